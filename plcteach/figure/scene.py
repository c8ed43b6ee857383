"""A picture as frozen shapes in a plane, with words in two languages; knows nothing of PLCs, SVG or matplotlib.

Units are CSS pixels at 100 %, x to the right, y downwards. What a shape looks like is decided by its `ink`, one word
from `figure.ink.INKS`, which the SVG writer and the matplotlib drawer both obey, so that page and printed book agree.
Every shape may name the `part` of the picture it belongs to, by which a page finds it again; on paper that means nothing.
"""

from __future__ import annotations

import math
import re
import unicodedata
from dataclasses import dataclass
from itertools import zip_longest
from typing import Literal

from plcteach.core.text import Text

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle, its corners rounded by `radius`."""

    x: float
    y: float
    width: float
    height: float
    ink: str
    radius: float = 0
    part: str = ""


@dataclass(frozen=True, slots=True)
class Words:
    """A line of words; `y` is the middle of its height; `size` in px; `code` asks for the fixed-width type."""

    x: float
    y: float
    text: Text
    ink: str = "text"
    anchor: Literal["start", "middle", "end"] = "middle"
    size: float = 13
    code: bool = False
    bold: bool = False
    part: str = ""


@dataclass(frozen=True, slots=True)
class Stroke:
    """A line through points, with an arrow head at its end where asked.

    curve: the four points are a cubic Bézier's start, two handles and end.
    """

    points: tuple[Point, ...]
    ink: str = "line"
    arrow: bool = False
    curve: bool = False
    part: str = ""

    @property
    def head(self) -> tuple[Point, Point, Point] | None:
        """The triangle of the arrow head, or None."""
        if not self.arrow:
            return None
        (x, y), (from_x, from_y) = self.points[-1], self.points[-2]
        length = math.hypot(x - from_x, y - from_y) or 1
        dx, dy = (x - from_x) / length, (y - from_y) / length
        back_x, back_y = x - _HEAD * dx, y - _HEAD * dy
        side_x, side_y = _HEAD * _SLIM * dy, -_HEAD * _SLIM * dx
        return (x, y), (back_x + side_x, back_y + side_y), (back_x - side_x, back_y - side_y)


_HEAD = 6.5
_SLIM = 0.42


@dataclass(frozen=True, slots=True)
class Disc:
    """A circle; `open` degrees of it are left out at the top and as many at the bottom, as a coil is drawn."""

    x: float
    y: float
    radius: float
    ink: str
    open: float = 0
    part: str = ""

    @property
    def arcs(self) -> tuple[tuple[float, float], ...]:
        """The stretches that are drawn, in degrees clockwise from the right; none for a full circle."""
        if not self.open:
            return ()
        half = self.open / 2
        return (half - 90, 90 - half), (90 + half, 270 - half)


Shape = Box | Words | Stroke | Disc


@dataclass(frozen=True, slots=True)
class Scene:
    """A finished picture: its size, its shapes in drawing order, and what a reader who cannot see it is told."""

    width: float
    height: float
    shapes: tuple[Shape, ...]
    title: Text

    def __repr__(self) -> str:
        return f"Scene({self.width:g}x{self.height:g}, {len(self.shapes)} shapes, {self.title.en!r})"


def extent(text: str, size: float = 13, *, code: bool = False) -> float:
    """Give about how wide words are, in px; a little generous, since every machine has its own fonts."""
    plain = 0.62 if code else 0.56
    return size * sum(1.0 if unicodedata.east_asian_width(sign) in "WF" else plain for sign in text)


def extent_of(text: Text, size: float = 13, *, code: bool = False) -> float:
    """Give about how wide words are in the language in which they are wider."""
    return max(extent(text.zh, size, code=code), extent(text.en, size, code=code))


def broken(text: Text, width: float, size: float = 13) -> list[Text]:
    """Break words into rows that fit, each language by itself; the shorter one ends with empty rows."""
    rows = [_broken(words, width, size) for words in (text.zh, text.en)]
    return [Text(zh, en) for zh, en in zip_longest(*rows, fillvalue="")]


def _broken(words: str, width: float, size: float) -> list[str]:
    """Break at blanks and between full-width signs, but never before a closing sign."""
    rows = [""]
    for piece in re.findall(r"[^\u2e80-\uffef\s]+\s*|[\u2e80-\uffef][，。；：？！、）”]*\s*|\s+", words):
        if rows[-1] and extent(rows[-1] + piece.rstrip(), size) > width:
            rows.append("")
        rows[-1] += piece
    return [row.rstrip() for row in rows]
