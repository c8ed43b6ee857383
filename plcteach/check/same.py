"""Whether two programs are the same machine, seen from their inputs and outputs: proved, refuted, or honestly not known.

The machine that is animated is the one that grades: a scan is run once over `Column`s that hold every combination of inputs, so
2^n rows cost one run. Three ways are tried, in this order:

* no memory: all rows of one scan decide (proof "table");
* induction: the remembered bits of both programs are inputs too. Those that always agree are found by splitting classes: at
  first all that are equal after the first scan, then, scan by scan, only those that stay equal if they were. If the outputs
  agree under that hypothesis they agree for ever (proof "induction");
* from power-on: every state that both can reach together is visited, breadth first, all inputs of a scan at once. Running out
  of states is a proof ("exhaustive"), a difference is a counterexample with the fewest scans, and running out of budget is
  "unknown". Budgets count states, never seconds, so that a verdict is the same on every machine.

Edge memories belong to lines, and the two programs need not have the same lines: that is why classes are found, not named.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.source import Span
from plcteach.core.verdict import Counterexample, Status, Verdict
from plcteach.machine.rows import Rows
from plcteach.machine.scan import Domain, Memory, run, sweep
from plcteach.machine.signals import ONE, ZERO, Column, X

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from plcteach.core.program import Program
    from plcteach.machine.step import Step

MOST_VARIABLES = 20
MOST_SEARCHED_INPUTS = 12
MOST_STATES = 4_000
MOST_INSTRUCTIONS = 2_000

Key = tuple[str, str | int]
"""A remembered bit of one program: ("bit", address), ("image", address) or ("past", line number)."""


@dataclass(frozen=True)
class _Machine:
    """One of the two programs, with what it reads, writes and remembers."""

    program: Program
    reads: frozenset[str]
    writes: frozenset[str]
    state: tuple[Key, ...]

    def scan(self, inputs: Mapping[str, Column], state: Mapping[Key, Column], rows: Rows, *, first: bool) -> _Result:
        """Run one scan over columns from a given state."""
        memory = _memory(state, first=first)
        after = sweep(self.program, memory, inputs, rows.domain)
        outputs = {address: after.bits.get(address, rows.domain.zero) for address in self.writes}
        return _Result(outputs, {key: _kept(after, key, rows.domain.zero) for key in self.state})


@dataclass(frozen=True)
class _Result:
    """The outputs and the remembered bits at a scan's end."""

    outputs: dict[str, Column]
    state: dict[Key, Column]


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


def _machine(program: Program) -> _Machine:
    """Watch one scan to see what a program reads, writes and remembers (no instruction here is conditional)."""
    reads: set[str] = set()
    writes: set[str] = set()
    past: list[Key] = []
    edges_of: set[str] = set()

    def watch(number: int, one: Step[Column]) -> None:
        reads.update(address.text for address, _ in one.read)
        writes.update(address.text for address, _ in one.written)
        if any(verb.name in {"set", "reset"} for verb in one.line.insn.then):
            reads.update(address.text for address, _ in one.written)
        if one.remembered is not None:
            past.append(("past", number))
            edges_of.update(address.text for address, _ in one.read)

    sweep(program, Memory(), {}, Domain(ZERO, ONE, X), watch)
    dialect = program.dialect
    state: list[Key] = [("bit", address) for address in sorted(writes & reads)]
    if dialect.samples_edges_at_start:
        state += [("image", address) for address in sorted(edges_of)]
    else:
        state += past
    return _Machine(program, frozenset(reads), frozenset(writes), tuple(state))


@dataclass(frozen=True)
class _Pair:
    """The two machines side by side, the free inputs and the outputs that are compared."""

    reference: _Machine
    student: _Machine
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]

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
            results.append(machine.scan(inputs, mine, rows, first=first))
        zero = rows.domain.zero
        differ = {
            address: results[0].outputs.get(address, zero).differs(results[1].outputs.get(address, zero))
            | results[1].outputs.get(address, zero).unknown
            for address in self.outputs
        }
        return differ, {(side, key): value for side, one in enumerate(results) for key, value in one.state.items()}


def compare(reference: Program, student: Program, *, outputs: Iterable[str] = ()) -> Verdict:
    """Judge whether the student's program does what the reference does; neither may have an error.

    outputs: the addresses compared; by default the outputs that the reference writes.
    """
    pair = _pair(reference, student, tuple(outputs))
    if _instructions(reference) == _instructions(student):
        return Verdict("equal", "structural", outputs=dict.fromkeys(pair.outputs, "equal"), diagnostics=_beside(pair))
    if max(len(reference.lines), len(student.lines)) > MOST_INSTRUCTIONS or len(pair.inputs) > MOST_VARIABLES:
        return Verdict("unknown", outputs=dict.fromkeys(pair.outputs, "unknown"), diagnostics=_beside(pair))
    at_first, after = _first_scan(pair)
    agreed = at_first & _induction(pair, after)
    if len(agreed) == len(pair.outputs):
        proof = "induction" if pair.state else "table"
        return Verdict("equal", proof, None, dict.fromkeys(pair.outputs, "equal"), _beside(pair), 1)  # type: ignore[arg-type]
    return _search(pair, agreed)


def _instructions(program: Program) -> list[list[tuple[str, str]]]:
    """Give a program as its instructions alone: comments, titles and headings do not count."""
    return [[(line.text, line.effect.text) for line in one.lines] for one in program.networks if one.lines]


def _pair(reference: Program, student: Program, wanted: tuple[str, ...]) -> _Pair:
    mine, theirs = _machine(reference), _machine(student)
    driven = frozenset(reference.dialect.specials)
    written = mine.writes | theirs.writes
    areas = {
        address.text: address for program in (reference, student) for line in program.lines for address in line.bits
    }
    role = {text: reference.dialect.area(address).role for text, address in areas.items()}
    inputs = {text for text in mine.reads | theirs.reads if role.get(text) == "input"}
    inputs |= {text for text in mine.reads if text not in written | driven}
    outputs = wanted or _compared(mine, role)
    order = {
        text: number
        for number, text in enumerate(sorted(areas, key=lambda text: (areas[text].area, areas[text].index)))
    }
    return _Pair(
        mine,
        theirs,
        tuple(sorted(inputs, key=order.__getitem__)),
        tuple(sorted(outputs, key=lambda one: order.get(one, -1))),
    )


def _compared(machine: _Machine, role: Mapping[str, str]) -> tuple[str, ...]:
    outputs = tuple(text for text in machine.writes if role.get(text) == "output")
    return outputs or tuple(machine.writes)


def _beside(pair: _Pair) -> tuple[Diagnostic, ...]:
    """Say which outputs the student writes beyond the reference, and which never."""
    mine, theirs = pair.reference.writes, pair.student.writes
    places = {arg.text: line.span for line in pair.student.program.lines if line.insn.then for arg in line.bits}
    dialect = pair.student.program.dialect
    roles = {arg.text: dialect.area(arg).role for line in pair.student.program.lines for arg in line.bits}
    extra = [
        rule("CHK001").at(places[text], address=text) for text in sorted(theirs - mine) if roles.get(text) == "output"
    ]
    missing = [rule("CHK002").at(Span(0), address=text) for text in pair.outputs if text not in theirs]
    return tuple(extra + missing)


def _first_scan(pair: _Pair) -> tuple[set[str], dict[tuple[int, Key], Column]]:
    """Run the first scan from power-on over all inputs: the outputs that agree in it, and the state after."""
    rows = Rows(len(pair.inputs))
    inputs = {address: rows.variable(number) for number, address in enumerate(pair.inputs)}
    differ, after = pair.scan(inputs, {}, rows, first=True)
    return {address for address, cases in differ.items() if not cases}, after


def _either(columns: Iterable[int]) -> int:
    union = 0
    for one in columns:
        union |= one
    return union


def _simplest(cases: int) -> int:
    """Give the case with the fewest inputs on, the first of those."""
    best, at = -1, 0
    while cases:
        skip = (cases & -cases).bit_length() - 1
        at += skip
        if best < 0 or at.bit_count() < best.bit_count():
            best = at
        if best.bit_count() <= 1:
            return best
        cases >>= skip + 1
        at += 1
    return best


def _induction(pair: _Pair, after: dict[tuple[int, Key], Column]) -> set[str]:
    """Find the remembered bits that always agree, and give the outputs that then agree in every later scan."""
    classes = _classes(dict.fromkeys(pair.state, 0), after)
    while True:
        count = len(set(classes.values()))
        if len(pair.inputs) + count > MOST_VARIABLES:
            return set()
        rows = Rows(len(pair.inputs) + count)
        inputs = {address: rows.variable(number) for number, address in enumerate(pair.inputs)}
        state = {key: rows.variable(len(pair.inputs) + number) for key, number in classes.items()}
        differ, then = pair.scan(inputs, state, rows, first=False)
        split = _classes(classes, then)
        if len(set(split.values())) == count:
            return {address for address, cases in differ.items() if not cases}
        classes = split


def _classes(
    old: Mapping[tuple[int, Key], int], values: Mapping[tuple[int, Key], Column]
) -> dict[tuple[int, Key], int]:
    """Split classes: two remembered bits stay together only if they were and are equal."""
    numbers: dict[tuple[int, Column], int] = {}
    return {key: numbers.setdefault((old[key], value), len(numbers)) for key, value in values.items() if key in old}


_State = tuple[str, ...]


def _search(pair: _Pair, agreed: set[str]) -> Verdict:
    """Visit the states that both reach from power-on, breadth first, until they differ, end, or use up the budget."""
    rows = Rows(len(pair.inputs))
    inputs = {address: rows.variable(number) for number, address in enumerate(pair.inputs)}
    start: _State = ("",)
    came: dict[_State, tuple[_State, int] | None] = {start: None}
    waiting = [start]
    explored = 0
    while waiting:
        following: list[_State] = []
        for state in waiting:
            explored += 1
            differ, after = pair.scan(inputs, _columns(pair, state, rows), rows, first=state == start)
            cases = _either(differ.values())
            if cases:
                case = _simplest(cases)
                return _different(pair, [*_path(came, state), case], agreed, explored)
            if len(pair.inputs) > MOST_SEARCHED_INPUTS or explored >= MOST_STATES:
                return _unknown(pair, agreed, explored)
            for case, new in _successors(pair, after, rows):
                if new not in came:
                    came[new] = (state, case)
                    following.append(new)
        waiting = following
    return Verdict("equal", "exhaustive", None, dict.fromkeys(pair.outputs, "equal"), _beside(pair), explored)


def _unknown(pair: _Pair, agreed: set[str], explored: int) -> Verdict:
    outputs: dict[str, Status] = {address: "equal" if address in agreed else "unknown" for address in pair.outputs}
    return Verdict("unknown", None, None, outputs, _beside(pair), explored)


def _columns(pair: _Pair, state: _State, rows: Rows) -> dict[tuple[int, Key], Column]:
    bits = {"0": ZERO, "1": ONE, "x": X}
    if state == ("",):
        return {}
    return {key: rows.constant(bits[value]) for key, value in zip(pair.state, state, strict=True)}


def _successors(pair: _Pair, after: Mapping[tuple[int, Key], Column], rows: Rows) -> Iterable[tuple[int, _State]]:
    """Give each state that some inputs lead to, once, with the simplest such inputs first."""
    columns = [after[key] for key in pair.state]
    if all(one.may0 == 0 or one.may1 == 0 for one in columns):
        yield 0, tuple(one.at(0) for one in columns)
        return
    seen = set()
    for case in sorted(range(rows.cases), key=int.bit_count):
        new = tuple(one.at(case) for one in columns)
        if new not in seen:
            seen.add(new)
            yield case, new


def _path(came: Mapping[_State, tuple[_State, int] | None], state: _State) -> list[int]:
    cases: list[int] = []
    step = came[state]
    while step is not None:
        cases.append(step[1])
        step = came[step[0]]
    return cases[::-1]


def _different(pair: _Pair, cases: list[int], agreed: set[str], explored: int) -> Verdict:
    """Replay the found inputs on the plain machine, so that what is shown is what it does."""
    scans = tuple({address: case >> number & 1 for number, address in enumerate(pair.inputs)} for case in cases)
    expected, got = (run(machine.program, scans) for machine in (pair.reference, pair.student))
    rows = [
        tuple({address: repr(scan[address]) for address in pair.outputs} for scan in trace.scans)
        for trace in (expected, got)
    ]
    wrong = [
        address
        for address in pair.outputs
        if rows[0][-1][address] != rows[1][-1][address] or rows[1][-1][address] == "x"
    ]
    outputs: dict[str, Status] = {
        address: "different" if address in wrong else "equal" if address in agreed else "unknown"
        for address in pair.outputs
    }
    counterexample = Counterexample(scans, rows[0], rows[1], len(scans) - 1, wrong[0])
    return Verdict("different", None, counterexample, outputs, _beside(pair), explored)
