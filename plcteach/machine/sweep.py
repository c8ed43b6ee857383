"""One scan over any signal, and the addresses and values by which a caller speaks of it."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING, Any, TypeVar

from plcteach.core.area import Address
from plcteach.core.errors import PlcTeachError, UnknownNameError
from plcteach.machine.course import Course
from plcteach.machine.signals import ONE, ZERO, Column, Signal, X
from plcteach.machine.store import Memory, in_word
from plcteach.machine.sums import real_bits
from plcteach.machine.words import BITS, UNKNOWN, Domain, Number
from plcteach.machine.world import Plant

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.machine.step import Step

S = TypeVar("S", bound=Signal)

_LONG = 32


def sweep(
    program: Program,
    memory: Memory[S],
    inputs: Mapping[str, Any],
    domain: Domain[S],
    watch: Callable[[Step[S]], None] | None = None,
    *,
    ms: int = 0,
    found: list[Diagnostic] | None = None,
) -> Memory[S]:
    """Run one scan over any signal and give the memory after it; `watch` sees each step.

    ms: the time since the last scan began.  found: takes what the run itself has to say (a loop that ran away).
    """
    course = Course(Plant(program, memory, inputs, domain, ms))
    for one in course.steps():
        if watch:
            watch(one)
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


def spread(program: Program, place: Address, value: Any, memory: Memory[Column] | None = None) -> dict[str, Any]:
    """Turn a given value into the bits or numbers in which the machine keeps it; `memory`: what a word's other bits are."""
    if place.size == 1 and not in_word(program.dialect, place):
        return {place.text: _bit(value, place)}
    plant = Plant(program, memory or Memory(), {}, BITS)
    if place.size == 1:
        plant.store(place, _bit(value, place))
        whole = program.dialect.whole(place).text
        return {whole: plant.number(whole)}
    number = UNKNOWN if value == "x" else _number(program.dialect, place, value)
    plant.bits.clear()
    plant.words.clear()
    plant.store(place, number)
    return {**plant.bits, **plant.words}


def _number(dialect: Dialect, place: Address, value: Any) -> Number:
    """Give a number as a word keeps it; a float for a double word is its 32 bits, in a family that works on reals."""
    if isinstance(value, float) and place.size == _LONG and any(one.real for one in dialect.kinds.values()):
        return Number(real_bits(value))
    if not isinstance(value, int) or not place.fits(value):
        msg = f"{place.text} has {place.size} bits, so it is a whole number that fits there, and not {value!r}"
        raise PlcTeachError(msg)
    return Number(value)


_BITS: dict[object, Column] = {"x": X, 1: ONE, "1": ONE, 0: ZERO, "0": ZERO}


def _bit(value: object, place: Address) -> Column:
    found = _BITS.get(value) if isinstance(value, Hashable) else None
    if found is None:
        msg = f'{place.text} is a bit, so it is 0, 1 or "x", and not {value!r}'
        raise PlcTeachError(msg)
    return found
