"""A program that runs while somebody watches: scan after scan on demand, with what is pressed, and with the plant that it drives.

Nothing runs by itself: whoever watches asks for so many scans. Time is virtual, and what has run can be looked at again, as far
back as is kept. What the inputs did is kept from power-on, as it is little: it can be replayed, scan for scan, and taken over.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from plcteach.machine.recorder import Recorder
from plcteach.machine.recording import Difference, course, joined, recorded
from plcteach.machine.store import Memory, Store
from plcteach.machine.trace import APART, SCAN_MS, Scan, Trace
from plcteach.machine.words import BITS

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.program import Program
    from plcteach.machine.recording import Edges
    from plcteach.machine.signals import Column
    from plcteach.machine.timeline import Timeline

APART_MOMENTS = 10
"""The plant is remembered after every so many scans."""

KEPT_MS = 600_000
"""So much of the past is kept, in virtual time."""

MOST_CHANGES = 50_000
"""So many changes of inputs and outputs are kept from before that; a longer recording loses its beginning."""


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

    def follow(self, row: Mapping[str, int]) -> None:
        """Hold its buttons as a recording says: by @ and a symbol, or by the address of an input."""
        ...


class Live:
    """A run under way, with its switches.

    held: what the switches are set to, by address.  scans: how many have run in all.  forgotten: how many of them are not kept
    any more.  touched: what a hand did at the plant where no input sees it.  tape: the recording that runs now, if one does.
    differs: where outputs are not what they were in it, each address once.
    """

    def __init__(
        self, program: Program, plant: Driven | None = None, *, scan_ms: int = SCAN_MS, kept_ms: int = KEPT_MS
    ) -> None:
        self.program, self.plant, self.scan_ms = program, plant, scan_ms
        self.most = max(2 * APART, kept_ms // max(1, scan_ms))
        self.outputs = tuple(one.text for one in program.addresses("output"))
        self.held: dict[str, int] = {}
        self.tape: Timeline | None = None
        self.reset()

    def reset(self, memory: Memory[Column] | None = None) -> None:
        """Start again, cold or with a memory; the switches stay as they are, the plant goes back to its beginning."""
        self.origin = memory or Memory()
        self.recorder = Recorder(self.program, self.origin, self.scan_ms)
        self.forgotten = 0
        self.past: dict[str, Edges] = {}
        self.touched: dict[str, Edges] = {}
        self.tape = None
        self.whole = True
        self.differs: list[Difference] = []
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

    def touch(self, symbol: str, value: int, before: int) -> None:
        """Note what a hand does at the plant where no input sees it."""
        self.touched.setdefault(symbol, [(0, before)]).append((self.next_ms, value))

    @property
    def next_ms(self) -> int:
        """The virtual time at which the next scan starts."""
        return self.now + self.scan_ms if self.scans else 0

    # a recording

    def recording(self) -> Timeline:
        """Give what has been done since power-on, by hand or by a tape, and what the outputs were."""
        stop = self.now + self.scan_ms
        hands = tuple(one for name, edges in self.by_hand().items() if (one := course(f"@{name}", edges, stop)))
        return recorded(self.trace(), self.past, hands, self.plant.sense() if self.plant else ())

    def replay(self, line: Timeline, memory: Memory[Column] | None = None) -> None:
        """Start again, with a recording in the place of hands until it is over or taken over.

        Of the plant's inputs those that it names are as it says; the plant itself gives the others.
        """
        self.held = {}
        self.reset(memory)
        self.tape = line

    @property
    def over(self) -> bool:
        """Say whether the recording that runs is at its end."""
        return self.tape is not None and self.next_ms > self.tape.until_ms

    def take_over(self) -> None:
        """Go on by hand from here: inputs that no plant moves stay as the recording left them."""
        if self.tape is None:
            return
        senses = self.plant.sense() if self.plant else {}
        self.held = {one: value for one, value in self.row().items() if value and one not in senses}
        self.touched = self.by_hand()
        self.tape = None

    def by_hand(self) -> dict[str, Edges]:
        """Give what has been done so far at the plant where no input sees it."""
        if self.tape is None:
            return self.touched
        done = {one.address[1:]: [(phase.start_ms, phase.value) for phase in one.phases] for one in self.tape.hands}
        return {name: [edge for edge in edges if edge[0] < self.next_ms] for name, edges in done.items()}

    def compare(self) -> None:
        """Hold the outputs of the last scan against the recording."""
        line = self.tape
        for one in line.seen if line else ():
            if one.tells(self.now) and all(known.address != one.address for known in self.differs):
                _, values = self.recorder.changes.get(one.address, ((), ()))
                expected, got = str(one.at(self.now)), repr(values[-1]) if values else "0"
                if expected != got:
                    self.differs.append(Difference(one.address, self.scans - 1, self.now, expected, got))

    def row(self) -> dict[str, Any]:
        """Give the inputs of the next scan: all that anybody sets."""
        free = {one.text: 0 for one in self.program.addresses("input")}
        hand = self.tape.at(self.next_ms) if self.tape else self.held
        return free | dict(self.plant.sense() if self.plant else {}) | hand

    def forced(self) -> list[str]:
        """Give the inputs that are set by hand against what the plant says."""
        senses = self.plant.sense() if self.plant else {}
        return [address for address in self.held if address in senses]

    def run(self, scans: int) -> None:
        """Run so many scans; the last is kept line by line, as it is looked at first. A recording stops at its end."""
        if self.tape:
            scans = min(scans, (self.tape.until_ms - self.next_ms) // self.scan_ms + 1)
        for number in range(scans):
            self.scan(watched=number == scans - 1)

    def scan(self, *, watched: bool = True) -> None:
        """Run one scan, and let the plant move until the next."""
        if self.tape and self.plant:
            self.plant.follow(self.tape.by_hand(self.next_ms))
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
        if self.tape:
            self.compare()
        if number + 1 > self.most + self.most // 4:
            self.forget(number + 1 - self.most)

    def forget(self, number: int) -> None:
        """Forget what is older than wanted, but for what the inputs and outputs did."""
        trace = self.trace()
        for one in (*self.program.addresses("input"), *self.program.addresses("output")):
            self.past[one.text] = joined(self.past.get(one.text, []), trace.edges(one.text))
        if sum(map(len, self.past.values())) > MOST_CHANGES:
            self.past, self.whole = {}, False
        self.forgotten += self.recorder.forget(number)
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
        """Give what the inputs did and what the outputs were as a timeline that can be typed: run it, and the same happens."""
        return self.recording().text
