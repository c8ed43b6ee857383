"""What a desk tells after an answer: the verdict as the page wants it, which rows of a grid are right, and the hints there are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from plcteach.check.chart import chart_of
from plcteach.check.chart_scene import chart_scene_of
from plcteach.check.hints import hints
from plcteach.check.judge import judge, model
from plcteach.check.judgement import UNMET
from plcteach.check.report import verdict_json
from plcteach.figure.svg import svg

if TYPE_CHECKING:
    from plcteach.check.judge import Judgement
    from plcteach.core.exercise import Exercise
    from plcteach.core.text import Text

MOST_REMARKS = 20
_EMPTY = set(".-_")
_TYPED = ("write", "complete", "bug", "translate")
"""The kinds whose answer stands in the editor, which shows what there is to say about each row."""


def verdict_of(judgement: Judgement) -> dict[str, Any]:
    """Give a judgement as the desk in the browser wants it: with the remarks that no editor shows, and the chart drawn."""
    typed = judgement.exercise.kind in _TYPED
    found = judgement.verdict.diagnostics
    remarks = [one for one in found if one.code != UNMET and (not typed or one.code.startswith(("CHK", "KND")))]
    return {
        **verdict_json(judgement),
        "remarks": [one.text.as_dict() for one in remarks[:MOST_REMARKS]],
        "picture": _picture(judgement),
    }


def _picture(judgement: Judgement) -> dict[str, str]:
    """Draw the counterexample as a timing chart, where it takes more than one scan; else its values are a row of a table."""
    chart = chart_of(judgement.verdict)
    if chart is None or len(chart.columns) == 1:
        return {}
    scene = chart_scene_of(chart)
    return {lang: svg(scene, lang) for lang in ("zh", "en")}


def marks_of(exercise: Exercise, text: str) -> dict[str, Any]:
    """Say of each row of a grid that is done whether it is right; one that is being filled in is left in peace.

    A row is done when as much is filled in as there is to fill in, or when a later row has been begun.  Not for a hidden
    exercise: where a cell is 0 or 1, to know that it is wrong is to know what is right.
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


class Hints:
    """The hints of one desk, given one by one: those that fit the last answer, before the first answer the exercise's own.

    They are only worked out when one is asked for: a repair takes a while to be proved.
    """

    def __init__(self, exercise: Exercise) -> None:
        self.exercise = exercise
        self.told: list[Text] = []
        self.judgement: Judgement | None = None
        self._waiting: list[Text] | None = list(exercise.hints)

    def after(self, judgement: Judgement) -> None:
        """Fit the hints to an answer."""
        self.judgement, self._waiting = judgement, None

    @property
    def some(self) -> bool:
        """Whether there may be another; of a right answer nothing is left to be said."""
        if self._waiting is not None:
            return bool(self._waiting)
        return self.judgement is not None and self.judgement.verdict.status != "equal"

    def next(self) -> Text | None:
        """Give the next hint that has not been told yet; None when there is no other."""
        if self._waiting is None and self.judgement is not None:
            self._waiting = [one for one in hints(self.judgement) if one not in self.told]
        if not self._waiting:
            return None
        self.told.append(self._waiting.pop(0))
        return self.told[-1]
