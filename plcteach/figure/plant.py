"""A plant as a picture, and what changes in it from moment to moment: a page only shows, hides, moves, turns and writes.

The scene holds everything that can ever be seen. A shape's part says when: `L+` is seen only while `L` is on, `L-` only while it
is off, `item:good` is the pattern of a workpiece, to be shown as often as there are such workpieces and nowhere else. `still`
does with shapes what a page does with groups, for paper.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import chain
from math import cos, radians, sin
from typing import TYPE_CHECKING, Any

from plcteach.core.text import Text
from plcteach.figure.plant_shapes import drawn_shapes
from plcteach.figure.scene import Disc, Scene, Stroke, Words

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from plcteach.figure.scene import Point, Shape
    from plcteach.plants import Model, Plant
    from plcteach.plants.declared import Drawn

_UNIT = 1_000_000


def plant_scene(plant: Plant) -> Scene:
    """Draw a plant with everything that can be seen of it at any time."""
    shapes = tuple(chain.from_iterable(drawn_shapes(one, plant) for one in plant.drawn))
    return Scene(*plant.size, shapes, plant.title)


def plant_state(model: Model, outputs: Mapping[str, int] | None = None) -> dict[str, Any]:
    """Give what a page must change now; `outputs` (by address) where the PLC's are newer than the plant's last step.

    on: parts that are on.  move: px to the right and down.  turn: degrees clockwise about the middle of the part.
    items: kind, x and y of each workpiece, to which its pattern is moved.  text: what a part now says.
    """
    bits = {**model.bits, **_newer(model.plant, outputs)} if outputs is not None else model.bits
    state: dict[str, Any] = {"on": [], "move": {}, "turn": {}, "items": [], "text": {}}
    for one in model.plant.drawn:
        lit = model.holds(one.on) if one.on else bits.get(one.symbol, False)
        if lit and one.part not in state["on"]:
            state["on"].append(one.part)
        if one.moves:
            state["move"][one.part] = _offset(one, model)
        if one.turns:
            angle = sum(_from_start(model, name) * degrees for name, degrees in one.turns.items())
            state["turn"] |= {part: round(angle % 360, 1) for part in _turning(one)}
        if one.kind == "item":
            state["items"] += _items(one, model)
        if one.kind == "value":
            state["text"][one.part] = _reading(one, model).as_dict()
    return state


def _newer(plant: Plant, outputs: Mapping[str, int]) -> dict[str, bool]:
    return {one.symbol: bool(outputs.get(one.address, 0)) for one in plant.outputs}


def _from_start(model: Model, name: str) -> float:
    """Give how far a part is from where it began, in its unit."""
    return (model.spots[name][0] - model.plant.part(name).start) / _UNIT


def _offset(one: Drawn, model: Model) -> list[float]:
    ways = [(_from_start(model, name), dx, dy) for name, (dx, dy) in one.moves.items()]
    return [round(sum(way * dx for way, dx, _ in ways), 2), round(sum(way * dy for way, _, dy in ways), 2)]


def _turning(one: Drawn) -> tuple[str, ...]:
    """Give the parts that turn: a belt has two rollers."""
    return (f"{one.part}.1", f"{one.part}.2") if one.kind == "belt" else (one.part,)


def _items(one: Drawn, model: Model) -> Iterator[list[Any]]:
    dx, dy = one.more["by"]
    for spot in model.spots[one.more["of"]]:
        yield [one.more["of"], round(one.x + spot / _UNIT * dx, 2), round(one.y + spot / _UNIT * dy, 2)]


def _reading(one: Drawn, model: Model) -> Text:
    whole = model.spots[one.more["of"]][0] // _UNIT
    return Text(one.text.zh.replace("{}", str(whole)), one.text.en.replace("{}", str(whole)))


# On paper.


def still(model: Model, outputs: Mapping[str, int] | None = None) -> Scene:
    """Draw a plant as it is at this moment, as a picture that needs no page."""
    scene, state = plant_scene(model.plant), plant_state(model, outputs)
    middles = {shape.part: (shape.x, shape.y) for shape in scene.shapes if isinstance(shape, Disc)}
    patterns = [shape for shape in scene.shapes if shape.part.startswith("item:")]
    seen = [shape for shape in scene.shapes if shape not in patterns and _seen(shape.part, state["on"])]
    shapes = [_placed(shape, state, middles.get(shape.part, (0, 0))) for shape in seen]
    for kind, x, y in state["items"]:
        shapes += [_moved(shape, x, y) for shape in patterns if shape.part == f"item:{kind}"]
    return replace(scene, shapes=tuple(shapes))


def _seen(part: str, on: list[str]) -> bool:
    return (part[:-1] in on) == (part[-1] == "+") if part.endswith(("+", "-")) else True


def _placed(shape: Shape, state: Mapping[str, Any], middle: Point) -> Shape:
    """Move, turn and write one shape as its part is now."""
    part = shape.part.rstrip("+-")
    if part in state["turn"] and isinstance(shape, Stroke):
        shape = replace(shape, points=tuple(_turned(point, middle, state["turn"][part]) for point in shape.points))
    if part in state["text"] and isinstance(shape, Words):
        shape = replace(shape, text=Text(**state["text"][part]))
    return _moved(shape, *state["move"].get(part, (0, 0)))


def _moved(shape: Shape, dx: float, dy: float) -> Shape:
    if isinstance(shape, Stroke):
        return replace(shape, points=tuple((x + dx, y + dy) for x, y in shape.points))
    return replace(shape, x=shape.x + dx, y=shape.y + dy)


def _turned(point: Point, middle: Point, degrees: float) -> Point:
    (x, y), (mx, my), turn = point, middle, radians(degrees)
    return mx + (x - mx) * cos(turn) - (y - my) * sin(turn), my + (x - mx) * sin(turn) + (y - my) * cos(turn)
