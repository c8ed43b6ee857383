"""What can be said of a program's coils, whatever the stack does."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.rules.registry import PROGRAM_RULES, finds
from plcteach.core.area import Address

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic, Rule
    from plcteach.core.program import Line, Program


@finds("COI001", PROGRAM_RULES)
def double_coil(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A bit has two coils, not each in a step of its own.

    A bistable written out, which reads its first coil before the second, is no mistake.
    """
    coils: dict[str, list[tuple[int, str, Line]]] = {}
    step = ""
    for number, network in enumerate(program.networks):
        read_since: set[str] = set()
        for line in network.lines:
            step = _step(line, step)
            address = _coil(line)
            if not address:
                read_since |= {bit.text for bit in line.bits}
                continue
            known = coils.setdefault(address, [])
            other = next((one for one in known if not (step and one[1] and one[1] != step)), None)
            if other and not (address in read_since and other[0] == number):
                yield row.at(line.span, address=address, row=other[2].span.row)
            known.append((number, step, line))
            read_since.discard(address)


def _step(line: Line, step: str) -> str:
    """Give the step that a line belongs to, "" outside of all."""
    does = line.insn.does
    return line.text if "step" in does else "" if "rail" in does else step


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


def _coil(line: Line) -> str:
    """Give the bit that a line drives as a coil, which set and reset do not."""
    return (
        line.bits[0].text
        if line.bits and any(verb.name == "coil" and verb.target == "out" for verb in line.insn.then)
        else ""
    )
