"""A program on its plant with nobody watching: the buttons are pressed as the plant's cycle says, and what went wrong is told."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

from plcteach.core.diagnostic import refuse
from plcteach.core.errors import PlcTeachError
from plcteach.core.text import Text, language
from plcteach.figure.running import program_of
from plcteach.machine.live import Live
from plcteach.machine.recording import to_its_end
from plcteach.machine.scan import SCAN_MS
from plcteach.machine.timeline import Timeline, timeline
from plcteach.plants import Model
from plcteach.plants import plant as find_plant
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.machine.trace import Trace
    from plcteach.plants import Fault, Plant, Sample
    from plcteach.plants.declared import Seen

_HEAD = Text("{title}：运行了{time}。", "{title}: it ran for {time}.")
_WELL = Text("设备没有出错。", "Nothing went wrong at the plant.")
_FAULT = Text("{time}：{says}", "{time}: {says}")
_MISSED = Text("{time}：这时应当 {what}，实际不是。", "{time}: {what} should hold here, and does not.")


@dataclass(frozen=True, slots=True)
class Drive:
    """What came of it; true if nothing went wrong.

    faults: what went wrong at the plant, each with its moment.  missed: what the plant's cycle wants to see and did not.
    trace: the run, to be charted: `plc.chart(drive.trace)`.
    """

    plant: Plant
    trace: Trace
    faults: tuple[Fault, ...]
    missed: tuple[Seen, ...] = ()

    def __bool__(self) -> bool:
        return not self.faults and not self.missed

    @property
    def says(self) -> tuple[Text, ...]:
        """What there is to say, in the order in which it happened."""
        late = [(one.ms, _MISSED.format(time=_time(one.ms), what=one.what.text)) for one in self.missed]
        found = [*((one.ms, _FAULT.format(time=_time(one.ms), says=one.says)) for one in self.faults), *late]
        return tuple(one for _, one in sorted(found, key=lambda pair: pair[0])) or (_WELL,)

    @property
    def moments(self) -> tuple[tuple[int, str, int], ...]:
        """When each button, switch and drive changed: ms, its symbol, and what the program saw or set (0 or 1)."""
        known = {one.text for role in ("input", "output") for one in self.trace.program.addresses(role)}
        found = [
            (ms, one.symbol, int(repr(value) == "1"))
            for one in self.plant.devices
            if one.address in known
            for ms, value in self.trace.edges(one.address)
            if ms or repr(value) == "1"
        ]
        return tuple(sorted(found))

    def __repr__(self) -> str:
        lang = language()
        return "\n".join(one.in_(lang) for one in (self._head, *self.says))

    def _repr_html_(self) -> str:
        head, *rest = (escape(one.in_(language())) for one in (self._head, *self.says))
        return f"<p><b>{head}</b></p><ul>{''.join(f'<li>{one}</li>' for one in rest)}</ul>"

    @property
    def _head(self) -> Text:
        ran = self.trace.starts[-1] + self.trace.scan_ms if self.trace.starts else 0
        return _HEAD.format(title=self.plant.title, time=_time(ran))


def _time(ms: int) -> str:
    return f"{ms / 1000:.2f} s"


def drive(
    plant: str | Plant,
    text: str | Program | None = None,
    dialect: str | Dialect | None = None,
    *,
    hands: str | None = None,
    seconds: float | None = None,
    scan_ms: int = SCAN_MS,
) -> Drive:
    """Let a program run a plant by itself, and say what went wrong: `plc.drive("drilling-head", my_program)`.

    text: as for `live`; without one the plant's own program runs.  hands: who presses what and when, a timeline such as
    "@SB1: 1s off, 0.2s on, off" or a recording of a live bench; without one the plant's cycle.  seconds: how long.
    """
    program, model = on_plant(text, plant, dialect)
    line = to_its_end(timeline(hands or "", program.dialect, scan_ms=scan_ms))
    refuse(line.diagnostics)
    until = line.until_ms + scan_ms if hands is not None else model.plant.cycle.ms
    until = until if seconds is None else round(seconds * 1000)
    if until <= 0 or until // max(1, scan_ms) > _MOST_SCANS:
        msg = f"a plant runs for more than 0 s and at most {_MOST_SCANS} scans, not for {until / 1000:g} s"
        raise PlcTeachError(msg)
    live = Live(program, model, scan_ms=scan_ms, kept_ms=until)
    missed = tuple(_run(live, model, until, line if hands is not None else None))
    return Drive(model.plant, live.trace(), model.faults, missed)


_MOST_SCANS = 100_000


def _run(live: Live, model: Model, until: int, line: Timeline | None) -> Iterator[Seen]:
    """Scan after scan, pressing what is to be pressed; give what should have been seen by then and was not."""
    cycle = model.plant.cycle
    acts = list(cycle.all_acts()) if line is None else []
    wanted = list(cycle.all_seen()) if line is None else []
    while live.next_ms < until:
        now = live.next_ms
        while acts and acts[0].ms <= now:
            act = acts.pop(0)
            model.press(act.symbol, act.down)
        if line:
            model.follow(line.by_hand(now))
        while wanted and wanted[0].ms <= now:
            one = wanted.pop(0)
            if not model.holds(one.what):
                yield one
        live.scan(watched=False)


def on_plant(
    text: str | Program | None, plant: str | Plant, dialect: str | Dialect | None = None
) -> tuple[Program, Model]:
    """Give a program and the plant that it drives, connected as the program wants it; see `live` for what the text may be."""
    there = find_plant(plant)
    sample = there.reference if text is None else sample_of(there, text) if isinstance(text, str) else None
    if sample:
        return read(sample.text, sample.family), Model(there.for_(sample))
    return program_of(text or "", dialect or there.family), Model(there)


def sample_of(plant: Plant, words: str) -> Sample | None:
    """Give the program of a plant that is named by its role and, where there are several, its number; None for other words."""
    role, _, number = words.strip().partition(" ")
    mine = [one for one in plant.samples if one.role == role]
    at = int(number) - 1 if number.isdigit() else 0
    return mine[at] if mine and at < len(mine) and not (number and not number.isdigit()) else None
