"""What the inputs do over time, in a little language that can be typed: `I0.0: 1s off, 0.2s on, off`.

A row is an address, a colon and phases: a length and a state, or a repetition `3 x (0.5s on, 0.5s off)`. Only the last phase
may go without a length; it lasts to the end. A state is kept until the next one, and an input that no row names stays 0. The
run ends 1 s after the last change, and never before a phase with a length is over.

A recording also says what was seen, `= Q0.0: 1s off, on`, so that another run can be held against it, and what a hand did at a
plant where no input sees it, `@W: 3s off, on`.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from plcteach.core.diagnostic import Diagnostic, few, rule
from plcteach.core.source import Span
from plcteach.core.text import Text
from plcteach.dialects import dialect as find_dialect
from plcteach.machine.phases import HAND, read_rows

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from plcteach.core.spec import Dialect
    from plcteach.machine.phases import Row

SCAN_MS = 10
AFTER_MS = 1_000
"""How long a run goes on after the last change."""

MOST_SCANS = 1_000_000


@dataclass(frozen=True, slots=True)
class Phase:
    """From when on an input has a state."""

    start_ms: int
    value: int


@dataclass(frozen=True, slots=True)
class Course:
    """What one address does: its phases in order, the first at 0 ms, and where its last stated length ends."""

    address: str
    phases: tuple[Phase, ...]
    stop_ms: int

    def __repr__(self) -> str:
        return f"Course({self.address}, {len(self.phases)} phases)"

    def at(self, ms: int) -> int:
        """Give its state at a moment."""
        return self.phases[bisect_right(self.phases, ms, key=lambda phase: phase.start_ms) - 1].value

    def tells(self, ms: int) -> bool:
        """Say whether it says anything of a moment: not after its last phase, if that has a length."""
        return ms < self.stop_ms or self.stop_ms == self.phases[-1].start_ms

    def written(self) -> str:
        """Write it as the row of a timeline."""
        phases = [*self.phases]
        return row_text(self.address, phases, self.stop_ms if self.stop_ms > phases[-1].start_ms else None)


@dataclass(frozen=True, slots=True)
class Timeline:
    """The courses of all inputs, until when they are run, how long a scan lasts, and everything that was found.

    seen: what addresses held when it was recorded.  hands: buttons of a plant that no input sees, "@" before their symbols.
    """

    rows: tuple[Course, ...]
    until_ms: int
    scan_ms: int = SCAN_MS
    diagnostics: tuple[Diagnostic, ...] = ()
    seen: tuple[Course, ...] = ()
    hands: tuple[Course, ...] = ()

    def __repr__(self) -> str:
        return f"Timeline({', '.join(row.address for row in self.rows)}; {self.until_ms} ms)"

    def at(self, ms: int) -> dict[str, int]:
        """Give the state of every input at a moment."""
        return {row.address: row.at(ms) for row in self.rows}

    def by_hand(self, ms: int) -> dict[str, int]:
        """Give the state of every input and of every button that no input sees at a moment."""
        return {row.address: row.at(ms) for row in (*self.rows, *self.hands)}

    @property
    def text(self) -> str:
        """The same as a text that reads as this timeline."""
        rows = [one.written() for one in (*self.rows, *self.hands)]
        return "\n".join([*rows, *(f"= {one.written()}" for one in self.seen)])

    def scans(self) -> Iterator[dict[str, int]]:
        """Give for each scan the inputs that have changed (all start from 0), as `run` wants them.

        Scans start at 0, scan_ms, 2 · scan_ms … up to the end itself, and each sees what has happened up to its start.
        """
        left = [iter(row.phases) for row in self.rows]
        following = [next(phases, None) for phases in left]
        last = [0] * len(self.rows)
        for now in range(0, self.until_ms + 1, self.scan_ms):
            changed: dict[str, int] = {}
            for number, row in enumerate(self.rows):
                value, phase = last[number], following[number]
                while phase and phase.start_ms <= now:
                    value, phase = phase.value, next(left[number], None)
                following[number] = phase
                if value != last[number]:
                    changed[row.address] = last[number] = value
            yield changed


def timeline(text: str, dialect: str | Dialect, *, scan_ms: int = SCAN_MS, until_ms: int | None = None) -> Timeline:
    """Read a timeline; what could not be read stands in `Timeline.diagnostics`, each finding with its place.

    UnknownNameError if there is no such family; ValueError if a scan takes no time.
    """
    if scan_ms < 1:
        msg = f"A scan takes at least 1 ms, not {scan_ms}."
        raise ValueError(msg)
    rows, found = read_rows(text, find_dialect(dialect))
    courses = [_course(row) for row in rows]
    changes = [change for course in courses if (change := _last_change(course)) is not None]
    stop = max([AFTER_MS + max(changes, default=0), *(course.stop_ms for course in courses)])
    until = max(0, stop if until_ms is None else until_ms)
    if until // scan_ms >= MOST_SCANS:
        longest = max(zip(courses, rows, strict=True), key=lambda pair: pair[0].stop_ms, default=None)
        place = longest[1].span if longest else Span(1)
        found.append(rule("TIM007").at(place, size=_scans(until // scan_ms + 1), most=_scans(MOST_SCANS)))
        until = (MOST_SCANS - 1) * scan_ms
    found += [one for row in rows if not row.mark for one in _unseen(row, scan_ms, until)]
    marked = {
        mark: tuple(one for one, row in zip(courses, rows, strict=True) if row.mark == mark) for mark in ("", "=", HAND)
    }
    said = tuple(few(sorted(found, key=lambda one: one.span)))
    return Timeline(marked[""], until, scan_ms, said, seen=marked["="], hands=marked[HAND])


def _scans(count: int) -> Text:
    return Text(f"{count}次扫描", f"{count} scans")


def _course(row: Row) -> Course:
    phases, now = [], 0
    for piece in row.pieces:
        phases.append(Phase(now, piece.value))
        now += piece.length or 0
    return Course(row.address.text, tuple(phases), now)


def _last_change(course: Course) -> int | None:
    """Give when an input changes for the last time, counted from 0 before the run; None if it never does."""
    values = [0, *(phase.value for phase in course.phases)]
    changes = (phase.start_ms for phase, last in zip(course.phases, values, strict=False) if phase.value != last)
    return max(changes, default=None)


def _unseen(row: Row, scan_ms: int, until_ms: int) -> Iterator[Diagnostic]:
    """Find the first phase of a row that is over before a scan starts."""
    now, last = 0, 0
    for piece in row.pieces:
        stop = now + (piece.length or until_ms)
        if piece.value != last and -(-now // scan_ms) * scan_ms >= stop and stop <= until_ms:
            yield rule("TIM009").at(piece.span, address=row.address.text, word=piece.word, scan=scan_ms)
            return
        now, last = stop, piece.value


def write_timeline(scans: Iterable[Mapping[str, int]], scan_ms: int = SCAN_MS) -> str:
    """Give the canonical text of recorded scans: a row for each input that ever changes, repetitions folded.

    "ms" in a mapping is that scan's length. Where the recording goes on for more than 1 s after the last change, the
    last phase says for how long.
    """
    now = 0
    courses: dict[str, list[Phase]] = {}
    for number, scan in enumerate(scans):
        now += int(scan.get("ms", scan_ms)) if number else 0
        for address, value in scan.items():
            if address != "ms":
                course = courses.setdefault(address, [Phase(0, 0)])
                if course[-1].start_ms == now:
                    course[-1] = Phase(now, value)
                elif course[-1].value != value:
                    course.append(Phase(now, value))
    courses = {address: course for address, course in courses.items() if any(phase.value for phase in course)}
    last = max((course[-1].start_ms for course in courses.values()), default=0)
    names = sorted(courses, key=_in_order)
    long = next((name for name in names if courses[name][-1].start_ms == last and now > last + AFTER_MS), "")
    return "".join(f"{row_text(name, courses[name], now if name == long else None)}\n" for name in names)


def _in_order(address: str) -> list[str | int]:
    return [int(part) if part.isascii() and part.isdigit() else part for part in re.split(r"([0-9]+)", address)]


def row_text(address: str, course: list[Phase], until_ms: int | None) -> str:
    """Write one row; the last phase says how long it lasts where the row ends at a stated moment."""
    binary = all(phase.value in {0, 1} for phase in course)
    states = [("off", "on")[phase.value] if binary else str(phase.value) for phase in course]
    lengths = [after.start_ms - phase.start_ms for phase, after in pairwise(course)]
    phases = [f"{_length(length)} {state}" for length, state in zip(lengths, states, strict=False)]
    last = states[-1] if until_ms is None else f"{_length(until_ms - course[-1].start_ms)} {states[-1]}"
    return f"{address}: {', '.join([*_folded(phases), last])}"


def _length(ms: int) -> str:
    for size, unit in ((60_000, "min"), (1_000, "s")):
        if ms and ms % size == 0:
            return f"{ms // size}{unit}"
    return f"{ms / 1_000:.1f}s" if ms % 100 == 0 else f"{ms}ms"


_WORTH_FOLDING = 3


def _folded(phases: list[str]) -> Iterator[str]:
    """Write two phases that alternate at least three times as a repetition."""
    at = 0
    while at < len(phases):
        pair = phases[at : at + 2]
        count = 1
        while phases[at + 2 * count : at + 2 * count + 2] == pair:
            count += 1
        if len(pair) > 1 and count >= _WORTH_FOLDING:
            yield f"{count} x ({', '.join(pair)})"
            at += 2 * count
        else:
            yield phases[at]
            at += 1
