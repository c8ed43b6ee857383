"""How a rule of a family is written as a case: a sentence, a program, and what goes in and comes out scan by scan."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING
from unittest.mock import patch

from plcteach.check.lint import lint
from plcteach.machine import recorder, run
from plcteach.machine.scan import warm
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.program import Program
    from plcteach.machine.trace import Trace


@dataclass(frozen=True)
class Rule:
    """A rule in a sentence, a program, what it is given and what it must show.

    Bits are written as signs, one for each scan (`I0.0 0110`), numbers with commas (`VW0=3,.,5`); a dot names nothing and asks
    nothing. `ms`: the scan time. `off`: before this scan the power goes and comes back. `says`: codes that the run reports.
    """

    sentence: str
    text: str
    given: str
    wanted: str
    ms: int = 10
    off: int = 0
    says: tuple[str, ...] = ()

    def __str__(self) -> str:
        return self.sentence


def _columns(text: str) -> dict[str, list[str]]:
    """Give the signs or numbers of every address, one for each scan."""
    found = {}
    for part in filter(None, (one.strip() for one in text.split(";"))):
        name, equals, numbers = part.partition("=")
        if equals:
            found[name] = [one.strip() for one in numbers.split(",")]
        else:
            name, _, signs = part.rpartition(" ")
            found[name] = list(signs)
    return found


def _number(word: str) -> float:
    return float(word) if "." in word else int(word)


def check(rule: Rule, dialect: str) -> None:
    """Run a rule's program, line by line and as generated source, and compare every address with what was written down."""
    program = read(rule.text.replace(" / ", "\n"), dialect)
    assert program.runs, program.diagnostics
    given, wanted = _columns(rule.given), _columns(rule.wanted)
    count = max(map(len, [*given.values(), *wanted.values()]))
    rows = [
        {name: _number(cells[scan]) for name, cells in given.items() if scan < len(cells) and cells[scan] != "."}
        for scan in range(count)
    ]
    for patience in (count, 0):
        with patch.object(recorder, "PATIENCE", patience):
            traces = _traces(rule, program, rows)
        for name, cells in wanted.items():
            got = [repr(value) for trace in traces for value in trace.values(name)]
            seen = [one if sign != "." else "." for one, sign in zip(got, cells, strict=False)]
            assert (name, seen) == (name, cells)
        assert tuple(one.code for trace in traces for one in trace.diagnostics) == rule.says


def _traces(rule: Rule, program: Program, rows: list[dict[str, float]]) -> list[Trace]:
    """Run to the end, or to the power failure and from there on."""
    first = run(program, rows[: rule.off or None], scan_ms=rule.ms)
    if not rule.off:
        return [first]
    return [first, run(program, rows[rule.off :], scan_ms=rule.ms, memory=warm(program, first.memory))]


def said(text: str, dialect: str) -> list[tuple[str, str, int]]:
    """Give what is found in a list without running it: how grave, which code, which row."""
    return [(one.severity, one.code, one.span.row) for one in lint(read(text.replace("/", "\n"), dialect))]
