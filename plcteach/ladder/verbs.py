"""The lecturer's words that write lists: lower a drawing, translate a program; what they give shows itself as it would be typed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.diagnostic import refuse
from plcteach.core.ladder import Ladder, Rung
from plcteach.core.text import language
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import names
from plcteach.ladder.either import Given, ladder_either, read_either
from plcteach.ladder.lower import lower as lowered
from plcteach.ladder.lower import lower_lines
from plcteach.ladder.translate import translate as translated

if TYPE_CHECKING:
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.ladder.translate import Translation


class Listing(str):
    """The text of a list, which a notebook shows with its lines below each other."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self).rstrip("\n")


def lower(
    ladder: str | Ladder | Rung,
    dialect: str | Dialect | None = None,
    *,
    grouped: bool = False,
    fused: bool = True,
    reasons: bool = False,
) -> Listing:
    """Write a ladder (or its drawing) out as the list of a family; NotRepresentableError says why it has none.

    grouped: joins stand together behind their blocks.  fused: False makes each contact a block of its own.  reasons: say
    behind each inserted instruction why it is there.
    """
    family = find_dialect(dialect or names()[0])
    given = ladder_either(ladder, family) if isinstance(ladder, str) else Given(_whole(ladder), ())
    refuse(given.found)
    drawn = given.ladder
    if not reasons:
        return Listing("\n".join((*given.configuration, lowered(drawn, family, grouped=grouped, fused=fused))))
    lines = lower_lines(drawn, family, grouped=grouped, fused=fused)
    wide = max((len(one.text) for one in lines), default=0)
    said = ((one.text, one.reason.in_(language())) for one in lines)
    return Listing("".join(f"{f'{text:{wide}}  // {why}' if why else text}\n" for text, why in said))


def translate(text: str | Program, to: str | Dialect, dialect: str | Dialect | None = None) -> Translation:
    """Carry a program (or the text of a list or drawing) to another family, with the table of its addresses."""
    if isinstance(text, str):
        text = read_either(text, dialect or names()[0])
        refuse(text.diagnostics)
    return translated(text, to)


def _whole(ladder: Ladder | Rung) -> Ladder:
    return ladder if isinstance(ladder, Ladder) else Ladder((ladder,))
