"""Reads what stands between BLK and END_BLK, where the name of a pin or an output stands for that of the block.

It also takes the two ways in which a number is glued to its instruction: a label (`%L1:`) and a subroutine (`SR0`, `SR0:`).
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Literal

from plcteach.core.area import Address
from plcteach.core.program import Assign
from plcteach.core.source import Span
from plcteach.core.text import Text, same
from plcteach.stl.words import Word

if TYPE_CHECKING:
    from plcteach.core.insn import Insn
    from plcteach.core.program import Arg, Line
    from plcteach.stl.operands import Operands

OPEN, OUTPUTS, CLOSE = "BLK", "OUT_BLK", "END_BLK"
_GLUED = re.compile(r"(?P<mark>%?[A-Za-z]{1,3})(?P<number>[0-9]{1,9})(?P<colon>:?)")
_ELSEWHERE = {"jump", "label", "call", "return", "entry", "end", "stop"}


@dataclass(frozen=True, slots=True)
class Spelled:
    """A statement as it is to be read: its words, how the list spells it, and the words that are an instruction of their own."""

    words: list[Word]
    said: str = ""
    rest: tuple[Word, ...] = ()


class Section:
    """Where the reader is: outside of a block's section, among its inputs, or among its outputs."""

    def __init__(self, operands: Operands) -> None:
        self.operands = operands
        self.dialect = operands.dialect
        self.block: Address | None = None
        self.opened = Span(0)
        self.part: Literal["", "inputs", "outputs"] = ""

    @cached_property
    def glued(self) -> dict[str, Insn]:
        """The instructions to which their number is glued, by what stands before the number and after it."""
        rows = (row for row in self.dialect.insns if len(row.operands) == 1 and row.operands[0].number)
        return {row.word: row for row in rows if row.operands[0].mark and row.operands[0].mark == row.word.rstrip(":")}

    def numbered(self, words: list[Word]) -> re.Match[str] | None:
        """Notice a label or a subroutine, `%L1:` or `SR0`."""
        colon = ":" if len(words) > 1 and words[1].text == ":" else ""
        match = _GLUED.fullmatch(words[0].text + colon)
        return match if match and match["mark"].upper() + match["colon"] in self.glued else None

    def unglued(self, words: list[Word]) -> Spelled | None:
        """Part a number from its instruction; behind a label the next instruction may stand in the same row."""
        match = self.numbered(words)
        if match is None:
            return None
        row = self.glued[match["mark"].upper() + match["colon"]]
        rest = words[2 if not words[0].text.endswith(":") and match["colon"] else 1 :]
        number = Word(match["mark"] + match["number"], words[0].span)
        own = [replace(words[0], text=row.word), number]
        return Spelled(own, rest=tuple(rest)) if match["colon"] else Spelled([*own, *rest])

    def spelled(self, words: list[Word]) -> Spelled | None:
        """Give a statement with the block's address where the list leaves it out; None where it cannot stand here."""
        if self.numbered(words):
            return self.unglued(words)
        if words[0].text.startswith("[") and "[" in self.dialect.words:
            return Spelled([Word("[", words[0].span), *words])
        if words[0].text.upper() in {OUTPUTS, CLOSE} & set(self.dialect.words):
            return self.bound(words)
        if len(words) == 1 and words[0].text.upper() in self.pins:
            return self.pinned(words[0])
        if len(words) > 1 and words[1].text.upper() in self.fields and self.block:
            return self.output(words)
        return Spelled(words)

    @cached_property
    def pins(self) -> frozenset[str]:
        """The names of all pins that instructions of this family stand for."""
        areas = {block.area: block.pins for block in self.dialect.blocks}
        return frozenset(
            row.word
            for row in self.dialect.insns
            for area in areas
            if row.mnemonic == f"{row.word} {area}" and row.word in areas[area]
        )

    @cached_property
    def fields(self) -> frozenset[str]:
        """The names of all outputs of this family's blocks."""
        return frozenset(name for block in self.dialect.blocks for name in block.outputs)

    def bound(self, words: list[Word]) -> Spelled | None:
        """Take OUT_BLK or END_BLK, which belong to the block that is open and have no operand of their own."""
        word, said = words[0], words[0].text.upper()
        if self.block is None:
            self.operands.say("BLK003", word.span, word=said)
            return None
        if said == OUTPUTS and self.part == "outputs":
            self.operands.say("BLK005", word.span, word=said, block=self.block.text)
            return None
        return Spelled([word, Word(self.block.text, word.span), *words[1:]], said)

    def pinned(self, word: Word) -> Spelled | None:
        """Take a pin's name standing alone."""
        name = word.text.upper()
        if self.block is None:
            if name not in self.dialect.words:
                self.operands.say("BLK008", word.span, word=name)
                return None
            return Spelled([word])
        if not self.has(word, pins=True):
            return None
        if self.part == "outputs":
            self.operands.say("BLK005", word.span, word=name, block=self.block.text)
            return None
        return Spelled([word, Word(self.block.text, word.span)], name)

    def output(self, words: list[Word]) -> Spelled | None:
        """Take an output's name where an operand stands."""
        name = words[1].text.upper()
        if self.block is None or not self.has(words[1], pins=False):
            return None
        if self.part == "inputs":
            self.operands.say("BLK002", words[1].span, word=name, block=self.block.text)
            return None
        full = Word(f"{self.block.text}.{name}", words[1].span)
        return Spelled([words[0], full, *words[2:]], f"{words[0].text.upper()} {name}")

    def has(self, word: Word, *, pins: bool) -> bool:
        """Say whether the open block has a pin or an output of this name, and tell the learner if it has not."""
        block = self.dialect.block(self.block) if self.block else None
        names = () if block is None else block.pins if pins else block.outputs
        if word.text.upper() not in names and self.block:
            what = Text("输入", "inputs") if pins else Text("输出", "outputs")
            none = Text("没有", "none") if not names else same(", ".join(names))
            self.operands.say("BLK004", word.span, word=word.text.upper(), block=self.block.text, what=what, names=none)
            return False
        return True

    def suits(self, insn: Insn, words: list[Word]) -> bool:
        """Say whether a whole block may stand behind an instruction that bears the name of a pin (R %TM0 may not)."""
        found = self.dialect.address(words[0].text) if words and insn.word in self.pins else None
        if not isinstance(found, Address) or found.size or f"{insn.word} {found.area}" in self.dialect.words:
            return True
        block = self.dialect.block(found)
        names = same(", ".join(block.pins if block else ()))
        what = Text("输入", "inputs")
        self.operands.say("BLK004", words[0].span, word=insn.word, block=found.text, what=what, names=names)
        return False

    def said(self, insn: Insn, args: tuple[Arg, ...], spelled: Spelled) -> str:
        """Say how the list spells a line that is more than a mnemonic with its operands, "" for all others."""
        first = args[0] if args else None
        if insn.word in self.glued and isinstance(first, int):
            return f"{insn.operands[0].mark}{first}{':' if insn.word.endswith(':') else ''}"
        return first.text if isinstance(first, Assign) else spelled.said

    def after(self, line: Line) -> None:
        """Go on behind a line: into a block's section, to its outputs, out of it."""
        does = line.insn.does
        if "open" in does:
            if self.block:
                self.operands.say("BLK001", line.span, word=line.text, block=self.block.text)
            place = line.args[0]
            self.block, self.opened, self.part = place if isinstance(place, Address) else None, line.span, "inputs"
        elif "update" in does:
            ends = line.insn.word == CLOSE
            self.block, self.part = (None, "") if ends else (self.block, "outputs")
        elif self.block and (does & _ELSEWHERE or ("pin" in does and not line.said)):
            self.operands.say("BLK006", line.span, word=line.text, block=self.block.text)

    def close(self) -> None:
        """End what is open at a heading or at the end of the text."""
        if self.block:
            self.operands.say("BLK007", self.opened, block=self.block.text)
        self.block, self.part = None, ""
