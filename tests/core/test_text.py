"""Words in two languages, places in a text, bytes that become text, and names that nobody declared."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plcteach.core import text as words
from plcteach.core.diagnostic import RULES, rule
from plcteach.core.errors import PlcTeachError, UnknownNameError, nearest
from plcteach.core.source import Span, decode, half_width
from plcteach.core.text import NOTHING, Text, joined, language, same


@pytest.fixture(autouse=True)
def no_choice(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(words, "_chosen", [])


def test_a_text_within_a_text_speaks_the_same_language() -> None:
    said = Text("{what}丢失", "{what} is lost").format(what=Text("栈顶", "the top"))
    assert said == Text("栈顶丢失", "the top is lost")
    assert Text("{n}层", "{n} levels").format(n=9) == Text("9层", "9 levels")


def test_joined_leaves_empty_parts_out_and_separates_as_each_language_does() -> None:
    parts = [Text("甲", "a"), NOTHING, Text("乙", "b")]
    assert joined(parts) == Text("甲乙", "a b")
    assert joined(parts, "，", "; ") == Text("甲，乙", "a; b")
    assert joined([]) == NOTHING


def test_a_text_as_the_browser_wants_it() -> None:
    assert Text("层", "level").as_dict() == {"zh": "层", "en": "level"}
    assert Text("层", "level").in_("zh") == "层"
    assert Text("层", "level").in_("en") == "level"
    assert same("OLD") == Text("OLD", "OLD")
    assert repr(Text("层", "level")) == "Text('层', 'level')"


@pytest.mark.parametrize(
    ("variables", "wanted"),
    [
        ({}, "en"),
        ({"LANG": "zh_CN.UTF-8"}, "zh"),
        ({"LANG": "de_DE.UTF-8"}, "en"),
        ({"LANG": "zh_CN.UTF-8", "LC_ALL": "C"}, "en"),
        ({"LANG": "en_GB.UTF-8", "PLCTEACH_LANG": "zh"}, "zh"),
        ({"PLCTEACH_LANG": "EN", "LANG": "zh_TW"}, "en"),
    ],
)
def test_the_language_is_the_environments(
    monkeypatch: pytest.MonkeyPatch, variables: dict[str, str], wanted: str
) -> None:
    for name in ("PLCTEACH_LANG", "LC_ALL", "LANG"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert language() == wanted


def test_a_choice_stays_and_another_language_is_refused() -> None:
    assert language("zh") == "zh"
    assert language() == "zh"
    with pytest.raises(ValueError, match="fr"):
        language("fr")
    assert language() == "zh"
    assert language("en") == "en"


@pytest.mark.parametrize(
    ("typed", "plain"),
    [
        ("ＬＤ　Ｉ０．０；", "LD I0.0;"),
        ("＝　Ｑ０．０", "= Q0.0"),
        ("ＡＮＤ（　％Ｉ０．１", "AND( %I0.1"),
        ("S Q0.0、1", "S Q0.0,1"),
        ("LD I0。0", "LD I0.0"),
        ("\ufeffLD\tX0\xa0", " LD X0 "),
        ("电机 LD", "电机 LD"),
    ],
)
def test_what_a_chinese_keyboard_types_is_read_one_character_for_one(typed: str, plain: str) -> None:
    assert half_width(typed) == plain
    assert len(half_width(typed)) == len(typed)


@given(st.text())
def test_half_width_never_changes_the_columns(text: str) -> None:
    assert len(half_width(text)) == len(text)


PROGRAM = "Network 1 // 电动机启动\nLD I0.0\n= Q0.0\n"


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "gbk"])
def test_bytes_become_the_same_text_in_every_encoding(encoding: str) -> None:
    assert decode(PROGRAM.encode(encoding)) == PROGRAM


@pytest.mark.parametrize("mark", [b"\xff\xfe", b"\xfe\xff"])
def test_utf_16_comes_in_both_orders(mark: bytes) -> None:
    order = "utf-16-le" if mark[0] == 0xFF else "utf-16-be"
    assert decode(mark + PROGRAM.encode(order)) == PROGRAM


def test_what_the_caller_says_comes_before_gbk_and_after_utf_8() -> None:
    german = "// Türschütz\nLD I0.0\n"
    assert decode(german.encode("cp1252"), "cp1252") == german
    assert decode(german.encode("utf-8"), "cp1252") == german
    assert decode("// é".encode("cp1252")) == "// é"  # a lone high byte at the end is no GBK


@given(st.binary(max_size=200))
def test_any_bytes_become_some_text(data: bytes) -> None:
    assert isinstance(decode(data), str)


def test_spans_are_in_the_order_of_the_text() -> None:
    assert sorted([Span(2, 0, 1), Span(1, 5, 6), Span(1, 2, 9)]) == [Span(1, 2, 9), Span(1, 5, 6), Span(2, 0, 1)]
    assert repr(Span(3, 1, 4)) == "3:1-4"


def test_an_unknown_name_is_a_lookup_error_that_suggests_the_nearest() -> None:
    error = UnknownNameError("dialect", "s7200", ["s7-200", "fx"])
    assert isinstance(error, LookupError)
    assert isinstance(error, PlcTeachError)
    assert str(error) == "There is no dialect called 's7200'. Did you mean s7-200?"
    assert str(UnknownNameError("dialect", "zzz", ["fx"])) == "There is no dialect called 'zzz'. There is: fx."
    assert len(str(UnknownNameError("dialect", "q" * 10_000, ["fx"]))) < 200


def test_the_nearest_names_come_in_their_own_spelling() -> None:
    assert nearest("anbb", ["ANB", "ORB", "MPS"])[0] == "ANB"
    assert nearest("wholly different", ["ANB"]) == []


def test_rules_are_found_by_their_code_in_any_case() -> None:
    assert rule("stk001") is RULES["STK001"]
    with pytest.raises(UnknownNameError, match="STK001"):
        rule("STK0001")


def test_a_finding_fills_its_places_and_knows_why() -> None:
    found = rule("RDR010").at(Span(3, 1, 2))
    assert (found.code, found.severity, found.span) == ("RDR010", "error", Span(3, 1, 2))
    assert found.why == RULES["RDR010"].why
    assert repr(found).startswith("error RDR010 at 3:1-2: ")
