"""Where a program can go: its routines, labels and loops, and the timers that run by themselves; worked out once a program."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.area import Address
    from plcteach.core.block import When
    from plcteach.core.program import Line, Program

_WAKING = {"step", "rail", "restore", "segment"}


@dataclass(frozen=True, slots=True)
class Plan:
    """The fixed things about a program's course; lines are counted from 0 over all networks.

    starts: lines that begin a network.  routines: first line and the line after the last, by name; "" is the main program.
    labels: the line of each label, by routine and number.  ends: for each FOR its NEXT and the other way round.
    wakes: lines that matter even where the program passes over.  clocks: timers with their rule, and when they tick.
    """

    lines: tuple[Line, ...]
    starts: frozenset[int]
    routines: dict[str, tuple[int, int]]
    labels: dict[tuple[str, int], int]
    ends: dict[int, int]
    wakes: frozenset[int]
    clocks: tuple[tuple[Address, str, When], ...]

    @property
    def straight(self) -> bool:
        """Whether a scan never goes back, so that it can be written down line after line."""
        back = any(
            self.labels.get((name, number), at + 1) <= at
            for name, (first, stop) in self.routines.items()
            for at in range(first, stop)
            for number in jumps_of(self.lines[at])
        )
        return not back and not self.ends


def jumps_of(line: Line) -> Iterator[int]:
    """Give the labels that a line may jump to."""
    for verb in line.insn.then:
        number = line.bound.get(verb.target)
        if verb.name == "jump" and isinstance(number, int):
            yield number


_plans: dict[int, tuple[Program, Plan]] = {}
_MOST_PLANS = 64


def plan_of(program: Program) -> Plan:
    """Give a program's plan; the last few are kept."""
    known = _plans.get(id(program))
    if known and known[0] is program:
        return known[1]
    plan = _plan(program)
    if len(_plans) >= _MOST_PLANS:
        del _plans[next(iter(_plans))]
    _plans[id(program)] = (program, plan)
    return plan


def _plan(program: Program) -> Plan:
    routines: dict[str, tuple[int, int]] = {}
    starts: set[int] = set()
    at = 0
    for network in program.networks:
        first, _ = routines.get(network.block, (at, at))
        starts.add(at)
        at += len(network.lines)
        routines[network.block] = (first, at)
    routines.setdefault("", (0, 0))
    labels: dict[tuple[str, int], int] = {}
    for name, (first, stop) in routines.items():
        for number in range(first, stop):
            for verb in program.lines[number].insn.then:
                label = program.lines[number].bound.get(verb.target)
                if verb.name == "label" and isinstance(label, int):
                    labels.setdefault((name, label), number)
    wakes = {number for number, line in enumerate(program.lines) if line.insn.does & _WAKING}
    clocks = tuple(dict.fromkeys(_clocks(program)))
    return Plan(program.lines, frozenset(starts), routines, labels, _loops(program.lines), frozenset(wakes), clocks)


def _loops(lines: tuple[Line, ...]) -> dict[int, int]:
    ends: dict[int, int] = {}
    open_loops: list[int] = []
    for number, line in enumerate(lines):
        if "loop" in line.insn.does:
            open_loops.append(number)
        elif "next" in line.insn.does and open_loops:
            first = open_loops.pop()
            ends |= {first: number, number: first}
    return ends


def _clocks(program: Program) -> Iterator[tuple[Address, str, When]]:
    """Give each timer that ticks without its instruction, with the rule that its instruction names."""
    dialect = program.dialect
    for line in program.lines:
        for verb, target in line.targets:
            block = dialect.block(target)
            driven = verb.name in {"drive", "pin", "update"} and block and block.rule == "timer"
            if driven and dialect.bank(target).when != "line":
                yield target, verb.op if verb.name == "drive" else "", dialect.bank(target).when
