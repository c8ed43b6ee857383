"""The list while a ladder is being written out: its lines, and how high each stack of the family stands."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NoReturn

from plcteach.core.area import Address
from plcteach.core.diagnostic import errors
from plcteach.core.errors import NotRepresentableError
from plcteach.core.ladder import Box, Branch, Coil, Compared, Contact, Edge, Invert, Parallel, Rung, Series
from plcteach.core.ladder import parallel as in_parallel
from plcteach.core.ladder import series as in_series
from plcteach.core.text import NOTHING, Text
from plcteach.ladder.instructions import first_effect
from plcteach.stl.reader import read

if TYPE_CHECKING:
    from plcteach.core.effect import Effect
    from plcteach.core.insn import Insn
    from plcteach.core.ladder import Node, Out, Symbol
    from plcteach.core.program import Arg, Line
    from plcteach.core.spec import Dialect, Role

MOST_LINES = 5_000
"""No rung of a lesson is longer; one that copies itself from the rail again and again is refused."""


@dataclass(frozen=True, slots=True)
class LoweredLine:
    """One instruction of a lowered ladder, the rung it belongs to (from 0), and why it is there if no symbol shows it.

    symbol: the number in `rung.symbols` of what it stands for, None for a join, a push and whatever else is put in.
    """

    text: str
    rung: int
    reason: Text = NOTHING
    symbol: int | None = None

    def __repr__(self) -> str:
        return f"LoweredLine({self.text!r})"


class Sheet:
    """The lines so far, and what stands on each stack; whatever the family has no room or no word for is refused.

    mine: the rung being written, kept because its symbols are known by identity.
    """

    def __init__(self, dialect: Dialect) -> None:
        self.dialect = dialect
        self.lines: list[LoweredLine] = []
        self.mine: Rung | None = None
        self.number = 0
        self.first = 0
        self.last: Insn | None = None
        self.stacks: dict[str, list[str]] = {}
        self.residue = 0
        self.numbers: dict[int, int] = {}
        self.written: set[int] = set()
        self.put_in: dict[int, tuple[Symbol, Text]] = {}

    def turn(self, rung: Rung, number: int) -> Rung:
        """Begin a rung with empty stacks, and give it with each symbol an object of its own, so that each has its number."""
        self.number, self.first, self.residue = number, len(self.lines), 0
        self.stacks = {stack.name: [] for stack in self.dialect.stacks}
        mine = _apart(rung)
        self.numbers = {id(one): at for at, one in enumerate(mine.symbols)}
        self.written, self.put_in = set(), {}
        self.mine = mine
        return mine

    def stand_in(self, symbol: Symbol, like: Symbol, reason: Text = NOTHING) -> None:
        """Let a symbol that is put in stand for one of the drawing, and say why it is put in."""
        self.numbers[id(symbol)] = self.numbers[id(like)]
        self.put_in[id(symbol)] = (symbol, reason)

    def refuse(self, why: Text) -> NoReturn:
        """Say why a rung cannot be written in this family."""
        said = Text("第{n}级写不成{family}的{list}：{why}", "Rung {n} has no {list} of {family}: {why}")
        ended = Text(
            why.zh if why.zh.endswith(("。", "？", "！")) else f"{why.zh}。",
            why.en if why.en.endswith((".", "?", "!")) else f"{why.en}.",
        )
        values = {"n": self.number + 1, "family": self.dialect.title, "list": self.dialect.list, "why": ended}
        raise NotRepresentableError(said.format(**values))

    def insn(self, role: Role) -> Insn:
        """Give the instruction of a role."""
        if role not in self.dialect.roles:
            self.refuse(Text("这个系列没有所需的指令", "the family lacks the instruction that this needs"))
        return self.dialect.words[self.dialect.roles[role]]

    def address(self, word: str, insn: Insn) -> Address:
        """Give the address that a word of the drawing means as the operand of an instruction."""
        found = self.dialect.address(word)
        wanted = self.dialect.kinds[insn.operands[0].kind]
        if not isinstance(found, Address):
            self.refuse(Text(f"没有{word}这个位", f"there is no bit {word}"))
        if found.area not in wanted.areas:
            self.refuse(
                Text(
                    f"{insn.mnemonic}不能用于{word}，它要求{wanted.title.zh}",
                    f"{insn.mnemonic} does not take {word}; it wants {wanted.title.en}",
                )
            )
        return found

    def read(self, text: str) -> tuple[Line, ...]:
        """Read a learner's words as instructions of the family; what its reader objects to is the reason for a refusal."""
        program = read(text, self.dialect)
        bad = errors(program.diagnostics)
        if bad:
            self.refuse(bad[0].text)
        headed = any(network.headed for network in program.networks)
        if headed or program.configuration or not program.lines:
            self.refuse(Text(f"“{text}”不是一条指令", f'"{text}" is not one instruction'))
        return program.lines

    def emit(self, insn: Insn, *args: Arg, reason: Text = NOTHING, of: Symbol | None = None) -> None:
        """Write one instruction; `of`: the symbol that it stands for."""
        operands = insn.separator.join(str(arg) if isinstance(arg, int) else arg.text for arg in args)
        self.put(f"{insn.word} {operands}".strip(), insn, reason=reason, of=of)

    def put(self, text: str, insn: Insn, *, reason: Text = NOTHING, of: Symbol | None = None) -> None:
        """Write an instruction that is spelled already."""
        self.follow(insn.effect if any(self.stacks.values()) else first_effect(insn))
        symbol = None if of is None else self.numbers.get(id(of))
        reason = self.put_in[id(of)][1] if id(of) in self.put_in else reason
        self.lines.append(LoweredLine(text, self.number, reason, symbol))
        self.last = insn
        if len(self.lines) - self.first > MOST_LINES:
            self.refuse(Text(f"指令会超过{MOST_LINES}条", f"it would take more than {MOST_LINES} instructions"))

    def follow(self, effect: Effect) -> None:
        """Keep count of what stands on each stack, and refuse what would be more than it holds."""
        for clause in effect.clauses:
            cells = self.stacks[clause.stack]
            del cells[max(0, len(cells) - len(clause.takes)) :]
            cells += [give.tag for give in clause.gives]
        for stack in self.dialect.stacks:
            if len(self.stacks[stack.name]) > stack.depth:
                self.refuse(
                    Text(
                        f"{stack.title.zh}只有{stack.depth}层，放不下这么多中间结果",
                        f"the {stack.title.en} holds no more than {stack.depth} values",
                    )
                )
        for limit in self.dialect.limits:
            if sum(cells.count(limit.tag) for cells in self.stacks.values()) > limit.most:
                self.refuse(
                    Text(
                        f"同时等待的最多是{limit.most}个{limit.title.zh}",
                        f"at most {limit.most} {limit.title.en} may wait at once",
                    )
                )

    @property
    def pending(self) -> int:
        """How many cells the stacks hold, without those that are left over and disturb nothing."""
        return sum(map(len, self.stacks.values())) - self.residue


def _apart(rung: Rung) -> Rung:
    """Give a rung in its flat form with each symbol an object of its own."""
    stem = None if rung.stem is None else _node(rung.stem)
    return Rung(stem, tuple(map(_out, rung.outs)), rung.title)


def _node(node: Node) -> Node:
    match node:
        case Series(parts):
            return in_series(*map(_node, parts))
        case Parallel(parts):
            return in_parallel(*map(_node, parts))
        case Contact() | Compared() | Edge():
            return replace(node)
    return Invert()


def _out(out: Out) -> Out:
    match out:
        case Branch(stem, outs):
            return Branch(_node(stem), tuple(map(_out, outs)))
        case Box(_, pins):
            return replace(out, pins=tuple((name, _node(node)) for name, node in pins))
        case Coil():
            return replace(out)
