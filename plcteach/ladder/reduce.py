"""Makes rungs of nets and elements: joins what is parallel and what is in series, until only branch points are left.

Two paths between the same two nets become one, parallel; a net that one path enters and one path leaves is no node but a place
within a series. What remains of a ladder that an instruction list can express is a tree: each node is reached by one path.
A further input of a box is a path of its own from the left rail; it belongs to the box above it.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from plcteach.core.ladder import (
    MOST_NESTED,
    Box,
    Branch,
    Coil,
    Node,
    Out,
    Rung,
    branch,
    depth,
    parallel,
    rung,
    series,
)  # fmt: skip
from plcteach.core.text import Text
from plcteach.ladder.faults import check
from plcteach.ladder.symbols import Input
from plcteach.ladder.wires import LEFT, Element, Sheet, ends, sheet

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.ladder.wires import Cell, Row

_NO_BOX = Text("没有方框", "there is none")


@dataclass(frozen=True, slots=True)
class _Path:
    """A way from one net to another: its parallel parts, each with the row on which it begins."""

    parts: tuple[tuple[int, Node], ...]
    source: int
    target: int

    @property
    def node(self) -> Node:
        return parallel(*(node for _, node in self.parts))


def rungs(rows: list[Row]) -> tuple[list[Rung], list[Diagnostic]]:
    """Read the rows of one drawing; what begins at the left rail with paths of its own is a rung each."""
    drawn = sheet(rows)
    if not drawn.found:
        check(drawn)
    if drawn.found:
        return [], drawn.found
    paths: list[_Path] = []
    outputs: list[Element] = []
    for one in drawn.elements:
        one.source = one.source or LEFT
        if isinstance(one.symbol, Input):
            one.symbol = (one.symbol.label if one.source == LEFT else None) or one.symbol
        if isinstance(one.symbol, Coil | Box | Input):
            outputs.append(one)
        else:
            paths.append(_Path(((one.row, one.symbol),), one.source, one.target or LEFT))
    return _Tree(drawn, _reduced(paths, {one.source or LEFT for one in outputs}), outputs).rungs()


def _reduced(paths: list[_Path], outputs: set[int]) -> list[_Path]:
    """Join parallel paths and paths in series until nothing more can be joined."""
    count = -1
    while len(paths) != count:
        count = len(paths)
        paths = _in_series(_side_by_side(paths), outputs)
    return paths


def _side_by_side(paths: list[_Path]) -> list[_Path]:
    groups: dict[tuple[int, int], list[tuple[int, Node]]] = {}
    for path in paths:
        groups.setdefault((path.source, path.target), []).extend(path.parts)
    return [_Path(tuple(sorted(parts, key=lambda part: part[0])), *ends_of) for ends_of, parts in groups.items()]


def _in_series(paths: list[_Path], outputs: set[int]) -> list[_Path]:
    entered, left = Counter(path.target for path in paths), Counter(path.source for path in paths)
    through = {net for net in entered if entered[net] == left[net] == 1 and net != LEFT and net not in outputs}
    after = {path.source: path for path in paths if path.source in through}
    out = []
    for path in paths:
        if path.source in through:
            continue
        chain = [path]
        while chain[-1].target in through:
            chain.append(after[chain[-1].target])
        parts = path.parts if len(chain) == 1 else ((path.parts[0][0], series(*(one.node for one in chain))),)
        out.append(_Path(parts, path.source, chain[-1].target))
    return out


@dataclass(slots=True)
class _Tree:
    """What the reduction left, on its way to rungs.

    outputs: coils, boxes, and inputs of boxes.  pins: the further inputs of the box that stands in a cell, topmost first.
    placed: each coil and box as it went into a rung, and where it was drawn.
    """

    drawn: Sheet
    paths: list[_Path]
    outputs: list[Element]
    pins: dict[Cell, list[tuple[str, Node]]] = field(default_factory=dict)
    placed: list[tuple[Coil | Box, Element]] = field(default_factory=list)

    def rungs(self) -> tuple[list[Rung], list[Diagnostic]]:
        self.bridges()
        if not self.drawn.found:
            self.unreached()
        if not self.drawn.found:
            self.inputs()
        outs = [] if self.drawn.found else self.outs(LEFT)
        for out in outs:
            self.followed(out)
        if not self.drawn.found:
            self.apart()
        if self.drawn.found:
            return [], self.drawn.found
        made = [rung(None, out) for out in outs]
        if any(depth(one) > MOST_NESTED for one in made):
            self.drawn.say("DRW014", 0, 0, 1, most=MOST_NESTED)
            return [], self.drawn.found
        return made, []

    def inputs(self) -> None:
        """Give the boxes their further inputs; report an input without a box, or without a path of its own from the left rail."""
        for one in self.outputs:
            if not isinstance(one.symbol, Input):
                continue
            boxes = [other for other in self.above(one) if isinstance(other.symbol, Box)]
            path = self.lead(one)
            if not boxes:
                self.no_box(one)
            elif path is None:
                self.drawn.say_of("DRW019", one)
            else:
                self.paths.remove(path)
                self.pins.setdefault((boxes[-1].row, boxes[-1].start), []).append((one.symbol.name, path.node))

    def lead(self, one: Element) -> _Path | None:
        """Give the path that leads from the left rail to one input and to nothing else."""
        others = [other for other in self.outputs if other is not one and other.source == one.source]
        touching = [path for path in self.paths if one.source in {path.source, path.target}]
        alone = not others and len(touching) == 1 and (touching[0].source, touching[0].target) == (LEFT, one.source)
        return touching[0] if alone else None

    def above(self, one: Element) -> list[Element]:
        """Give the coils and boxes that are drawn above an input."""
        return [other for other in self.outputs if other.row < one.row and not isinstance(other.symbol, Input)]

    def followed(self, out: Out) -> None:
        """Report a box of several inputs that another output of its rung follows."""
        for one in list(_last(out))[:-1]:
            if isinstance(one, Box) and one.pins:
                self.drawn.say_of("DRW020", next(element for made, element in self.placed if made is one))

    def apart(self) -> None:
        """Report an input that a coil or box of another rung keeps apart from its box."""
        for one in self.outputs:
            if isinstance(one.symbol, Input) and not isinstance(self.above(one)[-1].symbol, Box):
                self.no_box(one)

    def no_box(self, one: Element) -> None:
        """Say of an input that no box stands above it, and what does."""
        above = self.above(one)[-1:]
        stands = [Text(f"是 {name.zh}", f"stands {name.en}") for name in map(self.drawn.name, above)]
        self.drawn.say_of("DRW018", one, above=(stands or [_NO_BOX])[0])

    def bridges(self) -> None:
        """Report the first net that more than one path enters, or a path back to the left rail."""
        entered = Counter(path.target for path in self.paths)
        wrong = {net for net, count in entered.items() if count > 1 or net == LEFT}
        if wrong:
            joints = [cell for cell, net in self.drawn.nets.items() if net in wrong and ends(self.drawn, cell) > 2]  # noqa: PLR2004
            places = [(one.row, one.stop) for one in self.drawn.elements if one.target in wrong]
            row, column = min(joints or places)
            self.drawn.say("DRW009", row, column, column + 1)

    def unreached(self) -> None:
        """Report an element in a ring that no path from the left rail enters."""
        reached, waiting = {LEFT}, [LEFT]
        while waiting:
            here = waiting.pop()
            fresh = [path.target for path in self.paths if path.source == here and path.target not in reached]
            reached.update(fresh)
            waiting += fresh
        for one in self.drawn.elements:
            if one.source not in reached and any(path.source == one.source for path in self.paths):
                self.drawn.say_of("DRW008", one)
                return

    def outs(self, net: int) -> list[Out]:
        """Give what hangs on a net, from top to bottom by the row of the uppermost coil or box."""
        found: list[tuple[int, Out]] = [
            (one.row, self.output(one, one.symbol))
            for one in self.outputs
            if one.source == net and isinstance(one.symbol, Coil | Box)
        ]
        for path in self.paths:
            if path.source == net:
                outs = self.outs(path.target)
                found.append((self.top(path.target), branch(path.node, *outs)))
        return [out for _, out in sorted(found, key=lambda item: item[0])]

    def output(self, one: Element, made: Coil | Box) -> Coil | Box:
        """Give a coil, or a box its further inputs, and keep in mind where it stands."""
        if isinstance(made, Box):
            made = replace(made, pins=tuple(self.pins.get((one.row, one.start), ())))
        self.placed.append((made, one))
        return made

    def top(self, net: int) -> int:
        rows = [one.row for one in self.outputs if one.source == net]
        rows += [self.top(path.target) for path in self.paths if path.source == net]
        return min(rows)


def _last(out: Out) -> Iterator[Coil | Box]:
    """Give the coils and boxes of an output in the order of execution."""
    if isinstance(out, Branch):
        for one in out.outs:
            yield from _last(one)
    else:
        yield out


def reduced(ways: list[tuple[int, Node, int, int]], outputs: set[int]) -> list[tuple[int, Node, int, int]]:
    """Join what is parallel and in series among ways of any origin: each has its place from above, its node, and its two nets."""
    paths = _reduced([_Path(((at, node),), source, target) for at, node, source, target in ways], outputs)
    return [(path.parts[0][0], path.node, path.source, path.target) for path in paths]
