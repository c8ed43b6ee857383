"""Advice on style: given where a list could be written better, never on a right textbook list, and never as an error."""

from __future__ import annotations

import sys
from itertools import product
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.check.lint import lint
from plcteach.core.diagnostic import RULES
from plcteach.dialects import families
from plcteach.exercises import exercise, ids
from plcteach.ladder.lower import lower
from plcteach.machine import run
from plcteach.stl import read

sys.path.insert(0, str(Path(__file__).parents[1] / "ladder"))
from random_ladders import FAMILIES, ladders

TESTS = Path(__file__).parents[1]
STYLE = sorted(code for code, row in RULES.items() if row.style)


def styles(text: str, name: str) -> list[tuple[str, int]]:
    return [(one.code, one.span.row) for one in lint(read(text.replace("; ", "\n"), name)) if RULES[one.code].style]


def test_advice_is_information_and_names_its_lesson_and_its_idea() -> None:
    assert {"STK007", "STK008", "STY001", "STY002"} <= set(STYLE)
    for code in STYLE:
        assert RULES[code].severity == "info"
        assert RULES[code].misconceptions
        assert RULES[code].lesson >= 0


@pytest.mark.parametrize("code", [code for code in STYLE if code.startswith("STY")])
def test_each_has_a_sample_in_every_family(code: str) -> None:
    for family in families():
        wanted = any(sample.code == code for sample in family.samples)
        assert wanted or family.name.startswith("s7-200-"), family.name


@pytest.mark.parametrize(
    ("name", "text", "wanted"),
    [
        ("s7-200", "LD I0.0; O I0.3; LD I0.1; A I0.2; ALD; = Q0.0", ("STY001", 3)),
        ("s7-200", "LD I0.0; A I0.3; LDN I0.1; O I0.2; ON I0.4; OLD; = Q0.0", ("STY001", 3)),
        ("fx", "LD X0; OR X3; LDP X1; ANDF X2; ANB; OUT Y0", ("STY001", 3)),
        ("gutta", "LD I0.0; LD I0.1; O I0.2; OLD; = Q0.0", ("STY001", 2)),
        ("neza", "LD %I0.0; OR(N %I0.1; ORN %I0.2; ); ST %Q0.0", ("STY001", 2)),
        ("neza", "LD %I0.0; AND( %I0.1; ); ST %Q0.0", ("STK008", 2)),
        ("neza", "LD %I0.0; OR(R %I0.1; ); ST %Q0.0", ("STK007", 2)),
        ("s7-200", "LD I0.0; LPS; = Q0.0; S Q0.1, 1; LRD; = Q0.2; LPP; = Q0.3", ("STY002", 2)),
        ("fx", "LD X0; MPS; OUT Y0; MPP; OUT Y1; LD X1; OUT Y2", ("STY002", 2)),
    ],
)
def test_it_says_where(name: str, text: str, wanted: tuple[str, int]) -> None:
    assert styles(text, name) == [wanted]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        # a block is needed where what is inside is not what is outside
        ("s7-200", "LD I0.0; A I0.1; LD I0.2; A I0.3; OLD; = Q0.0"),
        ("s7-200", "LD I0.0; O I0.1; LD I0.2; O I0.3; ALD; = Q0.0"),
        ("s7-200", "LD I0.0; O I0.1; LD I0.2; O I0.3; A I0.4; ALD; = Q0.0"),
        ("neza", "LD %I0.0; AND( %I0.1; OR %I0.2; ); ST %Q0.0"),
        # an edge of the block is not an edge of the whole
        ("s7-200", "LD I0.0; LD I0.1; A I0.2; EU; ALD; = Q0.0"),
        ("s7-200", "LD I0.0; LD I0.1; A I0.2; NOT; ALD; = Q0.0"),
        # some branch has contacts, in front of an output or behind the last one
        ("s7-200", "LD I0.0; LPS; = Q0.0; LPP; A I0.1; = Q0.1"),
        ("s7-200", "LD I0.0; LPS; A I0.1; = Q0.0; LPP; = Q0.1"),
        ("s7-200", "LD I0.0; LPS; = Q0.0; LRD; A I0.1; = Q0.1; LPP; = Q0.2"),
        ("neza", "LD %I0.0; MPS; AND %I0.1; ST %Q0.0; MPP; ST %Q0.1"),
    ],
)
def test_it_is_silent_where_nothing_could_be_saved(name: str, text: str) -> None:
    assert styles(text, name) == []


BOOKS = [
    (path.name, block.split("\n", 1)[0].strip(), block.split("\n", 1)[1])
    for path in sorted((TESTS / "book").glob("00*.md"))
    for block in path.read_text(encoding="utf-8").split("```stl ")[1:]
    for block in [block.split("```", 1)[0]]
]


def test_no_advice_on_the_lists_that_the_books_print() -> None:
    assert len(BOOKS) > 25
    said = [(name, family, styles(text, family)) for name, family, text in BOOKS]
    wrong = [one for one in said if any(code.startswith("STY") for code, _ in one[2])]
    assert wrong == []


@pytest.mark.parametrize("name", FAMILIES)
@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_no_advice_on_a_ladder_written_out(name: str, data: st.DataObject) -> None:
    assert styles(lower(data.draw(ladders(name)), name).replace("\n", "; "), name) == []


def test_no_advice_on_the_first_right_sample_of_an_exercise() -> None:
    for name in ids():
        task = exercise(name)
        for text in task.right[:1] if task.kind in {"write", "complete", "bug", "translate"} else ():
            said = [code for code, _ in styles(text.strip().replace("\n", "; "), task.dialect)]
            assert not any(code.startswith("STY") for code in said), (name, said)


@pytest.mark.parametrize("family", families(), ids=lambda one: one.name)
def test_what_is_advised_does_the_same(family) -> None:
    """The mended sample of each advice gives the same outputs for all inputs."""
    for sample in family.samples:
        if not RULES[sample.code].style:
            continue
        bad, good = (read(text.replace("; ", "\n"), family) for text in (sample.bad, sample.good))
        inputs = [one.text for one in bad.addresses("input")]
        for bits in product((0, 1), repeat=len(inputs)):
            traces = [run(one, [dict(zip(inputs, bits, strict=True))]) for one in (bad, good)]
            for output in bad.addresses("output"):
                assert traces[0][output.text] == traces[1][output.text], (sample, bits)


@pytest.mark.parametrize(
    ("name", "text", "always"),
    [("s7-200", "= Q0.0", "LD SM0.0"), ("fx", "SET Y0", "LD M8000"), ("neza", "ST %Q0.0", "LD 1"), ("gutta", "= Q0.0", "LD SM0.0")],
)  # fmt: skip
def test_an_output_before_any_contact_is_told_apart_from_a_contact_without_a_load(
    name: str, text: str, always: str
) -> None:
    (one,) = lint(read(text, name))
    assert one.code == "COI009"
    assert always in one.text.en
    assert always in one.text.zh
    assert {found.code for found in lint(read("A I0.0\n= Q0.0", "s7-200"))} == {"STK009"}
    assert lint(read(f"{always}\n{text}", name)) == ()


def test_a_push_without_its_pop_points_at_the_push() -> None:
    (one,) = lint(read("LD I0.0\nLPS\nA I0.1\n= Q0.0", "gutta"))
    assert (one.code, [note.span.row for note in one.notes]) == ("STK005", [2])
    assert "LPP" in one.notes[0].text.en
    (block,) = [found for found in lint(read("LD X0\nLD X1\nOUT Y0", "fx")) if found.code == "STK005"]
    assert block.notes == ()


def test_a_second_pop_points_at_the_first_one_which_came_too_early() -> None:
    """Misconception 9: a pop for every branch."""
    text = "LD X0\nMPS\nAND X1\nOUT Y0\nMPP\nAND X2\nOUT Y1\nMPP\nAND X3\nOUT Y2"
    (one,) = lint(read(text, "fx"))
    assert (one.code, one.span.row, [note.span.row for note in one.notes]) == ("STK003", 8, [5])
    assert "MRD" in one.notes[0].text.en
    assert "MRD" in one.notes[0].text.zh
    (alone,) = lint(read("LD X0\nOUT Y0\nMPP\nOUT Y1", "fx"))
    assert (alone.code, alone.notes) == ("STK003", ())
