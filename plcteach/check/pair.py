"""Two programs side by side as machines over columns: what they read, write and remember, and one scan of both."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.machine.scan import BITS, Memory, sweep

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from plcteach.core.program import Program
    from plcteach.machine.rows import Rows
    from plcteach.machine.signals import Column
    from plcteach.machine.step import Step

MOST_SETTLING_SCANS = 32

Key = tuple[str, str | int]
"""A remembered bit of one program: ("bit", address), ("image", address) or ("past", line number)."""


@dataclass(frozen=True)
class Machine:
    """One of the two programs, with what it reads, writes and remembers."""

    program: Program
    reads: frozenset[str]
    writes: frozenset[str]
    state: tuple[Key, ...]

    def scan(self, inputs: Mapping[str, Column], state: Mapping[Key, Column], rows: Rows, *, first: bool) -> Result:
        """Run one scan over columns from a given state."""
        memory = _memory(state, first=first)
        after = sweep(self.program, memory, inputs, rows.domain)
        outputs = {address: after.bits.get(address, rows.domain.zero) for address in self.writes}
        return Result(outputs, {key: _kept(after, key, rows.domain.zero) for key in self.state})

    def settle(self, inputs: Mapping[str, Column], state: Mapping[Key, Column], rows: Rows, *, first: bool) -> Result:
        """Hold the inputs and scan until nothing changes any more; `restless` are the cases in which it never stops."""
        result = self.scan(inputs, state, rows, first=first)
        for _ in range(MOST_SETTLING_SCANS):
            again = self.scan(inputs, result.state, rows, first=False)
            restless = either(again.state[key].differs(result.state[key]) for key in self.state)
            restless |= either(again.outputs[address].differs(result.outputs[address]) for address in self.writes)
            result = Result(again.outputs, again.state, restless)
            if not restless:
                break
        return result


@dataclass(frozen=True)
class Result:
    """The outputs and the remembered bits at a scan's end, and the cases in which the program has not come to rest."""

    outputs: dict[str, Column]
    state: dict[Key, Column]
    restless: int = 0


def either(columns: Iterable[int]) -> int:
    """Give the cases that are in any of some sets of cases."""
    union = 0
    for one in columns:
        union |= one
    return union


def _kept(memory: Memory[Column], key: Key, zero: Column) -> Column:
    what, where = key
    if what == "past":
        return memory.past.get(int(where), zero)
    bits = memory.image if what == "image" else memory.bits
    return (bits or {}).get(str(where), zero)


def _memory(state: Mapping[Key, Column], *, first: bool) -> Memory[Column]:
    """Give the memory that holds a state; before the first scan there is none."""
    if first:
        return Memory()
    bits = {str(where): value for (what, where), value in state.items() if what == "bit"}
    past = {int(where): value for (what, where), value in state.items() if what == "past"}
    image = {str(where): value for (what, where), value in state.items() if what == "image"}
    return Memory(bits, past, image, 1)


def machine_of(program: Program) -> Machine:
    """Watch one scan to see what a program reads, writes and remembers (no instruction here is conditional)."""
    reads: set[str] = set()
    writes: set[str] = set()
    past: list[Key] = []
    edges_of: set[str] = set()

    def watch(one: Step[Column]) -> None:
        reads.update(address.text for address, _ in one.read)
        writes.update(address.text for address, _ in one.written)
        if one.line.insn.does & {"set", "reset"}:
            reads.update(address.text for address, _ in one.written)
        if one.remembered is not None:
            past.append(("past", one.number))
            edges_of.update(address.text for address, _ in one.read)

    sweep(program, Memory(), {}, BITS, watch)
    dialect = program.dialect
    state: list[Key] = [("bit", address) for address in sorted(writes & reads)]
    if dialect.samples_edges_at_start:
        state += [("image", address) for address in sorted(edges_of)]
    else:
        state += past
    return Machine(program, frozenset(reads), frozenset(writes), tuple(state))


@dataclass(frozen=True)
class Pair:
    """The two machines side by side, the free inputs and the outputs that are compared.

    settled: inputs are held until both are at rest, and only then are the outputs compared.
    """

    reference: Machine
    student: Machine
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    settled: bool = False

    @property
    def state(self) -> tuple[tuple[int, Key], ...]:
        """All remembered bits of both, each with the side (0 the reference, 1 the student) that remembers it."""
        return tuple((side, key) for side, one in enumerate((self.reference, self.student)) for key in one.state)

    def scan(
        self, inputs: Mapping[str, Column], state: Mapping[tuple[int, Key], Column], rows: Rows, *, first: bool
    ) -> tuple[dict[str, int], dict[tuple[int, Key], Column]]:
        """Run both for one scan: for each output the cases in which they differ, and the state after."""
        results = []
        for side, machine in enumerate((self.reference, self.student)):
            mine = {key: value for (whose, key), value in state.items() if whose == side}
            run = machine.settle if self.settled else machine.scan
            results.append(run(inputs, mine, rows, first=first))
        zero = rows.domain.zero
        differ = {
            address: results[0].outputs.get(address, zero).differs(results[1].outputs.get(address, zero))
            | results[1].outputs.get(address, zero).unknown
            | results[0].restless
            | results[1].restless
            for address in self.outputs
        }
        return differ, {(side, key): value for side, one in enumerate(results) for key, value in one.state.items()}


def pair_of(reference: Program, student: Program, wanted: tuple[str, ...]) -> Pair:
    """Put two programs side by side; by default the outputs compared are those that the reference writes."""
    mine, theirs = machine_of(reference), machine_of(student)
    driven = frozenset(reference.dialect.specials)
    written = mine.writes | theirs.writes
    areas = {address.text: address for program in (reference, student) for address in _bits(program)}
    for text in mine.writes | theirs.writes:
        place = reference.dialect.address(text)
        if isinstance(place, Address) and place.size == 1:
            areas.setdefault(text, place)
    role = {text: reference.dialect.area(address).role for text, address in areas.items()}
    inputs = {text for text in mine.reads | theirs.reads if role.get(text) == "input"}
    inputs |= {text for text in mine.reads if text in areas and text not in written | driven}
    outputs = wanted or _compared(mine, role)
    order = {
        text: number
        for number, text in enumerate(sorted(areas, key=lambda text: (areas[text].area, areas[text].index)))
    }
    return Pair(
        mine,
        theirs,
        tuple(sorted(inputs, key=order.__getitem__)),
        tuple(sorted(outputs, key=lambda one: order.get(one, -1))),
    )


def _bits(program: Program) -> set[Address]:
    """Give the bits that a program names, those inside words as well."""
    named = {place for line in program.lines for place in line.places}
    return {bit for place in named for bit in program.dialect.bits_of(place)}


def _compared(machine: Machine, role: Mapping[str, str]) -> tuple[str, ...]:
    outputs = tuple(text for text in machine.writes if role.get(text) == "output")
    return outputs or tuple(machine.writes)
