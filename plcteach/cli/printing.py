"""Prints for people and for programs: findings with carets, tables, JSON and nothing but JSON."""

from __future__ import annotations

import json
import sys
from typing import TYPE_CHECKING, Any

from plcteach.check.chart import chart_of
from plcteach.check.report import summary
from plcteach.core.diagnostic import errors
from plcteach.core.source import printable, rows_of
from plcteach.core.text import Text, language
from plcteach.ladder.symbols import columns

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.cli.folder import Linted
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.program import Program
    from plcteach.core.verdict import Verdict


def say(zh: str, en: str) -> str:
    """Give a sentence of the command line's own in the language in force."""
    return Text(zh, en).in_(language())


def say_empty(program: Program) -> None:
    """Say so where a text holds no instruction and nothing else was said of it."""
    if not program.lines and not program.diagnostics:
        print(say("这里面没有指令。第一条应是什么？", "There is no instruction in it. What should the first one be?"))


def print_json(value: object) -> None:
    """Print one JSON value on one line."""
    text = json.dumps(value, ensure_ascii=False)
    try:
        text.encode(sys.stdout.encoding or "utf-8")
    except UnicodeEncodeError:
        text = json.dumps(value)
    print(text)


def plain(value: str) -> int | str:
    """Turn a shown value into what JSON has: a number, or "x"."""
    return value if value == "x" else int(value)


def finding_json(one: Diagnostic) -> dict[str, Any]:
    """Give a finding as the contract has it, in one language."""
    lang = language()
    notes = [note.text.in_(lang) for note in one.notes] + ([one.fix.in_(lang)] if one.fix.en else [])
    return {
        "code": one.code,
        "severity": one.severity,
        "row": one.span.row,
        "start": one.span.start,
        "stop": one.span.stop,
        "text": one.text.in_(lang),
        "notes": notes,
    }


def verdict_json(verdict: Verdict) -> dict[str, Any]:
    """Give a verdict as the contract has it."""
    example = verdict.counterexample
    return {
        "status": verdict.status,
        "level": verdict.level,
        "proof": verdict.proof,
        "counterexample": example
        and {
            "inputs": list(example.inputs),
            "outputs": list(example.expected[0]),
            "expected": [{name: plain(value) for name, value in row.items()} for row in example.expected],
            "got": [{name: plain(value) for name, value in row.items()} for row in example.got],
            "first": {"scan": example.scan, "address": example.address},
        },
        "outputs": dict(verdict.outputs),
        "diagnostics": [finding_json(one) for one in verdict.diagnostics],
        "explored": verdict.explored,
    }


_MOST_ROWS = 12
"""A counterexample of more scans than this is printed as a chart, in which scans that are alike are one column."""


def print_verdict(verdict: Verdict) -> None:
    """Print the status, and the scans that tell the two programs apart."""
    print(summary(verdict).in_(language()))
    example = verdict.counterexample
    if example is None:
        return
    chart = chart_of(verdict)
    if chart and (chart.timed or len(example.inputs) > _MOST_ROWS):
        print("\n".join(line.in_(language()) for line in chart.lines))
        return
    inputs = sorted({name for row in example.inputs for name in row})
    held: dict[str, int] = {}
    table = []
    for number, row in enumerate(example.inputs):
        held |= row
        expected, got = example.expected[number], example.got[number]
        table.append(
            [number, *(held.get(name, 0) for name in inputs), *(f"{expected[name]} / {got[name]}" for name in expected)]
        )
    heads = [f"{name} {say('应为/实际', 'expected/got')}" for name in example.expected[0]]
    print_table([say("扫描", "scan"), *inputs, *heads], table)


_SEVERITIES = {"error": Text("错误", "error"), "warning": Text("警告", "warning"), "info": Text("提示", "info")}


def print_findings(found: Sequence[Diagnostic], source: Program | str) -> None:
    """Print findings the way a compiler does: the place, the row with carets, what is said and what to do."""
    lang = language()
    rows = rows_of(source if isinstance(source, str) else source.source)
    for one in found:
        severity = _SEVERITIES[one.severity].in_(lang)
        place = f"{one.span.row}:{one.span.start + 1}: " if one.span.row else ""
        print(f"{place}{severity} {one.code}: {one.text.in_(lang)}")
        if 0 < one.span.row <= len(rows):
            row = printable(rows[one.span.row - 1][:200])
            print(f"    {row}")
            print(
                "    "
                + " " * columns(row[: one.span.start])
                + "^" * max(1, columns(row[one.span.start : one.span.stop]))
            )
        for note in one.notes:
            print(f"    {note.span.row}: {note.text.in_(lang)}")
        if one.fix.en:
            print(f"    {one.fix.in_(lang)}")


def print_folder(files: Sequence[Linted]) -> None:
    """Print what was found file by file, and at the end a table with a row for each file and the totals."""
    if not files:
        print(say("这个文件夹里没有程序。", "There is no program in this folder."))
        return
    for one in files:
        if one.found:
            print(f"== {one.name}")
            print_findings(one.found, one.program)
    table = [
        [
            say("文件", "file"),
            say("读来像", "reads like"),
            say("错误", "errors"),
            say("警告", "warnings"),
            say("第一条", "first finding"),
        ],
        *([one.name, one.other.in_(language()), *_counts([one]), _first(one.found)] for one in files),
        [say(f"共{len(files)}个文件", f"{len(files)} files"), "", *_counts(files), ""],
    ]
    if not any(one.other.en for one in files):
        table = [[row[0], *row[2:]] for row in table]
    print_table(table[0], table[1:])


def _counts(files: Sequence[Linted]) -> tuple[str, str]:
    severities = [each.severity for one in files for each in one.found]
    return f"{severities.count('error')}", f"{severities.count('warning')}"


def _first(found: Sequence[Diagnostic]) -> str:
    """Give the first error, or else the first finding, in as few words as a table has room for."""
    one = next(iter(errors(found)), found[0] if found else None)
    if one is None:
        return ""
    words = f"{one.span.row}: {one.code} {one.text.in_(language())}"
    while columns(words) > _ROOM:
        words = f"{words[:-2]}…"
    return words


_ROOM = 60


def print_table(head: Sequence[object], rows: Sequence[Sequence[object]]) -> None:
    """Print rows in columns, wide characters counted as two."""
    cells = [[str(cell) for cell in row] for row in (head, *rows)]
    widths = [max(columns(row[column]) for row in cells) for column in range(len(head))]
    for row in cells:
        print("  ".join(cell + " " * (width - columns(cell)) for cell, width in zip(row, widths, strict=True)).rstrip())
