"""Whether a gate can be on at all: by its whole truth table where it has few inputs, else by a decision diagram.

A truth table is one run over whole numbers with a place for each of 2^n cases. A decision diagram asks one input after another,
in the order in which the reference names them, and shares what is the same; it is kept below a number of nodes, so that a gate
that has no small diagram ends as "don't know" and not in a full memory.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.machine.rows import pattern

if TYPE_CHECKING:
    from collections.abc import Hashable, Mapping

    from plcteach.check.proof.budget import Budget
    from plcteach.machine.gates import Gate, Graph

MOST_ROWS = 20
FEW_ROWS = 12
MOST_NODES = 200_000

_WRITING, _ASKING = 100, 20
"""What writing a gate down for a table costs, and joining two nodes of a diagram, beside working one gate out."""

Model = dict["Hashable", int]
"""Inputs under which a gate is on; those that do not matter are not named."""


class TooLarge(Exception):  # noqa: N818 (no error: the answer is not known)
    """No small table or diagram says whether a gate can be on."""


def patterns(count: int) -> list[int]:
    """Give for each of some variables its values in all cases: case k gives variable v bit v of k."""
    return [pattern(number, 1 << count) for number in range(count)]


def model_of(
    graph: Graph, gate: Gate, *, rows: int = FEW_ROWS, nodes: int = MOST_NODES, budget: Budget | None = None
) -> Model | None:
    """Give inputs under which a gate is on, few of them 1; None where there are none, TooLarge where nobody knows."""
    if gate is graph.zero:
        return None
    names = graph.support([gate])
    if budget is not None and budget.spent:
        raise TooLarge
    if len(names) <= rows:
        if budget is not None:
            budget.spend(len(graph.cone([gate])) * (_WRITING + (1 << len(names) >> 9)))
        cases = graph.compiled([gate], names).call(patterns(len(names)), (1 << (1 << len(names))) - 1)[0]
        case = simplest(cases)
        return None if case < 0 else {name: case >> place & 1 for place, name in enumerate(names)}
    diagram = _Diagram(graph, {name: place for place, name in enumerate(names)}, nodes)
    try:
        return diagram.model(gate)
    finally:
        if budget is not None:
            budget.spend(_ASKING * len(diagram.made))


def simplest(cases: int) -> int:
    """Give the case with the fewest inputs on, the first of those; -1 where there is none."""
    size = max(cases.bit_length() - 1, 0).bit_length()
    return _least(cases, size, size)[1]


_NONE = (1 << 30, -1)
_SMALL = 6


def _least(cases: int, size: int, most: int) -> tuple[int, int]:
    """Give how many inputs are on in the simplest of some cases over so many inputs, and the case, where they are not too many.

    The cases with the last input off come first; those with it on need one more, so they are looked at only where that pays.
    """
    if not cases or most < 0:
        return _NONE
    if cases & 1:
        return 0, 0
    if size <= _SMALL:
        found = min((case.bit_count(), case) for case in range(1 << size) if cases >> case & 1)
        return found if found[0] <= most else _NONE
    half = 1 << size - 1
    best = _least(cases & (1 << half) - 1, size - 1, most)
    weight, case = _least(cases >> half, size - 1, min(most, best[0] - 1) - 1)
    return (weight + 1, case + half) if case >= 0 else best


def _simple(how: int, low: int, high: int) -> int | None:
    """Give the diagram of two where no question needs to be asked; None where one does."""
    if how == 1:
        return {0: 0, 1: high, high: high}.get(low)
    return 0 if low == high else high if low == 0 else None


class _Diagram:
    """A reduced ordered decision diagram; 0 and 1 are its ends, any other number a question with two ways on."""

    def __init__(self, graph: Graph, order: Mapping[Hashable, int], most: int) -> None:
        self.graph, self.order, self.most = graph, order, most
        self.nodes: list[tuple[int, int, int]] = [(len(order), 0, 0), (len(order), 1, 1)]
        self.known: dict[tuple[int, int, int], int] = {}
        self.made: dict[tuple[int, int, int], int] = {}

    def model(self, gate: Gate) -> Model | None:
        """Give inputs under which a gate is on, preferring 0; None where there are none."""
        values: dict[int, int] = {0: 0}
        for node in self.graph.cone([gate]):
            how, *parts = self.graph.nodes[node]
            if not how:
                values[node] = self.node(self.order[parts[0]], 0, 1)
                continue
            a, b = (self.opposite(values[part >> 1]) if part & 1 else values[part >> 1] for part in parts)
            values[node] = self.joined(how, a, b)
        end = values[gate.number >> 1]
        return self.way(self.opposite(end) if gate.number & 1 else end)

    def way(self, at: int) -> Model | None:
        """Follow a diagram to 1."""
        names, model = list(self.order), {}
        while at > 1:
            place, no, yes = self.nodes[at]
            model[names[place]] = int(no == 0)
            at = no or yes
        return model if at else None

    def node(self, place: int, no: int, yes: int) -> int:
        """Give the question about one variable; none where both ways are the same."""
        if no == yes:
            return no
        key = (place, no, yes)
        found = self.known.get(key)
        if found is None:
            if len(self.nodes) >= self.most:
                raise TooLarge
            found = self.known[key] = len(self.nodes)
            self.nodes.append(key)
        return found

    def opposite(self, at: int) -> int:
        """Give the diagram that answers the other way."""
        return self.joined(2, at, 1)

    def joined(self, how: int, a: int, b: int) -> int:
        """Give the diagram of two, both (1) or exactly one of them (2)."""
        simple = _simple(how, *sorted((a, b)))
        if simple is not None:
            return simple
        key = (how, a, b) if a < b else (how, b, a)
        found = self.made.get(key)
        if found is None:
            place = min(self.nodes[a][0], self.nodes[b][0])
            (a0, a1), (b0, b1) = self.ways(a, place), self.ways(b, place)
            found = self.made[key] = self.node(place, self.joined(how, a0, b0), self.joined(how, a1, b1))
            if len(self.made) > 4 * self.most:
                raise TooLarge
        return found

    def ways(self, at: int, place: int) -> tuple[int, int]:
        """Give where a diagram goes on for a variable that is 0, and that is 1."""
        mine, no, yes = self.nodes[at]
        return (no, yes) if mine == place else (at, at)
