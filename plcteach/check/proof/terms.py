"""The formulas of an exercise's terms, over addresses: `!(I0.2 & I0.3)`, read once and worked out over any signal."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from plcteach.check.proof.table import TooLarge, model_of
from plcteach.core.effect import Both, Name, Not, names
from plcteach.core.errors import DeclarationError
from plcteach.core.notation import parse_formula
from plcteach.machine.gates import Graph
from plcteach.machine.scan import address_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.core.area import Address
    from plcteach.core.effect import Formula
    from plcteach.core.exercise import Terms
    from plcteach.core.spec import Dialect

_ADDRESS = re.compile(r"%?[A-Za-z]+[A-Za-z0-9.]*")


@dataclass(frozen=True)
class Condition:
    """A formula over addresses, as it was written."""

    text: str
    formula: Formula
    addresses: dict[str, Address]

    def worked(self, value: Callable[[Address], Any]) -> Any:
        """Work it out, with the bit that each address holds."""
        return _worked(self.formula, {name: value(place) for name, place in self.addresses.items()})


@lru_cache(maxsize=256)
def condition(text: str, dialect: Dialect) -> Condition:
    """Read a formula; DeclarationError where it does not read, UnknownNameError for an address that the family does not have."""
    addresses: dict[str, Address] = {}

    def put_aside(match: re.Match[str]) -> str:
        name = f"a{len(addresses)}"
        addresses[name] = address_of(dialect, match[0])
        return f" {name} "

    formula = parse_formula(_ADDRESS.sub(put_aside, text))
    wide = [place.text for place in addresses.values() if place.size != 1]
    if wide or not names(formula) <= set(addresses):
        msg = f"{text!r}: only bits, & | ^ ! and parentheses can stand there"
        raise DeclarationError(msg)
    return Condition(text, formula, addresses)


def spelled_out(terms: Terms, dialect: Dialect) -> Terms:
    """Give terms with every address in its usual spelling; what stands in `never` by itself is told from the output of that name.

    DeclarationError where a formula does not read, or what is assumed speaks of outputs or can never hold.
    """
    for text in (*terms.never, *terms.dont_care.values()):
        condition(text, dialect)
    _sensible(terms.assume, dialect)
    return replace(
        terms,
        outputs=tuple(address_of(dialect, one).text for one in terms.outputs),
        dont_care={address_of(dialect, one).text: text for one, text in terms.dont_care.items()},
        never=tuple(f"({text})" if _ADDRESS.fullmatch(text.strip()) else text for text in terms.never),
    )


def _sensible(assumed: tuple[str, ...], dialect: Dialect) -> None:
    graph = Graph()
    every = graph.one
    for text in assumed:
        one = condition(text, dialect)
        if any(dialect.area(place).role == "output" for place in one.addresses.values()):
            msg = f"{text!r}: what is assumed speaks of inputs, and here stands an output"
            raise DeclarationError(msg)
        every &= one.worked(lambda place: graph.variable(place.text))
    try:
        hopeless = model_of(graph, every) is None
    except TooLarge:
        hopeless = False
    if hopeless:
        msg = f"no inputs are such as is assumed: {', '.join(assumed)}"
        raise DeclarationError(msg)


def _worked(formula: Formula, values: dict[str, Any]) -> Any:
    match formula:
        case Name(name):
            return values[name]
        case Not(of):
            return ~_worked(of, values)
        case Both(op, left, right):
            a, b = _worked(left, values), _worked(right, values)
            return a & b if op == "&" else a | b if op == "|" else a ^ b
    msg = f"{formula!r}: only bits, & | ^ ! and parentheses can stand there"
    raise DeclarationError(msg)
