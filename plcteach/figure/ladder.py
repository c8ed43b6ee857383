"""A ladder as textbooks draw it: two rails, contacts on wires, coils at the right, addresses above; knows no instruction.

Where values are given, the wires that carry power are drawn in another ink. What conducts is worked out along the plan of the
rung, net after net, so that the picture shows the flow itself and not what an instruction list made of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from plcteach.core.ladder import Coil, Contact, Invert, Ladder, Rung
from plcteach.core.text import Text, same
from plcteach.figure.scene import Disc, Scene, Stroke, Words, extent
from plcteach.ladder.layout import RAIL, Layout, Placed, Post, layout
from plcteach.ladder.oneline import write_line

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from plcteach.figure.scene import Shape

Style = Literal["relay", "iec"]
"""relay: round coils, arrows for edges, a stroke for NOT.  iec: coils in parentheses, the letters P, N and NOT."""

_LEFT, _TOP, _MARGIN = 44.0, 22.0, 18.0
_CELL, _ROW, _TITLE, _APART = 88.0, 58.0, 30.0, 16.0
_LABEL = 23.0
_SIZE = 13.0
_GAP, _BAR = 6.0, 10.5
_COIL, _OPEN = 11.0, 76.0
_BESIDE = 9.0
"""So far from its boundary stands each of two posts that are drawn apart."""
_SAID = 400


def ladder_scene(
    ladder: Ladder | Rung, *, style: Style = "relay", powered: Mapping[str, object] | None = None
) -> Scene:
    """Draw a ladder; `powered` gives the values of bits (0 or 1) by address, and lights the wires that carry power then.

    A bit that `powered` does not name counts as 0; for an edge contact the key is its mark and address, "P I0.0".
    """
    rungs = ladder.rungs if isinstance(ladder, Ladder) else (ladder,)
    title = ladder.title if isinstance(ladder, Ladder) else ""
    plans = [layout(rung) for rung in rungs]
    frame = _frame(plans)
    shapes: list[Shape] = []
    top = _TOP
    if title:
        shapes.append(Words(frame.left, top, same(title), "text", "start", 15, bold=True))
        top += _TITLE
    first = top
    for number, (rung, plan) in enumerate(zip(rungs, plans, strict=True), 1):
        picture = _Picture(plan, frame, style, powered, top + (_TITLE if rung.title else 0))
        shapes += _heading(rung, number, frame, top, several=len(rungs) > 1)
        shapes += picture.shapes()
        top = picture.bottom + _APART
    bottom = top - _APART
    rails = [Stroke(((x, first), (x, bottom)), "rail") for x in (frame.left, frame.right)]
    return Scene(round(frame.right + _MARGIN), round(bottom + _MARGIN), (*rails, *shapes), _said(ladder, rungs))


def _said(ladder: Ladder | Rung, rungs: tuple[Rung, ...]) -> Text:
    words = "; ".join(map(write_line, rungs))
    words = words if len(words) <= _SAID else f"{words[:_SAID]}…"
    name = f" {ladder.title}" if ladder.title else ""
    return Text(f"梯形图{name}：{words}", f"Ladder diagram{name}: {words}")


def _heading(rung: Rung, number: int, frame: _Frame, top: float, *, several: bool) -> Iterator[Shape]:
    y = top + _TITLE + _LABEL + 11 if rung.title else top + _LABEL + 11
    if several:
        yield Words(frame.left - 12, y, same(str(number)), "quiet", "end", 12)
    if rung.title:
        yield Words(frame.left + 12, top + _TITLE / 2 + 4, same(rung.title), "text", "start", 13, bold=True)


@dataclass(frozen=True, slots=True)
class _Frame:
    """What all rungs of a ladder share: the rails, the width of a cell and the column of the coils."""

    left: float
    cell: float
    columns: int

    @property
    def right(self) -> float:
        return self.left + self.cell * self.columns

    def x(self, boundary: int) -> float:
        return self.left + self.cell * boundary


def _frame(plans: list[Layout]) -> _Frame:
    names = [piece.symbol.address for plan in plans for piece in plan.pieces if not isinstance(piece.symbol, Invert)]
    widest = max((extent(name, _SIZE, code=True) for name in names), default=0)
    columns = max((plan.columns for plan in plans), default=2)
    beside = 2 * _BESIDE if any(plan.doubled for plan in plans) else 0
    return _Frame(_LEFT, max(_CELL, round(widest + 18 + beside)), columns)


def _is_on(value: object) -> bool:
    """Say whether a value is 1, given as a number, a truth value or a signal that writes itself so."""
    return value is True or repr(value) in {"1", "'1'"}


@dataclass(slots=True)
class _Picture:
    """One rung on its way to shapes."""

    plan: Layout
    frame: _Frame
    style: Style
    powered: Mapping[str, object] | None
    top: float

    @property
    def bottom(self) -> float:
        return self.y(self.plan.rows - 1) + _ROW - _LABEL - 11

    def y(self, row: int) -> float:
        return self.top + _LABEL + 11 + _ROW * row

    def x(self, boundary: int, net: int | None, *, opens: bool) -> float:
        """Give where a wire of a net begins (opens) or ends at a boundary: aside, where two posts are drawn apart."""
        aside = _BESIDE if (boundary, net) in self.plan.doubled else 0
        return self.frame.x(boundary) + (aside if opens else -aside)

    def middle(self, piece: Placed) -> float:
        if isinstance(piece.symbol, Coil):
            return self.frame.right - self.frame.cell / 2
        return self.frame.x(piece.column) + self.frame.cell / 2

    def shapes(self) -> list[Shape]:
        """Give wires that are off, then wires that are on, then dots, symbols and words, each over the last."""
        nets = self.nets()
        wires = sorted(self.wires(nets), key=lambda wire: wire.ink == "wire-on")
        symbols = [shape for piece in self.plan.pieces for shape in self.symbol(piece, nets)]
        return [*wires, *self.dots(), *symbols]

    def nets(self) -> frozenset[int]:
        """Give the nets that carry power: the rail, and what a conducting symbol reaches, in the order of execution."""
        if self.powered is None:
            return frozenset()
        live = {RAIL}
        for piece in self.plan.pieces:
            if piece.target is not None and self.conducts(piece, frozenset(live)):
                live.add(piece.target)
        return frozenset(live)

    def conducts(self, piece: Placed, live: frozenset[int]) -> bool:
        """Say whether power leaves a symbol on its right."""
        fed, symbol = piece.source in live, piece.symbol
        if self.powered is None:
            return False
        if isinstance(symbol, Coil):
            return fed
        if isinstance(symbol, Invert):
            return not fed
        key = f"{symbol.mark}{symbol.address}" if symbol.edge else symbol.address
        return fed and _is_on(self.powered.get(key, 0)) != symbol.negated

    def wires(self, nets: frozenset[int]) -> Iterator[Stroke]:
        for run in self.plan.runs:
            start, stop = self.x(run.start, run.net, opens=True), self.x(run.stop, run.net, opens=False)
            yield self.wire(start, stop, run.row, run.net, nets)
        for piece in self.plan.pieces:
            yield from self.ends(piece, nets)
        for post in self.posts():
            x, ink = self.x(post.boundary, post.net, opens=post.opens), "wire-on" if post.net in nets else "wire"
            yield Stroke(((x, self.y(post.rows[0])), (x, self.y(post.rows[-1]))), ink)
            if post.opens and (post.boundary, post.net) in self.plan.doubled:
                yield self.wire(x - 2 * _BESIDE, x, post.rows[0], post.net, nets)

    def posts(self) -> Iterator[Post]:
        """Give the vertical wires that are not the left rail itself."""
        return (post for post in self.plan.posts if (post.boundary, post.net) != (0, RAIL))

    def wire(self, start: float, stop: float, row: int, net: int | None, nets: frozenset[int]) -> Stroke:
        return Stroke(((start, self.y(row)), (stop, self.y(row))), "wire-on" if net in nets else "wire")

    def ends(self, piece: Placed, nets: frozenset[int]) -> Iterator[Stroke]:
        """Give the wires on both sides of a symbol; the one before a coil comes from as far left as the rung ends."""
        middle, coil = self.middle(piece), isinstance(piece.symbol, Coil)
        half = _COIL if coil else self.half(piece.symbol)
        start = self.x(piece.column, piece.source, opens=True)
        stop = self.frame.right if coil else self.x(piece.column + 1, piece.target, opens=False)
        yield self.wire(start, middle - half, piece.row, piece.source, nets)
        yield self.wire(middle + half, stop, piece.row, piece.source if coil else piece.target, nets)

    def half(self, symbol: Contact | Invert | Coil) -> float:
        if not isinstance(symbol, Invert):
            return _GAP
        return 0 if self.style == "relay" else 17

    def dots(self) -> Iterator[Disc]:
        filled = {(piece.row, piece.column) for piece in self.plan.pieces}
        filled |= {(run.row, column) for run in self.plan.runs for column in range(run.start, run.stop)}
        for post in self.posts():
            x = self.x(post.boundary, post.net, opens=post.opens)
            yield from (Disc(x, self.y(row), 2.6, "dot") for row in post.rows if self.joins(post, row, filled))

    def joins(self, post: Post, row: int, filled: set[tuple[int, int]]) -> bool:
        """Say whether at least three wires meet, so that a dot must tell a joint from a corner."""
        left, right = (row, post.boundary - 1) in filled, (row, post.boundary) in filled
        if (post.boundary, post.net) in self.plan.doubled:
            first = row == post.rows[0]
            left, right = (first, right) if post.opens else (left, first)
        return left + right + (row > post.rows[0]) + (row < post.rows[-1]) > 2  # noqa: PLR2004

    def symbol(self, piece: Placed, nets: frozenset[int]) -> Iterator[Shape]:
        x, y, symbol = self.middle(piece), self.y(piece.row), piece.symbol
        on = self.conducts(piece, nets) != (
            self.powered is not None and isinstance(symbol, Coil) and symbol.kind == "not"
        )
        ink = "wire-on" if on else "contact"
        match symbol:
            case Contact():
                yield from self.contact(symbol, x, y, ink)
            case Invert():
                yield from self.invert(x, y, ink)
            case Coil():
                yield from self.coil(symbol, x, y, ink)
        if not isinstance(symbol, Invert):
            yield Words(x, y - _LABEL, same(symbol.address), "text", "middle", _SIZE, code=True)

    def contact(self, contact: Contact, x: float, y: float, ink: str) -> Iterator[Shape]:
        for side in (x - _GAP, x + _GAP):
            yield Stroke(((side, y - _BAR), (side, y + _BAR)), ink)
        if contact.negated:
            reach = (_GAP + 3, _BAR) if self.style == "relay" else (_GAP - 1, _BAR - 2)
            yield Stroke(((x - reach[0], y + reach[1]), (x + reach[0], y - reach[1])), ink)
        elif contact.edge and self.style == "relay":
            up = -1 if contact.edge == "rise" else 1
            yield Stroke(((x, y - 8 * up), (x, y + 8 * up)), ink, arrow=True)
        elif contact.edge:
            yield Words(x, y, same(contact.mark.strip()), "text", "middle", 11, code=True)

    def invert(self, x: float, y: float, ink: str) -> Iterator[Shape]:
        if self.style == "relay":
            yield Stroke(((x - 6, y + _BAR), (x + 6, y - _BAR)), ink)
            return
        for side in (x - 17, x + 17):
            yield Stroke(((side, y - _BAR), (side, y + _BAR)), ink)
        yield Words(x, y, same("NOT"), "text", "middle", 11, code=True)

    def coil(self, coil: Coil, x: float, y: float, ink: str) -> Iterator[Shape]:
        yield Disc(x, y, _COIL, ink, open=_OPEN if self.style == "iec" else 0)
        if coil.kind == "not":
            yield Stroke(((x - 5, y + 7), (x + 5, y - 7)), ink)
        elif coil.kind:
            yield Words(x, y, same(coil.mark.strip()), "text", "middle", 12, code=True)
        if coil.count > 1:
            yield Words(x + _COIL + 4, y + 11, same(str(coil.count)), "quiet", "start", 11, code=True)
