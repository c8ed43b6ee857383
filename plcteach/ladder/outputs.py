"""The coils and boxes of a list: what each line with an output is as a symbol, and which flows it reads."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.effect import Edge, Name, Not
from plcteach.core.ladder import Box, Coil, CoilKind
from plcteach.ladder.sketch import directly

if TYPE_CHECKING:
    from plcteach.core.effect import Formula
    from plcteach.core.program import Line
    from plcteach.core.spec import Dialect
    from plcteach.core.verb import Verb
    from plcteach.ladder.piece import Piece
    from plcteach.machine.step import Step


@dataclass(slots=True, eq=False)
class Output:
    """A coil or a box of the list, before it is drawn.

    at: the line that executes it.  flow: what leads to it; None for a box that takes none.  pins: further inputs.
    lines: the lines that make it, its own first.  index: its number among the outputs of its network.
    """

    at: int
    flow: Piece | None
    symbol: Coil | Box
    pins: tuple[tuple[str, Piece], ...] = ()
    lines: list[int] = field(default_factory=list)
    index: int = 0

    @property
    def size(self) -> int:
        """How many symbols it adds to a rung: itself, and its further inputs."""
        return 1 + sum(piece.size for _, piece in self.pins)


@dataclass(slots=True)
class _Section:
    """A block's section that is open: the line that opened it, and its inputs so far with their lines."""

    block: Address
    text: str
    opened: int
    pins: list[tuple[str, Piece, int]] = field(default_factory=list)
    drawn: Output | None = None


class Outputs:
    """Turns lines into outputs, one after the other; a block's section becomes one box when the block acts."""

    def __init__(self, dialect: Dialect, blank: Piece) -> None:
        self.dialect, self.blank = dialect, blank
        self.section: _Section | None = None

    def of(self, step: Step[Piece]) -> Output | None:
        """Give the output that a line makes, if it makes one."""
        line, verbs = step.line, step.line.insn.then
        if not verbs or remembers(self.dialect, line):
            return None
        if verbs[0].name in {"open", "update"}:
            return self.sectioned(step, verbs[0])
        if self.section and verbs[0].name == "pin" and line.bound.get(verbs[0].target) == self.section.block:
            self.section.pins.append((verbs[0].op, self.flows(step)[0][1], step.number))
            return None
        flows = self.flows(step)
        symbol = _coil(self.dialect, line) or Box(line.text, (), flows[0][0] if len(flows) > 1 else "")
        return Output(step.number, flows[0][1] if flows else None, symbol, tuple(flows[1:]), [step.number])

    def flows(self, step: Step[Piece]) -> list[tuple[str, Piece]]:
        """Give the cells that the verbs of a line read, the deepest first."""
        read = set().union(*(verb.names for verb in step.line.insn.then))
        taken = [take.name for clause in step.line.effect.clauses for take in clause.takes if take.name in read]
        places = ((name, step.flow.named.get(name)) for name in taken)
        return [(name, step.before[place[0]][place[1]] if place else self.blank) for name, place in places]

    def sectioned(self, step: Step[Piece], verb: Verb) -> Output | None:
        """Open a block's section, or end its inputs or itself."""
        block = step.line.bound.get(verb.target)
        if verb.name == "open" and isinstance(block, Address):
            self.section = _Section(block, step.line.text, step.number)
        elif self.section and self.section.drawn:
            self.section.drawn.lines.append(step.number)
            self.section = None
        elif self.section:
            self.section.drawn = self.drawn(self.section, step.number)
            return self.section.drawn
        return None

    @staticmethod
    def drawn(section: _Section, at: int) -> Output:
        """Give the box of a section whose block acts now: its first input is its flow, the others are pins."""
        pins = section.pins
        flow, entry = (pins[0][1], pins[0][0]) if pins else (None, "")
        lines = [section.opened, *(number for _, _, number in pins), at]
        return Output(at, flow, Box(section.text, (), entry), tuple((name, one) for name, one, _ in pins[1:]), lines)


def remembers(dialect: Dialect, line: Line) -> bool:
    """Say whether a line is an edge on the wire with a bit of its own that remembers the last flow."""
    return dialect.parts.get(line.insn.mnemonic) in {"rise", "fall"} and bool(line.insn.operands)


def _coil(dialect: Dialect, line: Line) -> Coil | None:
    """Give a line as a coil, if all it does is to write, set or reset bits."""
    verb = line.insn.then[0]
    target = line.bound.get(verb.target)
    kind = _KINDS.get((verb.name, _shape(verb.formula)))
    if len(line.insn.then) > 1 or kind is None or verb.sources or not isinstance(target, Address):
        return None
    count = line.bound.get(verb.count) if verb.count else 1
    operand = next(one for one in line.insn.operands if one.name == verb.target)
    now = directly(dialect, operand, "output", "coil")
    return Coil(target.text, kind, count if isinstance(count, int) else 1, now)


_KINDS: dict[tuple[str, str], CoilKind] = {
    ("coil", "as it is"): "", ("coil", "inverse"): "not", ("coil", "rise"): "rise", ("coil", "fall"): "fall",
    ("set", "as it is"): "set", ("reset", "as it is"): "reset",
}  # fmt: skip


def _shape(formula: Formula | None) -> str:
    match formula:
        case Name():
            return "as it is"
        case Not(Name()):
            return "inverse"
        case Edge(rising, Name()):
            return "rise" if rising else "fall"
    return ""
