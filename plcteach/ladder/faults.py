"""Says what is wrong with a drawn rung: joints that miss each other, paths that begin or end nowhere, and loose wires.

Each check stops at the first kind of finding, so that one slip is said once; a joint that stands a column or two aside comes
first, because it is what leaves the paths behind it without an end.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from plcteach.core.diagnostic import Note, rule
from plcteach.core.source import Span
from plcteach.core.text import Text
from plcteach.ladder.wires import LEFT, TAB, Cell, Sheet, ends, neighbours

_UPRIGHT = frozenset("|+")
_REACH = 2
"""So many columns aside, a joint was most likely meant to meet the other."""

_ABOVE, _BELOW = Text("上面", "above"), Text("下面", "below")
_HERE = Text("最近的在这里。", "The nearest stands here.")
_TABBED = Text(
    "这个制表符按8列对齐计算；改用空格，位置就一目了然。",
    "This tab reaches to the next multiple of 8 columns. With blanks instead, what is seen is what is read.",
)


class _Miss(NamedTuple):
    """A joint or the end of a wire, and the joint of another wire that it misses."""

    cell: Cell
    near: Cell


def check(out: Sheet) -> None:
    """Report what keeps a drawn rung from being read."""
    right = {one.target for one in out.elements if one.last} - {None}
    _lonely(out, right)
    if not out.found:
        _paths(out, right)


def _lonely(out: Sheet, right: set[int | None]) -> None:
    """Report, once a row, joints that nothing meets from above or below while another stands a column or two aside."""
    edge, last = out.edge, _last(out)
    alone = {
        cell: net
        for cell, net in out.nets.items()
        if out.sign(*cell) in _UPRIGHT and edge <= cell[1] < last and net not in right and not _met(out, cell)
    }
    said: set[int] = set()
    for cell in alone:
        above, below = _nearest(out, cell, -1), _nearest(out, cell, 1)
        near = above or (None if below in alone else below)
        if near and not {cell[0], near[0]} & said:
            _say(out, _Miss(cell, near))
            said.add(cell[0])


def _met(out: Sheet, cell: Cell) -> bool:
    """Say whether a joint or an upright wire comes to a joint from above or below."""
    row, column = cell
    return out.sign(row - 1, column) in _UPRIGHT or out.sign(row + 1, column) in _UPRIGHT


def _nearest(out: Sheet, cell: Cell, side: int) -> Cell | None:
    """Give the joint of another wire that is next to a cell in the row above or below, and is not met from its row."""
    row, column = cell
    other = row + side
    if not 0 <= other < len(out.rows):
        return None
    reach = _REACH if out.rows[row].tab is None and out.rows[other].tab is None else TAB
    found = [
        (other, at)
        for at in range(column - reach, column + reach + 1)
        if out.sign(other, at) in _UPRIGHT
        and out.sign(row, at) not in _UPRIGHT
        and out.nets[other, at] != out.nets.get(cell)
    ]
    return min(found, key=lambda near: abs(near[1] - column), default=None)


def _say(out: Sheet, miss: _Miss) -> None:
    """Say where a joint stands and where the next one is, in columns as they are seen, counted from 1."""
    (row, column), (other, at) = miss
    span, there = out.rows[row].span(column, column + 1), out.rows[other].span(at, at + 1)
    what = out.sign(row, column)
    found = rule("DRW016" if what in _UPRIGHT else "DRW017").at(
        span,
        what=what,
        sign=out.sign(other, at),
        side=_ABOVE if other < row else _BELOW,
        column=column + 1,
        near=at + 1,
    )
    tabs = ((one.number, one.tab) for one in (out.rows[row], out.rows[other]) if one.tab is not None)
    notes = (Note(there, _HERE), *(Note(Span(number, tab, tab + 1), _TABBED) for number, tab in tabs))
    out.found.append(replace(found, notes=notes))


def _last(out: Sheet) -> int:
    return max((one.stop for one in out.elements), default=0)


def _paths(out: Sheet, right: set[int | None]) -> None:
    """Report coils and boxes that something follows, wires past an element, paths that begin or end nowhere, and loose ends."""
    feeds = {one.source for one in out.elements} - {None}
    fed = {one.target for one in out.elements if not one.last} - {None} | {LEFT}
    open_ends: list[tuple[int | None, Cell]] = []
    for one in out.elements:
        if one.source is None or one.source not in fed | right:
            out.say_of("DRW008", one)
            open_ends.append((one.source, (one.row, one.start)))
        elif one.source == one.target:
            out.say_of("DRW010", one)
        elif one.source in right:
            out.say_of("DRW011", one)
        elif not one.last and (one.target is None or one.target not in feeds):
            out.say_of("DRW007", one)
            open_ends.append((one.target, (one.row, one.stop - 1)))
    if not out.found:
        open_ends = _loose(out, right | {LEFT} if LEFT in feeds else right)
    _explain(out, open_ends)


def _loose(out: Sheet, rails: set[int | None]) -> list[tuple[int | None, Cell]]:
    """Report pieces of wire with an end that touches nothing; rails may end anywhere, and so may a right rail apart."""
    edge, last = out.edge, _last(out)
    said: dict[int | None, Cell] = {}
    for cell, net in out.nets.items():
        upright = out.sign(*cell) != "-"
        at_rail = net in rails and (net != LEFT or cell[1] < edge)
        if at_rail or net in said or (upright and not edge <= cell[1] < last):
            continue
        if ends(out, cell) < 2:  # noqa: PLR2004
            out.say("DRW006", cell[0], cell[1], cell[1] + 1)
            said[net] = cell
    return list(said.items())


def _explain(out: Sheet, open_ends: list[tuple[int | None, Cell]]) -> None:
    """Where a joint that was missed explains an open end, say that instead, once for each joint."""
    by_net: dict[int, _Miss] = {}
    for cell, net in out.nets.items() if open_ends else ():
        miss = None if net in by_net else _missed(out, cell)
        if miss:
            by_net[net] = miss
    misses = [_missed(out, cell) if net is None else by_net.get(net) for net, cell in open_ends]
    if any(misses):
        out.found.clear()
        for miss in dict.fromkeys(filter(None, misses)):
            _say(out, miss)


def _missed(out: Sheet, cell: Cell) -> _Miss | None:
    """Give the joint that another joint, or the first or last sign of a row, misses above or below it."""
    row, column = cell
    signs, met = out.rows[row].signs, set(neighbours(out, cell)) if cell in out.nets else set()
    if out.sign(*cell) not in _UPRIGHT and signs[:column].strip() and signs[column + 1 :].strip():
        return None
    found = (_nearest(out, cell, side) for side in (-1, 1) if (row + side, column) not in met)
    return next((_Miss(cell, near) for near in found if near), None)
