"""NEZA (TSX08): a Boolean accumulator, a stack for parentheses and a stack for branch points.

Sources: 003_8b8dde9772520c5a.txt; the guides of its successors EIO0000003289 and EIO0000003281. Depths of eight are ours [rec].
"""

from __future__ import annotations

from plcteach.core.area import Area, kind
from plcteach.core.spec import Dialect, Sample, Stack, insn
from plcteach.core.text import Text
from plcteach.core.verb import END, coil, reset, set_

INSTRUCTIONS = (
    # contacts
    insn("LD", "bit", "a -- bit", zh="装载（常开触点）", en="load a normally open contact"),
    insn("LDN", "bit", "a -- !bit", zh="取反后装载（常闭触点）", en="load a normally closed contact"),
    insn("LDR", "bit:edge", "a -- rise(bit)", zh="装载上升沿", en="load a rising edge"),
    insn("LDF", "bit:edge", "a -- fall(bit)", zh="装载下降沿", en="load a falling edge"),
    insn("AND", "bit", "a -- a&bit", zh="与（串联常开触点）", en="normally open contact in series"),
    insn("ANDN", "bit", "a -- a&!bit", zh="与非（串联常闭触点）", en="normally closed contact in series"),
    insn("ANDR", "bit:edge", "a -- a&rise(bit)", zh="与上升沿", en="rising edge in series"),
    insn("ANDF", "bit:edge", "a -- a&fall(bit)", zh="与下降沿", en="falling edge in series"),
    insn("OR", "bit", "a -- a|bit", zh="或（并联常开触点）", en="normally open contact in parallel"),
    insn("ORN", "bit", "a -- a|!bit", zh="或非（并联常闭触点）", en="normally closed contact in parallel"),
    insn("ORR", "bit:edge", "a -- a|rise(bit)", zh="或上升沿", en="rising edge in parallel"),
    insn("ORF", "bit:edge", "a -- a|fall(bit)", zh="或下降沿", en="falling edge in parallel"),
    insn("XOR", "bit", "a -- a^bit", zh="异或", en="exclusive or"),
    insn("XORN", "bit", "a -- a^!bit", zh="异或非", en="exclusive or with the inverse"),
    insn("XORR", "bit:edge", "a -- a^rise(bit)", zh="异或上升沿", en="exclusive or with a rising edge"),
    insn("XORF", "bit:edge", "a -- a^fall(bit)", zh="异或下降沿", en="exclusive or with a falling edge"),
    insn("N", "", "a -- !a", zh="取反", en="invert the accumulator"),
    # parentheses: the opener saves the accumulator, its ) brings it back and combines
    insn(
        "AND(",
        "bit?",
        "a -- bit ; paren: -- a",
        bare="a -- ; paren: -- a",
        close="b -- a&b ; paren: a --",
        zh="与括号",
        en="and a block in parentheses",
    ),
    insn(
        "AND(N",
        "bit",
        "a -- !bit ; paren: -- a",
        close="b -- a&b ; paren: a --",
        zh="与括号（取反）",
        en="and a block that begins inverted",
    ),
    insn(
        "AND(R",
        "bit:edge",
        "a -- rise(bit) ; paren: -- a",
        close="b -- a&b ; paren: a --",
        zh="与括号（上升沿）",
        en="and a block that begins with a rising edge",
    ),
    insn(
        "AND(F",
        "bit:edge",
        "a -- fall(bit) ; paren: -- a",
        close="b -- a&b ; paren: a --",
        zh="与括号（下降沿）",
        en="and a block that begins with a falling edge",
    ),
    insn(
        "OR(",
        "bit?",
        "a -- bit ; paren: -- a",
        bare="a -- ; paren: -- a",
        close="b -- a|b ; paren: a --",
        zh="或括号",
        en="or a block in parentheses",
    ),
    insn(
        "OR(N",
        "bit",
        "a -- !bit ; paren: -- a",
        close="b -- a|b ; paren: a --",
        zh="或括号（取反）",
        en="or a block that begins inverted",
    ),
    insn(
        "OR(R",
        "bit:edge",
        "a -- rise(bit) ; paren: -- a",
        close="b -- a|b ; paren: a --",
        zh="或括号（上升沿）",
        en="or a block that begins with a rising edge",
    ),
    insn(
        "OR(F",
        "bit:edge",
        "a -- fall(bit) ; paren: -- a",
        close="b -- a|b ; paren: a --",
        zh="或括号（下降沿）",
        en="or a block that begins with a falling edge",
    ),
    insn(")", "", "b -- a&b ; paren: a --", zh="括号结束", en="close the parenthesis"),
    # branches
    insn("MPS", "", "a -- a ; branch: -- a", zh="进栈", en="push: save the branch point"),
    insn("MRD", "", "a -- top ; branch: top -- top", zh="读栈", en="read: look at the branch point"),
    insn("MPP", "", "a -- top ; branch: top --", zh="出栈", en="pop: fetch the branch point and remove it"),
    # coils
    insn("ST", "out", "a -- a", then=coil("a"), zh="存储（线圈）", en="store: output coil"),
    insn("STN", "out", "a -- a", then=coil("!a"), zh="取反存储", en="store inverted"),
    insn("S", "out", "a -- a", then=set_("a"), zh="置位", en="set"),
    insn("R", "out", "a -- a", then=reset("a"), zh="复位", en="reset"),
    insn("NOP", "", "--", zh="空操作", en="no operation"),
    insn("END", "", "--", then=END, zh="程序结束", en="end of the program"),
)

NEZA = Dialect(
    name="neza",
    title=Text("NEZA（TSX08）", "NEZA (TSX08)"),
    list=Text("指令表", "instruction list"),
    unit=Text("梯级", "rung"),
    stacks=(
        Stack("", Text("累加器", "accumulator"), depth=1, fixed=True, register=Text("布尔累加器", "accumulator")),
        Stack("paren", Text("括号栈", "parentheses"), depth=8),
        Stack("branch", Text("分支栈", "branch points"), depth=8),
    ),
    areas=(
        Area("%I", (("0.0", "7.31"),), Text("输入", "inputs"), per=32, role="input"),
        Area("%Q", (("0.0", "7.31"),), Text("输出", "outputs"), per=32, role="output"),
        Area("%M", (("0", "255"),), Text("内部位", "internal bits")),
        Area("%S", (("0", "127"),), Text("系统位", "system bits")),
        Area("", (("0", "1"),), Text("常数0和1", "the constants 0 and 1")),
    ),
    kinds={
        "bit": kind("%I %Q %M %S ", zh="位地址，如%I0.0", en="a bit address such as %I0.0"),
        "edge": kind("%I %M", zh="%I或%M（只有它们有沿）", en="%I or %M (only they have edges)"),
        "out": kind("%Q %M %S", zh="%Q、%M或%S", en="%Q, %M or %S"),
    },
    insns=INSTRUCTIONS,
    roles={
        "load": "LD", "load_not": "LDN", "series": "AND", "series_not": "ANDN", "parallel": "OR", "parallel_not": "ORN",
        "join_series": "AND(", "join_parallel": "OR(", "push": "MPS", "read": "MRD", "pop": "MPP",
        "invert": "N", "coil": "ST", "set": "S", "reset": "R", "end": "END",
    },
    samples_edges_at_start=True,  # an %M written in scan n shows its edge in scan n+1
    networks_by_title=False,
    heading="RUNG",
    recognised=frozenset(
        "BLK OUT_BLK END_BLK IN U CU CD I O JMP JMPC JMPCN SR0 SR1 SR2 SR3 SR4 SR5 SR6 SR7 RET ENDC ENDCN [".split()
    ),
    specials={"0": "off", "1": "on", "%S13": "first", "%S0": "first"},
    examples=(
        "LD %I0.0; OR %Q0.0; ANDN %I0.1; ST %Q0.0; END",
        "LD %I0.0; AND( %I0.1; OR %I0.2; ); ST %Q0.0",
        "LD %I0.0; AND %I0.1; OR( %I0.2; AND %I0.3; ); ST %Q0.0",
        "LD %I0.0; MPS; AND %I0.1; ST %Q0.0; MRD; AND %I0.2; ST %Q0.1; MPP; AND %I0.3; STN %Q0.2",
        "LDN %I0.0; XOR %I0.1; N; XORN %I0.2; ST %Q0.0; NOP",
        "LDR %I0.0; S %Q0.0; LDF %I0.1; R %Q0.0",
        "LD %I0.0; ANDR %I0.1; ORF %I0.2; ST %Q0.0",
        "LD %I0.0; ANDF %I0.1; ORR %I0.2; ORN %I0.3; ST %Q0.0",
        "LD %I0.0; XORR %I0.1; XORF %I0.2; ST %Q0.0",
        "LD %I0.0; AND(N %I0.1; OR %I0.2; ); OR(N %I0.3; AND %I0.4; ); ST %Q0.0",
        "LD %I0.0; AND(R %I0.1; OR %I0.2; ); OR(R %I0.3; AND %I0.4; ); ST %Q0.0",
        "LD %I0.0; AND(F %I0.1; OR %I0.2; ); OR(F %I0.3; AND %I0.4; ); ST %Q0.0",
    ),
    samples=(
        Sample("COI001", "LD %I0.0; ST %Q0.0; LD %I0.1; ST %Q0.0", "LD %I0.0; OR %I0.1; ST %Q0.0"),
        Sample("STK003", "LD %I0.0; AND %I0.1; ST %Q0.0; MPP; AND %I0.2; ST %Q0.1", "LD %I0.0; MPS; AND %I0.1; ST %Q0.0; MPP; AND %I0.2; ST %Q0.1"),
        Sample("STK005", "LD %I0.0; MPS; AND %I0.1; ST %Q0.0", "LD %I0.0; MPS; AND %I0.1; ST %Q0.0; MPP; ST %Q0.1"),
        Sample(
            "STK006",
            "LD %I0.0; MPS; AND %I0.1; ST %Q0.0; MRD; AND %I0.2; ST %Q0.1",
            "LD %I0.0; MPS; AND %I0.1; ST %Q0.0; MPP; AND %I0.2; ST %Q0.1",
        ),
        Sample("STK009", "XOR %I0.0; ST %Q0.0", "LD %I0.1; XOR %I0.0; ST %Q0.0"),
        Sample("STK010", "LD %I0.0; LD %I0.1; ST %Q0.0", "LD %I0.0; AND %I0.1; ST %Q0.0"),
        Sample("STK012", "LD %I0.0; AND( %I0.1; ST %Q0.0; )", "LD %I0.0; AND( %I0.1; OR %I0.2; ); ST %Q0.0"),
        Sample("RDR010", "LD %I0.0; OR %I0.1; ); ST %Q0.0", "LD %I0.2; AND( %I0.0; OR %I0.1; ); ST %Q0.0"),
        Sample("RDR011", "LD %I0.0; AND( %I0.1; OR %I0.2; ST %Q0.0", "LD %I0.0; AND( %I0.1; OR %I0.2; ); ST %Q0.0"),
    ),
)  # fmt: skip
