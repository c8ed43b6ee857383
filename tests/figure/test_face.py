"""What a block's figure shows: the values it was given, where they belong, in both languages and for every kind."""

from __future__ import annotations

import json
from itertools import pairwise

import pytest

from plcteach.core.text import Text, same
from plcteach.figure import mpl
from plcteach.figure.face import Face, Gauge, Grid, Pin, Slot, face_changes, lasting, step_slots, timed, window
from plcteach.figure.face_scene import face_scene, folded
from plcteach.figure.scene import Box, Disc, Stroke, Words, extent
from plcteach.figure.svg import svg

TIMER = Face("%TM0", "timer", Text("接通延时定时器", "on-delay timer"), (Pin("IN", "1"),), (Pin("Q", "0"),),
             timed(32, 50, 100, most=9_999))  # fmt: skip
FIGURE_4_30 = Grid(tuple(f"%Q0.{bit}" for bit in (1, 2, 3, 4, 5, 7)), ("110000", "011000", "100010", "010101"), 2)
DRUM = Face("%DR1", "drum", same("drum"), (Pin("R", "0"), Pin("U", "1")), (Pin("F", "0"),), grid=FIGURE_4_30)


def bits(word: str) -> tuple[Slot, ...]:
    return tuple(Slot(str(place), bit) for place, bit in enumerate(reversed(word)))


def shift(word: str, *more: Slot, before: tuple[Slot, ...] = (), way: str = "") -> Face:
    pins = (Pin("R", "0"), Pin("CU", "1"), Pin("CD"))
    return Face("%SBR0", "shift", same("shift register"), pins, slots=(*before, *bits(word), *more), way=way)


def queue(words: list[str], way: str, mark: str = "") -> Face:
    slots = tuple(
        Slot(str(at), words[at] if at < len(words) else "", mark if at == len(words) - 1 else "") for at in range(16)
    )
    inputs = (Pin("R", "0"), Pin("I", "0"), Pin("O", "0"), Pin(".I", "45"))
    outputs = (Pin("E", "0"), Pin("F", "0"), Pin(".O", "20"))
    return Face("%R0", "queue", same("register"), inputs, outputs, slots=slots, way=way)


STEPS = Face("%SC1", "steps", same("step counter"), (Pin("R", "0"), Pin("CU", "1"), Pin("CD")), slots=step_slots(17))
ALL = {
    "timer": TIMER,
    "unknown": Face("T37", "timer", same("timer"), (Pin("IN", "x"),), (Pin("T37", "x"),), timed(None, None, 100)),
    "ctud": Face("C48", "counter", same("counter"), (Pin("CU", "0"),), (Pin("C48", "0"),), Gauge(-3, 4, least=-32_768)),
    "drum": DRUM,
    "shift": shift("0000000000000101"),
    "shifted": shift("0000000000001010", Slot("", "1", "gone")),
    "steps": STEPS,
    "fifo": queue(["80", "50", "-7"], "fifo", "new"),
    "lifo": queue(["80", "50", "-7"], "lifo", "pointer"),
    "full": queue([str(word) for word in range(16)], "fifo"),
    "empty": queue([], "lifo"),
}


def words(face: Face, lang: str = "en") -> list[str]:
    return [shape.text.in_(lang) for shape in face_scene(face).shapes if isinstance(shape, Words)]


def place(face: Face, text: str) -> Words:
    found = [shape for shape in face_scene(face).shapes if isinstance(shape, Words) and shape.text.en == text]
    assert len(found) == 1, text
    return found[0]


def boxes(face: Face, ink: str) -> list[Box]:
    return [shape for shape in face_scene(face).shapes if isinstance(shape, Box) and shape.ink == ink]


@pytest.mark.parametrize("lang", ["zh", "en"])
@pytest.mark.parametrize("face", ALL.values(), ids=ALL)
def test_every_kind_stays_within_its_paper(face, lang):
    scene = face_scene(face)
    for shape in scene.shapes:
        if isinstance(shape, Words):
            text = shape.text.in_(lang)
            room = extent(text, shape.size, code=shape.code) * 0.9  # `extent` is a little generous
            left = shape.x - {"start": 0, "middle": room / 2, "end": room}[shape.anchor]
            assert left >= -1, text
            assert left + room <= scene.width + 1, text
            assert 0 < shape.y < scene.height
        elif isinstance(shape, Box):
            assert 0 <= shape.x <= shape.x + shape.width <= scene.width
            assert 0 <= shape.y <= shape.y + shape.height <= scene.height
    assert len(scene.shapes) < 400
    assert svg(scene, lang).count("<text") == len([word for word in words(face, lang) if word])


@pytest.mark.parametrize("face", ALL.values(), ids=ALL)
def test_every_kind_is_drawn_on_paper_and_told_in_words(face, tmp_path):
    assert mpl.save(face_scene(face), tmp_path / "face.png", "zh").stat().st_size > 1_000
    for pin in (*face.inputs, *face.outputs):
        assert f"{pin.name}={pin.value}" in face.words.en or not pin.value
    assert face.address in face.words.zh


def test_a_timer_shows_current_against_preset_on_a_scale_in_counts_and_in_seconds():
    shown = words(TIMER)
    for text in ("%TM0", "on-delay timer", "IN", "Q", "current 32", "preset 50", "×100 ms", "3.2 s of 5 s", "0", "50"):
        assert text in shown
    (bar,) = boxes(TIMER, "new")
    (whole,) = [box for box in boxes(TIMER, "cell") if box.height == bar.height]
    mark = place(TIMER, "50")
    assert bar.x == whole.x
    # 32 of 50 counts: the bar must end at 64 % of the way to the preset's mark
    assert bar.width / (mark.x - whole.x) == pytest.approx(32 / 50, abs=0.01)


def test_a_value_beyond_the_scale_fills_the_bar_and_says_so():
    gauge = timed(812, 300, 100)
    assert gauge.beyond
    assert gauge.bar == (0.0, 1.0)
    assert gauge.time.en == "81.2 s of 30 s"
    assert not timed(300, 300, 100).beyond
    assert Gauge(9_999, 9_999, most=9_999).mark == 1.0


def test_a_counter_below_zero_grows_to_the_left_of_zero():
    gauge = Gauge(-3, 4, least=-32_768)
    first, last = gauge.bar
    assert last == 0.5
    assert first < 0.5
    assert (0.5 - first) / (gauge.mark - 0.5) == pytest.approx(3 / 4)


def test_what_nobody_knows_is_hatched_and_called_x():
    face = ALL["unknown"]
    assert "current x" in words(face)
    assert "x of x" in words(face)
    assert "当前值x" in face.words.zh
    assert not boxes(face, "new")
    assert "value" not in face.as_dict()["gauge"]


@pytest.mark.parametrize(
    ("ms", "told"),
    [(0, "0 s"), (10, "10 ms"), (1_000, "1 s"), (3_200, "3.2 s"), (60_000, "1 min"), (90_000, "90 s"),
     (599_940_000, "9999 min"), (725_000, "12 min 5 s"), (None, "x")],
)  # fmt: skip
def test_times_are_told_briefly(ms, told):
    assert lasting(ms) == told


def test_a_pin_that_carries_1_has_a_live_wire_and_one_not_connected_a_faint_one():
    wires = [shape.ink for shape in face_scene(shift("1")).shapes if isinstance(shape, Stroke) and not shape.arrow]
    assert [wires.count(ink) for ink in ("wire", "wire-on", "slot")] == [1, 1, 1]


def test_a_drum_has_a_peg_for_each_control_bit_and_marks_the_active_step():
    discs = [shape for shape in face_scene(DRUM).shapes if isinstance(shape, Disc)]
    assert len(discs) == sum(row.count("1") for row in FIGURE_4_30.rows) == 9
    (row,) = boxes(DRUM, "outline")
    active = [disc for disc in discs if row.y < disc.y < row.y + row.height]
    heads = {place(DRUM, name).x: name for name in FIGURE_4_30.columns}
    assert [heads[disc.x] for disc in active] == ["%Q0.1", "%Q0.5"]  # step 2 of figure 4-30
    assert {disc.ink for disc in active} == {"peg"}
    assert place(DRUM, "2").bold
    assert "step 2, on: %Q0.1, %Q0.5" in DRUM.words.en


def test_a_shift_register_is_written_with_its_highest_bit_on_the_left():
    face = shift("1000000000000001")
    labels = sorted((shape for shape in face_scene(face).shapes if isinstance(shape, Words) and shape.text.en.isdigit()
                     and shape.size < 11), key=lambda shape: shape.x)  # fmt: skip
    assert [label.text.en for label in labels] == [str(bit) for bit in range(15, -1, -1)]
    assert "1000000000000001" in face.words.en


def test_the_bit_that_is_lost_stands_outside_at_the_end_where_it_fell_out():
    row = boxes(shift("0000", Slot("", "1", "gone")), "cell")[1:]
    (up,) = boxes(shift("0000", Slot("", "1", "gone")), "gone")
    (down,) = boxes(shift("0000", before=(Slot("", "1", "gone"),)), "gone")
    assert up.x + up.width < min(box.x for box in row)
    assert down.x > max(box.x + box.width for box in row)


def test_a_step_counter_shows_a_window_around_its_one_active_step():
    shown = window(STEPS)
    assert [slot.label for slot in shown] == ["…", *(str(step) for step in range(13, 22)), "…"]
    assert [slot.value for slot in shown].count("1") == 1
    assert len(boxes(STEPS, "new")) == 1
    ends = [window(Face("%SC0", "steps", same(""), slots=step_slots(active))) for active in (0, 255)]
    assert (ends[0][0].label, ends[1][-1].label) == ("0", "255")
    assert "step 17" in STEPS.words.en


def test_a_fifo_takes_from_the_bottom_and_a_lifo_from_the_top():
    for way, word in (("fifo", "80"), ("lifo", "-7")):
        face = queue(["80", "50", "-7"], way)
        assert place(face, ".O 20").y == place(face, word).y  # figures 4-42 and 4-43
        assert place(face, "-7").y < place(face, "50").y < place(face, "80").y  # newest on top
        assert place(face, ".I 45").y < place(face, "-7").y
    assert place(ALL["lifo"], "pointer").y == place(ALL["lifo"], "-7").y
    assert "pointer" not in words(ALL["fifo"])


def test_the_long_empty_part_of_a_pile_is_left_out_but_its_last_place_is_not():
    low, full = face_scene(ALL["fifo"]), face_scene(ALL["full"])
    assert low.height < full.height - 150
    assert "15" in words(ALL["fifo"])
    assert "⋮" in words(ALL["fifo"])
    assert "⋮" not in words(ALL["full"])


def test_a_long_note_is_folded_in_each_language_at_its_own_places():
    text = Text("很长的说明文字" * 9, "a rather long note " * 9)
    lines = folded(text, 200, 12)
    assert "".join(line.zh for line in lines) == text.zh
    assert " ".join(line.en for line in lines if line.en) == text.en.strip()
    assert all(extent(line.in_(lang), 12) <= 200 for line in lines for lang in ("zh", "en"))


@pytest.mark.parametrize("face", ALL.values(), ids=ALL)
def test_the_browser_gets_plain_data_without_empty_keys(face):
    data = face.as_dict()
    assert json.loads(json.dumps(data)) == data
    assert None not in data.values()
    assert data["address"] == face.address
    assert not {"", None} & {data.get("way", "-"), data.get("note", "-")}
    assert len(data.get("slots", [])) <= 17


def test_changes_put_onto_the_face_before_give_the_face_after():
    faces = [shift("0001"), shift("0010", Slot("", "0", "gone")), shift("0010"), shift("0010", way="left")]
    for before, after in pairwise([one.as_dict() for one in (*faces, *faces[::-1])]):
        changes = face_changes(before, after)
        put = {name: value for name, value in (before | changes).items() if value is not None}
        assert put == after
    assert face_changes(faces[0].as_dict(), faces[0].as_dict()) == {}
    assert face_changes({"way": "left"}, {}) == {"way": None}
