"""Plants without a page and recordings as tests: what is reported agrees with a loop that is written by other hands."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

import plcteach as plc
from plcteach import plants
from plcteach.core import text as words
from plcteach.core.errors import PlcTeachError, UnknownNameError

sys.path.insert(0, str(Path(__file__).parents[1] / "plants"))
from closed_loop import played

ALL = [plants.plant(name) for name in plants.names()]
SAMPLES = [(plant, sample) for plant in ALL for sample in plant.samples]

pytestmark = pytest.mark.no_cover  # many scans: measured lines would take most of the time


@pytest.fixture(autouse=True)
def _language_as_before() -> Iterator[None]:
    kept = list(words._chosen)
    yield
    words._chosen[:] = kept


def named(value: object) -> str:
    return getattr(value, "id", "") or f"{value.role}: {value.title.en}"  # type: ignore[attr-defined]


@pytest.mark.parametrize(("plant", "sample"), SAMPLES, ids=named)
def test_a_plant_that_runs_by_itself_does_what_it_does_in_the_loop(plant, sample) -> None:
    mine = [one for one in plant.samples if one.role == sample.role]
    told = plc.drive(plant, f"{sample.role} {mine.index(sample) + 1}")
    loop, unseen = played(plant, sample)
    assert told.faults == loop.model.faults
    assert [f"{one.ms} ms: {one.what.text}" for one in told.missed] == unseen
    assert bool(told) == (not loop.model.faults and not unseen)
    for device in told.plant.outputs:
        mine = [(ms, value) for ms, symbol, value in told.moments if symbol == device.symbol]
        assert mine == loop.times(device.address)


def test_what_went_wrong_is_said_in_both_languages() -> None:
    plc.language("en")
    told = plc.drive("star-delta", "wrong")
    assert "short circuit" in repr(told)
    assert "<li>" in told._repr_html_()
    plc.language("zh")
    assert "短路" in repr(told)
    assert "没有出错" in repr(plc.drive("star-delta", seconds=8))


def test_other_hands_and_other_lengths() -> None:
    told = plc.drive("drilling-head", hands="@SB1: 1s off, 0.2s on, off", seconds=12)
    assert len(told.trace) == 1_200
    assert [ms for ms, symbol, value in told.moments if symbol == "SB1"] == [1_000, 1_200]
    assert plc.drive("drilling-head", hands="@SB1: 3s off").moments == tuple(
        (0, symbol, 1) for symbol in ("S1", "SQ1")
    ), "nobody presses: nothing moves"
    for wrong in ({"seconds": 0}, {"seconds": 1e7}, {"hands": "@SB1: soon"}):
        with pytest.raises(PlcTeachError):
            plc.drive("drilling-head", **wrong)
    with pytest.raises(UnknownNameError):
        plc.drive("drilling-heat")


def test_a_recording_is_a_test_of_another_program() -> None:
    plc.language("en")
    seal_in = "LD I0.0; O Q0.0; AN I0.1; = Q0.0"
    wanted = "I0.0: 1s off, 0.2s on, 3s off\nI0.1: 3s off, 0.2s on, 1s off\n= Q0.0: 1s off, 2s on, 1.2s off"
    right = plc.replay(seal_in, wanted)
    assert right
    right.assert_same()
    assert len(right.trace) == 420
    wrong = plc.replay("LD I0.0; = Q0.0", wanted)
    assert not wrong
    assert repr(wrong) == "1.20 s (scan 121): Q0.0 was 1 in the recording and is 0 now."
    with pytest.raises(AssertionError, match=r"^1\.20 s"):
        wrong.assert_same()
    late = plc.replay("LD I0.0; O M0.0; AN I0.1; = M0.0; LD Q0.1; = Q0.0; LD M0.0; = Q0.1", wanted)
    assert [one.scan for one in late.differences] == [100]
    assert plc.replay("LD I0.0; O M0.0; AN I0.1; = M0.0; LD Q0.1; = Q0.0; LD M0.0; = Q0.1", wanted, within_ms=10)
    nothing = plc.replay(seal_in, "I0.0: on")
    assert not nothing
    assert "nothing to compare" in repr(nothing)
    with pytest.raises(PlcTeachError):
        plc.replay(seal_in, wanted, within_ms=-1)
