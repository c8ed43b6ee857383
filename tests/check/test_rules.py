"""Every rule finds its sample and nothing else, says it as loudly as the family's notes want, and is silent on right programs."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.check.lint import lint
from plcteach.check.rules import PROGRAM_RULES, STACK_RULES
from plcteach.check.rules.registry import finds
from plcteach.core import text as words
from plcteach.core.diagnostic import MOST_FINDINGS, RULES
from plcteach.core.errors import DeclarationError, UnknownNameError
from plcteach.dialects import dialect, families
from plcteach.ladder.lower import lower
from plcteach.machine import run
from plcteach.stl import read
from plcteach.stl.tokens import MOST_ROWS

sys.path.insert(0, str(Path(__file__).parents[1] / "ladder"))
from random_ladders import FAMILIES, ladders

TESTS = Path(__file__).parents[1]
SAMPLES = [(family.name, sample) for family in families() for sample in family.samples]


def found(text: str, name: str) -> list[tuple[str, str, int]]:
    return [(one.severity, one.code, one.span.row) for one in lint(read(text.replace("/", "\n"), name))]


@pytest.mark.parametrize(("name", "sample"), SAMPLES, ids=lambda one: getattr(one, "code", one))
def test_the_bad_program_triggers_exactly_its_code_and_the_good_one_nothing(name: str, sample) -> None:
    bad, good = (lint(read(text.replace("; ", "\n"), name)) for text in (sample.bad, sample.good))
    assert {one.code for one in bad} == {sample.code}
    assert good == ()


@pytest.mark.parametrize("code", [code for code in RULES if code[:3] in {"STK", "COI", "RDR"}])
def test_every_rule_about_a_text_has_a_sample_or_a_test_of_its_own(code: str) -> None:
    here = {
        "RDR013": test_a_text_that_is_too_long,
        "RDR015": test_variables_that_never_end,
        "RDR016": test_more_findings_than_anyone_reads,
        "RDR017": test_a_list_of_another_family_is_recognised,
        "RDR018": test_an_interrupt_program_is_not_run_and_a_subroutine_is_no_part_of_the_main_program,
    }
    assert code in {sample.code for _, sample in SAMPLES} or code in here


def test_a_text_that_is_too_long() -> None:
    assert {one.code for one in lint(read("LD I0.0\n= Q0.0\n" + "// x\n" * (MOST_ROWS + 1), "s7-200"))} == {"RDR013"}
    assert {one.code for one in lint(read(f"LD I0.0\n= Q0.0 //{'x' * 3_000}", "s7-200"))} == {"RDR013"}


def test_variables_that_never_end() -> None:
    assert [(one.code, one.span.row) for one in lint(read("LD I0.0\n= Q0.0\nVAR\nx : BOOL\n", "s7-200"))] == [
        ("RDR015", 3)
    ]
    assert lint(read("VAR\nx : BOOL\nEND_VAR\nLD I0.0\n= Q0.0\n", "s7-200")) == ()


def test_more_findings_than_anyone_reads() -> None:
    found = lint(read("LD I0.9\n" * (MOST_FINDINGS + 50), "s7-200"))
    assert [one.code for one in found] == ["RDR006"] * MOST_FINDINGS + ["RDR016"]
    assert found[-1].span.row == MOST_FINDINGS + 1
    exactly = lint(read("LD I0.9\n" * MOST_FINDINGS, "s7-200"))
    assert {one.code for one in exactly} == {"RDR006"}


def test_an_interrupt_program_is_not_run_and_a_subroutine_is_no_part_of_the_main_program() -> None:
    block = "{0}_BLOCK {1}_0:{1}0\nBEGIN\nLD I0.1\n= Q0.1\nEND_{0}_BLOCK\n"
    interrupt = read("LD I0.0\n= Q0.0\n" + block.format("INTERRUPT", "INT"), "s7-200")
    assert [line.text for line in interrupt.lines] == ["LD I0.0", "= Q0.0"]
    assert [(one.code, one.span.row) for one in lint(interrupt)] == [("RDR018", 5)]
    subroutine = read("LD I0.0\n= Q0.0\n" + block.format("SUBROUTINE", "SBR"), "s7-200")
    assert [one.block for one in subroutine.networks] == ["", "SBR0"]
    assert "RDR018" not in {one.code for one in lint(subroutine)}


def test_a_list_of_another_family_is_recognised() -> None:
    fx = "LD X0\nOR X1\nANI X2\nOUT Y0\nEND\n"
    said = [one for one in lint(read(fx, "s7-200")) if one.code == "RDR017"]
    assert [(one.severity, one.span.row) for one in said] == [("info", 1)]
    assert "Mitsubishi FX" in said[0].text.en
    assert "三菱FX" in said[0].text.zh
    assert lint(read(fx, "fx")) == ()
    assert "RDR017" not in {one.code for one in lint(read("LD I0.9\nA I0.9\nO I0.9\n= Q0.9\n", "s7-200"))}


SAMPLED = {sample.code for _, sample in SAMPLES}


@pytest.mark.parametrize(
    "code", [code for code in RULES if code[:3] not in {"STK", "COI", "RDR"} and code not in SAMPLED]
)
def test_every_other_code_stands_in_some_other_test(code: str) -> None:
    home = {
        "CHK": "check/test_same.py",
        "CHK004": "check/test_settled.py",
        "CHK005": "check/proof/test_variants.py",
        "CHK006": "check/test_kinds.py",
        "KND": "check/test_kinds.py",
        "DRW": "ladder/test_picture.py",
        "XML": "ladder/test_plcopen.py",
        "LAD": "ladder/test_lift.py",
        "FIL": "test_contract.py",
        "HND": "check/test_marking.py",
        "BOX": "machine/test_gutta_boxes.py",
        "RUN001": "machine/test_scan.py",
        "RUN002": "machine/test_s7_course.py",
        "RUN003": "machine/test_s7_course.py",
        "RUN004": "machine/test_neza_blocks.py",
        "RUN": "machine/test_neza_blocks.py",
        "TMR": "machine/test_s7_timers.py",
        "SYM": "stl/test_symbols.py",
        "TIM": "machine/test_timeline.py",
    }
    home = home.get(code) or home[code[:3]]
    assert code in (TESTS / home).read_text(encoding="utf-8")


def test_every_stack_and_coil_rule_has_its_finder() -> None:
    wanted = {code for code in RULES if code[:3] in {"STK", "COI"}}
    assert wanted <= {*STACK_RULES, *PROGRAM_RULES} <= set(RULES)
    assert not set(STACK_RULES) & set(PROGRAM_RULES)


def test_a_finder_for_no_rule_or_for_one_that_has_its_own_is_refused() -> None:
    with pytest.raises(UnknownNameError, match="STK999"):
        finds("STK999", STACK_RULES)
    with pytest.raises(DeclarationError, match="STK001"):
        finds("STK001", PROGRAM_RULES)


# How loudly, and where.


@pytest.mark.parametrize(
    ("name", "text", "wanted"),
    [
        # residue: the S7-200's CPU does not mind
        ("s7-200", "LD I0.0/LD I0.1/= Q0.0", ("warning", "STK005", 3)),
        ("s7-200-smart", "LD I0.0/LD I0.1/= Q0.0", ("warning", "STK005", 3)),
        ("fx", "LD X0/LD X1/OUT Y0", ("error", "STK005", 3)),
        ("gutta", "LD I0.0/LD I0.1/= Q0.0", ("error", "STK005", 3)),
        ("neza", "LD %I0.0/MPS/AND %I0.1/ST %Q0.0", ("error", "STK005", 4)),
        ("gutta", "LD I0.0/LPS/A I0.1/= Q0.0", ("error", "STK005", 4)),
        # the last branch read and not popped
        ("s7-200", "LD I0.0/LPS/A I0.1/= Q0.0/LRD/A I0.2/= Q0.1", ("warning", "STK006", 7)),
        ("fx", "LD X0/MPS/AND X1/OUT Y0/MRD/AND X2/OUT Y1", ("error", "STK006", 7)),
        ("neza", "LD %I0.0/MPS/AND %I0.1/ST %Q0.0/MRD/ST %Q0.1", ("error", "STK006", 6)),
        ("gutta", "LD I0.0/LPS/A I0.1/= Q0.0/LRD/A I0.2/= Q0.1", ("error", "STK006", 7)),
        # underflow
        ("s7-200", "LD I0.0/OLD/= Q0.0", ("error", "STK001", 2)),
        ("fx", "LD X0/AND X1/ANB/OUT Y0", ("error", "STK001", 3)),
        ("gutta", "LD I0.0/LPS/ALD/= Q0.0", ("error", "STK001", 3)),
        ("s7-200", "LD I0.0/LD I0.1/LDS 2/OLD/OLD/= Q0.0", ("error", "STK001", 3)),
        ("s7-200", "LD I0.0/= Q0.0/ALD/= Q0.1", ("error", "STK001", 3)),
        # a pop without its push
        ("s7-200", "LD I0.0/A I0.1/= Q0.0/LPP/= Q0.1", ("error", "STK003", 4)),
        ("fx", "LD X0/OUT Y0/MPP/OUT Y1", ("error", "STK003", 3)),
        ("neza", "LD %I0.0/ST %Q0.0/MRD/ST %Q0.1", ("error", "STK003", 3)),
        ("gutta", "LD I0.0/= Q0.0/LRD/= Q0.1", ("error", "STK003", 3)),
        ("s7-200", "Network 1/LD I0.0/LPS/= Q0.0/Network 2/LPP/A I0.1/= Q0.1", ("error", "STK003", 6)),
        # begins with what is not its own
        ("s7-200", "A I0.0/= Q0.0", ("error", "STK009", 1)),
        ("s7-200", "NOT/= Q0.0", ("error", "STK009", 1)),
        ("neza", "ANDN %I0.0/ST %Q0.0", ("error", "STK009", 1)),
        # parentheses
        ("neza", "LD %I0.0/AND( %I0.1/MPS/)/ST %Q0.0", ("error", "STK012", 3)),
        ("neza", "LD %I0.0/AND( %I0.1/S %Q0.0/)/ST %Q0.1", ("error", "STK012", 3)),
        ("neza", "LD %I0.0/OR( %I0.1/ST %Q0.0", ("error", "RDR011", 2)),
        # one line too many
        ("s7-200", "LD I0.0/LDN I0.1/OLD/= Q0.0", ("info", "STK007", 2)),
        ("s7-200", "LD I0.0/LDI I0.1/ALD/= Q0.0", ("info", "STK008", 2)),
        ("fx", "LD X0/LDF X1/ANB/OUT Y0", ("info", "STK008", 2)),
        # coils
        ("s7-200", "LD I0.0/= Q0.0/LD I0.1/= Q0.0", ("warning", "COI001", 4)),
        ("fx", "LD X0/OUT M0/LD X1/PLS M0", ("warning", "COI001", 4)),
        ("s7-200", "LD I0.0/= I0.1", ("warning", "RDR012", 2)),
        ("s7-200", "LD I0.0/R I0.1, 2", ("warning", "RDR012", 2)),
    ],
)  # fmt: skip
def test_each_is_said_where_it_happens_and_as_the_family_minds_it(
    name: str, text: str, wanted: tuple[str, str, int]
) -> None:
    assert wanted in found(text, name)


# A timer that resets itself: what reaches its input counts, not how the list spells it.


def on(text: str, name: str, place: str, rows: list[dict[str, int]]) -> str:
    """What a bit is in each scan, on the plain machine."""
    return str(run(read(text.replace("/", "\n"), name), rows)[place])


STARTED = [{"I0.0": 1, "ms": 10}] * 40
LAMP = "/Network 9/LD {0}/= Q0.0"


@pytest.mark.parametrize("name", ["s7-200", "s7-200-smart", "gutta"])
@pytest.mark.parametrize("timer", ["T33", "T32"])
@pytest.mark.parametrize(
    "text",
    [
        "LDN {0}/TON {0}, 3",
        "LD {0}/NOT/TON {0}, 3",
        "LDN {0}/= Q0.1/TON {0}, 3",
        "LD I0.0/AN {0}/LPS/A I0.1/= Q0.1/LPP/TON {0}, 3",
        "LD I0.0/LPS/AN {0}/TON {0}, 3/LPP/= Q0.1",
        "Network 1/LDN {0}/= M0.0/Network 2/LD M0.0/TON {0}, 3",
        "Network 1/LDN {0}/= M0.0/Network 2/LDN M0.0/NOT/A I0.0/TON {0}, 3",
    ],
)
def test_a_timer_that_resets_itself_before_its_instruction_is_found_however_it_is_spelled(
    name: str, timer: str, text: str
) -> None:
    head = text if text.startswith("Network") else f"Network 1/{text}"
    program = (head + LAMP).format(timer)
    if timer == "T33":
        assert on(program, name, "Q0.0", STARTED) == "0" * 40
    assert [code for _, code, _ in found(program, name)] == ["TMR003"]
    assert [code for _, code, _ in found(head.format(timer), name)] == ["TMR003"]


@pytest.mark.parametrize(
    "text",
    [
        "LDN %TM0.Q/IN %TM0/LD %TM0.Q/ST %Q0.0",
        "LD %TM0.Q/N/ST %M0/LD %M0/IN %TM0/LD %TM0.Q/ST %Q0.0",
        "BLK %TM0/LDN %TM0.Q/IN/OUT_BLK/LD Q/ST %Q0.0/END_BLK",
    ],
)
def test_so_it_is_where_every_timer_is_brought_up_to_date_at_the_start_of_the_scan(text: str) -> None:
    program = f"%TM0: TYPE=TON TB=10ms P=3/{text}"
    assert on(program, "neza", "%Q0.0", [{"ms": 10}] * 40) == "0" * 40
    assert [code for _, code, _ in found(program, "neza")] == ["TMR003"]
    assert found(program.replace("TYPE=TON", "TYPE=TP"), "neza") == []


@pytest.mark.parametrize(
    ("name", "text", "place", "wanted"),
    [
        # a 100 ms timer is brought up to date at its own line
        ("s7-200", "Network 1/LDN T37/= M0.0/Network 2/LD M0.0/TON T37, 1/Network 3/LD T37/= Q0.0", "Q0.0", 3),
        ("fx", "LDI T0/OUT T0 K1/LD T0/OUT Y0", "Y0", 3),
        # a bit of memory of the scan before, and one that takes the timer's bit above it
        ("s7-200", "LDN M0.0/TON T33, 3/LD T33/= M0.0/= Q0.0", "Q0.0", 8),
        ("s7-200", "Network 1/LD M0.0/TON T33, 3/Network 2/LDN T33/= M0.0/Network 3/LD T33/= Q0.0", "Q0.0", 8),
        ("s7-200", "LD T33/= M0.0/= Q0.0/LDN M0.0/TON T33, 3", "Q0.0", 10),
        ("s7-200", "LD T33/= Q0.0/LDN T33/TON T33, 3", "Q0.0", 10),
        ("neza", "%TM0: TYPE=TON TB=10ms P=3/LD %TM0.Q/ST %Q0.0/LDN %TM0.Q/IN %TM0", "%Q0.0", 10),
    ],
)  # fmt: skip
def test_a_timer_that_others_see_may_reset_itself(name: str, text: str, place: str, wanted: int) -> None:
    """It pulses: every 4 scans where it stops in the scan that sees it, every 5 where it stops in the next."""
    assert on(text, name, place, [{"ms": 10}] * 40).count("1") == wanted
    assert found(text, name) == []


def test_a_bit_that_holds_itself_remembers_what_the_timer_said() -> None:
    """A pulse of 30 ms: the timer switches off the bit that keeps it running, and nobody needs to see it."""
    for text in ("LD I0.0/O Q0.0/AN T33/= Q0.0/TON T33, 3", "LD I0.0/O Q0.0/AN T33/TON T33, 3/= Q0.0"):
        assert on(text, "s7-200", "Q0.0", [{"I0.0": int(scan == 1), "ms": 10} for scan in range(10)]) == "0111000000"
        assert found(text, "s7-200") == []
        waits = f"{text}/LD T33/S Q0.1, 1"
        assert "1" not in on(waits, "s7-200", "Q0.1", [{"I0.0": int(scan == 1), "ms": 10} for scan in range(10)])
        assert [code for _, code, _ in found(waits, "s7-200")] == ["TMR003"]


# Driven twice.


@pytest.mark.parametrize(
    ("name", "text", "start", "lamp"),
    [
        ("s7-200", "LD I0.0/= Q0.0/LD Q0.0/= Q0.1/LD I0.1/= Q0.0", "I0.0", "Q0.0"),
        ("gutta", "LD I0.0/= Q0.0/LD Q0.0/= Q0.1/LD I0.1/= Q0.0", "I0.0", "Q0.0"),
        ("fx", "LD X0/OUT Y0/AND Y0/OUT Y1/LD X1/OUT Y0", "X0", "Y0"),
        ("neza", "LD %I0.0/ST %Q0.0/LD %Q0.0/ST %Q0.1/LD %I0.1/ST %Q0.0", "%I0.0", "%Q0.0"),
        ("s7-200", "Network 1/LD I0.0/= Q0.0/Network 2/LD I0.1/=I Q0.0", "I0.0", "Q0.0"),
        ("s7-200", "Network 1/LD I0.0/=I Q0.0/Network 2/LD I0.1/= Q0.0", "I0.0", "Q0.0"),
    ],
)
def test_a_second_coil_is_a_bistable_only_where_its_own_condition_reads_the_bit(
    name: str, text: str, start: str, lamp: str
) -> None:
    assert on(text, name, lamp, [{start: 1}] * 3) == "000"
    assert [code for _, code, _ in found(text, name)] == ["COI001"]


def test_a_coil_read_before_the_first_is_no_bistable_and_one_read_after_it_is() -> None:
    assert "COI001" in {code for _, code, _ in found("LD Q0.0/LPS/A I0.0/= Q0.0/LPP/A I0.1/= Q0.0", "s7-200")}
    latch = "LD I0.0/= Q0.0/LD Q0.0/A I0.2/O I0.1/= Q0.0"
    assert on(latch, "s7-200", "Q0.0", [{"I0.0": 1, "I0.2": 1}] * 3) == "111"
    assert found(latch, "s7-200") == []


@pytest.mark.parametrize(
    ("name", "text", "start", "lamp"),
    [
        ("fx", "LD X0/OUT T0 K1/LD X1/OUT T0 K2/LD T0/OUT Y0", "X0", "Y0"),
        ("fx", "LD X0/MC N0 M100/LD X0/OUT T0 K1/MCR N0/LD X1/MC N0 M101/OUT T0 K2/MCR N0/LD T0/OUT Y0", "X0", "Y0"),
        ("s7-200", "LD I0.0/TON T37, 1/LD I0.1/TON T37, 2/LD T37/= Q0.0", "I0.0", "Q0.0"),
        ("gutta", "LD I0.0/TON T37, 1/LD I0.1/TON T37, 2/LD T37/= Q0.0", "I0.0", "Q0.0"),
        ("neza", "%TM0: TB=10ms P=3/LD %I0.0/IN %TM0/LD %I0.1/IN %TM0/LD %TM0.Q/ST %Q0.0", "%I0.0", "%Q0.0"),
        (
            "s7-200",
            "LD SM0.1/S S0.0, 1/LSCR S0.0/LD I0.0/TON T37, 1/SCRE/LSCR S0.1/LD I0.0/TON T37, 1/SCRE/LD T37/= Q0.0",
            "I0.0",
            "Q0.0",
        ),
    ],
)
def test_a_timer_driven_twice_never_comes_on_and_is_found(name: str, text: str, start: str, lamp: str) -> None:
    assert "1" not in on(text, name, lamp, [{start: 1, "ms": 100}] * 20)
    assert "COI010" in {code for _, code, _ in found(text, name)}


@pytest.mark.parametrize(
    ("name", "text", "row"),
    [
        ("fx", "LD X0/OUT C0 K10/LD X1/OUT C0 K20/LD C0/OUT Y0", 4),
        ("s7-200", "LD I0.0/LD I0.2/CTU C0, 5/Network 2/LD I0.1/LD I0.2/CTU C0, 5", 7),
        ("s7-200", "LD I0.0/LD I0.2/CTU C0, 5/Network 2/LD I0.1/LD I0.2/CTD C0, 5", 7),
        ("gutta", "LD I0.0/LD I0.2/CTU C0, 5/Network 2/LD I0.1/LD I0.2/CTU C0, 5", 7),
        ("neza", "%C0: P=3/LD %I0.0/CU %C0/LD %I0.1/CU %C0/LD %C0.D/ST %Q0.0", 5),
    ],
)
def test_a_counter_driven_twice_is_found(name: str, text: str, row: int) -> None:
    assert [(code, at) for _, code, at in found(text, name)] == [("COI010", row)]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        # two steps
        ("fx", "STL S20/OUT T0 K10/LD T0/SET S21/STL S21/LD X1/OUT T0 K5/RET/END"),
        # jumped over by turns, in both usual forms
        ("s7-200", "LD I0.0/JMP 1/Network 2/LD I0.1/= Q0.0/Network 3/LBL 1/Network 4/LDN I0.0/JMP 2/Network 5/LD I0.2/= Q0.0/Network 6/LBL 2"),
        ("s7-200", "LD I0.0/JMP 1/Network 2/LD I0.1/= Q0.0/Network 3/LD SM0.0/JMP 2/Network 4/LBL 1/Network 5/LD I0.2/= Q0.0/Network 6/LBL 2"),
        ("neza", "LD %I0.0/JMPC %L1/LD %I0.1/IN %TM0/JMP %L2/%L1:/LD %I0.2/IN %TM0/%L2:/LD %TM0.Q/ST %Q0.2"),
        # two subroutines
        ("neza", "LD %I0.0/SR1/LDN %I0.0/SR2/END/SR1:/LD %I0.1/ST %Q0.0/RET/SR2:/LD %I0.2/ST %Q0.0/RET"),
        # one pin of a counter each, and a reset from two places
        ("neza", "%C0: P=3/LD %I0.0/CU %C0/LD %I0.1/CD %C0/LD %I0.2/R %C0/LD %I0.3/R %C0/LD %C0.D/ST %Q0.0"),
    ],
)  # fmt: skip
def test_alternatives_may_drive_the_same_bit_or_block(name: str, text: str) -> None:
    assert not {"COI001", "COI010"} & {code for _, code, _ in found(text, name)}


def test_what_one_jump_passes_over_together_is_no_alternative() -> None:
    both = "LD I0.0/JMP 1/Network 2/LD I0.1/= Q0.0/Network 3/LD I0.2/= Q0.0/Network 4/LBL 1"
    assert [(code, row) for _, code, row in found(both, "s7-200")] == [("COI001", 8)]
    one = "LD I0.1/= Q0.0/Network 2/LD I0.0/JMP 1/Network 3/LD I0.2/= Q0.0/Network 4/LBL 1"
    assert [(code, row) for _, code, row in found(one, "s7-200")] == [("COI001", 8)]


NINE = "/".join(f"LD I0.{number}/A I1.{number}" for number in range(8)) + "/LD I2.0/A I2.1"


@pytest.mark.parametrize(
    ("name", "text"),
    [
        # nine pending blocks fit into nine levels, and eight branch points
        ("s7-200", f"{NINE}{'/OLD' * 8}/= Q0.0"),
        ("s7-200", "LD I0.0" + "/LPS/A I1.0" * 8 + "/= Q0.0" + "".join(f"/LPP/= Q1.{bit}" for bit in range(8))),
        ("s7-200", "LD I0.0/LPS/NOT/= Q0.0/LPP/= Q0.1"),
        ("s7-200", "LD I0.0/A I0.1/= Q0.0/A I0.2/= Q0.1"),
        # SR and RS as the ladder's boxes are written out: exempt from the rule about two coils
        ("s7-200", "LD I0.0/LD I0.1/NOT/A Q0.0/OLD/= Q0.0"),
        ("s7-200", "LD I0.0/LD I0.1/NOT/LPS/A Q0.0/= Q0.0/LPP/ALD/O Q0.0/= Q0.0"),
        ("s7-200", "LD I0.0/S Q0.0, 1/LD I0.1/R Q0.0, 1"),
        ("fx", "LD X0/MPS/MPS/AND X1/OUT Y0/MPP/AND X2/OUT Y1/MPP/AND X3/OUT Y2"),
        ("fx", "LD X0/AND X1/INV/OUT Y0/AND X2/OUT Y1"),
        ("fx", "LD X0" + "/MPS/AND X1" * 11 + "/OUT Y0" + "".join(f"/MPP/OUT Y{number:o}" for number in range(1, 12))),
        ("neza", "LD %I0.0/AND( %I0.1/OR( %I0.2/AND %I0.3/)/)/ST %Q0.0/STN %Q0.1"),
        ("neza", "LD %I0.0/MPS/AND %I0.1/ST %Q0.0/MRD/AND %I0.2/ST %Q0.1/MPP/ST %Q0.2"),
        ("gutta", "LD I0.0/LPS/NOT/LD SM0.0/LPP/A I0.1/OLD/= Q0.0"),
        ("gutta", "LD I0.0/P M0.0/= Q0.0/LD I0.1/N M0.1/= Q0.1"),
    ],
)  # fmt: skip
def test_right_programs_are_left_in_peace(name: str, text: str) -> None:
    assert found(text, name) == []


def test_the_nop_of_a_branch_written_with_lds_is_no_error() -> None:
    """common.md: it rightly leaves a cell, so a warning is the most that may be said."""
    assert {severity for severity, _, _ in found("LD I0.0/LPS/NOT/LDS 1/A I0.1/OLD/= Q0.0", "s7-200")} <= {"warning"}


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("s7-200", f"{NINE}/LD I2.2/A I2.3{'/OLD' * 9}/= Q0.0"),
        (
            "s7-200",
            "LD I0.0"
            + "/LPS/A I1.0" * 9
            + "/= Q0.0"
            + "".join(f"/LPP/= Q{bit // 8 + 1}.{bit % 8}" for bit in range(9)),
        ),
    ],
    ids=["ten blocks", "nine branch points"],
)
def test_one_more_than_the_s7_200_holds_loses_a_value(name: str, text: str) -> None:
    assert [code for _, code, _ in found(text, name)] == ["STK002"]
    assert "all 9 levels" in lint(read(text.replace("/", "\n"), name))[0].text.en
    assert found(text, "s7-200-smart") == []


def test_twelve_branch_points_are_one_too_many_for_the_fx() -> None:
    text = "LD X0" + "/MPS/AND X1" * 12 + "/OUT Y0" + "".join(f"/MPP/OUT Y{number:o}" for number in range(1, 13))
    codes = found(text, "fx")
    assert [row for _, _, row in codes] == [24]
    assert {code for _, code, _ in codes} <= {"STK002", "STK011"}


def test_parentheses_and_branches_have_their_own_depth_in_neza() -> None:
    deep = "LD %I0.0" + "/AND( %I0.1/OR %I0.2" * 8 + "/)" * 8 + "/ST %Q0.0"
    assert found(deep, "neza") == []
    assert [
        severity
        for severity, _, _ in found(deep.replace("/ST", "/)/ST").replace("LD %I0.0", "LD %I0.0/OR( %I0.2"), "neza")
    ] == ["error"]


# What is reported together, and what is not.


def test_after_the_first_error_of_a_network_the_rest_is_guesswork() -> None:
    assert found("LD I0.0/OLD/OLD/LPP/= Q0.0", "s7-200") == [("error", "STK001", 2)]


def test_each_network_is_judged_for_itself() -> None:
    text = "Network 1/LD I0.0/OLD/= Q0.0/Network 2/LD I0.1/= Q0.1/Network 3/LD I0.2/LD I0.3/= Q0.2"
    assert found(text, "s7-200") == [("error", "STK001", 3), ("warning", "STK005", 11)]


def test_a_network_with_an_unreadable_line_is_not_judged_by_its_stack() -> None:
    text = "Network 1/LD I0.0/OLDD/OLD/= Q0.0/Network 2/LD I0.1/OLD/= Q0.1"
    assert found(text, "s7-200") == [("error", "RDR001", 3), ("error", "STK001", 8)]


def test_a_note_shows_the_further_place_and_a_fix_says_what_to_do() -> None:
    (one,) = lint(read("LD X0\nMPS\nOUT Y0\nMRD\nOUT Y1", "fx"))
    assert (one.code, one.notes[0].span.row) == ("STK006", 4)
    assert one.fix.en == "Make row 4 a MPP."
    assert "第4行" in one.fix.zh
    (join,) = lint(read("LD X0\nLD X1\nORB\nOUT Y0", "fx"))
    assert [note.span.row for note in join.notes] == [3]
    assert "OR X1" in join.text.en


def test_findings_show_themselves_and_nothing_found_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    for lang, nothing in (("en", "Nothing to remark."), ("zh", "没有发现问题。")):
        monkeypatch.setattr(words, "_chosen", [lang])
        assert repr(lint("LD I0.0\n= Q0.0")) == nothing
        assert nothing in lint("LD I0.0\n= Q0.0")._repr_html_()
        bad = lint("LD I0.0\n<b>LPSS</b>\n= Q0.0")
        assert len(repr(bad).split("\n")) == len(bad) > 0
        assert bad[0].text.in_(lang) in repr(bad)
        assert "<b>" not in bad._repr_html_()
        assert bad[0].code in bad._repr_html_()


def test_the_words_of_underflow_count() -> None:
    (one,) = lint(read("LD I0.0\nA I0.1\nALD\n= Q0.0", "s7-200"))
    assert "ALD needs 2 values" in one.text.en
    assert "only 1 on the stack" in one.text.en
    assert "LD" in one.text.zh


# Silence on what is right: ladders of every kind, written out.


@pytest.mark.parametrize("name", FAMILIES)
@settings(max_examples=80, deadline=None)
@given(data=st.data())
def test_a_ladder_written_out_has_nothing_wrong_with_its_stack(name: str, data: st.DataObject) -> None:
    text = lower(data.draw(ladders(name)), name)
    assert [one for one in lint(read(text, name)) if one.code != "COI001"] == []


def test_every_mnemonic_of_a_role_is_what_the_rules_speak_of() -> None:
    assert dialect("fx").roles["push"] == "MPS"
    assert "MPS" in lint(read("LD X0\nOUT Y0\nMPP\nOUT Y1", "fx"))[0].text.en
    assert "LPS" in lint(read("LD I0.0\n= Q0.0\nLPP\n= Q0.1", "gutta"))[0].text.zh
