"""What an instruction does beside its stack effect: verbs with formulas, each carried out by one rule of the machine."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from plcteach.core.effect import Formula, names
from plcteach.core.notation import parse_formula

VerbName = Literal[
    "coil", "set", "reset", "work", "shift", "drive", "pin", "open", "update",
    "jump", "label", "call", "return", "loop", "next", "end", "stop",
    "master", "restore", "segment", "transfer", "step", "rail", "entry",
]  # fmt: skip


@dataclass(frozen=True, slots=True)
class Verb:
    """What an instruction does beside its stack effect: a verb, the formula that decides, and the operands it works on.

    target: the operand it writes or goes to.  count: the operand that says how many bits.  op: the rule that it follows.
    sources: the operands it works with.  pins: for a block, each input with its formula.
    """

    name: VerbName
    formula: Formula | None = None
    target: str = "out"
    count: str = ""
    op: str = ""
    sources: tuple[str, ...] = ()
    pins: tuple[tuple[str, Formula], ...] = ()

    @property
    def names(self) -> frozenset[str]:
        """Every name in its formulas."""
        formulas = [self.formula] if self.formula else []
        return frozenset().union(*(names(one) for one in [*formulas, *(formula for _, formula in self.pins)]))

    @property
    def operands(self) -> frozenset[str]:
        """The operands that it names outright."""
        return frozenset(one for one in (self.target, self.count, *self.sources) if one)


def coil(formula: str, target: str = "out") -> Verb:
    """Write the value of `formula` to the operand."""
    return Verb("coil", parse_formula(formula), target)


def set_(formula: str, count: str = "") -> Verb:
    """Where `formula` is 1, write 1 to the operand (and to the `count`-1 bits after it)."""
    return Verb("set", parse_formula(formula), count=count)


def reset(formula: str, count: str = "") -> Verb:
    """Where `formula` is 1, write 0 to the operand (and to the `count`-1 bits after it)."""
    return Verb("reset", parse_formula(formula), count=count)


def clear(formula: str, first: str, last: str) -> Verb:
    """Where `formula` is 1, clear every bit, timer, counter or word from one operand to another."""
    return Verb("reset", parse_formula(formula), first, sources=(last,))


def work(op: str, sources: str, target: str, formula: str = "a") -> Verb:
    """Where `formula` is 1, work out a word from others by a rule of the machine's arithmetic."""
    return Verb("work", parse_formula(formula), target, op=op, sources=tuple(sources.split()))


def shift(op: str, sources: str, target: str, formula: str = "a") -> Verb:
    """Where `formula` is 1, shift a row of bits that begins at the target."""
    return Verb("shift", parse_formula(formula), target, op=op, sources=tuple(sources.split()))


def drive(op: str, target: str, pins: str, sources: str = "") -> Verb:
    """Bring a block up to date with its pins, "CU=a R=b"; `sources`: the operand that holds its preset."""
    pairs = (one.split("=") for one in pins.split())
    return Verb(
        "drive",
        None,
        target,
        op=op,
        sources=tuple(sources.split()),
        pins=tuple((a, parse_formula(b)) for a, b in pairs),
    )


def pin(name: str, target: str = "block") -> Verb:
    """Put the working value on one pin of a block; outside a block's own section the block acts on it at once."""
    return Verb("pin", parse_formula("a"), target, op=name)


def go(name: VerbName, formula: str = "", target: str = "", sources: str = "") -> Verb:
    """Change where the program goes on, or whether it is powered: jump, call, loop, end, master control …."""
    return Verb(name, parse_formula(formula) if formula else None, target, sources=tuple(sources.split()))


END = Verb("end", None, "")
