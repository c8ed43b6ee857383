"""The ways of proving against each other, against running by chance, and against engines that were broken on purpose."""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.check import same
from plcteach.check.proof import circuit, product, trial, walk
from plcteach.check.proof.budget import Budget
from plcteach.check.proof.chance import Chance
from plcteach.check.proof.induction import always_equal
from plcteach.check.proof.search import breadth_first, fewest
from plcteach.check.proof.table import TooLarge, model_of, patterns, simplest
from plcteach.check.proof.walk import Walker
from plcteach.core.exercise import Terms
from plcteach.machine import run
from plcteach.machine.gates import Gate, Graph
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.program import Program

# Gates: every operation keeps its truth table, whatever is simplified on the way.

FORMULAS = st.recursive(
    st.integers(0, 4),
    lambda inner: st.one_of(
        st.tuples(st.sampled_from("&|^"), inner, inner),
        st.tuples(st.just("~"), inner),
        st.tuples(st.just("?"), inner, inner, inner),
    ),
    max_leaves=14,
)


def gate(graph: Graph, formula: Any) -> Gate:
    match formula:
        case int():
            return graph.variable(formula)
        case ("&", a, b):
            return gate(graph, a) & gate(graph, b)
        case ("|", a, b):
            return gate(graph, a) | gate(graph, b)
        case ("^", a, b):
            return gate(graph, a) ^ gate(graph, b)
        case ("~", a):
            return ~gate(graph, a)
        case ("?", c, a, b):
            return graph.domain.pick(gate(graph, c), gate(graph, a), gate(graph, b))
    raise AssertionError(formula)


def truth(formula: Any, row: tuple[int, ...]) -> int:
    match formula:
        case int():
            return row[formula]
        case ("&", a, b):
            return truth(a, row) & truth(b, row)
        case ("|", a, b):
            return truth(a, row) | truth(b, row)
        case ("^", a, b):
            return truth(a, row) ^ truth(b, row)
        case ("~", a):
            return 1 - truth(a, row)
        case ("?", c, a, b):
            return truth(a, row) if truth(c, row) else truth(b, row)
    raise AssertionError(formula)


@settings(max_examples=200, deadline=None)
@given(FORMULAS)
def test_gates_keep_their_truth_and_table_and_diagram_agree(formula: Any) -> None:
    graph = Graph()
    for number in range(5):
        graph.variable(number)
    made = gate(graph, formula)
    rows = [tuple(case >> number & 1 for number in range(5)) for case in range(32)]
    expected = sum(truth(formula, row) << case for case, row in enumerate(rows))
    assert graph.compiled([made], range(5)).call(patterns(5), (1 << 32) - 1)[0] == expected
    for few in (12, 0):
        model = model_of(graph, made, rows=few)
        assert (model is None) == (expected == 0)
        if model is not None:
            assert truth(formula, tuple(model.get(number, 0) for number in range(5)))


def test_a_gate_without_a_small_diagram_is_not_known() -> None:
    graph = Graph()
    pairs = graph.zero
    ones = [graph.variable(("a", number)) for number in range(20)]
    others = [graph.variable(("b", number)) for number in range(20)]
    for one, other in zip(ones, others, strict=True):
        pairs |= one & other
    with pytest.raises(TooLarge):
        model_of(graph, pairs & ~graph.variable("c"), nodes=2_000)


# Random programs in time.

CONDITIONS = st.lists(
    st.sampled_from(["A I0.0", "AN I0.0", "A I0.1", "O I0.1", "AN Q0.0", "A M0.0", "ON M0.0", "A T37", "AN T38"]),
    min_size=0,
    max_size=2,
)
ACTS = st.sampled_from(
    ["= Q0.0", "= M0.0", "S M0.0, 1", "R M0.0, 1", "TON T37, {}", "TON T38, {}", "TOF T37, {}", "EU\n= M0.0", "CTU"]
)
LOADS = st.sampled_from(["LD I0.0", "LDN I0.1", "LD I0.1", "LDN T37", "LD M0.0", "LD T38", "LD C0"])


@st.composite
def rung(draw: st.DrawFn) -> str:
    act, count = draw(ACTS), draw(st.integers(1, 4))
    if act == "CTU":
        return f"{draw(LOADS)}\nLD I0.1\nCTU C0, {count}"
    return "\n".join([draw(LOADS), *draw(CONDITIONS), act.format(count)])


PROGRAMS = st.lists(rung(), min_size=1, max_size=3).map(
    lambda rungs: "\n".join([*rungs, "LD T37\nO M0.0\nO C0\n= Q0.0"])
)


def timer_kinds_agree(text: str) -> bool:
    return not ("TON T37" in text and "TOF T37" in text)


def by_chance(one: Program, other: Program, seed: int) -> int | None:
    """Run both on the plain machine; give the first scan in which Q0.0 differs."""
    chance = Random(seed)
    rows, now = [], {"I0.0": 0, "I0.1": 0}
    for _ in range(60):
        for name in now:
            if chance.random() < (0.5 if seed % 2 else 0.1):
                now[name] ^= 1
        rows.append({**now, "ms": chance.choice([0, 100])})
    mine, theirs = run(one, rows)["Q0.0"], run(other, rows)["Q0.0"]
    return next((scan for scan, (a, b) in enumerate(zip(mine, theirs, strict=True)) if a != b), None)


@settings(max_examples=60, deadline=None)
@given(one=PROGRAMS, other=PROGRAMS, seed=st.integers(0, 9))
def test_what_is_equal_survives_chance_and_what_differs_is_replayed(one: str, other: str, seed: int) -> None:
    if not (timer_kinds_agree(one) and timer_kinds_agree(other)):
        return
    mine, theirs = read(one, "s7-200"), read(other, "s7-200")
    exact = same.compare(mine, theirs, terms=Terms(level="exact"))
    found = by_chance(mine, theirs, seed)
    assert exact.status in {"equal", "different"}
    if exact.status == "equal":
        assert found is None
        assert same.compare(mine, theirs, terms=Terms(level="settled")).status in {"equal", "unsettled"}
    else:
        example = exact.counterexample
        assert example is not None
        ends = [repr(run(program, example.inputs).value("Q0.0", example.scan)) for program in (mine, theirs)]
        assert ends[0] != ends[1]
    assert same.compare(theirs, mine, terms=Terms(level="exact")).status == exact.status


@settings(max_examples=40, deadline=None)
@given(text=PROGRAMS)
def test_a_program_rewritten_is_the_same(text: str) -> None:
    if not timer_kinds_agree(text):
        return
    renamed = text.replace("T37", "T101").replace("T38", "T102").replace("M0.0", "M7.7").replace("C0", "C20")
    doubled = "\n".join(
        f"NOT\nNOT\n{row}" if row.startswith(("=", "TO", "S ", "R ")) else row for row in text.split("\n")
    )
    mine = read(text, "s7-200")
    for again in (renamed, doubled):
        if again == renamed and (
            "M0.0" in text and "= M0.0" not in text and "S M0.0" not in text and "R M0.0" not in text
        ):
            continue
        verdict = same.compare(mine, read(again, "s7-200"), terms=Terms(level="exact"))
        assert verdict.status == "equal", again


@settings(max_examples=40, deadline=None)
@given(one=PROGRAMS, other=PROGRAMS)
def test_the_ways_of_proving_never_contradict_each_other(one: str, other: str) -> None:
    if not (timer_kinds_agree(one) and timer_kinds_agree(other)):
        return
    asked = product.product(read(one, "s7-200"), read(other, "s7-200"), Terms())
    budget = Budget(3_000_000)
    walker = Walker(asked, budget)
    found = breadth_first(walker, budget)
    proved = always_equal(asked)
    assert found.status in {"equal", "different"}
    if proved:
        assert found.status == "equal"
    easiest = fewest(Walker(asked, Budget(3_000_000)), Budget(3_000_000))
    assert (easiest is None) == (found.status == "equal")
    if Chance(asked, Budget(500_000)).patient() is not None:
        assert found.status == "different"
    if easiest is not None:
        assert pressed(walker, easiest) <= pressed(walker, found.cases)


def pressed(walker: Walker, cases: tuple[int, ...]) -> int:
    before, count = 0, 0
    for case in cases:
        count += ((case ^ before) & walker.pressed).bit_count()
        before = case
    return count


# Broken on purpose: each mistake makes some verdict of this small table wrong, so that no such mistake stays unseen.

TABLE = [
    ("LD I0.0; TON T37, 5; LD T37; = Q0.0", "LD I0.0; TON T38, 5; LD T38; = Q0.0", "equal"),
    ("LD I0.0; TON T37, 49; LD T37; = Q0.0", "LD I0.0; TON T38, 50; LD T38; = Q0.0", "different"),
    ("LD I0.0; TON T37, 5; LD T37; TON T38, 5; LD T38; = Q0.0", "LD I0.0; TON T39, 10; LD T39; = Q0.0", "equal"),
    ("LD I0.0; O Q0.0; AN I0.1; = Q0.0", "LD I0.0; AN I0.1; = Q0.0", "different"),
    ("LD I0.0; LD I0.1; CTU C0, 3; LD C0; = Q0.0", "LD I0.0; LD I0.1; CTU C0, 4; LD C0; = Q0.0", "different"),
    ("LD I0.0; = M0.0; LD M0.0; = Q0.0", "LD M0.0; = Q0.0; LD I0.0; = M0.0", "equal"),
    ("LD I0.0; TON T33, 3; LD T33; = Q0.0", "LD I0.0; TON T37, 3; LD T37; = Q0.0", "different"),
    ("LD I0.0; TON T33, 15; LD T33; = Q0.0", "LD I0.0; TON T37, 2; LD T37; = Q0.0", "different"),
]


def verdicts() -> list[str]:
    same.forget()
    found = []
    for one, other, _ in TABLE:
        try:
            found.append(same.compare(read(one.replace("; ", "\n")), read(other.replace("; ", "\n"))).status)
        except (KeyError, IndexError, ValueError):
            found.append("broken")
    same.forget()
    return found


RIGHT = [row[2] for row in TABLE]


def test_the_engine_as_it_is_gives_the_verdicts_of_the_table() -> None:
    assert verdicts() == RIGHT


def drop_a_state(patch: pytest.MonkeyPatch) -> None:
    whole = product.Product.narrowed

    def less(self: product.Product) -> product.Product:
        one = whole(self)
        frozen = (
            {name: gate if name != one.state[-1] else one.start[name] for name, gate in one.next.items()}
            if one.state
            else one.next
        )
        return product.replace(one, next=frozen)

    patch.setattr(product.Product, "narrowed", less)


def coarse_ticks(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(product, "bases", lambda program: {max(circuit.bases(program), default=1) * 100})


def starts_with_one(patch: pytest.MonkeyPatch) -> None:
    from plcteach.machine import timers

    on = timers.DRIVES["on"]

    def late(domain: Any, clock: Any, power: Any, goal: Any) -> Any:
        after = on(domain, clock, power, goal)
        began = power & ~clock.going
        return timers.replace(after, ms=domain.pick(began, after.ms + domain.number(1), after.ms))

    patch.setitem(timers.DRIVES, "on", late)


def no_rest(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(walk, "MOST_SETTLING_SCANS", 1)


def never_searches(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(trial, "breadth_first", lambda *_: trial.Found("equal"))


@pytest.mark.parametrize("broken", [drop_a_state, coarse_ticks, starts_with_one, no_rest, never_searches])
def test_a_broken_engine_is_caught(broken: Any) -> None:
    with pytest.MonkeyPatch.context() as patch:
        broken(patch)
        assert verdicts() != RIGHT


@settings(max_examples=100, deadline=None)
@given(cases=st.sets(st.integers(0, 1 << 9), max_size=20))
def test_the_simplest_case_has_the_fewest_inputs_on(cases: set[int]) -> None:
    found = simplest(sum(1 << case for case in cases))
    assert found == min(cases, key=lambda case: (case.bit_count(), case), default=-1)
