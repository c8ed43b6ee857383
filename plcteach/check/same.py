"""Whether two programs are the same machine, seen from their inputs and outputs: proved, refuted, or honestly not known.

The machine that is animated is the one that grades: both programs are run over gates (check.proof), and what is left is one
question, whether an output can ever differ. `exact` asks it at the end of every scan, from power-on, for every sequence of inputs
and every timing. `settled` asks it when both programs have come to rest with the inputs held, and a tick of time never meets a
change of the inputs: so rungs in another order are the same, and 49 for 50 is not. By default either will do.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

from plcteach.check.proof.product import driven, ordered, product
from plcteach.check.proof.terms import spelled_out
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
from plcteach.machine.signals import X
from plcteach.machine.store import Memory
from plcteach.machine.words import BITS

if TYPE_CHECKING:
    from collections.abc import Hashable

    from plcteach.core.area import Address
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.machine.signals import Column
    from plcteach.machine.step import Step

Places = dict["Address", Span]
"""What a program writes, each with the line that does so first."""

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
    wanted = _sound(reference, dialect)
    terms = spelled_out(terms, wanted.dialect)
    pair = _Pair(wanted, _sound(student, dialect), terms)
    mine, theirs = _kernel(pair.reference), _kernel(pair.student)
    key = (mine, theirs, _spelled(terms))
    verdict = _known.get(key)
    if verdict is None:
        verdict = pair.alike() if mine == theirs and not terms.never else pair.judged()
        if len(_known) >= MOST_REMEMBERED:
            del _known[next(iter(_known))]
        _known[key] = verdict
    return replace(verdict, diagnostics=(*pair.beside(verdict), *verdict.diagnostics))


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
    lines = tuple(
        (one.block, tuple((line.text, line.effect.text) for line in one.lines)) for one in program.networks if one.lines
    )
    return (
        program.dialect.name,
        lines,
        repr(sorted((key, sorted(said.items())) for key, said in program.settings.items())),
    )


def _spelled(terms: Terms) -> Hashable:
    return repr(
        (terms.level, terms.outputs, terms.assume, terms.single_change, sorted(terms.dont_care.items()), terms.never)
    )


@dataclass(frozen=True)
class _Pair:
    """Two programs to be compared, and what each of them writes."""

    reference: Program
    student: Program
    terms: Terms

    @cached_property
    def mine(self) -> Places:
        """What the reference writes."""
        return _written(self.reference)

    @cached_property
    def outputs(self) -> tuple[str, ...]:
        """The outputs compared: those asked for, or those that the reference writes."""
        return (*(self.driven or _outputs(self.reference, self.mine)), *self.terms.never)

    @cached_property
    def driven(self) -> tuple[str, ...]:
        """The outputs asked for, or those of the machine that the reference drives; none where it drives none of them."""
        return self.terms.outputs or driven(self.reference.dialect, self.mine)

    def alike(self) -> Verdict:
        """Give the verdict where the student's program is the reference, line by line."""
        return Verdict("equal", "structural", None, dict.fromkeys(self.outputs, "equal"))

    def judged(self) -> Verdict:
        """Give the verdict without what there is to say beside it."""
        if max(len(self.reference.lines), len(self.student.lines)) > MOST_INSTRUCTIONS:
            return Verdict("unknown", outputs=dict.fromkeys(self.outputs, "unknown"))
        try:
            asked = product(self.reference, self.student, replace(self.terms, outputs=self.driven))
        except Unprovable:
            return self.tried()
        trial = Trial((self.reference, self.student), self.terms, asked)
        if not asked.state:
            verdict = trial.decided(settled=False)
            if verdict.status != "different" or self.terms.level == "exact" or not trial.fleeting():
                return verdict
        return _in_time(trial, self.terms)

    def tried(self) -> Verdict:
        """Try both over many timelines on the plain machine; exactly, or so that only a difference that lasts counts."""
        lasting = 1 if self.terms.level == "exact" else LASTING
        verdict = tried((self.reference, self.student), self.outputs, self.terms, lasting=lasting)
        return replace(verdict, level="settled") if self.terms.level == "settled" else verdict

    def beside(self, verdict: Verdict) -> tuple[Diagnostic, ...]:
        """Say which outputs the student writes beyond the reference, and which never."""
        if verdict.proof == "structural":
            return ()
        mine = {place.text for place in self.mine}
        dialect = self.student.dialect
        theirs = {
            place.text: span for place, span in _written(self.student).items() if dialect.area(place).role == "output"
        }
        extra = [rule("CHK001").at(theirs[text], address=text) for text in sorted(theirs) if text not in mine]
        missing = [
            rule("CHK002").at(Span(0), address=text) for text in verdict.outputs if text in mine and text not in theirs
        ]
        return tuple(extra + missing)


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


def outputs_of(program: Program) -> tuple[str, ...]:
    """Give the outputs that a program writes, in order; where it writes none, all bits that it writes."""
    return _outputs(program, _written(program))


def _outputs(program: Program, written: Places) -> tuple[str, ...]:
    return driven(program.dialect, written) or tuple(one.text for one in ordered(written) if one.size == 1)


def _written(program: Program) -> Places:
    """Run one scan, with nothing known of the inputs, to see what a program writes, and where; and look where it did not come."""
    found: Places = {}
    dialect = program.dialect

    def note(place: Address, span: Span) -> None:
        for bit in dialect.bits_of(place) or (place,):
            found.setdefault(bit, span)

    def watch(one: Step[Column]) -> None:
        for place, _ in one.written:
            note(place, one.line.span)

    inputs = {bit.text: X for place in program.addresses("input") for bit in dialect.bits_of(place)}
    sweep(program, Memory(), inputs, BITS, watch)
    for line in program.lines:
        for _, place in line.targets:
            if dialect.area(place).role == "output":
                note(place, line.span)
    return found
