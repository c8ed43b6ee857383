"""Keeps the rules in the order in which they were declared."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeVar

from plcteach.core.diagnostic import Diagnostic, Rule, rule
from plcteach.core.errors import DeclarationError
from plcteach.core.program import Program
from plcteach.machine.walk import Walk

Seen = TypeVar("Seen", Walk, Program)
Finder = Callable[[Seen, Rule], Iterator[Diagnostic]]

STACK_RULES: dict[str, tuple[Rule, Finder[Walk]]] = {}
"""Rules that look at one network's walk."""

PROGRAM_RULES: dict[str, tuple[Rule, Finder[Program]]] = {}
"""Rules that look at a whole program."""


def finds(code: str, rules: dict[str, tuple[Rule, Finder[Seen]]]) -> Callable[[Finder[Seen]], Finder[Seen]]:
    """Enter a function as the finder of one declared diagnostic; an unknown or doubled code fails at import."""
    row = rule(code)
    if code in STACK_RULES or code in PROGRAM_RULES:
        msg = f"{code} has two finders"
        raise DeclarationError(msg)

    def enter(finder: Finder[Seen]) -> Finder[Seen]:
        rules[code] = (row, finder)
        return finder

    return enter
