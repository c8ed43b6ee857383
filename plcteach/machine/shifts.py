"""Rows of bits that move by one or more places: what enters, what falls out."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from plcteach.core.area import Address

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.core.verb import Verb
    from plcteach.machine.evaluation import Evaluation


def moved(row: Sequence[Any], entering: Sequence[Any], *, up: bool) -> list[Any]:
    """Give a row of bits (lowest first) after the entering bits have pushed it up (down) by as many places."""
    if up:
        return [*entering, *row][: len(row)]
    return [*row, *entering][len(entering) :]


def shifted(doing: Evaluation[Any], verb: Verb, power: Any) -> None:
    """Shift the row of bits that begins at the target, where there is power.

    "row": the operands are the entering bit and a signed length, and the bit that falls out goes to the overflow flag.
    "left", "right": the operands are the first entering bit, the length of the row and how many enter.
    """
    world, target = doing.world, doing.bound(verb.target)
    given = [doing.bound(name) for name in verb.sources]
    if not isinstance(target, Address) or not isinstance(given[0], Address):
        return
    numbers = [_whole(one) for one in given[1:]]
    up = verb.op == "left" or (verb.op == "row" and numbers[0] > 0)
    count = 1 if verb.op == "row" else numbers[1]
    places = list(world.following(target, abs(numbers[0])))
    row = [world.bit(place) for place in places]
    entering = [world.bit(place) for place in world.following(given[0], count)]
    doing.seen += zip(world.following(given[0], count), entering, strict=True)
    result = moved(row, entering, up=up)
    doing.written += [
        (place, world.domain.pick(power, new, old)) for place, new, old in zip(places, result, row, strict=True)
    ]
    doing.kept.append(("ENO", power))
    if verb.op == "row" and "overflow" in world.dialect.flags and row:
        flag = world.dialect.address(world.dialect.flags["overflow"])
        doing.written.append((flag, world.domain.pick(power, row[-1] if up else row[0], world.bit(flag))))


def _whole(given: Any) -> int:
    return given if isinstance(given, int) else int(given.number)
