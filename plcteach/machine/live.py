"""A program that runs while somebody watches: scan after scan on demand, with what is pressed, and with the plant that it drives.

Nothing runs by itself: whoever watches asks for so many scans. Time is virtual, and what has run can be looked at again, as far
back as is kept.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from plcteach.machine.recorder import Recorder
from plcteach.machine.store import Memory, Store
from plcteach.machine.trace import APART, SCAN_MS, Scan, Trace
from plcteach.machine.words import BITS

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.program import Program
    from plcteach.machine.signals import Column

APART_MOMENTS = 10
"""The plant is remembered after every so many scans."""

KEPT_MS = 600_000
"""So much of the past is kept, in virtual time."""


class Driven(Protocol):
    """What a program drives: it gives the inputs, and moves with the outputs."""

    def sense(self) -> Mapping[str, int]:
        """Give the inputs that it sets."""
        ...

    def step(self, outputs: Mapping[str, int], ms: int) -> None:
        """Let so much time pass with these outputs."""
        ...

    def reset(self) -> None:
        """Go back to how it was at the beginning."""
        ...

    def moment(self) -> Any:
        """Give a copy of all that it remembers."""
        ...


class Live:
    """A run under way, with its switches.

    held: what the switches are set to, by address.  scans: how many have run in all.  forgotten: how many of them are not kept
    any more.
    """

    def __init__(
        self, program: Program, plant: Driven | None = None, *, scan_ms: int = SCAN_MS, kept_ms: int = KEPT_MS
    ) -> None:
        self.program, self.plant, self.scan_ms = program, plant, scan_ms
        self.most = max(2 * APART, kept_ms // max(1, scan_ms))
        self.outputs = tuple(one.text for one in program.addresses("output"))
        self.held: dict[str, int] = {}
        self.pressed: list[tuple[int, str, int]] = []
        self.reset()

    def reset(self, memory: Memory[Column] | None = None) -> None:
        """Start again, cold or with a memory; the switches stay as they are, the plant goes back to its beginning."""
        self.recorder = Recorder(self.program, memory or Memory(), self.scan_ms)
        self.forgotten = 0
        self.moments: dict[int, Any] = {}
        self.last: Scan[Column] | None = None
        if self.plant:
            self.plant.reset()

    @property
    def scans(self) -> int:
        """How many scans have run."""
        return self.forgotten + len(self.recorder.starts)

    @property
    def now(self) -> int:
        """The virtual time of the last scan's start in ms."""
        return self.recorder.starts[-1] if self.recorder.starts else 0

    def press(self, address: str, value: int) -> None:
        """Set an input for the scans to come; what is set by hand goes before what the plant says."""
        self.held[address] = value

    def release(self, address: str) -> None:
        """Leave an input to the plant again, or at 0."""
        self.held.pop(address, None)

    def row(self) -> dict[str, Any]:
        """Give the inputs of the next scan: all that anybody sets."""
        free = {one.text: 0 for one in self.program.addresses("input")}
        return free | dict(self.plant.sense() if self.plant else {}) | self.held

    def forced(self) -> list[str]:
        """Give the inputs that are set by hand against what the plant says."""
        senses = self.plant.sense() if self.plant else {}
        return [address for address in self.held if address in senses]

    def run(self, scans: int) -> None:
        """Run so many scans; the last is kept line by line, as it is looked at first."""
        for number in range(scans):
            self.scan(watched=number == scans - 1)

    def scan(self, *, watched: bool = True) -> None:
        """Run one scan, and let the plant move until the next."""
        row, before = self.row(), self.recorder.memory()
        self.recorder.scan(row)
        after = self.recorder.memory()
        if self.plant:
            store = Store(self.program, after, BITS)
            self.plant.step({one: int(repr(store.bits.get(one)) == "1") for one in self.outputs}, self.scan_ms)
            if not self.scans % APART_MOMENTS:
                self.moments[self.scans] = self.plant.moment()
        number = len(self.recorder.starts) - 1
        starts = self.recorder.starts
        ms = starts[number] - starts[number - 1] if number else self.recorder.first_ms
        self.last = (
            Scan(self.program, BITS, number, starts[number], self.recorder.inputs[number], before, ms)
            if watched
            else None
        )
        if number + 1 > self.most + self.most // 4:
            self.forgotten += self.recorder.forget(number + 1 - self.most)
            self.moments = {scan: moment for scan, moment in self.moments.items() if scan >= self.forgotten}

    def at(self, scan: int) -> Scan[Column]:
        """Give a scan by its number, or the nearest that is kept."""
        number = max(0, min(scan - self.forgotten, len(self.recorder.starts) - 1))
        if self.last and scan >= self.scans - 1:
            return self.last
        return self.trace().scans[number]

    def plant_at(self, scan: int) -> Any:
        """Give how the plant was after a scan, or shortly before; None for now."""
        if scan >= self.scans - 1:
            return None
        return self.moments.get((scan + 1) // APART_MOMENTS * APART_MOMENTS)

    def trace(self) -> Trace:
        """Give what has run, as far back as it is kept."""
        return self.recorder.trace()

    def timeline(self) -> str:
        """Give what the inputs did as a timeline that can be typed: run it, and the same happens again."""
        return written(self.trace())


def written(trace: Trace) -> str:
    """Write the inputs of a run as a timeline, a row an input, lengths in ms."""
    rows = []
    end = trace.starts[-1] if trace.starts else 0
    for place in trace.program.addresses("input"):
        edges = trace.edges(place.text)
        phases = []
        for at, (ms, value) in enumerate(edges):
            until = edges[at + 1][0] if at + 1 < len(edges) else end + trace.scan_ms
            phases.append(f"{until - ms}ms {'on' if repr(value) == '1' else 'off'}")
        if any(repr(value) == "1" for _, value in edges):
            rows.append(f"{place.text}: {', '.join(phases)}")
    return "\n".join(rows)
