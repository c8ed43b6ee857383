"""What the lines say about function blocks as a whole: one that nothing ever fills, one that drives nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.rules.registry import PROGRAM_RULES, finds

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.area import Address
    from plcteach.core.block import BlockRule
    from plcteach.core.diagnostic import Diagnostic, Rule
    from plcteach.core.program import Line, Program


def _driven(program: Program, rule: BlockRule) -> Iterator[tuple[Address, Line, str]]:
    """Give each pin of a kind of block that a line puts a value on, with the block."""
    for line in program.lines:
        for verb, target in line.targets:
            block = program.dialect.block(target)
            if verb.name == "pin" and block and block.rule == rule:
                yield target, line, verb.op


@finds("BLK009", PROGRAM_RULES)
def shifts_only_zeros(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A shift register is shifted, and no line writes a bit of it."""
    written = {
        program.dialect.whole(place).text
        for line in program.lines
        for verb, place in line.targets
        if place.field and verb.name in {"coil", "set"}
    }
    said: set[str] = set()
    for block, line, pin in _driven(program, "bits"):
        if pin != "R" and block.text not in written | said:
            said.add(block.text)
            yield row.at(line.span, block=block.text)


@finds("CFG008", PROGRAM_RULES)
def drum_without_steps(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A drum is turned that no line has configured."""
    said: set[str] = set()
    for block, line, _ in _driven(program, "drum"):
        if block.text not in program.settings and block.text not in said:
            said.add(block.text)
            yield row.at(line.span, block=block.text)
