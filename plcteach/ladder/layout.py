"""Where the symbols of a rung stand on a grid of columns and rows, and which wires join them.

The text drawing and the figure share this plan, so that both show the same rung alike. Boundaries count from 0, the left rail;
column c lies between boundaries c and c + 1; the last column holds coils and boxes. Each piece of wire belongs to a net, a
number; net 0 is the left rail. A box of several inputs is as high as they need, below everything else of its rung.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from plcteach.core.ladder import Box, Branch, Node, Out, Parallel, Rung, Series, Symbol

RAIL = 0


@dataclass(frozen=True, slots=True)
class Placed:
    """A symbol, the cell it stands in, and the nets on its left and right; right of a coil or box is the right rail, None."""

    symbol: Symbol
    row: int
    column: int
    source: int
    target: int | None


@dataclass(frozen=True, slots=True)
class Pin:
    """A further input of the box that stands above it in the last column: its name, its row, and the net that feeds it."""

    name: str
    row: int
    source: int


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
    """The plan of one rung; pieces stand in the order of execution, a box after what feeds its inputs."""

    columns: int
    rows: int
    pieces: tuple[Placed, ...]
    runs: tuple[Run, ...]
    posts: tuple[Post, ...]
    pins: tuple[Pin, ...] = ()

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
    return Layout(plan.columns, plan.rows, tuple(plan.pieces), tuple(plan.runs), posts, tuple(plan.pins))


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
    """Count the columns of a node and what hangs on it; the inputs of a box begin at the left rail on their own."""
    widest = max(_columns(one.stem, one.outs) if isinstance(one, Branch) else 1 for one in outs)
    pins = [_width(node) + 1 for one in outs if isinstance(one, Box) for _, node in one.pins]
    return max(widest + (_width(stem) if stem else 0), *pins, 1)


@dataclass(slots=True)
class _Plan:
    """The plan while it is being made."""

    columns: int
    nets: int = RAIL
    pieces: list[Placed] = field(default_factory=list)
    runs: list[Run] = field(default_factory=list)
    posts: dict[tuple[int, int, bool], set[int]] = field(default_factory=dict)
    pins: list[Pin] = field(default_factory=list)
    rows: int = 1

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
        self.put(Placed(node, row, column, source, target))
        return 1

    def put(self, piece: Placed) -> None:
        self.pieces.append(piece)
        self.rows = max(self.rows, piece.row + 1)

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
            if isinstance(one, Branch):
                target = self.net()
                width = self.node(one.stem, row, column, net, target)
                self.outs(one.outs, row, column + width, target)
            else:
                self.run(row, column, self.columns - 1, net)
                self.rows = max(self.rows, row + 1)
                if isinstance(one, Box):
                    self.inputs(one)
                self.put(Placed(one, row, self.columns - 1, net, None))
            row += _height(one)
        self.post(column, net, rows, opens=True)

    def inputs(self, box: Box) -> None:
        """Lead the further inputs of a box to it from the left rail, each below all that stands already."""
        for name, node in box.pins:
            row, net = self.rows, self.net()
            width = self.node(node, row, 0, RAIL, net)
            self.run(row, width, self.columns - 1, net)
            self.pins.append(Pin(name, row, net))
