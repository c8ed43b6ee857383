"""What is right and could yet be written better, and an output that no contact leads to."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

from plcteach.check.rules.registry import STACK_RULES, finds
from plcteach.core.diagnostic import Note
from plcteach.core.effect import Both, Effect, Name, names
from plcteach.core.text import NOTHING, Text

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from plcteach.core.diagnostic import Diagnostic, Rule
    from plcteach.core.effect import Formula
    from plcteach.core.insn import Insn
    from plcteach.core.program import Line
    from plcteach.core.spec import Dialect
    from plcteach.machine.walk import Move, Walk

_WRITES = {"coil", "set", "reset", "work", "shift", "drive", "pin"}
_HOW = {"&": Text("串联", "series"), "|": Text("并联", "parallel")}


def bare_output(move: Move) -> bool:
    """Say whether a line hands the top of the stack to an output although its network has put nothing there."""
    takes = [take for clause in move.line.effect.clauses for take in clause.takes if not take.optional]
    own = any(cell.line is not None for cell in move.before[0])
    return bool(move.line.insn.does & _WRITES) and len(takes) == 1 and not own


@finds("COI009", STACK_RULES)
def output_without_a_contact(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """An output stands at the beginning of a network, where no contact leads to it."""
    move = next((move for move in walk.moves if bare_output(move)), None)
    if move:
        on = walk.dialect.special("on")
        load = f"{walk.dialect.roles['load']} {on}"
        always = Text(f"要它一直接通，就写{load}。", f" Always on would be {load}.") if on else NOTHING
        yield row.at(move.line.span, word=move.line.text, unit=walk.dialect.unit, always=always)


@finds("STY001", STACK_RULES)
def block_not_needed(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """All contacts of a block are in series and so is the block, or both are in parallel."""
    for number, move in enumerate(walk.moves):
        sign = joined_by(move)
        first = _beginning(walk, number, sign) if sign else number
        load = walk.moves[first].line
        single = single_contact(walk, load.insn, sign) if sign else None
        if single and number - first > 1 and _two_blocks(move):
            said = f"{single} {load.text.partition(' ')[2]}"
            finding = {"load": load.text, "join": move.line.text, "single": said, "how": _HOW[sign]}
            yield row.at(load.span, **finding)


def joined_by(move: Move) -> str:
    """Give "&" or "|" where a line joins two blocks, whatever the family's way of writing it; "" where it joins none."""
    given = [give.formula for clause in move.line.effect.clauses for give in clause.gives]
    match given:
        case [Both(sign, Name(left), Name(right))] if sign in _HOW and {left, right} <= set(move.taken):
            return sign
    return ""


def _two_blocks(move: Move) -> bool:
    return all(cell.line and not cell.branch for cell in move.taken.values())


def _beginning(walk: Walk, join: int, sign: str) -> int:
    """Give the line at which the block above a join begins, if only contacts of one kind follow there; else the join's own."""
    for number in range(join - 1, -1, -1):
        line = walk.moves[number].line
        if single_contact(walk, line.insn, sign):
            return number
        if not _is_contact(line, sign):
            break
    return join


def _is_contact(line: Line, sign: str) -> bool:
    """Say whether a line is one contact in series (or in parallel)."""
    match _result(line.effect):
        case Both(op, Name(cell), _) if op == sign:
            return bool(line.insn.operands) and cell in {take.name for take in line.effect.clauses[0].takes}
    return False


def _result(effect: Effect) -> Formula | None:
    clauses = effect.clauses
    return clauses[0].gives[-1].formula if len(clauses) == 1 and clauses[0].gives else None


def single_contact(walk: Walk, load: Insn, sign: str) -> str | None:
    """Give the instruction that does a load (or an opening parenthesis) and its join in one, found by its effect."""
    return _in_one(walk.dialect, load.mnemonic, sign)


@lru_cache(maxsize=2048)
def _in_one(dialect: Dialect, mnemonic: str, sign: str) -> str | None:
    load = dialect.words[mnemonic]
    top = load.effect.clauses[0].gives[-1:]
    taken = {take.name for clause in load.effect.clauses for take in clause.takes}
    if not load.operands or load.then or not top or names(top[0].formula) & taken:
        return None
    if load.close is None and len(load.effect.clauses[0].gives) != len(load.effect.clauses[0].takes) + 1:
        return None
    kinds = tuple(operand.kind for operand in load.operands)
    for row in dialect.insns:
        if row.then or tuple(one.kind for one in row.operands) != kinds:
            continue
        match _result(row.effect):
            case Both(op, Name(_), other) if op == sign and other == top[0].formula:
                return row.mnemonic
    return None


@finds("STY002", STACK_RULES)
def push_not_needed(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """Between a push and its pop, and behind that, there are outputs only."""
    fetches = [number for number, move in enumerate(walk.moves) if move.role in {"read", "pop"}]
    for number, move in enumerate(walk.moves):
        pop = _after_outputs(walk.moves, number + 1) if move.role == "push" else number
        if pop > number + 1 and walk.moves[pop:] and walk.moves[pop].role == "pop" and pop == fetches[-1]:
            end = _after_outputs(walk.moves, pop + 1)
            if end > pop + 1 and not (walk.moves[end:] and _works_with(walk.moves[end])):
                line = walk.moves[pop].line
                there = Note(line.span, Text("到这里为止，栈顶没有变过", "up to here the top has not changed"))
                yield replace(row.at(move.line.span, push=move.line.text, pop=line.text), notes=(there,))


def _after_outputs(moves: Sequence[Move], start: int) -> int:
    """Give the first line from one on that is no output and no look at the branch point."""
    number = start
    while number < len(moves) and _leaves(moves[number]):
        number += 1
    return number


def _works_with(move: Move) -> set[str]:
    """Give the cells that a line works with, by name."""
    given = [names(give.formula) for clause in move.line.effect.clauses for give in clause.gives]
    top = set().union(*given[-1:])
    return top & set(move.taken)


def _leaves(move: Move) -> bool:
    """Say whether a line leaves the stack as it is: an output, or another look at the branch point."""
    return move.role == "read" or (bool(move.line.insn.then) and not move.line.insn.powers and _same(move))


def _same(move: Move) -> bool:
    return [give.formula for give in move.line.effect.clauses[0].gives] == [
        Name(take.name) for take in move.line.effect.clauses[0].takes
    ]
