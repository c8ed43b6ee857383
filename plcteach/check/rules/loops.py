"""What can be said of loops: every one begins and ends in its own routine, and not too many stand within each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.rules.registry import PROGRAM_RULES, finds
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic, Rule
    from plcteach.core.program import Line, Program

MOST_LOOPS = 8
_NO_END = Text("这个循环没有结束", "this loop has no end")
_NO_BEGINNING = Text("前面没有循环开始", "no loop begins above it")


def _loops(program: Program) -> Iterator[tuple[str, Line, int]]:
    """Give each line that begins or ends a loop, with what is wrong with it ("open", "stray", "") and how deep it stands."""
    waiting: list[tuple[str, Line]] = []
    for network in program.networks:
        while waiting and waiting[-1][0] != network.block:
            yield "open", waiting.pop()[1], 0
        for line in network.lines:
            does = line.insn.does
            if "loop" in does:
                waiting.append((network.block, line))
                yield "", line, len(waiting)
            elif "next" in does and waiting:
                waiting.pop()
            elif "next" in does:
                yield "stray", line, 0
    for _, line in reversed(waiting):
        yield "open", line, 0


@finds("JMP005", PROGRAM_RULES)
def loop_unpaired(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A loop begins and does not end, or ends and did not begin."""
    for wrong, line, _ in _loops(program):
        if wrong:
            yield row.at(line.span, word=line.text, what=_NO_END if wrong == "open" else _NO_BEGINNING)


@finds("JMP006", PROGRAM_RULES)
def loops_too_deep(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """More loops stand within each other than the CPU can nest."""
    for _, line, depth in _loops(program):
        if depth > MOST_LOOPS:
            yield row.at(line.span, word=line.text, depth=depth, most=MOST_LOOPS)
