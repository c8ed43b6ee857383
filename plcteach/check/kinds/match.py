"""Which ladder is this list: the right one is found by proof, and a wrong one comes with what tells it apart."""

from __future__ import annotations

import re
from dataclasses import replace
from string import ascii_uppercase
from typing import TYPE_CHECKING

from plcteach.check.against import reference, verdict_on
from plcteach.check.answers import graded, looked_at, refused, rows, text_of
from plcteach.check.judgement import Judgement, Sheet
from plcteach.core.diagnostic import rule
from plcteach.core.errors import DeclarationError
from plcteach.core.source import Span
from plcteach.core.text import Text
from plcteach.ladder.either import ladder_either

if TYPE_CHECKING:
    from plcteach.core.exercise import Exercise
    from plcteach.core.verdict import Verdict

_ONLY_ONE = Text(
    "只有一个梯形图和程序作用相同。选哪一个？", "Only one of the ladders does what the list does. Which one is it?"
)
_CHOICE = re.compile(r"\(?(?:[A-Z]|[1-9][0-9]?)[).]?")


def shown(exercise: Exercise) -> Sheet:
    """Give the list, and the ladders with their letters."""
    ladders = tuple(ladder_either(one, exercise.dialect).ladder for one in exercise.choices)
    return Sheet("choice", program=looked_at(exercise), ladders=ladders, rows=tuple(ascii_uppercase[: len(ladders)]))


def judged(exercise: Exercise, answer: str | bytes) -> Judgement:
    """Hold the chosen ladder against the list."""
    text = text_of(answer)
    found = refused(text)
    chosen = () if found else _read(text)
    if not found and (not chosen or not all(0 <= one < len(exercise.choices) for one in chosen)):
        last = ascii_uppercase[len(exercise.choices) - 1]
        found = (rule("KND007").at(Span(next(rows(text))[0]), last=last),)
    if found:
        return graded(exercise, text, 0.0, found=found)
    if len(chosen) > 1:
        return graded(exercise, text, 0.0, says=(_ONLY_ONE,))
    verdict = told(exercise, chosen[0])
    right = verdict.status == "equal"
    judgement = graded(exercise, text, 1.0 if right else 0.0)
    if right or verdict.counterexample is None:
        return judgement
    program = reference(exercise.choices[chosen[0]], exercise.dialect)
    shown = replace(verdict, status="different", diagnostics=(), proof=None)
    return replace(judgement, program=program, verdict=shown)


def model(exercise: Exercise) -> str:
    """Give the letter of the ladder that does what the list does; DeclarationError where not exactly one does."""
    right = [
        letter
        for at, letter in enumerate(ascii_uppercase[: len(exercise.choices)])
        if told(exercise, at).status == "equal"
    ]
    if len(right) != 1:
        msg = f"exercise {exercise.id}: exactly one choice is the list, and here it is {right}"
        raise DeclarationError(msg)
    return right[0]


def told(exercise: Exercise, number: int) -> Verdict:
    """Compare the list with one of the ladders, counted from 0."""
    choice = reference(exercise.choices[number], exercise.dialect)
    return verdict_on(looked_at(exercise), choice, exercise.terms)


def _read(text: str) -> tuple[int, ...]:
    """Read letters or numbers, and give the numbers of the choices from 0; none where something else stands there too."""
    words = " ".join(row for _, row in rows(text)).upper().replace(",", " ").split()
    if len(words) > len(ascii_uppercase) or not all(map(_CHOICE.fullmatch, words)):
        return ()
    plain = dict.fromkeys(word.strip("().") for word in words)
    return tuple(ascii_uppercase.index(one) if one in ascii_uppercase else int(one) - 1 for one in plain)
