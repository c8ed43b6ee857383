"""A plant's picture: everything named, nothing written over anything else, and each state shows what the plant does."""

from __future__ import annotations

import json
import math
from itertools import combinations

import pytest
from defusedxml import ElementTree

from plcteach import plants
from plcteach.figure.plant import plant_scene, plant_state, still
from plcteach.figure.plant_shapes import _KINDS
from plcteach.figure.scene import Box, Disc, Stroke, Words, extent
from plcteach.figure.svg import bare, svg
from plcteach.plants import Model
from plcteach.plants.declared import SHAPES

ALL = [plants.plant(name) for name in plants.names()]
each_plant = pytest.mark.parametrize("plant", ALL, ids=lambda plant: plant.id)


def base(part: str) -> str:
    return part.rstrip("+-")


def test_every_kind_of_thing_that_may_be_declared_can_be_drawn() -> None:
    assert set(_KINDS) == set(SHAPES)


@each_plant
def test_every_device_is_drawn_named_and_addressed(plant) -> None:
    scene = plant_scene(plant)
    words = [shape.text.en for shape in scene.shapes if isinstance(shape, Words)]
    for device in plant.devices:
        assert words.count(device.symbol) == 1, device.symbol
        if device.address:
            assert words.count(device.address) == 1, device.address
        assert any(base(shape.part) == device.symbol for shape in scene.shapes)


@each_plant
def test_the_address_in_the_picture_is_the_one_of_the_program(plant) -> None:
    for sample in plant.samples:
        words = [shape.text.en for shape in plant_scene(plant.for_(sample)).shapes if isinstance(shape, Words)]
        assert all(device.address in words for device in plant.for_(sample).devices if device.address)


@each_plant
def test_whatever_can_be_on_looks_different_then(plant) -> None:
    parts = {shape.part for shape in plant_scene(plant).shapes}
    for device in plant.devices:
        assert f"{device.symbol}+" in parts


@each_plant
@pytest.mark.parametrize("lang", ["zh", "en"])
def test_no_word_is_written_over_another_or_beyond_the_edge(plant, lang: str) -> None:
    scene = plant_scene(plant)
    boxes = []
    for shape in still(Model(plant)).shapes:
        if isinstance(shape, Words) and shape.text.in_(lang).strip():
            wide = extent(shape.text.in_(lang), shape.size, code=shape.code)
            left = {"start": shape.x, "middle": shape.x - wide / 2, "end": shape.x - wide}[shape.anchor]
            boxes.append((left, shape.y - shape.size / 2, left + wide, shape.y + shape.size / 2, shape.text.in_(lang)))
    for one in boxes:
        assert one[0] >= 0, one
        assert one[2] <= scene.width, one
        assert 0 <= one[1] < one[3] <= scene.height, one
    for one, two in combinations(boxes, 2):
        apart = one[2] <= two[0] or two[2] <= one[0] or one[3] <= two[1] + 1 or two[3] <= one[1] + 1
        assert apart, (one, two)


@each_plant
def test_a_state_is_what_a_page_can_apply(plant) -> None:
    scene, model = plant_scene(plant), Model(plant)
    parts = {base(shape.part) for shape in scene.shapes}
    for _ in range(40):
        model.step({one.address: 1 for one in plant.outputs}, 130)
        state = plant_state(model)
        assert json.loads(json.dumps(state)) == state
        assert set(state) == {"on", "move", "turn", "items", "text"}
        named = {*state["on"], *state["move"], *state["turn"], *state["text"]}
        assert named - {""} <= parts | {one.part for one in plant.drawn}
        assert {f"item:{kind}" for kind, _, _ in state["items"]} <= parts
        assert {one.symbol for one in plant.outputs} <= set(state["on"])


@each_plant
def test_the_middle_of_what_turns_is_the_middle_of_its_box(plant) -> None:
    """A page turns a group about the middle of its box; so the box must lie evenly about the disc."""
    scene = plant_scene(plant)
    for part in plant_state(Model(plant))["turn"]:
        shapes = [shape for shape in scene.shapes if shape.part == part]
        disc = next(shape for shape in shapes if isinstance(shape, Disc))
        for shape in shapes:
            if isinstance(shape, Stroke):
                assert all(math.hypot(x - disc.x, y - disc.y) <= disc.radius + 0.01 for x, y in shape.points)
            else:
                assert isinstance(shape, Disc)
                assert (shape.x, shape.y) == (disc.x, disc.y)


def test_the_head_moves_to_the_right_and_its_switch_comes_on() -> None:
    plant = plants.plant("drilling-head")
    model = Model(plant)
    start = plant_state(model)
    assert "SQ1" in start["on"]
    assert start["move"]["slide"] == [0, 0]
    model.step({"%Q0.1": 1}, 800)
    assert plant_state(model)["move"]["slide"] == [68, 0]
    model.step({"%Q0.1": 1}, 2_100)
    later = plant_state(model, {"%Q0.2": 1})
    assert {"SQ2", "YV2", "cam"} <= set(later["on"])
    assert not {"SQ1", "YV1"} & set(later["on"])
    assert later["text"]["reading"] == {"zh": "61 mm", "en": "61 mm"}
    moved = [shape.x for shape in still(model).shapes if isinstance(shape, Box) and shape.part == "slide"]
    rest = [shape.x for shape in plant_scene(plant).shapes if isinstance(shape, Box) and shape.part == "slide"]
    assert all(now - then == pytest.approx(61 * 1.7) for now, then in zip(moved, rest, strict=True))


def test_a_motor_turns_and_a_lamp_that_is_off_is_not_shown_as_on() -> None:
    motors = Model(plants.plant("three-motors"))
    motors.step({"%Q0.1": 1}, 3_000)
    state = plant_state(motors)
    assert state["turn"]["motor1"] > 0
    assert state["turn"]["motor2"] == 0
    lamps = Model(plants.plant("eight-lamps"))
    lamps.step({"%Q0.2": 1}, 10)
    seen = {shape.part for shape in still(lamps).shapes}
    assert {"L3+", "L2-"} <= seen
    assert not {"L3-", "L2+"} & seen


def test_workpieces_stand_on_the_belt_where_the_model_has_them() -> None:
    model = Model(plants.plant("reject-conveyor"))
    model.step({"%Q0.0": 1}, 3_000)
    items = sorted(plant_state(model)["items"])
    assert [(kind, round(x), y) for kind, x, y in items] == [
        ("good", 212, 147),
        ("good", 267, 147),
        ("waste", 157, 147),
    ]
    assert all(
        not shape.part.startswith("item:") or shape.x > 100 for shape in still(model).shapes if isinstance(shape, Box)
    )


@each_plant
@pytest.mark.parametrize("dark", [False, True])
def test_the_picture_is_well_formed_in_both_languages(plant, dark) -> None:
    for lang in ("zh", "en"):
        assert ElementTree.fromstring(svg(still(Model(plant)), lang, dark=dark)).tag.endswith("svg")
    page = ElementTree.fromstring(bare(plant_scene(plant)))
    parts = {group.get("data-part") for group in page.iter("{http://www.w3.org/2000/svg}g")}
    assert {one.symbol for one in plant.devices} <= {base(part or "") for part in parts}
