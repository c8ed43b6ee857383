"""Two programs that no circuit describes (they loop, divide, jump back), tried side by side over many timelines.

The timelines are the same ones on every machine. What is found is a difference and its inputs; finding none proves nothing, and the
verdict then says so.
"""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING, Any

from plcteach.check.proof.replay import holds, replay
from plcteach.check.proof.terms import condition
from plcteach.core.verdict import Status, Verdict
from plcteach.machine.plan import plan_of
from plcteach.machine.scan import run
from plcteach.machine.signals import ONE, ZERO

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.exercise import Terms
    from plcteach.core.program import Program
    from plcteach.machine.scan import Trace

TIMELINES, SCANS = 16, 120
FEWEST_TIMELINES, FEWEST_SCANS = 2, 5
MOST_LINE_SCANS = 12_000
"""So many lines are executed in all; a long program is tried over fewer scans."""
SCAN_MS = 20
_SEED = 20030907

Row = dict[str, Any]


def tried(programs: tuple[Program, Program], outputs: tuple[str, ...], terms: Terms, *, lasting: int = 1) -> Verdict:
    """Run both (the reference first) over the same timelines, and report the first scan in which they differ.

    lasting: for so many scans in a row; more than 1 passes over what only comes a scan or two later.
    """
    nothing: dict[str, Status] = dict.fromkeys(outputs, "unknown")
    if any(_runs_away(one) for one in programs):
        return Verdict("unknown", outputs=nothing, explored=1)
    lines = sum(len(one.lines) + 1 for one in programs)
    scans = max(FEWEST_SCANS, min(SCANS, MOST_LINE_SCANS // (lines * FEWEST_TIMELINES)))
    count = max(FEWEST_TIMELINES, min(TIMELINES, MOST_LINE_SCANS // (lines * scans)))
    inputs = tuple(dict.fromkeys(place.text for one in programs for place in one.addresses("input")))
    for number in range(count):
        rows = [{**row, "ms": SCAN_MS} for row in _timeline(number, scans, inputs, (programs[0], terms))]
        scan = _parting(programs, rows, outputs, terms, lasting)
        seen = None if scan is None else replay(programs, rows[: scan + 1], outputs, terms)
        if seen:
            said: dict[str, Status] = {text: "different" if text in seen.wrong else "unknown" for text in outputs}
            return Verdict("different", None, seen.example, said, explored=number * scans + len(seen.example.inputs))
    return Verdict("unknown", outputs=nothing, explored=count * scans)


def _parting(
    programs: tuple[Program, Program], rows: list[Row], outputs: tuple[str, ...], terms: Terms, lasting: int
) -> int | None:
    """Give the first scan after which the two have differed for so long; None where they do not."""
    traces = tuple(run(one, rows) for one in programs)
    held = 0
    for scan in range(len(rows)):
        held = held + 1 if any(_differs(traces, text, scan, terms) for text in outputs) else 0
        if held >= lasting:
            return scan
    return None


def _differs(traces: tuple[Trace, ...], text: str, scan: int, terms: Terms) -> bool:
    """Say whether an output differs after a scan, or what must never be is."""
    mine, theirs = traces
    if text in terms.never:
        return holds(theirs, text, scan) != "0"
    if text in terms.dont_care and holds(mine, terms.dont_care[text], scan) == "1":
        return False
    got = repr(theirs.value(text, scan))
    return got == "x" or got != repr(mine.value(text, scan))


def _runs_away(program: Program) -> bool:
    """Say whether a program that can go back does not come to the end of its first scan."""
    return not plan_of(program).straight and any(one.code in {"RUN002", "RUN003"} for one in run(program).diagnostics)


def _timeline(number: int, scans: int, inputs: tuple[str, ...], allowed: tuple[Program, Terms]) -> Iterator[Row]:
    """Give one timeline: inputs held for a while, then one or a few of them turned over; some are quick and some slow."""
    chance = Random(_SEED + number)  # noqa: S311 (the same timelines everywhere, on purpose)
    pace = (2, 8, 20, 60)[number % 4]
    now = dict.fromkeys(inputs, 0)
    program, terms = allowed
    for scan in range(scans):
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
