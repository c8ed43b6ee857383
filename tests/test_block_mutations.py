"""Wrong rows of timers, counters, blocks, words and the program's course are noticed: each row is changed, and a case tells.

Every expectation is a literal after the notes on the four families, or is worked out by Python's own operators; the true tables
give them all. A row is changed in every way of its kind: another rule, other pins or sources, another relation, another
condition, or nothing done at all. Only the cases that use the row are run, so no sampling is needed.
"""

from __future__ import annotations

import operator
import re
import struct
from dataclasses import dataclass, replace
from functools import cache
from itertools import permutations
from typing import TYPE_CHECKING, Any

import pytest

from plcteach.core.effect import Not
from plcteach.core.notation import parse_effect, parse_formula
from plcteach.dialects import dialect
from plcteach.machine import run
from plcteach.machine.sums import RULES
from plcteach.machine.timers import DRIVES
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect
    from plcteach.core.verb import Verb

FAMILIES = ("s7-200", "fx", "neza", "gutta")


@dataclass(frozen=True)
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
    case("s7-200", "LD I0.0; TONR T5, 3; LD T5; = Q0.0", "I0.0=01101110", "Q0.0=00000011 T5.V=0,0,1,1,1,2,3,3", 100),
    case("s7-200", "LD I0.0; TOF T38, 3; LD T38; = Q0.0", "I0.0=0110000", "Q0.0=0111110 T38.V=0,0,0,0,1,2,3", 100),
    case("gutta", "LD I0.0; TON T37, 3; LD T37; = Q0.0", "I0.0=0111110", "Q0.0=0000110 T37.V=0,0,1,2,3,4,0", 100),
    case("gutta", "LD I0.0; TONR T5, 3; LD T5; = Q0.0", "I0.0=01101110", "Q0.0=00000011 T5.V=0,0,1,1,1,2,3,3", 100),
    case("gutta", "LD I0.0; TOF T38, 3; LD T38; = Q0.0", "I0.0=0110000", "Q0.0=0111110 T38.V=0,0,0,0,1,2,3", 100),
    case("fx", "LD X0; OUT T0 K3; LD T0; OUT Y0", "X0=0111110", "Y0=0000110 T0.V=0,0,1,2,3,3,0", 100),
    case("neza", "%TM0: TB=100ms P=3; LD %I0.0; IN %TM0; LD %TM0.Q; ST %Q0.0", "%I0.0=0111110", "%Q0.0=0000110 %TM0.V=0,0,1,2,3,3,0", 100),
    # counters: edges only, the preset, the ends, both ways
    case("s7-200", "LD I0.0; LD I0.1; CTU C0, 2; LD C0; = Q0.0", "I0.0=0101010 I0.1=0000001", "Q0.0=0001110 C0.V=0,1,1,2,2,3,0"),
    case("s7-200", "LD I0.0; LD I0.1; CTU C0, 2", "I0.0=01 I0.1=00 C0=32767,", "C0.V=32767,32767"),
    case("s7-200", "LD I0.0; LD I0.1; CTD C1, 2; LD C1; = Q0.0", "I0.0=0001010 I0.1=0100000", "Q0.0=1000011 C1.V=0,2,2,1,1,0,0"),
    case("s7-200", "LD I0.0; LD I0.1; LD I0.2; CTUD C2, 2; LD C2; = Q0.0", "I0.0=01010000 I0.1=00000100 I0.2=00000001", "Q0.0=00011000 C2.V=0,1,1,2,2,1,1,0"),
    case("s7-200", "LD I0.0; LD I0.1; LD I0.2; CTUD C2, 2", "I0.0=01 I0.1=00 I0.2=00 C2=32767,", "C2.V=32767,-32768"),
    case("gutta", "Network 1\nLD I0.0; LD I0.1; CTU C0, 2\nNetwork 2\nLD C0; = Q0.0", "I0.0=0101010 I0.1=0000001", "Q0.0=0001110 C0.V=0,1,1,2,2,3,0"),
    case("gutta", "LD I0.0; LD I0.1; CTU C0, 2", "I0.0=01 I0.1=00 C0=32767,", "C0.V=32767,32767"),
    case("gutta", "Network 1\nLD I0.0; LD I0.1; CTD C1, 2\nNetwork 2\nLD C1; = Q0.0", "I0.0=0001010 I0.1=0100000", "Q0.0=1000011 C1.V=0,2,2,1,1,0,0"),
    case("gutta", "Network 1\nLD I0.0; LD I0.1; LD I0.2; CTUD C2, 2\nNetwork 2\nLD C2; = Q0.0", "I0.0=01010000 I0.1=00000100 I0.2=00000001", "Q0.0=00011000 C2.V=0,1,1,2,2,1,1,0"),
    case("gutta", "LD I0.0; LD I0.1; LD I0.2; CTUD C2, 2", "I0.0=01 I0.1=00 I0.2=00 C2=32767,", "C2.V=32767,-32768"),
    case("fx", "LD X0; OUT C0 K2; LD C0; OUT Y0; LD X1; RST C0", "X0=01010101 X1=00000010", "Y0=00011110 C0.V=0,1,1,2,2,2,0,1"),
    case(
        "neza", "%C0: P=3; LD %I0.0; CU %C0; LD %I0.1; CD %C0; LD %I0.2; S %C0; LD %I0.3; R %C0; LD %C0.D; ST %Q0.0",
        "%I0.0=0101000 %I0.1=0000100 %I0.2=0000010 %I0.3=0000001", "%C0.V=0,1,1,2,1,3,0 %Q0.0=0000010",
    ),
    # a drum, a shift register, a step counter, a queue
    case(
        "neza", "%DR0: OUT=%Q0.0,%Q0.1 STEPS=00,10,01; LD %I0.0; U %DR0; LD %I0.1; R %DR0",
        "%I0.0=01010 %I0.1=00001", "%DR0.S=0,1,1,2,0 %Q0.0=01100 %Q0.1=00010",
    ),
    case(
        "neza", "LD %I0.3; S %SBR0.0; LD %I0.0; CU %SBR0; LD %I0.1; CD %SBR0; LD %I0.2; R %SBR0",
        "%I0.3=10000 %I0.0=01010 %I0.1=00100 %I0.2=00001", "%SBR0.0=10100 %SBR0.1=01010",
    ),
    case(
        "neza", "LD %I0.0; CU %SC0; LD %I0.1; CD %SC0; LD %I0.2; R %SC0",
        "%I0.0=0101000 %I0.1=0000100 %I0.2=0000001", "%SC0.0=1000001 %SC0.1=0110110 %SC0.2=0001000",
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
        for p, wanted in (("", "M0=01000 M1=00110 M2=00001"), ("P", "M0=01100 M1=00001"))
    ),
    *(
        case("fx", f"LD X0; SFTR{p} X1 M0 K4 K1", "X0=01101 X1=11000", wanted)
        for p, wanted in (("", "M3=01000 M2=00110 M1=00001"), ("P", "M3=01100 M2=00001"))
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
        case("fx", f"LD X0; {d}ZCP{p} D0 D2 D4 M0", "X0=0111111 D0=3, D2=5, D4=2,2,3,4,5,6,-1 D5=0,0,0,0,0,0,-1", wanted)
        for d in ("", "D")
        for p, wanted in (("", "M0=0100001 M1=0011100 M2=0000010"), ("P", "M0=0111111 M1=0000000 M2=0000000"))
    ),
    # where the program goes on
    case("s7-200", "LD I0.0; JMP 1; LD I0.1; = Q0.0; LBL 1; LD I0.1; = Q0.1", "I0.0=0110 I0.1=1001", "Q0.0=1111 Q0.1=1001"[:9] + " Q0.1=1001"),
    case("s7-200", "LD I0.0; FOR VW0, 1, 5; LD SM0.0; INCW VW2; NEXT", "I0.0=0110", "VW2=0,5,10,10"),
    case("s7-200", "LD I0.0; CALL SBR0\nSUBROUTINE_BLOCK SBR_0:SBR0\nLD I0.1; CRET; LD SM0.0; = Q0.1; RET; = Q0.2\nEND_SUBROUTINE_BLOCK", "I0.0=0011 I0.1=0110", "Q0.1=0001 Q0.2=0000"),
    case("s7-200", "LD I0.0; END; LD I0.1; = Q0.0", "I0.0=0110 I0.1=1100", "Q0.0=1110"),
    case("s7-200", "LD I0.0; = Q0.0; MEND; LD I0.0; = Q0.1", "I0.0=01", "Q0.0=01 Q0.1=00"),
    case("s7-200", "LD I0.0; STOP; LD I0.1; = Q0.0", "I0.0=010 I0.1=001", "Q0.0=000"),
    case(
        "s7-200", "LSCR S0.1; LD SM0.0; = Q0.0; LD I0.0; SCRT S0.2; SCRE; LD I0.1; = Q0.2; "
        "LSCR S0.2; LD SM0.0; = Q0.1; LD I0.2; CSCRE; LD SM0.0; = Q0.3; SCRE",
        "S0.1=1 I0.0=0100 I0.1=1110 I0.2=0010", "S0.1=1000 S0.2=0111 Q0.0=1100 Q0.1=0111 Q0.2=1110 Q0.3=0101",
    ),
    case("s7-200", "LD I0.0; /I VW0, VW2; AENO; = Q0.0", "I0.0=0111 VW0=1,1,0,1 VW2=9,9,9,9", "Q0.0=0101"),
    case("fx", "LD X0; MC N0 M100; LD X1; OUT Y0; MCR N0; LD X2; OUT Y1", "X0=0110 X1=1011 X2=1001", "M100=0110 Y0=0010 Y1=1001"),
    case(
        "fx", "LD M8002; SET S0; STL S0; LD X0; SET S20; STL S20; LD M8000; OUT Y0; RET; LD X1; OUT Y1",
        "X0=010 X1=101", "S0=110 S20=011 Y0=011 Y1=101",
    ),
    case("neza", "LD %I0.0; JMPC %L1; LD %I0.1; ST %Q0.0; %L1:; LD %I0.1; ST %Q0.1", "%I0.0=0110 %I0.1=1001", "%Q0.0=1111 %Q0.1=1001"),
    case("neza", "LD %I0.0; JMPCN %L1; LD %I0.1; ST %Q0.0; JMP %L2; %L1:; LD %I0.1; ST %Q0.1; %L2:; LD %I0.1; ST %Q0.2", "%I0.0=1001 %I0.1=1010", "%Q0.0=1110 %Q0.1=0010 %Q0.2=1010"),
    case("neza", "LD %I0.0; SR1; END; SR1:; LD %I0.1; ST %Q0.0; RET; LD 1; ST %Q0.1", "%I0.0=0110 %I0.1=1110", "%Q0.0=0110 %Q0.1=0000"),
    case("neza", "LD %I0.0; ENDC; LD %I0.1; ENDCN; LD %I0.2; ST %Q0.0; END; LD 1; ST %Q0.1", "%I0.0=0101 %I0.1=1101 %I0.2=1010", "%Q0.0=1110 %Q0.1=0000"),
)  # fmt: skip
