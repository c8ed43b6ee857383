"""The left rail within one scan: master controls, segments and steps, which give it power or take it away.

Where the rail has no power every load gives 0, so that coils drop and nothing is set. A step does more: its lines are
executed while it is on and once more after that, without power, and from then on they are passed over.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Generic, TypeVar

from plcteach.machine.signals import Signal

if TYPE_CHECKING:
    from plcteach.core.area import Address
    from plcteach.core.program import Line
    from plcteach.core.verb import Verb
    from plcteach.machine.step import Step
    from plcteach.machine.world import Plant

S = TypeVar("S", bound=Signal)


class Rails(Generic[S]):
    """The rail of one scan under way.

    base: its power outside of segments and steps.  outer: for each master control that is open, the power before it.
    powered_by: the relays of the segment or steps that it hangs on.  gate: where the lines of those steps are executed.
    leaving: steps that end with the scan, and where.  lit: coils that a step has driven in this scan.
    """

    def __init__(self, world: Plant[S]) -> None:
        self.world = world
        self.base: S | None = None
        self.outer: dict[int, S | None] = {}
        self.powered_by: list[Address] = []
        self.gate: S | None = None
        self.stepping = False
        self.leaving: list[tuple[Address, S]] = []
        self.lit: dict[str, S] = {}

    def before(self, line: Line, above: Line | None) -> None:
        """Before a line that switches the rail, the rail is what it was outside; a step after a step needs both."""
        if line.insn.powers and not (above and above.insn.powers and self.powered_by):
            self.clear()

    def clear(self) -> None:
        """Give the rail back the power that it has outside of segments and steps."""
        self.world.rail, self.gate, self.stepping, self.powered_by = self.base, None, False, []

    def master(self, number: int, power: S | None) -> None:
        """Switch the rail by a master control."""
        self.outer[number] = self.base
        self.world.rail = self.base = power

    def restore(self, number: int) -> None:
        """Give the rail back what it had before a master control, and end those inside it."""
        if number in self.outer:
            self.world.rail = self.base = self.outer[number]
            self.outer = {key: rail for key, rail in self.outer.items() if key < number}

    def segment(self, bit: Address, power: S | None) -> None:
        """Power the rail by the bit of a segment; the lines of a segment without power are executed, with every load 0."""
        self.world.rail = power
        self.powered_by = [bit]

    def unpower(self, power: S | None) -> None:
        """End a segment or a step; with a condition, only where it holds."""
        if power is None:
            self.clear()
            return
        rail = self.world.rail
        self.world.rail = ~power if rail is None else rail & ~power

    def transfer(self, here: S) -> None:
        """Leave the segment at once where there is power."""
        for source in self.powered_by:
            self.world.store(source, self.world.bit(source) & ~here)

    def step(self, bit: Address, power: S, number: int) -> None:
        """Power the rail by a step; one that has just ended is executed once more, without power, and then passed over.

        Which steps were on is remembered by line, because a relay may begin several stretches of a program.
        """
        self.world.rail = power
        key = f"{bit.text}.step{number}"
        gate = power | self.world.kept(key)
        self.gate, self.stepping = None if gate == self.world.domain.one else gate, True
        self.world.bits[key] = power
        self.powered_by.append(bit)

    def depart(self, target: Address, here: S) -> None:
        """Leave the steps that power the rail for another one, at the end of the scan."""
        if self.stepping and target not in self.powered_by:
            self.leaving += [(bit, here) for bit in self.powered_by if bit.area == target.area]

    def coil(self, one: Step[S]) -> Step[S]:
        """Give a line within a step what its coil does there.

        A coil of another step's relay sets it and leaves this step. And several steps may drive one coil: one that has just
        ended does not switch off what another has switched on in this scan [rec].
        """
        rail = self.world.rail
        if not self.stepping or rail is None or "coil" not in one.line.insn.does:
            return one
        written = []
        for address, value in one.written:
            if address.area == self.powered_by[0].area:
                self.depart(address, value)
                written.append((address, value | self.world.bit(address)))
                continue
            lit = self.lit.get(address.text, self.world.domain.zero)
            self.lit[address.text] = self.world.domain.pick(rail, value, lit)
            written.append((address, value | ~rail & lit))
        return replace(one, written=tuple(written))

    def end(self) -> None:
        """End the scan: steps that were left go off."""
        for bit, where in self.leaving:
            self.world.store(bit, self.world.bit(bit) & ~where)


def number_of(verb: Verb, one: Step[S]) -> int:
    """Give the number that a master control stands under."""
    number = one.line.bound[verb.target]
    return number if isinstance(number, int) else 0
