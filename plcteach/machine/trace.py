"""What a run leaves: any scan of it again, step by step, and what every address held at every scan's end.

A trace keeps the memory now and then, and of every address when it changed, but no steps: a scan that is asked for is executed
again from a memory before it.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

from plcteach.machine.course import Course
from plcteach.machine.signals import Column, Signal
from plcteach.machine.store import Memory, Store
from plcteach.machine.sweep import address_of, sweep
from plcteach.machine.words import BITS, Domain
from plcteach.machine.world import Plant

if TYPE_CHECKING:
    from plcteach.core.area import Address
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.program import Program
    from plcteach.machine.step import Step

S = TypeVar("S", bound=Signal)

SCAN_MS = 10
APART = 64
"""A trace keeps the memory of every so many scans."""


@dataclass(frozen=True)
class Scan(Generic[S]):
    """One scan of a trace: when it began, how long after the last one, the inputs it saw, and the memory before it."""

    program: Program
    domain: Domain[S]
    number: int
    start_ms: int
    inputs: Mapping[str, Any]
    before: Memory[S]
    ms: int = 0

    def __repr__(self) -> str:
        return f"Scan({self.number} at {self.start_ms} ms)"

    @cached_property
    def after(self) -> Memory[S]:
        """The memory as this scan leaves it."""
        return sweep(self.program, self.before, self.inputs, self.domain, ms=self.ms)

    @cached_property
    def steps(self) -> tuple[Step[S], ...]:
        """Every step of this scan, executed again from the memory before it."""
        return tuple(one for one, _ in self.walk())

    def walk(self) -> Iterator[tuple[Step[S], Plant[S]]]:
        """Execute the scan again, and give each step with the plant as it then is."""
        world = self.start()
        return ((one, world) for one in Course(world).steps())

    def start(self) -> Plant[S]:
        """Give the plant as the scan finds it: inputs read, time passed, no line executed."""
        return Plant(self.program, self.before, self.inputs, self.domain, self.ms)

    def __getitem__(self, address: str) -> Any:
        """Give a bit or a word as this scan left it; UnknownNameError if the family has no such address."""
        return Store(self.program, self.after, self.domain).value(address_of(self.program.dialect, address))


class Scans(Sequence[Scan[Column]]):
    """The scans of a trace, each made when it is asked for; going through them in order costs one scan each."""

    def __init__(self, trace: Trace) -> None:
        self._trace = trace
        self._last: Scan[Column] | None = None

    def __len__(self) -> int:
        return len(self._trace.starts)

    @overload
    def __getitem__(self, number: int) -> Scan[Column]: ...
    @overload
    def __getitem__(self, number: slice) -> list[Scan[Column]]: ...
    def __getitem__(self, number: int | slice) -> Scan[Column] | list[Scan[Column]]:
        if isinstance(number, slice):
            return [self._at(one) for one in range(*number.indices(len(self)))]
        if not -len(self) <= number < len(self):
            raise IndexError(number)
        return self._at(number % len(self))

    def __iter__(self) -> Iterator[Scan[Column]]:
        return (self._at(number) for number in range(len(self)))

    def _at(self, number: int) -> Scan[Column]:
        last = self._last
        if last is not None and last.number == number:
            return last
        at = number - number % APART
        memory = self._trace.checkpoints[at]
        if last is not None and at <= last.number < number:
            at, memory = last.number + 1, last.after
        for each in range(at, number):
            memory = self._trace.scan_from(each, memory).after
        self._last = self._trace.scan_from(number, memory)
        return self._last


@dataclass(frozen=True)
class Trace:
    """A run: when each scan began, when each address changed, and what only the values could tell (an x at an output)."""

    program: Program
    starts: tuple[int, ...]
    inputs: tuple[Mapping[str, Any], ...]
    checkpoints: Mapping[int, Memory[Column]]
    changes: Mapping[str, tuple[list[int], list[Any]]]
    memory: Memory[Column]
    diagnostics: tuple[Diagnostic, ...] = ()
    scan_ms: int = SCAN_MS
    first_ms: int = 0
    domain: Domain[Column] = field(default=BITS, repr=False)

    def __repr__(self) -> str:
        return f"Trace({self.program.dialect.name}, {len(self.starts)} scans)"

    @cached_property
    def scans(self) -> Scans:
        """The scans, one by one."""
        return Scans(self)

    def scan_from(self, number: int, memory: Memory[Column]) -> Scan[Column]:
        """Give a scan, the memory before it being known."""
        ms = self.starts[number] - self.starts[number - 1] if number else self.first_ms
        return Scan(self.program, self.domain, number, self.starts[number], self.inputs[number], memory, ms)

    def __getitem__(self, address: str) -> Any:
        """Give a bit at the ends of all scans as a string such as "0011x", a word as a list of numbers (None for x)."""
        if address_of(self.program.dialect, address).size != 1:
            return [one.value for one in self.values(address)]
        return "".join(map(repr, self.values(address)))

    def __len__(self) -> int:
        return len(self.starts)

    def values(self, address: str) -> list[Any]:
        """Give what an address held at the end of every scan: bits, or numbers."""
        place = address_of(self.program.dialect, address)
        return [_Moment(self, number).value(place) for number in range(len(self.starts))]

    def value(self, address: str, number: int) -> Any:
        """Give what an address held at the end of one scan."""
        return _Moment(self, number).value(address_of(self.program.dialect, address))

    def edges(self, address: str) -> list[tuple[int, Any]]:
        """Give the moments (ms, the start of the scan) at which an address changed, each with its new value."""
        place = address_of(self.program.dialect, address)
        found: list[tuple[int, Any]] = []
        for number in self._moments(place):
            value = _Moment(self, number).value(place)
            if not found or found[-1][1] != value:
                found.append((self.starts[number], value))
        return found

    def _moments(self, place: Address) -> list[int]:
        """Give the scans in which an address may have changed."""
        if not self.starts:
            return []
        dialect = self.program.dialect
        named = {bit.text for bit in dialect.bits_of(place)}
        if not named or place.field:
            named.add(dialect.whole(place).text)
        touched = [when for key, (when, _) in self.changes.items() if key in named or key.split(".")[0] in named]
        if not touched and place.size != 1:
            touched = [when for key, (when, _) in self.changes.items() if key.startswith(place.area)]
        return sorted({0}.union(*touched))

    def base(self, block: Address) -> int:
        """Give the time base of a timer in ms."""
        return _Moment(self, 0).base(self.program.dialect.whole(block))


class _Moment(Store[Column]):
    """The end of one scan of a trace, read from what changed."""

    def __init__(self, trace: Trace, number: int) -> None:
        self.program, self.dialect, self.domain = trace.program, trace.program.dialect, trace.domain
        self.bits = self.words = _Past(trace.changes, number)


class _Past(Mapping[str, Any]):
    """A mapping of an earlier moment."""

    def __init__(self, changes: Mapping[str, tuple[list[int], list[Any]]], number: int) -> None:
        self._changes, self._number = changes, number

    def __getitem__(self, key: str) -> Any:
        when, values = self._changes[key]
        at = bisect_right(when, self._number)
        if not at:
            raise KeyError(key)
        return values[at - 1]

    def __iter__(self) -> Iterator[str]:
        return iter(self._changes)

    def __len__(self) -> int:
        return len(self._changes)
