"""A program given as a list or as a ladder drawing: whichever it is, one Program and everything that was found."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.diagnostic import errors
from plcteach.core.program import Program
from plcteach.dialects import dialect as find_dialect
from plcteach.ladder.telling import is_drawing
from plcteach.stl.reader import read

if TYPE_CHECKING:
    from plcteach.core.spec import Dialect
    from plcteach.stl.symbols import Symbols


def read_either(text: str, dialect: str | Dialect, symbols: Symbols | None = None) -> Program:
    """Read a list, or lower a drawing; a drawing with an error gives a program without lines and with its findings."""
    if not is_drawing(text):
        return read(text, dialect, symbols=symbols)
    from plcteach.ladder.lower import lower
    from plcteach.ladder.picture import read_drawing

    family = find_dialect(dialect)
    ladder, found = read_drawing(text)
    return Program(family, (), source=text, diagnostics=found) if errors(found) else read(lower(ladder, family), family)
