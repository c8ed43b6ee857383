"""A whole program as one row of stacks: above each column its instruction, below it what the stack holds then."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plcteach.core.program import Program
from plcteach.core.text import Text, same
from plcteach.figure.scene import Box, Scene, Words, extent, extent_of
from plcteach.machine.formula import Term, spelled, written

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from plcteach.core.spec import Dialect, Stack
    from plcteach.figure.scene import Shape
    from plcteach.machine.scan import Scan
    from plcteach.machine.step import Step

_ROW = 22
_APART = 9
_MARGIN = 18
_HEAD = 40
_LONGEST = 18
_NARROWEST = 46.0

WRITTEN = Text("写入", "writes")


def strip(shown: Program | Scan[Any], *, columns: int = 12) -> Scene:
    """Draw a program's stacks as formulas, or a scan's as values, one column a line; wrapped after so many columns."""
    program = shown if isinstance(shown, Program) else shown.program
    steps: Sequence[Step[Any]] = spelled(program) if isinstance(shown, Program) else shown.steps
    rows = _rows(program.dialect, steps)
    labels = max((extent_of(row.label, 12) for row in rows), default=0) + 10
    widths = [_width(one, rows) for one in steps]
    height = _HEAD + sum(row.height for row in rows)
    shapes: list[Shape] = []
    right, y = 0.0, float(_MARGIN)
    for first in range(0, len(steps), max(1, columns)):
        shapes += [Words(_MARGIN + labels - 8, y + _HEAD + row.y, row.label, "quiet", "end", 12) for row in rows]
        x = _MARGIN + labels
        for one, width in list(zip(steps, widths, strict=True))[first : first + max(1, columns)]:
            shapes += _column(one, rows, x, y, width)
            x += width + 6
        right, y = max(right, x), y + height + 20
    names = "; ".join(one.line.text for one in steps)
    title = Text(f"每条指令执行后的堆栈：{names}", f"The stack after each instruction: {names}")
    return Scene(round(max(right, 120) + _MARGIN - 6), round(max(y - 20, 40) + _MARGIN), tuple(shapes), title)


def shown_value(value: object) -> str:
    """Write a cell's value as briefly as a narrow column wants it."""
    words = written(value, 40) if isinstance(value, Term) else repr(value)
    return words if len(words) <= _LONGEST else words[: _LONGEST - 1] + "…"


@dataclass(frozen=True, slots=True)
class Level:
    """One row of the table: a level of one stack, at `y` below the head, or (`place` -1) what is written."""

    stack: int
    place: int
    y: float
    height: float
    label: Text


def levels_used(dialect: Dialect, steps: Sequence[Step[Any]]) -> list[int]:
    """Give for each stack how many levels hold anything but x at some time, and one more; a stack never used gives 0."""
    counts = []
    for number, stack in enumerate(dialect.stacks):
        columns = [cells[number] for one in steps for cells in (one.before, one.after)]
        used = max(
            (place + 1 for cells in columns for place, cell in enumerate(cells) if shown_value(cell) != "x"), default=0
        )
        main = not number
        counts.append(min(stack.depth, used + 1) if used or main else 0)
    return counts


def _rows(dialect: Dialect, steps: Sequence[Step[Any]]) -> list[Level]:
    rows: list[Level] = []
    y = 0.0
    for number, count in enumerate(levels_used(dialect, steps)):
        stack = dialect.stacks[number]
        if number and count:
            y += _APART
        for place in range(count):
            apart = _APART if stack.register and not place and count > 1 else 0
            rows.append(Level(number, place, y + _ROW / 2, _ROW, level_name(dialect, stack, place)))
            y += _ROW + apart
    if any(one.written for one in steps):
        rows.append(Level(0, -1, y + _ROW / 2 + 4, _ROW, WRITTEN))
        y += _ROW + 4
    total = y - sum(row.height for row in rows)
    return (
        [*rows[:-1], Level(rows[-1].stack, rows[-1].place, rows[-1].y, rows[-1].height + total, rows[-1].label)]
        if rows
        else rows
    )


def level_name(dialect: Dialect, stack: Stack, place: int) -> Text:
    """Name a level, with its stack where the family has several."""
    if not stack.name and (stack.register or len(dialect.stacks) == 1):
        return stack.level(place)
    return Text("{stack}{level}", "{stack}, {level}").format(stack=stack.title, level=stack.level(place))


def _cell(one: Step[Any], row: Level) -> str | None:
    if row.place < 0:
        return ""
    cells = one.after[row.stack]
    return shown_value(cells[row.place]) if row.place < len(cells) else None


def _writes(one: Step[Any]) -> list[str]:
    return [f"{address.text}={shown_value(value)}" for address, value in one.written[:1]]


def _width(one: Step[Any], rows: list[Level]) -> float:
    mnemonic, _, operand = one.line.text.partition(" ")
    texts = [(mnemonic, 13), (operand, 11), *((words, 11) for words in _writes(one))]
    texts += [(_cell(one, row) or "", 12) for row in rows]
    return max(_NARROWEST, *(extent(text, size, code=True) + 10 for text, size in texts))


def _column(one: Step[Any], rows: list[Level], x: float, y: float, width: float) -> Iterator[Shape]:
    mnemonic, _, operand = one.line.text.partition(" ")
    yield Words(x + width / 2, y + 9, same(mnemonic), "text", size=13, code=True, bold=True)
    yield Words(x + width / 2, y + 26, same(operand), "quiet", size=11, code=True)
    for row in rows:
        middle, text = y + _HEAD + row.y, _cell(one, row)
        if row.place < 0:
            for words in _writes(one):
                yield Words(x + width / 2, middle, same(words), "accent", size=11, code=True)
        elif text is None:
            yield Box(x, middle - _ROW / 2, width, _ROW, "slot")
        else:
            new = one.flow.after[row.stack][row.place].how in {"made", "copied"}
            yield Box(x, middle - _ROW / 2, width, _ROW, "new" if new else "cell")
            ink = "accent" if new else "quiet" if text == "x" else "text"
            yield Words(x + width / 2, middle, same(text), ink, size=12, code=True, bold=new)
