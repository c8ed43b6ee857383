"""Two programs that no circuit describes (they loop, divide, jump back), tried side by side over many timelines.

The timelines are the same ones on every machine. What is found is a difference and its inputs; finding none proves nothing, and the
verdict then says so.
"""

from __future__ import annotations

from itertools import chain, repeat
from random import Random
from typing import TYPE_CHECKING, Any

from plcteach.check.proof.replay import holds, replay
from plcteach.check.proof.terms import condition
from plcteach.core.diagnostic import errors
from plcteach.core.verdict import Status, Verdict
from plcteach.machine.plan import plan_of
from plcteach.machine.scan import run, sweep
from plcteach.machine.signals import ONE, ZERO
from plcteach.machine.store import Memory
from plcteach.machine.words import BITS

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.exercise import Terms
    from plcteach.core.program import Line, Program
    from plcteach.machine.scan import Trace

TIMELINES, SCANS = 16, 120
FEWEST_TIMELINES, FEWEST_SCANS = 2, 5
MOST_LINE_SCANS = 12_000
"""So many lines are executed in all; a long program is tried over fewer scans."""
SCAN_MS = 20
_SEED = 20030907
_ENDLESS = {"RUN002", "RUN003"}

Row = dict[str, Any]


def tried(programs: tuple[Program, Program], outputs: tuple[str, ...], terms: Terms, *, lasting: int = 1) -> Verdict:
    """Run both (the reference first) over the same timelines, and report the first scan in which they differ.

    lasting: for so many scans in a row; more than 1 passes over what only comes a scan or two later.
    """
    nothing: dict[str, Status] = dict.fromkeys(outputs, "unknown")
    first = [_first_scan(one) for one in programs]
    if any(errors(found) for _, found in first):
        return Verdict("unknown", outputs=nothing, explored=1)
    lines = sum(count + 1 for count, _ in first)
    scans = max(FEWEST_SCANS, min(SCANS, MOST_LINE_SCANS // (lines * FEWEST_TIMELINES)))
    count = max(FEWEST_TIMELINES, min(TIMELINES, MOST_LINE_SCANS // (lines * scans)))
    inputs = tuple(dict.fromkeys(place.text for one in programs for place in one.addresses("input")))
    allowed = programs[0], terms
    by_chance = (_timeline(number, scans, inputs, allowed) for number in range(count))
    explored = 0
    few = (lines * lasting << len(inputs)) <= MOST_LINE_SCANS
    for timeline in chain(_held(inputs, lasting, allowed) if few else (), by_chance):
        rows = [{**row, "ms": SCAN_MS} for row in timeline]
        scan = _parting(programs, rows, outputs, terms, lasting)
        seen = None if scan is None else replay(programs, rows[: scan + 1], outputs, terms)
        if seen:
            said: dict[str, Status] = {text: "different" if text in seen.wrong else "unknown" for text in outputs}
            return Verdict("different", None, seen.example, said, explored=explored + len(seen.example.inputs))
        explored += len(rows)
    return Verdict("unknown", outputs=nothing, explored=explored)


def _first_scan(program: Program) -> tuple[int, tuple[Diagnostic, ...]]:
    """Count the lines that the first scan executes, where loops or calls make them more, and say where it has no end."""
    if plan_of(program).straight and not any("call" in line.insn.does for line in program.lines):
        return len(program.lines), ()
    seen: list[Line] = []
    found: list[Diagnostic] = []
    sweep(program, Memory(), {}, BITS, lambda one: seen.append(one.line), found=found)
    return max(len(seen), len(program.lines)), tuple(one for one in dict.fromkeys(found) if one.code in _ENDLESS)


def _parting(
    programs: tuple[Program, Program], rows: list[Row], outputs: tuple[str, ...], terms: Terms, lasting: int
) -> int | None:
    """Give the scan from which on the two differ for so long; None where they never do."""
    traces = tuple(run(one, rows) for one in programs)
    held = 0
    for scan in range(len(rows)):
        held = held if lasting == 1 or rows[scan].keys() <= {"ms"} else 0
        held = held + 1 if any(_differs(traces, text, scan, terms) for text in outputs) else 0
        if held >= lasting:
            return scan + 1 - lasting
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


def runaway(program: Program) -> tuple[Diagnostic, ...]:
    """Say where a program that goes back or calls does so for ever in its first scan, or too deep."""
    return _first_scan(program)[1]


def _held(inputs: tuple[str, ...], scans: int, allowed: tuple[Program, Terms]) -> Iterator[Iterable[Row]]:
    """Give for each combination of inputs a timeline that holds it from power-on, those with few inputs on first."""
    for case in sorted(range(1 << len(inputs)), key=int.bit_count):
        row = {name: case >> bit & 1 for bit, name in enumerate(inputs)}
        if _may(*allowed, row) and not (allowed[1].single_change and case.bit_count() > 1):
            yield chain((row,), repeat({}, scans - 1))


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
