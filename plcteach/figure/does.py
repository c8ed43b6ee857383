"""The words for what an instruction does beside bits and stack: words, blocks, jumps, calls, loops, steps and segments."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.program import Assign
from plcteach.core.text import NOTHING, Text, joined, same

if TYPE_CHECKING:
    from plcteach.core.verb import Verb
    from plcteach.figure.told import Told

_ALWAYS: dict[str, Text] = {
    "label": Text("标号{target}：跳转到这里的程序从这里接着执行", "label {target}: a jump to it goes on from here"),
    "next": Text(
        "循环到此结束：循环变量加1，没有超过终值就回到循环开头",
        "the loop's end: the index counts one on, and unless it has passed the last value the loop begins again",
    ),
    "restore": Text(
        "主控{target}到此结束，左母线恢复", "master control {target} ends here, and the left rail has its power back"
    ),
    "open": Text(
        "{target}的输入部分开始：下面的结果接到它的引脚上",
        "the inputs of {target} begin: what follows goes to its pins",
    ),
    "update": Text("{target}按引脚上的值动作一次", "{target} acts once on what stands at its pins"),
    "entry": Text("子程序从这里开始", "a subroutine begins here"),
    "return": Text(
        "子程序结束，回到调用它的地方，堆栈恢复",
        "the subroutine ends; the program goes on where it was called, with its stack restored",
    ),
    "end": Text(
        "程序到此结束，输出映像送到输出端子，下一个扫描周期从头开始",
        "the program ends here; the output image goes to the terminals, and the next scan begins at the top",
    ),
    "rail": Text("步（段）到此结束，左母线恢复", "the step or segment ends here, and the left rail has its power back"),
}
_WHERE_POWERED: dict[str, tuple[Text, Text]] = {
    "jump": (
        Text(
            "程序跳到标号{target}，中间的指令不执行",
            "the program goes on at label {target}, and the lines between are passed over",
        ),
        Text("不跳转，接着执行下一条", "there is no jump, and the next line follows"),
    ),
    "call": (
        Text(
            "调用{target}：整个堆栈保存起来，子程序里栈顶为1，其余为0",
            "{target} is called: the whole stack is put aside, and the subroutine begins with 1 on top and 0 below",
        ),
        Text("不调用{target}", "{target} is not called"),
    ),
    "loop": (
        Text("循环开始：{target}得到初值", "the loop begins: {target} gets its first value"),
        Text("整个循环被跳过", "the whole loop is passed over"),
    ),
    "return": (Text("子程序提前返回", "the subroutine returns at once"), Text("子程序继续", "the subroutine goes on")),
    "end": (Text("这个扫描周期到此结束", "the scan ends here"), Text("扫描继续", "the scan goes on")),
    "stop": (
        Text(
            "CPU在这个扫描周期结束时转入STOP，输出断开",
            "the CPU goes to STOP at the end of this scan, and the outputs switch off",
        ),
        Text("CPU继续运行", "the CPU keeps running"),
    ),
    "master": (
        Text("主控{target}接通，左母线有电", "master control {target} is on, and the rail below has power"),
        Text(
            "主控{target}断开：在它结束之前，每个装载都得0",
            "master control {target} is off: until it ends, every load gives 0",
        ),
    ),
    "segment": (
        Text("{target}段激活，左母线有电", "the segment of {target} is active, and the rail has power"),
        Text(
            "{target}段没有激活：在它结束之前，每个装载都得0",
            "the segment of {target} is not active: until it ends, every load gives 0",
        ),
    ),
    "step": (
        Text("步{target}激活，左母线有电", "step {target} is active, and the rail has power"),
        Text("步{target}没有激活，它的指令不起作用", "step {target} is not active, and its lines do nothing"),
    ),
    "transfer": (
        Text("当前段的继电器复位", "the relay of this segment is reset"),
        Text("不转移", "there is no transfer"),
    ),
    "rail": (Text("这一段提前结束", "the segment ends early"), Text("这一段继续", "the segment goes on")),
    "work": (
        Text("执行{title}，{result}", "{title}: {result}"),
        Text("不执行，{target}不变", "nothing is worked out, and {target} keeps its value"),
    ),
    "shift": (Text("从{target}起的各位移动一位", "the bits from {target} move on"), Text("各位不动", "no bit moves")),
    "pin": (
        Text("{target}的引脚{op}得到1", "pin {op} of {target} gets 1"),
        Text("{target}的引脚{op}得到0", "pin {op} of {target} gets 0"),
    ),
}


def does(told: Told, verb: Verb) -> Text:
    """Say what a verb does, or did: without values both ways, with values the one that happened."""
    if verb.name == "drive":
        return _driven(told, verb)
    values = {"target": goal(told, verb), "title": told.line.insn.title, "result": _result(told), "op": verb.op}
    if verb.formula is None:
        return _ALWAYS.get(verb.name, NOTHING).format(**values)
    yes, no = (one.format(**values) for one in _WHERE_POWERED[verb.name])
    power = told.value if verb.name in {"segment", "step"} else told.was()
    it = told.result
    if not told.step:
        said = Text("{it}为1时，{yes}；为0时，{no}", "if {it} is 1, {yes}; if it is 0, {no}")
        return said.format(it=it, yes=yes, no=no)
    if power == "x":
        return Text("{it}为x，是否这样无法知道：{yes}", "{it} is x, and nobody knows whether {yes}").format(
            it=it, yes=yes
        )
    said = Text("{it}为{power}，{what}", "{it} is {power}: {what}")
    return said.format(it=it, power=power or "1", what=yes if power == "1" else no)


def _result(told: Told) -> Text:
    """Say what was worked out."""
    if not told.step or not told.step.written:
        return Text("结果写入操作数", "the result goes into its operand")
    address, value = told.step.written[0]
    flags = [f"{flag.text} = {bit!r}" for flag, bit in told.step.written[1:] if repr(bit) == "1"]
    return joined(
        [Text(f"{address.text}变为{value!r}", f"{address.text} becomes {value!r}"), *map(same, flags)], "，", ", "
    )


def _driven(told: Told, verb: Verb) -> Text:
    """Say what a block's pins get, and what came of it."""
    target, pins = goal(told, verb), [name for name, _ in verb.pins]
    if not told.step:
        named = same(", ".join(pins))
        return Text("{pins}接到{target}上，它动作一次", "{pins} goes to {target}, which acts once").format(
            pins=named, target=target
        )
    height = {name: told.flow.named.get(name.rstrip("?")) for name in pins}
    seen = [f"{name} = {told.was(place)}" for name, place in height.items() if place]
    after = [f"{address.text} = {value!r}" for address, value in told.step.written]
    said = Text("{target}看到{seen}，动作后{after}", "{target} sees {seen}; afterwards {after}")
    return said.format(target=target, seen=same(", ".join(seen or pins)), after=same(", ".join(after)))


def goal(told: Told, verb: Verb) -> Text:
    """Name what a verb works on."""
    arg = told.line.bound.get(verb.target)
    if arg is None:
        return Text("操作数", "the operand")
    operand = next((one for one in told.line.insn.operands if one.name == verb.target), None)
    mark = operand.mark if operand else ""
    return same(f"{mark}{arg}" if isinstance(arg, int) else arg.target.text if isinstance(arg, Assign) else arg.text)
