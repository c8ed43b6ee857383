"""Random programs with timers, counters and words: the machine and a direct evaluator agree at the end of every scan."""

from __future__ import annotations

import sys
from pathlib import Path
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.machine import run
from plcteach.stl import read

sys.path.insert(0, str(Path(__file__).parent))
from direct import Clock, Direct, Program, Sink, kept, random_program, random_scans, render, spelled, watched

FAMILIES = ("s7-200", "gutta", "fx", "neza")
PROGRAMS, CHUNK = 650, 50
Scans = list[tuple[dict[str, bool], int]]


def direct_ends(program: Program, scans: Scans, how: type[Direct] = Direct) -> list[list[int]]:
    """What the evaluator has at every scan's end: a row of numbers for each scan, in the order of `watched`."""
    names, one, found = watched(program), how(program), []
    for inputs, dt in scans:
        one.scan(inputs, dt)
        found.append([one.word(name) if word else int(one.bit(name)) for name, word in names])
    return found


def machine_ends(program: Program, scans: Scans) -> list[list[int]]:
    """What the machine has, by running the family's list."""
    family = program.family
    code = read(render(program, family), family)
    assert not [one for one in code.diagnostics if one.severity == "error"], code.diagnostics
    first = {kept(family, name, word=True): value for name, value in program.first.items() if used(program, name)}
    rows = [{spelled(family, name): int(bit) for name, bit in inputs.items()} | {"ms": dt} for inputs, dt in scans]
    trace = run(code, [rows[0] | first, *rows[1:]])
    columns = []
    for name, word in watched(program):
        changes = {at: int(repr(value)) for at, value in trace.edges(kept(family, name, word=word))}
        column = [changes.get(0, 0)]
        column += [changes.get(at, None) for at in trace.starts[1:]]
        for scan in range(1, len(column)):
            column[scan] = column[scan - 1] if column[scan] is None else column[scan]
        columns.append(column)
    return [list(row) for row in zip(*columns, strict=True)]


def used(program: Program, name: str) -> bool:
    return name[0] != "p" or program.family != "neza"


def disagreement(program: Program, scans: Scans, how: type[Direct] = Direct) -> str:
    """Say where the two first differ, with the program; "" if nowhere."""
    machine, direct = machine_ends(program, scans), direct_ends(program, scans, how)
    if machine == direct:
        return ""
    scan = next(at for at, (one, other) in enumerate(zip(machine, direct, strict=True)) if one != other)
    names = [kept(program.family, name, word=word) for name, word in watched(program)]
    rows = zip(names, machine[scan], direct[scan], strict=True)
    apart = [f"{name}: the machine {one}, directly {other}" for name, one, other in rows if one != other]
    inputs = [f"  {at}: {''.join(str(int(bit)) for bit in row.values())} after {dt} ms" for at, (row, dt) in enumerate(scans[: scan + 1])]
    given_ = f"first {program.first}"
    return "\n".join(["", f"scan {scan}", *apart, "", render(program, program.family), "", given_, *inputs])


def drawn(family: str, seed: int) -> tuple[Program, Scans]:
    chance = Random(f"{family} {seed}")  # noqa: S311
    return random_program(chance, family), random_scans(chance, chance.randint(25, 32))


@pytest.mark.parametrize("start", range(0, PROGRAMS, CHUNK))
@pytest.mark.parametrize("family", FAMILIES)
def test_the_machine_and_the_direct_evaluator_agree(family: str, start: int) -> None:
    for seed in range(start, start + CHUNK):
        said = disagreement(*drawn(family, seed))
        assert not said, f"{family}, seed {seed}{said}"
