"""Draws random ladders of a kind and a level of difficulty in the addresses of any family; each contact counts.

A contact is never drawn twice in a rung, so that what comes out always depends on it. Timers, counters and edges are found in the
family's table by what they do.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.drilling.blocks import Blocks
from plcteach.core.ladder import Branch, Coil, Contact, Edge, Ladder, Node, Rung, branch, parallel, rung, series

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.check.drilling.dice import Dice
    from plcteach.core.spec import Dialect, Use

MOST_LEVEL = 5
_NEGATED = 0.35
_FEW_INPUTS = 8


class Shapes:
    """One ladder in the making: which addresses are still free, and the dice."""

    def __init__(self, dialect: Dialect, dice: Dice, level: int) -> None:
        self.dialect, self.dice, self.level = dialect, dice, level
        self.inputs = self.free("input", _FEW_INPUTS) + self.free("input", 3 * _FEW_INPUTS, _FEW_INPUTS)
        self.outputs = self.free("output", 4)
        self.memory = [self.bit("memory", number) for number in range(_FEW_INPUTS)]
        self.blocks = Blocks(dialect)

    def bit(self, use: Use, number: int) -> str:
        """Give the bit of a use with a number."""
        prefix = self.dialect.counterparts[use]
        return next(one for one in self.dialect.areas if one.prefix == prefix).address(number).text

    def free(self, use: Use, stop: int, start: int = 0) -> list[str]:
        """Give some of the bits of a use in another order."""
        return self.dice.mixed(self.bit(use, number) for number in range(start, stop))

    # contacts and blocks

    def contact(self, *, plain: bool = False) -> Contact:
        """Give a contact of an input that has not been used."""
        return Contact(self.inputs.pop(0), negated=not plain and self.dice.falls(_NEGATED))

    def coil(self) -> Coil:
        """Give a coil of an output that has not been used."""
        return Coil(self.outputs.pop(0))

    def some(self, count: int) -> list[Node]:
        """Give so many contacts."""
        return [self.contact() for _ in range(count)]

    def chain(self, count: int) -> Node:
        """Give contacts of which each stands in series or in parallel with all before it, both ways occurring."""
        node: Node = self.contact()
        ways = [self.dice.falls(0.5) for _ in range(count - 1)]
        if len(ways) > 1 and len(set(ways)) == 1:
            ways[self.dice.number(0, len(ways) - 1)] ^= True
        for onward in ways:
            node = series(node, self.contact()) if onward else parallel(node, self.contact())
        return node

    def block(self, size: int, *, onward: bool, deep: bool = False) -> Node:
        """Give a series (or parallel) block; deep: one of its parts is a block of the other kind with blocks in it."""
        parts = self.some(size - deep)
        if deep:
            inner = [self.block(2, onward=onward) for _ in range(2)]
            parts.append(parallel(*inner) if onward else series(*inner))
        return series(*parts) if onward else parallel(*parts)

    def joined(self, count: int, *, deep: int = 0) -> Node:
        """Give blocks in parallel or in series; deep: so many of them have blocks inside."""
        onward = self.dice.falls(0.6)
        sizes = [2 + (self.level > 1 and self.dice.falls(0.3)) for _ in range(count)]
        parts = [self.block(size, onward=onward, deep=number < deep) for number, size in enumerate(sizes)]
        parts = self.dice.mixed(parts)
        return parallel(*parts) if onward else series(*parts)

    # the kinds

    def contacts(self) -> list[Rung]:
        """Give series and parallel of single contacts; from level 4 on a second output further to the right."""
        stem = self.chain(self.level + 1 + self.dice.number(0, 1))
        if self.level < MOST_LEVEL - 1:
            return [rung(stem, self.coil())]
        more = rung(self.chain(3), self.coil())
        return [rung(stem, self.coil(), Branch(self.contact(), (self.coil(),))), *([more] if self.level > 4 else [])]  # noqa: PLR2004 (the hardest)

    def blocks_joined(self) -> list[Rung]:
        """Give a rung whose blocks want joins."""
        counts = {1: 2, 2: self.dice.number(2, 3), 3: 3, 4: 2, 5: 3}
        stem = self.joined(counts[self.level], deep=max(0, self.level - 3))
        if self.level > 2 and self.dice.falls(0.4):  # noqa: PLR2004 (from the middle on)
            stem = series(stem, self.contact())
        return [rung(stem, self.coil())]

    def branches(self) -> list[Rung]:
        """Give a rung with a branch point; from level 4 on one behind another."""
        count = 2 if self.level == 1 else 3
        stem = self.contact() if self.level < 3 else self.chain(2)  # noqa: PLR2004 (from the middle on)
        nested = self.level - 3 if self.level > 3 else 0  # noqa: PLR2004 (from the middle on)
        if nested:
            self.outputs += [self.bit("output", number) for number in range(4, 8)]
        paths = []
        for number in range(count):
            node = self.path()
            if number < nested:
                paths.append(branch(node, *(branch(self.path(), self.coil()) for _ in range(2))))
            else:
                paths.append(branch(node, self.coil()))
        return [rung(stem, *self.dice.mixed(paths))]

    def path(self) -> Node:
        """Give what stands in one output path."""
        if self.level > 2 and self.dice.falls(0.4):  # noqa: PLR2004 (from the middle on)
            return self.block(2, onward=self.dice.falls(0.5))
        return self.contact()

    def set_reset(self) -> list[Rung]:
        """Give outputs that are set by one rung and reset by the next, or the other way round."""
        rungs = []
        for _ in range(1 if self.level < MOST_LEVEL - 1 else 2):
            address = self.outputs.pop(0)
            pair = [
                rung(self.condition(), Coil(address, "set")),
                rung(self.condition(), Coil(address, "reset")),
            ]
            rungs += self.dice.mixed(pair)
        if self.level in {3, MOST_LEVEL}:
            last = rungs[-1].outs[0]
            address = last.address if isinstance(last, Coil) else ""
            rungs.append(rung(series(Contact(address), self.contact()), self.coil()))
        return rungs

    def condition(self) -> Node:
        """Give a condition of two contacts; at level 1 one that closes, and at level 4 one or two."""
        single = self.level == 1 or (self.level == MOST_LEVEL - 1 and self.dice.falls(0.5))
        return self.contact(plain=True) if single else self.chain(2)

    # edges

    def edge(self, *, rising: bool) -> Node:
        """Give a contact that closes for one scan, or a contact and an edge on the wire where the family has it so."""
        contact = self.contact(plain=True)
        row = self.dialect.words.get(self.dialect.roles.get("rise", ""))
        if row is None or not row.operands:
            return Contact(contact.address, edge="rise" if rising else "fall")
        return series(contact, Edge(rising=rising, memory=self.memory.pop(0)))

    def edges(self) -> list[Rung]:
        """Give outputs that are on for one scan, then what they set and reset, and last one button that turns a lamp on and off."""
        rising = self.dice.falls(0.5)
        edge = self.edge(rising=rising)
        if self.level == 1:
            return [rung(edge, self.coil())]
        if self.level == 2:  # noqa: PLR2004 (an easy one)
            return [rung(series(edge, *self.some(self.dice.number(1, 2))), self.coil())]
        if self.level == 3:  # noqa: PLR2004 (the middle)
            return [rung(series(parallel(edge, self.edge(rising=not rising)), self.contact()), self.coil())]
        address = self.outputs.pop(0)
        if self.level < MOST_LEVEL:
            pair = [
                rung(edge, Coil(address, "set")),
                rung(parallel(self.edge(rising=not rising), self.contact(plain=True)), Coil(address, "reset")),
            ]
            return self.dice.mixed(pair)
        pulse = self.memory.pop()
        turned = parallel(
            series(Contact(pulse), Contact(address, negated=True)),
            series(Contact(pulse, negated=True), Contact(address)),
        )
        return [rung(edge, Coil(pulse)), rung(series(turned, self.contact()), Coil(address))]

    # time

    def timers(self) -> list[Rung]:
        """Give an on-delay, then two of them one after the other, and last one that keeps itself going."""
        timer = self.blocks.timer(self.dice.number(3, 9) * 5 if self.level > 1 else self.dice.number(2, 6) * 5)
        if self.level < 4:  # noqa: PLR2004 (one timer)
            stem = self.contact(plain=True) if self.level == 1 else self.chain(2)
            out = self.coil()
            done = Contact(timer.bit) if self.level < 3 else series(Contact(timer.bit, negated=True), self.contact())  # noqa: PLR2004
            return [rung(stem, timer.box), rung(done, out)]
        going, later = self.memory.pop(), self.blocks.timer(self.dice.number(2, 6) * 5)
        start = series(parallel(self.contact(plain=True), Contact(going)), self.contact())
        first = rung(start, Coil(going)) if self.level == MOST_LEVEL else rung(self.chain(2), Coil(going))
        return [
            first,
            rung(Contact(going), timer.box),
            rung(Contact(timer.bit), later.box),
            rung(series(Contact(timer.bit), Contact(later.bit, negated=True)), self.coil()),
            *([rung(Contact(later.bit), self.coil())] if self.level == MOST_LEVEL else []),
        ]

    def counters(self) -> list[Rung]:
        """Give a counter with its reset, then with conditions, and last two of them one after the other."""
        preset = self.dice.number(2, 3 if self.level > 3 else 5)  # noqa: PLR2004 (two counters)
        count = self.contact(plain=True) if self.level < 3 else self.chain(2)  # noqa: PLR2004
        reset = self.contact(plain=True) if self.level < 4 else self.chain(2)  # noqa: PLR2004
        counter = self.blocks.counter(preset, count, reset)
        done = Contact(counter.bit) if self.level == 1 else series(Contact(counter.bit), self.contact())
        rungs = [*counter.rungs, rung(done, self.coil())]
        if self.level == MOST_LEVEL:
            more = self.blocks.counter(2, Contact(counter.bit), self.contact(plain=True))
            rungs += [*more.rungs, rung(Contact(more.bit), self.coil())]
        return rungs


KINDS: dict[str, Callable[[Shapes], list[Rung]]] = {
    "contacts": Shapes.contacts,
    "blocks": Shapes.blocks_joined,
    "branches": Shapes.branches,
    "set-reset": Shapes.set_reset,
    "edges": Shapes.edges,
    "timers": Shapes.timers,
    "counters": Shapes.counters,
}
"""What a drill is about, and how its ladder is drawn."""


def shape(kind: str, dialect: Dialect, dice: Dice, level: int) -> Ladder:
    """Draw a ladder of a kind and a level from 1 to 5."""
    work = Shapes(dialect, dice, level)
    rungs = KINDS[kind](work)
    return Ladder(tuple(rungs), configuration=tuple(work.blocks.configuration))
