"""Textbook programs in time and what learners make of them: each gets the verdict that its meaning demands, whatever proves it.

Nothing here comes from the machine: 49 for 50 is wrong because 4.9 s is not 5 s, a rung moved is only late, a renamed timer is the
same timer.
"""

from __future__ import annotations

import pytest

from plcteach.check.lint import lint
from plcteach.check.same import compare
from plcteach.core.exercise import Terms
from plcteach.machine import run
from plcteach.stl import read

STAR = (
    "LD I0.0; O Q0.0; AN I0.1; = Q0.0; LD Q0.0; AN T37; AN Q0.2; = Q0.1; "
    "LD Q0.0; TON T37, 50; LD T37; A Q0.0; AN Q0.1; = Q0.2"
)
FLASH = "LD I0.0; AN T38; TON T37, 5; LD T37; TON T38, 5; LD T37; = Q0.0"
CHAIN = "LD I0.0; TON T37, 50; LD T37; TON T38, 50; LD T38; = Q0.0"
COUNT = "LD I0.0; LD I0.1; CTU C0, 20; LD C0; = Q0.0"
SHIFT = "LD I0.0; EU; = M1.0; LD M1.0; SHRB I0.1, M10.0, +4; LD M10.3; = Q0.0"
SEAL = "LD I0.0; O Q0.0; AN I0.1; = Q0.0"
LATCH = "LD I0.0; S Q0.0, 1; LD I0.1; R Q0.0, 1"
OFF = "LD I0.0; TOF T37, 30; LD T37; = Q0.0"
FX_FLASH = "LD X0; ANI T1; OUT T0 K5; LD T0; OUT T1 K5; LD T0; OUT Y0"
FX_COUNT = "LD X0; RST C0; LD X1; OUT C0 K5; LD C0; OUT Y0"
FX_STEPS = "LD X0; SET S20; STL S20; OUT Y0; LD X1; SET S21; STL S21; OUT Y1; LD X2; OUT S20; RET"
DRUM = "%DR1: OUT=%Q0.1,%Q0.2,%Q0.3,%Q0.4,%Q0.5,%Q0.7 STEPS=110000,011000,100010,010101; LD %I0.0; U %DR1; LD %I0.1; R %DR1"
SBR = "LD %I0.0; CU %SBR0; LD %I0.1; ST %SBR0.0; LD %SBR0.3; ST %Q0.0"
STEPS = "LD %I0.0; CU %SC0; LD %I0.1; R %SC0; LD %SC0.3; ST %Q0.0"
FIFO = "LD %I0.0; [%R0.I := 5]; LD %I0.1; I %R0; LD %I0.2; O %R0; LD [%R0.O = 5]; ST %Q0.0"
NEZA_ON = "%TM0: TYPE=TON TB=100ms P=5; LD %I0.0; IN %TM0; LD %TM0.Q; ST %Q0.0"

EQUAL = [
    ("another timer of the same kind", "s7-200", STAR, STAR.replace("T37", "T101"), "exact"),
    ("5 s after 5 s is 10 s", "s7-200", CHAIN, "LD I0.0; TON T37, 100; LD T37; = Q0.0", "exact"),
    ("rungs in another order", "s7-200", STAR,
     "LD I0.0; O Q0.0; AN I0.1; = Q0.0; LD Q0.0; TON T37, 50; LD Q0.0; AN T37; AN Q0.2; = Q0.1; LD T37; A Q0.0; AN Q0.1; = Q0.2",
     "settled"),
    ("star-delta without its cross contacts, provably the same at rest", "s7-200", STAR,
     "LD I0.0; O Q0.0; AN I0.1; = Q0.0; LD Q0.0; AN T37; = Q0.1; LD Q0.0; TON T37, 50; LD T37; A Q0.0; = Q0.2", "settled"),
    ("flashing by other timers", "s7-200", FLASH, FLASH.replace("T37", "T101").replace("T38", "T102"), "exact"),
    ("a comparison for the timer's bit", "s7-200", "LD I0.0; TON T37, 30; LD T37; = Q0.0",
     "LD I0.0; TON T37, 300; LDW>= T37, 30; = Q0.0", "exact"),
    ("a counter of another number", "s7-200", COUNT, COUNT.replace("C0", "C9"), "exact"),
    ("a comparison for the counter's bit", "s7-200", COUNT, "LD I0.0; LD I0.1; CTU C1, 99; LDW>= C1, 20; = Q0.0", "exact"),
    ("up and down, another number", "s7-200", "LD I0.0; LD I0.1; LD I0.2; CTUD C5, 4; LD C5; = Q0.0",
     "LD I0.0; LD I0.1; LD I0.2; CTUD C6, 4; LD C6; = Q0.0", "exact"),
    ("a shift register of other bits", "s7-200", SHIFT, SHIFT.replace("M10", "M20"), "exact"),
    ("a seal-in and a latch where reset wins", "s7-200", SEAL, LATCH, "exact"),
    ("FX: flashing", "fx", FX_FLASH, FX_FLASH.replace("T0", "T7").replace("T1 ", "T9 ").replace("ANI T1;", "ANI T9;"), "exact"),
    ("FX: the reset above or below", "fx", FX_COUNT, "LD X1; OUT C1 K5; LD X0; RST C1; LD C1; OUT Y0", None),
    ("FX: other steps", "fx", FX_STEPS, FX_STEPS.replace("S20", "S30").replace("S21", "S31"), "exact"),
    ("NEZA: another drum", "neza", DRUM, DRUM.replace("%DR1", "%DR2"), "exact"),
    ("NEZA: another shift register", "neza", SBR, SBR.replace("%SBR0", "%SBR5"), "exact"),
    ("NEZA: another step counter", "neza", STEPS, STEPS.replace("%SC0", "%SC3"), "exact"),
    ("NEZA: another queue", "neza", FIFO, FIFO.replace("%R0", "%R2"), "exact"),
    ("NEZA: half the time base, twice the preset", "neza", NEZA_ON, NEZA_ON.replace("TB=100ms P=5", "TB=10ms P=50"), "exact"),
    ("GUTTA: the memory bit of an edge written out", "gutta", "LD I0.0; P M0.0; = Q0.0",
     "LD I0.0; AN M7.0; = Q0.0; LD I0.0; = M7.0", "exact"),
    ("GUTTA: another timer", "gutta", "LD I0.0; TON T37, 5; LD T37; = Q0.0", "LD I0.0; TON T38, 5; LD T38; = Q0.0", "exact"),
]  # fmt: skip

DIFFERENT = [
    ("49 for 50", "s7-200", STAR, STAR.replace("50", "49"), 1),
    ("19 for 20", "s7-200", COUNT, COUNT.replace("20", "19"), 37),
    ("5 s after 5 s is not 9.9 s", "s7-200", CHAIN, "LD I0.0; TON T37, 99; LD T37; = Q0.0", 1),
    ("a latch without its seal-in", "s7-200", SEAL, "LD I0.0; AN I0.1; = Q0.0", 2),
    ("S and R exchanged", "s7-200", LATCH, "LD I0.1; R Q0.0, 1; LD I0.0; S Q0.0, 1", 2),
    ("a counter for a shift register", "s7-200", SHIFT, "LD I0.0; LDN I0.1; CTU C0, 4; LD C0; = Q0.0", None),
    ("TON for TOF", "s7-200", OFF, OFF.replace("TOF", "TON"), 1),
    ("the stop button forgotten", "s7-200", STAR, STAR.replace("AN I0.1; ", ""), 2),
    ("unequal halves", "s7-200", FLASH, FLASH.replace("TON T38, 5", "TON T38, 6"), 1),
    ("a timer that keeps its time", "s7-200", "LD I0.0; TON T37, 20; LD T37; = Q0.0", "LD I0.0; TONR T5, 20; LD T5; = Q0.0", None),
    ("the fastest timers too", "s7-200", "LD I0.0; TON T32, 30; LD T32; = Q0.0", "LD I0.0; TON T96, 31; LD T96; = Q0.0", 1),
    ("a clock the wrong way round", "s7-200", "LD I0.0; TON T37, 5; LD T37; A SM0.5; = Q0.0",
     "LD I0.0; TON T37, 5; LD T37; AN SM0.5; = Q0.0", 1),
    ("FX: a count too few", "fx", FX_COUNT, FX_COUNT.replace("K5", "K4"), 7),
    ("FX: the wrong step", "fx", FX_STEPS, FX_STEPS.replace("LD X1; SET S21", "LD X2; SET S21"), 2),
    ("NEZA: a wrong row of the drum", "neza", DRUM, DRUM.replace("010101", "010100"), 5),
    ("NEZA: one place too far", "neza", SBR, SBR.replace("%SBR0.3", "%SBR0.4"), None),
    ("NEZA: TOF for TON", "neza", NEZA_ON, NEZA_ON.replace("TYPE=TON", "TYPE=TOF"), 1),
    ("NEZA: another number in the queue", "neza", FIFO, FIFO.replace(":= 5", ":= 4"), None),
    ("GUTTA: one tick more", "gutta", "LD I0.0; TON T37, 5; LD T37; = Q0.0", "LD I0.0; TON T37, 6; LD T37; = Q0.0", 1),
]  # fmt: skip


def presses(scans: tuple[dict[str, int], ...]) -> int:
    count, now = 0, dict.fromkeys(scans[0], 0)
    for scan in scans:
        count += sum(now[name] != value for name, value in scan.items() if name != "ms")
        now |= scan
    return count


def programs(family: str, *texts: str) -> list:
    found = [read(text.replace("; ", "\n"), family) for text in texts]
    assert not [one for program in found for one in lint(program) if one.severity == "error"]
    return found


@pytest.mark.parametrize(("why", "family", "reference", "student", "level"), EQUAL, ids=[row[0] for row in EQUAL])
def test_the_same_is_proved(why: str, family: str, reference: str, student: str, level: str | None) -> None:
    mine, theirs = programs(family, reference, student)
    verdict = compare(mine, theirs)
    assert verdict.status == "equal", why
    assert verdict.proof in {"table", "exhaustive", "induction"}
    assert level in (verdict.level, None)
    assert compare(theirs, mine).status == "equal", "either way round"


@pytest.mark.parametrize(
    ("why", "family", "reference", "student", "least"), DIFFERENT, ids=[row[0] for row in DIFFERENT]
)
def test_what_differs_is_shown_with_as_few_presses_as_can_be(
    why: str, family: str, reference: str, student: str, least: int | None
) -> None:
    mine, theirs = programs(family, reference, student)
    verdict = compare(mine, theirs)
    assert verdict.status == "different", why
    example = verdict.counterexample
    assert example is not None
    ends = [repr(run(one, example.inputs).value(example.address, example.scan)) for one in (mine, theirs)]
    assert ends == [example.expected[-1][example.address], example.got[-1][example.address]]
    assert ends[0] != ends[1]
    if least is not None:
        assert presses(example.inputs) == least
    assert compare(theirs, mine).status == "different"


def test_the_counterexample_of_49_for_50_is_one_press_held_for_4_9_seconds() -> None:
    example = compare(*programs("s7-200", STAR, STAR.replace("50", "49"))).counterexample
    assert example is not None
    assert example.inputs[0] == {"I0.0": 1, "I0.1": 0, "ms": 0}
    assert sum(scan["ms"] for scan in example.inputs) == 4900
    assert {scan["I0.0"] for scan in example.inputs} == {1}


def test_presets_of_any_size_are_proved_by_induction() -> None:
    rows = [f"LD I{n // 8}.{n % 8}; TON T{{}}, 32767; LD T{{}}; = Q{n // 8}.{n % 8}" for n in range(12)]
    one, other = ("; ".join(row.replace("{}", str(at + n)) for n, row in enumerate(rows)) for at in (37, 101))
    verdict = compare(*programs("s7-200", one, other))
    assert (verdict.status, verdict.proof) == ("equal", "induction")


@pytest.mark.parametrize("level", ["either", "exact", "settled"])
@pytest.mark.parametrize(
    ("why", "text", "seconds"),
    [
        (
            "ten minutes after one press",
            "LD I0.0; O Q0.0; AN I0.1; = Q0.0; LD Q0.0; TON T37, {}; LD T37; = Q0.1",
            599.9,
        ),
        ("ten minutes after it is let go", "LD I0.0; TOF T37, {}; LD T37; = Q0.0", 599.9),
        ("one delay behind the other", "LD I0.0; TON T37, {}; LD T37; TON T38, 600; LD T38; = Q0.0", 659.9),
    ],
)
def test_one_tick_in_ten_minutes_is_found(why: str, text: str, seconds: float, level: str) -> None:
    wanted, got = programs("s7-200", text.format(6000), text.format(5999))
    verdict = compare(wanted, got, terms=Terms(level=level))
    assert verdict.status == "different", why
    example = verdict.counterexample
    assert example is not None
    assert sum(scan.get("ms", 0) for scan in example.inputs) == pytest.approx(seconds * 1000, abs=300)
    assert presses(example.inputs) <= 2


def test_one_count_in_thousands_is_found() -> None:
    text = "LD I0.0; LD I0.1; CTU C0, {}; LD C0; = Q0.0"
    verdict = compare(*programs("s7-200", text.format(6000), text.format(5999)))
    assert verdict.counterexample is not None
    assert presses(verdict.counterexample.inputs) >= 5999


# The terms of an exercise.


def judged(reference: str, student: str, **terms: object) -> str:
    return compare(*programs("s7-200", reference, student), terms=Terms(**terms)).status  # type: ignore[arg-type]


def test_what_cannot_happen_need_not_be_right() -> None:
    one, other = "LD I0.0; A I0.1; = Q0.0; LD I0.2; = Q0.1", "LD I0.2; = Q0.1"
    assert judged(one, other + "; LDN I0.0; A I0.0; = Q0.0") == "different"
    assert judged(one, other + "; LDN I0.0; A I0.0; = Q0.0", assume=("!(I0.0 & I0.1)",)) == "equal"
    ends = "LD I0.0; S Q0.0, 1; LD I0.1; R Q0.0, 1"
    swapped = "LD I0.1; R Q0.0, 1; LD I0.0; S Q0.0, 1"
    assert judged(ends, swapped) == "different"
    assert judged(ends, swapped, assume=("!(I0.0 & I0.1)",)) == "equal"


def test_inputs_that_change_one_at_a_time_hide_what_needs_two() -> None:
    both = "LD I0.0; EU; = M0.0; LD I0.1; EU; A M0.0; = Q0.0"
    nothing = "LD I0.0; AN I0.0; = Q0.0"
    assert judged(both, nothing, level="exact") == "different"
    assert judged(both, nothing, level="exact", single_change=True) == "equal"


def test_one_input_at_a_time_holds_at_rest_too() -> None:
    one = "LD I0.0; EU; A I0.1; S Q0.0, 1; LDN I0.1; R Q0.0, 1"
    other = "LDN I0.1; R Q0.0, 1; LD I0.0; EU; A I0.1; A M0.0; S Q0.0, 1; LD I0.1; = M0.0"
    assert judged(one, other, level="settled") == "different"
    assert judged(one, other, level="settled", single_change=True) == "equal"


def test_what_does_not_matter_is_not_compared() -> None:
    assert judged("LD I0.0; = Q0.0", "LD I0.0; O I0.7; = Q0.0") == "different"
    assert judged("LD I0.0; = Q0.0", "LD I0.0; O I0.7; = Q0.0", dont_care={"Q0.0": "I0.7"}) == "equal"


def test_only_the_outputs_asked_for_are_compared() -> None:
    assert judged("LD I0.0; = Q0.0; = Q0.1", "LD I0.0; = Q0.0; NOT; = Q0.1") == "different"
    assert judged("LD I0.0; = Q0.0; = Q0.1", "LD I0.0; = Q0.0; NOT; = Q0.1", outputs=("Q0.0",)) == "equal"


def test_what_must_never_be_is_found_though_the_reference_does_it_as_well() -> None:
    motors = "LD I0.0; = Q0.0; LD I0.1; = Q0.1"
    verdict = compare(*programs("s7-200", motors, motors), terms=Terms(never=("Q0.0 & Q0.1",)))
    assert verdict.status == "different"
    assert verdict.counterexample is not None
    assert verdict.counterexample.address == "Q0.0 & Q0.1"
    assert verdict.counterexample.inputs[-1] == {"I0.0": 1, "I0.1": 1}
    assert (verdict.counterexample.expected[-1]["Q0.0 & Q0.1"], verdict.counterexample.got[-1]["Q0.0 & Q0.1"]) == (
        "0",
        "1",
    )
    locked = "LD I0.0; AN Q0.1; = Q0.0; LD I0.1; AN Q0.0; = Q0.1"
    assert judged(locked, locked, never=("Q0.0 & Q0.1",)) == "equal"


# A pulse of one scan leaves no trace at rest, and yet it must come: the usual level sees it, and "settled" alone does not.

PULSES = [
    ("a falling edge for a rising one", "s7-200", "LD I0.0; EU; = Q0.0", "LD I0.0; ED; = Q0.0"),
    ("never on", "s7-200", "LD I0.0; EU; = Q0.0", "LD I0.0; AN I0.0; = Q0.0"),
    ("the memory of the edge written too early", "s7-200", "LD I0.0; EU; = Q0.0", "LD I0.0; = M0.0; LD I0.0; AN M0.0; = Q0.0"),
    ("the edge of the whole condition", "fx", "LD X0; ANDP X1; OUT Y0", "LD X0; AND X1; PLS M0; LD M0; OUT Y0"),
    ("the edge of one contact", "s7-200", "LD I0.0; EU; A I0.1; = Q0.0", "LD I0.0; A I0.1; EU; = Q0.0"),
    ("the other edge", "gutta", "LD I0.0; P M0.0; = Q0.0", "LD I0.0; N M0.0; = Q0.0"),
    ("a timer's scan that never comes", "s7-200", "LDN T37; TON T37, 10; LD T37; = Q0.0", "LDN T37; TON T37, 10; LD T37; AN T37; = Q0.0"),
]  # fmt: skip


@pytest.mark.parametrize(("why", "family", "reference", "student"), PULSES, ids=[row[0] for row in PULSES])
def test_a_pulse_that_does_not_come_is_a_difference(why: str, family: str, reference: str, student: str) -> None:
    mine, theirs = programs(family, reference, student)
    verdict = compare(mine, theirs)
    assert verdict.status == "different", why
    example = verdict.counterexample
    assert example is not None
    ends = [repr(run(one, example.inputs).value(example.address, example.scan)) for one in (mine, theirs)]
    assert ends[0] != ends[1]
    assert compare(theirs, mine).status == "different"


def test_a_pulse_a_scan_later_is_only_late_and_a_lost_one_is_named() -> None:
    one, late = "LD I0.0; EU; = M1.0; LD M1.0; = Q0.0", "LD M1.0; = Q0.0; LD I0.0; EU; = M1.0"
    verdict = compare(*programs("s7-200", one, late))
    assert (verdict.status, verdict.level) == ("equal", "settled")
    lost = compare(*programs("s7-200", *PULSES[-1][2:]))
    assert [one.code for one in lost.diagnostics] == ["CHK005"]
    settled = compare(*programs("s7-200", *PULSES[1][2:]), terms=Terms(level="settled"))
    assert settled.status == "equal", "who asks for what remains at rest gets that"


# A number that is read in any other way than by a comparison with a constant keeps all its bits.

MOVED = [
    ("s7-200", "LD I0.0; TON T37, 5; LD SM0.0; MOVW T37, VW0; LDW>= VW0, 8; = Q0.0", ("8;", "9;")),
    ("s7-200", "LD I0.0; LD I0.1; CTU C0, 2; LD SM0.0; MOVW C0, VW0; LDW>= VW0, 5; = Q0.0", ("5;", "6;")),
    ("s7-200", "LD I0.0; TON T37, 5; LDW>= T37, 7; = Q0.0", (">=", "> ")),
    ("s7-200", "LD I0.0; LD I0.1; CTU C0, 2; LDW= C0, 3; = Q0.0", ("LDW= ", "LDW>= ")),
    ("s7-200", "LD I0.1; MOVW 5, VW0; LD I0.0; TON T37, VW0; LD T37; = Q0.0", ("MOVW 5", "MOVW 6")),
    ("s7-200", "LD I0.0; TON T37, 5; LD I0.1; TON T37, 9; LD T37; = Q0.0", ("9;", "8;")),
    ("fx", "LD X0; OUT T0 K5; LD M8000; MOV T0 D0; LD>= D0 K3; OUT Y0", ("K3", "K4")),
    ("neza", "%TM0: TYPE=TON TB=100ms P=5; LD %I0.0; IN %TM0; LD 1; [%MW0 := %TM0.V]; LD [%MW0 >= 3]; ST %Q0.0", (">= 3", ">= 4")),
]  # fmt: skip


@pytest.mark.parametrize(("family", "text", "change"), MOVED)
def test_a_number_that_goes_elsewhere_is_followed(family: str, text: str, change: tuple[str, str]) -> None:
    mine, theirs = programs(family, text, text.replace(*change))
    assert compare(mine, theirs).status == "different"
    renamed = text.replace("T37", "T101").replace("C0", "C9").replace("D0", "D7")
    assert compare(mine, programs(family, renamed)[0]).status == "equal"
