"""The lists that prove a random task: right ones, lowered in several ways, and wrong ones with what is found in them."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice
from typing import TYPE_CHECKING

from plcteach.check.drilling.slips import slips
from plcteach.check.lint import lint
from plcteach.core.diagnostic import errors
from plcteach.core.errors import NotRepresentableError
from plcteach.core.exercise import WrongSample
from plcteach.core.ladder import Branch, Edge, Invert, Ladder, Parallel, Rung, Series, parallel, series, symbols_of
from plcteach.ladder.lower import lower
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.ladder import Node, Out
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect

ENOUGH = 4


def right_lists(ladder: Ladder, dialect: Dialect, most: int = 2) -> tuple[str, ...]:
    """Give at least two lists of a ladder: as it stands, its joins grouped, its parts turned round, or each contact a block."""
    found: list[str] = []
    for text in _lists(ladder, dialect):
        if text not in found and not errors(lint(read(text, dialect))):
            found.append(text)
        if len(found) == most:
            break
    return tuple(found)


def _lists(ladder: Ladder, dialect: Dialect) -> Iterator[str]:
    yield lower(ladder, dialect)
    for one, ways in (
        (ladder, {"grouped": True}),
        (turned(ladder), {}),
        (ladder, {"fused": False}),
    ):
        try:
            yield lower(one, dialect, **ways)
        except NotRepresentableError:
            continue
    yield from islice(inverted_twice(read(lower(ladder, dialect), dialect)), 1)


def inverted_twice(program: Program) -> Iterator[str]:
    """Give the list again with an inversion and its undoing in it, which change nothing, behind each line that reads a value."""
    invert = program.dialect.roles.get("invert", "")
    rows = program.source.split("\n")
    for line in program.lines if invert else ():
        if line.places and not line.insn.then and not line.insn.close:
            yield "\n".join([*rows[: line.span.row], invert, invert, *rows[line.span.row :]])


def turned(ladder: Ladder) -> Ladder:
    """Give the same ladder with the parts of each series and each parallel in the other order, where that is the same."""
    return replace(ladder, rungs=tuple(_turned_rung(one) for one in ladder.rungs))


def _turned_rung(one: Rung) -> Rung:
    stem = _turned(one.stem) if one.stem else None
    return replace(one, stem=stem, outs=tuple(map(_turned_out, one.outs)))


def _turned_out(out: Out) -> Out:
    if isinstance(out, Branch):
        return Branch(_turned(out.stem), tuple(map(_turned_out, out.outs)))
    return out


def _turned(node: Node) -> Node:
    match node:
        case Series(parts) if not any(isinstance(one, Edge | Invert) for one in symbols_of(node)):
            return series(*(_turned(one) for one in reversed(parts)))
        case Parallel(parts):
            return parallel(*(_turned(one) for one in reversed(parts)))
    return node


def wrong_lists(program: Program, most: int = ENOUGH) -> tuple[WrongSample, ...]:
    """Give lists that somebody might write, each for another reason as far as there are so many."""
    some = slips(program)
    first = {one.because: one for one in reversed(some)}
    telling = [one for one in some if first[one.because] is one]
    made: list[WrongSample] = []
    for one in [*telling, *(one for one in some if one not in telling)]:
        if len(made) == most:
            break
        found = lint(read(one.text, program.dialect))
        if one.sure or errors(found):
            made.append(WrongSample(one.text, _expected(found), one.because, one.misconception))
    return tuple(made)


def _expected(found: tuple[Diagnostic, ...]) -> str:
    """Give the code of the first error, or of what is left on the stack; a list without either is just different."""
    wrong = errors(found) or [one for one in found if one.severity == "warning" and one.code.startswith("STK")]
    return wrong[0].code if wrong else "different"
