"""The level "settled": inputs held until both programs rest; rung order forgiven, wrong results not."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from plcteach.check import same
from plcteach.core.exercise import Terms
from plcteach.machine import run
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.core.program import Program
    from plcteach.core.verdict import Verdict


def compare(reference: Program, student: Program, *, level: str = "exact", outputs: Iterable[str] = ()) -> Verdict:
    return same.compare(reference, student, terms=Terms(level=level, outputs=tuple(outputs)))


RELAY = "LD I0.0\n= M0.0\nLD M0.0\n= Q0.0"
SWAPPED = "LD M0.0\n= Q0.0\nLD I0.0\n= M0.0"
CHAIN = "LD M0.1\n= Q0.0\nLD M0.0\n= M0.1\nLD I0.0\n= M0.0"
SEAL = "LD I0.0\nO Q0.0\nAN I0.1\n= Q0.0"


def judged(reference: str, student: str, level: str) -> tuple[str, str]:
    verdict = compare(read(reference), read(student), level=level)
    return verdict.status, verdict.level


@pytest.mark.parametrize("late", [SWAPPED, CHAIN])
def test_a_bit_used_before_it_is_written_is_only_late(late: str) -> None:
    assert judged(RELAY, late, "exact") == ("different", "exact")
    assert judged(RELAY, late, "settled") == ("equal", "settled")
    verdict = compare(read(RELAY), read(late), level="either")
    assert (verdict.status, verdict.level) == ("equal", "settled")
    assert "CHK003" in {one.code for one in verdict.diagnostics}, "and it says that the result comes later"


def test_what_is_exact_is_not_called_late() -> None:
    verdict = compare(read(SEAL), read("LD Q0.0\nO I0.0\nAN I0.1\n= Q0.0"), level="either")
    assert (verdict.status, verdict.level) == ("equal", "exact")
    assert not verdict.diagnostics


@pytest.mark.parametrize(
    "student", ["LD I0.0\nAN I0.1\n= Q0.0", "LD I0.0\nAN I0.1\nO Q0.0\n= Q0.0", "LD M0.0\n= Q0.0\nLDN I0.0\n= M0.0"]
)
def test_a_wrong_result_is_different_at_every_level(student: str) -> None:
    for level in ("exact", "settled", "either"):
        verdict = compare(read(SEAL), read(student), level=level)
        assert verdict.status == "different"
        example = verdict.counterexample
        assert example is not None
        ends = [run(read(text), example.inputs).scans[example.scan][example.address] for text in (SEAL, student)]
        assert ends[0] != ends[1], "the inputs show it on the plain machine"


def test_a_settled_counterexample_holds_its_inputs_until_both_rest() -> None:
    slow = CHAIN.replace("LD I0.0", "LDN I0.0")
    example = compare(read(RELAY), read(slow), level="settled").counterexample
    assert example is not None
    last = example.inputs[-1]
    assert example.inputs[-3:] == (last, last, last), "the chain of three needs three scans"
    for text in (RELAY, slow):
        scans = run(read(text), [*example.inputs, last]).scans
        assert scans[-1]["Q0.0"] == scans[-2]["Q0.0"]


def test_a_program_that_never_rests_is_unsettled() -> None:
    blinker = "LDN Q0.0\n= Q0.0"
    assert judged("LD I0.0\n= Q0.0", blinker, "settled") == ("unsettled", "settled")
    assert judged("LD I0.0\n= Q0.0", blinker, "either")[0] == "different"


def test_a_program_that_differs_and_never_rests_is_told_so() -> None:
    verdict = compare(read("LD I0.0\n= Q0.0"), read("LD I0.0\nAN Q0.0\n= Q0.0"), level="either")
    assert verdict.status == "different"
    assert [one.code for one in verdict.diagnostics] == ["CHK004"]
    both = compare(read("LDN Q0.0\n= Q0.0"), read("LD I0.0\nAN Q0.0\n= Q0.0"), level="either")
    assert "CHK004" not in {one.code for one in both.diagnostics}, "the reference does not rest either"
