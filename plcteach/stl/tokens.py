"""Cuts a text into statements and headings with their places; knows comments and layout, but no instruction."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.core.diagnostic import rule
from plcteach.core.source import MOST_CHARACTERS, Span, half_width
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic

MOST_ROWS = 40_000
MOST_STATEMENTS = 20_000
LONGEST_ROW = 2_000


@dataclass(frozen=True, slots=True)
class Word:
    """A word in half-width letters, and where it stands."""

    text: str
    span: Span

    @property
    def shown(self) -> str:
        """The word as a message may show it: never longer than a line can bear."""
        return self.text if len(self.text) <= _SHOWN else f"{self.text[:_SHOWN]}…"


_SHOWN = 24


@dataclass(slots=True)
class Statement:
    """The words of one instruction, the comment behind it and the comment lines above it."""

    words: list[Word]
    comment: str = ""
    above: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Heading:
    """A line that begins a network, with its title."""

    span: Span
    title: str


@dataclass(slots=True)
class Tokens:
    """Everything a text is made of, in order; `tail` holds the comments after the last statement."""

    items: list[Statement | Heading] = field(default_factory=list)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    tail: tuple[str, ...] = ()


_HEADING = re.compile(
    r"\s*(?:NETWORK|RUNG|网络|程序段|梯级)\s*(?P<number>\d{0,9})\s*(?P<rest>(?![\w.]).*)", re.IGNORECASE
)
_WRAPPER = re.compile(
    r"\s*(?:ORGANIZATION_BLOCK\b.*|END_ORGANIZATION_BLOCK\s*|BEGIN\s*|TITLE\s*=.*|AUTHOR\s*:.*|VERSION\s*:.*)",
    re.IGNORECASE,
)
_OTHER_BLOCK = re.compile(r"\s*(?P<end>END_)?(?:SUBROUTINE|INTERRUPT)_BLOCK\b.*", re.IGNORECASE)
_ROW_ENDS = re.compile(r"\r\n|\n|\r")
_VARIABLES = re.compile(r"\s*VAR(?:_INPUT|_OUTPUT|_IN_OUT|_TEMP)?\s*", re.IGNORECASE)
_SIGNS = re.compile(r"[\s/:;]*(?:\(\*(?P<block>.*)\*\)\s*|(?P<bare>.*))")
_WORDS = re.compile(r"[^\s,;]+")
_CONTROL = re.compile(r"[\x00-\x08\x0e-\x1f\x7f]")


class _Cutter:
    """Goes down the rows of one text, with what it must remember from row to row."""

    def __init__(self, *, closers: bool) -> None:
        self.out = Tokens()
        self.closers = closers
        self.comments: list[str] = []
        self.opened: Span | None = None
        self.variables: Span | None = None
        self.other: Span | None = None

    def cut(self, text: str) -> Tokens:
        rows = _ROW_ENDS.split(text)
        for number, row in enumerate(rows[:MOST_ROWS], 1):
            self.row(number, row)
            if len(self.out.items) > MOST_STATEMENTS:
                more = Text(f"{MOST_STATEMENTS}条指令以上", f"more than {MOST_STATEMENTS} instructions")
                self.too_long(Span(number), more, Text(f"{MOST_STATEMENTS}条", f"{MOST_STATEMENTS}"))
                del self.out.items[MOST_STATEMENTS:]
                break
        if len(rows) > MOST_ROWS:
            self.too_long(Span(MOST_ROWS + 1), _rows(len(rows)), _rows(MOST_ROWS))
        if self.opened:
            self.out.diagnostics.append(rule("RDR009").at(self.opened))
        if self.variables:
            self.out.diagnostics.append(rule("RDR015").at(self.variables))
        self.out.tail = tuple(self.comments)
        return self.out

    def too_long(self, span: Span, size: Text, most: Text) -> None:
        self.out.diagnostics.append(rule("RDR013").at(span, size=size, most=most))

    def row(self, number: int, given: str) -> None:
        if len(given) > LONGEST_ROW:
            self.too_long(Span(number, LONGEST_ROW, len(given)), _characters(len(given)), _characters(LONGEST_ROW))
            given = given[:LONGEST_ROW]
        control = _CONTROL.search(given)
        if control:
            at = control.start()
            self.out.diagnostics.append(rule("RDR014").at(Span(number, at, at + 1), word=f"U+{ord(given[at]):04X}"))
            given = _CONTROL.sub(" ", given)
        plain = half_width(given)
        if self.variables:
            self.variables = None if plain.strip().upper().startswith("END_VAR") else self.variables
        elif not self.opened and _VARIABLES.fullmatch(plain):
            self.variables = Span(number, 0, len(given))
        elif not self.opened and (block := _OTHER_BLOCK.fullmatch(plain)):
            self.other = None if block["end"] else Span(number, 0, len(given))
        elif not self.heading(number, plain, given) and not self.skipped(plain):
            self.statements(number, plain, given)

    def skipped(self, plain: str) -> bool:
        return not self.opened and (bool(_WRAPPER.fullmatch(plain)) or plain.lstrip().startswith("###"))

    def heading(self, number: int, plain: str, given: str) -> bool:
        match = None if self.opened else _HEADING.fullmatch(plain)
        if not match or self.other:
            return bool(match)
        start = match.start("rest")
        stop = plain.find(";", start)
        inside = plain.find("//", start), plain.find("(*", start)
        if stop < 0 or any(0 <= sign < stop for sign in inside):
            stop = len(given)
        self.out.items.append(Heading(Span(number, 0, stop), _title(plain[start:stop], given[start:stop])))
        self.statements(number, " " * stop + plain[stop:].replace(";", " ", 1), given)
        return True

    def statements(self, number: int, plain: str, given: str) -> None:
        code, comment = self.without_comments(number, plain, given)
        if self.other:
            self.not_run(number, code)
            return
        start = len(self.out.items)
        for first, last in _pieces(code):
            words = list(_split(code, first, last, number, closers=self.closers))
            for statement in _closed(words, closers=self.closers):
                self.out.items.append(Statement(statement, above=tuple(self.comments)))
                self.comments.clear()
        if comment and len(self.out.items) > start:
            last_one = self.out.items[-1]
            if isinstance(last_one, Statement):
                last_one.comment = comment
        elif comment:
            self.comments.append(comment)

    def not_run(self, number: int, code: str) -> None:
        """Say once for each block beside the main program that its instructions are not run."""
        if code.strip() and self.other and self.other.stop >= 0:
            self.out.diagnostics.append(rule("RDR018").at(Span(number, 0, len(code.rstrip())), row=self.other.row))
            self.other = Span(self.other.row, 0, -1)

    def without_comments(self, number: int, plain: str, given: str) -> tuple[str, str]:
        """Blank out the comments of a row, so that columns stay, and give their words apart."""
        if not self.opened and plain.lstrip().startswith(";"):
            return "", given.strip().lstrip(";；").strip()
        code, said, at = [], [], 0
        while at < len(plain):
            if self.opened:
                end = plain.find("*)", at)
                said.append(given[at : end if end >= 0 else None].strip())
                if end < 0:
                    break
                code.append(" " * (end + 2 - at))
                at, self.opened = end + 2, None
                continue
            line, block = plain.find("//", at), plain.find("(*", at)
            if line >= 0 and (block < 0 or line < block):
                code.append(plain[at:line])
                said.append(given[line + 2 :].strip())
                break
            if block < 0:
                code.append(plain[at:])
                break
            code.append(plain[at:block] + "  ")
            self.opened, at = Span(number, block, block + 2), block + 2
        return "".join(code), " ".join(words for words in said if words)


def _title(plain: str, given: str) -> str:
    """Take the signs of a comment off a title, however many there are; `plain` is the same in half-width letters."""
    while match := _SIGNS.fullmatch(plain):
        inside = match["block"] is not None
        first, last = match.span("block" if inside else "bare")
        plain, given = plain[first:last], given[first:last]
        if not inside:
            break
    return given.strip()


def _rows(count: int) -> Text:
    return Text(f"{count}行", f"{count} rows")


def _characters(count: int) -> Text:
    return Text(f"{count}个字符", f"{count} characters")


def _pieces(code: str) -> Iterator[tuple[int, int]]:
    """Give the stretches between semicolons that hold anything."""
    start = 0
    for end in [at for at, sign in enumerate(code) if sign == ";"] + [len(code)]:
        if code[start:end].strip():
            yield start, end
        start = end + 1


def _split(code: str, first: int, last: int, row: int, *, closers: bool) -> Iterator[Word]:
    for match in _WORDS.finditer(code, first, last):
        text, start = match[0], match.start()
        while closers and text.endswith(")") and len(text) > 1:
            text = text[:-1]
        if text:
            yield Word(text, Span(row, start, start + len(text)))
        for at in range(start + len(text), match.end()):
            yield Word(")", Span(row, at, at + 1))


def _closed(words: list[Word], *, closers: bool) -> Iterator[list[Word]]:
    """Make each closing parenthesis a statement of its own, in families that have one."""
    current: list[Word] = []
    for word in words:
        if closers and word.text == ")":
            if current:
                yield current
            yield [word]
            current = []
        else:
            current.append(word)
    if current:
        yield current


def cut(text: str, *, closers: bool) -> Tokens:
    """Cut a text into statements and headings; `closers`: the family closes parentheses with a `)` of its own."""
    if len(text) > MOST_CHARACTERS:
        out = Tokens()
        size, most = _characters(len(text)), _characters(MOST_CHARACTERS)
        out.diagnostics.append(rule("RDR013").at(Span(1), size=size, most=most))
        return out
    return _Cutter(closers=closers).cut(text)
