"""An instruction list after reading: lines in networks, each with its instruction and its resolved effect."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.diagnostic import errors
from plcteach.core.source import Span

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.effect import Effect
    from plcteach.core.spec import Dialect, Insn

Arg = Address | int


@dataclass(frozen=True, slots=True)
class Line:
    """One instruction of a program; `bound` has its operands by name, `effect` is what it does here (FX's LD has two readings, `)` one for each opener)."""

    insn: Insn
    args: tuple[Arg, ...]
    effect: Effect
    span: Span = field(default=Span(0), compare=False)
    comment: str = ""
    above: tuple[str, ...] = ()
    bound: dict[str, Arg] = field(init=False, compare=False)

    def __post_init__(self) -> None:
        """Bind the operands to their names."""
        names = (operand.name for operand in self.insn.operands)
        object.__setattr__(self, "bound", dict(zip(names, self.args, strict=False)))

    def __repr__(self) -> str:
        return f"Line({self.text!r})"

    @property
    def text(self) -> str:
        """The canonical spelling: mnemonic, a space, the operands separated by commas."""
        operands = ", ".join(str(arg) if isinstance(arg, int) else arg.text for arg in self.args)
        return f"{self.insn.mnemonic} {operands}" if operands else self.insn.mnemonic

    @property
    def bits(self) -> tuple[Address, ...]:
        """The operands that are addresses."""
        return tuple(arg for arg in self.args if isinstance(arg, Address))


@dataclass(frozen=True, slots=True)
class Network:
    """One network (rung) of a program, with its title and the lines in order."""

    title: str
    lines: tuple[Line, ...]
    headed: bool = True


@dataclass(frozen=True, slots=True)
class Program:
    """What the reader made of a text: as much as it understood, and everything it found."""

    dialect: Dialect
    networks: tuple[Network, ...]
    tail: tuple[str, ...] = ()
    source: str = field(default="", compare=False)
    diagnostics: tuple[Diagnostic, ...] = field(default=(), compare=False)

    def __repr__(self) -> str:
        lines = sum(len(network.lines) for network in self.networks)
        return f"Program({self.dialect.name}, {len(self.networks)} networks, {lines} lines)"

    @property
    def lines(self) -> tuple[Line, ...]:
        """All lines of all networks, in the order in which a scan executes them."""
        return tuple(line for network in self.networks for line in network.lines)

    @property
    def runs(self) -> bool:
        """Whether the text could be read without an error."""
        return not errors(self.diagnostics)

    def addresses(self, role: str) -> tuple[Address, ...]:
        """Give the addresses of one role ("input", "output", "memory") that the program names, in order of index."""
        found = {arg for line in self.lines for arg in _touched(self.dialect, line)}
        mine = (address for address in found if self.dialect.area(address).role == role)
        return tuple(sorted(mine, key=lambda address: (address.area, address.index)))


def _touched(dialect: Dialect, line: Line) -> Iterator[Address]:
    bound = line.bound
    counts = {verb.target: bound.get(verb.count, 1) for verb in line.insn.then}
    for name, arg in bound.items():
        if isinstance(arg, Address):
            count = counts.get(name, 1)
            yield from dialect.following(arg, count if isinstance(count, int) else 1)
