"""One instruction, executed: what it takes, gives, reads and writes, against an evaluator that knows lists and nothing else."""

from __future__ import annotations

from dataclasses import dataclass, field

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.area import Address
from plcteach.core.effect import Shape
from plcteach.core.insn import Insn, Operand
from plcteach.core.notation import parse_effect
from plcteach.core.program import Line
from plcteach.core.text import same
from plcteach.dialects import dialect
from plcteach.machine import ONE, ZERO, Column, X, step
from plcteach.stl import read

MASK = 0xFFFF


@dataclass(frozen=True)
class Mask:
    """Sixteen plain truth values: a signal of the test's own."""

    value: int

    def __and__(self, other: Mask) -> Mask:
        return Mask(self.value & other.value)

    def __or__(self, other: Mask) -> Mask:
        return Mask(self.value | other.value)

    def __xor__(self, other: Mask) -> Mask:
        return Mask(self.value ^ other.value)

    def __invert__(self) -> Mask:
        return Mask(self.value ^ MASK)

    def edge(self, previous: Mask | None, *, rising: bool) -> Mask:
        raise AssertionError((previous, rising))


BLANK = Mask(0b1010101010101010)


@dataclass
class World:
    """A PLC of the test's own: bits by address, and a note of what was asked."""

    bits: dict[str, object]
    last: object = None
    asked: list[str] = field(default_factory=list)
    rail: object = None
    spells: bool = True

    def read(self, operand: Operand, address: Address):
        self.asked.append(f"{operand.name} {address.text}")
        return self.bits[address.text]

    def past(self, address: Address | None, value):
        self.asked.append(f"past {address}")
        return value, self.last

    def following(self, address: Address, count: int) -> tuple[Address, ...]:
        return tuple(dialect("s7-200").following(address, count))


BIT = Address("I", 0, "I0.0")


@st.composite
def formulas(draw: st.DrawFn, names: list[str]) -> str:
    leaf = st.sampled_from([*names, "bit"])
    return draw(
        st.recursive(
            leaf,
            lambda inner: (
                st.tuples(inner, st.sampled_from("&|^"), inner).map("{0[0]}{0[1]}{0[2]}".format)
                | inner.map("!{}".format)
                | inner.map("({})".format)
            ),
            max_leaves=5,
        )
    )


@dataclass(frozen=True)
class Case:
    """A random effect on random stacks: for each stack what its clause takes and gives, and the values it holds, top first."""

    takes: list[list[str]]
    gives: list[list[str]]
    shapes: list[Shape]
    stacks: list[list[Mask]]
    n: int

    @property
    def text(self) -> str:
        return " ; ".join(
            f"{f'{shape.name}: ' if shape.name else ''}{' '.join(takes)} -- {' '.join(gives)}"
            for shape, takes, gives in zip(self.shapes, self.takes, self.gives, strict=True)
        )


MASKS = st.integers(0, MASK).map(Mask)


@st.composite
def cases(draw: st.DrawFn) -> Case:
    letters = iter("abcdefgh")
    takes = [
        [next(letters) for _ in range(count)] for count in draw(st.lists(st.integers(0, 3), min_size=1, max_size=2))
    ]
    every = [name for some in takes for name in some]
    give = st.sampled_from([*every, "[n]"]) | formulas(every)
    gives = [draw(st.lists(give, max_size=3)) for _ in takes]
    shapes = [Shape("s" * number, draw(st.integers(1, 5)), draw(st.booleans())) for number in range(len(takes))]
    stacks = [draw(st.lists(MASKS, min_size=one.depth if one.fixed else 0, max_size=one.depth)) for one in shapes]
    return Case(takes, gives, shapes, stacks, draw(st.integers(0, 5)))


def expected(case: Case, bit: Mask) -> list[list[Mask]]:
    """Take from the tops, give to the tops, cut or fill at the bottoms; formulas are Python's with ~ for !."""
    names: dict[str, Mask] = {"bit": bit}
    rests = []
    for takes, stack in zip(case.takes, case.stacks, strict=True):
        rest = list(stack)
        for name in reversed(takes):
            names[name] = rest.pop(0) if rest else BLANK
        rests.append(rest)
    main = case.stacks[0]
    after = []
    for gives, rest, shape in zip(case.gives, rests, case.shapes, strict=True):
        cells = rest
        for give in gives:
            there = main[case.n] if case.n < len(main) else BLANK
            value = there if give == "[n]" else eval(give.replace("!", "~"), {}, names)  # noqa: S307
            cells = [value, *cells]
        cells = cells[: shape.depth]
        after.append(cells + [BLANK] * (shape.depth - len(cells)) * shape.fixed)
    return after


@settings(max_examples=200, deadline=None)
@given(cases(), MASKS)
def test_a_step_does_what_its_effect_says(case: Case, bit: Mask) -> None:
    effect = parse_effect(case.text).bind({"n": case.n})
    line = Line(Insn("XYZ", (Operand("bit", "bit"),), effect, same("xyz")), (BIT,), effect)
    world = World({"I0.0": bit})
    before = tuple(map(tuple, case.stacks))
    one = step(line, tuple(case.shapes), before, world, BLANK)  # type: ignore[type-var]
    assert [list(cells) for cells in one.after] == expected(case, bit)
    assert one.before == before == tuple(map(tuple, case.stacks))
    assert one.written == ()
    assert set(world.asked) <= {"bit I0.0"}


@settings(max_examples=100, deadline=None)
@given(cases(), MASKS)
def test_the_origins_tell_where_each_value_came_from(case: Case, bit: Mask) -> None:
    effect = parse_effect(case.text).bind({"n": case.n})
    line = Line(Insn("XYZ", (Operand("bit", "bit"),), effect, same("xyz")), (BIT,), effect)
    one = step(line, tuple(case.shapes), tuple(map(tuple, case.stacks)), World({"I0.0": bit}), BLANK)  # type: ignore[type-var]
    for cells, origins in zip(one.after, one.flow.after, strict=True):
        for cell, origin in zip(cells, origins, strict=True):
            if origin.how in {"kept", "copied"}:
                stack, place = origin.sources[0]
                there = one.before[stack]
                assert cell == (there[place] if place < len(there) else BLANK)
            elif origin.how == "blank":
                assert cell == BLANK


# What an instruction reads and writes beside the stack.

NINE = ((ZERO, ONE, *[X] * 7),)


def s7(text: str, *, top: Column = ZERO, last: Column | None = None, **bits: Column):
    line = read(text, "s7-200").lines[0]
    world = World({name.replace("_", "."): value for name, value in bits.items()}, last)
    before = ((top, ONE, *[X] * 7),)
    return step(line, dialect("s7-200").shapes, before, world, X), world  # type: ignore[arg-type]


def seen(pairs) -> list[str]:
    return [f"{address.text}={value!r}" for address, value in pairs]


def test_only_what_the_effect_reads_is_read() -> None:
    assert seen(s7("LD I0.0", I0_0=ONE)[0].read) == ["I0.0=1"]
    assert seen(s7("A I0.0", I0_0=ONE)[0].read) == ["I0.0=1"]
    for text in ("= Q0.0", "OLD", "LPS", "NOT", "LDS 3", "NOP 0"):
        one, world = s7(text)
        assert one.read == ()
        assert world.asked == []


def test_a_coil_writes_the_top_and_leaves_the_stack() -> None:
    for top in (ZERO, ONE, X):
        one, _ = s7("= Q0.0", top=top)
        assert seen(one.written) == [f"Q0.0={top!r}"]
        assert one.after == one.before


@pytest.mark.parametrize(
    ("text", "top", "old", "new"),
    [("S Q0.0, 2", *row.split()) for row in ("0 0 0", "0 1 1", "1 0 1", "1 1 1", "x 0 x", "x 1 1", "0 x x", "1 x 1")]
    + [("R Q0.0, 2", *row.split()) for row in ("0 0 0", "0 1 1", "1 0 0", "1 1 0", "x 0 0", "x 1 x", "0 x x", "1 x 0")],
)  # fmt: skip
def test_set_and_reset_by_table(text: str, top: str, old: str, new: str) -> None:
    word = {"0": ZERO, "1": ONE, "x": X}
    one, _ = s7(text, top=word[top], Q0_0=word[old], Q0_1=word[old])
    assert seen(one.written) == [f"Q0.0={new}", f"Q0.1={new}"]
    assert one.after == one.before


def test_an_edge_looks_back_and_leaves_what_the_next_scan_needs() -> None:
    up, world = s7("EU", top=ONE, last=ZERO)
    assert (up.after[0][0], up.remembered, world.asked) == (ONE, ONE, ["past None"])
    assert s7("EU", top=ONE, last=ONE)[0].after[0][0] == ZERO
    assert s7("ED", top=ZERO, last=ONE)[0].after[0][0] == ONE
    assert s7("EU", top=ONE, last=None)[0].after[0][0] == ZERO
    assert s7("LD I0.0", I0_0=ONE)[0].remembered is None


def test_a_step_is_told_in_one_line() -> None:
    one, _ = s7("LD I0.0", I0_0=ONE)
    assert repr(one) == "Step('LD I0.0': (0, 1, x, x, x, x, x, x, x) -> (1, 0, 1, x, x, x, x, x, x))"


def test_too_few_cells_give_x_and_never_an_exception() -> None:
    line = read("ALD", "gutta").lines[0]
    for before in (((), ()), ((ONE,), ())):
        one = step(line, dialect("gutta").shapes, before, World({}), X)  # type: ignore[arg-type]
        assert one.after == ((X,), ())
    lrd = read("LRD", "gutta").lines[0]
    one = step(lrd, dialect("gutta").shapes, ((ONE,), ()), World({}), X)  # type: ignore[arg-type]
    assert one.after[0] == (X,)
