"""Where the symbols of a rung stand on a grid of columns and rows, and which wires join them.

The text drawing and the figure share this plan, so that both show the same rung alike. Boundaries count from 0, the left rail;
column c lies between boundaries c and c + 1; the last column holds the coils. Each piece of wire belongs to a net, a number;
net 0 is the left rail.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from plcteach.core.ladder import Branch, Coil, Contact, Invert, Node, Out, Parallel, Rung, Series

RAIL = 0
Symbol = Contact | Invert | Coil


@dataclass(frozen=True, slots=True)
class Placed:
    """A symbol, the cell it stands in, and the nets on its left and right; a coil's right is the right rail, None."""

    symbol: Symbol
    row: int
    column: int
    source: int
    target: int | None


@dataclass(frozen=True, slots=True)
class Run:
    """A plain wire through the columns from `start` up to, not including, `stop`."""

    row: int
    start: int
    stop: int
    net: int


@dataclass(frozen=True, slots=True)
class Post:
    """A vertical wire on a boundary, and the rows that are joined to it, topmost first.

    opens: whether paths part here; where they come together, and part again at once, two posts share boundary and net.
    """

    boundary: int
    rows: tuple[int, ...]
    net: int
    opens: bool


@dataclass(frozen=True, slots=True)
class Layout:
    """The plan of one rung; pieces stand in the order of execution."""

    columns: int
    rows: int
    pieces: tuple[Placed, ...]
    runs: tuple[Run, ...]
    posts: tuple[Post, ...]

    @property
    def doubled(self) -> frozenset[tuple[int, int]]:
        """Boundaries and nets with two posts, which are drawn apart so that no path seems to run straight on."""
        count = Counter((post.boundary, post.net) for post in self.posts)
        return frozenset(place for place, number in count.items() if number > 1)


def layout(rung: Rung) -> Layout:
    """Plan a rung: parallel parts below each other, parts in series from left to right, coils in the last column."""
    plan = _Plan(_columns(rung.stem, rung.outs))
    node = plan.net() if rung.stem else RAIL
    width = plan.node(rung.stem, 0, 0, RAIL, node) if rung.stem else 0
    plan.outs(rung.outs, 0, width, node)
    posts = tuple(
        Post(boundary, tuple(sorted(rows)), net, opens) for (boundary, net, opens), rows in sorted(plan.posts.items())
    )
    rows = 1 + max(piece.row for piece in plan.pieces)
    return Layout(plan.columns, rows, tuple(plan.pieces), tuple(plan.runs), posts)


def _width(node: Node) -> int:
    match node:
        case Series(parts):
            return sum(map(_width, parts))
        case Parallel(parts):
            return max(map(_width, parts))
    return 1


def _height(part: Node | Out) -> int:
    match part:
        case Series(parts):
            return max(map(_height, parts))
        case Parallel(parts):
            return sum(map(_height, parts))
        case Branch(stem, outs):
            return max(_height(stem), sum(map(_height, outs)))
    return 1


def _columns(stem: Node | None, outs: tuple[Out, ...]) -> int:
    widest = max(_columns(one.stem, one.outs) if isinstance(one, Branch) else 1 for one in outs)
    return widest + (_width(stem) if stem else 0)


@dataclass(slots=True)
class _Plan:
    """The plan while it is being made."""

    columns: int
    nets: int = RAIL
    pieces: list[Placed] = field(default_factory=list)
    runs: list[Run] = field(default_factory=list)
    posts: dict[tuple[int, int, bool], set[int]] = field(default_factory=dict)

    def net(self) -> int:
        self.nets += 1
        return self.nets

    def post(self, boundary: int, net: int, rows: list[int], *, opens: bool) -> None:
        if len(rows) > 1:
            self.posts.setdefault((boundary, net, opens), set()).update(rows)

    def run(self, row: int, start: int, stop: int, net: int) -> None:
        if start < stop:
            self.runs.append(Run(row, start, stop, net))

    def node(self, node: Node, row: int, column: int, source: int, target: int) -> int:
        """Place a node with its upper left corner in a cell, between two nets, and give its width."""
        match node:
            case Series(parts):
                at = column
                for number, part in enumerate(parts, 1):
                    net = target if number == len(parts) else self.net()
                    at += self.node(part, row, at, source, net)
                    source = net
                return at - column
            case Parallel(parts):
                return self.parallel(parts, row, column, source, target)
        self.pieces.append(Placed(node, row, column, source, target))
        return 1

    def parallel(self, parts: tuple[Node, ...], row: int, column: int, source: int, target: int) -> int:
        width, rows = max(map(_width, parts)), []
        for part in parts:
            rows.append(row)
            end = column + self.node(part, row, column, source, target)
            self.run(row, end, column + width, target)
            row += _height(part)
        self.post(column, source, rows, opens=True)
        self.post(column + width, target, rows, opens=False)
        return width

    def outs(self, outs: tuple[Out, ...], row: int, column: int, net: int) -> None:
        """Hang outputs on a net, one below the other."""
        rows = []
        for one in outs:
            rows.append(row)
            if isinstance(one, Coil):
                self.run(row, column, self.columns - 1, net)
                self.pieces.append(Placed(one, row, self.columns - 1, net, None))
            else:
                target = self.net()
                width = self.node(one.stem, row, column, net, target)
                self.outs(one.outs, row, column + width, target)
            row += _height(one)
        self.post(column, net, rows, opens=True)
