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
from plcteach.core.text import Text, language
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import names
from plcteach.exercises import exercise as find_exercise
from plcteach.ladder.lower import lower
from plcteach.ladder.picture import write_drawing
from plcteach.stl import read

if TYPE_CHECKING:
    from pathlib import Path

    from plcteach.core.spec import Dialect

Ask = Literal["write", "predict", "join", "order", "match"]
ASKS: tuple[Ask, ...] = get_args(Ask)
_JOINED = ("blocks",)
_ID = re.compile(
    rf"drill-(?P<kind>{'|'.join(KINDS)})-(?P<level>[1-{MOST_LEVEL}])-(?P<seed>0|[1-9][0-9]{{0,17}})-(?P<dialect>[a-z0-9-]+?)"
    rf"(?:-(?P<ask>{'|'.join(ASKS[1:])}))?"
)
_LARGEST = 10**18


_NO_KIND = Text("没有{name}这种随机练习；有：{known}。", "There is no kind of drill called {name}. There is: {known}.")
_NO_ASK = Text("没有{name}这种问法；有：{known}。", "There is no question called {name}. There is: {known}.")
_LEVEL = Text("level是从1到{last}的整数，而不是{value}。", "level is a whole number from 1 to {last}, and not {value}.")
_SEED = Text("seed是不小于0的整数，而不是{value}。", "seed is a whole number from 0 on, and not {value}.")
_NO_JOIN = Text("只有{kinds}这种随机练习有块连接可问。", "Only drills about {kinds} have joins to ask for.")


class _UnknownDrillError(UnknownNameError):
    """A kind or question that no drill has; there are few, so all are named and none is guessed."""

    def __init__(self, words: str) -> None:
        Exception.__init__(self, words)
        self.near = []


def drill(
    kind: str = "blocks", seed: int = 0, level: int = 2, dialect: str | Dialect | None = None, ask: str = "write"
) -> Exercise:
    """Make a random exercise; the same arguments give the same one everywhere.

    kind: contacts, blocks, branches, set-reset, edges, timers or counters.  level: 1 (easy) to 5.  ask: what is asked of the
    ladder: write, predict (the stack), join (which blocks; of blocks only), order (the lines), match (the ladder).
    """
    for name, known, unknown in ((kind, KINDS, _NO_KIND), (ask, ASKS, _NO_ASK)):
        if name not in known:
            raise _UnknownDrillError(unknown.format(name=repr(str(name)[:40]), known=", ".join(known)).in_(language()))
    for what, value, first, last in ((_LEVEL, level, 1, MOST_LEVEL), (_SEED, seed, 0, _LARGEST - 1)):
        if not (isinstance(value, int) and first <= value <= last):
            raise PlcTeachError(what.format(value=str(value)[:20], last=last).in_(language()))
    if ask == "join" and kind not in _JOINED:
        raise PlcTeachError(_NO_JOIN.format(kinds=", ".join(_JOINED)).in_(language()))
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


def task_of(exercise: Exercise | str | Path) -> Exercise:
    """Give an exercise by its id, a drill's or a bundled one's, or a teacher's own by its file; UnknownNameError suggests the nearest."""
    return (from_id(exercise) if isinstance(exercise, str) else None) or find_exercise(exercise)


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
