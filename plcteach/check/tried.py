"""Two programs that no circuit describes (they loop, divide, jump back), tried side by side over many timelines.

The timelines are the same ones on every machine. What is found is a difference and its inputs; finding none proves nothing, and the
verdict then says so.
"""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING, Any

from plcteach.check.proof.replay import replay
from plcteach.check.proof.terms import condition
from plcteach.core.verdict import Status, Verdict
from plcteach.machine.lanes import Lanes, lanes
from plcteach.machine.plan import plan_of
from plcteach.machine.scan import run
from plcteach.machine.signals import ONE, ZERO

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.exercise import Terms
    from plcteach.core.program import Program

TIMELINES = 32
SCANS = 200
FEW_TIMELINES = 4
FEW_SCANS = 60
"""A program that goes back in its scan runs timeline after timeline, so it is tried over fewer of them."""
SCAN_MS = 20
MOST_LINE_SCANS = 500_000
_SEED = 20030907

Row = dict[str, Any]


def tried(programs: tuple[Program, Program], outputs: tuple[str, ...], terms: Terms, *, lasting: int = 1) -> Verdict:
    """Run both (the reference first) over the same timelines, and report the first scan in which they differ.

    lasting: for so many scans in a row; more than 1 passes over what only comes a scan or two later.
    """
    nothing: dict[str, Status] = dict.fromkeys(outputs, "unknown")
    if any(_runs_away(one) for one in programs):
        return Verdict("unknown", outputs=nothing, explored=1)
    straight = all(plan_of(one).straight for one in programs)
    count, scans = (TIMELINES, SCANS) if straight else (FEW_TIMELINES, FEW_SCANS)
    scans = max(2, min(scans, MOST_LINE_SCANS // (count * max(len(one.lines) + 1 for one in programs))))
    inputs = tuple(dict.fromkeys(place.text for one in programs for place in one.addresses("input")))
    timelines = [list(_timeline(number, inputs, programs[0], terms))[:scans] for number in range(count)]
    both = tuple(lanes(one, timelines, scan_ms=SCAN_MS) for one in programs)
    held = [0] * count
    for scan in range(scans):
        cases = _differing(both, outputs, scan, terms)
        held = [one + 1 if cases >> lane & 1 else 0 for lane, one in enumerate(held)]
        found = [lane for lane, one in enumerate(held) if one >= lasting]
        if found:
            lane = min(found, key=lambda one: sum(len(row) for row in timelines[one][: scan + 1]))
            rows = tuple({**row, "ms": SCAN_MS} for row in timelines[lane][: scan + 1])
            seen = replay(programs, rows, outputs, terms)
            if seen:
                said: dict[str, Status] = {text: "different" if text in seen.wrong else "unknown" for text in outputs}
                return Verdict("different", None, seen.example, said, explored=len(rows))
    return Verdict("unknown", outputs=nothing, explored=count * scans)


def _runs_away(program: Program) -> bool:
    """Say whether a program that can go back does not come to the end of its first scan."""
    return not plan_of(program).straight and any(one.code in {"RUN002", "RUN003"} for one in run(program).diagnostics)


def _timeline(number: int, inputs: tuple[str, ...], program: Program, terms: Terms) -> Iterator[Row]:
    """Give one timeline: inputs held for a while, then one or a few of them turned over; some are quick and some slow."""
    chance = Random(_SEED + number)  # noqa: S311 (the same timelines everywhere, on purpose)
    pace = (2, 10, 60, 300)[number % 4]
    now = dict.fromkeys(inputs, 0)
    for scan in range(SCANS):
        changed = {}
        if inputs and scan and chance.random() < 1 / pace:
            few = 1 + (chance.random() < 1 / 3 and len(inputs) > 1 and not terms.single_change)
            for name in chance.sample(inputs, chance.randint(1, few)):
                changed[name] = 1 - now[name]
            changed = changed if _may(program, terms, now | changed) else {}
            now |= changed
        yield changed


def _may(program: Program, terms: Terms, now: Row) -> bool:
    """Say whether inputs are such as the terms allow."""
    bits = {name: ONE if value else ZERO for name, value in now.items()}
    return all(
        condition(text, program.dialect).worked(lambda place: bits.get(place.text, ZERO)) == ONE
        for text in terms.assume
    )


def _differing(both: tuple[Lanes, ...], outputs: tuple[str, ...], scan: int, terms: Terms) -> int:
    """Give the timelines in which an output differs after a scan, as the bits of a number."""
    cases = 0
    dialect = both[0].program.dialect
    for text in outputs:
        if text in terms.never:
            broken = condition(text, dialect).worked(lambda place: both[1].column(place.text, scan))
            cases |= broken.may1
            continue
        mine, theirs = (one.column(text, scan) for one in both)
        wrong = mine.differs(theirs) | theirs.unknown
        if text in terms.dont_care:
            spared = condition(terms.dont_care[text], dialect).worked(lambda place: both[0].column(place.text, scan))
            wrong &= ~(spared.may1 & ~spared.may0)
        cases |= wrong
    return cases
