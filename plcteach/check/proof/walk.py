"""One step of two programs side by side, for every combination of inputs at once.

A state is a whole number with a bit for each thing remembered; `None` is the moment before the first scan. A case is a whole
number with a bit for each input. At the level "exact" a step is a scan. At the level "settled" it is as many scans as both need
to come to rest with the inputs held: first, where a tick comes, with the inputs as they were, then with the new ones and no time.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plcteach.check.proof.circuit import TICK
from plcteach.check.proof.table import patterns

if TYPE_CHECKING:
    from collections.abc import Generator, Hashable, Iterator, Sequence

    from plcteach.check.proof.budget import Budget
    from plcteach.check.proof.product import Product
    from plcteach.machine.gates import Compiled

MOST_SETTLING_SCANS = 32
Scan = dict["Hashable", int]


def of_time(name: Hashable) -> bool:
    """Say whether an input is time passing, and nothing that is held."""
    return name == TICK or (isinstance(name, tuple) and name[0] == "here")


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a step from one state leads to. parts: sets of cases with the state that each leads to.

    bad: the cases in which an output differs; restless: for each program the cases in which it never comes to rest.
    """

    parts: list[tuple[int, int | None]]
    bad: int
    restless: tuple[int, int] = (0, 0)


class _Pulses:
    """What the outputs did on the way to rest: those that changed twice or more in one program, and not so in the other.

    At rest a pulse of one scan has left no trace. So one that the reference gives must come, be it a scan later, and one that it
    does not give must not. But rungs in another order may well give one where several inputs change in the same scan, or at
    power-on: that is overlooked, as is whatever else differs on the way.
    """

    def __init__(self, seen: Sequence[int]) -> None:
        self.last, self.once, self.twice = list(seen), [0] * len(seen), [0] * len(seen)

    def see(self, seen: Sequence[int]) -> None:
        """Take in the outputs of one more scan, the reference's and the student's by turns."""
        for place, value in enumerate(seen):
            changed = value ^ self.last[place]
            self.twice[place] |= self.once[place] & changed
            self.once[place] |= changed
        self.last = list(seen)

    def odd(self, plain: int) -> int:
        """Give the cases in which only one of the two gave a pulse (only the student's: in plain cases), and begin anew."""
        cases = 0
        for mine, theirs in zip(self.twice[::2], self.twice[1::2], strict=True):
            cases |= mine & ~theirs | theirs & ~mine & plain
        self.once, self.twice = [0] * len(self.last), [0] * len(self.last)
        return cases


class Walker:
    """The two programs as functions of state and inputs.

    pulses: at rest a pulse on the way there counts as well.
    """

    def __init__(self, product: Product, budget: Budget, *, settled: bool = False, pulses: bool = False) -> None:
        self.product, self.budget, self.settled = product, budget, settled
        self.watch: _Pulses | None = None
        texts = sorted(set(product.first.seen) & set(product.later.seen)) if pulses and settled else []
        self.watched = 2 * len(texts)
        self.state, self.inputs = product.state, product.inputs
        self.first = product.scan(first=True, beside=[gate for text in texts for gate in product.first.seen[text]])
        self.later = product.scan(first=False, beside=[gate for text in texts for gate in product.later.seen[text]])
        self.every = (1 << (1 << len(self.inputs))) - 1
        self.rows = patterns(len(self.inputs))
        self.timed = list(map(of_time, self.inputs))
        self.sides = [int(isinstance(name, tuple) and name[0] == 1) for name in self.state]
        self.bad = False
        self.lasting = sum(1 << place for place, timed in enumerate(self.timed) if not timed)
        self.pressed = sum(1 << place for place, name in enumerate(self.inputs) if name not in product.drift)
        self.weight = 1 + (len(self.every.to_bytes(-(-self.every.bit_length() // 8))) >> 6)

    def step(self, state: int | None, before: int = 0) -> Outcome:
        """Give what follows from one state for all inputs at once; `before`: the case of the step that led there."""
        if self.settled:
            return self._settled(state, before)
        if state is None:
            self.budget.spend(self.first.cost * self.weight)
            *ends, bad, fair = self.first.call(self.rows, self.every)
        else:
            self.budget.spend(self.later.cost * self.weight)
            *ends, bad, fair = self.later.call([*self._spread(state), *self.rows], self.every)
        return Outcome(self._parts(ends, fair), bad & fair)

    def _spread(self, state: int) -> list[int]:
        return [self.every if state >> place & 1 else 0 for place in range(len(self.state))]

    def _parts(self, ends: Sequence[int], fair: int) -> list[tuple[int, int | None]]:
        """Part the cases by the state that they lead to."""
        parts = [(fair, 0)] if fair else []
        for place, column in enumerate(ends):
            if not column:
                continue
            bit, split = 1 << place, []
            for cases, state in parts:
                on = cases & column
                if on != cases:
                    split.append((cases ^ on, state))
                if on:
                    split.append((on, state | bit))
            parts = split
        self.budget.spend(len(parts) * len(ends) * self.weight >> 1)
        return parts  # type: ignore[return-value]

    def _settled(self, state: int | None, before: int) -> Outcome:
        still = [0 if timed else row for timed, row in zip(self.timed, self.rows, strict=True)]
        bad, moved = 0, [0, 0]
        if state is None:
            self.watch = _Pulses([0] * self.watched)
            ends, (_, fair) = self._taken(self.first, still)
        else:
            ends, fair = self._spread(state), self.every
            held = [self.every if before >> place & 1 else 0 for place in range(len(self.inputs))]
            quiet = [0 if timed else value for timed, value in zip(self.timed, held, strict=True)]
            self.watch = None
            if self.watched:
                self._scan(ends, quiet)
            if any(self.timed):
                tick = [row if timed else value for timed, value, row in zip(self.timed, held, self.rows, strict=True)]
                ends, _ = self._scan(ends, tick)
                ends, bad, _ = self._rest(ends, quiet, moved)
                bad |= self.watch.odd(self.every) if self.watch else 0
        ends, worse, fairly = self._rest(ends, still, moved)
        worse |= self.watch.odd(self._single(before) if state is not None else 0) if self.watch else 0
        fair &= fairly
        return Outcome(self._parts(ends, fair), (bad | worse) & fair, (moved[0] & fair, moved[1] & fair))

    def _single(self, before: int) -> int:
        """Give the cases in which at most one input is another than before."""
        one = two = 0
        for place, row in enumerate(self.rows):
            if not self.timed[place]:
                changed = row ^ self.every if before >> place & 1 else row
                two |= one & changed
                one |= changed
        return self.every & ~two

    def _scan(self, ends: Sequence[int], inputs: Sequence[int]) -> tuple[list[int], tuple[int, int]]:
        return self._taken(self.later, [*ends, *inputs])

    def _taken(self, call: Compiled, values: Sequence[int]) -> tuple[list[int], tuple[int, int]]:
        """Run a scan: what is remembered then, where an output differs, and where the inputs may be as they are."""
        self.budget.spend(call.cost * self.weight)
        found = call.call(values, self.every)
        count = len(self.state)
        if self.watched:
            seen = found[count + 2 :]
            if self.watch is None:
                self.watch = _Pulses(seen)
            self.watch.see(seen)
        return list(found[:count]), (found[count], found[count + 1])

    def _rest(self, ends: list[int], inputs: Sequence[int], moved: list[int]) -> tuple[list[int], int, int]:
        """Scan until nothing changes; note in which cases that never happens, and in which program."""
        fair = self.every
        for _ in range(MOST_SETTLING_SCANS):
            after, (bad, fairly) = self._scan(ends, inputs)
            fair &= fairly
            if after == ends:
                return after, bad, fair
            before, ends = ends, after
        for side, old, new in zip(self.sides, before, ends, strict=True):
            moved[side] |= old ^ new
        return ends, bad & ~(moved[0] | moved[1]), fair

    def scans(self, cases: Sequence[int]) -> Iterator[Scan]:
        """Give the scans that some steps stand for, each with its inputs by name; the last one shows the difference."""
        if not self.settled:
            yield from map(self._named, cases)
            return
        state: int | None = None
        old = 0
        for number, case in enumerate(cases):
            quiet, held = self._without_time(case), self._without_time(old)
            if state is not None and case != quiet:
                state = yield from self._held(state, held | case ^ quiet, held)
                if number + 1 == len(cases) and self._shows(state, held):
                    if not self.bad:
                        yield self._named(held)
                    return
            if state is None or quiet != held or case == quiet:
                state = yield from self._held(state, quiet, quiet)
            old = case
        if state is not None and not self.bad:
            yield self._named(self._without_time(old))

    def _shows(self, state: int, case: int) -> bool:
        """Say whether a scan shows a difference now, or one more with the same inputs does."""
        if self.bad:
            return True
        self._one(state, case)
        found, self.bad = self.bad, False
        return found

    def _held(self, state: int | None, case: int, still: int) -> Generator[Scan, None, int]:
        """Give a scan of one case, and further ones of another until nothing changes."""
        yield self._named(case)
        now = self._one(state, case)
        for _ in range(MOST_SETTLING_SCANS):
            shown = self.bad
            after = self._one(now, still)
            if after == now:
                self.bad = shown
                break
            yield self._named(still)
            now = after
        return now

    def _one(self, state: int | None, case: int) -> int:
        """Run one scan of one case."""
        inputs = [case >> place & 1 for place in range(len(self.inputs))]
        if state is None:
            found = self.first.call(inputs, 1)
        else:
            remembered = [state >> place & 1 for place in range(len(self.state))]
            found = self.later.call([*remembered, *inputs], 1)
        count = len(self.state)
        self.bad = bool(found[count])
        return sum(bit << place for place, bit in enumerate(found[:count]))

    def _without_time(self, case: int) -> int:
        return case & self.lasting

    def _named(self, case: int) -> Scan:
        return {name: case >> place & 1 for place, name in enumerate(self.inputs)}
