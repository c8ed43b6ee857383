"""The before-and-after figures, cell for cell as the books print them, and one for every instruction there is."""

from __future__ import annotations

from itertools import product

import pytest

from plcteach.core.errors import UnknownNameError
from plcteach.core.text import Text
from plcteach.dialects import dialect, names
from plcteach.figure.ink import COLOURS, INKS
from plcteach.figure.scene import Box, Stroke, Words, extent
from plcteach.figure.stack import illustrate, illustration, strip
from plcteach.machine import run
from plcteach.stl import read

EVERY = [(name, row.mnemonic) for name in names() for row in dialect(name).insns]


def columns(family: str, words: str, number: int | None = None) -> tuple[str, str]:
    told = illustration(family, words, number)
    return " ".join(told.before[0]), " ".join(told.after[0])


# Figures 6 and 7 of 000_8c35a2fe1b5d9b9b.txt; figure 2-35 (a) to (c) of 002_0e43569a3a430994.txt by its sentences.
@pytest.mark.parametrize(
    ("words", "before", "after"),
    [
        ("OLD", "S1 S0 iv0 iv1 iv2 iv3 iv4 iv5 iv6", "S2 iv0 iv1 iv2 iv3 iv4 iv5 iv6 x"),
        ("ALD", "S1 S0 iv0 iv1 iv2 iv3 iv4 iv5 iv6", "S2 iv0 iv1 iv2 iv3 iv4 iv5 iv6 x"),
        ("LDS 3", "iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8", "iv3 iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7"),
        ("LDS 0", "iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8", "iv0 iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7"),
        ("LPS", "iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8", "iv0 iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7"),
        ("LRD", "iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8", "iv1 iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8"),
        ("LPP", "iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8", "iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8 x"),
        ("LD I0.0", "iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8", "I0.0 iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7"),
        ("AN I0.4", "iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8", "iv0·/I0.4 iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8"),
    ],
)
def test_the_books_figures_cell_for_cell(words, before, after):
    assert columns("s7-200", words) == (before, after)


@pytest.mark.parametrize(("words", "note"), [("OLD", "S2=S0+S1"), ("ALD", "S2=S0·S1")])
def test_the_books_name_the_new_value(words, note):
    assert illustration("s7-200", words).notes == (Text(note, note),)


def test_the_number_may_come_apart_from_the_mnemonic():
    assert columns("s7-200", "LDS", 3) == columns("s7-200", "LDS 3")
    assert columns("s7-200-smart", "LDS", 20)[1].startswith("iv20 iv0 iv1")
    assert len(columns("s7-200-smart", "LPS")[0].split()) == 32


# 000_8c35a2fe1b5d9b9b.txt: the text on MPS, MRD and MPP, and on ORB; the result register comes first here.
@pytest.mark.parametrize(
    ("words", "before", "after"),
    [
        ("LD", "iv0 iv1 iv2 iv3", "X0 iv0 iv1 iv2 iv3"),
        ("MPS", "iv0 iv1 iv2 iv3", "iv0 iv0 iv1 iv2 iv3"),
        ("MRD", "iv0 iv1 iv2 iv3 iv4", "iv1 iv1 iv2 iv3 iv4"),
        ("MPP", "iv0 iv1 iv2 iv3 iv4", "iv1 iv2 iv3 iv4"),
        ("ORB", "iv0 iv1 iv2 iv3 iv4", "iv1+iv0 iv2 iv3 iv4"),
    ],
)
def test_the_result_register_and_the_stack_below_it(words, before, after):
    assert columns("fx", words) == (before, after)


def test_two_stacks_exchange_cells():
    push, pop = illustration("gutta", "LPS"), illustration("gutta", "LPP")
    assert (push.before[1], push.after[1]) == (("iv4", "iv5"), ("iv0", "iv4", "iv5"))
    assert push.after[0] == push.before[0]
    assert pop.after[0][0] == pop.before[1][0]
    assert pop.after[1] == pop.before[1][1:]


def test_a_parenthesis_saves_the_accumulator_and_brings_it_back():
    opens, closes = illustration("neza", "AND("), illustration("neza", ")")
    assert (opens.before[0], opens.after[0]) == (("iv0",), ("%I0.0",))
    assert opens.after[1] == ("iv0", *opens.before[1])
    assert closes.after[0] == (f"{closes.before[1][0]}·iv0",)


def test_eleven_levels_below_the_result_register():
    scene = illustrate("fx", "ORB")
    words = [shape.text.zh for shape in scene.shapes if isinstance(shape, Words)]
    assert [f"第{level}层" for level in range(1, 12)] == [
        word for word in words if word.startswith("第") and "=" not in word
    ]
    register = next(shape.y for shape in scene.shapes if isinstance(shape, Words) and shape.text.zh == "运算结果寄存器")
    first, second = (
        next(s.y for s in scene.shapes if isinstance(s, Words) and s.text.en == f"level {n}") for n in (1, 2)
    )
    assert first - register > second - first  # drawn apart


def test_deep_stacks_are_shortened():
    for name, words in (("gutta", "OLD"), ("s7-200-smart", "LPP")):
        levels = [s for s in illustrate(name, words).shapes if isinstance(s, Words) and s.text.en.startswith("level")]
        assert len(levels) < 14
    shown = [s.text.zh for s in illustrate("s7-200-smart", "LDS 20").shapes if isinstance(s, Words)]
    assert {"第1层", "第21层", "第32层", "⋮"} <= set(shown)


@pytest.mark.parametrize(("name", "mnemonic"), EVERY)
def test_every_instruction_has_a_figure_in_which_nothing_overlaps(name, mnemonic):
    scene = illustrate(name, mnemonic)
    words = [shape for shape in scene.shapes if isinstance(shape, Words)]
    assert scene.title.zh
    assert scene.title.en
    assert "{" not in "".join(word.text.zh + word.text.en for word in words)
    for lang in ("zh", "en"):
        spaces = [space(word, lang) for word in words if word.text.in_(lang)]
        assert all(
            left >= 0 and right <= scene.width and top >= 0 and low <= scene.height for left, top, right, low in spaces
        )
        for number, one in enumerate(spaces):
            assert not any(meet(one, other) for other in spaces[:number])
        for stroke in (shape for shape in scene.shapes if isinstance(shape, Stroke)):
            assert not any(crosses(stroke, one) for one in spaces), (name, mnemonic, stroke)


def space(word: Words, lang: str) -> tuple[float, float, float, float]:
    width = extent(word.text.in_(lang), word.size, code=word.code)
    left = word.x - {"start": 0, "middle": width / 2, "end": width}[word.anchor]
    return left, word.y - word.size * 0.45, left + width, word.y + word.size * 0.45


def meet(one, other):
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def crosses(stroke: Stroke, space: tuple[float, float, float, float]) -> bool:
    return any(space[0] < x < space[2] and space[1] < y < space[3] for x, y in along(stroke))


def along(stroke: Stroke):
    for step in range(41):
        t = step / 40
        if stroke.curve:
            weights = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3)
            yield tuple(sum(w * p[axis] for w, p in zip(weights, stroke.points, strict=True)) for axis in (0, 1))
        else:
            for start, end in zip(stroke.points, stroke.points[1:], strict=False):
                yield tuple(start[axis] + t * (end[axis] - start[axis]) for axis in (0, 1))


def test_each_new_cell_has_an_accent_and_an_arrow():
    scene = illustrate("s7-200", "OLD")
    assert sum(isinstance(shape, Box) and shape.ink == "new" for shape in scene.shapes) == 1
    arrows = [shape for shape in scene.shapes if isinstance(shape, Stroke) and shape.arrow]
    assert [arrow.ink for arrow in arrows].count("accent") == 2  # S0 and S1 become S2
    assert [arrow.ink for arrow in arrows].count("line") == 7  # levels 3 to 9 move up
    assert [arrow.ink for arrow in arrows].count("lost") == 1  # x enters


@pytest.mark.parametrize(
    ("family", "words"), [("s7-200", "MPS"), ("fx", "LD I0.0"), ("s7-200", "LDS 9"), ("s7-200", "")]
)
def test_what_is_no_instruction_is_named(family, words):
    with pytest.raises(UnknownNameError):
        illustrate(family, words)


def test_a_line_of_a_program_keeps_its_own_reading():
    line = read("LD X0; OUT Y0; LD X1; OUT Y1", "fx").lines[2]
    told = illustration("fx", line)
    assert told.after[0] == ("X1",)  # a new circuit: nothing is pushed


def cells_of(scene, ink=None):
    return [
        s.text.zh
        for s in scene.shapes
        if isinstance(s, Words) and s.code and s.size == 12 and (not ink or s.ink == ink)
    ]


def test_a_strip_of_formulas_is_figure_5():
    program = read("LD X0; OR X2; LD X1; AND X4; LD X3; AND X5; ORB; ANB; OUT Y0", "fx")
    cells = cells_of(strip(program))
    after_six = cells[cells.index("X3·X5") :][:3]
    assert after_six == ["X3·X5", "X1·X4", "X0+X2"]  # result register, level 1, level 2: C, B, A
    assert "X1·X4+X3·X5" in cells


def test_a_strip_of_values_is_the_scan():
    program = read("LD I0.0; LD I0.1; OLD; = Q0.0", "s7-200")
    for a, b in product((0, 1), repeat=2):
        cells = cells_of(strip(run(program, [{"I0.0": a, "I0.1": b}]).scans[0]))
        joined = str(a or b)
        wanted = [str(a), "x", "x", str(b), str(a), "x", joined, "x", "x", joined, "x", "x"]
        assert cells == wanted  # two levels are used, and one more is drawn


def test_a_strip_wraps():
    program = read("; ".join(["LD I0.0"] + ["A I0.1"] * 9), "s7-200")
    wide, narrow = strip(program, columns=10), strip(program, columns=4)
    assert narrow.width < wide.width
    assert narrow.height > 2 * wide.height
    assert strip(read("", "fx")).shapes == ()


def light(colour):
    parts = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    red, green, blue = (part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


@pytest.mark.parametrize("theme", [0, 1])
def test_words_are_readable_on_every_ground(theme):
    grounds = [COLOURS[role][theme] for role in ("paper", "cell", "chip", "head", "wash")]
    inks = [COLOURS[role][theme] for role in ("text", "quiet", "accent", "lost", "good")]
    for ink, ground in product(inks, grounds):
        high, low = sorted((light(ink), light(ground)), reverse=True)
        assert (high + 0.05) / (low + 0.05) >= 4.5, (ink, ground)


def test_every_ink_names_colours_that_exist():
    assert all(role in COLOURS for ink in INKS.values() for role in (ink.fill, ink.stroke) if role)
