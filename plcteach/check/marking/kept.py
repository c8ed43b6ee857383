"""A file of the marks given so far, one a row, so that a run that was interrupted goes on where it stopped."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from plcteach.check.marking.mark import STOPPED, Mark

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Iterator
    from pathlib import Path

NAME = ".plcteach-marks.jsonl"


def kept(folder: Path, wanted: Collection[str]) -> dict[str, Mark]:
    """Read the marks that are wanted and there; a row cut short by an interruption counts as not there."""
    found: dict[str, Mark] = {}
    path = folder / NAME
    rows = path.read_text(encoding="utf-8", errors="replace").splitlines() if path.is_file() else ()
    for row in rows:
        try:
            told = json.loads(row)
            if told["key"] in wanted:
                found[told["key"]] = Mark.from_json(told["mark"])
        except (ValueError, KeyError, TypeError, RecursionError):
            continue
    return found


def keep(folder: Path, marks: Iterable[tuple[str, Mark]]) -> Iterator[tuple[str, Mark]]:
    """Pass marks on, each written down first; one that was only stopped is not, so that it is tried again."""
    with (folder / NAME).open("a", encoding="utf-8", newline="\n") as file:
        if file.tell():
            file.write("\n")  # a row cut short ends here
        for key, mark in marks:
            if STOPPED not in mark.codes:
                file.write(_row(key, mark))
                file.flush()
            yield key, mark


def settle(folder: Path, marks: dict[str, Mark]) -> None:
    """Write the file anew, in order and only with the marks that count."""
    rows = [_row(key, mark) for key, mark in sorted(marks.items()) if STOPPED not in mark.codes]
    (folder / NAME).write_text("".join(rows), encoding="utf-8", newline="\n")


def _row(key: str, mark: Mark) -> str:
    return json.dumps({"key": key, "mark": mark.as_json()}, ensure_ascii=False) + "\n"
