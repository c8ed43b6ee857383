"""Writes what hangs on a node: coils, boxes, and branch points, where the flow is saved before the first path that changes it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.ladder import MOST_NESTED, Box, Branch, Coil, Edge, Invert, Rung, depth, in_series
from plcteach.core.text import Text
from plcteach.ladder.contacts import REASONS, Contacts
from plcteach.ladder.instructions import coil_word, flows
from plcteach.stl.section import CLOSE

if TYPE_CHECKING:
    from plcteach.core.ladder import Out
    from plcteach.core.program import Line
    from plcteach.core.spec import Role

_ON_THE_RAIL = Text(
    "线圈直接接在左母线上，前面至少要有一个触点", "a coil hangs on the left rail itself; a contact must come first"
)


class Lowering(Contacts):
    """Rungs with all that hangs on them."""

    def rung(self, drawn: Rung, number: int) -> None:
        """Write one rung."""
        self.number = number
        if depth(drawn) > MOST_NESTED:
            self.refuse(Text(f"嵌套超过{MOST_NESTED}层", f"it is nested deeper than {MOST_NESTED}"))
        rung = self.turn(drawn, number)
        sections = [one for one in rung.symbols if isinstance(one, Box) and self.opens(one)]
        if len(sections) > 1:
            self.refuse(Text("一级里只能有一个功能块", "a rung holds one function block"))
        for box in sections:
            first, _ = self.frame(box)
            self.put(first.text, first.insn, reason=REASONS["open"], of=box)
        if rung.stem is None:
            self.bare(rung.outs)
        else:
            self.begin(rung.stem, "load", at_rail=True)
            self.outs(rung.outs)

    def bare(self, outs: tuple[Out, ...]) -> None:
        """Write what hangs on the rail itself: a box that takes no flow, and what it gives power to by itself."""
        box, rest = outs[0], outs
        if isinstance(box, Box) and not (self.opens(box) or box.pins or box.word in self.dialect.patterns):
            if flows(self.read(box.text)[0].insn) != ():
                self.refuse(
                    Text(
                        f"{box.text}要有能流，左边至少要有一个触点",
                        f"{box.text} takes a flow, so a contact must come first",
                    )
                )
            self.whole(box)
            rest = outs[1:]
        powered = self.last is not None and self.last.powers
        if rest and not (powered and (rest is not outs or not self.dialect.networks_by_title)):
            self.refuse(_ON_THE_RAIL)
        if rest:
            self.outs(rest)

    def outs(self, outs: tuple[Out, ...]) -> None:
        """Write what hangs on a node whose value is on the top of the stack."""
        paths = [self.path(out) for out in outs]
        first = next((number for number, path in enumerate(paths) if isinstance(path, Branch)), len(paths))
        last = len(paths) - 1
        for number, path in enumerate(paths):
            if first < last and number >= first:
                role: Role = "push" if number == first else "pop" if number == last else "read"
                self.emit(self.insn(role), reason=REASONS[role])
            if isinstance(path, Coil):
                self.coil(path)
            elif isinstance(path, Box):
                self.box(path)
            else:
                self.onward(in_series(path.stem), "join_series", at_rail=True)
                self.outs(path.outs)

    def path(self, out: Out) -> Out:
        """Turn an inverted coil or a pulse coil into NOT or an edge, and a coil, where the family has no such coil."""
        if not isinstance(out, Coil) or out.kind not in {"not", "rise", "fall"}:
            return out
        if coil_word(self.dialect, out.kind, out.immediate) is not None:
            return out
        plain = replace(out, kind="")
        sign: Invert | Edge = Invert() if out.kind == "not" else Edge(out.kind == "rise")
        self.stand_in(plain, out)
        self.stand_in(sign, out, REASONS["invert" if out.kind == "not" else "pulse"])
        return Branch(sign, (plain,))

    # coils

    def coil(self, coil: Coil) -> None:
        """Write one coil, or several where an instruction takes only one bit at a time."""
        insn = coil_word(self.dialect, coil.kind, coil.immediate)
        if insn is None:
            sign = f"({coil.mark}{coil.address})"
            self.refuse(Text(f"没有线圈{sign}的指令", f"it has no instruction for the coil {sign}"))
        address = self.address(coil.address, insn)
        if self.dialect.area(address).role == "input":
            self.refuse(_input(coil.address))
        places = tuple(self.dialect.following(address, coil.count))
        if len(places) < coil.count:
            self.refuse(
                Text(
                    f"从{coil.address}起没有{coil.count}个位", f"there are not {coil.count} bits from {coil.address} on"
                )
            )
        if any(operand.number for operand in insn.operands):
            self.emit(insn, address, coil.count, of=coil)
        else:
            for place in places:
                self.emit(insn, place, of=coil)

    # boxes

    def box(self, box: Box) -> None:
        """Write a box whose first input is the flow on the top."""
        if self.opens(box):
            self.section(box)
            return
        if box.word in self.dialect.patterns:
            self.pattern(box)
            return
        insn = self.read(box.text)[0].insn
        wanted = flows(insn)
        if wanted is None or insn.powers:
            self.refuse(Text(f"{box.text}不是输出，不能画成框", f"{box.text} is no output, so it is no box"))
        if not wanted:
            self.refuse(
                Text(
                    f"{box.text}不看能流，要单独占一级", f"{box.text} takes no flow, so it stands on a rung of its own"
                )
            )
        self.pins(box, wanted)
        self.whole(box)

    def whole(self, box: Box) -> None:
        """Write the one instruction of a box, or the two that a box becomes which the list has none for."""
        lines = self.read(box.text)
        if len(lines) > 1 and box.word not in self.dialect.boxes:
            self.refuse(Text(f"“{box.text}”不止一条指令", f'"{box.text}" is more than one instruction'))
        for line in lines:
            self.put(line.text, line.insn, of=box)

    def pins(self, box: Box, wanted: tuple[str, ...]) -> None:
        """Write the further inputs of a box in the order in which its instruction takes them, the first lying deepest."""
        given = {name.upper(): node for name, node in box.pins}
        entry = box.entry.upper() or wanted[0]
        if entry != wanted[0] or sorted(wanted[1:]) != sorted(name.upper() for name, _ in box.pins):
            self.refuse(_pins(box, wanted))
        for name in wanted[1:]:
            before = len(self.lines)
            self.begin(given[name], "load", at_rail=True)
            self.lines[before] = replace(self.lines[before], reason=REASONS["pin"])

    def pattern(self, box: Box) -> None:
        """Write a box as the lines that its family's table gives for it."""
        names, rows = self.dialect.patterns[box.word]
        out = self.read(f"{self.insn('coil').mnemonic} {box.operands}")
        place = out[0].args[0]
        if len(out) > 1 or not isinstance(place, Address):
            self.refuse(Text(f"“{box.operands}”不是一个位", f'"{box.operands}" is not one bit'))
        if self.dialect.area(place).role == "input":
            self.refuse(_input(place.text))
        self.pins(box, tuple(names.split()))
        for row in rows.split("; "):
            (line,) = self.read(row.replace("OUT", place.text))
            self.put(line.text, line.insn, of=box)

    # blocks with a section

    def opens(self, box: Box) -> bool:
        """Say whether a box is a block with a section of its own (BLK … END_BLK)."""
        row = self.dialect.words.get(box.word)
        return row is not None and any(verb.name == "open" for verb in row.then)

    def frame(self, box: Box) -> tuple[Line, Line]:
        """Give the lines with which a block's section opens and closes."""
        first, *others = self.read(f"{box.text}\n{CLOSE}")
        if len(others) != 1:
            self.refuse(Text(f"“{box.text}”不止一条指令", f'"{box.text}" is more than one instruction'))
        return first, others[0]

    def section(self, box: Box) -> None:
        """Write the inputs of a block, each under its name, and the end of its section."""
        first, last = self.frame(box)
        place = first.args[0]
        block = self.dialect.block(place) if isinstance(place, Address) else None
        names = block.pins if block else ()
        entry = box.entry.upper() or (names[0] if len(names) == 1 else "")
        given = [entry, *(name.upper() for name, _ in box.pins)]
        if block is None or not set(given) <= set(names) or len(set(given)) < len(given):
            self.refuse(_pins(box, names))
        for name, node in [(entry, None), *box.pins]:
            if node is not None:
                self.begin(node, "load", at_rail=True)
            row = self.dialect.words[f"{name.upper()} {block.area}"]
            self.put(name.upper(), row, reason=REASONS["entry"], of=box)
        self.put(last.text, last.insn, reason=REASONS["close"], of=box)


def _input(word: str) -> Text:
    return Text(f"{word}是输入，程序不能写它", f"{word} is an input, which a program cannot write")


def _pins(box: Box, names: tuple[str, ...]) -> Text:
    """Say which inputs a box has, and which the drawing gives it."""
    given = [one for one in (box.entry, *(name for name, _ in box.pins)) if one]
    shown = f"{{{names[0]}: {box.text} }} {' '.join(f'{{{name}: }}' for name in names[1:])}" if names else box.text
    return Text(
        f"{box.text}的输入是{'、'.join(names)}，各一次，一行一个：{shown}；图里写的是{'、'.join(given) or '没有名字的输入'}",
        f"{box.text} has the inputs {', '.join(names)}, each once, a row each: {shown}; the drawing has "
        f"{', '.join(given) or 'an input without a name'}",
    )
