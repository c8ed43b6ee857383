"""The formulas of one line, worked out over any signal, with what is read, written and remembered along the way."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar

from plcteach.core.area import Address
from plcteach.core.effect import At, Both, Edge, Flow, Formula, Name, Not, Origin
from plcteach.core.insn import REGISTERS
from plcteach.core.program import Compare
from plcteach.machine.signals import Signal

if TYPE_CHECKING:
    from plcteach.core.insn import Operand
    from plcteach.core.program import Arg, Line
    from plcteach.core.verb import Verb

S = TypeVar("S", bound=Signal)

Stacks = tuple[tuple[S, ...], ...]
"""For each stack of the dialect its values, top first."""


class World(Protocol[S]):
    """What an instruction can ask of the rest of the PLC."""

    spells: bool
    """Whether bits are names here and nothing ever happens: blocks and words are passed over."""

    rail: S | None
    """The power of the left rail; None where nothing has switched it."""

    def read(self, operand: Operand, address: Address) -> S:
        """Give the bit that an operand of this kind sees at an address."""
        ...

    def compare(self, compare: Compare) -> S:
        """Say how two words compare."""
        ...

    def register(self, name: str) -> S:
        """Give a bit of the machine itself (ENO)."""
        ...

    def past(self, address: Address | None, value: S) -> tuple[S, S | None]:
        """Give the two values between which an edge is looked for: now, and the last time (None: never before)."""
        ...

    def following(self, address: Address, count: int) -> tuple[Address, ...]:
        """Give `count` addresses from this one on."""
        ...


@dataclass(slots=True)
class Evaluation(Generic[S]):
    """One line being executed.

    seen: what it read.  written: addresses with their new bits and words.  kept, numbers: what blocks and edges remember,
    which no address names.  world: a World; deeds ask more of it, where it is a whole plant.  asks: verbs that change where the program goes on or what is powered, each with its condition.
    """

    line: Line
    before: Stacks[S]
    moves: Flow
    world: Any
    blank: S
    seen: list[tuple[Address | Compare, S]] = field(default_factory=list)
    written: list[tuple[Address, Any]] = field(default_factory=list)
    kept: list[tuple[str, S]] = field(default_factory=list)
    numbers: list[tuple[str, Any]] = field(default_factory=list)
    asks: list[tuple[Verb, S | None]] = field(default_factory=list)
    remembered: S | None = None

    def head(self, number: int) -> tuple[S, ...]:
        """Give the cells that the effect itself puts on one stack; the others have only moved."""
        return tuple(self.cell(origin) for origin in self.moves.after[number][: self.moves.heads[number]])

    def cell(self, origin: Origin) -> S:
        """Give one cell; what a load puts there comes from the left rail, and is 0 where the rail has no power."""
        if origin.formula is not None:
            value = self.value(origin.formula)
            rail = self.world.rail
            fed: S = value if rail is None or origin.sources else value & rail
            return fed
        stack, place = origin.sources[0]
        return self.before[stack][place] if place < len(self.before[stack]) else self.blank

    def value(self, formula: Formula) -> S:
        """Work out a formula."""
        match formula:
            case Name(name):
                return self.named(name)
            case Not(of):
                return ~self.value(of)
            case Both(op, left, right):
                a, b = self.value(left), self.value(right)
                return a & b if op == "&" else a | b if op == "|" else a ^ b
            case Edge(rising, of):
                return self.edge(of, rising=rising)
            case At():
                return self.blank

    def power(self, formula: Formula | None) -> S | None:
        """Work out the formula of a verb; without power on the rail nothing fires. None: the verb has no condition."""
        if formula is None:
            return None
        value: S = self.value(formula)
        return value if self.world.rail is None else value & self.world.rail

    def named(self, name: str) -> S:
        """Give a cell taken from the stack, a register, or what an operand reads."""
        place = self.moves.named.get(name)
        if place is not None:
            return self.before[place[0]][place[1]]
        if name in REGISTERS:
            register: S = self.world.register(name)
            return register
        arg = self.line.bound.get(name)
        if isinstance(arg, Compare):
            value: S = self.world.compare(arg)
            self.seen.append((arg, value))
            if not self.world.spells:
                kind = self.world.dialect.kinds[arg.kind]
                self.seen += [
                    (one, self.world.word(one, kind)) for one in (arg.left, arg.right) if isinstance(one, Address)
                ]
            return value
        if isinstance(arg, Address):
            value = self.world.read(self.operand(name), arg)
        else:
            return self.blank
        self.seen.append((arg, value))
        return value

    def operand(self, name: str) -> Operand:
        """Give the declaration of an operand."""
        return next(one for one in self.line.insn.operands if one.name == name)

    def edge(self, of: Formula, *, rising: bool) -> S:
        """Give the edge of a formula since this line last ran."""
        value = self.value(of)
        address = self.line.bound.get(of.name) if isinstance(of, Name) else None
        now, last = self.world.past(address if isinstance(address, Address) else None, value)
        self.remembered = value
        edge: S = now.edge(last, rising=rising)
        return edge

    def bound(self, name: str) -> Arg | None:
        """Give what stands for an operand in this line."""
        return self.line.bound.get(name)
