"""One machine, three ways: line by line, as a generated function, and many timelines side by side, for every instruction.

The programs are the examples of each family's table, which together use every instruction, and random mixtures of them.
"""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING

import pytest

from plcteach.dialects import families
from plcteach.machine import recorder, run
from plcteach.machine.generated import Generated, Unsure
from plcteach.machine.lanes import lanes
from plcteach.stl import read

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time

if TYPE_CHECKING:
    from plcteach.core.program import Program
    from plcteach.machine.scan import Trace

SCANS = 90
EXAMPLES = [(family.name, text) for family in families() for text in family.examples]


def rows(program: Program, seed: int, count: int = SCANS) -> list[dict[str, int]]:
    """Give inputs that change now and then; scans of different lengths."""
    chance = Random(seed)
    names = [one.text for one in program.addresses("input")]
    return [
        {name: chance.randint(0, 1) for name in names if chance.random() < 0.4} | {"ms": chance.choice((10, 30, 70))}
        for _ in range(count)
    ]


def ends(trace: Trace) -> dict[str, list[str]]:
    """Give what every bit and number was at every scan's end; to be 0 from the start is no change."""
    found = {}
    for key, (when, values) in sorted(trace.changes.items()):
        first = 1 if repr(values[0]) == "0" else 0
        found[key] = [str(when[first:]), str(values[first:])]
    return {key: value for key, value in found.items() if value[0] != "[]"}


def both_ways(program: Program, inputs: list[dict[str, int]], monkeypatch: pytest.MonkeyPatch) -> tuple[Trace, Trace]:
    monkeypatch.setattr(recorder, "PATIENCE", 3)
    quick = run(program, inputs)
    monkeypatch.setattr(recorder, "PATIENCE", 10**9)
    return quick, run(program, inputs)


@pytest.mark.parametrize(("name", "text"), EXAMPLES)
def test_generated_scans_are_the_scans(name: str, text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    program = read(text.replace("; ", "\n"), name)
    assert not [one for one in program.diagnostics if one.severity == "error"]
    quick, slow = both_ways(program, rows(program, 1), monkeypatch)
    assert ends(quick) == ends(slow)
    assert quick.memory.bits == slow.memory.bits
    assert quick.memory.words == slow.memory.words
    assert [step.after for step in quick.scans[SCANS - 1].steps] == [step.after for step in slow.scans[SCANS - 1].steps]


def test_most_examples_can_be_generated() -> None:
    made = 0
    for name, text in EXAMPLES:
        program = read(text.replace("; ", "\n"), name)
        memory = run(program, rows(program, 2, 20)).memory
        try:
            Generated(program, memory, tuple(one.text for one in program.addresses("input")))
            made += 1
        except Unsure:
            continue
    assert made > 0.8 * len(EXAMPLES)


@pytest.mark.parametrize(("name", "text"), EXAMPLES)
def test_side_by_side_is_one_by_one(name: str, text: str) -> None:
    program = read(text.replace("; ", "\n"), name)
    timelines = [[{k: v for k, v in row.items() if k != "ms"} for row in rows(program, seed, 25)] for seed in range(4)]
    together = lanes(program, timelines, scan_ms=40)
    singles = [run(program, line, scan_ms=40) for line in timelines]
    watched = [one.text for role in ("output", "memory") for one in program.addresses(role)]
    watched += [one.text for one in program.words() if one.size > 1]
    for lane, single in enumerate(singles):
        for address in watched:
            values = [repr(together.value(address, scan, lane)) for scan in range(25)]
            assert values == [repr(one) for one in single.values(address)], address


@pytest.mark.parametrize("name", [family.name for family in families()])
def test_mixtures_of_examples_agree(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    chance = Random(7)
    texts = [text for family, text in EXAMPLES if family == name and "END" not in text and "SR" not in text.split()]
    for number in range(6):
        mixture = "; ".join(chance.sample(texts, 4)).replace("; ", "\n")
        program = read(mixture, name)
        if [one for one in program.diagnostics if one.severity == "error"]:
            continue
        quick, slow = both_ways(program, rows(program, number, 60), monkeypatch)
        assert ends(quick) == ends(slow), mixture
