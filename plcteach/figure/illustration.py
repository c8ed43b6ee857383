"""What an instruction does, as names: the stacks before and after it, found by stepping the machine over formulas.

Nothing here is drawn, and no instruction is known by name: iv0, S0 and x come out of the declared effect alone.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.core.errors import UnknownNameError
from plcteach.core.program import Line
from plcteach.core.text import Text, same
from plcteach.dialects import dialect as find_dialect
from plcteach.figure.compared import comparison
from plcteach.machine.formula import Spelling, Term, name, written
from plcteach.machine.step import Step, step
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.area import Address
    from plcteach.core.effect import Effect
    from plcteach.core.insn import Insn, Operand
    from plcteach.core.program import Arg, Compare
    from plcteach.core.spec import Dialect

Columns = tuple[tuple[str, ...], ...]

UNKNOWN = name("x")
_SPARE = 3
_SPARE_BESIDE = 2
_MOST_NOTES = 2
_USUAL_N = 3


@dataclass(frozen=True, slots=True)
class Illustration:
    """An instruction's before and after: for each stack of the family its cells, top first, as a book names them.

    notes: the formulas of the new values and of what is written.  step: the machine's step that it was read from.
    """

    dialect: Dialect
    line: Line
    before: Columns
    after: Columns
    notes: tuple[Text, ...]
    step: Step[Term] = field(repr=False, compare=False)


def illustration(dialect: str | Dialect, mnemonic: str | Line, number: int | None = None) -> Illustration:
    """Step one instruction over names: a mnemonic ("OLD"), a whole line ("LDS 3") or a line of a program.

    number: the number operand where the words give none. UnknownNameError if the family has no such instruction.
    """
    family = find_dialect(dialect)
    line = mnemonic if isinstance(mnemonic, Line) else example(family, mnemonic, number)
    before = _named(family, line)
    one = step(line, family.shapes, before, _World(family), UNKNOWN)
    after = tuple(
        tuple(origin.label or written(cell) for origin, cell in zip(origins, cells, strict=True))
        for origins, cells in zip(one.flow.after, one.after, strict=True)
    )
    return Illustration(
        family, line, tuple(tuple(map(written, cells)) for cells in before), after, tuple(_notes(family, one)), one
    )


def example(dialect: Dialect, words: str, number: int | None = None) -> Line:
    """Make a line of an instruction with operands such as a textbook would choose, where the words give none."""
    if words.upper() in dialect.words:
        mnemonic, operands = words, []
    else:
        mnemonic, *operands = words.split() or [""]
    if operands:
        program = read(words, dialect)
        if program.runs and len(program.lines) == 1:
            return program.lines[0]
    row = dialect.insn(mnemonic)
    if operands:
        kind = f"operand of {row.mnemonic}"
        raise UnknownNameError(kind, " ".join(operands), ())
    if beyond_bits(dialect, row) and number is None:
        return _shown(dialect, row)
    args = tuple(_usual(dialect, row, operand, number) for operand in row.operands)
    numbers = {operand.name: arg for operand, arg in zip(row.operands, args, strict=True) if isinstance(arg, int)}
    return Line(row, args, row.effect.bind(numbers))


_BITS = {"coil", "set", "reset"}


def beyond_bits(dialect: Dialect, row: Insn) -> bool:
    """Say whether an instruction works on more than bits and counts, so that only a line of its own shows what it does."""
    kinds = [dialect.kinds[one.kind] for one in row.operands if one.kind]
    words = any(one.size != 1 for one in kinds) or any(one.mark or one.first < 0 for one in row.operands)
    return words or any(verb.name not in _BITS or verb.sources for verb in row.then)


def _shown(dialect: Dialect, row: Insn) -> Line:
    """Give the line of the dialect's own example in which an instruction stands."""
    program = read(dialect.example(row.mnemonic).replace("; ", "\n"), dialect)
    return next(line for line in program.lines if line.insn is row)


def _usual(dialect: Dialect, row: Insn, operand: Operand, number: int | None) -> Arg:
    if operand.number:
        usual = _USUAL_N if "[" in row.effect.text else operand.first
        if number is not None and not operand.first <= number <= operand.last:
            kind = f"operand of {row.mnemonic}"
            raise UnknownNameError(kind, str(number), (f"{operand.first} to {operand.last}",))
        return min(max(usual if number is None else number, operand.first), operand.last)
    writes = operand.name in {verb.target for verb in row.then}
    reads = operand.name in row.effect.operands
    roles = ("memory",) if writes and reads else ("output", "memory") if writes else ("input", "memory")
    fitting = [area for area in dialect.areas if area.prefix in dialect.kinds[operand.kind].areas]
    areas = [area for role in roles for area in fitting if area.role == role] or fitting
    return areas[0].address(0)


class _World(Spelling):
    """A PLC in which every bit is its own name, also those that one instruction sets in a row."""

    def __init__(self, dialect: Dialect) -> None:
        self.dialect = dialect

    def compare(self, compare: Compare) -> Term:
        """Name a comparison as it is read aloud."""
        return name(comparison(compare))

    def following(self, address: Address, count: int) -> tuple[Address, ...]:
        """Give `count` addresses from this one on."""
        return tuple(self.dialect.following(address, count))


def _named(dialect: Dialect, line: Line) -> tuple[tuple[Term, ...], ...]:
    """Name the cells before the instruction: S0, S1 where the book names what is taken, iv0, iv1, … for all others."""
    columns, count = [], 0
    for stack in dialect.stacks:
        takes = takes_of(line.effect, stack.name)
        labels = takes if line.effect.labelled else ()
        spare = 0 if line.effect == line.insn.fresh else _SPARE_BESIDE if stack.name else _SPARE
        height = stack.depth if stack.fixed else min(stack.depth, len(takes) + spare)
        plain = [name(f"iv{count + place}") for place in range(height - len(labels))]
        count += len(plain)
        columns.append((*(name(label) for label in labels), *plain))
    return tuple(columns)


def takes_of(effect: Effect, stack: str) -> tuple[str, ...]:
    """Give the names of the cells that an effect takes from one stack, top first."""
    return tuple(take.name for clause in effect.clauses if clause.stack == stack for take in reversed(clause.takes))


def _notes(dialect: Dialect, one: Step[Term]) -> Iterator[Text]:
    for stack, origins, cells in zip(dialect.stacks, one.flow.after, one.after, strict=True):
        for place, (origin, cell) in enumerate(zip(origins, cells, strict=True)):
            if origin.label:
                yield same(f"{origin.label}={written(cell)}")
            elif origin.how == "made" and cell.parts:
                yield Text("{level} = {formula}", "{level} = {formula}").format(
                    level=stack.level(place), formula=written(cell)
                )
    for address, value in one.written[:_MOST_NOTES]:
        yield same(f"{address.text} = {written(value)}")
    if len(one.written) > _MOST_NOTES:
        yield same(f"… {one.written[-1][0].text} = {written(one.written[-1][1])}")
