"""Boxes, long rungs, rungs half built, brackets, legends and formulas: what the new parts of a drawn ladder show."""

from __future__ import annotations

import itertools
import re

import pytest

from plcteach.core.ladder import Box as Block
from plcteach.core.ladder import Coil, Compared, Contact, Edge, Invert, Ladder, Rung, branch, parallel, rung, series
from plcteach.figure.bands import bands
from plcteach.figure.ink import INKS
from plcteach.figure.ladder import ladder_scene
from plcteach.figure.ladders import lift
from plcteach.figure.rung import Look
from plcteach.figure.scene import Box, Scene, Stroke, Words
from plcteach.figure.svg import svg
from plcteach.ladder.formulas import formulas
from plcteach.ladder.layout import layout

COUNTER = Rung(Contact("I0.0"), (Block("CTU C0, 3", (("R", parallel(Contact("I0.1"), Contact("M0.0"))),), "CU"),))
LONG = rung(series(*(Contact(f"I{number // 8}.{number % 8}") for number in range(20))), Coil("Q0.0"))
BLOCKS = rung(
    parallel(series(Contact("I0.0"), Contact("I0.1")), series(Contact("I0.2"), Contact("I0.3"))), Coil("Q0.0")
)


def names(scene: Scene) -> dict[str, Words]:
    return {shape.text.en: shape for shape in scene.shapes if isinstance(shape, Words)}


def boxes(scene: Scene, ink: str) -> list[Box]:
    return [shape for shape in scene.shapes if isinstance(shape, Box) and shape.ink == ink]


def strokes(scene: Scene, part: str) -> list[Stroke]:
    return [shape for shape in scene.shapes if isinstance(shape, Stroke) and shape.part == part]


def test_a_counter_has_one_box_and_a_wire_from_the_left_rail_to_each_input() -> None:
    scene = ladder_scene(COUNTER)
    (box,) = boxes(scene, "block")
    said = names(scene)
    assert box.y < said["CU"].y < said["R"].y < box.y + box.height
    assert box.x < said["CTU"].x < box.x + box.width
    left = next(shape.points[0][0] for shape in scene.shapes if isinstance(shape, Stroke) and shape.ink == "rail")
    for pin in ("CU", "R"):
        level = [
            shape.points
            for shape in scene.shapes
            if isinstance(shape, Stroke) and shape.points[0][1] == shape.points[1][1] == said[pin].y
        ]
        assert min(start for (start, _), _ in level) == left
        assert max(stop for _, (stop, _) in level) >= box.x
    assert said["M0.0"].y > said["I0.1"].y > said["I0.0"].y


def test_every_wire_of_a_row_meets_the_next_so_that_nothing_hangs_in_the_air() -> None:
    scene = ladder_scene(COUNTER)
    rows: dict[float, list[tuple[float, float]]] = {}
    for shape in scene.shapes:
        if isinstance(shape, Stroke) and shape.points[0][1] == shape.points[1][1]:
            rows.setdefault(shape.points[0][1], []).append((shape.points[0][0], shape.points[1][0]))
    for level in rows.values():
        level.sort()
        gaps = [after[0] - one[1] for one, after in itertools.pairwise(level)]
        assert all(gap in {0, 12} for gap in gaps), "a gap is a contact's, and nothing else's"


def test_a_rung_of_twenty_contacts_goes_on_in_bands_and_its_coil_stands_at_the_rail() -> None:
    plan = layout(LONG)
    assert [(one.start, one.stop) for one in bands(plan, 9)] == [(0, 9), (9, 18), (18, 21)]
    scene = ladder_scene(LONG)
    said = names(scene)
    assert said["I0.0"].x == said["I1.1"].x == said["I2.2"].x
    assert said["I0.0"].y < said["I1.1"].y < said["I2.2"].y == said["Q0.0"].y
    arrows = [shape for shape in scene.shapes if isinstance(shape, Stroke) and shape.arrow]
    assert len(arrows) == 4
    assert scene.width < 900


def test_a_rung_is_cut_only_where_a_single_wire_goes_on() -> None:
    wide = rung(parallel(LONG.stem, Contact("M0.0")), Coil("Q0.0"))  # type: ignore[arg-type]
    assert [(one.start, one.stop) for one in bands(layout(wide), 9)] == [(0, 20), (20, 21)]
    forked = rung(LONG.stem, branch(Contact("M0.0"), Coil("Q0.0")), branch(Contact("M0.1"), Coil("Q0.1")))
    assert [one.stop for one in bands(layout(forked), 9)] == [9, 18, 22]


def test_what_is_not_built_yet_is_faint_and_the_two_blocks_of_a_join_are_bracketed() -> None:
    look = Look(unbuilt=frozenset({3, 4}), brackets=(frozenset({0, 1}), frozenset({2, 3})))
    scene = ladder_scene(BLOCKS, looks={0: look})
    faint = {shape.part for shape in scene.shapes if shape.ink == "unbuilt"}
    assert {"s0-3", "s0-4"} <= faint
    assert not {"s0-0", "s0-1", "s0-2"} & faint
    upper, lower = boxes(scene, "bracket")
    said = names(scene)
    assert upper.y < said["I0.0"].y < said["1"].y + 20 < lower.y < said["I0.2"].y
    assert upper.x < said["I0.0"].x < said["I0.1"].x < upper.x + upper.width


def test_every_shape_of_a_sign_bears_its_number_and_every_wire_that_of_its_net() -> None:
    scene = ladder_scene(Ladder((BLOCKS, COUNTER)))
    parts = {shape.part for shape in scene.shapes if shape.part}
    assert {f"s0-{at}" for at in range(5)} | {f"s1-{at}" for at in range(4)} <= parts
    assert {shape.part[:2] for shape in scene.shapes if isinstance(shape, Stroke) and shape.ink == "wire"} == {
        "n0",
        "n1",
        "j0",
        "j1",
    }
    drawn = svg(scene, "en")
    assert drawn.count('data-part="s0-4"') == 1
    assert re.search(r'<g data-part="s0-4">.*?Q0\.0.*?</g>', drawn, re.DOTALL)


@pytest.mark.parametrize("style", ["relay", "iec"])
def test_every_kind_of_sign_is_drawn_and_explained_in_both_languages(style: str) -> None:
    signs = rung(
        series(
            Contact("I0.0"), Contact("I0.1", negated=True), Contact("I0.2", edge="rise"), Contact("I0.3", edge="fall"),
            Contact("I0.4", immediate=True), Contact("I0.5", negated=True, immediate=True), Compared("VW0", ">=", "5"),
            Invert(), Edge(), Edge(rising=False, memory="M9.0"),
        ),
        Coil("Q0.0"), Coil("Q0.1", "set", 3), Coil("Q0.2", "reset"), Coil("Q0.3", "not"), Coil("M0.0", "rise"),
        Coil("M0.1", "fall"), Coil("Q0.4", immediate=True), Block("TON T37, 50"),
    )  # fmt: skip
    scene = ladder_scene(signs, style=style, legend=True, most=30)  # type: ignore[arg-type]
    said = names(scene)
    assert {"VW0", "5", ">=", "M9.0", "TON", "T37", "50", "normally closed contact", "comparing contact", "box"} <= set(
        said
    )
    zh = {shape.text.zh for shape in scene.shapes if isinstance(shape, Words)}
    assert {"常闭触点", "比较触点", "功能框", "置位线圈"} <= zh
    assert all(shape.ink in INKS for shape in scene.shapes)
    assert all(shape.x <= scene.width for shape in scene.shapes if isinstance(shape, Words))


def test_the_formula_of_each_output_stands_below_its_rung() -> None:
    one = rung(series(parallel(Contact("I0.0"), Contact("Q0.0")), Contact("I0.1", negated=True)), Coil("Q0.0"))
    assert formulas(one) == (("Q0.0", "(I0.0+Q0.0)·/I0.1"),)
    assert formulas(COUNTER) == (("CTU C0 CU", "I0.0"), ("CTU C0 R", "I0.1+M0.0"))
    turned = rung(
        Contact("I0.0"),
        branch(Invert(), Coil("Q0.0")),
        branch(parallel(Invert(), Contact("I0.1")), Coil("Q0.1", "set")),
    )
    assert formulas(turned) == (("Q0.0", "/I0.0"), ("S Q0.1", "/I0.0+I0.0·I0.1"))
    scene = ladder_scene(one, formulas=True)
    assert names(scene)["Q0.0 = (I0.0+Q0.0)·/I0.1"].y > names(scene)["Q0.0"].y
    wide = ladder_scene(LONG, formulas=True)
    rows = [word for word in names(wide) if word.startswith(("Q0.0 =", "    "))]
    assert len(rows) == 2
    assert "".join(row.strip() for row in rows).endswith("I2.2·I2.3")


def test_power_reaches_a_box_and_its_further_input_by_its_own_wire() -> None:
    def box_ink(**bits: int) -> str:
        scene = ladder_scene(COUNTER, powered={name.replace("_", "."): value for name, value in bits.items()})
        return next(shape.ink for shape in scene.shapes if isinstance(shape, Box) and shape.part == "s0-3")

    assert box_ink(I0_0=1) == "block-on"
    assert box_ink(I0_1=1) == "block"
    scene = ladder_scene(COUNTER, powered={"I0.1": 1})
    pin = layout(COUNTER).pins[0]
    assert {stroke.ink for stroke in strokes(scene, f"n0-{pin.source}")} == {"wire-on"}


def test_two_blocks_stand_apart_until_their_join_is_executed() -> None:
    def ink(line: int) -> set[str]:
        figure = lift("LD I0.0; A I0.1; LD I0.2; A I0.3; OLD; = Q0.0", "s7-200", line=line)
        return {shape.ink for shape in figure.scene.shapes if shape.part == "j0-1-0" and isinstance(shape, Stroke)}

    assert ink(4) == {"unbuilt"}
    assert ink(5) == {"wire"}


def test_a_block_in_series_hangs_on_nothing_until_its_join_is_executed() -> None:
    def inks(line: int) -> set[str]:
        figure = lift("LD I0.0; O I0.1; LD I0.2; O I0.3; ALD; = Q0.0", "s7-200", line=line)
        (joint,) = {
            shape.part for shape in figure.scene.shapes if shape.part.startswith("j0") and shape.part.endswith("-1")
        } - {"j0-0-1"}
        return {shape.ink for shape in figure.scene.shapes if shape.part == joint and isinstance(shape, Stroke)}

    assert inks(4) == {"unbuilt"}
    assert inks(5) == {"wire"}
