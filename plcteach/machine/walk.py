"""Follows every cell of every network without its value: who put it there, whether anyone has used it, where it went.

The rules about the stack are short because all of them read this one walk, and the walk is exact because it follows the same
`flow` as the machine.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.core.effect import Flow, Origin, flow, names

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.program import Line, Network, Program
    from plcteach.core.spec import Dialect, Role


@dataclass(slots=True, eq=False)
class Cell:
    """One cell's story.

    line: the line that put it there, None for what stood there before the network.  spent: an output has used it.
    branch: a push has saved it.  tag: FX's L or B.
    """

    line: Line | None = None
    spent: bool = False
    branch: bool = False
    tag: str = ""

    @property
    def live(self) -> bool:
        """Whether this network has put it there and nobody has used it yet."""
        return self.line is not None and not self.spent


@dataclass(frozen=True, slots=True)
class Move:
    """One line's doing: the cells before and after, what it took by name, and what it lost or dropped unused.

    spent, tags: for each cell afterwards whether it was spent by then, and the tag it bore.
    """

    line: Line
    role: Role | None
    before: tuple[tuple[Cell, ...], ...]
    after: tuple[tuple[Cell, ...], ...]
    flow: Flow
    taken: dict[str, Cell]
    lost: tuple[Cell, ...]
    dropped: tuple[Cell, ...]
    spent: tuple[tuple[bool, ...], ...]
    tags: tuple[tuple[str, ...], ...]


@dataclass(frozen=True, slots=True)
class Walk:
    """All moves of one network, and the cells that stand when it ends."""

    dialect: Dialect
    network: Network
    moves: tuple[Move, ...]
    end: tuple[tuple[Cell, ...], ...] = field(default=())

    @property
    def last(self) -> Line:
        """The network's last line, where its residue is reported."""
        return self.network.lines[-1]


def walks(program: Program) -> Iterator[Walk]:
    """Walk every network that has lines; each begins as the family begins it, with cells that are not its own."""
    for network in program.networks:
        if network.lines:
            yield _walk(program.dialect, network)


def _walk(dialect: Dialect, network: Network) -> Walk:
    stacks = tuple(tuple(Cell() for _ in range(stack.depth)) if stack.fixed else () for stack in dialect.stacks)
    moves = []
    for line in network.lines:
        move = _move(dialect, line, stacks)
        moves.append(move)
        stacks = move.after
    return Walk(dialect, network, tuple(moves), stacks)


def _move(dialect: Dialect, line: Line, before: tuple[tuple[Cell, ...], ...]) -> Move:
    moves = flow(line.effect, dialect.shapes, tuple(map(len, before)))
    role = dialect.parts.get(line.insn.mnemonic)
    taken = {name: before[stack][place] for name, (stack, place) in moves.named.items()}
    lost = tuple(before[stack][place] for stack, place in moves.lost if before[stack][place].live)
    dropped = tuple(before[stack][place] for stack, place in moves.dropped if before[stack][place].live)
    after = tuple(tuple(_cell(origin, before, line, role) for origin in stack) for stack in moves.after)
    for verb in line.insn.then:
        for name in names(verb.formula) if verb.formula else ():
            if name in taken:
                taken[name].spent = True
    spent = tuple(tuple(cell.spent for cell in stack) for stack in after)
    tags = tuple(tuple(cell.tag for cell in stack) for stack in after)
    return Move(line, role, before, after, moves, taken, lost, dropped, spent, tags)


def _cell(origin: Origin, before: tuple[tuple[Cell, ...], ...], line: Line, role: Role | None) -> Cell:
    if origin.how == "blank":
        return Cell()
    if origin.how == "kept":
        stack, place = origin.sources[0]
        cell = before[stack][place]
        cell.tag = origin.tag or ("" if place == 0 else cell.tag)
        return cell
    return Cell(line, branch=role == "push", tag=origin.tag)
