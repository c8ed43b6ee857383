"""Where an S7-200 program goes on: jumps, loops, calls, ends and segments; nested ones against a direct evaluation."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.check.lint import lint
from plcteach.machine import run
from plcteach.stl import read


def program(text: str):
    found = read(text.replace(" / ", "\n"), "s7-200")
    assert found.runs, found.diagnostics
    return found


def routines(main: str, *blocks: str) -> str:
    """A main program with subroutines SBR0, SBR1 …"""
    return main + "".join(
        f"\nSUBROUTINE_BLOCK SBR_{number}:SBR{number}\nBEGIN\nNetwork 1\n{text}\nEND_SUBROUTINE_BLOCK"
        for number, text in enumerate(blocks)
    )


def value(text: str, address: str, *scans: dict[str, int]) -> list[int]:
    return [one.value for one in run(program(text), scans or [{}]).values(address)]


# Jumps.


def test_what_is_jumped_over_changes_nothing_not_even_the_stack() -> None:
    text = "LD I0.0 / LD I0.1 / JMP 1 / LDN I0.0 / = Q0.0 / LBL 1 / OLD / = Q0.1"
    found = run(program(text), [{"I0.0": 1, "I0.1": 1}, {"I0.0": 0, "I0.1": 0}])
    assert (found["Q0.0"], found["Q0.1"]) == ("01", "11")
    assert len(found.scans[0].steps) == 6
    assert [one.line.text for one in found.scans[0].steps][3:] == ["LBL 1", "OLD", "= Q0.1"]


def test_a_jump_back_is_a_loop() -> None:
    text = "LD SM0.0 / MOVW 0, VW0 / LBL 1 / LD SM0.0 / INCW VW0 / LDW< VW0, 7 / JMP 1"
    assert value(text, "VW0", {}, {}) == [7, 7]


def test_a_loop_that_runs_away_is_stopped_and_the_jump_is_named() -> None:
    found = run(program("LD I0.0 / = Q0.0\nLBL 3\nLD SM0.0\nJMP 3\nLD SM0.0\n= Q0.1"), [{"I0.0": 1}, {}, {}])
    (said,) = found.diagnostics
    assert (said.code, said.severity, said.span.row) == ("RUN002", "error", 5)
    assert "JMP 3" in said.text.en
    assert len(found.starts) == 1
    assert found["Q0.0"] == "0", "a CPU in STOP switches its outputs off"


# Loops.


@settings(max_examples=60, deadline=None)
@given(
    bounds=st.lists(st.tuples(st.integers(-3, 3), st.integers(-3, 3)), min_size=1, max_size=8).filter(
        lambda rows: len([1 for a, b in rows if b > a]) <= 4
    )
)
def test_nested_loops_count_as_pythons_do(bounds: list[tuple[int, int]]) -> None:
    heads = " / ".join(f"LD SM0.0 / FOR VW{10 + 2 * at}, {a}, {b}" for at, (a, b) in enumerate(bounds))
    text = f"{heads} / LD SM0.0 / INCD VD0{' / NEXT' * len(bounds)}"
    wanted = 1
    for a, b in bounds:
        wanted *= max(b - a + 1, 0)
    found = run(program(text))
    assert found.value("VD0", 0).value == wanted
    if bounds[0][1] >= bounds[0][0]:
        assert found.value("VW10", 0).value == bounds[0][1] + 1


def test_a_loop_without_power_is_passed_over() -> None:
    text = "LD I0.0 / FOR VW0, 1, 5 / LD SM0.0 / INCW VW2 / NEXT / LD SM0.0 / INCW VW4"
    assert value(text, "VW2", {}, {"I0.0": 1}) == [0, 5]
    assert value(text, "VW4", {}, {"I0.0": 1}) == [1, 2]


def test_the_last_value_may_change_in_the_loop() -> None:
    text = "LD SM0.0 / MOVW 9, VW4 / FOR VW0, 1, VW4 / LD SM0.0 / INCW VW2 / LDW= VW2, 3 / MOVW 4, VW4 / NEXT"
    assert value(text, "VW2") == [4]


def test_a_jump_out_of_an_inner_loop_leaves_the_outer_one_running() -> None:
    text = "LD SM0.0 / FOR VW0, 1, 3 / LD SM0.0 / FOR VW2, 1, 5 / LDW= VW2, 2 / JMP 1 / NEXT / LBL 1 / LD SM0.0 / INCW VW4 / NEXT"
    assert value(text, "VW4") == [3]


def test_loops_come_in_pairs() -> None:
    for text in ("LD SM0.0 / FOR VW0, 1, 2", "NEXT", "LD SM0.0 / FOR VW0, 1, 2 / NEXT / NEXT"):
        assert "JMP005" in {one.code for one in lint(read(text.replace(" / ", "\n"), "s7-200"))}
    crossed = routines("LD SM0.0\nFOR VW0, 1, 2", "NEXT")
    assert [one.code for one in lint(read(crossed, "s7-200"))].count("JMP005") == 2


# Calls.


def test_a_routine_begins_with_1_above_zeros_and_the_stack_comes_back() -> None:
    text = routines(
        "LD I0.0\nLD I0.1\nLD I0.2\nCALL SBR0\n= Q0.0\nOLD\n= Q0.1\nALD\n= Q0.2",
        "= Q1.0\nLRD\n= Q1.1\nLD I0.0\nLDN I0.0\nLDN I0.0",
    )
    found = run(program(text), [{"I0.0": 1, "I0.1": 0, "I0.2": 1}])
    assert [found[f"Q0.{bit}"] for bit in range(3)] == ["1", "1", "1"]
    assert [found[f"Q1.{bit}"] for bit in range(2)] == ["1", "0"]
    steps = found.scans[0].steps
    inside = next(one for one in steps if one.line.text == "= Q1.0")
    assert repr(inside.before[0]) == "(1, 0, 0, 0, 0, 0, 0, 0, 0)"
    call = next(one for one in steps if one.line.text == "CALL SBR0")
    after = next(one for one in steps if one.line.text == "= Q0.0")
    assert after.before == call.after


def test_a_routine_without_power_is_not_called() -> None:
    text = routines("LD I0.0\nCALL SBR0", "LD SM0.0\nINCW VW0")
    assert value(text, "VW0", {}, {"I0.0": 1}, {"I0.0": 0}, {"I0.0": 1}) == [0, 1, 1, 2]


def test_a_call_in_a_call_and_one_routine_twice() -> None:
    text = routines(
        "LD SM0.0\nCALL SBR0\nCALL SBR1", "LD SM0.0\nINCW VW0\nCALL SBR1\nLD SM0.0\n+I 100, VW0", "LD SM0.0\n+I 10, VW0"
    )
    assert value(text, "VW0") == [121]


def test_cret_leaves_the_routine_and_its_loop_and_nothing_else() -> None:
    text = routines(
        "LD SM0.0\nFOR VW0, 1, 3\nLD SM0.0\nCALL SBR0\nNEXT",
        "LD SM0.0\nINCW VW2\nFOR VW4, 1, 9\nLDW= VW4, 2\nCRET\nLD SM0.0\nINCW VW6\nNEXT",
    )
    assert value(text, "VW2") == [3]
    assert value(text, "VW6") == [3]


def test_eight_calls_nest_and_the_ninth_is_not_made() -> None:
    eight = routines(
        "LD SM0.0\nCALL SBR0", *(f"LD SM0.0\nINCW VW0\nCALL SBR{one + 1}" for one in range(7)), "LD SM0.0\nINCW VW0"
    )
    found = run(program(eight))
    assert (found.value("VW0", 0).value, found.diagnostics) == (8, ())
    itself = run(program(routines("LD SM0.0\nCALL SBR0", "LD SM0.0\nINCW VW0\nCALL SBR0")))
    assert itself.value("VW0", 0).value == 8
    assert [one.code for one in itself.diagnostics] == ["RUN003"]


# The end of the scan, and of the run.


def test_end_ends_the_scan_where_there_is_power() -> None:
    text = "LD I0.1 / = Q0.0 / LD I0.0 / END / LD I0.1 / = Q0.1"
    found = run(program(text), [{"I0.1": 1}, {"I0.0": 1, "I0.1": 0}, {"I0.0": 0}])
    assert (found["Q0.0"], found["Q0.1"]) == ("100", "110")


def test_stop_finishes_the_scan_and_switches_the_outputs_off() -> None:
    text = "LD SM0.0 / = Q0.0 / LD I0.0 / STOP / LD SM0.0 / INCW VW0 / TON T33, 100"
    found = run(program(text), [{}, {}, {"I0.0": 1}, {"I0.0": 0}, {}])
    assert found["Q0.0"] == "11000"
    assert [one.value for one in found.values("VW0")] == [1, 2, 3, 3, 3]
    assert [one.value for one in found.values("T33.V")] == [0, 1, 2, 2, 2]


# Segments.


SEGMENTS = (
    "LD SM0.1 / S S0.1, 1 / LSCR S0.1 / LD SM0.0 / = Q0.0 / S Q1.0, 1 / LD I0.0 / SCRT S0.2 / LD SM0.0 / = Q0.1 / SCRE / "
    "LSCR S0.2 / LD SM0.0 / = Q0.2 / TON T37, 2 / LD T37 / SCRT S0.1 / SCRE / LD SM0.0 / = Q0.7"
)


def test_a_segment_without_power_drops_its_coils_and_keeps_what_is_set() -> None:
    found = run(program(SEGMENTS), [{}, {"I0.0": 1}, {"I0.0": 0}, {}, {}, {}], scan_ms=100)
    assert found["Q0.0"] == "110011"
    assert found["Q0.1"] == found["Q0.0"], "the segment that is left keeps its power to its end"
    assert found["Q0.2"] == "011100"
    assert found["Q1.0"] == "111111"
    assert found["Q0.7"] == "111111"
    assert (found["S0.1"], found["S0.2"]) == ("100111", "011000")


def test_cscre_takes_the_power_from_the_rest_of_its_segment() -> None:
    text = "LD SM0.1 / S S0.1, 1 / LSCR S0.1 / LD SM0.0 / = Q0.0 / LD I0.0 / CSCRE / LD SM0.0 / = Q0.1 / SCRE / LD SM0.0 / = Q0.2"
    found = run(program(text), [{}, {"I0.0": 1}, {"I0.0": 0}])
    assert [found[f"Q0.{bit}"] for bit in range(3)] == ["111", "101", "111"]


# ENO.


@pytest.mark.parametrize(("first", "second", "wanted"), [(100, 200, "11"), (32767, 5, "00"), (1, 32767, "10")])
def test_boxes_in_series_go_on_only_where_the_last_went_well(first: int, second: int, wanted: str) -> None:
    text = f"LD SM0.0 / +I {first}, VW0 / AENO / = Q0.0 / +I {second}, VW2 / AENO / = Q0.1"
    found = run(program(text), [{"VW0": 10, "VW2": 10}])
    assert found["Q0.0"] + found["Q0.1"] == wanted
    assert found.value("VW2", 0).value == (10 + second if wanted == "11" else 10)


def test_eno_is_what_the_call_was_and_not_what_happened_inside() -> None:
    text = routines("LD SM0.0\nCALL SBR0\nAENO\n= Q0.0", "LD SM0.0\n/I 0, VW0\nAENO\n= Q0.1")
    found = run(program(text))
    assert (found["Q0.0"], found["Q0.1"], found["SM1.3"]) == ("1", "0", "1")
