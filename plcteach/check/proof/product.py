"""Two circuits over the same inputs, side by side, and the one question asked of them, whether an output can ever differ.

What is compared, what is assumed of the inputs, and what does not matter all become gates, so that no way of proving has to know
of them: `bad` is on where an output differs (one gate an output), `fair` where the inputs are such as may be.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import TYPE_CHECKING, Any

from plcteach.check.proof.circuit import Circuit, Setting, bases, circuit, split
from plcteach.check.proof.terms import condition
from plcteach.core.area import Address
from plcteach.machine.gates import Gate, Graph, differs
from plcteach.machine.scan import address_of
from plcteach.machine.words import Vector

if TYPE_CHECKING:
    from collections.abc import Callable, Hashable, Iterable, Sequence

    from plcteach.core.exercise import Terms
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.machine.gates import Compiled
    from plcteach.machine.store import Memory

NO_TIME = 1


@dataclass(frozen=True)
class Question:
    """What is asked of one kind of scan. bad: for each output where it differs; fair: where the inputs may be as they are.

    seen: for each output that is a bit and may differ, what the reference and the student's program give.
    """

    bad: dict[str, Gate]
    fair: Gate
    seen: dict[str, tuple[Gate, Gate]] = field(default_factory=dict)

    def of(self, wanted: Iterable[str]) -> Question:
        """Ask the same of some outputs only."""
        bad = {key: self.bad[key] for key in wanted}
        return Question(bad, self.fair, {key: pair for key, pair in self.seen.items() if key in bad})

    @property
    def gates(self) -> list[Gate]:
        """All gates that the answer depends on."""
        return [*self.bad.values(), self.fair, *(one for pair in self.seen.values() for one in pair)]

    def rewritten(self, graph: Graph, by: dict[Hashable, Gate]) -> Question:
        """Ask the same with some variables replaced."""
        new = iter(graph.rewritten(self.gates, by))
        bad = {key: next(new) for key in self.bad}
        fair = next(new)
        return Question(bad, fair, {key: (next(new), next(new)) for key in self.seen})


@dataclass(frozen=True)
class Product:
    """Both programs as one machine. state: the names of the remembered bits that matter, with their gates in `start` and `next`.

    inputs: the names of the variables that an operator, the clock or time moves, in order; those of them that are no operator's
    stand in `drift`.  unit: ms of a tick.
    """

    graph: Graph
    circuits: tuple[Circuit, Circuit]
    first: Question
    later: Question
    start: dict[Hashable, Gate]
    next: dict[Hashable, Gate]
    unit: int
    outputs: tuple[str, ...]
    state: tuple[Hashable, ...] = ()
    inputs: tuple[Hashable, ...] = ()

    @property
    def drift(self) -> frozenset[Hashable]:
        """The variables among the inputs that nobody presses: ticks and clocks."""
        return frozenset(name for name in self.inputs if isinstance(name, tuple) and name[0] != "in")

    @property
    def clocks(self) -> list[str]:
        """The clock bits among the inputs, which go by real time and cannot be made to wait."""
        return [name[1] for name in self.inputs if isinstance(name, tuple) and name[0] == "clock"]

    def scan(self, *, first: bool, beside: Sequence[Gate] = ()) -> Compiled:
        """Give the first scan as a function of the inputs, or a later one of state and inputs.

        It gives what is remembered then, whether an output differs, whether the inputs may be so, and what is asked for beside.
        """
        ends, question = (self.start, self.first) if first else (self.next, self.later)
        gates = [*(ends[name] for name in self.state), self.graph.any(question.bad.values()), question.fair, *beside]
        return self.graph.compiled(gates, self.inputs if first else (*self.state, *self.inputs))

    def of(self, outputs: Iterable[str]) -> Product:
        """Give the same question about some of the outputs only, with what matters for those."""
        wanted = tuple(outputs)
        one = replace(
            self,
            first=self.first.of(wanted),
            later=self.later.of(wanted),
            outputs=wanted,
        )
        return one.narrowed()

    def calm(self) -> Product:
        """Let the tick of the fastest timers always come at a scan's end, as it does in a scan of one ms."""
        zero = self.graph.zero
        by: dict[Hashable, Gate] = {name: zero for name in self.inputs if isinstance(name, tuple) and name[0] == "here"}
        if not by:
            return self

        def all_of(gates: dict[Any, Gate]) -> dict[Any, Gate]:
            return dict(zip(gates, self.graph.rewritten(list(gates.values()), by), strict=True))

        first, later = self.first.rewritten(self.graph, by), self.later.rewritten(self.graph, by)
        start, then = all_of(self.start), all_of(self.next)
        return replace(self, first=first, later=later, start=start, next=then).narrowed()

    def narrowed(self) -> Product:
        """Keep only the remembered bits and inputs on which the answer can depend."""
        roots = self.later.gates
        state: set[Hashable] = set()
        while True:
            names = set(self.graph.support([*roots, *(self.next[name] for name in state)]))
            found = {name for name in names if name in self.next}
            if found <= state:
                break
            state |= found
        seen = self.graph.support(
            [*roots, *self.first.gates] + [gate for name in state for gate in (self.next[name], self.start[name])]
        )
        inputs = tuple(sorted((name for name in seen if name not in self.next), key=_rank))
        kept = tuple(name for name in self.next if name in state)
        start, then = ({name: gates[name] for name in kept} for gates in (self.start, self.next))
        return replace(self, start=start, next=then, state=kept, inputs=inputs)


def _rank(name: Hashable) -> tuple[Any, ...]:
    """Put operators' inputs first, by address, then clocks and ticks."""
    parts = name if isinstance(name, tuple) else (name,)
    return (parts[0] != "in", *(f"{one:06d}" if isinstance(one, int) else _padded(str(one)) for one in parts))


def _padded(text: str) -> str:
    return ".".join(part.zfill(8) for part in text.split("."))


def product(reference: Program, student: Program, terms: Terms) -> Product:
    """Put two programs side by side; Unprovable where one of them has no circuit."""
    dialect = reference.dialect
    unit = min(bases(reference) | bases(student), default=NO_TIME)
    named = _named(terms, dialect)
    setting = Setting(Graph(), unit, named)
    pair = circuit(setting, 0, reference), circuit(setting, 1, student)
    free = _free(pair) | named
    if free != named:
        setting = Setting(Graph(), unit, free)
        pair = circuit(setting, 0, reference), circuit(setting, 1, student)
    outputs = tuple(address_of(dialect, one).text for one in terms.outputs) or compared(pair[0])
    ask = _Asking(setting.graph, pair, terms, outputs)
    start, then = _remembered(pair)
    if terms.single_change:
        for name in ask.pressed:
            start["was", name] = then["was", name] = setting.graph.variable(name)
    first, later = ask.question(first=True), ask.question(first=False)
    open_ones = {text for text in first.bad if first.bad[text].number or later.bad[text].number}
    first, later = (
        replace(one, seen={key: one.seen[key] for key in one.seen if key in open_ones}) for one in (first, later)
    )
    return Product(setting.graph, pair, first, later, start, then, unit, tuple(first.bad)).narrowed()


def _named(terms: Terms, dialect: Dialect) -> frozenset[str]:
    """Give the inputs that the terms name, whether a program does or not."""
    formulas = (*terms.assume, *terms.never, *terms.dont_care.values())
    places = [place for text in formulas for place in condition(text, dialect).addresses.values()]
    return frozenset(place.text for place in places if dialect.area(place).role == "input")


def _remembered(pair: tuple[Circuit, Circuit]) -> tuple[dict[Hashable, Gate], dict[Hashable, Gate]]:
    """Give what both remember, after the first scan and after a later one, each by its program and its key."""
    start: dict[Hashable, Gate] = {}
    then: dict[Hashable, Gate] = {}
    for side, one in enumerate(pair):
        start |= {(side, *key): gate for key, gate in split(one.start.items()).items()}
        then |= {(side, *key): gate for key, gate in split(one.next.items()).items()}
    return {name: start.get(name, pair[0].graph.zero) for name in then}, then


def _free(pair: tuple[Circuit, Circuit]) -> frozenset[str]:
    """Give the bits that the reference reads and nobody writes: they are inputs of the task, whatever area they lie in."""
    dialect = pair[0].program.dialect
    found = set()
    for text in pair[0].reads - pair[0].writes - pair[1].writes:
        place = dialect.address(text)
        if not isinstance(place, Address) or place.size != 1 or text in dialect.specials:
            continue
        if dialect.area(place).role == "memory" and dialect.block(place) is None and not place.field:
            found.add(place.text)
    return frozenset(found)


def compared(one: Circuit) -> tuple[str, ...]:
    """Give the outputs that a program writes; where it writes none, everything that it writes."""
    dialect = one.program.dialect
    written = one.writes - set(dialect.specials)
    places = [place for text in written if isinstance(place := dialect.address(text), Address)]
    others = [place for place in ordered(places) if place.size == 1 or dialect.block(place) is None]
    return driven(dialect, places) or tuple(place.text for place in others)


def driven(dialect: Dialect, places: Iterable[Address]) -> tuple[str, ...]:
    """Give those of some places that are outputs of the machine, in order."""
    return tuple(place.text for place in ordered(places) if dialect.area(place).role == "output")


def ordered(places: Iterable[Address]) -> list[Address]:
    """Put places in the order in which they are listed."""
    return sorted(places, key=lambda place: (place.area, place.index, place.text))


@dataclass
class _Asking:
    """The terms of a comparison, as gates."""

    graph: Graph
    pair: tuple[Circuit, Circuit]
    terms: Terms
    outputs: tuple[str, ...]

    @property
    def pressed(self) -> list[Hashable]:
        """The inputs that an operator can press."""
        return [name for name in self.graph.variables if isinstance(name, tuple) and name[0] == "in"]

    def question(self, *, first: bool) -> Question:
        """Ask about the first scan, or about any later one."""
        memories = tuple(one.first if first else one.later for one in self.pair)
        bad = {text: self.differ(text, memories) for text in self.outputs}
        for text in self.terms.never:
            made = self.formula(text, 1, memories[1])
            bad[text] = made.surely | made.unknown
        fair = self.graph.one
        for text in self.terms.assume:
            fair &= self.formula(text, 0, memories[0]).surely
        if self.terms.single_change:
            fair &= self.one_change(first=first)
        return Question(bad, fair, {text: pair for text in self.outputs if (pair := self.both(text, memories))})

    def values(self, text: str, memories: tuple[Memory[Any], ...]) -> tuple[Any, Any]:
        """Give what an output holds in both programs."""
        place = address_of(self.pair[0].program.dialect, text)
        mine, theirs = (one.value(memory, place) for one, memory in zip(self.pair, memories, strict=True))
        return mine, theirs

    def differ(self, text: str, memories: tuple[Memory[Any], ...]) -> Gate:
        """Say where an output differs, or is x in the student's program, and it matters."""
        mine, theirs = self.values(text, memories)
        wrong = self.graph.zero
        for a, b in _pairs(mine, theirs):
            wrong |= differs(a, b) | b.unknown
        spared = self.terms.dont_care.get(text)
        return wrong & ~self.formula(spared, 0, memories[0]).surely if spared else wrong

    def both(self, text: str, memories: tuple[Memory[Any], ...]) -> tuple[Gate, Gate] | None:
        """Give what both programs put out; None where it is no bit."""
        mine, theirs = self.values(text, memories)
        return None if isinstance(mine, Vector) else (mine.surely, theirs.surely)

    def formula(self, text: str, side: int, memory: Memory[Any]) -> Any:
        """Work a formula out over what a program's memory holds."""
        one = self.pair[side]
        value: Callable[[Address], Any] = lambda place: one.value(memory, place)  # noqa: E731
        return condition(text, one.program.dialect).worked(value)

    def one_change(self, *, first: bool) -> Gate:
        """Say where at most one input is another than in the scan before; before the first all are 0."""
        now = [self.graph.variable(name) for name in self.pressed]
        if not first:
            now = [one ^ self.graph.variable(("was", name)) for one, name in zip(now, self.pressed, strict=True)]
        return ~self.graph.any(a & b for a, b in combinations(now, 2))


def _pairs(mine: Any, theirs: Any) -> list[tuple[Any, Any]]:
    if not isinstance(mine, Vector):
        return [(mine, theirs)]
    size = max(len(mine.signs), len(theirs.signs))
    return [(mine.at(place), theirs.at(place)) for place in range(size)]
