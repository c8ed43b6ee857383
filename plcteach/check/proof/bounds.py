"""How large a remembered number can get as far as anybody can tell: its value beyond the last one compared with does not matter.

A timer that is compared with its preset only may stop counting there, and nobody will ever know. Without such bounds a proof
would have to count to 32767 in every timer. A number that is read in any other way keeps all its bits.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plcteach.core.program import Compare, Value
from plcteach.machine.registers import WORDS
from plcteach.machine.store import Store, owner

if TYPE_CHECKING:
    from plcteach.core.area import Address
    from plcteach.core.program import Line, Program

_WORD, _MOST, _LAST_STEP = 16, 32767, 255
_DRIVING = {"drive", "pin", "update", "open", "set", "reset", "coil"}


@dataclass(frozen=True, slots=True)
class Bound:
    """The range of one remembered number: so many bits, one of them a sign or not; `most` where it may be held there."""

    size: int
    signed: bool = False
    most: int | None = None


def bounds(program: Program, store: Store[Any], keys: list[str]) -> dict[str, Bound]:
    """Give the bound of each remembered number; times are in the store's unit."""
    uses = _uses(program)
    return {key: _bound(store, key, uses) for key in keys}


def natural(store: Store[Any], key: str) -> Bound:
    """Give the range in which the machine itself keeps a number, whatever the program does with it."""
    return _bound(store, key, {})


@dataclass(slots=True)
class _Use:
    """How one block's number is used: with which constants it is compared, and whether in any other way."""

    presets: list[int]
    compared: list[int]
    op: str = ""
    otherwise: bool = False


def _uses(program: Program) -> dict[str, _Use]:
    """Look through a program for what becomes of each block's number."""
    found: dict[str, _Use] = {}
    dialect = program.dialect
    for line in program.lines:
        for place in line.places:
            if dialect.block(place) is None:
                continue
            use = found.setdefault(dialect.whole(place).text, _Use([], []))
            _note(use, line, place)
    return found


def _note(use: _Use, line: Line, place: Address) -> None:
    """Note what one line does with a block."""
    for verb, target in line.targets:
        if target == place and verb.name in _DRIVING:
            use.op = verb.op or use.op
            given = line.bound.get(verb.sources[0]) if verb.sources and verb.name == "drive" else None
            if isinstance(given, Value | int):
                use.presets.append(int(given.number if isinstance(given, Value) else given))
            elif given is not None:
                use.otherwise = True
            return
    for arg in line.args:
        if isinstance(arg, Compare) and place in (arg.left, arg.right):
            other = arg.right if arg.left == place else arg.left
            if isinstance(other, Value) and isinstance(other.number, int):
                use.compared.append(other.number)
                return
    use.otherwise |= place.size != 1


def _bound(store: Store[Any], key: str, uses: dict[str, _Use]) -> Bound:
    place = owner(store.dialect, key)
    block = store.dialect.block(place) if place else None
    if place is None or block is None:
        return Bound(max(store.dialect.area(place).size, _WORD) if place else 2 * _WORD, signed=True)
    whole = store.dialect.whole(place)
    use = uses.get(whole.text, _Use([], [], otherwise=True))
    match block.rule, key.removeprefix(whole.text):
        case "timer", ".ms" | ".goal" as name:
            return _timed(store, whole, use, clamped=name == ".ms")
        case "counter", ".V":
            return _counted(store, whole, use)
        case "drum" | "steps" | "queue" as rule, ".S" | "#":
            steps = len(store.setting(whole, "STEPS")) if rule == "drum" else 0
            return _upto({"drum": max(steps - 1, 1), "steps": _LAST_STEP, "queue": WORDS}[rule])
    return Bound(_WORD, signed=True)


def _upto(most: int, *, held: bool = False) -> Bound:
    return Bound(most.bit_length(), most=most if held else None)


def _presets(store: Store[Any], whole: Address, use: _Use) -> list[int] | None:
    """Give all presets that a block can have; None where a program can change them."""
    if use.otherwise:
        return None
    field = f"{whole.text}.P"
    block = store.dialect.block(whole)
    if use.presets or block is None or not block.preset:
        return use.presets
    return [store.initial(field)]


def _timed(store: Store[Any], whole: Address, use: _Use, *, clamped: bool) -> Bound:
    base, block = store.base(whole), store.dialect.block(whole)
    presets = _presets(store, whole, use)
    if presets is None or block is None or min(presets, default=0) < 0:
        return Bound(((block.most if block else _MOST) * base).bit_length(), signed=True)
    most = max([one * base for one in presets] + [(one + 1) * base for one in use.compared] + [1])
    return _upto(min(most, block.most * base), held=clamped)


def _counted(store: Store[Any], whole: Address, use: _Use) -> Bound:
    bank, block = store.dialect.bank(whole), store.dialect.block(whole)
    presets = _presets(store, whole, use)
    both_ways = use.op not in {"up", "upto", "down"} or bank.size > _WORD or block is None
    if both_ways or presets is None or min(presets, default=0) < 0:
        return Bound(bank.size or _WORD, signed=True)
    most = max([*presets, *(one + 1 for one in use.compared), 1])
    return _upto(most, held=use.op == "up")
