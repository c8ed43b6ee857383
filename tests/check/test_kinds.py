"""Each kind of exercise: what it shows, what it takes for right, and what it says to everything else.

What is expected is written by hand: from the figures of the first document, from the instruction sets' notes, and from tables
of AND and OR worked out here without the package.
"""

from __future__ import annotations

import sys
import time
from itertools import permutations, product
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.check.judge import judge, model, shown
from plcteach.check.kinds import KINDS
from plcteach.check.kinds.order import offered
from plcteach.check.report import headline, report_html, verdict_json
from plcteach.core.errors import DeclarationError
from plcteach.core.exercise import KINDS as NAMES
from plcteach.core.exercise import Exercise, Terms
from plcteach.core.text import Text
from plcteach.exercises import exercise
from plcteach.ladder.lower import lower
from plcteach.machine import run
from plcteach.stl import read

sys.path.insert(0, str(Path(__file__).parents[1] / "ladder"))
from random_ladders import FAMILIES, bits, ladders

WORDS = Text("例", "an example")


def task(kind: str, dialect: str = "s7-200", **fields: Any) -> Exercise:
    values: dict[str, Any] = {"reference": "", **fields}
    return Exercise("mine", dialect, WORDS, WORDS, kind=kind, **values)  # type: ignore[arg-type]


def codes(judged: Any) -> list[str]:
    return [one.code for one in judged.verdict.diagnostics]


def test_every_kind_has_its_three_ways() -> None:
    assert tuple(KINDS) == NAMES
    for way in KINDS.values():
        assert callable(way.shown)
        assert callable(way.judged)
        assert callable(way.model)


# Predict: the columns of figure 5 stand in 000_8c35a2fe1b5d9b9b.txt; X0 and X2 in parallel are A, X1·X4 is B, X3·X5 is C.

FIGURE_5 = "LD X0\nOR X2\nLD X1\nAND X4\nLD X3\nAND X5\nORB\nANB\nOUT Y0\n"
A_0_B_1_C_0 = {"X0": 0, "X2": 0, "X1": 1, "X4": 1, "X3": 1, "X5": 0}
BY_HAND = """
0 . .
0 . .
1 0 .
1 0 .
1 1 0
0 1 0
1 0 .
0 . .
0 . .
"""


def predict(**fields: Any) -> Exercise:
    values = {"given": FIGURE_5, "dialect": "fx", "scans": (A_0_B_1_C_0,), "levels": 3, **fields}
    return task("predict", **values)


def test_the_stack_of_figure_5_as_the_article_tells_it() -> None:
    judged = judge(predict(), BY_HAND)
    assert (judged.verdict.status, judged.marks, judged.wrong, judged.says) == ("equal", 4.0, (), ())
    assert headline(judged) == Text(
        "正确，4/4分：堆栈的每一个值都对。", "Correct, 4 of 4: every value of the stack is as the machine has it."
    )
    assert judged.program is None


def test_one_wrong_value_costs_its_share_and_is_named_with_what_the_line_does() -> None:
    # 16 cells hold something: 9 in the first column, 5 in the second, 2 in the third; one of them is wrong
    judged = judge(predict(), BY_HAND.replace("1 0 .\n0 . .\n0 . .", "0 0 .\n0 . .\n0 . ."))
    assert judged.verdict.status == "different"
    assert judged.wrong == ((6, 0),)
    assert judged.marks == pytest.approx(3.75)
    assert [one.got for one in judged.parts] == [judged.marks]
    assert judged.says[0].en.startswith("Row 7, ORB: here is the first value that is not so. ")
    assert judged.says[0].zh.startswith("第7行 ORB：")
    assert "3.75 of 4. Row 7, ORB" in headline(judged).en


def test_figure_1_the_result_register_is_a_column_of_its_own() -> None:
    sheet = shown(predict())
    assert sheet.form == "grid"
    assert sheet.columns == ("R", "1", "2")
    assert sheet.heads[0] == Text("运算结果寄存器", "result register")
    assert sheet.rows == tuple(FIGURE_5.split("\n")[:-1])
    assert sheet.start == ". . .\n" * 9
    assert "X0=0, X2=0, X1=1, X4=1, X3=1, X5=0" in sheet.text.en
    assert "1 0" not in sheet.start


SIEMENS = "LD I0.0\nA I0.1\nLD I0.2\nAN I0.3\nOLD\n= Q0.0\n"


@pytest.mark.parametrize(
    ("answer", "right"),
    [
        ("1 .\n1 .\n0 1\n0 1\n1 .\n1 .\n", True),
        ("1 x\n1 x\n0 1\n0 1\n1 x\n1 x\n", True),  # nobody has put anything there: x and nothing are both so
        ("1\n1\n0 1\n0 1\n1\n1\n", True),
        ("1.\n1.\n01\n01\n1.\n1.\n", True),
        ("１　.\n１ －\n0 1 x x\n0 1\n1\n1 // stays\n", True),
        ("### BEGIN SOLUTION\n1\n1\n0 1\n0 1\n1\n1\n### END SOLUTION", True),
        ("# BEGIN SOLUTION\n1\n1\n0 1\n0 1\n1\n1\n# END SOLUTION", True),
        ("1 .\n1 .\n0 1\n0 1\n1 1\n1 .\n", False),  # OLD takes two and leaves one
        ("1 .\n1 .\n0 1\n0 1\n0 .\n1 .\n", False),
    ],
)
def test_a_stack_of_nine_levels(answer: str, *, right: bool) -> None:
    one = predict(given=SIEMENS, dialect="s7-200", scans=({"I0.0": 1, "I0.1": 1},), levels=2)
    judged = judge(one, answer)
    assert (judged.verdict.status == "equal") is right
    assert (judged.marks == 4) is right


def test_only_the_last_scan_is_asked_for_and_the_ones_before_count() -> None:
    """A self-holding circuit: the button is let go in the second scan, and the output it holds itself by is still on."""
    one = predict(
        given="LD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n", dialect="s7-200", scans=({"I0.0": 1}, {"I0.0": 0}), levels=1
    )
    assert judge(one, "0\n1\n1\n1\n").marks == 4
    assert judge(one, "1\n1\n1\n1\n").wrong == ((0, 0),)
    assert "The last scan is asked for." in shown(one).text.en


def test_stacks_beside_the_first_have_columns_of_their_own() -> None:
    """GUTTA's LPS saves on the auxiliary stack; NEZA's parenthesis saves the accumulator."""
    gutta = predict(
        given="LD I0.0\nLPS\nA I0.1\n= Q0.0\nLPP\n= Q0.1\n", dialect="gutta", scans=({"I0.0": 1},), levels=1
    )
    assert judge(gutta, "1 .\n1 1\n0 1\n0 1\n1 .\n1 .\n").marks == 4
    assert shown(gutta).columns[0] == "1"
    neza = predict(
        given="LD %I0.0\nAND( %I0.1\nOR %I0.2\n)\nST %Q0.0\n",
        dialect="neza",
        scans=({"%I0.0": 1, "%I0.2": 1},),
        levels=1,
    )
    assert judge(neza, "1\n0 1\n1 1\n1\n1\n").marks == 4


def test_a_grid_that_is_short_or_long_or_holds_other_signs_says_so_and_still_counts() -> None:
    one = predict()
    short = judge(one, BY_HAND.strip().rsplit("\n", 2)[0])
    assert codes(short) == ["KND004"]
    assert 0 < short.marks < 4
    long = judge(one, BY_HAND + "0 0 0\n")
    assert (codes(long), long.verdict.status) == (["KND004"], "equal")
    odd = judge(one, BY_HAND.replace("1 1 0", "1 2 0"))
    assert (codes(odd), odd.wrong) == (["KND005"], ((4, 1),))
    assert "“2”" in odd.verdict.diagnostics[0].text.zh
    assert codes(judge(one, BY_HAND.replace("1 1 0", "1 ² 0"))) == ["KND005"]
    assert codes(judge(one, "")) == ["KND011"]
    assert codes(judge(one, shown(one).start)) == ["KND011"]
    assert judge(one, shown(one).start).marks == 0
    assert judge(one, shown(one).start).verdict.status == "error"


@settings(max_examples=60, deadline=None)
@given(data=st.data())
@pytest.mark.parametrize("name", FAMILIES)
def test_the_model_answer_of_any_program_gets_full_marks_and_no_other_grid_does(name: str, data) -> None:
    inputs = bits(name)[0]
    text = lower(data.draw(ladders(name)), name)
    scans = tuple(
        dict.fromkeys(inputs, 0) | data.draw(st.dictionaries(st.sampled_from(inputs), st.integers(0, 1)))
        for _ in range(2)
    )
    one = predict(given=text, dialect=name, scans=scans, levels=0)
    answer = model(one)
    judged = judge(one, answer)
    assert (judged.verdict.status, judged.marks) == ("equal", 4.0)
    places = [at for at, sign in enumerate(answer) if sign in "01"]
    at = data.draw(st.sampled_from(places))
    turned = answer[:at] + str(1 - int(answer[at])) + answer[at + 1 :]
    assert judge(one, turned).marks < 4
    assert len(judge(one, turned).wrong) == 1


def test_the_report_shows_the_grid_as_it_was_filled_in_and_not_what_would_be_right() -> None:
    judged = judge(predict(), BY_HAND.replace("1 1 0", "1 1 1"))
    html = report_html(judged, "en")
    assert html.count("≠ 1") == 1
    assert '<th scope="row" style="text-align:left"><code>LD X3</code></th>' in html
    assert "result register" in html
    assert "运算结果寄存器" in report_html(judged, "zh")
    assert judged.grid[4] == ("1", "1", "1")
    assert "<table>" not in report_html(judge(predict(), BY_HAND), "en")


# Join: "ORB 或 ANB 连接它上面靠近它的两块已经连接好的电路" (000_8c35a2fe1b5d9b9b.txt).


def join(row: int, **fields: Any) -> Exercise:
    return task("join", **{"given": FIGURE_5, "dialect": "fx", "row": row, **fields})


@pytest.mark.parametrize(
    ("row", "answer", "marks"),
    [
        (7, "3-4 5-6", 4),
        (7, "5-6 3-4", 4),
        (7, "3-4, 5-6", 4),
        (7, "(3–4) (5–6)", 4),
        (7, "3~4；5~6", 4),
        (7, "第3-4和5-6", 0),
        (7, "1-2 3-4", 1),
        (7, "1-4 5-6", 1),
        (7, "1-2 3-6", 0),
        (8, "1-2 3-7", 4),
        (8, "3-7 1-2", 4),
        (8, "1-2 3-6", 4),
        (8, "1-2 3-8", 1),
        (8, "1-2 5-6", 1),
        (8, "1-6 7", 0),
        (7, "3-4", 0),
        (7, "3-4 5-6 1-2", 0),
        (7, "A and B", 0),
        (7, "³-4 5-6", 0),
    ],
)
def test_the_two_nearest_finished_blocks(row: int, answer: str, marks: float) -> None:
    assert judge(join(row), answer).marks == marks


def test_a_join_behind_a_branch_takes_the_copy_and_the_block() -> None:
    """Misconception 11: LPS has saved a copy of the first block, which ALD joins with the block right above it."""
    one = join(6, dialect="s7-200", given="LD I0.0\nLPS\nLD I0.1\nO I0.2\nA I0.3\nALD\n= Q0.0\nLPP\n= Q0.1\n")
    assert judge(one, "1-1 3-5").marks == 4
    assert judge(one, "1-2 3-5").marks == 4  # LPS moves cells and makes none
    assert judge(one, "1 3-4").marks == 1
    assert model(one) == "1-1 3-5"


def test_what_is_no_pair_of_stretches_is_told_what_is_expected() -> None:
    judged = judge(join(7), "blocks B and C")
    assert (codes(judged), judged.verdict.status) == (["KND006"], "error")
    assert headline(judged).en == "Two stretches of instruction numbers are expected, such as 1-2 3-4. Which two?"
    assert codes(judge(join(7), "")) == ["KND011"]
    assert "nearest finished blocks" in judge(join(7), "1-2 3-6").says[0].en
    assert "最近的两个已经完成的块" in judge(join(7), "1-2 3-4").says[0].zh
    sheet = shown(join(7))
    assert (sheet.form, sheet.rows[6]) == ("blocks", "ORB")


@pytest.mark.parametrize("row", [0, 1, 9, 10])
def test_a_row_that_joins_nothing_is_the_teachers_mistake(row: int) -> None:
    with pytest.raises(DeclarationError, match=f"row {row} is no join"):
        model(join(row))


# Match: the ladder that the proof finds, and the row of inputs that tells another one apart.

CHOICES = (
    "--[ I0.0 ]--[ I0.1 ]--+--( Q0.0 )\n--[ I0.2 ]--[ I0.3 ]--+\n",
    "--[ I0.0 ]--[ I0.1 ]--+--[ I0.3 ]--( Q0.0 )\n--[ I0.2 ]------------+\n",
    "--[ I0.0 ]--+--[ I0.1 ]--( Q0.0 )\n--[ I0.2 ]--+\n",
)


def match(**fields: Any) -> Exercise:
    return task("match", **{"given": "LD I0.0\nA I0.1\nO I0.2\nA I0.3\n= Q0.0\n", "choices": CHOICES, **fields})


def truth(number: int, a: int, b: int, c: int, d: int) -> int:
    """Work out what the ladders do, by hand: ab+cd, (ab+c)d, (a+c)b."""
    return (a & b | c & d, (a & b | c) & d, (a | c) & b)[number]


@pytest.mark.parametrize("answer", ["B", "b", "2", "(B)", "B.", "Ｂ", " B \n"])
def test_the_right_ladder_is_the_one_that_does_what_the_list_does(answer: str) -> None:
    judged = judge(match(), answer)
    assert (judged.verdict.status, judged.verdict.proof, judged.marks) == ("equal", None, 4)
    assert model(match()) == "B"


@pytest.mark.parametrize(("answer", "number"), [("A", 0), ("C", 2)])
def test_a_wrong_ladder_comes_with_the_inputs_that_tell_it_apart(answer: str, number: int) -> None:
    judged = judge(match(), answer)
    example = judged.verdict.counterexample
    assert (judged.verdict.status, judged.marks) == ("different", 0)
    assert example is not None
    row = [int(example.inputs[-1].get(f"I0.{bit}", 0)) for bit in range(4)]
    assert example.expected[-1]["Q0.0"] == str(truth(1, *row))
    assert example.got[-1]["Q0.0"] == str(truth(number, *row))
    assert "the list makes Q0.0" in headline(judged).en
    assert "这个梯形图使它为" in headline(judged).zh


def test_a_letter_that_is_no_choice() -> None:
    for answer in ("D", "4", "0", "A ladder", "²", "AB", "A\nhello"):
        assert codes(judge(match(), answer)) == ["KND007"], answer
    assert codes(judge(match(), " \n")) == ["KND011"]
    both = judge(match(), "A B")
    assert (both.verdict.status, both.marks) == ("different", 0)
    sheet = shown(match())
    assert (sheet.form, sheet.rows, len(sheet.ladders)) == ("choice", ("A", "B", "C"), 3)


def test_two_choices_that_do_the_same_are_the_teachers_mistake() -> None:
    with pytest.raises(DeclarationError, match="exactly one choice"):
        model(match(choices=(*CHOICES, "--[ I0.2 ]------------+--[ I0.3 ]--( Q0.0 )\n--[ I0.0 ]--[ I0.1 ]--+\n")))


# Chart: "the late lamp": rungs in the wrong order react a scan later; a seal-in circuit.

SEAL_IN = "LD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n"
PRESSES = ({}, {"I0.0": 1}, {"I0.0": 0}, {}, {"I0.1": 1}, {"I0.1": 0})


def chart(**fields: Any) -> Exercise:
    return task("chart", **{"given": SEAL_IN, "scans": PRESSES, **fields})


@pytest.mark.parametrize(
    ("answer", "marks"),
    [
        ("Q0.0 011100", 4),
        ("Q0.0 _###__", 4),
        ("q0.0: 01110 0", 4),
        ("Q0.0 = 0 1 1 1 0 0", 4),
        ("_###__", 4),
        ("Ｑ0.0　０１１１００", 4),
        ("Q0.0 010000", 2.67),
        ("Q0.0 0111", 2.67),
        ("Q0.0 0111001", 4),
        ("Q0.0 ......", 0),
        ("Q0.0 000000", 0),  # three of six are right, and nothing is said of when it is on
        ("Q0.0 111111", 0),
        ("Q0.0 .111..", 0),
        ("Q0.1 011100", 0),
        ("", 0),
    ],
)
def test_a_seal_in_circuit_scan_by_scan(answer: str, marks: float) -> None:
    assert judge(chart(), answer).marks == pytest.approx(marks, abs=0.01)


def test_a_row_that_never_changes_earns_only_where_the_right_one_does_not_change() -> None:
    """Q0.0 is on in the first scan, Q0.1 never: of six cells five are 0, and three of them stand in a row that stays."""
    one = chart(given="LD I0.0\n= Q0.0\nA I0.1\n= Q0.1\n", scans=({"I0.0": 1}, {"I0.0": 0}, {}))
    assert judge(one, "Q0.0 000\nQ0.1 000\n").marks == 2
    assert judge(one, "Q0.0 100\nQ0.1 000\n").marks == 4
    assert judge(one, "Q0.0 100\nQ0.1 010\n").marks == pytest.approx(4 * 5 / 6, abs=0.01)
    assert judge(one, "Q0.0 111\nQ0.1 111\n").marks == 0
    late = "Q0.0 000000"
    assert judge("s7-late-lamp", late).marks == 0
    assert judge("s7-late-lamp", late.replace("000000", "011001")).marks == 2


@pytest.mark.parametrize("lamp", ["000000", "111111", "010000", "011101"])
def test_of_a_hidden_chart_no_scan_is_named(lamp: str) -> None:
    judged = judge(chart(hidden=True), f"Q0.0 {lamp}")
    assert (judged.wrong, len(judged.says)) == ((), 1)
    assert judged.says[0] == Text("全对的行：0/1。", "Rows that are right throughout: 0 of 1.")
    assert judged.marks == judge(chart(), f"Q0.0 {lamp}").marks
    assert "≠" not in report_html(judged, "en")
    assert verdict_json(judged)["wrong"] == []


def test_of_a_hidden_prediction_only_the_rows_are_counted() -> None:
    one = predict(hidden=True)
    turned = [judge(one, BY_HAND.replace("1 1 0", other)) for other in ("0 1 0", "1 0 0", "1 1 1")]
    assert [(each.marks, each.wrong) for each in turned] == [(3.75, ())] * 3
    assert {headline(each).en for each in turned} == {"3.75 of 4. Rows that are right throughout: 8 of 9."}
    assert {headline(each).zh for each in turned} == {"3.75/4分。全对的行：8/9。"}
    assert judge(one, BY_HAND).marks == 4


def test_the_first_scan_that_is_not_so_is_named_with_its_inputs() -> None:
    judged = judge(chart(), "Q0.0 010000")
    assert judged.wrong == ((0, 2), (0, 3))
    assert judged.says == (
        Text(
            "Q0.0在第3个扫描不是这样：那时I0.0=0, I0.1=0。从第一行起把这个扫描走一遍，好吗？",
            "Q0.0 is not so in scan 3, where I0.0=0, I0.1=0. Can you go through that scan from the first line on?",
        ),
    )
    assert codes(judge(chart(), "Q0.0 0111")) == ["KND009"]
    assert codes(judge(chart(), "Q0.0 01a100")) == ["KND005"]
    assert codes(judge(chart(), "Q0.0 011100\nQ0.7 000000")) == ["KND008"]
    assert codes(judge(chart(), shown(chart()).start)) == ["KND011"]


def test_a_lamp_that_is_read_before_it_is_written_comes_a_scan_late() -> None:
    one = chart(given="LD M0.0\n= Q0.0\nLD I0.0\n= M0.0\n= Q0.1\n", scans=({"I0.0": 1}, {"I0.0": 0}, {}))
    assert judge(one, "Q0.0 010\nQ0.1 100\n").marks == 4
    assert judge(one, "Q0.1 100\nQ0.0 100\n").marks == pytest.approx(4 * 4 / 6, abs=0.01)
    assert shown(one).rows == ("Q0.0", "Q0.1")
    assert shown(one).columns == ("1", "2", "3")
    assert "I0.0 100" in shown(one).text.zh


def test_scans_of_different_lengths_are_listed() -> None:
    one = chart(scans=({"I0.0": 1}, {"ms": 40}, {"ms": 100}))
    assert "Time before each scan (ms): · 40 100" in shown(one).text.en
    assert "各扫描之前经过的时间（ms）：· 40 100" in shown(one).text.zh


def test_a_chart_wants_an_output_and_scans() -> None:
    for one in (chart(scans=()), chart(given="LD I0.0\nS M0.0, 1\n")):
        with pytest.raises(DeclarationError, match="wants an output and scans"):
            model(one)


def test_a_timer_of_one_second_with_scans_of_half_a_second() -> None:
    """TON T37, 10 counts 100 ms steps; the scan that starts it counts none, so that it is on in the third scan."""
    scans = ({"I0.0": 1, "ms": 500}, *({"ms": 500},) * 3, {"I0.0": 0, "ms": 500})
    one = chart(given="LD I0.0\nTON T37, 10\nLD T37\n= Q0.0\n", scans=scans)
    assert judge(one, "Q0.0 00110").marks == 4
    assert "Each scan takes 500 ms." in shown(one).text.en


@settings(max_examples=40, deadline=None)
@given(data=st.data())
@pytest.mark.parametrize("name", FAMILIES)
def test_the_model_chart_is_the_plain_machines_run(name: str, data) -> None:
    inputs, outputs = bits(name)
    text = lower(data.draw(ladders(name)), name)
    scans = tuple(data.draw(st.dictionaries(st.sampled_from(inputs), st.integers(0, 1))) for _ in range(4))
    one = chart(given=text, dialect=name, scans=scans)
    asked = [output for output in outputs if output in text]
    trace = run(read(text, name), scans)
    assert model(one).split() == [word for output in asked for word in (output, trace[output])]
    assert judge(one, "".join(f"{output} {trace[output]}\n" for output in asked)).marks == 4


# Order: any order that does the right thing, worked out here with a stack of its own.

LINES = ("LD I0.0", "A I0.1", "LD I0.2", "OLD", "= Q0.0")


def order(**fields: Any) -> Exercise:
    values = {"reference": CHOICES[0].replace("--[ I0.3 ]", "----------"), "right": ("\n".join(LINES),), **fields}
    return task("order", **values)


def by_hand(lines: tuple[str, ...], row: tuple[int, ...]) -> int | None:
    """Run a list over a stack of bits; None where it does not fit together or says nothing of Q0.0."""
    stack: list[int] = []
    given: int | None = None
    for line in lines:
        word, _, address = line.partition(" ")
        bit = row[int(address[-1])] if word in {"LD", "A", "O"} else 0
        if word == "LD":
            stack.append(bit)
        elif not stack or (word in {"OLD", "ALD"} and len(stack) < 2):
            return None
        elif word == "=":
            given = stack[-1]
        elif word in {"A", "O"}:
            stack[-1] = stack[-1] & bit if word == "A" else stack[-1] | bit
        else:
            one, other = stack.pop(), stack.pop()
            stack.append(one | other if word == "OLD" else one & other)
    return given if len(stack) == 1 else None


def test_any_order_is_right_that_does_the_right_thing() -> None:
    one = order()
    wanted = [a & b | c for a, b, c in product((0, 1), repeat=3)]
    accepted = 0
    for lines in permutations(LINES):
        got = [by_hand(lines, row) for row in product((0, 1), repeat=3)]
        judged = judge(one, "\n".join(lines))
        assert (judged.verdict.status == "equal") == (got == wanted), lines
        accepted += got == wanted
    assert accepted == 2  # a·b first, or c first


def test_lines_that_were_not_offered_are_not_accepted_even_if_they_do_the_same() -> None:
    one = order(distractors=("ALD", "A I0.1"))
    assert sorted(offered(one)) == sorted([*LINES, "ALD", "A I0.1"])
    foreign = judge(one, "LD I0.0\nA I0.1\nO I0.2\n= Q0.0\n")
    assert (codes(foreign), foreign.verdict.status, foreign.marks) == (["KND002"], "error", 0)
    assert foreign.verdict.diagnostics[0].span.row == 3
    often = judge(one, "LD I0.0\nA I0.1\nLD I0.2\nOLD\n= Q0.0\n= Q0.0\n")
    assert codes(often)[0] == "KND003"
    assert "offered 1 time," in often.verdict.diagnostics[0].text.en
    twice = judge(one, "LD I0.0\nA I0.1\nA I0.1\nLD I0.2\nOLD\n= Q0.0\n")
    assert twice.verdict.status == "equal"


def test_the_offered_order_is_the_same_every_time_and_never_the_answer() -> None:
    mixed = offered(order())
    assert offered(order()) == mixed
    assert mixed != LINES
    assert shown(order()).rows == mixed
    assert shown(order()).start == ""
    for name in range(40):
        one = Exercise(f"task-{name}", "s7-200", WORDS, WORDS, CHOICES[0], kind="order", right=("LD I0.0\n= Q0.0",))
        assert offered(one) == ("= Q0.0", "LD I0.0")


# Complete, bug, translate, write.

HOLES = "LD I0.0\nA I0.1\nLD I0.2\n____\n____\n= Q0.0\n"


def test_a_list_is_completed_and_what_was_given_stays() -> None:
    one = task(
        "complete",
        reference=CHOICES[0],
        start=HOLES,
        right=(HOLES.replace("____", "A I0.3", 1).replace("____", "OLD"),),
    )
    assert judge(one, model(one)).marks == 4
    assert judge(one, HOLES).verdict.status == "error"
    other = judge(one, "LD I0.2\nA I0.3\nLD I0.0\nA I0.1\nOLD\n= Q0.0\n")
    assert (codes(other)[0], other.marks) == ("KND001", 0)
    assert "LD I0.2" in other.verdict.diagnostics[0].text.en
    assert judge(one, "LD  i0.0 // first\nA I0.1\nLD I0.2\nA I0.3\nOLD\n= Q0.0\n").marks == 4
    assert shown(one).start == HOLES
    assert len(shown(one).ladders) == 1


def test_a_gap_is_no_room_for_another_program() -> None:
    """Two gaps take eight lines at the most, or as many as the full answer has."""
    filled = HOLES.replace("____", "A I0.3", 1).replace("____", "OLD{}")
    one = task("complete", reference=CHOICES[0], start=HOLES, right=(filled.format(""),))
    assert judge(one, filled.format("\nNOT" * 6)).marks == 4
    beside = judge(one, filled.format("\nNOT" * 8))
    assert (codes(beside)[0], beside.marks) == ("KND012", 0)
    assert "10 lines are filled in, and there is room for 8" in headline(beside).en
    assert "填进了10行，而这里最多填8行" in headline(beside).zh
    long = "\nNOT" * 12
    wide = task("complete", reference=CHOICES[0], start=HOLES, right=(filled.format(long),))
    assert judge(wide, filled.format(long)).marks == 4


def test_a_fault_is_mended_with_few_edits() -> None:
    """The latch without its seal-in contact is mended by one line; a new program does the same and is no mending."""
    from plcteach.core.exercise import Need

    start = "LD I0.0\nAN I0.1\n= Q0.0\n"
    one = task("bug", reference=SEAL_IN, start=start, needs=(Need("edits", "1"),))
    assert judge(one, SEAL_IN).marks == 4
    assert judge(one, start).verdict.status == "different"
    rewritten = judge(one, "LD I0.0\nO Q0.0\nLDN I0.1\nALD\n= Q0.0\n")
    assert (rewritten.verdict.status, rewritten.marks) == ("equal", 3)
    assert "Changing 1 of the lines is enough; here 3 are changed." in headline(rewritten).en


def test_what_is_shown_of_a_fault_is_the_list_with_it_and_the_ladder_that_was_meant() -> None:
    one = task("bug", reference=CHOICES[0], start="LD I0.0\nA I0.1\nO I0.2\n= Q0.0\n")
    sheet = shown(one)
    assert (sheet.form, sheet.start, len(sheet.ladders)) == ("list", one.start, 1)
    assert sheet.program is not None
    assert [line.text for line in sheet.program.lines] == one.start.splitlines()
    assert model(one).splitlines()[1:] == ["LD I0.0", "A I0.1", "LD I0.2", "A I0.3", "OLD", "= Q0.0"]


def test_a_translation_keeps_what_it_does_by_the_table_that_is_shown() -> None:
    one = task("translate", "fx", given=SEAL_IN, source="s7-200", reference=SEAL_IN)
    text = shown(one).text.en
    table = dict(pair.split(" → ") for pair in text.removeprefix("Addresses: ").split(", "))
    assert set(table) == {"I0.0", "I0.1", "Q0.0"}
    by_table = "LD {I0}\nOR {Q0}\nANI {I1}\nOUT {Q0}\n".format(I0=table["I0.0"], I1=table["I0.1"], Q0=table["Q0.0"])
    assert judge(one, by_table).marks == 4
    assert judge(one, by_table.replace("ANI", "AND")).verdict.status == "different"
    assert judge(one, SEAL_IN).verdict.status == "error"
    own = task(
        "translate", "fx", given=SEAL_IN, source="s7-200", reference="--[ X0 ]--+--[/X1 ]--( Y0 )\n--[ Y0 ]--+\n"
    )
    assert judge(own, "LD X0\nOR Y0\nANI X1\nOUT Y0\n").marks == 4
    assert shown(own).text.en == ""


def test_a_drawing_pasted_as_the_answer_is_no_list() -> None:
    assert judge(task("write", reference=CHOICES[0]), CHOICES[0]).verdict.status == "error"


def test_what_is_shown_before_the_answer_never_holds_a_hidden_reference_or_a_list() -> None:
    one = task("write", reference=CHOICES[0], hidden=True)
    assert shown(one).ladders == ()
    assert shown(task("write", reference=SEAL_IN)).ladders == ()
    assert len(shown(task("write", reference=CHOICES[0])).ladders) == 1


# Everything else that can be typed.

ALL = {
    "write": task("write", reference=CHOICES[0]),
    "complete": task("complete", reference=CHOICES[0], start=HOLES),
    "bug": task("bug", reference=SEAL_IN, start="LD I0.0\n= Q0.0\n"),
    "translate": task("translate", "fx", given=SEAL_IN, source="s7-200", reference=SEAL_IN),
    "order": order(),
    "predict": predict(),
    "join": join(7),
    "match": match(),
    "chart": chart(),
}
HOSTILE = {
    "nothing": "",
    "blanks": " \n\t\n",
    "nul": "\x00" * 1000,
    "bytes": b"\xff\xfe\x00\xd8\x00",
    "letters": "x" * 1_000_000,
    "garbage": bytes(range(256)) * 4_000,
    "markup": "<script>alert(1)</script>\n<img src=x onerror=alert(1)>" * 20,
    "raised digits": "² ³ ¹\n" * 9,
    "other digits": "١ ٢\n" * 9,
    "rows": "1 0\n" * 1_000_000,
    "one long row": "1 0 " * 250_000,
    "stretches": "1-2 " * 200_000,
    "large numbers": f"{'9' * 400}-{'9' * 400} 1-999999",
    "braces": "{} {0} {word} %s %(x)s",
    "escapes": "\x1b[31mred\x1b[0m \u202e\u2028\u0085",
    "lonely surrogate": "\ud800\udfff",
}


@pytest.mark.parametrize("kind", ALL)
@pytest.mark.parametrize("hostile", HOSTILE)
def test_whatever_is_typed_gets_a_clear_answer_soon(kind: str, hostile: str, capfd: pytest.CaptureFixture[str]) -> None:
    answer = HOSTILE[hostile]
    start = time.process_time()
    judged = judge(ALL[kind], answer)
    assert time.process_time() - start < 2
    assert judged.marks == 0
    assert judged.verdict.status in {"error", "different"}
    for lang in ("zh", "en"):
        html = report_html(judged, lang)
        assert "<script" not in html
        assert "<img" not in html
        assert len(html) < 30_000
        assert headline(judged).in_(lang).isprintable()
    assert verdict_json(judged)["marks"] == 0
    again = judge(ALL[kind], answer)
    assert (again.verdict, again.says, again.wrong) == (judged.verdict, judged.says, judged.wrong)
    assert capfd.readouterr() == ("", "")


def test_an_answer_that_is_far_too_long_is_not_read() -> None:
    for kind in ("predict", "join", "match", "chart"):
        assert codes(judge(ALL[kind], "1-2 " * 200_000)) == ["KND010"]


@pytest.mark.no_cover  # it looks at the time
def test_the_ends_of_the_numbers_of_rows() -> None:
    """A long program is judged by its rungs and edits as soon as a short one."""
    from plcteach.core.exercise import Need

    needs = (Need("contact", "/I0.7", "Q0.0"), Need("edits", "1"), Need("most", "3"))
    one = task("bug", reference="--[ I0.0 ]--( Q0.0 )", start="LD I0.0\n= Q0.0\n", needs=needs)
    rung = "LD I0.{0}\nO Q0.{0}\nAN I1.{0}\n= Q1.{0}\n"
    start = time.process_time()
    judged = judge(one, "".join(rung.format(number % 8) for number in range(480)) + "LD I0.0\n= Q0.0\n")
    assert time.process_time() - start < 2
    assert (judged.verdict.status, judged.marks, len(judged.says)) == ("equal", 3, 3)


def test_terms_of_an_exercise_reach_the_comparison() -> None:
    """Where both switches are never on at once, it does not matter what happens then."""
    wanted, other = "LD I0.0\nA I0.1\nO I0.2\n= Q0.0\n", "LD I0.2\n= Q0.0\n"
    assert judge(task("write", reference=wanted), other).verdict.status == "different"
    never = Terms(assume=("!(I0.0 & I0.1)",))
    assert judge(task("write", reference=wanted, terms=never), other).verdict.status == "equal"


def test_an_interlock_that_is_absent_is_a_finding_that_a_class_can_be_counted_by() -> None:
    """Misconception of the star-delta starter: the timer seems to be enough."""
    star = exercise("s7-star-delta")
    lacking = judge(star, star.right[0].replace("AN Q0.2\n", ""))
    assert lacking.verdict.status == "equal"
    assert lacking.marks < star.points
    assert codes(lacking) == ["CHK006"]
    assert [one.text.en for one in lacking.verdict.diagnostics] == [
        "The network of star must contain the normally closed contact of delta."
    ]
    assert report_html(lacking, "en").count("normally closed contact of delta") == 2  # the headline and one remark
    assert codes(judge(star, star.right[0])) == []


@pytest.mark.parametrize(
    ("useless", "rows"),
    [
        (True, "LDN Q0.2\nO Q0.2\nALD\n"),
        (True, "LDN Q0.2\nO SM0.0\nALD\n"),
        (False, "LDN Q0.2\nALD\n"),
        (False, "LDN Q0.2\nA I0.7\nLDN Q0.2\nAN I0.7\nOLD\nALD\n"),
    ],
)
def test_an_interlock_that_never_opens_anything_is_none(useless: bool, rows: str) -> None:  # noqa: FBT001
    star = exercise("s7-star-delta")
    judged = judge(star, star.right[0].replace("AN Q0.2\n", rows))
    assert judged.verdict.status == "equal"
    assert (codes(judged) == ["CHK006"]) == useless
