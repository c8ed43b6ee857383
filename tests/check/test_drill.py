"""Random exercises: the same everywhere, none of them trivial, each solvable, its right answers accepted and its wrong ones refused."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from statistics import mean
from typing import TYPE_CHECKING

import pytest

from plcteach.check.drill import ASKS, drill, from_id
from plcteach.check.drilling.shapes import KINDS
from plcteach.check.judge import judge, model, shown
from plcteach.check.lint import lint
from plcteach.core.errors import PlcTeachError, UnknownNameError
from plcteach.core.ladder import Coil, Contact
from plcteach.dialects import families, names
from plcteach.ladder.meaning import meaning
from plcteach.ladder.picture import read_drawing
from plcteach.machine.rows import Rows
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.exercise import Exercise
    from plcteach.machine.signals import Column

FAMILIES = tuple(one.name for one in families())
LEVELS = (1, 2, 3, 4, 5)
BITS_ONLY = ("contacts", "blocks", "branches")


def seeds(*words: object) -> int:
    """Give a seed that differs from case to case."""
    return sum(ord(sign) * (place + 7) for place, sign in enumerate("/".join(map(str, words)))) % 1_000


def refused(exercise: Exercise, number: int) -> bool:
    sample = exercise.wrong[number]
    judged = judge(exercise, sample.program)
    codes = {one.code for one in judged.verdict.diagnostics}
    reason = sample.expect in codes if sample.expect[-1].isdigit() else judged.verdict.status == sample.expect
    return judged.marks < exercise.points and judged.verdict.status != "equal" and reason


# Each is its own test.


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("dialect", FAMILIES)
def test_a_drill_is_its_own_test(dialect: str, kind: str, level: int) -> None:
    one = drill(kind, seeds(dialect, kind, level), level, dialect)
    assert len(one.right) >= 2
    assert len(one.wrong) >= 3
    assert not lint(read(one.right[0], dialect)), "the model answer has nothing to remark, and keeps within the stack"
    for answer in (model(one), *one.right):
        judged = judge(one.id, answer)
        assert (judged.verdict.status, judged.marks) == ("equal", one.points), answer
    for number in range(len(one.wrong)):
        assert refused(one, number), one.wrong[number]


@pytest.mark.parametrize("ask", ASKS[1:])
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("dialect", FAMILIES)
def test_so_is_every_other_question_about_it(dialect: str, kind: str, ask: str) -> None:
    if ask == "join" and kind != "blocks":
        with pytest.raises(PlcTeachError, match="join"):
            drill(kind, 1, 2, dialect, ask)
        return
    seed = seeds(dialect, kind, ask)
    one = drill(kind, seed, 1 + seed % 5, dialect, ask)
    assert one.kind == ask
    assert shown(one).rows or ask == "match"
    assert len(one.wrong) >= 3
    for answer in (model(one), *one.right):
        assert judge(one.id, answer).marks == one.points, answer
    for number in range(len(one.wrong)):
        assert refused(one, number), one.wrong[number]


@pytest.mark.parametrize("dialect", FAMILIES)
def test_hundreds_of_drills_keep_within_the_stack_and_draw_as_they_are(dialect: str) -> None:
    for kind in KINDS:
        for level in LEVELS:
            for seed in range(6):
                one = drill(kind, seed, level, dialect)
                assert not lint(read(one.right[0], dialect)), one.id
                assert not read_drawing(one.reference)[1], one.id


# The same everywhere.


def test_the_same_words_make_the_same_drill_in_another_process() -> None:
    code = "from plcteach import drill; print([repr(vars_) for one in range(4) for vars_ in [drill('blocks', one, 5).reference, drill('timers', one, 4, 'neza', 'predict').right]])"
    said = [
        subprocess.run(
            [sys.executable, "-c", code],
            capture_output=True,
            text=True,
            check=True,
            env={**os.environ, "PYTHONHASHSEED": seed},
        ).stdout
        for seed in ("1", "2")
    ]
    assert said[0] == said[1]
    assert len(said[0]) > 500


def test_this_one_is_known() -> None:
    assert drill("blocks", seed=7).reference.splitlines() == [
        "--[ I0.0 ]--+--+--[ I0.2 ]--+--( Q0.2 )",
        "--[/I0.5 ]--+  +--[ I0.1 ]--+",
        "               +--[ I0.6 ]--+",
    ]


@pytest.mark.parametrize("dialect", names())
@pytest.mark.parametrize("ask", ASKS)
def test_a_drill_is_made_again_from_its_id(dialect: str, ask: str) -> None:
    one = drill("blocks", 123456789, 3, dialect, ask)
    assert from_id(one.id) == one
    assert drill("set-reset", 0, 1, dialect).id == f"drill-set-reset-1-0-{dialect}"
    assert judge(one.id, "").exercise == one


@pytest.mark.parametrize(
    "name",
    [
        "s7-two-blocks", "drill", "drill-", "drill-blocks-2-7", "drill-blocks-0-7-fx", "drill-blocks-6-7-fx", "drill-blocks-2--7-fx",
        "drill-blocks-2-07-fx", "drill-blocks-2-7-fy", "drill-bloks-2-7-fx", "drill-timers-2-7-fx-join", "drill-blocks-2-7-fx-write",
        "drill-blocks-2-7-fx ", "drill-blocks-2-٧-fx", f"drill-blocks-2-{'7' * 5000}-fx", "",
    ],
)  # fmt: skip
def test_what_is_no_id_of_a_drill_makes_none(name: str) -> None:
    assert from_id(name) is None
    if name != "s7-two-blocks":
        with pytest.raises(UnknownNameError):
            judge(name, "LD I0.0")


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ({"kind": "bloks"}, "blocks"),
        ({"ask": "predikt"}, "predict"),
        ({"dialect": "fxx"}, "fx"),
        ({"level": 0}, "level is a whole number from 1 to 5"),
        ({"level": 6}, "level is a whole number from 1 to 5"),
        ({"seed": -1}, "seed is a whole number from 0"),
        ({"seed": 10**30}, "seed is a whole number from 0"),
        ({"seed": 1.5}, "seed is a whole number from 0"),
    ],
)
def test_words_that_make_no_drill_are_named(words: dict, says: str) -> None:
    with pytest.raises(PlcTeachError, match=says):
        drill(**words)


# None is trivial: every output depends on every contact that leads to it.


def columns(one: Exercise) -> tuple[list[str], list[tuple[set[str], dict[str, Column]]]]:
    """Work out each output of a drill over all inputs at once, from the drawing alone."""
    ladder, found = read_drawing(one.reference)
    assert not found
    inputs = sorted({each.address for rung in ladder.rungs for each in rung.symbols if isinstance(each, Contact)})
    rows = Rows(len(inputs))
    bits = {address: rows.variable(number) for number, address in enumerate(inputs)}
    return inputs, [
        ({each.address for each in rung.symbols if isinstance(each, Contact)}, meaning(rung, bits))
        for rung in ladder.rungs
    ]


@pytest.mark.parametrize("kind", BITS_ONLY)
@pytest.mark.parametrize("level", LEVELS)
def test_every_contact_counts(kind: str, level: int) -> None:
    for seed in range(12):
        inputs, rungs = columns(drill(kind, seed, level))
        for read_here, written in rungs:
            counting = {
                address
                for number, address in enumerate(inputs)
                for value in written.values()
                if _depends(value, number, len(inputs))
            }
            assert counting == read_here
            assert all(value.may1 and value.may0 for value in written.values())


def _depends(value: Column, number: int, count: int) -> bool:
    block = 1 << number
    low = sum(((1 << block) - 1) << start for start in range(0, 1 << count, 2 * block))
    return value.may1 & low != value.may1 >> block & low


@pytest.mark.parametrize("kind", ["timers", "counters", "set-reset", "edges"])
def test_where_there_is_a_memory_a_contact_turned_round_is_always_found(kind: str) -> None:
    for seed in range(3):
        one = drill(kind, seed, 3, "s7-200")
        rows = one.right[0].split("\n")
        turned = {"LD": "LDN", "LDN": "LD", "A": "AN", "AN": "A", "O": "ON", "ON": "O"}
        for number, row in enumerate(rows):
            word, _, address = row.partition(" ")
            if address.startswith("I") and word in turned:
                other = "\n".join([*rows[:number], f"{turned[word]} {address}", *rows[number + 1 :]])
                assert judge(one, other).verdict.status == "different", other


def test_a_higher_level_is_more_work() -> None:
    for kind in KINDS:
        sizes = [mean(len(read(drill(kind, seed, level).right[0]).lines) for seed in range(10)) for level in LEVELS]
        assert sizes[0] < sizes[2] < sizes[4], kind


def test_drills_of_a_kind_differ() -> None:
    for kind in KINDS:
        assert len({drill(kind, seed, 3).reference for seed in range(40)}) >= 38


def test_contacts_want_no_join_and_blocks_do_and_branches_save_and_fetch() -> None:
    for seed in range(20):
        for level in LEVELS:
            joins = [
                re.findall(r"^(ALD|OLD|LPS|LPP)$", drill(kind, seed, level).right[0], re.MULTILINE)
                for kind in BITS_ONLY
            ]
            assert not joins[0]
            assert {"ALD", "OLD"} & set(joins[1])
            assert joins[2].count("LPS") == joins[2].count("LPP") >= 1


# What is told is true; counted here without the package.


@pytest.mark.parametrize("dialect", ["s7-200", "fx", "gutta"])
@pytest.mark.parametrize("level", LEVELS)
def test_the_hints_count_right(dialect: str, level: int) -> None:
    for seed in range(8):
        one = drill("blocks", seed, level, dialect)
        rows = [row for row in one.right[0].splitlines() if not row.startswith("Network")]
        told = " ".join(hint.en for hint in one.hints)
        loads = sum(row.split()[0] in {"LD", "LDN", "LDI"} for row in rows)
        joins = [row for row in rows if row in {"ALD", "OLD", "ANB", "ORB"}]
        assert len(joins) == loads - 1
        assert f"{loads} blocks want {len(joins)} join" in told
        assert f"they are {' '.join(joins)}, in this order" in told
        assert f"has {len(rows)} instructions" in told
        assert f"begins with {rows[0]} and ends with {rows[-1]}" in told
        for hint in one.hints:
            assert re.search("[\u4e00-\u9fff]", hint.zh)
            assert not re.search("[\u4e00-\u9fff]", hint.en)
            assert re.findall(r"\d+(?![.\d])", hint.zh)[:1] == re.findall(r"\d+(?![.\d])", hint.en)[:1]


@pytest.mark.parametrize("dialect", ["s7-200", "fx", "gutta"])
def test_which_blocks_a_join_joins_is_worked_out_with_pencil_and_paper(dialect: str) -> None:
    for seed in range(15):
        one = drill("blocks", seed, 1 + seed % 5, dialect, "join")
        blocks: list[list[int]] = []
        rows = [row for row in one.given.splitlines() if row and not row.startswith("Network")]
        for number, row in enumerate(rows[: one.row], 1):
            word = row.split()[0]
            if word in {"LD", "LDN", "LDI"}:
                blocks.append([number, number])
            elif word in {"ALD", "OLD", "ANB", "ORB"}:
                lower, upper = blocks.pop(), blocks.pop()
                pair = (upper, lower)
                blocks.append([upper[0], number])
            else:
                blocks[-1][1] = number
        assert number == one.row
        assert one.right[0].split() == [f"{first}-{last}" for first, last in pair]


@pytest.mark.parametrize("kind", ["contacts", "blocks"])
def test_what_is_on_the_stack_is_worked_out_with_pencil_and_paper(kind: str) -> None:
    for seed in range(15):
        one = drill(kind, seed, 1 + seed % 5, "s7-200", "predict")
        stack: list[bool] = []
        tops = []
        for row in (row for row in one.given.splitlines() if row and not row.startswith("Network")):
            word, _, address = row.partition(" ")
            bit = bool(one.scans[0].get(address, 0)) != word.endswith("N")
            if word.startswith("LD"):
                stack.append(bit)
            elif word in {"ALD", "OLD"}:
                bit = stack.pop()
                stack[-1] = stack[-1] & bit if word == "ALD" else stack[-1] | bit
            elif word[0] in "AO":
                stack[-1] = stack[-1] & bit if word[0] == "A" else stack[-1] | bit
            tops.append("".join(str(int(value)) for value in reversed(stack)))
        told = [row.replace(" ", "").rstrip(".") for row in one.right[0].splitlines()]
        assert [row[: len(top)] for row, top in zip(told, tops, strict=True)] == tops


def test_of_the_ladders_to_choose_from_one_is_the_list_and_they_differ_to_the_eye() -> None:
    for dialect in FAMILIES:
        one = drill("blocks", 3, 2, dialect, "match")
        assert len(set(one.choices)) == len(one.choices) == 4
        assert drill("blocks", 3, 2, dialect).reference in one.choices


def test_a_pulse_is_asked_for_at_every_scan() -> None:
    assert drill("edges", 1, 1).level == "exact"
    assert drill("set-reset", 1, 1).level == "either"
    kinds = {
        each.kind
        for one in [drill("set-reset", 1, 1)]
        for rung in read_drawing(one.reference)[0].rungs
        for each in rung.symbols
        if isinstance(each, Coil)
    }
    assert kinds == {"set", "reset"}
