"""What stands between the brackets of a drawing: the words of contacts, coils and boxes, and their symbols back."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass

from plcteach.core.ladder import Box, Coil, Compared, Contact, Edge, Invert, Symbol

ADDRESS = r"%?[^\W_][\w.]{0,23}"
NAME = r"[^\W\d_]\w{0,11}"
"""The name of an input of a box: CU, R, LD."""

_WORD = r"(?:[-+]?\d[\d.]{0,30}E[-+]?\d{1,3}|(?:[-+]?\d{1,2}#|[KHE](?=[-+]))?[-+]?%?[^\W_][\w.]{0,39})"
"""A word of a comparison: 1.5E-3, or one of 16#1F, K-5, -3, VW0, %DR0.S."""

_CONTACT = re.compile(rf"(?P<mark>[/!] ?(?:I )?|[↑↓] ?|[PNI] )?(?P<address>{ADDRESS})")
_EDGE = re.compile(rf"(?P<mark>[PN↑↓])(?: ?: ?(?P<memory>{ADDRESS}))?")
_COMPARED = re.compile(
    rf"(?P<left>{_WORD}) ?(?P<relation>==|<>|!=|[<>]=|=[<>]|[=<>≥≤≠])(?P<size>[BDRIW](?=[-+% ]))? ?(?P<right>{_WORD})"
)
_COIL = re.compile(
    rf"(?P<mark>[/!↑↓] ?|(?:SET|RST|SI|RI|[SRPNI]) )?(?P<address>{ADDRESS})(?:(?: ?, ?| )(?P<count>\d{{1,3}}))?"
)
_BOX = re.compile(rf"(?:(?P<name>{NAME}) ?:(?!=) ?)?(?P<text>[^{{}};]*)")
EDGES = {"P": "rise", "↑": "rise", "N": "fall", "↓": "fall"}
KINDS = {"S": "set", "SET": "set", "R": "reset", "RST": "reset", "/": "not", "!": "not", **EDGES}
KINDS |= {"I": "", "SI": "set", "RI": "reset"}
_RELATIONS = {"==": "=", "!=": "<>", "≠": "<>", "=>": ">=", "≥": ">=", "=<": "<=", "≤": "<="}
_COUNTED = frozenset({"set", "reset"})
_SIXTEEN = frozenset("IW")
MOST_BITS = 255
RESERVED = frozenset({*KINDS, "NOT"})
_SHOWN = 24


@dataclass(frozen=True, slots=True)
class Input:
    """A further input of a box as it is drawn, {R: }, on the row below the box."""

    name: str

    @property
    def label(self) -> Box | None:
        """What it is where it stands on the left rail itself: the label of a subroutine, SR0:, which has a number."""
        return Box(f"{self.name}:") if self.name[-1].isdigit() else None


def _plain(words: str) -> str:
    """Put words in upper case and single blanks between them, so that no pattern has two ways to take a blank."""
    return " ".join(words.upper().split())


def contact(words: str) -> Contact | Compared | Edge | Invert | None:
    """Read what stands in square brackets; None if it is no contact."""
    plain = _plain(words)
    if plain == "NOT":
        return Invert()
    if edge := _EDGE.fullmatch(plain):
        memory = edge["memory"] or ""
        return None if memory in RESERVED else Edge(rising=EDGES[edge["mark"]] == "rise", memory=memory)
    if match := _CONTACT.fullmatch(plain):
        mark = (match["mark"] or "").replace(" ", "")
        return None if match["address"] in RESERVED else contact_of(match["address"], mark)
    return compared(plain)


def contact_of(address: str, mark: str) -> Contact:
    """Make the contact that a mark before an address means."""
    edge = EDGES.get(mark, "")
    return Contact(address, negated=mark[:1] in {"/", "!"}, edge=edge, immediate=mark[-1:] == "I")  # type: ignore[arg-type]


def compared(words: str) -> Compared | None:
    """Read two words with a relation between them; None if they are not.

    A letter for the size stands right behind the relation with a blank after it, because >=D5 has an address at its right.
    """
    match = _COMPARED.fullmatch(_plain(words))
    if not match:
        return None
    relation = _RELATIONS.get(match["relation"], match["relation"])
    size = "" if match["size"] in _SIXTEEN else match["size"] or ""
    return Compared(match["left"], relation, match["right"], size)  # type: ignore[arg-type]


def coil(words: str) -> Coil | None:
    """Read what stands in round brackets; None if it is no coil."""
    match = _COIL.fullmatch(_plain(words))
    if not match or match["address"] in RESERVED or match["address"].isdigit():
        return None
    return coil_of(match["address"], (match["mark"] or "").strip(), match["count"])


def coil_of(address: str, mark: str, count: str | None) -> Coil | None:
    """Make the coil that a mark and a number of bits mean; None where the number has no place or is out of range."""
    kind = KINDS.get(mark, "")
    number = int(count) if count else 1
    if (count and kind not in _COUNTED) or not 1 <= number <= MOST_BITS:
        return None
    return Coil(address, kind, number, immediate=mark[-1:] == "I")  # type: ignore[arg-type]


def box(words: str) -> Box | Input | None:
    """Read what stands in braces, an instruction or the name of a further input; None if it is neither."""
    match = _BOX.fullmatch(_plain(words))
    if not match or not (match["name"] or match["text"]):
        return None
    name = match["name"] or ""
    return Box(match["text"], entry=name) if match["text"] else Input(name)


def drawn(symbol: Symbol) -> str:
    """Write a symbol as a drawing has it: [ I0.0 ], [P I0.2 ], [ VW0 >= 5 ], [NOT], ( Q0.0 ), (S Q0.0 3), { TON T37, 50 }."""
    match symbol:
        case Contact():
            return f"[{symbol.mark or ' '}{symbol.address} ]"
        case Compared():
            return f"[ {symbol.text} ]"
        case Invert():
            return "[NOT]"
        case Edge():
            return f"[{symbol.mark}]"
        case Box():
            return f"{{{symbol.entry}{':' if symbol.entry else ''} {symbol.text} }}"
    return f"({symbol.mark or ' '}{symbol.address} {symbol.count if symbol.count > 1 else ''})"


def drawn_input(name: str, width: int) -> str:
    """Write a further input of a box, as wide as the box if it can: {R:            }."""
    return f"{{{name}:{' ' * max(1, width - columns(name) - len('{:}'))}}}"


def columns(word: str) -> int:
    """Count the columns that a word takes in fixed-width type, where Chinese and full-width characters take two."""
    return sum(2 if unicodedata.east_asian_width(sign) in "WF" else 1 for sign in word)


def shortened(words: str) -> str:
    """Give what was drawn as a message may show it."""
    return words if len(words) <= _SHOWN else f"{words[:_SHOWN]}…"
