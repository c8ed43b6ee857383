"""One instruction as a row of a table: mnemonic, operands, stack effect, and what it does beside it.

A row that cannot work (an operand nobody declares, a number of cells without a range) fails at import and names itself.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.core.effect import At, Effect
from plcteach.core.errors import DeclarationError
from plcteach.core.notation import parse_effect
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.verb import Verb, VerbName


@dataclass(frozen=True, slots=True)
class Operand:
    """An operand: its name in the effect, and either the kind of address it takes or its range of numbers.

    relation: it is two words with this relation between them, and reads as a bit.
    mark: a letter that stands before the number (N0, P3), or a word with the sign that ends it.
    """

    name: str
    kind: str = ""
    first: int = 0
    last: int = 0
    optional: bool = False
    relation: str = ""
    mark: str = ""

    @property
    def number(self) -> bool:
        """Whether a number stands here and not an address."""
        return not self.kind


_OPERAND = re.compile(
    r"(?P<name>\w+)(?::(?:(?P<mark>[A-Z%]*)(?P<first>-?\d+)\.\.(?P<last>\d+)|(?P<kind>\w+)(?P<relation>[<>=]*)))?(?P<optional>\?)?"
)


def parse_operand(text: str) -> Operand:
    """Read `bit`, `m:out`, `n:0..8`, `n:N0..7`, `cmp:word>=` or `bit?` as an operand."""
    match = _OPERAND.fullmatch(text)
    if not match:
        msg = f"operand {text!r}: expected name, name:kind, name:kind>= or name:first..last"
        raise DeclarationError(msg)
    optional = bool(match["optional"])
    if match["first"] is not None:
        return Operand(match["name"], "", int(match["first"]), int(match["last"]), optional, mark=match["mark"] or "")
    return Operand(match["name"], match["kind"] or match["name"], optional=optional, relation=match["relation"] or "")


@dataclass(frozen=True, slots=True)
class Insn:
    """One instruction: mnemonic, operands, what it does to the stacks, what else it does, and its name in two languages.

    fresh: the effect where the instruction opens a new circuit.  bare: the effect when the optional operand is left out.
    close: the effect of the `)` that ends what this instruction opens.  separator: what its family's lists put between two
    operands.
    """

    mnemonic: str
    operands: tuple[Operand, ...]
    effect: Effect
    title: Text
    then: tuple[Verb, ...] = ()
    fresh: Effect | None = None
    bare: Effect | None = None
    close: Effect | None = None
    separator: str = ", "
    does: frozenset[VerbName] = field(init=False, compare=False, repr=False)
    """The names of what it does beside its stack effect."""

    def __post_init__(self) -> None:
        """Name what it does once; it is asked for at every line."""
        object.__setattr__(self, "does", frozenset(verb.name for verb in self.then))

    def __repr__(self) -> str:
        return f"Insn({self.mnemonic!r}, {self.effect.text!r})"

    @property
    def word(self) -> str:
        """The mnemonic as a list spells it, without the area by which `OUT T` is told from `OUT`."""
        return self.mnemonic.partition(" ")[0]

    @property
    def powers(self) -> bool:
        """Whether it powers the rail for the lines below it, so that what it loads need not be used."""
        return not self.does.isdisjoint(("step", "segment"))

    @property
    def retentive(self) -> bool:
        """Whether it drives a timer that keeps its time while its input is 0."""
        return any(verb.op == "retentive" for verb in self.then)

    @property
    def effects(self) -> tuple[Effect, ...]:
        """Every effect that this instruction can have."""
        return tuple(one for one in (self.effect, self.fresh, self.bare, self.close) if one)


def insn(
    mnemonic: str,
    operands: str,
    effect: str,
    *,
    zh: str,
    en: str,
    then: Verb | tuple[Verb, ...] = (),
    fresh: str = "",
    bare: str = "",
    close: str = "",
) -> Insn:
    """Declare an instruction; DeclarationError names it where an operand is used that is not declared."""
    row = Insn(
        mnemonic,
        tuple(parse_operand(word) for word in operands.split()),
        parse_effect(effect),
        Text(zh, en),
        then if isinstance(then, tuple) else (then,),
        parse_effect(fresh) if fresh else None,
        parse_effect(bare) if bare else None,
        parse_effect(close) if close else None,
    )
    _complete(row)
    return row


def _complete(row: Insn) -> None:
    """Refuse a row that uses what it does not declare."""
    declared = {operand.name for operand in row.operands}
    wanted = set().union(*(one.operands for one in row.effects))
    taken = {take.name for clause in row.effect.clauses for take in clause.takes}
    for verb in row.then:
        wanted |= (verb.names - taken) | verb.operands
    wanted -= REGISTERS
    if wanted - declared:
        msg = f"{row.mnemonic}: {', '.join(sorted(wanted - declared))} stands in no stack and is no operand"
        raise DeclarationError(msg)
    given = [give.formula for one in row.effects for clause in one.clauses for give in clause.gives]
    counted = {formula.n for formula in given if isinstance(formula, At)}
    for operand in row.operands:
        if operand.name in counted and not operand.number:
            msg = f"{row.mnemonic}: [{operand.name}] counts cells, so {operand.name} wants a range of numbers"
            raise DeclarationError(msg)


def compares(prefixes: Mapping[str, str], sizes: Mapping[str, str], *, zh: str, en: str) -> tuple[Insn, ...]:
    """Declare the family of comparing contacts: for each prefix its effect on `cmp`, for each size letter its kind."""
    return tuple(
        insn(f"{prefix}{letter}{relation}", f"cmp:{size}{relation}", effect, zh=zh, en=en)
        for prefix, effect in prefixes.items()
        for letter, size in sizes.items()
        for relation in RELATIONS
    )


RELATIONS = ("=", "<>", ">=", "<=", ">", "<")

REGISTERS = frozenset({"ENO"})
"""Bits of the machine that a formula may name and no stack or operand holds: whether the last box went well."""
