"""A program as a circuit: what flows are gates of one graph, in which the same gate is never made twice.

A scan that is run over gates leaves, for each output and each thing remembered, the gate that works it out from the inputs and
from what was remembered before. Gates are AND and XOR; OR is an AND of opposites, and the opposite of a gate is the same node,
seen with the other sign. Because everything is simplified as it is made, two programs that say the same thing in the same way
end in the very same gate, and nothing is left to prove. Where a bit may be x, a `Blurred` has a second gate that says where.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plcteach.machine.words import Domain, Vector

if TYPE_CHECKING:
    from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence


class Unprovable(Exception):  # noqa: N818 (no error: what is asked for has no formula over bits)
    """A program does something that no circuit of reasonable size does (divides, loops, has no end)."""


MOST_GATES = 50_000


class Gate:
    """One gate, or its opposite; made by a `Graph` only, and the same one is the same object."""

    __slots__ = ("graph", "number")

    def __init__(self, graph: Graph, number: int) -> None:
        self.graph = graph
        self.number = number

    def __repr__(self) -> str:
        return f"Gate({self.number})" if self.number > 1 else str(self.number)

    def __and__(self, other: Gate) -> Gate:
        if type(other) is not Gate:
            return NotImplemented
        return self.graph.both(self.number, other.number)

    def __or__(self, other: Gate) -> Gate:
        if type(other) is not Gate:
            return NotImplemented
        graph = self.graph
        return graph.gates[graph.both(self.number ^ 1, other.number ^ 1).number ^ 1]

    def __xor__(self, other: Gate) -> Gate:
        if type(other) is not Gate:
            return NotImplemented
        return self.graph.unlike(self.number, other.number)

    def __invert__(self) -> Gate:
        return self.graph.gates[self.number ^ 1]

    def edge(self, previous: Any, *, rising: bool) -> Any:
        """Give the edge since `previous`, no edge the first time."""
        if previous is None:
            return self.graph.zero
        return self & ~previous if rising else ~self & previous

    @property
    def unknown(self) -> Gate:
        """Where the bit is x: nowhere."""
        return self.graph.zero

    @property
    def surely(self) -> Gate:
        """Where the bit is 1 and not x."""
        return self


@dataclass(frozen=True, slots=True)
class Blurred:
    """A bit that is x where `unknown` is on; elsewhere it is `surely`, which is off where the bit is x."""

    surely: Gate
    unknown: Gate

    def __and__(self, other: Bit) -> Bit:
        may1 = (self.surely | self.unknown) & (other.surely | other.unknown)
        return _bit(self.surely & other.surely, may1)

    def __or__(self, other: Bit) -> Bit:
        may1 = self.surely | self.unknown | other.surely | other.unknown
        return _bit(self.surely | other.surely, may1)

    def __xor__(self, other: Bit) -> Bit:
        blur = self.unknown | other.unknown
        return _bit((self.surely ^ other.surely) & ~blur, (self.surely ^ other.surely) | blur)

    __rand__, __ror__, __rxor__ = __and__, __or__, __xor__

    def __invert__(self) -> Bit:
        return Blurred(~(self.surely | self.unknown), self.unknown)

    def edge(self, previous: Any, *, rising: bool) -> Any:
        """Give the edge since `previous`, no edge the first time."""
        if previous is None:
            return self.surely.graph.zero
        return self & ~previous if rising else ~self & previous


Bit = Gate | Blurred


def _bit(surely: Gate, may1: Gate) -> Bit:
    """Give the bit that is 1 for sure in some cases, and may be 1 in those and others."""
    blur = may1 & ~surely
    return surely if blur.number == 0 else Blurred(surely, blur)


def differs(one: Bit, other: Bit) -> Gate:
    """Give the cases in which two bits are not the same, x counting as a value of its own."""
    return (one.surely ^ other.surely) | (one.unknown ^ other.unknown)


class Graph:
    """The gates made so far; gates 0 and 1 are the constants, and gate 2k + 1 is the opposite of gate 2k.

    nodes: for each pair of gates how it is made: (0, name) a variable, (1, a, b) AND, (2, a, b) XOR.
    """

    def __init__(self) -> None:
        self.gates: list[Gate] = [Gate(self, 0), Gate(self, 1)]
        self.nodes: list[tuple[Any, ...]] = [(0, None)]
        self.known: dict[tuple[int, int, int], Gate] = {}
        self.variables: dict[Hashable, Gate] = {}
        self.domain = CircuitDomain(self.zero, self.one, Blurred(self.zero, self.one))

    @property
    def zero(self) -> Gate:
        """The gate that is never on."""
        return self.gates[0]

    @property
    def one(self) -> Gate:
        """The gate that is always on."""
        return self.gates[1]

    def variable(self, name: Hashable) -> Gate:
        """Give the variable of a name."""
        found = self.variables.get(name)
        if found is None:
            found = self.variables[name] = self._new((0, name))
        return found

    def _new(self, node: tuple[Any, ...]) -> Gate:
        if len(self.nodes) >= MOST_GATES:
            raise Unprovable
        self.nodes.append(node)
        self.gates += [Gate(self, len(self.gates)), Gate(self, len(self.gates) + 1)]
        return self.gates[-2]

    def both(self, a: int, b: int) -> Gate:
        """Give the gate that is on where two are."""
        if a > b:
            a, b = b, a
        if a == 0 or a == b ^ 1:
            return self.gates[0]
        if a in (1, b):
            return self.gates[b]
        key = (1, a, b)
        found = self.known.get(key)
        if found is None:
            found = self.known[key] = self._shorter(a, b) or self._new(key)
        return found

    def _shorter(self, a: int, b: int) -> Gate | None:
        """Give an AND with a gate that already is one, where it says nothing new, or the opposite of it."""
        for x, y in ((a, b), (b, a)):
            node = self.nodes[y >> 1]
            if node[0] != 1:
                continue
            _, left, right = node
            if not y & 1:
                if x in (left, right):
                    return self.gates[y]
                if x ^ 1 in (left, right):
                    return self.gates[0]
            elif x == left:
                return self.both(x, right ^ 1)
            elif x == right:
                return self.both(x, left ^ 1)
            elif x ^ 1 in (left, right):
                return self.gates[x]
        return None

    def unlike(self, a: int, b: int) -> Gate:
        """Give the gate that is on where exactly one of two is."""
        sign, a, b = (a ^ b) & 1, a & ~1, b & ~1
        if a > b:
            a, b = b, a
        if a == b:
            return self.gates[sign]
        if a == 0:
            return self.gates[b ^ sign]
        key = (2, a, b)
        found = self.known.get(key)
        if found is None:
            found = self.known[key] = self._new(key)
        return self.gates[found.number ^ sign]

    def any(self, gates: Iterable[Gate]) -> Gate:
        """Give the gate that is on where any of some is."""
        union = self.zero
        for one in gates:
            union |= one
        return union

    def cone(self, gates: Iterable[Gate]) -> list[int]:
        """Give the nodes that some gates are made of, each after those it is made of."""
        seen: set[int] = set()
        waiting = [one.number >> 1 for one in gates]
        while waiting:
            node = waiting.pop()
            if node in seen or node == 0:
                continue
            seen.add(node)
            if self.nodes[node][0]:
                _, a, b = self.nodes[node]
                waiting += (a >> 1, b >> 1)
        return sorted(seen)

    def support(self, gates: Iterable[Gate]) -> list[Hashable]:
        """Give the names of the variables that some gates depend on, in the order in which they were made."""
        return [self.nodes[node][1] for node in self.cone(gates) if not self.nodes[node][0]]

    def rewritten(self, gates: Sequence[Gate], by: Mapping[Hashable, Gate]) -> list[Gate]:
        """Give gates with some variables replaced."""
        new: dict[int, int] = {0: 0}
        for node in self.cone(gates):
            how, *parts = self.nodes[node]
            if not how:
                new[node] = by[parts[0]].number if parts[0] in by else 2 * node
                continue
            a, b = (new[part >> 1] ^ part & 1 for part in parts)
            new[node] = (self.both(a, b) if how == 1 else self.unlike(a, b)).number
        return [self.gates[new[one.number >> 1] ^ one.number & 1] for one in gates]

    def compiled(self, gates: Sequence[Gate], names: Sequence[Hashable]) -> Compiled:
        """Write gates down as a function of the variables named (all that they depend on)."""
        places = {name: place for place, name in enumerate(names)}
        rows = ["def circuit(values, every):"]
        cone = self.cone(gates)
        for node in cone:
            how, *parts = self.nodes[node]
            if how:
                a, b = map(_spelled, parts)
                rows.append(f"    t{node} = {a} {'&' if how == 1 else '^'} {b}")
            else:
                rows.append(f"    t{node} = values[{places[parts[0]]}]")
        rows.append(f"    return ({''.join(_spelled(one.number) + ',' for one in gates)})")
        space: dict[str, Any] = {}
        exec(compile("\n".join(rows), "<circuit>", "exec"), space)  # noqa: S102 (numbers and operators only, nothing typed)
        return Compiled(space["circuit"], len(cone) + 1)


def _spelled(number: int) -> str:
    if number < 2:  # noqa: PLR2004 (the constants)
        return "every" if number else "0"
    return f"(t{number >> 1} ^ every)" if number & 1 else f"t{number >> 1}"


class Compiled:
    """Gates as a function: of the variables' values, each a row of cases in one whole number, and of all cases."""

    __slots__ = ("call", "cost")

    def __init__(self, call: Callable[[Sequence[int], int], tuple[int, ...]], cost: int) -> None:
        self.call = call
        self.cost = cost


class CircuitDomain(Domain[Any]):
    """Gates: no case can be looked at, so that what needs to be looked at has no circuit."""

    __slots__ = ()

    def pick(self, condition: Any, this: Any, other: Any) -> Any:
        """Give `this` where the condition is 1, else `other`: two numbers, or two signals."""
        if this is other or condition is self.one:
            return this
        if condition is self.zero:
            return other
        if isinstance(this, Vector):
            size = max(len(this.signs), len(other.signs))
            return Vector(tuple(self.pick(condition, this.at(at), other.at(at)) for at in range(size)), self.zero)
        if type(condition) is type(this) is type(other) is Gate:
            return other ^ (condition & (this ^ other))
        return super().pick(condition, this, other)

    def apply(self, rule: Callable[..., int | None], *words: Any) -> Any:
        """Refuse: a rule over whole numbers is no formula over bits."""
        del rule, words
        raise Unprovable

    def certain(self, signal: Any) -> bool | None:
        """Say whether a signal is 1 (True) or 0 (False) in every case; None where it is not settled."""
        return True if signal is self.one else False if signal is self.zero else None
