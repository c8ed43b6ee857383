"""A scene as a self-contained SVG: no script, no font, nothing fetched, and every word escaped.

A notebook may show it inside the page or as an image, on light or dark paper, and the picture cannot ask which. So the
colours are custom properties: as an image they follow the reader's system, and the picture brings its own paper; inside a
page of JupyterLab they follow its theme, and the paper is the page's. Other readers take the plain attributes.
"""

from __future__ import annotations

import math
import re
from html import escape
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING

from plcteach.core.text import language
from plcteach.figure.ink import COLOURS, INKS, hue
from plcteach.figure.scene import Box, Disc, Scene, Stroke, Words

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.figure.scene import Shape

_UI = (
    "var(--jp-ui-font-family,system-ui),'Segoe UI','Noto Sans','PingFang SC','Microsoft YaHei','Noto Sans CJK SC',"
    "'WenQuanYi Micro Hei',sans-serif"
)
_CODE = (
    "var(--jp-code-font-family,ui-monospace),Menlo,Consolas,'DejaVu Sans Mono','Noto Sans CJK SC',"
    "'WenQuanYi Micro Hei',monospace"
)


def svg(scene: Scene, lang: str, *, dark: bool | None = None, scale: float = 1.0, paper: bool = True) -> str:
    """Write a scene as SVG.

    dark: None follows the page or the reader's system.  paper: False leaves the ground transparent everywhere.
    """
    theme = {None: "auto", True: "dark", False: "light"}[dark]
    pen = _Pen(lang, dark=bool(dark))
    ground = [Box(0, 0, scene.width, scene.height, "paper", 6)] if paper else []
    title = _printable(scene.title.in_(lang))
    rows = [
        _opening(scene, theme, lang, title, scale),
        f"<title>{escape(title)}</title>",
        f"<style>{_STYLES[theme]}</style>",
        *(_grouped(part, map(pen.draw, shapes)) for part, shapes in groupby((*ground, *scene.shapes), _part)),
        "</svg>",
        "",
    ]
    return "\n".join(rows)


def bare(scene: Scene) -> str:
    """Write a scene as SVG without a style sheet or paper, for a page that colours its parts itself."""
    pen, label = _Pencil("en", dark=False), escape(_printable(scene.title.en))
    rows = [_grouped(part, map(pen.draw, shapes)) for part, shapes in groupby(scene.shapes, _part)]
    size = f'width="{_n(scene.width)}" height="{_n(scene.height)}" viewBox="0 0 {_n(scene.width)} {_n(scene.height)}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" role="group" aria-label="{label}" {size}>{"".join(rows)}</svg>'


def _part(shape: Shape) -> str:
    return shape.part


def _grouped(part: str, rows: Iterable[str]) -> str:
    """Put the shapes of one part of the picture into a group that bears its name."""
    inside = "\n".join(rows)
    return f'<g data-part="{escape(part)}">{inside}</g>' if part else inside


def _opening(scene: Scene, theme: str, lang: str, title: str, scale: float) -> str:
    size = f'width="{_n(scene.width * scale)}" height="{_n(scene.height * scale)}"'
    view = f'viewBox="0 0 {_n(scene.width)} {_n(scene.height)}"'
    tongue = "zh-CN" if lang == "zh" else "en"
    root = f'class="plc-fig plc-fig-{theme}" role="img" lang="{tongue}" aria-label="{escape(title)}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {root} {size} {view}>'


_NOT_IN_XML = re.compile("[^\t\n -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def _printable(words: str) -> str:
    """Leave out what XML cannot hold: control characters, halves of surrogate pairs and the two non-characters."""
    return _NOT_IN_XML.sub("", words)


def _n(number: float) -> str:
    """Write a number with two decimals at most and no idle zeros."""
    return f"{number:.2f}".rstrip("0").rstrip(".") if number else "0"


def _points(points: Iterable[tuple[float, float]]) -> str:
    return " ".join(f"{_n(x)},{_n(y)}" for x, y in points)


class _Pen:
    """Writes shapes as elements; classes for pages, plain attributes for whatever reads no custom properties."""

    def __init__(self, lang: str, *, dark: bool) -> None:
        self.lang = lang
        self.dark = dark

    def draw(self, shape: Shape) -> str:
        match shape:
            case Box():
                corner = f' rx="{_n(shape.radius)}"' if shape.radius else ""
                place = f'x="{_n(shape.x)}" y="{_n(shape.y)}" width="{_n(shape.width)}" height="{_n(shape.height)}"'
                return f"<rect {place}{corner} {self.area(shape.ink)}/>"
            case Words():
                return self.words(shape)
            case Stroke():
                return self.stroke(shape)
            case Disc():
                return self.disc(shape)

    def area(self, word: str) -> str:
        """Give the attributes of a shape with an inside."""
        ink = INKS[word]
        fill = hue(ink.fill, dark=self.dark) if ink.fill else "none"
        colour = hue(ink.stroke, dark=self.dark) if ink.stroke else "none"
        edge = f'stroke="{colour}" stroke-width="{_n(ink.width)}"{self.dashes(word)}'
        return f'class="plc-ink plc-ink-{word}" fill="{fill}" {edge}'

    def line(self, word: str) -> str:
        """Give the attributes of a shape that is only a line."""
        ink = INKS[word]
        edge = f'stroke="{hue(ink.colour, dark=self.dark)}" stroke-width="{_n(ink.width)}"{self.dashes(word)}'
        return f'class="plc-line plc-line-{word}" fill="none" {edge}'

    @staticmethod
    def dashes(word: str) -> str:
        dash = INKS[word].dash
        return f' stroke-dasharray="{" ".join(_n(one) for one in dash)}"' if dash else ""

    def solid(self, word: str) -> str:
        """Give the attributes of words and arrow heads."""
        return f'class="plc-solid plc-solid-{word}" fill="{hue(INKS[word].colour, dark=self.dark)}"'

    def words(self, shape: Words) -> str:
        text = _printable(shape.text.in_(self.lang))
        if not text:
            return ""
        family, bold = "plc-code" if shape.code else "plc-ui", ' font-weight="600"' if shape.bold else ""
        look = self.solid(shape.ink).replace('class="', f'class="{family} ', 1)
        kind = f'font-size="{_n(shape.size)}" font-family="{"monospace" if shape.code else "sans-serif"}"{bold}'
        place = f'x="{_n(shape.x)}" y="{_n(shape.y + 0.35 * shape.size)}" text-anchor="{shape.anchor}"'
        return f'<text {place} {kind} {look} xml:space="preserve">{escape(text)}</text>'

    def stroke(self, shape: Stroke) -> str:
        points, head = list(shape.points), shape.head
        if head:
            points[-1] = ((head[1][0] + head[2][0]) / 2, (head[1][1] + head[2][1]) / 2)
        if shape.curve:
            body = f'<path d="M{_points(points[:1])} C{_points(points[1:])}" {self.line(shape.ink)}/>'
        else:
            body = f'<polyline points="{_points(points)}" {self.line(shape.ink)}/>'
        return body + (f'<polygon points="{_points(head)}" {self.solid(shape.ink)}/>' if head else "")

    def disc(self, shape: Disc) -> str:
        if not shape.arcs:
            return f'<circle cx="{_n(shape.x)}" cy="{_n(shape.y)}" r="{_n(shape.radius)}" {self.area(shape.ink)}/>'
        path = []
        for arc in shape.arcs:
            (x, y), end = (_on_circle(shape, angle) for angle in arc)
            path.append(f"M{_n(x)},{_n(y)} A{_n(shape.radius)},{_n(shape.radius)} 0 0 1 {_points([end])}")
        return f'<path d="{" ".join(path)}" {self.line(shape.ink)}/>'


class _Pencil(_Pen):
    """Writes the same elements with their classes alone: what they look like is the page's business."""

    def area(self, word: str) -> str:
        """Give the class of a shape with an inside."""
        return f'class="plc-ink plc-ink-{word}"'

    def line(self, word: str) -> str:
        """Give the class of a shape that is only a line."""
        return f'class="plc-line plc-line-{word}"'

    def solid(self, word: str) -> str:
        """Give the class of words and arrow heads."""
        return f'class="plc-solid plc-solid-{word}"'

    def words(self, shape: Words) -> str:
        text = _printable(shape.text.in_(self.lang))
        bold = ' font-weight="600"' if shape.bold else ""
        place = f'x="{_n(shape.x)}" y="{_n(shape.y + 0.35 * shape.size)}" text-anchor="{shape.anchor}"'
        return (
            f'<text {place} font-size="{_n(shape.size)}"{bold} class="plc-solid">{escape(text)}</text>' if text else ""
        )


def _on_circle(disc: Disc, angle: float) -> tuple[float, float]:
    turn = math.radians(angle)
    return disc.x + disc.radius * math.cos(turn), disc.y + disc.radius * math.sin(turn)


def _palette(*, dark: bool) -> str:
    return "".join(f"--plc-{role}:{hue(role, dark=dark)};" for role in COLOURS)


def _classes(root: str) -> str:
    """Write the rules of all inks, for the shapes inside one kind of root."""
    rules = [f".{root} .plc-ui{{font-family:{_UI}}}", f".{root} .plc-code{{font-family:{_CODE}}}"]
    for word, ink in INKS.items():
        fill = f"var(--plc-{ink.fill})" if ink.fill else "none"
        edge = f";stroke:var(--plc-{ink.stroke})" if ink.stroke else ""
        rules.append(f".{root} .plc-ink-{word}{{fill:{fill}{edge}}}")
        rules.append(f".{root} .plc-line-{word}{{stroke:var(--plc-{ink.colour})}}")
        rules.append(f".{root} .plc-solid-{word}{{fill:var(--plc-{ink.colour})}}")
    return "".join(rules)


def _style(theme: str) -> str:
    root = f"plc-fig-{theme}"
    light, dark = _palette(dark=False), _palette(dark=True)
    if theme != "auto":
        return f".{root}{{{light if theme == 'light' else dark}}}{_classes(root)}"
    return (
        f".{root}{{{light}}}@media (prefers-color-scheme:dark){{.{root}{{{dark}}}}}"
        f"[data-jp-theme-light=true] .{root}{{{light}--plc-paper:transparent}}"
        f"[data-jp-theme-light=false] .{root}{{{dark}--plc-paper:transparent}}{_classes(root)}"
    )


_STYLES = {theme: _style(theme) for theme in ("auto", "light", "dark")}


class Figure:
    """A scene that a notebook shows by itself, in one language."""

    def __init__(self, scene: Scene, lang: str | None = None) -> None:
        """Keep the scene; without `lang` it speaks the language in force when it is shown."""
        self.scene = scene
        self.lang = lang

    def __repr__(self) -> str:
        return f"Figure({self.scene.title.in_(self.lang or language())!r})"

    def svg(self, *, dark: bool | None = None, scale: float = 1.0) -> str:
        """Give the picture as SVG."""
        return svg(self.scene, self.lang or language(), dark=dark, scale=scale)

    def _repr_svg_(self) -> str:
        return self.svg()

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        del include, exclude
        return {"image/svg+xml": self.svg(), "text/plain": self.scene.title.in_(self.lang or language())}

    def save(self, path: str | Path) -> Path:
        """Write the picture to a .svg file and give its path; other kinds of file are another module's."""
        target = Path(path)
        if target.suffix.lower() != ".svg":
            msg = f"This saves .svg, not {target.suffix or 'a name without an ending'}."
            raise ValueError(msg)
        target.write_text(self.svg(), encoding="utf-8")
        return target
