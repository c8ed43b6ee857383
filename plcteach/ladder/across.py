"""Maps the boxes of a ladder from one family to another: timers, counters, moves and sums, and what both families have.

An up-counter with a reset is a box of two inputs in one family, two instructions
in another, and a block in the third; what differs at the edges of that is said.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.block import Bank
from plcteach.core.effect import Edge as Risen
from plcteach.core.ladder import Box, Branch, Coil, Compared, Contact, Edge, Rung, series
from plcteach.core.program import Assign, Value
from plcteach.ladder.places import none
from plcteach.ladder.sums import Sum, summed
from plcteach.ladder.timing import Timing
from plcteach.stl.reader import read
from plcteach.stl.section import CLOSE

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.ladder import Node, Out
    from plcteach.core.program import Line, Source
    from plcteach.core.spec import Use
    from plcteach.core.verb import Verb
    from plcteach.ladder.places import Places

_MOST = 9_999
_COURSE = {
    "jump",
    "label",
    "loop",
    "next",
    "master",
    "restore",
    "step",
    "segment",
    "transfer",
    "rail",
    "return",
    "stop",
    "end",
}
"""Verbs that decide whether other lines are executed or powered."""


class Across(Timing):
    """Boxes of the target for boxes of the source.

    after: rungs that follow the one just written.  resets: for a counter what leads to its one reset.
    """

    def __init__(self, places: Places, settings: Mapping[str, Mapping[str, object]]) -> None:
        super().__init__(places, settings)
        self.after: list[Rung] = []
        self.resets: dict[str, Node] = {}

    # what a box is

    def lines(self, box: Box) -> tuple[Line, ...]:
        """Read a box as the source does."""
        opens = any(verb.name == "open" for row in [self.source.words.get(box.word)] if row for verb in row.then)
        return read(f"{box.text}\n{CLOSE}" if opens else box.text, self.source).lines

    def box(self, box: Box, *, alone: bool) -> list[Out]:
        """Give what a box becomes at the same place; `alone`: nothing else hangs on its rung."""
        lines = self.lines(box)
        if not lines:
            none(f"{box.text}读不成指令", f"{box.text} does not read as an instruction")
        line = lines[0]
        verb = next(iter(line.insn.then), None)
        if verb and verb.name in {"drive", "pin", "open"} and isinstance(place := line.args[0], Address):
            block = self.source.block(place)
            rule = block.rule if block else ""
            if rule == "timer" and not box.pins:
                return self.timer(line, place)
            if rule == "counter":
                return self.counter(box, line, place, alone=alone)
        if verb and verb.name == "work":
            return self.sum(line, verb)
        return self.alike(box, line)

    def alike(self, box: Box, line: Line) -> list[Out]:
        """Give the same instruction where the target has it."""
        row = self.target.words.get(line.insn.mnemonic)
        if row is None or (row.then, row.effect) != (line.insn.then, line.insn.effect):
            course = any(verb.name in _COURSE for verb in line.insn.then)
            none(
                f"{self.target.title.zh}没有{box.text}的对应写法。{'本来由它控制的部分现在总是执行。' if course else ''}",
                f"{self.target.title.en} has no counterpart of {box.text}. {'What it controlled now always runs.' if course else ''}".strip(),
            )
        words = [
            str(arg) if isinstance(arg, int) else self.operand(arg) if isinstance(arg, Address | Value) else ""
            for arg in line.args
        ]
        pins = tuple((name, self.node(node)) for name, node in box.pins)
        return [Box(f"{row.word} {row.separator.join(words)}".strip(), pins, box.entry)]

    def operand(self, arg: Source) -> str:
        """Give an operand of an instruction that both families have."""
        if isinstance(arg, Address) and self.source.block(arg) and arg.text in self.places.table:
            return self.places.table[arg.text]
        return self.places.bit(arg.text)[0] if isinstance(arg, Address) and arg.size == 1 else self.word(arg)

    # counters

    def counter(self, box: Box, line: Line, place: Address, *, alone: bool) -> list[Out]:
        """Give an up-counter with its reset."""
        verb = line.insn.then[0]
        kind = verb.op if verb.name in {"drive", "pin"} else "block"
        if kind == "R" and not box.pins:
            return [self.block_coil(Coil(place.text, "reset"), place)]
        if kind in {"down", "updown"}:
            return self.alike_counter(box, line, place)
        if kind not in {"up", "upto", "CU", "block"} or (kind == "upto" and self.source.bank(place).size > 16):  # noqa: PLR2004
            none(f"{box.text}没有对应的计数器", f"there is no counter that does what {box.text} does")
        pins = {name.upper(): node for name, node in box.pins}
        if kind == "block" and (box.entry != "CU" or set(pins) - {"R"}):
            none(f"{box.text}没有对应的计数器", f"there is no counter that does what {box.text} does")
        self.plan_counter(line, place)
        reset = pins.get("R") or self.resets.get(place.text)
        return self.counted(place, self.node(reset) if reset else None, alone=alone)

    def alike_counter(self, box: Box, line: Line, place: Address) -> list[Out]:
        """Give a counter that the other family has under the same name."""
        self.places.number("counter", place.text, self.banks("counter"))
        return self.alike(box, line)

    def banks(self, use: Use) -> list[Bank]:
        """Give the banks of the target's counters that are 16 bits wide."""
        area = self.target.counterparts.get(use)
        block = next((one for one in self.target.blocks if one.area == area), None)
        last = next((int(one.ranges[-1][1]) for one in self.target.areas if one.prefix == area), 0)
        found = [bank for bank in (block.banks if block else ()) if bank.size == 16]  # noqa: PLR2004
        return found or [Bank(0, last)]

    def preset(self, line: Line, place: Address) -> Source | int:
        """Give what a counter counts to."""
        verb = line.insn.then[0]
        return line.bound[verb.sources[0]] if verb.name == "drive" else int(self.setting(place, "P"))  # type: ignore[return-value]

    def plan_counter(self, line: Line, place: Address) -> None:
        """Choose a number, a preset, and what is read for its output."""
        if place.text in self.texts:
            return
        number = self.places.number("counter", place.text, self.banks("counter"))
        preset = self.preset(line, place)
        count = preset.number if isinstance(preset, Value) else preset
        whole = self.target.address(number)
        block = self.target.block(whole) if isinstance(whole, Address) else None
        mine = self.source.block(place)
        if block and block.settings:
            if isinstance(count, Address) or not 0 <= int(count) <= _MOST:
                none(f"{place.text}的预设值没有对应的写法", f"there is no way to write the preset of {place.text}")
            self.configuration.append(f"{number}: P={int(count)}")
            self.texts[place.text] = number
            return
        text = self.word(count) if isinstance(count, Address) else self.number(int(count))
        if mine and mine.settings:
            value = number if self.target.area(whole).value else f"{number}.V"  # type: ignore[arg-type]
            self.compared_bits[f"{place.text}.D"] = Compared(value, "=", text)
            self.note(
                f"{place.text}.D写成比较；{self.source.title.zh}的计数值过了9999回到0，{self.target.title.zh}的不回。",
                f"{place.text}.D is a comparison now; its count goes from 9999 back to 0 in {self.source.title.en}, and does not in {self.target.title.en}.",
            )
            text = self.number(_MOST) if self.stops() else text
        self.texts[place.text] = f"{number} {text}"

    def stops(self) -> bool:
        """Say whether the target's counters stay at their preset."""
        return any(verb.op == "upto" for row in self.target.insns for verb in row.then)

    def counted(self, place: Address, reset: Node | None, *, alone: bool) -> list[Out]:
        """Give the counter where its count input is the flow."""
        number, _, preset = self.texts[place.text].partition(" ")
        row = next((one for one in self.target.insns for verb in one.then if verb.op in {"up", "upto"}), None)
        if row is None:
            return self.section(place, number, reset)
        text = f"{row.word} {row.separator.join((number, preset))}"
        if row.then[0].op == "upto":
            if reset is not None:
                self.after.append(Rung(reset, (Coil(number, "reset"),)))
            return [Box(text)]
        word, inverse = self.places.known("on")
        box = Box(text, (("R", reset or Contact(word, negated=not inverse)),), "CU")
        if alone:
            return [box]
        bit = self.places.fresh()
        self.after.append(Rung(Contact(bit), (box,)))
        return [Coil(bit)]

    def section(self, place: Address, number: str, reset: Node | None) -> list[Out]:
        """Give a block that counts pulses, none of them once the preset is reached, so that its output stays."""
        memory, pulse = self.places.fresh(), self.places.fresh()
        done = self.places.output(number)
        pins = (("R", reset),) if reset is not None else ()
        if self.source.block(place) == self.target.block(self.target.address(number)):  # type: ignore[arg-type]
            return [Box(f"BLK {number}", pins, "CU")]
        self.after.append(Rung(Contact(pulse), (Box(f"BLK {number}", pins, "CU"),)))
        self.compared_bits.pop(place.text, None)
        here = series(Contact(memory, negated=True), Contact(done, negated=True))
        return [Branch(here, (Coil(pulse),)), Coil(memory)]

    # words

    def sum(self, line: Line, verb: Verb) -> list[Out]:
        """Give a move or a sum."""
        given = next((arg for arg in line.args if isinstance(arg, Assign)), None)
        if given:
            one = Sum(given.op, given.sources, given.target)
        else:
            target = line.bound.get(verb.target)
            sources = tuple(line.bound[name] for name in verb.sources)
            if not isinstance(target, Address) or not all(isinstance(each, Address | Value) for each in sources):
                none(f"{line.text}没有对应的写法", f"there is no counterpart of {line.text}")
            one = Sum(verb.op, sources, target)  # type: ignore[arg-type]
        widths = {self.source.kinds[each.kind].size for each in line.insn.operands if each.kind}
        real = any(self.source.kinds[each.kind].real for each in line.insn.operands if each.kind)
        texts = None if real or len(widths) > 1 else summed(self.target, one, max(widths), self.word)
        if texts is None:
            return self.alike(Box(line.text), line)
        if one.rule != "move" and self.source.wraps != self.target.wraps:
            self.note(
                "运算结果放不下时，两个系列的处理不同（一个截断，一个不写）。",
                "A sum that has no room is cut off in one of the two families and not written in the other.",
            )
        boxes: tuple[Out, ...] = tuple(Box(text) for text in texts)
        return [Branch(Edge(), boxes)] if isinstance(verb.formula, Risen) else list(boxes)
