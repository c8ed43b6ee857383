"""Writes a program as canonical text: one instruction a line, headings numbered, comments kept."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.program import Line, Network, Program


def write(program: Program) -> str:
    """Give the canonical text of a program; reading it again gives an equal program."""
    heading = program.dialect.heading
    rows: list[str] = []
    for number, network in enumerate(program.networks, 1):
        rows += _network(network, f"{heading} {number}")
    rows += [f"// {comment}" for comment in program.tail]
    return "\n".join(rows) + "\n" if rows else ""


def _network(network: Network, heading: str) -> Iterator[str]:
    if network.headed:
        yield f"{heading} // {network.title}" if network.title else heading
    for line in network.lines:
        yield from _line(line)


def _line(line: Line) -> Iterator[str]:
    for comment in line.above:
        yield f"// {comment}"
    yield f"{line.text} // {line.comment}" if line.comment else line.text
