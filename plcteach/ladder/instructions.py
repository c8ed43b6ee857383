"""Finds in a family's table the instruction that a symbol of a ladder needs, by its effect on the stack and not by its name."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

from plcteach.core.effect import Both as Two
from plcteach.core.effect import Edge, Formula, Name, Not
from plcteach.core.insn import REGISTERS
from plcteach.core.ladder import Compared

if TYPE_CHECKING:
    from plcteach.core.effect import Clause, Effect
    from plcteach.core.insn import Insn
    from plcteach.core.ladder import CoilKind, Contact, Size
    from plcteach.core.spec import Dialect, Role

_WIDTHS: dict[Size, int] = {"": 16, "B": 8, "D": 32, "R": 32}


def contact_word(dialect: Dialect, role: Role, contact: Contact | Compared) -> Insn | None:
    """Give the instruction that does with this contact what `role` does with a normally open one; None if there is none."""
    if isinstance(contact, Compared):
        return _compared(dialect, role, contact.relation, contact.size)
    if contact.address in REGISTERS:
        return _register(dialect, role, contact.address) if not contact.mark else None
    return _now(dialect, role, contact.mark) if contact.immediate else _contact(dialect, role, contact.mark)


@lru_cache(maxsize=256)
def _contact(dialect: Dialect, role: Role, mark: str) -> Insn | None:
    """Find an open or closed contact, or one that is closed at an edge of its bit."""
    base = dialect.words[dialect.roles[role]]
    if not base.operands:
        return None
    name = base.operands[0].name
    return _row(dialect, base, name, _marked(Name(name), name, mark))


@lru_cache(maxsize=256)
def _now(dialect: Dialect, role: Role, mark: str) -> Insn | None:
    """Find a contact that reads the input itself: one that takes inputs and nothing else, under a name of its own."""
    base = dialect.words[dialect.roles[role]]
    for row in dialect.insns if base.operands else ():
        own = row.operands[0].name if row.operands else ""
        if own not in {"", base.operands[0].name} and _only(dialect, row, "input"):
            found = _row(dialect, base, own, _marked(Name(own), own, "/" if mark.startswith("/") else ""))
            if found:
                return found
    return None


@lru_cache(maxsize=256)
def _compared(dialect: Dialect, role: Role, relation: str, size: Size) -> Insn | None:
    """Find the comparing contact of a relation and a width: a row of its own, or the plain one where it takes brackets."""
    base = dialect.words[dialect.roles[role]]
    if not base.operands:
        return None
    kind = dialect.kinds[base.operands[0].kind]
    if kind.compare:
        return base if not size else None
    for row in dialect.insns:
        if row.operands and row.operands[0].relation == relation:
            width = dialect.kinds[row.operands[0].kind]
            fits = (width.size, width.real) == (_WIDTHS[size], size == "R")
            if fits and _like(row, base, row.operands[0].name, Name(row.operands[0].name)):
                return row
    return None


def comparing(load: Insn, one: Compared) -> str:
    """Write a comparing contact as a line of the list: its two words, or the whole comparison in brackets."""
    words = load.separator.join((one.left, one.right)) if load.operands[0].relation else f"[{one.text}]"
    return f"{load.mnemonic} {words}"


@lru_cache(maxsize=16)
def _register(dialect: Dialect, role: Role, register: str) -> Insn | None:
    """Find the contact of a bit of the machine itself, such as ENO, which stands in no list as an address."""
    base = dialect.words[dialect.roles[role]]
    rows = (row for row in dialect.insns if not row.operands and not row.then)
    return next((row for row in rows if _like(row, base, "", Name(register))), None)


def _row(dialect: Dialect, base: Insn, name: str, wanted: Formula) -> Insn | None:
    """Find the row with one operand of this name that does with `wanted` what the base does with its operand."""
    rows = (row for row in dialect.insns if [one.name for one in row.operands] == [name] and not row.then)
    return next((row for row in rows if _like(row, base, name, wanted)), None)


def _like(row: Insn, base: Insn, name: str, wanted: Formula) -> bool:
    """Say whether a row does with `wanted` what the base does with its own operand."""
    old = base.operands[0].name
    clauses = tuple(_put(clause, old, wanted) for clause in base.effect.clauses)
    same_operands = [one.name for one in row.operands] == ([name] if name else [])
    return row.effect.clauses == clauses and same_operands and not row.then and row.close == base.close


def _put(clause: Clause, name: str, wanted: Formula) -> Clause:
    """Put a formula in an operand's place."""
    gives = tuple(replace(give, formula=_in_place(give.formula, name, wanted)) for give in clause.gives)
    return replace(clause, gives=gives)


def _in_place(formula: Formula, name: str, wanted: Formula) -> Formula:
    match formula:
        case Name(found) if found == name:
            return wanted
        case Two(op, left, right):
            return Two(op, _in_place(left, name, wanted), _in_place(right, name, wanted))
    return formula


def _marked(formula: Formula, name: str, mark: str) -> Formula:
    """Give the inverse or the edge of an operand."""
    if not isinstance(formula, Name) or formula.name != name:
        return formula
    kinds: dict[str, Formula] = {
        "/": Not(formula),
        "P ": Edge(rising=True, of=formula),
        "N ": Edge(rising=False, of=formula),
    }
    return kinds.get(mark, formula)


def _only(dialect: Dialect, row: Insn, role: str) -> bool:
    """Say whether the first operand of a row lies in areas of one role only."""
    kind = dialect.kinds.get(row.operands[0].kind)
    roles = {area.role for area in dialect.areas if kind and area.prefix in kind.areas}
    return roles == {role}


def edge_word(dialect: Dialect, *, rising: bool) -> Insn | None:
    """Give the instruction that makes the edge of the flow; it may want a bit that remembers the last one."""
    role: Role = "rise" if rising else "fall"
    return dialect.words[dialect.roles[role]] if role in dialect.roles else None


@lru_cache(maxsize=64)
def coil_word(dialect: Dialect, kind: CoilKind, immediate: bool = False) -> Insn | None:  # noqa: FBT001, FBT002 (a coil has it so)
    """Give the instruction of a kind of coil: the one that writes the inverse, or the edge, of what `coil` writes.

    immediate: it writes outputs and nothing else, and does to them what the plain one does.
    """
    if kind in {"", "set", "reset"}:
        role: Role = kind or "coil"
        base = dialect.words[dialect.roles[role]] if role in dialect.roles else None
        return _directly(dialect, base) if immediate and base else base
    base = dialect.words[dialect.roles["coil"]]
    wanted = tuple(replace(verb, formula=_turned(verb.formula, kind)) for verb in base.then if verb.formula)
    rows = (row for row in dialect.insns if row.then == wanted and row.effect == base.effect and not immediate)
    return next(rows, None)


def _turned(formula: Formula, kind: CoilKind) -> Formula:
    return Not(formula) if kind == "not" else Edge(rising=kind == "rise", of=formula)


def _directly(dialect: Dialect, base: Insn) -> Insn | None:
    """Find the coil that writes the output itself."""
    for row in dialect.insns:
        if row.operands and row is not base and row.effect == base.effect and _only(dialect, row, "output"):
            target = row.operands[0].name
            wanted = tuple(replace(verb, target=target if verb.target == "out" else verb.target) for verb in base.then)
            if row.then == wanted:
                return row
    return None


@lru_cache(maxsize=64)
def closer(dialect: Dialect) -> Insn | None:
    """Give what ends a block in a family that writes blocks in parentheses; None in a family that joins them afterwards."""
    opener = dialect.words[dialect.roles["join_series"]]
    return next((row for row in dialect.insns if row.effect == opener.close), None) if opener.close else None


def first_effect(insn: Insn) -> Effect:
    """Give the effect that an instruction has where nothing is on the stack yet."""
    return insn.fresh or insn.effect


def flows(insn: Insn) -> tuple[str, ...] | None:
    """Give the cells that an output reads and leaves, the deepest first; none if it takes no flow, None if it is no output."""
    if insn.powers:
        return ()
    taken: tuple[str, ...] = ()
    for clause in insn.effect.clauses:
        if [give.formula for give in clause.gives] != [Name(take.name) for take in clause.takes]:
            return None
        taken += tuple(take.name for take in clause.takes)
    return taken
