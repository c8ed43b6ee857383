"""What must agree within a plant: every name is somebody's, no two have the same, and each program's fault can be reported."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from plcteach.core.errors import DeclarationError, nearest

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from plcteach.plants.condition import Condition
    from plcteach.plants.declared import Cycle, Plant


def prove(plant: Plant) -> None:
    """Refuse a plant of which something does not agree; DeclarationError says what, as far as it is seen at once."""
    found = list(dict.fromkeys(_disagreements(plant)))
    if found:
        msg = f"plant {plant.id}: {'; '.join(found)}"
        raise DeclarationError(msg)


def _disagreements(plant: Plant) -> Iterator[str]:
    things = [*(one.name for one in plant.parts), *(one.name for one in plant.items)]
    bits = [*(one.symbol for one in plant.devices), *(one.name for one in plant.latches)]
    yield from _twice([*things, *bits], "the name")
    yield from _twice([one.id for one in plant.hazards], "the fault")
    for sample in plant.samples:
        devices = plant.for_(sample).devices
        yield from _twice([one.address for one in devices if one.address], f"{sample.role}: the address")
        yield from _known((*(sample.addresses or {}), *(sample.wired or {}), *(sample.ways or {})), bits, "device")
        yield from _known([sample.fault] if sample.fault else [], [one.id for one in plant.hazards], "fault")
    seen = [one.what for each in _cycles(plant) for one in each.seen]
    drawn = [one.on for one in plant.drawn if one.on]
    for condition in (*plant.conditions, *seen, *drawn):
        yield from _names(condition, bits, things)
    yield from _travel(plant, bits)
    yield from _picture(plant, bits, things)


def _travel(plant: Plant, bits: list[str]) -> Iterator[str]:
    """Look at workpieces, one-way switches and hands."""
    items = [one.name for one in plant.items]
    parts = [one.name for one in plant.parts]
    yield from _known([name for one in plant.births for name in one.items], items, "kind of workpiece")
    yield from _known(
        [name for one in plant.changes for name in (one.item, one.into) if name], items, "kind of workpiece"
    )
    for sample in plant.samples:
        for one in plant.for_(sample).devices:
            if one.way != "both" and one.along not in parts:
                yield f"{one.symbol} can act one way only if the position of one part actuates it"
    hands = {one.symbol for one in plant.hands}
    for each in _cycles(plant):
        acted = [act.symbol for act in each.acts]
        yield from _known(acted, bits, "device")
        yield from (f"no hand can press {symbol}" for symbol in acted if symbol in bits and symbol not in hands)


def _picture(plant: Plant, bits: list[str], things: list[str]) -> Iterator[str]:
    parts = [one.name for one in plant.parts]
    for one in plant.drawn:
        yield from _known([one.symbol] if one.symbol else [], bits, "device")
        yield from _known((*one.moves, *one.turns), parts, "part")
        yield from _known([one.more["of"]] if "of" in one.more else [], things, "part")


def _cycles(plant: Plant) -> list[Cycle]:
    return [plant.cycle, *(one.cycle for one in plant.samples if one.cycle)]


def _names(condition: Condition, bits: list[str], things: list[str]) -> Iterator[str]:
    for said in (
        *_known(condition.bits, bits, "device or latch"),
        *_known([b.name for b in condition.bounds], things, "part"),
    ):
        yield f"{condition.text!r}: {said}"


def _known(names: Iterable[str], known: list[str], what: str) -> Iterator[str]:
    for name in names:
        if name not in known:
            near = nearest(name, known)
            yield f"there is no {what} {name!r}" + (f" (did you mean {near[0]}?)" if near else "")


def _twice(names: list[str], what: str) -> Iterator[str]:
    yield from (f"{what} {name!r} stands there twice" for name, count in Counter(names).items() if count > 1)
