"""Judges a learner's text against an exercise: what the text itself shows, what the machine does, and the marks for it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

from plcteach.check.lint import lint
from plcteach.check.same import compare
from plcteach.core.diagnostic import errors
from plcteach.core.errors import PlcTeachError
from plcteach.core.text import language
from plcteach.core.verdict import Verdict
from plcteach.exercises import exercise as find_exercise
from plcteach.ladder.either import read_either
from plcteach.ladder.telling import is_drawing
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.exercise import Exercise
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect


@dataclass(frozen=True, slots=True)
class Judgement:
    """One submission, judged: the program as it was read, the verdict, and the marks out of the exercise's points."""

    exercise: Exercise
    program: Program
    verdict: Verdict
    marks: float

    def __repr__(self) -> str:
        return f"Judgement({self.exercise.id}: {self.verdict.status}, {self.marks:g}/{self.exercise.points:g})"


def judge(exercise: Exercise | str, text: str | bytes) -> Judgement:
    """Judge a submission; UnknownNameError if there is no such exercise. The text may be anything at all."""
    task = find_exercise(exercise)
    program = read(text, task.dialect)
    verdict = verdict_on(reference(task.reference, task.dialect), program, task.level)
    return Judgement(task, program, verdict, _marks(verdict, task.points))


def verdict_on(wanted: Program, program: Program, level: str = "either") -> Verdict:
    """Compare a submission with the reference; with an error in its text or its stack there is nothing to compare."""
    found = lint(program)
    if errors(found) or not program.lines:
        return Verdict("error", diagnostics=found)
    verdict = compare(wanted, program, level=level)
    return replace(verdict, diagnostics=tuple(found) + verdict.diagnostics)


@lru_cache(maxsize=256)
def reference(text: str, dialect: str | Dialect) -> Program:
    """Read a reference, a ladder drawing or a program; PlcTeachError if it has an error itself."""
    program = read_either(text, dialect)
    if is_drawing(text) and errors(program.diagnostics):
        one = errors(program.diagnostics)[0]
        msg = f"reference, row {one.span.row}, column {one.span.start + 1}: {one.text.in_(language())}"
        raise PlcTeachError(msg)
    wrong = errors(lint(program))
    if wrong:
        msg = f"the reference has an error itself: {wrong[0]}"
        raise PlcTeachError(msg)
    if not any(line.insn.then and line.bits for line in program.lines):
        msg = "the reference writes no output, so there is nothing to compare"
        raise PlcTeachError(msg)
    return program


def _marks(verdict: Verdict, points: float) -> float:
    """Give full marks for equal, else half the points for the share of outputs that are proved equal."""
    if verdict.status == "equal":
        return points
    if not verdict.outputs or verdict.status == "error":
        return 0.0
    right = sum(status == "equal" for status in verdict.outputs.values())
    return round(points / 2 * right / len(verdict.outputs), 2)
