"""Equal is proved, different is replayed, and the rest is an honest don't-know; truth is worked out here, without the machine."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from itertools import pairwise, product
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.check import same
from plcteach.check.lint import lint
from plcteach.check.proof import search
from plcteach.core.exercise import Terms
from plcteach.machine import run
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from plcteach.core.program import Program
    from plcteach.core.verdict import Verdict


def compare(reference: Program, student: Program, *, level: str = "exact", outputs: Iterable[str] = ()) -> Verdict:
    return same.compare(reference, student, terms=Terms(level=level, outputs=tuple(outputs)))


def program(text: str, dialect: str = "s7-200") -> Program:
    found = read(text.replace(" / ", "\n"), dialect)
    assert found.lines
    assert not [one for one in lint(found) if one.severity == "error"], lint(found)
    return found


def checked(reference: Program, student: Program, **how: object) -> Verdict:
    """Compare, and replay every counterexample on the plain machine."""
    verdict = compare(reference, student, **how)  # type: ignore[arg-type]
    if verdict.counterexample:
        replay(reference, student, verdict)
    assert (verdict.status == "different") == (verdict.counterexample is not None)
    assert (verdict.status == "equal") == (verdict.proof is not None)
    if verdict.status == "equal":
        assert set(verdict.outputs.values()) <= {"equal"}
    if verdict.status == "different":
        assert verdict.outputs[verdict.counterexample.address] == "different"  # type: ignore[union-attr]
    return verdict


def replay(reference: Program, student: Program, verdict: Verdict) -> None:
    example = verdict.counterexample
    assert example is not None
    wanted, got = run(reference, example.inputs), run(student, example.inputs)
    assert example.scan == len(example.inputs) - 1
    for number in range(len(example.inputs)):
        for address in verdict.outputs:
            assert wanted[address][number] == example.expected[number][address]
            assert got[address][number] == example.got[number][address]
            if number < example.scan:
                assert wanted[address][number] == got[address][number] != "x", "the first difference is the last scan"
    address = example.address
    assert wanted[address][-1] != got[address][-1] or got[address][-1] == "x"


# Textbook pairs.

BLOCKS = "LD I0.0 / A I0.1 / LD I0.2 / AN I0.3 / OLD / = Q0.0"


@pytest.mark.parametrize(
    ("dialect", "reference", "student", "proof"),
    [
        ("s7-200", BLOCKS, BLOCKS, "structural"),
        ("s7-200", BLOCKS, f"Network 1 // a title / {BLOCKS} // a comment", "structural"),
        ("s7-200", BLOCKS, "LDN I0.3 / A I0.2 / LD I0.1 / A I0.0 / OLD / = Q0.0", "table"),
        ("s7-200", "LD I0.0 / LD I0.1 / OLD / = Q0.0", "LD I0.1 / O I0.0 / = Q0.0", "table"),
        ("s7-200", "LD I0.0 / O I0.1 / NOT / = Q0.0", "LDN I0.0 / AN I0.1 / = Q0.0", "table"),
        ("s7-200", "LD I0.0 / LPS / A I0.1 / = Q0.0 / LPP / A I0.2 / = Q0.1",
         "LD I0.0 / A I0.1 / = Q0.0 / LD I0.0 / A I0.2 / = Q0.1", "table"),
        ("s7-200", "LD I0.0 / A I0.1 / LD I0.2 / OLD / LD I0.3 / OLD / = Q0.0",
         "LD I0.0 / A I0.1 / LD I0.2 / LD I0.3 / OLD / OLD / = Q0.0", "table"),
        ("fx", "LD X0 / OR X2 / LD X1 / AND X4 / LD X3 / AND X5 / ORB / ANB / OUT Y0",
         "LD X1 / AND X4 / LD X3 / AND X5 / ORB / LD X0 / OR X2 / ANB / OUT Y0", "table"),
        ("fx", "LD X0 / LD X1 / ORB / OUT Y0", "LD X0 / OR X1 / OUT Y0", "table"),
        ("neza", "LD %I0.0 / XOR %I0.1 / ST %Q0.0", "LD %I0.0 / ANDN %I0.1 / OR( %I0.1 / ANDN %I0.0 / ) / ST %Q0.0", "table"),
        ("gutta", "LD M0.0 / LD I0.0 / OLD / = Q0.0", "LD M0.0 / O I0.0 / = Q0.0", "table"),
        # SR lowered as a box against S and R; a seal-in against R after S: for any number of scans
        ("s7-200", "LD I0.0 / O Q0.0 / AN I0.1 / = Q0.0", "LD I0.0 / S Q0.0, 1 / LD I0.1 / R Q0.0, 1", "exhaustive"),
        ("s7-200", "LD I0.0 / LD I0.1 / NOT / A Q0.0 / OLD / = Q0.0", "LD I0.1 / R Q0.0, 1 / LD I0.0 / S Q0.0, 1", "exhaustive"),
        ("fx", "LD X0 / OR Y0 / ANI X1 / OUT Y0", "LD X0 / SET M5 / LD X1 / RST M5 / LD M5 / OUT Y0", "exhaustive"),
        ("fx", "LD X0 / PLS M0 / LD M0 / OUT Y0", "LDP X0 / OUT Y0", "exhaustive"),
        ("gutta", "LD I0.0 / P M0.0 / = Q0.0", "LD I0.0 / AN M7.0 / = Q0.0 / LD I0.0 / = M7.0", "exhaustive"),
        ("neza", "LDR %I0.0 / ST %Q0.0", "LDN %I0.0 / N / ANDR %I0.0 / ST %Q0.0", "exhaustive"),
    ],
)  # fmt: skip
def test_textbook_pairs_that_are_equal(dialect: str, reference: str, student: str, proof: str) -> None:
    mine, theirs = program(reference, dialect), program(student, dialect)
    verdict = checked(mine, theirs)
    assert (verdict.status, verdict.proof) == ("equal", proof)
    assert checked(theirs, mine).status == "equal"


RING = " / LDN M0.0 / AN M0.1 / = M0.2 / LD M0.0 / = M0.1 / LD M0.2 / = M0.0"


def test_a_pair_that_only_the_states_from_power_on_decide() -> None:
    """A ring of two bits never has both on, so that asking for one of them or for that one alone is the same."""
    verdict = checked(program(f"LD M0.1 / = Q0.0{RING}"), program(f"LD M0.1 / AN M0.0 / = Q0.0{RING}"))
    assert (verdict.status, verdict.proof, verdict.explored) == ("equal", "exhaustive", 4)


@pytest.mark.parametrize(
    ("dialect", "reference", "student", "scans"),
    [
        ("s7-200", BLOCKS, "LD I0.0 / A I0.1 / O I0.2 / AN I0.3 / = Q0.0", 1),
        ("s7-200", BLOCKS, "LD I0.0 / A I0.1 / LD I0.2 / AN I0.3 / ALD / = Q0.0", 1),
        ("s7-200", "LD I0.0 / EU / = Q0.0", "LD I0.0 / = Q0.0", 1),
        ("s7-200", "LD I0.0 / EU / = Q0.0", "LD I0.0 / ED / = Q0.0", 2),
        ("s7-200", "LD I0.0 / EU / = Q0.0", "LD I0.0 / AN M0.0 / = Q0.0 / LD I0.0 / = M0.0", 1),
        ("s7-200", "LD I0.0 / S Q0.0, 1 / LD I0.1 / R Q0.0, 1", "LD I0.1 / R Q0.0, 1 / LD I0.0 / S Q0.0, 1", 1),
        ("s7-200", "LD I0.0 / O Q0.0 / AN I0.1 / = Q0.0", "LD I0.0 / AN I0.1 / = Q0.0", 2),
        ("s7-200", "LD I0.0 / S Q0.0, 1 / LD I0.1 / R Q0.0, 1", "LD I0.0 / S Q0.0, 1", 1),
        ("s7-200", "LD I0.0 / = M0.0 / LD M0.0 / = M0.1 / LD M0.1 / = Q0.0", "LD M0.1 / = Q0.0 / LD M0.0 / = M0.1 / LD I0.0 / = M0.0", 1),
        ("s7-200", "LD M0.1 / = Q0.0 / LD M0.0 / = M0.1 / LD I0.0 / = M0.0", "LD M0.0 / = Q0.0 / LD I0.0 / = M0.0", 2),
        ("neza", "LDR %I0.0 / ST %Q0.0", "LD %I0.0 / ST %M0 / LDR %M0 / ST %Q0.0", 2),
        ("fx", "LD X0 / ANDP X1 / OUT Y0", "LD X0 / AND X1 / MEP / OUT Y0", 2),
        ("gutta", "LD I0.0 / P M0.0 / = Q0.0", "LD I0.0 / N M0.0 / = Q0.0", 1),
        ("s7-200", "LD I0.0 / = Q0.0", "LD I0.0 / = Q0.1", 1),
    ],
)  # fmt: skip
def test_textbook_pairs_that_differ_do_so_in_as_few_scans_as_can_be(
    dialect: str, reference: str, student: str, scans: int
) -> None:
    mine, theirs = program(reference, dialect), program(student, dialect)
    verdict = checked(mine, theirs)
    assert verdict.status == "different"
    assert len(verdict.counterexample.inputs) == scans  # type: ignore[union-attr]


def test_a_counterexample_shows_what_each_gives() -> None:
    example = checked(program("LD I0.0 / A I0.1 / = Q0.0"), program("LD I0.0 / = Q0.0")).counterexample
    assert example is not None
    assert example.inputs == ({"I0.0": 1, "I0.1": 0},)
    assert (example.expected, example.got) == (({"Q0.0": "0"},), ({"Q0.0": "1"},))
    assert (example.scan, example.address) == (0, "Q0.0")


def test_an_x_at_a_compared_output_is_different_even_from_x() -> None:
    wanted = program("LD I0.0 / O I0.1 / = Q0.0")
    missing = read("LD I0.0\nLD I0.1\nOLD\nOLD\n= Q0.0", "s7-200")
    verdict = checked(wanted, missing)
    assert verdict.counterexample is not None
    assert (verdict.status, verdict.counterexample.got[-1]) == ("different", {"Q0.0": "x"})
    assert verdict.counterexample.inputs == ({"I0.0": 0, "I0.1": 0},)


def test_an_output_that_agrees_only_at_first_is_not_called_equal() -> None:
    wanted = program("LD I0.0 / = Q0.0 / LD I0.1 / EU / = Q0.1")
    verdict = checked(wanted, program("LDN I0.0 / = Q0.0 / LD I0.1 / ED / = Q0.1"))
    assert verdict.outputs["Q0.0"] == "different"
    assert verdict.outputs["Q0.1"] in {"different", "unknown"}
    good = checked(wanted, program("LDN I0.0 / = Q0.0 / LD I0.1 / EU / = Q0.1"))
    assert good.outputs == {"Q0.0": "different", "Q0.1": "equal"}


def test_outputs_beside_the_reference_are_told_and_not_compared() -> None:
    wanted, more = program("LD I0.0 / = Q0.0"), program("LD I0.0 / = Q0.0 / = Q0.5 / = M0.0")
    verdict = checked(wanted, more)
    assert verdict.status == "equal"
    assert [(one.code, one.severity, one.span.row) for one in verdict.diagnostics] == [("CHK001", "warning", 3)]
    less = checked(more, wanted)
    assert less.status == "different"
    assert [(one.code, one.severity) for one in less.diagnostics] == [("CHK002", "warning")]
    assert "Q0.5" in less.diagnostics[0].text.en


def test_what_is_compared_can_be_chosen_and_is_the_outputs_by_default() -> None:
    one, other = program("LD I0.0 / = Q0.0 / = M0.0"), program("LD I0.0 / = Q0.0 / LDN I0.0 / = M0.0")
    assert checked(one, other).outputs == {"Q0.0": "equal"}
    assert checked(one, other, outputs=["M0.0"]).outputs == {"M0.0": "different"}
    bare = program("LD I0.0 / = M0.0")
    assert checked(bare, program("LDN I0.0 / = M0.0")).outputs == {"M0.0": "different"}


# Size and budgets.


def many(count: int, *, turned: bool = False) -> Program:
    bits = [f"I{number // 8}.{number % 8}" for number in range(count)]
    bits = bits[::-1] if turned else bits
    return program(" / ".join([f"LD {bits[0]}", *(f"A {bit}" for bit in bits[1:]), "= Q0.0"]))


def test_any_number_of_inputs_is_decided_where_a_small_diagram_tells() -> None:
    assert checked(many(20), many(20, turned=True)).proof == "table"
    shorter = program(" / ".join(["LD I0.0", *(f"A I{number // 8}.{number % 8}" for number in range(1, 19)), "= Q0.0"]))
    verdict = checked(many(20), shorter)
    assert verdict.counterexample is not None
    assert sum(verdict.counterexample.inputs[0].values()) == 19
    assert checked(many(21), many(21)).proof == "structural"
    for count in (21, 40, 60):
        assert checked(many(count), many(count, turned=True)).proof == "table"
        less = program(" / ".join(line.text for line in many(count).lines if line.text != "A I1.2"))
        shown = checked(many(count), less).counterexample
        assert shown is not None
        assert [address for address, value in shown.inputs[0].items() if not value] == ["I1.2"]


@pytest.mark.parametrize("change", ["// a comment\n{}", "Network 1 // a title\n{}", "{} // behind"])
def test_comments_titles_and_headings_do_not_count(change: str) -> None:
    text = "\n".join(line.text for line in many(21).lines)
    assert checked(many(21), read(change.format(text), "s7-200")).proof == "structural"


def test_more_instructions_than_the_bound_are_not_known() -> None:
    long = program("LD I0.0" + " / A I0.1" * same.MOST_INSTRUCTIONS + " / = Q0.0")
    assert checked(long, program("LD I0.0 / A I0.1 / = Q0.0")).status == "unknown"


def test_many_inputs_and_a_memory_are_not_known_but_never_equal_by_mistake() -> None:
    rest = "".join(f" / A I1.{bit}" for bit in range(8)) + "".join(f" / A I2.{bit}" for bit in range(6))
    one, other = (f"LD M0.1{more}{rest} / = Q0.0{RING}" for more in ("", " / AN M0.0"))
    verdict = checked(program(one), program(other))
    assert (verdict.status, verdict.counterexample) == ("unknown", None)
    assert verdict.explored > 100


@pytest.mark.parametrize(("most", "wanted"), [(1, "unknown"), (3, "unknown"), (6, "equal")])
def test_a_used_up_budget_says_unknown_and_how_far_it_looked(
    monkeypatch: pytest.MonkeyPatch, most: int, wanted: str
) -> None:
    same.forget()
    monkeypatch.setattr(search, "MOST_STATES", most)
    verdict = checked(program(f"LD M0.1 / = Q0.0{RING}"), program(f"LD M0.1 / AN M0.0 / = Q0.0{RING}"))
    same.forget()
    assert verdict.status == wanted
    assert verdict.explored >= min(most, 4)


# Random conditions without a memory: the truth is the formula's, worked out in plain Python.

Tree = tuple
LEAVES = st.tuples(st.just("v"), st.integers(0, 3), st.booleans())
TREES = st.recursive(
    LEAVES,
    lambda inner: st.tuples(st.sampled_from(["and", "or"]), inner, inner) | st.tuples(st.just("not"), inner),
    max_leaves=6,
)
WORDS = {
    "s7-200": {"v": "I0.", "q": "Q0.", "load": ("LD", "LDN"), "and": ("A", "AN"), "or": ("O", "ON"), "not": "NOT", "join": {"and": "ALD", "or": "OLD"}, "=": "="},
    "gutta": {"v": "I0.", "q": "Q0.", "load": ("LD", "LDN"), "and": ("A", "AN"), "or": ("O", "ON"), "not": "NOT", "join": {"and": "ALD", "or": "OLD"}, "=": "="},
    "fx": {"v": "X", "q": "Y", "load": ("LD", "LDI"), "and": ("AND", "ANI"), "or": ("OR", "ORI"), "not": "INV", "join": {"and": "ANB", "or": "ORB"}, "=": "OUT"},
    "neza": {"v": "%I0.", "q": "%Q0.", "load": ("LD", "LDN"), "and": ("AND", "ANDN"), "or": ("OR", "ORN"), "not": "N", "join": None, "=": "ST"},
}  # fmt: skip


def truth(tree: Tree, bits: tuple[int, ...] | dict) -> int:
    match tree:
        case ("v", where, closed):
            return bits[where] ^ closed
        case ("not", one):
            return 1 - truth(one, bits)
        case ("and", one, other):
            return truth(one, bits) & truth(other, bits)
        case ("or", one, other):
            return truth(one, bits) | truth(other, bits)
    raise AssertionError(tree)


def listing(tree: Tree, name: str) -> list[str]:
    """Write a condition as a beginner is taught to: single contacts in place, everything else as a block."""
    words = WORDS[name]

    def contact(leaf: Tree) -> str:
        return f"{words['v']}{leaf[1]}" if isinstance(leaf[1], int) else leaf[1]

    match tree:
        case ("v", _, closed):
            return [f"{words['load'][closed]} {contact(tree)}"]
        case ("not", one):
            return [*listing(one, name), words["not"]]
        case (op, one, ("v", _, closed) as leaf):
            return [*listing(one, name), f"{words[op][closed]} {contact(leaf)}"]
        case (op, one, other):
            if words["join"]:
                return [*listing(one, name), *listing(other, name), words["join"][op]]
            return [*listing(one, name), f"{op.upper()}(", *listing(other, name), ")"]
    raise AssertionError(tree)


def rung(tree: Tree, name: str, output: int = 0) -> Program:
    words = WORDS[name]
    return program(" / ".join([*listing(tree, name), f"{words['=']} {words['q']}{output}"]), name)


ROWS = list(product((0, 1), repeat=4))


@pytest.mark.parametrize("name", WORDS)
@settings(max_examples=100, deadline=None)
@given(one=TREES, other=TREES)
def test_the_verdict_on_random_pairs_is_the_truth_tables(name: str, one: Tree, other: Tree) -> None:
    verdict = checked(rung(one, name), rung(other, name))
    differ = [row for row in ROWS if truth(one, row) != truth(other, row)]
    assert verdict.status == ("different" if differ else "equal")
    assert checked(rung(other, name), rung(one, name)).status == verdict.status
    if differ:
        assert verdict.counterexample is not None
        shown = verdict.counterexample.inputs[0]
        row = tuple(shown.get(f"{WORDS[name]['v']}{number}", 0) for number in range(4))
        assert row in differ
        assert sum(row) == min(map(sum, differ)), "as few inputs on as can be"
        assert list(verdict.counterexample.expected[0].values()) == [str(truth(one, row))]
        assert list(verdict.counterexample.got[0].values()) == [str(truth(other, row))]


def turned(tree: Tree) -> Tree:
    """Say the same by De Morgan's laws."""
    match tree:
        case ("v", where, closed):
            return ("not", ("v", where, not closed))
        case ("not", one):
            return ("not", turned(one))
        case ("and", one, other):
            return ("not", ("or", ("not", turned(one)), ("not", turned(other))))
        case ("or", one, other):
            return ("not", ("and", ("not", turned(other)), ("not", turned(one))))
    raise AssertionError(tree)


@pytest.mark.parametrize("name", WORDS)
@settings(max_examples=40, deadline=None)
@given(tree=TREES)
def test_a_condition_said_another_way_is_equal(name: str, tree: Tree) -> None:
    original = rung(tree, name)
    for again in (turned(tree), ("not", ("not", tree)), ("or", tree, tree), ("and", ("not", ("not", tree)), tree)):
        verdict = checked(original, rung(again, name))
        assert verdict.status == "equal"
        assert verdict.proof in {"table", "structural"}


# Random programs with a memory: rungs that write bits which rungs read. The truth is a search of the test's own.

BITS = ("I0.0", "I0.1", "M0.0", "M0.1", "Q0.0")
BIT_TREES = st.recursive(
    st.tuples(st.just("v"), st.sampled_from(BITS), st.booleans()),
    lambda inner: st.tuples(st.sampled_from(["and", "or"]), inner, inner),
    max_leaves=3,
)


@dataclass(frozen=True)
class Rung:
    """A condition and what it does to one bit."""

    tree: Tree
    does: str
    target: str


RUNGS = st.builds(
    Rung, BIT_TREES, st.sampled_from(["=", "=", "=", "S", "R"]), st.sampled_from(["M0.0", "M0.1", "Q0.0"])
)
LISTS = st.tuples(st.lists(RUNGS, max_size=2), BIT_TREES).map(lambda drawn: [*drawn[0], Rung(drawn[1], "=", "Q0.0")])


def text_of(rungs: list[Rung]) -> str:
    coils = {"=": "= {}", "S": "S {}, 1", "R": "R {}, 1"}
    return "\n".join("\n".join([*listing(one.tree, "s7-200"), coils[one.does].format(one.target)]) for one in rungs)


def scan(rungs: list[Rung], state: dict[str, int], bits: tuple[int, int]) -> dict[str, int]:
    now = {**state, "I0.0": bits[0], "I0.1": bits[1]}
    for one in rungs:
        value = truth(one.tree, now)
        if one.does == "=":
            now[one.target] = value
        elif value:
            now[one.target] = int(one.does == "S")
    return {name: now[name] for name in ("M0.0", "M0.1", "Q0.0")}


def fewest_presses(one: list[Rung], other: list[Rung]) -> int | None:
    """Search both together from power-on for a difference of Q0.0 with as few inputs turned over as can be; None: no difference."""
    start = (("M0.0", 0), ("M0.1", 0), ("Q0.0", 0))
    waiting = deque([(0, start, start, (0, 0))])
    seen = set()
    while waiting:
        presses, mine, theirs, bits = waiting.popleft()
        if (mine, theirs, bits) in seen:
            continue
        seen.add((mine, theirs, bits))
        after = scan(one, dict(mine), bits), scan(other, dict(theirs), bits)
        if after[0]["Q0.0"] != after[1]["Q0.0"]:
            return presses
        waiting.appendleft((presses, tuple(after[0].items()), tuple(after[1].items()), bits))
        waiting += [(presses + 1, mine, theirs, new) for new in ((1 - bits[0], bits[1]), (bits[0], 1 - bits[1]))]
    return None


def presses_of(scans: Sequence[Mapping[str, int]]) -> int:
    rows = [{}, *scans]
    return sum(after[name] != before.get(name, 0) for before, after in pairwise(rows) for name in after)


@settings(max_examples=150, deadline=None)
@given(one=LISTS, other=LISTS)
def test_in_time_the_verdict_is_the_truth_and_the_counterexample_the_easiest(
    one: list[Rung], other: list[Rung]
) -> None:
    agrees(one, other)


@settings(max_examples=100, deadline=None)
@given(one=LISTS, data=st.data())
def test_in_time_small_changes_are_told_apart_as_well(one: list[Rung], data: st.DataObject) -> None:
    place = data.draw(st.integers(0, len(one) - 1))
    other = [data.draw(RUNGS) if number == place < len(one) - 1 else each for number, each in enumerate(one)]
    if place == len(one) - 1:
        other[-1] = Rung(data.draw(BIT_TREES), "=", "Q0.0")
    agrees(one, other)


def agrees(one: list[Rung], other: list[Rung]) -> None:
    if not closed(one, other):
        return
    mine, theirs = read(text_of(one), "s7-200"), read(text_of(other), "s7-200")
    verdict = checked(mine, theirs)
    presses = fewest_presses(one, other)
    assert verdict.status == ("equal" if presses is None else "different")
    if presses is not None:
        assert verdict.counterexample is not None
        assert presses_of(verdict.counterexample.inputs) == presses
    assert checked(theirs, mine).status == verdict.status


def closed(one: list[Rung], other: list[Rung]) -> bool:
    """Say whether some of the two writes every bit that they read; a bit that nobody writes would be one more input."""
    written = {each.target for each in (*one, *other)} | {"I0.0", "I0.1"}
    return {name for each in (*one, *other) for name in named(each.tree)} <= written


def named(tree: Tree) -> set[str]:
    return {tree[1]} if tree[0] == "v" else named(tree[1]) | named(tree[2])


@settings(max_examples=60, deadline=None)
@given(one=LISTS, other=LISTS, most=st.integers(1, 3))
def test_a_small_budget_is_never_wrong(one: list[Rung], other: list[Rung], most: int) -> None:
    mine, theirs = read(text_of(one), "s7-200"), read(text_of(other), "s7-200")
    whole = compare(mine, theirs)
    with pytest.MonkeyPatch.context() as patch:
        same.forget()
        patch.setattr(search, "MOST_STATES", most)
        verdict = compare(mine, theirs)
    same.forget()
    assert verdict.status in {whole.status, "unknown"}
    for address, status in verdict.outputs.items():
        assert status in {whole.outputs[address], "unknown"}


# At rest: inputs are held until nothing changes any more, and only then are the outputs compared.

LATE = ("LD I0.0 / = M0.0 / LD M0.0 / = Q0.0", "LD M0.0 / = Q0.0 / LD I0.0 / = M0.0")


def test_the_order_of_rungs_counts_exactly_and_not_at_rest() -> None:
    mine, theirs = map(program, LATE)
    assert checked(mine, theirs).status == "different"
    settled = compare(mine, theirs, level="settled")
    assert (settled.status, settled.level) == ("equal", "settled")
    verdict = checked(mine, theirs, level="either")
    assert (verdict.status, verdict.level) == ("equal", "settled")
    assert [(one.code, one.severity) for one in verdict.diagnostics] == [("CHK003", "info")]
    same_scan = checked(mine, mine, level="either")
    assert (same_scan.level, same_scan.diagnostics) == ("exact", ())


def test_what_differs_at_rest_differs_either_way_and_the_inputs_are_held() -> None:
    mine, theirs = program(LATE[0]), program("LD M0.0 / NOT / = Q0.0 / LD I0.0 / = M0.0")
    assert compare(mine, theirs, level="either").level == "settled", "what is shown is what remains at rest"
    verdict = compare(mine, theirs, level="settled")
    assert verdict.status == "different"
    rested(mine, theirs, verdict)


def test_a_program_that_never_rests_is_called_so() -> None:
    flicker = program("LD I0.0 / AN Q0.0 / = Q0.0")
    verdict = compare(program("LD I0.0 / = Q0.0"), flicker, level="settled")
    assert (verdict.status, verdict.outputs) == ("unsettled", {"Q0.0": "unsettled"})
    assert compare(program("LD I0.0 / = Q0.0"), flicker, level="either").status == "different"


def rested(reference: Program, student: Program, verdict: Verdict) -> None:
    """Replay a counterexample at rest: the last scan differs, and holding its inputs for one more changes nothing."""
    example = verdict.counterexample
    assert example is not None
    for one, shown in ((reference, example.expected), (student, example.got)):
        trace = run(one, [*example.inputs, example.inputs[-1]])
        for address in verdict.outputs:
            assert trace[address][:-1] == "".join(scan[address] for scan in shown)
            assert trace[address][-1] == trace[address][-2]
    assert example.expected[-1][example.address] != example.got[-1][example.address]


def at_rest(rungs: list[Rung], state: dict[str, int], bits: tuple[int, int]) -> tuple[dict[str, int], bool] | None:
    """Scan until nothing changes; give the state, and whether Q0.0 gave a pulse on the way: it changed twice or more."""
    changes = 0
    for _ in range(40):
        after = scan(rungs, state, bits)
        changes += after["Q0.0"] != state["Q0.0"]
        if after == state:
            return after, changes > 1
        state = after
    return None


def rest_outcomes(one: list[Rung], other: list[Rung]) -> set[str]:
    """Search both from power-on, at rest after each change of the inputs; give what is met: a difference, unrest, a pulse.

    A pulse of the student's alone counts only where one input has changed.
    """
    start = (("M0.0", 0), ("M0.1", 0), ("Q0.0", 0))
    first: tuple[Any, ...] = (start, start, None)
    seen, waiting, met = {first}, [first], set()
    while waiting:
        mine, theirs, held = waiting.pop()
        for bits in product((0, 1), repeat=2):
            after = at_rest(one, dict(mine), bits), at_rest(other, dict(theirs), bits)
            if after[0] is None or after[1] is None:
                met.add("unsettled")
                continue
            (a, wanted), (b, given) = after
            if a["Q0.0"] != b["Q0.0"]:
                met.add("different")
                continue
            single = held is not None and sum(x != y for x, y in zip(bits, held, strict=True)) <= 1
            if (wanted and not given) or (given and not wanted and single):
                met.add("pulse")
            place = (tuple(a.items()), tuple(b.items()), bits)
            if place not in seen:
                seen.add(place)
                waiting.append(place)
    return met


@settings(max_examples=50, deadline=None)
@given(one=LISTS, other=LISTS)
def test_at_rest_the_verdict_is_the_truth_too(one: list[Rung], other: list[Rung]) -> None:
    if not closed(one, other):
        return
    mine, theirs = read(text_of(one), "s7-200"), read(text_of(other), "s7-200")
    exact, settled = compare(mine, theirs), compare(mine, theirs, level="settled")
    met = rest_outcomes(one, other) if settled.proof != "structural" else set()
    if settled.proof != "structural":
        assert settled.status in met | {"equal"} | ({"different"} if "unsettled" in met else set())
        assert settled.status != "equal" or "different" not in met, "a restless bit may not matter, a difference does"
    if settled.status == "different":
        rested(mine, theirs, settled)
    if exact.status == "equal":
        assert settled.status != "different"
    chosen = compare(mine, theirs, level="either")
    if "unsettled" not in met:
        pulse = "pulse" in met and exact.status != "equal"
        assert (chosen.status == "equal") == ("equal" in {exact.status, settled.status} and not pulse)
    if chosen.status == "equal":
        assert chosen.level == ("exact" if exact.status == "equal" else "settled")


@settings(max_examples=60, deadline=None)
@given(rungs=LISTS)
def test_renamed_memory_and_double_negation_change_nothing(rungs: list[Rung]) -> None:
    text = text_of(rungs)
    renamed = text.replace("M0.0", "V9.9").replace("M0.1", "M3.3").replace("V9.9", "M2.7")
    doubled = "\n".join(f"NOT\nNOT\n{row}" if row[0] in "=SR" else row for row in text.split("\n"))
    written = {one.target for one in rungs}
    for again in (renamed, doubled):
        if again == renamed and not {name for one in rungs for name in named(one.tree)} <= written | {"I0.0", "I0.1"}:
            continue  # a bit that nobody writes is an input, and an input's name does matter
        assert checked(read(text, "s7-200"), read(again, "s7-200")).status == "equal"


OWN = st.lists(
    st.recursive(
        st.tuples(st.just("v"), st.sampled_from(["I0.0", "I0.1", "I0.2", "own"]), st.booleans()),
        lambda inner: st.tuples(st.sampled_from(["and", "or"]), inner, inner),
        max_leaves=4,
    ),
    min_size=2,
    max_size=4,
)


@settings(max_examples=50, deadline=None)
@given(trees=OWN, data=st.data())
def test_the_order_of_independent_rungs_does_not_matter(trees: list[Tree], data: st.DataObject) -> None:
    rungs = [
        "\n".join(listing(tree, "s7-200")).replace("own", f"Q0.{number}") + f"\n= Q0.{number}"
        for number, tree in enumerate(trees)
    ]
    mixed = data.draw(st.permutations(rungs))
    assert checked(read("\n".join(rungs), "s7-200"), read("\n".join(mixed), "s7-200")).status == "equal"


EDGED = [
    ("fx", "LD{} X0 / AND{} X1 / OUT Y0", ("", "P", "F")),
    ("s7-200", "LD I0.0 / {} / A I0.1 / {} / = Q0.0", ("NOT", "EU", "ED")),
    ("neza", "LD{} %I0.0 / OR{} %I0.1 / ST %Q0.0", ("", "R", "F")),
]


@pytest.mark.parametrize(("name", "form", "words"), EDGED, ids=[row[0] for row in EDGED])
def test_edges_are_told_apart_from_each_other_and_from_none(name: str, form: str, words: tuple[str, ...]) -> None:
    every = [program(form.format(*pair), name) for pair in product(words, repeat=2)]
    inputs = sorted({address.text for one in every for address in one.addresses("input")})
    scans = list(product(product((0, 1), repeat=2), repeat=3))
    output = {"fx": "Y0", "s7-200": "Q0.0", "neza": "%Q0.0"}[name]
    shown = [
        [run(one, [dict(zip(inputs, row, strict=True)) for row in rows])[output] for rows in scans] for one in every
    ]
    for (one, mine), (other, theirs) in product(zip(every, shown, strict=True), repeat=2):
        verdict = checked(one, other)
        assert verdict.status == ("equal" if mine == theirs else "different")


@pytest.mark.parametrize(
    ("text", "outputs"),
    [
        ("LD I0.0 / JMP 1 / LD I0.1 / S Q0.0, 3 / LBL 1", "Q0.0 Q0.1 Q0.2"),
        ("LSCR S0.1 / LD I0.0 / = Q0.3 / SCRE", "Q0.3"),
        ("LD M0.0 / JMP 1 / LD I0.1 / = Q1.0 / LBL 1 / LD I0.0 / = Q0.0", "Q0.0 Q1.0"),
        ("LBL 1 / LD SM0.0 / JMP 1 / LD I0.0 / = Q0.0", "Q0.0"),
        ("LD I0.0 / = M0.0", "M0.0"),
    ],
)
def test_an_output_counts_where_the_first_scan_does_not_come_as_well(text: str, outputs: str) -> None:
    assert same.outputs_of(read(text.replace(" / ", "\n"), "s7-200")) == tuple(outputs.split())
