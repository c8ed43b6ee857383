"""The words for what an instruction writes: coils, inverted coils, set and reset, pulses, and what some edges keep."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.effect import Edge, Not
from plcteach.core.text import NOTHING, Text, same
from plcteach.figure.told import edge_seen, with_value
from plcteach.figure.when import when

if TYPE_CHECKING:
    from plcteach.core.verb import Verb
    from plcteach.figure.told import Told


def writes(told: Told, verb: Verb) -> Text:
    """Say what is written where, and whether it changes anything."""
    bits, be = _bits(told, verb)
    if verb.name != "coil":
        return _sets(told, verb, bits, be)
    if isinstance(verb.formula, Edge):
        return _pulse(told, bits, rising=verb.formula.rising)
    unknown = Text("，是0还是1谁也不知道", ", which may be 0 or 1") if told.written == "x" else NOTHING
    value = Text(f"的{told.written}", f", {told.written},") if told.written else Text("的值", "")
    if isinstance(verb.formula, Not):
        said = Text("{it}取反得{value}，写入{bits}{x}", "{it} is inverted on the way: {value} is written to {bits}{x}")
        if not told.written:
            said = Text("{it}的反写入{bits}", "the inverse of {it} is written to {bits}")
        return said.format(it=told.cell(), value=told.written, bits=bits, x=unknown)
    if told.flow.after[0] and told.flow.after[0][0].how == "made":
        said = Text(
            "{it}原来的值{value}存入{bits}，下一个扫描周期用它比较",
            "what {it} was{value} is kept in {bits} for the next scan",
        )
        return said.format(it=told.result, value=with_value(NOTHING, told.written), bits=bits)
    return Text("{it}{value}写入{bits}{x}", "{it}{value} is written to {bits}{x}").format(
        it=told.result, value=value, bits=bits, x=unknown
    )


def _pulse(told: Told, bits: Text, *, rising: bool) -> Text:
    if not told.written:
        turn = Text("由0变1" if rising else "由1变0", "rises" if rising else "falls")
        said = Text("{it}{turn}时，{bits}接通一个扫描周期", "when {it} {turn}, {bits} is on for one scan")
        return said.format(it=told.result, turn=turn, bits=bits)
    why = edge_seen(told, told.cell(), told.written, rising=rising)
    return Text("{why}，{value}写入{bits}", "{why}, so {value} is written to {bits}").format(
        why=why, value=told.written, bits=bits
    )


def _bits(told: Told, verb: Verb) -> tuple[Text, Text]:
    """Name the bits that are written, with the verb that fits them."""
    target = told.address(verb.target) if told.step or told.named else ""
    count = told.line.bound.get(verb.count, 1)
    if verb.sources:
        last = told.address(verb.sources[0])
        return Text(f"{target}到{last}", f"{target} to {last}"), same("are")
    if told.step and isinstance(count, int) and count > 1:
        return Text(f"从{target}起的{count}个位", f"the {count} bits from {target}"), same("are")
    return Text(target or "操作数指定的位", target or "the operand's bit"), same("is")


def _sets(told: Told, verb: Verb, bits: Text, be: Text) -> Text:
    does = Text("置位（写1）", "set to 1") if verb.name == "set" else Text("复位（写0）", "reset to 0")
    more = _more(told, verb)
    yes = Text("{bits}{does}{more}", "{bits} {be} {does}{more}").format(bits=bits, does=does, be=be, more=more)
    nothing = Text("什么也不改变", "nothing changes")
    if isinstance(verb.formula, Edge):
        return when(told, verb, yes, nothing, Text("{bits}", "{bits}").format(bits=_now(told)))
    said = {
        "": Text("{it}为1时，{yes}；为0时什么也不改变", "if {it} is 1, {yes}; if it is 0, nothing changes"),
        "1": Text("{it}为1，{yes}", "{it} is 1, so {yes}"),
        "0": Text("{it}为0，{bits}不改变", "{it} is 0, so nothing changes in {bits}"),
    }.get(
        told.was(), Text("{it}为x，{bits}是否{does}无法知道", "{it} is x, so nobody knows whether {bits} {be} {does}")
    )
    return said.format(it=told.result, bits=bits, does=does, be=be, yes=yes)


def _now(told: Told) -> Text:
    """Say what the bits are that may have been written."""
    each = [f"{place.text} = {value!r}" for place, value in told.step.written[:_MOST]] if told.step else []
    more = ", …" if told.step and len(told.step.written) > _MOST else ""
    return same(", ".join(each) + more)


_MOST = 4


_COUNTING = {"timer", "counter"}


def _more(told: Told, verb: Verb) -> Text:
    """Say that a timer or counter loses its current value with its bit."""
    target = told.line.bound.get(verb.target)
    if verb.name != "reset" or not told.step or not isinstance(target, Address) or target.field:
        return NOTHING
    block = told.dialect.block(target)
    return (
        Text("，当前值也清零", ", and the current value becomes 0 too")
        if block and block.rule in _COUNTING
        else NOTHING
    )


def besides(told: Told, verb: Verb) -> Text:
    """Say on a card what a set or reset does beside its bit: a timer loses its time, a step that sets another one ends."""
    operand = next((one for one in told.line.insn.operands if one.name == verb.target), None)
    if operand is None or not operand.kind:
        return NOTHING
    areas = told.dialect.kinds[operand.kind].areas
    if verb.name == "set":
        openers = (row for row in told.dialect.insns if any(one.name == "step" for one in row.then))
        steps = {area for row in openers for area in told.dialect.kinds[row.operands[0].kind].areas}
        ends = Text(
            "在一步里置位另一步的继电器，这一步随本次扫描结束",
            "Where a step sets the relay of another step, it ends with the scan",
        )
        return ends if steps & areas else NOTHING
    if verb.name == "reset" and any(block.area in areas and block.rule in _COUNTING for block in told.dialect.blocks):
        return Text("定时器和计数器的当前值也清零", "A timer or counter loses its current value too")
    return NOTHING
