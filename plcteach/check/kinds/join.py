"""Which two blocks does this join connect: each is a stretch of the list, told by the numbers of its instructions."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from plcteach.check.answers import graded, looked_at, refused, rows, seen, text_of
from plcteach.check.judgement import Judgement, Sheet
from plcteach.core.diagnostic import rule
from plcteach.core.effect import flow
from plcteach.core.errors import DeclarationError
from plcteach.core.source import Span
from plcteach.core.text import NOTHING, Text

if TYPE_CHECKING:
    from plcteach.core.effect import Origin
    from plcteach.core.exercise import Exercise
    from plcteach.core.program import Line, Program

Made = tuple[int, ...]
"""The numbers of the instructions that have made the value of a cell, from 0."""

_JOINED = 2
_ONE_RIGHT = Text(
    "一个电路块对了，另一个不对。连接指令取它上面最近的两个已经完成的块。",
    "One block is right, the other is not. A join takes the two nearest finished blocks above it.",
)
_NONE_RIGHT = Text(
    "连接指令取它上面最近的两个已经完成的块：从{line}往上看，先找到的是哪一块？",
    "A join takes the two nearest finished blocks above it: going up from {line}, which one comes first?",
)
_STRETCH = re.compile(r"([0-9]{1,6})(?:\s*(?:-|~|…|\.\.+|to|至|到)\s*([0-9]{1,6}))?")
_BETWEEN = re.compile(r"[\s,;:()\[\]+&|]|and|和|与")


def shown(exercise: Exercise) -> Sheet:
    """Give the list with its instructions numbered; the task asks."""
    program = looked_at(exercise)
    _join(exercise, program)
    lines = tuple(line.text for line in program.lines)
    return Sheet("blocks", NOTHING, program, seen(exercise), lines, start=exercise.start)


def judged(exercise: Exercise, answer: str | bytes) -> Judgement:
    """Hold the two stretches against what the machine joins; lines that read nothing may be counted in at the edges or not."""
    text = text_of(answer)
    program = looked_at(exercise)
    pair = blocks(exercise)
    found = refused(text)
    given = () if found else _read(text)
    if not found and len(given) != _JOINED:
        found = (rule("KND006").at(Span(next(rows(text))[0])),)
    if found:
        return graded(exercise, text, 0.0, found=found)
    hits = max(
        sum(_same(one, made, program) for one, made in zip(order, pair, strict=True)) for order in (given, given[::-1])
    )
    says = (_ONE_RIGHT if hits else _NONE_RIGHT.format(line=_join(exercise, program).text),) if hits < _JOINED else ()
    return graded(exercise, text, 1.0 if hits == _JOINED else hits / 4, says=says)


def model(exercise: Exercise) -> str:
    """Give the two stretches, the upper block first."""
    return " ".join(f"{made[0] + 1}-{made[-1] + 1}" for made in blocks(exercise))


def blocks(exercise: Exercise) -> tuple[Made, Made]:
    """Give the instructions that made the two blocks of the join, counted from 0, the upper block first."""
    program = looked_at(exercise)
    _join(exercise, program)
    first = 0
    for network in program.networks:
        last = first + len(network.lines)
        if exercise.row <= last:
            return _joined(program, network.lines[: exercise.row - first], first)
        first = last
    raise _no_join(exercise)


def _joined(program: Program, lines: tuple[Line, ...], first: int) -> tuple[Made, Made]:
    """Follow the cells of one network up to its join, and give what made the two that it takes."""
    dialect = program.dialect
    cells: list[list[Made]] = [[()] * (stack.depth if stack.fixed else 0) for stack in dialect.stacks]
    for number, line in enumerate(lines, first):
        moves = flow(line.effect, dialect.shapes, tuple(map(len, cells)))
        before = cells
        if number == first + len(lines) - 1:
            break
        cells = [[_made(origin, before, number) for origin in column] for column in moves.after]
    top = next(origin for origin in moves.after[0] if origin.how == "made")
    upper, lower = sorted((before[stack][at] for stack, at in top.sources), key=lambda made: made or (-1,))
    return upper, lower


def _made(origin: Origin, before: list[list[Made]], number: int) -> Made:
    if origin.how == "blank":
        return ()
    sources = [before[stack][at] for stack, at in origin.sources]
    whole = sorted({one for made in sources for one in made} | ({number} if origin.how == "made" else set()))
    return tuple(whole)


def _join(exercise: Exercise, program: Program) -> Line:
    """Give the line that is asked about; DeclarationError where it joins nothing."""
    if not 1 <= exercise.row <= len(program.lines) or not _joins(program, program.lines[exercise.row - 1]):
        raise _no_join(exercise)
    return program.lines[exercise.row - 1]


def _no_join(exercise: Exercise) -> DeclarationError:
    return DeclarationError(f"exercise {exercise.id}: row {exercise.row} is no join")


def _joins(program: Program, line: Line) -> bool:
    heights = tuple(stack.depth for stack in program.dialect.stacks)
    moves = flow(line.effect, program.dialect.shapes, heights)
    return any(len(origin.sources) == _JOINED for origin in moves.after[0] if origin.how == "made")


def _idle(program: Program, line: Line) -> bool:
    """Say whether a line makes no new value and writes nothing: it only moves cells."""
    heights = tuple(stack.depth for stack in program.dialect.stacks)
    moves = flow(line.effect, program.dialect.shapes, heights)
    return not line.insn.then and all(origin.how != "made" for column in moves.after for origin in column)


def _read(text: str) -> tuple[tuple[int, int], ...]:
    """Read stretches of instruction numbers, counted from 1; nothing where something else stands among them."""
    whole = " ".join(row for _, row in rows(text)).lower()
    if _BETWEEN.sub("", _STRETCH.sub("", whole)):
        return ()
    pairs = [(int(one[1]), int(one[2] or one[1])) for one in _STRETCH.finditer(whole)]
    return tuple((min(pair), max(pair)) for pair in pairs)


def _same(given: tuple[int, int], made: Made, program: Program) -> bool:
    """Say whether a stretch holds all that made a block, and beside that only lines that move cells.

    A join at the end of a block that was joined itself may be left out: the contacts are what is meant.
    """
    whole = set(range(given[0] - 1, min(given[1], len(program.lines) + 1)))
    reading = {number for number in made if program.lines[number].places}
    more = whole - set(made)
    return (
        bool(made)
        and reading <= whole
        and all(number < len(program.lines) and _idle(program, program.lines[number]) for number in more)
    )
