"""The before-and-after figure of an instruction: two columns of cells, and an arrow from each cell to where it goes.

It knows how a stack is drawn and nothing of any instruction: the arrows are the effect's flow, as the machine follows it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.text import Text, same
from plcteach.figure.illustration import Illustration, illustration
from plcteach.figure.panel import MARGIN, ROW, Panel, chip_width, panels_of, read_words, top_of_cells, written_words
from plcteach.figure.scene import Box, Scene, Stroke, Words, extent, extent_of
from plcteach.figure.strip import strip

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.program import Line
    from plcteach.core.spec import Dialect
    from plcteach.figure.scene import Shape

__all__ = ["Illustration", "illustrate", "illustration", "strip"]


def illustrate(dialect: str | Dialect, mnemonic_or_line: str | Line, number: int | None = None) -> Scene:
    """Draw what an instruction does to its family's stacks: figures 6 and 7 of 000_8c35a2fe1b5d9b9b.txt, for any effect."""
    told = illustration(dialect, mnemonic_or_line, number)
    panels = panels_of(told)
    shapes = [*_heading(told)]
    for panel in panels:
        shapes += panel.columns()
        shapes += panel.arrows()
    shapes += _across(told, panels)
    shapes += _chips(told, panels[0])
    lowest = max(max(*panel.ys.values(), *(dots - 4 for dots in panel.dots), 0) for panel in panels)
    bottom = lowest + ROW / 2 + (30 if _moves_at_bottom(told) else 10)
    for number_of_note, note in enumerate(told.notes):
        shapes.append(
            Words(panels[0].before_x, bottom + 18 + 22 * number_of_note, note, "accent", "start", 14, code=True)
        )
    bottom += 22 * len(told.notes) + 6
    heading = MARGIN + max(extent(told.line.text, 19, code=True), extent_of(told.line.insn.title, 13.5))
    notes = max((panels[0].before_x + extent_of(note, 14, code=True) for note in told.notes), default=0.0)
    width = max(panels[-1].right, panels[0].right, heading, notes) + MARGIN
    return Scene(round(width), round(bottom + 10), tuple(shapes), _title(told))


def _title(told: Illustration) -> Text:
    name = told.line.text
    zh = "；".join(
        f"{stack.title.zh}执行前 {' '.join(before) or '空'}，执行后 {' '.join(after) or '空'}"
        for stack, before, after in zip(told.dialect.stacks, told.before, told.after, strict=True)
    )
    en = "; ".join(
        f"{stack.title.en} before: {' '.join(before) or 'empty'}, after: {' '.join(after) or 'empty'}"
        for stack, before, after in zip(told.dialect.stacks, told.before, told.after, strict=True)
    )
    return Text(f"{name}（自栈顶起）：{zh}", f"{name} (from the top down): {en}")


def _heading(told: Illustration) -> Iterator[Shape]:
    yield Words(MARGIN, 28, same(told.line.text), "text", "start", 19, code=True, bold=True)
    yield Words(MARGIN, 53, told.line.insn.title, "quiet", "start", 13.5)


def _moves_at_bottom(told: Illustration) -> bool:
    flow = told.step.flow
    return bool(flow.lost) or any(one.how == "blank" for cells in flow.after for one in cells[1:])


def _across(told: Illustration, panels: list[Panel]) -> Iterator[Shape]:
    """Draw the arrows from one stack to another, in a lane above the cells."""
    lane = top_of_cells(told.dialect) - 11
    for target in panels:
        for place, one in enumerate(told.step.flow.after[target.number]):
            for number, source in one.sources:
                if number == target.number:
                    continue
                origin = panels[number]
                x, end = origin.before_x + origin.cell / 2 + 8, target.after_x + target.cell / 2 - 8
                top = origin.ys[source] - ROW / 2 - 2
                yield Stroke(
                    ((x, top), (x, lane), (end, lane), (end, target.ys[place] - ROW / 2 - 2)), "accent", arrow=True
                )


def _chips(told: Illustration, main: Panel) -> Iterator[Shape]:
    """Draw the bit that the instruction reads and the bit that it writes, beside the new top.

    What is written comes from the top as it is afterwards; where the instruction has changed it, from the top before.
    """
    x, y = main.after_x + main.cell + 34, main.ys[0]
    read, written = read_words(told), written_words(told)
    if read:
        yield from _chip(x, y, read)
        yield Stroke(((x - 3, y), (x - 30, y)), "accent", arrow=True)
    if written and read:
        start, lane, top = main.before_x + main.cell / 2, top_of_cells(told.dialect) - 11, y - ROW / 2 - 2
        x += chip_width(read) + 22
        yield from _chip(x, y, written)
        end = x + chip_width(written) / 2
        yield Stroke(((start, top), (start, lane), (end, lane), (end, top)), "accent", arrow=True)
    elif written:
        yield from _chip(x, y, written)
        yield Stroke(((x - 30, y), (x - 3, y)), "accent", arrow=True)


def _chip(x: float, y: float, words: str) -> Iterator[Shape]:
    width = chip_width(words)
    yield Box(x, y - 11, width, 22, "chip", 11)
    yield Words(x + width / 2, y, same(words), "text", size=13, code=True)
