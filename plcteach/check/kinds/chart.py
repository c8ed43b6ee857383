"""Say when an output is on: a row for each output with one sign for each scan."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.answers import graded, looked_at, quoted, refused, rows, seen, text_of
from plcteach.check.judgement import Judgement, Sheet
from plcteach.core.diagnostic import rule
from plcteach.core.errors import DeclarationError
from plcteach.core.source import Span
from plcteach.core.text import NOTHING, Text
from plcteach.machine.scan import run

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.exercise import Exercise
    from plcteach.core.program import Program
    from plcteach.machine.scan import Trace

EMPTY = "."
UNREAD = "?"
_SIGNS = {"0": "0", "_": "0", "1": "1", "#": "1", "x": "x", ".": EMPTY, "-": EMPTY}
_GROUPED = 5
_INPUTS = Text("输入，一个扫描一个值：", "Inputs, one value for each scan:")
_EACH = Text("每个扫描{ms} ms。", "Each scan takes {ms} ms.")
_TIMES = Text("各扫描之前经过的时间（ms）：{times}", "Time before each scan (ms): {times}")
_FIRST_WRONG = Text(
    "{address}在第{scan}个扫描不是这样：那时{inputs}。从第一行起把这个扫描走一遍，好吗？",
    "{address} is not so in scan {scan}, where {inputs}. Can you go through that scan from the first line on?",
)
_ALL_0 = Text("所有输入都是0", "all inputs are 0")


def shown(exercise: Exercise) -> Sheet:
    """Give the program, the course of the inputs, and an empty row for each output."""
    program = looked_at(exercise)
    outputs = asked(exercise, program)
    count = len(exercise.scans)
    columns = tuple(str(number) for number in range(1, count + 1))
    start = "".join(f"{address} {grouped(EMPTY * count)}\n" for address in outputs)
    text = _inputs_said(exercise, run(program, exercise.scans))
    return Sheet("grid", text, program, seen(exercise), outputs, columns, exercise.start or start)


def judged(exercise: Exercise, answer: str | bytes) -> Judgement:
    """Count the scans that are right, and name the first that is not.

    A row that never changes earns nothing where the right one changes: it says nothing of when the output is on.
    """
    text = text_of(answer)
    program = looked_at(exercise)
    outputs = asked(exercise, program)
    found = refused(text)
    if found:
        return graded(exercise, text, 0.0, found=found)
    trace = run(program, exercise.scans)
    given, found = _read(text, outputs, len(exercise.scans))
    if not any(sign != EMPTY for row in given.values() for sign in row):
        found = (*found, rule("KND011").at(Span(1)))
    wrong = tuple(
        (row, scan)
        for row, address in enumerate(outputs)
        for scan, (one, other) in enumerate(zip(trace[address], given[address], strict=True))
        if one != other
    )
    share = _share([(trace[address], given[address]) for address in outputs])
    return graded(
        exercise, text, share, found=found, says=_says(trace, outputs, wrong), wrong=wrong, grid=given.values()
    )


def model(exercise: Exercise) -> str:
    """Give the rows as the machine runs."""
    program = looked_at(exercise)
    trace = run(program, exercise.scans)
    return "".join(f"{address} {grouped(trace[address])}\n" for address in asked(exercise, program))


def asked(exercise: Exercise, program: Program) -> tuple[str, ...]:
    """Give the addresses whose course is asked for: those of the exercise, else the outputs that the program names."""
    found = exercise.terms.outputs or tuple(one.text for one in program.addresses("output"))
    if not found or not exercise.scans:
        msg = f"exercise {exercise.id}: a chart wants an output and scans"
        raise DeclarationError(msg)
    return found


def grouped(signs: str) -> str:
    """Part a row of signs into groups that the eye can count."""
    return " ".join(signs[at : at + _GROUPED] for at in range(0, len(signs), _GROUPED))


def _read(text: str, outputs: tuple[str, ...], count: int) -> tuple[dict[str, str], tuple[Diagnostic, ...]]:
    """Read a row for each output; what is missing is empty, and what is too much is left out."""
    found: list[Diagnostic] = []
    given: dict[str, str] = {}
    known = {_plain(address): address for address in outputs}
    for number, row in rows(text):
        head, _, rest = row.replace(":", " ").replace("=", " ").partition(" ")
        address = known.get(_plain(head))
        if address is None and len(outputs) == 1 and set(head.lower()) <= set(_SIGNS):
            address, rest = outputs[0], row
        if address is None or address in given:
            found.append(rule("KND008").at(Span(number), wanted=", ".join(outputs)))
            continue
        given[address], misread = _signs(rest, address, count, number)
        found += misread
    return {address: given.get(address, EMPTY * count) for address in outputs}, tuple(found)


def _signs(rest: str, address: str, count: int, number: int) -> tuple[str, list[Diagnostic]]:
    words = "".join(rest.lower().split())
    unread = [one for one in words[:count] if one not in _SIGNS]
    found = [rule("KND005").at(Span(number), word=quoted(one)) for one in unread[:1]]
    if len(words) != count:
        found.append(rule("KND009").at(Span(number), address=address, got=len(words), wanted=count))
    return "".join(_SIGNS.get(one, UNREAD) for one in words[:count]).ljust(count, EMPTY), found


def _share(pairs: list[tuple[Sequence[str], str]]) -> float:
    """Give the share of all scans that are right, in rows that change where the right row changes."""
    counted = [pair for pair in pairs if _changes(pair[1]) or not _changes(pair[0])]
    right = sum(one == other for pair in counted for one, other in zip(*pair, strict=True))
    return right / sum(len(wanted) for wanted, _ in pairs)


def _changes(row: Iterable[str]) -> bool:
    return len(set(row) - {EMPTY}) > 1


def _plain(word: str) -> str:
    return word.upper().lstrip("%")


def _says(trace: Trace, outputs: tuple[str, ...], wrong: tuple[tuple[int, int], ...]) -> tuple[Text, ...]:
    """Name for each output the first scan that is not right, with the inputs as they then are."""
    first: dict[int, int] = {}
    for row, scan in wrong:
        first.setdefault(row, scan)
    names = [one.text for one in trace.program.addresses("input")]
    said = []
    for row, scan in sorted(first.items(), key=lambda one: one[1]):
        inputs = ", ".join(f"{name}={trace.value(name, scan)!r}" for name in names)
        where = Text(inputs, inputs) if inputs else _ALL_0
        said.append(_FIRST_WRONG.format(address=outputs[row], scan=scan + 1, inputs=where))
    return tuple(said)


def _inputs_said(exercise: Exercise, trace: Trace) -> Text:
    """Give the course of the inputs as rows of signs, and how long the scans take where that is told."""
    names = list(dict.fromkeys(one for row in exercise.scans for one in row if one != "ms"))
    longest = max(map(len, names), default=0)
    lines = [f"{name:<{longest}} {grouped(_signs_of(trace, name))}" for name in names]
    times = [row["ms"] for row in exercise.scans if "ms" in row]
    time = NOTHING
    if times and len(times) == len(exercise.scans) and len(set(times)) == 1:
        time = _EACH.format(ms=times[0])
    elif times:
        time = _TIMES.format(times=" ".join(str(row.get("ms", "·")) for row in exercise.scans))
    zh, en = ([said, *lines, after] for said, after in ((_INPUTS.zh, time.zh), (_INPUTS.en, time.en)))
    return Text("\n".join(filter(None, zh)), "\n".join(filter(None, en)))


def _signs_of(trace: Trace, name: str) -> str:
    values = trace[name]
    return values if isinstance(values, str) else " ".join(map(str, values))
