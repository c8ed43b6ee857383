"""The lecturer's words that draw: a text in, a picture out that a notebook shows."""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, Any

from plcteach.core.diagnostic import errors
from plcteach.core.errors import PlcTeachError, UnknownNameError
from plcteach.core.text import language
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import names
from plcteach.figure.charts import chart_of
from plcteach.figure.face_scene import face_scene
from plcteach.figure.faces import Blocks
from plcteach.figure.film import Film, film
from plcteach.figure.ladder import ladder_scene
from plcteach.figure.stack import illustrate as stack_scene
from plcteach.figure.strip import strip as strip_scene
from plcteach.figure.svg import Figure
from plcteach.ladder import read_drawing, read_either
from plcteach.machine.rows import Rows
from plcteach.machine.scan import SCAN_MS, Memory, Trace, sweep
from plcteach.machine.scan import run as run_program
from plcteach.machine.timeline import timeline

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.core.text import Text

MOST_TABLE_INPUTS = 6


def program_of(text: str | Program, dialect: str | Dialect | None = None) -> Program:
    """Read a list, or lower a ladder drawing; PlcTeachError with the first finding where it cannot be read."""
    if not isinstance(text, str):
        return text
    program = read_either(text, dialect or names()[0])
    _refuse(errors(program.diagnostics))
    return program


def _refuse(found: Sequence[Diagnostic]) -> None:
    """Raise the first finding, if there is one, as an error with its row."""
    if found:
        msg = f"row {found[0].span.row}: {found[0].text.in_(language())}"
        raise PlcTeachError(msg)


def run(
    text: str | Program,
    scans: str | Iterable[Mapping[str, Any]] | int = 1,
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
    _refuse(errors(line.diagnostics))
    return run_program(program, line.scans(), scan_ms=scan_ms)


def chart(
    text: str | Program | Trace,
    inputs: str | Iterable[Mapping[str, Any]] | int = 1,
    dialect: str | Dialect | None = None,
    *,
    show: str | Iterable[str] = (),
    scan_ms: int = SCAN_MS,
    width: float = 720,
) -> Figure:
    """Draw the timing chart of a run, or of a program over a timeline; `show`: the addresses, "I0.0 T37.V Q0.0"."""
    trace = text if isinstance(text, Trace) else run(text, inputs, dialect, scan_ms=scan_ms)
    names_shown = show.replace(",", " ").split() if isinstance(show, str) else show
    return Figure(chart_of(trace, names_shown, width=width))


def face(trace: Trace, block: str, scan: int = -1) -> Figure:
    """Draw what one function block shows at the end of a scan: `face(trace, "T37")`."""
    blocks, last = Blocks(trace.program), trace.scans[scan]
    store = last.start()
    for step, plant in last.walk():
        blocks.look(step)
        store = plant
    name = normal_block(trace.program, block, blocks)
    return Figure(face_scene(blocks.face(store, name)))


def normal_block(program: Program, word: str, blocks: Blocks) -> str:
    """Give the name of a block that the program drives; UnknownNameError names those that there are."""
    place = program.dialect.address(word)
    name = getattr(place, "text", word)
    if name in blocks.found:
        return str(name)
    kind = "block of this program"
    raise UnknownNameError(kind, word, blocks.found)


def illustrate(word: str, dialect: str | Dialect | None = None) -> Figure:
    """Draw the before/after figure of an instruction: `illustrate("OLD")`, `illustrate("LDS 3")`."""
    mnemonic, _, number = word.strip().partition(" ")
    scene = stack_scene(find_dialect(dialect or names()[0]), mnemonic.upper(), int(number) if number.strip() else None)
    return Figure(scene)


def strip(text: str | Program, dialect: str | Dialect | None = None, inputs: Mapping[str, int] | None = None) -> Figure:
    """Draw a whole program in one row: each instruction above the stack that it leaves."""
    program = program_of(text, dialect)
    return Figure(strip_scene(run_program(program, [dict(inputs or {})]).scans[0]))


def draw(drawing: str) -> Figure:
    """Draw a ladder typed as text; PlcTeachError names the row where it cannot be read."""
    ladder, found = read_drawing(drawing)
    _refuse(errors(found))
    return Figure(ladder_scene(ladder))


def film_of(
    text: str | Program | Trace,
    dialect: str | Dialect | None = None,
    inputs: str | Mapping[str, int] | Iterable[Mapping[str, int]] | None = None,
    *,
    at: float = 0,
    scans: int | None = None,
    title: Text | None = None,
) -> Film:
    """Make the film of one scan, or of several if `inputs` is a list with one mapping a scan, or a timeline.

    at: begin with the first scan from so many seconds on.  scans: how many of them to show.
    """
    if isinstance(text, Trace):
        trace = text
    elif isinstance(inputs, str):
        trace = run(text, inputs, dialect)
    else:
        rows = [dict(inputs)] if hasattr(inputs, "keys") else [dict(row) for row in inputs or [{}]]  # type: ignore[arg-type]
        trace = run_program(program_of(text, dialect), rows)
    first = min(bisect_left(trace.starts, round(at * 1000)), len(trace.starts) - 1)
    last = len(trace.starts) if scans is None else first + max(1, scans)
    return film((trace.scans[number] for number in range(first, min(last, len(trace.starts)))), title)


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
