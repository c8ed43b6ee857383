"""Writes a ladder as PLCopen XML (TC6 0201): one program with an LD body, its variables located, ready for an open editor.

An address such as %I0.0 or I0.0 becomes a variable I0_0 located at %IX0.0; any other bit must be a name that IEC 61131-3 takes,
and stays one. Boxes are those of `plcopen`: TON, TOF, TP, CTU, CTD, CTUD by their neutral text; NOT on the wire becomes the
function NOT, an edge on the wire R_TRIG or F_TRIG. What the standard has no sign for raises NotRepresentableError: comparisons,
immediate contacts and coils, a coil of several bits, an edge with a memory bit, and all other boxes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.ladder import (
    MOST_NESTED,
    Box,
    Branch,
    Coil,
    Contact,
    Edge,
    Invert,
    Ladder,
    Parallel,
    Rung,
    Series,
    depth,
)
from plcteach.core.text import Text
from plcteach.ladder.plcopen_names import INPUTS
from plcteach.ladder.plcopen_sheet import Sheet, framed
from plcteach.ladder.plcopen_variables import Variables, boxed, plain_name, refuse

if TYPE_CHECKING:
    from plcteach.core.ladder import Node, Out
    from plcteach.ladder.plcopen_sheet import Refs

_RAIL: Refs = ((1, ""),)


def write_plcopen(ladder: Ladder | Rung, *, name: str = "main") -> str:
    """Write a ladder as a project with one program; NotRepresentableError says what the format has no sign for."""
    whole = ladder if isinstance(ladder, Ladder) else Ladder((ladder,))
    variables = Variables(whole)
    body = _Body(variables)
    for number, rung in enumerate(whole.rungs):
        body.rung(rung, number)
    title = " ".join(whole.title.split())
    return framed(plain_name(name), title, variables.declared(), body.sheet.rows())


class _Body:
    """The LD body while it is being drawn: rows from top to bottom, each output in a row of its own, in the order of execution."""

    def __init__(self, variables: Variables) -> None:
        self.variables, self.sheet = variables, Sheet()
        self.number = 0
        self.row = self.lowest = 0

    def rung(self, rung: Rung, number: int) -> None:
        """Draw a rung below the last one, its title above it."""
        self.number, self.row = number, self.lowest + 2
        if depth(rung) > MOST_NESTED:
            refuse(number, Text("嵌套太深", "it is nested too deeply"))
        if rung.title.strip():
            self.sheet.comment(" ".join(rung.title.split()), self.row)
            self.row += 1
        self.lowest = self.row
        refs, column = (_RAIL, 1) if rung.stem is None else self.node(rung.stem, _RAIL, self.row, 1)
        self.outs(rung.outs, refs, self.row, column)

    def node(self, node: Node, refs: Refs, row: int, column: int) -> tuple[Refs, int]:
        """Draw contacts from a place on; give what the next one hangs on, and its column."""
        self.lowest = max(self.lowest, row)
        match node:
            case Series(parts):
                for part in parts:
                    refs, column = self.node(part, refs, row, column)
                return refs, column
            case Parallel(parts):
                ends: Refs = ()
                last = column
                for part in parts:
                    made, after = self.node(part, refs, row, column)
                    ends, last, row = ends + made, max(last, after), row + _height(part)
                return ends, last
        return self.sign(node, refs, row, column), column + 1

    def sign(self, node: Node, refs: Refs, row: int, column: int) -> Refs:
        """Draw one sign on the wire."""
        match node:
            case Contact(address, negated, edge, immediate=False):
                word = self.variables.bit(address, self.number)
                return self.sheet.contact(word, (row, column), refs, negated=negated, edge=edge)
            case Invert():
                return self.sheet.block("NOT", "", (row, column), {"IN": refs}, ("OUT",))
            case Edge(rising, ""):
                kind = "R_TRIG" if rising else "F_TRIG"
                return self.sheet.block(kind, self.variables.trigger(kind), (row, column), {"CLK": refs}, ("Q",))
        shown = getattr(node, "text", "") or f"[{getattr(node, 'mark', '')}{getattr(node, 'address', '')}]"
        return refuse(
            self.number, Text(f"{shown}在标准的梯形图里没有符号", f"a ladder of the standard has no sign for {shown}")
        )

    def outs(self, outs: tuple[Out, ...], refs: Refs, row: int, column: int) -> int:
        """Draw what hangs on a node, each output below the one before; give the row below the last."""
        for out in outs:
            self.lowest = max(self.lowest, row)
            match out:
                case Branch(stem, inner):
                    further, after = self.node(stem, refs, row, column)
                    row = max(self.outs(inner, further, row, after), row + _height(stem))
                case Coil():
                    self.coil(out, refs, row, column)
                    row += 1
                case Box():
                    self.box(out, refs, row, column)
                    row += 1
        return row

    def coil(self, coil: Coil, refs: Refs, row: int, column: int) -> None:
        """Draw a coil, and its wire to the right rail."""
        if coil.immediate or coil.count > 1:
            shown = f"({coil.mark}{coil.address}{f' {coil.count}' if coil.count > 1 else ''})"
            refuse(
                self.number,
                Text(f"{shown}在标准的梯形图里没有符号", f"a ladder of the standard has no sign for {shown}"),
            )
        self.sheet.coil(self.variables.bit(coil.address, self.number), (row, column), refs, coil.kind)

    def box(self, box: Box, refs: Refs, row: int, column: int) -> None:
        """Draw a timer or counter, its preset at its left, and what leads to its further inputs below the rung."""
        kind, name, preset = boxed(box, self.number)
        inputs: dict[str, Refs] = {box.entry or INPUTS[kind][0]: refs}
        for pin, node in box.pins:
            self.lowest += 1
            inputs[pin], after = self.node(node, _RAIL, self.lowest, 1)
            column = max(column, after)
        self.sheet.timed(kind, name, preset, (row, column + 1), inputs)


def _height(node: Node) -> int:
    """Give how many rows some contacts take."""
    match node:
        case Series(parts):
            return max(map(_height, parts))
        case Parallel(parts):
            return sum(map(_height, parts))
    return 1
