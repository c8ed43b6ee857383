"""Whole numbers that flow through a PLC: a plain one for simulation, and one of signals for many cases at once.

The rules of timers, counters and blocks are written once over `Word`, without a Python `if` on anything that flows: they add,
compare and pick. A `Number` does that for one case, where nobody may know the value; a `Vector` is a number made of signals,
bit for bit, so that the same rule runs a thousand timelines, or all 2^n cases of a proof, side by side.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, Protocol, Self, TypeVar

from plcteach.machine.signals import ONE, ZERO, Column, Signal, X

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

S = TypeVar("S", bound=Signal)


class Word(Protocol):
    """A whole number as the rules see it; comparisons give the signal that the number is made for."""

    def __add__(self, other: Self, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def times(self, factor: int, /) -> Self:
        """Multiply by a number known beforehand."""
        ...

    def over(self, divisor: int, /) -> Self:
        """Divide by a positive number known beforehand, dropping the rest; the word is not negative."""
        ...

    def ge(self, other: Self, /) -> Any:
        """Say whether it is at least the other."""
        ...

    def eq(self, other: Self, /) -> Any:
        """Say whether it equals the other."""
        ...

    def wrap(self, size: int, /, *, signed: bool = True) -> Self:
        """Keep the lowest `size` bits, as a register does."""
        ...

    def bits(self, size: int, /) -> tuple[Any, ...]:
        """Give the lowest `size` bits, the lowest first."""
        ...


@dataclass(frozen=True, slots=True)
class Number:
    """One whole number of one case; None is a number that nobody knows."""

    value: int | None

    def __repr__(self) -> str:
        return "x" if self.value is None else str(self.value)

    def __int__(self) -> int:
        if self.value is None:
            msg = "nobody knows this number (x)"
            raise ValueError(msg)
        return self.value

    def __lt__(self, other: Number | int) -> bool:
        return int(self) < int(other)

    def __gt__(self, other: Number | int) -> bool:
        return int(self) > int(other)

    def __add__(self, other: Number) -> Number:
        return UNKNOWN if self.value is None or other.value is None else Number(self.value + other.value)

    def __sub__(self, other: Number) -> Number:
        return UNKNOWN if self.value is None or other.value is None else Number(self.value - other.value)

    def times(self, factor: int) -> Number:
        """Multiply by a number known beforehand."""
        return UNKNOWN if self.value is None else Number(self.value * factor)

    def over(self, divisor: int) -> Number:
        """Divide by a positive number, dropping the rest."""
        return UNKNOWN if self.value is None else Number(self.value // divisor)

    def ge(self, other: Number) -> Column:
        """Say whether it is at least the other."""
        return X if self.value is None or other.value is None else ONE if self.value >= other.value else ZERO

    def eq(self, other: Number) -> Column:
        """Say whether it equals the other."""
        return X if self.value is None or other.value is None else ONE if self.value == other.value else ZERO

    def wrap(self, size: int, *, signed: bool = True) -> Number:
        """Keep the lowest `size` bits."""
        return UNKNOWN if self.value is None else Number(wrapped(self.value, size, signed=signed))

    def bits(self, size: int) -> tuple[Column, ...]:
        """Give the lowest `size` bits, the lowest first."""
        value = self.value
        return (X,) * size if value is None else tuple(ONE if value >> place & 1 else ZERO for place in range(size))

    def differs(self, other: Number) -> int:
        """Give 1 where the two are not the same, unknown counting as a value of its own."""
        return int(self.value != other.value)

    @property
    def unknown(self) -> int:
        """1 where nobody knows the number."""
        return int(self.value is None)


UNKNOWN = Number(None)


def wrapped(value: int, size: int, *, signed: bool = True) -> int:
    """Give what a register of `size` bits holds of a number."""
    value &= (1 << size) - 1
    return value - (1 << size) if signed and value >> (size - 1) else value


@dataclass(frozen=True, slots=True)
class Vector(Generic[S]):
    """A number made of signals in two's complement, the lowest bit first; the last one is the sign and goes on for ever."""

    signs: tuple[S, ...]
    zero: S

    def __repr__(self) -> str:
        return f"Vector({len(self.signs)} bits)"

    def at(self, place: int) -> S:
        """Give one bit; past the end it is the sign."""
        return self.signs[min(place, len(self.signs) - 1)]

    def __add__(self, other: Vector[S]) -> Vector[S]:
        return self._sum(other, self.zero)

    def __sub__(self, other: Vector[S]) -> Vector[S]:
        return self._sum(Vector(tuple(~one for one in other.signs), self.zero), ~self.zero)

    def _sum(self, other: Vector[S], carry: S) -> Vector[S]:
        total = []
        for place in range(max(len(self.signs), len(other.signs)) + 1):
            a, b = self.at(place), other.at(place)
            half = a ^ b
            total.append(half ^ carry)
            carry = a & b | carry & half
        return Vector(tuple(total), self.zero)

    def times(self, factor: int) -> Vector[S]:
        """Multiply by a number known beforehand: shifted copies, added."""
        if factor < 0:
            return Vector((self.zero,), self.zero) - self.times(-factor)
        if all(sign == self.zero for sign in self.signs):
            return self
        one = ~self.zero
        if all(sign in (self.zero, one) for sign in self.signs):
            digits = "".join("1" if sign == one else "0" for sign in reversed(self.signs))
            return constant(wrapped(int(digits, 2), len(digits)) * factor, self.zero)
        total = Vector((self.zero,), self.zero)
        for shift in range(factor.bit_length()):
            if factor >> shift & 1:
                total += Vector((self.zero,) * shift + self.signs, self.zero)
        return total

    def over(self, divisor: int) -> Vector[S]:
        """Divide by a positive number known beforehand, as one does on paper; the word is not negative."""
        rest, digits = Vector((self.zero,), self.zero), []
        by = constant(divisor, self.zero)
        for sign in reversed(self.signs):
            rest = Vector((sign, *rest.signs), self.zero)
            fits = rest.ge(by)
            digits.append(fits)
            rest = picked(fits, rest - by, rest)
            rest = Vector((*rest.signs[: divisor.bit_length()], self.zero), self.zero)
        return Vector((*reversed(digits), self.zero), self.zero)

    def ge(self, other: Vector[S]) -> S:
        """Say whether it is at least the other: their difference is not negative."""
        return ~(self - other).signs[-1]

    def eq(self, other: Vector[S]) -> S:
        """Say whether it equals the other, bit for bit."""
        same = ~self.zero
        for place in range(max(len(self.signs), len(other.signs))):
            same = same & ~(self.at(place) ^ other.at(place))
        return same

    def wrap(self, size: int, *, signed: bool = True) -> Vector[S]:
        """Keep the lowest `size` bits."""
        return Vector(self.bits(size) if signed else (*self.bits(size), self.zero), self.zero)

    def bits(self, size: int) -> tuple[S, ...]:
        """Give the lowest `size` bits, the lowest first."""
        return tuple(self.at(place) for place in range(size))


def constant(value: int, zero: S) -> Vector[S]:
    """Give the vector that has one value in every case."""
    signs = tuple(~zero if value >> place & 1 else zero for place in range(max(value.bit_length(), 1)))
    return Vector((*signs, ~zero if value < 0 else zero), zero)


def either(condition: S, this: S, other: S) -> S:
    """Give `this` where the condition is 1, else `other`; where both agree the condition need not be known."""
    return condition & this | ~condition & other | this & other


def picked(condition: S, this: Vector[S], other: Vector[S]) -> Vector[S]:
    """Give `this` where the condition is 1, else `other`, bit for bit."""
    size = max(len(this.signs), len(other.signs))
    signs = tuple(either(condition, this.at(place), other.at(place)) for place in range(size))
    return Vector(signs, this.zero)


@dataclass(frozen=True, slots=True)
class Domain(Generic[S]):
    """What flows: the constants of a signal (a bit at power-on, an always-on bit, what nobody knows) and its numbers."""

    zero: S
    one: S
    blank: S

    def number(self, value: int | None) -> Any:
        """Give a constant number; None is a number that nobody knows."""
        return Vector((self.blank,), self.zero) if value is None else constant(value, self.zero)

    def join(self, bits: Sequence[S], *, signed: bool = True) -> Any:
        """Give the number that some bits spell, the lowest first."""
        return Vector(tuple(bits) if signed else (*bits, self.zero), self.zero)

    def pick(self, condition: S, this: Any, other: Any) -> Any:
        """Give `this` where the condition is 1, else `other`: two numbers, or two signals."""
        if isinstance(this, Vector):
            return picked(condition, this, other)
        return either(condition, this, other)

    def apply(self, rule: Callable[..., int | None], *words: Any) -> Any:
        """Work out any rule over whole numbers, case by case, where no formula over bits exists (division, reals)."""
        cases = self.one.may1.bit_length()  # type: ignore[attr-defined]
        rows = ([value_of(word, case) for word in words] for case in range(cases))
        results = [None if None in row else rule(*row) for row in rows]
        return gathered(results, self)

    def certain(self, signal: S) -> bool | None:
        """Say whether a signal is 1 (True) or 0 (False) in every case; None where it is not settled."""
        return True if signal == self.one else False if signal == self.zero else None


def value_of(word: Vector[Column], case: int) -> int | None:
    """Give a vector's number in one case; None where nobody knows it."""
    digits = [sign.at(case) for sign in word.signs]
    if "x" in digits:
        return None
    return wrapped(int("".join(reversed(digits)), 2), len(digits))


def gathered(results: list[int | None], domain: Domain[Any]) -> Vector[Column]:
    """Turn the numbers of all cases into one vector."""
    size = max((one.bit_length() for one in results if one is not None), default=0) + 1
    signs = []
    for place in range(size):
        may1 = sum(1 << case for case, one in enumerate(results) if one is None or one >> place & 1)
        may0 = sum(1 << case for case, one in enumerate(results) if one is None or not one >> place & 1)
        signs.append(Column(may0, may1))
    return Vector(tuple(signs), domain.zero)


class Single(Domain[Column]):
    """One case: numbers are plain whole numbers."""

    __slots__ = ()

    def number(self, value: int | None) -> Number:
        """Give a number."""
        return Number(value)

    def join(self, bits: Sequence[Column], *, signed: bool = True) -> Number:
        """Give the number that some bits spell, the lowest first."""
        value = 0
        for place, bit in enumerate(bits):
            if bit.may0 and bit.may1:
                return UNKNOWN
            value |= bit.may1 << place
        return Number(wrapped(value, len(bits), signed=signed))

    def pick(self, condition: Column, this: Any, other: Any) -> Any:
        """Give `this` where the condition is 1, else `other`."""
        if condition.may0 and condition.may1 and isinstance(this, Number):
            return this if this == other else UNKNOWN
        if condition.may0 and condition.may1:
            return either(condition, this, other)
        return this if condition.may1 else other

    def apply(self, rule: Callable[..., int | None], *words: Any) -> Number:
        """Work out a rule over whole numbers."""
        values = [word.value for word in words]
        return UNKNOWN if None in values else Number(rule(*values))


BITS = Single(ZERO, ONE, X)
