"""Files that people have: exported projects, GX Works2 lists as a table, PL7-style listings.

No vendor's sample is at hand: every file here is ours, shaped after the formats' descriptions.
"""

from __future__ import annotations

import csv
import io
import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.diagnostic import errors
from plcteach.core.source import Span, decode
from plcteach.stl import read, write, write_bytes
from plcteach.stl.listing import cells, layout_of
from plcteach.stl.tokens import Heading, Statement, Tokens, cut

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time


def words(tokens: Tokens) -> list[list[str]]:
    return [[word.text for word in item.words] for item in tokens.items if isinstance(item, Statement)]


def headings(tokens: Tokens) -> list[tuple[str, str]]:
    return [(item.title, item.block) for item in tokens.items if isinstance(item, Heading)]


def texts(program) -> list[tuple[str, str, list[str]]]:
    return [(one.block, one.title, [line.text for line in one.lines]) for one in program.networks]


# Exported projects


PROJECT = """ORGANIZATION_BLOCK MAIN:OB1
TITLE=PROGRAM COMMENTS
// What the program is for
BEGIN
Network 1 // start and stop
// seal-in
LD     I0.0
O      Q0.0
AN     I0.1
=      Q0.0
Network 2
LD     Q0.0
CALL   SBR0
END_ORGANIZATION_BLOCK
SUBROUTINE_BLOCK Pump:SBR0
TITLE=SUBROUTINE COMMENTS
VAR_INPUT
level : BOOL;
END_VAR
BEGIN
Network 1 // pump
LD     I0.2
=      Q0.2
Network 2
LD     I0.3
=      Q0.3
END_SUBROUTINE_BLOCK
SUBROUTINE_BLOCK SBR_1:SBR01
TITLE=SUBROUTINE COMMENTS
BEGIN
LD     I0.4
=      Q0.4
END_SUBROUTINE_BLOCK
INTERRUPT_BLOCK INT_0:INT0
TITLE=INTERRUPT COMMENTS
BEGIN
Network 1
{}END_INTERRUPT_BLOCK
""".replace("\n", "\r\n")


def test_each_network_of_a_project_knows_its_subroutine() -> None:
    program = read(PROJECT.format(""), "s7-200")
    assert not errors(program.diagnostics)
    assert texts(program) == [
        ("", "start and stop", ["LD I0.0", "O Q0.0", "AN I0.1", "= Q0.0"]),
        ("", "", ["LD Q0.0", "CALL SBR0"]),
        ("SBR0", "pump", ["LD I0.2", "= Q0.2"]),
        ("SBR0", "", ["LD I0.3", "= Q0.3"]),
        ("SBR1", "", ["LD I0.4", "= Q0.4"]),
    ]
    assert program.lines[0].above == ("What the program is for", "seal-in")


def test_a_subroutine_keeps_the_name_by_which_it_may_be_called() -> None:
    assert cut(PROJECT, closers=False).blocks == {"PUMP": "SBR0", "SBR_1": "SBR1"}
    named = cut("SUBROUTINE_BLOCK 泵\nLD I0.0\nEND_SUBROUTINE_BLOCK\nSUBROUTINE_BLOCK\nLD I0.1\n", closers=False)
    assert named.blocks == {"泵": "SBR0", "SBR1": "SBR1"}
    assert headings(named) == [("", "SBR0"), ("", "SBR1")]


def test_only_an_interrupt_program_is_not_run_and_that_is_said_once() -> None:
    text = PROJECT.format("LD I0.5\r\n= Q0.5\r\n")
    (one,) = read(text, "s7-200").diagnostics
    rows = text.split("\r\n")
    assert (one.code, one.severity, one.span) == ("RDR018", "error", Span(rows.index("LD I0.5") + 1, 0, 7))
    assert f"row {rows.index('INTERRUPT_BLOCK INT_0:INT0') + 1} " in one.text.en
    assert "中断" in one.text.zh


def test_what_follows_a_subroutine_is_the_main_program_again() -> None:
    text = "LD I0.0\n= Q0.0\nSUBROUTINE_BLOCK a:SBR3\nLD I0.1\n= Q0.1\nEND_SUBROUTINE_BLOCK\nLD I0.2\n= Q0.2\n"
    assert texts(read(text, "s7-200")) == [
        ("", "", ["LD I0.0", "= Q0.0"]),
        ("SBR3", "", ["LD I0.1", "= Q0.1"]),
        ("", "", ["LD I0.2", "= Q0.2"]),
    ]


def test_a_project_is_written_as_it_is_exported() -> None:
    program = read(
        "Network 1 // a\nLD I0.0 // b\n= Q0.0\nSUBROUTINE_BLOCK p:SBR4\nNetwork 9\nLD I0.1\n= Q0.1\n", "s7-200"
    )
    assert write(program, "export") == (
        "ORGANIZATION_BLOCK MAIN:OB1\r\nTITLE=\r\nBEGIN\r\nNetwork 1 // a\r\nLD I0.0 // b\r\n= Q0.0\r\n"
        "END_ORGANIZATION_BLOCK\r\nSUBROUTINE_BLOCK SBR_4:SBR4\r\nTITLE=\r\nBEGIN\r\nNetwork 1\r\nLD I0.1\r\n= Q0.1\r\n"
        "END_SUBROUTINE_BLOCK\r\n"
    )
    assert write(program) == (
        "Network 1 // a\nLD I0.0 // b\n= Q0.0\n"
        "SUBROUTINE_BLOCK SBR_4:SBR4\nNetwork 1\nLD I0.1\n= Q0.1\nEND_SUBROUTINE_BLOCK\n"
    )


def test_a_list_without_headings_is_exported_with_one() -> None:
    assert "BEGIN\r\nNetwork 1\r\nLD I0.0\r\n" in write(read("LD I0.0\n= Q0.0\n", "s7-200"), "export")
    assert "Network" not in write(read("LD X0\nOUT Y0\n", "fx"), "export")


@pytest.mark.parametrize("encoding", [None, "gbk", "utf-8-sig", "utf-16"])
def test_an_exported_file_comes_back_from_its_bytes(encoding: str | None) -> None:
    program = read("Network 1 // 启动\nLD I0.0 // 按钮\n= Q0.0\n", "s7-200")
    data = write_bytes(program, "export", encoding)
    assert read(data, "s7-200") == program
    assert data.count(b"\r\x00\n\x00" if encoding == "utf-16" else b"\r\n") == 7


# GX Works2


def table(*rows: list[str], delimiter: str = "\t", quoting: int = csv.QUOTE_ALL) -> str:
    """Write rows with Python's own csv module."""
    out = io.StringIO()
    csv.writer(out, delimiter=delimiter, quoting=quoting).writerows(rows)
    return out.getvalue()


TOP = (["MAIN"], ["PLC Information:", "FX3U/FX3UC"])
HEAD = ["Step No.", "Line Statement", "Instruction", "I/O(Device)", "Blank", "P/I Statement", "Note"]
FLICKER = (
    ["", "flicker", "", "", "", "", ""],
    ["0", "", "LD", "X4", "", "", ""],
    ["1", "", "ANI", "T31", "", "", ""],
    ["2", "", "OUT", "T30", "", "", "10 s dark"],
    ["", "", "", "K100", "", "", ""],
    ["5", "", "LD", "T30", "", "", ""],
    ["6", "", "OUT", "Y001", "", "", 'lamp, "big"'],
    ["7", "", "END", "", "", "", ""],
)  # fmt: skip
FLICKER_WORDS = [["LD", "X4"], ["ANI", "T31"], ["OUT", "T30", "K100"], ["LD", "T30"], ["OUT", "Y001"], ["END"]]


@pytest.mark.parametrize("top", [(*TOP, HEAD), (HEAD,), TOP, ()], ids=["all", "head", "names", "bare"])
@pytest.mark.parametrize(
    ("delimiter", "quoting"),
    [
        ("\t", csv.QUOTE_ALL),
        (",", csv.QUOTE_ALL),
        (";", csv.QUOTE_ALL),
        ("\t", csv.QUOTE_MINIMAL),
        (",", csv.QUOTE_MINIMAL),
    ],
)
def test_a_table_is_noticed_and_read(delimiter: str, quoting: int, top: tuple[list[str], ...]) -> None:
    tokens = cut(table(*top, *FLICKER, delimiter=delimiter, quoting=quoting), closers=False)
    assert words(tokens) == FLICKER_WORDS
    statements = [one for one in tokens.items if isinstance(one, Statement)]
    assert [one.comment for one in statements] == ["", "", "10 s dark", "", 'lamp, "big"', ""]
    assert statements[0].above == ("flicker",)


def test_a_further_operand_stands_in_its_own_row_and_column() -> None:
    tokens = cut(table(*TOP, HEAD, *FLICKER), closers=False)
    out = next(one for one in tokens.items if isinstance(one, Statement) and one.comment == "10 s dark")
    assert [(word.text, word.span) for word in out.words] == [
        ("OUT", Span(7, 8, 11)),
        ("T30", Span(7, 14, 17)),
        ("K100", Span(8, 10, 14)),
    ]
    rows = table(*TOP, HEAD, *FLICKER).split("\r\n")
    assert [rows[word.span.row - 1][word.span.start : word.span.stop] for word in out.words] == ["OUT", "T30", "K100"]


def test_the_whole_way_of_a_table_from_bytes_to_a_program() -> None:
    data = table(*TOP, HEAD, *FLICKER).encode("utf-16")
    program = read(data, "fx")
    assert not errors(program.diagnostics)
    assert [line.text for line in program.lines][-2:] == ["OUT Y1", "END"]
    again = write_bytes(program, "csv")
    assert again.startswith(b'\xff\xfe"\x00M\x00')
    assert read(again, "fx") == program


@pytest.mark.parametrize(
    "head",
    [
        ["步号", "行间声明", "指令", "I/O（软元件）", "空白", "P/I声明", "注解"],
        ["ステップ番号", "行間ステートメント", "命令", "I/O(デバイス)", "空き", "P/Iステートメント", "ノート"],
        ["STEP", "STATEMENT", "INSTRUCTION", "DEVICE", "BLANK", "P/I STATEMENT", "NOTE"],
    ],
)
def test_heads_in_other_languages(head: list[str]) -> None:
    assert words(cut(table(head, *FLICKER), closers=False)) == FLICKER_WORDS


def test_columns_are_found_by_their_heads_in_any_order() -> None:
    text = table(["Note", "Device", "Instruction", "Step"], ["lamp", "X0", "LD", "0"], ["", "Y0", "OUT", "1"])
    assert words(cut(text, closers=False)) == [["LD", "X0"], ["OUT", "Y0"]]


def test_three_columns_without_heads_are_step_instruction_device() -> None:
    text = table(["0", "LD", "X0"], ["1", "OUT", "T0"], ["", "", "K10"])
    assert words(cut(text, closers=False)) == [["LD", "X0"], ["OUT", "T0", "K10"]]


def test_nothing_of_a_table_is_lost() -> None:
    text = table(
        HEAD, ["LD", "", "", "X0", "", "", ""], ["", "", "", "", "", "P note", "n"], ["1", "", "", "", "K7", "", ""]
    )
    tokens = cut(text, closers=False)
    assert words(tokens) == [["LD", "X0", "K7"]]
    assert tokens.tail == ("P note", "n")
    lonely = table(HEAD, ["", "", "", "K10", "", "", ""])
    assert words(cut(lonely, closers=False)) == [["K10"]]
    assert errors(read(lonely, "fx").diagnostics)


@pytest.mark.parametrize(
    ("text", "dialect"),
    [
        ('LD "Start", "Stop"\n', "s7-200"),
        ("%DR0: OUT=%Q0.0,%Q0.1,%Q0.2 STEPS=000,100,101,010,110,111,001\n", "neza"),
        ("0\tLD\tX0\n1\tOUT\tY0\n", "fx"),
        ("// Instruction, device, and more\nLD I0.0\n", "s7-200"),
        ("\t\t\t\t\t\t\tLD I0.0\n", "s7-200"),
        ("", "fx"),
    ],
)
def test_other_texts_are_no_tables(text: str, dialect: str) -> None:
    assert dialect
    assert layout_of(text.split("\n")) is None


PLAIN = st.text(st.sampled_from("ab '\"“,;\t，、x启1"), max_size=8)


@settings(max_examples=300, deadline=None)
@given(
    st.lists(PLAIN, min_size=1, max_size=6),
    st.sampled_from("\t,;"),
    st.sampled_from([csv.QUOTE_ALL, csv.QUOTE_MINIMAL]),
)
def test_cells_are_what_the_csv_module_writes(row: list[str], delimiter: str, quoting: int) -> None:
    out = io.StringIO()
    csv.writer(out, delimiter=delimiter, quoting=quoting, lineterminator="").writerow(row)
    found = list(cells(out.getvalue(), delimiter))
    assert [cell.text for cell in found] == row
    for cell in found:
        if cell.exact:
            assert out.getvalue()[cell.start : cell.start + len(cell.text)] == cell.text


def test_a_quote_that_never_ends_ends_with_its_row() -> None:
    assert [cell.text for cell in cells('"LD\tX0', "\t")] == ["LD\tX0"]
    assert [cell.text for cell in cells('"LD" x\t"X0"', "\t")] == ["LD x", "X0"]


def test_a_statement_may_say_what_looks_like_a_heading() -> None:
    program = read("Network 1 // a\n// Network 2\n// ; b\nLD X0\nOUT Y0 // SUBROUTINE_BLOCK\n", "fx")
    assert program.lines[0].above == ("Network 2", "; b")
    assert read(write(program, "csv"), "fx") == program


# PL7


def test_a_pl7_listing() -> None:
    text = (
        "(* lamp\n   and more *)\nRUNG 0 (* first *)\n000 LD %I0.0 (* button *)\n001 AND( %I0.1\n002 OR %I0.2\n003 )\n"
        "004 ST %Q0.0\nRUNG 1\n%L1:\n005 LD %I0.1\n006 (* alone *)\n007 ST %Q0.1\n"
    )
    tokens = cut(text, closers=True)
    assert headings(tokens) == [("first", ""), ("", "")]
    assert words(tokens) == [
        ["000", "LD", "%I0.0"],
        ["001", "AND(", "%I0.1"],
        ["002", "OR", "%I0.2"],
        [")"],
        ["004", "ST", "%Q0.0"],
        ["%L1:"],
        ["005", "LD", "%I0.1"],
        ["007", "ST", "%Q0.1"],
    ]
    assert tokens.items[1].above == ("lamp", "and more")
    assert tokens.items[-1].above == ("alone",)


def test_expressions_labels_and_configuration_arrive_word_for_word() -> None:
    text = (
        "%TM0: TYPE=TON TB=10ms P=100 ADJ=N\n%DR0: OUT=%Q0.0,%Q0.1 STEPS=00,10\nSR0:\n[ %MW0 := %MW1 + 5 ]\n"
        "[%MW2:=(%MW1 + 5)*2]\nOR( [%DR0.S=1])\nAND [ %MW0 > (3) ]\n"
    )
    assert words(cut(text, closers=True)) == [
        ["%TM0:", "TYPE=TON", "TB=10ms", "P=100", "ADJ=N"],
        ["%DR0:", "OUT=%Q0.0", "%Q0.1", "STEPS=00", "10"],
        ["SR0:"],
        ["[", "%MW0", ":=", "%MW1", "+", "5", "]"],
        ["[%MW2:=(%MW1", "+", "5)*2]"],
        ["OR(", "[%DR0.S=1]"],
        [")"],
        ["AND", "[", "%MW0", ">", "(3", ")", "]"],
    ]


def test_a_pl7_listing_is_written() -> None:
    program = read("RUNG 0 // first\n// above\nLD %I0.0 // b *) c\nAND( %I0.1\n)\nST %Q0.0 // d\n// end\n", "neza")
    assert write(program, "pl7") == (
        "RUNG 0 (* first *)\n(* above *)\n000 LD %I0.0 // b *) c\n001 AND( %I0.1\n002 )\n003 ST %Q0.0 (* d *)\n(* end *)\n"
    )


WHOLE = {
    "neza": (
        "(* three motors *)\n%TM0: TYPE=TON TB=1s P=5\n%DR0: OUT=%Q0.0,%Q0.1 STEPS=00,10\nRUNG 0 (* start *)\n000 LD %I0.0\n"
        "001 OR( %Q0.1\n002 AND [%DR0.S=1]\n003 )\n004 ST %Q0.1\nRUNG 1\nBLK %TM0\nLD %Q0.1\nIN\nOUT_BLK\nLD Q\nST %Q0.2\n"
        "END_BLK\nLD 1\n[ %MW0 := %MW1 + 5 ]\nJMPC %L1\n%L1:\nLD %I0.2\nSR0\nEND\nSR0:\nLD %I0.3\nST %Q0.3\nRET\n"
    ),
    "fx": "LD X4\nOUT T30 K100\nLD= D0 K5\nOR X1\nADDP D0 K1 D2\nLD M8002\nMOV K7 K2M0 // set\nEND\n",
    "s7-200": "Network 1 // compare\nLDW>= VW10, +100\nMOVW 16#0F, VW2\nTON T37, 5\nSUBROUTINE_BLOCK a:SBR2\nLD I0.0\nCRET\n",
}


@pytest.mark.parametrize("name", WHOLE)
@pytest.mark.parametrize("form", ["plain", "export", "csv", "pl7"])
def test_words_blocks_and_labels_survive_in_every_form(name: str, form: str) -> None:
    program = read(WHOLE[name], name)
    assert program.diagnostics == ()
    assert read(write_bytes(program, form), name) == program


# Symbols in double quotes


def test_a_word_in_double_quotes_may_hold_anything() -> None:
    text = 'LD "Start button"\nA “启动, 按钮；//”;= "a (* b"\n="Lamp" // "x\nS "q",2\n'
    tokens = cut(text, closers=True)
    assert words(tokens) == [
        ["LD", '"Start button"'],
        ["A", '"启动, 按钮;//"'],
        ["=", '"a (* b"'],
        ["=", '"Lamp"'],
        ["S", '"q"', "2"],
    ]
    assert tokens.items[0].words[1].span == Span(1, 3, 17)
    assert tokens.items[3].comment == '"x'
    assert tokens.diagnostics == []


def test_a_quote_that_is_never_closed_takes_nothing_with_it() -> None:
    assert words(cut('LD "I0.0 ; = Q0.0\nLD I0.1', closers=False)) == [["LD", '"I0.0'], ["=", "Q0.0"], ["LD", "I0.1"]]
    assert errors(read('LD "I0.0\n= Q0.0', "s7-200").diagnostics)


def test_symbols_in_quotes_go_through_a_table_too() -> None:
    text = table(HEAD, ["0", "", "LD", '"Start ""it"" button"', "", "", ""], ["1", "", "OUT", "Y0", "", "", ""])
    (load, _) = [one for one in cut(text, closers=False).items if isinstance(one, Statement)]
    assert load.words[0].text == "LD"
    assert text.split("\r\n")[1][slice(load.words[1].span.start, load.words[1].span.stop)].startswith('""Start')


# Texts that nobody should write


@pytest.mark.parametrize(
    "text",
    [
        '"' * 1_900_000,
        ('LD "' + '"a' * 900 + "\n") * 1_000,
        ('"' + "a;" * 900 + "\n") * 1_000,
        '"0"\t"LD"\t"X0"\n' + '"' * 1_900_000,
        '"0"\t"LD"\t"X0"\n' + ('""' * 900 + "\n") * 1_000,
        table(HEAD) + "\t" * 1_900_000,
        table(HEAD) + ("\t" * 1_900 + "\n") * 1_000,
        table(HEAD) + '"","","K1"\n' * 100_000,
        table(HEAD, *[["", "", "", "K1", "", "", ""]] * 30_000),
        "SUBROUTINE_BLOCK " + "x" * 1_900_000,
        "SUBROUTINE_BLOCK a\nLD I0.0\n" * 30_000,
    ],
    ids=range(11),
)
def test_long_texts_with_quotes_and_tables_are_cut_soon(text: str) -> None:
    begun = time.monotonic()
    cut(text, closers=True)
    assert time.monotonic() - begun < 30  # a guard against hanging, no measurement


@settings(max_examples=200, deadline=None)
@given(st.text(st.sampled_from('"\t,;\n LDX01()[]*/:'), max_size=120))
def test_anything_is_cut_and_what_is_understood_survives(text: str) -> None:
    program = read(text, "fx")
    for form in ("plain", "csv", "pl7"):
        assert read(write(program, form), "fx") == program


def test_a_table_is_decoded_before_it_is_read() -> None:
    assert decode(write_bytes(read("LD X0\nOUT Y0\n", "fx"), "csv")).startswith('"MAIN"\r\n"PLC Information:"\t')
