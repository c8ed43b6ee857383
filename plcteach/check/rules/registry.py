"""Keeps the rules in the order in which they were declared."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from plcteach.machine.walk import Walk
from plcteach.core.diagnostic import Diagnostic, Rule, rule

Finder = Callable[[Walk, Rule], Iterator[Diagnostic]]

STACK_RULES: dict[str, tuple[Rule, Finder]] = {}


def finds(code: str) -> Callable[[Finder], Finder]:
    """Enter a function as the finder of one declared diagnostic; an unknown or doubled code fails at import."""
    row = rule(code)
    if code in STACK_RULES:
        msg = f"{code} has two finders"
        raise ValueError(msg)

    def enter(finder: Finder) -> Finder:
        STACK_RULES[code] = (row, finder)
        return finder

    return enter
