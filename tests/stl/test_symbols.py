"""Symbol tables as people export them; each diagnostic has a table that triggers it and one that does not.

No vendor's sample is at hand: every table here is ours, shaped after the formats' descriptions.
"""

from __future__ import annotations

import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.diagnostic import RULES
from plcteach.core.source import Span
from plcteach.dialects import dialect
from plcteach.stl import Symbol, read, read_symbols
from plcteach.stl.symbols import Symbols, is_symbols

WANTED = (Symbol("Start", "I0.0", "green button"), Symbol("停止", "I0.1", "红色按钮"), Symbol("Motor 1", "Q0.0"))


@pytest.mark.parametrize(
    "text",
    [
        "Start\tI0.0\tgreen button\n停止\tI0.1\t红色按钮\nMotor 1\tQ0.0\n",
        "Symbol\tAddress\tComment\r\nStart\tI0.0\tgreen button\r\n停止\tI0.1\t红色按钮\r\nMotor 1\tQ0.0\t\r\n",
        "符号\t地址\t注释\nStart\tI0.0\tgreen button\n停止\tI0.1\t红色按钮\nMotor 1\tQ0.0\n",
        '"Symbol"\t"Address"\t"Comment"\n"Start"\t"I0.0"\t"green button"\n"停止"\t"I0.1"\t"红色按钮"\n"Motor 1"\t"Q0.0"\t""\n',
        "Start,I0.0,green button\n停止,I0.1,红色按钮\nMotor 1,Q0.0,\n",
        "Name;Address;Comment\nStart;I0.0;green button\n停止;I0.1;红色按钮\nMotor 1;Q0.0;\n",
        "地址\t符号\t注释\nI0.0\tStart\tgreen button\nI0.1\t停止\t红色按钮\nQ0.0\tMotor 1\n",
        "I0.0\tStart\tgreen button\nI0.1\t停止\t红色按钮\nQ0.0\tMotor 1\n",
        "USER1\n\tSymbol\tAddress\tComment\n1\tStart\tI0.0\tgreen button\n2\t停止\tI0.1\t红色按钮\n3\tMotor 1\tQ0.0\t\n",
        "1\tStart\tI0.0\tgreen button\n2\t停止\tI0.1\t红色按钮\n3\tMotor 1\tQ0.0\t\n",
        '// ours\nStart I0.0 green button\n\n停止 I0.1 红色按钮\n"Motor 1" Q0.0\n',
        " Start \t Ｉ０．０ \t green button\n停止\tI0.1\t红色按钮\n  Motor 1  \tQ0.0\n",
    ],
)
@pytest.mark.parametrize("encoding", [None, "utf-8-sig", "utf-16", "gbk"])
def test_tables_in_every_usual_shape(text: str, encoding: str | None) -> None:
    symbols = read_symbols(text.encode(encoding) if encoding else text)
    assert symbols.diagnostics == ()
    assert tuple(symbols) == symbols.rows == WANTED
    assert len(symbols) == 3


def test_names_that_look_like_addresses_stay_names() -> None:
    assert read_symbols("KM1\tQ0.0\nSB1\tI0.0\n").rows == (Symbol("KM1", "Q0.0"), Symbol("SB1", "I0.0"))


def test_a_word_is_found_in_any_case_and_width_with_or_without_quotes() -> None:
    symbols = read_symbols("Start button\tI0.0\n阀（左）\tQ0.1\nÄra\tM0.0\n")
    for word in ("Start button", '"START BUTTON"', "ｓｔａｒｔ　ｂｕｔｔｏｎ", "“Start Button”"):
        assert symbols.find(word) == "I0.0"
    assert symbols.find("阀(左)") == symbols.find("阀（左）") == "Q0.1"
    assert symbols.find("äRA") == "M0.0"
    assert symbols.find("I0.0") is None
    assert symbols.find("") is None


def test_an_address_is_found_in_any_spelling() -> None:
    symbols = read_symbols("灯\tY000\n泵\tX0010\n%阀\t%Q0.3\n")
    assert (symbols.name("Y0"), symbols.name("y000"), symbols.name("Y00")) == ("灯", "灯", "灯")
    assert (symbols.name("X10"), symbols.name("X1"), symbols.name("%q0.3")) == ("泵", "", "%阀")


BAD_AND_GOOD = {
    "SYM001": ("Start\tI0.0\nStop\t\n", "Start\tI0.0\nStop\tI0.1\n", Span(2, 0, 4)),
    "SYM002": ("Start\tI0.0\n\tI0.1\n", "Start\tI0.0\nStop\tI0.1\n", Span(2, 0, 5)),
    "SYM003": ("Start\tI0.0\nSTART\tI0.1\n", "Start\tI0.0\nSTART\tI0.0\n", Span(2, 0, 10)),
    "SYM004": ("Start\tI0.0\nBegin\tI0.0\n", "Start\tI0.0\nBegin\tI0.1\n", Span(2, 0, 10)),
    "SYM005": ("Start\tI0.0\nStop\tbutton\n", "Start\tI0.0\nStop\tI0.1\n", Span(2, 0, 11)),
}


@pytest.mark.parametrize("code", BAD_AND_GOOD)
def test_each_diagnostic_has_its_table_and_the_mended_one_has_none(code: str) -> None:
    bad, good, span = BAD_AND_GOOD[code]
    (one,) = read_symbols(bad).diagnostics
    assert (one.code, one.span) == (code, span)
    assert one.severity == RULES[code].severity
    assert "{" not in one.text.en + one.text.zh
    assert read_symbols(good).diagnostics == ()


def test_every_code_about_symbols_is_among_them() -> None:
    assert set(BAD_AND_GOOD) == {code for code in RULES if code.startswith("SYM")}


def test_the_first_of_two_counts_and_the_other_is_told() -> None:
    symbols = read_symbols("Start\tI0.0\nstart\tI0.1\nGo\tI0.0\n")
    assert symbols.find("START") == "I0.0"
    assert symbols.name("I0.0") == "Start"
    assert symbols.find("go") == "I0.0"
    said, shared = symbols.diagnostics
    assert "row 1" in said.text.en
    assert "I0.0" in said.text.en
    assert "I0.1" in said.text.zh
    assert "Start" in shared.text.en


def test_rows_that_cannot_be_read_are_told_and_the_others_kept() -> None:
    symbols = read_symbols("Start\tI0.0\n\x00\x01\nonly\nStop\tI0.1\n")
    assert [one.name for one in symbols] == ["Start", "Stop"]
    assert [(one.code, one.span.row) for one in symbols.diagnostics] == [("RDR014", 2), ("SYM001", 3)]
    assert read_symbols("x" * 2_000_001).diagnostics[0].code == "RDR013"
    assert read_symbols("a\tI0.0\n" * 40_002).diagnostics[-1].code == "RDR013"


def test_a_headed_table_is_known_as_one_and_a_program_is_not() -> None:
    assert is_symbols("Symbol\tAddress\tComment\nStart\tI0.0\t\n")
    assert is_symbols("符号,地址\n启动,I0.0\n")
    assert not is_symbols("Network 1 // Symbol, Address\nLD I0.0\n= Q0.0\n")
    assert not is_symbols("LD X0\nOUT Y0\n")
    assert not is_symbols("")


def test_symbols_stand_in_a_program() -> None:
    symbols = read_symbols("Start button\tI0.0\n电机\tQ0.0\n停止\tI0.1\n")
    program = read('LD "start BUTTON"\nO 电机\nAN 停止\n= "电机"\n', "s7-200", symbols=symbols)
    assert program.diagnostics == ()
    assert [line.text for line in program.lines] == ["LD I0.0", "O Q0.0", "AN I0.1", "= Q0.0"]
    assert "RDR005" in {one.code for one in read('LD "nobody"\n= Q0.0', "s7-200", symbols=symbols).diagnostics}


@settings(max_examples=100, deadline=None)
@given(st.text(st.sampled_from('\t,; "\nIQ0.1启ab'), max_size=80))
def test_any_table_gives_symbols_that_are_found_again(text: str) -> None:
    symbols = read_symbols(text)
    assert isinstance(symbols, Symbols)
    for one in symbols:
        assert symbols.find(one.name) == one.address
        assert symbols.name(one.address)


@settings(max_examples=50, deadline=None)
@given(
    st.lists(
        st.text(st.characters(categories=["L", "N"], exclude_characters="ﬀ"), min_size=1, max_size=9),
        min_size=1,
        max_size=20,
        unique_by=str.casefold,
    )
)
def test_names_of_any_script_are_found(names: list[str]) -> None:
    symbols = read_symbols("Symbol\tAddress\n" + "".join(f"{name}\tM{at}.0\n" for at, name in enumerate(names)))
    family = dialect("s7-200")
    for at, name in enumerate(names):
        found = symbols.find(name)
        assert found is not None
        assert family.address(found) == family.address(f"M{at}.0") or symbols.diagnostics


@pytest.mark.parametrize(
    "text", ["a" * 1_900_000, "\t" * 1_900_000, '"' * 1_900_000, "a\tI0.0\n" * 200_000, "a b\n" * 400_000]
)
def test_long_tables_are_read_soon(text: str) -> None:
    begun = time.monotonic()
    read_symbols(text)
    assert time.monotonic() - begun < 30  # a guard against hanging, no measurement
