"""Opens the lessons in JupyterLab: those of the checkout, or copies of the installed package's own."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from plcteach.core.errors import PlcTeachError

_PACKAGE = Path(__file__).parents[1]
_INDEX = "index.ipynb"


def lessons(folder: Path | None = None) -> Path:
    """Give the folder with the lessons; installed ones are copied to `folder`, where nothing existing is overwritten."""
    checkout = _PACKAGE.parent / "notebooks"
    if folder is None and (checkout / _INDEX).is_file():
        return checkout
    source = checkout if (checkout / _INDEX).is_file() else _PACKAGE / "lessons"
    if not (source / _INDEX).is_file():
        msg = f"the lessons are missing from this installation ({source}); reinstall plcteach"
        raise PlcTeachError(msg)
    target = folder or Path("plcteach-lessons")
    for path in sorted(source.rglob("*.ipynb")):
        copy = target / path.relative_to(source)
        if not copy.exists() and ".ipynb_checkpoints" not in path.parts:
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, copy)
    return target


def _trust(folder: Path) -> None:
    """Sign the lessons for this user, so that JupyterLab shows their saved pictures before anything has run."""
    books = [str(path) for path in sorted(folder.rglob("*.ipynb")) if ".ipynb_checkpoints" not in path.parts]
    subprocess.run([sys.executable, "-m", "nbformat.sign", *books], check=False, capture_output=True)  # noqa: S603


def open_lab(folder: Path | None = None, *, browser: bool = True) -> int:
    """Start JupyterLab on the lessons and wait until it is closed; Ctrl-C ends it."""
    if find_spec("jupyterlab") is None:
        msg = "JupyterLab is not installed here. Install it with: pip install 'plcteach[lab]'"
        raise PlcTeachError(msg)
    where = lessons(folder).resolve()
    _trust(where)
    command = [
        sys.executable,
        "-m",
        "jupyterlab",
        f"--ServerApp.root_dir={where}",
        f"--LabApp.default_url=/lab/tree/{_INDEX}",
    ]
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        command.append("--allow-root")  # in a container there often is no other user; the token still guards the server
    try:
        return subprocess.run([*command, *([] if browser else ["--no-browser"])], check=False).returncode  # noqa: S603
    except KeyboardInterrupt:
        return 0
