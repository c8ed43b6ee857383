"""What a drawing says, that it survives being written and read again, and what each slip in one is called."""

from __future__ import annotations

import re
import sys
import time
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.diagnostic import RULES, Diagnostic
from plcteach.core.errors import DeclarationError
from plcteach.core.ladder import (
    Box,
    Branch,
    Coil,
    Compared,
    Contact,
    Edge,
    Invert,
    Ladder,
    Parallel,
    Rung,
    Series,
    branch,
    depth,
    parallel,
    series,
)
from plcteach.core.ladder import titled as retitled
from plcteach.dialects import dialect as find_dialect
from plcteach.ladder.lower import lower
from plcteach.ladder.picture import read_drawing, read_line, write_drawing, write_line
from plcteach.ladder.symbols import box, coil, contact
from plcteach.ladder.telling import is_drawing

sys.path.insert(0, str(Path(__file__).parent))
from random_ladders import TITLES, ladders, rungs

A, B, C, D, E = (Contact(f"I0.{number}") for number in range(5))
Q, R = Coil("Q0.0"), Coil("Q0.1")


def one(drawing: str) -> Rung:
    ladder, found = read_drawing(drawing)
    assert found == ()
    assert len(ladder.rungs) == 1
    return ladder.rungs[0]


SEAL_IN = """\
--[ I0.0 ]--+--[/I0.1 ]--( Q0.0 )
--[ Q0.0 ]--+
"""

DRAWINGS = {
    "seal-in": (SEAL_IN, Rung(Series((Parallel((A, Contact("Q0.0"))), Contact("I0.1", negated=True))), (Q,))),
    "rails": ("|--[ I0.0 ]--( Q0.0 )--|", Rung(A, (Q,))),
    "no wire at all": ("[I0.0](Q0.0)", Rung(A, (Q,))),
    "touching symbols": ("--[I0.0][I0.1]--(Q0.0)", Rung(Series((A, B)), (Q,))),
    "symbols": (
        (
            "-[P I0.0]-[N I0.1]-[NOT]-[!I0.2]-+-(S Q0.0 3)\n                                 +-(R Q0.1)-|\n"
            "                                 +-(/Q0.2)"
        ),
        None,
    ),
    "two outputs, further contacts": (
        "--[ I0.0 ]--+---------------( Q0.0 )\n            |\n            +--[ I0.1 ]-----( Q0.1 )",
        Rung(A, (Q, Branch(B, (R,)))),
    ),
    "two levels": (
        "--[I0.0]-+-[I0.1]-+-[I0.2]-(Q0.0)\n         |        +-[I0.3]-(Q0.1)\n         +-[I0.4]----------(Q0.2)",
        Rung(A, (Branch(B, (Branch(C, (Q,)), Branch(D, (R,)))), Branch(E, (Coil("Q0.2"),)))),
    ),
    "three blocks in series": (
        "--[I0.0]--+--+--[I0.1]--+--+--[I0.2]--+--(Q0.0)\n--[I0.3]--+  +--[I0.4]--+  +--[I0.3]--+",
        Rung(Series((Parallel((A, D)), Parallel((B, E)), Parallel((C, D)))), (Q,)),
    ),
    "parallel within parallel": (
        (
            "--+--[I0.0]--+--[I0.1]--+--(Q0.0)\n  |          |          |\n  |          +--[I0.2]--+\n  |                     |\n"
            "  +--[I0.3]-------------+"
        ),
        Rung(Parallel((Series((A, Parallel((B, C)))), D)), (Q,)),
    ),
    "full width": ("－－［　Ｉ０．０　］－－（　Ｑ０．０　）", Rung(A, (Q,))),
    "full width brackets above plain ones": ("--【I0.0】--+--(Q0.0)\n--[ I0.1 ]--+", Rung(Parallel((A, B)), (Q,))),
    "box drawing": ("├──[ I0.0 ]──┬──( Q0.0 )──┤\n│            └──( Q0.1 )──┤", Rung(A, (Q, R))),
    "comments": ("--[ I0.0 ]--( Q0.0 )   // the lamp\n// nothing here", Rung(A, (Q,))),
    "tabs and crlf": ("\t--[ I0.0 ]--( Q0.0 )\r\n", Rung(A, (Q,))),
    "lower case": ("--[ %i0.0 ]--( 启动 )", Rung(Contact("%I0.0"), (Coil("启动"),))),
    "right rail apart": ("--[I0.0]--(Q0.0)  |\n                  |", Rung(A, (Q,))),
}


@pytest.mark.parametrize("name", DRAWINGS)
def test_drawings_read_as_they_look(name: str) -> None:
    drawing, expected = DRAWINGS[name]
    if expected is not None:
        assert one(drawing) == expected
    assert read_drawing(write_drawing(Ladder((one(drawing),)))) == (Ladder((one(drawing),)), ())


def test_every_symbol_is_read() -> None:
    rung = one(DRAWINGS["symbols"][0])
    assert rung.stem == Series(
        (Contact("I0.0", edge="rise"), Contact("I0.1", edge="fall"), Invert(), Contact("I0.2", negated=True))
    )
    assert rung.outs == (Coil("Q0.0", "set", 3), Coil("Q0.1", "reset"), Coil("Q0.2", "not"))
    assert [symbol.mark for symbol in rung.symbols if not isinstance(symbol, Invert)] == [
        "P ",
        "N ",
        "/",
        "S ",
        "R ",
        "/ ",
    ]


def test_the_canonical_drawing_is_the_one_of_the_books() -> None:
    assert write_drawing(Ladder((one(SEAL_IN),))) == SEAL_IN
    assert write_drawing(one("I0.0 -> (I0.1 -> Q0.0), (I0.2 -> S Q0.1 3)")) == (
        "--[ I0.0 ]--+--[ I0.1 ]--( Q0.0 )\n            +--[ I0.2 ]--(S Q0.1 3)\n"
    )


def test_several_rungs_with_headings_blank_lines_and_a_common_rail() -> None:
    ladder, found = read_drawing(
        "// 电动机 motor\nNetwork 1 // start\n--[I0.0]--(Q0.0)\nRUNG 2\n--[I0.1]--(Q0.1)\n\n\n|--[I0.2]--(Q0.2)--|\n|\n|--[I0.3]--(Q0.3)--|\nI0.4 -> Q0.4\n"
    )
    assert found == ()
    assert ladder.title == "电动机 motor"
    assert [(rung.title, write_line(rung)) for rung in ladder.rungs] == [
        ("start", "I0.0 -> Q0.0"), ("", "I0.1 -> Q0.1"), ("", "I0.2 -> Q0.2"), ("", "I0.3 -> Q0.3"), ("", "I0.4 -> Q0.4"),
    ]  # fmt: skip
    assert read_drawing(write_drawing(ladder)) == (ladder, ())


@settings(max_examples=400, deadline=None)
@given(ladder=ladders("s7-200", edges=True, turned=True))
def test_ladder_to_drawing_to_ladder(ladder: Ladder) -> None:
    drawing = write_drawing(ladder)
    assert read_drawing(drawing) == (ladder, ())
    assert is_drawing(drawing)
    assert write_drawing(read_drawing(drawing)[0]) == drawing


CONTACTS = {
    "[I I0.0 ]": Contact("I0.0", immediate=True),
    "[/I I0.0 ]": Contact("I0.0", negated=True, immediate=True),
    "[! i i0.0]": Contact("I0.0", negated=True, immediate=True),
    "[/I0.0 ]": Contact("I0.0", negated=True),
    "[P]": Edge(),
    "[ n ]": Edge(rising=False),
    "[P:M0.0]": Edge(memory="M0.0"),
    "[↓ : %M1]": Edge(rising=False, memory="%M1"),
    "[ VW0 >= 5 ]": Compared("VW0", ">=", "5"),
    "[vw0>=5]": Compared("VW0", ">=", "5"),
    "[ VB1 =B 5 ]": Compared("VB1", "=", "5", "B"),
    "[ VB1 ==B 5 ]": Compared("VB1", "=", "5", "B"),
    "[ VW2 >I -3 ]": Compared("VW2", ">", "-3"),
    "[ VW2 <>W +88 ]": Compared("VW2", "<>", "+88"),
    "[ VD0 >D 70000 ]": Compared("VD0", ">", "70000", "D"),
    "[ VD4 <R 1.5 ]": Compared("VD4", "<", "1.5", "R"),
    "[ VD4 <R-1.5E-10 ]": Compared("VD4", "<", "-1.5E-10", "R"),
    "[D0>=D5]": Compared("D0", ">=", "D5"),
    "[ K4M0 < H1F ]": Compared("K4M0", "<", "H1F"),
    "[ K-5 <= T0 ]": Compared("K-5", "<=", "T0"),
    "[ %DR0.S = 16#1F ]": Compared("%DR0.S", "=", "16#1F"),
    "[ 2#1010 ≤ %TM0.V ]": Compared("2#1010", "<=", "%TM0.V"),
    "[ AC0 ≠ C0 ]": Compared("AC0", "<>", "C0"),
    "[ %MW0 != MW4 ]": Compared("%MW0", "<>", "MW4"),
    "［ＶＷ０　＞＝　－５］": Compared("VW0", ">=", "-5"),
    "【ＶＤ０　＜＞Ｄ　＋５】": Compared("VD0", "<>", "+5", "D"),
    "［Ｐ：Ｍ０．０］": Edge(memory="M0.0"),
}


@pytest.mark.parametrize("drawn", CONTACTS)
def test_contacts_of_every_kind(drawn: str) -> None:
    assert one(f"--{drawn}--( Q0.0 )") == Rung(CONTACTS[drawn], (Q,))
    assert one(f"--[ I0.0 ]--+--{drawn}--( Q0.0 )\n            +--( Q0.1 )") == Rung(
        A, (Branch(CONTACTS[drawn], (Q,)), R)
    )


NO_CONTACTS = [
    "[]", "[ I ]", "[/I ]", "[P:]", "[P:N]", "[:M0.0]", "[P M0.0:M0.1]", "[P /I0.0]", "[NOT NOT]", "[VW0 >]", "[>= 5]",
    "[VW0 5]", "[VW0 > > 5]", "[VW0 >= 5 6]", "[VW0 >=Q 5]", "[--5 > VW0]", "[VW0 > 5-]", "[a,b > 5]", "[VW0 >- 5]",
]  # fmt: skip


@pytest.mark.parametrize("drawn", NO_CONTACTS)
def test_what_is_nearly_a_contact_is_said_where_it_stands(drawn: str) -> None:
    (found,) = read_drawing(f"--[ I0.0 ]--{drawn}--( Q0.0 )")[1]
    assert (found.code, found.span.start, found.span.stop) == ("DRW003", 12, 12 + len(drawn))


OUTPUTS = {
    "(P M0.0 )": Coil("M0.0", "rise"),
    "(↓M0.0)": Coil("M0.0", "fall"),
    "(N M0.0)": Coil("M0.0", "fall"),
    "(I Q0.0 )": Coil("Q0.0", immediate=True),
    "(SI Q0.0 2)": Coil("Q0.0", "set", 2, immediate=True),
    "( ri q0.0, 2 )": Coil("Q0.0", "reset", 2, immediate=True),
    "{ TON T37, 50 }": Box("TON T37, 50"),
    "{  ton   t37,50}": Box("TON T37,50"),
    "{ CU: CTU C0, 3 }": Box("CTU C0, 3", entry="CU"),
    "{[%MW0 := %MW1 - 5]}": Box("[%MW0 := %MW1 - 5]"),
    "{JMPC %L1}": Box("JMPC %L1"),
    "｛ＴＯＮ　Ｔ３７，－５０｝": Box("TON T37,-50"),
    "{ MOVW VW0, 温度 }": Box("MOVW VW0, 温度"),
}


@pytest.mark.parametrize("drawn", OUTPUTS)
def test_coils_and_boxes_of_every_kind(drawn: str) -> None:
    assert one(f"--[ I0.0 ]--+--{drawn}\n            +--( Q0.0 )") == Rung(A, (OUTPUTS[drawn], Q))


@pytest.mark.parametrize(
    "drawn", ["( I )", "(SI)", "(P M0.0 2)", "(I Q0.0 2)", "(SI Q0.0 0)", "(RI Q0.0 256)", "(PI Q0.0)"]
)
def test_what_is_nearly_a_coil_is_said_where_it_stands(drawn: str) -> None:
    (found,) = read_drawing(f"--[ I0.0 ]--{drawn}")[1]
    assert (found.code, found.span.start, found.span.stop) == ("DRW004", 12, 12 + len(drawn))


def test_the_canonical_forms_of_all_symbols() -> None:
    line = "[VW0 >= 5] · P:M0.0 · /I I0.0 · I I0.1 · N -> S Q0.0, SI Q0.1 2, P M0.0, I Q0.2, /Q0.3, {TON T37, 50}"
    rung = one(line)
    assert write_line(rung) == line
    assert (
        write_drawing(rung)
        == """\
--[ VW0 >= 5 ]--[P:M0.0]--[/I I0.0 ]--[I I0.1 ]--[N]--+--(S Q0.0 )
                                                      +--(SI Q0.1 2)
                                                      +--(P M0.0 )
                                                      +--(I Q0.2 )
                                                      +--(/ Q0.3 )
                                                      +--{ TON T37, 50 }
"""
    )


BIG = """\
--[ I0.0 ]--+--( Q0.0 )
            +--[/I0.1 ]-----------------{CU: CTUD C48, 3 }
|
--[ I0.2 ]--+--+--[ I0.4 ]--+--[NOT]----{CD:             }
--[ I0.3 ]--+  +--[ I0.0 ]--+
--[ VW0 > 5 ]---------------------------{R:              }
"""


def test_a_box_of_several_inputs() -> None:
    counter = Box("CTU C0, 3", (("R", B),), "CU")
    assert one(COUNTER) == Rung(A, (counter,))
    assert write_drawing(Rung(A, (counter,))) == COUNTER
    assert one("I0.0 -> {CU: CTU C0, 3; R: I0.1}") == Rung(A, (counter,))
    assert one("--[I0.0]-{cu:ctu C0, 3}\n|\n|-[I0.1]-{ r : }--|") == Rung(A, (counter,))
    down = series(parallel(C, D), parallel(E, A), Invert())
    pins = (("CD", down), ("R", Compared("VW0", ">", "5")))
    apart = Rung(None, (Box("CTUD C0, 3", (("CD", parallel(A, B)), ("R", parallel(C, D))), "CU"),))
    assert write_drawing(apart).splitlines()[3] == "|"
    assert read_drawing(write_drawing(apart)) == (Ladder((apart,)), ())
    assert one(BIG) == Rung(A, (Q, Branch(Contact("I0.1", negated=True), (Box("CTUD C48, 3", pins, "CU"),))))


def test_two_counters_in_one_drawing_keep_their_inputs_apart() -> None:
    ladder, found = read_drawing(f"{COUNTER}--[ I0.2 ]--{{CD: CTD C1, 3 }}\n--[ I0.3 ]--{{LD: }}\n--[ I0.4 ]--( Q0.0 )")
    assert found == ()
    assert [write_line(rung) for rung in ladder.rungs] == [
        "I0.0 -> {CU: CTU C0, 3; R: I0.1}", "I0.2 -> {CD: CTD C1, 3; LD: I0.3}", "I0.4 -> Q0.0",
    ]  # fmt: skip


@pytest.mark.parametrize("text", ["LBL 1", "NEXT", "SCRE", "MCR N0", "STL S20", "%L1:", "SR0:"])
def test_a_box_without_a_flow(text: str) -> None:
    label = Rung(None, (Box(text),))
    for drawing in (f"--{{{text}}}", f"{{ {text} }}", f"|--{{ {text} }}--|", f"-> {{{text}}}"):
        assert one(drawing) == label
    ladder, found = read_drawing(f"--[ I0.0 ]--{{ TON T37, 50 }}\n--{{ {text} }}\n--[ I0.1 ]--( Q0.0 )")
    assert found == ()
    assert ladder.rungs == (Rung(A, (Box("TON T37, 50"),)), label, Rung(B, (Q,)))


def test_an_input_apart_from_its_box_is_said_in_both_languages() -> None:
    (found,) = read_drawing(BAD["DRW018"])[1]
    assert found.text.zh == "{R:     }是方框的另一个输入，而它上面是 ( Q0.0 )。它属于哪个方框？"
    assert found.text.en == (
        "{R:     } is a further input of a box, and above it stands ( Q0.0 ). Which box does it belong to?"
    )
    assert "there is none" in read_drawing("--[ I0.0 ]--{R: }")[1][0].text.en


@settings(max_examples=600, deadline=None)
@given(ladder=ladders("s7-200", every=True) | ladders("neza", every=True), title=st.sampled_from(TITLES))
def test_every_symbol_to_drawing_and_back(ladder: Ladder, title: str) -> None:
    titled = Ladder(ladder.rungs, title)
    drawing = write_drawing(titled)
    assert read_drawing(drawing) == (titled, ())
    assert write_drawing(read_drawing(drawing)[0]) == drawing
    assert is_drawing(drawing)
    for rung in ladder.rungs:
        assert read_line(write_line(rung)) == retitled(rung, "")
        assert is_drawing(write_line(rung))


@settings(max_examples=300, deadline=None)
@given(rung=rungs("fx", every=True), data=st.data())
def test_one_slip_beside_a_box_is_found_or_gives_another_rung(rung: Rung, data: st.DataObject) -> None:
    drawing = write_drawing(rung)
    at = data.draw(st.integers(0, len(drawing) - 1))
    slip = drawing[:at] + data.draw(st.sampled_from(" -+|[]{}(:;=x")) + drawing[at + 1 :]
    read, found = read_drawing(slip)
    if not found:
        assert read_drawing(write_drawing(read)) == (read, ())


@settings(max_examples=200, deadline=None)
@given(ladder=ladders("neza", edges=True, turned=True))
def test_box_drawing_characters_and_rails_say_the_same(ladder: Ladder) -> None:
    rows = write_drawing(ladder).splitlines()
    width = max(map(len, rows)) + 2
    railed = "\n".join(f"|{row.ljust(width, '-' if row.endswith(')') else ' ')}|" if row else "" for row in rows)
    assert read_drawing(railed) == (ladder, ())
    assert read_drawing(railed.translate(str.maketrans("-|+", "─│┼"))) == (ladder, ())


@settings(max_examples=200, deadline=None)
@given(rung=rungs("fx", edges=True, turned=True))
def test_one_line_there_and_back(rung: Rung) -> None:
    assert read_line(write_line(rung)) == rung
    assert is_drawing(write_line(rung))


LINES = {
    "(I0.0 + Q0.0) · /I0.1 -> Q0.0": "(I0.0 + Q0.0) · /I0.1 -> Q0.0",
    "(i0.0|q0.0)*!i0.1->q0.0": "(I0.0 + Q0.0) · /I0.1 -> Q0.0",
    "I0.0 & I0.1 + I0.2 → Q0.0, S Q0.1, R Q0.2 4, /Q0.3": "I0.0 · I0.1 + I0.2 -> Q0.0, S Q0.1, R Q0.2 4, /Q0.3",
    "/(I0.0 + /I0.1·I0.2) -> Q0.0": "/I0.0 · (I0.1 + /I0.2) -> Q0.0",
    "//  not this": "",
    "!!I0.0 -> Q0.0": "I0.0 -> Q0.0",
    "↑I0.0 · N M0.0 · NOT -> Q0.0": "P I0.0 · N M0.0 · NOT -> Q0.0",
    "/([D0 > 1] + [D0 >= 2] + [D0 < 3] + [D0 <= 4]) -> Q0.0": "[D0 <= 1] · [D0 < 2] · [D0 >= 3] · [D0 > 4] -> Q0.0",
    "!([VW0=5]·![VD0<>R 1.5]·/I I0.0) -> Q0.0": "[VW0 <> 5] + [VD0 <>R 1.5] + I I0.0 -> Q0.0",
    "[vw0>=5]*p*n:m0.0->si q0.0 2,{cu:ctu c0,3;r:p}": "[VW0 >= 5] · P · N:M0.0 -> SI Q0.0 2, {CU: CTU C0,3; R: P}",
    "［ＶＷ０≥－５］→｛ＴＯＮ　Ｔ３７，５０｝": "[VW0 >= -5] -> {TON T37,50}",
    "（Ｉ０．０＋Ｉ０．１）＊Ｉ０．２－＞Ｑ０．０": "(I0.0 + I0.1) · I0.2 -> Q0.0",
}  # fmt: skip


@pytest.mark.parametrize("line", [line for line in LINES if LINES[line]])
def test_one_line_spellings(line: str) -> None:
    assert write_line(one(line)) == LINES[line]


BAD = {
    "DRW001": "--[ I0.0 ]--( Q0.0 )  lamp",
    "DRW002": "--[ I0.0 --( Q0.0 )",
    "DRW003": "--[ I0.0 I0.1 ]--( Q0.0 )",
    "DRW004": "--[ I0.0 ]--(S Q0.0 0)",
    "DRW005": "--[ I0.0 ]--{ }",
    "DRW006": "--[ I0.0 ]--+--( Q0.0 )\n            |",
    "DRW007": "--[ I0.0 ]--[ I0.1 ]--",
    "DRW008": "--[ I0.0 ]--( Q0.0 )\n            --( Q0.1 )",
    "DRW009": "--[I0.0]--+--[I0.1]--+--(Q0.0)\n          |          |\n          +---(Q0.1) |\n--[I0.2]-------------+",
    "DRW010": "--+--[ I0.0 ]--+--[ I0.1 ]--( Q0.0 )\n  +------------+",
    "DRW011": "--[ I0.0 ]--( Q0.0 )--[ I0.1 ]--( Q0.1 )",
    "DRW012": "-" * 600 + "[ I0.0 ]--( Q0.0 )",
    "DRW013": "I0.0 + -> Q0.0",
    "DRW014": "(" * 100 + "I0.0" + ")" * 100 + " -> Q0.0",
    "DRW015": "   \n\n",
    "DRW016": "--[ I0.0 ]--+--( Q0.0 )\n--[ Q0.0 ]---+",
    "DRW017": "--[ I0.0 ]--+--( Q0.0 )\n--[ Q0.0 ]--",
    "DRW018": "--[ I0.0 ]--( Q0.0 )\n--[ I0.1 ]--{R:     }",
    "DRW019": "--[ I0.0 ]--+------------{CU: CTU C0, 3 }\n            +--[ I0.1 ]--{R:            }",
    "DRW020": "I0.0 -> {CU: CTU C0, 3; R: I0.1}, Q0.0",
}


def test_every_declared_slip_has_a_bad_drawing() -> None:
    assert set(BAD) == {code for code in RULES if code.startswith("DRW")}


@pytest.mark.parametrize("code", BAD)
def test_a_bad_drawing_is_called_by_its_name(code: str) -> None:
    ladder, found = read_drawing(BAD[code])
    assert {one.code for one in found} == {code}
    assert ladder.rungs == ()
    for one_found in found:
        assert not re.search(r"{[a-z]+}", one_found.text.zh + one_found.text.en)


PLACES = [
    ("DRW001", "--[ I0.0 ]--( Q0.0 )  lamp", (1, 22, 26)),
    ("DRW006", "\n--[ I0.0 ]--+--( Q0.0 )\n            |", (3, 12, 13)),
    ("DRW007", "--[ I0.0 ]--", (1, 2, 10)),
    ("DRW008", "--[ I0.0 ]--( Q0.0 )\n            --( Q0.1 )", (2, 14, 22)),
    ("DRW009", "--[I0.0]--+--[I0.1]--+--(Q0.0)\n          +---(Q0.1) |\n--[I0.2]-------------+", (1, 21, 22)),
    ("DRW013", "I0.0 + * I0.1 -> Q0.0", (1, 7, 8)),
    ("DRW013", "I0.0 → → Q0.0", (1, 7, 8)),
    ("DRW013", "I0.0 → Q0.0 ,", (1, 13, 13)),
    ("DRW001", "－－［Ｉ０．０］－－（Ｑ０．０）灯", (1, 16, 17)),
]


COUNTER = """\
--[ I0.0 ]--{CU: CTU C0, 3 }
--[ I0.1 ]--{R:            }
"""

PLACES += [
    ("DRW002", "--[ I0.0 ]--{ TON T37, // 50 }", (1, 12, 13)),
    ("DRW002", "--[ I0.0 ]--{ TON T37, 50", (1, 12, 13)),
    ("DRW005", "--[ I0.0 ]--{}", (1, 12, 14)),
    ("DRW005", "--[ I0.0 ]--{CU: CTU C0, 3; R: I0.1}", (1, 12, 36)),
    ("DRW007", "--[ I0.0 ]--[ VW0 > 5 ]--", (1, 12, 23)),
    ("DRW011", "--[ I0.0 ]--{ TON T37, 30 }--( Q0.0 )", (1, 29, 37)),
    ("DRW018", "--[ I0.0 ]--{R: }", (1, 12, 17)),
    ("DRW018", "--{R: }", (1, 2, 7)),
    ("DRW018", "--[ I0.1 ]--{R: }\n--[ I0.0 ]--{CU: CTU C0, 3 }", (1, 12, 17)),
    ("DRW018", f"{COUNTER}--[ I0.2 ]--( Q0.0 )\n--[ I0.3 ]--{{X: }}", (4, 12, 17)),
    ("DRW019", f"{COUNTER}------------{{X: }}", (3, 12, 17)),
    ("DRW019", "--[ I0.0 ]--+--{CU: CTU C0, 3 }\n            +--{R: }", (2, 15, 20)),
    ("DRW019", f"{COUNTER}--[ I0.2 ]--+--{{X: }}\n            +--( Q0.0 )", (3, 15, 20)),
    ("DRW019", f"{COUNTER}--[ I0.2 ]--+--{{X: }}\n            +--[ I0.3 ]--( Q0.0 )", (3, 15, 20)),
    ("DRW020", "--[ I0.0 ]--+--{CU: CTU C0, 3 }\n            +--( Q0.0 )\n--[ I0.1 ]-----{R: }", (1, 15, 31)),
    ("DRW020", "I0.0 -> {CU: CTU C0, 3; R: I0.1}, Q0.0", (1, 8, 22)),
    ("DRW020", "I0.0 -> (I0.2 -> {CU: CTU C0, 3; R: I0.1}), Q0.0", (1, 17, 31)),
    ("DRW013", "[VW0 5] -> Q0.0", (1, 0, 7)),
    ("DRW013", "[VW0 > 5 -> Q0.0", (1, 0, 16)),
    ("DRW013", "P: -> Q0.0", (1, 3, 5)),
    ("DRW013", "/P -> Q0.0", (1, 3, 5)),
    ("DRW013", "I0.0 -> {}", (1, 8, 9)),
    ("DRW013", "I0.0 -> {R:}", (1, 8, 11)),
    ("DRW013", "I0.0 -> {CTU C0, 3; 5: I0.1}", (1, 20, 21)),
    ("DRW013", "I0.0 -> {CTU C0, 3; R I0.1}", (1, 22, 26)),
    ("DRW013", "I0.0 -> {CTU C0, 3; R: }", (1, 23, 24)),
    ("DRW013", "I0.0 -> {CTU C0, 3", (1, 18, 18)),
    ("DRW013", "I0.0 -> I Q0.0 3", (1, 15, 16)),
]


@pytest.mark.parametrize(("code", "drawing", "place"), PLACES)
def test_a_finding_stands_where_the_slip_is(code: str, drawing: str, place: tuple[int, int, int]) -> None:
    found = [one for one in read_drawing(drawing)[1] if one.code == code]
    assert (found[0].span.row, found[0].span.start, found[0].span.stop) == place


def test_every_message_about_a_drawing_ends_with_a_question_and_no_blank() -> None:
    for code in BAD:
        says = RULES[code].says
        assert (says.zh[-1], says.en[-1]) == ("？", "?")
        assert (says.zh.strip(), says.en.strip()) == (says.zh, says.en)


MISSED = {
    "one column to the right": ("--[I0.0]--+--(Q0.0)\n--[Q0.0]---+", "DRW016", (2, 11), (1, 10)),
    "two columns to the right": ("--[I0.0]--+--(Q0.0)\n--[Q0.0]----+", "DRW016", (2, 12), (1, 10)),
    "one column to the left": ("--[I0.0]--+--(Q0.0)\n--[Q0.0]-+", "DRW016", (2, 9), (1, 10)),
    "a branch aside": ("--[I0.0]--+--(Q0.0)\n           +--(Q0.1)", "DRW016", (2, 11), (1, 10)),
    "the upper one aside": (
        "--[I0.0]--+--(Q0.0)\n           +--(Q0.1)\n           +--(Q0.2)", "DRW016", (1, 10), (2, 11),
    ),
    "in the middle of three rows": (
        "--[I0.0]--+--(Q0.0)\n--[I0.1]---+\n--[I0.2]--+", "DRW016", (2, 11), (1, 10),
    ),
    "a vertical wire aside": ("--[I0.0]--+\n           |\n--[Q0.0]--+--(Q0.0)", "DRW016", (2, 11), (1, 10)),
    "a vertical wire aside below a wire": (
        "--[I0.0]--+--(Q0.0)\n           |\n--[Q0.0]--+", "DRW016", (3, 10), (2, 11),
    ),
    "two pairs": (
        "--[I0.0]--+--(Q0.0)\n--[I0.1]--+\n--[I0.2]---+\n--[I0.3]---+", "DRW016", (3, 11), (2, 10),
    ),
    "beside the left rail": ("--+--[I0.0]--+--(Q0.0)\n   +--[Q0.0]--+", "DRW016", (2, 3), (1, 2)),
    "no joint at the end": ("--[I0.0]--+--(Q0.0)\n--[Q0.0]-", "DRW017", (2, 8), (1, 10)),
    "no joint, right below": ("--[I0.0]--+--(Q0.0)\n--[Q0.0]---", "DRW017", (2, 10), (1, 10)),
    "no joint at the beginning": ("--[I0.0]--+--(Q0.0)\n          ---(Q0.1)", "DRW017", (2, 10), (1, 10)),
    "nothing but a contact": ("--[I0.0]--+--(Q0.0)\n--[ Q0.0 ]", "DRW017", (2, 9), (1, 10)),
    "a tab in one row": ("\t--[I0.0]--+--(Q0.0)\n  --[Q0.0]--+", "DRW016", (2, 12), (1, 11)),
    "a loose row that is otherwise a rung": (
        "--[I0.0]--+--(Q0.0)\n--[Q0.0]---+--(Q0.1)", "DRW016", (2, 11), (1, 10),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", MISSED)
def test_a_joint_that_was_missed_is_said_with_both_places(name: str) -> None:
    drawing, code, place, near = MISSED[name]
    ladder, found = read_drawing(drawing)
    assert ladder.rungs == ()
    assert [(one.code, (one.span.row, one.span.start)) for one in found] == [(code, place)]
    assert (found[0].notes[0].span.row, found[0].notes[0].span.start) == near
    rows = [row.expandtabs(8) for row in drawing.split("\n")]
    seen = [len(drawing.split("\n")[row - 1][:at].expandtabs(8)) + 1 for row, at in (place, near)]
    assert all(f"{column}" in found[0].text.zh and f"{column}" in found[0].text.en for column in seen)
    assert rows[near[0] - 1][seen[1] - 1] in "+|"
    assert len(found[0].notes) == 1 + ("\t" in drawing)


def test_the_message_names_both_columns() -> None:
    (found,) = read_drawing("--[ I0.0 ]--+--( Q0.0 )\n--[ Q0.0 ]---+")[1]
    assert found.text.en == (
        "The + at column 14 has no + above it; the nearest is at column 13. Should they stand under each other?"
    )
    assert found.text.zh == "第14列的 + 上面没有 +，最近的在第13列。它们是不是应该上下对齐？"


CLOSE = {
    "joint beside joint": "--[I0.0]-+-+-[I0.1]-(Q0.0)\n--[I0.2]-+ +-[I0.3]-(Q0.1)",
    "a joint that joins nothing": "--[I0.0]-+-[I0.1]-(Q0.0)",
    "stairs": (
        "--[I0.0]-+-[I0.1]-+-(Q0.0)\n         |        +-(Q0.1)\n         +-[I0.3]--+-(Q0.2)\n                   +-(Q0.3)"
    ),
    "a ragged right rail": "--[I0.0]--(Q0.0)--+\n--[I0.1]--(Q0.1)---+",
}


@pytest.mark.parametrize("name", CLOSE)
def test_joints_that_are_near_each_other_on_purpose_are_left_alone(name: str) -> None:
    assert read_drawing(CLOSE[name])[1] == ()


def test_a_tab_reaches_to_the_next_multiple_of_eight() -> None:
    rows = ["--[ I0.0 ]--\t+--( Q0.0 )", "--[ I0.1 ]--\t+"]
    blanks = "\n".join(row.expandtabs(8) for row in rows)
    assert {found.code for found in read_drawing(blanks)[1]} == {
        found.code for found in read_drawing("\n".join(rows))[1]
    }
    assert one("\t--[ I0.0 ]--+--( Q0.0 )\n        --[ I0.1 ]--+") == Rung(Parallel((A, B)), (Q,))
    assert one("  \t--[ I0.0 ]--+--( Q0.0 )\n\t--[ I0.1 ]--+") == Rung(Parallel((A, B)), (Q,))
    (found,) = read_drawing("\t--[ I0.0 ]--( Q0.0 )\tlamp")[1]
    assert (found.span.start, found.span.stop) == (22, 26)


def test_a_join_and_the_branch_behind_it_stay_two_joints() -> None:
    drawing = "--[ I0.0 ]--+--+--[ I0.1 ]--( Q0.0 )\n--[ I0.5 ]--+  +--[ I0.2 ]--( Q0.1 )\n"
    assert write_drawing(one(drawing)) == drawing
    merged = "--[ I0.0 ]--+--[ I0.1 ]--( Q0.0 )\n--[ I0.5 ]--+--[ I0.2 ]--( Q0.1 )\n"
    assert write_drawing(one(merged)) == drawing


def test_a_real_bridge_is_refused_and_said_once() -> None:
    bridge = """\
--[I0.0]--+--[I0.3]----------+--(Q0.0)
          |                  |
          +--[I0.2]--+       |
                     |       |
--[I0.1]-------------+-[I0.4]+
"""
    ladder, found = read_drawing(bridge)
    assert ladder.rungs == ()
    assert [one.code for one in found] == ["DRW009"]


def test_good_rungs_beside_a_bad_one_are_kept() -> None:
    ladder, found = read_drawing("--[I0.0]--(Q0.0)\n\n--[I0.1]--\n\n--[I0.2]--(Q0.2)")
    assert [write_line(rung) for rung in ladder.rungs] == ["I0.0 -> Q0.0", "I0.2 -> Q0.2"]
    assert [one.span.row for one in found] == [3]


HOSTILE = {
    "1 MB of wires": "-" * 1_000_000,
    "1 MB of rows": "--[I0.0]--(Q0.0)\n" * 60_000,
    "many rows within the limit": "--[I0.0]--(Q0.0)\n" * 5_800,
    "one tall rung": "--[I0.0]--+\n" * 8_000,
    "10,000 columns": "--[ I0.0 ]" * 1_000 + "--( Q0.0 )",
    "control characters": "--[ I0.0 ]\x00\x01--( Q0.0 )",
    "10,000 parentheses": "(" * 10_000 + "I0.0" + ")" * 10_000 + "->Q0.0",
    "400 parentheses": "(" * 200 + "I0.0" + ")" * 200 + "->Q0.0",
    "400 inversions": "/" + "/" * 399 + "(->",
    "inversions and parentheses": "!(" * 200 + "I0.0" + ")" * 200 + "->Q0.0",
    "nested outputs": "I0.0->" + "(I0.0->" * 60 + "Q0.0",
    "brackets": "[(" * 200 + "\n" + "])" * 200,
    "crosses": ("+" * 400 + "\n") * 100,
    "a maze": ("-+|" * 150 + "\n") * 110,
    "full width": "＋" * 90_000,
    "10,000 braces": "--{" * 10_000,
    "braces within": "--" + "{" * 200 + "}" * 200,
    "inputs only": "--[I0.0]--{R: }\n" * 100,
    "rings of inputs": "--[I0.0]--+--{R: }\n" * 100,
    "boxes behind boxes": "--{A: B}" * 60,
    "relations": "--[" + "<>=" * 100 + "]--( Q0.0 )",
    "signs": "--[ " + "+-" * 100 + " > 5 ]--( Q0.0 )",
    "emoji": "🙂--[ 🙂 ]--( 🙂 )" * 20,
    "surrogate": "--[ \ud800 ]--( Q0.0 )",
    "filler": "--[ \ufdd0 ]--( \ufdd0Q0.0 )",
    "nothing": "",
}


HANGS = 60
"""Seconds of work after which a reader is said to hang; how fast it is, the benchmarks say."""


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_text_gives_a_finding_and_does_not_hang(name: str) -> None:
    begun = time.process_time()
    ladder, found = read_drawing(HOSTILE[name])
    assert time.process_time() - begun < HANGS
    assert found or (ladder.rungs and name == "many rows within the limit")
    assert len(found) <= 20
    is_drawing(HOSTILE[name])


LONG = 100_000
LONG_LINES = {
    "blanks in a comparison": f"[VW0{' ' * LONG}>{' ' * LONG}5{' ' * LONG}x] -> Q0.0",
    "a long word": f"[{'A1.' * LONG} > 5] -> Q0.0",
    "digits": f"[VW0 > {'1' * LONG}] -> Q0.0",
    "a real": f"[VD0 >R {'1.' * LONG}E{'9' * LONG}] -> Q0.0",
    "signs": f"[VW0 > {'-' * LONG}5] -> Q0.0",
    "prefixes": f"[VW0 > {'16#' * LONG}] -> Q0.0",
    "relations": f"[{'<' * LONG}] -> Q0.0",
    "open comparisons": f"{'[' * LONG} -> Q0.0",
    "open braces": f"I0.0 -> {'{' * LONG}",
    "an open box": f"I0.0 -> {{{'A: ' * LONG}",
    "semicolons": f"I0.0 -> {{CTU C0, 3{';' * LONG}}}",
    "edges": f"{'P:' * LONG} -> Q0.0",
    "slashes": f"{'/' * LONG} -> Q0.0",
    "blanks at the end": f"I0.0 -> {' ' * LONG}",
}


@pytest.mark.parametrize("name", LONG_LINES)
def test_a_very_long_line_gives_a_finding_at_once(name: str) -> None:
    begun = time.process_time()
    found = read_line(LONG_LINES[name])
    assert time.process_time() - begun < 5
    assert isinstance(found, Diagnostic)
    assert len(found.text.en) < 300


@pytest.mark.parametrize("words", [
    " " * LONG, "/" + " " * LONG, "P" + " " * LONG + ":", "VW0" + " " * LONG + "> 5 x", "A" * LONG, "1" * LONG + ">", "> " * LONG,
    "E-" * LONG, "CU " * LONG, "S Q0.0" + " " * LONG + "x", ":" * LONG, "R :" * LONG,
])  # fmt: skip
def test_very_long_words_between_brackets_are_read_or_refused_at_once(words: str) -> None:
    begun = time.process_time()
    assert contact(words) is None
    assert coil(words) is None
    box(words)
    assert time.process_time() - begun < 5


def test_a_very_long_box_is_read() -> None:
    text = "X " * LONG
    assert read_line(f"I0.0 -> {{{text}}}") == Rung(A, (Box(text),))


@settings(max_examples=400, deadline=None)
@given(text=st.text(st.sampled_from("-|+[]()/ \nI0.1QNPSR,>{}:;=＋【─┬→·"), max_size=200))
def test_any_scribble_gives_rungs_or_findings(text: str) -> None:
    ladder, found = read_drawing(text)
    assert ladder.rungs or found
    for one_found in found:
        assert isinstance(one_found, Diagnostic)
        rows = text.split("\n")
        assert 1 <= one_found.span.row <= len(rows)
        assert 0 <= one_found.span.start <= one_found.span.stop <= len(rows[one_found.span.row - 1]) + 1


@settings(max_examples=200, deadline=None)
@given(ladder=ladders("s7-200"), data=st.data())
def test_one_slip_in_a_drawing_is_found_or_gives_another_ladder_but_never_a_crash(
    ladder: Ladder, data: st.DataObject
) -> None:
    drawing = write_drawing(ladder)
    at = data.draw(st.integers(0, len(drawing) - 1))
    slip = drawing[:at] + data.draw(st.sampled_from(" -+|[](x")) + drawing[at + 1 :]
    read, found = read_drawing(slip)
    if not found:
        assert read_drawing(write_drawing(read)) == (read, ())


@pytest.mark.parametrize(("text", "expected"), [
    (SEAL_IN, True),
    ("I0.0 -> Q0.0", True),
    ("\n\n  // a comment -- with dashes\n--[I0.0]--(Q0.0)", True),
    ("|\n|--[I0.0]--(Q0.0)", True),
    ("├──[ I0.0 ]──( Q0.0 )┤", True),
    ("Network 1 // start\n--[I0.0]--(Q0.0)", True),
    ("[I0.0]-[I0.1]-+-(Q0.0)", True),
    ("[I0.0]-(Q0.0)", True),
    (" |-[ I0.0 ] - ( Q0.0 )", True),
    ("-(Q0.0)", True),
    ("【I0.0】－（Q0.0）", True),
    ("// [I0.0]-(Q0.0)\nLD I0.0", False),
    ("[%MW0 := 1]", False),
    ("[%MW0 := %MW1-(%MW2)]", False),
    ("[ %MW0 := %MW1 - 1 ]\nLD %I0.0", False),
    ("LD [%MW0 > 5]\nAND( %I0.1\nOR %I0.2\n)", False),
    ("AND( %I0.1\nOR( %I0.2 - 1)", False),
    ("LD I0.0 ; motor-(a)", False),
    ("LD I0.0 // -> the lamp\n= Q0.0", False),
    ("(* -- *)\nLD I0.0", False),
    ("Network 1 // a -- b\nLD I0.0\n= Q0.0", False),
    ("LD I0.0\n--[I0.0]--(Q0.0)", False),
    ("", False),
])  # fmt: skip
def test_a_drawing_is_told_from_a_program(text: str, *, expected: bool) -> None:
    assert is_drawing(text) is expected


@pytest.mark.parametrize("family", ["s7-200", "fx", "neza", "gutta"])
@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_no_instruction_list_is_taken_for_a_drawing(family: str, data: st.DataObject) -> None:
    program = lower(data.draw(ladders(family)), find_dialect(family))
    assert not is_drawing(program)
    assert not any(is_drawing(line) for line in program.splitlines())


@settings(max_examples=150, deadline=None)
@given(chain=st.lists(st.sampled_from([A, B, Contact("I0.2", negated=True), Contact("I0.3", edge="rise")]), min_size=1))
def test_single_dashes_are_wires(chain: list[Contact]) -> None:
    row = "-".join([*(f"[{contact.mark}{contact.address}]" for contact in chain[:30]), "(Q0.0)"])
    assert is_drawing(row)
    assert one(row) == Rung(series(*chain[:30]), (Q,))


def test_makers_give_the_plain_form() -> None:
    assert series(series(A, B), C) == Series((A, B, C))
    assert parallel(A) == A
    assert parallel(parallel(A, B), series(C, parallel(D, E))) == Parallel((A, B, Series((C, Parallel((D, E))))))
    assert branch(A, branch(B, Q, R)) == Branch(Series((A, B)), (Q, R))
    assert depth(Rung(Series((A, Parallel((B, C)))), (Q,))) == 4
    assert repr(Contact("i0.0", negated=True)) == "Contact(/I0.0)"
    assert "\n" not in repr(Rung(A, (Q,)))


def test_a_developer_is_told_about_what_cannot_be() -> None:
    with pytest.raises(DeclarationError):
        Contact("I0.0", negated=True, edge="rise")
    with pytest.raises(DeclarationError):
        Rung(A, ())
