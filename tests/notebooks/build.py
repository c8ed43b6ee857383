"""Executes the lessons and writes them in one normal form, so that building twice changes no byte.

python tests/notebooks/build.py            build all notebooks in place
python tests/notebooks/build.py --check    only say which ones a build would change; exit code 1 if there are any
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient

FOLDER = Path(__file__).resolve().parents[2] / "notebooks"
WIDGET_VIEW = "application/vnd.jupyter.widget-view+json"
KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}
_FOLD = "jupyter"
_SECONDS = 120


def notebooks() -> list[Path]:
    """Give every lesson that is committed, in order of path; the graders' course has its own form and its own tests."""
    return sorted(
        path
        for path in FOLDER.rglob("*.ipynb")
        if not {".ipynb_checkpoints", "course"} & {*path.relative_to(FOLDER).parts}
    )


def executed(path: Path) -> Any:
    """Run a notebook from the top in a fresh kernel; nothing of a widget's state is kept."""
    book = nbformat.read(path, 4)
    NotebookClient(
        book,
        timeout=_SECONDS,
        kernel_name=KERNEL["name"],
        resources={"metadata": {"path": str(path.parent)}},
        store_widget_state=False,
        record_timing=False,
    ).execute()
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
    for path in notebooks():
        text = normal(executed(path))
        if text != path.read_text(encoding="utf-8"):
            changed.append(path)
            if "--check" not in words:
                path.write_text(text, encoding="utf-8", newline="\n")
    sys.stdout.writelines(f"{path.relative_to(FOLDER)}\n" for path in changed)
    return 1 if changed and "--check" in words else 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
