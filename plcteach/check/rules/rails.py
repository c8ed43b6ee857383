"""What can be said of master controls and steps: every one is ended, they nest by number, and neither stands in the wrong place."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from plcteach.check.rules.registry import PROGRAM_RULES, finds

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic, Rule
    from plcteach.core.program import Line, Program

What = Literal["open", "stray", "nested", "in step"]


@dataclass(frozen=True, slots=True)
class _Event:
    """Something about a master control: what, the line it is about, and the line that it meets."""

    what: What
    line: Line
    other: Line | None = None


def _number(line: Line) -> int:
    return next((arg for arg in line.args if isinstance(arg, int)), 0)


def _masters(program: Program) -> Iterator[_Event]:
    """Follow the master controls down the list."""
    waiting: list[Line] = []
    step: Line | None = None
    for line in program.lines:
        does = line.insn.does
        step = line if "step" in does else None if "rail" in does else step
        if "master" in does:
            if step:
                yield _Event("in step", line, step)
            if waiting and _number(waiting[-1]) >= _number(line):
                yield _Event("nested", line, waiting[-1])
            waiting.append(line)
        elif "restore" in does:
            numbers = [_number(one) for one in waiting]
            if _number(line) in numbers:
                del waiting[numbers.index(_number(line)) :]
            else:
                yield _Event("stray", line)
    yield from (_Event("open", line) for line in waiting)


def _partner(program: Program, verb: str, line: Line) -> str:
    """Give the instruction that begins or ends what a line is about, with the same number."""
    row = next(row for row in program.dialect.insns if verb in row.does)
    mark = row.operands[0].mark if row.operands else ""
    return f"{row.word} {mark}{_number(line)}" if mark else row.word


@finds("COI003", PROGRAM_RULES)
def master_open(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A master control is never ended."""
    for one in _masters(program):
        if one.what == "open":
            yield row.at(one.line.span, word=one.line.text, end=_partner(program, "restore", one.line))


@finds("COI004", PROGRAM_RULES)
def master_stray(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A master control reset has no master control."""
    open_later = {_number(one.line) for one in _masters(program) if one.what == "nested"}
    for one in _masters(program):
        if one.what == "stray" and _number(one.line) not in open_later:
            yield row.at(one.line.span, word=one.line.text, begin=_partner(program, "master", one.line))


@finds("COI005", PROGRAM_RULES)
def master_nesting(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A master control stands in another whose number is not smaller."""
    for one in _masters(program):
        if one.what == "nested" and one.other:
            yield row.at(one.line.span, word=one.line.text, outer=one.other.text)


@finds("COI006", PROGRAM_RULES)
def master_in_step(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A master control stands inside a step."""
    for one in _masters(program):
        if one.what == "in step" and one.other:
            yield row.at(one.line.span, word=one.line.text, step=one.other.text)


@finds("COI007", PROGRAM_RULES)
def branch_after_step(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A push stands right behind a step's contact."""
    for above, line in zip(program.lines, program.lines[1:], strict=False):
        if "step" in above.insn.does and program.dialect.parts.get(line.insn.mnemonic) == "push":
            yield row.at(line.span, word=line.text, step=above.text, load=program.dialect.roles["load"])


@finds("COI008", PROGRAM_RULES)
def steps_open(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """Steps are begun and never ended."""
    step: Line | None = None
    for line in program.lines:
        does = line.insn.does
        step = line if "step" in does else None if "rail" in does else step
    if step:
        yield row.at(step.span, word=step.text, end=_partner(program, "rail", step))
