"""Scan after scan: the inputs are read into their image, every line is executed in order, the outputs are written.

A `Memory` is everything that lasts from one scan to the next; it is never changed, a scan gives the next one. After the first
scans of a long run a program becomes one generated function, as long as nothing happens that wants to be looked at line by line.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from plcteach.machine.recorder import Recorder, lapse
from plcteach.machine.store import PIN, Memory, owner
from plcteach.machine.sweep import address_of, normal, spread, sweep
from plcteach.machine.trace import SCAN_MS, Scan, Trace
from plcteach.machine.words import BITS, Domain

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.core.program import Program
    from plcteach.machine.signals import Column

__all__ = [
    "BITS",
    "SCAN_MS",
    "Domain",
    "Memory",
    "Scan",
    "Trace",
    "address_of",
    "normal",
    "run",
    "spread",
    "sweep",
    "warm",
]


def warm(program: Program, memory: Memory[Column]) -> Memory[Column]:
    """Give the memory with which a warm start begins: what is retentive stays, everything else is as at power-on."""
    dialect = program.dialect

    def stays(key: str) -> bool:
        whole = owner(dialect, key)
        ranges = dialect.retentive.get(whole.area, ()) if whole else ()
        return any(whole and first <= whole.index <= last for first, last in ranges)

    bits = {
        key: bit for key, bit in memory.bits.items() if stays(key) and PIN not in key and not key.endswith(".going")
    }
    words = {key: number for key, number in memory.words.items() if stays(key)}
    return Memory(bits=bits, words=words, warm=True)


def run(
    program: Program,
    scans: Iterable[Mapping[str, Any]] | Mapping[str, Any] | int = 1,
    *,
    scan_ms: int = SCAN_MS,
    memory: Memory[Column] | None = None,
) -> Trace:
    """Run a program, one scan for each mapping of inputs {address: value} (or the one mapping), or that many scans with all inputs 0.

    Inputs start at 0 and keep their value until they are named again; any other address is written once, when it is named.
    "ms" in a mapping is the time since the scan before; the first scan begins at 0. A runaway loop ends the run.
    UnknownNameError names an address that the family does not have.
    """
    recorder = Recorder(program, memory or Memory(), lapse(scan_ms))
    given = [scans] if isinstance(scans, Mapping) else scans
    rows: Iterable[Mapping[str, Any]] = ({} for _ in range(given)) if isinstance(given, int) else given
    for row in rows:
        recorder.scan(row)
        if recorder.ran_away:
            break
    return recorder.trace()
