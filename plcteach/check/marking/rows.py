"""A row for each learner, and what a class has in common: the same mistakes, the same wrong ideas, the same text."""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from dataclasses import dataclass, replace
from itertools import groupby
from typing import TYPE_CHECKING

from plcteach.check.marking.mark import Mark, plain, unread

if TYPE_CHECKING:
    from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence

    from plcteach.check.marking.handed import HandIn


@dataclass(frozen=True, slots=True)
class Row:
    """One learner's result. file: the answer that counts; others: what else they handed in.  page: the name of their report.

    group: the number of the group with the same instructions, 0 where nobody else has them.
    """

    learner: str
    number: str
    file: str
    text: str
    mark: Mark
    page: str
    others: tuple[str, ...] = ()
    group: int = 0


def rows_of(handed: Sequence[HandIn], marks: Mapping[HandIn, Mark]) -> list[Row]:
    """Give a row for each learner, in order; of several answers the best counts, of equally good ones the first."""
    rows: list[Row] = []
    pages: set[str] = set()
    for _, files in groupby(handed, key=lambda one: one.owner):
        tried = [(one, unread(one.trouble) if one.trouble else marks[one]) for one in files]
        best, mark = max(tried, key=lambda pair: (pair[0].trouble is None, pair[1].marks, pair[1].status == "equal"))
        others = tuple(one.file for one, _ in tried if one is not best)
        name = _page(best.learner, best.number, pages)
        rows.append(Row(best.learner, best.number, best.file, best.text, mark, name, others))
    return _grouped(rows)


_LONGEST_NAME = 60
_DEVICE = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)", re.IGNORECASE)


def _page(learner: str, number: str, taken: set[str]) -> str:
    """Name a learner's report so that every file system takes the name and no two reports share one."""
    words = unicodedata.normalize("NFC", f"{learner}_{number}" if number else learner)
    name = re.sub(r"[^\w-]+", "_", words).strip("_")[:_LONGEST_NAME] or "_"
    name = f"_{name}" if _DEVICE.fullmatch(name) else name
    free, count = name, 1
    while free.casefold() in taken:
        count += 1
        free = f"{name}-{count}"
    taken.add(free.casefold())
    return f"{free}.html"


def _grouped(rows: list[Row]) -> list[Row]:
    """Give each row the number of its group, counted by their first learners; what was not read is in no group."""
    counts = Counter(row.mark.same for row in rows if row.text.strip())
    numbers: dict[str, int] = {}
    for row in rows:
        if row.text.strip() and counts[row.mark.same] > 1:
            numbers.setdefault(row.mark.same, len(numbers) + 1)
    return [replace(row, group=numbers.get(row.mark.same, 0) if row.text.strip() else 0) for row in rows]


def groups(rows: Iterable[Row]) -> list[list[list[Row]]]:
    """Give the groups of the same instructions, the largest first; within one, those together whose text is the same to the letter."""
    together = _by(rows, lambda row: row.group)
    found = [list(_by(each, lambda row: plain(row.text)).values()) for number, each in together.items() if number]
    return sorted(found, key=lambda one: (-sum(map(len, one)), one[0][0].group))


def _by(rows: Iterable[Row], key: Callable[[Row], Hashable]) -> dict[Hashable, list[Row]]:
    found: dict[Hashable, list[Row]] = {}
    for row in rows:
        found.setdefault(key(row), []).append(row)
    return found


def tally(rows: Iterable[Row], what: Callable[[Row], Iterable[Hashable]]) -> list[tuple[Hashable, list[Row]]]:
    """Give who has each of something, the most frequent first, equally frequent ones in order."""
    found: dict[Hashable, list[Row]] = {}
    for row in rows:
        for one in dict.fromkeys(what(row)):
            found.setdefault(one, []).append(row)
    return sorted(found.items(), key=lambda pair: (-len(pair[1]), str(pair[0])))


_MOST_BARS = 10


def histogram(rows: Sequence[Row], points: float) -> list[tuple[float, float, int]]:
    """Give the marks as bars (from, below, how many), a bar for each point, or ten of them; the last is the full marks."""
    count = int(points) if points == int(points) and 1 <= points <= _MOST_BARS else _MOST_BARS
    bars = Counter(min(int(row.mark.marks / points * count + 1e-9), count) if points else 0 for row in rows)
    edges = [points * at / count for at in range(count + 1)]
    return [(edges[at], edges[min(at + 1, count)], bars[at]) for at in range(count + 1)]
