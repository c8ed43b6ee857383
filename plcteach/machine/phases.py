"""Reads the rows of a timeline: which address is meant, and its phases written out one by one; knows no scans."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.diagnostic import MOST_FINDINGS, rule
from plcteach.core.source import MOST_CHARACTERS, Span, half_width, rows_of
from plcteach.core.text import Text, counted

if TYPE_CHECKING:
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.spec import Dialect

MOST_PHASES = 100_000
"""All rows of a timeline together may have so many phases, repetitions written out."""

HAND = "@"
"""What stands before the symbol of a plant's button."""

_MOST = counted(MOST_PHASES, "段", "phases")
_DEEPEST = 8
_STATES = dict.fromkeys(("on", "通", "接通", "开", "true"), 1) | dict.fromkeys(("off", "断", "断开", "关", "false"), 0)
_UNITS = {"ms": 1, "毫秒": 1, "s": 1_000, "秒": 1_000, "秒钟": 1_000, "min": 60_000, "分": 60_000, "分钟": 60_000}
_UNIT = "|".join(sorted(_UNITS, key=len, reverse=True))
_PHASE = re.compile(
    rf"(?:(?P<length>[0-9]{{1,9}}(?:\.[0-9]{{1,9}})?)\s*(?P<unit>{_UNIT})\s*)?(?P<state>\S{{1,12}})?", re.IGNORECASE
)
_NUMBER = re.compile(r"[+-]?[0-9]{1,10}")
_PARTS = re.compile(r"(?P<open>[^,()]*\()|(?P<close>\))|(?P<comma>,)|(?P<phase>[^,()]+)")
_COUNT = re.compile(r"([0-9]{1,12})\s*[x*次]?\s*\(", re.IGNORECASE)
_SEEN = re.compile(r"\s*=")
_HAND = re.compile(r"@\w{1,24}")
_COLON = re.compile(r":(?!X[0-9])", re.IGNORECASE)
_BIT = Text("是一位，只有通和断", "is one bit, on or off")
_SHOWN = 24


@dataclass(frozen=True, slots=True)
class Piece:
    """A phase as it is written: how many ms it lasts (None: to the end), its state, and where it stands."""

    length: int | None
    value: int
    span: Span
    word: str


@dataclass(frozen=True, slots=True)
class Row:
    """An address with its phases in order, repetitions written out, and where its row stands.

    mark: "=" before an address that is only looked at, "@" before a button of a plant that no input sees.
    """

    address: Address
    pieces: tuple[Piece, ...]
    span: Span
    mark: str = ""


def read_rows(text: str, dialect: Dialect) -> tuple[list[Row], list[Diagnostic]]:
    """Give the rows that could be read, and findings about all else."""
    reading = _Reading(dialect)
    if len(text) > MOST_CHARACTERS:
        size, most = (counted(count, "个字符", "characters") for count in (len(text), MOST_CHARACTERS))
        reading.too_long(Span(1), size, most)
        return [], reading.found
    for number, given in enumerate(rows_of(text), 1):
        plain = half_width(given).split("//")[0]
        start = 0
        for part in plain.split(";"):
            if part.strip():
                reading.row(_Stretch(number, plain, start, start + len(part)))
            start += len(part) + 1
        if len(reading.found) > MOST_FINDINGS:
            break
    return list(reading.rows.values()), reading.found


@dataclass(frozen=True, slots=True)
class _Stretch:
    """A part of one row of the text, blanks at its ends not counted."""

    number: int
    plain: str
    first: int
    last: int

    @property
    def text(self) -> str:
        return self.plain[self.first : self.last].strip()

    @property
    def span(self) -> Span:
        inside = self.plain[self.first : self.last]
        first = self.first + len(inside) - len(inside.lstrip())
        return Span(self.number, first, first + len(self.text))

    @property
    def shown(self) -> str:
        return self.text if len(self.text) <= _SHOWN else f"{self.text[:_SHOWN]}…"


@dataclass(slots=True)
class _Group:
    """The phases between two parentheses and how often they are repeated; the outermost is the row itself."""

    count: int
    span: Span
    pieces: list[Piece]


class _Reading:
    """Goes down the rows, collecting findings as it goes; `left`: how many phases may still be written out."""

    def __init__(self, dialect: Dialect) -> None:
        self.dialect = dialect
        self.rows: dict[str, Row] = {}
        self.found: list[Diagnostic] = []
        self.left = MOST_PHASES

    def say(self, code: str, span: Span, **values: object) -> None:
        self.found.append(rule(code).at(span, **values))

    def too_long(self, span: Span, size: Text, most: Text) -> None:
        self.say("TIM007", span, size=size, most=most)

    def row(self, row: _Stretch) -> None:
        colon = _COLON.search(row.plain, row.first, row.last)
        if colon is None:
            example = f"{self.dialect.areas[0].first}: 1s off, 0.2s on, off"
            self.say("TIM001", row.span, word=row.shown, example=example)
            return
        seen = _SEEN.match(row.plain, row.first, colon.start())
        address = self.address(_Stretch(row.number, row.plain, seen.end() if seen else row.first, colon.start()))
        if address is None:
            return
        mark = "=" if seen else address.area if address.area == HAND else ""
        key = "=" * bool(seen) + address.text
        if key in self.rows:
            self.say("TIM008", row.span, address=address.text, row=self.rows[key].span.row)
            return
        pieces = self.pieces(address, _Stretch(row.number, row.plain, colon.end(), row.last))
        if pieces:
            self.rows[key] = Row(address, tuple(pieces), row.span, mark)
        elif not row.plain[colon.end() : row.last].strip():
            self.say("TIM003", row.span, word=row.shown)

    def address(self, word: _Stretch) -> Address | None:
        if _HAND.fullmatch(word.text):
            return Address(HAND, 0, word.text)
        found = self.dialect.address(word.text)
        if isinstance(found, Address) and found.size:
            return found
        span = word.span if word.text else Span(word.number, word.first, word.last + 1)
        self.say("TIM002", span, word=word.shown or ":", family=self.dialect.title)
        return None

    def pieces(self, address: Address, body: _Stretch) -> list[Piece]:
        """Write out the phases of a row; each but the last must have a length."""
        groups = [_Group(1, body.span, [])]
        shut = False
        for match in _PARTS.finditer(body.plain, body.first, body.last):
            part = _Stretch(body.number, body.plain, match.start(), match.end())
            match match.lastgroup:
                case "open":
                    groups.append(self.opened(part, len(groups)))
                case "close":
                    self.closed(address, groups, part)
                case "phase" if part.text and shut:
                    self.say("TIM006", part.span, word=part.shown)
                case "phase" if part.text:
                    groups[-1].pieces += self.phase(address, part)
            shut = match.lastgroup == "close" or (shut and match.lastgroup == "phase")
            if len(self.found) > MOST_FINDINGS:
                break
        while len(groups) > 1:
            self.say("TIM006", groups[-1].span, word="(")
            self.joined(address, groups)
        return self.timed(address, groups[0].pieces, to_the_end=True)

    def opened(self, part: _Stretch, deep: int) -> _Group:
        """Begin a repetition; one whose count does not read is taken once."""
        match = _COUNT.fullmatch(part.text)
        count = int(match[1]) if match else 0
        if not count or deep > _DEEPEST:
            self.say("TIM006", part.span, word=part.shown)
        return _Group(count if count and deep <= _DEEPEST else 1, part.span, [])

    def closed(self, address: Address, groups: list[_Group], part: _Stretch) -> None:
        if len(groups) > 1:
            self.joined(address, groups)
        else:
            self.say("TIM006", part.span, word=part.shown)

    def joined(self, address: Address, groups: list[_Group]) -> None:
        """Put the innermost repetition, written out, behind what stands before it."""
        group = groups.pop()
        pieces = self.timed(address, group.pieces, to_the_end=False)
        more = len(pieces) * (group.count - 1)
        if more > self.left:
            self.too_long(group.span, counted(more + len(pieces), "段", "phases"), _MOST)
            return
        self.left -= more
        groups[-1].pieces += pieces * group.count

    def timed(self, address: Address, pieces: list[Piece], *, to_the_end: bool) -> list[Piece]:
        """Keep the phases that have a length, and the last one of a row."""
        timed = []
        for number, piece in enumerate(pieces, 1):
            if piece.length is not None or (to_the_end and number == len(pieces)):
                timed.append(piece)
            else:
                self.say("TIM004", piece.span, word=piece.word, address=address.text)
        return timed

    def phase(self, address: Address, part: _Stretch) -> list[Piece]:
        """Give the phase that a part says, nothing where it does not read as one."""
        match = _PHASE.fullmatch(part.text)
        if not match or not match["state"]:
            self.say("TIM003", part.span, word=part.shown)
            return []
        length = Fraction(match["length"]) * _UNITS[match["unit"].lower()] if match["length"] else None
        if length is not None and (length < 1 or length.denominator != 1):
            self.say("TIM010", part.span, word=part.shown)
            return []
        value = self.state(address, match["state"].lower(), part)
        if value is None:
            return []
        self.left -= 1
        if self.left < 0:
            self.too_long(part.span, counted(MOST_PHASES - self.left, "段", "phases"), _MOST)
            return []
        return [Piece(None if length is None else int(length), value, part.span, part.shown)]

    def state(self, address: Address, word: str, part: _Stretch) -> int | None:
        if word in _STATES:
            return _STATES[word]
        if not _NUMBER.fullmatch(word):
            self.say("TIM003", part.span, word=part.shown)
            return None
        value = int(word)
        if address.size == 1 and value not in {0, 1}:
            self.say("TIM005", part.span, address=address.text, what=_BIT, word=word)
        elif address.size > 1 and not address.fits(value):
            what = Text(f"只有{address.size}位", f"has {address.size} bits")
            self.say("TIM005", part.span, address=address.text, what=what, word=word)
        else:
            return value
        return None
