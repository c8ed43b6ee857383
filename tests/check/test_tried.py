"""Programs with time or words in them are tried side by side: what differs is shown, and what is only tried is never called equal."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from plcteach.check import same
from plcteach.check.against import reference, verdict_on
from plcteach.core.errors import PlcTeachError
from plcteach.core.exercise import Terms
from plcteach.machine import run
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.core.program import Program
    from plcteach.core.verdict import Verdict


def compare(reference: Program, student: Program, *, level: str = "exact", outputs: Iterable[str] = ()) -> Verdict:
    return same.compare(reference, student, terms=Terms(level=level, outputs=tuple(outputs)))


LAMP = "LD I0.0; TON T37, {}; LD T37; = Q0.0"
LATE = "LD M0.0; = Q0.0; LD I0.0; TON T37, 5; LD T37; = M0.0"
SOON = "LD I0.0; TON T37, 5; LD T37; = M0.0; LD M0.0; = Q0.0"


@pytest.mark.parametrize("level", ["exact", "either"])
def test_one_tick_more_is_found_and_can_be_replayed(level: str) -> None:
    reference, student = read(LAMP.format(49)), read(LAMP.format(50))
    verdict = compare(reference, student, level=level)
    assert verdict.status == "different"
    example = verdict.counterexample
    assert example is not None
    ends = [repr(run(one, example.inputs).value("Q0.0", example.scan)) for one in (reference, student)]
    assert ends == [example.expected[-1]["Q0.0"], example.got[-1]["Q0.0"]] == ["1", "0"]


def test_the_same_text_is_equal_and_another_number_is_not_called_so() -> None:
    assert compare(read(LAMP.format(5)), read(LAMP.format(5))).proof == "structural"
    other = compare(read(LAMP.format(5)), read(LAMP.format(5).replace("T37", "T38")))
    assert (other.status, other.proof) == ("equal", "exhaustive")


def test_a_scan_later_is_a_difference_only_at_the_level_exact() -> None:
    assert compare(read(SOON), read(LATE), level="exact").status == "different"
    assert compare(read(SOON), read(LATE), level="either").status == "equal"


def test_another_configuration_is_another_program() -> None:
    text = "%TM0: TYPE={} TB=100ms P=5\nLD %I0.0\nIN %TM0\nLD %TM0.Q\nST %Q0.0"
    assert compare(read(text.format("TON"), "neza"), read(text.format("TOF"), "neza")).status == "different"


def test_a_program_that_never_ends_its_scan_is_not_tried_for_long() -> None:
    endless = read("LBL 1; LD SM0.0; JMP 1; LD I0.0; = Q0.0")
    verdict = compare(endless, read("LBL 1; LD SM0.0; JMP 1; LDN I0.0; = Q0.0"))
    assert (verdict.status, verdict.explored) == ("unknown", 1)


def test_a_word_that_nothing_writes_is_no_free_input_and_stays_zero() -> None:
    reference = read("LD= D0 K5; OR X0; OUT Y0", "fx")
    assert compare(reference, reference).status == "equal"
    assert compare(reference, read("LD X0; OR= D0 K5; OUT Y0", "fx")).status == "equal"
    wrong = compare(reference, read("LD= D0 K5; AND X0; OUT Y0", "fx"))
    assert wrong.status == "different"


@pytest.mark.parametrize(
    ("dialect", "task", "answer", "row"),
    [
        ("s7-200", "LD I0.0; = Q0.0", "LBL 1; LD SM0.0; JMP 1", 3),
        ("s7-200", "LD I0.0; = Q0.0", "LD I0.0; = Q0.0; LBL 1; LD SM0.0; JMP 1", 5),
        ("neza", "LD %I0.0; ST %Q0.0", "LD %I0.0; ST %Q0.0; %L1:; JMP %L1", 4),
    ],
)
def test_a_scan_that_never_ends_is_an_error_in_its_row(dialect: str, task: str, answer: str, row: int) -> None:
    verdict = verdict_on(read(task, dialect), read(answer.replace("; ", "\n"), dialect))
    assert verdict.status == "error"
    assert [(one.code, one.span.row) for one in verdict.diagnostics if one.severity == "error"] == [("RUN002", row)]
    with pytest.raises(PlcTeachError, match="20000 lines"):
        reference(answer.replace("; ", "\n"), dialect)


def test_a_routine_that_calls_itself_is_told_and_a_combination_of_inputs_shows_what_is_wrong() -> None:
    calls = "LD SM0.0\nCALL SBR0\nSUBROUTINE_BLOCK SBR_0:SBR0\nLD SM0.0\nCALL SBR0\nEND_SUBROUTINE_BLOCK"
    verdict = verdict_on(read("LD I0.0\nAN I0.1\n= Q0.0", "s7-200"), read(calls, "s7-200"))
    assert verdict.status == "different"
    assert "RUN003" in {one.code for one in verdict.diagnostics}
    assert verdict.counterexample is not None
    assert [{key: scan[key] for key in ("I0.0", "I0.1")} for scan in verdict.counterexample.inputs] == [
        {"I0.0": 1, "I0.1": 0}
    ]
