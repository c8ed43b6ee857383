"""Program and exercise to verdict: what is wrong with a list by itself, and whether it does what another one does."""

from plcteach.check.judge import Judgement, judge, reference, verdict_on
from plcteach.check.lint import lint
from plcteach.check.same import compare
from plcteach.check.score import Score, grade

__all__ = ["Judgement", "Score", "compare", "grade", "judge", "lint", "reference", "verdict_on"]
