"""A card for every instruction of every family: its symbol, example, figure and sentence, in two languages, and no hole for a script."""

from __future__ import annotations

import re
from dataclasses import replace
from xml.etree import ElementTree as ET

import pytest

from plcteach import dialects
from plcteach.core import text as words
from plcteach.core.text import Text
from plcteach.dialects import dialect, families
from plcteach.figure.card import Card

EVERY = [(family.name, row.mnemonic) for family in families() for row in family.insns]
IN_LADDERS = {
    "s7-200": "LD LDN A AN O ON NOT = S R ALD OLD LPS LRD LPP",
    "fx": "LD LDI LDP LDF AND ANI ANDP ANDF OR ORI ORP ORF INV ANB ORB MPS MRD MPP OUT SET RST",
    "neza": "LD LDN LDR LDF AND ANDN ANDR ANDF OR ORN ORR ORF N AND( AND(N AND(R AND(F OR( OR(N OR(R OR(F MPS MRD MPP ST STN S R",
    "gutta": "LD LDN A AN O ON NOT ALD OLD LPS LRD LPP = S R",
}
"""What a ladder drawing has a sign or wires for."""


def card(name: str, mnemonic: str) -> Card:
    family = dialect(name)
    return Card(family, family.insn(mnemonic))


@pytest.mark.parametrize("lang", ["zh", "en"])
@pytest.mark.parametrize(("name", "mnemonic"), EVERY)
def test_a_card_has_its_sentence_form_operands_effect_example_and_figures(name: str, mnemonic: str, lang: str) -> None:
    one = card(name, mnemonic)
    text, html = one.text(lang), one.html(lang)
    assert text.startswith(f"{one.name}  {one.insn.title.in_(lang)}")
    assert one.name.startswith(mnemonic)
    assert one.insn.effect.text in text
    for operand in one.insn.operands:
        assert operand.name in text
    example = one.dialect.example(mnemonic)
    assert any(part.startswith(one.insn.word.rstrip(":")) for part in example.split("; "))
    assert example in text
    assert html.count("<svg") == html.count("</svg>") >= 2
    assert "{" not in re.sub(r"<style.*?</style>", "", text)
    chinese = any("\u4e00" <= sign <= "\u9fff" for sign in text)
    assert chinese == (lang == "zh")


@pytest.mark.parametrize(("name", "mnemonic"), EVERY)
def test_a_cards_html_is_well_formed(name: str, mnemonic: str) -> None:
    for lang in ("zh", "en"):
        ET.fromstring(f"<div>{card(name, mnemonic).html(lang)}</div>")  # noqa: S314


@pytest.mark.parametrize(
    ("name", "mnemonic"), [(name, one) for name, all_ in IN_LADDERS.items() for one in all_.split()]
)
def test_what_a_ladder_can_draw_has_its_symbol(name: str, mnemonic: str) -> None:
    scene = card(name, mnemonic).symbol()
    assert scene is not None
    assert card(name, mnemonic).html("en").count("<svg") == 3


@pytest.mark.parametrize(
    ("name", "mnemonic", "en"),
    [
        ("s7-200", "LD", "contact instruction"),
        ("s7-200", "=", "coil instruction"),
        ("s7-200", "OLD", "stack instruction"),
        ("s7-200", "LDS", "stack instruction"),
        ("fx", "END", "program control instruction"),
        ("fx", "NOP", "other instruction"),
        ("s7-200", "TON", "block instruction"),
        ("s7-200", "MOVW", "word instruction"),
        ("fx", "PLS", "coil instruction"),
        ("gutta", "P", "contact instruction"),
        ("neza", "STN", "coil instruction"),
    ],
)
def test_the_class_is_the_books(name: str, mnemonic: str, en: str) -> None:
    assert card(name, mnemonic).kind.en == en


def test_the_figure_on_the_card_of_old_is_the_books() -> None:
    text = card("s7-200", "OLD").text("zh")
    assert "执行前: S1 S0 iv0 iv1 iv2 iv3 iv4 iv5 iv6" in text
    assert "执行后: S2 iv0 iv1 iv2 iv3 iv4 iv5 iv6 x" in text


def test_number_operands_say_their_range() -> None:
    assert "0 to 8" in card("s7-200", "LDS").text("en")
    assert "1到255" in card("s7-200", "S").text("zh")


def test_nothing_on_a_card_can_become_a_tag() -> None:
    family = dialect("s7-200")
    hostile = replace(
        family, title=Text("<script>标题", "<script>title"), examples=("LD I0.0; = Q0.0",), kinds={
            name: replace(kind, title=Text("<b>位", "<b>bit")) for name, kind in family.kinds.items()
        }
    )  # fmt: skip
    row = replace(family.insn("LD"), title=Text("<img>装载", "<img>load"))
    for lang in ("zh", "en"):
        html = Card(hostile, row).html(lang)
        assert "&lt;script&gt;" in html
        for tag in ("<script", "<img", "<b>"):
            assert tag not in html


def test_a_card_shows_itself_in_the_language_in_force(monkeypatch: pytest.MonkeyPatch) -> None:
    one = card("fx", "ANB")
    for lang in ("zh", "en"):
        monkeypatch.setattr(words, "_chosen", [lang])
        assert repr(one) == one.text(lang)
        assert one._repr_html_() == one.html(lang)


def test_every_mnemonic_of_every_dialect_has_its_example() -> None:
    for name in dialects.names():
        family = dialect(name)
        assert [row.mnemonic for row in family.insns if not family.example(row.mnemonic)] == []
    assert dialect("fx").example("NOSUCH") == ""
