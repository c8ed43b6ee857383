"""The little language for inputs over time: what it means, what is said of its slips, and that what is written is read again."""

from __future__ import annotations

import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.diagnostic import RULES
from plcteach.core.errors import UnknownNameError
from plcteach.core.source import Span
from plcteach.machine.timeline import MOST_SCANS, Timeline, timeline, write_timeline
from plcteach.stl import read


def changes(told: Timeline) -> list[tuple[int, dict[str, int]]]:
    """The scans in which anything changes, by their time."""
    return [(number * told.scan_ms, scan) for number, scan in enumerate(told.scans()) if scan]


def read_well(text: str, dialect: str = "s7-200", **more: int) -> Timeline:
    told = timeline(text, dialect, **more)
    assert told.diagnostics == ()
    return told


def test_phases_come_one_after_the_other_and_the_last_lasts_to_the_end() -> None:
    told = read_well("I0.0: 1s off, 0.2s on, off")
    assert changes(told) == [(1000, {"I0.0": 1}), (1200, {"I0.0": 0})]
    assert told.until_ms == 2200
    assert len(list(told.scans())) == 221


def test_only_what_changes_is_named_and_inputs_start_at_0() -> None:
    told = read_well("I0.0: on\nI0.1: off\nI0.2: 1s on, 1s on, off")
    assert changes(told) == [(0, {"I0.0": 1, "I0.2": 1}), (2000, {"I0.2": 0})]


@pytest.mark.parametrize(
    ("text", "until"),
    [
        ("I0.0: on", 1000),
        ("I0.0: off", 1000),
        ("", 1000),
        ("I0.0: 5s off", 5000),
        ("I0.0: 2s off, on", 3000),
        ("I0.0: 2s off, 0.5s on", 3000),
        ("I0.0: 2s off, 4s on", 6000),
        ("I0.0: 1s on, off; I0.1: 2s off, on", 3000),
    ],
)
def test_it_ends_a_second_after_the_last_change_and_never_within_a_stated_phase(text: str, until: int) -> None:
    assert read_well(text).until_ms == until
    assert read_well(text, until_ms=70).until_ms == 70
    assert len(list(read_well(text, until_ms=70).scans())) == 8


@pytest.mark.parametrize(
    "text",
    [
        "I0.0: 1s off, 200ms on, off",
        "i0.0:1S OFF,0.2 s ON,OFF",
        "I0.0: 1000 ms 0, 0.2s 1, 0",
        "Ｉ０．０：１秒　断，０．２秒　通，断",
        "I0.0：1秒断、200毫秒通、断",
        "I0.0: 1s 关, 0.2s 开, 关",
        "I0.0: 1s 断开, 0.2s 接通, 断开;",
        "// a comment; I0.1: on\n\nI0.0: 1s off, 0.2s on, off // behind: it\r\n",
        "I0.0: 1s off, 1 x (0.2s on), off",
    ],
)
def test_ways_to_say_the_same(text: str) -> None:
    assert changes(read_well(text)) == [(1000, {"I0.0": 1}), (1200, {"I0.0": 0})]


def test_minutes() -> None:
    assert changes(read_well("I0.0: 1min on, 0.5分 off, 1分钟 on", scan_ms=1000)) == [
        (0, {"I0.0": 1}),
        (60_000, {"I0.0": 0}),
        (90_000, {"I0.0": 1}),
    ]


@pytest.mark.parametrize(
    "text", ["3 x (0.5s on, 0.5s off), on", "3×(0.5s on, 0.5s off), on", "3次（0.5秒通，0.5秒断），通"]
)
def test_repetitions(text: str) -> None:
    assert changes(read_well(f"I0.2: {text}")) == [
        (at, {"I0.2": value}) for at, value in zip(range(0, 3001, 500), [1, 0, 1, 0, 1, 0, 1], strict=True)
    ]


def test_repetitions_within_repetitions() -> None:
    told = read_well("I0.0: 2 x (2 x (10ms on, 10ms off), 100ms off)")
    assert [at for at, scan in changes(told) if scan["I0.0"]] == [0, 20, 140, 160]
    assert told.until_ms == 1170


def test_words_may_be_given_numbers() -> None:
    told = read_well("VW0: 2s 5, 1s -17\nVB10: 1s 255, 0")
    assert changes(told) == [(0, {"VW0": 5, "VB10": 255}), (1000, {"VB10": 0}), (2000, {"VW0": -17})]


def test_words_of_other_families() -> None:
    assert changes(read_well("D0: 1s 5, 6\nX010: on", "fx"))[0] == (0, {"D0": 5, "X10": 1})
    assert changes(read_well("%MW0: 5\n%MW1:X3: 1s off, on\n%I0.0: on", "neza")) == [
        (0, {"%MW0": 5, "%I0.0": 1}),
        (1000, {"%MW1:X3": 1}),
    ]


def test_a_change_is_seen_by_the_first_scan_that_starts_at_or_after_it() -> None:
    told = read_well("I0.0: 35ms off, 40ms on, off", scan_ms=20)
    assert changes(told) == [(40, {"I0.0": 1}), (80, {"I0.0": 0})]
    exactly = read_well("I0.0: 40ms off, 40ms on, off", scan_ms=20)
    assert changes(exactly) == [(40, {"I0.0": 1}), (80, {"I0.0": 0})]


def test_the_state_at_any_moment() -> None:
    told = read_well("I0.0: 1s off, 0.2s on, off; VW0: 7")
    assert [told.at(ms)["I0.0"] for ms in (0, 999, 1000, 1199, 1200, 99_999)] == [0, 0, 1, 1, 0, 0]
    assert told.at(5) == {"I0.0": 0, "VW0": 7}


def test_at_and_scans_tell_the_same() -> None:
    told = read_well("I0.0: 3 x (35ms on, 45ms off), on\nI0.1: 100ms off, on", scan_ms=7)
    held = dict.fromkeys(told.at(0), 0)
    for number, scan in enumerate(told.scans()):
        held |= scan
        assert held == told.at(number * 7)


def test_a_program_runs_over_it() -> None:
    run = pytest.importorskip("plcteach.machine").run
    told = read_well("I0.0: 20ms off, 10ms on, off\nI0.1: 60ms off, 10ms on, off", until_ms=90)
    trace = run(read("LD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n", "s7-200"), told.scans(), scan_ms=told.scan_ms)
    assert trace["Q0.0"] == "0011110000"


# What is said of slips


BAD_AND_GOOD = {
    "TIM001": ("1s off, on", "I0.0: 1s off, on", Span(1, 0, 10)),
    "TIM002": ("Start: on", "I0.0: on", Span(1, 0, 5)),
    "TIM003": ("I0.0: 1s off, 2m on, off", "I0.0: 1s off, 2min on, off", Span(1, 14, 19)),
    "TIM004": ("I0.1: off, 3s on", "I0.1: 1s off, 3s on", Span(1, 6, 9)),
    "TIM005": ("I0.0: 1s 5, 0", "VW0: 1s 5, 0", Span(1, 6, 10)),
    "TIM006": ("I0.0: 3 x (1s on, 1s off", "I0.0: 3 x (1s on, 1s off)", Span(1, 6, 11)),
    "TIM007": ("I0.0: 1000000000 x (1s on, 1s off)", "I0.0: 100 x (1s on, 1s off)", Span(1, 6, 20)),
    "TIM008": ("I0.0: on\ni0.0: off", "I0.0: on\nI0.1: off", Span(2, 0, 9)),
    "TIM009": ("I0.0: 11ms off, 5ms on, off", "I0.0: 11ms off, 10ms on, off", Span(1, 16, 22)),
    "TIM010": ("I0.0: 0.0005s on, off", "I0.0: 0.005s on, off", Span(1, 6, 16)),
}


@pytest.mark.parametrize("code", BAD_AND_GOOD)
def test_each_diagnostic_has_its_timeline_and_the_mended_one_has_none(code: str) -> None:
    bad, good, span = BAD_AND_GOOD[code]
    (one,) = timeline(bad, "s7-200").diagnostics
    assert (one.code, one.span, one.severity) == (code, span, RULES[code].severity)
    assert "{" not in one.text.en + one.text.zh
    assert timeline(good, "s7-200").diagnostics == ()


def test_every_code_about_timelines_is_among_them() -> None:
    assert set(BAD_AND_GOOD) == {code for code in RULES if code.startswith("TIM")}


@pytest.mark.parametrize(
    ("text", "codes"),
    [
        ("I0.9: on", ["TIM002"]),
        (": on", ["TIM002"]),
        ("I0.0:", ["TIM003"]),
        ("I0.0: 1s", ["TIM003"]),
        ("I0.0: maybe", ["TIM003"]),
        ("I0.0: 1s on off", ["TIM003"]),
        ("I0.0: 99999999999s on, off", ["TIM003"]),
        ("I0.0: 0s on, off", ["TIM010"]),
        ("I0.0: 1.5ms on, off", ["TIM010"]),
        ("VB0: 256", ["TIM005"]),
        ("VW0: -32769", ["TIM005"]),
        ("I0.0: (1s on, 1s off)", ["TIM006"]),
        ("I0.0: 0 x (1s on, 1s off)", ["TIM006"]),
        ("I0.0: 1s on)", ["TIM006"]),
        ("I0.0: 2 x (1s on) off, 1s on", ["TIM006"]),
        ("I0.0: 2 x (1s on, off), on", ["TIM004"]),
        ("I0.0: " + "2 x (" * 12 + "1s on" + ")" * 12, ["TIM006"] * 4),
        ("I0.0: 999999999min off, on", ["TIM007"]),
        ("I0.0: 300 x (300 x (300 x (1s on, 1s off)))", ["TIM007"]),
        ("I0.0: 1s on\nnonsense\nI0.1: 2s on", ["TIM001"]),
    ],
)
def test_what_cannot_be_read_is_told(text: str, codes: list[str]) -> None:
    assert [one.code for one in timeline(text, "s7-200").diagnostics] == codes


def test_what_could_be_read_is_kept() -> None:
    told = timeline("I0.0: 1s off, maybe, on\nnonsense\nI0.1: 2s off, on", "s7-200")
    assert changes(told) == [(1000, {"I0.0": 1}), (2000, {"I0.1": 1})]


def test_a_row_shows_an_address_of_the_family() -> None:
    (one,) = timeline("on", "fx").diagnostics
    assert "X0: 1s off" in one.text.en
    assert "X0: 1s off" in one.text.zh


def test_places_count_code_points_of_the_text_as_given() -> None:
    (one,) = timeline("I0.0: on;　Ｉ０．１：１秒断，咦", "s7-200").diagnostics
    assert (one.code, one.span) == ("TIM003", Span(1, 19, 20))


def test_never_more_than_a_million_scans() -> None:
    told = timeline("I0.0: 100min off, on", "s7-200", scan_ms=1)
    assert [one.code for one in told.diagnostics] == ["TIM007"]
    assert told.until_ms == MOST_SCANS - 1
    assert timeline("", "s7-200", until_ms=10**12).until_ms == (MOST_SCANS - 1) * 10


def test_a_developers_mistakes_are_exceptions() -> None:
    with pytest.raises(UnknownNameError, match="s5"):
        timeline("", "s5")
    with pytest.raises(ValueError, match="at least 1 ms"):
        timeline("", "s7-200", scan_ms=0)


@pytest.mark.parametrize(
    "text",
    [
        "I0.0: " + "1s on, " * 250_000,
        "I0.0: " + "?, " * 600_000,
        "(" * 1_900_000,
        "I0.0: " + "2 x (" * 380_000,
        "I0.0: " + ")" * 1_900_000,
        "I0.0: on\n" * 200_000,
        "".join(f"V{at // 8}.{at % 8}: 99999 x (1s on)\n" for at in range(5_000)),
        "I0.0: " + "1" * 1_900_000,
        ";" * 1_900_000,
        "x" * 2_000_001,
    ],
    ids=range(10),
)
def test_texts_that_nobody_should_write_are_answered_soon(text: str) -> None:
    begun = time.monotonic()
    told = timeline(text, "s7-200")
    assert len(told.diagnostics) < 400
    assert sum(len(row.phases) for row in told.rows) <= 100_000
    assert time.monotonic() - begun < 30  # a guard against hanging, no measurement


@settings(max_examples=200, deadline=None)
@given(st.text(st.sampled_from("I0.1V:;,()x3 sonf\n//秒通"), max_size=60))
def test_anything_may_be_typed(text: str) -> None:
    told = timeline(text, "s7-200", until_ms=100)
    assert len(list(told.scans())) == 11


# Written and read again


def test_recorded_scans_become_a_text() -> None:
    scans = [{}, {"I0.0": 1}, {}, {"I0.0": 0, "VW10": 300}, {"I0.10": 0}, {"VW10": -1, "VW2": 1}]
    assert write_timeline(scans, 100) == "I0.0: 0.1s off, 0.2s on, off\nVW2: 0.5s off, on\nVW10: 0.3s 0, 0.2s 300, -1\n"
    assert write_timeline([{"I0.0": 1}, {}, {"I0.0": 1, "ms": 250}, {"I0.0": 0}]) == "I0.0: 270ms on, off\n"
    assert write_timeline([{"I0.0": 1}] + [{}] * 300) == "I0.0: 3s on\n"
    assert write_timeline([]) == ""


def test_repetitions_are_folded() -> None:
    blink = [{"I0.0": number % 2} for number in range(9)]
    assert write_timeline(blink, 500) == "I0.0: 4 x (0.5s off, 0.5s on), off\n"
    assert write_timeline(blink[1:6], 60_000) == "I0.0: 1min on, 1min off, 1min on, 1min off, on\n"


VALUES = {"I0.0": st.integers(0, 1), "I0.1": st.integers(0, 1), "VW0": st.integers(-32768, 65535)}
SCANS = st.lists(st.fixed_dictionaries({}, optional=VALUES), max_size=40)


@settings(max_examples=300, deadline=None)
@given(SCANS, st.sampled_from([1, 7, 10, 50, 100, 1000]))
def test_what_is_written_is_read_again(scans: list[dict[str, int]], scan_ms: int) -> None:
    text = write_timeline(scans, scan_ms)
    told = timeline(text, "s7-200", scan_ms=scan_ms)
    assert told.diagnostics == ()
    again = list(told.scans())
    assert write_timeline(again, scan_ms) == text
    held = dict.fromkeys(VALUES, 0)
    for number, scan in enumerate(scans):
        held |= scan
        assert held == dict.fromkeys(VALUES, 0) | told.at(number * scan_ms)


@settings(max_examples=100, deadline=None)
@given(
    st.lists(st.tuples(st.integers(1, 400), st.integers(0, 1)), min_size=1, max_size=12), st.sampled_from([5, 10, 30])
)
def test_scans_see_what_the_phases_say(phases: list[tuple[int, int]], scan_ms: int) -> None:
    """The state at each scan's start, added up here by hand."""
    told = timeline("I0.0: " + ", ".join(f"{length}ms {value}" for length, value in phases), "s7-200", scan_ms=scan_ms)
    by_ms = [value for length, value in phases for _ in range(length)]
    held = 0
    for number, scan in enumerate(told.scans()):
        held = scan.get("I0.0", held)
        assert held == by_ms[min(number * scan_ms, len(by_ms) - 1)]
