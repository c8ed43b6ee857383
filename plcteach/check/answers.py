"""Answers that are no program: read with patience, marked by the share of them that is right."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from plcteach.check.judgement import Judgement
from plcteach.check.marks import parted
from plcteach.core.diagnostic import errors, refuse, rule
from plcteach.core.source import Span, decode, half_width, printable, rows_of
from plcteach.core.text import Text
from plcteach.core.verdict import Status, Verdict
from plcteach.ladder.either import read_either
from plcteach.ladder.picture import read_drawing
from plcteach.ladder.telling import is_drawing

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.exercise import Exercise
    from plcteach.core.ladder import Ladder
    from plcteach.core.program import Program

MOST_CHARACTERS = 50_000
MOST_REMARKS = 20
_SHOWN = 20
_SHARES = ("outputs", "steps", "style", "needs")
_COUNTED = Text("全对的行：{right}/{all}。", "Rows that are right throughout: {right} of {all}.")


def looked_at(exercise: Exercise) -> Program:
    """Read the program that a task is about; PlcTeachError where it has an error, which is the teacher's."""
    program = read_either(exercise.given or exercise.reference, exercise.dialect)
    refuse(program.diagnostics)
    return program


def seen(exercise: Exercise) -> tuple[Ladder, ...]:
    """Give the ladder that a task is about, where it is given as a drawing."""
    return drawing(exercise.given or exercise.reference)


def drawing(text: str) -> tuple[Ladder, ...]:
    """Read a ladder as it is drawn; nothing where a text is no drawing."""
    return (read_drawing(text)[0],) if is_drawing(text) else ()


_HALVES = re.compile("[\ud800-\udfff]")


def text_of(answer: str | bytes) -> str:
    """Give an answer as text that can be written to a file: half a character from a broken paste is replaced."""
    return _HALVES.sub("\ufffd", answer if isinstance(answer, str) else decode(answer))


def refused(text: str) -> tuple[Diagnostic, ...]:
    """Find what keeps an answer from being read at all: it is far too long, or there is none."""
    if len(text) > MOST_CHARACTERS:
        return (rule("KND010").at(Span(1), size=len(text), most=MOST_CHARACTERS),)
    return () if next(rows(text), None) else (rule("KND011").at(Span(1)),)


_COMMENT = re.compile(r"//.*|#+\s*(?:BEGIN|END)\b.*")


def rows(text: str) -> Iterator[tuple[int, str]]:
    """Give the rows in which something stands, each with its number: plain signs, no comments."""
    for number, row in enumerate(rows_of(text), 1):
        plain = " ".join(printable(half_width(_COMMENT.sub("", row))).split())
        if plain:
            yield number, plain


def quoted(word: str) -> str:
    """Give a word of an answer as a message names it: short, and nothing that a terminal obeys."""
    plain = printable(word)
    return plain if len(plain) <= _SHOWN else f"{plain[:_SHOWN]}…"


def graded(
    exercise: Exercise,
    answer: str,
    share: float,
    *,
    found: tuple[Diagnostic, ...] = (),
    says: tuple[Text, ...] = (),
    wrong: tuple[tuple[int, int], ...] = (),
    grid: Iterable[Iterable[str]] = (),
) -> Judgement:
    """Make the judgement of an answer of which a share (0 to 1) is right; one that could not be read is an error.

    Of a hidden exercise no cell is named: where one is 0 or 1, to know that it is wrong is to know what is right.
    """
    signs = tuple(map(tuple, grid))
    if exercise.hidden and wrong:
        says = (_COUNTED.format(all=len(signs), right=len(signs) - len({row for row, _ in wrong})),)
        wrong = ()
    status: Status = "error" if errors(found) else "equal" if share >= 1 else "different"
    verdict = Verdict(status, diagnostics=found[:MOST_REMARKS])
    parts, marks = parted(exercise, dict.fromkeys(_SHARES, share if status != "error" else 0.0))
    return Judgement(exercise, answer, None, verdict, marks, parts, says, wrong, signs)
