"""Drums, step counters and queues: blocks that hold a place in a row, or words in a line."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from plcteach.machine.counters import Ends, counted

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.machine.words import Domain

WORDS = 16


def turned(domain: Domain[Any], step: Any, pins: dict[str, Any], steps: int) -> Any:
    """Turn a drum of so many steps one step on, round at the end; R puts it back to step 0."""
    ends = Ends(domain.number(0), domain.number(steps - 1), round=True)
    return domain.pick(pins["R"], domain.number(0), counted(domain, step, pins["U"], domain.zero, ends))


def control_bits(domain: Domain[Any], step: Any, table: Sequence[str]) -> list[Any]:
    """Give the control bits of a drum in its step: `table` has a row of 0 and 1 for each step."""
    here = [step.eq(domain.number(number)) for number in range(len(table))]
    found = []
    for place in range(max(map(len, table), default=0)):
        bit = domain.zero
        for row, active in zip(table, here, strict=True):
            bit = bit | active if row[place : place + 1] == "1" else bit
        found.append(bit)
    return found


def stepped(domain: Domain[Any], step: Any, pins: dict[str, Any]) -> Any:
    """Move a step counter one step up or down; at either end it stays; R puts it back to step 0."""
    ends = Ends(domain.number(0), domain.number(255))
    return domain.pick(pins["R"], domain.number(0), counted(domain, step, pins["CU"], pins["CD"], ends))


Queue = tuple[list[Any], Any, Any]
"""The words of a queue, how many of them hold something, and the word that was taken last."""


def queued(domain: Domain[Any], queue: Queue, pins: dict[str, Any], given: Any, *, last_first: bool) -> Queue:
    """Store a word or take one; both at once do neither. First in, first out: the words move down. Last in: a pointer moves."""
    words, count, out = queue
    zero, one, most = domain.number(0), domain.number(1), domain.number(WORDS)
    store = pins["I"] & ~pins["O"] & ~pins["R"] & ~count.ge(most)
    take = pins["O"] & ~pins["I"] & ~pins["R"] & count.ge(one)
    top = count - one
    newest = words[0]
    for place in range(1, WORDS):
        newest = domain.pick(top.eq(domain.number(place)), words[place], newest)
    out = domain.pick(take, newest if last_first else words[0], out)
    after = []
    for place, word in enumerate(words):
        kept = word
        if not last_first:
            kept = domain.pick(take, words[place + 1] if place + 1 < WORDS else zero, word)
        after.append(domain.pick(store & count.eq(domain.number(place)), given, kept))
    count = domain.pick(store, count + one, domain.pick(take, top, count))
    return after, domain.pick(pins["R"], zero, count), out
