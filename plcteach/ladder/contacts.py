"""Writes contacts and blocks of contacts, in series and in parallel, and what acts on the whole flow: NOT, edges, ENO.

What acts on the flow may stand in a parallel path that does not begin at the left rail. The flow before it is then kept and
fetched again for each further path, where the family's stacks allow that; else each path is written from the rail anew, which
means the same as long as nothing is written between.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.insn import REGISTERS
from plcteach.core.ladder import (
    Compared,
    Contact,
    Edge,
    Invert,
    Parallel,
    Series,
    in_series,
    parallel,
    series,
    symbols_of,
)
from plcteach.core.text import NOTHING, Text
from plcteach.ladder.instructions import closer, comparing, contact_word, edge_word
from plcteach.ladder.sheet import Sheet

if TYPE_CHECKING:
    from plcteach.core.area import Address
    from plcteach.core.insn import Insn
    from plcteach.core.ladder import Node
    from plcteach.core.program import Arg
    from plcteach.core.spec import Dialect, Role

REASONS: dict[str, Text] = {
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
    "pulse": Text("脉冲线圈：先取结果的沿", "a pulse coil: the edge of the result is taken first"),
    "keep": Text("这条并联支路改变整个能流，所以先留一份", "a parallel path here acts on the whole flow, so a copy is kept"),
    "copy": Text("下一条并联支路从留下的那一份开始", "the next parallel path begins with the kept copy"),
    "room": Text("先占一层，下一条指令把留下的能流写进去", "makes a cell that the next instruction overwrites with the kept flow"),
    "again": Text(
        "并联支路里有作用于整个能流的元件，所以这条支路从左母线重写一遍",
        "a symbol in this parallel path acts on the whole flow, so the path is written from the left rail again",
    ),
    "pin": Text("下一个输入从这里开始，前一个留在下面", "the next input begins here, and the one before waits below it"),
    "open": Text("功能块从这里开始", "the block begins here"),
    "entry": Text("上面的结果送到这个输入", "the result goes to this input"),
    "close": Text("功能块到这里结束，这时才动作", "the block ends here, and acts"),
}  # fmt: skip

_NOTHING_LEFT = Text(
    "{word}左边没有触点，没有可以作用的能流", "{word} has no contact on its left, so there is no flow for it to act on"
)
_NOT_THERE = Text(
    "NOT要取反从左母线来的全部能流（沿也是一样），而这里的支路不是从左母线开始的",
    "NOT turns round the whole flow from the left rail (and an edge is an edge of it), and the parallel path does not begin there",
)


def wired(node: Node) -> bool:
    """Say whether something in a parallel path acts on the whole flow and not on a block of its own."""
    waiting = [node]
    while waiting:
        one = waiting.pop()
        match one:
            case Invert() | Edge():
                return True
            case Parallel(parts):
                if any(_register(part) for part in parts):
                    return True
                waiting += parts
            case Series(parts):
                if _register(parts[0]):
                    return True
                waiting += parts
    return False


def _register(node: Node) -> bool:
    return isinstance(node, Contact) and node.address in REGISTERS


def _remembers(nodes: tuple[Node, ...]) -> bool:
    """Say whether an edge with a bit of its own is among some nodes: written twice it would see itself."""
    return any(isinstance(one, Edge) and one.memory for node in nodes for one in symbols_of(node))


class Contacts(Sheet):
    """Contacts and blocks as a family's list has them."""

    def __init__(self, dialect: Dialect, *, grouped: bool, fused: bool) -> None:
        super().__init__(dialect)
        self.grouped, self.fused = grouped, fused
        self.closer = closer(dialect)

    def begin(self, node: Node, role: Role, *, at_rail: bool) -> None:
        """Start a block with a load (or what opens a parenthesis); `at_rail`: its own value is the whole flow."""
        match node:
            case Contact() | Compared():
                self.contact(role, node)
            case Invert() | Edge():
                self.refuse(_NOTHING_LEFT.format(word=_name(node)))
            case Series(parts):
                at = self.anew(parts) if at_rail else 0
                if at:
                    copies = (series(*parts[:at], path) for path in parts[at].parts)  # type: ignore[union-attr]
                    self.begin(series(parallel(*copies), *parts[at + 1 :]), role, at_rail=True)
                    return
                self.begin(parts[0], role, at_rail=at_rail)
                self.onward(parts[1:], "join_series", at_rail=at_rail)
            case Parallel(parts):
                self.begin(parts[0], role, at_rail=at_rail)
                self.onward(parts[1:], "join_parallel", at_rail=at_rail)

    def onward(self, parts: tuple[Node, ...], join: Role, *, at_rail: bool) -> None:
        """Go on from the top of the stack with parts in series, or in parallel to it."""
        pending = 0
        in_line = join == "join_series"
        for part in parts:
            alone = self.alone(part, join)
            acts = isinstance(part, Invert | Edge) or (in_line and isinstance(part, Parallel) and wired(part))
            if (alone or acts) and pending:
                pending = self.join(join, pending)
            if acts:
                self.acting(part, in_line=in_line, at_rail=at_rail)
            elif alone and isinstance(part, Contact | Compared):
                self.contact("series" if in_line else "parallel", part)
            else:
                pending += self.block(part, join, at_rail=at_rail and not in_line)
            if not self.grouped and pending:
                pending = self.join(join, pending)
        self.join(join, pending)

    def alone(self, part: Node, join: Role) -> bool:
        """Say whether a part is one contact with an instruction of its own."""
        role: Role = "series" if join == "join_series" else "parallel"
        if not isinstance(part, Contact | Compared) or contact_word(self.dialect, role, part) is None:
            return False
        return self.fused or _register(part)

    def block(self, part: Node, join: Role, *, at_rail: bool) -> int:
        """Write a block, and say how many joins it leaves to be written."""
        self.begin(part, join if self.closer else "load", at_rail=at_rail)
        if not self.closer:
            return 1
        self.emit(self.closer, reason=REASONS[join])
        return 0

    def join(self, join: Role, count: int) -> int:
        """Write some joins, and say that none waits any more."""
        for _ in range(count):
            self.emit(self.insn(join), reason=REASONS[join])
        return 0

    # what acts on the whole flow

    def acting(self, part: Node, *, in_line: bool, at_rail: bool) -> None:
        """Write NOT, an edge on the wire, or parallel paths with such in them."""
        if not in_line:
            self.refuse(_NOTHING_LEFT.format(word=_name(part)))
        if not at_rail:
            self.refuse(_NOT_THERE)
        match part:
            case Invert():
                self.emit(self.insn("invert"), of=part)
            case Edge():
                self.edge(part)
            case Parallel():
                self.paths(part)

    def edge(self, edge: Edge, reason: Text = NOTHING) -> None:
        """Write an edge of the flow, with its bit where the family wants one."""
        insn = edge_word(self.dialect, rising=edge.rising)
        if insn is None:
            self.refuse(
                Text(
                    "这个系列没有取能流之沿的指令，只有单个位的沿触点",
                    "the family has no instruction for an edge of the flow, only edge contacts of single bits",
                )
            )
        if insn.operands and not edge.memory:
            self.refuse(
                Text(
                    f"{insn.mnemonic}要用一个位记住上次的能流，梯形图里没有给出这个位（写成{edge.mark}:位）",
                    f"{insn.mnemonic} needs a bit that remembers the last flow, and the ladder names none (write {edge.mark}:bit)",
                )
            )
        if edge.memory and not insn.operands:
            self.refuse(
                Text(
                    f"{insn.mnemonic}自己记住上次的能流，用不上{edge.memory}",
                    f"{insn.mnemonic} remembers the last flow by itself and has no use for {edge.memory}",
                )
            )
        where = (self.address(edge.memory, insn),) if insn.operands else ()
        self.emit(insn, *where, reason=reason, of=edge)

    def anew(self, parts: tuple[Node, ...]) -> int:
        """Give the number of the part whose paths are to begin at the rail again; 0 where a kept copy of the flow serves."""
        at = next((at for at, part in enumerate(parts) if at and isinstance(part, Parallel) and wired(part)), 0)
        kept = "copy" in self.dialect.roles and not self.pending
        return 0 if kept or _remembers(parts[:at]) else at

    def paths(self, node: Parallel) -> None:
        """Write parallel paths that act on the flow, each from a copy of it."""
        copies = "copy" in self.dialect.roles and self.pending == 1
        push = self.insn("push")
        beside = any(clause.stack for clause in push.effect.clauses)
        if not copies and not (beside and not self.insn("load").effect.clauses[0].takes):
            self.refuse(_NOT_THERE)
        self.emit(push, reason=REASONS["keep"])
        self.onward(in_series(node.parts[0]), "join_series", at_rail=True)
        for path in node.parts[1:]:
            if copies:
                self.emit(self.insn("copy"), 1, reason=REASONS["copy"])
            else:
                self.emit(self.insn("load"), self.always(), reason=REASONS["room"])
                self.emit(self.insn("pop" if path is node.parts[-1] else "read"), reason=REASONS["copy"])
            self.onward(in_series(path), "join_series", at_rail=True)
            self.join("join_parallel", 1)
        self.residue += copies

    def always(self) -> Address:
        """Give the bit that is always on."""
        return self.address(self.dialect.special("on"), self.insn("load"))

    # contacts

    def contact(self, role: Role, contact: Contact | Compared) -> None:
        """Write one contact; its edge is a block where the family has no contact of that kind."""
        found = contact_word(self.dialect, role, contact)
        plain = found
        if found is None and isinstance(contact, Contact) and contact.edge:
            plain = contact_word(self.dialect, role, Contact(contact.address))
        if plain is None:
            self.refuse(_no_contact(contact))
        operands = (self.operand(plain, contact),) if plain.operands else ()
        self.emit(plain, *operands, reason=self.why(role, contact), of=contact)
        if found is None and isinstance(contact, Contact):
            self.contact_edge(contact)

    def why(self, role: Role, contact: Contact | Compared) -> Text:
        """Say why a contact begins a block."""
        number = self.numbers.get(id(contact), -1)
        seen = number in self.written
        self.written.add(number)
        if not any(self.stacks.values()):
            return NOTHING
        word = {"join_series": "open_series", "join_parallel": "open_parallel"}.get(role, role)
        return REASONS["again"] if seen and word in REASONS else REASONS.get(word, NOTHING)

    def operand(self, insn: Insn, contact: Contact | Compared) -> Arg:
        """Give what a contact's instruction stands before: an address, or two words compared."""
        if isinstance(contact, Contact):
            return self.address(contact.address, insn)
        load = contact_word(self.dialect, "load", contact) or insn
        lines = self.read(comparing(load, contact))
        if len(lines) > 1 or lines[0].insn is not load:
            self.refuse(Text(f"“{contact.text}”不是一个比较", f'"{contact.text}" is not one comparison'))
        return lines[0].args[0]

    def contact_edge(self, contact: Contact) -> None:
        """Write the edge of the value just loaded."""
        found = edge_word(self.dialect, rising=contact.edge == "rise")
        if found is None or found.operands:
            self.refuse(
                Text(
                    f"{contact.address}的沿在这个系列里要用一个位记住上次的状态，梯形图里没有给出这个位",
                    f"the edge of {contact.address} needs a bit here that remembers the last flow, and the ladder names none",
                )
            )
        self.emit(found, reason=REASONS["edge"], of=contact)


def _name(node: Node) -> str:
    return node.mark if isinstance(node, Edge) else "NOT"


def _no_contact(contact: Contact | Compared) -> Text:
    if isinstance(contact, Compared):
        return Text(
            f"这个系列没有比较触点[{contact.text}]的指令", f"the family has no comparing contact for [{contact.text}]"
        )
    sign = f"{contact.mark}{contact.address}"
    if contact.immediate:
        return Text(
            f"这个系列没有立即触点[{sign}]",
            f"the family has no contact that reads an input immediately, as [{sign}] does",
        )
    return Text(f"这个系列没有触点[{sign}]的指令", f"the family has no instruction for the contact [{sign}]")
