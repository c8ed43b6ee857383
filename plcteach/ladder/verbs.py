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
from plcteach.ladder.translation import Translation

if TYPE_CHECKING:
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect


class Listing(str):  # noqa: SLOT000 (it bears its family)
    """The text of a list, which a notebook shows with its lines below each other; it knows its family."""

    dialect: Dialect

    @classmethod
    def of(cls, text: str, family: Dialect) -> Listing:
        """Give the text of a list of a family."""
        made = cls(text)
        made.dialect = family
        return made

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
        return Listing.of(
            "\n".join((*given.configuration, lowered(drawn, family, grouped=grouped, fused=fused))), family
        )
    lines = lower_lines(drawn, family, grouped=grouped, fused=fused)
    wide = max((len(one.text) for one in lines), default=0)
    said = ((one.text, one.reason.in_(language())) for one in lines)
    rows = (
        *given.configuration,
        *drawn.configuration,
        *(f"{text:{wide}}  // {why}" if why else text for text, why in said),
    )
    return Listing.of("".join(f"{row}\n" for row in rows), family)


def translate(
    text: str | Program | Translation, to: str | Dialect, dialect: str | Dialect | None = None
) -> Translation:
    """Carry a program (or the text of a list or drawing) to another family, with the table of its addresses."""
    if isinstance(text, Translation):
        return translated(text.program, to)
    if isinstance(text, str):
        text = read_either(text, dialect or getattr(text, "dialect", None) or names()[0])
        refuse(text.diagnostics)
    return translated(text, to)


def _whole(ladder: Ladder | Rung) -> Ladder:
    return ladder if isinstance(ladder, Ladder) else Ladder((ladder,))
