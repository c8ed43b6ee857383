"""Maps the symbols of a ladder from one family to another: contacts, comparisons, coils, and boxes by what they do.

A box is read by its family's reader, told by the rule of the machine that it follows (a timer's, a counter's, a sum's), and
written as the instruction of the other family that follows the same rule.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.insn import REGISTERS
from plcteach.core.ladder import Box, Coil, Compared, Contact, Edge, Parallel, Series, parallel, series
from plcteach.core.text import Text
from plcteach.ladder.instructions import coil_word, comparing, contact_word
from plcteach.ladder.places import lacking, none
from plcteach.stl.reader import read

if TYPE_CHECKING:
    from plcteach.core.ladder import Node, Out
    from plcteach.core.program import Source
    from plcteach.core.spec import Dialect
    from plcteach.ladder.places import Places


class Crossing:
    """Symbols of the source as symbols of the target; what there is to say goes to `notes`."""

    def __init__(self, places: Places) -> None:
        self.places = places
        self.source: Dialect = places.source
        self.target: Dialect = places.target
        self.notes: list[Text] = []
        self.said: set[str] = set()
        self.compared_bits: dict[str, Compared] = {}
        self.held_bits: dict[str, str] = {}

    def note(self, zh: str, en: str) -> None:
        """Say something once."""
        if en not in self.said:
            self.said.add(en)
            self.notes.append(Text(zh, en))

    # contacts

    def node(self, node: Node) -> Node:
        """Give contacts and what is between them with the target's addresses."""
        match node:
            case Series(parts):
                return series(*map(self.node, parts))
            case Parallel(parts):
                return parallel(*map(self.node, parts))
            case Contact():
                return self.contact(node)
            case Compared():
                return self.compared(node)
            case Edge(_, memory) if memory:
                return replace(node, memory=self.places.bit(memory)[0])
        return node

    def contact(self, one: Contact) -> Contact | Compared:
        """Give a contact of the target."""
        if one.address in REGISTERS:
            none(f"{one.address}在{self.target.title.zh}里没有", f"{self.target.title.en} has no {one.address}")
        word = self.block_bit(one)
        if isinstance(word, Compared):
            return word
        address, inverse = (word, False) if word else self.places.bit(one.address)
        found = replace(one, address=address, negated=one.negated != inverse)
        if one.immediate and contact_word(self.target, "load", found) is None:
            sign = f"[{one.mark}{one.address}]"
            self.note(
                f"{sign}：{self.target.title.zh}没有立即触点，改读输入映像。",
                f"{sign}: {self.target.title.en} has no immediate contact; the input image is read.",
            )
            found = replace(found, immediate=False)
        return found

    def block_bit(self, one: Contact) -> str | Compared:
        """Give what reads the output of a timer or counter, "" for any other bit."""
        place = self.source.address(one.address)
        if not isinstance(place, Address) or not self.source.block(place):
            return ""
        whole = self.source.whole(place).text
        if whole in self.held_bits and place.field in {"", self.bit_field(place)}:
            return self.held_bits[whole]
        if one.address in self.compared_bits:
            if one.edge:
                none(f"{one.address}的沿没有对应的触点", f"there is no contact for the edge of {one.address}")
            found = self.compared_bits[one.address]
            return replace(found, relation="<>") if one.negated else found
        if whole not in self.places.table or place.field not in {"", self.bit_field(place)}:
            none(f"{one.address}没有对应的位", f"there is no bit for {one.address}")
        return self.places.output(self.places.table[whole])

    def bit_field(self, place: Address) -> str:
        """Give the field that is a block's output bit."""
        block = self.source.block(place)
        return block.bit if block else ""

    def compared(self, one: Compared) -> Compared:
        """Give a comparison of the target."""
        load = contact_word(self.source, "load", one)
        if load is None:
            none(f"[{one.text}]读不成比较", f"[{one.text}] does not read as a comparison")
        pair = read(comparing(load, one), self.source).lines[0].args[0]
        left, right = (self.word(source) for source in (pair.left, pair.right))  # type: ignore[union-attr]
        found = Compared(left, one.relation, right, one.size)
        if contact_word(self.target, "load", found) is None:
            none(f"没有[{one.text}]这样的比较触点", f"there is no comparing contact such as [{one.text}]")
        return found

    def word(self, source: Source) -> str:
        """Give a word or a number in the target's spelling."""
        if isinstance(source, Address):
            self.current(source)
            return self.places.word(source)
        return self.number(source.number)

    def current(self, place: Address) -> None:
        """Say where a current value goes on past the preset in one family and stays there in the other."""
        block = self.source.block(place)
        use = self.places.uses.get(place.area)
        other = next((one for one in self.target.blocks if use and one.area == self.target.counterparts.get(use)), None)
        if block and other and block.stops != other.stops:
            self.note(
                f"{place.text}：当前值到了预设值以后，一个系列停住，一个继续计。",
                f"{place.text}: once the preset is reached, the current value stays there in one family and goes on in the other.",
            )

    def number(self, number: float) -> str:
        """Spell a number as the target does."""
        if isinstance(number, float):
            if not any(kind.real for kind in self.target.kinds.values()):
                none(f"{number}是实数", f"{number} is a real number")
            return repr(number)
        prefix = next(mark for mark, base in self.target.constant.items() if base == _TEN)
        return f"{prefix}{number}"

    # coils

    def coil(self, coil: Coil) -> list[Out]:
        """Give a coil, or several where the bits that it reaches over lie apart in the target."""
        place = self.source.address(coil.address)
        if not isinstance(place, Address) or place.size not in {0, 1}:
            none(f"没有{coil.address}的线圈", f"there is no coil of {coil.address}")
        if coil.immediate and coil_word(self.target, coil.kind, immediate=True) is None:
            sign = f"({coil.mark}{coil.address})"
            self.note(
                f"{sign}：{self.target.title.zh}没有立即线圈，改写输出映像。",
                f"{sign}: {self.target.title.en} has no immediate coil; the output image is written.",
            )
            coil = replace(coil, immediate=False)
        if self.source.block(place):
            return [self.block_coil(coil, place)]
        texts = [self.places.bit(one.text)[0] for one in self.source.following(place, coil.count)]
        first = self.target.address(texts[0])
        if isinstance(first, Address) and [one.text for one in self.target.following(first, len(texts))] == texts:
            return [replace(coil, address=texts[0])]
        return [replace(coil, address=text, count=1) for text in texts]

    def block_coil(self, coil: Coil, place: Address) -> Coil | Box:
        """Give the reset of a timer or counter: a coil, or the reset input of a block."""
        whole = self.source.whole(place).text
        reset = coil_word(self.target, "reset")
        found = self.target.address(self.places.table.get(whole, ""))
        if (
            coil.kind == "reset"
            and coil.count == 1
            and isinstance(found, Address)
            and reset
            and whole not in self.held_bits
        ):
            if found.area in self.target.kinds[reset.operands[0].kind].areas:
                return Coil(found.text, "reset")
            if f"{reset.word} {found.area}" in self.target.words:
                return Box(f"{reset.word} {found.text}")
        sign = f"({coil.mark}{coil.address})"
        why = lacking(f"没有{sign}的写法", f"there is no way to write {sign}")
        raise why


_TEN = 10
