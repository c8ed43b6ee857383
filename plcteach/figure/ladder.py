"""A ladder as textbooks draw it: two rails, contacts on wires, coils at the right, addresses above; knows no instruction.

Where values are given, the wires that carry power are drawn in another ink; a long rung goes on in a further band below.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from plcteach.core.ladder import Ladder, Rung
from plcteach.core.text import Text, same
from plcteach.figure.bands import bands
from plcteach.figure.legend import legend as legend_shapes
from plcteach.figure.power import by_bits
from plcteach.figure.rung import Frame, Look, Picture
from plcteach.figure.scene import Scene, Stroke, Words, broken, extent, extent_of
from plcteach.figure.symbol import Style, cell_width
from plcteach.ladder.formulas import formulas as formulas_of
from plcteach.ladder.layout import Layout, layout
from plcteach.ladder.oneline import write_line

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from plcteach.figure.scene import Shape

__all__ = ["MOST_COLUMNS", "Style", "frame_of", "ladder_scene", "rung_scene"]

_LEFT, _TOP, _MARGIN = 44.0, 22.0, 18.0
_CELL, _TITLE, _APART, _LINE = 88.0, 30.0, 16.0, 20.0
_SAID = 400
_NOTE = 520.0
MOST_COLUMNS = 9
"""A rung of more columns goes on in a further band below, where a single wire leads on."""


def ladder_scene(
    ladder: Ladder | Rung,
    *,
    style: Style = "relay",
    powered: Mapping[str, object] | None = None,
    looks: Mapping[int, Look] | None = None,
    legend: bool = False,
    formulas: bool = False,
    notes: Sequence[Text] = (),
    most: int = MOST_COLUMNS,
) -> Scene:
    """Draw a ladder; `powered` gives the values of bits (0 or 1) by address, and lights the wires that carry power then.

    A bit that `powered` does not name counts as 0; for an edge contact the key is its mark and address, "P I0.0", for a
    comparison its text.  looks: for a rung by number, what of it is built and bracketed.  legend, formulas: add the meaning
    of the signs, or each output's Boolean formula.  notes: what is to be said below it.  most: the columns of a rung before it
    goes on below.
    """
    rungs = ladder.rungs if isinstance(ladder, Ladder) else (ladder,)
    title = ladder.title if isinstance(ladder, Ladder) else ""
    plans = [layout(rung) for rung in rungs]
    frame = frame_of(plans, most)
    plain = Look(style, by_bits(powered) if powered is not None else None)
    shapes: list[Shape] = [Words(frame.left, _TOP, same(title), "text", "start", 15, bold=True)] if title else []
    first = top = _TOP + (_TITLE if title else 0)
    setup = _setup(ladder, frame)
    shapes += _rows(setup, frame.left, top)
    first = top = top + _LINE * len(setup)
    for number, (rung, plan) in enumerate(zip(rungs, plans, strict=True)):
        look = replace(looks.get(number, plain), style=style) if looks else plain
        picture = Picture(plan, frame, look, top + (_TITLE if rung.title else 0), number)
        shapes += [*_heading(rung, number + 1, frame, top, several=len(rungs) > 1), *picture.shapes()]
        rows = _formulas(rung, frame) if formulas else []
        shapes += _rows(rows, frame.left + 14, picture.bottom + 6)
        top = picture.bottom + _LINE * len(rows) + _APART
    bottom = top - _APART
    rails = [Stroke(((x, first), (x, bottom)), "rail") for x in (frame.left, frame.right)]
    words, foot = legend_shapes(rungs, style, frame.left, bottom + _MARGIN, frame.right) if legend else ([], bottom)
    told = [row for note in notes for row in broken(note, max(_NOTE, frame.right - frame.left), 12)]
    said = [Words(frame.left, foot + _LINE * at, one, "quiet", "start", 12) for at, one in enumerate(told, 1)]
    foot += _LINE * len(said)
    wide = max([frame.right, *(one.x + extent_of(one.text, 12) for one in (*words, *said) if isinstance(one, Words))])
    wide = max([wide, *(frame.left + extent(row, 12, code=True) for row in setup)])
    return Scene(round(wide + _MARGIN), round(foot + _MARGIN), (*rails, *shapes, *words, *said), _said(ladder, rungs))


def rung_scene(rung: Rung, number: int, frame: Frame, style: Style = "relay") -> Scene:
    """Draw one rung alone in a frame that it shares with others, between rails of its own; its parts bear its number."""
    picture = Picture(layout(rung), frame, Look(style, live=True), 4.0, number)
    shapes = picture.shapes()
    rails = [Stroke(((x, 0.0), (x, picture.bottom)), "rail") for x in (frame.left, frame.right)]
    words = write_line(rung)
    said = words if len(words) <= _SAID else f"{words[:_SAID]}…"
    return Scene(round(frame.right + 4), round(picture.bottom), (*rails, *shapes), same(said))


def frame_of(plans: Sequence[Layout], most: int = MOST_COLUMNS, *, fewest: int = 2, left: float = _LEFT) -> Frame:
    """Give the frame in which all these rungs fit, `fewest` columns wide at least."""
    inner = [piece.symbol for plan in plans for piece in plan.pieces if piece.target is not None]
    outer = [piece.symbol for plan in plans for piece in plan.pieces if piece.target is None]
    beside = 18 if any(plan.doubled for plan in plans) else 0
    cell = max([_CELL, *(round(cell_width(symbol) + beside) for symbol in inner)])
    last = max([_CELL, *(round(cell_width(symbol)) for symbol in outer)])
    widest = max([fewest, *(band.columns for plan in plans for band in bands(plan, most))])
    return Frame(left, cell, last, widest)


def _said(ladder: Ladder | Rung, rungs: tuple[Rung, ...]) -> Text:
    words = "; ".join(map(write_line, rungs))
    words = words if len(words) <= _SAID else f"{words[:_SAID]}…"
    name = f" {ladder.title}" if ladder.title else ""
    return Text(f"梯形图{name}：{words}", f"Ladder diagram{name}: {words}")


def _heading(rung: Rung, number: int, frame: Frame, top: float, *, several: bool) -> Iterator[Shape]:
    y = top + _TITLE + 34 if rung.title else top + 34
    if several:
        yield Words(frame.left - 12, y, same(str(number)), "quiet", "end", 12)
    if rung.title:
        yield Words(frame.left + 12, top + _TITLE / 2 + 4, same(rung.title), "text", "start", 13, bold=True)


def _rows(rows: Sequence[str], x: float, y: float) -> Iterator[Shape]:
    """Write rows of formulas, one below the other."""
    return (Words(x, y + _LINE * at, same(row), "quiet", "start", 12, code=True) for at, row in enumerate(rows))


def _setup(ladder: Ladder | Rung, frame: Frame) -> list[str]:
    """Give the lines that set blocks up, broken at blanks where they are long."""
    most = int(max(_NOTE, frame.right - frame.left) / extent("0", 12, code=True))
    lines = ladder.configuration if isinstance(ladder, Ladder) else ()
    return [row for line in lines for row in _broken(line, most, r"(?<=\s)")]


def _formulas(rung: Rung, frame: Frame) -> list[str]:
    """Write the formula of each output in rows that fit between the rails."""
    most = int((frame.right - frame.left - 28) / extent("0", 12, code=True))
    return [row for word, formula in formulas_of(rung) for row in _broken(f"{word} = {formula}", most)]


def _broken(words: str, most: int, behind: str = r"(?<=[·+])") -> list[str]:
    """Break a formula behind its signs (another text: where `behind` matches), into rows of so many characters; what follows the first is set in."""
    rows = [""]
    for piece in re.split(behind, words):
        if len(rows[-1]) + len(piece) > most and rows[-1].strip():
            rows.append("    ")
        rows[-1] += piece
    return rows
