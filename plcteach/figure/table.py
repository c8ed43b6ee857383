"""Worksheets for paper exams: an empty stack table, lines by levels, and its answer key filled in by the machine."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plcteach.core.effect import Both, Name, Not
from plcteach.core.text import Text, same
from plcteach.figure.scene import Box, Scene, Stroke, Words, extent, extent_of
from plcteach.figure.strip import Level, level_name, levels_used
from plcteach.machine.course import Mixed
from plcteach.machine.formula import spelled
from plcteach.machine.scan import Domain, Memory, run, sweep
from plcteach.machine.signals import Column

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from plcteach.core.effect import Formula
    from plcteach.core.program import Program
    from plcteach.figure.scene import Shape
    from plcteach.machine.step import Step

A4 = (794, 1123)
_LEFT, _RIGHT, _TOP = 56, 738, 64
_ROW = 27
_FOOT = 64
_SEARCHED = 8
_JOIN_TELLS = 3
_NUMBER_WIDTH = 34.0
_LONGEST_TITLE = 60

TITLE = Text("堆栈表", "Stack table")
KEY = Text("（答案）", " (answer key)")
NAME, DATE = Text("姓名", "Name"), Text("日期", "Date")
TASK = Text(
    "在每一行写出该指令执行后堆栈各层的值（0、1、x，空的层写–）。",
    "Write into each row what the stack holds after the instruction: 0, 1, x, or – for an empty level.",
)
REST = Text("第一个扫描周期；没有列出的位都是0。", "First scan; every bit not listed is 0.")
GIVEN = Text("输入", "Inputs")
INSTRUCTION, WRITTEN = Text("指令", "instruction"), Text("写入", "writes")
PAGE = Text("第{page}页，共{pages}页", "page {page} of {pages}")


def sheet(
    program: Program,
    *,
    key: bool,
    rows_per_page: int = 28,
    inputs: Mapping[str, int] | None = None,
    title: Text | None = None,
) -> tuple[Scene, ...]:
    """Make the pages of a worksheet for one scan; with `key` the table is filled in.

    inputs: the bits of the exam; without them, those that best tell AND from OR in this program.
    """
    given = dict(inputs) if inputs is not None else telling_inputs(program)
    steps = run(program, [given]).scans[0].steps
    table = _Table(program, steps, given, key, title or TITLE, _columns(program))
    rows = list(_rows(program, steps))
    size = max(1, min(rows_per_page, table.room))
    chunks = [rows[first : first + size] for first in range(0, len(rows), size)] or [[]]
    return tuple(table.page(chunk, number, len(chunks)) for number, chunk in enumerate(chunks, 1))


def telling_inputs(program: Program) -> dict[str, int]:
    """Choose the inputs that tell most instructions from their likely confusions: AND from OR, open from closed.

    All cases run at once, one bit of a column each; joins of blocks count most, then a table that holds 0 and 1 alike.
    """
    names = [address.text for address in program.addresses("input")]
    tried = names[:_SEARCHED]
    cases = 1 << len(tried)
    full = (1 << cases) - 1
    rest = {name: place % 2 for place, name in enumerate(names[_SEARCHED:])}
    ones = {name: sum(1 << case for case in range(cases) if case >> place & 1) for place, name in enumerate(tried)}
    ones |= {name: full * value for name, value in rest.items()}
    bits = {name: Column(full ^ one, one) for name, one in ones.items()}
    scores, highs, steps = [0] * cases, [0] * cases, 0

    def watch(one: Step[Column]) -> None:
        nonlocal steps
        steps += 1
        for mask, worth in _telling(one):
            for case in range(cases):
                scores[case] += worth * (mask >> case & 1)
        for case in range(cases):
            highs[case] += one.after[0][0].at(case) == "1" if one.after[0] else 0

    with suppress(Mixed):  # where the cases part at a jump back, what was seen so far decides
        sweep(program, Memory(), bits, Domain(Column(full, 0), Column(0, full), Column(full, full)), watch)
    best = max(range(cases), key=lambda case: (scores[case], min(highs[case], steps - highs[case]), -case))
    return {name: rest[name] if name in rest else best >> tried.index(name) & 1 for name in names}


def _telling(one: Step[Column]) -> Iterator[tuple[int, int]]:
    """Give the cases in which a swapped operator, and those in which an operand of the wrong sense, would be seen here."""
    for origin in (origin for cells in one.flow.after for origin in cells):
        if not isinstance(origin.formula, Both):
            continue
        left, right = _value(origin.formula.left, one), _value(origin.formula.right, one)
        if left is None or right is None:
            continue
        join = len(origin.sources) > 1
        yield left.differs(right) & ~(left.unknown | right.unknown), _JOIN_TELLS if join else 1
        if not join:
            yield {"&": left.may1 & ~left.may0, "|": left.may0 & ~left.may1}.get(origin.formula.op, ~left.unknown), 1


def _value(formula: Formula, one: Step[Column]) -> Column | None:
    match formula:
        case Name(name) if name in one.flow.named:
            stack, place = one.flow.named[name]
            return one.before[stack][place]
        case Name():
            return one.read[0][1] if one.read else None
        case Not(of):
            value = _value(of, one)
            return None if value is None else ~value
    return None


@dataclass(frozen=True, slots=True)
class _Row:
    """A row of the table: a line with its step (none after the program's end), or a heading."""

    number: int
    text: str
    step: Step[Any] | None = None
    heading: bool = False


def _rows(program: Program, steps: tuple[Step[Any], ...]) -> Iterator[_Row]:
    number = 0
    for place, network in enumerate(program.networks, 1):
        if network.headed:
            yield _Row(0, f"{program.dialect.heading} {place}  {network.title}".strip()[:_LONGEST_TITLE], heading=True)
        for line in network.lines:
            yield _Row(number + 1, line.text, steps[number] if number < len(steps) else None)
            number += 1


def _columns(program: Program) -> list[Level]:
    """Give the columns: for each stack in use its levels and one more, whatever the inputs are; last, what is written."""
    dialect = program.dialect
    columns = [
        Level(number, place, 0, 0, level_name(dialect, dialect.stacks[number], place))
        for number, count in enumerate(levels_used(dialect, spelled(program)))
        for place in range(count)
    ]
    return [*columns, Level(0, -1, 0, 0, WRITTEN)]


@dataclass(frozen=True, slots=True)
class _Table:
    """One worksheet: what is the same on all its pages."""

    program: Program
    steps: tuple[Step[Any], ...]
    given: Mapping[str, int]
    key: bool
    title: Text
    columns: list[Level]

    @property
    def words_width(self) -> float:
        """How wide the column of instructions is."""
        return min(190.0, 20 + max((extent(line.text, 13, code=True) for line in self.program.lines), default=60.0))

    @property
    def room(self) -> int:
        """How many rows a page holds below the given bits and above its foot."""
        return int((A4[1] - _FOOT - self.inputs(_TOP + 84)[0] - 24 - _HEAD) // _ROW)

    @property
    def xs(self) -> list[float]:
        """The left edges of the columns for levels and writes, and the right edge of the last."""
        first = _LEFT + _NUMBER_WIDTH + self.words_width
        width = min(96.0, (_RIGHT - first - _NUMBER_WIDTH) / len(self.columns))
        edges = [first + width * place for place in range(len(self.columns))]
        return [*edges, min(float(_RIGHT), edges[-1] + max(width, 96.0))]

    def page(self, rows: list[_Row], number: int, pages: int) -> Scene:
        shapes: list[Shape] = [Box(0, 0, *A4, "paper")]
        heading = Text(self.title.zh + (KEY.zh if self.key else ""), self.title.en + (KEY.en if self.key else ""))
        shapes.append(Words(_LEFT, _TOP, heading, size=20, anchor="start", bold=True))
        shapes.append(Words(_LEFT, _TOP + 28, self.program.dialect.title, "quiet", "start", 13))
        shapes += _blank_line(NAME, 420, _TOP) if not self.key else ()
        shapes += _blank_line(DATE, 600, _TOP) if not self.key else ()
        shapes.append(Words(_LEFT, _TOP + 60, TASK, size=13, anchor="start"))
        top, inputs = self.inputs(_TOP + 84)
        shapes += inputs
        shapes += self.table(rows, top + 24)
        foot = PAGE.format(page=number, pages=pages)
        shapes.append(Words(A4[0] / 2, A4[1] - 44, foot, "quiet", size=11))
        return Scene(*A4, tuple(shapes), Text(f"{heading.zh}，{foot.zh}", f"{heading.en}, {foot.en}"))

    def inputs(self, top: float) -> tuple[float, list[Shape]]:
        """Draw the row of given bits, wrapped, and say where it ends."""
        shapes: list[Shape] = [Words(_LEFT, top + 11, GIVEN, "quiet", "start", 13)]
        x, y = _LEFT + extent_of(GIVEN, 13) + 16, top
        for address, value in self.given.items():
            words = f"{address} = {value}"
            width = extent(words, 13, code=True) + 18
            if x + width > _RIGHT:
                x, y = _LEFT + extent_of(GIVEN, 13) + 16, y + 30
            shapes += [Box(x, y, width, 24, "chip", 4), Words(x + width / 2, y + 12, same(words), size=13, code=True)]
            x += width + 8
        shapes.append(Words(_LEFT, y + 44, REST, "quiet", "start", 12))
        return y + 50, shapes

    def table(self, rows: list[_Row], top: float) -> Iterator[Shape]:
        xs = self.xs
        yield Box(_LEFT, top, xs[-1] - _LEFT, _HEAD, "head")
        yield Words(_LEFT + _NUMBER_WIDTH + 8, top + _HEAD / 2, INSTRUCTION, "quiet", "start", 12)
        for column, left, right in zip(self.columns, xs, xs[1:], strict=False):
            yield from _head((left + right) / 2, top, column.label, right - left)
        y = top + _HEAD
        for row in rows:
            yield from self.row(row, y)
            y += _ROW
        table = Box(_LEFT, top, xs[-1] - _LEFT, y - top, "table")
        yield table
        yield Stroke(((_LEFT, top + _HEAD), (xs[-1], top + _HEAD)), "line")

    def row(self, row: _Row, y: float) -> Iterator[Shape]:
        xs, middle = self.xs, y + _ROW / 2
        yield Stroke(((_LEFT, y), (xs[-1], y)), "faint")
        if row.heading:
            yield Words(_LEFT + 8, middle, same(row.text), "text", "start", 12, bold=True)
            return
        yield Words(_LEFT + _NUMBER_WIDTH - 8, middle, same(str(row.number)), "quiet", "end", 11)
        yield Words(_LEFT + _NUMBER_WIDTH + 8, middle, same(row.text), "text", "start", 13, code=True)
        for column, left, right in zip(self.columns, xs, xs[1:], strict=False):
            yield Stroke(((left, y), (left, y + _ROW)), "faint")
            if self.key and row.step:
                yield Words((left + right) / 2, middle, same(_answer(row.step, column)), "accent", size=13, code=True)


_HEAD = 38


def _answer(one: Step[Any], column: Level) -> str:
    if column.place < 0:
        first = [f"{address.text}={value!r}" for address, value in one.written]
        return first[0] + (" …" if len(first) > 1 else "") if first else ""
    cells = one.after[column.stack]
    return repr(cells[column.place]) if column.place < len(cells) else "–"


def _head(x: float, top: float, label: Text, width: float) -> Iterator[Shape]:
    """Write a column's heading, in two lines where one is too long."""
    if extent_of(label, 12) <= width - 6:
        yield Words(x, top + _HEAD / 2, label, "quiet", size=12)
        return
    (zh_first, zh_rest), (en_first, en_rest) = _halves(label.zh), _halves(label.en)
    size = max(
        7.0,
        min(
            12.0, 12 * (width - 4) / max(extent_of(Text(zh_first, en_first), 12), extent_of(Text(zh_rest, en_rest), 12))
        ),
    )
    yield Words(x, top + 12, Text(zh_first, en_first), "quiet", size=size)
    yield Words(x, top + 26, Text(zh_rest, en_rest), "quiet", size=size)


def _halves(words: str) -> tuple[str, str]:
    """Cut a heading where its level begins, else at the blank nearest its middle, else in the middle."""
    at = words.find("第") if "第" in words[1:] else words.find(", ") + 1
    if at <= 0:
        blanks = [place for place, sign in enumerate(words) if sign == " "]
        at = min(blanks, key=lambda place: abs(place - len(words) / 2), default=(len(words) + 1) // 2)
    return words[:at].strip(), words[at:].strip()


def _blank_line(label: Text, x: float, y: float) -> Iterator[Shape]:
    yield Words(x, y, label, "quiet", "start", 13)
    yield Stroke(((x + 40, y + 8), (x + 40 + 98, y + 8)), "line")
