"""Whether two programs are the same machine, seen from their inputs and outputs: proved, refuted, or honestly not known.

The machine that is animated is the one that grades: both programs are run over gates (check.proof), and what is left is one
question, whether an output can ever differ. `exact` asks it at the end of every scan, from power-on, for every sequence of inputs
and every timing. `settled` asks it when both programs have come to rest with the inputs held, and a tick of time never meets a
change of the inputs: so rungs in another order are the same, and 49 for 50 is not. By default either will do.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from plcteach.check.proof.product import product
from plcteach.check.proof.trial import LASTING, Trial
from plcteach.check.tried import tried
from plcteach.core.diagnostic import Diagnostic, refuse, rule
from plcteach.core.exercise import Terms
from plcteach.core.source import Span
from plcteach.core.verdict import Verdict
from plcteach.dialects import names
from plcteach.ladder.either import read_either
from plcteach.machine.gates import Unprovable
from plcteach.machine.scan import sweep
from plcteach.machine.store import Memory
from plcteach.machine.words import BITS

if TYPE_CHECKING:
    from collections.abc import Hashable

    from plcteach.core.area import Address
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.machine.signals import Column
    from plcteach.machine.step import Step

MOST_INSTRUCTIONS = 2_000
MOST_REMEMBERED = 512
_USUAL = Terms()


def compare(
    reference: Program | str,
    student: Program | str,
    dialect: str | Dialect | None = None,
    terms: Terms = _USUAL,
) -> Verdict:
    """Judge whether the student's program does what the reference does; neither may have an error.

    Each may be a program, or the text of a list or a drawing in the family `dialect`, and then PlcTeachError says what is wrong
    with it. DeclarationError or UnknownNameError where the terms do not read.
    """
    reference, student = _sound(reference, dialect), _sound(student, dialect)
    key = (_kernel(reference), _kernel(student), _spelled(terms))
    verdict = _known.get(key)
    if verdict is None:
        verdict = _judged(reference, student, terms)
        if len(_known) >= MOST_REMEMBERED:
            del _known[next(iter(_known))]
        _known[key] = verdict
    return replace(verdict, diagnostics=(*_beside(reference, student, verdict), *verdict.diagnostics))


_known: dict[Hashable, Verdict] = {}


def forget() -> None:
    """Forget the verdicts given so far, which are otherwise remembered by what the programs do."""
    _known.clear()


def _sound(text: Program | str, dialect: str | Dialect | None) -> Program:
    if not isinstance(text, str):
        return text
    program = read_either(text, dialect or names()[0])
    refuse(program.diagnostics)
    return program


def _kernel(program: Program) -> Hashable:
    """Give what a program does, without comments, titles and layout."""
    lines = tuple(tuple((line.text, line.effect.text) for line in one.lines) for one in program.networks if one.lines)
    return (
        program.dialect.name,
        lines,
        repr(sorted((key, sorted(said.items())) for key, said in program.settings.items())),
    )


def _spelled(terms: Terms) -> Hashable:
    return repr(
        (terms.level, terms.outputs, terms.assume, terms.single_change, sorted(terms.dont_care.items()), terms.never)
    )


def _judged(reference: Program, student: Program, terms: Terms) -> Verdict:
    """Give the verdict without what there is to say beside it."""
    if _kernel(reference) == _kernel(student) and not terms.never:
        return Verdict("equal", "structural", None, dict.fromkeys(_outputs(reference, terms), "equal"))
    if max(len(reference.lines), len(student.lines)) > MOST_INSTRUCTIONS:
        return Verdict("unknown", outputs=dict.fromkeys(_outputs(reference, terms), "unknown"))
    try:
        asked = product(reference, student, terms)
    except Unprovable:
        return _tried(reference, student, terms)
    trial = Trial((reference, student), terms, asked)
    if not asked.state:
        return trial.decided(settled=False)
    return _in_time(trial, terms)


def _in_time(trial: Trial, terms: Terms) -> Verdict:
    """Judge two programs with a memory at the level asked for."""
    if terms.level == "exact":
        return trial.decided(settled=False)
    exact = trial.decided(settled=False, alone=True) if terms.level == "either" else trial.unknown()
    if exact.status == "equal":
        return exact
    settled = replace(trial.decided(settled=True), level="settled")
    if settled.status == "equal" and terms.level == "either":
        return replace(settled, diagnostics=(rule("CHK003").at(Span(0)),))
    if settled.status == "unsettled" and exact.status == "different":
        shown = trial.decided(settled=False)
        return shown if trial.restless == 0 else replace(shown, diagnostics=(rule("CHK004").at(Span(0)),))
    return settled


def _tried(reference: Program, student: Program, terms: Terms) -> Verdict:
    """Try two programs over many timelines on the plain machine; exactly, or so that only a difference that lasts counts."""
    lasting = 1 if terms.level == "exact" else LASTING
    verdict = tried((reference, student), _outputs(reference, terms), terms, lasting=lasting)
    return replace(verdict, level="settled") if terms.level == "settled" else verdict


def _outputs(program: Program, terms: Terms) -> tuple[str, ...]:
    """Give the outputs compared: those asked for, or those that the reference writes."""
    return (*(terms.outputs or outputs_of(program)), *terms.never)


def outputs_of(program: Program) -> tuple[str, ...]:
    """Give the outputs that a program writes, in order; where it writes none, all bits that it writes."""
    places = sorted(_written(program), key=lambda place: (place.area, place.index, place.text))
    outputs = tuple(one.text for one in places if program.dialect.area(one).role == "output")
    return outputs or tuple(one.text for one in places if one.size == 1)


def _written(program: Program) -> dict[Address, Span]:
    """Run one scan to see what a program writes, and where."""
    found: dict[Address, Span] = {}

    def watch(one: Step[Column]) -> None:
        for place, _ in one.written:
            for bit in program.dialect.bits_of(place) or (place,):
                found.setdefault(bit, one.line.span)

    sweep(program, Memory(), {}, BITS, watch)
    return found


def _beside(reference: Program, student: Program, verdict: Verdict) -> tuple[Diagnostic, ...]:
    """Say which outputs the student writes beyond the reference, and which never."""
    if verdict.proof == "structural":
        return ()
    mine = {place.text for place in _written(reference)}
    theirs = {
        place.text: span for place, span in _written(student).items() if student.dialect.area(place).role == "output"
    }
    extra = [rule("CHK001").at(theirs[text], address=text) for text in sorted(theirs) if text not in mine]
    missing = [
        rule("CHK002").at(Span(0), address=text) for text in verdict.outputs if text in mine and text not in theirs
    ]
    return tuple(extra + missing)
