"""How a plant gets from one millisecond to a later one: who moves how far, and what begins, changes or disappears on the way."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.plants.declared import Part

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.plants.condition import Condition
    from plcteach.plants.declared import Birth, Change, Item, Move, Plant
    from plcteach.plants.moment import Moment

MOST_ITEMS = 200
"""So many workpieces of a kind there can be; more do not appear."""

_FAR = 1 << 62


@dataclass(frozen=True, slots=True)
class _Ride:
    """How the workpieces of one kind travel just now, and the places that they do not pass."""

    item: Item
    speed: int
    closed: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class _Plan:
    """What the next milliseconds bring, all of it seen before anything has moved."""

    speeds: dict[str, int]
    rides: tuple[_Ride, ...]
    latches: dict[str, bool]
    home: tuple[Part, ...]
    caught: tuple[tuple[Change, int], ...]
    begun: tuple[Part | Birth, ...]
    sudden: bool


_Watched = tuple[str, "Condition", "Part | Birth"]


class Travel:
    """The motion of one plant, of which it knows beforehand every position at which some condition may change."""

    def __init__(self, plant: Plant) -> None:
        self.plant = plant
        movable: tuple[Part | Item, ...] = (*plant.parts, *plant.items)
        found: dict[str, set[int]] = {one.name: set() for one in movable}
        for bound in plant.bounds:
            found[bound.name].update(bound.edges)
        for part in plant.parts:
            if part.round:
                found[part.name].update((part.least, part.most))
        for item in plant.items:
            found[item.name].add(item.most)
        self.edges = {name: sorted(edges) for name, edges in found.items()}
        watched: list[_Watched] = [(f"birth {number}", one.on, one) for number, one in enumerate(plant.births)]
        self.watched = [*watched, *((f"notch {one.name}", one.notch, one) for one in plant.parts if one.notch)]

    def go(self, now: Moment, most: int) -> None:
        """Let time pass until the outcome of some condition may be another, 1 ms at least and `most` at most.

        Whatever happens suddenly (a latch, a workpiece that appears) happens within the 1 ms that follows its cause.
        """
        plan = self._plan(now)
        ms = 1 if plan.sudden else max(1, min(most, self._quiet(now, plan)))
        for part in self.plant.parts:
            _move(part, plan.speeds[part.name] * ms, now)
        new = _taken(now, plan.caught)
        for ride in plan.rides:
            now.spots[ride.item.name] = _ridden(ride, now.spots[ride.item.name], ms)
        for part in plan.home:
            now.spots[part.name][0] = part.start
        for name in new:
            self._appear(name, now)
        for one in plan.begun:
            self._begin(one, now)
        now.bits.update(plan.latches)
        now.ms += ms

    def _plan(self, now: Moment) -> _Plan:
        plant, spots = self.plant, now.spots
        speeds = {one.name: _free(one, now) for one in plant.parts}
        latches = {
            one.name: (now.bits[one.name] or one.set.test(now)) and not one.reset.test(now) for one in plant.latches
        }
        latches = {name: bit for name, bit in latches.items() if bit != now.bits[name]}
        home = tuple(one for one in plant.parts if one.home and spots[one.name][0] != one.start and one.home.test(now))
        caught = tuple((one, place) for one in plant.changes for place in _caught(one, now))
        begun, other = self._beginnings(now)
        turned = any(speed and now.heading[name] != (1 if speed > 0 else -1) for name, speed in speeds.items())
        rides = tuple(
            _Ride(one, _speed(one.moves, now), tuple(stop.at for stop in one.stops if not stop.unless.test(now)))
            for one in plant.items
            if spots[one.name]
        )
        return _Plan(speeds, rides, latches, home, caught, begun, bool(latches or home or caught or other or turned))

    def _beginnings(self, now: Moment) -> tuple[tuple[Part | Birth, ...], bool]:
        """Give what begins just now, and whether any of these conditions is other than it was; take note of all of them."""
        begun: list[Part | Birth] = []
        other = False
        for key, condition, one in self.watched:
            holds, held = condition.test(now), now.known.get(key, False)
            if holds and not held and (isinstance(one, Part) or one.only.test(now)):
                begun.append(one)
            other |= holds != held
            now.known[key] = holds
        return tuple(begun), other

    def _quiet(self, now: Moment, plan: _Plan) -> int:
        """Give the ms until the first thing reaches a position that counts."""
        ways = [_until(self.edges[name], now.spots[name][0], speed) for name, speed in plan.speeds.items() if speed]
        arrivals = [self._arrival(ride, now.spots[ride.item.name]) for ride in plan.rides if ride.speed]
        return min((*ways, *arrivals), default=_FAR)

    def _arrival(self, ride: _Ride, spots: Sequence[int]) -> int:
        """Give the ms until a workpiece that is free to go reaches a position that counts."""
        soonest, last = _FAR, None
        for spot in spots:
            if spot in ride.closed or (last is not None and ride.item.gap and spot + ride.item.gap >= last):
                last = spot
                continue
            soonest, last = min(soonest, _until(self.edges[ride.item.name], spot, ride.speed)), None
        return soonest

    def _begin(self, one: Part | Birth, now: Moment) -> None:
        """Let a workpiece appear, or a counting wheel jump."""
        if isinstance(one, Part):
            spot = now.spots[one.name][0] + one.by
            now.spots[one.name][0] = min(max(spot, one.least), one.most)
            return
        number = self.plant.births.index(one)
        self._appear(one.items[now.turn[number] % len(one.items)], now)
        now.turn[number] += 1

    def _appear(self, name: str, now: Moment) -> None:
        item = next((one for one in self.plant.items if one.name == name), None)
        if item is None:
            return
        spots = now.spots[name]
        crowded = item.gap and spots and spots[-1] < item.start + item.gap
        if not crowded and len(spots) < MOST_ITEMS:
            spots.append(item.start)


def _speed(moves: Sequence[Move], now: Moment) -> int:
    """Give the speed of the first motion whose condition holds."""
    for move in moves:
        if move.when.test(now):
            return move.speed
    return 0


def _free(part: Part, now: Moment) -> int:
    """Give how fast a part can go: 0 where it stands at its stop and is driven against it."""
    speed, spot = _speed(part.moves, now), now.spots[part.name][0]
    held = not part.round and (spot >= part.most if speed > 0 else spot <= part.least)
    return 0 if held else speed


def _move(part: Part, way: int, now: Moment) -> None:
    if not way:
        return
    spot = now.spots[part.name][0] + way
    if part.round:
        spot = part.least + (spot - part.least) % (part.most - part.least)
    now.spots[part.name][0] = min(max(spot, part.least), part.most)
    now.heading[part.name] = 1 if way > 0 else -1


def _ridden(ride: _Ride, spots: Sequence[int], ms: int) -> list[int]:
    """Give where the workpieces are afterwards, the foremost first: each stops at closed places and behind the one before it."""
    after: list[int] = []
    for spot in spots:
        reach = [spot + ride.speed * ms, *(at for at in ride.closed if spot <= at)]
        if after and ride.item.gap:
            reach.append(after[-1] - ride.item.gap)
        after.append(max(spot, min(reach)))
    return [spot for spot in after if spot < ride.item.most]


def _caught(change: Change, now: Moment) -> list[int]:
    """Give the numbers of the workpieces that a change takes hold of."""
    if not now.spots[change.item] or not change.when.test(now):
        return []
    return [place for place, spot in enumerate(now.spots[change.item]) if change.where.holds([spot])]


def _taken(now: Moment, caught: Sequence[tuple[Change, int]]) -> list[str]:
    """Take away the workpieces that changes have caught, each by the first, and give the kinds that they become."""
    becomes: dict[tuple[str, int], str] = {}
    for change, place in caught:
        becomes.setdefault((change.item, place), change.into)
    for name in {name for name, _ in becomes}:
        now.spots[name] = [spot for place, spot in enumerate(now.spots[name]) if (name, place) not in becomes]
    return list(becomes.values())


def _until(edges: Sequence[int], spot: int, speed: int) -> int:
    """Give the ms until something that moves has come to the next of these positions, or has gone below the last."""
    place = bisect_right(edges, spot)
    if speed > 0:
        return -((spot - edges[place]) // speed) if place < len(edges) else _FAR
    return -((edges[place - 1] - spot - 1) // -speed) if place else _FAR
