"""All that a running plant remembers, as one value: a run can be taken back to any moment of it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plcteach.core.text import Text


@dataclass(frozen=True, slots=True)
class Fault:
    """What went wrong, when, and the sentence that says so."""

    id: str
    ms: int
    says: Text

    def __repr__(self) -> str:
        return f"Fault({self.id} at {self.ms} ms)"


@dataclass(slots=True)
class Moment:
    """Where everything is, and what has happened so far.

    bits: what is actuated, energised or latched.  spots: where each part is, and each workpiece of a kind, foremost first.
    heading: the way a part last went, 1 up, -1 down.  known: for whatever happens when a condition *begins* to hold, whether
    it held before.  since: from when on each hazard has held.  turn: which of its workpieces each birth gives next.
    """

    ms: int = 0
    bits: dict[str, bool] = field(default_factory=dict)
    spots: dict[str, list[int]] = field(default_factory=dict)
    heading: dict[str, int] = field(default_factory=dict)
    known: dict[str, bool] = field(default_factory=dict)
    since: dict[str, int] = field(default_factory=dict)
    turn: list[int] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)

    def copy(self) -> Moment:
        """Give the same moment again, so that one of the two can go on."""
        spots = {name: list(places) for name, places in self.spots.items()}
        heading, known, since = dict(self.heading), dict(self.known), dict(self.since)
        return Moment(self.ms, dict(self.bits), spots, heading, known, since, list(self.turn), list(self.faults))
