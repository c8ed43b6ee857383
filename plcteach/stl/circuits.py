"""Finds where circuits begin and which of its readings an instruction has there: FX's LD, NEZA's closing parenthesis.

A list without headings (FX, NEZA) starts a new rung at a load when every value has been used. An FX load after an output has
two readings: it saves the result register if a later ANB or ORB takes what it saved, and otherwise it opens a new circuit and
leaves no garbage. Which one, only what follows can tell; so such a load leaves a *ghost* on the stack, a cell that becomes real
when a join takes it and vanishes when a branch instruction looks past it. One pass, linear in the length of the list.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from plcteach.core.diagnostic import rule
from plcteach.core.effect import Name, names
from plcteach.core.program import Line, Network
from plcteach.stl.section import CLOSE
from plcteach.stl.tokens import Heading

if TYPE_CHECKING:
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.effect import Effect
    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect


@dataclass(slots=True, eq=False)
class _Cell:
    """What this pass knows of a cell: whether an output has used it, and the load whose reading hangs on it."""

    spent: bool = False
    ghost: int = -1


def arrange(dialect: Dialect, items: list[Line | Heading]) -> tuple[tuple[Network, ...], list[Diagnostic]]:
    """Put lines into networks, each line with the effect that it has where it stands."""
    walk = _Walk(dialect)
    for item in items:
        if isinstance(item, Heading):
            walk.heading(item)
        else:
            walk.line(item)
    return walk.finish()


class _Walk:
    """One pass down a list."""

    def __init__(self, dialect: Dialect) -> None:
        self.dialect = dialect
        self.lines: list[Line] = []
        self.headings: dict[int, list[Heading]] = {}
        self.breaks: set[int] = set()
        self.openers: list[Line] = []
        self.diagnostics: list[Diagnostic] = []
        self.block = ""
        self.inside = False
        self.routine = ""
        self.routines: dict[int, str] = {}
        self.clear()

    def clear(self) -> None:
        self.stacks: dict[str, list[_Cell]] = {stack.name: [] for stack in self.dialect.stacks}
        for stack in self.dialect.stacks:
            if stack.fixed:
                self.stacks[stack.name] = [_Cell(spent=True) for _ in range(stack.depth)]

    def heading(self, heading: Heading) -> None:
        self.close()
        self.clear()
        self.inside = False
        self.headings.setdefault(len(self.lines), []).append(heading)

    def line(self, line: Line) -> None:
        number = len(self.lines)
        line = self.married(line)
        if not self.dialect.networks_by_title:
            line = self.settled(line, number)
            self.apply(line.effect, line.insn)
        self.lines.append(line)

    def married(self, line: Line) -> Line:
        """Give a closing parenthesis the effect of what opened it."""
        if line.insn.close:
            self.openers.append(line)
        elif line.insn.mnemonic == ")":
            if not self.openers:
                self.diagnostics.append(rule("RDR010").at(line.span))
                return line
            opener = self.openers.pop()
            return replace(line, effect=opener.insn.close or line.effect)
        return line

    def close(self) -> None:
        for opener in self.openers:
            self.diagnostics.append(rule("RDR011").at(opener.span, word=opener.insn.mnemonic))
        self.openers.clear()

    def settled(self, line: Line, number: int) -> Line:
        """Break the list before a load when every value is used, and choose the reading of a load that has two."""
        self.placed(line, number)
        if not _loads(line):
            return line
        if self.free():
            self.new_rung(number)
        if line.insn.fresh is None:
            return line
        main = self.stacks[""]
        if main and not main[-1].spent:
            return line
        if main:
            main[-1].ghost = number
            main.append(_Cell(spent=True))
        return replace(line, effect=line.insn.fresh)

    def free(self) -> bool:
        """Say whether a new rung may begin: every value is used, no block is open, and no label stands right above."""
        below = bool(self.lines) and bool(_verbs(self.lines[-1]) & _HEADS)
        used = all(cell.spent for cells in self.stacks.values() for cell in cells)
        return used and not (self.openers or self.inside or below)

    def placed(self, line: Line, number: int) -> None:
        """Break the list before a label, a subroutine and a block's section, and behind a subroutine."""
        verbs = _verbs(line)
        if "entry" in verbs:
            operand, arg = line.insn.operands[0], line.args[0]
            self.routine = f"{operand.mark}{arg}"
            self.new_rung(number)
        elif verbs & _BEGINS and self.free():
            self.new_rung(number)
        if self.routine:
            self.routines[number] = self.routine
            if "return" in verbs:
                self.routine = ""
                self.breaks.add(number + 1)
        self.inside = "open" in verbs or (self.inside and line.insn.word != CLOSE)

    def new_rung(self, number: int) -> None:
        self.breaks.add(number)
        main = self.stacks[""]
        del main[:-1]

    def apply(self, effect: Effect, insn: Insn) -> None:
        taken: dict[str, _Cell] = {}
        for clause in effect.clauses:
            cells = self.stacks[clause.stack]
            for take in reversed(clause.takes):
                if take.tag:
                    self.find(cells, take.tag)
                if cells:
                    taken[take.name] = cells.pop()
        for verb in insn.then:
            for name in verb.names & set(taken):
                taken[name].spent = True
        self.give(effect, taken)
        if insn.powers and self.stacks[""]:
            self.stacks[""][-1].spent = True

    def give(self, effect: Effect, taken: dict[str, _Cell]) -> None:
        """Put the cells back, the top first: a name alone is the taken cell itself, once; all else is new and unused."""
        for clause in effect.clauses:
            given: list[_Cell] = []
            for give in reversed(clause.gives):
                alone = give.formula.name if isinstance(give.formula, Name) else ""
                given.append(taken.pop(alone) if alone in taken else _Cell())
            self.stacks[clause.stack] += given[::-1]

    def find(self, cells: list[_Cell], tag: str) -> None:
        """Settle the ghosts that an instruction meets: a join makes the uppermost real, a branch instruction drops them."""
        if tag == "L" and cells and cells[-1].ghost >= 0:
            number = cells[-1].ghost
            cells[-1].ghost = -1
            self.lines[number] = replace(self.lines[number], effect=self.lines[number].insn.effect)
            self.breaks.discard(number)
        while tag != "L" and cells and cells[-1].ghost >= 0:
            cells.pop()

    def network(self, heading: Heading | None, lines: tuple[Line, ...], last: int) -> Network:
        """Make a network; it belongs to the subroutine whose first line stands above, else to that of the last heading."""
        if heading:
            self.block = heading.block
        block = self.routines.get(last, "") or self.block
        return Network(heading.title if heading else "", lines, heading is not None, block)

    def finish(self) -> tuple[tuple[Network, ...], list[Diagnostic]]:
        self.close()
        networks: list[Network] = []
        current: list[Line] = []
        heading: Heading | None = None

        def flush(number: int) -> None:
            nonlocal heading
            if current or heading:
                networks.append(self.network(heading, tuple(current), number - 1))
            current.clear()
            heading = None

        for number in range(len(self.lines) + 1):
            for one in self.headings.get(number, ()):
                flush(number)
                heading = one
            if number in self.breaks and current:
                flush(number)
            if number < len(self.lines):
                current.append(self.lines[number])
        flush(len(self.lines))
        return tuple(networks), self.diagnostics


_HEADS = {"label", "entry"}
_BEGINS = {"label", "entry", "open"}


def _verbs(line: Line) -> set[str]:
    return {verb.name for verb in line.insn.then}


def _loads(line: Line) -> bool:
    """Say whether an instruction replaces the working value by one of its own, as a load does."""
    if line.insn.fresh:
        return True
    if len(line.effect.clauses) > 1 or (line.insn.then and not line.insn.powers):
        return False
    clause = line.effect.clauses[0]
    taken = {take.name for take in clause.takes}
    return bool(clause.gives) and not any(names(give.formula) & taken for give in clause.gives)
