"""The ExerciseDesk: a task with its ladder, an editor, Check, a counterexample, and "show me"."""

from __future__ import annotations

import json
from html import escape
from typing import TYPE_CHECKING, Any

import traitlets

from plcteach.check.judge import Judgement, judge
from plcteach.check.lint import lint
from plcteach.check.report import verdict_json
from plcteach.core.diagnostic import errors
from plcteach.core.text import language
from plcteach.dialects import dialect as find_dialect
from plcteach.exercises import exercise as find_exercise
from plcteach.figure.film import film
from plcteach.figure.ladder import ladder_scene
from plcteach.figure.svg import svg
from plcteach.ladder.picture import read_drawing
from plcteach.ladder.telling import is_drawing
from plcteach.machine.scan import run
from plcteach.stl import read
from plcteach.widgets.bench import as_json
from plcteach.widgets.show import Shown, module, styles

if TYPE_CHECKING:
    from plcteach.core.exercise import Exercise


class ExerciseDesk(Shown):
    """Work on one exercise: type, check, see what differs and on which step.

    exercise: its id or the exercise itself.  The last judgement stands in `judgement`.
    """

    _esm = module("render-desk.js")
    _css = styles("player.css", "bench.css")
    task = traitlets.Unicode("{}").tag(sync=True)
    source = traitlets.Unicode("").tag(sync=True)
    film = traitlets.Unicode("").tag(sync=True)
    report = traitlets.Unicode("{}").tag(sync=True)
    verdict = traitlets.Unicode("").tag(sync=True)
    serial = traitlets.Int(0).tag(sync=True)
    index = traitlets.Int(0).tag(sync=True)

    def __init__(self, exercise: str | Exercise, text: str | None = None, **values: Any) -> None:
        self._exercise = find_exercise(exercise)
        self._dialect = find_dialect(self._exercise.dialect)
        self.judgement: Judgement | None = None
        start = self._exercise.start if text is None else text
        super().__init__(task=json.dumps(self._task(), ensure_ascii=False), source=start, **values)
        self._answer()
        self.observe(self._changed, names=["serial"])
        self.on_msg(self._asked)

    def _task(self) -> dict[str, Any]:
        one = self._exercise
        return {
            "id": one.id,
            "title": one.title.as_dict(),
            "task": one.task.as_dict(),
            "ladder": self._ladder(),
            "hints": [hint.as_dict() for hint in one.hints],
            "max": one.points,
            "dialect": {"name": self._dialect.name, "title": self._dialect.title.as_dict()},
            "list": self._dialect.list.as_dict(),
        }

    def _ladder(self) -> dict[str, str]:
        if not is_drawing(self._exercise.reference):
            return {}
        ladder, _ = read_drawing(self._exercise.reference)
        scene = ladder_scene(ladder)
        return {lang: svg(scene, lang) for lang in ("zh", "en")}

    def _changed(self, _change: object) -> None:
        self._answer()

    def _answer(self) -> None:
        found = lint(read(self.source, self._dialect))
        report = {"source": self.serial, "diagnostics": [as_json(one) for one in found], "ok": not errors(found)}
        self.report = json.dumps({**report, "dialect": {"title": self._dialect.title.as_dict()}}, ensure_ascii=False)

    def _asked(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        """Do what a button in the page asks: check, or show where it goes wrong."""
        if content.get("type") == "check":
            self.check()
        elif content.get("type") == "show":
            self.show()

    def check(self) -> Judgement:
        """Judge the text as it stands now."""
        self.judgement = judge(self._exercise, self.source)
        self.verdict = json.dumps(verdict_json(self.judgement), ensure_ascii=False)
        return self.judgement

    def show(self) -> None:
        """Put the learner's own program, run on the counterexample's inputs, into the player."""
        example = self.judgement.verdict.counterexample if self.judgement else None
        if self.judgement and example:
            trace = run(self.judgement.program, example.inputs)
            shot = film(trace.scans[-1:], self._exercise.title, rows=True)
            with self.hold_sync():
                self.index = 0
                self.film = shot.json

    def _words(self) -> str:
        return f"ExerciseDesk({self._exercise.id})"

    def _still(self) -> str:
        lang, one = language(), self._exercise
        return (
            f"<h4>{escape(one.title.in_(lang))}</h4><p>{escape(one.task.in_(lang))}</p>{self._ladder().get(lang, '')}"
        )
