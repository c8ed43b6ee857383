"""The S7-200's rules one by one: each row says a sentence of the notes and shows it in scans."""

from __future__ import annotations

import pytest

from .rules import Rule, check, said

AB = "I0.0 0011; I0.1 0101"
BOTH = "LD I0.0 / LD I0.1 / "
PUSHED = " / LPS"

STACK = [
    Rule("before anything is loaded all nine levels are unknown", "LDS 8 / = Q0.0", "I0.0 0", "Q0.0 x", says=("RUN001",)),
    Rule("a push moves everything one level down", "LD I0.0" + PUSHED * 8 + " / LDS 8 / = Q0.0", "I0.0 01", "Q0.0 01"),
    Rule("one push less and the ninth level is still unknown", "LD I0.0" + PUSHED * 7 + " / LDS 8 / = Q0.0", "I0.0 01", "Q0.0 xx", says=("RUN001",)),
    Rule("the ninth push loses the lowest level and stops nothing", "LD I0.1 / LD I0.0" + PUSHED * 8 + " / LDS 8 / = Q0.0", "I0.0 01; I0.1 10", "Q0.0 01"),
    Rule("at a pop an unknown value comes in at the bottom", "LD I0.0" + PUSHED * 8 + " / LPP / LDS 8 / = Q0.0", "I0.0 01", "Q0.0 xx", says=("RUN001",)),
    Rule("x and 0 is 0, x or 1 is 1", "LDS 8 / A I0.0 / = Q0.0 / LDS 8 / O I0.1 / = Q0.1", "I0.0 0; I0.1 1", "Q0.0 0; Q0.1 1"),
    Rule("ALD takes two and gives their product; what was third is second", "LD I0.2 / " + BOTH + "ALD / = Q0.0 / OLD / = Q0.1", AB + "; I0.2 1010", "Q0.0 0001; Q0.1 1011"),
    Rule("OLD takes two and gives their sum; what was third is second", "LD I0.2 / " + BOTH + "OLD / = Q0.0 / ALD / = Q0.1", AB + "; I0.2 1101", "Q0.0 0111; Q0.1 0101"),
    Rule("LPS doubles the top", "LD I0.0 / LPS / A I0.1 / ALD / = Q0.0", AB, "Q0.0 0001"),
    Rule("LRD overwrites the top with the second level and moves nothing else", BOTH + "LRD / = Q0.0 / LPP / = Q0.1", AB, "Q0.0 0011; Q0.1 0011"),
    Rule("LPP uncovers the second level", BOTH + "LPP / = Q0.0", AB, "Q0.0 0011"),
    Rule("LDS counts from 0: LDS 0 doubles the top", BOTH + "LDS 0 / = Q0.0 / LPP / = Q0.1", AB, "Q0.0 0101; Q0.1 0101"),
    Rule("LDS counts from 0: LDS 3 copies the fourth level and leaves it there", "LD I0.3 / LD I0.2 / " + BOTH + "LDS 3 / = Q0.0 / LPP / LPP / LPP / LPP / = Q0.1", AB + "; I0.3 1001", "Q0.0 1001; Q0.1 1001"),
    Rule("NOT turns the top alone", BOTH + "NOT / = Q0.0 / LPP / = Q0.1", AB, "Q0.0 1010; Q0.1 0011"),
    Rule("NOP changes nothing, whatever its number", "LD I0.0 / NOP 255 / NOP 0 / = Q0.0", AB, "Q0.0 0011"),
    Rule("a network goes on with the stack that the last one left", "Network 1 / LD I0.0 / = Q0.0 / Network 2 / A I0.1 / = Q0.1", AB, "Q0.1 0001"),
]  # fmt: skip

CONTACTS = [
    *(
        Rule(f"LD and LDN read a bit of {area}", f"LD {area} / = Q0.0 / LDN {area} / = Q0.1", f"{area} 10", "Q0.0 10; Q0.1 01")
        for area in ("I15.7", "Q15.7", "M31.7", "V10239.7", "S31.7", "L63.7", "SM100.0", "C255", "T255")
    ),
    *(
        Rule(f"{word} combines with the top", f"LD I0.0 / {word} I0.1 / = Q0.0", AB, f"Q0.0 {bits}")
        for word, bits in (("A", "0001"), ("AN", "0010"), ("O", "0111"), ("ON", "1011"))
    ),
    Rule("an immediate contact does not bring the image up to date", "LDN I0.0 / = I0.0 / LDI I0.0 / = Q0.1 / LD I0.0 / = Q0.0", "I0.0 01", "Q0.1 01; Q0.0 10"),
    Rule("bytes are compared without a sign", "LDB> VB0, 100 / = Q0.0", "VB0=200,100,101", "Q0.0 101"),
    Rule("words are compared with their sign", "LDW> VW0, 100 / = Q0.0", "VW0=40000,101,-1", "Q0.0 010"),
    Rule("double words are compared with their sign", "LDD< VD0, 0 / = Q0.0", "VD0=-1,0,2147483647", "Q0.0 100"),
    Rule("reals are compared as numbers", "LDR>= VD0, -1.5 / = Q0.0", "VD0=-1.5,-1.75,0.0", "Q0.0 101"),
    Rule("AW and OD join a comparison to the top", "LD I0.0 / AW<> VW0, 3 / OD<= VD4, -5 / = Q0.0", "I0.0 1110; VW0=3,4,3,4; VD4=0,0,-5,-6", "Q0.0 0111"),
    Rule("an edge needs a 0 since the first scan", "LD I0.0 / EU / = Q0.0 / LD I0.1 / ED / = Q0.1", "I0.0 1101; I0.1 0010", "Q0.0 0001; Q0.1 0001"),
    Rule("an edge instruction that is jumped over keeps what it remembers", "LD I0.1 / JMP 1 / LD I0.0 / EU / = Q0.0 / LBL 1", "I0.0 01111; I0.1 01100", "Q0.0 00010"),
]  # fmt: skip

COILS = [
    Rule("a coil is written at once: a line below sees it in the same scan", "LD I0.0 / = M0.0 / LD M0.0 / = Q0.0", "I0.0 010", "Q0.0 010"),
    *(
        Rule(f"= writes a bit of {area}", f"LD I0.0 / = {area}", "I0.0 0110", f"{area} 0110")
        for area in ("Q0.7", "M0.1", "SM100.3", "V5.6", "S0.2", "L1.1")
    ),
    Rule("=I writes the image too", "LD I0.0 / =I Q0.0 / LD Q0.0 / = Q0.1", "I0.0 01", "Q0.1 01"),
    Rule("SI and RI set and clear as many bits as they say", "LD I0.0 / SI Q0.6, 3 / LD I0.1 / RI Q0.7, 1", "I0.0 010; I0.1 001", "Q0.6 011; Q0.7 010; Q1.0 011; Q1.1 000"),
    Rule("S and R without power leave their bits", "LD I0.0 / S M0.0, 2 / LD I0.1 / R M0.1, 1", "I0.0 0100; I0.1 0001", "M0.0 0111; M0.1 0110; M0.2 0000"),
    Rule("S may reach 255 bits", "LD I0.0 / S V0.0, 255", "I0.0 1", "V31.6 1; V31.7 0"),
    Rule("R of a timer clears its bit and its current value", "LD SM0.0 / TON T37, 1 / LD I0.0 / R T37, 1", "I0.0 00010", "T37 0110.; T37.V=0,1,2,0,.", 100),
    Rule("R of a counter clears its bit and its current value", "LD I0.0 / LD I0.1 / CTU C5, 1 / LD I0.2 / R C5, 1", "I0.0 0100; I0.1 0; I0.2 0001", "C5 0110; C5.V=0,1,1,0"),
    Rule("R reaches several counters", "LD I0.2 / R C4, 2", "C4.V=7; C5.V=8; C6.V=9; I0.2 01", "C4.V=7,0; C5.V=8,0; C6.V=9,9"),
    Rule("SR, set dominant: OUT = S1 + /R OUT", "LD I0.0 / LD I0.1 / NOT / A Q0.0 / OLD / = Q0.0", "I0.0 0101001; I0.1 0001101", "Q0.0 0111001"),
    Rule("RS, reset dominant: OUT = (S + OUT) /R1", "LD I0.0 / LD I0.1 / NOT / LPS / A Q0.0 / = Q0.0 / LPP / ALD / O Q0.0 / = Q0.0", "I0.0 0101001; I0.1 0001101", "Q0.0 0110000"),
    Rule("what a program writes on I lasts until the inputs are read again", "LD I0.0 / = Q0.0 / LD SM0.0 / S I0.0, 1 / LD I0.0 / = Q0.1", "I0.0 00", "Q0.0 00; Q0.1 11"),
]  # fmt: skip

TIMERS = [
    Rule("an on-delay is on from its preset, counts on, and forgets all without power", "LD I0.0 / TON T37, 2", "I0.0 111101", "T37 001100; T37.V=0,1,2,3,0,0", 100),
    Rule("a current value is whole units of what has passed", "LD SM0.0 / TON T37, 2", "I0.0 0", "T37.V=0,0,0,0,1,1,1,2", 30),
    Rule("a retentive one holds both without power, and only R clears them", "LD I0.0 / TONR T5, 2 / LD I0.1 / R T5, 1", "I0.0 11001110; I0.1 00000001", "T5.V=0,1,2,2,2,3,4,0; T5 00111110", 100),
    Rule("an off-delay is on with its input and counts from its fall", "LD I0.0 / TOF T37, 2", "I0.0 0110000", "T37 0111100; T37.V=0,0,0,0,1,2,2", 100),
    Rule("an off-delay whose input comes back begins again", "LD I0.0 / TOF T37, 2", "I0.0 1001000", "T37 1111110; T37.V=0,0,1,0,0,1,2", 100),
    Rule("an off-delay that never was on does not count", "LD I0.0 / TOF T37, 2", "I0.0 0000", "T37 0000; T37.V=0,0,0,0", 100),
    Rule("an off-delay after R needs a new on and off", "LD I0.0 / TOF T37, 3 / LD I0.1 / R T37, 1", "I0.0 10000100; I0.1 00100000", "T37 11000111; T37.V=0,0,0,0,0,0,0,1", 100),
    Rule("100 ms: up to date where its instruction stands, not above it", "LD T37 / = Q0.0 / LD SM0.0 / TON T37, 1 / LD T37 / = Q0.1", "I0.0 0", "Q0.0 001; Q0.1 011", 100),
    Rule("10 ms: up to date from the start of the scan", "LD T33 / = Q0.0 / LD SM0.0 / TON T33, 10 / LD T33 / = Q0.1", "I0.0 0", "Q0.0 011; Q0.1 011", 100),
    Rule("1 ms: goes on in the middle of a scan, away from its instruction", "LD SM0.0 / TON T32, 50 / LD T32 / = Q0.0" + " / NOP 0" * 20 + " / LD T32 / = Q0.1", "I0.0 0", "Q0.0 001; Q0.1 011", 100),
    Rule("100 ms: jumped over it gets no time, and makes good what passed since", "LD I0.0 / JMP 1 / LD SM0.0 / TON T37, 9 / LBL 1", "I0.0 0011", "T37.V=0,1,1,1", 100),
    Rule("10 ms: jumped over it goes on", "LD I0.0 / JMP 1 / LD SM0.0 / TON T33, 9 / LBL 1", "I0.0 0011", "T33.V=0,1,2,3"),
    Rule("a word that is given from outside stops no timer", "LD SM0.0 / TON T33, 9 / TON T32, 90 / TON T37, 9", "VW0=.,.,3", "T33.V=0,1,2,3; T32.V=0,10,20,30"),
    Rule("the first scan adds nothing, however long it is said to last; the others what they lasted", "LD SM0.0 / TON T37, 2 / TON T33, 9", "ms=90,30,70,100,1", "T37.V=0,0,1,2,2; T33.V=0,3,10,20,20; T37 00011"),
    Rule("a preset may be a word, which counts at once", "LD SM0.0 / TON T37, VW0", "VW0=5,.,2", "T37 00111; T37.V=0,1,2,3,4", 100),
    Rule("a timer ends at 32767", "LD SM0.0 / TON T101, 5", "ms=0,3276600,100,100", "T101.V=0,32766,32767,32767"),
    Rule("across a power failure a retentive timer keeps its value and its bit", "LD I0.0 / TONR T5, 2 / LD I0.0 / TON T37, 2", "I0.0 111001", "T5.V=0,1,2,2,2,2; T5 001111; T37.V=0,1,2,0,0,0; T37 001000", 100, 3),
    Rule("and counts on from it", "LD I0.0 / TONR T65, 9", "I0.0 1111", "T65.V=0,1,1,2", 10, 2),
]  # fmt: skip

COUNTERS = [
    Rule("CTU finds R on top and CU below it", "LD I0.0 / LD I0.1 / CTU C0, 2", "I0.0 010101; I0.1 000001", "C0.V=0,1,1,2,2,0; C0 000110"),
    Rule("CTU counts on beyond its preset to 32767 and stays there", "LD I0.0 / LD I0.1 / CTU C0, 2", "I0.0 01010; C0.V=32766", "C0.V=32766,32767,32767,32767,32767; C0 11111"),
    Rule("a count in the first scan is no edge", "LD I0.0 / LD I0.1 / CTU C0, 2", "I0.0 1101", "C0.V=0,0,0,1"),
    Rule("CTD: LD loads the preset and clears the bit", "LD I0.0 / LD I0.1 / CTD C1, 2", "I0.0 00101010; I0.1 01000000", "C1.V=0,2,1,1,0,0,0,0; C1 10001111"),
    Rule("CTUD finds R on top, CD below it, CU below that", "LD I0.0 / LD I0.1 / LD I0.2 / CTUD C2, 1", "I0.0 010100; I0.1 000010; I0.2 000001", "C2.V=0,1,1,2,1,0; C2 011110"),
    Rule("CTUD goes round from 32767 to -32768", "LD I0.0 / LD I0.1 / LD I0.2 / CTUD C2, 1", "I0.0 01; C2.V=32767", "C2.V=32767,-32768; C2 10"),
    Rule("and back", "LD I0.0 / LD I0.1 / LD I0.2 / CTUD C2, 1", "I0.1 01; C2.V=-32768", "C2.V=-32768,32767; C2 01"),
    Rule("a counter leaves its inputs on the stack", "LD I0.2 / " + BOTH + "CTUD C2, 9 / = Q0.0 / LPP / = Q0.1 / LPP / = Q0.2", AB + "; I0.2 1001", "Q0.0 0101; Q0.1 0011; Q0.2 1001"),
    Rule("a counter keeps its value across a power failure", "LD I0.0 / LD I0.1 / CTU C0, 1", "I0.0 01110", "C0.V=0,1,1,1,1; C0 01111", 10, 2),
]  # fmt: skip

WORDS = [
    Rule("SHRB with N > 0: the bit enters at S_BIT and moves up", "LD I0.0 / SHRB I0.1, V0.0, 3", "I0.0 1111; I0.1 1000", "V0.0 1000; V0.1 0100; V0.2 0010; SM1.1 0001; V0.3 0000"),
    Rule("SHRB with N < 0: the bit enters at the far end and moves down", "LD I0.0 / SHRB I0.1, V0.0, -3", "I0.0 1111; I0.1 1000", "V0.2 1000; V0.1 0100; V0.0 0010; SM1.1 0001"),
    Rule("SHRB shifts in every scan with power and in none without", "LD I0.0 / SHRB SM0.0, V0.0, 9", "I0.0 1011", "V0.0 1111; V0.1 0011; V0.2 0001"),
    Rule("without power no word is worked on and no flag changes", "LD I0.0 / +I 5, VW0", "I0.0 01; VW0=-5; SM1.2 1", "VW0=-5,0; SM1.0 01; SM1.2 10"),
    Rule("OUT becomes OUT op IN", "LD SM0.0 / -I 5, VW0 / *I 2, VW0", "VW0=8", "VW0=6"),
    Rule("SM1.2 says negative", "LD SM0.0 / -I 5, VW0", "VW0=3", "VW0=-2; SM1.0 0; SM1.1 0; SM1.2 1"),
    Rule("SM1.1 says that the sum does not fit, and ENO goes off", "LD SM0.0 / +I 1, VW0 / AENO / = Q0.0", "VW0=32766,32767", "SM1.1 01; Q0.0 10"),
    Rule("SM1.3 says division by zero, and ENO goes off", "LD SM0.0 / /I VW2, VW0 / AENO / = Q0.0", "VW0=7,7; VW2=2,0", "SM1.3 01; Q0.0 10"),
    Rule("AENO joins ENO to the top and not to the branch below", "LD SM0.0 / LPS / /I VW2, VW0 / AENO / = Q0.0 / LPP / = Q0.1", "VW0=7", "Q0.0 0; Q0.1 1"),
    Rule("a word has its high byte first", "LD I0.0 / MOVW 258, VW100", "I0.0 1; VB102=9", "VB100=1; VB101=2; VB102=9; V101.1 1; V100.0 1; VW101=521; VD99=66057"),
    Rule("M is words too", "LD SM0.0 / MOVW 1, MW0", "I0.0 0", "M1.0 1; M0.0 0; MB1=1"),
    Rule("an accumulator holds 32 bits", "LD SM0.0 / MOVD 70000, AC0 / MOVD AC0, VD0", "I0.0 0", "VD0=70000; VW2=4464"),
    Rule("a timer's and a counter's number as a word is its current value", "LD SM0.0 / TON T37, 9 / MOVW T37, VW0 / LDW>= C0, 3 / = Q0.0", "C0.V=2,3", "VW0=0,1; Q0.0 01", 100),
    Rule("writing a counter's word changes where it counts on", "LD I0.0 / LD I0.1 / CTU C0, 9 / LD SM0.1 / MOVW 5, C0", "I0.0 01", "C0.V=5,6"),
]  # fmt: skip

COURSE = [
    Rule("what is jumped over keeps its state", "LD I0.0 / JMP 7 / LD I0.1 / = Q0.0 / LBL 7", "I0.0 011; I0.1 100", "Q0.0 111"),
    Rule("a jump without power is none", "LD I0.0 / JMP 7 / LD I0.1 / = Q0.0 / LBL 7", "I0.0 00; I0.1 01", "Q0.0 01"),
    Rule("a loop runs from its first to its last value, both counted", "LD I0.0 / FOR VW0, 3, 5 / LD SM0.0 / INCW VW2 / NEXT", "I0.0 01", "VW2=0,3"),
    Rule("a loop whose first value is beyond its last does not run", "LD I0.0 / FOR VW0, 6, 5 / LD SM0.0 / INCW VW2 / NEXT", "I0.0 01", "VW2=0,0"),
    Rule("a subroutine finds 1 above zeros, and the caller's stack comes back", "LD I0.1 / LD I0.0 / CALL SBR0 / = Q0.0 / LPP / = Q0.1\nSUBROUTINE_BLOCK SBR_0:SBR0\n= Q0.2\nLDS 8\n= Q0.3\nEND_SUBROUTINE_BLOCK", "I0.0 11; I0.1 01", "Q0.0 11; Q0.1 01; Q0.2 11; Q0.3 00"),
    Rule("CRET returns only with power", "LD SM0.0 / CALL SBR0\nSUBROUTINE_BLOCK SBR_0:SBR0\nLD I0.0\nCRET\nLD SM0.0\n= Q0.0\nEND_SUBROUTINE_BLOCK", "I0.0 101", "Q0.0 011"),
    Rule("END ends the scan only with power", "LD I0.0 / END / LD I0.1 / = Q0.0", "I0.0 011; I0.1 101", "Q0.0 111"),
    Rule("a segment without power: every load is 0, an inverted one too; coils drop, S does not fire", "LSCR S0.1 / LDN I0.0 / = Q0.0 / S Q0.1, 1 / SCRE / LDN I0.0 / = Q0.2", "S0.1 010; I0.0 000", "Q0.0 010; Q0.1 011; Q0.2 111"),
    Rule("a transfer turns the next segment on and its own off", "LSCR S0.1 / LD I0.0 / SCRT S0.2 / SCRE / LSCR S0.2 / LD SM0.0 / = Q0.0 / SCRE", "S0.1 1; I0.0 010", "S0.1 100; S0.2 011; Q0.0 011"),
    Rule("the power of a segment ends at SCRE", "LSCR S0.1 / SCRE / LD SM0.0 / = Q0.0", "S0.1 0", "Q0.0 1"),
    Rule("SM0.2 says that retentive memory was lost, SM0.1 and SM0.3 that RUN begins", "LD SM0.2 / = Q0.2 / LD SM0.1 / = Q0.1 / LD SM0.3 / = Q0.3", "I0.0 0000", "Q0.2 1000; Q0.1 1010; Q0.3 1010", 10, 2),
    Rule("V and the upper M outlive a power failure, the lower M, Q and S do not", "LD I0.0 / S V0.0, 1 / S M13.7, 2 / S S0.0, 1 / S Q0.0, 1", "I0.0 10", "V0.0 11; M13.7 10; M14.0 11; S0.0 10; Q0.0 10", 10, 1),
]  # fmt: skip


@pytest.mark.parametrize("rule", [*STACK, *CONTACTS, *COILS, *TIMERS, *COUNTERS, *WORDS, *COURSE], ids=str)
def test_a_rule_of_the_s7_200(rule: Rule) -> None:
    check(rule, "s7-200")


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("LDI M0.0/= Q0.0", ("error", "RDR007", 1)),  # immediate contacts: inputs only
        ("LD I0.0/=I M0.0", ("error", "RDR007", 2)),  # immediate coils: outputs only
        ("LD I0.0/S Q0.0, 0", ("error", "RDR008", 2)),
        ("LD I0.0/S Q0.0, 256", ("error", "RDR008", 2)),
        ("LD I0.0/SI Q0.0, 129", ("error", "RDR008", 2)),
        ("LD I0.0/NOP 256", ("error", "RDR008", 2)),
        ("LD I0.0/SHRB I0.1, V0.0, 65", ("error", "RDR008", 2)),
        ("LD I16.0/= Q0.0", ("error", "RDR006", 1)),
        ("LD M32.0/= Q0.0", ("error", "RDR006", 1)),
        ("LD S32.0/= Q0.0", ("error", "RDR006", 1)),
        ("LD T256/= Q0.0", ("error", "RDR006", 1)),
        ("LD L64.0/= Q0.0", ("error", "RDR006", 1)),
        ("LD SM0.0/MOVD AC4, VD0", ("error", "RDR006", 2)),
        ("LD SM0.0/MOVW AIW3, VW0", ("error", "RDR006", 2)),
        ("LD I0.0/JMP 256", ("error", "RDR008", 2)),
        ("LD I0.0/JMP 3", ("error", "JMP001", 2)),
        ("LD I0.0/HSC 0", ("error", "RDR002", 2)),
        ("LDS= VB0, VB10/= Q0.0", ("error", "RDR002", 1)),
        ("LDD= HC0, 5/= Q0.0", ("error", "RDR007", 1)),  # high-speed counters are not run
    ],
)  # fmt: skip
def test_what_the_s7_200_does_not_take(text: str, wanted: tuple[str, str, int]) -> None:
    assert wanted in said(text, "s7-200")
