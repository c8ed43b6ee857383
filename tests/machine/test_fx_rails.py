"""FX master controls and steps: beside a hand-written table, beside programs with every condition written out, beside a model."""

from __future__ import annotations

from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.check.lint import lint
from plcteach.machine import run
from plcteach.stl import read


def program(text: str):
    found = read(text.replace("/", "\n"), "fx")
    assert found.diagnostics == (), found.diagnostics
    return found


def right(text: str):
    found = program(text)
    assert [one for one in lint(found) if one.severity != "info"] == []
    return found


# Master control.

NESTED = (
    "LD X0/MC N0 M100/LD X1/OUT Y0/LD X2/MC N1 M101/LD X3/OUT Y1/MCR N1/LDI X3/OUT Y2/MCR N0/LD X3/OUT Y3"
)  # fmt: skip


def test_nested_master_controls_by_a_table() -> None:
    """X0 X1 X2 X3 | M100 M101 Y0 Y1 Y2 Y3: inside an open MC even LDI gives 0 where the rail has no power."""
    table = """
        0 0 0 0 | 0 0 0 0 0 0
        0 1 1 1 | 0 0 0 0 0 1
        0 0 0 1 | 0 0 0 0 0 1
        1 0 0 0 | 1 0 0 0 1 0
        1 1 0 0 | 1 0 1 0 1 0
        1 1 0 1 | 1 0 1 0 0 1
        1 0 1 0 | 1 1 0 0 1 0
        1 1 1 0 | 1 1 1 0 1 0
        1 1 1 1 | 1 1 1 1 0 1
        1 0 1 1 | 1 1 0 1 0 1
    """
    list_ = right(NESTED)
    for row in table.strip().splitlines():
        given, wanted = (part.split() for part in row.split("|"))
        trace = run(list_, [{f"X{place}": int(one) for place, one in enumerate(given)}])
        assert [trace[one] for one in ("M100", "M101", "Y0", "Y1", "Y2", "Y3")] == wanted, row


def test_a_reset_ends_all_that_is_open_inside_it() -> None:
    list_ = program("LD X0/MC N0 M100/LD X1/MC N1 M101/LD X2/OUT Y0/MCR N0/LD X2/OUT Y1")
    for a, b, c in product((0, 1), repeat=3):
        trace = run(list_, [{"X0": a, "X1": b, "X2": c}])
        assert (trace["Y0"], trace["Y1"]) == (str(a & b & c), str(c))


def test_what_a_master_control_switches_off_and_what_it_lets_hold() -> None:
    """ "OUT coils and ordinary timers go off; SET bits, retentive timers and counters hold"; and RST does not fire."""
    inside = "LD X1/OUT Y0/LD X1/OUT T0 K9/LD X1/OUT T250 K9/LD X2/OUT C0 K9/LD X1/SET Y1/LDI X1/RST Y2/LD M8000/SFTL X1 M0 K4 K1"
    list_ = program(f"LD X0/MC N0 M100/{inside}/MCR N0")
    rows = [{"X0": 1, "X1": 1, "Y2": 1}, {"X2": 1}, {"X2": 0}, {"X2": 1}, {"X0": 0}, {"X1": 0}, {"X2": 0}, {"X2": 1}]
    trace = run(list_, rows, scan_ms=100)
    assert (trace["Y0"], trace["Y1"], trace["Y2"]) == ("11110000", "11111111", "11111111")
    assert [one.value for one in trace.values("T0.V")] == [0, 1, 2, 3, 0, 0, 0, 0]
    assert [one.value for one in trace.values("T250.V")] == [0, 1, 2, 3, 4, 4, 4, 4]
    assert [one.value for one in trace.values("C0.V")] == [0, 1, 1, 2, 2, 2, 2, 2]
    assert [trace[f"M{place}"][-1] for place in range(4)] == ["1", "1", "1", "1"]


class Tree:
    """A random nest of master controls: conditions, coils, sets, and further nests."""

    def __init__(self, draw: st.DrawFn) -> None:
        self.draw = draw
        self.with_masters: list[str] = []
        self.written_out: list[str] = []
        self.coils = 0

    def rung(self, conditions: list[str]) -> None:
        word, x = self.draw(st.sampled_from(["LD", "LDI"])), self.draw(st.integers(0, 5))
        verb = self.draw(st.sampled_from(["OUT", "SET"]))
        self.coils += 1
        coil = f"{verb} Y{self.coils:o}"
        self.with_masters += [f"{word} X{x}", coil]
        self.written_out += [f"{word} X{x}", *[f"AND {one}" for one in conditions], coil]

    def nest(self, depth: int, conditions: list[str]) -> None:
        for _ in range(self.draw(st.integers(1, 3))):
            if depth < 8 and self.draw(st.integers(0, 2)) == 0:
                x, relay = self.draw(st.integers(0, 5)), f"M{100 + 10 * depth + self.coils}"
                self.with_masters += [f"LD X{x}", f"MC N{depth} {relay}"]
                self.nest(depth + 1, [*conditions, f"X{x}"])
                self.with_masters.append(f"MCR N{depth}")
            self.rung(conditions)


@st.composite
def nests(draw: st.DrawFn) -> tuple[str, str, int]:
    tree = Tree(draw)
    tree.nest(0, [])
    return "\n".join(tree.with_masters), "\n".join(tree.written_out), tree.coils


BITS = st.lists(st.lists(st.integers(0, 1), min_size=6, max_size=6), min_size=1, max_size=5)


@given(nests(), BITS)
@settings(max_examples=150, deadline=None)
def test_master_controls_are_conditions_before_every_coil(nest: tuple[str, str, int], scans: list[list[int]]) -> None:
    with_masters, written_out, coils = nest
    rows = [{f"X{place}": bit for place, bit in enumerate(scan)} for scan in scans]
    one, other = (run(program(text), rows) for text in (with_masters, written_out))
    for number in range(1, coils + 1):
        assert one[f"Y{number:o}"] == other[f"Y{number:o}"]


# Steps.

LADDER = (
    "LD M8002/SET S0/"
    "STL S0/OUT Y0/LD X0/SET S20/LD X1/SET S30/"  # a selection
    "STL S20/OUT Y1/LD X2/SET S21/SET S22/"  # both at once
    "STL S21/OUT Y2/LD X3/SET S23/"
    "STL S22/OUT Y3/"
    "STL S23/STL S22/LD X4/SET S40/"  # joined where both wait
    "STL S30/OUT Y4/LD X5/SET S40/"
    "STL S40/OUT Y0/LD X6/OUT S0/RET/"
    "LD S40/OUT Y5/LD S0/AND S20/OR S30/AND S0/OUT Y6/END"
)
STEPS = ("S0", "S20", "S30", "S21", "S22", "S23", "S40")


def active(trace) -> list[set[str]]:
    """The steps that are on when each scan ends: a step that was left is off by then."""
    return [{one for one in STEPS if trace[one][scan] == "1"} for scan in range(len(trace.starts))]


def test_a_ladder_of_steps_with_a_selection_and_a_parallel_branch() -> None:
    pressed = ["", "X0", "", "X2", "", "X4", "X3", "", "X4", "", "X6", "", "X1", "", "X5", "", "X6", "", ""]
    rows = [{f"X{place}": int(one == f"X{place}") for place in range(7)} for one in pressed]
    trace = run(right(LADDER), rows)
    assert active(trace) == [
        {"S0"},
        {"S20"},
        {"S20"},
        {"S21", "S22"},
        {"S21", "S22"},
        {"S21", "S22"},  # X4 does nothing while S23 is not on
        {"S22", "S23"},
        {"S22", "S23"},
        {"S40"},
        {"S40"},
        {"S0"},
        {"S0"},
        {"S30"},
        {"S30"},
        {"S40"},
        {"S40"},
        {"S0"},
        {"S0"},
        {"S0"},
    ]
    assert [scan for scan, both in enumerate(trace["Y6"]) if both == "1"] == [
        1,
        12,
    ]  # within the scan of a transfer both are
    coils = {
        "Y0": {"S0", "S40"}, "Y1": {"S20"}, "Y2": {"S21"}, "Y3": {"S22"}, "Y4": {"S30"}, "Y5": {"S40"},
    }  # fmt: skip
    before: set[str] = set()
    for scan, steps in enumerate(active(trace)):
        for coil, drivers in coils.items():
            # in the scan of a transfer what the source drives is still on, and what the target drives already
            assert trace[coil][scan] == str(int(bool((steps | before) & drivers))), (scan, coil)
        before = steps


def test_one_press_moves_one_step_only_where_an_edge_is_asked_for() -> None:
    """A step that is set stands below the one that sets it, so it is executed in the same scan, with the same input."""
    chain = "LD M8002/SET S0/STL S0/LD{0} X0/SET S20/STL S20/LD{0} X0/SET S21/STL S21/OUT Y0/RET"
    level = run(right(chain.format("")), [{}, {"X0": 1}, {}, {}])
    assert [level[one] for one in ("S0", "S20", "S21")] == ["1000", "0000", "0111"]
    pulse = run(right(chain.format("P")), [{}, {"X0": 1}, {}, {"X0": 0}, {"X0": 1}, {}])
    assert [pulse[one] for one in ("S0", "S20", "S21")] == ["100000", "011100", "000011"]


def test_what_a_step_leaves_behind() -> None:
    """OUT and ordinary timers end with the step; SET, retentive timers and counters hold."""
    text = (
        "LD M8002/SET S20/STL S20/OUT Y0/SET Y1/OUT T0 K50/OUT T250 K50/LD X1/OUT C0 K9/LD X0/SET S21/STL S21/OUT Y2/RET/"
        "LD Y0/OUT Y3"
    )
    trace = run(program(text), [{}, {"X1": 1}, {"X1": 0, "X0": 1}, {"X0": 0}, {}, {"X1": 1}], scan_ms=100)
    assert [trace[one] for one in ("Y0", "Y1", "Y2", "Y3")] == ["111000", "111111", "001111", "111000"]
    assert [one.value for one in trace.values("T0.V")] == [0, 1, 2, 0, 0, 0]
    assert [one.value for one in trace.values("T250.V")] == [0, 1, 2, 3, 3, 3]
    assert [one.value for one in trace.values("C0.V")] == [0, 1, 1, 1, 1, 1]


def test_two_steps_may_drive_one_coil_whichever_stands_first() -> None:
    text = "LD M8002/SET S0/STL S0/OUT Y0/LD X0/SET S20/STL S20/OUT Y0/LD X1/SET S0/RET"
    assert lint(program(text)) == ()
    trace = run(program(text), [{}, {"X0": 1}, {"X0": 0}, {"X1": 1}, {"X1": 0}, {"X0": 1}, {"X0": 0}])
    assert trace["Y0"] == "1111111"
    assert [one.code for one in lint(program("LD X2/OUT Y0/STL S0/OUT Y0/RET"))] == ["COI001"]
    assert [one.code for one in lint(program("STL S0/OUT Y0/LD X0/OUT Y0/RET"))] == ["COI001"]


def test_a_jump_by_out_holds_and_leaves_like_set_and_is_a_plain_coil_outside() -> None:
    text = "LD M8002/SET S0/STL S0/LD X0/OUT S20/STL S20/OUT Y1/RET/LD X1/OUT S30"
    trace = run(right(text), [{}, {"X0": 1}, {"X0": 0}, {"X1": 1}, {"X1": 0}])
    assert [trace[one] for one in ("S0", "S20", "Y1", "S30")] == ["10000", "01111", "01111", "00010"]


def test_several_steps_joined_hold_their_coil_only_together() -> None:
    """A stretch under two steps ends properly although one of its relays begins a stretch of its own above."""
    text = "STL S20/OUT Y0/STL S21/OUT Y1/STL S20/STL S21/OUT Y2/RET/LD X0/RST S20/LD X1/RST S21"
    rows = [{"S20": 1}, {"S21": 1}, {}, {"X0": 1}, {"X0": 0}, {"S20": 1}, {"X1": 1}, {"X1": 0}]
    trace = run(program(text), rows)
    assert [trace[one] for one in ("S20", "S21")] == ["11100111", "01111100"]
    assert [trace[f"Y{place}"] for place in range(3)] == ["11110111", "01111110", "01110110"]


@st.composite
def walks(draw: st.DrawFn) -> tuple[list[list[tuple[int, int]]], list[list[int]]]:
    """Random steps S20 …: for each its ways on, as (input, target); and what is pressed."""
    count = draw(st.integers(2, 5))
    way = st.tuples(st.integers(0, 4), st.integers(0, count - 1))
    ways = [draw(st.lists(way, min_size=0, max_size=2)) for _ in range(count)]
    pressed = draw(st.lists(st.lists(st.integers(0, 1), min_size=5, max_size=5), min_size=1, max_size=8))
    return ways, pressed


@given(walks())
@settings(max_examples=200, deadline=None)
def test_random_steps_go_as_the_sentences_say(walk: tuple[list[list[tuple[int, int]]], list[list[int]]]) -> None:
    """ "SET S turns the target on and the source off; both are on for the scan of the transfer": list order, plain sets."""
    ways, pressed = walk
    text = ["LD M8002", "SET S20"]
    for number, mine in enumerate(ways):
        text += [f"STL S{20 + number}", f"OUT Y{number}"]
        text += [line for x, to in mine for line in (f"LD X{x}", f"SET S{20 + to}")]
    trace = run(
        program("/".join([*text, "RET"])), [{f"X{place}": bit for place, bit in enumerate(row)} for row in pressed]
    )
    on: set[int] = set()
    for scan, row in enumerate(pressed):
        on |= {0} if scan == 0 else set()
        left: set[int] = set()
        driven = []
        for number, mine in enumerate(ways):
            driven.append(number in on)
            for x, to in mine:
                if number in on and row[x]:
                    on.add(to)
                    left |= {number} - {to}
        on -= left
        shown = {number for number in range(len(ways)) if trace[f"S{20 + number}"][scan] == "1"}
        assert shown == on
        assert [trace[f"Y{number}"][scan] for number in range(len(ways))] == [str(int(one)) for one in driven]


# What is said of rails that do not close.


@pytest.mark.parametrize(
    ("text", "code", "row"),
    [
        ("LD X0/MC N0 M100/LD X1/OUT Y0/END", "COI003", 2),
        ("LD X0/OUT Y0/MCR N0", "COI004", 3),
        ("LD X0/MC N0 M100/LD X1/OUT Y0/MCR N1/MCR N0", "COI004", 5),
        ("LD X0/MC N0 M100/LD X1/MC N0 M101/LD X2/OUT Y0/MCR N0", "COI005", 4),
        ("STL S20/OUT Y0/LD X0/MC N0 M100/LD X1/OUT Y1/MCR N0/RET", "COI006", 4),
        ("STL S20/MPS/AND X0/OUT Y0/MPP/OUT Y1/RET", "COI007", 2),
        ("STL S20/OUT Y0/LD X0/SET S21/STL S21/OUT Y1/END", "COI008", 5),
    ],
)
def test_what_is_said_of_rails(text: str, code: str, row: int) -> None:
    found = [one for one in lint(program(text)) if one.severity == "error"]
    assert (found[0].code, found[0].span.row) == (code, row)
    assert {one.code for one in found} == {code}


def test_a_load_between_step_and_push_is_right() -> None:
    list_ = right("STL S20/LD X0/MPS/AND X1/OUT Y0/MPP/AND X2/SET S21/STL S21/OUT Y1/RET")
    trace = run(list_, [{"S20": 1, "X0": 1, "X1": 1}, {"X2": 1}, {}])
    assert [trace[one] for one in ("S20", "S21", "Y0", "Y1")] == ["100", "011", "110", "011"]
