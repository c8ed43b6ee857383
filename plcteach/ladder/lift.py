"""Lifts an instruction list to a ladder: the machine's own step, run over pieces of ladder, and what it leaves drawn as rungs.

Whatever is no ladder is said and left out, and everything else is there. A flow that parts at a branch point keeps its node,
because a branch instruction copies the same piece: drawing the stem twice instead would be wrong wherever an earlier branch
writes a bit that the stem reads. Where the list itself reads a bit once and the drawing needs it twice, that is looked at.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.diagnostic import few, rule
from plcteach.core.ladder import MOST_NESTED
from plcteach.ladder.editor import remarks
from plcteach.ladder.growth import Drawn, Read, grown
from plcteach.ladder.lifted import Growth, Lifted, LiftedRung
from plcteach.ladder.outputs import Output, Outputs, remembers
from plcteach.ladder.piece import MOST_DRAWN, Page, Piece, leaf, settled
from plcteach.ladder.rungs import Drawing, Ground, NoLadderError
from plcteach.ladder.sketch import Sketch
from plcteach.ladder.trie import Fault, Group, Trie
from plcteach.machine.step import Stacks, Step, step

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.program import Line, Network, Program

__all__ = ["Growth", "Lifted", "LiftedRung", "lift"]


def lift(program: Program) -> Lifted:
    """Give the ladder of a program: its rungs, what is no ladder and why, and how the ladder grows line by line."""
    work = _Lifting(program)
    for number, network in enumerate(program.networks):
        work.network(network, number)
    growth = grown(work.reads, work.rungs, work.places, work.drawn)
    work.found += _unseen(program, work, growth)
    found = tuple(few(sorted(work.found, key=lambda one: one.span)))
    return Lifted(program, tuple(work.rungs), found, tuple(growth))


class _Lifting:
    """The ladder while the list is being read.

    reads: what each line leaves on the top, and what it joins.  places: the symbol of each line that makes a coil or box.
    """

    def __init__(self, program: Program) -> None:
        self.program, self.dialect = program, program.dialect
        self.page = Page()
        self.world = Sketch(self.dialect, self.page)
        self.blank = leaf(self.page, None)
        self.rungs: list[LiftedRung] = []
        self.found: list[Diagnostic] = []
        self.reads: list[Read] = []
        self.places: dict[int, tuple[int, int]] = {}
        self.drawn = Drawn()

    def network(self, network: Network, number: int) -> None:
        """Lift one network; what other networks have left on the stack is nothing that a ladder shows."""
        first = len(self.reads)
        outputs = self.read(network)
        trie = Trie()
        for output in outputs:
            trie.add(output)
        ground = Ground(self.dialect, self.program.lines, outputs)
        title, said = network.title, len(self.found)
        for group in trie.groups:
            title = "" if self.draw(ground, group, number, title) else title
        if len(self.found) == said:
            self.unseen(network, first, ground)
        if self.dialect.shows_rungs:
            self.found += remarks(self.dialect, network, first, trie.groups)

    def read(self, network: Network) -> list[Output]:
        """Run the lines of a network, and give its outputs."""
        stacks: Stacks[Piece] = tuple(
            (self.blank,) * shape.depth if shape.fixed else () for shape in self.dialect.shapes
        )
        outputs, made = Outputs(self.dialect, self.blank), list[Output]()
        for line in network.lines:
            self.page.line = len(self.reads)
            one = step(line, self.dialect.shapes, stacks, self.world, self.blank, number=self.page.line)
            stacks = self.after(one)
            output = outputs.of(one)
            if output:
                output.index = len(made)
                made.append(output)
            self.reads.append((stacks[0][0] if stacks[0] else None, _joined(one)))
        return made

    def after(self, one: Step[Piece]) -> Stacks[Piece]:
        """Give the stacks after a line, the top being a cell now and no bit just read."""
        main, *others = one.after
        if not main:
            return one.after
        top = settled(main[0])
        if remembers(self.dialect, one.line):
            top = self.edge(one.line, one.before[0][0] if one.before[0] else self.blank)
        return one.after if top is main[0] else ((top, *main[1:]), *others)

    def edge(self, line: Line, flow: Piece) -> Piece:
        rising = self.dialect.parts[line.insn.mnemonic] == "rise"
        memory = next((place.text for place in line.bits), "")
        return flow.remembered(memory, rising=rising)

    def unseen(self, network: Network, first: int, ground: Ground) -> None:
        """Report edges that write a bit of their own and lead to no output, in a network whose rungs are all drawn."""
        for number, line in enumerate(network.lines, first):
            if remembers(self.dialect, line) and number not in ground.memories:
                self.found.append(rule("LAD012").at(line.span, word=line.text))

    def draw(self, ground: Ground, group: Group, network: int, title: str) -> bool:
        """Draw one rung, or say why it is none."""
        drawing = Drawing(ground)
        try:
            drawn = drawing.rung(group, title)
        except NoLadderError as reason:
            self.say(reason.fault, group)
            return False
        number = len(self.rungs)
        self.rungs.append(LiftedRung(drawn, network, tuple(drawing.sources)))
        self.drawn.note(number, drawing.spans)
        own = {output.lines[0]: output for output in group.outputs}
        for symbol, lines in enumerate(drawing.sources):
            if lines[0] in own:
                self.places.update(dict.fromkeys(lines, (number, symbol)))
        return True

    def say(self, fault: Fault, group: Group) -> None:
        """Report what is no ladder, once for each rung."""
        lines = self.program.lines
        row = lines[fault.other].span.row if fault.other >= 0 else 0
        values = {"most": MOST_DRAWN if group.size > MOST_DRAWN else MOST_NESTED, "row": row, "unit": self.dialect.unit}
        self.found.append(rule(fault.code).at(lines[fault.at].span, word=lines[fault.at].text, **values))


def _unseen(program: Program, work: _Lifting, growth: list[Growth]) -> Iterator[Diagnostic]:
    """Report, once a network, a contact that leads to no output; where something else has been said, that explains it."""
    said = {one.span.row for one in work.found if one.severity == "warning"}
    drawn = {one.network for one in work.rungs}
    first = 0
    for number, network in enumerate(program.networks):
        lines = list(enumerate(network.lines, first))
        first += len(lines)
        lost = [line for at, line in lines if not growth[at].added and not line.insn.then and line.places]
        if number in drawn and lost and not said & {line.span.row for _, line in lines}:
            yield rule("LAD014").at(lost[0].span, word=lost[0].text)


def _joined(one: Step[Piece]) -> tuple[Piece, Piece] | None:
    """Give the two blocks that a join puts together, the upper first: the older one is not on the top."""
    origins = one.flow.after[0]
    if not origins or origins[0].how != "made" or len(origins[0].sources) != 2:  # noqa: PLR2004 (two blocks)
        return None
    (stack, place), older = origins[0].sources
    return one.before[older[0]][older[1]], one.before[stack][place]
