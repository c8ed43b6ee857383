"""When something holds in a plant: a Boolean formula of symbols and of comparisons of positions, such as `YV1 & head >= 40`.

    comparison = name ( ">=" | "<=" | ">" | "<" ) number  |  name "=" number [ ".." number ]

The rest is the notation of `core.notation`. A name that is compared is a part of the plant, or a kind of workpiece: then the
comparison holds if it does for any one of them. Positions are whole millionths of their unit, so that nothing drifts.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from decimal import Decimal, InvalidOperation
from typing import TYPE_CHECKING, Protocol

from plcteach.core.effect import Both, Name, Not, names
from plcteach.core.errors import DeclarationError
from plcteach.core.notation import parse_formula

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from plcteach.core.effect import Formula

MICRO = 1_000_000
"""So many steps has a unit of position."""


class View(Protocol):
    """What a condition is asked of: bits by their names, and where each part is, or each workpiece of a kind."""

    bits: dict[str, bool]
    spots: dict[str, list[int]]


@dataclass(frozen=True, slots=True)
class Bound:
    """From where to where the position of a thing counts, both ends included, in millionths; None is without end."""

    name: str
    least: int | None
    most: int | None

    def holds(self, spots: Sequence[int]) -> bool:
        """Say whether any of the positions lies between the ends."""
        least, most = self.least, self.most
        return any((least is None or spot >= least) and (most is None or spot <= most) for spot in spots)

    @property
    def edges(self) -> tuple[int, ...]:
        """The positions at which the answer may be another than just below them."""
        low = () if self.least is None else (self.least,)
        return low if self.most is None else (*low, self.most + 1)


@dataclass(frozen=True, slots=True)
class Condition:
    """A formula that was read, with the comparisons that stand in it; an empty one always holds."""

    text: str
    bits: frozenset[str] = frozenset()
    bounds: tuple[Bound, ...] = ()
    test: Callable[[View], bool] = field(default=lambda _: True, repr=False, compare=False)

    def __repr__(self) -> str:
        return f"Condition({self.text!r})"


_COMPARISON = re.compile(
    r"(?P<name>[A-Za-z_]\w*)\s*(?P<sign>>=|<=|>|<|=)\s*(?P<one>-?\d+(?:\.\d+)?)(?:\s*\.\.\s*(?P<two>-?\d+(?:\.\d+)?))?"
)


def micro(number: object) -> int:
    """Give a position in millionths; DeclarationError for what is no number, or one finer than that."""
    if isinstance(number, bool) or not isinstance(number, int | float | str):
        msg = f"a position is a number and not {number!r}"
        raise DeclarationError(msg)
    try:
        exact = Decimal(str(number)) * MICRO
    except InvalidOperation:
        msg = f"a position is a number and not {number!r}"
        raise DeclarationError(msg) from None
    if not exact.is_finite() or exact != exact.to_integral_value():
        msg = f"a position has at most six decimals, and {number} has more"
        raise DeclarationError(msg)
    return int(exact)


def read_condition(text: str) -> Condition:
    """Read a condition; DeclarationError names what does not fit."""
    if not text.strip():
        return Condition("")
    bounds: dict[str, Bound] = {}

    def put_aside(match: re.Match[str]) -> str:
        key = f"_{len(bounds)}"
        bounds[key] = _bound(match)
        return f" {key} "

    formula = parse_formula(_COMPARISON.sub(put_aside, text))
    return Condition(text, names(formula) - set(bounds), tuple(bounds.values()), _test(formula, bounds, text))


def _bound(match: re.Match[str]) -> Bound:
    name, sign, one, two = match["name"], match["sign"], micro(match["one"]), match["two"]
    if sign == "=":
        most = micro(two) if two else one
        if most < one:
            msg = f"{match[0]!r} ends before it begins"
            raise DeclarationError(msg)
        return Bound(name, one, most)
    if two:
        msg = f"{match[0]!r}: only = may have a second number"
        raise DeclarationError(msg)
    least = {">=": one, ">": one + 1}.get(sign)
    return Bound(name, least, {"<=": one, "<": one - 1}.get(sign))


def _test(formula: Formula, bounds: Mapping[str, Bound], text: str) -> Callable[[View], bool]:
    """Give the formula as a function of what is to be seen; made of functions, so that nothing is ever evaluated as text."""
    match formula:
        case Name(name) if name in bounds:
            bound, thing = bounds[name], bounds[name].name
            return lambda view: bound.holds(view.spots[thing])
        case Name(name):
            return lambda view: view.bits[name]
        case Not(of):
            inner = _test(of, bounds, text)
            return lambda view: not inner(view)
        case Both(op, left, right):
            return _both(op, _test(left, bounds, text), _test(right, bounds, text))
    msg = f"{text!r}: only symbols, comparisons, & | ^ ! and parentheses can stand there"
    raise DeclarationError(msg)


def _both(op: str, left: Callable[[View], bool], right: Callable[[View], bool]) -> Callable[[View], bool]:
    if op == "&":
        return lambda view: left(view) and right(view)
    if op == "|":
        return lambda view: left(view) or right(view)
    return lambda view: left(view) != right(view)
