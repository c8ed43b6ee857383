"""How each sign of a ladder is drawn at a place: contacts, comparisons, NOT, edges, coils and boxes, in two styles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from plcteach.core.ladder import Box as Block
from plcteach.core.ladder import Coil, Compared, Contact, Edge, Invert
from plcteach.core.text import same
from plcteach.figure.scene import Box, Disc, Stroke, Words, extent

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.ladder import Symbol
    from plcteach.figure.scene import Shape

Style = Literal["relay", "iec"]
"""relay: round coils, arrows for edges, a stroke for NOT.  iec: coils in parentheses, the letters P, N and NOT."""

LABEL = 23.0
"""So far above its wire stands the name of a symbol."""
SIZE = 13.0
_SMALL = 11.0
_GAP, _BAR = 6.0, 10.5
_WIDE = 17.0
_RADIUS, _OPEN = 11.0, 76.0
_PAD = 10.0
_LINE = 15.0


def half(symbol: Symbol, style: Style) -> float:
    """Give how far a symbol reaches to either side of its middle."""
    match symbol:
        case Coil():
            return _RADIUS
        case Block():
            return box_width(symbol) / 2
        case Compared():
            return _compared_half(symbol)
        case Invert() | Edge() if style == "iec" or isinstance(symbol, Edge):
            return _WIDE
        case Invert():
            return 0
    return _WIDE if isinstance(symbol, Contact) and symbol.immediate else _GAP


def cell_width(symbol: Symbol) -> float:
    """Give the width of the cell that a symbol needs with the name above it."""
    match symbol:
        case Contact() | Coil():
            return extent(symbol.address, SIZE, code=True) + 18
        case Compared(left, _, right):
            names = max(extent(word, SIZE, code=True) for word in (left, right))
            return max(names, 2 * _compared_half(symbol)) + 18
        case Block():
            return box_width(symbol) + 26
    return 0


def box_width(box: Block) -> float:
    """Give how wide a box must be for its words, and for the names of its inputs."""
    pins = max((extent(name, _SMALL, code=True) for name in (box.entry, *(name for name, _ in box.pins))), default=0)
    return max(54.0, *(extent(row, SIZE, code=True) + 2 * _PAD + 2 * (pins + 4 if pins else 0) for row in _rows(box)))


def box_reach(box: Block) -> float:
    """Give how far a box reaches below the wire of its first input, its further inputs apart."""
    return _LINE * (len(_rows(box)) - 1) + 10


def _rows(box: Block) -> list[str]:
    """Give the words of a box in rows: the instruction, then its operands."""
    operands = [one.strip() for one in box.operands.replace(" ", ",").split(",") if one.strip()]
    if any(sign in box.text for sign in "[:"):
        return [box.text]
    return [box.word, *operands]


def _compared_half(compared: Compared) -> float:
    return max(_WIDE, extent(_relation(compared), _SMALL, code=True) / 2 + 6)


def _relation(compared: Compared) -> str:
    return f"{compared.relation}{compared.size}"


def symbol_shapes(symbol: Symbol, x: float, y: float, ink: str, style: Style) -> Iterator[Shape]:
    """Draw a symbol with its middle at a place on its wire, and its name above it; a box is `box_shapes`."""
    match symbol:
        case Contact():
            yield from _contact(symbol, x, y, ink, style)
            yield _name(symbol.address, x, y)
        case Compared():
            yield from _bars(x, y, ink, _compared_half(symbol))
            yield Words(x, y, same(_relation(symbol)), "text", "middle", _SMALL, code=True)
            yield _name(symbol.left, x, y)
            yield Words(x, y + LABEL, same(symbol.right), "text", "middle", SIZE, code=True)
        case Invert():
            yield from _invert(x, y, ink, style)
        case Edge():
            yield from _bars(x, y, ink, _WIDE)
            yield from _turn(x, y, ink, style, rising=symbol.rising)
            if symbol.memory:
                yield _name(symbol.memory, x, y)
        case Coil():
            yield from _coil(symbol, x, y, ink, style)
            yield _name(symbol.address, x, y)


def _name(words: str, x: float, y: float) -> Words:
    return Words(x, y - LABEL, same(words), "text", "middle", SIZE, code=True)


def _bars(x: float, y: float, ink: str, reach: float) -> Iterator[Shape]:
    for side in (x - reach, x + reach):
        yield Stroke(((side, y - _BAR), (side, y + _BAR)), ink)


def _contact(contact: Contact, x: float, y: float, ink: str, style: Style) -> Iterator[Shape]:
    yield from _bars(x, y, ink, _WIDE if contact.immediate else _GAP)
    if contact.immediate:
        yield Words(x, y, same(contact.mark.strip()), "text", "middle", _SMALL, code=True)
    elif contact.negated:
        reach = (_GAP + 3, _BAR) if style == "relay" else (_GAP - 1, _BAR - 2)
        yield Stroke(((x - reach[0], y + reach[1]), (x + reach[0], y - reach[1])), ink)
    elif contact.edge:
        yield from _turn(x, y, ink, style, rising=contact.edge == "rise")


def _turn(x: float, y: float, ink: str, style: Style, *, rising: bool) -> Iterator[Shape]:
    """Draw the sign of an edge: an arrow up or down, or the letter P or N."""
    if style == "relay":
        up = -1 if rising else 1
        yield Stroke(((x, y - 8 * up), (x, y + 8 * up)), ink, arrow=True)
    else:
        yield Words(x, y, same("P" if rising else "N"), "text", "middle", _SMALL, code=True)


def _invert(x: float, y: float, ink: str, style: Style) -> Iterator[Shape]:
    if style == "relay":
        yield Stroke(((x - 6, y + _BAR), (x + 6, y - _BAR)), ink)
        return
    yield from _bars(x, y, ink, _WIDE)
    yield Words(x, y, same("NOT"), "text", "middle", _SMALL, code=True)


def _coil(coil: Coil, x: float, y: float, ink: str, style: Style) -> Iterator[Shape]:
    yield Disc(x, y, _RADIUS, ink, open=_OPEN if style == "iec" else 0)
    if coil.kind == "not":
        yield Stroke(((x - 5, y + 7), (x + 5, y - 7)), ink)
    elif coil.mark:
        yield Words(x, y, same(coil.mark.strip()), "text", "middle", 12 if len(coil.mark) <= 2 else 10, code=True)  # noqa: PLR2004
    if coil.count > 1:
        yield Words(x + _RADIUS + 4, y + 11, same(str(coil.count)), "quiet", "start", _SMALL, code=True)


_BOX_INKS = {"wire-on": "block-on", "unbuilt": "block-off"}


def box_shapes(box: Block, x: float, inputs: list[tuple[str, float]], ink: str) -> Iterator[Shape]:
    """Draw a box around its middle x; `inputs`: the names of its inputs and the heights of their wires, first on top."""
    width, (_, top) = box_width(box), inputs[0]
    bottom = max(inputs[-1][1] + 14, top + box_reach(box))
    yield Box(x - width / 2, top - 18, width, bottom - top + 18, _BOX_INKS.get(ink, "block"), 2)
    for number, row in enumerate(_rows(box)):
        yield Words(x, top - 4 + _LINE * number, same(row), "text", "middle", SIZE, code=True, bold=not number)
    for name, y in inputs:
        if name:
            yield Words(x - width / 2 + 5, y, same(name), "quiet", "start", _SMALL, code=True)
