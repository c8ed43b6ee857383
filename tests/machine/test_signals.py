"""What flows through the stack: three values, and columns of many cases that obey the same tables case by case."""

from __future__ import annotations

from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plcteach.machine import ONE, ZERO, Column, X
from plcteach.machine.rows import Rows

MEANS = {"0": {0}, "1": {1}, "x": {0, 1}}
"""An x may be either; what may come out is all that the possible values give."""

BITS = {"0": ZERO, "1": ONE, "x": X}


def spelled(values: set[int]) -> str:
    return next(word for word, meant in MEANS.items() if meant == values)


@pytest.mark.parametrize(("a", "b"), list(product("01x", repeat=2)))
def test_the_three_valued_tables(a: str, b: str) -> None:
    possible = [(one, other) for one in MEANS[a] for other in MEANS[b]]
    assert repr(BITS[a] & BITS[b]) == spelled({one & other for one, other in possible})
    assert repr(BITS[a] | BITS[b]) == spelled({one | other for one, other in possible})
    assert repr(BITS[a] ^ BITS[b]) == spelled({one ^ other for one, other in possible})
    assert repr(~BITS[a]) == spelled({1 - one for one in MEANS[a]})


@pytest.mark.parametrize(("now", "last"), list(product("01x", repeat=2)))
def test_an_edge_is_a_change_since_the_last_time(now: str, last: str) -> None:
    possible = [(one, other) for one in MEANS[now] for other in MEANS[last]]
    up, down = (BITS[now].edge(BITS[last], rising=rising) for rising in (True, False))
    assert repr(up) == spelled({int(one == 1 and other == 0) for one, other in possible})
    assert repr(down) == spelled({int(one == 0 and other == 1) for one, other in possible})


@pytest.mark.parametrize("now", "01x")
def test_the_first_time_shows_no_edge(now: str) -> None:
    assert BITS[now].edge(None, rising=True) == ZERO
    assert BITS[now].edge(None, rising=False) == ZERO


@pytest.mark.parametrize(
    ("one", "other", "differs"), [("0", "0", 0), ("1", "0", 1), ("x", "x", 0), ("x", "1", 1), ("0", "x", 1)]
)
def test_x_is_a_value_of_its_own_when_two_are_compared(one: str, other: str, differs: int) -> None:
    assert BITS[one].differs(BITS[other]) == differs


def column(word: str) -> Column:
    """Case k has the k-th sign of the word."""
    may0 = sum(1 << case for case, sign in enumerate(word) if sign in "0x")
    may1 = sum(1 << case for case, sign in enumerate(word) if sign in "1x")
    return Column(may0, may1)


PAIRS = st.lists(st.tuples(st.sampled_from("01x"), st.sampled_from("01x")), min_size=1, max_size=70)


@given(PAIRS)
def test_a_column_is_its_cases_side_by_side(pairs: list[tuple[str, str]]) -> None:
    a, b = (column("".join(signs)) for signs in zip(*pairs, strict=True))
    singles = [(BITS[one], BITS[other]) for one, other in pairs]
    for whole, parts in (
        (a & b, [one & other for one, other in singles]),
        (a | b, [one | other for one, other in singles]),
        (a ^ b, [one ^ other for one, other in singles]),
        (~a, [~one for one, _ in singles]),
        (a.edge(b, rising=True), [one.edge(other, rising=True) for one, other in singles]),
        (a.edge(b, rising=False), [one.edge(other, rising=False) for one, other in singles]),
        (a.edge(None, rising=True), [ZERO] * len(pairs)),
    ):
        assert [whole.at(case) for case in range(len(pairs))] == [repr(one) for one in parts]
        assert not (whole.may0 | whole.may1) >> len(pairs), "nothing beyond the last case"
    assert [a.differs(b) >> case & 1 for case in range(len(pairs))] == [int(one != other) for one, other in pairs]
    assert [a.unknown >> case & 1 for case in range(len(pairs))] == [int(one == "x") for one, _ in pairs]


@pytest.mark.parametrize("count", range(7))
def test_rows_are_all_combinations_case_k_giving_variable_v_bit_v_of_k(count: int) -> None:
    rows = Rows(count)
    assert rows.cases == 2**count
    for variable in range(count):
        one = rows.variable(variable)
        assert [one.at(case) for case in range(rows.cases)] == [str(case >> variable & 1) for case in range(rows.cases)]
    for bit, word in ((ZERO, "0"), (ONE, "1"), (X, "x")):
        assert {rows.constant(bit).at(case) for case in range(rows.cases)} == {word}
    assert rows.domain.zero == rows.constant(ZERO)
    assert rows.domain.one == rows.constant(ONE)
    assert rows.domain.blank == rows.constant(X)
