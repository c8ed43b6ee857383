"""A ladder box that somebody writes into a list (ADD_I IN1, IN2, OUT): read as the two instructions that the editor makes of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.boxes import Box, split
from plcteach.core.program import Line, Value
from plcteach.core.source import Span
from plcteach.core.text import same

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.stl.operands import Operands
    from plcteach.stl.tokens import Statement, Word

_OPERANDS = 3


def expanded(operands: Operands, words: list[Word], statement: Statement) -> Iterator[Line]:
    """Give the lines of one box, faithfully split, and report where they do not give what the box says."""
    dialect, name = operands.dialect, words[0].text.upper()
    span = Span(words[0].span.row, words[0].span.start, words[-1].span.stop)
    move, work = (dialect.insn(word) for word in dialect.boxes[name])
    given = words[1 : _OPERANDS + 1]
    if len(given) < _OPERANDS:
        operands.say("RDR003", span, word=name, expected=same("IN1, IN2, OUT"))
        return
    if words[_OPERANDS + 1 :]:
        operands.say("RDR004", words[_OPERANDS + 1].span, word=name, rest=words[_OPERANDS + 1].shown)
        return
    kinds = (move, move.operands[0]), (work, work.operands[0]), (move, move.operands[1])
    in1, in2, out = (
        operands.word(insn, operand, word, dialect.kinds[operand.kind])
        for (insn, operand), word in zip(kinds, given, strict=True)
    )
    if not isinstance(in1, Address | Value) or not isinstance(in2, Address | Value) or not isinstance(out, Address):
        return
    parts, found = split(dialect, Box(name, in1, in2, out, span))
    operands.found += found
    for number, (word, source, target) in enumerate(parts):
        insn = dialect.insn(word)
        remarks = ("", statement.above) if number == 0 else (statement.comment, ())
        yield Line(insn, (source, target), insn.effect, span, *remarks)
