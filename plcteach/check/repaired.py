"""A proved repair, told in stages: where to look, what kind of change it is, and the change."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.core.text import Text

if TYPE_CHECKING:
    from plcteach.check.edits import Edit, Kind
    from plcteach.core.program import Program


@dataclass(frozen=True, slots=True)
class Repair:
    """One edit that is proved to mend a program."""

    edit: Edit
    program: Program

    def __repr__(self) -> str:
        return f"Repair({self.kind} at row {self.row}: {self.before!r} -> {self.after!r})"

    @property
    def kind(self) -> Kind:
        """What sort of edit it is."""
        return self.edit.kind

    @property
    def text(self) -> str:
        """The mended list, which is the one that was proved."""
        return self.edit.text

    @property
    def row(self) -> int:
        """The row of the learner's text at which it begins; for an insertion the row above it, 0 at the very beginning."""
        if self.edit.at < 0:
            rows = (row.upper().split() for row in self.program.source.splitlines())
            return next((number for number, row in enumerate(rows, 1) if row == self.before.upper().split()), 0)
        lines = self.program.lines
        if self.edit.before:
            return lines[self.edit.at].span.row
        return lines[self.edit.at - 1].span.row if self.edit.at else 0

    @property
    def before(self) -> str:
        """The instructions that go, one a row."""
        return "\n".join(self.edit.before)

    @property
    def after(self) -> str:
        """The instructions that come, one a row."""
        return "\n".join(self.edit.after)

    def stages(self) -> tuple[Text, Text, Text]:
        """Give three hints, each saying more than the one before: where, of what kind, and the edit."""
        return self._where(), _KINDS[self.kind], self._edit()

    def _where(self) -> Text:
        row = self.row
        if self.kind in {"order", "priority"}:
            last = self.program.lines[self.edit.stop - 1].span.row
            return Text(
                f"看第{row}到第{last}行：只在这里改一处，程序就符合要求。",
                f"Look at rows {row} to {last}: one change there is enough.",
            )
        if self.kind == "heading":
            return Text(
                f"看第{row}行上面，新的网络从那里开始：只在那里改一处就够了。",
                f"Look just above row {row}, where a new network begins: one change there is enough.",
            )
        if not row:
            return Text(
                "看程序的开头：只在那里改一处就够了。", "Look at the very beginning: one change there is enough."
            )
        if self.edit.before:
            return Text(
                f"看第{row}行：{self.before}。只改这一行，程序就符合要求。",
                f"Look at row {row}: {self.before}. A change in this row alone is enough.",
            )
        return Text(
            f"看第{row}行的后面：只在那里改一处就够了。", f"Look just behind row {row}: one change there is enough."
        )

    def _edit(self) -> Text:
        before, after = self.before, self.after
        if self.kind == "heading":
            return Text(
                "去掉那里的网络标题，两个网络合成一个。",
                "Take the heading there away, so that the two networks become one.",
            )
        if self.kind in {"order", "priority"}:
            first, second = self.edit.before[0], self.edit.after[0]
            return Text(
                f"把从{first}开始的梯级和从{second}开始的梯级对调。",
                f"Let the rung that begins with {first} and the one that begins with {second} change places.",
            )
        if not self.row:
            into = Text(f"把{before}改成{after}。", f"Make {before} into {after}.")
            return into if before else Text(f"在最前面加一行：{after}。", f"Put {after} before the first row.")
        return _in_row(self.row, before, after)


def _in_row(row: int, before: str, after: str) -> Text:
    if not after:
        return Text(f"去掉第{row}行的{before}。", f"Take {before} out of row {row}.")
    if before:
        return Text(f"把第{row}行的{before}改成{after}。", f"In row {row} make {before} into {after}.")
    return Text(f"在第{row}行后面加一行：{after}。", f"Put {after} behind row {row}.")


_KINDS: dict[Kind, Text] = {
    "join": Text(
        "问题在于串联还是并联：这里用的是其中一种，改成另一种就对了。",
        "It is about series and parallel: here stands one of the two, and the other makes it right.",
    ),
    "branch": Text(
        "问题在于分支点：这里是保存、看一眼，还是取走？",
        "It is about the branch point: is it saved here, looked at, or fetched?",
    ),
    "start": Text(
        "问题在于电路块从哪里开始：这一行是开始新的一块，还是接在前面的触点上？",
        "It is about where a block begins: does this row begin a new one, or does it go on from the contacts above?",
    ),
    "invert": Text(
        "问题在于一个值和它的反：常开还是常闭，上升沿还是下降沿。",
        "It is about a value and its opposite: normally open or closed, rising or falling.",
    ),
    "contact": Text(
        "地址可以不变，要换的是触点的种类：怎样读这个位，什么时候读，或怎样比较。",
        "The address can stay; what changes is the sort of contact: how or when it is read, or how it compares.",
    ),
    "priority": Text(
        "问题在于先后：置位和复位同时有效时，后执行的说了算。",
        "It is about the order: where set and reset are both asked for, the one that is executed later has its way.",
    ),
    "order": Text(
        "问题在于梯级的先后：先写后用，当个扫描就见效；先用后写，要等下一个扫描。",
        "It is about the order of rungs: a bit written before it is used acts in this scan, one written after in the next.",
    ),
    "number": Text("问题在于一个数。", "It is about a number."),
    "block": Text(
        "操作数可以不变，要换的是指令：哪一种定时器或计数器，或者是置位还是复位。",
        "The operands can stay; what changes is the instruction: which sort of timer or counter, or set or reset.",
    ),
    "operand": Text("指令可以不变，要换的是操作数：说的是哪一个地址？", "The instruction can stay; what changes is the operand: which address is meant?"),
    "delete": Text("这里有一条指令是多余的。", "One instruction here is too many."),
    "insert": Text("这里少了一条指令。", "One instruction is missing here."),
    "heading": Text(
        "问题在于网络从哪里分开：堆栈里的值不留给下一个网络。",
        "It is about where networks part: no value on the stack is kept for the next one.",
    ),
    "setting": Text("问题在于这一行设定的一个值。", "It is about one value that this row sets."),
}  # fmt: skip
