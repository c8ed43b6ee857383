"""What a plant is, as frozen values: its devices, what moves, what can go wrong, its programs, a cycle, and its picture.

Nothing here moves: `plants.model` does that. Every position is in millionths of a unit, every speed in millionths a millisecond.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from plcteach.core.errors import UnknownNameError
from plcteach.core.text import NOTHING

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from plcteach.core.text import Text
    from plcteach.plants.condition import Bound, Condition

Wired = Literal["NO", "NC"]
Way = Literal["both", "up", "down"]
Role = Literal["hand", "sense", "drive"]

KINDS: dict[str, Role] = {
    "push-button": "hand",
    "switch": "hand",
    "limit-switch": "sense",
    "sensor": "sense",
    "lamp": "drive",
    "contactor": "drive",
    "solenoid": "drive",
}
"""Each kind of device, and who moves it: a hand, the plant, or the PLC."""

SHAPES: dict[str, tuple[frozenset[str], frozenset[str]]] = {
    kind: (frozenset(needed.split()), frozenset(others.split()))
    for kind, needed, others in (
        ("button", "for", "stop label"),
        ("lever", "for", "label"),
        ("limit-switch", "for", "side label"),
        ("sensor", "for", "beam label"),
        ("lamp", "for", "radius glow letter label"),
        ("contactor", "for", "up down label"),
        ("valve", "for", "label"),
        ("motor", "", "radius label"),
        ("belt", "length", "height"),
        ("box", "width height", "ink radius shown"),
        ("disc", "radius", "ink shown"),
        ("line", "points", "ink arrow shown"),
        ("words", "text", "ink size anchor bold shown"),
        ("value", "text of", "size anchor"),
        ("item", "of by", "look"),
    )
}
"""What a picture is made of: each kind of thing, what must be said of it and what may be; every thing has a place too."""


@dataclass(frozen=True, slots=True)
class Device:
    """One row of the I/O list. Without an address it is a hand at the plant that no PLC sees.

    wired: a normally closed contact gives 1 at rest.  way: a one-way limit switch acts only while its part travels up or down.
    start: a switch that is on from the beginning.  on: where the plant itself actuates it.
    """

    symbol: str
    address: str
    kind: str
    what: Text
    wired: Wired = "NO"
    way: Way = "both"
    start: bool = False
    on: Condition | None = None

    @property
    def role(self) -> Role:
        """Who moves it: a hand, the plant ("sense"), or the PLC ("drive")."""
        return KINDS[self.kind]

    @property
    def momentary(self) -> bool:
        """Whether it springs back when it is let go."""
        return self.kind == "push-button"

    @property
    def along(self) -> str:
        """The one part whose position actuates it, "" if there are several or none."""
        things = {bound.name for bound in self.on.bounds} if self.on else set()
        return things.pop() if len(things) == 1 else ""


@dataclass(frozen=True, slots=True)
class Move:
    """How fast something goes while a condition holds, in millionths of its unit a millisecond."""

    when: Condition
    speed: int


@dataclass(frozen=True, slots=True)
class Part:
    """Something with a position between two ends; it stops there, or begins again if it goes round.

    moves: the first that holds counts.  home: while it holds, the part is back where it began.
    notch, by: each time `notch` begins to hold, the position jumps by so much (a counting wheel).
    """

    name: str
    unit: str
    least: int
    most: int
    start: int
    moves: tuple[Move, ...] = ()
    round: bool = False
    home: Condition | None = None
    notch: Condition | None = None
    by: int = 0


@dataclass(frozen=True, slots=True)
class Stop:
    """A place that workpieces do not pass unless a condition holds."""

    at: int
    unless: Condition


@dataclass(frozen=True, slots=True)
class Item:
    """A kind of workpiece: where it appears and disappears, how it travels, where it waits, how far apart they keep."""

    name: str
    start: int
    most: int
    moves: tuple[Move, ...] = ()
    stops: tuple[Stop, ...] = ()
    gap: int = 0


@dataclass(frozen=True, slots=True)
class Birth:
    """Each time `on` begins to hold (and `only` holds too) a workpiece appears, of the kinds named, one after the other."""

    on: Condition
    items: tuple[str, ...]
    only: Condition


@dataclass(frozen=True, slots=True)
class Change:
    """While a condition holds, workpieces of a kind at a place become workpieces of another kind ("": disappear)."""

    item: str
    where: Bound
    when: Condition
    into: str


@dataclass(frozen=True, slots=True)
class Latch:
    """A bit of the plant's own that stays: reset wins."""

    name: str
    set: Condition
    reset: Condition


@dataclass(frozen=True, slots=True)
class Hazard:
    """What must never hold (for so many ms without a break), and the sentence that reports it."""

    id: str
    when: Condition
    lasts_ms: int
    says: Text


@dataclass(frozen=True, slots=True)
class Drawn:
    """One thing in the picture: its kind, where it stands, the device it shows, and what moves, turns or lights it.

    moves: for a part's name the px to the right and down for each unit.  turns: for a part's name the degrees.
    more: whatever else its kind needs.
    """

    kind: str
    part: str
    x: float
    y: float
    symbol: str
    on: Condition | None
    moves: Mapping[str, tuple[float, float]]
    turns: Mapping[str, float]
    text: Text
    more: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Act:
    """At a moment a hand presses something, or lets it go."""

    ms: int
    symbol: str
    down: bool


@dataclass(frozen=True, slots=True)
class Seen:
    """At a moment something must hold."""

    ms: int
    what: Condition


@dataclass(frozen=True, slots=True)
class Cycle:
    """What the operator does and what is to be seen, again and again."""

    every_ms: int
    times: int
    acts: tuple[Act, ...]
    seen: tuple[Seen, ...] = ()

    @property
    def ms(self) -> int:
        """How long all of it takes."""
        return self.every_ms * self.times

    def all_acts(self) -> Iterator[Act]:
        """Give what is done in all rounds, in order."""
        for turn in range(self.times):
            yield from (replace(act, ms=act.ms + turn * self.every_ms) for act in self.acts)

    def all_seen(self) -> Iterator[Seen]:
        """Give what is to be seen in all rounds, in order."""
        for turn in range(self.times):
            yield from (replace(seen, ms=seen.ms + turn * self.every_ms) for seen in self.seen)


@dataclass(frozen=True, slots=True)
class Sample:
    """A program for the plant. `fault`: the hazard that it runs into ("" for one that runs into none).

    role: "reference" (the one shown), "right", "book" or "wrong".  addresses, wired, ways: what is connected otherwise for it.
    """

    role: str
    family: str
    text: str
    title: Text
    because: Text = NOTHING
    fault: str = ""
    addresses: Mapping[str, str] | None = None
    wired: Mapping[str, Wired] | None = None
    ways: Mapping[str, Way] | None = None
    cycle: Cycle | None = None


@dataclass(frozen=True)
class Plant:
    """The thing that is driven."""

    id: str
    title: Text
    story: Text
    family: str
    devices: tuple[Device, ...]
    parts: tuple[Part, ...]
    items: tuple[Item, ...]
    births: tuple[Birth, ...]
    changes: tuple[Change, ...]
    latches: tuple[Latch, ...]
    hazards: tuple[Hazard, ...]
    samples: tuple[Sample, ...]
    cycle: Cycle
    size: tuple[float, float]
    drawn: tuple[Drawn, ...]
    order: int = 0

    def __repr__(self) -> str:
        return f"Plant({self.id!r}, {self.title.en!r})"

    @cached_property
    def reference(self) -> Sample:
        """The program that drives it as it should."""
        return next(one for one in self.samples if one.role == "reference")

    @property
    def inputs(self) -> tuple[Device, ...]:
        """The devices that a PLC reads."""
        return tuple(one for one in self.devices if one.role != "drive" and one.address)

    @property
    def outputs(self) -> tuple[Device, ...]:
        """The devices that a PLC drives."""
        return tuple(one for one in self.devices if one.role == "drive")

    @property
    def hands(self) -> tuple[Device, ...]:
        """Everything that a hand can press or turn."""
        return tuple(one for one in self.devices if one.role == "hand")

    def part(self, name: str) -> Part:
        """Give a part by its name."""
        return self._parts[name]

    @cached_property
    def _parts(self) -> dict[str, Part]:
        return {one.name: one for one in self.parts}

    @cached_property
    def conditions(self) -> tuple[Condition, ...]:
        """Everything on which the motion or a report of this plant depends."""
        movable: tuple[Part | Item, ...] = (*self.parts, *self.items)
        moves = [move.when for one in movable for move in one.moves]
        parts = [each for one in self.parts for each in (one.home, one.notch) if each]
        stops = [stop.unless for one in self.items for stop in one.stops]
        births = [each for one in self.births for each in (one.on, one.only)]
        latches = [each for one in self.latches for each in (one.set, one.reset)]
        rest = [*(one.when for one in self.changes), *(one.when for one in self.hazards)]
        return (*moves, *parts, *stops, *births, *latches, *rest, *(one.on for one in self.devices if one.on))

    @cached_property
    def bounds(self) -> tuple[Bound, ...]:
        """Every stretch of positions that counts for something."""
        inside = [bound for condition in self.conditions for bound in condition.bounds]
        return (*inside, *(one.where for one in self.changes))

    def device(self, symbol: str) -> Device:
        """Give a device by its symbol; UnknownNameError suggests the nearest."""
        for one in self.devices:
            if one.symbol == symbol:
                return one
        kind = "device"
        raise UnknownNameError(kind, symbol, (one.symbol for one in self.devices))

    def for_(self, sample: Sample) -> Plant:
        """Give the plant connected as a program expects it: other addresses, other contacts, one-way switches."""
        addresses, wired, ways = sample.addresses or {}, sample.wired or {}, sample.ways or {}
        devices = tuple(
            replace(
                one,
                address=addresses.get(one.symbol, one.address),
                wired=wired.get(one.symbol, one.wired),
                way=ways.get(one.symbol, one.way),
            )
            for one in self.devices
        )
        return replace(self, devices=devices, family=sample.family, cycle=sample.cycle or self.cycle)
