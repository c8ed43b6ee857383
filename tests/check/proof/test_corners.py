"""Corners in which a proof could go wrong, found by attacking it: each verdict is held against the plain machine."""

from __future__ import annotations

import pytest

from plcteach.check.same import compare, forget
from plcteach.core.errors import DeclarationError
from plcteach.core.exercise import Terms
from plcteach.machine import run
from plcteach.stl import read

# Two programs that the plain machine tells apart on the given inputs.
DIFFERENT = [
    ("an edge that the first scan jumps over", "s7-200", "LD SM0.1; JMP 1; LD I0.0; EU; = Q0.0; LBL 1",
     "LD I0.0; AN SM0.1; EU; = Q0.0", [{"I0.0": 0}, {"I0.0": 1}]),
    ("an edge behind the end of the first scan", "s7-200", "LD SM0.1; END; LD I0.0; EU; S Q0.0, 1",
     "LD I0.0; AN SM0.1; EU; S Q0.0, 1", [{"I0.0": 0}, {"I0.0": 1}]),
    ("a counter that the first scan jumps over", "s7-200",
     "LD SM0.1; JMP 1; LD I0.0; LD I0.1; CTU C0, 2; LBL 1; LD C0; = Q0.0",
     "LD I0.0; AN SM0.1; LD I0.1; CTU C0, 2; LD C0; = Q0.0", [{"I0.0": 1}, {"I0.0": 1}, {"I0.0": 0}, {"I0.0": 1}]),
    ("a counter of another family", "neza",
     "LD %S13; JMPC %L1; LD %I0.0; CU %C0; %L1:; LD [%C0.V >= 1]; ST %Q0.0",
     "LD %I0.0; ANDN %S13; CU %C0; LD [%C0.V >= 1]; ST %Q0.0", [{"%I0.0": 0}, {"%I0.0": 1}]),
    ("the word of a timer that nobody drives", "s7-200",
     "LD I0.0; TON T37, 5; LD T37; = Q0.0; LDW>= T33, 1; = Q0.1",
     "LD I0.0; TON T37, 5; LD T37; = Q0.0; LD SM0.0; = Q0.1", [{}]),
    ("a preset below 0", "s7-200",
     "LD SM0.0; MOVW -1, VW0; LD T33; = Q0.0; LD I0.0; TON T33, VW0; LDW>= T33, 3; R T33, 1",
     "LD SM0.0; MOVW 32767, VW0; LD T33; = Q0.0; LD I0.0; TON T33, VW0; LDW>= T33, 3; R T33, 1",
     [{"I0.0": 1, "ms": 10}, {"I0.0": 1, "ms": 10}]),
    ("an x within a number", "s7-200", "LDN SM0.0; = Q0.0", "LD SM0.0; ALD; MOVW 4, VW0; LDW>= VW0, 8; = Q0.0", [{}]),
    ("an x in a bit of a number", "s7-200", "LD I0.0; = Q0.0",
     "LD SM0.0; ALD; = V1.0; LDW>= VW0, 2; = M0.0; LD I0.0; O M0.0; = Q0.0", [{"I0.0": 0}]),
    ("an output that the reference jumps over", "s7-200", "LD I0.0; = Q0.0; LD SM0.0; JMP 1; LD I0.1; = Q0.1; LBL 1",
     "LD I0.0; = Q0.0; LD I0.1; = Q0.1", [{"I0.1": 1}]),
    ("an analogue input below 0", "s7-200", "LDW>= AIW0, 0; = Q0.0", "LD SM0.0; = Q0.0", [{"AIW0": -1}]),
    ("a row in a routine that nobody calls", "s7-200", "LD I0.0; = Q0.0; Network 2; LD I0.1; = Q0.1",
     "LD I0.0; = Q0.0; SUBROUTINE_BLOCK SBR_0:SBR0; Network 1; LD I0.1; = Q0.1; END_SUBROUTINE_BLOCK", [{"I0.1": 1}]),
]  # fmt: skip


def text(rows: str) -> str:
    return rows.replace("; ", "\n")


@pytest.mark.parametrize(("why", "family", "one", "other", "rows"), DIFFERENT, ids=[row[0] for row in DIFFERENT])
def test_what_the_plain_machine_tells_apart_is_never_called_equal(
    why: str, family: str, one: str, other: str, rows: list[dict[str, int]]
) -> None:
    mine, theirs = read(text(one), family), read(text(other), family)
    outputs = ("%Q0.0",) if family == "neza" else ("Q0.0", "Q0.1")
    ends = [[repr(run(program, rows).value(place, len(rows) - 1)) for place in outputs] for program in (mine, theirs)]
    assert ends[0] != ends[1], why
    verdict = compare(mine, theirs, terms=Terms(level="exact"))
    assert verdict.status == "different", why
    assert compare(mine, mine, terms=Terms(level="exact")).status == "equal"


@pytest.mark.parametrize(
    "rows",
    [
        "LD I0.0; JMP 1; LD I0.1; LD I0.2; CTU C0, 3; LBL 1; LD C0; = Q0.0",
        "LD I0.0; END; LD I0.1; LD I0.2; CTU C0, 3; LD C0; = Q0.0",
        "LD I0.0; CTU C0, 3; LD C0; = Q0.0",
        "LD I0.0; ALD; EU; = Q0.0",
    ],
)
def test_an_edge_of_what_may_be_x_is_worked_out(rows: str) -> None:
    program, other = read(text(rows), "s7-200"), read(text(rows + "; LD I0.7; = M9.0"), "s7-200")
    assert compare(program, read("LD I0.3\n= Q0.0", "s7-200"), terms=Terms(level="exact")).status == "different"
    assert compare(program, other, terms=Terms(level="exact")).status in {"equal", "different"}


@pytest.mark.parametrize("preset", [500, 6000])
@pytest.mark.parametrize(
    ("family", "timer", "lamp"),
    [("s7-200", "LD I0.0; TON T37, {}", "LD T37; = Q0.0"), ("s7-200", "LD I0.0; TOF T37, {}", "LD T37; = Q0.0"),
     ("fx", "LD X0; OUT T0 K{}", "LD T0; OUT Y0")],
)  # fmt: skip
def test_rungs_in_another_order_are_never_different_at_rest(family: str, timer: str, lamp: str, preset: int) -> None:
    rungs = timer.format(preset), lamp
    mine, theirs = (read(text("; ".join(order)), family) for order in (rungs, rungs[::-1]))
    for level in ("either", "settled"):
        status = compare(mine, theirs, terms=Terms(level=level)).status
        assert status == "equal" if preset == 500 else status in {"equal", "unknown"}


def test_a_lag_of_one_scan_is_no_difference_though_the_inputs_change_in_every_scan() -> None:
    count, copy, lamp = "LD I0.0; LD I0.1; CTU C0, 3", "LD SM0.0; MOVW C0, VW4", "LDW< VW4, 1; = Q0.0"
    mine, theirs = (read(text("; ".join(order)), "s7-200") for order in ((count, copy, lamp), (copy, count, lamp)))
    assert compare(mine, theirs).status in {"equal", "unknown"}


def test_what_is_remembered_of_earlier_verdicts_is_no_other_program() -> None:
    good = read("LD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1", "s7-200")
    bad = read(text(DIFFERENT[-1][3]), "s7-200")
    forget()
    assert [compare(good, one).status for one in (good, bad, good, bad)] == ["equal", "different"] * 2


def test_the_terms_are_read_as_they_are_meant() -> None:
    lamp, never = read("LD I0.0\n= Q0.0", "s7-200"), read("LDN SM0.0\n= Q0.0", "s7-200")
    narrow = read("LD I0.0\nA I0.1\n= Q0.0", "s7-200")
    assert compare(lamp, never, terms=Terms(never=("Q0.0",))).status == "different"
    assert compare(lamp, narrow, terms=Terms(dont_care={"q0.0": "!I0.1"})).status == "equal"
    for assumed in ("I0.0 & !I0.0", "!Q0.0"):
        with pytest.raises(DeclarationError):
            compare(lamp, narrow, terms=Terms(assume=(assumed,)))


def test_what_only_the_first_scan_shows_is_gone_at_rest() -> None:
    off, once = read("LD I0.0\nAN I0.0\n= Q0.0", "s7-200"), read("LD SM0.1\n= Q0.0", "s7-200")
    late = read("LD M0.1\n= M0.0\nLD I0.0\nON I0.0\n= M0.1\nLDN M0.0\n= Q0.0", "s7-200")
    assert compare(off, late, terms=Terms(level="settled")).status == "equal"
    assert compare(off, late, terms=Terms(level="exact")).status == "different"
    assert compare(once, off).status == "different", "a pulse that the reference gives must come"
