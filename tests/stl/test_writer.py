"""Writing a program and reading it again gives the same program, whatever it says; writing twice changes nothing."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING, get_args

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plcteach.core.area import Area
from plcteach.core.diagnostic import errors
from plcteach.core.source import half_width
from plcteach.dialects import dialect, names
from plcteach.stl import read, write, write_bytes
from plcteach.stl.writer import Form

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time

if TYPE_CHECKING:
    from plcteach.core.insn import Insn, Operand
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect


def test_the_canonical_text() -> None:
    program = read("NETWORK 5 //启动\nld i0.0 (* a *); U e0.1\n// above\n=a0.0\nnetwork\n s q0.1 , 2\n;bye", "s7-200")
    assert write(program) == (
        "Network 1 // 启动\nLD I0.0\nA I0.1 // a\n// above\n= Q0.0\nNetwork 2\nS Q0.1, 2\n// bye\n"
    )
    assert write(read("0 LD X000\n1 OUT Y000\n", "fx")) == "LD X0\nOUT Y0\n"
    assert write(read("rung 0\nLD %I0.0\nST %Q0.0", "neza")) == "RUNG 0\nLD %I0.0\nST %Q0.0\n"
    assert write(read("", "s7-200")) == ""


def headed(program: Program) -> Program:
    """The same program with a heading for each network, as an exported project has it in families with networks."""
    if not program.dialect.networks_by_title:
        return program
    return replace(program, networks=tuple(replace(one, headed=True) for one in program.networks))


def survives(program: Program) -> None:
    for form in get_args(Form):
        text = write(program, form)
        again = read(text, program.dialect)
        assert again == (headed(program) if form == "export" else program), form
        assert write(again, form) == text
        assert read(write_bytes(program, form), program.dialect) == again


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
REMARKS = WORDS.filter(lambda text: "*)" not in half_width(text))  # ×） and the like end a comment as well
PLAIN = st.text(st.sampled_from("ab 启动，.-=1(*)/;："), max_size=10)


def spellings(family: Dialect, operand: Operand) -> list[str]:
    """What may stand for an operand: the ends and the middle of each area that its kind names, in that kind's width."""
    if operand.number:
        return [f"{operand.mark}{number}" for number in sorted({operand.first, operand.last})]
    if operand.kind == "assign":
        return ["%MW0", "%TM3.P", "%C15.P", "%R1.I"]
    kind = family.kinds[operand.kind]
    words = [f"{mark}7" for mark, base in family.constant.items() if base == 10 and kind.constant]
    for area in [one for one in family.areas if one.prefix in kind.areas]:
        for first, last in area.ranges:
            ends = area.index(first), area.index(last)
            for index in {*ends, sum(ends) // 2}:
                whole = area.address(index)
                letters = [f"{area.prefix}{letter}{index // 8 - index // 8 % 4}" for letter in area.words]
                words += [whole.text, *letters, *(area.part(whole, name).text for name in list(area.fields)[:4])]
    read_as = {word: found for word in words if not isinstance(found := family.address(word), Area)}
    fit = [word for word, found in read_as.items() if found is None or (found.size == kind.size and found.text == word)]
    fit = ["1.5"] if kind.real and kind.constant else fit
    if not kind.size:
        fit = whole_blocks(family, operand.kind)
    return [family.separator.join((one, one)) for one in fit] if operand.relation else fit


@lru_cache
def whole_blocks(family: Dialect, kind: str) -> list[str]:
    """The blocks that the instructions of one kind take, tried one by one: TON and TONR have timers of their own."""
    insn = next(one for one in family.insns if any(operand.kind == kind for operand in one.operands))
    words = [f"{area}{number}" for area in sorted(family.kinds[kind].areas) for number in range(256)]
    ten = next(mark for mark, base in family.constant.items() if base == 10)
    more = f", {ten}7" * (len(insn.operands) - 1)
    found = {word: errors(read(f"{insn.word} {word}{more}", family).diagnostics) for word in words}
    return [word for word in words if {one.code for one in found[word]} <= {"BLK007"}]


def operands(family: Dialect, insn: Insn) -> st.SearchStrategy[str]:
    full = st.tuples(*(st.sampled_from(spellings(family, one)) for one in insn.operands)).map(", ".join)
    return full | st.just("") if any(operand.optional for operand in insn.operands) else full


def spelled(insn: Insn, operands: str) -> str:
    """An instruction as a list spells it: with its block's section around it, its number glued to it, or in brackets."""
    if insn.word in {"BLK", "OUT_BLK", "END_BLK"}:
        return "BLK %C0\nLD %I0.0\nCU\nOUT_BLK\nLD D\nST %Q0.0\nEND_BLK"
    if insn.word in {"%L:", "SR", "SR:"}:
        return operands + insn.word[-1:].replace("R", "")
    return f"[{operands} := %MW1 + 5]" if insn.word == "[" else f"{insn.word} {operands}".strip()


@st.composite
def texts(draw: st.DrawFn, name: str) -> str:
    family = dialect(name)
    rows = []
    for _ in range(draw(st.integers(0, 14))):
        what = draw(st.integers(0, 9))
        if what == 0 and "SR:" not in family.words and draw(st.booleans()):
            rows.append(
                draw(
                    st.sampled_from(
                        ["SUBROUTINE_BLOCK SBR_1:SBR1", "SUBROUTINE_BLOCK a b:SBR2", "END_SUBROUTINE_BLOCK"]
                    )
                )
            )
        elif what == 0:
            sign = draw(st.sampled_from(["// ", ": ", "(* "]))
            title = draw(PLAIN | WORDS)
            title = title if sign == "// " else title.replace(";", "").replace("；", "")  # there a `;` ends the heading
            rows.append(f"{family.heading} 1 {sign}{title}{' *)' if sign == '(* ' else ''}")
        elif what == 1:
            rows.append(draw(st.sampled_from(["// ", "; ", "//"])) + draw(PLAIN | WORDS))
        elif what == 2:
            rows.append(f"(* {draw(REMARKS)}\n{draw(REMARKS)} *)")
        else:
            insn = draw(st.sampled_from(family.insns))
            tail = draw(st.sampled_from(["", "", " ;"]) | WORDS.map(" // {}".format))
            rows.append(f"{spelled(insn, draw(operands(family, insn)))}{tail}")
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
        for place in (0, -1):
            said = family.separator.join(spellings(family, operand)[place] for operand in insn.operands)
            text = spelled(insn, said)
            program = read(text, family)
            assert [line.text for line in program.lines] == text.split("\n")
            survives(program)


@settings(max_examples=100, deadline=None)
@given(st.text(max_size=200))
def test_what_was_understood_of_anything_survives(text: str) -> None:
    survives(read(text, "s7-200"))
