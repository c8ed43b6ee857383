"""One rung as shapes: its plan cut into bands, wires and dots, and every symbol in the state that it is shown in."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from itertools import chain
from typing import TYPE_CHECKING

from plcteach.core.ladder import Box as Block
from plcteach.core.ladder import Coil
from plcteach.core.text import same
from plcteach.figure.bands import Band, bands
from plcteach.figure.power import live_nets, passes
from plcteach.figure.scene import Box, Disc, Stroke, Words
from plcteach.figure.symbol import LABEL, Style, box_reach, box_shapes, half, symbol_shapes
from plcteach.ladder.layout import RAIL, Layout, Pin, Placed, Post, Run

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from plcteach.figure.power import Conducts
    from plcteach.figure.scene import Shape

_ROW, _HEAD, _FOOT = 58.0, 34.0, 24.0
_BESIDE = 9.0
"""So far from its boundary stands each of two posts that are drawn apart."""
_BETWEEN = 10.0
_INSET = 18.0
"""So far off the left rail goes on what a band above has begun."""


Joint = tuple[int, bool]
"""A vertical wire by its net, and whether paths part there (True) or come together."""


@dataclass(frozen=True, slots=True)
class Frame:
    """What all rungs of a ladder share: the left rail, the width of a cell and of the last column, how many columns fit."""

    left: float
    cell: float
    last: float
    columns: int

    @property
    def right(self) -> float:
        """Where the right rail stands."""
        return self.left + self.cell * (self.columns - 1) + self.last

    @property
    def most(self) -> int:
        """The number of columns of a band."""
        return self.columns


@dataclass(frozen=True, slots=True)
class Look:
    """How a rung is shown: by symbol numbers, those that are not built yet and the groups that are bracketed.

    loose: nets whose paths nothing has joined yet, each with whether the joint opens (a block in series) or closes (parallel).
    conducts: what lets power through; None where no power is shown.  live: it will be pointed at, so every sign gets an area.
    """

    style: Style = "relay"
    conducts: Conducts | None = None
    unbuilt: frozenset[int] = frozenset()
    brackets: tuple[frozenset[int], ...] = ()
    loose: frozenset[Joint] = frozenset()
    live: bool = False


@dataclass(slots=True)
class Picture:
    """One rung on its way to shapes, its top at a height; `number` counts rungs from 0 and names its parts."""

    plan: Layout
    frame: Frame
    look: Look
    top: float
    number: int = 0
    pieces: dict[Placed, int] = field(init=False)
    live: frozenset[int] = field(init=False)
    cut: tuple[Band, ...] = field(init=False)
    heights: list[list[float]] = field(init=False)

    def __post_init__(self) -> None:
        """Work out where each row of each band stands, and which wires carry power."""
        self.pieces = {piece: number for number, piece in enumerate(self.plan.pieces)}
        self.live = live_nets(self.plan, self.look.conducts) if self.look.conducts else frozenset()
        self.cut = bands(self.plan, self.frame.most)
        self.heights, y = [], self.top
        for band in self.cut:
            rows = []
            for row in range(band.rows):
                y += _HEAD if not row else 0
                rows.append(y)
                y += (_ROW if row < band.rows - 1 else _FOOT) + self.deeper(band, row)
            self.heights.append(rows)
            y += _BETWEEN

    @property
    def bottom(self) -> float:
        """Where the next thing may begin."""
        last = self.cut[-1]
        return self.heights[-1][-1] + _FOOT + self.deeper(last, last.rows - 1)

    def deeper(self, band: Band, row: int) -> float:
        """Give how much more room a row needs below for a box that reaches far down."""
        last = self.plan.pins[-1].row if self.plan.pins else -1
        ends = [piece.row for piece in self.plan.pieces if isinstance(piece.symbol, Block) and band.last]
        boxes = [
            piece.symbol
            for piece in self.plan.pieces
            if isinstance(piece.symbol, Block) and piece.row == row and not piece.symbol.pins
        ]
        tall = [piece for piece in self.plan.pieces if isinstance(piece.symbol, Block) and piece.symbol.pins]
        more = max((box_reach(box) - 20 for box in boxes if row in ends), default=0)
        if tall and row == last and band.last:
            room = _ROW * (last - tall[0].row)
            more = max(more, box_reach(tall[0].symbol) - room - 20)  # type: ignore[arg-type]
        return max(0.0, more)

    def y(self, band: int, row: int) -> float:
        """Give the height of a row of a band."""
        return self.heights[band][row]

    def x(self, band: Band, boundary: int, net: int | None, *, opens: bool) -> float:
        """Give where a wire of a net begins (opens) or ends at a boundary: aside, where two posts are drawn apart."""
        aside = _BESIDE if (boundary, net) in self.plan.doubled else 0
        if boundary == self.plan.columns:
            return self.frame.right
        aside += _INSET if opens and boundary == band.start > 0 else 0
        x = self.frame.left + self.frame.cell * (boundary - band.start) + (aside if opens else -aside)
        return x if opens or boundary < band.stop else min(x, self.frame.right - _INSET)

    def band_of(self, column: int) -> int:
        """Give the band in which a column stands."""
        return next(number for number, band in enumerate(self.cut) if band.start <= column < band.stop)

    def middle(self, piece: Placed) -> float:
        """Give the middle of a symbol."""
        band = self.cut[self.band_of(piece.column)]
        if piece.target is None:
            return self.frame.right - self.frame.last / 2
        return self.frame.left + self.frame.cell * (piece.column - band.start + 0.5)

    def shapes(self) -> list[Shape]:
        """Give wires that are off, then wires that are on, then dots, symbols and words, each over the last."""
        wires = sorted(self.wires(), key=lambda wire: (wire.ink == "wire-on", wire.part))
        symbols = [shape for piece in self.plan.pieces for shape in self.symbol(piece)]
        return [*self.brackets(), *wires, *self.dots(), *symbols]

    # wires

    def wires(self) -> Iterator[Stroke]:
        """Give every wire: plain runs, what leads to symbols, vertical wires, and what leads from band to band."""
        for run in self.plan.runs:
            yield from self.run(run)
        for piece in self.plan.pieces:
            yield from self.ends(piece)
        for pin in self.plan.pins:
            number = len(self.cut) - 1
            start = self.x(self.cut[number], self.plan.columns - 1, pin.source, opens=True)
            yield self.wire(start, self.frame.right - self.frame.last / 2, self.y(number, pin.row), pin.source)
        for post in self.posts():
            yield from self.upright(post)
        yield from self.links()

    def run(self, run: Run) -> Iterator[Stroke]:
        """Give a plain wire, in as many pieces as there are bands that it goes through."""
        for number, band in enumerate(self.cut):
            start, stop = max(run.start, band.start), min(run.stop, band.stop)
            if start < stop:
                left, right = self.x(band, start, run.net, opens=True), self.x(band, stop, run.net, opens=False)
                yield self.wire(left, right, self.y(number, run.row), run.net)

    def ends(self, piece: Placed) -> Iterator[Stroke]:
        """Give the wires on both sides of a symbol; what stands in the last column is reached from where the rung ends."""
        number = self.band_of(piece.column)
        band, middle, y = self.cut[number], self.middle(piece), self.y(self.band_of(piece.column), piece.row)
        reach = half(piece.symbol, self.look.style)
        start = self.x(band, piece.column, piece.source, opens=True)
        yield self.wire(start, middle - reach, y, piece.source)
        if piece.target is not None:
            yield self.wire(middle + reach, self.x(band, piece.column + 1, piece.target, opens=False), y, piece.target)
        elif isinstance(piece.symbol, Coil):
            yield self.wire(middle + reach, self.frame.right, y, piece.source)

    def upright(self, post: Post) -> Iterator[Stroke]:
        """Give a vertical wire, and the short one that joins it to its twin."""
        number = self.band_of(post.boundary if post.opens else post.boundary - 1)
        band, ink, part = self.cut[number], self.ink_of_joint(post), self.joint(post)
        x, top = self.x(band, post.boundary, post.net, opens=post.opens), self.y(number, post.rows[0])
        yield Stroke(((x, top), (x, self.y(number, post.rows[-1]))), ink, part=part)
        if post.opens and (post.boundary, post.net) in self.plan.doubled:
            start = x - (1 if post.boundary == band.start > 0 else 2) * _BESIDE
            yield Stroke(((start, top), (x, top)), ink, part=part)

    def ink_of_joint(self, post: Post) -> str:
        """Give the ink of a vertical wire: pale until something has joined its paths."""
        return "unbuilt" if (post.net, post.opens) in self.look.loose else self.ink_of(post.net)

    def joint(self, post: Post) -> str:
        """Give the name of the part that is a vertical wire."""
        return f"j{self.number}-{post.net}-{int(post.opens)}"

    def links(self) -> Iterator[Stroke]:
        """Lead each band's wire out with an arrow at the right, and with one into the next band, off the left rail."""
        for number, band in enumerate(self.cut[:-1]):
            net = self.crossing(band.stop)
            start, begin = self.x(band, band.stop, net, opens=False), self.frame.left + 6
            for x, y in ((start, self.y(number, 0)), (begin, self.y(number + 1, 0))):
                yield Stroke(((x, y), (x + _INSET - 6, y)), self.ink_of(net), arrow=True, part=self.net(net))

    def crossing(self, boundary: int) -> int:
        """Give the net that goes on at a cut."""
        return next(piece.source for piece in self.plan.pieces if piece.column == boundary)

    def posts(self) -> Iterator[Post]:
        """Give the vertical wires that are not the left rail itself."""
        return (post for post in self.plan.posts if (post.boundary, post.net) != (0, RAIL))

    def wire(self, start: float, stop: float, y: float, net: int | None) -> Stroke:
        """Give a level wire of a net."""
        return Stroke(((start, y), (stop, y)), self.ink_of(net), part=self.net(net))

    def ink_of(self, net: int | None) -> str:
        """Give the ink of a net: not built or not joined yet, alive, or plain."""
        if (net, False) in self.look.loose:
            return "unbuilt"
        if net in self.live:
            return "wire-on"
        feeds = [number for piece, number in self.pieces.items() if piece.target == net]
        return "unbuilt" if feeds and self.look.unbuilt.issuperset(feeds) else "wire"

    def net(self, net: int | None) -> str:
        """Give the name of the part that is a net's wires."""
        return f"n{self.number}-{net}"

    def dots(self) -> Iterator[Disc]:
        """Give a dot wherever at least three wires meet."""
        filled = {(piece.row, piece.column) for piece in self.plan.pieces}
        filled |= {(run.row, column) for run in self.plan.runs for column in range(run.start, run.stop)}
        for post in self.posts():
            number = self.band_of(post.boundary if post.opens else post.boundary - 1)
            x = self.x(self.cut[number], post.boundary, post.net, opens=post.opens)
            for row in post.rows:
                if self.joins(post, row, filled):
                    ink = "dot-off" if self.ink_of_joint(post) == "unbuilt" else "dot"
                    yield Disc(x, self.y(number, row), 2.6, ink, part=self.joint(post))

    def joins(self, post: Post, row: int, filled: set[tuple[int, int]]) -> bool:
        """Say whether at least three wires meet, so that a dot must tell a joint from a corner."""
        left, right = (row, post.boundary - 1) in filled, (row, post.boundary) in filled
        if (post.boundary, post.net) in self.plan.doubled:
            first = row == post.rows[0]
            left, right = (first, right) if post.opens else (left, first)
        return left + right + (row > post.rows[0]) + (row < post.rows[-1]) > 2  # noqa: PLR2004

    # symbols

    def symbol(self, piece: Placed) -> Iterable[Shape]:
        """Draw a symbol in the ink of its state, as one part of the picture."""
        symbol, x, number = piece.symbol, self.middle(piece), self.pieces[piece]
        band = self.band_of(piece.column)
        ink = self.state(piece, number)
        if isinstance(symbol, Block):
            inputs = [
                (symbol.entry, self.y(band, piece.row)),
                *((pin.name, self.y(band, pin.row)) for pin in self.pins(symbol)),
            ]
            shapes = box_shapes(symbol, x, inputs, ink)
        else:
            shapes = symbol_shapes(symbol, x, self.y(band, piece.row), ink, self.look.style)
        part = f"s{self.number}-{number}"
        if self.look.live and not isinstance(symbol, Block):
            shapes = chain([self.area(piece)], shapes)
        return (_part_of(shape, part, faint=ink == "unbuilt") for shape in shapes)

    def area(self, piece: Placed) -> Box:
        """Give the area that counts as a sign when it is pointed at."""
        top = self.y(self.band_of(piece.column), piece.row) - LABEL - 9
        half_width = max(half(piece.symbol, self.look.style) + 8, 26.0)
        return Box(self.middle(piece) - half_width, top, 2 * half_width, LABEL + 24, "area")

    def pins(self, box: Block) -> Iterator[Pin]:
        """Give the further inputs of a box."""
        return iter(self.plan.pins if box.pins else ())

    def state(self, piece: Placed, number: int) -> str:
        """Give the ink of a symbol: not built yet, alive, or plain."""
        if number in self.look.unbuilt:
            return "unbuilt"
        if self.look.conducts is None:
            return "contact"
        on = passes(piece, number, self.live, self.look.conducts)
        turned = isinstance(piece.symbol, Coil) and piece.symbol.kind == "not"
        return "wire-on" if on != turned else "contact"

    def brackets(self) -> Iterator[Shape]:
        """Draw a bracket around each group of symbols, once for each band that it stands in, and number the groups."""
        for number, group in enumerate(self.look.brackets, 1):
            mine = [piece for piece, at in self.pieces.items() if at in group]
            for band in sorted({self.band_of(piece.column) for piece in mine}):
                here = [piece for piece in mine if self.band_of(piece.column) == band]
                xs = [self.middle(piece) for piece in here]
                ys = [self.y(band, piece.row) for piece in here]
                reach = self.frame.cell / 2 - 5 + number
                left, top = min(xs) - reach, min(ys) - LABEL - 11
                yield Box(left, top, max(xs) + reach - left, max(ys) + 17 - top, "bracket", 6)
                yield Words(left + 9, top + 8, same(str(number)), "accent", "middle", 11, bold=True)


def _part_of(shape: Shape, part: str, *, faint: bool) -> Shape:
    """Name the part that a shape belongs to; the words of what is not built yet are quiet."""
    ink = "quiet" if faint and isinstance(shape, Words) else shape.ink
    return replace(shape, part=part, ink=ink)
