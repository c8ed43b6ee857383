"""One scan over any signal, and the addresses and values by which a caller speaks of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

from plcteach.core.area import Address
from plcteach.core.errors import UnknownNameError
from plcteach.machine.course import Course
from plcteach.machine.signals import ONE, ZERO, Column, Signal, X
from plcteach.machine.store import Memory
from plcteach.machine.words import BITS, UNKNOWN, Domain, Number
from plcteach.machine.world import Plant

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.machine.step import Step

S = TypeVar("S", bound=Signal)


def sweep(
    program: Program,
    memory: Memory[S],
    inputs: Mapping[str, Any],
    domain: Domain[S],
    watch: Callable[[int, Step[S]], None] | None = None,
    *,
    ms: int = 0,
    found: list[Diagnostic] | None = None,
) -> Memory[S]:
    """Run one scan over any signal and give the memory after it; `watch` sees each step with its line number.

    ms: the time since the last scan began.  found: takes what the run itself has to say (a loop that ran away).
    """
    course = Course(Plant(program, memory, inputs, domain, ms))
    for number, one in course.steps():
        if watch:
            watch(number, one)
    if found is not None:
        found += course.found
    return course.world.after()


def normal(dialect: Dialect, word: str) -> str:
    """Give the canonical spelling of an address; UnknownNameError if the family has none such."""
    return address_of(dialect, word).text


def address_of(dialect: Dialect, word: str) -> Address:
    """Give the address that a word spells; UnknownNameError if the family has none such."""
    found = dialect.address(word)
    if isinstance(found, Address) and found.size:
        return found
    kind = f"{dialect.name} address"
    raise UnknownNameError(kind, word, (area.first for area in dialect.areas))


def spread(program: Program, place: Address, value: Any) -> dict[str, Any]:
    """Turn a given value into the bits or numbers in which the machine keeps it."""
    if place.size == 1 and not (place.field and program.dialect.area(place).digits):
        return {place.text: _bit(value)}
    number = UNKNOWN if value == "x" else Number(int(value))
    plant = Plant(program, Memory(), {}, BITS)
    plant.bits.clear()
    plant.store(place, number)
    return {**plant.bits, **plant.words}


def _bit(value: object) -> Column:
    return X if value == "x" else ONE if value in (1, "1") else ZERO
