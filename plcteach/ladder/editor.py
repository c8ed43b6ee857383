"""What a program editor that shows a network as one rung or not at all would not show as a ladder, and why.

Source: the vendor's own help on statement list programs that cannot be displayed as ladder.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from plcteach.core.diagnostic import Diagnostic, Note, rule
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.program import Line, Network
    from plcteach.core.spec import Dialect
    from plcteach.ladder.outputs import Output
    from plcteach.ladder.trie import Group

_BEFORE = Text("上一级到这里为止。", "The rung above ends here.")


def remarks(dialect: Dialect, network: Network, first: int, groups: list[Group]) -> list[Diagnostic]:
    """Give the reasons why a network, whose lines are numbered from `first`, would not be shown as a ladder."""
    lines = [line for line in network.lines if line.insn.then or line.insn.effect.clauses[0].gives]
    if not lines:
        return []
    return [
        *_apart(network, first, groups),
        *_alone(network, first, groups),
        *_after_pop(dialect, network, first, [one for group in groups for one in group.outputs]),
        *_ends(lines),
    ]


def _apart(network: Network, first: int, groups: list[Group]) -> Iterator[Diagnostic]:
    """Find a second rung."""
    rungs = [(group.root.piece.at, group.outputs[-1].at) for group in groups if group.root]
    for (_, last), (begin, _) in pairwise(rungs[:2]):
        note = Note(network.lines[last - first].span, _BEFORE)
        behind = network.lines[last + 1 - first : max(begin, last + 1) + 1 - first]
        yield _at("LAD007", next((line for line in behind if line.places), behind[-1]), note)


def _alone(network: Network, first: int, groups: list[Group]) -> Iterator[Diagnostic]:
    """Find what takes no flow and has company."""
    for group in groups:
        line = network.lines[group.outputs[0].at - first]
        if group.root is None and any(other.insn.then for other in network.lines if other is not line):
            yield _at("LAD009", line)


def _after_pop(dialect: Dialect, network: Network, first: int, outputs: list[Output]) -> Iterator[Diagnostic]:
    """Find contacts that go on behind the output of the last branch."""
    last: Output | None = None
    branches, popped = {"push", "read", "pop"}, False
    at = {output.at: output for output in outputs}
    for number, line in enumerate(network.lines, first):
        role = dialect.parts.get(line.insn.mnemonic)
        if role in branches:
            popped, last = role == "pop", None
        output = at.get(number)
        if output is None or not popped:
            continue
        if last and last.flow and output.flow and _follows(output, last):
            yield _at("LAD008", network.lines[last.at - first + 1], Note(network.lines[last.at - first].span, _BEFORE))
            popped = False
        last = output


def _follows(output: Output, last: Output) -> bool:
    piece = output.flow
    while piece is not None and piece is not last.flow:
        piece = piece.before
    return piece is not None and output.flow is not last.flow


def _ends(lines: list[Line]) -> Iterator[Diagnostic]:
    """Find a network that does not begin with a contact, or does not end with an output."""
    if lines[0].effect.clauses[0].takes:
        yield _at("LAD010", lines[0])
    if not lines[-1].insn.then:
        yield _at("LAD011", lines[-1])


def _at(code: str, line: Line, *notes: Note) -> Diagnostic:
    found = rule(code).at(line.span, word=line.text)
    return Diagnostic(found.code, found.severity, found.span, found.text, notes)
