"""Hints come in stages and are true; what an answer shows of the usual wrong ideas is found, and the concept test finds it too."""

from __future__ import annotations

from dataclasses import replace

import pytest

from plcteach.check.hints import believed, hints, mended
from plcteach.check.judge import judge, model, shown
from plcteach.core.diagnostic import RULES
from plcteach.core.errors import UnknownNameError
from plcteach.core.exercise import Exercise, WrongSample
from plcteach.core.misconception import MISCONCEPTIONS
from plcteach.core.text import NOTHING, Text
from plcteach.exercises import concept_test, exercise, ids

TASK = Exercise(
    id="two-blocks",
    dialect="s7-200",
    title=Text("两块", "Two blocks"),
    task=Text("写出来。", "Write it."),
    reference="LD I0.0\nA I0.1\nLD I0.2\nA I0.3\nOLD\n= Q0.0",
    hints=(Text("数一数块。", "Count the blocks."), Text("用OLD。", "It is OLD.")),
    misconceptions=(1, 6),
    wrong=(
        WrongSample("LD I0.0\nA I0.1\nO I0.2\nA I0.3\n= Q0.0", "different", NOTHING, 1),
        WrongSample("LD I0.0\nA I0.1\nLD I0.2\nA I0.3\nALD\n= Q0.0", "different", NOTHING, 6),
    ),
)
SWAPPED = "LD I0.0\nA I0.1\nLD I0.2\nA I0.3\nALD\n= Q0.0"


def english(texts: tuple[Text, ...]) -> list[str]:
    return [one.en for one in texts]


def test_the_stages_say_more_and_more_and_the_exercises_own_come_last() -> None:
    said = english(hints(judge(TASK, SWAPPED)))
    assert said[:3] == [
        "Look at row 5: ALD. A change in this row alone is enough.",
        "It is about series and parallel: here stands one of the two, and the other makes it right.",
        "In row 5 make ALD into OLD.",
    ]
    assert said[3:] == ["Count the blocks.", "It is OLD."]
    chinese = [one.zh for one in hints(judge(TASK, SWAPPED))]
    assert chinese[2] == "把第5行的ALD改成OLD。"


def test_what_was_found_in_the_text_is_no_hint_for_it_is_shown_anyway() -> None:
    judged = judge(TASK, SWAPPED.replace("ALD", "OLD\nOLD"))
    assert judged.verdict.diagnostics[0].text.en.startswith("OLD needs 2 values")
    said = english(hints(judged))
    assert not any("needs 2 values" in one for one in said)
    assert "Take OLD out of row 5." in said or "Take OLD out of row 6." in said


def test_a_right_answer_gets_no_hint_even_where_it_could_be_written_better() -> None:
    assert hints(judge(TASK, TASK.reference)) == ()
    task = replace(TASK, reference="LD I0.0\nO I0.1\n= Q0.0", wrong=())
    assert hints(judge(task, "LD I0.0\nLD I0.1\nOLD\n= Q0.0")) == ()
    assert believed(judge(task, "LD I0.0\nLD I0.1\nOLD\n= Q0.0")) == (7,)


def test_a_hidden_reference_keeps_the_edit_to_itself() -> None:
    said = english(hints(judge(replace(TASK, hidden=True), SWAPPED)))
    assert not any("OLD" in one for one in said[:-1])
    assert len(said) == 4


def test_a_repair_must_be_one_that_the_exercise_takes() -> None:
    start = "LD I0.0\nA I0.1\nLD I0.2\nAN I0.3\n____\n= Q0.0"
    task = replace(TASK, kind="complete", start=start, reference=start.replace("____", "OLD"))
    judged = judge(task, start.replace("____", "ALD"))
    found = mended(judged)
    assert found is not None
    assert judge(task, found.text).verdict.status == "equal"


@pytest.mark.parametrize("answer", ["", "x", "\x00", "LD", "LD I0.9\n", "ALD\n" * 50, "LD I0.0\n" * 400 + "= Q0.0"])
def test_anything_at_all_gets_the_exercises_own_hints(answer: str) -> None:
    said = hints(judge(TASK, answer))
    assert said[-2:] == TASK.hints
    assert len(said) <= 3 + 2
    assert isinstance(believed(judge(TASK, answer)), tuple)


@pytest.mark.parametrize(
    ("answer", "wanted"),
    [
        (SWAPPED, (6,)),
        ("ld i0.0 // the first\nA I0.1\n\nLD I0.2\nA I0.3\nALD\n= Q0.0", (6,)),
        ("LD I0.3\nA I0.2\nLD I0.1\nA I0.0\nALD\n= Q0.0", (6,)),
        ("LD I0.1\nA I0.0\nO I0.2\nA I0.3\n= Q0.0", (1,)),
        ("LDN I0.0\n= Q0.0", ()),
        (TASK.reference, ()),
        ("LD I0.0\nA I0.1\nLD I0.2\nA I0.3\nOLD\nOLD\n= Q0.0", (4,)),
    ],
)
def test_a_wrong_idea_is_known_by_its_sample_by_what_it_does_or_by_its_finding(
    answer: str, wanted: tuple[int, ...]
) -> None:
    assert believed(judge(TASK, answer)) == wanted


def test_of_several_ideas_behind_a_finding_those_count_that_the_exercise_is_about() -> None:
    assert RULES["STK001"].misconceptions[0] == 4
    answer = "LD I0.0\nA I0.1\nLD I0.2\nA I0.3\nOLD\nOLD\n= Q0.0"
    assert believed(judge(replace(TASK, misconceptions=(12,)), answer)) == (12,)


@pytest.mark.parametrize("name", ids()[::7])
def test_the_repairs_of_bundled_wrong_samples_are_accepted(name: str) -> None:
    """One sample of every seventh exercise; a mended list is judged as any answer is."""
    task = exercise(name)
    if not task.wrong:
        return
    found = mended(judge(task, task.wrong[0].program))
    if found is not None:
        assert judge(task, found.text).verdict.status == "equal"
        assert judge(task, task.wrong[0].program).verdict.status != "equal"


# The concept test.


def test_twelve_short_questions_on_twelve_ideas() -> None:
    items = concept_test()
    assert [one.id for one in items] == [f"concept-{number:02d}" for number in range(1, 13)]
    assert {one.kind for one in items} == {"predict", "join", "match", "chart"}
    assert len({one.misconceptions for one in items}) == 12
    assert not {one.id for one in items} & set(ids())
    assert exercise("concept-01") is items[0]
    with pytest.raises(UnknownNameError):
        exercise("concept-99")


@pytest.mark.parametrize("item", concept_test(), ids=lambda one: one.id)
def test_each_question_takes_the_right_answer_and_tells_the_wrong_idea(item: Exercise) -> None:
    """The right answers are written by hand, from the table of misconceptions."""
    for answer in item.right:
        assert judge(item, answer).marks == item.points
        assert believed(judge(item, answer)) == ()
    assert judge(item, model(item)).marks == item.points
    assert item.wrong
    for sample in item.wrong:
        judged = judge(item, sample.program)
        assert judged.marks < item.points
        assert judged.verdict.status == "different"
        assert sample.misconception in believed(judged)
        assert sample.misconception in item.misconceptions
    assert item.hints == hints(judge(item, item.wrong[0].program))[-len(item.hints) :]
    assert set(item.misconceptions) <= set(MISCONCEPTIONS)


@pytest.mark.parametrize("item", concept_test(), ids=lambda one: one.id)
def test_a_question_takes_no_more_than_a_minute(item: Exercise) -> None:
    sheet = shown(item)
    cells = len(sheet.rows) * max(1, len(sheet.columns)) if sheet.form == "grid" else 1
    assert cells <= 20
    assert sheet.program is not None
    assert len(sheet.program.lines) <= 10
    assert len(item.task.en) < 220
