"""Grades a folder: reads it, judges each different text once, keeps what is done, and writes the tables and the pages."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.check.marking.classpage import class_page
from plcteach.check.marking.cluster import marked_there
from plcteach.check.marking.handed import handed_in
from plcteach.check.marking.kept import keep, kept, settle
from plcteach.check.marking.mark import key_of, plain
from plcteach.check.marking.pages import learner_page
from plcteach.check.marking.rows import rows_of
from plcteach.check.marking.tables import REPORTS, csv_of, json_of
from plcteach.check.marking.workers import SECONDS, marked

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from pathlib import Path

    from plcteach.check.marking.mark import Mark
    from plcteach.check.marking.rows import Row
    from plcteach.core.exercise import Exercise


@dataclass(frozen=True, slots=True)
class How:
    """Where and how to judge: so many processes here (None: one for each core), or a cluster; how long one text may take."""

    jobs: int | None = None
    cluster: str = ""
    seconds: float = SECONDS
    encoding: str | None = None


@dataclass(frozen=True, slots=True)
class Graded:
    """What came of a folder: a row for each learner, how many different texts there were, and how many of them were judged now."""

    rows: tuple[Row, ...]
    distinct: int
    judged: int


def grade_folder(
    folder: Path, exercise: Exercise, out: Path, how: How | None = None, seen: Callable[[int, int], None] | None = None
) -> Graded:
    """Grade all that was handed in, and keep each mark in `out` as soon as it is there. `seen` hears of the progress.

    The same folder gives the same rows, wherever and in whatever order its texts were judged.
    """
    how = how or How()
    handed = handed_in(folder, how.encoding, out.resolve())
    keys = {one: key_of(exercise, plain(one.text)) for one in handed if one.trouble is None}
    texts = {key: plain(one.text) for one, key in keys.items()}
    out.mkdir(parents=True, exist_ok=True)
    marks = kept(out, texts.keys())
    todo = {key: text for key, text in texts.items() if key not in marks}
    hear = seen or (lambda _done, _whole: None)
    hear(len(marks), len(texts))
    for key, mark in keep(out, _judged(exercise, todo, how)):
        marks[key] = mark
        hear(len(marks), len(texts))
    settle(out, marks)
    rows = rows_of(handed, {one: marks[key] for one, key in keys.items()})
    return Graded(tuple(rows), len(texts), len(todo))


def _judged(exercise: Exercise, todo: dict[str, str], how: How) -> Iterable[tuple[str, Mark]]:
    if not todo:
        return ()
    if how.cluster:
        return marked_there(exercise, todo, how.cluster, how.seconds)
    return marked(exercise, todo, how.jobs, how.seconds)


def write_results(rows: tuple[Row, ...], exercise: Exercise, out: Path, lang: str) -> None:
    """Write the tables, the class's page and a page for each learner; the same rows give the same bytes."""
    reports = out / REPORTS
    reports.mkdir(parents=True, exist_ok=True)
    for row in rows:
        _write(reports / row.page, learner_page(row, exercise, lang))
    for old in {one.name for one in reports.glob("*.html")} - {row.page for row in rows}:
        (reports / old).unlink()
    _write(out / "results.csv", csv_of(rows, exercise, lang))
    _write(out / "results.json", json_of(rows, exercise, lang))
    _write(out / "class.html", class_page(rows, exercise, lang))


def _write(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8", errors="replace", newline="")
