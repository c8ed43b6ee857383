"""The concept test: twelve questions twice, nothing told in between, and the two compared."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

import plcteach
from plcteach.check.judge import model
from plcteach.core import text as words
from plcteach.exercises import concept_test as questions

if TYPE_CHECKING:
    from plcteach.widgets.quiz import ConceptTest


@pytest.fixture(autouse=True)
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(words, "_chosen", ["en"])


def presses(test: ConceptTest, button: str, **content: object) -> dict:
    test._handle_custom_msg({"type": button, **content}, [])
    return json.loads(test.quiz)


def answers(test: ConceptTest, right: set[int]) -> None:
    """Answer some of the questions right, and leave the others."""
    for number, one in enumerate(questions()):
        presses(test, "go", at=number)
        if number in right:
            test.source = model(one)
            test.serial += 1


def test_it_asks_twelve_questions_and_tells_nothing_while_it_runs() -> None:
    test = plcteach.concept_test()
    assert len(json.loads(test.quiz)["answered"]) == 12
    before = test.source
    for button in ("check", "hint", "show", "model", "nothing"):
        presses(test, button)
    presses(test, "go", at="seven")
    assert (test.verdict, test.film, test.model, test.source) == ("", "", "", before)
    test.feedback = "each"
    test.serial += 1
    assert "marks" not in json.loads(test.report)
    assert json.loads(test.task)["id"] == "concept-01"


def test_before_and_after_are_kept_and_compared() -> None:
    test = plcteach.concept_test()
    answers(test, {0, 3, 5})
    told = presses(test, "finish")
    assert (told["phase"], told["result"]) == ("between", {"all": 12, "before": 3})
    test = plcteach.concept_test()
    assert test.phase == "between", "it is kept"
    told = presses(test, "begin")
    assert (told["phase"], told["answered"]) == ("after", [False] * 12)
    answers(test, set(range(12)) - {7})
    told = presses(test, "finish")
    assert told["phase"] == "done"
    assert (told["result"]["before"], told["result"]["after"]) == (3, 11)
    assert [row["after"] for row in told["result"]["rows"]] == [number != 7 for number in range(12)]
    assert "3 of 12" in told["result"]["say"]["en"]
    assert json.loads(plcteach.concept_test().quiz)["phase"] == "done"
    assert "Concept test: before the course 3 / 12, after it 11 / 12" in repr(plcteach.progress())
    presses(test, "begin")
    presses(test, "finish")
    assert json.loads(test.quiz) == told, "what is done stays"


def test_it_goes_on_where_it_was_left() -> None:
    answers(plcteach.concept_test(), {0, 1})
    test = plcteach.concept_test()
    assert json.loads(test.quiz)["at"] == 2
    presses(test, "go", at=1)
    assert test.source == model(questions()[1])
    assert presses(test, "go", at=99)["at"] == 11
    assert plcteach.progress().summary.en.startswith("0 with full marks, 0 begun"), "a test is no exercise"


def test_a_printed_page_has_all_questions_and_no_answer() -> None:
    test = plcteach.concept_test()
    shown = test._repr_mimebundle_()[0]["text/html"]
    assert shown.count("<h4>") == 12
    assert repr(test) == "ConceptTest(12 questions)"
    assert plcteach.concept_test(size=2).size == 2
