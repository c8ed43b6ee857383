"""Scan after scan: the inputs are read into their image, every line is executed in order, the outputs are written.

A `Memory` is everything that lasts from one scan to the next; it is never changed, a scan gives the next one. So any scan of a
`Trace` can be executed again, step by step, from a memory before it: a trace keeps the memory now and then, and of every
address when it changed, but no steps.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

from plcteach.core.area import Address
from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.errors import UnknownNameError
from plcteach.machine.course import Course
from plcteach.machine.signals import ONE, ZERO, Column, Signal, X
from plcteach.machine.store import Memory, Store
from plcteach.machine.words import BITS, UNKNOWN, Domain, Number
from plcteach.machine.world import Plant

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.machine.step import Step

__all__ = ["BITS", "SCAN_MS", "Domain", "Memory", "Scan", "Trace", "normal", "run", "sweep", "warm"]

S = TypeVar("S", bound=Signal)

SCAN_MS = 10
APART = 64
"""A trace keeps the memory of every so many scans."""


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
        world = Plant(self.program, self.before, self.inputs, self.domain, self.ms)
        return tuple(one for _, one in Course(world).steps())

    def __getitem__(self, address: str) -> Any:
        """Give a bit or a word as this scan left it; UnknownNameError if the family has no such address."""
        return Store(self.program, self.after, self.domain).value(_place(self.program.dialect, address))


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
    domain: Domain[Column] = field(default=BITS, repr=False)

    def __repr__(self) -> str:
        return f"Trace({self.program.dialect.name}, {len(self.starts)} scans)"

    @cached_property
    def scans(self) -> Scans:
        """The scans, one by one."""
        return Scans(self)

    def scan_from(self, number: int, memory: Memory[Column]) -> Scan[Column]:
        """Give a scan, the memory before it being known."""
        ms = self.starts[number] - self.starts[number - 1] if number else 0
        return Scan(self.program, self.domain, number, self.starts[number], self.inputs[number], memory, ms)

    def __getitem__(self, address: str) -> str:
        """Give the values of a bit at the ends of all scans as a string such as "0011x"."""
        return "".join(map(repr, self.values(address)))

    def values(self, address: str) -> list[Any]:
        """Give what an address held at the end of every scan: bits, or numbers."""
        return [self.value(address, number) for number in range(len(self.starts))]

    def value(self, address: str, number: int) -> Any:
        """Give what an address held at the end of one scan."""
        return _Moment(self, number).value(_place(self.program.dialect, address))

    def edges(self, address: str) -> list[tuple[int, Any]]:
        """Give the moments (ms, the start of the scan) at which an address changed, each with its new value."""
        found: list[tuple[int, Any]] = []
        for start, value in zip(self.starts, self.values(address), strict=True):
            if not found or found[-1][1] != value:
                found.append((start, value))
        return found


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


def normal(dialect: Dialect, word: str) -> str:
    """Give the canonical spelling of an address; UnknownNameError if the family has none such."""
    return _place(dialect, word).text


def _place(dialect: Dialect, word: str) -> Address:
    found = dialect.address(word)
    if isinstance(found, Address) and found.size:
        return found
    kind = f"{dialect.name} address"
    raise UnknownNameError(kind, word, (area.first for area in dialect.areas))


def warm(program: Program, memory: Memory[Column]) -> Memory[Column]:
    """Give the memory with which a warm start begins: what is retentive stays, everything else is as at power-on."""
    dialect = program.dialect

    def stays(key: str) -> bool:
        whole = dialect.address(key.partition("<")[0].partition("#")[0].partition(".ms")[0].partition(".g")[0])
        if not isinstance(whole, Address):
            return False
        return any(first <= whole.index <= last for first, last in dialect.retentive.get(whole.area, ()))

    bits = {
        key: bit for key, bit in memory.bits.items() if stays(key) and "<" not in key and not key.endswith(".going")
    }
    words = {key: number for key, number in memory.words.items() if stays(key)}
    return Memory(bits=bits, words=words, warm=True)


def run(
    program: Program,
    scans: Iterable[Mapping[str, Any]] | int = 1,
    *,
    scan_ms: int = SCAN_MS,
    memory: Memory[Column] | None = None,
) -> Trace:
    """Run a program, one scan for each mapping of inputs {address: value}, or that many scans with all inputs 0.

    Inputs start at 0 and keep their value until they are named again; any other address is written once, when it is named.
    "ms" in a mapping is the time since the scan before; the first scan begins at 0. A runaway loop ends the run.
    UnknownNameError names an address that the family does not have.
    """
    recorder = _Recorder(program, memory or Memory())
    rows: Iterable[Mapping[str, Any]] = ({} for _ in range(scans)) if isinstance(scans, int) else scans
    for row in rows:
        recorder.scan(row, scan_ms)
        if recorder.state.stopped == ONE and recorder.ran_away:
            break
    return recorder.trace(scan_ms)


class _Recorder:
    """Runs scan after scan and keeps what a trace needs."""

    def __init__(self, program: Program, memory: Memory[Column]) -> None:
        self.program = program
        self.state = memory
        self.held: dict[str, Any] = {
            one.text: memory.bits[one.text] for one in program.addresses("input") if one.text in memory.bits
        }
        self.starts: list[int] = []
        self.inputs: list[Mapping[str, Any]] = []
        self.checkpoints: dict[int, Memory[Column]] = {}
        self.changes: dict[str, tuple[list[int], list[Any]]] = {}
        self.found: dict[str, Diagnostic] = {}
        self.ran_away = False

    def scan(self, row: Mapping[str, Any], scan_ms: int) -> None:
        number = len(self.starts)
        ms = int(row.get("ms", scan_ms)) if number else 0
        self.starts.append(self.starts[-1] + ms if number else 0)
        self.inputs.append(self.taken(row))
        if number % APART == 0:
            self.checkpoints[number] = self.state
        said: list[Diagnostic] = []
        after = sweep(self.program, self.state, self.inputs[-1], BITS, self.watch, ms=ms, found=said)
        for one in said:
            self.found.setdefault(f"{one.code} {one.span}", one)
            self.ran_away |= one.code == "RUN002"
        before = self.state if number else Memory()
        for old, new in ((before.bits, after.bits), (before.words, after.words)):
            for key, value in new.items():
                if old.get(key) != value:
                    when, values = self.changes.setdefault(key, ([], []))
                    when.append(number)
                    values.append(value)
        self.state = after

    def taken(self, row: Mapping[str, Any]) -> Mapping[str, Any]:
        """Give the inputs of one scan: those that are held, and what is written only now."""
        once: dict[str, Any] = {}
        held: dict[str, Any] = {}
        dialect = self.program.dialect
        for name, value in row.items():
            if name == "ms":
                continue
            place = _place(dialect, name)
            into = held if dialect.area(place).role == "input" else once
            into |= _spread(self.program, place, value)
        if held:
            self.held = self.held | held
        return {**self.held, **once} if once else self.held

    def watch(self, _number: int, one: Step[Column]) -> None:
        for address, value in one.written:
            if value.unknown and address.text not in self.found:
                self.found[address.text] = rule("RUN001").at(one.line.span, address=address.text)

    def trace(self, scan_ms: int) -> Trace:
        return Trace(
            self.program,
            tuple(self.starts),
            tuple(self.inputs),
            self.checkpoints,
            self.changes,
            self.state,
            tuple(self.found.values()),
            scan_ms,
        )


def _spread(program: Program, place: Address, value: Any) -> dict[str, Any]:
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
