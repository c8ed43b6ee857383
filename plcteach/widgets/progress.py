"""All exercises at a glance: what there is, in teaching order, and how far the learner has come with each."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

from plcteach.core.text import Text, language, same
from plcteach.dialects import dialect as find_dialect
from plcteach.exercises import exercise, ids
from plcteach.widgets.keeping import Notes, Record

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.exercise import Exercise
    from plcteach.core.spec import Dialect

KINDS = {
    "write": Text("写程序", "write the list"),
    "complete": Text("补全", "complete"),
    "bug": Text("找错", "find the bug"),
    "translate": Text("改写成另一系列", "translate"),
    "order": Text("排序", "put in order"),
    "predict": Text("预测堆栈", "predict the stack"),
    "join": Text("哪两个电路块", "which two blocks"),
    "match": Text("哪个梯形图", "which ladder"),
    "chart": Text("填时序图", "timing chart"),
}
_HEADS = (
    Text("", ""),
    Text("练习", "exercise"),
    Text("编号", "id"),
    Text("做什么", "what to do"),
    Text("检查次数", "checked"),
    Text("最好成绩", "best mark"),
    Text("提示", "hints"),
    Text("先做", "after"),
)
_SUMMARY = Text("满分{full}道，做过{begun}道，共{all}道", "{full} with full marks, {begun} begun, {all} in all")
_TEST = Text("概念测验：课前{before}", "Concept test: before the course {before}")
_TESTS = Text("概念测验：课前{before}，课后{after}", "Concept test: before the course {before}, after it {after}")
_EARLIER = Text("（不在这里的题）", "(not among these)")
_ENOUGH = 1e-9


@dataclass(frozen=True, slots=True)
class Row:
    """One exercise and what is kept of it; an exercise that is not here any more has only its id."""

    id: str
    record: Record
    exercise: Exercise | None = None

    @property
    def full(self) -> bool:
        """Whether it has full marks."""
        best, points = self.record.best, self.exercise.points if self.exercise else self.record.points
        return best is not None and points > 0 and best >= points - _ENOUGH

    @property
    def begun(self) -> bool:
        """Whether anything has been done with it."""
        return self.record.attempts > 0 or self.record.text is not None


@dataclass(frozen=True, slots=True)
class Progress:
    """The exercises with what is kept of them; a table in a notebook, rows of text elsewhere."""

    rows: tuple[Row, ...]
    besides: tuple[Text, ...] = ()

    @property
    def summary(self) -> Text:
        """How many exercises there are, how many have been begun, and how many have full marks."""
        counts = {"full": sum(one.full for one in self.rows), "begun": sum(one.begun for one in self.rows)}
        return _SUMMARY.format(all=len(self.rows), **counts)

    def __repr__(self) -> str:
        lang = language()
        table = [[cell.in_(lang) for cell in row] for row in (_HEADS, *map(self._cells, self.rows))]
        widths = [max(map(len, column)) for column in zip(*table, strict=True)]
        rows = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in table]
        return "\n".join([*self._said(lang), *rows])

    def _repr_html_(self) -> str:
        lang = language()
        head = "".join(f'<th scope="col" style="text-align:left">{escape(one.in_(lang))}</th>' for one in _HEADS)
        body = "".join(
            f"<tr>{''.join(self._cell(cell.in_(lang)) for cell in self._cells(row))}</tr>" for row in self.rows
        )
        caption = "<br>".join(map(escape, self._said(lang)))
        return (
            f'<table><caption style="text-align:left">{caption}</caption>'
            f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
        )

    def _said(self, lang: str) -> Iterator[str]:
        yield from (one.in_(lang) for one in (self.summary, *self.besides))

    @staticmethod
    def _cell(words: str) -> str:
        return f'<td style="text-align:left">{escape(words)}</td>'

    def _cells(self, row: Row) -> tuple[Text, ...]:
        one, record = row.exercise, row.record
        points = one.points if one else record.points
        full = {other.id for other in self.rows if other.full}
        after = ", ".join(f"{name} ✓" if name in full else name for name in one.after) if one else ""
        return (
            same("✓" if row.full else "…" if row.begun else ""),
            one.title if one else _EARLIER,
            same(row.id),
            KINDS[one.kind] if one else same(""),
            same(f"{record.attempts}" if record.attempts else ""),
            same("" if record.best is None else f"{record.best:g} / {points:g}"),
            same(f"{record.hints}" if record.hints else ""),
            same(after),
        )


def progress(dialect: str | Dialect | None = None) -> Progress:
    """Show all exercises in teaching order (of one family, if it is named) with attempts, best marks and hints used."""
    notes = Notes()
    records = notes.records()
    wanted = find_dialect(dialect).name if dialect else ""
    known = [exercise(name) for name in ids()]
    rows = [Row(one.id, records.get(one.id, Record()), one) for one in known if not wanted or one.dialect == wanted]
    if not wanted:
        here = {one.id for one in known}
        rows += [Row(name, record) for name, record in sorted(records.items()) if name not in here]
    besides = [*_tests(notes), *([notes.trouble] if notes.trouble else [])]
    return Progress(tuple(rows), tuple(besides))


def _tests(notes: Notes) -> Iterator[Text]:
    """Say how many answers of the concept test were right, before the course and after it."""
    test = notes.test("concept")
    rights = {
        phase: row.get("right") for phase, row in test.items() if isinstance(row, dict) and row.get("done") is True
    }
    counts = {
        phase: f"{sum(value is True for value in right.values())} / {len(right)}"
        for phase, right in rights.items()
        if isinstance(right, dict)
    }
    if "before" in counts:
        yield (_TESTS if "after" in counts else _TEST).format(**counts)
