"""Translate a list into another family: what it does stays, and the addresses go by a table that is shown."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

from plcteach.check.against import reference
from plcteach.check.answers import drawing
from plcteach.check.judgement import Judgement, Sheet
from plcteach.check.program import judged_program
from plcteach.core.text import NOTHING, Text
from plcteach.ladder.either import read_either
from plcteach.ladder.translate import translate
from plcteach.stl import write

if TYPE_CHECKING:
    from plcteach.core.exercise import Exercise
    from plcteach.core.program import Program
    from plcteach.ladder.translation import Translation

_TABLE = Text("地址对应：{table}", "Addresses: {table}")


def shown(exercise: Exercise) -> Sheet:
    """Give the program of the other family, and which address becomes which where that is not for the learner to say."""
    program = read_either(exercise.given, exercise.source)
    return Sheet("list", _table(exercise), program, drawing(exercise.given), start=exercise.start)


def judged(exercise: Exercise, answer: str | bytes) -> Judgement:
    """Hold the list against the reference, or against the translation where there is none."""
    return judged_program(exercise, answer, _wanted(exercise))


def model(exercise: Exercise) -> str:
    """Write the reference, or the translation, out as a list."""
    return write(_wanted(exercise))


def _wanted(exercise: Exercise) -> Program:
    if _own(exercise):
        return reference(exercise.reference, exercise.dialect)
    return reference(_translated(exercise.given, exercise.source, exercise.dialect).text, exercise.dialect)


def _own(exercise: Exercise) -> bool:
    """Say whether the exercise has a reference of its own; the loader puts `given` where there is none."""
    return bool(exercise.reference.strip()) and exercise.reference != exercise.given


@lru_cache(maxsize=64)
def _translated(given: str, source: str, dialect: str) -> Translation:
    return translate(reference(given, source), dialect)


def _table(exercise: Exercise) -> Text:
    if _own(exercise):
        return NOTHING
    rows = _translated(exercise.given, exercise.source, exercise.dialect).addresses.items()
    return _TABLE.format(table=", ".join(f"{old} → {new}" for old, new in rows))
