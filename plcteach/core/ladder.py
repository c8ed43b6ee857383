"""A rung as a tree: contacts in series and in parallel on the left, and on the right a node with one or more outputs.

    Node = Contact | Compared | Invert | Edge | Series | Parallel     from the left rail, or a branch point, to the next node
    Out  = Coil | Box | Branch                       what hangs on a node; a Branch goes on to a node of its own
    Rung = stem: Node, outs: Out, Out, …             so branch points within branch points are trees within trees

Addresses are words in upper case; whether a family has such a bit is asked when the rung is written out for it.
`Invert` turns round the whole flow on its left, from the rail on, as NOT does in every family; `Edge` lets it through for the
one scan in which it changes.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

from plcteach.core.errors import DeclarationError

if TYPE_CHECKING:
    from collections.abc import Iterator

EdgeKind = Literal["", "rise", "fall"]
CoilKind = Literal["", "set", "reset", "not", "rise", "fall"]
Relation = Literal["=", "<>", ">=", "<=", ">", "<"]
OPPOSITE: dict[Relation, Relation] = {"=": "<>", "<>": "=", ">": "<=", "<=": ">", "<": ">=", ">=": "<"}
Size = Literal["", "B", "D", "R"]
"""How wide the words of a comparison are: a word of 16 bits, a byte, a double word, or a real."""


@dataclass(frozen=True, slots=True)
class Contact:
    """A contact of one bit: normally open, normally closed (`negated`), or closed for one scan at an edge of the bit.

    immediate: it reads the input itself at that moment, and not the process image.
    """

    address: str
    negated: bool = False
    edge: EdgeKind = ""
    immediate: bool = False

    def __post_init__(self) -> None:
        """Put the address in upper case; an edge contact has neither a normally closed nor an immediate form."""
        object.__setattr__(self, "address", self.address.upper())
        if self.edge and (self.negated or self.immediate):
            msg = f"contact {self.address}: an edge is neither normally closed nor immediate"
            raise DeclarationError(msg)

    def __repr__(self) -> str:
        return f"Contact({self.mark}{self.address})"

    @property
    def mark(self) -> str:
        """What stands before the address in a drawing: "", "/", "P ", "N ", "I " or "/I "."""
        plain = ("/" if self.negated else "") + ("I " if self.immediate else "")
        return {"rise": "P ", "fall": "N "}.get(self.edge, plain)


@dataclass(frozen=True, slots=True)
class Compared:
    """A contact that is closed while a relation holds between two words, each an address or a constant."""

    left: str
    relation: Relation
    right: str
    size: Size = ""

    def __post_init__(self) -> None:
        """Put the words in upper case."""
        object.__setattr__(self, "left", self.left.upper())
        object.__setattr__(self, "right", self.right.upper())

    def __repr__(self) -> str:
        return f"Compared({self.text})"

    @property
    def text(self) -> str:
        """What stands between the brackets of a drawing: VW0 >= 5, VD4 <R 1.5."""
        return f"{self.left} {self.relation}{self.size} {self.right}"


@dataclass(frozen=True, slots=True)
class Edge:
    """An edge on the wire: power passes for the one scan in which the flow from the left has come, or gone.

    memory: the bit that keeps the last flow, where the family wants one named (GUTTA).
    """

    rising: bool = True
    memory: str = ""

    def __post_init__(self) -> None:
        """Put the memory bit in upper case."""
        object.__setattr__(self, "memory", self.memory.upper())

    def __repr__(self) -> str:
        return f"Edge({self.mark})"

    @property
    def mark(self) -> str:
        """What stands between the brackets of a drawing: P, N, or with its memory P:M0.0."""
        return ("P" if self.rising else "N") + (f":{self.memory}" if self.memory else "")


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


Node = Contact | Compared | Invert | Edge | Series | Parallel


@dataclass(frozen=True, slots=True)
class Coil:
    """A coil, set, reset, inverted or pulse coil of one bit; set and reset may reach over `count` bits from there on.

    A pulse coil (kind "rise" or "fall") is on for the one scan in which the flow comes or goes.
    immediate: it writes the output itself at that moment, and the process image.
    """

    address: str
    kind: CoilKind = ""
    count: int = 1
    immediate: bool = False

    def __post_init__(self) -> None:
        """Put the address in upper case."""
        object.__setattr__(self, "address", self.address.upper())

    def __repr__(self) -> str:
        return f"Coil({self.mark}{self.address}{f' {self.count}' if self.count > 1 else ''})"

    @property
    def mark(self) -> str:
        """What stands before the address in a drawing: "", "S ", "R ", "/ ", "P ", "N ", or "I ", "SI ", "RI "."""
        plain = {"": "", "set": "S", "reset": "R", "not": "/", "rise": "P", "fall": "N"}[self.kind]
        return f"{plain}I " if self.immediate else f"{plain} ".lstrip()


@dataclass(frozen=True, slots=True)
class Box:
    """An instruction drawn as a box at the right: a timer, a counter, a block, a move, a jump.

    text: the instruction as its family's list has it, "TON T37, 50".  pins: inputs beside the first, each with its name and
    what leads to it from the left rail, in the order of the list.  entry: the name of the first, where there are several.
    A box whose instruction takes no flow (a label) is a rung without a stem.
    """

    text: str
    pins: tuple[tuple[str, Node], ...] = ()
    entry: str = ""

    def __post_init__(self) -> None:
        """Put the text in upper case and its blanks in order."""
        object.__setattr__(self, "text", " ".join(self.text.upper().split()))

    def __repr__(self) -> str:
        return f"Box({self.text!r}{''.join(f', {name}={node!r}' for name, node in self.pins)})"

    @property
    def word(self) -> str:
        """The mnemonic."""
        return self.text.partition(" ")[0]

    @property
    def operands(self) -> str:
        """What follows the mnemonic."""
        return self.text.partition(" ")[2]


@dataclass(frozen=True, slots=True)
class Branch:
    """One output path of a node: contacts, then a node with outputs of its own; `branch` makes it plain."""

    stem: Node
    outs: tuple[Out, ...]

    def __repr__(self) -> str:
        return f"Branch({self.stem!r} -> {self.outs!r})"


Out = Coil | Box | Branch
Symbol = Contact | Compared | Invert | Edge | Coil | Box
"""What a drawing shows as one sign."""


@dataclass(frozen=True, slots=True)
class Rung:
    """One rung: what leads from the left rail to the first node, and what hangs there, in the order of execution.

    stem: None where the outputs hang on the rail itself: a box that takes no flow, or what no family has instructions for.
    """

    stem: Node | None
    outs: tuple[Out, ...]
    title: str = ""

    def __post_init__(self) -> None:
        """Refuse a rung that does nothing, and a box of several inputs that something follows: its inputs stay on the stack."""
        if not self.outs:
            msg = "a rung ends in at least one coil"
            raise DeclarationError(msg)
        ends = [one for one in self.symbols if isinstance(one, Coil | Box)]
        if any(isinstance(one, Box) and one.pins for one in ends[:-1]):
            msg = "a box of several inputs is the last output of its rung"
            raise DeclarationError(msg)

    def __repr__(self) -> str:
        return f"Rung({self.stem!r} -> {self.outs!r})"

    @property
    def symbols(self) -> tuple[Symbol, ...]:
        """Every contact, NOT, edge, coil and box, in the order in which the rung is executed; a box after its inputs."""
        return tuple(symbols_of(self))


@dataclass(frozen=True, slots=True)
class Ladder:
    """Rungs from top to bottom, with a title; configuration: the lines that set up its blocks, before the first rung."""

    rungs: tuple[Rung, ...]
    title: str = ""
    configuration: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"Ladder({len(self.rungs)} rungs{f', {self.title!r}' if self.title else ''})"


def in_series(node: Node) -> tuple[Node, ...]:
    """Give the parts of a series; any other node is its own only part."""
    return node.parts if isinstance(node, Series) else (node,)


def series(*parts: Node) -> Node:
    """Put parts one after the other: a series within a series becomes one, and a single part is itself."""
    flat = tuple(one for part in parts for one in in_series(part))
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
        case Box(_, pins):
            return tuple(node for _, node in pins)
        case Rung(stem, outs):
            return outs if stem is None else (stem, *outs)
    return ()


def symbols_of(top: Node | Out | Rung) -> Iterator[Symbol]:
    """Give every symbol of a part in the order of execution, without recursion; a box after its inputs."""
    waiting: list[tuple[_Part, bool]] = [(top, False)]
    while waiting:
        one, seen = waiting.pop()
        inside = _inside(one)
        if isinstance(one, Box) and inside and not seen:
            waiting += [(one, True), *((part, False) for part in reversed(inside))]
        elif isinstance(one, Contact | Compared | Invert | Edge | Coil | Box):
            yield one
        else:
            waiting += [(part, False) for part in reversed(inside)]


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
