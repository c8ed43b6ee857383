"""What a live bench is told: the values beside the lines, only what has changed, and a chart that grows."""

from __future__ import annotations

import json
from typing import Any

from plcteach.figure.live import Watch
from plcteach.machine.live import Live
from plcteach.plants import Model
from plcteach.plants import plant as find_plant
from plcteach.stl import read, read_symbols
from plcteach.widgets.live import LiveBench, Session

PROGRAM = "LD I0.0; O Q0.0; AN I0.1; = Q0.0; LD Q0.0; TON T37, 5; LD T37; EU; INCW VW0; LD T37; = Q0.1"


def watched(text: str = PROGRAM) -> Watch:
    return Watch(Live(read(text, "s7-200")))


def test_beside_each_line_stand_its_operand_and_the_uppermost_levels_of_the_stack() -> None:
    watch = watched("LD I0.0; LD I0.1; OLD; = Q0.0; LD I0.2; JMP 1; LD I0.3; = Q0.1; LBL 1; LD I0.3; = Q0.2")
    watch.live.press("I0.1", 1)
    watch.live.press("I0.2", 1)
    watch.live.run(1)
    lines = watch.batch(watch.live.at(0), 0)["lines"]
    assert lines[:4] == [
        ["0", "0", "x", "x", "x"],
        ["1", "1", "0", "x", "x"],
        ["", "1", "x", "x", "x"],
        ["1", "1", "x", "x", "x"],
    ]
    assert lines[6] == lines[7] == [], "what is jumped over has no values"
    assert lines[9][0] == "0"


def test_the_page_is_told_only_what_has_changed() -> None:
    watch = watched()
    watch.live.run(2)
    first = watch.batch(watch.live.at(1), 1)
    assert {"lines", "lit", "bits", "words", "faces"} <= set(first)
    watch.live.run(1)
    assert not {"lines", "lit", "bits", "words", "faces"} & set(watch.batch(watch.live.at(2), 2))
    watch.live.press("I0.0", 1)
    watch.live.run(30)
    later = watch.batch(watch.live.at(32), 32)
    assert later["bits"]["Q0.0"] == "1"
    assert set(later["faces"]) == {"T37"}
    assert "words" not in later
    assert "s0-2" in later["lit"]


def test_the_chart_gets_each_change_once_and_a_word_when_it_is_another() -> None:
    watch = watched()
    watch.live.run(3)
    watch.batch(watch.live.at(2), 2)
    begin = watch.chart()
    assert begin["I0.0"] == [[0, "0"]]
    watch.live.press("I0.0", 1)
    watch.live.run(70)
    watch.batch(watch.live.at(72), 72)
    grown = watch.chart()
    assert grown["I0.0"] == [[30, "1"]]
    assert grown["Q0.1"] == [[530, "1"]]
    assert grown["VW0"][-1][1] == "1"
    assert watch.chart() == {}


def test_what_does_not_change_is_told_once_with_the_names_of_a_symbol_table() -> None:
    table = read_symbols("Start\tI0.0\tpush-button\nMotor\tQ0.0\t\n")
    program = read("LD Start; O Motor; = Motor", "s7-200", symbols=table)
    cast = Watch(Live(program)).cast()
    assert cast["inputs"] == [{"address": "I0.0", "name": "Start"}]
    assert cast["lamps"] == [{"address": "Q0.0", "name": "Motor"}]
    assert len(cast["ladder"]["rungs"]) == 1
    assert json.loads(json.dumps(cast)) == cast


def answer(session: Session, **asked: Any) -> dict[str, Any]:
    return session.answer({"id": 1, **asked})


def test_a_session_runs_only_when_it_is_asked_and_never_more_than_a_request_may_want() -> None:
    session = Session(Live(read(PROGRAM, "s7-200")))
    assert answer(session, type="look")["scans"] == 1
    assert answer(session, type="run", scans=5)["scans"] == 6
    assert answer(session, type="run", scans=10**9)["scans"] == 2_006
    assert answer(session, type="run", scans=-3)["scans"] == 2_006
    earlier = answer(session, type="look", at=3)
    assert (earlier["scan"], earlier["now"], earlier["scans"]) == (3, 30, 2_006)
    assert answer(session, type="start", how="cold")["scans"] == 1


def test_events_set_inputs_of_the_program_and_nothing_else() -> None:
    session = Session(Live(read(PROGRAM, "s7-200")))
    told = answer(session, type="run", scans=2, events=[["I0.0", 1], ["Q0.1", 1], ["<b>", 1], ["I0.9", 7]])
    assert (told["bits"]["I0.0"], told["bits"]["Q0.0"], told["bits"]["Q0.1"]) == ("1", "1", "0")
    told = answer(session, type="run", scans=1, events=[["I0.0", None]])
    assert told["bits"]["I0.0"] == "0"
    assert answer(session, type="timeline")["text"] == "I0.0: 20ms on, 10ms off\n= Q0.0: 30ms on\n= Q0.1: 30ms off\n"


def test_a_frozen_scan_is_a_film_and_a_warm_start_keeps_what_is_retentive() -> None:
    session = Session(Live(read("LD I0.0; = Q0.0; LD I0.0; TONR T5, 3", "s7-200")))
    answer(session, type="run", scans=25, events=[["I0.0", 1]])
    film = json.loads(answer(session, type="film", at=20)["film"])
    assert [step["line"] for step in film["steps"]] == [-1, 0, 1, 2, 3]
    assert film["faces"][0]["gauge"]["value"] == 1, "the timer as the scan finds it: 190 ms"
    warm = answer(session, type="start", how="warm", events=[["I0.0", 0]])
    assert warm["faces"]["T5"]["gauge"]["value"] == 2
    cold = answer(session, type="start", how="cold")
    assert cold["faces"]["T5"]["gauge"]["value"] == 0


def test_two_benches_do_not_disturb_each_other_and_each_says_what_it_is() -> None:
    program = read(PROGRAM, "s7-200")
    one, other = LiveBench(program, language="en"), LiveBench(program, language="zh")
    one._session.answer({"type": "run", "scans": 10, "events": [["I0.0", 1]]})
    other._session.answer({"type": "run", "scans": 4})
    assert one.trace["Q0.0"] == "1" * 10
    assert other.trace["Q0.0"] == "0" * 4
    assert repr(one) == repr(other) == "LiveBench(s7-200, 11 lines)"
    assert one.timeline.startswith("I0.0: ")


def planted(name: str, role: str = "reference") -> Session:
    plant = find_plant(name)
    sample = next(one for one in plant.samples if one.role == role)
    return Session(Live(read(sample.text, sample.family), Model(plant.for_(sample))))


def test_a_plant_is_pressed_by_its_symbol_and_its_picture_follows() -> None:
    session = planted("eight-lamps")
    cast = session.watch.cast()
    assert cast["plant"]["hands"]["SB1"]["springs"] is True
    assert {"address": "%I0.0", "name": "SB1"} in cast["inputs"]
    told = answer(session, type="run", scans=3, events=[["@SB1", 1]])
    assert told["bits"]["%I0.0"] == "1"
    told = answer(session, type="run", scans=50, events=[["@SB1", 0]])
    assert [part for part in told["plant"]["on"] if part.startswith("L")] == ["L1"]
    told = answer(session, type="run", scans=100)
    assert [part for part in told["plant"]["on"] if part.startswith("L")] == ["L2"]
    assert told["found"] == []
    assert told["forced"] == []


def test_the_past_of_a_plant_is_looked_at_again_and_does_not_change_its_present() -> None:
    session = planted("drilling-head")
    answer(session, type="run", scans=2)
    answer(session, type="run", scans=5, events=[["@SB1", 1]])
    now = answer(session, type="run", scans=300, events=[["@SB1", 0]])["plant"]
    then = answer(session, type="look", at=20)["plant"]
    assert then["text"] != now["text"]
    assert answer(session, type="look", anew=True)["plant"] == now


def test_the_books_program_shows_its_fault_in_words_and_a_button_can_be_wired_otherwise() -> None:
    session = planted("eight-lamps", "book")
    answer(session, type="run", scans=2, events=[["@SB1", 1]])
    told = answer(session, type="run", scans=1_000, events=[["@SB1", 0]])
    (fault,) = told["found"]
    assert fault["en"].split(":")[0].endswith(" s")
    assert fault["zh"] != fault["en"]
    session = planted("three-motors")
    assert answer(session, type="run", scans=1)["bits"]["%I0.1"] == "0"
    answer(session, type="wire", symbol="SB2", how="NC")
    answer(session, type="wire", symbol="<b>", how="NC")
    assert answer(session, type="run", scans=1)["bits"]["%I0.1"] == "1"


def test_an_input_that_the_plant_moves_is_forced_by_hand_and_given_back() -> None:
    session = planted("drilling-head")
    told = answer(session, type="run", scans=1, events=[["%I0.2", 1]])
    assert (told["forced"], told["bits"]["%I0.2"]) == (["%I0.2"], "1")
    told = answer(session, type="run", scans=1, events=[["%I0.2", None]])
    assert (told["forced"], told["bits"]["%I0.2"]) == ([], "0")


def test_a_limit_switch_can_be_fitted_to_act_one_way_only() -> None:
    session = planted("drilling-head")
    model = session.watch.model
    assert model is not None
    assert [row[0] for row in session.watch.cast()["plant"]["ways"]][:1] == ["SQ1"]
    answer(session, type="wire", symbol="SQ2", how="up")
    answer(session, type="wire", symbol="SB1", how="up")
    assert model.ways["SQ2"] == "up"
    assert session.watch.cast()["plant"]["ways"][1][:2] == ["SQ2", "up"]
