"""What a shape's ink looks like on light and on dark paper: one table, obeyed by the SVG writer and by matplotlib.

An ink names colours by their role; `COLOURS` gives each role its two hues. Every hue that words may have keeps a contrast
of at least 4.5 : 1 on every hue that may lie under it, in both themes.
"""

from __future__ import annotations

from dataclasses import dataclass

COLOURS: dict[str, tuple[str, str]] = {
    "paper": ("#ffffff", "#1b1f24"),
    "cell": ("#ffffff", "#22282f"),
    "chip": ("#f3f5f7", "#2a3139"),
    "head": ("#eef1f4", "#2a3139"),
    "wash": ("#e6f0fb", "#17324f"),
    "text": ("#1f2328", "#e6edf3"),
    "quiet": ("#57606a", "#aab4bf"),
    "accent": ("#1565c0", "#82bdff"),
    "lost": ("#a63a2b", "#ffa597"),
    "good": ("#276c2c", "#7ed08a"),
    "warn": ("#8a5200", "#f0c36a"),
    "line": ("#8a939d", "#76818c"),
    "faint": ("#c9d0d7", "#434c56"),
}


@dataclass(frozen=True, slots=True)
class Ink:
    """The roles of the colours inside and around a shape, the width of its line in px, and the dashes, if any."""

    fill: str = ""
    stroke: str = ""
    width: float = 1
    dash: tuple[float, ...] = ()

    @property
    def colour(self) -> str:
        """The one colour for what has only one: a line, its arrow head, words."""
        return self.stroke or self.fill


INKS: dict[str, Ink] = {
    # words and lines
    "text": Ink(stroke="text"),
    "quiet": Ink(stroke="quiet"),
    "accent": Ink(stroke="accent", width=1.4),
    "lost": Ink(stroke="lost", width=1.2),
    "good": Ink(stroke="good", width=1.4),
    "warn": Ink(stroke="warn", width=1.4),
    "line": Ink(stroke="line"),
    "faint": Ink(stroke="faint"),
    "dashed": Ink(stroke="line", dash=(4, 3)),
    "mark": Ink(stroke="accent", width=1.2, dash=(4, 3)),
    "wire": Ink(stroke="text", width=1.4),
    "rail": Ink(stroke="text", width=2.4),
    "wire-on": Ink(stroke="accent", width=2.6),
    "contact": Ink(stroke="text", width=1.6),
    "unbuilt": Ink(stroke="faint", width=1.4),
    # boxes and discs
    "paper": Ink(fill="paper"),
    "cell": Ink(fill="cell", stroke="line"),
    "new": Ink(fill="wash", stroke="accent", width=1.5),
    "block": Ink(fill="cell", stroke="text", width=1.6),
    "block-on": Ink(fill="cell", stroke="accent", width=2.4),
    "block-off": Ink(fill="cell", stroke="faint", width=1.4),
    "bracket": Ink(stroke="accent", width=1.4, dash=(5, 3)),
    "slot": Ink(stroke="faint", dash=(3, 3)),
    "table": Ink(stroke="line"),
    "gone": Ink(stroke="line", dash=(3, 3)),
    "chip": Ink(fill="chip", stroke="line"),
    "head": Ink(fill="head"),
    "wash": Ink(fill="wash"),
    "dot": Ink(fill="text"),
    "dot-off": Ink(fill="faint"),
    "peg": Ink(fill="accent"),
    "busy": Ink(fill="line"),
    "area": Ink(),
    "outline": Ink(stroke="accent", width=1.5),
}


def hue(role: str, *, dark: bool = False) -> str:
    """Give the hue of a colour's role, as `#rrggbb`."""
    return COLOURS[role][dark]
