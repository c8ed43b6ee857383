"""The StackPlayer: plays a film in the page; the kernel may be busy or gone, the player goes on."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

import traitlets

from plcteach.widgets.show import Shown, module, styles

if TYPE_CHECKING:
    from plcteach.figure.film import Film


class StackPlayer(Shown):
    """Steps through a film of a run, forward and back, beside the moving stack.

    film: the film as JSON.  index: the step shown, 0 before the first line; set it from Python to go there.
    """

    _esm = module("render-player.js")
    _css = styles("player.css")
    film = traitlets.Unicode("{}").tag(sync=True)
    index = traitlets.Int(0).tag(sync=True)

    def __init__(self, film: Film, *, index: int = 0, **values: object) -> None:
        self._film = film
        super().__init__(film=film.json, index=min(index, film.length - 1), **values)

    def show(self, film: Film) -> None:
        """Put another film in."""
        self._film = film
        self.film = film.json

    def _words(self) -> str:
        return f"StackPlayer({still(self._film)})"

    def _still(self) -> str:
        return table(self._film)


def still(film: Film) -> str:
    """Say in a line which program it is and what the stack holds at the end."""
    steps = film.data["steps"]
    values = "".join(cell[3] for cell in steps[-1]["cells"] if cell[1] == 0)
    return f"{film.data['digest']}, {len(steps) - 1} steps, stack {values or 'empty'}"


def table(film: Film) -> str:
    """Give the film as a plain table: each line and the first stack after it, top first."""
    lines = film.data["lines"]
    rows = []
    for step in film.data["steps"]:
        if step["line"] >= 0:
            values = " ".join(cell[3] for cell in step["cells"] if cell[1] == 0)
            rows.append(
                f"<tr><td><code>{escape(lines[step['line']]['text'])}</code></td><td><code>{values}</code></td></tr>"
            )
    return f"<table>{''.join(rows[:200])}</table>"
