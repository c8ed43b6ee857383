"""A chart and a face from a run: what is drawn, what is refused in words."""

from __future__ import annotations

import pytest

import plcteach as plc
from plcteach.core.errors import PlcTeachError, UnknownNameError
from plcteach.figure.charts import chart_of, telling_addresses, tracks_of
from plcteach.figure.scene import Words
from plcteach.figure.verbs import film_of

LAMP = "LD I0.0; TON T37, 5; LD T37; = Q0.0"


@pytest.fixture
def trace():
    return plc.run(LAMP, "I0.0: 1s off, 1s on, off", scan_ms=50)


def test_tracks_are_the_changes_of_the_run(trace) -> None:
    tracks = {track.label: track for track in tracks_of(trace, ["I0.0", "T37.V", "Q0.0"])}
    assert tracks["I0.0"].changes == ((0, 0), (1000, 1), (2000, 0))
    assert tracks["Q0.0"].changes == ((0, 0), (1500, 1), (2000, 0))
    assert (tracks["T37.V"].word, tracks["T37.V"].unit) == (True, "×100 ms")
    assert max(value for _, value in tracks["T37.V"].changes) == 9


def test_without_a_wish_inputs_values_and_outputs_are_drawn(trace) -> None:
    assert telling_addresses(trace.program) == ["I0.0", "T37.V", "Q0.0"]
    words = [shape.text.en for shape in chart_of(trace).shapes if isinstance(shape, Words)]
    assert {"I0.0", "T37.V", "Q0.0"} <= set(words)


def test_a_chart_of_a_text_is_the_chart_of_its_run(trace) -> None:
    again = plc.chart(LAMP, "I0.0: 1s off, 1s on, off", show="I0.0, Q0.0", scan_ms=50)
    assert again.scene == plc.chart(trace, show=["I0.0", "Q0.0"]).scene


def test_a_face_shows_the_block_at_the_end_of_its_scan(trace) -> None:
    words = [shape.text.en for shape in plc.face(trace, "t37", 30).scene.shapes if isinstance(shape, Words)]
    assert {"current 5", "preset 5", "500 ms of 500 ms"} <= set(words)


def test_wrong_wishes_are_refused_in_words(trace) -> None:
    with pytest.raises(UnknownNameError, match="T38"):
        plc.face(trace, "T38")
    with pytest.raises(PlcTeachError, match="scans, counted from 0"):
        plc.face(trace, "T37", 10_000)
    with pytest.raises(PlcTeachError, match="already"):
        plc.chart(trace, "I0.0: 1s on")
    with pytest.raises(PlcTeachError, match="show nothing"):
        film_of(trace, at=100)
    with pytest.raises(PlcTeachError, match="row 1"):
        plc.run(LAMP, "I0.0: 1 on")


def test_a_film_begins_where_it_is_asked_to(trace) -> None:
    film = film_of(trace, at=1.5, scans=2)
    assert [step["scan"] for step in film.data["steps"] if step["line"] < 0] == [30, 31]


@pytest.mark.parametrize("value", ["on", 2, None, 0.5])
def test_a_bit_is_0_1_or_x(value) -> None:
    with pytest.raises(PlcTeachError, match="is a bit"):
        plc.run(LAMP, [{"I0.0": value}])


def test_words_and_times_that_cannot_be_are_refused() -> None:
    with pytest.raises(PlcTeachError, match="16 bits"):
        plc.run(LAMP, [{"VW0": 70_000}])
    with pytest.raises(PlcTeachError, match="0 or more"):
        plc.run(LAMP, [{}, {"ms": -1}])
    with pytest.raises(PlcTeachError, match="0 or more"):
        plc.run(LAMP, 3, scan_ms=-1)
    assert plc.run(LAMP, {"I0.0": 1})["T37.V"] == [0]
