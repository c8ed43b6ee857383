"""The results as tables for other programs: CSV that spreadsheets open as it is, and JSON."""

from __future__ import annotations

import csv
import io
import json
import statistics
from typing import TYPE_CHECKING, Any

from plcteach.check.marking.mark import version
from plcteach.check.marking.rows import histogram, tally
from plcteach.core.misconception import MISCONCEPTIONS
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.check.marking.rows import Row
    from plcteach.core.exercise import Exercise

STATUSES = {
    "equal": Text("正确", "right"),
    "different": Text("不同", "different"),
    "unsettled": Text("停不下来", "never settles"),
    "unknown": Text("无法判定", "undecided"),
    "error": Text("有错误", "errors"),
}
NAME, NUMBER = Text("姓名", "name"), Text("编号", "number")
RESULT, WORDS = Text("结果", "result"), Text("说明", "in words")
_HEADS = (
    NAME,
    NUMBER,
    Text("得分", "marks"),
    Text("满分", "out of"),
    RESULT,
    WORDS,
    Text("诊断", "findings"),
    Text("误解", "misconceptions"),
    Text("误解的名称", "misconceptions in words"),
    Text("相同答案组", "same as others"),
    Text("文件", "file"),
    Text("其他文件", "other files"),
    Text("报告", "report"),
)
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")
_BOM = "\ufeff"
REPORTS = "reports"


def csv_of(rows: Sequence[Row], exercise: Exercise, lang: str) -> str:
    """Give the rows as CSV with a mark at its beginning, by which spreadsheets know that it is UTF-8."""
    sheet = io.StringIO()
    writer = csv.writer(sheet, lineterminator="\r\n")
    writer.writerow([head.in_(lang) for head in _HEADS])
    for row in rows:
        mark = row.mark
        writer.writerow(
            [
                cell(row.learner),
                cell(row.number),
                f"{mark.marks:g}",
                f"{exercise.points:g}",
                STATUSES[mark.status].in_(lang),
                cell(mark.headline.in_(lang)),
                " ".join(mark.codes),
                " ".join(map(str, mark.beliefs)),
                "; ".join(MISCONCEPTIONS[one].title.in_(lang) for one in mark.beliefs if one in MISCONCEPTIONS),
                row.group or "",
                cell(row.file),
                cell("; ".join(row.others)),
                cell(f"{REPORTS}/{row.page}"),
            ]
        )
    return _BOM + sheet.getvalue()


def cell(words: str) -> str:
    """Keep a spreadsheet from reckoning with what a learner typed: words that begin like a formula get an apostrophe."""
    return f"'{words}" if words.lstrip(" ").startswith(_FORMULA) or words.startswith(_FORMULA) else words


def json_of(rows: Sequence[Row], exercise: Exercise, lang: str) -> str:
    """Give the results as JSON."""
    return json.dumps(results(rows, exercise, lang), ensure_ascii=False, indent=1) + "\n"


def results(rows: Sequence[Row], exercise: Exercise, lang: str) -> dict[str, Any]:
    """Give all there is to know of a class as plain values: of the class, and of each learner."""
    return {
        "exercise": exercise.id,
        "version": version(),
        "points": exercise.points,
        "class": {
            **middle(rows),
            "distinct": distinct(rows),
            "histogram": [
                {"from": low, "below": high, "learners": count} for low, high, count in _bars(rows, exercise)
            ],
            "findings": {str(code): len(who) for code, who in tally(rows, lambda row: row.mark.codes)},
            "misconceptions": {str(number): len(who) for number, who in tally(rows, lambda row: row.mark.beliefs)},
        },
        "learners": [_learner(row, lang) for row in rows],
    }


def distinct(rows: Sequence[Row]) -> int:
    """Count the different answers among those that could be read."""
    return len({row.mark.same for row in rows if row.text.strip()})


def _bars(rows: Sequence[Row], exercise: Exercise) -> list[tuple[float, float, int]]:
    return histogram(rows, exercise.points)


def middle(rows: Sequence[Row]) -> dict[str, float]:
    """Give how many learners there are, and the mean and the median of their marks."""
    marks = [row.mark.marks for row in rows]
    mean, median = (statistics.fmean(marks), statistics.median(marks)) if marks else (0.0, 0.0)
    return {"learners": len(rows), "mean": round(mean, 2), "median": round(median, 2)}


def _learner(row: Row, lang: str) -> dict[str, Any]:
    mark = row.mark
    return {
        "learner": row.learner,
        "number": row.number,
        "marks": mark.marks,
        "status": mark.status,
        "headline": mark.headline.in_(lang),
        "findings": list(mark.codes),
        "misconceptions": list(mark.beliefs),
        "parts": [{"name": name.in_(lang), "got": got, "of": of} for name, got, of in mark.parts],
        "group": row.group,
        "file": row.file,
        "others": list(row.others),
        "report": f"{REPORTS}/{row.page}",
    }
