"""Which instructions of a family differ in one respect only: inverted, series for parallel, a block's beginning, another timer.

Partners are found by comparing effects and verbs, never by their names.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

from plcteach.core.effect import Both, Edge, Name, Not, names

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.core.effect import Clause, Effect, Formula
    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect
    from plcteach.core.verb import Verb, VerbName

_Shape = tuple[object, ...]


def _clauses(effect: Effect | None, turn: Callable[[Formula], Formula]) -> tuple[Clause, ...]:
    if effect is None:
        return ()
    return tuple(
        replace(clause, gives=tuple(replace(give, formula=turn(give.formula)) for give in clause.gives))
        for clause in effect.clauses
    )


def _shape(row: Insn, turn: Callable[[Formula], Formula], then: tuple[Verb, ...] | None = None) -> _Shape:
    """Give what an instruction takes and does, its formulas turned."""
    effects = tuple(_clauses(one, turn) for one in (row.effect, row.fresh, row.bare, row.close))
    operands = tuple((one.name, one.kind, one.first, one.last, one.relation) for one in row.operands)
    return (operands, effects, row.then if then is None else then)


def _same(formula: Formula) -> Formula:
    return formula


@lru_cache(maxsize=16)
def _shapes(dialect: Dialect) -> dict[_Shape, str]:
    return {_shape(row, _same): row.mnemonic for row in reversed(dialect.insns)}


def _found(dialect: Dialect, row: Insn, shape: _Shape) -> tuple[str, ...]:
    """Give the word of the instruction of a shape, if it is another one."""
    found = _shapes(dialect).get(shape, row.mnemonic)
    return (dialect.words[found].word,) if found != row.mnemonic and shape != _shape(row, _same) else ()


@lru_cache(maxsize=4096)
def turned(dialect: Dialect, mnemonic: str) -> tuple[str, ...]:
    """Give the instruction that combines in series what this one combines in parallel, or the other way round."""
    row = dialect.words[mnemonic]
    return _found(dialect, row, _shape(row, _crossed))


def _crossed(formula: Formula) -> Formula:
    match formula:
        case Both(op, left, right) if op in _OTHER_SIGN:
            return Both(_OTHER_SIGN[op], left, right)
    return formula


_OTHER_SIGN = {"&": "|", "|": "&"}


@lru_cache(maxsize=4096)
def inverses(dialect: Dialect, mnemonic: str) -> tuple[str, ...]:
    """Give the instruction that reads, or writes, the inverse of what this one does; of an edge, the other edge."""
    row = dialect.words[mnemonic]
    if row.then:
        coils = tuple(_inverted_verb(verb) for verb in row.then)
        return _found(dialect, row, _shape(row, _same, coils))
    read = {one.name for one in row.operands} or {take.name for clause in row.effect.clauses for take in clause.takes}
    only_edges = not row.operands
    return _found(dialect, row, _shape(row, lambda formula: _inverted(formula, read, only_edges=only_edges)))


def _inverted_verb(verb: Verb) -> Verb:
    if verb.name != "coil" or verb.formula is None:
        return verb
    return replace(verb, formula=_inverted(verb.formula, names(verb.formula)))


def _inverted(formula: Formula, read: set[str] | frozenset[str], *, only_edges: bool = False) -> Formula:
    match formula:
        case Edge(rising, Name(name)) if name in read:
            return Edge(not rising, Name(name))
        case Not(Name(name)) if name in read and not only_edges:
            return Name(name)
        case Name(name) if name in read and not only_edges:
            return Not(Name(name))
        case Both(op, left, right):
            turned_left = _inverted(left, read, only_edges=only_edges)
            return Both(op, turned_left, _inverted(right, read, only_edges=only_edges))
    return formula


@lru_cache(maxsize=4096)
def starts(dialect: Dialect, mnemonic: str) -> tuple[str, ...]:
    """Give for a contact the load of the same bit, and for a load the contacts in series and in parallel."""
    mine = _reading(dialect.words[mnemonic])
    return (
        () if mine is None else _words(dialect, lambda one: one[1:] == mine[1:] and (one[0] == "") != (mine[0] == ""))
    )


@lru_cache(maxsize=4096)
def contacts(dialect: Dialect, mnemonic: str) -> tuple[str, ...]:
    """Give the other sorts of contact that go in as this one does: closed, at an edge, immediate; of a comparison, the others."""
    mine = _reading(dialect.words[mnemonic])
    if mine is None:
        return ()
    return _words(dialect, lambda one: one[0] == mine[0] and one != mine and one[2] == mine[2])


def _words(dialect: Dialect, fits: Callable[[_Reading], bool]) -> tuple[str, ...]:
    read = ((row.word, _reading(row)) for row in dialect.insns)
    return tuple(dict.fromkeys(word for word, one in read if one is not None and fits(one)))


_Reading = tuple[str, "Formula", str, str]


def _reading(row: Insn) -> _Reading | None:
    """Give how a contact goes in ("" for a load, else "&" or "|"), what it reads, the width of words compared, the relation.

    None where it is no contact.
    """
    clauses = row.effect.clauses
    if row.then or len(row.operands) != 1 or len(clauses) != 1 or not clauses[0].gives or row.close:
        return None
    operand = row.operands[0]
    words = (operand.kind if operand.relation else "", operand.relation)
    top, taken = clauses[0].gives[-1].formula, {take.name for take in clauses[0].takes}
    match top:
        case Both(sign, Name(cell), other) if sign in _OTHER_SIGN and cell in taken and operand.kind:
            return (sign, other, *words)
    return ("", top, *words) if not names(top) & taken and operand.kind else None


@lru_cache(maxsize=4096)
def others(dialect: Dialect, mnemonic: str) -> tuple[str, ...]:
    """Give the other instructions that drive the same sort of block with as many inputs, and the reset for a set."""
    row = dialect.words[mnemonic]
    mine = _driving(row)
    words = [one.word for one in dialect.insns if mine and _driving(one) == mine]
    forced = tuple(replace(verb, name=_FORCED.get(verb.name, verb.name)) for verb in row.then)
    found = [*words, *_found(dialect, row, _shape(row, _same, forced))]
    return tuple(word for word in dict.fromkeys(found) if word != row.word)


_FORCED: dict[VerbName, VerbName] = {"set": "reset", "reset": "set"}


def _driving(row: Insn) -> tuple[object, ...]:
    drives = [len(verb.pins) for verb in row.then if verb.name in {"drive", "pin"}]
    kinds = tuple(one.kind for one in row.operands if any(verb.name == "pin" for verb in row.then))
    return (len(row.operands), kinds, *drives) if drives else ()
