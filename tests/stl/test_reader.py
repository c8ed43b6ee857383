"""What people have in their files and type into a cell: it is read, or everything that is odd about it is said with its place."""

from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.diagnostic import RULES
from plcteach.core.errors import UnknownNameError
from plcteach.core.source import MOST_CHARACTERS, Span
from plcteach.dialects import names
from plcteach.machine import run
from plcteach.stl import read
from plcteach.stl.tokens import LONGEST_ROW, MOST_ROWS, MOST_STATEMENTS


def lines(text: str | bytes, dialect: str = "s7-200") -> list[str]:
    """Read without a finding and give the lines."""
    program = read(text, dialect)
    assert program.diagnostics == (), program.diagnostics
    return [line.text for line in program.lines]


def said(text: str | bytes, dialect: str = "s7-200") -> list[tuple[str, Span]]:
    return [(one.code, one.span) for one in read(text, dialect).diagnostics]


AND = ["LD I0.0", "A I0.1", "= Q0.0"]


# One program in every dress.


@pytest.mark.parametrize(
    "text",
    [
        "LD I0.0\nA I0.1\n= Q0.0\n",
        "ld i0.0\na i0.1\n= q0.0",
        "Ld I0.0; A I0.1; = Q0.0",
        "LD I0.0;A I0.1;=Q0.0;",
        "LD I0.0;;\n;\nA I0.1\n\n\n=Q0.0",
        "\tLD\tI0.0\r\n\tA\tI0.1\r\n\t=\tQ0.0\r\n",
        "LD I0.0\r\nA I0.1\r\n=Q0.0",
        "LD I0.0 // an old Mac's line ends\rA I0.1\r=Q0.0\r",
        "ＬＤ　Ｉ０．０；Ａ　Ｉ０．１；＝　Ｑ０．０",
        "ld　i0。0；Ａ Ｉ０.1；=Q0.0",
        "LD I0.0 // start\nA I0.1 // guard\n= Q0.0 // lamp",
        "LD I0.0 (* start *)\nA (* in the middle *) I0.1\n= Q0.0",
        "(* a note\nover LD I0.5\nthree rows *) LD I0.0\nA I0.1\n= Q0.0",
        "LD I0.0 (* a\n*) A I0.1\n= Q0.0",
        "LD I0.0 ／／ 启动\nA I0.1\n= Q0.0",
        "; a whole row of words, LD I0.7\nLD I0.0\nA I0.1\n= Q0.0",
        "；注释 LD\nLD I0.0\nA I0.1\n= Q0.0",
        "LD I0.0 // no (* comment opens here\nA I0.1\n= Q0.0",
        "LD I0.0 (* no // line comment here *)\nA I0.1\n= Q0.0",
        "\ufeffLD I0.0\nA I0.1\n= Q0.0",
        "0 LD I0.0\n1 A I0.1\n2 = Q0.0",
        "0: LD I0.0\n1: A I0.1\n10: = Q0.0",
        "LD\xa0I0.0\nA I0.1\n= Q0.0",
        "### BEGIN SOLUTION\nLD I0.0\nA I0.1\n### END SOLUTION\n= Q0.0",
        "    ### BEGIN SOLUTION\n    LD I0.0\n    A I0.1\n    = Q0.0\n    ### END SOLUTION",
        "# BEGIN SOLUTION\nLD I0.0\nA I0.1\n# END SOLUTION\n= Q0.0",
        "  #BEGIN SOLUTION NO PROMPT\n  LD I0.0\n  A I0.1\n  = Q0.0\n  # end solution\n",
        "U E0.0",
    ],
)
def test_one_program_in_every_dress(text: str) -> None:
    assert lines(text) == (AND if text != "U E0.0" else ["A I0.0"])


def test_german_mnemonics_and_addresses() -> None:
    german = "LD E0.0\nU E0.1\nLDN E0.2\nUN E0.3\nOLD\nO E0.4\nON E0.5\nULD\n= A0.0\nS A0.1, 1\n"
    assert lines(german) == [
        "LD I0.0", "A I0.1", "LDN I0.2", "AN I0.3", "OLD", "O I0.4", "ON I0.5", "ALD", "= Q0.0", "S Q0.1, 1",
    ]  # fmt: skip
    assert lines("ui e0.0; uni e0.1") == ["AI I0.0", "ANI I0.1"]


def test_gx_step_numbers_and_padded_devices() -> None:
    text = "0\tLD\tX000\n1\tOR\tY000\n2\tANI\tX001\n3\tOUT\tY000\n4\tEND\n"
    assert lines(text, "fx") == ["LD X0", "OR Y0", "ANI X1", "OUT Y0", "END"]
    assert lines("LD X0", "fx") == lines("LD X000", "fx") == lines("LD X00", "fx")


def test_the_sign_may_be_glued_to_its_operand() -> None:
    assert lines("=Q0.0") == ["= Q0.0"]
    assert lines("LD %I0.0\nAND(%I0.1\nOR %I0.2)\nST %Q0.0", "neza") == [
        "LD %I0.0", "AND( %I0.1", "OR %I0.2", ")", "ST %Q0.0",
    ]  # fmt: skip
    assert lines("LD %I0.0\nOR( %I0.1\nAND( %I0.2\nOR %I0.3))\nST %Q0.0", "neza")[-3:] == [")", ")", "ST %Q0.0"]


def test_operands_are_separated_by_commas_or_spaces() -> None:
    assert lines("S Q0.0,3") == lines("S Q0.0, 3") == lines("S Q0.0 3") == lines("S Q0.0， 3") == ["S Q0.0, 3"]
    assert lines("S Q0.0, +3") == ["S Q0.0, 3"]
    assert lines("LDS 3") == ["LDS 3"]


@pytest.mark.parametrize("operand", ["0", "1"])
def test_nezas_constants(operand: str) -> None:
    """neza.md: "LD LDN LDR LDF | 0/1 %I %Q %M %S"."""
    assert lines(f"LD {operand}\nST %Q0.0", "neza") == [f"LD {operand}", "ST %Q0.0"]
    assert run(read(f"LD {operand}\nST %Q0.0", "neza"))["%Q0.0"] == operand


# Networks and wrappers.


@pytest.mark.parametrize(
    ("heading", "title"),
    [
        ("Network 1", ""),
        ("NETWORK 1 // motor on", "motor on"),
        ("network 1 //电动机启动", "电动机启动"),
        ("Network 1: motor on", "motor on"),
        ("Network 1 (* motor on *)", "motor on"),
        ("网络 1 // 电动机启动", "电动机启动"),
        ("网络1", ""),
        ("程序段 1：启动", "启动"),
        ("Ｎｅｔｗｏｒｋ　１　／／　启动", "启动"),
        ("  Network 12", ""),
        ("Network", ""),
    ],
)
def test_titles_in_english_and_chinese(heading: str, title: str) -> None:
    program = read(f"{heading}\nLD I0.0\n= Q0.0\n", "s7-200")
    assert program.diagnostics == ()
    assert [(one.title, one.headed, len(one.lines)) for one in program.networks] == [(title, True, 2)]


def test_networks_keep_their_lines() -> None:
    program = read("Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nNetwork 3 // last\nLD I0.1\n= Q0.1\n", "s7-200")
    assert [(one.title, [line.text for line in one.lines]) for one in program.networks] == [
        ("", ["LD I0.0", "= Q0.0"]),
        ("", []),
        ("last", ["LD I0.1", "= Q0.1"]),
    ]


def test_nezas_rungs_are_headings_too() -> None:
    program = read("RUNG 0\nLD %I0.0\nST %Q0.0\nRUNG 1 // second\nLD %I0.1\nST %Q0.1\n", "neza")
    assert program.diagnostics == ()
    assert [one.title for one in program.networks] == ["", "second"]


def test_an_exported_block_is_read_through_its_wrapper() -> None:
    text = (
        "ORGANIZATION_BLOCK MAIN:OB1\r\nTITLE=PROGRAM COMMENTS\r\nVAR\r\nLD : BOOL;\r\nstart AT I0.0 : BOOL;\r\nEND_VAR\r\n"
        "BEGIN\r\nNetwork 1 // NETWORK TITLE\r\nLD I0.0\r\nA I0.1\r\n= Q0.0\r\nEND_ORGANIZATION_BLOCK\r\n"
    )
    program = read(text, "s7-200")
    assert program.diagnostics == ()
    assert [line.text for line in program.lines] == AND
    assert program.networks[0].title == "NETWORK TITLE"
    assert program.lines[0].span == Span(9, 0, 7)


PROJECT = (
    "ORGANIZATION_BLOCK MAIN:OB1\r\nTITLE=PROGRAM COMMENTS\r\nBEGIN\r\nNetwork 1 // NETWORK TITLE\r\n// NETWORK COMMENTS\r\n"
    "LD     I0.0\r\nA      I0.1\r\n=      Q0.0\r\nEND_ORGANIZATION_BLOCK\r\n"
    "SUBROUTINE_BLOCK SBR_0:SBR0\r\nTITLE=SUBROUTINE COMMENTS\r\nBEGIN\r\nNetwork 1 // NETWORK TITLE\r\n{}END_SUBROUTINE_BLOCK\r\n"
    "INTERRUPT_BLOCK INT_0:INT0\r\nTITLE=INTERRUPT COMMENTS\r\nBEGIN\r\nNetwork 1 // NETWORK TITLE\r\n{}END_INTERRUPT_BLOCK\r\n"
)


def test_a_whole_project_is_read_when_only_its_main_block_says_anything() -> None:
    assert lines(PROJECT.format("", "")) == AND


def test_instructions_of_a_subroutine_stand_in_networks_of_their_own() -> None:
    program = read(PROJECT.format("LD I0.5\r\n= Q0.5\r\n", ""), "s7-200")
    assert program.diagnostics == ()
    assert [(one.block, [line.text for line in one.lines]) for one in program.networks] == [
        ("", AND),
        ("SBR0", ["LD I0.5", "= Q0.5"]),
    ]


def test_instructions_of_an_interrupt_program_are_not_the_main_programs() -> None:
    program = read(PROJECT.format("", "LD I0.5\r\n= Q0.5\r\n"), "s7-200")
    assert [line.text for line in program.lines] == AND
    assert [15 <= one.span.row <= 20 for one in program.diagnostics] == [True]
    assert program.diagnostics[0].severity == "error"


@pytest.mark.parametrize("kind", ["VAR", "VAR_INPUT", "VAR_OUTPUT", "VAR_IN_OUT", "VAR_TEMP", "var"])
def test_declared_variables_are_passed_over(kind: str) -> None:
    assert lines(f"{kind}\nLD I0.9 nonsense\nend_var\nLD I0.0\nA I0.1\n= Q0.0") == AND


def test_variables_that_never_end_are_said_to_have_swallowed_the_program() -> None:
    found = said("VAR\nx : BOOL\nLD I0.0\n= Q0.0\n")
    assert [span.row for _, span in found] == [1]


# Bytes.


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "gbk"])
def test_bytes_in_every_usual_encoding(encoding: str) -> None:
    program = read("Network 1 // 启动\r\nLD I0.0 // 按钮\r\nA I0.1\r\n= Q0.0\r\n".encode(encoding), "s7-200")
    assert program.diagnostics == ()
    assert (program.networks[0].title, program.lines[0].comment) == ("启动", "按钮")
    assert [line.text for line in program.lines] == AND


def test_western_bytes_with_and_without_being_told() -> None:
    text = "LD I0.0 // Tür\nA I0.1\n= Q0.0\n"
    assert read(text.encode("cp1252"), "s7-200", encoding="cp1252").lines[0].comment == "Tür"
    assert lines(text.encode("cp1252")) == AND


# Comments are kept where they belong.


def test_comments_stay_with_their_lines() -> None:
    program = read("// first\n(* second *)\nLD I0.0 // behind\n; third\n= Q0.0 (* a *) // b\n// the end\n", "s7-200")
    load, coil = program.lines
    assert (load.above, load.comment) == (("first", "second"), "behind")
    assert (coil.above, coil.comment) == (("third",), "a b")
    assert program.tail == ("the end",)


# Places: rows from 1, columns from 0, in code points of the text as given.


@pytest.mark.parametrize(
    ("text", "code", "span"),
    [
        ("LD I0.0\nADN I0.1\n", "RDR001", Span(2, 0, 3)),
        ("  LD I0.9", "RDR006", Span(1, 5, 9)),
        ("(* 电动机 *) LD I0.9", "RDR006", Span(1, 13, 17)),
        ("(* 𝔸😀 *) LD I0.9", "RDR006", Span(1, 12, 16)),
        ("ＬＤ　Ｉ０．９", "RDR006", Span(1, 3, 7)),
        ("LD I0.0; A I0.9; = Q0.0", "RDR006", Span(1, 11, 15)),
        ("\tLD\tI0.9", "RDR006", Span(1, 4, 8)),
        ("LD I0.0\r\nLD I0.9\r\n", "RDR006", Span(2, 3, 7)),
        ("0 LD I0.9", "RDR006", Span(1, 5, 9)),
        ("=Q0.9", "RDR006", Span(1, 1, 5)),
        ("  A // nothing", "RDR003", Span(1, 2, 3)),
        ("LPS 1", "RDR004", Span(1, 4, 5)),
        ("LD I0.0 I0.1 I0.2", "RDR004", Span(1, 8, 17)),
        ("S Q0.0, 256", "RDR008", Span(1, 8, 11)),
        ("LD I0.0 (* 启动", "RDR009", Span(1, 8, 10)),
        ("启动\x00", "RDR014", Span(1, 2, 3)),
        ("LDI M0.0", "RDR007", Span(1, 4, 8)),
        ("=  I0.1", "RDR012", Span(1, 3, 7)),
        ("LD IO.0", "RDR005", Span(1, 3, 7)),
        ("PID VB100, 0", "RDR002", Span(1, 0, 3)),
    ],
)
def test_a_finding_stands_where_it_is(text: str, code: str, span: Span) -> None:
    assert (code, span) in said(text)


@settings(max_examples=60, deadline=None)
@given(st.text(st.characters(exclude_characters="*()/\r\n\x00", exclude_categories=["Cs", "Cc"]), max_size=20))
def test_columns_count_code_points_after_any_comment(comment: str) -> None:
    text = f"(*{comment}*) LD I0.9"
    at = text.index("I0.9")
    assert ("RDR006", Span(1, at, at + 4)) in said(text)


def test_the_span_of_a_line_reaches_from_its_mnemonic_to_its_last_operand() -> None:
    program = read("  LD   I0.0  // x\n 3 S Q0.0 , 2 ;\n", "s7-200")
    assert [line.span for line in program.lines] == [Span(1, 2, 11), Span(2, 3, 13)]


# All of it at once.


def test_all_slips_are_reported_at_once_in_order() -> None:
    text = "ADN I0.0\nLD\nLD I0.9\nLDI M0.0\nLPS 2\nLDS 9\nPID 1\nLD I00\nLD I0.1\n= I0.0\n(* open"
    assert [(code, span.row) for code, span in said(text)] == [
        ("RDR001", 1), ("RDR003", 2), ("RDR006", 3), ("RDR007", 4), ("RDR004", 5), ("RDR008", 6), ("RDR002", 7),
        ("RDR005", 8), ("RDR012", 10), ("RDR009", 11),
    ]  # fmt: skip
    assert [line.text for line in read(text, "s7-200").lines] == ["LD I0.1", "= I0.0"]


def test_several_slips_on_one_row_each_have_their_place() -> None:
    assert said("LD I0.9; A I0.8; = Q0.9") == [
        ("RDR006", Span(1, 3, 7)),
        ("RDR006", Span(1, 11, 15)),
        ("RDR006", Span(1, 19, 23)),
    ]


@pytest.mark.parametrize(
    ("dialect", "text", "hint"),
    [
        ("s7-200", "ADN I0.0", "AN"),
        ("s7-200", "LDI0.0", "LD I0.0"),
        ("s7-200", "LD IO.0", "I0.0"),
        ("s7-200", "LD I00", "I0.0"),
        ("s7-200", "LD %I0.0", "I0.0"),
        ("fx", "ANNB", "ANB"),
        ("fx", "LD XO", "X0"),
        ("neza", "LD I0.0", "%I0.0"),
    ],
)
def test_the_nearest_thing_is_suggested(dialect: str, text: str, hint: str) -> None:
    (found,) = read(text, dialect).diagnostics
    assert f"Did you mean {hint}" in found.text.en
    assert f"是不是{hint}" in found.text.zh


def test_the_octal_devices_say_why_there_is_no_8() -> None:
    (found,) = read("LD X8", "fx").diagnostics
    assert found.code == "RDR006"
    assert "X10 follows X7" in found.text.en
    assert "X7之后是X10" in found.text.zh
    assert "octal" not in read("LD M9999", "fx").diagnostics[0].text.en


@pytest.mark.parametrize(
    ("dialect", "word"),
    [("s7-200", "PID"), ("s7-200", "LDS="), ("s7-200", "ATCH"), ("s7-200", "hsc"), ("fx", "BMOV"), ("fx", "CJ"),
     ("fx", "from"), ("neza", "MCS")],
)  # fmt: skip
def test_real_instructions_that_are_not_run_are_refused_by_their_own_name(dialect: str, word: str) -> None:
    (found,) = read(f"{word} 1, 2", dialect).diagnostics
    assert found.code == "RDR002"
    assert word.upper() in found.text.en


@pytest.mark.parametrize(("text", "canonical"), [("OUT T0, K10", "OUT T0 K10"), ("out c005 d7", "OUT C5 D7")])
def test_an_fx_timer_or_counter_coil_has_its_preset(text: str, canonical: str) -> None:
    program = read(f"LD X0\n{text}\n", "fx")
    assert program.diagnostics == ()
    assert [line.text for line in program.lines] == ["LD X0", canonical]


def test_a_string_compare_is_no_lds() -> None:
    assert [code for code, _ in said("LDS= VB0, VB10")] == ["RDR002"]


# Too much.


def test_too_many_instructions_too_many_rows_a_too_long_row_and_too_long_a_text_are_said() -> None:
    assert said("LD I0.0\n" * MOST_STATEMENTS) == []
    assert said("LD I0.0\n" * MOST_STATEMENTS + "// the end\n") == []
    assert said("LD I0.0\n" * (MOST_STATEMENTS + 5)) == [("RDR013", Span(MOST_STATEMENTS + 1))]
    assert [code for code, _ in said("// x\n" * (MOST_ROWS + 5))] == ["RDR013"]
    assert said("LD I0.0 //" + "x" * LONGEST_ROW) == [("RDR013", Span(1, LONGEST_ROW, LONGEST_ROW + 10))]
    assert said("LD I0.0 //" + "x" * (LONGEST_ROW - 10)) == []
    assert said(" " * (MOST_CHARACTERS + 1)) == [("RDR013", Span(1))]
    assert MOST_STATEMENTS >= 20_000, "CHECKING, bounds: 20,000 for reading"


PIECES = [
    "LD",
    "A",
    "OLD",
    "LPP",
    "=",
    "(",
    ")",
    "(*",
    "*)",
    "//",
    ";",
    "I0.0",
    "X0",
    "%I0.0",
    "Network 1",
    "AND(",
    ",",
    "\n",
]


@pytest.mark.parametrize("dialect", names())
@settings(max_examples=60, deadline=None)
@given(text=st.text(max_size=120) | st.lists(st.sampled_from(PIECES)).map(" ".join))
def test_anything_at_all_is_read_and_every_finding_is_a_declared_one_in_the_text(dialect: str, text: str) -> None:
    program = read(text, dialect)
    rows = re.split(r"\r\n|\r|\n", text)
    assert program.source == text
    for one in program.diagnostics:
        assert one.code in RULES
        assert 1 <= one.span.row <= len(rows)
        assert 0 <= one.span.start <= one.span.stop <= len(rows[one.span.row - 1])
    assert [one.span for one in program.diagnostics] == sorted(one.span for one in program.diagnostics)


@given(st.binary(max_size=100))
def test_any_bytes_at_all_are_read(data: bytes) -> None:
    assert isinstance(read(data, "s7-200").lines, tuple)


def test_a_family_that_nobody_knows() -> None:
    with pytest.raises(UnknownNameError, match="s7-200"):
        read("LD I0.0", "s7_20")


@pytest.mark.parametrize(
    ("family", "text", "given"),
    [
        ("fx", "MC N0 M100", "MC N0, M100"),
        ("fx", "LD>= D0 K5", "LD>= D0,K5"),
        ("fx", "ADD D0 K5 D10", "ADD D0, K5 D10"),
        ("s7-200", "TON T37, 10", "TON T37 10"),
        ("gutta", "CTU C0, 3", "CTU C0,3"),
    ],
)
def test_each_family_parts_its_operands_as_its_books_do(family: str, text: str, given: str) -> None:
    assert [read(f"{one}\n", family).lines[0].text for one in (text, given)] == [text, text]


def test_a_preset_may_stand_on_a_row_of_its_own() -> None:
    program = read("0 LD X0\n1 OUT T0\n  K10\n4 LD T0\n5 OUT Y0\n", "fx")
    assert program.diagnostics == ()
    assert [line.text for line in program.lines] == ["LD X0", "OUT T0 K10", "LD T0", "OUT Y0"]
    assert program.lines[1].span == Span(2, 2, 8)
    assert [one.code for one in read("LD X0\nK10\nOUT Y0", "fx").diagnostics] == ["RDR004"]
