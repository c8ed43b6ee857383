"""What was handed in: the files of a folder as a learning platform packs them, whose they are, and the text in each."""

from __future__ import annotations

import os
import re
import stat
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from plcteach.check.files import no_text, unread
from plcteach.check.marking.webtext import web_text
from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.source import Span, decode, printable
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Iterator

MOST_BYTES = 400_000
"""A longer file is no answer to an exercise: it is named in its row, and not read."""

_PLATFORM = re.compile(r"(?P<name>.+?)_(?P<number>\d+)_assignsubmission_(?:file|onlinetext)(?:_.*)?", re.DOTALL)
_ARCHIVES = re.compile(r"zip|rar|7z|tar|gz|tgz|bz2|xz")
_NO_TEXTS = re.compile(r"bmp|docx?|exe|gif|heic|html?|ipynb|jpe?g|mp4|mov|odt|pdf|png|pptx?|py|svg|webp|xlsx?")
_OF_THE_SYSTEM = {"__MACOSX", "Thumbs.db", "desktop.ini"}


@dataclass(frozen=True, slots=True)
class HandIn:
    """One file: whose it is, the number that the platform gave them, its path in the folder, and its text or what is wrong with it."""

    learner: str
    number: str
    file: str
    text: str = ""
    trouble: Diagnostic | None = None


def handed_in(folder: Path, encoding: str | None = None, without: Path | None = None) -> list[HandIn]:
    """Read a folder in order of the learners' names; nothing in it stops the reading. `without`: a folder inside that is left out.

    A folder for each learner (`Name_1234_assignsubmission_file_`, or just a name), or files named for their learners.
    """
    folder = _inner(folder, without)
    found = [_handed(folder, path, encoding) for path in _files(folder, without)]
    return sorted(found, key=lambda one: (one.learner.casefold(), one.learner, one.number, one.file))


def _inner(folder: Path, without: Path | None) -> Path:
    """Go into a folder that holds nothing but another with folders in it, as unpacking often makes them."""
    seen = [one for one in folder.iterdir() if not _passed_over(one.name) and one.resolve() != without]
    alone = len(seen) == 1 and seen[0].is_dir() and not seen[0].is_symlink() and not _PLATFORM.fullmatch(seen[0].name)
    if alone and any(one.is_dir() for one in seen[0].iterdir()):
        return _inner(seen[0], without)
    return folder


def _files(folder: Path, without: Path | None) -> Iterator[Path]:
    """Give the files that somebody may have handed in, and the folders of those who handed in none."""
    empty = [Path(each.path) for each in os.scandir(folder) if each.is_dir() and not _passed_over(each.name)]
    full = set()
    for where, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if not _passed_over(name) and Path(where, name).resolve() != without]
        for name in names:
            if not _passed_over(name):
                path = Path(where, name)
                full.add(path.relative_to(folder).parts[0])
                yield path
    yield from (path for path in empty if path.name not in full and path.resolve() != without)


def _passed_over(name: str) -> bool:
    return name.startswith(".") or name in _OF_THE_SYSTEM


def _handed(folder: Path, path: Path, encoding: str | None) -> HandIn:
    name = path.relative_to(folder).as_posix()
    learner, number = _learner(path.relative_to(folder))
    read = _read(path, encoding)
    text, trouble = (read, None) if isinstance(read, str) else ("", read)
    return HandIn(_shown(learner), number, _shown(name), text, trouble)


def _learner(path: Path) -> tuple[str, str]:
    """Say whose a file is: the platform's name and number, else the folder's name, else the file's."""
    first = path.parts[0]
    match = _PLATFORM.fullmatch(first)
    if match:
        return match["name"], match["number"]
    return (first if len(path.parts) > 1 or not path.suffix else path.stem), ""


def _shown(name: str) -> str:
    """Make a name of a file showable everywhere: no sign that a terminal obeys, none that no encoding has."""
    return printable(name.encode("utf-8", "replace").decode("utf-8"))


def _read(path: Path, encoding: str | None) -> str | Diagnostic:
    """Give the text of a file, or the finding that says why there is none; links are not followed out of the folder."""
    kind = path.suffix[1:].lower()
    try:
        refused = _refused(path.lstat(), kind)
        data = b"" if refused else path.read_bytes()
    except OSError as trouble:
        return unread(trouble)
    if refused:
        return refused
    typed_in = "onlinetext" in path.as_posix() and kind in {"html", "htm"}
    if no_text(data) or (_NO_TEXTS.fullmatch(kind) and not typed_in):
        return _said("FIL002")
    text = decode(data, encoding)
    return web_text(text) if typed_in else text


def _refused(about: os.stat_result, kind: str) -> Diagnostic | None:
    """Say why something is not even opened: no file, an archive, too long."""
    if stat.S_ISDIR(about.st_mode):
        return _said("HND002")
    if not stat.S_ISREG(about.st_mode):
        return _said("FIL001", reason=_NO_FILE)
    if _ARCHIVES.fullmatch(kind):
        return _said("HND001", kind=f".{kind}")
    if about.st_size > MOST_BYTES:
        return _said("RDR013", size=f"{about.st_size:,} B", most=f"{MOST_BYTES:,} B")
    return None


_NO_FILE = Text("它是链接或设备，不是文件", "it is a link or a device and no file")


def _said(code: str, **values: object) -> Diagnostic:
    return rule(code).at(Span(1), **values)
