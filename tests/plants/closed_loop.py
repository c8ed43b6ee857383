"""A plant driven by a program: switches to inputs, a scan, outputs to the plant, 10 ms, and again."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from plcteach.core.diagnostic import errors
from plcteach.machine.recorder import Recorder
from plcteach.machine.store import Memory
from plcteach.plants import Model, Plant, Sample
from plcteach.stl import read

SCAN = 10


def program_of(plant: Plant, text: str, family: str):
    program = read(text, family)
    assert not errors(program.diagnostics), (plant.id, program.diagnostics)
    return program


class Loop:
    """Scans until somebody asks what is to be seen."""

    def __init__(self, plant: Plant, text: str, *, family: str = "", scan: int = SCAN) -> None:
        self.model = Model(plant)
        self.recorder = Recorder(program_of(plant, text, family or plant.family), Memory(), scan)
        self.scan = scan
        self.addresses = [one.address for one in plant.outputs]
        self.outputs: dict[str, int] = {}
        self.log: list[tuple[int, dict[str, int]]] = []

    def once(self) -> None:
        self.recorder.scan(self.model.sense())
        changes, last = self.recorder.changes, {}
        for address in self.addresses:
            if address in changes:
                last[address] = int(repr(changes[address][1][-1]))
        if last != self.outputs:
            self.log.append((self.model.ms, last))
        self.outputs = last
        self.model.step(last, self.scan)

    def until(self, ms: int) -> None:
        while self.model.ms < ms:
            self.once()

    def play(self, acts: Iterable, ms: int, see: Callable[[int], None] = lambda _: None) -> Model:
        """Run for so long; do what is to be done when its time has come."""
        waiting = list(acts)
        while self.model.ms < ms:
            while waiting and waiting[0].ms <= self.model.ms:
                act = waiting.pop(0)
                self.model.press(act.symbol, act.down)
            see(self.model.ms)
            self.once()
        return self.model

    def times(self, address: str) -> list[tuple[int, int]]:
        """When an output changed, and to what."""
        found, value = [], 0
        for ms, outputs in self.log:
            if outputs.get(address, 0) != value:
                value = outputs.get(address, 0)
                found.append((ms, value))
        return found


def sample_loop(plant: Plant, sample: Sample, scan: int = SCAN) -> Loop:
    return Loop(plant.for_(sample), sample.text, scan=scan)


def played(plant: Plant, sample: Sample, scan: int = SCAN) -> tuple[Loop, list[str]]:
    """Play a sample's cycle; give the loop and what was not to be seen."""
    loop = sample_loop(plant, sample, scan)
    cycle = loop.model.plant.cycle
    waiting, unseen = list(cycle.all_seen()), []

    def see(now: int) -> None:
        while waiting and waiting[0].ms <= now:
            one = waiting.pop(0)
            if not loop.model.holds(one.what):
                unseen.append(f"{one.ms} ms: {one.what.text}")

    loop.play(cycle.all_acts(), cycle.ms, see)
    return loop, unseen
