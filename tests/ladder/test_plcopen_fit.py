"""Ladders of the standard in the families' own words: timers and counters beside plain models of IEC 61131-3, scan by scan."""

from __future__ import annotations

import random
from itertools import pairwise
from pathlib import Path

import pytest

from plcteach.core.diagnostic import errors
from plcteach.core.errors import NotRepresentableError
from plcteach.core.ladder import Box, Coil, Compared, Contact, Ladder, Rung
from plcteach.ladder.lower import lower
from plcteach.ladder.plcopen import read_plcopen
from plcteach.ladder.plcopen_fit import fitted, milliseconds
from plcteach.machine import run
from plcteach.stl import read

FILES = Path(__file__).parent / "plcopen"
FAMILIES = ("neza", "s7-200", "fx", "gutta")
PERIOD = 100


def program(ladder: Ladder, family: str):
    """The ladder as a list of the family, its configuration above it, and what became of each address."""
    made = fitted(ladder, family)
    found = read("\n".join([*made.configuration, lower(made.ladder, family)]), family)
    assert not errors(found.diagnostics), found.diagnostics
    return found, made.table


def rows(dice: random.Random, width: int, size: int = 120) -> list[list[int]]:
    """Inputs that change now and then; all are 0 in the first scan, which shows no edge."""
    now = [0] * width
    found = [now]
    for _ in range(size):
        now = [bit ^ (dice.random() < 0.15) for bit in now]
        found.append(now)
    return found


def outputs(ladder: Ladder, family: str, given: list[list[int]]) -> list[list[int]]:
    """The outputs %Q0.0 and %Q0.1 after each scan."""
    made, table = program(ladder, family)
    scans = [{table[f"%I0.{at}"]: bit for at, bit in enumerate(row) if f"%I0.{at}" in table} for row in given]
    trace = run(made, scans, scan_ms=PERIOD)
    return [[int(repr(bit)) for bit in trace.values(table[name])] for name in ("%Q0.0", "%Q0.1")]


def timed(kind: str) -> Ladder:
    box = Rung(Contact("%I0.0"), (Box(f"{kind} T, T#500MS"),))
    bits = (Rung(Contact("T.Q"), (Coil("%Q0.0"),)), Rung(Contact("T.Q", negated=True), (Coil("%Q0.1"),)))
    return Ladder((box, *bits))


def counted(kind: str, first: str, second: str) -> Ladder:
    box = Rung(Contact("%I0.0"), (Box(f"{kind} C, 3", ((second, Contact("%I0.1")),), first),))
    bits = (Rung(Contact("C.Q"), (Coil("%Q0.0"),)), Rung(Contact("C.Q", negated=True), (Coil("%Q0.1"),)))
    return Ladder((box, *bits))


def by_the_standard(kind: str, given: list[list[int]], ticks: int = 5) -> list[int]:
    """The output bit of a timer by the moments at which its input changed."""
    start, q, found = -1, 0, []
    inputs = [row[0] for row in given]
    for now, (before, bit) in enumerate(pairwise([0, *inputs])):
        if kind == "TON":
            start = now if bit and not before else start
            q = int(bit and now - start >= ticks)
        elif kind == "TOF":
            start = now if before and not bit else start
            q = int(bit or (start >= 0 and now - start < ticks))
        elif bit and not before and not (start >= 0 and now - start < ticks):
            start, q = now, 1
        if kind == "TP":
            q = int(start >= 0 and now - start < ticks)
        found.append(q)
    return found


def counts_by_the_standard(kind: str, given: list[list[int]], preset: int = 3) -> list[int]:
    count, found = 0, []
    for before, (pulse, other) in pairwise([[0, 0], *given]):
        rises = pulse and not before[0]
        changed = count + bool(rises) * (1 if kind == "CTU" else -1)
        count = (0 if kind == "CTU" else preset) if other else changed
        found.append(int(count >= preset if kind == "CTU" else count <= 0))
    return found


HAVE = [("neza", "TON"), ("neza", "TOF"), ("neza", "TP"), *((one, "TON") for one in FAMILIES[1:]), ("s7-200", "TOF"), ("gutta", "TOF")]  # fmt: skip


@pytest.mark.parametrize(("family", "kind"), HAVE)
def test_a_timer_does_what_the_standard_says(family: str, kind: str) -> None:
    dice = random.Random(f"{family}{kind}")
    for _ in range(4):
        given = rows(dice, 2)
        on, off = outputs(timed(kind), family, given)
        wanted = by_the_standard(kind, given)
        assert 0 < sum(wanted) < len(wanted)
        assert on == wanted
        assert off == [1 - bit for bit in wanted]


@pytest.mark.parametrize(
    ("family", "kind"), [*((one, "CTU") for one in FAMILIES), *((one, "CTD") for one in FAMILIES if one != "fx")]
)
def test_a_counter_does_what_the_standard_says(family: str, kind: str) -> None:
    dice = random.Random(f"{family}{kind}")
    for _ in range(4):
        given = [[a, int(dice.random() < 0.02)] for a, _ in rows(dice, 2, 250)]
        given[0] = [0, 0]
        on, off = outputs(counted(kind, *(("CU", "R") if kind == "CTU" else ("CD", "LD"))), family, given)
        wanted = counts_by_the_standard(kind, given)
        assert 0 < sum(wanted) < len(wanted)
        assert on == wanted
        assert off == [1 - bit for bit in wanted]


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("name", ["seal_in", "branches"])
def test_files_of_contacts_and_coils_run_in_every_family(name: str, family: str) -> None:
    ladder, said = read_plcopen((FILES / f"{name}.xml").read_bytes())
    assert not errors(said)
    if name == "branches" and family in {"neza", "gutta"}:
        with pytest.raises(NotRepresentableError):
            lower(fitted(ladder, family).ladder, family)  # no pulse coil there
        ladder = Ladder(ladder.rungs[:1])
    if name == "seal_in" and family in {"neza", "gutta"}:
        ladder = Ladder(ladder.rungs[:1])  # no edge of an output there, and of a bit
    if family == "gutta" and name == "branches":
        return
    made, table = program(ladder, family)
    if name == "seal_in":
        on, off, lamp = table["%I0.0"], table["%I0.1"], table["%Q0.0"]
        trace = run(made, [{on: 1, off: 0}, {on: 0, off: 0}, {on: 0, off: 1}, {on: 0, off: 0}])
        assert [int(repr(bit)) for bit in trace.values(lamp)] == [1, 1, 0, 0]


def test_the_files_with_boxes_run_where_the_family_has_them() -> None:
    for name, family in (("timers", "neza"), ("counters", "neza"), ("counters", "s7-200"), ("counters", "gutta")):
        ladder, _ = read_plcopen((FILES / f"{name}.xml").read_bytes())
        made, _ = program(ladder, family)
        assert made.runs


def test_a_configured_block_has_its_line_and_its_count_is_compared() -> None:
    made = fitted(counted("CTU", "CU", "R"), "neza")
    assert made.configuration == ("%C0: P=3",)
    assert made.ladder.rungs[0].outs == (Box("BLK %C0", (("R", Contact("%I0.1")),), "CU"),)
    assert made.ladder.rungs[1].stem == Compared("%C0.V", ">=", "3")
    assert made.ladder.rungs[2].stem == Compared("%C0.V", "<", "3")
    made = fitted(timed("TP"), "neza")
    assert made.configuration == ("%TM0: TYPE=TP TB=100ms P=5",)
    assert made.ladder.rungs[0].outs == (Box("BLK %TM0", (), "IN"),)
    assert made.ladder.rungs[1].stem == Contact("%TM0.Q")


def test_names_without_an_address_take_memory_bits_that_are_free() -> None:
    ladder = Ladder((Rung(Contact("%M0.0"), (Coil("MARK"), Coil("%Q1.2"))), Rung(Contact("MARK"), (Coil("OTHER"),))))
    assert fitted(ladder, "fx").table == {"%M0.0": "M0", "%Q1.2": "Y12", "MARK": "M1", "OTHER": "M2"}
    assert fitted(ladder, "s7-200").table == {"%M0.0": "M0.0", "%Q1.2": "Q1.2", "MARK": "M0.1", "OTHER": "M0.2"}
    assert fitted(ladder, "neza").table == {"%M0.0": "%M0", "%Q1.2": "%Q1.2", "MARK": "%M1", "OTHER": "%M2"}


@pytest.mark.parametrize(
    ("family", "word", "one"),
    [
        ("fx", "TOF", Rung(Contact("X0"), (Box("TOF T, T#1S"),))),
        ("s7-200", "TP", Rung(Contact("I0.0"), (Box("TP T, T#1S"),))),
        ("neza", "CTUD", Rung(Contact("%I0.0"), (Box("CTUD C, 3", (), "CU"),))),
        ("s7-200", "CTUD", Rung(Contact("I0.0"), (Box("CTUD C, 3", (), "CU"),))),
        ("neza", "T#1US", Rung(Contact("%I0.0"), (Box("TON T, T#1US"),))),
        ("s7-200", "T#10D", Rung(Contact("I0.0"), (Box("TON T, T#10D"),))),
        ("neza", "WAIT", Rung(Contact("%I0.0"), (Box("TON T, WAIT"),))),
        ("neza", "LIMIT", Rung(Contact("%I0.0"), (Box("CTU C, LIMIT", (), "CU"),))),
        ("neza", "99999", Rung(Contact("%I0.0"), (Box("CTU C, 99999", (), "CU"),))),
        ("s7-200", "99999", Rung(Contact("I0.0"), (Box("CTU C, 99999", (), "CU"),))),
        ("s7-200", "%I0.9", Rung(Contact("%I0.9"), (Coil("Q0.0"),))),
        ("s7-200", "%I0.1.2", Rung(Contact("%I0.1.2"), (Coil("Q0.0"),))),
        ("s7-200", "%Q99.0", Rung(Contact("I0.1"), (Coil("%Q99.0"),))),
        ("neza", "CU", Rung(Contact("%I0.0"), (Box("CTU C, 3", (), "R"),))),
        ("neza", "TON T37, 50", Rung(Contact("%I0.0"), (Box("TON T37, 50"),))),
    ],
)
def test_what_has_no_counterpart_is_named(family: str, word: str, one: Rung) -> None:
    with pytest.raises(NotRepresentableError) as refused:
        fitted(Ladder((one,)), family)
    assert word in refused.value.reason.en
    assert word in refused.value.reason.zh


def test_times_of_the_standard_are_counted_exactly() -> None:
    assert [milliseconds(f"T#{one}") for one in ("5S", "1M30S", "1.5S", "2H", "1D", "250MS")] == [
        5_000, 90_000, 1_500, 7_200_000, 86_400_000, 250,
    ]  # fmt: skip
    assert milliseconds("T#500US") == milliseconds("T#1MS") / 2
    assert milliseconds("5S") is milliseconds("T#") is milliseconds("T#-5S") is milliseconds("T#S5") is None
