"""One stack of a before-and-after figure: its two columns of cells, and the arrows from each cell to where it goes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.core.text import NOTHING, Text, same
from plcteach.figure.scene import Box, Stroke, Words, extent, extent_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.spec import Dialect, Stack
    from plcteach.figure.illustration import Illustration
    from plcteach.figure.scene import Shape

ROW = 26
_APART = 14
_GAP = 76
MARGIN = 20
_CELLS_TOP = 112
_TITLE_ROOM = 24
_ALL_DRAWN = 12
_HEAD_SHOWN = 6
_FOOT_SHOWN = 2
_EMPTY_SHOWN = 2

BEFORE, AFTER = Text("执行前", "before"), Text("执行后", "after")
UNCHANGED = Text("不变", "unchanged")
LOST, ENTERS = Text("丢失", "lost"), Text("x补入", "x enters")


@dataclass(slots=True)
class Panel:
    """One stack of the figure: where its columns stand and which levels are drawn."""

    told: Illustration
    number: int
    labels_x: float
    before_x: float
    after_x: float
    cell: float
    ys: dict[int, float]
    dots: list[float]

    @property
    def stack(self) -> Stack:
        """The stack that is drawn."""
        return self.told.dialect.stacks[self.number]

    @property
    def changes(self) -> bool:
        """Whether before and after are drawn apart."""
        return self.after_x != self.before_x

    @property
    def title(self) -> Text:
        """The stack's name over its columns; a register alone is called by its own."""
        if len(self.told.dialect.stacks) == 1:
            return NOTHING
        return self.stack.register if self.stack.register and self.stack.depth == 1 else self.stack.title

    @property
    def middle(self) -> float:
        """Where its title is centred."""
        return (self.before_x + self.after_x + self.cell) / 2

    @property
    def right(self) -> float:
        """Where it ends, with the bits beside it."""
        room = chip_room(self.told) if not self.number else 0
        return max(self.after_x + self.cell + room, self.middle + extent_of(self.title, 13) / 2)

    def columns(self) -> Iterator[Shape]:
        """Draw titles, level numbers and cells."""
        top = top_of_cells(self.told.dialect)
        yield Words(self.middle, top - 46, self.title, "text", size=13, bold=True)
        for x, words in (
            (self.before_x, BEFORE if self.changes else UNCHANGED),
            (self.after_x, AFTER if self.changes else NOTHING),
        ):
            yield Words(x + self.cell / 2, top - 25, words, "quiet", size=13)
        for place, y in self.ys.items():
            if self.stack.depth > 1:
                yield Words(self.before_x - 10, y, self.stack.level(place), "quiet", "end", 12)
        for x, column, inks in (
            (self.before_x, self.told.before[self.number], self.inks_before),
            (self.after_x, self.told.after[self.number], self.inks_after),
        ):
            yield from self.column(x, column, inks)
            if not self.changes:
                break

    def column(self, x: float, cells: tuple[str, ...], inks: dict[int, tuple[str, str]]) -> Iterator[Shape]:
        """Draw one column: empty slots below, then cells, the accented ones over their neighbours."""
        for place, y in self.ys.items():
            if place >= len(cells):
                yield Box(x, y - ROW / 2, self.cell, ROW, "slot")
        for place, y in self.ys.items():
            if place < len(cells):
                yield Box(x, y - ROW / 2, self.cell, ROW, "cell")
        for place, y in self.ys.items():
            if place < len(cells):
                box, words = inks.get(place, ("", "text"))
                if box:
                    yield Box(x, y - ROW / 2, self.cell, ROW, box)
                yield Words(x + self.cell / 2, y, same(cells[place]), words, size=13, code=True, bold=box == "new")
        for y in self.dots:
            yield Words(x + self.cell / 2, y, same("⋮"), "quiet", size=14)

    @property
    def inks_before(self) -> dict[int, tuple[str, str]]:
        """The inks of box and words for each cell before that is not an ordinary one."""
        flow = self.told.step.flow
        return {place: ("", "quiet") for number, place in (*flow.lost, *flow.dropped) if number == self.number}

    @property
    def inks_after(self) -> dict[int, tuple[str, str]]:
        """The inks of box and words for each cell afterwards that is not an ordinary one."""
        inks = {"made": ("new", "accent"), "copied": ("new", "accent"), "blank": ("", "lost")}
        flow = self.told.step.flow
        found = {place: inks[one.how] for place, one in enumerate(flow.after[self.number]) if one.how in inks}
        moved_in = {place: ("new", "accent") for place, one in enumerate(flow.after[self.number])
                    if one.how == "kept" and one.sources[0][0] != self.number}  # fmt: skip
        return found | moved_in

    def arrows(self) -> Iterator[Shape]:
        """Draw the arrows that stay within this stack."""
        if not self.changes:
            return
        flow = self.told.step.flow
        for accented in (False, True):
            for place, one in enumerate(flow.after[self.number]):
                for number, source in one.sources:
                    if number == self.number and (one.how != "kept") == accented:
                        yield from self.arrow(source, place, "accent" if accented else "line")
        for number, place in flow.dropped:
            if number == self.number and (number, place) not in _copied(self.told):
                yield from self.cross(place)
        yield from self.at_bottom()

    def arrow(self, source: int, target: int, ink: str) -> Iterator[Shape]:
        """Draw the way of one cell, if both its ends are drawn."""
        if source not in self.ys or target not in self.ys:
            return
        start, end = (self.before_x + self.cell + 3, self.ys[source]), (self.after_x - 3, self.ys[target])
        if start[1] == end[1]:
            yield Stroke((start, end), ink, arrow=True)
        else:
            yield Stroke(
                (start, (start[0] + _GAP * 0.4, start[1]), (end[0] - _GAP * 0.45, end[1]), end),
                ink,
                arrow=True,
                curve=True,
            )

    def cross(self, place: int) -> Iterator[Shape]:
        """Mark a cell whose value nobody keeps."""
        x, y = self.before_x + self.cell + 14, self.ys[place]
        yield Stroke(((x - 11, y), (x - 4, y)), "lost")
        yield Stroke(((x - 4, y - 4), (x + 4, y + 4)), "lost")
        yield Stroke(((x - 4, y + 4), (x + 4, y - 4)), "lost")

    def at_bottom(self) -> Iterator[Shape]:
        """Draw what falls out of a full stack and the x that enters where a cell has left."""
        flow, foot = self.told.step.flow, max(self.ys)
        y, middle = self.ys[foot], self.before_x + self.cell + _GAP / 2
        low = y + ROW / 2 + 10
        if any(number == self.number for number, _ in flow.lost):
            x = self.before_x + self.cell + 3
            yield Stroke(((x, y), (middle, y), (middle, y + 6), (middle, low)), "lost", arrow=True, curve=True)
            yield Words(middle, low + 11, LOST, "lost", size=12)
        cells = flow.after[self.number]
        if foot < len(cells) and foot and cells[foot].how == "blank":
            x = self.after_x - 3
            yield Stroke(((middle, low), (middle, y + 6), (middle, y), (x, y)), "lost", arrow=True, curve=True)
            yield Words(middle, low + 11, ENTERS, "lost", size=12)


def _copied(told: Illustration) -> set[tuple[int, int]]:
    return {place for cells in told.step.flow.after for one in cells if one.how == "copied" for place in one.sources}


def _touched(told: Illustration, number: int) -> bool:
    cells = told.step.flow.after[number]
    stays = all(one.how == "kept" and one.sources == ((number, place),) for place, one in enumerate(cells))
    return not stays or len(cells) != len(told.before[number])


def panels_of(told: Illustration) -> list[Panel]:
    """Place the stacks beside each other: before and after where something changes, one column where nothing does."""
    panels: list[Panel] = []
    x = float(MARGIN)
    for number, stack in enumerate(told.dialect.stacks):
        ys, dots = _levels(told, number, stack)
        labels = max(extent_of(stack.level(place), 12) for place in ys) + 10 if stack.depth > 1 else 24
        texts = (*told.before[number], *told.after[number])
        cell = max(62.0, *(extent(text, 13, code=True) + 20 for text in texts)) if texts else 62.0
        before_x = x + labels
        after_x = before_x + cell + _GAP if not number or _touched(told, number) else before_x
        panels.append(Panel(told, number, x, before_x, after_x, cell, ys, dots))
        x = panels[-1].right + 34
    return panels


def _levels(told: Illustration, number: int, stack: Stack) -> tuple[dict[int, float], list[float]]:
    """Choose the levels to draw, with the height at which each stands, and where the dots stand for those left out."""
    used = max(len(told.before[number]), len(told.after[number]))
    places = list(range(stack.depth))
    if stack.depth > _ALL_DRAWN and stack.fixed:
        seen = {place for one in told.step.flow.after[number] if one.how == "copied" for _, place in one.sources}
        around = {place for one in seen for place in (one - 1, one, one + 1)}
        wanted = set(range(_HEAD_SHOWN)) | around | set(range(stack.depth - _FOOT_SHOWN, stack.depth))
        places = sorted(place for place in wanted if 0 <= place < stack.depth)
    elif stack.depth > _ALL_DRAWN:
        places = list(range(min(stack.depth, used + _EMPTY_SHOWN)))
    ys, dots, y, last = {}, [], top_of_cells(told.dialect), -1
    for place in places:
        if place > last + 1:
            dots.append(y + 9)
            y += 18
        ys[place] = y + ROW / 2
        y += ROW + (_APART if stack.register and not place else 0)
        last = place
    if last < stack.depth - 1:
        dots.append(y + 9)
    return ys, dots


def read_words(told: Illustration) -> str:
    """Give the bit that is read, or nothing."""
    return told.step.read[0][0].text if told.step.read else ""


def written_words(told: Illustration) -> str:
    """Give the bits that are written, or nothing."""
    places = [address.text for address, _ in told.step.written]
    return places[0] if len(places) == 1 else f"{places[0]}…{places[-1]}" if places else ""


def chip_room(told: Illustration) -> float:
    """Give the room that the bits beside the stack need."""
    widths = [chip_width(words) + 34 for words in (read_words(told), written_words(told)) if words]
    return sum(widths)


def chip_width(words: str) -> float:
    """Give the width of one such bit."""
    return extent(words, 13, code=True) + 18


def top_of_cells(dialect: Dialect) -> float:
    """Give the height at which the cells begin: lower where each stack has a title of its own."""
    return float(_CELLS_TOP + (_TITLE_ROOM if len(dialect.stacks) > 1 else 0))
