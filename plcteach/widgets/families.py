"""The FamilyPlayer: one ladder, several instruction lists, several stacks, all stepping together in the page."""

from __future__ import annotations

from typing import TYPE_CHECKING

import traitlets

from plcteach.figure.film import Film
from plcteach.widgets.player import table
from plcteach.widgets.show import Shown, module, styles

if TYPE_CHECKING:
    from plcteach.figure.families import Together


class FamilyPlayer(Shown):
    """Steps through the same ladder in several families at once.

    together: what is played, as JSON.  index: the moment shown, 0 before the first line.
    """

    _esm = module("render-families.js")
    _css = styles("player.css")
    together = traitlets.Unicode("{}").tag(sync=True)
    index = traitlets.Int(0).tag(sync=True)

    def __init__(self, together: Together, *, index: int = 0, **values: object) -> None:
        self._together = together
        last = len(together.data["moments"]) - 1
        super().__init__(together=together.json, index=max(0, min(index, last)), **values)

    def _words(self) -> str:
        return f"FamilyPlayer({self._together!r})"

    def _still(self) -> str:
        cells = "".join(f"<td>{table(Film(family['film']))}</td>" for family in self._together.data["families"])
        return f'<table><tr style="vertical-align:top">{cells}</tr></table>'
