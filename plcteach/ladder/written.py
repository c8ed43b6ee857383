"""What the lines of a network may change, so that a contact drawn later than the list reads it can be told from a harmless one.

It errs on the safe side: a subroutine or a loop may change anything, and of words that are kept as such one may be part of another.
"""

from __future__ import annotations

from bisect import bisect_right
from functools import cached_property
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.program import Assign

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.program import Line
    from plcteach.core.spec import Dialect
    from plcteach.core.verb import Verb

_OF_PLACES = {"coil", "set", "reset", "work", "drive", "pin", "update"}
_Key = tuple[str, int]
_ANYTHING, _WHOLE = ("", -1), -1
_MACHINE = ("", 0)
"""A bit of the machine itself (ENO), which every operation on words changes."""


class Changes:
    """Which lines of one network may change a place, looked up only when a drawing asks."""

    def __init__(self, dialect: Dialect, lines: tuple[Line, ...], numbers: list[int]) -> None:
        self.dialect, self.lines, self.numbers = dialect, lines, numbers

    @cached_property
    def by_place(self) -> dict[_Key, list[int]]:
        """For each bit or word the lines that may change it, in order."""
        found: dict[_Key, list[int]] = {}
        for number in self.numbers:
            for key in dict.fromkeys(self.written(self.lines[number])):
                found.setdefault(key, []).append(number)
        return found

    def between(self, places: tuple[Address, ...], first: int, last: int) -> int | None:
        """Give a line behind `first`, and not behind `last`, that may change one of some places."""
        keys = {key for place in places for key in self.keys(place)} or {_MACHINE}
        for key in (_ANYTHING, *keys):
            numbers = self.by_place.get(key, [])
            at = bisect_right(numbers, first)
            if at < len(numbers) and numbers[at] <= last:
                return numbers[at]
        return None

    def written(self, line: Line) -> Iterator[_Key]:
        """Give what a line may change."""
        for verb in line.insn.then:
            places = self.targets(line, verb)
            if places is None:
                yield _ANYTHING
                continue
            if verb.name == "work":
                yield _MACHINE
                words = self.dialect.flags.values()
                places += tuple(one for word in words if isinstance(one := self.dialect.address(word), Address))
            for place in places:
                yield from self.keys(place)

    def targets(self, line: Line, verb: Verb) -> tuple[Address, ...] | None:
        """Give the places that a verb writes; None where that may be anything, as with a drum, which has outputs of its own."""
        target = line.bound.get(verb.target)
        if isinstance(target, Assign):
            target = target.target
        wide = verb.name == "reset" and verb.sources
        if verb.name not in _OF_PLACES or wide or not isinstance(target, Address) or verb.op == "compare":
            return None
        block = self.dialect.block(target)
        if block and block.rule == "drum":
            return None
        count = line.bound.get(verb.count, 1) if verb.count else 1
        many = isinstance(count, int) and target.size == 1
        return tuple(self.dialect.following(target, count)) if many and isinstance(count, int) else (target,)

    def keys(self, place: Address) -> set[_Key]:
        """Give what a place shares with others: its bits, or all of its area where words are kept as such."""
        if self.dialect.area(place).size > 1:
            return {(place.area, _WHOLE)}
        return {(bit.area, bit.index) for bit in self.dialect.bits_of(place)} or {(place.area, place.index)}
