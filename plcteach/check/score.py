"""Marks as a grader's autograder wants them: a plain, clamped, finite float that also carries the report a learner reads."""

from __future__ import annotations

import math
from html import escape
from typing import TYPE_CHECKING, Self

from plcteach.check.judge import Judgement, judge
from plcteach.check.report import headline, table
from plcteach.core.text import language

if TYPE_CHECKING:
    from plcteach.core.exercise import Exercise


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

    def _repr_html_(self) -> str:
        if self.judgement is None:
            return escape(repr(self))
        return report_html(self.judgement, language())

    def assert_correct(self) -> None:
        """Raise AssertionError, its first line the counterexample, unless the program was proved equal."""
        if self.judgement is not None and self.judgement.verdict.status != "equal":
            raise AssertionError(headline(self.judgement).in_(language()))


def grade(exercise: Exercise | str, text: str | bytes) -> Score:
    """Grade a submission: `plcteach.grade("s7-two-blocks", my_program)` as the last line of a graded cell."""
    judgement = judge(exercise, text)
    return Score(judgement.marks, judgement.exercise.points, judgement)


def report_html(judgement: Judgement, lang: str) -> str:
    """Give the report as HTML: the headline, the findings with their rows, and the row of inputs that tells them apart."""
    parts = [f"<p><strong>{escape(headline(judgement).in_(lang))}</strong></p>"]
    found = judgement.verdict.diagnostics
    if found:
        items = "".join(
            f"<li><code>{one.code}</code> {_row(one.span.row, lang)}{escape(one.text.in_(lang))}</li>"
            for one in found[:20]
        )
        parts.append(f"<ul>{items}</ul>")
    rows = table(judgement.verdict)
    if rows:
        body = "".join(
            f"<tr><td><code>{escape(row.address)}</code> {escape(row.label.in_(lang))}</td><td>{row.value}</td>"
            f"<td>{'≠' if row.differs else ''}</td></tr>"
            for row in rows
        )
        parts.append(f"<table>{body}</table>")
    return "".join(parts)


def _row(row: int, lang: str) -> str:
    if not row:
        return ""
    return f"第{row}行：" if lang == "zh" else f"row {row}: "
