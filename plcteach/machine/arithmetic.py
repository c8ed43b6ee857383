"""Words worked out from words: moves, sums, logic, shifts and conversions, with the flags that they leave.

Sums and moves are formulas over `Word`; a rule that no formula over bits can give (a product, a quotient, reals) is a plain
function of whole numbers, worked out case by case, and an answer of None means that there is no answer (a division by zero).
"""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plcteach.core.area import Address, Kind
from plcteach.core.program import Value

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.machine.evaluation import Evaluation

Operands = list[tuple[Any, Kind | None]]


@dataclass(frozen=True, slots=True)
class Rule:
    """How a word is worked out: a formula over words, or else a function of whole numbers.

    flags: it leaves zero, overflow and negative behind.  wraps: too large a result is cut off and is no overflow.
    """

    formula: Callable[..., Any] | None = None
    function: Callable[..., int | None] | None = None
    flags: bool = True
    wraps: bool = False


def real(bits: int) -> float:
    """Give the floating-point number that 32 bits spell."""
    return float(struct.unpack(">f", struct.pack(">I", bits & 0xFFFFFFFF))[0])


def real_bits(number: float) -> int | None:
    """Give the 32 bits of a floating-point number; None where it has none."""
    try:
        return int(struct.unpack(">i", struct.pack(">f", number))[0]) if math.isfinite(number) else None
    except OverflowError:
        return None


def _reals(function: Callable[..., float | None]) -> Rule:
    def lifted(*bits: int) -> int | None:
        result = function(*(real(one) for one in bits))
        return None if result is None else real_bits(result)

    return Rule(function=lifted)


def _quotient(a: int, b: int) -> int | None:
    """Divide towards zero, as every PLC does."""
    if not b:
        return None
    return abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)


def _rest(a: int, b: int) -> int | None:
    quotient = _quotient(a, b)
    return None if quotient is None else a - quotient * b


def _halves(a: int, b: int) -> int | None:
    """Divide two 16-bit numbers into one double word: the rest high, the quotient low."""
    quotient, rest = _quotient(a, b), _rest(a, b)
    return None if quotient is None or rest is None else (rest & 0xFFFF) << 16 | quotient & 0xFFFF


def _left(size: int) -> Callable[[int, int], int]:
    return lambda value, count: (value & ((1 << size) - 1)) << min(max(count, 0), size)


def _right(size: int) -> Callable[[int, int], int]:
    return lambda value, count: (value & ((1 << size) - 1)) >> min(max(count, 0), size)


def _turn(size: int, way: int) -> Callable[[int, int], int]:
    def turned(value: int, count: int) -> int:
        places = way * count % size
        value &= (1 << size) - 1
        return (value << places | value >> (size - places)) & ((1 << size) - 1)

    return turned


RULES: dict[str, Rule] = {
    "move": Rule(lambda a: a, flags=False, wraps=True),
    "add": Rule(lambda a, b: a + b),
    "sub": Rule(lambda a, b: a - b),
    "mul": Rule(function=lambda a, b: a * b),
    "div": Rule(function=_quotient),
    "rem": Rule(function=_rest),
    "divmod": Rule(function=_halves, wraps=True),
    "and": Rule(function=lambda a, b: a & b, wraps=True),
    "or": Rule(function=lambda a, b: a | b, wraps=True),
    "xor": Rule(function=lambda a, b: a ^ b, wraps=True),
    "not": Rule(function=lambda a: ~a, wraps=True),
    "neg": Rule(function=lambda a: -a),
    "sqrt": Rule(function=lambda a: math.isqrt(a) if a >= 0 else None),
    "radd": _reals(lambda a, b: a + b),
    "rsub": _reals(lambda a, b: a - b),
    "rmul": _reals(lambda a, b: a * b),
    "rdiv": _reals(lambda a, b: a / b if b else None),
    "rsqrt": _reals(lambda a: math.sqrt(a) if a >= 0 else None),
    "to_real": Rule(function=lambda a: real_bits(float(a)), flags=False),
    "round": Rule(function=lambda a: math.floor(real(a) + 0.5) if math.isfinite(real(a)) else None),
    "trunc": Rule(function=lambda a: math.trunc(real(a)) if math.isfinite(real(a)) else None),
    "inc": Rule(function=lambda a: a + 1),
    "dec": Rule(function=lambda a: a - 1),
}
for _size in (8, 16, 32):
    RULES[f"shl{_size}"] = Rule(function=_left(_size), wraps=True)
    RULES[f"shr{_size}"] = Rule(function=_right(_size), wraps=True)
    RULES[f"rol{_size}"] = Rule(function=_turn(_size, 1), wraps=True)
    RULES[f"ror{_size}"] = Rule(function=_turn(_size, -1), wraps=True)


def worked(doing: Evaluation[Any], op: str, sources: Operands, target: tuple[Address, Kind], power: Any) -> None:
    """Write the result to the target where there is power, with its flags; ENO says whether it went well.

    Where the result does not fit, or there is none, a family either keeps the target as it was or cuts the result off.
    """
    world, domain, rule = doing.world, doing.world.domain, RULES[op]
    words = [world.word(arg, kind) for arg, kind in sources]
    for arg, _ in sources:
        if isinstance(arg, Address):
            doing.seen.append((arg, words[[one for one, _ in sources].index(arg)]))
    exact = rule.formula(*words) if rule.formula else domain.apply(rule.function, *words)
    place, kind = target
    size = place.size or kind.size
    old = world.word(place, kind)
    result = exact.wrap(size, signed=kind.signed)
    fits = domain.one if rule.wraps else result.eq(exact)
    divides = _divides(world, op, words)
    done = power & divides if world.dialect.wraps else power & fits & divides
    doing.written.append((place, domain.pick(done, result, old)))
    doing.kept.append(("ENO", power & fits & divides))
    if rule.flags:
        _flags(doing, power, (exact, result), (fits, divides))


def _divides(world: Any, op: str, words: list[Any]) -> Any:
    """Say whether a division has a divisor."""
    if op not in {"div", "rem", "divmod", "rdiv"}:
        return world.domain.one
    return ~words[-1].eq(world.domain.number(0))


def _flags(doing: Evaluation[Any], power: Any, values: tuple[Any, Any], went: tuple[Any, Any]) -> None:
    """Leave the flags of a result, in the bits that the family has for them."""
    world, domain = doing.world, doing.world.domain
    (exact, result), (fits, divides) = values, went
    zero = domain.number(0)
    found = {
        "zero": result.eq(zero) & fits & divides,
        "negative": ~result.ge(zero) & fits & divides,
        "overflow": ~fits,
        "divide": ~divides,
        "borrow": ~fits & ~exact.ge(zero),
        "carry": ~fits & exact.ge(zero),
    }
    for name, value in found.items():
        if name in world.dialect.flags:
            flag = world.dialect.address(world.dialect.flags[name])
            doing.written.append((flag, domain.pick(power, value, world.bit(flag))))


def number_of(value: Value, *, as_real: bool) -> int | None:
    """Give the bits of a constant as a whole number; a real operand takes 2 as 2.0."""
    return real_bits(float(value.number)) if as_real else int(value.number)
