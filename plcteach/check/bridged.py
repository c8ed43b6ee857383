"""Whether a contact does anything where it stands: a closed one that is bridged, an open one that is cut, must change the rung.

An interlock may be drawn so that it never opens anything, beside a contact of the opposite kind; then it is none.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from plcteach.check.proof.table import TooLarge, model_of
from plcteach.core.errors import NotRepresentableError
from plcteach.core.ladder import Box, Branch, Coil, Compared, Contact, Edge, Invert, Parallel, Rung, Series, symbols_of
from plcteach.ladder.meaning import meaning
from plcteach.machine.gates import Graph

if TYPE_CHECKING:
    from plcteach.core.spec import Dialect

_INSTEAD, _HERE = Contact("#"), "@"


def matters(rung: Rung, output: str, contact: Contact, dialect: Dialect) -> bool:
    """Say whether what the rung writes to the output would be another thing without the contact.

    True as well where that is no question of Boolean logic: of edges, of boxes, of too many contacts.
    """
    if any(isinstance(one, Edge) or (isinstance(one, Contact) and one.edge) for one in symbols_of(rung)):
        return True
    graph = Graph()
    plain, bare = _free(rung, None), _free(rung, contact)
    known = {"on": graph.one, "off": graph.zero}
    names = [_name(one) for one in symbols_of(plain) if not isinstance(one, Box | Invert | Edge)]
    driven = {name: dialect.specials.get(name.removeprefix(_HERE), "") for name in names}
    bits = {name: known.get(what) or graph.variable(name) for name, what in driven.items()}
    bits[_INSTEAD.address] = graph.one if contact.negated else graph.zero
    try:
        as_drawn, without = meaning(plain, bits), meaning(bare, bits)
        outputs = [output] if output else list(as_drawn)
        if not all(one in as_drawn and one in without for one in outputs):
            return True
        return any(model_of(graph, as_drawn[one] ^ without[one]) is not None for one in outputs)
    except (NotRepresentableError, TooLarge):
        return True


def _name(one: Contact | Compared | Coil) -> str:
    return one.text if isinstance(one, Compared) else one.address


def _free(one: Any, contact: Contact | None) -> Any:
    """Let every contact stand for itself, whatever a coil above writes, and put something else in the place of one of them."""
    match one:
        case Contact():
            there = contact and (one.address, one.negated) == (contact.address, contact.negated)
            return _INSTEAD if there else replace(one, address=_HERE + one.address)
        case Series() | Parallel():
            return replace(one, parts=tuple(_free(part, contact) for part in one.parts))
        case Branch(stem, outs):
            return Branch(_free(stem, contact), tuple(_free(out, contact) for out in outs))
        case Rung(stem, outs):
            return Rung(_free(stem, contact), tuple(_free(out, contact) for out in outs))
    return one
