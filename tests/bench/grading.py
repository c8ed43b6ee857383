"""Grades 1,000 distinct submissions as `plcteach grade` does: one process, all cores, again, and the files that come of it."""

from __future__ import annotations

import os
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from random import Random

COUNT = 1_000
EXERCISES = ("s7-two-blocks", "s7-branch", "fx-star-delta")


def submissions(name: str, count: int, seed: int = 7) -> list[str]:
    """Give so many texts that differ in their instructions: the exercise's right answer, edited here and there at random."""
    from plcteach.check.judge import model
    from plcteach.core.errors import PlcTeachError
    from plcteach.exercises import exercise

    chance, found = Random(seed), {}
    try:
        rows = [row for row in model(name).splitlines() if row.strip()]
    except PlcTeachError:
        rows = exercise(name).right[0].splitlines()
    while len(found) < count:
        text = list(rows)
        for _ in range(chance.randint(0, 3)):
            _edit(text, chance)
        found.setdefault("\n".join(text) + "\n", len(found))
    return list(found)


def _edit(text: list[str], chance: Random) -> None:
    """Do what learners do: another operand, two rows exchanged, now and then a row too few or too many."""
    at, other = chance.randrange(len(text)), chance.randrange(len(text))
    kind = chance.random()
    if kind < 0.7:
        (word, _, mine), (_, _, theirs) = text[at].partition(" "), text[other].partition(" ")
        text[at] = f"{word} {theirs}" if mine and theirs else text[at]
    elif kind < 0.85:
        text[at], text[other] = text[other], text[at]
    elif kind < 0.93 and len(text) > 3:
        del text[at]
    else:
        text.insert(at, text[other])


def grading(show: Callable[..., None]) -> None:
    """Measure each exercise on a folder of its own."""
    for name in EXERCISES:
        show(f"grade: {COUNT:,} distinct submissions of {name}", *_measured(name))


def _measured(name: str) -> list[tuple[str, str]]:
    from plcteach.check.marking.grading import How, grade_folder, write_results
    from plcteach.check.marking.mark import mark_of
    from plcteach.exercises import exercise

    task, texts, rows = exercise(name), submissions(name, COUNT), []
    with tempfile.TemporaryDirectory() as where:
        folder = Path(where, "in")
        folder.mkdir()
        for at, text in enumerate(texts):
            (folder / f"learner {at:04}.stl").write_text(text, encoding="utf-8")
        took = []
        for text in texts[:200]:
            start = time.perf_counter()
            mark_of(task, text)
            took.append((time.perf_counter() - start) * 1e3)
        took.sort()
        rows.append(
            (
                "judging one, report included (200 of them)",
                f"median {took[100]:.1f} ms, 95 % {took[190]:.1f} ms, worst {took[-1]:.0f} ms",
            )
        )
        for jobs in (1, os.cpu_count() or 1):
            out = Path(where, f"out{jobs}")
            start = time.perf_counter()
            graded = grade_folder(folder, task, out, How(jobs=jobs))
            rows.append((f"all of them, {jobs} process(es) started for it", f"{time.perf_counter() - start:.1f} s"))
        start = time.perf_counter()
        again = grade_folder(folder, task, out, How())
        rows.append(("the same folder again", f"{time.perf_counter() - start:.2f} s, {again.judged} judged"))
        start = time.perf_counter()
        write_results(graded.rows, task, out, "en")
        size = sum(path.stat().st_size for path in out.rglob("*")) / 1e6
        rows.append(
            (
                "tables and 1,001 pages",
                f"{time.perf_counter() - start:.2f} s, {size:.1f} MB, class.html {(out / 'class.html').stat().st_size / 1e3:.0f} kB",
            )
        )
        rows.append(
            (
                "what they got",
                ", ".join(
                    f"{status} {count}"
                    for status, count in Counter(row.mark.status for row in graded.rows).most_common()
                ),
            )
        )
    return rows


if __name__ == "__main__":

    def printed(name: str, *rows: tuple[str, str]) -> None:
        print(f"\n{name}")
        for what, value in rows:
            print(f"  {what:<62} {value}")

    grading(printed)
