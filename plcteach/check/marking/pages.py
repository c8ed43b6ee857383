"""The page that a learner gets back: the marks, what they are made of, what is to be said, and their own text with its rows."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from plcteach.check.marking.mark import plain
from plcteach.check.marking.paper import page
from plcteach.check.marking.tables import STATUSES
from plcteach.core.source import printable, rows_of
from plcteach.core.text import Text

if TYPE_CHECKING:
    from plcteach.check.marking.rows import Row
    from plcteach.core.exercise import Exercise

_MOST_ROWS = 1_000
_WIDEST_ROW = 500
_TEXT = Text("交上来的程序", "The program as it was handed in")
_OTHERS = Text("还交了：{files}。以得分最高的一份为准。", "Also handed in: {files}. The best one counts.")
_MORE = Text("……还有{n}行", "… and {n} more rows")


def learner_page(row: Row, exercise: Exercise, lang: str) -> str:
    """Give a learner's report; it holds nothing of anybody else, and nothing of the reference."""
    mark, points = row.mark, exercise.points
    title = f"{row.learner} · {exercise.title.in_(lang)}"
    tone = "good" if mark.marks >= points and mark.status == "equal" else "bad"
    told = Text(f"{mark.marks:g}/{points:g}分", f"{mark.marks:g} of {points:g}").in_(lang)
    body = [
        f"<h1>{escape(exercise.title.in_(lang))}</h1>",
        f'<p><strong>{escape(row.learner)}</strong> <span class="quiet">{escape(row.number)}</span></p>',
        f'<p class="quiet">{escape(exercise.task.in_(lang))}</p>',
        f'<p class="marks"><span class="{tone}">{escape(told)}</span> · {escape(STATUSES[mark.status].in_(lang))}</p>',
        f'<div class="report">{mark.report.in_(lang) or f"<p>{escape(mark.headline.in_(lang))}</p>"}</div>',
    ]
    if row.text.strip():
        body += [f"<h2>{escape(_TEXT.in_(lang))}</h2>", f'<p class="quiet">{escape(row.file)}</p>', text_of(row, lang)]
    if row.others:
        body.append(f'<p class="quiet">{escape(_OTHERS.format(files=", ".join(row.others)).in_(lang))}</p>')
    return page(title, body, lang)


_ROW = '<tr><td class="number">{}</td><td>{}</td></tr>'
_FOUND = '<tr class="found"><td class="number">▸ {}</td><td>{}</td></tr>'


def _signs(line: str) -> str:
    return escape(printable(line[:_WIDEST_ROW])) + ("…" if len(line) > _WIDEST_ROW else "")


def text_of(row: Row, lang: str) -> str:
    """Show a learner's text, its rows numbered, those with a finding tinted and marked; no sign in it acts on the page."""
    lines = rows_of(plain(row.text))
    found = set(row.mark.rows)
    body = "\n".join(
        _FOUND.format(at, _signs(line)) if at in found else _ROW.format(at, _signs(line))
        for at, line in enumerate(lines[:_MOST_ROWS], 1)
    )
    left = len(lines) - _MOST_ROWS
    more = f'<p class="quiet">{escape(_MORE.format(n=left).in_(lang))}</p>' if left > 0 else ""
    return f'<div class="text" tabindex="0" role="region" aria-label="{escape(row.file)}"><table>\n{body}\n</table></div>{more}'
