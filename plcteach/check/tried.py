"""Two programs with time or words in them, tried side by side: many timelines at once, the same ones on every machine.

What is found is a difference and its inputs; finding none proves nothing, and the verdict then says so.
"""

from __future__ import annotations

from dataclasses import replace
from random import Random
from typing import TYPE_CHECKING, Any

from plcteach.core.area import Address
from plcteach.core.program import Compare
from plcteach.core.verdict import Counterexample, Status, Verdict
from plcteach.machine.lanes import Lanes, lanes
from plcteach.machine.plan import plan_of
from plcteach.machine.scan import run

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator, Sequence

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.program import Line, Program
    from plcteach.core.spec import Dialect

TIMELINES = 64
SCANS = 400
FEW_TIMELINES = 4
FEW_SCANS = 60
"""A program that goes back in its scan runs timeline after timeline, so it is tried over fewer of them."""
LASTING = 5
"""A difference that is over sooner may be no more than rungs in another order."""
SCAN_MS = 20
_SEED = 20030907
_BITS_ONLY = {"coil", "set", "reset", "end"}

Row = dict[str, Any]


def beyond_bits(program: Program) -> bool:
    """Say whether a program has more than bits in it: time, words, blocks, or another course than straight on."""
    return any(_beyond(program.dialect, line) for line in program.lines)


def _beyond(dialect: Dialect, line: Line) -> bool:
    if not line.insn.does <= _BITS_ONLY:
        return True
    return any(
        isinstance(arg, Compare)
        or (
            isinstance(arg, Address) and (arg.size != 1 or arg.text in dialect.moving or dialect.block(arg) is not None)
        )
        for arg in line.args
    )


def tried(
    programs: tuple[Program, Program],
    inputs: tuple[str, ...],
    outputs: tuple[str, ...],
    beside: tuple[Diagnostic, ...],
    *,
    lasting: int = 1,
) -> Verdict:
    """Run both (the reference first) over the same timelines, and report the first scan in which they differ.

    lasting: for so many scans in a row; more than 1 passes over what only comes a scan or two later.
    """
    nothing: dict[str, Status] = dict.fromkeys(outputs, "unknown")
    if any(_runs_away(one) for one in programs):
        return Verdict("unknown", None, None, nothing, beside, 1)
    straight = all(plan_of(one).straight for one in programs)
    count, scans = (TIMELINES, SCANS) if straight else (FEW_TIMELINES, FEW_SCANS)
    timelines = [list(_timeline(number, inputs))[:scans] for number in range(count)]
    both = tuple(lanes(one, timelines, scan_ms=SCAN_MS) for one in programs)
    held = [0] * count
    for scan in range(scans):
        cases = _differing(both, outputs, scan)
        held = [one + 1 if cases >> lane & 1 else 0 for lane, one in enumerate(held)]
        found = [lane for lane, one in enumerate(held) if one >= lasting]
        if found:
            lane = min(found, key=lambda one: sum(len(row) for row in timelines[one][: scan + 1]))
            rows = tuple({**row, "ms": SCAN_MS} for row in timelines[lane][: scan + 1])
            return replace(different(programs, rows, outputs), diagnostics=beside, explored=len(rows))
    return Verdict("unknown", None, None, nothing, beside, count * scans)


def _runs_away(program: Program) -> bool:
    """Say whether a program that can go back does not come to the end of its first scan."""
    return not plan_of(program).straight and any(one.code in {"RUN002", "RUN003"} for one in run(program).diagnostics)


def _timeline(number: int, inputs: tuple[str, ...]) -> Iterator[Row]:
    """Give one timeline: inputs held for a while, then one or a few of them turned over; some are quick and some slow."""
    chance = Random(_SEED + number)  # noqa: S311 (the same timelines everywhere, on purpose)
    pace = (2, 10, 60, 300)[number % 4]
    now = dict.fromkeys(inputs, 0)
    for scan in range(SCANS):
        changed = {}
        if inputs and scan and chance.random() < 1 / pace:
            for name in chance.sample(inputs, chance.randint(1, 1 + (chance.random() < 1 / 3 and len(inputs) > 1))):
                now[name] = changed[name] = 1 - now[name]
        yield changed


def _differing(both: tuple[Lanes, ...], outputs: tuple[str, ...], scan: int) -> int:
    """Give the timelines in which an output differs after a scan, as the bits of a number."""
    cases = 0
    for address in outputs:
        mine, theirs = (one.column(address, scan) for one in both)
        cases |= mine.differs(theirs) | theirs.unknown
    return cases


def different(
    programs: tuple[Program, Program],
    rows: Sequence[Row],
    outputs: tuple[str, ...],
    agreed: Collection[str] = (),
) -> Verdict:
    """Replay the found inputs on the plain machine, so that what is shown is what it does; `agreed`: outputs proved equal."""
    traces = [run(one, rows) for one in programs]
    last = len(rows) - 1
    values = [
        tuple({address: repr(trace.value(address, scan)) for address in outputs} for scan in range(len(rows)))
        for trace in traces
    ]
    wrong = [one for one in outputs if values[0][last][one] != values[1][last][one] or values[1][last][one] == "x"]
    said: dict[str, Status] = {
        one: "different" if one in wrong else "equal" if one in agreed else "unknown" for one in outputs
    }
    return Verdict("different", None, Counterexample(tuple(rows), values[0], values[1], last, wrong[0]), said)
