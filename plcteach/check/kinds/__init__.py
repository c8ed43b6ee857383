"""The kinds of exercises: what each shows before the answer, how it judges one, and an answer that gets full marks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from plcteach.check.judgement import Judgement, Part, Sheet
from plcteach.check.kinds import bug, chart, complete, join, match, order, predict, translate, write

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.exercise import Exercise, Kind

__all__ = ["KINDS", "Judgement", "Part", "Sheet", "Way"]


class Way(Protocol):
    """What a kind's module offers."""

    def shown(self, exercise: Exercise) -> Sheet:
        """Give what is seen before the answer, and never the answer."""

    def judged(self, exercise: Exercise, answer: str | bytes) -> Judgement:
        """Judge an answer, whatever stands in it."""

    def model(self, exercise: Exercise) -> str:
        """Give an answer that gets full marks."""


KINDS: Mapping[Kind, Way] = {
    "write": write,
    "complete": complete,
    "bug": bug,
    "translate": translate,
    "order": order,
    "predict": predict,
    "join": join,
    "match": match,
    "chart": chart,
}
