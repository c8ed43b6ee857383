"""The verb `grade`: a folder of answers to marks, with a progress bar where a person sits at the terminal."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plcteach.check.drill import task_of as exercise
from plcteach.cli.printing import print_json, say
from plcteach.cli.reading import CallError
from plcteach.core.text import language

if TYPE_CHECKING:
    import argparse

    from plcteach.check.marking.grading import Graded
    from plcteach.core.exercise import Exercise

_GRADED, _INTERRUPTED = 0, 130


def grade_verb(options: argparse.Namespace) -> int:
    """Grade a folder; exit code 0 when all of it was gone through, whatever the marks."""
    from tqdm import tqdm

    from plcteach.check.marking.grading import How, grade_folder, write_results

    folder, task = _folder(options.folder), exercise(options.exercise)
    out = options.output or folder.with_name(f"{folder.resolve().name}-marks")
    if out.resolve() == folder.resolve() or (out.exists() and not out.is_dir()):
        msg = f"{out}: the results want a folder of their own"
        raise CallError(msg)
    how = How(options.jobs, options.cluster or "", encoding=options.encoding)
    try:
        with tqdm(file=sys.stderr, disable=None, leave=False, unit="") as bar:

            def seen(done: int, whole: int) -> None:
                bar.total = whole
                bar.update(done - bar.n)

            graded = grade_folder(folder, task, out, how, seen)
    except KeyboardInterrupt:
        _say_stopped(options)
        return _INTERRUPTED
    write_results(graded.rows, task, out, language())
    _say_done(graded, task, out, options)
    return _GRADED


def _folder(name: str) -> Path:
    folder = Path(name)
    if folder.is_file():
        msg = f"{name} is a file; grade wants the folder with the answers"
        if folder.suffix.lower() == ".zip":
            msg = f"{name} is a ZIP file; unpack it and name the folder"
        raise CallError(msg)
    if not folder.is_dir():
        msg = f"there is no folder {name}"
        raise CallError(msg)
    return folder


def _say_stopped(options: argparse.Namespace) -> None:
    if not options.json:
        print(
            say(
                "中断了。已批改的都留着；再运行同一条命令就接着批改。",
                "Stopped. What is judged is kept; the same command goes on from there.",
            )
        )


def _say_done(graded: Graded, task: Exercise, out: Path, options: argparse.Namespace) -> None:
    if options.json:
        results: Any = json.loads((out / "results.json").read_text(encoding="utf-8"))
        print_json(results)
        return
    from plcteach.check.marking.classpage import NOBODY
    from plcteach.check.marking.tables import distinct

    count, marks = len(graded.rows), [row.mark.marks for row in graded.rows]
    if not count:
        print(NOBODY.in_(language()))
    else:
        mean, full = sum(marks) / count, sum(mark >= task.points for mark in marks)
        print(
            say(
                f"{count}人，{distinct(graded.rows)}份不同的答案，这次批改{graded.judged}份文本；平均{mean:.2f}/{task.points:g}，满分{full}人。",
                f"{count} learners, distinct answers: {distinct(graded.rows)}, texts judged now: {graded.judged}; "
                f"mean {mean:.2f} of {task.points:g}, {full} with full marks.",
            )
        )
    print(out / "class.html")
