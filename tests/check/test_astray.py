"""Where a wrong program goes astray, as a teacher would point at it: the misconceptions of the lessons, row by row."""

from __future__ import annotations

import pytest

from plcteach.check.against import verdict_on
from plcteach.check.astray import Astray, astray
from plcteach.check.judge import judge
from plcteach.exercises import exercise, ids
from plcteach.stl import read
from plcteach.widgets.replay import wrong_run

S7, FX = "s7-200", "fx"


def found(wanted: str, mine: str, family: str) -> Astray:
    pair = [read(one.replace(" / ", "\n"), family) for one in (wanted, mine)]
    verdict = verdict_on(*pair)
    assert verdict.counterexample is not None
    return astray(*pair, verdict.counterexample)


@pytest.mark.parametrize(
    ("wanted", "mine", "row", "other", "family"),
    [
        # A binds no tighter than O: the second block wants an LD
        ("LD I0.0 / A I0.1 / LD I0.2 / A I0.3 / OLD / = Q0.0", "LD I0.0 / A I0.1 / O I0.2 / A I0.3 / = Q0.0", 3, "LD I0.2", S7),
        # the joins in the wrong order, and the wrong join
        ("LD I0.0 / A I0.1 / LD I0.2 / A I0.3 / OLD / LD I0.4 / ALD / = Q0.0",
         "LD I0.0 / A I0.1 / LD I0.2 / A I0.3 / LD I0.4 / OLD / ALD / = Q0.0", 6, "OLD", S7),
        ("LD I0.0 / O I0.1 / LD I0.2 / O I0.3 / ALD / = Q0.0", "LD I0.0 / O I0.1 / LD I0.2 / O I0.3 / OLD / = Q0.0", 5, "ALD", S7),
        # an output goes back to no branch by itself
        ("LD I0.0 / LPS / A I0.1 / = Q0.0 / LPP / A I0.2 / = Q0.1", "LD I0.0 / A I0.1 / = Q0.0 / A I0.2 / = Q0.1", 2, "A I0.2", S7),
        # no seal-in; the seal-in round the stop; the wrong contact
        ("LD I0.0 / O Q0.0 / AN I0.1 / = Q0.0", "LD I0.0 / AN I0.1 / = Q0.0", 2, "O Q0.0", S7),
        ("LD X0 / OR Y0 / ANI X1 / OUT Y0", "LD X0 / ANI X1 / OR Y0 / OUT Y0", 2, "OR Y0", FX),
        ("LD I0.0 / AN I0.1 / = Q0.0", "LD I0.0 / A I0.1 / = Q0.0", 2, "AN I0.1", S7),
        ("LDI X0 / OUT Y0", "LD X0 / OUT Y0", 1, "LDI X0", FX),
        # the fault is where the bit comes from
        ("LD I0.0 / TON T37, 50 / LD T37 / = Q0.0", "LD I0.0 / TON T37, 49 / LD T37 / = Q0.0", 2, "TON T37, 50", S7),
        ("LD I0.0 / A I0.1 / = M0.0 / LD M0.0 / = Q0.0", "LD I0.0 / O I0.1 / = M0.0 / LD M0.0 / = Q0.0", 2, "A I0.1", S7),
        # every value is made, the last word is wrong
        ("LD I0.0 / S Q0.0, 1 / LD I0.1 / R Q0.0, 1", "LD I0.1 / R Q0.0, 1 / LD I0.0 / S Q0.0, 1", 4, "R Q0.0, 1", S7),
        ("LD I0.0 / O I0.1 / = Q0.0", "LD I0.0 / = Q0.0 / LD I0.1 / = Q0.0", 4, "= Q0.0", S7),
    ],
)  # fmt: skip
def test_it_points_at_the_row_that_a_teacher_points_at(
    wanted: str, mine: str, row: int, other: str, family: str
) -> None:
    one = found(wanted, mine, family)
    assert one.line == row - 1
    assert mine.split(" / ")[row - 1] in one.says.en
    assert mine.split(" / ")[row - 1] in one.says.zh
    assert one.other is not None
    assert wanted.split(" / ")[one.other] == other
    assert other not in one.says.en or other == mine.split(" / ")[row - 1]


def test_the_same_contacts_in_another_order_are_not_astray() -> None:
    wanted = "LD I0.0 / A I0.1 / A I0.2 / LD I0.3 / A I0.4 / OLD / = Q0.0"
    mine = "LD I0.4 / A I0.3 / LD I0.2 / A I0.0 / AN I0.1 / OLD / = Q0.0"
    assert found(wanted, mine, S7).line == 4, "only AN I0.1 is wrong"


def test_a_helper_bit_of_the_learners_own_is_not_astray() -> None:
    mine = "LD I0.0 / = M5.0 / LD M5.0 / A I0.1 / = Q0.0"
    assert found("LD I0.0 / AN I0.1 / = Q0.0", mine, S7).line == 3


def test_an_output_that_nobody_writes_is_said_so() -> None:
    one = found("LD I0.0 / = Q0.0 / = Q0.1", "LD I0.0 / = Q0.0", S7)
    assert one.line is None
    assert "Q0.1" in one.says.zh


@pytest.mark.parametrize("name", [name for name in ids() if exercise(name).wrong])
def test_every_wrong_sample_can_be_shown(name: str) -> None:
    for sample in exercise(name).wrong:
        judgement = judge(name, sample.program)
        replay = wrong_run(judgement)
        if judgement.verdict.counterexample and judgement.program:
            assert replay is not None
            assert replay.beside["say"]["zh"]


def test_a_rung_of_hundreds_of_lines_is_no_trouble() -> None:
    wanted = "LD I0.0\n" + "A I0.1\nO I0.2\n" * 700 + "= Q0.0"
    pair = read(wanted, S7), read(wanted.replace("= Q0.0", "AN I0.3\n= Q0.0"), S7)
    verdict = verdict_on(*pair)
    assert verdict.counterexample is not None
    assert astray(*pair, verdict.counterexample).line == 1401
