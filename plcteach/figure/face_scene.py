"""The still figure of a function block: a box with its pins, and inside it what its kind has to show."""

from __future__ import annotations

from itertools import zip_longest
from typing import TYPE_CHECKING, Literal

from plcteach.core.text import Text, same
from plcteach.figure.face_parts import insides, moved
from plcteach.figure.panel import MARGIN, ROW
from plcteach.figure.scene import Box, Scene, Stroke, Words, extent, extent_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.figure.face import Face, Pin
    from plcteach.figure.scene import Shape

Anchor = Literal["start", "end"]
_HEAD = 34
_PAD = 14
_WIRE = 26
_NOTE_ROW = 18
_NARROWEST = 150.0
_INKS = {"1": ("wire-on", "accent"), "0": ("wire", "text"), "x": ("dashed", "lost"), "": ("slot", "quiet")}


def face_scene(face: Face) -> Scene:
    """Draw a block as it stands: inputs on the left, outputs on the right, its address and its kind on top."""
    inputs = [pin for pin in face.inputs if not is_word(face, pin)]
    outputs = [pin for pin in face.outputs if not is_word(face, pin)]
    part = insides(face)
    left, right = MARGIN + _room(inputs), _room(outputs)
    names = [max((extent(pin.name, 13, code=True) + 8 for pin in pins), default=0.0) for pins in (inputs, outputs)]
    inner = max(part.width, _head_width(face) - sum(names) - 2 * _PAD, _NARROWEST - sum(names) - 2 * _PAD)
    width = inner + sum(names) + 2 * _PAD
    body = max(part.height + 2 * _PAD, ROW * max(len(inputs), len(outputs)) + _PAD)
    top = float(MARGIN)
    shapes = [*_frame(face, left, top, width, body)]
    shapes += _pins(inputs, left, top + _HEAD, outward=-1)
    shapes += _pins(outputs, left + width, top + _HEAD, outward=1)
    shapes += moved(part, left + _PAD + names[0] + (inner - part.width) / 2, top + _HEAD + _PAD)
    bottom = top + _HEAD + body
    notes = folded(face.note, max(width, 220), 12)
    shapes += [
        Words(left, bottom + 18 + _NOTE_ROW * row, words, "quiet", "start", 12) for row, words in enumerate(notes)
    ]
    wide = max([width + right, *(extent_of(words, 12) for words in notes)])
    high = bottom + (_NOTE_ROW * len(notes) + 8 if notes else 0) + MARGIN
    return Scene(round(left + wide + MARGIN), round(high), tuple(shapes), face.words)


def is_word(face: Face, pin: Pin) -> bool:
    """Tell whether a pin is one of a queue's two words, which stand beside the pile and not at the box."""
    return face.kind == "queue" and pin.name.startswith(".")


def _head_width(face: Face) -> float:
    return extent(face.address, 15, code=True) + 12 + extent_of(face.title, 13) + 2 * _PAD


def _room(pins: list[Pin]) -> float:
    """Give the room that wires and values need beside the box."""
    return max((_WIRE + 6 + max(10.0, extent(pin.value, 13, code=True)) for pin in pins), default=0.0)


def _frame(face: Face, x: float, y: float, width: float, body: float) -> Iterator[Shape]:
    yield Box(x, y, width, _HEAD + body, "cell", 4)
    yield Box(x + 0.5, y + 0.5, width - 1, _HEAD - 0.5, "head", 3.5)
    yield Stroke(((x, y + _HEAD), (x + width, y + _HEAD)), "line")
    yield Words(x + _PAD, y + _HEAD / 2, same(face.address), "text", "start", 15, code=True, bold=True)
    yield Words(x + width - _PAD, y + _HEAD / 2, face.title, "quiet", "end", 13)


def _pins(pins: list[Pin], edge: float, y: float, *, outward: int) -> Iterator[Shape]:
    """Draw pins along one edge: the name inside, the wire and its value outside."""
    for number, pin in enumerate(pins):
        middle = y + _PAD / 2 + ROW * (number + 0.5)
        wire, words = _INKS.get(pin.value, ("wire", "text"))
        inner: Anchor = "start" if outward < 0 else "end"
        yield Words(edge - outward * 8, middle, same(pin.name), "text", inner, 13, code=True)
        yield Stroke(((edge, middle), (edge + outward * _WIRE, middle)), wire)
        value, place = same(pin.value), (edge + outward * (_WIRE + 5), middle)
        anchor: Anchor = "end" if outward < 0 else "start"
        yield Words(*place, value, words, anchor, 13, code=True, bold=pin.value == "1")


def folded(text: Text, width: float, size: float) -> list[Text]:
    """Break a sentence into lines that fit, each language at its own places."""
    pairs = zip_longest(_fold(text.zh, width, size), _fold(text.en, width, size), fillvalue="")
    return [Text(zh, en) for zh, en in pairs]


def _fold(words: str, width: float, size: float) -> list[str]:
    pieces = words.replace(" ", " \0").split("\0") if words.isascii() or " " in words else list(words)
    lines: list[str] = []
    for piece in pieces:
        if lines and extent(lines[-1] + piece.rstrip(), size) <= width:
            lines[-1] += piece
        else:
            lines.append(piece)
    return [line.rstrip() for line in lines if line.strip()]
