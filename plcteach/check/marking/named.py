"""Names of files and of their owners as people can read them, and never two of them alike."""

from __future__ import annotations

import os
import re
import unicodedata
from collections import Counter
from typing import TYPE_CHECKING

from plcteach.core.source import printable

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping


_EITHER = re.compile(rb"(?:[\0-\x7f]|(?<![A-Za-z])(?:[\xc2-\xdf][\xa1-\xbf])+(?![A-Za-z]))+")
"""Names that are GBK, and UTF-8 by chance: two bytes for each sign, and no letter beside them as in Müller."""


def readable(names: Iterable[str]) -> dict[str, str]:
    """Give the names of files in words: those that are no UTF-8 are GBK, as ZIP files from Windows have them, or else spelled out."""
    found = {name: os.fsencode(name) for name in names}
    packed = any(not _in("utf-8", data) and _in("gbk", data) for data in found.values())
    return {name: _words(data, packed=packed) for name, data in found.items()}


def _words(data: bytes, *, packed: bool) -> str:
    first = "gbk" if packed and _EITHER.fullmatch(data) else "utf-8"
    return _in(first, data) or _in("gbk", data) or data.decode("utf-8", "backslashreplace")


def _in(encoding: str, data: bytes) -> str:
    try:
        return data.decode(encoding)
    except UnicodeDecodeError:
        return ""


def told_apart(names: Mapping[tuple[str, str], tuple[str, str]]) -> dict[tuple[str, str], str]:
    """Give each owner a name to show that no other shows, by what they are called and their number; who looks like another gets a count.

    Whoever is called exactly what is shown keeps it, so that a name made to look like another's takes nothing from them.
    """
    given: dict[tuple[str, str], str] = {}
    taken: set[tuple[str, str]] = set()
    counts: Counter[tuple[str, str]] = Counter()
    shown = {raw: (printable(name), number) for raw, (name, number) in names.items()}
    for raw in sorted(shown, key=lambda one: (shown[one] != one, one)):
        name, number = shown[raw]
        free = name
        while (_look(free), number) in taken:
            counts[_look(name), number] += 1
            free = f"{name} ({counts[_look(name), number] + 1})"
        taken.add((_look(free), number))
        given[raw] = free
    return given


def _look(name: str) -> str:
    """Give what an eye sees of a name: one sign for each accent's two spellings, and blanks run together."""
    return unicodedata.normalize("NFC", " ".join(name.split()))
