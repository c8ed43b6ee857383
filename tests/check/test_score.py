"""Marks as a grader takes them: a bare finite number between nothing and full, with the report beside it and silence on stderr."""

from __future__ import annotations

import copy
import json
import math
import pickle
import subprocess
import sys
from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plcteach.check.judge import judge
from plcteach.check.score import Score, grade
from plcteach.core import text as words
from plcteach.exercises import ids


@pytest.fixture(autouse=True)
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(words, "_chosen", ["en"])


RIGHT = "LD I0.0\nA I0.1\nLD I0.2\nAN I0.3\nOLD\n= Q0.0\n"
WRONG = "LD I0.0\nA I0.1\nO I0.2\nAN I0.3\n= Q0.0\n"


@pytest.mark.parametrize(
    ("marks", "maximum", "wanted"),
    [
        (2.5, 4, 2.5),
        (4, 4, 4.0),
        (5, 4, 4.0),
        (4.000001, 4, 4.0),
        (-1, 4, 0.0),
        (0, 4, 0.0),
        (math.nan, 4, 0.0),
        (-math.inf, 4, 0.0),
        (True, 4, 1.0),
        (False, 4, 0.0),
        (3, 0, 0.0),
    ],
)
def test_marks_are_clamped_and_finite(marks: float, maximum: float, wanted: float) -> None:
    score = Score(marks, maximum)
    assert float(score) == wanted
    assert math.isfinite(score)


def test_an_infinite_number_of_marks_is_no_full_marks_by_accident() -> None:
    score = Score(math.inf, 4)
    assert math.isfinite(score)
    assert 0 <= score <= 4


@given(st.floats(), st.floats(0, 1000))
def test_whatever_comes_in_a_number_between_nothing_and_full_comes_out(marks: float, maximum: float) -> None:
    score = Score(marks, maximum)
    assert math.isfinite(score)
    assert 0 <= score <= maximum


def test_it_is_a_plain_number_to_everyone_who_looks() -> None:
    score = grade("s7-two-blocks", RIGHT)
    assert isinstance(score, float)
    assert not isinstance(score, bool)
    assert (repr(score), str(score), f"{score}") == ("4.0", "4.0", "4.0")
    assert float(repr(grade("s7-two-blocks", WRONG))) == 0.0
    assert json.dumps({"score": score}) == '{"score": 4.0}'
    assert Decimal(repr(Score(2.5, 4))) == Decimal("2.5")
    assert score + 1 == 5.0
    assert score == 4
    assert sorted([Score(3, 4), Score(1, 4)]) == [1.0, 3.0]


def test_the_report_carries_the_counterexample_and_is_escaped() -> None:
    html = grade("s7-two-blocks", WRONG)._repr_html_()
    assert "should be" in html
    assert "≠" in html
    for hostile in (
        "<script>alert(1)</script>",
        "LD <img/src=x>",
        "LD I0.0\n= <b>",
        "LD I0.0 &amp;<i>",
        '"><svg/onload=1>',
    ):
        shown = grade("s7-two-blocks", hostile)._repr_html_()
        for tag in ("<script", "<img", "<b>", "<i>", "<svg"):
            assert tag not in shown
    assert Score(1, 4)._repr_html_() == "1.0"


def test_the_report_speaks_the_language_in_force(monkeypatch: pytest.MonkeyPatch) -> None:
    score = grade("s7-two-blocks", WRONG)
    assert "your program gives" in score._repr_html_()
    monkeypatch.setattr(words, "_chosen", ["zh"])
    assert "你的程序给出" in score._repr_html_()
    monkeypatch.setattr(words, "_chosen", ["en"])
    finding = grade("s7-two-blocks", "LD I0.0\nOLD\n= Q0.0")
    assert "STK001" in finding._repr_html_()
    assert "row 2: " in finding._repr_html_()


def test_assert_correct_raises_with_the_counterexample_in_its_first_line() -> None:
    grade("s7-two-blocks", RIGHT).assert_correct()
    with pytest.raises(AssertionError) as caught:
        grade("s7-two-blocks", WRONG).assert_correct()
    first = str(caught.value).splitlines()[0]
    example = judge("s7-two-blocks", WRONG).verdict.counterexample
    assert example is not None
    for address, value in example.inputs[-1].items():
        assert f"{address}={value}" in first
    assert f"Q0.0 should be {example.expected[-1]['Q0.0']}" in first
    assert f"gives {example.got[-1]['Q0.0']}" in first


@pytest.mark.parametrize("text", ["", "LD I0.0\nOLD\n= Q0.0", "nonsense"])
def test_assert_correct_of_what_cannot_be_compared_says_why(text: str) -> None:
    with pytest.raises(AssertionError, match=r"Row \d|no program yet"):
        grade("s7-two-blocks", text).assert_correct()


def test_the_solution_marks_of_a_grader_may_stand_inside_the_text() -> None:
    text = f"### BEGIN SOLUTION\n{RIGHT}### END SOLUTION\n"
    assert grade("s7-two-blocks", text) == 4.0


HOSTILE = [
    RIGHT,
    WRONG,
    "",
    "LD I0.0\nOLD",
    "\x00",
    "x" * 100_000,
    "LD\n" * 3_000,
    "(*",
    "Network 1\n" * 500,
    "💥;" * 200,
]


@pytest.mark.parametrize("text", HOSTILE, ids=range(len(HOSTILE)))
def test_nothing_goes_to_stderr_and_the_same_text_gets_the_same_report(
    text: str, capfd: pytest.CaptureFixture[str]
) -> None:
    one, other = (grade("s7-two-blocks", text) for _ in range(2))
    assert (float(one), one._repr_html_()) == (float(other), other._repr_html_())
    out, err = capfd.readouterr()
    assert (out, err) == ("", "")


def test_grading_opens_no_screen_and_no_window_to_the_world() -> None:
    code = (
        "import sys, plcteach\n"
        f"score = plcteach.grade('s7-two-blocks', {WRONG!r})\n"
        "score._repr_html_()\n"
        "try: score.assert_correct()\n"
        "except AssertionError: pass\n"
        "heavy = {'anywidget', 'ipywidgets', 'IPython', 'traitlets', 'matplotlib', 'numpy', 'socket', 'urllib.request'}\n"
        "print(repr(score), sorted(heavy & set(sys.modules)))\n"
    )
    done = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=True)
    assert (done.stdout.strip(), done.stderr) == ("0.0 []", "")


@pytest.mark.parametrize("name", ids())
def test_no_exercise_gives_marks_for_an_empty_page_or_for_its_own_start(name: str) -> None:
    from plcteach.exercises import exercise

    assert grade(name, "") == 0.0
    assert grade(name, exercise(name).start) < exercise(name).points


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))])  # noqa: S301
def test_a_score_comes_back_whole_from_a_copy_and_from_another_process(again) -> None:
    score = grade("s7-two-blocks", WRONG)
    other = again(score)
    assert (type(other), other, repr(other)) == (Score, score, repr(score))
    assert other._repr_html_() == score._repr_html_()


# Cases, for graders that count what passes.

TWO_OUTPUTS = """
dialect = "s7-200"
points = 4
title = { zh = "两个输出", en = "two outputs" }
task = { zh = "写出来。", en = "Write it." }
reference = "LD I0.0\\n= Q0.0\\nLD I0.1\\n= Q0.1\\n"
"""


def passed(score: Score) -> list[tuple[str, float, bool]]:
    found = []
    for name, points, check in score.cases():
        try:
            check()
            found.append((name, points, True))
        except AssertionError:
            found.append((name, points, False))
    return found


def test_each_output_is_a_case_and_all_of_them_are_another() -> None:
    from plcteach.exercises import parse

    one = parse(TWO_OUTPUTS, "two")
    half = grade(one, "LD I0.0\n= Q0.0\nLDN I0.1\n= Q0.1\n")
    assert passed(half) == [("output Q0.0", 1.0, True), ("output Q0.1", 1.0, False), ("all outputs", 2.0, False)]
    assert sum(points for _, points, right in passed(half) if right) == half == 1.0
    with pytest.raises(AssertionError, match=r"Q0\.1 should be"):
        list(half.cases())[1][2]()
    nothing = grade(one, "")
    assert [right for *_, right in passed(nothing)] == [False] * 3
    assert [case[:2] for case in passed(nothing)] == [case[:2] for case in passed(half)]


@pytest.mark.parametrize("name", ids())
def test_the_cases_of_every_exercise_add_up_and_do_not_depend_on_the_answer(name: str) -> None:
    from plcteach.check.judge import model
    from plcteach.exercises import exercise

    one = exercise(name)
    answers = [model(one), one.wrong[0].program, ""]
    cases = [passed(grade(one, answer)) for answer in answers]
    assert cases[0]
    assert all(right for *_, right in cases[0])
    assert sum(points for _, points, _ in cases[0]) == pytest.approx(one.points, abs=0.01)
    for other in cases[1:]:
        assert [case[:2] for case in other] == [case[:2] for case in cases[0]]
    reached = sum(points for _, points, right in cases[1] if right)
    assert reached <= grade(one, one.wrong[0].program) + 0.01
    assert not any(right for *_, right in cases[2])


def test_a_score_without_a_judgement_has_no_cases() -> None:
    assert list(Score(1, 4).cases()) == []


def test_a_right_program_that_lacks_what_the_task_asks_for_is_not_correct_yet() -> None:
    from plcteach.exercises import parse

    one = parse(TWO_OUTPUTS + "[[need]]\nuses = 'NOT'\n", "two")
    score = grade(one, "LD I0.0\n= Q0.0\nLD I0.1\n= Q0.1\n")
    assert score == 3.0
    with pytest.raises(AssertionError, match="asks for NOT"):
        score.assert_correct()
    assert sum(points for _, points, right in passed(score) if right) == 3.0
