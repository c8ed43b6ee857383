"""The film: every cell keeps its key as long as it is the same cell, and every coming and going is told."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.text import Text
from plcteach.figure.film import MOST_STEPS, Film, film
from plcteach.figure.verbs import film_of
from plcteach.machine import run
from plcteach.stl import read

sys.path.insert(0, str(Path(__file__).parents[1] / "machine"))
from random_lists import MENU, SCANS, inputs, lists

KEY, STACK, PLACE, VALUE, FORMULA, NAME, FLAGS = range(7)


def shot(text: str, dialect: str = "s7-200", **bits: int) -> dict:
    return film_of(
        read(text.replace(" / ", "\n"), dialect), inputs={k.replace("_", "."): v for k, v in bits.items()}
    ).data


def keys(step: dict, stack: int = 0) -> list[str]:
    return [cell[KEY] for cell in step["cells"] if cell[STACK] == stack]


def test_a_join_merges_two_cells_into_a_new_one_and_x_enters_at_the_bottom() -> None:
    steps = shot("LD I0.0 / LD I0.1 / OLD / = Q0.0", I0_0=1)["steps"]
    before, after = keys(steps[2]), keys(steps[3])
    assert steps[3]["from"] == {after[0]: [before[0], before[1]]}
    assert after[1:8] == before[2:]
    assert steps[3]["enter"] == {after[8]: "bottom"}
    assert steps[3]["leave"] == {before[0]: "merge", before[1]: "merge"}
    assert [cell[VALUE] for cell in steps[3]["cells"]] == ["1", *["x"] * 8]
    assert keys(steps[4]) == after


def test_a_load_comes_from_the_operand_and_the_bottom_falls_out() -> None:
    steps = shot("LD I0.0 / LD I0.1", I0_1=1)["steps"]
    assert steps[2]["enter"] == {keys(steps[2])[0]: "load"}
    assert keys(steps[2])[1:] == keys(steps[1])[:8]
    assert steps[2]["leave"] == {keys(steps[1])[8]: "bottom"}
    assert steps[2]["read"] == [["I0.1", "1"]]


def test_a_push_copies_the_top_a_read_replaces_it_and_a_pop_uncovers_what_was_saved() -> None:
    steps = shot("LD I0.0 / LPS / A I0.1 / LRD / LPP", I0_0=1)["steps"]
    loaded, pushed, anded, read_, popped = (keys(step) for step in steps[1:6])
    assert pushed[0] == loaded[0]
    assert steps[2]["from"] == {pushed[1]: [loaded[0]]}
    assert steps[2]["leave"] == {loaded[8]: "bottom"}
    assert anded == pushed
    assert steps[3]["changed"] == [pushed[0]]
    assert steps[4]["from"] == {read_[0]: [pushed[1]]}
    assert steps[4]["leave"] == {anded[0]: "top"}
    assert read_[1:] == anded[1:]
    assert popped[:8] == read_[1:]
    assert steps[5]["leave"] == {read_[0]: "top"}
    assert steps[5]["enter"] == {popped[8]: "bottom"}


def test_what_another_network_left_is_foreign_there() -> None:
    steps = shot("Network 1 / LD I0.0 / = Q0.0 / Network 2 / LD I0.1 / = Q0.1", I0_0=1)["steps"]
    (mine,) = [cell for cell in steps[2]["cells"] if cell[PLACE] == 0]
    assert "f" not in mine[FLAGS]
    foreign = [cell for cell in steps[3]["cells"] if "f" in cell[FLAGS]]
    assert [(cell[KEY], cell[PLACE]) for cell in foreign] == [(mine[KEY], 1)]
    assert {cell[FLAGS] for cell in steps[3]["cells"] if cell[PLACE] > 1} == {"u"}


def test_guttas_stacks_are_swept_between_networks() -> None:
    steps = shot("Network 1 / LD I0.0 / LPS / = Q0.0 / Network 2 / LD I0.1 / = Q0.1", "gutta")["steps"]
    gone = keys(steps[3]) + keys(steps[3], 1)
    assert len(gone) == 2
    assert steps[4]["leave"] == dict.fromkeys(gone, "top")


def test_a_used_cell_is_marked_as_spent_and_an_fx_cell_bears_its_letter() -> None:
    steps = shot("LD X0 / LD X1 / ORB / OUT Y0", "fx")["steps"]
    assert [cell[FLAGS] for cell in steps[2]["cells"]] == ["", "L"]
    assert [cell[FLAGS] for cell in steps[4]["cells"]] == ["s"]
    branch = shot("LD X0 / MPS / OUT Y0 / MPP / OUT Y1", "fx")["steps"]
    assert [cell[FLAGS] for cell in branch[2]["cells"]] == ["", "B"]


def test_the_books_names_stand_beside_the_cells() -> None:
    data = shot("LD I0.0 / LD I0.1 / OLD", I0_0=1)
    named = [data["texts"][cell[NAME]] if cell[NAME] >= 0 else "" for cell in data["steps"][3]["cells"]]
    assert named == ["S2", "iv0", "iv1", "iv2", "iv3", "iv4", "iv5", "iv6", "x"]
    pushed = [data["texts"][cell[NAME]] for cell in data["steps"][2]["cells"]]
    assert pushed == ["I0.1", "iv0", "iv1", "iv2", "iv3", "iv4", "iv5", "iv6", "iv7"]
    top = data["steps"][3]["cells"][0]
    assert data["texts"][top[FORMULA]] == "I0.0+I0.1"


def test_warnings_stand_at_their_step() -> None:
    steps = film(run(read("LD I0.0\nLPP\n= Q0.0\n", "s7-200")).scans).data["steps"]
    assert "Q0.0" in steps[3]["warn"]["en"]
    assert "warn" not in steps[1]
    loads = "\n".join(f"LD I{number // 8}.{number % 8}" for number in range(10))
    full = film(run(read(loads, "s7-200")).scans).data["steps"]
    assert "warn" not in full[9]
    assert "lost" in full[10]["warn"]["en"]


def test_several_scans_follow_each_other_with_their_own_inputs() -> None:
    data = film_of("LD I0.0; EU; = Q0.0", "s7-200", [{"I0.0": 0}, {"I0.0": 1}]).data
    assert [(step["scan"], step["line"]) for step in data["steps"]] == [
        (scan, line) for scan in (0, 1) for line in (-1, 0, 1, 2)
    ]
    assert data["steps"][0]["read"] == [["I0.0", "0"]]
    assert data["steps"][4]["read"] == [["I0.0", "1"]]
    assert data["steps"][7]["write"] == [["Q0.0", "1"]]
    assert set(data["steps"][4]["leave"]) == set(keys(data["steps"][3]))
    assert not set(keys(data["steps"][4])) & set(keys(data["steps"][3]))


def test_lines_and_networks_are_told_with_their_rows() -> None:
    data = shot("Network 1 // start / LD I0.0 // button / = Q0.0 / Network 2 / LD I0.1 / = Q0.1")
    assert data["lines"][0] == {"text": "LD I0.0", "comment": "button", "row": 2, "network": 0, "number": 1}
    beside_an_editor = film(run(read("Network 1\nLD I0.0\n= Q0.0", "s7-200")).scans, rows=True).data["lines"]
    assert [(one["row"], one.get("number")) for one in beside_an_editor] == [(2, None), (3, None)]
    assert [(one["title"], one["first"]) for one in data["networks"]] == [("Network 1: start", 0), ("Network 2", 2)]
    one_row = film_of("LD I0.0; = Q0.0", "s7-200").data["lines"]
    assert [line["number"] for line in one_row] == [1, 2]


def test_the_columns_know_their_stacks() -> None:
    fx = shot("LD X0 / OUT Y0", "fx")["columns"]
    assert [(one["id"], one["depth"], one["fixed"], one["register"]["en"]) for one in fx] == [
        ("main", 12, False, "result register")
    ]
    assert [(one["id"], one["drawn"]) for one in shot("LD I0.0 / = Q0.0")["columns"]] == [("main", 9)]
    assert [one["id"] for one in shot("LD %I0.0 / ST %Q0.0", "neza")["columns"]] == ["main", "paren", "branch"]


def test_a_long_film_is_cut_and_says_so() -> None:
    long = film_of("LD I0.0; = Q0.0", "s7-200", [{}] * MOST_STEPS)
    assert long.length <= MOST_STEPS
    assert "the beginning only" in long.data["title"]["en"]
    assert "只放开头部分" in long.data["title"]["zh"]
    assert "beginning" not in film_of("LD I0.0; = Q0.0", "s7-200", [{}] * 10).data["title"]["en"]


def test_a_film_says_what_it_is() -> None:
    one = film(run(read("LD I0.0\n= Q0.0", "s7-200")).scans, Text("标题", "a title"))
    assert one.data["title"] == {"zh": "标题", "en": "a title"}
    assert one.length == 3
    assert repr(one) == f"Film({one.data['digest']}, 3 steps)"
    assert json.loads(one.json) == one.data


def test_the_digest_is_the_programs_and_not_its_comments() -> None:
    plain, said, other = (
        film_of(text, "s7-200").data["digest"]
        for text in ("LD I0.0; = Q0.0", "ld i0.0 ; = q0.0 // lamp", "LDN I0.0; = Q0.0")
    )
    assert plain == said != other


def test_the_same_film_is_the_same_bytes_in_every_process() -> None:
    code = (
        "import plcteach, hashlib; from plcteach.figure.verbs import film_of;"
        "t = 'Network 1\\nLD I0.0\\nLPS\\nA I0.1\\n= Q0.0\\nLPP\\n= Q0.1\\nNetwork 2\\nLD I0.2\\nLD I0.3\\nOLD\\n= Q0.2';"
        "print(hashlib.sha256(film_of(t, 's7-200').json.encode()).hexdigest())"
    )
    shown = {
        subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=True, env={"PYTHONHASHSEED": seed}
        ).stdout
        for seed in ("1", "2")
    }
    assert len(shown) == 1


@pytest.mark.parametrize(
    ("dialect", "text"), [("fx", "NOP / LD X0 / OUT Y0"), ("fx", "END"), ("gutta", "OLD / LD I0.0 / = Q0.0")]
)
def test_a_picture_of_an_empty_stack_is_a_picture(dialect: str, text: str) -> None:
    steps = film(run(read(text.replace(" / ", "\n"), dialect)).scans).data["steps"]
    assert all("cells" in step for step in steps)


# Over random programs.


def consistent(one: Film, program, scans) -> None:
    """Every picture holds what the machine held, and every cell's story is told without a gap."""
    steps = one.data["steps"]
    machine = iter([step for scan in scans for step in (None, *scan.steps)])
    seen: set[str] = set()
    last: dict[str, tuple[int, int]] = {}
    for step in steps:
        places = [(cell[STACK], cell[PLACE]) for cell in step["cells"]]
        here = {cell[KEY]: (cell[STACK], cell[PLACE]) for cell in step["cells"]}
        assert len(here) == len(places) == len(set(places))
        for number in range(len(one.data["columns"])):
            mine = sorted(place for stack, place in places if stack == number)
            assert mine == list(range(len(mine)))
        for cell in step["cells"]:
            assert -1 <= cell[FORMULA] < len(one.data["texts"])
            assert -1 <= cell[NAME] < len(one.data["texts"])
        moved = next(machine)
        new, gone = set(here) - set(last), set(last) - set(here)
        assert not new & seen, "a key never comes back"
        assert set(step.get("leave", {})) == gone
        if step["line"] < 0:
            assert moved is None
        else:
            told(step, moved, new, last, here)
        seen |= set(here)
        last = here
    assert len(program.lines) >= max(step["line"] for step in steps) + 1


def told(step: dict, moved, new: set[str], last: dict, here: dict) -> None:
    assert step["line"] >= 0
    values = [[repr(value) for value in stack] for stack in moved.after]
    assert {(cell[STACK], cell[PLACE]): cell[VALUE] for cell in step["cells"]} == {
        (stack, place): value for stack, cells in enumerate(values) for place, value in enumerate(cells)
    }
    assert new == set(step.get("from", {})) | set(step.get("enter", {}))
    assert not set(step.get("from", {})) & set(step.get("enter", {}))
    for key, parents in step.get("from", {}).items():
        stack, place = here[key]
        assert tuple(last[parent] for parent in parents) == moved.flow.after[stack][place].sources
    for key in set(here) - new:
        (stack, place), origin = here[key], moved.flow.after[here[key][0]][here[key][1]]
        assert origin.sources == (last[key],), "the same key is the same cell, moved or worked on in place"
        if origin.how != "kept":
            assert last[key] == (stack, place)
        if key in step.get("changed", []):
            assert moved.before[stack][place] != moved.after[stack][place]
        else:
            old = last[key]
            assert moved.before[old[0]][old[1]] == moved.after[stack][place]
    assert [address for address, _ in step.get("write", [])] == [address.text for address, _ in moved.written]


@pytest.mark.parametrize("name", MENU)
@settings(max_examples=60, deadline=None)
@given(data=st.data(), rows=SCANS)
def test_every_cells_story_is_told_without_a_gap(name: str, data: st.DataObject, rows: list[list[int]]) -> None:
    program = read(data.draw(lists(name, headings=True)), name)
    if not program.lines:
        return
    trace = run(program, [inputs(name, row) for row in rows])
    one = film(trace.scans)
    assert film(trace.scans).json == one.json
    consistent(one, program, trace.scans)
