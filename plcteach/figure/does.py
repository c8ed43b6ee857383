"""The words for where a program goes on and what is powered: jumps, calls, loops, master controls, steps and segments."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.program import Assign
from plcteach.core.text import NOTHING, Text, same
from plcteach.figure.drives import drives, opens, pins, updates
from plcteach.figure.when import fired, when
from plcteach.figure.works import shifts, works

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.core.verb import Verb
    from plcteach.figure.told import Told

_JUMPS = Text(
    "程序跳到标号{target}，中间的指令不执行",
    "the program goes on at label {target}, and the lines between are passed over",
)
_ALWAYS: dict[str, Text] = {
    "jump": _JUMPS,
    "label": Text("跳转到标号{target}的程序从这里接着执行", "a jump to label {target} goes on from here"),
    "next": Text(
        "循环变量加1：没有超过终值，就回到循环开头再执行一遍；超过了，循环结束",
        "the index counts one on: unless it has passed the last value, the loop begins again; then it ends",
    ),
    "restore": Text(
        "主控{target}到此结束，左母线恢复为它前面的状态",
        "master control {target} ends here, and the left rail is what it was before it",
    ),
    "entry": Text(
        "子程序{target}从这里开始，只有被调用时才执行",
        "subroutine {target} begins here; it runs only where it is called",
    ),
    "return": Text(
        "子程序结束，回到调用它的地方，堆栈恢复原样",
        "the subroutine ends; the program goes on behind the call, with the stack as it was",
    ),
    "end": Text(
        "程序到此结束，输出映像送到输出端子，下一个扫描周期从头开始",
        "the program ends here; the output image goes to the terminals, and the next scan begins at the top",
    ),
    "rail": Text("{part}到此结束，左母线恢复供电", "{part} ends here, and the left rail has its power back"),
}
_ALONE = Text(
    "子程序结束，回到调用它的地方，累加器恢复原值",
    "the subroutine ends; the program goes on behind the call, with the accumulator as it was",
)
_WHERE_POWERED: dict[str, tuple[Text, Text]] = {
    "jump": (
        _JUMPS,
        Text("不跳转，接着执行下一条", "there is no jump, and the next line follows"),
    ),
    "call": (
        Text("调用{target}：{begins}", "{target} is called: {begins}"),
        Text("不调用{target}", "{target} is not called"),
    ),
    "loop": (
        Text(
            "{target}从{first}数到{last}，每个值把循环里的指令执行一遍（初值大于终值时一遍也不执行）",
            "{target} counts from {first} to {last}, and the lines of the loop are executed for each value "
            "(not at all where the first is greater than the last)",
        ),
        Text("整个循环被跳过", "the whole loop is passed over"),
    ),
    "return": (
        Text("子程序提前结束，回到调用它的地方", "the subroutine ends early, and the program goes on behind the call"),
        Text("子程序继续往下执行", "the subroutine goes on"),
    ),
    "end": (
        Text("这个扫描周期的程序到此结束，后面的指令不执行", "the program ends here for this scan, and the lines below are not executed"),
        Text("程序继续往下执行", "the program goes on"),
    ),
    "stop": (
        Text("CPU在这个扫描周期结束时转入STOP，输出全部断开", "the CPU goes to STOP at the end of this scan, and all outputs switch off"),
        Text("CPU继续运行", "the CPU keeps running"),
    ),
    "master": (
        Text("{out}为1，主控{target}接通，下面的左母线有电", "{out} is 1: master control {target} is on, and the rail below has power"),
        Text(
            "{out}为0，主控{target}断开：在它结束之前，每个装载都得0",
            "{out} is 0: master control {target} is off, and until it ends every load gives 0",
        ),
    ),
    "segment": (
        Text("这一段激活，它的左母线有电", "its segment is active, and the rail has power there"),
        Text("这一段没有激活：在它结束之前，每个装载都得0", "its segment is not active, and until it ends every load gives 0"),
    ),
    "step": (
        Text("这一步激活，它的左母线有电，指令照常执行", "its step is active: the rail has power there, and its lines are executed"),
        Text(
            "这一步没有激活，它的指令被跳过（刚结束时再不带电执行一遍，使线圈断开）",
            "its step is not active, and its lines are passed over (right after its end they are executed once more "
            "without power, so that coils drop)",
        ),
    ),
    "rail": (
        Text("这一段提前结束：后面的装载都得0", "the segment ends early, and every load below it gives 0"),
        Text("这一段继续", "the segment goes on"),
    ),
}  # fmt: skip
_TRANSFERS = Text(
    "同时当前段的继电器复位，这一段结束", "with it the relay of the present segment is reset, and that segment ends"
)
_TRANSFERS_IF = Text("这时当前段的继电器复位", "where that happens, the relay of the present segment is reset")
_STEP, _SEGMENT = Text("这一步", "the step"), Text("这一段", "the segment")
_STACK = Text(
    "整个堆栈保存起来，子程序开始时栈顶为1，其余各层为0",
    "the whole stack is put aside, and the subroutine begins with 1 on top and 0 below",
)
_ACCUMULATOR = Text(
    "{it}和各个栈保存起来，子程序开始时{it}为1",
    "{it} and the stacks are put aside, and the subroutine begins with {it} 1",
)
_BLOCKS: dict[str, Callable[[Told, Verb], Text]] = {
    "drive": drives,
    "pin": pins,
    "open": opens,
    "update": updates,
    "work": works,
    "shift": shifts,
}


def does(told: Told, verb: Verb) -> Text:
    """Say what a verb does, or did: without values both ways, with values the one that happened."""
    if verb.name in _BLOCKS:
        return _BLOCKS[verb.name](told, verb)
    if verb.name == "transfer":
        power = fired(told, verb)
        return _TRANSFERS_IF if not told.step else _TRANSFERS if power == "1" else NOTHING
    values = _values(told, verb)
    if verb.formula is None:
        alone = verb.name == "return" and told.main.depth == 1
        return _ALONE if alone else _ALWAYS.get(verb.name, NOTHING).format(**values)
    yes, no = (one.format(**values) for one in _WHERE_POWERED[verb.name])
    return when(told, verb, yes, no)


def _values(told: Told, verb: Verb) -> dict[str, Text]:
    """Give what the sentences name."""
    begins = _STACK
    if told.main.depth == 1:
        begins = _ACCUMULATOR.format(it=told.result)
    steps = any(one.name == "step" for row in told.dialect.insns for one in row.then)
    first, last = (same(told.address(name)) for name in (*verb.sources, "", "")[:2])
    return {
        "target": goal(told, verb), "begins": begins,
        "part": _STEP if steps else _SEGMENT, "first": first, "last": last,
        "out": same(told.address("out")) if "out" in told.line.bound else NOTHING,
    }  # fmt: skip


def goal(told: Told, verb: Verb) -> Text:
    """Name what a verb works on."""
    arg = told.line.bound.get(verb.target)
    if arg is None:
        return Text("操作数", "the operand")
    return same(arg.target.text if isinstance(arg, Assign) else told.line.spell(verb.target))
