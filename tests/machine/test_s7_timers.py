"""Timers and counters of the S7-200 against a model written from the manual's sentences, at any scan times."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.check.lint import lint
from plcteach.machine import run
from plcteach.machine.scan import warm
from plcteach.stl import read

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time


def program(text: str, dialect: str = "s7-200"):
    found = read(text.replace(" / ", "\n"), dialect)
    assert found.runs, found.diagnostics
    return found


# The model: a timer as the manual tells it, in ms and in its own units.


@dataclass
class Timer:
    """A timer; `advance` is its update point, `execute` the instruction, `reset` an R."""

    sort: str
    base: int
    preset: int
    ms: int = 0
    bit: int = 0
    going: bool = False
    input: int = 0

    @property
    def current(self) -> int:
        return self.ms // self.base

    def advance(self, ms: int) -> None:
        if not self.going:
            return
        self.ms += ms
        if self.sort == "TOF":
            if self.current >= self.preset:
                self.ms, self.bit, self.going = self.preset * self.base, 0, False
            return
        self.ms = min(self.ms, 32767 * self.base)
        if self.current >= self.preset:
            self.bit = 1

    def execute(self, power: int) -> None:
        if self.sort == "TOF":
            if power:
                self.ms, self.bit, self.going = 0, 1, False
            elif self.input and self.bit:
                self.ms, self.going = 0, True
                if not self.preset:
                    self.bit, self.going = 0, False
        elif power:
            self.going = True
            self.bit |= self.current >= self.preset
        else:
            self.going = False
            if self.sort == "TON":
                self.ms, self.bit = 0, 0
        self.input = power

    def reset(self) -> None:
        self.ms, self.bit, self.going = 0, 0, False


RESOLUTIONS = [
    ("TON", 32, 1), ("TON", 96, 1), ("TON", 33, 10), ("TON", 97, 10), ("TON", 37, 100), ("TON", 255, 100),
    ("TOF", 32, 1), ("TOF", 36, 10), ("TOF", 63, 100),
    ("TONR", 0, 1), ("TONR", 64, 1), ("TONR", 4, 10), ("TONR", 65, 10), ("TONR", 5, 100), ("TONR", 95, 100),
]  # fmt: skip
SCANS = st.lists(
    st.tuples(st.sampled_from([0, 0, 1, 1, 1]), st.sampled_from([0, 0, 0, 0, 1]), st.integers(1, 140)),
    min_size=1,
    max_size=30,
)


@pytest.mark.parametrize(("sort", "number", "base"), RESOLUTIONS)
@settings(max_examples=60, deadline=None)
@given(preset=st.integers(0, 9), scans=SCANS)
def test_a_timer_does_what_the_manual_says(
    sort: str, number: int, base: int, preset: int, scans: list[tuple[int, int, int]]
) -> None:
    lines = ["LD I0.0", f"{sort} T{number}, {preset}", "LD I0.1", f"R T{number}, 1", f"LD T{number}", "= Q0.0"]
    found = run(program(" / ".join(lines)), [{"I0.0": a, "I0.1": b, "ms": ms} for a, b, ms in scans])
    timer = Timer(sort, base, preset)
    for scan, (power, reset, given_ms) in enumerate(scans):
        ms = given_ms if scan else 0
        seen = 0
        if base == 10:
            timer.advance(ms)
        for line in range(len(lines)):
            if base == 1:
                timer.advance(ms * (line + 1) // len(lines) - ms * line // len(lines))
            if line == 1:
                if base == 100:
                    timer.advance(ms)
                timer.execute(power)
            if line == 3 and reset:
                timer.reset()
            if line == 4:
                seen = timer.bit
        got = (
            repr(found.value("Q0.0", scan)),
            found.value(f"T{number}.V", scan).value,
            repr(found.value(f"T{number}", scan)),
        )
        assert got == (str(seen), timer.current, str(timer.bit)), scan


def test_a_timer_of_100_ms_with_5_at_30_ms_scans_needs_17_scans_after_the_starting_one() -> None:
    found = run(program("LD SM0.0 / TON T37, 5 / LD T37 / = Q0.0"), 19, scan_ms=30)
    assert found["Q0.0"] == "0" * 17 + "11"


def test_an_on_delay_counts_on_to_32767() -> None:
    found = run(program("LD SM0.0 / TON T33, 5"), [{"ms": 400_000} for _ in range(4)])
    assert [one.value for one in found.values("T33.V")] == [0, 32767, 32767, 32767]


def test_after_a_reset_an_off_delay_needs_a_new_fall() -> None:
    text = "LD I0.0 / TOF T37, 1 / LD I0.1 / R T37, 1 / LD T37 / = Q0.0"
    rows = [(1, 0), (0, 0), (0, 1), (0, 0), (0, 0), (1, 0), (0, 0), (0, 0)]
    found = run(program(text), [{"I0.0": a, "I0.1": b} for a, b in rows], scan_ms=60)
    assert found["Q0.0"] == "11000111"


def test_the_current_value_is_a_word_like_any_other() -> None:
    text = "LD SM0.0 / TON T37, 100 / MOVW T37, VW0 / LDW>= T37, 3 / = Q0.0"
    found = run(program(text), 6, scan_ms=100)
    assert [one.value for one in found.values("VW0")] == [0, 1, 2, 3, 4, 5]
    assert found["Q0.0"] == "000111"


@pytest.mark.parametrize(
    "rest",
    [
        "LD I0.0\nJMP 1\nLD I0.1\n= Q0.0\n= Q0.1\nLBL 1\nLD SM0.0",
        "LD I0.0\nEND\nLD I0.1\n= Q0.0",
        "LD I0.0\nCALL SBR0\nSUBROUTINE_BLOCK SBR_0:SBR0\nLD SM0.0\n= Q0.0\n= Q0.1\nEND_SUBROUTINE_BLOCK",
        "LD I0.0\nFOR VW0, 1, 5\nLD I0.1\n= Q0.0\nNEXT",
    ],
    ids=["jump", "end", "call", "loop"],
)
@pytest.mark.parametrize("power", [0, 1])
def test_a_1_ms_timer_runs_on_whatever_the_program_passes_over(rest: str, power: int) -> None:
    found = run(program(f"LD SM0.0\nTON T32, 1000\n{rest}"), [{"I0.0": power, "ms": 13}] * 11)
    assert [one.value for one in found.values("T32.V")] == [13 * scan for scan in range(11)]


# Misconception 22: a timer that resets itself.


def test_a_10_ms_timer_that_resets_itself_is_never_seen_on() -> None:
    assert "1" not in run(program("LDN T33 / TON T33, 30 / LD T33 / = Q0.0"), 400)["Q0.0"]


def test_a_100_ms_timer_that_resets_itself_is_on_for_one_scan() -> None:
    seen = run(program("LDN T37 / TON T37, 3 / LD T37 / = Q0.0"), 200)["Q0.0"]
    assert "1" in seen
    assert "11" not in seen
    assert [at for at, bit in enumerate(seen) if bit == "1"] == [30, 62, 94, 126, 158, 190]


def test_a_1_ms_timer_that_resets_itself_is_seen_now_and_then() -> None:
    seen = run(program("LDN T32 / TON T32, 33 / LD T32 / = Q0.0"), [{"ms": 7 + scan % 5} for scan in range(600)])[
        "Q0.0"
    ]
    assert 0 < seen.count("1") < 600 // 4


@pytest.mark.parametrize(("timer", "preset"), [("T32", 300), ("T33", 30), ("T37", 3)])
def test_the_safe_form_pulses_with_any_resolution(timer: str, preset: int) -> None:
    seen = run(program(f"LDN M0.0 / TON {timer}, {preset} / LD {timer} / = M0.0"), 400)["M0.0"]
    ups = [at for at, bit in enumerate(seen) if bit == "1"]
    assert len(ups) > 10
    assert "11" not in seen
    assert len({b - a for a, b in pairwise(ups)}) == 1


# Numbers.


def said(text: str, dialect: str = "s7-200") -> list[tuple[str, str, int]]:
    return [(one.severity, one.code, one.span.row) for one in lint(read(text.replace(" / ", "\n"), dialect))]


@pytest.mark.parametrize("dialect", ["s7-200", "s7-200-smart", "gutta"])
def test_a_number_goes_with_one_sort_of_timer(dialect: str) -> None:
    for number in range(256):
        retentive = number <= 31 or 64 <= number <= 95
        for sort in ("TON", "TOF", "TONR"):
            right = retentive == (sort == "TONR")
            wanted = [] if right else [("error", "TMR001", 2)]
            assert said(f"LD I0.0 / {sort} T{number}, 5", dialect) == wanted


def test_the_message_says_which_numbers_fit() -> None:
    (one,) = lint(read("LD I0.0\nTON T5, 3", "s7-200"))
    assert "T32–T63, T96–T255" in one.text.en
    assert "T32–T63、T96–T255" in one.text.zh or "T32–T63, T96–T255" in one.text.zh
    (one,) = lint(read("LD I0.0\nTONR T37, 3", "s7-200"))
    assert "T0–T31, T64–T95" in one.text.en


def test_an_on_and_an_off_delay_share_no_number() -> None:
    assert said("LD I0.0 / TON T37, 5 / LD I0.1 / TOF T37, 5") == [("error", "TMR002", 4)]
    assert said("LD I0.0 / TON T37, 5 / LD I0.1 / TON T38, 5") == []


@pytest.mark.parametrize("preset", ["-1", "32768", "16#FFFF"])
def test_a_preset_lies_between_0_and_32767(preset: str) -> None:
    for line in (f"TON T37, {preset}", f"CTU C0, {preset}"):
        assert [one.code for one in read(f"LD I0.0\nLD I0.1\n{line}", "s7-200").diagnostics] == ["RDR008"]
    assert read("LD I0.0\nTON T37, 32767\nTON T38, 16#7FFF\nTON T39, VW0", "s7-200").runs


# Counters.


@settings(max_examples=150, deadline=None)
@given(
    preset=st.integers(0, 4),
    scans=st.lists(st.tuples(*[st.integers(0, 1)] * 4), min_size=1, max_size=30),
    start=st.sampled_from([0, 32765, -32767]),
)
def test_counters_do_what_the_manual_says(preset: int, scans: list[tuple[int, ...]], start: int) -> None:
    """CTU C0, CTD C1 and CTUD C2 side by side: I0.0 counts up, I0.1 down, I0.2 is R and LD, I0.3 an R instruction."""
    text = (
        f"LD I0.0 / LD I0.2 / CTU C0, {preset} / LD I0.1 / LD I0.2 / CTD C1, {preset} / "
        f"LD I0.0 / LD I0.1 / LD I0.2 / CTUD C2, {preset} / LD I0.3 / R C0, 3"
    )
    rows = [{f"I0.{place}": bit for place, bit in enumerate(row)} for row in scans]
    rows[0] |= {"C0.V": max(start, 0), "C2.V": start}
    found = run(program(text), rows)
    up, down, both = max(start, 0), 0, start
    bits = [0, 0, 0]
    last: tuple[int, ...] | None = None
    for scan, row in enumerate(scans):
        rises = [bool(last is not None and bit and not before) for bit, before in zip(row, last or row, strict=True)]
        up = 0 if row[2] else min(up + rises[0], 32767)
        down = preset if row[2] else max(down - rises[1], 0)
        both = 0 if row[2] else (both + rises[0] - rises[1] + 32768) % 65536 - 32768
        bits = [up >= preset and not row[2], down == 0 and not row[2], both >= preset and not row[2]]
        if row[3]:
            up, down, both, bits = 0, 0, 0, [0, 0, 0]
        assert [found.value(f"C{n}.V", scan).value for n in range(3)] == [up, down, both], scan
        assert [repr(found.value(f"C{n}", scan)) for n in range(3)] == [str(int(bit)) for bit in bits], scan
        last = row


# Clocks: 002_0e43569a3a430994.txt, section 2.2.7. Which half comes first is nobody's business.


@pytest.mark.parametrize(("bit", "half"), [("SM0.4", 30_000), ("SM0.5", 500)])
def test_the_clock_bits_are_half_on_and_half_off(bit: str, half: int) -> None:
    seen = run(program(f"LD {bit} / = Q0.0"), 4 * 2 * half // 50, scan_ms=50)["Q0.0"]
    changes = [at for at in range(1, len(seen)) if seen[at] != seen[at - 1]]
    assert {b - a for a, b in pairwise(changes)} == {half // 50}


def test_sm06_is_on_for_one_scan_and_off_for_one() -> None:
    assert run(program("LD SM0.6 / = Q0.0"), 6)["Q0.0"] in {"101010", "010101"}


def test_a_warm_start_keeps_what_is_retentive() -> None:
    text = (
        "LD SM0.0 / TONR T5, 50 / TON T37, 50 / LD SM0.0 / LD I0.7 / CTU C0, 9 / LD I0.0 / = M0.0 / = M14.0 / MOVW 7, VW0 / "
        "LD SM0.2 / = Q0.2"
    )
    code = program(text)
    first = run(code, [{"I0.0": 1, "C0.V": 3}, *[{}] * 30], scan_ms=100)
    again = run(code, [{"I0.0": 0}], memory=warm(code, first.memory))
    assert (first.value("T5.V", 30).value, first.value("T37.V", 30).value) == (30, 30)
    assert (again.value("T5.V", 0).value, again.value("T37.V", 0).value) == (30, 0)
    assert again.value("C0.V", 0).value == 3
    kept = warm(code, first.memory).bits
    assert "M14.0" in kept
    assert "M0.0" not in kept
    assert again.value("VW0", 0).value == 7
    assert (first["Q0.2"][0], again["Q0.2"]) == ("1", "0")
