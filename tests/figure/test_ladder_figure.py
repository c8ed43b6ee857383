"""A drawn ladder: what stands where, and which wires are lit."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from hypothesis import given, settings

from plcteach.core.ladder import Contact, Ladder
from plcteach.figure.ladder import ladder_scene
from plcteach.figure.scene import Disc, Scene, Stroke, Words
from plcteach.ladder.picture import read_drawing

sys.path.insert(0, str(Path(__file__).parents[1] / "ladder"))
import itertools

from random_ladders import ladders

SEAL_IN = "(I0.0 + Q0.0) · /I0.1 -> Q0.0"
INKS = {"wire", "wire-on", "rail", "text", "quiet", "contact", "dot"}


def drawn(text: str, **how: object) -> Scene:
    ladder, found = read_drawing(text)
    assert not found
    return ladder_scene(ladder, **how)  # type: ignore[arg-type]


BAR = (0, 21)


def tall(stroke: Stroke) -> tuple[float, float]:
    (x0, y0), (x1, y1) = stroke.points
    return abs(x1 - x0), abs(y1 - y0)


def words(scene: Scene) -> list[tuple[str, float, float]]:
    return [(shape.text.en, shape.x, shape.y) for shape in scene.shapes if isinstance(shape, Words)]


def strokes(scene: Scene, ink: str) -> list[Stroke]:
    return [shape for shape in scene.shapes if isinstance(shape, Stroke) and shape.ink == ink]


def coils(scene: Scene) -> list[Disc]:
    return [shape for shape in scene.shapes if isinstance(shape, Disc) and shape.ink != "dot"]


def lit(text: str, powered: dict[str, object]) -> int:
    return len(strokes(drawn(text, powered=powered), "wire-on"))


def test_one_contact_between_two_rails() -> None:
    scene = drawn("I0.0 -> Q0.0")
    left, right = strokes(scene, "rail")
    assert left.points[0][0] < right.points[0][0]
    assert [word for word, _, _ in words(scene)] == ["I0.0", "Q0.0"]
    assert len(strokes(scene, "contact")) == 2
    assert len(coils(scene)) == 1
    ends = sorted(x for stroke in strokes(scene, "wire") for x, _ in stroke.points)
    assert (ends[0], ends[-1]) == (left.points[0][0], right.points[0][0])
    assert "I0.0 -> Q0.0" in scene.title.zh
    assert scene.title.zh.startswith("梯形图")


def test_the_seal_in_contact_stands_below_the_start_contact_and_meets_it_in_a_dot() -> None:
    scene = drawn(SEAL_IN)
    places = {(word, round(y)): x for word, x, y in words(scene)}
    (first, seal) = sorted(
        key
        for key in places
        if key[0] in {"I0.0", "Q0.0"} and places[key] == places[("I0.0", min(y for _, y in places))]
    )
    assert (first[0], seal[0]) == ("I0.0", "Q0.0")
    assert first[1] < seal[1]
    assert sum(isinstance(shape, Disc) and shape.ink == "dot" for shape in scene.shapes) == 1


def test_a_join_and_the_branch_behind_it_have_a_vertical_each_and_a_short_wire_between() -> None:
    scene = drawn("(I0.0 + I0.5) -> (I0.1 -> Q0.0), (I0.2 -> Q0.1)")
    wires = [stroke.points for stroke in strokes(scene, "wire")]
    closing, opening = sorted(x0 for (x0, y0), (x1, y1) in wires if x0 == x1 and y0 != y1)
    upper, lower = sorted({y0 for (_, y0), (_, y1) in wires if y0 == y1})
    assert opening - closing >= 12
    assert ((closing, upper), (opening, upper)) in wires
    level = [(x0, x1) for (x0, y0), (x1, y1) in wires if y0 == y1 == lower]
    assert closing in {stop for _, stop in level}
    assert opening in {start for start, _ in level}
    assert not any(start < opening and stop > closing for start, stop in level)
    assert {(shape.x, shape.y) for shape in scene.shapes if isinstance(shape, Disc) and shape.ink == "dot"} == {
        (closing, upper),
        (opening, upper),
    }


def test_two_parallel_blocks_in_series_and_power_between_them() -> None:
    text = "(I0.0 + I0.1) · (I0.2 + I0.3) -> Q0.0"
    tops = [stroke.points[0][0] for stroke in strokes(drawn(text), "wire") if tall(stroke)[1]]
    assert len(set(tops)) == 3
    (coil,) = coils(drawn(text, powered={"I0.1": 1, "I0.3": 1}))
    assert coil.ink == "wire-on"


def test_coils_of_all_rungs_stand_under_each_other_at_the_right_rail() -> None:
    scene = drawn("I0.0 -> Q0.0\nI0.0·I0.1·I0.2 -> (I0.3 -> Q0.1), Q0.2\n")
    assert len({disc.x for disc in coils(scene)}) == 1
    assert [word for word, _, _ in words(scene)].count("1") == 1


def test_titles_of_ladder_and_rungs_are_written() -> None:
    scene = drawn("// motor\nNetwork 1 // start 启动\nI0.0 -> Q0.0")
    assert {"motor", "start 启动"} <= {word for word, _, _ in words(scene)}


@pytest.mark.parametrize(("powered", "coil_on"), [
    ({}, False),
    ({"I0.0": 1}, True),
    ({"Q0.0": 1}, True),
    ({"I0.0": 1, "I0.1": 1}, False),
    ({"I0.0": True}, True),
    ({"I0.0": "x"}, False),
])  # fmt: skip
def test_power_goes_where_the_contacts_let_it(powered: dict[str, object], *, coil_on: bool) -> None:
    (coil,) = coils(drawn(SEAL_IN, powered=powered))
    assert (coil.ink == "wire-on") is coil_on


def test_the_wire_before_an_open_contact_is_lit_and_the_wire_behind_it_is_not() -> None:
    assert lit("I0.0 -> Q0.0", {}) == 1
    assert lit("I0.0 -> Q0.0", {"I0.0": 1}) == 6
    assert len(strokes(drawn("I0.0 -> Q0.0"), "wire-on")) == 0


def test_a_set_bit_one_not_and_an_inverted_coil() -> None:
    assert coils(drawn("I0.0·NOT -> Q0.0", powered={}))[0].ink == "wire-on"
    assert coils(drawn("I0.0 -> /Q0.0", powered={}))[0].ink == "wire-on"
    assert coils(drawn("P I0.0 -> Q0.0", powered={"I0.0": 1}))[0].ink == "contact"
    assert coils(drawn("P I0.0 -> Q0.0", powered={"P I0.0": 1}))[0].ink == "wire-on"


def test_the_two_styles_differ_in_coils_edges_and_not() -> None:
    text = "P I0.0·NOT -> S Q0.0 3"
    relay, iec = drawn(text), drawn(text, style="iec")
    assert not coils(relay)[0].arcs
    assert coils(iec)[0].arcs
    assert any(stroke.arrow for stroke in strokes(relay, "contact"))
    assert {"P", "NOT", "S", "3"} <= {word for word, _, _ in words(iec)}


@settings(max_examples=150, deadline=None)
@given(ladder=ladders("fx", edges=True, turned=True))
def test_every_shape_lies_in_the_picture_and_no_two_wires_lie_on_each_other(ladder: Ladder) -> None:
    scene = ladder_scene(ladder, powered={"X0": 1, "X2": 1})
    level: dict[float, list[tuple[float, float]]] = {}
    for shape in scene.shapes:
        assert shape.ink in INKS
        if isinstance(shape, Stroke):
            for x, y in shape.points:
                assert 0 <= x <= scene.width
                assert 0 <= y <= scene.height
            (x0, y0), (x1, y1) = shape.points
            if y0 == y1:
                level.setdefault(y0, []).append((x0, x1))
    for runs in level.values():
        runs.sort()
        assert all(one[1] <= after[0] for one, after in itertools.pairwise(runs))
    names = [symbol.address for rung in ladder.rungs for symbol in rung.symbols if hasattr(symbol, "address")]
    assert sorted(names) == sorted(word for word, _, _ in words(scene) if word[0] in "XY")
    contacts = [symbol for rung in ladder.rungs for symbol in rung.symbols if isinstance(symbol, Contact)]
    bars = [stroke for stroke in strokes(scene, "contact") + strokes(scene, "wire-on") if tall(stroke) == BAR]
    assert len(bars) == 2 * len(contacts)
