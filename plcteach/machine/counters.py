"""The counters of all families: one count with its ends, and what each family reads from it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from plcteach.machine.words import Domain


@dataclass(frozen=True, slots=True)
class Ends:
    """Between which numbers a count runs, and whether it goes round at the ends or stops there."""

    low: Any
    high: Any
    round: bool = False


def counted(domain: Domain[Any], value: Any, up: Any, down: Any, ends: Ends) -> Any:
    """Count one up, one down, or neither; both at once cancel each other."""
    one = domain.number(1)
    at_top, at_bottom = value.ge(ends.high), ends.low.ge(value)
    upper = domain.pick(at_top, ends.low if ends.round else value, value + one)
    lower = domain.pick(at_bottom, ends.high if ends.round else value, value - one)
    return domain.pick(up & ~down, upper, domain.pick(down & ~up, lower, value))


@dataclass(frozen=True, slots=True)
class Count:
    """A counter afterwards: its current value and its output bits by name."""

    value: Any
    bits: dict[str, Any]


def up(domain: Domain[Any], value: Any, pins: dict[str, Any], preset: Any, most: int) -> Count:
    """Count up to the largest number; the bit is on from the preset; R clears both."""
    ends = Ends(domain.number(0), domain.number(most))
    value = domain.pick(pins["R"], domain.number(0), counted(domain, value, pins["CU"], domain.zero, ends))
    return Count(value, {"": value.ge(preset) & ~pins["R"]})


def up_to(domain: Domain[Any], value: Any, pins: dict[str, Any], preset: Any, bit: Any) -> Count:
    """Count up to the preset and stay there; the bit comes on with the count that reaches it, and stays.

    A value that was written beyond the preset becomes the preset with the next count (FX programming manual).
    """
    one = domain.number(1)
    preset = domain.pick(preset.ge(one), preset, one)
    reaches = pins["CU"] & (value + one).ge(preset)
    value = domain.pick(reaches, preset, domain.pick(pins["CU"], value + one, value))
    return Count(value, {"": bit | reaches})


def down(domain: Domain[Any], value: Any, pins: dict[str, Any], preset: Any) -> Count:
    """Count from the preset, which LD loads, down to 0, and be on there."""
    ends = Ends(domain.number(0), domain.number(32767))
    value = domain.pick(pins["LD"], preset, counted(domain, value, domain.zero, pins["CD"], ends))
    return Count(value, {"": ~pins["LD"] & domain.number(0).ge(value)})


def up_down(domain: Domain[Any], value: Any, pins: dict[str, Any], preset: Any) -> Count:
    """Count both ways, round from 32767 to -32768 and back; the bit is on from the preset; R clears both."""
    ends = Ends(domain.number(-32768), domain.number(32767), round=True)
    value = domain.pick(pins["R"], domain.number(0), counted(domain, value, pins["CU"], pins["CD"], ends))
    return Count(value, {"": value.ge(preset) & ~pins["R"]})


def ring(domain: Domain[Any], value: Any, pins: dict[str, Any], preset: Any, bit: Any) -> Count:
    """Count 32 bits both ways; the bit comes on where the preset is passed upwards and goes off where it is passed downwards."""
    ends = Ends(domain.number(-(2**31)), domain.number(2**31 - 1), round=True)
    rises, falls = pins["CU"] & ~pins["DOWN"], pins["CU"] & pins["DOWN"]
    after = counted(domain, value, rises, falls, ends)
    return Count(after, {"": bit & ~(falls & value.eq(preset)) | rises & after.eq(preset)})


def preset_both_ways(domain: Domain[Any], value: Any, pins: dict[str, Any], preset: Any, bits: dict[str, Any]) -> Count:
    """Count 0 to 9999 both ways and round: D where the preset stands, F after 9999 to 0, E after 0 to 9999.

    R clears all, then S loads the preset; F and E stay until the next count.
    """
    zero, most = domain.number(0), domain.number(9999)
    after = counted(domain, value, pins["CU"], pins["CD"], Ends(zero, most, round=True))
    moves = (pins["CU"] ^ pins["CD"]) & ~pins["S"]
    over = pins["CU"] & ~pins["CD"] & value.ge(most)
    under = pins["CD"] & ~pins["CU"] & zero.ge(value)
    after = domain.pick(pins["R"], zero, domain.pick(pins["S"], preset, after))
    calm = ~pins["R"]
    full = domain.pick(moves, over, bits["F"]) & calm
    empty = domain.pick(moves, under, bits["E"]) & calm
    return Count(after, {"D": after.eq(preset) & calm, "F": full, "E": empty})
