"""GUTTA's compound instructions: counters that read several flows, blocks that a user declares, boxes split in two."""

from __future__ import annotations

from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.check.lint import lint
from plcteach.core.errors import DeclarationError, NotRepresentableError, UnknownNameError
from plcteach.core.insn import insn
from plcteach.core.verb import coil, work
from plcteach.dialects import dialect, extended
from plcteach.figure.card import Card
from plcteach.figure.film import film
from plcteach.ladder.boxes import decomposed
from plcteach.machine import run
from plcteach.stl import read, write

VOTE = insn("VOTE", "", "a b c -- a&b|a&c|b&c", zh="三取二", en="two out of three")


def said(text: str, family: object = "gutta") -> list[tuple[str, str, int]]:
    return [(one.severity, one.code, one.span.row) for one in lint(read(text.replace(" / ", "\n"), family))]  # type: ignore[arg-type]


# Compound outputs.


def test_a_compound_output_reads_the_top_three_and_pops_nothing() -> None:
    text = "LD I0.0\nLD I0.1\nLD I0.2\nCTUD C0, 2"
    found = run(read(text, "gutta"), [{"I0.0": 0}, {"I0.0": 1}, {"I0.0": 0}, {"I0.0": 1}, {"I0.1": 1}, {"I0.2": 1}])
    assert [one.value for one in found.values("C0.V")] == [0, 1, 1, 2, 1, 0]
    assert found["C0"] == "000100"
    last = found.scans[3].steps[-1]
    assert repr(last.before[0]) == repr(last.after[0]) == "(0, 0, 1)"
    assert said(text) == []


def test_nothing_follows_a_compound_output_in_its_network() -> None:
    counter = "LD I0.0 / LD I0.1 / CTU C0, 3"
    assert said(f"{counter} / LD C0 / = Q0.0") == [("error", "STK013", 4)]
    assert said(f"Network 1 / {counter} / Network 2 / LD C0 / = Q0.0") == []
    assert "STK013" not in {code for _, code, _ in said(f"{counter} / LD C0 / = Q0.0", "s7-200")}
    assert said("LD I0.0 / TON T37, 5 / LD T37 / = Q0.0") == [], "a timer reads one flow"


# Blocks that a user declares.


def test_a_declared_compound_input_works_at_once() -> None:
    family = extended("gutta", VOTE)
    code = read("LD I0.0\nLD I0.1\nLD I0.2\nVOTE\n= Q0.0", family)
    assert lint(code) == ()
    for bits in product((0, 1), repeat=3):
        found = run(code, [{f"I0.{at}": bit for at, bit in enumerate(bits)}])
        assert found["Q0.0"] == str(int(sum(bits) >= 2))
    assert [len(one.after[0]) for one in found.scans[0].steps] == [1, 2, 3, 1, 1]
    assert len(film(found.scans).data["steps"]) >= 5
    assert read(write(code), family) == code
    assert said("LD I0.0 / LD I0.1 / VOTE / = Q0.0", family) == [("error", "STK001", 3)]


def test_the_family_itself_stays_as_it_was() -> None:
    family = extended("gutta", VOTE)
    assert family != dialect("gutta")
    assert "VOTE" not in dialect("gutta").words
    assert [one.code for one in read("LD I0.0\nVOTE", "gutta").diagnostics] == ["RDR001"]


def test_an_input_that_writes_is_refused_in_words() -> None:
    for row in (
        insn("BAD", "out", "a b -- a&b", then=coil("a", "out"), zh="坏", en="bad"),
        insn("BAD", "out", "-- out", then=coil("out", "out"), zh="坏", en="bad"),
        insn("BAD", "IN:word OUT:word_out", "a b c -- a|b", then=work("move", "IN", "OUT"), zh="坏", en="bad"),
    ):
        with pytest.raises(DeclarationError, match=r"BAD makes a flow .* an input only reads"):
            extended("gutta", row)
    output = insn("PAIR", "out", "a b -- a b", then=coil("a&b"), zh="双路输出", en="two flows out")
    assert extended("gutta", output).insn("PAIR") is output


# Boxes.

NAMES = {"ADD_I": lambda a, b: a + b, "SUB_I": lambda a, b: a - b, "MUL_I": lambda a, b: a * b}


def fed(lines: tuple[str, ...], memory: dict[str, int]) -> int:
    return run(read("\n".join(["LD SM0.0", *lines]), "gutta"), [memory]).value("MW4", 0).value


@settings(max_examples=150, deadline=None)
@given(
    box=st.sampled_from(sorted(NAMES)),
    words=st.tuples(*[st.sampled_from(["MW0", "MW2", "MW3", "MW4", "MW5", "MW6", "7"])] * 2),
    memory=st.lists(st.integers(0, 9), min_size=9, max_size=9),
)
def test_a_safe_box_is_right_or_refused_and_a_faithful_one_is_right_or_warned_of(
    box: str, words: tuple[str, str], memory: list[int]
) -> None:
    given = {f"MB{at}": value for at, value in enumerate(memory)}
    both = bytes(memory)

    def word(name: str) -> int:
        return int(name) if name.isdigit() else int.from_bytes(both[int(name[2:]) :][:2], "big")

    wanted = (NAMES[box](word(words[0]), word(words[1])) + 32768) % 65536 - 32768
    fits = NAMES[box](word(words[0]), word(words[1])) == wanted
    lines, found = decomposed("gutta", box, *words, "MW4", "safe")
    assert bool(lines) != bool(found)
    if lines and fits:
        assert fed(lines, given) == wanted
    lines, found = decomposed("gutta", box, *words, "MW4", "faithful")
    assert len(lines) == 2
    shares = not words[1].isdigit() and abs(int(words[1][2:]) - 4) < 2
    assert [one.code for one in found] == (["BOX001"] if shares and words[0] != "MW4" else [])
    if not found and fits:
        assert fed(lines, given) == wanted


def test_the_books_boxes() -> None:
    assert decomposed("gutta", "ADD_I", "MW0", "MW2", "MW4") == (("MOVW MW0, MW4", "+I MW2, MW4"), ())
    lines, (warned,) = decomposed("gutta", "add_i", "1000", "MW4", "MW4")
    assert lines == ("MOVW 1000, MW4", "+I MW4, MW4")
    assert (warned.code, warned.severity) == ("BOX001", "warning")
    assert fed(lines, {"MW4": 5}) == 2000
    assert decomposed("gutta", "ADD_I", "1000", "MW4", "MW4", "safe") == (("+I 1000, MW4",), ())
    assert decomposed("gutta", "ADD_I", "MW4", "1000", "MW4", "safe") == (("+I 1000, MW4",), ())
    assert [one.code for one in decomposed("gutta", "SUB_I", "1000", "MW4", "MW4", "safe")[1]] == ["BOX002"]


def test_overlap_goes_by_bytes_and_not_by_names() -> None:
    for in2, shares in (("MW2", False), ("MW3", True), ("MW4", True), ("MW5", True), ("MW6", False), ("VW4", False)):
        assert bool(decomposed("gutta", "ADD_I", "MW0", in2, "MW4")[1]) == shares


def test_a_box_in_a_list_is_read_as_the_editor_splits_it() -> None:
    code = read("LD SM0.0\n// sum\nADD_I 1000, MW4, MW4 // both", "gutta")
    assert [line.text for line in code.lines] == ["LD SM0.0", "MOVW 1000, MW4", "+I MW4, MW4"]
    assert [(one.code, one.severity, one.span.row) for one in code.diagnostics] == [("BOX001", "warning", 3)]
    assert (code.lines[1].above, code.lines[2].comment) == (("sum",), "both")
    assert read(write(code), "gutta") == code
    assert [one.code for one in read("LD I0.0\nADD_I MW0, MW2", "gutta").diagnostics] == ["RDR003"]
    assert [one.code for one in read("LD I0.0\nADD_I MW0, MW2, MW4, MW6", "gutta").diagnostics] == ["RDR004"]
    assert [one.code for one in read("LD I0.0\nADD_I MW0, MW2, 5", "gutta").diagnostics] == ["RDR005"]


def test_what_is_no_box_says_so() -> None:
    with pytest.raises(UnknownNameError, match="ADD_I"):
        decomposed("gutta", "ADD_J", "1", "MW0", "MW4")
    with pytest.raises(NotRepresentableError):
        decomposed("gutta", "ADD_I", "1", "MX0", "MW4")


@pytest.mark.parametrize("family", ["s7-200", "gutta"])
def test_every_instruction_has_its_card_in_both_languages(family: str) -> None:
    for row in dialect(family).insns:
        card = Card(dialect(family), row)
        for lang in ("zh", "en"):
            assert row.title.in_(lang) in card.text(lang)
            assert card.html(lang)
