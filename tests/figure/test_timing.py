"""Timing charts: an edge stands where its moment stands on the axis, whatever the width and however many changes."""

from __future__ import annotations

import random
from itertools import pairwise

import pytest

from plcteach.core.text import Text, same
from plcteach.figure import mpl
from plcteach.figure.scene import Box, Stroke, Words, extent
from plcteach.figure.svg import Figure, svg
from plcteach.figure.timing import Track, chart_scene

TITLE = Text("断开延时", "off delay")
WIDTHS = [300, 720, 1600]
# figure 4-20, TOF with P = 5 s: Q goes on with IN and off 5 s after IN has gone off; a new start within that time holds it
IN = ((0, 0), (1_000, 1), (3_000, 0), (9_000, 1), (10_000, 0), (12_000, 1), (13_000, 0))
Q = ((0, 0), (1_000, 1), (8_000, 0), (9_000, 1), (18_000, 0))
V = ((0, 0), *((3_000 + 1_000 * count, count) for count in range(1, 6)), (9_000, 0), (11_000, 1), (12_000, 0),
     *((13_000 + 1_000 * count, count) for count in range(1, 6)))  # fmt: skip
TOF = (Track("%TM0.IN", IN), Track("%TM0.Q", Q), Track("%TM0.V", V, word=True, unit="×1 s"))


def axis(scene):
    """Read the axis from its printed numbers, as a reader does: px of second 0, and px per second."""
    found = sorted((shape.x, float(shape.text.en)) for shape in scene.shapes
                   if isinstance(shape, Words) and shape.code and shape.size == 11 and _number(shape.text.en))  # fmt: skip
    (first, zero), (last, most) = found[0], found[-1]
    assert zero == 0
    scale = (last - first) / most
    for x, seconds in found:
        assert x == pytest.approx(first + scale * seconds, abs=0.01)
    return first, scale


def _number(text: str) -> bool:
    return text.replace(".", "", 1).isdigit()


def lines(scene):
    return [shape for shape in scene.shapes if isinstance(shape, Stroke) and shape.ink == "wire"]


def words(scene, lang="en"):
    return [shape.text.in_(lang) for shape in scene.shapes if isinstance(shape, Words)]


@pytest.mark.parametrize("width", WIDTHS)
def test_the_high_stretches_of_an_off_delay_begin_and_end_at_their_moments(width):
    scene = chart_scene(TOF, 20_000, title=TITLE, width=width)
    zero, second = axis(scene)
    line = lines(scene)[1]
    high = min(y for _, y in line.points)
    spans = [x for (x, y), (_, before) in zip(line.points[1:], line.points, strict=False) if y != before]
    assert spans == pytest.approx([zero + second * at for at in (1, 8, 9, 18)], abs=0.06)
    washes = [shape for shape in scene.shapes if isinstance(shape, Box) and shape.ink == "wash" and shape.y == high]
    assert [(box.x, box.x + box.width) for box in washes] == [
        pytest.approx((zero + second * first, zero + second * last), abs=0.06) for first, last in ((1, 8), (9, 18))
    ]


@pytest.mark.parametrize("width", WIDTHS)
def test_a_word_is_drawn_as_stairs_with_its_values_where_there_is_room(width):
    scene = chart_scene(TOF, 20_000, title=TITLE, width=width)
    zero, second = axis(scene)
    stairs = lines(scene)[2].points
    top, bottom = min(y for _, y in stairs), max(y for _, y in stairs)
    for moment, value in ((2, 0), (4.5, 1), (6.5, 3), (8.5, 5), (11.5, 1), (19, 5)):
        x = zero + second * moment
        (y,) = {y for (x0, y), (x1, after) in pairwise(stairs) if x0 < x < x1 and y == after}
        assert (bottom - y) / (bottom - top) == pytest.approx(value / 5)
    shown = words(scene)
    assert {"%TM0.V", "×1 s"} <= set(shown)
    assert shown.count("5") >= (3 if width >= 720 else 1)


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize(
    ("until", "unit", "size"),
    [(40, "ms", 1), (2_000, "ms", 1), (16_000, "s", 1_000), (120_000, "s", 1_000), (3_600_000, "min", 60_000)],
)
def test_the_axis_has_round_numbers_in_a_unit_that_suits(width, until, unit, size):
    scene = chart_scene((Track("X0", ((0, 0), (until // 2, 1))),), until, title=TITLE, width=width)
    assert f"time ({unit})" in words(scene)
    assert f"时间（{unit}）" in words(scene, "zh")
    zero, scale = axis(scene)
    ticks = [shape for shape in scene.shapes if isinstance(shape, Words) and shape.code and shape.size == 11]
    numbers = [float(tick.text.en) for tick in ticks]
    assert numbers[1] / 10 ** len(str(int(numbers[1]))) in {0.1, 0.2, 0.5} or numbers[1] in {0.1, 0.2, 0.5}
    assert 2 <= len(ticks) <= width / 45
    for one, two in pairwise(ticks):
        assert one.x + extent(one.text.en, 11, code=True) / 2 < two.x - extent(two.text.en, 11, code=True) / 2
    edge = [x for x, _ in lines(scene)[0].points][1]
    assert edge == pytest.approx(zero + scale * (until // 2) / size, abs=0.06)


@pytest.mark.parametrize("width", WIDTHS)
def test_everything_stays_on_the_paper(width):
    long = Track("%a long name of a track that nobody could fit", ((0, 0),))
    marks = ((19_900, Text("快到结尾的一个说明", "a remark near the very end")), (0, Text("开始", "start")))
    scene = chart_scene((*TOF, long), 20_000, title=Text("标题" * 40, "title " * 40), width=width, marks=marks)
    assert scene.width == width
    for shape in scene.shapes:
        if isinstance(shape, Words):
            for text in (shape.text.zh, shape.text.en):
                room = extent(text, shape.size, code=shape.code) * 0.9
                left = shape.x - {"start": 0, "middle": room / 2, "end": room}[shape.anchor]
                assert -1 <= left <= left + room <= width + 1, text
        elif isinstance(shape, Stroke):
            assert all(0 <= x <= width and 0 <= y <= scene.height for x, y in shape.points)


@pytest.mark.parametrize("width", WIDTHS)
def test_many_changes_make_few_shapes_and_few_points(width):
    tracks = (
        Track("fast", tuple((at, at % 2) for at in range(60_000))),
        Track("ramp", tuple((10 * at, at) for at in range(6_000)), word=True),
        Track("saw", tuple((at, at % 997) for at in range(60_000)), word=True),
        Track("half", tuple((at * 300, at % 2) for at in range(200))),
        Track("odd", tuple((at, None if at % 3 == 0 else at % 2) for at in range(60_000))),
    )
    scene = chart_scene(tracks, 60_000, title=TITLE, width=width, scans=tuple(range(0, 60_000, 10)))
    assert len(scene.shapes) < 150 + width / 6
    assert max(len(shape.points) for shape in scene.shapes if isinstance(shape, Stroke)) < 4 * width
    assert len(svg(scene, "en")) < 400 * width + 40_000


def test_a_staircase_finer_than_pixels_becomes_a_straight_ramp():
    ramp = Track("T37", tuple((10 * at, at) for at in range(6_001)), word=True)
    (line,) = lines(chart_scene((ramp,), 60_000, title=TITLE))
    assert len(line.points) < 12
    xs = [x for x, _ in line.points]
    assert xs == sorted(xs)


def test_a_pulse_shorter_than_a_pixel_is_still_seen():
    scene = chart_scene((Track("M1", ((0, 0), (30_000, 1), (30_010, 0))),), 60_000, title=TITLE)
    zero, second = axis(scene)
    (line,) = lines(scene)
    low, high = max(y for _, y in line.points), min(y for _, y in line.points)
    assert low - high > 15
    assert all(x == pytest.approx(zero + 30 * second, abs=0.5) for x, y in line.points if y == high)


def test_thinning_loses_no_high_or_low_that_a_pixel_held():
    wild = random.Random(3)
    changes = tuple((at, wild.randrange(1_000)) for at in range(0, 60_000, 7))
    scene = chart_scene((Track("VW0", changes, word=True),), 60_000, title=TITLE)
    (line,) = lines(scene)
    ys = [y for _, y in line.points]
    top, bottom, most = min(ys), max(ys), max(value for _, value in changes)
    zero, second = axis(scene)
    for start in range(0, 60_000, 6_000):
        inside = [value for at, value in changes if start + 200 <= at < start + 5_800]
        held = [y for x, y in line.points if start <= (x - zero) / second * 1_000 < start + 6_000]
        assert min(held) <= bottom - (bottom - top) * max(inside) / most + 0.01


@pytest.mark.parametrize("word", [False, True])
def test_what_nobody_knows_is_a_band_and_not_a_line(word):
    track = Track("T37", ((0, None), (5_000, 0), (10_000, 1), (12_000, None), (14_000, 1)), word=word)
    scene = chart_scene((track,), 20_000, title=TITLE)
    zero, second = axis(scene)
    bands = [shape for shape in scene.shapes if isinstance(shape, Box) and shape.ink == "head"]
    assert [(box.x, box.x + box.width) for box in bands] == [
        pytest.approx((zero + second * first, zero + second * last), abs=0.06) for first, last in ((0, 5), (12, 14))
    ]
    for line in lines(scene):
        xs = [x for x, _ in line.points]
        assert not any(min(xs) < box.x + box.width / 2 < max(xs) for box in bands)
    assert words(scene).count("x") == 2


def test_before_its_first_change_nobody_knows_a_value():
    scene = chart_scene((Track("X0", ((5_000, 1),)), Track("X1", ())), 10_000, title=TITLE)
    assert len([shape for shape in scene.shapes if isinstance(shape, Box) and shape.ink == "head"]) == 2


def test_negative_values_hang_below_zero():
    scene = chart_scene((Track("C48", ((0, 0), (1_000, -4), (3_000, 4)), word=True),), 4_000, title=TITLE)
    (line,) = lines(scene)
    ys = sorted({y for _, y in line.points})
    assert ys[1] == pytest.approx((ys[0] + ys[2]) / 2)
    assert "-4" in words(scene)


def test_scans_are_marked_only_where_they_can_be_seen():
    def marked(step, width=720):
        scene = chart_scene(TOF, 2_000, title=TITLE, scans=tuple(range(0, 2_001, step)), width=width)
        return [shape for shape in scene.shapes if isinstance(shape, Stroke) and shape.ink == "accent"], words(scene)

    seen, told = marked(50)
    assert len(seen) == 41
    assert "ticks: scans" in told
    unseen, silent = marked(10, 300)
    assert not unseen
    assert "ticks: scans" not in silent


def test_no_line_of_a_mark_runs_through_the_words_of_another():
    wild = random.Random(5)
    for _ in range(60):
        marks = tuple((wild.randrange(0, 14_000), same("word" * wild.randint(1, 4))) for _ in range(wild.randint(2, 6)))
        scene = chart_scene(TOF, 20_000, title=TITLE, marks=marks)
        told = [shape for shape in scene.shapes if isinstance(shape, Words) and shape.ink == "accent"]
        flags = [shape for shape in scene.shapes if isinstance(shape, Stroke) and shape.ink == "mark"]
        for flag in flags:
            (x, top), (_, bottom) = flag.points
            for one in told:
                right = one.x + extent(one.text.en, one.size)
                assert not (one.x < x < right and top < one.y < bottom), marks
        assert len({(one.x, one.y) for one in told}) == len(told)


def test_guides_stand_at_the_edges_of_bits():
    scene = chart_scene(TOF[:2], 20_000, title=TITLE, guides=True)
    zero, second = axis(scene)
    guides = [shape.points[0][0] for shape in scene.shapes if isinstance(shape, Stroke) and shape.ink == "dashed"]
    assert guides == pytest.approx([zero + second * at for at in (1, 3, 8, 9, 10, 12, 13, 18)])


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_the_same_chart_goes_to_the_page_and_onto_paper(lang, tmp_path):
    scene = chart_scene(TOF, 20_000, title=TITLE, scans=tuple(range(0, 20_000, 500)), marks=((8_000, same("V = P")),))
    assert Figure(scene, lang).svg().count("<polyline") > 10
    assert "%TM0.Q" in scene.title.in_(lang)
    for kind in ("png", "svg", "pdf"):
        assert mpl.save(scene, tmp_path / f"chart.{kind}", lang).stat().st_size > 2_000


def test_an_empty_chart_is_a_chart():
    assert chart_scene((), 0, title=TITLE).height > 40
