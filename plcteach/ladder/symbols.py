"""What stands between the brackets of a drawing: the words of contacts and coils, and their symbols back."""

from __future__ import annotations

import re
import unicodedata

from plcteach.core.ladder import Coil, Contact, Invert

ADDRESS = r"%?[^\W_][\w.]{0,23}"
_CONTACT = re.compile(rf"\s*(?P<mark>[/!↑↓]|[PN]\s)?\s*(?P<address>{ADDRESS})\s*", re.IGNORECASE)
_COIL = re.compile(
    rf"\s*(?P<mark>[/!]|(?:SET|RST|S|R)\s)?\s*(?P<address>{ADDRESS})(?:(?:\s*,\s*|\s+)(?P<count>\d{{1,3}}))?\s*",
    re.IGNORECASE,
)
EDGES = {"P": "rise", "↑": "rise", "N": "fall", "↓": "fall"}
KINDS = {"S": "set", "SET": "set", "R": "reset", "RST": "reset", "/": "not", "!": "not"}
MOST_BITS = 255
RESERVED = frozenset({*EDGES, *KINDS, "NOT"})


def contact(words: str) -> Contact | Invert | None:
    """Read what stands in square brackets; None if it is no contact."""
    if words.strip().upper() == "NOT":
        return Invert()
    match = _CONTACT.fullmatch(words)
    if not match or match["address"].upper() in RESERVED:
        return None
    mark = (match["mark"] or "").strip().upper()
    return contact_of(match["address"], mark)


def contact_of(address: str, mark: str) -> Contact:
    """Make the contact that a mark before an address means."""
    edge = EDGES.get(mark, "")
    return Contact(address, negated=mark in {"/", "!"}, edge=edge)  # type: ignore[arg-type]


def coil(words: str) -> Coil | None:
    """Read what stands in round brackets; None if it is no coil."""
    match = _COIL.fullmatch(words)
    if not match or match["address"].upper() in RESERVED or match["address"].isdigit():
        return None
    return coil_of(match["address"], (match["mark"] or "").strip().upper(), match["count"])


def coil_of(address: str, mark: str, count: str | None) -> Coil | None:
    """Make the coil that a mark and a number of bits mean; None where the number has no place or is out of range."""
    kind = KINDS.get(mark, "")
    number = int(count) if count else 1
    if (count and kind not in {"set", "reset"}) or not 1 <= number <= MOST_BITS:
        return None
    return Coil(address, kind, number)  # type: ignore[arg-type]


def drawn(symbol: Contact | Invert | Coil) -> str:
    """Write a symbol as a drawing has it: [ I0.0 ], [/I0.1 ], [P I0.2 ], [NOT], ( Q0.0 ), (S Q0.0 3)."""
    if isinstance(symbol, Invert):
        return "[NOT]"
    if isinstance(symbol, Contact):
        return f"[{symbol.mark or ' '}{symbol.address} ]"
    count = f" {symbol.count}" if symbol.count > 1 else ""
    return f"({symbol.mark or ' '}{symbol.address}{count}{'' if symbol.mark else ' '})"


def columns(word: str) -> int:
    """Count the columns that a word takes in fixed-width type, where Chinese and full-width characters take two."""
    return sum(2 if unicodedata.east_asian_width(sign) in "WF" else 1 for sign in word)
