"""The Boolean formula as a signal: run a program over it and every cell knows how it was made.

Formulas are graphs: the same formula is the same object, however often it is used, so that a list of 80 lines whose formula
would fill a book is still computed at once. Writing one out stops at a limit and says so.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING
from weakref import WeakValueDictionary

from plcteach.machine.step import Stacks, Step, step

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.area import Address
    from plcteach.core.insn import Operand
    from plcteach.core.program import Compare, Program

MOST_NODES = 2_000

_known: WeakValueDictionary[tuple[object, ...], Term] = WeakValueDictionary()


@dataclass(frozen=True, slots=True, eq=False, weakref_slot=True)
class Term:
    """A node of a formula: an operator over other terms, or a name. Make one with `name` or the operators."""

    op: str
    parts: tuple[Term, ...]
    word: str = ""

    def __repr__(self) -> str:
        return f"Term({written(self)})"

    def __and__(self, other: Term) -> Term:
        return _term("·", self, other)

    def __or__(self, other: Term) -> Term:
        return _term("+", self, other)

    def __xor__(self, other: Term) -> Term:
        return _term("⊕", self, other)

    def __invert__(self) -> Term:
        return self.parts[0] if self.op == "/" else _term("/", self)

    def edge(self, previous: Term | None, *, rising: bool) -> Term:
        """Give the edge of this term; a formula says what is meant, not what it was before."""
        del previous
        return _term("↑" if rising else "↓", self)


def _term(op: str, *parts: Term, word: str = "") -> Term:
    key = (op, word, *(id(part) for part in parts))
    found = _known.get(key)
    if found is None:
        found = Term(op, parts, word)
        _known[key] = found
    return found


def name(word: str) -> Term:
    """Make the formula that is one name: an address, S0, iv3, or x for a value that nobody knows."""
    return _term("", word=word)


_BINDS = {"+": 1, "⊕": 2, "·": 3, "/": 4, "↑": 4, "↓": 4, "": 5}


def written(term: Term, most: int = MOST_NODES) -> str:
    """Write a formula out (`I0.0·(I0.1+/I0.2)`); past `most` nodes it ends with an ellipsis."""
    return "".join(_pieces(term, most))


def _pieces(term: Term, most: int) -> Iterator[str]:
    """Walk the formula without recursion, so that depth costs nothing but time."""
    waiting: list[Term | str] = [term]
    while waiting:
        one = waiting.pop()
        if isinstance(one, str):
            yield one
            continue
        most -= 1
        if most < 0:
            yield "…"
            return
        waiting += reversed(list(_spelling(one)))


def _spelling(term: Term) -> Iterator[Term | str]:
    if not term.parts:
        yield term.word
        return
    if len(term.parts) == 1:
        yield term.op
    for number, part in enumerate(term.parts):
        if number:
            yield term.op
        loose = _BINDS[part.op] < _BINDS[term.op] or (len(term.parts) == 1 and part.op in "/↑↓" and part.op != "")
        yield from ("(", part, ")") if loose else (part,)


class Spelling:
    """A world in which every bit is its own name, so that a run over it spells out what each cell means.

    It has no time, no words and no course: blocks do nothing in it, and a comparison is a name like any other.
    """

    spells = True
    rail: Term | None = None

    def compare(self, compare: Compare) -> Term:
        """Give the comparison as a formula."""
        return name(compare.text)

    def register(self, word: str) -> Term:
        """Give a bit of the machine as a formula."""
        return name(word)

    def read(self, operand: Operand, address: Address) -> Term:
        """Give the address as a formula."""
        del operand
        return name(address.text)

    def past(self, address: Address | None, value: Term) -> tuple[Term, Term | None]:
        """Give the value itself; its edge is a sign before it."""
        del address
        return value, None

    def following(self, address: Address, count: int) -> tuple[Address, ...]:
        """Give the address alone; a formula is written once, however many bits take it."""
        del count
        return (address,)


def spelled(program: Program) -> tuple[Step[Term], ...]:
    """Run a program once over formulas: the same steps as any scan, each cell knowing how it was made."""
    shapes, world, blank = program.dialect.shapes, Spelling(), name("x")
    stacks: Stacks[Term] = tuple((blank,) * shape.depth if shape.fixed else () for shape in shapes)
    steps: list[Step[Term]] = []
    block = ""
    for network in program.networks:
        stacks = tuple(cells if shape.fixed else () for cells, shape in zip(stacks, shapes, strict=True))
        if network.block != block:
            block = network.block
            called = (name("1"), *(name("0") for _ in range(shapes[0].depth - 1)))
            stacks = (called if shapes[0].fixed else (), *stacks[1:])
        for line in network.lines:
            one = step(line, shapes, stacks, world, blank, number=len(steps))
            steps.append(one)
            stacks = one.after
    return tuple(steps)
