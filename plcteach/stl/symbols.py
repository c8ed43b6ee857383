"""Reads a symbol table as people export it: a name, its address and a comment in each row; knows no family's addresses."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Literal

from plcteach.core.diagnostic import Diagnostic, few, rule
from plcteach.core.source import MOST_CHARACTERS, Span, decode, half_width, rows_of
from plcteach.stl.listing import Cell, cells
from plcteach.stl.words import too_long

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

MOST_ROWS = 40_000
LONGEST_ROW = 2_000

Column = Literal["name", "address", "comment", "other"]


@dataclass(frozen=True, slots=True)
class Symbol:
    """A name that stands for an address, in any script, and what the table says of it."""

    name: str
    address: str
    comment: str = ""


@dataclass(frozen=True)
class Symbols:
    """The symbols of a table in its order, and everything that was found in reading it."""

    rows: tuple[Symbol, ...] = ()
    diagnostics: tuple[Diagnostic, ...] = ()

    def __repr__(self) -> str:
        return f"Symbols({len(self.rows)} names)"

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[Symbol]:
        return iter(self.rows)

    def find(self, word: str) -> str | None:
        """Give the address that a word stands for: in any case, half or full width, with or without its quotes."""
        return self._addresses.get(_folded(word))

    def name(self, address: str) -> str:
        """Give the name of an address, the first one where it has several, "" where it has none; X000 is X0."""
        return self._names.get(_plain(address), "")

    @cached_property
    def _addresses(self) -> dict[str, str]:
        return {_folded(one.name): one.address for one in reversed(self.rows)}

    @cached_property
    def _names(self) -> dict[str, str]:
        return {_plain(one.address): one.name for one in reversed(self.rows)}


def _folded(word: str) -> str:
    return half_width(word).strip().strip('"').strip().casefold()


def _plain(address: str) -> str:
    return _LEADING_ZEROS.sub(r"\1", half_width(address).strip().upper())


_LEADING_ZEROS = re.compile(r"^(%?[A-Z]+)0+(?=\d)")
_LIKE_AN_ADDRESS = re.compile(r"%?[A-Z]{1,4}\d+(?:\.\d+)?", re.IGNORECASE)
_CONTROL = re.compile(r"[\x00-\x08\x0e-\x1f\x7f]")
_SPACED = re.compile(r'\s*(?:"(?P<quoted>[^"]*)"|(?P<bare>\S+))(?:\s+(?P<address>\S+))?(?:\s+(?P<comment>\S.*))?')
_FIRST_ROWS = 40
_HEADS: dict[Column, str] = {
    "name": "symbol|symbols|name|symbol name|tag|label|符号|符号名|名称|变量|变量名|标签",
    "address": "address|addr|地址|绝对地址",
    "comment": "comment|comments|description|注释|说明|备注|注解|描述",
}
_BY_HEAD = {name: column for column, names in _HEADS.items() for name in names.split("|")}
_SAYS_ADDRESS = re.compile(_HEADS["address"], re.IGNORECASE)
_ORDER: tuple[Column, ...] = ("name", "address", "comment")
_SWAPPED: tuple[Column, ...] = ("address", "name", "comment")


@dataclass(frozen=True, slots=True)
class _Layout:
    """How a table is laid out: what parts its cells ("" for blanks), what each column holds, and how many rows stand above."""

    delimiter: str
    columns: tuple[Column, ...]
    above: int = 0

    def holds(self, at: int) -> Column:
        """Give what a column holds; those behind the last one say something more."""
        return self.columns[at] if at < len(self.columns) else "comment"


def is_symbols(text: str) -> bool:
    """Say whether a text is a symbol table with heads over its columns."""
    rows = rows_of(text[: _FIRST_ROWS * LONGEST_ROW])
    return _headed(rows, _delimiter(rows)) is not None


def read_symbols(text: str | bytes, *, encoding: str | None = None) -> Symbols:
    """Read a table of names, addresses and comments; a row that could not be read stands in `Symbols.diagnostics`.

    Tabs part the cells, else commas or semicolons, else blanks. The head row may be English, Chinese or absent. Bytes are
    decoded as a program's are.
    """
    source = text if isinstance(text, str) else decode(text, encoding)
    if len(source) > MOST_CHARACTERS:
        return Symbols((), (too_long(Span(1), len(source), MOST_CHARACTERS, "个字符", "characters"),))
    rows = rows_of(source)
    delimiter = _delimiter(rows)
    layout = _headed(rows, delimiter) or _unheaded(rows, delimiter)
    table = _Table(layout)
    for number, row in enumerate(rows[:MOST_ROWS], 1):
        if number > layout.above:
            table.row(number, row)
    if len(rows) > MOST_ROWS:
        table.found.append(too_long(Span(MOST_ROWS + 1), len(rows), MOST_ROWS, "行", "rows"))
    return Symbols(tuple(table.rows), tuple(few(table.found)))


def _delimiter(rows: Sequence[str]) -> str:
    beginning = "\n".join(row[:LONGEST_ROW] for row in rows[:_FIRST_ROWS])
    return next((sign for sign in "\t,;" if sign in beginning), "")


def _cut(row: str, delimiter: str) -> list[Cell]:
    if delimiter:
        return list(cells(row, delimiter))
    match = _SPACED.match(row)
    parts = ("quoted" if match and match["quoted"] is not None else "bare", "address", "comment")
    return [Cell(match[part] or "", max(0, match.start(part))) for part in parts] if match else []


def _headed(rows: Sequence[str], delimiter: str) -> _Layout | None:
    for number, row in enumerate(rows[:_FIRST_ROWS], 1):
        if not _SAYS_ADDRESS.search(half_width(row[:LONGEST_ROW])):
            continue
        names = [half_width(cell.text).strip().lower() for cell in _cut(row[:LONGEST_ROW], delimiter)]
        columns = tuple(map(_column, names))
        if {"name", "address"} <= set(columns):
            return _Layout(delimiter, columns, number)
    return None


def _column(head: str) -> Column:
    return _BY_HEAD.get(head, "other")


def _unheaded(rows: Sequence[str], delimiter: str) -> _Layout:
    """Take the columns in the usual order; numbers and empty cells in front are passed over, addresses may stand first."""
    beginning = [_cut(row[:LONGEST_ROW], delimiter) for row in rows[:_FIRST_ROWS] if row.strip()]
    width = max(map(len, beginning), default=0)
    column = [[half_width(row[at].text).strip() if at < len(row) else "" for row in beginning] for at in range(width)]
    front = 0
    while front < width - 2 and all(not one or one.isdigit() for one in column[front]):
        front += 1
    order = _ORDER
    if width >= front + 2 and _addresses(column[front]) and not any(map(_LIKE_AN_ADDRESS.fullmatch, column[front + 1])):
        order = _SWAPPED
    in_front = tuple(map(_column, [""] * front))
    return _Layout(delimiter, in_front + order)


def _addresses(column: list[str]) -> bool:
    return all(not one or _LIKE_AN_ADDRESS.fullmatch(one) for one in column)


class _Table:
    """Takes row after row, with the names and addresses that it has met."""

    def __init__(self, layout: _Layout) -> None:
        self.layout = layout
        self.rows: list[Symbol] = []
        self.found: list[Diagnostic] = []
        self.names: dict[str, tuple[str, int]] = {}
        self.addresses: dict[str, str] = {}

    def row(self, number: int, given: str) -> None:
        row = given[:LONGEST_ROW]
        control = _CONTROL.search(row)
        if control:
            place = Span(number, control.start(), control.end())
            self.found.append(rule("RDR014").at(place, word=f"U+{ord(control[0]):04X}"))
            return
        if half_width(row).lstrip().startswith("//"):
            return
        parts: dict[Column, list[Cell]] = {"name": [], "address": [], "comment": [], "other": []}
        for at, cell in enumerate(_cut(row, self.layout.delimiter)):
            if cell.text.strip():
                parts[self.layout.holds(at)].append(cell)
        if parts["name"] or parts["address"]:
            name, address = _joined(parts["name"]).strip('"').strip(), half_width(_joined(parts["address"]))
            self.symbol(Symbol(name, address, _joined(parts["comment"])), Span(number, 0, len(row.rstrip())))
        elif parts["comment"]:
            self.say("SYM002", Span(number, 0, len(row.rstrip())), address=_shown(_joined(parts["comment"])))

    def say(self, code: str, span: Span, **values: object) -> None:
        self.found.append(rule(code).at(span, **values))

    def symbol(self, one: Symbol, span: Span) -> None:
        """Keep a symbol, or say why it cannot be one."""
        if not one.address:
            self.say("SYM001", span, name=_shown(one.name))
        elif not one.name:
            self.say("SYM002", span, address=_shown(one.address))
        elif any(sign.isspace() for sign in one.address) or not any(sign.isdigit() for sign in one.address):
            self.say("SYM005", span, name=_shown(one.name), address=_shown(one.address))
        else:
            self.new(one, span)

    def new(self, one: Symbol, span: Span) -> None:
        name, address = _folded(one.name), _plain(one.address)
        before, row = self.names.get(name, ("", 0))
        if before == address:
            return
        if before:
            self.say("SYM003", span, name=_shown(one.name), row=row, first=before, second=_shown(one.address))
            return
        if address in self.addresses:
            other = self.addresses[address]
            self.say("SYM004", span, name=_shown(one.name), address=_shown(one.address), other=_shown(other))
        self.names[name] = address, span.row
        self.addresses.setdefault(address, one.name)
        self.rows.append(one)


def _joined(found: list[Cell]) -> str:
    return " ".join(cell.text.strip() for cell in found)


def _shown(words: str) -> str:
    return words if len(words) <= _SHOWN else f"{words[:_SHOWN]}…"


_SHOWN = 24
