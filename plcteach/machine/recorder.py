"""Runs scan after scan and keeps what a trace needs: a memory now and then, and for every address when it changed.

The first scans run line by line. Then, if it can be written down, the program becomes one generated function; whatever that
cannot do (an x in an input, an address written from outside) is done line by line again.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.errors import PlcTeachError
from plcteach.machine.blocks import AT_END
from plcteach.machine.generated import Generated, Unsure, bit_of
from plcteach.machine.signals import ONE
from plcteach.machine.store import Memory, in_word
from plcteach.machine.sweep import address_of, spread, sweep
from plcteach.machine.trace import APART, Trace
from plcteach.machine.words import BITS, Number

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from plcteach.core.area import Address
    from plcteach.core.program import Program
    from plcteach.machine.signals import Column
    from plcteach.machine.step import Step

PATIENCE = 24
"""So many scans run line by line before a program is written down; a short run never is."""


def lapse(ms: object) -> int:
    """Give the time between two scans; PlcTeachError where it is no whole number of ms, or less than none."""
    if not isinstance(ms, int) or ms < 0:
        msg = f"a scan lasts a whole number of ms, 0 or more, and not {ms!r}"
        raise PlcTeachError(msg)
    return ms


class Recorder:
    """A run under way."""

    def __init__(self, program: Program, memory: Memory[Column], scan_ms: int) -> None:
        self.program = program
        self.state = memory
        self.scan_ms = scan_ms
        inputs = [one.text for one in program.addresses("input")]
        self.fed = tuple(inputs)
        self.held: dict[str, Any] = {text: memory.bits[text] for text in inputs if text in memory.bits}
        self.starts: list[int] = []
        self.inputs: list[Mapping[str, Any]] = []
        self.checkpoints: dict[int, Memory[Column]] = {}
        self.changes: dict[str, tuple[list[int], list[Any]]] = {}
        self.found: dict[str, Diagnostic] = {}
        self.ran_away = False
        self.wait = PATIENCE
        self.fast: Generated | None = None
        self.values: tuple[int, ...] = ()
        self.given: tuple[int, ...] = ()
        self.ticks: tuple[int, ...] = ()
        self.scans = self.now = self.first_ms = 0
        self.named: dict[str, tuple[Address, bool]] = {}

    def scan(self, row: Mapping[str, Any]) -> None:
        """Run one scan."""
        number = len(self.starts)
        ms = lapse(row.get("ms", self.scan_ms)) if number or self.state.scans else 0
        self.first_ms = self.first_ms if number else ms
        self.starts.append(self.starts[-1] + ms if number else 0)
        same = not row or (len(row) == 1 and "ms" in row)
        inputs = self.held if same else self.taken(row)
        self.inputs.append(inputs)
        if self.fast and not self.fits(inputs, same=same):
            self.slow_down()
        if number % APART == 0:
            self.checkpoints[number] = self.memory()
        if self.fast:
            self.quickly(number, ms)
        else:
            self.line_by_line(number, ms, inputs)

    def line_by_line(self, number: int, ms: int, inputs: Mapping[str, Any]) -> None:
        """Run one scan as it is taught, and see whether the next ones can go faster."""
        said: list[Diagnostic] = []
        after = sweep(self.program, self.state, inputs, BITS, self.watch, ms=ms, found=said)
        for one in said:
            self.found.setdefault(f"{one.code} {one.span}", one)
            self.ran_away |= one.code == "RUN002"
        before = self.state if number else Memory()
        for old, new in ((before.bits, after.bits), (before.words, after.words)):
            for key, value in new.items():
                if old.get(key) != value:
                    self.changed(key, number, value)
        self.state = after
        self.wait -= 1
        if not self.wait:
            self.speed_up()

    def changed(self, key: str, number: int, value: Any) -> None:
        """Enter that an address has changed."""
        when, values = self.changes.setdefault(key, ([], []))
        when.append(number)
        values.append(value)

    def speed_up(self) -> None:
        """Write the program down, if that can be done; otherwise it goes on line by line."""
        try:
            self.fast = Generated(self.program, self.state, tuple(dict.fromkeys((*self.fed, *self.held))))
            self.values = self.fast.state(self.state)
            self.given = self.fast.given(self.held)
            self.scans, self.now = self.state.scans, self.state.now
            self.ticks = self.fast.ticks(self.scans - 1, self.now)
        except Unsure:
            self.fast, self.wait = None, PATIENCE * 8

    def fits(self, inputs: Mapping[str, Any], *, same: bool) -> bool:
        """Say whether the generated scan can take these inputs, and hand them to it."""
        if same or self.fast is None:
            return True
        if inputs is not self.held or any(key not in self.fast.fed for key in inputs):
            return False
        try:
            given = self.fast.given(inputs)
        except Unsure:
            return False
        for key, old, new in zip(self.fast.fed, self.given, given, strict=True):
            if old != new:
                self.changed(key, len(self.starts) - 1, inputs[key])
        self.given = given
        return True

    def slow_down(self) -> None:
        """Go on line by line for a while."""
        self.state = self.memory()
        self.fast, self.wait = None, PATIENCE

    def memory(self) -> Memory[Column]:
        """Give the memory as it is now."""
        if not self.fast:
            return self.state
        return self.fast.memory((self.values, self.given, self.ticks), self.state, self.scans, self.now)

    def quickly(self, number: int, ms: int) -> None:
        """Run one generated scan and enter what it changed."""
        fast = self.fast
        if fast is None:
            return
        self.now += ms
        ticks = fast.ticks(self.scans, self.now)
        self.scans += 1
        before, self.values = self.values, fast.call(self.values, self.given, ticks, ms)
        if before != self.values:
            for key, old, new in zip(fast.keys, before, self.values, strict=False):
                if old != new:
                    self.changed(key, number, Number(new) if key in fast.counts else bit_of(new))
        if ticks != self.ticks:
            for key, old, new in zip(fast.clocks, self.ticks, ticks, strict=True):
                if old != new:
                    self.changed(key, number, bit_of(new))
            self.ticks = ticks

    def taken(self, row: Mapping[str, Any]) -> Mapping[str, Any]:
        """Give the inputs of one scan: those that are held, and what is written only now."""
        once: dict[str, Any] = {}
        held: dict[str, Any] = {}
        for name, value in row.items():
            if name == "ms":
                continue
            place, given = self.named.get(name) or self.learn(name)
            into = held if given else once
            if in_word(self.program.dialect, place):
                memory = self.memory()
                into |= spread(self.program, place, value, replace(memory, words={**memory.words, **once}))
            else:
                into |= spread(self.program, place, value)
        if held:
            self.held = self.held | held
        return {**self.held, **once} if once else self.held

    def learn(self, name: str) -> tuple[Address, bool]:
        """Find out what a name in the inputs stands for, once."""
        place = address_of(self.program.dialect, name)
        found = self.named[name] = place, self.program.dialect.area(place).role == "input"
        return found

    def watch(self, one: Step[Column]) -> None:
        """Note the first x at every address."""
        for address, value in one.written:
            if value.unknown and address.text not in self.found:
                self.found[address.text] = rule("RUN001").at(one.line.span, address=address.text)

    def ends(self) -> Iterator[Diagnostic]:
        """Give each step counter that was asked to go beyond its ends, at the first line that drives it."""
        asked = {
            key.removesuffix(AT_END)
            for key, (_, values) in self.changes.items()
            if key.endswith(AT_END) and ONE in values
        }
        for line in self.program.lines:
            for place in line.places:
                if place.text in asked:
                    asked.discard(place.text)
                    yield rule("RUN004").at(line.span, block=place.text)

    def forget(self, scan: int) -> int:
        """Forget the scans before one, so that a run without an end keeps no more than is wanted; give how many are gone.

        Whole stretches between two kept memories go, so a few scans more than asked for may stay; later numbers shift down.
        """
        gone = scan - scan % APART
        if gone <= 0:
            return 0
        self.first_ms = self.starts[gone] - self.starts[gone - 1]
        del self.starts[:gone], self.inputs[:gone]
        self.checkpoints = {at - gone: memory for at, memory in self.checkpoints.items() if at >= gone}
        for when, values in self.changes.values():
            at = bisect_right(when, gone)
            del when[: at - 1], values[: at - 1]
            when[:] = [max(0, one - gone) for one in when]
        return gone

    def trace(self) -> Trace:
        """Give what the run leaves."""
        return Trace(
            self.program,
            tuple(self.starts),
            tuple(self.inputs),
            self.checkpoints,
            self.changes,
            self.memory(),
            (*self.found.values(), *self.ends()),
            self.scan_ms,
            self.first_ms,
        )
