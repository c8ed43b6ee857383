"""A recording: what a run's inputs did and what its outputs were, to be run again, and where another run differs from it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from plcteach.core.text import Text
from plcteach.machine.timeline import Course, Phase, Timeline

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Iterator

    from plcteach.machine.trace import Trace

_DIFFERS = Text(
    "{time}（第{number}次扫描）：记录里{address}={expected}，这次是{got}。",
    "{time} (scan {number}): {address} was {expected} in the recording and is {got} now.",
)


@dataclass(frozen=True, slots=True)
class Difference:
    """The first scan (counted from 0) in which an address is not what was recorded."""

    address: str
    scan: int
    ms: int
    expected: str
    got: str

    def __repr__(self) -> str:
        return f"Difference({self.address}={self.got}, not {self.expected}, in scan {self.scan} at {self.ms} ms)"

    @property
    def text(self) -> Text:
        """The same in words."""
        time = f"{self.ms / 1000:.2f} s"
        return _DIFFERS.format(
            time=time, number=str(self.scan + 1), address=self.address, expected=self.expected, got=self.got
        )


Edges = list[tuple[int, Any]]


def course(address: str, edges: Edges, stop_ms: int) -> Course | None:
    """Give what an address did, by the moments at which it changed; None where nobody knew its value."""
    values = [repr(value) for _, value in edges]
    if not edges or not all(_is_number(value) for value in values):
        return None
    first = [] if edges[0][0] == 0 else [Phase(0, 0)]
    return Course(
        address, (*first, *(Phase(ms, int(value)) for (ms, _), value in zip(edges, values, strict=True))), stop_ms
    )


def _is_number(value: str) -> bool:
    return value.removeprefix("-").isdigit()


def joined(past: Edges, later: Edges) -> Edges:
    """Give the changes of two stretches of a run that may overlap: the first is complete up to its last change."""
    both = [*past, *(one for one in later if not past or one[0] > past[-1][0])]
    return [*both[:1], *(now for last, now in pairwise(both) if now[1] != last[1])]


def recorded(
    trace: Trace, past: dict[str, Edges] | None = None, hands: tuple[Course, ...] = (), always: Collection[str] = ()
) -> Timeline:
    """Give a run as a timeline: its inputs that were ever on, and all outputs.

    past: what is not kept in the trace any more.  always: inputs that are told even if they were never on.
    """
    until = trace.starts[-1] if trace.starts else 0
    stop = until + trace.scan_ms

    def courses(role: str) -> Iterator[Course]:
        for place in trace.program.addresses(role):
            found = course(place.text, joined((past or {}).get(place.text, []), trace.edges(place.text)), stop)
            if found:
                yield found

    rows = tuple(one for one in courses("input") if one.address in always or any(phase.value for phase in one.phases))
    return Timeline(rows, until, trace.scan_ms, seen=tuple(courses("output")), hands=hands)


def to_its_end(line: Timeline) -> Timeline:
    """Let a timeline end where all its rows end, if all of them say where that is: so a recording runs as long as it ran."""
    rows = (*line.rows, *line.seen, *line.hands)
    if not rows or any(one.tells(one.stop_ms) for one in rows):
        return line
    return replace(line, until_ms=max(0, max(one.stop_ms for one in rows) - line.scan_ms))


def differences(line: Timeline, trace: Trace, within_ms: int = 0) -> tuple[Difference, ...]:
    """Give for each address that was recorded the first scan in which a run differs, the earliest first.

    within_ms: so much earlier or later a change may come.
    """
    firsts = (next(_differs(one, trace, within_ms), None) for one in line.seen)
    return tuple(sorted((one for one in firsts if one), key=lambda one: (one.scan, one.address)))


def _differs(seen: Course, trace: Trace, within_ms: int) -> Iterator[Difference]:
    edges = trace.edges(seen.address)
    at, got = 0, "0"
    for scan, ms in enumerate(trace.starts):
        if not seen.tells(ms):
            return
        while at < len(edges) and edges[at][0] <= ms:
            got, at = repr(edges[at][1]), at + 1
        expected = str(seen.at(ms))
        if got != expected and got not in _about(seen, ms, within_ms):
            yield Difference(seen.address, scan, ms, expected, got)


def _about(seen: Course, ms: int, within_ms: int) -> Iterable[str]:
    """Give the values that were recorded about a moment."""
    around = (phase.value for phase in seen.phases if ms - within_ms < phase.start_ms <= ms + within_ms)
    return {str(seen.at(max(0, ms - within_ms))), *map(str, around)} if within_ms else ()
