"""Timers and counters of any family as boxes of a ladder, found in its table by what they do."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.core.ladder import Box, Coil, Rung, rung

if TYPE_CHECKING:
    from plcteach.core.block import Block
    from plcteach.core.insn import Insn
    from plcteach.core.ladder import Node
    from plcteach.core.spec import Dialect, Use

BASE = 100
"""The time base that every family has, in ms."""
_SHORT = 16


@dataclass(frozen=True, slots=True)
class Timer:
    """A timer: the box that starts it, and the bit by which it is read."""

    box: Box
    bit: str


@dataclass(frozen=True, slots=True)
class Counter:
    """A counter: the rungs that count and reset it, and the bit by which it is read."""

    rungs: tuple[Rung, ...]
    bit: str


class Blocks:
    """The timers and counters given out so far, and the lines that configure them."""

    def __init__(self, dialect: Dialect) -> None:
        self.dialect = dialect
        self.configuration: list[str] = []
        self.given: dict[str, int] = {}

    def declared(self, use: Use) -> Block:
        """Give the family's blocks for a use."""
        area = self.dialect.counterparts[use]
        return next(one for one in self.dialect.blocks if one.area == area)

    def place(self, block: Block, first: int) -> str:
        """Give the next free one of an area."""
        number = self.given.get(block.area, first)
        self.given[block.area] = number + 1
        return next(one for one in self.dialect.areas if one.prefix == block.area).address(number).text

    def row(self, block: Block, *ops: str) -> Insn | None:
        """Give the instruction that drives a block by one of some rules."""
        return next(
            (
                one
                for op in ops
                for one in self.dialect.insns
                if one.operands
                and one.operands[0].kind
                and block.area in self.dialect.kinds[one.operands[0].kind].areas
                if any(verb.op == op and verb.name in {"drive", "pin"} for verb in one.then)
            ),
            None,
        )

    def number(self, count: int) -> str:
        """Write a whole number as the family does."""
        letters = next((one for one, base in self.dialect.constant.items() if base == 10), "")  # noqa: PLR2004 (decimal)
        return f"{letters}{count}"

    def timer(self, preset: int) -> Timer:
        """Give an on-delay of so many tenths of a second."""
        block = self.declared("timer")
        if block.settings:
            place = self.place(block, block.banks[0].first)
            kinds, bases = block.settings["TYPE"].choices or {}, block.settings["TB"].choices or {}
            kind = next(word for word, meant in kinds.items() if meant == "on")
            base = next(word for word, meant in bases.items() if meant == BASE)
            self.configuration.append(f"{place}: TYPE={kind} TB={base} P={preset}")
            row = self.row(block, "IN")
            return Timer(Box(f"{row.word if row else 'IN'} {place}"), f"{place}.{block.bit}")
        bank = next(one for one in block.banks if one.base == BASE and not one.retains)
        place, row = self.place(block, bank.first), self.row(block, "on")
        return Timer(Box(self.spelled(row, place, preset)), place)

    def spelled(self, row: Insn | None, place: str, preset: int) -> str:
        """Write the instruction of a timer or counter with its preset."""
        return f"{row.word} {place}{row.separator}{self.number(preset)}" if row else ""

    def counter(self, preset: int, count: Node, reset: Node) -> Counter:
        """Give a counter that counts up when the one condition comes, and is reset by the other."""
        block = self.declared("counter")
        place = self.place(block, 0)
        if block.settings:
            self.configuration.append(f"{place}: P={preset}")
            opener = next(one for one in self.dialect.insns if any(verb.name == "open" for verb in one.then))
            box = Box(f"{opener.word} {place}", (("R", reset),), "CU")
            return Counter((rung(count, box),), f"{place}.{block.outputs[1]}")
        row = self.row(block, "up", "upto")
        text = self.spelled(row, place, preset)
        if row and len(row.effect.clauses[0].takes) > 1:
            return Counter((rung(count, Box(text, (("R", reset),), "CU")),), place)
        return Counter((rung(reset, Coil(place, "reset")), rung(count, Box(text))), place)
