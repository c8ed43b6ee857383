"""How one word is made of others: sums, products, logic, shifts, conversions and reals, a row each.

Sums and logic are formulas over `Word`. A rule that no formula over bits can give (a product, a quotient, reals) is a plain
function of whole numbers, worked out case by case; an answer of None means that there is none (a division by zero, a root of
a negative number).
"""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plcteach.machine.words import wrapped

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.machine.words import Domain

SUM = ("zero", "overflow", "negative", "borrow", "carry")
QUOTIENT = (*SUM, "divide")
LOGIC = ("zero",)
ROOM = ("overflow",)
"""Which flags a rule leaves: a sum, a quotient, logic, and a conversion whose result may find no room."""


@dataclass(frozen=True, slots=True)
class Rule:
    """How a word is worked out: a formula over words, or else a function of whole numbers.

    flags: what it leaves behind in the family's flags.  wraps: too large a result is cut off and is no overflow.
    divides: its last operand must not be 0.  out: the bit that falls out last, which the overflow flag then keeps; None where
    none falls out.  keeps_sign: too large a result is cut off below its sign, which stays.  shown: the number that zero and negative speak of, where that is not the result.
    """

    formula: Callable[..., Any] | None = None
    function: Callable[..., int | None] | None = None
    flags: tuple[str, ...] = ()
    keeps_sign: bool = False
    wraps: bool = False
    divides: bool = False
    out: Callable[[int, int], int | None] | None = None
    shown: Callable[[int], int] | None = None

    def exact(self, domain: Domain[Any], words: list[Any]) -> tuple[Any, Any]:
        """Give the result before it is cut to size, and whether there is one."""
        if self.formula:
            return self.formula(domain, *words), domain.one
        function = self.function
        assert function is not None  # noqa: S101 (a rule has one or the other)
        answered = domain.apply(lambda *values: int(function(*values) is not None), *words)
        return domain.apply(lambda *values: function(*values) or 0, *words), answered.eq(domain.number(1))


# Reals.


def real(bits: int) -> float:
    """Give the floating-point number that 32 bits spell."""
    return float(struct.unpack(">f", struct.pack(">I", bits & 0xFFFFFFFF))[0])


def real_bits(number: float) -> int | None:
    """Give the 32 bits of a floating-point number; None where it has none."""
    try:
        return int(struct.unpack(">i", struct.pack(">f", number))[0]) if math.isfinite(number) else None
    except OverflowError:
        return None


def ordered(bits: int) -> int:
    """Turn the bits of a real into a whole number of the same order, so that reals compare like whole numbers."""
    bits &= 0xFFFFFFFF
    return -(bits & 0x7FFFFFFF) if bits >> 31 else bits


def _reals(function: Callable[..., float | None], *, divides: bool = False) -> Rule:
    def lifted(*bits: int) -> int | None:
        numbers = [real(one) for one in bits]
        result = function(*numbers) if all(map(math.isfinite, numbers)) else None
        return None if result is None else real_bits(result)

    return Rule(function=lifted, flags=QUOTIENT if divides else SUM, divides=divides, shown=ordered)


def _whole(function: Callable[[float], int]) -> Rule:
    return Rule(function=lambda a: function(real(a)) if math.isfinite(real(a)) else None, flags=ROOM)


# Products and quotients.


def _quotient(a: int, b: int) -> int | None:
    """Divide towards zero, as every PLC does."""
    if not b:
        return None
    return abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)


def _rest(a: int, b: int) -> int | None:
    quotient = _quotient(a, b)
    return None if quotient is None else a - quotient * b


def _halves(a: int, b: int) -> int | None:
    """Divide the low word of a by b into one double word: the rest high, the quotient low."""
    quotient, rest = _quotient(_low(a), b), _rest(_low(a), b)
    if quotient is None or rest is None or quotient != _low(quotient):
        return None
    return (rest & 0xFFFF) << 16 | quotient & 0xFFFF


def _low(value: int) -> int:
    return wrapped(value, 16)


# Bits of a word.


def _bitwise(operator: Callable[[Any, Any], Any]) -> Rule:
    def worked(domain: Domain[Any], a: Any, b: Any) -> Any:
        return domain.join([operator(x, y) for x, y in zip(a.bits(_WIDEST), b.bits(_WIDEST), strict=True)])

    return Rule(worked, flags=LOGIC, wraps=True)


_WIDEST = 32


def _shift(size: int, *, left: bool) -> Rule:
    """Shift a value of this size; zeros enter, and a count beyond the size counts as the size."""
    every = (1 << size) - 1

    def shifted(value: int, count: int) -> int:
        count = min(max(count, 0), size)
        return (value & every) << count & every if left else (value & every) >> count

    def out(value: int, count: int) -> int | None:
        count = min(max(count, 0), size)
        return (value & every) >> (size - count if left else count - 1) & 1 if count else None

    return Rule(function=shifted, flags=LOGIC, wraps=True, out=out)


def _turn(size: int, *, left: bool) -> Rule:
    """Turn a value of this size round; a count beyond the size goes round once more."""
    every = (1 << size) - 1

    def turned(value: int, count: int) -> int:
        places = (count if left else -count) % size
        value &= every
        return (value << places | value >> (size - places)) & every

    def out(value: int, count: int) -> int | None:
        return turned(value, count) >> (0 if left else size - 1) & 1 if count % size else None

    return Rule(function=turned, flags=LOGIC, wraps=True, out=out)


RULES: dict[str, Rule] = {
    "move": Rule(lambda _, a: a, wraps=True),
    "add": Rule(lambda _, a, b: a + b, flags=SUM),
    "sub": Rule(lambda _, a, b: a - b, flags=SUM),
    "sum": Rule(lambda _, a, b: a + b, flags=SUM, keeps_sign=True),
    "difference": Rule(lambda _, a, b: a - b, flags=SUM, keeps_sign=True),
    "next": Rule(lambda domain, a: a + domain.number(1), wraps=True),
    "last": Rule(lambda domain, a: a - domain.number(1), wraps=True),
    "product": Rule(function=lambda a, b: a * b, wraps=True),
    "parts": Rule(function=_halves, wraps=True, divides=True),
    "inc": Rule(lambda domain, a: a + domain.number(1), flags=SUM),
    "dec": Rule(lambda domain, a: a - domain.number(1), flags=SUM),
    "up": Rule(lambda domain, a: a + domain.number(1), wraps=True),
    "down": Rule(lambda domain, a: a - domain.number(1), wraps=True),
    "neg": Rule(lambda domain, a: domain.number(0) - a, flags=SUM),
    "mul": Rule(function=lambda a, b: a * b, flags=SUM),
    "div": Rule(function=_quotient, flags=QUOTIENT, divides=True),
    "rem": Rule(function=_rest, flags=QUOTIENT, divides=True),
    "mul16": Rule(function=lambda a, b: _low(a) * b, flags=SUM),
    "divmod": Rule(function=_halves, flags=QUOTIENT, wraps=True, divides=True, shown=_low),
    "and": _bitwise(lambda a, b: a & b),
    "or": _bitwise(lambda a, b: a | b),
    "xor": _bitwise(lambda a, b: a ^ b),
    "not": Rule(lambda domain, a: domain.number(-1) - a, flags=LOGIC, wraps=True),
    "fit": Rule(lambda _, a: a, flags=ROOM),
    "sqrt": Rule(function=lambda a: math.isqrt(a) if a >= 0 else None, flags=SUM),
    "radd": _reals(lambda a, b: a + b),
    "rsub": _reals(lambda a, b: a - b),
    "rmul": _reals(lambda a, b: a * b),
    "rdiv": _reals(lambda a, b: a / b if b else None, divides=True),
    "rsqrt": _reals(lambda a: math.sqrt(a) if a >= 0 else None),
    "to_real": Rule(function=lambda a: real_bits(float(a)), wraps=True),
    "round": _whole(lambda a: math.floor(a + 0.5)),
    "trunc": _whole(math.trunc),
}
for _size in (8, 16, 32):
    RULES[f"shl{_size}"] = _shift(_size, left=True)
    RULES[f"shr{_size}"] = _shift(_size, left=False)
    RULES[f"rol{_size}"] = _turn(_size, left=True)
    RULES[f"ror{_size}"] = _turn(_size, left=False)
