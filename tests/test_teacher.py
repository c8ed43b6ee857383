"""A teacher's way: a ladder or a list becomes an exercise file, and the file proves itself without a word changed."""

from __future__ import annotations

import importlib.util
import io
import json
import sys
import tomllib
from pathlib import Path
from types import SimpleNamespace

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from plcteach.check.drill import drill
from plcteach.check.drilling.shapes import KINDS
from plcteach.check.drilling.slips import slips
from plcteach.check.judge import judge
from plcteach.check.proving import proofs, proved
from plcteach.cli import main
from plcteach.dialects import families
from plcteach.exercises import exercise, ids, load, parse
from plcteach.ladder.picture import write_drawing
from plcteach.stl import read

FAMILIES = tuple(one.name for one in families())
MADE = ["write", "complete", "bug", "order", "predict", "join", "match", "chart"]
SEAL = "--[ I0.0 ]--+--[/I0.1 ]--( Q0.0 )\n--[ Q0.0 ]--+\n"


def made(tmp_path: Path, text: str, *words: str) -> Path:
    """Write a file, and an exercise from it."""
    given_here, out = tmp_path / "given.txt", tmp_path / "mine.toml"
    given_here.write_text(text, encoding="utf-8")
    assert main(["exercise", "new", str(given_here), "-o", str(out), "--force", *words]) == 0
    return out


def _ladders():
    """Open the random ladders of another folder of tests."""
    spec = importlib.util.spec_from_file_location(
        "random_ladders", Path(__file__).parent / "ladder" / "random_ladders.py"
    )
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.ladders


def why(path: Path) -> str:
    return "\n".join(repr(one) for one in proofs(load(path)) if one.state == "failed")


# From a ladder to a proved file.


@pytest.mark.parametrize("dialect", FAMILIES)
@pytest.mark.parametrize("kind", KINDS)
def test_a_drawing_becomes_an_exercise_that_is_proved_as_it_stands(tmp_path, capsys, dialect: str, kind: str) -> None:
    one = drill(kind, len(dialect), 2, dialect)
    path = made(tmp_path, one.reference, "--dialect", dialect)
    assert main(["exercise", "test", str(path)]) == 0, capsys.readouterr().out
    read_back = load(path)
    assert (read_back.kind, read_back.dialect, read_back.reference.strip()) == ("write", dialect, one.reference.strip())
    assert read_back.level == ("exact" if kind == "edges" else "either")
    assert len(read_back.right) >= 2
    assert len(read_back.wrong) >= 3
    assert judge(read_back, one.right[0]).marks == read_back.points


@pytest.mark.parametrize("dialect", FAMILIES)
@pytest.mark.parametrize("kind", MADE)
def test_every_kind_can_be_made_from_a_list(tmp_path, capsys, dialect: str, kind: str) -> None:
    path = made(tmp_path, drill("blocks", 11, 2, dialect).right[0], "--dialect", dialect, "--kind", kind)
    assert load(path).kind == kind
    assert main(["exercise", "test", str(path)]) == 0, capsys.readouterr().out


@pytest.mark.parametrize("dialect", FAMILIES)
def test_any_ladder_of_any_family_becomes_one(tmp_path, dialect: str) -> None:
    ladders = _ladders()

    @settings(max_examples=10, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
    @given(ladders(dialect, edges=dialect != "gutta"))
    def check(ladder) -> None:
        path = made(tmp_path, write_drawing(ladder), "--dialect", dialect)
        assert proved(proofs(load(path))), why(path)

    check()


def test_it_is_printed_where_no_file_is_named_and_read_from_standard_input(monkeypatch, capsys) -> None:
    monkeypatch.setattr(sys, "stdin", SimpleNamespace(buffer=io.BytesIO(SEAL.encode())))
    assert main(["exercise", "new", "-"]) == 0
    said = capsys.readouterr()
    assert said.err == ""
    table = tomllib.loads(said.out)
    assert table["reference"].strip() == SEAL.strip()
    assert "# hidden = true" in said.out


@pytest.mark.parametrize(("lang", "words"), [("en", "Each must get full marks"), ("zh", "每一个都要得满分")])
def test_the_remarks_speak_to_the_teacher_in_the_language_in_force(tmp_path, capsys, lang: str, words: str) -> None:
    path = tmp_path / "a.txt"
    path.write_text(SEAL, encoding="utf-8")
    assert main(["exercise", "new", str(path), "--lang", lang]) == 0
    assert words in capsys.readouterr().out


def test_odd_signs_in_a_drawing_survive(tmp_path) -> None:
    text = '// "quoted" \\ back """ three\n' + SEAL
    path = made(tmp_path, text)
    assert load(path).reference.strip() == text.strip()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("--[ I0.0 ]--", ["coil"]),
        ("LD I0.0\nOLD\n= Q0.0\n", ["OLD"]),
        ("LD I0.0\n", ["no output"]),
        ("", ["no"]),
        ("hello there", ["hello", "HELLO"]),
    ],
)
def test_what_makes_no_exercise_is_said_in_words(tmp_path, capsys, text: str, words: list[str]) -> None:
    path = tmp_path / "given.txt"
    path.write_text(text, encoding="utf-8")
    assert main(["exercise", "new", str(path)]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert any(word in said.err for word in words), said.err


def test_nothing_is_written_over(tmp_path, capsys) -> None:
    path = made(tmp_path, SEAL)
    before = path.read_text(encoding="utf-8")
    assert main(["exercise", "new", str(tmp_path / "given.txt"), "-o", str(path), "--kind", "bug"]) == 2
    assert "--force" in capsys.readouterr().err
    assert path.read_text(encoding="utf-8") == before
    assert main(["exercise", "new", str(tmp_path / "given.txt"), "-o", str(tmp_path / "x.json")]) == 2


# What is not sound is found.

SPOILED = {
    "a right sample that is wrong": ("A I0.1", "O I0.1", "right samples 1"),
    "a wrong sample that is right": ("LDN I0.0\nA I0.1\n= Q0.0", "LD I0.1\nA I0.0\n= Q0.0", "wrong samples 1"),
    "a promise that is not kept": ('expect = "different"', 'expect = "STK001"', "wrong samples 1"),
    "a hint that lies": ("has 3 instructions", "has 4 instructions", "hints 1"),
    "a hint that lies in Chinese": ("有3条指令", "有5条指令", "hints 1"),
    "a language that is missing": ('zh = "两个触点"', 'zh = ""', "both languages"),
    "the other language": ('en = "Two contacts"', 'en = "两个触点"', "both languages"),
    "a start that is the answer": ("points = 2", 'points = 2\nstart = "LD I0.0; A I0.1; = Q0.0"', "the start"),
    "a prerequisite that is not there": ("points = 2", 'points = 2\nafter = ["s7-nowhere"]', "prerequisites"),
    "a prerequisite that comes later": ("order = 5", 'order = 5\nafter = ["s7-two-blocks"]', "prerequisites"),
    "a drawing that does not read": ("( Q0.0 )", "", "the reference"),
    "a need that the right samples do not meet": (
        "points = 2",
        'points = 2\nneed = [{ avoids = "A" }]',
        "right samples 1",
    ),
    "no right sample": ("[[right]]", "[[wrong]]\nexpect = 'different'", "right samples"),
    "a file that does not read": ("order = 5", "order = = 5", "reading the file"),
    "a word that nobody knows": ("order = 5", "ordr = 5", "reading the file"),
}
SOUND = '''
order = 5
dialect = "s7-200"
points = 2
title = { zh = "两个触点", en = "Two contacts" }
task = { zh = "写出来。", en = "Write it." }
reference = """
--[ I0.0 ]--[ I0.1 ]--( Q0.0 )
"""
hints = [{ zh = "标准答案有3条指令。", en = "The answer has 3 instructions." }, { zh = "串联。", en = "In series." }]
[[right]]
program = """
LD I0.0
A I0.1
= Q0.0
"""
[[wrong]]
expect = "different"
because = { zh = "反了", en = "Turned round." }
program = """
LDN I0.0
A I0.1
= Q0.0
"""
'''


def outcome(capsys, *words: str) -> tuple[int, dict[str, list[dict[str, str]]]]:
    code = main(["exercise", "test", *words, "--json", "--lang", "en"])
    said = capsys.readouterr()
    assert said.err == ""
    return code, json.loads(said.out)


def test_a_sound_file_is_proved_with_advice(tmp_path, capsys) -> None:
    path = tmp_path / "sound.toml"
    path.write_text(SOUND, encoding="utf-8")
    code, found = outcome(capsys, str(path))
    assert code == 0
    notes = [one["what"] for one in found["sound"] if one["state"] == "note"]
    assert notes == ["right samples", "wrong samples"]


@pytest.mark.parametrize("name", SPOILED)
def test_a_file_that_is_spoiled_is_found(tmp_path, capsys, name: str) -> None:
    old, new, what = SPOILED[name]
    assert old in SOUND
    path = tmp_path / "spoiled.toml"
    path.write_text(SOUND.replace(old, new, 1), encoding="utf-8")
    code, found = outcome(capsys, str(path))
    assert code == 1
    assert what in {one["what"] for one in found["spoiled"] if one["state"] == "failed"}, found
    assert main(["exercise", "test", str(path)]) == 1
    assert "FAILED" in capsys.readouterr().out


LIES = {
    "an instruction": ("要用OLD。", "Use OLD.", "failed", "OLD"),
    "an instruction that is only spoken of": ("OLD连接两块。", "OLD joins two blocks.", "note", "OLD"),
    "in Chinese alone": ("写OLD", "Two blocks.", "failed", "OLD"),
    "at the end of a question": ("这里是OLD吗？", "Is it OLD?", "note", "OLD"),
    "addresses": ("程序是LD I0.5、A I0.1。", "The list is LD I0.5, A I0.1.", "failed", "I0.5"),
    "an output": ("写= Q0.7", "It ends with = Q0.7", "failed", "Q0.7"),
    "a number in words": ("七条。", "The answer has seven instructions.", "failed", "seven"),
    "a number in Chinese words": ("答案有七条指令。", "Seven.", "failed", "七"),
    "a number of lines": ("答案共4行。", "The list has four lines.", "failed", "4"),
    "two languages that part": ("LD I0.0、A I0.1、= Q0.0。", "LD I0.0, O I0.1, = Q0.0", "failed", "only in English: O"),
    "one language that says more": ("先写LD I0.0。", "Load the first one.", "note", "only in Chinese: I0.0, LD"),
    "a line": ("先是LD I0.0，然后LD I0.1。", "LD I0.0, then LD I0.1.", "note", "LD I0.1"),
}
TRUTHS = {
    "a warning": ("不要用OLD。", "Do not use OLD."),
    "what it is instead": ("用A，而不是OLD。", "Write A instead of OLD."),
    "a number in words": ("答案有三条指令。", "The answer has three instructions."),
    "two lines of it": ("有两条指令读输入。", "Two instructions read inputs."),
    "a number of two signs": ("十二条也行。", "The list could have more lines."),
    "a range": ("I0.0到I0.7是一个字节。", "I0.0 to I0.7 are one byte."),
    "the list": ("LD I0.0，A I0.1，= Q0.0。", "LD I0.0, A I0.1, = Q0.0."),
    "a sentence that begins with A": ("一个触点读I0.1。", "A contact reads I0.1."),
}


def told(zh: str, en: str, text: str = SOUND) -> list[tuple[str, str]]:
    """Prove the sound exercise with a hint of one's own, and give what is said of that hint."""
    hint = f'{{ zh = "{zh}", en = "{en}" }}, {{ zh = "串联。"'
    one = parse(text.replace('{ zh = "串联。"', hint, 1), "mine")
    return [(proof.state, proof.says.en) for proof in proofs(one) if proof.what.en == "hints 2"]


@pytest.mark.parametrize("name", LIES)
def test_a_hint_that_lies_is_refused_and_a_doubtful_one_is_remarked(name: str) -> None:
    zh, en, state, words = LIES[name]
    ((got, says),) = told(zh, en)
    assert (got, words in says) == (state, True), says


@pytest.mark.parametrize("name", TRUTHS)
def test_a_hint_that_is_true_is_believed(name: str) -> None:
    assert told(*TRUTHS[name]) == [("proved", "")]


def test_bits_that_a_line_reaches_with_its_number_are_in_the_exercise() -> None:
    text = SOUND.replace("= Q0.0", "S Q0.0, 4").replace("( Q0.0 )", "{ S Q0.0, 4 }")
    assert told("Q0.3也置位。", "Q0.3 is set as well.", text) == [("proved", "")]
    assert told("Q0.4也置位。", "Q0.4 is set as well.", text)[0][0] == "failed"


def test_every_wrong_list_is_searched_for_its_repair_where_more_is_asked_too() -> None:
    found = {
        name: [one for one in proofs(exercise(name)) if "repair" in one.what.en]
        for name in ("s7-seal-in", "s7-star-delta")
    }
    assert all(len(some) > 1 and proved(tuple(some)) for some in found.values()), found


def test_no_hint_of_the_bundled_exercises_lies() -> None:
    known = {name: exercise(name) for name in ids()}
    some = {name: proofs(one, known, repairs=False) for name, one in known.items()}
    assert {name: one for name, one in some.items() if not proved(one)} == {}


def test_a_folder_of_files_is_proved_one_by_one(tmp_path, capsys) -> None:
    (tmp_path / "good.toml").write_text(SOUND, encoding="utf-8")
    (tmp_path / "bad.toml").write_text(SOUND.replace("A I0.1", "O I0.1", 1), encoding="utf-8")
    code, found = outcome(capsys, str(tmp_path))
    assert (code, sorted(found)) == (1, ["bad", "good"])
    (tmp_path / "bad.toml").unlink()
    (tmp_path / "next.toml").write_text(SOUND.replace("order = 5", 'order = 6\nafter = ["good"]'), encoding="utf-8")
    assert outcome(capsys, str(tmp_path))[0] == 0
    assert main(["exercise", "test", str(tmp_path)]) == 0
    assert "2 of 2 exercises are proved" in capsys.readouterr().out


def test_bundled_ones_and_drills_are_proved_by_their_ids(capsys) -> None:
    code, found = outcome(capsys, "s7-two-blocks", "drill-timers-2-7-fx")
    assert (code, list(found)) == (0, ["s7-two-blocks", "drill-timers-2-7-fx"])


@pytest.mark.parametrize("words", [["s7-two-bloks"], ["/there/is/none.toml"], ["drill-blocks-9-9-fx"]])
def test_what_is_not_there_is_a_wrong_call(capsys, words: list[str]) -> None:
    assert main(["exercise", "test", *words]) == 2
    assert capsys.readouterr().err


# The catalogue.


def test_the_catalogue_is_in_teaching_order(capsys) -> None:
    assert main(["exercise", "list", "--json"]) == 0
    assert [one["id"] for one in json.loads(capsys.readouterr().out)] == list(ids())
    assert main(["exercise", "list", "--dialect", "fx", "--lang", "zh"]) == 0
    rows = capsys.readouterr().out.splitlines()
    assert sum(exercise(name).dialect == "fx" for name in ids()) == len(rows) - 2
    assert main(["exercise"]) == 0


def test_a_task_is_shown_without_its_answer(capsys) -> None:
    for name in ("s7-two-blocks", "drill-blocks-2-7-fx", "drill-blocks-2-7-fx-match", "drill-blocks-2-7-fx-order"):
        assert main(["exercise", "show", name, "--lang", "en"]) == 0
        said = capsys.readouterr().out
        task = judge(name, "").exercise
        assert task.task.en in said
        assert "--[" in said
    assert "A:" in capsys.readouterr().out or task.kind == "order"
    assert main(["exercise", "show", "s7-two-blocks", "--lang", "en"]) == 0
    assert "OLD" not in capsys.readouterr().out


# Slips.


@pytest.mark.parametrize("dialect", FAMILIES)
@settings(max_examples=15, deadline=None, derandomize=True)
@given(data=st.data())
def test_a_slip_changes_one_thing_and_says_why(dialect: str, data) -> None:
    kind, seed = data.draw(st.sampled_from(sorted(KINDS))), data.draw(st.integers(0, 10**6))
    program = read(drill(kind, seed, 3, dialect).right[0], dialect)
    some = slips(program)
    assert some
    assert len({one.text for one in some}) == len(some)
    for one in some:
        assert one.text != program.source
        assert one.because.zh
        assert one.because.en
        assert 0 <= one.misconception <= 29
