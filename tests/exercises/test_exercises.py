"""Every exercise is its own test: its right programs get full marks, its wrong ones are refused for the reason it promises."""

from __future__ import annotations

from pathlib import Path

import pytest

from plcteach.check.judge import judge, model, reference, shown
from plcteach.check.lint import lint
from plcteach.core.diagnostic import RULES, errors
from plcteach.core.errors import DeclarationError, UnknownNameError
from plcteach.dialects import names
from plcteach.exercises import concept_test, exercise, ids, load, parse
from plcteach.ladder.picture import read_drawing
from plcteach.ladder.telling import is_drawing
from plcteach.machine import run
from plcteach.stl import read

NAMES = (*ids(), *(one.id for one in concept_test()))
RIGHT = [(name, number) for name in NAMES for number in range(len(exercise(name).right))]
WRONG = [(name, number) for name in NAMES for number in range(len(exercise(name).wrong))]


PROGRAMS = {"write", "complete", "bug", "translate", "order"}
"""The kinds whose answer is a program."""


@pytest.mark.parametrize(("name", "number"), RIGHT)
def test_a_right_answer_gets_full_marks(name: str, number: int) -> None:
    one = exercise(name)
    judged = judge(one, one.right[number])
    assert (judged.verdict.status, judged.marks) == ("equal", one.points)
    assert not errors(judged.verdict.diagnostics)
    assert judged.says == ()


@pytest.mark.parametrize(("name", "number"), WRONG)
def test_a_wrong_answer_is_refused_for_the_promised_reason(name: str, number: int) -> None:
    one = exercise(name)
    sample = one.wrong[number]
    judged = judge(one, sample.program)
    verdict = judged.verdict
    assert judged.marks < one.points
    if sample.expect in {"different", "unsettled", "unknown", "equal"}:
        assert verdict.status == sample.expect
        assert sample.expect != "equal" or (one.needs and judged.says), "it does the right thing, and a need is not met"
    else:
        assert sample.expect in RULES
        assert sample.expect in {found.code for found in verdict.diagnostics}
    if verdict.status == "different" and one.kind in PROGRAMS:
        assert verdict.counterexample is not None
        assert judged.program is not None


@pytest.mark.parametrize(("name", "number"), WRONG)
def test_a_counterexample_replays_on_the_plain_machine(name: str, number: int) -> None:
    one = exercise(name)
    judged = judge(one, one.wrong[number].program)
    example = judged.verdict.counterexample
    if example is None or judged.program is None:
        return
    trace = run(judged.program, example.inputs)
    for address, value in example.got[example.scan].items():
        if judged.program.dialect.address(address) is not None:
            assert repr(trace.value(address, example.scan)) == value
    if example.address in example.expected[example.scan]:
        assert example.expected[example.scan][example.address] != example.got[example.scan][example.address]


@pytest.mark.parametrize("name", NAMES)
def test_the_model_answer_gets_full_marks(name: str) -> None:
    one = exercise(name)
    judged = judge(one, model(one))
    assert (judged.verdict.status, judged.marks, judged.says) == ("equal", one.points, ())


@pytest.mark.parametrize("name", NAMES)
def test_what_is_shown_is_something_to_work_with_and_not_the_answer(name: str) -> None:
    one = exercise(name)
    sheet = shown(one)
    assert sheet.ladders or sheet.program or sheet.start or sheet.rows or one.task.en
    assert sheet.start.split() != model(one).split()
    if one.kind == "order":
        assert "\n".join(sheet.rows) not in one.right
        assert all(judge(one, right).verdict.status == "equal" for right in one.right)
    if sheet.form == "grid":
        assert len(sheet.start.splitlines()) == len(sheet.rows)
        assert sheet.columns


@pytest.mark.parametrize("name", NAMES)
def test_an_exercise_is_whole_and_speaks_both_languages(name: str) -> None:
    one = exercise(name)
    assert one.dialect in names()
    assert one.points > 0
    assert one.right, "without a right answer nobody knows that it can be solved"
    assert one.wrong, "without a wrong answer nobody knows what it teaches"
    assert set(one.after) <= set(NAMES)
    assert name not in one.after
    for said in (one.title, one.task, *one.hints, *(sample.because for sample in one.wrong)):
        assert said.zh.strip()
        assert said.en.strip()
        assert not any("\u4e00" <= sign <= "\u9fff" for sign in said.en)
    for said in (one.title, one.task):
        assert any("\u4e00" <= sign <= "\u9fff" for sign in said.zh)
    for number in (*one.misconceptions, *(sample.misconception for sample in one.wrong)):
        assert 0 <= number <= 29
    if one.kind in PROGRAMS - {"translate"}:
        assert not errors(lint(reference(one.reference, one.dialect)))
    for text in (one.reference, one.given, *one.choices):
        if is_drawing(text):
            assert not errors(read_drawing(text)[1])


@pytest.mark.parametrize("name", NAMES)
def test_the_start_is_not_the_answer(name: str) -> None:
    one = exercise(name)
    if one.kind in {"write", "bug"}:
        assert read(one.start, one.dialect).runs
    assert judge(one, one.start).verdict.status != "equal"


@pytest.mark.parametrize("name", NAMES)
def test_an_exercise_comes_after_those_it_builds_on(name: str) -> None:
    one = exercise(name)
    assert all(exercise(before).order <= one.order for before in one.after)


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


KINDS = GOOD.replace('reference = "--[ X0 ]--( Y0 )"\n', "") + 'given = "LD X0\\nOUT Y0"\n'


def test_every_key_of_a_file_arrives() -> None:
    one = parse(
        KINDS
        + """
kind = "chart"
source = "s7-200"
lesson = 3
after = ["one", "two"]
misconceptions = [1, 6]
weights = { outputs = 3, style = 1 }
assume = ["!(X0 & X1)"]
never = ["Y0 & Y1"]
single_change = true
outputs = ["Y0"]
dont_care = { "Y0" = "X1" }
levels = 2
row = 7
choices = ["a", "b"]
distractors = ["ORB"]
hidden = true
scans = [{ X0 = 1, ms = 100 }, {}]
[[need]]
contact = "/Y1"
rung = "Y0"
says = { zh = "要互锁。", en = "An interlock is wanted." }
[[need]]
most = 4
""",
        "mine",
    )
    assert (one.kind, one.given, one.reference, one.source, one.lesson) == (
        "chart", "LD X0\nOUT Y0", "LD X0\nOUT Y0", "s7-200", 3,
    )  # fmt: skip
    assert (one.after, one.misconceptions, one.weights) == (("one", "two"), (1, 6), {"outputs": 3.0, "style": 1.0})
    assert (one.terms.assume, one.terms.never, one.terms.single_change) == (("!(X0 & X1)",), ("Y0 & Y1",), True)
    assert (one.terms.outputs, one.terms.dont_care) == (("Y0",), {"Y0": "X1"})
    assert (one.levels, one.row, one.choices, one.distractors, one.hidden) == (2, 7, ("a", "b"), ("ORB",), True)
    assert one.scans == ({"X0": 1, "ms": 100}, {})
    assert [(need.what, need.value, need.rung, need.says.en) for need in one.needs] == [
        ("contact", "/Y1", "Y0", "An interlock is wanted."),
        ("most", "4", "", ""),
    ]


@pytest.mark.parametrize(
    ("more", "named"),
    [
        ('kind = "essay"\n', "kind"),
        ("weights = { outputs = 0 }\n", "weights"),
        ("weights = { outputs = -1, style = 2 }\n", "weights"),
        ("weights = { beauty = 1 }\n", "weights"),
        ("[[need]]\nsays = { zh = '', en = '' }\n", "need"),
        ("[[need]]\nmost = 4\ncolour = 1\n", "need"),
        ('choices = "a"\n', "choices"),
        ("scans = [1]\n", "scans"),
    ],
)
def test_what_does_not_read_is_named(more: str, named: str) -> None:
    with pytest.raises(DeclarationError, match=named):
        parse(GOOD + more, "mine")
