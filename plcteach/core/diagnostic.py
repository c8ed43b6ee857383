"""What plcteach can say about a learner's text: every message is one declared row, and a finding is a frozen value.

Voice: says what it sees and what it expected, and ends with a question or an action; it never blames.
The bad and the good program of each row stand in the dialects' tables, because each family has its own.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Literal

from plcteach.core.errors import PlcTeachError, UnknownNameError
from plcteach.core.text import NOTHING, Text, language

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.core.source import Span

Severity = Literal["error", "warning", "info"]


@dataclass(frozen=True, slots=True)
class Rule:
    """One thing that can be said: its code, its name, what it says (with named places) and why it matters.

    misconceptions: the numbers of the usual wrong ideas behind it, as the teaching notes count them, the most usual first.
    lesson: the number of the lesson that treats it, -1 if none does.
    """

    code: str
    name: str
    severity: Severity
    says: Text
    why: Text
    misconceptions: tuple[int, ...] = ()
    lesson: int = -1

    def __repr__(self) -> str:
        return f"Rule({self.code} {self.name})"

    @property
    def style(self) -> bool:
        """Whether it speaks of a right program that could be written better, which marks for style count."""
        return self.code.startswith("STY") or self.code in _ONE_LINE_TOO_MANY

    def at(self, span: Span, **values: object) -> Diagnostic:
        """Make a finding of this rule at a place, its named places filled."""
        said = self.says.format(**values)
        return Diagnostic(self.code, self.severity, span, Text(said.zh.strip(), said.en.strip()))


_ONE_LINE_TOO_MANY = frozenset({"STK007", "STK008"})


@dataclass(frozen=True, slots=True)
class Note:
    """A further place that a finding points at, with what is to be seen there."""

    span: Span
    text: Text


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One finding in a learner's text, in two languages."""

    code: str
    severity: Severity
    span: Span
    text: Text
    notes: tuple[Note, ...] = field(default=())
    fix: Text = NOTHING

    def __repr__(self) -> str:
        return f"{self.severity} {self.code} at {self.span}: {self.text.in_(language())}"

    @property
    def why(self) -> Text:
        """Why it matters, from the rule's row."""
        return rule(self.code).why


MOST_FINDINGS = 300


def few(found: list[Diagnostic]) -> list[Diagnostic]:
    """Keep the first of very many findings, errors before remarks, and say that there are more."""
    if len(found) <= MOST_FINDINGS:
        return found
    kept = sorted(found, key=lambda one: one.severity != "error")[:MOST_FINDINGS]
    cut = len(errors(found)) > len(errors(kept))
    more = replace(rule("RDR016").at(found[-1].span, most=MOST_FINDINGS), severity="error" if cut else "info")
    return [*sorted(kept, key=lambda one: one.span), more]


def errors(diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Give the findings that keep a program from being run."""
    return [one for one in diagnostics if one.severity == "error"]


def refuse(found: Iterable[Diagnostic]) -> None:
    """Raise the first error, if there is one, as a PlcTeachError with its row."""
    for one in errors(found):
        msg = f"row {one.span.row}: {one.text.in_(language())}"
        raise PlcTeachError(msg)


def rule(code: str) -> Rule:
    """Give the declared row of a code such as "STK001"."""
    try:
        return RULES[code.upper()]
    except KeyError:
        kind = "diagnostic"
        raise UnknownNameError(kind, code, RULES) from None


_ROWS = (
    # RDR: reading the text
    Rule(
        "RDR001",
        "unknown-instruction",
        "error",
        Text(
            "“{word}”不是{family}的指令。{near}这一行想做什么？",
            "{family} has no instruction {word}. {near}What should this line do?",
        ),
        Text(
            "PLC只认识自己指令集里的助记符；拼写差一个字母就是另一条指令。",
            "A PLC knows only the mnemonics of its own set; one letter more or less is another instruction.",
        ),
        lesson=0,
    ),
    Rule(
        "RDR002",
        "not-run-here",
        "error",
        Text(
            "{word}是{family}的指令，但plcteach目前只认得它，还不执行它。这个练习能不用它写吗？",
            "{word} is an instruction of {family} that plcteach recognises but does not run. Can it be written without?",
        ),
        Text(
            "这里只执行讲到的指令；其余的只认名字，以免把真指令说成错误。",
            "Only what the lessons teach is executed; the rest is known by name, so that it is never called a mistake.",
        ),
    ),
    Rule(
        "RDR003",
        "operand-missing",
        "error",
        Text("{word}后面还应有{expected}。", "{word} wants {expected} after it."),
        Text(
            "一条指令由操作码和操作数组成：做什么，对谁做。",
            "An instruction is an opcode and its operand: what to do, and to which bit.",
        ),
        lesson=0,
    ),
    Rule(
        "RDR004",
        "operand-too-many",
        "error",
        Text(
            "{word}到这里已经完整，后面的“{rest}”是多余的。它属于下一行吗？",
            "{word} is complete before {rest}. Does that belong on the next line?",
        ),
        Text(
            "堆栈指令没有操作数：它们处理的是堆栈里已有的值。",
            "Stack instructions have no operand: they work on what the stack already holds.",
        ),
        lesson=0,
    ),
    Rule(
        "RDR005",
        "address-unread",
        "error",
        Text(
            "“{word}”读不成{family}的地址，这里应写{expected}。{near}",
            "{word} does not read as an address of {family}; expected here: {expected}. {near}",
        ),
        Text(
            "地址由区域字母和编号组成，说明取哪一位。",
            "An address is the letter of an area and a number: it says which bit is meant.",
        ),
        lesson=0,
    ),
    Rule(
        "RDR006",
        "address-out-of-range",
        "error",
        Text(
            "没有{word}这个地址：{area}的范围是{first}–{last}。{note}",
            "There is no {word} ({area}: {first} to {last}). {note}",
        ),
        Text(
            "每个区域的点数是固定的；FX的X、Y按八进制编号，X7之后是X10。",
            "Each area has a fixed size; X and Y of the FX count in octal, so X10 follows X7.",
        ),
        lesson=0,
    ),
    Rule(
        "RDR007",
        "area-unsuited",
        "error",
        Text(
            "{word}不能用于{address}：这里应是{expected}。", "{word} does not work on {address}: it wants {expected}."
        ),
        Text(
            "输入只能由现场接线改变，所以线圈不能写输入；立即指令只对输入有意义。",
            "Only the wiring changes an input, so a coil cannot write one; an immediate contact makes sense for inputs only.",
        ),
        misconceptions=(24,),
        lesson=0,
    ),
    Rule(
        "RDR008",
        "number-out-of-range",
        "error",
        Text(
            "{word}的{name}应在{first}到{last}之间，这里是{number}。",
            "{name} of {word} lies between {first} and {last}; here it is {number}.",
        ),
        Text(
            "操作数里的数有固定范围，例如九层堆栈只能数0到8。",
            "A number operand has its range: a stack of nine levels is counted 0 to 8.",
        ),
        lesson=0,
    ),
    Rule(
        "RDR009",
        "comment-open",
        "error",
        Text("从这里开始的注释 (* 一直没有 *) 结束。", "The comment that (* opens here is never closed by *)."),
        Text("没有结束的注释会把后面的程序全部吞掉。", "A comment left open swallows the rest of the program."),
    ),
    Rule(
        "RDR010",
        "parenthesis-stray",
        "error",
        Text(
            "这个 ) 前面没有对应的 AND( 或 OR( 。它要结束哪一块？",
            "This ) closes nothing: no AND( or OR( is open before it. Which block should it end?",
        ),
        Text(
            "括号成对：打开时保存累加器，关闭时取回来合并。",
            "Parentheses come in pairs: opening saves the accumulator, closing brings it back and combines.",
        ),
        lesson=9,
    ),
    Rule(
        "RDR011",
        "parenthesis-open",
        "error",
        Text(
            "{word}打开的括号到梯级结束也没有 ) 。这一块到哪里为止？",
            "The parenthesis that {word} opens is not closed before the rung ends. Where does the block end?",
        ),
        Text(
            "没有关闭的括号里，累加器的值一直留在括号栈里，没有人用它。",
            "While a parenthesis is open the saved value waits on its stack and nobody uses it.",
        ),
        lesson=9,
    ),
    Rule(
        "RDR012",
        "input-written",
        "warning",
        Text(
            "{word} {address}写的是输入映像：下一次读输入时就被现场的状态覆盖。是想写Q吗？",
            "{word} {address} writes the image of an input: the next reading of the inputs overwrites it. Was Q meant?",
        ),
        Text(
            "输入映像在每个扫描开始时由端子刷新，程序写进去的值活不过一个扫描。",
            "The terminals refresh the input image at the start of each scan; what a program writes there lasts no longer.",
        ),
        lesson=0,
    ),
    Rule(
        "RDR013",
        "too-long",
        "error",
        Text(
            "这段文本太长（{size}），plcteach只读到{most}。",
            "The text is too long ({size}); plcteach reads up to {most}.",
        ),
        Text(
            "课程里的程序只有几十行；过长的文本多半是选错了文件。",
            "A lesson's program has some dozens of lines; a text of this size is most likely the wrong file.",
        ),
    ),
    Rule(
        "RDR014",
        "character-unread",
        "error",
        Text(
            "这里有读不出的字符（{word}）。文件的编码对吗？",
            "There is a character here that cannot be read ({word}). Is it the right file and encoding?",
        ),
        Text(
            "程序文本里不会有控制字符；多半是把别的文件当成了程序。",
            "A program's text has no control characters; most likely another kind of file was opened.",
        ),
    ),
    Rule(
        "RDR015",
        "variables-open",
        "error",
        Text(
            "从这里开始的变量表一直没有END_VAR；它后面的程序都没有读到。",
            "The table of variables that begins here has no END_VAR; nothing after it was read.",
        ),
        Text(
            "变量表里的行不是指令，要用END_VAR说明它到哪里为止。",
            "The rows of a table of variables are no instructions; END_VAR says where the program goes on.",
        ),
    ),
    Rule(
        "RDR016",
        "too-many-findings",
        "info",
        Text(
            "到这里已经有{most}条提示，后面的不再一一列出。是这个机型的程序吗？",
            "There are {most} findings up to here, and the rest is not listed. Is it the right file, and the right family?",
        ),
        Text(
            "没有人会读几百条提示；先改前面几条，其余的常常跟着消失。",
            "Nobody reads hundreds of findings; mend the first few, and many of the others go with them.",
        ),
    ),
    Rule(
        "RDR017",
        "other-family",
        "info",
        Text(
            "这看起来像{other}的{list}，而不是{family}的。机型选对了吗？",
            "This reads like the {list} of {other}, not of {family}. Is it the right family?",
        ),
        Text(
            "各家的助记符和地址不同：同一份文本换一个机型来读，往往处处是错。",
            "Each maker has its own mnemonics and addresses; a list read as another family's is wrong almost everywhere.",
        ),
        lesson=12,
    ),
    Rule(
        "RDR018",
        "interrupt-block",
        "error",
        Text(
            "第{row}行开始的中断程序里有指令；这里只执行主程序和它调用的子程序，不执行中断程序。能把它们写进主程序吗？",
            "The interrupt block that begins in row {row} holds instructions, and only the main program and the subroutines it calls are run here. Could they stand there?",
        ),
        Text(
            "主程序每个扫描执行一次，子程序被调用时执行；中断程序要等事件，不接在主程序后面执行。",
            "The main program runs once a scan and a subroutine when it is called; an interrupt waits for its event.",
        ),
    ),
    Rule(
        "RDR019",
        "word-for-bit",
        "error",
        Text(
            "{word}的操作数是一个位（{expected}），而{address}是一个字或一个功能块。要用的是哪一位？",
            "{word} works on one bit ({expected}), and {address} is a word or a whole block. Which bit of it is meant?",
        ),
        Text(
            "触点和线圈一次只读写一个位；字要用比较、传送和运算指令。",
            "A contact or coil reads or writes one bit; words have their own instructions: compare, move, arithmetic.",
        ),
        lesson=0,
    ),
    # STK: the stack, whatever the values
    Rule(
        "STK001",
        "underflow",
        "error",
        Text(
            "{word}要用{wanted}个值，本{unit}放进堆栈的只有{found}个。缺的那一块该由哪条{load}开始？",
            "{word} needs {wanted} values, but this {unit} has put only {found} on the stack. Which {load} should begin the missing block?",
        ),
        Text(
            "n个电路块只需要n－1条连接指令；多一条，就会去拿堆栈里不存在的块。",
            "n blocks need n − 1 joins; one more reaches for a block that was never put on the stack.",
        ),
        (4, 12, 25),
        lesson=7,
    ),
    Rule(
        "STK002",
        "lost-at-bottom",
        "error",
        Text(
            "{word}再压入一个值，{levels}层堆栈已满：最下面还没有用过的值（第{row}行）被推出丢失。能先连接几块吗？",
            "{word} pushes once more, but all {levels} levels are full: the value from row {row}, not yet used, falls out at the bottom. Can some blocks be joined earlier?",
        ),
        Text(
            "堆栈的层数是固定的，推出栈底的值再也取不回来。",
            "A stack has a fixed number of levels, and what leaves at the bottom never comes back.",
        ),
        (13, 14),
        lesson=8,
    ),
    Rule(
        "STK003",
        "pop-without-push",
        "error",
        Text(
            "{word}想取回分支点的值，但那里没有{push}存下的值{what}。对应的{push}在哪里？",
            "{word} fetches the value of a branch point, but no {push} has left one there{what}. Where is its {push}?",
        ),
        Text(
            "存分支点和取分支点必须在同一个独立电路里成对出现。",
            "Saving a branch point and fetching it come in pairs, within one circuit.",
        ),
        (9, 26),
        lesson=8,
    ),
    Rule(
        "STK004",
        "join-meets-branch",
        "error",
        Text(
            "{word}要连接两个电路块，但上面那个值是{push}存的分支点，不是电路块。是不是少了一条{pop}？",
            "{word} joins two blocks, but the value above is a branch point saved by {push}, not a block. Is a {pop} missing before it?",
        ),
        Text(
            "电路块由LD开始，分支点由进栈指令保存；连接指令只能连接电路块。",
            "A block begins with an LD, a branch point is saved by a push; a join takes blocks only.",
        ),
        misconceptions=(9,),
        lesson=8,
    ),
    Rule(
        "STK005",
        "residue",
        "error",
        Text(
            "本{unit}结束时堆栈里还剩{count}个没有用过的值（来自第{rows}行）。它该和谁连接，或由谁输出？",
            "This {unit} ends with unused values on the stack: {count} (row {rows}). What should join or output them?",
        ),
        Text(
            "每个放进堆栈的值都应当被连接或输出；剩下的值说明少了一条连接指令或出栈指令。",
            "Every value on the stack is there to be joined or output; one left over means that a join or a pop is missing.",
        ),
        (3, 5),
        lesson=7,
    ),
    Rule(
        "STK006",
        "last-branch-reads",
        "error",
        Text(
            "分支点的值到{unit}结束还留在堆栈里：最后一条支路应当用{pop}，而不是{read}。",
            "The branch point's value is still on the stack when the {unit} ends: the last branch wants {pop}, not {read}.",
        ),
        Text(
            "{read}只是看一眼，{pop}才把分支点的值取走，使堆栈恢复原状。".replace("{read}", "读栈").replace(
                "{pop}", "出栈"
            ),
            "A read only looks; the pop takes the branch point away and leaves the stack as it was before the push.",
        ),
        (10,),
        lesson=8,
    ),
    Rule(
        "STK007",
        "join-for-one-parallel",
        "info",
        Text(
            "只有一个触点的并联，{single}一条指令就够了，不必用{load}加{join}。",
            "One contact in parallel needs no block: {single} does in one instruction what {load} and {join} do in two.",
        ),
        Text(
            "结果一样，只是多用一条指令、多占一层堆栈。",
            "The result is the same, with one instruction and one level more.",
        ),
        (7,),
        lesson=7,
    ),
    Rule(
        "STK008",
        "join-for-one-series",
        "info",
        Text(
            "只有一个触点的串联，{single}一条指令就够了，不必用{load}加{join}。",
            "One contact in series needs no block: {single} does in one instruction what {load} and {join} do in two.",
        ),
        Text(
            "结果一样，只是多用一条指令、多占一层堆栈。",
            "The result is the same, with one instruction and one level more.",
        ),
        (7,),
        lesson=7,
    ),
    Rule(
        "STK009",
        "starts-from-leftover",
        "error",
        Text(
            "本{unit}第一条{word}就要用已有的值，可是这里还没有自己的值：它会接着用上一个{unit}留下的值。开头该用哪条{load}？",
            "This {unit} starts with {word}, which combines with a value that is not its own: what the last {unit} left behind. Which {load} should it begin with?",
        ),
        Text(
            "CPU不会在网络之间清空堆栈；每个网络都从LD开始，才不受前面的影响。",
            "The CPU does not clear the stack between networks; a network that begins with LD does not depend on the one before.",
        ),
        (15,),
        lesson=2,
    ),
    Rule(
        "STK010",
        "value-dropped",
        "warning",
        Text(
            "{word}丢掉了栈顶的值（来自第{row}行），而它还没有被用过。是不是少了一条连接或输出？",
            "{word} throws the top value away (from row {row}) before anything has used it. Is a join or an output missing?",
        ),
        Text(
            "读栈和出栈都会覆盖栈顶，它们不会替你保存原来的值。",
            "A read or a pop replaces the top of the stack; it does not keep a copy of what was there.",
        ),
        (3, 11),
        lesson=8,
    ),
    Rule(
        "STK011",
        "too-many-pending",
        "error",
        Text(
            "执行到{word}，有{count}个{kind}在等待；{family}最多允许{most}个。能先处理掉几个吗？",
            "At {word}, {count} {kind} are waiting; {family} allows {most}. Can some be finished earlier?",
        ),
        Text(
            "厂家给成组连接和多重分支各规定了上限；边写边连就不会超过。",
            "The maker limits how many blocks and branch points may wait at once; joining as you go stays below it.",
        ),
        (13, 14),
        lesson=7,
    ),
    Rule(
        "STK012",
        "not-inside-parentheses",
        "error",
        Text(
            "{word}不能写在括号里：括号里只收集触点。把它放到 ) 之后好吗？",
            "{word} cannot stand inside parentheses, which only collect contacts. Could it follow the )?",
        ),
        Text(
            "括号里的结果还没有和外面合并，这时输出或分支没有意义。",
            "Inside a parenthesis the result is not yet combined with the rest, so there is nothing to output or branch.",
        ),
        lesson=9,
    ),
    Rule(
        "STK013",
        "after-compound-output",
        "error",
        Text(
            "第{row}行是复合输出指令，{unit}到那里就结束了，后面却还有{word}。把它写进下一个{unit}？",
            "{word} stands after the compound output in row {row}, with which its {unit} ends. Does it belong in the next {unit}?",
        ),
        Text(
            "复合输出指令读取几路能流而不出栈，它们还留在数据栈上，后面的指令会错用它们。",
            "A compound output reads several flows and pops none; they stay on the data stack, where what follows would misuse them.",
        ),
        lesson=10,
    ),
    Rule(
        "STK014",
        "used-input",
        "warning",
        Text(
            "{word}的{pin}用的是第{row}行装载的值，而那个值已经有输出用过了。是不是少装载了一个输入？",
            "{word} takes for {pin} the value that row {row} loaded, and an output has used it already. Was a load for one of its inputs forgotten?",
        ),
        Text(
            "计数器每个输入要先各装载一个值，最后装载的在栈顶；少装载一个，它就拿到前面剩下的值。",
            "Each input of a counter wants a value of its own, loaded before it, the last one on top; with one too few it takes what an earlier line has left.",
        ),
        (3,),
        lesson=5,
    ),
    Rule(
        "CHK003",
        "reacts-later",
        "info",
        Text(
            "稳定以后结果一样，但中间有一个或几个扫描和参考不同：某一位的写和用，次序与参考不一样。",
            "At rest the result is right; for a scan or more on the way it is not the reference's: some bit is written and used in another order.",
        ),
        Text(
            "程序按顺序执行；先写后用，当个扫描就见效，先用后写，要等下一个扫描。",
            "A scan runs in order: a bit written before it is used acts at once, one written after acts in the next scan.",
        ),
        lesson=2,
    ),
    Rule(
        "CHK005",
        "pulse-differs",
        "warning",
        Text(
            "在{address}，参考和你的程序只有一个给出一两个扫描的脉冲。边沿属于哪个触点，定时器的那一个扫描又到哪里去了？",
            "At {address} only one of the two, the reference or your program, gives a pulse of a scan or two. Which contact does the edge belong to, and where does the timer's one scan go?",
        ),
        Text(
            "脉冲只有一个扫描，稳定以后看不出来；但后面的计数器、置位指令要靠它。",
            "A pulse is there for one scan and has left no trace at rest; but the counter or the latch behind it lives by it.",
        ),
        lesson=3,
    ),
    Rule(
        "CHK006",
        "need-unmet",
        "warning",
        Text("{need}", "{need}"),
        Text(
            "除了作用相同，题目还提出了要求，例如星形和三角形之间的互锁：定时器看起来已经够了，触点粘连时却只有互锁能防止短路。",
            "A task may ask for more than the right behaviour, such as the interlock of star and delta: the timer seems to be enough, but where a contact has welded only the interlock keeps them apart.",
        ),
        lesson=8,
    ),
    Rule(
        "CHK004",
        "never-rests",
        "warning",
        Text(
            "输入不变时，程序的某个输出还在每个扫描翻转，永远停不下来。是不是有一位在用自己的反？",
            "With the inputs held, the program goes on changing from scan to scan and never rests. Does some bit work on its own opposite?",
        ),
        Text(
            "一个线圈由自己的常闭触点驱动，就会一个扫描通、一个扫描断；要闪烁，用定时器。",
            "A coil driven by its own normally closed contact is on in one scan and off in the next; for flashing there are timers.",
        ),
        lesson=2,
    ),
    # STY: right, and yet it can be written better
    Rule(
        "STY001",
        "block-not-needed",
        "info",
        Text(
            "从{load}到{join}这一块里的触点都是{how}，和块外面的连接一样，不必成块：{load}写成{single}，{join}去掉。",
            "From {load} to {join} all contacts are in {how}, just as the block itself is joined, so it need not be a block: {load} becomes {single}, and {join} goes.",
        ),
        Text(
            "只有串联里套着并联，或并联里套着串联，才需要电路块。",
            "A block is needed only where parallel contacts stand in a series path, or series contacts in a parallel one.",
        ),
        (7,),
        lesson=7,
    ),
    Rule(
        "STY002",
        "push-not-needed",
        "info",
        Text(
            "{push}保存的值一直没有变过：到{pop}为止只有输出。去掉{push}和{pop}，几个输出直接一个接一个写，结果会变吗？",
            "Nothing changes what {push} has saved: up to {pop} there are outputs only. Would the result be another with the outputs one after the other, without {push} and {pop}?",
        ),
        Text(
            "输出不改变栈顶，下一个输出可以接着用；只有某条支路上还有触点时，才要保存分支点。",
            "An output leaves the top as it is, for the next one to use; a branch point is saved only where some branch has contacts of its own.",
        ),
        (8,),
        lesson=8,
    ),
    # COI: the program as a whole
    Rule(
        "COI001",
        "double-coil",
        "warning",
        Text(
            "{address}在第{row}行已经输出过一次；每个扫描里最后写的那个才算数。能把两个条件合成一个梯级吗？",
            "{address} is already driven in row {row}; in each scan the last coil wins. Can both conditions share one coil?",
        ),
        Text(
            "同一个线圈出现两次不是“或”：后面的结果覆盖前面的。",
            "Two coils of one bit are no OR: the later one overwrites what the earlier one wrote.",
        ),
        (20,),
        lesson=3,
    ),
    Rule(
        "COI002",
        "edge-memory-shared",
        "warning",
        Text(
            "{word}用{address}记住上次的能流，可是第{row}行也写{address}。能换一个没有别人用的位吗？",
            "{word} keeps the last flow in {address}, but row {row} writes {address} too. Could it have a bit of its own?",
        ),
        Text(
            "每个正跳变、负跳变都要有自己的记忆位，否则比较的是别人的旧值。",
            "Each edge needs a bit of its own to remember the last flow; shared, it compares with somebody else's.",
        ),
        lesson=3,
    ),
    Rule(
        "COI003",
        "master-open",
        "error",
        Text(
            "{word}打开的主控到程序结束也没有{end}。它管到哪里为止？",
            "The master control that {word} opens has no {end} before the program ends. How far should it reach?",
        ),
        Text(
            "MC和MCR成对：MC之后的触点接在主控的母线上，MCR才回到原来的母线。",
            "MC and MCR come in pairs: contacts after MC hang on its own rail, and MCR goes back to the one before.",
        ),
        lesson=8,
    ),
    Rule(
        "COI004",
        "master-stray",
        "error",
        Text(
            "{word}前面没有打开着的{begin}。它要结束哪一个主控？",
            "{word} ends nothing: no {begin} is open before it. Which master control is meant?",
        ),
        Text(
            "MCR结束的是同一编号的MC；没有打开的主控就没有什么可以结束。",
            "An MCR ends the MC with its own number; where none is open there is nothing to end.",
        ),
        lesson=8,
    ),
    Rule(
        "COI005",
        "master-nesting",
        "error",
        Text(
            "{word}写在{outer}里面，编号却不比它大。嵌套的编号要从N0起由外向里变大，这里该用哪个编号？",
            "{word} stands inside {outer}, but its number is not larger. Nested numbers grow from N0 inwards; which one belongs here?",
        ),
        Text(
            "主控按编号嵌套：外层N0，里层N1……；MCR N0会把里面的各层一起结束。",
            "Master controls nest by number, N0 outside, then N1; MCR N0 ends all that are open inside it.",
        ),
        lesson=8,
    ),
    Rule(
        "COI006",
        "master-in-step",
        "error",
        Text(
            "{word}写在步（{step}）里面，那里不能用主控。把条件写进这一步的触点，或者把主控放到步的外面，哪个合适？",
            "{word} stands inside a step ({step}), where there is no master control. Could its condition be a contact there, or the master stand outside?",
        ),
        Text(
            "步本身就是一段有条件的母线，两种母线不能这样套在一起。",
            "A step is a rail with a condition already, and the two kinds of rail do not nest this way.",
        ),
        lesson=8,
    ),
    Rule(
        "COI007",
        "branch-after-step",
        "error",
        Text(
            "{word}紧跟在{step}后面：步的触点后面不能直接{word}。中间该先有哪条{load}？",
            "{word} follows {step} at once, and a step's contact cannot be branched like that. Which {load} should come between?",
        ),
        Text(
            "STL后面先用LD取一个触点，再进栈分支。",
            "After STL a contact is loaded first; what it gives can then be branched.",
        ),
    ),
    Rule(
        "COI008",
        "steps-open",
        "error",
        Text(
            "{word}以后一直没有{end}：后面的电路都算在这一步里。步进程序到哪里为止？",
            "After {word} there is no {end}, so that everything below belongs to this step. Where do the steps end?",
        ),
        Text(
            "一组步写完要用RET回到原来的母线，否则后面的电路只在最后一步里有能流。",
            "After the last step RET goes back to the rail; without it, all that follows has power in that step only.",
        ),
    ),
    Rule(
        "COI009",
        "output-without-a-contact",
        "error",
        Text(
            "{word}写在本{unit}的最前面，前面没有触点：输出不能直接接在左母线上。应该由哪个条件接通它？{always}",
            "{word} stands at the very beginning of this {unit}, before any contact, and no output hangs right on the left rail. Which condition is to switch it?{always}",
        ),
        Text(
            "输出指令把栈顶的值送给线圈；前面没有触点，那里就没有本梯级自己的值。",
            "An output hands the top of the stack to its coil; with no contact before it there is no value of its own to hand over.",
        ),
        misconceptions=(15,),
        lesson=2,
    ),
    Rule(
        "COI010",
        "block-driven-twice",
        "warning",
        Text(
            "{address}在第{row}行已经驱动过一次：同一个编号只有一个当前值和一个位，两行都在改它。能把两个条件合成一个，还是换一个编号？",
            "{address} is already driven in row {row}: a number has one current value and one bit, and both lines work on them. Can both conditions share one line, or should each have a number of its own?",
        ),
        Text(
            "同一个定时器或计数器写两次不是“或”：一行让它计，另一行又把它复位，或者两行数到一起。",
            "Two lines for one timer or counter are no OR: one lets it run and the other clears it, or both count into the same value.",
        ),
        (20,),
        lesson=4,
    ),
    # TMR: timers by their numbers
    Rule(
        "TMR001",
        "timer-number",
        "error",
        Text(
            "{address}是{title}的编号，{word}用不了它；{word}可以用{fitting}。要用哪一个？",
            "{address} is the number of a {title}, which {word} cannot drive; {word} takes {fitting}. Which one is meant?",
        ),
        Text(
            "定时器的编号决定它是否有记忆、分辨率是多少，指令要与编号相配。",
            "A timer's number decides whether it is retentive and what it counts in, and the instruction must go with it.",
        ),
        lesson=4,
    ),
    Rule(
        "TMR002",
        "timer-shared",
        "error",
        Text(
            "{address}在第{row}行已经由{other}驱动，这里又由{word}驱动：同一个编号不能既接通延时又断开延时。换一个编号？",
            "{address} is driven by {other} in row {row} and by {word} here: one number is either an on-delay or an off-delay. Another number?",
        ),
        Text(
            "一个编号只有一个当前值和一个位；两种定时器用同一个编号，互相改写。",
            "A number has one current value and one bit; two kinds of timer that share it overwrite each other.",
        ),
        lesson=4,
    ),
    Rule(
        "TMR003",
        "timer-resets-itself",
        "warning",
        Text(
            "{address}用自己取反的位复位自己，而它的位是{when}接通的：多半还没有别的指令看到它，它就又断开了。让一个中间位来复位它？",
            "{address} resets itself by its own bit inverted, but this bit comes on {when}: mostly it is off again before any other line has seen it. Should a bit of memory reset it?",
        ),
        Text(
            "定时器要在执行到自己的指令时才刷新（S7-200只有100 ms的），才能用自己的位复位；1 ms和10 ms定时器要用一个中间位复位。",
            "A timer can reset itself only where it is brought up to date at its own instruction, as 100 ms timers of the S7-200 are; 1 ms and 10 ms timers want a bit of memory between.",
        ),
        (22,),
        lesson=4,
    ),
    # BOX: ladder boxes that become two instructions
    Rule(
        "BOX001",
        "box-overwrites-its-operand",
        "warning",
        Text(
            "{word}变成{first}和{then}：第一条已经改写了{address}，第二条再读它时，它不再是原来的值。先把它移到别处？",
            "{word} becomes {first} and {then}: the first already overwrites {address}, which the second then reads. Move it out of the way first?",
        ),
        Text(
            "功能框分解成两条指令；OUT与IN2占用的字节有重叠，而IN1又不是OUT时，结果不是两数之和。",
            "A box is split into two instructions; where OUT's bytes overlap IN2's and IN1 is not OUT itself, the result is another one.",
        ),
        (27,),
        lesson=10,
    ),
    Rule(
        "BOX002",
        "box-needs-a-spare-word",
        "error",
        Text(
            "{word}不能安全地分解：{out}与{address}的字节有重叠，先写哪一个都会丢掉另一个。用一个空闲的字存中间结果？",
            "{word} cannot be split safely: {out} and {address} share bytes, so whichever is written first spoils the other. A spare word for the result in between?",
        ),
        Text(
            "IN2就是OUT、而运算又不能交换时，或者两者只重叠一部分时，要有一个中间字。",
            "Where IN2 is OUT and the operation cannot be turned round, or they overlap in part, a word in between is needed.",
        ),
        (27,),
        lesson=10,
    ),
    # EXP, CFG, BLK: words in brackets, the configuration of function blocks, and their sections
    Rule(
        "EXP001",
        "bracket-unread",
        "error",
        Text(
            "方括号里这里应写{expected}，而不是“{word}”。",
            "Expected here, inside the brackets: {expected}, not {word}.",
        ),
        Text(
            "方括号里是一个运算或一个比较，只有一个运算符：[%MW0 := %MW1 + 5]、[%MW0 > 10]。",
            "Brackets hold one operation or one comparison, with a single operator: [%MW0 := %MW1 + 5], [%MW0 > 10].",
        ),
        lesson=6,
    ),
    Rule(
        "CFG001",
        "configuration-unread",
        "error",
        Text(
            "“{word}”不能在这里设置，可以写的有：{expected}", "{word} cannot be configured here; what can: {expected}"
        ),
        Text(
            "功能块的类型、时基、预设值等在程序之前设好，例如 %TM0: TYPE=TON TB=1s P=5。",
            "Type, time base, preset of a block are settled before the program begins, as in %TM0: TYPE=TON TB=1s P=5.",
        ),
        lesson=6,
    ),
    Rule(
        "CFG002",
        "configuration-value",
        "error",
        Text("{name}应是{expected}，这里是“{word}”。", "{name} is to be {expected}; here it is {word}."),
        Text(
            "每一项设置都有规定的取值；预设值在0到9999之间，时基有五种。",
            "Each setting has the values it may take: a preset lies between 0 and 9999, and there are five time bases.",
        ),
        lesson=6,
    ),
    Rule(
        "CFG003",
        "drum-rows-uneven",
        "error",
        Text(
            "{block}的第{step}步“{word}”有{size}位，而OUT有{outputs}个输出。每个输出占一位，缺了哪一位？",
            "Step {step} of {block}, {word}, has {size} control bits, and OUT has {outputs} outputs. Which one is which?",
        ),
        Text(
            "鼓形控制器每一步的控制位和输出一一对应。",
            "In every step of a drum there is one control bit for each output.",
        ),
        lesson=6,
    ),
    Rule(
        "CFG004",
        "configuration-late",
        "error",
        Text(
            "{block}的设置写在了指令后面。把这一行移到第一个梯级之前。",
            "{block} is configured below an instruction. Move this line above the first rung.",
        ),
        Text(
            "设置在程序运行之前就生效，和它写在哪个梯级旁边无关，所以都写在最前面。",
            "A configuration holds before the program runs, wherever it stands, so all of them stand at the beginning.",
        ),
        lesson=6,
    ),
    Rule(
        "CFG005",
        "configured-twice",
        "error",
        Text(
            "{word}在第{row}行已经设置过了。该用哪一个？",
            "{word} has been configured in row {row} already. Which one counts?",
        ),
        Text("一个功能块只有一组设置。", "A block has one configuration."),
        lesson=6,
    ),
    Rule(
        "CFG006",
        "configuration-incomplete",
        "error",
        Text("{block}这一行还缺{word}。", "The line of {block} still lacks {word}."),
        Text(
            "鼓形控制器既要知道驱动哪些输出（OUT），也要知道每一步各是多少（STEPS）。",
            "A drum must know which outputs it drives (OUT) and what they are in every step (STEPS).",
        ),
        lesson=6,
    ),
    Rule(
        "CFG007",
        "preset-locked",
        "error",
        Text(
            "{block}设成了ADJ=N，程序不能改写{address}。要让程序改，就把ADJ设为Y。",
            "{block} is configured with ADJ=N, so the program may not write {address}. Should ADJ be Y?",
        ),
        Text(
            "ADJ说明预设值能不能改：Y可以改，N不可以。",
            "ADJ says whether the preset may be changed: Y it may, N it may not.",
        ),
        lesson=6,
    ),
    Rule(
        "CFG008",
        "drum-without-steps",
        "warning",
        Text(
            "{block}没有设置步，它什么也不驱动。在程序前面加一行 {block}: OUT=… STEPS=… 好吗？",
            "{block} has no steps, so it drives nothing. Is a line {block}: OUT=… STEPS=… missing at the beginning?",
        ),
        Text(
            "鼓形控制器的输出不写在梯级里，而写在它的设置里。",
            "What a drum drives stands in no rung but in its configuration.",
        ),
        lesson=6,
    ),
    Rule(
        "BLK001",
        "block-in-block",
        "error",
        Text(
            "{block}还没有用END_BLK结束，{word}就开始了。先结束前一个好吗？",
            "{word} begins while {block} is still open. Should an END_BLK stand before it?",
        ),
        Text("功能块一个接一个写，不能套在一起。", "Blocks stand one after the other, never inside each other."),
        lesson=6,
    ),
    Rule(
        "BLK002",
        "output-before-out-blk",
        "error",
        Text(
            "{block}的输出{word}要写在OUT_BLK后面。这里少了OUT_BLK吗？",
            "{word} is an output of {block} and is read after OUT_BLK. Is OUT_BLK missing above?",
        ),
        Text(
            "功能块在OUT_BLK处才动作；在那之前它的输出还是上一个扫描周期的。",
            "A block acts at OUT_BLK; before it, its outputs are still those of the last scan.",
        ),
        lesson=6,
    ),
    Rule(
        "BLK003",
        "no-open-block",
        "error",
        Text("{word}前面没有打开的功能块。少了BLK吗？", "No block is open at {word}. Is its BLK missing?"),
        Text(
            "BLK打开一个功能块，OUT_BLK转到它的输出，END_BLK结束它。",
            "BLK opens a block, OUT_BLK turns to its outputs, END_BLK ends it.",
        ),
        lesson=6,
    ),
    Rule(
        "BLK004",
        "no-such-pin",
        "error",
        Text("{block}没有叫{word}的端子；它的{what}有：{names}。", "{block} has no {word}; its {what}: {names}."),
        Text(
            "每种功能块有自己的输入和输出：定时器是IN和Q，计数器是R、S、CU、CD和E、D、F。",
            "Each kind of block has its own pins: a timer IN and Q, a counter R, S, CU, CD and E, D, F.",
        ),
        lesson=6,
    ),
    Rule(
        "BLK005",
        "input-after-out-blk",
        "error",
        Text(
            "{word}来晚了：{block}在OUT_BLK处已经动作。把它移到OUT_BLK之前。",
            "{word} comes too late: {block} has acted at OUT_BLK. Move it above OUT_BLK.",
        ),
        Text("输入在OUT_BLK之前，输出在它之后。", "Inputs stand before OUT_BLK, outputs after it."),
        lesson=6,
    ),
    Rule(
        "BLK006",
        "not-inside-block",
        "error",
        Text(
            "{word}不能写在{block}的BLK和END_BLK之间。移到END_BLK后面好吗？",
            "{word} does not belong between BLK and END_BLK of {block}. Should it stand after END_BLK?",
        ),
        Text(
            "BLK和END_BLK之间只有这个功能块的输入和输出；跳进跳出会让它只动作一半。",
            "Between BLK and END_BLK stand the inputs and outputs of this block alone; a jump would let it act by half.",
        ),
        lesson=6,
    ),
    Rule(
        "BLK007",
        "end-blk-missing",
        "error",
        Text("{block}的BLK没有用END_BLK结束。它到哪里为止？", "The BLK of {block} has no END_BLK. Where does it end?"),
        Text(
            "没有END_BLK，后面的R、S等都会被当成这个功能块的输入。",
            "Without END_BLK an R or S below would be taken for its input.",
        ),
        lesson=6,
    ),
    Rule(
        "BLK008",
        "pin-of-no-block",
        "error",
        Text(
            "{word}是功能块的输入，可这里没有打开的功能块。写成 {word} %…，还是放到BLK里？",
            "{word} is the input of a block, and no block is open here. Name the block behind it, or put it between BLK and END_BLK?",
        ),
        Text(
            "只有在BLK和END_BLK之间，输入的名字才能单独写。",
            "Only between BLK and END_BLK can the name of an input stand alone.",
        ),
        lesson=6,
    ),
    Rule(
        "BLK009",
        "shifts-only-zeros",
        "warning",
        Text(
            "{block}只移位，却没有一行写入它：移来移去都是0。第一个1从哪里来？",
            "{block} is shifted, but no line ever writes to it: it moves nothing but zeros. Where does the first 1 come from?",
        ),
        Text(
            "移位寄存器不会自己装入数据；使用前要用ST或S写入它的某一位。",
            "A shift register does not fill itself; ST or S must put something into one of its bits.",
        ),
        (28,),
        lesson=6,
    ),
    # JMP: where a program goes on
    Rule(
        "JMP001",
        "no-such-place",
        "error",
        Text(
            "{word}要去{name}，可程序里没有{name}。",
            "{word} goes to {name}, and there is no {name} in this program. Where should it go?",
        ),
        Text(
            "跳转要有标号，调用要有子程序。",
            "A jump needs its label, a call its subroutine.",
        ),
    ),
    Rule(
        "JMP002",
        "place-twice",
        "error",
        Text(
            "{name}在第{row}行已经有了。跳转该去哪一个？",
            "{name} stands in row {row} already. Which of the two is meant?",
        ),
        Text("同一个标号只能出现一次。", "A label stands only once."),
    ),
    Rule(
        "JMP003",
        "subroutine-before-end",
        "error",
        Text(
            "{name}写在主程序结束之前，主程序会走进子程序里。在它前面加{end}好吗？",
            "{name} stands before the end of the main program, which would run into it. Should {end} stand above it?",
        ),
        Text(
            "子程序写在主程序结束之后，只有调用才能进入。",
            "Subroutines stand after the end of the main program, and only a call enters them.",
        ),
    ),
    Rule(
        "JMP004",
        "jump-inside-branch",
        "error",
        Text(
            "{word}写在{push}和{pop}之间：跳走以后分支点就留在栈里了。先写完分支好吗？",
            "{word} stands between {push} and {pop}: after the jump the branch point would be left over. Should the branch end first?",
        ),
        Text("跳转和标号不能写在分支当中。", "Jumps and labels do not stand inside a branch."),
    ),
    Rule(
        "JMP005",
        "loop-unpaired",
        "error",
        Text("{word}：{what}。另一半该写在哪里？", "{word}: {what}. Where should its other half stand?"),
        Text(
            "循环开始和循环结束成对出现，在同一个程序块里。",
            "The beginning and the end of a loop come in pairs, in one routine.",
        ),
    ),
    Rule(
        "JMP006",
        "loops-too-deep",
        "error",
        Text(
            "{word}是第{depth}层循环，最多嵌套{most}层。能把里面的几层写进子程序吗？",
            "{word} is a loop at depth {depth}, and {most} may stand within each other. Could the inner ones go into a subroutine?",
        ),
        Text("CPU能记住的循环层数是有限的。", "The CPU keeps track of only so many loops at once."),
    ),
    # RUN: only the values can tell
    Rule(
        "RUN001",
        "x-reaches-output",
        "warning",
        Text(
            "{address}得到的是x：它来自栈底补进来的、谁也不知道的值，实际PLC上可能是0也可能是1。",
            "{address} receives x: it comes from a cell that entered the stack unknown, and on a real PLC it may be 0 or 1.",
        ),
        Text(
            "出栈时栈底补进的值是不确定的；正确的程序从不用到它。",
            "What enters at the bottom when the stack moves up is unknown; a sound program never uses it.",
        ),
        (4, 12, 13),
        lesson=1,
    ),
    Rule(
        "RUN002",
        "runaway",
        "error",
        Text(
            "一个扫描周期里已经执行了{count}条指令还没有结束：{word}总是往回跳，扫描到不了末尾。怎样让它停下来？",
            "One scan has executed {count} lines without coming to its end: {word} goes back again and again. What is to stop it?",
        ),
        Text(
            "PLC的看门狗会在扫描时间过长时停机；往回跳的程序必须有结束的条件。",
            "A PLC's watchdog stops a scan that takes too long; whatever goes back needs a condition that ends it.",
        ),
    ),
    Rule(
        "RUN003",
        "nested-too-deep",
        "warning",
        Text(
            "{word}处的子程序已经嵌套8层，这一次不再调用。",
            "At {word} eight calls are already nested, so this one is not made.",
        ),
        Text(
            "子程序最多嵌套8层；自己调用自己的子程序很快就会用完。",
            "Calls nest eight deep; a subroutine that calls itself uses them up quickly.",
        ),
    ),
    Rule(
        "RUN004",
        "step-counter-at-its-end",
        "warning",
        Text(
            "{block}已经在头一步或最后一步，再往外走一步不起作用，它停在那里。是不是该先复位？",
            "{block} stands at its first or last step and was asked to go beyond it; it stays there. Should it be reset first?",
        ),
        Text(
            "步进计数器有256位，从第0步到第255步；到了头不会绕回去。",
            "A step counter has 256 steps, 0 to 255, and does not go round at either end.",
        ),
        lesson=6,
    ),
    # CHK: beside the reference
    Rule(
        "CHK001",
        "extra-output",
        "warning",
        Text(
            "程序还写了{address}，参考梯形图里没有它。真的需要吗？",
            "The program also writes {address}, which the reference ladder does not. Is it meant?",
        ),
        Text(
            "多驱动一个输出，现场就可能多动一台设备。",
            "One output too many, and on the plant something moves that nobody asked for.",
        ),
        lesson=11,
    ),
    Rule(
        "CHK002",
        "output-missing",
        "warning",
        Text(
            "程序没有写{address}，参考梯形图里有它。", "The program never writes {address}; the reference ladder does."
        ),
        Text("没有写的输出一直是0。", "An output that is never written stays 0."),
        lesson=11,
    ),
    # DRW: reading a ladder drawing or a one-line rung
    Rule(
        "DRW001",
        "no-drawing-sign",
        "error",
        Text(
            "“{word}”不是梯形图里的符号。是注释的话，前面加 // 好吗？",
            "{word} is no part of a drawing. If it is a comment, could it follow //?",
        ),
        Text(
            "图里只有导线 - | +、触点 [ ]、线圈 ( ) 和方框 { }。",
            "A drawing has wires - | +, contacts [ ], coils ( ) and boxes { }.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW002",
        "bracket-open",
        "error",
        Text(
            "这个 {word} 没有配对的另一半。触点、线圈或方框到哪里为止？",
            "This {word} has no partner on its row. Where does the contact, coil or box end?",
        ),
        Text(
            "触点写成 [ I0.0 ]，线圈写成 ( Q0.0 )，方框写成 { TON T37, 50 }，左右括号在同一行。",
            "A contact is [ I0.0 ], a coil ( Q0.0 ), a box { TON T37, 50 }, both brackets on one row.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW003",
        "contact-unread",
        "error",
        Text(
            "读不出触点 {word}。可以写 [ I0.0 ]、[/I0.0]、[P I0.0]、[I I0.0]、[ VW0 >= 5 ]、[P] 或 [NOT]，这里是哪一种？",
            "{word} does not read as a contact. [ I0.0 ], [/I0.0], [P I0.0], [I I0.0], [ VW0 >= 5 ], [P] and [NOT] do; "
            "which is meant?",
        ),
        Text(
            "一个触点看一个位（常开、常闭、上升沿或下降沿），或者比较两个字；[NOT]、[P]、[N] 处理左边来的能流。",
            "A contact looks at one bit (open, closed, rising, falling) or compares two words; [NOT], [P] and [N] work on the "
            "flow from the left.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW004",
        "coil-unread",
        "error",
        Text(
            "读不出线圈 {word}。可以写 ( Q0.0 )、(S Q0.0)、(S Q0.0 3)、(R Q0.0)、(/ Q0.0)、(P M0.0) 或 (I Q0.0)，这里是哪一种？",
            "{word} does not read as a coil. ( Q0.0 ), (S Q0.0), (S Q0.0 3), (R Q0.0), (/ Q0.0), (P M0.0) and (I Q0.0) do; "
            "which is meant?",
        ),
        Text(
            "一个线圈写一个位；置位和复位还可以写出位数（1–255）。",
            "A coil writes one bit; set and reset may say over how many bits (1 to 255).",
        ),
        lesson=11,
    ),
    Rule(
        "DRW005",
        "box-unread",
        "error",
        Text(
            "读不出方框 {word}。可以写 {{ TON T37, 50 }}，几个输入时写 {{CU: CTU C0, 3 }}，下面再写 {{R: }}，这里是哪一种？",
            "{word} does not read as a box. {{ TON T37, 50 }} does, and with several inputs {{CU: CTU C0, 3 }} above {{R: }}; "
            "which is meant?",
        ),
        Text(
            "方框里是一条指令，照指令表的写法；有几个输入时，前面写这一行的输入名和冒号。",
            "A box holds one instruction as a list has it; where it has several inputs, the name of this row's input and a "
            "colon come first.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW006",
        "wire-ends",
        "error",
        Text(
            "导线到这里断了，没有接上任何东西。它该接到哪里？",
            "This wire ends here and meets nothing. What should it reach?",
        ),
        Text(
            "竖线用 | 对准上下两个 +，横线中间不能有空格。",
            "A | stands exactly below a +, and a wire along a row has no gap in it.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW007",
        "no-coil",
        "error",
        Text(
            "这条支路到{word}就结束了，后面没有线圈，也没有方框。它要控制什么？",
            "This path ends after {word}, with no coil and no box. What should it drive?",
        ),
        Text(
            "每条支路从左母线出发，最后到一个线圈或方框。",
            "Every path starts at the left rail and ends in a coil or a box.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW008",
        "not-fed",
        "error",
        Text(
            "没有导线从左母线通到{word}。它的左边该接什么？",
            "No wire leads from the left rail to {word}. What should feed it?",
        ),
        Text(
            "能流从左母线向右流；左边没有接线，就永远没有能流。",
            "Power flows from the left rail to the right; with nothing on the left there is never any.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW009",
        "no-series-parallel",
        "error",
        Text(
            "几条路在这里会合，但它们不是从同一个点分出来的（桥式电路）。能改画成只有串联和并联的图吗？",
            "Paths meet here that did not part at one point (a bridge). Can it be drawn with series and parallel only?",
        ),
        Text(
            "指令表一块一块地串联、并联；桥式电路没有这样的块，要先改画。",
            "An instruction list joins block after block in series or in parallel; a bridge has no such blocks.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW010",
        "wire-past",
        "error",
        Text(
            "有一条导线从{word}旁边直接绕过去，它通不通都一样。这条线是多画的吗？",
            "A wire leads straight past {word}, which then makes no difference. Is that wire meant?",
        ),
        Text("并联一条没有触点的导线，就是短接。", "A parallel wire without a contact is a short circuit."),
        lesson=11,
    ),
    Rule(
        "DRW011",
        "behind-coil",
        "error",
        Text(
            "{word}画在线圈或方框的右边。一级到那里就是终点，它该放在左边吗？",
            "{word} stands to the right of a coil or box, where a rung ends. Does it belong to the left of that?",
        ),
        Text(
            "线圈和方框右边只有右母线；几个输出要上下并联。",
            "Right of a coil or box there is only the right rail; several outputs stand below each other.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW012",
        "drawing-too-large",
        "error",
        Text(
            "这张图太大（{size}），最多读到{most}。是不是选错了文件？",
            "The drawing is too large ({size}; up to {most} is read). Is it the right file?",
        ),
        Text(
            "一级梯形图通常只有几行；过大的文本多半不是图。",
            "A rung has a few rows; a text of this size is most likely something else.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW013",
        "formula-unread",
        "error",
        Text(
            "这里写的是“{word}”，但应当是{expected}。这里想表达什么？",
            "Here stands {word}; expected was {expected}. What is meant here?",
        ),
        Text(
            "一行式写成 (I0.0 + Q0.0) · /I0.1 -> Q0.0：先写条件，再写箭头和输出。",
            "On one line a rung is (I0.0 + Q0.0) · /I0.1 -> Q0.0: the condition, an arrow, the outputs.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW014",
        "nested-too-deep",
        "error",
        Text(
            "这里的嵌套超过{most}层。能分成几级来写吗？",
            "The nesting here is deeper than {most}. Can it be split into several rungs?",
        ),
        Text(
            "没有哪个PLC的堆栈有这么多层，人也看不清。", "No PLC has a stack that deep, and no reader could follow it."
        ),
        lesson=11,
    ),
    Rule(
        "DRW015",
        "no-rung",
        "error",
        Text(
            "这里没有一级梯形图。例如 --[ I0.0 ]--( Q0.0 )，从哪个触点开始？",
            "There is no rung here. One is --[ I0.0 ]--( Q0.0 ). Which contact comes first?",
        ),
        Text(
            "一级梯形图至少有一个线圈或方框，左边是它的条件。",
            "A rung has at least a coil or a box, with its condition on the left.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW016",
        "joint-aside",
        "error",
        Text(
            "第{column}列的 {what} {side}没有 {sign}，最近的在第{near}列。它们是不是应该上下对齐？",
            "The {what} at column {column} has no {sign} {side} it; the nearest is at column {near}. "
            "Should they stand under each other?",
        ),
        Text(
            "+ 只和正上方、正下方的 + 或 | 相连，差一列就没有接上。",
            "A + meets only the + or | right above or below it; one column aside, and nothing is joined.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW017",
        "joint-missing",
        "error",
        Text(
            "导线在第{column}列结束，没有 +；{side}最近的 {sign} 在第{near}列。要不要把线画到第{near}列，在那里写一个 +？",
            "The wire ends at column {column} without a +; the nearest {sign} {side} it is at column {near}. "
            "Should it reach column {near} and have a + there?",
        ),
        Text(
            "横线要接到竖线上，交点处写 +；只靠在旁边不算接上。",
            "Where a wire joins one above or below, a + stands; being near is not being joined.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW018",
        "input-without-box",
        "error",
        Text(
            "{word}是方框的另一个输入，而它上面{above}。它属于哪个方框？",
            "{word} is a further input of a box, and above it {above}. Which box does it belong to?",
        ),
        Text(
            "方框有几个输入时，第一个输入在方框那一行，其余的在正下面，每个一行。",
            "Where a box has several inputs, the first is on the row of the box and the others right below it, a row each.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW019",
        "input-without-path",
        "error",
        Text(
            "{word}要有自己的一行：从左母线出发，至少一个触点，只通到它。这里该怎么接？",
            "{word} wants a row of its own: from the left rail, with at least one contact, to it alone. What should lead to it?",
        ),
        Text(
            "方框的每个输入各有自己的条件，在指令表里各由一条新的装载指令开始。",
            "Each input of a box has its own condition, and in the list each begins with a load.",
        ),
        lesson=11,
    ),
    Rule(
        "DRW020",
        "box-not-last",
        "error",
        Text(
            "{word}有几个输入，它后面却还有别的输出。能把它放到这一级的最后吗？",
            "{word} has several inputs, and yet another output follows it. Could it be the last one of its rung?",
        ),
        Text(
            "它的几个输入一起留在堆栈里等它用，后面的输出就取不到自己要的值。",
            "Its inputs lie on the stack together until it takes them, so an output after it would not find its own value.",
        ),
        lesson=11,
    ),
    # LAD: lists that are no ladder, and what a program editor would not show as one
    Rule(
        "LAD001",
        "no-way-from-the-rail",
        "warning",
        Text(
            "“{word}”用到的值不是这个{unit}里的触点得来的：堆栈里没有放进过它，或者是别处留下的。它前面原来应该接哪些触点？",
            "{word} uses a value that no contact of this {unit} has made: nothing was put on the stack for it, or something "
            "else has left it there. Which contacts should stand before it?",
        ),
        Text(
            "梯形图里的能流都从左母线经过触点而来；没有来处的值画不出来。",
            "In a ladder all power comes from the left rail through contacts; a value from nowhere cannot be drawn.",
        ),
        lesson=11,
    ),
    Rule(
        "LAD002",
        "output-inside-a-block",
        "warning",
        Text(
            "“{word}”要连接的电路块里，第{row}行已经接了一个输出。把那个输出放到连接之后，或者另写一个{unit}，行吗？",
            "The block that {word} takes has an output inside it already, in row {row}. Can that output stand behind the join, "
            "or in a {unit} of its own?",
        ),
        Text(
            "梯形图的输出都在最右边，它后面的线不能再和别的电路块连起来。",
            "In a ladder outputs stand at the far right; no wire comes back from one to be joined with another block.",
        ),
        lesson=11,
    ),
    Rule(
        "LAD003",
        "back-to-an-earlier-branch",
        "warning",
        Text(
            "“{word}”接在前面已经画完的支路上，而中间执行过别的输出。把同一个分支点的输出放在一起，行吗？",
            "{word} hangs on a path that is finished, and other outputs have been executed in between. Can the outputs of one "
            "branch point stand together?",
        ),
        Text(
            "梯形图从上到下执行；回到上面的支路，就不再是原来的顺序了。",
            "A ladder is executed from top to bottom; to go back to a path above would be another order.",
        ),
        lesson=11,
    ),
    Rule(
        "LAD004",
        "drawn-after-a-change",
        "warning",
        Text(
            "“{word}”读到的值在梯形图里要画到第{row}行之后，而第{row}行可能已经改变了它。先把它存到一个存储器位里，行吗？",
            "What {word} reads would have to be drawn behind row {row}, which may have changed it by then. Can it be kept in a "
            "memory bit first?",
        ),
        Text(
            "指令表读一次、用两次的值，梯形图要画两个触点；两次之间若被改写，两个触点就不一样了。",
            "A value that a list reads once and uses twice needs two contacts in a ladder, and they differ if the bit is "
            "written in between.",
        ),
        lesson=11,
    ),
    Rule(
        "LAD005",
        "not-within-a-block",
        "warning",
        Text(
            "“{word}”只作用于一个不从左母线开始的电路块，而梯形图里它作用于左边全部的能流。把这个块放到最前面，或者换成相反的触点，行吗？",
            "{word} acts on a block that does not begin at the left rail, but in a ladder it acts on all the power from its left. "
            "Can the block come first, or its contacts be turned round one by one?",
        ),
        Text(
            "取反和沿在线上作用于从左母线来的全部能流。",
            "NOT and an edge on the wire act on the whole flow from the left rail.",
        ),
        lesson=11,
    ),
    Rule(
        "LAD006",
        "ladder-too-large",
        "warning",
        Text(
            "到“{word}”为止，这一级画成梯形图太大了：超过{most}个符号，或者{most}层嵌套。能用中间的存储器位把它分开吗？",
            "Up to {word} this rung is too large to be drawn: it passes {most} symbols, or {most} levels of nesting. Can memory "
            "bits divide it?",
        ),
        Text(
            "没有人能读这么大的一级梯形图；指令表照样可以运行。",
            "Nobody can read a rung of that size; as a list it runs all the same.",
        ),
        lesson=11,
    ),
    Rule(
        "LAD007",
        "two-rungs-in-one-network",
        "info",
        Text(
            "从“{word}”起又从左母线开始了一级，编程软件不会把这个网络显示为梯形图。把它放到下一个网络里。",
            "With {word} a second rung begins at the left rail, so the editor does not show this network as a ladder. Give it a "
            "network of its own.",
        ),
        Text(
            "在这种编程软件里，一个网络就是一级；程序照样运行，只是看不到梯形图。",
            "In that editor one network is one rung. The program runs all the same; only its ladder is not shown.",
        ),
        lesson=11,
    ),
    Rule(
        "LAD008",
        "logic-behind-the-last-branch",
        "info",
        Text(
            "最后一条支路的输出之后，“{word}”还在继续，编程软件不会把这个网络显示为梯形图。把后面的部分放到另一个网络里。",
            "Behind the output of the last branch, {word} goes on, so the editor does not show this network as a ladder. Put what "
            "follows into a network of its own.",
        ),
        Text(
            "出栈之后的支路在它的输出处结束；要再分支，应当先入栈。",
            "The branch behind a pop ends at its output; to part once more there, the flow has to be pushed first.",
        ),
        lesson=11,
    ),
    Rule(
        "LAD009",
        "must-stand-alone",
        "info",
        Text(
            "“{word}”不取用能流，应当单独占一个网络，否则编程软件不会把这个网络显示为梯形图。把它移到自己的网络里。",
            "{word} takes no power and stands in a network by itself; with company, the editor does not show the network as a "
            "ladder. Move it into one of its own.",
        ),
        Text(
            "标号、循环结束、顺序段的开始和结束直接接在左母线上。",
            "Labels, the end of a loop, and the ends of a segment hang on the left rail itself.",
        ),
        lesson=11,
    ),
    Rule(
        "LAD010",
        "begins-without-a-contact",
        "info",
        Text(
            "这个网络以“{word}”开头，编程软件不会把它显示为梯形图。让它以装载一个触点的指令开头。",
            "This network begins with {word}, so the editor does not show it as a ladder. Let it begin by loading a contact.",
        ),
        Text(
            "一级梯形图从左母线上的一个触点开始。",
            "A rung begins with a contact at the left rail.",
        ),
        lesson=11,
    ),
    Rule(
        "LAD011",
        "ends-without-an-output",
        "info",
        Text(
            "这个网络以“{word}”结尾，编程软件不会把它显示为梯形图。它的结果要送到哪个输出？",
            "This network ends with {word}, so the editor does not show it as a ladder. Which output should get the result?",
        ),
        Text(
            "一级梯形图以线圈或功能框结束。",
            "A rung ends with a coil or a box.",
        ),
        lesson=11,
    ),
    Rule(
        "LAD012",
        "edge-leads-nowhere",
        "warning",
        Text(
            "“{word}”每次执行都改写它的记忆位，却没有通到任何输出，所以梯形图里没有它。它后面要接哪个输出？",
            "{word} writes its bit each time it is executed, but it leads to no output, so no rung shows it. Which output should "
            "follow it?",
        ),
        Text(
            "梯形图里只有通到线圈或功能框的部分。",
            "A ladder shows only what leads to a coil or a box.",
        ),
        lesson=3,
    ),
    Rule(
        "LAD013",
        "edge-with-one-bit-drawn-twice",
        "warning",
        Text(
            "“{word}”把上次的能流存在自己的位里，所以在梯形图里只能画一次，而且要画在它执行的地方；这里却要画两次，或者要画得更晚。先把它的结果存到一个存储器位里，行吗？",
            "{word} keeps its last flow in a bit of its own, so a ladder can hold it once only, and where it is executed; here it "
            "would be drawn twice, or later. Can its result be kept in a memory bit first?",
        ),
        Text(
            "沿指令每执行一次就改写一次它的位；执行两次，第二次就看不到沿了。",
            "Each time the edge is executed it writes its bit; the second time there is no edge left to see.",
        ),
        lesson=3,
    ),
    Rule(
        "LAD014",
        "contact-leads-nowhere",
        "info",
        Text(
            "“{word}”没有通到任何输出，所以梯形图里没有这个触点。它后面少了一条块连接指令，还是少了一个输出？",
            "{word} leads to no output, so the ladder does not show its contact. Is a join missing behind it, or an output?",
        ),
        Text(
            "梯形图里只有通到线圈或功能框的部分；没有连接起来的电路块留在堆栈里，谁也不用它。",
            "A ladder shows only what leads to a coil or a box; a block that nothing joins is left on the stack, and nobody uses it.",
        ),
        (3, 5),
        lesson=11,
    ),
    # SYM: symbol tables
    Rule(
        "SYM001",
        "symbol-without-address",
        "error",
        Text(
            "符号“{name}”后面没有地址。它代表哪个地址？",
            "The symbol {name} has no address behind it. Which one does it stand for?",
        ),
        Text(
            "符号表的一行是：符号、地址、注释，用制表符分开。",
            "A row of a symbol table is a name, an address and a comment, with tabs between them.",
        ),
    ),
    Rule(
        "SYM002",
        "address-without-symbol",
        "error",
        Text(
            "这一行只有“{address}”，没有符号名。想给它起什么名字？",
            "This row says {address} but gives no name. What should it be called?",
        ),
        Text(
            "符号是给人看的名字，PLC只认识地址。", "A symbol is a name for people; the PLC itself knows addresses only."
        ),
    ),
    Rule(
        "SYM003",
        "symbol-twice",
        "error",
        Text(
            "符号“{name}”在第{row}行已经代表{first}，这里又写成{second}；按前一个读。哪一个对？",
            "{name} stands for {first} since row {row}, and here for {second}; the first one counts. Which of them is right?",
        ),
        Text(
            "一个符号只能代表一个地址，否则程序里写它时不知道指哪一个。",
            "A name stands for one address; otherwise nobody knows which one a program means by it.",
        ),
    ),
    Rule(
        "SYM004",
        "address-named-twice",
        "warning",
        Text(
            "{address}已经叫“{other}”，这里又叫“{name}”。是同一个信号吗？",
            "{address} is called {other} already, and here {name}. Is it the same signal?",
        ),
        Text(
            "两个名字指同一位时，读程序的人会以为是两个信号。",
            "Where two names mean one bit, a reader takes them for two signals.",
        ),
    ),
    Rule(
        "SYM005",
        "symbol-address-unread",
        "error",
        Text(
            "符号“{name}”后面的“{address}”读不成地址。这里应写I0.0或X0这样的地址，是不是两列写反了？",
            "{address} behind the symbol {name} does not read as an address such as I0.0 or X0. Have two columns changed places?",
        ),
        Text(
            "地址里总有编号；没有编号的词，PLC找不到它。",
            "An address has a number in it; a word without one leads to no place in the PLC.",
        ),
    ),
    # TIM: timelines of inputs
    Rule(
        "TIM001",
        "row-unread",
        "error",
        Text(
            "“{word}”前面没有地址和冒号。一行应像 {example} 这样写：哪个输入，各持续多久？",
            "There is no address and colon before {word}. A row reads {example}: which input is it, and for how long is it what?",
        ),
        Text(
            "时间表的一行是一个输入：地址、冒号，然后是一段一段的状态。",
            "A row of a timeline is one input: its address, a colon, and its phases one after the other.",
        ),
    ),
    Rule(
        "TIM002",
        "address-unknown",
        "error",
        Text(
            "“{word}”不是{family}的地址。这一行说的是哪个输入？",
            "{word} is no address of {family}. Which input is this row about?",
        ),
        Text(
            "时间表按地址驱动输入；这个机型没有的地址，什么也驱动不了。",
            "A timeline drives inputs by their addresses; one that the family lacks drives nothing.",
        ),
    ),
    Rule(
        "TIM003",
        "phase-unread",
        "error",
        Text(
            "“{word}”读不成一段。一段是时间加状态，如 0.2s on；时间的单位是ms、s、min。这里想写什么？",
            "{word} does not read as a phase. One is a length and a state, such as 0.2s on, in ms, s or min. What is meant here?",
        ),
        Text(
            "先写多久，再写是通是断：1s off, 0.2s on, off。",
            "First for how long, then on or off: 1s off, 0.2s on, off.",
        ),
    ),
    Rule(
        "TIM004",
        "length-missing",
        "error",
        Text(
            "“{word}”不是{address}的最后一段，要写明持续多久。多长时间？",
            "{word} is not the last phase of {address}, so it needs a length. How long is it?",
        ),
        Text(
            "只有最后一段可以不写时间，它一直保持到结束。",
            "Only the last phase may go without a length: it lasts to the end.",
        ),
    ),
    Rule(
        "TIM005",
        "state-unsuited",
        "error",
        Text(
            "{address}{what}，不能是{word}。这里应写什么？",
            "{address} {what}, so it cannot be {word}. What should it be?",
        ),
        Text("位只有通和断两种状态，字才能装下数。", "A bit is on or off and nothing else; numbers want a word."),
    ),
    Rule(
        "TIM006",
        "repetition-unread",
        "error",
        Text(
            "这里的括号或重复次数读不懂（{word}）。重复要写成 3 x (0.5s on, 0.5s off)，几次，哪几段？",
            "The parentheses or the count do not add up here ({word}). A repetition is 3 x (0.5s on, 0.5s off): how often, and which phases?",
        ),
        Text(
            "括号成对，前面写次数，里面每一段都要有时间。",
            "Parentheses come in pairs with a count before them, and every phase within has a length.",
        ),
    ),
    Rule(
        "TIM007",
        "timeline-too-long",
        "error",
        Text(
            "这张时间表太长（{size}），plcteach最多算{most}。能短一些，或把扫描时间加大吗？",
            "The timeline is too long ({size}); plcteach goes up to {most}. Can it be shorter, or the scans longer?",
        ),
        Text(
            "时间是虚拟的，但每个扫描都要真正算一遍。",
            "Time is virtual here, but each scan is really worked out.",
        ),
    ),
    Rule(
        "TIM008",
        "input-twice",
        "error",
        Text(
            "{address}在第{row}行已经有一行；只按那一行走。要把两行接成一行吗？",
            "{address} has a row already, in row {row}, and only that one counts. Should the two become one?",
        ),
        Text(
            "一个输入在同一时刻只有一个状态。",
            "At any moment an input has one state.",
        ),
    ),
    Rule(
        "TIM009",
        "phase-unseen",
        "warning",
        Text(
            "{address}的这一段（{word}）落在两次扫描之间，程序看不到它。要长过一个扫描（{scan} ms）吗？",
            "This phase of {address} ({word}) falls between two scans, and the program never sees it. Should it last longer than one scan ({scan} ms)?",
        ),
        Text(
            "输入只在每个扫描开始时读一次；比扫描周期短的脉冲可能被漏掉。",
            "Inputs are read once, at the start of each scan; a pulse shorter than a scan may be missed.",
        ),
    ),
    Rule(
        "TIM010",
        "length-unsuited",
        "error",
        Text(
            "“{word}”的时间不是整毫秒，或者是0。这一段持续几毫秒？",
            "The length in {word} is no whole number of milliseconds, or it is 0. How many milliseconds is it?",
        ),
        Text(
            "这里的时间以毫秒为单位，最短1 ms。",
            "Time is counted in milliseconds here, and the shortest is 1 ms.",
        ),
    ),
    # XML: reading a ladder from a PLCopen XML file
    Rule(
        "XML001",
        "markup-unread",
        "error",
        Text(
            "文件从这一行起不再是完整的XML（{reason}）。能从编辑器里重新导出一次吗？",
            "From this row on the file is no complete XML ({reason}). Can the editor export it once more?",
        ),
        Text(
            "XML文件少一个括号、一个结尾标记，后面的内容就无从读起；多半是保存或传送时断了。",
            "With one bracket or closing tag missing, the rest of an XML file cannot be read; most often it was cut off while it was saved or sent.",
        ),
    ),
    Rule(
        "XML002",
        "markup-too-large",
        "error",
        Text(
            "文件里超过{most}{what}。一次练习用不到这么多；能只导出这一个程序吗？",
            "The file has more than {most} {what}. No lesson needs so many; can this one program be exported alone?",
        ),
        Text(
            "读文件有上限，这样一个坏文件不会让所有人等待。",
            "Reading has its limits, so that one bad file does not keep everybody waiting.",
        ),
    ),
    Rule(
        "XML003",
        "markup-of-its-own",
        "error",
        Text(
            "文件在这里声明了自己的文档类型或实体，这里不读。梯形图用不着它；能导出一份不带它的文件吗？",
            "Here the file declares a document type or entities of its own, and those are not read. A ladder needs none; can it be exported without?",
        ),
        Text(
            "实体可以把几行字展开成几十亿行，也可以去取别的文件，所以一律不读；PLCopen文件里从来没有它。",
            "Entities can unfold a few rows into billions, or fetch other files, so none is read; a PLCopen file never has any.",
        ),
    ),
    Rule(
        "XML004",
        "no-ladder-in-file",
        "error",
        Text(
            "文件里没有可读的梯形图（LD）：{found}。要读的程序是用梯形图画的吗？",
            "There is no ladder (LD) in this file to be read: {found}. Is the program drawn as a ladder?",
        ),
        Text(
            "PLCopen XML里可以有梯形图、功能块图、顺序功能图和文本；这里只读梯形图。",
            "PLCopen XML may hold ladders, function block diagrams, sequential charts and text; only ladders are read here.",
        ),
    ),
    Rule(
        "XML005",
        "program-not-in-file",
        "error",
        Text(
            "文件里没有名为“{name}”的程序，有的是：{names}。要读哪一个？",
            "There is no program {name} in this file, but there is: {names}. Which one is meant?",
        ),
        Text(
            "一个PLCopen文件可以装几个程序（POU）；按名字取其中一个。",
            "A PLCopen file can hold several programs (POUs); one of them is taken by its name.",
        ),
    ),
    Rule(
        "XML006",
        "object-unread",
        "error",
        Text(
            "{what}（localId {id}）在这里读不成梯形图里的元件。能用触点、线圈或TON、TOF、TP、CTU、CTD、CTUD改画吗？",
            "{what} (localId {id}) is read as no part of a ladder here. Can it be drawn with contacts, coils, or TON, TOF, TP, CTU, CTD, CTUD?",
        ),
        Text(
            "读的是触点、线圈、电源母线、定时器、计数器、NOT和沿检测；跳转、运算块和别的语言的图形不读。",
            "What is read: contacts, coils, power rails, timers, counters, NOT and edge detection; jumps, arithmetic blocks and the signs of other languages are not.",
        ),
    ),
    Rule(
        "XML007",
        "nothing-at-reference",
        "error",
        Text(
            "{what}（localId {id}）的连线通向localId {target}，而图里没有它。那个元件是被删掉了吗？",
            "The wire of {what} (localId {id}) leads to localId {target}, and nothing in the drawing has that number. Was it deleted?",
        ),
        Text(
            "连线写成“左边是几号元件”；号码没有主人，就不知道能流从哪里来。",
            "A wire is kept as the number of what is on its left; without an owner of the number nobody knows where the flow comes from.",
        ),
    ),
    Rule(
        "XML008",
        "number-unsuited",
        "error",
        Text(
            "localId {id}在这里不能用：它不是数，或者第{row}行已经用过。每个元件一个自己的号码，能改过来吗？",
            "localId {id} does not do here: it is no number, or row {row} has it already. Can each part have a number of its own?",
        ),
        Text(
            "连线按号码找元件；两个元件同号，连线就有两种读法。",
            "Wires find their parts by number; with two of one number a wire could be read in two ways.",
        ),
    ),
    Rule(
        "XML009",
        "end-open",
        "error",
        Text(
            "{what}（localId {id}）{side}没有接上。它应当接到哪里？",
            "{what} (localId {id}) is not connected {side}. Where should it lead?",
        ),
        Text(
            "能流从左母线经触点到线圈；中间断开的一段没有作用，多半是忘了连线。",
            "Power flows from the left rail through contacts to a coil; a piece that is cut off does nothing, and most often a wire was forgotten.",
        ),
    ),
    Rule(
        "XML010",
        "flow-in-a-circle",
        "error",
        Text(
            "{what}（localId {id}）的连线转了一圈又回到自己。要自锁的话，改用它所写的位的触点好吗？",
            "The wires of {what} (localId {id}) lead in a circle back to it. For a seal-in, could a contact of the bit that is written stand there?",
        ),
        Text(
            "梯形图里能流只从左向右；自锁靠的是再读一次输出位，不是把线接回来。",
            "In a ladder power flows from left to right only; a seal-in reads the output bit again, and no wire leads back.",
        ),
    ),
    Rule(
        "XML011",
        "bridge-in-file",
        "error",
        Text(
            "{what}（localId {id}）处的支路交叉成桥，拆不成串联和并联。把共用的触点再画一遍，让每条支路自成一路，好吗？",
            "At {what} (localId {id}) the paths cross as a bridge, which is neither series nor parallel. Could the contact that they share be drawn twice, so that each path is complete?",
        ),
        Text(
            "指令表只有串联、并联和分支点；桥要先化成几条各自完整的支路。",
            "An instruction list has series, parallel and branch points only; a bridge has to become paths that are complete each by itself.",
        ),
    ),
    Rule(
        "XML012",
        "marks-together",
        "error",
        Text(
            "{what}（localId {id}）同时有这些标记：{marks}。想要的是其中哪一个？",
            "{what} (localId {id}) has these marks at once: {marks}. Which of them is meant?",
        ),
        Text(
            "一个触点是常开、常闭、上升沿或下降沿之一；一个线圈是输出、取反、置位、复位或沿之一。",
            "A contact is one of open, closed, rising and falling; a coil is one of plain, inverted, set, reset and pulse.",
        ),
    ),
    Rule(
        "XML013",
        "no-bit-in-file",
        "error",
        Text(
            "{what}（localId {id}）的“{word}”不是一个位。它是哪个变量，或者哪个地址（如%IX0.0）？",
            "{word}, at {what} (localId {id}), is no bit. Which variable is it, or which address, such as %IX0.0?",
        ),
        Text(
            "触点和线圈各是一个位：变量名，或%IX、%QX、%MX地址；表达式和字不行。",
            "A contact or coil is one bit: the name of a variable, or an address %IX, %QX, %MX; no expression and no word.",
        ),
    ),
    Rule(
        "XML014",
        "box-incomplete",
        "error",
        Text(
            "{what}（localId {id}）缺少{missing}。应当是多少，或者接什么？",
            "{what} (localId {id}) lacks {missing}. What should it be, or what should lead there?",
        ),
        Text(
            "定时器要有名字、IN和时间PT（如T#5s），计数器要有名字、计数输入和预设值PV。",
            "A timer has a name, IN and a time PT such as T#5s; a counter has a name, a counting input and a preset PV.",
        ),
    ),
    Rule(
        "XML015",
        "box-not-last",
        "error",
        Text(
            "{what}（localId {id}）有几个输入，而同一个分支点上还有画得比它低的输出。能把它画到最下面吗？",
            "{what} (localId {id}) has several inputs, and its node has outputs that are drawn below it. Can it be drawn lowest?",
        ),
        Text(
            "几个输入的方框执行后，它们的值还占着栈；所以它是这一级的最后一个输出。",
            "The inputs of such a box stay on the stack when it has acted, so it is the last output of its rung.",
        ),
    ),
    Rule(
        "XML016",
        "names-without-address",
        "info",
        Text(
            "这些变量没有地址：{names}。写成某个系列的程序时，它们各占一个空闲的存储器位。给它们定个地址好吗？",
            "These variables have no address: {names}. Where a family's list is written, each takes a free memory bit. Which address should it have?",
        ),
        Text(
            "PLCopen的变量可以先不定地址；指令表里的触点和线圈都要有。",
            "A variable of PLCopen may wait for its address; each contact and coil of an instruction list has one.",
        ),
    ),
    Rule(
        "XML017",
        "left-out",
        "info",
        Text(
            "文件里还有这些，这里没有读：{what}。",
            "The file also holds this, which was not read here: {what}.",
        ),
        Text(
            "读的是一个程序的一张梯形图，从上到下执行；其余的不影响它的画法，但可能影响它怎样运行。",
            "What is read is one ladder of one program, executed from top to bottom; the rest does not change its drawing, but may change how it runs.",
        ),
    ),
    Rule(
        "XML018",
        "flow-always-there",
        "error",
        Text(
            "{what}（localId {id}）{side}直接接着左母线，旁边的触点不起作用。这根线是多画的吗？",
            "{what} (localId {id}) hangs right on the left rail {side}, so no contact matters there. Is that wire one too many?",
        ),
        Text(
            "与触点并联的一根导线永远接通。",
            "A wire in parallel with a contact is always closed.",
        ),
    ),
    # FIL: files that are no text
    Rule(
        "FIL001",
        "file-unread",
        "error",
        Text(
            "这个文件打不开（{reason}）。它还在那里，可以读吗？",
            "The file could not be opened ({reason}). Is it still there, and may it be read?",
        ),
        Text(
            "打不开的文件没有检查过，所以算一个错误。",
            "A file that was not read was not looked at, so it counts as an error.",
        ),
    ),
    Rule(
        "FIL002",
        "file-not-text",
        "error",
        Text(
            "这个文件不是纯文本的指令表，{what}。能把指令表本身导出或另存为文本文件（.txt、.awl）吗？",
            "This file is no list in plain text; {what}. Can the list itself be exported or saved as a text file (.txt, .awl)?",
        ),
        Text(
            "plcteach读的是导出的文本：.awl、指令表、CSV。",
            "What plcteach reads is exported text: .awl, an instruction list, CSV.",
        ),
    ),
    Rule(
        "FIL003",
        "ladder-not-written-out",
        "error",
        Text(
            "这个文件里的梯形图写不成{family}的{list}：{reason}能换一种画法吗？",
            "The ladder in this file cannot be written as {list} of {family}: {reason} Can it be drawn in another way?",
        ),
        Text(
            "不是每一张梯形图都能写成指令；各家能写的也不一样。",
            "Not every ladder can be written as instructions, and each family's can do something else.",
        ),
    ),
    Rule(
        "HND001",
        "file-packed",
        "error",
        Text(
            "这是一个压缩文件（{kind}）。先解压，再批改里面的程序，好吗？",
            "This is an archive ({kind}). Unpack it first, and grade the program in it?",
        ),
        Text(
            "plcteach不解压文件：里面有什么，应当由人先看一眼。",
            "plcteach unpacks nothing: what is inside should be seen by a person first.",
        ),
    ),
    Rule(
        "HND002",
        "nothing-handed-in",
        "error",
        Text(
            "这个文件夹里没有文件。程序交上来了吗？",
            "There is no file in this folder. Was the program handed in?",
        ),
        Text(
            "没有交程序的人也留在名单里，得0分，这样名单是完整的。",
            "Who handed in nothing stays in the list with 0 marks, so that the list is complete.",
        ),
    ),
    Rule(
        "HND003",
        "judging-stopped",
        "error",
        Text(
            "这份程序没能批改完（{reason}）。请老师亲自看一看。",
            "This program could not be judged to the end ({reason}). Please look at it yourself.",
        ),
        Text(
            "一份批改不完的程序不能拖住全班，所以到时间就停下来，并且说明。",
            "One program must not keep a class waiting, so it is stopped after a while, and this says so.",
        ),
    ),
    # KND: answers to the kinds of exercises
    Rule(
        "KND001",
        "given-line-missing",
        "error",
        Text(
            "题目给出的“{line}”不在这里，或者顺序变了。只填____的地方，其余的行保留，好吗？",
            "The line {line} was given, and it is missing here or stands elsewhere. Can the given lines stay, and only ____ be filled?",
        ),
        Text(
            "填空题给出的行就是线索：缺的那几行必须和它们配合。",
            "The lines that are given are the clue: the missing ones have to go with them.",
        ),
    ),
    Rule(
        "KND002",
        "line-not-offered",
        "error",
        Text(
            "“{line}”不在给出的行里。能只用给出的行排出来吗？",
            "{line} is not among the lines that are offered. Can it be done with those alone?",
        ),
        Text(
            "排序题只练一件事：先后次序。指令都已经写好了。",
            "Putting lines in order is about one thing, the order; the instructions are there already.",
        ),
    ),
    Rule(
        "KND003",
        "line-too-often",
        "error",
        Text(
            "“{line}”只给出{times}，这里用得更多。哪一处多余？",
            "{line} is offered {times}, and here it is used more often. Which one is too many?",
        ),
        Text(
            "每一行给出几次，就最多用几次；不属于程序的行可以不用。",
            "Each line may be used as often as it is offered; lines that do not belong may be left over.",
        ),
    ),
    Rule(
        "KND004",
        "rows-counted",
        "warning",
        Text(
            "这里填了{got}行，而程序有{wanted}条指令：一条指令一行。",
            "There are {got} rows, and the list has {wanted} instructions: one row each.",
        ),
        Text(
            "每执行一条指令，堆栈就变成新的样子，所以每条指令都有一行。",
            "After each instruction the stack is a new one, so each has a row of its own.",
        ),
    ),
    Rule(
        "KND005",
        "value-unread",
        "warning",
        Text(
            "“{word}”读不成这里的值。请写0、1、x，空的写 . ，好吗？",
            "{word} does not read as a value. Could it be 0, 1 or x, or . for an empty place?",
        ),
        Text(
            "一位只有0和1；x表示谁也不知道它是几。",
            "A bit is 0 or 1; an x says that nobody knows which.",
        ),
    ),
    Rule(
        "KND006",
        "blocks-unread",
        "error",
        Text(
            "这里应写两段指令的行号，例如 1-2 3-4。哪两段？",
            "Two stretches of instruction numbers are expected, such as 1-2 3-4. Which two?",
        ),
        Text(
            "连接指令总是连接两个电路块，每一块是一段连续的指令。",
            "A join always connects two blocks, and each of them is a stretch of instructions.",
        ),
    ),
    Rule(
        "KND007",
        "choice-unread",
        "error",
        Text(
            "这里应写一个字母，从A到{last}。选哪一个？",
            "A letter from A to {last} is expected. Which one is it?",
        ),
        Text(
            "只有一个梯形图和这个程序作用相同。",
            "Only one of the ladders does what the list does.",
        ),
    ),
    Rule(
        "KND008",
        "track-unread",
        "warning",
        Text(
            "这一行应以要填的地址开头：{wanted}。这里是哪一个？",
            "A row begins with the address that is asked for: {wanted}. Which one is this?",
        ),
        Text(
            "时序图里一个地址一行。",
            "A timing chart has one row for each address.",
        ),
    ),
    Rule(
        "KND009",
        "signs-counted",
        "warning",
        Text(
            "{address}有{got}个值，而一共有{wanted}个扫描：一个扫描一个值。",
            "{address} has {got} values, and there are {wanted} scans: one value each.",
        ),
        Text(
            "输出在每个扫描结束时写出一次，所以每个扫描有一个值。",
            "Outputs are written once, at the end of each scan; so each scan has one value.",
        ),
    ),
    Rule(
        "KND010",
        "answer-too-long",
        "error",
        Text(
            "这个答案太长（{size}个字符），读到{most}个为止。是不是贴错了内容？",
            "The answer is too long ({size} characters; {most} are read). Was something else pasted here?",
        ),
        Text(
            "这一类题的答案只有几行。",
            "An answer of this kind has a few short rows.",
        ),
    ),
    Rule(
        "KND011",
        "nothing-answered",
        "error",
        Text("还没有填。从第一行开始吧？", "Nothing is filled in yet. What comes first?"),
        Text("空着的答案没有什么可以判断。", "There is nothing to judge in an empty answer."),
    ),
    Rule(
        "KND012",
        "gaps-overfilled",
        "error",
        Text(
            "空处一共填进了{got}行，而这里最多填{most}行。给出的行能做哪一部分工作？",
            "{got} lines are filled in, and there is room for {most} at the most. Which part of the work do the given lines do?",
        ),
        Text(
            "填空是补上缺的几行，不是在给出的行旁边另写一个程序。",
            "A gap is for the few lines that are missing, not for another program beside the one that is given.",
        ),
    ),
)

RULES: dict[str, Rule] = {row.code: row for row in _ROWS}
