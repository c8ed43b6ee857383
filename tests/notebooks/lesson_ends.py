"""The exercises at the end of each lesson: which ones, and why; the cells themselves are made from the catalogue."""

from __future__ import annotations

from typing import Any

from nbformat.v4 import new_code_cell, new_markdown_cell

from plcteach.core.diagnostic import RULES
from plcteach.core.text import Text
from plcteach.dialects import dialect, names
from plcteach.exercises import exercise, ids

HEAD = Text("## 练习", "## Exercises")
NEXT = Text("## 下一", "## Next")
RUN = Text(
    "运行单元，练习台就会打开；没运行时看到的，和印在纸上的题目一样。做过的内容会记在笔记本旁边的一个小文件里，下次打开还在。",
    "Run a cell and its desk opens; until then you see the task as it would stand on paper. What you write is kept in a small "
    "file beside the notebook and is there again next time.",
)
ALL = Text(
    '**这一课的全部练习。** 任何一道都可以用`plc.desk("编号")`打开；它们也都在练习册里：{books}。',
    '**All exercises of this lesson.** Open any of them with `plc.desk("its id")`; they are in the exercise books, too: {books}.',
)
FURTHER = """from plcteach.exercises import exercise, ids

{{name: exercise(name).title.in_(plc.language()) for name in ids() if exercise(name).lesson == {lesson}}}"""

MESSAGES = Text(
    '**和这一课有关的检查提示。** 你的程序旁边出现其中一条，就回来看这一课；`plc.explain("{code}")`举例说明一条。',
    "**What the checker says about this lesson.** If one of these stands beside your list, this is the lesson to read again; "
    '`plc.explain("{code}")` shows one of them with examples.',
)
_MANY = 12
"""A longer list of messages is folded, so that what comes next is not pushed away."""
SAID = """from plcteach.core.diagnostic import RULES

{{rule.code: rule.why.in_(plc.language()) for rule in RULES.values() if rule.lesson == {lesson}}}"""

CHOSEN: dict[int, dict[str, Text]] = {
    0: {
        "s7-one-contact": Text(
            "最短的一张语句表：先确认写、检查、改这三步你都会用。",
            "The shortest list there is, to get used to writing, checking and mending.",
        ),
        "s7-no-precedence": Text(
            "这一课最容易错的地方：语句表里“与”并不比“或”先算。",
            "The trap of this lesson: in a list AND does not go before OR.",
        ),
        "s7-seal-in": Text(
            "几乎每台设备里都有的启动、停止电路，而且停止要优先。",
            "The start/stop circuit that nearly every machine has, and stop has to win.",
        ),
    },
    1: {
        "s7-predict-blocks": Text(
            "第1、2节的栈，这回一层一层由你来填：会填，就是懂了。",
            "The stack of sections 1 and 2, but now you fill in the levels: if you can, you have understood them.",
        ),
        "fx-stack-of-figure-5": Text(
            "三个块、两种连接，放在FX的运算结果寄存器和栈里再想一遍。",
            "Three blocks and both joins, thought through once more with the FX's result register and stack.",
        ),
    },
    2: {
        "s7-late-lamp": Text(
            "先读后写，灯就晚一个扫描：不运行程序，自己把时序图画出来。",
            "Read first and written later, the lamp is one scan late: draw the chart yourself, without running anything.",
        ),
        "s7-rung-order": Text(
            "一个网络把一个位交给另一个网络：先写后读，就不用等一个扫描。",
            "One network passes a bit on to the other: write it first and read it below, and nothing has to wait.",
        ),
        "s7-own-start": Text(
            "一个网络接着用了上一个网络留下的值：找出来，改好。",
            "A network goes on with what the one before has left behind: find it and mend it.",
        ),
    },
    3: {
        "s7-double-coil": Text(
            "两个网络单独看都没错，放在一起，后写的线圈就盖掉先写的。",
            "Each network is right by itself, and yet the later coil overwrites the earlier one.",
        ),
        "s7-who-wins": Text(
            "S和R同时来，谁说了算？从语句表的次序看出来。",
            "S and R at once: read from the order of the list which of them wins.",
        ),
        "s7-edges-chart": Text(
            "边沿只有一个扫描宽，第一个扫描又没有边沿：在图上标对位置。",
            "An edge is one scan wide and the first scan has none: put both edges in the right place of a chart.",
        ),
        "s7-one-button": Text(
            "整课内容合在一起：一个脉冲、两个条件、一个线圈。",
            "The whole lesson in one circuit: one pulse, both questions, one coil.",
        ),
    },
    4: {
        "s7-on-delay": Text(
            "由编号决定时基，由时基算出预设值：先把这一步练熟。",
            "The number gives the time base, the time base the preset: get that step right first.",
        ),
        "s7-timer-chart": Text(
            "哪一个扫描接通？差一个扫描就错，所以动手数一遍。",
            "In which scan does it come on? One scan off is wrong, so count them once by hand.",
        ),
        "s7-self-resetting": Text(
            "只用一个定时器做出节拍；再想一想，同一张表换个编号为什么就不行了。",
            "A clock from a single timer; and the question behind it is why the same list fails with another number.",
        ),
        "s7-star-delta": Text(
            "一个完整的任务：自锁、定时和互锁缺一不可。",
            "A whole task, in which seal-in, timer and interlock are all needed.",
        ),
    },
    5: {
        "s7-three-presses": Text(
            "先装载计数信号，后装载复位：亲手写一次就记住了。",
            "Count first, reset last: written once by hand, it stays in mind.",
        ),
        "s7-counter-chart": Text(
            "计数器数的是上升沿，复位期间的不算：画出来看看。",
            "A counter counts rising edges, and none during reset: draw what that means.",
        ),
        "neza-twenty-flashes": Text(
            "书上的程序，最后一次闪光不完整：想清楚数的是开始还是结束。",
            "A program from a book whose last flash is cut short: is it the beginning that is counted, or the end?",
        ),
    },
    6: {
        "neza-drum": Text(
            "把一张动作表变成鼓形控制器的步和控制位。",
            "Turn a table of actions into the steps and control bits of a drum.",
        ),
        "neza-only-zeros": Text(
            "移位寄存器只会移，不会自己放进1：找出少了什么。",
            "A shift register only moves what somebody has put in: find what is missing.",
        ),
        "neza-last-in": Text(
            "后进先出，先取出来的是哪一个？在时序图上填出来。",
            "Last in, first out: say in a chart which number comes out when.",
        ),
        "neza-reject-conveyor": Text(
            "这一课最大的任务：先回答起停、周期、输出三个问题，再动手写。",
            "The largest task of this lesson: ask about start and stop, period and outputs first, and only then write.",
        ),
    },
    7: {
        "s7-which-blocks": Text(
            "连接指令只管上面最近的、已完成的两块：指出是哪两块。",
            "A join takes the two nearest finished blocks: say which two.",
        ),
        "s7-joins-in-order": Text(
            "两条连接指令的先后一换，就成了另一个梯形图。",
            "Two joins in the other order make another ladder.",
        ),
        "s7-single-contacts": Text(
            "短的表也更好读：不需要的连接指令，一条也不写。",
            "The shorter list is the one that is easier to read: leave out every join that nobody needs.",
        ),
        "s7-sort-two-blocks": Text(
            "行都给好了，只差次序；有几行是用不上的。",
            "The lines are there and only the order is missing; some of them do not belong.",
        ),
    },
    8: {
        "s7-branch": Text(
            "先入栈，中间读栈，最后出栈：三个输出正好各用一次。",
            "Push, read, pop: with three outputs you need each of them once.",
        ),
        "s7-predict-nested": Text(
            "两级分支时，栈里同时放着两个分支点：逐层写出来。",
            "With branches on two levels two branch points wait at once: write down where.",
        ),
        "s7-read-is-no-push": Text(
            "很多人以为LRD会再压一份：这张表就错在这里。",
            "Many think that LRD pushes another copy: that is what is wrong with this list.",
        ),
        "s7-branch-is-no-copy": Text(
            "分支点的值只算一次，所以不能用抄主干的办法代替。",
            "A branch point's value is worked out once, so copying the stem is not the same.",
        ),
    },
    9: {
        "neza-parentheses": Text(
            "左括号先说做什么运算，右括号才去做：写一对试试。",
            "The opening parenthesis names the operation, the closing one carries it out: write one pair.",
        ),
        "neza-what-the-bracket-joins": Text(
            "看着右括号，说出它把哪两段的结果连在一起。",
            "Look at a closing parenthesis and say which two stretches it brings together.",
        ),
        "neza-accumulator": Text(
            "括号里套括号时，哪个值在累加器里，哪个先放到一边？",
            "With a parenthesis inside another: which value is in the accumulator, and which is put away?",
        ),
    },
    10: {
        "gutta-fusion": Text(
            "按复合的规则把指令减到最少。",
            "Use the rules of fusion until no line is left over.",
        ),
        "gutta-two-stacks": Text(
            "数据栈和辅助栈分开填，就不会把两者弄混。",
            "Fill in the data stack and the auxiliary stack side by side, and you will not confuse them again.",
        ),
        "gutta-not-the-data-stack": Text(
            "在S7-200上对、在GUTTA上错的一张表：问题就出在两个栈上。",
            "A list that is right on the S7-200 and wrong on the GUTTA: the two stacks are the reason.",
        ),
        "gutta-add-and-overwrite": Text(
            "分解功能块时，OUT不能和IN2是同一个地址：看看碰上了会怎样。",
            "When a box is split, OUT must not touch IN2: see what happens where it does, and mend it.",
        ),
    },
    11: {
        "fx-lines-in-order": Text(
            "从梯形图到指令表：四条规则决定了每一行的位置。",
            "From ladder to list: the four rules give every line its place.",
        ),
        "fx-which-ladder": Text(
            "再走回来：读指令表，在心里画出图，再挑出那一张。",
            "And back: read the list, draw the ladder in your mind, and pick it out.",
        ),
        "neza-which-ladder": Text(
            "换成带括号的指令表，同样要认得出梯形图。",
            "The same with parentheses, where the ladder looks just as it did.",
        ),
    },
    12: {
        "fx-from-s7": Text(
            "同样写作LDI，意思却不同：翻译时最容易上当的一条。",
            "LDI here is not LDI there: the false friend of every translation.",
        ),
        "s7-from-fx-branch": Text(
            "分支指令换了名字，栈的用法没有变。",
            "The stack instructions change their names, and what they do stays.",
        ),
        "neza-from-fx": Text(
            "连接指令写在最后，括号写在最前：换一种次序来想。",
            "The FX names a join at the end, the NEZA at the front: turn your thinking round.",
        ),
        "gutta-from-s7": Text(
            "GUTTA没有LDS，要换一种办法得到同样的值。",
            "The GUTTA has no LDS, so the same value must be had in another way.",
        ),
    },
    13: {
        "fx-published-mistake": Text(
            "印出来的程序也会错：像这一课那样往上读，找出那一行。",
            "Print does not make a list right: read it upwards, as in this lesson, and find the line.",
        ),
        "neza-drilling-head": Text(
            "书上的程序，开不动：先写出要求，再去找错。",
            "A program from a book in which nothing moves: write down the wish first, then look for the fault.",
        ),
        "neza-eight-lamps": Text(
            "一圈里只有一个扫描是黑的，眼睛看不见，检查却看得见。",
            "Dark for one scan a round: too short for the eye, but not for the check.",
        ),
    },
}  # fmt: skip


def lesson_of(name: str) -> int:
    """Give a lesson's number from its file's name."""
    return int(name[:2])


def families_of(lesson: int) -> list[str]:
    """Name the families that have exercises for a lesson, in the order of the house."""
    used = {exercise(name).dialect for name in ids() if exercise(name).lesson == lesson}
    return [name for name in names() if name in used]


def end_of_lesson(lesson: int, lang: str, books: str) -> list[Any]:
    """Make the cells of one lesson's exercises and messages; `books` are links to where all exercises stand."""
    cells = [new_markdown_cell(f"{HEAD.in_(lang)}\n\n{RUN.in_(lang)}")]
    several = len({exercise(name).dialect for name in CHOSEN[lesson]}) > 1
    for name, why in CHOSEN[lesson].items():
        one = exercise(name)
        family = f" · {dialect(one.dialect).title.in_(lang)}" if several else ""
        cells.append(new_markdown_cell(f"### {one.title.in_(lang)}{family}\n\n{why.in_(lang)}"))
        cells.append(new_code_cell(f'plc.desk("{name}")'))
    cells.append(new_markdown_cell(ALL.in_(lang).format(books=books)))
    cells.append(new_code_cell(FURTHER.format(lesson=lesson)))
    return cells + messages(lesson, lang)


def messages(lesson: int, lang: str) -> list[Any]:
    """Make the cells with what the checker says about one lesson's matter, so that a diagnostic's lesson is a place to go to."""
    codes = [rule.code for rule in RULES.values() if rule.lesson == lesson]
    if not codes:
        return []
    said = MESSAGES.in_(lang).format(code=codes[0])
    folded = {"jupyter": {"outputs_hidden": True}} if len(codes) > _MANY else {}
    return [new_markdown_cell(said), new_code_cell(SAID.format(lesson=lesson), metadata=folded)]


def woven(book: Any, lesson: int, lang: str, books: str) -> Any:
    """Put a lesson's exercises between what to remember and what comes next, in place of those that stand there."""
    starts = [number for number, cell in enumerate(book.cells) if cell.source.startswith(HEAD.in_(lang))]
    ends = next(number for number, cell in enumerate(book.cells) if cell.source.startswith(NEXT.in_(lang)))
    book.cells[starts[0] if starts else ends : ends] = end_of_lesson(lesson, lang, books)
    return book
