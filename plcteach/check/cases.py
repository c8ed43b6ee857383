"""A judgement as cases that are passed or not, for graders that count such; which cases there are the exercise decides alone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.check.judge import model
from plcteach.check.kinds import KINDS
from plcteach.check.marks import CAPPED, HALF, NAMES, weights_of
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.check.judgement import Judgement
    from plcteach.core.exercise import Exercise

_QUARTERS = (1, 2, 3, 4)
_OUTPUT = Text("输出{address}", "output {address}")
_WHOLE = Text("所有输出", "all outputs")
_QUARTER = Text("{name}，达到{share}%", "{name}, {share} % of it")


@dataclass(frozen=True, slots=True)
class Case:
    """One thing that is tested: its name, its points, and whether the answer passes it."""

    name: Text
    points: float
    passed: bool

    def __repr__(self) -> str:
        return f"Case({self.name.en}, {self.points:g}, {'passed' if self.passed else 'not passed'})"


def cases_of(judgement: Judgement) -> Iterator[Case]:
    """Give the cases of a judgement; their points add up to the exercise's.

    Outputs are a case each, and all of them together another; every other part is told in quarters.
    """
    exercise = judgement.exercise
    whole = exercise.points
    equal = judgement.verdict.status == "equal"
    weights = weights_of(exercise)
    if exercise.needs and "needs" not in weights:
        yield Case(NAMES["needs"], round(whole * (1 - CAPPED), 4), equal and not judgement.says)
        whole *= CAPPED
    for (name, weight), part in zip(weights.items(), judgement.parts, strict=True):
        points = whole * weight
        outputs = _outputs(exercise) if name == "outputs" else ()
        if outputs:
            yield from _by_output(judgement, outputs, points)
        else:
            reached = part.got / part.of if part.of else 0.0
            yield from (
                Case(_QUARTER.format(name=part.name, share=25 * one), round(points / 4, 4), reached >= one / 4 - 1e-6)
                for one in _QUARTERS
            )


def _by_output(judgement: Judgement, outputs: tuple[str, ...], points: float) -> Iterator[Case]:
    verdict = judgement.verdict
    equal = verdict.status == "equal"
    for address in outputs:
        right = equal or (verdict.status != "error" and verdict.outputs.get(address) == "equal")
        yield Case(_OUTPUT.format(address=address), round(points * HALF / len(outputs), 4), right)
    yield Case(_WHOLE, round(points * HALF, 4), equal)


def _outputs(exercise: Exercise) -> tuple[str, ...]:
    """Give the outputs that an exercise compares; none where its answer is no program."""
    judgement = KINDS[exercise.kind].judged(exercise, model(exercise))
    return tuple(judgement.verdict.outputs) if judgement.program is not None else ()
