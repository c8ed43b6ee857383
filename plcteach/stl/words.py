"""What a text is cut into: words with their places, statements and headings; knows no layout and no instruction."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.core.diagnostic import rule
from plcteach.core.source import Span
from plcteach.core.text import counted

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic


@dataclass(frozen=True, slots=True)
class Word:
    """A word in half-width letters, and where it stands; one in double quotes keeps them and may hold spaces."""

    text: str
    span: Span

    @property
    def shown(self) -> str:
        """The word as a message may show it: never longer than a line can bear."""
        return self.text if len(self.text) <= _SHOWN else f"{self.text[:_SHOWN]}…"


_SHOWN = 24


def too_long(span: Span, size: int, most: int, zh: str, en: str) -> Diagnostic:
    """Say that there are more of something than are read."""
    return rule("RDR013").at(span, size=counted(size, zh, en), most=counted(most, zh, en))


@dataclass(slots=True)
class Statement:
    """The words of one instruction, the comment behind it and the comment lines above it."""

    words: list[Word]
    comment: str = ""
    above: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Heading:
    """A line that begins a network, with its title; `block` is the subroutine it stands in ("SBR0"), "" in the main program."""

    span: Span
    title: str
    block: str = ""


@dataclass(slots=True)
class Tokens:
    """Everything a text is made of, in order.

    tail: the comments after the last statement.  blocks: the name that a subroutine goes by, in capitals, and its number:
    {"PUMP": "SBR3"}.
    """

    items: list[Statement | Heading] = field(default_factory=list)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    tail: tuple[str, ...] = ()
    blocks: dict[str, str] = field(default_factory=dict)


_WORDS = re.compile(r'"[^"]*"|"?[^\s,;"]+|"')
_PIECES = re.compile(r'(?:"[^"]*"|[^;"]|")+')


def pieces(code: str) -> Iterator[tuple[int, int]]:
    """Give the stretches between semicolons that hold anything; a semicolon in double quotes parts nothing."""
    for match in _PIECES.finditer(code):
        if match[0].strip():
            yield match.span()


def split(code: str, first: int, last: int, row: int, *, closers: bool) -> Iterator[Word]:
    """Give the words of a stretch of a row, which blanks and commas part."""
    for match in _WORDS.finditer(code, first, last):
        text, start = match[0], match.start()
        while closers and text.endswith(")") and len(text) > 1:
            text = text[:-1]
        yield Word(text, Span(row, start, start + len(text)))
        for at in range(start + len(text), match.end()):
            yield Word(")", Span(row, at, at + 1))


def closed(words: list[Word], *, closers: bool) -> Iterator[list[Word]]:
    """Make each closing parenthesis a statement of its own, in families that have one, but not within brackets [ ].

    The line number before one goes with it, and is dropped.
    """
    current: list[Word] = []
    depth = 0
    for word in words:
        if not word.text.startswith('"'):
            depth = max(0, depth + word.text.count("[") - word.text.count("]"))
        if closers and not depth and word.text == ")":
            if len(current) > 1 or (current and not current[0].text.rstrip(":").isdigit()):
                yield current
            yield [word]
            current = []
        else:
            current.append(word)
    if current:
        yield current
