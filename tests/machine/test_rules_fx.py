"""The FX's rules one by one: each row says a sentence of the notes and shows it in scans; then the table of wrong programs."""

from __future__ import annotations

import pytest

from .rules import Rule, check, said

AB = "X0 0011; X1 0101"
STEPS = "LD M8002 / SET S0 / STL S0 / LD X0 / SET S20 / STL S20 / LD M8000 / OUT Y0 / "
COMPARED = "LD X0 / CMP D0 K5 M0"

CONTACTS = [
    Rule("a load that no join will take begins a new circuit and replaces the result", "LD X0 / OUT Y0 / LD X1 / OUT Y1", AB, "Y0 0011; Y1 0101"),
    Rule("a load inside a circuit saves the result for the join", "LD X0 / LD X1 / OR X2 / ANB / OUT Y0", AB + "; X2 1010", "Y0 0011"),
    Rule("such a load may stand behind an output", "LD X0 / MPS / OUT Y0 / LD X1 / OR X2 / ANB / OUT Y1 / MPP / OUT Y2", AB + "; X2 0000", "Y0 0011; Y1 0001; Y2 0011"),
    Rule("an output keeps the result: outputs in a row go on from it", "LD X0 / OUT Y0 / AND X1 / OUT Y1", AB, "Y0 0011; Y1 0001"),
    *(
        Rule(f"{word} combines with the result", f"LD X0 / {word} X1 / OUT Y0", AB, f"Y0 {bits}")
        for word, bits in (("AND", "0001"), ("ANI", "0010"), ("OR", "0111"), ("ORI", "1011"))
    ),
    *(
        Rule(f"LD and LDI read {area}", f"LD {area} / OUT Y0 / LDI {area} / OUT Y1", f"{area} 10", "Y0 10; Y1 01")
        for area in ("X377", "Y377", "M7679", "S4095", "T511", "C255")
    ),
    Rule("ORB and ANB take the saved block", "LD X0 / AND X1 / LDI X0 / ANI X1 / ORB / OUT Y0", AB, "Y0 1001"),
    Rule("INV turns the result", "LD X0 / AND X1 / INV / OUT Y0", AB, "Y0 1110"),
    Rule("MPS, MRD and MPP give each branch the same point", "LD X0 / OR X5 / MPS / AND X1 / OUT Y0 / MRD / ANI X1 / OUT Y1 / MPP / OUT Y2", AB + "; X5 1000", "Y0 0001; Y1 1010; Y2 1011"),
    Rule("what is nested comes back in order", "LD X0 / MPS / AND X1 / MPS / ANI X2 / OUT Y0 / MPP / AND X2 / OUT Y1 / MPP / OUT Y2", AB + "; X2 0000", "Y0 0001; Y1 0000; Y2 0011"),
    Rule("an edge contact is on for one scan and not in the first", "LDP X0 / OUT Y0 / LDF X1 / OUT Y1", "X0 10110; X1 01001", "Y0 00100; Y1 00100"),
    Rule("an edge contact of a relay looks where it stands", "LD X0 / OUT M0 / LDP M0 / OUT Y0 / LDF M0 / OUT Y1", "X0 0110", "Y0 0100; Y1 0001"),
    Rule("ANDP and ORF join an edge to the result", "LD X0 / ANDP X1 / OUT Y0 / LD X0 / ORF X1 / OUT Y1", "X0 00111; X1 01010", "Y0 00010; Y1 00111"),
    Rule("MEP and MEF are edges of the result so far", "LD X0 / AND X1 / MEP / OUT Y0 / LD X0 / AND X1 / MEF / OUT Y1", "X0 0111; X1 0110", "Y0 0100; Y1 0001"),
    Rule("no result has an edge in the first scan", "LD X0 / MEP / OUT Y0 / LD X0 / PLS M0 / LDI X0 / PLF M1", "X0 1", "Y0 0; M0 0; M1 0"),
]  # fmt: skip

COILS = [
    Rule("of two coils of one relay the last one wins", "LD X0 / OUT Y0 / LD X1 / OUT Y0", AB, "Y0 0101"),
    Rule("SET latches and RST releases; the later one wins", "LD X0 / SET Y0 / LD X1 / RST Y0", "X0 0100010; X1 0001010", "Y0 0110000"),
    Rule("PLS and PLF last exactly one scan", "LD X0 / PLS M0 / LD X0 / PLF M1", "X0 0111001", "M0 0100001; M1 0000100"),
    Rule("RST of a timer clears value and contact", "LD X0 / OUT T250 K2 / LD X1 / RST T250", "X0 111000; X1 000010", "T250.V=0,1,2,.,0,0; T250 001100", 100),
    Rule("RST of a counter clears value and contact", "LD X0 / OUT C0 K1 / LD X1 / RST C0", "X0 01000; X1 00010", "C0.V=0,1,1,0,0; C0 01100"),
    Rule("RST clears a word", "LD X0 / RST D0", "D0=7; X0 001", "D0=7,7,0"),
    Rule("END: what stands below is not executed", "LD X0 / OUT Y0 / END / LD X0 / OUT Y1", "X0 11", "Y0 11; Y1 00"),
]  # fmt: skip

RAILS = [
    Rule("inside an open MC each load is 0 where it has no power, an inverted one too", "LD X0 / MC N0 M100 / LDI X1 / OUT Y0 / MCR N0 / LDI X1 / OUT Y1", "X0 010", "M100 010; Y0 010; Y1 111"),
    Rule("SET and RST do not fire there and keep what was", "LD X0 / MC N0 M100 / LD X1 / SET Y0 / LD X1 / RST Y1 / MCR N0", "X0 01000; X1 11111; Y1 1", "Y0 01111; Y1 10000"),
    Rule("ordinary timers end there, retentive ones hold", "LD X0 / MC N0 M100 / LD M8000 / OUT T0 K9 / LD M8000 / OUT T250 K9 / MCR N0", "X0 11100", "T0.V=0,1,2,0,0; T250.V=0,1,2,3,3", 100),
    Rule("counters hold there and count no edge", "LD X0 / MC N0 M100 / LD X1 / OUT C0 K9 / MCR N0", "X0 11000; X1 01010", "C0.V=0,1,1,1,1"),
    Rule("an MC within an MC has the power of both", "LD X0 / MC N0 M100 / LD X1 / MC N1 M101 / LD M8000 / OUT Y0 / MCR N1 / LD M8000 / OUT Y1 / MCR N0", AB, "Y0 0001; Y1 0011"),
    Rule("SET of a step leaves its source; both are on for the scan of the transfer", STEPS + "LD S0 / OUT Y1 / RET", "X0 0010", "S0 1100; S20 0011; Y0 0011; Y1 0010"),
    Rule("in a step that is off every load is 0", "STL S20 / LDI X0 / OUT Y0 / SET Y1 / RET / LDI X0 / OUT Y2", "S20 0; X0 0", "Y0 0; Y1 0; Y2 1"),
    Rule("steps one after the other are joined by and", "STL S20 / STL S21 / LD M8000 / OUT Y0 / RET", "S20 0011; S21 0101", "Y0 0001"),
    Rule("two steps may drive one coil", "STL S20 / LD M8000 / OUT Y0 / STL S21 / LD M8000 / OUT Y0 / RET", "S20 1100; S21 0110", "Y0 1110"),
    Rule("a coil goes off with its step, what it set stays", "STL S20 / LD M8000 / OUT Y0 / SET Y1 / RET", "S20 10", "Y0 10; Y1 11"),
]  # fmt: skip

TIME = [
    *(
        Rule(f"{timer} counts {ms} ms", f"LD X0 / OUT {timer} K2", "X0 0111101", f"{timer}.V=0,0,1,2,.,{held},.; {timer} 00011{on}{on}", ms)
        for timer, ms, held, on in (
            ("T0", 100, 0, 0), ("T199", 100, 0, 0), ("T200", 10, 0, 0), ("T245", 10, 0, 0), ("T256", 1, 0, 0), ("T511", 1, 0, 0),
            ("T246", 1, 2, 1), ("T249", 1, 2, 1), ("T250", 100, 2, 1), ("T255", 100, 2, 1),
        )
    ),
    Rule("a timer's contact changes where OUT T stands, not above it", "LD T0 / OUT Y0 / LD M8000 / OUT T0 K1 / LD T0 / OUT Y1", "X0 0", "Y0 001; Y1 011", 100),
    Rule("a preset may be a register", "LD M8000 / OUT T0 D0", "D0=2", "T0 0011", 100),
    Rule("a 16-bit counter stops at its preset and stays on until RST", "LD X1 / RST C0 / LD X0 / OUT C0 K2", "X0 010101010; X1 000000001", "C0.V=0,1,1,2,2,2,2,2,0; C0 000111110"),
    Rule("a counter counts no edge in the first scan", "LD X0 / OUT C0 K2", "X0 1101", "C0.V=0,0,0,1"),
    Rule("M8200 on: C200 counts down; its contact goes on at K upward and off downward", "LD X1 / OUT M8200 / LD X0 / OUT C200 K2", "X0 01010101; X1 00000111", "C200.V=0,1,1,2,2,1,1,0; C200 00011000"),
    Rule("a preset of 32 bits may be negative", "LD X1 / OUT M8234 / LD X0 / OUT C234 K-1", "X0 0101; X1 0011; C234.V=-2", "C234.V=-2,-1,-1,-2; C234 0110"),
    Rule("a 32-bit counter is a ring, up", "LD X0 / OUT C200 K5", "X0 01; C200.V=2147483647", "C200.V=2147483647,-2147483648"),
    Rule("a 32-bit counter is a ring, down", "LD M8000 / OUT M8200 / LD X0 / OUT C200 K5", "X0 01; C200.V=-2147483648", "C200.V=-2147483648,2147483647"),
    Rule("M8000 to M8003: running, its inverse, first scan, not the first", "LD M8000 / OUT Y0 / LD M8001 / OUT Y1 / LD M8002 / OUT Y2 / LD M8003 / OUT Y3", "X0 0000", "Y0 1111; Y1 0000; Y2 1010; Y3 0101", 10, 2),
    Rule("what is latched outlives a power failure, the rest does not", "LD X0 / SET M499 / SET M500 / SET Y0", "X0 10", "M499 10; M500 11; Y0 10", 10, 1),
    Rule("latched counters and retentive timers too", "LD X0 / OUT C99 K9 / OUT C100 K9 / OUT T249 K9 / OUT T250 K9", "X0 0111", "C99.V=0,1,0,0; C100.V=0,1,1,1; T250.V=0,0,0,1", 100, 2),
]  # fmt: skip

WORDS = [
    Rule("MOV copies only with power", "LD X0 / MOV K7 D0", "X0 010; D0=1", "D0=1,7,7"),
    Rule("a P form acts once at each rise, and not in the first scan", "LD X0 / INCP D0 / LD X0 / INC D1", "X0 110110", "D0=0,0,0,1,1,1; D1=1,2,2,3,4,4"),
    Rule("a D form takes two registers, the low one first", "LD X0 / DMOV K70000 D0", "X0 1", "D0=4464; D1=1"),
    Rule("DINC carries into the upper register", "LD X0 / DINC D0", "X0 1; D0=-1; D1=0", "D0=0; D1=1"),
    Rule("CMP: greater, equal, less in three relays, which stay without power", COMPARED, "X0 1110; D0=6,5,4,9", "M0 1000; M1 0100; M2 0011"),
    Rule("ZCP: below, within (ends counted), above", "LD X0 / ZCP K5 K9 D0 M0", "X0 1111; D0=4,5,9,10", "M0 1000; M1 0110; M2 0001"),
    Rule("ADD to zero sets M8020", "LD X0 / ADD D0 K-3 D1", "X0 11; D0=3,4", "D1=0,1; M8020 10"),
    Rule("above 32767 M8022 is carry, below -32768 M8021 is borrow", "LD X0 / ADD D0 K1 D1 / LD M8022 / OUT Y0 / LD X0 / SUB D2 K1 D3 / LD M8021 / OUT Y1", "X0 11; D0=32767,5; D2=-32768,5", "Y0 10; Y1 10"),
    Rule("SFTL lets the bit in at the bottom and moves up, in each scan with power", "LD X0 / SFTL X1 M0 K3 K1", "X0 1101; X1 1000", "M0 1000; M1 0110; M2 0001; M3 0000"),
    Rule("SFTR lets the bit in at the top and moves down", "LD X0 / SFTR X1 M0 K3 K1", "X0 1101; X1 1000", "M2 1000; M1 0110; M0 0001"),
    Rule("ZRST clears all from the first to the last", "LD X0 / ZRST M1 M3 / ZRST D1 D2 / ZRST C0 C1", "X0 01; M0 1; M1 1; M3 1; M4 1; D0=1; D1=2; D2=3; D3=4; C0.V=5; C1.V=6", "M0 11; M1 10; M3 10; M4 11; D0=1,1; D1=2,0; D2=3,0; D3=4,4; C0.V=5,0; C1.V=6,0"),
    Rule("K4M0 is sixteen relays, M0 the lowest", "LD X0 / MOV K-32766 K4M0 / MOV K4M0 D0", "X0 1", "M0 0; M1 1; M2 0; M15 1; D0=-32766"),
    Rule("K2X4 goes from X4 to X7 and on from X10", "LD M8000 / MOV K2X4 D0", "X4 1; X7 1; X10 1; X13 1", "D0=153"),
    Rule("K1Y0 takes four bits and leaves the others", "LD X0 / MOV K31 K1Y0", "X0 1", "Y0 1; Y1 1; Y2 1; Y3 1; Y4 0"),
    Rule("numbers are compared with their sign; AND and OR join", "LD X0 / AND> D0 K-2 / OR= D1 K5 / OUT Y0", "X0 1101; D0=-3,-1,-1,-1; D1=0,0,0,5", "Y0 0101"),
    Rule("a D compare takes 32 bits", "LDD= D0 K70000 / OUT Y0 / LD= D0 K4464 / OUT Y1", "D0=4464; D1=1", "Y0 1; Y1 1"),
    Rule("a timer's current value is a word", "LD M8000 / OUT T0 K50 / LD>= T0 K2 / OUT Y0", "X0 0", "Y0 0011", 100),
    Rule("the flicker circuit: off for the first time, on for the second", "LD X4 / LDI T30 / ORI T31 / ANB / OUT T30 K3 / LD T30 / MPS / ANI T31 / OUT Y1 / MPP / OUT T31 K2", "X4 1111111111110", "Y1 0001110000110", 100),
]  # fmt: skip


@pytest.mark.parametrize("rule", [*CONTACTS, *COILS, *RAILS, *TIME, *WORDS], ids=str)
def test_a_rule_of_the_fx(rule: Rule) -> None:
    check(rule, "fx")


BLOCKS = "/".join(f"LD X{number:o}/AND X{number + 16:o}" for number in range(9))


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("LD X0/LD X1/MPS/ORB/OUT Y0/MPP/OUT Y1", [("error", "STK004", 4)]),
        ("LD X0/AND X1/MPS/LD X2/AND X3/MRD/ORB/ANB/OUT Y0", [("error", "STK003", 6)]),
        ("LD X0/MPS/AND X1/OUT Y0/MRD/AND X2/OUT Y1/END", [("error", "STK006", 8)]),
        ("LD X0/AND X1/ANB", [("error", "STK001", 3)]),
        ("LD X0/LD X1/OUT Y0", [("error", "STK005", 3)]),
        (f"{BLOCKS}{'/ORB' * 8}/OUT Y0", [("error", "STK011", 17)]),
        ("LD X0" + "/MPS/AND X1" * 12 + "/OUT Y0" + "".join(f"/MPP/OUT Y{one:o}" for one in range(1, 13)), [("error", "STK002", 24)]),
        ("LD X0/LD X1/ORB/OUT Y0", [("info", "STK007", 2)]),
        (f"{BLOCKS.rpartition('/LD')[0]}{'/ORB' * 7}/OUT Y0", []),
        ("AND X0/OUT Y0", [("error", "STK001", 1)]),
        ("INV/OUT Y0", [("error", "STK001", 1)]),
        ("LD X0/OUT X1", [("error", "RDR007", 2)]),
        ("LD X0/OUT Y0/LD X1/OUT Y0", [("warning", "COI001", 4)]),
        ("LD X0/PLS S20", [("error", "RDR007", 2)]),
        ("LD X0/OUT T0 K0", [("error", "RDR008", 2)]),
        ("LD X0/OUT C199 K32768", [("error", "RDR008", 2)]),
        ("LD X0/OUT C200 K-5", []),
        ("LD X8/OUT Y0", [("error", "RDR006", 1)]),
        ("LD X400/OUT Y0", [("error", "RDR006", 1)]),
        ("LD X0/MC N0 M100/LD X1/OUT Y0", [("error", "COI003", 2)]),
        ("LD X0/OUT Y0/MCR N0", [("error", "COI004", 3)]),
        ("LD X0/MC N1 M100/LD X1/MC N0 M101/LD X2/OUT Y0/MCR N0/MCR N1", [("error", "COI005", 4)]),
        ("STL S20/LD X0/MC N0 M100/LD X1/OUT Y0/MCR N0/RET", [("error", "COI006", 3)]),
        ("STL S20/MPS/AND X0/OUT Y0/MPP/OUT Y1/RET", [("error", "COI007", 2)]),
        ("STL S20/LD X0/OUT Y0/STL S21/LD X1/OUT Y0/RET", []),
    ],
)  # fmt: skip
def test_the_verdict_on_a_program(text: str, wanted: list[tuple[str, str, int]]) -> None:
    assert said(text, "fx") == wanted
