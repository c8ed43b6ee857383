"""Follows values from the lines that make them to the lines that use them, through the bits that coils write in between."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.machine.evaluation import Evaluation
from plcteach.machine.formula import Spelling, Term, name
from plcteach.machine.step import Stacks, Step, step

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from plcteach.core.area import Address
    from plcteach.core.effect import Formula
    from plcteach.core.insn import Operand
    from plcteach.core.program import Program

_MARK = "@"
_TURNS = {
    "jump", "label", "call", "entry", "return", "loop", "next", "end",
    "segment", "step", "rail", "master", "restore", "work", "shift",
}  # fmt: skip
_BLANK = name("x")


@dataclass(slots=True)
class Values(Spelling):
    """A run over formulas in which a bit that a line has written reads as what that line wrote, and not as the bit of before.

    steps: the run.  made: the value of each mark that a coil has left.  last: the value of each bit's last coil.
    """

    steps: list[Step[Term]] = field(default_factory=list)
    made: dict[str, Term] = field(default_factory=dict)
    last: dict[str, Term] = field(default_factory=dict)
    now: dict[str, Term] = field(default_factory=dict)

    def read(self, operand: Operand, address: Address) -> Term:
        """Give the bit's name, with the mark of the line that wrote it last."""
        del operand
        return self.now.get(address.text) or name(address.text)

    def note(self, done: Step[Term]) -> None:
        """Mark what a line has written; where the program may have gone another way nothing is known of what was written."""
        self.steps.append(done)
        coils = {target.text for verb, target in done.line.targets if verb.name == "coil"}
        for address, value in done.written:
            mark = f"{address.text}{_MARK}{done.number}"
            self.now[address.text] = name(mark)
            if address.text in coils:
                self.made[mark] = self.last[address.text] = value
        if done.line.insn.does & _TURNS:
            self.now = {text: name(f"{text}{_MARK}") for text in self.now}

    def given(self, number: int, formula: Formula | None) -> Term:
        """Give the value that a verb of one line works with."""
        one = self.steps[number]
        if formula is None:
            return _BLANK
        return Evaluation(one.line, one.before, one.flow, self, _BLANK).value(formula)

    def told(self, bit: str) -> int:
        """Give the first line whose coil comes on with a bit, past the end where there is none."""
        met: set[tuple[Term, Leaf]] = set()
        for mark, term in self.made.items():
            if any(leaf.word == bit and not leaf.falls for leaf in leaves([term], {}, met)):
                return int(mark.rpartition(_MARK)[2])
        return len(self.steps)


def follow(program: Program) -> Values:
    """Run a program once over formulas and keep what its coils write."""
    shapes, values = program.dialect.shapes, Values()
    stacks: Stacks[Term] = tuple((_BLANK,) * shape.depth if shape.fixed else () for shape in shapes)
    for network in program.networks:
        stacks = tuple(cells if shape.fixed else () for cells, shape in zip(stacks, shapes, strict=True))
        for line in network.lines:
            one = step(line, shapes, stacks, values, _BLANK, number=len(values.steps))
            values.note(one)
            stacks = one.after
    return values


@dataclass(frozen=True, slots=True)
class Leaf:
    """A name in a formula.

    falls: the formula falls as the name rises.  through: a bit written in the same scan carries it here.
    turned: that bit falls as the name rises.
    """

    word: str
    falls: bool
    through: bool = False
    turned: bool = False


def leaves(terms: Iterable[Term], made: dict[str, Term], met: set[tuple[Term, Leaf]] | None = None) -> set[Leaf]:
    """Give every name of some formulas, the values of written bits put in their place; an edge is a matter of its own.

    met: the ways that have been gone already, so that many formulas that share their parts are soon gone through.
    """
    waiting = [(term, Leaf("", falls=False)) for term in terms]
    met = set() if met is None else met
    found: set[Leaf] = set()
    while waiting:
        one, way = waiting.pop()
        if (one, way) in met:
            continue
        met.add((one, way))
        if one.op == "" and one.word in made:
            waiting.append((made[one.word], way if way.through else Leaf("", way.falls, through=True)))
        elif one.op == "":
            found.add(Leaf(one.word, way.falls, way.through, way.turned))
        else:
            waiting += [(part, further) for part in one.parts for further in _further(one.op, way)]
    return found


def _further(op: str, way: Leaf) -> Iterator[Leaf]:
    """Give the ways into an operator's parts: straight, turned over, or both."""
    if op not in "↑↓/":
        yield way
    if op in "/⊕":
        yield Leaf("", not way.falls, way.through, way.through and not way.turned)


def was_written(term: Term, address: str, clean: set[Term]) -> bool:
    """Say whether a value was worked out from a bit as an earlier line of the same scan has written it.

    clean: the formulas that are known not to be, to which those of this value are added.
    """
    waiting = [term]
    while waiting:
        one = waiting.pop()
        if one.word.startswith(f"{address}{_MARK}"):
            return True
        if one not in clean:
            clean.add(one)
            waiting += one.parts
    return False
