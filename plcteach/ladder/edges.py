"""Writes the edges and pulse coils of one family in the ways that another has: on the wire, as a contact, or by a bit of memory.

An edge that a family keeps for itself shows nothing in the first scan; one that keeps its last flow in a bit (off at first) does
if it rises. So the first scan is shut out, or let in, by the bit of that name. A family without edges on the wire gets the
flow beside the bit that keeps it: `flow -> (/m -> …), m`.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.ladder import (
    Box,
    Branch,
    Coil,
    Contact,
    Edge,
    Invert,
    Parallel,
    Rung,
    Series,
    branch,
    in_series,
    parallel,
    rung,
    series,
    symbols_of,
)
from plcteach.ladder.instructions import coil_word, contact_word, edge_word
from plcteach.ladder.places import none

if TYPE_CHECKING:
    from plcteach.core.ladder import Node, Out
    from plcteach.core.spec import Dialect
    from plcteach.ladder.places import Places


class Edges:
    """Rungs whose addresses are the target's already, and whose edges become the target's too.

    kept: the memory bits that nothing but one edge uses, so that they may go.  sampled: the source takes edges of memory
    bits at the start of the scan.  top: rungs that must stand before all others.
    """

    def __init__(self, places: Places, kept: frozenset[str]) -> None:
        self.places, self.kept = places, kept
        self.target: Dialect = places.target
        self.source: Dialect = places.source
        self.top: list[Rung] = []
        self.before: list[Rung] = []
        on_wire = edge_word(self.target, rising=True)
        self.own = on_wire is not None and not on_wire.operands
        self.by_bit = on_wire is not None and bool(on_wire.operands)

    def rungs(self, one: Rung) -> list[Rung]:
        """Give a rung, and before it those that prepare its edges."""
        outer, self.before = self.before, []
        stem = None if one.stem is None else self.contacts(one.stem)
        outs = tuple(self.pulses(out) for out in one.outs)
        if stem is None:
            made = [rung(None, *(found for out in outs for found in self.out(out)), title=one.title)]
        else:
            some = self.hung(branch(stem, *outs), at_rail=True)
            if len(some) == 1 and isinstance(some[0], Branch):
                made = [rung(some[0].stem, *some[0].outs, title=one.title)]
            else:
                made = [rung(out.stem, *out.outs, title=one.title) for out in some if isinstance(out, Branch)]
        before, self.before = self.before, outer
        return [*before, *made]

    def first_scan(self, *, shut: bool) -> Contact:
        """Give the contact that is open (closed) in the first scan only."""
        word, inverse = self.places.known("first")
        return Contact(word, negated=inverse != shut)

    # contacts with an edge of their own, and pulse coils

    def contacts(self, node: Node) -> Node:
        """Give a node with its edge contacts as the target has them."""
        match node:
            case Series(parts):
                return series(*map(self.contacts, parts))
            case Parallel(parts):
                return parallel(*map(self.contacts, parts))
            case Contact(_, _, edge) if edge:
                return self.contact(node)
        return node

    def contact(self, one: Contact) -> Contact:
        """Give an edge contact, or a contact of the bit that is on where the edge is."""
        place = self.target.address(one.address)
        row = contact_word(self.target, "load", one)
        apart = self.own if row is None else True
        fits = row is None or (
            isinstance(place, Address) and place.area in self.target.kinds[row.operands[0].kind].areas
        )
        is_input = isinstance(place, Address) and self.target.area(place).role == "input"
        alike = is_input or self.source.samples_edges_at_start == self.target.samples_edges_at_start
        if apart and fits and alike:
            return one
        bit = self.places.fresh()
        plain = Contact(one.address)
        if self.source.samples_edges_at_start and not is_input and row and fits:
            made = [rung(one, Coil(bit))]
        else:
            made = self.rungs(Rung(series(plain, Edge(one.edge == "rise")), (Coil(bit),)))
        (self.top if self.source.samples_edges_at_start and not is_input else self.before).extend(made)
        return Contact(bit)

    def pulses(self, out: Out) -> Out:
        """Give an output with its pulse coils as edges where the target has none such."""
        match out:
            case Branch(stem, outs):
                return Branch(self.contacts(stem), tuple(map(self.pulses, outs)))
            case Box(_, pins) if pins:
                return replace(out, pins=tuple((name, self.pin(node)) for name, node in pins))
            case Coil(address, kind, _, _) if kind in {"rise", "fall"}:
                row, place = coil_word(self.target, kind), self.target.address(address)
                area = place.area if isinstance(place, Address) else ""
                if row and area in self.target.kinds[row.operands[0].kind].areas:
                    return out
                return Branch(Edge(kind == "rise"), (replace(out, kind=""),))
        return out

    def pin(self, node: Node) -> Node:
        """Give a further input of a box; one that acts on the whole flow there gets a bit of its own before the rung."""
        node = self.contacts(node)
        if not _edged(node):
            return node
        bit = self.places.fresh()
        self.before += self.rungs(Rung(node, (Coil(bit),)))
        return Contact(bit)

    # edges on the wire

    def out(self, out: Out) -> list[Out]:
        """Give what one output becomes at its node."""
        return self.hung(out, at_rail=False) if isinstance(out, Branch) else [out]

    def hung(self, path: Branch, *, at_rail: bool) -> list[Out]:
        """Give what an output path becomes where it hangs; `at_rail`: it is a whole rung and hangs on the rail."""
        parts: list[Node] = [*in_series(path.stem)]
        at = 0
        while at < len(parts):
            part, rest = parts[at], tuple(parts[at + 1 :])
            if isinstance(part, Edge):
                done = self.native(part, rest)
                if done is None:
                    return self.stored(tuple(parts[:at]), part, Branch(series(*rest), path.outs))
                parts[at:] = done
            elif isinstance(part, Parallel) and _edged(part):
                inside = self.inside(part)
                if inside is None:
                    return self.parted(tuple(parts[:at]), part, Branch(series(*rest), path.outs), at_rail=at_rail)
                parts[at] = inside
            at += 1
        return [Branch(series(*parts), tuple(found for out in path.outs for found in self.out(out)))]

    def native(self, edge: Edge, rest: tuple[Node, ...]) -> tuple[Node, ...] | None:
        """Give an edge and what follows it as the target has it; None where the target has no edge that does the same."""
        if self.own:
            if not edge.memory:
                return (edge, *rest)
            shut = bool(rest) and rest[0] == self.first_scan(shut=True)
            if edge.memory in self.kept and (shut or not edge.rising):
                return (Edge(edge.rising), *(rest[1:] if edge.rising else rest))
        if self.by_bit:
            mask = (self.first_scan(shut=True),) if edge.rising and not edge.memory else ()
            return (Edge(edge.rising, edge.memory or self.places.fresh()), *mask, *rest)
        return None

    def inside(self, node: Node) -> Node | None:
        """Give a part with the edges in it as the target has them where they stand; None where it cannot."""
        if isinstance(node, Parallel):
            paths = [self.inside(part) for part in node.parts]
            return None if None in paths else parallel(*(one for one in paths if one))
        parts: list[Node] = [*in_series(node)]
        for at, part in enumerate(parts):
            done = self.native(part, ()) if isinstance(part, Edge) else None
            whole = series(*done) if done else self.inside(part) if isinstance(part, Parallel) else part
            if whole is None or (isinstance(part, Edge) and done is None):
                return None
            parts[at] = whole
        return series(*parts)

    def stored(self, left: tuple[Node, ...], edge: Edge, path: Branch) -> list[Out]:
        """Give the flow beside the bit that keeps it."""
        memory = edge.memory or self.places.fresh()
        mask = [self.first_scan(shut=True)] if edge.rising and not edge.memory else []
        turned: list[Node] = [] if edge.rising else [Invert()]
        here = series(*turned, Contact(memory, negated=edge.rising), *mask, *in_series(path.stem))
        if any(isinstance(one, Box) and one.pins for one in path.outs):
            none("多输入的框前面的沿没有对应的写法", "there is no way to write an edge before a box of several inputs")
        some: list[Out] = [*self.hung(Branch(here, path.outs), at_rail=False), Coil(memory)]
        return [branch(series(*left), *some)] if left else some

    def parted(self, left: tuple[Node, ...], part: Parallel, path: Branch, *, at_rail: bool) -> list[Out]:
        """Give parallel paths with edges in them: each edge is worked out before, and read as a bit of its own."""
        found: list[Out] = []
        paths: list[Node] = []
        for one in part.parts:
            if not _edged(one):
                paths.append(series(*left, one) if at_rail else one)
                continue
            if not at_rail and _falls(one):
                none(
                    "分支里并联支路上的下降沿没有对应的写法",
                    "there is no way to write a falling edge in a parallel path of a branch",
                )
            bit = self.places.fresh()
            paths.append(Contact(bit))
            found += self.hung(Branch(series(*left, one), (Coil(bit),)), at_rail=at_rail)
        whole = parallel(*paths) if at_rail else series(*left, parallel(*paths))
        return [*found, *self.hung(Branch(series(whole, *in_series(path.stem)), path.outs), at_rail=at_rail)]


def _edged(node: Node) -> bool:
    """Say whether an edge on the wire is in a node."""
    return any(isinstance(one, Edge) for one in symbols_of(node))


def _falls(node: Node) -> bool:
    """Say whether a falling edge or NOT is in a node, which can be on where the flow is not."""
    return any(isinstance(one, Invert) or (isinstance(one, Edge) and not one.rising) for one in symbols_of(node))
