"""A piece of a ladder as a signal: a list run over pieces puts into each cell the part of the ladder that the cell stands for.

A piece is what lies between the left rail and a place on a wire: the piece just before it, and what is added last. Going back
from piece to piece gives its spine. A branch instruction copies the very same piece, so two flows that part at a branch point
have spines that begin with the same pieces, by identity; that is all that tells a branch point from a stem drawn twice.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from plcteach.core.ladder import OPPOSITE, Compared, Contact, Edge, Invert

if TYPE_CHECKING:
    from plcteach.core.area import Address

MOST_DRAWN = 2_000
"""More symbols than any rung has; what would be larger is not drawn."""

_HUGE = 10**9


@dataclass(slots=True)
class Page:
    """Which line of the list is being read."""

    line: int = 0


@dataclass(frozen=True, slots=True)
class Mark:
    """One symbol, the lines that make it, and the places that it reads; no symbol for a value that comes from nowhere."""

    symbol: Contact | Compared | Invert | Edge | None
    lines: tuple[int, ...]
    places: tuple[Address, ...] = ()


@dataclass(frozen=True, slots=True)
class Block:
    """A block of its own, in series with what stands before it."""

    inner: Piece


@dataclass(frozen=True, slots=True)
class Fork:
    """Two paths in parallel; each is a piece whose spine begins at the rail, or with the piece before the fork."""

    upper: Piece
    lower: Piece


@dataclass(frozen=True, slots=True, eq=False)
class Piece:
    """What leads from the left rail to one place: the piece before it, and what is added there.

    at: the line that made it.  fresh: a bit that this line has just read and that stands in no cell yet.  deep: how many pieces
    its spine has.  size: how many symbols it is when drawn.  nest, high: how deeply its last part, and its whole, is nested.
    """

    page: Page
    before: Piece | None
    own: Mark | Block | Fork
    at: int
    fresh: bool = False
    head: Piece | None = None
    deep: int = 1
    size: int = 1
    nest: int = 1
    high: int = 1

    def __repr__(self) -> str:
        return f"Piece(line {self.at}, {self.size} symbols)"

    @property
    def start(self) -> Piece:
        """The first piece of its spine."""
        return self.head or self

    @property
    def added(self) -> int:
        """How many symbols it adds to the piece before it."""
        return self.size - self.before.size if self.before else self.size

    def __and__(self, other: Piece) -> Piece:
        return _made(self, Block(settled(other)), other.size, other.high + 1)

    def __or__(self, other: Piece) -> Piece:
        return _fork(self, settled(other))

    def __xor__(self, other: Piece) -> Piece:
        """Draw both ways to differ; a single contact is turned round by its other kind, a whole flow by NOT behind it."""
        mine, its = self.turned(), other.turned()
        if its:
            return (self & its) | ((mine or ~self) & other)
        other = settled(other)
        if mine:
            return (other & mine) | (~other & self)
        return ~(~self | other) | (~self & other)

    def __invert__(self) -> Piece:
        turned = self.turned() if self.fresh else None
        return turned or _made(settled(self), Mark(Invert(), (self.page.line,)), 1, 1)

    def edge(self, previous: Piece | None, *, rising: bool) -> Piece:
        """Give the contact of an edge for a bit just read, and otherwise the edge on the wire."""
        del previous
        edged = self.edged(rising=rising) if self.fresh else None
        return edged or self.remembered("", rising=rising)

    def remembered(self, memory: str, *, rising: bool) -> Piece:
        """Give the edge on the wire behind this piece, with the bit that remembers the last flow."""
        return _made(settled(self), Mark(Edge(rising, memory), (self.page.line,)), 1, 1)

    def turned(self) -> Piece | None:
        """Give a single contact as its inverse; None where there is no such contact."""
        mark = turned(self.own) if isinstance(self.own, Mark) and self.before is None else None
        if mark is None:
            return None
        return replace(self, own=mark if self.fresh else replace(mark, lines=(*mark.lines, self.page.line)))

    def edged(self, *, rising: bool) -> Piece | None:
        """Give a single normally open contact as the contact of its edge."""
        mark = edged(self.own, rising=rising) if isinstance(self.own, Mark) and self.before is None else None
        return replace(self, own=mark) if mark else None


def turned(mark: Mark) -> Mark | None:
    """Give the symbol that is closed where this one is open; an edge has none, nor has a comparison of reals."""
    match mark.symbol:
        case Contact(address, negated, "", immediate):
            return replace(mark, symbol=Contact(address, not negated, "", immediate))
        case Compared(left, relation, right, size) if size != "R":
            return replace(mark, symbol=Compared(left, OPPOSITE[relation], right, size))
    return None


def edged(mark: Mark, *, rising: bool) -> Mark | None:
    """Give the edge contact of a plain normally open contact."""
    match mark.symbol:
        case Contact(address, False, "", False):
            return replace(mark, symbol=Contact(address, edge="rise" if rising else "fall"))
    return None


def leaf(page: Page, symbol: Contact | Compared | None, places: tuple[Address, ...] = ()) -> Piece:
    """Make a contact just read by the line that the page is at; no symbol: a value from nowhere."""
    return Piece(page, None, Mark(symbol, (page.line,), places), page.line, fresh=symbol is not None)


def settled(one: Piece) -> Piece:
    """Give a piece as it stands in a cell, where NOT and edges no longer belong to the contact alone."""
    return replace(one, fresh=False) if one.fresh else one


def spine(end: Piece, after: Piece | None = None) -> list[Piece]:
    """Give the pieces from the rail, or from behind another piece of the spine, up to this one."""
    found: list[Piece] = []
    one: Piece | None = end
    while one is not None and one is not after:
        found.append(one)
        one = one.before
    return found[::-1]


def _made(before: Piece, own: Mark | Block, size: int, nest: int) -> Piece:
    return Piece(
        before.page, before, own, before.page.line, head=before.start, deep=before.deep + 1,
        size=min(before.size + size, _HUGE), nest=nest, high=max(before.high, nest),
    )  # fmt: skip


def _fork(upper: Piece, lower: Piece) -> Piece:
    """Put two pieces in parallel; what their spines have in common stands before the fork and is drawn once."""
    shared = _shared(upper, lower)
    sides = [spine(upper, shared), spine(lower, shared)] if shared else []
    nest = 1 + (max(one.nest for side in sides for one in side) if shared else max(upper.high, lower.high))
    size = upper.size + lower.size - (shared.size if shared else 0)
    own = Fork(upper, lower)
    page = upper.page
    if shared is None:
        return Piece(page, None, own, page.line, size=min(size, _HUGE), nest=nest, high=nest)
    return Piece(
        page, shared, own, page.line, head=shared.start, deep=shared.deep + 1,
        size=min(size, _HUGE), nest=nest, high=max(shared.high, nest),
    )  # fmt: skip


def _shared(one: Piece, other: Piece) -> Piece | None:
    """Give the last piece that two spines share; None if they share none, or one of the two is that piece itself."""
    if one.start is not other.start or max(one.size, other.size) > MOST_DRAWN:
        return None
    first, second = one, other
    while first is not second:
        longer = first if first.deep >= second.deep else second
        back = longer.before
        if back is None:
            return None
        first, second = (back, second) if longer is first else (first, back)
    return None if first is one or first is other else first
