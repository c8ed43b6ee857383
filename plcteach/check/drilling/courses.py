"""The scans of a chart that is asked for: a course of the inputs, long enough for its timers, in which the outputs do something."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.errors import PlcTeachError
from plcteach.core.text import Text, language
from plcteach.figure.table import telling_inputs
from plcteach.machine import run

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.check.drilling.dice import Dice
    from plcteach.core.program import Program

_SHORT, _LONG = 8, 12
_TRIES = 12
_STEPS = (100, 500, 1_000, 2_000, 5_000, 10_000, 60_000, 600_000)
"""How long a scan may take in ms, where the program measures time: round numbers, for they are added up on paper."""
_CHANGES = 0.3

Scans = tuple[dict[str, int], ...]


def course(program: Program, dice: Dice) -> Scans:
    """Give scans in which as many outputs as can be found are on as well as off; with times only where time makes one so."""
    inputs = [one.text for one in program.addresses("input")]
    first = telling_inputs(program)
    best: Scans = (first, *({dice.pick(inputs): dice.number(0, 1)} if inputs else {} for _ in range(_SHORT - 1)))
    outputs = [one.text for one in program.addresses("output")]
    most = _telling(program, best, outputs)
    for step in (0, *_STEPS):
        for _ in range(_TRIES):
            if most == len(outputs):
                return best
            tried = _tried(inputs, dice, step)
            told = _telling(program, tried, outputs)
            if told > most:
                most, best = told, tried
    if most < 0:
        raise PlcTeachError(_NO_END.in_(language()))
    return best


_NO_END = Text(
    "这个程序在扫描当中停了下来，所以没有什么可问的。",
    "The program comes to a stop within a scan, so there is nothing to ask.",
)


def _tried(inputs: Sequence[str], dice: Dice, step: int) -> Scans:
    """Give a course by chance; each scan takes `step` ms, or as long as a scan takes where it is 0."""
    time = {"ms": step} if step else {}
    first = {name: dice.number(0, 1) for name in inputs}
    later = [
        {dice.pick(inputs): dice.number(0, 1)} if inputs and dice.falls(_CHANGES) else {}
        for _ in range((_LONG if step else _SHORT) - 1)
    ]
    return tuple({**row, **time} for row in (first, *later))


def _telling(program: Program, scans: Scans, outputs: Sequence[str]) -> int:
    """Count the outputs that are on at some time and off at another; -1 where the program does not run to the end of the scans."""
    trace = run(program, list(scans))
    if len(trace) < len(scans):
        return -1
    return sum({"0", "1"} <= set(map(repr, trace.values(one))) for one in outputs)
