"""One instruction, executed: the stack before, the stack after, what was read and what is to be written.

`step` is pure. It reads through a `World`, changes nothing, and gives everything back in a `Step`; stepping back is indexing.
Where each cell comes from is the business of `core.effect.flow`, so the same origins serve every signal and every picture.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Generic, Protocol, TypeVar

from plcteach.core.area import Address
from plcteach.core.effect import At, Both, Edge, Flow, Formula, Name, Not, Origin, Shape, flow
from plcteach.machine.signals import Signal

if TYPE_CHECKING:
    from plcteach.core.program import Line
    from plcteach.core.spec import Operand, Verb

S = TypeVar("S", bound=Signal)

Stacks = tuple[tuple[S, ...], ...]
"""For each stack of the dialect its values, top first."""


class World(Protocol[S]):
    """What an instruction can ask of the rest of the PLC."""

    def read(self, operand: Operand, address: Address) -> S:
        """Give the bit that an operand of this kind sees at an address."""
        ...

    def past(self, address: Address | None, value: S) -> tuple[S, S | None]:
        """Give the two values between which an edge is looked for: now, and the last time (None: never before)."""
        ...

    def following(self, address: Address, count: int) -> tuple[Address, ...]:
        """Give `count` addresses from this one on."""
        ...


@dataclass(frozen=True, slots=True)
class Step(Generic[S]):
    """What one line did. `before` and `after` hold the values, `flow` says which cell became which."""

    line: Line
    before: Stacks[S]
    after: Stacks[S]
    flow: Flow
    read: tuple[tuple[Address, S], ...]
    written: tuple[tuple[Address, S], ...]
    remembered: S | None = None

    def __repr__(self) -> str:
        return f"Step({self.line.text!r}: {self.before[0]} -> {self.after[0]})"


def step(line: Line, shapes: tuple[Shape, ...], before: Stacks[S], world: World[S], blank: S) -> Step[S]:
    """Execute one line; `blank` is what stands in a cell that nobody has filled."""
    moves = flow(line.effect, shapes, tuple(map(len, before)))
    evaluation = _Evaluation(line, before, moves, world, blank)
    after = tuple(
        evaluation.head(number)
        + before[number][start:stop]
        + (blank,) * (len(moves.after[number]) - moves.heads[number] - stop + start)
        for number, (start, stop) in enumerate(moves.tails)
    )
    written = tuple(write for verb in line.insn.then for write in evaluation.writes(verb))
    return Step(line, before, after, moves, tuple(evaluation.seen), written, evaluation.remembered)


@dataclass(slots=True)
class _Evaluation(Generic[S]):
    """The formulas of one line, with what they read along the way."""

    line: Line
    before: Stacks[S]
    moves: Flow
    world: World[S]
    blank: S
    seen: list[tuple[Address, S]] = field(default_factory=list)
    remembered: S | None = None

    def head(self, number: int) -> tuple[S, ...]:
        """Give the cells that the effect itself puts on one stack; the others have only moved."""
        return tuple(self.cell(origin) for origin in self.moves.after[number][: self.moves.heads[number]])

    def cell(self, origin: Origin) -> S:
        if origin.formula is not None:
            return self.value(origin.formula)
        stack, place = origin.sources[0]
        return self.before[stack][place] if place < len(self.before[stack]) else self.blank

    def value(self, formula: Formula) -> S:
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

    def named(self, name: str) -> S:
        place = self.moves.named.get(name)
        if place is not None:
            return self.before[place[0]][place[1]]
        address = self.line.bound.get(name)
        if not isinstance(address, Address):
            return self.blank
        operand = next(one for one in self.line.insn.operands if one.name == name)
        value = self.world.read(operand, address)
        self.seen.append((address, value))
        return value

    def edge(self, of: Formula, *, rising: bool) -> S:
        value = self.value(of)
        address = self.line.bound.get(of.name) if isinstance(of, Name) else None
        now, last = self.world.past(address if isinstance(address, Address) else None, value)
        self.remembered = value
        return now.edge(last, rising=rising)

    def writes(self, verb: Verb) -> list[tuple[Address, S]]:
        """Say what a verb writes: a coil its value; set and reset the old bit with the value worked in."""
        if verb.formula is None:
            return []
        value = self.value(verb.formula)
        bound = self.line.bound
        target, count = bound[verb.target], bound.get(verb.count, 1)
        if not isinstance(target, Address) or not isinstance(count, int):
            return []
        operand = next(one for one in self.line.insn.operands if one.name == verb.target)
        places = self.world.following(target, count)
        if verb.name == "coil":
            return [(place, value) for place in places]
        old = [(place, self.world.read(operand, place)) for place in places]
        return [(place, was | value if verb.name == "set" else was & ~value) for place, was in old]
