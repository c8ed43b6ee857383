"""What the tests of the graders share: commands of this environment, and notebooks made and filled in."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import nbformat
from nbformat.v4 import new_code_cell, new_notebook

COURSE = Path(__file__).parents[2] / "notebooks" / "course"
KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}
RIGHT = "LD I0.0\nA I0.1\nLD I0.2\nAN I0.3\nOLD\n= Q0.0"
WRONG = "LD I0.0\nA I0.1\nO I0.2\nAN I0.3\n= Q0.0"
BRANCHES = "LD I0.0\nO I0.5\nLPS\nA I0.1\n= Q0.0\nLRD\nA I0.2\n= Q0.1\nLPP\nA I0.3\n= Q0.2"


def call(folder: Path, *words: str | Path, code: int = 0) -> str:
    """Run a command of this environment in a folder; give its output, both streams of it."""
    scripts = Path(sys.executable).parent
    told = {name: value for name, value in os.environ.items() if not name.startswith(("LC_", "LANG", "PLCTEACH_LANG"))}
    told |= {"PATH": f"{scripts}{os.pathsep}{told['PATH']}", "JUPYTER_PREFER_ENV_PATH": "1", "PLCTEACH_LANG": "en"}
    done = subprocess.run(
        [scripts / words[0], *words[1:]], cwd=folder, capture_output=True, text=True, check=False, env=told, timeout=300
    )
    assert done.returncode == code, done.stdout[-4000:] + done.stderr[-8000:]
    return done.stdout + done.stderr


def filled(source: Path, target: Path, answers: dict[str, str]) -> None:
    """Copy a notebook with other text in some cells: those with this grade_id, or those whose source begins so."""
    book = nbformat.read(source, 4)
    for cell in book.cells:
        name = cell.metadata.get("nbgrader", {}).get("grade_id") or cell.source.split("=")[0].strip()
        if name in answers:
            cell.source = answers[name]
    target.parent.mkdir(parents=True, exist_ok=True)
    nbformat.write(book, target)


def graded(name: str, source: str, points: float = 4) -> object:
    """Make a cell whose last expression nbgrader takes for its marks."""
    told = {
        "schema_version": 3, "grade_id": name, "grade": True, "solution": False, "locked": True, "task": False,
        "points": points, "cell_type": "code",
    }  # fmt: skip
    return new_code_cell(source, metadata={"nbgrader": told})


def written(path: Path, cells: list[object]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    nbformat.write(new_notebook(cells=cells, metadata={"kernelspec": KERNEL}), path)
