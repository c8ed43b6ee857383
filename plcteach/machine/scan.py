"""Scan after scan: the inputs are read into their image, every line is executed in order, the outputs are written.

A `Memory` is everything that lasts from one scan to the next; it is never changed, a scan gives the next one. So any scan of a
`Trace` can be executed again, step by step, from the memory before it, and a long run need not keep its steps.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from plcteach.core.area import Address
from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.errors import UnknownNameError
from plcteach.machine.signals import ONE, ZERO, Column, Signal, X
from plcteach.machine.step import Stacks, Step, step

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Mapping

    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect, Operand

S = TypeVar("S", bound=Signal)

SCAN_MS = 10
_IMMEDIATE = "now"


@dataclass(frozen=True, slots=True)
class Domain(Generic[S]):
    """The constants of a signal: what a bit is at power-on, what an always-on bit is, and what nobody knows."""

    zero: S
    one: S
    blank: S


BITS = Domain(ZERO, ONE, X)


@dataclass(frozen=True, slots=True)
class Memory(Generic[S]):
    """What lasts between scans.

    bits: every bit that is not 0, by address.  past: for each line with an edge the value it last saw.
    image: the bits at the start of the last scan (None before the first).  scans: how many have run.
    """

    bits: Mapping[str, S] = field(default_factory=dict)
    past: Mapping[int, S] = field(default_factory=dict)
    image: Mapping[str, S] | None = None
    scans: int = 0


class _World(Generic[S]):
    """The PLC around the stack during one scan."""

    def __init__(self, dialect: Dialect, memory: Memory[S], inputs: Mapping[str, S], domain: Domain[S]) -> None:
        self.dialect = dialect
        self.domain = domain
        self.inputs = inputs
        self.memory = memory
        self.bits = {**memory.bits, **inputs, **self.driven(memory.scans)}
        self.image = dict(self.bits)
        self.past_of_lines = dict(memory.past)
        self.line = 0

    def driven(self, scans: int) -> dict[str, S]:
        """Give the bits that the system drives."""
        one, zero = self.domain.one, self.domain.zero
        values = {"on": one, "off": zero, "first": zero if scans else one, "later": one if scans else zero}
        return {address: values[what] for address, what in self.dialect.specials.items()}

    def read(self, operand: Operand, address: Address) -> S:
        source = self.inputs if operand.kind == _IMMEDIATE else self.bits
        return source.get(address.text, self.domain.zero)

    def past(self, address: Address | None, value: S) -> tuple[S, S | None]:
        if self.dialect.samples_edges_at_start and address is not None:
            zero, last = self.domain.zero, self.memory.image
            return self.image.get(address.text, zero), None if last is None else last.get(address.text, zero)
        return value, self.past_of_lines.get(self.line)

    def following(self, address: Address, count: int) -> tuple[Address, ...]:
        return tuple(self.dialect.following(address, count))

    def keep(self, one: Step[S]) -> None:
        """Take over what a step wrote and remembered."""
        for address, value in one.written:
            self.bits[address.text] = value
        if one.remembered is not None:
            self.past_of_lines[self.line] = one.remembered

    def after(self) -> Memory[S]:
        """Give the memory as the scan leaves it."""
        return Memory(self.bits, self.past_of_lines, self.image, self.memory.scans + 1)


def sweep(
    program: Program,
    memory: Memory[S],
    inputs: Mapping[str, S],
    domain: Domain[S],
    watch: Callable[[int, Step[S]], None] | None = None,
) -> Memory[S]:
    """Run one scan over any signal and give the memory after it; `watch` sees each step with its line number."""
    world = _World(program.dialect, memory, inputs, domain)
    for number, one in _steps(program, world):
        if watch:
            watch(number, one)
    return world.after()


def _steps(program: Program, world: _World[S]) -> Iterator[tuple[int, Step[S]]]:
    shapes, blank = program.dialect.shapes, world.domain.blank
    stacks: Stacks[S] = tuple((blank,) * shape.depth if shape.fixed else () for shape in shapes)
    number = 0
    for network in program.networks:
        stacks = tuple(cells if shape.fixed else () for cells, shape in zip(stacks, shapes, strict=True))
        for line in network.lines:
            world.line = number
            one = step(line, shapes, stacks, world, blank)
            world.keep(one)
            yield number, one
            stacks = one.after
            number += 1
            if any(verb.name == "end" for verb in line.insn.then):
                return


@dataclass(frozen=True)
class Scan(Generic[S]):
    """One scan of a trace: when it began, the inputs it saw, and the memory before and after."""

    program: Program
    domain: Domain[S]
    number: int
    start_ms: int
    inputs: Mapping[str, S]
    before: Memory[S]
    after: Memory[S]

    def __repr__(self) -> str:
        return f"Scan({self.number} at {self.start_ms} ms)"

    @cached_property
    def steps(self) -> tuple[Step[S], ...]:
        """Every step of this scan, executed again from the memory before it."""
        world = _World(self.program.dialect, self.before, self.inputs, self.domain)
        return tuple(one for _, one in _steps(self.program, world))

    def __getitem__(self, address: str) -> S:
        """Give a bit as this scan left it; UnknownNameError if the family has no such address."""
        return self.after.bits.get(normal(self.program.dialect, address), self.domain.zero)


@dataclass(frozen=True, slots=True)
class Trace(Generic[S]):
    """A run: its scans, and what only the values could tell (an x that reached an output)."""

    program: Program
    scans: tuple[Scan[S], ...]
    diagnostics: tuple[Diagnostic, ...] = ()

    def __repr__(self) -> str:
        return f"Trace({self.program.dialect.name}, {len(self.scans)} scans)"

    def __getitem__(self, address: str) -> str:
        """Give the values of a bit at the ends of all scans as a string such as "0011x"."""
        return "".join(repr(scan[address]) for scan in self.scans)


def normal(dialect: Dialect, word: str) -> str:
    """Give the canonical spelling of an address; UnknownNameError if the family has none such."""
    found = dialect.address(word)
    if isinstance(found, Address):
        return found.text
    kind = f"{dialect.name} address"
    raise UnknownNameError(kind, word, (area.first for area in dialect.areas))


def run(
    program: Program,
    scans: Iterable[Mapping[str, Any]] | int = 1,
    *,
    scan_ms: int = SCAN_MS,
    memory: Memory[Column] | None = None,
) -> Trace[Column]:
    """Run a program, one scan for each mapping of inputs {address: 0 | 1}, or that many scans with all inputs 0.

    Inputs start at 0 and keep their value until they are named again. "ms" in a mapping is that scan's length in ms.
    UnknownNameError names an address that the family does not have.
    """
    wanted: list[Mapping[str, Any]] = [{}] * scans if isinstance(scans, int) else list(scans)
    state: Memory[Column] = memory or Memory()
    inputs = {one.text: state.bits[one.text] for one in program.addresses("input") if one.text in state.bits}
    done: list[Scan[Column]] = []
    found: dict[str, Diagnostic] = {}

    def watch(_number: int, one: Step[Column]) -> None:
        for address, value in one.written:
            if value.unknown and address.text not in found:
                found[address.text] = rule("RUN001").at(one.line.span, address=address.text)

    now = 0
    for number, row in enumerate(wanted):
        now += int(row.get("ms", scan_ms)) if number else 0
        inputs = inputs | {normal(program.dialect, name): _bit(value) for name, value in row.items() if name != "ms"}
        after = sweep(program, state, inputs, BITS, watch)
        done.append(Scan(program, BITS, number, now, inputs, state, after))
        state = after
    return Trace(program, tuple(done), tuple(found.values()))


def _bit(value: object) -> Column:
    return X if value == "x" else ONE if value in (1, "1") else ZERO
