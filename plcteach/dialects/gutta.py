"""GUTTA: a data stack for series and parallel, an auxiliary stack for branch points; A and O are fusions of LD with a join.

Source: 004_076ff6df1b5a98bb.txt. Depths of 32 and the clearing of both stacks at each network are ours [rec].
"""

from __future__ import annotations

from plcteach.core.area import Area, blocks, kind, words
from plcteach.core.block import Bank, Block
from plcteach.core.insn import RELATIONS, compares, insn
from plcteach.core.spec import Dialect, Sample, Stack
from plcteach.core.text import Text
from plcteach.core.verb import coil, drive, reset, set_, work

_BYTES = {"B": 8, "W": 16, "D": 32}
_IN_BYTES = "I Q M SM V"
_WHOLE = (("B", "byte", "字节", "byte"), ("W", "word", "字", "word"), ("D", "dword", "双字", "double word"))
_SUMS = (
    ("+", "add", "加", "add"),
    ("-", "sub", "减", "subtract"),
    ("*", "mul", "乘", "multiply"),
    ("/", "div", "除", "divide"),
)

INSTRUCTIONS = (
    # input instructions
    insn("LD", "bit", "-- bit", zh="装载（常开开关）", en="load a normally open contact"),
    insn("LDN", "bit", "-- !bit", zh="取反后装载（常闭开关）", en="load a normally closed contact"),
    # fusions: LD b with the join that follows it
    insn(
        "A",
        "bit",
        "a -- a&bit",
        zh="LD与ALD的复合：位为0则清栈顶",
        en="LD and ALD fused: where the bit is 0, clear the top",
    ),
    insn(
        "AN",
        "bit",
        "a -- a&!bit",
        zh="LDN与ALD的复合：位为1则清栈顶",
        en="LDN and ALD fused: where the bit is 1, clear the top",
    ),
    insn(
        "O",
        "bit",
        "a -- a|bit",
        zh="LD与OLD的复合：位为1则置栈顶",
        en="LD and OLD fused: where the bit is 1, set the top",
    ),
    insn(
        "ON",
        "bit",
        "a -- a|!bit",
        zh="LDN与OLD的复合：位为0则置栈顶",
        en="LDN and OLD fused: where the bit is 0, set the top",
    ),
    # the three that act on the flow itself
    insn("NOT", "", "a -- !a", zh="能流取反", en="invert the flow"),
    insn(
        "P",
        "m",
        "a -- a&!m",
        then=coil("a", "m"),
        zh="正跳变（上次的能流存在m）",
        en="rising edge; m keeps the last flow",
    ),
    insn(
        "N",
        "m",
        "a -- !a&m",
        then=coil("a", "m"),
        zh="负跳变（上次的能流存在m）",
        en="falling edge; m keeps the last flow",
    ),
    # system instructions
    insn("ALD", "", "a b -- a&b", zh="串联连接", en="blocks in series"),
    insn("OLD", "", "a b -- a|b", zh="并联连接", en="blocks in parallel"),
    insn("LPS", "", "a -- a ; aux: -- a", zh="逻辑入栈（到辅助栈）", en="push the flow onto the auxiliary stack"),
    insn(
        "LRD", "", "a -- top ; aux: top -- top", zh="逻辑读栈（看辅助栈）", en="read the flow from the auxiliary stack"
    ),
    insn("LPP", "", "a -- top ; aux: top --", zh="逻辑出栈（取自辅助栈）", en="pop the flow from the auxiliary stack"),
    # output instructions
    insn("=", "out", "a -- a", then=coil("a"), zh="线圈输出", en="output coil"),
    insn("S", "out N:1..255", "a -- a", then=set_("a", "N"), zh="置位N个位", en="set N bits"),
    insn("R", "out N:1..255", "a -- a", then=reset("a", "N"), zh="复位N个位", en="reset N bits"),
    insn("TON", "T:ton PT:preset", "IN -- IN", then=drive("on", "T", "IN=IN", "PT"), zh="接通延时定时器", en="on-delay timer"),
    insn("TONR", "T:tonr PT:preset", "IN -- IN", then=drive("retentive", "T", "IN=IN", "PT"), zh="有记忆接通延时定时器", en="retentive on-delay timer"),
    insn("TOF", "T:ton PT:preset", "IN -- IN", then=drive("off", "T", "IN=IN", "PT"), zh="断开延时定时器", en="off-delay timer"),
    *(
        insn(f"MOV{letter}", f"IN:{size} OUT:{size}_out", "a -- a", then=work("move", "IN", "OUT"), zh=f"{zh}传送", en=f"move {en}")
        for letter, size, zh, en in _WHOLE
    ),
    *(
        insn(f"{sign}I", "IN:word OUT:word_out", "a -- a", then=work(op, "OUT IN", "OUT"), zh=f"整数{zh}", en=f"{en} integer")
        for sign, op, zh, en in _SUMS
    ),
    # compound output instructions: they read several flows and pop none
    insn("CTU", "C:counter PV:preset", "CU R -- CU R", then=drive("up", "C", "CU=CU R=R", "PV"), zh="增计数器", en="up counter"),
    insn("CTD", "C:counter PV:preset", "CD LD -- CD LD", then=drive("down", "C", "CD=CD LD=LD", "PV"), zh="减计数器", en="down counter"),
    insn(
        "CTUD", "C:counter PV:preset", "CU CD R -- CU CD R", then=drive("updown", "C", "CU=CU CD=CD R=R", "PV"),
        zh="增减计数器", en="up-down counter",
    ),
    # two words compared read as a bit, so these are inputs, alone or fused with a join
    *compares(
        {"LD": "-- cmp", "A": "a -- a&cmp", "O": "a -- a|cmp"}, {"B": "byte", "W": "word", "D": "dword"},
        zh="比较触点", en="comparing contact",
    ),
)  # fmt: skip

GUTTA = Dialect(
    name="gutta",
    title=Text("GUTTA", "GUTTA"),
    list=Text("指令表", "instruction list"),
    unit=Text("网络", "network"),
    stacks=(
        Stack("", Text("数据栈", "data stack"), depth=32),
        Stack("aux", Text("辅助栈", "auxiliary stack"), depth=32),
    ),
    areas=(
        Area("I", (("0.0", "15.7"),), Text("输入", "inputs"), per=8, words=_BYTES, role="input"),
        Area("Q", (("0.0", "15.7"),), Text("输出", "outputs"), per=8, words=_BYTES, role="output"),
        Area("M", (("0.0", "31.7"),), Text("位存储器", "bit memory"), per=8, words=_BYTES),
        Area("SM", (("0.0", "179.7"),), Text("特殊存储器位", "special memory bits"), per=8, words=_BYTES),
        Area("V", (("0.0", "2047.7"),), Text("变量存储器", "variable memory"), per=8, words=_BYTES),
        Area("T", (("0", "255"),), Text("定时器", "timers"), fields={"V": 16}, value="V"),
        Area("C", (("0", "255"),), Text("计数器", "counters"), fields={"V": 16}, value="V"),
    ),
    kinds={
        "bit": kind("I Q M SM V T C", zh="位地址，如I0.0", en="a bit address such as I0.0"),
        "out": kind("Q M V T C", zh="可写的位，如Q0.0", en="a bit that can be written, such as Q0.0"),
        "m": kind("M V Q", zh="记录上次能流的位，如M0.0", en="a bit that keeps the last flow, such as M0.0"),
        "ton": blocks("T", zh="定时器，如T37", en="a timer such as T37"),
        "tonr": blocks("T", zh="定时器，如T5", en="a timer such as T5"),
        "counter": blocks("C", zh="计数器，如C0", en="a counter such as C0"),
        "preset": words(f"{_IN_BYTES} T C", 16, ends=(0, 32767), zh="预设值：0到32767，或一个字，如MW0", en="a preset: 0 to 32767, or a word such as MW0"),
        "byte": words(_IN_BYTES, 8, signed=False, zh="字节或0到255的数，如MB0", en="a byte or a number 0 to 255, such as MB0"),
        "word": words(f"{_IN_BYTES} T C", 16, zh="字或整数，如MW0", en="a word or a whole number, such as MW0"),
        "dword": words(_IN_BYTES, 32, zh="双字或整数，如MD0", en="a double word or a whole number, such as MD0"),
        "byte_out": words("Q M V", 8, constant=False, signed=False, zh="可写的字节，如MB0", en="a byte that can be written, such as MB0"),
        "word_out": words("Q M V T C", 16, constant=False, zh="可写的字，如MW0", en="a word that can be written, such as MW0"),
        "dword_out": words("Q M V", 32, constant=False, zh="可写的双字，如MD0", en="a double word that can be written, such as MD0"),
    },
    insns=INSTRUCTIONS,
    roles={
        "load": "LD", "load_not": "LDN", "series": "A", "series_not": "AN", "parallel": "O", "parallel_not": "ON",
        "join_series": "ALD", "join_parallel": "OLD", "push": "LPS", "read": "LRD", "pop": "LPP",
        "invert": "NOT", "coil": "=", "set": "S", "reset": "R", "rise": "P", "fall": "N",
    },
    compound_ends=True,  # what a compound output read stays on the data stack, where a further line would misuse it [rec]
    boxes={"ADD_I": ("MOVW", "+I"), "SUB_I": ("MOVW", "-I"), "MUL_I": ("MOVW", "*I"), "DIV_I": ("MOVW", "/I")},
    blocks=(
        Block(
            "T", "timer", Text("定时器", "timer"), ("IN", "PT"), most=32767,
            banks=(
                Bank(0, 0, 1, "always", retains=True), Bank(64, 64, 1, "always", retains=True),
                Bank(1, 4, 10, "scan", retains=True), Bank(65, 68, 10, "scan", retains=True),
                Bank(5, 31, 100, retains=True), Bank(69, 95, 100, retains=True), Bank(32, 32, 1, "always"), Bank(96, 96, 1, "always"),
                Bank(33, 36, 10, "scan"), Bank(97, 100, 10, "scan"), Bank(37, 63, 100), Bank(101, 255, 100),
            ),
        ),
        Block("C", "counter", Text("计数器", "counter"), ("CU", "CD", "R", "LD", "PV"), most=32767),
    ),
    flags={"zero": "SM1.0", "overflow": "SM1.1", "negative": "SM1.2", "divide": "SM1.3"},
    counterparts={"input": "I", "output": "Q", "memory": "M", "word": "V", "timer": "T", "counter": "C"},
    specials={"SM0.0": "on", "SM0.1": "first", "SM0.4": "60000", "SM0.5": "1000", "SM0.6": "turns"},
    examples=(
        "LD I0.0; O Q0.0; AN I0.1; = Q0.0",
        "LD I0.0; A I0.1; LDN I0.2; A I0.3; OLD; = Q0.0",
        "LD I0.0; ON I0.1; LD I0.2; O I0.3; ALD; = Q0.0",
        "LD I0.0; LPS; A I0.1; = Q0.0; LRD; A I0.2; = Q0.1; LPP; A I0.3; = Q0.2",
        "LD I0.0; P M0.0; S Q0.0, 1; LD I0.1; N M0.1; R Q0.0, 1",
        "LD I0.0; LPS; NOT; LD SM0.0; LPP; A I0.1; OLD; = Q0.0",
        "LD I0.0; TON T37, 10; LD T37; = Q0.0",
        "LD I0.0; TONR T5, 100; LD T5; = Q0.0",
        "LD I0.0; TOF T38, 5; LD T38; = Q0.0",
        "LD I0.0; LD I0.1; CTU C0, 3",
        "LD I0.0; LD I0.1; CTD C1, 3",
        "LD I0.0; LD I0.1; LD I0.2; CTUD C2, 3",
        "LD I0.0; MOVW MW0, MW4; +I MW2, MW4",
        "LD I0.0; MOVB 5, MB0; MOVD 100000, MD4",
        *(f"LD I0.0; {sign}I MW0, MW4" for sign in "-*/"),
        *(
            f"LD{letter}{sign} {left}, {right}; O{letter}{sign} {right}, {left}; A{letter}{sign} {left}, {other}; = Q0.0"
            for letter, left, right, other in (("B", "MB0", "5", "MB1"), ("W", "MW0", "100", "MW2"), ("D", "MD0", "100000", "MD4"))
            for sign in RELATIONS
        ),
    ),
    samples=(
        Sample("TMR001", "LD I0.0; TONR T37, 10", "LD I0.0; TON T37, 10"),
        Sample("STK013", "LD I0.0; LD I0.1; CTU C0, 3; LD C0; = Q0.0", "Network 1\nLD I0.0; LD I0.1; CTU C0, 3\nNetwork 2\nLD C0; = Q0.0"),
        Sample("BOX001", "LD I0.0; ADD_I 1000, MW4, MW4", "LD I0.0; ADD_I MW4, 1000, MW4"),
        Sample("COI002", "LD I0.0; P M0.0; = Q0.0; LD I0.1; = M0.0", "LD I0.0; P M0.1; = Q0.0; LD I0.1; = M0.0"),
        Sample("COI001", "LD I0.0; = Q0.0; LD I0.1; = Q0.0", "LD I0.0; O I0.1; = Q0.0"),
        Sample("COI009", "= Q0.0", "LD I0.0; = Q0.0"),
        Sample("COI010", "LD I0.0; TON T37, 10; LD I0.1; TON T37, 20; LD T37; = Q0.0", "LD I0.0; TON T37, 10; LD I0.1; TON T38, 20; LD T37; O T38; = Q0.0"),
        Sample("STY001", "LD I0.0; O I0.3; LD I0.1; AN I0.2; ALD; = Q0.0", "LD I0.0; O I0.3; A I0.1; AN I0.2; = Q0.0"),
        Sample("STY002", "LD I0.0; LPS; = Q0.0; LPP; = Q0.1", "LD I0.0; = Q0.0; = Q0.1"),
        Sample("STK001", "LD I0.0; LPS; ALD; = Q0.0", "LD I0.0; LD I0.1; O I0.2; ALD; = Q0.0"),
        Sample("STK003", "LD I0.0; A I0.1; = Q0.0; LPP; A I0.2; = Q0.1", "LD I0.0; LPS; A I0.1; = Q0.0; LPP; A I0.2; = Q0.1"),
        Sample("STK005", "LD I0.0; LPS; A I0.1; = Q0.0", "LD I0.0; A I0.1; = Q0.0"),
        Sample("STK007", "LD I0.0; LD M0.0; OLD; = Q0.0", "LD I0.0; O M0.0; = Q0.0"),
        Sample("STK008", "LD I0.0; LD M0.0; ALD; = Q0.0", "LD I0.0; A M0.0; = Q0.0"),
    ),
)  # fmt: skip
