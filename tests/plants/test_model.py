"""The model beside plain arithmetic: positions after so many ms, however the time is cut, switches, workpieces and latches."""

from __future__ import annotations

import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach import plants
from plcteach.core.errors import DeclarationError, PlcTeachError, UnknownNameError
from plcteach.plants import Model
from plcteach.plants.condition import micro, read_condition

ALL = [plants.plant(name) for name in plants.names()]

SMALL = """
title = { zh = "小车", en = "A carriage" }
story = { zh = "去一趟，再回来。", en = "There and back." }
picture = [200, 100]
cycle = { every = 1000, times = 1, acts = [[100, "SB1", 1]] }

[[io]]
symbol = "SB1"
at = "I0.0"
kind = "push-button"
what = { zh = "按钮", en = "button" }

[[io]]
symbol = "SQ1"
at = "I0.1"
kind = "limit-switch"
on = "cart = 10..20"
what = { zh = "开关", en = "switch" }

[[io]]
symbol = "KM1"
at = "Q0.0"
kind = "contactor"
what = { zh = "前进", en = "forwards" }

[[io]]
symbol = "KM2"
at = "Q0.1"
kind = "contactor"
what = { zh = "后退", en = "backwards" }

[[part]]
name = "cart"
unit = "mm"
from = 0
to = 30
moves = [{ while = "KM1", speed = 7 }, { while = "KM2", speed = -3 }]

[[part]]
name = "times"
from = 0
to = 9
notch = "SQ1"

[[latch]]
name = "been"
set = "SQ1"
reset = "SB1"

[[fault]]
id = "far"
when = "KM1 & cart >= 29"
lasts = 100
says = { zh = "太远了", en = "too far" }

[[program]]
role = "reference"
family = "s7-200"
title = { zh = "程序", en = "program" }
text = "LD I0.0; = Q0.0"

[[draw]]
kind = "button"
for = "SB1"
x = 20
y = 60
"""


def small() -> Model:
    return Model(plants.parse(SMALL, "small"))


FORWARDS, BACKWARDS = {"Q0.0": 1}, {"Q0.1": 1}


def test_a_part_goes_by_its_speed_and_stops_at_its_end() -> None:
    model = small()
    model.step(FORWARDS, 1_000)
    assert model.position("cart") == 7
    model.step(BACKWARDS, 1_000)
    assert model.position("cart") == 4
    model.step({}, 5_000)
    assert model.position("cart") == 4
    model.step(FORWARDS, 60_000)
    assert model.position("cart") == 30


def test_a_limit_switch_comes_on_because_the_cart_has_arrived() -> None:
    """10 mm at 7 mm/s take 1428.57 ms; 20 mm are passed after 2857.14 ms."""
    model = small()
    model.step(FORWARDS, 1_428)
    assert model.sense() == {"I0.0": 0, "I0.1": 0}
    model.step(FORWARDS, 1)
    assert model.sense() == {"I0.0": 0, "I0.1": 1}
    model.step(FORWARDS, 1_428)
    assert model.sense()["I0.1"] == 1
    model.step(FORWARDS, 1)
    assert model.sense()["I0.1"] == 0


def test_a_one_way_switch_says_nothing_on_the_way_back() -> None:
    model = small()
    model.way("SQ1", "up")
    model.step(FORWARDS, 2_000)
    assert model.sense()["I0.1"] == 1
    model.step(FORWARDS, 2_000)
    model.step(BACKWARDS, 4_000)
    assert 10 < model.position("cart") < 20
    assert model.sense()["I0.1"] == 0
    model.way("SQ1", "down")
    assert model.sense()["I0.1"] == 1
    model.way("SQ1", "both")
    assert model.sense()["I0.1"] == 1


def test_a_normally_closed_button_gives_1_at_rest() -> None:
    model = small()
    model.wire("SB1", "NC")
    assert model.sense()["I0.0"] == 1
    model.press("SB1", 1)
    assert model.sense()["I0.0"] == 0
    model.reset()
    assert model.sense()["I0.0"] == 1
    model.wire("SB1", "NO")
    assert model.sense()["I0.0"] == 0


def test_a_latch_stays_a_wheel_counts_and_a_fault_is_reported_once_with_its_moment() -> None:
    """29 mm at 7 mm/s: reached at 4143 ms; 100 ms later the fault."""
    model = small()
    model.step(FORWARDS, 10_000)
    assert model.bits["been"]
    assert model.position("times") == 1
    assert [(one.id, one.ms, one.says.en) for one in model.faults] == [("far", 4_243, "too far")]
    model.step({}, 10)
    model.step(FORWARDS, 10_000)
    assert len(model.faults) == 1
    model.press("SB1")
    model.step(FORWARDS, 2)
    assert not model.bits["been"]
    model.reset()
    assert model.faults == ()
    assert model.position("cart") == model.ms == 0


def test_a_fault_that_lasts_must_not_be_broken_off() -> None:
    model = small()
    model.step(FORWARDS, 4_150)
    for _ in range(20):
        model.step(FORWARDS, 60)
        model.step({}, 1)
    assert not model.faults


def test_a_moment_can_be_taken_back() -> None:
    model = small()
    model.step(FORWARDS, 3_000)
    kept = model.moment()
    before = (model.sense(), model.position("cart"), model.ms)
    model.step(FORWARDS, 9_000)
    assert model.faults
    model.back_to(kept)
    assert (model.sense(), model.position("cart"), model.ms) == before
    assert not model.faults
    model.step(FORWARDS, 500)
    assert kept.ms == 3_000


def test_what_no_hand_can_do_is_refused_in_words() -> None:
    model = small()
    with pytest.raises(PlcTeachError, match="no hand"):
        model.press("SQ1", 1)
    with pytest.raises(UnknownNameError, match="SB1"):
        model.press("SB11", 1)
    for refused in (
        lambda: model.wire("KM1", "NC"),
        lambda: model.wire("SB1", "nc"),
        lambda: model.way("SB1", "up"),
        lambda: model.way("SQ1", "left"),
        lambda: model.step({}, -1),
        lambda: model.step({}, 0.5),
    ):
        with pytest.raises(PlcTeachError):
            refused()


# However the time is cut.


def plays(plant):
    outputs = st.fixed_dictionaries({one.address: st.integers(0, 1) for one in plant.outputs})
    hands = st.sampled_from([one.symbol for one in plant.hands])
    return st.lists(st.tuples(outputs, hands, st.booleans(), st.integers(1, 700)), min_size=1, max_size=12)


@pytest.mark.no_cover
@pytest.mark.parametrize("plant", ALL, ids=lambda plant: plant.id)
@settings(max_examples=20, deadline=None)
@given(data=st.data())
def test_the_motion_is_the_same_however_the_time_is_cut(plant, data) -> None:
    whole, single, mixed = Model(plant), Model(plant), Model(plant)
    for outputs, symbol, down, ms in data.draw(plays(plant)):
        for model in (whole, single, mixed):
            model.press(symbol, down)
        whole.step(outputs, ms)
        for _ in range(ms):
            single.step(outputs, 1)
        cut = data.draw(st.integers(0, ms))
        mixed.step(outputs, cut)
        mixed.step(outputs, ms - cut)
        for model in (single, mixed):
            assert (model.ms, model.spots, model.bits, model.sense()) == (
                whole.ms,
                whole.spots,
                whole.bits,
                whole.sense(),
            )
            assert [(one.id, one.ms) for one in model.faults] == [(one.id, one.ms) for one in whole.faults]


@pytest.mark.parametrize("plant", ALL, ids=lambda plant: plant.id)
def test_a_step_of_10_ms_takes_well_under_a_fifth_of_a_millisecond(plant) -> None:
    """The best of several stretches, with everything that can move on: another program on the machine is nobody's fault."""
    model = Model(plant)
    outputs = {one.address: 1 for one in plant.outputs}
    best = 1.0
    for _ in range(8):
        start = time.process_time()
        for _ in range(150):
            model.step(outputs, 10)
            model.sense()
        best = min(best, (time.process_time() - start) / 150)
    assert best < 0.0002


# Workpieces.


def test_cars_wait_at_the_line_and_behind_each_other() -> None:
    model = Model(plants.plant("traffic-light"))
    model.step({}, 30_000)
    cars = [one / 1_000_000 for one in model.spots["car"]]
    assert cars[:4] == [40, 31, 22, 13]
    model.step({"Q0.2": 1}, 1_000)
    assert [one / 1_000_000 for one in model.spots["car"]][:4] == [52, 43, 34, 25]


def test_a_part_enters_with_every_turn_of_the_belt_and_leaves_at_its_end() -> None:
    model = Model(plants.plant("reject-conveyor"))
    model.step({"%Q0.0": 1}, 3_000)
    placed = {name: [round(one / 1_000_000) for one in model.spots[name]] for name in ("good", "waste")}
    assert placed == {"good": [250, 150], "waste": [50]}
    model.press("W", 1)
    model.step({"%Q0.0": 1}, 1_000)
    assert len(model.spots["waste"]) == 2
    model.press("W", 0)
    model.step({"%Q0.0": 1}, 20_000)
    assert 7 <= sum(len(model.spots[name]) for name in ("good", "waste")) <= 8


# Declarations.


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("symbol = ", "sybmol = ", "io 1.*sybmol"),
        ('on = "cart = 10..20"', 'on = "car = 10..20"', "no part 'car' .did you mean cart"),
        ('on = "cart = 10..20"', 'on = "cart = 20..10"', "io 2 SQ1.*ends before it begins"),
        ('on = "cart = 10..20"', "", "io 2 SQ1.*on"),
        ('when = "KM1 & cart >= 29"', 'when = "KM7 & cart >= 29"', "no device or latch 'KM7'"),
        ('when = "KM1 & cart >= 29"', 'when = "rise(KM1)"', "fault 1 far.*only symbols"),
        ('when = "KM1 & cart >= 29"', 'when = "KM1 &"', "fault 1 far"),
        ('when = "KM1 & cart >= 29"', 'when = "__import__(1)"', "fault 1 far"),
        ("speed = 7", "speed = 0.0001", "part 1 cart.*three decimals"),
        ("speed = 7", 'speed = "fast"', "part 1 cart"),
        ("from = 0\nto = 30", "from = 30\nto = 0", "part 1 cart"),
        ('at = "Q0.1"', 'at = "Q0.0"', "the address 'Q0.0' stands there twice"),
        ('symbol = "KM2"', 'symbol = "KM1"', "the name 'KM1' stands there twice"),
        ('kind = "contactor"', 'kind = "contacter"', "io 3 KM1.*contactor"),
        ('role = "reference"', 'role = "wrong"', "program 1 wrong.*fault"),
        ('role = "reference"', 'role = "wrong"\nfault = "far"', "reference"),
        ('[[100, "SB1", 1]]', '[[1000, "SB1", 1]]', "cycle.*outside"),
        ('[[100, "SB1", 1]]', '[[100, "SQ1", 1]]', "no hand can press SQ1"),
        ('kind = "button"', 'kind = "knob"', "draw 1 SB1.*knob|draw 1.*knob"),
        ('for = "SB1"', 'for = "SB1"\nwidth = 3', "draw 1.*width"),
        ('for = "SB1"', 'for = "SB1"\nmoves = { cat = [1, 0] }', "no part 'cat'"),
        ('kind = "push-button"', 'kind = "push-button"\nway = "up"', "SB1 can act one way only"),
        ("[[fault]]", "[[fault", ""),
        ('en = "A carriage"', 'fr = "Un chariot"', "title.*fr"),
    ],
)
def test_a_declaration_that_does_not_fit_is_refused_and_names_itself(old: str, new: str, said: str) -> None:
    assert old in SMALL
    with pytest.raises(DeclarationError, match=f"plant small.*({said})"):
        plants.parse(SMALL.replace(old, new, 1), "small")


def test_conditions_read_as_they_are_written() -> None:
    class View:
        bits = {"A": True, "B": False}  # noqa: RUF012
        spots = {"head": [40_000_000], "box": [1_000_000, 9_000_000]}  # noqa: RUF012

    for text, wanted in {
        "A": True,
        "A & B": False,
        "A & !B": True,
        "B | A & !B": True,
        "A ^ A": False,
        "!(A & B)": True,
        "head >= 40": True,
        "head > 40": False,
        "head < 40.5 & head <= 40": True,
        "head < 40": False,
        "head = 40": True,
        "head = 39.5..40": True,
        "head = -1..39.999999": False,
        "box = 8..10": True,
        "box = 2..8": False,
        "!box >= 9 | A": True,
        "": True,
    }.items():
        assert read_condition(text).test(View()) is wanted, text
    assert micro("0.000001") == 1
    with pytest.raises(DeclarationError):
        micro("0.0000001")
