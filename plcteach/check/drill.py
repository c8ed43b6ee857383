"""Endless random exercises of a chosen kind and difficulty, each the same on every machine, each its own test.

    drill("blocks", seed=7, level=3)                write the list of a random ladder
    drill("blocks", seed=7, ask="join")             the same sort of ladder, another question

The id of a drill says how it was made, so that it can be made again from its id alone.
"""

from __future__ import annotations

import re
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING, Literal, get_args

from plcteach.check.drilling.asked import ASKED
from plcteach.check.drilling.dice import Dice
from plcteach.check.drilling.samples import right_lists, wrong_lists
from plcteach.check.drilling.shapes import KINDS, MOST_LEVEL, shape
from plcteach.check.drilling.told import NUMBERED, TITLES, hints, task
from plcteach.core.errors import PlcTeachError, UnknownNameError
from plcteach.core.exercise import Exercise, Terms
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import names
from plcteach.exercises import exercise as find_exercise
from plcteach.ladder.lower import lower
from plcteach.ladder.picture import write_drawing
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.spec import Dialect

Ask = Literal["write", "predict", "join", "order", "match"]
ASKS: tuple[Ask, ...] = get_args(Ask)
_JOINED = ("blocks",)
_ID = re.compile(
    rf"drill-(?P<kind>{'|'.join(KINDS)})-(?P<level>[1-{MOST_LEVEL}])-(?P<seed>0|[1-9][0-9]{{0,17}})-(?P<dialect>[a-z0-9-]+?)"
    rf"(?:-(?P<ask>{'|'.join(ASKS[1:])}))?"
)
_LARGEST = 10**18


def drill(
    kind: str = "blocks", seed: int = 0, level: int = 2, dialect: str | Dialect | None = None, ask: str = "write"
) -> Exercise:
    """Make a random exercise; the same arguments give the same one everywhere.

    kind: contacts, blocks, branches, set-reset, edges, timers or counters.  level: 1 (easy) to 5.  ask: what is asked of the
    ladder: write, predict (the stack), join (which blocks; of blocks only), order (the lines), match (the ladder).
    """
    for what, name, known in (("kind of drill", kind, KINDS), ("question", ask, ASKS)):
        if name not in known:
            raise UnknownNameError(what, str(name), known)
    if not (isinstance(level, int) and isinstance(seed, int) and 1 <= level <= MOST_LEVEL and 0 <= seed < _LARGEST):
        msg = f"a drill has a level from 1 to {MOST_LEVEL} and a seed from 0 on, and not {level!r} and {str(seed)[:20]}"
        raise PlcTeachError(msg)
    if ask == "join" and kind not in _JOINED:
        msg = f"only drills about {' and '.join(_JOINED)} have joins to ask for"
        raise PlcTeachError(msg)
    return _made(kind, int(seed), int(level), find_dialect(dialect or names()[0]), ask)


def from_id(name: str) -> Exercise | None:
    """Make a drill again from its id; None where the id is none of a drill."""
    found = _ID.fullmatch(name) if isinstance(name, str) and len(name) < 80 else None  # noqa: PLR2004 (longer than any id)
    if found is None or found["dialect"] not in names():
        return None
    ask = found["ask"] or "write"
    if ask == "join" and found["kind"] not in _JOINED:
        return None
    return drill(found["kind"], int(found["seed"]), int(found["level"]), found["dialect"], ask)


def task_of(exercise: Exercise | str) -> Exercise:
    """Give an exercise by its id, a drill's or a bundled one's; UnknownNameError suggests the nearest."""
    made = from_id(exercise) if isinstance(exercise, str) else exercise
    return made or find_exercise(exercise)


@lru_cache(maxsize=256)
def _made(kind: str, seed: int, level: int, dialect: Dialect, ask: str) -> Exercise:
    word = f"drill-{kind}-{level}-{seed}-{dialect.name}"
    ladder = shape(kind, dialect, Dice(word), level)
    program = read(lower(ladder, dialect), dialect)
    level_of = "exact" if kind == "edges" else "either"
    title = NUMBERED.format(title=TITLES[kind], level=level, seed=seed)
    plain = Exercise(
        word, dialect.name, title, task("write", dialect), write_drawing(ladder),
        hints=hints(program, kind), right=right_lists(ladder, dialect), wrong=wrong_lists(program),
        terms=Terms(level=level_of),
    )  # fmt: skip
    if ask == "write":
        return plain
    return ASKED[ask](replace(plain, id=f"{word}-{ask}"), program, Dice(f"{word}-{ask}"))
