"""Marks: how an exercise's points are shared among what an answer shows, and what an answer gets of each share."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.judgement import Part
from plcteach.core.diagnostic import rule
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.exercise import Exercise
    from plcteach.core.verdict import Verdict

NAMES = {
    "outputs": Text("输出", "outputs"),
    "steps": Text("步骤", "steps"),
    "style": Text("写法", "style"),
    "needs": Text("题目要求", "requirements"),
}
_USUAL = {"outputs": 1.0}
_PER_REMARK = 0.25
HALF = 0.5
CAPPED = 0.75
"""More than this no answer gets that does the right thing and leaves out what the task asks for."""


def parted(exercise: Exercise, shares: Mapping[str, float], *, capped: bool = False) -> tuple[tuple[Part, ...], float]:
    """Give the parts of the marks and their sum, from the share (0 to 1) that was reached of each.

    capped: something that the task asks for is missing, and the weights leave nothing for it.
    """
    weights = weights_of(exercise)
    most = CAPPED if capped and "needs" not in weights else 1.0
    reached = sum(weight * shares.get(name, 0.0) for name, weight in weights.items())
    scale = most / reached if reached > most else 1.0
    parts = tuple(
        Part(
            NAMES[name],
            round(exercise.points * weight * shares.get(name, 0.0) * scale, 2),
            round(exercise.points * weight, 2),
        )
        for name, weight in weights.items()
    )
    if all(shares.get(name, 0.0) >= 1 for name in weights) and scale >= 1:
        return parts, exercise.points
    return parts, round(min(sum(one.got for one in parts), exercise.points), 2)


def weights_of(exercise: Exercise) -> dict[str, float]:
    """Give the weight of each part that counts; together they are 1."""
    weights = {name: weight for name, weight in (exercise.weights or _USUAL).items() if weight > 0}
    return {name: weight / sum(weights.values()) for name, weight in weights.items()}


def shares_of(verdict: Verdict, met: float = 1.0) -> dict[str, float]:
    """Give what a program reaches of each share; `met`: how many of the task's requirements it fulfils, 0 to 1.

    A program that does not do the right thing gets half of its right outputs, and of the rest as much as outputs are right:
    one that does nothing is not to be paid for doing it in good style.
    """
    if verdict.status == "error":
        return {}
    equal = verdict.status == "equal"
    right = sum(one == "equal" for one in verdict.outputs.values())
    share = 1.0 if equal else right / len(verdict.outputs) if verdict.outputs else 0.0
    remarks = sum(rule(one.code).style for one in verdict.diagnostics)
    return {
        "outputs": 1.0 if equal else share * HALF,
        "steps": 1.0 if equal else agreeing(verdict, share),
        "style": max(0.0, 1 - _PER_REMARK * remarks) * share,
        "needs": met * share,
    }


def agreeing(verdict: Verdict, otherwise: float) -> float:
    """Give the share of the counterexample's scans in which all outputs agree."""
    example = verdict.counterexample
    if example is None or not example.inputs:
        return otherwise
    pairs = list(zip(example.expected, example.got, strict=False))
    return sum(wanted == got for wanted, got in pairs) / len(pairs)
