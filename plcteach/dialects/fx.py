"""Mitsubishi FX: a result register above one stack of eleven cells, each tagged as a block (L) or a branch point (B).

Sources: 000_8c35a2fe1b5d9b9b.txt (figures 1 to 5), the FX programming manual as tutorials give it.
Eight blocks (seven cells and the register) and eleven branch points at most: the manual's limits, stricter than the seed's
eleven shared cells, and the same for every circuit that a ladder can draw within them.
"""

from __future__ import annotations

from plcteach.core.area import Area, kind
from plcteach.core.spec import Dialect, Limit, Sample, Stack, insn
from plcteach.core.text import Text
from plcteach.core.verb import END, coil, reset, set_

INSTRUCTIONS = (
    # contacts
    insn("LD", "bit", "a -- a.L bit", fresh="a? -- bit", zh="取（常开触点）", en="load a normally open contact"),
    insn(
        "LDI",
        "bit",
        "a -- a.L !bit",
        fresh="a? -- !bit",
        zh="取反（常闭触点）",
        en="load inverse: a normally closed contact",
    ),
    insn("LDP", "bit", "a -- a.L rise(bit)", fresh="a? -- rise(bit)", zh="取上升沿", en="load a rising edge"),
    insn("LDF", "bit", "a -- a.L fall(bit)", fresh="a? -- fall(bit)", zh="取下降沿", en="load a falling edge"),
    insn("AND", "bit", "a -- a&bit", zh="与（串联常开触点）", en="normally open contact in series"),
    insn("ANI", "bit", "a -- a&!bit", zh="与反（串联常闭触点）", en="normally closed contact in series"),
    insn("ANDP", "bit", "a -- a&rise(bit)", zh="与上升沿", en="rising edge in series"),
    insn("ANDF", "bit", "a -- a&fall(bit)", zh="与下降沿", en="falling edge in series"),
    insn("OR", "bit", "a -- a|bit", zh="或（并联常开触点）", en="normally open contact in parallel"),
    insn("ORI", "bit", "a -- a|!bit", zh="或反（并联常闭触点）", en="normally closed contact in parallel"),
    insn("ORP", "bit", "a -- a|rise(bit)", zh="或上升沿", en="rising edge in parallel"),
    insn("ORF", "bit", "a -- a|fall(bit)", zh="或下降沿", en="falling edge in parallel"),
    insn("INV", "", "a -- !a", zh="取反（运算结果）", en="invert the result so far"),
    insn("MEP", "", "a -- rise(a)", zh="运算结果上升沿（FX3）", en="rising edge of the result so far (FX3)"),
    insn("MEF", "", "a -- fall(a)", zh="运算结果下降沿（FX3）", en="falling edge of the result so far (FX3)"),
    # the stack
    insn("ANB", "", "a.L b -- a&b", zh="电路块串联（块与）", en="blocks in series"),
    insn("ORB", "", "a.L b -- a|b", zh="电路块并联（块或）", en="blocks in parallel"),
    insn("MPS", "", "a -- a.B a", zh="进栈", en="push: save the branch point"),
    insn("MRD", "", "a.B b -- a.B a", zh="读栈", en="read: look at the branch point"),
    insn("MPP", "", "a.B b -- a", zh="出栈", en="pop: fetch the branch point and remove it"),
    # coils
    insn("OUT", "out", "a -- a", then=coil("a"), zh="线圈输出", en="output coil"),
    insn("SET", "out", "a -- a", then=set_("a"), zh="置位", en="set"),
    insn("RST", "out:clear", "a -- a", then=reset("a"), zh="复位", en="reset"),
    insn("PLS", "out:pulse", "a -- a", then=coil("rise(a)"), zh="上升沿脉冲输出", en="one scan on at the rising edge"),
    insn("PLF", "out:pulse", "a -- a", then=coil("fall(a)"), zh="下降沿脉冲输出", en="one scan on at the falling edge"),
    insn("NOP", "", "--", zh="空操作", en="no operation"),
    insn("END", "", "--", then=END, zh="程序结束", en="end of the program"),
)

FX = Dialect(
    name="fx",
    title=Text("三菱FX", "Mitsubishi FX"),
    list=Text("指令表", "instruction list"),
    unit=Text("独立电路", "circuit"),
    stacks=(Stack("", Text("堆栈", "stack"), depth=12, register=Text("运算结果寄存器", "result register")),),
    areas=(
        Area("X", (("0", "377"),), Text("输入X", "inputs X"), base=8, role="input"),
        Area("Y", (("0", "377"),), Text("输出Y", "outputs Y"), base=8, role="output"),
        Area("M", (("0", "7679"), ("8000", "8511")), Text("辅助继电器M", "auxiliary relays M")),
        Area("S", (("0", "4095"),), Text("状态继电器S", "state relays S")),
        Area("T", (("0", "511"),), Text("定时器T", "timers T")),
        Area("C", (("0", "255"),), Text("计数器C", "counters C")),
    ),
    kinds={
        "bit": kind("X Y M S T C", zh="软元件，如X0", en="a device such as X0"),
        "out": kind("Y M S", zh="Y、M或S，如Y0", en="Y, M or S, such as Y0"),
        "clear": kind("Y M S T C", zh="Y、M、S、T或C", en="Y, M, S, T or C"),
        "pulse": kind("Y M", zh="Y或M", en="Y or M"),
    },
    insns=INSTRUCTIONS,
    roles={
        "load": "LD", "load_not": "LDI", "series": "AND", "series_not": "ANI", "parallel": "OR", "parallel_not": "ORI",
        "join_series": "ANB", "join_parallel": "ORB", "push": "MPS", "read": "MRD", "pop": "MPP",
        "invert": "INV", "coil": "OUT", "set": "SET", "reset": "RST", "rise": "MEP", "fall": "MEF", "end": "END",
    },
    networks_by_title=False,  # a GX list has no headings: a new circuit begins at an LD once every value is used
    limits=(
        Limit("L", 7, Text("个电路块（连同结果寄存器共8块）", "blocks beside the one in the result register")),
        Limit("B", 11, Text("个分支点", "branch points")),
    ),
    recognised=frozenset(
        "MC MCR STL RET MOV MOVP DMOV CMP DCMP ZCP ADD DADD SUB DSUB MUL DIV INC INCP DEC DECP SFTL SFTLP SFTR ZRST BMOV FMOV "
        "XCH BCD BIN WAND WOR WXOR NEG ROR ROL DECO ENCO MEAN ANS ANR SQR FLT REF HSCS PLSY PWM IST ALT ALTP RAMP CJ CALL "
        "SRET IRET EI DI FEND WDT FOR NEXT ZRSTP TO FROM LD= LD> LD< LD<> LD>= LD<= AND= AND> AND< AND<> OR= OR> OR<".split()
    ) | frozenset({"OUT T", "OUT C"}),
    specials={"M8000": "on", "M8001": "off", "M8002": "first", "M8003": "later"},
    note_octal=Text("X和Y按八进制编号，X7之后是X10，没有8和9。", "X and Y count in octal: X10 follows X7, and there is no 8 or 9."),
    examples=(
        "LD X0; OR Y0; ANI X1; OUT Y0; END",
        "LD X0; OR X2; LD X1; AND X4; LD X3; AND X5; ORB; ANB; OUT Y0",
        "LD X0; OR X5; MPS; AND X1; OUT Y0; MRD; AND X2; OUT Y1; MPP; AND X3; OUT Y2",
        "LDI X0; ORI X1; INV; OUT Y0; NOP",
        "LDP X0; ANDP X1; ORP X2; SET Y0; LDF X3; ANDF X4; ORF X5; RST Y0",
        "LD X0; PLS M0; LD X1; PLF M1; LD M0; OR M1; OUT Y0",
        "LD X0; AND X1; MEP; OUT Y0; LD X0; AND X1; MEF; OUT Y1",
    ),
    samples=(
        Sample("COI001", "LD X0; OUT Y0; LD X1; OUT Y0", "LD X0; OR X1; OUT Y0"),
        Sample("STK001", "LD X0; AND X1; ANB; OUT Y0", "LD X0; AND X1; OUT Y0"),
        Sample("STK003", "LD X0; AND X1; MPS; LD X2; AND X3; MRD; ORB; ANB; OUT Y0", "LD X0; AND X1; LD X2; AND X3; ORB; OUT Y0"),
        Sample("STK004", "LD X0; LD X1; MPS; ORB; OUT Y0; MPP; OUT Y1", "LD X0; MPS; AND X1; OUT Y0; MPP; OUT Y1"),
        Sample("STK005", "LD X0; LD X1; OUT Y0", "LD X0; AND X1; OUT Y0"),
        Sample(
            "STK006",
            "LD X0; MPS; AND X1; OUT Y0; MRD; AND X2; OUT Y1; MRD; AND X3; OUT Y2",
            "LD X0; MPS; AND X1; OUT Y0; MRD; AND X2; OUT Y1; MPP; AND X3; OUT Y2",
        ),
        Sample("STK007", "LD X0; LD X1; ORB; OUT Y0", "LD X0; OR X1; OUT Y0"),
        Sample("STK008", "LD X0; LD X1; ANB; OUT Y0", "LD X0; AND X1; OUT Y0"),
        Sample("STK010", "LD X0; MPS; AND X1; MRD; AND X2; OUT Y0; MPP; OUT Y1", "LD X0; MPS; AND X1; OUT Y2; MRD; AND X2; OUT Y0; MPP; OUT Y1"),
        Sample(
            "STK011",
            "LD X0; AND X20; LD X1; AND X21; LD X2; AND X22; LD X3; AND X23; LD X4; AND X24; LD X5; AND X25; LD X6; AND X26; "
            "LD X7; AND X27; LD X10; AND X30; ORB; ORB; ORB; ORB; ORB; ORB; ORB; ORB; OUT Y0",
            "LD X0; AND X20; LD X1; AND X21; ORB; LD X2; AND X22; ORB; LD X3; AND X23; ORB; OUT Y0",
        ),
        Sample("RDR001", "LD X0; ORR X1; OUT Y0", "LD X0; ORI X1; OUT Y0"),
        Sample("RDR006", "LD X8; OUT Y0", "LD X10; OUT Y0"),
        Sample("RDR007", "LD X0; OUT X1", "LD X0; OUT Y1"),
    ),
)  # fmt: skip
