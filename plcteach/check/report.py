"""A verdict in words and in a table: what the desk, the score and the command line all say of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from plcteach.core.diagnostic import errors
from plcteach.core.text import Text

if TYPE_CHECKING:
    from plcteach.check.judge import Judgement
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.verdict import Verdict


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
    inputs: dict[str, int] = {}
    for scan in example.inputs:
        inputs.update(scan)
    rows = [Row(address, "input", str(value), _LABELS["input"]) for address, value in inputs.items()]
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


def headline(judgement: Judgement) -> Text:
    """Say the verdict in one line, the counterexample first where there is one."""
    verdict = judgement.verdict
    marks = Text(
        f"{judgement.marks:g}/{judgement.exercise.points:g}分", f"{judgement.marks:g} of {judgement.exercise.points:g}"
    )
    match verdict.status:
        case "equal":
            proof = _PROOFS[verdict.proof or "table"]
            return Text("正确，{marks}：{proof}。", "Correct, {marks}: {proof}.").format(marks=marks, proof=proof)
        case "error":
            return _error(verdict.diagnostics)
        case "different":
            return _different(verdict)
    return Text(
        "没有发现差别，但也没能证明相同（查看了{n}个状态）。",
        "No difference was found, but none was excluded either ({n} states seen).",
    ).format(n=verdict.explored)


def _error(found: tuple[Diagnostic, ...]) -> Text:
    wrong = errors(found)
    if not wrong:
        return Text("还没有程序。先写第一条指令吧。", "There is no program yet. Which instruction comes first?")
    one = wrong[0]
    row = Text(f"第{one.span.row}行：", f"Row {one.span.row}: ")
    return Text(row.zh + one.text.zh, row.en + one.text.en)


def _different(verdict: Verdict) -> Text:
    example = verdict.counterexample
    if example is None:
        return Text("与参考不同。", "It differs from the reference.")
    inputs = ", ".join(f"{row.address}={row.value}" for row in table(verdict) if row.kind == "input")
    words = Text(
        "当{inputs}时，{address}应为{expected}，你的程序给出{got}{scan}。",
        "With {inputs}, {address} should be {expected}; your program gives {got}{scan}.",
    )
    later = Text(f"（第{example.scan + 1}个扫描）", f" (scan {example.scan + 1})") if example.scan else Text("", "")
    return words.format(
        inputs=inputs,
        address=example.address,
        expected=example.expected[example.scan][example.address],
        got=example.got[example.scan][example.address],
        scan=later,
    )


def verdict_json(judgement: Judgement) -> dict[str, Any]:
    """Give the judgement as the desk in the browser wants it."""
    verdict = judgement.verdict
    return {
        "status": verdict.status,
        "headline": headline(judgement).as_dict(),
        "marks": judgement.marks,
        "max": judgement.exercise.points,
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
        "canShow": verdict.counterexample is not None,
    }
