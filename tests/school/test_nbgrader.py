"""The example course under nbgrader itself: made, handed in, graded, given back, exported; and what each last expression gets.

Runs where the extra `school` is installed: pip install '.[school]' && python -m pytest tests/school
"""

from __future__ import annotations

import csv
import shutil
import sys
from pathlib import Path

import nbformat
import pytest

pytest.importorskip(
    "nbgrader", reason="nbgrader is not installed here: it has an environment of its own (extra `school`)"
)
sys.path.insert(0, str(Path(__file__).parent))

from schoolroom import BRANCHES, COURSE, RIGHT, WRONG, call, filled, graded, written

PREDICTED = "1 .\n1 .\n1 1\n0 1\n1 .\n1 ."
STRICT = "import warnings\nwarnings.simplefilter('error')\n"
ANSWERS = {
    "alice": {
        "blocks": f'{STRICT}program = """\n### BEGIN SOLUTION\n{RIGHT}\n### END SOLUTION\n"""',
        "branch": f"%%stl branch --exercise s7-branch\n{BRANCHES}",
        "predict": f"%%stl cells --exercise s7-predict-blocks\n{PREDICTED}",
    },
    "bob": {
        "blocks": f'{STRICT}program = """\n{WRONG}\n"""',
        "branch": "%%stl branch --exercise s7-branch\n" + BRANCHES.replace("I0.3", "I0.4"),
        "predict": "%%stl cells --exercise s7-predict-blocks\n" + PREDICTED.replace("0 1", "0 0"),
    },
    "carol": {},
}
VALUES = {
    "score": ("plc.grade('s7-branch', most)", pytest.approx(4 / 2 * 2 / 3, abs=0.01)),
    "float": ("2.5", 2.5),
    "int": ("3", 3),
    "zero": ("0", 0),
    "not_a_number": ("float('nan')", "full"),
    "false": ("False", "full"),
    "none": ("None", "full"),
    "nothing": ("marks = 2.5", "full"),
    "dict": ("{'marks': 2.5}", "full"),
    "text": ("'2.5'", "full"),
    "fraction": ("from fractions import Fraction\nFraction(5, 2)", "full"),
    "negative": ("-1.0", "full"),
    "judgement": ("plc.judge('s7-branch', most)", "full"),
    "score_that_is_none": ("plc.grade('s7-branch', most) and None", "full"),
    "said_on_stderr": ("import sys\nprint('a word', file=sys.stderr)\n4.0", 0),
    "warned": ("import warnings\nwarnings.warn('a word')\n4.0", 0),
    "raised": ("raise ValueError('a word')", 0),
    "asserted": ("plc.grade('s7-branch', most).assert_correct()", 0),
    "clamped_nan": ("from plcteach.check.score import Score\nScore(float('nan'), 4)", 0),
    "clamped_below": ("Score(-1, 4)", 0),
    "clamped_above": ("Score(9, 4)", 4),
}
"""What a graded cell ends with, and what nbgrader records of 4 points: FULL is why marks are a Score and nothing else."""


@pytest.fixture(scope="module")
def course(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("school") / "course"
    shutil.copytree(COURSE / "nbgrader", folder)
    table = [
        graded(name, ("import plcteach as plc\n" if not at else "") + source)
        for at, (name, (source, _)) in enumerate(VALUES.items())
    ]
    most = "most = '" + BRANCHES.replace("I0.3", "I0.4").replace("\n", "; ") + "'\n"
    table[0].source = most + table[0].source
    written(folder / "source" / "values" / "values.ipynb", table)
    written(folder / "source" / "over" / "over.ipynb", [graded("over", "4.5")])
    for assignment in ("ps1", "values", "over"):
        call(folder, "nbgrader", "generate_assignment", assignment)
    for name, answers in ANSWERS.items():
        filled(folder / "release" / "ps1" / "stack.ipynb", folder / "submitted" / name / "ps1" / "stack.ipynb", answers)
    for assignment in ("values", "over"):
        book = Path(assignment, f"{assignment}.ipynb")
        filled(folder / "release" / book, folder / "submitted" / "dora" / book, {})
    return folder


@pytest.fixture(scope="module")
def marks(course) -> dict[tuple[str, str], dict[str, float]]:
    from nbgrader.api import Gradebook

    call(course, "nbgrader", "autograde", "ps1")
    call(course, "nbgrader", "autograde", "values")
    with Gradebook(f"sqlite:///{course / 'gradebook.db'}") as book:
        return {
            (one.student.id, one.assignment.name): {
                grade.name: grade.score for notebook in one.notebooks for grade in notebook.grades
            }
            for one in book.assignments[0].submissions + book.find_assignment("values").submissions
            + book.find_assignment("ps1").submissions
        }  # fmt: skip


def test_the_released_notebook_holds_no_solution(course) -> None:
    book = nbformat.read(course / "release" / "ps1" / "stack.ipynb", 4)
    code = [cell.source for cell in book.cells if cell.cell_type == "code"]
    assert [one for one in code if "SOLUTION" in one or "OLD" in one or "LPS" in one or "0 1" in one] == []
    assert len([one for one in code if "your answer here" in one]) == 3


def test_full_marks_for_the_right_answers_and_none_for_no_answer(marks) -> None:
    assert marks["alice", "ps1"] == {"blocks-marks": 4, "branch-marks": 4, "predict-marks": 4}
    assert marks["carol", "ps1"] == {"blocks-marks": 0, "branch-marks": 0, "predict-marks": 0}


def test_partial_marks_are_recorded_as_they_are(marks) -> None:
    bob = marks["bob", "ps1"]
    assert bob["blocks-marks"] == 0
    assert bob["branch-marks"] == pytest.approx(4 / 2 * 2 / 3, abs=0.01)
    assert 0 < bob["predict-marks"] < 4


@pytest.mark.parametrize("name", VALUES)
def test_what_the_last_expression_of_a_cell_gets(marks, name: str) -> None:
    wanted = VALUES[name][1]
    assert marks["dora", "values"][name] == (4 if wanted == "full" else wanted)


def test_more_than_the_maximum_stops_the_grading_which_a_score_never_does(course, marks) -> None:
    assert "over" in call(course, "nbgrader", "autograde", "over", code=1)
    assert marks["dora", "values"]["clamped_above"] == 4


@pytest.mark.parametrize("name", ["alice", "bob"])
@pytest.mark.usefixtures("marks")
def test_nothing_stood_on_stderr_under_warnings_as_errors(course, name: str) -> None:
    book = nbformat.read(course / "autograded" / name / "ps1" / "stack.ipynb", 4)
    outputs = [one for cell in book.cells if cell.cell_type == "code" for one in cell.outputs]
    assert [one for one in outputs if one.output_type in {"stream", "error"}] == []


def test_the_counterexample_stands_in_the_feedback_and_the_marks_in_the_export(course, marks) -> None:
    call(course, "nbgrader", "generate_feedback", "ps1", "--student", "bob")
    page = (course / "feedback" / "bob" / "ps1" / "stack.html").read_text(encoding="utf-8")
    assert "Q0.0 should be 1" in page
    call(course, "nbgrader", "export")
    with (course / "grades.csv").open(encoding="utf-8", newline="") as file:
        rows = {(row["assignment"], row["student_id"]): float(row["score"]) for row in csv.DictReader(file)}
    assert rows["ps1", "alice"] == 12
    assert rows["ps1", "bob"] == pytest.approx(sum(marks["bob", "ps1"].values()))
    assert rows["ps1", "carol"] == 0
