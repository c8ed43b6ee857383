"""NEZA's scan: edges between images, system bits, words and their flags, jumps, subroutines, ends, warm starts."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.check.lint import lint
from plcteach.machine import run
from plcteach.machine.scan import warm
from plcteach.stl import read

ROWS = st.lists(st.tuples(*[st.integers(0, 1)] * 3), min_size=1, max_size=40)


def traced(text: str, rows=None, scan_ms: int = 10):
    program = read(text.replace("; ", "\n"), "neza")
    assert not program.diagnostics, program.diagnostics
    scans = [{f"%I0.{number}": bit for number, bit in enumerate(row)} for row in rows or [[0]]]
    return run(program, scans, scan_ms=scan_ms)


def words(trace, address: str) -> list[int]:
    return [int(repr(value)) for value in trace.values(address)]


# Edges.


@settings(max_examples=60, deadline=None)
@given(rows=ROWS)
def test_edges_compare_the_images_of_two_scan_starts(rows: list[tuple[int, ...]]) -> None:
    """An %M written in scan n shows its edge in n+1, wherever it is read; no edge in the first scan."""
    trace = traced(
        "LDR %M0; ST %Q0.0; LD %I0.0; ST %M0; LDF %M0; ST %Q0.1; LDR %I0.1; ST %Q0.2; LDF %I0.1; ST %Q0.3", rows
    )
    for scan in range(len(rows)):
        early, before = (rows[scan - 2][0] if scan > 1 else 0), (rows[scan - 1][0] if scan else 0)
        got = [repr(trace.value(f"%Q0.{number}", scan)) for number in range(4)]
        was, now = (rows[scan - 1][1] if scan else rows[scan][1]), rows[scan][1]
        wanted = [before and not early, early and not before, now and not was, was and not now]
        assert got == [str(int(bool(one))) for one in wanted]


# System bits.


def test_system_bits_of_the_first_scan() -> None:
    """%S0 first scan after a cold start, %S1 after a warm one, %S13 the first scan of either."""
    program = read("LD %S0\nST %Q0.0\nLD %S1\nST %Q0.1\nLD %S13\nST %Q0.2", "neza")
    cold = run(program, 3)
    assert [cold[f"%Q0.{bit}"] for bit in range(3)] == ["100", "000", "100"]
    again = run(program, 3, memory=warm(program, cold.memory))
    assert [again[f"%Q0.{bit}"] for bit in range(3)] == ["000", "100", "100"]


@pytest.mark.parametrize(("bit", "period"), [("%S5", 100), ("%S6", 1_000), ("%S7", 60_000)])
def test_clock_bits_are_half_on_and_half_off(bit: str, period: int) -> None:
    trace = traced(f"LD {bit}; ST %Q0.0", [[0]] * 1_000, period // 10)
    changes = trace.edges("%Q0.0")[1:]
    assert {after[0] - before[0] for before, after in pairwise(changes)} == {period // 2}
    assert trace["%Q0.0"].count("1") == 500


def test_s4_is_a_clock_of_10_ms() -> None:
    assert "1010" in traced("LD %S4; ST %Q0.0", [[0]] * 20, 5)["%Q0.0"]


def test_what_outlives_a_warm_start() -> None:
    """[rec]: internal bits, words, counters, drums, shift registers, step counters and registers; timers begin anew."""
    text = (
        "%TM0: TB=10ms P=3\n%DR0: OUT=%Q1.0,%Q1.1 STEPS=00,11\nLD %I0.0\nST %Q0.0\nS %M5\nS %SBR0.3\nIN %TM0\n[%MW3 := 17]\n"
        "[%R0.I := 5]\nCU %C0\nU %DR0\nCU %SC0\nI %R0"
    )
    program = read(text, "neza")
    cold = run(program, [{}, {"%I0.0": 1}, *[{}] * 4])
    after = run(program, [{"%I0.0": 0}], memory=warm(program, cold.memory))
    kept = ["%M5", "%SBR0.3", "%MW3", "%C0.V", "%DR0.S", "%SC0.1"]
    assert [int(repr(after.value(one, 0))) for one in kept] == [1, 1, 17, 1, 1, 1]
    assert [repr(after.value(one, 0)) for one in ("%TM0.V", "%TM0.Q", "%Q0.0", "%R0.E")] == ["0", "0", "0", "0"]


# Words.


def wrapped(number: int) -> int:
    return (number + 2**15) % 2**16 - 2**15


def towards_zero(a: int, b: int) -> int:
    return int(abs(a) // abs(b)) * (1 if (a < 0) == (b < 0) else -1)


OPERATIONS = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": towards_zero,
    "REM": lambda a, b: a - towards_zero(a, b) * b,
    "AND": lambda a, b: a & b,
    "OR": lambda a, b: a | b,
    "XOR": lambda a, b: a ^ b,
}
WORD = st.integers(-(2**15), 2**15 - 1)


@settings(max_examples=150, deadline=None)
@given(
    a=WORD | st.sampled_from([0, 1, -1, -(2**15)]),
    b=WORD | st.sampled_from([0, 1, -1]),
    sign=st.sampled_from(sorted(OPERATIONS)),
)
def test_operations_on_words(a: int, b: int, sign: str) -> None:
    """Too large a result is cut off and sets %S18; a division by zero sets it and leaves the word as it was."""
    trace = traced(f"%KW0: {a}; %KW1: {b}; LD 1; [%MW0 := 77]; [%MW0 := %KW0 {sign} %KW1]")
    if sign in {"/", "REM"} and not b:
        assert (words(trace, "%MW0"), trace["%S18"]) == ([77], "1")
        return
    exact = OPERATIONS[sign](a, b)
    assert (words(trace, "%MW0"), trace["%S18"]) == ([wrapped(exact)], str(int(wrapped(exact) != exact)))


@pytest.mark.parametrize(
    ("text", "wanted"),
    [("NOT(5)", -6), ("NOT %KW0", ~1234), ("SQRT(%KW0)", 35), ("SHL(%KW0, 3)", wrapped(1234 << 3)), ("SHR(-1, 15)", 1),
     ("ROL(%KW0, 6)", wrapped(1234 << 6 | 1234 >> 10)), ("ROR(1, 1)", -(2**15)), ("%KW0", 1234), ("16#7F", 127), ("-5", -5)],
)  # fmt: skip
def test_functions_of_words(text: str, wanted: int) -> None:
    assert words(traced(f"%KW0: 1234; LD 1; [%MW0 := {text}]"), "%MW0") == [wanted]


def test_s17_keeps_the_bit_that_a_word_loses_and_s18_says_that_a_result_is_too_large() -> None:
    trace = traced(
        "%KW0: -32768; LD 1; [%MW0 := SHL(%KW0, 1)]; LD %S17; ST %Q0.0; LD 1; [%MW1 := %KW0 / -1]; LD %S18; ST %Q0.1"
    )
    assert [trace[place] for place in ("%Q0.0", "%Q0.1")] == ["1", "1"]
    assert traced("LD 1; [%MW0 := SQRT(-4)]; LD %S18; ST %Q0.0")["%Q0.0"] == "1"


def test_operations_wait_for_the_accumulator_and_compares_read_it() -> None:
    rows = [[0], [1], [0], [1], [1]]
    trace = traced("LD %I0.0; [INC %MW0]; LD [%MW0 >= 2]; AND [%MW0 < 3]; OR( [%MW0 = 1]; AND %I0.0; ); ST %Q0.0", rows)
    assert words(trace, "%MW0") == [0, 1, 1, 2, 3]
    assert trace["%Q0.0"] == "01010"


def test_bits_of_words() -> None:
    trace = traced("LD %I0.0; ST %MW1:X4; LD 1; S %MW1:X15; R %MW1:X15; LD %MW1:X4; ST %Q0.0", [[0], [1], [0]])
    assert words(trace, "%MW1") == [0, 16, 0]
    assert trace["%Q0.0"] == "010"


def test_presets_are_words_that_can_be_read_and_written() -> None:
    trace = traced(
        "%C0: P=4; LD %I0.0; [%C0.P := 2]; [%MW0 := %C0.P]; CU %C0; LD %C0.D; ST %Q0.0", [[0], [1], [0], [1]]
    )
    assert words(trace, "%C0.P") == [4, 2, 2, 2]
    assert words(trace, "%MW0") == [0, 2, 2, 2]
    assert trace["%Q0.0"] == "0001"


# Where the program goes on.


@settings(max_examples=60, deadline=None)
@given(rows=ROWS)
def test_jumps_pass_over_lines(rows: list[tuple[int, ...]]) -> None:
    trace = traced(
        "LD %I0.0; JMPC %L1; LD %I0.1; ST %Q0.0; %L1:; LD %I0.0; JMPCN %L2; LD %I0.2; ST %Q0.1; JMP %L3; %L2:; LD %I0.2; ST %Q0.2; %L3:",
        rows,
    )
    first = second = third = 0
    for scan, (jump, one, two) in enumerate(rows):
        first = first if jump else one
        second, third = (two, third) if jump else (second, two)
        assert [repr(trace.value(f"%Q0.{bit}", scan)) for bit in range(3)] == [str(first), str(second), str(third)]


def test_a_jump_backwards_that_never_ends_is_stopped_and_named() -> None:
    trace = traced("%L1:; LD %I0.0; JMPC %L1", [[0], [1], [0]])
    assert [(one.code, one.span.row) for one in trace.diagnostics] == [("RUN002", 3)]
    assert "JMPC %L1" in trace.diagnostics[0].text.en


@settings(max_examples=40, deadline=None)
@given(rows=ROWS)
def test_subroutines_run_where_they_are_called(rows: list[tuple[int, ...]]) -> None:
    trace = traced(
        "LD %I0.0; SR1; LD %I0.1; SR2; LD %I0.0; ST %Q0.0; END; SR1:; LD %I0.2; ST %Q0.1; LD 1; SR2; RET; SR2:; LD 1; [INC %MW0]; RET",
        rows,
    )
    held = count = 0
    for scan, (one, two, three) in enumerate(rows):
        held = three if one else held
        count += one + two
        assert [repr(trace.value(place, scan)) for place in ("%Q0.0", "%Q0.1", "%MW0")] == [
            str(one),
            str(held),
            str(count),
        ]


def test_ends() -> None:
    text = "LD %I0.0; ENDC; LD 1; [INC %MW0]; LD %I0.1; ENDCN; LD 1; [INC %MW1]; END; LD 1; [INC %MW2]"
    trace = traced(text, [[0, 0], [0, 1], [1, 1], [1, 0]])
    assert [words(trace, f"%MW{number}") for number in range(3)] == [[1, 2, 2, 2], [0, 1, 1, 1], [0] * 4]


def test_a_timer_that_is_jumped_over_goes_on() -> None:
    """Timers tick at the start of the scan; the line is only asked for its input."""
    trace = traced("%TM0: TB=10ms P=3; LD %I0.1; JMPC %L1; LD %I0.0; IN %TM0; %L1:", [[0, 0], [1, 0], *[[1, 1]] * 4])
    assert trace["%TM0.Q"] == "000011"


# Rungs and sections.


def test_no_rung_begins_inside_a_section_and_one_begins_with_it() -> None:
    program = read(
        "LD %I0.0\nST %Q0.0\nBLK %C0\nLD %I0.1\nR\nLD %I0.2\nCU\nOUT_BLK\nLD D\nST %Q0.1\nEND_BLK\nLD %I0.3\nST %Q0.2",
        "neza",
    )
    assert [len(one.lines) for one in program.networks] == [2, 9, 2]
    assert [line.text for line in program.lines[2:11]] == [
        "BLK %C0",
        "LD %I0.1",
        "R",
        "LD %I0.2",
        "CU",
        "OUT_BLK",
        "LD D",
        "ST %Q0.1",
        "END_BLK",
    ]
    assert [str(line.args[0]) for line in program.lines[2:9] if line.said] == ["%C0", "%C0", "%C0", "%C0.D"]


def test_a_label_and_a_subroutine_begin_a_rung_of_their_own() -> None:
    program = read("LD %I0.0\nJMPC %L1\n%L1: LD %I0.1\nST %Q0.0\nEND\nSR3:\nLD %I0.2\nST %Q0.1\nRET", "neza")
    assert [[line.text for line in one.lines] for one in program.networks] == [
        ["LD %I0.0", "JMPC %L1"],
        ["%L1:", "LD %I0.1", "ST %Q0.0", "END"],
        ["SR3:", "LD %I0.2", "ST %Q0.1", "RET"],
    ]
    assert [one.block for one in program.networks] == ["", "", "SR3"]


@pytest.mark.parametrize(
    ("text", "codes"),
    [
        ("BLK %C0; LD %I0.0; IN; END_BLK", {"BLK004": 3}),
        ("BLK %TM0; LD %I0.0; R; END_BLK", {"BLK004": 3}),
        ("BLK %TM0; LD %I0.0; IN; OUT_BLK; LD D; ST %Q0.0; END_BLK", {"BLK004": 5}),
        ("LD %I0.0; R %TM0", {"BLK004": 2}),
        ("BLK %C0; LD %I0.0; CU; OUT_BLK; OUT_BLK; END_BLK", {"BLK005": 5}),
        ("BLK %C0; LD %I0.0; CU %C1; END_BLK", {"BLK006": 3}),
        ("BLK %C0; LD %I0.0; CU; JMP %L1; END_BLK; %L1:", {"BLK006": 4}),
        ("RUNG 0; BLK %C0; LD %I0.0; CU; RUNG 1; LD %I0.0; ST %Q0.0", {"BLK007": 2}),
        ("OUT_BLK", {"BLK003": 1}),
        ("BLK %M0", {"RDR007": 1, "RDR019": 1}),
        ("BLK", {"RDR003": 1}),
        ("LD %TM0; ST %Q0.0", {"RDR019": 1}),
        ("LD %I0.0; ST %SC0.1", {"RDR007": 2}),
        ("LD %I0.0; R %MW0", {"RDR019": 2}),
        ("LD %I0.0; AND( %I0.1; IN %TM0; )", {"STK012": 3}),
        ("LD %I0.0; AND( %I0.1; JMPC %L1; ); ST %Q0.0; %L1:", {"STK012": 3}),
        ("LD %I0.0; AND( %I0.1; [%MW0 := 1]; ); ST %Q0.0", {"STK012": 3}),
        ("LD %I0.0; SR5; END", {"JMP001": 2}),
        ("LD %I0.0; JMPC %L99", {"RDR008": 2}),
        ("LD %I0.0; SR1; END; SR1:; RET; SR1:; RET", {"JMP002": 6}),
    ],
)  # fmt: skip
def test_what_is_said_and_where(text: str, codes: dict[str, int]) -> None:
    said = {one.code: one.span.row for one in lint(read(text.replace("; ", "\n"), "neza"))}
    assert said.items() <= codes.items()
    assert said
