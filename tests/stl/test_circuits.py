"""Where circuits begin in a list without headings, which reading an FX load has there, and NEZA's parentheses."""

from __future__ import annotations

from itertools import product

import pytest

from plcteach.check.lint import lint
from plcteach.machine import run
from plcteach.stl import read


def rungs(text: str, dialect: str = "fx") -> list[str]:
    program = read(text.replace("/", "\n"), dialect)
    assert program.diagnostics == ()
    return ["/".join(line.text for line in network.lines) for network in program.networks]


def readings(text: str) -> str:
    """Give for each load of an FX list P where it pushes and N where it opens a new circuit."""
    program = read(text.replace("/", "\n"), "fx")
    return "".join(
        "N" if line.effect == line.insn.fresh else "P" for line in program.lines if line.insn.fresh is not None
    )


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("LD X0/OUT Y0", "N"),
        ("LD X0/LD X1/ORB/OUT Y0", "NP"),
        ("LD X0/OUT Y0/LD X1/OUT Y1", "NN"),
        ("LD X0/AND X1/LD X2/AND X3/ORB/OUT Y0/LDI X4/OUT Y1", "NPN"),
        # the two programs of fx.md
        ("LD X0/MPS/OUT Y0/LD X1/OR X2/ANB/OUT Y1/MPP/OUT Y2", "NP"),
        ("LD X0/MPS/OUT Y0/LD X1/OR X2/ANB/OUT Y1/MPP/OUT Y2/LD X10/OR X11/ANB/OUT Y3", "NPP"),
        # a load after the last branch whose value nobody joins opens a new circuit
        ("LD X0/MPS/AND X1/OUT Y0/MPP/OUT Y1/LD X2/OUT Y2", "NN"),
        ("LD X0/OUT Y0/LDP X1/OUT Y1/LDF X2/OUT Y2", "NNN"),
        # an output in the middle of a series goes on: a later block joins what the output has left
        ("LD X0/OUT Y0/LD X1/OR X2/ANB/OUT Y1", "NP"),
        # of two loads after an output only the one whose saved value is popped pushes
        ("LD X0/OUT Y0/LD X1/LD X2/ORB/OUT Y1", "NNP"),
        ("LD X0/OUT Y0/LD X1/LD X2/ORB/ANB/OUT Y1", "NPP"),
    ],
)
def test_a_load_saves_the_result_only_if_a_join_will_take_it(text: str, wanted: str) -> None:
    assert readings(text) == wanted


FIRST = "LD X0/MPS/OUT Y0/LD X1/OR X2/ANB/OUT Y1/MPP/OUT Y2"
SECOND = FIRST + "/LD X10/OR X11/ANB/OUT Y3"


@pytest.mark.parametrize("text", [FIRST, SECOND])
def test_the_two_programs_of_the_notes_are_right(text: str) -> None:
    program = read(text.replace("/", "\n"), "fx")
    assert lint(program) == ()
    assert len(program.networks) == 1
    for a, b, c, d, e in product((0, 1), repeat=5):
        trace = run(program, [{"X0": a, "X1": b, "X2": c, "X10": d, "X11": e}])
        assert (trace["Y0"], trace["Y1"], trace["Y2"]) == (str(a), str(a & (b | c)), str(a))
        if text == SECOND:
            assert trace["Y3"] == str(a & (d | e))


@pytest.mark.parametrize(
    ("dialect", "text", "wanted"),
    [
        ("fx", "LD X0/OUT Y0/LD X1/OUT Y1/END", ["LD X0/OUT Y0", "LD X1/OUT Y1/END"]),
        ("fx", "LD X0/OUT Y0/OUT Y1/AND X1/OUT Y2/LD X1/OUT Y3", ["LD X0/OUT Y0/OUT Y1/AND X1/OUT Y2", "LD X1/OUT Y3"]),
        ("fx", "LD X0/OUT Y0/LD X1/OR X2/ANB/OUT Y1/LD X3/OUT Y2", ["LD X0/OUT Y0/LD X1/OR X2/ANB/OUT Y1", "LD X3/OUT Y2"]),
        ("fx", "LD X0/MPS/AND X1/OUT Y0/MPP/OUT Y1/LD X2/OUT Y2", ["LD X0/MPS/AND X1/OUT Y0/MPP/OUT Y1", "LD X2/OUT Y2"]),
        ("neza", "LD %I0.0/ST %Q0.0/LD %I0.1/ST %Q0.1", ["LD %I0.0/ST %Q0.0", "LD %I0.1/ST %Q0.1"]),
        ("neza", "LD %I0.0/MPS/ST %Q0.0/MPP/ST %Q0.1/LDN %I0.1/ST %Q0.2", ["LD %I0.0/MPS/ST %Q0.0/MPP/ST %Q0.1", "LDN %I0.1/ST %Q0.2"]),
        ("neza", "LD %I0.0/AND( %I0.1/OR %I0.2/)/ST %Q0.0/LD %I0.1/ST %Q0.1", ["LD %I0.0/AND( %I0.1/OR %I0.2/)/ST %Q0.0", "LD %I0.1/ST %Q0.1"]),
    ],
)  # fmt: skip
def test_a_new_rung_begins_at_a_load_once_everything_is_used(dialect: str, text: str, wanted: list[str]) -> None:
    assert rungs(text, dialect) == wanted


def test_a_load_while_a_value_is_unused_begins_no_rung() -> None:
    assert len(rungs("LD X0/LD X1/OUT Y0")) == 1
    assert len(rungs("LD %I0.0/LD %I0.1/ST %Q0.0", "neza")) == 1
    assert len(rungs("LD X0/MPS/OUT Y0/LD X1/OUT Y1/MPP/OUT Y2")) == 1


def test_the_s7_200_and_gutta_split_at_titles_only() -> None:
    assert len(rungs("LD I0.0/= Q0.0/LD I0.1/= Q0.1", "s7-200")) == 1
    assert len(rungs("LD I0.0/= Q0.0/LD I0.1/= Q0.1", "gutta")) == 1


@pytest.mark.parametrize(
    ("text", "closers"),
    [
        ("LD %I0.0/AND( %I0.1/OR %I0.2/)/ST %Q0.0", ["&"]),
        ("LD %I0.0/OR( %I0.1/AND %I0.2/)/ST %Q0.0", ["|"]),
        ("LD %I0.0/AND( %I0.1/OR( %I0.2/AND %I0.3/)/)/ST %Q0.0", ["|", "&"]),
        ("LD %I0.0/OR(N %I0.1/AND(R %I0.2/OR %I0.3/)/)/AND(F %I0.1/)/ST %Q0.0", ["&", "|", "&"]),
    ],
)
def test_every_closing_parenthesis_is_married_to_its_opener(text: str, closers: list[str]) -> None:
    program = read(text.replace("/", "\n"), "neza")
    assert program.diagnostics == ()
    found = [line.effect.text for line in program.lines if line.insn.mnemonic == ")"]
    assert found == [f"b -- a{sign}b ; paren: a --" for sign in closers]


def test_parentheses_without_a_partner_are_found_where_they_stand() -> None:
    stray = read("LD %I0.0\n)\nAND( %I0.1\n)\n)\nST %Q0.0", "neza")
    assert [(one.code, one.span.row) for one in stray.diagnostics] == [("RDR010", 2), ("RDR010", 5)]
    never = read("LD %I0.0\nAND( %I0.1\nOR( %I0.2\nST %Q0.0\nRUNG 2\nLD %I0.0\n)\nST %Q0.1", "neza")
    assert [(one.code, one.span.row) for one in never.diagnostics] == [("RDR011", 2), ("RDR011", 3), ("RDR010", 7)]


def test_parentheses_mean_what_they_enclose() -> None:
    program = read("LD %I0.0\nOR( %I0.1\nAND( %I0.2\nOR %I0.3\n)\n)\nST %Q0.0", "neza")
    for a, b, c, d in product((0, 1), repeat=4):
        trace = run(program, [{"%I0.0": a, "%I0.1": b, "%I0.2": c, "%I0.3": d}])
        assert trace["%Q0.0"] == str(a | (b & (c | d)))


def test_a_bare_parenthesis_begins_with_the_accumulator_empty_for_a_load() -> None:
    program = read("LD %I0.0\nAND(\nLD %I0.1\nOR %I0.2\n)\nST %Q0.0", "neza")
    assert lint(program) == ()
    for a, b, c in product((0, 1), repeat=3):
        assert run(program, [{"%I0.0": a, "%I0.1": b, "%I0.2": c}])["%Q0.0"] == str(a & (b | c))
