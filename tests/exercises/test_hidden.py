"""A hidden exercise shows its reference nowhere: what a learner can see is searched for every row of it, its list and its picture."""

from __future__ import annotations

import json
import os
import pickle
import re
import subprocess
import sys
from pathlib import Path

import pytest

from plcteach import explain
from plcteach.check.hints import hints
from plcteach.check.judge import judge, model, reference, shown
from plcteach.check.kinds import KINDS
from plcteach.check.report import headline, report_html, verdict_json
from plcteach.check.score import grade
from plcteach.cli import main
from plcteach.core.errors import DeclarationError, PlcTeachError, UnknownNameError
from plcteach.core.exercise import KINDS as NAMES
from plcteach.core.exercise import Exercise
from plcteach.core.text import Text
from plcteach.exercises import exercise, folder, ids, load
from plcteach.figure.ladder import ladder_scene
from plcteach.figure.svg import svg
from plcteach.ladder.picture import read_drawing
from plcteach.widgets import ExerciseDesk

pytestmark = pytest.mark.usefixtures("own")

HIDDEN = '''
kind = "write"
dialect = "s7-200"
order = 7
hidden = true
title = { zh = "考试第一题", en = "Examination, task 1" }
task = { zh = "按下启动按钮后，灯一直亮到停止。", en = "The lamp is on from start until stop." }
reference = """
// watermark-4711
--[ I0.0 ]--+--[/I0.6 ]--( M29.5 )
--[ M29.5 ]-+

--[ M29.5 ]--[/I0.7 ]--( Q0.5 )
"""
hints = [ { zh = "想想自锁。", en = "Think of a seal-in." }, { zh = "停止优先。", en = "Stop wins." } ]

[[right]]
program = """
// watermark-4712
LD I0.0
O M27.1
AN I0.6
= M27.1
AN I0.7
= Q0.5
"""

[[wrong]]
expect = "different"
because = { zh = "忘了自锁 watermark-4713", en = "Forgets the seal-in, watermark-4713" }
program = """
LD I0.0
AN I0.6
= M27.2
LD M27.2
AN I0.7
= Q0.5
"""
'''
SECRETS = ("watermark", "M29.5", "M27.1", "M27.2", "--[/I0.6", "O M29", "[/I0.7 ]")
ANSWERS = {
    "nothing": "",
    "one contact": "LD I0.0\n= Q0.5\n",
    "nearly right": "LD I0.0\nO Q0.5\nAN I0.6\n= Q0.5\n",
    "inverted": "LD I0.0\nO M0.0\nA I0.6\n= M0.0\nLD M0.0\nAN I0.7\n= Q0.5\n",
    "one edit away": "LD I0.0\nA M0.0\nAN I0.6\n= M0.0\nLD M0.0\nAN I0.7\n= Q0.5\n",
    "right": "LD I0.0\nO M0.0\nAN I0.6\n= M0.0\nLD M0.0\nAN I0.7\n= Q0.5\n",
    "an error": "LD I0.0\nOLD\n= Q0.5\n",
    "garbage": "\x00\x01<script>",
    "double coil": "LD I0.0\n= Q0.5\nLDN I0.6\n= Q0.5\n",
}


@pytest.fixture
def own(tmp_path, monkeypatch) -> Path:
    """Give a teacher's own folder, named by the environment, with one hidden exercise; the work stands elsewhere."""
    place = tmp_path / "teacher"
    place.mkdir()
    (place / "exam-1.toml").write_text(HIDDEN, encoding="utf-8")
    monkeypatch.setenv("PLCTEACH_EXERCISES", str(place))
    work = tmp_path / "learner"
    work.mkdir()
    monkeypatch.chdir(work)
    return place


def told_of(text: object) -> str:
    """Give a text as a learner may read it, entities and escapes undone."""
    plain = text if isinstance(text, str) else json.dumps(text, ensure_ascii=False, default=repr)
    return plain.replace("\\n", "\n").replace("&gt;", ">").replace("&lt;", "<").replace("&#x27;", "'")


def silent(text: object, answer: str = "", kept: str = "") -> None:
    """Refuse a text in which something of the reference stands that the answer does not say itself."""
    plain = told_of(text).replace(kept or "\x7f", "")
    for secret in SECRETS:
        assert secret not in plain, secret
    rows = [row.text for row in reference(exercise("exam-1").reference, "s7-200").lines if "M29" in row.text]
    assert not [row for row in [*rows, "= M29.5"] if row in plain and row not in answer]
    picture = _inside(svg(ladder_scene(read_drawing(exercise("exam-1").reference)[0]), "en"))
    assert picture not in plain


def _inside(picture: str) -> str:
    shapes = re.findall(r"<(?:path|line|polyline)[^>]*>", picture)
    return "".join(sorted(shapes, key=len)[-3:])


# Found, and told.


def test_a_teachers_own_folder_is_found_by_id_and_read_as_a_whole(own) -> None:
    one = exercise("exam-1")
    assert (one.hidden, one.kind, one.order) == (True, "write", 7)
    assert folder(own) == (one,) == (load(own / "exam-1.toml"),)
    assert "exam-1" not in ids()
    assert judge("exam-1", ANSWERS["right"]).marks == 4
    (own / "a.toml").write_text(HIDDEN.replace("order = 7", "order = 9"), encoding="utf-8")
    assert [each.id for each in folder(str(own))] == ["exam-1", "a"]


@pytest.mark.parametrize(
    "name", ["exam-2", "../teacher/exam-1", "/etc/passwd", ".", "", "a" * 500, "x\x00y", "exam-1\n"]
)
def test_other_names_are_not_looked_for_outside_it(name: str) -> None:
    with pytest.raises(UnknownNameError):
        exercise(name)


def test_without_the_variable_there_is_only_what_is_bundled(own, monkeypatch) -> None:
    monkeypatch.delenv("PLCTEACH_EXERCISES")
    with pytest.raises(UnknownNameError):
        exercise("exam-1")
    monkeypatch.setenv("PLCTEACH_EXERCISES", os.pathsep.join(["", "/there/is/none", str(own)]))
    assert exercise("exam-1").hidden


def test_a_bundled_exercise_keeps_its_name(own) -> None:
    (own / "s7-two-blocks.toml").write_text(HIDDEN, encoding="utf-8")
    assert not exercise("s7-two-blocks").hidden


# Nothing shows.


def test_what_it_shows_before_the_answer() -> None:
    sheet = shown("exam-1")
    assert sheet.ladders == ()
    silent(repr(sheet))
    silent(repr(exercise("exam-1")))
    silent(f"{exercise('exam-1')!s} {[exercise('exam-1')]!r} { ({'a': exercise('exam-1')})!r}")


@pytest.mark.parametrize("name", ANSWERS)
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_a_judgement_and_its_reports(name: str, lang: str, monkeypatch) -> None:
    monkeypatch.setenv("PLCTEACH_LANG", lang)
    answer = ANSWERS[name]
    judged = judge("exam-1", answer)
    silent(repr(judged))
    silent(repr(judged.verdict), answer)
    silent(str(headline(judged)), answer)
    silent([one.text.as_dict() for one in judged.verdict.diagnostics], answer)
    silent([one.as_dict() for one in judged.says], answer)
    score = grade("exam-1", answer)
    silent(score._repr_html_(), answer)
    silent(repr(score))
    silent(pickle.loads(pickle.dumps(score))._repr_html_(), answer)  # noqa: S301 (our own)
    silent([case for case, _, _ in score.cases()], answer)
    with pytest.raises(AssertionError) if judged.marks < 4 else _nothing() as caught:
        score.assert_correct()
    if caught:
        silent(str(caught.value), answer)


class _nothing:  # noqa: N801 (like pytest.raises)
    def __enter__(self) -> None:
        return None

    def __exit__(self, *_: object) -> None:
        return None


@pytest.mark.parametrize("name", ANSWERS)
def test_the_hints_stop_before_the_edit(name: str) -> None:
    answer = ANSWERS[name]
    for one in hints(judge("exam-1", answer)):
        silent(one.as_dict(), answer)
        assert not re.search(r"\b(?:make|Put) (?:LD|A|AN|O|ON|=) ", one.en), one


@pytest.mark.parametrize("name", ANSWERS)
def test_the_desk_and_its_state(name: str) -> None:
    answer = ANSWERS[name]
    desk = ExerciseDesk("exam-1", answer)
    for deed in ("check", "show", "hint", "hint", "hint", "hint", "hint", "model"):
        desk._asked(desk, {"type": deed}, None)
        for trait, value in desk.get_state().items():
            if trait not in {"_esm", "_css", "layout"}:
                silent(value, answer, kept=answer)
    bundle = desk._repr_mimebundle_()
    silent(bundle, answer)
    silent(repr(desk), answer)
    for path in Path.cwd().rglob("*"):
        if path.is_file():
            silent(path.read_text(encoding="utf-8"), answer, kept=json.dumps(answer)[1:-1])


def test_explain_knows_nothing_of_it() -> None:
    silent(repr(explain()))
    with pytest.raises(UnknownNameError) as caught:
        explain("exam-1")
    silent(str(caught.value))


@pytest.mark.parametrize("json_only", [[], ["--json"]])
def test_the_command_line(own, tmp_path, capsys, json_only: list[str]) -> None:
    for name, answer in ANSWERS.items():
        path = tmp_path / "work.stl"
        path.write_text(answer, encoding="utf-8")
        main(["check", str(path), "--exercise", "exam-1", *json_only])
        said = capsys.readouterr()
        silent(said.out + said.err, answer, kept=answer), name
    main(["exercise", "show", "exam-1"])
    main(["exercise", "show", str(own / "exam-1.toml")])
    main(["exercise", "test", "exam-1", *json_only])
    said = capsys.readouterr()
    assert "The lamp is on" in said.out
    silent(said.out + said.err)


def test_marks_for_a_folder(tmp_path, capsys) -> None:
    place = tmp_path / "handed-in"
    place.mkdir()
    for name, answer in ANSWERS.items():
        (place / f"{name.replace(' ', '-')}.stl").write_text(answer, encoding="utf-8")
    assert main(["grade", str(place), "--exercise", "exam-1", "--jobs", "1", "-o", str(tmp_path / "marks")]) == 0
    said = capsys.readouterr()
    silent(said.out)
    for path in (tmp_path / "marks").rglob("*"):
        if path.is_file():
            silent(path.read_text(encoding="utf-8", errors="replace"), "\n".join(ANSWERS.values()))


# Tracebacks.

BROKEN = HIDDEN.replace("= M27.1", "OLD").replace("--( Q0.5 )", "--")
SHELL = """
import sys
from IPython.core.interactiveshell import InteractiveShell
shell = InteractiveShell.instance()
shell.run_line_magic("xmode", sys.argv[1])
shell.run_cell("import plcteach; from plcteach.check.judge import *; from plcteach.widgets import ExerciseDesk")
shell.run_cell(sys.argv[2])
"""


@pytest.mark.parametrize("mode", ["Plain", "Context", "Verbose", "Minimal"])
@pytest.mark.parametrize(
    "cell",
    [
        "plcteach.judge('exam-1', 'LD I0.0')",
        "plcteach.grade('exam-1', 'LD I0.0')",
        "shown('exam-1'), model('exam-1')",
        "ExerciseDesk('exam-1').check()",
        "plcteach.judge('torn', 'LD I0.0')",
    ],
)
def test_a_traceback_of_a_task_with_an_error_of_its_own(own, mode: str, cell: str) -> None:
    (own / "exam-1.toml").write_text(BROKEN, encoding="utf-8")
    (own / "torn.toml").write_text(HIDDEN.replace('kind = "write"', "kind = write"), encoding="utf-8")
    done = subprocess.run([sys.executable, "-c", SHELL, mode, cell], capture_output=True, text=True, check=False)
    said = re.sub(r"\x1b\[[0-9;]*m", "", done.stdout + done.stderr)
    assert "Error" in said or "exam-1" in said, said
    for secret in SECRETS:
        assert secret not in said, said


@pytest.mark.parametrize("mode", ["Context", "Verbose"])
def test_a_traceback_where_the_machine_itself_fails(mode: str) -> None:
    cell = (
        "import plcteach.check.same as same\n"
        "def fails(*_): raise ZeroDivisionError('deep ' + 'inside')\n"
        "same.product = fails\n"
        "plcteach.judge('exam-1', 'LD I0.0; = Q0.5')"
    )
    done = subprocess.run([sys.executable, "-c", SHELL, mode, cell], capture_output=True, text=True, check=False)
    said = re.sub(r"\x1b\[[0-9;]*m", "", done.stdout + done.stderr)
    assert "exam-1 has an error itself" in said, said
    assert "deep inside" not in said
    for secret in SECRETS:
        assert secret not in said, said


def test_an_interrupted_judgement_shows_no_frame(monkeypatch) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("plcteach.check.program.verdict_on", interrupted)
    with pytest.raises(KeyboardInterrupt) as caught:
        judge("exam-1", "LD I0.0\n= Q0.5")
    frames = [frame.name for frame in caught.traceback]
    assert "judged_program" not in frames
    assert caught.value.__suppress_context__ or caught.value.__context__ is None


def test_what_is_not_hidden_keeps_its_traceback(monkeypatch) -> None:
    def failing(*_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr("plcteach.check.program.verdict_on", failing)
    with pytest.raises(ZeroDivisionError):
        judge("s7-two-blocks", "LD I0.0\n= Q0.5")


def test_a_file_that_does_not_read_is_named_and_not_repeated(own) -> None:
    (own / "torn.toml").write_text(HIDDEN.replace("kind", "knd"), encoding="utf-8")
    (own / "bytes.toml").write_bytes(b"\xff\xfe watermark")
    for name in ("torn", "bytes"):
        with pytest.raises(DeclarationError, match=name) as caught:
            exercise(name)
        assert "watermark" not in str(caught.value)
        assert "watermark" not in repr([frame.f_locals for frame in _frames(caught.tb)])
    with pytest.raises(PlcTeachError):
        folder(own)


def _frames(tb):
    while tb is not None:
        if "test_hidden" not in tb.tb_frame.f_code.co_filename:
            yield tb.tb_frame
        tb = tb.tb_next


# Every kind.

WORDS = Text("考试", "Examination")
REFERENCE = "// watermark\n" + HIDDEN.split('"""')[1].split("watermark-4711")[1]
FULL = "// watermark\nLD I0.0\nO M27.1\nAN I0.6\n= M27.1\nAN I0.7\n= Q0.5\n"
GAPS = "LD I0.0\n____\nAN I0.6\n____\nAN I0.7\n= Q0.5\n"
FAULT = "LD I0.0\nAN I0.6\n= M0.0\nAN I0.7\n= Q0.5\n"
BLOCKS = "LD I0.0\nO I0.2\nLD I0.1\nA I0.4\nLD I0.3\nA I0.5\nOLD\nALD\n= Q0.0\n"
CHOICES = (
    "--[ I0.0 ]--[ I0.1 ]--( Q0.0 )",
    "--[ I0.0 ]--+--( Q0.0 )\n--[ I0.1 ]--+",
    "--[ I0.0 ]--[/I0.1 ]--( Q0.0 )",
)
LATE = "LD M0.0\n= Q0.0\nLD I0.0\n= M0.0\nNOT\n= Q0.1\n"
ON = tuple({"I0.0": one} for one in (0, 1, 1, 0, 0, 1))


def secret(kind: str, **fields) -> Exercise:
    values = {"dialect": "s7-200", "reference": REFERENCE, "right": (FULL,), **fields}
    return Exercise("secret", title=WORDS, task=WORDS, kind=kind, hidden=True, **values)


EVERY = {
    "write": secret("write"),
    "complete": secret("complete", start=GAPS),
    "bug": secret("bug", start=FAULT),
    "translate": secret("translate", source="fx", given="LD X0\nOR Y5\nANI X6\nANI X7\nOUT Y5\n"),
    "order": secret("order", distractors=("O I0.6",)),
    "predict": secret("predict", reference="", given=BLOCKS, scans=({"I0.0": 1, "I0.3": 1, "I0.5": 1},), levels=3),
    "join": secret("join", reference="", given=BLOCKS, row=8),
    "match": secret("match", reference="", given="LD I0.0\nAN I0.1\n= Q0.0\n", choices=CHOICES),
    "chart": secret("chart", reference="", given=LATE, scans=ON),
}
TOLD = {
    "write": list(ANSWERS.values()),
    "complete": [
        "",
        GAPS,
        GAPS.replace("____", "O M0.0", 1).replace("____", "= M0.1"),
        GAPS.replace("____", "NOT"),
        FAULT,
    ],
    "bug": ["", FAULT, FAULT.replace("AN I0.7", "O M0.0\nAN I0.7"), FAULT.replace("LD I0.0", "LD I0.0\nO M0.1")],
    "translate": ["", FAULT, FAULT.replace("LD I0.0", "LD I0.0\nO I0.1"), "LD X0"],
    "order": ["", "LD I0.0\n= Q0.5\n", "LD I0.0\nAN I0.6\n= Q0.5\n", "LD I0.0\nO I0.6\nAN I0.7\n= Q0.5\n", "LD I1.0"],
    "predict": ["", ". . .\n" * 9, "0 0 0\n" * 9, "1 1 1\n" * 9, "1 . .\n1 . .\n1 1 .\n", "2 2"],
    "join": ["", "1-2 3-4", "3-4 5-6", "7 8", "all"],
    "match": ["", "A", "B", "D", "A B"],
    "chart": ["", "Q0.0 000000", "Q0.0 111111\nQ0.1 111111", "Q0.0 011001\nQ0.1 001100", "Q0.0 0\nQ0.1 ??????"],
}
"""Answers none of which is right and none of which holds a whole row of the right one that it would not be told by itself."""


def held_back(kind: str) -> list[str]:
    """Give what nobody may read: marks of the reference and of the samples, or the rows of the answer as they are written."""
    if kind in {"write", "complete", "bug", "translate"}:
        return ["watermark", "M29.5", "M27.1"]
    if kind == "order":
        return [
            "watermark",
            "M29.5",
            "LD I0.0\nO M27.1",
            '"LD I0.0", "O M27.1"',
            "O M27.1\nAN I0.6",
            '"O M27.1", "AN I0.6"',
        ]
    if kind == "predict":  # by hand: A = 1, B = 0, C = 1
        return ["0 1 .", "1 0 1", "1 1 .", "≠"]
    return {"join": ["1-2 3-7", "3-7"], "match": ['"C"\n', "C."], "chart": ["00110", "001100", "10011", "≠"]}[kind]


def all_told(task: Exercise, answer: str) -> list[object]:
    """Gather everything that an answer brings forth, in both languages, but for the answer itself."""
    judged, score = judge(task, answer), grade(task, answer)
    said: list[object] = [repr(task), repr(shown(task)), repr(judged), repr(judged.verdict), verdict_json(judged)]
    said += [
        headline(judged).as_dict(),
        report_html(judged, "zh"),
        report_html(judged, "en"),
        score._repr_html_(),
        repr(score),
    ]
    said += [one.as_dict() for one in (*hints(judged), *judged.says)]
    for name, points, check in score.cases():
        said.append((name, points))
        try:
            check()
        except AssertionError as error:
            said.append(str(error))
    try:
        score.assert_correct()
    except AssertionError as error:
        said.append(str(error))
    return [*said, list(judged.wrong)]


def desk_told(task: Exercise, answer: str, *deeds: str) -> dict[str, object]:
    """Give what a desk has told when an answer has been typed, cell by cell, and some buttons have been pressed."""
    Path(".plcteach-progress.json").unlink(missing_ok=True)
    desk = ExerciseDesk(task)
    for end in range(len(answer) + 1):
        if end == len(answer) or not end % 7:
            desk.source = answer[:end]
            desk.serial += 1
    for deed in deeds:
        desk._asked(desk, {"type": deed}, None)
    state = {
        name: value for name, value in desk.get_state().items() if name not in {"_esm", "_css", "layout", "source"}
    }
    return {**state, "page": desk._repr_mimebundle_()[0]["text/html"], "repr": repr(desk)}


BUTTONS = ("model", "check", "show", "hint", "hint", "hint", "hint", "hint", "model", "restore", "check")


def test_every_kind_is_gone_over() -> None:
    assert tuple(EVERY) == tuple(TOLD) == NAMES
    assert model(EVERY["predict"]) == STACK
    for kind, task in EVERY.items():
        assert judge(task, model(task)).marks == 4, kind
        assert all(judge(task, answer).marks < 4 for answer in TOLD[kind] if kind != "write"), kind


@pytest.mark.parametrize("lang", ["zh", "en"])
@pytest.mark.parametrize("kind", NAMES)
def test_no_kind_tells_its_answer_before_or_after_an_attempt(kind: str, lang: str, monkeypatch) -> None:
    monkeypatch.setenv("PLCTEACH_LANG", lang)
    for answer in TOLD[kind]:
        told = [
            *all_told(EVERY[kind], answer),
            desk_told(EVERY[kind], answer),
            desk_told(EVERY[kind], answer, *BUTTONS),
        ]
        for one in told:
            plain = told_of(one)
            found = [each for each in held_back(kind) if each in plain and each not in answer]
            assert not found, (answer, found, plain)


STACK = "1 . .\n1 . .\n0 1 .\n0 1 .\n1 0 1\n1 0 1\n1 1 .\n1 . .\n1 . .\n"
ALIKE = {
    "predict": [f"{STACK[:at]}{1 - int(sign)}{STACK[at + 1 :]}" for at, sign in enumerate(STACK) if sign in "01"],
    "chart": [f"Q0.0 {one}\nQ0.1 100110\n" for one in ("101100", "011100", "000100", "001000", "001110", "001101")],
}
"""Answers that are wrong in one cell each, every one in another."""


def told_but_for_the_count(told: dict[str, object]) -> str:
    return re.sub(r'\\*"(?:serial|source|earlier)\\*": \d+', "", json.dumps(told, ensure_ascii=False))


@pytest.mark.parametrize("kind", ALIKE)
def test_where_a_hidden_grid_is_wrong_makes_no_difference_to_what_is_told(kind: str) -> None:
    task = EVERY[kind]
    begun = [desk_told(task, answer) for answer in [*ALIKE[kind], *TOLD[kind], model(task)]]
    assert len({told_but_for_the_count(one) for one in begun}) == 1
    assert all("marks" not in json.loads(str(one["report"])) for one in begun)
    same = ALIKE[kind]
    assert len({judge(task, answer).marks for answer in same}) == 1
    told = [json.dumps(all_told(task, answer), ensure_ascii=False) for answer in same]
    assert set(told) == {told[0]}
    desks = [desk_told(task, answer, *BUTTONS) for answer in same]
    assert len({told_but_for_the_count(one) for one in desks}) == 1


@pytest.mark.parametrize("way", ["judged", "shown", "model"])
@pytest.mark.parametrize("kind", NAMES)
def test_no_kind_tells_of_what_goes_wrong_inside_it(kind: str, way: str, monkeypatch) -> None:
    def failing(*_: object) -> None:
        raise ZeroDivisionError("inside " + model_answer)

    model_answer = model(EVERY[kind])
    monkeypatch.setattr(KINDS[kind], way, failing)
    with pytest.raises(PlcTeachError, match=r"has an error itself|自己有错误") as caught:
        {"judged": judge, "shown": lambda task, _: shown(task), "model": lambda task, _: model(task)}[way](
            EVERY[kind], "x"
        )
    assert "inside" not in str(caught.value)
    assert caught.value.__suppress_context__
    assert caught.value.__cause__ is None


def test_the_repr_of_an_exercise_is_short() -> None:
    assert len(repr(exercise("s7-two-blocks"))) < 80
    assert "reference" not in repr(exercise("s7-two-blocks"))
    assert Exercise.__repr__ is not object.__repr__


def test_a_model_answer_of_a_hidden_exercise_is_for_those_who_have_the_file() -> None:
    assert "M29.5" in model(exercise("exam-1")), "the one door, for a teacher; the desk and the reports do not open it"
