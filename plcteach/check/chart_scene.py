"""A counterexample's chart as a picture: columns of one width, however long each is held, the first difference marked."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.chart import chart_of
from plcteach.core.text import Text, same
from plcteach.figure.scene import Box, Scene, Stroke, Words, extent_of
from plcteach.figure.track import Plot, Track, row_of, track_ground, track_height, track_shapes

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.check.chart import Chart, Row
    from plcteach.core.verdict import Verdict
    from plcteach.figure.scene import Shape

_MARGIN, _HEAD, _APART, _GAP = 12.0, 34.0, 14.0, 8.0
_NARROWEST, _WIDEST, _USUAL = 34.0, 110.0, 720.0
_TITLE = Text("反例：输入、应有的输出和你的输出", "Counterexample: inputs, outputs as they should be, and yours")
_HERE = Text("这里不同", "differs here")


def counterexample_scene(verdict: Verdict) -> Scene | None:
    """Draw the counterexample of a verdict; nothing where it has none."""
    chart = chart_of(verdict)
    return chart_scene_of(chart) if chart else None


def chart_scene_of(chart: Chart) -> Scene:
    """Draw a chart."""
    left = _MARGIN + max(extent_of(row.label, 13, code=True) for row in chart.rows) + 12
    count = len(chart.columns)
    holds = max(extent_of(hold, 11) for hold in chart.holds) + 6
    width = min(max(_NARROWEST, holds, min(_WIDEST, (_USUAL - left) / count)), _WIDEST)
    plot = Plot(left, width * count, count)
    shapes: list[Shape] = [*_holds(chart, plot, width)]
    y = _HEAD
    lines: list[Shape] = []
    for row in chart.rows:
        y += _GAP if row.kind == "expected" else 0
        track = _track(row)
        lines += _drawn(row, track, plot, y)
        y += track_height(track) + _APART
    shapes += _grid(chart, plot, y)
    shapes += lines
    return Scene(round(left + width * count + _MARGIN), round(y + 18), tuple(shapes), _TITLE)


def _holds(chart: Chart, plot: Plot, width: float) -> Iterator[Shape]:
    for at, hold in enumerate(chart.holds):
        yield Words(plot.x(at) + width / 2, _HEAD / 2, hold, "quiet", size=11)


def _grid(chart: Chart, plot: Plot, bottom: float) -> Iterator[Shape]:
    """Draw a line between the columns, and a ground and a word where the outputs differ first."""
    first, last = plot.x(chart.at), plot.x(chart.at + 1)
    yield Box(first, _HEAD - 6, last - first, bottom - _HEAD + 2, "head")
    for at in range(len(chart.columns) + 1):
        yield Stroke(((plot.x(at), _HEAD - 6), (plot.x(at), bottom - 4)), "faint")
    end = min((first + last) / 2 + extent_of(_HERE, 12) / 2, plot.left + plot.width)
    yield Words(end, bottom + 6, _HERE, "lost", "end", 12, bold=True)


def _drawn(row: Row, track: Track, plot: Plot, y: float) -> Iterator[Shape]:
    place = row_of(track, y)
    ink = "lost" if any(row.differs) else "text"
    yield Words(plot.left - 10, place.middle, row.label, ink, "end", 13, code=True)
    yield from track_ground(track, plot, place)
    yield from track_shapes(track, plot, place)
    for at, differs in enumerate(row.differs):
        if differs:
            yield Words((plot.x(at) + plot.x(at + 1)) / 2, place.middle, same("≠"), "lost", size=13, bold=True)


def _track(row: Row) -> Track:
    values = [None if one == "x" else int(one) for one in row.values]
    changes = tuple((at, value) for at, value in enumerate(values) if not at or value != values[at - 1])
    return Track(row.address, changes, any(value not in {0, 1, None} for value in values))
