"""Makes rungs of the objects of a PLCopen ladder body: what hangs on the same outputs is one net, and the nets make a tree.

Several wires at one input are parallel paths; a contact that two inputs read, each in other company, is a bridge. The output of a
box begins at the left rail anew, as a contact of the box's output bit.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple, NoReturn

from plcteach.core.ladder import MOST_NESTED, Box, Coil, Edge, Invert, Rung, branch, depth, rung, series
from plcteach.core.text import Text, same
from plcteach.ladder.markup import RefusedError, refuse
from plcteach.ladder.plcopen_flow import ON_RAIL, RAIL, Group, groups, numbered
from plcteach.ladder.plcopen_names import INPUTS, preset_of
from plcteach.ladder.plcopen_parts import flows, output, preset, source
from plcteach.ladder.reduce import reduced
from plcteach.ladder.wires import LEFT

if TYPE_CHECKING:
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.ladder import Node, Out
    from plcteach.ladder.plcopen_flow import Net
    from plcteach.ladder.plcopen_names import Names
    from plcteach.ladder.plcopen_parts import Part

_LEFTWARD, _RIGHTWARD = Text("左边", "on its left"), Text("右边", "on its right")


class Drawn(NamedTuple):
    """A rung, where its first output stands, its boxes, and the boxes whose outputs it reads over a wire."""

    place: tuple[float, float]
    rung: Rung
    boxes: frozenset[int]
    needs: frozenset[int]


class _Way(NamedTuple):
    """An object on the wire: its rank from above, its sign, the nets on its left and on its right."""

    part: Part
    rank: int
    node: Node
    left: Net
    right: Net


class _Hung(NamedTuple):
    """What hangs on a net: where the first of its outputs stands, itself, and its outputs in the order of execution."""

    place: tuple[float, float]
    out: Out
    ends: tuple[Part, ...]


def rungs(found: dict[int, Part], names: Names) -> tuple[list[Drawn], list[Diagnostic]]:
    """Give the rungs in the order of execution; whatever hangs together with something unread is left out, and is said."""
    drawn: list[Drawn] = []
    said: list[Diagnostic] = []
    for members in groups(found):
        problems = [one.problem for one in members if one.problem]
        said += problems
        if problems:
            continue
        try:
            drawn += _Tree(Group(found, members, names)).rungs()
        except RefusedError as refused:
            said.append(refused.found)
    return _in_order(drawn), said


def _in_order(drawn: list[Drawn]) -> list[Drawn]:
    """Put rungs in order from top to bottom, but each behind those whose boxes it reads over a wire."""
    waiting = sorted(drawn, key=lambda one: one.place)
    there = frozenset[int]().union(*(one.boxes for one in drawn))
    done: set[int] = set()
    ready: list[Drawn] = []
    while waiting:
        following = next((one for one in waiting if (one.needs & there) <= done), waiting[0])
        waiting.remove(following)
        done |= following.boxes
        ready.append(following)
    return ready


@dataclass(slots=True)
class _Tree:
    """The nets of a group as a tree, from the left rail to the coils and boxes.

    used: the objects on the wire that lead to some output.  paths: what leads on from each net.  hanging: the outputs on each net.
    """

    group: Group
    used: set[int] = field(default_factory=set)
    paths: dict[int, list[tuple[Node, int]]] = field(default_factory=dict)
    hanging: dict[int, list[Part]] = field(default_factory=dict)

    def rungs(self) -> list[Drawn]:
        """Reduce what leads to the outputs, and give a rung for each path from the left rail."""
        self.group.follow()
        outputs = [one for one in self.group.members if isinstance(one.symbol, Coil) or one.box]
        entries = {part.number: self.group.flow[part.number, self.entry(part)] for part in outputs}
        ways = self.ways([(part, entries[part.number]) for part in outputs])
        numbers = numbered([*entries.values(), *(way.right for way in ways)])
        for part in outputs:
            self.hanging.setdefault(numbers[entries[part.number]], []).append(part)
        self.tree(ways, numbers)
        found = [self.drawn(one) for one in self.outs(LEFT)]
        for part in self.group.members:
            if part.symbol and not isinstance(part.symbol, Coil) and part.number not in self.used:
                part.refuse("XML009", side=_RIGHTWARD)
        return found

    def entry(self, part: Part) -> str:
        """Give the input of an output that its stem leads to; something must lead there."""
        flow = self.group.flow
        if not part.box:
            if not flow[part.number, ""]:
                part.refuse("XML009", side=_LEFTWARD)
            return ""
        if flow.get((part.number, "EN"), ON_RAIL) != ON_RAIL:
            refuse("XML006", part.row, what=same(f"{part.kind}.EN"), id=part.number)
        name = next((one for one in flows(part) if flow[part.number, one]), "")
        if not name:
            part.refuse("XML014", missing=same(INPUTS[part.kind][0]))
        return name

    def ways(self, wanted: list[tuple[Part, Net]]) -> list[_Way]:
        """Give the objects on the wire that lead to some outputs; one that leads to two nets is a bridge."""
        ranks = {one.number: at for at, one in enumerate(self.group.members)}
        found: list[_Way] = []
        leads: dict[int, Net] = {}
        seen, waiting = {ON_RAIL}, [*wanted]
        while waiting:
            user, net = waiting.pop()
            if net in seen:
                continue
            seen.add(net)
            if RAIL in net:
                user.refuse("XML018", side=_LEFTWARD)
            for number, outlet in sorted(net):
                part = self.group.found[number]
                if part.symbol and leads.setdefault(number, net) != net:
                    part.refuse("XML011")
                node, left = self.lead(part, outlet)
                found.append(_Way(part, ranks[number], node, left, net))
                waiting.append((part, left))
        self.used |= {way.part.number for way in found}
        return found

    def lead(self, part: Part, outlet: str) -> tuple[Node, Net]:
        """Give the sign of an object on the wire, and what is on its left; a box or a variable begins at the rail anew."""
        if part.box:
            return output(part, outlet), ON_RAIL
        if part.symbol is None or isinstance(part.symbol, Coil):
            return source(part, self.group.names), ON_RAIL
        left = self.group.flow[part.number, ""]
        if not left:
            part.refuse("XML009", side=_LEFTWARD)
        return part.symbol, left

    def tree(self, ways: list[_Way], numbers: dict[Net, int]) -> None:
        """Join what is parallel and in series; each net that is left must be reached by one path, and none too deep."""
        paths = reduced([(way.rank, way.node, numbers[way.left], numbers[way.right]) for way in ways], {*self.hanging})
        entered = Counter(target for _, _, _, target in paths)
        crossed = [way for way in ways if entered[numbers[way.right]] > 1]
        if crossed:
            first = min((way.right for way in crossed), key=self.complete)
            inner = [way for way in crossed if way.right == first]
            min(inner, key=lambda way: (way.left == ON_RAIL, way.rank)).part.refuse("XML011")
        for _, node, net, target in sorted(paths, key=lambda path: path[0]):
            self.paths.setdefault(net, []).append((node, target))
        level, levels = [LEFT], 0
        while level:
            level = [target for net in level for _, target in self.paths.get(net, ())]
            levels += 1
            if levels > MOST_NESTED:
                self.too_deep()

    def complete(self, net: Net) -> int:
        """Say when all that leads to a net has been followed; the first crossing is the one that makes the others."""
        return max(self.group.turn.get(number, 0) for number, _ in net)

    def too_deep(self) -> NoReturn:
        """Say that a rung is nested too deeply."""
        what = Text("层嵌套（一级梯形图里）", "levels of nesting in one rung")
        refuse("XML002", self.group.members[0].row, what=what, most=MOST_NESTED)

    def outs(self, net: int) -> list[_Hung]:
        """Give what hangs on a net, from top to bottom by its uppermost coil or box."""
        found = [_Hung(part.place, self.output(part), (part,)) for part in self.hanging.get(net, ())]
        for node, target in self.paths.get(net, ()):
            inner = self.outs(target)
            ends = tuple(part for one in inner for part in one.ends)
            found.append(_Hung(inner[0].place, branch(node, *(one.out for one in inner)), ends))
        return sorted(found, key=lambda one: one.place)

    def output(self, part: Part) -> Out:
        """Give a coil, or a box with its further inputs."""
        if isinstance(part.symbol, Coil):
            return part.symbol
        entry = self.entry(part)
        others = [name for name in flows(part) if name != entry and self.group.flow[part.number, name]]
        pins = tuple((name, self.pin(part, name)) for name in others)
        text = f"{part.kind} {part.name}, {preset(part, self.group.found)}"
        box = Box(text, pins, entry if preset_of(part.kind) == "PV" else "")
        turned = self.turned(part, entry)
        return branch(series(*turned), box) if turned else box

    def turned(self, part: Part, name: str) -> list[Node]:
        """Give what an input does with the flow before it takes it."""
        inlet = part.inlets[name]
        edge: list[Node] = [Edge(rising=inlet.edge == "rise")] if inlet.edge else []
        return [Invert(), *edge] if inlet.negated else edge

    def pin(self, part: Part, name: str) -> Node:
        """Give what leads from the left rail to a further input of a box."""
        net = self.group.flow[part.number, name]
        if net == ON_RAIL:
            refuse("XML018", part.row, what=same(f"{part.kind}.{name}"), id=part.number, side=_LEFTWARD)
        ways = self.ways([(part, net)])
        numbers = numbered([net, *(way.right for way in ways)])
        paths = reduced([(way.rank, way.node, numbers[way.left], numbers[way.right]) for way in ways], {numbers[net]})
        if len(paths) > 1:
            refuse("XML011", part.row, what=same(f"{part.kind}.{name}"), id=part.number)
        return series(paths[0][1], *self.turned(part, name))

    def drawn(self, one: _Hung) -> Drawn:
        """Make a rung of what hangs on the left rail."""
        for part in one.ends[:-1]:
            if part.box and len([name for name in flows(part) if self.group.flow[part.number, name]]) > 1:
                part.refuse("XML015")
        made = rung(None, one.out)
        if depth(made) > MOST_NESTED:
            self.too_deep()
        boxes = frozenset(part.number for part in one.ends if part.box)
        above = frozenset[int]().union(*(self.group.above[part.number] for part in one.ends))
        return Drawn(one.place, made, boxes, above)
