"""The timers of all families: one that switches on late, one that switches off late, one that gives a pulse.

A timer remembers how many ms it has counted; what the list sees as its current value is that over its time base. It is
brought up to date in two moves: `ticked` adds the time that has passed, `DRIVES` looks at the input. A timer that starts in
this scan has not yet been going, so the scan that starts it adds nothing.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.machine.words import Domain


@dataclass(frozen=True, slots=True)
class Clock:
    """A timer: its output bit, the ms it has counted, whether it is counting, its input the last time, and its goal in ms."""

    bit: Any
    ms: Any
    going: Any
    was: Any
    goal: Any


def ticked(domain: Domain[Any], clock: Clock, dt: Any, op: str, top: Any) -> Clock:
    """Let `dt` ms pass: an on-delay counts up to `top` and is due at its goal, the others stop at their goal."""
    if op in {"on", "retentive"}:
        ms = clock.ms + dt
        ms = domain.pick(clock.going, domain.pick(ms.ge(top), top, ms), clock.ms)
        return replace(clock, ms=ms, bit=domain.pick(clock.going, ms.ge(clock.goal), clock.bit))
    ms = clock.ms + dt
    ms = domain.pick(clock.going, domain.pick(ms.ge(clock.goal), clock.goal, ms), clock.ms)
    due = clock.going & ms.ge(clock.goal)
    return replace(clock, ms=ms, bit=clock.bit & ~due, going=clock.going & ~due)


def _on(domain: Domain[Any], clock: Clock, power: Any, goal: Any) -> Clock:
    """Count while there is power, and be on from the goal; without power nothing remains."""
    ms = domain.pick(power, clock.ms, domain.number(0))
    return replace(clock, ms=ms, goal=goal, going=power, was=power, bit=power & (clock.bit | ms.ge(goal)))


def _retentive(domain: Domain[Any], clock: Clock, power: Any, goal: Any) -> Clock:
    """Count while there is power; without power hold both the time and the bit."""
    del domain
    return replace(clock, goal=goal, going=power, was=power, bit=clock.bit | power & clock.ms.ge(goal))


def _off(domain: Domain[Any], clock: Clock, power: Any, goal: Any) -> Clock:
    """Be on with the power; when it goes, count, and be off from the goal."""
    falls = clock.was & ~power & clock.bit
    ms = domain.pick(power | falls, domain.number(0), clock.ms)
    going = (clock.going | falls) & ~power
    due = going & ms.ge(goal)
    return Clock(power | clock.bit & ~due, ms, going & ~due, power, goal)


def _pulse(domain: Domain[Any], clock: Clock, power: Any, goal: Any) -> Clock:
    """Begin a pulse when the power comes, whatever it does meanwhile; afterwards the time stays until the power goes."""
    starts = power & ~clock.was & ~clock.going
    ms = domain.pick(starts | ~power & ~clock.going, domain.number(0), clock.ms)
    return Clock(clock.bit | starts, ms, clock.going | starts, power, domain.pick(starts, goal, clock.goal))


DRIVES: dict[str, Callable[[Domain[Any], Clock, Any, Any], Clock]] = {
    "on": _on,
    "retentive": _retentive,
    "off": _off,
    "pulse": _pulse,
}
