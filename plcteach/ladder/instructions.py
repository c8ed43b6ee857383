"""Finds in a family's table the instruction that a symbol of a ladder needs, by its effect on the stack and not by its name."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

from plcteach.core.effect import Both as Two
from plcteach.core.effect import Edge, Formula, Name, Not

if TYPE_CHECKING:
    from plcteach.core.effect import Clause, Effect
    from plcteach.core.insn import Insn
    from plcteach.core.ladder import CoilKind, Contact
    from plcteach.core.spec import Dialect, Role


def contact_word(dialect: Dialect, role: Role, contact: Contact) -> Insn | None:
    """Give the instruction that does with this contact what `role` does with a normally open one; None if there is none."""
    return _contact(dialect, role, contact.mark)


@lru_cache(maxsize=256)
def _contact(dialect: Dialect, role: Role, mark: str) -> Insn | None:
    base = dialect.words[dialect.roles[role]]
    if not base.operands:
        return None
    name = base.operands[0].name
    wanted = tuple(_put(clause, name, mark) for clause in base.effect.clauses)
    return next(
        (
            row
            for row in dialect.insns
            if row.effect.clauses == wanted and _takes_one(row, name) and row.close == base.close
        ),
        None,
    )


def _takes_one(row: Insn, name: str) -> bool:
    return [operand.name for operand in row.operands] == [name] and not row.then


def _put(clause: Clause, name: str, mark: str) -> Clause:
    """Put the inverse or the edge of an operand in the operand's place."""
    return replace(
        clause, gives=tuple(replace(give, formula=_marked(give.formula, name, mark)) for give in clause.gives)
    )


def _marked(formula: Formula, name: str, mark: str) -> Formula:
    match formula:
        case Name(found) if found == name:
            kinds: dict[str, Formula] = {
                "/": Not(formula),
                "P ": Edge(rising=True, of=formula),
                "N ": Edge(rising=False, of=formula),
            }
            return kinds.get(mark, formula)
        case Two(op, left, right):
            return Two(op, _marked(left, name, mark), _marked(right, name, mark))
    return formula


def edge_word(dialect: Dialect, contact: Contact) -> Insn | None:
    """Give the instruction that makes the edge of the value on top, if it needs no bit to remember the last one in."""
    role: Role = "rise" if contact.edge == "rise" else "fall"
    row = dialect.words[dialect.roles[role]] if role in dialect.roles else None
    return row if row and not row.operands else None


@lru_cache(maxsize=64)
def coil_word(dialect: Dialect, kind: CoilKind) -> Insn | None:
    """Give the instruction of a kind of coil; the inverted coil is the one that writes the inverse of what `coil` writes."""
    if kind != "not":
        role: Role = kind or "coil"
        return dialect.words[dialect.roles[role]] if role in dialect.roles else None
    base = dialect.words[dialect.roles["coil"]]
    wanted = tuple(replace(verb, formula=Not(verb.formula)) for verb in base.then if verb.formula)
    return next((row for row in dialect.insns if row.then == wanted and row.effect == base.effect), None)


@lru_cache(maxsize=64)
def closer(dialect: Dialect) -> Insn | None:
    """Give what ends a block in a family that writes blocks in parentheses; None in a family that joins them afterwards."""
    opener = dialect.words[dialect.roles["join_series"]]
    return next((row for row in dialect.insns if row.effect == opener.close), None) if opener.close else None


def first_effect(insn: Insn) -> Effect:
    """Give the effect that an instruction has where nothing is on the stack yet."""
    return insn.fresh or insn.effect
