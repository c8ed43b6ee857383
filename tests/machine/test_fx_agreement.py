"""FX lists of every kind of line, run in three ways that must agree: line by line, as one generated function, and many at once.

Rungs with timers, counters, words, master controls and steps are put together at random.
"""

from __future__ import annotations

import random

import pytest

from plcteach.machine import run
from plcteach.machine.lanes import lanes
from plcteach.machine.scan import sweep
from plcteach.machine.signals import ONE, ZERO
from plcteach.machine.store import Memory
from plcteach.machine.words import BITS
from plcteach.stl import read

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time

CONTACTS = ["X0", "X1", "X2", "X3", "M0", "M1", "T0", "T250", "C0", "C200", "S20", "Y1"]
COMPARES = ["D0 K3", "D2 D0", "T0 K2", "C0 K1", "K2X0 D4"]
OUTPUTS = [
    "OUT Y0", "OUT M0", "SET Y1", "RST Y1", "PLS M1", "OUT T0 K3", "OUT T200 K2", "OUT T250 K4", "RST T250", "OUT C0 K2", "RST C0",
    "OUT C200 K2", "OUT M8200", "RST C200", "INC D0", "INCP D0", "DECP D2", "ADD D0 K7 D2", "SUBP D0 T0 D4", "MOV K2X0 K2M10",
    "MOVP D0 D4", "DMOV D0 D6", "DADD D6 K100000 D6", "CMP D0 K3 M20", "ZCPP K1 K5 D2 M23", "SFTLP X1 M30 K6 K2", "SFTR X0 M30 K6 K1",
    "ZRST D0 D2", "ZRSTP M30 M32", "RST D4", "MUL D0 D2 D10", "DIV D10 D0 D12", "SET S20",
]  # fmt: skip


def rung(chance: random.Random) -> list[str]:
    rows = [f"LD{chance.choice(['', 'I', 'P'])} {chance.choice(CONTACTS)}"]
    for _ in range(chance.randrange(3)):
        if chance.random() < 0.3:
            relation = chance.choice(["=", "<>", ">", "<=", "D>="])
            rows.append(
                f"{chance.choice(['AND', 'OR'])}{relation} {chance.choice(COMPARES).replace('T0', 'D2').replace('C0', 'D4')}"
            )
        else:
            rows.append(f"{chance.choice(['AND', 'ANI', 'OR', 'ORF'])} {chance.choice(CONTACTS)}")
    return [*rows, *(chance.choice(OUTPUTS) for _ in range(chance.randrange(1, 3)))]


def program(seed: int) -> str:
    """Some rungs, some under master controls, some in steps."""
    chance = random.Random(seed)
    rows = [row for _ in range(chance.randrange(1, 4)) for row in rung(chance)]
    for depth in range(chance.randrange(3)):
        rows += [f"LD X{depth}", f"MC N{depth} M{100 + depth}", *rung(chance)]
    rows += [f"MCR N{depth}" for depth in (1, 0) if f"MC N{depth} M{100 + depth}" in rows]
    if chance.random() < 0.6:
        rows += ["LD M8002", "SET S20"]
        for step in (20, 21, 22):
            rows += [f"STL S{step}", *rung(chance), f"LD X{chance.randrange(4)}", f"SET S{chance.choice([20, 21, 22])}"]
        rows += ["STL S20", "STL S22", "OUT Y5", "RET", *rung(chance)]
    return "\n".join([*rows, "END"])


def timeline(seed: int, scans: int) -> list[dict[str, int]]:
    chance = random.Random(seed)
    return [{f"X{place}": int(chance.random() < 0.4) for place in range(4)} for _ in range(scans)]


SCANS = 60
LANES = 3


@pytest.mark.parametrize("seed", range(24))
def test_line_by_line_generated_and_side_by_side_agree(seed: int) -> None:
    list_ = read(program(seed), "fx")
    assert list_.diagnostics == (), list_.diagnostics
    timelines = [timeline(1000 * seed + lane, SCANS) for lane in range(LANES)]
    traces = [run(list_, rows, scan_ms=40) for rows in timelines]
    memory: Memory = Memory()
    for number, row in enumerate(timelines[0]):
        given = {name: ONE if bit else ZERO for name, bit in row.items()}
        memory = sweep(list_, memory, given, BITS, ms=40 if number else 0)
    last = traces[0].memory
    for kept, other, nothing in ((memory.bits, last.bits, ZERO), (memory.words, last.words, BITS.number(0))):
        assert {key for key in {*kept, *other} if kept.get(key, nothing) != other.get(key, nothing)} == set()
    together = lanes(list_, timelines, scan_ms=40)
    for address in (
        "Y0",
        "Y1",
        "Y5",
        "M0",
        "S20",
        "S21",
        "T0",
        "C0",
        "C200",
        "D0",
        "D2",
        "D4",
        "D6",
        "T0.V",
        "C200.V",
        "M20",
        "M30",
    ):
        for lane, trace in enumerate(traces):
            for scan in range(0, SCANS, 7):
                assert together.value(address, scan, lane) == trace.value(address, scan), (address, lane, scan)
