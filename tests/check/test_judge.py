"""A submission judged: what is said of it, in which order, and how many marks it gets."""

from __future__ import annotations

from dataclasses import replace

import pytest

from plcteach.check.judge import judge, reference, verdict_on
from plcteach.check.report import headline, table, verdict_json
from plcteach.core.errors import PlcTeachError, UnknownNameError
from plcteach.core.exercise import Exercise, Terms
from plcteach.core.text import Text
from plcteach.stl import read

TWO = """
--[ I0.0 ]--+--[ I0.1 ]--( Q0.0 )
            +--[/I0.2 ]--( Q0.1 )
"""


def task(drawing: str = TWO, points: float = 4.0, dialect: str = "s7-200") -> Exercise:
    words = Text("例", "an example")
    return Exercise("mine", dialect, words, words, drawing, points=points)


RIGHT = "LD I0.0\nLPS\nA I0.1\n= Q0.0\nLPP\nAN I0.2\n= Q0.1\n"


@pytest.mark.parametrize(
    ("text", "status", "marks"),
    [
        (RIGHT, "equal", 4.0),
        ("LD I0.0\nA I0.1\n= Q0.0\nLD I0.0\nAN I0.2\n= Q0.1\n", "equal", 4.0),
        ("LD I0.0\nA I0.1\n= Q0.0\nLD I0.0\nA I0.2\n= Q0.1\n", "different", 1.0),
        ("LD I0.0\nA I0.1\n= Q0.0\n", "different", 1.0),
        ("LD I0.0\n= Q0.0\n= Q0.1\n", "different", 0.0),
        ("LD I0.0\nA I0.1\n= Q0.0\nLPP\nAN I0.2\n= Q0.1\n", "error", 0.0),
        ("LD I0.9\n= Q0.0\n", "error", 0.0),
        ("", "error", 0.0),
        ("// nothing but a comment\n", "error", 0.0),
        ("\x00\x01\x02", "error", 0.0),
        (b"\xff\xfe\x00", "error", 0.0),
        (RIGHT.encode("utf-16"), "equal", 4.0),
    ],
)
def test_status_and_marks(text: str | bytes, status: str, marks: float) -> None:
    judged = judge(task(), text)
    assert (judged.verdict.status, judged.marks) == (status, marks)
    assert repr(judged) == f"Judgement(mine: {status}, {marks:g}/4)"


@pytest.mark.parametrize("points", [1.0, 10.0, 2.5])
def test_marks_are_out_of_the_exercises_points(points: float) -> None:
    assert judge(task(points=points), RIGHT).marks == points
    assert judge(task(points=points), "LD I0.0\nA I0.1\n= Q0.0\n").marks == pytest.approx(points / 4, abs=0.01)


def test_findings_stand_in_the_verdict_beside_what_the_comparison_says() -> None:
    text = "LD I0.0\nLPS\nA I0.1\n= Q0.0\nLRD\nAN I0.2\n= Q0.1\n= Q0.5\n"
    verdict = judge(task(), text).verdict
    assert [(one.code, one.severity) for one in verdict.diagnostics] == [("STK006", "warning"), ("CHK001", "warning")]
    assert verdict.status == "equal"


def test_an_error_is_told_with_its_row_first() -> None:
    judged = judge(task(), "LD I0.0\nOLD\n= Q0.0\n")
    assert headline(judged).en.startswith("Row 2: OLD needs 2 values")
    assert headline(judged).zh.startswith("第2行：OLD要用2个值")
    empty = headline(judge(task(), ""))
    assert "no program yet" in empty.en
    assert "还没有程序" in empty.zh


def test_a_difference_is_told_with_its_inputs_the_expected_and_the_actual_value() -> None:
    judged = judge(task("--[ I0.0 ]--[ I0.1 ]--( Q0.0 )"), "LD I0.0\nO I0.1\n= Q0.0\n")
    told = headline(judged)
    assert told.en == "With I0.0=1, I0.1=0, Q0.0 should be 0; your program gives 1."
    assert told.zh == "当I0.0=1, I0.1=0时，Q0.0应为0，你的程序给出1。"
    assert [(row.address, row.kind, row.value, row.differs) for row in table(judged.verdict)] == [
        ("I0.0", "input", "1", False),
        ("I0.1", "input", "0", False),
        ("Q0.0", "expected", "0", False),
        ("Q0.0", "got", "1", True),
    ]


def test_a_difference_in_a_later_scan_says_which() -> None:
    sealed = task("--[ I0.0 ]--+--[/I0.1 ]--( Q0.0 )\n--[ Q0.0 ]--+")
    judged = judge(sealed, "LD I0.0\nAN I0.1\n= Q0.0\n")
    assert "(scan 2)" in headline(judged).en
    assert "第2个扫描" in headline(judged).zh
    assert table(judged.verdict)[0].value == "0"


@pytest.mark.parametrize(
    ("drawing", "text", "zh", "en"),
    [
        ("--[ I0.0 ]--( Q0.0 )", "LD I0.0\n= Q0.0\n", "与参考完全一样", "line for line"),
        ("--[ I0.0 ]--( Q0.0 )", "LDN I0.0\nNOT\n= Q0.0\n", "所有输入组合", "every combination"),
        ("--[P I0.0 ]--( Q0.0 )", "LD I0.0\nEU\nNOT\nNOT\n= Q0.0\n", "任意多个扫描", "any number of scans"),
    ],
)
def test_a_right_program_is_told_how_that_is_known(drawing: str, text: str, zh: str, en: str) -> None:
    told = headline(judge(task(drawing), text))
    assert zh in told.zh
    assert en in told.en
    assert "4/4" in told.zh
    assert "4 of 4" in told.en


def test_what_is_not_known_is_said_honestly() -> None:
    bits = [f"I{number // 8}.{number % 8}" for number in range(21)]
    text = "\n".join([f"LD {bits[0]}", *(f"A {bit}" for bit in bits[1:]), "= Q0.0"])
    judged = judge(task("\n".join([f"LD {bits[-1]}", *(f"A {bit}" for bit in bits[:-1]), "= Q0.0"])), text)
    assert judged.verdict.status == "unknown"
    assert judged.marks == 0
    assert "No difference was found" in headline(judged).en


def test_the_desk_gets_plain_data() -> None:
    sent = verdict_json(judge(task("--[ I0.0 ]--( Q0.0 )"), "LDN I0.0\n= Q0.0\n"))
    assert (sent["status"], sent["marks"], sent["max"], sent["canShow"]) == ("different", 0.0, 4.0, True)
    assert sent["outputs"] == {"Q0.0": "different"}
    assert sent["rows"][-1] == {
        "address": "Q0.0", "kind": "got", "value": "1", "label": {"zh": "你的程序", "en": "yours"}, "differs": True,
    }  # fmt: skip
    right = verdict_json(judge(task("--[ I0.0 ]--( Q0.0 )"), "LD I0.0\n= Q0.0\n"))
    assert (right["rows"], right["canShow"]) == ([], False)


PULSE = "--[P I0.0 ]--( Q0.0 )"
NEVER = "LD I0.0\nAN I0.0\n= Q0.0\n"


def test_an_exercise_about_pulses_asks_for_exact() -> None:
    exact = replace(task(PULSE), terms=Terms(level="exact"))
    assert judge(exact, NEVER).verdict.status == "different"
    assert judge(exact, NEVER).marks == 0
    assert judge(exact, "LD I0.0\nEU\n= Q0.0\n").marks == 4


def test_a_right_program_that_reacts_later_is_right_and_told_so() -> None:
    late = "LD M0.0\nA I0.1\n= Q0.0\nLD I0.0\n= M0.0\n"
    judged = judge(task("--[ I0.0 ]--[ I0.1 ]--( Q0.0 )"), late)
    assert (judged.verdict.status, judged.verdict.level, judged.marks) == ("equal", "settled", 4)
    assert [(one.code, one.severity) for one in judged.verdict.diagnostics] == [("CHK003", "info")]
    assert judge(replace(judged.exercise, terms=Terms(level="exact")), late).verdict.status == "different"


# References.


def test_a_reference_is_a_drawing_or_a_list_in_the_exercises_family() -> None:
    drawn = reference("--[ X0 ]--+--[/X1 ]--( Y0 )\n--[ Y0 ]--+", "fx")
    assert [line.text for line in drawn.lines] == ["LD X0", "OR Y0", "ANI X1", "OUT Y0"]
    assert reference("LD X0\nOUT Y0\n", "fx").dialect.name == "fx"


@pytest.mark.parametrize(
    ("text", "dialect"),
    [
        ("--[ I0.0 ]--", "s7-200"),
        ("LD I0.0\nOLD\n= Q0.0\n", "s7-200"),
        ("LD I0.9\n= Q0.0\n", "s7-200"),
        ("--[ X0 ]--( Y0 )", "s7-200"),
        ("", "s7-200"),
        ("LD I0.0\n", "s7-200"),
    ],
)
def test_a_reference_that_is_wrong_itself_is_the_teachers_and_an_exception(text: str, dialect: str) -> None:
    with pytest.raises(PlcTeachError):
        reference(text, dialect)


def test_an_exercise_that_nobody_has_written() -> None:
    with pytest.raises(UnknownNameError, match="s7-two-blocks"):
        judge("s7-two-block", "LD I0.0")


def test_a_verdict_without_an_exercise() -> None:
    wanted = reference("LD I0.0\n= Q0.0\n", "s7-200")
    assert verdict_on(wanted, read("LD I0.0\nO I0.0\n= Q0.0\n", "s7-200")).status == "equal"
    assert repr(verdict_on(wanted, wanted)) == "Verdict(equal, by structural)"
    assert repr(verdict_on(wanted, read("", "s7-200"))) == "Verdict(error)"
