"""Executes the notebooks and writes them in one normal form, so that building twice changes no byte.

The exercise books, and the exercises in the index and at the end of each lesson, are made from the catalogue before that.

python tests/notebooks/build.py            build all notebooks in place
python tests/notebooks/build.py --check    only say which ones a build would change; exit code 1 if there are any
Further words name the notebooks to be built, if not all of them are wanted: a part of their path is enough.
"""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient

sys.path.insert(0, str(Path(__file__).parent))
import exercise_books

FOLDER = exercise_books.FOLDER
WIDGET_VIEW = "application/vnd.jupyter.widget-view+json"
KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}
_FOLD = "jupyter"
_SECONDS = 120


def notebooks() -> list[Path]:
    """Give every notebook, in order of path; the graders' course has its own form and its own tests."""
    found = {*FOLDER.rglob("*.ipynb"), *exercise_books.paths()}
    return sorted(path for path in found if not {".ipynb_checkpoints", "course"} & {*path.relative_to(FOLDER).parts})


def executed(path: Path) -> Any:
    """Run a notebook from the top in a fresh kernel; nothing of a widget's state and nobody's progress is kept."""
    book = exercise_books.source(path)
    with tempfile.TemporaryDirectory() as nobody:
        NotebookClient(
            book,
            timeout=_SECONDS,
            kernel_name=KERNEL["name"],
            resources={"metadata": {"path": str(path.parent)}},
            store_widget_state=False,
            record_timing=False,
        ).execute(env={**os.environ, "PLCTEACH_PROGRESS": str(Path(nobody) / "progress.json")})
    return book


def normal(book: Any) -> str:
    """Write a notebook out without anything that depends on the machine, the moment or the editor that saved it."""
    book.metadata = nbformat.from_dict({"kernelspec": KERNEL, "language_info": {"name": "python"}})
    for number, cell in enumerate(book.cells):
        cell.id = f"c{number:03d}"
        folded = cell.metadata.get(_FOLD, {}).get("outputs_hidden")
        cell.metadata = nbformat.from_dict({_FOLD: {"outputs_hidden": True}} if folded else {})
        for output in cell.get("outputs", []):
            output.get("data", {}).pop(WIDGET_VIEW, None)
    return str(nbformat.writes(book, 4)).rstrip("\n") + "\n"


def main(words: list[str]) -> int:
    """Build, or with --check only compare; give the exit code."""
    changed = []
    wanted = [word for word in words if word != "--check"]
    for path in notebooks():
        if wanted and not any(word in path.relative_to(FOLDER).as_posix() for word in wanted):
            continue
        text = normal(executed(path))
        if not path.exists() or text != path.read_text(encoding="utf-8"):
            changed.append(path)
            if "--check" not in words:
                path.write_text(text, encoding="utf-8", newline="\n")
    sys.stdout.writelines(f"{path.relative_to(FOLDER)}\n" for path in changed)
    return 1 if changed and "--check" in words else 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
