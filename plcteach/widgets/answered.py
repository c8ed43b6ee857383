"""What a desk tells after an answer: the verdict as the page wants it, which rows of a grid are right, and the hints there are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from plcteach.check.judge import judge, model
from plcteach.check.report import verdict_json
from plcteach.widgets.bench import as_json

if TYPE_CHECKING:
    from plcteach.check.judge import Judgement
    from plcteach.core.exercise import Exercise
    from plcteach.core.text import Text

_EMPTY = set(".-_")
_BESIDE = ("CHK", "STY", "KND")


def verdict_of(judgement: Judgement) -> dict[str, Any]:
    """Give a judgement as the desk in the browser wants it: the verdict, its parts, its remarks, and the cells that are wrong."""
    remarks = [one for one in judgement.verdict.diagnostics if one.code.startswith(_BESIDE)]
    return {
        **verdict_json(judgement),
        "parts": [{"name": one.name.as_dict(), "got": one.got, "of": one.of} for one in judgement.parts],
        "says": [one.as_dict() for one in judgement.says],
        "remarks": [as_json(one) for one in remarks],
        "wrong": [list(place) for place in judgement.wrong],
        "canShow": judgement.verdict.counterexample is not None and judgement.program is not None,
    }


def marks_of(exercise: Exercise, text: str) -> dict[str, Any]:
    """Say of each row of a grid that is done whether it is right; one that is being filled in is left in peace.

    A row is done when as much is filled in as there is to fill in, or when a later row has been begun.
    """
    wanted, given = (_filled(exercise, one) for one in (model(exercise), text))
    given += [0] * (len(wanted) - len(given))
    last = max((number for number, count in enumerate(given) if count), default=-1)
    later = exercise.kind != "chart"
    done = {
        number
        for number, count in enumerate(wanted)
        if (given[number] and given[number] >= count) or (later and number < last)
    }
    wrong = judge(exercise, text).wrong
    bad = {row for row, _ in wrong}
    rows = ["" if number not in done else "wrong" if number in bad else "right" for number in range(len(wanted))]
    return {"rows": rows, "cells": [list(place) for place in wrong if place[0] in done]}


def _filled(exercise: Exercise, text: str) -> list[int]:
    """Count for each row of a grid's text the cells in which something stands."""
    rows = [row.split() for row in text.split("\n") if row.strip()]
    if exercise.kind == "chart":
        rows = [list("".join(row[1:])) for row in rows]
        return [sum(sign != "." for sign in row) for row in rows]
    return [sum(not set(sign) <= _EMPTY for sign in row) for row in rows]


def hints_for(exercise: Exercise, judgement: Judgement | None) -> tuple[Text, ...]:
    """Give the hints in their order: those that fit the last answer, before the first answer the exercise's own."""
    return exercise.hints
