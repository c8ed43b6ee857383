"""The lecturer's words that need no player and no chart: run, table, illustrate."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, Any

from plcteach.core.diagnostic import refuse
from plcteach.core.errors import PlcTeachError
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import names
from plcteach.figure.stack import illustrate as stack_scene
from plcteach.figure.svg import Figure
from plcteach.ladder.either import read_either
from plcteach.ladder.translation import Translation
from plcteach.machine.rows import Rows
from plcteach.machine.scan import SCAN_MS, Memory, Trace, sweep
from plcteach.machine.scan import run as run_program
from plcteach.machine.timeline import timeline

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect

MOST_TABLE_INPUTS = 6


def program_of(text: str | Program | Translation, dialect: str | Dialect | None = None) -> Program:
    """Read a list, or lower a ladder drawing; PlcTeachError with the first finding where it cannot be read."""
    if isinstance(text, Translation):
        return text.program
    if not isinstance(text, str):
        return text
    program = read_either(text, dialect or getattr(text, "dialect", None) or names()[0])
    refuse(program.diagnostics)
    return program


def run(
    text: str | Program,
    scans: str | Iterable[Mapping[str, Any]] | Mapping[str, Any] | int = 1,
    dialect: str | Dialect | None = None,
    *,
    scan_ms: int = SCAN_MS,
) -> Trace:
    """Run a list (or a drawing, or a Program) over scans of inputs, or over a timeline: "I0.0: 1s off, 0.2s on, off".

    See `plcteach.machine.run` and `plcteach.machine.timeline`; PlcTeachError says what of a timeline cannot be read.
    """
    program = program_of(text, dialect)
    if not isinstance(scans, str):
        return run_program(program, scans, scan_ms=scan_ms)
    line = timeline(scans, program.dialect, scan_ms=scan_ms)
    refuse(line.diagnostics)
    return run_program(program, line.scans(), scan_ms=scan_ms)


def illustrate(word: str, dialect: str | Dialect | None = None) -> Figure:
    """Draw the before/after figure of an instruction or a whole line: `illustrate("OLD")`, `illustrate("LDS 3")`, `illustrate("O M0.0")`."""
    return Figure(stack_scene(find_dialect(dialect or names()[0]), word.strip().upper()))


@dataclass(frozen=True, slots=True)
class TruthTable:
    """One scan for every combination of inputs: `rows` of input values and output values, as strings of 0, 1 and x."""

    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    rows: tuple[tuple[str, str], ...]

    def __repr__(self) -> str:
        head = f"{' '.join(self.inputs)} | {' '.join(self.outputs)}"
        lines = [
            f"{_spread(values, self.inputs)} | {_spread(results, self.outputs)}".rstrip()
            for values, results in self.rows
        ]
        return "\n".join([head, *lines])

    def _repr_html_(self) -> str:
        head = "".join(f"<th>{escape(address)}</th>" for address in (*self.inputs, *self.outputs))
        body = "".join(
            "<tr>"
            + "".join(f"<td>{value}</td>" for value in values)
            + "".join(f"<td><b>{value}</b></td>" for value in results)
            + "</tr>"
            for values, results in self.rows
        )
        return f"<table><tr>{head}</tr>{body}</table>"


def _spread(values: str, names: tuple[str, ...]) -> str:
    return " ".join(value.center(len(name)) for value, name in zip(values, names, strict=True))


def table(text: str | Program, dialect: str | Dialect | None = None) -> TruthTable:
    """Run one scan from power-on for every combination of the inputs (six at most) at once, and give all rows."""
    program = program_of(text, dialect)
    inputs = [address.text for address in program.addresses("input")]
    outputs = [address.text for address in program.addresses("output")]
    if len(inputs) > MOST_TABLE_INPUTS:
        msg = f"a table of {len(inputs)} inputs would have {2 ** len(inputs)} rows; {MOST_TABLE_INPUTS} inputs is the most"
        raise PlcTeachError(msg)
    rows = Rows(len(inputs))
    columns = {name: rows.variable(place) for place, name in enumerate(reversed(inputs))}
    after = sweep(program, Memory(), columns, rows.domain)
    results = [after.bits.get(name, rows.domain.zero) for name in outputs]
    shown = tuple(
        ("".join(columns[name].at(case) for name in inputs), "".join(one.at(case) for one in results))
        for case in range(rows.cases)
    )
    return TruthTable(tuple(inputs), tuple(outputs), shown)
