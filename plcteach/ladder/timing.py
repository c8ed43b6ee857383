"""Maps timers from one family to another, each with the same time.

A timer keeps its kind, its time and its time base if the other family has numbers with that base; an off-delay is built from
an on-delay where it must be, which is exact.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.ladder import Box, Branch, Coil, Contact, Invert, series
from plcteach.core.program import Value
from plcteach.ladder.crossing import Crossing
from plcteach.ladder.places import lacking

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from plcteach.core.block import Bank, Block, Setting
    from plcteach.core.insn import Insn
    from plcteach.core.ladder import Out
    from plcteach.core.program import Line, Source
    from plcteach.ladder.places import Places


@dataclass(frozen=True, slots=True)
class Way:
    """One way to write a timer in the target: its instruction, a bank of numbers, its time base, and the ends of its preset."""

    row: Insn
    bank: Bank
    base: int
    ends: tuple[int, int]
    type: str = ""
    base_word: str = ""


class Timing(Crossing):
    """Timers of the target for timers of the source, and the lines that configure its blocks.

    settings: what the source's configuration says.  texts: for each timer or counter how its instruction is written.
    """

    def __init__(self, places: Places, settings: Mapping[str, Mapping[str, object]]) -> None:
        super().__init__(places)
        self.settings = settings
        self.configuration: list[str] = []
        self.texts: dict[str, str] = {}

    def setting(self, place: Address, name: str) -> int | str:
        """Give what the configuration says of a block, or its default."""
        block = self.source.block(place)
        if block is None or not block.settings:
            return ""
        setting: Setting = block.settings[name]
        said = self.settings.get(place.text, {}).get(name, setting.default)
        return setting.choices[str(said)] if setting.choices else int(str(said))

    def timing(self, line: Line, place: Address) -> tuple[str, int, Source | int]:
        """Give a timer's rule, time base and preset."""
        verb = line.insn.then[0]
        if verb.name == "drive":
            bank = self.source.bank(place)
            return bank.rule(verb.op), bank.base, line.bound[verb.sources[0]]  # type: ignore[return-value]
        return str(self.setting(place, "TYPE")), int(self.setting(place, "TB")), int(self.setting(place, "P"))

    def timer(self, line: Line, place: Address) -> list[Out]:
        """Give the timer with the same time."""
        if place.text not in self.texts:
            self.plan_timer(line, place)
        box = Box(self.texts[place.text])
        held = self.held_bits.get(place.text)
        if not held:
            return [box]
        number = self.places.table[place.text]
        off = Branch(Contact(self.places.output(number)), (Coil(held, "reset"),))
        return [Coil(held, "set"), Branch(series(Invert(), Contact(held)), (box, off))]

    def plan_timer(self, line: Line, place: Address) -> None:
        """Choose a number and a preset in the target."""
        rule, base, preset = self.timing(line, place)
        ways = list(self.ways(rule))
        if not ways and rule == "off":
            ways = list(self.ways("on"))
            self.held_bits[place.text] = self.places.fresh() if ways else ""
        way, number = self.fitting(place, ways, base, preset)
        text = self.places.number("timer", place.text, [way.bank])
        if way.type:
            self.configuration.append(f"{text}: TYPE={way.type} TB={way.base_word} P={number}")
            self.texts[place.text] = f"{way.row.word} {text}"
        else:
            self.texts[place.text] = f"{way.row.word} {way.row.separator.join((text, number))}"
        self.timed(place, way)

    def ways(self, rule: str) -> Iterator[Way]:
        """Give every way in which the target has timers of a rule, its own instruction for it before others."""
        block = next((one for one in self.target.blocks if one.area == self.target.counterparts.get("timer")), None)
        for row in sorted(self.target.insns, key=lambda one: [verb.op for verb in one.then] != [rule]):
            verb = next(iter(row.then), None)
            if block is None or verb is None or not row.operands or row.operands[0].number:
                continue
            if block.area not in self.target.kinds[row.operands[0].kind].areas:
                continue
            if verb.name == "drive":
                ends = self.target.kinds[row.operands[1].kind].ends or (0, 0)
                for bank in block.banks:
                    if bank.rule(verb.op) == rule and bank.retains == (rule == "retentive"):
                        yield Way(row, bank, bank.base, ends)
            elif verb.name == "pin" and block.settings:
                yield from _configured(row, block, rule)

    def fitting(self, place: Address, ways: list[Way], base: int, preset: Source | int) -> tuple[Way, str]:
        """Choose the way that keeps the time, if it can with the same base."""
        number = preset.number if isinstance(preset, Value) else preset
        best = sorted(ways, key=lambda way: (way.base != base, -way.base))
        for way in best:
            if isinstance(number, Address):
                if way.base == base and not way.type:
                    return way, self.word(number)
                continue
            total = int(number) * base
            if total % way.base == 0 and way.ends[0] <= total // way.base <= way.ends[1]:
                count = total // way.base
                return way, f"{count}" if way.type else self.number(count)
        why = lacking(f"没有和{place.text}同样的定时器", f"there is no timer that does what {place.text} does")
        raise why

    def timed(self, place: Address, way: Way) -> None:
        """Say where the two change a timer's bit at different moments of a scan."""
        here, there = self.source.bank(place).when, way.bank.when
        if here != there:
            self.note(
                f"定时器的位：{_WHEN[here][0]}（{self.source.title.zh}），{_WHEN[there][0]}（{self.target.title.zh}），所以可能相差一次扫描。",
                f"A timer's bit changes {_WHEN[here][1]} in {self.source.title.en}, and {_WHEN[there][1]} in {self.target.title.en}, so it may come a scan earlier or later.",
            )


_WHEN = {
    "scan": ("在扫描开始时变", "at the start of the scan"),
    "line": ("在执行到它的指令时变", "where its instruction is executed"),
    "always": ("随时会变", "at any moment of the scan"),
}


def _configured(row: Insn, block: Block, rule: str) -> Iterator[Way]:
    """Give the ways of a block whose kind and time base its configuration says."""
    kinds, bases, preset = ((block.settings or {})[name] for name in ("TYPE", "TB", "P"))
    word = next((name for name, meant in (kinds.choices or {}).items() if meant == rule), "")
    for base_word, base in (bases.choices or {}).items():
        if word:
            yield Way(row, block.banks[0], int(base), (preset.first, preset.last), word, base_word)
