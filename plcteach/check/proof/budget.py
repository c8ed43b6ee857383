"""How much work may still be done, counted in gates worked out and never in seconds, so that it is the same on every machine."""

from __future__ import annotations


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
