"""What the lines say about where a program goes: labels and subroutines that are missing, doubled, or in the wrong place."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.rules.registry import PROGRAM_RULES, STACK_RULES, finds

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic, Rule
    from plcteach.core.program import Line, Program
    from plcteach.core.verb import VerbName
    from plcteach.machine.walk import Walk

_PLACES: tuple[tuple[VerbName, VerbName], ...] = (("jump", "label"), ("call", "entry"))


def named(line: Line, name: VerbName) -> str:
    """Give the label or subroutine that a line names with a verb, spelled as the list does; "" where it names none."""
    for verb in line.insn.then:
        if verb.name == name and isinstance(line.bound.get(verb.target), int):
            return line.spell(verb.target)
    return ""


def _lines(program: Program) -> Iterator[tuple[str, Line]]:
    """Give every line with the routine in which it stands."""
    for network in program.networks:
        for line in network.lines:
            yield network.block, line


@finds("JMP001", PROGRAM_RULES)
def no_such_place(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A jump goes to a label that does not stand in its routine, or a call to a subroutine that stands nowhere."""
    labels = {(block, named(line, "label")) for block, line in _lines(program)}
    routines = {network.block for network in program.networks}
    for block, line in _lines(program):
        jumps, calls = named(line, "jump"), named(line, "call")
        if jumps and (block, jumps) not in labels:
            yield row.at(line.span, word=line.text, name=_label(program, jumps))
        if calls and calls not in routines:
            yield row.at(line.span, word=line.text, name=calls)


def _label(program: Program, name: str) -> str:
    """Spell a label as its own line would."""
    rows = [row for row in program.dialect.insns if "label" in row.does]
    return name if not name.isdigit() or not rows else f"{rows[0].word} {name}"


@finds("JMP002", PROGRAM_RULES)
def place_twice(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A label stands twice in one routine, or a subroutine begins twice."""
    first: dict[tuple[str, str], Line] = {}
    for block, line in _lines(program):
        for _, verb in _PLACES:
            name = named(line, verb)
            before = first.setdefault((block if verb == "label" else "", name), line) if name else line
            if before is not line:
                yield row.at(line.span, name=name, row=before.span.row)


@finds("JMP003", PROGRAM_RULES)
def subroutine_before_end(program: Program, row: Rule) -> Iterator[Diagnostic]:
    """A subroutine that begins with a line of its own stands where the main program would run into it."""
    ended = False
    for _, line in _lines(program):
        ended |= any(verb.name == "end" and verb.formula is None for verb in line.insn.then)
        name = named(line, "entry")
        if name and not ended:
            yield row.at(line.span, name=name, end=program.dialect.roles.get("end", ""))


@finds("JMP004", STACK_RULES)
def jump_inside_branch(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """A jump or a label stands while a branch point waits, in families whose branch points have a stack of their own."""
    kept = [number for number, stack in enumerate(walk.dialect.stacks) if stack.name == "branch"]
    roles = walk.dialect.roles
    for move in walk.moves:
        goes = move.line.insn.does & {"jump", "label", "call", "entry"}
        if goes and any(move.before[number] for number in kept):
            yield row.at(move.line.span, word=move.line.text, push=roles["push"], pop=roles["pop"])
