"""A counterexample as a timing chart, held against the picture in the design's notes and against its own scans."""

from __future__ import annotations

from plcteach.check.chart import MOST_COLUMNS, chart_of
from plcteach.check.chart_scene import counterexample_scene
from plcteach.check.judge import reference, verdict_on
from plcteach.core.verdict import Counterexample, Verdict
from plcteach.figure.scene import Words
from plcteach.figure.svg import svg
from plcteach.ladder.symbols import columns


def verdict(wanted: str, got: str) -> Verdict:
    return verdict_on(reference(wanted, "s7-200"), reference(got, "s7-200"))


STAR = "LD I0.0\nTON T37, {}\nLD I0.0\nAN T37\n= Q0.1\n"


def test_star_delta_49_for_50() -> None:
    """The picture in CHECKING: held for 4.9 s both are on, and then only the one that waits for 50 steps still is."""
    chart = chart_of(verdict(STAR.format(50), STAR.format(49)))
    assert chart is not None
    assert [one.en for one in chart.lines] == [
        "hold           4.9 s 1 scan",
        "I0.0           ##### ######",
        "Q0.1 expected  ##### ######",
        "Q0.1 yours     ##### ______  <- differs",
    ]
    assert [one.zh for one in chart.lines] == [
        "保持       4.9 s 1个扫描",
        "I0.0       ##### #######",
        "Q0.1 应为  ##### #######",
        "Q0.1 你的  ##### _______  <- 不同",
    ]
    assert (chart.at, chart.timed, chart.left) == (1, True, 0)


def test_columns_are_scans_in_which_nothing_changes() -> None:
    inputs = ({"I0.0": 1}, {}, {}, {"I0.0": 0}, {"I0.1": 1})
    wanted = tuple({"Q0.0": one} for one in "11100")
    got = tuple({"Q0.0": one} for one in "1110x")
    chart = chart_of(Verdict("different", None, Counterexample(inputs, wanted, got, 4, "Q0.0")))
    assert chart is not None
    assert [(one.first, one.scans) for one in chart.columns] == [(0, 3), (3, 1), (4, 1)]
    assert [row.values for row in chart.rows] == [
        ("1", "0", "0"),
        ("0", "0", "1"),
        ("1", "0", "0"),
        ("1", "0", "x"),
    ]
    assert chart.rows[-1].differs == (False, False, True)
    assert chart.at == 2
    assert chart.lines[0].en == "scans          3    1    1"
    assert chart.lines[-1].en == "Q0.0 yours     #### ____ xxxx  <- differs"


def test_of_a_long_story_the_end_is_shown() -> None:
    count = 90
    inputs = tuple({"I0.0": number % 2} for number in range(count))
    wanted = tuple({"Q0.0": "0"} for _ in range(count))
    got = (*wanted[:-1], {"Q0.0": "1"})
    chart = chart_of(Verdict("different", None, Counterexample(inputs, wanted, got, count - 1, "Q0.0")))
    assert chart is not None
    assert (len(chart.columns), chart.left, chart.at) == (MOST_COLUMNS, count - MOST_COLUMNS, MOST_COLUMNS - 1)
    assert chart.lines[0].en == f"… ({count - MOST_COLUMNS} columns before these)"


def test_of_many_inputs_only_those_are_shown_that_are_ever_on() -> None:
    inputs = ({f"I{number // 8}.{number % 8}": int(number == 5) for number in range(40)},)
    chart = chart_of(Verdict("different", None, Counterexample(inputs, ({"Q0.0": "1"},), ({"Q0.0": "0"},), 0, "Q0.0")))
    assert chart is not None
    assert [row.address for row in chart.rows] == ["I0.5", "Q0.0", "Q0.0"]
    assert chart.lines[-1].en == "All other inputs are 0."
    assert chart.lines[-1].zh == "其余输入都是0。"


def test_the_output_that_differs_comes_first_and_rows_line_up_in_both_languages() -> None:
    chart = chart_of(verdict("LD I0.0\n= Q0.0\nLD I0.1\n= Q0.1\n", "LD I0.0\n= Q0.0\nLDN I0.1\n= Q0.1\n"))
    assert chart is not None
    assert [row.address for row in chart.rows if row.kind == "got"] == ["Q0.1", "Q0.0"]
    for lang in ("zh", "en"):
        signs = [one.in_(lang).split("  <-")[0] for one in chart.lines[1:]]
        assert len({columns(one) for one in signs}) == 1


def test_a_verdict_without_a_counterexample_has_no_chart() -> None:
    assert chart_of(verdict("LD I0.0\n= Q0.0\n", "LD I0.0\n= Q0.0\n")) is None
    assert counterexample_scene(Verdict("error")) is None


def test_the_picture_names_every_row_and_marks_the_difference() -> None:
    scene = counterexample_scene(verdict(STAR.format(50), STAR.format(49)))
    assert scene is not None
    words = [shape.text.en for shape in scene.shapes if isinstance(shape, Words)]
    assert words.count("≠") == 1
    for wanted in ("4.9 s", "1 scan", "I0.0", "Q0.1 expected", "Q0.1 yours", "differs here"):
        assert wanted in words
    for shape in scene.shapes:
        if isinstance(shape, Words):
            assert 0 <= shape.x <= scene.width
            assert 0 <= shape.y <= scene.height
    assert "应为" in svg(scene, "zh")


def test_words_are_shown_as_numbers() -> None:
    example = Counterexample(({"VW0": 5},), ({"QW0": "12"},), ({"QW0": "-7"},), 0, "QW0")
    chart = chart_of(Verdict("different", None, example))
    assert chart is not None
    assert chart.lines[-1].en == "QW0 yours     -7    <- differs"
    assert counterexample_scene(Verdict("different", None, example)) is not None
