"""Text drawing and one-line form to ladder, and back: splits a text into rungs and has each one read.

    --[ I0.0 ]--+--[/I0.1 ]--( Q0.0 )          [ ] [/ ] [P ] [N ] [I ] [/I ] [ VW0 >= 5 ]      contacts
    --[ Q0.0 ]--+                              [NOT] [P] [N] [P:M0.0]                          on the wire
                                               ( ) (/ ) (S ) (R ) (P ) (N ) (I ) (SI ) (RI )   coils
    --[ I0.0 ]--{CU: CTU C0, 3 }               a box; its further inputs stand on rows of their own right below it,
    --[ I0.1 ]--{R:            }               from the left rail
    --{ LBL 1 }                                a box that takes no flow

Rungs are separated by blank lines or by headings (`Network 1 // title`); `//` begins a comment. Full-width characters and
box-drawing characters are understood, and columns are counted as they are seen: a full-width character takes two, a tab reaches to the next
multiple of eight.
"""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass, field

from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.ladder import Ladder, Rung, titled
from plcteach.core.source import Span, half_width
from plcteach.core.text import Text
from plcteach.ladder.oneline import read_line, write_line
from plcteach.ladder.reduce import rungs
from plcteach.ladder.telling import CONFIGURATION, HEADING, MOST_CHARACTERS, PLAIN
from plcteach.ladder.typeset import write_drawing
from plcteach.ladder.wires import FILL, TAB, Row

__all__ = ["read_drawing", "read_line", "write_drawing", "write_line"]

MOST_COLUMNS = 500
MOST_ROWS = 120
"""Rows of one rung."""
MOST_FINDINGS = 20

_CONTROL = re.compile(r"[\x00-\x08\x0e-\x1f\x7f]")


def read_drawing(text: str) -> tuple[Ladder, tuple[Diagnostic, ...]]:
    """Read a ladder; rungs that could not be read are left out, and everything found stands in the second value."""
    reading = _read(text, wide=True)
    if reading.diagnostics and not text.isascii():
        narrow = _read(text, wide=False)
        reading = reading if narrow.diagnostics else narrow
    if not reading.rungs and not reading.diagnostics:
        reading.diagnostics.append(rule("DRW015").at(Span(1)))
    return Ladder(tuple(reading.rungs), reading.title, tuple(reading.settings)), tuple(
        reading.diagnostics[:MOST_FINDINGS]
    )


def _read(text: str, *, wide: bool) -> _Reading:
    reading = _Reading(wide=wide)
    if len(text) > MOST_CHARACTERS:
        reading.too_large(Span(1), Text(f"{len(text)}个字符", f"{len(text)} characters"), f"{MOST_CHARACTERS}")
        return reading
    for number, line in enumerate(text.split("\n"), 1):
        reading.line(number, line.rstrip("\r"))
        if len(reading.diagnostics) >= MOST_FINDINGS:
            return reading
    reading.close()
    return reading


@dataclass(slots=True)
class _Reading:
    """A text being split into rungs."""

    wide: bool
    rungs: list[Rung] = field(default_factory=list)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    title: str = ""
    heading: str = ""
    rows: list[Row] = field(default_factory=list)
    begun: bool = False
    settings: list[str] = field(default_factory=list)

    def too_large(self, span: Span, size: Text, most: str) -> None:
        self.diagnostics.append(rule("DRW012").at(span, size=size, most=most))

    def line(self, number: int, given: str) -> None:
        code = given[: len(half_width(given).partition("//")[0])]
        control = _CONTROL.search(code)
        match = HEADING.fullmatch(half_width(given))
        if len(code) > MOST_COLUMNS:
            size = Text(f"一行{len(code)}个字符", f"a row of {len(code)} characters")
            self.too_large(Span(number, MOST_COLUMNS, len(code)), size, f"{MOST_COLUMNS}")
        elif control:
            at = control.start()
            self.diagnostics.append(rule("DRW001").at(Span(number, at, at + 1), word=f"U+{ord(code[at]):04X}"))
        elif CONFIGURATION.fullmatch(half_width(code)) and not (self.rungs or self.rows):
            self.settings.append(" ".join(half_width(code).split()))
        elif match:
            self.close()
            self.heading = given[match.start("rest") :].strip().lstrip("/:：").strip()
            self.begun = True
        else:
            self.drawn(number, given, code)

    def drawn(self, number: int, given: str, code: str) -> None:
        """Take a row: part of a drawing, a rung on one line, a comment, or the blank line after a rung."""
        plain = half_width(code)
        if not plain.strip():
            if not given.strip():
                self.close()
            elif not self.begun:
                self.title = given.strip().lstrip("/／").strip()
            elif not self.rows and not self.heading:
                self.heading = given.strip().lstrip("/／").strip()
            self.begun = True
            return
        self.begun = True
        if "->" in plain or "→" in plain:
            self.close()
            self.one_line(number, plain)
        elif len(self.rows) >= MOST_ROWS:
            self.too_large(
                Span(number), Text(f"一级超过{MOST_ROWS}行", f"a rung of more than {MOST_ROWS} rows"), f"{MOST_ROWS}"
            )
            self.rows.clear()
        else:
            self.rows.append(_row(number, code, wide=self.wide))

    def one_line(self, number: int, plain: str) -> None:
        found = read_line(plain, number)
        if isinstance(found, Diagnostic):
            self.diagnostics.append(found)
        else:
            self.add([found])

    def close(self) -> None:
        """Read the rows collected so far as one drawing."""
        if self.rows:
            made, found = rungs(self.rows)
            self.diagnostics += found
            self.rows = []
            self.add(made)

    def add(self, made: list[Rung]) -> None:
        if made and self.heading:
            made = [titled(made[0], self.heading), *made[1:]]
            self.heading = ""
        self.rungs += made


def _row(number: int, given: str, *, wide: bool) -> Row:
    """Spread a row over the columns in which it is seen."""
    plain = half_width(given.translate(PLAIN))
    tab = given.find("\t")
    if tab < 0 and (given.isascii() or not wide):
        return Row(number, plain, list(range(len(plain))))
    signs: list[str] = []
    places: list[int] = []
    within = 0
    for place, (sign, seen) in enumerate(zip(plain, given, strict=True)):
        two = wide and unicodedata.east_asian_width(seen) in "WF"
        after = plain[place + 1 : place + 2]
        cells = " " * (TAB - len(places) % TAB) if seen == "\t" else _double(sign, after, within) if two else sign
        within = max(0, within + (sign in "[({") - (sign in "])}"))
        signs.append(cells)
        places += [place] * len(cells)
    return Row(number, "".join(signs), places, None if tab < 0 else tab)


def _double(sign: str, after: str, within: int) -> str:
    """Give the two columns of a full-width sign; a wire fills both, but within brackets there are no wires."""
    if sign in "])}":
        return FILL + sign
    if sign in "-|+" and not within:
        return sign + ("-" if sign == "-" or (after and after in "-|+[({") else " ")
    return sign * 2 if sign == " " else sign + FILL
