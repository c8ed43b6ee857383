"""The single edits that may mend a list, each found in its family's table by what instructions do and not by their names.

An edit is a new list. Whether it is right, nobody here knows: `check.repair` tries them one after the other.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Literal

from plcteach.check.partners import contacts, inverses, others, starts, turned
from plcteach.core.area import Address
from plcteach.core.program import Value
from plcteach.stl import read, write

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from plcteach.core.program import Line, Program
    from plcteach.core.spec import Dialect, Role

Kind = Literal[
    "join", "branch", "start", "invert", "contact", "priority", "order", "number", "block", "operand", "delete", "insert", "setting", "heading",
]  # fmt: skip
"""join: series or parallel.  branch: push, read, pop.  start: a block begins here, or does not.  invert: open or closed, rising
or falling.  priority: two rungs that set and reset one bit change places.  order: two other rungs do.  number: a preset, or
another number.  block: another kind of timer or counter.  setting: a word of a configuration line.
heading: two networks are one."""


@dataclass(frozen=True, slots=True)
class Edit:
    """One edit: its kind, the instructions that it touches (numbers from 0, `stop` outside), and the list afterwards.

    before, after: the instructions taken away and put there; nothing before is an insertion behind `at` - 1.
    """

    kind: Kind
    at: int
    stop: int
    before: tuple[str, ...]
    after: tuple[str, ...]
    rows: tuple[str, ...]

    @property
    def text(self) -> str:
        """The whole list after the edit."""
        return "".join(f"{row}\n" for row in self.rows)


@dataclass(frozen=True)
class Listing:
    """A program as rows of text, with the row in which each of its instructions stands, and how its rungs part it."""

    program: Program
    reference: Program
    rungs: tuple[tuple[int, int], ...]

    @cached_property
    def rows(self) -> tuple[str, ...]:
        """The rows of the canonical text."""
        return tuple(write(self.program).split("\n")[:-1])

    @cached_property
    def places(self) -> tuple[int, ...]:
        """For each instruction the number of its row, from 0."""
        again = read("\n".join(self.rows), self.program.dialect)
        return tuple(line.span.row - 1 for line in again.lines)

    @property
    def lines(self) -> tuple[Line, ...]:
        """The instructions."""
        return self.program.lines

    def changed(self, kind: Kind, at: int, *after: str, taken: int = 1) -> Edit:
        """Put other instructions in the place of some (of none: they go before instruction `at`)."""
        first = self.places[at] if at < len(self.places) else len(self.rows)
        rows = (*self.rows[:first], *after, *self.rows[first + taken :])
        return Edit(kind, at, at + taken, tuple(line.text for line in self.lines[at : at + taken]), after, rows)

    def behind(self, kind: Kind, at: int, after: str) -> Edit:
        """Put an instruction behind another."""
        row = self.places[at] + 1
        return Edit(kind, at + 1, at + 1, (), (after,), (*self.rows[:row], after, *self.rows[row:]))

    def exchanged(self, kind: Kind, first: tuple[int, int], second: tuple[int, int]) -> Edit:
        """Let two stretches of instructions change places; headings between them stay."""
        (a, b), (c, d) = ((self.places[start], self.places[stop - 1] + 1) for start, stop in (first, second))
        rows = (*self.rows[:a], *self.rows[c:d], *self.rows[b:c], *self.rows[a:b], *self.rows[d:])
        texts = [line.text for line in self.lines]
        before, after = texts[first[0] : first[1]], texts[second[0] : second[1]]
        return Edit(kind, first[0], second[1], tuple(before), tuple(after), rows)

    @cached_property
    def bits(self) -> tuple[str, ...]:
        """Every bit that one of the two programs names, in order of address."""
        return _addresses(place for one in (self.reference, self.program) for line in one.lines for place in line.bits)

    @cached_property
    def written(self) -> tuple[str, ...]:
        """Every bit that a line of one of the two programs writes."""
        return _addresses(_written(self.reference) + _written(self.program))

    @cached_property
    def missing(self) -> tuple[str, ...]:
        """The instructions that the reference has and this program has not, or not as often."""
        mine = Counter(line.text for line in self.lines)
        theirs = Counter(line.text for line in self.reference.lines)
        return tuple((theirs - mine).keys())


def _written(program: Program) -> list[Address]:
    return [target for line in program.lines for verb, target in line.targets if target.size == 1]


def _addresses(places: Iterator[Address] | list[Address]) -> tuple[str, ...]:
    found = {place.text: place for place in places}
    return tuple(sorted(found, key=lambda text: (found[text].area, found[text].index, text)))


def edits(listing: Listing, relevant: Callable[[int], bool], *, shapes: bool = False) -> Iterator[Edit]:
    """Give every single edit of the relevant instructions, the likeliest kinds first (what the reference uses before all), in a fixed order.

    shapes: only those that change what happens to the stack, whatever contacts read.
    """
    numbers = [number for number in range(len(listing.lines)) if relevant(number)]
    words = {line.insn.word for line in listing.reference.lines}
    kinds = _SHAPES if shapes else _WORDS
    odd = [one for number in numbers for one in _other_words(listing, number, kinds)]
    yield from (one for one in odd if one.after[0].partition(" ")[0] in words)
    yield from _rung_orders(listing, relevant)
    yield from _settings(listing)
    for make in (_numbers, _blocks, _deleted) if shapes else (_numbers, _blocks, _deleted, _operands):
        for number in numbers:
            yield from make(listing, number)
    yield from _headings(listing)
    yield from odd
    starts_at = [start for start, _ in listing.rungs if relevant(start)]
    for new in (_missing_words, _stack_words, *(() if shapes else (_contact_words,))):
        for number in numbers:
            yield from (listing.behind("insert", number, word) for word in new(listing))
        for start in starts_at:
            yield from (listing.changed("insert", start, word, taken=0) for word in new(listing))


_Words = tuple[tuple[Kind, "Callable[[Dialect, str], tuple[str, ...]]"], ...]


def _branch_words(dialect: Dialect, mnemonic: str) -> tuple[str, ...]:
    words = [dialect.roles[role] for role in _FETCHING if role in dialect.roles]
    return tuple(word for word in words if word != mnemonic) if mnemonic in words else ()


_SHAPES: _Words = (("join", turned), ("branch", _branch_words), ("start", starts))
_WORDS: _Words = (*_SHAPES, ("invert", inverses), ("contact", contacts))


def _other_words(listing: Listing, number: int, kinds: _Words) -> Iterator[Edit]:
    """Give the same operands behind another instruction: joins, branches, the beginnings of blocks, inverses."""
    line = listing.lines[number]
    operands = line.text.partition(" ")[2]
    for kind, find in kinds:
        for word in find(listing.program.dialect, line.insn.mnemonic):
            yield listing.changed(kind, number, f"{word} {operands}".strip())


def _headings(listing: Listing) -> Iterator[Edit]:
    """Take away the heading between two networks."""
    for above, below in zip(listing.program.networks, listing.program.networks[1:], strict=False):
        if above.lines and below.lines and below.headed and above.block == below.block:
            at = next(number for number, line in enumerate(listing.lines) if line is below.lines[0])
            row = listing.places[at] - 1 - len(below.lines[0].above)
            rows = (*listing.rows[:row], *listing.rows[row + 1 :])
            yield Edit("heading", at, at, (listing.rows[row],), (), rows)


_FETCHING: tuple[Role, ...] = ("push", "read", "pop")


def _rung_orders(listing: Listing, relevant: Callable[[int], bool]) -> Iterator[Edit]:
    """Let neighbouring rungs change places."""
    for first, second in zip(listing.rungs, listing.rungs[1:], strict=False):
        if relevant(first[0]) or relevant(second[0]):
            pair = [_forced(listing, one) for one in (first, second)]
            yield listing.exchanged("priority" if pair[0] & pair[1] else "order", first, second)


def _forced(listing: Listing, rung: tuple[int, int]) -> set[str]:
    """Give the bits that a rung sets or resets."""
    lines = listing.lines[slice(*rung)]
    return {target.text for line in lines for verb, target in line.targets if verb.name in {"set", "reset"}}


def _settings(listing: Listing) -> Iterator[Edit]:
    """Put what the reference says in a word of a configuration line."""
    said: dict[str, list[str]] = {}
    for row in listing.reference.configuration:
        for word in row.split():
            said.setdefault(word.partition("=")[0], []).append(word)
    for at, row in enumerate(listing.program.configuration):
        words = row.split()
        for place, word in enumerate(words):
            for other in dict.fromkeys(said.get(word.partition("=")[0], ())):
                if other != word and "=" in word:
                    new = " ".join((*words[:place], other, *words[place + 1 :]))
                    rows = tuple(new if number == at else one for number, one in enumerate(listing.rows))
                    yield Edit("setting", -1, -1, (row,), (new,), rows)


def _numbers(listing: Listing, number: int) -> Iterator[Edit]:
    """Put another number: one of the reference's, or a neighbour of a count of cells."""
    line = listing.lines[number]
    for name, arg in line.bound.items():
        others_there = [
            one.spell(name)
            for one in listing.reference.lines
            if name in one.bound and type(one.bound[name]) is type(arg) and isinstance(arg, int | Value)
        ]
        if isinstance(arg, int):
            others_there += [line.spell(name).replace(str(arg), str(arg + step)) for step in (-1, 1)]
        for other in dict.fromkeys(others_there):
            yield from _with_operand(listing, number, name, other, "number")


def _with_operand(listing: Listing, number: int, name: str, other: str, kind: Kind) -> Iterator[Edit]:
    line = listing.lines[number]
    if other != line.spell(name) and not line.said:
        words = line.insn.separator.join(other if one == name else line.spell(one) for one in line.bound)
        yield listing.changed(kind, number, f"{line.insn.word} {words}")


def _blocks(listing: Listing, number: int) -> Iterator[Edit]:
    """Put another kind of timer or counter, or a reset for a set."""
    line = listing.lines[number]
    operands = line.text.partition(" ")[2]
    for word in others(listing.program.dialect, line.insn.mnemonic):
        yield listing.changed("block", number, f"{word} {operands}".strip())


def _operands(listing: Listing, number: int) -> Iterator[Edit]:
    """Put another bit: for a contact any that is named, for a coil one that is written; for a block one of its area."""
    line = listing.lines[number]
    targets = {verb.target for verb in line.insn.then}
    for name, arg in line.bound.items():
        if not isinstance(arg, Address):
            continue
        pool = listing.written if name in targets else listing.bits
        if arg.size != 1:
            named = (place for one in listing.reference.lines for place in one.places)
            pool = _addresses([place for place in named if place.area == arg.area and place.size == arg.size])
        for other in pool:
            yield from _with_operand(listing, number, name, other, "operand")


def _deleted(listing: Listing, number: int) -> Iterator[Edit]:
    yield listing.changed("delete", number)


@lru_cache(maxsize=16)
def _words_without_operands(dialect: Dialect) -> tuple[str, ...]:
    roles: tuple[Role, ...] = ("join_parallel", "join_series", "push", "read", "pop", "invert", "rise", "fall")
    words = [dialect.words[dialect.roles[role]] for role in roles if role in dialect.roles]
    closing = [row.mnemonic for row in dialect.insns if any(one.close == row.effect for one in words if one.close)]
    plain = [row.mnemonic for row in words if not row.operands or (row.close is None and row.bare is not None)]
    return tuple(dict.fromkeys([*plain, *closing]))


def _missing_words(listing: Listing) -> tuple[str, ...]:
    return listing.missing


def _stack_words(listing: Listing) -> tuple[str, ...]:
    """Give what can be put into a list without an operand."""
    return _words_without_operands(listing.program.dialect)


def _contact_words(listing: Listing) -> tuple[str, ...]:
    """Give every contact that can be put into a list, in series and in parallel, open and closed."""
    roles: tuple[Role, ...] = ("series_not", "series", "parallel", "parallel_not")
    dialect = listing.program.dialect
    return tuple(f"{dialect.roles[role]} {address}" for role in roles for address in listing.bits)
