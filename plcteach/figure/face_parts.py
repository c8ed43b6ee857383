"""What stands inside a block's box: a gauge, a drum's grid, a row of bits or steps, a pile of words."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from plcteach.core.text import Text, joined, same
from plcteach.figure.face import GAP, window
from plcteach.figure.panel import ROW
from plcteach.figure.scale import round_step
from plcteach.figure.scene import Box, Disc, Stroke, Words, extent, extent_of

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from plcteach.figure.face import Face, Gauge, Grid, Slot
    from plcteach.figure.scene import Shape

CURRENT, PRESET = Text("当前值", "current"), Text("预设值", "preset")
STEP = Text("步", "step")
POINTER = Text("指针", "pointer")

_BAR, _BAR_LONG, _BAR_HIGH, _SCALE_PARTS = 200.0, 260.0, 16.0, 5
_BIT, _STEP, _IN_A_ROW, _ROW_APART = 25.0, 36.0, 16, 48.0
_WORD, _WORD_ROW, _SPARE_ROWS = 86.0, 22.0, 3
_BESIDE = 14.0


@dataclass(frozen=True, slots=True)
class Part:
    """Some shapes that belong together, drawn from the corner (0, 0), and the room that they take."""

    width: float
    height: float
    shapes: tuple[Shape, ...]


NO_PART = Part(0, 0, ())


def moved(part: Part, x: float, y: float) -> list[Shape]:
    """Give a part's shapes at another place."""
    shapes: list[Shape] = []
    for shape in part.shapes:
        if isinstance(shape, Stroke):
            shapes.append(replace(shape, points=tuple((at + x, down + y) for at, down in shape.points)))
        else:
            shapes.append(replace(shape, x=shape.x + x, y=shape.y + y))
    return shapes


def insides(face: Face) -> Part:
    """Give all that a face has to show inside its box, one below the other."""
    parts = [_gauge(face.gauge) if face.gauge else NO_PART, _grid(face.grid) if face.grid else NO_PART, _slots(face)]
    kept = [part for part in parts if part.shapes]
    width, y = max((part.width for part in kept), default=0.0), 0.0
    shapes: list[Shape] = []
    for part in kept:
        shapes += moved(part, (width - part.width) / 2, y)
        y += part.height + _BESIDE
    return Part(width, max(0.0, y - _BESIDE), tuple(shapes))


def _gauge(gauge: Gauge) -> Part:
    said = [
        joined((CURRENT, same("x" if gauge.value is None else str(gauge.value))), " "),
        joined((PRESET, same("x" if gauge.preset is None else str(gauge.preset))), " "),
    ]
    below = [gauge.unit, gauge.time]
    rows = [said, below] if below[0].en or below[1].en else [said]
    need = max(extent_of(row[0], 12) + extent_of(row[1], 12) + 18 for row in rows)
    width = max(_BAR if gauge.least >= 0 else _BAR_LONG, need)
    shapes = [*_bar(gauge, width), *_ticks(gauge, width)]
    y = _BAR_HIGH + 38
    for row in rows:
        inks = ("text", "text") if row is said else ("quiet", "accent")
        shapes += [
            Words(0, y, row[0], inks[0], "start", 12),
            Words(width, y, row[1], inks[1], "end", 12),
        ]
        y += 19
    return Part(width, y - 13, tuple(shapes))


def _bar(gauge: Gauge, width: float) -> Iterator[Shape]:
    first, last = (part * width for part in gauge.bar)
    yield Box(0, 4, width, _BAR_HIGH, "cell", 2)
    if gauge.value is None:
        yield Box(0, 4, width, _BAR_HIGH, "head", 2)
        yield hatched(0, 4, width, _BAR_HIGH)
        yield Words(width / 2, 4 + _BAR_HIGH / 2, same("x"), "lost", size=12, code=True)
    elif last - first > 0:
        yield Box(first, 4, max(last - first, 1.5), _BAR_HIGH, "new", 2)
    if gauge.beyond:
        middle = 4 + _BAR_HIGH / 2
        yield Stroke(((width - 16, middle), (width - 4, middle)), "accent", arrow=True)


def _ticks(gauge: Gauge, width: float) -> Iterator[Shape]:
    """Draw the scale under a bar: round steps, zero, and the preset as a longer line with its number."""
    low = -gauge.end if gauge.least < 0 else 0
    step = round(max(1.0, round_step(gauge.end - low, _SCALE_PARTS * (2 if low else 1))))
    base = 4 + _BAR_HIGH
    for value in range(-(-low // step) * step, gauge.end + 1, step):
        yield Stroke(((gauge.part(value) * width, base), (gauge.part(value) * width, base + 4)), "faint")
    zero, mark = gauge.part(0) * width, gauge.mark
    yield Words(zero, base + 13, same("0"), "quiet", "start" if not low else "middle", 11, code=True)
    if mark is None:
        return
    x = mark * width
    yield Stroke(((x, 0), (x, base + 5)), "accent")
    words = str(gauge.preset)
    if abs(x - zero) > extent(words, 11, code=True) / 2 + 12:
        room = extent(words, 11, code=True) / 2
        yield Words(min(max(x, room), width - room), base + 13, same(words), "accent", size=11, code=True)


def hatched(x: float, y: float, width: float, height: float) -> Stroke:
    """Draw the one zigzag line that fills what nobody knows."""
    count = max(2, min(240, round(width / 7)))
    points = tuple((x + width * at / count, y + (height if at % 2 else 0)) for at in range(count + 1))
    return Stroke(points, "faint")


def _grid(grid: Grid) -> Part:
    label = extent_of(STEP, 11) + 14
    cell = max(26.0, *(extent(name, 11, code=True) + 9 for name in grid.columns), 0.0)
    width, row, top = label + cell * len(grid.columns), ROW - 2, 24
    shapes: list[Shape] = [Words(label - 8, 10, STEP, "quiet", "end", 11)]
    for place, name in enumerate(grid.columns):
        shapes.append(Words(label + cell * (place + 0.5), 10, same(name or "–"), "quiet", size=11, code=True))
    for number, bits in enumerate(grid.rows):
        y, active = top + row * number, number == grid.active
        shapes.append(
            Words(label - 8, y + row / 2, same(str(number)), "accent" if active else "quiet", "end", 12, bold=active)
        )
        shapes += [Box(label + cell * place, y, cell, row, "table") for place in range(len(grid.columns))]
        shapes += [_peg(label + cell * (place + 0.5), y + row / 2, bit, active) for place, bit in enumerate(bits)]
    if 0 <= grid.active < len(grid.rows):
        y = top + row * grid.active
        shapes.insert(0, Box(label, y, width - label, row, "wash"))
        shapes.append(Box(label, y, width - label, row, "outline", 2))
        shapes.append(Stroke(((0, y + row / 2), (8, y + row / 2)), "accent", arrow=True))
    return Part(width, top + row * len(grid.rows), tuple(shapes))


def _peg(x: float, y: float, bit: str, active: bool) -> Shape:  # noqa: FBT001
    if bit == "1":
        return Disc(x, y, 5.5, "peg" if active else "dot")
    return Words(x, y, same("·" if bit == "0" else bit), "quiet", size=13)


def _slots(face: Face) -> Part:
    if not face.slots:
        return NO_PART
    if face.kind == "queue":
        return _pile(face)
    if face.kind == "steps":
        return _steps(face, window(face))
    return _register(face)


def _cell(slot: Slot, x: float, y: float, width: float, height: float = ROW) -> Iterator[Shape]:
    """Draw one bit or word."""
    if slot.label == GAP:
        yield Words(x + width / 2, y + height / 2, same(GAP), "quiet", size=14)
        return
    hot = slot.mark in {"active", "new"} or (slot.mark == "pointer" and bool(slot.value))
    box = "gone" if slot.mark == "gone" else "new" if hot else "cell" if slot.value else "slot"
    ink = "lost" if slot.value == "x" else "accent" if hot else "quiet" if slot.mark == "gone" else "text"
    yield Box(x, y, width, height, box)
    yield Words(x + width / 2, y + height / 2, same(slot.value), ink, size=13, code=True, bold=hot or slot.value == "1")


def _steps(face: Face, slots: Sequence[Slot]) -> Part:
    """Draw the steps around the active one, the numbers going up to the right."""
    shapes: list[Shape] = []
    for place, slot in enumerate(slots):
        active = slot.mark == "active"
        if slot.label != GAP:
            number, x = same(slot.label), _STEP * (place + 0.5)
            shapes.append(Words(x, 8, number, "accent" if active else "quiet", size=11, bold=active))
    for place, slot in sorted(enumerate(slots), key=lambda one: one[1].mark == "active"):
        shapes += _cell(slot, _STEP * place, 18, _STEP)
    width = _STEP * len(slots)
    shapes += _ways(width, 18 + ROW + 14, _pin_called(face, "CD"), _pin_called(face, "CU"))
    return Part(width, 18 + ROW + 22, tuple(shapes))


def _pin_called(face: Face, name: str) -> str:
    return name if any(pin.name == name for pin in face.inputs) else ""


def _ways(width: float, y: float, left: str, right: str) -> Iterator[Shape]:
    """Draw under a row which pin moves it which way."""
    for name, start, sign in ((left, width / 2 - 16, -1), (right, width / 2 + 16, 1)):
        if name:
            room = extent(name, 11, code=True) / 2 + 6
            end = start + sign * min(96.0, width / 2 - 20)
            yield Words(start + sign * room, y, same(name), "quiet", size=11, code=True)
            yield Stroke(((start + sign * (2 * room), y), (end, y)), "line", arrow=True)


def _register(face: Face) -> Part:
    """Draw bits as a word is written, the highest on the left, with what enters and what is lost at the ends."""
    slots, bit = face.slots, max(_BIT, *(extent(slot.label, 10.5, code=True) + 5 for slot in face.slots))
    up, down = slots[-1].mark == "gone", slots[0].mark == "gone"
    bits = slots[down : len(slots) - up]
    lost = slots[-1] if up else slots[0] if down else None
    rows = [bits[first : first + _IN_A_ROW] for first in range(0, len(bits), _IN_A_ROW)][::-1]
    beside = max(_BIT, extent(_enters(face), 12, code=True)) + 30
    right, low = beside + bit * max(len(row) for row in rows), _ROW_APART * (len(rows) - 1)
    shapes: list[Shape] = []
    for number, row in enumerate(rows):
        shapes += _bit_row(row, right, _ROW_APART * number, bit)
    highest = (right - bit * len(rows[0]), 18.0)
    if up or (face.way == "left" and not down):
        shapes += _ends(face, lost, -1, highest, (right, low + 18))
    elif down or face.way == "right":
        shapes += _ends(face, lost, 1, (right, low + 18), highest)
    if face.way:
        return Part(right + beside, low + 18 + ROW, tuple(shapes))
    across = Part(0, 0, tuple(_ways(right - beside, 0, _pin_called(face, "CU"), _pin_called(face, "CD"))))
    shapes += moved(across, beside, low + 18 + ROW + 14)
    return Part(right + beside, low + 18 + ROW + 22, tuple(shapes))


def _enters(face: Face) -> str:
    """Say what comes in at the end: the bit of the pin DATA where there is one, else 0."""
    return _pin_called(face, "DATA") or "0"


def _bit_row(row: Sequence[Slot], right: float, y: float, bit: float) -> Iterator[Shape]:
    for hot in (False, True):
        for place, slot in enumerate(row):
            x = right - bit * (place + 1)
            if not hot:
                yield Words(x + bit / 2, y + 8, same(slot.label), "quiet", size=10.5)
            if hot == (slot.mark in {"new", "active"}):
                yield from _cell(slot, x, y + 18, bit)


def _ends(
    face: Face, lost: Slot | None, sign: int, out: tuple[float, float], into: tuple[float, float]
) -> Iterator[Shape]:
    """Draw the bit that leaves at one end and what enters at the other; sign: -1 to the left, 1 to the right."""
    (x, y), (start, low) = (out[0] + sign * 4, out[1]), (into[0] - sign * 4, into[1])
    yield Stroke(((x, y + ROW / 2), (x + sign * 18, y + ROW / 2)), "lost" if lost else "line", arrow=True)
    if lost:
        yield from _cell(lost, x + sign * 21 - (_BIT if sign < 0 else 0), y, _BIT)
    ink = "accent" if lost else "line"
    yield Stroke(((start - sign * 18, low + ROW / 2), (start, low + ROW / 2)), ink, arrow=True)
    words, place = same(_enters(face)), (start - sign * 22, low + ROW / 2)
    yield Words(*place, words, "accent" if lost else "quiet", "start" if sign < 0 else "end", 12, code=True)


def _pile(face: Face) -> Part:
    """Draw the words of a queue as a pile, newest on top; a long empty part is left out (figures 4-42 and 4-43)."""
    count = sum(bool(slot.value) and slot.mark != "gone" for slot in face.slots)
    words = {pin.name: pin.value for pin in (*face.inputs, *face.outputs) if pin.name.startswith(".")}
    chips = {name: _chip_width(name, value) for name, value in words.items()}
    left = max(chips.get(".I", 0.0) + 30, extent_of(POINTER, 12) + 34 if face.way == "lifo" else 0.0)
    ys, dots, height = _pile_rows(face.slots, count)
    shapes: list[Shape] = []
    for hot in (False, True):
        for place, y in ys.items():
            slot = face.slots[place]
            if hot == (slot.mark in {"new", "active", "pointer"} and bool(slot.value)):
                shapes += _cell(slot, left, y, _WORD, _WORD_ROW)
                shapes.append(Words(left + 6, y + _WORD_ROW / 2, same(slot.label), "quiet", "start", 10))
    if dots is not None:
        shapes.append(Words(left + _WORD / 2, dots, same("⋮"), "quiet", size=14))
    shapes += _pile_words(face, words, left, ys, count)
    right = 30 + chips.get(".O", 0.0) if ".O" in words else 0.0
    return Part(left + _WORD + right, height, tuple(shapes))


def _pile_rows(slots: Sequence[Slot], count: int) -> tuple[dict[int, float], float | None, float]:
    """Choose the places that are drawn: all that hold a word, the next free one, and the highest; with their heights."""
    gone = max((place + 1 for place, slot in enumerate(slots) if slot.value), default=0)
    shown = max(count + 1, gone, min(len(slots), _SPARE_ROWS))
    places = [*range(min(shown, len(slots)))]
    dots, y, ys = None, 0.0, {}
    if places[-1] < len(slots) - 2:
        ys[len(slots) - 1] = y
        dots, y = y + _WORD_ROW + 9, y + _WORD_ROW + 18
    else:
        places = [*range(len(slots))]
    for place in reversed(places):
        ys[place] = y
        y += _WORD_ROW
    return ys, dots, y


def _pile_words(face: Face, words: dict[str, str], left: float, ys: dict[int, float], count: int) -> Iterator[Shape]:
    """Draw the word that may come in, the word that came out last, and the pointer of a pile that gives back its top."""
    top, lifo = count - 1, face.way == "lifo"
    middle = {place: y + _WORD_ROW / 2 for place, y in ys.items()}
    if ".I" in words:
        y = middle.get(count, middle[max(middle)] - 2)
        width = _chip_width(".I", words[".I"])
        yield from _chip(left - 26 - width, y, ".I", words[".I"])
        if count in middle:
            yield Stroke(((left - 24, y), (left - 3, y)), "line", arrow=True)
    if lifo and top >= 0:
        yield Words(left - 26, middle[top], POINTER, "accent", "end", 12)
        yield Stroke(((left - 23, middle[top]), (left - 3, middle[top])), "accent", arrow=True)
    if not lifo and top >= 1:
        yield Stroke(((left - 10, middle[top] + 2), (left - 10, middle[0])), "line", arrow=True)
    if ".O" in words:
        y = middle[max(0, top) if lifo else 0]
        yield from _chip(left + _WORD + 26, y, ".O", words[".O"])
        if count:
            yield Stroke(((left + _WORD + 3, y), (left + _WORD + 24, y)), "line", arrow=True)


def _chip_width(name: str, value: str) -> float:
    return extent(f"{name} {value}", 12, code=True) + 16


def _chip(x: float, y: float, name: str, value: str) -> Iterator[Shape]:
    width = _chip_width(name, value)
    yield Box(x, y - 10, width, 20, "chip", 10)
    yield Words(x + width / 2, y, same(f"{name} {value}".strip()), "text", size=12, code=True)
