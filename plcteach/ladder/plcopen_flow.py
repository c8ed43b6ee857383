"""Follows the wires of a PLCopen ladder body: which objects hang together, in which order, and where each input's flow comes from.

A wire leads from an input to an output on its left. A coil lets the flow on its left pass to its right; the output of a box, and
a variable at the left, give a flow of their own.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.ladder.markup import refuse
from plcteach.ladder.plcopen_names import INPUTS
from plcteach.ladder.plcopen_parts import always, output

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.ladder.plcopen_names import Names
    from plcteach.ladder.plcopen_parts import Part, Wire

Source = tuple[int, str]
"""An output: the number of its object, and its name."""
Net = frozenset[Source]
"""All that one input hangs on."""
RAIL: Source = (-1, "")
ON_RAIL: Net = frozenset({RAIL})


def wires(part: Part) -> list[Wire]:
    """Give the wires of all inputs of an object."""
    return [wire for inlet in part.inlets.values() for wire in inlet.wires]


def groups(found: dict[int, Part]) -> list[list[Part]]:
    """Give the objects that hang together, power rails apart, each group from top to bottom."""
    root = {number: number for number in found}

    def of(number: int) -> int:
        while root[number] != number:
            root[number] = root[root[number]]
            number = root[number]
        return number

    for part in found.values():
        for wire in wires(part):
            other = found.get(wire.target)
            if other and "PowerRail" not in part.tag + other.tag:
                root[of(part.number)] = of(other.number)
    together: dict[int, list[Part]] = {}
    for part in sorted(found.values(), key=lambda one: one.place):
        if part.tag != "leftPowerRail":
            together.setdefault(of(part.number), []).append(part)
    return list(together.values())


@dataclass(slots=True)
class Group:
    """Objects that hang together.

    flow: for each input (object, name) all that it hangs on.  above: for each object the boxes whose outputs reach it over wires.
    turn: the place of each object in an order in which it stands behind all that it hangs on.
    """

    found: dict[int, Part]
    members: list[Part]
    names: Names
    flow: dict[Source, Net] = field(default_factory=dict)
    above: dict[int, frozenset[int]] = field(default_factory=dict)
    turn: dict[int, int] = field(default_factory=dict)

    def follow(self) -> None:
        """Follow every wire to the left."""
        for at, part in enumerate(self._ordered()):
            self.turn[part.number] = at
            above: set[int] = set()
            for name, inlet in part.inlets.items():
                nets = (self._behind(wire) for wire in inlet.wires if takes_flow(part, name))
                self.flow[part.number, name] = frozenset().union(*nets)
                for wire in inlet.wires:
                    above |= self.above.get(wire.target, frozenset())
                    above |= {wire.target} if self.found[wire.target].box else set()
            self.above[part.number] = frozenset(above)

    def _ordered(self) -> list[Part]:
        """Give the objects so that each stands behind all that it hangs on; a circle and a wire to nothing are refused."""
        waiting = {one.number: 0 for one in self.members}
        after: dict[int, list[Part]] = {}
        for part in self.members:
            for wire in wires(part):
                if wire.target not in self.found:
                    target = wire.target if wire.target >= 0 else "?"
                    refuse("XML007", wire.row, what=part.what, id=part.number, target=target)
                if wire.target in waiting:
                    waiting[part.number] += 1
                    after.setdefault(wire.target, []).append(part)
        ready = [one for one in self.members if not waiting[one.number]]
        for part in ready:
            for following in after.get(part.number, ()):
                waiting[following.number] -= 1
                if not waiting[following.number]:
                    ready.append(following)
        if len(ready) < len(self.members):
            self._in_circle({number for number, count in waiting.items() if count}).refuse("XML010")
        return ready

    def _in_circle(self, left: set[int]) -> Part:
        """Give an object of a circle: from any that is left over, always on to the left."""
        seen: dict[int, int] = {}
        number = min(left)
        while number not in seen:
            seen[number] = len(seen)
            number = next(wire.target for wire in wires(self.found[number]) if wire.target in left)
        return self.found[min(one for one, at in seen.items() if at >= seen[number])]

    def _behind(self, wire: Wire) -> Net:
        """Give where the flow comes from that a wire brings."""
        other = self.found[wire.target]
        own: Net = frozenset({(other.number, wire.output if other.box else "")})
        if other.tag == "block" and wire.output == "ENO":
            return self.flow.get((other.number, "EN"), ON_RAIL)
        if other.box:
            output(other, wire.output)
        match other.tag:
            case "leftPowerRail":
                return ON_RAIL
            case "coil":
                return self.flow[other.number, ""]
            case "inVariable":
                constant = always(other)
                return own if constant is None else ON_RAIL if constant else frozenset()
            case "contact" | "block":
                return own
        return other.refuse("XML006")


def takes_flow(part: Part, name: str) -> bool:
    """Say whether an input is one for the flow, and not for a number, or the right rail, which takes whatever comes."""
    if part.tag == "rightPowerRail" or (part.tag == "outVariable" and not part.symbol):
        return False
    return not part.box or name in {*INPUTS[part.kind], "EN"}


def numbered(nets: Iterable[Net]) -> dict[Net, int]:
    """Give each net a number, the left rail's being 0."""
    return {net: at for at, net in enumerate(dict.fromkeys((ON_RAIL, *nets)))}
