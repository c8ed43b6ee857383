"""A difference that was found among gates, done again by the plain machine, so that what is shown is what it does.

The gates know of time only that a tick passes or none, and of the clocks nothing at all. Here each scan gets the ms that make it
so; where no ms do, the difference was none that can happen.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plcteach.check.proof.circuit import TICK
from plcteach.check.proof.terms import condition
from plcteach.core.verdict import Counterexample
from plcteach.machine.scan import address_of, run
from plcteach.machine.world import beat

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from plcteach.check.proof.product import Product
    from plcteach.check.proof.walk import Scan
    from plcteach.core.exercise import Terms
    from plcteach.core.program import Program
    from plcteach.machine.scan import Trace

Row = dict[str, int]
MOST_SCANS, MOST_WRITTEN = 70_000, 6_000
"""Longer ones are not done again; nor are these, where bits of memory are written from outside, which is slow."""
_STEP_MS, _LONGEST_MS = 10, 60_000


@dataclass(frozen=True, slots=True)
class Replay:
    """A counterexample that the plain machine has confirmed, and which outputs differ in its last scan."""

    example: Counterexample
    wrong: tuple[str, ...]


def rows_of(product: Product, scans: Sequence[Scan]) -> list[Row] | None:
    """Give scans as the machine takes them, each with its ms.

    None where no time makes the clocks what they should be, or where they are too many.
    """
    free = free_bits(product)
    if free and len(scans) > MOST_WRITTEN:
        return None
    dialect = product.circuits[0].program.dialect
    clocks, ticking = product.clocks, TICK in product.inputs
    rows, now = [], 0
    for number, scan in enumerate(scans):
        row = _inputs(scan)
        wanted = {clock: scan["clock", clock] for clock in clocks}
        dt = product.unit * scan[TICK] if ticking else 0
        if number and clocks:
            found = next(
                (
                    ms
                    for ms in ((dt,) if ticking else range(0, _LONGEST_MS + 1, _STEP_MS))
                    if all(beat(dialect.specials[key], number, now + ms) == value for key, value in wanted.items())
                ),
                None,
            )
            if found is None:
                return None
            dt = found
        if ticking or clocks:
            now += dt if number else 0
            row["ms"] = dt if number else 0
        rows.append(row)
    _once(rows, free)
    return rows


def free_bits(product: Product) -> set[str]:
    """Give the bits of memory that are inputs of the task because nobody writes them."""
    dialect = product.circuits[0].program.dialect
    names = [name[1] for name in product.inputs if isinstance(name, tuple) and name[0] == "in"]
    return {text for text in names if dialect.area(address_of(dialect, text)).role != "input"}


def _once(rows: list[Row], free: set[str]) -> None:
    """Name a bit of memory only where it changes: it stays as it is, and the machine is quicker where nobody writes to it."""
    held: Row = {}
    for row in rows:
        for key in free & row.keys():
            if held.get(key) == row[key]:
                del row[key]
            else:
                held[key] = row[key]


def _inputs(scan: Scan) -> Row:
    """Give the inputs of one scan by address; the bits of a word are put together, the highest being its sign."""
    row: Row = {}
    signs: dict[str, int] = {}
    for name, value in scan.items():
        if isinstance(name, tuple) and name[0] == "in":
            place = name[2] if len(name) > 2 else 0  # noqa: PLR2004
            row[name[1]] = row.get(name[1], 0) | value << place
            signs[name[1]] = max(signs.get(name[1], 0), place)
    return {
        key: value - (2 << signs[key]) if signs[key] and value >> signs[key] else value for key, value in row.items()
    }


def replay(
    programs: tuple[Program, Program], rows: Sequence[Mapping[str, Any]], outputs: Sequence[str], terms: Terms
) -> Replay | None:
    """Run both programs on some inputs; None where nothing differs at the end."""
    if not rows or len(rows) > MOST_SCANS:
        return None
    traces = [run(one, rows) for one in programs]
    plain = [text for text in outputs if text not in terms.never]
    expected, got = (
        tuple({text: repr(trace.value(text, scan)) for text in plain} for scan in range(len(rows))) for trace in traces
    )
    for text in terms.never:
        for scan in range(len(rows)):
            expected[scan][text] = "0"
            got[scan][text] = holds(traces[1], text, scan)
    last = len(rows) - 1
    spared = {text for text, formula in terms.dont_care.items() if holds(traces[0], formula, last) == "1"}
    wrong = tuple(
        text
        for text in outputs
        if text not in spared and (expected[last][text] != got[last][text] or got[last][text] == "x")
    )
    if not wrong:
        return None
    scans = tuple({key: int(value) for key, value in row.items()} for row in rows)
    return Replay(Counterexample(scans, expected, got, last, wrong[0]), wrong)


def holds(trace: Trace, formula: str, scan: int) -> str:
    """Give what a formula is after a scan."""
    dialect = trace.program.dialect
    found = condition(formula, dialect).worked(lambda place: trace.value(address_of(dialect, place.text).text, scan))
    return repr(found)
