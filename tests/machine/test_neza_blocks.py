"""NEZA's six blocks beside plain models of them, written from the notes' table and driven with the same random inputs."""

from __future__ import annotations

from collections import deque
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.machine import run
from plcteach.stl import read

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time

MOST = 9999


def section(block: str, pins: str, configuration: str = "") -> str:
    """A list that feeds %I0.0, %I0.1 … to the pins of a block."""
    feeds = [f"LD %I0.{number}\n{pin}" for number, pin in enumerate(pins.split())]
    head = [f"{block}: {configuration}"] if configuration else []
    return "\n".join([*head, f"BLK {block}", *feeds, "END_BLK"])


def traced(text: str, rows: list[list[int]], scan_ms: int = 10):
    program = read(text, "neza")
    assert not program.diagnostics, program.diagnostics
    scans = [{f"%I0.{number}": bit for number, bit in enumerate(row)} for row in rows]
    return run(program, scans, scan_ms=scan_ms)


def numbers(trace, address: str) -> list[int]:
    return [int(repr(value)) for value in trace.values(address)]


def bits(width: int, size: int = 60) -> st.SearchStrategy[list[list[int]]]:
    """Rows of `width` bits, which change now and then: each scan flips some."""
    flips = st.lists(st.lists(st.integers(0, 3), min_size=width, max_size=width), min_size=1, max_size=size)

    def flipped(rows: list[list[int]]) -> list[list[int]]:
        now, found = [0] * width, []
        for row in rows:
            now = [bit ^ (flip == 0) for bit, flip in zip(now, row, strict=True)]
            found.append(now)
        return found

    return flips.map(flipped)


def rises(rows: list[list[int]], column: int) -> list[bool]:
    """Where a column rises; the first scan shows no edge."""
    values = [row[column] for row in rows]
    return [False, *(now > before for before, now in pairwise(values))]


# Timers: a model by moments, not by steps.


def on_delay(ins: list[int], ms: int, goal: int, base: int) -> list[tuple[int, int]]:
    found, start = [], None
    for scan, power in enumerate(ins):
        start = (scan * ms if start is None else start) if power else None
        passed = 0 if start is None else min(scan * ms - start, goal)
        found.append((int(start is not None and passed >= goal), passed // base))
    return found


def off_delay(ins: list[int], ms: int, goal: int, base: int) -> list[tuple[int, int]]:
    found, fell, before = [], None, 0
    for scan, power in enumerate(ins):
        fell = None if power else scan * ms if before else fell
        passed = 0 if fell is None else min(scan * ms - fell, goal)
        found.append((int(bool(power) or (fell is not None and passed < goal)), passed // base))
        before = power
    return found


def pulse(ins: list[int], ms: int, goal: int, base: int) -> list[tuple[int, int]]:
    found, start, before = [], None, 0
    for scan, power in enumerate(ins):
        now = scan * ms
        over = start is not None and now - start >= goal
        if power and not before and (start is None or over):
            start, over = now, False
        elif over and not power:
            start = None
        found.append((int(start is not None and not over), 0 if start is None else min(now - start, goal) // base))
        before = power
    return found


@pytest.mark.parametrize(("kind", "model"), [("TON", on_delay), ("TOF", off_delay), ("TP", pulse)])
@pytest.mark.parametrize(("base", "ms"), [("10ms", 10), ("10ms", 3), ("100ms", 70), ("1ms", 4), ("1s", 300)])
@settings(max_examples=25, deadline=None)
@given(rows=bits(1, 90), preset=st.integers(0, 9))
def test_timers(kind: str, model, base: str, ms: int, rows: list[list[int]], preset: int) -> None:
    length = {"1ms": 1, "10ms": 10, "100ms": 100, "1s": 1000}[base]
    trace = traced(section("%TM5", "IN", f"TYPE={kind} TB={base} P={preset}"), rows, ms)
    wanted = model([row[0] for row in rows], ms, preset * length, length)
    assert list(zip(numbers(trace, "%TM5.Q"), numbers(trace, "%TM5.V"), strict=True)) == wanted


def test_on_at_power_up_starts_a_timer_and_gives_no_edge_to_any_other_block() -> None:
    """[rec]: "%TM's IN counts as 0 before the first scan"; CU, CD, U, I, O give no edge in the first scan."""
    on = [[1]] * 4
    assert numbers(traced(section("%TM0", "IN", "TYPE=TP TB=10ms P=2"), on), "%TM0.Q") == [1, 1, 0, 0]
    assert numbers(traced(section("%TM0", "IN", "TYPE=TON TB=10ms P=2"), on), "%TM0.V") == [0, 1, 2, 2]
    assert numbers(traced(section("%C0", "CU"), on), "%C0.V") == [0] * 4
    assert numbers(traced(section("%C0", "CD"), on), "%C0.V") == [0] * 4
    assert numbers(traced(section("%DR0", "U", "OUT=%Q0.0 STEPS=0,1"), on), "%DR0.S") == [0] * 4
    assert numbers(traced(section("%SC0", "CU"), on), "%SC0.0") == [1] * 4
    assert numbers(traced(section("%R0", "I"), on), "%R0.E") == [1] * 4
    assert numbers(traced("LD 1\nS %SBR0.0\n" + section("%SBR0", "CU"), on), "%SBR0.1") == [0] * 4


@pytest.mark.parametrize("kind", ["TON", "TP"])
def test_a_new_preset_counts_from_the_next_start(kind: str) -> None:
    text = section("%TM0", "IN", f"TYPE={kind} TB=10ms P=3") + "\nLDR %I0.1\n[%TM0.P := 6]"
    rows = [[0, 0], [1, 0], [1, 1], *[[1, 0]] * 8, [0, 0], *[[1, 0]] * 9, [0, 0]]
    ons = numbers(traced(text, rows), "%TM0.Q")
    wanted = (
        [0, 0, 0, 0, *[1] * 7, 0, *[0] * 6, 1, 1, 1, 0]
        if kind == "TON"
        else [0, *[1] * 3, *[0] * 8, *[1] * 6, *[0] * 4]
    )
    assert ons == wanted


def test_defaults() -> None:
    """TYPE TON, TB 1 min, P 9999."""
    trace = traced(section("%TM0", "IN"), [[1]] * 4, 30_000)
    assert numbers(trace, "%TM0.P") == [MOST] * 4
    assert numbers(trace, "%TM0.V") == [0, 0, 1, 1]
    assert numbers(traced(section("%C0", "CU"), [[0]]), "%C0.P") == [MOST]


# Counters.


@settings(max_examples=150, deadline=None)
@given(rows=bits(4, 80), preset=st.sampled_from([0, 1, 3, 9997, 9998, MOST]))
def test_counters(rows: list[list[int]], preset: int) -> None:
    trace = traced(section("%C2", "R S CU CD", f"P={preset}"), rows)
    value, empty, full = 0, 0, 0
    up, down = rises(rows, 2), rises(rows, 3)
    for scan, (reset, load, *_) in enumerate(rows):
        step = up[scan] - down[scan]
        if reset:
            value = empty = full = 0
        elif load:
            value = preset
        elif step:
            full, empty = int(value + step > MOST), int(value + step < 0)
            value = (value + step) % (MOST + 1)
        done = int(value == preset and not reset)
        got = [int(repr(trace.value(f"%C2.{name}", scan))) for name in "VDEF"]
        assert got == [value, done, empty, full], scan


def test_e_and_f_at_the_wrap_and_at_the_next_count() -> None:
    pulse_row = [[0, 1], [0, 0]]
    trace = traced(
        section("%C0", "CU CD"), [[0, 0], *pulse_row, *pulse_row, [1, 0], [0, 0], [1, 0], [0, 0], [1, 0], [0, 0]]
    )
    assert numbers(trace, "%C0.V") == [0, 9999, 9999, 9998, 9998, 9999, 9999, 0, 0, 1, 1]
    assert trace["%C0.E"] == "01100000000"
    assert trace["%C0.F"] == "00000001100"
    assert trace["%C0.D"] == "01100110000"


# Drums.


@settings(max_examples=80, deadline=None)
@given(
    rows=bits(2, 60),
    table=st.integers(1, 8).flatmap(
        lambda size: st.lists(st.text("01", min_size=4, max_size=4), min_size=size, max_size=size)
    ),
)
def test_drums(rows: list[list[int]], table: list[str]) -> None:
    outs = [f"%Q0.{number}" for number in range(3)] + ["%M7"]
    trace = traced(section("%DR3", "R U", f"OUT={','.join(outs)} STEPS={','.join(table)}"), rows)
    step = 0
    on = rises(rows, 1)
    for scan, (reset, _) in enumerate(rows):
        step = 0 if reset else (step + on[scan]) % len(table)
        assert int(repr(trace.value("%DR3.S", scan))) == step
        assert int(repr(trace.value("%DR3.F", scan))) == (step == len(table) - 1)
        assert "".join(repr(trace.value(out, scan)) for out in outs) == table[step]


def test_a_drum_writes_when_its_step_changes_while_r_is_held_and_at_cold_start_only() -> None:
    """Between the steps another line may write the same bit, and it stays so."""
    text = section("%DR0", "R U", "OUT=%Q0.0,%Q0.1 STEPS=10,01") + "\nLD %I0.2\nR %Q0.0"
    rows = [[0, 0, 0], [0, 0, 1], [0, 0, 0], [1, 0, 0], [0, 0, 1], [0, 0, 0], [0, 1, 0], [0, 0, 0], [0, 1, 0]]
    trace = traced(text, rows)
    assert trace["%Q0.0"] == "100100001"
    assert trace["%Q0.1"] == "000000110"


# Shift registers.


@settings(max_examples=100, deadline=None)
@given(rows=bits(4, 80), place=st.integers(0, 15))
def test_shift_registers(rows: list[list[int]], place: int) -> None:
    text = f"LD %I0.3\nS %SBR7.{place}\n" + section("%SBR7", "R CU CD")
    trace = traced(text, rows)
    word, fallen = 0, 0
    left, right = rises(rows, 1), rises(rows, 2)
    for scan, (reset, _, _, fill) in enumerate(rows):
        word |= fill << place
        if left[scan] and not right[scan]:
            fallen, word = word >> 15, word << 1 & 0xFFFF
        elif right[scan] and not left[scan]:
            fallen, word = word & 1, word >> 1
        word = 0 if reset else word
        assert "".join(repr(trace.value(f"%SBR7.{bit}", scan)) for bit in range(15, -1, -1)) == f"{word:016b}"
        assert int(repr(trace.value("%S17", scan))) == fallen


# Step counters.


@settings(max_examples=60, deadline=None)
@given(rows=bits(3, 60))
def test_step_counters(rows: list[list[int]]) -> None:
    trace = traced(section("%SC4", "R CU CD"), rows)
    step = 0
    up, down = rises(rows, 1), rises(rows, 2)
    asked = False
    for scan, (reset, *_) in enumerate(rows):
        wanted = step + up[scan] - down[scan]
        asked |= not reset and wanted < 0
        step = 0 if reset else max(wanted, 0)
        on = [number for number in range(40) if repr(trace.value(f"%SC4.{number}", scan)) == "1"]
        assert on == [step]
    assert [one.code for one in trace.diagnostics] == ["RUN004"] * asked


def test_a_step_counter_has_256_steps_and_stays_at_the_last() -> None:
    trace = traced(section("%SC0", "CU"), [[0], *[[1], [0]] * 257])
    assert trace["%SC0.255"].index("1") == 2 * 255 - 1
    assert trace["%SC0.255"].endswith("1" * 6)
    assert [one.code for one in trace.diagnostics] == ["RUN004"]
    assert traced(section("%SC0", "CU"), [[0], *[[1], [0]] * 255]).diagnostics == ()


# Registers.


@pytest.mark.parametrize("kind", ["FIFO", "LIFO"])
@settings(max_examples=80, deadline=None)
@given(rows=bits(3, 100), fill=st.integers(0, 16))
def test_registers(kind: str, rows: list[list[int]], fill: int) -> None:
    text = f"%R1: TYPE={kind}\nLD 1\n[INC %R1.I]\n" + section("%R1", "R I O")
    rows = [[0, 0, 0], *[[0, 1, 0], [0, 0, 0]] * fill, *rows]
    trace = traced(text, rows)
    held: deque[int] = deque()
    out = 0
    store, take = rises(rows, 1), rises(rows, 2)
    for scan, (reset, *_) in enumerate(rows):
        if reset:
            held.clear()
        elif store[scan] and not take[scan] and len(held) < 16:
            held.append(scan + 1)
        elif take[scan] and not store[scan] and held:
            out = held.popleft() if kind == "FIFO" else held.pop()
        got = [int(repr(trace.value(f"%R1.{name}", scan))) for name in "OEF"]
        assert got == [out, int(not held), int(len(held) == 16)], scan


def test_the_words_of_a_fifo_move_down_and_those_of_a_lifo_stay() -> None:
    """ "FIFO: the words move down; LIFO: only a pointer moves" (figures 4-42 and 4-43), as the machine keeps them."""
    rows = [[0, 0, 0], *[[0, 1, 0], [0, 0, 0]] * 3, [0, 0, 1]]
    for kind, kept in (("FIFO", [4, 6]), ("LIFO", [2, 4, 6])):
        trace = traced(f"%R1: TYPE={kind}\nLD 1\n[INC %R1.I]\n" + section("%R1", "R I O"), rows)
        words = [int(repr(trace.memory.words[f"%R1#{place}"])) for place in range(4)]
        assert [word for word in words if word] == kept


# The direct form, and where a block acts.


@settings(max_examples=60, deadline=None)
@given(rows=bits(3, 40))
def test_the_direct_form_does_what_the_section_does(rows: list[list[int]]) -> None:
    """One pin a line; apart from two counts at once it is the same."""
    rows = [[one, two, 0] if two else [one, two, three] for one, two, three in rows]
    one = traced(section("%C0", "R CU S", "P=7"), rows)
    other = traced("%C0: P=7\nLD %I0.1\nCU %C0\nLD %I0.2\nS %C0\nLD %I0.0\nR %C0", rows)
    assert numbers(one, "%C0.V") == numbers(other, "%C0.V")
    timer = traced("%TM0: TB=10ms P=4\nLD %I0.0\nIN %TM0", rows)
    assert timer["%TM0.Q"] == traced(section("%TM0", "IN", "TB=10ms P=4"), rows)["%TM0.Q"]


def test_a_block_acts_at_out_blk_and_not_again_at_its_end() -> None:
    text = "BLK %C0\nLD %I0.0\nCU\nOUT_BLK\nLD [%C0.V = 1]\nST %Q0.0\nEND_BLK"
    trace = traced(text, [[0], [1], [1], [0]])
    assert numbers(trace, "%C0.V") == [0, 1, 1, 1]
    assert trace["%Q0.0"] == "0111"
    late = traced("BLK %C0\nLD %I0.0\nCU\nLD [%C0.V = 1]\nST %Q0.0\nEND_BLK", [[0], [1], [1]])
    assert late["%Q0.0"] == "001"


def test_a_missing_pin_is_0() -> None:
    """A section without its IN line: the timer is reset."""
    program = read("%TM0: TYPE=TON TB=10ms P=2\nLD %I0.0\nIN %TM0\nBLK %TM0\nEND_BLK", "neza")
    assert run(program, [{"%I0.0": 1}, *[{}] * 9])["%TM0.Q"] == "0" * 10


def test_a_register_is_empty_before_its_line_has_run() -> None:
    assert traced("LD %R0.E\nST %Q0.0\nLD %I0.0\nI %R0", [[0], [1], [0]])["%Q0.0"] == "110"
