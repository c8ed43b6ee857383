"""A judgement in words, in a table and as HTML: what the desk, the score and the command line all say of it."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, Any, Literal

from plcteach.check.chart import chart_of, held, passed
from plcteach.check.judge import shown
from plcteach.check.judgement import UNMET
from plcteach.core.diagnostic import errors
from plcteach.core.text import NOTHING, Text, joined
from plcteach.figure.face import lasting

if TYPE_CHECKING:
    from plcteach.check.chart import Chart
    from plcteach.check.chart import Row as ChartRow
    from plcteach.check.judgement import Judgement
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.verdict import Counterexample, Verdict


@dataclass(frozen=True, slots=True)
class Row:
    """One line of a counterexample: an input's value, or what an output should be and is."""

    address: str
    kind: Literal["input", "expected", "got"]
    value: str
    label: Text
    differs: bool = False


_LABELS = {
    "input": Text("输入", "input"),
    "expected": Text("应为", "expected"),
    "got": Text("你的程序", "yours"),
}
_PROOFS = {
    "structural": Text("与参考完全一样", "it is the reference, line for line"),
    "table": Text("所有输入组合都试过", "every combination of inputs was tried"),
    "exhaustive": Text("所有能到达的状态都试过", "every state that can be reached was tried"),
    "induction": Text("对任意多个扫描都成立", "it holds for any number of scans"),
}


def table(verdict: Verdict) -> list[Row]:
    """Give the counterexample's last scan as rows: the inputs, then for each output the expected and the actual value."""
    example = verdict.counterexample
    if example is None:
        return []
    inputs = held(example)[example.scan]
    rows = [Row(address, "input", value, _LABELS["input"]) for address, value in inputs.items()]
    for address, wanted in example.expected[example.scan].items():
        got = example.got[example.scan][address]
        rows.append(Row(address, "expected", wanted, _LABELS["expected"]))
        rows.append(Row(address, "got", got, _LABELS["got"], differs=wanted != got))
    return rows


_STATUSES = {
    "equal": Text("相同", "equal"),
    "different": Text("不同", "different"),
    "unsettled": Text("停不下来", "unsettled"),
    "unknown": Text("无法判定", "unknown"),
    "error": Text("程序有错误", "error"),
}


def summary(verdict: Verdict) -> Text:
    """Say the status, and how it is known."""
    status = _STATUSES[verdict.status]
    if verdict.proof:
        return Text("{status}：{proof}", "{status}: {proof}").format(status=status, proof=_PROOFS[verdict.proof])
    if verdict.status == "unknown":
        return Text(
            f"{status.zh}：看了{verdict.explored}个状态，没有发现差别",
            f"{status.en}: no difference in {verdict.explored} states",
        )
    return status


_RIGHT = Text("正确，{marks}：{proof}。", "Correct, {marks}: {proof}.")
_RIGHT_BUT = Text("{marks}：{need}", "{marks}: {need}")
_ALL_RIGHT: dict[str, Text] = {
    "predict": Text("堆栈的每一个值都对", "every value of the stack is as the machine has it"),
    "join": Text("两个电路块都对", "both blocks are the ones it joins"),
    "match": Text("这个梯形图和程序作用相同", "this ladder does what the list does"),
    "chart": Text("每个扫描都对", "every scan is as the machine has it"),
}
_PARTLY = Text("{marks}。{first}", "{marks}. {first}")
_NOT_YET = Text("还不对。", "Not yet.")
_UNSETTLED = Text(
    "输入不变，输出却停不下来，所以没有可以比较的结果。哪两个梯级互相改来改去？",
    "With its inputs held, the program never comes to rest, so there is nothing to compare. Which rungs undo each other?",
)
_NOT_KNOWN = Text(
    "没有发现差别，但也没能证明相同（查看了{n}个状态）。",
    "No difference was found, but none was excluded either ({n} states seen).",
)
_WORDS = {
    "program": Text(
        "{when}，{address}应为{expected}，你的程序给出{got}{scan}。",
        "{when}, {address} should be {expected}; your program gives {got}{scan}.",
    ),
    "never": Text(
        "{when}，{address}成立，而这绝不允许出现{scan}。",
        "{when}, {address} holds, and that must never be{scan}.",
    ),
    "match": Text(
        "{when}，程序使{address}为{expected}，这个梯形图使它为{got}{scan}。",
        "{when}, the list makes {address} {expected}, and this ladder makes it {got}{scan}.",
    ),
}


def marks_said(judgement: Judgement) -> Text:
    """Say the marks: 2.5 of 4."""
    got, points = f"{judgement.marks:g}", f"{judgement.exercise.points:g}"
    return Text(f"{got}/{points}分", f"{got} of {points}")


def headline(judgement: Judgement) -> Text:
    """Say the judgement in one line, the counterexample first where there is one."""
    verdict = judgement.verdict
    match verdict.status:
        case "equal":
            return _correct(judgement)
        case "error":
            return _error(verdict.diagnostics, placed=judgement.exercise.kind not in _ALL_RIGHT)
        case "different":
            return _wrong(judgement)
        case "unsettled":
            return _UNSETTLED
    return _NOT_KNOWN.format(n=verdict.explored)


def _correct(judgement: Judgement) -> Text:
    """Say why it is right; or what the task asks for beside that."""
    marks = marks_said(judgement)
    if judgement.says:
        return _RIGHT_BUT.format(marks=marks, need=judgement.says[0])
    proof = _ALL_RIGHT.get(judgement.exercise.kind) or _PROOFS[judgement.verdict.proof or "table"]
    return _RIGHT.format(marks=marks, proof=proof)


def _wrong(judgement: Judgement) -> Text:
    verdict, kind = judgement.verdict, judgement.exercise.kind
    if verdict.counterexample is None and kind in _ALL_RIGHT:
        return _PARTLY.format(marks=marks_said(judgement), first=next(iter(judgement.says), _NOT_YET))
    if verdict.counterexample is not None and verdict.counterexample.address in judgement.exercise.terms.never:
        return _different(verdict, _WORDS["never"])
    return _different(verdict, _WORDS["match" if kind == "match" else "program"])


def _error(found: tuple[Diagnostic, ...], *, placed: bool) -> Text:
    wrong = errors(found)
    if not wrong:
        return Text("还没有程序。先写第一条指令吧。", "There is no program yet. Which instruction comes first?")
    one = wrong[0]
    row = Text(f"第{one.span.row}行：", f"Row {one.span.row}: ") if placed else NOTHING
    return Text(row.zh + one.text.zh, row.en + one.text.en)


def _different(verdict: Verdict, words: Text) -> Text:
    example = verdict.counterexample
    if example is None:
        return Text("与参考不同。", "It differs from the reference.")
    later = Text(f"（第{example.scan + 1}个扫描）", f" (scan {example.scan + 1})") if example.scan else NOTHING
    return words.format(
        when=_when(example),
        address=example.address,
        expected=example.expected[example.scan][example.address],
        got=example.got[example.scan][example.address],
        scan=later,
    )


_WHEN = {
    (True, False): Text("当{inputs}时", "With {inputs}"),
    (True, True): Text("{time}后，当{inputs}时", "After {time}, with {inputs}"),
    (False, True): Text("{time}后", "After {time}"),
    (False, False): Text("没有任何输入", "Without any input"),
}


def _when(example: Counterexample) -> Text:
    """Say when two programs differ: with which inputs, and how long after the first scan where times matter."""
    values = held(example)[example.scan]
    inputs = ", ".join(f"{address}={value}" for address, value in values.items())
    ms = passed(example)
    return _WHEN[bool(inputs), bool(ms)].format(inputs=inputs, time=lasting(ms))


def verdict_json(judgement: Judgement) -> dict[str, Any]:
    """Give the judgement as the desk in the browser wants it."""
    verdict = judgement.verdict
    chart = chart_of(verdict)
    return {
        "status": verdict.status,
        "kind": judgement.exercise.kind,
        "headline": headline(judgement).as_dict(),
        "marks": judgement.marks,
        "max": judgement.exercise.points,
        "parts": [{"name": one.name.as_dict(), "got": one.got, "of": one.of} for one in judgement.parts],
        "says": [one.as_dict() for one in judgement.says],
        "wrong": [list(place) for place in judgement.wrong],
        "rows": [
            {
                "address": row.address,
                "kind": row.kind,
                "value": row.value,
                "label": row.label.as_dict(),
                "differs": row.differs,
            }
            for row in table(verdict)
        ],
        "outputs": dict(verdict.outputs),
        "chart": chart.as_dict() if chart else None,
        "diagnostics": [_finding_json(one) for one in verdict.diagnostics[:_MOST_FINDINGS]],
        "canShow": verdict.counterexample is not None and judgement.program is not None,
    }


def _finding_json(one: Diagnostic) -> dict[str, Any]:
    return {
        "code": one.code,
        "severity": one.severity,
        "row": one.span.row,
        "text": one.text.as_dict(),
        "why": one.why.as_dict(),
    }


_MOST_FINDINGS = 20
_CELL = "padding:0 .6em;text-align:center"


def report_html(judgement: Judgement, lang: str) -> str:
    """Give the report as HTML: the headline, the marks by parts, the remarks, the findings, and the counterexample's chart."""
    rows = [f"<p><strong>{escape(headline(judgement).in_(lang))}</strong></p>"]
    if len(judgement.parts) > 1 or 0 < judgement.marks < judgement.exercise.points:
        rows.append(f"<p>{escape(_marks_by_parts(judgement).in_(lang))}</p>")
    remarks = [escape(one.in_(lang)) for one in judgement.says]
    found = [one for one in judgement.verdict.diagnostics if one.code != UNMET]
    remarks += [_finding_html(one, lang) for one in found[:_MOST_FINDINGS]]
    if remarks:
        rows.append(f"<ul>{''.join(f'<li>{one}</li>' for one in remarks)}</ul>")
    chart = chart_of(judgement.verdict)
    if chart:
        rows.append(_chart_html(chart, lang))
    if judgement.grid and judgement.wrong:
        rows.append(_grid_html(judgement, lang))
    return "".join(rows)


def _marks_by_parts(judgement: Judgement) -> Text:
    """Say the marks, and where there are several parts what was reached of each."""
    said = Text("得分：{marks}", "Marks: {marks}").format(marks=marks_said(judgement))
    if len(judgement.parts) < 2:  # noqa: PLR2004 (one part is the whole)
        return said
    each = [
        Text("{name}{of}分得{got}分", "{name} {got} of {of}").format(
            name=one.name, got=f"{one.got:g}", of=f"{one.of:g}"
        )
        for one in judgement.parts
    ]
    return Text("{said}（{each}）", "{said} ({each})").format(said=said, each=joined(each, "，", ", "))


def _finding_html(one: Diagnostic, lang: str) -> str:
    return f"<code>{one.code}</code> {_row(one.span.row, lang)}{escape(one.text.in_(lang))}"


def _row(row: int, lang: str) -> str:
    if not row:
        return ""
    return f"第{row}行：" if lang == "zh" else f"row {row}: "


def _chart_html(chart: Chart, lang: str) -> str:
    """Write the chart as a table, which every reader shows and reads aloud."""
    holds = "".join(f'<th scope="col" style="{_CELL}">{escape(one.in_(lang))}</th>' for one in chart.holds)
    body = "".join(_chart_row(row, lang) for row in chart.rows)
    return f"<table><tr><td></td>{holds}</tr>{body}</table>"


def _grid_html(judgement: Judgement, lang: str) -> str:
    """Write the grid as it was filled in, with what is not right marked; what would be right it does not tell."""
    sheet = shown(judgement.exercise)
    heads = [one.in_(lang) for one in sheet.heads] or list(sheet.columns)
    head = "".join(f'<th scope="col" style="{_CELL}">{escape(one)}</th>' for one in heads)
    wrong = set(judgement.wrong)
    body = "".join(
        f'<tr><th scope="row" style="text-align:left"><code>{escape(name)}</code></th>'
        + "".join(_cell_html(sign, wrong=(row, at) in wrong) for at, sign in enumerate(signs))
        + "</tr>"
        for row, (name, signs) in enumerate(zip(sheet.rows, judgement.grid, strict=True))
    )
    return f"<table><tr><td></td>{head}</tr>{body}</table>"


def _cell_html(value: str, *, wrong: bool) -> str:
    said = f"<strong>≠ {escape(value)}</strong>" if wrong else escape(value)
    return f'<td style="{_CELL}">{said}</td>'


def _chart_row(row: ChartRow, lang: str) -> str:
    differs = row.differs or (False,) * len(row.values)
    cells = "".join(_cell_html(value, wrong=wrong) for value, wrong in zip(row.values, differs, strict=True))
    label = escape(row.label.in_(lang))
    return f'<tr><th scope="row" style="text-align:left"><code>{label}</code></th>{cells}</tr>'
