"""Rows of bits that move by one or more places: what enters, what falls out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plcteach.core.area import Address
from plcteach.core.program import Value

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.core.program import Line
    from plcteach.core.spec import Dialect
    from plcteach.core.verb import Verb
    from plcteach.machine.evaluation import Evaluation


def moved(row: Sequence[Any], entering: Sequence[Any], *, up: bool) -> list[Any]:
    """Give a row of bits (lowest first) after the entering bits have pushed it up (down) by as many places."""
    if up:
        return [*entering, *row][: len(row)]
    return [*row, *entering][len(entering) :]


@dataclass(frozen=True, slots=True)
class Shift:
    """A row of bits, the lowest first, the bits that enter it, and whether they push it up."""

    row: tuple[Address, ...]
    entering: tuple[Address, ...]
    up: bool


def shift_of(dialect: Dialect, line: Line, verb: Verb) -> Shift | None:
    """Say which bits a line shifts, the row beginning at the target; None where it does not name them.

    "row": the operands are the entering bit and a signed length, and the bit that falls out goes to the overflow flag.
    "left", "right": the operands are the first entering bit, the length of the row and how many enter.
    """
    target, data, *rest = (line.bound.get(name) for name in (verb.target, *verb.sources))
    if not isinstance(target, Address) or not isinstance(data, Address):
        return None
    numbers = [one if isinstance(one, int) else int(one.number) for one in rest if isinstance(one, int | Value)]
    up = verb.op == "left" or (verb.op == "row" and numbers[0] > 0)
    count = 1 if verb.op == "row" else numbers[1]
    return Shift(tuple(dialect.following(target, abs(numbers[0]))), tuple(dialect.following(data, count)), up)


def shifted(doing: Evaluation[Any], verb: Verb, power: Any) -> None:
    """Shift a row of bits, where there is power."""
    world = doing.world
    shift = shift_of(world.dialect, doing.line, verb)
    if shift is None:
        return
    row = [world.bit(place) for place in shift.row]
    entering = [world.bit(place) for place in shift.entering]
    doing.seen += zip(shift.entering, entering, strict=True)
    result = moved(row, entering, up=shift.up)
    doing.written += [
        (place, world.domain.pick(power, new, old)) for place, new, old in zip(shift.row, result, row, strict=True)
    ]
    doing.kept.append(("ENO", power))
    if verb.op == "row" and "overflow" in world.dialect.flags and row:
        flag = world.dialect.address(world.dialect.flags["overflow"])
        doing.written.append((flag, world.domain.pick(power, row[-1] if shift.up else row[0], world.bit(flag))))
