"""Siemens S7-200: one logic stack of nine bits, no pointer and no trap (the SMART: 32).

Sources: 000_8c35a2fe1b5d9b9b.txt (figures 6 and 7), 002_0e43569a3a430994.txt (section 2.2, figure 2-35), the system manual.
"""

from __future__ import annotations

from dataclasses import replace

from plcteach.core.area import Area, blocks, kind, words
from plcteach.core.block import Bank, Block
from plcteach.core.insn import RELATIONS, compares, insn
from plcteach.core.spec import Dialect, Sample, Stack
from plcteach.core.text import Text
from plcteach.core.verb import END, coil, drive, go, reset, set_, shift, work

_BYTES = {"B": 8, "W": 16, "D": 32}
_IN_BYTES = "I Q M SM V S L AC"
_WHOLE = (("B", "byte", "字节", "byte"), ("W", "word", "字", "word"), ("D", "dword", "双字", "double word"))
_REAL = ("R", "real", "实数", "real")
_SUMS = (
    ("+", "add", "加", "add"),
    ("-", "sub", "减", "subtract"),
    ("*", "mul", "乘", "multiply"),
    ("/", "div", "除", "divide"),
)

INSTRUCTIONS = (
    # contacts
    insn("LD", "bit", "-- bit", zh="装载（常开触点）", en="load a normally open contact"),
    insn("LDN", "bit", "-- !bit", zh="取反后装载（常闭触点）", en="load a normally closed contact"),
    insn("A", "bit", "a -- a&bit", zh="与（串联常开触点）", en="and: normally open contact in series"),
    insn("AN", "bit", "a -- a&!bit", zh="与非（串联常闭触点）", en="and not: normally closed contact in series"),
    insn("O", "bit", "a -- a|bit", zh="或（并联常开触点）", en="or: normally open contact in parallel"),
    insn("ON", "bit", "a -- a|!bit", zh="或非（并联常闭触点）", en="or not: normally closed contact in parallel"),
    insn("LDI", "now", "-- now", zh="立即装载（不是取反）", en="load immediately from the input (no inversion)"),
    insn("LDNI", "now", "-- !now", zh="取反后立即装载", en="load inverted, immediately from the input"),
    insn("AI", "now", "a -- a&now", zh="立即与", en="and, read immediately from the input"),
    insn("ANI", "now", "a -- a&!now", zh="立即与非", en="and not, read immediately from the input"),
    insn("OI", "now", "a -- a|now", zh="立即或", en="or, read immediately from the input"),
    insn("ONI", "now", "a -- a|!now", zh="立即或非", en="or not, read immediately from the input"),
    insn("NOT", "", "a -- !a", zh="取反", en="invert the result so far"),
    insn("EU", "", "a -- rise(a)", zh="上升沿（正跳变）", en="edge up: on for one scan when the result rises"),
    insn("ED", "", "a -- fall(a)", zh="下降沿（负跳变）", en="edge down: on for one scan when the result falls"),
    # coils
    insn("=", "out", "a -- a", then=coil("a"), zh="线圈输出", en="output coil"),
    insn(
        "=I", "direct", "a -- a", then=coil("a", "direct"), zh="立即输出", en="output coil, immediately to the terminal"
    ),
    insn("S", "out N:1..255", "a -- a", then=set_("a", "N"), zh="置位N个位", en="set N bits"),
    insn("R", "out N:1..255", "a -- a", then=reset("a", "N"), zh="复位N个位", en="reset N bits"),
    insn("SI", "out:direct N:1..128", "a -- a", then=set_("a", "N"), zh="立即置位N个位", en="set N bits immediately"),
    insn(
        "RI", "out:direct N:1..128", "a -- a", then=reset("a", "N"), zh="立即复位N个位", en="reset N bits immediately"
    ),
    # the stack
    insn("ALD", "", "S0 S1 -- S2=S0&S1", zh="电路块串联（块与）", en="blocks in series"),
    insn("OLD", "", "S0 S1 -- S2=S0|S1", zh="电路块并联（块或）", en="blocks in parallel"),
    insn("LPS", "", "a -- a a", zh="逻辑入栈", en="logic push: save the branch point"),
    insn("LRD", "", "a b -- a a", zh="逻辑读栈", en="logic read: look at the branch point"),
    insn("LPP", "", "a b -- a", zh="逻辑出栈", en="logic pop: fetch the branch point and remove it"),
    insn(
        "LDS",
        "n:0..8",
        "-- [n]",
        zh="装载堆栈（复制从0数起的第n个值）",
        en="load stack: copy the value n places below the top",
    ),
    insn("AENO", "", "a -- a&ENO", zh="与ENO（上一个功能框是否正常）", en="and ENO: did the last box go well"),
    insn("NOP", "n:0..255", "--", zh="空操作", en="no operation"),
    # timers and counters: their inputs stand on the stack and stay there
    insn("TON", "T:ton PT:preset", "IN -- IN", then=drive("on", "T", "IN=IN", "PT"), zh="接通延时定时器", en="on-delay timer"),
    insn("TONR", "T:tonr PT:preset", "IN -- IN", then=drive("retentive", "T", "IN=IN", "PT"), zh="有记忆接通延时定时器", en="retentive on-delay timer"),
    insn("TOF", "T:ton PT:preset", "IN -- IN", then=drive("off", "T", "IN=IN", "PT"), zh="断开延时定时器", en="off-delay timer"),
    insn("CTU", "C:counter PV:preset", "CU R -- CU R", then=drive("up", "C", "CU=CU R=R", "PV"), zh="增计数器", en="up counter"),
    insn("CTD", "C:counter PV:preset", "CD LD -- CD LD", then=drive("down", "C", "CD=CD LD=LD", "PV"), zh="减计数器", en="down counter"),
    insn(
        "CTUD", "C:counter PV:word", "CU CD R -- CU CD R", then=drive("updown", "C", "CU=CU CD=CD R=R", "PV"),
        zh="增减计数器", en="up-down counter",
    ),
    # two words compared read as a contact
    *compares(
        {"LD": "-- cmp", "A": "a -- a&cmp", "O": "a -- a|cmp"}, {"B": "byte", "W": "word", "D": "dword", "R": "real"},
        zh="比较触点", en="comparing contact",
    ),
    # words; what they do to the flags stands with their rules
    insn("SHRB", "DATA:bit S_BIT:out N:-64..64", "a -- a", then=shift("row", "DATA N", "S_BIT"), zh="移位寄存器", en="shift register bit"),
    *(
        insn(f"MOV{letter}", f"IN:{size} OUT:{size}_out", "a -- a", then=work("move", "IN", "OUT"), zh=f"{zh}传送", en=f"move {en}")
        for letter, size, zh, en in (*_WHOLE, _REAL)
    ),
    *(
        insn(f"{sign}I", "IN:word OUT:word_out", "a -- a", then=work(op, "OUT IN", "OUT"), zh=f"整数{zh}", en=f"{en} integer")
        for sign, op, zh, en in _SUMS
    ),
    *(
        insn(f"{sign}D", "IN:dword OUT:dword_out", "a -- a", then=work(op, "OUT IN", "OUT"), zh=f"双整数{zh}", en=f"{en} double integer")
        for sign, op, zh, en in _SUMS
    ),
    *(
        insn(f"{sign}R", "IN:real OUT:real_out", "a -- a", then=work(f"r{op}", "OUT IN", "OUT"), zh=f"实数{zh}", en=f"{en} real")
        for sign, op, zh, en in _SUMS
    ),
    insn("MUL", "IN:word OUT:dword_out", "a -- a", then=work("mul16", "OUT IN", "OUT"), zh="整数相乘得双整数", en="multiply two integers into a double integer"),
    insn("DIV", "IN:word OUT:dword_out", "a -- a", then=work("divmod", "OUT IN", "OUT"), zh="整数相除得商和余数", en="divide two integers into remainder and quotient"),
    insn("SQRT", "IN:real OUT:real_out", "a -- a", then=work("rsqrt", "IN", "OUT"), zh="实数平方根", en="square root of a real"),
    *(
        insn(f"{word}{letter}", f"OUT:{size}_out", "a -- a", then=work(op, "OUT", "OUT"), zh=f"{zh}{does}", en=f"{verb} {en}")
        for word, op, does, verb in (("INC", "inc", "加一", "increment"), ("DEC", "dec", "减一", "decrement"), ("INV", "not", "按位取反", "invert the bits of a"))
        for letter, size, zh, en in _WHOLE
    ),
    *(
        insn(f"{word}{letter}", f"IN:{size} OUT:{size}_out", "a -- a", then=work(op, "OUT IN", "OUT"), zh=f"{zh}按位{does}", en=f"{word.lower()} {en}s bit by bit")
        for word, op, does in (("AND", "and", "与"), ("OR", "or", "或"), ("XOR", "xor", "异或"))
        for letter, size, zh, en in _WHOLE
    ),
    *(
        insn(f"{word}{letter}", f"OUT:{size}_out N:byte", "a -- a", then=work(f"{op}{bits}", "OUT N", "OUT"), zh=f"{zh}{does}", en=f"{verb} {en}")
        for word, op, does, verb in (
            ("SL", "shl", "左移", "shift left a"), ("SR", "shr", "右移", "shift right a"),
            ("RL", "rol", "循环左移", "rotate left a"), ("RR", "ror", "循环右移", "rotate right a"),
        )
        for (letter, size, zh, en), bits in zip(_WHOLE, (8, 16, 32), strict=True)
    ),
    insn("BTI", "IN:byte OUT:word_out", "a -- a", then=work("move", "IN", "OUT"), zh="字节转整数", en="byte to integer"),
    insn("ITB", "IN:word OUT:byte_out", "a -- a", then=work("fit", "IN", "OUT"), zh="整数转字节", en="integer to byte"),
    insn("ITD", "IN:word OUT:dword_out", "a -- a", then=work("move", "IN", "OUT"), zh="整数转双整数", en="integer to double integer"),
    insn("DTI", "IN:dword OUT:word_out", "a -- a", then=work("fit", "IN", "OUT"), zh="双整数转整数", en="double integer to integer"),
    insn("DTR", "IN:dword OUT:real_out", "a -- a", then=work("to_real", "IN", "OUT"), zh="双整数转实数", en="double integer to real"),
    insn("ROUND", "IN:real OUT:dword_out", "a -- a", then=work("round", "IN", "OUT"), zh="实数四舍五入成双整数", en="round a real to a double integer"),
    insn("TRUNC", "IN:real OUT:dword_out", "a -- a", then=work("trunc", "IN", "OUT"), zh="实数去掉小数成双整数", en="cut a real off to a double integer"),
    # where the program goes on
    insn("JMP", "n:0..255", "a -- a", then=go("jump", "a", "n"), zh="跳转", en="jump to a label"),
    insn("LBL", "n:0..255", "--", then=go("label", "", "n"), zh="标号", en="label"),
    insn("FOR", "INDX:word_out INIT:word FINAL:word", "a -- a", then=go("loop", "a", "INDX", "INIT FINAL"), zh="循环开始", en="begin a loop"),
    insn("NEXT", "", "--", then=go("next"), zh="循环结束", en="end of the loop"),
    insn("CALL", "n:SBR0..127", "a -- a", then=go("call", "a", "n"), zh="调用子程序", en="call a subroutine"),
    insn("CRET", "", "a -- a", then=go("return", "a"), zh="有条件返回", en="return from the subroutine where powered"),
    insn("RET", "", "--", then=go("return"), zh="返回", en="return from the subroutine"),
    insn("END", "", "a -- a", then=go("end", "a"), zh="有条件结束", en="end the scan where powered"),
    insn("MEND", "", "--", then=END, zh="主程序结束", en="end of the main program"),
    insn("STOP", "", "a -- a", then=go("stop", "a"), zh="停止（CPU转入STOP）", en="go to STOP where powered"),
    # sequence control
    insn("LSCR", "bit:scr", "-- bit", then=go("segment", "bit", "bit"), zh="顺序控制段开始", en="begin a sequence control segment"),
    insn("SCRT", "out:scr", "a -- a", then=(set_("a"), go("transfer", "a", "out")), zh="顺序控制段转移", en="transfer to another segment"),
    insn("SCRE", "", "--", then=go("rail"), zh="顺序控制段结束", en="end of the segment"),
    insn("CSCRE", "", "a -- a", then=go("rail", "a"), zh="有条件结束顺序控制段", en="end the segment where powered"),
)  # fmt: skip

S7_200 = Dialect(
    name="s7-200",
    title=Text("西门子S7-200", "Siemens S7-200"),
    list=Text("语句表（STL）", "statement list (STL)"),
    unit=Text("网络", "network"),
    stacks=(Stack("", Text("逻辑堆栈", "logic stack"), depth=9, fixed=True),),
    areas=(
        Area("I", (("0.0", "15.7"),), Text("输入映像", "input image"), per=8, words=_BYTES, role="input"),
        Area("Q", (("0.0", "15.7"),), Text("输出映像", "output image"), per=8, words=_BYTES, role="output"),
        Area("M", (("0.0", "31.7"),), Text("位存储器", "bit memory"), per=8, words=_BYTES),
        Area("SM", (("0.0", "549.7"),), Text("特殊存储器位（SM）", "special memory bits"), per=8, words=_BYTES),
        Area("V", (("0.0", "10239.7"),), Text("变量存储器", "variable memory"), per=8, words=_BYTES),
        Area("S", (("0.0", "31.7"),), Text("顺序控制继电器", "sequence control relays"), per=8, words=_BYTES),
        Area("L", (("0.0", "63.7"),), Text("局部存储器", "local memory"), per=8, words=_BYTES),
        Area("T", (("0", "255"),), Text("定时器", "timers"), fields={"V": 16}, value="V"),
        Area("C", (("0", "255"),), Text("计数器", "counters"), fields={"V": 16}, value="V"),
        Area("AC", (("0", "3"),), Text("累加器", "accumulators"), size=32),
        Area("HC", (("0", "5"),), Text("高速计数器", "high-speed counters"), size=32),
        Area("AIW", (("0", "62"),), Text("模拟量输入", "analogue inputs"), role="input", size=16, even=True),
        Area("AQW", (("0", "62"),), Text("模拟量输出", "analogue outputs"), role="output", size=16, even=True),
    ),
    kinds={
        "bit": kind("I Q M SM V S L T C", zh="位地址，如I0.0", en="a bit address such as I0.0"),
        "now": kind("I", zh="输入地址，如I0.0", en="an input such as I0.0"),
        "out": kind("Q M SM V S L T C I", zh="可写的位，如Q0.0", en="a bit that can be written, such as Q0.0"),
        "direct": kind("Q", zh="输出地址，如Q0.0", en="an output such as Q0.0"),
        "scr": kind("S", zh="顺序控制继电器，如S0.1", en="a sequence control relay such as S0.1"),
        "ton": blocks("T", zh="定时器，如T37", en="a timer such as T37"),
        "tonr": blocks("T", zh="定时器，如T5", en="a timer such as T5"),
        "counter": blocks("C", zh="计数器，如C0", en="a counter such as C0"),
        "preset": words(f"{_IN_BYTES} T C AIW", 16, ends=(0, 32767), zh="预设值：0到32767，或一个字，如VW100", en="a preset: 0 to 32767, or a word such as VW100"),
        "byte": words(_IN_BYTES, 8, signed=False, zh="字节或0到255的数，如VB100", en="a byte or a number 0 to 255, such as VB100"),
        "word": words(f"{_IN_BYTES} T C AIW", 16, zh="字或整数，如VW100", en="a word or a whole number, such as VW100"),
        "dword": words(_IN_BYTES, 32, zh="双字或整数，如VD100", en="a double word or a whole number, such as VD100"),
        "real": words(_IN_BYTES, 32, real=True, zh="实数或双字，如3.14、VD100", en="a real number or a double word, such as 3.14 or VD100"),
        "byte_out": words("Q M SM V S L AC", 8, constant=False, signed=False, zh="可写的字节，如VB100", en="a byte that can be written, such as VB100"),
        "word_out": words("Q M SM V S L AC T C AQW", 16, constant=False, zh="可写的字，如VW100", en="a word that can be written, such as VW100"),
        "dword_out": words("Q M SM V S L AC", 32, constant=False, zh="可写的双字，如VD100", en="a double word that can be written, such as VD100"),
        "real_out": words("Q M SM V S L AC", 32, constant=False, real=True, zh="可写的双字，如VD100", en="a double word that can be written, such as VD100"),
    },
    insns=INSTRUCTIONS,
    roles={
        "load": "LD", "load_not": "LDN", "series": "A", "series_not": "AN", "parallel": "O", "parallel_not": "ON",
        "join_series": "ALD", "join_parallel": "OLD", "push": "LPS", "read": "LRD", "pop": "LPP", "copy": "LDS",
        "invert": "NOT", "coil": "=", "set": "S", "reset": "R", "rise": "EU", "fall": "ED",
    },
    traps=False,  # the CPU has no stack trap: x enters at the bottom and the program goes on
    shows_rungs=True,  # Micro/WIN draws a network as one rung or leaves it as a list, without a word about why
    residue="warning",  # LPS / NOT / LDS 1 … rightly leaves a cell, and the CPU does not mind
    aliases={"U": "A", "UN": "AN", "UI": "AI", "UNI": "ANI", "ULD": "ALD"},
    letters={"E": "I", "A": "Q"},
    recognised=frozenset(
        "BMB BMW BMD SWAP BIR BIW ITA DTA RTA ATH HTA ITS DTS RTS STI STD STR SLEN SCPY SSCPY SCAT SFND CFND DECO ENCO SEG BCDI "
        "IBCD SIN COS TAN LN EXP FILL ATT FIFO LIFO FND= FND< FND> FND<> WDR DLED BITIM CITIM ENI DISI ATCH DTCH CRETI RETI CEVNT "
        "XMT RCV NETR NETW GPA SPA HDEF HSC PLS PID TODR TODW TODRX TODWX LDS= AS= OS= LDS<> AS<> OS<>".split()
    ),
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
    patterns={  # two bistables of the ladder that no list has an instruction for: the dominant input is the one with a 1
        "SR": ("S1 R", "NOT; A OUT; OLD; = OUT"),
        "RS": ("S R1", "NOT; LPS; A OUT; = OUT; LPP; ALD; O OUT; = OUT"),
    },
    flags={"zero": "SM1.0", "overflow": "SM1.1", "negative": "SM1.2", "divide": "SM1.3"},
    retentive={"V": ((0, 81919),), "M": ((112, 255),), "T": ((0, 31), (64, 95)), "C": ((0, 255),)},
    counterparts={"input": "I", "output": "Q", "memory": "M", "step": "S", "word": "V", "timer": "T", "counter": "C"},
    specials={
        "SM0.0": "on", "SM0.1": "first", "SM0.2": "cold", "SM0.3": "first", "SM0.4": "60000", "SM0.5": "1000", "SM0.6": "turns",
    },
    examples=(
        "LD I0.0; O Q0.0; AN I0.1; = Q0.0",
        "LD I0.0; A I0.1; LDN I0.2; A I0.3; OLD; = Q0.0",
        "LD I0.0; O I0.1; LD I0.2; ON I0.3; ALD; = Q0.0",
        "LD I0.0; LPS; A I0.1; = Q0.0; LRD; A I0.2; = Q0.1; LPP; AN I0.3; = Q0.2",
        "LD I0.0; EU; S Q0.0, 1; LD I0.1; ED; R Q0.0, 1",
        "LD I0.0; LPS; NOT; LDS 1; A I0.1; OLD; = Q0.0",
        "LDI I0.0; AI I0.1; OI I0.2; =I Q0.0",
        "LDNI I0.0; ANI I0.1; ONI I0.2; SI Q0.0, 1",
        "LD I0.0; NOP 0; RI Q0.0, 1",
        "LD I0.0; TON T37, 10; LD T37; = Q0.0",
        "LD I0.0; TONR T5, 100; LD I0.1; R T5, 1; LD T5; = Q0.0",
        "LD I0.0; TOF T38, 5; LD T38; = Q0.0",
        "LD I0.0; LD I0.1; CTU C0, 3; LD C0; = Q0.0",
        "LD I0.0; LD I0.1; CTD C1, 3; LD C1; = Q0.0",
        "LD I0.0; LD I0.1; LD I0.2; CTUD C2, 3; LD C2; = Q0.0",
        "LD I0.0; EU; SHRB I0.1, V100.0, 4; LD V100.3; = Q0.0",
        "LD I0.0; MOVW VW0, VW2; AENO; +I VW4, VW2; AENO; = Q0.0",
        *(
            f"LD{letter}{sign} {left}, {right}; O{letter}{sign} {right}, {left}; A{letter}{sign} {left}, {other}; = Q0.0"
            for letter, left, right, other in (("B", "VB0", "5", "VB1"), ("W", "VW0", "+100", "VW2"), ("D", "VD0", "+100000", "VD4"), ("R", "VD0", "1.5", "VD4"))
            for sign in RELATIONS
        ),
        *(f"LD I0.0; MOV{letter} {first}, {place}" for letter, first, place in (("B", "5", "VB0"), ("D", "100000", "VD0"), ("R", "1.5", "VD0"))),
        *(
            f"LD I0.0; {sign}{letter} {first}, {place}; AENO; = Q0.0"
            for letter, first, place in (("I", "VW0", "VW2"), ("D", "VD0", "VD4"), ("R", "1.5", "VD4"))
            for sign in "+-*/"
        ),
        "LD I0.0; MUL VW0, VD4",
        "LD I0.0; DIV VW0, VD4",
        "LD I0.0; SQRT VD0, VD4",
        *(f"LD I0.0; EU; {word}{letter} V{letter}0" for word in ("INC", "DEC", "INV") for letter in "BWD"),
        *(f"LD I0.0; {word}{letter} V{letter}0, V{letter}4" for word in ("AND", "OR", "XOR") for letter in "BWD"),
        *(f"LD I0.0; EU; {word}{letter} V{letter}0, 2" for word in ("SL", "SR", "RL", "RR") for letter in "BWD"),
        "LD I0.0; BTI VB0, VW2; ITD VW2, VD4; DTR VD4, VD8",
        "LD I0.0; ROUND VD0, VD4; DTI VD4, VW8; ITB VW8, VB10",
        "LD I0.0; TRUNC VD0, VD4",
        "LD I0.0; JMP 1; LD I0.1; = Q0.0; LBL 1",
        "LD SM0.0; FOR VW0, 1, 5; LD SM0.0; INCW VW2; NEXT",
        "LD I0.0; CALL SBR0; = Q0.0\nSUBROUTINE_BLOCK SBR_0:SBR0\nLD I0.1; = Q0.1\nEND_SUBROUTINE_BLOCK",
        "LD I0.0; CRET; LD I0.1; = Q0.0; RET",
        "LD I0.0; END; LD I0.1; = Q0.0; MEND",
        "LD I0.0; STOP",
        "LSCR S0.1; LD SM0.0; = Q0.0; LD I0.0; SCRT S0.2; LD I0.1; CSCRE; LD I0.2; = Q0.1; SCRE",
    ),
    samples=(
        Sample("COI001", "LD I0.0; = Q0.0; LD I0.1; = Q0.0", "LD I0.0; O I0.1; = Q0.0"),
        Sample("COI009", "= Q0.0", "LD I0.0; = Q0.0"),
        Sample("COI010", "LD I0.0; TON T37, 10; LD I0.1; TON T37, 20; LD T37; = Q0.0", "LD I0.0; TON T37, 10; LD I0.1; TON T38, 20; LD T37; O T38; = Q0.0"),
        Sample("STY001", "LD I0.0; O I0.3; LD I0.1; AN I0.2; ALD; = Q0.0", "LD I0.0; O I0.3; A I0.1; AN I0.2; = Q0.0"),
        Sample("STY001", "LD I0.0; A I0.3; LD I0.1; O I0.2; OLD; = Q0.0", "LD I0.0; A I0.3; O I0.1; O I0.2; = Q0.0"),
        Sample("STY002", "LD I0.0; LPS; = Q0.0; LRD; = Q0.1; LPP; = Q0.2", "LD I0.0; = Q0.0; = Q0.1; = Q0.2"),
        Sample("STK001", "LD I0.0; A I0.1; LD I0.2; A I0.3; OLD; OLD; = Q0.0", "LD I0.0; A I0.1; LD I0.2; A I0.3; OLD; = Q0.0"),
        Sample(
            "STK002",
            "LD I0.0; A I2.0; LD I0.1; A I2.1; LD I0.2; A I2.2; LD I0.3; A I2.3; LD I0.4; A I2.4; LD I0.5; A I2.5; LD I0.6; "
            "A I2.6; LD I0.7; A I2.7; LD I1.0; A I3.0; LD I1.1; A I3.1; OLD; OLD; OLD; OLD; OLD; OLD; OLD; OLD; OLD; = Q0.0",
            "LD I0.0; A I2.0; LD I0.1; A I2.1; OLD; LD I0.2; A I2.2; OLD; LD I0.3; A I2.3; OLD; = Q0.0",
        ),
        Sample("STK003", "LD I0.0; A I0.1; = Q0.0; LPP; A I0.2; = Q0.1", "LD I0.0; LPS; A I0.1; = Q0.0; LPP; A I0.2; = Q0.1"),
        Sample("STK005", "LD I0.0; LD I0.1; = Q0.0", "LD I0.0; A I0.1; = Q0.0"),
        Sample(
            "STK006",
            "LD I0.0; LPS; A I0.1; = Q0.0; LRD; A I0.2; = Q0.1; LRD; A I0.3; = Q0.2",
            "LD I0.0; LPS; A I0.1; = Q0.0; LRD; A I0.2; = Q0.1; LPP; A I0.3; = Q0.2",
        ),
        Sample("STK007", "LD I0.0; LD I0.1; OLD; = Q0.0", "LD I0.0; O I0.1; = Q0.0"),
        Sample("STK008", "LD I0.0; LD I0.1; ALD; = Q0.0", "LD I0.0; A I0.1; = Q0.0"),
        Sample("STK009", "Network 1\nLD I0.0; = Q0.0\nNetwork 2\nA I0.1; = Q0.1", "Network 1\nLD I0.0; = Q0.0\nNetwork 2\nLD I0.1; = Q0.1"),
        Sample("STK014", "LD I0.0; = Q0.0; LD I0.1; CTU C0, 5; LD C0; = Q0.1", "LD I0.0; = Q0.0; LD I0.1; LD I0.2; CTU C0, 5; LD C0; = Q0.1"),
        Sample("STK010", "LD I0.0; LPS; A I0.1; LRD; A I0.2; OLD; = Q0.0", "LD I0.0; LD I0.1; O I0.2; ALD; = Q0.0"),
        Sample("JMP005", "LD SM0.0; FOR VW0, 1, 5; LD SM0.0; INCW VW2", "LD SM0.0; FOR VW0, 1, 5; LD SM0.0; INCW VW2; NEXT"),
        Sample(
            "JMP006",
            "LD SM0.0; " + "; ".join(f"FOR VW{word}, 1, 2; LD SM0.0" for word in range(0, 18, 2)) + "; INCW VW100" + "; NEXT" * 9,
            "LD SM0.0; " + "; ".join(f"FOR VW{word}, 1, 2; LD SM0.0" for word in range(0, 16, 2)) + "; INCW VW100" + "; NEXT" * 8,
        ),
        Sample("TMR001", "LD I0.0; TON T5, 10; LD T5; = Q0.0", "LD I0.0; TONR T5, 10; LD T5; = Q0.0"),
        Sample("TMR003", "LDN T33; TON T33, 30; LD T33; = Q0.0", "LDN M0.0; TON T33, 30; LD T33; = M0.0; = Q0.0"),
        Sample("TMR002", "LD I0.0; TON T37, 10; LD I0.1; TOF T37, 10", "LD I0.0; TON T37, 10; LD I0.1; TOF T38, 10"),
        Sample("RDR001", "LD I0.0; ADN I0.1; = Q0.0", "LD I0.0; AN I0.1; = Q0.0"),
        Sample("RDR002", "LD I0.0; PID VB100, 0", "LD I0.0; = Q0.0"),
        Sample("RDR003", "LD I0.0; A; = Q0.0", "LD I0.0; A I0.1; = Q0.0"),
        Sample("RDR004", "LD I0.0; LPS 1; A I0.1; = Q0.0; LPP; = Q0.1", "LD I0.0; LPS; A I0.1; = Q0.0; LPP; = Q0.1"),
        Sample("RDR005", "LD I00; = Q0.0", "LD I0.0; = Q0.0"),
        Sample("RDR006", "LD I0.8; = Q0.0", "LD I1.0; = Q0.0"),
        Sample("RDR007", "LDI M0.0; = Q0.0", "LDI I0.0; = Q0.0"),
        Sample("RDR008", "LD I0.0; TON T37, 40000", "LD I0.0; TON T37, 30000"),
        Sample("RDR006", "LD I0.0; MOVW AIW1, VW0", "LD I0.0; MOVW AIW2, VW0"),
        Sample("RDR008", "LD I0.0; LDS 9; ALD; = Q0.0", "LD I0.0; LDS 0; A I0.1; OLD; = Q0.0"),
        Sample("RDR009", "LD I0.0\n= Q0.0 (* the lamp", "LD I0.0\n= Q0.0 (* the lamp *)"),
        Sample("RDR012", "LD I0.0; = I0.1", "LD I0.0; = Q0.1"),
        Sample("RDR014", "LD I0.0\x00; = Q0.0", "LD I0.0; = Q0.0"),
    ),
)  # fmt: skip

_DEEP = insn(
    "LDS",
    "n:0..31",
    "-- [n]",
    zh="装载堆栈（复制从0数起的第n个值）",
    en="load stack: copy the value n places below the top",
)

S7_200_SMART = replace(
    S7_200,
    name="s7-200-smart",
    title=Text("西门子S7-200 SMART", "Siemens S7-200 SMART"),
    unit=Text("程序段", "network"),
    stacks=(replace(S7_200.stacks[0], depth=32),),
    insns=tuple(_DEEP if row.mnemonic == "LDS" else row for row in INSTRUCTIONS),
    samples=(),
)
