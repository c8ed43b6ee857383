"""Texts that nobody should write, and files that are no programs: a clear finding, soon, in two languages, and never an exception.

Times are guards against hanging on slow machines, not measurements.
"""

from __future__ import annotations

import io
import json
import os
import random
import re
import subprocess
import sys
import time
from contextlib import contextmanager
from html.parser import HTMLParser
from pathlib import Path
from types import SimpleNamespace
from xml.etree import ElementTree as ET

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from plcteach.check.judge import judge, verdict_on
from plcteach.check.lint import lint
from plcteach.check.score import grade
from plcteach.cli import main
from plcteach.core.diagnostic import errors
from plcteach.core.errors import NotRepresentableError
from plcteach.core.source import decode
from plcteach.dialects import names
from plcteach.figure.film import film
from plcteach.figure.ladder import ladder_scene
from plcteach.figure.svg import svg
from plcteach.ladder.lower import lower
from plcteach.ladder.picture import read_drawing
from plcteach.ladder.telling import is_drawing
from plcteach.machine import run
from plcteach.machine.formula import spelled, written
from plcteach.machine.timeline import timeline
from plcteach.publish import player_page
from plcteach.stl import read, write
from plcteach.widgets import ExerciseDesk, Workbench

pytestmark = pytest.mark.no_cover  # many programs: measured lines would take most of the time

ROOT = Path(__file__).parents[1]
HANGS = 60.0
SCRIPT = "<script>alert(1)</script>"
DIALECTS = names()


@contextmanager
def soon(seconds: float = HANGS):
    begun = time.monotonic()
    yield
    took = time.monotonic() - begun
    assert took < seconds, f"took {took:.1f} s"


def lint_json(capsys, monkeypatch, data: bytes, dialect: str, lang: str) -> list[dict[str, object]]:
    """Lint bytes from standard input; nothing may stand on stderr."""
    monkeypatch.setattr(sys, "stdin", SimpleNamespace(buffer=io.BytesIO(data)))
    capsys.readouterr()
    code = main(["lint", "-", "--dialect", dialect, "--json", "--lang", lang])
    shown = capsys.readouterr()
    assert shown.err == ""
    found = json.loads(shown.out)
    assert code == (1 if any(one["severity"] == "error" for one in found) else 0)
    return found


def rows(*lines: str, times: int) -> str:
    return "\n".join(lines * times) + "\n"


LONG = {
    "a 10 MB line": ("s7-200 neza", "LD I0.0" + "1" * 10_000_000),
    "a 10 MB line of blanks": ("s7-200", " " * 10_000_000),
    "a line just within 2 MB": ("s7-200 fx", "X" * 1_999_999),
    "100,000 lines without an end": ("s7-200 gutta", rows("LD I0.0", times=100_000)),
    "100,000 lines of rungs": ("s7-200 gutta", rows("LD I0.0", "= Q0.0", times=50_000)),
    "100,000 lines of one rung": ("fx", rows("LD X0", "AND X1", times=50_000)),
    "100,000 lines of rungs that it must find itself": ("fx", rows("LD X0", "OUT Y0", times=50_000)),
    "rungs whose reading an ANB settles at last": ("fx", rows("LD X0", "OUT Y0", times=9_000) + rows("ANB", times=900)),
    "100,000 lines of an accumulator": ("neza", rows("LD %I0.0", "ST %Q0.0", times=50_000)),
    "100,000 unknown words": ("s7-200 fx", rows("XYZZY", times=100_000)),
    "100,000 unknown words, each another": ("s7-200 neza", "\n".join(f"LDX{number}" for number in range(100_000))),
    "good and bad lines in turn": ("fx s7-200", rows("LD X0", "OUT Y0", "OUR Y0", times=30_000)),
    "good and bad rungs in turn": ("neza", rows("LD %I0.0", "ST %Q0.0", "SPQR", times=30_000)),
    "200,000 networks": ("s7-200 neza", rows("Network 1", times=200_000)),
    "good and bad networks in turn": (
        "s7-200",
        rows("Network 1", "LD I0.0", "= Q0.0", "Network 2", "AND I0.0", times=20_000),
    ),
    "many statements on each of many rows": ("s7-200", rows("a;" * 900, times=1_000)),
    "many instructions on each of many rows": ("s7-200 gutta", rows("LD I0.0;" * 240, times=1_000)),
    "many rungs on each of many rows": ("fx", rows("LD X0;OUT Y0;" * 150, times=1_000)),
    "many comments opened": ("s7-200", "(*" * 900_000),
    "many comments opened and closed": ("s7-200", rows("(**)" * 400, times=1_000)),
    "many parentheses on each of many rows": ("neza s7-200", rows(")" * 1_900, times=1_000)),
    "many slashes": ("s7-200", "/" * 1_900_000),
    "many commas": ("s7-200", rows("," * 1_900, times=1_000)),
    "many pushes": ("s7-200 gutta", rows("LPS", times=20_000)),
    "many pushes upon one load": ("fx neza", "LD X0\n" + rows("MPS", times=19_000)),
}
NOTHING_TO_SAY = {"many comments opened and closed", "many commas"}


@pytest.mark.parametrize(
    ("name", "dialect"), [(name, dialect) for name, (dialects, _) in LONG.items() for dialect in dialects.split()]
)
def test_a_text_that_is_far_too_long_is_answered_soon(name: str, dialect: str) -> None:
    with soon():
        program = read(LONG[name][1], dialect)
        found = lint(program)
    assert bool(errors(found)) != (name in NOTHING_TO_SAY)
    assert all(len(one.text.en) < 600 and len(one.text.zh) < 600 for one in found)


@pytest.mark.parametrize(
    "name", ["a 10 MB line", "100,000 lines of rungs", "100,000 unknown words", "many statements on each of many rows"]
)
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_it_is_said_that_a_text_is_too_long(capsys, monkeypatch, name: str, lang: str) -> None:
    with soon():
        found = lint_json(capsys, monkeypatch, LONG[name][1].encode(), "s7-200", lang)
    codes = {one["code"] for one in found if one["severity"] == "error"}
    assert codes & ({"RDR013"} if "rungs" in name or "10 MB" in name else {"RDR013", "RDR016"})
    assert len(found) < 1_000


def test_many_remarks_are_no_error(capsys, monkeypatch) -> None:
    text = "".join(f"LD I0.0\nLD I0.1\nOLD\n= V{number // 8}.{number % 8}\n" for number in range(400))
    assert not [
        one for one in lint_json(capsys, monkeypatch, text.encode(), "s7-200", "en") if one["severity"] == "error"
    ]


def test_an_error_is_not_left_out_because_many_remarks_stand_before_it(capsys, monkeypatch) -> None:
    text = "".join(f"LD I0.0\nLD I0.1\nOLD\n= V{number // 8}.{number % 8}\n" for number in range(400)) + "ADN I0.0\n"
    assert "RDR001" in {one["code"] for one in lint_json(capsys, monkeypatch, text.encode(), "s7-200", "en")}


@pytest.mark.parametrize(
    "name", ["a 10 MB line", "100,000 lines of rungs", "many statements on each of many rows", "many pushes"]
)
def test_a_text_that_is_far_too_long_is_graded_soon(name: str) -> None:
    with soon():
        marks = grade("s7-two-blocks", LONG[name][1])
    assert float(marks) == 0.0


def test_a_right_program_of_too_many_instructions_is_not_compared_for_ever() -> None:
    text = "".join(
        f"LD I0.0\nA I0.1\nLD I0.2\nAN I0.3\nOLD\n= V{number // 8}.{number % 8}\n" for number in range(3_000)
    )
    with soon():
        assert judge("s7-two-blocks", text + "= Q0.0\n").verdict.status in {"unknown", "equal"}


NUL = {
    "one NUL": "LD I0.0\x00\n= Q0.0\n",
    "a megabyte of NUL": "\x00" * 1_000_000,
    "NUL between letters": "L\x00D\x00 \x00I\x000\x00.\x000\x00",
    "escape sequences": "\x1b[31mLD I0.0\x1b[0m\n\x07= Q0.0\n",
    "backspaces": "LD I0.0\x08\x08\x081.0\n",
}


@pytest.mark.parametrize("name", NUL)
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_control_characters_are_named_and_not_repeated(capsys, monkeypatch, name: str, lang: str) -> None:
    with soon():
        found = lint_json(capsys, monkeypatch, NUL[name].encode(), "s7-200", lang)
    assert "RDR014" in {one["code"] for one in found}
    assert not any(ord(sign) < 32 for one in found for sign in str(one["text"]) if sign != "\n")


def test_for_people_control_characters_do_not_reach_the_terminal(capsys, monkeypatch) -> None:
    monkeypatch.setattr(sys, "stdin", SimpleNamespace(buffer=io.BytesIO(NUL["escape sequences"].encode())))
    assert main(["lint", "-", "--dialect", "s7-200"]) == 1
    shown = capsys.readouterr()
    assert "\x1b" not in shown.out
    assert "\x07" not in shown.out


# Parentheses and depth


def lowered(ladder, dialect: str) -> str:
    """Give the list, or the reason why there is none; any other exception is a fault."""
    try:
        return lower(ladder, dialect)
    except NotRepresentableError as refused:
        return refused.reason.zh and refused.reason.en


@pytest.mark.parametrize("opener", ["AND( %I0.0", "OR(", "AND(N %M0"])
def test_ten_thousand_parentheses_in_a_list(opener: str) -> None:
    text = "LD %I0.0\n" + f"{opener}\n" * 10_000 + ")\n" * 10_000 + "ST %Q0.0\n"
    with soon():
        program = read(text, "neza")
        found = lint(program)
    assert errors(found)
    with soon():
        assert read(write(program), "neza") == program


def test_ten_thousand_parentheses_that_never_close() -> None:
    with soon():
        found = lint(read("LD %I0.0\n" + "AND( %I0.1\n" * 10_000, "neza"))
    assert "RDR011" in {one.code for one in found}


@pytest.mark.parametrize(
    "line",
    [
        "(" * 10_000 + "I0.0" + ")" * 10_000 + " -> Q0.0",
        "(" * 150 + "I0.0" + ")" * 150 + " -> Q0.0",
        "I0.0 -> " + "(I0.1 -> " * 50 + "Q0.0" + ")" * 50,
        "/" * 10_000 + "I0.0 -> Q0.0",
        "/(" * 200 + "I0.0" + ")" * 200 + " -> Q0.0",
        "I0.0 + " * 10_000 + "I0.1 -> Q0.0",
        "(" * 10_000,
        "->" * 10_000,
        "[" * 10_000,
    ],
)
@pytest.mark.parametrize("dashes", ["", "--[ I0.0 ]--"])
def test_ten_thousand_parentheses_in_a_drawing(line: str, dashes: str) -> None:
    with soon():
        is_drawing(dashes + line)
        ladder, found = read_drawing(dashes + line)
    assert found
    assert not ladder.rungs


def test_a_drawing_that_is_deep_but_read_can_be_lowered_or_is_refused_in_words() -> None:
    deep = "I0.0"
    for number in range(19):
        deep = f"({deep} · I0.{number % 8} + I1.{number % 8})"
    ladder, found = read_drawing(f"{deep} -> Q0.0")
    assert not found
    for dialect in DIALECTS:
        with soon():
            assert lowered(ladder, dialect)


# Addresses

DIGITS = "1" * 1_000_000


@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize("area", ["I0.", "I", "X", "%M", "%I0.", "M", "T", "", "Q0.0, "])
@pytest.mark.parametrize(
    "digits", [DIGITS, "1" * 1_900, "1" * 4_999, "9" * 13, "٣" * 1_000, "²" * 1_000, "1_000", "0" * 1_900 + "1"]
)
def test_an_address_of_a_million_digits(dialect: str, area: str, digits: str) -> None:
    with soon():
        for mnemonic in ("LD", "S", "OUT", "LDS", "NOP"):
            found = lint(read(f"{mnemonic} {area}{digits}\n", dialect))
            assert all(len(one.text.en) < 600 for one in found)


def test_a_million_digits_everywhere_else(tmp_path, capsys) -> None:
    with soon():
        read_drawing(f"--[ I0.{DIGITS} ]--( Q0.0 )")
        read_drawing(f"I0.{'1' * 400} -> Q0.0")
        read_drawing(f"--[ I0.0 ]--(S Q0.0 {'9' * 400} )")
        read(f"Network {'1' * 1_000}\nLD I0.0\n", "s7-200")
    (tmp_path / "p.stl").write_text("LD I0.0\n= Q0.0\n", encoding="utf-8")
    for scans in ([{f"I0.{DIGITS}": 1}], [{"I0.0": int("1" * 4_000)}], f'[{{"ms": {DIGITS}}}]'):
        text = scans if isinstance(scans, str) else json.dumps(scans)
        (tmp_path / "s.json").write_text(text, encoding="utf-8")
        with soon():
            code = main(
                ["run", str(tmp_path / "p.stl"), "--inputs", str(tmp_path / "s.json"), "--watch", "Q0.0", "--json"]
            )
        shown = capsys.readouterr()
        assert code in {0, 2}
        assert len(shown.err) < 1_000


# Markup


class Page(HTMLParser):
    """The elements of a page and what its scripts hold."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.scripts: list[str] = []
        self.handlers: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag, attrs) -> None:
        self.tags.append(tag)
        self.handlers += [name for name, _ in attrs if name.startswith("on")]
        if tag == "script":
            self.scripts.append("")

    def handle_data(self, data) -> None:
        if self.scripts and self.tags[-1] == "script":
            self.scripts[-1] += data


MARKED = f"Network 1 // {SCRIPT}<!--\nLD I0.0 // {SCRIPT} </script> ]]> <img src=x onerror=alert(1)>\n= Q0.0 (* <!-- --> {SCRIPT} *)\n"


def test_markup_in_a_comment_stays_text_in_lint(capsys, monkeypatch) -> None:
    assert lint_json(capsys, monkeypatch, MARKED.encode(), "s7-200", "en") == []
    (one,) = lint_json(capsys, monkeypatch, f"{SCRIPT}\n".encode(), "s7-200", "zh")
    assert "script" in str(one["text"])


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_markup_in_a_comment_stays_text_in_the_players_page(lang: str) -> None:
    shot = film(run(read(MARKED, "s7-200"), [{"I0.0": 1}]).scans)
    text = player_page(shot, lang)
    page = Page(text)
    assert page.tags.count("script") == 2
    assert "img" not in page.tags
    assert not page.handlers
    assert "<!--" not in text
    kept = json.loads(page.scripts[0])
    assert SCRIPT in json.dumps(kept)
    assert kept == shot.data


def test_markup_in_a_file_name_stays_text_in_the_players_page(tmp_path, capsys) -> None:
    path = tmp_path / "<script>alert(1)<&script>.stl"
    path.write_text("LD I0.0\n= Q0.0\n", encoding="utf-8")
    assert main(["play", str(path), "--dialect", "s7-200", "-o", str(tmp_path / "page.html")]) == 0
    assert capsys.readouterr().err == ""
    assert Page((tmp_path / "page.html").read_text(encoding="utf-8")).tags.count("script") == 2


@pytest.mark.parametrize("source", [MARKED, f"{SCRIPT}\n", f"LD {SCRIPT}\n= Q0.0", f"LD I0.0 {SCRIPT}\n= Q0.0"])
def test_markup_stays_text_in_what_a_saved_notebook_shows(source: str) -> None:
    bench, desk = Workbench(source, "s7-200"), ExerciseDesk("s7-two-blocks", source)
    desk.check()
    marks = grade("s7-two-blocks", source)
    for shown in (still_of(bench), still_of(desk), marks._repr_html_()):
        assert SCRIPT not in shown
        page = Page(shown)
        assert "script" not in page.tags
        assert not page.handlers
    for name, trait in (("report", bench.report), ("report", desk.report), ("verdict", desk.verdict)):
        assert json.loads(trait), name


def still_of(widget) -> str:
    bundle = widget._repr_mimebundle_()
    data = bundle[0] if isinstance(bundle, tuple) else bundle
    return data["text/html"]


def test_markup_in_a_drawing_stays_text_in_its_figure() -> None:
    ladder, found = read_drawing(f"Network 1 // {SCRIPT} & ]]>\n--[ I0.0 ]--( Q0.0 )\n")
    assert not found
    for lang in ("en", "zh"):
        text = svg(ladder_scene(ladder), lang)
        assert SCRIPT not in text
        assert not [one for one in ET.fromstring(text).iter() if one.tag.endswith("script")]  # noqa: S314  (our own output)


FILES = {
    "NULs": b"\x00" * 1_000,
    "half a mark": b"\xff\xfe\x00",
    "noise": random.Random(200).randbytes(4_000),
    "an archive": b"PK\x03\x04" + bytes(range(256)),
    "nothing": b"",
}


@pytest.mark.parametrize("name", FILES)
def test_any_file_can_be_opened_in_the_workbench(name: str) -> None:
    bench = Workbench("LD I0.0\n= Q0.0", "s7-200")
    bench._asked(bench, {"type": "open", "name": SCRIPT}, [FILES[name]])
    assert isinstance(json.loads(bench.report)["diagnostics"], list)
    assert SCRIPT not in still_of(bench)


# Formulas that grow


def test_a_formula_of_2_to_the_40_signs_is_played_at_once() -> None:
    text = "LD I0.0\n" + "LPS\nOLD\n" * 40 + "= Q0.0\n"
    with soon():
        program = read(text, "s7-200")
        assert run(program, [{"I0.0": 1}])["Q0.0"] == "1"
        assert all(len(written(cell)) < 20_000 for step in spelled(program) for cell in step.after[0])
        page = player_page(film(run(program, [{"I0.0": 1}]).scans))
    assert len(page) < 3_000_000


def test_a_long_right_program_is_played_or_refused_soon(capsys, tmp_path) -> None:
    path = tmp_path / "long.stl"
    path.write_text(rows("LD I0.0", "A I0.1", "= Q0.0", times=1_500), encoding="utf-8")
    with soon(4 * HANGS):
        code = main(["play", str(path), "--dialect", "s7-200", "-o", str(tmp_path / "page.html")])
    assert code in {0, 1}
    assert capsys.readouterr().err == ""


# Words, blocks, time, and loops that do not end

EXPRESSIONS = {
    "10,000 brackets": "[" * 10_000,
    "10,000 brackets that close": "LD " + "[" * 10_000 + "%MW0 > 1" + "]" * 10_000,
    "10,000 rows of brackets": "[\n" * 10_000,
    "10,000 parentheses in a bracket": "[ %MW0 := " + "(" * 10_000 + "%MW1" + ")" * 10_000 + " ]",
    "900 parentheses in a bracket": "[ %MW0 := " + "(" * 900 + "%MW1" + ")" * 900 + " ]",
    "an expression of 2,000 characters": "[ %MW0 := %MW1" + " + %MW1" * 280 + " ]",
    "an expression of 100,000 characters": "[ %MW0 := %MW1" + " * 2" * 25_000 + " ]",
}


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_an_expression_that_nobody_should_write_is_answered_soon_and_in_its_place(name: str) -> None:
    text = f"LD %I0.0\n{EXPRESSIONS[name]}"
    with soon(10):
        found = [one for one in lint(read(text, "neza")) if one.severity == "error"]
    assert {"EXP001"} <= {one.code for one in found}
    assert all(one.span.row >= 2 and one.text.en and one.text.zh for one in found)


@pytest.mark.parametrize(
    "row", ["999999999 x (1ms on, 1ms off)", "999999999s on, off", "999 x (" * 1_000 + "1ms on" + ")" * 1_000, "9" * 5_000 + "s on"]
)  # fmt: skip
def test_a_timeline_that_nobody_should_write_is_answered_soon(row: str, tmp_path, capsys) -> None:
    with soon(10):
        found = timeline(f"I0.0: {row}", "s7-200").diagnostics
    assert found
    assert all(one.code.startswith(("TIM", "RDR")) and one.span.row == 1 for one in found)
    path = tmp_path / "p.stl"
    path.write_text("LD I0.0\n= Q0.0\n", encoding="utf-8")
    with soon(10):
        assert main(["run", str(path), "--inputs", f"I0.0: {row}"]) in {1, 2}
    assert "Traceback" not in capsys.readouterr().err


TIMERS = {
    "s7-200": "".join(f"LD I0.0\nTON T{37 + at % 27}, {at % 100}\n" for at in range(10_000)),
    "fx": "".join(f"LD X0\nOUT T{at % 200} K{at % 100 + 1}\n" for at in range(9_900)),
    "neza": "".join(f"LD %I0.0\nIN %TM{at % 32}\n" for at in range(10_000)),
}


@pytest.mark.parametrize("dialect", TIMERS)
def test_20_000_lines_of_timers_are_read_and_run_soon(dialect: str) -> None:
    with soon():
        program = read(TIMERS[dialect], dialect)
        assert not [one for one in lint(program) if one.severity == "error"]
        assert len(run(program, 3).scans) == 3


def test_20_000_configuration_lines_are_answered_soon() -> None:
    with soon():
        found = lint(
            read("".join(f"%TM{at % 32}: P={at % 100}\n" for at in range(20_000)) + "LD %I0.0\nIN %TM0", "neza")
        )
    assert {"CFG005"} <= {one.code for one in found}


@pytest.mark.parametrize(
    ("text", "row", "code"),
    [
        ("%DR0: OUT=%Q0.0 STEPS=" + ",".join("1" * 255), 1, "CFG002"),
        ("%DR0: OUT=%Q0.0,%Q0.1 STEPS=" + "1" * 255, 1, "CFG002"),
        ("%DR0: OUT=" + ",".join(f"%Q{at // 32 % 8}.{at % 32}" for at in range(255)) + " STEPS=" + "1" * 255, 1, "CFG002"),
        ("%DR0: OUT=%Q0.0 STEPS=" + ",".join("1" * 100_000), 1, "RDR013"),
    ],
)  # fmt: skip
def test_a_drum_that_is_far_too_large_is_answered_soon(text: str, row: int, code: str) -> None:
    with soon(10):
        found = lint(read(f"{text}\nLD %I0.0\nU %DR0", "neza"))
    assert (code, row) in {(one.code, one.span.row) for one in found}


NESTED = "; ".join(f"LD SM0.0; FOR VW{word}, 1, 32767" for word in (0, 2, 4)) + "; NEXT; NEXT; NEXT"
RUNAWAY = {
    "a jump backwards": ("s7-200", "LBL 1; LD SM0.0; JMP 1", "RUN002"),
    "three loops": ("s7-200", NESTED, "RUN002"),
    "a jump without a condition": ("neza", "%L1:; JMP %L1", "RUN002"),
    "a jump with one": ("neza", "%L1:; LD 1; JMPC %L1", "RUN002"),
    "a routine that calls itself twice": (
        "s7-200",
        "LD SM0.0; CALL SBR0\nSUBROUTINE_BLOCK SBR_0:SBR0\nLD SM0.0; CALL SBR0; LD SM0.0; CALL SBR0\nEND_SUBROUTINE_BLOCK",
        "RUN003",
    ),
    "two routines that call each other": (
        "neza",
        "LD 1; SR0; END; SR0:; LD 1; SR1; LD 1; SR1; RET; SR1:; LD 1; SR0; LD 1; SR0; RET",
        "RUN003",
    ),
}


@pytest.mark.parametrize("name", RUNAWAY)
def test_a_program_that_runs_away_is_stopped_and_told_where(name: str) -> None:
    dialect, text, code = RUNAWAY[name]
    program = read(text, dialect)
    with soon(20):
        trace = run(program, 3)
    assert {one.code for one in trace.diagnostics} == {code}
    rows = text.split("\n")
    for one in trace.diagnostics:
        assert rows[one.span.row - 1][one.span.start : one.span.stop].split()[0] in {
            "JMP",
            "JMPC",
            "NEXT",
            "CALL",
            "SR0",
            "SR1",
        }
    assert len(trace.starts) == (1 if code == "RUN002" else 3)


@pytest.mark.parametrize("name", RUNAWAY)
def test_a_program_that_runs_away_is_played_for_a_while(name: str) -> None:
    dialect, text, code = RUNAWAY[name]
    with soon(30):
        shot = film(run(read(text, dialect), 1).scans)
        bench = Workbench(text, dialect)
    assert shot.length <= 2_000
    assert ("the beginning only" in shot.data["title"]["en"]) == (code == "RUN002")
    assert code in {one["code"] for one in json.loads(bench.report)["diagnostics"]}


@pytest.mark.parametrize("name", RUNAWAY)
def test_a_program_that_runs_away_is_judged_soon(name: str) -> None:
    dialect, text, _ = RUNAWAY[name]
    output = "LD I0.0; = Q0.0" if dialect == "s7-200" else "LD %I0.0; ST %Q0.0"
    with soon(2 * HANGS):
        verdict = verdict_on(read(output, dialect), read(f"{output}; {text}", dialect))
    code = RUNAWAY[name][2]
    assert code in {one.code for one in verdict.diagnostics}
    assert verdict.status == ("error" if code == "RUN002" else "unknown")  # it loops no more than others, and is tried


# Encodings

SPOKEN = "Network 1 // 电动机 启动\nLD I0.0 // 启动按钮\n= Q0.0 // 接触器\n"


@pytest.mark.parametrize("dialect", ["s7-200", "gutta"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le-bom", "utf-16-be-bom", "gbk"])
def test_bytes_in_the_usual_encodings_are_read(dialect: str, encoding: str) -> None:
    data = {
        "utf-16-le-bom": b"\xff\xfe" + SPOKEN.encode("utf-16-le"),
        "utf-16-be-bom": b"\xfe\xff" + SPOKEN.encode("utf-16-be"),
    }.get(encoding) or SPOKEN.encode(encoding)
    program = read(data, dialect)
    assert program == read(SPOKEN, dialect)
    assert [line.comment for line in program.lines] == ["启动按钮", "接触器"]
    assert program.networks[0].title == "电动机 启动"


def test_western_bytes_are_read_and_german_words_survive() -> None:
    text = "LD E0.0 // läuft für\n= A0.0 // Schütz ä\n"
    program = read(text.encode("cp1252"), "s7-200")
    assert [line.text for line in program.lines] == ["LD I0.0", "= Q0.0"]
    assert not program.diagnostics
    assert read(text.encode("cp1252"), "s7-200", encoding="cp1252").lines[1].comment == "Schütz ä"


BYTES = {
    "UTF-16 without its mark": SPOKEN.encode("utf-16-le"),
    "half of a UTF-16 pair": b"\xff\xfe" + SPOKEN.encode("utf-16-le") + b"\x00",
    "a lone surrogate": b"\xff\xfe" + b"\x00\xd8" + "LD I0.0".encode("utf-16-le"),
    "half of a GBK sign": SPOKEN.encode("gbk") + b"\x81",
    "UTF-8 cut short": SPOKEN.encode()[:-2] + b"\xe5\x90",
    "a program of the machine": Path(sys.executable).read_bytes()[:200_000],
    "all bytes": bytes(range(256)) * 100,
    "big5": SPOKEN.replace("动", "動")
    .replace("启", "啟")
    .replace("机", "機")
    .replace("电", "電")
    .replace("钮", "鈕")
    .replace("触", "觸")
    .encode("big5"),
}


@pytest.mark.parametrize("name", BYTES)
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_other_bytes_are_answered_and_nothing_stands_on_stderr(capsys, monkeypatch, name: str, lang: str) -> None:
    with soon():
        found = lint_json(capsys, monkeypatch, BYTES[name], "s7-200", lang)
    if name in {"UTF-16 without its mark", "a program of the machine", "all bytes"}:
        assert any(one["severity"] == "error" for one in found)


def test_a_program_of_its_own_with_every_warning_an_error() -> None:
    for data in (BYTES["all bytes"], NUL["a megabyte of NUL"].encode(), b"LD I0." + DIGITS.encode()):
        done = subprocess.run(
            [
                sys.executable,
                "-W",
                "error",
                "-c",
                "from plcteach.cli import script; script()",
                "lint",
                "-",
                "--json",
                "--lang",
                "zh",
            ],
            cwd=ROOT,
            input=data,
            capture_output=True,
            timeout=60,
            check=False,
            env={**os.environ, "PYTHONIOENCODING": "utf-8"},
        )
        assert (done.returncode, done.stderr) == (1, b"")
        assert json.loads(done.stdout)


@pytest.mark.skipif(sys.platform == "win32", reason="file names are text there")
def test_a_folder_with_a_file_name_that_is_no_text(tmp_path) -> None:
    (Path(os.fsdecode(os.fsencode(tmp_path) + b"/\xff\xfe.stl"))).write_text("LD I0.0\n= Q0.0\n", encoding="utf-8")
    for more in (["--json"], []):
        done = subprocess.run(
            [sys.executable, "-c", "from plcteach.cli import script; script()", "lint", str(tmp_path), *more],
            cwd=ROOT,
            capture_output=True,
            timeout=60,
            check=False,
        )
        assert (done.returncode, done.stderr) == (0, b"")


# Garbage of every kind

PIECES = {
    "s7-200": [
        "LD",
        "LDN",
        "A",
        "AN",
        "O",
        "ON",
        "=",
        "S",
        "R",
        "NOT",
        "EU",
        "ED",
        "ALD",
        "OLD",
        "LPS",
        "LRD",
        "LPP",
        "LDS",
        "NOP",
        "LDI",
        "=I",
        "U",
        "ULD",
        "TON",
        "TOF",
        "CTU",
        "MOVW",
        "+I",
        "/D",
        "INCB",
        "LDW>=",
        "AB<>",
        "SHRB",
        "JMP",
        "LBL",
        "FOR",
        "NEXT",
        "CALL",
        "LSCR",
        "SCRE",
        "AENO",
    ],
    "fx": [
        "LD",
        "LDI",
        "AND",
        "ANI",
        "OR",
        "ORB",
        "ANB",
        "MPS",
        "MRD",
        "MPP",
        "OUT",
        "SET",
        "RST",
        "PLS",
        "INV",
        "LDP",
        "MEP",
        "END",
        "NOP",
        "MC",
        "MCR",
        "STL",
        "RET",
        "DMOVP",
        "ADD",
        "LD>=",
        "ZRST",
        "SFTL",
    ],
    "neza": [
        "LD",
        "LDN",
        "LDR",
        "AND",
        "AND(",
        "OR(",
        "AND(N",
        "OR(R",
        ")",
        "N",
        "XOR",
        "MPS",
        "MRD",
        "MPP",
        "ST",
        "STN",
        "S",
        "R",
        "END",
        "BLK",
        "OUT_BLK",
        "END_BLK",
        "IN",
        "CU",
        "U",
        "JMPC",
        "SR1",
        "%L1:",
        "SR1:",
        "RET",
        "[",
        "%TM0:",
        "%DR0:",
    ],
    "gutta": [
        "LD",
        "LDN",
        "A",
        "O",
        "NOT",
        "P",
        "N",
        "ALD",
        "OLD",
        "LPS",
        "LRD",
        "LPP",
        "=",
        "S",
        "R",
        "TON",
        "CTUD",
        "MOVW",
        "+I",
        "ADD_I",
        "LDW<",
        "OB=",
    ],
}
OPERANDS = {
    "s7-200": [
        "I0.0",
        "i0.1",
        "Q0.0",
        "M0.0",
        "E0.0",
        "A0.0",
        "T37",
        "I0.8",
        "3",
        "9",
        "1",
        "1, 2",
        "T37, 5",
        "VW0, VW2",
        "VD0",
        "16#FF, AC0",
        "VW0, 1, 5",
        "C0, 3",
        "I0.1, V0.0, -4",
        "SBR0",
        "S0.1",
    ],
    "fx": [
        "X0",
        "X010",
        "x7",
        "X8",
        "Y0",
        "M0",
        "M8000",
        "T0",
        "K10",
        "T0 K10",
        "C0 K5",
        "K4X0 D0",
        "N0 M100",
        "D0 K5 D10",
        "S20",
        "X1 M0 K8 K1",
        "M0 M7",
    ],
    "neza": [
        "%I0.0",
        "%I0.1",
        "%Q0.0",
        "%M0",
        "0",
        "1",
        "%S13",
        "I0.0",
        "%M0)",
        "%TM0",
        "%C0.D",
        "[%MW0 > 5]",
        "%MW0 := %MW1 + 5 ]",
        "%L1",
        "TYPE=TON P=5",
        "OUT=%Q0.0 STEPS=0,1",
        "%SBR0.3",
    ],
    "gutta": ["I0.0", "Q0.0", "M0.0", "SM0.0", "Q0.0, 2", "M0.1", "T37, 5", "C0, 3", "MW0, MW4", "1000, MW4, MW4"],
}
LAYOUT = [
    "\n", "\n", "\n", "; ", " ", "\t", "\r\n", "\r", " // ", "//", "(*", "*)", ";", "；", "／／", "（＊", "\nNetwork 1\n", "\nNETWORK 2 // title\n",
    "\nRUNG 0 (* x *)\n", "\n网络 1：启动\n", "\nNetwork 1 (* /x *)\n", "\nNetwork 3 (* (* y *) *)\n", "\nNetwork // : z\n", "\nBEGIN\n", "\nTITLE=a\n",
    "\nVAR\n", "\nEND_VAR\n", "\n### BEGIN SOLUTION\n", "0 ", "12: ", "　", "，", "\x00", "\x0b", "\x0c", "\x85", "\u2028", "\ufeff", "😀", "/", ":",
]  # fmt: skip


def texts(dialect: str) -> st.SearchStrategy[str]:
    family = dialect.removesuffix("-smart")
    known = st.builds("{} {}".format, st.sampled_from(PIECES[family]), st.sampled_from(["", *OPERANDS[family]]))
    part = (
        known
        | known
        | st.sampled_from(LAYOUT)
        | st.sampled_from(PIECES[family] + OPERANDS[family])
        | st.text(max_size=6)
    )
    lines = st.lists(known, max_size=25).map("\n".join)
    return st.text(max_size=200) | st.lists(part, max_size=40).map("".join) | lines


FUZZ = settings(
    max_examples=250, deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large]
)


@pytest.mark.parametrize("dialect", DIALECTS)
def test_garbage_is_read_and_what_was_read_is_written_and_read_again_equal(dialect: str) -> None:
    @FUZZ
    @given(texts(dialect))
    def holds(text: str) -> None:
        program = read(text, dialect)
        assert read(write(program), dialect) == program
        given_rows = re.split(r"\r\n|\n|\r", text)
        for one in lint(program):
            assert one.text.zh
            assert one.text.en
            assert 0 <= one.span.row <= len(given_rows) + 1
            if 0 < one.span.row <= len(given_rows):
                assert 0 <= one.span.start <= one.span.stop <= len(given_rows[one.span.row - 1])

    holds()


@pytest.mark.parametrize("dialect", DIALECTS)
def test_what_has_no_error_runs_and_is_played(dialect: str) -> None:
    @FUZZ
    @given(texts(dialect))
    def holds(text: str) -> None:
        program = read(text, dialect)
        trap = errors(lint(program)) if program.dialect.traps else errors(program.diagnostics)
        if not trap and program.lines:
            ones = {address.text: 1 for address in program.addresses("input")}
            trace = run(program, [{}, ones, {}])
            assert len(trace.scans) == 3
            assert film(trace.scans[:1]).json
            if program.dialect.traps:
                assert not trace.diagnostics

    holds()


@pytest.mark.parametrize("dialect", ["s7-200", "fx", "neza", "gutta"])
def test_two_pieces_of_garbage_can_be_compared(dialect: str) -> None:
    @settings(FUZZ, max_examples=80)
    @given(texts(dialect), texts(dialect))
    def holds(one: str, other: str) -> None:
        programs = read(one, dialect), read(other, dialect)
        if all(program.lines and not errors(lint(program)) for program in programs):
            assert verdict_on(*programs).status in {"equal", "different", "unknown", "unsettled"}
            assert verdict_on(programs[0], programs[0]).status == "equal"

    holds()


@FUZZ
@given(st.binary(max_size=200))
def test_any_bytes_are_text_to_us(data: bytes) -> None:
    assert isinstance(decode(data), str)
    for dialect in ("s7-200", "neza"):
        assert read(write(read(data, dialect)), dialect) == read(data, dialect)


@FUZZ
@given(texts("s7-200"))
def test_garbage_can_be_judged(text: str) -> None:
    judgement = judge("s7-two-blocks", text)
    assert 0 <= judgement.marks <= judgement.exercise.points


SIGNS = ["--", "-", "+", "|", "[ I0.0 ]", "[/I0.1]", "[P I0.0]", "[NOT]", "( Q0.0 )", "(S Q0.0 3)", "{TON}", " ", "  ", "\n", "\n\n", "->", "→", "·", "(", ")", "/",
         "I0.0", "Q0.0", ",", "S ", "// x\n", "Network 1\n", "［", "─", "┬", "灯", "\x00", "(*", "NOT", "P "]  # fmt: skip


@FUZZ
@given(st.text(max_size=120) | st.lists(st.sampled_from(SIGNS), max_size=40).map("".join))
def test_a_garbled_drawing_is_read_and_lowered_or_refused_in_words(text: str) -> None:
    is_drawing(text)
    ladder, found = read_drawing(text)
    assert found or ladder.rungs
    for one in found:
        assert 0 <= one.span.row <= len(re.split(r"\r\n|\n|\r", text)) + 1
    if ladder.rungs:
        for dialect in DIALECTS:
            assert lowered(ladder, dialect)
