"""The lecturer's word that draws a list as a ladder: with power flow, or as far as a line of the list has built it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, get_args

from plcteach.core.diagnostic import refuse
from plcteach.core.errors import NotRepresentableError, PlcTeachError, UnknownNameError
from plcteach.core.ladder import Ladder
from plcteach.core.text import Text
from plcteach.figure.growth import Growth
from plcteach.figure.ladder import ladder_scene
from plcteach.figure.rung import Look
from plcteach.figure.running import program_of
from plcteach.figure.svg import Figure
from plcteach.figure.symbol import Style
from plcteach.ladder.picture import read_drawing
from plcteach.ladder.telling import is_drawing
from plcteach.machine.scan import run

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect

_WHERE = Text("第{row}行：{text}", "row {row}: {text}")


def draw(
    drawing: str,
    *,
    style: Style = "relay",
    powered: Mapping[str, object] | None = None,
    legend: bool = False,
    formulas: bool = False,
) -> Figure:
    """Draw a ladder typed as text; PlcTeachError names the row where it cannot be read.

    powered: values of bits by address, to light what carries power.  legend, formulas: add what the signs mean, and each
    output's Boolean formula.
    """
    ladder, found = read_drawing(drawing)
    refuse(found)
    _known_style(style)
    return Figure(ladder_scene(ladder, style=style, powered=powered, legend=legend, formulas=formulas))


def lift(
    text: str | Program,
    dialect: str | Dialect | None = None,
    inputs: Mapping[str, int] | None = None,
    *,
    line: int | None = None,
    style: Style = "relay",
    legend: bool = False,
    formulas: bool = False,
) -> Figure:
    """Draw the ladder of a list (or of a drawing): what no ladder can show is said below it, and the rest is there.

    inputs: run one scan with them and light what carries power at its end.  line: draw it as far as this line of the list,
    counted from 1, has built it, with brackets around the two blocks of a join.
    """
    _known_style(style)
    program = program_of(text, dialect)
    growth = Growth(program, style)
    notes = tuple(_WHERE.format(row=one.span.row, text=one.text) for one in growth.lifted.diagnostics)
    if not growth.lifted.rungs:
        raise NotRepresentableError(
            notes[0] if notes else Text("这个程序里没有梯级。", "There is no rung in this program.")
        )
    if line is not None and not 1 <= line <= len(program.lines):
        msg = f"the list has {len(program.lines)} lines, counted from 1, and none with the number {line}"
        raise PlcTeachError(msg)
    looks = _looks(growth, len(program.lines) if line is None else line)
    if inputs is not None:
        looks = _powered(growth, inputs, looks, last=line)
    ladder = read_drawing(text)[0] if isinstance(text, str) and is_drawing(text) else growth.lifted.ladder
    if len(ladder.rungs) != len(growth.lifted.rungs):
        ladder = growth.lifted.ladder
    return Figure(
        ladder_scene(_named(ladder, growth), style=style, looks=looks, legend=legend, formulas=formulas, notes=notes)
    )


def _known_style(style: str) -> None:
    if style not in get_args(Style):
        kind = "style"
        raise UnknownNameError(kind, str(style), get_args(Style))


def _named(ladder: Ladder, growth: Growth) -> Ladder:
    """Take the rungs as the list makes them, under the titles of the drawing."""
    rungs = tuple(
        replace(one.rung, title=drawn.title) for one, drawn in zip(growth.lifted.rungs, ladder.rungs, strict=True)
    )
    return Ladder(rungs, ladder.title, ladder.configuration)


def _looks(growth: Growth, line: int) -> dict[int, Look]:
    """Give for each rung what the first lines of the list have built, and the brackets of the last of them."""
    told, joints = growth.lifted.growth[line - 1], growth.joints()
    looks = {}
    for number, one in enumerate(growth.lifted.rungs):
        unbuilt = frozenset(at for at, lines in enumerate(one.sources) if lines[0] >= line)
        groups = [frozenset(at for rung, at in block if rung == number) for block in told.blocks or ()]
        last = line == len(growth.program.lines)
        loose = frozenset((net, opens) for (rung, net, opens), at in joints.items() if rung == number and at >= line)
        brackets = () if last else tuple(group for group in groups if group)
        looks[number] = Look(unbuilt=unbuilt, brackets=brackets, loose=loose)
    return looks


def _powered(growth: Growth, inputs: Mapping[str, int], looks: dict[int, Look], last: int | None) -> dict[int, Look]:
    """Run one scan, as far as a line if one is named, and let each sign conduct as it then does."""
    growth.start()
    for step in run(growth.program, [dict(inputs)]).scans[0].steps:
        if last is None or step.number < last:
            growth.step(step)
    return {
        number: replace(look, conducts=lambda _, at, rung=number: growth.closed.get((rung, at), False))
        for number, look in looks.items()
    }
