"""Words of the S7-200 against a small machine of its own, which keeps bytes and does sums with Python's numbers and `struct`."""

from __future__ import annotations

import math
import struct
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.machine import run
from plcteach.machine.lanes import lanes
from plcteach.stl import read

sys.path.insert(0, str(Path(__file__).parent))
from direct import RELATIONS

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time

if TYPE_CHECKING:
    from collections.abc import Callable

BYTES = 12
SIZES = {"B": 1, "W": 2, "D": 4}


class Bytes:
    """VB0 to VB11, the four flags and ENO, and each instruction from the manual's sentences."""

    def __init__(self, memory: bytes) -> None:
        self.memory = bytearray(memory)
        self.flags = {"zero": 0, "overflow": 0, "negative": 0, "divide": 0}
        self.eno = 1

    def get(self, word: str, letter: str = "") -> int:
        if word[0] != "V":
            return int(word)
        letter = letter or word[1]
        return int.from_bytes(self.memory[int(word[2:]) :][: SIZES[letter]], "big", signed=letter != "B")

    def packed(self, word: str) -> bytes:
        return bytes(self.memory[int(word[2:]) :][:4]) if word[0] == "V" else struct.pack(">f", float(word))

    def real(self, word: str) -> float:
        return float(struct.unpack(">f", self.packed(word))[0])

    def put(self, word: str, number: int) -> None:
        size = SIZES[word[1]]
        self.memory[int(word[2:]) : int(word[2:]) + size] = (number & (1 << 8 * size) - 1).to_bytes(size, "big")

    def fits(self, word: str, number: int) -> bool:
        size = 8 * SIZES[word[1]]
        return 0 <= number < 256 if size == 8 else -(1 << size - 1) <= number < 1 << size - 1

    def flag(self, **values: object) -> None:
        self.flags |= {name: int(bool(value)) for name, value in values.items()}

    def sum(self, target: str, number: int) -> None:
        """Too large a result leaves the target; then zero and negative mean nothing (0 here)."""
        good = self.fits(target, number)
        self.flag(overflow=not good, zero=good and number == 0, negative=good and number < 0)
        self.eno = int(good)
        if good:
            self.put(target, number)

    def float(self, target: str, number: float | None) -> None:
        try:
            packed = struct.pack(">f", number) if number is not None and math.isfinite(number) else None
        except OverflowError:
            packed = None
        value = 0.0 if packed is None else struct.unpack(">f", packed)[0]
        self.flag(
            overflow=packed is None, zero=packed is not None and value == 0, negative=packed is not None and value < 0
        )
        self.eno = int(packed is not None)
        if packed is not None:
            self.memory[int(target[2:]) : int(target[2:]) + 4] = packed

    def convert(self, target: str, number: int | None) -> None:
        good = number is not None and self.fits(target, number)
        self.flag(overflow=not good)
        self.eno = int(good)
        if good:
            self.put(target, number or 0)

    def do(self, line: str) -> None:
        name, _, rest = line.partition(" ")
        words = rest.split(", ")
        self.eno = 1
        if name.startswith("MOV") and name != "MOVR":
            self.put(words[1], self.get(words[0]))
        elif name == "MOVR":
            self.memory[int(words[1][2:]) : int(words[1][2:]) + 4] = self.packed(words[0])
        elif name[0] in "+-*/":
            self.arithmetic(name, *words)
        elif name in {"MUL", "DIV"}:
            self.wide(name, *words)
        elif name[:3] in {"INC", "DEC"}:
            self.sum(words[0], self.get(words[0]) + (1 if name[0] == "I" else -1))
        elif name[:2] in {"AN", "OR", "XO", "IN"}:
            self.logic(name[:-1], words)
        elif name[:2] in {"SL", "SR", "RL", "RR"}:
            self.shift(name[:2], *words)
        else:
            self.conversion(name, *words)

    def arithmetic(self, name: str, source: str, target: str) -> None:
        if name[1] == "R":
            a, b = self.real(target), self.real(source)
            if name[0] == "/" and b == 0:
                self.flag(divide=1)
                self.eno = 0
                return
            finite = math.isfinite(a) and math.isfinite(b)
            result = {"+": a + b, "-": a - b, "*": a * b, "/": a / (b or 1.0)}[name[0]] if finite else None
            self.float(target, result)
        else:
            a, b = self.get(target), self.get(source)
            if name[0] == "/" and b == 0:
                self.flag(divide=1)
                self.eno = 0
                return
            self.sum(
                target,
                {
                    "+": a + b,
                    "-": a - b,
                    "*": a * b,
                    "/": int(math.copysign(1, a) * math.copysign(1, b)) * (abs(a) // abs(b or 1)),
                }[name[0]],
            )
        if name[0] == "/":
            self.flag(divide=0)

    def wide(self, name: str, source: str, target: str) -> None:
        low = int.from_bytes(self.memory[int(target[2:]) + 2 :][:2], "big", signed=True)
        by = self.get(source, "W")
        if name == "MUL":
            self.sum(target, low * by)
            return
        if not by:
            self.flag(divide=1)
            self.eno = 0
            return
        quotient = math.trunc(low / by)
        rest = low - quotient * by
        good = quotient < 32768
        self.flag(divide=0, overflow=not good, zero=good and not quotient, negative=good and quotient < 0)
        self.eno = int(good)
        if good:
            self.memory[int(target[2:]) : int(target[2:]) + 4] = struct.pack(">hh", rest, quotient)

    def logic(self, name: str, words: list[str]) -> None:
        target = words[-1]
        b = self.get(target)
        a = self.get(words[0])
        self.put(target, {"AND": a & b, "OR": a | b, "XOR": a ^ b, "INV": ~b}[name])
        self.flag(zero=self.get(target) == 0)

    def shift(self, way: str, target: str, count: str) -> None:
        """Bit by bit, so many times."""
        size = 8 * SIZES[target[1]]
        row = [self.get(target) >> place & 1 for place in range(size)]
        times = min(self.get(count), size) if way[0] == "S" else self.get(count) % size
        for _ in range(times):
            if way[1] == "L":
                out = row[-1]
                row = [out if way[0] == "R" else 0, *row[:-1]]
            else:
                out = row[0]
                row = [*row[1:], out if way[0] == "R" else 0]
            self.flag(overflow=out)
        self.put(target, sum(bit << place for place, bit in enumerate(row)))
        self.flag(zero=not any(row))

    def conversion(self, name: str, source: str, target: str) -> None:
        if name in {"BTI", "ITD"}:
            self.put(target, self.get(source))
        elif name in {"ITB", "DTI"}:
            self.convert(target, self.get(source))
        elif name == "DTR":
            self.memory[int(target[2:]) : int(target[2:]) + 4] = struct.pack(">f", self.get(source))
        elif name == "SQRT":
            self.float(target, math.sqrt(self.real(source)) if 0 <= self.real(source) < math.inf else None)
        else:
            number = self.real(source)
            how: Callable[[float], int] = (lambda one: math.floor(one + 0.5)) if name == "ROUND" else math.trunc
            self.convert(target, how(number) if math.isfinite(number) else None)


def place(letter: str) -> st.SearchStrategy[str]:
    """A byte, word or double word anywhere in the memory, also across another one."""
    return st.integers(0, BYTES - SIZES[letter]).map(lambda at: f"V{letter}{at}")


def operand(letter: str) -> st.SearchStrategy[str]:
    low, high = (0, 255) if letter == "B" else (-(1 << 8 * SIZES[letter] - 1), (1 << 8 * SIZES[letter] - 1) - 1)
    numbers = st.integers(low, high) | st.sampled_from([0, 1, high, low])
    return place(letter) | place(letter) | numbers.map(str)


REALS = place("D") | st.sampled_from(["0.0", "1.5", "-2.5", "3.0", "1000000.0", "0.001"])


@st.composite
def lines(draw: st.DrawFn) -> str:  # noqa: PLR0911 (a row for each sort of instruction)
    letter = draw(st.sampled_from("BWD"))
    sort = draw(st.sampled_from(["move", "sum", "sum", "real", "wide", "count", "logic", "shift", "convert"]))
    if sort == "move":
        return f"MOV{letter} {draw(operand(letter))}, {draw(place(letter))}"
    if sort == "sum":
        name, letter = draw(st.sampled_from([("I", "W"), ("D", "D")]))
        return f"{draw(st.sampled_from('+-*/'))}{name} {draw(operand(letter))}, {draw(place(letter))}"
    if sort == "real":
        name = draw(st.sampled_from(["+R", "-R", "*R", "/R", "MOVR", "SQRT", "ROUND", "TRUNC"]))
        return f"{name} {draw(REALS)}, {draw(place('D'))}"
    if sort == "wide":
        return f"{draw(st.sampled_from(['MUL', 'DIV']))} {draw(operand('W'))}, {draw(place('D'))}"
    if sort == "count":
        return f"{draw(st.sampled_from(['INC', 'DEC', 'INV']))}{letter} {draw(place(letter))}"
    if sort == "logic":
        return f"{draw(st.sampled_from(['AND', 'OR', 'XOR']))}{letter} {draw(operand(letter))}, {draw(place(letter))}"
    if sort == "shift":
        count = draw(st.integers(0, 40).map(str) | place("B"))
        return f"{draw(st.sampled_from(['SL', 'SR', 'RL', 'RR']))}{letter} {draw(place(letter))}, {count}"
    name, source, target = draw(st.sampled_from(["BTI B W", "ITB W B", "ITD W D", "DTI D W", "DTR D D"])).split()
    return f"{name} {draw(operand(source))}, {draw(place(target))}"


SMALL = st.lists(st.sampled_from([0, 0, 1, 2, 64, 127, 128, 255]), min_size=BYTES, max_size=BYTES)
MEMORY = st.binary(min_size=BYTES, max_size=BYTES) | SMALL.map(bytes)
FLAGS = {"zero": "SM1.0", "overflow": "SM1.1", "negative": "SM1.2", "divide": "SM1.3"}


def listed(body: list[str]) -> str:
    """Each instruction with its own enabling contact, and a coil behind it that shows ENO."""
    rows = [f"LD I{at // 8}.{at % 8}\n{line}\nAENO\n= Q{at // 8}.{at % 8}" for at, line in enumerate(body)]
    return "\n".join(rows)


def first_scan(memory: bytes, powers: list[int]) -> dict[str, int]:
    return {f"VB{at}": one for at, one in enumerate(memory)} | {
        f"I{at // 8}.{at % 8}": power for at, power in enumerate(powers)
    }


@settings(max_examples=700, deadline=None)
@given(body=st.lists(lines(), min_size=1, max_size=8), memory=MEMORY, data=st.data())
def test_random_word_programs_agree_with_bytes(body: list[str], memory: bytes, data: st.DataObject) -> None:
    powers = data.draw(st.lists(st.sampled_from([1, 1, 1, 0]), min_size=len(body), max_size=len(body)))
    code = read(listed(body), "s7-200")
    assert not code.diagnostics, code.diagnostics
    found = run(code, [first_scan(memory, powers), {}])
    model = Bytes(memory)
    for scan in range(2):
        enos = []
        for line, power in zip(body, powers, strict=True):
            if power:
                model.do(line)
            enos.append(power & model.eno)
        assert [found.value(f"VB{at}", scan).value for at in range(BYTES)] == list(model.memory), scan
        assert {name: int(repr(found.value(flag, scan))) for name, flag in FLAGS.items()} == model.flags, scan
        assert [int(repr(found.value(f"Q{at // 8}.{at % 8}", scan))) for at in range(len(body))] == enos, scan


@settings(max_examples=40, deadline=None)
@given(body=st.lists(lines(), min_size=1, max_size=4), memory=MEMORY)
def test_a_long_run_agrees_too(body: list[str], memory: bytes) -> None:
    """After some scans a run is generated source, which must say the same."""
    code = read(listed(body), "s7-200")
    scans = 80
    found = run(code, [first_scan(memory, [1] * len(body)), *[{}] * (scans - 1)])
    model = Bytes(memory)
    for scan in range(scans):
        for line in body:
            model.do(line)
        assert [found.value(f"VB{at}", scan).value for at in range(BYTES)] == list(model.memory), scan
        assert {name: int(repr(found.value(flag, scan))) for name, flag in FLAGS.items()} == model.flags, scan


@settings(max_examples=40, deadline=None)
@given(
    body=st.lists(lines(), min_size=1, max_size=4), memories=st.lists(MEMORY, min_size=3, max_size=3), data=st.data()
)
def test_many_memories_side_by_side_are_as_many_single_runs(
    body: list[str], memories: list[bytes], data: st.DataObject
) -> None:
    """The same rules over vectors of columns give per lane what they give over plain numbers."""
    code = read(listed(body), "s7-200")
    powers = [data.draw(st.lists(st.integers(0, 1), min_size=len(body), max_size=len(body))) for _ in memories]
    rows = [[first_scan(memory, power), {}] for memory, power in zip(memories, powers, strict=True)]
    many = lanes(code, rows)
    watched = [*(f"VB{at}" for at in range(BYTES)), *FLAGS.values(), *(f"Q0.{at}" for at in range(len(body)))]
    for lane, row in enumerate(rows):
        single = run(code, row)
        for address in watched:
            assert repr(many.value(address, 1, lane)) == repr(single.value(address, 1)), (address, lane)


def test_a_word_is_two_bytes_the_high_one_first() -> None:
    found = run(
        read("LD SM0.0\nMOVW 16#1234, VW100\nLD V100.4\n= Q0.0\nLD V101.2\n= Q0.1\nMOVD VD99, VD200", "s7-200"),
        [{"VB99": 1}],
    )
    assert [found.value(place, 0).value for place in ("VW100", "VB100", "VB101", "VD99")] == [
        0x1234,
        0x12,
        0x34,
        0x01123400,
    ]
    assert [found[bit] for bit in ("Q0.0", "Q0.1", "V100.0", "V100.1", "V101.5")] == ["1", "1", "0", "1", "1"]


def test_an_accumulator_gives_as_much_as_is_asked_for_and_keeps_the_rest() -> None:
    text = "LD SM0.0\nMOVD 16#12345678, AC0\nMOVW AC0, VW0\nMOVB AC0, VB2\nINCW AC0\nMOVB 0, AC0\n+I -1, AC1"
    found = run(read(text, "s7-200"))
    assert [found.value(place, 0).value & 0xFFFFFFFF for place in ("VW0", "VB2", "AC0")] == [0x5678, 0x78, 0x12345600]
    assert found.value("AC1", 0).value == 0xFFFF


@pytest.mark.parametrize("relation", RELATIONS)
@settings(max_examples=25, deadline=None)
@given(memory=MEMORY)
def test_compares_see_bytes_unsigned_words_signed_and_reals_as_numbers(relation: str, memory: bytes) -> None:
    how = RELATIONS[relation]
    text = "\n".join(
        f"LD{letter}{relation} V{size}0, V{size}4\nAN I0.0\nO{letter}{relation} V{size}4, V{size}4\nA{letter}{relation} V{size}0, V{size}4\n= Q0.{at}"
        for at, (letter, size) in enumerate(("BB", "WW", "DD", "RD"))
    )
    found = run(read(text, "s7-200"), [first_scan(memory, [])])
    model = Bytes(memory)
    pairs = [(model.get(f"V{size}0"), model.get(f"V{size}4")) for size in "BWD"] + [
        (model.real("VD0"), model.real("VD4"))
    ]
    for at, (a, b) in enumerate(pairs):
        if not (math.isnan(a) or math.isnan(b)):
            assert found[f"Q0.{at}"] == str(int(how(a, b))), (a, b)


@settings(max_examples=120, deadline=None)
@given(
    length=st.integers(-64, 64).filter(bool),
    start=st.integers(0, 20),
    scans=st.lists(st.tuples(st.integers(0, 1), st.integers(0, 1)), min_size=1, max_size=80),
)
def test_shrb_is_a_list_that_moves(length: int, start: int, scans: list[tuple[int, int]]) -> None:
    first = f"V{start // 8}.{start % 8}"
    code = read(f"LD I0.0\nSHRB I0.1, {first}, {length}\n", "s7-200")
    assert not code.diagnostics
    found = run(code, [{"I0.0": a, "I0.1": b} for a, b in scans])
    row, out = [0] * abs(length), 0
    for scan, (power, data) in enumerate(scans):
        if power and length > 0:
            out, row = row[-1], [data, *row[:-1]]
        elif power:
            out, row = row[0], [*row[1:], data]
        places = [f"V{at // 8}.{at % 8}" for at in range(start, start + len(row))]
        if scan in {0, len(scans) // 2, len(scans) - 1}:
            assert [int(repr(found.value(one, scan))) for one in places] == row
            assert repr(found.value("SM1.1", scan)) == str(out)


def test_analogue_words_are_even() -> None:
    assert read("LD SM0.0\nMOVW AIW2, AQW4", "s7-200").runs
    (one,) = read("LD SM0.0\nMOVW AIW3, VW0", "s7-200").diagnostics
    assert one.code == "RDR006"
    assert "even numbers" in one.text.en
    assert "偶数" in one.text.zh
    assert run(read("LD SM0.0\nMOVW AIW2, AQW4", "s7-200"), [{"AIW2": 777}, {}]).value("AQW4", 1).value == 777


def test_what_has_not_been_built_is_refused_by_its_own_name() -> None:
    for word in ("PID", "SEG", "HSC", "FILL", "TODR", "SIN", "SWAP", "BMW"):
        (one,) = read(f"LD I0.0\n{word} VB0, 1", "s7-200").diagnostics
        assert (one.code, word in one.text.en) == ("RDR002", True)
