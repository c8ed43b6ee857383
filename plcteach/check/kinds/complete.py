"""Complete a list: the lines that are given stay, in their order, and `____` stands where some are missing."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from plcteach.check.against import reference
from plcteach.check.judgement import Judgement, Sheet
from plcteach.check.program import drawn, judged_program, written
from plcteach.core.diagnostic import rule
from plcteach.core.source import Span
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.exercise import Exercise
    from plcteach.core.program import Program

BLANK = "____"
_BLANK = re.compile(r"_{3,}[^\n]*")
_MOST_IN_A_GAP = 4


def shown(exercise: Exercise) -> Sheet:
    """Give the ladder, and the list with its gaps."""
    return Sheet("list", ladders=drawn(exercise), start=exercise.start)


def judged(exercise: Exercise, answer: str | bytes) -> Judgement:
    """Hold the completed list against the reference; a given line that is missing is an error."""

    def refused(program: Program) -> tuple[Diagnostic, ...]:
        return _missing(exercise, program) or _overfilled(exercise, program)

    return judged_program(exercise, answer, reference(exercise.reference, exercise.dialect), refused)


def model(exercise: Exercise) -> str:
    """Give the first right sample, else the reference as a list."""
    return written(exercise)


def given_lines(exercise: Exercise) -> list[str]:
    """Give the lines that must stay, in their canonical spelling."""
    return [line.text for line in read(_BLANK.sub("", exercise.start), exercise.dialect).lines]


def _missing(exercise: Exercise, program: Program) -> tuple[Diagnostic, ...]:
    """Find the first given line that does not follow the ones before it."""
    lines = program.lines
    at = 0
    for wanted in given_lines(exercise):
        found = next((number for number in range(at, len(lines)) if lines[number].text == wanted), -1)
        if found < 0:
            row = lines[min(at, len(lines) - 1)].span.row
            return (rule("KND001").at(Span(row), line=wanted),)
        at = found + 1
    return ()


def _overfilled(exercise: Exercise, program: Program) -> tuple[Diagnostic, ...]:
    """Find that far more was filled in than is missing: a few lines for each gap, or as many as the full answer has."""
    given = len(given_lines(exercise))
    full = len(read(model(exercise), exercise.dialect).lines) - given
    most = max(_MOST_IN_A_GAP * len(_BLANK.findall(exercise.start)), full)
    got = len(program.lines) - given
    if got <= most:
        return ()
    return (rule("KND012").at(program.lines[given + most].span, got=got, most=most),)
