"""Keeps a hidden exercise to itself when something goes wrong: no message and no frame of a traceback tells what it holds."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.errors import PlcTeachError
from plcteach.core.text import Text, language

if TYPE_CHECKING:
    from types import TracebackType

    from plcteach.core.exercise import Exercise

_HELD = Text(
    "这道题自己有错误，没能完成：{id}。请老师用plcteach exercise test检查它。",
    "Exercise {id} has an error itself. Can its teacher look at it with plcteach exercise test?",
)


class discreet:  # noqa: N801 (it reads as a word: with discreet(exercise))
    """Do something with an exercise; of a hidden one nothing is told but that it did not come to its end.

    A traceback may show the values of variables, so the exception is a new one, and no variable here keeps the old one.
    """

    def __init__(self, exercise: Exercise) -> None:
        self.exercise = exercise

    def __enter__(self) -> None:
        """Begin."""

    def __exit__(
        self, kind: type[BaseException] | None, trouble: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Put what went wrong with a hidden exercise into other words."""
        del trouble, trace
        if kind is None or not self.exercise.hidden:
            return
        if issubclass(kind, KeyboardInterrupt):
            raise KeyboardInterrupt from None
        if issubclass(kind, Exception):
            raise PlcTeachError(_HELD.format(id=self.exercise.id).in_(language())) from None
