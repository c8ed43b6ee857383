"""Put lines in order: each is offered as often as it is needed, and some do not belong."""

from __future__ import annotations

from collections import Counter
from hashlib import sha256
from typing import TYPE_CHECKING

from plcteach.check.against import reference
from plcteach.check.judgement import Judgement, Sheet
from plcteach.check.program import drawn, judged_program
from plcteach.core.diagnostic import rule
from plcteach.core.text import counted
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.exercise import Exercise
    from plcteach.core.program import Program


def shown(exercise: Exercise) -> Sheet:
    """Give the ladder and the offered lines, in an order that depends on nothing but the exercise."""
    return Sheet("rows", ladders=drawn(exercise), rows=offered(exercise))


def judged(exercise: Exercise, answer: str | bytes) -> Judgement:
    """Hold the list against the reference; a line that was not offered is an error."""

    def refused(program: Program) -> tuple[Diagnostic, ...]:
        return _foreign(exercise, program)

    return judged_program(exercise, answer, reference(exercise.reference, exercise.dialect), refused)


def model(exercise: Exercise) -> str:
    """Give the first right sample, whose lines are the ones that are offered."""
    return exercise.right[0] if exercise.right else exercise.reference


def offered(exercise: Exercise) -> tuple[str, ...]:
    """Give the lines of the first right sample and those that do not belong, shuffled by the exercise's id."""
    lines = _lines(exercise, model(exercise))
    others = [text for one in exercise.distractors for text in _lines(exercise, one) or [one.strip()]]
    marked = [
        (sha256(f"{exercise.id}/{number}/{text}".encode()).digest(), text)
        for number, text in enumerate([*lines, *others])
    ]
    mixed = [text for _, text in sorted(marked)]
    return tuple(mixed if mixed[: len(lines)] != lines else [*mixed[1:], mixed[0]])


def _lines(exercise: Exercise, text: str) -> list[str]:
    return [line.text for line in read(text, exercise.dialect).lines]


def _foreign(exercise: Exercise, program: Program) -> tuple[Diagnostic, ...]:
    """Find the lines that were not offered, or not so often."""
    left = Counter(offered(exercise))
    often = Counter(left)
    found = []
    for line in program.lines:
        if left[line.text] > 0:
            left[line.text] -= 1
            continue
        times = often[line.text]
        row = rule("KND003" if times else "KND002")
        found.append(row.at(line.span, line=line.text, times=counted(times, "次", "times" if times > 1 else "time")))
    return tuple(found[:_MOST])


_MOST = 20
