"""What is told of a random task: its title, what is to be done, and hints that are counted off its own answer and so never lie."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.drilling.slips import joins
from plcteach.core.effect import Edge
from plcteach.core.text import Text, counted

if TYPE_CHECKING:
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect, Role

TITLES: dict[str, Text] = {
    "contacts": Text("触点的串联和并联", "Contacts in series and in parallel"),
    "blocks": Text("电路块的连接", "Joining blocks"),
    "branches": Text("多重输出", "Branches to several outputs"),
    "set-reset": Text("置位与复位", "Set and reset"),
    "edges": Text("上升沿和下降沿", "Rising and falling edges"),
    "timers": Text("接通延时定时器", "On-delay timers"),
    "counters": Text("加计数器", "Up counters"),
}

NUMBERED = Text("{title}，难度{level}，第{seed}题", "{title}, level {level}, number {seed}")

TASKS: dict[str, Text] = {
    "write": Text("请写出这个梯形图的{list}。", "Write the {list} for this ladder."),
    "predict": Text(
        "按给出的输入执行一次扫描：每条指令执行以后，堆栈里是什么？",
        "One scan is executed with these inputs: what is on the stack after each instruction?",
    ),
    "join": Text("第{row}条指令连接的是哪两块？", "Which two blocks does instruction {row} join?"),
    "order": Text(
        "请把这些行排成这个梯形图的{list}。有的行用不上。",
        "Put these lines in order so that they are the {list} of this ladder. Not all of them belong.",
    ),
    "match": Text("这段{list}是哪一个梯形图？", "Which of these ladders is this {list}?"),
}

_FIRST: dict[str, Text] = {
    "contacts": Text(
        "从左到右读：第一个触点用装载指令，以后每个触点都和前面整个结果串联或并联。",
        "Read from left to right: the first contact is loaded, and each further one is in series or in parallel with all before it.",
    ),
    "blocks": Text(
        "一个电路块里只有串联，或者只有并联。先把两块都写完，再把它们连接起来。",
        "Within a block everything is in series, or everything in parallel. Finish two blocks, and only then join them.",
    ),
    "branches": Text(
        "几个输出从同一个分支点出发，所以分支点的结果要先存起来，每条支路都从它开始。",
        "Several outputs start from one branch point, so its result is saved first, and each branch begins with it.",
    ),
    "set-reset": Text(
        "置位和复位各占一级。两个条件同时成立时，后执行的说了算，所以顺序要和图里一样。",
        "Set and reset have a rung each. Where both conditions hold, the one that is executed later wins: keep the order of the drawing.",
    ),
    "edges": Text(
        "沿只在变化的那一个扫描周期里接通。先弄清它取的是哪个触点的沿，是上升沿还是下降沿。",
        "An edge is on only in the one scan in which something changes. Of which contact is it the edge, and does it rise or fall?",
    ),
    "timers": Text(
        "先写让定时器走的条件和定时器，再用它的位去接通输出。",
        "First the condition that lets the timer run, and the timer; then its bit drives the output.",
    ),
    "counters": Text(
        "计数器有计数和复位两个条件；数到预设值以后，它的位才接通。",
        "A counter has two conditions, one that counts and one that resets it; its bit comes on once the preset is reached.",
    ),
}

_COUNTED = Text("标准答案有{lines}条指令。", "The model answer has {lines} instructions.")
_ENDS = Text("它以{first}开头，以{last}结束。", "It begins with {first} and ends with {last}.")
_JOINED = Text(
    "{blocks}个电路块要{joins}，标准答案里依次是{words}。",
    "{blocks} blocks want {joins}; in the model answer they are {words}, in this order.",
)
_BRACKETS = Text(
    "标准答案里有{count}，依次以{words}开头。", "The model answer has {count}, which open with {words}, in this order."
)
_SAVED = Text(
    "标准答案里：{push}有{pushes}条，{read}有{reads}条，{pop}有{pops}条。",
    "In the model answer there are: {push} {pushes} times, {read} {reads} times, {pop} {pops} times.",
)


def hints(program: Program, kind: str = "") -> tuple[Text, ...]:
    """Give hints for writing a list, from vague to nearly the answer; each is true of the program."""
    lines = program.lines
    first = _FIRST[kind or subject(program)]
    ends = _ENDS.format(first=lines[0].text, last=lines[-1].text)
    more = [one for one in (_of_joins(program), _of_branches(program)) if one]
    return (first, *more, _COUNTED.format(lines=len(lines)), ends)


def subject(program: Program) -> str:
    """Say which kind of drill a program would be: the hardest thing that it has in it."""
    roles = program.dialect.roles
    blocks = {block.rule for line in program.lines for place in line.places if (block := program.dialect.block(place))}
    signs = {
        "counters": "counter" in blocks,
        "timers": "timer" in blocks,
        "edges": has_edges(program),
        "set-reset": any(line.insn.does & {"set", "reset"} for line in program.lines),
        "branches": bool(times(program, roles.get("push", ""))),
        "blocks": bool(joins(program)),
    }
    return next((kind for kind, there in signs.items() if there), "contacts")


def has_edges(program: Program) -> bool:
    """Say whether a program takes an edge anywhere."""
    roles = program.dialect.roles
    words = {roles.get("rise"), roles.get("fall")}
    return any(
        line.insn.mnemonic in words
        or any(sign in line.effect.text for sign in ("rise(", "fall("))
        or any(verb.formula is not None and isinstance(verb.formula, Edge) for verb in line.insn.then)
        for line in program.lines
    )


def _of_joins(program: Program) -> Text | None:
    theirs = joins(program)
    if not theirs:
        return None
    words = " ".join(line.insn.mnemonic for line in theirs)
    if any(line.insn.close for line in theirs):
        pairs = "pairs of parentheses" if len(theirs) > 1 else "pair of parentheses"
        return _BRACKETS.format(count=counted(len(theirs), "对括号", pairs), words=words)
    load = {program.dialect.roles[role] for role in ("load", "load_not")}
    blocks = sum(line.insn.mnemonic in load for line in program.lines)
    if blocks != len(theirs) + 1:
        return None
    said = counted(len(theirs), "条连接指令", "joins" if len(theirs) > 1 else "join")
    return _JOINED.format(blocks=blocks, joins=said, words=words)


def _of_branches(program: Program) -> Text | None:
    roles: tuple[Role, ...] = ("push", "read", "pop")
    counts = {role: times(program, program.dialect.roles.get(role, "")) for role in roles}
    if not counts["push"]:
        return None
    words = {role: program.dialect.roles[role] for role in roles}
    return _SAVED.format(**words, pushes=counts["push"], reads=counts["read"], pops=counts["pop"])


def times(program: Program, mnemonic: str) -> int:
    """Say how often an instruction stands in a program."""
    return sum(line.insn.mnemonic == mnemonic for line in program.lines)


def task(ask: str, dialect: Dialect, row: int = 0) -> Text:
    """Say what is to be done."""
    return TASKS[ask].format(list=dialect.list, row=row)
