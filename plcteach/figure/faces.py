"""The faces of a program's function blocks at one moment, read from their declaration and from what the machine holds.

Which blocks there are stands in the program; what one is called, its pins and its ends stand in the dialect's table.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from plcteach.core.program import Value
from plcteach.core.text import Text
from plcteach.figure.face import Face, Gauge, Grid, Pin, Slot, step_slots, timed
from plcteach.machine.registers import WORDS
from plcteach.machine.shifts import Shift, shift_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from plcteach.core.area import Address
    from plcteach.core.block import Block
    from plcteach.core.program import Arg, Line, Program
    from plcteach.core.verb import Verb
    from plcteach.machine.step import Step
    from plcteach.machine.store import Store

_DRIVES = {"drive", "pin", "update", "shift"}
_MOST_SLOTS = 64


@dataclass(slots=True)
class Blocks:
    """All blocks of one program; `seen` keeps what stood at each pin when its block last looked."""

    program: Program
    found: dict[str, tuple[Address, Line, Verb]] = field(default_factory=dict)
    seen: dict[str, dict[str, str]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Find the blocks that the program drives, in the order in which it does."""
        for line in self.program.lines:
            for verb, target in line.targets:
                if verb.name in _DRIVES:
                    self.found.setdefault(target.text, (target, line, verb))

    def look(self, step: Step[Any]) -> None:
        """Take note of what an instruction puts on a block's pins."""
        for verb, target in step.line.targets:
            if target.text not in self.found:
                continue
            pins = self.seen.setdefault(target.text, {})
            if verb.name == "pin":
                pins[verb.op] = repr(step.before[0][0]) if step.before[0] else ""
            for name, formula in verb.pins:
                place = step.flow.named.get(getattr(formula, "name", ""))
                pins[name] = repr(step.before[place[0]][place[1]]) if place else ""

    def faces(self, store: Store[Any]) -> list[Face]:
        """Give every block's face."""
        return [self.face(store, text) for text in self.found]

    def face(self, store: Store[Any], text: str) -> Face:
        """Give one block's face."""
        target, line, verb = self.found[text]
        if verb.name == "shift":
            return _row(store, target, line, verb)
        block = store.dialect.block(target)
        if block is None:
            return Face(text, "steps", line.insn.title)
        pins = tuple(Pin(name, self.seen.get(text, {}).get(name, "")) for name in _pins(block, verb))
        return _FACES[block.rule](_Shown(store, target, block, line, verb, pins))


@dataclass(frozen=True, slots=True)
class _Shown:
    """One block to be shown: where its values stand, how it is declared, and the line that drives it."""

    store: Store[Any]
    target: Address
    block: Block
    line: Line
    verb: Verb
    pins: tuple[Pin, ...]

    @property
    def title(self) -> Text:
        """What the block is: its type where it is configured or named by its instruction, and its name."""
        settings = self.block.settings or {}
        if "TYPE" in settings:
            said = self.store.program.settings.get(self.target.text, {}).get("TYPE", settings["TYPE"].default)
            return Text(f"{self.block.title.zh} {said}", f"{self.block.title.en} {said}")
        if self.verb.name == "drive" and self.line.insn.word != self.line.insn.mnemonic:
            return self.block.title
        return self.line.insn.title if self.verb.name == "drive" else self.block.title

    def bit(self, name: str) -> Pin:
        """Give an output bit; "" is the block's own."""
        place = self.field(name) if name else self.target
        return Pin(name or self.target.text, repr(self.store.bit(place)))

    def number(self, name: str) -> int | None:
        """Give a number of the block."""
        value: int | None = self.store.number(f"{self.target.text}.{name}").value
        return value

    @property
    def preset(self) -> int | None:
        """The preset, as the line or the block has it."""
        arg: Arg | None = self.line.bound.get(self.verb.sources[0]) if self.verb.sources else None
        if arg is None:
            return self.number("P")
        if isinstance(arg, Value):
            return int(arg.number)
        value: int | None = self.store.word(arg).value
        return value

    def field(self, name: str) -> Address:
        """Give one of the block's fields."""
        return self.store.dialect.area(self.target).part(self.target, name)


def _pins(block: Block, verb: Verb) -> tuple[str, ...]:
    return tuple(name for name, _ in verb.pins) or block.pins


def _timer(one: _Shown) -> Face:
    base = one.store.base(one.target)
    ms = one.number("ms")
    gauge = timed(None if ms is None else ms // base, one.preset, base, most=one.block.most)
    return Face(one.target.text, "timer", one.title, one.pins, (one.bit(one.block.bit),), gauge)


def _counter(one: _Shown) -> Face:
    least = -32768 if one.verb.op == "updown" else 0
    gauge = Gauge(one.number("V"), one.preset, most=one.block.most, least=least)
    outputs = tuple(one.bit(name) for name in one.block.outputs) or (one.bit(""),)
    return Face(one.target.text, "counter", one.title, one.pins, outputs, gauge)


def _drum(one: _Shown) -> Face:
    outputs, table = one.store.setting(one.target, "OUT"), one.store.setting(one.target, "STEPS")
    step = one.number("S")
    grid = Grid(tuple(outputs), tuple(table), -1 if step is None else step)
    return Face(one.target.text, "drum", one.title, one.pins, (one.bit("F"),), grid=grid)


def _bits(one: _Shown) -> Face:
    slots = tuple(Slot(str(place), repr(one.store.bit(one.field(str(place))))) for place in range(16))
    return Face(one.target.text, "shift", one.title, one.pins, slots=slots)


def _steps(one: _Shown) -> Face:
    return Face(one.target.text, "steps", one.title, one.pins, slots=step_slots(one.number("S")))


def _queue(one: _Shown) -> Face:
    store, text = one.store, one.target.text
    last_first = store.setting(one.target, "TYPE") == "last"
    count = store.number(f"{text}#").value or 0
    words = [store.number(f"{text}#{place}") for place in range(WORDS)]
    slots = tuple(
        Slot(str(place), repr(word) if place < count else "", "pointer" if last_first and place == count - 1 else "")
        for place, word in enumerate(words)
    )
    ends = [Pin(f".{name}", repr(store.number(f"{text}.{name}"))) for name in "IO"]
    outputs = (one.bit("E"), one.bit("F"), ends[1])
    return Face(
        text, "queue", one.title, (*one.pins, ends[0]), outputs, slots=slots, way="lifo" if last_first else "fifo"
    )


_FACES: dict[str, Callable[[_Shown], Face]] = {
    "timer": _timer,
    "counter": _counter,
    "drum": _drum,
    "bits": _bits,
    "steps": _steps,
    "queue": _queue,
}


def _row(store: Store[Any], target: Address, line: Line, verb: Verb) -> Face:
    """Give the face of a row of bits that an instruction shifts."""
    shift = shift_of(store.dialect, line, verb) or Shift((), (), up=False)
    slots = tuple(
        Slot(place.text.removeprefix(place.area), repr(store.bit(place))) for place in shift.row[:_MOST_SLOTS]
    )
    pins = (Pin("DATA", repr(store.bit(shift.entering[0])) if shift.entering else ""),)
    return Face(target.text, "shift", line.insn.title, pins, slots=slots, way="left" if shift.up else "right")


def block_names(program: Program) -> Iterator[str]:
    """Give the addresses of the blocks that a program drives."""
    yield from Blocks(program).found
