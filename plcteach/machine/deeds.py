"""What each verb of an instruction does: the bits and words it writes, the block it drives, or what it asks of the program's course.

Nothing here changes anything: a deed reads through the world and leaves what is to be written in the evaluation. No deed asks
in Python what a signal holds, so that the same deeds serve one case, a thousand timelines and a proof.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from plcteach.core.area import Address
from plcteach.core.program import Assign
from plcteach.machine.arithmetic import ordered, worked
from plcteach.machine.blocks import cleared, driven
from plcteach.machine.shifts import shifted

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.core.verb import Verb
    from plcteach.machine.evaluation import Evaluation


def _coil(doing: Evaluation[Any], verb: Verb) -> None:
    """Write the value to the bit, or to the bits that follow it."""
    power, target = doing.power(verb.formula), doing.bound(verb.target)
    if isinstance(target, Address):
        doing.written.append((target, power))


def _latch(doing: Evaluation[Any], verb: Verb) -> None:
    """Set or reset some bits, where there is power; a timer, counter or word that is reset loses its value as well."""
    power: Any = doing.power(verb.formula)
    target = doing.bound(verb.target)
    count = doing.bound(verb.count) if verb.count else 1
    if not isinstance(target, Address) or not isinstance(count, int):
        return
    operand = doing.operand(verb.target)
    for place in _stretch(doing, verb, target, count):
        if not doing.world.spells and verb.name == "reset" and cleared(doing, place, power):
            continue
        was = doing.world.read(operand, place)
        doing.written.append((place, was | power if verb.name == "set" else was & ~power))
    if verb.name == "set":
        doing.asks.append((verb, power))


def _stretch(doing: Evaluation[Any], verb: Verb, target: Address, count: int) -> tuple[Address, ...]:
    """Give the addresses that a set or reset works on: so many, or up to another of the same area."""
    last = doing.bound(verb.sources[0]) if verb.sources else None
    if isinstance(last, Address) and last.area == target.area:
        count = max(1, last.index - target.index + 1)
    places: tuple[Address, ...] = doing.world.following(target, count)
    return places


def _work(doing: Evaluation[Any], verb: Verb) -> None:
    """Work out a word."""
    if doing.world.spells:
        return
    power, target = doing.power(verb.formula), doing.bound(verb.target)
    if isinstance(target, Assign):
        kind = doing.world.dialect.kinds[target.kind]
        worked(doing, target.op, [(one, kind) for one in target.sources], (target.target, kind), power)
    elif isinstance(target, Address):
        kinds = doing.world.dialect.kinds
        sources = [
            (doing.bound(name), kinds.get(doing.operand(name).kind))
            for name in verb.sources
            if doing.bound(name) is not None
        ]
        if verb.op == "compare":
            ordered(doing, sources, target, power)
            return
        worked(doing, verb.op, sources, (target, kinds[doing.operand(verb.target).kind]), power)


def _shift(doing: Evaluation[Any], verb: Verb) -> None:
    """Shift a row of bits."""
    if not doing.world.spells:
        shifted(doing, verb, doing.power(verb.formula))


def _drive(doing: Evaluation[Any], verb: Verb) -> None:
    """Bring a block up to date with its pins."""
    target = doing.bound(verb.target)
    if isinstance(target, Address) and not doing.world.spells:
        pins = {name: doing.power(formula) for name, formula in verb.pins}
        driven(doing, verb.op, target, pins, doing.bound(verb.sources[0]) if verb.sources else None)


def _pin(doing: Evaluation[Any], verb: Verb) -> None:
    """Put a value on a block's pin: kept until the block's section ends, or acted on at once outside of one."""
    target, power = doing.bound(verb.target), doing.power(verb.formula)
    if not isinstance(target, Address) or doing.world.spells:
        return
    if doing.world.open_block == target.text:
        doing.asks.append((verb, power))
    else:
        driven(doing, "", target, {verb.op: power}, None)


def _update(doing: Evaluation[Any], verb: Verb) -> None:
    """End a block's input section: the block acts on the pins it was given, the others being 0."""
    target = doing.bound(verb.target)
    doing.asks.append((verb, None))
    if isinstance(target, Address) and not doing.world.spells and doing.world.open_block == target.text:
        block = doing.world.dialect.block(target)
        zero = doing.world.domain.zero
        driven(doing, "", target, {name: doing.world.pins.get(name, zero) for name in block.pins}, None)


def ask(doing: Evaluation[Any], verb: Verb) -> None:
    """Leave it to the program's course."""
    doing.asks.append((verb, doing.power(verb.formula)))


def _master(doing: Evaluation[Any], verb: Verb) -> None:
    """Write the master contact, and leave the rest to the program's course."""
    power, target = doing.power(verb.formula), doing.bound("out")
    if isinstance(target, Address):
        doing.written.append((target, power))
    doing.asks.append((verb, power))


DEEDS: dict[str, Callable[[Evaluation[Any], Verb], None]] = {
    "coil": _coil,
    "set": _latch,
    "reset": _latch,
    "work": _work,
    "shift": _shift,
    "drive": _drive,
    "pin": _pin,
    "update": _update,
    "master": _master,
}
"""Every other verb is left to the program's course."""
