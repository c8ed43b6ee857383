"""Draws one tree of outputs as a rung, and stops where it is no ladder: the reason is a fault with its line."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from plcteach.core.ladder import (
    MOST_NESTED,
    Box,
    Branch,
    Coil,
    Contact,
    Edge,
    Invert,
    Node,
    Out,
    Rung,
    depth,
    parallel,
    rung,
    series,
)  # fmt: skip
from plcteach.ladder.instructions import contact_word
from plcteach.ladder.outputs import Output
from plcteach.ladder.piece import Block, Fork, Mark, Piece, edged, spine, turned
from plcteach.ladder.trie import Fault, Group
from plcteach.ladder.trie import Node as Knot
from plcteach.ladder.written import Changes

if TYPE_CHECKING:
    from plcteach.core.area import Address
    from plcteach.core.program import Line
    from plcteach.core.spec import Dialect


class NoLadderError(Exception):
    """What a rung cannot show; it never leaves the lifting."""

    def __init__(self, fault: Fault) -> None:
        self.fault = fault
        super().__init__(fault.code)


class Ground:
    """What the rungs of one network have in common: their outputs, and where each piece has its first output.

    memories: edges with a bit of their own that are drawn already, by line.
    """

    def __init__(self, dialect: Dialect, lines: tuple[Line, ...], outputs: list[Output]) -> None:
        self.dialect, self.lines, self.outputs = dialect, lines, outputs
        self.driven: dict[int, int] = {}
        self.memories: dict[int, Address] = {}
        self.changes = Changes(dialect, lines, [output.at for output in outputs])
        self.folds = contact_word(dialect, "load", Contact("", edge="rise")) is None
        for output in outputs:
            for flow in (output.flow, *(piece for _, piece in output.pins)):
                self.drive(flow, output.at)

    def drive(self, flow: Piece | None, at: int) -> None:
        """Note the first output of each piece on the way to one."""
        while flow is not None and id(flow) not in self.driven:
            self.driven[id(flow)] = at
            flow = flow.before


class Drawing:
    """One rung while it is being drawn.

    sources: for each symbol so far the lines that made it.  spans: for each piece drawn its first symbol and the one behind
    its last.  upto: how many outputs of the network come before what is drawn now.
    """

    def __init__(self, ground: Ground) -> None:
        self.ground = ground
        self.sources: list[tuple[int, ...]] = []
        self.spans: list[tuple[Piece, int, int]] = []
        self.read: list[tuple[int, tuple[Address, ...]]] = []
        self.upto = 0
        self.level = 0

    def rung(self, group: Group, title: str) -> Rung:
        """Draw a rung; NoLadderError says why it is none."""
        if group.fault:
            raise NoLadderError(group.fault)
        if group.root is None:
            return Rung(None, (self.out(group.outputs[0]),), title)
        stem, last = self.stem(group.root, at_rail=True)
        drawn = rung(stem, *self.outs(last), title=title)
        if depth(drawn) > MOST_NESTED:
            raise NoLadderError(Fault("LAD006", group.outputs[-1].at))
        return drawn

    def stem(self, knot: Knot, *, at_rail: bool) -> tuple[Node, Knot]:
        """Draw the pieces up to the next branch point, and give that too."""
        pieces = [knot.piece]
        self.upto = knot.first
        while len(knot.items) == 1 and isinstance(knot.items[0], Knot):
            knot = knot.items[0]
            pieces.append(knot.piece)
        if max(piece.nest for piece in pieces) > MOST_NESTED:
            raise NoLadderError(Fault("LAD006", pieces[-1].at))
        return self.row(pieces, at_rail=at_rail), knot

    def outs(self, knot: Knot) -> list[Out]:
        """Draw what hangs on a branch point."""
        self.level += 1
        if self.level > MOST_NESTED:
            raise NoLadderError(Fault("LAD006", knot.piece.at))
        found: list[Out] = []
        for item in knot.items:
            if isinstance(item, Output):
                found.append(self.out(item))
            else:
                stem, last = self.stem(item, at_rail=False)
                found.append(Branch(stem, tuple(self.outs(last))))
        self.level -= 1
        return found

    def out(self, output: Output) -> Coil | Box:
        """Draw a coil, or a box behind its further inputs, each of which begins at the rail."""
        self.upto = output.index
        pins = tuple((name, self.pin(piece, output.at)) for name, piece in output.pins)
        self.sources.append(tuple(output.lines))
        return replace(output.symbol, pins=pins) if isinstance(output.symbol, Box) else output.symbol

    def pin(self, piece: Piece, at: int) -> Node:
        """Draw a further input of a box."""
        if piece.high > MOST_NESTED:
            raise NoLadderError(Fault("LAD006", at))
        return self.row(spine(piece), at_rail=True)

    def row(self, pieces: list[Piece], *, at_rail: bool, inner: bool = False) -> Node:
        """Draw pieces in series; inner: they are a block whose own beginning is not the left rail."""
        start = len(self.sources)
        mark, count = self.folded(pieces, inner=inner) if at_rail or inner else (None, 0)
        parts: list[Node] = []
        if mark:
            parts.append(self.symbol(mark, pieces[0].at))
            self.spans += [(one, start, start + 1) for one in pieces[:count]]
        for one in pieces[count:]:
            start = len(self.sources)
            parts.append(self.piece(one, at_rail=at_rail and one.before is None, inner=inner))
            self.spans.append((one, start, len(self.sources)))
        return series(*parts)

    def folded(self, pieces: list[Piece], *, inner: bool) -> tuple[Mark | None, int]:
        """Put the edge of a single contact into the contact; within a block, NOT behind one too."""
        if not isinstance(pieces[0].own, Mark) or pieces[0].before is not None:
            return None, 0
        mark, count = pieces[0].own, 1
        for one in pieces[1:]:
            own = one.own
            symbol = own.symbol if isinstance(own, Mark) else None
            found = None
            if isinstance(symbol, Edge) and not symbol.memory and (inner or self.ground.folds):
                found = edged(mark, rising=symbol.rising)
            elif isinstance(symbol, Invert) and inner:
                found = turned(mark)
            if found is None or not isinstance(own, Mark):
                break
            mark, count = replace(found, lines=(*mark.lines, *own.lines)), count + 1
        return mark, count

    def piece(self, one: Piece, *, at_rail: bool, inner: bool) -> Node:
        """Draw what a piece adds."""
        match one.own:
            case Block(block):
                self.joined(block.start, one.at)
                return self.row(spine(block), at_rail=False, inner=True)
            case Fork(upper, lower):
                paths = [spine(upper, one.before), spine(lower, one.before)]
                for path in paths:
                    self.joined(path[0], one.at)
                return parallel(*(self.row(path, at_rail=at_rail, inner=inner) for path in paths))
            case Mark(symbol) as mark:
                if inner and isinstance(symbol, Invert | Edge):
                    raise NoLadderError(Fault("LAD005", one.at))
                return self.symbol(mark, one.at)

    def joined(self, first: Piece, at: int) -> None:
        """Refuse to join a block that has an output inside already."""
        before = self.ground.driven.get(id(first), at)
        if before < at:
            raise NoLadderError(Fault("LAD002", at, before))

    def symbol(self, mark: Mark, at: int) -> Node:
        """Draw one symbol, where what it reads is still what the list read."""
        if mark.symbol is None:
            raise NoLadderError(Fault("LAD001", self.ground.outputs[self.upto].at))
        if isinstance(mark.symbol, Edge):
            self.edge(mark.symbol, at)
        elif not isinstance(mark.symbol, Invert):
            self.contact(mark.places, at)
        self.sources.append(mark.lines)
        return mark.symbol

    def contact(self, places: tuple[Address, ...], at: int) -> None:
        """Refuse a contact above which an output is drawn that the list executes after it, and that may change it."""
        ground = self.ground
        last = ground.outputs[self.upto - 1].at if self.upto else -1
        later = ground.changes.between(places, at, last) if last > at else None
        if later is not None:
            raise NoLadderError(Fault("LAD004", at, later))
        for line, memory in ground.memories.items():
            if line > at and memory in places:
                raise NoLadderError(Fault("LAD004", at, line))
        self.read.append((at, places))

    def edge(self, edge: Edge, at: int) -> None:
        """Refuse a second copy of an edge with a bit of its own, or one drawn late: it changes that bit."""
        if not edge.memory:
            return
        memory = next(iter(self.ground.lines[at].bits))
        late = self.upto > 0 and self.ground.outputs[self.upto - 1].at > at
        early = any(line > at and memory in places for line, places in self.read)
        if at in self.ground.memories or late or early:
            raise NoLadderError(Fault("LAD013", at))
        self.ground.memories[at] = memory
