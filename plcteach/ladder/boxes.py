"""A box of a ladder as the lines that it becomes in a list, split faithfully or safely."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.boxes import Box, Mode, split
from plcteach.core.errors import NotRepresentableError
from plcteach.dialects import dialect as find_dialect
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.program import Source
    from plcteach.core.spec import Dialect


def decomposed(  # noqa: PLR0917 (a box's operands stand in their order)
    dialect: str | Dialect, box: str, in1: str, in2: str, out: str, mode: Mode = "faithful"
) -> tuple[tuple[str, ...], tuple[Diagnostic, ...]]:
    """Give the lines of a list that a box becomes, and what there is to say about them.

    faithful: as the editor writes it, with a warning where the result is another one.  safe: the right result, or no lines and
    the reason why not.  NotRepresentableError where an operand does not read; UnknownNameError if there is no such box.
    """
    family = find_dialect(dialect)
    given = Box(box.upper(), *operands_of(family, box.upper(), (in1, in2, out)))  # type: ignore[arg-type]
    parts, found = split(family, given, mode)
    return tuple(f"{word} {source.text}, {target.text}" for word, source, target in parts), found


def operands_of(dialect: Dialect, box: str, words: tuple[str, str, str]) -> list[Source]:
    """Read the three operands of a box as the instructions take them into which it is split."""
    if box not in dialect.boxes:
        split(dialect, Box(box, None, None, None))  # type: ignore[arg-type]
    move, work = dialect.boxes[box]
    program = read(f"{move} {words[0]}, {words[2]}\n{work} {words[1]}, {words[2]}", dialect)
    if not program.runs:
        raise NotRepresentableError(program.diagnostics[0].text)
    (in1, out), (in2, _) = (line.args for line in program.lines)
    return [in1, in2, out]  # type: ignore[list-item]
