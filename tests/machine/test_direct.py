"""Random programs with timers, counters and words: the machine and a direct evaluator agree at the end of every scan.

The machine runs a family's list; the evaluator (in direct.py) works out the contacts and blocks that the list was written from
and imports nothing of the package. A program with an odd seed becomes generated source after four scans, so that both ways of
running are compared.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from itertools import islice
from pathlib import Path
from random import Random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from plcteach.machine import recorder, run
from plcteach.stl import read

sys.path.insert(0, str(Path(__file__).parent))
from direct import Clock, Direct, Program, Sink, kept, random_program, random_scans, render, spelled, watched

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time

FAMILIES = ("s7-200", "gutta", "fx", "neza")
PROGRAMS, CHUNK = 600, 50
PATIENCE = (24, 4)
"""After so many scans a run becomes generated source: late with an even seed, soon with an odd one."""

Scans = list[tuple[dict[str, bool], int]]
Drawn = tuple[Program, Scans]


def drawn(chance: Random, family: str) -> Drawn:
    return random_program(chance, family), random_scans(chance, chance.randint(25, 40))


def seeded(family: str, seed: int) -> Drawn:
    return drawn(Random(f"{family} {seed}"), family)


def directly(program: Program, scans: Scans, how: type[Direct] = Direct) -> list[list[int]]:
    """What the evaluator has at every scan's end: a row for each scan, in the order of `watched`."""
    names, one, found = watched(program), how(program), []
    for inputs, dt in scans:
        one.scan(inputs, dt)
        found.append([one.word(name) if word else int(one.bit(name)) for name, word in names])
    return found


def by_machine(program: Program, scans: Scans) -> list[list[int]]:
    """What the machine has, which runs the family's list."""
    family = program.family
    code = read(render(program, family), family)
    assert not [one for one in code.diagnostics if one.severity == "error"], (code.diagnostics, render(program, family))
    first = {kept(family, name, word=True): value for name, value in program.first.items()}
    rows = [{spelled(family, name): int(bit) for name, bit in inputs.items()} | {"ms": dt} for inputs, dt in scans]
    trace = run(code, [rows[0] | first, *rows[1:]])
    columns = []
    for name, word in watched(program):
        changes = {at: int(repr(value)) for at, value in trace.edges(kept(family, name, word=word))}
        value, column = 0, []
        for at in trace.starts:
            value = changes.get(at, value)
            column.append(value)
        columns.append(column)
    return [list(row) for row in zip(*columns, strict=True)]


def disagreement(program: Program, scans: Scans, how: type[Direct] = Direct) -> str:
    """Say where the two first differ, with the program; "" if nowhere."""
    machine, direct = by_machine(program, scans), directly(program, scans, how)
    if machine == direct:
        return ""
    scan = next(at for at, (one, other) in enumerate(zip(machine, direct, strict=True)) if one != other)
    names = [kept(program.family, name, word=word) for name, word in watched(program)]
    rows = zip(names, machine[scan], direct[scan], strict=True)
    apart = [f"{name}: the machine {one}, directly {other}" for name, one, other in rows if one != other]
    seen = [
        f"{at}: inputs {''.join(str(int(bit)) for bit in row.values())} after {dt} ms"
        for at, (row, dt) in enumerate(scans[: scan + 1])
    ]
    words = f"at first {program.first}"
    return "\n".join([f"scan {scan}", *apart, render(program, program.family), words, *seen, repr(program)])


@pytest.mark.parametrize("start", range(0, PROGRAMS, CHUNK))
@pytest.mark.parametrize("family", FAMILIES)
def test_the_machine_agrees_with_the_direct_evaluator(family: str, start: int, monkeypatch: pytest.MonkeyPatch) -> None:
    for seed in range(start, start + CHUNK):
        monkeypatch.setattr(recorder, "PATIENCE", PATIENCE[seed % 2])
        said = disagreement(*seeded(family, seed))
        assert not said, f"{family}, seed {seed}, {said}"


def some(family: str) -> st.SearchStrategy[Drawn]:
    """Programs and scans whose every choice is hypothesis's own, so that it can make them smaller."""
    return st.randoms(use_true_random=False).map(lambda chance: drawn(chance, family))


@pytest.mark.parametrize("family", FAMILIES)
@settings(max_examples=25, deadline=None, suppress_health_check=list(HealthCheck))
@given(data=st.data())
def test_they_agree_on_what_hypothesis_draws_too(family: str, data: st.DataObject) -> None:
    said = disagreement(*data.draw(some(family)))
    assert not said, said


# Evaluators with one rule broken: the random programs must tell each of them from the machine.


class StartCounts(Direct):
    """The scan that starts a timer adds its time."""

    def start(self, clock: Clock) -> None:
        super().start(clock)
        clock.ms += self.dt


class LevelCounts(Direct):
    """A counter counts in every scan in which its pin is on."""

    def counts(self, sink: Sink, pins: dict[str, bool], pin: str) -> bool:
        del sink
        return pins.get(pin, False)


class OffEarly(Direct):
    """An off-delay goes off one scan early."""

    def off_delay(self, clock: Clock, *, power: bool) -> None:
        super().off_delay(clock, power=power)
        if clock.going and clock.ms + self.dt >= clock.goal:
            clock.bit = clock.going = False


class ResetYields(Direct):
    """R of a counter does nothing in a scan in which the counter counts."""

    def count(self, sink: Sink, pins: dict[str, bool]) -> None:
        counts = any(pins.get(pin) and not self.seen.get((sink.target, pin), True) for pin in ("CU", "CD"))
        super().count(sink, pins | ({"R": False} if counts else {}))


class ContactStays(Direct):
    """R or RST clears the current value and leaves the contact."""

    def clear(self, sink: Sink, pins: dict[str, bool]) -> None:
        before = self.bit(sink.target)
        super().clear(sink, pins)
        self.bits[sink.target] = before


class FirstEdge(Direct):
    """What is on in the first scan has risen."""

    def between(self, how: str, *, before: bool | None, now: bool) -> bool:
        return super().between(how, before=bool(before), now=now)


class EdgeByLine(Direct):
    """An edge is since its line was last executed, also where it is between the images of two scans."""

    def rung(self, rung: object) -> None:
        self.image = dict(self.bits)
        super().rung(rung)


class HoldsAll(Direct):
    """Every on-delay holds its time when its input goes."""

    def time(self, sink: Sink, *, power: bool) -> None:
        if power or self.clocks[sink.target].rule != "on":
            super().time(sink, power=power)


class ForgetsAll(Direct):
    """A retentive timer forgets its time when its input goes."""

    def time(self, sink: Sink, *, power: bool) -> None:
        super().time(sink, power=power)
        clock = self.clocks[sink.target]
        clock.ms = clock.ms if power or clock.rule != "retentive" else 0


class OtherMoment(Direct):
    """Timers are brought up to date at the other moment: at the scan's start, or with their line."""

    def __post_init__(self) -> None:
        super().__post_init__()
        every = {clock.base for clock in self.clocks.values()}
        self.ways = replace(self.ways, at_scan_start=tuple(every - set(self.ways.at_scan_start)))


class OtherSums(Direct):
    """A sum that does not fit is left as another family leaves it."""

    def __post_init__(self) -> None:
        super().__post_init__()
        other = "wraps" if self.ways.outside != "wraps" else "keeps"
        self.ways = replace(self.ways, outside=other)


class PulseAgain(Direct):
    """A pulse that is under way begins anew when its input comes again."""

    def pulse(self, clock: Clock, *, power: bool) -> None:
        if power and not clock.was:
            clock.going = False
        super().pulse(clock, power=power)


class SetFirst(Direct):
    """S of a counter comes before R."""

    def count_preset(self, sink: Sink, pins: dict[str, bool]) -> None:
        super().count_preset(sink, pins | {"R": bool(pins.get("R")) and not pins.get("S")})


class OrderTurned(Direct):
    """A register takes from its other end."""

    def store(self, sink: Sink, pins: dict[str, bool]) -> None:
        super().store(Sink(sink.verb, sink.target, (), {"FIFO": "LIFO", "LIFO": "FIFO"}[sink.rule]), pins)


MUTANTS = [
    *((StartCounts, family) for family in FAMILIES),
    *((LevelCounts, family) for family in FAMILIES),
    *((OffEarly, family) for family in ("s7-200", "gutta", "neza")),
    *((ResetYields, family) for family in ("s7-200", "gutta", "neza")),
    *((ContactStays, family) for family in ("s7-200", "gutta", "fx")),
    *((FirstEdge, family) for family in FAMILIES),
    *((HoldsAll, family) for family in FAMILIES),
    *((ForgetsAll, family) for family in ("s7-200", "gutta", "fx")),
    *((OtherMoment, family) for family in FAMILIES),
    *((OtherSums, family) for family in FAMILIES),
    *((one, "neza") for one in (EdgeByLine, PulseAgain, SetFirst, OrderTurned)),
]


def told_apart(program: Program, scans: Scans, mutant: type[Direct]) -> bool:
    return directly(program, scans) != directly(program, scans, mutant)


@pytest.mark.parametrize(("mutant", "family"), MUTANTS, ids=lambda one: getattr(one, "__name__", one))
def test_a_broken_rule_is_found(mutant: type[Direct], family: str) -> None:
    seeds = (seed for seed in range(PROGRAMS) if told_apart(*seeded(family, seed), mutant))
    found = list(islice(seeds, 3))
    assert len(found) == 3
    assert disagreement(*seeded(family, found[0]), mutant)
