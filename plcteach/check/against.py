"""One program held against another: the reference as it is read, and the verdict on a learner's program."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

from plcteach.check.lint import lint
from plcteach.check.same import compare, outputs_of
from plcteach.check.tried import runaway
from plcteach.core.diagnostic import errors
from plcteach.core.errors import PlcTeachError
from plcteach.core.exercise import Terms
from plcteach.core.text import language
from plcteach.core.verdict import Verdict
from plcteach.ladder.either import read_either
from plcteach.ladder.telling import is_drawing

if TYPE_CHECKING:
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect

_USUAL = Terms()


def verdict_on(wanted: Program, program: Program, terms: Terms = _USUAL) -> Verdict:
    """Compare a submission with the reference; with an error in its text or its stack there is nothing to compare.

    Nor is there where a scan never ends.
    """
    found = tuple(lint(program))
    if not errors(found):
        found += runaway(program)
    if errors(found) or not program.lines:
        return Verdict("error", diagnostics=found)
    verdict = compare(wanted, program, terms=terms)
    return replace(verdict, diagnostics=found + verdict.diagnostics)


@lru_cache(maxsize=256)
def reference(text: str, dialect: str | Dialect) -> Program:
    """Read a reference, a ladder drawing or a program; PlcTeachError if it has an error itself."""
    program = read_either(text, dialect)
    if is_drawing(text) and errors(program.diagnostics):
        one = errors(program.diagnostics)[0]
        msg = f"reference, row {one.span.row}, column {one.span.start + 1}: {one.text.in_(language())}"
        raise PlcTeachError(msg)
    wrong = errors(lint(program)) or errors(runaway(program))
    if wrong:
        msg = f"the reference has an error itself: {wrong[0]}"
        raise PlcTeachError(msg)
    if not outputs_of(program):
        msg = "the reference writes no output, so there is nothing to compare"
        raise PlcTeachError(msg)
    return program
