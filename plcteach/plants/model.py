"""A plant in motion: what its switches feel, where everything is after so many milliseconds, and what has gone wrong.

Time goes in whole milliseconds and positions in whole millionths of a unit, so that the same outputs give the same motion
however the time is cut into scans. What holds at one millisecond decides what is the case at the next. Where nothing can change
for a while (no part reaches a place that some condition names) the model leaps over that while at once.
"""

from __future__ import annotations

from copy import deepcopy
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.core.errors import PlcTeachError, UnknownNameError
from plcteach.plants.travel import Travel

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.text import Text
    from plcteach.plants.condition import Condition
    from plcteach.plants.plant import Hazard, Plant, Way, Wired


@dataclass(frozen=True, slots=True)
class Fault:
    """What went wrong, when, and the sentence that says so."""

    id: str
    ms: int
    says: Text

    def __repr__(self) -> str:
        return f"Fault({self.id} at {self.ms} ms)"


@dataclass(slots=True)
class Moment:
    """All that a plant remembers: kept as one value, so that a run can be taken back to a moment.

    spots: where each part is, and each workpiece of a kind.  heading: the way a part last went, 1 up, -1 down.
    known: for everything that happens when a condition *begins* to hold, whether it held a millisecond ago.
    since: from when on each hazard has held.  turn: which workpiece of its row each birth gives next.
    """

    ms: int = 0
    bits: dict[str, bool] = field(default_factory=dict)
    spots: dict[str, list[int]] = field(default_factory=dict)
    heading: dict[str, int] = field(default_factory=dict)
    known: dict[str, bool] = field(default_factory=dict)
    since: dict[str, int] = field(default_factory=dict)
    turn: list[int] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)


class Model:
    """One plant, running."""

    def __init__(self, plant: Plant) -> None:
        """Begin at rest, connected as the plant says."""
        self.plant = plant
        self.wires: dict[str, Wired] = {one.symbol: one.wired for one in plant.devices}
        self.ways: dict[str, Way] = {one.symbol: one.way for one in plant.devices}
        self._drives = [(one.symbol, one.address) for one in plant.outputs]
        self._feels = [(one.symbol, one.along, one.on.test) for one in plant.devices if one.on]
        self._travel = Travel(plant)
        self._now = Moment()
        self.reset()

    def __repr__(self) -> str:
        return f"Model({self.plant.id!r} at {self._now.ms} ms, {len(self._now.faults)} faults)"

    def reset(self) -> None:
        """Put everything back to where it began; the wiring stays as it was chosen."""
        plant = self.plant
        bits = {one.symbol: one.start for one in plant.devices} | {one.name: False for one in plant.latches}
        spots = {one.name: [one.start] for one in plant.parts} | {one.name: [] for one in plant.items}
        self._now = Moment(bits=bits, spots=spots, turn=[0] * len(plant.births))
        self._now.heading = {one.name: 0 for one in plant.parts}
        self._feel()

    @property
    def ms(self) -> int:
        """How long the plant has been running."""
        return self._now.ms

    @property
    def bits(self) -> dict[str, bool]:
        """What is actuated, energised or latched, by its name."""
        return self._now.bits

    @property
    def spots(self) -> dict[str, list[int]]:
        """Where each part is, and each workpiece of a kind, in millionths."""
        return self._now.spots

    @property
    def faults(self) -> tuple[Fault, ...]:
        """What has gone wrong so far, each once, in order."""
        return tuple(self._now.faults)

    def position(self, part: str) -> float:
        """Give where a part is, in its unit."""
        return self._now.spots[part][0] / 1_000_000

    def holds(self, condition: Condition) -> bool:
        """Say whether a condition holds now."""
        return condition.test(self)

    def moment(self) -> Moment:
        """Give a copy of all that the plant remembers."""
        return deepcopy(self._now)

    def back_to(self, moment: Moment) -> None:
        """Take the plant back to a moment."""
        self._now = deepcopy(moment)

    # what a hand does

    def press(self, symbol: str, down: bool = True) -> None:  # noqa: FBT001, FBT002 - a finger is down or up
        """Press a button or turn a switch on, or let it go; PlcTeachError for what no hand can press."""
        device = self.plant.device(symbol)
        if device.role != "hand":
            msg = f"{symbol} is a {device.kind}: the plant moves it, and no hand"
            raise PlcTeachError(msg)
        self._now.bits[symbol] = bool(down)

    def wire(self, symbol: str, wired: Wired) -> None:
        """Connect an input to its normally open or normally closed contact."""
        device = self.plant.device(symbol)
        if device.role == "drive" or not device.address or wired not in {"NO", "NC"}:
            msg = f"an input is wired NO or NC; {symbol} cannot be wired {wired!r}"
            raise PlcTeachError(msg)
        self.wires[symbol] = wired

    def way(self, symbol: str, way: Way) -> None:
        """Fit a limit switch that acts both ways, or only while its part travels up, or down."""
        if not self.plant.device(symbol).along or way not in {"both", "up", "down"}:
            msg = f"a limit switch acts both ways, up or down; {symbol} cannot be fitted {way!r}"
            raise PlcTeachError(msg)
        self.ways[symbol] = way
        self._feel()

    # what the PLC sees and does

    def sense(self) -> dict[str, int]:
        """Give every input as it stands at the PLC's terminals: 0 or 1 by its address."""
        bits, wires = self._now.bits, self.wires
        return {one.address: int(bits[one.symbol] != (wires[one.symbol] == "NC")) for one in self.plant.inputs}

    def step(self, outputs: Mapping[str, int], ms: int) -> None:
        """Let so many milliseconds pass with these outputs (by address; one that is not named is 0)."""
        if not isinstance(ms, int) or ms < 0:
            msg = f"time passes in whole ms, 0 or more, and not {ms!r}"
            raise PlcTeachError(msg)
        for symbol, address in self._drives:
            self._now.bits[symbol] = bool(outputs.get(address, 0))
        end = self._now.ms + ms
        while self._now.ms < end:
            alarm = self._watch(end)
            self._travel.go(self._now, alarm - self._now.ms)
            self._feel()

    def _feel(self) -> None:
        """Set the bits of all switches that the plant actuates."""
        now = self._now
        for symbol, along, test in self._feels:
            way = self.ways[symbol]
            agrees = way == "both" or now.heading[along] == (1 if way == "up" else -1)
            now.bits[symbol] = agrees and test(now)

    def _watch(self, end: int) -> int:
        """Report the hazards that have held long enough, and give the moment at which the next may be due."""
        now = self._now
        for one in self.plant.hazards:
            if not one.when.test(now):
                now.since.pop(one.id, None)
                continue
            due = now.since.setdefault(one.id, now.ms) + one.lasts_ms
            if due > now.ms:
                end = min(end, due)
            else:
                self._report(one)
        return end

    def _report(self, hazard: Hazard) -> None:
        if all(fault.id != hazard.id for fault in self._now.faults):
            self._now.faults.append(Fault(hazard.id, self._now.ms, hazard.says))


def fault_of(model: Model, name: str) -> Fault:
    """Give a fault that has happened, by its name; UnknownNameError where it has not."""
    for fault in model.faults:
        if fault.id == name:
            return fault
    kind = "fault so far"
    raise UnknownNameError(kind, name, (fault.id for fault in model.faults))
