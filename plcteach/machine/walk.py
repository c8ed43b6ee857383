"""Follows every cell of every network without its value: who put it there, whether anyone has used it, where it went.

The rules about the stack are short because all of them read this one walk, and the walk is exact because it follows the same
`flow` as the machine.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.core.effect import Flow, Origin, Place, flow

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.program import Line, Network, Program
    from plcteach.core.spec import Dialect, Role


@dataclass(frozen=True, slots=True)
class Cell:
    """What is known of one cell at one moment.

    line: the line that put it there, None for what stood there before the network.  spent: an output has used it.
    branch: a push has saved it and no pop has fetched it.  tag: FX's L or B.
    """

    line: Line | None = None
    spent: bool = False
    branch: bool = False
    tag: str = ""

    @property
    def live(self) -> bool:
        """Whether this network has put it there and nobody has used it yet."""
        return self.line is not None and not self.spent


Cells = tuple[tuple[Cell, ...], ...]
"""For each stack of the dialect its cells, top first."""


@dataclass(frozen=True, slots=True)
class Move:
    """One line's doing: the cells before and after, what it took by name, and the places of live cells it lost or dropped."""

    line: Line
    role: Role | None
    before: Cells
    after: Cells
    flow: Flow
    taken: dict[str, Cell]
    lost: tuple[Place, ...]
    dropped: tuple[Place, ...]

    def at(self, place: Place) -> Cell:
        """Give the cell that stood at a place before the line."""
        return self.before[place[0]][place[1]]


@dataclass(frozen=True, slots=True)
class Walk:
    """All moves of one network, and the cells that stand when it ends."""

    dialect: Dialect
    network: Network
    moves: tuple[Move, ...]
    end: Cells = field(default=())

    @property
    def last(self) -> Line:
        """The network's last line, where its residue is reported."""
        return self.network.lines[-1]

    @property
    def leftover(self) -> list[Cell]:
        """The network's own unused cells at its end, of all stacks but the parentheses, which the reader watches."""
        kept = [cells for cells, stack in zip(self.end, self.dialect.stacks, strict=True) if stack.name != "paren"]
        return [cell for number, cells in enumerate(kept) for cell in cells if cell.live or (number and cell.line)]


def walks(program: Program) -> Iterator[Walk]:
    """Walk every network that has lines; each begins as the family begins it, with cells that are not its own."""
    for network in program.networks:
        if network.lines:
            yield walk(program.dialect, network)


def walk(dialect: Dialect, network: Network) -> Walk:
    """Walk one network that has lines."""
    stacks: Cells = tuple((Cell(),) * stack.depth if stack.fixed else () for stack in dialect.stacks)
    moves = []
    for line in network.lines:
        move = _move(dialect, line, stacks)
        moves.append(move)
        stacks = move.after
    return Walk(dialect, network, tuple(moves), stacks)


def _move(dialect: Dialect, line: Line, before: Cells) -> Move:
    moves = flow(line.effect, dialect.shapes, tuple(map(len, before)))
    role = dialect.parts.get(line.insn.mnemonic)
    taken = {name: before[stack][place] for name, (stack, place) in moves.named.items()}
    lost = tuple(place for place in moves.lost if before[place[0]][place[1]].live)
    dropped = tuple(place for place in moves.dropped if before[place[0]][place[1]].live)
    used = {moves.named[name] for name in _read_by_verbs(line) if name in moves.named}
    spent, branch = line.insn.powers, role == "push"
    after = tuple(
        tuple(
            _kept(origin, before, (number, place), used)
            if origin.how == "kept"
            else Cell()
            if origin.how == "blank"
            else Cell(line, spent, branch, origin.tag)
            for place, origin in enumerate(stack)
        )
        for number, stack in enumerate(moves.after)
    )
    return Move(line, role, before, after, moves, taken, lost, dropped)


def _read_by_verbs(line: Line) -> set[str]:
    return {name for verb in line.insn.then for name in verb.names}


def _kept(origin: Origin, before: Cells, here: Place, used: set[Place]) -> Cell:
    """Give a kept cell afterwards: it is spent once read by an output, and no branch point any more once it is the top."""
    stack, place = origin.sources[0]
    cell = before[stack][place]
    top = here == (0, 0)
    spent = cell.spent or (stack, place) in used
    branch = cell.branch and not top
    tag = origin.tag or ("" if top else cell.tag)
    return cell if (spent, branch, tag) == (cell.spent, cell.branch, cell.tag) else Cell(cell.line, spent, branch, tag)
