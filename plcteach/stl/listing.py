"""The table that GX Works2 makes of a list: which column holds what, and what one row of it says.

A row is an instruction with its first operand; each further operand stands in a row of its own whose step and instruction are
empty. Columns are found by their heads where there is a head row, else by their place; tabs, commas and semicolons part them.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Literal

from plcteach.core.source import half_width

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

Part = Literal["step", "statement", "instruction", "operand", "note"]

COLUMNS: tuple[tuple[str, Part], ...] = (
    ("Step No.", "step"),
    ("Line Statement", "statement"),
    ("Instruction", "instruction"),
    ("I/O(Device)", "operand"),
    ("Blank", "operand"),
    ("P/I Statement", "statement"),
    ("Note", "note"),
)
"""The columns in their order, as the head row names them."""

_SHORT: tuple[Part, ...] = ("step", "instruction", "operand")
_OTHER_HEADS: dict[Part, str] = {
    "step": "step|step no|步号|步|步编号|ステップ番号",
    "statement": "statement|pi statement|行间声明|p/i声明|行間ステートメント|p/iステートメント",
    "instruction": "mnemonic|指令|助记符|命令",
    "operand": "device|operand|i/o|i/o (device)|i/o(软元件)|软元件|操作数|空白|空栏|i/o(デバイス)|デバイス|空き",
    "note": "notes|comment|注解|注释|ノート",
}
_HEADS = {name.lower(): part for name, part in COLUMNS} | {
    name: part for part, names in _OTHER_HEADS.items() for name in names.split("|")
}

_SAYS_INSTRUCTION = re.compile("|".join(name for name, part in _HEADS.items() if part == "instruction"), re.IGNORECASE)
_FIRST_ROWS = 40
_LONGEST = 2_000
_DELIMITERS = "\t,;"
_FEWEST = 3
_QUOTED = re.compile(r'\s*"[^"]*(?:""[^"]*)*"(?:[\t,;]"[^"]*(?:""[^"]*)*"){2,}\s*')
_NUMBERED = re.compile(r"\s*\d+(?:\t[^\t]*){6,}|\s*\d+(?:,[^,]*){6,}")


@dataclass(frozen=True, slots=True)
class Cell:
    """What stands between two delimiters, without its quotes; `start` is its first column.

    exact: it stands in the row letter by letter, so that a place in it is a place in the row.
    """

    text: str
    start: int
    exact: bool = True


@dataclass(frozen=True, slots=True)
class Record:
    """One row: statements above it, instruction and operands, note; `begins`: it has an instruction."""

    statements: tuple[Cell, ...]
    code: tuple[Cell, ...]
    note: str
    begins: bool


@dataclass(frozen=True, slots=True)
class Layout:
    """How the table of one file is laid out; `first` is the number of the first row under the heads."""

    delimiter: str
    parts: tuple[Part, ...]
    first: int

    def record(self, number: int, row: str) -> Record | None:
        """Give what a row says; nothing for what stands above the heads, such as the program's name."""
        if number < self.first:
            return None
        found = list(cells(row, self.delimiter))
        by_part: dict[Part, list[Cell]] = {"step": [], "statement": [], "instruction": [], "operand": [], "note": []}
        for at, cell in enumerate(found):
            if cell.text.strip():
                by_part[_where(self.parts[at] if at < len(self.parts) else "note", cell)].append(cell)
        instruction = by_part["instruction"]
        note = " ".join(cell.text.strip() for cell in by_part["note"])
        return Record(tuple(by_part["statement"]), (*instruction, *by_part["operand"]), note, begins=bool(instruction))


def _where(part: Part, cell: Cell) -> Part:
    """Take what stands in the column of step numbers and is none for an instruction, so that it is not lost."""
    return "instruction" if part == "step" and not cell.text.strip().rstrip(":").isdigit() else part


def cells(row: str, delimiter: str) -> Iterator[Cell]:
    """Cut a row at its delimiters, but not within double quotes; two double quotes stand for one."""
    at = 0
    while at <= len(row):
        match = _cell(delimiter).match(row, at)
        if match is None:  # every row matches, if only by nothing
            return
        quoted, rest = match["quoted"], match["rest"]
        if quoted is None:
            yield Cell(rest, at)
        else:
            yield Cell(quoted.replace('""', '"') + rest, match.start("quoted"), '""' not in quoted and not rest)
        at = match.end() + 1


@lru_cache(maxsize=len(_DELIMITERS))
def _cell(delimiter: str) -> re.Pattern[str]:
    return re.compile(rf'(?: *"(?P<quoted>[^"]*(?:""[^"]*)*)"?)?(?P<rest>[^{delimiter}]*)')


def layout_of(rows: Sequence[str]) -> Layout | None:
    """Notice such a table by its head row or, without one, by its quoted or numbered rows; None for any other text."""
    beginning = [row[:_LONGEST] for row in rows[:_FIRST_ROWS]]
    for number, row in enumerate(beginning, 1):
        for delimiter in _DELIMITERS if _SAYS_INSTRUCTION.search(half_width(row)) else "":
            parts = _heads(row, delimiter)
            if {"instruction", "operand"} <= set(parts):
                return Layout(delimiter, parts, number + 1)
    telling = next((row for row in beginning if _QUOTED.fullmatch(row) or _NUMBERED.fullmatch(row)), None)
    return None if telling is None else _by_place(telling, beginning)


def _heads(row: str, delimiter: str) -> tuple[Part, ...]:
    names = [half_width(cell.text).strip().lower() for cell in cells(row, delimiter)]
    if not any(_HEADS.get(name) == "instruction" for name in names):
        return ()
    return tuple(_HEADS.get(name, "note") for name in names)


def _by_place(telling: str, beginning: list[str]) -> Layout:
    """Take the columns in their usual order, from the first row on that has several."""
    delimiter = max(_DELIMITERS, key=lambda one: _width(telling, one))
    first = next(number for number, row in enumerate(beginning, 1) if _width(row, delimiter) >= _FEWEST)
    short = _width(telling, delimiter) <= _FEWEST
    return Layout(delimiter, _SHORT if short else tuple(part for _, part in COLUMNS), first)


def _width(row: str, delimiter: str) -> int:
    return sum(1 for _ in cells(row, delimiter))
