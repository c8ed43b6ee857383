"""What a film tells of its ladder: which line drew which sign, and which parts carry power at each step."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.figure.growth import Growth
from plcteach.figure.power import by_bits, live_nets
from plcteach.figure.verbs import film_of
from plcteach.ladder.layout import layout
from plcteach.ladder.lower import lower
from plcteach.machine import run
from plcteach.stl import read

sys.path.insert(0, str(Path(__file__).parents[1] / "ladder"))
from random_ladders import ladders

if TYPE_CHECKING:
    from plcteach.core.ladder import Ladder

BLOCKS = "LD I0.0; A I0.1; LD I0.2; AN I0.3; OLD; LD I0.4; O I0.5; ALD; = Q0.0; NOT; = Q0.1"


def lit(film: Any, upto: int) -> set[str]:
    """Give the parts with power after some steps, as the browser puts them together."""
    on: set[str] = set()
    for step in film.data["steps"][: upto + 1]:
        for part, now in step.get("power", ()):
            (on.add if now else on.discard)(part)
    return on


def test_each_line_names_the_signs_that_it_draws_and_a_join_its_two_blocks() -> None:
    film = film_of(BLOCKS, "s7-200", {"I0.2": 1})
    growth = film.data["ladder"]["growth"]
    assert [line.get("added") for line in growth] == [
        ["s0-0"], ["s0-1"], ["s0-2"], ["s0-3"], None, ["s0-4"], ["s0-5"], None, ["s0-6"], ["s0-7"], ["s0-8"],
    ]  # fmt: skip
    assert growth[4]["blocks"] == [["s0-0", "s0-1"], ["s0-2", "s0-3"]]
    assert growth[7]["blocks"] == [["s0-0", "s0-1", "s0-2", "s0-3"], ["s0-4", "s0-5"]]
    assert growth[5]["top"] == ["s0-4"]
    (rung,) = film.data["ladder"]["rungs"]
    assert rung["lines"][:3] == [[0], [1], [2]]
    assert rung["formulas"] == [
        ["Q0.0", "(I0.0·I0.1+I0.2·/I0.3)·(I0.4+I0.5)"],
        ["Q0.1", "/((I0.0·I0.1+I0.2·/I0.3)·(I0.4+I0.5))"],
    ]
    for part in [f"s0-{at}" for at in range(9)]:
        assert f'data-part="{part}"' in rung["svg"]


def test_power_grows_with_the_list_and_a_not_lights_up_only_when_it_is_reached() -> None:
    film = film_of(BLOCKS, "s7-200", {"I0.2": 1})
    assert lit(film, 3) == {"n0-0", "s0-2"} | (lit(film, 3) & {"n0-3", "n0-4"})
    assert {"s0-3", "s0-2"} <= lit(film, 4)
    assert not {"s0-7", "s0-8"} & lit(film, 9)
    assert {"s0-7", "s0-8"} <= lit(film, 11)
    assert "s0-6" not in lit(film, 11)


def test_a_new_scan_begins_in_the_dark_and_blocks_and_edges_light_by_what_they_did() -> None:
    text = "LD I0.0; EU; = Q0.0; LD I0.1; TON T37, 5; LD I0.2; LD I0.3; CTU C0, 3; LD T37; = Q0.1"
    film = film_of(text, "s7-200", [{"I0.3": 1}, {"I0.0": 1, "I0.1": 1}, {}])
    steps = film.data["steps"]
    starts = [at for at, step in enumerate(steps) if step["line"] < 0]
    assert all(lit(film, at) == set() for at in starts)
    ends = [*(at - 1 for at in starts[1:]), len(steps) - 1]
    first, second, third = (lit(film, at) for at in ends)
    rungs = {tuple(sorted(rung["lines"][-1])): at for at, rung in enumerate(film.data["ladder"]["rungs"])}
    edge, timer = rungs[2,], rungs[4,]
    assert f"s{edge}-1" in second
    assert f"s{edge}-1" not in first | third
    assert f"s{timer}-1" in second & third
    assert f"s{timer}-1" not in first


@settings(max_examples=120, deadline=None)
@given(ladder=ladders("s7-200"), values=st.integers(0, 15))
def test_after_a_scan_what_is_lit_is_what_the_drawn_contacts_let_through(ladder: Ladder, values: int) -> None:
    program = read(lower(ladder, "s7-200"), "s7-200")
    inputs = {f"I0.{at}": values >> at & 1 for at in range(4)}
    written = {symbol.address for rung in ladder.rungs for symbol in rung.symbols if hasattr(symbol, "kind")}
    read_too = {symbol.address for rung in ladder.rungs for symbol in rung.symbols if hasattr(symbol, "negated")}
    if written & read_too:
        return
    growth = Growth(program)
    growth.start()
    for step in run(program, [inputs]).scans[0].steps:
        growth.step(step)
    for number, one in enumerate(growth.lifted.rungs):
        nets = live_nets(layout(one.rung), by_bits(inputs))
        shown = {part for part in growth.lit[number] if part.startswith("n")}
        assert shown == {f"n{number}-{net}" for net in nets}
