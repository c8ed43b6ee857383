"""The exercise desk without a browser: every kind of exercise, what the page is told, what it shows, and what stays hidden."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

import plcteach
from plcteach.check.judge import model
from plcteach.core import text as words
from plcteach.core.errors import PlcTeachError
from plcteach.core.exercise import Exercise
from plcteach.core.text import Text
from plcteach.exercises import exercise, ids
from plcteach.widgets import ExerciseDesk


@pytest.fixture(autouse=True)
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(words, "_chosen", ["en"])


def types(desk: ExerciseDesk, source: str) -> dict:
    """Do as the page does: put the text in, then count the serial up; give the answer."""
    desk.source = source
    desk.serial += 1
    return json.loads(desk.report)


def presses(desk: ExerciseDesk, button: str, **content: object) -> None:
    desk._handle_custom_msg({"type": button, **content}, [])


def said(desk: ExerciseDesk, trait: str) -> dict:
    return json.loads(getattr(desk, trait) or "null")


def html(desk: ExerciseDesk) -> str:
    return desk._repr_mimebundle_()[0]["text/html"]


TASK = Exercise(
    "mine",
    "s7-200",
    Text("题目", "a <b>title</b>"),
    Text("写", "write"),
    "--[ I0.0 ]--[ I0.1 ]--( Q0.0 )",
    hints=(Text("提示", "a hint"), Text("另一个", "another")),
    points=2.0,
)
RIGHT, WRONG = "LD I0.0\nA I0.1\n= Q0.0\n", "LD I0.0\nO I0.1\n= Q0.0\n"
FIRST = {kind: next(name for name in ids() if exercise(name).kind == kind) for kind in (
    "write", "complete", "bug", "translate", "order", "predict", "join", "match", "chart")}  # fmt: skip


# What is shown.


def test_a_desk_shows_its_task_and_keeps_its_hints_for_when_they_are_asked_for() -> None:
    desk = ExerciseDesk("s7-two-blocks")
    task = said(desk, "task")
    assert (task["id"], task["kind"], task["form"], task["max"]) == ("s7-two-blocks", "write", "list", 4.0)
    assert task["ladders"][0]["zh"].startswith("<svg")
    assert "hints" not in task
    assert "reference" not in json.dumps(task)
    assert said(ExerciseDesk(replace(TASK, reference=RIGHT)), "task")["ladders"] == []


@pytest.mark.parametrize(("kind", "name"), FIRST.items())
def test_every_kind_opens_is_wrong_at_first_and_right_with_its_model(kind: str, name: str) -> None:
    desk = ExerciseDesk(name)
    form = said(desk, "task")["form"]
    assert form == {"order": "rows", "predict": "grid", "chart": "grid", "join": "blocks", "match": "choice"}.get(
        kind, "list"
    )
    assert desk.source == exercise(name).start or form in {"grid", "rows", "blocks", "choice"}
    presses(desk, "check")
    assert said(desk, "verdict")["status"] in {"error", "different"}
    types(desk, model(exercise(name)))
    presses(desk, "check")
    verdict = said(desk, "verdict")
    assert (verdict["status"], verdict["marks"]) == ("equal", verdict["max"])
    assert said(desk, "kept") == {
        "attempts": 2, "best": verdict["max"], "hints": 0, "model": False, "earlier": 0, "trouble": {"zh": "", "en": ""},
    }  # fmt: skip


@pytest.mark.parametrize("name", FIRST.values())
def test_a_page_without_a_kernel_shows_the_material_in_both_languages(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    one = exercise(name)
    assert one.title.en in html(ExerciseDesk(name)).replace("&#x27;", "'").replace("&quot;", '"')
    monkeypatch.setattr(words, "_chosen", ["zh"])
    assert one.title.zh in html(ExerciseDesk(name)).replace("&quot;", '"')


@pytest.mark.parametrize("hostile", ["<script>alert(1)</script>", "<img src=x onerror=alert(1)>", "</pre><b>"])
def test_nothing_that_anybody_writes_becomes_a_tag(hostile: str) -> None:
    both = Text(hostile, hostile)
    task = replace(TASK, id=hostile, title=both, task=both, start=hostile, hints=(both,))
    order = replace(task, kind="order", right=(RIGHT,), distractors=(hostile,))
    for one in (task, order):
        desk = ExerciseDesk(one, f"{hostile}\n")
        desk.check()
        desk.hint()
        for tag in ("<script", "<img", "</pre><b>"):
            assert tag not in html(desk)


def test_a_desk_answers_each_change_with_its_findings() -> None:
    desk = ExerciseDesk(TASK)
    report = types(desk, "LD I0.0\nOLD\n= Q0.0")
    assert (report["source"], report["ok"]) == (1, False)
    assert [one["code"] for one in report["diagnostics"] if one["severity"] == "error"] == ["STK001"]
    assert types(desk, RIGHT) == {
        "source": 2, "diagnostics": [], "ok": True, "dialect": {"title": {"zh": "西门子S7-200", "en": "Siemens S7-200"}},
    }  # fmt: skip
    assert desk.verdict == ""


def test_a_gap_that_is_still_to_be_filled_is_no_finding() -> None:
    desk = ExerciseDesk(replace(TASK, kind="complete", start="LD I0.0\n____\n= Q0.0\n", right=(RIGHT,)))
    assert [one["row"] for one in types(desk, desk.source)["diagnostics"] if one["row"] == 2] == []


def test_a_desk_begins_with_the_exercises_start_or_a_given_text() -> None:
    begun = replace(TASK, start="LD I0.0\n")
    assert ExerciseDesk(begun).source == "LD I0.0\n"
    assert ExerciseDesk(begun, "").source == ""
    assert repr(ExerciseDesk(begun)) == "ExerciseDesk(mine)"


# Show me.


def test_show_me_opens_on_the_step_that_goes_wrong_with_the_reference_beside_it() -> None:
    desk = ExerciseDesk(TASK, WRONG)
    presses(desk, "show")
    assert desk.film == "", "there is nothing to show before a check"
    presses(desk, "check")
    presses(desk, "show")
    film, beside = said(desk, "film"), said(desk, "beside")
    assert [line["text"] for line in film["lines"]] == ["LD I0.0", "O I0.1", "= Q0.0"]
    assert dict(film["steps"][0]["read"]) == {"I0.0": "1", "I0.1": "0"}
    assert film["steps"][-1]["write"] == [["Q0.0", "1"]]
    assert film["lines"][film["steps"][desk.index]["line"]]["text"] == "O I0.1"
    other = beside["film"]
    assert other["lines"][other["steps"][beside["index"]]["line"]]["text"] == "A I0.1"
    assert "O I0.1" in beside["say"]["en"]
    assert "A I0.1" in beside["say"]["zh"]


def test_show_me_plays_the_scan_in_which_they_differ() -> None:
    sealed = replace(TASK, reference="--[ I0.0 ]--+--[/I0.1 ]--( Q0.0 )\n--[ Q0.0 ]--+")
    desk = ExerciseDesk(sealed, "LD I0.0\nAN I0.1\n= Q0.0")
    presses(desk, "check")
    presses(desk, "show")
    assert {step["scan"] for step in said(desk, "film")["steps"]} == {1}
    verdict = said(desk, "verdict")
    assert verdict["picture"]["en"].startswith("<svg"), "more than one scan is a timing chart"
    assert ExerciseDesk(TASK, WRONG).check().verdict.counterexample is not None


def test_the_chosen_ladder_is_played_against_the_list() -> None:
    name = FIRST["match"]
    desk = ExerciseDesk(name)
    wrong = next(letter for letter in "ABCD" if letter != model(exercise(name)))
    types(desk, wrong)
    presses(desk, "check")
    presses(desk, "show")
    assert said(desk, "verdict")["canShow"]
    assert said(desk, "film")["steps"]


# Hints, feedback and the model answer.


def test_hints_come_one_by_one_and_are_counted() -> None:
    desk = ExerciseDesk(TASK)
    assert said(desk, "hints") == {"shown": [], "left": 1}
    presses(desk, "hint")
    assert said(desk, "hints") == {"shown": [{"zh": "提示", "en": "a hint"}], "left": 1}
    presses(desk, "hint")
    presses(desk, "hint")
    assert [one["en"] for one in said(desk, "hints")["shown"]] == ["a hint", "another"]
    assert (said(desk, "hints")["left"], said(desk, "kept")["hints"]) == (0, 2)
    types(desk, WRONG)
    presses(desk, "check")
    presses(desk, "hint")
    assert len(said(desk, "hints")["shown"]) == 3, "an answer brings hints of its own"
    types(desk, RIGHT)
    presses(desk, "check")
    assert said(desk, "hints")["left"] == 0


PREDICT = replace(TASK, kind="predict", given="LD I0.0\nA I0.1\n= Q0.0", levels=2, scans=({"I0.0": 1, "I0.1": 0},))


def test_a_grid_is_marked_row_by_row_as_far_as_it_is_filled_in() -> None:
    desk = ExerciseDesk(PREDICT)
    assert types(desk, "1 .\n. .\n. .\n")["marks"] == {"rows": ["right", "", ""], "cells": []}
    assert types(desk, "1 .\n1 .\n. .\n")["marks"] == {"rows": ["right", "wrong", ""], "cells": [[1, 0]]}
    assert types(desk, "1 .\n. .\n0 .\n")["marks"]["rows"] == ["right", "wrong", "right"], (
        "a row that was passed over is done"
    )
    desk.feedback = "final"
    assert "marks" not in types(desk, "1 .\n1 .\n. .\n")
    presses(desk, "check")
    assert said(desk, "verdict")["wrong"][0] == [1, 0]


def test_a_chart_is_marked_when_an_outputs_row_is_full() -> None:
    desk = ExerciseDesk(replace(PREDICT, kind="chart", scans=({}, {"I0.0": 1, "I0.1": 1}, {"I0.0": 0})))
    task = said(desk, "task")
    assert task["waves"] == [
        {"address": "I0.0", "values": ["0", "1", "0"]},
        {"address": "I0.1", "values": ["0", "1", "1"]},
    ]
    assert "I0.1" not in task["text"]["en"], "the grid draws the inputs itself"
    assert types(desk, "Q0.0 01.\n")["marks"]["rows"] == [""]
    assert types(desk, "Q0.0 011\n")["marks"] == {"rows": ["wrong"], "cells": [[0, 2]]}
    assert types(desk, "Q0.0 010\n")["marks"]["rows"] == ["right"]


def test_the_model_answer_is_shown_after_an_attempt_and_ends_the_best_mark() -> None:
    desk = ExerciseDesk(PREDICT)
    presses(desk, "model")
    assert desk.model == ""
    types(desk, "1 .\n1 .\n. .\n")
    presses(desk, "check")
    best = said(desk, "kept")["best"]
    presses(desk, "model")
    assert desk.model == model(PREDICT)
    film = said(desk, "film")
    assert film["lines"][film["steps"][desk.index]["line"]]["text"] == "A I0.1", "it opens on the row that was wrong"
    types(desk, desk.model)
    presses(desk, "check")
    assert said(desk, "verdict")["marks"] == PREDICT.points
    assert (said(desk, "kept")["best"], said(desk, "kept")["model"], said(desk, "kept")["attempts"]) == (best, True, 2)


def test_of_a_program_the_desk_has_no_model_answer() -> None:
    desk = ExerciseDesk(TASK, WRONG)
    desk.check()
    presses(desk, "model")
    assert (desk.model, said(desk, "task")["model"]) == ("", False)


# Hidden exercises.

HIDDEN = "LD I0.0\n= M17.5\nLD M17.5\nA I0.1\n= Q0.0\n"


def everything(desk: ExerciseDesk) -> str:
    """Gather all that leaves the kernel."""
    state = {name: getattr(desk, name) for name in desk.traits(sync=True) if name not in {"_esm", "_css", "layout"}}
    return json.dumps(state, default=str, ensure_ascii=False) + html(desk) + repr(desk)


@pytest.mark.parametrize("drawn", [False, True])
def test_of_a_hidden_exercise_the_reference_is_shown_nowhere(*, drawn: bool) -> None:
    ladder = "--[ I0.0 ]--( M17.5 )\n\n--[ M17.5 ]--[ I0.1 ]--( Q0.0 )"
    task = replace(TASK, hidden=True, reference=ladder if drawn else HIDDEN)
    desk = ExerciseDesk(task, WRONG)
    desk.check()
    for _ in range(6):
        presses(desk, "hint")
    presses(desk, "show")
    presses(desk, "model")
    shown = everything(desk)
    assert "M17.5" not in shown
    assert "film" not in said(desk, "beside")
    assert said(desk, "film")["lines"]
    assert said(desk, "task")["ladders"] == []


@pytest.mark.parametrize("feedback", ["each", "final", "rows", ""])
@pytest.mark.parametrize("kind", ["predict", "chart"])
def test_a_hidden_grid_is_not_marked_while_it_is_filled_in_whatever_the_page_asks(kind: str, feedback: str) -> None:
    """The right cells are 1, 0, 0 of the prediction and 0, 1, 0 of the chart; each row is all wrong here."""
    scans = ({"I0.0": 1, "I0.1": 0},) if kind == "predict" else ({}, {"I0.0": 1, "I0.1": 1}, {"I0.0": 0})
    desk = ExerciseDesk(replace(PREDICT, kind=kind, scans=scans, hidden=True))
    desk.feedback = feedback
    reports = [
        types(desk, text)
        for text in (("0 .\n1 .\n1 .\n", model(PREDICT)) if kind == "predict" else ("Q0.0 101", "Q0.0 010"))
    ]
    assert [{**one, "source": 0} for one in reports] == [{**reports[0], "source": 0}] * 2
    assert "marks" not in reports[0]
    assert said(desk, "task")["tells"] is False
    assert said(ExerciseDesk(PREDICT), "task")["tells"] is True


def test_trouble_with_a_hidden_exercise_tells_nothing_of_it() -> None:
    desk = ExerciseDesk(replace(TASK, hidden=True, reference=HIDDEN.replace("LD M17.5", "LDX M17.5")), WRONG)
    with pytest.raises(PlcTeachError, match="has an error itself") as trouble:
        desk.check()
    whole = "".join(trouble.getrepr(style="native", showlocals=False).reprtraceback.__str__())
    assert "M17.5" not in whole
    assert trouble.value.__suppress_context__
    with pytest.raises(PlcTeachError, match="LDX"):
        ExerciseDesk(replace(TASK, reference=HIDDEN.replace("LD M17.5", "LDX M17.5")), WRONG).check()


def test_the_verbs_are_found() -> None:
    assert isinstance(plcteach.desk("s7-two-blocks", size=2), ExerciseDesk)
