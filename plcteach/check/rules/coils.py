"""What can be said of a program's coils, and of the timers and counters driven like coils, whatever the stack does."""

from __future__ import annotations

from dataclasses import dataclass
from heapq import heappop, heappush
from typing import TYPE_CHECKING

from plcteach.check.rules.course import named
from plcteach.check.rules.registry import PROGRAM_RULES, finds
from plcteach.check.rules.values import Values, follow, was_written
from plcteach.core.area import Address

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic, Rule
    from plcteach.core.effect import Formula
    from plcteach.core.program import Line, Program
    from plcteach.machine.formula import Term

_OFTEN = {"R", "S"}
"""Pins of a counter that several lines may serve: each acts at once, and none undoes what another has done."""


@dataclass(frozen=True, slots=True)
class _Spot:
    """A line and where it stands: its number, its network, its routine, its step.

    left: the last line above from which a jump passes it over.  landed: the first line below where such a jump lands.
    """

    number: int
    line: Line
    network: int
    block: str
    step: str
    left: int
    landed: int

    def excludes(self, above: _Spot) -> bool:
        """Say whether it and one above it are alternatives: of two steps, two subroutines, or passed over by different jumps."""
        steps = self.step and above.step and self.step != above.step
        routines = self.block and above.block and self.block != above.block
        return bool(steps or routines or (above.landed <= self.number and self.left > above.number))


def _spots(program: Program) -> list[_Spot]:
    """Give every line with the place where it stands."""
    jumps, count = _jumps(program), len(program.lines)
    landed = _ends(jumps, count)
    left = [count - 1 - end for end in reversed(_ends([(count - 1 - b, count - 1 - a) for a, b in jumps], count))]
    spots: list[_Spot] = []
    step = ""
    for network, one in enumerate(program.networks):
        for line in one.lines:
            number, step = len(spots), _step(line, step)
            spots.append(_Spot(number, line, network, one.block, step, left[number], landed[number]))
    return spots


def _jumps(program: Program) -> list[tuple[int, int]]:
    """Give each jump down with the line where it lands, both by number."""
    placed = [(network.block, line) for network in program.networks for line in network.lines]
    labels: dict[tuple[str, str], int] = {}
    found = []
    for number, (block, line) in reversed(list(enumerate(placed))):
        if "label" in line.insn.does:
            labels[block, named(line, "label")] = number
        aim = labels.get((block, named(line, "jump"))) if "jump" in line.insn.does else None
        if aim is not None:
            found.append((number, aim))
    return found


def _ends(stretches: list[tuple[int, int]], count: int) -> list[int]:
    """Give for each number the nearest end of the stretches that it lies within, past all where it lies in none."""
    waiting, within = sorted(stretches, reverse=True), list[int]()
    found = []
    for number in range(count):
        while waiting and waiting[-1][0] < number:
            heappush(within, waiting.pop()[1])
        while within and within[0] <= number:
            heappop(within)
        found.append(within[0] if within else count)
    return found


def _step(line: Line, step: str) -> str:
    """Give the step that a line belongs to, "" outside of all."""
    does = line.insn.does
    return line.text if "step" in does else "" if "rail" in does else step


@finds("COI001", PROGRAM_RULES)
def double_coil(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A bit has two coils that are no alternatives.

    A bistable written out, whose second coil works with what the first has just written, is no mistake.
    """
    coils: dict[str, list[_Spot]] = {}
    clean: dict[str, set[Term]] = {}
    values: Values | None = None
    for spot in _spots(program):
        for formula, address in _coils(spot.line):
            known = coils.setdefault(address, [])
            other = next((one for one in known if not spot.excludes(one)), None)
            known.append(spot)
            if other and other.network == spot.network:
                values = values or follow(program)
                value = values.given(spot.number, formula)
                other = None if was_written(value, address, clean.setdefault(address, set())) else other
            if other:
                yield row.at(spot.line.span, address=address, row=other.line.span.row)


def _coils(line: Line) -> Iterator[tuple[Formula | None, str]]:
    """Give each bit that a line drives as a coil, which set, reset and the memory of an edge do not, with its formula."""
    return ((verb.formula, bit.text) for verb, bit in line.targets if verb.name == "coil" and verb.target != "m")


@finds("COI010", PROGRAM_RULES)
def driven_twice(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A timer or counter is driven by two lines that are no alternatives, and not as two sorts of timer."""
    known: dict[tuple[str, str], list[tuple[_Spot, str]]] = {}
    for spot in _spots(program):
        for address, way, op, timer in _drives(program, spot.line):
            others = known.setdefault((address, way), [])
            clashes = (one for one, before in others if not spot.excludes(one) and not (timer and before != op))
            other = next(clashes, None)
            others.append((spot, op))
            if other:
                yield row.at(spot.line.span, address=address, row=other.line.span.row)


def _drives(program: Program, line: Line) -> Iterator[tuple[str, str, str, bool]]:
    """Give each timer or counter that a line drives, the pin where it is only one, how, and whether it is a timer."""
    for verb, target in line.targets:
        block = program.dialect.block(target)
        if block and block.rule in {"timer", "counter"}:
            if verb.name == "drive":
                yield target.text, "", verb.op, block.rule == "timer"
            elif verb.name == "pin" and verb.op not in _OFTEN:
                yield target.text, verb.op, "", block.rule == "timer"


@finds("COI002", PROGRAM_RULES)
def edge_memory_shared(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """The bit in which an edge instruction keeps the last flow is written by another line as well."""
    writers: dict[str, list[Line]] = {}
    for line in program.lines:
        for _, target in line.targets:
            writers.setdefault(target.text, []).append(line)
    for line in program.lines:
        memory = next((line.bound["m"] for verb in line.insn.then if verb.target == "m"), None)
        others = [one for one in writers[memory.text] if one is not line] if isinstance(memory, Address) else []
        if others and isinstance(memory, Address):
            yield row.at(line.span, word=line.insn.mnemonic, address=memory.text, row=others[0].span.row)
