"""A task for a learner: what to write, the ladder it is checked against, hints, and programs that prove the task itself."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plcteach.core.text import Text


@dataclass(frozen=True, slots=True)
class WrongSample:
    """A program that must be refused: with this diagnostic's code, or as "different"; and what its writer believed."""

    program: str
    expect: str
    because: Text


@dataclass(frozen=True, slots=True)
class Exercise:
    """One task. `reference` is a ladder drawing; `points` are the full marks; right and wrong samples test the task.

    level: what equal means, "exact", "settled" or "either"; an exercise about pulses, which are gone at rest, asks for "exact".
    """

    id: str
    dialect: str
    title: Text
    task: Text
    reference: str
    start: str = ""
    hints: tuple[Text, ...] = ()
    right: tuple[str, ...] = ()
    wrong: tuple[WrongSample, ...] = ()
    points: float = 4.0
    order: int = 0
    level: str = "either"

    def __repr__(self) -> str:
        return f"Exercise({self.id!r}, {self.title.en!r})"
