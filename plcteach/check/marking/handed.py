"""What was handed in: the files of a folder as a learning platform packs them, whose they are, and the text in each."""

from __future__ import annotations

import os
import re
import stat
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from plcteach.check.files import document, no_text, project, unread
from plcteach.check.marking.named import readable, told_apart
from plcteach.check.marking.webtext import web_text
from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.source import Span, decode
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Iterator

MOST_BYTES = 400_000
"""A longer file is no answer to an exercise: it is named in its row, and not read."""

_PLATFORM = re.compile(r"(?P<name>.+?)_(?P<number>\d+)_assignsubmission_(?:file|onlinetext)(?:_.*)?", re.DOTALL)
_ARCHIVES = re.compile(r"zip|rar|7z|tar|gz|tgz|bz2|xz")
_OF_THE_SYSTEM = {"__MACOSX", "Thumbs.db", "desktop.ini"}


@dataclass(frozen=True, slots=True)
class HandIn:
    """One file: whose it is, the number that the platform gave them, its path in the folder, and its text or what is wrong with it.

    `learner` and `file` are shown; `owner` tells one learner from another: their name, as the file system has it, and the number.
    """

    owner: tuple[str, str]
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
    paths = {path: path.relative_to(folder) for path in _files(folder, without)}
    owners = {path: _learner(name) for path, name in paths.items()}
    words = readable(
        [*(name for name, _ in owners.values()), *(part for name in paths.values() for part in name.parts)]
    )
    learners = told_apart({(name, number): (words[name], number) for name, number in owners.values()})
    files = told_apart(
        {(name.as_posix(), ""): ("/".join(words[part] for part in name.parts), "") for name in paths.values()}
    )
    found = [
        _handed(path, owners[path], (learners[owners[path]], files[name.as_posix(), ""]), encoding)
        for path, name in paths.items()
    ]
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


def _handed(path: Path, owner: tuple[str, str], shown: tuple[str, str], encoding: str | None) -> HandIn:
    learner, file = shown
    read = _read(path, encoding)
    text, trouble = (read, None) if isinstance(read, str) else ("", read)
    return HandIn(owner, learner, owner[1], file, text, trouble)


def _learner(path: Path) -> tuple[str, str]:
    """Say whose a file is: the platform's name and number, else the folder's name, else the file's."""
    first = path.parts[0]
    match = _PLATFORM.fullmatch(first)
    if match:
        return match["name"], match["number"]
    return (first if len(path.parts) > 1 or not path.suffix else path.stem), ""


def _read(path: Path, encoding: str | None) -> str | Diagnostic:
    """Give the text of a file, or the finding that says why there is none; links are not followed out of the folder."""
    kind = path.suffix[1:].lower()
    typed_in = "onlinetext" in path.as_posix() and kind in {"html", "htm"}
    try:
        refused = _refused(path.lstat(), "" if typed_in else kind)
        data = b"" if refused else path.read_bytes()
    except OSError as trouble:
        return unread(trouble)
    if refused:
        return refused
    if no_text(data):
        return project()
    text = decode(data, encoding)
    return web_text(text) if typed_in else text


def _refused(about: os.stat_result, kind: str) -> Diagnostic | None:
    """Say why something is not even opened: no file, an archive, a document, too long."""
    if stat.S_ISDIR(about.st_mode):
        return _said("HND002")
    if not stat.S_ISREG(about.st_mode):
        return _said("FIL001", reason=_NO_FILE)
    if _ARCHIVES.fullmatch(kind):
        return _said("HND001", kind=f".{kind}")
    if told := document(kind):
        return told
    if about.st_size > MOST_BYTES:
        return _said("RDR013", size=f"{about.st_size:,} B", most=f"{MOST_BYTES:,} B")
    return None


_NO_FILE = Text("它是链接或设备，不是文件", "it is a link or a device and no file")


def _said(code: str, **values: object) -> Diagnostic:
    return rule(code).at(Span(1), **values)
