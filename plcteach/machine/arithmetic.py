"""Words worked out from words: where the operands come from, what the target keeps, and the flags that are left.

How a result is made stands in `sums`. Where it does not fit, or there is none, a family either keeps the target as it was or
cuts the result off.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from plcteach.core.area import Address, Kind
from plcteach.machine.sums import RULES, Rule, real_bits

if TYPE_CHECKING:
    from plcteach.core.program import Value
    from plcteach.machine.evaluation import Evaluation

Operands = list[tuple[Any, Kind | None]]


def worked(doing: Evaluation[Any], op: str, sources: Operands, target: tuple[Address, Kind], power: Any) -> None:
    """Write the result to the target where there is power, with its flags; ENO says whether it went well."""
    world, domain, rule = doing.world, doing.world.domain, RULES[op]
    words = _read(doing, sources)
    exact, answered = rule.exact(domain, words)
    place, kind = target
    size = kind.size if place.field == "K" else min(place.size, kind.size) or kind.size
    result = exact.wrap(size, signed=kind.signed)
    fits = answered if rule.wraps else answered & result.eq(exact)
    if rule.keeps_sign:
        result = domain.join((*exact.bits(size - 1), ~exact.ge(domain.number(0))))
    divides = ~words[-1].eq(domain.number(0)) if rule.divides else domain.one
    if rule.divides and kind.real:
        divides = divides & ~words[-1].eq(domain.number(_MINUS_ZERO))
    went = divides & (answered if world.dialect.wraps else fits)
    doing.written.append(
        (place, domain.pick(power & went, _among(domain, result, (world, place, size)), world.word(place)))
    )
    doing.kept.append(("ENO", power & fits & divides))
    _flags(doing, rule, power, (exact, result, fits, divides))
    if rule.out:
        _fallen(doing, rule, power, words)


_MINUS_ZERO = -(1 << 31)


def _read(doing: Evaluation[Any], sources: Operands) -> list[Any]:
    """Give the words that the operands stand for, and note what was read."""
    words = [doing.world.word(arg, kind) for arg, kind in sources]
    doing.seen += [(arg, word) for (arg, _), word in zip(sources, words, strict=True) if isinstance(arg, Address)]
    return words


def _among(domain: Any, result: Any, into: tuple[Any, Address, int]) -> Any:
    """Put a result into the low part of a wider register, whose other bits stay [rec]."""
    world, place, size = into
    if size >= place.size:
        return result
    return domain.join((*result.bits(size), *world.word(place).bits(place.size)[size:]))


def ordered(doing: Evaluation[Any], sources: Operands, target: Address, power: Any) -> None:
    """Say in three bits where the last word lies: below the first, at or between the others, or above them.

    Two words are the number compared with and the number itself; of three, an upper end below the lower one counts as equal.
    """
    world, domain = doing.world, doing.world.domain
    words = _read(doing, sources)
    low, value = words[0], words[-1]
    high = domain.pick(words[-2].ge(low), words[-2], low)
    found = (~value.ge(low), value.ge(low) & high.ge(value), ~high.ge(value))
    for place, bit in zip(world.following(target, len(found)), found, strict=False):
        doing.written.append((place, domain.pick(power, bit, world.bit(place))))


def _flags(doing: Evaluation[Any], rule: Rule, power: Any, made: tuple[Any, Any, Any, Any]) -> None:
    """Leave the flags of a result in the bits that the family has for them; a division by zero leaves the others alone."""
    world, domain = doing.world, doing.world.domain
    exact, result, fits, divides = made
    zero = domain.number(0)
    shown = domain.apply(rule.shown, result) if rule.shown else result
    found = {
        "zero": shown.eq(zero) & (domain.one if rule.keeps_sign else fits),
        "negative": ~shown.ge(zero) & fits,
        "overflow": ~fits,
        "borrow": ~fits & ~exact.ge(zero),
        "carry": ~fits & exact.ge(zero),
        "divide": ~divides,
    }
    if world.dialect.flags.get("divide") == world.dialect.flags.get("overflow"):
        found |= dict.fromkeys(("overflow", "divide"), ~fits | ~divides)
    for name in rule.flags:
        if name in world.dialect.flags:
            flag = world.dialect.address(world.dialect.flags[name])
            where = power if name == "divide" else power & divides
            doing.written.append((flag, domain.pick(where, found[name], world.bit(flag))))


def _fallen(doing: Evaluation[Any], rule: Rule, power: Any, words: list[Any]) -> None:
    """Keep the bit that fell out last, in a flag of its own or in that of an overflow; where none fell out the flag stays."""
    world, domain, out = doing.world, doing.world.domain, rule.out
    name = world.dialect.flags.get("out", world.dialect.flags.get("overflow"))
    if out is None or name is None:
        return
    flag = world.dialect.address(name)
    fallen = domain.apply(lambda value, count: _NOTHING if (bit := out(value, count)) is None else bit, *words)
    falls, bit = ~fallen.eq(domain.number(_NOTHING)), fallen.eq(domain.number(1))
    doing.written.append((flag, domain.pick(power & falls, bit, world.bit(flag))))


_NOTHING = 2
"""No bit, where the bit that fell out is asked for."""


def number_of(value: Value, *, as_real: bool) -> int | None:
    """Give the bits of a constant as a whole number; a real operand takes 2 as 2.0."""
    return real_bits(float(value.number)) if as_real else int(value.number)
