"""One ladder in several families at once: for each its list and its film, and the moments at which all step together.

A moment belongs to a sign of the ladder, or to what a family does before it (saving or fetching a branch point) or after it
(joining blocks). So OLD, ORB, a closing parenthesis and GUTTA's OLD come at the same moment, however long each list is.
"""

from __future__ import annotations

import json
from bisect import bisect_right
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from plcteach.core.text import Text
from plcteach.figure.film import film
from plcteach.figure.running import program_of
from plcteach.ladder.lift import lift
from plcteach.ladder.translate import translate
from plcteach.machine.scan import run

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.figure.film import Film

Key = tuple[int, int, int, int]
"""A moment: rung, sign, whether before it (-1), at it (0) or after it (1), and a count of those."""

_TITLE = Text("同一个梯形图，{n}个系列", "One ladder in {n} families")


@dataclass(frozen=True, slots=True)
class Together:
    """What the page plays: plain data for JSON."""

    data: dict[str, Any]

    def __repr__(self) -> str:
        names = ", ".join(family["title"]["en"] for family in self.data["families"])
        return f"Together({names}; {len(self.data['moments'])} moments)"

    @property
    def json(self) -> str:
        """The data as the browser gets it."""
        return json.dumps(self.data, ensure_ascii=False, separators=(",", ":"))


def together(
    text: str | Program,
    dialect: str | Dialect | None,
    others: Sequence[Dialect],
    inputs: Mapping[str, int] | None = None,
) -> Together:
    """Write a ladder or a list out in its own family and in others, run one scan of each, and lay their steps side by side.

    inputs: as the first family names them.  NotRepresentableError where a family has no list for it.
    """
    first = program_of(text, dialect)
    shown: list[tuple[Program, Mapping[str, int]]] = [(first, dict(inputs or {}))]
    for other in others:
        if other != first.dialect:
            made = translate(first, other)
            given = {made.addresses[name]: value for name, value in (inputs or {}).items() if name in made.addresses}
            shown.append((made.program, given))
    films = [film(run(program, [given]).scans) for program, given in shown]
    keys = [_keys(program) for program, _ in shown]
    moments = sorted({key for mine in keys for key in mine})
    rows = [[0] * len(shown), *([bisect_right(mine, moment) for mine in keys] for moment in moments)]
    return Together(
        {
            "title": _TITLE.format(n=len(shown)).as_dict(),
            "moments": rows,
            "families": [_family(program, one) for (program, _), one in zip(shown, films, strict=True)],
        }
    )


def _family(program: Program, one: Film) -> dict[str, Any]:
    title, kind = program.dialect.title.as_dict(), program.dialect.list.as_dict()
    return {"title": title, "kind": kind, "film": one.data}


def _keys(program: Program) -> list[Key]:
    """Give for each line the moment that it belongs to, in the order of the lines."""
    lifted = lift(program)
    own = {
        lines[0]: (number, symbol)
        for number, one in enumerate(lifted.rungs)
        for symbol, lines in enumerate(one.sources)
    }
    keys: list[Key] = []
    for number, growth in enumerate(lifted.growth):
        place = own.get(number)
        last = keys[-1] if keys else (0, -1, 1, 0)
        if place:
            keys.append((*place, 0, 0))
        elif growth.blocks or growth.added:
            keys.append((last[0], last[1], 1, last[3] + 1 if last[2] > 0 else 1))
        else:
            after = next((own[later] for later in range(number + 1, len(lifted.growth)) if later in own), None)
            keys.append(
                (*after, -1, last[3] + 1 if last[:3] == (*after, -1) else 0) if after else (last[0] + 1, 0, -1, 0)
            )
    return [max(keys[: number + 1]) for number in range(len(keys))]
