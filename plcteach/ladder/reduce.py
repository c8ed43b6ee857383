"""Makes rungs of nets and elements: joins what is parallel and what is in series, until only branch points are left.

Two paths between the same two nets become one, parallel; a net that one path enters and one path leaves is no node but a place
within a series. What remains of a ladder that an instruction list can express is a tree: each node is reached by one path.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.core.ladder import (
    MOST_NESTED,
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
from plcteach.ladder.faults import check
from plcteach.ladder.wires import LEFT, Sheet, ends, sheet

if TYPE_CHECKING:
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.ladder.wires import Row


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
    paths, coils = _graph(drawn)
    paths = _reduced(paths, {net for net, _, _ in coils})
    return _Tree(drawn, paths, coils).rungs()


def _graph(drawn: Sheet) -> tuple[list[_Path], list[tuple[int, int, Coil]]]:
    paths, coils = [], []
    for one in drawn.elements:
        source, target = one.source or LEFT, one.target or LEFT
        if isinstance(one.symbol, Coil):
            coils.append((source, one.row, one.symbol))
        else:
            paths.append(_Path(((one.row, one.symbol),), source, target))
    return paths, coils


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
    """What the reduction left, on its way to rungs."""

    drawn: Sheet
    paths: list[_Path]
    coils: list[tuple[int, int, Coil]]

    def rungs(self) -> tuple[list[Rung], list[Diagnostic]]:
        self.bridges()
        if not self.drawn.found:
            self.unreached()
        if self.drawn.found:
            return [], self.drawn.found
        made = [rung(None, out) for out in self.outs(LEFT)]
        if any(depth(one) > MOST_NESTED for one in made):
            self.drawn.say("DRW014", 0, 0, 1, most=MOST_NESTED)
            return [], self.drawn.found
        return made, []

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
        """Give what hangs on a net, from top to bottom by the row of the uppermost coil."""
        found: list[tuple[int, Out]] = [(row, coil) for source, row, coil in self.coils if source == net]
        for path in self.paths:
            if path.source == net:
                outs = self.outs(path.target)
                found.append((self.top(path.target), branch(path.node, *outs)))
        return [out for _, out in sorted(found, key=lambda item: item[0])]

    def top(self, net: int) -> int:
        rows = [row for source, row, _ in self.coils if source == net]
        rows += [self.top(path.target) for path in self.paths if path.source == net]
        return min(rows)
