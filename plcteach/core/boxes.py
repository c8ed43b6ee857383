"""Ladder boxes that a list has no instruction for: a box of three words becomes a move and an operation on the result.

`faithful` splits as the editor does, move first; `safe` splits so that the result is right, or says that it cannot.
Source: 004_076ff6df1b5a98bb.txt, whose editor 1.0 splits faithfully.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from plcteach.core.area import BYTE, Address
from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.errors import UnknownNameError
from plcteach.core.source import Span

if TYPE_CHECKING:
    from plcteach.core.program import Source
    from plcteach.core.spec import Dialect

Mode = Literal["faithful", "safe"]

_TURNS_ROUND = {"add", "mul", "and", "or", "xor"}
"""Operations whose operands may change places."""


_NOWHERE = Span(1)


@dataclass(frozen=True, slots=True)
class Box:
    """A box with its operands: OUT := IN1 op IN2.  span: where it stands."""

    name: str
    in1: Source
    in2: Source
    out: Address
    span: Span = _NOWHERE

    @property
    def text(self) -> str:
        """The box as a list spells it."""
        return f"{self.name} {self.in1.text}, {self.in2.text}, {self.out.text}"


Part = tuple[str, "Source", Address]
"""A mnemonic with its two operands."""


def split(dialect: Dialect, box: Box, mode: Mode = "faithful") -> tuple[tuple[Part, ...], tuple[Diagnostic, ...]]:
    """Give the instructions that a box becomes, and what is to be said about it; UnknownNameError if there is no such box."""
    if box.name not in dialect.boxes:
        kind = f"{dialect.name} box"
        raise UnknownNameError(kind, box.name, dialect.boxes)
    move, work = dialect.boxes[box.name]
    parts: tuple[Part, ...] = ((move, box.in1, box.out), (work, box.in2, box.out))
    if mode == "safe" and box.in1 == box.out:
        return parts[1:], ()
    if box.in1 == box.out or not (isinstance(box.in2, Address) and overlap(dialect, box.out, box.in2)):
        return parts, ()
    if mode == "faithful":
        texts = [f"{word} {source.text}, {out.text}" for word, source, out in parts]
        values = {"word": box.text, "first": texts[0], "then": texts[1], "address": box.in2.text}
        return parts, (rule("BOX001").at(box.span, **values),)
    if box.in2 == box.out and dialect.insn(work).then[0].op in _TURNS_ROUND:
        return ((work, box.in1, box.out),), ()
    return (), (rule("BOX002").at(box.span, word=box.text, out=box.out.text, address=box.in2.text),)


def overlap(dialect: Dialect, one: Address, other: Address) -> bool:
    """Say whether two words share a byte (MW3 and MW4 do); words that are kept as such share all or nothing."""
    mine, theirs = ({(bit.area, bit.index // BYTE) for bit in dialect.bits_of(word)} for word in (one, other))
    return bool(mine & theirs) if mine and theirs else one == other
