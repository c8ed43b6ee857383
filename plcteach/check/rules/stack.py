"""What the stack alone tells about a network, whatever the inputs: too little, too much, left over, or one line too many."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from plcteach.check.rules.registry import STACK_RULES, finds
from plcteach.check.rules.style import bare_output, joined_by, single_contact
from plcteach.core.diagnostic import Note
from plcteach.core.effect import At, Name
from plcteach.core.text import NOTHING, Text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.diagnostic import Diagnostic, Rule
    from plcteach.machine.walk import Cell, Move, Walk

_FETCHES = {"read", "pop"}
_JOINS = {"join_series", "join_parallel"}


@finds("STK001", STACK_RULES)
def underflow(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """A join, or any instruction, needs more values than the network has put on the stack."""
    for move in walk.moves:
        if move.role in _FETCHES or bare_output(move):
            continue
        wanted = _wanted(move)
        own = sum(cell.line is not None for cell in move.before[0])
        first_is_foreign = bool(move.before[0]) and move.before[0][0].line is None
        if own < wanted and not (first_is_foreign and wanted == 1):
            yield row.at(
                move.line.span,
                word=move.line.text,
                wanted=wanted,
                found=own,
                unit=walk.dialect.unit,
                load=walk.dialect.roles["load"],
            )


def _wanted(move: Move) -> int:
    """Count the values of the main stack that a line must find there."""
    clause = move.line.effect.clauses[0]
    deepest = [
        give.formula.n + 1 for give in clause.gives if isinstance(give.formula, At) and isinstance(give.formula.n, int)
    ]
    return max([sum(not take.optional for take in clause.takes if _used(move, take.name)), *deepest])


def _used(move: Move, name: str) -> bool:
    """Say whether a taken value matters: NEZA's LD takes the accumulator only to replace it."""
    return (
        any(
            origin.sources and move.flow.named.get(name) in origin.sources
            for stack in move.flow.after
            for origin in stack
        )
        or name not in move.flow.named
    )


@finds("STK009", STACK_RULES)
def starts_from_leftover(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """A network begins with an instruction that combines with what the last network left."""
    move = walk.moves[0]
    for move in walk.moves:
        if move.before[0] and any(cell.line for cell in move.before[0]):
            return
        foreign = bool(move.before[0]) and _wanted(move) == 1 and move.before[0][0].line is None
        if foreign and move.role not in _FETCHES and not bare_output(move):
            yield row.at(move.line.span, word=move.line.text, unit=walk.dialect.unit, load=walk.dialect.roles["load"])
            return


@finds("STK003", STACK_RULES)
def pop_without_push(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """A read or a pop finds no branch point where it looks for one."""
    roles = walk.dialect.roles
    popped: Move | None = None
    for move in walk.moves:
        if move.role in _FETCHES:
            cell = _fetched(move)
            if cell is None or not cell.branch:
                block = cell is not None and cell.line is not None
                what = Text("，那里是一个电路块的值", ": the value there belongs to a block") if block else NOTHING
                found = row.at(move.line.span, word=move.line.text, push=roles["push"], what=what)
                yield replace(found, notes=_popped_before(walk, popped))
            elif move.role == "pop":
                popped = move


def _popped_before(walk: Walk, popped: Move | None) -> tuple[Note, ...]:
    """Point at the pop that has taken a branch point away too early."""
    if popped is None or "read" not in walk.dialect.roles:
        return ()
    pop, read = popped.line.text, walk.dialect.roles["read"]
    said = Text(
        f"这里的{pop}已经把分支点取走了；不是最后一条支路，就用{read}。",
        f"Here {pop} has taken the branch point away; a branch that is not the last one wants {read}.",
    )
    return (Note(popped.line.span, said),)


def _fetched(move: Move) -> Cell | None:
    """Give the cell that a read or a pop brings to the top."""
    source = move.flow.after[0][0].sources[:1] if move.flow.after[0] else ()
    return move.before[source[0][0]][source[0][1]] if source else None


@finds("STK004", STACK_RULES)
def join_meets_branch(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """A join finds a branch point where it wants a block (families whose cells are tagged)."""
    roles = walk.dialect.roles
    for move in walk.moves:
        for name, tag in move.flow.tags.items():
            if tag and move.role in _JOINS and move.taken[name].branch:
                yield row.at(move.line.span, word=move.line.text, push=roles["push"], pop=roles["pop"])


@finds("STK002", STACK_RULES)
def lost_at_bottom(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """A push on a full stack loses a value that nothing has used."""
    for move in walk.moves:
        for place in move.lost:
            stack = walk.dialect.stacks[place[0]]
            levels = stack.depth - 1 if stack.register else stack.depth
            yield row.at(move.line.span, word=move.line.text, levels=levels, row=_row(move.at(place)))


@finds("STK011", STACK_RULES)
def too_many_pending(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """More blocks or branch points wait than the maker allows."""
    for limit in walk.dialect.limits:
        for move in walk.moves:
            waiting = sum(cell.tag == limit.tag for cell in move.after[0])
            if waiting > limit.most:
                yield row.at(
                    move.line.span,
                    word=move.line.text,
                    count=waiting,
                    most=limit.most,
                    kind=limit.title,
                    family=walk.dialect.title,
                )
                break


@finds("STK012", STACK_RULES)
def not_inside_parentheses(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """An output or a branch stands inside parentheses."""
    closed = [number for number, stack in enumerate(walk.dialect.stacks) if stack.name == "paren"]
    for move in walk.moves:
        inside = any(move.before[number] for number in closed)
        if inside and (move.line.insn.then or move.role in _FETCHES | {"push"}):
            yield row.at(move.line.span, word=move.line.text)


@finds("STK013", STACK_RULES)
def after_compound_output(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """A network goes on behind an output that reads several flows and pops none (families that end a network there)."""
    if not walk.dialect.compound_ends:
        return
    for number, move in enumerate(walk.moves[:-1]):
        flows = [take for clause in move.line.effect.clauses for take in clause.takes]
        if len(flows) > 1 and move.line.insn.then:
            after = walk.moves[number + 1].line
            yield row.at(after.span, word=after.text, row=move.line.span.row, unit=walk.dialect.unit)
            return


@finds("STK014", STACK_RULES)
def used_input(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """A block of several inputs takes below the top a value that an output has already used."""
    for move in walk.moves:
        for verb in move.line.insn.then:
            for pin, formula in verb.pins if len(verb.pins) > 1 else ():
                name = formula.name if isinstance(formula, Name) else ""
                cell = move.taken.get(name)
                below = name in move.flow.named and move.flow.named[name][1] > 0
                if below and cell and cell.line and cell.spent:
                    yield row.at(move.line.span, word=move.line.text, pin=pin, row=_row(cell))


@finds("STK010", STACK_RULES)
def value_dropped(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """A value is thrown away before anything has used it; the cell that a pop overwrites on purpose is no loss."""
    for before, move in zip((None, *walk.moves), walk.moves, strict=False):
        for cell in map(move.at, move.dropped):
            made_for_it = (
                before is not None and before.role == "load" and cell.line is before.line and move.role == "pop"
            )
            if not made_for_it:
                yield row.at(move.line.span, word=move.line.text, row=_row(cell))


@finds("STK005", STACK_RULES)
def residue(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """Values are left on the stack that nothing has used."""
    left = walk.leftover
    if left and not _last_read(walk, left):
        rows = "、".join(str(_row(cell)) for cell in left), ", ".join(str(_row(cell)) for cell in left)
        finding = row.at(walk.last.span, unit=walk.dialect.unit, count=len(left), rows=Text(*rows))
        pop = walk.dialect.roles["pop"] if any(cell.branch for cell in left) else ""
        said = Text(f"这里存下的分支点，后面没有{pop}来取。", f"No {pop} fetches the branch point that is saved here.")
        notes = tuple(Note(cell.line.span, said) for cell in left if pop and cell.branch and cell.line)
        yield replace(finding, severity=walk.dialect.residue, notes=notes)


@finds("STK006", STACK_RULES)
def last_branch_reads(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """The last branch was read and not popped, so that the branch point stays."""
    read = _last_read(walk, walk.leftover)
    if read:
        roles = walk.dialect.roles
        finding = row.at(walk.last.span, unit=walk.dialect.unit, pop=roles["pop"], read=roles["read"])
        here = Text(f"这是最后一条支路，这里应是{roles['pop']}。", f"The last branch begins here: {roles['pop']}.")
        fix = Text(
            f"把第{read.line.span.row}行改成{roles['pop']}。", f"Make row {read.line.span.row} a {roles['pop']}."
        )
        yield replace(finding, severity=walk.dialect.residue, notes=(Note(read.line.span, here),), fix=fix)


def _last_read(walk: Walk, left: list[Cell]) -> Move | None:
    if not any(cell.branch for cell in left):
        return None
    return next((move for move in reversed(walk.moves) if move.role == "read"), None)


@finds("STK007", STACK_RULES)
def join_for_one_parallel(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """LD and OLD/ORB where O/OR does."""
    yield from _single(walk, row, "|")


@finds("STK008", STACK_RULES)
def join_for_one_series(walk: Walk, row: Rule) -> Iterator[Diagnostic]:
    """LD and ALD/ANB where A/AND does."""
    yield from _single(walk, row, "&")


def _single(walk: Walk, row: Rule, sign: str) -> Iterator[Diagnostic]:
    for load, move in zip(walk.moves, walk.moves[1:], strict=False):
        blocks = [cell for cell in move.taken.values() if cell.line and not cell.branch]
        joins = joined_by(move) == sign and len(blocks) > 1
        single = single_contact(walk, load.line.insn, sign) if joins else None
        if single:
            operand = load.line.text.partition(" ")[2]
            finding = row.at(load.line.span, single=f"{single} {operand}", load=load.line.text, join=move.line.text)
            together = f"{load.line.text} + {move.line.text} → {single} {operand}"
            joined = Text(f"与这一行合成一条：{together}", f"one with this row: {together}")
            yield replace(finding, notes=(Note(move.line.span, joined),))


def _row(cell: Cell) -> int:
    return cell.line.span.row if cell.line else 0
