"""A submission judged: what is said of it, in which order, and how many marks it gets."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from plcteach.check.judge import judge, reference, verdict_on
from plcteach.check.report import headline, report_html, table, verdict_json
from plcteach.core.errors import PlcTeachError, UnknownNameError
from plcteach.core.exercise import Exercise, Need, Terms
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


def test_a_difference_in_time_says_after_how_long_and_no_scan_length_is_an_input() -> None:
    """Of 5 s and 4.9 s with the same timer the second is over after 4.9 s, and not after 4.8 s."""
    timer = "LD I0.0\nTON T37, {}\nLD T37\n= Q0.0\n"
    judged = judge(task(timer.format(50)), timer.format(49))
    told = headline(judged)
    assert told.en.startswith("After 4.9 s, with I0.0=1, Q0.0 should be 0; your program gives 1")
    assert told.zh.startswith("4.9 s后，当I0.0=1时，Q0.0应为0，你的程序给出1")
    assert [row.address for row in table(judged.verdict)] == ["I0.0", "Q0.0", "Q0.0"]
    desk = verdict_json(judged)
    assert "ms" not in {row["address"] for row in desk["rows"]}
    assert desk["headline"] == told.as_dict()
    for lang in ("zh", "en"):
        page = report_html(judged, lang)
        assert told.in_(lang) in page
        assert "ms=" not in page


def test_a_difference_without_inputs_is_told_without_any() -> None:
    timer = "LD SM0.0\nTON T37, {}\nLD T37\n= Q0.0\n"
    assert headline(judge(task(timer.format(5)), timer.format(4))).en.startswith("After 400 ms, Q0.0 should be 0")
    told = headline(judge(task("LD SM0.0\n= Q0.0\n"), "LDN SM0.0\n= Q0.0\n"))
    assert told.en == "Without any input, Q0.0 should be 1; your program gives 0."
    assert told.zh == "没有任何输入，Q0.0应为1，你的程序给出0。"


def test_no_heading_of_a_report_is_empty() -> None:
    judged = judge(task("--[ I0.0 ]--[ I0.1 ]--( Q0.0 )"), "LD I0.0\nO I0.1\n= Q0.0\n")
    page = report_html(judged, "en")
    assert "<th" in page
    assert not re.search(r"<th[^>]*></th>", page)


@pytest.mark.parametrize(
    ("drawing", "text", "zh", "en"),
    [
        ("--[ I0.0 ]--( Q0.0 )", "LD I0.0\n= Q0.0\n", "与参考完全一样", "line for line"),
        ("--[ I0.0 ]--( Q0.0 )", "LDN I0.0\nNOT\n= Q0.0\n", "所有输入组合", "every combination"),
        (
            "--[P I0.0 ]--( Q0.0 )",
            "LD I0.0\nEU\nNOT\nNOT\n= Q0.0\n",
            "所有能到达的状态",
            "every state that can be reached",
        ),
        (
            "--[ I0.0 ]--{ TON T37, 30000 }\n\n--[ T37 ]--( Q0.0 )",
            "LDN I0.0\nNOT\nTON T40, 30000\nLD T40\n= Q0.0\n",
            "任意多个扫描",
            "any number of scans",
        ),
    ],
)
def test_a_right_program_is_told_how_that_is_known(drawing: str, text: str, zh: str, en: str) -> None:
    told = headline(judge(task(drawing), text))
    assert zh in told.zh
    assert en in told.en
    assert "4/4" in told.zh
    assert "4 of 4" in told.en


def test_what_is_not_known_is_said_honestly() -> None:
    """A product of words is beyond what is proved: two ways of writing it are tried, and nothing is promised."""
    wanted = "LD I0.0\nMOVW +3, VW0\nLD I0.1\n*I VW0, VW0\nLDW= VW0, +9\n= Q0.0\n"
    judged = judge(task(wanted), wanted.replace("LD I0.1", "LDN I0.1\nNOT"))
    assert (judged.verdict.status, judged.marks) == ("unknown", 0)
    assert "No difference was found" in headline(judged).en
    assert "没有发现差别" in headline(judged).zh


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
    assert repr(verdict_on(wanted, wanted)) == "Verdict(equal, structural)"
    assert repr(verdict_on(wanted, read("", "s7-200"))) == "Verdict(error)"


# What the text must show, which equivalence cannot see.

LATCHES = """
--[ I0.0 ]--[/Q0.1 ]--( Q0.0 )

--[ I0.1 ]--[/Q0.0 ]--( Q0.1 )
"""
CROSSED = "LD I0.0\nAN Q0.1\n= Q0.0\nLD I0.1\nAN Q0.0\n= Q0.1\n"


def needing(*needs: Need, weights: dict[str, float] | None = None, drawing: str = TWO, start: str = "") -> Exercise:
    return replace(task(drawing), needs=needs, weights=weights or {}, start=start)


@pytest.mark.parametrize(
    ("need", "text", "met"),
    [
        (Need("most", "7"), RIGHT, True),
        (Need("most", "6"), RIGHT, False),
        (Need("uses", "LPS"), RIGHT, True),
        (Need("uses", "lpp"), RIGHT, True),
        (Need("uses", "A I0.1"), RIGHT, True),
        (Need("uses", "OLD"), RIGHT, False),
        (Need("avoids", "OLD"), RIGHT, True),
        (Need("avoids", "LPS"), RIGHT, False),
        (Need("avoids", "AN"), RIGHT, False),
        (Need("contact", "/I0.2"), RIGHT, True),
        (Need("contact", "/I0.2", "Q0.1"), RIGHT, True),
        (Need("contact", "/I0.2", "Q0.0"), RIGHT, False),
        (Need("contact", "I0.2", "Q0.1"), RIGHT, False),
        (Need("contact", "I0.0", "Q0.1"), RIGHT, True),
        (Need("contact", "I0.0", "Q0.7"), RIGHT, False),
    ],
)
def test_needs_of_the_text(need: Need, text: str, *, met: bool) -> None:
    judged = judge(needing(need), text)
    assert judged.verdict.status == "equal"
    assert (judged.says == ()) is met
    assert judged.marks == (4.0 if met else 3.0)


def test_an_interlock_is_asked_for_in_the_rung_that_needs_it() -> None:
    """Whatever a sensor under "never both" makes redundant can still be asked for; a contact elsewhere is not it."""
    task = needing(Need("contact", "/Q0.1", "Q0.0"), Need("contact", "/Q0.0", "Q0.1"), drawing=LATCHES)
    assert judge(task, CROSSED).marks == 4
    by_not = "LD I0.0\nAN Q0.1\n= Q0.0\nLD Q0.0\nNOT\nA I0.1\n= Q0.1\n"
    lacking = judge(task, by_not)
    assert (lacking.verdict.status, lacking.marks, len(lacking.says)) == ("equal", 3, 1)
    told = headline(lacking)
    assert told.en == (
        "3 of 4: It does the right thing; the task asks for one thing more: "
        "The rung that writes Q0.1 still lacks a normally closed contact of Q0.0."
    )
    assert told.zh == "3/4分：作用是对的，但题目还要求：输出Q0.1的梯级里还少一个常闭触点Q0.0。"


def test_an_exercise_says_what_is_missing_in_its_own_words() -> None:
    own = Text("正转和反转要互锁。", "Forward and reverse want an interlock.")
    judged = judge(needing(Need("uses", "OLD", says=own)), RIGHT)
    assert judged.says[0].en.endswith("Forward and reverse want an interlock.")


@pytest.mark.parametrize(
    ("most", "text", "met"),
    [
        ("1", "LD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n", True),
        ("1", "LD I0.0\nAN I0.1\nO Q0.0\n= Q0.0\n", True),
        ("0", "LD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n", False),
        ("1", "LD Q0.0\nO I0.0\nAN I0.1\n= Q0.0\n", False),
    ],
)
def test_edits_are_lines_changed_put_in_or_taken_out(most: str, text: str, *, met: bool) -> None:
    start = "LD I0.0\nAN I0.1\n= Q0.0\n"
    task = needing(Need("edits", most), drawing=text, start=start)
    assert (judge(task, text).says == ()) is met


# Marks by parts.


def test_marks_are_shared_by_weights_and_the_parts_add_up() -> None:
    weights = {"outputs": 2.0, "style": 1.0, "needs": 1.0}
    task = needing(Need("uses", "LPS"), Need("uses", "OLD"), weights=weights)
    judged = judge(task, RIGHT)
    assert [(one.name.en, one.got, one.of) for one in judged.parts] == [
        ("outputs", 2.0, 2.0),
        ("style", 1.0, 1.0),
        ("requirements", 0.5, 1.0),
    ]
    assert judged.marks == 3.5
    half = judge(task, "LD I0.0\nLPS\nA I0.1\n= Q0.0\nLPP\nA I0.2\n= Q0.1\n")
    assert [one.got for one in half.parts] == [0.5, 0.5, 0.25]
    assert half.marks == 1.25


def test_steps_are_the_scans_of_the_counterexample_that_agree() -> None:
    """The latch without its seal-in is right while the button is held, and wrong when it is let go: one of two scans."""
    sealed = replace(task("--[ I0.0 ]--+--[/I0.1 ]--( Q0.0 )\n--[ Q0.0 ]--+"), weights={"outputs": 1.0, "steps": 1.0})
    judged = judge(sealed, "LD I0.0\nAN I0.1\n= Q0.0\n")
    assert [(one.name.en, one.got) for one in judged.parts] == [("outputs", 0.0), ("steps", 1.0)]
    assert judged.marks == 1


@pytest.mark.parametrize("weights", [{}, {"style": 1.0}, {"needs": 1.0}, {"outputs": 1.0, "style": 1.0, "steps": 1.0}])
def test_what_does_nothing_right_gets_nothing_for_its_style(weights: dict[str, float]) -> None:
    task = needing(Need("avoids", "OLD"), weights=weights, drawing="--[ I0.0 ]--[ I0.1 ]--( Q0.0 )")
    assert judge(task, "LDN I0.0\n= Q0.0\n").marks == 0
    assert judge(task, "").marks == 0
    assert judge(task, "LD I0.0\nA I0.1\n= Q0.0\n").marks == 4


@pytest.mark.parametrize(("blocks", "share"), [(0, 1.0), (1, 0.75), (2, 0.5), (4, 0.0), (5, 0.0)])
def test_each_block_that_is_not_needed_costs_a_quarter_of_the_style(blocks: int, share: float) -> None:
    """LD + OLD for a single contact is right and one line too many (misconception 7)."""
    task_ = replace(
        task("LD I0.0\nO I0.1\nO I0.2\nO I0.3\nO I0.4\nO I0.5\n= Q0.0\n"), weights={"style": 1.0, "outputs": 1.0}
    )
    lines = [f"LD I0.{bit}\nOLD" if bit <= blocks else f"O I0.{bit}" for bit in range(1, 6)]
    judged = judge(task_, "\n".join(["LD I0.0", *lines, "= Q0.0"]))
    assert judged.verdict.status == "equal"
    assert [(one.name.en, one.got) for one in judged.parts] == [("style", 2 * share), ("outputs", 2.0)]


# What must never be.


def test_what_must_never_be_is_told_as_such() -> None:
    both = replace(task("--[ I0.0 ]--( Q0.0 )\n\n--[ I0.1 ]--( Q0.1 )"), terms=Terms(never=("Q0.0 & Q0.1",)))
    judged = judge(both, "LD I0.0\n= Q0.0\nLD I0.1\n= Q0.1\n")
    assert judged.verdict.status == "different"
    assert headline(judged).en == "With I0.0=1, I0.1=1, Q0.0 & Q0.1 holds, and that must never be."


def test_a_program_that_never_comes_to_rest_is_told_so() -> None:
    settled = replace(task("--[ I0.0 ]--( Q0.0 )"), terms=Terms(level="settled"))
    judged = judge(settled, "LDN M0.1\n= M0.1\n= Q0.0\n")
    assert (judged.verdict.status, judged.marks) == ("unsettled", 0)
    assert "never comes to rest" in headline(judged).en
    assert "停不下来" in headline(judged).zh
