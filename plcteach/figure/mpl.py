"""Scenes on paper: the only module that imports matplotlib, and only when something is to be drawn.

It never touches pyplot and never writes a warning: nbgrader counts anything on stderr as a failed exercise. Where the
machine has no Chinese font, Chinese figures speak English rather than in empty boxes.
"""

from __future__ import annotations

import logging
import warnings
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plcteach.core.source import printable
from plcteach.figure.ink import INKS, hue
from plcteach.figure.scene import Box, Disc, Scene, Stroke, Words

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.path import Path as Outline

    from plcteach.figure.scene import Shape

CHINESE_FONTS = (
    "WenQuanYi Micro Hei", "Noto Sans CJK SC", "Noto Sans SC", "Source Han Sans SC", "Source Han Sans CN", "PingFang SC",
    "Microsoft YaHei", "SimHei", "Hiragino Sans GB", "Heiti SC", "STHeiti", "WenQuanYi Zen Hei", "Noto Sans CJK JP",
    "Droid Sans Fallback", "Arial Unicode MS", "SimSun", "Noto Serif CJK SC",
)  # fmt: skip
_DOTS_PER_INCH = 96
_POINTS = 72 / _DOTS_PER_INCH
_SHARP = 200
_SAME_BYTES: dict[str, dict[str, None]] = {
    "svg": {"Date": None, "Creator": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
    "png": {"Software": None},
}
_SETTINGS: Any = {"svg.hashsalt": "plcteach", "svg.fonttype": "path", "pdf.fonttype": 3, "savefig.bbox": None, "text.usetex": False,
             "savefig.transparent": False, "savefig.facecolor": "auto", "path.sketch": None, "path.effects": []}  # fmt: skip


def draw(scene: Scene, lang: str, ax: Axes | None = None) -> Axes:
    """Draw a scene into axes (new ones of the scene's own size, where none are given) and give them."""
    with _quiet():
        axes = ax or _page(scene)
        axes.set_xlim(0, scene.width)
        axes.set_ylim(scene.height, 0)
        axes.set_aspect("equal")
        axes.axis("off")
        inches = axes.get_window_extent().width / axes.figure.dpi
        pen = _Pen(axes, lang if lang != "zh" or chinese_font() else "en", inches * _DOTS_PER_INCH / scene.width)
        for shape in scene.shapes:
            pen.draw(shape)
    return axes


def save(scene: Scene, path: str | Path, lang: str) -> Path:
    """Write a scene to a .svg (words as outlines), .pdf or .png file and give its path; the same scene, the same bytes."""
    target = Path(path)
    kind = target.suffix.lower().lstrip(".")
    if kind not in _SAME_BYTES:
        msg = f"A figure is saved as .svg, .pdf or .png, not {target.suffix or 'without an ending'}."
        raise ValueError(msg)
    with _quiet():
        _sheet(draw(scene, lang)).savefig(target, format=kind, dpi=_SHARP, metadata=_SAME_BYTES[kind])
    return target


def save_pages(scenes: Iterable[Scene], path: str | Path, lang: str) -> Path:
    """Write several scenes to one PDF, a page each, and give its path."""
    target = Path(path)
    if target.suffix.lower() != ".pdf":
        msg = f"Pages are saved as .pdf, not {target.suffix or 'without an ending'}."
        raise ValueError(msg)
    with _quiet():
        from matplotlib.backends.backend_pdf import PdfPages  # noqa: PLC0415

        with PdfPages(target, metadata=_SAME_BYTES["pdf"]) as pages:
            for scene in scenes:
                pages.savefig(_sheet(draw(scene, lang)))
    return target


@lru_cache(maxsize=1)
def chinese_font() -> str:
    """Give the name of an installed font with Chinese letters, or nothing."""
    with _quiet():
        from matplotlib.font_manager import fontManager  # noqa: PLC0415

        there = {font.name for font in fontManager.ttflist}
    return next((name for name in CHINESE_FONTS if name in there), "")


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep matplotlib and its font tools silent, with settings of our own, and leave everything as it was."""
    loggers = [logging.getLogger(name) for name in ("matplotlib", "matplotlib.font_manager", "fontTools", "PIL")]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            from matplotlib import rc_context  # noqa: PLC0415

            with rc_context(_SETTINGS):
                yield
    finally:
        for logger, level in zip(loggers, levels, strict=True):
            logger.setLevel(level)


def _page(scene: Scene) -> Axes:
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(scene.width / _DOTS_PER_INCH, scene.height / _DOTS_PER_INCH), facecolor=hue("paper"))
    return figure.add_axes((0, 0, 1, 1))


def _sheet(axes: Axes) -> Figure:
    figure: Any = axes.figure
    sheet: Figure = figure
    return sheet


class _Pen:
    """Draws shapes into axes; `scale` is how much larger than its own size the scene appears."""

    def __init__(self, axes: Axes, lang: str, scale: float) -> None:
        self.axes = axes
        self.lang = lang
        self.points = _POINTS * scale

    def draw(self, shape: Shape) -> None:
        match shape:
            case Box():
                self.box(shape)
            case Words():
                self.words(shape)
            case Stroke():
                self.stroke(shape)
            case Disc():
                self.disc(shape)

    def look(self, word: str, *, line: bool = False) -> dict[str, Any]:
        """Give matplotlib's words for an ink."""
        ink = INKS[word]
        edge = ink.colour if line else ink.stroke
        dashes = (0, tuple(one / ink.width for one in ink.dash)) if ink.dash else "solid"
        return {
            "facecolor": "none" if line or not ink.fill else hue(ink.fill),
            "edgecolor": hue(edge) if edge else "none",
            "linewidth": ink.width * self.points if edge else 0,
            "linestyle": dashes,
            "clip_on": False,
        }

    def box(self, shape: Box) -> None:
        from matplotlib.patches import FancyBboxPatch, Rectangle  # noqa: PLC0415

        corner, look = (shape.x, shape.y), self.look(shape.ink)
        if shape.radius:
            radius = min(shape.radius, shape.width / 2, shape.height / 2)
            style = f"round,pad=0,rounding_size={radius}"
            self.axes.add_patch(FancyBboxPatch(corner, shape.width, shape.height, boxstyle=style, **look))
        else:
            self.axes.add_patch(Rectangle(corner, shape.width, shape.height, **look))

    def words(self, shape: Words) -> None:
        text = printable(shape.text.in_(self.lang))
        if not text:
            return
        family = ["DejaVu Sans Mono" if shape.code else "DejaVu Sans", *filter(None, [chinese_font()])]
        self.axes.text(
            shape.x, shape.y + 0.35 * shape.size, text,
            fontsize=shape.size * self.points * _NARROWER, fontfamily=family, fontweight="bold" if shape.bold else "normal",
            color=hue(INKS[shape.ink].colour), ha={"start": "left", "middle": "center", "end": "right"}[shape.anchor],
            va="baseline", parse_math=False,
        )  # fmt: skip

    def stroke(self, shape: Stroke) -> None:
        from matplotlib.patches import PathPatch, Polygon  # noqa: PLC0415
        from matplotlib.path import Path as Outline  # noqa: PLC0415

        points, head = list(shape.points), shape.head
        if head:
            points[-1] = ((head[1][0] + head[2][0]) / 2, (head[1][1] + head[2][1]) / 2)
        step = Outline.CURVE4 if shape.curve else Outline.LINETO
        outline = Outline(points, [Outline.MOVETO] + [step] * (len(points) - 1))
        self.axes.add_patch(PathPatch(outline, capstyle="butt", **self.look(shape.ink, line=True)))
        if head:
            colour = hue(INKS[shape.ink].colour)
            self.axes.add_patch(
                Polygon(head, closed=True, facecolor=colour, edgecolor="none", linewidth=0, clip_on=False)
            )

    def disc(self, shape: Disc) -> None:
        from matplotlib.patches import Circle, PathPatch  # noqa: PLC0415

        if not shape.arcs:
            self.axes.add_patch(Circle((shape.x, shape.y), shape.radius, **self.look(shape.ink)))
        for first, last in shape.arcs:
            self.axes.add_patch(PathPatch(_arc(shape, first, last), **self.look(shape.ink, line=True)))


_NARROWER = 0.97
"""DejaVu runs a little wider than the fonts of screens."""


def _arc(shape: Disc, first: float, last: float) -> Outline:
    from matplotlib.path import Path as Outline  # noqa: PLC0415

    vertices: Any = (arc := Outline.arc(first, last)).vertices
    return Outline([(shape.x + shape.radius * x, shape.y + shape.radius * y) for x, y in vertices], arc.codes)
