"""The meaning of the signs in a ladder, written below it in both languages: each kind that occurs, once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.ladder import Box as Block
from plcteach.core.ladder import Coil, Compared, Contact, Edge, Invert
from plcteach.core.text import Text
from plcteach.figure.scene import Box, Stroke, Words, extent_of
from plcteach.figure.symbol import symbol_shapes

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.core.ladder import Rung, Symbol
    from plcteach.figure.scene import Shape
    from plcteach.figure.symbol import Style

_SIGN, _ROW = 58.0, 34.0

_KINDS: tuple[tuple[Symbol, Text], ...] = (
    (Contact("-"), Text("常开触点", "normally open contact")),
    (Contact("-", negated=True), Text("常闭触点", "normally closed contact")),
    (Contact("-", edge="rise"), Text("上升沿触点", "contact for a rising edge")),
    (Contact("-", edge="fall"), Text("下降沿触点", "contact for a falling edge")),
    (Contact("-", immediate=True), Text("立即触点", "immediate contact")),
    (Contact("-", negated=True, immediate=True), Text("立即常闭触点", "immediate normally closed contact")),
    (Compared("", "=", ""), Text("比较触点", "comparing contact")),
    (Invert(), Text("取反", "NOT")),
    (Edge(rising=True), Text("能流的上升沿", "rising edge of the flow")),
    (Edge(rising=False), Text("能流的下降沿", "falling edge of the flow")),
    (Coil("-"), Text("线圈", "coil")),
    (Coil("-", "set"), Text("置位线圈", "set coil")),
    (Coil("-", "reset"), Text("复位线圈", "reset coil")),
    (Coil("-", "not"), Text("反相线圈", "inverted coil")),
    (Coil("-", "rise"), Text("上升沿脉冲线圈", "coil for one scan at a rising edge")),
    (Coil("-", "fall"), Text("下降沿脉冲线圈", "coil for one scan at a falling edge")),
    (Coil("-", immediate=True), Text("立即线圈", "immediate coil")),
    (Coil("-", "set", immediate=True), Text("立即置位线圈", "immediate set coil")),
    (Coil("-", "reset", immediate=True), Text("立即复位线圈", "immediate reset coil")),
    (Block("-"), Text("功能框", "box")),
)


def legend(rungs: Sequence[Rung], style: Style, left: float, top: float, right: float) -> tuple[list[Shape], float]:
    """Draw the signs that occur, each with its name, in as many rows as they need; gives the shapes and where they end."""
    used = {_kind(symbol) for rung in rungs for symbol in rung.symbols}
    shapes: list[Shape] = []
    x, y = left, top + _ROW / 2
    for symbol, words in _KINDS:
        if _kind(symbol) not in used:
            continue
        width = _SIGN + extent_of(words, 12) + 14
        if x > left and x + width > right:
            x, y = left, y + _ROW
        shapes += _sign(symbol, x + _SIGN / 2, y, style)
        shapes.append(Words(x + _SIGN, y, words, "quiet", "start", 12))
        x += width
    return shapes, y + _ROW / 2


def _kind(symbol: Symbol) -> str:
    """Give the word by which a kind of sign is told from another."""
    match symbol:
        case Contact():
            return f"contact {symbol.mark}"
        case Coil():
            return f"coil {symbol.mark}"
        case Edge(rising):
            return f"edge {rising}"
    return type(symbol).__name__


def _sign(symbol: Symbol, x: float, y: float, style: Style) -> list[Shape]:
    """Draw a small sign without a name, on a piece of wire."""
    if isinstance(symbol, Block):
        return [Box(x - 15, y - 9, 30, 18, "block", 2), Stroke(((x - 26, y), (x - 15, y)), "wire")]
    shapes = [shape for shape in symbol_shapes(symbol, x, y, "contact", style) if not _is_name(shape, y)]
    reach = {"Contact": 6.0, "Coil": 11.0, "Invert": 0.0 if style == "relay" else 17.0}.get(type(symbol).__name__, 17.0)
    reach = 17.0 if isinstance(symbol, Contact) and symbol.immediate else reach
    wires: list[Shape] = [Stroke(((x - 26, y), (x - reach, y)), "wire"), Stroke(((x + reach, y), (x + 26, y)), "wire")]
    return wires + shapes


def _is_name(shape: Shape, y: float) -> bool:
    return isinstance(shape, Words) and abs(shape.y - y) > 1
