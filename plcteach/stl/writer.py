"""Writes a program as text: in canonical form, or in the shape of the files that people's software reads and writes."""

from __future__ import annotations

import codecs
import csv
import io
from itertools import groupby
from typing import TYPE_CHECKING, Literal

from plcteach.stl.listing import COLUMNS
from plcteach.stl.tokens import reads_as_comment
from plcteach.stl.words import split

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.program import Line, Network, Program

Form = Literal["plain", "export", "csv", "pl7"]
"""plain: one instruction a line.  export: an exported project of Micro/WIN (.awl).  csv: a list of GX Works2 (a table).
pl7: numbered lines under RUNG headings, with (* comments *)."""


def write(program: Program, form: Form = "plain") -> str:
    """Give the text of a program; reading it again gives an equal program, and writing that the same text.

    The exported project heads each network of a family that has networks, because the software that takes it wants that: a
    list without any heading comes back with one. The table numbers instructions, not the steps they take in a PLC's memory.
    """
    return _FORMS[form](program)


def write_bytes(program: Program, form: Form = "plain", encoding: str | None = None) -> bytes:
    """Give the bytes of such a file: UTF-16 with a mark for the table, else UTF-8, unless `encoding` names another.

    UnicodeEncodeError where a comment has a letter that the encoding lacks.
    """
    text = write(program, form)
    if form == "csv" and encoding is None:
        return codecs.BOM_UTF16_LE + text.encode("utf-16-le")
    return text.encode(encoding or "utf-8")


def _blocks(program: Program) -> Iterator[tuple[str, list[Network]]]:
    """Give the main program and the subroutines, each with its networks, in the order of the text."""
    begun = {one.block for one in program.networks if one.lines and _begins(one.lines[0])}
    for block, networks in groupby(program.networks, lambda one: "" if one.block in begun else one.block):
        yield block, list(networks)


def _begins(line: Line) -> bool:
    """Say whether a line begins a subroutine by itself, so that nothing need stand around it (NEZA's `SR0:`)."""
    return "entry" in line.insn.does


def _begin(block: str) -> str:
    return f"SUBROUTINE_BLOCK SBR_{block.removeprefix('SBR')}:{block}"


_END = "END_SUBROUTINE_BLOCK"


def _plain(program: Program) -> str:
    rows = list(program.configuration)
    for block, networks in _blocks(program):
        inside = [row for number, one in enumerate(networks, 1) for row in _network(program, one, number)]
        rows += [_begin(block), *inside, _END] if block else inside
    return _ended([*rows, *map(_remark, program.tail)], "\n")


def _export(program: Program) -> str:
    rows = list(program.configuration)
    every = program.dialect.networks_by_title
    for block, networks in _blocks(program):
        rows += [_begin(block) if block else "ORGANIZATION_BLOCK MAIN:OB1", "TITLE=", "BEGIN"]
        rows += [row for number, one in enumerate(networks, 1) for row in _network(program, one, number, every=every)]
        rows.append(_END if block else "END_ORGANIZATION_BLOCK")
    return _ended([*rows, *map(_remark, program.tail)], "\r\n")


def _ended(rows: list[str], end: str) -> str:
    return "".join(row + end for row in rows)


def _network(program: Program, network: Network, number: int, *, every: bool = False) -> Iterator[str]:
    if network.headed or every:
        yield _heading(program, network, number)
    for line in network.lines:
        yield from map(_remark, line.above)
        yield f"{line.text} {_remark(line.comment)}" if line.comment else line.text


def _heading(program: Program, network: Network, number: int) -> str:
    heading = program.dialect.head(number - 1)
    return f"{heading} {_remark(network.title)}" if network.title else heading


def _remark(text: str) -> str:
    return f"// {text}"


def _pl7(program: Program) -> str:
    rows = list(program.configuration)
    step = 0
    for block, networks in _blocks(program):
        rows += [_begin(block)] if block else []
        for number, network in enumerate(networks):
            if network.headed:
                rows.append(f"RUNG {number} {_enclosed(network.title)}" if network.title else f"RUNG {number}")
            for line in network.lines:
                rows += map(_enclosed, line.above)
                rows.append(
                    f"{step:03} {line.text} {_enclosed(line.comment)}" if line.comment else f"{step:03} {line.text}"
                )
                step += 1
        rows += [_END] if block else []
    return _ended([*rows, *map(_enclosed, program.tail)], "\n")


def _enclosed(text: str) -> str:
    """Write a comment between (* and *), unless it says *) itself."""
    return _remark(text) if "*)" in text else f"(* {text} *)"


_STEP, _STATEMENT, _INSTRUCTION, _DEVICE, _NOTE = 0, 1, 2, 3, 6


def _csv(program: Program) -> str:
    out = io.StringIO()
    table = csv.writer(out, delimiter="\t", quoting=csv.QUOTE_ALL, lineterminator="\r\n")
    table.writerow(["MAIN"])
    table.writerow(["PLC Information:", program.dialect.title.en])
    table.writerow([name for name, _ in COLUMNS])
    table.writerows(_row(cells) for cells in _cells(program))
    return out.getvalue()


def _row(cells: dict[int, str]) -> list[str]:
    return [cells.get(column, "") for column in range(len(COLUMNS))]


def _cells(program: Program) -> Iterator[dict[int, str]]:
    for text in program.configuration:
        yield from _instruction(text)
    step = 0
    for block, networks in _blocks(program):
        if block:
            yield {_STATEMENT: _begin(block)}
        for number, network in enumerate(networks, 1):
            if network.headed:
                yield {_STATEMENT: _heading(program, network, number)}
            for line in network.lines:
                yield from _of_line(line, step)
                step += 1
        if block:
            yield {_STATEMENT: _END}
    for comment in program.tail:
        yield {_STATEMENT: _statement(comment)}


def _of_line(line: Line, step: int) -> Iterator[dict[int, str]]:
    for comment in line.above:
        yield {_STATEMENT: _statement(comment)}
    first, *others = _instruction(line.text)
    yield {_STEP: str(step), **first, _NOTE: line.comment}
    yield from others


def _instruction(text: str) -> Iterator[dict[int, str]]:
    """Give the rows of one instruction: its first operand beside it, each further one in a row of its own."""
    mnemonic, *operands = (word.text for word in split(text, 0, len(text), 0, closers=False))
    yield {_INSTRUCTION: mnemonic, _DEVICE: operands[0] if operands else ""}
    for operand in operands[1:]:
        yield {_DEVICE: operand}


def _statement(comment: str) -> str:
    """Mark a comment as one where it would be read as a heading."""
    return comment if reads_as_comment(comment) else f"; {comment}"


_FORMS = {"plain": _plain, "export": _export, "csv": _csv, "pl7": _pl7}
