"""Judges a learner's answer to an exercise of any kind: what it is, what it gets marks for, and what there is to say."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.against import reference, verdict_on
from plcteach.check.discreet import discreet
from plcteach.check.drill import task_of as find_exercise
from plcteach.check.judgement import Judgement, Part, Sheet
from plcteach.check.kinds import KINDS

if TYPE_CHECKING:
    from pathlib import Path

    from plcteach.core.exercise import Exercise

__all__ = ["Judgement", "Part", "Sheet", "judge", "model", "reference", "shown", "verdict_on"]


def judge(exercise: Exercise | str | Path, answer: str | bytes) -> Judgement:
    """Judge an answer; UnknownNameError if there is no such exercise. The answer may be anything at all."""
    task = find_exercise(exercise)
    with discreet(task):
        return KINDS[task.kind].judged(task, answer)


def shown(exercise: Exercise | str | Path) -> Sheet:
    """Give what an exercise shows before it is answered."""
    task = find_exercise(exercise)
    with discreet(task):
        return KINDS[task.kind].shown(task)


def model(exercise: Exercise | str | Path) -> str:
    """Give an answer that gets full marks; PlcTeachError where the exercise itself has an error."""
    task = find_exercise(exercise)
    with discreet(task):
        return KINDS[task.kind].model(task)
