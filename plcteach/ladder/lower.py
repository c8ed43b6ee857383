"""Writes a ladder out as an instruction list of any family, driven by the roles in its table and by the effects of its rows.

The rules are the ones by which the makers' software does it: a single contact in series or in parallel is one instruction, a
block begins with a load and is joined right after it; at a branch point the flow is saved before the first output path that
changes it, read again before the middle ones and fetched before the last. A family that opens and closes parentheses writes
its blocks so. Which instruction reads a bit inverted, or its edge, is found by comparing effects, never by name. A box is what
its family's reader makes of its text, and nothing else of a drawing reaches the list unread.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.ladder import Ladder, Rung
from plcteach.core.source import printable
from plcteach.dialects import dialect as find_dialect
from plcteach.ladder.lowering import Lowering
from plcteach.ladder.meaning import meaning
from plcteach.ladder.sheet import LoweredLine

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from plcteach.core.spec import Dialect

__all__ = ["LoweredLine", "lower", "lower_lines", "meaning"]


def lower(ladder: Ladder | Rung, dialect: str | Dialect, *, grouped: bool = False, fused: bool = True) -> str:
    """Write a ladder as the canonical instruction list of a family; NotRepresentableError says why it cannot.

    grouped: joins stand together behind the blocks instead of one after each.  fused: False writes a single contact as a
    block too (load and join), as a lesson about composition wants it.
    """
    family = find_dialect(dialect)
    rows = [
        *(ladder.configuration if isinstance(ladder, Ladder) else ()),
        *listing(_rungs(ladder), family, lower_lines(ladder, family, grouped=grouped, fused=fused)),
    ]
    return "".join(f"{row}\n" for row in rows)


def listing(
    rungs: Sequence[Rung],
    family: Dialect,
    lines: Sequence[LoweredLine],
    above: Mapping[int, Sequence[str]] | None = None,
) -> Iterator[str]:
    """Put lowered lines under the headings of their rungs; above: comments that stand before the lines of a rung."""
    texts: dict[int, list[str]] = {}
    for line in lines:
        texts.setdefault(line.rung, []).append(line.text)
    for number, rung in enumerate(rungs):
        title = " ".join(printable(rung.title).split())
        titled = f"// {title}" if title else ""
        if family.networks_by_title:
            yield f"{family.head(number)} {titled}".rstrip()
        elif titled:
            yield titled
        yield from (f"// {row}" for row in (above or {}).get(number, ()))
        yield from texts.get(number, ())


def lower_lines(
    ladder: Ladder | Rung, dialect: str | Dialect, *, grouped: bool = False, fused: bool = True
) -> tuple[LoweredLine, ...]:
    """Give the instructions of a lowered ladder, each with the reason for it where no symbol of the drawing shows it."""
    work = Lowering(find_dialect(dialect), grouped=grouped, fused=fused)
    for number, rung in enumerate(_rungs(ladder)):
        work.rung(rung, number)
    return tuple(work.lines)


def _rungs(ladder: Ladder | Rung) -> tuple[Rung, ...]:
    return ladder.rungs if isinstance(ladder, Ladder) else (ladder,)
