"""How much work may still be done, counted in gates worked out and never in seconds, so that it is the same on every machine."""

from __future__ import annotations

from dataclasses import dataclass, field

SHORT, LONG, INDUCTIONS = 1_000_000, 14_000_000, 3_000_000
"""Work for a short search, for all long ones together, and for all inductions together."""

WAITING, CHANCES = 6_000_000, 2_000_000
"""Work for holding inputs for long, and for one trial by chance."""


class Budget:
    """Some units of work; a million is something like a tenth of a second."""

    __slots__ = ("units",)

    def __init__(self, units: int) -> None:
        self.units = units

    def spend(self, units: int) -> None:
        """Take some; `spent` says when there is none left."""
        self.units -= units

    @property
    def spent(self) -> bool:
        """Whether nothing is left."""
        return self.units < 0


@dataclass(frozen=True, slots=True)
class Means:
    """What one comparison may spend in all, whatever it does for each output: on searches, on inductions, on waiting."""

    searches: Budget = field(default_factory=lambda: Budget(LONG))
    inductions: Budget = field(default_factory=lambda: Budget(INDUCTIONS))
    waiting: Budget = field(default_factory=lambda: Budget(WAITING))
