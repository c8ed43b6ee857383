"""The formula in each cell: written as the books write it, and meaning what the machine computes."""

from __future__ import annotations

import gc
import re
from itertools import product

import pytest

from plcteach.machine import run
from plcteach.machine.formula import MOST_NODES, name, spelled, written
from plcteach.stl import read

A, B, C, D = map(name, "abcd")


@pytest.mark.parametrize(
    ("term", "words"),
    [
        (A & B, "a·b"),
        (A | B, "a+b"),
        (A ^ B, "a⊕b"),
        (~A, "/a"),
        (~~A, "a"),
        (~(A & B), "/(a·b)"),
        ((A | B) & C, "(a+b)·c"),
        (A & B | C & D, "a·b+c·d"),
        (A & (B | ~C), "a·(b+/c)"),
        ((A ^ B) & C, "(a⊕b)·c"),
        (A ^ B & C, "a⊕b·c"),
        (A ^ B | C, "a⊕b+c"),
        ((A | B) ^ C, "(a+b)⊕c"),
        (A.edge(None, rising=True), "↑a"),
        ((A & B).edge(None, rising=False), "↓(a·b)"),
        (~A.edge(None, rising=True), "/(↑a)"),
        ((~A).edge(B, rising=True), "↑(/a)"),
    ],
)
def test_a_formula_as_the_books_write_it(term, words: str) -> None:
    assert written(term) == words
    assert repr(term) == f"Term({words})"


def test_the_same_formula_is_the_same_object() -> None:
    assert (A & B) is (A & B)
    assert name("a") is A
    assert (A & B) is not (B & A)
    kept = [(A & B) | C, (A & B) | C]
    gc.collect()
    assert kept[0] is kept[1]


LISTS = [
    ("s7-200", "LD I0.0 / A I0.1 / LDN I0.2 / A I0.3 / OLD / = Q0.0", "I0.0·I0.1+/I0.2·I0.3"),
    ("s7-200", "LD I0.0 / O I0.1 / LD I0.2 / ON I0.3 / ALD / NOT / = Q0.0", "/((I0.0+I0.1)·(I0.2+/I0.3))"),
    ("s7-200", "LD I0.0 / EU / A I0.1 / = Q0.0", "↑I0.0·I0.1"),
    ("fx", "LD X0 / OR X2 / LD X1 / AND X4 / LD X3 / AND X5 / ORB / ANB / OUT Y0", "(X0+X2)·(X1·X4+X3·X5)"),
    ("neza", "LD %I0.0 / XOR %I0.1 / AND( %I0.2 / OR %I0.3 / ) / ST %Q0.0", "(%I0.0⊕%I0.1)·(%I0.2+%I0.3)"),
    ("gutta", "LD I0.0 / LPS / A I0.1 / = Q0.0 / LPP / AN I0.2 / = Q0.1", "I0.0·/I0.2"),
]


@pytest.mark.parametrize(("dialect", "text", "formula"), LISTS)
def test_a_run_over_formulas_spells_the_result(dialect: str, text: str, formula: str) -> None:
    assert written(spelled(read(text.replace(" / ", "\n"), dialect))[-1].after[0][0]) == formula


@pytest.mark.parametrize(
    ("dialect", "text", "meaning"),
    [
        (LISTS[0][0], LISTS[0][1], lambda v: v[0] & v[1] | (1 - v[2]) & v[3]),
        (LISTS[1][0], LISTS[1][1], lambda v: 1 - ((v[0] | v[1]) & (v[2] | 1 - v[3]))),
        (LISTS[3][0], LISTS[3][1], lambda v: (v[0] | v[2]) & (v[1] & v[4] | v[3] & v[5])),
        (LISTS[4][0], LISTS[4][1], lambda v: (v[0] ^ v[1]) & (v[2] | v[3])),
    ],
)
def test_and_the_machine_computes_what_is_spelled(dialect: str, text: str, meaning) -> None:
    code = read(text.replace(" / ", "\n"), dialect)
    inputs = [address.text for address in code.addresses("input")]
    for bits in product((0, 1), repeat=len(inputs)):
        found = run(code, [dict(zip(inputs, bits, strict=True))]).scans[0].steps[-1]
        assert repr(found.written[0][1]) == str(meaning(bits))


def test_unknown_cells_are_spelled_x() -> None:
    steps = spelled(read("LD I0.0\nOLD\nLPP\n= Q0.0", "s7-200"))
    assert written(steps[1].after[0][0]) in {"x+I0.0", "I0.0+x"}
    assert {written(cell) for cell in steps[2].after[0]} == {"x"}


def test_eighty_lines_whose_formula_would_fill_a_book_are_spelled_at_once_and_cut() -> None:
    text = "LD I0.0\n" + "LPS\nNOT\nALD\n" * 27 + "= Q0.0"
    steps = spelled(read(text, "s7-200"))
    words = written(steps[-1].after[0][0])
    assert words.endswith("…")
    assert len(re.findall(r"I0\.0", words)) <= MOST_NODES
    assert written(steps[-1].after[0][0], 5).endswith("…")
    assert written(A & B, 3) == "a·b"
    assert written(A & B, 2) == "a·…"


def test_depth_costs_no_recursion() -> None:
    term = A
    for _ in range(20_000):
        term = ~(term & B)
    assert written(term, 100).endswith("…")
