"""An answer that is a program, judged: held against the reference, against what the task asks for, and marked."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from plcteach.check.against import reference, verdict_on
from plcteach.check.answers import drawing, text_of
from plcteach.check.judgement import UNMET, Judgement
from plcteach.check.marks import parted, shares_of
from plcteach.check.needs import unmet
from plcteach.core.diagnostic import rule
from plcteach.core.source import Span
from plcteach.core.text import Text
from plcteach.core.verdict import Verdict
from plcteach.stl import read, write

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.exercise import Exercise
    from plcteach.core.ladder import Ladder
    from plcteach.core.program import Program

_MISSING = Text("作用是对的，但题目还要求：{need}", "It does the right thing; the task asks for one thing more: {need}")


def judged_program(
    exercise: Exercise,
    answer: str | bytes,
    wanted: Program,
    refused: Callable[[Program], tuple[Diagnostic, ...]] = lambda _: (),
) -> Judgement:
    """Judge a program; `refused` gives what this kind of task does not accept, whatever the program does."""
    text = text_of(answer)
    program = read(text, exercise.dialect)
    found = refused(program) if program.lines else ()
    verdict = verdict_on(wanted, program, exercise.terms)
    if found:
        others = tuple(one for one in verdict.diagnostics if not one.code.startswith("CHK"))
        verdict = Verdict("error", outputs=verdict.outputs, diagnostics=(*found, *others))
    lacking = unmet(exercise, program) if verdict.status != "error" else ()
    if lacking:
        told = tuple(rule(UNMET).at(Span(0), need=one) for one in lacking)
        verdict = replace(verdict, diagnostics=verdict.diagnostics + told)
    met = 1 - len(lacking) / len(exercise.needs) if exercise.needs else 1.0
    parts, marks = parted(exercise, shares_of(verdict, met), capped=bool(lacking))
    said = tuple(_MISSING.format(need=one) if verdict.status == "equal" else one for one in lacking)
    return Judgement(exercise, text, program, verdict, marks, parts, said)


def drawn(exercise: Exercise) -> tuple[Ladder, ...]:
    """Give the ladder that the list is to be written for: the reference's drawing, unless it is to stay hidden."""
    return drawing(exercise.given) or drawing("" if exercise.hidden else exercise.reference)


def written(exercise: Exercise) -> str:
    """Give the first right sample, else the reference as a list."""
    return exercise.right[0] if exercise.right else write(reference(exercise.reference, exercise.dialect))
