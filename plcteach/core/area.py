"""Addresses and the areas they lie in: how a family numbers its bits, byte by byte, straight on, or in octal."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from plcteach.core.text import Text

LONGEST = 12
"""More digits than any address has; a longer run is answered without being counted."""


@dataclass(frozen=True, slots=True)
class Address:
    """One bit of one area; `text` is its canonical spelling, `index` counts the bits of the area from 0."""

    area: str
    index: int
    text: str

    def __repr__(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True)
class Area:
    """An area of bits: its letters, how it is numbered, and its ends.

    per: bits in each numbered unit (8 for I0.0 … I0.7), 0 where bits are numbered straight on.  base: 8 for octal.
    ranges: pairs of first and last, as they are written after the letters.
    """

    prefix: str
    ranges: tuple[tuple[str, str], ...]
    title: Text
    per: int = 0
    base: int = 10
    role: Literal["input", "output", "memory"] = "memory"

    def __repr__(self) -> str:
        return f"Area({self.prefix} {self.first}-{self.last})"

    @property
    def first(self) -> str:
        """The first address of the area."""
        return self.prefix + self.ranges[0][0]

    @property
    def last(self) -> str:
        """The last address of the area."""
        return self.prefix + self.ranges[-1][1]

    def index(self, digits: str) -> int | None:
        """Give the bit's number in the area for what follows the letters; None if it does not read as one."""
        unit, dot, bit = digits.partition(".")
        if bool(dot) != bool(self.per) or not unit.isascii() or not unit.isdigit() or len(digits) > LONGEST:
            return None
        if not self.per:
            return int(unit, self.base) if all(int(digit) < self.base for digit in unit) else -1
        if not bit.isascii() or not bit.isdigit():
            return None
        return int(unit) * self.per + int(bit) if int(bit) < self.per else -1

    def holds(self, index: int) -> bool:
        """Say whether a bit number lies in the area."""
        return any((self.index(first) or 0) <= index <= (self.index(last) or 0) for first, last in self.ranges)

    def address(self, index: int) -> Address:
        """Give the address with this bit number, in canonical spelling."""
        if self.per:
            return Address(self.prefix, index, f"{self.prefix}{index // self.per}.{index % self.per}")
        return Address(
            self.prefix, index, f"{self.prefix}{index:o}" if self.base == _OCTAL else f"{self.prefix}{index}"
        )


_OCTAL = 8


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of operand: the areas it may lie in, and what the reader says that it expected."""

    areas: frozenset[str]
    title: Text


def kind(areas: str, *, zh: str, en: str) -> Kind:
    """Declare a kind of operand by the letters of its areas."""
    return Kind(frozenset(areas.split(" ")), Text(zh, en))
