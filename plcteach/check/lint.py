"""Everything that can be said of a program without running it: what the reader found, and what the stack tells."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.rules import PROGRAM_RULES, STACK_RULES
from plcteach.core.diagnostic import Diagnostic, errors
from plcteach.machine.walk import Walk, walks

if TYPE_CHECKING:
    from plcteach.core.program import Program

_BELOW_ALL = 10**9


def lint(program: Program) -> tuple[Diagnostic, ...]:
    """Give all findings in order of place; a network with an unreadable line is not judged by its stack."""
    found = list(program.diagnostics)
    found += [one for row, finder in PROGRAM_RULES.values() for one in finder(program, row)]
    unread = {one.span.row for one in errors(program.diagnostics)}
    judged = list(walks(program))
    starts = [0, *(walk.network.lines[0].span.row for walk in judged[1:]), _BELOW_ALL]
    for walk, start, end in zip(judged, starts, starts[1:], strict=False):
        if not any(start <= row < end for row in unread):
            found += _of_network(walk)
    return tuple(sorted(found, key=lambda one: (one.span.row, one.span.start, one.code)))


def _of_network(walk: Walk) -> list[Diagnostic]:
    """Find what every rule finds; after the first error the rest of the network's stack is guesswork and not reported."""
    found = [one for row, finder in STACK_RULES.values() for one in finder(walk, row)]
    broken = [one.span for one in errors(found)]
    if not broken:
        return found
    first = min(broken)
    at_first = [one for one in found if one.span == first and one.severity == "error"][:1]
    return at_first + [one for one in found if one.span < first or one.severity == "info"]
