"""A program given as a list, as a ladder drawing or as a PLCopen file: whichever it is, one Program, or one Ladder."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plcteach.core.diagnostic import errors
from plcteach.core.ladder import Ladder
from plcteach.core.program import Program
from plcteach.dialects import dialect as find_dialect
from plcteach.ladder.telling import is_drawing, is_plcopen
from plcteach.stl.reader import read

if TYPE_CHECKING:
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.spec import Dialect
    from plcteach.stl.symbols import Symbols


class Given(NamedTuple):
    """A ladder, and what was found in the text that it was read from or lifted from; without rungs where it cannot be.

    configuration: the lines that set up its blocks, where the family wants them before the first rung.
    """

    ladder: Ladder
    found: tuple[Diagnostic, ...]
    configuration: tuple[str, ...] = ()


def read_either(text: str, dialect: str | Dialect, symbols: Symbols | None = None) -> Program:
    """Read a list, or lower a drawing; a drawing with an error gives a program without lines and with its findings."""
    if not is_drawing(text) and not is_plcopen(text):
        return read(text, dialect, symbols=symbols)
    from plcteach.ladder.lower import lower

    family = find_dialect(dialect)
    given = _drawn(text, family)
    if errors(given.found):
        return Program(family, (), source=text, diagnostics=given.found)
    return read("\n".join((*given.configuration, lower(given.ladder, family))), family)


def ladder_either(text: str, dialect: str | Dialect, symbols: Symbols | None = None) -> Given:
    """Read a drawing, or lift a list; with an error in the text there is no rung."""
    family = find_dialect(dialect)
    if is_drawing(text) or is_plcopen(text):
        return _drawn(text, family)
    program = read(text, family, symbols=symbols)
    if errors(program.diagnostics):
        return Given(Ladder(()), program.diagnostics)
    from plcteach.ladder.lift import lift

    lifted = lift(program)
    return Given(lifted.ladder, (*program.diagnostics, *lifted.diagnostics))


def _drawn(text: str, family: Dialect) -> Given:
    if is_plcopen(text):
        from plcteach.ladder.plcopen import read_plcopen
        from plcteach.ladder.plcopen_fit import fitted

        ladder, found = read_plcopen(text)
        if errors(found):
            return Given(Ladder(()), found)
        made = fitted(ladder, family)
        return Given(made.ladder, found, made.configuration)
    from plcteach.ladder.picture import read_drawing

    return Given(*read_drawing(text))
