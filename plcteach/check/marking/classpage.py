"""The page for the teacher: the marks of a class, which mistake how often, which wrong ideas, and who handed in the same."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING
from urllib.parse import quote

from plcteach.check.manual import blanks
from plcteach.check.marking.pages import text_of
from plcteach.check.marking.paper import bars, page, table
from plcteach.check.marking.rows import groups, histogram, tally
from plcteach.check.marking.tables import NAME, NUMBER, REPORTS, RESULT, STATUSES, WORDS, distinct, middle
from plcteach.core.diagnostic import RULES
from plcteach.core.misconception import MISCONCEPTIONS
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.check.marking.rows import Row
    from plcteach.core.exercise import Exercise

_FEW = 6
_MOST_GROUPS = 40
_MOST_KINDS = 60
_TITLE = Text("全班成绩：{exercise}", "The class: {exercise}")
_LEARNERS, _MEAN, _MEDIAN = Text("人数", "learners"), Text("平均分", "mean"), Text("中位数", "median")
_FULL, _DISTINCT = Text("满分人数", "full marks"), Text("不同的答案", "distinct answers")
_MARKS = Text("得分", "Marks")
_FINDINGS = Text("哪些问题，多少人", "Which mistakes, how often")
_BELIEFS = Text("可能的误解", "Misconceptions that may be behind them")
_WRONG = Text("运行起来错在哪里", "What goes wrong when it runs")
_SAME = Text("相同的答案", "Identical answers")
_SAME_WHY = Text(
    "指令完全相同（注释、空格和大小写不算）。题目短的时候，相同的正确答案很正常；相同的错误更值得问一问。并排的是字面不同的几份。",
    "The same instructions, comments, blanks and case apart. In a short exercise identical right answers are to be expected; "
    "identical wrong ones are worth a question. Side by side stand those that differ to the letter.",
)
_OF_GROUP = Text("第{number}组：{count}人 · {result}", "Group {number}: {count} learners · {result}")
_LETTER = Text("一字不差", "the same to the letter")
_ALL, _GROUP = Text("所有人", "Everyone"), Text("组", "group")
_EMPTY = Text("交上来的是空的", "What was handed in is empty")
_NONE = Text("没有。", "None.")
NOBODY = Text("这个文件夹里没有可批改的文件。", "There is nothing to grade in this folder.")
_TABLES = Text("表格", "Tables")


def class_page(rows: Sequence[Row], exercise: Exercise, lang: str) -> str:
    """Give the page of a whole class, with links to each learner's report."""
    title = _TITLE.format(exercise=exercise.title).in_(lang)
    body = [
        f"<h1>{escape(title)}</h1>",
        f'<p class="quiet"><code>{escape(exercise.id)}</code> · {escape(exercise.task.in_(lang))}</p>',
    ]
    if not rows:
        return page(title, [*body, f"<p>{escape(NOBODY.in_(lang))}</p>"], lang)
    parts = (_facts, _marks, _findings, _wrong, _beliefs, _everyone, _same)
    return page(title, [*body, *(one(rows, exercise, lang) for one in parts)], lang)


def _facts(rows: Sequence[Row], exercise: Exercise, lang: str) -> str:
    told = middle(rows)
    full = sum(row.mark.marks >= exercise.points for row in rows)
    facts = [
        (_LEARNERS, f"{len(rows)}"),
        (_MEAN, f"{told['mean']:g}/{exercise.points:g}"),
        (_MEDIAN, f"{told['median']:g}/{exercise.points:g}"),
        (_FULL, f"{full}"),
        (_DISTINCT, f"{distinct(rows)}"),
    ]
    told_all = "".join(f"<div><dt>{escape(name.in_(lang))}</dt><dd>{value}</dd></div>" for name, value in facts)
    files = ", ".join(f'<a href="{name}">{name}</a>' for name in ("results.csv", "results.json"))
    return f'<dl class="facts">{told_all}</dl>\n<p class="quiet">{escape(_TABLES.in_(lang))}: {files}</p>'


def _marks(rows: Sequence[Row], exercise: Exercise, lang: str) -> str:
    shown = [
        (f"{low:g}" if low == high else f"{low:g} – &lt;{high:g}", count, "")
        for low, high, count in histogram(rows, exercise.points)
    ]
    return _chapter(_MARKS, bars(_MARKS.in_(lang), shown), lang)


def _findings(rows: Sequence[Row], exercise: Exercise, lang: str) -> str:
    """Count what was found, each with what was said of it first; advice on an answer with full marks is no mistake."""
    shown = []
    empty = [row for row in rows if not row.text.strip() and not row.mark.codes]
    if empty:
        shown.append((escape(_EMPTY.in_(lang)), empty))
    for code, who in tally(rows, lambda row: _mistakes(row, exercise)):
        said = dict(zip(who[0].mark.codes, who[0].mark.said, strict=False)).get(
            str(code), blanks(RULES[str(code)].says)
        )
        words = f"<code>{escape(str(code))}</code> {escape(said.in_(lang))}"
        shown.append((words, who))
    shown.sort(key=lambda one: -len(one[1]))
    return _chapter(_FINDINGS, _counted(_FINDINGS, shown, lang), lang)


def _mistakes(row: Row, exercise: Exercise) -> list[str]:
    full = row.mark.marks >= exercise.points
    return [code for code in row.mark.codes if not full or RULES[code].severity != "info"]


def _wrong(rows: Sequence[Row], _exercise: Exercise, lang: str) -> str:
    differing = [row for row in rows if row.mark.status not in {"equal", "error"}]
    shown = [(escape(str(said)), who) for said, who in tally(differing, lambda row: [row.mark.headline.in_(lang)])]
    return _chapter(_WRONG, _counted(_WRONG, shown, lang), lang)


def _beliefs(rows: Sequence[Row], _exercise: Exercise, lang: str) -> str:
    shown = [
        (f"{number}. <strong>{escape(row.title.in_(lang))}</strong>: {escape(row.thinks.in_(lang))}", who)
        for number, who in tally(rows, lambda row: row.mark.beliefs)
        if (row := MISCONCEPTIONS.get(int(str(number))))
    ]
    return _chapter(_BELIEFS, _counted(_BELIEFS, shown, lang), lang)


def _counted(name: Text, shown: Sequence[tuple[str, Sequence[Row]]], lang: str) -> str:
    """Give what was counted as bars, with the names of those it was found with."""
    if not shown:
        return f"<p>{escape(_NONE.in_(lang))}</p>"
    return bars(name.in_(lang), [(words, len(who), _who(who)) for words, who in shown[:_MOST_KINDS]], "words")


def _who(rows: Sequence[Row]) -> str:
    """Name learners with links to their reports; more than a few are folded."""
    links = ", ".join(_link(row) for row in rows)
    if len(rows) <= _FEW:
        return f'<div class="who">{links}</div>'
    return f'<details class="who"><summary>{escape(rows[0].learner)} … ({len(rows)})</summary>{links}</details>'


def _link(row: Row) -> str:
    return f'<a href="{REPORTS}/{escape(quote(row.page))}">{escape(row.learner)}</a>'


def _same(rows: Sequence[Row], _exercise: Exercise, lang: str) -> str:
    found = groups(rows)
    if not found:
        return _chapter(_SAME, f"<p>{escape(_NONE.in_(lang))}</p>", lang)
    parts = [f'<p class="quiet">{escape(_SAME_WHY.in_(lang))}</p>']
    for group in found[:_MOST_GROUPS]:
        first = group[0][0]
        told = _OF_GROUP.format(number=first.group, count=sum(map(len, group)), result=STATUSES[first.mark.status])
        columns = "".join(f"<div>{_letters(each, lang)}{text_of(each[0], lang)}</div>" for each in group[:_FEW])
        left = [row for each in group[_FEW:] for row in each]
        parts.append(f'<h3 id="group-{first.group}">{escape(told.in_(lang))}</h3><div class="beside">{columns}</div>')
        parts += [f"<p>… {_who(left)}</p>"] if left else []
    left_out = len(found) - _MOST_GROUPS
    parts += [f"<p>… +{left_out}</p>"] if left_out > 0 else []
    return _chapter(_SAME, "\n".join(parts), lang)


def _letters(rows: Sequence[Row], lang: str) -> str:
    note = f' <span class="quiet">({escape(_LETTER.in_(lang))})</span>' if len(rows) > 1 else ""
    return f"<div>{_who(rows)}{note}</div>"


def _everyone(rows: Sequence[Row], exercise: Exercise, lang: str) -> str:
    kinds = ("", "short", "number", "short", "number", "")
    heads = zip((NAME, NUMBER, _MARKS, RESULT, _GROUP, WORDS), kinds, strict=True)
    shown = (
        (
            _link(row),
            escape(row.number),
            f"{row.mark.marks:g}/{exercise.points:g}",
            escape(STATUSES[row.mark.status].in_(lang)),
            f'<a href="#group-{row.group}">{row.group}</a>' if row.group else "",
            escape(row.mark.headline.in_(lang)),
        )
        for row in rows
    )
    return _chapter(_ALL, table(_ALL.in_(lang), [(head.in_(lang), kind) for head, kind in heads], shown), lang)


def _chapter(name: Text, body: str, lang: str) -> str:
    return f"<h2>{escape(name.in_(lang))}</h2>\n{body}"
