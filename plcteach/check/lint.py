"""Everything that can be said of a program without running it: what the reader found, and what the stack tells."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from plcteach.check.rules import PROGRAM_RULES, STACK_RULES
from plcteach.core.diagnostic import Diagnostic, errors, few, rule
from plcteach.core.text import Text, language
from plcteach.dialects import families, names
from plcteach.ladder.either import read_either
from plcteach.machine.walk import Walk, walk
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect

_BELOW_ALL = 10**9
_PUZZLING = 3
_TOO_LONG = {"RDR013"}
_ENOUGH_ROWS = 60


class Findings(tuple[Diagnostic, ...]):
    """All that was found, in order of place; in a notebook a table in the language in force."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "\n".join(map(repr, self)) or NOTHING_FOUND.in_(language())

    def _repr_html_(self) -> str:
        if not self:
            return f"<p>{NOTHING_FOUND.in_(language())}</p>"
        rows = "".join(
            f"<tr><td>{one.span.row}</td><td><code>{one.code}</code></td>"
            f'<td style="text-align: left">{escape(one.text.in_(language()))}</td></tr>'
            for one in self
        )
        return f"<table>{rows}</table>"


NOTHING_FOUND = Text("没有发现问题。", "Nothing to remark.")


def lint(program: Program | str, dialect: str | Dialect | None = None) -> Findings:
    """Give all findings in order of place; a network with an unreadable line is not judged by its stack.

    Of a ladder drawing: what keeps it from being read, else what there is to say of the list that it becomes.
    """
    if isinstance(program, str):
        program = read_either(program, dialect or names()[0])
    found = list(program.diagnostics)
    found += [one for row, finder in PROGRAM_RULES.values() for one in finder(program, row)]
    found += _other_family(program)
    unread = {one.span.row for one in errors(program.diagnostics)}
    judged = [] if _TOO_LONG & {one.code for one in found} else [one for one in program.networks if one.lines]
    starts = [0, *(network.lines[-1].span.row + 1 for network in judged[:-1])]
    ends = [*(network.lines[0].span.row for network in judged[1:]), _BELOW_ALL]
    for network, start, end in zip(judged, starts, ends, strict=False):
        if not any(start <= row < max(end, start + 1) for row in unread):
            found += _of_network(walk(program.dialect, network))
    return Findings(few(sorted(found, key=lambda one: (one.span.row, one.span.start, one.code))))


def _other_family(program: Program) -> list[Diagnostic]:
    """Say so where nearly nothing reads in the family chosen, and nearly everything in another."""
    if len(errors(program.diagnostics)) < max(_PUZZLING, len(program.lines)):
        return []
    beginning = "\n".join(program.source.split("\n", _ENOUGH_ROWS)[:_ENOUGH_ROWS])
    unread = _unread(beginning, program.dialect)
    for other in families():
        if unread >= _PUZZLING and other != program.dialect and _unread(beginning, other) <= unread // _PUZZLING:
            names = {"other": other.title, "family": program.dialect.title, "list": other.list}
            return [rule("RDR017").at(program.diagnostics[0].span, **names)]
    return []


def _unread(text: str, family: Dialect) -> int:
    return len(errors(read(text, family).diagnostics))


def _of_network(walked: Walk) -> list[Diagnostic]:
    """Find what every rule finds; after the first error the rest of the network's stack is guesswork and not reported."""
    found = [one for row, finder in STACK_RULES.values() for one in finder(walked, row)]
    broken = [one.span for one in errors(found)]
    if not broken:
        return found
    first = min(broken)
    at_first = [one for one in found if one.span == first and one.severity == "error"][:1]
    return at_first + [one for one in found if one.span < first or one.severity == "info"]
