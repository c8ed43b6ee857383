"""Makes a family's own ladder of one with IEC addresses, names and boxes, as `plcopen` reads it.

An input, output or memory bit goes to the family's area for that use, a name without an address to a memory bit that is free.
A timer or counter becomes what the family has for it: a configured block between its inputs and its outputs (`BLK %TM0`, with
its configuration line), or an instruction with the pins that the standard's box has (`TON T37, 50`), its number from a bank
whose time base measures the preset. Where the family's counter has no output bit that means the same, its count is compared.

What has no counterpart raises NotRepresentableError: TP or TOF where the family has only on-delays, CTD where it only counts up,
CTUD (of two outputs) everywhere, a preset that is a variable or does not go into the time base, an edge of a compared count.
A pin that stays free is held at 0. The standard's counters stop at the ends of INT and its CTD counts on below zero; those here
stop, or turn over at the ends of their own range, which a lesson does not reach.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, NoReturn

from plcteach.core.area import Address
from plcteach.core.errors import NotRepresentableError
from plcteach.core.ladder import (
    Box,
    Branch,
    Coil,
    Compared,
    Contact,
    Ladder,
    Parallel,
    Rung,
    Series,
    branch,
    parallel,
    rung,
    series,
)  # fmt: skip
from plcteach.core.text import Text
from plcteach.dialects import dialect as find_dialect
from plcteach.ladder.plcopen_names import ADDRESS, INPUTS
from plcteach.ladder.plcopen_variables import boxed

if TYPE_CHECKING:
    from plcteach.core.area import Area
    from plcteach.core.block import Block
    from plcteach.core.insn import Insn
    from plcteach.core.ladder import Node, Out
    from plcteach.core.spec import Dialect, Use

_OPS = {"TON": "on", "TOF": "off", "TP": "pulse", "CTU": "up", "CTD": "down"}
_UNITS: dict[str, int | Fraction] = {
    "D": 86_400_000,
    "H": 3_600_000,
    "M": 60_000,
    "S": 1_000,
    "MS": 1,
    "US": Fraction(1, 1_000),
    "NS": Fraction(1, 1_000_000),
}
_PIECE = re.compile(r"(\d+(?:\.\d+)?)(MS|US|NS|[DHMS])")
_USES: dict[str, Use] = {"I": "input", "Q": "output", "M": "memory"}
_BYTE = 8
_TURNED = {">=": "<", "=": "<>", ">": "<="}


@dataclass(frozen=True, slots=True)
class Fitted:
    """A ladder in a family's own words, the configuration lines of its blocks, and what became of each address and name."""

    ladder: Ladder
    configuration: tuple[str, ...]
    table: dict[str, str]

    def __repr__(self) -> str:
        return f"Fitted({len(self.ladder.rungs)} rungs, {len(self.table)} addresses)"


def fitted(ladder: Ladder, dialect: str | Dialect) -> Fitted:
    """Fit a ladder with IEC addresses and boxes to a family; NotRepresentableError says what the family has nothing for."""
    work = _Fitting(find_dialect(dialect))
    work.survey(ladder)
    made = []
    for number, one in enumerate(ladder.rungs):
        work.number = number
        made.append(rung(None if one.stem is None else work.node(one.stem), *map(work.out, one.outs), title=one.title))
        made += work.after
        work.after.clear()
    return Fitted(Ladder(tuple(made), ladder.title), tuple(work.configuration), work.table)


def milliseconds(preset: str) -> Fraction | None:
    """Give how long a time such as T#1M30S is."""
    pieces = _PIECE.findall(preset.removeprefix("T#"))
    whole = preset.startswith("T#") and "".join(f"{size}{unit}" for size, unit in pieces) == preset[2:]
    return sum((Fraction(size) * _UNITS[unit] for size, unit in pieces), Fraction(0)) if whole and pieces else None


@dataclass(frozen=True, slots=True)
class _Timed:
    """A timer or counter of the ladder: its kind, its preset as a number, and the family's block that takes its place."""

    kind: str
    preset: int
    place: Address
    insn: Insn | None


@dataclass(slots=True)
class _Fitting:
    """The ladder on its way into a family.

    used: the places that something stands for already.  after: rungs that a box leaves to follow its own.
    """

    dialect: Dialect
    table: dict[str, str] = field(default_factory=dict)
    boxes: dict[str, _Timed] = field(default_factory=dict)
    configuration: list[str] = field(default_factory=list)
    used: set[str] = field(default_factory=set)
    after: list[Rung] = field(default_factory=list)
    number: int = 0

    def refuse(self, why: Text) -> NoReturn:
        """Say why a rung does not fit."""
        said = Text("第{n}级在{family}里没有对应：{why}。", "Rung {n} has no counterpart in {family}: {why}.")
        raise NotRepresentableError(said.format(n=self.number + 1, family=self.dialect.title, why=why))

    def survey(self, ladder: Ladder) -> None:
        """Give every address and every box its place; names without an address take what is left of the memory bits."""
        names: dict[str, int] = {}
        for self.number, one in enumerate(ladder.rungs):
            for symbol in one.symbols:
                if isinstance(symbol, Box):
                    self.timed(symbol)
                elif isinstance(symbol, Contact | Coil) and not self.located(symbol.address):
                    names.setdefault(symbol.address, self.number)
        for name, self.number in names.items():
            if name.partition(".")[0] not in self.boxes:
                self.table[name] = self.free(self.area("memory"), range(10_000)).text

    def located(self, word: str) -> bool:
        """Give an address its place in the family; a name has none yet."""
        found = self.dialect.address(word)
        match = ADDRESS.fullmatch(word)
        if match and not isinstance(found, Address):
            area = self.area(_USES[match[1]])
            first, *rest = map(int, match[2].split("."))
            index = first * _BYTE + rest[0] if rest else first
            fits = area.holds(index) and len(rest) < 2 and not (rest and rest[0] >= _BYTE)  # noqa: PLR2004 (byte and bit)
            found = area.address(index) if fits else None
            if found is None:
                self.refuse(Text(f"没有与{word}对应的位", f"there is no bit for {word}"))
        if isinstance(found, Address):
            self.table[word] = found.text
            self.used.add(found.text)
        return isinstance(found, Address)

    def area(self, use: Use) -> Area:
        """Give the family's area for a use."""
        prefix = self.dialect.counterparts.get(use)
        return next(area for area in self.dialect.areas if area.prefix == prefix)

    def free(self, area: Area, numbers: range) -> Address:
        """Take the first place of an area that nothing stands for."""
        for index in numbers:
            if area.holds(index) and area.address(index).text not in self.used:
                self.used.add(area.address(index).text)
                return area.address(index)
        return self.refuse(Text(f"{area.title.zh}不够用", f"there are not enough {area.title.en}"))

    # timers and counters

    def timed(self, box: Box) -> None:
        """Give a timer or counter its place, and its configuration line where the family has them."""
        kind, name, preset = boxed(box, self.number)
        if name in self.boxes:
            self.refuse(Text(f"{name}在两处出现", f"{name} stands in two places"))
        use: Use = "timer" if "IN" in INPUTS[kind] else "counter"
        area = self.area(use)
        block = next(one for one in self.dialect.blocks if one.area == area.prefix)
        insn = None if block.settings else self.driving(kind, area)
        numbers, count = self.bank(block, preset) if use == "timer" else (range(block.most), self.count(preset))
        place = self.free(area, numbers)
        if block.settings:
            self.configuration.append(f"{place.text}: {self.settings(block, kind, preset)}")
            count = count if use == "counter" else 0
        elif not 0 < count <= block.most:
            self.too_long(preset)
        self.boxes[name] = _Timed(kind, count, place, insn)
        self.table[name] = place.text

    def driving(self, kind: str, area: Area) -> Insn:
        """Find the instruction that does what a box of the standard does."""
        wanted = [_OPS.get(kind), "upto"] if kind == "CTU" else [_OPS.get(kind)]
        for op in wanted:
            for insn in self.dialect.insns:
                kinds = [self.dialect.kinds.get(operand.kind) for operand in insn.operands]
                if insn.does == {"drive"} and insn.then[0].op == op and kinds[0] and area.prefix in kinds[0].areas:
                    return insn
        return self.refuse(Text(f"没有{kind}", f"there is no {kind}"))

    def bank(self, block: Block, preset: str) -> tuple[range, int]:
        """Give the numbers whose time base measures a time, the coarsest first, and how many of its ticks it is."""
        time = milliseconds(preset)
        if time is None:
            self.refuse(Text(f"预设值{preset}不是时间常数", f"the preset {preset} is no constant time"))
        if block.settings:
            return range(block.banks[0].first, block.banks[0].last + 1), 0
        for bank in sorted(block.banks, key=lambda one: (-one.base, one.first)):
            if not bank.retains and time % bank.base == 0 and 0 < time // bank.base <= block.most:
                return range(bank.first, bank.last + 1), int(time // bank.base)
        return self.too_long(preset)

    def too_long(self, preset: str) -> NoReturn:
        """Say that a preset cannot be set."""
        self.refuse(Text(f"预设值{preset}放不进去", f"the preset {preset} cannot be set"))

    def count(self, preset: str) -> int:
        """Give a counter's preset."""
        if not preset.isdigit():
            self.refuse(Text(f"预设值{preset}不是数", f"the preset {preset} is no number"))
        return int(preset)

    def settings(self, block: Block, kind: str, preset: str) -> str:
        """Write what a configuration line says of a block."""
        known = block.settings or {}
        most = known[block.preset].last
        if "TYPE" not in known:
            if kind not in _OPS:
                self.refuse(Text(f"没有{kind}", f"there is no {kind}"))
            return f"{block.preset}={preset}" if int(preset) <= most else self.too_long(preset)
        time = milliseconds(preset) or Fraction(0)
        word = next((word for word, op in (known["TYPE"].choices or {}).items() if op == _OPS[kind]), None)
        for base, size in (known["TB"].choices or {}).items():
            if word and time % int(size) == 0 and time // int(size) <= most:
                return f"TYPE={word} TB={base} {block.preset}={time // int(size)}"
        return self.too_long(preset)

    # symbols

    def node(self, node: Node) -> Node:
        """Fit contacts."""
        match node:
            case Contact(address):
                name, _, bit = address.partition(".")
                if address not in self.table and name in self.boxes:
                    return self.reached(node, self.boxes[name], bit)
                return Contact(self.table[address], node.negated, node.edge, node.immediate)
            case Series(parts):
                return series(*map(self.node, parts))
            case Parallel(parts):
                return parallel(*map(self.node, parts))
        return node

    def reached(self, contact: Contact, timed: _Timed, bit: str) -> Node:
        """Give what says that a timer or counter has come to its end: its own bit, or its count compared."""
        place = timed.place
        block = self.dialect.block(place)
        if bit != "Q" or block is None:
            self.refuse(Text(f"{contact.address}没有对应的位", f"nothing is there for {contact.address}"))
        if timed.kind not in {"CTU", "CTD"} or timed.insn:
            text = f"{place.text}.{block.bit}" if block.bit else place.text
            return Contact(text, contact.negated, contact.edge)
        if contact.edge:
            self.refuse(Text("比较没有沿", "a comparison has no edge"))
        wanted = [(">=", timed.preset)] if timed.kind == "CTU" else [("=", 0), (">", timed.preset)]
        found = [
            Compared(f"{place.text}.V", _TURNED[sign] if contact.negated else sign, str(end))  # type: ignore[arg-type]
            for sign, end in wanted
        ]
        return series(*found) if contact.negated else parallel(*found)

    def out(self, out: Out) -> Out:
        """Fit a coil, a box, or a branch."""
        match out:
            case Branch(stem, outs):
                return branch(self.node(stem), *map(self.out, outs))
            case Coil(address, kind, count, immediate):
                return Coil(self.table[address], kind, count, immediate)
        return self.box(out)

    def box(self, box: Box) -> Box:
        """Fit a timer or counter, with a flow on every pin that its instruction has."""
        kind, name, _ = boxed(box, self.number)
        timed = self.boxes[name]
        first = box.entry or INPUTS[kind][0]
        pins = {pin: self.node(node) for pin, node in box.pins}
        if first != INPUTS[kind][0]:
            self.refuse(Text(f"{name}的{INPUTS[kind][0]}没有接", f"nothing leads to {INPUTS[kind][0]} of {name}"))
        if timed.insn is None:
            opener = next(insn.word for insn in self.dialect.insns if "open" in insn.does)
            known = self.dialect.block(timed.place)
            renamed = {
                ("S" if pin == "LD" and known and "S" in known.pins else pin): node for pin, node in pins.items()
            }
            return Box(f"{opener} {timed.place.text}", tuple(renamed.items()), first)
        letters = next(iter(self.dialect.constant)) if timed.insn.separator == self.dialect.separator else ""
        text = f"{timed.insn.word} {timed.place.text}{timed.insn.separator}{letters}{timed.preset}"
        wanted = [pin for pin, _ in timed.insn.then[0].pins[1:]]
        for pin in [one for one in pins if one not in wanted]:
            self.after.append(Rung(pins.pop(pin), (Coil(timed.place.text, "reset"),)))
        return Box(text, tuple((pin, pins.get(pin) or self.never()) for pin in wanted), first if wanted else "")

    def never(self) -> Contact:
        """Give a contact that is never closed."""
        off = self.dialect.special("off")
        return Contact(off) if off else Contact(self.dialect.special("on"), negated=True)
