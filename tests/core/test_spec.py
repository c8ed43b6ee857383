"""A family's table: what is refused when it is imported, by name, and how addresses are read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plcteach import dialects
from plcteach.core.area import Address, Area, kind
from plcteach.core.errors import DeclarationError, UnknownNameError
from plcteach.core.insn import Operand, insn, parse_operand
from plcteach.core.spec import Dialect, Sample, Stack
from plcteach.core.text import Text
from plcteach.core.verb import coil, set_

S7 = dialects.dialect("s7-200")
FX = dialects.dialect("fx")


def row(mnemonic: str, operands: str, effect: str, **more: object):
    return insn(mnemonic, operands, effect, zh="例", en="an example", **more)  # type: ignore[arg-type]


# Rows that cannot work.


@pytest.mark.parametrize(
    ("operands", "effect", "named"),
    [
        ("", "-- bit", "bit"),
        ("bit", "a -- a&bti", "bti"),
        ("", "-- [n]", "n"),
        ("bit", "a -- b", "b"),
    ],
)
def test_an_operand_that_nobody_declares_is_refused_by_name(operands: str, effect: str, named: str) -> None:
    with pytest.raises(DeclarationError, match=rf"XYZ: {named} stands in no stack"):
        row("XYZ", operands, effect)


def test_the_operands_of_a_verb_must_be_declared_too() -> None:
    with pytest.raises(DeclarationError, match="XYZ: out "):
        row("XYZ", "bit", "a -- a", then=coil("a"))
    with pytest.raises(DeclarationError, match="XYZ: N "):
        row("XYZ", "out", "a -- a", then=set_("a", "N"))
    with pytest.raises(DeclarationError, match="XYZ: b "):
        row("XYZ", "out", "a -- a", then=coil("b"))


@pytest.mark.parametrize("which", ["fresh", "bare", "close"])
def test_further_effects_are_looked_at_as_well(which: str) -> None:
    with pytest.raises(DeclarationError, match="XYZ: bti"):
        row("XYZ", "bit", "a -- a&bit", **{which: "-- bti"})


@pytest.mark.parametrize("text", ["", "n:", "n:1..", "n:..8", "n:1..2..3", "a-b", "bit:", "?"])
def test_an_operand_in_no_known_form_is_refused(text: str) -> None:
    with pytest.raises(DeclarationError, match="expected name"):
        parse_operand(text)


def test_operands_are_kinds_or_numbers() -> None:
    assert parse_operand("bit") == Operand("bit", "bit")
    assert parse_operand("m:out") == Operand("m", "out")
    assert parse_operand("bit?") == Operand("bit", "bit", optional=True)
    assert parse_operand("n:0..8") == Operand("n", "", 0, 8)
    assert parse_operand("n:0..8").number
    assert not parse_operand("bit").number


def test_a_place_below_the_top_is_counted_by_a_number() -> None:
    with pytest.raises(DeclarationError, match="LDS"):
        row("LDS", "n:bit", "-- [n]")


# Tables that contradict themselves.


def broken(**changes: object) -> Callable[[], Dialect]:
    return lambda: replace(S7, **changes)  # type: ignore[arg-type]


LD = S7.insn("LD")


@pytest.mark.parametrize(
    ("make", "named"),
    [
        (broken(insns=(*S7.insns, row("PUSH", "", "a -- a ; aux: -- a"))), "PUSH"),
        (broken(insns=(*S7.insns, row("LDZ", "bit:zeta", "-- bit"))), "LDZ"),
        (broken(roles={**S7.roles, "load": "LOAD"}), "LOAD"),
        (broken(insns=(*S7.insns, row("LD", "bit", "-- !bit"))), "LD"),
        (broken(samples=(Sample("STK999", "LD I0.0", "= Q0.0"),)), "STK999"),
        (broken(kinds={**S7.kinds, "bit": kind("I Zeta", zh="位", en="a bit")}), "Zeta"),
    ],
    ids=["stack", "kind", "role", "twice", "sample", "area of a kind"],
)
def test_a_table_that_contradicts_itself_is_refused_and_says_where(make: Callable[[], Dialect], named: str) -> None:
    with pytest.raises(DeclarationError) as caught:
        make()
    assert "s7-200" in str(caught.value)
    assert named in str(caught.value)


def test_the_tables_that_come_with_plcteach_stand() -> None:
    for name in dialects.names():
        family = dialects.dialect(name)
        assert replace(family) == family
        assert set(family.specials) <= {
            one.text for one in map(family.address, family.specials) if isinstance(one, Address)
        }
        assert not family.recognised & set(family.words), "an instruction is either run or only recognised"
        assert set(family.aliases.values()) <= set(family.words)
        assert not set(family.aliases) & set(family.words)


def test_dialects_are_asked_for_by_name() -> None:
    assert dialects.names() == ("s7-200", "s7-200-smart", "fx", "neza", "gutta")
    assert [one.name for one in dialects.families()] == ["s7-200", "fx", "neza", "gutta"]
    assert dialects.dialect(" S7_200 ") is S7
    assert dialects.dialect(FX) is FX
    with pytest.raises(UnknownNameError, match="Did you mean gutta"):
        dialects.dialect("guta")


def test_the_smart_differs_from_the_s7_200_in_depth_only() -> None:
    smart = dialects.dialect("s7-200-smart")
    assert (S7.stacks[0].depth, smart.stacks[0].depth) == (9, 32)
    assert [one.last for one in S7.insn("LDS").operands] == [8]
    assert [one.last for one in smart.insn("LDS").operands] == [31]
    assert set(smart.words) == set(S7.words)


def test_an_instruction_is_asked_for_by_mnemonic_or_alias() -> None:
    assert S7.insn("old").mnemonic == "OLD"
    assert S7.insn("un").mnemonic == "AN"
    with pytest.raises(UnknownNameError, match="ALD"):
        S7.insn("ALDD")


# Where bits are.


@pytest.mark.parametrize(
    ("family", "word", "text"),
    [
        ("s7-200", "i0.0", "I0.0"),
        ("s7-200", "E0.1", "I0.1"),
        ("s7-200", "A1.7", "Q1.7"),
        ("s7-200", "SM0.0", "SM0.0"),
        ("s7-200", "T37", "T37"),
        ("s7-200", "V10239.7", "V10239.7"),
        ("fx", "X000", "X0"),
        ("fx", "x17", "X17"),
        ("fx", "M8002", "M8002"),
        ("neza", "%i0.1", "%I0.1"),
        ("neza", "%M7", "%M7"),
        ("neza", "%S13", "%S13"),
        ("gutta", "M31.7", "M31.7"),
    ],
)
def test_an_address_has_one_canonical_spelling(family: str, word: str, text: str) -> None:
    found = dialects.dialect(family).address(word)
    assert isinstance(found, Address)
    assert found.text == text
    assert repr(found) == text


@pytest.mark.parametrize(
    ("family", "word"),
    [("s7-200", "I0.8"), ("s7-200", "I16.0"), ("s7-200", "Q16.0"), ("s7-200", "T256"), ("fx", "X8"), ("fx", "X9"),
     ("fx", "X400"), ("fx", "M7680"), ("fx", "M7999"), ("fx", "M8512"), ("neza", "%M256"), ("s7-200", "I" + "9" * 5_000)],
)  # fmt: skip
def test_an_address_beyond_its_area_gives_the_area(family: str, word: str) -> None:
    assert isinstance(dialects.dialect(family).address(word), Area)


@pytest.mark.parametrize(
    ("family", "word"),
    [("s7-200", "I00"), ("s7-200", "I0.0.0"), ("s7-200", "T3.1"), ("s7-200", "motor"), ("fx", "X0.0"), ("fx", "X"),
     ("neza", "I0.0"), ("s7-200", ""), ("s7-200", "I²")],
)  # fmt: skip
def test_what_reads_as_nothing_is_none(family: str, word: str) -> None:
    assert dialects.dialect(family).address(word) is None


@given(st.integers(0, 255))
def test_octal_areas_count_as_python_does(number: int) -> None:
    address = FX.address(f"X{number:o}")
    assert isinstance(address, Address)
    assert (address.index, address.text) == (number, f"X{number:o}")


@given(st.integers(0, 127))
def test_byte_areas_count_eight_bits_a_byte(number: int) -> None:
    address = S7.address(f"Q{number // 8}.{number % 8}")
    assert isinstance(address, Address)
    assert address.index == number


def test_following_goes_over_the_byte_and_stops_at_the_areas_end() -> None:
    start = S7.address("Q0.6")
    last = S7.address("Q15.6")
    assert isinstance(start, Address)
    assert isinstance(last, Address)
    assert [one.text for one in S7.following(start, 4)] == ["Q0.6", "Q0.7", "Q1.0", "Q1.1"]
    assert [one.text for one in S7.following(last, 4)] == ["Q15.6", "Q15.7"]


def test_levels_are_counted_from_one_and_a_register_stands_above_them() -> None:
    main = S7.stacks[0]
    assert [main.level(place).en for place in (0, 1, 8)] == ["level 1", "level 2", "level 9"]
    assert main.level(0).zh == "第1层"
    fx = FX.stacks[0]
    assert [fx.level(place).en for place in (0, 1, 11)] == ["result register", "level 1", "level 11"]
    assert Stack("", Text("栈", "stack"), 4).shape.depth == 4


def test_every_value_says_what_it_is_in_one_line() -> None:
    from plcteach.core.diagnostic import RULES
    from plcteach.stl import read

    program = read("LD X0\nOUT Y0\nLD X1\nSET M5", "fx")
    assert repr(FX) == f"Dialect('fx', {len(FX.insns)} instructions)"
    assert repr(FX.insn("ORB")) == "Insn('ORB', 'a.L b -- a|b')"
    assert repr(FX.areas[0]) == "Area(X X0-X377)"
    assert repr(program) == "Program(fx, 2 networks, 4 lines)"
    assert repr(program.lines[0]) == "Line('LD X0')"
    assert repr(RULES["STK001"]) == "Rule(STK001 underflow)"


def test_a_programs_addresses_by_role() -> None:
    from plcteach.stl import read

    program = read("LD I0.1\nA I0.0\nS Q0.6, 3\n= M0.0\nA SM0.0\n= Q0.0", "s7-200")
    shown = [[one.text for one in program.addresses(role)] for role in ("input", "output", "memory")]
    assert shown == [["I0.0", "I0.1"], ["Q0.0", "Q0.6", "Q0.7", "Q1.0"], ["M0.0", "SM0.0"]]


def test_every_instruction_stands_in_an_example_that_can_be_read_and_is_right() -> None:
    from plcteach.check.lint import lint
    from plcteach.stl import read

    for family in dialects.families():
        used = set()
        for example in family.examples:
            program = read(example, family)
            assert not [one for one in lint(program) if one.severity == "error"], (family.name, example)
            used |= {line.insn.mnemonic for line in program.lines}
        assert used == set(family.words), family.name


def test_each_table_is_found_under_its_own_name() -> None:
    assert [dialects.dialect(name).name for name in dialects.names()] == list(dialects.names())
    assert [family.name for family in dialects.families()] == [
        name for name in dialects.names() if name != "s7-200-smart"
    ]
