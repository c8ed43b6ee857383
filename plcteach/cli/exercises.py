"""The verb `exercise`: list and show tasks, write a new one from a ladder or a list, and prove one by its own samples."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from plcteach.cli.printing import print_json, print_table, say
from plcteach.cli.reading import CallError, family_of, text_of
from plcteach.core.errors import PlcTeachError, UnknownNameError
from plcteach.core.text import Text, language
from plcteach.exercises import exercise, ids, load

if TYPE_CHECKING:
    import argparse

    from plcteach.check.proving import Proof
    from plcteach.core.exercise import Exercise

RIGHT, WRONG, MISCALLED = 0, 1, 2


def new_verb(options: argparse.Namespace) -> int:
    """Write an exercise file from a drawing or a list."""
    from plcteach.check.drilling.draft import draft
    from plcteach.check.proving import sound
    from plcteach.cli.drafts import toml

    text, family = text_of(options.file, options), family_of(options)
    path = options.output
    if path is not None and path.suffix != ".toml":
        msg = f"{path}: an exercise is written as .toml"
        raise CallError(msg)
    if path is not None and path.exists() and not options.force:
        msg = f"{path} is there already; --force writes over it"
        raise CallError(msg)
    stem = path.stem if path else Path(options.file).stem if options.file != "-" else "mine"
    written = toml(sound(draft(text, family, options.kind, re.sub(r"\s+", "-", stem))))
    if path is None:
        print(written, end="")
    else:
        path.write_text(written, encoding="utf-8")
        print(path)
    return RIGHT


def test_verb(options: argparse.Namespace) -> int:
    """Prove exercises; exit code 1 where one is not proved."""
    from plcteach.check.proving import proofs, proved

    tasks, broken = _gathered(options.what or list(ids()))
    known = {name: exercise(name) for name in ids()} | {one.id: one for one in tasks}
    found: dict[str, tuple[Proof, ...]] = {name: (_unread(why),) for name, why in broken.items()}
    found |= {one.id: proofs(one, known) for one in tasks}
    if options.json:
        print_json({name: [_row(one) for one in some] for name, some in found.items()})
    else:
        for name, some in found.items():
            _print_proofs(name, some, quiet=len(found) > 1)
        failed = [name for name, some in found.items() if not proved(some)]
        print(
            say(
                f"{len(found) - len(failed)}/{len(found)}个练习得到证明。",
                f"{len(found) - len(failed)} of {len(found)} exercises are proved.",
            )
        )
    return RIGHT if found and all(map(proved, found.values())) else WRONG


def _gathered(what: list[str]) -> tuple[list[Exercise], dict[str, str]]:
    """Read what is named, each a file, a folder, a bundled exercise's id or a drill's; and what does not read, with the reason."""
    from plcteach.check.drill import task_of

    found: list[Exercise] = []
    broken: dict[str, str] = {}
    for word in what:
        path = Path(word)
        if path.is_dir():
            files = sorted(path.glob("*.toml"))
            if not files:
                msg = f"there is no exercise (.toml) in {word}"
                raise CallError(msg)
        elif path.suffix == ".toml":
            if not path.exists():
                raise CallError(say(f"没有文件{word}", f"there is no file {word}"))
            files = [path]
        else:
            found.append(_named(word, task_of(word)))
            continue
        for one in files:
            try:
                found.append(load(one))
            except (PlcTeachError, UnicodeDecodeError) as trouble:
                broken[one.stem] = str(trouble)
    return found, broken


def _named(word: str, one: Exercise | None) -> Exercise:
    if one is None:
        what = "exercise"
        raise UnknownNameError(what, word, ids())
    return one


def _unread(why: str) -> Proof:
    from plcteach.check.proving import Proof

    return Proof(Text("读文件", "reading the file"), "failed", Text(why, why))


def _row(one: Proof) -> dict[str, str]:
    lang = language()
    return {"what": one.what.in_(lang), "state": one.state, "says": one.says.in_(lang)}


_STATES = {"proved": Text("√", "ok"), "failed": Text("×", "FAILED"), "note": Text("注意", "note")}


def _print_proofs(name: str, some: tuple[Proof, ...], *, quiet: bool) -> None:
    """Print a table with a row for each check; of many exercises only what is to be looked at."""
    shown = [one for one in some if not quiet or one.state != "proved"]
    lang = language()
    if shown:
        print_table(
            [name, "", ""], [[one.what.in_(lang), _STATES[one.state].in_(lang), one.says.in_(lang)] for one in shown]
        )
        print()


def list_verb(options: argparse.Namespace) -> int:
    """Print the catalogue in teaching order."""
    tasks = [exercise(name) for name in ids()]
    tasks = [one for one in tasks if options.dialect in {None, one.dialect}]
    if options.json:
        print_json([_entry(one) for one in tasks])
        return RIGHT
    lang = language()
    heads = [say("编号", "id"), say("题型", "kind"), say("分", "points"), say("标题", "title"), say("先做", "after")]
    rows = [[one.id, one.kind, f"{one.points:g}", one.title.in_(lang), ", ".join(one.after)] for one in tasks]
    print_table(heads, rows)
    print(
        say(
            f"共{len(tasks)}个练习；另有无数随机练习，如drill-blocks-2-7-…",
            f"{len(tasks)} exercises, and endless random ones (plcteach.drill)",
        )
    )
    return RIGHT


def _entry(one: Exercise) -> dict[str, object]:
    lang = language()
    return {
        "id": one.id,
        "kind": one.kind,
        "dialect": one.dialect,
        "points": one.points,
        "title": one.title.in_(lang),
        "lesson": one.lesson,
        "after": list(one.after),
    }


def show_verb(options: argparse.Namespace) -> int:
    """Print a task as a learner sees it before answering."""
    from plcteach.check.drill import task_of
    from plcteach.check.judge import shown
    from plcteach.ladder.picture import write_drawing

    if Path(options.what).is_dir():
        msg = f"{options.what}: name one exercise"
        raise CallError(msg)
    task = task_of(options.what)
    sheet, lang = shown(task), language()
    print(f"{task.id}  {task.title.in_(lang)}  ({task.points:g})\n\n{task.task.in_(lang)}\n")
    if sheet.text.in_(lang):
        print(f"{sheet.text.in_(lang)}\n")
    for number, ladder in enumerate(sheet.ladders):
        head = f"{chr(ord('A') + number)}:\n" if len(sheet.ladders) > 1 else ""
        print(f"{head}{write_drawing(ladder)}")
    rows = sheet.rows or tuple(line.text for line in (sheet.program.lines if sheet.program else ()))
    for count, row in enumerate(rows, 1):
        print(f"{count:3}  {row}")
    listed = sheet.program.source if sheet.program and not sheet.rows else ""
    if sheet.start.strip() and sheet.form == "list" and sheet.start.strip() != listed.strip():
        print(f"\n{sheet.start}")
    return RIGHT
