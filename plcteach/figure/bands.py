"""Where a long rung is cut so that it fits: into bands one below the other, only where a single wire goes on."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plcteach.ladder.layout import Layout


@dataclass(frozen=True, slots=True)
class Band:
    """The columns from `start` up to, not including, `stop`, with how many rows they use; `last`: the rung ends in it."""

    start: int
    stop: int
    rows: int
    last: bool

    @property
    def columns(self) -> int:
        """How many columns it holds."""
        return self.stop - self.start


def bands(plan: Layout, most: int) -> tuple[Band, ...]:
    """Cut a plan into bands of `most` columns or fewer; where no cut is possible a band is as wide as it must be."""
    cuts = [0]
    clean = [at for at, nets in _crossing(plan).items() if len(nets) == 1 and 0 < at < plan.columns]
    while plan.columns - cuts[-1] > most:
        behind = [at for at in clean if at > cuts[-1]]
        if not behind:
            break
        cuts.append(max((at for at in behind if at - cuts[-1] <= most), default=min(behind)))
    ends = [*cuts[1:], plan.columns]
    return tuple(
        Band(start, stop, _rows(plan, start, stop), stop == plan.columns)
        for start, stop in zip(cuts, ends, strict=True)
    )


def _crossing(plan: Layout) -> dict[int, set[int]]:
    """Give for each boundary the nets that touch it."""
    found: dict[int, set[int]] = defaultdict(set)
    for piece in plan.pieces:
        found[piece.column].add(piece.source)
        if piece.target is not None:
            found[piece.column + 1].add(piece.target)
    for run in plan.runs:
        for at in range(run.start, run.stop + 1):
            found[at].add(run.net)
    return found


def _rows(plan: Layout, start: int, stop: int) -> int:
    """Count the rows down to the lowest symbol or wire in some columns."""
    rows = [piece.row for piece in plan.pieces if start <= piece.column < stop]
    rows += [run.row for run in plan.runs if run.start < stop and run.stop > start]
    return 1 + max(rows, default=0)
