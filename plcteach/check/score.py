"""Marks as a grader's autograder wants them: a plain, clamped, finite float that also carries the report a learner reads."""

from __future__ import annotations

import math
from html import escape
from typing import TYPE_CHECKING, Self

from plcteach.check.cases import cases_of
from plcteach.check.judge import judge
from plcteach.check.report import headline, report_html
from plcteach.core.text import language

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from plcteach.check.judgement import Judgement
    from plcteach.core.exercise import Exercise

__all__ = ["Score", "grade", "report_html"]


class Score(float):
    """Marks between 0 and the maximum. As the last expression of a graded cell it *is* the score; its HTML is the report."""

    judgement: Judgement | None

    def __new__(cls, marks: float, maximum: float, judgement: Judgement | None = None) -> Self:
        """Clamp the marks to 0 … maximum; what is not finite becomes 0."""
        safe = marks if math.isfinite(marks) else 0.0
        score = super().__new__(cls, min(max(safe, 0.0), maximum))
        score.judgement = judgement
        return score

    def __repr__(self) -> str:
        return float.__repr__(self)

    def __reduce__(self) -> tuple[type[Score], tuple[float, float, Judgement | None]]:
        """Let a copy, and a score that comes back from another process, keep its judgement."""
        return Score, (float(self), float(self), self.judgement)

    def _repr_html_(self) -> str:
        if self.judgement is None:
            return escape(repr(self))
        return report_html(self.judgement, language())

    def assert_correct(self) -> None:
        """Raise AssertionError, its first line the counterexample, unless the answer was proved right in all that is asked."""
        judgement = self.judgement
        if judgement is not None and (judgement.verdict.status != "equal" or judgement.says):
            raise AssertionError(headline(judgement).in_(language()))

    def cases(self) -> Iterator[tuple[str, float, Callable[[], None]]]:
        """Give (name, points, check) for a grader that counts cases: a check raises AssertionError where it is not passed.

        Names and points depend on the exercise alone, so that they can be written down before anyone has answered.
        """
        if self.judgement is None:
            return
        said = headline(self.judgement)
        for case in cases_of(self.judgement):
            yield case.name.in_(language()), case.points, _check(f"{said.in_(language())}", passed=case.passed)


def _check(said: str, *, passed: bool) -> Callable[[], None]:
    def check() -> None:
        if not passed:
            raise AssertionError(said)

    return check


def grade(exercise: Exercise | str | Path, text: str | bytes) -> Score:
    """Grade a submission: `plcteach.grade("s7-two-blocks", my_program)` as the last line of a graded cell; a path is a teacher's own file."""
    judgement = judge(exercise, text)
    return Score(judgement.marks, judgement.exercise.points, judgement)
