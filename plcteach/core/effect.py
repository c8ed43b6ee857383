"""What an instruction does to the stacks, and where each cell goes when it runs.

An effect is a value: clauses that take cells and give cells back, written in the notation of `core.notation`.

The clever part of this module is `flow`: it says, for stacks of given heights and whatever their cells hold, which cell each
cell afterwards was before, was copied from or was made from. The simulator, the animation, the figures and the stack rules all
follow the same flow, so that a picture can never disagree with the machine.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal


@dataclass(frozen=True, slots=True)
class Name:
    """A cell taken from the stack, or an operand."""

    name: str


@dataclass(frozen=True, slots=True)
class At:
    """The cell `n` places below the top; `n` is an operand's name until the line binds it to a number."""

    n: str | int


@dataclass(frozen=True, slots=True)
class Not:
    """The inverse."""

    of: Formula


@dataclass(frozen=True, slots=True)
class Both:
    """Two formulas and the operator between them: "&", "|" or "^"."""

    op: str
    left: Formula
    right: Formula


@dataclass(frozen=True, slots=True)
class Edge:
    """A rising or falling edge of a formula, from one evaluation to the next."""

    rising: bool
    of: Formula


Formula = Name | At | Not | Both | Edge


@dataclass(frozen=True, slots=True)
class Taken:
    """A cell that a clause takes: its name, the tag it must bear, and whether it may be missing."""

    name: str
    tag: str = ""
    optional: bool = False


@dataclass(frozen=True, slots=True)
class Given:
    """A cell that a clause gives back: how it is made, the tag it gets and the book's name for it."""

    formula: Formula
    tag: str = ""
    label: str = ""


@dataclass(frozen=True, slots=True)
class Clause:
    """What an effect does to one stack; in both tuples the top of the stack is the last."""

    stack: str
    takes: tuple[Taken, ...]
    gives: tuple[Given, ...]


@dataclass(frozen=True, slots=True)
class Effect:
    """What an instruction does to the stacks of its family."""

    clauses: tuple[Clause, ...]
    text: str

    def __repr__(self) -> str:
        return f"Effect({self.text!r})"

    def __hash__(self) -> int:
        return hash(self.text)

    @property
    def operands(self) -> frozenset[str]:
        """The names that must be declared as operands, because no clause takes them from a stack."""
        taken = {take.name for clause in self.clauses for take in clause.takes}
        used = {name for clause in self.clauses for give in clause.gives for name in names(give.formula)}
        return frozenset(used - taken)

    @property
    def labelled(self) -> bool:
        """Whether the textbook gives the new values names of its own."""
        return any(give.label for clause in self.clauses for give in clause.gives)

    def bind(self, numbers: dict[str, int]) -> Effect:
        """Put numbers for the operands inside "[n]", as a line `LDS 3` does."""
        if "[" not in self.text:
            return self
        return _bind(self, tuple(sorted(numbers.items())))


@lru_cache(maxsize=1024)
def _bind(effect: Effect, numbers: tuple[tuple[str, int], ...]) -> Effect:
    known = dict(numbers)
    clauses = tuple(
        replace(clause, gives=tuple(replace(give, formula=_bound(give.formula, known)) for give in clause.gives))
        for clause in effect.clauses
    )
    return replace(effect, clauses=clauses)


def _bound(formula: Formula, known: dict[str, int]) -> Formula:
    if isinstance(formula, At) and isinstance(formula.n, str):
        return At(known[formula.n])
    return formula


def names(formula: Formula) -> frozenset[str]:
    """Give every name in a formula, operands of "[n]" included."""
    match formula:
        case Name(name):
            return frozenset({name})
        case At(n):
            return frozenset({n} if isinstance(n, str) else ())
        case Not(of) | Edge(_, of):
            return names(of)
        case Both(_, left, right):
            return names(left) | names(right)


# Where the cells go.

Place = tuple[int, int]
"""A cell's place: the index of its stack in the dialect, and its position counted from the top, 0 first."""

How = Literal["kept", "copied", "made", "blank"]


@dataclass(frozen=True, slots=True)
class Origin:
    """Where a cell after the instruction comes from: moved, copied, made from others (or from none), or entered blank."""

    how: How
    sources: tuple[Place, ...] = ()
    formula: Formula | None = None
    tag: str = ""
    label: str = ""


@dataclass(frozen=True, slots=True)
class Shape:
    """What `flow` must know of a stack: its name, how many cells it can hold, and whether it always holds that many."""

    name: str
    depth: int
    fixed: bool


@dataclass(frozen=True, slots=True)
class Flow:
    """One effect on stacks of given heights.

    after: for each stack the origin of each cell, top first.  lost: cells that fell out at the bottom.
    dropped: cells popped and used for nothing.  merged: cells that went into a new value.
    missing: how many cells each stack was short of.  named: where each taken name stands (absent if missing).
    heads: how many cells of each stack the effect gives.  tails: the stretch of old cells that follows them unchanged.
    """

    after: tuple[tuple[Origin, ...], ...]
    lost: tuple[Place, ...]
    dropped: tuple[Place, ...]
    merged: tuple[Place, ...]
    missing: tuple[int, ...]
    named: dict[str, Place]
    tags: dict[str, str]
    heads: tuple[int, ...]
    tails: tuple[tuple[int, int], ...]


@lru_cache(maxsize=4096)
def flow(effect: Effect, shapes: tuple[Shape, ...], heights: tuple[int, ...]) -> Flow:
    """Say where every cell goes when `effect` runs on stacks of these heights, whatever the cells hold."""
    numbers = {shape.name: number for number, shape in enumerate(shapes)}
    named, tags, counts, missing = _take(effect, numbers, heights)
    homes = _homes(effect, numbers, named)
    after: list[tuple[Origin, ...]] = []
    lost: list[Place] = []
    heads: list[int] = []
    for number, shape in enumerate(shapes):
        cells = _given_cells(effect, shape.name, number, named, homes)
        heads.append(min(len(cells), shape.depth))
        cells += [Origin("kept", ((number, place),)) for place in range(counts[number], heights[number])]
        lost += [one.sources[0] for one in cells[shape.depth :] if one.how == "kept"]
        cells = cells[: shape.depth]
        if shape.fixed:
            cells += [Origin("blank")] * (shape.depth - len(cells))
        after.append(tuple(cells))
    room = [shape.depth - head for shape, head in zip(shapes, heads, strict=True)]
    tails = [(start, min(height, start + free)) for start, height, free in zip(counts, heights, room, strict=True)]
    dropped, merged = _gone(after, named, lost)
    return Flow(
        after=tuple(after),
        lost=tuple(lost),
        dropped=dropped,
        merged=merged,
        missing=missing,
        named=named,
        tags=tags,
        heads=tuple(heads),
        tails=tuple(tails),
    )


def _gone(
    after: list[tuple[Origin, ...]], named: dict[str, Place], lost: list[Place]
) -> tuple[tuple[Place, ...], tuple[Place, ...]]:
    """Tell the taken cells that are there no more: dropped unused, or merged into a new value."""
    origins = [origin for stack in after for origin in stack]
    kept = {origin.sources[0] for origin in origins if origin.how == "kept"}
    used = {place for origin in origins if origin.how == "made" for place in origin.sources}
    gone = [place for place in named.values() if place not in kept and place not in lost]
    return tuple(place for place in gone if place not in used), tuple(place for place in gone if place in used)


_Taking = tuple[dict[str, Place], dict[str, str], list[int], tuple[int, ...]]


def _take(effect: Effect, numbers: dict[str, int], heights: tuple[int, ...]) -> _Taking:
    named: dict[str, Place] = {}
    tags: dict[str, str] = {}
    counts = [0] * len(heights)
    missing = [0] * len(heights)
    for clause in effect.clauses:
        number = numbers[clause.stack]
        takes = list(clause.takes)
        while len(takes) > heights[number] and takes and takes[0].optional:
            takes.pop(0)
        missing[number] = max(0, len(takes) - heights[number])
        for place, take in enumerate(reversed(takes)):
            if place < heights[number]:
                named[take.name] = (number, place)
                tags[take.name] = take.tag
        counts[number] = min(len(takes), heights[number])
    return named, tags, counts, tuple(missing)


def _homes(effect: Effect, numbers: dict[str, int], named: dict[str, Place]) -> dict[str, Place]:
    """Choose for each taken cell the one place afterwards where it is the same cell and not a copy of it.

    A cell stays where it was if its name stands there; else it moves to the first place of its own stack, else of another.
    """
    found: dict[str, list[Place]] = {}
    for clause in effect.clauses:
        for place, give in enumerate(reversed(clause.gives)):
            if isinstance(give.formula, Name) and give.formula.name in named:
                found.setdefault(give.formula.name, []).append((numbers[clause.stack], place))
    return {
        name: min(places, key=lambda place, old=named[name]: (place != old, place[0] != old[0], -place[1]))  # type: ignore[misc]
        for name, places in found.items()
    }


def _given_cells(
    effect: Effect, stack: str, number: int, named: dict[str, Place], homes: dict[str, Place]
) -> list[Origin]:
    cells = []
    for clause in effect.clauses:
        if clause.stack != stack:
            continue
        for place, give in enumerate(reversed(clause.gives)):
            cells.append(_origin(give, (number, place), named, homes))
    return cells


def _origin(give: Given, here: Place, named: dict[str, Place], homes: dict[str, Place]) -> Origin:
    formula = give.formula
    match formula:
        case Name(name) if name in named:
            how: How = "kept" if homes[name] == here else "copied"
            return Origin(how, (named[name],), None, give.tag, give.label)
        case At(n) if isinstance(n, int):
            return Origin("copied", ((0, n),), None, give.tag, give.label)
    sources = tuple(sorted(named[name] for name in names(formula) if name in named))
    return Origin("made", sources, formula, give.tag, give.label)
