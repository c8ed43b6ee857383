"""Mitsubishi FX: a result register above one stack of eleven cells, each tagged as a block (L) or a branch point (B).

Sources: 000_8c35a2fe1b5d9b9b.txt (figures 1 to 5), the FX programming manual as tutorials give it.
Eight blocks (seven cells and the register) and eleven branch points at most: the manual's limits, stricter than the seed's
eleven shared cells, and the same for every circuit that a ladder can draw within them.
"""

from __future__ import annotations

from plcteach.core.area import Area, blocks, kind, words
from plcteach.core.block import Bank, Block
from plcteach.core.insn import RELATIONS, insn
from plcteach.core.spec import Dialect, Limit, Sample, Stack
from plcteach.core.text import Text
from plcteach.core.verb import END, clear, coil, drive, go, reset, set_, shift, work

_SIZES = (("", "word", "", ""), ("D", "dword", "（32位）", " (32 bits)"))
"""The letter before a mnemonic, the width it works on, and what its title says of that."""

_PULSES = (("", "a", "", ""), ("P", "rise(a)", "（脉冲执行）", " (pulse)"))
"""The letter behind a mnemonic, when it is executed, and what its title says of that."""

_FORMS = tuple((d, size, p, when, dz + pz, de + pe) for d, size, dz, de in _SIZES for p, when, pz, pe in _PULSES)

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
    # timers and counters
    insn("OUT T", "T:timer SV:preset", "a -- a", then=drive("on", "T", "IN=a", "SV"), zh="定时器线圈", en="timer coil"),
    insn("OUT C", "C:counter SV:preset", "a -- a", then=drive("upto", "C", "CU=a", "SV"), zh="计数器线圈", en="counter coil"),
    # what the rail is fed by
    insn("MC", "n:N0..7 out:pulse", "a -- a", then=go("master", "a", "n"), zh="主控", en="master control"),
    insn("MCR", "n:N0..7", "--", then=go("restore", "", "n"), zh="主控复位", en="master control reset"),
    insn("STL", "bit:state", "a? -- bit", then=go("step", "bit", "bit"), zh="步进触点（步的开始）", en="step ladder contact"),
    insn("RET", "", "--", then=go("rail"), zh="步进返回", en="end of the step ladder"),
    # two words compared read as a contact
    *(
        insn(
            f"LD{d}{relation}", f"cmp:{size}{relation}", "a -- a.L cmp", fresh="a? -- cmp",
            zh=f"比较触点{zh}", en=f"load a comparison{en}",
        )
        for d, size, zh, en in _SIZES for relation in RELATIONS
    ),
    *(
        insn(f"{word}{d}{relation}", f"cmp:{size}{relation}", f"a -- a{sign}cmp", zh=f"比较触点{joined_zh}{zh}", en=f"comparison in {joined}{en}")
        for word, sign, joined_zh, joined in (("AND", "&", "串联", "series"), ("OR", "|", "并联", "parallel"))
        for d, size, zh, en in _SIZES for relation in RELATIONS
    ),
    # words
    *(insn(f"{d}MOV{p}", f"S:{size} D:{size}_out", "a -- a", then=work("move", "S", "D", when), zh=f"传送{zh}", en=f"move{en}") for d, size, p, when, zh, en in _FORMS),
    *(
        insn(f"{d}CMP{p}", f"S1:{size} S2:{size} D:out", "a -- a", then=work("compare", "S1 S2", "D", when), zh=f"比较{zh}", en=f"compare{en}")
        for d, size, p, when, zh, en in _FORMS
    ),
    *(
        insn(f"{d}ZCP{p}", f"S1:{size} S2:{size} S:{size} D:out", "a -- a", then=work("compare", "S1 S2 S", "D", when), zh=f"区间比较{zh}", en=f"compare with a zone{en}")
        for d, size, p, when, zh, en in _FORMS
    ),
    *(
        insn(f"{d}{word}{p}", f"S1:{size} S2:{size} D:{size}_out", "a -- a", then=work(op, "S1 S2", "D", when), zh=f"{name}{zh}", en=f"{english}{en}")
        for word, op, name, english in (("ADD", "sum", "加法", "add"), ("SUB", "difference", "减法", "subtract"))
        for d, size, p, when, zh, en in _FORMS
    ),
    *(
        insn(f"{word}{p}", "S1:word S2:word D:dword_out", "a -- a", then=work(op, "S1 S2", "D", when), zh=f"{name}{zh}", en=f"{english}{en}")
        for word, op, name, english in (
            ("MUL", "product", "乘法（积为32位）", "multiply (32-bit product)"),
            ("DIV", "parts", "除法（商在D，余数在D+1）", "divide (quotient, and the remainder after it)"),
        )
        for p, when, zh, en in _PULSES
    ),
    *(
        insn(f"{d}{word}{p}", f"D:{size}_out", "a -- a", then=work(op, "D", "D", when), zh=f"{name}{zh}", en=f"{english}{en}")
        for word, op, name, english in (("INC", "next", "加一", "add one"), ("DEC", "last", "减一", "subtract one"))
        for d, size, p, when, zh, en in _FORMS
    ),
    *(
        insn(
            f"{word}{p}", "S:bit D:out n1:K1..1024 n2:K1..1024", "a -- a", then=shift(op, "S n1 n2", "D", when),
            zh=f"{name}{zh}", en=f"{english}{en}",
        )
        for word, op, name, english in (("SFTL", "left", "位左移", "shift bits up"), ("SFTR", "right", "位右移", "shift bits down"))
        for p, when, zh, en in _PULSES
    ),
    *(
        insn(f"ZRST{p}", "D1:clear D2:clear", "a -- a", then=clear(when, "D1", "D2"), zh=f"区间复位{zh}", en=f"reset a range{en}")
        for p, when, zh, en in _PULSES
    ),
    insn("NOP", "", "--", zh="空操作", en="no operation"),
    insn("END", "", "--", then=END, zh="程序结束", en="end of the program"),
)  # fmt: skip

FX = Dialect(
    name="fx",
    title=Text("三菱FX", "Mitsubishi FX"),
    list=Text("指令表", "instruction list"),
    unit=Text("独立电路", "circuit"),
    stacks=(Stack("", Text("堆栈", "stack"), depth=12, register=Text("运算结果寄存器", "result register")),),
    areas=(
        Area("X", (("0", "377"),), Text("输入X", "inputs X"), base=8, role="input", groups=True),
        Area("Y", (("0", "377"),), Text("输出Y", "outputs Y"), base=8, role="output", groups=True),
        Area("M", (("0", "7679"), ("8000", "8511")), Text("辅助继电器M", "auxiliary relays M"), groups=True),
        Area("S", (("0", "4095"),), Text("状态继电器S", "state relays S"), groups=True),
        Area("T", (("0", "511"),), Text("定时器T", "timers T"), fields={"V": 16}, value="V"),
        Area("C", (("0", "255"),), Text("计数器C", "counters C"), fields={"V": 32}, value="V"),
        Area("D", (("0", "7999"), ("8000", "8511")), Text("数据寄存器D", "data registers D"), size=16),
    ),
    kinds={
        "bit": kind("X Y M S T C", zh="软元件，如X0", en="a device such as X0"),
        "out": kind("Y M S", zh="Y、M或S，如Y0", en="Y, M or S, such as Y0"),
        "clear": kind("Y M S T C D", zh="Y、M、S、T、C或D", en="Y, M, S, T, C or D"),
        "pulse": kind("Y M", zh="Y或M", en="Y or M"),
        "state": kind("S", zh="状态继电器，如S20", en="a state relay such as S20"),
        "timer": blocks("T", zh="定时器，如T0", en="a timer such as T0"),
        "counter": blocks("C", zh="计数器，如C0", en="a counter such as C0"),
        "word": words("X Y M S T C D", 16, zh="字：K或H开头的常数、D0、T0、C0或K4M0这样的位组", en="a word: a constant such as K5 or H1F, D0, T0, C0, or bits taken together such as K4M0"),
        "dword": words("X Y M S C D", 32, zh="32位的字：K或H开头的常数、D0（与D1一起）、C200或K8M0这样的位组", en="32 bits: a constant such as K5 or H1F, D0 (with D1), C200, or bits taken together such as K8M0"),
        "word_out": words("Y M S T C D", 16, constant=False, zh="可写的字，如D0、T0、C0或K4Y0", en="a word that can be written, such as D0, T0, C0 or K4Y0"),
        "dword_out": words("Y M S C D", 32, constant=False, zh="可写的32位，如D0（与D1一起）、C200或K8M0", en="32 bits that can be written, such as D0 (with D1), C200 or K8M0"),
        "preset": words("D", 16, ends=(1, 32767), zh="设定值：K1到K32767，或D0这样的数据寄存器", en="a preset: K1 to K32767, or a data register such as D0"),
        "preset32": words("D", 32, zh="设定值：32位的K常数，或D0（与D1一起）", en="a preset: a K constant of 32 bits, or D0 (with D1)"),
    },
    insns=INSTRUCTIONS,
    roles={
        "load": "LD", "load_not": "LDI", "series": "AND", "series_not": "ANI", "parallel": "OR", "parallel_not": "ORI",
        "join_series": "ANB", "join_parallel": "ORB", "push": "MPS", "read": "MRD", "pop": "MPP",
        "invert": "INV", "coil": "OUT", "set": "SET", "reset": "RST", "rise": "MEP", "fall": "MEF", "end": "END",
    },
    networks_by_title=False,  # a GX list has no headings: a new circuit begins at an LD once every value is used
    limits=(
        Limit("L", 7, Text("电路块（运算结果寄存器里的那一块不算，加上它一共8块）", "blocks beside the one in the result register (8 with that one)")),
        Limit("B", 11, Text("分支点", "branch points")),
    ),
    recognised=frozenset(
        "DMUL DMULP DDIV DDIVP SMOV SMOVP CML CMLP DCML BMOV BMOVP FMOV FMOVP DFMOV XCH XCHP DXCH BCD BCDP DBCD BIN BINP DBIN "
        "WAND WANDP DAND WOR WORP DOR WXOR WXORP DXOR NEG NEGP DNEG ROR RORP DROR ROL ROLP DROL RCR RCL WSFR WSFL SFWR SFRD "
        "DECO ENCO SUM BON MEAN ANS ANR SQR FLT REF REFF MTR HSCS HSCR HSZ SPD PLSY PWM PLSR IST SER ABSD INCD TTMR STMR ALT "
        "ALTP RAMP ROTC SORT TKY HKY DSW SEGD SEGL ASC PR FROM TO RS PRUN ASCI HEX CCD VRRD VRSC PID TRD TWR TCMP TZCP GRY GBIN "
        "ECMP EADD ESUB EMUL EDIV DECMP DEADD DESUB DEMUL DEDIV SWAP CJ CJP CALL CALLP SRET IRET EI DI FEND WDT FOR NEXT".split()
    ),
    blocks=(
        Block(
            "T", "timer", Text("定时器", "timer"), ("IN", "SV"), most=32767, stops=True,
            banks=(
                Bank(0, 199, 100), Bank(200, 245, 10), Bank(246, 249, 1, retains=True), Bank(250, 255, 100, retains=True),
                Bank(256, 511, 1),
            ),
        ),
        Block(
            "C", "counter", Text("计数器", "counter"), ("CU", "SV"), most=32767, stops=True, down="M8",
            banks=(Bank(0, 199), Bank(200, 234, size=32)),
            note=Text("C235到C255是高速计数器，这里不执行。", "C235 to C255 are high-speed counters, which are not run here."),
        ),
    ),
    flags={"zero": "M8020", "borrow": "M8021", "carry": "M8022"},
    wraps=True,
    separator=" ",
    retentive={
        "M": ((500, 7679),), "S": ((500, 4095),), "T": ((246, 255),), "C": ((100, 199), (220, 255)), "D": ((200, 7999),),
    },
    constant={"K": 10, "H": 16},
    counterparts={"input": "X", "output": "Y", "memory": "M", "step": "S", "word": "D", "timer": "T", "counter": "C"},
    specials={
        "M8000": "on", "M8001": "off", "M8002": "first", "M8003": "later",
        "M8011": "10", "M8012": "100", "M8013": "1000", "M8014": "60000",
    },
    note_octal=Text("X和Y按八进制编号，X7之后是X10，没有8和9。", "X and Y count in octal: X10 follows X7, and there is no 8 or 9."),
    examples=(
        "LD X0; OR Y0; ANI X1; OUT Y0; END",
        "LD X0; OR X2; LD X1; AND X4; LD X3; AND X5; ORB; ANB; OUT Y0",
        "LD X0; OR X5; MPS; AND X1; OUT Y0; MRD; AND X2; OUT Y1; MPP; AND X3; OUT Y2",
        "LDI X0; ORI X1; INV; OUT Y0; NOP",
        "LDP X0; ANDP X1; ORP X2; SET Y0; LDF X3; ANDF X4; ORF X5; RST Y0",
        "LD X0; PLS M0; LD X1; PLF M1; LD M0; OR M1; OUT Y0",
        "LD X0; AND X1; MEP; OUT Y0; LD X0; AND X1; MEF; OUT Y1",
        "LD X0; OUT T0 K10; LD T0; OUT Y0",
        "LD X0; RST C0; LD X1; OUT C0 K5; LD C0; OUT Y0",
        "LD X0; MC N0 M100; LD X1; OUT Y0; MCR N0; LD X2; OUT Y1",
        "LD M8002; SET S0; STL S0; LD X0; SET S20; STL S20; OUT Y0; LD X1; OUT S0; RET; END",
        *(f"LD{d}{relation} D0 K5; OUT Y0" for d in ("", "D") for relation in RELATIONS),
        *(f"LD X0; {word}{d}{relation} D0 K5; OUT Y0" for word in ("AND", "OR") for d in ("", "D") for relation in RELATIONS),
        *(f"LD X0; {d}MOV{p} K5 D0" for d in ("", "D") for p in ("", "P")),
        *(f"LD X0; {d}CMP{p} D0 K5 M0; LD M1; OUT Y0" for d in ("", "D") for p in ("", "P")),
        *(f"LD X0; {d}ZCP{p} K5 K9 D0 M0; LD M1; OUT Y0" for d in ("", "D") for p in ("", "P")),
        *(f"LD X0; {d}{word}{p} D0 K5 D10" for word in ("ADD", "SUB") for d in ("", "D") for p in ("", "P")),
        *(f"LD X0; {word}{p} D0 D1 D10" for word in ("MUL", "DIV") for p in ("", "P")),
        *(f"LD X0; {d}{word}{p} D0" for word in ("INC", "DEC") for d in ("", "D") for p in ("", "P")),
        *(f"LD X0; {word}{p} X1 M0 K8 K1; LD M7; OUT Y0" for word in ("SFTL", "SFTR") for p in ("", "P")),
        *(f"LD X0; ZRST{p} M0 M7" for p in ("", "P")),
    ),
    samples=(
        Sample("COI001", "LD X0; OUT Y0; LD X1; OUT Y0", "LD X0; OR X1; OUT Y0"),
        Sample("COI009", "OUT Y0", "LD X0; OUT Y0"),
        Sample("COI010", "LD X0; OUT T0 K10; LD X1; OUT T0 K20; LD T0; OUT Y0", "LD X0; OUT T0 K10; LD X1; OUT T1 K20; LD T0; OR T1; OUT Y0"),
        Sample("STY001", "LD X0; AND X3; LD X1; ORI X2; ORB; OUT Y0", "LD X0; AND X3; OR X1; ORI X2; OUT Y0"),
        Sample("STY002", "LD X0; MPS; OUT Y0; MRD; OUT Y1; MPP; OUT Y2", "LD X0; OUT Y0; OUT Y1; OUT Y2"),
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
        Sample("COI003", "LD X0; MC N0 M100; LD X1; OUT Y0", "LD X0; MC N0 M100; LD X1; OUT Y0; MCR N0"),
        Sample("COI004", "LD X0; OUT Y0; MCR N0", "LD X0; MC N0 M100; LD X1; OUT Y0; MCR N0"),
        Sample(
            "COI005", "LD X0; MC N1 M100; LD X1; MC N0 M101; LD X2; OUT Y0; MCR N1; MCR N0",
            "LD X0; MC N0 M100; LD X1; MC N1 M101; LD X2; OUT Y0; MCR N1; MCR N0",
        ),
        Sample(
            "COI006", "STL S20; OUT Y0; LD X0; MC N0 M100; LD X1; OUT Y1; MCR N0; RET",
            "LD X0; MC N0 M100; LD X1; OUT Y1; MCR N0; STL S20; OUT Y0; RET",
        ),
        Sample(
            "COI007", "STL S20; MPS; AND X0; OUT Y0; MPP; AND X1; OUT Y1; RET",
            "STL S20; LD X2; MPS; AND X0; OUT Y0; MPP; AND X1; OUT Y1; RET",
        ),
        Sample("COI008", "STL S20; OUT Y0", "STL S20; OUT Y0; RET"),
        Sample("RDR001", "LD X0; ORR X1; OUT Y0", "LD X0; ORI X1; OUT Y0"),
        Sample("RDR006", "LD X8; OUT Y0", "LD X10; OUT Y0"),
        Sample("RDR007", "LD X0; OUT X1", "LD X0; OUT Y1"),
        Sample("RDR019", "LD D0; OUT Y0", "LD> D0 K0; OUT Y0"),
    ),
)  # fmt: skip
