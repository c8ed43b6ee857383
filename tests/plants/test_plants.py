"""Every plant closed over its programs: the right ones by values worked out by hand, the others by the fault they run into."""

from __future__ import annotations

import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import pytest

from plcteach import dialects, plants
from plcteach.core.errors import UnknownNameError
from plcteach.plants import Model
from plcteach.plants.condition import read_condition

sys.path.insert(0, str(Path(__file__).parent))
from closed_loop import Loop, played, sample_loop

ALL = [plants.plant(name) for name in plants.names()]
SAMPLES = [(plant, sample) for plant in ALL for sample in plant.samples]
NEAR = 25
"""Two scans and a bit: the times below are the plant's, and a scan sees a change up to one scan late."""

pytestmark = pytest.mark.no_cover  # many scans: measured lines would take most of the time


def named(value: object) -> str:
    return getattr(value, "id", "") or f"{value.role}: {value.title.en}"  # type: ignore[attr-defined]


def test_the_eight_plants_of_the_issue_are_there_each_with_programs_that_fail() -> None:
    assert set(plants.names()) == {
        "three-motors",
        "flashing-lamp",
        "eight-lamps",
        "reject-conveyor",
        "drilling-head",
        "star-delta",
        "traffic-light",
        "two-hand-press",
    }
    for plant in ALL:
        assert plant.family in dialects.names()
        assert len([one for one in plant.samples if one.role in {"book", "wrong"}]) >= 2, plant.id
    for name in ("drilling-head", "reject-conveyor"):
        assert any(one.role == "book" for one in plants.plant(name).samples)


@pytest.mark.parametrize(("plant", "sample"), SAMPLES, ids=named)
def test_a_program_does_what_its_plant_file_promises(plant, sample) -> None:
    loop, unseen = played(plant, sample)
    faults = {one.id: one for one in loop.model.faults}
    if sample.fault:
        assert sample.fault in faults
        said = faults[sample.fault].says
        assert len(said.zh) > 8
        assert len(said.en) > 20
    else:
        assert not faults
        assert not unseen


@pytest.mark.parametrize("plant", ALL, ids=named)
@pytest.mark.parametrize("scan", [2, 20])
def test_the_reference_also_runs_with_shorter_and_longer_scans(plant, scan: int) -> None:
    loop, _ = played(replace(plant, cycle=replace(plant.cycle, times=1)), plant.reference, scan)
    assert not loop.model.faults


# By values, worked out by hand from speeds and distances.


def near(found: list[tuple[int, int]], wanted: list[int], tolerance: int = NEAR) -> None:
    """The moments at which an output went on, off, on …"""
    assert [value for _, value in found] == [1 - number % 2 for number in range(len(wanted))], found
    for (ms, _), goal in zip(found, wanted, strict=True):
        assert abs(ms - goal) <= tolerance, (ms, goal)


def run(name: str) -> Loop:
    plant = plants.plant(name)
    loop, _ = played(plant, plant.reference)
    assert plant.cycle.ms / plant.cycle.every_ms >= 3 or plant.cycle.ms >= 3 * 24_020
    return loop


def rounds(every: int, *moments: int) -> list[int]:
    return [turn * every + moment for turn in range(3) for moment in moments]


def test_three_motors_start_five_seconds_apart_and_stop_together() -> None:
    loop = run("three-motors")
    for address, start in (("%Q0.1", 1_000), ("%Q0.2", 6_000), ("%Q0.3", 11_000)):
        near(loop.times(address), rounds(18_000, start, 14_000))
    assert loop.times("%Q0.1")[1] == loop.times("%Q0.3")[1]


def test_the_lamp_flashes_twenty_times_a_second_and_two_scans_each() -> None:
    loop = run("flashing-lamp")
    flashes = [moment for n in range(20) for moment in (1_500 + 2_040 * n, 2_520 + 2_040 * n)]
    near(loop.times("%Q0.0"), rounds(45_000, *flashes))


def test_each_of_eight_lamps_is_lit_for_a_second_and_two_scans() -> None:
    loop = run("eight-lamps")
    for number in range(8):
        lit = [500 + 1_020 * step - 20 * (step > 0) for step in range(number, 16, 8)]
        past = [500 + 1_020 * (step + 1) - 20 for step in range(number, 16, 8)]
        moments = [moment for pair in zip(lit, past, strict=True) for moment in pair if moment < 16_000]
        near(loop.times(f"%Q0.{number}"), rounds(18_000, *moments, *([16_000] if len(moments) % 2 else [])), 45)


def test_a_waste_part_is_pushed_off_five_places_after_it_was_found() -> None:
    """Part i enters when the belt has gone 50 + 100 i mm; the pulse that fires the manipulator comes at 600 + 100 i."""
    pattern = "ggwgggwwgg"
    plant = plants.plant("reject-conveyor")
    loop = sample_loop(plant, plant.reference)
    seen = 0

    def belt(ms: int) -> tuple[float, bool]:
        turn, rest = divmod(ms, 30_000)
        return turn * 2_490 + min(max(rest - 500, 0), 24_900) / 10, 500 <= rest < 25_400

    def see(ms: int) -> None:
        nonlocal seen
        gone, runs = belt(ms)
        if 30 < gone % 100 < 70:
            part = int(gone // 100) - 6
            wanted = int(runs and part >= 0 and pattern[part % 10] == "w")
            assert loop.model.bits["KM3"] == loop.model.bits["KM2"] == bool(wanted), ms
            seen += wanted

    loop.play(plant.cycle.all_acts(), plant.cycle.ms, see)
    assert loop.model.position("pushes") >= 12
    assert seen > 500
    assert not loop.model.faults


def test_the_drilling_head_goes_rapidly_feeds_twice_and_returns() -> None:
    """40 mm at 50 mm/s, 20 mm at 10, 30 mm at 4, back at 50; it stands 3 mm before its stop when home is felt."""
    loop = run("drilling-head")
    advance, limit, back = [], [], []
    for turn, ahead in enumerate((0, 3, 3)):
        start = 500 + 14_000 * turn
        second = start + (40 - ahead) * 20 + 2_000
        end = second + 7_500
        advance += [start, end]
        limit += [second, end]
        back += [end, end + 87 * 20]
    near(loop.times("%Q0.1"), advance, 60)
    near(loop.times("%Q0.2"), limit, 60)
    near(loop.times("%Q0.3"), back, 60)


def test_the_first_feed_begins_without_a_signal_of_the_plc() -> None:
    plant = plants.plant("drilling-head")
    model = Model(plant)
    model.step({"%Q0.1": 1}, 700)
    assert model.position("head") == 35
    model.step({"%Q0.1": 1}, 200)  # 5 mm in 0.1 s, and then the cam valve: 1 mm in 0.1 s
    assert model.position("head") == 41
    model.step({"%Q0.1": 1, "%Q0.2": 1}, 1_000)
    assert model.position("head") == 45


def test_the_motor_goes_from_star_to_delta_after_six_seconds_and_a_pause() -> None:
    loop = run("star-delta")
    near(loop.times("Y0"), rounds(30_000, 500, 16_000))
    near(loop.times("Y1"), rounds(30_000, 500, 6_500))
    near(loop.times("Y2"), rounds(30_000, 6_700, 16_000), 45)


def test_the_traffic_light_keeps_its_times_for_four_cycles() -> None:
    loop = run("traffic-light")

    def cycles(on: int, off: int) -> list[int]:
        return [1_000 + 24_020 * turn + moment for turn in range(4) for moment in (on, off)]

    for address, on, off in (
        ("Q0.2", 0, 10_000),
        ("Q0.1", 10_000, 12_000),
        ("Q0.5", 13_000, 21_000),
        ("Q0.4", 21_000, 23_000),
    ):
        near(loop.times(address)[:8], cycles(on, off), 90)
    assert loop.model.position("cars") > 25
    assert loop.model.position("vans") > 18


def test_the_press_needs_both_hands_together_for_every_stroke() -> None:
    """150 mm at 200 mm/s, 50 mm at 50, back at 250; a hand that lets go sends the ram up; too late a hand starts nothing."""
    loop = run("two-hand-press")
    near(loop.times("Q0.0"), rounds(9_000, 600, 2_350, 5_100, 5_500), 40)
    near(loop.times("Q0.1")[:4], [2_350, 2_350 + 198 * 4, 5_500, 5_500 + 78 * 4], 40)
    assert loop.model.position("strokes") == 3


# What is connected wrongly is noticed.


def noticed(plant, text: str = "") -> bool:
    sample = replace(plant.reference, text=text or plant.reference.text)
    short = replace(plant, cycle=replace(plant.cycle, times=1))
    loop, unseen = played(short, sample)
    return bool(unseen or loop.model.faults)


def swapped(plant, one: str, two: str):
    addresses = {one: plant.device(two).address, two: plant.device(one).address}
    return replace(plant, devices=tuple(replace(d, address=addresses.get(d.symbol, d.address)) for d in plant.devices))


@pytest.mark.parametrize("plant", ALL, ids=named)
def test_two_swapped_outputs_are_noticed(plant) -> None:
    symbols = [one.symbol for one in plant.outputs]
    for one, two in [*pairwise(symbols), *([(symbols[0], symbols[-1])] if len(symbols) > 2 else [])]:
        if (one, two) == ("KM3", "KM2"):
            continue  # manipulator and belt B are driven by one signal
        assert noticed(swapped(plant, one, two)), (one, two)


@pytest.mark.parametrize(
    ("plant", "symbol"),
    [(plant, one.symbol) for plant in ALL for one in plant.devices if one.on and one.symbol != "FR"],
    ids=lambda value: getattr(value, "id", value),
)
def test_a_switch_that_never_comes_on_is_noticed(plant, symbol: str) -> None:
    never = read_condition(f"{symbol} & !{symbol}")
    assert noticed(
        replace(plant, devices=tuple(replace(d, on=never) if d.symbol == symbol else d for d in plant.devices))
    )


def moved(plant, symbol: str, on: str):
    return replace(
        plant, devices=tuple(replace(d, on=read_condition(on)) if d.symbol == symbol else d for d in plant.devices)
    )


@pytest.mark.parametrize(
    ("name", "symbol", "on", "fault"),
    [
        ("drilling-head", "SQ2", "head = 70..74", "breaks"),
        ("drilling-head", "SQ2", "head = 20..24", "skipped"),
        ("drilling-head", "BP", "head >= 99.5", "overrun"),
        ("two-hand-press", "SQ2", "ram >= 205.5", "overrun"),
        ("reject-conveyor", "P", "waste = 190..260", "passes"),
    ],
)
def test_a_limit_switch_out_of_place_leads_to_its_fault(name: str, symbol: str, on: str, fault: str) -> None:
    plant = moved(plants.plant(name), symbol, on)
    loop, _ = played(replace(plant, cycle=replace(plant.cycle, times=1)), plant.reference)
    assert fault in [one.id for one in loop.model.faults]


def test_a_blown_relay_stops_the_motor() -> None:
    """FR is wired normally closed: with the heat at 100 % its input falls to 0, and the reference lets go."""
    plant = plants.plant("star-delta")
    loop = sample_loop(plant, plant.reference)
    loop.play([act for act in plant.cycle.acts if act.ms < 5_000], 9_000)
    assert loop.model.sense()["X2"] == 1
    assert loop.model.bits["KMD"]
    loop.model.spots["heat"][0] = 110_000_000
    loop.model.step({}, 10)
    assert loop.model.sense()["X2"] == 0
    loop.until(9_100)
    assert not any(loop.model.bits[one] for one in ("KM1", "KMY", "KMD"))
    assert not loop.model.faults


def test_the_books_drum_works_with_one_way_switches_and_strands_with_two_way_ones() -> None:
    plant = plants.plant("drilling-head")
    drum = next(one for one in plant.samples if one.fault == "stranded")
    loop = sample_loop(plant, drum)
    loop.model.way("SQ2", "up")
    loop.model.way("BP", "up")
    loop.play(plant.cycle.all_acts(), plant.cycle.ms)
    assert not loop.model.faults
    assert loop.model.position("head") <= 3


def test_rewiring_the_stop_button_stops_the_books_program_from_starting() -> None:
    plant = plants.plant("three-motors")
    loop = sample_loop(plant, plant.reference)
    loop.model.wire("SB2", "NC")
    loop.play([act for act in plant.cycle.acts if act.ms < 2_000], 3_000)
    assert [one.id for one in loop.model.faults] == ["dead"]
    assert not loop.times("%Q0.1")


def test_ten_minutes_leave_no_more_behind_than_one() -> None:
    plant = plants.plant("traffic-light")
    model = Model(plant)
    for _ in range(600):
        model.step({"Q0.2": 1, "Q0.3": 1}, 1_000)
    assert len(model.spots["car"]) < 12
    assert len(model.spots["van"]) < 12
    assert len(model.faults) <= 1


def test_a_name_that_nobody_knows_suggests_the_nearest() -> None:
    with pytest.raises(UnknownNameError, match="drilling-head"):
        plants.plant("driling-head")
    assert plants.plant(ALL[0]) is ALL[0]


def test_a_teacher_may_keep_a_plant_in_a_file_of_his_own(tmp_path: Path) -> None:
    source = Path(plants.__file__).with_name("three-motors.toml").read_text(encoding="utf-8")
    path = tmp_path / "my-motors.toml"
    path.write_text(source.replace("speed = 50", "speed = 25"), encoding="utf-8")
    mine = plants.load(path)
    assert mine.id == "my-motors"
    assert mine.part("m1").moves[0].speed * 2 == plants.plant("three-motors").part("m1").moves[0].speed
