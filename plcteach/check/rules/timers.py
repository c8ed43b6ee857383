"""What can be said of timers by their numbers: which instruction a number goes with, and who shares it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.rules.registry import PROGRAM_RULES, finds
from plcteach.core.text import Text, same

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.area import Address
    from plcteach.core.diagnostic import Diagnostic, Rule
    from plcteach.core.program import Line, Program
    from plcteach.core.spec import Dialect

_RETENTIVE = "retentive"
_TITLES = {
    True: Text("有记忆接通延时定时器", "retentive timer"),
    False: Text("没有记忆的定时器", "timer that is not retentive"),
}


@finds("TMR001", PROGRAM_RULES)
def number_of_another_timer(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A timer instruction stands with a number of the other sort, in a family whose numbers decide."""
    if not _tells_by_number(program.dialect):
        return
    for line, timer, op in _driven(program):
        wanted = op == _RETENTIVE
        if program.dialect.bank(timer).retains is not wanted:
            word, fitting = line.insn.word, same(", ".join(_fitting(program.dialect, timer, retains=wanted)))
            yield row.at(line.span, address=timer.text, word=word, title=_TITLES[not wanted], fitting=fitting)


@finds("TMR002", PROGRAM_RULES)
def number_shared(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """One number is an on-delay here and an off-delay there."""
    first: dict[str, tuple[Line, str]] = {}
    for line, timer, op in _driven(program):
        other, before = first.setdefault(timer.text, (line, op))
        if before != op and program.dialect.bank(timer).retains is (op == _RETENTIVE):
            yield row.at(line.span, address=timer.text, row=other.span.row, other=other.insn.word, word=line.insn.word)


@finds("TMR003", PROGRAM_RULES)
def resets_itself(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A timer that is brought up to date elsewhere than at its own line switches itself off by its own bit."""
    for network in program.networks:
        circuit: list[Line] = []
        for line in network.lines:
            for _, timer, op in _drives(program, line):
                when = program.dialect.bank(timer).when
                if op == "on" and when != "line" and any(_breaks(one, timer) for one in circuit):
                    yield row.at(line.span, address=timer.text, when=_MOMENTS[when])
            circuit = [] if line.insn.then else [*circuit, line]


_MOMENTS = {
    "scan": Text("每个扫描周期开始时", "at the start of each scan"),
    "always": Text("在扫描中途随时", "in the middle of a scan, at any moment"),
}


def _breaks(line: Line, timer: Address) -> bool:
    """Say whether a line is a normally closed contact of a timer."""
    return "!" in line.effect.text and any(place.text == timer.text for place in line.bits)


def _tells_by_number(dialect: Dialect) -> bool:
    return any(row.retentive for row in dialect.insns)


def _driven(program: Program) -> Iterator[tuple[Line, Address, str]]:
    """Give each line that drives a timer, with the timer and the rule that the instruction names."""
    return (found for line in program.lines for found in _drives(program, line))


def _drives(program: Program, line: Line) -> Iterator[tuple[Line, Address, str]]:
    for verb, timer in line.targets:
        block = program.dialect.block(timer)
        if verb.name == "drive" and block and block.rule == "timer":
            yield line, timer, verb.op


def _fitting(dialect: Dialect, timer: Address, *, retains: bool) -> list[str]:
    """Give the stretches of numbers that are of one sort, neighbours in one."""
    block, area = dialect.block(timer), dialect.area(timer)
    stretches: list[tuple[int, int]] = []
    for bank in sorted(block.banks if block else (), key=lambda one: one.first):
        if bank.retains is not retains:
            continue
        if stretches and stretches[-1][1] + 1 == bank.first:
            stretches[-1] = stretches[-1][0], bank.last
        else:
            stretches.append((bank.first, bank.last))
    return [area.prefix + f"{first}" + (f"–{area.prefix}{last}" if last > first else "") for first, last in stretches]
