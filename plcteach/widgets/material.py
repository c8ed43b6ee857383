"""What a desk shows of an exercise before it is answered, as the page wants it and as a printed page has it; never the answer."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING, Any

from plcteach.check.discreet import discreet
from plcteach.check.judge import shown
from plcteach.core.text import Text, language
from plcteach.dialects import dialect as find_dialect
from plcteach.figure.ladder import ladder_scene
from plcteach.figure.svg import svg
from plcteach.machine.scan import run

if TYPE_CHECKING:
    from plcteach.check.judge import Sheet
    from plcteach.core.exercise import Exercise
    from plcteach.core.ladder import Ladder

_BOTH = ("zh", "en")
_LOOKED_AT = {"translate", "match", "chart"}
"""The kinds whose program stands beside the answer, and neither in it nor in its rows."""


def sheet_of(exercise: Exercise) -> Sheet:
    """Give what an exercise shows before it is answered."""
    with discreet(exercise):
        return shown(exercise)


def task_of(exercise: Exercise, sheet: Sheet) -> dict[str, Any]:
    """Give an exercise as the desk in the browser wants it."""
    family = find_dialect(exercise.dialect)
    drawings = [_drawn(one) for one in sheet.ladders]
    choice = sheet.form == "choice"
    given = {"rows": list(sheet.rows), "columns": list(sheet.columns), "heads": [one.as_dict() for one in sheet.heads]}
    return {
        "id": exercise.id,
        "kind": exercise.kind,
        "form": sheet.form,
        "title": exercise.title.as_dict(),
        "task": exercise.task.as_dict(),
        "text": _text(exercise, sheet).as_dict(),
        "max": exercise.points,
        "dialect": {"name": family.name, "title": family.title.as_dict()},
        "list": family.list.as_dict(),
        "ladders": [] if choice else drawings,
        "choices": drawings if choice else [],
        "program": _program(exercise, sheet),
        "waves": _waves(exercise),
        "row": exercise.row,
        "start": sheet.start,
        "model": sheet.form != "list" and not exercise.hidden,
        "tells": not exercise.hidden,
        **given,
    }


def still_of(exercise: Exercise, sheet: Sheet) -> str:
    """Give the material as plain HTML in the language in force, for a page without a kernel; everything escaped."""
    lang = language()
    parts = [f"<h4>{escape(exercise.title.in_(lang))}</h4><p>{escape(exercise.task.in_(lang))}</p>"]
    if sheet.text.in_(lang):
        parts.append(f"<pre>{escape(sheet.text.in_(lang))}</pre>")
    if program := _program(exercise, sheet):
        parts.append(f"<pre>{escape(program)}</pre>")
    for number, one in enumerate(sheet.ladders):
        letter = f"<p>{escape(sheet.rows[number])}</p>" if sheet.form == "choice" else ""
        parts.append(letter + _drawn(one)[lang])
    if sheet.form == "grid":
        parts.append(_table(sheet))
    elif sheet.form != "choice" and (sheet.rows or sheet.start):
        rows = (
            [f"{number:2}  {row}" for number, row in enumerate(sheet.rows, 1)] if sheet.form == "blocks" else sheet.rows
        )
        parts.append(f"<pre>{escape(chr(10).join(rows) or sheet.start)}</pre>")
    return "".join(parts)


def _drawn(ladder: Ladder) -> dict[str, str]:
    scene = ladder_scene(ladder)
    return {lang: svg(scene, lang) for lang in _BOTH}


def _program(exercise: Exercise, sheet: Sheet) -> str:
    """Give the list that is looked at beside the answer; where it stands in the answer already, nothing."""
    if exercise.kind not in _LOOKED_AT or sheet.program is None or sheet.program.source == sheet.start:
        return ""
    return "\n".join(line.text for line in sheet.program.lines)


def _waves(exercise: Exercise) -> list[dict[str, Any]]:
    """Give the course of the inputs of a chart, scan by scan, to be drawn above the answer."""
    names = list(dict.fromkeys(name for row in exercise.scans for name in row if name != "ms"))
    if exercise.kind != "chart" or not names:
        return []
    values: dict[str, str] = dict.fromkeys(names, "0")
    course: dict[str, list[str]] = {name: [] for name in names}
    for row in exercise.scans:
        values |= {
            name: str(int(value) if isinstance(value, bool) else value) for name, value in row.items() if name != "ms"
        }
        for name in names:
            course[name].append(values[name])
    return [{"address": name, "values": row} for name, row in course.items()]


def _text(exercise: Exercise, sheet: Sheet) -> Text:
    """Give the words beside the task, without the rows of inputs that the grid draws itself."""
    waves = {wave["address"] for wave in _waves(exercise)}
    if not waves:
        return sheet.text

    def kept(words: str) -> str:
        rows = words.split("\n")
        return "\n".join(row for row in rows[1:] if row.split(" ")[0] not in waves)

    return Text(kept(sheet.text.zh), kept(sheet.text.en))


def _table(sheet: Sheet) -> str:
    head = "".join(f"<th>{escape(one)}</th>" for one in sheet.columns)
    rows = "".join(
        f"<tr><td><code>{escape(one)}</code></td>{'<td></td>' * len(sheet.columns)}</tr>" for one in sheet.rows
    )
    return f"<table><tr><td></td>{head}</tr>{rows}</table>"


def course_of(exercise: Exercise, sheet: Sheet) -> Any:
    """Run the program that is looked at over the scans of the task; None where there is nothing to run."""
    return run(sheet.program, exercise.scans or [{}]) if sheet.program else None
