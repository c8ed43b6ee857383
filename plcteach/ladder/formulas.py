"""The Boolean formula of each coil and box input of a rung, as a book writes it: Q0.0 = (I0.0+Q0.0)·/I0.1."""

from __future__ import annotations

import operator
from functools import reduce
from typing import TYPE_CHECKING

from plcteach.core.ladder import (
    Box,
    Branch,
    Compared,
    Contact,
    Edge,
    Invert,
    Node,
    Out,
    Parallel,
    Rung,
    Series,
    symbols_of,
)
from plcteach.machine.formula import Term, name, written

if TYPE_CHECKING:
    from collections.abc import Iterator

_RAIL = name("1")
MOST_NODES = 120


def formulas(rung: Rung) -> tuple[tuple[str, str], ...]:
    """Give for each output what it is called (Q0.0, TON T37, a box's input CTU C0 CU) and its formula, from top to bottom."""
    if rung.stem is None:
        return ()
    found = _outs(rung.outs, _through(rung.stem, _RAIL))
    return tuple((said, written(term, MOST_NODES)) for said, term in found)


def _outs(outs: tuple[Out, ...], flow: Term) -> Iterator[tuple[str, Term]]:
    for out in outs:
        match out:
            case Branch(stem, inner):
                yield from _outs(inner, _through(stem, flow))
            case Box(_, pins, entry):
                word = f"{out.word} {out.operands.partition(',')[0]}".strip()
                yield f"{word} {entry}".strip(), flow
                yield from ((f"{word} {pin}".strip(), _through(node, _RAIL)) for pin, node in pins)
            case _:
                yield f"{'' if out.kind == 'not' else out.mark}{out.address}", ~flow if out.kind == "not" else flow


def _through(node: Node, flow: Term) -> Term:
    """Give the formula of what comes out of a node on its right; from the rail itself nothing is written before it."""
    match node:
        case Contact():
            return _joined(flow, _contact(node))
        case Compared():
            return _joined(flow, name(f"[{node.text}]"))
        case Invert():
            return ~flow
        case Edge(rising):
            return flow.edge(None, rising=rising)
        case Parallel(parts):
            return _side_by_side(parts, flow)
        case Series(parts):
            return reduce(lambda before, part: _through(part, before), parts, flow)


def _side_by_side(parts: tuple[Node, ...], flow: Term) -> Term:
    """Join parallel paths behind the flow that feeds them all, unless one of them turns the whole flow round."""
    if any(map(_turns, parts)):
        return reduce(operator.or_, [_through(part, flow) for part in parts])
    return _joined(flow, reduce(operator.or_, [_through(part, _RAIL) for part in parts]))


def _turns(node: Node) -> bool:
    return any(isinstance(one, Invert | Edge) for one in symbols_of(node))


def _joined(flow: Term, term: Term) -> Term:
    return term if flow is _RAIL else flow & term


def _contact(contact: Contact) -> Term:
    bit = name(contact.address)
    if contact.edge:
        return bit.edge(None, rising=contact.edge == "rise")
    return ~bit if contact.negated else bit
