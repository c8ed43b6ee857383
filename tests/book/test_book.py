"""The books' figures and programs as cases: every `## ` section of every Markdown file in this folder is one.

A case is prose and fenced blocks; each block is checked by what its first word names, against the last `stl` block above it.

    ```stl fx                 the program, with its dialect
    ```stack                  the stack after lines of it, top first: `3  RR=X2 | X0·X1`
                              cells are formulas, compared by their meaning over all values of the names in them;
                              `A = X0+X2` gives a formula a name, `|` alone is an empty stack, a last cell `x …` repeats
                              to the bottom, `;` separates the stacks of a family that has several, `RR=` names a register
    ```stack X0=1 X2=0        the same with values (0, 1, x) for these inputs
    ```gives                  `Y0 = X0·X1 + X2`: an output after one scan from power-on, for all values of the names in it
    ```run                    scan by scan: `X0 X1 | Y0` as the head, then a row of values a scan
    ```time 10ms 20s          the inputs over time, as a teacher types them (`I0.0: 1s off, 0.2s on, off`), the scan time
                              (10ms) and when it ends (1 s after the last change); runs the program for the next block
    ```then                   what the scans of that run leave behind, in the same language, scan by scan: `Q0.0: 1s off, on`
                              is 0 in every scan that starts before 1 s and 1 from there on; words have numbers (`T37.V: 1s 0,
                              10 x (100ms 1, 100ms 2), 5`); `at most 1 of Q0.0 Q0.1`; `says RUN001 at 3` for each finding;
                              `turns every 500ms: Q0.0`: it is on and off for so long by turns, whichever comes first
    ```figure s7-200 LDS 3    the before and after columns of an instruction, top first
    ```ladder                 a drawing that lowers to the program
    ```lint                   everything that is said: `error STK003 at 6`, or `nothing`
    ```same                   another list of the same dialect that leaves the same stacks, for all inputs
    ```says fx                named facts: `register: …`, `cells below it: …`, `cells: …`
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import pairwise, product
from pathlib import Path

import pytest

from plcteach.check.lint import lint
from plcteach.dialects import dialect
from plcteach.figure.illustration import illustration
from plcteach.ladder.lower import lower
from plcteach.ladder.picture import read_drawing
from plcteach.machine import Trace, run
from plcteach.machine.formula import spelled, written
from plcteach.machine.timeline import timeline
from plcteach.stl import read, write

FOLDER = Path(__file__).parent


@dataclass(frozen=True)
class Block:
    """A fenced block: its first word, what follows it on that line, and its rows."""

    kind: str
    about: str
    rows: list[str]


@dataclass(frozen=True)
class Case:
    """One section of one file."""

    document: str
    heading: str
    blocks: list[Block]


def cases() -> list[Case]:
    return [
        case for path in sorted(FOLDER.glob("*.md")) for case in sections(path.name, path.read_text(encoding="utf-8"))
    ]


def sections(name: str, text: str) -> list[Case]:
    """Cut a file at its `## ` headings; fenced blocks may hold anything."""
    found: list[Case] = []
    open_block: Block | None = None
    for row in text.split("\n"):
        if open_block is not None:
            if row.startswith("```"):
                open_block = None
            else:
                open_block.rows.append(row)
        elif row.startswith("```"):
            kind, _, about = row[3:].partition(" ")
            open_block = Block(kind, about.strip(), [])
            found[-1].blocks.append(open_block)
        elif row.startswith("## "):
            found.append(Case(name, row[3:].strip(), []))
    return found


# Formulas, read and evaluated here and not by the code under test.

_TOKEN = re.compile(r"\s*([()+·*/⊕]|[↑↓]?[\w.%]+)")


class Formula:
    """A Boolean formula: `+` or, `⊕` exclusive or, `·` and, `/` not, and names (an edge ↑X0 is a name)."""

    def __init__(self, text: str, named: dict[str, str] | None = None) -> None:
        self.words = _TOKEN.findall(text)
        assert "".join(self.words) == "".join(text.split()), f"cannot read the formula {text!r}"
        self.place = 0
        self.named = {name: Formula(meaning) for name, meaning in (named or {}).items()}
        self.names = {word for word in self.words if word[0] not in "()+·*/⊕" and word not in self.named}
        for meaning in self.named.values():
            self.names |= meaning.names if set(self.words) & set(self.named) else set()

    def at(self, values: dict[str, int]) -> int:
        self.place, self.values = 0, values
        value = self.sum()
        assert self.place == len(self.words), f"words are left over in {self.words}"
        return value

    def sum(self) -> int:
        value = self.exclusive()
        while self.peek() == "+":
            self.place += 1
            value |= self.exclusive()
        return value

    def exclusive(self) -> int:
        value = self.product()
        while self.peek() == "⊕":
            self.place += 1
            value ^= self.product()
        return value

    def product(self) -> int:
        value = self.factor()
        while self.peek() in ("·", "*"):
            self.place += 1
            value &= self.factor()
        return value

    def factor(self) -> int:
        word = self.peek()
        self.place += 1
        if word == "/":
            return 1 - self.factor()
        if word == "(":
            value = self.sum()
            assert self.peek() == ")"
            self.place += 1
            return value
        if word in self.named:
            return self.named[word].at(self.values)
        return int(word) if word in ("0", "1") else self.values[word]

    def peek(self) -> str:
        return self.words[self.place] if self.place < len(self.words) else ""


def same_meaning(one: Formula, other: Formula) -> bool:
    names = sorted(one.names | other.names)
    assert len(names) <= 16
    rows = (dict(zip(names, bits, strict=True)) for bits in product((0, 1), repeat=len(names)))
    return all(one.at(row) == other.at(row) for row in rows)


def test_the_formulas_of_the_cases_mean_what_they_should() -> None:
    assert same_meaning(Formula("a·(b+c)"), Formula("a·b + a·c"))
    assert same_meaning(Formula("/(a·b)"), Formula("/a+/b"))
    assert not same_meaning(Formula("a+b·c"), Formula("(a+b)·c"))
    assert same_meaning(Formula("A·D", {"A": "X0+X2", "D": "X1+X3"}), Formula("(X0+X2)·(X1+X3)"))
    assert same_meaning(Formula("/a⊕b"), Formula("a·b+/a·/b"))


# What each kind of block asserts. Each takes the block and the program above it.


def columns(text: str, drawn: int | None = None) -> list[list[str]]:
    """Read the cells of one row: stacks separated by `;`, cells by `|`, `RR=` before the register."""
    stacks = []
    for part in text.split(";"):
        cells = [re.sub(r"^\s*\w+\s*=\s*", "", cell).strip() for cell in part.split("|")]
        cells = [cell for cell in cells if cell]
        if cells and cells[-1].endswith("…"):
            cells[-1] = cells[-1].removesuffix("…").strip()
            cells += [cells[-1]] * ((drawn or len(cells)) - len(cells))
        stacks.append(cells)
    return stacks


def check_stack(block: Block, program) -> None:
    values = dict(word.split("=") for word in block.about.split())
    named: dict[str, str] = {}
    if values:
        steps = run(program, [{name: int(value) for name, value in values.items()}]).scans[0].steps
        shown = [[[repr(cell) for cell in cells] for cells in one.after] for one in steps]
    else:
        shown = [[[written(cell) for cell in cells] for cells in one.after] for one in spelled(program)]
    checked = 0
    for row in filter(None, map(str.strip, block.rows)):
        line = re.match(r"(\d+)\s+(.*)", row)
        if line is None:
            name, _, meaning = row.partition("=")
            named[name.strip()] = meaning.strip()
            continue
        wanted = columns(line[2], max(stack.depth for stack in program.dialect.stacks))
        got = shown[int(line[1]) - 1]
        wanted += [[] for _ in range(len(got) - len(wanted))]
        assert [len(cells) for cells in got] == [len(cells) for cells in wanted], f"line {line[1]}: {got}"
        for cells, expected in zip(got, wanted, strict=True):
            for cell, meant in zip(cells, expected, strict=True):
                if values:
                    assert cell == meant, f"line {line[1]}: {got}"
                else:
                    assert same_meaning(Formula(cell), Formula(meant, named)), f"line {line[1]}: {cell} is not {meant}"
        checked += 1
    assert checked


def check_gives(block: Block, program) -> None:
    for row in filter(None, map(str.strip, block.rows)):
        output, _, meaning = row.partition("=")
        formula = Formula(meaning)
        names = sorted(formula.names | {address.text for address in program.addresses("input")})
        assert len(names) <= 12
        for bits in product((0, 1), repeat=len(names)):
            values = dict(zip(names, bits, strict=True))
            got = run(program, [values])[output.strip()]
            assert got == str(formula.at(values)), f"{output.strip()} at {values}"


def check_run(block: Block, program) -> None:
    head, *rows = [row for row in block.rows if row.strip()]
    inputs, outputs = (part.split() for part in head.split("|"))
    scans, expected = [], []
    for row in rows:
        given, wanted = (part.split() for part in row.split("|"))
        scans.append({name: int(value) for name, value in zip(inputs, given, strict=True)})
        expected.append(dict(zip(outputs, wanted, strict=True)))
    trace = run(program, scans)
    assert [{name: repr(scan[name]) for name in outputs} for scan in trace.scans] == expected


_SPAN = re.compile(r"([0-9.]+)(ms|s|min)")
_MS = {"ms": 1, "s": 1_000, "min": 60_000}


def milliseconds(word: str) -> int:
    match = _SPAN.fullmatch(word)
    assert match, f"a length of time such as 10ms, not {word!r}"
    return round(float(match[1]) * _MS[match[2]])


def check_time(block: Block, program) -> Trace:
    given = dict(zip(("scan_ms", "until_ms"), map(milliseconds, block.about.split()), strict=False))
    told = timeline("\n".join(block.rows), program.dialect, **given)
    assert not told.diagnostics, told.diagnostics
    return run(program, told.scans(), scan_ms=told.scan_ms)


def check_then(block: Block, trace: Trace) -> None:
    rows = [row.strip() for row in block.rows if row.strip()]
    said = [row.removeprefix("says ") for row in rows if row.startswith("says ")]
    assert [f"{one.code} at {one.span.row}" for one in trace.diagnostics] == said
    courses = [row for row in rows if not row.startswith(("says ", "at most ", "turns "))]
    told = timeline("\n".join(courses), trace.program.dialect, until_ms=trace.starts[-1], scan_ms=1)
    assert not told.diagnostics, told.diagnostics
    for course in told.rows:
        got = [int(repr(value)) for value in trace.values(course.address)]
        wrong = [
            f"{start} ms: {value}, not {course.at(start)}"
            for start, value in zip(trace.starts, got, strict=True)
            if value != course.at(start)
        ]
        assert not wrong, (
            f"{course.address}: {wrong[:6]} … {len(wrong)} scans; changes at {trace.edges(course.address)[:60]}"
        )
    for most, places in (row.removeprefix("at most ").split(" of ") for row in rows if row.startswith("at most ")):
        on = zip(*(trace[place] for place in places.split()), strict=True)
        assert max(values.count("1") for values in on) <= int(most)
    for every, place in (
        row.removeprefix("turns every ").split(": ") for row in rows if row.startswith("turns every ")
    ):
        changes = [ms for ms, _ in trace.edges(place)][1:]
        assert len(changes) > 1
        assert {b - a for a, b in pairwise(changes)} == {milliseconds(every)}


def check_figure(block: Block, _program: object) -> None:
    family, _, words = block.about.partition(" ")
    told = illustration(family, words)
    rows = {name: rest for name, _, rest in (row.partition(" ") for row in block.rows if row.strip())}
    assert set(rows) == {"before", "after"}
    for name, got in (("before", told.before), ("after", told.after)):
        assert [list(cells) for cells in got] == columns(rows[name]), name


def check_ladder(block: Block, program) -> None:
    ladder, found = read_drawing("\n".join(block.rows))
    assert not found
    lowered = read(lower(ladder, program.dialect), program.dialect)
    assert [line.text for line in lowered.lines] == [line.text for line in program.lines]


def check_lint(block: Block, program) -> None:
    wanted = [row.strip() for row in block.rows if row.strip()]
    got = [f"{one.severity} {one.code} at {one.span.row}" for one in lint(program)]
    assert got == [row for row in wanted if row != "nothing"]


def check_same(block: Block, program) -> None:
    other = read("\n".join(block.rows), program.dialect)
    assert not other.diagnostics
    names = [address.text for address in program.addresses("input") + program.addresses("memory")]
    for bits in product((0, 1), repeat=len(names)):
        given = [dict(zip(names, bits, strict=True))]
        ends = [run(one, given).scans[0].steps[-1].after for one in (program, other)]
        assert ends[0] == ends[1], given


def check_says(block: Block, _program: object) -> None:
    family = dialect(block.about)
    main = family.stacks[0]
    facts = {
        "register": f"{main.register.en}, {main.register.zh}" if main.register else "none",
        "cells below it": str(main.depth - 1),
        "cells": str(main.depth),
        "level 1 is": main.level(0).en,
    }
    rows = [row.partition(":") for row in block.rows if row.strip()]
    assert {name.strip(): value.strip() for name, _, value in rows} == {
        name.strip(): facts[name.strip()] for name, _, _ in rows
    }


CHECKS = {
    "stack": check_stack,
    "gives": check_gives,
    "run": check_run,
    "then": check_then,
    "figure": check_figure,
    "ladder": check_ladder,
    "lint": check_lint,
    "same": check_same,
    "says": check_says,
}


@pytest.mark.parametrize("case", cases(), ids=lambda case: f"{case.document}: {case.heading}")
def test_the_book_is_right(case: Case) -> None:
    program, trace, checked = None, None, 0
    for block in case.blocks:
        if block.kind == "stl":
            program = read("\n".join(block.rows), block.about)
            assert not program.diagnostics, program.diagnostics
            assert read(write(program), block.about) == program
        elif block.kind == "time":
            trace = check_time(block, program)
        else:
            CHECKS[block.kind](block, trace if block.kind == "then" else program)
            checked += 1
    assert checked, "nothing in this case is checked"


def test_every_figure_of_the_documents_has_a_case() -> None:
    headings = {(case.document, case.heading) for case in cases()}
    for document, figures in (
        ("000_8c35a2fe1b5d9b9b.md", [f"Figure {number}" for number in range(1, 8)]),
        ("002_0e43569a3a430994.md", ["Figure 2-35 (a)", "Figure 2-35 (b)", "Figure 2-35 (c)"]),
        ("003_8b8dde9772520c5a.md", [f"Figure 4-{number}" for number in (17, 21, 22, 24, 28, 30, 34, 36, 39, 42, 43)]),
    ):
        for figure in figures:
            assert any(name == document and heading.startswith(figure) for name, heading in headings), figure
