"""`plcteach grade`: a folder as a platform gives it out, to tables and pages; nothing in it stops, hangs or fools the grading."""

from __future__ import annotations

import csv
import json
import os
import re
import signal
import subprocess
import sys
import time
from html.parser import HTMLParser
from pathlib import Path

import pytest

from plcteach.check.judge import model
from plcteach.check.marking import mark as marks
from plcteach.check.marking.grading import How, grade_folder
from plcteach.check.marking.handed import MOST_BYTES, handed_in
from plcteach.check.marking.mark import Mark, mark_of, plain
from plcteach.check.marking.named import told_apart
from plcteach.check.marking.rows import histogram
from plcteach.check.marking.tables import cell
from plcteach.check.marking.workers import marked
from plcteach.check.score import grade
from plcteach.cli import main
from plcteach.core.text import Text
from plcteach.exercises import exercise, ids

RIGHT = "LD I0.0\nA I0.1\nLD I0.2\nAN I0.3\nOLD\n= Q0.0\n"
WRONG = "LD I0.0\nA I0.1\nO I0.2\nAN I0.3\n= Q0.0\n"
LONELY = "LD I0.0\nA I0.1\nOLD\nLD I0.2\nAN I0.3\n= Q0.0\n"
TASK = exercise("s7-two-blocks")
ID = TASK.id
MOODLE = "{}_{}_assignsubmission_file_/{}"
TYPED = "<head><title>LD I9.9</title></head><p>LD I0.0<br>A&nbsp;I0.1</p><p>LD I0.2</p><p>AN I0.3</p><p>OLD</p><div>= Q0.0</div>"
HANDED = {
    MOODLE.format("Alice Müller", 1, "x.txt"): RIGHT.encode(),
    MOODLE.format("李雷", 2, "程序.awl"): ("// 我的程序\r\n" + RIGHT.replace("\n", "\r\n")).encode("gbk"),
    MOODLE.format("韩梅梅", 3, "a.stl"): WRONG.encode("utf-16"),
    MOODLE.format("Bob", 4, "a.stl"): WRONG.encode(),
    MOODLE.format("Carol", 5, "photo.jpg"): b"\xff\xd8\0",
    MOODLE.format("Carol", 5, "p.txt"): LONELY.encode(),
    MOODLE.format("=1+1", 6, "p.txt"): b"<script>alert(1)</script>\nLD I0.0\n= Q0.0",
    MOODLE.format("Dora", 7, "p.zip"): b"PK",
    MOODLE.format("Frank", 9, "p.txt"): b"LD I0.0\n" * (MOST_BYTES // 8 + 1),
    MOODLE.format("Gina", 10, "p.mwp"): b"\0\1\2",
    MOODLE.format("Hans", 11, "p.txt"): b"",
    MOODLE.format("Ivan", 12, "a.txt"): WRONG.encode(),
    MOODLE.format("Ivan", 12, "b.txt"): RIGHT.encode(),
    "Judy_13_assignsubmission_onlinetext_/onlinetext.html": TYPED.encode(),
    "Kim_14_assignsubmission_file_kim.il": RIGHT.lower().encode(),
    "lee.stl": WRONG.replace("\n", "   \r\n").encode(),
    ".hidden": b"x",
    "__MACOSX/x.stl": b"x",
}
WANTED = {
    "Alice Müller": (4, "equal", ()),
    "李雷": (4, "equal", ()),
    "韩梅梅": (0, "different", ()),
    "Bob": (0, "different", ()),
    "Carol": (0, "error", ("STK001",)),
    "=1+1": (0, "error", ("RDR001",)),
    "Dora": (0, "error", ("HND001",)),
    "Eve": (0, "error", ("HND002",)),
    "Frank": (0, "error", ("RDR013",)),
    "Gina": (0, "error", ("FIL002",)),
    "Hans": (0, "error", ()),
    "Ivan": (4, "equal", ()),
    "Judy": (4, "equal", ()),
    "Kim": (4, "equal", ()),
    "lee": (0, "different", ()),
    "mallory": (0, "error", ("FIL001",)),
    "nick": (0, "error", ("FIL001",)),
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("handed") / "week 3"
    for name, data in HANDED.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    (folder / MOODLE.format("Eve", 8, "")).mkdir()
    (folder / "mallory.txt").symlink_to(Path(__file__))
    os.mkfifo(folder / "nick.txt")
    return folder


@pytest.fixture(scope="module")
def results(folder) -> Path:
    out = folder.with_name("out")
    assert main(["grade", str(folder), "--exercise", ID, "-o", str(out), "--lang", "en"]) == 0
    return out


def everything(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def learners(out: Path) -> dict[str, dict]:
    return {one["learner"]: one for one in json.loads((out / "results.json").read_text(encoding="utf-8"))["learners"]}


# What is read, and what it gets.


@pytest.mark.parametrize("name", WANTED)
def test_each_learner_has_a_row_whatever_they_handed_in(results, name: str) -> None:
    got, (points, status, codes) = learners(results)[name], WANTED[name]
    assert (got["marks"], got["status"]) == (points, status)
    assert set(codes) <= set(got["findings"])


def test_nobody_is_missing_and_nobody_came_from_nowhere(results) -> None:
    assert learners(results).keys() == WANTED.keys()


def test_the_marks_are_those_of_grade(results) -> None:
    for name, text in (("Alice Müller", RIGHT), ("Bob", WRONG), ("Carol", LONELY)):
        assert learners(results)[name]["marks"] == grade(TASK, text)


def test_of_several_answers_the_best_counts_and_the_others_are_named(results) -> None:
    ivan = learners(results)["Ivan"]
    assert ivan["file"].endswith("b.txt")
    assert [Path(one).name for one in ivan["others"]] == ["a.txt"]


def test_a_link_is_not_followed_out_of_the_folder(folder) -> None:
    (mallory,) = [one for one in handed_in(folder) if one.learner == "mallory"]
    assert mallory.text == ""


def test_the_folder_that_unpacking_made_around_the_others_is_passed_through(folder, tmp_path) -> None:
    (tmp_path / "outer" / "inner").mkdir(parents=True)
    (tmp_path / "outer" / "inner" / "week").symlink_to(folder)
    for name in ("Ann_1_assignsubmission_file_", "Ben"):
        (tmp_path / "unpacked" / "week 4" / name).mkdir(parents=True)
        (tmp_path / "unpacked" / "week 4" / name / "a.stl").write_text(RIGHT)
    assert [(one.learner, one.number) for one in handed_in(tmp_path / "unpacked")] == [("Ann", "1"), ("Ben", "")]
    assert [one.trouble.code for one in handed_in(tmp_path / "outer")] == ["FIL001"]


FIRST_OF_KIND = {exercise(one).kind: one for one in reversed(ids())}


@pytest.mark.parametrize("kind", FIRST_OF_KIND)
def test_every_kind_of_exercise_is_graded_and_its_mark_comes_back_from_the_file_as_it_was(kind: str) -> None:
    task = exercise(FIRST_OF_KIND[kind])
    for text in (model(task), "", "LD", task.wrong[0].program):
        mark = mark_of(task, plain(text))
        assert Mark.from_json(json.loads(json.dumps(mark.as_json()))) == mark
        assert mark.marks == grade(task, text)
        assert mark.codes != ("HND003",)
    assert mark_of(task, model(task)).marks == task.points


# The tables.


def test_the_csv_is_opened_by_spreadsheets_in_chinese_and_reckons_nothing(results) -> None:
    data = (results / "results.csv").read_bytes()
    assert data.startswith("\ufeff".encode())
    rows = {row["name"]: row for row in csv.DictReader(data.decode("utf-8-sig").splitlines())}
    assert "'=1+1" in rows
    assert "=1+1" not in rows
    assert (rows["李雷"]["number"], rows["李雷"]["marks"], rows["李雷"]["out of"]) == ("2", "4", "4")


@pytest.mark.parametrize("words", ["=1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", " =1", "＝1"])
def test_words_that_begin_like_a_formula_get_an_apostrophe(words: str) -> None:
    assert cell(words) == f"'{words}"


def test_other_words_stay() -> None:
    assert cell("李雷") == "李雷"
    assert cell("a=1") == "a=1"


@pytest.mark.parametrize(
    ("points", "marks_of", "bars"),
    [
        (4, [0, 0.5, 1, 3.99, 4], [2, 1, 0, 1, 1]),
        (2.5, [0.25, 2.5], [0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1]),
        (0, [0], [1, *[0] * 10]),
    ],
)
def test_the_bars_of_the_histogram(points: float, marks_of: list[float], bars: list[int]) -> None:
    from plcteach.check.marking.rows import Row

    rows = [Row("a", "", "", "", Mark("different", one, Text("", "")), "") for one in marks_of]
    assert [count for _, _, count in histogram(rows, points)] == bars


# The pages.


class Page(HTMLParser):
    """Collects what a page would fetch or run, and whether its tags close."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.fetched: list[str] = []
        self.links: list[str] = []
        self.open: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag, attrs) -> None:
        told = dict(attrs)
        if tag in {"script", "iframe", "object", "embed", "base", "form", "img"} or any(
            one.startswith("on") for one in told
        ):
            self.fetched.append(tag)
        if tag == "a":
            self.links.append(told["href"])
        elif "href" in told or "src" in told:
            self.fetched.append(tag)
        if tag not in {"meta", "br", "rect", "line", "path", "circle", "use", "polyline", "polygon"}:
            self.open.append(tag)

    def handle_endtag(self, tag) -> None:
        if tag in self.open:
            assert self.open.pop() == tag


def test_every_page_is_self_contained_and_runs_nothing(results) -> None:
    pages = [*results.rglob("*.html")]
    assert len(pages) == 1 + len(WANTED)
    for path in pages:
        text = path.read_text(encoding="utf-8")
        page = Page(text)
        assert page.fetched == []
        assert page.open == []
        assert "default-src 'none'" in text
        assert not re.search(r"url\(|@import", text)


def test_a_report_holds_its_own_text_and_marks_and_nobody_elses(results) -> None:
    reports = {name: (results / one["report"]).read_text(encoding="utf-8") for name, one in learners(results).items()}
    assert "Q0.0 should be 1" in reports["Bob"]
    assert "0 of 4" in reports["Bob"]
    assert "&lt;script&gt;alert(1)" in reports["=1+1"]
    for name, report in reports.items():
        assert name in report
        assert [other for other in WANTED if len(other) > 3 and other != name and other in report] == []


def test_the_class_page_links_to_every_report(results) -> None:
    from urllib.parse import unquote

    page = Page((results / "class.html").read_text(encoding="utf-8"))
    files = {unquote(one) for one in page.links if not one.startswith("#")}
    assert {f"reports/{path.name}" for path in (results / "reports").iterdir()} <= files
    assert all((results / one).is_file() for one in files)


def test_the_class_page_counts_mistakes_and_shows_identical_answers_together(results) -> None:
    told = json.loads((results / "results.json").read_text(encoding="utf-8"))
    assert told["class"]["findings"]["STK001"] == 1
    assert told["class"]["learners"] == len(WANTED)
    same = {name for name, one in learners(results).items() if one["group"] == learners(results)["Bob"]["group"]}
    assert same == {"Bob", "韩梅梅", "lee"}
    right = {name for name, one in learners(results).items() if one["group"] == learners(results)["Kim"]["group"]}
    assert right == {"Alice Müller", "李雷", "Ivan", "Judy", "Kim"}


def test_both_languages(folder, tmp_path) -> None:
    assert main(["grade", str(folder), "--exercise", ID, "-o", str(tmp_path), "--lang", "zh"]) == 0
    page = (tmp_path / "class.html").read_text(encoding="utf-8")
    assert '<html lang="zh-CN">' in page
    assert TASK.title.zh in page
    assert TASK.title.en not in page
    assert (tmp_path / "results.csv").read_text(encoding="utf-8-sig").startswith("姓名,编号,得分")


# Again, elsewhere, interrupted, stopped.


def test_the_same_folder_gives_the_same_bytes_in_one_process_or_several(folder, results, tmp_path) -> None:
    assert main(["grade", str(folder), "--exercise", ID, "-o", str(tmp_path), "--lang", "en", "--jobs", "3"]) == 0
    assert everything(tmp_path) == everything(results)


def test_a_second_run_judges_nothing_and_a_new_hand_in_only_itself(tmp_path) -> None:
    folder, out = tmp_path / "in", tmp_path / "out"
    folder.mkdir()
    for name, text in {"a": RIGHT, "b": WRONG, "c": RIGHT}.items():
        (folder / f"{name}.stl").write_text(text)
    first = grade_folder(folder, TASK, out, How(jobs=1))
    assert (first.distinct, first.judged) == (2, 2)
    again = grade_folder(folder, TASK, out, How(jobs=1))
    assert (again.rows, again.judged) == (first.rows, 0)
    (folder / "d.stl").write_text(LONELY)
    assert grade_folder(folder, TASK, out, How(jobs=1)).judged == 1


def test_no_mark_outlives_the_rules_that_gave_it(tmp_path, monkeypatch) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "in" / "a.stl").write_text(RIGHT)
    assert grade_folder(tmp_path / "in", TASK, tmp_path / "out", How(jobs=1)).judged == 1
    monkeypatch.setattr(marks, "version", lambda: "another")
    assert grade_folder(tmp_path / "in", TASK, tmp_path / "out", How(jobs=1)).judged == 1


RUN = "import sys; from plcteach.cli import main; raise SystemExit(main(sys.argv[1:]))"


def test_an_interrupted_run_keeps_what_it_has_and_goes_on(tmp_path) -> None:
    folder, out, other = tmp_path / "in", tmp_path / "out", tmp_path / "other"
    folder.mkdir()
    for at in range(200):
        more = f"LD I1.{at % 8}\n= M{at // 8}.{at % 8}\n"
        (folder / f"s{at:03}.stl").write_text(f"{RIGHT if at % 3 else WRONG}{more}")
    command = [sys.executable, "-W", "error", "-c", RUN, "grade", str(folder), "--exercise", ID, "--jobs", "1"]
    run = subprocess.Popen([*command, "-o", str(out)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    journal = out / ".plcteach-marks.jsonl"
    end = time.monotonic() + 60
    while time.monotonic() < end and not (journal.is_file() and journal.read_bytes().count(b"\n") > 5):
        time.sleep(0.005)
    run.send_signal(signal.SIGINT)
    said, err = run.communicate(timeout=60)
    assert (run.returncode, err) == (130, "")
    assert "the same command goes on" in said
    done = journal.read_bytes().count(b"\n")
    assert 5 < done < 200
    with journal.open("ab") as file:
        file.write(b'{"key": "cut sho')
    graded = grade_folder(folder, TASK, out, How(jobs=1))
    assert graded.judged <= 200 - done + 1
    assert graded.rows == grade_folder(folder, TASK, other, How(jobs=2)).rows
    assert journal.read_bytes() == (other / ".plcteach-marks.jsonl").read_bytes()


def _hangs(_exercise, text: str) -> Mark:
    """Stand in for judging, in the worker's own process: one text never ends, one kills its process."""
    if "hang" in text:
        time.sleep(1_000)
    if "die" in text:
        os._exit(7)
    return Mark("equal", 4.0, Text("", ""))


class Mended:
    """Travels to the worker in the place of an exercise and puts the stand-in there when it arrives."""

    def __reduce__(self):
        return (_mended, (str(Path(__file__).parent),))


def _mended(_where: str) -> str:
    from plcteach.check.marking import workers

    workers.mark_of = _hangs
    return ""


def test_a_text_that_hangs_or_kills_its_process_costs_its_own_row_only(monkeypatch) -> None:
    monkeypatch.syspath_prepend(str(Path(__file__).parent))
    import test_marking  # the worker finds the stand-in under this name

    texts = {"a": "hang", "b": "die", **{f"k{at}": f"text {at}" for at in range(8)}}
    start = time.monotonic()
    told = dict(marked(test_marking.Mended(), texts, jobs=2, seconds=1.0))
    assert told.keys() == texts.keys()
    assert (told["a"].codes, told["b"].codes) == (("HND003",), ("HND003",))
    assert "more than 1 seconds" in told["a"].headline.en
    assert "ended by itself" in told["b"].headline.en
    assert {told[f"k{at}"].status for at in range(8)} == {"equal"}
    assert time.monotonic() - start < 30


def test_a_fault_inside_is_a_row_and_not_kept(monkeypatch, tmp_path) -> None:
    def broken(*_: object) -> None:
        raise RecursionError

    monkeypatch.setattr(marks, "judge", broken)
    mark = mark_of(TASK, RIGHT)
    assert mark.codes == ("HND003",)
    assert "RecursionError" in mark.headline.en
    from plcteach.check.marking.kept import keep, kept

    assert dict(keep(tmp_path, [("k", mark)])) == {"k": mark}
    assert kept(tmp_path, {"k"}) == {}


# Names: whose a file is says the file system, not what can be shown of its name.

RAW = {
    "张三.stl".encode("gbk"): RIGHT,
    "李四.stl".encode("gbk"): LONELY,
    "王五.stl".encode("gbk"): WRONG,
    b"a\x07b.stl": RIGHT,
    b"a b.stl": WRONG,
    b"a\x06b.stl": LONELY,
    "赵六.stl".encode(): RIGHT,
    "赵六.stl".encode("gbk"): WRONG,
    b"\xff\xff.stl": RIGHT,
    b"\xff\xfe.stl": WRONG,
    "Mu\u0308ller.stl".encode(): RIGHT,
    "M\u00fcller.stl".encode(): WRONG,
    "孙七_21_assignsubmission_file_/一\a.stl".encode("gbk"): WRONG,
    "孙七_21_assignsubmission_file_/一 .stl".encode("gbk"): RIGHT,
    "孙七_22_assignsubmission_file_/二.stl".encode("gbk"): WRONG,
    "周八_23_assignsubmission_file_".encode() + "王.stl".encode("gbk"): WRONG,
    "周八_23_assignsubmission_file_a.stl".encode(): RIGHT,
}
MIXED = "周八_23_assignsubmission_file_".encode().decode("gbk") + "王.stl"
NAMED = {
    ("张三", ""): (4, "张三.stl", []),
    ("李四", ""): (0, "李四.stl", []),
    ("王五", ""): (0, "王五.stl", []),
    ("a b", ""): (0, "a b.stl", []),
    ("a b (2)", ""): (0, "a b.stl (2)", []),
    ("a b (3)", ""): (4, "a b.stl (3)", []),
    ("赵六", ""): (4, "赵六.stl", []),
    ("赵六 (2)", ""): (0, "赵六.stl (2)", []),
    ("\\xff\\xff", ""): (4, "\\xff\\xff.stl", []),
    ("\\xff\\xfe", ""): (0, "\\xff\\xfe.stl", []),
    ("Mu\u0308ller", ""): (4, "Mu\u0308ller.stl", []),
    ("M\u00fcller (2)", ""): (0, "M\u00fcller.stl (2)", []),
    ("孙七", "21"): (
        4,
        "孙七_21_assignsubmission_file_/一 .stl (2)",
        ["孙七_21_assignsubmission_file_/一 .stl"],
    ),
    ("孙七", "22"): (0, "孙七_22_assignsubmission_file_/二.stl", []),
    ("周八", "23"): (4, "周八_23_assignsubmission_file_a.stl", [MIXED]),
}
raw_names = pytest.mark.skipif(sys.platform != "linux", reason="file names are text there")


def put(folder: Path, names: dict[bytes, str]) -> Path:
    for name, text in names.items():
        path = Path(os.fsdecode(os.fsencode(folder) + b"/" + name))
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


def graded(folder: Path, out: Path) -> list[dict]:
    command = [sys.executable, "-W", "error", "-c", RUN, "grade", str(folder), "--exercise", ID, "-o", str(out)]
    done = subprocess.run([*command, "--lang", "en", "--jobs", "1"], capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    return json.loads((out / "results.json").read_text(encoding="utf-8"))["learners"]


@raw_names
def test_learners_whose_names_are_no_text_or_look_alike_stay_different_learners(tmp_path) -> None:
    rows = graded(put(tmp_path / "in", RAW), tmp_path / "out")
    assert {(one["learner"], one["number"]): (one["marks"], one["file"], one["others"]) for one in rows} == NAMED
    table = (tmp_path / "out" / "results.csv").read_text(encoding="utf-8-sig").splitlines()
    told = [(row["name"], row["number"], float(row["marks"]), row["report"]) for row in csv.DictReader(table)]
    assert told == [(one["learner"], one["number"], one["marks"], one["report"]) for one in rows]


@raw_names
def test_each_of_them_has_a_report_of_their_own_and_the_class_page_links_it(tmp_path) -> None:
    from urllib.parse import unquote

    out = tmp_path / "out"
    rows = graded(put(tmp_path / "in", RAW), out)
    assert len({one["report"].casefold() for one in rows}) == len(NAMED)
    assert {path.name for path in (out / "reports").iterdir()} == {Path(one["report"]).name for one in rows}
    assert (out / "reports" / "张三.html").is_file()
    for one in rows:
        report = (out / one["report"]).read_text(encoding="utf-8")
        assert f"<strong>{one['learner']}</strong>" in report
        assert f"{one['marks']:g} of 4" in report
    page = (out / "class.html").read_text(encoding="utf-8")
    names = dict(re.findall(r'<a href="(reports/[^"]*)">([^<]*)</a>', page))
    assert {unquote(link): name for link, name in names.items()} == {one["report"]: one["learner"] for one in rows}
    groups = {(one["learner"], one["number"]): one["group"] for one in rows}
    right = {who for who, group in groups.items() if group == groups["张三", ""]}
    assert right == {who for who, (points, *_) in NAMED.items() if points}


@raw_names
def test_their_marks_do_not_wander_when_the_run_goes_on_or_begins_anew(tmp_path) -> None:
    first = dict(list(RAW.items())[::2])
    out, other = tmp_path / "out", tmp_path / "other"
    folder = put(tmp_path / "in", first)
    graded(folder, out)
    again = graded(put(folder, RAW), out)
    assert again == graded(put(tmp_path / "in again", dict(reversed(RAW.items()))), other)
    assert everything(out) == everything(other)
    graded(folder, out)
    assert everything(out) == everything(other)


@raw_names
def test_a_name_that_is_utf_8_by_chance_is_read_as_the_names_beside_it(tmp_path) -> None:
    chance = "模一.stl"
    assert chance.encode("gbk").decode("utf-8") != chance
    put(tmp_path, {chance.encode("gbk"): RIGHT, "Müller.stl".encode(): RIGHT, "赵六.stl".encode(): RIGHT})
    assert "模一" not in {one.learner for one in handed_in(tmp_path)}
    put(tmp_path, {"张三.stl".encode("gbk"): RIGHT})
    assert {one.learner for one in handed_in(tmp_path)} == {"模一", "Müller", "赵六", "张三"}


def test_two_learners_of_one_name_are_told_apart_by_their_numbers(tmp_path) -> None:
    for number, text in ((5, RIGHT), (6, WRONG)):
        put(tmp_path, {MOODLE.format("张伟", number, "a.stl").encode(): text})
    assert [(one.learner, one.number) for one in handed_in(tmp_path)] == [("张伟", "5"), ("张伟", "6")]


def test_a_name_that_has_a_count_already_keeps_it() -> None:
    names = {(one, ""): (one, "") for one in ("a b (2)", "a\tb", "a\rb", "a b")}
    given = {raw: name for (raw, _), name in told_apart(names).items()}
    assert given == {"a b": "a b", "a b (2)": "a b (2)", "a\tb": "a b (3)", "a\rb": "a b (4)"}


# What is a document of another kind.

DOCUMENTS = {
    "a.pdf": ("PDF文档", "a PDF document (.pdf)"),
    "a.PDF": ("PDF文档", "a PDF document (.pdf)"),
    "a.doc": ("文字处理软件的文档", "a word processor's document (.doc)"),
    "a.docx": ("文字处理软件的文档", "a word processor's document (.docx)"),
    "a.odt": ("文字处理软件的文档", "a word processor's document (.odt)"),
    "a.wps": ("文字处理软件的文档", "a word processor's document (.wps)"),
    "a.ipynb": ("Jupyter笔记本", "a Jupyter notebook (.ipynb)"),
    "a.png": ("图片", "a picture (.png)"),
    "a.jpeg": ("图片", "a picture (.jpeg)"),
}


@pytest.mark.parametrize("name", DOCUMENTS)
@pytest.mark.parametrize("size", [8, MOST_BYTES + 8])
def test_a_document_is_called_what_it_is_and_the_list_is_asked_for_as_text(tmp_path, name: str, size: int) -> None:
    (tmp_path / name).write_bytes(b"%PDF-1.7\0" + b"\1" * size)
    (one,) = handed_in(tmp_path)
    assert one.trouble.code == "FIL002"
    zh, en = DOCUMENTS[name]
    assert zh in one.trouble.text.zh
    assert en in one.trouble.text.en
    assert "指令表本身" in one.trouble.text.zh
    assert "the list itself" in one.trouble.text.en
    assert "project" not in one.trouble.text.en


@pytest.mark.parametrize("name", ["a.zip", "a.rar", "a.7z"])
def test_an_archive_is_called_one(tmp_path, name: str) -> None:
    (tmp_path / name).write_bytes(b"PK\0\1")
    assert [one.trouble.code for one in handed_in(tmp_path)] == ["HND001"]


def test_what_only_may_be_a_project_is_not_called_a_document(tmp_path) -> None:
    (tmp_path / "a.mwp").write_bytes(b"\0\1")
    (one,) = handed_in(tmp_path)
    assert "most likely it is a project" in one.trouble.text.en


def test_lint_of_a_folder_says_the_same_of_a_document(tmp_path, capsys) -> None:
    for name in ("a.odt", "b.rar", "c.mwp"):
        (tmp_path / name).write_bytes(b"PK\0\1")
    assert main(["lint", str(tmp_path), "--dialect", "s7-200", "--json", "--lang", "en"]) == 1
    said = {name: one["text"] for name, (one,) in json.loads(capsys.readouterr().out).items()}
    assert "a word processor's document (.odt)" in said["a.odt"]
    assert "an archive (.rar)" in said["b.rar"]
    assert "project" in said["c.mwp"]


# The call.


def test_nothing_on_stderr_but_the_bar_of_a_terminal(folder, tmp_path) -> None:
    command = [sys.executable, "-W", "error", "-c", RUN, "grade", str(folder), "--exercise", ID, "-o", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_person_at_the_terminal_sees_a_bar(folder, tmp_path, monkeypatch, capsys) -> None:
    monkeypatch.setattr(type(sys.stderr), "isatty", lambda _: True, raising=False)
    assert main(["grade", str(folder), "--exercise", ID, "-o", str(tmp_path)]) == 0
    assert "/" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["{folder}", "--exercise", "s7-two-block"], "s7-two-blocks"),
        (["{folder}/nowhere", "--exercise", ID], "there is no folder"),
        (["{folder}/lee.stl", "--exercise", ID], "wants the folder"),
        (["{folder}/" + MOODLE.format("Dora", 7, "p.zip"), "--exercise", ID], "unpack it"),
        (["{folder}", "--exercise", ID, "-o", "{folder}"], "a folder of their own"),
        (["{folder}", "--exercise", ID, "--jobs", "0"], "no number from 1"),
        (["{folder}"], "--exercise"),
    ],
)
def test_a_wrong_call_says_what_to_do(folder, words: list[str], said: str, capsys) -> None:
    assert main(["grade", *(one.replace("{folder}", str(folder)) for one in words)]) == 2
    assert said in capsys.readouterr().err


def test_json_and_nothing_but_json(folder, tmp_path, capsys) -> None:
    assert main(["grade", str(folder), "--exercise", ID, "-o", str(tmp_path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["class"]["learners"] == len(WANTED)


def test_a_cluster_wants_its_extra(folder, tmp_path, capsys, monkeypatch) -> None:
    monkeypatch.setattr("plcteach.check.marking.cluster.find_spec", lambda _: None)
    call = ["grade", str(folder), "--exercise", ID, "-o", str(tmp_path), "--cluster", "tcp://127.0.0.1:9"]
    assert main(call) == 2
    assert "plcteach[cluster]" in capsys.readouterr().err


def test_an_empty_folder_is_graded_too(tmp_path, capsys) -> None:
    (tmp_path / "in").mkdir()
    assert main(["grade", str(tmp_path / "in"), "--exercise", ID, "--lang", "en"]) == 0
    assert "nothing to grade" in capsys.readouterr().out
    assert (tmp_path / "in-marks" / "class.html").is_file()


def test_results_inside_the_folder_are_not_graded_again(tmp_path) -> None:
    (tmp_path / "a.stl").write_text(RIGHT)
    for _ in range(2):
        assert main(["grade", str(tmp_path), "--exercise", ID, "-o", str(tmp_path / "marks")]) == 0
        assert learners(tmp_path / "marks").keys() == {"a"}
