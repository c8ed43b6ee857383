"""What the player of a desk shows: the learner's program where it goes wrong with the reference's run beside it, or the run asked about."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from plcteach.check.answers import looked_at
from plcteach.check.astray import astray
from plcteach.check.judge import model
from plcteach.core.text import Text, joined
from plcteach.figure.film import film
from plcteach.machine.scan import run
from plcteach.stl import read
from plcteach.widgets.material import course_of

if TYPE_CHECKING:
    from plcteach.check.judge import Judgement, Sheet
    from plcteach.core.exercise import Exercise
    from plcteach.core.program import Program
    from plcteach.figure.film import Film

_REFERENCE = Text("参考程序", "The reference")
_RUN = Text("题目中的程序就是这样执行的。", "This is how the program of the task is carried out.")


@dataclass(frozen=True, slots=True)
class Replay:
    """A film, the step on which it opens, and what stands beside it: a sentence, and another film with its own step."""

    film: str
    index: int
    beside: dict[str, Any] = field(default_factory=dict)


def wrong_run(judgement: Judgement) -> Replay | None:
    """Play the scan in which the outputs differ, from the step at which the stack goes wrong."""
    example, mine = judgement.verdict.counterexample, judgement.program
    if example is None or mine is None:
        return None
    exercise = judgement.exercise
    wanted = _wanted(exercise)
    found = astray(wanted, mine, example)
    shot = film([run(mine, example.inputs).scans[found.scan]], exercise.title, rows=True)
    if exercise.hidden:
        return Replay(shot.json, _step(shot, found.line), {"say": found.says.as_dict()})
    other = film([run(wanted, example.inputs).scans[found.scan]], _REFERENCE)
    said = joined((found.says, found.beside)).as_dict()
    beside = {"say": said, "film": other.data, "index": _step(other, found.other)}
    return Replay(shot.json, _step(shot, found.line), beside)


def given_run(exercise: Exercise, sheet: Sheet, judgement: Judgement | None) -> Replay | None:
    """Play the program that the task is about, from the first row that was not right."""
    trace = course_of(exercise, sheet) if sheet.form in {"grid", "blocks"} else None
    if trace is None:
        return None
    scans = trace.scans if exercise.kind == "chart" else trace.scans[-1:]
    shot = film(scans, exercise.title)
    row = judgement.wrong[0][0] if judgement and judgement.wrong and exercise.kind == "predict" else None
    row = exercise.row - 1 if exercise.row else row
    return Replay(shot.json, _step(shot, row), {"say": _RUN.as_dict()})


def _wanted(exercise: Exercise) -> Program:
    """Give the program that the answer is held against: the list of a choice, else an answer that gets full marks."""
    return looked_at(exercise) if exercise.kind == "match" else read(model(exercise), exercise.dialect)


def _step(shot: Film, line: int | None) -> int:
    """Give the first step of a film that carries out a line; its beginning where there is none."""
    steps = shot.data["steps"]
    return next((number for number, one in enumerate(steps) if line is not None and one["line"] == line), 0)
