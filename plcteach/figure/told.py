"""The words for what an instruction works on: a cell, a bit, its inverse, its edge, with its value where there is one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plcteach.core.effect import Both, Edge, Flow, Name, Not, names
from plcteach.core.insn import REGISTERS
from plcteach.core.program import Compare, Value
from plcteach.core.text import NOTHING, Text, joined, same
from plcteach.figure.compared import comparison
from plcteach.machine.sums import real

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.effect import Formula, Place
    from plcteach.core.program import Line
    from plcteach.core.spec import Dialect, Stack
    from plcteach.machine.signals import Column
    from plcteach.machine.step import Step


@dataclass(frozen=True, slots=True)
class Told:
    """What there is to tell: an instruction's flow and, where it has run, its values; `first`: in the first scan.

    named: without values the operands are told by the names that the line has, and not as "the operand".
    """

    dialect: Dialect
    line: Line
    flow: Flow
    step: Step[Column] | None = None
    first: bool = False
    named: bool = False

    @property
    def main(self) -> Stack:
        """The stack on which everything is combined."""
        return self.dialect.stacks[0]

    @property
    def result(self) -> Text:
        """The place where the result of everything stands: the top, or the register above the stack."""
        register = self.main.register
        return Text(register.zh, f"the {register.en}") if register else Text("栈顶", "the top")

    def was(self, place: Place = (0, 0)) -> str:
        """Give the value that a cell held before, or nothing when only names are told."""
        if self.step is None or place[1] >= len(self.step.before[place[0]]):
            return ""
        return repr(self.step.before[place[0]][place[1]])

    @property
    def value(self) -> str:
        """The value of the result afterwards, or nothing."""
        return repr(self.step.after[0][0]) if self.step and self.step.after[0] else ""

    @property
    def bit(self) -> str:
        """The value of the bit that was read, or nothing."""
        return repr(self.step.read[0][1]) if self.step and self.step.read else ""

    @property
    def written(self) -> str:
        """The value that was written, or nothing."""
        return repr(self.step.written[0][1]) if self.step and self.step.written else ""

    def cell(self, place: Place = (0, 0), *, numbered: bool = False) -> Text:
        """Name a cell, with its value in brackets where it has one; `numbered` calls the top level 1."""
        stack = self.dialect.stacks[place[0]]
        if place[0]:
            level = stack.level(place[1])
            words = Text(f"{stack.title.zh}{level.zh}", f"{level.en} of the {stack_name(stack).en}")
            if not place[1]:
                words = Text(f"{stack.title.zh}栈顶", f"the top of the {stack_name(stack).en}")
        elif place[1] or (numbered and not self.main.register):
            words = stack.level(place[1])
        else:
            words = self.result
        return with_value(words, self.was(place))

    def address(self, name: str) -> str:
        """Spell an operand as the line has it."""
        arg = self.line.bound.get(name, "")
        if isinstance(arg, Compare):
            return comparison(arg)
        return str(arg) if isinstance(arg, int | str) else arg.text


def with_value(words: Text, value: str) -> Text:
    """Put a value in brackets behind words."""
    return Text(f"{words.zh}（{value}）", f"{words.en} ({value})") if value else words


def stack_name(stack: Stack) -> Text:
    """Give a stack's name as a sentence wants it."""
    return stack.title if stack.title.en.endswith("stack") else Text(stack.title.zh, f"{stack.title.en} stack")


def inverse(value: str) -> str:
    """Invert a value's sign; x stays x."""
    return {"0": "1", "1": "0"}.get(value, value)


def side(told: Told, formula: Formula, op: str) -> Text:
    """Name one side of an operation: a cell or its inverse with its value, or what the operand gives."""
    name = formula.name if isinstance(formula, Name) else ""
    inner = formula.of.name if isinstance(formula, Not) and isinstance(formula.of, Name) else ""
    if name in told.flow.named:
        return told.cell(told.flow.named[name], numbered=len(told.flow.named) > 1)
    if inner in told.flow.named:
        place = told.flow.named[inner]
        words = Told(told.dialect, told.line, told.flow).cell(place)
        return with_value(Text(f"{words.zh}的反", f"the inverse of {words.en}"), inverse(told.was(place)))
    if name in REGISTERS:
        return (
            Text(f"{name}（上一个功能框正常时为1）", f"{name} (1 where the last box went well)")
            if not told.step
            else same(name)
        )
    if name and name not in told.line.bound:
        return same("x")
    return _operand_side(told, formula, op) if told.step else operand_name(told, formula)


def _operand_side(told: Told, formula: Formula, op: str) -> Text:
    match formula:
        case Edge(rising, _):
            known = edge_value(told, op, rising=rising)
            return same(known) if known else Text("这个沿", "that edge")
        case Not():
            return same(inverse(told.bit))
        case Name(name):
            return with_value(same(told.address(name)), told.bit)
    return operand_name(told, formula)


def edge_value(told: Told, op: str, *, rising: bool) -> str:
    """Give the value of an operand's edge, as far as it can be seen: 0 AND anything is 0, and nothing rises to 0."""
    before, result = told.was(), told.value
    if told.first or (told.bit == ("0" if rising else "1") and not told.dialect.samples_edges_at_start):
        return "0"
    if not op or (op, before) in {("&", "1"), ("|", "0"), ("^", "0")}:
        return result
    return inverse(result) if (op, before) == ("^", "1") else ""


def edge_seen(told: Told, what: Text, value: str, *, rising: bool) -> Text:
    """Say whether something has risen (fallen) since the last scan, from the value that its edge has."""
    if told.first and value == "0":
        return Text("第一个扫描周期没有沿", "in the first scan there is no edge")
    if value == "x":
        return Text("{what}有没有变化无法知道", "nobody knows whether {what} has changed").format(what=what)
    turn = Text("由0变1" if rising else "由1变0", "risen" if rising else "fallen")
    if value == "1":
        return Text("{what}自上次扫描以来{turn}", "{what} has {turn} since the last scan").format(what=what, turn=turn)
    return Text("{what}自上次扫描以来没有{turn}", "{what} has not {turn} since the last scan").format(
        what=what, turn=turn
    )


def operand_name(told: Told, formula: Formula) -> Text:
    """Name what an operand gives where there are no values."""
    for name in names(formula):
        arg = told.line.bound.get(name)
        if isinstance(arg, Compare):
            said = Text("{it}的比较结果（成立为1，不成立为0）", "the comparison {it} (1 where it holds, 0 where not)")
            return said.format(it=comparison(arg))
        if arg is not None and told.named and isinstance(formula, Name):
            relay = Text("继电器", "relay ") if told.line.insn.powers else NOTHING
            return Text(f"{relay.zh}{told.address(name)}", f"{relay.en}{told.address(name)}")
    match formula:
        case Edge(rising, _):
            return Text(
                "操作数的上升沿" if rising else "操作数的下降沿",
                f"the operand's {'rising' if rising else 'falling'} edge",
            )
        case Not():
            return Text("操作数的反", "the inverse of the operand's bit")
    return Text("操作数的位", "the operand's bit")


def _compared(told: Told, compare: Compare, value: str) -> Text:
    """Say whether a comparison holds, with the words that were compared where the step has read them."""
    as_real = told.dialect.kinds[compare.kind].real
    words = {place: word for place, word in told.step.read if not isinstance(place, Compare)} if told.step else {}
    seen = []
    for place in (compare.left, compare.right):
        word: Any = None if isinstance(place, Value) else words.get(place)
        if word is not None:
            number = word.value
            said = "x" if number is None else f"{real(number):.7g}" if as_real else str(number)
            seen.append(Text(f"{place.text}为{said}", f"{place.text} is {said}"))
    holds = {"1": Text("成立", "is true"), "0": Text("不成立", "is false")}
    what = holds.get(value, Text("是否成立无法知道", "may be true or false"))
    brackets = with_text(joined(seen, "，", ", "))
    return Text("{it}{what}{seen}", "{it} {what}{seen}").format(it=comparison(compare), what=what, seen=brackets)


def with_text(words: Text) -> Text:
    """Put words in brackets, if there are any."""
    return Text(f"（{words.zh}）", f" ({words.en})") if words.zh else NOTHING


def operand_said(told: Told, formula: Formula) -> Text | None:
    """Say what the bit of the operand is, inverted or with its edge where the formula wants it so; None without values."""
    if not told.step or not told.step.read:
        return None
    place, op = told.step.read[0][0], formula.op if isinstance(formula, Both) else ""
    if isinstance(place, Compare):
        return _compared(told, place, told.bit)
    address = place.text
    for part in _parts(formula):
        if isinstance(part, Edge):
            known = edge_value(told, op, rising=part.rising)
            if known:
                return edge_seen(told, with_value(same(address), told.bit), known, rising=part.rising)
            turn = Text("上升沿" if part.rising else "下降沿", "rising" if part.rising else "falling")
            said = Text("{bit}为{value}，这里看它的{turn}", "{bit} is {value}, and its {turn} edge is wanted")
            return said.format(bit=address, value=told.bit, turn=turn)
        if isinstance(part, Not) and not names(part) & set(told.flow.named):
            said = Text("{bit}为{value}，取反得{inverse}", "{bit} is {value}, inverted {inverse}")
            return said.format(bit=address, value=told.bit, inverse=inverse(told.bit))
    return Text("{bit}为{value}", "{bit} is {value}").format(bit=address, value=told.bit)


def plain(told: Told, formula: Formula) -> bool:
    """Say whether the operand's bit is used as it is, neither inverted nor for its edge."""
    operands = set(told.line.bound)
    return not any(isinstance(part, Not | Edge) and names(part) & operands for part in _parts(formula))


def _parts(formula: Formula) -> Iterator[Formula]:
    yield formula
    if isinstance(formula, Both):
        yield from _parts(formula.left)
        yield from _parts(formula.right)
