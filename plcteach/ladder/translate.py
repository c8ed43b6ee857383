"""A program of one family as a program of another: lifted to a ladder, every symbol mapped, and lowered again.

The addresses go by one visible table that stands on top of the text. What has no counterpart is named in the notes and left in
the text as a comment, and nothing is dropped without a word. Where the two families do the same thing at different moments of
a scan, a note says so.
"""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.errors import NotRepresentableError
from plcteach.core.ladder import Box, Branch, Coil, Compared, Contact, Edge, Ladder, Rung, symbols_of
from plcteach.core.text import NOTHING, Text, language
from plcteach.dialects import dialect as find_dialect
from plcteach.ladder.across import Across
from plcteach.ladder.edges import Edges
from plcteach.ladder.lift import lift
from plcteach.ladder.lower import listing, lower_lines
from plcteach.ladder.oneline import write_line
from plcteach.ladder.places import Places
from plcteach.ladder.translation import Translation
from plcteach.stl.reader import read
from plcteach.stl.writer import write

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping, Sequence

    from plcteach.core.ladder import Out
    from plcteach.core.program import Line, Program
    from plcteach.core.spec import Dialect


def translate(program: Program, to: str | Dialect) -> Translation:
    """Translate a program into another family; its own family gives it as it is."""
    if program.dialect == find_dialect(to):
        own = {place.text: place.text for line in program.lines for place in line.places}
        return Translation(write(program), program, own, ())
    lifted = lift(program)
    work = _Translating(program.dialect, find_dialect(to), lifted.ladder, program.settings)
    for one in program.diagnostics:
        if one.severity == "error":
            work.across.note(one.text.zh, one.text.en)
    covered: set[int] = set()
    first = 0
    for at, network in enumerate(program.networks):
        mine = [number for number, one in enumerate(lifted.rungs) if one.network == at]
        for number in mine:
            work.sources[number] = [[program.lines[row] for row in rows] for rows in lifted.rungs[number].sources]
            covered |= {row for rows in lifted.rungs[number].sources for row in rows}
            if not network.block:
                work.rung(number)
        lost = [line for row, line in enumerate(network.lines, first) if row not in covered and line.insn.then]
        first += len(network.lines)
        lost = list(network.lines) if network.block or not mine else lost
        rows = {line.span.row for line in lost}
        why = next((one.text for one in lifted.diagnostics if one.span.row in rows), _NO_LADDER)
        if lost:
            work.left(lost, _SUBROUTINE if network.block else why)
    return work.done()


_NO_LADDER = Text("这里画不成梯形图。", "it cannot be drawn as a ladder.")
_SUBROUTINE = Text("子程序不翻译。", "subroutines are not translated.")
_LEFT = Text("没有对应：", "no counterpart: ")


def translate_ladder(
    ladder: Ladder,
    dialect: str | Dialect,
    to: str | Dialect,
    settings: Mapping[str, Mapping[str, object]] | None = None,
) -> Translation:
    """Translate a ladder of one family into a program of another; settings: what its blocks are configured as."""
    work = _Translating(find_dialect(dialect), find_dialect(to), ladder, settings or {})
    for number in range(len(ladder.rungs)):
        work.rung(number)
    return work.done()


class _Translating:
    """The target's rungs so far, each with the comments that stand before it.

    counts: how often each address is named, in order of first appearance.  sources: for each rung of the source the lines that made it, as a note names them.
    """

    def __init__(
        self, source: Dialect, target: Dialect, ladder: Ladder, settings: Mapping[str, Mapping[str, object]]
    ) -> None:
        self.source, self.target, self.ladder = source, target, ladder
        self.counts = Counter(word for one in ladder.rungs for word in _words(source, one))
        self.places = Places(source, target, self.counts)
        self.across = Across(self.places, settings)
        self.sources: dict[int, list[list[Line]]] = {}
        self.edges = Edges(self.places, frozenset())
        self.rungs: list[Rung] = []
        self.comments: dict[int, list[str]] = {}
        self.merged: set[int] = set()
        self.prepare()

    def prepare(self) -> None:
        """Choose the numbers of all timers and counters first, for contacts above may read them."""
        for one in self.ladder.rungs:
            for box in one.symbols:
                if isinstance(box, Box):
                    self.chosen(box)
        for number, one in enumerate(self.ladder.rungs):
            self.merge(number, one)
        memories = {
            one.memory
            for rung in self.ladder.rungs
            for one in rung.symbols
            if isinstance(one, Edge) and one.memory and self.counts[one.memory] == 1
        }
        self.edges.kept = frozenset(self.places.bit(memory)[0] for memory in memories)

    def chosen(self, box: Box) -> None:
        lines = self.across.lines(box)
        line = next(iter(lines), None)
        verb = next(iter(line.insn.then), None) if line else None
        if line is None or verb is None or verb.name not in {"drive", "pin", "open"}:
            return
        place = line.args[0]
        block = self.source.block(place) if isinstance(place, Address) else None
        try:
            if block and block.rule == "timer" and isinstance(place, Address):
                self.across.plan_timer(line, place) if place.text not in self.across.texts else None
            elif block and block.rule == "counter" and isinstance(place, Address) and verb.op not in {"down", "updown"}:
                self.across.plan_counter(line, place)
        except NotRepresentableError:
            self.places.table.pop(place.text if isinstance(place, Address) else "", None)

    def merge(self, number: int, one: Rung) -> None:
        """Take the one reset of a counter that stands right beside it as its reset input."""
        box = one.outs[0]
        line = next(iter(self.across.lines(box)), None) if isinstance(box, Box) and len(one.outs) == 1 else None
        if (
            line is None
            or not line.insn.then
            or line.insn.then[0].op != "upto"
            or not isinstance(line.args[0], Address)
        ):
            return
        place = line.args[0].text
        resets = [
            at for at, rung in enumerate(self.ladder.rungs) for each in rung.symbols if each == Coil(place, "reset")
        ]
        if len(resets) != 1 or abs(resets[0] - number) != 1:
            return
        reset = self.ladder.rungs[resets[0]]
        if reset.stem is None or reset.outs != (Coil(place, "reset"),):
            return
        self.across.resets[place] = reset.stem
        self.merged.add(resets[0])
        if resets[0] < number and not self.across.stops():
            self.across.note(
                f"{place}：复位有效时来的计数沿，{self.source.title.zh}还计1，{self.target.title.zh}不计。",
                f"{place}: an edge that comes while the reset is on still counts 1 in {self.source.title.en}, and does not in {self.target.title.en}.",
            )

    def rung(self, number: int) -> None:
        """Translate one rung, or say why it has no counterpart."""
        one = self.ladder.rungs[number]
        if number in self.merged and not self.across.stops():
            return
        if number in self.merged:
            self.across.resets.clear()
        self.across.after = []
        before = len(self.rungs)
        try:
            made = [*self.crossed(one, number), *self.across.after]
            for rung in made:
                self.rungs += self.edges.rungs(rung)
            lower_lines(Ladder(tuple(self.rungs[before:])), self.target)
        except NotRepresentableError as reason:
            del self.rungs[before:]
            self.left(self.behind(number, one), reason.reason)

    def crossed(self, one: Rung, number: int) -> Iterator[Rung]:
        """Give the rung with all that has a counterpart."""
        one = _counting(one)
        stem = None if one.stem is None else self.across.node(one.stem)
        outs = self.outs(one.outs, number, alone=len(one.outs) == 1)
        if outs:
            yield Rung(stem, tuple(outs), one.title)

    def outs(self, outs: tuple[Out, ...], number: int, *, alone: bool) -> list[Out]:
        """Give what hangs on a node; what has no counterpart is left out and named."""
        found: list[Out] = []
        for out in outs:
            try:
                found += self.out(out, number, alone=alone)
            except NotRepresentableError as reason:
                self.left(self.behind(number, out), reason.reason)
        return found

    def out(self, out: Out, number: int, *, alone: bool) -> list[Out]:
        match out:
            case Branch(stem, outs):
                node = self.across.node(stem)
                inner = self.outs(outs, number, alone=False)
                return [Branch(node, tuple(inner))] if inner else []
            case Coil():
                return self.across.coil(out)
        if any(
            verb.name == "end" and verb.formula is None for line in self.across.lines(out) for verb in line.insn.then
        ):
            return [Box(self.target.roles["end"])] if "end" in self.target.roles else []
        return self.across.box(out, alone=alone)

    def left(self, lost: Iterable[Line | str], why: Text) -> None:
        """Leave something out, with a comment where it would stand and a note."""
        lines = list(lost)
        texts = [line if isinstance(line, str) else line.text for line in lines]
        rows = sorted({line.span.row for line in lines if not isinstance(line, str)})
        at = Text(f"第{'、'.join(map(str, rows))}行", f"line {', '.join(map(str, rows))}") if rows else NOTHING
        told = "; ".join(texts)
        self.across.note(
            f"{at.zh}{'：' if rows else ''}{told}没有写出来。{why.zh}",
            f"{at.en}{': ' if rows else ''}{told} is left out: {why.en}",
        )
        here = self.comments.setdefault(len(self.rungs), [])
        here += [f"{_LEFT.in_(language())}{text}" for text in texts]

    def behind(self, number: int, part: Rung | Out) -> Sequence[Line | str]:
        """Give the lines that made a part of a rung; the part itself, where it comes from a drawing."""
        made = self.sources.get(number)
        ids = {id(one) for one in symbols_of(part)}
        numbers = [at for at, one in enumerate(self.ladder.rungs[number].symbols) if id(one) in ids]
        if not made or not numbers:
            return [_said(part)]
        if isinstance(part, Box) and len(made[numbers[-1]]) == 1:
            return [*made[numbers[-1]]]
        rows = {id(line): line for at in numbers for line in made[at]}
        return sorted(rows.values(), key=lambda line: line.span)

    # the text

    def done(self) -> Translation:
        """Put everything together."""
        self.rungs[:0] = self.edges.top
        moved = len(self.edges.top)
        comments = {at + moved: rows for at, rows in self.comments.items()}
        rows = [*(f"// {old} -> {new}" for old, new in self.addresses().items()), *self.across.configuration]
        rows += listing(self.rungs, self.target, lower_lines(Ladder(tuple(self.rungs)), self.target), comments)
        rows += [f"// {row}" for row in comments.get(len(self.rungs), [])]
        text = "".join(f"{row}\n" for row in rows)
        return Translation(text, read(text, self.target), self.addresses(), tuple(self.across.notes))

    def addresses(self) -> dict[str, str]:
        """Give the table in order of first appearance."""
        table = self.places.table
        return {word: table[word] for word in [*self.counts, *table] if word in table}


def _said(out: Out | Rung) -> str:
    if isinstance(out, Rung):
        return write_line(out)
    if isinstance(out, Box):
        return out.text
    return f"({out.mark}{out.address})" if isinstance(out, Coil) else write_line(Rung(out.stem, out.outs))


def _counting(one: Rung) -> Rung:
    """Give a block's rung with the input that counts as the one on the left."""
    box = one.outs[0]
    if len(one.outs) > 1 or not isinstance(box, Box) or box.entry == "CU" or one.stem is None:
        return one
    pins = {box.entry: one.stem, **dict(box.pins)}
    if "CU" not in pins or not box.entry:
        return one
    rest = tuple((name, node) for name, node in pins.items() if name != "CU")
    return Rung(pins["CU"], (Box(box.text, rest, "CU"),), one.title)


def _words(dialect: Dialect, one: Rung) -> Iterator[str]:
    """Give every address of a rung in order of appearance, and each bit that a coil over several reaches."""
    for symbol in one.symbols:
        match symbol:
            case Contact(address):
                yield address
            case Edge(_, memory) if memory:
                yield memory
            case Compared(left, _, right):
                yield from (word for word in (left, right) if isinstance(dialect.address(word), Address))
            case Coil(address, _, count):
                place = dialect.address(address)
                yield from (each.text for each in dialect.following(place, count)) if isinstance(place, Address) else ()
            case Box(text):
                yield from _named(dialect, text)


def _named(dialect: Dialect, text: str) -> Iterator[str]:
    lines = read(text, dialect).lines
    for line in lines:
        for place in line.places:
            yield place.text
