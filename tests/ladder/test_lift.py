"""A lifted list is the ladder that the books draw, means what the machine does, and says where a list is no ladder."""

from __future__ import annotations

import sys
import time
from functools import partial
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach import stl
from plcteach.core.ladder import (
    Box,
    Branch,
    Coil,
    Compared,
    Contact,
    Edge,
    Invert,
    Ladder,
    Rung,
    branch,
    parallel,
    rung,
    series,
)
from plcteach.dialects import dialect, families
from plcteach.ladder.lift import Lifted, lift
from plcteach.ladder.lower import lower
from plcteach.ladder.picture import read_drawing
from plcteach.machine import Column, Domain, Memory, sweep

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parents[1] / "machine"))
from played import Played
from random_ladders import FAMILIES, ladders
from random_lists import INPUTS, lists
from sensible_lists import sensible

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time

C = Contact
NC = partial(Contact, negated=True)


def lifted(text: str, family: str) -> Lifted:
    return lift(stl.read(text.replace("/", "\n"), family))


def rungs_of(text: str, family: str) -> tuple[Rung, ...]:
    found = lifted(text, family)
    assert [one for one in found.diagnostics if one.severity != "info"] == []
    return found.ladder.rungs


def codes(text: str, family: str) -> list[tuple[str, int]]:
    return [(one.code, one.span.row) for one in lifted(text, family).diagnostics]


# The figures of the books.

FIGURE_2 = "LD X0/AND X1/LD X2/AND X3/ORB/OUT Y0"
FIGURE_3 = "LD X0/OR X5/MPS/AND X1/OUT Y0/MRD/AND X2/OUT Y1/MPP/AND X3/OUT Y2"
FIGURE_4 = "LD X0/MPS/AND X1/MPS/AND X2/OUT Y0/MPP/AND X3/OUT Y1/MPP/AND X4/OUT Y2"
FIGURE_5 = "LD X0/OR X2/LD X1/AND X4/LD X3/AND X5/ORB/ANB/OUT Y0"
DRAWN = [
    ("fx", FIGURE_2, "--[ X0 ]--[ X1 ]--+--( Y0 )\n--[ X2 ]--[ X3 ]--+"),
    (
        "fx", FIGURE_3,
        "--[ X0 ]--+--+--[ X1 ]--( Y0 )\n--[ X5 ]--+  |\n             +--[ X2 ]--( Y1 )\n             +--[ X3 ]--( Y2 )",
    ),
    (
        "fx", FIGURE_4,
        "--[ X0 ]--+--[ X1 ]--+--[ X2 ]--( Y0 )\n          |          +--[ X3 ]--( Y1 )\n          +--[ X4 ]-------------( Y2 )",
    ),
    (
        "fx", FIGURE_5,
        "--[ X0 ]--+--+--[ X1 ]--[ X4 ]--+--( Y0 )\n--[ X2 ]--+  |                  |\n             +--[ X3 ]--[ X5 ]--+",
    ),
    ("s7-200", "LD I0.0/LD I0.1/LD I2.0/A I2.1/OLD/ALD/= Q5.0", "I0.0·(I0.1 + I2.0·I2.1) -> Q5.0"),
    (
        "s7-200", "LD I0.0/LPS/LD I0.5/O I0.6/ALD/= Q7.0/LRD/LD I2.1/O I1.3/ALD/= Q6.0/LPP/A I1.0/= Q3.0",
        "I0.0 -> ((I0.5 + I0.6) -> Q7.0), ((I2.1 + I1.3) -> Q6.0), (I1.0 -> Q3.0)",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("family", "text", "drawing"), DRAWN)
def test_the_figures_of_the_books_lift_to_their_drawings_and_lower_to_the_same_lists(
    family: str, text: str, drawing: str
) -> None:
    wanted, found = read_drawing(drawing)
    assert not found
    assert rungs_of(text, family) == wanted.rungs
    again = lower(lifted(text, family).ladder, family).split("\n")
    assert "/".join(row for row in again if row and not row.startswith("Network")) == text


def test_the_manuals_two_networks_are_two_rungs_with_their_titles() -> None:
    one, other = (text.replace("/", "\n") for family, text, _ in DRAWN if family == "s7-200")
    found = lift(stl.read(f"Network 1 // first\n{one}\nNetwork 2 // 第二级\n{other}", "s7-200"))
    assert [(one.rung.title, one.network) for one in found.rungs] == [("first", 0), ("第二级", 1)]
    assert found.diagnostics == ()


# Symbols.

LIFTS = [
    # a bit just read is a contact of another kind; once it stands in a cell, NOT and edges are on the wire
    ("s7-200", "LDN I0.0/AN I0.1/= Q0.0", [rung(series(NC("I0.0"), NC("I0.1")), Coil("Q0.0"))]),
    ("s7-200", "LD I0.0/NOT/= Q0.0", [rung(series(C("I0.0"), Invert()), Coil("Q0.0"))]),
    ("s7-200", "LD I0.0/EU/= Q0.0", [rung(C("I0.0", edge="rise"), Coil("Q0.0"))]),
    ("s7-200", "LD I0.0/A I0.1/ED/= Q0.0", [rung(series(C("I0.0"), C("I0.1"), Edge(rising=False)), Coil("Q0.0"))]),
    ("s7-200", "LDN I0.0/EU/= Q0.0", [rung(series(NC("I0.0"), Edge()), Coil("Q0.0"))]),
    ("s7-200", "LD I0.0/LD I0.1/EU/ALD/= Q0.0", [rung(series(C("I0.0"), C("I0.1", edge="rise")), Coil("Q0.0"))]),
    ("s7-200", "LD I0.0/LD I0.1/NOT/O I0.2/ALD/= Q0.0",
     [rung(series(C("I0.0"), parallel(NC("I0.1"), C("I0.2"))), Coil("Q0.0"))]),
    ("fx", "LD X0/MEP/OUT Y0", [rung(series(C("X0"), Edge()), Coil("Y0"))]),
    ("fx", "LDP X0/ORF X1/OUT Y0", [rung(parallel(C("X0", edge="rise"), C("X1", edge="fall")), Coil("Y0"))]),
    ("gutta", "LD I0.0/P M0.0/= Q0.0", [rung(series(C("I0.0"), Edge(memory="M0.0")), Coil("Q0.0"))]),
    ("s7-200", "LDI I0.0/ANI I0.1/=I Q0.0/SI Q0.1, 2", [
        rung(series(C("I0.0", immediate=True), NC("I0.1", immediate=True)),
             Coil("Q0.0", immediate=True), Coil("Q0.1", "set", 2, immediate=True))]),
    ("s7-200", "LDW>= VW0, +5/AB= VB1, 5/OR< VD4, 1.5/= Q0.0", [
        rung(parallel(series(Compared("VW0", ">=", "5"), Compared("VB1", "=", "5", "B")), Compared("VD4", "<", "1.5", "R")),
             Coil("Q0.0"))]),
    ("neza", "LD %I0.0/ANDN [%MW0 > 10]/ST %Q0.0", [rung(series(C("%I0.0"), Compared("%MW0", "<=", "10")), Coil("%Q0.0"))]),
    # exclusive or: both ways to differ
    ("neza", "LD %I0.0/XOR %I0.1/ST %Q0.0", [
        rung(parallel(series(C("%I0.0"), NC("%I0.1")), series(NC("%I0.0"), C("%I0.1"))), Coil("%Q0.0"))]),
    ("neza", "LD %I0.0/AND %I0.2/XOR %I0.1/ST %Q0.0", [
        rung(series(C("%I0.0"), C("%I0.2"), parallel(NC("%I0.1"), series(Invert(), C("%I0.1")))), Coil("%Q0.0"))]),
    # coils
    ("fx", "LD X0/PLS M0/PLF M1/RST C0/RST D0/OUT T0 K10", [
        rung(C("X0"), Coil("M0", "rise"), Coil("M1", "fall"), Coil("C0", "reset"), Coil("D0", "reset"), Box("OUT T0 K10"))]),
    ("neza", "LD %I0.0/STN %Q0.0/S %M0", [rung(C("%I0.0"), Coil("%Q0.0", "not"), Coil("%M0", "set"))]),
    # branches: kept by identity, in every family's way
    ("s7-200", "LD I0.0/= Q0.0/A I0.1/= Q0.1", [rung(C("I0.0"), Coil("Q0.0"), Branch(C("I0.1"), (Coil("Q0.1"),)))]),
    ("gutta", "LD I0.0/LPS/A I0.1/= Q0.0/LRD/A I0.2/= Q0.1/LPP/= Q0.2", [
        rung(C("I0.0"), branch(C("I0.1"), Coil("Q0.0")), branch(C("I0.2"), Coil("Q0.1")), Coil("Q0.2"))]),
    ("fx", "LD X0/MPS/LD X1/OR X2/ANB/OUT Y0/MPP/OUT Y1", [
        rung(C("X0"), branch(parallel(C("X1"), C("X2")), Coil("Y0")), Coil("Y1"))]),
    ("neza", "LD %I0.0/MPS/AND( %I0.1/OR %I0.2/)/ST %Q0.0/MPP/ST %Q0.1", [
        rung(C("%I0.0"), branch(parallel(C("%I0.1"), C("%I0.2")), Coil("%Q0.0")), Coil("%Q0.1"))]),
    # a node within a block: what both paths have in common is drawn once
    ("s7-200", "LD I0.0/LPS/NOT/LDS 1/A I0.1/OLD/= Q0.0", [
        rung(series(C("I0.0"), parallel(Invert(), C("I0.1"))), Coil("Q0.0"))]),
    ("gutta", "LD I0.0/LPS/NOT/LD SM0.0/LPP/A I0.1/OLD/= Q0.0", [
        rung(series(C("I0.0"), parallel(Invert(), C("I0.1"))), Coil("Q0.0"))]),
    # a path that is the stem itself is drawn with a stem of its own
    ("s7-200", "LD I0.0/LPS/A I0.1/OLD/= Q0.0", [rung(parallel(C("I0.0"), series(C("I0.0"), C("I0.1"))), Coil("Q0.0"))]),
    # two rungs in one circuit
    ("s7-200", "LD I0.0/= Q0.0/LD I0.1/= Q0.1", [rung(C("I0.0"), Coil("Q0.0")), rung(C("I0.1"), Coil("Q0.1"))]),
    # boxes
    ("s7-200", "LD I0.0/LD I0.1/O I0.2/CTU C0, 3", [
        rung(C("I0.0"), Box("CTU C0, 3", (("R", parallel(C("I0.1"), C("I0.2"))),), "CU"))]),
    ("gutta", "LD I0.0/LD I0.1/LD I0.2/CTUD C2, 3", [
        rung(C("I0.0"), Box("CTUD C2, 3", (("CD", C("I0.1")), ("R", C("I0.2"))), "CU"))]),
    ("s7-200", "LD I0.0/MOVW VW0, VW2/AENO/= Q0.0", [
        rung(C("I0.0"), Box("MOVW VW0, VW2"), branch(C("ENO"), Coil("Q0.0")))]),
    ("s7-200", "LBL 1", [Rung(None, (Box("LBL 1"),))]),
    ("fx", "STL S20/OUT Y0/LD X1/SET S21/RET", [
        Rung(None, (Box("STL S20"),)), rung(C("S20"), Coil("Y0")), rung(C("X1"), Coil("S21", "set")), Rung(None, (Box("RET"),))]),
    ("neza", "BLK %C0/LD %I0.0/CU/LD %I0.1/R/OUT_BLK/LD D/ST %Q0.0/END_BLK", [
        rung(C("%I0.0"), Box("BLK %C0", (("R", C("%I0.1")),), "CU")), rung(C("%C0.D"), Coil("%Q0.0"))]),
    ("neza", "LD %I0.0/IN %TM0/LD %TM0.Q/ST %Q0.0", [
        rung(C("%I0.0"), Box("IN %TM0")), rung(C("%TM0.Q"), Coil("%Q0.0"))]),
    # nothing follows a box of several inputs on its rung
    ("s7-200", "LD I0.0/LPS/LD I0.1/CTU C0, 3/LPP/LPP/= Q0.0", [
        rung(C("I0.0"), Box("CTU C0, 3", (("R", C("I0.1")),), "CU")), rung(C("I0.0"), Coil("Q0.0"))]),
]  # fmt: skip


@pytest.mark.parametrize(("family", "text", "wanted"), LIFTS, ids=[f"{family}: {text}" for family, text, _ in LIFTS])
def test_each_instruction_draws_its_symbol(family: str, text: str, wanted: list[Rung]) -> None:
    assert rungs_of(text, family) == tuple(wanted)


@pytest.mark.parametrize("family", families(), ids=lambda one: one.name)
def test_every_example_of_every_family_is_a_ladder(family) -> None:
    for text in family.examples:
        found = lift(stl.read(text.replace("; ", "\n"), family))
        assert [one for one in found.diagnostics if one.severity != "info"] == [], text
        drawn = [line for one in found.rungs for lines in one.sources for line in lines]
        outputs = {number for number, line in enumerate(found.program.lines) if line.insn.then}
        assert outputs <= set(drawn), text


OTHERWISE = {
    "LDN %I0.0; XOR %I0.1; N; XORN %I0.2; ST %Q0.0; NOP",
    "LD %I0.0; XORR %I0.1; XORF %I0.2; ST %Q0.0",
    "LD I0.0; LPS; NOT; LD SM0.0; LPP; A I0.1; OLD; = Q0.0",
}
"""NOT in a path behind a node: families that cannot save the flow there write the stem twice."""


@pytest.mark.parametrize("family", families(), ids=lambda one: one.name)
def test_every_example_is_lowered_again_to_a_list_of_the_same_ladder(family) -> None:
    for text in set(family.examples) - OTHERWISE:
        program = stl.read(text.replace("; ", "\n"), family)
        ladder = lift(program).ladder
        again = "".join(f"{row}\n" for row in program.configuration) + lower(ladder, family)
        assert lift(stl.read(again, family)).ladder == ladder, text


# What the lines made, and how the ladder grows.


def test_each_symbol_names_its_lines_its_own_first() -> None:
    assert lifted("LD I0.0/EU/LPS/NOT/= Q0.0/LPP/= Q0.1", "s7-200").rungs[0].sources == ((0, 1), (3,), (4,), (6,))
    text = "BLK %C0/LD %I0.0/CU/LD %I0.1/R/OUT_BLK/LD D/ST %Q0.0/END_BLK"
    assert lifted(text, "neza").rungs[0].sources == ((1,), (3,), (0, 2, 4, 5, 8))


GROWN = {
    # symbols:  0=X0 1=X1 2=X2 3=X3 4=Y0
    FIGURE_2: ["0", "01", "2", "23", "0123", "0123"],
    # 0=X0 1=X5 2=X1 3=Y0 4=X2 5=Y1 6=X3 7=Y2
    FIGURE_3: ["0", "01", "01", "012", "012", "01", "014", "014", "01", "016", "016"],
    # 0=X0 1=X1 2=X2 3=Y0 4=X3 5=Y1 6=X4 7=Y2
    FIGURE_4: ["0", "0", "01", "01", "012", "012", "01", "014", "014", "0", "06", "06"],
    # 0=X0 1=X2 2=X1 3=X4 4=X3 5=X5 6=Y0
    FIGURE_5: ["0", "01", "2", "23", "4", "45", "2345", "012345", "012345"],
}


@pytest.mark.parametrize("text", GROWN)
def test_the_top_of_the_stack_stands_for_the_symbols_read_so_far(text: str) -> None:
    found = lifted(text, "fx")
    assert ["".join(str(symbol) for _, symbol in one.top) for one in found.growth] == GROWN[text]
    seen = [symbol for one in found.growth for _, symbol in one.added]
    assert seen == list(range(len(found.rungs[0].rung.symbols)))
    drives = [number for number, line in enumerate(found.program.lines) if line.insn.then]
    assert [number for number, one in enumerate(found.growth) if one.out] == drives
    for number in drives:
        (place,) = found.growth[number].out
        assert found.rungs[0].rung.symbols[place[1]].address == found.program.lines[number].text.split()[1]


def test_a_join_names_its_two_blocks_the_upper_first() -> None:
    def joins(text: str, family: str) -> list[tuple[str, str]]:
        blocks = [one.blocks for one in lifted(text, family).growth if one.blocks]
        return [tuple("".join(str(symbol) for _, symbol in refs) for refs in pair) for pair in blocks]

    assert joins(FIGURE_5, "fx") == [("23", "45"), ("01", "2345")]
    assert joins(FIGURE_2, "fx") == [("01", "23")]
    assert joins("LD %I0.0/AND( %I0.1/OR %I0.2/)/ST %Q0.0", "neza") == [("0", "12")]
    assert joins("LD I0.0/LD I0.1/LD I0.2/OLD/ALD/= Q0.0", "gutta") == [("1", "2"), ("0", "12")]
    assert joins(FIGURE_3, "fx") == joins("LD I0.0/LPS/AENO/= Q0.0/LPP/= Q0.1", "s7-200") == []


def test_what_is_drawn_twice_is_named_twice_and_what_is_left_out_not_at_all() -> None:
    found = lifted("LD I0.0/LPS/A I0.1/OLD/= Q0.0", "s7-200")
    assert [len(one.top) for one in found.growth] == [2, 2, 3, 3, 3]
    gone = lifted("LD I0.0/LD I0.1/= Q0.0/ALD/= Q0.1", "s7-200")
    assert [one.top for one in gone.growth] == [(), ((0, 0),), ((0, 0),), (), ()]
    assert gone.growth[2].out == ((0, 1),)


def test_a_line_that_draws_several_pieces_at_once_stands_for_all_of_them() -> None:
    growth = lifted("LD %I0.0/XORR %I0.1/ST %Q0.0/ST %Q0.1", "neza").growth
    assert [one.top for one in growth[1:]] == [tuple((0, symbol) for symbol in range(4))] * 3


def test_blocks_that_are_saved_share_one_tuple() -> None:
    growth = lifted(FIGURE_4, "fx").growth
    assert growth[0].top is growth[1].top is growth[9].top


# Thousands of random ladders and lists.


def as_kept(family: str, outs: tuple) -> list:
    """An inverted coil is NOT and a coil in a family that has none; every other form is kept."""
    plain = family != "neza"
    found = []
    for one in outs:
        if isinstance(one, Branch):
            found.append(branch(one.stem, *as_kept(family, one.outs)))
        else:
            found.append(branch(Invert(), Coil(one.address)) if plain and one.kind == "not" else one)
    return found


@pytest.mark.parametrize(("family", "how"), [
    *((family, {}) for family in FAMILIES),
    *((family, {"edges": True, "turned": True}) for family in ("s7-200", "fx", "neza")),
    ("gutta", {"turned": True}),
])  # fmt: skip
@settings(max_examples=400, deadline=None)
@given(data=st.data())
def test_lowering_and_lifting_draws_the_same_ladder(family: str, how: dict[str, bool], data: st.DataObject) -> None:
    ladder: Ladder = data.draw(ladders(family, **how))
    found = lift(stl.read(lower(ladder, family), family))
    assert found.ladder.rungs == tuple(rung(one.stem, *as_kept(family, one.outs)) for one in ladder.rungs)
    assert [one for one in found.diagnostics if one.severity != "info"] == []
    assert all(len(one.sources) == len(one.rung.symbols) for one in found.rungs)


ROWS = range(8)


def agrees(text: str, family: str, scans: list[int]) -> bool:
    """Play the lifted rungs beside the machine, for every row of inputs at once; False where the list is no ladder."""
    program = stl.read(text, family)
    found = lift(program)
    assert len(found.growth) == len(program.lines)
    if not program.runs or [one for one in found.diagnostics if one.severity != "info"]:
        return False
    every = (1 << len(ROWS)) - 1
    domain = Domain(Column(every, 0), Column(0, every), Column(every, every))
    plays, memory = [Played(found) for _ in ROWS], Memory()
    for scan in scans:
        rows = [{f"{INPUTS[family]}{bit}": bool((row ^ scan) >> bit & 1) for bit in range(3)} for row in ROWS]
        memory = sweep(program, memory, {name: column([row[name] for row in rows]) for name in rows[0]}, domain)
        after = [play.scan(row) for play, row in zip(plays, rows, strict=True)]
        for name in written(found):
            assert memory.bits.get(name, domain.zero) == column([bits.get(name, False) for bits in after]), (text, name)
    return True


def column(truths: list[bool]) -> Column:
    ones = sum(truth << case for case, truth in enumerate(truths))
    return Column((1 << len(truths)) - 1 & ~ones, ones)


def written(found: Lifted) -> set[str]:
    family = found.program.dialect
    coils = [symbol for one in found.rungs for symbol in one.rung.symbols if isinstance(symbol, Coil)]
    places = [place for one in coils for place in family.following(family.address(one.address), one.count)]
    return {place.text for place in places if family.area(place).role != "input"}


@pytest.mark.parametrize("family", INPUTS)
@settings(max_examples=400, deadline=None)
@given(random=st.randoms(use_true_random=False), scans=st.lists(st.integers(0, 7), min_size=3, max_size=3))
def test_a_list_that_is_a_ladder_means_what_the_machine_does(family: str, random, scans: list[int]) -> None:
    agrees(sensible(family, random), family, scans)


def test_most_sensible_lists_are_ladders() -> None:
    import random

    chance = random.Random(4)
    for family in INPUTS:
        assert sum(agrees(sensible(family, chance), family, [1, 6, 3]) for _ in range(60)) >= 15


@pytest.mark.parametrize("family", INPUTS)
@settings(max_examples=200, deadline=None)
@given(data=st.data(), scans=st.lists(st.integers(0, 7), min_size=2, max_size=2))
def test_any_list_at_all_is_lifted_or_says_why_not(family: str, data: st.DataObject, scans: list[int]) -> None:
    agrees(data.draw(lists(family, headings=True)), family, scans)


def test_an_earlier_branch_writes_a_bit_that_the_stem_reads() -> None:
    text = "LD I0.0\nAN Q0.1\nLPS\n= Q0.1\nLPP\nA I0.1\n= Q0.0"
    (one,) = lift(stl.read(text, "s7-200")).ladder.rungs
    assert one == rung(series(C("I0.0"), NC("Q0.1")), Coil("Q0.1"), branch(C("I0.1"), Coil("Q0.0")))
    assert agrees(text, "s7-200", [3, 3, 0, 3])
    assert lower(one, "s7-200").split("\n")[1:-1] != text.split("\n")  # a bare coil first needs no LPS
    assert lift(stl.read(lower(one, "s7-200"), "s7-200")).ladder.rungs == (one,)


# What is no ladder.

NONE = [
    ("LAD001", "s7-200", "LD I0.0/= Q0.0/LPP/A I0.1/= Q0.1", 5, 1),
    ("LAD001", "s7-200", "Network 1/LD I0.0/= Q0.0/Network 2/A I0.1/= Q0.1", 6, 1),
    ("LAD001", "fx", "LD X0/AND X1/ANB/OUT Y0", 4, 0),
    ("LAD001", "s7-200", "LD I0.0/LDS 5/= Q0.0", 3, 0),
    ("LAD002", "s7-200", "LD I0.0/LD I0.1/= Q0.0/ALD/= Q0.1", 4, 1),
    ("LAD002", "gutta", "LD I0.0/= Q0.0/O I0.1/= Q0.1", 3, 1),
    ("LAD003", "gutta", "LD I0.0/LPS/A I0.1/= Q0.0/LD I0.2/= Q0.1/LPP/= Q0.2", 8, 2),
    ("LAD003", "s7-200", "LD I0.0/LPS/A I0.1/= Q0.0/LDS 1/A I0.2/= Q0.1/LPP/A I0.3/= Q0.2", 10, 0),
    ("LAD004", "s7-200", "LD Q0.0/LPS/A I0.0/OLD/LD I0.1/= Q0.0/LPP/= Q0.1", 1, 1),
    ("LAD005", "s7-200", "LD I0.0/LD I0.1/A I0.2/NOT/ALD/= Q0.0", 4, 0),
    ("LAD005", "fx", "LD X0/LD X1/AND X2/MEP/ANB/OUT Y0", 4, 0),
    ("LAD006", "s7-200", "LD I0.0/" + "A I0.1/" * 2100 + "= Q0.0", 2102, 0),
    ("LAD006", "s7-200", "LD I0.0/" + "O I0.1/A I0.2/" * 40 + "= Q0.0", None, 0),
    ("LAD012", "gutta", "LD I0.0/LPS/P M0.0/LPP/= Q0.0", 3, 1),
    ("LAD013", "gutta", "LD I0.0/P M0.0/LPS/A I0.1/LD I0.2/LPP/OLD/= Q0.0", 2, 0),
]


@pytest.mark.parametrize(
    ("code", "family", "text", "row", "rungs"), NONE, ids=[f"{one[0]} {one[2][:40]}" for one in NONE]
)
def test_what_is_no_ladder_is_said_where_it_is_and_the_rest_is_shown(code, family, text, row, rungs) -> None:
    found = lifted(text, family)
    said = [one for one in found.diagnostics if one.severity == "warning"]
    assert [one.code for one in said] == [code]
    assert row is None or said[0].span.row == row
    assert rungs is None or len(found.rungs) == rungs
    assert said[0].text.zh != said[0].text.en


@pytest.mark.parametrize(("family", "text", "row"), [
    ("s7-200", "LD I0.0/A I0.1/LD I0.2/= Q0.0", 1),
    ("fx", "LD X0/LD X1/AND X2/LD X3/ORB/OUT Y0", 1),
    ("gutta", "LD I0.3/= Q0.1/LD I0.0/= Q0.0/LD I0.1/LD I0.2/= Q0.2", 5),
])  # fmt: skip
def test_a_contact_that_leads_to_no_output_is_said_once_a_network(family: str, text: str, row: int) -> None:
    said = [one for one in lifted(text, family).diagnostics if one.code == "LAD014"]
    assert [one.span.row for one in said] == [row]
    assert codes("LD I0.0/A I0.1/= Q0.0", "s7-200") == []


EDITOR = [
    ("Network 1/LD I0.0/= Q0.0/LD I0.1/= Q0.1", [("LAD007", 4)]),
    ("Network 1/LD I0.0/LPS/A I0.1/= Q0.0/LPP/A I0.2/= Q0.1/A I0.3/= Q0.2", [("LAD008", 9)]),
    ("Network 1/LD I0.0/LPS/A I0.1/= Q0.0/LPP/= Q0.1/LD I0.2/O I0.3/ALD/= Q0.2", [("LAD008", 8)]),
    ("Network 1/LD I0.0/LPS/A I0.1/LPS/A I0.2/= Q0.0/LPP/A I0.3/= Q0.1/LPP/A I0.4/= Q0.2", []),
    ("Network 1/LD I0.0/= Q0.0/A I0.1/= Q0.1", []),
    ("Network 1/LD I0.0/JMP 1/Network 2/LBL 1/Network 3/LSCR S0.1/Network 4/SCRE", []),
    ("Network 1/LD I0.0/JMP 1/LBL 1", [("LAD009", 4)]),
    ("Network 1/LD I0.0/A I0.1", [("LAD011", 3)]),
    ("Network 1/LD I0.0/= Q0.0/NOP 0", []),
]


@pytest.mark.parametrize(("text", "wanted"), EDITOR)
def test_what_the_editor_would_not_show_is_said_with_its_reason(text: str, wanted: list[tuple[str, int]]) -> None:
    assert codes(text, "s7-200") == wanted
    assert codes(text.replace("Network", "network"), "s7-200-smart") == wanted
    assert {one.severity for one in lifted(text, "s7-200").diagnostics} <= {"info"}


def test_a_network_that_begins_without_a_contact_is_remarked_on_beside_what_is_no_ladder() -> None:
    assert codes("Network 1/A I0.0/= Q0.0", "s7-200") == [("LAD010", 2), ("LAD001", 3)]
    assert codes("Network 1/LD I0.0/= Q0.0/LD I0.1/= Q0.1", "gutta") == []


# Absurd lists.


@pytest.mark.parametrize(("family", "text"), [
    ("s7-200", "".join(f"Network {n}\nLD I0.0\nO Q0.0\nLPS\nA I1.0\n= Q0.0\nLPP\nAN I0.2\n= M0.0\n" for n in range(2200))),
    ("s7-200", "LD I0.0\n" + "A I0.1\n= Q0.0\n" * 9990),
    ("s7-200", "LD I0.0\n" + "A I0.1\n" * 19_990 + "= Q0.0"),
    ("s7-200", "LD I0.0\n" + "O I0.1\nA I0.2\n" * 3000 + "= Q0.0"),
    ("s7-200", "LD I0.0\n" + "LPS\nOLD\n" * 6000 + "= Q0.0"),
    ("s7-200", "LD I0.0\n" + "LPS\nA I0.1\nOLD\n= Q0.0\n" * 4900),
    ("neza", "LD %I0.0\n" + "XOR %I0.1\n" * 5000 + "ST %Q0.0"),
    ("neza", "LD %I0.0\n" + "XORR %I0.1\n" * 5000 + "ST %Q0.0"),
    ("gutta", "LD I0.0\n" + "A M0.0\n" * 1900 + "LPS\n" + "LD I0.1\n= Q0.1\n" * 8500 + "LPP\n= Q0.1"),
], ids=["branches", "outputs", "series", "nested", "doubling", "outputs in blocks", "xor", "xor of edges", "late"])  # fmt: skip
def test_absurd_lists_are_lifted_or_refused_within_seconds(family: str, text: str) -> None:
    program = stl.read(text, family)
    begin = time.perf_counter()
    found = lift(program)
    assert time.perf_counter() - begin < 15
    assert len(found.growth) == len(program.lines)
    assert len(found.diagnostics) <= 301


def test_600_exclusive_ors_in_a_row_are_drawn_without_being_multiplied() -> None:
    (one,) = rungs_of("LD %I0.0/" + "XOR %I0.1/" * 600 + "ST %Q0.0", "neza")
    assert len(one.symbols) == 4 + 599 * 3 + 1


def test_what_is_lifted_says_itself_in_one_line() -> None:
    found = lifted(FIGURE_5, "fx")
    for one in (found, found.rungs[0], found.growth[-2]):
        assert "\n" not in repr(one)
    assert dialect("s7-200").shows_rungs
    assert not dialect("gutta").shows_rungs
