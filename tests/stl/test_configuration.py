"""Configuration lines before the first rung: what they set, how they are spelled again, and what is said of the others."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.dialects import dialect
from plcteach.machine import run
from plcteach.stl import read, write, write_bytes

REST = "\nLD %I0.0\nST %Q0.0"


def configured(*lines: str):
    return read("\n".join(lines) + REST, "neza")


def said(*lines: str) -> list[tuple[str, int]]:
    return [(one.code, one.span.row) for one in configured(*lines).diagnostics]


def test_the_four_kinds_of_lines_of_the_notes() -> None:
    lines = (
        "%TM0: TYPE=TON TB=10ms P=100 ADJ=N",
        "%C3: P=20",
        "%R0: TYPE=LIFO",
        "%DR0: OUT=%Q0.0,%Q0.1,%Q0.2 STEPS=000,100,101,010",
        "%KW0: 5",
    )
    program = configured(*lines)
    assert not program.diagnostics
    assert program.configuration == lines
    assert program.settings == {
        "%TM0": {"TYPE": "TON", "TB": "10ms", "P": 100, "ADJ": "N"},
        "%C3": {"P": 20},
        "%R0": {"TYPE": "LIFO"},
        "%DR0": {"OUT": ("%Q0.0", "%Q0.1", "%Q0.2"), "STEPS": ("000", "100", "101", "010")},
        "%KW0": {"": 5},
    }
    again = read(write(program), "neza")
    assert (again, again.settings) == (program, program.settings)
    assert [repr(run(program).value(one, 0)) for one in ("%TM0.P", "%C3.P", "%C0.P", "%KW0")] == [
        "100",
        "20",
        "9999",
        "5",
    ]


@pytest.mark.parametrize(
    ("line", "canonical"),
    [
        ("%tm0:type=ton", "%TM0: TYPE=TON"),
        ("%TM0 : ADJ = y  P= 5 TB =1MIN", "%TM0: TB=1min P=5 ADJ=Y"),
        ("000 %C3: P=+20", "%C3: P=20"),
        ("%C3: P=020 // parts", "%C3: P=20"),
        ("%DR0: STEPS=0 1, 1 OUT=%m7", "%DR0: OUT=%M7 STEPS=0,1,1"),
        ("%DR0:OUT=%Q0.0, %Q0.1 STEPS=00 , 10", "%DR0: OUT=%Q0.0,%Q0.1 STEPS=00,10"),
        ("%KW5: -7", "%KW5: -7"),
        ("%KW5: 16#ff", "%KW5: 16#FF"),
    ],
)
def test_lines_have_one_canonical_spelling(line: str, canonical: str) -> None:
    program = configured(line)
    assert not program.diagnostics
    assert program.configuration == (canonical,)


@pytest.mark.parametrize(
    ("lines", "codes"),
    [
        (["%TM0: TPE=TON"], [("CFG001", 1)]),
        (["%TM0: TYPE"], [("CFG001", 1)]),
        (["%TM0: 5"], [("CFG001", 1)]),
        (["%TM0:"], [("CFG001", 1)]),
        (["%SBR0: P=5"], [("CFG001", 1)]),
        (["%M0: P=5"], [("CFG001", 1)]),
        (["%MW0: 5"], [("CFG001", 1)]),
        (["%XY0: P=5"], [("CFG001", 1)]),
        (["%TM32: P=5"], [("RDR006", 1)]),
        (["%TM0: TYPE=TONR"], [("CFG002", 1)]),
        (["%TM0: TYPE="], [("CFG002", 1)]),
        (["%TM0: TYPE=TON,TOF"], [("CFG002", 1)]),
        (["%TM0: TB=2s"], [("CFG002", 1)]),
        (["%TM0: P=10000"], [("CFG002", 1)]),
        (["%TM0: P=-1"], [("CFG002", 1)]),
        (["%TM0: P=5.5"], [("CFG002", 1)]),
        (["%TM0: ADJ=1 P=x"], [("CFG002", 1), ("CFG002", 1)]),
        (["%KW0: 40000"], [("CFG002", 1)]),
        (["%KW0:"], [("CFG002", 1)]),
        (["%DR0: OUT=%Q0.0 STEPS=2"], [("CFG002", 1)]),
        (["%DR0: OUT=%I0.0 STEPS=1"], [("CFG002", 1)]),
        (["%DR0: OUT=Q0.0 STEPS=1"], [("CFG002", 1)]),
        (["%DR0: OUT=%Q0.0 STEPS=0,1,0,1,0,1,0,1,0"], [("CFG002", 1)]),
        (["%DR0: OUT=" + ",".join(f"%Q0.{bit}" for bit in range(17)) + " STEPS=0"], [("CFG002", 1)]),
        (["%DR0: OUT=%Q0.0,%Q0.1 STEPS=01,1"], [("CFG003", 1)]),
        (["LD %I0.0", "ST %Q0.1", "%TM0: P=5"], [("CFG004", 3)]),
        (["%TM0: P=5", "%TM1: P=6", "%TM0: P=5"], [("CFG005", 3)]),
        (["%TM0: P=5 P=6"], [("CFG005", 1)]),
        (["%DR0: OUT=%Q0.0"], [("CFG006", 1)]),
        (["%DR0: STEPS=0,1"], [("CFG006", 1)]),
        (["%C0: P=5 ADJ=N", "LD %I0.0", "[%C0.P := 6]"], [("CFG007", 3)]),
        (["%C0: P=5 ADJ=N", "LD %I0.0", "[INC %C0.P]"], [("CFG007", 3)]),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_said_where_it_stands_in_both_languages(
    lines: list[str], codes: list[tuple[str, int]]
) -> None:
    program = configured(*lines)
    assert [(one.code, one.span.row) for one in program.diagnostics] == codes
    for one in program.diagnostics:
        assert one.text.zh != one.text.en
        assert "{" not in one.text.zh + one.text.en
        row = lines[one.span.row - 1]
        assert 0 <= one.span.start < one.span.stop <= len(row)


def test_a_finding_stands_under_its_word_and_says_what_was_expected() -> None:
    (one,) = configured("%TM0: TYPE=TON TB=2s P=5").diagnostics
    assert "%TM0: TYPE=TON TB=2s P=5"[one.span.start : one.span.stop] == "2s"
    assert "1min, 1s, 100ms, 10ms or 1ms" in one.text.en
    assert "1min、1s、100ms、10ms或1ms" in one.text.zh
    (one,) = configured("%TM0: TIME=5").diagnostics
    assert "TYPE, TB, P, ADJ".replace(", ", "=, ") + "=" in one.text.en


def test_locked_words_are_locked_and_open_ones_are_not() -> None:
    assert said("%C0: P=5 ADJ=Y", "LD %I0.0", "[%C0.P := 6]") == []
    assert said("%C0: P=5", "LD %I0.0", "[%C0.P := 6]") == []
    assert said("%C0: P=5 ADJ=N", "LD %I0.0", "[%MW0 := %C0.P]") == []


def test_comments_beside_configuration_lines_are_kept() -> None:
    program = read("// the delay\n%TM0: P=5 // five\n%C0: P=2\n// start\nLD %I0.0 // go\nST %Q0.0\n// end", "neza")
    assert program.lines[0].above == ("the delay", "five", "start")
    assert read(write(program), "neza") == program
    alone = read("%TM0: P=5 // five", "neza")
    assert (alone.tail, read(write(alone), "neza")) == (("five",), alone)


def test_configuration_survives_in_every_form_of_file() -> None:
    program = configured("%TM0: TYPE=TP TB=1s P=3", "%DR0: OUT=%Q0.0,%Q0.1 STEPS=00,10")
    for form in ("plain", "export", "csv", "pl7"):
        again = read(write_bytes(program, form), "neza")
        assert again == program, form
        assert again.settings == program.settings


def test_a_family_whose_blocks_are_not_configured_knows_no_such_lines() -> None:
    assert [one.code for one in read("%TM0: P=5\nLD I0.0\n= Q0.0", "s7-200").diagnostics] == ["RDR001"]


SETTING = {
    "TYPE": st.sampled_from(["TON", "TOF", "TP"]),
    "TB": st.sampled_from(["1min", "1s", "100ms", "10ms", "1ms"]),
    "P": st.integers(0, 9999),
    "ADJ": st.sampled_from("YN"),
}


@settings(max_examples=60, deadline=None)
@given(st.dictionaries(st.integers(0, 31), st.fixed_dictionaries({}, optional=SETTING).filter(bool), max_size=4))
def test_any_configuration_of_timers_is_read_as_it_is_written(timers: dict[int, dict[str, object]]) -> None:
    lines = [
        f"%TM{number}: " + " ".join(f"{name}={value}" for name, value in one.items()) for number, one in timers.items()
    ]
    program = configured(*lines)
    assert not program.diagnostics
    assert program.settings == {f"%TM{number}": one for number, one in timers.items()}
    assert read(write(program), "neza").settings == program.settings


@settings(max_examples=200, deadline=None)
@given(st.text(st.sampled_from("%TMCDRKW01:=,. PTYPEOUTSB-#\t(*/")))
def test_anything_behind_a_colon_is_read_or_said(text: str) -> None:
    program = configured(f"%TM0:{text}")
    assert dialect("neza") is program.dialect
    if not program.diagnostics:
        assert read(write(program), "neza") == program
