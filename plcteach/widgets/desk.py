"""The ExerciseDesk: a task, the place for its answer, Check, what differs and where, hints one by one; and all of it kept."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import traitlets

from plcteach.check.discreet import discreet
from plcteach.check.drill import task_of as find_exercise
from plcteach.check.judge import Judgement, judge, model
from plcteach.check.lint import lint
from plcteach.core.diagnostic import errors
from plcteach.core.text import NOTHING, Text
from plcteach.dialects import dialect as find_dialect
from plcteach.stl import read
from plcteach.widgets.answered import Hints, marks_of, verdict_of
from plcteach.widgets.bench import as_json
from plcteach.widgets.keeping import Notes, Record, aside, hinted, modelled, tried, typed
from plcteach.widgets.material import sheet_of, still_of, task_of
from plcteach.widgets.replay import Replay, given_run, wrong_run
from plcteach.widgets.show import Shown, module, styles

if TYPE_CHECKING:
    from pathlib import Path

    from plcteach.core.exercise import Exercise

_GAP = "____"


class ExerciseDesk(Shown):
    """Work on one exercise: answer, check, see what differs and on which step.

    exercise: its id, a teacher's own file, or the exercise itself.  text: what stands in it at first, instead of the exercise's own
    start; what was typed before into the same start comes back, and what was typed into another one can be put back.  The last
    judgement stands in `judgement`.  feedback: of a grid, "each" row or "final" only.  The other traits are JSON for the page;
    nothing of a hidden exercise's reference is in any of them.
    """

    _esm = module("render-desk.js")
    _css = styles("player.css", "bench.css", "desk.css")
    task = traitlets.Unicode("{}").tag(sync=True)
    source = traitlets.Unicode("").tag(sync=True)
    film = traitlets.Unicode("").tag(sync=True)
    beside = traitlets.Unicode("").tag(sync=True)
    report = traitlets.Unicode("{}").tag(sync=True)
    verdict = traitlets.Unicode("").tag(sync=True)
    hints = traitlets.Unicode("{}").tag(sync=True)
    kept = traitlets.Unicode("{}").tag(sync=True)
    model = traitlets.Unicode("").tag(sync=True)
    feedback = traitlets.Unicode("each").tag(sync=True)
    serial = traitlets.Int(0).tag(sync=True)
    index = traitlets.Int(0).tag(sync=True)

    _tells = True
    """Whether a grid may be marked while it is filled in; that of a hidden exercise never is."""

    def __init__(self, exercise: str | Path | Exercise, text: str | None = None, **values: Any) -> None:
        self._notes = Notes()
        super().__init__(**values)
        self._open(find_exercise(exercise), text)
        self.observe(self._changed, names=["serial", "feedback"])
        self.on_msg(self._asked)

    def _open(self, exercise: Exercise, text: str | None = None) -> None:
        """Put an exercise on the desk, with what was typed before."""
        self._exercise, self._sheet = exercise, sheet_of(exercise)
        self._dialect = find_dialect(exercise.dialect)
        self.judgement: Judgement | None = None
        self._hints = Hints(exercise)
        self._start = self._sheet.start if text is None else text
        self._known = self._record().begun_with(self._start)
        with self.hold_sync():
            self.task = json.dumps(task_of(exercise, self._sheet), ensure_ascii=False)
            self.source = self._start if self._known is None else self._known
            self.verdict = self.film = self.beside = self.model = ""
            self._say_hints()
            self._say_kept()
            self._answer()

    def _record(self) -> Record:
        """Give what is kept of the exercise."""
        return self._notes.record(self._exercise.id)

    def _changed(self, _change: object) -> None:
        self._keep()
        self._answer()

    def _keep(self) -> None:
        """Keep the text as typed in the file beside the notebook; opening a desk alone writes nothing."""
        if self.source in {self._known, self._start if self._known is None else self._known}:
            return
        self._write()
        self._known = self.source
        self._say_kept()

    def _write(self) -> None:
        self._notes.change(self._exercise.id, typed(self.source, self._start, self._known))

    def _answer(self) -> None:
        """Tell the page what is found in the text as it is typed; of a grid that is not hidden, which rows are right."""
        found = lint(read(self.source, self._dialect)) if self._sheet.form == "list" else ()
        gaps = {number for number, row in enumerate(self.source.split("\n"), 1) if _GAP in row}
        report = {
            "source": self.serial,
            "diagnostics": [as_json(one) for one in found if one.span.row not in gaps],
            "ok": not errors(found),
            "dialect": {"title": self._dialect.title.as_dict()},
        }
        if self._sheet.form == "grid" and self.feedback == "each" and self._tells and not self._exercise.hidden:
            report["marks"] = marks_of(self._exercise, self.source)
        self.report = json.dumps(report, ensure_ascii=False)

    def _say_hints(self) -> None:
        """Tell the page the hints that were asked for; the others stay here."""
        said = [one.as_dict() for one in self._hints.told]
        self.hints = json.dumps({"shown": said, "left": int(self._hints.some)}, ensure_ascii=False)

    def _say_kept(self) -> None:
        record = self._record()
        trouble = self._notes.trouble or NOTHING
        self.kept = json.dumps(
            {
                "attempts": record.attempts,
                "best": record.best,
                "hints": max(record.hints, len(self._hints.told)),
                "model": record.model,
                "earlier": sum(text != self.source for text in record.besides(self._start)),
                "trouble": trouble.as_dict(),
            },
            ensure_ascii=False,
        )

    def _asked(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        """Do what a button in the page asks."""
        deeds = {
            "check": self.check,
            "show": self.show,
            "hint": self.hint,
            "model": self.show_model,
            "restore": self.restore,
        }
        deed = deeds.get(str(content.get("type")))
        if deed:
            deed()

    def check(self) -> Judgement:
        """Judge the answer as it stands now, and count the attempt."""
        self._keep()
        with discreet(self._exercise):
            self.judgement = judge(self._exercise, self.source)
        self._hints.after(self.judgement)
        self._notes.change(self._exercise.id, tried(self.judgement.marks, self._exercise.points))
        with self.hold_sync():
            self._say_kept()
            self._say_hints()
            self.verdict = json.dumps(verdict_of(self.judgement), ensure_ascii=False)
        return self.judgement

    def hint(self) -> Text | None:
        """Give the next hint, and count it; None when there is no other."""
        with discreet(self._exercise):
            another = self._hints.next()
        if another:
            self._notes.change(self._exercise.id, hinted(len(self._hints.told)))
        with self.hold_sync():
            self._say_hints()
            self._say_kept()
        return another

    def restore(self) -> None:
        """Put back a text that was typed before and is not shown, once more the next one; what stands here now is kept."""
        self._keep()
        others = self._record().besides(self._start)
        if not set(others) - {self.source}:
            return
        at = others.index(self.source) + 1 if self.source in others else 0
        if self.source not in {*others, self._start}:
            self._notes.change(self._exercise.id, aside(self.source))
        with self.hold_sync():
            self.source = others[at % len(others)]
            self._keep()
            self._say_kept()
            self._answer()

    def show(self) -> None:
        """Put the learner's own program into the player, where it goes wrong, and the reference's run beside it."""
        if self.judgement:
            with discreet(self._exercise):
                replay = wrong_run(self.judgement)
            self._play(replay)

    def show_model(self) -> None:
        """Show an answer that gets full marks, once the learner has tried; marks after that are not counted as the best."""
        if self._sheet.form == "list" or self._exercise.hidden or not self._record().attempts:
            return
        self._notes.change(self._exercise.id, modelled)
        with self.hold_sync():
            self.model = model(self._exercise)
            self._say_kept()
        self._play(given_run(self._exercise, self._sheet, self.judgement))

    def _play(self, replay: Replay | None) -> None:
        if replay:
            with self.hold_sync():
                self.index = replay.index
                self.beside = json.dumps(replay.beside, ensure_ascii=False)
                self.film = replay.film

    def _words(self) -> str:
        return f"ExerciseDesk({self._exercise.id})"

    def _still(self) -> str:
        return still_of(self._exercise, self._sheet)
