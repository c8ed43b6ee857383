"""The usual wrong ideas about instruction lists, numbered: what a learner thinks, what is so, and a program that tells them apart.

Diagnostics, exercises and reports name them by their numbers. The programs are one instruction after another, parted by `; `,
networks by ` | `; each is written as the family writes it in which the idea is usually met.
"""

from __future__ import annotations

from dataclasses import dataclass

from plcteach.core.errors import UnknownNameError
from plcteach.core.text import Text


@dataclass(frozen=True, slots=True)
class Misconception:
    """One wrong idea. title: a name for it, for a table.  lesson: the number of the lesson that sets it right."""

    number: int
    title: Text
    thinks: Text
    fact: Text
    program: str
    lesson: int

    def __repr__(self) -> str:
        return f"Misconception({self.number} {self.title.en})"


def misconception(number: int) -> Misconception:
    """Give a wrong idea by its number; UnknownNameError if there is none with it."""
    try:
        return MISCONCEPTIONS[number]
    except KeyError:
        kind = "misconception"
        raise UnknownNameError(kind, str(number), map(str, MISCONCEPTIONS)) from None


_ROWS = (
    Misconception(
        1,
        Text("以为“与”比“或”先算", "“And” before “or”"),
        Text("A比O先算，所以第二条支路不用LD。", "A binds tighter than O, so the second branch needs no LD."),
        Text(
            "指令表从上到下算，没有优先级：O之后的A把前面的全部结果都串联进去。",
            "A list is worked out from top to bottom without precedence: an A behind an O takes all that came before.",
        ),
        "LD I0.0; A I0.1; O I0.2; A I0.3; = Q0.0", 0,
    ),
    Misconception(
        2,
        Text("以为连接指令连接最前面的两块", "A join takes the first two blocks"),
        Text("连接指令连接最先写的两块，或者上面所有的块。", "A join takes the two blocks written first, or everything above it."),
        Text(
            "它只连接栈顶的两个值，也就是离它最近的两块已经连接好的电路。",
            "It takes the two values on top: the two nearest finished blocks above it.",
        ),
        "LD I0.0; A I0.1; LD I0.2; A I0.3; LD I0.4; OLD; ALD; = Q0.0", 7,
    ),
    Misconception(
        3,
        Text("以为LD是“再接一个触点”", "LD means “and the next contact”"),
        Text("梯级中间的LD把触点串联在后面。", "An LD in the middle of a rung puts its contact in series with what stands there."),
        Text(
            "LD开始新的一块，把前面的结果压到下一层；没有连接指令，那个结果就没有人用。",
            "LD begins a new block and pushes the result so far one level down; without a join nobody uses it.",
        ),
        "LD I0.0; LD I0.1; = Q0.0", 1,
    ),
    Misconception(
        4,
        Text("以为n块要n条连接指令", "n blocks need n joins"),
        Text("每一块都要有一条自己的连接指令。", "Every block wants a join of its own."),
        Text(
            "每条连接指令把两块变成一块，所以n块只要n－1条；多一条就会去拿堆栈里没有的值。",
            "Each join makes one block of two, so n blocks need n − 1; one more takes a value that nobody put there.",
        ),
        "LD I0.0; LD I0.1; OLD; OLD; = Q0.0", 7,
    ),
    Misconception(
        5,
        Text("以为最后一条连接指令连接所有的块", "One join at the end joins all"),
        Text("最后写一条OLD，就把上面所有的块都并联起来。", "One OLD at the end puts all blocks above it in parallel."),
        Text("一条连接指令只连接两块；三块要两条。", "A join takes two blocks and no more; three blocks need two joins."),
        "LD I0.0; A I0.1; LD I0.2; A I0.3; LD I0.4; A I0.5; OLD; = Q0.0", 7,
    ),
    Misconception(
        6,
        Text("把ALD和OLD弄反", "ALD and OLD mixed up"),
        Text("块里面是并联，所以用OLD连接。", "The blocks are parallel inside, so OLD joins them."),
        Text(
            "要看的是块与块怎样连接，而不是块里面：并联块的串联用ALD（ANB）。",
            "What counts is how the blocks are connected to each other, not what is inside: in series it is ALD (ANB).",
        ),
        "LD I0.0; O I0.1; LD I0.2; O I0.3; OLD; = Q0.0", 7,
    ),
    Misconception(
        7,
        Text("单个触点也写成块", "A block for a single contact"),
        Text("并联或串联一个触点，也要LD加连接指令。", "A single contact too needs an LD and a join."),
        Text("结果是对的，但一条O（OR）或A（AND）就够了。", "The result is right, but one O (OR) or A (AND) does it."),
        "LD X0; LD X1; ORB; OUT Y0", 7,
    ),
    Misconception(
        8,
        Text("以为输出会把值用掉，或自动回到分支点", "An output uses the value up"),
        Text("输出之后就回到了分支点，下一个触点从那里接起。", "Behind an output one is back at the branch point, and the next contact starts there."),
        Text(
            "输出指令不改变栈顶：下一个触点接着刚才的结果，要回到分支点就得先保存它。",
            "An output leaves the top as it is: the next contact goes on from there, and a branch point must have been saved.",
        ),
        "LD I0.0; A I0.1; = Q0.0; A I0.2; = Q0.1", 8,
    ),
    Misconception(
        9,
        Text("每条支路都用出栈", "A pop for every branch"),
        Text("每条支路都用LPP（MPP）回到分支点。", "Each branch goes back to the branch point with an LPP (MPP)."),
        Text(
            "出栈会取走分支点：只有最后一条支路用它，中间的用读栈。",
            "A pop takes the branch point away: the last branch pops, those in the middle read.",
        ),
        "LD X0; MPS; AND X1; OUT Y0; MPP; AND X2; OUT Y1; MPP; AND X3; OUT Y2", 8,
    ),
    Misconception(
        10,
        Text("最后一条支路用读栈", "A read for the last branch"),
        Text("最后一条支路用LRD（MRD）和用LPP（MPP）一样。", "For the last branch LRD (MRD) is as good as LPP (MPP)."),
        Text(
            "读栈只看一眼，分支点还留在那里；外层再取值时，取到的就是它。",
            "A read only looks, and the branch point stays; an outer branch that fetches later gets the wrong one.",
        ),
        "LD I0.0; LPS; A I0.1; LPS; A I0.2; = Q0.0; LRD; A I0.3; = Q0.1; LPP; A I0.4; = Q0.2", 8,
    ),
    Misconception(
        11,
        Text("以为读栈会再压入一份", "A read pushes a copy"),
        Text("LRD把分支点再压入一份，原来的栈顶还在下面。", "LRD pushes the branch point once more and keeps the top below it."),
        Text("读栈用分支点的值覆盖栈顶，原来的栈顶就没有了。", "A read overwrites the top with the branch point's value; what was there is gone."),
        "LD I0.0; LPS; A I0.1; LRD; A I0.2; OLD; = Q0.0", 8,
    ),
    Misconception(
        12,
        Text("以为LDS从1数起", "LDS counts from 1"),
        Text("LDS 3复制第3层。", "LDS 3 copies level 3."),
        Text("LDS从0数起：LDS 0是栈顶，LDS 2才是第3层。", "LDS counts from 0: LDS 0 is the top, and LDS 2 is level 3."),
        "LD I0.0; LD I0.1; LD I0.2; LDS 3; = Q0.0", 1,
    ),
    Misconception(
        13,
        Text("以为堆栈要多深有多深", "The stack has no bottom"),
        Text("块可以先全部写完，最后再一起连接，多少块都行。", "Any number of blocks can be written first and joined at the end."),
        Text(
            "层数是固定的，再压入一个，最下面的值就丢了；边写边连就不会。",
            "The levels are counted, and one more push drops the lowest value; joining as you go avoids that.",
        ),
        "; ".join([*(f"LD I{number // 8}.{number % 8}" for number in range(10)), *["OLD"] * 9, "= Q0.0"]), 7,
    ),
    Misconception(
        14,
        Text("以为9层堆栈能嵌套9个LPS", "Nine levels take nine branch points"),
        Text("堆栈有9层，所以可以嵌套9个LPS。", "Nine levels hold nine nested branch points."),
        Text("栈顶那一层是当前的结果，留给分支点的只有8层。", "The top level is the working value, so eight are left for branch points."),
        "; ".join(["LD I0.0", *(f"LPS; A I1.{bit}" for bit in range(8)), "LPS; A I2.0; = Q0.0", *["LPP; = Q0.1"] * 9]), 8,
    ),
    Misconception(
        15,
        Text("以为堆栈里存的是触点，或能跨网络记住", "The stack stores contacts, or remembers"),
        Text("堆栈存着触点或指令，到下一个网络、下一个扫描还在。", "The stack keeps contacts or commands, and still has them in the next network or scan."),
        Text(
            "每一层只是一个位，是刚算出来的结果；每个网络要自己从LD开始。",
            "Each level is one bit, a result just worked out; every network begins with an LD of its own.",
        ),
        "Network 1; LD I0.0; = Q0.0 | Network 2; A I0.1; = Q0.1", 2,
    ),
    Misconception(
        16,
        Text("以为FX的第1层放着最新的块", "Level 1 of the FX is the newest block"),
        Text("FX堆栈的第1层放着刚写的那一块。", "Level 1 of the FX stack holds the block written last."),
        Text(
            "最新的值在运算结果寄存器里，第1层在它下面：FX的第k层相当于S7-200的第k+1层。",
            "The newest value is in the result register, and level 1 lies below it: FX level k is S7-200 level k + 1.",
        ),
        "LD X0; OR X2; LD X1; AND X4; LD X3; AND X5; ORB; ANB; OUT Y0", 12,
    ),
    Misconception(
        17,
        Text("以为NOT只取反前一个触点", "NOT inverts the last contact"),
        Text("NOT取反它前面的那个触点。", "NOT inverts the contact in front of it."),
        Text("NOT取反栈顶，也就是到这里为止的全部结果。", "NOT inverts the top of the stack: the whole result so far."),
        "LD I0.0; A I0.1; NOT; = Q0.0", 0,
    ),
    Misconception(
        18,
        Text("以为沿只属于前一个触点", "An edge belongs to the last contact"),
        Text("串联一个沿触点，和取整个结果的沿是一回事。", "A contact at an edge and the edge of the whole result are the same."),
        Text(
            "沿触点看的是那个位自己的变化，脉冲指令看的是到这里为止的结果的变化。",
            "A contact at an edge watches its own bit; a pulse instruction watches the result up to there.",
        ),
        "LD X0; ANDP X1; OUT M0", 3,
    ),
    Misconception(
        19,
        Text("以为分支就是把主干抄一遍", "A branch is a copy of its stem"),
        Text("有分支的梯级，和把主干抄进两个梯级是一样的。", "A rung with a branch is the same as two rungs that repeat its stem."),
        Text(
            "分支点的值只算一次；抄一遍就会再读一次，前面的输出可能已经改变了主干里的位。",
            "A branch point is worked out once; a copy reads its bits again, and an output in between may have changed one.",
        ),
        "LD I0.0; AN Q0.0; LPS; = Q0.0; LPP; A I0.1; = Q0.1", 8,
    ),
    Misconception(
        20,
        Text("以为双线圈就是“或”", "Two coils are an OR"),
        Text("同一个线圈写两次，哪个条件成立都接通。", "With two coils of one bit either condition switches it on."),
        Text("两次都写了，最后一次才算数。", "Both are written, and the last one counts."),
        "LD I0.0; = Q0.0; LD I0.1; = Q0.0", 3,
    ),
    Misconception(
        21,
        Text("以为置位复位与先后无关", "Set and reset: the first wins, or neither"),
        Text("置位和复位同时有效时，先写的算数，或者先后没有关系。", "Where set and reset are both asked for, the first wins, or the order does not matter."),
        Text("两条都执行，后执行的说了算：复位写在后面就是复位优先。", "Both are executed, and the later one has its way: with R last, reset dominates."),
        "LD I0.0; S Q0.0, 1; LD I0.1; R Q0.0, 1", 3,
    ),
    Misconception(
        22,
        Text("以为什么定时器都能自己复位自己", "Any timer may reset itself"),
        Text("用自己的常闭触点复位的定时器，总会给出一个脉冲。", "A timer with its own closed contact before it always gives a pulse."),
        Text(
            "10 ms的定时器在扫描开始时置位，马上又被自己的指令清掉，别的行看不到；用一个M位就可靠了。",
            "A 10 ms timer comes on at the start of a scan and its own line clears it at once, so no line sees it; a memory bit makes it safe.",
        ),
        "LDN T33; TON T33, 30; LD T33; = Q0.0", 4,
    ),
    Misconception(
        23,
        Text("常闭按钮配常闭触点", "A closed button wants a closed contact"),
        Text("停止按钮是常闭的，程序里也要写常闭触点。", "The stop button is normally closed, so the program needs a normally closed contact."),
        Text(
            "常闭按钮不按时输入就是1，所以程序里写常开触点；写成常闭，电动机根本启动不了。",
            "A normally closed button at rest gives a 1, so the contact is normally open; with a closed one the motor never starts.",
        ),
        "LD I0.0; O Q0.0; AN I0.1; = Q0.0", 0,
    ),
    Misconception(
        24,
        Text("以为LDI到处都一样", "LDI is the same everywhere"),
        Text("LDI在哪里都是取反装载。", "LDI loads the inverse, whatever the family."),
        Text("FX的LDI是取反；S7-200的LDI是立即读输入，不取反，取反要写LDN。", "On the FX it does; on the S7-200 LDI reads the input at once and as it is, and the inverse is LDN."),
        "LDI I0.0; = Q0.0", 12,
    ),
    Misconception(
        25,
        Text("以为GUTTA的LPS压入数据栈", "LPS pushes on GUTTA's data stack"),
        Text("LPS之后数据栈上多了一个值，可以和它连接。", "Behind LPS the data stack holds one value more, which a join may take."),
        Text("GUTTA的LPS存到辅助栈上，数据栈不变，连接指令就少一个值。", "GUTTA's LPS saves on the auxiliary stack and leaves the data stack alone, so a join lacks a value."),
        "LD I0.0; LPS; ALD; = Q0.0", 10,
    ),
    Misconception(
        26,
        Text("把LPS当作主控，管到后面的网络", "LPS is a master control"),
        Text("LPS管着后面的网络，到LPP为止。", "LPS rules the networks that follow, up to the LPP."),
        Text("入栈和它的出栈在同一个网络里；主控是另外的指令（FX的MC/MCR）。", "A push and its pop stand in one network; a master control is another instruction (MC/MCR of the FX)."),
        "Network 1; LD I0.0; LPS; = Q0.0 | Network 2; LPP; A I0.1; = Q0.1", 8,
    ),
    Misconception(
        27,
        Text("以为第二个操作数可以就是结果", "IN2 may be OUT"),
        Text("ADD_I 1000,MW4,MW4给MW4加1000。", "ADD_I 1000,MW4,MW4 adds 1000 to MW4."),
        Text(
            "这个框拆成先传送、再相加两条：MW4先变成1000，再加上自己，得2000。",
            "The box becomes a move and an addition: MW4 first turns into 1000 and then has itself added, which gives 2000.",
        ),
        "LD I0.0; ADD_I 1000, MW4, MW4", 10,
    ),
    Misconception(
        28,
        Text("以为移位寄存器自己会有1", "A shift register fills itself"),
        Text("移位寄存器一移位，灯就一个个亮起来。", "As soon as it is shifted, its lamps come on one after the other."),
        Text("移进来的是0；第一个1要由程序写进去。", "What is shifted in is 0; the first 1 must be written by the program."),
        "LD %I0.0; CU %SBR0; LD %SBR0.3; ST %Q0.0", 6,
    ),
    Misconception(
        29,
        Text("以为数上升沿就有n次完整的闪烁", "Counting rises gives n full flashes"),
        Text("数灯的上升沿，数到20就正好闪完20次。", "Counting the lamp's rising edges to 20 gives 20 full flashes."),
        Text(
            "第20次刚亮，计数就到了，灯只亮一个扫描；要数下降沿，才是20次完整的闪烁。",
            "The count is full as the 20th flash begins, and the lamp goes out after one scan; count its falls for 20 full ones.",
        ),
        "LD %I0.1; OR %C3.D; R %C3; LD %Q0.0; CU %C3", 5,
    ),
)  # fmt: skip

MISCONCEPTIONS: dict[int, Misconception] = {row.number: row for row in _ROWS}
