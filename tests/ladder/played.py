"""Plays lifted rungs with plain truth values, scan after scan; shares nothing with the package's own evaluators."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.ladder import Box, Branch, Coil, Edge, Invert, Parallel, Series

if TYPE_CHECKING:
    from plcteach.core.ladder import Contact, Node, Out
    from plcteach.ladder.lift import Lifted


class Played:
    """Rungs that are played; each symbol remembers its own last value, and a box END ends the scan."""

    def __init__(self, lifted: Lifted) -> None:
        self.lifted, self.dialect = lifted, lifted.program.dialect
        self.bits: dict[str, bool] = {}
        self.kept: dict[tuple[int, int], bool] = {}
        self.first, self.start, self.last = True, {}, {}
        self.number, self.count = 0, 0

    def scan(self, inputs: dict[str, bool]) -> dict[str, bool]:
        self.bits.update(inputs)
        powered = {"on": True, "first": self.first, "later": not self.first, "cold": self.first}
        self.bits.update({word: powered.get(what, False) for word, what in self.dialect.specials.items()})
        self.start = dict(self.bits)
        for number, one in enumerate(self.lifted.rungs):
            self.number, self.count = number, 0
            flow = self.through(one.rung.stem, flow=True) if one.rung.stem else True
            if self.ended(one.rung.outs, flow=flow):
                break
        self.last, self.first = self.start, False
        return self.bits

    def moved(self, *, now: bool, rising: bool) -> bool:
        key = (self.number, self.count)
        was, self.kept[key] = self.kept.get(key), now
        return was is not None and now != was and now == rising

    def ended(self, outs: tuple[Out, ...], *, flow: bool) -> bool:
        for out in outs:
            if isinstance(out, Branch):
                if self.ended(out.outs, flow=self.through(out.stem, flow=flow)):
                    return True
            elif isinstance(out, Box):
                assert out.text == "END"
                return True
            else:
                self.coil(out, flow=flow)
        return False

    def coil(self, coil: Coil, *, flow: bool) -> None:
        self.count += 1
        value = self.moved(now=flow, rising=coil.kind == "rise") if coil.kind in {"rise", "fall"} else flow
        for place in self.dialect.following(self.dialect.address(coil.address), coil.count):
            if coil.kind in {"set", "reset"}:
                if flow:
                    self.bits[place.text] = coil.kind == "set"
            else:
                self.bits[place.text] = value != (coil.kind == "not")

    def through(self, node: Node, *, flow: bool) -> bool:
        if isinstance(node, Series):
            for part in node.parts:
                flow = self.through(part, flow=flow)
            return flow
        if isinstance(node, Parallel):
            paths = [self.through(part, flow=flow) for part in node.parts]
            return any(paths)
        self.count += 1
        if isinstance(node, Invert):
            return not flow
        if isinstance(node, Edge):
            if not node.memory:
                return self.moved(now=flow, rising=node.rising)
            was, self.bits[node.memory] = self.bits.get(node.memory, False), flow
            return flow != was and flow == node.rising
        closed = self.closed(node)
        return flow and closed

    def closed(self, contact: Contact) -> bool:
        now = self.bits.get(contact.address, False)
        if not contact.edge:
            return now != contact.negated
        if not self.dialect.samples_edges_at_start:
            return self.moved(now=now, rising=contact.edge == "rise")
        now = self.start.get(contact.address, False)
        return not self.first and now != self.last.get(contact.address, False) and now == (contact.edge == "rise")
