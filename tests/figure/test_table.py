"""Worksheets: an empty table, a key that agrees with Boolean arithmetic, and inputs that tell instructions apart."""

from __future__ import annotations

from itertools import product

from plcteach.core.text import Text
from plcteach.figure.scene import Scene, Words
from plcteach.figure.table import A4, sheet, telling_inputs
from plcteach.machine import run
from plcteach.stl import read

PROGRAM = "LD I0.0; A I0.1; LD I0.2; AN I0.3; OLD; = Q0.0"


def rows(page: Scene) -> list[list[str]]:
    """Give the rows of a page's table as its words, left to right."""
    found: dict[float, list[Words]] = {}
    for shape in page.shapes:
        if isinstance(shape, Words) and shape.code and shape.y > 230:
            found.setdefault(shape.y, []).append(shape)
    return [
        [word.text.en for word in sorted(row, key=lambda word: word.x) if word.text.en]
        for _, row in sorted(found.items())
    ]


def test_the_empty_sheet_has_the_lines_and_nothing_else():
    (page,) = sheet(read(PROGRAM, "s7-200"), key=False)
    assert (page.width, page.height) == A4
    assert rows(page) == [["LD I0.0"], ["A I0.1"], ["LD I0.2"], ["AN I0.3"], ["OLD"], ["= Q0.0"]]
    words = [shape.text for shape in page.shapes if isinstance(shape, Words)]
    assert Text("姓名", "Name") in words
    assert Text("第3层", "level 3") in words  # two levels are used, one more is drawn
    assert Text("第4层", "level 4") not in words


def test_the_key_is_boolean_arithmetic():
    program = read(PROGRAM, "s7-200")
    for a, b, c, d in product((0, 1), repeat=4):
        given = {"I0.0": a, "I0.1": b, "I0.2": c, "I0.3": d}
        (page,) = sheet(program, key=True, inputs=given)
        first, second = a & b, c & (1 - d)
        result = str(first | second)
        assert rows(page) == [
            ["LD I0.0", str(a), "x", "x"],
            ["A I0.1", str(first), "x", "x"],
            ["LD I0.2", str(c), str(first), "x"],
            ["AN I0.3", str(second), str(first), "x"],
            ["OLD", result, "x", "x"],
            ["= Q0.0", result, "x", "x", f"Q0.0={result}"],
        ]


def test_all_stacks_of_a_family_have_columns():
    program = read("LD %I0.0; AND( %I0.1; OR %I0.2; ); MPS; AND %I0.3; ST %Q0.0; MPP; STN %Q0.1", "neza")
    (page,) = sheet(program, key=True, inputs={"%I0.0": 1, "%I0.1": 0, "%I0.2": 1, "%I0.3": 0})
    words = "".join(shape.text.zh for shape in page.shapes if isinstance(shape, Words))
    assert "布尔累加器" in words
    assert "括号栈" in words
    assert "分支栈" in words
    assert rows(page)[1] == ["AND( %I0.1", "0", "1", "–", "–", "–"]
    assert rows(page)[-1] == ["STN %Q0.1", "1", "–", "–", "–", "–", "%Q0.1=0"]


def test_long_programs_take_several_pages():
    program = read("LD I0.0\n" + "A I0.1\n" * 40 + "= Q0.0", "s7-200")
    pages = sheet(program, key=False, rows_per_page=20)
    assert [len(rows(page)) for page in pages] == [20, 20, 2]
    assert sum(len(rows(page)) for page in sheet(program, key=False)) == 42
    many = read("\n".join(["LD I0.0"] + [f"A I{n // 8}.{n % 8}" for n in range(1, 70)]), "s7-200")
    for page in sheet(many, key=True, rows_per_page=99):
        foot = next(shape.y for shape in page.shapes if isinstance(shape, Words) and shape.text.en.startswith("page"))
        assert all(shape.y <= foot for shape in page.shapes if isinstance(shape, Words))
    assert all(shape.y < A4[1] for page in pages for shape in page.shapes if isinstance(shape, Words))


def test_an_empty_program_gives_an_empty_table():
    (page,) = sheet(read("", "fx"), key=True)
    assert rows(page) == []


def test_lines_after_the_end_stay_empty():
    (page,) = sheet(read("LD X0; OUT Y0; END; LD X1; OUT Y1", "fx"), key=True, inputs={"X0": 1})
    assert rows(page)[-1] == ["OUT Y1"]


CONFUSIONS = (("A I0.1", "O I0.1"), ("A I0.1", "AN I0.1"), ("AN I0.3", "A I0.3"), ("AN I0.3", "ON I0.3"))


def seen(right: str, wrong: str, given: dict[str, int]) -> bool:
    """Say whether a table filled in for one program shows that another was meant."""
    programs = (read(PROGRAM, "s7-200"), read(PROGRAM.replace(right, wrong), "s7-200"))
    stacks = [[step.after for step in run(program, [given]).scans[0].steps] for program in programs]
    return stacks[0] != stacks[1]


def test_the_chosen_inputs_show_the_most_confusions_that_one_case_can():
    chosen = telling_inputs(read(PROGRAM, "s7-200"))
    assert seen("OLD", "ALD", chosen)
    shown = {
        bits: sum(seen(right, wrong, dict(zip(chosen, bits, strict=True))) for right, wrong in CONFUSIONS)
        for bits in product((0, 1), repeat=4)
        if seen("OLD", "ALD", dict(zip(chosen, bits, strict=True)))
    }
    assert shown[tuple(chosen.values())] == max(shown.values())
    assert telling_inputs(read(PROGRAM, "s7-200")) == chosen


def test_many_inputs_do_not_take_for_ever():
    text = "LD I0.0; " + "; ".join(f"A I{n // 8}.{n % 8}" for n in range(1, 40)) + "; = Q0.0"
    assert len(telling_inputs(read(text, "s7-200"))) == 40


def test_inputs_are_chosen_though_some_of_the_cases_jump_back():
    looping = "LBL 1; LD I0.0; A I0.1; = M0.0; LD SM0.0; INCW VW0; LDW< VW0, 5; A I0.2; JMP 1; LD M0.0; = Q0.0"
    assert telling_inputs(read(looping, "s7-200")).keys() == {"I0.0", "I0.1", "I0.2"}
    assert sheet(read(looping, "s7-200"), key=True)
