"""The example assignment under otter-grader itself: assigned, and run on a right and a partly right answer."""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path

import nbformat
import pytest

pytest.importorskip(
    "otter", reason="otter-grader is not installed here: it has an environment of its own (extra `school`)"
)
sys.path.insert(0, str(Path(__file__).parent))

from schoolroom import BRANCHES, COURSE, RIGHT, WRONG, call, filled

ANSWERS = {
    "alice": ({"program": RIGHT, "branch": BRANCHES}, {"blocks": 4, "branch": 4}),
    "bob": ({"program": WRONG, "branch": BRANCHES.replace("I0.3", "I0.4")}, {"blocks": 0, "branch": 1.33}),
}


@pytest.fixture(scope="module")
def assigned(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("otter")
    shutil.copy(COURSE / "otter" / "stack.ipynb", folder)
    call(folder, "otter", "assign", "stack.ipynb", "dist")
    return folder / "dist"


def test_the_students_notebook_holds_no_solution_and_its_checks(assigned) -> None:
    book = nbformat.read(assigned / "student" / "stack.ipynb", 4)
    code = [cell.source for cell in book.cells if cell.cell_type == "code"]
    assert [one for one in code if "OLD" in one or "LPS" in one or "SOLUTION" in one] == []
    assert 'grader.check("blocks")' in code
    assert 'grader.check("branch")' in code


@pytest.mark.parametrize("name", ANSWERS)
def test_the_marks_of_each_question(assigned, tmp_path, name: str) -> None:
    answers, wanted = ANSWERS[name]
    cells = {variable: f"{variable} = '''\n{text}\n'''" for variable, text in answers.items()}
    filled(assigned / "student" / "stack.ipynb", tmp_path / "stack.ipynb", cells)
    (archive,) = (assigned / "autograder").glob("*.zip")
    call(tmp_path, "otter", "run", "-a", archive, "-o", tmp_path, "stack.ipynb")
    tests = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))["tests"]
    scores = {one["name"]: one["score"] for one in tests if one["name"] in wanted}
    assert scores == pytest.approx(wanted)
    if name == "bob":
        assert "Q0.0 should be 1" in json.dumps(tests)
