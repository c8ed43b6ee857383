"""A task for a learner: what to write, the ladder it is checked against, hints, and programs that prove the task itself."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, get_args

from plcteach.core.text import NOTHING, Text

if TYPE_CHECKING:
    from collections.abc import Mapping

Kind = Literal["write", "complete", "bug", "translate", "order", "predict", "join", "match", "chart"]
KINDS: tuple[Kind, ...] = get_args(Kind)
"""What a learner is asked to do.

write: the list for this ladder.  complete: the missing lines of a list.  bug: a list with its fault mended.  translate: the list
in another family.  order: given lines in the right order, some of which do not belong.  predict: the stack after each line.
join: which two blocks a join connects.  match: which of some ladders a list is.  chart: when an output is on.
Every answer is a text, whatever its kind, so that it can stand in a file, in a cell or in a grader's form.
"""


@dataclass(frozen=True, slots=True)
class Terms:
    """What "the same" means for one exercise.

    level: "exact" (at every scan's end), "settled" (held inputs, at rest) or "either".  outputs: those compared; () are all that
    the reference writes.  assume: formulas over inputs that always hold (`!(I0.2 & I0.3)`).  single_change: at most one input
    changes at a time.  dont_care: for an output the formula under which it does not matter.  never: formulas over inputs and
    outputs that the learner's program must never make true, whatever the reference does.
    """

    level: str = "either"
    outputs: tuple[str, ...] = ()
    assume: tuple[str, ...] = ()
    single_change: bool = False
    dont_care: Mapping[str, str] = field(default_factory=dict)
    never: tuple[str, ...] = ()


NeedKind = Literal["most", "uses", "avoids", "contact", "edits"]


@dataclass(frozen=True, slots=True)
class Need:
    """One thing that the answer's text must show beside doing the same, because equivalence cannot see it.

    what: "most" (at most so many instructions), "uses" or "avoids" (an instruction), "contact" (the rung that writes `rung`
    contains this contact; `/Q0.1` is a normally closed one), "edits" (at most so many lines changed).
    """

    what: NeedKind
    value: str
    rung: str = ""
    says: Text = NOTHING


@dataclass(frozen=True, slots=True)
class WrongSample:
    """An answer that must not get full marks: with this diagnostic's code, as "different", or as "equal" where a need is not met.

    because: what its writer believed.  misconception: the number of that belief in the table of usual wrong ideas; 0 is none.
    """

    program: str
    expect: str
    because: Text
    misconception: int = 0


@dataclass(frozen=True, slots=True)
class Exercise:
    """One task. `reference` is a ladder drawing or a list; `points` are the full marks; the samples test the task itself.

    kind: what the learner does (`KINDS`).  given: the program that is looked at, where the answer is not a program, or the one
    to be translated, in the family `source`.  start: what stands in the editor at first; `____` is a line to be filled in.
    after: exercises to be done before.  lesson: the number of the lesson it belongs to.  weights: how the marks are shared
    among "outputs", "steps", "style" and "needs".  scans: the inputs of a prediction or a chart, one mapping a scan.
    levels: how many levels of the stack are asked for.  row: the join that is asked about, counted among the instructions from 1.
    choices: ladders to choose from.  distractors: lines that do not belong.  hidden: the reference is shown nowhere.
    """

    id: str
    dialect: str
    title: Text
    task: Text
    reference: str
    kind: Kind = "write"
    start: str = ""
    given: str = ""
    source: str = ""
    hints: tuple[Text, ...] = ()
    right: tuple[str, ...] = ()
    wrong: tuple[WrongSample, ...] = ()
    needs: tuple[Need, ...] = ()
    weights: Mapping[str, float] = field(default_factory=dict)
    points: float = 4.0
    order: int = 0
    lesson: int = -1
    after: tuple[str, ...] = ()
    misconceptions: tuple[int, ...] = ()
    terms: Terms = field(default_factory=Terms)
    scans: tuple[Mapping[str, Any], ...] = ()
    levels: int = 0
    row: int = 0
    choices: tuple[str, ...] = ()
    distractors: tuple[str, ...] = ()
    hidden: bool = False

    def __repr__(self) -> str:
        return f"Exercise({self.id!r}, {self.title.en!r})"

    @property
    def level(self) -> str:
        """What equal means here: "exact", "settled" or "either"."""
        return self.terms.level
