"""A run under way: what is pressed counts from the next scan, the past is kept as far as wanted, and a recording runs again."""

from __future__ import annotations

import pytest

from plcteach.machine import run
from plcteach.machine.live import Live
from plcteach.machine.recorder import Recorder
from plcteach.machine.recording import differences, recorded, to_its_end
from plcteach.machine.store import Memory
from plcteach.machine.timeline import Timeline, timeline
from plcteach.stl import read

SEAL_IN = read("LD I0.0; O Q0.0; AN I0.1; = Q0.0; LD Q0.0; TON T37, 5; LD T37; = Q0.1", "s7-200")
BUSY = read(
    "LDN T38; TON T37, 5; LD T37; TON T38, 5; LD T37; EU; LD I0.0; CTU C0, 30; LD C0; = Q0.0; LD T37; = Q0.1; LD I0.0; EU; = Q0.2",
    "s7-200",
)


def test_what_is_pressed_counts_from_the_next_scan_and_holds_until_it_is_let_go() -> None:
    live = Live(SEAL_IN)
    live.run(3)
    live.press("I0.0", 1)
    live.run(2)
    live.press("I0.0", 0)
    live.run(60)
    trace = live.trace()
    assert trace["I0.0"] == "00011" + "0" * 60
    assert trace["Q0.0"] == "000" + "1" * 62
    assert trace.edges("Q0.1")[1][0] == 30 + 500
    live.press("I0.1", 1)
    live.run(1)
    assert live.trace()["Q0.0"][-1] == live.trace()["Q0.1"][-1] == "0"


def test_the_last_scan_can_be_looked_at_line_by_line_and_so_can_every_one_before() -> None:
    live = Live(BUSY)
    live.run(40)
    live.press("I0.0", 1)
    live.run(200)
    straight = run(BUSY, [{}] * 40 + [{"I0.0": 1}] * 200)
    for number in (0, 39, 40, 63, 64, 150, 239):
        assert [repr(one) for one in live.at(number).steps] == [repr(one) for one in straight.scans[number].steps]
    assert live.at(10_000).number == 239


def test_no_more_of_the_past_is_kept_than_is_wanted_and_what_is_kept_is_true() -> None:
    live = Live(BUSY, kept_ms=5_000)
    straight = Recorder(BUSY, Memory(), 10)
    for number in range(3_000):
        live.press("I0.0", number // 300 % 2)
        live.run(1)
        straight.scan({"I0.0": number // 300 % 2})
    whole, kept = straight.trace(), live.trace()
    assert live.scans == 3_000
    assert 500 <= len(kept) <= 700
    gone = live.forgotten
    assert gone + len(kept) == 3_000
    for address in ("Q0.0", "Q0.1", "Q0.2", "T37.V", "C0.V", "I0.0"):
        assert kept[address] == whole[address][gone:], address
    assert kept.starts == whole.starts[gone:]
    assert [repr(one) for one in live.at(gone + 70).steps] == [repr(one) for one in whole.scans[gone + 70].steps]
    assert live.at(0).number == 0, "what is forgotten is shown as the oldest that is kept"


def test_ten_minutes_keep_no_more_than_the_history_that_was_chosen() -> None:
    live = Live(BUSY, kept_ms=10_000)
    sizes = []
    for _ in range(6):
        live.run(2_000)
        recorder = live.recorder
        sizes.append(
            len(recorder.starts) + len(recorder.checkpoints) + sum(len(when) for when, _ in recorder.changes.values())
        )
    assert max(sizes[2:]) <= 1.3 * min(sizes[2:])
    assert live.now == 119_990


def test_a_recorded_run_is_written_as_a_timeline_and_runs_again_the_same() -> None:
    live = Live(SEAL_IN)
    for scans, address, value in ((20, "I0.0", 1), (7, "I0.0", 0), (100, "I0.1", 1), (3, "I0.1", 0), (10, "I0.0", 1)):
        live.run(scans)
        live.press(address, value)
    live.run(5)
    again = run(SEAL_IN, _scans(live.timeline()))
    for address in ("I0.0", "I0.1", "Q0.0", "Q0.1"):
        assert again[address][: live.scans] == live.trace()[address]
    assert recorded(run(SEAL_IN, 5)).text == "= Q0.0: 50ms off\n= Q0.1: 50ms off"


def _scans(text: str) -> list[dict[str, int]]:
    return list(_read(text).scans())


def _read(text: str) -> Timeline:
    found = timeline(text, SEAL_IN.dialect)
    assert found.diagnostics == ()
    return to_its_end(found)


def pressed(live: Live, *acts: tuple[int, str, int]) -> Live:
    """Run so many scans before each act."""
    for scans, address, value in acts:
        live.run(scans)
        live.press(address, value)
    live.run(25)
    return live


ACTS = ((20, "I0.0", 1), (7, "I0.0", 0), (100, "I0.1", 1), (3, "I0.1", 0), (10, "I0.0", 1))


def test_a_recording_says_what_the_outputs_were_and_ends_where_the_run_ended() -> None:
    live = pressed(Live(SEAL_IN), *ACTS)
    line = _read(live.timeline())
    assert line.until_ms == live.now == 1640
    assert line.text == live.timeline()
    by_hand = [
        "I0.0: 0.2s off, 70ms on, 1130ms off, 250ms on",
        "I0.1: 1270ms off, 30ms on, 350ms off",
        "= Q0.0: 0.2s off, 1070ms on, 130ms off, 250ms on",
        "= Q0.1: 0.7s off, 570ms on, 380ms off",
    ]
    assert live.timeline().splitlines() == by_hand


def test_a_replay_is_the_same_scan_for_scan_and_then_stands_still_until_somebody_takes_over() -> None:
    first = pressed(Live(SEAL_IN), *ACTS)
    line, was = first.recording(), first.trace()
    live = pressed(Live(SEAL_IN), (3, "I0.1", 1))
    live.replay(line)
    live.press("I0.1", 1)
    live.run(60)
    assert not live.over
    live.run(10_000)
    assert live.over
    now = live.trace()
    assert now.starts == was.starts
    for address in ("I0.0", "I0.1", "Q0.0", "Q0.1", "T37.V"):
        assert now[address] == was[address]
    assert live.differs == []
    assert live.recording() == line
    live.take_over()
    assert live.held == {"I0.0": 1}, "what was on stays on"
    live.run(5)
    assert live.scans == first.scans + 5
    live.press("I0.1", 1)
    live.run(1)
    assert live.trace()["Q0.0"][-2:] == "10"
    assert live.timeline().splitlines()[0] == "I0.0: 0.2s off, 70ms on, 1130ms off, 310ms on"


def test_another_program_is_told_apart_at_the_scan_at_which_it_differs() -> None:
    line = pressed(Live(SEAL_IN), *ACTS).recording()
    later = read("LD I0.0; O Q0.0; AN I0.1; = Q0.0; LD Q0.0; TON T37, 6; LD T37; = Q0.1", "s7-200")
    found = differences(line, run(later, line.scans()))
    assert [(one.address, one.scan, one.ms, one.expected, one.got) for one in found] == [("Q0.1", 70, 700, "1", "0")]
    assert "0.70 s" in found[0].text.zh
    assert "scan 71" in found[0].text.en
    assert differences(line, run(later, line.scans()), within_ms=100) == ()
    assert len(differences(line, run(later, line.scans()), within_ms=90)) == 1
    live = Live(later)
    live.replay(line)
    live.run(1_000)
    assert live.differs == list(found)


def test_the_recording_reaches_back_to_power_on_even_where_the_past_is_forgotten() -> None:
    live = Live(BUSY, kept_ms=2_000)
    for number in range(20):
        live.press("I0.0", number % 2)
        live.run(70)
    assert live.forgotten > 500
    again = Live(BUSY)
    again.replay(live.recording())
    again.run(5_000)
    assert again.scans == live.scans == 1_400
    assert again.differs == []
    for address in ("I0.0", "Q0.0", "Q0.1", "Q0.2", "C0.V"):
        assert again.trace()[address][live.forgotten :] == live.trace()[address]


class Carriage:
    """A plant of three lines: it goes right while Q0.0 is on and meets a limit switch at 100 mm."""

    def __init__(self) -> None:
        self.x = 0

    def sense(self) -> dict[str, int]:
        return {"I0.1": int(self.x >= 100)}

    def step(self, outputs: dict[str, int], ms: int) -> None:
        self.x += outputs["Q0.0"] * ms // 10

    def reset(self) -> None:
        self.x = 0

    def moment(self) -> int:
        return self.x

    def follow(self, row: dict[str, int]) -> None:
        """It has no buttons."""


def test_the_plant_closes_the_loop_and_a_hand_goes_before_it() -> None:
    live = Live(SEAL_IN, Carriage())
    live.press("I0.0", 1)
    live.run(1)
    live.press("I0.0", 0)
    live.run(200)
    on = live.trace()["Q0.0"].count("1")
    assert on == 100, "100 scans of 1 mm each, and the scan that sees the switch turns the motor off"
    assert live.forced() == []
    live.reset()
    assert live.trace().starts == ()
    live.press("I0.1", 0)
    live.press("I0.0", 1)
    live.run(150)
    assert live.trace()["Q0.0"] == "1" * 150, "the limit switch is held at 0 by hand"
    assert live.forced() == ["I0.1"]
    live.release("I0.1")
    live.run(1)
    assert live.trace()["Q0.0"][-1] == "0"


@pytest.mark.parametrize("asked", [-5, 0, 63, 64, 65, 128])
def test_forgetting_goes_by_whole_stretches(asked: int) -> None:
    recorder = Recorder(BUSY, Memory(), 10)
    for _ in range(300):
        recorder.scan({})
    gone = recorder.forget(asked)
    assert gone == max(0, asked // 64 * 64)
    assert len(recorder.starts) == 300 - gone
    assert sorted(recorder.checkpoints) == list(range(0, 300 - gone, 64))
