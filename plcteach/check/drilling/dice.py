"""Chance that falls alike on every machine and in every version of Python: it uses nothing but numbers between 0 and 1."""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

T = TypeVar("T")


class Dice:
    """Choices that follow from a word alone."""

    def __init__(self, word: str) -> None:
        self._chance = Random(word)  # noqa: S311 (the same tasks everywhere, on purpose)

    def number(self, first: int, last: int) -> int:
        """Give a whole number from `first` to `last`."""
        return first + int(self._chance.random() * (last - first + 1))

    def pick(self, some: Sequence[T]) -> T:
        """Give one of some things."""
        return some[self.number(0, len(some) - 1)]

    def falls(self, share: float) -> bool:
        """Say yes in a share of all cases."""
        return self._chance.random() < share

    def mixed(self, some: Iterable[T]) -> list[T]:
        """Give all of some things in another order."""
        rest, found = list(some), []
        while rest:
            found.append(rest.pop(self.number(0, len(rest) - 1)))
        return found
