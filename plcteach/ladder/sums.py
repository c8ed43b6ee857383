"""Writes a move or a sum as the instructions of any family: with three operands, on the spot, or in brackets."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.core.effect import Name
from plcteach.core.program import Value

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.core.area import Address
    from plcteach.core.insn import Insn
    from plcteach.core.program import Source
    from plcteach.core.spec import Dialect

_RULES = {"sum": "add", "difference": "sub", "next": "inc", "last": "dec"}
_SIGNS = {"add": "+", "sub": "-", "and": "AND", "or": "OR", "xor": "XOR"}
_TURNS_ROUND = {"add", "and", "or", "xor"}
_WORD = 16


@dataclass(frozen=True, slots=True)
class Sum:
    """A word worked out from others by a rule of the machine."""

    op: str
    sources: tuple[Source, ...]
    target: Address

    @property
    def rule(self) -> str:
        """The rule, whatever a family calls it."""
        return _RULES.get(self.op, self.op)


def summed(dialect: Dialect, one: Sum, width: int, word: Callable[[Source], str]) -> list[str] | None:
    """Give the instructions of a family that do the same; None where it has none. `word` spells an operand there."""
    if one.rule not in {"move", "inc", "dec", *_SIGNS}:
        return None
    if "[" in dialect.words:
        return _bracketed(one, word) if width == _WORD else None
    row = _row(dialect, one.rule, width)
    if row is None:
        plain = Sum({"inc": "add", "dec": "sub"}.get(one.rule, ""), (one.target, Value(1, "1")), one.target)
        return summed(dialect, plain, width, word) if plain.op else None
    return _worded(dialect, row, one, (width, word))


def _worded(dialect: Dialect, row: Insn, one: Sum, how: tuple[int, Callable[[Source], str]]) -> list[str] | None:
    """Write a sum by one row, as many operands as it takes."""
    width, word = how
    target, sources = word(one.target), [word(source) for source in one.sources]
    verb = row.then[0]
    free = [name for name in verb.sources if name != verb.target]
    if len(free) == len(sources):
        return [_line(row, {**dict(zip(free, sources, strict=True)), verb.target: target})]
    if len(sources) == 1:
        return [_line(row, {verb.target: target})] if sources == [target] else None
    return _on_the_spot(dialect, row, (one.rule, width), (sources[0], sources[1], target))


def _on_the_spot(dialect: Dialect, row: Insn, what: tuple[str, int], words: tuple[str, str, str]) -> list[str] | None:
    """Write a sum of two where the instruction works on its result: with a move before it, if need be."""
    left, right, target = words
    verb = row.then[0]
    (free,) = (name for name in verb.sources if name != verb.target)
    if right == target and left != target:
        if what[0] not in _TURNS_ROUND:
            return None
        left, right = right, left
    move = _row(dialect, "move", what[1])
    before = (
        []
        if left == target or move is None
        else [_line(move, {move.then[0].sources[0]: left, move.then[0].target: target})]
    )
    if left != target and not before:
        return None
    return [*before, _line(row, {free: right, verb.target: target})]


def _bracketed(one: Sum, word: Callable[[Source], str]) -> list[str]:
    target, sources = word(one.target), [word(source) for source in one.sources]
    if one.rule in {"inc", "dec"}:
        return [f"[{one.rule.upper()} {target}]"]
    sign = f" {_SIGNS[one.rule]} " if one.rule in _SIGNS else ""
    return [f"[{target} := {sign.join(sources)}]"]


def _row(dialect: Dialect, rule: str, width: int) -> Insn | None:
    """Find the instruction of a rule that works on words of one width, whenever there is power."""
    for row in dialect.insns:
        verb = next(iter(row.then), None)
        if verb is None or verb.name != "work" or _RULES.get(verb.op, verb.op) != rule:
            continue
        kinds = [dialect.kinds[one.kind] for one in row.operands if one.kind]
        if isinstance(verb.formula, Name) and all(one.size == width and not one.real for one in kinds):
            return row
    return None


def _line(row: Insn, words: dict[str, str]) -> str:
    return f"{row.word} {row.separator.join(words[one.name] for one in row.operands)}"
