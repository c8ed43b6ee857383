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
_SUFFIXES = {".ipynb", ".md", ".png", ".py"}


def _source() -> Path:
    """Give the folder from which the lessons come: the checkout's own, else the installed package's."""
    for folder in (_PACKAGE.parent / "notebooks", _PACKAGE / "lessons"):
        if (folder / _INDEX).is_file():
            return folder
    msg = f"the lessons are missing from this installation ({_PACKAGE}); reinstall plcteach"
    raise PlcTeachError(msg)


def _files(source: Path) -> list[Path]:
    """List the lessons, their pictures, and what the example course needs beside its notebooks, relative to their folder."""
    found = [path for path in source.rglob("*") if path.suffix in _SUFFIXES and path.is_file()]
    return sorted(path.relative_to(source) for path in found if ".ipynb_checkpoints" not in path.parts)


def lessons(folder: Path | None = None) -> Path:
    """Give the folder with the lessons; installed ones are copied to `folder`, where nothing existing is overwritten."""
    source = _source()
    if folder is None and source.name == "notebooks":
        return source
    target = folder or Path("plcteach-lessons")
    for name in _files(source):
        copy = target / name
        if not copy.exists():
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source / name, copy)
    return target


def _trust(folder: Path) -> None:
    """Sign the lessons that are still ours, so that JupyterLab shows their saved pictures before anything has run."""
    source = _source()
    ours = [name for name in _files(source) if name.suffix == ".ipynb" and (folder / name).is_file()]
    books = [str(folder / name) for name in ours if (folder / name).read_bytes() == (source / name).read_bytes()]
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
