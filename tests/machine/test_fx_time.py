"""FX timers and counters beside plain models, written from the manual's sentences and run over scans of any length."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.machine import run
from plcteach.machine.scan import warm
from plcteach.stl import read

SCANS = st.lists(st.tuples(st.integers(1, 400), st.integers(0, 1), st.integers(0, 9)), min_size=1, max_size=40)
"""Scan by scan: how long it lasts in ms, the input, and a number that is 0 where the reset input is on."""


def program(text: str):
    found = read(text.replace("/", "\n"), "fx")
    assert found.diagnostics == (), found.diagnostics
    return found


def rows(scans: list[tuple[int, int, int]]) -> list[dict[str, int]]:
    return [{"ms": ms, "X0": on, "X1": int(reset == 0)} for ms, on, reset in scans]


def bits(trace, address: str) -> list[int]:
    return [int(one) for one in trace[address]]


def values(trace, address: str) -> list[int]:
    return [one.value for one in trace.values(address)]


# Timers. "The current value advances while the coil is driven; the contact is updated when OUT T executes."


class Timer:
    """One timer: T0-199 100 ms, T200-245 10 ms, T246-249 1 ms retentive, T250-255 100 ms retentive, T256-511 1 ms.

    The time between two looks counts where the first of them found the coil driven [rec]: the scan that starts it adds nothing,
    and the scan that stops a retentive one adds what has passed until then.
    """

    def __init__(self, number: int, preset: int) -> None:
        self.base = 100 if number < 200 or 250 <= number < 256 else 10 if number < 246 else 1
        self.retentive = 246 <= number < 256
        self.preset, self.ms, self.was, self.on = preset, 0, 0, 0

    def scan(self, dt: int, driven: int) -> tuple[int, int]:
        if self.was:
            self.ms = min(self.ms + dt, self.preset * self.base)
        self.on |= int(self.ms >= self.preset * self.base)
        if not driven and not self.retentive:
            self.ms = self.on = 0
        self.was = driven
        return self.ms // self.base, self.on

    def reset(self) -> None:
        self.ms = self.on = self.was = 0


@pytest.mark.parametrize("number", [0, 199, 200, 245, 246, 249, 250, 255, 256, 511])
@given(scans=SCANS, preset=st.sampled_from([1, 2, 7, 30]), by_register=st.integers(0, 1))
@settings(max_examples=30, deadline=None)
def test_a_timer_of_each_class_is_the_model(
    number: int, scans: list[tuple[int, int, int]], preset: int, by_register: int
) -> None:
    start = {"D5": preset} if by_register else {}
    list_ = program(f"LD X0/OUT T{number} {'D5' if by_register else f'K{preset}'}/LD X1/RST T{number}")
    given = rows(scans)
    given[0] |= start
    trace = run(list_, given)
    model = Timer(number, preset)
    expected = []
    for place, (ms, on, reset) in enumerate(scans):
        found = model.scan(ms if place else 0, on)
        if reset == 0:
            model.reset()
            found = 0, 0
        expected.append(found)
    assert list(zip(values(trace, f"T{number}.V"), bits(trace, f"T{number}"), strict=True)) == expected


def test_the_contact_changes_where_out_t_stands_and_not_before() -> None:
    trace = run(program("LD T0/OUT Y0/LD X0/OUT T0 K1/LD T0/OUT Y1"), [{"X0": 1}, {"ms": 100}, {"ms": 100}])
    assert (trace["Y0"], trace["Y1"]) == ("001", "011")


def test_a_timer_can_reset_itself_for_one_scan_each_time() -> None:
    """On for one scan; the next one clears it, and the one after that starts it and adds nothing: 5 + 2 scans a round."""
    trace = run(program("LDI T0/OUT T0 K5/LD T0/OUT Y0"), 20, scan_ms=100)
    assert [number for number, on in enumerate(bits(trace, "Y0")) if on] == [5, 12, 19]


# Counters.


@given(scans=SCANS, preset=st.integers(1, 6))
@settings(max_examples=80, deadline=None)
def test_a_sixteen_bit_counter_stops_at_its_preset(scans: list[tuple[int, int, int]], preset: int) -> None:
    """ "Counts the rising edges of its condition; at the preset the contact comes on, and both stay until RST." """
    trace = run(program(f"LD X0/OUT C7 K{preset}/LD X1/RST C7"), rows(scans))
    count, was, on, expected = 0, None, 0, []
    for _, x, reset in scans:
        count += int(was == 0 and x == 1 and count < preset)
        on |= count == preset
        if reset == 0:
            count = on = 0
        was = x
        expected.append((count, int(on)))
    assert list(zip(values(trace, "C7.V"), bits(trace, "C7"), strict=True)) == expected


EDGE = st.sampled_from([2**31 - 2, 2**31 - 1, -(2**31), -(2**31) + 1, -3, -1, 0, 4])


@given(
    scans=SCANS, start=EDGE, preset=EDGE | st.integers(-4, 5), down=st.lists(st.booleans(), min_size=40, max_size=40)
)
@settings(max_examples=100, deadline=None)
def test_a_thirty_two_bit_counter_is_a_ring(
    scans: list[tuple[int, int, int]], start: int, preset: int, down: list[bool]
) -> None:
    """ "From 2147483647 up comes -2147483648, and back; the contact comes on where the current value goes up to the preset
    and off where it goes down from it; the current value counts on whatever the contact does." """
    text = f"LD X2/OUT M8203/LD M8002/DMOV K{start} C203/LD X0/OUT C203 K{preset}/LD X1/RST C203"
    given = [{**row, "X2": int(down[place])} for place, row in enumerate(rows(scans))]
    trace = run(program(text), given)
    value, was, on, expected = start, None, 0, []
    for place, (_, x, reset) in enumerate(scans):
        if was == 0 and x == 1:
            on = 0 if down[place] and value == preset else on
            value = (value + (-1 if down[place] else 1) + 2**31) % 2**32 - 2**31
            on = 1 if not down[place] and value == preset else on
        if reset == 0:
            value = on = 0
        was = x
        expected.append((value, on))
    assert list(zip(values(trace, "C203.V"), bits(trace, "C203"), strict=True)) == expected


def test_a_count_beyond_the_preset_comes_back_to_it_with_the_next_edge() -> None:
    """The manual: the contact comes on when the next counting input is received, and the value becomes the set value."""
    rows_ = [{"X1": 1}, {"X1": 0, "X0": 1}, {"X0": 0}, {"X0": 1}]
    trace = run(program("LD X1/MOV K50 C0/LD X0/OUT C0 K10"), rows_)
    assert (values(trace, "C0.V"), trace["C0"]) == ([50, 10, 10, 10], "0111")


def test_presets_in_registers_of_thirty_two_bits() -> None:
    trace = run(
        program("LD M8002/DMOV K70000 D0/DMOV K69998 C200/LD X0/OUT C200 D0"), [{"X0": n % 2} for n in range(8)]
    )
    assert (values(trace, "C200.V")[-1], trace["C200"]) == (70002, "00011111")


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("OUT T0 K0", "RDR008"),
        ("OUT T0 K32768", "RDR008"),
        ("OUT T0 K-1", "RDR008"),
        ("OUT T0 HFFFF", "RDR008"),
        ("OUT C0 K-1", "RDR008"),
        ("OUT C199 K32768", "RDR008"),
        ("OUT C200 K2147483648", "RDR008"),
        ("OUT C235 K5", "RDR002"),
        ("OUT T512 K5", "RDR006"),
        ("OUT T0", "RDR003"),
        ("OUT T0 M5", "RDR007"),
        ("OUT T0 K5 K6", "RDR004"),
    ],
)
def test_presets_out_of_range_are_refused(line: str, code: str) -> None:
    (found,) = read(f"LD X0\n{line}", "fx").diagnostics
    assert found.code == code
    assert read(f"LD X0\n{line}", "fx").lines[1:] == ()


def test_what_is_latched_outlives_a_warm_start() -> None:
    text = (
        "LD X0/OUT T0 K50/LD X0/OUT T246 K9000/LD X0/OUT T250 K50/LD X0/OUT C0 K5/LD X0/OUT C100 K1/LD X0/OUT C210 K5/"
        "LD X0/OUT C220 K5/LD X0/SET M0/SET M500/SET S0/SET S500/MOV K5 D0/MOV K6 D200"
    )
    list_ = program(text)
    trace = run(list_, [{"X0": 0}, {"X0": 1}, {"ms": 1000}])
    keys = ["T0.V", "T246.V", "T250.V", "C0.V", "C100.V", "C210.V", "C220.V", "D0", "D200"]
    relays = ["M0", "M500", "S0", "S500", "C100", "C0"]
    assert [values(trace, key)[-1] for key in keys] == [10, 1000, 10, 1, 1, 1, 1, 5, 6]
    again = run(list_, [{"X0": 0}], memory=warm(list_, trace.memory))
    assert [values(again, key)[-1] for key in keys] == [0, 1000, 10, 0, 1, 0, 1, 0, 6]
    assert [again[one] for one in relays] == ["0", "1", "0", "1", "1", "0"]
    on = run(list_, [{"X0": 1}, {"ms": 500}], memory=warm(list_, trace.memory))
    assert values(on, "T246.V") == [1000, 1500]  # the scan that starts it adds nothing
    assert values(on, "C100.V") == [1, 1]  # the first scan shows no edge


def test_the_special_relays() -> None:
    trace = run(program("LD M8000/OUT Y0/LD M8001/OUT Y1/LD M8002/OUT Y2/LD M8003/OUT Y3"), 3)
    assert [trace[f"Y{place}"] for place in range(4)] == ["111", "000", "100", "011"]


@pytest.mark.parametrize(("relay", "period"), [("M8011", 10), ("M8012", 100), ("M8013", 1_000), ("M8014", 60_000)])
def test_clock_relays_are_on_half_of_their_period(relay: str, period: int) -> None:
    trace = run(program(f"LD {relay}/OUT Y0"), 41, scan_ms=period // 10)
    shown = bits(trace, "Y0")
    assert sum(shown[:40]) == 20
    assert all(shown[place] == shown[place + 10] for place in range(30))
    assert sum(one != other for one, other in pairwise(shown)) == 8
