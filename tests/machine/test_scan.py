"""Scan after scan: images, edges, specials, memory and time, family by family as their notes say."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.errors import UnknownNameError
from plcteach.core.source import Span
from plcteach.machine import Column, Domain, Memory, run, sweep
from plcteach.stl import read

sys.path.insert(0, str(Path(__file__).parent))
from random_lists import INPUTS, MENU, lists


def program(text: str, dialect: str):
    found = read(text.replace(" / ", "\n"), dialect)
    assert not [one for one in found.diagnostics if one.severity == "error"], found.diagnostics
    return found


def over(text: str, dialect: str, address: str, **inputs: str) -> str:
    """Run one scan for each sign of the inputs' words, and give the address's values as a word."""
    names = {name.replace("_", ".").replace("p", "%"): word for name, word in inputs.items()}
    count = len(next(iter(names.values())))
    scans = [{name: int(word[scan]) for name, word in names.items()} for scan in range(count)]
    return run(program(text, dialect), scans)[address]


# Edges.


@pytest.mark.parametrize(
    ("dialect", "text", "address", "inputs", "wanted"),
    [
        # S7-200 and FX: one memory for each instruction, no edge in the first scan
        ("s7-200", "LD I0.0 / EU / = Q0.0", "Q0.0", {"I0_0": "011010"}, "010010"),
        ("s7-200", "LD I0.0 / EU / = Q0.0", "Q0.0", {"I0_0": "1101"}, "0001"),
        ("s7-200", "LD I0.0 / ED / = Q0.0", "Q0.0", {"I0_0": "0100110"}, "0010001"),
        ("s7-200", "LD I0.0 / ED / = Q0.0", "Q0.0", {"I0_0": "0011"}, "0000"),
        ("s7-200", "LD I0.0 / A I0.1 / EU / = Q0.0", "Q0.0", {"I0_0": "0111", "I0_1": "1101"}, "0101"),
        ("s7-200", "LD I0.0 / EU / = Q0.1 / LD I0.1 / EU / = Q0.0", "Q0.0", {"I0_0": "0111", "I0_1": "0011"}, "0010"),
        ("fx", "LDP X0 / OUT Y0", "Y0", {"X0": "1011"}, "0010"),
        ("fx", "LDF X0 / OUT Y0", "Y0", {"X0": "0101"}, "0010"),
        ("fx", "LD X0 / ANDP X1 / OUT Y0", "Y0", {"X0": "0011", "X1": "0101"}, "0001"),
        ("fx", "LD X0 / ORF X1 / OUT Y0", "Y0", {"X0": "0001", "X1": "1000"}, "0101"),
        ("fx", "LD X0 / PLS M0 / LD M0 / OUT Y0", "Y0", {"X0": "01101"}, "01001"),
        ("fx", "LD X0 / PLF M0 / LD M0 / OUT Y0", "Y0", {"X0": "01101"}, "00010"),
        ("fx", "LD X0 / OR X1 / MEP / OUT Y0", "Y0", {"X0": "0100", "X1": "0010"}, "0100"),
        ("fx", "LD X0 / MEF / OUT Y0", "Y0", {"X0": "0101"}, "0010"),
        ("fx", "LDP X0 / OUT Y0 / LDP X0 / OUT Y1", "Y1", {"X0": "0110"}, "0100"),
        # a bit that the program itself writes: FX looks at it where the instruction stands
        ("fx", "LD X0 / OUT M0 / LDP M0 / OUT Y0", "Y0", {"X0": "0110"}, "0100"),
        # NEZA compares the images of two scan starts: an %M written in scan n shows its edge in scan n+1
        ("neza", "LDR %I0.0 / ST %Q0.0", "%Q0.0", {"pI0_0": "1011"}, "0010"),
        ("neza", "LDF %I0.0 / ST %Q0.0", "%Q0.0", {"pI0_0": "1011"}, "0100"),
        ("neza", "LD %I0.0 / ST %M0 / LDR %M0 / ST %Q0.0", "%Q0.0", {"pI0_0": "01101"}, "00100"),
        ("neza", "LDR %M0 / ST %Q0.0 / LD %I0.0 / ST %M0", "%Q0.0", {"pI0_0": "01101"}, "00100"),
        ("neza", "LD %I0.0 / ST %M0 / LDF %M0 / ST %Q0.0", "%Q0.0", {"pI0_0": "01001"}, "00010"),
        ("neza", "LD %I0.0 / ST %M0 / LDR %M0 / ST %Q0.0", "%Q0.0", {"pI0_0": "1111"}, "0100"),
        ("neza", "LDR %I0.0 / ST %Q0.1 / LD %I0.1 / ANDR %I0.0 / ST %Q0.0", "%Q0.0", {"pI0_0": "0101", "pI0_1": "1101"}, "0101"),
        # GUTTA keeps the last flow in m, which starts at 0: P does fire at first, N does not
        ("gutta", "LD I0.0 / P M0.0 / = Q0.0", "Q0.0", {"I0_0": "1101"}, "1001"),
        ("gutta", "LD I0.0 / P M0.0 / = Q0.0", "M0.0", {"I0_0": "1101"}, "1101"),
        ("gutta", "LD I0.0 / N M0.0 / = Q0.0", "Q0.0", {"I0_0": "0100"}, "0010"),
        ("gutta", "LD I0.0 / P M0.0 / = Q0.1 / LD I0.1 / P M0.0 / = Q0.0", "Q0.0", {"I0_0": "11", "I0_1": "11"}, "00"),
    ],
)  # fmt: skip
def test_edges(dialect: str, text: str, address: str, inputs: dict[str, str], wanted: str) -> None:
    assert over(text, dialect, address, **inputs) == wanted


# Coils, set and reset.


def test_set_and_reset_reach_n_bits_over_the_byte() -> None:
    found = run(program("LD I0.0 / S Q0.6, 4 / LD I0.1 / R Q0.7, 2", "s7-200"), [{"I0.0": 1}, {"I0.0": 0}, {"I0.1": 1}])
    assert [found[f"Q{bit}"] for bit in ("0.5", "0.6", "0.7", "1.0", "1.1", "1.2")] == [
        "000",
        "111",
        "110",
        "110",
        "111",
        "000",
    ]


def test_the_later_of_set_and_reset_wins() -> None:
    assert over("LD I0.0 / S Q0.0, 1 / LD I0.1 / R Q0.0, 1", "s7-200", "Q0.0", I0_0="1100", I0_1="0110") == "1000"
    assert over("LD X1 / RST Y0 / LD X0 / SET Y0", "fx", "Y0", X0="1100", X1="0110") == "1100"


def test_what_is_set_stays_until_it_is_reset() -> None:
    assert over("LD %I0.0 / S %Q0.0 / LD %I0.1 / R %Q0.0", "neza", "%Q0.0", pI0_0="01000", pI0_1="00010") == "01100"
    assert over("LD %I0.0 / STN %Q0.0", "neza", "%Q0.0", pI0_0="010") == "101"


def test_a_coil_is_in_the_image_at_once_and_the_seal_in_holds() -> None:
    assert over("LD I0.0 / = M0.0 / LD M0.0 / = Q0.0", "s7-200", "Q0.0", I0_0="010") == "010"
    assert over("LD M0.0 / = Q0.0 / LD I0.0 / = M0.0", "s7-200", "Q0.0", I0_0="010") == "001"
    assert over("LD I0.0 / O Q0.0 / AN I0.1 / = Q0.0", "s7-200", "Q0.0", I0_0="010000", I0_1="000010") == "011100"


# Immediate contacts and the image.


def test_an_immediate_contact_reads_the_terminal_and_not_the_image() -> None:
    text = "LDN I0.0 / = I0.0 / LD I0.0 / = Q0.0 / LDI I0.0 / = Q0.1 / LDNI I0.0 / = Q0.2"
    assert over(text, "s7-200", "Q0.0", I0_0="010") == "101"
    assert over(text, "s7-200", "Q0.1", I0_0="010") == "010"
    assert over(text, "s7-200", "Q0.2", I0_0="010") == "101"


def test_the_next_reading_of_the_inputs_overwrites_what_a_program_wrote_there() -> None:
    assert over("LD I0.0 / = Q0.0 / LD I0.1 / S I0.0, 1", "s7-200", "Q0.0", I0_0="0000", I0_1="1111") == "0000"


@pytest.mark.parametrize(
    ("text", "wanted"), [("AI I0.1", "0001"), ("ANI I0.1", "0010"), ("OI I0.1", "0111"), ("ONI I0.1", "1011")]
)
def test_the_immediate_series_and_parallel_contacts(text: str, wanted: str) -> None:
    assert over(f"LD I0.0 / {text} / = Q0.0", "s7-200", "Q0.0", I0_0="0011", I0_1="0101") == wanted


def test_a_run_that_goes_on_has_one_opinion_of_its_inputs() -> None:
    both = program("LD I0.0 / = Q0.0 / LDI I0.0 / = Q0.1", "s7-200")
    first = run(both, [{"I0.0": 1}])
    then = run(both, [{}], memory=first.scans[-1].after)
    assert then["Q0.0"] == then["Q0.1"]


# Bits that the system drives.


@pytest.mark.parametrize(
    ("dialect", "text", "address", "wanted"),
    [
        ("s7-200", "LD SM0.0 / = Q0.0", "Q0.0", "1111"),
        ("s7-200", "LD SM0.1 / = Q0.0", "Q0.0", "1000"),
        ("s7-200-smart", "LD SM0.1 / = Q0.0", "Q0.0", "1000"),
        ("gutta", "LD SM0.0 / = Q0.0", "Q0.0", "1111"),
        ("gutta", "LD SM0.1 / = Q0.0", "Q0.0", "1000"),
        ("fx", "LD M8000 / OUT Y0", "Y0", "1111"),
        ("fx", "LD M8001 / OUT Y0", "Y0", "0000"),
        ("fx", "LD M8002 / OUT Y0", "Y0", "1000"),
        ("fx", "LD M8003 / OUT Y0", "Y0", "0111"),
        ("neza", "LD %S13 / ST %Q0.0", "%Q0.0", "1000"),
        ("neza", "LD %S0 / ST %Q0.0", "%Q0.0", "1000"),
        ("neza", "LD 1 / ST %Q0.0", "%Q0.0", "1111"),
        ("neza", "LDN 0 / AND 1 / ST %Q0.0", "%Q0.0", "1111"),
        ("s7-200", "LD SM0.0 / EU / = Q0.0", "Q0.0", "0000"),
        ("s7-200", "LD SM0.1 / ED / = Q0.0", "Q0.0", "0100"),
    ],
)
def test_special_bits(dialect: str, text: str, address: str, wanted: str) -> None:
    assert run(program(text, dialect), 4)[address] == wanted


# The end, the networks, the stack between them.


@pytest.mark.parametrize(
    ("dialect", "text", "before", "behind"),
    [
        ("fx", "LD X0 / OUT Y0 / END / LD X0 / OUT Y1", "Y0", "Y1"),
        ("neza", "LD %I0.0 / ST %Q0.0 / END / LD %I0.0 / ST %Q0.1", "%Q0.0", "%Q0.1"),
    ],
)
def test_end_ends_the_scan(dialect: str, text: str, before: str, behind: str) -> None:
    found = run(program(text, dialect), [{"X0" if dialect == "fx" else "%I0.0": 1}] * 2)
    assert (found[before], found[behind]) == ("11", "00")
    assert [one.line.text for one in found.scans[1].steps][-1] == "END"


def test_the_s7_200_begins_with_nine_x_and_keeps_its_stack_between_networks() -> None:
    text = "Network 1 / LD I0.0 / = Q0.0 / Network 2 / A I0.1 / = Q0.1"
    found = run(program(text, "s7-200"), [{"I0.0": 1, "I0.1": 1}])
    steps = found.scans[0].steps
    assert repr(steps[0].before[0]) == "(x, x, x, x, x, x, x, x, x)"
    assert repr(steps[0].after[0]) == "(1, x, x, x, x, x, x, x, x)"
    assert steps[2].before == steps[1].after
    assert found["Q0.1"] == "1"


def test_the_smart_has_32_levels() -> None:
    steps = run(program("LD I0.0 / LDS 31", "s7-200-smart")).scans[0].steps
    assert [len(one.after[0]) for one in steps] == [32, 32]


def test_guttas_stacks_are_empty_at_each_network() -> None:
    text = "Network 1 / LD I0.0 / LPS / = Q0.0 / Network 2 / LD I0.1 / = Q0.1"
    steps = run(program(text, "gutta"), [{"I0.0": 1}]).scans[0].steps
    assert [len(cells) for cells in steps[2].after] == [1, 1]
    assert steps[3].before == ((), ())


def test_nezas_accumulator_starts_x() -> None:
    found = run(program("ST %Q0.0", "neza"))
    assert found["%Q0.0"] == "x"


# x.


def test_x_reaching_an_output_is_reported_once_where_it_was_written() -> None:
    found = run(program("LD I0.0\nLPP\n= Q0.0\n= Q0.1\nA I0.1\n= Q0.2", "s7-200"), [{"I0.1": 0}, {"I0.1": 0}])
    assert (found["Q0.0"], found["Q0.1"], found["Q0.2"]) == ("xx", "xx", "00")
    assert [(one.code, one.severity, one.span) for one in found.diagnostics] == [
        ("RUN001", "warning", Span(3, 0, 6)),
        ("RUN001", "warning", Span(4, 0, 6)),
    ]
    assert "Q0.0" in found.diagnostics[0].text.en


def test_ten_blocks_on_nine_levels_lose_the_first() -> None:
    """TEACHING, row 13: only I0.0 = 1 gives x; with another 1 it is 1."""
    loads = " / ".join(f"LD I{number // 8}.{number % 8}" for number in range(10))
    text = f"{loads} / {' / '.join(['OLD'] * 9)} / = Q0.0"
    assert over(text, "s7-200", "Q0.0", I0_0="10", I0_5="01") == "x1"


# Many cases at once, memory, traces.

CASES = 6
ROWS = st.lists(st.lists(st.integers(0, 2**CASES - 1), min_size=3, max_size=3), min_size=1, max_size=4)
EVERY = 2**CASES - 1


@pytest.mark.parametrize("name", MENU)
@settings(max_examples=80, deadline=None)
@given(data=st.data(), rows=ROWS)
def test_a_column_of_cases_equals_as_many_single_runs(name: str, data: st.DataObject, rows: list[list[int]]) -> None:
    code = read(data.draw(lists(name)), name)
    domain = Domain(Column(EVERY, 0), Column(0, EVERY), Column(EVERY, EVERY))
    memory: Memory[Column] = Memory()
    for row in rows:
        columns = {f"{INPUTS[name]}{bit}": Column(EVERY & ~ones, ones) for bit, ones in enumerate(row)}
        memory = sweep(code, memory, columns, domain)
    for case in range(CASES):
        scans = [{f"{INPUTS[name]}{bit}": ones >> case & 1 for bit, ones in enumerate(row)} for row in rows]
        single = run(code, scans).scans[-1].after
        assert {address: value.at(case) for address, value in memory.bits.items()} == {
            address: repr(value) for address, value in single.bits.items()
        }
        assert {line: value.at(case) for line, value in memory.past.items()} == {
            line: repr(value) for line, value in single.past.items()
        }


@pytest.mark.parametrize("name", MENU)
@settings(max_examples=50, deadline=None)
@given(data=st.data(), rows=ROWS)
def test_the_steps_on_demand_are_the_run(name: str, data: st.DataObject, rows: list[list[int]]) -> None:
    code = read(data.draw(lists(name)), name)
    trace = run(code, [{f"{INPUTS[name]}{bit}": ones & 1 for bit, ones in enumerate(row)} for row in rows])
    heads, at = set(), 0
    for network in code.networks:
        heads.add(at)
        at += len(network.lines)
    for scan in trace.scans:
        bits = {**scan.before.bits, **scan.inputs}
        for number, one in enumerate(scan.steps):
            assert one.line == code.lines[number]
            if number and number not in heads:
                assert one.before == scan.steps[number - 1].after
            bits |= {address.text: value for address, value in one.written}
        specials = set(code.dialect.specials)
        assert {key: value for key, value in bits.items() if key not in specials} == {
            key: value for key, value in scan.after.bits.items() if key not in specials
        }
        assert scan.steps == type(scan)(code, scan.domain, scan.number, 0, scan.inputs, scan.before, scan.ms).steps


@pytest.mark.parametrize("name", MENU)
@settings(max_examples=40, deadline=None)
@given(data=st.data(), rows=ROWS, cut=st.integers(0, 4))
def test_a_run_can_be_cut_and_go_on(name: str, data: st.DataObject, rows: list[list[int]], cut: int) -> None:
    code = read(data.draw(lists(name)), name)
    scans = [{f"{INPUTS[name]}{bit}": ones & 1 for bit, ones in enumerate(row)} for row in rows]
    whole = run(code, scans)
    if 0 < cut < len(scans):
        rest = run(code, scans[cut:], memory=run(code, scans[:cut]).scans[-1].after)
        assert rest.scans[-1].after == whole.scans[-1].after


def test_inputs_start_at_0_and_stay_until_they_are_named_again() -> None:
    found = run(program("LD I0.0 / A I0.1 / = Q0.0", "s7-200"), [{}, {"I0.0": 1}, {"i0.1": 1}, {}, {"E0.0": 0}])
    assert found["Q0.0"] == found["a0.0"] == "00110"
    assert repr(found) == "Trace(s7-200, 5 scans)"


def test_time_is_virtual_and_exact() -> None:
    found = run(program("LD I0.0 / = Q0.0", "s7-200"), [{}, {}, {"ms": 25}, {}])
    assert [scan.start_ms for scan in found.scans] == [0, 10, 35, 45]
    assert [scan.start_ms for scan in run(program("LD I0.0 / = Q0.0", "s7-200"), 3, scan_ms=7).scans] == [0, 7, 14]
    assert repr(found.scans[2]) == "Scan(2 at 35 ms)"


def test_an_address_that_the_family_does_not_have_is_named() -> None:
    code = program("LD I0.0 / = Q0.0", "s7-200")
    with pytest.raises(UnknownNameError, match="X0"):
        run(code, [{"X0": 1}])
    with pytest.raises(UnknownNameError, match=r"I0\.9"):
        run(code)["I0.9"]
