"""The sentence for each step and each instruction: precise, in both languages, and never with a hole in it."""

from __future__ import annotations

import re

import pytest

from plcteach.dialects import dialect, names
from plcteach.figure.says import describes, says
from plcteach.machine import run
from plcteach.stl import read

EVERY = [(name, row.mnemonic) for name in names() for row in dialect(name).insns]


def told(family: str, text: str, inputs=None, line: int = -1, scans: int = 1):
    program = read(text, family)
    trace = run(program, inputs if isinstance(inputs, list) else [inputs or {}] * scans)
    scan = trace.scans[-1]
    return says(program.dialect, scan.steps[line], first=scan.number == 0)


def test_a_load_is_pushed():
    text = told("s7-200", "LD I0.1", {"I0.1": 1})
    assert text.en == "LD I0.1: I0.1 is 1. It is pushed onto the top; everything below moves down one level."
    assert text.zh == "LD I0.1：I0.1为1，压入栈顶；下面各层依次下移一层。"


def test_a_closed_contact_says_both_values():
    text = told("s7-200", "LDN I0.1", {"I0.1": 1})
    assert text.en.startswith("LDN I0.1: I0.1 is 1, inverted 0, and 0 is pushed onto the top")
    assert text.zh.startswith("LDN I0.1：I0.1为1，取反得0，压入栈顶")


def test_a_join_names_its_levels_and_the_x_that_enters():
    text = told("s7-200", "LD I0.0; LD I0.1; OLD", {"I0.1": 1})
    assert text.en == (
        "OLD: level 2 (0) OR level 1 (1) = 1 becomes the new top; the levels below move up and x enters level 9."
    )
    assert text.zh == "OLD：第2层（0）与第1层（1）相或得1，成为新的栈顶；下面各层依次上移一层，x补入第9层。"


def test_series_in_place():
    text = told("s7-200", "LD I0.0; AN I0.1", {"I0.0": 1, "I0.1": 1})
    assert "I0.1 is 1, inverted 0. The top (1) AND 0 = 0" in text.en
    assert "the other levels stay" in text.en


def test_a_coil_changes_no_stack():
    text = told("s7-200", "LD I0.0; = Q0.0", {"I0.0": 1})
    assert text.en == "= Q0.0: the top, 1, is written to Q0.0; the stack stays as it is."
    assert text.zh == "= Q0.0：栈顶的1写入Q0.0；堆栈不变。"


@pytest.mark.parametrize(
    ("value", "en", "zh"), [(1, "so Q0.0 is set to 1", "置位"), (0, "so nothing changes", "不改变")]
)
def test_set_acts_only_on_1(value, en, zh):
    text = told("s7-200", "LD I0.0; S Q0.0, 1", {"I0.0": value})
    assert en in text.en
    assert zh in text.zh


def test_set_counts_its_bits():
    assert "the 3 bits from Q0.0 are set to 1" in told("s7-200", "LD I0.0; S Q0.0, 3", {"I0.0": 1}).en


def test_x_is_never_hidden():
    assert "may be 0 or 1" in told("s7-200", "= Q0.0").en
    assert "nobody knows" in told("s7-200", "S Q0.0, 1").en


def test_the_bottom_falls_out_when_it_held_something():
    lines = "; ".join(["LD I0.0"] * 10)
    assert "the 1 in level 9 falls out" in told("s7-200", lines, {"I0.0": 1}).en.lower()
    assert "falls out" not in told("s7-200", lines, {"I0.0": 1}, line=8).en


@pytest.mark.parametrize(
    ("words", "en", "zh"),
    [
        ("LD I0.0; LPS", "the top (1) is copied into level 2", "栈顶（1）复制一份压入第2层"),
        ("LD I0.0; LD I0.1; LRD", "level 2 (1) is copied to the top, and the old top (0) is gone", "原栈顶（0）消失"),
        ("LD I0.0; LD I0.1; LPP", "level 2 (1) becomes the new top", "x补入第9层"),
        ("LD I0.0; LD I0.1; LDS 1", "level 2 (1) is copied and pushed onto the top", "第2层（1）复制一份压入栈顶"),
        ("LD I0.0; NOT", "the top (1) is inverted to 0", "栈顶（1）取反得0"),
        ("NOP 1", "nothing changes", "什么也不改变"),
    ],
)
def test_the_stack_instructions(words, en, zh):
    text = told("s7-200", words, {"I0.0": 1})
    assert en in text.en
    assert zh in text.zh


def test_edges_are_told_by_what_they_show():
    rising = [{"I0.0": 0}, {"I0.0": 1}]
    assert "has risen since the last scan, so the top becomes 1" in told("s7-200", "LD I0.0; EU", rising).en
    assert "has not risen" in told("s7-200", "LD I0.0; EU", [{"I0.0": 1}] * 2).en
    assert "in the first scan there is no edge" in told("s7-200", "LD I0.0; EU", [{"I0.0": 1}]).en
    assert "X1 (1) has risen" in told("fx", "LD X0; ANDP X1", [{"X0": 1}, {"X1": 1}]).en
    assert "so 1 is written to M0" in told("fx", "LD X0; PLS M0", [{}, {"X0": 1}]).en
    assert "%I0.0（0）自上次扫描以来由1变0" in told("neza", "LDF %I0.0", [{"%I0.0": 1}, {"%I0.0": 0}]).zh


def test_an_edge_that_cannot_be_seen_is_not_invented():
    # 1 OR anything is 1: the step does not show whether X1 has risen.
    text = told("fx", "LD X0; ORP X1", [{"X0": 1, "X1": 0}, {"X1": 1}])
    assert "has risen" not in text.en
    assert "has not risen" not in text.en
    assert "that edge = 1" in text.en


def test_the_result_register_is_called_by_its_name():
    fresh = told("fx", "LD X0", {"X0": 1})
    assert "goes into the result register, and a new circuit begins" in fresh.en
    pushed = told("fx", "LD X0; AND X1; LD X2; AND X3; ORB; OUT Y0", {"X0": 1, "X1": 1}, line=2)
    assert pushed.en == "LD X2: X2 is 0. It goes into the result register; the old value (1) is pushed down to level 1."
    assert "运算结果寄存器" in pushed.zh
    assert (
        "level 1 (1) OR the result register (0) = 1"
        in told("fx", "LD X0; AND X1; LD X2; AND X3; ORB; OUT Y0", {"X0": 1, "X1": 1}, line=4).en
    )


def test_parentheses_and_branches():
    text = "LD %I0.0; AND( %I0.1; OR %I0.2; ); MPS; AND %I0.3; ST %Q0.0; MPP; STN %Q0.1"
    given = {"%I0.0": 1, "%I0.2": 1}
    assert "布尔累加器（1）压入括号栈" in told("neza", text, given, line=1).zh
    assert "the top of the parentheses stack (1) AND the accumulator (1) = 1" in told("neza", text, given, line=3).en
    assert "copied onto the branch points stack" in told("neza", text, given, line=4).en
    assert "is popped and goes to the accumulator" in told("neza", text, given, line=7).en
    assert "0 is written to %Q0.1" in told("neza", text, given, line=8).en


def test_the_auxiliary_stack():
    assert "the top (1) is copied onto the auxiliary stack" in told("gutta", "LD I0.0; LPS", {"I0.0": 1}).en
    assert "kept in M0.0" in told("gutta", "LD I0.0; P M0.0", {"I0.0": 1}).en


@pytest.mark.parametrize(
    ("family", "words", "zh"),
    [
        ("gutta", "LD I0.0; ALD", "数据栈里少1个值，用x代替"),
        ("gutta", "LPP", "辅助栈里少1个值，用x代替"),
        ("fx", "LD X0; ORB", "堆栈里少1个值，用x代替"),
        ("neza", "MPP", "分支栈里少1个值，用x代替"),
        ("fx", "MPS", "少1个值"),
        ("fx", "OUT Y0", "少1个值"),
        ("gutta", "= Q0.0", "少1个值"),
    ],
)
def test_missing_cells_are_counted(family, words, zh):
    text = told(family, words)
    assert zh in text.zh
    assert_whole(text)


def assert_whole(text):
    for words in (text.zh, text.en):
        assert words.strip()
        assert not re.search(r"[{}]|None|  |（）|\(\)|,\.|；。|：。|[，。；]{2}", words), words
    assert text.zh.endswith("。")
    assert text.en.endswith(".")
    assert not re.search(r"[a-z]{3}", text.zh.replace("plc", ""))
    assert not re.search(r"[一-鿿（）。，]", text.en)


@pytest.mark.parametrize(("name", "mnemonic"), EVERY)
def test_every_instruction_is_described_without_holes(name, mnemonic):
    family = dialect(name)
    text = describes(family, family.insn(mnemonic))
    assert text.en.startswith(mnemonic.rstrip(":"))
    assert_whole(text)


USUAL = {"s7-200": "I0.0 Q0.0", "s7-200-smart": "I0.0 Q0.0", "fx": "X0 M0", "neza": "%I0.0 %M0", "gutta": "I0.0 M0.0"}


def programs_with(name, mnemonic):
    """Give an instruction on a full and on an empty stack; where it wants more than bits, the family's own example of it."""
    family = dialect(name)
    row = family.insn(mnemonic)
    bit, out = USUAL[name].split()
    words = [
        "1" if operand.number else out if operand.name in {verb.target for verb in row.then} else bit
        for operand in row.operands
    ]
    load, push = family.roles["load"], family.roles["push"]
    line = f"{row.word} {', '.join(words)}"
    usual = [read(before + line, family) for before in (f"{load} {bit}; {load} {bit}; {push}; ", "")]
    if all(one.runs and one.lines[-1].insn is row for one in usual):
        return usual
    return [read(family.example(mnemonic).replace("; ", "\n"), family)]


@pytest.mark.parametrize(("name", "mnemonic"), EVERY)
def test_every_step_is_told_without_holes(name, mnemonic):
    """Every instruction runs on a full and on an empty stack, with 0 and 1, in the first scan and later."""
    family, bit = dialect(name), USUAL[name].split()[0]
    for program in programs_with(name, mnemonic):
        assert family.insn(mnemonic) in [line.insn for line in program.lines]
        for scan in run(program, [{bit: 0}, {bit: 1}, {bit: 0}]).scans:
            for step in scan.steps:
                assert_whole(says(family, step, first=scan.number == 0))
