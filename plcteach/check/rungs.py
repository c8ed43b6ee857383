"""Where the rungs of a list begin, and which of them can have anything to do with a wrong output."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.effect import names
from plcteach.machine.walk import walk

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from plcteach.core.program import Program
    from plcteach.machine.walk import Move

Rung = tuple[int, int]
"""The first instruction of a rung, counted from 0, and the one behind its last."""


def rungs(program: Program) -> tuple[Rung, ...]:
    """Give every rung: a network, and within one each load that finds no unused value."""
    starts: list[int] = []
    number = 0
    for network in program.networks:
        if network.lines:
            starts.append(number)
            moves = walk(program.dialect, network).moves
            starts += [number + at for at, move in enumerate(moves) if at and _begins(move, moves[at - 1])]
        number += len(network.lines)
    return tuple(zip(starts, [*starts[1:], number], strict=True)) if starts else ()


def _begins(move: Move, before: Move) -> bool:
    """Say whether a line loads a value where every other has been used, behind an output."""
    if not before.line.insn.then or move.line.insn.then or any(cell.live or cell.branch for cell in move.before[0]):
        return False
    if any(cell.line for cells in move.before[1:] for cell in cells):
        return False
    clause = move.line.effect.clauses[0]
    taken = {take.name for take in clause.takes}
    return bool(clause.gives) and not names(clause.gives[-1].formula) & taken


def network_lines(program: Program, row: int) -> range:
    """Give the instructions of the network in which a row of the text stands; all where none does."""
    first = 0
    for network in program.networks:
        last = first + len(network.lines)
        if network.lines and network.lines[0].span.row <= row <= network.lines[-1].span.row:
            return range(first, last)
        first = last
    return range(first)


def relevant_lines(parts: tuple[Rung, ...], program: Program, wrong: Iterable[str]) -> Callable[[int], bool]:
    """Give what says of an instruction whether its rung can touch one of some outputs; without outputs all can."""
    outputs = set(wrong)
    reads, writes = [], []
    for start, stop in parts:
        lines = program.lines[start:stop]
        written = {_whole(program, target.text) for line in lines for _, target in line.targets}
        named = {_whole(program, place.text) for line in lines for place in line.places}
        writes.append(written)
        reads.append(named)
    cone = {_whole(program, text) for text in outputs}
    size = -1
    while size != len(cone):
        size = len(cone)
        cone = cone.union(*(read for read, written in zip(reads, writes, strict=True) if written & cone))
    every = not outputs or not outputs <= set().union(*writes) or _wanders(program)
    kept = [one for one, written in zip(parts, writes, strict=True) if every or not written or written & cone]
    return lambda number: any(start <= number < stop for start, stop in kept)


def _whole(program: Program, text: str) -> str:
    """Give the block that a field belongs to, or the bit itself."""
    place = program.dialect.address(text)
    return program.dialect.whole(place).text if isinstance(place, Address) else text


def _wanders(program: Program) -> bool:
    """Say whether something decides which lines are executed, so that any line may matter."""
    return any(
        line.insn.does & {"jump", "call", "loop", "master", "segment", "step", "shift", "work"}
        for line in program.lines
    )
