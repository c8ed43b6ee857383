"""A plant in motion: what its switches feel, where everything is after so many milliseconds, and what has gone wrong.

Time goes in whole milliseconds and positions in whole millionths of a unit, so that the same outputs give the same motion
however the time is cut into scans. What holds at one millisecond decides what is the case at the next. Where nothing can change
for a while (no part reaches a place that some condition names) the model leaps over that while at once.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.errors import PlcTeachError
from plcteach.plants.condition import MICRO
from plcteach.plants.moment import Fault, Moment
from plcteach.plants.travel import Travel

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.plants.condition import Condition
    from plcteach.plants.declared import Hazard, Plant, Way, Wired


class Model:
    """One plant, running."""

    def __init__(self, plant: Plant) -> None:
        """Begin at rest, connected as the plant says."""
        self.plant = plant
        self.wires: dict[str, Wired] = {one.symbol: one.wired for one in plant.devices}
        self.ways: dict[str, Way] = {one.symbol: one.way for one in plant.devices}
        self._drives = [(one.symbol, one.address) for one in plant.outputs]
        self._senses = [(one.symbol, one.address) for one in plant.inputs]
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
        return self._now.spots[part][0] / MICRO

    def holds(self, condition: Condition) -> bool:
        """Say whether a condition holds now."""
        return condition.test(self._now)

    def moment(self) -> Moment:
        """Give a copy of all that the plant remembers."""
        return self._now.copy()

    def back_to(self, moment: Moment) -> None:
        """Take the plant back to a moment."""
        self._now = moment.copy()

    # what a hand does

    def press(self, symbol: str, down: int = 1) -> None:
        """Press a button or turn a switch on (1), or let it go (0); PlcTeachError for what no hand can press."""
        device = self.plant.device(symbol)
        if device.role != "hand":
            msg = f"{symbol} is a {device.kind}: the plant moves it, and no hand"
            raise PlcTeachError(msg)
        self._now.bits[symbol] = bool(down)

    def follow(self, row: Mapping[str, int]) -> None:
        """Hold the buttons as a recording says: by @ and the symbol, or by the address of the input that sees one."""
        for one in self.plant.hands:
            if f"@{one.symbol}" in row:
                self._now.bits[one.symbol] = bool(row[f"@{one.symbol}"])
            elif one.address and one.address in row:
                self._now.bits[one.symbol] = bool(row[one.address]) != (self.wires[one.symbol] == "NC")

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
        return {address: int(bits[symbol] != (wires[symbol] == "NC")) for symbol, address in self._senses}

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
