"""An instruction list after reading: lines in networks, each with its instruction and its resolved effect."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.diagnostic import errors
from plcteach.core.source import Span

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.effect import Effect
    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect
    from plcteach.core.verb import Verb


@dataclass(frozen=True, slots=True)
class Value:
    """A number in a program, with its canonical spelling (K10, 16#0F, 3.14)."""

    number: int | float
    text: str

    def __repr__(self) -> str:
        return self.text


Source = Address | Value


@dataclass(frozen=True, slots=True)
class Compare:
    """Two words compared: an operand that reads as a bit. relation: one of = <> >= <= > <; kind: how wide the words are."""

    left: Source
    relation: str
    right: Source
    kind: str
    text: str

    def __repr__(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True)
class Assign:
    """A word worked out from others: target := op(sources), as NEZA writes it in brackets."""

    target: Address
    op: str
    sources: tuple[Source, ...]
    kind: str
    text: str

    def __repr__(self) -> str:
        return self.text


Arg = Address | Value | Compare | Assign | int


@dataclass(frozen=True, slots=True)
class Line:
    """One instruction of a program.

    bound: its operands by name.  effect: what it does here (FX's LD has two readings, `)` one for each opener).
    said: how the list spells it where that is shorter than its meaning (`IN` inside a block, for the pin of that block).
    """

    insn: Insn
    args: tuple[Arg, ...]
    effect: Effect
    span: Span = field(default=Span(0), compare=False)
    comment: str = ""
    above: tuple[str, ...] = ()
    said: str = ""
    bound: dict[str, Arg] = field(init=False, compare=False)

    def __post_init__(self) -> None:
        """Bind the operands to their names."""
        names = (operand.name for operand in self.insn.operands)
        object.__setattr__(self, "bound", dict(zip(names, self.args, strict=False)))

    def __repr__(self) -> str:
        return f"Line({self.text!r})"

    @property
    def text(self) -> str:
        """The canonical spelling: mnemonic, a space, the operands parted as the family does it."""
        if self.said:
            return self.said
        operands = self.insn.separator.join(map(self.spell, self.bound))
        word = self.insn.word
        return f"{word} {operands}".strip() if operands else word

    def spell(self, name: str) -> str:
        """Spell an operand, a number with its mark (N0, P3); "" where the line has none of this name."""
        arg = self.bound.get(name)
        if isinstance(arg, int):
            return f"{next(one.mark for one in self.insn.operands if one.name == name)}{arg}"
        return arg.text if arg else ""

    @property
    def targets(self) -> Iterator[tuple[Verb, Address]]:
        """Each verb of its instruction with the address that it works on, if it is one."""
        for verb in self.insn.then:
            target = self.bound.get(verb.target)
            if isinstance(target, Address):
                yield verb, target

    @property
    def bits(self) -> tuple[Address, ...]:
        """The operands that are addresses of bits."""
        return tuple(arg for arg in self.args if isinstance(arg, Address) and arg.size == 1)

    @property
    def places(self) -> tuple[Address, ...]:
        """Every address that the line names, inside comparisons and assignments too."""
        return tuple(place for arg in self.args for place in _places(arg))


def _places(arg: Arg) -> Iterator[Address]:
    match arg:
        case Address():
            yield arg
        case Compare(left, _, right):
            yield from (one for one in (left, right) if isinstance(one, Address))
        case Assign(target, _, sources):
            yield target
            yield from (one for one in sources if isinstance(one, Address))


@dataclass(frozen=True, slots=True)
class Network:
    """One network (rung) of a program, with its title and the lines in order; `block` is the subroutine it belongs to."""

    title: str
    lines: tuple[Line, ...]
    headed: bool = True
    block: str = ""


@dataclass(frozen=True)
class Program:
    """What the reader made of a text: as much as it understood, and everything it found.

    settings: for each configured block what its line says, by its words.  configuration: those lines, in canonical spelling.
    symbols: names for addresses, as a symbol table gives them.
    """

    dialect: Dialect
    networks: tuple[Network, ...]
    tail: tuple[str, ...] = ()
    configuration: tuple[str, ...] = ()
    source: str = field(default="", compare=False)
    diagnostics: tuple[Diagnostic, ...] = field(default=(), compare=False)
    settings: Mapping[str, Mapping[str, int | str | tuple[str, ...]]] = field(default_factory=dict, compare=False)
    symbols: Mapping[str, str] = field(default_factory=dict, compare=False)

    def __repr__(self) -> str:
        lines = sum(len(network.lines) for network in self.networks)
        return f"Program({self.dialect.name}, {len(self.networks)} networks, {lines} lines)"

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """All lines of all networks, in the order in which they stand."""
        return tuple(line for network in self.networks for line in network.lines)

    @property
    def runs(self) -> bool:
        """Whether the text could be read without an error."""
        return not errors(self.diagnostics)

    def addresses(self, role: str) -> tuple[Address, ...]:
        """Give the bits of one role ("input", "output", "memory") that the program or its configuration names, in order of index."""
        return tuple(one for one in self._named if self.dialect.area(one).role == role)

    @cached_property
    def _named(self) -> tuple[Address, ...]:
        """Every bit that the program or its configuration names, in order of area and index."""
        touched = [arg for line in self.lines for arg in _touched(self.dialect, line)]
        listed = [
            word
            for said in self.settings.values()
            for words in said.values()
            if isinstance(words, tuple)
            for word in words
        ]
        touched += [
            place for word in listed if isinstance(place := self.dialect.address(word), Address) and place.size == 1
        ]
        found = {one for arg in touched for one in self.dialect.bits_of(arg)}
        return tuple(sorted(found, key=lambda address: (address.area, address.index, address.text)))

    def words(self) -> tuple[Address, ...]:
        """Give the words that the program names, and the blocks, in order of area and index."""
        found = {place for line in self.lines for place in line.places if place.size != 1}
        return tuple(sorted(found, key=lambda address: (address.area, address.index, address.text)))


def _touched(dialect: Dialect, line: Line) -> Iterator[Address]:
    bound = line.bound
    counts = {verb.target: bound.get(verb.count, 1) for verb in line.insn.then}
    for name, arg in bound.items():
        if isinstance(arg, Address) and arg.size == 1:
            count = counts.get(name, 1)
            yield from dialect.following(arg, count if isinstance(count, int) else 1)
        else:
            yield from _places(arg)
