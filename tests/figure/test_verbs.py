"""The lecturer's words that draw: a text or a drawing in, a picture or a table out, and a clear word where it cannot be read."""

from __future__ import annotations

import pytest

import plcteach as plc
from plcteach.core.errors import PlcTeachError, UnknownNameError

TWO_BLOCKS = "--[ I0.0 ]--[ I0.1 ]--+--( Q0.0 )\n--[ I0.2 ]--[/I0.3 ]--+"


def test_a_table_has_every_row_and_the_boolean_meaning_of_the_ladder() -> None:
    table = plc.table(TWO_BLOCKS)
    assert table.inputs == ("I0.0", "I0.1", "I0.2", "I0.3")
    assert [values for values, _ in table.rows] == [f"{case:04b}" for case in range(16)]
    for values, result in table.rows:
        a, b, c, d = map(int, values)
        assert result == str(a & b | c & (1 - d))
    assert repr(table).splitlines()[0] == "I0.0 I0.1 I0.2 I0.3 | Q0.0"
    assert table._repr_html_().count("<tr>") == 17


def test_a_table_says_when_there_are_too_many_rows() -> None:
    with pytest.raises(PlcTeachError, match="6 inputs is the most"):
        plc.table("LD I0.0; A I0.1; A I0.2; A I0.3; A I0.4; A I0.5; A I0.6; = Q0.0")


def test_a_drawing_runs_in_every_family() -> None:
    assert plc.run(TWO_BLOCKS, [{"I0.2": 1}, {"I0.3": 1}])["Q0.0"] == "10"
    assert plc.run("--[ X0 ]--[/X1 ]--( Y0 )", [{"X0": 1}, {"X1": 1}], "fx")["Y0"] == "10"
    assert plc.run("--[ %I0.0 ]--( %Q0.0 )", [{"%I0.0": 1}], "neza")["%Q0.0"] == "1"
    assert plc.run("--[ I0.0 ]--( Q0.0 )", [{"I0.0": 1}], "gutta")["Q0.0"] == "1"


@pytest.mark.parametrize(("text", "row"), [("LD I0.0\nADN I0.1\n= Q0.0", 2), ("--[ I0.0 ]--( Q0.0 )\n--[ I0.1 ]--", 2)])
def test_what_cannot_be_read_is_said_with_its_row(text: str, row: int) -> None:
    with pytest.raises(PlcTeachError, match=f"row {row}"):
        plc.strip(text)


def test_figures_are_found_by_their_words() -> None:
    assert "iv3 iv0 iv1" in repr(plc.illustrate("LDS 3"))
    assert plc.illustrate("mpp", "fx").svg().startswith("<svg")
    assert plc.strip(TWO_BLOCKS, inputs={"I0.2": 1}).svg().count("OLD") >= 1
    assert "I0.0" in plc.draw(TWO_BLOCKS).svg()
    with pytest.raises(UnknownNameError):
        plc.illustrate("OLDD")
    with pytest.raises(PlcTeachError):
        plc.draw("--[ I0.0 ]--")
