"""The lecturer's words that draw: a text in, a picture out that a notebook shows."""

from __future__ import annotations

from bisect import bisect_left
from typing import TYPE_CHECKING, Any

from plcteach.core.errors import PlcTeachError, UnknownNameError
from plcteach.figure.charts import chart_of
from plcteach.figure.face_scene import face_scene
from plcteach.figure.faces import Blocks
from plcteach.figure.film import Film, film
from plcteach.figure.running import program_of, run
from plcteach.figure.strip import strip as strip_scene
from plcteach.figure.svg import Figure
from plcteach.machine.scan import SCAN_MS, Trace
from plcteach.machine.scan import run as run_program

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.core.text import Text


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
    if isinstance(text, Trace) and inputs != 1:
        msg = "a run has its inputs already: draw the run, or give the program and the inputs"
        raise PlcTeachError(msg)
    trace = text if isinstance(text, Trace) else run(text, inputs, dialect, scan_ms=scan_ms)
    names_shown = show.replace(",", " ").split() if isinstance(show, str) else show
    return Figure(chart_of(trace, names_shown, width=width))


def face(trace: Trace, block: str, scan: int = -1) -> Figure:
    """Draw what one function block shows at the end of a scan: `face(trace, "T37")`."""
    if not -len(trace.starts) <= scan < len(trace.starts):
        msg = f"this run has {len(trace.starts)} scans, counted from 0, and none with the number {scan}"
        raise PlcTeachError(msg)
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


def strip(text: str | Program, dialect: str | Dialect | None = None, inputs: Mapping[str, int] | None = None) -> Figure:
    """Draw a whole program in one row: each instruction above the stack that it leaves."""
    program = program_of(text, dialect)
    return Figure(strip_scene(run_program(program, [dict(inputs or {})]).scans[0]))


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
    if not 0 <= at * 1000 <= max(trace.starts[-1:], default=0) or (scans is not None and scans < 1):
        msg = f"this run lasts {trace.starts[-1] / 1000 if trace.starts else 0:g} s; at={at:g} and scans={scans} show nothing of it"
        raise PlcTeachError(msg)
    first = min(bisect_left(trace.starts, round(at * 1000)), len(trace.starts) - 1)
    last = len(trace.starts) if scans is None else first + max(1, scans)
    return film((trace.scans[number] for number in range(first, min(last, len(trace.starts)))), title)
