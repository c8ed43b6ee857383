"""Sorts the outputs of one network into rungs: outputs whose flows begin with the same pieces hang on one tree.

The tree grows at its right edge only, because a ladder is executed from top to bottom: an output belongs to the last branch, or
begins a new one at a place from which the way down to the last output started.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.ladder.piece import MOST_DRAWN

if TYPE_CHECKING:
    from plcteach.ladder.outputs import Output
    from plcteach.ladder.piece import Piece


@dataclass(frozen=True, slots=True)
class Fault:
    """Why something is no ladder: a diagnostic's code, the line that it is about, and another line that it speaks of."""

    code: str
    at: int
    other: int = -1


@dataclass(slots=True, eq=False)
class Node:
    """A piece of a rung and what hangs behind it, in the order of execution; first: the index of its first output."""

    piece: Piece
    first: int
    items: list[Node | Output] = field(default_factory=list)


@dataclass(slots=True, eq=False)
class Group:
    """One rung to be: its outputs as a tree, or a single box without a flow; fault: why it is no ladder."""

    outputs: list[Output]
    root: Node | None = None
    size: int = 0
    fault: Fault | None = None


class Trie:
    """The rungs of one network while they grow."""

    def __init__(self) -> None:
        self.groups: list[Group] = []
        self.path: list[Node] = []
        self.open: dict[int, Node] = {}
        self.inside: set[int] = set()
        self.roots: set[int] = set()
        self.ended = False

    def add(self, output: Output) -> None:
        """Hang an output on the rung that it continues, or begin another rung with it."""
        flow = output.flow
        if flow is None:
            self.groups.append(Group([output]))
            self.path, self.open = [], {}
            return
        if not self.path or self.path[0].piece is not flow.start or self.ended:
            self.begin(output, flow.start)
        else:
            self.groups[-1].outputs.append(output)
        group = self.groups[-1]
        if group.fault is None:
            self.hang(group, output, flow)
        self.ended = bool(output.pins)

    def begin(self, output: Output, root: Piece) -> None:
        """Begin a rung; nothing can follow a box of several inputs on its rung, so what would, is drawn anew."""
        again = id(root) in self.roots and not (self.ended and self.path and self.path[0].piece is root)
        node = Node(root, output.index)
        group = Group([output], node, root.size, Fault("LAD003", output.at) if again else None)
        self.groups.append(group)
        self.path, self.open, self.inside = [node], {id(root): node}, {id(root)}
        self.roots.add(id(root))

    def hang(self, group: Group, output: Output, flow: Piece) -> None:
        """Go back along the flow to the last branch, and add what is new."""
        fresh: list[Piece] = []
        one: Piece | None = flow
        while one is not None and id(one) not in self.open:
            if id(one) in self.inside:
                group.fault = Fault("LAD003", output.at)
                return
            fresh.append(one)
            one = one.before
        node = self.open[id(one)]
        while self.path[-1] is not node:
            del self.open[id(self.path.pop().piece)]
        for piece in reversed(fresh):
            self.grow(Node(piece, output.index))
        self.path[-1].items.append(output)
        group.size += sum(piece.added for piece in fresh) + output.size
        if group.size > MOST_DRAWN:
            group.fault = Fault("LAD006", output.at)

    def grow(self, node: Node) -> None:
        """Add a piece behind the last one."""
        self.path[-1].items.append(node)
        self.path.append(node)
        self.open[id(node.piece)] = node
        self.inside.add(id(node.piece))
