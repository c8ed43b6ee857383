"""Brings the function blocks up to date: reads what a block remembers, applies its rule, leaves what it is afterwards.

The rules are in timers, counters and registers, once for all families; which of them a block follows, and between which ends,
stands in the dialect's table and in the program's configuration.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from plcteach.machine import counters, registers
from plcteach.machine.shifts import moved
from plcteach.machine.store import PIN
from plcteach.machine.timers import DRIVES, Clock, ticked

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.core.area import Address
    from plcteach.core.program import Arg
    from plcteach.machine.evaluation import Evaluation

Pins = dict[str, Any]

AT_END = "!end"
"""Behind a step counter's name: whether it was asked to go beyond its first or last step in this scan."""


def driven(doing: Evaluation[Any], op: str, target: Address, pins: Pins, preset: Arg | None) -> None:
    """Let a block act on its pins; a pin that is not among them takes no part this time."""
    block = doing.world.dialect.block(target)
    _RULES[block.rule](doing, op, target, pins, preset)


def cleared(doing: Evaluation[Any], place: Address, power: Any) -> bool:
    """Clear a timer, a counter or a word where there is power; False where the address is a mere bit."""
    world, domain = doing.world, doing.world.domain
    block = world.dialect.block(place)
    zero = domain.number(0)
    if block is None or place.field:
        if place.size == 1:
            return False
        doing.written.append((place, domain.pick(power, zero, world.word(place))))
        return True
    doing.written.append((place, world.bit(place) & ~power))
    if block.rule == "timer":
        doing.numbers.append((f"{place.text}.ms", domain.pick(power, zero, world.number(f"{place.text}.ms"))))
        doing.kept.append((f"{place.text}.going", world.kept(f"{place.text}.going") & ~power))
    else:
        value = world.dialect.area(place).part(place, "V")
        doing.written.append((value, domain.pick(power, zero, world.number(value.text))))
    return True


def _field(doing: Evaluation[Any], target: Address, name: str) -> Address:
    """Give the address of one part of a block; "" is the block's own bit."""
    return doing.world.dialect.area(target).part(target, name) if name else target


def _risen(doing: Evaluation[Any], target: Address, pins: Pins, name: str) -> Any:
    """Give the rising edge of a pin since the block last looked at it; a pin that takes no part gives none."""
    if name not in pins:
        return doing.world.domain.zero
    key = f"{target.text}{PIN}{name}"
    doing.kept.append((key, pins[name]))
    return pins[name].edge(doing.world.remembered(key, pins[name]), rising=True)


def clock_of(world: Any, target: Address) -> Clock:
    """Give what a timer remembers."""
    key = target.text
    return Clock(
        world.kept(world.output(target)),
        world.number(f"{key}.ms"),
        world.kept(f"{key}.going"),
        world.kept(f"{key}.was"),
        world.number(f"{key}.goal"),
    )


def ticked_clock(world: Any, target: Address, op: str, dt: Any, goal: Any = None) -> Clock:
    """Give a timer after `dt` ms; `goal`: where its preset is another one by now."""
    block, clock = world.dialect.block(target), clock_of(world, target)
    clock = clock if goal is None else replace(clock, goal=goal)
    top = clock.goal if block.stops else world.domain.number(block.most * world.base(target))
    return ticked(world.domain, clock, dt, op, top)


def _timer(doing: Evaluation[Any], op: str, target: Address, pins: Pins, preset: Arg | None) -> None:
    world = doing.world
    block, bank = world.dialect.block(target), world.dialect.bank(target)
    op = timer_op(world, op, target)
    goal = world.preset(target, preset).times(world.base(target))
    clock = clock_of(world, target)
    if block.latches:
        goal = world.domain.pick(clock.going, clock.goal, goal)
    if bank.when == "line":
        clock = ticked_clock(world, target, op, world.dt, goal)
    after = DRIVES[op](world.domain, clock, pins["IN"], goal)
    doing.written.append((_field(doing, target, block.bit), after.bit))
    doing.kept += [(f"{target.text}.going", after.going), (f"{target.text}.was", after.was)]
    doing.numbers += [(f"{target.text}.ms", after.ms), (f"{target.text}.goal", after.goal)]


def timer_op(world: Any, op: str, target: Address) -> str:
    """Say which rule a timer follows: its instruction's, its configuration's, or what its number makes of it."""
    rule: str = world.dialect.bank(target).rule(op or world.setting(target, "TYPE"))
    return rule


def _counter(doing: Evaluation[Any], op: str, target: Address, pins: Pins, preset: Arg | None) -> None:
    world, domain = doing.world, doing.world.domain
    value = _field(doing, target, "V")
    now, goal = world.number(value.text), world.preset(target, preset)
    edges: Pins = {name: _risen(doing, target, pins, name) for name in ("CU", "CD")}
    levels: Pins = {name: pins.get(name, domain.zero) for name in ("R", "S", "LD")}
    both = edges | levels
    if op == "up":
        after = counters.up(domain, now, both, goal, world.dialect.block(target).most)
    elif op == "down":
        after = counters.down(domain, now, both, goal)
    elif op == "updown":
        after = counters.up_down(domain, now, both, goal)
    elif op == "upto" and world.dialect.bank(target).size == _LONG:
        both["DOWN"] = world.kept(f"{world.dialect.block(target).down}{target.index}")
        after = counters.ring(domain, now, both, goal, world.kept(target.text))
    elif op == "upto":
        after = counters.up_to(domain, now, both, goal, world.kept(target.text))
    else:
        bits = {name: world.kept(f"{target.text}.{name}") for name in "EF"}
        after = counters.preset_both_ways(domain, now, both, goal, bits)
    doing.written.append((value, after.value))
    doing.written += [(_field(doing, target, name), bit) for name, bit in after.bits.items()]


_LONG = 32


def _drum(doing: Evaluation[Any], op: str, target: Address, pins: Pins, preset: Arg | None) -> None:
    """Turn a drum; its control bits are written when the step changes, while R is held, and at cold start."""
    del op, preset
    world, domain = doing.world, doing.world.domain
    table, outputs = world.setting(target, "STEPS"), world.setting(target, "OUT")
    step = _field(doing, target, "S")
    before = world.number(step.text)
    both = {"R": pins.get("R", domain.zero), "U": _risen(doing, target, pins, "U")}
    after = registers.turned(domain, before, both, max(len(table), 1))
    writes = both["R"] | ~after.eq(before) | (domain.zero if world.scans else domain.one)
    doing.written += [(step, after), (_field(doing, target, "F"), after.eq(domain.number(max(len(table), 1) - 1)))]
    for name, bit in zip(outputs, registers.control_bits(domain, after, table), strict=False):
        place = world.dialect.address(name)
        doing.written.append((place, domain.pick(writes, bit, world.bit(place))))


def _bits(doing: Evaluation[Any], op: str, target: Address, pins: Pins, preset: Arg | None) -> None:
    """Shift the sixteen bits of a register up or down; 0 enters; the last bit that fell out is kept in a flag."""
    del op, preset
    world, domain = doing.world, doing.world.domain
    clear = pins.get("R", domain.zero)
    up, down = _risen(doing, target, pins, "CU"), _risen(doing, target, pins, "CD")
    up, down = up & ~down, down & ~up
    places = [_field(doing, target, f"{number}") for number in range(16)]
    row = [world.bit(place) for place in places]
    pairs = zip(places, row, moved(row, [domain.zero], up=True), moved(row, [domain.zero], up=False), strict=True)
    for place, old, higher, lower in pairs:
        shifted = domain.pick(up, higher, domain.pick(down, lower, old))
        doing.written.append((place, shifted & ~clear))
    flag = world.dialect.flags.get("out")
    if flag:
        place = world.dialect.address(flag)
        fallen = domain.pick(up, row[-1], domain.pick(down, row[0], world.bit(place)))
        doing.written.append((place, fallen))


def _steps(doing: Evaluation[Any], op: str, target: Address, pins: Pins, preset: Arg | None) -> None:
    """Move a step counter; which of its bits is 1 is read from its step. A step beyond either end is noted."""
    del op, preset
    domain = doing.world.domain
    both = {"R": pins.get("R", domain.zero)} | {name: _risen(doing, target, pins, name) for name in ("CU", "CD")}
    key = f"{target.text}.S"
    before = doing.world.number(key)
    after = registers.stepped(domain, before, both)
    doing.numbers.append((key, after))
    doing.kept.append((f"{target.text}{AT_END}", (both["CU"] ^ both["CD"]) & ~both["R"] & after.eq(before)))


def _queue(doing: Evaluation[Any], op: str, target: Address, pins: Pins, preset: Arg | None) -> None:
    """Store or take a word."""
    del op, preset
    world, domain = doing.world, doing.world.domain
    both = {"R": pins.get("R", domain.zero)} | {name: _risen(doing, target, pins, name) for name in "IO"}
    keys = [f"{target.text}#{place}" for place in range(registers.WORDS)]
    out = _field(doing, target, "O")
    queue = [world.number(key) for key in keys], world.number(f"{target.text}#"), world.number(out.text)
    given = world.number(_field(doing, target, "I").text)
    words, count, taken = registers.queued(
        domain, queue, both, given, last_first=world.setting(target, "TYPE") == "last"
    )
    doing.numbers += [*zip(keys, words, strict=True), (f"{target.text}#", count)]
    doing.written += [
        (out, taken),
        (_field(doing, target, "E"), domain.number(0).ge(count)),
        (_field(doing, target, "F"), count.ge(domain.number(registers.WORDS))),
    ]


_RULES: dict[str, Callable[[Evaluation[Any], str, Address, Pins, Arg | None], None]] = {
    "timer": _timer,
    "counter": _counter,
    "drum": _drum,
    "bits": _bits,
    "steps": _steps,
    "queue": _queue,
}
