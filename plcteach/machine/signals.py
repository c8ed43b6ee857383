"""What can flow through the stack: a three-valued bit, or a column of many, one for each of any number of cases.

A bit on a PLC is 0, 1 or x (nobody knows). A `Column` holds one such bit for each of any number of cases at once, in two big
integers: in which cases the bit may be 0, and in which it may be 1. Where both are set the bit is x. Simulation uses columns
of one case, the checker columns of all 2^n; the rules are the same, and inversion is nothing but swapping the two integers.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, Self


class Signal(Protocol):
    """Anything that an instruction list can be run over."""

    def __and__(self, other: Self, /) -> Self: ...
    def __or__(self, other: Self, /) -> Self: ...
    def __xor__(self, other: Self, /) -> Self: ...
    def __invert__(self) -> Self: ...
    def edge(self, previous: Self | None, /, *, rising: bool) -> Self:
        """Give 1 where the signal has risen (fallen) since `previous`; None is the first time, which shows no edge."""
        ...


@dataclass(frozen=True, slots=True)
class Column:
    """One three-valued bit in each of many cases: bit k of `may0` (`may1`) says that in case k it may be 0 (1)."""

    may0: int
    may1: int

    def __repr__(self) -> str:
        return {(1, 0): "0", (0, 1): "1", (1, 1): "x"}.get(
            (self.may0, self.may1), f"Column({self.may0:b}, {self.may1:b})"
        )

    def __and__(self, other: Column) -> Column:
        return Column(self.may0 | other.may0, self.may1 & other.may1)

    def __or__(self, other: Column) -> Column:
        return Column(self.may0 & other.may0, self.may1 | other.may1)

    def __xor__(self, other: Column) -> Column:
        a0, a1, b0, b1 = self.may0, self.may1, other.may0, other.may1
        return Column(a0 & b0 | a1 & b1, a1 & b0 | a0 & b1)

    def __invert__(self) -> Column:
        return Column(self.may1, self.may0)

    def edge(self, previous: Column | None, *, rising: bool) -> Column:
        """Give the edge since `previous`, no edge the first time."""
        if previous is None:
            return Column(self.may0 | self.may1, 0)
        return self & ~previous if rising else ~self & previous

    @property
    def unknown(self) -> int:
        """The cases in which the bit is x."""
        return self.may0 & self.may1

    def differs(self, other: Column) -> int:
        """Give the cases in which the two are not the same, x counting as a value of its own."""
        return (self.may0 ^ other.may0) | (self.may1 ^ other.may1)

    def at(self, case: int) -> str:
        """Give the value in one case: "0", "1" or "x"."""
        zero, one = self.may0 >> case & 1, self.may1 >> case & 1
        return "x" if zero and one else "1" if one else "0"


ZERO, ONE, X = Column(1, 0), Column(0, 1), Column(1, 1)
