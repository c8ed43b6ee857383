"""Write the list: for a ladder that is shown, or for a task in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.against import reference
from plcteach.check.judgement import Judgement, Sheet
from plcteach.check.needs import unmet
from plcteach.check.program import drawn, judged_program
from plcteach.stl import write

if TYPE_CHECKING:
    from plcteach.core.exercise import Exercise


def shown(exercise: Exercise) -> Sheet:
    """Give the ladder, if the reference is a drawing that may be seen, and what stands in the editor at first."""
    return Sheet("list", ladders=drawn(exercise), start=exercise.start)


def judged(exercise: Exercise, answer: str | bytes) -> Judgement:
    """Hold the list against the reference."""
    return judged_program(exercise, answer, reference(exercise.reference, exercise.dialect))


def model(exercise: Exercise) -> str:
    """Write the reference out as a list; where the task asks for more than that shows, give the first right sample."""
    wanted = reference(exercise.reference, exercise.dialect)
    if unmet(exercise, wanted) and exercise.right:
        return exercise.right[0]
    return write(wanted)
