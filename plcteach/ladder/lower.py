"""Writes a ladder out as an instruction list of any family, driven by the roles in its table and by the effects of its rows.

The rules are the ones by which the makers' software does it: a single contact in series or in parallel is one instruction, a
block begins with a load and is joined right after it; at a branch point the flow is saved before the first output path that
changes it, read again before the middle ones and fetched before the last. A family that opens and closes parentheses writes
its blocks so. Which instruction reads a bit inverted, or its edge, is found by comparing effects, never by name.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.errors import NotRepresentableError
from plcteach.core.ladder import (
    MOST_NESTED,
    Branch,
    Coil,
    Contact,
    Invert,
    Ladder,
    Node,
    Out,
    Parallel,
    Rung,
    Series,
    depth,
)  # fmt: skip
from plcteach.core.text import NOTHING, Text
from plcteach.dialects import dialect as find_dialect
from plcteach.ladder.instructions import closer, coil_word, contact_word, edge_word, first_effect
from plcteach.ladder.meaning import meaning

if TYPE_CHECKING:
    from plcteach.core.effect import Effect
    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect, Role

__all__ = ["LoweredLine", "lower", "lower_lines", "meaning"]


@dataclass(frozen=True, slots=True)
class LoweredLine:
    """One instruction of a lowered ladder, the rung it belongs to (from 0), and why it is there if no symbol shows it."""

    text: str
    rung: int
    reason: Text = NOTHING

    def __repr__(self) -> str:
        return f"LoweredLine({self.text!r})"


def lower(ladder: Ladder | Rung, dialect: str | Dialect, *, grouped: bool = False, fused: bool = True) -> str:
    """Write a ladder as the canonical instruction list of a family; NotRepresentableError says why it cannot.

    grouped: joins stand together behind the blocks instead of one after each.  fused: False writes a single contact as a
    block too (load and join), as a lesson about composition wants it.
    """
    family = find_dialect(dialect)
    lines = lower_lines(ladder, family, grouped=grouped, fused=fused)
    rows: list[str] = []
    for number, rung in enumerate(_rungs(ladder)):
        title = " ".join(rung.title.split())
        if family.networks_by_title:
            rows.append(f"{family.heading} {number + 1} // {title}" if title else f"{family.heading} {number + 1}")
        elif title:
            rows.append(f"// {title}")
        rows += [line.text for line in lines if line.rung == number]
    return "".join(f"{row}\n" for row in rows)


def lower_lines(
    ladder: Ladder | Rung, dialect: str | Dialect, *, grouped: bool = False, fused: bool = True
) -> tuple[LoweredLine, ...]:
    """Give the instructions of a lowered ladder, each with the reason for it where no symbol of the drawing shows it."""
    work = _Lowering(find_dialect(dialect), grouped=grouped, fused=fused)
    for number, rung in enumerate(_rungs(ladder)):
        work.rung(rung, number)
    return tuple(work.lines)


def _rungs(ladder: Ladder | Rung) -> tuple[Rung, ...]:
    return ladder.rungs if isinstance(ladder, Ladder) else (ladder,)


_REASONS: dict[str, Text] = {
    "load": Text("一个新的电路块从这里开始", "a new block begins here"),
    "join_series": Text("两个串联的电路块到这里结束", "two blocks in series end here"),
    "join_parallel": Text("两个并联的电路块到这里结束", "two parallel blocks end here"),
    "open_series": Text("串联的电路块从这里开始", "a block in series begins here"),
    "open_parallel": Text("并联的电路块从这里开始", "a parallel block begins here"),
    "push": Text("分支点：先把这里的结果存起来", "a branch point: the result so far is saved"),
    "read": Text("中间的支路：再读一次分支点的结果", "a middle branch: the saved result is read again"),
    "pop": Text("最后一条支路：取回分支点的结果", "the last branch: the saved result is fetched and removed"),
    "edge": Text("沿只取这一个触点，所以它自成一块", "the edge is of this contact alone, so it is a block of its own"),
    "invert": Text("反相线圈：先把结果取反", "an inverted coil: the result is turned round first"),
}  # fmt: skip


class _Lowering:
    """The list while it is being written, and how high each stack of the family stands."""

    def __init__(self, dialect: Dialect, *, grouped: bool, fused: bool) -> None:
        self.dialect, self.grouped, self.fused = dialect, grouped, fused
        self.lines: list[LoweredLine] = []
        self.number = 0
        self.stacks: dict[str, list[str]] = {}
        self.closer = closer(dialect)

    def rung(self, rung: Rung, number: int) -> None:
        self.number = number
        self.stacks = {stack.name: [] for stack in self.dialect.stacks}
        if depth(rung) > MOST_NESTED:
            self.refuse(f"嵌套超过{MOST_NESTED}层", f"it is nested deeper than {MOST_NESTED}")
        if rung.stem is None:
            self.refuse(
                "线圈直接接在左母线上，前面至少要有一个触点",
                "a coil hangs on the left rail itself; a contact must come first",
            )
        else:
            self.begin(rung.stem, "load", at_rail=True)
            self.outs(rung.outs)

    def refuse(self, zh: str, en: str) -> None:
        said = Text("第{n}级写不成{family}的{list}：{why}。", "Rung {n} has no {list} of {family}: {why}.")
        values = {"n": self.number + 1, "family": self.dialect.title, "list": self.dialect.list, "why": Text(zh, en)}
        raise NotRepresentableError(said.format(**values))

    # contacts and blocks

    def begin(self, node: Node, role: Role, *, at_rail: bool) -> None:
        """Start a block with a load (or what opens a parenthesis); `at_rail`: its own value is the whole flow."""
        match node:
            case Contact():
                self.contact(role, node)
            case Invert():
                self.refuse("NOT左边没有触点，没有可以取反的东西", "NOT has no contact on its left to turn round")
            case Series(parts):
                self.begin(parts[0], role, at_rail=at_rail)
                self.onward(parts[1:], "join_series", at_rail=at_rail)
            case Parallel(parts):
                self.begin(parts[0], role, at_rail=at_rail)
                self.onward(parts[1:], "join_parallel", at_rail=at_rail)

    def onward(self, parts: tuple[Node, ...], join: Role, *, at_rail: bool) -> None:
        """Go on from the top of the stack with parts in series, or in parallel to it."""
        pending = 0
        for part in parts:
            alone = self.alone(part, join)
            if (alone or isinstance(part, Invert)) and pending:
                pending = self.join(join, pending)
            if isinstance(part, Invert):
                self.invert(join, at_rail=at_rail)
            elif alone and isinstance(part, Contact):
                self.contact("series" if join == "join_series" else "parallel", part)
            else:
                pending += self.block(part, join, at_rail=at_rail and join == "join_parallel")
            if not self.grouped and pending:
                pending = self.join(join, pending)
        self.join(join, pending)

    def alone(self, part: Node, join: Role) -> bool:
        role: Role = "series" if join == "join_series" else "parallel"
        return self.fused and isinstance(part, Contact) and contact_word(self.dialect, role, part) is not None

    def block(self, part: Node, join: Role, *, at_rail: bool) -> int:
        """Write a block, and say how many joins it leaves to be written."""
        self.begin(part, join if self.closer else "load", at_rail=at_rail)
        if not self.closer:
            return 1
        self.emit(self.closer, reason=_REASONS[join])
        return 0

    def join(self, join: Role, count: int) -> int:
        for _ in range(count):
            self.emit(self.insn(join), reason=_REASONS[join])
        return 0

    def invert(self, join: Role, *, at_rail: bool) -> None:
        if join == "join_parallel":
            self.refuse("NOT左边没有触点，没有可以取反的东西", "NOT has no contact on its left to turn round")
        if not at_rail:
            self.refuse(
                "NOT要取反从左母线来的全部能流，而这里的支路不是从左母线开始的",
                "NOT turns round the whole flow from the left rail, and the parallel path it stands in does not begin there",
            )
        self.emit(self.insn("invert"))

    def contact(self, role: Role, contact: Contact) -> None:
        found = contact_word(self.dialect, role, contact)
        plain = found or contact_word(self.dialect, role, Contact(contact.address))
        if plain is None:
            self.refuse("这个系列没有这样的触点指令", "the family has no such contact instruction")
            return
        inner = any(self.stacks.values())
        word = {"join_series": "open_series", "join_parallel": "open_parallel"}.get(role, role)
        self.emit(plain, self.address(contact.address, plain), reason=_REASONS.get(word, NOTHING) if inner else NOTHING)
        if found is None:
            self.edge(contact)

    def edge(self, contact: Contact) -> None:
        """Write the edge of the value just loaded, where the family has no contact of that kind."""
        found = edge_word(self.dialect, contact)
        if found is None:
            self.refuse(
                f"{contact.address}的沿在这个系列里要用一个位记住上次的状态，梯形图里没有给出这个位",
                f"the edge of {contact.address} needs a bit here that remembers the last flow, and the ladder names none",
            )
        else:
            self.emit(found, reason=_REASONS["edge"])

    # outputs and branch points

    def outs(self, outs: tuple[Out, ...]) -> None:
        """Write what hangs on a node whose value is on the top of the stack."""
        paths = [self.path(out) for out in outs]
        first = next((number for number, path in enumerate(paths) if isinstance(path, Branch)), len(paths))
        last = len(paths) - 1
        saved = first < last
        for number, path in enumerate(paths):
            if saved and number >= first:
                role: Role = "push" if number == first else "pop" if number == last else "read"
                self.emit(self.insn(role), reason=_REASONS[role])
            if isinstance(path, Coil):
                self.coil(path)
            else:
                stem = path.stem.parts if isinstance(path.stem, Series) else (path.stem,)
                self.onward(stem, "join_series", at_rail=True)
                self.outs(path.outs)

    def path(self, out: Out) -> Out:
        """Turn an inverted coil into NOT and a coil where the family has no such coil."""
        if isinstance(out, Coil) and out.kind == "not" and coil_word(self.dialect, "not") is None:
            return Branch(Invert(), (Coil(out.address),))
        return out

    def coil(self, coil: Coil) -> None:
        insn = coil_word(self.dialect, coil.kind)
        if insn is None:
            self.refuse(
                f"没有对应线圈（{coil.mark}{coil.address}）的指令",
                f"it has no instruction for the coil ({coil.mark}{coil.address})",
            )
            return
        address = self.address(coil.address, insn)
        if self.dialect.area(address).role == "input":
            self.refuse(
                f"{coil.address}是输入，程序不能写它", f"{coil.address} is an input, which a program cannot write"
            )
        places = tuple(self.dialect.following(address, coil.count))
        if len(places) < coil.count:
            self.refuse(
                f"从{coil.address}起没有{coil.count}个位", f"there are not {coil.count} bits from {coil.address} on"
            )
        if any(operand.number for operand in insn.operands):
            self.emit(insn, address, coil.count)
        else:
            for place in places:
                self.emit(insn, place)

    # instructions

    def insn(self, role: Role) -> Insn:
        if role not in self.dialect.roles:
            self.refuse("这个系列没有所需的指令", "the family lacks the instruction that this needs")
        return self.dialect.words[self.dialect.roles[role]]

    def address(self, word: str, insn: Insn) -> Address:
        """Give the address that a word of the drawing means as the operand of an instruction."""
        found = self.dialect.address(word)
        wanted = self.dialect.kinds[insn.operands[0].kind]
        if not isinstance(found, Address):
            self.refuse(f"没有{word}这个位", f"there is no bit {word}")
        elif found.area not in wanted.areas:
            self.refuse(
                f"{insn.mnemonic}不能用于{word}，它要求{wanted.title.zh}",
                f"{insn.mnemonic} does not take {word}; it wants {wanted.title.en}",
            )
        else:
            return found
        raise AssertionError

    def emit(self, insn: Insn, *args: Address | int, reason: Text = NOTHING) -> None:
        operands = ", ".join(str(arg) if isinstance(arg, int) else arg.text for arg in args)
        self.follow(insn.effect if any(self.stacks.values()) else first_effect(insn))
        self.lines.append(LoweredLine(f"{insn.mnemonic} {operands}".strip(), self.number, reason))

    def follow(self, effect: Effect) -> None:
        """Keep count of what stands on each stack, and refuse what would be more than it holds."""
        for clause in effect.clauses:
            cells = self.stacks[clause.stack]
            del cells[max(0, len(cells) - len(clause.takes)) :]
            cells += [give.tag for give in clause.gives]
        for stack in self.dialect.stacks:
            if len(self.stacks[stack.name]) > stack.depth:
                self.refuse(
                    f"{stack.title.zh}只有{stack.depth}层，放不下这么多中间结果",
                    f"the {stack.title.en} holds no more than {stack.depth} values",
                )
        for limit in self.dialect.limits:
            if sum(cells.count(limit.tag) for cells in self.stacks.values()) > limit.most:
                self.refuse(
                    f"同时等待的最多是{limit.most}{limit.title.zh}",
                    f"at most {limit.most} {limit.title.en} may wait at once",
                )
