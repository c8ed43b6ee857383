"""Timing charts as in figures 4-19 to 4-21 of 003_8b8dde9772520c5a.txt: bits as lines, words as stairs, over one time axis.

A chart knows values in time and nothing of who made them. However often a value changes, a track is one line: what falls
into one pixel is drawn once.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from plcteach.core.text import NOTHING, Text, same
from plcteach.figure.scale import round_step
from plcteach.figure.scene import Scene, Stroke, Words, extent, extent_of
from plcteach.figure.track import Plot, Track, edges, row_of, track_ground, track_height, track_shapes

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from plcteach.figure.scene import Shape
    from plcteach.figure.track import Row

__all__ = ["Track", "chart_scene"]

Marks = tuple[tuple[int, Text], ...]

_MARGIN = 14
_TITLE, _MARK_ROW, _APART = 15, 17, 15
_TICKS_APART, _SCANS_APART, _EDGES_MOST = 52.0, 6.0, 40
_LABEL_SHARE = 0.36
_MARK_ROWS = 3
_UNITS = ((2_000, 1, "ms"), (180_000, 1_000, "s"), (7_200_000, 60_000, "min"))
_HOURS = (3_600_000, "h")
TIME = Text("时间", "time")
SCANS = Text("短线：扫描", "ticks: scans")


@dataclass(frozen=True, slots=True)
class Flag:
    """A marked moment: where its line stands, and where its words begin, how wide they are and in which row."""

    x: float
    start: float
    room: float
    row: int
    words: Text

    @property
    def end(self) -> float:
        """Where the words end."""
        return self.start + self.room


def chart_scene(
    tracks: Sequence[Track],
    until_ms: int,
    *,
    title: Text,
    scans: tuple[int, ...] = (),
    width: float = 720,
    marks: Marks = (),
    guides: bool = False,
) -> Scene:
    """Draw tracks below each other from 0 to `until_ms`.

    scans: when each scan began; marked on the axis if they stand far enough apart to be seen.
    marks: moments with a word, as lines through all tracks.  guides: a dashed line at each edge of a bit.
    """
    left = _gutter(tracks, width)
    plot = Plot(left, width - left - _MARGIN - 4, max(1, until_ms))
    head = _MARGIN + (22 if title.zh or title.en else 0)
    rows, told = _mark_rows(marks, plot)
    top = head + _MARK_ROW * rows + 6
    places = _places(tracks, top)
    bottom = (places[-1] + track_height(tracks[-1]) if tracks else top) + 8
    drawn = [(track, row_of(track, y)) for track, y in zip(tracks, places, strict=True)]
    shapes: list[Shape] = [*_title(title, width)]
    shapes += [shape for track, row in drawn for shape in track_ground(track, plot, row)]
    shapes += _grid(plot, top - 4, bottom)
    if guides:
        shapes += _guides(tracks, plot, top, bottom)
    for track, row in drawn:
        shapes += _label(track, left, row)
        shapes += track_shapes(track, plot, row)
    shapes += _marks(told, plot, head, bottom)
    shapes += _axis(plot, bottom, scans)
    return Scene(round(width), round(bottom + 42), tuple(shapes), _words(tracks, title))


def _places(tracks: Sequence[Track], top: float) -> list[float]:
    places, y = [], top
    for track in tracks:
        places.append(y)
        y += track_height(track) + _APART
    return places


def _gutter(tracks: Sequence[Track], width: float) -> float:
    """Give the room for the names of the tracks, but never more than a good third of the picture."""
    names = [max(extent(track.label, 13, code=True), extent(track.unit, 11)) for track in tracks]
    scales = [extent(word, 10, code=True) for track in tracks for word in map(str, track.reach)]
    return _MARGIN + min(max(names, default=0), width * _LABEL_SHARE) + max(scales, default=0) + 14


def _title(title: Text, width: float) -> Iterator[Shape]:
    if title.zh or title.en:
        yield Words(_MARGIN, _MARGIN + 6, _cut(title, width - 2 * _MARGIN, _TITLE), "text", "start", _TITLE, bold=True)


def _cut(text: Text, room: float, size: float) -> Text:
    return Text(_cut_words(text.zh, room, size), _cut_words(text.en, room, size))


_SLACK = 0.01
"""Widths are sums, and sums of fractions are a little off."""


def _cut_words(words: str, room: float, size: float, *, code: bool = False) -> str:
    if extent(words, size, code=code) <= room + _SLACK:
        return words
    while words and extent(words + "…", size, code=code) > room:
        words = words[:-1]
    return words.rstrip() + "…"


def _label(track: Track, left: float, row: Row) -> Iterator[Shape]:
    right = left - max(extent(word, 10, code=True) for word, _ in row.scale) - 14
    words = same(_cut_words(track.label, right - _MARGIN, 13, code=True))
    yield Words(right, row.middle - (7 if track.unit else 0), words, "text", "end", 13, code=True)
    if track.unit:
        yield Words(right, row.middle + 8, same(_cut_words(track.unit, right - _MARGIN, 11)), "quiet", "end", 11)
    for word, y in row.scale:
        yield Words(left - 6, y, same(word), "quiet", "end", 10, code=True)


def _unit(until: int) -> tuple[int, str]:
    return next(((size, name) for most, size, name in _UNITS if until <= most), _HOURS)


def _ticks(plot: Plot) -> list[tuple[float, str]]:
    """Give the round moments at which the axis has a number, and the numbers."""
    size, _ = _unit(plot.until)
    parts = max(1.0, plot.width / _TICKS_APART)
    step = round_step(plot.until / size, parts)
    count = int(plot.until / size / step + 1e-9)
    return [(number * step * size, f"{number * step:.10g}") for number in range(count + 1)]


def _grid(plot: Plot, top: float, bottom: float) -> Iterator[Shape]:
    for moment, _ in _ticks(plot):
        x = plot.x(moment)
        yield Stroke(((x, top), (x, bottom)), "faint")


def _axis(plot: Plot, y: float, scans: tuple[int, ...]) -> Iterator[Shape]:
    end = plot.left + plot.width
    yield Stroke(((plot.left, y), (end + 10, y)), "text", arrow=True)
    for moment, words in _ticks(plot):
        x = plot.x(moment)
        yield Stroke(((x, y), (x, y + 5)), "text")
        yield Words(x, y + 14, same(words), "quiet", size=11, code=True)
    _, unit = _unit(plot.until)
    yield Words(end + 8, y + 31, Text(f"{TIME.zh}（{unit}）", f"{TIME.en} ({unit})"), "quiet", "end", 11)
    seen = _seen(plot, scans)
    for x in seen:
        yield Stroke(((x, y - 5), (x, y)), "accent")
    if seen:
        yield Words(plot.left, y + 31, SCANS, "accent", "start", 11)


def _seen(plot: Plot, scans: tuple[int, ...]) -> list[float]:
    """Give where scans can be seen: those that stand apart from both their neighbours."""
    apart = [plot.x(moment) for moment in scans if 0 <= moment <= plot.until]
    far = [after - before >= _SCANS_APART for before, after in pairwise(apart)]
    return [x for x, before, after in zip(apart, [True, *far], [*far, True], strict=False) if before and after]


def _guides(tracks: Sequence[Track], plot: Plot, top: float, bottom: float) -> Iterator[Shape]:
    moments = sorted({moment for track in tracks if not track.word for moment in edges(track, plot.until)})
    if len(moments) <= _EDGES_MOST:
        for moment in moments:
            yield Stroke(((plot.x(moment), top), (plot.x(moment), bottom)), "dashed")


def _mark_rows(marks: Marks, plot: Plot) -> tuple[int, list[Flag]]:
    """Place the words of the marks, each to the right of its line, in as few rows as they need.

    Words that reach beyond a later line stand above its words, so that no line crosses words. One that fits into none of
    the rows keeps its line and loses its words.
    """
    told: list[Flag] = []
    edge = plot.left + plot.width + _MARGIN
    for moment, words in sorted((one for one in marks if 0 <= one[0] <= plot.until), key=lambda one: one[0]):
        room, x = extent_of(words, 12) + 4, plot.x(moment)
        start = max(2.0, min(x + 4, edge - room))
        row = max((flag.row + 1 for flag in told if flag.words != NOTHING and flag.end + 4 > min(x, start)), default=0)
        told.append(Flag(x, start, room, min(row, _MARK_ROWS), words if row < _MARK_ROWS else NOTHING))
    return max((flag.row + 1 for flag in told if flag.words != NOTHING), default=0), told


def _marks(told: list[Flag], plot: Plot, head: float, bottom: float) -> Iterator[Shape]:
    seen = -1.0
    for flag in told:
        y = head + _MARK_ROW * (flag.row + 0.5)
        if flag.x - seen >= 1 or flag.words != NOTHING:
            x = min(flag.x, plot.left + plot.width)
            yield Stroke(((x, y - 7), (x, bottom)), "mark")
            seen = flag.x
        if flag.words != NOTHING:
            yield Words(flag.start, y, flag.words, "accent", "start", 12)


def _words(tracks: Sequence[Track], title: Text) -> Text:
    names = "; ".join(track.label for track in tracks)
    return Text(f"时序图：{title.zh}（{names}）", f"Timing chart: {title.en} ({names})")
