"""Two programs with time or words in them, tried side by side: many timelines at once, the same ones on every machine.

What is found is a difference and its inputs; finding none proves nothing, and the verdict then says so.
"""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING, Any

from plcteach.core.area import Address
from plcteach.core.program import Compare
from plcteach.core.verdict import Counterexample, Status, Verdict
from plcteach.machine.lanes import Lanes, lanes
from plcteach.machine.scan import run

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.program import Line, Program

TIMELINES = 64
SCANS = 400
SCAN_MS = 50
_SEED = 20030907
_BITS_ONLY = {"coil", "set", "reset", "end"}

Row = dict[str, Any]


def beyond_bits(program: Program) -> bool:
    """Say whether a program has more than bits in it: time, words, blocks, or another course than straight on."""
    clocks = {address for address, what in program.dialect.specials.items() if what.isdigit() or what == "turns"}
    return any(_beyond(program, line, clocks) for line in program.lines)


def _beyond(program: Program, line: Line, clocks: set[str]) -> bool:
    if any(verb.name not in _BITS_ONLY for verb in line.insn.then):
        return True
    return any(
        isinstance(arg, Compare)
        or (
            isinstance(arg, Address) and (arg.size != 1 or arg.text in clocks or program.dialect.block(arg) is not None)
        )
        for arg in line.args
    )


def tried(
    programs: tuple[Program, Program], inputs: tuple[str, ...], outputs: tuple[str, ...], beside: tuple[Diagnostic, ...]
) -> Verdict:
    """Run both (the reference first) over the same timelines, and report the first scan in which they differ."""
    timelines = [list(_timeline(number, inputs)) for number in range(TIMELINES)]
    both = tuple(lanes(one, timelines, scan_ms=SCAN_MS) for one in programs)
    explored = TIMELINES * SCANS
    for scan in range(SCANS):
        cases = _differing(both, outputs, scan)
        if cases:
            lane = min(cases, key=lambda one: sum(len(row) for row in timelines[one][: scan + 1]))
            rows = tuple({**row, "ms": SCAN_MS} for row in timelines[lane][: scan + 1])
            return _different(programs, rows, outputs, beside)
    unknown: dict[str, Status] = dict.fromkeys(outputs, "unknown")
    return Verdict("unknown", None, None, unknown, beside, explored)


def _timeline(number: int, inputs: tuple[str, ...]) -> Iterator[Row]:
    """Give one timeline: inputs held for a while, then one or a few of them turned over; some are quick and some slow."""
    chance = Random(_SEED + number)  # noqa: S311 (the same timelines everywhere, on purpose)
    pace = (1, 3, 10, 40)[number % 4]
    now = dict.fromkeys(inputs, 0)
    for scan in range(SCANS):
        changed = {}
        if inputs and scan and chance.random() < 1 / pace:
            for name in chance.sample(inputs, chance.randint(1, 1 + (chance.random() < 1 / 3 and len(inputs) > 1))):
                now[name] = changed[name] = 1 - now[name]
        yield changed


def _differing(both: tuple[Lanes, ...], outputs: tuple[str, ...], scan: int) -> list[int]:
    cases = 0
    for address in outputs:
        mine, theirs = (one.column(address, scan) for one in both)
        cases |= mine.differs(theirs) | theirs.unknown
    return [lane for lane in range(TIMELINES) if cases >> lane & 1]


def _different(
    programs: tuple[Program, Program],
    rows: tuple[Row, ...],
    outputs: tuple[str, ...],
    beside: tuple[Diagnostic, ...],
) -> Verdict:
    traces = [run(one, rows, scan_ms=SCAN_MS) for one in programs]
    last = len(rows) - 1
    values = [
        tuple({address: repr(trace.value(address, scan)) for address in outputs} for scan in range(len(rows)))
        for trace in traces
    ]
    wrong = [one for one in outputs if values[0][last][one] != values[1][last][one] or values[1][last][one] == "x"]
    said: dict[str, Status] = {address: "different" if address in wrong else "unknown" for address in outputs}
    counterexample = Counterexample(rows, values[0], values[1], last, wrong[0])
    return Verdict("different", None, counterexample, said, beside, len(rows))
