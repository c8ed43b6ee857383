"""What can go wrong for a developer; a learner's mistake is never an exception but a Diagnostic."""

from __future__ import annotations

from difflib import get_close_matches
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.core.text import Text


class PlcTeachError(Exception):
    """The root of every exception that plcteach raises on purpose."""


class DeclarationError(PlcTeachError):
    """A table row is incomplete or contradicts itself; raised at import and names the row."""


_FEW = 12


class UnknownNameError(PlcTeachError, LookupError):
    """A dialect, instruction, exercise or diagnostic that nobody declared, with a "did you mean"."""

    def __init__(self, kind: str, name: str, known: Iterable[str]) -> None:
        """Remember the kind and name asked for and the nearest known names."""
        names = sorted(known)
        self.near = nearest(name, names)
        hint = f" Did you mean {' or '.join(self.near)}?" if self.near else ""
        if not hint and 0 < len(names) <= _FEW:
            hint = f" There is: {', '.join(names)}."
        super().__init__(f"There is no {kind} called {name[:60]!r}.{hint}")


class NotRepresentableError(PlcTeachError):
    """A ladder that no instruction list can express, or a list that is no ladder; says why in two languages."""

    def __init__(self, reason: Text) -> None:
        """Keep the reason in both languages."""
        self.reason = reason
        super().__init__(reason.en)

    def __str__(self) -> str:
        from plcteach.core.text import language  # noqa: PLC0415 (the words know the errors)

        return self.reason.in_(language())


def nearest(name: str, known: Iterable[str], most: int = 2) -> list[str]:
    """Give the known names most like `name`, the best first."""
    by_upper = {one.upper(): one for one in known}
    return [by_upper[near] for near in get_close_matches(name[:40].upper(), by_upper, n=most, cutoff=0.5)]
