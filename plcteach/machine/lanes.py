"""Many timelines side by side: one run in which every bit is a column with a place for each of them.

A thousand timelines cost a few scans' worth of time and not a thousand, because one operation on two long integers serves all of
them. Where some go back in the program and others do not (a loop, a jump backwards) they run one by one.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from plcteach.machine.course import Mixed
from plcteach.machine.scan import SCAN_MS, Trace, address_of, run, spread, sweep
from plcteach.machine.signals import ZERO, Column
from plcteach.machine.store import Memory, Store, in_word
from plcteach.machine.words import Domain, Number, gathered, value_of

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from plcteach.core.program import Program


@dataclass(frozen=True)
class Lanes:
    """What many timelines did: the memory after each scan, for all of them at once, or one trace for each."""

    program: Program
    count: int
    memories: tuple[Memory[Column], ...] = field(repr=False)
    domain: Domain[Column] = field(repr=False)
    traces: tuple[Trace, ...] = field(default=(), repr=False)

    def column(self, address: str, scan: int) -> Column:
        """Give a bit after one scan, a case for each timeline."""
        place = address_of(self.program.dialect, address)
        if self.traces:
            column: Column = _column([trace.value(address, scan) for trace in self.traces], self.domain)
        else:
            column = Store(self.program, self.memories[scan], self.domain).value(place)
        return column

    def value(self, address: str, scan: int, lane: int) -> Any:
        """Give what an address held after one scan in one timeline: a bit, or a number."""
        if self.traces:
            return self.traces[lane].value(address, scan)
        place = address_of(self.program.dialect, address)
        found = Store(self.program, self.memories[scan], self.domain).value(place)
        if isinstance(found, Column):
            return Column(found.may0 >> lane & 1, found.may1 >> lane & 1)
        return Number(value_of(found, lane))


def lanes(program: Program, timelines: Sequence[Sequence[Mapping[str, Any]]], *, scan_ms: int = SCAN_MS) -> Lanes:
    """Run all timelines at once, each a list of scans as `run` takes it; all have the same length and scan time."""
    count = len(timelines)
    every = (1 << count) - 1
    domain = Domain(Column(every, 0), Column(0, every), Column(every, every))
    held: dict[str, list[Any]] = {}
    memory: Memory[Column] = Memory()
    memories: list[Memory[Column]] = []
    try:
        for number in range(max(map(len, timelines), default=0)):
            inputs = _inputs(program, held, [line[number] for line in timelines], domain)
            memory = sweep(program, memory, inputs, domain, ms=scan_ms if number else 0)
            memories.append(memory)
    except Mixed:
        traces = tuple(run(program, line, scan_ms=scan_ms) for line in timelines)
        return Lanes(program, count, (), domain, traces)
    return Lanes(program, count, tuple(memories), domain)


def _inputs(
    program: Program, held: dict[str, list[Any]], rows: list[Mapping[str, Any]], domain: Domain[Column]
) -> dict[str, Any]:
    """Give the inputs of one scan as columns; inputs are held, any other address is written when it is named."""
    now: dict[str, list[Any]] = {}
    for lane, row in enumerate(rows):
        for name, value in row.items():
            place = address_of(program.dialect, name)
            into = held if program.dialect.area(place).role == "input" else now
            if in_word(program.dialect, place):
                raise Mixed
            for key, one in spread(program, place, value).items():
                blank = ZERO if isinstance(one, Column) else Number(0)
                into.setdefault(key, [blank] * len(rows))[lane] = one
    return {key: _column(values, domain) for key, values in {**held, **now}.items()}


def _column(values: list[Any], domain: Domain[Column]) -> Any:
    if isinstance(values[0], Number):
        return gathered([one.value for one in values], domain)
    return Column(
        sum(one.may0 << lane for lane, one in enumerate(values)),
        sum(one.may1 << lane for lane, one in enumerate(values)),
    )
