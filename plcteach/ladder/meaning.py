"""What a rung means: the Boolean value of each coil, worked out from the tree alone and without any instruction list."""

from __future__ import annotations

import operator
from functools import reduce
from typing import TYPE_CHECKING, Generic, TypeVar

from plcteach.core.area import Address
from plcteach.core.errors import NotRepresentableError
from plcteach.core.ladder import Branch, Coil, Compared, Contact, Edge, Invert, Node, Out, Parallel, Rung, Series
from plcteach.core.text import Text
from plcteach.machine.signals import Signal

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.spec import Dialect

S = TypeVar("S", bound=Signal)


def meaning(
    rung: Rung,
    bits: Mapping[str, S],
    *,
    past: Mapping[str, S] | None = None,
    flows: dict[int, S] | None = None,
    dialect: Dialect | None = None,
) -> dict[str, S]:
    """Give what each coil of a rung writes, from top to bottom, a coil above being seen by the contacts below it.

    bits: every bit that the rung reads, and those that it sets or resets, by address as drawn; a comparison stands there by
    its text (`VW0 >= 5`).  past: the bits one scan ago, for edges of bits.  flows: what edges on the wire and pulse coils saw
    one scan ago, each by its number in `rung.symbols`; it is brought up to date.  dialect: counts further bits for set and
    reset coils over several.  Boxes are left out. NotRepresentableError where power meets a coil or NOT straight from the rail.
    """
    work = _Meaning({**bits}, past or {}, {} if flows is None else flows, dialect)
    work.outs(rung.outs, work.flow(rung.stem, None) if rung.stem else None)
    return work.written


class _Meaning(Generic[S]):
    """The bits as the rung changes them on its way down."""

    def __init__(self, bits: dict[str, S], past: Mapping[str, S], flows: dict[int, S], dialect: Dialect | None) -> None:
        self.bits, self.past, self.flows, self.dialect = bits, past, flows, dialect
        self.written: dict[str, S] = {}
        self.number = -1

    def outs(self, outs: tuple[Out, ...], flow: S | None) -> None:
        for out in outs:
            if isinstance(out, Coil):
                self.coil(out, _there(flow))
            elif isinstance(out, Branch):
                self.outs(out.outs, self.flow(out.stem, flow))
            else:
                self.number += 1

    def flow(self, node: Node, flow: S | None) -> S:
        """Give what comes out of a node on the right when `flow` comes in on the left, None being the rail's own power."""
        match node:
            case Contact() | Compared():
                self.number += 1
                closed = self.closed(node)
                return closed if flow is None else flow & closed
            case Invert():
                self.number += 1
                return ~_there(flow)
            case Edge():
                return self.edge(node, _there(flow))
            case Parallel(parts):
                return reduce(operator.or_, [self.flow(part, flow) for part in parts])
            case Series(parts):
                for part in parts:
                    flow = self.flow(part, flow)
        return _there(flow)

    def closed(self, contact: Contact | Compared) -> S:
        if isinstance(contact, Compared):
            return self.bits[contact.text]
        value = self.bits[contact.address]
        if contact.edge:
            return value.edge(self.past.get(contact.address), rising=contact.edge == "rise")
        return ~value if contact.negated else value

    def edge(self, edge: Edge, flow: S) -> S:
        """Give the edge of a flow; a bit of its own is a bit like any other, and off before the first scan."""
        if not edge.memory:
            return self.changed(flow, rising=edge.rising)
        self.number += 1
        last = self.bits[edge.memory]
        self.bits[edge.memory] = self.written[edge.memory] = flow
        return flow & ~last if edge.rising else ~flow & last

    def changed(self, flow: S, *, rising: bool) -> S:
        """Give the edge of a flow since it was last here, no edge the first time."""
        self.number += 1
        last = self.flows.get(self.number)
        self.flows[self.number] = flow
        return flow.edge(last, rising=rising)

    def coil(self, coil: Coil, flow: S) -> None:
        if coil.kind in {"rise", "fall"}:
            flow = self.changed(flow, rising=coil.kind == "rise")
        else:
            self.number += 1
        for address in self.places(coil):
            if coil.kind == "set":
                value = self.bits[address] | flow
            elif coil.kind == "reset":
                value = self.bits[address] & ~flow
            else:
                value = ~flow if coil.kind == "not" else flow
            self.bits[address] = self.written[address] = value

    def places(self, coil: Coil) -> list[str]:
        found = self.dialect.address(coil.address) if self.dialect and coil.count > 1 else None
        if self.dialect and isinstance(found, Address):
            return [one.text for one in self.dialect.following(found, coil.count)]
        return [coil.address]


def _there(flow: S | None) -> S:
    if flow is None:
        raise NotRepresentableError(
            Text(
                "线圈或NOT直接接在左母线上，前面没有触点。",
                "A coil or NOT hangs on the left rail itself, with no contact before it.",
            )
        )
    return flow
