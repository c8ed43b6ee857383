"""GUTTA: a data stack for series and parallel, an auxiliary stack for branch points; A and O are fusions of LD with a join.

Source: 004_076ff6df1b5a98bb.txt. Depths of 32 and the clearing of both stacks at each network are ours [rec].
"""

from __future__ import annotations

from plcteach.core.area import Area, kind
from plcteach.core.spec import Dialect, Sample, Stack, insn
from plcteach.core.text import Text
from plcteach.core.verb import coil, reset, set_

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
)

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
        Area("I", (("0.0", "15.7"),), Text("输入", "inputs"), per=8, role="input"),
        Area("Q", (("0.0", "15.7"),), Text("输出", "outputs"), per=8, role="output"),
        Area("M", (("0.0", "31.7"),), Text("位存储器", "bit memory"), per=8),
        Area("SM", (("0.0", "179.7"),), Text("特殊存储器位", "special memory bits"), per=8),
        Area("V", (("0.0", "2047.7"),), Text("变量存储器", "variable memory"), per=8),
        Area("T", (("0", "255"),), Text("定时器位", "timer bits")),
        Area("C", (("0", "255"),), Text("计数器位", "counter bits")),
    ),
    kinds={
        "bit": kind("I Q M SM V T C", zh="位地址，如I0.0", en="a bit address such as I0.0"),
        "out": kind("Q M V T C", zh="可写的位，如Q0.0", en="a bit that can be written, such as Q0.0"),
        "m": kind("M V Q", zh="记录上次能流的位，如M0.0", en="a bit that keeps the last flow, such as M0.0"),
    },
    insns=INSTRUCTIONS,
    roles={
        "load": "LD", "load_not": "LDN", "series": "A", "series_not": "AN", "parallel": "O", "parallel_not": "ON",
        "join_series": "ALD", "join_parallel": "OLD", "push": "LPS", "read": "LRD", "pop": "LPP",
        "invert": "NOT", "coil": "=", "set": "S", "reset": "R", "rise": "P", "fall": "N",
    },
    recognised=frozenset("CTUD CTU CTD TON TOF TONR MOVW MOVB MOVD +I -I *I /I LDW= LDW> LDW< ADD_I".split()),
    specials={"SM0.0": "on", "SM0.1": "first"},
    examples=(
        "LD I0.0; O Q0.0; AN I0.1; = Q0.0",
        "LD I0.0; A I0.1; LDN I0.2; A I0.3; OLD; = Q0.0",
        "LD I0.0; ON I0.1; LD I0.2; O I0.3; ALD; = Q0.0",
        "LD I0.0; LPS; A I0.1; = Q0.0; LRD; A I0.2; = Q0.1; LPP; A I0.3; = Q0.2",
        "LD I0.0; P M0.0; S Q0.0, 1; LD I0.1; N M0.1; R Q0.0, 1",
        "LD I0.0; LPS; NOT; LD SM0.0; LPP; A I0.1; OLD; = Q0.0",
    ),
    samples=(
        Sample("COI002", "LD I0.0; P M0.0; = Q0.0; LD I0.1; = M0.0", "LD I0.0; P M0.1; = Q0.0; LD I0.1; = M0.0"),
        Sample("COI001", "LD I0.0; = Q0.0; LD I0.1; = Q0.0", "LD I0.0; O I0.1; = Q0.0"),
        Sample("STK001", "LD I0.0; LPS; ALD; = Q0.0", "LD I0.0; LD I0.1; O I0.2; ALD; = Q0.0"),
        Sample("STK003", "LD I0.0; A I0.1; = Q0.0; LPP; A I0.2; = Q0.1", "LD I0.0; LPS; A I0.1; = Q0.0; LPP; A I0.2; = Q0.1"),
        Sample("STK005", "LD I0.0; LPS; A I0.1; = Q0.0", "LD I0.0; A I0.1; = Q0.0"),
        Sample("STK007", "LD I0.0; LD M0.0; OLD; = Q0.0", "LD I0.0; O M0.0; = Q0.0"),
        Sample("STK008", "LD I0.0; LD M0.0; ALD; = Q0.0", "LD I0.0; A M0.0; = Q0.0"),
    ),
)  # fmt: skip
