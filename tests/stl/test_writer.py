"""Writing a program and reading it again gives the same program, whatever it says; writing twice changes nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.dialects import dialect, names
from plcteach.stl import read, write

if TYPE_CHECKING:
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect, Insn, Operand


def test_the_canonical_text() -> None:
    program = read("NETWORK 5 //启动\nld i0.0 (* a *); U e0.1\n// above\n=a0.0\nnetwork\n s q0.1 , 2\n;bye", "s7-200")
    assert write(program) == (
        "Network 1 // 启动\nLD I0.0\nA I0.1 // a\n// above\n= Q0.0\nNetwork 2\nS Q0.1, 2\n// bye\n"
    )
    assert write(read("0 LD X000\n1 OUT Y000\n", "fx")) == "LD X0\nOUT Y0\n"
    assert write(read("rung 0\nLD %I0.0\nST %Q0.0", "neza")) == "RUNG 1\nLD %I0.0\nST %Q0.0\n"
    assert write(read("", "s7-200")) == ""


def survives(program: Program) -> None:
    text = write(program)
    again = read(text, program.dialect)
    assert again == program
    assert write(again) == text


@pytest.mark.parametrize(
    "title",
    [
        "(* a *)",
        "(* (* x *) *)",
        "// // x",
        "(* // x *)",
        "(*/x*)",
        "(* ; x *)",
        ": : x",
        "(*a",
        "a *)",
        "// (* a *) b",
        "// ;；：x",
    ],
)
def test_odd_titles_survive(title: str) -> None:
    survives(read(f"Network 1 {title}\nLD I0.0\n= Q0.0\n", "s7-200"))


@pytest.mark.parametrize(
    "comment",
    [
        "(* a // b *)",
        "// // a",
        "// (* a",
        "(* (* a *)",
        "; ; a",
        "；；a",
        "// ### x",
        "(* Network 2 *)",
        "// VAR",
        "(*\n\na\n*)",
        "//",
        "// a *)",
    ],
)
def test_odd_comments_survive(comment: str) -> None:
    survives(read(f"{comment}\nLD I0.0\n= Q0.0\n{comment}\n", "s7-200"))
    survives(read(f"LD I0.0\n= Q0.0 {comment}\n", "s7-200"))


# Random programs, made from the table: every mnemonic with legal operands, with titles and comments.

WORDS = st.text(st.characters(exclude_characters="\r\n\x00", exclude_categories=["Cs", "Cc", "Zl", "Zp"]), max_size=12)
PLAIN = st.text(st.sampled_from("ab 启动，.-=1(*)/;："), max_size=10)


def operands(family: Dialect, insn: Insn) -> st.SearchStrategy[str]:
    def one(operand: Operand) -> st.SearchStrategy[str]:
        if operand.number:
            return st.integers(operand.first, operand.last).map(str)
        areas = [area for area in family.areas if area.prefix in family.kinds[operand.kind].areas]
        indexes = [(area.index(first), area.index(last), area) for area in areas for first, last in area.ranges]
        return st.sampled_from(indexes).flatmap(
            lambda span: st.integers(span[0], span[1]).map(lambda index: span[2].address(index).text)
        )

    needed = [one(operand) for operand in insn.operands]
    full = st.tuples(*needed).map(", ".join)
    return full | st.just("") if any(operand.optional for operand in insn.operands) else full


@st.composite
def texts(draw: st.DrawFn, name: str) -> str:
    family = dialect(name)
    rows = []
    for _ in range(draw(st.integers(0, 14))):
        what = draw(st.integers(0, 9))
        if what == 0:
            sign = draw(st.sampled_from(["// ", ": ", "(* "]))
            title = draw(PLAIN | WORDS)
            title = title if sign == "// " else title.replace(";", "").replace("；", "")  # there a `;` ends the heading
            rows.append(f"{family.heading} 1 {sign}{title}{' *)' if sign == '(* ' else ''}")
        elif what == 1:
            rows.append(draw(st.sampled_from(["// ", "; ", "//"])) + draw(PLAIN | WORDS))
        elif what == 2:
            rows.append(f"(* {draw(WORDS).replace('*)', '')}\n{draw(WORDS).replace('*)', '')} *)")
        else:
            insn = draw(st.sampled_from(family.insns))
            tail = draw(st.sampled_from(["", "", " ;"]) | WORDS.map(" // {}".format))
            rows.append(f"{insn.mnemonic} {draw(operands(family, insn))}{tail}")
    return "\n".join(rows)


@pytest.mark.parametrize("name", names())
@settings(max_examples=100, deadline=None)
@given(data=st.data())
def test_read_write_read(name: str, data: st.DataObject) -> None:
    text = data.draw(texts(name))
    program = read(text, name)
    assert {one.code for one in program.diagnostics} <= {"RDR010", "RDR011", "RDR012"}, program.diagnostics
    survives(program)


@pytest.mark.parametrize("name", names())
def test_every_instruction_survives_with_every_number_of_operands(name: str) -> None:
    family = dialect(name)
    for insn in family.insns:
        first = []
        for operand in insn.operands:
            kind = None if operand.number else family.kinds[operand.kind]
            area = next((one for one in family.areas if kind and one.prefix in kind.areas), None)
            first.append(str(operand.first) if area is None else area.first)
        text = f"{insn.mnemonic} {', '.join(first)}".strip()
        program = read(text, family)
        assert [line.text for line in program.lines] == [text]
        survives(program)


@settings(max_examples=100, deadline=None)
@given(st.text(max_size=200))
def test_what_was_understood_of_anything_survives(text: str) -> None:
    survives(read(text, "s7-200"))
