"""The cell magic `%%stl NAME`: the cell below it is a program, kept as text, and what is to be said of it is shown.

It stands here and not among the widgets because it lies on the way to the marks, where nothing of a screen may be needed.
"""

from __future__ import annotations

from keyword import iskeyword
from typing import TYPE_CHECKING, Any

from plcteach.check.drill import task_of as find_exercise
from plcteach.check.lint import Findings, lint
from plcteach.core.errors import NotRepresentableError, PlcTeachError, UnknownNameError
from plcteach.core.text import Text, language
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import names
from plcteach.ladder.either import read_either

if TYPE_CHECKING:
    from plcteach.core.spec import Dialect

_USAGE = Text(
    "用法：%%stl 名字 [--dialect 系列] [--exercise 题号]，例如 %%stl program --dialect {family}",
    "Usage: %%stl NAME [--dialect FAMILY] [--exercise ID], for example %%stl program --dialect {family}",
)
_NO_PROGRAM = {"predict", "join", "match", "chart"}
"""The kinds of exercises whose answer is no program, so that nothing is to be said of it as one."""


class MagicError(PlcTeachError):
    """What stands behind %%stl is not to be understood; a notebook shows one line of it, and the cell counts as failed."""

    def _render_traceback_(self) -> list[str]:
        return [f"%%stl: {self}"]


def load(shell: Any) -> None:
    """Give a notebook's shell the magic."""

    def stl(line: str, cell: str) -> Findings | None:
        """Keep the cell's text, to the letter, in a variable, and show what is to be said of it."""
        name, family = _asked(line)
        shell.push({name: cell})
        found = _found(cell, family) if family else Findings()
        return found or None

    shell.register_magic_function(stl, magic_kind="cell", magic_name="stl")


def _found(cell: str, family: Dialect) -> Findings:
    """Say what there is to say of a list or a drawing; of a drawing that no list can express, judging says it."""
    try:
        return lint(read_either(cell, family))
    except NotRepresentableError:
        return Findings()


def _asked(line: str) -> tuple[str, Dialect | None]:
    """Read what stands behind %%stl: the variable's name, and the family (None where the answer is no program)."""
    words = line.replace("=", " ").split()
    name, options = (words[0] if words else ""), words[1:]
    pairs = dict(zip(options[::2], options[1::2], strict=False))
    if not name.isidentifier() or iskeyword(name) or len(options) % 2 or set(pairs) - {"--dialect", "--exercise"}:
        raise MagicError(_USAGE.format(family=names()[0]).in_(language()))
    try:
        if "--exercise" not in pairs:
            return name, find_dialect(pairs.get("--dialect", names()[0]))
        task = find_exercise(pairs["--exercise"])
        return name, None if task.kind in _NO_PROGRAM else find_dialect(task.dialect)
    except UnknownNameError as trouble:
        raise MagicError(str(trouble)) from None
