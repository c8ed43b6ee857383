"""Where in a learner's text something stands, and how bytes from anywhere become that text."""

from __future__ import annotations

import re
from dataclasses import dataclass

MOST_CHARACTERS = 2_000_000
"""A longer text is not a program for a lesson; it is refused before anything reads it."""


@dataclass(frozen=True, slots=True, order=True)
class Span:
    """A stretch of one row: rows count from 1, columns from 0 in code points of the text as given; `stop` is outside."""

    row: int
    start: int = 0
    stop: int = 0

    def __repr__(self) -> str:
        return f"{self.row}:{self.start}-{self.stop}"


_ROW_ENDS = re.compile(r"\r\n|\n|\r")


def rows_of(text: str) -> list[str]:
    """Give the rows of a text, whatever ends them."""
    return _ROW_ENDS.split(text)


def printable(text: str) -> str:
    """Put a blank for every sign that a terminal would obey, sign for sign, so that columns stay."""
    return "".join(sign if sign.isprintable() else " " for sign in text)


_FULL_WIDTH = {code: code - 0xFEE0 for code in range(0xFF01, 0xFF5F)}
_MARKS: dict[str, str] = {
    "　": " ",
    "\xa0": " ",
    "。": ".",
    "、": ",",
    "“": '"',
    "”": '"',
    "‘": "'",
    "’": "'",
    "【": "[",
    "】": "]",
    "−": "-",
    "–": "-",
    "×": "*",
    "÷": "/",
    "﻿": " ",
    "\t": " ",
    "\f": " ",
    "\v": " ",
}
_HALF_WIDTH: dict[int, int | str] = {**_FULL_WIDTH, **{ord(mark): plain for mark, plain in _MARKS.items()}}


def half_width(text: str) -> str:
    """Turn what a Chinese input method types (ＬＤ　Ｉ０．０；) into ASCII, one character for one, so that columns stay."""
    return text.translate(_HALF_WIDTH)


def decode(data: bytes, encoding: str | None = None) -> str:
    """Turn the bytes of a file into text: UTF-8, UTF-16 with a mark, then `encoding`, else GBK, else cp1252.

    Nothing is lost: bytes that fit no encoding come back as cp1252 or, last, as replacement characters.
    """
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode("utf-16", errors="replace")
    for name in ("utf-8-sig", encoding, "gbk", "cp1252"):
        if name is None:
            continue
        try:
            return data.decode(name)
        except UnicodeDecodeError:
            continue
    return data.decode("utf-8", errors="replace")
