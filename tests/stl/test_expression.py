"""Brackets: operations and comparisons, blanks anywhere, one canonical spelling, and what is said of all else."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.program import Assign, Compare
from plcteach.stl import read, write
from plcteach.stl.expression import LONGEST


def first(text: str):
    program = read(f"LD %I0.0\n{text}", "neza")
    assert not program.diagnostics, program.diagnostics
    return program.lines[1]


@pytest.mark.parametrize(
    ("text", "op", "canonical"),
    [
        ("[%MW0 := %MW1 + 5]", "add", "[%MW0 := %MW1 + 5]"),
        ("[%mw0:=%mw1+5]", "add", "[%MW0 := %MW1 + 5]"),
        ("[ %MW0 := %MW1 -5 ]", "sub", "[%MW0 := %MW1 - 5]"),
        ("[%MW0 := %MW1 * -5]", "mul", "[%MW0 := %MW1 * -5]"),
        ("[%MW0:=%MW1/%KW3]", "div", "[%MW0 := %MW1 / %KW3]"),
        ("[%MW0 := %MW1 rem 7]", "rem", "[%MW0 := %MW1 REM 7]"),
        ("[%MW0 := %MW1 AND 16#0f]", "and", "[%MW0 := %MW1 AND 16#F]"),
        ("[%MW0 := %MW1 OR 2#101]", "or", "[%MW0 := %MW1 OR 2#101]"),
        ("[%MW0 := %MW1 XOR %MW2]", "xor", "[%MW0 := %MW1 XOR %MW2]"),
        ("[%MW0 := NOT (%MW1)]", "not", "[%MW0 := NOT(%MW1)]"),
        ("[%MW0 := NOT %MW1]", "not", "[%MW0 := NOT(%MW1)]"),
        ("[%MW0 := SQRT(%MW1 )]", "sqrt", "[%MW0 := SQRT(%MW1)]"),
        ("[%MW0:=SHL(%MW1,3)]", "shl16", "[%MW0 := SHL(%MW1, 3)]"),
        ("[%MW0 := ROR ( %MW1 , 3 ) ]", "ror16", "[%MW0 := ROR(%MW1, 3)]"),
        ("[INC %MW0]", "inc", "[INC %MW0]"),
        ("[dec %MW0]", "dec", "[DEC %MW0]"),
        ("[%MW0 := -5]", "move", "[%MW0 := -5]"),
        ("[%MW0 := %TM3.V]", "move", "[%MW0 := %TM3.V]"),
        ("[%TM3.P := %MW0]", "move", "[%TM3.P := %MW0]"),
        ("[%R2.I := %DR1.S]", "move", "[%R2.I := %DR1.S]"),
    ],
)
def test_operations(text: str, op: str, canonical: str) -> None:
    line = first(text)
    assert isinstance(line.args[0], Assign)
    assert line.args[0].op == op
    assert line.text == canonical
    assert first(line.text) == line


@pytest.mark.parametrize(
    ("text", "canonical"),
    [
        ("AND [%MW0 > 10]", "AND [%MW0 > 10]"),
        ("AND [%DR0.S=0]", "AND [%DR0.S = 0]"),
        ("and[%MW0<>%MW1]", "AND [%MW0 <> %MW1]"),
        ("ORN [ %C0.V >= %C0.P ]", "ORN [%C0.V >= %C0.P]"),
        ("XOR [5 <= %MW0]", "XOR [5 <= %MW0]"),
        ("AND([%MW0<-3]\n)", "AND( [%MW0 < -3]"),
        ("OR( [%MW0 = 0])", "OR( [%MW0 = 0]"),
        ("OR(N [%MW0 = 0]\n)", "OR(N [%MW0 = 0]"),
    ],
)
def test_comparisons(text: str, canonical: str) -> None:
    line = first(text)
    assert isinstance(line.args[0], Compare)
    assert line.text == canonical
    whole = read(f"LD %I0.0\n{text}", "neza")
    assert read(write(whole), "neza") == whole


def test_a_closing_parenthesis_in_brackets_closes_nothing_outside() -> None:
    program = read("LD %I0.0\nAND( [%MW0 = 1]\nOR %I0.1 )\n[%MW1 := SHL(%MW0, 2 )]\n[%MW1 := NOT ( %MW0 ) ]", "neza")
    assert [line.text for line in program.lines[2:]] == [
        "OR %I0.1",
        ")",
        "[%MW1 := SHL(%MW0, 2)]",
        "[%MW1 := NOT(%MW0)]",
    ]
    assert not program.diagnostics


@pytest.mark.parametrize(
    ("text", "code", "under"),
    [
        ("[]", "EXP001", "]"),
        ("[%MW0]", "EXP001", "]"),
        ("[%MW0 := ]", "EXP001", "]"),
        ("[%MW0 = 5]", "EXP001", "="),
        ("[%MW0 := %MW1 + ]", "EXP001", "]"),
        ("[%MW0 := %MW1 5]", "EXP001", "5"),
        ("[%MW0 := %MW1 + 5 + 6]", "EXP001", "+"),
        ("[%MW0 := (%MW1 + 5)]", "EXP001", "("),
        ("[%MW0 := SQRT(%MW1]", "EXP001", "]"),
        ("[%MW0 := %MW1 % 5]", "EXP001", "%"),
        ("[%MW0 := %MW1 + 5", "EXP001", "[%MW0 := %MW1 + 5"),
        ("[__import__(1)]", "EXP001", "__import__"),
        ("[%MW0 := 40000]", "RDR008", "40000"),
        ("[%MW0 := %MW999]", "RDR006", "%MW999"),
        ("[%MW0 := %M1]", "RDR007", "%M1"),
        ("[%M0 := 1]", "RDR007", "%M0"),
        ("[%KW0 := 1]", "RDR007", "%KW0"),
        ("[%TM0.V := 1]", "RDR007", "%TM0.V"),
        ("[%C0.V := 1]", "RDR007", "%C0.V"),
        ("[5 := %MW0]", "RDR007", "5"),
        ("AND [%MW0 := 5]", "EXP001", ":="),
        ("AND [%MW0 >]", "EXP001", "]"),
        ("AND [%MW0 > 5", "EXP001", "[%MW0 > 5"),
        ("ST [%MW0 > 5]", "RDR005", "[%MW0 > 5]"),
        ("LDR [%MW0 > 5]", "RDR005", "[%MW0 > 5]"),
        ("AND [%MW0 > 5] %I0.0", "RDR004", "%I0.0"),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_said_where_it_stands(text: str, code: str, under: str) -> None:
    (one,) = read(f"LD %I0.0\n{text}", "neza").diagnostics
    assert (one.code, one.span.row) == (code, 2)
    assert text[one.span.start : one.span.stop] == under
    assert one.text.zh != one.text.en


def test_very_long_brackets_are_refused_unread() -> None:
    for text in ("[%MW0 := " + "(" * 1_500 + "]", "[" * 1_500, f"[%MW0 := {'1' * LONGEST}]"):
        assert {one.code for one in read(f"LD %I0.0\n{text}", "neza").diagnostics} == {"EXP001"}


def test_families_without_brackets_know_nothing_of_them() -> None:
    assert [one.code for one in read("LD I0.0\n[VW0 := 5]", "s7-200").diagnostics] == ["RDR001"]


@settings(max_examples=300, deadline=None)
@given(st.text(st.sampled_from("%MWKCTMV01.9:=<>+-*/() ,[]#ANDSHLRINC"), max_size=30))
def test_anything_in_brackets_is_read_or_said(text: str) -> None:
    program = read(f"LD %I0.0\n[{text}]\nLD %I0.1\nAND [{text}]\nST %Q0.0", "neza")
    if not program.diagnostics:
        assert read(write(program), "neza") == program
