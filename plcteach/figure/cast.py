"""What a film tells of its program before the first step: the lines, the networks, and the columns that will be drawn."""

from __future__ import annotations

from hashlib import sha256
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.core.program import Line, Program
    from plcteach.core.spec import Stack

_SPARE_LEVELS = 1
_FEWEST_DRAWN = 4
_LONGEST_DRAWN = 12


def cast(program: Program, heights: Sequence[int], *, rows: bool) -> dict[str, Any]:
    """Give the film's fixed part; `heights`: how high each stack ever was; `rows`: number the lines by their rows."""
    lines: list[dict[str, Any]] = [
        {"text": line.text, "comment": line.comment or _named(program, line), "row": line.span.row, "network": number}
        for number, network in enumerate(program.networks)
        for line in network.lines
    ]
    if not rows or len({line["row"] for line in lines}) < len(lines):
        lines = [{**line, "number": number} for number, line in enumerate(lines, 1)]
    firsts = [sum(len(one.lines) for one in program.networks[:at]) for at in range(len(program.networks))]
    return {
        "digest": _digest(program),
        "lines": lines,
        "networks": [{"title": _heading(program, number), "first": first} for number, first in enumerate(firsts)],
        "columns": [_column(stack, height) for stack, height in zip(program.dialect.stacks, heights, strict=True)],
    }


def _named(program: Program, line: Line) -> str:
    """Give the symbols of a line's addresses, where a table has named them."""
    return ", ".join(
        f"{place.text} = {program.symbols[place.text]}" for place in line.places if place.text in program.symbols
    )


def _column(stack: Stack, height: int) -> dict[str, Any]:
    whole = stack.depth if stack.depth <= _LONGEST_DRAWN else 0
    used = max(height + _SPARE_LEVELS, _FEWEST_DRAWN)
    column: dict[str, Any] = {
        "id": stack.name or "main",
        "title": stack.title.as_dict(),
        "depth": stack.depth,
        "drawn": whole or min(used, stack.depth),
        "fixed": stack.fixed,
    }
    if stack.register:
        column["register"] = stack.register.as_dict()
    return column


def _heading(program: Program, number: int) -> str:
    network = program.networks[number]
    if not network.headed:
        first = number and program.networks[number - 1].block != network.block
        return network.block if first else ""
    if network.block:
        return f"{network.block}: {network.title}" if network.title else network.block
    head = program.dialect.head(number)
    return f"{head}: {network.title}" if network.title else head


def _digest(program: Program) -> str:
    text = "\n".join((*program.configuration, *(line.text for line in program.lines)))
    return sha256(f"{program.dialect.name}\n{text}".encode()).hexdigest()[:8]
