"""Mend a list: a program with a fault stands in the editor, and the answer is the program without it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.against import reference
from plcteach.check.judgement import Judgement, Sheet
from plcteach.check.program import drawn, judged_program, written
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.exercise import Exercise


def shown(exercise: Exercise) -> Sheet:
    """Give the ladder that was meant, and the list with its fault."""
    program = read(exercise.start, exercise.dialect)
    return Sheet("list", program=program, ladders=drawn(exercise), start=exercise.start)


def judged(exercise: Exercise, answer: str | bytes) -> Judgement:
    """Hold the mended list against the reference."""
    return judged_program(exercise, answer, reference(exercise.reference, exercise.dialect))


def model(exercise: Exercise) -> str:
    """Give the first right sample, which mends no more than it must; else the reference as a list."""
    return written(exercise)
