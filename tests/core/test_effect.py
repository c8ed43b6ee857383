"""The notation and the flow: what each declared effect does to the cells, cell by cell, and that no cell is ever lost from sight."""

from __future__ import annotations

from dataclasses import dataclass

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.effect import At, Both, Edge, Name, Not, Shape, flow
from plcteach.core.errors import DeclarationError
from plcteach.core.notation import parse_effect, parse_formula
from plcteach.dialects import dialect, families

# The notation.


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("a @ -- a", "@"),
        ("a -- a + b", r"\+"),
        ("a -- a&", "a word"),
        ("a -- a |", "a word"),
        ("a", "a word"),
        ("a -- (a", r"\)"),
        ("a -- a )", "the end"),
        ("a -- [n", r"\]"),
        ("-- rise(a", r"\)"),
        ("-- fall(a b)", r"expected \).*b"),
        ("a -- b=", "a word"),
        ("a -- a ; aux: b", "a word"),
        ("", "a word"),
    ],
)
def test_a_notation_that_does_not_fit_is_refused_and_the_word_is_named(text: str, named: str) -> None:
    with pytest.raises(DeclarationError, match=named) as caught:
        parse_effect(text)
    assert repr(text) in str(caught.value)


@pytest.mark.parametrize(
    "text", ["& -- a", "a -- &", "a -- a & & b", "a -- .B", "a -- !|", "a -- [)]", "= -- a", "a -- a.="]
)
def test_a_sign_is_no_name(text: str) -> None:
    with pytest.raises(DeclarationError):
        parse_effect(text)


@pytest.mark.parametrize("text", ["a a -- a", "a b a -- b", "a -- a ; aux: a -- a"])
def test_a_cell_name_is_taken_once(text: str) -> None:
    with pytest.raises(DeclarationError, match="a"):
        parse_effect(text)


def test_a_stack_has_one_clause() -> None:
    with pytest.raises(DeclarationError):
        parse_effect("a -- a ; b -- b")


@pytest.mark.parametrize("text", ["", "a b", "a)", "(a", "a | | b", "!", "rise(a"])
def test_a_formula_alone_is_refused_as_well(text: str) -> None:
    with pytest.raises(DeclarationError):
        parse_formula(text)


def test_not_binds_tightest_then_and_then_exclusive_or_then_or() -> None:
    a, b, c, d = map(Name, "abcd")
    assert parse_formula("a | b ^ c & !d") == Both("|", a, Both("^", b, Both("&", c, Not(d))))
    assert parse_formula("(a | b) & c") == Both("&", Both("|", a, b), c)
    assert parse_formula("a & b & c") == Both("&", Both("&", a, b), c)
    assert parse_formula("!(a & b)") == Not(Both("&", a, b))
    assert parse_formula("!!a") == Not(Not(a))
    assert parse_formula("rise(a) & fall(!b)") == Both("&", Edge(True, a), Edge(False, Not(b)))  # noqa: FBT003
    assert parse_formula("rise") == Name("rise")


def test_a_clause_is_read_with_tags_labels_and_options() -> None:
    effect = parse_effect("a.L b? -- S2=a|b.B [n] ; aux: c -- c")
    main, aux = effect.clauses
    assert [(one.name, one.tag, one.optional) for one in main.takes] == [("a", "L", False), ("b", "", True)]
    assert [(one.label, one.formula, one.tag) for one in main.gives] == [
        ("S2", Both("|", Name("a"), Name("b")), "B"),
        ("", At("n"), ""),
    ]
    assert (main.stack, aux.stack) == ("", "aux")
    assert effect.labelled
    assert effect.operands == {"n"}
    assert repr(effect) == "Effect('a.L b? -- S2=a|b.B [n] ; aux: c -- c')"


def test_operands_are_the_names_that_no_clause_takes() -> None:
    assert parse_effect("a -- a&bit").operands == {"bit"}
    assert parse_effect("a -- top ; aux: top --").operands == frozenset()
    assert parse_effect("-- rise(bit) !c").operands == {"bit", "c"}


def test_binding_puts_the_number_in_and_leaves_others_alone() -> None:
    bound = parse_effect("-- [n]").bind({"n": 3})
    assert bound.clauses[0].gives[0].formula == At(3)
    assert parse_effect("-- [n]").clauses[0].gives[0].formula == At("n")
    plain = parse_effect("a -- a&bit")
    assert plain.bind({"n": 3}) is plain


# The flow, cell by cell. "=2" is the cell that stood at place 2, "+2" a copy of it, "*01" a value made from 0 and 1, "x" blank;
# the places of further stacks have the stack's letter before them.

NINE = (Shape("", 9, fixed=True),)
FX = (Shape("", 12, fixed=False),)
NEZA = (Shape("", 1, fixed=True), Shape("paren", 8, fixed=False), Shape("branch", 8, fixed=False))
GUTTA = (Shape("", 32, fixed=False), Shape("aux", 32, fixed=False))


def place(where: tuple[int, int], shapes: tuple[Shape, ...]) -> str:
    return f"{shapes[where[0]].name[:1]}{where[1]}"


def told(text: str, shapes: tuple[Shape, ...], heights: tuple[int, ...]) -> list[str]:
    sign = {"kept": "=", "copied": "+", "made": "*", "blank": "x"}
    return [
        " ".join(sign[one.how] + "".join(place(source, shapes) for source in one.sources) for one in stack)
        for stack in flow(parse_effect(text), shapes, heights).after
    ]


@pytest.mark.parametrize(
    ("mnemonic", "after", "lost", "dropped", "merged"),
    [
        ("LD", "* =0 =1 =2 =3 =4 =5 =6 =7", [8], [], []),
        ("A", "*0 =1 =2 =3 =4 =5 =6 =7 =8", [], [], [0]),
        ("NOT", "*0 =1 =2 =3 =4 =5 =6 =7 =8", [], [], [0]),
        ("EU", "*0 =1 =2 =3 =4 =5 =6 =7 =8", [], [], [0]),
        ("=", "=0 =1 =2 =3 =4 =5 =6 =7 =8", [], [], []),
        ("NOP", "=0 =1 =2 =3 =4 =5 =6 =7 =8", [], [], []),
        ("OLD", "*01 =2 =3 =4 =5 =6 =7 =8 x", [], [], [0, 1]),
        ("ALD", "*01 =2 =3 =4 =5 =6 =7 =8 x", [], [], [0, 1]),
        ("LPS", "=0 +0 =1 =2 =3 =4 =5 =6 =7", [8], [], []),
        ("LRD", "+1 =1 =2 =3 =4 =5 =6 =7 =8", [], [0], []),
        ("LPP", "=1 =2 =3 =4 =5 =6 =7 =8 x", [], [0], []),
    ],
)
def test_the_s7_200s_stack_as_its_books_draw_it(
    mnemonic: str, after: str, lost: list[int], dropped: list[int], merged: list[int]
) -> None:
    effect = dialect("s7-200").insn(mnemonic).effect
    moves = flow(effect, NINE, (9,))
    assert told(effect.text, NINE, (9,)) == [after]
    assert [one for _, one in moves.lost] == lost
    assert sorted(one for _, one in moves.dropped) == dropped
    assert sorted(one for _, one in moves.merged) == merged
    assert moves.missing == (0,)


@pytest.mark.parametrize("n", range(9))
def test_lds_n_copies_what_stood_n_places_below_the_top(n: int) -> None:
    moves = flow(dialect("s7-200").insn("LDS").effect.bind({"n": n}), NINE, (9,))
    assert [(one.how, one.sources) for one in moves.after[0]] == [("copied", ((0, n),))] + [
        ("kept", ((0, place),)) for place in range(8)
    ]
    assert moves.lost == ((0, 8),)


@pytest.mark.parametrize(
    ("mnemonic", "height", "after"),
    [
        ("LD", 1, "* =0"),
        ("LD", 3, "* =0 =1 =2"),
        ("AND", 2, "*0 =1"),
        ("ANB", 3, "*01 =2"),
        ("ORB", 2, "*01"),
        ("MPS", 1, "+0 =0"),
        ("MPS", 2, "+0 =0 =1"),
        ("MRD", 3, "+1 =1 =2"),
        ("MPP", 3, "=1 =2"),
        ("MPP", 2, "=1"),
        ("OUT", 2, "=0 =1"),
    ],
)
def test_the_fx_keeps_what_stands_on_its_stack(mnemonic: str, height: int, after: str) -> None:
    after_mps = {"+0 =0": "=0 +0", "+0 =0 =1": "=0 +0 =1"}
    got = told(dialect("fx").insn(mnemonic).effect.text, FX, (height,))
    assert got in ([after], [after_mps.get(after, after)])


def test_an_fx_load_that_opens_a_circuit_pushes_nothing() -> None:
    fresh = dialect("fx").insn("LD").fresh
    assert fresh is not None
    assert told(fresh.text, FX, (0,)) == ["*"]
    assert told(fresh.text, FX, (1,)) == ["*"]
    assert flow(fresh, FX, (0,)).missing == (0,)
    assert flow(fresh, FX, (1,)).dropped == ((0, 0),)


@pytest.mark.parametrize(
    ("text", "heights", "after"),
    [
        ("a -- bit ; paren: -- a", (1, 0, 0), ["*", "=0", ""]),
        ("a -- bit ; paren: -- a", (1, 2, 0), ["*", "=0 =p0 =p1", ""]),
        ("b -- a&b ; paren: a --", (1, 1, 0), ["*0p0", "", ""]),
        ("b -- a|b ; paren: a --", (1, 3, 1), ["*0p0", "=p1 =p2", "=b0"]),
        ("a -- a ; branch: -- a", (1, 0, 1), ["=0", "", "+0 =b0"]),
        ("a -- top ; branch: top -- top", (1, 0, 2), ["+b0", "", "=b0 =b1"]),
        ("a -- top ; branch: top --", (1, 0, 2), ["=b0", "", "=b1"]),
    ],
)
def test_nezas_parentheses_and_branches(text: str, heights: tuple[int, ...], after: list[str]) -> None:
    assert text in {effect.text for row in dialect("neza").insns for effect in row.effects}
    assert told(text, NEZA, heights) == after


@pytest.mark.parametrize(
    ("mnemonic", "heights", "after"),
    [
        ("LD", (1, 1), ["* =0", "=a0"]),
        ("ALD", (2, 1), ["*01", "=a0"]),
        ("LPS", (2, 1), ["=0 =1", "+0 =a0"]),
        ("LRD", (2, 1), ["+a0 =1", "=a0"]),
        ("LPP", (2, 2), ["=a0 =1", "=a1"]),
        ("O", (2, 0), ["*0 =1", ""]),
    ],
)
def test_guttas_two_stacks(mnemonic: str, heights: tuple[int, ...], after: list[str]) -> None:
    assert told(dialect("gutta").insn(mnemonic).effect.text, GUTTA, heights) == after


def test_what_is_missing_is_counted_for_each_stack() -> None:
    join = parse_effect("a b -- a&b")
    assert flow(join, GUTTA, (2, 0)).missing == (0, 0)
    assert flow(join, GUTTA, (1, 0)).missing == (1, 0)
    assert flow(join, GUTTA, (0, 0)).missing == (2, 0)
    assert flow(parse_effect("a -- top ; aux: top --"), GUTTA, (1, 0)).missing == (0, 1)
    assert flow(join, GUTTA, (1, 0)).named == {"b": (0, 0)}


def test_every_declared_effect_has_a_shape_for_each_of_its_stacks() -> None:
    for family in families():
        heights = tuple(stack.depth if stack.fixed else 3 for stack in family.stacks)
        for row in family.insns:
            for effect in row.effects:
                bound = effect.bind({operand.name: operand.first for operand in row.operands if operand.number})
                conserved(bound, family.shapes, heights)


# Properties over random effects.


@dataclass(frozen=True)
class Case:
    """A random effect with the stacks it runs on."""

    text: str
    shapes: tuple[Shape, ...]
    heights: tuple[int, ...]


def formulas(names: list[str]) -> st.SearchStrategy[str]:
    leaf = st.sampled_from([*names, "bit"])
    return st.recursive(
        leaf,
        lambda inner: (
            st.tuples(inner, st.sampled_from("&|^"), inner).map("({0[0]}{0[1]}{0[2]})".format)
            | inner.map("!{}".format)
            | inner.map("rise({})".format)
        ),
        max_leaves=3,
    )


@st.composite
def cases(draw: st.DrawFn) -> Case:
    counts = draw(st.lists(st.integers(0, 3), min_size=1, max_size=3))
    letters = iter("abcdefghi")
    takes = [[next(letters) for _ in range(count)] for count in counts]
    every = [name for some in takes for name in some]
    clauses, shapes, heights = [], [], []
    for number, some in enumerate(takes):
        gives = draw(
            st.lists(st.sampled_from(every or ["bit"]) | formulas(every) | st.sampled_from(["[n]"]), max_size=3)
        )
        stack = "" if not number else f"s{number}"
        clauses.append(f"{f'{stack}: ' if stack else ''}{' '.join(some)} -- {' '.join(gives)}")
        shape = Shape(stack, draw(st.integers(1, 6)), draw(st.booleans()))
        shapes.append(shape)
        heights.append(shape.depth if shape.fixed else draw(st.integers(0, shape.depth)))
    return Case(" ; ".join(clauses), tuple(shapes), tuple(heights))


def conserved(effect: object, shapes: tuple[Shape, ...], heights: tuple[int, ...]) -> None:
    moves = flow(effect, shapes, heights)  # type: ignore[arg-type]
    every = [(stack, place) for stack, height in enumerate(heights) for place in range(height)]
    kept = [one.sources[0] for stack in moves.after for one in stack if one.how == "kept"]
    fates = [*kept, *moves.lost, *moves.dropped, *moves.merged]
    assert sorted(fates) == every, "each cell before is kept, lost, dropped or merged, and only one of them"
    for shape, stack in zip(shapes, moves.after, strict=True):
        assert len(stack) == shape.depth if shape.fixed else len(stack) <= shape.depth
        for one in stack:
            assert {"kept": 1, "copied": 1, "blank": 0}.get(one.how, len(one.sources)) == len(one.sources)
            assert (one.formula is not None) == (one.how == "made")
            assert shape.fixed or one.how != "blank" or one.sources
    for clause, number in ((clause, [one.name for one in shapes].index(clause.stack)) for clause in effect.clauses):  # type: ignore[attr-defined]
        least = sum(not take.optional for take in clause.takes)
        assert moves.missing[number] == max(0, least - heights[number])


@settings(max_examples=250, deadline=None)
@given(cases(), st.integers(0, 4))
def test_whatever_an_effect_does_every_cell_has_one_fate_and_every_new_cell_one_origin(case: Case, n: int) -> None:
    conserved(parse_effect(case.text).bind({"n": n}), case.shapes, case.heights)


@settings(max_examples=100, deadline=None)
@given(cases())
def test_the_height_of_a_growing_stack_is_what_the_clause_says(case: Case) -> None:
    effect = parse_effect(case.text)
    moves = flow(effect.bind({"n": 0}), case.shapes, case.heights)
    for number, shape in enumerate(case.shapes):
        if not shape.fixed:
            clause = next(one for one in effect.clauses if one.stack == shape.name)
            rest = max(0, case.heights[number] - len(clause.takes))
            assert len(moves.after[number]) == min(shape.depth, rest + len(clause.gives))
