"""A translated program does what the other does: both are run over the same inputs, and there and back again is proved equal."""

from __future__ import annotations

import random
import sys
from itertools import permutations
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach import stl
from plcteach.check.lint import lint
from plcteach.check.same import compare
from plcteach.core.diagnostic import errors
from plcteach.core.errors import NotRepresentableError
from plcteach.core.ladder import Coil, Contact, Ladder, Rung
from plcteach.dialects import dialect
from plcteach.ladder.lower import lower
from plcteach.ladder.translate import Translation, translate, translate_ladder
from plcteach.machine import run

sys.path.insert(0, str(Path(__file__).parent))
from typing import TYPE_CHECKING

from random_ladders import FAMILIES, bits, enriched, ladders

if TYPE_CHECKING:
    from plcteach.core.program import Program


PAIRS = list(permutations(FAMILIES, 2))


def program(text: str, family: str) -> Program:
    found = stl.read(text, family)
    assert not errors(found.diagnostics), found.diagnostics
    return found


def across(text: str, family: str, to: str) -> Translation:
    made = translate(program(text, family), to)
    assert not errors(made.program.diagnostics), made.text
    return made


def runs(one: Program, scans: list[dict[str, int]], names: list[str]) -> list[list[str]]:
    trace = run(one, scans)
    return [[repr(scan[name]) for name in names] for scan in trace.scans]


@pytest.mark.no_cover
@pytest.mark.parametrize(("family", "to"), PAIRS)
@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_there_and_back_again_is_the_same_machine(family: str, to: str, data: st.DataObject) -> None:
    drawn = data.draw(ladders(family, edges=family != "gutta", turned=True))
    ladder = enriched(drawn, family, data, words=False)
    try:
        text = lower(ladder, family)
    except NotRepresentableError:
        return
    first = program(text, family)
    there = across(text, family, to)
    back = translate(there.program, family)
    for note in (*there.notes, *back.notes):
        assert "does not begin there" in note.en or "no way to write" in note.en, note
    if there.notes or back.notes:
        return
    assert not errors(back.program.diagnostics)
    inputs, outputs = bits(family)
    table = there.addresses
    seed = data.draw(st.integers(0, 2**16))
    rows = [{name: random.Random(seed + at * 8 + n).randint(0, 1) for n, name in enumerate(inputs)} for at in range(9)]
    named = [name for name in outputs if name in table]
    mine = runs(first, rows, named)
    theirs = runs(
        there.program, [{table[name]: value for name, value in row.items() if name in table} for row in rows],
        [table[name] for name in named],
    )  # fmt: skip
    assert mine == theirs, f"{text}\n{there.text}"
    assert mine == runs(back.program, rows, named), f"{text}\n{there.text}\n{back.text}"
    verdict = compare(first, back.program)
    assert verdict.status in {"equal", "unknown"}, f"{text}\n{there.text}\n{back.text}"


TIMERS = [
    ("s7-200", "Network 1\nLD I0.0; TON {t}\nNetwork 2\nLD {b}; = Q0.0", ("T37, 3", "T37")),
    ("s7-200", "Network 1\nLD I0.0; TOF {t}\nNetwork 2\nLD {b}; = Q0.0", ("T38, 4", "T38")),
    ("s7-200", "Network 1\nLD I0.0; TONR {t}\nNetwork 2\nLD I0.1; R {b}, 1\nNetwork 3\nLD {b}; = Q0.0", ("T5, 3", "T5")),
    ("s7-200", "Network 1\nLD I0.0; TONR {t}\nNetwork 2\nLD I0.1; R {b}, 1\nNetwork 3\nLD {b}; = Q0.0", ("T1, 17", "T1")),
    ("gutta", "Network 1\nLD I0.0; TOF {t}\nNetwork 2\nLD {b}; = Q0.0", ("T101, 2", "T101")),
    ("fx", "LD X0; OUT {t}; LD {b}; OUT Y0", ("T0 K3", "T0")),
    ("fx", "LD X0; OUT {t}; LD {b}; OUT Y0", ("T200 K30", "T200")),
    ("fx", "LD X0; OUT {t}; LD X1; RST {b}; LD {b}; OUT Y0", ("T250 K2", "T250")),
    ("neza", "%TM0: TYPE=TON TB=100ms P=3\nLD %I0.0; {t}; LD {b}; ST %Q0.0", ("IN %TM0", "%TM0.Q")),
    ("neza", "%TM0: TYPE=TOF TB=10ms P=40\nLD %I0.0; {t}; LD {b}; ST %Q0.0", ("IN %TM0", "%TM0.Q")),
    ("neza", "%TM0: TYPE=TON TB=1s P=1\nBLK %TM0; LD %I0.0; IN; OUT_BLK; LD Q; ST %Q0.0; END_BLK", ("", "")),
]  # fmt: skip


def driven(seed: int, names: list[str]) -> list[dict[str, int]]:
    """Hold random inputs for random times, with scans of 10 to 60 ms."""
    chance = random.Random(seed)
    rows: list[dict[str, int]] = []
    for _ in range(14):
        held = {name: chance.randint(0, 1) for name in names}
        rows += [{**held, "ms": chance.choice([10, 20, 60])} for _ in range(chance.randint(1, 22))]
    return rows


def mapped(rows: list[dict[str, int]], table: dict[str, str]) -> list[dict[str, int]]:
    return [
        {table.get(name, name): value for name, value in row.items() if name == "ms" or name in table} for row in rows
    ]


@pytest.mark.parametrize("to", FAMILIES)
@pytest.mark.parametrize(("family", "text", "parts"), TIMERS)
def test_a_timer_takes_the_same_time(family: str, text: str, parts: tuple[str, str], to: str) -> None:
    given_text = text.format(t=parts[0], b=parts[1])
    made = across(given_text, family, to)
    missing = [note.en for note in made.notes if "left out" in note.en]
    if missing:
        assert to == "neza"
        assert "TONR" in given_text or "T250" in given_text
        return
    inputs, outputs = bits(family)
    names = [name for name in inputs if name in made.addresses]
    late = any("A timer's bit changes" in note.en for note in made.notes)
    for seed in range(6):
        rows = driven(seed, names)
        mine = [row[0] for row in runs(program(given_text, family), rows, outputs[:1])]
        theirs = [row[0] for row in runs(made.program, mapped(rows, made.addresses), [made.addresses[outputs[0]]])]
        if not late:
            assert mine == theirs
            continue
        for at in range(1, len(mine) - 1):
            assert mine[at] in theirs[at - 1 : at + 2]
            assert theirs[at] in mine[at - 1 : at + 2]


COUNTERS = [
    ("s7-200", "Network 1\nLD I0.0; LD I0.1; CTU C3, 3\nNetwork 2\nLD C3; = Q0.0"),
    ("gutta", "Network 1\nLD I0.0; A I0.2; LD I0.1; O I0.3; CTU C0, 2\nNetwork 2\nLD C0; = Q0.0"),
    ("fx", "LD X0; OUT C0 K3; LD X1; RST C0; LD C0; OUT Y0"),
    ("fx", "LD X0; OUT C7 K2; LD X2; OUT Y1; LD X1; RST C7; LD C7; OUT Y0"),
    ("neza", "%C0: P=3\nBLK %C0; LD %I0.1; R; LD %I0.0; CU; END_BLK; LD %C0.D; ST %Q0.0"),
    ("neza", "%C0: P=3\nLD %I0.1; R %C0; LD %I0.0; CU %C0; LD %C0.D; ST %Q0.0"),
]


@pytest.mark.parametrize("to", FAMILIES)
@pytest.mark.parametrize(("family", "text"), COUNTERS)
def test_a_counter_counts_the_same(family: str, text: str, to: str) -> None:
    made = across(text, family, to)
    assert not [note for note in made.notes if "left out" in note.en]
    inputs, outputs = bits(family)
    for seed in range(12):
        chance = random.Random(seed)
        rows = [{name: chance.randint(0, 3) // (3 if name == inputs[1] else 2) for name in inputs} for _ in range(40)]
        mine = runs(program(text, family), rows, outputs[:1])
        assert mine == runs(made.program, mapped(rows, made.addresses), [made.addresses[outputs[0]]]), made.text


def test_a_reset_above_a_counter_becomes_its_input_and_the_difference_is_said() -> None:
    made = across("LD X1; RST C0; LD X0; OUT C0 K3; LD C0; OUT Y0", "fx", "s7-200")
    assert "LD I0.0\nLD I0.1\nCTU C0, 3\n" in made.text
    assert any("still counts 1" in note.en for note in made.notes)


WORDS = [
    ("s7-200", "LD I0.0; EU; +I 5, VW0\nNetwork 2\nLDW>= VW0, 12; = Q0.0\nNetwork 3\nLD I0.1; MOVW 0, VW0"),
    ("fx", "LDP X0; ADD D0 K5 D0; LD>= D0 K12; OUT Y0; LD X1; MOV K0 D0"),
    ("fx", "LD X0; INCP D3; LD> D3 K2; OUT Y0; LD X1; MOVP K0 D3"),
    ("neza", "LDR %I0.0; [%MW4 := %MW4 + 5]; LD [%MW4 >= 12]; ST %Q0.0; LD %I0.1; [%MW4 := 0]"),
    ("gutta", "Network 1\nLD I0.0; P M0.0; MOVW VW0, VW4; +I 3, VW4; MOVW VW4, VW0\nNetwork 2\nLDW> VW0, 7; = Q0.0"),
]  # fmt: skip


@pytest.mark.parametrize("to", FAMILIES)
@pytest.mark.parametrize(("family", "text"), WORDS)
def test_moves_sums_and_comparisons_do_the_same(family: str, text: str, to: str) -> None:
    made = across(text, family, to)
    assert not [note for note in made.notes if "left out" in note.en]
    inputs, outputs = bits(family)
    for seed in range(6):
        chance = random.Random(seed)
        rows = [{inputs[0]: chance.randint(0, 1), inputs[1]: chance.randint(0, 7) // 7} for _ in range(30)]
        mine = runs(program(text, family), rows, outputs[:1])
        assert mine == runs(made.program, mapped(rows, made.addresses), [made.addresses[outputs[0]]]), made.text


TABLE = [
    ("s7-200", "LD I0.7; A I1.0; = Q1.1", "fx", {"I0.7": "X7", "I1.0": "X10", "Q1.1": "Y11"}),
    ("fx", "LD X7; AND X10; OUT Y10", "neza", {"X7": "%I0.7", "X10": "%I0.8", "Y10": "%Q0.8"}),
    ("neza", "LD %I0.8; AND %M9; ST %Q0.3", "gutta", {"%I0.8": "I1.0", "%M9": "M1.1", "%Q0.3": "Q0.3"}),
    ("s7-200", "LD SM0.1; O SM0.5; AN SM0.0; = M0.0", "fx", {"SM0.1": "M8002", "SM0.5": "M8013", "SM0.0": "M8000", "M0.0": "M0"}),
    ("fx", "LD M8002; OR M8001; OUT Y0", "s7-200", {"M8002": "SM0.1", "M8001": "/SM0.0", "Y0": "Q0.0"}),
    ("s7-200", "LD SM0.1; = Q0.0", "neza", {"SM0.1": "%S13", "Q0.0": "%Q0.0"}),
    ("s7-200", "LD I0.0; MOVW VW2, VW6", "fx", {"I0.0": "X0", "VW2": "D1", "VW6": "D3"}),
    ("fx", "LD X0; MOV D1 D3", "neza", {"X0": "%I0.0", "D1": "%MW1", "D3": "%MW3"}),
]  # fmt: skip


@pytest.mark.parametrize(("family", "text", "to", "table"), TABLE)
def test_addresses_go_by_the_table_in_order_of_first_appearance(
    family: str, text: str, to: str, table: dict[str, str]
) -> None:
    made = across(text, family, to)
    assert list(made.addresses.items()) == list(table.items())
    assert made.text.splitlines()[: len(table)] == [f"// {old} -> {new}" for old, new in table.items()]
    assert not made.notes


def test_the_example_of_the_task_is_one_time_in_three_families() -> None:
    text = "LD I0.0; TON T37, 50"
    assert "OUT T0 K50" in across(text, "s7-200", "fx").text
    assert "%TM0: TYPE=TON TB=100ms P=50\nLD %I0.0\nIN %TM0\n" in across(text, "s7-200", "neza").text
    assert "TON T37, 50" in across(text, "s7-200", "gutta").text


LOST = [
    ("s7-200", "LD I0.0; SHRB I0.1, M0.0, 4; = Q0.0", "fx", "SHRB I0.1, M0.0, 4"),
    ("s7-200", "Network 1\nLD I0.0; JMP 1\nNetwork 2\nLD I0.1; = Q0.0\nNetwork 3\nLBL 1", "fx", "JMP 1"),
    ("fx", "LD X0; MC N0 M100; LD X1; OUT Y0; MCR N0", "s7-200", "MC N0 M100"),
    ("neza", "%TM0: TYPE=TP TB=10ms P=5\nLD %I0.0; IN %TM0; LD %I0.1; ST %Q0.0", "s7-200", "IN %TM0"),
    ("neza", "LD %I0.0; XOR %I0.1; ST %Q0.0; LD %I0.2; U %DR0", "s7-200", "U %DR0"),
    ("s7-200", "LD I0.0; MOVR 1.5, VD0", "neza", "MOVR 1.5, VD0"),
    ("s7-200", "LDB> VB0, 5; = Q0.0", "fx", "LDB> VB0, 5"),
    ("s7-200", "LD I0.0; CALL SBR0\nSUBROUTINE_BLOCK SBR_0:SBR0\nLD I0.1; = Q0.1\nEND_SUBROUTINE_BLOCK", "gutta", "CALL SBR0"),
    ("s7-200", "LD I0.0; LD I0.1; CTD C0, 3", "fx", "CTD C0, 3"),
]  # fmt: skip


@pytest.mark.parametrize(("family", "text", "to", "word"), LOST)
def test_what_has_no_counterpart_is_named_and_stands_as_a_comment(family: str, text: str, to: str, word: str) -> None:
    made = translate(program(text, family), to)
    told = [note for note in made.notes if word in note.en and "line" in note.en]
    assert told
    assert word in told[0].zh
    assert any(row.startswith("//") and row.endswith(word) for row in made.text.splitlines())
    assert not errors(made.program.diagnostics)


def test_every_output_line_of_a_program_is_written_or_named() -> None:
    text = "Network 1\nLD I0.0; LDS 3; = Q0.0; = Q0.1\nNetwork 2\nLD I0.1; = Q0.2"
    made = translate(program(text, "s7-200"), "fx")
    for line in program(text, "s7-200").lines:
        if line.insn.then and line.text != "= Q0.2":
            assert any(line.text in note.en for note in made.notes), made.notes
    assert "OUT Y2" in made.text


@pytest.mark.parametrize(("family", "to"), PAIRS)
def test_every_example_of_a_family_reads_and_stacks_well_in_the_other(family: str, to: str) -> None:
    for text in dialect(family).examples:
        given_program = program(text, family)
        made = translate(given_program, to)
        assert not [
            one for one in lint(made.program) if one.severity == "error" and one.code.startswith(("STK", "RDR"))
        ]
        assert made.text.startswith("// ") or not made.addresses
        if not made.program.lines:
            assert made.notes


def test_a_drawing_can_be_translated_too() -> None:
    ladder = Ladder((Rung(Contact("X0"), (Coil("Y0"),), "start"),))
    assert translate_ladder(ladder, "fx", "s7-200").text.endswith("Network 1 // start\nLD I0.0\n= Q0.0\n")
