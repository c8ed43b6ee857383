"""What is kept beside the notebook: never lost, never overwritten unread, and shared by desks and notebooks at once."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import plcteach
from plcteach.core import text as words
from plcteach.core.exercise import Exercise
from plcteach.core.text import Text
from plcteach.exercises import ids
from plcteach.widgets import ExerciseDesk
from plcteach.widgets.keeping import Notes, hinted, modelled, tried, typed

TASK = Exercise("mine", "s7-200", Text("题", "t"), Text("写", "write"), "--[ I0.0 ]--( Q0.0 )", points=2.0)
RIGHT = "LD I0.0\n= Q0.0\n"


@pytest.fixture(autouse=True)
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(words, "_chosen", ["en"])


def types(desk: ExerciseDesk, source: str) -> None:
    desk.source = source
    desk.serial += 1


def rows(path: Path) -> dict:
    return json.loads(path.read_text(encoding="utf-8"))["exercises"]


def trouble(desk: ExerciseDesk) -> str:
    return json.loads(desk.kept)["trouble"]["en"]


def test_to_open_a_desk_writes_nothing(kept: Path) -> None:
    ExerciseDesk(TASK)
    ExerciseDesk(TASK, "LD I0.0")
    assert not kept.exists()


def test_what_was_typed_comes_back_in_a_new_desk(kept: Path) -> None:
    desk = ExerciseDesk(TASK)
    types(desk, "LD I0.0 // 还没完 \ud800")
    assert rows(kept)["mine"]["text"] == desk.source
    assert ExerciseDesk(TASK).source == desk.source
    desk.check()
    desk.hint()
    again = json.loads(ExerciseDesk(TASK).kept)
    assert (again["attempts"], again["best"], again["hints"]) == (1, 0.0, 1)


def test_a_text_that_the_lesson_gives_counts_until_it_has_been_worked_on() -> None:
    desk = ExerciseDesk(TASK, "LD I0.0\nOLD")
    types(desk, RIGHT)
    assert ExerciseDesk(TASK, "LD I0.0\nOLD").source == RIGHT
    assert ExerciseDesk(TASK, "LD I0.7").source == "LD I0.7", "the lesson has another text now"
    assert ExerciseDesk(TASK).source == ""


FULL = "LD I0.0\n= Q0.0 // full marks\n"


def others(desk: ExerciseDesk) -> int:
    return json.loads(desk.kept)["earlier"]


def restores(desk: ExerciseDesk) -> str:
    desk._handle_custom_msg({"type": "restore"}, [])
    return desk.source


def test_a_text_typed_into_another_start_waits_for_it_and_can_be_put_back(kept: Path) -> None:
    types(ExerciseDesk(TASK), FULL)
    lesson = ExerciseDesk(TASK, "LD I0.5\n")
    assert (lesson.source, others(lesson)) == ("LD I0.5\n", 1)
    types(lesson, "LD I0.5\nA I0.6\n")
    types(lesson, "LD I0.5\nA I0.6\n= Q0.0\n")
    assert FULL in kept.read_text(encoding="utf-8").encode().decode("unicode_escape")
    assert ExerciseDesk(TASK).source == FULL
    assert others(lesson) == 1
    assert restores(lesson) == FULL
    assert ExerciseDesk(TASK, "LD I0.5\n").source == FULL
    assert restores(lesson) == "LD I0.5\nA I0.6\n= Q0.0\n", "what stood there is not lost by it"
    assert restores(lesson) == FULL


def test_after_an_update_with_another_start_the_answer_can_be_put_back() -> None:
    begun = Exercise("mine", "s7-200", Text("题", "t"), Text("写", "write"), TASK.reference, start="LD I0.0\n____\n")
    types(ExerciseDesk(begun), FULL)
    new = ExerciseDesk(Exercise("mine", "s7-200", begun.title, begun.task, begun.reference, start="____\n= Q0.0\n"))
    assert (new.source, others(new)) == ("____\n= Q0.0\n", 1)
    assert restores(new) == FULL
    assert ExerciseDesk(begun).source == FULL


def test_what_stood_there_before_starting_over_can_be_put_back() -> None:
    for over in ("", " \n", "LD I0.0\n"):
        desk = ExerciseDesk(TASK, "LD I0.0\n")
        types(desk, FULL)
        types(desk, over)
        types(desk, "LD I0.1")
        assert restores(ExerciseDesk(TASK, "LD I0.0\n")) == FULL


def test_going_through_what_is_kept_comes_by_every_text_and_loses_none() -> None:
    texts = [f"LD I0.{number}\n= Q0.0\n" for number in range(6)]
    for number, text in enumerate(texts):
        types(ExerciseDesk(TASK, f"// lesson {number}\n"), text)
    types(ExerciseDesk(TASK), "LD I1.0")
    types(ExerciseDesk(TASK), "LD I1.1")
    desk = ExerciseDesk(TASK)
    for _ in range(2):
        assert {restores(desk) for _ in range(7)} >= set(texts)
    types(desk, "LD I1.2")
    assert {restores(desk) for _ in range(8)} >= {*texts, "LD I1.1", "LD I1.2"}
    for number, text in enumerate(texts):
        assert ExerciseDesk(TASK, f"// lesson {number}\n").source == text
    assert restores(ExerciseDesk(Exercise("new", "s7-200", TASK.title, TASK.task, TASK.reference))) == ""


def test_the_best_mark_stays_when_a_later_answer_is_worse(kept: Path) -> None:
    desk = ExerciseDesk(TASK)
    for text in (RIGHT, "LD I0.1\n= Q0.0\n"):
        types(desk, text)
        desk.check()
    assert (rows(kept)["mine"]["best"], rows(kept)["mine"]["attempts"]) == (2.0, 2)


def test_two_desks_on_one_exercise_lose_nothing_of_each_other(kept: Path) -> None:
    one, other = ExerciseDesk(TASK), ExerciseDesk(TASK)
    types(one, "LD I0.0")
    types(other, "LD I0.1")
    types(one, "LD I0.0\n= Q0.0")
    row = rows(kept)["mine"]
    assert row["text"] == "LD I0.0\n= Q0.0"
    assert row["earlier"] == ["LD I0.1", "LD I0.0"]
    one.check()
    other.check()
    assert rows(kept)["mine"]["attempts"] == 2


WORKER = """
import sys
from pathlib import Path
from plcteach.widgets.keeping import Notes, tried, typed
notes = Notes(Path(sys.argv[1]))
for number in range(25):
    notes.change(sys.argv[2], typed(f"LD I0.{number % 8}", "", None))
    notes.change("shared", tried(1.0, 2.0))
assert notes.trouble is None, notes.trouble
"""


def test_two_notebooks_at_once_do_not_disturb_each_other(kept: Path) -> None:
    running = [subprocess.Popen([sys.executable, "-c", WORKER, str(kept), name]) for name in ("a", "b", "c")]
    assert [one.wait(60) for one in running] == [0, 0, 0]
    assert rows(kept)["shared"]["attempts"] == 75
    assert {"a", "b", "c"} <= set(rows(kept))
    assert [path.name for path in kept.parent.iterdir()] == [kept.name], "no lock and no half-written file is left"


@pytest.mark.parametrize("broken", ["{", "[]", '{"plcteach": 1, "exercises": []}', "", '"x"', "{}", "[" * 100_000])
def test_a_file_that_cannot_be_read_is_put_aside_and_told(kept: Path, broken: str) -> None:
    kept.write_text(broken, encoding="utf-8")
    desk = ExerciseDesk(TASK)
    assert kept.read_text(encoding="utf-8") == broken, "looking changes nothing"
    assert "cannot be read" in trouble(desk)
    types(desk, RIGHT)
    aside = kept.with_name(".plcteach-progress.broken-1.json")
    assert aside.read_text(encoding="utf-8") == broken
    assert aside.name in trouble(desk)
    assert rows(kept)["mine"]["text"] == RIGHT


@pytest.mark.parametrize(
    "row",
    [
        "7",
        "[]",
        '{"attempts": "many", "best": -3, "hints": true, "text": 5, "earlier": 3}',
        '{"earlier": [3, null, {}], "others": [3, {"start": 1, "text": "x"}, {"text": "y"}], "text": "LD I0.3", "start": "x"}',
    ],
)
def test_a_row_that_holds_anything_does_no_harm(kept: Path, row: str) -> None:
    kept.write_text(
        f'{{"plcteach": 1, "exercises": {{"mine": {row}, "other": {{"text": "LD I0.5"}}}}}}', encoding="utf-8"
    )
    desk = ExerciseDesk(TASK)
    types(desk, RIGHT)
    desk.check()
    assert (rows(kept)["mine"]["attempts"], rows(kept)["mine"]["best"]) == (1, 2.0)
    assert rows(kept)["other"] == {"text": "LD I0.5"}


def test_a_file_of_a_newer_plcteach_is_left_as_it_is(kept: Path) -> None:
    newer = '{"plcteach": 2, "exercises": {"mine": {"text": "LD I0.7"}}}'
    kept.write_text(newer, encoding="utf-8")
    desk = ExerciseDesk(TASK)
    types(desk, RIGHT)
    assert kept.read_text(encoding="utf-8") == newer
    assert "newer" in trouble(desk)


def test_a_read_only_file_is_told_and_not_written(kept: Path) -> None:
    types(ExerciseDesk(TASK), RIGHT)
    before = kept.read_bytes()
    kept.chmod(0o444)
    desk = ExerciseDesk(TASK)
    types(desk, "LD I0.1\n= Q0.0\n")
    assert desk.check().marks == 0.0, "the desk works on"
    assert kept.read_bytes() == before
    assert "cannot be written" in trouble(desk)


def test_a_folder_that_is_not_there_is_told(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PLCTEACH_PROGRESS", str(tmp_path / "gone" / "progress.json"))
    desk = ExerciseDesk(TASK)
    types(desk, RIGHT)
    assert "cannot be written" in trouble(desk)
    assert desk.check().marks == 2.0


def test_a_lock_that_was_left_behind_is_taken_over(kept: Path) -> None:
    lock = kept.with_name(f"{kept.name}.lock")
    lock.touch()
    os.utime(lock, (0, 0))
    notes = Notes(kept)
    notes.change("mine", typed("LD I0.0", "", None))
    assert rows(kept)["mine"]["text"] == "LD I0.0"
    assert not lock.exists()


def test_a_link_to_a_file_elsewhere_stays_a_link(kept: Path, tmp_path: Path) -> None:
    home = tmp_path / "elsewhere.json"
    kept.symlink_to(home)
    Notes(kept).change("mine", hinted(3))
    assert kept.is_symlink()
    assert json.loads(home.read_text(encoding="utf-8"))["exercises"]["mine"]["hints"] == 3


def test_after_the_model_answer_marks_do_not_count() -> None:
    notes = Notes()
    for change in (tried(0.5, 2.0), modelled, tried(2.0, 2.0)):
        notes.change("mine", change)
    assert (notes.record("mine").best, notes.record("mine").attempts) == (0.5, 2)


# The table.


def test_progress_shows_every_exercise_in_teaching_order() -> None:
    table = plcteach.progress()
    assert tuple(row.id for row in table.rows) == ids()
    assert repr(table).startswith(f"0 with full marks, 0 begun, {len(ids())} in all")
    first = plcteach.progress("fx")
    assert {row.exercise.dialect for row in first.rows} == {"fx"}


def test_progress_tells_attempts_best_mark_hints_and_what_comes_first(monkeypatch: pytest.MonkeyPatch) -> None:
    notes = Notes()
    notes.change("s7-one-contact", tried(99.0, 99.0))
    notes.change("a-teachers-own", tried(1.0, 5.0))
    notes.change("a-teachers-own", hinted(2))
    table = plcteach.progress()
    shown = table._repr_html_()
    assert "✓" in shown
    assert "s7-one-contact ✓" in shown, "what comes first is done"
    own = next(row for row in repr(table).split("\n") if "a-teachers-own" in row)
    assert "1 / 5" in own
    assert own.split()[0] == "…"
    monkeypatch.setattr(words, "_chosen", ["zh"])
    assert "满分1道，做过2道" in repr(table)
    assert "最好成绩" in table._repr_html_()


def test_progress_says_when_the_file_cannot_be_read_and_leaves_it(kept: Path) -> None:
    kept.write_text("{", encoding="utf-8")
    assert "cannot be read" in repr(plcteach.progress())
    assert kept.read_text(encoding="utf-8") == "{"


def test_nothing_of_the_file_becomes_a_tag(kept: Path) -> None:
    Notes(kept).change("<script>alert(1)</script>", tried(1.0, 2.0))
    assert "<script" not in plcteach.progress()._repr_html_()
