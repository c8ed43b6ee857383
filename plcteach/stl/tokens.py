"""Cuts a text into statements and headings with their places; knows comments and layout, but no instruction."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from plcteach.core.diagnostic import rule
from plcteach.core.source import MOST_CHARACTERS, Span, half_width, rows_of
from plcteach.core.text import Text
from plcteach.stl.listing import layout_of
from plcteach.stl.words import Heading, Statement, Tokens, Word, closed, pieces, split, too_long

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.stl.listing import Cell, Layout

__all__ = ["Heading", "Statement", "Tokens", "Word", "cut", "reads_as_comment"]

MOST_ROWS = 40_000
MOST_STATEMENTS = 20_000
LONGEST_ROW = 2_000

_HEADING = re.compile(
    r"\s*(?:NETWORK|RUNG|网络|程序段|梯级)\s*(?P<number>\d{0,9})\s*(?P<rest>(?![\w.]).*)", re.IGNORECASE
)
_WRAPPER = re.compile(r"\s*(?:BEGIN\s*|TITLE\s*=.*|AUTHOR\s*:.*|VERSION\s*:.*)", re.IGNORECASE)
_SOLUTION = re.compile(r"\s*(?:###.*|#\s*(?:BEGIN|END)\s+SOLUTION\b.*)", re.IGNORECASE)
_BLOCK = re.compile(
    r"\s*(?P<end>END_)?(?P<kind>ORGANIZATION|SUBROUTINE|INTERRUPT)_BLOCK\b\s*(?P<name>[^:/(]*)(?P<rest>.*)",
    re.IGNORECASE,
)
_SUBROUTINE = re.compile(r"SBR_?(\d{1,9})", re.IGNORECASE)
_VARIABLES = re.compile(r"\s*VAR(?:_INPUT|_OUTPUT|_IN_OUT|_TEMP)?\s*", re.IGNORECASE)
_SIGNS = re.compile(r"[\s/:;]*(?:\(\*(?P<block>.*)\*\)\s*|(?P<bare>.*))")
_COMMENT_OPENS = re.compile(r'"[^"]*"|//|\(\*')
_LONE_NUMBER = re.compile(r"\s*\d+:?\s*")
_CONTROL = re.compile(r"[\x00-\x08\x0e-\x1f\x7f]")


class _Cutter:
    """Goes down the rows of one text, with what it must remember from row to row.

    block: the subroutine in which the row stands, and `said` the one that the last heading named.
    """

    def __init__(self, *, closers: bool, layout: Layout | None) -> None:
        self.out = Tokens()
        self.closers = closers
        self.layout = layout
        self.comments: list[str] = []
        self.opened: Span | None = None
        self.variables: Span | None = None
        self.interrupt: Span | None = None
        self.block = self.said = ""

    def cut(self, rows: Sequence[str]) -> Tokens:
        for number, row in enumerate(rows[:MOST_ROWS], 1):
            self.row(number, row)
            if len(self.out.items) > MOST_STATEMENTS:
                more = Text(f"{MOST_STATEMENTS}条指令以上", f"more than {MOST_STATEMENTS} instructions")
                most = Text(f"{MOST_STATEMENTS}条", f"{MOST_STATEMENTS}")
                self.out.diagnostics.append(rule("RDR013").at(Span(number), size=more, most=most))
                del self.out.items[MOST_STATEMENTS:]
                break
        if len(rows) > MOST_ROWS:
            self.out.diagnostics.append(too_long(Span(MOST_ROWS + 1), len(rows), MOST_ROWS, "行", "rows"))
        if self.opened:
            self.out.diagnostics.append(rule("RDR009").at(self.opened))
        if self.variables:
            self.out.diagnostics.append(rule("RDR015").at(self.variables))
        self.out.tail = tuple(self.comments)
        return self.out

    def row(self, number: int, given: str) -> None:
        if len(given) > LONGEST_ROW:
            rest = Span(number, LONGEST_ROW, len(given))
            self.out.diagnostics.append(too_long(rest, len(given), LONGEST_ROW, "个字符", "characters"))
            given = given[:LONGEST_ROW]
        control = _CONTROL.search(given)
        if control:
            at = control.start()
            self.out.diagnostics.append(rule("RDR014").at(Span(number, at, at + 1), word=f"U+{ord(given[at]):04X}"))
            given = _CONTROL.sub(" ", given)
        if self.layout:
            self.record(number, given, self.layout)
        else:
            self.free(number, half_width(given), given)

    def free(self, number: int, plain: str, given: str) -> None:
        """Take a row of an ordinary text."""
        if self.variables:
            self.variables = None if plain.strip().upper().startswith("END_VAR") else self.variables
        elif not self.opened and _VARIABLES.fullmatch(plain):
            self.variables = Span(number, 0, len(given))
        elif self.opened or not self.layout_row(number, plain, given):
            self.statements(number, plain, given)

    def layout_row(self, number: int, plain: str, given: str) -> bool:
        """Take a row that is no instruction: a block's beginning or end, a heading, a wrapper's row."""
        if self.bounds(number, plain, given) or self.heading(number, plain, given):
            return True
        return bool(_WRAPPER.fullmatch(plain)) or bool(_SOLUTION.fullmatch(plain))

    def bounds(self, number: int, plain: str, given: str) -> bool:
        """Enter or leave a block of an exported project; only a subroutine has a name that the lists must keep."""
        match = _BLOCK.fullmatch(plain)
        if not match:
            return False
        kind = "" if match["end"] else match["kind"].upper()
        self.block = self.named(match) if kind == "SUBROUTINE" else ""
        self.interrupt = Span(number, 0, len(given)) if kind == "INTERRUPT" else None
        return True

    def named(self, match: re.Match[str]) -> str:
        """Give a subroutine its number, and keep the name that calls may use."""
        name = match["name"].strip()
        found = _SUBROUTINE.search(match["rest"].split("//")[0]) or _SUBROUTINE.fullmatch(name)
        block = f"SBR{int(found[1]) if found else len(self.out.blocks)}"
        self.out.blocks[name.upper() or block] = block
        return block

    def heading(self, number: int, plain: str, given: str) -> bool:
        match = _HEADING.fullmatch(plain)
        if not match or self.interrupt:
            return bool(match)
        start = match.start("rest")
        stop = plain.find(";", start)
        inside = plain.find("//", start), plain.find("(*", start)
        if stop < 0 or any(0 <= sign < stop for sign in inside):
            stop = len(given)
        self.begin(Span(number, 0, stop), _title(plain[start:stop], given[start:stop]))
        self.statements(number, " " * stop + plain[stop:].replace(";", " ", 1), given)
        return True

    def begin(self, span: Span, title: str) -> None:
        self.out.items.append(Heading(span, title, self.block))
        self.said = self.block

    def statements(self, number: int, plain: str, given: str) -> None:
        code, comment = self.without_comments(number, plain, given)
        if comment and _LONE_NUMBER.fullmatch(code):
            code = ""
        found: list[list[Word]] = []
        for first, last in pieces(code):
            heading = _HEADING.fullmatch(code[first:last])
            if heading and not self.interrupt:
                self.add(number, found, "")
                found = []
                self.begin(Span(number, first, last), heading["rest"].strip())
            else:
                found += closed(list(split(code, first, last, number, closers=self.closers)), closers=self.closers)
        self.add(number, found, comment)

    def add(self, number: int, found: list[list[Word]], comment: str) -> None:
        """Add the instructions of one row; a comment with none waits for the next one."""
        if self.interrupt:
            self.not_run(found)
            return
        if found and self.said != self.block:
            self.begin(Span(number), "")
        for words in found:
            self.out.items.append(Statement(words, above=tuple(self.comments)))
            self.comments.clear()
        last = self.out.items[-1] if found else None
        if comment and isinstance(last, Statement):
            last.comment = comment
        elif comment:
            self.comments.append(comment)

    def not_run(self, found: list[list[Word]]) -> None:
        """Say once for each interrupt program that its instructions are not run."""
        if found and self.interrupt and self.interrupt.stop >= 0:
            first, last = found[0][0].span, found[-1][-1].span
            self.out.diagnostics.append(
                rule("RDR018").at(Span(first.row, first.start, last.stop), row=self.interrupt.row)
            )
            self.interrupt = Span(self.interrupt.row, 0, -1)

    def record(self, number: int, given: str, layout: Layout) -> None:
        """Take a row of a table: what is said above an instruction, the instruction or a further operand of it, the note."""
        row = layout.record(number, given)
        if row is None:
            return
        for cell in row.statements:
            self.said_above(number, cell)
        words = [word for cell in row.code for word in _words(cell, number, closers=self.closers)]
        last = self.out.items[-1] if self.out.items else None
        if row.begins or not isinstance(last, Statement) or self.interrupt:
            self.add(number, list(closed(words, closers=self.closers)), row.note)
        elif words:
            last.words += words
            last.comment = f"{last.comment} {row.note}".strip()
        elif row.note:
            self.comments.append(row.note)

    def said_above(self, number: int, cell: Cell) -> None:
        text = " " * cell.start + cell.text
        plain = half_width(text)
        if self.bounds(number, plain, text) or self.heading(number, plain, text):
            return
        said = cell.text.strip()
        said = said.lstrip(";；").strip() if said.startswith((";", "；")) else said
        if said and not self.interrupt:
            self.comments.append(said)

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
            sign = _COMMENT_OPENS.search(plain, at)
            if sign is None:
                code.append(plain[at:])
                break
            start = sign.end() if sign[0].startswith('"') else sign.start()
            code.append(plain[at:start])
            at = start
            if sign[0] == "//":
                said.append(given[start + 2 :].strip())
                break
            if sign[0] == "(*":
                code.append("  ")
                self.opened, at = Span(number, start, start + 2), start + 2
        return "".join(code), " ".join(words for words in said if words)


def _words(cell: Cell, number: int, *, closers: bool) -> list[Word]:
    """Give the words of a cell; where quotes were doubled, the whole cell is their place."""
    plain = half_width(cell.text)
    found = split(plain, 0, len(plain), number, closers=closers)
    if not cell.exact:
        return [Word(word.text, Span(number, cell.start, cell.start + len(plain))) for word in found]
    return [Word(word.text, Span(number, cell.start + word.span.start, cell.start + word.span.stop)) for word in found]


def reads_as_comment(text: str) -> bool:
    """Say whether a cell with this text would be read as nothing but a comment."""
    plain = half_width(text)
    return not (plain.startswith(";") or _BLOCK.fullmatch(plain) or _HEADING.fullmatch(plain))


def _title(plain: str, given: str) -> str:
    """Take the signs of a comment off a title, however many there are; `plain` is the same in half-width letters."""
    while match := _SIGNS.fullmatch(plain):
        inside = match["block"] is not None
        first, last = match.span("block" if inside else "bare")
        plain, given = plain[first:last], given[first:last]
        if not inside:
            break
    return given.strip()


def cut(text: str, *, closers: bool) -> Tokens:
    """Cut a text or a table into statements and headings; `closers`: the family closes parentheses with a `)` of its own."""
    if len(text) > MOST_CHARACTERS:
        return Tokens(diagnostics=[too_long(Span(1), len(text), MOST_CHARACTERS, "个字符", "characters")])
    rows = rows_of(text)
    return _Cutter(closers=closers, layout=layout_of(rows)).cut(rows)
