"""Rows of the table of misconceptions that need bit logic only: what the program really gives, and what is said about it.

Every expected value stands in the table, none comes from the machine. a, b, c … are the inputs in order, as in the table.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from pathlib import Path

import pytest

from plcteach.check.lint import lint
from plcteach.check.same import compare
from plcteach.core.diagnostic import RULES
from plcteach.core.errors import UnknownNameError
from plcteach.core.misconception import MISCONCEPTIONS, misconception
from plcteach.dialects import families
from plcteach.exercises import concept_test, exercise, ids
from plcteach.machine import run
from plcteach.machine.formula import spelled, written
from plcteach.stl import read

INPUTS = {
    "s7-200": [f"I{number // 8}.{number % 8}" for number in range(20)],
    "gutta": [f"I{number // 8}.{number % 8}" for number in range(20)],
    "fx": [f"X{number:o}" for number in range(20)],
    "neza": [f"%I0.{number}" for number in range(20)],
}


def list_of(program: str) -> str:
    """The table separates instructions by strokes; `//` separates networks."""
    return "\n".join(part.strip().replace("/", "\n") for part in program.split(" | "))


def inputs(dialect: str, bits: str) -> dict[str, int]:
    return {address: int(bit) for address, bit in zip(INPUTS[dialect], bits, strict=False)}


@dataclass(frozen=True)
class Row:
    """One tell-tale input of a row: what the learner expects, what the machine gives."""

    number: int
    dialect: str
    program: str
    bits: str
    output: str
    expects: str
    gets: str


TABLE = [
    Row(1, "s7-200", "LD I0.0/A I0.1/O I0.2/A I0.3/= Q0.0", "1100", "Q0.0", "1", "0"),
    Row(1, "s7-200", "LD I0.0/A I0.1/O I0.2/A I0.3/= Q0.0", "0011", "Q0.0", "1", "1"),
    Row(2, "s7-200", "LD I0.0/A I0.1/LD I0.2/A I0.3/LD I0.4/OLD/ALD/= Q0.0", "00111", "Q0.0", "1", "0"),
    Row(3, "s7-200", "LD I0.0/LD I0.1/= Q0.0", "01", "Q0.0", "0", "1"),
    Row(4, "s7-200", "LD I0.0/LD I0.1/OLD/OLD/= Q0.0", "00", "Q0.0", "0", "x"),
    Row(4, "s7-200", "LD I0.0/LD I0.1/OLD/OLD/= Q0.0", "01", "Q0.0", "1", "1"),
    Row(5, "s7-200", "LD I0.0/A I0.1/LD I0.2/A I0.3/LD I0.4/A I0.5/OLD/= Q0.0", "110000", "Q0.0", "1", "0"),
    Row(6, "s7-200", "LD I0.0/O I0.1/LD I0.2/O I0.3/OLD/= Q0.0", "0001", "Q0.0", "0", "1"),
    Row(8, "s7-200", "LD I0.0/A I0.1/= Q0.0/A I0.2/= Q0.1", "101", "Q0.1", "1", "0"),
    Row(9, "s7-200", "LD I0.0/LPS/A I0.1/= Q0.0/LPP/A I0.2/= Q0.1/LPP/A I0.3/= Q0.2", "0001", "Q0.2", "0", "x"),
    Row(9, "s7-200", "LD I0.0/LPS/A I0.1/= Q0.0/LPP/A I0.2/= Q0.1/LPP/A I0.3/= Q0.2", "1110", "Q0.2", "0", "0"),
    Row(
        10,
        "s7-200",
        "LD I0.0/LPS/A I0.1/LPS/A I0.2/= Q0.0/LRD/A I0.3/= Q0.1/LPP/A I0.4/= Q0.2",
        "10001",
        "Q0.2",
        "1",
        "0",
    ),
    Row(11, "s7-200", "LD I0.0/LPS/A I0.1/LRD/A I0.2/OLD/= Q0.0", "100", "Q0.0", "0", "1"),
    Row(15, "s7-200", "Network 1 | LD I0.0/= Q0.0 | Network 2 | A I0.1/= Q0.1", "01", "Q0.1", "1", "0"),
    Row(17, "s7-200", "LD I0.0/A I0.1/NOT/= Q0.0", "00", "Q0.0", "0", "1"),
    Row(20, "s7-200", "LD I0.0/= Q0.0/LD I0.1/= Q0.0", "10", "Q0.0", "1", "0"),
    Row(21, "s7-200", "LD I0.0/S Q0.0,1/LD I0.1/R Q0.0,1", "11", "Q0.0", "1", "0"),
    Row(21, "s7-200", "LD I0.1/R Q0.0,1/LD I0.0/S Q0.0,1", "11", "Q0.0", "0", "1"),
    Row(24, "fx", "LDI X0/OUT Y0", "0", "Y0", "1", "1"),
    Row(24, "s7-200", "LDI I0.0/= Q0.0", "0", "Q0.0", "1", "0"),
    Row(25, "s7-200", "LD I0.0/LPS/ALD/= Q0.0", "1", "Q0.0", "1", "1"),
    Row(25, "s7-200", "LD I0.0/LPS/ALD/= Q0.0", "0", "Q0.0", "0", "0"),
]


@pytest.mark.parametrize("row", TABLE, ids=lambda row: f"{row.number}-{row.dialect}-{row.bits}")
def test_the_machine_gives_what_the_table_says(row: Row) -> None:
    trace = run(read(list_of(row.program), row.dialect), [inputs(row.dialect, row.bits)])
    assert trace[row.output] == row.gets


MEANINGS = [
    (1, "LD I0.0/A I0.1/O I0.2/A I0.3/= Q0.0", "Q0.0", lambda a, b, c, d: (a & b | c) & d),
    (2, "LD I0.0/A I0.1/LD I0.2/A I0.3/LD I0.4/OLD/ALD/= Q0.0", "Q0.0", lambda a, b, c, d, e: a & b & (c & d | e)),
    (3, "LD I0.0/LD I0.1/= Q0.0", "Q0.0", lambda _a, b: b),
    (5, "LD I0.0/A I0.1/LD I0.2/A I0.3/LD I0.4/A I0.5/OLD/= Q0.0", "Q0.0", lambda _a, _b, c, d, e, f: c & d | e & f),
    (6, "LD I0.0/O I0.1/LD I0.2/O I0.3/OLD/= Q0.0", "Q0.0", lambda a, b, c, d: a | b | c | d),
    (8, "LD I0.0/A I0.1/= Q0.0/A I0.2/= Q0.1", "Q0.1", lambda a, b, c: a & b & c),
    (
        10,
        "LD I0.0/LPS/A I0.1/LPS/A I0.2/= Q0.0/LRD/A I0.3/= Q0.1/LPP/A I0.4/= Q0.2",
        "Q0.2",
        lambda a, b, _c, _d, e: a & b & e,
    ),
    (11, "LD I0.0/LPS/A I0.1/LRD/A I0.2/OLD/= Q0.0", "Q0.0", lambda a, _b, _c: a),
    (15, "Network 1 | LD I0.0/= Q0.0 | Network 2 | A I0.1/= Q0.1", "Q0.1", lambda a, b: a & b),
    (17, "LD I0.0/A I0.1/NOT/= Q0.0", "Q0.0", lambda a, b: 1 - (a & b)),
    (26, "Network 1 | LD I0.0/LPS/= Q0.0 | Network 2 | LPP/A I0.1/= Q0.1", "Q0.1", lambda a, b: a & b),
]


@pytest.mark.parametrize(("number", "program", "output", "meaning"), MEANINGS, ids=[str(row[0]) for row in MEANINGS])
def test_the_program_is_the_formula_of_the_table_on_all_inputs(number: int, program: str, output: str, meaning) -> None:
    assert number
    loaded = read(list_of(program), "s7-200")
    for bits in product((0, 1), repeat=meaning.__code__.co_argcount):
        word = "".join(map(str, bits))
        assert run(loaded, [inputs("s7-200", word)])[output] == str(meaning(*bits)), word


SAID = [
    (3, "s7-200", "LD I0.0/LD I0.1/= Q0.0", "STK005", "warning", 3),
    (3, "fx", "LD X0/LD X1/OUT Y0", "STK005", "error", 3),
    (4, "s7-200", "LD I0.0/LD I0.1/OLD/OLD/= Q0.0", "STK001", "error", 4),
    (5, "s7-200", "LD I0.0/A I0.1/LD I0.2/A I0.3/LD I0.4/A I0.5/OLD/= Q0.0", "STK005", "warning", 8),
    (7, "fx", "LD X0/LD X1/ORB/OUT Y0", "STK007", "info", 2),
    (7, "fx", "LD X0/LD X1/ANB/OUT Y0", "STK008", "info", 2),
    (9, "fx", "LD X0/MPS/AND X1/OUT Y0/MPP/AND X2/OUT Y1/MPP/AND X3/OUT Y2", "STK003", "error", 8),
    (9, "s7-200", "LD I0.0/LPS/A I0.1/= Q0.0/LPP/A I0.2/= Q0.1/LPP/A I0.3/= Q0.2", "STK003", "error", 8),
    (10, "s7-200", "LD I0.0/LPS/A I0.1/LPS/A I0.2/= Q0.0/LRD/A I0.3/= Q0.1/LPP/A I0.4/= Q0.2", "STK006", "warning", 12),
    (11, "s7-200", "LD I0.0/LPS/A I0.1/LRD/A I0.2/OLD/= Q0.0", "STK010", "warning", 4),
    (15, "s7-200", "Network 1 | LD I0.0/= Q0.0 | Network 2 | A I0.1/= Q0.1", "STK009", "error", 5),
    (25, "gutta", "LD I0.0/LPS/ALD/= Q0.0", "STK001", "error", 3),
    (26, "s7-200", "Network 1 | LD I0.0/LPS/= Q0.0 | Network 2 | LPP/A I0.1/= Q0.1", "STK003", "error", 6),
]


@pytest.mark.parametrize(
    ("number", "dialect", "program", "code", "severity", "row"),
    SAID,
    ids=[f"{row[0]}-{row[1]}-{row[3]}" for row in SAID],
)
def test_the_mistake_is_said_where_it_is_made_and_names_its_misconception(
    number: int, dialect: str, program: str, code: str, severity: str, row: int
) -> None:
    found = {one.code: one for one in lint(read(list_of(program), dialect))}
    assert code in found
    assert (found[code].severity, found[code].span.row) == (severity, row)
    assert number in RULES[code].misconceptions


@pytest.mark.parametrize("program", ["LD X0/LD X1/ORB/OUT Y0", "LD X0/LD X1/ANB/OUT Y0"])
def test_7_a_join_for_a_single_contact_is_right_but_one_line_too_many(program: str) -> None:
    short = {"ORB": "LD X0\nOR X1\nOUT Y0", "ANB": "LD X0\nAND X1\nOUT Y0"}["ORB" if "ORB" in program else "ANB"]
    long = read(list_of(program), "fx")
    assert {one.severity for one in lint(long)} == {"info"}
    assert compare(read(short, "fx"), long).status == "equal"


@pytest.mark.parametrize("bits", ["000", "100", "111", "011"])
def test_12_lds_counts_from_0(bits: str) -> None:
    given = [inputs("s7-200", bits)]
    assert run(read(list_of("LD I0.0/LD I0.1/LD I0.2/LDS 3/= Q0.0"), "s7-200"), given)["Q0.0"] == "x"
    assert run(read(list_of("LD I0.0/LD I0.1/LD I0.2/LDS 2/= Q0.0"), "s7-200"), given)["Q0.0"] == bits[0]


def test_12_an_x_at_an_output_is_said_and_names_the_misconception() -> None:
    trace = run(read(list_of("LD I0.0/LD I0.1/LD I0.2/LDS 3/= Q0.0"), "s7-200"), [{}])
    assert [one.code for one in trace.diagnostics] == ["RUN001"]
    assert 12 in RULES["RUN001"].misconceptions


TEN_BLOCKS = "\n".join([*(f"LD {address}" for address in INPUTS["s7-200"][:10]), *["OLD"] * 9, "= Q0.0"])


def test_13_the_tenth_block_pushes_the_first_one_out() -> None:
    program = read(TEN_BLOCKS, "s7-200")
    assert run(program, [{"I0.0": 1}])["Q0.0"] == "x"
    for address in INPUTS["s7-200"][1:10]:
        assert run(program, [{address: 1}])["Q0.0"] == "1"
    lost = [one for one in lint(program) if one.code == "STK002"]
    assert [(one.severity, one.span.row) for one in lost] == [("error", 10)]
    assert 13 in RULES["STK002"].misconceptions


def test_13_nine_blocks_fit_and_the_smart_takes_ten() -> None:
    nine = "\n".join([*(f"LD {address}" for address in INPUTS["s7-200"][:9]), *["OLD"] * 8, "= Q0.0"])
    assert not [one for one in lint(read(nine, "s7-200")) if one.severity != "info"]
    assert run(read(nine, "s7-200"), [{"I0.0": 1}])["Q0.0"] == "1"
    assert not [one for one in lint(read(TEN_BLOCKS, "s7-200-smart")) if one.severity != "info"]
    assert run(read(TEN_BLOCKS, "s7-200-smart"), [{"I0.0": 1}])["Q0.0"] == "1"


def nested(pushes: int) -> str:
    """A stem, so many nested branch points, and as many pops, each with a coil of its own."""
    rows = ["LD I0.0"]
    for address in INPUTS["s7-200"][1 : pushes + 1]:
        rows += ["LPS", f"A {address}"]
    rows.append("= Q0.0")
    for number in range(1, pushes + 1):
        rows += ["LPP", f"= Q{number // 8}.{number % 8}"]
    return "\n".join(rows)


def test_14_eight_nested_pushes_are_fine_in_nine_levels_and_the_ninth_loses_the_outermost_node() -> None:
    ones = [dict.fromkeys(INPUTS["s7-200"][:11], 1)]
    eight, nine = (read(nested(pushes), "s7-200") for pushes in (8, 9))
    assert run(eight, ones)["Q1.0"] == "1"
    assert run(eight, [{"I0.0": 1}])["Q1.0"] == "1"
    assert not lint(eight)
    assert run(nine, ones)["Q1.1"] == "x"
    lost = [one for one in lint(nine) if one.code == "STK002"]
    assert [(one.severity, one.span.row) for one in lost] == [("error", 18)]
    assert 14 in RULES["STK002"].misconceptions


def test_16_the_newest_block_stands_in_the_result_register_and_a_is_the_deepest() -> None:
    def cells(program: str, dialect: str) -> list[str]:
        return [written(cell) for cell in spelled(read(program, dialect))[5].after[0]]

    fx = "LD X0\nOR X2\nLD X1\nAND X4\nLD X3\nAND X5\nORB\nANB\nOUT Y0"
    assert cells(fx, "fx") == ["X3·X5", "X1·X4", "X0+X2"]
    s7 = "LD I0.0\nO I0.2\nLD I0.1\nA I0.4\nLD I0.3\nA I0.5\nOLD\nALD\n= Q0.0"
    assert cells(s7, "s7-200")[:4] == ["I0.3·I0.5", "I0.1·I0.4", "I0.0+I0.2", "x"]


@pytest.mark.parametrize(("program", "gives"), [("LD X0/ANDP X1/OUT M0", "0001"), ("LD X0/AND X1/PLS M0", "0101")])
def test_18_the_edge_of_a_contact_is_not_the_edge_of_the_result(program: str, gives: str) -> None:
    scans = [inputs("fx", bits) for bits in ("01", "11", "10", "11")]
    assert run(read(list_of(program), "fx"), scans)["M0"] == gives


def test_19_a_branch_keeps_the_stems_value_and_a_copied_stem_is_read_again() -> None:
    branch = "LD I0.0/AN Q0.0/LPS/= Q0.0/LPP/A I0.1/= Q0.1"
    copied = "LD I0.0/AN Q0.0/= Q0.0/LD I0.0/AN Q0.0/A I0.1/= Q0.1"
    for program, gives in ((branch, "1"), (copied, "0")):
        assert run(read(list_of(program), "s7-200"), [inputs("s7-200", "11")])["Q0.1"] == gives
    assert compare(read(list_of(branch), "s7-200"), read(list_of(copied), "s7-200")).status == "different"


@pytest.mark.parametrize(
    ("dialect", "program"),
    [("s7-200", "LD I0.0/= Q0.0/LD I0.1/= Q0.0"), ("fx", "LD X0/OUT Y0/LD X1/OUT Y0")],
)
def test_20_a_double_coil_is_a_warning_at_the_second_coil(dialect: str, program: str) -> None:
    warned = [one for one in lint(read(list_of(program), dialect)) if one.severity == "warning"]
    assert [one.span.row for one in warned] == [4]
    assert 20 in RULES[warned[0].code].misconceptions


def test_20_set_and_reset_of_one_bit_is_no_double_coil() -> None:
    assert not lint(read(list_of("LD I0.0/S Q0.0,1/LD I0.1/R Q0.0,1"), "s7-200"))


def test_23_with_a_normally_closed_button_the_negated_contact_never_lets_the_motor_start() -> None:
    at_rest = [{"I0.1": 1}, {"I0.0": 1}, {"I0.0": 0}]
    assert run(read(list_of("LD I0.0/O Q0.0/AN I0.1/= Q0.0"), "s7-200"), at_rest)["Q0.0"] == "000"
    assert run(read(list_of("LD I0.0/O Q0.0/A I0.1/= Q0.0"), "s7-200"), at_rest)["Q0.0"] == "011"


def test_25_guttas_push_leaves_the_data_stack_alone() -> None:
    program = read(list_of("LD I0.0/LPS/ALD/= Q0.0"), "gutta")
    data, aux = spelled(program)[1].after
    assert ([written(cell) for cell in data], [written(cell) for cell in aux]) == (["I0.0"], ["I0.0"])


def test_25_the_same_list_is_fine_on_the_s7_200() -> None:
    assert not [one for one in lint(read(list_of("LD I0.0/LPS/ALD/= Q0.0"), "s7-200")) if one.severity == "error"]


def test_13_the_message_of_a_full_stack_counts_levels_as_the_family_does() -> None:
    twelve = "\n".join(["LD X0", *["MPS"] * 12, "OUT Y0", *["MPP"] * 12, "OUT Y1"])
    (full,) = [one for one in lint(read(twelve, "fx")) if one.severity == "error"]
    assert "11" in full.text.en
    assert "11" in full.text.zh
    assert "12" not in full.text.en + full.text.zh  # the result register is not a level


# The table of all 29, and where each is met.

LESSONS = {int(path.name[:2]) for path in (Path(__file__).parents[1] / "notebooks" / "en").glob("[0-9][0-9]-*.ipynb")}


def test_the_table_has_29_rows_each_with_its_own_words_and_a_lesson_that_is_there() -> None:
    assert list(MISCONCEPTIONS) == list(range(1, 30))
    for number, row in MISCONCEPTIONS.items():
        assert row.number == number
        texts = [row.title, row.thinks, row.fact]
        assert all(one.zh and one.en for one in texts)
        assert len({one.en for one in texts}) == 3
        assert row.lesson in LESSONS
    assert len({row.title.zh for row in MISCONCEPTIONS.values()}) == 29
    assert misconception(6) is MISCONCEPTIONS[6]
    with pytest.raises(UnknownNameError):
        misconception(30)


@pytest.mark.parametrize("number", MISCONCEPTIONS)
def test_the_program_of_a_row_can_be_read_in_some_family(number: int) -> None:
    text = MISCONCEPTIONS[number].program.replace("; ", "\n").replace(" | ", "\n")
    assert any(read(text, family).runs for family in families())


def test_every_diagnostic_names_a_lesson_that_is_there_and_ideas_that_are_in_the_table() -> None:
    for row in RULES.values():
        assert row.lesson in LESSONS | {-1}, row.code
        assert set(row.misconceptions) <= set(MISCONCEPTIONS), row.code
        assert row.lesson >= 0 or not row.misconceptions, row.code


def test_a_diagnostic_about_the_stack_or_the_coils_names_its_lesson() -> None:
    without = [
        code for code, row in RULES.items() if code[:3] in {"STK", "STY", "TMR", "BLK", "BOX"} and row.lesson < 0
    ]
    assert without == []


def met() -> dict[int, list[str]]:
    """Where each idea is met: the diagnostics, the concept test, the wrong samples and the exercises that name it."""
    found: dict[int, list[str]] = {number: [] for number in MISCONCEPTIONS}
    for code, row in RULES.items():
        for number in row.misconceptions:
            found[number].append(code)
    for task in (*concept_test(), *map(exercise, ids())):
        for number in {*task.misconceptions, *(one.misconception for one in task.wrong)} - {0}:
            found[number].append(task.id)
    return found


BY_EXERCISES_ALONE = {19, 29}
"""Neither a diagnostic nor the concept test meets these; an exercise of the book does."""


def test_each_of_the_29_is_a_diagnostic_or_a_question_of_the_concept_test_or_an_exercise() -> None:
    found = met()
    by_rules = {number for row in RULES.values() for number in row.misconceptions}
    asked = {number for task in concept_test() for number in task.misconceptions}
    assert set(MISCONCEPTIONS) - by_rules - asked == BY_EXERCISES_ALONE
    missing = [number for number, where in found.items() if not where]
    assert missing == [], f"no diagnostic, question or exercise names {missing}"


def test_each_of_the_29_is_a_sample_or_an_exercise_of_the_book_or_a_question() -> None:
    """A diagnostic alone is not enough: a learner must be able to meet the idea in a task."""
    missing = [number for number, where in met().items() if not any(one not in RULES for one in where)]
    assert missing == [], f"no [[wrong]] sample, question or exercise names {missing}"
