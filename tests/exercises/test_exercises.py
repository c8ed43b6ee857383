"""Every exercise is its own test: its right programs get full marks, its wrong ones are refused for the reason it promises."""

from __future__ import annotations

from pathlib import Path

import pytest

from plcteach.check.judge import judge, reference
from plcteach.check.lint import lint
from plcteach.core.diagnostic import RULES, errors
from plcteach.core.errors import DeclarationError, UnknownNameError
from plcteach.dialects import names
from plcteach.exercises import exercise, ids, load, parse
from plcteach.ladder.picture import read_drawing
from plcteach.ladder.telling import is_drawing
from plcteach.stl import read

RIGHT = [(name, number) for name in ids() for number in range(len(exercise(name).right))]
WRONG = [(name, number) for name in ids() for number in range(len(exercise(name).wrong))]


@pytest.mark.parametrize(("name", "number"), RIGHT)
def test_a_right_program_gets_full_marks(name: str, number: int) -> None:
    one = exercise(name)
    judged = judge(one, one.right[number])
    assert (judged.verdict.status, judged.marks) == ("equal", one.points)
    assert not errors(judged.verdict.diagnostics)


@pytest.mark.parametrize(("name", "number"), WRONG)
def test_a_wrong_program_is_refused_for_the_promised_reason(name: str, number: int) -> None:
    one = exercise(name)
    sample = one.wrong[number]
    judged = judge(one, sample.program)
    verdict = judged.verdict
    assert judged.marks < one.points
    if sample.expect == "different":
        assert verdict.status == "different"
        assert verdict.counterexample is not None
    else:
        assert sample.expect in RULES
        assert sample.expect in {found.code for found in verdict.diagnostics}
        assert verdict.status != "equal"


@pytest.mark.parametrize("name", ids())
def test_an_exercise_is_whole_and_speaks_both_languages(name: str) -> None:
    one = exercise(name)
    assert one.dialect in names()
    assert one.points > 0
    assert one.right, "without a right program nobody knows that it can be solved"
    assert one.wrong, "without a wrong program nobody knows what it teaches"
    for said in (one.title, one.task, *one.hints, *(sample.because for sample in one.wrong)):
        assert said.zh.strip()
        assert said.en.strip()
        assert any("\u4e00" <= sign <= "\u9fff" for sign in said.zh)
        assert not any("\u4e00" <= sign <= "\u9fff" for sign in said.en)
    assert not errors(lint(reference(one.reference, one.dialect)))
    if is_drawing(one.reference):
        assert not errors(read_drawing(one.reference)[1])


@pytest.mark.parametrize("name", ids())
def test_the_start_is_readable_and_not_the_answer(name: str) -> None:
    one = exercise(name)
    assert read(one.start, one.dialect).runs
    assert judge(one, one.start).verdict.status != "equal"


def test_exercises_come_in_teaching_order_and_by_name() -> None:
    orders = [(exercise(name).order, name) for name in ids()]
    assert orders == sorted(orders)
    assert exercise(exercise("s7-two-blocks")) is exercise("s7-two-blocks")
    assert repr(exercise("s7-two-blocks")).startswith("Exercise('s7-two-blocks', ")
    with pytest.raises(UnknownNameError, match="s7-two-blocks"):
        exercise("s7-two-bloks")


# A teacher's own file.

GOOD = """
dialect = "fx"
title = { zh = "自锁", en = "seal-in" }
task = { zh = "写出来。", en = "Write it." }
reference = "--[ X0 ]--( Y0 )"
"""
SAMPLE = '\n[[wrong]]\nexpect = "different"\nprogram = "LDI X0"\nbecause = { zh = "反了", en = "turned round" }\n'


def test_a_teachers_own_file_is_read(tmp_path: Path) -> None:
    path = tmp_path / "seal-in.toml"
    path.write_text(GOOD + "points = 2.5\norder = 3\n" + SAMPLE, encoding="utf-8")
    one = load(path)
    assert (one.id, one.dialect, one.points, one.order, one.title.zh) == ("seal-in", "fx", 2.5, 3, "自锁")
    assert one.wrong[0].expect == "different"
    assert judge(one, "LD X0\nOUT Y0\n").marks == 2.5
    plain = parse(GOOD, "x")
    assert (plain.points, plain.start, plain.hints, plain.right) == (4.0, "", (), ())


def test_a_file_may_ask_for_a_level() -> None:
    assert parse(GOOD, "mine").level == "either"
    assert parse(GOOD + 'level = "exact"\n', "mine").level == "exact"
    with pytest.raises(DeclarationError, match="level"):
        parse(GOOD + 'level = "roughly"\n', "mine")


def test_a_family_that_nobody_knows_is_named_when_it_is_needed() -> None:
    with pytest.raises(UnknownNameError, match="fxx"):
        judge(parse(GOOD.replace('"fx"', '"fxx"'), "mine"), "LD X0")


@pytest.mark.parametrize(
    ("toml", "named"),
    [
        ("not toml at all = = =", "mine"),
        (GOOD.replace('dialect = "fx"\n', ""), "dialect"),
        (GOOD.replace("reference", "referenz"), "referenz"),
        (GOOD + "colour = 1\n", "colour"),
        (GOOD.replace('title = { zh = "自锁", en = "seal-in" }', 'title = "seal-in"'), "title"),
        (GOOD.replace('zh = "自锁", ', ""), "title"),
        (GOOD + SAMPLE.replace('program = "LDI X0"\n', ""), "program"),
        (GOOD + SAMPLE.replace('expect = "different"\n', ""), "expect"),
        (GOOD + "\n[[right]]\nprogramm = 'LD X0'\n", "program"),
        (GOOD + "points = 'many'\n", "points"),
        (GOOD + SAMPLE.replace('"different"', '"STK999"'), "STK999"),
    ],
)
def test_a_file_that_is_incomplete_says_what_is_wrong_with_it(toml: str, named: str) -> None:
    with pytest.raises(DeclarationError, match=named) as caught:
        parse(toml, "mine")
    assert "mine" in str(caught.value)
