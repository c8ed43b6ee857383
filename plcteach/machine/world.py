"""The PLC around the stack during one scan: what the lines read and write, its clocks, its rail and the time that passes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

from plcteach.machine.blocks import ticked_clock, timer_op
from plcteach.machine.plan import plan_of
from plcteach.machine.signals import Signal
from plcteach.machine.store import PIN, REGISTER, SEEN, Memory, Store, in_word

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.area import Address
    from plcteach.core.insn import Operand
    from plcteach.core.program import Program
    from plcteach.machine.step import Step
    from plcteach.machine.words import Domain

S = TypeVar("S", bound=Signal)

_IMMEDIATE = "now"


def beat(what: str, scans: int, now: int) -> int:
    """Give what a moving system bit is after so many scans: a clock is 1 in the second half of its period."""
    return 1 - scans % 2 if what == "turns" else now * 2 // int(what) % 2


class Plant(Store[S]):
    """Everything that a line can read, and that a step is written into; it lives for one scan."""

    spells = False

    def __init__(
        self, program: Program, memory: Memory[S], inputs: Mapping[str, Any], domain: Domain[S], ms: int = 0
    ) -> None:
        super().__init__(program, memory, domain)
        self.inputs = {name: value for name, value in inputs.items() if not hasattr(value, "times")}
        self.memory = memory
        self.scans = memory.scans
        self.now = memory.now + ms
        self.ms = ms
        self.dt = self.lapse(ms)
        self.words: dict[str, Any] = {
            **memory.words,
            **{name: value for name, value in inputs.items() if hasattr(value, "times")},
        }
        self.bits: dict[str, S] = {**memory.bits, **self.inputs, **self.driven()}
        self.past_of_lines = dict(memory.past)
        self.rail: S | None = None
        self.stopped = memory.stopped
        self.open_block = ""
        self.pins: dict[str, S] = {}
        self.line = self.reached = 0
        self.clocks = plan_of(program).clocks
        self.tick("scan", self.dt)
        self.image = dict(self.bits)

    def driven(self) -> dict[str, S]:
        """Give the bits that the system drives."""
        one, zero, first = self.domain.one, self.domain.zero, not self.scans
        now = {
            "on": True,
            "off": False,
            "first": first,
            "later": not first,
            "cold": first and not self.memory.warm,
            "warm": first and self.memory.warm,
        }
        return {
            address: one if (now[what] if what in now else beat(what, self.scans, self.now)) else zero
            for address, what in self.dialect.specials.items()
        }

    def tick(self, when: str, dt: Any) -> None:
        """Let time pass for the timers that run without their instruction, but not where the CPU is in STOP."""
        if self.stopped is not None:
            dt = self.domain.pick(self.stopped, self.domain.number(0), dt)
        for target, op, moment in self.clocks:
            if moment == when:
                clock = ticked_clock(self, target, timer_op(self, op, target), dt)
                self.bits[self.output(target)] = clock.bit
                self.bits[f"{target.text}.going"] = clock.going
                self.words[f"{target.text}.ms"] = clock.ms

    def at(self, line: int, of: int) -> None:
        """Come to a line; as if line i of n ran i/n of the way through the scan, the fastest timers move on a little.

        Lines that were passed over give their part to the next one, and a line that runs again gives none.
        """
        self.line = line
        if line >= self.reached and any(moment == "always" for _, _, moment in self.clocks):
            self.tick("always", self.share(self.reached, line + 1, of))
            self.reached = line + 1

    def lapse(self, ms: int) -> Any:
        """Give the time since the last scan as a number."""
        return self.domain.number(ms)

    def share(self, first: int, stop: int, of: int) -> Any:
        """Give the part of that time that belongs to some lines of so many."""
        return self.domain.number(self.ms * stop // of - self.ms * first // of)

    def read(self, operand: Operand, address: Address) -> S:
        """Give the bit that an operand of this kind sees."""
        if operand.kind == _IMMEDIATE:
            now: S = self.inputs.get(address.text, self.domain.zero)
            return now
        return self.bit(address)

    def past(self, address: Address | None, value: S) -> tuple[S, S | None]:
        """Give the two values between which an edge is looked for."""
        if self.dialect.samples_edges_at_start and address is not None:
            zero, last = self.domain.zero, self.memory.image
            return self.image.get(address.text, zero), None if last is None else last.get(address.text, zero)
        before, seen = self.past_of_lines.get(self.line), self.past_of_lines.get(~self.line)
        return value, before if before is None or seen is None else self.domain.pick(seen, before, value)

    def following(self, address: Address, count: int) -> tuple[Address, ...]:
        """Give `count` addresses from this one on."""
        return tuple(self.dialect.following(address, count))

    # What the lines write.

    def keep(self, one: Step[S], run: S | None = None) -> None:
        """Take over what a step wrote and remembered; `run`: only where the line was executed at all."""
        run = None if run == self.domain.one else run
        for address, value in one.written:
            self.store(address, value, run)
        for key, bit in one.kept:
            if PIN in key:
                _remember(self, self.bits, (key, key + SEEN), bit, run)
            else:
                self.bits[key] = bit if run is None else self.domain.pick(run, bit, self.bits.get(key, bit))
        for key, number in one.numbers:
            self.words[key] = number if run is None else self.domain.pick(run, number, self.number(key))
        if one.remembered is not None:
            _remember(self, self.past_of_lines, (self.line, ~self.line), one.remembered, run)

    def store(self, address: Address, value: Any, run: S | None = None) -> None:
        """Write a bit or a word where it is kept."""
        if address.size == 1 and not in_word(self.dialect, address):
            self.bits[address.text] = value if run is None else self.domain.pick(run, value, self.bit(address))
            return
        bits = self.dialect.bits_of(address)
        if len(bits) > 1:
            for place, bit in zip(bits, value.bits(len(bits)), strict=True):
                self.store(place, bit, run)
            return
        for key, new in self._parts(address, value):
            self.words[key] = new if run is None else self.domain.pick(run, new, self.number(key))

    def _parts(self, address: Address, value: Any) -> list[tuple[str, Any]]:
        """Say which numbers a word goes into."""
        area, whole = self.dialect.area(address), self.dialect.whole(address)
        block = self.dialect.block(address)
        if address.size == 1:
            row = list(self.number(whole.text).bits(area.size))
            row[int(address.field)] = value
            return [(whole.text, self.domain.join(row))]
        if block and block.rule == "timer" and address.field in {"", "V"}:
            return [(f"{whole.text}.ms", value.times(self.base(whole)))]
        if area.value and not address.field:
            return [(f"{whole.text}.{area.value}", value)]
        if address.size > area.size and not address.field:
            low, high = value.bits(address.size)[:REGISTER], value.bits(address.size)[REGISTER:]
            next_one = area.address(address.index + 1)
            return [(area.address(address.index).text, self.domain.join(low)), (next_one.text, self.domain.join(high))]
        return [(address.text, value)]

    def after(self) -> Memory[S]:
        """Give the memory as the scan leaves it."""
        return Memory(
            self.bits,
            self.past_of_lines,
            self.image,
            self.scans + 1,
            self.words,
            self.now,
            self.memory.warm,
            self.stopped,
        )


def _remember(world: Plant[S], into: dict[Any, S], keys: tuple[Any, Any], value: S, run: S | None) -> None:
    """Keep what an edge saw last, where the line was executed; where it never was, there is nothing to compare with yet.

    The second key says where it has been executed at all, as long as that is not everywhere.
    """
    key, seen_at = keys
    old, seen = into.get(key), into.get(seen_at)
    if run is None:
        into[key] = value
        into.pop(seen_at, None)
    elif old is None:
        into[key], into[seen_at] = value, run
    else:
        into[key] = world.domain.pick(run, value, old)
        if seen is not None:
            into[seen_at] = seen | run
