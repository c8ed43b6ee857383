"""Wrong instructions are noticed: each family's table is changed in one place, and a book's figure or a small ladder tells.

The expectations are the books' sentences and figures and the Boolean meaning of ladders, written here as literals; a mutant that
passes them all would be a mistake that nobody would see. The true tables pass them all. Rows of blocks, words and jumps have
cases of their own, in test_block_mutations.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise, product
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from plcteach.core.notation import parse_effect, parse_formula
from plcteach.core.verb import Verb
from plcteach.dialects import dialect
from plcteach.machine import run
from plcteach.machine.formula import name, written
from plcteach.machine.step import step
from plcteach.stl import read

sys.path.insert(0, str(Path(__file__).parent / "machine"))
from wrong_rows import beyond_bits, table_with, turned

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time

if TYPE_CHECKING:
    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect

# What the oracles look at: figures as names, programs as values.


class Names:
    """A PLC in which every bit is its own name; blocks and words are passed over."""

    spells = True
    rail = None

    def read(self, _operand: object, address):
        return name(address.text)

    def past(self, _address: object, value):
        return value, None

    def following(self, address, _count: int):
        return (address,)


def figure(family: Dialect, text: str, *before: str) -> list[str]:
    """Execute one instruction on named cells (a string for each stack, top first) and give the cells after it."""
    line = read(text, family).lines[0]
    stacks = tuple(tuple(map(name, cells.split())) for cells in before)
    one = step(line, family.shapes, stacks, Names(), name("x"))  # type: ignore[type-var]
    return [" ".join(map(written, cells)) for cells in one.after]


def gives(family: Dialect, text: str, *scans: dict[str, int]) -> Callable[[str], str]:
    """Run a program and give what it shows at an address, scan by scan."""
    program = read(text.replace("/", "\n"), family)
    return run(program, list(scans)).__getitem__


def means(family: Dialect, text: str, output: str, inputs: str, meaning: Callable[..., int]) -> bool:
    """Say whether an output is what a formula says for all values of some inputs."""
    names = inputs.split()
    return all(
        gives(family, text, dict(zip(names, bits, strict=True)))(output) == str(int(meaning(*bits)))
        for bits in product((0, 1), repeat=len(names))
    )


def shows(family: Dialect, text: str, output: str, wanted: str, **inputs: str) -> bool:
    """Say whether an output is a word over some scans, each input being a word too."""
    scans = [
        {key.replace("_", ".").replace("p", "%"): int(word[at]) for key, word in inputs.items()}
        for at in range(len(wanted))
    ]
    return gives(family, text, *scans)(output) == wanted


def edged(
    family: Dialect, text: str, output: str, bit: str, beside: str, letter: str, op: Callable[[int, int], int]
) -> bool:
    """Say whether an output is what a value beside and a rising (P, R) or falling (F) edge give; no edge in the first scan."""
    bits, values = "1001101010011000", "1010110010101101"
    edges = [0] + [int(now != old and now == ("0" if letter == "F" else "1")) for old, now in pairwise(bits)]
    wanted = "".join(str(op(int(value), edge)) for value, edge in zip(values, edges, strict=True))
    scans = [{bit: int(one), beside: int(value)} for one, value in zip(bits, values, strict=True)]
    assert {(one, value, edge) for one, value, edge in zip(bits, values, edges, strict=True)} >= {
        ("0" if letter == "F" else "1", "0", 1), ("0" if letter == "F" else "1", "1", 1), ("1", "1", 0), ("0", "1", 0), ("0", "0", 0),
    }  # fmt: skip
    return gives(family, text, *scans)(output) == wanted


NINE = "iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8"


def s7_200(f: Dialect) -> Iterator[bool]:
    """000, figures 6 and 7 and its sentences on LPS, LRD and LPP; 002, figure 2-35; the meaning of small ladders."""
    yield figure(f, "OLD", "S1 S0 iv0 iv1 iv2 iv3 iv4 iv5 iv6") in (
        ["S1+S0 iv0 iv1 iv2 iv3 iv4 iv5 iv6 x"], ["S0+S1 iv0 iv1 iv2 iv3 iv4 iv5 iv6 x"],
    )  # fmt: skip
    yield figure(f, "ALD", "S1 S0 iv0 iv1 iv2 iv3 iv4 iv5 iv6") in (
        ["S1·S0 iv0 iv1 iv2 iv3 iv4 iv5 iv6 x"], ["S0·S1 iv0 iv1 iv2 iv3 iv4 iv5 iv6 x"],
    )  # fmt: skip
    yield figure(f, "LDS 3", NINE) == ["iv3 iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7"]
    yield figure(f, "LDS 0", NINE) == ["iv0 iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7"]
    yield figure(f, "LPS", NINE) == ["iv0 iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7"]
    yield figure(f, "LRD", NINE) == ["iv1 iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8"]
    yield figure(f, "LPP", NINE) == ["iv1 iv2 iv3 iv4 iv5 iv6 iv7 iv8 x"]
    yield figure(f, "LD I0.0", NINE) == ["I0.0 iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7"]
    yield figure(f, "LDN I0.0", NINE) == ["/I0.0 iv0 iv1 iv2 iv3 iv4 iv5 iv6 iv7"]
    for text in ("= Q0.0", "S Q0.0, 1", "R Q0.0, 1", "NOP 0", "=I Q0.0"):
        yield figure(f, text, NINE) == [NINE]
    three = "I0.0 I0.1 I0.2"
    yield means(f, "LD I0.0/A I0.1/O I0.2/= Q0.0", "Q0.0", three, lambda a, b, c: a & b | c)
    yield means(f, "LD I0.0/AN I0.1/ON I0.2/= Q0.0", "Q0.0", three, lambda a, b, c: a & (1 - b) | (1 - c))
    yield means(f, "LDI I0.0/AI I0.1/OI I0.2/=I Q0.0", "Q0.0", three, lambda a, b, c: a & b | c)
    yield means(f, "LDNI I0.0/ANI I0.1/ONI I0.2/= Q0.0", "Q0.0", three, lambda a, b, c: (1 - a) & (1 - b) | (1 - c))
    yield means(f, "LD I0.0/O I0.1/NOT/A I0.2/= Q0.0", "Q0.0", three, lambda a, b, c: (1 - (a | b)) & c)
    yield shows(f, "LDN I0.0/= I0.0/LDI I0.0/= Q0.0", "Q0.0", "010", I0_0="010")
    yield shows(f, "LD I0.0/EU/= Q0.0", "Q0.0", "01001", I0_0="01101")
    yield shows(f, "LD I0.0/ED/= Q0.0", "Q0.0", "00010", I0_0="01101")
    yield shows(f, "LD I0.0/S Q0.0, 2/LD I0.1/R Q0.1, 1", "Q0.1", "0110", I0_0="0100", I0_1="0001")
    yield shows(f, "LD I0.0/S Q0.0, 2/LD I0.1/R Q0.1, 1", "Q0.0", "0111", I0_0="0100", I0_1="0001")
    yield shows(f, "LD I0.0/SI Q0.0, 2/LD I0.1/RI Q0.1, 1", "Q0.1", "0110", I0_0="0100", I0_1="0001")


def fx(f: Dialect) -> Iterator[bool]:
    """000, figures 2 to 5 and its sentences on MPS, MRD and MPP; the register first, then the stack."""
    yield figure(f, "ORB", "D C A") in (["C+D A"], ["D+C A"])
    yield figure(f, "ANB", "D A") in (["A·D"], ["D·A"])
    yield figure(f, "MPS", "RR A") == ["RR RR A"]
    yield figure(f, "MRD", "RR B A") == ["B B A"]
    yield figure(f, "MPP", "RR B A") == ["B A"]
    yield figure(f, "OUT Y0", "RR A") == ["RR A"]
    yield means(f, "LD X0/AND X1/LD X2/AND X3/ORB/OUT Y0", "Y0", "X0 X1 X2 X3", lambda a, b, c, d: a & b | c & d)
    fig3 = "LD X0/OR X5/MPS/AND X1/OUT Y0/MRD/AND X2/OUT Y1/MPP/AND X3/OUT Y2"
    for output, at in (("Y0", 2), ("Y1", 3), ("Y2", 4)):
        yield means(f, fig3, output, "X0 X5 X1 X2 X3", lambda *v, at=at: (v[0] | v[1]) & v[at])
    fig4 = "LD X0/MPS/AND X1/MPS/AND X2/OUT Y0/MPP/AND X3/OUT Y1/MPP/AND X4/OUT Y2"
    yield means(f, fig4, "Y0", "X0 X1 X2 X3 X4", lambda a, b, c, _d, _e: a & b & c)
    yield means(f, fig4, "Y1", "X0 X1 X2 X3 X4", lambda a, b, _c, d, _e: a & b & d)
    yield means(f, fig4, "Y2", "X0 X1 X2 X3 X4", lambda a, _b, _c, _d, e: a & e)
    fig5 = "LD X0/OR X2/LD X1/AND X4/LD X3/AND X5/ORB/ANB/OUT Y0"
    yield means(f, fig5, "Y0", "X0 X1 X2 X3 X4 X5", lambda a, b, c, d, e, g: (a | c) & (b & e | d & g))
    yield means(
        f, "LDI X0/ANI X1/ORI X2/INV/OUT Y0", "Y0", "X0 X1 X2", lambda a, b, c: 1 - ((1 - a) & (1 - b) | (1 - c))
    )
    yield means(f, "LD X0/OUT Y0/LDI X1/OUT Y1", "Y1", "X0 X1", lambda _a, b: 1 - b)
    yield means(f, "LD X0/LDI X1/ORB/OUT Y1", "Y1", "X0 X1", lambda a, b: a | (1 - b))
    for letter in "PF":
        for text in (f"LD{letter} X0", f"LD X1/AND X7/LD{letter} X0/ORB"):
            yield edged(f, f"{text}/OUT Y0", "Y0", "X0", "X1", letter, lambda _a, edge: edge)
        yield edged(f, f"LD X1/AND{letter} X0/OUT Y0", "Y0", "X0", "X1", letter, lambda a, edge: a & edge)
        yield edged(f, f"LD X1/OR{letter} X0/OUT Y0", "Y0", "X0", "X1", letter, lambda a, edge: a | edge)
    yield shows(f, "LD X0/AND X1/MEP/OUT Y0", "Y0", "0010", X0="0111", X1="1011")
    yield shows(f, "LD X0/AND X1/MEF/OUT Y0", "Y0", "0001", X0="0110", X1="1011")
    yield shows(f, "LD X0/PLS M0/LD M0/OUT Y0", "Y0", "0100", X0="0110")
    yield shows(f, "LD X0/PLF M0/LD M0/OUT Y0", "Y0", "0001", X0="0110")
    yield shows(f, "LD X0/SET Y0/LD X1/RST Y0", "Y0", "0110", X0="0100", X1="0001")
    yield shows(f, "LD X0/OUT Y0/END/LD X0/OUT Y1", "Y1", "00", X0="11")
    yield shows(f, "LD X0/NOP/OUT Y0", "Y0", "01", X0="01")


def neza(f: Dialect) -> Iterator[bool]:
    """003's rules on the accumulator, parentheses and branches, as the notes give them, on ladders of three contacts."""
    yield figure(f, "MPS", "A", "", "B") == ["A", "", "A B"]
    yield figure(f, "MRD", "A", "", "B C") == ["B", "", "B C"]
    yield figure(f, "MPP", "A", "", "B C") == ["B", "", "C"]
    yield figure(f, "AND( %I0.0", "A", "P", "") == ["%I0.0", "A P", ""]
    yield figure(f, "ST %Q0.0", "A", "P", "B") == ["A", "P", "B"]
    three = "%I0.0 %I0.1 %I0.2"

    def is_(text: str, meaning: Callable[..., int]) -> bool:
        return means(f, f"{text}/ST %Q0.0", "%Q0.0", three, meaning)

    yield is_("LD %I0.0/AND %I0.1/OR %I0.2", lambda a, b, c: a & b | c)
    yield is_("LDN %I0.0/ANDN %I0.1/ORN %I0.2", lambda a, b, c: (1 - a) & (1 - b) | (1 - c))
    yield is_("LD %I0.0/XOR %I0.1/XORN %I0.2", lambda a, b, c: a ^ b ^ (1 - c))
    yield is_("LD %I0.0/OR %I0.1/N/AND %I0.2", lambda a, b, c: (1 - (a | b)) & c)
    yield is_("LD %I0.0/AND( %I0.1/OR %I0.2/)", lambda a, b, c: a & (b | c))
    yield is_("LD %I0.0/OR( %I0.1/AND %I0.2/)", lambda a, b, c: a | b & c)
    yield is_("LD %I0.0/AND(N %I0.1/OR %I0.2/)", lambda a, b, c: a & ((1 - b) | c))
    yield is_("LD %I0.0/OR(N %I0.1/AND %I0.2/)", lambda a, b, c: a | (1 - b) & c)
    yield is_("LD %I0.0/AND(/LD %I0.1/OR %I0.2/)", lambda a, b, c: a & (b | c))
    yield is_("LD %I0.0/OR(/LD %I0.1/AND %I0.2/)", lambda a, b, c: a | b & c)
    tree = "LD %I0.0/MPS/AND %I0.1/ST %Q0.0/MRD/ANDN %I0.1/ST %Q0.1/MPP/AND %I0.2/STN %Q0.2"
    yield means(f, tree, "%Q0.0", three, lambda a, b, _c: a & b)
    yield means(f, tree, "%Q0.1", three, lambda a, b, _c: a & (1 - b))
    yield means(f, tree, "%Q0.2", three, lambda a, _b, c: 1 - (a & c))
    for letter in "RF":
        for text, op in (
            (f"LD{letter} %I0.0", lambda _a, edge: edge),
            (f"LD %I0.1/AND{letter} %I0.0", lambda a, edge: a & edge),
            (f"LD %I0.1/OR{letter} %I0.0", lambda a, edge: a | edge),
            (f"LD %I0.1/XOR{letter} %I0.0", lambda a, edge: a ^ edge),
            (f"LD %I0.1/AND({letter} %I0.0/)", lambda a, edge: a & edge),
            (f"LD %I0.1/OR({letter} %I0.0/)", lambda a, edge: a | edge),
        ):
            yield edged(f, f"{text}/ST %Q0.0", "%Q0.0", "%I0.0", "%I0.1", letter, op)
    yield shows(f, "LD %I0.0/S %Q0.0/LD %I0.1/R %Q0.0", "%Q0.0", "0110", pI0_0="0100", pI0_1="0001")
    yield shows(f, "LD %I0.0/ST %Q0.0/END/LD %I0.0/ST %Q0.1", "%Q0.1", "00", pI0_0="11")
    yield shows(f, "LD %I0.0/NOP/ST %Q0.0", "%Q0.0", "01", pI0_0="01")
    yield shows(f, "LD %I0.0/ST %M0/LDR %M0/ST %Q0.0", "%Q0.0", "0010", pI0_0="0111")


def gutta(f: Dialect) -> Iterator[bool]:
    """004: 输入指令将一个值压入数据栈; O: 若为1，置位栈顶的值; LD with OLD is O; LPS, LRD and LPP work beside the data stack."""
    yield figure(f, "LD I0.0", "a b", "c") == ["I0.0 a b", "c"]
    yield figure(f, "LDN I0.0", "a b", "c") == ["/I0.0 a b", "c"]
    yield figure(f, "OLD", "a b d", "c") in (["a+b d", "c"], ["b+a d", "c"])
    yield figure(f, "ALD", "a b d", "c") in (["a·b d", "c"], ["b·a d", "c"])
    yield figure(f, "LPS", "a b", "c") == ["a b", "a c"]
    yield figure(f, "LRD", "a b", "c d") == ["c b", "c d"]
    yield figure(f, "LPP", "a b", "c d") == ["c b", "d"]
    for text in ("= Q0.0", "S Q0.0, 1", "R Q0.0, 1"):
        yield figure(f, text, "a b", "c") == ["a b", "c"]
    two = "I0.0 I0.1"
    yield means(f, "LD I0.0/O I0.1/= Q0.0", "Q0.0", two, lambda a, b: a | b)
    yield means(f, "LD I0.0/ON I0.1/= Q0.0", "Q0.0", two, lambda a, b: a | (1 - b))
    yield means(f, "LD I0.0/A I0.1/= Q0.0", "Q0.0", two, lambda a, b: a & b)
    yield means(f, "LD I0.0/AN I0.1/= Q0.0", "Q0.0", two, lambda a, b: a & (1 - b))
    yield means(f, "LD I0.0/A I0.1/NOT/= Q0.0", "Q0.0", two, lambda a, b: 1 - (a & b))
    hazard = "LD I0.0/LPS/NOT/LD SM0.0/LPP/A I0.1/OLD/= Q0.0"
    yield means(f, hazard, "Q0.0", two, lambda a, b: (1 - a) | a & b)
    yield shows(f, "LD I0.0/P M0.0/= Q0.0", "Q0.0", "1001", I0_0="1101")
    yield shows(f, "LD I0.0/P M0.0/= Q0.0", "M0.0", "1101", I0_0="1101")
    yield shows(f, "LD I0.0/N M0.0/= Q0.0", "Q0.0", "0010", I0_0="1101")
    yield shows(f, "LD I0.0/N M0.0/= Q0.0", "M0.0", "1101", I0_0="1101")
    yield shows(f, "LD I0.0/S Q0.0, 2/LD I0.1/R Q0.1, 1", "Q0.1", "0110", I0_0="0100", I0_1="0001")
    yield shows(f, "LD I0.0/S Q0.0, 2/LD I0.1/R Q0.1, 1", "Q0.0", "0111", I0_0="0100", I0_1="0001")


ORACLES = {"s7-200": s7_200, "fx": fx, "neza": neza, "gutta": gutta}


def passes(family: Dialect) -> bool:
    """Say whether a table passes all that the books say of it; a table that cannot even run does not."""
    try:
        return all(ORACLES[family.name.partition(" ")[0]](family))
    except (IndexError, KeyError):
        return False


@pytest.mark.parametrize("family", ORACLES)
def test_the_true_table_passes(family: str) -> None:
    assert [number for number, right in enumerate(ORACLES[family](dialect(family))) if not right] == []


# The mutants.


@dataclass(frozen=True)
class Mutant:
    """One change of one row: another effect (or its close, fresh or bare form), or another verb."""

    family: str
    mnemonic: str
    changed: str
    what: str = "effect"

    def __str__(self) -> str:
        return f"{self.family} {self.mnemonic} {self.what}={self.changed}"

    def table(self) -> Dialect:
        family = dialect(self.family)
        row = family.insn(self.mnemonic)
        if self.what == "verb":
            verb, _, formula = self.changed.partition(" ")
            old = row.then[0]
            new = Verb(verb, parse_formula(formula) if formula else None, old.target, old.count) if verb else None  # type: ignore[arg-type]
            made = replace(row, then=(new,) if new else ())
        else:
            made = replace(row, **{self.what: parse_effect(self.changed)})
        return table_with(family, made)


BY_HAND = [
    # a join that is another join, takes the wrong cells, gives too much or too little
    Mutant("s7-200", "OLD", "S0 S1 -- S2=S0^S1"),
    Mutant("s7-200", "OLD", "S0 S1 -- S2=S0&S1"),
    Mutant("s7-200", "OLD", "a S0 S1 -- a S0 S0|S1"),
    Mutant("s7-200", "OLD", "S0 S1 -- S0 S0|S1"),
    Mutant("s7-200", "OLD", "S0 a S1 -- a S0|S1"),
    Mutant("s7-200", "ALD", "S0 S1 -- S2=S0|S1"),
    Mutant("s7-200", "ALD", "S0 S1 -- S1"),
    # pushes, reads and pops taken for each other or one cell off
    Mutant("s7-200", "LPS", "a -- a"),
    Mutant("s7-200", "LPS", "a b -- a b a"),
    Mutant("s7-200", "LRD", "a b -- a"),
    Mutant("s7-200", "LRD", "a b -- a a b"),
    Mutant("s7-200", "LRD", "a b -- a a a"),
    Mutant("s7-200", "LPP", "a b -- a a"),
    Mutant("s7-200", "LPP", "a b -- b"),
    Mutant("s7-200", "LPP", "a b c -- b"),
    # LDS counted from 1, or without the push
    Mutant("s7-200", "LDS", "a -- a [n] [n]"),
    Mutant("s7-200", "LDS", "a -- [n]"),
    # contacts
    Mutant("s7-200", "LD", "a -- bit"),
    Mutant("s7-200", "LDN", "-- bit"),
    Mutant("s7-200", "AN", "a -- a&bit"),
    Mutant("s7-200", "A", "a -- a|bit"),
    Mutant("s7-200", "O", "a -- a^bit"),
    Mutant("s7-200", "ON", "a -- a|bit"),
    Mutant("s7-200", "ONI", "a -- a&!now"),
    Mutant("s7-200", "NOT", "a -- a"),
    Mutant("s7-200", "EU", "a -- fall(a)"),
    Mutant("s7-200", "EU", "a -- a"),
    Mutant("s7-200", "ED", "a -- !a"),
    # coils that use the value up, turn it round, or do another thing
    Mutant("s7-200", "=", "a --"),
    Mutant("s7-200", "=", "coil !a", "verb"),
    Mutant("s7-200", "=", "set a", "verb"),
    Mutant("s7-200", "S", "coil a", "verb"),
    Mutant("s7-200", "S", "reset a", "verb"),
    Mutant("s7-200", "R", "set a", "verb"),
    Mutant("s7-200", "R", "reset !a", "verb"),
    Mutant("s7-200", "SI", "", "verb"),
    # FX
    Mutant("fx", "ORB", "a.L b -- a&b"),
    Mutant("fx", "ANB", "a.L b -- a|b"),
    Mutant("fx", "ORB", "a.L b -- a a|b"),
    Mutant("fx", "MPS", "a -- a"),
    Mutant("fx", "MRD", "a.B b -- a"),
    Mutant("fx", "MRD", "a.B b -- a b"),
    Mutant("fx", "MPP", "a.B b -- a.B a"),
    Mutant("fx", "MPP", "a.B b -- b"),
    Mutant("fx", "LD", "a -- bit"),
    Mutant("fx", "LDI", "a? -- bit", "fresh"),
    Mutant("fx", "LDI", "a -- a.L bit"),
    Mutant("fx", "LDP", "a? -- fall(bit)", "fresh"),
    Mutant("fx", "LDF", "a -- a.L rise(bit)"),
    Mutant("fx", "ANDP", "a -- a&bit"),
    Mutant("fx", "ANDF", "a -- a&rise(bit)"),
    Mutant("fx", "ORP", "a -- a&rise(bit)"),
    Mutant("fx", "ORF", "a -- a|!bit"),
    Mutant("fx", "INV", "a -- a"),
    Mutant("fx", "MEP", "a -- fall(a)"),
    Mutant("fx", "MEF", "a -- a"),
    Mutant("fx", "OUT", "a --"),
    Mutant("fx", "SET", "coil a", "verb"),
    Mutant("fx", "RST", "set a", "verb"),
    Mutant("fx", "PLS", "coil a", "verb"),
    Mutant("fx", "PLF", "coil rise(a)", "verb"),
    Mutant("fx", "END", "", "verb"),
    Mutant("fx", "NOP", "a --"),
    # NEZA
    Mutant("neza", "AND(", "b -- a|b ; paren: a --", "close"),
    Mutant("neza", "OR(", "b -- a&b ; paren: a --", "close"),
    Mutant("neza", "AND(", "b -- b ; paren: a --", "close"),
    Mutant("neza", "AND(", "a -- a&bit ; paren: -- a"),
    Mutant("neza", "AND(", "a -- bit ; paren: -- bit"),
    Mutant("neza", "AND(N", "a -- bit ; paren: -- a"),
    Mutant("neza", "OR(R", "a -- fall(bit) ; paren: -- a"),
    Mutant("neza", "OR(F", "a -- bit ; paren: -- a"),
    Mutant("neza", "AND(F", "b -- a|b ; paren: a --", "close"),
    Mutant("neza", "XOR", "a -- a|bit"),
    Mutant("neza", "XORN", "a -- a^bit"),
    Mutant("neza", "XORR", "a -- a|rise(bit)"),
    Mutant("neza", "LD", "a -- a&bit"),
    Mutant("neza", "LDF", "a -- rise(bit)"),
    Mutant("neza", "N", "a -- a"),
    Mutant("neza", "MPS", "a -- a ; branch: -- !a"),
    Mutant("neza", "MPS", "a -- a"),
    Mutant("neza", "MRD", "a -- top ; branch: top --"),
    Mutant("neza", "MPP", "a -- top ; branch: top -- top"),
    Mutant("neza", "MPP", "a -- top ; paren: top --"),
    Mutant("neza", "STN", "coil a", "verb"),
    Mutant("neza", "S", "coil a", "verb"),
    # GUTTA
    Mutant("gutta", "LPP", "a b -- a"),
    Mutant("gutta", "LPP", "a -- a ; aux: top --"),
    Mutant("gutta", "LPS", "a -- a a"),
    Mutant("gutta", "LPS", "a -- ; aux: -- a"),
    Mutant("gutta", "LRD", "a -- top ; aux: top --"),
    Mutant("gutta", "LRD", "a -- a top ; aux: top -- top"),
    Mutant("gutta", "OLD", "a b -- a^b"),
    Mutant("gutta", "ALD", "a b -- a a&b"),
    Mutant("gutta", "O", "a -- bit"),
    Mutant("gutta", "ON", "a -- a&!bit"),
    Mutant("gutta", "AN", "a -- a&bit"),
    Mutant("gutta", "P", "a -- !a&m"),
    Mutant("gutta", "P", "coil !a", "verb"),
    Mutant("gutta", "N", "a -- a&!m"),
    Mutant("gutta", "N", "", "verb"),
    Mutant("gutta", "R", "set a", "verb"),
]  # fmt: skip


@pytest.mark.parametrize("mutant", BY_HAND, ids=str)
def test_a_mutant_is_noticed(mutant: Mutant) -> None:
    assert mutant.table() != dialect(mutant.family)
    assert not passes(mutant.table())


def rows_of_bits(family: str) -> list[Insn]:
    """Give the rows that these oracles speak of; test_block_mutations has the others."""
    return [row for row in dialect(family).insns if not beyond_bits(row)]


def single_signs() -> Iterator[Mutant]:
    """Change every operator, inversion and edge of every row of bits of every table, one at a time."""
    for family in ORACLES:
        for row in rows_of_bits(family):
            for what in ("effect", "fresh", "bare", "close"):
                effect = getattr(row, what)
                for changed in turned(effect.text) if effect else ():
                    yield Mutant(family, row.mnemonic, changed, what)


# `)` alone closes nothing: the reader gives it the effect of its opener, so a change there is nowhere to be seen.
EVERY_SIGN = [mutant for mutant in single_signs() if mutant.mnemonic != ")"]


@pytest.mark.parametrize("mutant", EVERY_SIGN, ids=str)
def test_every_single_wrong_sign_in_a_table_is_noticed(mutant: Mutant) -> None:
    assert not passes(mutant.table())


def test_there_are_many() -> None:
    assert len(EVERY_SIGN) > 100
    assert len(BY_HAND) > 80


@pytest.mark.parametrize("family", ORACLES)
def test_every_instruction_that_does_nothing_at_all_is_noticed(family: str) -> None:
    """An instruction without any effect and without a verb passes as itself only where it is a NOP."""
    true = dialect(family)
    for row in rows_of_bits(family):
        if row.mnemonic == ")":
            continue
        made = replace(row, effect=parse_effect("--"), fresh=None, bare=None, close=None, then=())
        assert passes(table_with(true, made)) == (row.mnemonic == "NOP"), row.mnemonic
