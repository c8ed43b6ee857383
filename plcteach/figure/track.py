"""One row of a timing chart: a bit as a line that is low or high, a word as stairs with its numbers."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from plcteach.core.text import same
from plcteach.figure.scene import Box, Stroke, Words, extent

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from plcteach.figure.scene import Point, Shape

_BIT_HIGH, _WORD_HIGH, _NUMBER_ROOM = 22.0, 36.0, 14.0
_FINE = 2.0
_WASH_FROM, _X_FROM, _HATCH = 3.0, 14.0, 6.0

_BUSY, _MANY = 2, 4
"""The value of a stretch in which a bit changes too fast to be drawn, and how many changes make one."""

Stretch = tuple[float, float, "int | None"]
"""From x to x, and the value there."""


@dataclass(frozen=True, slots=True)
class Track:
    """A value in time: (ms, value) pairs in order of time, None for a value that nobody knows.

    Before its first pair nobody knows the value either.
    """

    label: str
    changes: tuple[tuple[int, int | None], ...]
    word: bool = False
    unit: str = ""

    def __repr__(self) -> str:
        return f"Track({self.label!r}, {len(self.changes)} changes)"

    @property
    def reach(self) -> tuple[int, int]:
        """The values at the bottom and at the top of its row: 0 at the bottom where no value is below it."""
        if not self.word:
            return 0, 1
        known = [value for _, value in self.changes if value is not None]
        low = min(0, *known) if known else 0
        return low, max(low + 1, *known) if known else 1


@dataclass(frozen=True, slots=True)
class Row:
    """Where a track's values lie on the paper: two values, and their heights."""

    low: int
    high: int
    bottom: float
    top: float

    def y(self, value: int) -> float:
        """Give the height of a value."""
        share = (value - self.low) / (self.high - self.low)
        return self.bottom - (self.bottom - self.top) * min(1.0, max(0.0, share))

    @property
    def middle(self) -> float:
        """The height of its middle."""
        return (self.bottom + self.top) / 2

    @property
    def scale(self) -> tuple[tuple[str, float], tuple[str, float]]:
        """The numbers at the top and at the bottom, with their heights."""
        return (str(self.high), self.top), (str(self.low), self.bottom)


def row_of(track: Track, y: float) -> Row:
    """Give the row of a track that begins at the height `y`."""
    bottom = y + track_height(track)
    return Row(*track.reach, bottom, bottom - (_WORD_HIGH if track.word else _BIT_HIGH))


@dataclass(frozen=True, slots=True)
class Plot:
    """Where time lies on the paper."""

    left: float
    width: float
    until: int

    def x(self, moment: float) -> float:
        """Give where a moment stands."""
        return self.left + self.width * min(1.0, max(0.0, moment / self.until))


def track_height(track: Track) -> float:
    """Give the height of a row, the room for numbers included."""
    return _WORD_HIGH + _NUMBER_ROOM if track.word else _BIT_HIGH


def edges(track: Track, until: int) -> list[int]:
    """Give the moments at which a bit changes between 0 and 1."""
    pairs = pairwise(track.changes)
    return [
        moment for (_, old), (moment, new) in pairs if moment <= until and old is not None is not new and old != new
    ]


def track_ground(track: Track, plot: Plot, row: Row) -> Iterator[Shape]:
    """Draw what lies under the grid: washes under a bit that is on, grey where it is too fast to be drawn."""
    if not track.word:
        high = row.bottom - row.top
        for first, last, value in _calmed(_stretches(track, plot)):
            if value == _BUSY or (value == 1 and last - first >= _WASH_FROM):
                yield Box(first, row.top, last - first, high, "wash" if value == 1 else "busy")


def track_shapes(track: Track, plot: Plot, row: Row) -> Iterator[Shape]:
    """Draw a track: bands where nobody knows, one line for the rest, numbers on words."""
    stretches = _stretches(track, plot) if track.word else _calmed(_stretches(track, plot))
    for first, last, _ in _unknown(stretches):
        yield Box(first, row.top, last - first, row.bottom - row.top, "head")
        yield _hatching(first, last, row.top, row.bottom)
        if last - first >= _X_FROM:
            yield Words((first + last) / 2, row.middle, same("x"), "lost", size=12, code=True)
    for run in _known(stretches, track):
        yield Stroke(_thinned(_line(run, row)), "wire")
    if track.word:
        yield from _numbers(stretches, row)


def _stretches(track: Track, plot: Plot) -> list[Stretch]:
    """Give the stretches of equal value between the chart's two ends, in px."""
    found: list[Stretch] = []
    shown = [(max(0, moment), value) for moment, value in track.changes if moment < plot.until]
    if not shown or shown[0][0] > 0:
        shown.insert(0, (0, None))
    ends = [moment for moment, _ in shown[1:]] + [plot.until]
    for (moment, value), end in zip(shown, ends, strict=True):
        if end <= moment:
            continue
        if found and found[-1][2] == value:
            found[-1] = (found[-1][0], plot.x(end), value)
        else:
            found.append((plot.x(moment), plot.x(end), value))
    return found


def _calmed(stretches: Sequence[Stretch]) -> list[Stretch]:
    """Join the changes of a bit that are too fast to be told apart into one busy stretch."""
    found: list[Stretch] = []
    fast: list[Stretch] = []
    for one in (*stretches, None):
        if one and one[2] is not None and one[1] - one[0] < _FINE:
            fast.append(one)
            continue
        found += [(fast[0][0], fast[-1][1], _BUSY)] if len(fast) >= _MANY else fast
        fast = []
        found += [one] if one else []
    return found


def _unknown(stretches: Sequence[Stretch]) -> list[Stretch]:
    """Join unknown stretches that are less than a few pixels apart."""
    found: list[Stretch] = []
    for first, last, value in stretches:
        if value is not None:
            continue
        if found and first - found[-1][1] < _WASH_FROM:
            found[-1] = (found[-1][0], last, None)
        else:
            found.append((first, max(last, first + 1), None))
    return found


def _known(stretches: Sequence[Stretch], track: Track) -> list[list[tuple[float, float, int]]]:
    """Split at the unknown and the busy; a gap that is too narrow to be seen does not split."""
    runs: list[list[tuple[float, float, int]]] = []
    end = -1e9
    for first, last, value in stretches:
        if value is None or (value == _BUSY and not track.word):
            continue
        if first - end >= 1 or not runs:
            runs.append([])
        runs[-1].append((first, last, value))
        end = last
    return runs


def _line(run: Sequence[tuple[float, float, int]], row: Row) -> Iterator[Point]:
    """Go along the values: a step where it is wide enough to be one, else straight from point to point."""
    before_fine = False
    for first, last, value in run:
        y, fine = row.y(value), last - first < _FINE
        if not (fine and before_fine):
            yield first, y
        if fine:
            yield (first + last) / 2, y
        else:
            yield last, y
        before_fine = fine


def _thinned(points: Iterator[Point]) -> tuple[Point, ...]:
    """Keep of all points in one pixel the first, the lowest, the highest and the last, in their order; drop what is on line."""
    columns: dict[int, list[Point]] = {}
    for point in points:
        columns.setdefault(int(point[0]), []).append(point)
    kept: list[Point] = []
    for column in columns.values():
        wanted = {0, len(column) - 1}
        wanted |= {
            min(range(len(column)), key=lambda at: column[at][1]),
            max(range(len(column)), key=lambda at: column[at][1]),
        }
        for at in sorted(wanted):
            if len(kept) > 1 and _in_line(kept[-2], kept[-1], column[at]):
                kept.pop()
            kept.append(column[at])
    return tuple(kept)


def _in_line(one: Point, two: Point, three: Point) -> bool:
    """Tell whether the middle one of three points lies between the others, to a twentieth of a pixel."""
    (ax, ay), (bx, by), (cx, cy) = one, two, three
    if not (min(ax, cx) - 0.01 <= bx <= max(ax, cx) + 0.01 and min(ay, cy) - 0.01 <= by <= max(ay, cy) + 0.01):
        return False
    return abs((cx - ax) * (by - ay) - (cy - ay) * (bx - ax)) <= 0.05 * max(abs(cx - ax), abs(cy - ay), 1)


def _hatching(first: float, last: float, top: float, bottom: float) -> Stroke:
    count = max(2, round((last - first) / _HATCH))
    return Stroke(
        tuple((first + (last - first) * at / count, bottom if at % 2 else top) for at in range(count + 1)), "faint"
    )


def _numbers(stretches: Sequence[Stretch], row: Row) -> Iterator[Shape]:
    """Write a value over its step where there is room for it."""
    for first, last, value in stretches:
        words = "" if value is None else str(value)
        if value is not None and extent(words, 10.5, code=True) + 6 <= last - first:
            yield Words((first + last) / 2, row.y(value) - 7, same(words), "quiet", size=10.5, code=True)
