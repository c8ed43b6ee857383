"""Which wires of a planned rung carry power, worked out along the plan: what a picture lights.

The flow itself is shown, and not what an instruction list made of it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from plcteach.core.ladder import Box, Coil, Compared, Contact, Invert
from plcteach.ladder.layout import RAIL

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.ladder.layout import Layout, Placed


class Conducts(Protocol):
    """Says whether a contact or an edge lets power through; `number` counts the pieces of the plan from 0."""

    def __call__(self, piece: Placed, number: int, /) -> bool:
        """Say whether it conducts."""
        ...


def live_nets(plan: Layout, conducts: Conducts) -> frozenset[int]:
    """Give the nets that carry power: the rail, and what a conducting symbol reaches, in the order of execution."""
    live = {RAIL}
    for number, piece in enumerate(plan.pieces):
        if piece.target is not None and passes(piece, number, live, conducts):
            live.add(piece.target)
    return frozenset(live)


def passes(piece: Placed, number: int, live: set[int] | frozenset[int], conducts: Conducts) -> bool:
    """Say whether power leaves a symbol on its right, or reaches it where nothing is on its right."""
    fed = piece.source in live
    if isinstance(piece.symbol, Coil | Box):
        return fed
    if isinstance(piece.symbol, Invert):
        return not fed
    return fed and conducts(piece, number)


def by_bits(bits: Mapping[str, object]) -> Conducts:
    """Let contacts conduct by the values of bits (0 or 1) by address; a bit that is not named counts as 0.

    An edge contact is asked for by its mark and address, "P I0.0", a comparison by its text, "VW0 >= 5".
    """

    def conducts(piece: Placed, number: int) -> bool:
        del number
        match piece.symbol:
            case Contact() as contact:
                key = f"{contact.mark}{contact.address}" if contact.edge else contact.address
                return _is_on(bits.get(key, 0)) != contact.negated
            case Compared() as compared:
                return _is_on(bits.get(compared.text, 0))
        return False

    return conducts


def _is_on(value: object) -> bool:
    """Say whether a value is 1, given as a number, a truth value or a signal that writes itself so."""
    return value is True or repr(value) in {"1", "'1'"}
