"""One instruction, executed: the stack before, the stack after, what was read and what is to be written.

`step` is pure. It reads through a `World`, changes nothing, and gives everything back in a `Step`; stepping back is indexing.
Where each cell comes from is the business of `core.effect.flow`, so the same origins serve every signal and every picture.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from plcteach.core.effect import Flow, Shape, flow
from plcteach.machine.deeds import DEEDS, ask
from plcteach.machine.evaluation import Evaluation, Stacks, World
from plcteach.machine.signals import Signal

if TYPE_CHECKING:
    from plcteach.core.area import Address
    from plcteach.core.program import Compare, Line
    from plcteach.core.verb import Verb

S = TypeVar("S", bound=Signal)

__all__ = ["Stacks", "Step", "World", "step"]


@dataclass(frozen=True, slots=True)
class Step(Generic[S]):
    """What one line did. `before` and `after` hold the values, `flow` says which cell became which.

    number: the line's number in the program, from 0.  read, written: bits and words by address.  kept, numbers: what an edge
    or a block remembers beside them.  asks: verbs about where to go on, each with its condition.
    """

    line: Line
    before: Stacks[S]
    after: Stacks[S]
    flow: Flow
    read: tuple[tuple[Address | Compare, S], ...]
    written: tuple[tuple[Address, Any], ...]
    remembered: S | None = None
    kept: tuple[tuple[str, S], ...] = ()
    numbers: tuple[tuple[str, Any], ...] = ()
    asks: tuple[tuple[Verb, S | None], ...] = ()
    number: int = 0

    def __repr__(self) -> str:
        return f"Step({self.line.text!r}: {self.before[0]} -> {self.after[0]})"


def step(
    line: Line, shapes: tuple[Shape, ...], before: Stacks[S], world: World[S], blank: S, *, number: int = 0
) -> Step[S]:
    """Execute one line; `blank` is what stands in a cell that nobody has filled."""
    moves = flow(line.effect, shapes, tuple(map(len, before)))
    doing = Evaluation(line, before, moves, world, blank)
    after = tuple(
        doing.head(place)
        + before[place][start:stop]
        + (blank,) * (len(moves.after[place]) - moves.heads[place] - stop + start)
        for place, (start, stop) in enumerate(moves.tails)
    )
    for verb in line.insn.then:
        DEEDS.get(verb.name, ask)(doing, verb)
    return Step(
        line,
        before,
        after,
        moves,
        tuple(doing.seen),
        tuple(doing.written),
        doing.remembered,
        tuple(doing.kept),
        tuple(doing.numbers),
        tuple(doing.asks),
        number,
    )
