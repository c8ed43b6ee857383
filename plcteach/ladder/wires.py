"""Reads one drawn rung: signs on a grid become nets of wire, and symbols become the edges between nets.

There are no crossings in a ladder, so wires that touch are joined. A `+` joins in all four directions, but upwards and downwards
only to another `+` or `|`; two `-` one below the other do not touch. Everything within three columns of the left margin is the
left rail, because no symbol is narrower than that.
"""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.ladder import Box, Coil
from plcteach.core.ladder import Symbol as Drawn
from plcteach.core.source import Span
from plcteach.core.text import Text, same
from plcteach.ladder.symbols import Input, box, coil, contact, shortened

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

Cell = tuple[int, int]
Symbol = Drawn | Input
LEFT = 0
"""The net of the left rail."""

FILL = "\ufdd0"
"""Stands in the second column of a sign that is two columns wide."""

TAB = 8
"""A tab reaches to the next multiple of so many columns."""

_MARGIN = 3
_WIRES = frozenset("-|+")
_TOKEN = re.compile(
    r"(?P<wire>[-|+]+)|(?P<symbol>\[[^\[\]]*\]|\([^()]*\)|\{[^{}]*\})|(?P<open>[\[\](){}])|(?P<word>[^\s\-|+\[\](){}]+)"
)


_READERS: dict[str, tuple[str, Callable[[str], Symbol | None]]] = {
    "[": ("DRW003", contact),
    "(": ("DRW004", coil),
    "{": ("DRW005", box),
}
"""What reads the words in a pair of brackets, and what is said where it cannot."""


class Row(NamedTuple):
    """One row of a drawing in columns as they are seen.

    places: for each column the code point in the text.  tab: the code point of the first tab, if there is one.
    """

    number: int
    signs: str
    places: list[int]
    tab: int | None = None

    def span(self, start: int, stop: int) -> Span:
        """Give the place in the text of some columns."""
        places = [*self.places, self.places[-1] + 1 if self.places else 0]
        return Span(self.number, places[min(start, len(self.signs))], places[min(stop, len(self.signs))])


@dataclass(slots=True)
class Element:
    """A symbol where it was drawn, and the nets at its two ends (None: nothing there)."""

    symbol: Symbol
    row: int
    start: int
    stop: int
    source: int | None = None
    target: int | None = None

    @property
    def last(self) -> bool:
        """Whether a path ends here, at a coil, a box or an input of one."""
        return isinstance(self.symbol, Coil | Box | Input)


@dataclass(slots=True)
class Sheet:
    """A drawn rung: its rows, its elements from top to bottom, the net of each piece of wire, and where symbols end."""

    rows: list[Row]
    elements: list[Element] = field(default_factory=list)
    nets: dict[Cell, int] = field(default_factory=dict)
    tips: Counter[Cell] = field(default_factory=Counter)
    found: list[Diagnostic] = field(default_factory=list)

    def say(self, code: str, row: int, start: int, stop: int, **values: object) -> None:
        """Note a finding at some columns of a row."""
        self.found.append(rule(code).at(self.rows[row].span(start, stop), **values))

    def say_of(self, code: str, element: Element, **values: object) -> None:
        """Note a finding at an element, which it names."""
        self.say(code, element.row, element.start, element.stop, word=self.name(element), **values)

    def name(self, element: Element) -> Text:
        """Give an element as it was drawn."""
        return same(shown(self.rows[element.row].signs[element.start : element.stop]))

    @property
    def edge(self) -> int:
        """The column up to which everything is the left rail."""
        begin = (len(row.signs) - len(row.signs.lstrip()) for row in self.rows if row.signs.strip())
        return min(begin, default=0) + _MARGIN

    def sign(self, row: int, column: int) -> str:
        """Give the wire sign in a cell, or nothing."""
        return self.rows[row].signs[column] if (row, column) in self.nets else ""


def shown(words: str) -> str:
    """Give what was drawn as a message may show it."""
    return shortened(words.replace(FILL, ""))


def sheet(rows: list[Row]) -> Sheet:
    """Find the symbols and nets of one drawn rung; with a sign that cannot be read, the nets are left out."""
    out = Sheet(rows)
    for number in range(len(rows)):
        _tokens(out, number)
    if not out.found:
        _number_nets(out)
        _connect(out)
    return out


def _tokens(out: Sheet, row: int) -> None:
    """Cut a row into wires and symbols; after a bracket without a partner nothing more of the row can be told apart."""
    for match in _TOKEN.finditer(out.rows[row].signs):
        start, stop = match.span()
        if match["wire"]:
            out.nets.update({(row, column): -1 for column in range(start, stop)})
        elif match["symbol"]:
            _symbol(out, row, start, stop)
        else:
            code = "DRW002" if match["open"] else "DRW001"
            out.say(code, row, start, stop, word=same(shown(match[0])))
            if match["open"]:
                return


def _symbol(out: Sheet, row: int, start: int, stop: int) -> None:
    drawn = out.rows[row].signs[start:stop]
    words = drawn[1:-1].replace(FILL, "")
    code, read = _READERS[drawn[0]]
    symbol = read(words)
    if symbol is None:
        out.say(code, row, start, stop, word=same(shown(drawn)))
    else:
        out.elements.append(Element(symbol, row, start, stop))


def neighbours(out: Sheet, cell: Cell) -> Iterator[Cell]:
    """Give the wires that touch a piece of wire."""
    row, column = cell
    sign = out.rows[row].signs[column]
    for other in ((row, column - 1), (row, column + 1)):
        if other in out.nets and sign + out.rows[row].signs[other[1]] != "||":
            yield other
    for other in ((row - 1, column), (row + 1, column)):
        if other in out.nets and sign + out.rows[other[0]].signs[column] not in {"--", "+-", "-+"}:
            yield other


def _number_nets(out: Sheet) -> None:
    """Give all wires that hang together one number, the left rail being 0."""
    first = [next((at for at, sign in enumerate(row.signs) if not sign.isspace()), None) for row in out.rows]
    edge = out.edge
    rail = [(row, column) for row, column in enumerate(first) if column is not None and column < edge]
    _flood(out, [cell for cell in rail if cell in out.nets], LEFT)
    number = LEFT
    for cell in list(out.nets):
        if out.nets[cell] < 0:
            number += 1
            _flood(out, [cell], number)


def _flood(out: Sheet, waiting: list[Cell], number: int) -> None:
    while waiting:
        cell = waiting.pop()
        if out.nets[cell] < 0:
            out.nets[cell] = number
            waiting += neighbours(out, cell)


def _connect(out: Sheet) -> None:
    """Find the net at each end of each element; elements drawn without a gap share a net of their own."""
    fresh, edge = max(out.nets.values(), default=LEFT), out.edge
    before: Element | None = None
    for element in out.elements:
        row = element.row
        out.tips.update(((row, element.start - 1), (row, element.stop)))
        element.source = out.nets.get((row, element.start - 1))
        if element.source is None and before and (before.row, before.stop) == (row, element.start):
            fresh += 1
            before.target = element.source = fresh
        elif element.source is None and not out.rows[row].signs[: element.start].strip() and element.start < edge:
            element.source = LEFT
        element.target = out.nets.get((row, element.stop))
        before = element


def ends(out: Sheet, cell: Cell) -> int:
    """Count what touches a piece of wire: other wires and symbols."""
    return out.tips[cell] + len(list(neighbours(out, cell)))
