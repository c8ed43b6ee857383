"""The ConceptTest: twelve short questions about the usual wrong ideas, before a course and after it, and the two compared.

While it runs it tells nothing: no verdict, no hint, no answer. After the first time only the number of right answers is told, so
that the second time still asks something.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Literal

import traitlets

from plcteach.check.judge import judge
from plcteach.core.text import Text
from plcteach.exercises import concept_test as questions
from plcteach.widgets.desk import ExerciseDesk
from plcteach.widgets.keeping import Record, Table
from plcteach.widgets.material import sheet_of, still_of
from plcteach.widgets.show import module

if TYPE_CHECKING:
    from plcteach.core.exercise import Exercise

Phase = Literal["before", "between", "after", "done"]
NAME = "concept"
_GAIN = Text(
    "课前答对{before}题，课后答对{after}题，共{all}题。",
    "Before the course {before} of {all} were right, after it {after}.",
)
_ENOUGH = 1e-9


class ConceptTest(ExerciseDesk):
    """Answer the questions of the concept test one after the other; answers and results are kept beside the notebook.

    quiz: how far it is, and the results, as JSON.
    """

    _esm = module("render-quiz.js")
    _tells = False
    quiz = traitlets.Unicode("{}").tag(sync=True)

    def __init__(self, **values: Any) -> None:
        self._items = questions()
        self._at = 0
        super().__init__(self._items[0], feedback="final", **values)
        self._go(self._first_open())

    @property
    def phase(self) -> Phase:
        """How far it is: before the course, between, after the course, or done."""
        if not self._taken("before").get("done"):
            return "before"
        if not self._taken("after"):
            return "between"
        return "done" if self._taken("after").get("done") else "after"

    def _taken(self, phase: str) -> Table:
        """Give what is kept of one time that the test is taken."""
        row = self._notes.test(NAME).get(phase)
        return row if isinstance(row, dict) else {}

    def _answers(self) -> dict[str, Any]:
        answers = self._taken("after" if self.phase == "after" else "before").get("answers")
        return answers if isinstance(answers, dict) else {}

    def _record(self) -> Record:
        text = self._answers().get(self._exercise.id)
        return Record(text=text if isinstance(text, str) else None, start=self._start)

    def _write(self) -> None:
        phase = self.phase
        if phase in {"before", "after"}:
            self._change(phase, answers={**self._answers(), self._exercise.id: self.source})

    def _change(self, phase: str, **news: Any) -> None:
        def change(row: Table) -> None:
            now = row.get(phase)
            row[phase] = {**(now if isinstance(now, dict) else {}), **news}

        self._notes.change(NAME, change, among="tests")

    def _first_open(self) -> int:
        answers = self._answers()
        return next((number for number, one in enumerate(self._items) if one.id not in answers), 0)

    def _go(self, number: int) -> None:
        """Open one of the questions."""
        self._at = min(max(0, number), len(self._items) - 1)
        self._open(self._items[self._at])
        self._say_quiz()

    def _changed(self, change: object) -> None:
        super()._changed(change)
        self._say_quiz()

    def _asked(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        """Do what a button in the page asks; a test has no check, no hint and no model answer."""
        match content.get("type"):
            case "go" if isinstance(content.get("at"), int):
                self._go(content["at"])
            case "finish":
                self.finish()
            case "begin" if self.phase == "between":
                self._change("after", answers={})
                self._go(0)

    def finish(self) -> None:
        """Judge all answers of this time, and keep the results."""
        phase, answers = self.phase, self._answers()
        if phase in {"before", "after"}:
            right = {one.id: _right(one, str(answers.get(one.id, ""))) for one in self._items}
            self._change(phase, right=right, done=True)
            self._go(0)

    def _say_quiz(self) -> None:
        answers, phase = self._answers(), self.phase
        told = {
            "phase": phase,
            "at": self._at,
            "answered": [one.id in answers for one in self._items],
            "result": self._result(phase),
        }
        self.quiz = json.dumps(told, ensure_ascii=False)

    def _result(self, phase: Phase) -> dict[str, Any]:
        """Give what may be told: after the first time a number, after the second everything."""
        before, after = (self._rights(one) for one in ("before", "after"))
        counts = {"all": len(self._items), "before": sum(before), "after": sum(after)}
        if phase == "between":
            return {"all": counts["all"], "before": counts["before"]}
        if phase != "done":
            return {}
        rows = [
            {"title": one.title.as_dict(), "before": was, "after": now, "lesson": one.lesson}
            for one, was, now in zip(self._items, before, after, strict=True)
        ]
        return {**counts, "rows": rows, "say": _GAIN.format(**counts).as_dict()}

    def _rights(self, phase: str) -> list[bool]:
        right = self._taken(phase).get("right")
        return [isinstance(right, dict) and right.get(one.id) is True for one in self._items]

    def _words(self) -> str:
        return f"ConceptTest({len(self._items)} questions)"

    def _still(self) -> str:
        return "".join(still_of(one, sheet_of(one)) for one in self._items)


def _right(exercise: Exercise, answer: str) -> bool:
    return judge(exercise, answer).marks >= exercise.points - _ENOUGH


def concept_test(*, size: float = 1.0) -> ConceptTest:
    """Open the concept test: twelve questions, before the course and after it."""
    return ConceptTest(size=size)
