"""What can be said of timers by their numbers: which instruction a number goes with, and who shares it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.check.rules.registry import PROGRAM_RULES, finds
from plcteach.check.rules.values import Leaf, Values, follow, leaves
from plcteach.core.text import Text, same

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.area import Address
    from plcteach.core.block import Block
    from plcteach.core.diagnostic import Diagnostic, Rule
    from plcteach.core.effect import Formula
    from plcteach.core.program import Line, Program
    from plcteach.core.spec import Dialect
    from plcteach.core.verb import Verb

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
    """A timer that is brought up to date elsewhere than at its own line switches itself off by its own bit.

    It is no mistake where a coil above has taken the bit first, and no contact below waits for it.
    """
    early = {one.bit: one for one in reversed(_on_delays(program)) if program.dialect.bank(one.timer).when != "line"}
    values = follow(program) if early else Values()
    for one in early.values():
        ways = leaves([values.given(one.number, one.formula)], values.made)
        own = [leaf for leaf in ways if leaf.word == one.bit]
        if own and all(leaf.falls for leaf in own):
            when = program.dialect.bank(one.timer).when
            carried = all(leaf.through and not leaf.turned for leaf in own)
            seen = when == "scan" and values.told(one.bit) < one.number
            if not (carried or seen or _held(values, ways, one.bit)) or _read_later(program, one):
                yield row.at(one.line.span, address=one.timer.text, when=_MOMENTS[when])


_MOMENTS = {
    "scan": Text("每个扫描周期开始时", "at the start of each scan"),
    "always": Text("在扫描中途随时", "in the middle of a scan, at any moment"),
}


@dataclass(frozen=True, slots=True)
class _OnDelay:
    """A line that switches an on-delay on: its number, the timer, the timer's output bit, and what reaches its input."""

    number: int
    line: Line
    timer: Address
    bit: str
    formula: Formula | None


def _on_delays(program: Program) -> list[_OnDelay]:
    found = []
    for number, line in enumerate(program.lines):
        for verb, timer in line.targets:
            block = program.dialect.block(timer)
            if block and block.rule == "timer" and _switches_on(program, verb, timer, block):
                bit = f"{timer.text}.{block.bit}" if block.bit else timer.text
                found.append(_OnDelay(number, line, timer, bit, dict(verb.pins).get("IN", verb.formula)))
    return found


def _switches_on(program: Program, verb: Verb, timer: Address, block: Block) -> bool:
    """Say whether a verb is the input of an on-delay; some families say in the configuration what a timer is."""
    if verb.name == "drive":
        return verb.op == "on"
    kind = (block.settings or {}).get("TYPE")
    if verb.name != "pin" or not kind or not kind.choices:
        return False
    said = program.settings.get(timer.text, {}).get("TYPE", kind.default)
    return kind.choices.get(str(said)) == "on"


def _held(values: Values, ways: set[Leaf], bit: str) -> bool:
    """Say whether a bit that holds itself keeps the timer on and is let go by it: then it remembers what the timer said."""
    holding = [values.last[leaf.word] for leaf in ways if not leaf.falls and leaf.word in values.last]
    return any(one.word == bit and one.falls for one in leaves(holding, values.made))


def _read_later(program: Program, one: _OnDelay) -> bool:
    """Say whether a normally open contact of the timer stands below it in its routine, where it is off again."""
    placed = [(network.block, line) for network in program.networks for line in network.lines]
    block = placed[one.number][0]
    return any(
        home == block
        and "!" not in line.effect.text
        and one.bit in {place.text for place in line.bits}
        and one.bit not in {target.text for _, target in line.targets}
        for home, line in placed[one.number + 1 :]
    )


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
