"""What is said of timers, counters, words, comparisons and the program's course: by hand what a good teacher would say of each."""

from __future__ import annotations

from dataclasses import replace

import pytest

from plcteach.dialects import dialect
from plcteach.figure.card import Card
from plcteach.figure.says import describes, says
from plcteach.figure.works import bits_of
from plcteach.machine import run
from plcteach.machine.words import Number
from plcteach.stl import read

S7, FX, NEZA, GUTTA = "s7-200", "fx", "neza", "gutta"


def card(family: str, mnemonic: str):
    found = dialect(family)
    return describes(found, found.insn(mnemonic))


def sentences(family: str, text: str, rows, *, scan_ms: int = 100):
    """Give what is said of the last line, scan by scan."""
    program = read(text.replace("; ", "\n"), family)
    assert program.runs, program.diagnostics
    trace = run(program, rows, scan_ms=scan_ms)
    return [says(program.dialect, scan.steps[-1], first=scan.number == 0) for scan in trace.scans]


def test_an_on_delay_says_when_it_counts_and_from_when_it_is_on():
    text = card(S7, "TON")
    assert "while IN (the top) is 1, T37 counts time in steps of 100 ms; from 10 steps (1 s) on T37 is 1" in text.en
    assert "when IN is 0, the time is back at 0" in text.en
    assert "IN（栈顶）为1时，T37以100 ms为单位计时；计到10（1 s）起T37为1" in text.zh
    assert "up to 32767" in text.en
    assert "the time stops there" in card(FX, "OUT T").en


def test_the_other_timers_are_told_by_their_own_rules():
    assert "T5 keeps its time and its bit" in card(S7, "TONR").en
    assert "after IN has fallen, T38 counts" in card(GUTTA, "TOF").en
    pulse = card(NEZA, "IN %TM").en
    assert [word for word in ("TYPE=TON", "TYPE=TOF", "TYPE=TP") if word not in pulse] == []


def test_a_timers_step_tells_its_time_against_its_preset():
    told = sentences(S7, "LD I0.0; TON T37, 2", [{"I0.0": 1}] * 3 + [{"I0.0": 0}])
    assert "T37 is counting: 100 ms (1) of 200 ms (2); T37 is 0" in told[1].en
    assert "T37 has reached its time: 200 ms (2) of 200 ms (2); T37 is 1" in told[2].en
    assert "IN (the top) is 0; T37 is not counting" in told[3].en
    assert "T37正在计时，已计100 ms（1），设定200 ms（2）；T37为0" in told[1].zh


def test_a_counters_pins_are_told_by_their_levels():
    text = card(S7, "CTUD").en
    for pin in ("CU (level 3)", "CD (level 2)", "R (the top)"):
        assert pin in text
    told = sentences(S7, "LD I0.0; LD I0.1; CTU C0, 2", [{"I0.0": 0}, {"I0.0": 1}, {"I0.0": 0}, {"I0.0": 1}])
    assert "CU (level 2) is 1, R (the top) is 0; C0 stands at 2 of 2; C0 is 1" in told[3].en


@pytest.mark.parametrize(
    ("line", "en"),
    [
        ("+I 3, VW2", "VW2 := 300 + 3 = 303"),
        ("-I 301, VW2", "VW2 := 300 - 301 = -1, SM1.2 is 1 (the result is negative)"),
        ("*I 200, VW2", "300 × 200 is wanted; the result does not fit, so VW2 keeps 300, SM1.1 is 1 (overflow)"),
        ("/I 7, VW2", "VW2 := 300 ÷ 7 = 42"),
        ("/I VW8, VW2", "300 ÷ 0 is wanted; nothing can be divided by 0, so VW2 keeps 300, SM1.3 is 1"),
        ("MOVW VW2, VW4", "VW4 := 300"),
        ("ANDW 16#FF, VW2", "VW2 := 0000 0001 0010 1100 AND 0000 0000 1111 1111 = 0000 0000 0010 1100 (44)"),
        ("SLW VW2, 2", "shifted left by 2 = 0000 0100 1011 0000 (1200)"),
        ("ITD VW2, VD10", "VD10 := 300"),
        ("LDW>= VW2, 301", "VW2 ≥ 301 is false (VW2 is 300), so 0 is pushed onto the top"),
    ],
)
def test_words_are_worked_out_before_the_learners_eyes(line, en):
    assert en in sentences(S7, f"LD SM0.0; MOVW 300, VW2; {line}", 1)[0].en


def test_without_power_a_word_keeps_its_value():
    told = sentences(S7, "LD SM0.0; MOVW 300, VW2; LD I0.0; +I 3, VW2", [{"I0.0": 0}])[0]
    assert "the top is 0, so VW2 keeps 300" in told.en
    assert "栈顶为0，VW2保持300" in told.zh


def test_reals_are_told_as_reals_and_a_quotient_with_its_remainder():
    assert "VD0 := 1.5 + 2.25 = 3.75" in sentences(S7, "LD SM0.0; MOVR 1.5, VD0; +R 2.25, VD0", 1)[0].en
    assert "VD0 := 7 ÷ 3 = 2, remainder 1" in sentences(S7, "LD SM0.0; MOVD 7, VD0; DIV 3, VD0", 1)[0].en
    assert "the quotient in D10, the remainder in D11" in card(FX, "DIV").en


def test_a_comparison_shows_the_words_that_were_read_with_it():
    program = read("LDW>= VW0, 10", S7)
    step = run(program, 1).scans[0].steps[0]
    compare = program.lines[0].args[0]
    shown = says(program.dialect, replace(step, read=(*step.read, (compare.left, Number(12)))), first=True)
    assert "VW0 ≥ 10 is false (VW0 is 12)" in shown.en  # the bit is the step's, the word is what was handed in


def test_three_bits_of_a_comparison():
    assert "M0, M1, M2 say whether D0 > K5, D0 = K5, D0 < K5" in card(FX, "CMP").en
    assert "D0 < K5, K5 ≤ D0 ≤ K9, D0 > K9" in card(FX, "ZCP").en
    told = sentences(FX, "LD M8000; MOV K7 D0; CMP D0 K5 M0", 1)[0]
    assert "D0 = 7 and D0 > K5, so M0 = 1, M1 = 0, M2 = 0" in told.en


def test_pulse_forms_act_only_where_the_result_rises():
    assert "only in the scan in which the result register rises, D0 := D0 + 1" in card(FX, "INCP").en
    told = sentences(FX, "LD X0; INCP D0", [{"X0": 0}, {"X0": 1}, {"X0": 1}])
    assert "the result register (1) has risen since the last scan, so D0 := 0 + 1 = 1" in told[1].en
    assert "only its rising edge counts; D0 is 1 now" in told[2].en


def test_shifts_say_what_enters_and_what_falls_out():
    assert "V100.0 to V100.3 move 1 place up: I0.1 enters at V100.0" in card(S7, "SHRB").en
    assert "what stood in V100.3 falls out into SM1.1" in card(S7, "SHRB").en
    assert "M0到M7向低位移1位：X1进入M7，M0原来的值移出" in card(FX, "SFTR").zh
    told = sentences(FX, "LD X0; SFTL X1 M0 K4 K1", [{"X0": 1, "X1": 1}])[0]
    assert "X1 (1) enters at M0" in told.en
    assert "M0 to M3 are 1 0 0 0 now" in told.en


def test_resets_name_their_range_and_the_value_that_goes_too():
    assert "M0 to M7 are reset to 0" in card(FX, "ZRST").en
    assert "A timer or counter loses its current value too" in card(FX, "RST").en
    told = sentences(FX, "LD X0; OUT C0 K5; RST C0", [{"X0": 1}])[0]
    assert "C0 is reset to 0, and the current value becomes 0 too" in told.en


def test_a_jump_on_0_is_told_by_what_it_does():
    program = "LD %I0.0; JMPCN %L1; LD %I0.1; ST %Q0.0; %L1:; LD %I0.2; ST %Q0.1"
    done = read(program.replace("; ", "\n"), NEZA)
    for value, words in ((0, "goes on at label %L1"), (1, "there is no jump")):
        step = run(done, [{"%I0.0": value}]).scans[0].steps[1]
        assert words in says(done.dialect, step).en
    assert "if the accumulator is 0, the program goes on at label %L1" in card(NEZA, "JMPCN").en
    assert card(NEZA, "JMP").en == "JMP %L2: the program goes on at label %L2, and the lines between are passed over."


def test_an_accumulator_has_no_levels_below_it():
    assert "the subroutine begins with the accumulator 1" in card(NEZA, "SR").en
    assert "0 below" not in card(NEZA, "SR").en
    assert "with 1 on top and 0 below" in card(S7, "CALL").en


def test_labels_have_one_colon():
    assert card(NEZA, "%L:").en.startswith("%L1: a jump")
    assert "::" not in card(NEZA, "%L:").en
    assert "：：" not in card(NEZA, "SR:").zh


def test_a_relay_is_called_a_relay():
    text = card(FX, "STL")
    assert "relay S0 goes into the result register" in text.en
    assert "继电器S0送入运算结果寄存器" in text.zh


def test_a_block_names_its_pins_and_acts_once():
    assert "pin IN" in card(NEZA, "BLK").en
    found = dialect(NEZA)
    facts = Card(found, found.insn("BLK")).text("en")
    assert "%C: R, S, CU, CD → E, D, F" in facts
    program = read("BLK %TM0\nLD %I0.0\nIN\nOUT_BLK\nLD Q\nST %Q0.0\nEND_BLK", NEZA)
    steps = run(program, [{"%I0.0": 1}]).scans[0].steps
    assert "acts when its inputs are complete" in says(program.dialect, steps[2]).en
    assert "%TM0 acts once" in says(program.dialect, steps[3]).en
    assert says(program.dialect, steps[6]).en == "END_BLK: the block's section ends here."


@pytest.mark.parametrize(
    ("line", "en"),
    [
        ("CU %C0", "%C0 stands at 1"),
        ("CU %SC0", "%SC0 stands at step 1, and %SC0.1 is 1"),
        ("I %R0", "%R0 holds 1 word;"),
        ("U %DR0", "%DR0 stands at step 1; %DR0.F is 0, %Q0.0 is 1, %Q0.1 is 0"),
    ],
)
def test_what_the_blocks_have_come_to(line, en):
    settings = "%DR0: OUT=%Q0.0,%Q0.1 STEPS=00,10,01; " if "%DR" in line else ""
    assert en in sentences(NEZA, f"{settings}LD %I0.0; {line}", [{"%I0.0": 0}, {"%I0.0": 1}])[1].en


def test_a_card_says_which_numbers_count_in_which_steps():
    found = dialect(S7)
    assert "1 ms: T32, T96; 10 ms: T33–T36" in Card(found, found.insn("TON")).text("en")
    assert "1 ms: T0, T64" in Card(found, found.insn("TONR")).text("en")
    fx = dialect(FX)
    assert "100 ms（保持型）：T250–T255" in Card(fx, fx.insn("OUT T")).text("zh")
    assert "C200–C234 count 32 bits" in Card(fx, fx.insn("OUT C")).text("en")


@pytest.mark.parametrize("mnemonic", ["TON", "CTU", "MOVW", "LDW>=", "LSCR", "JMP"])
def test_what_a_ladder_cannot_draw_yet_has_no_symbol(mnemonic):
    found = dialect(S7)
    assert Card(found, found.insn(mnemonic)).symbol() is None


@pytest.mark.parametrize(
    ("family", "mnemonic", "form"),
    [
        (NEZA, "[", "[ do ]"), (NEZA, "%L:", "%Ln:"), (NEZA, "SR", "SRn"), (NEZA, "END_BLK", "END_BLK"),
        (FX, "OUT T", "OUT T SV"), (S7, "LDW=", "LDW= cmp1, cmp2"), (S7, "CALL", "CALL SBRn"),
    ],
)  # fmt: skip
def test_the_form_is_what_a_list_would_say(family, mnemonic, form):
    found = dialect(family)
    assert Card(found, found.insn(mnemonic)).form == form


@pytest.mark.parametrize(
    ("value", "size", "said"), [(10, 8, "0000 1010"), (-1, 16, " ".join(["1111"] * 4)), (255, 32, "16#000000FF")]
)
def test_bits_stand_in_groups_of_four(value, size, said):
    from plcteach.core.effect import flow
    from plcteach.figure.told import Told

    line = read("NOP 0", S7).lines[0]
    told = Told(dialect(S7), line, flow(line.effect, dialect(S7).shapes, (9,)))
    assert bits_of(told, value, size) == said
