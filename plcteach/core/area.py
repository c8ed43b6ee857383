"""Addresses and the areas they lie in: bits numbered byte by byte, straight on or in octal, words over them, and blocks."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Literal

from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Mapping

LONGEST = 12
"""More digits than any address has; a longer run is answered without being counted."""

BYTE = 8


@dataclass(frozen=True, slots=True)
class Address:
    """One place of one area; `text` is its canonical spelling, `index` counts the bits (or words, or blocks) from 0.

    size: how many bits it is wide: 1 for a bit, 8 to 64 for a word, 0 for a whole block.  field: which part of a block or of
    a timer it is ("V", "Q", "3").
    """

    area: str
    index: int
    text: str
    size: int = 1
    field: str = ""

    def __repr__(self) -> str:
        return self.text

    def fits(self, number: int) -> bool:
        """Say whether a number goes into so many bits, with a sign or without."""
        return -(1 << self.size >> 1) <= number < 1 << self.size


@dataclass(frozen=True)
class Area:
    """An area: its letters, how it is numbered, its ends, and how wide what is numbered is.

    per: bits in each numbered unit (8 for I0.0 … I0.7), 0 where it is numbered straight on.  base: 8 for octal.
    ranges: pairs of first and last, as they are written after the letters.
    size: the width of what a plain address names: 1 a bit, 16 or 32 a word, 0 a whole block.
    words: letters that name a wider stretch of a byte-numbered area, high byte first (VB8, VW16, VD32).
    groups: this area's bits can be taken four at a time (K4M0).  fields: parts of a block and their widths.
    value: the field that a plain address means where a number is wanted (the current value of T37).
    digits: a digit after the dot names one bit of a word (D0.3, %MW0:X3); the sign between the two.
    even: words begin at even numbers only.
    """

    prefix: str
    ranges: tuple[tuple[str, str], ...]
    title: Text
    per: int = 0
    base: int = 10
    role: Literal["input", "output", "memory"] = "memory"
    size: int = 1
    words: Mapping[str, int] = field(default_factory=dict)
    groups: bool = False
    fields: Mapping[str, int] = field(default_factory=dict)
    value: str = ""
    digits: str = ""
    even: bool = False

    def __repr__(self) -> str:
        return f"Area({self.prefix} {self.first}-{self.last})"

    def __hash__(self) -> int:
        return hash(self.prefix)

    @property
    def first(self) -> str:
        """The first address of the area."""
        return self.prefix + self.ranges[0][0]

    @property
    def last(self) -> str:
        """The last address of the area."""
        return self.prefix + self.ranges[-1][1]

    def index(self, digits: str) -> int | None:
        """Give the bit's number in the area for what follows the letters; -1 outside of it, None if it does not read as one."""
        unit, dot, bit = digits.partition(".")
        if bool(dot) != bool(self.per) or not unit.isascii() or not unit.isdigit() or len(digits) > LONGEST:
            return None
        if not self.per:
            return int(unit, self.base) if all(int(digit) < self.base for digit in unit) else -1
        if not bit.isascii() or not bit.isdigit():
            return None
        return int(unit) * self.per + int(bit) if int(bit) < self.per else -1

    def holds(self, index: int) -> bool:
        """Say whether a number lies in the area."""
        if self.even and index % 2:
            return False
        return any(first <= index <= last for first, last in self._ends)

    @cached_property
    def _ends(self) -> tuple[tuple[int, int], ...]:
        return tuple((self.index(first) or 0, self.index(last) or 0) for first, last in self.ranges)

    def address(self, index: int) -> Address:
        """Give the address with this number, in canonical spelling."""
        if self.per:
            return Address(self.prefix, index, f"{self.prefix}{index // self.per}.{index % self.per}")
        digits = f"{index:o}" if self.base == _OCTAL else f"{index}"
        return Address(self.prefix, index, self.prefix + digits, self.size)

    def part(self, address: Address, name: str) -> Address:
        """Give a field of a block (or timer) of this area."""
        return Address(self.prefix, address.index, f"{address.text}.{name}", self.fields[name], name)

    def read(self, rest: str) -> Address | Area | None:
        """Read what follows the letters; the area itself where it lies outside, None where it does not read as one."""
        for letter, size in self.words.items():
            if rest.startswith(letter) and rest[len(letter) :].isdigit():
                return self._word(letter, size, rest[len(letter) :])
        if self.fields or self.digits:
            found = self._part(rest)
            if found is not None:
                return found
        if not rest[:1].isdigit():
            return None
        if len(rest) > LONGEST and rest.replace(".", "", 1).isdigit():
            return self
        index = self.index(rest)
        if index is None:
            return None
        return self.address(index) if self.holds(index) else self

    def _word(self, letter: str, size: int, digits: str) -> Address | Area:
        if len(digits) > LONGEST:
            return self
        first = int(digits)
        inside = self.holds(first * self.per) and self.holds(first * self.per + size - 1)
        return Address(self.prefix, first * self.per, f"{self.prefix}{letter}{first}", size) if inside else self

    def _part(self, rest: str) -> Address | Area | None:
        match = _PART.fullmatch(rest)
        if not match or len(match["unit"]) > LONGEST:
            return None
        index = self.index(match["unit"])
        if index is None or not self.holds(index):
            return self if index is not None else None
        whole, name = self.address(index), match["name"]
        if match["sign"] == "." and name in self.fields:
            return self.part(whole, name)
        if self.digits and match["sign"].upper() == self.digits and name.isdigit() and len(name) < LONGEST:
            inside = int(name) < self.size
            return (
                Address(self.prefix, index, f"{whole.text}{self.digits}{int(name)}", 1, str(int(name)))
                if inside
                else self
            )
        return None


_PART = re.compile(r"(?P<unit>[0-9]+)(?P<sign>\.|:[Xx])(?P<name>[A-Za-z0-9]+)")
_OCTAL = 8


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of operand: the areas it may lie in, and what the reader says that it expected.

    size: the width it wants: 1 a bit, 8 to 32 a word, 0 a whole block.  constant: a number may stand there instead.
    signed: how its bits are read.  real: they are a floating-point number.  compare: a comparison in brackets may stand there.
    ends: the smallest and the largest number that may stand there, if not just any that fits.
    """

    areas: frozenset[str]
    title: Text
    size: int = 1
    constant: bool = False
    signed: bool = True
    real: bool = False
    compare: bool = False
    ends: tuple[int, int] | None = None


def kind(areas: str, *, zh: str, en: str, compare: bool = False) -> Kind:
    """Declare a kind of bit operand by the letters of its areas; `compare`: or a comparison in brackets."""
    return Kind(frozenset(areas.split(" ")), Text(zh, en), compare=compare)


def words(
    areas: str,
    size: int,
    *,
    zh: str,
    en: str,
    constant: bool = True,
    signed: bool = True,
    real: bool = False,
    ends: tuple[int, int] | None = None,
) -> Kind:
    """Declare a kind of word operand: `size` bits, in these areas or a number (between two `ends`)."""
    return Kind(frozenset(areas.split(" ")), Text(zh, en), size, constant, signed, real, ends=ends)


def blocks(areas: str, *, zh: str, en: str) -> Kind:
    """Declare a kind of operand that is a whole block, such as %TM0."""
    return Kind(frozenset(areas.split(" ")), Text(zh, en), 0)
