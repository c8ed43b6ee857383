"""Lints every file of a folder that may be a program; a file that cannot be read is a finding like any other."""

from __future__ import annotations

import os
import re
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from plcteach.check.files import document, no_text, project, unread
from plcteach.check.lint import lint
from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.errors import NotRepresentableError
from plcteach.core.program import Program
from plcteach.core.source import MOST_CHARACTERS, Span, decode
from plcteach.core.text import NOTHING, Text
from plcteach.dialects import families
from plcteach.ladder.either import read_either
from plcteach.stl.symbols import is_symbols, read_symbols

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.spec import Dialect
    from plcteach.stl.symbols import Symbols

_NO_PROGRAMS = re.compile(
    r"bmp|css|docx?|exe|gif|html?|ini|ipynb|jpe?g|js|json|md|mp4|pdf|png|pptx?|pyc?|rst|svg|toml|xlsx?|ya?ml|zip"
)
_MOST_BYTES = 4 * MOST_CHARACTERS + 1


@dataclass(frozen=True, slots=True)
class Linted:
    """A file, what is to be said of it, and `other`: the family that it reads like, if that is not the one chosen."""

    name: str
    program: Program
    found: tuple[Diagnostic, ...]
    other: Text = NOTHING


def lint_files(
    folder: Path, family: Dialect, encoding: str | None = None, symbols: Symbols | None = None
) -> Iterator[Linted]:
    """Lint one file after the other in order of name, behind a progress bar where a person sits at the terminal."""
    from tqdm import tqdm

    troubles: list[OSError] = []
    files = sorted(_files(folder, troubles))
    with tqdm(files, file=sys.stderr, disable=None, leave=False, unit="") as bar:
        for path in bar:
            yield _linted(path, path.relative_to(folder).as_posix(), (family, symbols), encoding)
    for trouble in troubles:
        name = Path(os.fsdecode(trouble.filename or folder)).relative_to(folder).as_posix()
        yield Linted(name, Program(family, ()), (unread(trouble),))


def _files(folder: Path, troubles: list[OSError]) -> Iterator[Path]:
    """Give the files that may be programs, hidden ones and hidden folders left out."""
    for where, folders, names in os.walk(folder, onerror=troubles.append):
        folders[:] = [name for name in folders if not name.startswith((".", "__"))]
        for name in names:
            path = Path(where, name)
            if not name.startswith(".") and not _NO_PROGRAMS.fullmatch(path.suffix[1:].lower()) and path.is_file():
                yield path


def _linted(path: Path, name: str, how: tuple[Dialect, Symbols | None], encoding: str | None) -> Linted:
    family, symbols = how
    nothing = Program(family, ())
    try:
        with path.open("rb") as file:
            data = file.read(_MOST_BYTES)
    except OSError as trouble:
        return Linted(name, nothing, (unread(trouble),))
    if no_text(data):
        return Linted(name, nothing, (document(path.suffix[1:]) or project(),))
    text = decode(data, encoding)
    if is_symbols(text):
        return Linted(name, Program(family, (), source=text), read_symbols(text).diagnostics)
    try:
        program = read_either(text, family, symbols)
    except NotRepresentableError as refused:
        told = rule("FIL003").at(Span(1), list=family.list, family=family.title, reason=refused.reason)
        return Linted(name, nothing, (told,))
    found = lint(program)
    return Linted(name, program if found else nothing, found, _other(found, family))


def _other(found: tuple[Diagnostic, ...], family: Dialect) -> Text:
    """Give the family that a file reads like, where that was found."""
    for one in found:
        if one.code == _OTHER:
            for other in families():
                told = rule(_OTHER).at(one.span, other=other.title, family=family.title, list=other.list)
                if told.text == one.text:
                    return other.title
    return NOTHING


_OTHER = "RDR017"
