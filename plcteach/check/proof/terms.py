"""The formulas of an exercise's terms, over addresses: `!(I0.2 & I0.3)`, read once and worked out over any signal."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from plcteach.core.effect import Both, Name, Not, names
from plcteach.core.errors import DeclarationError
from plcteach.core.notation import parse_formula
from plcteach.machine.scan import address_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.core.area import Address
    from plcteach.core.effect import Formula
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
