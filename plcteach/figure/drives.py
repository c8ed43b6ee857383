"""The words for function blocks: what each rule does with its pins, and what a block has come to."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from plcteach.core.area import Address
from plcteach.core.effect import Name
from plcteach.core.program import Value
from plcteach.core.text import NOTHING, Text, joined, same
from plcteach.figure.face import lasting
from plcteach.figure.told import with_value

if TYPE_CHECKING:
    from plcteach.core.block import Block
    from plcteach.core.verb import Verb
    from plcteach.figure.told import Told

_TIMERS = {
    "on": Text(
        "{IN}为1时，{t}以{base}为单位计时；计到{goal}起{t}为1{then}；{in_}为0时，时间回到0，{t}为0",
        "while {IN} is 1, {t} counts time in steps of {base}; from {goal} on {t} is 1{then}; when {in_} is 0, "
        "the time is back at 0 and {t} is 0",
    ),
    "retentive": Text(
        "{IN}为1时，{t}以{base}为单位计时；计到{goal}起{t}为1{then}；{in_}为0时，时间和{t}都保持，要用复位指令清零",
        "while {IN} is 1, {t} counts time in steps of {base}; from {goal} on {t} is 1{then}; while {in_} is 0, "
        "{t} keeps its time and its bit, until it is reset",
    ),
    "off": Text(
        "{IN}为1时，{t}为1，时间为0；{in_}由1变0后，{t}以{base}为单位计时，计到{goal}时{t}变为0",
        "while {IN} is 1, {t} is 1 and its time is 0; after {in_} has fallen, {t} counts time in steps of {base}, "
        "and at {goal} {t} becomes 0",
    ),
}
_TYPES = {
    "on": Text("IN持续为1达到设定时间后Q为1", "Q is 1 once IN has been 1 for the time set"),
    "off": Text("IN变为0之后Q再保持设定的时间", "Q stays 1 for the time set after IN has fallen"),
    "pulse": Text("IN由0变1时Q接通，只接通设定的时间", "Q is 1 for the time set from when IN rises"),
}
_COUNTERS = {
    "up": Text(
        "{CU}每次由0变1，{c}加1；计到{goal}起{c}为1；{R}为1时，当前值和{c}都为0",
        "each time {CU} rises, {c} counts one up; from {goal} on {c} is 1; while {R} is 1, the count and {c} are 0",
    ),
    "down": Text(
        "{LD}为1时，当前值为{goal}，{c}为0；{CD}每次由0变1，当前值减1；减到0时{c}为1",
        "while {LD} is 1, the count is {goal} and {c} is 0; each time {CD} rises, it counts one down; at 0 {c} is 1",
    ),
    "updown": Text(
        "{CU}每次由0变1，{c}加1；{CD}每次由0变1，{c}减1；当前值不小于{goal}时{c}为1；{R}为1时，当前值和{c}都为0",
        "each time {CU} rises, {c} counts one up, and each time {CD} rises, one down; while the count is {goal} or more, "
        "{c} is 1; while {R} is 1, the count and {c} are 0",
    ),
    "upto": Text(
        "{CU}每次由0变1，{c}加1；计到{goal}时{c}变为1，不再往上计，直到被复位",
        "each time {CU} rises, {c} counts one up; at {goal} {c} becomes 1 and the counting ends, until it is reset",
    ),
}
_PINS = {
    "timer.IN": NOTHING,
    "counter.R": Text("为1时，{c}.V为0", "while it is 1, {c}.V is 0"),
    "counter.S": Text("为1时，{c}.V等于预设值{c}.P", "while it is 1, {c}.V is the preset {c}.P"),
    "counter.CU": Text(
        "每次由0变1，{c}.V加1（9999之后是0，这时F为1）；{c}.V等于{c}.P时D为1",
        "each time it rises, {c}.V counts one up (after 9999 comes 0, and F is 1); while {c}.V equals {c}.P, D is 1",
    ),
    "counter.CD": Text(
        "每次由0变1，{c}.V减1（0之后是9999，这时E为1）；{c}.V等于{c}.P时D为1",
        "each time it rises, {c}.V counts one down (after 0 comes 9999, and E is 1); while {c}.V equals {c}.P, D is 1",
    ),
    "drum.R": Text("为1时，{c}回到第0步", "while it is 1, {c} stands at step 0"),
    "drum.U": Text(
        "每次由0变1，{c}前进一步，最后一步之后回到第0步，并把这一步的控制位写到它的输出",
        "each time it rises, {c} goes one step on, from the last to step 0, and writes that step's control bits to its outputs",
    ),
    "bits.R": Text("为1时，{c}的16位都为0", "while it is 1, the sixteen bits of {c} are 0"),
    "bits.CU": Text(
        "每次由0变1，{c}的各位向高位移一位，{c}.0补0，{c}.15移出{out}",
        "each time it rises, the bits of {c} move one place up: 0 enters at {c}.0, and {c}.15 falls out{out}",
    ),
    "bits.CD": Text(
        "每次由0变1，{c}的各位向低位移一位，{c}.15补0，{c}.0移出{out}",
        "each time it rises, the bits of {c} move one place down: 0 enters at {c}.15, and {c}.0 falls out{out}",
    ),
    "steps.R": Text("为1时，{c}回到第0步，只有{c}.0为1", "while it is 1, {c} stands at step 0, and only {c}.0 is 1"),
    "steps.CU": Text(
        "每次由0变1，{c}前进一步：只有这一步的位为1（到第255步为止）",
        "each time it rises, {c} goes one step on: only that step's bit is 1 (255 is the last)",
    ),
    "steps.CD": Text(
        "每次由0变1，{c}后退一步：只有这一步的位为1（到第0步为止）",
        "each time it rises, {c} goes one step back: only that step's bit is 1 (0 is the first)",
    ),
    "queue.R": Text("为1时，{c}清空", "while it is 1, {c} is emptied"),
    "queue.I": Text("每次由0变1，把{c}.I的字存入{c}", "each time it rises, the word in {c}.I is stored in {c}"),
    "queue.O": Text(
        "每次由0变1，从{c}取出一个字放到{c}.O：先进先出取最早的，后进先出取最近的",
        "each time it rises, {c} gives a word to {c}.O: FIFO the oldest, LIFO the newest",
    ),
}


def _driven(told: Told, verb: Verb) -> tuple[Address | None, Block | None]:
    """Give the block that a verb works on: its address and its declaration."""
    target = told.line.bound.get(verb.target)
    return (target, told.dialect.block(target)) if isinstance(target, Address) else (None, None)


def drives(told: Told, verb: Verb) -> Text:
    """Say what an instruction makes its timer or counter do, or what the block has come to."""
    target, block = _driven(told, verb)
    if target is None or block is None:
        return NOTHING
    if told.step:
        seen = [
            Text("{pin}为{value}", "{pin} is {value}").format(pin=pin, value=_level(told, verb, name) or "x")
            for name, pin in _located(told, verb).items()
        ]
        return Text("{seen}；{state}", "{seen}; {state}").format(
            seen=joined(seen, "，", ", "), state=state(told, target, verb)
        )
    if block.rule == "timer":
        return _timer_rule(told, verb, target, block)
    pins = _located(told, verb)
    return _COUNTERS[verb.op].format(**pins, c=target.text, goal=_preset(told, verb))


def _located(told: Told, verb: Verb) -> dict[str, Text]:
    """Name the pins by where they stand: by the table's name with its level, or by the result they get."""
    found = {}
    for name, formula in verb.pins:
        if isinstance(formula, Name) and formula.name in told.flow.named:
            bare = _bare(told, formula.name)
            found[name] = with_place(name, bare) if formula.name == name else bare
        else:
            found[name] = same(name)
    return found


def _bare(told: Told, taken: str) -> Text:
    """Name a cell by its level, without its value."""
    number, place = told.flow.named[taken]
    return told.result if not place else told.dialect.stacks[number].level(place)


def with_place(name: str, place: Text) -> Text:
    """Put a level in brackets behind a pin's name."""
    return Text(f"{name}（{place.zh}）", f"{name} ({place.en})")


def _level(told: Told, verb: Verb, pin: str) -> str:
    formula = dict(verb.pins)[pin]
    place = told.flow.named.get(getattr(formula, "name", ""))
    return told.was(place) if place else ""


def _preset(told: Told, verb: Verb) -> str:
    arg = told.line.bound.get(verb.sources[0]) if verb.sources else None
    return str(int(arg.number)) if isinstance(arg, Value) else arg.text if isinstance(arg, Address) else "P"


def _timer_rule(told: Told, verb: Verb, target: Address, block: Block) -> Text:
    bank = block.bank(target.index)
    ((name, formula),) = verb.pins
    short = same(name) if getattr(formula, "name", "") == name else told.result
    arg = told.line.bound.get(verb.sources[0])
    steps = int(arg.number) if isinstance(arg, Value) else None
    goal = Text(f"{_preset(told, verb)}步", f"{_preset(told, verb)} steps")
    if steps is not None:
        goal = with_place(f"{steps}", same(lasting(steps * bank.base)))
        goal = Text(goal.zh, f"{steps} steps ({lasting(steps * bank.base)})")
    then = Text("，时间不再增加", ", and the time stops there")
    if not block.stops:
        then = Text(f"，时间继续增加（最多{block.most}）", f", while the time goes on up to {block.most}")
    values = {"IN": _located(told, verb)[name], "in_": short, "t": target.text, "base": lasting(bank.base)}
    return _TIMERS[bank.rule(verb.op)].format(**values, goal=goal, then=then)


def pins(told: Told, verb: Verb) -> Text:
    """Say what a pin does with the value that it gets, or what came of it."""
    target, block = _driven(told, verb)
    if target is None or block is None:
        return NOTHING
    it = with_value(told.result, told.was())
    goes = Text("{it}接到{c}的{pin}", "{it} goes to pin {pin} of {c}").format(it=it, c=target.text, pin=verb.op)
    if told.step:
        if any(asked is verb for asked, _ in told.step.asks):
            return Text("{goes}，等输入部分结束时起作用", "{goes}, which acts when its inputs are complete").format(
                goes=goes
            )
        return Text("{goes}；{state}", "{goes}; {state}").format(goes=goes, state=state(told, target, verb))
    said = (
        Text("{goes}；{what}", "{goes}; {what}") if block.rule == "timer" else Text("{goes}：{what}", "{goes}: {what}")
    )
    return said.format(goes=goes, what=_pin_rule(told, block, target, verb.op))


def _pin_rule(told: Told, block: Block, target: Address, pin: str) -> Text:
    if block.rule != "timer":
        flag = told.dialect.flags.get("out", "")
        out = Text(f"到{flag}" if flag else "", f" into {flag}" if flag else "")
        return _PINS[f"{block.rule}.{pin}"].format(c=target.text, out=out)
    choices = (block.settings or {})["TYPE"].choices or {}
    each = [
        Text("TYPE={type}时，{what}", "with TYPE={type} {what}").format(type=word, what=_TYPES[str(op)])
        for word, op in choices.items()
    ]
    return joined(each, "；", "; ")


def opens(told: Told, verb: Verb) -> Text:
    """Say which pins a block waits for."""
    target, block = _driven(told, verb)
    if target is None or block is None:
        return NOTHING
    said = Text(
        "{c}的输入部分从这里开始：引脚{pins}，没有接的引脚为0",
        "the inputs of {c} begin here: {pins}; a pin that gets nothing is 0",
    )
    named = Text("、".join(block.pins), ("pin " if len(block.pins) == 1 else "pins ") + ", ".join(block.pins))
    return said.format(c=target.text, pins=named)


def updates(told: Told, verb: Verb) -> Text:
    """Say that a block acts on its pins, or only that its section ends."""
    target, block = _driven(told, verb)
    if told.step and not told.step.written and not told.step.numbers:
        return Text("功能块部分到此结束", "the block's section ends here")
    if target is None or block is None:
        return Text("功能块按引脚上的值动作一次", "the block acts once on what its pins have been given")
    if told.step:
        said = Text("{c}按引脚上的值动作一次；{state}", "{c} acts once on what its pins have been given; {state}")
        return said.format(c=target.text, state=state(told, target, verb))
    said = Text(
        "{c}的输入部分到此结束，它按引脚上的值动作一次；如果前面已经动作过，这里只表示结束",
        "the inputs of {c} end here, and it acts once on what its pins have been given; if it has acted already, "
        "this only closes its section",
    )
    return said.format(c=target.text)


def state(told: Told, target: Address, verb: Verb) -> Text:
    """Say what a block has come to."""
    block = told.dialect.block(target)
    assert told.step and block  # noqa: PT018, S101 (asked for steps of blocks only)
    written = {place.text: value for place, value in told.step.written}
    said: Text = _STATES[block.rule](told, target, verb, written)
    return said


def _timer_state(told: Told, target: Address, verb: Verb, written: dict[str, Any]) -> Text:
    assert told.step  # noqa: S101
    numbers, kept, name = dict(told.step.numbers), dict(told.step.kept), target.text
    if f"{name}.ms" not in numbers:
        return NOTHING
    ms, goal, going = numbers[f"{name}.ms"].value, numbers[f"{name}.goal"].value, repr(kept[f"{name}.going"])
    counts = {"1": Text("正在计时", "is counting"), "0": Text("没有计时", "is not counting")}
    doing = counts.get(going, Text("是否计时无法知道", "may be counting or not"))
    if None not in {ms, goal} and ms >= goal and going == "1":
        doing = Text("时间已到", "has reached its time")
    bit, value = next(iter(written.items()))
    said = Text("{t}{doing}，已计{ms}，设定{goal}；{bit}为{value}", "{t} {doing}: {ms} of {goal}; {bit} is {value}")
    base = told.dialect.bank(target).base if verb.sources else 0
    return said.format(t=name, doing=doing, ms=_time(ms, base), goal=_time(goal, base), bit=bit, value=repr(value))


def _time(ms: int | None, base: int) -> Text:
    """Write a time with the count that the list sees."""
    if ms is None or not base:
        return same(lasting(ms))
    return with_value(same(lasting(ms)), str(ms // base))


def _counter_state(told: Told, target: Address, verb: Verb, written: dict[str, Any]) -> Text:
    value = written.pop(f"{target.text}.V", None)
    bits = joined([Text(f"{bit}为{one!r}", f"{bit} is {one!r}") for bit, one in written.items()], "，", ", ")
    goal = _preset(told, verb) if verb.sources else ""
    of = Text(f"，设定值{goal}", f" of {goal}") if goal else NOTHING
    said = Text("{c}的当前值为{value}{of}；{bits}", "{c} stands at {value}{of}; {bits}")
    return said.format(c=target.text, value=repr(value), of=of, bits=bits)


def _drum_state(told: Told, target: Address, _verb: Verb, written: dict[str, Any]) -> Text:
    del told
    step = written.pop(f"{target.text}.S", None)
    bits = joined([Text(f"{bit}为{one!r}", f"{bit} is {one!r}") for bit, one in written.items()], "，", ", ")
    return Text("{c}在第{step}步；{bits}", "{c} stands at step {step}; {bits}").format(
        c=target.text, step=repr(step), bits=bits
    )


def _bits_state(told: Told, target: Address, _verb: Verb, written: dict[str, Any]) -> Text:
    del told
    row = [
        repr(written[name]) for name in (f"{target.text}.{place}" for place in reversed(range(16))) if name in written
    ]
    shown = " ".join("".join(row[place : place + 4]) for place in range(0, len(row), 4))
    return Text("{c}.15到{c}.0现在是{row}", "{c}.15 to {c}.0 are {row} now").format(c=target.text, row=shown)


def _steps_state(told: Told, target: Address, _verb: Verb, _written: dict[str, Any]) -> Text:
    assert told.step  # noqa: S101
    step = repr(dict(told.step.numbers).get(f"{target.text}.S", "x"))
    return Text("{c}在第{step}步，{c}.{step}为1", "{c} stands at step {step}, and {c}.{step} is 1").format(
        c=target.text, step=step
    )


def _queue_state(told: Told, target: Address, _verb: Verb, written: dict[str, Any]) -> Text:
    assert told.step  # noqa: S101
    count = dict(told.step.numbers).get(f"{target.text}#")
    said = Text("{c}里有{count}个字；{bits}", "{c} holds {count}; {bits}")
    bits = joined([Text(f"{bit}为{one!r}", f"{bit} is {one!r}") for bit, one in written.items()], "，", ", ")
    words = Text("{n}", "{n} word" if repr(count) == "1" else "{n} words").format(n=repr(count))
    return said.format(c=target.text, count=words, bits=bits)


_STATES: dict[str, Any] = {
    "timer": _timer_state,
    "counter": _counter_state,
    "drum": _drum_state,
    "bits": _bits_state,
    "steps": _steps_state,
    "queue": _queue_state,
}
