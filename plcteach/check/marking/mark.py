"""What one text got, as plain values that travel between processes and lie in a file: marks, mistakes, beliefs, the report."""

from __future__ import annotations

import hashlib
import re
from dataclasses import asdict, dataclass, fields
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plcteach import __version__
from plcteach.check.hints import believed
from plcteach.check.judge import judge
from plcteach.check.report import headline, report_html
from plcteach.core.diagnostic import Diagnostic, errors, rule
from plcteach.core.source import Span
from plcteach.core.text import NOTHING, Text

if TYPE_CHECKING:
    from plcteach.check.judgement import Judgement
    from plcteach.core.exercise import Exercise

_PACKAGE = Path(__file__).parents[2]


@dataclass(frozen=True, slots=True)
class Mark:
    """The marks for one text. codes: what was found, each once.  said: what was said of the first of each.  beliefs: the numbers of the usual wrong ideas behind it, the surest first.

    parts: what the marks are made of: name, reached, out of how much.  rows: the rows of the text with a finding.  same: a
    digest that programs of the same instructions share.  report: HTML, for both languages.
    """

    status: str
    marks: float
    headline: Text
    codes: tuple[str, ...] = ()
    beliefs: tuple[int, ...] = ()
    parts: tuple[tuple[Text, float, float], ...] = ()
    rows: tuple[int, ...] = ()
    same: str = ""
    report: Text = NOTHING
    said: tuple[Text, ...] = ()

    def as_json(self) -> dict[str, Any]:
        """Give the mark as JSON has it."""
        return asdict(self)

    @classmethod
    def from_json(cls, row: dict[str, Any]) -> Mark:
        """Read a mark back; KeyError, TypeError or ValueError if it is none."""
        told = {one.name: row[one.name] for one in fields(cls)}
        told |= {name: Text(**row[name]) for name in ("headline", "report")}
        told |= {name: tuple(row[name]) for name in ("codes", "beliefs", "rows")}
        told["said"] = tuple(Text(**one) for one in row["said"])
        told["parts"] = tuple((Text(**name), float(got), float(of)) for name, got, of in row["parts"])
        return cls(**told)


def mark_of(exercise: Exercise, text: str) -> Mark:
    """Judge one text. Whatever goes wrong in it becomes its row, because one answer must never stop a class."""
    try:
        return _marked(exercise, judge(exercise, text))
    except Exception as trouble:  # noqa: BLE001 (see above)
        return stopped(Text(f"程序内部的问题：{type(trouble).__name__}", f"a fault inside: {type(trouble).__name__}"))


def _marked(exercise: Exercise, judgement: Judgement) -> Mark:
    found = judgement.verdict.diagnostics
    first = {one.code: one.text for one in reversed(found)}
    codes = tuple(dict.fromkeys(one.code for one in found))
    program = (
        None if errors(found) else judgement.program
    )  # what did not read is in no line, and yet no two are the same
    said = "\n".join(line.text for line in program.lines) if program and program.lines else judgement.answer
    return Mark(
        judgement.verdict.status,
        float(judgement.marks),
        headline(judgement),
        codes,
        believed(judgement),
        tuple((one.name, one.got, one.of) for one in judgement.parts),
        tuple(sorted({one.span.row for one in found if one.span.row > 0 and one.severity != "info"})),
        digest(exercise.id, re.sub(r"\s+", " ", said).strip()),
        Text(report_html(judgement, "zh"), report_html(judgement, "en")),
        tuple(first[code] for code in codes),
    )


def unread(trouble: Diagnostic) -> Mark:
    """Give no marks for what could not be read or judged, and say why."""
    same = digest(trouble.code, trouble.text.en)
    return Mark("error", 0.0, trouble.text, (trouble.code,), same=same, said=(trouble.text,))


def stopped(reason: Text) -> Mark:
    """Give no marks yet for a text that could not be judged to its end."""
    return unread(rule(STOPPED).at(Span(1), reason=reason))


STOPPED = "HND003"


def plain(text: str) -> str:
    """Give a text as it counts: its line ends and the blanks at the ends of rows are nobody's work.

    Rows keep their numbers, so that whoever handed in the same text is told the same.
    """
    return "\n".join(row.rstrip() for row in re.split(r"\r\n|\n|\r", text)).rstrip()


def digest(*words: str) -> str:
    """Give a short name for some words that no other words have."""
    told = hashlib.sha256()
    for word in words:
        data = word.encode("utf-8", "surrogatepass")
        told.update(b"%d:" % len(data) + data)
    return told.hexdigest()[:32]


def key_of(exercise: Exercise, text: str) -> str:
    """Name a text's mark: the same text, exercise and version of plcteach have the same one."""
    return digest(version(), repr(asdict(exercise)), text)


@cache
def version() -> str:
    """Give this plcteach's version and a digest of its files, so that no mark outlives the rule that gave it."""
    told = hashlib.sha256()
    for path in sorted(_PACKAGE.rglob("*.py")):
        if "lessons" not in path.relative_to(_PACKAGE).parts:
            told.update(path.relative_to(_PACKAGE).as_posix().encode() + path.read_bytes())
    return f"{__version__}+{told.hexdigest()[:12]}"
