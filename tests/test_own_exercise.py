"""A teacher's own exercise is named by its file wherever an exercise is named, and what goes wrong with it is said in words."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path
from random import Random

import pytest

import plcteach as plc
from plcteach.check.drilling.draft import DRAFTED, draft
from plcteach.check.judge import shown
from plcteach.check.marking.grading import How, grade_folder, write_results
from plcteach.cli import main
from plcteach.core.errors import DeclarationError, PlcTeachError
from plcteach.core.text import Text, speaking
from plcteach.dialects import dialect
from plcteach.exercises import exercise, load
from plcteach.figure.ladder import ladder_scene
from plcteach.figure.scene import Words, extent
from plcteach.ladder.telling import is_drawing
from plcteach.machine import run
from plcteach.stl import read

EDGE = "LD I0.0\nEU\n= Q0.0\n"
MINE = '''
dialect = "s7-200"
level = "exact"
title = { zh = "一个脉冲", en = "One pulse" }
task = { zh = "I0.0每接通一次，Q0.0只接通一个扫描。", en = "Q0.0 is on for one scan each time I0.0 comes on." }
reference = """
LD I0.0
EU
= Q0.0
"""
'''
TIMED = """
--[ I0.0 ]--+--[/I0.1 ]--( Q0.0 )
--[ Q0.0 ]--+

--[ Q0.0 ]--{ TON T37,50 }

--[ T37 ]--( Q0.1 )
"""


@pytest.fixture
def mine(tmp_path, monkeypatch) -> Path:
    """Give a file beside the work, as a teacher has it."""
    monkeypatch.chdir(tmp_path)
    Path("mine.toml").write_text(MINE, encoding="utf-8")
    Path("right.txt").write_text(EDGE, encoding="utf-8")
    Path("wrong.txt").write_text("LD I0.0\n= Q0.0\n", encoding="utf-8")
    return Path("mine.toml")


# A file wherever an exercise is named.


def test_a_file_is_an_exercise_for_every_word(mine) -> None:
    for named in ("mine.toml", mine, str(mine.resolve()), load(mine)):
        assert plc.grade(named, EDGE) == 4
        assert plc.judge(named, "LD I0.0\n= Q0.0\n").verdict.status == "different"
        assert "One pulse" in plc.desk(named).task
        assert shown(named).form == "list"


def test_a_file_is_an_exercise_on_the_command_line(mine, capsys) -> None:
    assert main(["check", "right.txt", "--exercise", str(mine)]) == 0
    assert main(["check", "wrong.txt", "--exercise", str(mine)]) == 1
    assert main(["exercise", "show", str(mine)]) == 0
    assert "One pulse" in capsys.readouterr().out


def test_a_hidden_file_stays_hidden_on_the_desk(mine) -> None:
    mine.write_text("hidden = true\n" + MINE, encoding="utf-8")
    desk = plc.desk("mine.toml")
    desk.source = "LD I0.0\n= Q0.0\n"
    desk.check()
    sent = " ".join(str(getattr(desk, name)) for name in desk.trait_names(sync=True) if not name.startswith("_"))
    assert "EU" not in sent


@pytest.mark.parametrize(("lang", "says"), [("en", "there is no file none.toml"), ("zh", "没有文件none.toml")])
def test_a_file_that_is_not_there_is_said_so(mine, capsys, lang: str, says: str) -> None:
    with speaking(lang):
        for deed in (plc.desk, exercise, lambda name: plc.grade(name, EDGE)):
            with pytest.raises(DeclarationError, match=says):
                deed("none.toml")
        mine.unlink()
        with pytest.raises(DeclarationError):
            exercise(mine)
    for words in (
        ["check", "right.txt", "--exercise", "none.toml"],
        ["exercise", "test", "none.toml"],
        ["exercise", "show", "none.toml"],
    ):
        assert main([*words, "--lang", lang]) == 2
        assert says in capsys.readouterr().err


# What is wrong in a file.


@pytest.mark.parametrize(
    ("old", "new", "en", "zh"),
    [
        (
            "level =",
            "points = -4\nlevel =",
            "points: it must be a number above 0, and not -4",
            "points：必须大于0，而不是-4",
        ),
        ("level =", "points = 0\nlevel =", "above 0", "大于0"),
        ("level =", 'points = "four"\nlevel =', "above 0", "大于0"),
        ("level =", "poinst = 4\nlevel =", "no field poinst, did you mean points", "没有poinst这一项，是不是points"),
        (', en = "One pulse"', "", "title: en is missing", "title：缺少en"),
        ("title = {", "titel = {", "title is missing", "缺少title"),
        (
            '"exact"',
            '"exactly"',
            "level: it is one of exact, settled, either",
            "level：只能是exact、settled、either之一",
        ),
        ("level =", 'order = "first"\nlevel =', "order: it is a whole number", "order：应是整数"),
        ("level =", 'hints = "try"\nlevel =', "hints: it is written", "hints：应写成"),
        ("level =", "level = =", "no TOML", "不是TOML"),
    ],
)
def test_what_is_wrong_with_a_file_is_said_in_words(mine, old: str, new: str, en: str, zh: str) -> None:
    mine.write_text(MINE.replace(old, new, 1), encoding="utf-8")
    for lang, says in (("en", en), ("zh", zh)):
        with speaking(lang), pytest.raises(DeclarationError, match=re.escape(says)) as told:
            load(mine)
        assert not re.search(r"Error|\[\]|Traceback", str(told.value))


def test_a_hidden_task_that_speaks_of_a_ladder_is_remarked(mine, capsys) -> None:
    mine.write_text("hidden = true\n" + MINE.replace("Q0.0 is on", "In this ladder Q0.0 is on"), encoding="utf-8")
    main(["exercise", "test", str(mine), "--json"])
    assert "a hidden exercise shows none" in capsys.readouterr().out


# Drafts.


def test_what_a_ladder_does_not_make_is_said(monkeypatch) -> None:
    with pytest.raises(PlcTeachError, match="no join of blocks"):
        draft(TIMED, dialect("s7-200"), "join", "mine")
    monkeypatch.setattr("plcteach.check.drilling.asked.slips", lambda _program: [])
    with pytest.raises(PlcTeachError, match="nothing to choose from"):
        draft(TIMED, dialect("s7-200"), "match", "mine")


@pytest.mark.parametrize("preset", [5, 50, 3000])
def test_a_chart_is_long_enough_for_its_timer(preset: int) -> None:
    made = draft(TIMED.replace("50", str(preset)), dialect("s7-200"), "chart", "mine")
    trace = run(read(made.given, "s7-200"), list(made.scans))
    assert {"0", "1"} <= set(trace["Q0.1"])
    assert sum(row.get("ms", 10) for row in made.scans) >= preset * 100


def test_a_chart_without_a_timer_tells_of_no_times() -> None:
    made = draft("LD I0.0\nA I0.1\n= Q0.0", dialect("s7-200"), "chart", "mine")
    assert not any("ms" in row for row in made.scans)


def test_a_list_is_shown_once(tmp_path, capsys) -> None:
    text, out = tmp_path / "ladder.txt", tmp_path / "bug.toml"
    text.write_text(TIMED, encoding="utf-8")
    assert main(["exercise", "new", str(text), "--kind", "bug", "-o", str(out)]) == 0
    assert main(["exercise", "show", str(out)]) == 0
    assert capsys.readouterr().out.count("= Q0.1") == 1


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ({"kind": "nonsense"}, "There is: contacts, blocks,"),
        ({"level": 9}, "level is a whole number from 1 to 5, and not 9."),
        ({"seed": -1}, "seed is a whole number from 0 on, and not -1."),
    ],
)
def test_a_drill_names_what_is_wrong_and_nothing_else(words: dict, says: str) -> None:
    with pytest.raises(PlcTeachError, match=re.escape(says)) as told:
        plc.drill(**words)
    assert "Did you mean" not in str(told.value)


# Lists that are no ladder, or none of their own: the list stays the reference.

LISTS = {
    "a counter": ("s7-200", "LD I0.0\nLD I0.1\nCTU C0, 3\nLD C0\n= Q0.0\n"),
    "two bits at once": ("s7-200", "LD I0.0\nEU\nS Q0.0, 2\nLD I0.1\nR Q0.0, 2\n"),
    "words compared": ("s7-200", "LDW>= IW0, 5\n= Q0.0\n"),
    "bytes compared": ("s7-200", "LDB= IB0, 5\nS Q0.0, 1\nLDB= IB0, 6\nR Q0.0, 1\n"),
    "a timer in a branch": ("s7-200", "LD I0.0\nLPS\nA I0.1\n= Q0.0\nLPP\nTON T37, 50\nLD T37\n= Q0.1\n"),
    "a word moved": ("s7-200", "LD SM0.0\nMOVW 5, VW0\nLD I0.0\n= Q0.0\n"),
    "a jump": ("s7-200", "LD I0.0\nJMP 1\nLD I0.1\n= Q0.0\nLBL 1\n"),
    "a data register": ("fx", "LD> D0 K5\nOUT Y0\n"),
    "a step": ("fx", "STL S20\nOUT Y0\nRET\n"),
    "a master control": ("fx", "LD X0\nMC N0 M100\nLD X1\nOUT Y0\nMCR N0\n"),
    "a word compared": ("neza", "LD [%MW0 > 5]\nST %Q0.0\n"),
    "a shift register": ("neza", "LD %I0.0\nCU %SBR0\nLD %I0.1\nST %SBR0.0\nLD %SBR0.3\nST %Q0.0\n"),
    "a counter of three": ("gutta", "LD I0.0\nLD I0.1\nLD I0.2\nCTUD C0, 3\nLD C0\n= Q0.0\n"),
    "an edge": ("gutta", "LD I0.0\nP M0.0\n= Q0.0\n"),
}
WITHOUT = {
    "join": set(LISTS),
    "match": {
        "a counter", "two bits at once", "bytes compared", "a timer in a branch", "a word moved", "a data register",
        "a word compared", "a jump",
    },
    "bug": {"a data register", "a word compared"},
}  # fmt: skip
"""What a list does not make: it has no join, no ladder that is like it, or nothing that a change would change."""


@pytest.mark.parametrize("name", LISTS)
@pytest.mark.parametrize("kind", ["write", *DRAFTED])
def test_any_list_makes_an_exercise_that_is_proved_or_is_refused_in_words(
    tmp_path, capsys, name: str, kind: str
) -> None:
    family, text = LISTS[name]
    (tmp_path / "given.txt").write_text(text, encoding="utf-8")
    out = tmp_path / "made.toml"
    words = ["exercise", "new", str(tmp_path / "given.txt"), "--dialect", family, "--kind", kind, "-o", str(out)]
    code, said = main(words), capsys.readouterr()
    if name in WITHOUT.get(kind, ()):
        assert code == 2
        assert re.search(r"no join of blocks|nothing to choose from|nothing to mend", said.err)
        assert not out.exists()
        return
    assert code == 0, said.err
    assert main(["exercise", "test", str(out)]) == 0, capsys.readouterr().out
    written = load(out)
    assert (written.kind, len(written.wrong) > 0, len(written.hints) > 1) == (kind, True, True)
    if len(written.right) < 2:
        assert "please add another" in out.read_text(encoding="utf-8")
    unseen = kind in {"write", "order"} and not is_drawing(written.reference)
    assert ("must say in words" in out.read_text(encoding="utf-8").partition("# Say it")[2]) == unseen


@pytest.mark.parametrize("name", LISTS)
def test_every_right_sample_runs_like_the_list_itself(name: str) -> None:
    family, text = LISTS[name]
    made, dice = draft(text, dialect(family), "write", "mine"), Random(name)
    mine = read(text, family)
    inputs = [one.text for one in mine.addresses("input")]
    scans = [{one: dice.randint(0, 1) for one in inputs} | {"ms": 500} for _ in range(60)]
    outputs = [one.text for one in mine.addresses("output")]
    for right in made.right:
        trace, wanted = run(read(right, family), scans), run(mine, scans)
        assert len(wanted) == len(scans)
        assert [trace.values(one) for one in outputs] == [wanted.values(one) for one in outputs]


def test_a_draft_that_does_not_prove_itself_is_refused(mine, monkeypatch, capsys) -> None:
    monkeypatch.setattr("plcteach.check.drilling.draft.hints", lambda _program: (Text("答案有9条指令。", "It lies."),))
    assert main(["exercise", "new", "right.txt", "--lang", "en", "-o", "out.toml"]) == 2
    assert "No exercise that proves itself came of this (hints 1: '9'" in capsys.readouterr().err
    assert mine.exists()
    assert not Path("out.toml").exists()


@pytest.mark.parametrize("kind", ["predict", "chart", "order"])
def test_a_jump_back_is_no_crash(kind: str) -> None:
    text = "LD I0.0\n= Q0.0\nLBL 1\nLD Q0.0\nAN I0.0\nJMP 1\n"
    assert draft(text, dialect("s7-200"), kind, "mine").right


# A counterexample is short, and can be run.


@pytest.fixture
def timers(tmp_path, monkeypatch) -> list[str]:
    monkeypatch.chdir(tmp_path)
    for name, preset in (("got.txt", 49), ("wanted.txt", 50)):
        Path(name).write_text(f"LD I0.0\nTON T37, {preset}\nLD T37\n= Q0.0\n", encoding="utf-8")
    return ["check", "got.txt", "--reference", "wanted.txt"]


def test_scans_that_are_alike_are_folded(timers, capsys) -> None:
    assert main(timers) == 1
    assert len(capsys.readouterr().out.splitlines()) < 10


def test_a_report_of_check_is_run(timers, capsys) -> None:
    assert main([*timers, "--json"]) == 1
    report = capsys.readouterr().out
    Path("report.json").write_text(report, encoding="utf-8")
    example = json.loads(report)["counterexample"]
    for name, side in (("got.txt", "got"), ("wanted.txt", "expected")):
        assert main(["run", name, "--inputs", "report.json", "--json"]) == 0
        assert json.loads(capsys.readouterr().out) == example[side]
    Path("report.json").write_text('{"counterexample": null}', encoding="utf-8")
    assert main(["run", "got.txt", "--inputs", "report.json"]) == 2
    assert "check --json" in capsys.readouterr().err


# A class.


def test_a_class_counts_what_is_empty_and_no_advice_on_full_marks(mine, tmp_path) -> None:
    texts = {
        "a": EDGE, "b": EDGE.replace("= Q", "=  Q"), "empty": "", "odd": "LD I0.0\nFOO\n= Q0.0\n", "late": "LD I0.0\n= Q0.0\n",
        "long": "LD I0.0\nLD I0.0\nOLD\nEU\n= Q0.0\n",
    }  # fmt: skip
    folder, out = tmp_path / "class", tmp_path / "out"
    folder.mkdir()
    for name, text in texts.items():
        (folder / f"{name}.txt").write_text(text, encoding="utf-8")
    believed = '[[wrong]]\nexpect = "different"\nmisconception = 18\nprogram = "LD I0.0\\n= Q0.0"\n'
    mine.write_text(MINE + believed, encoding="utf-8")
    task = load(mine)
    graded = grade_folder(folder, task, out, How(1))
    write_results(graded.rows, task, out, "en")
    page = (out / "class.html").read_text(encoding="utf-8")
    mistakes = re.sub(r"<[^>]*>", " ", page.partition("Which mistakes")[2].partition("What goes wrong")[0])
    assert "What was handed in is empty" in mistakes
    assert "no instruction FOO" in mistakes
    assert "…" not in mistakes
    assert "STK007" not in mistakes
    groups = {row.learner: row.group for row in graded.rows}
    assert groups["a"] == groups["b"] != 0
    assert groups["odd"] == groups["late"] == 0
    rows = list(csv.DictReader(io.StringIO((out / "results.csv").read_text(encoding="utf-8-sig"))))
    late = next(row for row in rows if row["name"] == "late")
    assert (late["misconceptions"], late["misconceptions in words"]) == ("18", "An edge belongs to the last contact")


def test_the_command_line_counts_answers_as_the_page_does(mine, tmp_path, capsys) -> None:
    folder = tmp_path / "class"
    folder.mkdir()
    for name, text in (("a", EDGE), ("b", EDGE.replace("= Q", "=  Q"))):
        (folder / f"{name}.txt").write_text(text, encoding="utf-8")
    assert main(["grade", str(folder), "--exercise", str(mine), "--jobs", "1"]) == 0
    assert "distinct answers: 1," in capsys.readouterr().out


# Pictures of the bundled ones.


def test_the_lines_that_set_blocks_up_are_not_cut_off() -> None:
    scene = ladder_scene(shown("neza-drum").ladders[0])
    rows = [one for one in scene.shapes if isinstance(one, Words) and one.code and one.anchor == "start"]
    assert any("STEPS=" in one.text.en for one in rows)
    assert all(one.x + extent(one.text.en, one.size, code=True) <= scene.width for one in rows)


def test_a_printed_join_has_the_numbers_that_its_question_names() -> None:
    still = plc.desk("s7-which-blocks")._still()
    row, line = exercise("s7-which-blocks").row, shown("s7-which-blocks").rows
    assert f"{row}  {line[row - 1]}" in still
