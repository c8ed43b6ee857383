"""How each thing in a plant's picture is drawn: buttons, lamps, contactors, valves, motors, belts, switches and workpieces.

A shape whose part ends with "+" is seen while the thing is on, one that ends with "-" while it is off.
"""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, sin
from typing import TYPE_CHECKING, Any, Literal

from plcteach.core.text import Text, same
from plcteach.figure.scene import Box, Disc, Stroke, Words

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from plcteach.figure.scene import Shape
    from plcteach.plants import Plant
    from plcteach.plants.declared import Drawn

_SYMBOL, _ADDRESS = 13.0, 11.0
_CAP = 12.0
_GLOW = {"red": "lost", "green": "good", "amber": "warn"}


def drawn_shapes(one: Drawn, plant: Plant) -> Iterator[Shape]:
    """Give the shapes of one thing, each with its part, and the symbol and address of its device beside it."""
    for suffix, shape in _KINDS[one.kind](one):
        yield shape if shape.part else replace(shape, part="" if suffix == "fixed" else one.part + suffix)
    if one.symbol:
        address = plant.device(one.symbol).address
        for shape in _label(one.symbol, address, one):
            yield shape


def _label(symbol: str, address: str, one: Drawn) -> Iterator[Shape]:
    """Write a symbol and its address above, below or beside a thing."""
    reach_x, reach_y = _REACH.get(one.kind, (14.0, 14.0))
    radius = one.more.get("radius")
    if radius:
        reach_x = reach_y = radius + 2 if one.more.get("glow") else radius * 4 / 3 + 4
    where = one.more.get("label", _USUAL.get((one.kind, one.more.get("side", "")), "above"))
    if where == "none":
        return
    places: dict[str, tuple[float, float, Literal["start", "middle", "end"]]] = {
        "above": (one.x, one.y - reach_y - 22, "middle"),
        "below": (one.x, one.y + reach_y + 9, "middle"),
        "left": (one.x - reach_x - 5, one.y - 7, "end"),
        "right": (one.x + reach_x + 5, one.y - 7, "start"),
    }
    x, y, anchor = places[where]
    if not address:
        y += 7
    yield Words(x, y, same(symbol), "text", anchor, _SYMBOL, bold=True)
    if address:
        yield Words(x, y + 14, same(address), "quiet", anchor, _ADDRESS, code=True)


_REACH = {
    "button": (20.0, 20.0),
    "lever": (18.0, 18.0),
    "limit-switch": (26.0, 18.0),
    "sensor": (15.0, 12.0),
    "contactor": (24.0, 14.0),
    "valve": (34.0, 12.0),
}
_USUAL = {("contactor", ""): "right", ("limit-switch", ""): "below", ("limit-switch", "right"): "right"}


def _button(one: Drawn) -> Iterator[tuple[str, Shape]]:
    x, y, stop = one.x, one.y, one.more.get("stop", False)
    sign, ink = ("O", "lost") if stop else ("I", "good")
    yield "", Disc(x, y, 18, "block")
    yield "-", Disc(x, y, _CAP, ink)
    yield "-", Words(x, y, same(sign), ink, "middle", 13, bold=True)
    yield "+", Disc(x, y, _CAP, "peg")
    yield "+", Words(x, y, same(sign), "paper", "middle", 13, bold=True)


def _lever(one: Drawn) -> Iterator[tuple[str, Shape]]:
    x, y = one.x, one.y
    yield "", Disc(x, y, 16, "block")
    yield "", Words(x - 22, y - 13, same("0"), "quiet", "middle", 11)
    yield "", Words(x + 22, y - 13, same("1"), "quiet", "middle", 11)
    yield "-", Stroke(((x + 8, y + 9), (x - 9, y - 10)), "rail")
    yield "+", Stroke(((x - 8, y + 9), (x + 9, y - 10)), "wire-on")


def _limit_switch(one: Drawn) -> Iterator[tuple[str, Shape]]:
    x, y = one.x, one.y
    right = one.more.get("side") == "right"
    for sign, depth, ink, wheel in (("-", 0.0, "block", "cell"), ("+", 4.0, "block-on", "peg")):
        if right:
            yield sign, Stroke(((x + depth, y), (x + 12, y + 6)), "contact")
            yield sign, Disc(x - 4 + depth, y, 5, wheel)
            yield sign, Box(x + 10, y - 11, 15, 22, ink, 2)
        else:
            yield sign, Stroke(((x, y - 4 + depth), (x + 6, y + 4)), "contact")
            yield sign, Disc(x, y - 5 + depth, 5, wheel)
            yield sign, Box(x - 11, y + 2, 22, 15, ink, 2)


def _sensor(one: Drawn) -> Iterator[tuple[str, Shape]]:
    x, y = one.x, one.y
    dx, dy = one.more.get("beam", (0, 0))
    if dx or dy:
        yield "-", Stroke(((x, y + 10), (x + dx, y + 10 + dy)), "dashed")
        yield "+", Stroke(((x, y + 10), (x + dx, y + 10 + dy)), "wire-on")
    yield "-", Box(x - 13, y - 10, 26, 20, "block", 3)
    yield "+", Box(x - 13, y - 10, 26, 20, "block-on", 3)
    yield "-", Disc(x, y, 4.5, "cell")
    yield "+", Disc(x, y, 4.5, "peg")


def _lamp(one: Drawn) -> Iterator[tuple[str, Shape]]:
    x, y, r = one.x, one.y, float(one.more.get("radius", 14))
    glow = _GLOW.get(one.more.get("glow", ""), "")
    letter = one.more.get("letter", "")
    half = r * 0.7
    yield "", Disc(x, y, r, "block")
    if glow:
        yield from (("+", Disc(x, y, 0.6 + step, glow)) for step in range(int(r)))
    else:
        yield "+", Disc(x, y, r, "peg")
        rays = [2 * pi * place / 12 for place in range(12)]
        yield from (("+", _ray(x, y, r + 4, r + 4 + r / 3, angle)) for angle in rays)
    for sign, ink in (("-", "text"), ("+", "paper")):
        if letter:
            yield sign, Words(x, y, same(letter), "quiet" if sign == "-" else ink, "middle", 13, bold=True)
        else:
            yield sign, Stroke(((x - half, y - half), (x + half, y + half)), ink)
            yield sign, Stroke(((x - half, y + half), (x + half, y - half)), ink)


def _ray(x: float, y: float, near: float, far: float, angle: float) -> Stroke:
    return Stroke(tuple((x + far_or * cos(angle), y + far_or * sin(angle)) for far_or in (near, far)), "accent")


def _contactor(one: Drawn) -> Iterator[tuple[str, Shape]]:
    x, y = one.x, one.y
    up, down = float(one.more.get("up", 0)), float(one.more.get("down", 0))
    yield "-", Box(x - 30, y - 12, 22, 24, "block")
    yield "+", Box(x - 30, y - 12, 22, 24, "new")
    yield "", Stroke(((x - 8, y), (x + 22, y)), "dashed")
    for place in (0, 11, 22):
        yield "", Stroke(((x + place, y - 20 - up), (x + place, y - 8)), "contact")
        yield "", Stroke(((x + place, y + 8), (x + place, y + 20 + down)), "contact")
        yield "-", Stroke(((x + place, y + 8), (x + place - 6, y - 8)), "contact")
        yield "+", Stroke(((x + place, y + 8), (x + place, y - 8)), "wire-on")


def _valve(one: Drawn) -> Iterator[tuple[str, Shape]]:
    x, y = one.x, one.y
    for sign, ink, box in (("-", "contact", "block"), ("+", "wire-on", "new")):
        yield sign, Box(x - 36, y - 10, 15, 20, box)
        yield sign, Stroke(((x - 36, y + 10), (x - 21, y - 10)), "contact")
        yield sign, Box(x - 21, y - 10, 21, 20, "block" if sign == "-" else "block-on")
        yield sign, Stroke(((x - 11, y + 9), (x - 11, y - 8)), ink, arrow=True)
    yield "", Box(x, y - 10, 21, 20, "block")
    yield "", Stroke(((x + 10, y + 10), (x + 10, y + 4)), "contact")
    yield "", Stroke(((x + 6, y + 4), (x + 14, y + 4)), "contact")
    yield "", Stroke(((x + 10, y - 10), (x + 10, y - 4)), "contact")
    yield "", Stroke(((x + 6, y - 4), (x + 14, y - 4)), "contact")
    spring = tuple((x + 21 + 3 * place, y + swing) for place, swing in enumerate((0, 6, -6, 6, -6, 0)))
    yield "", Stroke(spring, "contact")


def _motor(one: Drawn) -> Iterator[tuple[str, Shape]]:
    x, y, r = one.x, one.y, float(one.more.get("radius", 26))
    yield "fixed", Disc(x, y, r, "block")
    yield "", Disc(x, y, r - 3, "area")
    for place in range(3):
        angle = 2 * pi * place / 3
        yield "", _spoke(x, y, r * 0.5, r - 3, angle)
    yield "fixed", Disc(x, y, r * 0.5, "block")
    yield "fixed", Words(x, y, same("M"), "text", "middle", 15, bold=True)


def _spoke(x: float, y: float, near: float, far: float, angle: float) -> Stroke:
    return Stroke(tuple((x + reach * cos(angle), y + reach * sin(angle)) for reach in (near, far)), "rail")


def _belt(one: Drawn) -> Iterator[tuple[str, Shape]]:
    x, y, length, r = one.x, one.y, float(one.more["length"]), float(one.more.get("height", 26)) / 2
    yield "fixed", Stroke(((x + r, y - r), (x + length - r, y - r)), "rail")
    yield "fixed", Stroke(((x + r, y + r), (x + length - r, y + r)), "rail")
    for number, middle in enumerate((x + r, x + length - r), start=1):
        part = f"{one.part}.{number}"
        yield "", Disc(middle, y, r, "block", part=part)
        yield "", Stroke(((middle - r + 2, y), (middle + r - 2, y)), "contact", part=part)
        yield "", Stroke(((middle, y - r + 2), (middle, y + r - 2)), "contact", part=part)


def _sign(one: Drawn) -> str:
    return {"on": "+", "off": "-"}.get(one.more.get("shown", ""), "")


def _box(one: Drawn) -> Iterator[tuple[str, Shape]]:
    more = one.more
    size = float(more["width"]), float(more["height"])
    yield _sign(one), Box(one.x, one.y, *size, more.get("ink", "block"), float(more.get("radius", 0)))


def _disc(one: Drawn) -> Iterator[tuple[str, Shape]]:
    yield _sign(one), Disc(one.x, one.y, float(one.more["radius"]), one.more.get("ink", "block"))


def _line(one: Drawn) -> Iterator[tuple[str, Shape]]:
    points = tuple((one.x + x, one.y + y) for x, y in one.more["points"])
    yield _sign(one), Stroke(points, one.more.get("ink", "line"), arrow=bool(one.more.get("arrow", False)))


def _words(one: Drawn) -> Iterator[tuple[str, Shape]]:
    more = one.more
    look: dict[str, Any] = {"anchor": more.get("anchor", "middle"), "size": float(more.get("size", 13))}
    yield _sign(one), Words(one.x, one.y, one.text, more.get("ink", "text"), bold=bool(more.get("bold", False)), **look)


def _value(one: Drawn) -> Iterator[tuple[str, Shape]]:
    zero = Text(one.text.zh.replace("{}", "0"), one.text.en.replace("{}", "0"))
    size = float(one.more.get("size", 13))
    yield "", Words(one.x, one.y, zero, "text", one.more.get("anchor", "middle"), size, bold=True)


def _item(one: Drawn) -> Iterator[tuple[str, Shape]]:
    """Draw the pattern of a workpiece about the place (0, 0), at the foot of a block and in the middle of a car."""
    part, look = f"item:{one.more['of']}", one.more.get("look", "block")
    if look in {"car", "car-up"}:
        wide, high = (34, 18) if look == "car" else (18, 34)
        yield "", Box(-wide / 2, -high / 2, wide, high, "block", 5, part=part)
        yield "", Box(2, -6, 7, 12, "chip", 2, part=part) if look == "car" else Box(-6, -9, 12, 7, "chip", 2, part=part)
        return
    yield "", Box(-12, -24, 24, 23, "block", 2, part=part)
    if look == "marked":
        yield "", Stroke(((-7, -19), (7, -6)), "lost", part=part)
        yield "", Stroke(((-7, -6), (7, -19)), "lost", part=part)


_KINDS: dict[str, Callable[[Drawn], Any]] = {
    "button": _button,
    "lever": _lever,
    "limit-switch": _limit_switch,
    "sensor": _sensor,
    "lamp": _lamp,
    "contactor": _contactor,
    "valve": _valve,
    "motor": _motor,
    "belt": _belt,
    "box": _box,
    "disc": _disc,
    "line": _line,
    "words": _words,
    "value": _value,
    "item": _item,
}
