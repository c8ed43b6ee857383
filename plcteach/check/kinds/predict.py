"""Predict the stack: one row for each instruction, with what its levels hold after it, top first."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.answers import graded, looked_at, quoted, refused, rows, seen, text_of
from plcteach.check.judgement import Judgement, Sheet
from plcteach.core.diagnostic import rule
from plcteach.core.source import Span
from plcteach.core.text import NOTHING, Text
from plcteach.figure.says import describes
from plcteach.figure.strip import level_name, levels_used
from plcteach.machine.scan import run

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from typing import Any

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.exercise import Exercise
    from plcteach.core.program import Program
    from plcteach.machine.signals import Column
    from plcteach.machine.step import Step

EMPTY = "."
UNREAD = "?"
_SIGNS = {"0": "0", "1": "1", "x": "x", ".": EMPTY, "-": EMPTY, "_": EMPTY}
_FIRST_WRONG = Text(
    "第{row}行 {line}：从这里开始有不对的值。{what}",
    "Row {row}, {line}: here is the first value that is not so. {what}",
)
_SCANS = Text("第{number}个扫描：{inputs}", "Scan {number}: {inputs}")
_ASKED = Text("填最后一个扫描。", "The last scan is asked for.")
_REST = Text("没有列出的位都是0。", "Every bit that is not listed is 0.")


def shown(exercise: Exercise) -> Sheet:
    """Give the list, its inputs, and an empty grid: instructions by levels."""
    program = looked_at(exercise)
    places = _places(exercise, program, _steps(exercise, program))
    dialect = program.dialect
    short = tuple(_short(program, stack, place) for stack, place in places)
    heads = tuple(level_name(dialect, dialect.stacks[stack], place) for stack, place in places)
    lines = tuple(line.text for line in program.lines)
    start = "".join(f"{' '.join(EMPTY for _ in places)}\n" for _ in lines)
    text = scans_said(exercise, asked=_ASKED)
    return Sheet("grid", text, program, seen(exercise), lines, short, exercise.start or start, heads)


def judged(exercise: Exercise, answer: str | bytes) -> Judgement:
    """Count the cells that are right, and name the first row that is not."""
    text = text_of(answer)
    found = refused(text)
    program = looked_at(exercise)
    wanted = cells(exercise)
    if found:
        return graded(exercise, text, 0.0, found=found)
    given, misread = _read(text, len(wanted), len(wanted[0]))
    marks = [[_right(one, other) for one, other in zip(*pair, strict=True)] for pair in zip(wanted, given, strict=True)]
    wrong = tuple((row, at) for row, line in enumerate(marks) for at, one in enumerate(line) if one is False)
    counted = [one for line in marks for one in line if one is not None]
    if all(one == EMPTY for line in given for one in line):
        misread = (*misread, rule("KND011").at(Span(1)))
    share = sum(counted) / len(counted) if counted else 1.0
    return graded(exercise, text, share, found=misread, says=_says(program, wrong), wrong=wrong, grid=given)


def model(exercise: Exercise) -> str:
    """Give the grid as the machine fills it."""
    return "".join(f"{' '.join(one[:1] for one in row)}\n" for row in cells(exercise))


def cells(exercise: Exercise) -> tuple[tuple[str, ...], ...]:
    """Give what each cell holds: 0, 1 or x; `.` where a level does not exist then, and `.x` where nobody has put anything.

    A row of a line that is not executed has nothing in it.
    """
    program = looked_at(exercise)
    steps = _steps(exercise, program)
    places = _places(exercise, program, steps)
    filled = _filled(program, steps)
    by_line = {one.number: (one, known) for one, known in zip(steps, filled, strict=True)}
    return tuple(
        tuple(_cell(*by_line[number], place) if number in by_line else EMPTY for place in places)
        for number in range(len(program.lines))
    )


def _steps(exercise: Exercise, program: Program) -> tuple[Step[Column], ...]:
    """Give the steps of the scan that is asked for."""
    return run(program, exercise.scans or [{}]).scans[-1].steps


def _places(exercise: Exercise, program: Program, steps: Iterable[Step[Column]]) -> list[tuple[int, int]]:
    """Give the columns as (stack, level): of the main stack as many as the exercise asks for, of others those in use."""
    counts = levels_used(program.dialect, tuple(steps))
    counts[0] = min(exercise.levels, program.dialect.stacks[0].depth) or counts[0]
    return [(stack, place) for stack, count in enumerate(counts) for place in range(count)]


def _short(program: Program, stack: int, place: int) -> str:
    """Give the heading of a narrow column: the number of the level, R for a register above them."""
    one = program.dialect.stacks[stack]
    if one.register and not place:
        return "R"
    return f"{one.name}{place if one.register else place + 1}"


Known = tuple[tuple[bool, ...], ...]


def _filled(program: Program, steps: Iterable[Step[Column]]) -> list[Known]:
    """Say for each step which cells hold what some line has put there, and not what stood there at first."""
    networks = [number for number, one in enumerate(program.networks) for _ in one.lines]
    now: Known = ()
    found: list[Known] = []
    last = -1
    for one in steps:
        if not now or networks[one.number] != last:
            now = tuple((False,) * len(column) for column in one.before)
        last = networks[one.number]
        now = tuple(
            tuple(
                origin.how == "made" or (origin.how != "blank" and any(now[stack][at] for stack, at in origin.sources))
                for origin in column
            )
            for column in one.flow.after
        )
        found.append(now)
    return found


def _cell(one: Step[Column], known: Known, place: tuple[int, int]) -> str:
    stack, level = place
    if level >= len(one.after[stack]):
        return EMPTY
    value = repr(one.after[stack][level])
    return ".x" if value == "x" and not known[stack][level] else value


def _read(text: str, height: int, width: int) -> tuple[list[list[str]], tuple[Diagnostic, ...]]:
    """Read the grid: as many rows and columns as are asked for, what is missing is empty."""
    found: list[Diagnostic] = []
    grid: list[list[str]] = []
    count = 0
    for number, row in rows(text):
        count += 1
        if count > height:
            continue
        words = row.lower().split()
        if len(words) == 1 and width > 1 and set(words[0]) <= set(_SIGNS):
            words = list(words[0])
        unread = [one for one in words[:width] if one not in _SIGNS]
        found += [rule("KND005").at(Span(number), word=quoted(one)) for one in unread[:1]]
        grid.append([_SIGNS.get(one, UNREAD) for one in words[:width]] + [EMPTY] * (width - len(words)))
    if count != height:
        found.append(rule("KND004").at(Span(1), got=count, wanted=height))
    grid += [[EMPTY] * width for _ in range(height - len(grid))]
    return grid, tuple(found)


def _right(wanted: str, given: str) -> bool | None:
    """Say whether a cell is right; None where nothing is asked and nothing was written."""
    if wanted == ".x":
        return None if given in {EMPTY, "x"} else False
    if wanted == EMPTY and given == EMPTY:
        return None
    return wanted == given


def _says(program: Program, wrong: tuple[tuple[int, int], ...]) -> tuple[Text, ...]:
    if not wrong:
        return ()
    line = program.lines[wrong[0][0]]
    what = describes(program.dialect, line.insn)
    return (_FIRST_WRONG.format(row=wrong[0][0] + 1, line=line.text, what=what),)


def scans_said(exercise: Exercise, asked: Text = NOTHING) -> Text:
    """Give the inputs of each scan, a row each."""
    said = [_SCANS.format(number=number, inputs=_inputs(row)) for number, row in enumerate(exercise.scans, 1)]
    if len(said) > 1 and asked != NOTHING:
        said.append(asked)
    said.append(_REST)
    return Text("\n".join(one.zh for one in said), "\n".join(one.en for one in said))


def _inputs(row: Mapping[str, Any]) -> str:
    return ", ".join(f"{address}={value}" for address, value in row.items())
