"""NEZA's rules one by one: each row says a sentence of the notes and shows it in scans; then what is refused, and with which code."""

from __future__ import annotations

import pytest

from .rules import Rule, check, said

AB = "%I0.0 0011; %I0.1 0101"
COUNTER = "%C0: P=3 / BLK %C0 / LD %I0.0 / R / LD %I0.1 / S / LD %I0.2 / CU / LD %I0.3 / CD / END_BLK"
DRUM = "%DR0: OUT=%Q0.0,%Q0.1 STEPS=00,10,01 / BLK %DR0 / LD %I0.0 / R / LD %I0.1 / U / END_BLK"
SHIFT = (
    "LD %I0.3 / S %SBR0.1 / LD %I0.4 / S %SBR0.15 / BLK %SBR0 / LD %I0.0 / R / LD %I0.1 / CU / LD %I0.2 / CD / END_BLK"
)
STEPS = "BLK %SC0 / LD %I0.0 / R / LD %I0.1 / CU / LD %I0.2 / CD / END_BLK"
QUEUE = "LD 1 / [%R0.I := %MW0] / BLK %R0 / LD %I0.0 / R / LD %I0.1 / I / LD %I0.2 / O / END_BLK"
PULSES = "01" * 17
WORDS = ",".join(f".,{number}" for number in range(20, 37))


def timer(kind: str, preset: int, more: str = "") -> str:
    """A timer on %I0.0."""
    return f"%TM0: TYPE={kind} TB=10ms P={preset}{more} / BLK %TM0 / LD %I0.0 / IN / END_BLK"


ACCUMULATOR = [
    *(
        Rule(f"{word} combines with the accumulator", f"LD %I0.0 / {word} %I0.1 / ST %Q0.0", AB, f"%Q0.0 {bits}")
        for word, bits in (("AND", "0001"), ("ANDN", "0010"), ("OR", "0111"), ("ORN", "1011"), ("XOR", "0110"), ("XORN", "1001"))
    ),
    *(
        Rule(f"LD and LDN read {place}", f"LD {place} / ST %Q1.0 / LDN {place} / ST %Q1.1", f"{place} 10", "%Q1.0 10; %Q1.1 01")
        for place in ("%I0.3", "%Q0.5", "%M255", "%S60", "%SBR7.15", "%MW5:X15")
    ),
    Rule("0 and 1 are operands", "LD 1 / ST %Q0.0 / LD 0 / ST %Q0.1 / LDN 0 / ST %Q0.2", "%I0.0 0", "%Q0.0 1; %Q0.1 0; %Q0.2 1"),
    Rule("a comparison is an operand, with its sign", "LD %I0.0 / AND [%MW0 < -1] / OR [%MW0 = 7] / ST %Q0.0", "%I0.0 1100; %MW0=-2,0,7,-2", "%Q0.0 1010"),
    Rule("the accumulator begins unknown", "N / ST %Q0.0", "%I0.0 0", "%Q0.0 x", says=("RUN001",)),
    Rule("N turns the accumulator", "LD %I0.0 / AND %I0.1 / N / ST %Q0.0", AB, "%Q0.0 1110"),
    Rule("STN stores the inverse and keeps the accumulator", "LD %I0.0 / STN %Q0.0 / ST %Q0.1", AB, "%Q0.0 1100; %Q0.1 0011"),
    Rule("S and R act where the accumulator is 1", "LD %I0.0 / S %M0 / LD %I0.1 / R %M0", "%I0.0 010010; %I0.1 000110", "%M0 011000"),
    Rule("AND( saves the accumulator and ) joins it by and", "LD %I0.0 / AND( %I0.1 / ORN %I0.2 / ) / ST %Q0.0", AB + "; %I0.2 1010", "%Q0.0 0001"),
    Rule("OR(N begins with the inverse", "LD %I0.0 / OR(N %I0.1 / AND %I0.2 / ) / ST %Q0.0", AB + "; %I0.2 1010", "%Q0.0 1011"),
    Rule("AND(R begins with an edge", "LD %I0.0 / AND(R %I0.1 / ) / ST %Q0.0", "%I0.0 1111; %I0.1 1011", "%Q0.0 0010"),
    Rule("parentheses nest", "LD %I0.0 / OR( %I0.1 / AND( %I0.2 / OR %I0.3 / ) / ) / ST %Q0.0", AB + "; %I0.2 0000; %I0.3 1110", "%Q0.0 0111"),
    Rule("MPS, MRD and MPP give each branch the same point", "LD %I0.0 / MPS / AND %I0.1 / ST %Q0.0 / MRD / ANDN %I0.1 / ST %Q0.1 / MPP / ST %Q0.2", AB, "%Q0.0 0001; %Q0.1 0010; %Q0.2 0011"),
    Rule("an edge compares two scan starts and needs a scan before", "LDR %I0.0 / ST %Q0.0 / LDF %I0.0 / ST %Q0.1", "%I0.0 110010", "%Q0.0 000010; %Q0.1 001001"),
    Rule("the edge of an %M that the program writes comes one scan later, above its coil and below", "LDR %M0 / ST %Q0.0 / LD %I0.0 / ST %M0 / LDR %M0 / ST %Q0.1", "%I0.0 01100", "%Q0.0 00100; %Q0.1 00100"),
    Rule("XORF and ORR join an edge", "LD %I0.0 / XORF %I0.1 / ST %Q0.0 / LD %I0.0 / ORR %I0.1 / ST %Q0.1", "%I0.0 0011; %I0.1 0101", "%Q0.0 0001; %Q0.1 0111"),
    Rule("an operation waits for a 1", "LD %I0.0 / [%MW0 := %MW0 + 5]", "%I0.0 0110", "%MW0=0,5,10,10"),
]  # fmt: skip

TIMERS = [
    Rule("TON: starts at the rise, is on at V=P, stays there, and forgets all at 0", timer("TON", 2), "%I0.0 0111100", "%TM0.V=0,0,1,2,2,0,0; %TM0.Q 0001100"),
    Rule("TOF: on at the rise, begins to count at the fall, off at V=P", timer("TOF", 2), "%I0.0 0110000", "%TM0.V=0,0,0,0,1,2,.; %TM0.Q 0111100"),
    Rule("TP: a pulse of P from the rise; V stays at P until IN is 0", timer("TP", 2), "%I0.0 0111100", "%TM0.V=0,0,1,2,2,0,0; %TM0.Q 0110000"),
    Rule("TP: a short input gives the whole pulse", timer("TP", 3), "%I0.0 0100000", "%TM0.Q 0111000; %TM0.V=0,0,1,2,0,0,0"),
    Rule("TP: what IN does during the pulse has no effect", timer("TP", 4), "%I0.0 0101110", "%TM0.Q 0111100; %TM0.V=0,0,1,2,3,4,0"),
    Rule("IN counts as 0 before the first scan, so that a 1 at power-on starts TON", timer("TON", 2), "%I0.0 1111", "%TM0.V=0,1,2,2; %TM0.Q 0011"),
    Rule("and TP", timer("TP", 2), "%I0.0 1111", "%TM0.Q 1100"),
    Rule("ADJ=Y: the program may write P, which counts from the next start", timer("TON", 2, " ADJ=Y") + " / LDR %I0.1 / [%TM0.P := 1]", "%I0.0 01111011; %I0.1 00100000", "%TM0.Q 00011001; %TM0.P=2,2,1,1,1,1,1,1"),
    Rule("a timer that restarts itself has a period of P and two scans", "%TM0: TB=10ms P=3 / BLK %TM0 / LDN %M1 / IN / OUT_BLK / LD Q / ST %M1 / END_BLK", "%I0.0 0", "%M1 00010000100001"),
    Rule("a word or a bit of one that is given from outside stops no timer", timer("TON", 9), "%I0.0 1; %MW0=.,.,3; %MW1:X2 ...1", "%TM0.V=0,1,2,3,4; %MW1=0,0,0,4,."),
    Rule("the direct form does the same", "%TM0: TB=10ms P=2 / LD %I0.0 / IN %TM0 / LD %TM0.Q / ST %Q0.0", "%I0.0 011110", "%Q0.0 000110"),
    Rule("a timer ticks at the start of a scan, also above its block", "%TM0: TB=10ms P=1 / LD %TM0.Q / ST %Q0.0 / LD 1 / IN %TM0", "%I0.0 00", "%Q0.0 01"),
    Rule("a timer begins anew after a power failure", timer("TON", 3), "%I0.0 11111", "%TM0.V=0,1,0,1,2", 10, 2),
]  # fmt: skip

BLOCKS = [
    Rule("%C: each rise of CU and CD counts, none in the first scan", COUNTER, "%I0.2 1010100; %I0.3 0000010", "%C0.V=0,0,1,1,2,1,1"),
    Rule("%C: S loads the preset, not 1, and D is on", COUNTER, "%I0.1 010", "%C0.V=0,3,3; %C0.D 011"),
    Rule("%C: R is a level and stronger than S", COUNTER, "%I0.0 0110; %I0.1 1110", "%C0.V=3,0,0,0; %C0.D 1000"),
    Rule("%C: R lets no edge count", COUNTER, "%I0.0 0110; %I0.2 0101", "%C0.V=0,0,0,1"),
    Rule("%C: both edges in one scan cancel", COUNTER, "%I0.2 010; %I0.3 010; %C0.V=2", "%C0.V=2,2,2"),
    Rule("%C: D is on exactly at V=P, from below and from above", COUNTER, "%I0.2 010101; %I0.3 000000010; %C0.V=1", "%C0.V=1,2,2,3,3,4,4,3; %C0.D 00011001"),
    Rule("%C: F only from 9999 to 0, until the next count", COUNTER, "%I0.2 0100010; %C0.V=9999", "%C0.V=9999,0,0,0,0,1,1; %C0.F 0111100; %C0.E 0000000"),
    Rule("%C: E only from 0 to 9999, until R", COUNTER, "%I0.0 00001; %I0.3 01000", "%C0.V=0,9999,9999,9999,0; %C0.E 01110; %C0.F 00000"),
    Rule("%C: reaching 0 by R is no E and no F", COUNTER, "%I0.0 01; %C0.V=9999", "%C0.V=9999,0; %C0.E 00; %C0.F 00"),
    Rule("%DR: at cold start the control bits of step 0 are written", DRUM.replace("STEPS=00", "STEPS=11"), "%I0.0 00", "%Q0.0 11; %Q0.1 11"),
    Rule("%DR: each rise of U is a step, after the last comes 0; F is on at the last", DRUM, "%I0.1 01010101", "%DR0.S=0,1,1,2,2,0,0,1; %DR0.F 00011000; %Q0.0 01100001; %Q0.1 00011000"),
    Rule("%DR: R is a level and stronger than U", DRUM, "%I0.0 00011; %I0.1 01001", "%DR0.S=0,1,1,0,0"),
    Rule("%DR: between steps another line may write a control bit", DRUM + " / LD %I0.2 / R %Q0.0", "%I0.1 0100000101; %I0.2 0001", "%Q0.0 0110000000"),
    Rule("%DR: while R is held the control bits are written again and again", DRUM.replace("STEPS=00", "STEPS=10") + " / LD %I0.2 / R %Q0.0", "%I0.0 0011; %I0.2 0100", "%Q0.0 1011"),
    Rule("%SBR: a rise of CU shifts to the left, of CD to the right; 0 comes in", SHIFT, "%I0.3 10; %I0.1 0101000; %I0.2 0000101", "%SBR0.1 1000001; %SBR0.2 0110110; %SBR0.3 0001000; %SBR0.0 0000000"),
    Rule("%SBR: what falls out at the left is in %S17", SHIFT, "%I0.4 10; %I0.1 01", "%SBR0.15 10; %S17 01; %SBR0.0 00"),
    Rule("%SBR: R clears all", SHIFT, "%I0.3 10; %I0.4 10; %I0.0 01", "%SBR0.1 10; %SBR0.15 10"),
    Rule("%SBR: no edge in the first scan", SHIFT, "%I0.3 10; %I0.1 11", "%SBR0.1 11"),
    Rule("%SC: exactly one bit is 1, moved by each rise", STEPS, "%I0.1 0101000; %I0.2 0000010", "%SC0.0 1000000; %SC0.1 0110011; %SC0.2 0001100"),
    Rule("%SC: R is a level and takes it to step 0", STEPS, "%I0.0 0001; %I0.1 0101", "%SC0.0 1001; %SC0.1 0110"),
    Rule("%SC: below step 0 it stays, and that is told", STEPS, "%I0.2 01", "%SC0.0 11", says=("RUN004",)),
    Rule("%R as FIFO: the first word in is the first out", "%R0: TYPE=FIFO / " + QUEUE, "%MW0=5,6,.,7; %I0.1 01010000; %I0.2 00000101", "%R0.O=0,0,0,0,0,6,6,7; %R0.E 10000001"),
    Rule("%R as LIFO: the last word in is the first out", "%R0: TYPE=LIFO / " + QUEUE, "%MW0=5,6,.,7; %I0.1 01010000; %I0.2 00000101", "%R0.O=0,0,0,0,0,7,7,6; %R0.E 10000001"),
    Rule("%R: taking from an empty one keeps .O", QUEUE, "%MW0=8; %I0.1 010000; %I0.2 000101", "%R0.O=0,0,0,8,8,8; %R0.E 100111"),
    Rule("%R: sixteen words fill it, the seventeenth is not stored", QUEUE, f"%MW0={WORDS}; %I0.1 {PULSES}00000; %I0.2 {'0' * 34}1010", f"%R0.F {'0' * 31}1110000; %R0.O={'0,' * 34}20,20,21,21"),
    Rule("%R: R empties it", QUEUE, "%MW0=8; %I0.0 0010; %I0.1 0100; %I0.2 0001", "%R0.E 1011; %R0.O=0,0,0,0"),
    Rule("%R: I and O together do neither", QUEUE, "%MW0=8,.,.,9; %I0.1 01010; %I0.2 00010", "%R0.E 10000; %R0.O=0,0,0,0,0"),
    Rule("%R: no edge in the first scan", QUEUE, "%MW0=8; %I0.1 11", "%R0.E 11"),
    Rule("a block acts at OUT_BLK, so that its outputs are of this scan", COUNTER.replace("P=3", "P=1").replace("END_BLK", "OUT_BLK / LD D / ST %Q0.0 / END_BLK"), "%I0.2 01", "%Q0.0 01"),
    Rule("a pin without a line is 0", "BLK %C0 / LD %I0.2 / CU / END_BLK", "%I0.2 0101", "%C0.V=0,1,1,2"),
    Rule("in the direct form a pin alone is enough", "%C0: P=2 / LD %I0.2 / CU %C0 / LD %I0.0 / R %C0 / LD %C0.D / ST %Q0.0", "%I0.2 010100; %I0.0 000001", "%C0.V=0,1,1,2,2,0; %Q0.0 000110"),
]  # fmt: skip

COURSE = [
    Rule("JMPC jumps at 1", "LD %I0.0 / JMPC %L1 / LD %I0.1 / ST %Q0.0 / %L1:", "%I0.0 011; %I0.1 100", "%Q0.0 111"),
    Rule("JMPCN jumps at 0", "LD %I0.0 / JMPCN %L1 / LD %I0.1 / ST %Q0.0 / %L1:", "%I0.0 101; %I0.1 100", "%Q0.0 110"),
    Rule("JMP always jumps", "JMP %L1 / LD 1 / ST %Q0.0 / %L1: / LD 1 / ST %Q0.1", "%I0.0 0", "%Q0.0 0; %Q0.1 1"),
    Rule("SRn runs the subroutine at 1", "LD %I0.0 / SR1 / END / SR1: / LD 1 / [INC %MW0] / RET", "%I0.0 0110", "%MW0=0,1,2,2"),
    Rule("ENDC ends at 1, ENDCN at 0", "LD %I0.0 / ENDC / LD 1 / [INC %MW0] / LD %I0.0 / ENDCN / LD 1 / [INC %MW1]", "%I0.0 0101", "%MW0=1,1,2,2; %MW1=0,0,0,0"),
    Rule("%S0 after a cold start, %S1 after a warm one, %S13 in either's first scan", "LD %S0 / ST %Q0.0 / LD %S1 / ST %Q0.1 / LD %S13 / ST %Q0.2", "%I0.0 0000", "%Q0.0 1000; %Q0.1 0010; %Q0.2 1010", 10, 2),
    Rule("too large a sum sets %S18", "LD 1 / [%MW1 := %MW0 + 1] / LD %S18 / ST %Q0.0", "%MW0=32767,5", "%Q0.0 1."),
]  # fmt: skip


@pytest.mark.parametrize("rule", [*ACCUMULATOR, *TIMERS, *BLOCKS, *COURSE], ids=str)
def test_a_rule_of_neza(rule: Rule) -> None:
    check(rule, "neza")


DEEP = "LD %I0.0"


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("XOR %I0.0/ST %Q0.0", ("error", "STK009", 1)),
        ("LD %I0.0/)/ST %Q0.0", ("error", "RDR010", 2)),
        ("LD %I0.0/AND( %I0.1/ST %Q0.0", ("error", "RDR011", 2)),
        (DEEP + "/AND( %I0.1" * 9 + "/)" * 9 + "/ST %Q0.0", ("error", "STK002", 10)),
        (DEEP + "/MPS" * 9 + "/ST %Q0.0" + "/MPP" * 9 + "/ST %Q0.1", ("error", "STK002", 10)),
        ("LD %I0.0/AND( %I0.1/MPS/)/ST %Q0.0", ("error", "STK012", 3)),
        ("LD %I0.0/AND( %I0.1/ST %Q0.0/)/ST %Q0.1", ("error", "STK012", 3)),
        ("LD %I0.0/AND( %I0.1/S %Q0.0/)/ST %Q0.1", ("error", "STK012", 3)),
        ("LD %I0.0/AND( %I0.1/JMPC %L1/)/ST %Q0.1/%L1:", ("error", "STK012", 3)),
        ("LD %I0.0/MPS/AND %I0.1/ST %Q0.0", ("error", "STK005", 4)),
        ("LD %I0.0/MPS/JMPC %L1/MPP/ST %Q0.0/%L1:", ("error", "JMP004", 3)),
        ("LD %I0.0/JMPC %L1", ("error", "JMP001", 2)),
        ("LD %I0.0/JMPC %L1/%L1:/LD %I0.0/ST %Q0.0/%L1:", ("error", "JMP002", 6)),
        ("LDR %Q0.0/ST %Q0.1", ("error", "RDR007", 1)),
        ("LD %I0.0/ST %I0.1", ("error", "RDR007", 2)),
        ("LD %TM32.Q/ST %Q0.0", ("error", "RDR006", 1)),
        ("LD %C16.D/ST %Q0.0", ("error", "RDR006", 1)),
        ("LD %SBR0.16/ST %Q0.0", ("error", "RDR005", 1)),
        ("LD %SC0.256/ST %Q0.0", ("error", "RDR005", 1)),
        ("%TM0: P=10000/LD %I0.0/IN %TM0", ("error", "CFG002", 1)),
        ("%TM0: ADJ=N/LD %I0.0/IN %TM0/[%TM0.P := 5]", ("error", "CFG007", 4)),
        ("BLK %C0/LD %I0.0/CU/BLK %C1/END_BLK/END_BLK", ("error", "BLK001", 4)),
        ("BLK %C0/LD D/ST %Q0.0/OUT_BLK/END_BLK", ("error", "BLK002", 2)),
        ("BLK %TM0/LD %I0.0/CD/END_BLK", ("error", "BLK004", 3)),
        ("LD %I0.0/CU %SBR0/LD %SBR0.3/ST %Q0.0", ("warning", "BLK009", 2)),
    ],
)  # fmt: skip
def test_what_neza_does_not_take(text: str, wanted: tuple[str, str, int]) -> None:
    assert wanted in said(text, "neza")


def test_eight_of_each_fit() -> None:
    assert said(DEEP + "/AND( %I0.1/OR %I0.2" * 8 + "/)" * 8 + "/ST %Q0.0", "neza") == []
    assert (
        said(
            DEEP + "/MPS" * 8 + "/AND %I0.1/ST %Q1.0" + "".join(f"/MPP/ANDN %I0.1/ST %Q0.{one}" for one in range(8)),
            "neza",
        )
        == []
    )
