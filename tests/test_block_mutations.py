"""Wrong rows of timers, counters, blocks, words and the program's course are noticed: each row is changed, and a case tells.

Every expectation is a literal after the notes on the four families, or is worked out by Python's own operators; the true tables
give them all. A row is changed in every way of its kind: another rule, other pins or sources, another relation, another
condition, or nothing done at all. Only the cases that use the row are run, so no sampling is needed.
"""

from __future__ import annotations

import operator
import struct
import sys
from dataclasses import dataclass, replace
from functools import cache
from itertools import permutations
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from plcteach.core.effect import Not
from plcteach.core.notation import parse_effect, parse_formula
from plcteach.dialects import dialect
from plcteach.machine import run
from plcteach.machine.sums import RULES
from plcteach.machine.timers import DRIVES
from plcteach.stl import read

sys.path.insert(0, str(Path(__file__).parent / "machine"))
from direct import RELATIONS
from wrong_rows import beyond_bits, table_with, turned

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect
    from plcteach.core.verb import Verb

FAMILIES = ("s7-200", "fx", "neza", "gutta")


@dataclass(frozen=True, eq=False)
class Case:
    """A program, what is given in each scan, and what each address must hold at the end of each scan."""

    family: str
    text: str
    rows: tuple[dict[str, int], ...]
    wanted: tuple[tuple[str, tuple[int, ...]], ...]
    ms: int = 10

    def __str__(self) -> str:
        return f"{self.family} {self.text[:60]}"

    def holds(self, family: Dialect) -> bool:
        """Say whether a table gives what is wanted; one that cannot even run it does not."""
        try:
            trace = run(read(self.text, family), self.rows, scan_ms=self.ms)
            return all(shown(trace, address) == values for address, values in self.wanted)
        except Exception:  # noqa: BLE001  (a wrong table may break anything)
            return False


def shown(trace: Any, address: str) -> tuple[int, ...]:
    """Give what an address holds scan by scan, as whole numbers."""
    return tuple(int(str(one)) for one in trace.values(address))


def case(family: str, text: str, given: str, wanted: str, ms: int = 10) -> Case:
    """Make a case of words like "I0.0=0110 VW0=7,8,9,9": a digit or a number for each scan; 7 alone is given once, at first."""
    columns = {name: numbers(word) for name, _, word in (one.partition("=") for one in given.split())}
    held = [(name, numbers(word)) for name, _, word in (one.partition("=") for one in wanted.split())]
    rows = tuple(
        {name: values[at] for name, values in columns.items() if at < len(values)} for at in range(len(held[0][1]))
    )
    return Case(family, text, rows, tuple(held), ms)


def numbers(word: str) -> tuple[int, ...]:
    return tuple(int(one) for one in (word.split(",") if "," in word else word) if one)


BY_HAND = (
    # timers: the scan that starts one adds nothing; where it is on, where it stops, what it holds
    case("s7-200", "LD I0.0; TON T37, 3; LD T37; = Q0.0", "I0.0=0111110", "Q0.0=0000110 T37.V=0,0,1,2,3,4,0", 100),
    case("s7-200", "LD I0.0; TONR T5, 3; LD T5; = Q0.0", "I0.0=01101110", "Q0.0=00000111 T5.V=0,0,1,2,2,3,4,5", 100),
    case("s7-200", "LD I0.0; TOF T38, 3; LD T38; = Q0.0", "I0.0=0110000", "Q0.0=0111110 T38.V=0,0,0,0,1,2,3", 100),
    case("gutta", "LD I0.0; TON T37, 3; LD T37; = Q0.0", "I0.0=0111110", "Q0.0=0000110 T37.V=0,0,1,2,3,4,0", 100),
    case("gutta", "LD I0.0; TONR T5, 3; LD T5; = Q0.0", "I0.0=01101110", "Q0.0=00000111 T5.V=0,0,1,2,2,3,4,5", 100),
    case("gutta", "LD I0.0; TOF T38, 3; LD T38; = Q0.0", "I0.0=0110000", "Q0.0=0111110 T38.V=0,0,0,0,1,2,3", 100),
    case("fx", "LD X0; OUT T0 K3; LD T0; OUT Y0", "X0=0111110", "Y0=0000110 T0.V=0,0,1,2,3,3,0", 100),
    case("neza", "%TM0: TB=100ms P=3; LD %I0.0; IN %TM0; LD %TM0.Q; ST %Q0.0", "%I0.0=0111110", "%Q0.0=0000110 %TM0.V=0,0,1,2,3,3,0", 100),
    # counters: edges only, the preset, the ends, both ways
    case("s7-200", "LD I0.0; LD I0.1; CTU C0, 2; LD C0; = Q0.0", "I0.0=0101010 I0.1=0000001", "Q0.0=0001110 C0.V=0,1,1,2,2,3,0"),
    case("s7-200", "LD I0.0; LD I0.1; CTU C0, 2", "I0.0=01 I0.1=00 C0.V=32767,", "C0.V=32767,32767"),
    case("s7-200", "LD I0.0; LD I0.1; CTD C1, 2; LD C1; = Q0.0", "I0.0=0001010 I0.1=0100000", "Q0.0=1000011 C1.V=0,2,2,1,1,0,0"),
    case("s7-200", "LD I0.0; LD I0.1; LD I0.2; CTUD C2, 2; LD C2; = Q0.0", "I0.0=01010000 I0.1=00000100 I0.2=00000001", "Q0.0=00011000 C2.V=0,1,1,2,2,1,1,0"),
    case("s7-200", "LD I0.0; LD I0.1; LD I0.2; CTUD C2, 2", "I0.0=01 I0.1=00 I0.2=00 C2.V=32767,", "C2.V=32767,-32768"),
    case("gutta", "Network 1\nLD I0.0; LD I0.1; CTU C0, 2\nNetwork 2\nLD C0; = Q0.0", "I0.0=0101010 I0.1=0000001", "Q0.0=0001110 C0.V=0,1,1,2,2,3,0"),
    case("gutta", "LD I0.0; LD I0.1; CTU C0, 2", "I0.0=01 I0.1=00 C0.V=32767,", "C0.V=32767,32767"),
    case("gutta", "Network 1\nLD I0.0; LD I0.1; CTD C1, 2\nNetwork 2\nLD C1; = Q0.0", "I0.0=0001010 I0.1=0100000", "Q0.0=1000011 C1.V=0,2,2,1,1,0,0"),
    case("gutta", "Network 1\nLD I0.0; LD I0.1; LD I0.2; CTUD C2, 2\nNetwork 2\nLD C2; = Q0.0", "I0.0=01010000 I0.1=00000100 I0.2=00000001", "Q0.0=00011000 C2.V=0,1,1,2,2,1,1,0"),
    case("gutta", "LD I0.0; LD I0.1; LD I0.2; CTUD C2, 2", "I0.0=01 I0.1=00 I0.2=00 C2.V=32767,", "C2.V=32767,-32768"),
    case("fx", "LD X0; OUT C0 K2; LD C0; OUT Y0; LD X1; RST C0", "X0=01010101 X1=00000010", "Y0=00011110 C0.V=0,1,1,2,2,2,0,1"),
    case(
        "neza", "%C0: P=3; LD %I0.0; CU %C0; LD %I0.1; CD %C0; LD %I0.2; S %C0; LD %I0.3; R %C0; LD %C0.D; ST %Q0.0",
        "%I0.0=0101000 %I0.1=0000100 %I0.2=0000010 %I0.3=0000001", "%C0.V=0,1,1,2,1,3,0 %Q0.0=0000010",
    ),
    # a drum, a shift register, a step counter, a queue
    case(
        "neza", "%DR0: OUT=%Q0.0,%Q0.1 STEPS=00,10,01,11; LD %I0.0; U %DR0; LD %I0.1; R %DR0",
        "%I0.0=01010 %I0.1=00001", "%DR0.S=0,1,1,2,0 %Q0.0=01100 %Q0.1=00010",
    ),
    case(
        "neza", "LD %I0.3; S %SBR0.0; LD %I0.0; CU %SBR0; LD %I0.1; CD %SBR0; LD %I0.2; R %SBR0",
        "%I0.3=10000 %I0.0=01010 %I0.1=00100 %I0.2=00001", "%SBR0.0=10100 %SBR0.1=01010 %SBR0.2=00000",
    ),
    case(
        "neza", "LD %I0.0; CU %SC0; LD %I0.1; CD %SC0; LD %I0.2; R %SC0",
        "%I0.0=0101010 %I0.1=0000100 %I0.2=0000001", "%SC0.0=1000001 %SC0.1=0110100 %SC0.2=0001010",
    ),
    case(
        "neza", "%R0: TYPE=FIFO; LD 1; [ %R0.I := %MW0 ]; LD %I0.0; I %R0; LD %I0.1; O %R0; LD %I0.2; R %R0",
        "%I0.0=010100 %I0.1=000010 %I0.2=000001 %MW0=10,11,12,13,14,15", "%R0.O=0,0,0,0,11,11 %R0.E=100001",
    ),
    # a block's own section: all its pins at once, R before CU, and its outputs in the same scan
    case("neza", "%C0: P=1; BLK %C0; LD %I0.1; R; LD %I0.0; CU; END_BLK", "%I0.0=0101 %I0.1=0001", "%C0.V=0,1,1,0"),
    case("neza", "%C0: P=1; BLK %C0; LD %I0.0; CU; OUT_BLK; LD D; ST %Q0.0; END_BLK", "%I0.0=0101", "%Q0.0=0110"),
    # words in brackets, where the accumulator is 1
    case("neza", "LD %I0.0; [ %MW0 := %MW1 - 5 ]; LD [%MW0 > 10]; ST %Q0.0", "%I0.0=0101 %MW1=20,20,15,15", "%MW0=0,15,15,10 %Q0.0=0110"),
    # rows of bits
    case("s7-200", "LD I0.0; EU; SHRB I0.1, V100.0, 4", "I0.0=010101 I0.1=011000", "V100.0=011000 V100.1=000110 V100.2=000001"),
    *(
        case("fx", f"LD X0; SFTL{p} X1 M0 K4 K1", "X0=01101 X1=11000", wanted)
        for p, wanted in (("", "M0=01000 M1=00110 M2=00001"), ("P", "M0=01110 M1=00001"))
    ),
    *(
        case("fx", f"LD X0; SFTR{p} X1 M0 K4 K1", "X0=01101 X1=11000", wanted)
        for p, wanted in (("", "M3=01000 M2=00110 M1=00001"), ("P", "M3=01110 M2=00001"))
    ),
    *(
        case("fx", f"LD X0; ZRST{p} M0 M2", "X0=0110 M0=1,1,1,1 M1=1,1,1,1 M2=1,1,1,1 M3=1,1,1,1", wanted)
        for p, wanted in (("", "M0=1001 M1=1001 M2=1001 M3=1111"), ("P", "M0=1011 M2=1011 M3=1111"))
    ),
    # comparisons into three bits; with P only where the power comes
    *(
        case("fx", f"LD X0; {d}CMP{p} D0 D2 M0", "X0=011111 D0=1,1,2,3,-1,0 D2=2,2,2,2,0,0 D1=0,0,0,0,-1,0", wanted)
        for d in ("", "D")
        for p, wanted in (("", "M0=000100 M1=001001 M2=010010"), ("P", "M0=000000 M1=000000 M2=011111"))
    ),
    *(
        case("fx", f"LD X0; {d}ZCP{p} D0 D2 D4 M0", f"D0=3, D2=5, {given}", wanted)
        for d in ("", "D")
        for p, given, wanted in (
            ("", "X0=0111111 D4=2,2,3,4,5,6,-1 D5=0,0,0,0,0,0,-1", "M0=0100001 M1=0011100 M2=0000010"),
            ("P", "X0=0101011 D4=4,4,4,6,4,2,4", "M0=0000011 M1=0110000 M2=0001100"),
        )
    ),
    # where the program goes on
    case("s7-200", "LD I0.0; JMP 1; LD I0.1; = Q0.0; LBL 1; LD I0.1; = Q0.1", "I0.0=0110 I0.1=1010", "Q0.0=1110 Q0.1=1010"),
    case("s7-200", "LD I0.0; FOR VW0, 1, 5; LD SM0.0; INCW VW2; NEXT", "I0.0=0110", "VW2=0,5,10,10"),
    case("s7-200", "LD I0.0; CALL SBR0\nSUBROUTINE_BLOCK SBR_0:SBR0\nLD I0.1; CRET; LD SM0.0; = Q0.1; RET; = Q0.2\nEND_SUBROUTINE_BLOCK", "I0.0=0011 I0.1=0110", "Q0.1=0001 Q0.2=0000"),
    case("s7-200", "LD I0.0; END; LD I0.1; = Q0.0", "I0.0=0110 I0.1=1100", "Q0.0=1110"),
    case("s7-200", "LD I0.0; = Q0.0; MEND; LD I0.0; = Q0.1", "I0.0=01", "Q0.0=01 Q0.1=00"),
    case("s7-200", "LD I0.0; STOP; LD I0.1; = Q0.0", "I0.0=0100 I0.1=1011", "Q0.0=1000"),
    case(
        "s7-200", "LSCR S0.1; LD SM0.0; = Q0.0; LD I0.0; SCRT S0.2; SCRE; LD I0.1; = Q0.2; "
        "LSCR S0.2; LD SM0.0; = Q0.1; LD I0.2; CSCRE; LD SM0.0; = Q0.3; SCRE",
        "S0.1=1 I0.0=0100 I0.1=1110 I0.2=0010", "S0.1=1000 S0.2=0111 Q0.0=1100 Q0.1=0111 Q0.2=1110 Q0.3=0101",
    ),
    case("s7-200", "LD I0.0; /I VW0, VW2; AENO; = Q0.0", "I0.0=0111 VW0=1,1,0,1 VW2=9,9,9,9", "Q0.0=0101"),
    case("fx", "LD X0; MC N0 M100; LD X1; OUT Y0; MCR N0; LD X2; OUT Y1", "X0=0110 X1=1011 X2=1001", "M100=0110 Y0=0010 Y1=1001"),
    case(
        "fx", "LD M8002; SET S0; STL S0; LD X0; SET S20; STL S20; LD M8000; OUT Y0; RET; LD X1; OUT Y1",
        "X0=010 X1=101", "S0=100 S20=011 Y0=011 Y1=101",
    ),
    case("fx", "LD X0; OUT Y0; END; LD X0; OUT Y1", "X0=01", "Y0=01 Y1=00"),
    case("neza", "LD %I0.0; JMPC %L1; LD %I0.1; ST %Q0.0; %L1:; LD %I0.1; ST %Q0.1", "%I0.0=0110 %I0.1=1010", "%Q0.0=1110 %Q0.1=1010"),
    case("neza", "LD %I0.0; JMPCN %L1; LD %I0.1; ST %Q0.0; JMP %L2; %L1:; LD %I0.1; ST %Q0.1; %L2:; LD %I0.1; ST %Q0.2", "%I0.0=1001 %I0.1=1010", "%Q0.0=1110 %Q0.1=0011 %Q0.2=1010"),
    case("neza", "LD %I0.0; SR1; END; SR1:; LD %I0.1; ST %Q0.0; RET; LD 1; ST %Q0.1", "%I0.0=0110 %I0.1=1110", "%Q0.0=0111 %Q0.1=0000"),
    case("neza", "LD %I0.0; ENDC; LD %I0.1; ENDCN; LD %I0.2; ST %Q0.0; END; LD 1; ST %Q0.1", "%I0.0=0100 %I0.1=1101 %I0.2=1000", "%Q0.0=1110 %Q0.1=0000"),
)  # fmt: skip


# Comparisons, worked out by Python; each relation meets less, equal and more, and words that only a sign tells apart.

PAIRS = {
    "B": ((5, 7), (7, 7), (200, 7), (7, 200)),
    "W": ((5, 7), (7, 7), (9, 7), (-5, 7), (7, -5)),
    "D": ((5, 100_000), (100_000, 100_000), (100_000, 5), (-100_000, 5), (5, -100_000)),
    "R": ((0.5, 1.5), (1.5, 1.5), (1.5, 0.5), (-1.5, -0.5), (-0.5, -1.5)),
}
JOINED = {"LD": lambda _, found: found, "A": lambda a, found: a and found, "O": lambda a, found: a or found}
JOINED |= {"AND": JOINED["A"], "OR": JOINED["O"]}


def bits_of(number: float) -> int:
    return int(struct.unpack(">i", struct.pack(">f", number))[0])


def halves(register: str, number: int, size: int) -> dict[str, int]:
    """Give what one register, or two of 16 bits, hold for a number."""
    if size == 16:
        return {register: number}
    low, high = number & 0xFFFF, number >> 16
    return {register: low - (low >> 15 << 16), f"D{int(register[1:]) + 1}": high}


def comparisons() -> Iterator[Case]:
    """Give a case for every comparing contact of every family."""
    for family, area, letters in (("s7-200", "V", "BWDR"), ("gutta", "M", "BWD")):
        for prefix, letter, relation in ((a, b, c) for a in ("LD", "A", "O") for b in letters for c in RELATIONS):
            one, other = (f"{area}{'D' if letter == 'R' else letter}{place}" for place in (0, 8))
            head = "" if prefix == "LD" else "LD I0.0; "
            yield compared(
                family,
                f"{head}{prefix}{letter}{relation} {one}, {other}; = Q0.0",
                (prefix, letter, relation),
                ("I0.0", one, other, "Q0.0"),
            )
    for prefix, d, relation in ((a, b, c) for a in ("LD", "AND", "OR") for b in ("", "D") for c in RELATIONS):
        head = "" if prefix == "LD" else "LD X0; "
        yield compared(
            "fx", f"{head}{prefix}{d}{relation} D0 D4; OUT Y0", (prefix, d or "W", relation), ("X0", "D0", "D4", "Y0")
        )


def compared(family: str, text: str, which: tuple[str, str, str], places: tuple[str, str, str, str]) -> Case:
    prefix, letter, relation = which
    given, one, other, output = places
    rows, wanted = [], []
    for a, b in PAIRS[letter]:
        for bit in (0, 1):
            numbers = [bits_of(number) if letter == "R" else number for number in (a, b)]
            if family == "fx":
                words = halves(one, numbers[0], 32 if letter == "D" else 16) | halves(
                    other, numbers[1], 32 if letter == "D" else 16
                )
            else:
                words = dict(zip((one, other), numbers, strict=True))
            rows.append({given: bit} | words)
            wanted.append(int(JOINED[prefix](bit, RELATIONS[relation](a, b))))
    return Case(family, text, tuple(rows), ((output, tuple(wanted)),))


# Words worked out from words: nothing without power, then the result.


def siemens(family: str, area: str, mnemonic: str, letters: str, before: tuple[int, ...], after: int) -> Case:
    """Give the case of an instruction on IN and OUT (or on OUT alone), which are words of these widths."""
    places = [f"{area}{letter}{12 * at}" for at, letter in enumerate(letters)]
    given = dict(zip(places, before, strict=True))
    rows = ({"I0.0": 0, **given}, {"I0.0": 1})
    return Case(family, f"LD I0.0; {mnemonic} {', '.join(places)}", rows, ((places[-1], (before[-1], after)),))


SUMS = {
    "+": (operator.add, 3.5),
    "-": (operator.sub, 2.5),
    "*": (operator.mul, 1.5),
    "/": (lambda a, b: int(a / b), 6.0),
}
BITS = {"AND": 8, "OR": 14, "XOR": 6}
BELOW = {"B": 8, "W": 16, "D": 32}


def read_as(value: int, letter: str) -> int:
    """Read bits as a byte, which has no sign, or as a word, which has one."""
    size = BELOW[letter]
    return value - (value >> (size - 1) << size) if letter != "B" else value


def rolled(word: str, letter: str, value: int) -> Case:
    """Shift or turn a word by two places, as a string of bits; the bit that falls out last stands in SM1.1."""
    text = f"{value:0{BELOW[letter]}b}"
    after = {"SL": text[2:] + "00", "SR": "00" + text[:-2], "RL": text[2:] + text[:2], "RR": text[-2:] + text[:-2]}[
        word
    ]
    place, out = f"V{letter}0", int(text[1] if word[1] == "L" else text[-2])
    before, shifted = read_as(value, letter), read_as(int(after, 2), letter)
    rows = ({"I0.0": 0, place: before, "SM1.1": 1 - out}, {"I0.0": 1})
    return Case(
        "s7-200", f"LD I0.0; {word}{letter} {place}, 2", rows, ((place, (before, shifted)), ("SM1.1", (1 - out, out)))
    )


def words_of_siemens() -> Iterator[Case]:
    for family, area, letters in (("s7-200", "V", "WD"), ("gutta", "M", "W")):
        for letter in letters:
            for sign, (whole, _) in SUMS.items():
                first = 100 if letter == "W" else 100_000
                yield siemens(
                    family, area, f"{sign}{'I' if letter == 'W' else letter}", letter * 2, (-7, first), whole(first, -7)
                )
        for letter in "BWD":
            yield siemens(family, area, f"MOV{letter}", letter * 2, (7, 100), 7)
    one = ("s7-200", "V")
    for sign, (_, real) in SUMS.items():
        yield siemens(*one, f"{sign}R", "DD", (bits_of(0.5), bits_of(3.0)), bits_of(real))
    yield siemens(*one, "MOVR", "DD", (bits_of(0.5), bits_of(3.0)), bits_of(0.5))
    yield siemens(*one, "MUL", "WD", (300, (5 << 16) + 400), 120_000)
    yield siemens(*one, "DIV", "WD", (7, (5 << 16) + 100), (2 << 16) + 14)
    yield siemens(*one, "SQRT", "DD", (bits_of(9.0), 0), bits_of(3.0))
    for letter, size in BELOW.items():
        yield siemens(*one, f"INC{letter}", letter, (7,), 8)
        yield siemens(*one, f"DEC{letter}", letter, (7,), 6)
        yield siemens(*one, f"INV{letter}", letter, (7,), 248 if letter == "B" else -8)
        for word, result in BITS.items():
            yield siemens(*one, f"{word}{letter}", letter * 2, (10, 12), result)
        for word in ("SL", "SR", "RL", "RR"):
            yield rolled(word, letter, 0b1101_0110 << size - 8 | 0b1001)
    yield siemens(*one, "BTI", "BW", (200, 0), 200)
    yield siemens(*one, "ITB", "WB", (200, 1), 200)
    yield siemens(*one, "ITB", "WB", (300, 1), 1)
    yield siemens(*one, "ITD", "WD", (-5, 0), -5)
    yield siemens(*one, "DTI", "DW", (-5, 0), -5)
    yield siemens(*one, "DTI", "DW", (70_000, 1), 1)
    yield siemens(*one, "DTR", "DD", (3, 0), bits_of(3.0))
    yield siemens(*one, "ROUND", "DD", (bits_of(2.7), 0), 3)
    yield siemens(*one, "TRUNC", "DD", (bits_of(2.7), 0), 2)


def moves_of_siemens() -> Iterator[Case]:
    """A move and a widening leave the flags alone; a narrowing says whether there was room."""
    for family, area in (("s7-200", "V"), ("gutta", "M")):
        for mnemonic, one, other in (
            ("MOVB", "B", "B"),
            ("MOVW", "W", "W"),
            ("MOVD", "D", "D"),
            ("MOVR", "D", "D"),
            ("BTI", "B", "W"),
            ("ITD", "W", "D"),
        ):
            if family == "s7-200" or mnemonic in {"MOVB", "MOVW", "MOVD"}:
                yield case(family, f"LD I0.0; {mnemonic} {area}{one}0, {area}{other}8", "I0.0=01 SM1.1=1,", "SM1.1=11")


MITSUBISHI = {
    "MOV": (("D0",), lambda a, _: (a, 0)),
    "ADD": (("D0", "D4"), lambda a, b: (a + b, 0)),
    "SUB": (("D0", "D4"), lambda a, b: (a - b, 0)),
    "MUL": (("D0", "D4"), lambda a, b: (a * b, 0)),
    "DIV": (("D0", "D4"), divmod),
}
"""What stands before the target, and what comes into it from 100 (100,000) or twice that, and 7."""


def words_of_mitsubishi() -> Iterator[Case]:
    for word, (places, meaning) in MITSUBISHI.items():
        for d in ("", "D") if word in {"MOV", "ADD", "SUB"} else ("",):
            for p in ("", "P"):
                size, first = (32, 100_000) if d else (16, 100)
                results = [meaning(first, 7), meaning(first if p else 2 * first, 7)]
                rows = (
                    {"X0": 0, **halves("D0", first, size), **halves("D4", 7, size)},
                    {"X0": 1},
                    {"X0": 1, **halves("D0", 2 * first, size)},
                )
                low = [halves("D8", result, 32)["D8"] for result, _ in results]
                high = [
                    rest if word == "DIV" else result >> 16 if d or word == "MUL" else 0 for result, rest in results
                ]
                yield Case(
                    "fx", f"LD X0; {d}{word}{p} {' '.join(places)} D8", rows, (("D8", (0, *low)), ("D9", (0, *high)))
                )
    for word, step in (("INC", 1), ("DEC", -1)):
        for d in ("", "D"):
            for p in ("", "P"):
                low = halves("D0", step, 32)["D0"]
                twice = step if p else 2 * step
                yield Case(
                    "fx",
                    f"LD X0; {d}{word}{p} D0",
                    ({"X0": 0}, {"X0": 1}, {"X0": 1}),
                    (
                        ("D0", (0, low, halves("D0", twice, 32)["D0"])),
                        ("D1", (0, step >> 16, twice >> 16) if d else (0, 0, 0)),
                    ),
                )


CASES = (*BY_HAND, *comparisons(), *words_of_siemens(), *moves_of_siemens(), *words_of_mitsubishi())


@cache
def uses(one: Case) -> frozenset[str]:
    """Give the rows that a program uses."""
    return frozenset(line.insn.mnemonic for line in read(one.text, one.family).lines)


@pytest.mark.parametrize("one", CASES, ids=str)
def test_the_true_table_gives_what_is_wanted(one: Case) -> None:
    assert not [found for found in read(one.text, one.family).diagnostics if found.severity == "error"]
    trace = run(read(one.text, one.family), one.rows, scan_ms=one.ms)
    assert {address: shown(trace, address) for address, _ in one.wanted} == dict(one.wanted)


# The wrong rows.


def wrong_conditions(verb: Verb) -> Iterator[Verb]:
    """Act where there is no power; without the edge; at the other edge."""
    if verb.formula:
        yield replace(verb, formula=Not(verb.formula))
    if verb.formula == parse_formula("rise(a)"):
        yield replace(verb, formula=parse_formula("a"))
        yield replace(verb, formula=parse_formula("fall(a)"))


def wrong_pins(verb: Verb) -> Iterator[Verb]:
    """Turn each pin round; exchange them."""
    for at, (name, formula) in enumerate(verb.pins):
        yield replace(verb, pins=(*verb.pins[:at], (name, Not(formula)), *verb.pins[at + 1 :]))
    formulas = [formula for _, formula in verb.pins]
    for order in permutations(formulas):
        if list(order) != formulas:
            yield replace(
                verb, pins=tuple((name, formula) for (name, _), formula in zip(verb.pins, order, strict=True))
            )


COUNTERS = ("up", "down", "updown", "upto")
COMMUTE = {"add", "mul", "and", "or", "xor", "radd", "rmul", "sum", "product"}
THE_SAME = {("/I", "divmod"), ("*I", "mul16"), ("SRB", "ror16"), ("SRB", "ror32")}
"""Rules that give the same in so narrow a word."""


def wrong_rules(family: Dialect, row: Insn, verb: Verb) -> Iterator[str]:
    """Give the rules that the verb might have been given instead, among those that the family has."""
    match verb.name:
        case "drive" if verb.op in DRIVES:
            yield from {*DRIVES} - {verb.op} - ({"on"} if verb.op == "retentive" else set())  # its number makes it so
        case "drive":
            yield from {*COUNTERS} - {verb.op}
        case "pin":
            area = next(iter(family.kinds[row.operands[0].kind].areas))
            yield from {*next(block.pins for block in family.blocks if block.area == area)} - {verb.op}
        case "shift":
            yield from {other.op for one in family.insns for other in one.then if other.name == "shift"} - {verb.op}
        case "work" if verb.op in RULES:
            alike = {
                other.op
                for one in family.insns
                for other in one.then
                if other.name == "work" and len(other.sources) == len(verb.sources)
            }
            for op in sorted(alike & set(RULES) - {verb.op}):
                shifts = op.rstrip("0123456789") == verb.op.rstrip("0123456789") and verb.op[:2] in {"sh", "ro"}
                if not shifts and (row.mnemonic, op) not in THE_SAME:
                    yield op


def wrong_verbs(family: Dialect, row: Insn, verb: Verb) -> Iterator[Verb | None]:
    """Do nothing; under another condition; by another rule; with other pins, or with the sources exchanged."""
    yield None
    yield from wrong_conditions(verb)
    yield from wrong_pins(verb)
    yield from (replace(verb, op=op) for op in wrong_rules(family, row, verb))
    if len(verb.sources) > 1 and verb.op not in COMMUTE:
        yield from (replace(verb, sources=order) for order in permutations(verb.sources) if order != verb.sources)


def wrong_rows(family: Dialect, row: Insn) -> Iterator[tuple[str, Insn]]:
    """Give a row in all the ways in which it could be wrong, each with its name."""
    for at, verb in enumerate(row.then):
        for other in wrong_verbs(family, row, verb):
            then = (*row.then[:at], *((other,) if other else ()), *row.then[at + 1 :])
            yield f"{verb.name} -> {other}", replace(row, then=then)
    for at, operand in enumerate(row.operands):
        for relation in RELATIONS if operand.relation else ():
            if relation != operand.relation:
                wrong = replace(operand, relation=relation)
                yield (
                    f"relation {relation}",
                    replace(row, operands=(*row.operands[:at], wrong, *row.operands[at + 1 :])),
                )
    for what in ("effect", "fresh"):
        effect = getattr(row, what)
        for changed in turned(effect.text) if effect else ():
            yield f"{what} {changed}", replace(row, **{what: parse_effect(changed)})


ROWS = [(family, row.mnemonic) for family in FAMILIES for row in dialect(family).insns if beyond_bits(row)]


@pytest.mark.parametrize(("family", "mnemonic"), ROWS)
def test_every_wrong_row_is_noticed(family: str, mnemonic: str) -> None:
    true = dialect(family)
    mine = [one for one in CASES if one.family == family and mnemonic in uses(one)]
    assert mine, "no case uses this row"
    unseen = [
        name
        for name, row in wrong_rows(true, true.words[mnemonic])
        if all(one.holds(table_with(true, row)) for one in mine)
    ]
    assert unseen == []


def test_there_are_many() -> None:
    assert (
        sum(1 for family, mnemonic in ROWS for _ in wrong_rows(dialect(family), dialect(family).words[mnemonic]))
        > 2_000
    )
