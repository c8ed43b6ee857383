"""What a judged answer is, and what a learner sees before answering: values, which know nothing of how they came about."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from plcteach.core.text import NOTHING, Text

if TYPE_CHECKING:
    from plcteach.core.exercise import Exercise
    from plcteach.core.ladder import Ladder
    from plcteach.core.program import Program
    from plcteach.core.verdict import Verdict

UNMET = "CHK006"
"""The code of what a task asks for and an answer lacks; its words stand among the remarks already."""

Form = Literal["list", "rows", "grid", "blocks", "choice"]
"""How an answer is given: a list that is written, rows to be ordered, a grid to be filled in, two blocks, one of several."""


@dataclass(frozen=True, slots=True)
class Part:
    """One part of the marks: its name, what was reached, and out of how much."""

    name: Text
    got: float
    of: float

    def __repr__(self) -> str:
        return f"Part({self.name.en}: {self.got:g}/{self.of:g})"


@dataclass(frozen=True, slots=True)
class Judgement:
    """One answer, judged: the program as it was read, the verdict, and the marks out of the exercise's points.

    program: None where the answer is no program.  parts: what the marks are made of; they add up to them.  says: further
    remarks in the order in which they matter.  grid: the cells of a grid as they were read.  wrong: those that are not right,
    (row, column) from 0.
    """

    exercise: Exercise
    answer: str
    program: Program | None
    verdict: Verdict
    marks: float
    parts: tuple[Part, ...] = ()
    says: tuple[Text, ...] = ()
    wrong: tuple[tuple[int, int], ...] = ()
    grid: tuple[tuple[str, ...], ...] = ()

    def __repr__(self) -> str:
        return f"Judgement({self.exercise.id}: {self.verdict.status}, {self.marks:g}/{self.exercise.points:g})"


@dataclass(frozen=True, slots=True)
class Sheet:
    """What a page or a printed notebook shows before an answer is given: the material, and never the answer.

    text: what is to be known beside the task, lines parted by a line end.  program: the list that is looked at.  ladders: those
    to be written, or to choose from.  rows: the lines to be ordered, the rows of the grid, the letters of the choices.
    columns: the headings of the grid, short enough for a narrow column; heads: the same in words, where there are any.
    start: what stands in the answer at first.
    """

    form: Form
    text: Text = NOTHING
    program: Program | None = None
    ladders: tuple[Ladder, ...] = ()
    rows: tuple[str, ...] = ()
    columns: tuple[str, ...] = ()
    start: str = ""
    heads: tuple[Text, ...] = ()
