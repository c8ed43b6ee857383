"""What to say to a learner who is stuck, from vague to plain, and which wrong idea an answer shows.

Nothing here guesses aloud: a repair has been proved, and the rest the exercise's author wrote.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.against import reference, verdict_on
from plcteach.check.kinds import KINDS
from plcteach.check.repair import repair
from plcteach.core.diagnostic import rule
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from plcteach.check.judgement import Judgement
    from plcteach.check.repaired import Repair
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.exercise import Exercise, WrongSample
    from plcteach.core.program import Program
    from plcteach.core.text import Text

__all__ = ["believed", "hints", "mended"]

_WRONG = {"different", "error", "unsettled"}


def hints(judgement: Judgement) -> tuple[Text, ...]:
    """Give hints to be shown one after the other: the repair in stages, then the exercise's own; none of a right answer.

    What was found in the text is no hint: it is said anyway. A hidden reference keeps its last stage, the edit, to itself.
    """
    if judgement.verdict.status == "equal":
        return ()
    return tuple(dict.fromkeys([*_stages(judgement), *judgement.exercise.hints]))


def _stages(judgement: Judgement) -> tuple[Text, ...]:
    found = mended(judgement)
    if found is None:
        return ()
    stages = found.stages()
    return stages[:-1] if judgement.exercise.hidden else stages


def mended(judgement: Judgement) -> Repair | None:
    """Give the proved repair of a wrong program, if one edit is enough, and if the exercise would take the mended list."""
    exercise, program = judgement.exercise, judgement.program
    if program is None or judgement.verdict.status not in _WRONG or exercise.choices:
        return None

    def accepts(text: str) -> bool:
        judged = KINDS[exercise.kind].judged(exercise, text)
        return judged.verdict.status == "equal" and not judged.says

    return repair(_wanted(exercise), program, exercise.terms, verdict=judgement.verdict, accepts=accepts)


def _wanted(exercise: Exercise) -> Program:
    """Give the reference; for a translation without one it is the translated list."""
    if exercise.source:
        return read(KINDS[exercise.kind].model(exercise), exercise.dialect)
    return reference(exercise.reference, exercise.dialect)


def believed(judgement: Judgement) -> tuple[int, ...]:
    """Give the numbers of the misconceptions that an answer shows, the surest first.

    A wrong sample that is the answer, or does exactly what the answer does, tells which; then come the findings' own. Advice on
    style counts where the answer is right.
    """
    right = judgement.verdict.status == "equal"
    found = [one for one in judgement.verdict.diagnostics if rule(one.code).style is right]
    of_findings = _of_findings(judgement.exercise, found)
    if right:
        return tuple(dict.fromkeys(of_findings))
    samples = [one for one in judgement.exercise.wrong if one.misconception]
    same = [one.misconception for one in samples if _words(one.program) == _words(judgement.answer)]
    alike = [] if same else [one.misconception for one in samples if _does_the_same(judgement, one)]
    return tuple(dict.fromkeys([*same, *alike, *of_findings]))


def _of_findings(exercise: Exercise, found: Iterable[Diagnostic]) -> Iterator[int]:
    """Give what findings tell: those of a rule's ideas that the exercise is about, else the most usual one."""
    for one in found:
        numbers = rule(one.code).misconceptions
        about = [number for number in numbers if number in exercise.misconceptions]
        yield from about or numbers[:1]


def _words(text: str) -> list[list[str]]:
    """Give a text as words, row by row, without comments and empty rows."""
    rows = (row.partition("//")[0].upper().replace(",", " ").split() for row in text.splitlines())
    return [row for row in rows if row]


def _does_the_same(judgement: Judgement, sample: WrongSample) -> bool:
    """Say whether a wrong program does exactly what a wrong sample does."""
    program, exercise = judgement.program, judgement.exercise
    if program is None or judgement.verdict.status != "different" or sample.expect != "different" or exercise.choices:
        return False
    wrong = read(sample.program, exercise.dialect)
    return wrong.runs and verdict_on(wrong, program, exercise.terms).status == "equal"
