"""A lowered ladder does what the ladder means, in every family, and reads as the books write it."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach import stl
from plcteach.check.lint import lint
from plcteach.core.errors import NotRepresentableError
from plcteach.core.ladder import Box, Coil, Compared, Contact, Ladder, Rung, Series, parallel, rung, series
from plcteach.ladder.lower import lower, lower_lines, meaning
from plcteach.ladder.picture import read_drawing
from plcteach.machine import ONE, ZERO, Column, Domain, Memory, run, sweep

sys.path.insert(0, str(Path(__file__).parent))
from random_ladders import FAMILIES, INPUTS, WORDS, Plain, bits, enriched, ladders, rungs

CASES = 1 << INPUTS
ALL = (1 << CASES) - 1
SCANS = ((1, 0), (5, 3), (11, 6))
"""Case k sees in scan s the inputs whose pattern is (k * factor + offset) mod 16: every row in every scan."""


def ladder_of(drawing: str) -> Ladder:
    ladder, found = read_drawing(drawing)
    assert not found
    return ladder


def listing(drawing: str, dialect: str, **how: bool) -> str:
    return "/".join(line.text for line in lower_lines(ladder_of(drawing), dialect, **how))


def column(truths: list[bool]) -> Column:
    ones = sum(truth << case for case, truth in enumerate(truths))
    return Column(ALL & ~ones, ones)


def agrees(ladder: Ladder, family: str, **how: bool) -> None:
    """Run the lowered list over all rows and three scans, and compare every output with the plain evaluator."""
    text = lower(ladder, family, **how)
    program = stl.read(text, family)
    assert program.diagnostics == ()
    assert stl.write(program) == text
    inputs, outputs = bits(family)
    domain = Domain(Column(ALL, 0), Column(0, ALL), Column(ALL, ALL))
    plains = [Plain() for _ in range(CASES)]
    memory: Memory[Column] = Memory()
    for factor, offset in SCANS:
        rows = [[bool((case * factor + offset) % CASES >> bit & 1) for bit in range(INPUTS)] for case in range(CASES)]
        memory = sweep(
            program, memory, {name: column([row[bit] for row in rows]) for bit, name in enumerate(inputs)}, domain
        )
        after = [
            plain.scan(ladder, dict(zip(inputs, row, strict=True))) for plain, row in zip(plains, rows, strict=True)
        ]
        for name in outputs:
            assert memory.bits.get(name, domain.zero) == column([one.get(name, False) for one in after]), text


@pytest.mark.no_cover
@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=350, deadline=None)
@given(data=st.data())
def test_the_list_does_what_the_ladder_means(family: str, data: st.DataObject) -> None:
    agrees(data.draw(ladders(family)), family)


@pytest.mark.no_cover
@pytest.mark.parametrize("family", ["s7-200", "fx", "neza"])
@settings(max_examples=150, deadline=None)
@given(data=st.data())
def test_edges_of_contacts_and_not_on_the_wire(family: str, data: st.DataObject) -> None:
    agrees(data.draw(ladders(family, edges=True, turned=True)), family)


@pytest.mark.no_cover
@pytest.mark.parametrize("how", [{}, {"grouped": True}, {"fused": False}])
@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=90, deadline=None)
@given(data=st.data(), seed=st.integers(0, 2**20))
def test_many_scans_with_edges_pulses_comparisons_and_not_in_parallel(
    family: str, how: dict[str, bool], data: st.DataObject, seed: int
) -> None:
    ladder = enriched(data.draw(ladders(family, edges=family != "gutta", turned=True)), family, data)
    try:
        text = lower(ladder, family, **how)
    except NotRepresentableError as reason:
        assert re.search("does not begin there|holds no more than|may wait at once", reason.reason.en)  # noqa: PT017
        return
    program = stl.read(text, family)
    assert program.diagnostics == ()
    assert stl.write(program) == text
    inputs, outputs = bits(family)
    chance, plain, word = Random(seed), Plain(), WORDS[family][0]
    rows = [{**{name: chance.randint(0, 1) for name in inputs}, word: chance.randint(0, 4)} for _ in range(8)]
    trace = run(program, rows)
    for row, scan in zip(rows, trace.scans, strict=True):
        plain.words[word] = row[word]
        after = plain.scan(ladder, {name: bool(row[name]) for name in inputs})
        for name in outputs:
            assert repr(scan[name]) == str(int(after.get(name, False))), text


@pytest.mark.no_cover
@pytest.mark.parametrize("how", [{"grouped": True}, {"fused": False}, {"grouped": True, "fused": False}])
@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_grouped_joins_and_single_contacts_as_blocks_mean_the_same(
    family: str, how: dict[str, bool], data: st.DataObject
) -> None:
    ladder = data.draw(ladders(family))
    try:
        agrees(ladder, family, **how)
    except NotRepresentableError:
        assert how.get("grouped"), "only waiting joins need more levels than a small ladder's own"


@pytest.mark.parametrize(("family", "loads", "joins", "pair"), [
    ("s7-200", {"LD", "LDN"}, {"ALD", "OLD"}, ("LPS", "LPP")),
    ("gutta", {"LD", "LDN"}, {"ALD", "OLD"}, ("LPS", "LPP")),
    ("fx", {"LD", "LDI"}, {"ANB", "ORB"}, ("MPS", "MPP")),
    ("neza", {"AND(", "AND(N", "OR(", "OR(N", "LD", "LDN"}, {")"}, ("MPS", "MPP")),
])  # fmt: skip
@settings(max_examples=200, deadline=None)
@given(data=st.data())
def test_blocks_and_joins_pushes_and_pops_come_out_even(
    family: str, loads: set[str], joins: set[str], pair: tuple[str, str], data: st.DataObject
) -> None:
    words = [line.text.split()[0] for line in lower_lines(data.draw(rungs(family)), family)]
    assert sum(word in loads for word in words) == sum(word in joins for word in words) + 1
    open_ones = 0
    for word in words:
        open_ones += (word == pair[0]) - (word == pair[1])
        assert open_ones >= 0
    assert open_ones == 0


@settings(max_examples=200, deadline=None)
@given(data=st.data(), row=st.integers(0, CASES - 1), state=st.integers(0, 7))
def test_meaning_agrees_with_plain_truth_values(data: st.DataObject, row: int, state: int) -> None:
    one = data.draw(rungs("s7-200", turned=True))
    inputs, outputs = bits("s7-200")
    truths = {name: bool((row | state << INPUTS) >> bit & 1) for bit, name in enumerate(inputs + outputs)}
    plain = Plain()
    plain.bits = {name: truths[name] for name in outputs}
    after = plain.scan(Ladder((one,)), {name: truths[name] for name in inputs})
    for name, value in meaning(one, {name: ONE if truth else ZERO for name, truth in truths.items()}).items():
        assert value == (ONE if after[name] else ZERO)


FIGURES = {
    "fig. 2": ("--[ X0 ]--[ X1 ]--+--( Y0 )\n--[ X2 ]--[ X3 ]--+", "LD X0/AND X1/LD X2/AND X3/ORB/OUT Y0"),
    "fig. 3": (
        "--[ X0 ]--+--+--[ X1 ]--( Y0 )\n--[ X5 ]--+  +--[ X2 ]--( Y1 )\n             +--[ X3 ]--( Y2 )",
        "LD X0/OR X5/MPS/AND X1/OUT Y0/MRD/AND X2/OUT Y1/MPP/AND X3/OUT Y2",
    ),
    "fig. 4": (
        ("|--[ X0 ]--+--[ X1 ]--+--[ X2 ]--( Y0 )--|\n|          |          +--[ X3 ]--( Y1 )--|\n"
        "|          +--[ X4 ]-------------( Y2 )--|"),
        "LD X0/MPS/AND X1/MPS/AND X2/OUT Y0/MPP/AND X3/OUT Y1/MPP/AND X4/OUT Y2",
    ),
    "fig. 5": (
        "--[ X0 ]--+--+--[ X1 ]--[ X4 ]--+--( Y0 )\n--[ X2 ]--+  +--[ X3 ]--[ X5 ]--+",
        "LD X0/OR X2/LD X1/AND X4/LD X3/AND X5/ORB/ANB/OUT Y0",
    ),
}  # fmt: skip


@pytest.mark.parametrize("figure", FIGURES)
def test_the_figures_of_the_article_on_the_stack(figure: str) -> None:
    drawing, expected = FIGURES[figure]
    assert listing(drawing, "fx") == expected


MANUALS = [
    ("s7-200", "I0.0·(I0.1 + I2.0·I2.1) -> Q5.0", "LD I0.0/LD I0.1/LD I2.0/A I2.1/OLD/ALD/= Q5.0"),
    (
        "s7-200", "I0.0 -> ((I0.5 + I0.6) -> Q7.0), ((I2.1 + I1.3) -> Q6.0), (I1.0 -> Q3.0)",
        "LD I0.0/LPS/LD I0.5/O I0.6/ALD/= Q7.0/LRD/LD I2.1/O I1.3/ALD/= Q6.0/LPP/A I1.0/= Q3.0",
    ),
    ("s7-200", "(I0.0 + Q0.0)·/I0.1 -> Q0.0", "LD I0.0/O Q0.0/AN I0.1/= Q0.0"),
    ("s7-200", "I0.0 -> Q0.0, (I0.1 -> Q0.1)", "LD I0.0/= Q0.0/A I0.1/= Q0.1"),
    ("s7-200", "I0.0 -> Q0.0, Q0.1, S Q0.2 3", "LD I0.0/= Q0.0/= Q0.1/S Q0.2, 3"),
    ("s7-200", "I0.0·I0.1 + I0.2·I0.3 + I0.4·I0.5 -> Q0.0", "LD I0.0/A I0.1/LD I0.2/A I0.3/OLD/LD I0.4/A I0.5/OLD/= Q0.0"),
    ("s7-200", "(I0.0 + I0.1)·(I0.2 + I0.3) -> Q0.0", "LD I0.0/O I0.1/LD I0.2/O I0.3/ALD/= Q0.0"),
    ("s7-200", "I0.0·P I0.1 -> Q0.0", "LD I0.0/LD I0.1/EU/ALD/= Q0.0"),
    ("s7-200", "I0.0·I0.1·NOT -> Q0.0", "LD I0.0/A I0.1/NOT/= Q0.0"),
    ("s7-200", "I0.0 -> /Q0.0, Q0.1", "LD I0.0/LPS/NOT/= Q0.0/LPP/= Q0.1"),
    ("fx", "X0 -> Y2, ((X10 + X11) -> Y3)", "LD X0/OUT Y2/LD X10/OR X11/ANB/OUT Y3"),
    ("fx", "X0·P X1 + N X2 -> M0", "LD X0/ANDP X1/ORF X2/OUT M0"),
    ("fx", "X4·(/T30 + /T31) -> Y1", "LD X4/LDI T30/ORI T31/ANB/OUT Y1"),
    ("neza", "(%I0.0 + %Q0.1)·/%I0.1 -> %Q0.1", "LD %I0.0/OR %Q0.1/ANDN %I0.1/ST %Q0.1"),
    ("neza", "(%M1·/%Q0.0 + %Q0.0·/%M1)·%M0 -> %Q0.0", "LD %M1/ANDN %Q0.0/OR( %Q0.0/ANDN %M1/)/AND %M0/ST %Q0.0"),
    ("neza", "%I0.0·(P %I0.1 + /%I0.2) -> /%Q0.0", "LD %I0.0/AND(R %I0.1/ORN %I0.2/)/STN %Q0.0"),
    ("gutta", "I0.0·NOT + I0.0·I0.1 -> Q0.0", "LD I0.0/NOT/LD I0.0/A I0.1/OLD/= Q0.0"),
]  # fmt: skip


@pytest.mark.parametrize(("dialect", "line", "expected"), MANUALS)
def test_the_lists_of_the_manuals(dialect: str, line: str, expected: str) -> None:
    assert listing(line, dialect) == expected


def test_joins_grouped_at_the_end_and_contacts_as_blocks() -> None:
    three = "I0.0·I0.1 + I0.2·I0.3 + I0.4·I0.5 -> Q0.0"
    assert listing(three, "s7-200", grouped=True) == "LD I0.0/A I0.1/LD I0.2/A I0.3/LD I0.4/A I0.5/OLD/OLD/= Q0.0"
    mixed = "I0.0·I0.1 + I0.2·I0.3 + I0.4 -> Q0.0"
    assert listing(mixed, "s7-200", grouped=True) == "LD I0.0/A I0.1/LD I0.2/A I0.3/OLD/O I0.4/= Q0.0"
    assert listing("I0.0·I0.1 + I0.2 -> Q0.0", "gutta", fused=False) == "LD I0.0/LD I0.1/ALD/LD I0.2/OLD/= Q0.0"


def test_inserted_instructions_say_why() -> None:
    lines = lower_lines(ladder_of("X0·(X1 + X2·X3) -> (X4 -> Y1), Y2"), "fx")
    said = {line.text: line.reason for line in lines}
    assert said["ORB"].en == "two parallel blocks end here"
    assert "分支点" in said["MPS"].zh
    assert said["LD X0"].en == said["AND X3"].en == said["OUT Y1"].en == ""


def test_titles_head_networks_or_stand_above_as_comments() -> None:
    ladder = ladder_of("Network 1 // start 启动\nI0.0 -> Q0.0\n\nI0.1 -> Q0.1")
    assert lower(ladder, "s7-200") == "Network 1 // start 启动\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1\n"
    assert [network.title for network in stl.read(lower(ladder, "s7-200"), "s7-200").networks] == ["start 启动", ""]
    assert lower(ladder_of("RUNG 0 // start\nX0 -> Y0"), "fx") == "// start\nLD X0\nOUT Y0\n"


BLOCKS = parallel(*(series(Contact(f"I{n // 8}.{n % 8}"), Contact("M0.0")) for n in range(12)))
TALL = parallel(series(Contact("I0.0"), Contact("M0.0")), series(Contact("I0.1"), Contact("M0.1")))
for _level in range(10):
    TALL = parallel(Contact("I0.2"), series(Contact("I0.3"), TALL))

REFUSED = [
    ("s7-200", "X0 -> Q0.0", "no bit X0"),
    ("fx", "X8 -> Y0", "no bit X8"),
    ("s7-200", "I0.0 -> I0.1", "is an input"),
    ("neza", "P %Q0.0 -> %Q0.1", "does not take"),
    ("gutta", "P I0.0 -> Q0.0", "remembers the last flow"),
    ("fx", "X0 -> ((X1·NOT + X2) -> Y0), Y1", "does not begin there"),
    ("neza", "%I0.0 -> ((%I0.1·NOT + %I0.2) -> %Q0.0), %Q0.1", "does not begin there"),
    ("s7-200", "I0.0 -> ((I0.1·NOT + I0.2) -> Q0.0), Q0.1", "does not begin there"),
    ("s7-200", "I0.0·I0.1 + NOT -> Q0.0", "no contact on its left"),
    ("s7-200", "NOT·I0.0 -> Q0.0", "no contact on its left"),
    ("s7-200", "-> Q0.0", "left rail itself"),
    ("fx", "X0 -> S Y377 2", "not 2 bits"),
]


@pytest.mark.parametrize(("dialect", "line", "why"), REFUSED)
def test_what_a_family_cannot_say_is_refused_in_two_languages(dialect: str, line: str, why: str) -> None:
    with pytest.raises(NotRepresentableError, match=why) as caught:
        lower(ladder_of(line), dialect)
    assert caught.value.reason.zh.startswith("第1级写不成")


def test_more_than_the_stack_holds_is_refused() -> None:
    with pytest.raises(NotRepresentableError, match="no more than 9"):
        lower(rung(TALL, Coil("Q0.0")), "s7-200")
    assert lower(rung(TALL, Coil("Q0.0")), "s7-200-smart")
    assert lower(rung(BLOCKS, Coil("Q0.0")), "s7-200").count("OLD") == 11
    with pytest.raises(NotRepresentableError, match="no more than 9"):
        lower(rung(BLOCKS, Coil("Q0.0")), "s7-200", grouped=True)


@pytest.mark.parametrize("pushes", range(1, 11))
def test_eight_nested_branch_points_fit_into_nine_levels_and_the_ninth_does_not(pushes: int) -> None:
    inner = "Q0.0"
    for _ in range(pushes):
        inner = f"(I0.2 -> {inner}), (I0.3 -> Q0.1)"
    ladder = ladder_of(f"I0.0 -> {inner}")
    if pushes <= 8:
        assert lower(ladder, "s7-200").count("LPS") == lower(ladder, "s7-200").count("LPP") == pushes
    else:
        with pytest.raises(NotRepresentableError, match="no more than 9"):
            lower(ladder, "s7-200")


def test_absurdly_deep_ladders_are_refused_and_not_a_crash() -> None:
    node: Contact | Series = Contact("I0.0")
    for number in range(3000):
        node = Series((node, Contact("I0.1"))) if number % 2 else Series((Contact("I0.1"), node))
    with pytest.raises(NotRepresentableError, match="nested deeper"):
        lower(Rung(node, (Coil("Q0.0"),)), "s7-200")


SYMBOLS = [
    ("s7-200", "I0.0·[VW0 >= 5] + [VB1 <B 200]·[VD4 >R 1.5] -> Q0.0", "LD I0.0/AW>= VW0, 5/LDB< VB1, 200/AR> VD4, 1.5/OLD/= Q0.0"),
    ("s7-200", "[VD0 <>D VD4] + [T37 < 10] -> Q0.0", "LDD<> VD0, VD4/OW< T37, 10/= Q0.0"),
    ("fx", "[D0 = K5]·[D2 >D K70000] + X0·[D1 <= D3] -> Y0", "LD= D0 K5/ANDD> D2 K70000/LD X0/AND<= D1 D3/ORB/OUT Y0"),
    ("neza", "%I0.0·([%MW0 >= 5]·%I0.1 + [%C0.V = 3]) -> %Q0.0", "LD %I0.0/AND( [%MW0 >= 5]/AND %I0.1/OR [%C0.V = 3]/)/ST %Q0.0"),
    ("gutta", "[MW0 = 5]·([MW2 > MW4] + I0.0) -> Q0.0", "LDW= MW0, 5/LDW> MW2, MW4/O I0.0/ALD/= Q0.0"),
    ("s7-200", "I I0.0·(/I I0.1 + I I0.2) -> I Q0.0, SI Q0.1 2, RI Q0.4", "LDI I0.0/LDNI I0.1/OI I0.2/ALD/=I Q0.0/SI Q0.1, 2/RI Q0.4, 1"),
    ("fx", "X0 -> P M0, N M1", "LD X0/PLS M0/PLF M1"),
    ("s7-200", "I0.0 -> P M0.0, Q0.0", "LD I0.0/LPS/EU/= M0.0/LPP/= Q0.0"),
    ("s7-200", "I0.0·I0.1·P -> S Q0.0", "LD I0.0/A I0.1/EU/S Q0.0, 1"),
    ("fx", "X0·X1·N -> Y0", "LD X0/AND X1/MEF/OUT Y0"),
    ("gutta", "I0.0·P:M0.0 -> Q0.0", "LD I0.0/P M0.0/= Q0.0"),
    ("s7-200", "I0.0 -> {MOVW VW0, VW2}, (ENO -> {+I VW4, VW2})", "LD I0.0/MOVW VW0, VW2/AENO/+I VW4, VW2"),
    ("s7-200", "I0.0 -> {TON T37,50}, (I0.1 -> Q0.0)", "LD I0.0/TON T37, 50/A I0.1/= Q0.0"),
    ("s7-200", "I0.0 -> {CU: CTU C0, 3; R: I0.1 + I0.2·I0.3}", "LD I0.0/LD I0.1/LD I0.2/A I0.3/OLD/CTU C0, 3"),
    ("s7-200", "I0.0 -> {CU: CTUD C0, 3; R: I0.2; CD: I0.1}", "LD I0.0/LD I0.1/LD I0.2/CTUD C0, 3"),
    ("gutta", "I0.0 -> {ADD_I MW0, MW2, MW4}, {CTD C0, 5; LD: I0.1}", "LD I0.0/MOVW MW0, MW4/+I MW2, MW4/LD I0.1/CTD C0, 5"),
    ("neza", "%I0.0 -> {CU: BLK %C0; R: %I0.1}", "BLK %C0/LD %I0.0/CU/LD %I0.1/R/END_BLK"),
    ("neza", "%I0.0·%I0.1 -> {IN %TM0}, {[ %MW0 := %MW1 + 5 ]}", "LD %I0.0/AND %I0.1/IN %TM0/[%MW0 := %MW1 + 5]"),
    ("fx", "X0 -> {OUT T0 K10}, R C0, {MOV D0 D1}", "LD X0/OUT T0 K10/RST C0/MOV D0 D1"),
    ("s7-200", "I0.0 -> {S1: SR Q0.0; R: I0.1}", "LD I0.0/LD I0.1/NOT/A Q0.0/OLD/= Q0.0"),
    ("s7-200", "I0.0 -> {S: RS Q0.0; R1: I0.1}", "LD I0.0/LD I0.1/NOT/LPS/A Q0.0/= Q0.0/LPP/ALD/O Q0.0/= Q0.0"),
    ("s7-200", "-> {LBL 1}", "LBL 1"),
    ("neza", "-> {%L1:}", "%L1:"),
    ("fx", "-> {STL S20}\nX0 -> Y0\n-> {RET}", "STL S20/LD X0/OUT Y0/RET"),
    ("s7-200", "I0.0·(I0.1·NOT + I0.2) -> Q0.0", "LD I0.0/LPS/A I0.1/NOT/LDS 1/A I0.2/OLD/= Q0.0"),
    ("s7-200", "I0.0·(NOT + I0.1) -> Q0.0", "LD I0.0/LPS/NOT/LDS 1/A I0.1/OLD/= Q0.0"),
    (
        "s7-200",
        "I0.0·(NOT + I0.1)·(NOT + I0.2) -> Q0.0",
        "LD I0.0/LPS/NOT/LDS 1/A I0.1/OLD/LPS/NOT/LDS 1/A I0.2/OLD/= Q0.0",
    ),
    ("gutta", "I0.0·(NOT + I0.1) -> Q0.0", "LD I0.0/NOT/LD I0.0/A I0.1/OLD/= Q0.0"),
    ("gutta", "I0.0·P:M0.0·(NOT + I0.1) -> Q0.0", "LD I0.0/P M0.0/LPS/NOT/LD SM0.0/LPP/A I0.1/OLD/= Q0.0"),
    ("fx", "X0·(NOT + X1) -> Y0", "LD X0/INV/LD X0/AND X1/ORB/OUT Y0"),
    ("neza", "%I0.0·(NOT + %I0.1) -> %Q0.0", "LD %I0.0/N/OR( %I0.0/AND %I0.1/)/ST %Q0.0"),
]  # fmt: skip


@pytest.mark.parametrize(("dialect", "line", "expected"), SYMBOLS)
def test_every_symbol_in_its_familys_spelling(dialect: str, line: str, expected: str) -> None:
    text = lower(ladder_of(line), dialect)
    assert listing(line, dialect) == expected
    again = stl.read(text, dialect)
    assert not again.diagnostics
    assert [one.text for one in again.lines] == expected.split("/")


WRONG = [
    ("s7-200", Box("TON T37, 99999"), "lies between 0 and 32767"),
    ("s7-200", Box("FOO 1"), "has no instruction FOO"),
    ("s7-200", Box("TON T37, 5; = Q0.0"), "more than one instruction"),
    ("s7-200", Box("TON T37, 5\nNetwork 2\nLD I0.0"), "TON is complete before"),
    ("s7-200", Box("LPS"), "is no output"),
    ("s7-200", Box("EU"), "is no output"),
    ("s7-200", Box("LBL 1"), "takes no flow"),
    ("s7-200", Box("CTU C0, 3"), "CU, R, each once, a row each"),
    ("s7-200", Box("CTU C0, 3", (("RST", Contact("I0.1")),), "CU"), "CU, R, each once"),
    ("s7-200", Box("CTU C0, 3", (("R", Contact("I0.1")), ("R", Contact("I0.2"))), "CU"), "CU, R, each once"),
    ("s7-200", Box("SR I0.0", (("R", Contact("I0.1")),), "S1"), "is an input"),
    ("s7-200", Box("SR Q0.0; = Q0.1", (("R", Contact("I0.1")),), "S1"), "not one bit"),
    ("fx", Box("TON T37, 5"), "has no instruction TON"),
    ("neza", Box("BLK %C0", (), "IN"), "R, S, CU, CD, each once"),
    ("neza", Box("BLK %C0"), "R, S, CU, CD, each once"),
    ("neza", Box("BLK %C99", (), "CU"), "%C99"),
]  # fmt: skip


@pytest.mark.parametrize(("dialect", "box", "why"), WRONG)
def test_a_box_that_does_not_read_is_refused_with_the_readers_words(dialect: str, box: Box, why: str) -> None:
    first = {"s7-200": "I0.0", "fx": "X0", "neza": "%I0.0"}[dialect]
    with pytest.raises(NotRepresentableError, match=re.escape(why)) as caught:
        lower(rung(Contact(first), box), dialect)
    assert not caught.value.reason.en.endswith("..")
    assert caught.value.reason.zh.startswith("第1级写不成")


REFUSED_SYMBOLS = [
    ("neza", "%I0.0·P -> %Q0.0", "no instruction for an edge of the flow"),
    ("gutta", "I0.0·P -> Q0.0", "write P:bit"),
    ("gutta", "I0.0 -> P Q0.0", "write P:bit"),
    ("neza", "%I0.0 -> P %Q0.0", "no instruction for an edge of the flow"),
    ("s7-200", "I0.0·P:M0.0 -> Q0.0", "no use for M0.0"),
    ("fx", "I X0 -> Y0", "immediately"),
    ("fx", "X0 -> I Y0", "the coil"),
    ("s7-200", "I M0.0 -> Q0.0", "does not take"),
    ("neza", "[%MW0 >D 5] -> %Q0.0", "no comparing contact"),
    ("s7-200", "[X0 > 5] -> Q0.0", "X0 does not read"),
    ("fx", "X0·ENO -> Y0", "no instruction for the contact"),
    ("s7-200", "-> {TON T37, 5}", "a contact must come first"),
]


@pytest.mark.parametrize(("dialect", "line", "why"), REFUSED_SYMBOLS)
def test_a_symbol_that_a_family_has_no_word_for_is_refused(dialect: str, line: str, why: str) -> None:
    with pytest.raises(NotRepresentableError, match=why) as caught:
        lower(ladder_of(line), dialect)
    assert caught.value.reason.zh.startswith("第1级写不成")


def test_no_words_of_a_comparison_reach_the_list_unread() -> None:
    evil = Compared("VW0, 5\n= Q0.7\nLDW> VW0", ">", "5")
    with pytest.raises(NotRepresentableError, match="not one comparison"):
        lower(rung(evil, Coil("Q0.0")), "s7-200")


@pytest.mark.parametrize("box", ["{S1: SR Q0.0; R: I0.1}", "{S: RS Q0.0; R1: I0.1}"])
def test_bistables_do_what_their_names_say_and_have_no_double_coil(box: str) -> None:
    program = stl.read(lower(ladder_of(f"I0.0 -> {box}"), "s7-200"), "s7-200")
    assert not lint(program)
    state = 0
    for at in range(40):
        chance = Random(at)
        rows = [(chance.randint(0, 1), chance.randint(0, 1)) for _ in range(6)]
        trace = run(program, [{"I0.0": s, "I0.1": r} for s, r in rows])
        state = 0
        for (s, r), scan in zip(rows, trace.scans, strict=True):
            state = (s | (state & (1 - r))) if "SR" in box else ((s | state) & (1 - r))
            assert repr(scan["Q0.0"]) == str(state)


def test_a_box_of_several_inputs_behind_branches_and_kept_flows_finds_its_inputs() -> None:
    text = lower(
        ladder_of("I0.0·(NOT + I0.1) -> (I0.2 -> Q0.1), {CU: CTUD C0, 2; CD: I0.3; R: I0.4}\n\nC0 -> Q0.0"), "s7-200"
    )
    program = stl.read(text, "s7-200")
    value, before = 0, None
    chance = Random(5)
    rows = [
        {f"I0.{bit}": chance.randint(0, 1) for bit in range(4)} | {"I0.4": chance.randint(0, 9) // 9} for _ in range(60)
    ]
    for row, scan in zip(rows, run(program, rows).scans, strict=True):
        up, down = (1 - row["I0.0"]) | (row["I0.0"] & row["I0.1"]), row["I0.3"]
        rises = (0, 0) if before is None else (up & (1 - before[0]), down & (1 - before[1]))
        value, before = 0 if row["I0.4"] else value + rises[0] - rises[1], (up, down)
        assert repr(scan["Q0.0"]) == str(int(value >= 2 and not row["I0.4"]))


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=80, deadline=None)
@given(data=st.data())
def test_each_line_knows_the_symbol_it_stands_for_or_why_it_is_there(family: str, data: st.DataObject) -> None:
    ladder = enriched(data.draw(ladders(family, turned=True)), family, data)
    try:
        lines = lower_lines(ladder, family)
    except NotRepresentableError:
        return
    for line in lines:
        if line.symbol is None:
            assert line.reason.zh
            assert line.reason.en
        else:
            symbol = ladder.rungs[line.rung].symbols[line.symbol]
            word = getattr(symbol, "address", "") or getattr(symbol, "memory", "") or getattr(symbol, "left", "")
            assert word in line.text or not isinstance(symbol, Contact)
    for number, one in enumerate(ladder.rungs):
        shown = {line.symbol for line in lines if line.rung == number} - {None}
        assert shown == set(range(len(one.symbols)))


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=80, deadline=None)
@given(data=st.data())
def test_no_stack_is_ever_deeper_than_the_familys(family: str, data: st.DataObject) -> None:
    ladder = enriched(data.draw(ladders(family, turned=True)), family, data, words=False)
    try:
        program = stl.read(lower(ladder, family), family)
    except NotRepresentableError:
        return
    assert not [one for one in lint(program) if one.severity == "error" and one.code.startswith("STK")]


@settings(max_examples=120, deadline=None)
@given(data=st.data(), seed=st.integers(0, 2**20))
def test_meaning_agrees_with_plain_values_over_scans(data: st.DataObject, seed: int) -> None:
    (one,) = enriched(Ladder((data.draw(rungs("fx", turned=True)),)), "fx", data).rungs
    inputs, outputs = bits("fx")
    plain, chance, flows = Plain(), Random(seed), {}
    state = dict.fromkeys(outputs, ZERO)
    relations = {
        "=": int.__eq__,
        "<>": int.__ne__,
        ">=": int.__ge__,
        "<=": int.__le__,
        ">": int.__gt__,
        "<": int.__lt__,
    }
    for _ in range(6):
        row, number = {name: chance.randint(0, 1) for name in inputs}, chance.randint(0, 4)
        plain.words["D0"] = number
        after = plain.scan(Ladder((one,)), {name: bool(value) for name, value in row.items()})
        compared = {
            each.text: ONE if relations[each.relation](number, int(each.right[1:])) else ZERO
            for each in one.symbols
            if isinstance(each, Compared)
        }
        truths = {name: ONE if value else ZERO for name, value in row.items()}
        state |= meaning(one, {**truths, **state, **compared}, flows=flows)
        assert {name: state[name] for name in outputs} == {name: ONE if after.get(name) else ZERO for name in outputs}


def test_a_meaning_leaves_boxes_out_and_keeps_a_memory_bit() -> None:
    (one,) = ladder_of("I0.0·P:M0.0 -> {TON T37, 5}, Q0.0").rungs
    bits_now = {"I0.0": ONE, "M0.0": ZERO, "Q0.0": ZERO}
    assert meaning(one, bits_now) == {"M0.0": ONE, "Q0.0": ONE}
    assert meaning(one, {**bits_now, "M0.0": ONE}) == {"M0.0": ONE, "Q0.0": ZERO}
