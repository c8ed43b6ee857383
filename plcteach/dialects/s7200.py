"""Siemens S7-200: one logic stack of nine bits, no pointer and no trap (the SMART: 32).

Sources: 000_8c35a2fe1b5d9b9b.txt (figures 6 and 7), 002_0e43569a3a430994.txt (section 2.2, figure 2-35), the system manual.
"""

from __future__ import annotations

from dataclasses import replace

from plcteach.core.area import Area, kind
from plcteach.core.spec import Dialect, Sample, Stack, coil, insn, reset, set_
from plcteach.core.text import Text

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
    insn("NOP", "n:0..255", "--", zh="空操作", en="no operation"),
)

S7_200 = Dialect(
    name="s7-200",
    title=Text("西门子S7-200", "Siemens S7-200"),
    list=Text("语句表（STL）", "statement list (STL)"),
    unit=Text("网络", "network"),
    stacks=(Stack("", Text("逻辑堆栈", "logic stack"), depth=9, fixed=True),),
    areas=(
        Area("I", (("0.0", "15.7"),), Text("输入映像", "input image"), per=8, role="input"),
        Area("Q", (("0.0", "15.7"),), Text("输出映像", "output image"), per=8, role="output"),
        Area("M", (("0.0", "31.7"),), Text("位存储器", "bit memory"), per=8),
        Area("SM", (("0.0", "549.7"),), Text("特殊存储器位（SM）", "special memory bits"), per=8),
        Area("V", (("0.0", "10239.7"),), Text("变量存储器", "variable memory"), per=8),
        Area("S", (("0.0", "31.7"),), Text("顺序控制继电器", "sequence control relays"), per=8),
        Area("L", (("0.0", "63.7"),), Text("局部存储器", "local memory"), per=8),
        Area("T", (("0", "255"),), Text("定时器位", "timer bits")),
        Area("C", (("0", "255"),), Text("计数器位", "counter bits")),
    ),
    kinds={
        "bit": kind("I Q M SM V S L T C", zh="位地址，如I0.0", en="a bit address such as I0.0"),
        "now": kind("I", zh="输入地址，如I0.0", en="an input such as I0.0"),
        "out": kind("Q M SM V S L T C I", zh="可写的位，如Q0.0", en="a bit that can be written, such as Q0.0"),
        "direct": kind("Q", zh="输出地址，如Q0.0", en="an output such as Q0.0"),
    },
    insns=INSTRUCTIONS,
    roles={
        "load": "LD", "load_not": "LDN", "series": "A", "series_not": "AN", "parallel": "O", "parallel_not": "ON",
        "join_series": "ALD", "join_parallel": "OLD", "push": "LPS", "read": "LRD", "pop": "LPP",
        "invert": "NOT", "coil": "=", "set": "S", "reset": "R", "rise": "EU", "fall": "ED",
    },
    traps=False,  # the CPU has no stack trap: x enters at the bottom and the program goes on
    residue="warning",  # LPS / NOT / LDS 1 … rightly leaves a cell, and the CPU does not mind
    aliases={"U": "A", "UN": "AN", "UI": "AI", "UNI": "ANI", "ULD": "ALD"},
    letters={"E": "I", "A": "Q"},
    recognised=frozenset(
        "TON TOF TONR CTU CTD CTUD SHRB MOVB MOVW MOVD MOVR BMB BMW BMD SWAP BIR BIW BTI ITB ITD DTI DTR ROUND TRUNC "
        "ITA DTA RTA ATH HTA DECO ENCO SEG BCDI IBCD +I -I *I /I +D -D *D /D +R -R *R /R MUL DIV SQRT SIN COS TAN LN EXP "
        "INCB INCW INCD DECB DECW DECD ANDB ANDW ANDD ORB ORW ORD XORB XORW XORD INVB INVW INVD SLB SLW SLD SRB SRW SRD "
        "RLB RLW RLD RRB RRW RRD FILL ATT FIFO LIFO FND= FND< FND> FND<> JMP LBL FOR NEXT CALL CRET RET END STOP WDR DLED "
        "LSCR SCRT SCRE CSCRE AENO ENI DISI ATCH DTCH CRETI RETI CEVNT XMT RCV NETR NETW GPA SPA HDEF HSC PLS PID TODR "
        "TODW TODRX TODWX LDS= AS= OS= LDS<> AS<> OS<>".split()
    ) | frozenset(f"{op}{size}{rel}" for op in ("LD", "A", "O") for size in "BWDR" for rel in ("=", "<>", ">=", "<=", ">", "<")),
    specials={"SM0.0": "on", "SM0.1": "first"},
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
    ),
    samples=(
        Sample("COI001", "LD I0.0; = Q0.0; LD I0.1; = Q0.0", "LD I0.0; O I0.1; = Q0.0"),
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
        Sample("STK010", "LD I0.0; LPS; A I0.1; LRD; A I0.2; OLD; = Q0.0", "LD I0.0; LD I0.1; O I0.2; ALD; = Q0.0"),
        Sample("RDR001", "LD I0.0; ADN I0.1; = Q0.0", "LD I0.0; AN I0.1; = Q0.0"),
        Sample("RDR002", "LD I0.0; PID VB100, 0", "LD I0.0; = Q0.0"),
        Sample("RDR003", "LD I0.0; A; = Q0.0", "LD I0.0; A I0.1; = Q0.0"),
        Sample("RDR004", "LD I0.0; LPS 1; = Q0.0; LPP; = Q0.1", "LD I0.0; LPS; = Q0.0; LPP; = Q0.1"),
        Sample("RDR005", "LD I00; = Q0.0", "LD I0.0; = Q0.0"),
        Sample("RDR006", "LD I0.8; = Q0.0", "LD I1.0; = Q0.0"),
        Sample("RDR007", "LDI M0.0; = Q0.0", "LDI I0.0; = Q0.0"),
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
