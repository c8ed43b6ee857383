"""The lecturer's words that put something live into a notebook: play, bench, desk."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import families as all_families
from plcteach.dialects import names
from plcteach.figure.driving import on_plant
from plcteach.figure.running import program_of
from plcteach.figure.verbs import film_of
from plcteach.machine.scan import SCAN_MS
from plcteach.widgets.bench import Workbench
from plcteach.widgets.desk import ExerciseDesk
from plcteach.widgets.families import FamilyPlayer
from plcteach.widgets.live import LiveBench
from plcteach.widgets.player import StackPlayer

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from pathlib import Path

    from plcteach.core.exercise import Exercise
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.machine.scan import Trace
    from plcteach.plants import Plant


def play(
    text: str | Program | Trace,
    dialect: str | Dialect | None = None,
    inputs: str | Mapping[str, int] | Iterable[Mapping[str, int]] | None = None,
    *,
    at: float = 0,
    scans: int | None = None,
    index: int = 0,
    size: float = 1.0,
) -> StackPlayer:
    """Play a list or a ladder drawing: one scan with these inputs, one for each mapping in a list, or a timeline.

    at, scans: of a long run, begin so many seconds in and show so many scans.
    """
    return StackPlayer(film_of(text, dialect, inputs, at=at, scans=scans), index=index, size=size)


def families(
    ladder: str | Program,
    inputs: Mapping[str, int] | None = None,
    dialect: str | Dialect | None = None,
    *others: str | Dialect,
    index: int = 0,
    size: float = 1.0,
) -> FamilyPlayer:
    """Play one ladder (or list) in several families at once: a list and a stack each, all stepping together.

    dialect: the family whose addresses it uses.  others: the families beside it, all four where none is named.
    """
    from plcteach.figure.families import together  # noqa: PLC0415 (translation is not needed to play one list)

    beside = [find_dialect(one) for one in others] or all_families()
    return FamilyPlayer(together(ladder, dialect, beside, inputs), index=index, size=size)


def live(
    text: str | Program | None = None,
    dialect: str | Dialect | None = None,
    *,
    plant: str | Plant | None = None,
    timeline: str | None = None,
    scan_ms: int = SCAN_MS,
    size: float = 1.0,
) -> LiveBench:
    """Open a live bench: the program runs in virtual time, with buttons to press and lamps to watch.

    plant: what it drives, by its id ("eight-lamps"), or one of a teacher's own; without a text its own program runs. The roles
    "book" and "wrong" for a text run the programs of the plant that fail on it, "wrong 2" the second of them.
    timeline: a recording to be replayed, until somebody takes over.
    """
    if plant is None:
        return LiveBench(program_of(text or "", dialect), scan_ms=scan_ms, tape=timeline, size=size)
    program, model = on_plant(text, plant, dialect)
    return LiveBench(program, model, scan_ms=scan_ms, tape=timeline, size=size)


def bench(
    text: str = "", dialect: str | Dialect | None = None, inputs: dict[str, int] | None = None, *, size: float = 1.0
) -> Workbench:
    """Open a workbench: editor, switches, player and lamps."""
    return Workbench(text.strip("\n"), dialect or names()[0], inputs, size=size)


def desk(exercise: str | Path | Exercise, text: str | None = None, *, size: float = 1.0) -> ExerciseDesk:
    """Open an exercise: by its id, or a teacher's own by its file (`plc.desk("my.toml")`)."""
    return ExerciseDesk(exercise, text, size=size)
