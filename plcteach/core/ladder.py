"""A rung as a tree: contacts in series and in parallel on the left, and on the right a node with one or more outputs.

    Node = Contact | Invert | Series | Parallel      from the left rail, or from a branch point, to the next node
    Out  = Coil | Branch                             what hangs on a node; a Branch goes on to a node of its own
    Rung = stem: Node, outs: Out, Out, …             so branch points within branch points are trees within trees

Addresses are words in upper case; whether a family has such a bit is asked when the rung is written out for it.
`Invert` turns round the whole flow on its left, from the rail on, as NOT does in every family.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

from plcteach.core.errors import DeclarationError

if TYPE_CHECKING:
    from collections.abc import Iterator

EdgeKind = Literal["", "rise", "fall"]
CoilKind = Literal["", "set", "reset", "not"]


@dataclass(frozen=True, slots=True)
class Contact:
    """A contact of one bit: normally open, normally closed (`negated`), or closed for one scan at an edge of the bit."""

    address: str
    negated: bool = False
    edge: EdgeKind = ""

    def __post_init__(self) -> None:
        """Put the address in upper case; an edge contact has no normally closed form."""
        object.__setattr__(self, "address", self.address.upper())
        if self.negated and self.edge:
            msg = f"contact {self.address}: either normally closed or an edge, not both"
            raise DeclarationError(msg)

    def __repr__(self) -> str:
        return f"Contact({self.mark}{self.address})"

    @property
    def mark(self) -> str:
        """What stands before the address in a drawing: "", "/", "P " or "N "."""
        return {"rise": "P ", "fall": "N "}.get(self.edge, "/" if self.negated else "")


@dataclass(frozen=True, slots=True)
class Invert:
    """NOT on the wire: everything that has come from the left rail is turned round."""

    def __repr__(self) -> str:
        return "Invert()"


@dataclass(frozen=True, slots=True)
class Series:
    """Parts one after the other; `series` makes it flat."""

    parts: tuple[Node, ...]

    def __repr__(self) -> str:
        return f"Series{self.parts!r}"


@dataclass(frozen=True, slots=True)
class Parallel:
    """Parts one below the other, the topmost first; `parallel` makes it flat."""

    parts: tuple[Node, ...]

    def __repr__(self) -> str:
        return f"Parallel{self.parts!r}"


Node = Contact | Invert | Series | Parallel


@dataclass(frozen=True, slots=True)
class Coil:
    """A coil, set, reset or inverted coil of one bit; set and reset may reach over `count` bits from there on."""

    address: str
    kind: CoilKind = ""
    count: int = 1

    def __post_init__(self) -> None:
        """Put the address in upper case."""
        object.__setattr__(self, "address", self.address.upper())

    def __repr__(self) -> str:
        return f"Coil({self.mark}{self.address}{f' {self.count}' if self.count > 1 else ''})"

    @property
    def mark(self) -> str:
        """What stands before the address in a drawing: "", "S ", "R " or "/ "."""
        return {"": "", "set": "S ", "reset": "R ", "not": "/ "}[self.kind]


@dataclass(frozen=True, slots=True)
class Branch:
    """One output path of a node: contacts, then a node with outputs of its own; `branch` makes it plain."""

    stem: Node
    outs: tuple[Out, ...]

    def __repr__(self) -> str:
        return f"Branch({self.stem!r} -> {self.outs!r})"


Out = Coil | Branch


@dataclass(frozen=True, slots=True)
class Rung:
    """One rung: what leads from the left rail to the first node, and what hangs there, in the order of execution.

    stem: None where the outputs hang on the rail itself, which can be drawn but which no family has instructions for.
    """

    stem: Node | None
    outs: tuple[Out, ...]
    title: str = ""

    def __post_init__(self) -> None:
        """Refuse a rung that does nothing."""
        if not self.outs:
            msg = "a rung ends in at least one coil"
            raise DeclarationError(msg)

    def __repr__(self) -> str:
        return f"Rung({self.stem!r} -> {self.outs!r})"

    @property
    def symbols(self) -> tuple[Contact | Invert | Coil, ...]:
        """Every contact, NOT and coil, in the order in which the rung is executed."""
        return tuple(_symbols(self))


@dataclass(frozen=True, slots=True)
class Ladder:
    """Rungs from top to bottom, with a title."""

    rungs: tuple[Rung, ...]
    title: str = ""

    def __repr__(self) -> str:
        return f"Ladder({len(self.rungs)} rungs{f', {self.title!r}' if self.title else ''})"


def series(*parts: Node) -> Node:
    """Put parts one after the other: a series within a series becomes one, and a single part is itself."""
    flat = tuple(one for part in parts for one in (part.parts if isinstance(part, Series) else (part,)))
    return flat[0] if len(flat) == 1 else Series(flat)


def parallel(*parts: Node) -> Node:
    """Put parts one below the other: a parallel within a parallel becomes one, and a single part is itself."""
    flat = tuple(one for part in parts for one in (part.parts if isinstance(part, Parallel) else (part,)))
    return flat[0] if len(flat) == 1 else Parallel(flat)


def branch(stem: Node, *outs: Out) -> Branch:
    """Make an output path; a node with one path that goes on is no node, so its contacts join the stem."""
    if len(outs) == 1 and isinstance(outs[0], Branch):
        return Branch(series(stem, outs[0].stem), outs[0].outs)
    return Branch(stem, outs)


def rung(stem: Node | None, *outs: Out, title: str = "") -> Rung:
    """Make a rung in the plain form that the reader of drawings gives too."""
    if len(outs) == 1 and isinstance(outs[0], Branch):
        only = outs[0]
        return Rung(series(stem, only.stem) if stem else only.stem, only.outs, title)
    return Rung(stem, outs, title)


def titled(one: Rung, title: str) -> Rung:
    """Give the same rung under another title."""
    return replace(one, title=title)


_Part = Node | Out | Rung


def _inside(part: _Part) -> tuple[_Part, ...]:
    """Give what a part is made of, in the order of execution."""
    match part:
        case Series(parts) | Parallel(parts):
            return parts
        case Branch(stem, outs):
            return (stem, *outs)
        case Rung(stem, outs):
            return outs if stem is None else (stem, *outs)
    return ()


def _symbols(top: Rung) -> Iterator[Contact | Invert | Coil]:
    waiting: list[_Part] = [top]
    while waiting:
        one = waiting.pop()
        if isinstance(one, Contact | Invert | Coil):
            yield one
        waiting += reversed(_inside(one))


MOST_NESTED = 60
"""Deeper than this no textbook nests, and no family's stack reaches; readers and writers of ladders refuse it."""


def depth(top: Node | Out | Rung) -> int:
    """Say how deeply a rung is nested, counted without recursion so that anything can be asked."""
    deepest, waiting = 0, [(top, 1)]
    while waiting:
        one, level = waiting.pop()
        deepest = max(deepest, level)
        waiting += [(part, level + 1) for part in _inside(one)]
    return deepest
