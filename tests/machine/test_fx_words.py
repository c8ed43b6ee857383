"""FX words: moves, sums, comparisons and shifts beside plain Python, written from the sentences of the programming manual."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.area import Address
from plcteach.core.program import Value
from plcteach.machine import run
from plcteach.stl import read

WORD = st.sampled_from([0, 1, -1, 32766, 32767, -32767, -32768]) | st.integers(-32768, 32767)
LONG = st.sampled_from([0, 1, -1, 2**31 - 1, -(2**31)]) | st.integers(-(2**31), 2**31 - 1)


def after(text: str, scans: object = 1, **given: int):
    """Run a list and give what an address holds at the end."""
    program = read(text.replace("/", "\n"), "fx")
    assert program.diagnostics == (), program.diagnostics
    rows = [given, *[{}] * (scans - 1)] if isinstance(scans, int) else scans
    trace = run(program, rows)
    return lambda address: trace.values(address)[-1]


def number(found: object) -> int:
    return int(found.value)  # type: ignore[attr-defined]


def bit(found: object) -> int:
    return int(repr(found))


def pair(value: int, low: str = "D0") -> dict[str, int]:
    """Two registers that hold 32 bits, the low word first."""
    first = int(low[1:])
    halves = value & 0xFFFF, value >> 16 & 0xFFFF
    return {f"D{first + place}": half - (half >> 15 << 16) for place, half in enumerate(halves)}


def held(get, low: str) -> int:
    first = int(low[1:])
    value = (number(get(f"D{first}")) & 0xFFFF) | (number(get(f"D{first + 1}")) & 0xFFFF) << 16
    return value - (value >> 31 << 32)


# Sums and their flags: "If the result is 0, M8020 is set; if it exceeds the upper limit, M8022; if it exceeds the lower limit,
# M8021. The sign of the stored data is that of the limit which has been exceeded."


def model(exact: int, size: int) -> tuple[int, int, int, int]:
    """The stored number and the zero, borrow and carry flags."""
    top = 2 ** (size - 1)
    carry, borrow = int(exact >= top), int(exact < -top)
    stored = exact % top - (top if exact < 0 else 0)
    return stored, int(stored == 0), borrow, carry


@given(WORD, WORD, st.sampled_from([("ADD", 1), ("SUB", -1)]))
@settings(max_examples=150, deadline=None)
def test_sums_of_sixteen_bits_and_their_flags(a: int, b: int, which: tuple[str, int]) -> None:
    word, sign = which
    get = after(f"LD X0/{word} D0 D1 D2", X0=1, D0=a, D1=b)
    found = number(get("D2")), *(bit(get(flag)) for flag in ("M8020", "M8021", "M8022"))
    assert found == model(a + sign * b, 16)
    assert found[0] == a + sign * b or found[2] or found[3]


@given(LONG, LONG, st.sampled_from([("DADD", 1), ("DSUB", -1)]))
@settings(max_examples=100, deadline=None)
def test_sums_of_thirty_two_bits_and_their_flags(a: int, b: int, which: tuple[str, int]) -> None:
    word, sign = which
    get = after(f"LD X0/{word} D0 D2 D4", X0=1, **pair(a), **pair(b, "D2"))
    assert (held(get, "D4"), *(bit(get(flag)) for flag in ("M8020", "M8021", "M8022"))) == model(a + sign * b, 32)


@given(WORD, st.sampled_from([("INC", 1), ("DEC", -1)]))
@settings(max_examples=60, deadline=None)
def test_adding_one_goes_round_and_leaves_no_flag(a: int, which: tuple[str, int]) -> None:
    word, sign = which
    get = after(f"LD X0/{word} D0", X0=1, D0=a, M8020=1, M8021=1, M8022=1)
    assert number(get("D0")) == (a + sign + 32768) % 65536 - 32768
    assert [bit(get(flag)) for flag in ("M8020", "M8021", "M8022")] == [1, 1, 1]


@given(LONG, st.sampled_from([("DINC", 1), ("DDEC", -1)]))
@settings(max_examples=60, deadline=None)
def test_adding_one_to_a_double_word(a: int, which: tuple[str, int]) -> None:
    word, sign = which
    get = after(f"LD X0/{word} D0", X0=1, **pair(a))
    assert held(get, "D0") == (a + sign + 2**31) % 2**32 - 2**31


@given(WORD, WORD)
@settings(max_examples=60, deadline=None)
def test_a_product_has_thirty_two_bits_and_a_quotient_its_remainder(a: int, b: int) -> None:
    get = after("LD X0/MUL D0 D1 D2/DIV D0 D1 D4", X0=1, D0=a, D1=b, D4=77)
    assert held(get, "D2") == a * b
    if b and (a, b) != (-32768, -1):
        quotient = abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)
        assert (number(get("D4")), number(get("D5"))) == (quotient, a - quotient * b)
    elif not b:
        assert number(get("D4")) == 77


def test_without_power_nothing_is_worked_out_and_no_flag_changes() -> None:
    get = after("LD X0/ADD K1 K-1 D0/MOV K5 D1/CMP K1 K2 M0/INC D2", D0=3, D1=4, D2=6, M8020=0, M0=1, M1=1)
    assert [number(get(f"D{place}")) for place in range(3)] == [3, 4, 6]
    assert [bit(get(one)) for one in ("M8020", "M0", "M1", "M2")] == [0, 1, 1, 0]


# The pulse forms: "executed only when the command rises".


@pytest.mark.parametrize("word", ["INCP D0", "DINCP D0", "ADDP D0 K1 D0", "DADDP D0 K1 D0"])
def test_a_pulse_form_is_executed_once_at_each_rising_edge(word: str) -> None:
    rows = [{"X0": one} for one in (1, 0, 1, 1, 1, 0, 1, 0, 0, 1)]
    assert number(after(f"LD X0/{word}", rows)("D0")) == 3  # and none in the first scan, which shows no edge
    plain = word.replace("P ", " ", 1)
    assert number(after(f"LD X0/{plain}", rows)("D0")) == 6


def test_pulse_forms_of_the_other_instructions() -> None:
    rows = [{"X0": 0, "D0": 9, "M0": 1, "M1": 1}, {"X0": 1}, {"D0": 8}]
    get = after("LD X0/MOVP D0 D1/CMPP D0 K9 M10/ZCPP K1 K2 D0 M20/SUBP D0 K1 D2/DECP D3/ZRSTP M0 M1", rows)
    assert [number(get(f"D{place}")) for place in (1, 2, 3)] == [9, 8, -1]
    assert [bit(get(f"M{place}")) for place in (10, 11, 12, 20, 21, 22, 0, 1)] == [0, 1, 0, 0, 0, 1, 0, 0]


# Comparing.


@given(WORD, WORD)
@settings(max_examples=60, deadline=None)
def test_cmp_says_greater_equal_or_less_in_three_bits(a: int, b: int) -> None:
    get = after("LD X0/CMP D0 D1 M5/DCMP D0 D2 Y0", X0=1, D0=a, D1=b)
    assert [bit(get(f"M{place}")) for place in (5, 6, 7)] == [a > b, a == b, a < b]
    whole = (a & 0xFFFF) | (b & 0xFFFF) << 16
    whole -= whole >> 31 << 32
    assert [bit(get(f"Y{place}")) for place in (0, 1, 2)] == [whole > 0, whole == 0, whole < 0]


@given(WORD, WORD, WORD)
@settings(max_examples=60, deadline=None)
def test_zcp_says_below_within_or_above(low: int, high: int, value: int) -> None:
    get = after("LD X0/ZCP D0 D1 D2 S5", X0=1, D0=low, D1=high, D2=value)
    high = max(low, high)
    assert [bit(get(f"S{place}")) for place in (5, 6, 7)] == [value < low, low <= value <= high, value > high]


RELATIONS = {
    "=": lambda a, b: a == b,
    "<>": lambda a, b: a != b,
    ">": lambda a, b: a > b,
    "<": lambda a, b: a < b,
    ">=": lambda a, b: a >= b,
    "<=": lambda a, b: a <= b,
}


@given(WORD, WORD, st.sampled_from(sorted(RELATIONS)), st.integers(0, 1))
@settings(max_examples=80, deadline=None)
def test_comparing_contacts(a: int, b: int, relation: str, x: int) -> None:
    b = a if b % 3 == 0 else b
    text = f"LD{relation} D0 D1/OUT Y0/LD X0/AND{relation} D0 D1/OUT Y1/LD X0/OR{relation} D0 D1/OUT Y2/LDD{relation} D0 D2/OUT Y3"
    get = after(text, X0=x, D0=a, D1=b, **pair(a, "D2"))
    holds = RELATIONS[relation](a, b)
    assert [bit(get(f"Y{place}")) for place in range(3)] == [holds, x and holds, x or holds]
    whole = (a & 0xFFFF) | (b & 0xFFFF) << 16
    assert bit(get("Y3")) == RELATIONS[relation](whole - (whole >> 31 << 32), a)


def test_a_hexadecimal_constant_is_its_bits() -> None:
    get = after(
        "LD X0/MOV HFFFF D0/LD= D0 HFFFF/OUT Y0/LD= D0 K-1/OUT Y1/LD X0/ADD D0 HFFFF D1/DMOV HFFFFFFFF D2", X0=1
    )
    assert [number(get(f"D{place}")) for place in range(4)] == [-1, -2, -1, -1]
    assert (bit(get("Y0")), bit(get("Y1"))) == (1, 1)


# Bits taken four at a time: K1X0 is X0 to X3, K2X0 goes on with X4 to X7, K3X0 with X10 to X13.


@given(st.integers(1, 4), st.integers(0, 2**20 - 1), st.integers(0, 15))
@settings(max_examples=60, deadline=None)
def test_a_group_of_inputs_is_read_in_octal_order(count: int, bits: int, first: int) -> None:
    inputs = {f"X{place:o}": bits >> place & 1 for place in range(40)}
    get = after(f"LD M8000/MOV K{count}X{first:o} D0/DMOV K{count}X{first:o} D2", **inputs)
    value = bits >> first & (1 << 4 * count) - 1
    assert held(get, "D2") == value
    assert number(get("D0")) == (value - 65536 if count == 4 and value >> 15 else value)


@given(st.integers(1, 8), st.integers(-(2**31), 2**31 - 1))
@settings(max_examples=60, deadline=None)
def test_a_group_takes_the_low_bits_and_leaves_the_others(count: int, value: int) -> None:
    before = {f"M{place}": 1 for place in range(40)}
    get = after(f"LD M8000/DMOV D0 K{count}M4", **pair(value), **before)
    expected = [1] * 4 + [value >> place & 1 for place in range(4 * count)] + [1] * (36 - 4 * count)
    assert [bit(get(f"M{place}")) for place in range(40)] == expected


def test_the_manuals_sum_into_a_group_keeps_what_fits() -> None:
    """25 is stored at K1Y4: only Y4 and Y7 are active, which is 9 (FX programming manual, ADD)."""
    get = after("LD M8000/ADD K20 K5 K1Y4")
    assert [bit(get(f"Y{place}")) for place in (4, 5, 6, 7, 10)] == [1, 0, 0, 1, 0]
    assert bit(get("M8022")) == 0


def test_timers_and_counters_are_words_too() -> None:
    rows = [{"X0": 1, "X1": 1, "ms": 100}] + [{"X1": number % 2, "ms": 100} for number in range(6)]
    get = after(
        "LD X0/OUT T0 K50/LD X1/OUT C0 K50/LD M8000/MOV T0 D0/ADD C0 T0 D1/LD>= T0 K5/OUT Y0/LD= C0 K2/OUT Y1", rows
    )
    assert (number(get("D0")), number(get("D1"))) == (6, 9)
    assert (bit(get("Y0")), bit(get("Y1"))) == (1, 0)
    get = after("LD X0/MOV K30 T0/DMOV K-70000 C200/DMOV C200 D0", X0=1)
    assert (number(get("T0.V")), number(get("C200.V")), held(get, "D0")) == (30, -70000, -70000)


# Shifting rows of bits.


@given(st.integers(1, 12), st.integers(1, 12), st.integers(0, 2**12 - 1), st.integers(0, 2**12 - 1), st.integers(0, 1))
@settings(max_examples=80, deadline=None)
def test_sftl_and_sftr_are_slices_of_lists(long: int, many: int, row: int, entering: int, left: int) -> None:
    many = min(long, many)
    bits = [row >> place & 1 for place in range(long)]
    fresh = [entering >> place & 1 for place in range(many)]
    inputs = {f"X{place:o}": one for place, one in enumerate(fresh)}
    text = f"LD M8000/SFT{'L' if left else 'R'} X0 M0 K{long} K{many}"
    get = after(text, **inputs, **{f"M{place}": one for place, one in enumerate(bits)}, M40=1)
    wanted = fresh + bits[: long - many] if left else bits[many:] + fresh
    assert [bit(get(f"M{place}")) for place in range(long)] == wanted
    assert bit(get(f"M{long}")) == 0


def test_shifting_by_pulses_moves_one_light_along() -> None:
    rows = [{"X0": 1, "X1": 0}] + [{"X1": one} for one in (1, 0)] + [{"X0": 0, "X1": one} for one in (1, 0) * 3]
    program = read("LD X1\nSFTLP X0 Y0 K4 K1", "fx")
    trace = run(program, rows)
    shown = ["".join(trace[f"Y{place}"][scan] for place in range(4)) for scan in (0, 1, 3, 5, 7)]
    assert shown == ["0000", "1000", "0100", "0010", "0001"]


# Resetting ranges.


def test_zrst_clears_bits_words_timers_and_counters_between_its_ends() -> None:
    text = "LD X0/OUT T5 K1/LD X0/OUT C5 K1/LD X1/ZRST D1 D3/ZRST Y6 Y11/ZRST T4 T6/ZRST C4 C6/ZRST S1 S1/ZRST M5 M3"
    given = {**{f"D{place}": 5 for place in range(5)}, **{f"Y{place}": 1 for place in (5, 6, 7, 10, 11, 12)}}
    given |= {"S0": 1, "S1": 1, "S2": 1, "M3": 1, "M4": 1, "M5": 1}
    rows = [{"X0": 0, **given}, {"X0": 1}, {"ms": 100}, {"X0": 0}, {"X0": 1, "X1": 1}]
    before, get = after(text, rows[:3]), after(text, rows)
    assert (bit(before("T5")), bit(before("C5")), number(before("C5.V"))) == (1, 1, 1)
    assert [number(get(f"D{place}")) for place in range(5)] == [5, 0, 0, 0, 5]
    assert [bit(get(f"Y{place}")) for place in (5, 6, 7, 10, 11, 12)] == [1, 0, 0, 0, 0, 1]
    assert (bit(get("T5")), number(get("T5.V")), bit(get("C5")), number(get("C5.V"))) == (0, 0, 0, 0)
    assert [bit(get(one)) for one in ("S0", "S1", "S2")] == [1, 0, 1]
    assert [bit(get(one)) for one in ("M3", "M4", "M5")] == [1, 1, 0]  # the first end above the last: it alone [rec]


def test_rst_clears_a_word_only_where_there_is_power() -> None:
    text = "LD X0/RST D7"
    assert number(after(text, D7=12345)("D7")) == 12345
    assert number(after(text, D7=12345, X0=1)("D7")) == 0


# What is refused, each with one sentence.


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("MOV C200 D0", "RDR007"),
        ("DMOV C0 D0", "RDR007"),
        ("MOV K8M0 D0", "RDR007"),
        ("MOV D0 X0", "RDR007"),
        ("MOV D0 K2X0", "RDR007"),
        ("MOV K40000 D0", "RDR008"),
        ("MOV H10000 D0", "RDR008"),
        ("DMOV K2147483648 D0", "RDR008"),
        ("MOV K2X8 D0", "RDR006"),
        ("MOV D9000 D0", "RDR006"),
        ("SFTL X0 M0 K0 K1", "RDR008"),
        ("SFTL X0 M0 K1025 K1", "RDR008"),
        ("SFTL X0 M0 D0 K1", "RDR008"),
        ("ADD D0 D1", "RDR003"),
        ("INC K5", "RDR005"),
        ("SET D0", "RDR007"),
        ("OUT D0", "RDR007"),
        ("LD D0", "RDR007"),
    ],
)
def test_operands_that_do_not_fit_are_refused_in_words(line: str, code: str) -> None:
    found = read(f"LD X0\n{line}", "fx").diagnostics
    assert [one.code for one in found] in ([code], ["RDR019"])
    assert found[0].span.row == 2


def test_operands_are_read_and_written_in_one_spelling() -> None:
    program = read("LD>= D000 hff\nMOV k-5 k2y010\nDMOV K8M0 C200", "fx")
    assert program.diagnostics == ()
    compare, (value, group), (row, counter) = (line.args for line in program.lines)
    assert repr(compare[0]) == "D0 HFF"
    assert value == Value(-5, "K-5")
    assert isinstance(group, Address)
    assert (group.text, group.size, row.size, counter.size) == ("K2Y10", 8, 32, 32)  # type: ignore[union-attr]
