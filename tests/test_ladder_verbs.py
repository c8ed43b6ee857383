"""The verbs about ladders, on the command line and in Python: what they print, write and refuse."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

import plcteach as plc
from plcteach.cli import main
from plcteach.core.errors import UnknownNameError
from plcteach.core.text import speaking

if TYPE_CHECKING:
    from pathlib import Path

MANUAL = """Network 1
LD I0.0
LD I0.1
LD I2.0
A I2.1
OLD
ALD
= Q5.0
Network 2
LD I0.0
LPS
LD I0.5
O I0.6
ALD
= Q7.0
LRD
LD I2.1
O I1.3
ALD
= Q6.0
LPP
A I1.0
= Q3.0
"""
NEZA = "%TM0: TYPE=TON TB=100ms P=30\nLD %I0.0\nIN %TM0\nLD %TM0.Q\nST %Q0.0\n"
SEAL_IN = "--[ I0.0 ]--+--[/I0.1 ]--( Q0.0 )\n--[ Q0.0 ]--+\n"


def call(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, str]:
    code = main([*words])
    out = capsys.readouterr()
    assert out.err == "" or code == 2
    return code, out.out + out.err


@pytest.fixture
def manual(tmp_path: Path) -> str:
    path = tmp_path / "manual.stl"
    path.write_text(MANUAL, encoding="utf-8")
    return str(path)


def test_the_manuals_two_networks_are_drawn_lifted_and_lowered_to_the_same_text(
    capsys: pytest.CaptureFixture[str], manual: str, tmp_path: Path
) -> None:
    code, drawing = call(capsys, "ladder", manual)
    assert code == 0
    assert drawing.startswith("--[ I0.0 ]--+--[ I0.1 ]------------+--( Q5.0 )")
    path = tmp_path / "drawing.txt"
    path.write_text(drawing, encoding="utf-8")
    assert call(capsys, "lower", str(path)) == (0, MANUAL)
    code, said = call(capsys, "check", str(path), "--reference", manual)
    assert (code, said.split(":")[0]) == (0, "equal")


@pytest.mark.parametrize("ending", ["svg", "pdf", "png", "txt", "xml"])
def test_a_ladder_is_written_in_the_form_that_the_ending_asks_for(
    capsys: pytest.CaptureFixture[str], manual: str, tmp_path: Path, ending: str
) -> None:
    path = tmp_path / f"ladder.{ending}"
    assert call(capsys, "ladder", manual, "-o", str(path), "--style", "iec", "--legend") == (0, "")
    begins = {"svg": b"<svg", "pdf": b"%PDF", "png": b"\x89PNG", "txt": b"--[", "xml": b"<?xml"}[ending]
    assert path.read_bytes().startswith(begins)
    if ending in {"txt", "xml"}:
        assert call(capsys, "check", str(path), "--reference", manual)[0] == 0


def test_lower_gives_reasons_and_json(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = tmp_path / "two.txt"
    path.write_text("--[ X0 ]--[ X1 ]--+--( Y0 )\n--[ X2 ]--[ X3 ]--+\n", encoding="utf-8")
    code, said = call(capsys, "lower", str(path), "--dialect", "fx", "--reasons", "--lang", "zh")
    assert code == 0
    assert "ORB     // 两个并联的电路块到这里结束" in said
    told = json.loads(call(capsys, "lower", str(path), "--dialect", "fx", "--json")[1])
    assert told["program"].split("\n")[:5] == ["LD X0", "AND X1", "LD X2", "AND X3", "ORB"]
    assert told["lines"][4] == {"text": "ORB", "rung": 0, "reason": "two parallel blocks end here"}


def test_translate_prints_the_table_the_program_and_the_notes(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    path = tmp_path / "timer.stl"
    path.write_text("LD I0.0\nTON T37, 50\nLD T37\n= Q0.0\n", encoding="utf-8")
    code, said = call(capsys, "translate", str(path), "--from", "s7-200", "--to", "neza")
    assert code == 0
    assert said.startswith("// I0.0 -> %I0.0\n// T37 -> %TM0\n")
    assert "%TM0: TYPE=TON TB=100ms P=50\n" in said
    assert "// note: A timer's bit changes" in said
    told = json.loads(call(capsys, "translate", str(path), "--to", "fx", "--json")[1])
    assert told["addresses"] == {"I0.0": "X0", "T37": "T0", "Q0.0": "Y0"}
    assert told["notes"] == []
    assert plc.run(told["program"], "X0: 6s on", "fx").edges("Y0")[1][0] == 5_000


def test_what_a_family_has_no_list_for_is_wrong_work_said_in_the_language_asked_for(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    path = tmp_path / "input.txt"
    path.write_text("--[ I0.0 ]--( I0.1 )\n", encoding="utf-8")
    assert call(capsys, "lower", str(path)) == (
        1,
        "Rung 1 has no statement list (STL) of Siemens S7-200: I0.1 is an input, which a program cannot write.\n",
    )
    code, said = call(capsys, "lower", str(path), "--lang", "zh")
    assert (code, said.startswith("第1级写不成")) == (1, True)
    assert "reason" in json.loads(call(capsys, "lower", str(path), "--json")[1])
    assert call(capsys, "ladder", str(tmp_path))[0] == 2


def test_a_wire_that_ends_nowhere_is_pointed_at(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = tmp_path / "loose.txt"
    path.write_text("--[ I0.0 ]--+--( Q0.0 )\n            |\n", encoding="utf-8")
    code, said = call(capsys, "lower", str(path))
    assert code == 1
    assert "2:13" in said
    assert "\n                ^\n" in said


def test_the_lines_that_set_up_blocks_go_with_the_ladder_and_come_back() -> None:
    listed = plc.lower(NEZA, "neza")
    assert listed == NEZA
    assert plc.compare(plc.lower(listed, "neza"), NEZA, "neza").status == "equal"
    drawing = "%TM0: TYPE=TON TB=100ms P=30\n--[ %I0.0 ]--{ IN %TM0 }\n\n--[ %TM0.Q ]--( %Q0.0 )\n"
    assert plc.lower(drawing, "neza") == NEZA
    assert plc.run(drawing, "%I0.0: 4s on", "neza").edges("%Q0.0")[1][0] in {3_000, 3_010}


def test_a_translation_and_a_listing_are_programs_and_know_their_family() -> None:
    made = plc.translate("LD I0.0; O Q0.0; = Q0.0", "fx")
    assert plc.run(made, [{"X0": 1}, {"X0": 0}])["Y0"] == "11"
    assert plc.translate(made, "s7-200").text.endswith("LD I0.0\nO Q0.0\n= Q0.0\n")
    assert plc.read(repr(made), "fx").runs
    assert plc.lift(plc.lower("--[ X0 ]--( Y0 )", "fx")).scene.title.en == "Ladder diagram: X0 -> Y0"


def test_a_comment_above_a_rung_is_its_title_and_a_style_that_is_none_is_named() -> None:
    drawing = f"// motor\n// start\n{SEAL_IN}\n// lamp\n--[ Q0.0 ]--( Q0.1 )\n"
    with speaking("en"):
        assert "// lamp" in plc.lower(drawing)
        with pytest.raises(UnknownNameError, match="relay"):
            plc.draw(SEAL_IN, style="din")
