"""A live bench without a page: the messages of a recording, plants included, and that it needs no thread and no numpy."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import pytest

import plcteach as plc
from plcteach.core.errors import PlcTeachError
from plcteach.machine.live import Live
from plcteach.plants import Model, plant
from plcteach.stl import read
from plcteach.widgets.live import Session

SEAL_IN = read("LD I0.0; O Q0.0; AN I0.1; = Q0.0; LD Q0.0; TON T37, 5; LD T37; = Q0.1", "s7-200")


def on_plant(name: str) -> Session:
    there = plant(name)
    sample = there.reference
    return Session(Live(read(sample.text, sample.family), Model(there.for_(sample))))


def ask(session: Session, kind: str, **more: Any) -> dict[str, Any]:
    return session.answer({"type": kind, "id": 1, **more})


def test_a_plant_is_replayed_with_its_motion_its_forced_switch_and_its_faults() -> None:
    session = on_plant("drilling-head")
    ask(session, "run", scans=50, events=[["@SB1", 1]])
    ask(session, "run", scans=300, events=[["@SB1", 0]])
    forced = "%I0.2"
    ask(session, "run", scans=600, events=[[forced, 0]])
    was, moment = session.live.trace(), session.watch.model.moment()  # type: ignore[union-attr]
    assert any(one.address == forced for one in session.live.recording().rows)
    batch = ask(session, "replay")
    assert batch["anew"]
    assert batch["tape"] == {"end": was.starts[-1], "over": False, "tells": True, "same": True}
    batch = ask(session, "run", scans=2_000, events=[["@SB1", 1]])
    assert batch["tape"]["over"]
    now = session.live.trace()
    assert now.starts == was.starts
    assert all(now[one.text] == was[one.text] for role in ("input", "output") for one in now.program.addresses(role))
    assert session.watch.model.moment() == moment  # type: ignore[union-attr]
    assert ask(session, "hand")["tape"] is None


def test_a_timeline_of_the_buttons_alone_leaves_the_limit_switches_to_the_plant() -> None:
    session = on_plant("drilling-head")
    ask(session, "replay", text="@SB1: 0.3s off, 0.2s on, 15s off")
    ask(session, "run", scans=2_000)
    moments = [place for place in session.live.trace().edges("%I0.2") if repr(place[1]) == "1"]
    assert len(moments) == 2, "SQ2 was met going and coming"
    assert session.watch.found() == []


def test_what_was_saved_is_what_is_loaded_and_what_cannot_be_read_is_answered() -> None:
    session = Session(Live(SEAL_IN))
    ask(session, "run", scans=30, events=[["I0.0", 1]])
    saved = ask(session, "timeline")["text"]
    assert saved == "I0.0: 0.3s on\n= Q0.0: 0.3s on\n= Q0.1: 0.3s off\n"
    other = Session(Live(SEAL_IN))
    assert ask(other, "replay", text=saved)["tape"]["end"] == 290
    refused = ask(other, "replay", text="I0.0: soon")
    assert refused["type"] == "refused"
    assert refused["says"][0]["en"].startswith("row 1")
    ask(other, "start", how="cold")
    assert other.live.tape is None
    assert ask(other, "replay")["tape"]["end"] == 290, "with nothing done by hand the loaded one runs again"


def test_a_warm_start_is_replayed_with_what_was_retained_and_the_file_says_so() -> None:
    counts = read("LD I0.0; LD I0.1; CTU C0, 3; LD C0; = Q0.0", "s7-200")
    session = Session(Live(counts))
    for value in (1, 0, 1, 0):
        ask(session, "run", scans=2, events=[["I0.0", value]])
    ask(session, "start", how="warm")
    for value in (1, 0):
        ask(session, "run", scans=2, events=[["I0.0", value]])
    was = session.live.trace()["C0.V"]
    assert (was[0], was[-1]) == (1, 2), "one is retained, one is counted"
    assert ask(session, "timeline")["text"].startswith("// ")
    ask(session, "replay")
    ask(session, "run", scans=100)
    assert session.live.trace()["C0.V"] == was


def test_the_bench_begins_with_a_timeline_and_refuses_one_that_does_not_read() -> None:
    bench = plc.live(SEAL_IN, timeline="I0.0: 0.1s off, 0.1s on")
    assert bench.trace["I0.0"] == ""
    bench._session.answer({"type": "run", "scans": 500})
    assert bench.trace["I0.0"] == "0" * 10 + "1" * 10
    assert plc.replay(SEAL_IN, bench.timeline)
    with pytest.raises(PlcTeachError):
        plc.live(SEAL_IN, timeline="I0.0: soon")


def test_the_workbench_replays_what_was_pressed_on_a_changed_program() -> None:
    bench = plc.bench("LD I0.0\n= Q0.0")
    bench._asked(bench, {"type": "live", "on": True}, [])
    first = bench._session
    assert first is not None
    ask(first, "run", scans=20, events=[["I0.0", 1]])
    bench.source, bench.serial = "LDN I0.0\n= Q0.0", 1
    second = bench._session
    assert second is not None
    assert second is not first
    ask(second, "replay")
    batch = ask(second, "run", scans=100)
    assert batch["tape"]["over"]
    assert "Q0.0" in batch["found"][0]["zh"]


def test_it_runs_without_threads_numpy_or_matplotlib() -> None:
    code = """
import sys, threading
for name in ("numpy", "matplotlib"):
    sys.modules[name] = None
def refuse(*_): raise RuntimeError("can't start new thread")
threading.Thread.start = refuse
import plcteach as plc
bench = plc.live(plant="drilling-head")
bench._session.answer({"type": "run", "scans": 500, "events": [["@SB1", 1]]})
assert bench._session.answer({"type": "film"})["film"]
assert bench._session.answer({"type": "replay"})["tape"]
assert plc.drive("drilling-head")
"""
    subprocess.run([sys.executable, "-c", code], check=True)
