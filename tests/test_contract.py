"""CONTRACT.md's run, lint and check sentence by sentence, and what it says of the other verbs, exit codes and streams."""

from __future__ import annotations

import io
import json
import os
import re
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace
from xml.etree import ElementTree as ET

import pytest

from plcteach.cli import main
from plcteach.core import text as words

ROOT = Path(__file__).parents[1]
LANGUAGE_VARIABLES = ("PLCTEACH_LANG", "LC_ALL", "LC_MESSAGES", "LANG", "LANGUAGE")

BLOCKS = "LD I0.0\nA I0.1\nLD I0.2\nA I0.3\nOLD\n= Q0.0\n"
UNDERFLOW = "LD I0.0\nA I0.1\nLD I0.2\nA I0.3\nOLD\nOLD\n= Q0.0\n"
RESIDUE = "LD I0.0\nLD I0.1\n= Q0.0\n"
UNREADABLE = "LD I0.0\nADN I0.1\n= Q0.0\n"
HOLD = "LD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n"


@pytest.fixture(autouse=True)
def _plain_surroundings(monkeypatch):
    """Each test starts in an English environment and leaves no language behind."""
    for name in LANGUAGE_VARIABLES:
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("LANG", "C.UTF-8")
    kept = list(words._chosen)
    words._chosen.clear()
    yield
    words._chosen[:] = kept


@pytest.fixture
def call(capsys, tmp_path):
    """Call main; a value is written to a file of its own, and its name stands in its place."""

    def save(name: str, content: object) -> str:
        path = tmp_path / name
        data = content if isinstance(content, str | bytes) else json.dumps(content)
        path.write_bytes(data if isinstance(data, bytes) else data.encode())
        return str(path)

    def one(*argv: str) -> SimpleNamespace:
        capsys.readouterr()
        code = main(list(argv))
        shown = capsys.readouterr()
        return SimpleNamespace(code=code, out=shown.out, err=shown.err, json=lambda: json.loads(shown.out))

    one.save = save
    return one


def run_json(
    call, program: str | bytes, scans: object, watch: str, *more: str, dialect: str = "s7-200"
) -> SimpleNamespace:
    files = call.save("p.stl", program), call.save("scans.json", scans)
    return call("run", files[0], "--dialect", dialect, "--inputs", files[1], "--watch", watch, "--json", *more)


def lint_json(call, program: str | bytes, *more: str, dialect: str = "s7-200") -> SimpleNamespace:
    return call("lint", call.save("p.stl", program), "--dialect", dialect, "--json", *more)


def check_json(call, student: str, reference: str, *more: str, dialect: str = "s7-200") -> SimpleNamespace:
    files = call.save("student.stl", student), call.save("reference.stl", reference)
    return call("check", files[0], "--reference", files[1], "--dialect", dialect, "--json", *more)


# run


def test_run_gives_one_object_a_scan_with_the_values_after_the_outputs_are_written(call) -> None:
    done = run_json(call, HOLD, [{}, {"I0.0": 1}, {"I0.0": 0}, {"I0.1": 1}, {"I0.1": 0}], "Q0.0,I0.0")
    assert done.code == 0
    assert done.json() == [
        {"Q0.0": 0, "I0.0": 0},
        {"Q0.0": 1, "I0.0": 1},
        {"Q0.0": 1, "I0.0": 0},
        {"Q0.0": 0, "I0.0": 0},
        {"Q0.0": 0, "I0.0": 0},
    ]
    assert done.err == ""


def test_run_inputs_start_at_0_and_keep_their_value_until_they_are_named_again(call) -> None:
    done = run_json(call, BLOCKS, [{"I0.2": 1}, {"I0.3": 1}, {}, {"I0.2": 0}], "Q0.0")
    assert [row["Q0.0"] for row in done.json()] == [0, 1, 1, 0]


def test_run_keys_are_as_typed_in_watch(call) -> None:
    done = run_json(call, BLOCKS, [{"I0.0": 1, "I0.1": 1}], "q0.0,A0.0, Q0.0,e0.1")
    assert done.json() == [{"q0.0": 1, "A0.0": 1, "Q0.0": 1, "e0.1": 1}]


def test_run_addresses_in_scans_are_normalised_case_and_german_letters(call) -> None:
    done = run_json(call, BLOCKS, [{"e0.0": 1, "i0.1": 1}, {"I0.0": 0}], "Q0.0")
    assert [row["Q0.0"] for row in done.json()] == [1, 0]


def test_run_addresses_are_normalised_octal(call) -> None:
    done = run_json(call, "LD X10\nAND X7\nOUT Y10\n", [{"X010": 1, "x007": 1}], "Y010,Y10,y10", dialect="fx")
    assert done.json() == [{"Y010": 1, "Y10": 1, "y10": 1}]


def test_run_x_stands_as_the_word_x(call) -> None:
    done = run_json(call, UNDERFLOW, [{}, {"I0.0": 1, "I0.1": 1}], "Q0.0", "--anyway")
    assert (done.code, done.json(), done.err) == (0, [{"Q0.0": "x"}, {"Q0.0": 1}], "")


def test_run_scans_may_carry_their_length(call) -> None:
    done = run_json(call, HOLD, [{"ms": 0}, {"I0.0": 1, "ms": 250}, {"ms": 1}], "Q0.0", "--scan-ms", "30")
    assert (done.code, [row["Q0.0"] for row in done.json()]) == (0, [0, 1, 1])


def test_run_a_memory_bit_can_be_watched_and_an_edge_lasts_one_scan(call) -> None:
    done = run_json(call, "LD I0.0\nEU\n= M0.0\n", [{}, {"I0.0": 1}, {}], "M0.0")
    assert [row["M0.0"] for row in done.json()] == [0, 1, 0]


@pytest.mark.parametrize(
    ("program", "dialect"),
    [
        (UNDERFLOW, "s7-200"),
        (UNREADABLE, "s7-200"),
        ("LD X0\nLD X1\nOUT Y0\n", "fx"),
        ("LD I0.0\nLPP\n= Q0.0\n", "gutta"),
    ],
)
def test_run_with_an_error_prints_its_diagnostics_and_exits_1(call, program: str, dialect: str) -> None:
    done = run_json(call, program, [{}], "M0", dialect=dialect)
    assert done.code == 1
    assert set(done.json()) == {"diagnostics"}
    assert "error" in {one["severity"] for one in done.json()["diagnostics"]}
    assert done.err == ""


def test_run_a_warning_does_not_stop_a_program(call) -> None:
    done = run_json(call, RESIDUE, [{"I0.1": 1}], "Q0.0")
    assert (done.code, done.json()) == (0, [{"Q0.0": 1}])


def test_run_anyway_does_not_run_what_cannot_be_read(call) -> None:
    done = run_json(call, UNREADABLE, [{}], "Q0.0", "--anyway")
    assert (done.code, set(done.json()), done.err) == (1, {"diagnostics"}, "")


@pytest.mark.parametrize(
    ("program", "dialect"),
    [
        ("LD X0\nAND X1\nANB\nOUT Y0\n", "fx"),
        ("LD I0.0\nLPS\nALD\n= Q0.0\n", "gutta"),
        ("LD %I0.0\nMPP\nST %Q0.0\n", "neza"),
    ],
)
def test_run_anyway_stops_where_the_familys_machine_has_a_trap(call, program: str, dialect: str) -> None:
    done = run_json(call, program, [{}], "M0", "--anyway", dialect=dialect)
    assert (done.code, set(done.json()), done.err) == (1, {"diagnostics"}, "")


def test_run_without_json_prints_a_table_for_people(call) -> None:
    done = call(
        "run",
        call.save("p.stl", BLOCKS),
        "--dialect",
        "s7-200",
        "--inputs",
        call.save("s.json", [{"I0.0": 1, "I0.1": 1}]),
    )
    assert (done.code, done.err) == (0, "")
    assert [row.split() for row in done.out.splitlines()] == [["scan", "Q0.0"], ["0", "1"]]


@pytest.mark.parametrize(
    "scans",
    [
        "not json",
        "{}",
        "[1, 2]",
        '[{"I0.0": "on"}]',
        '[{"I0.0": 0.5}]',
        '[{"I0.0": null}]',
        '[{"nonsense": 1}]',
        '[{"I0.8": 1}]',
        "[" * 100_000,
        b"\xff\xfe\xff",
        b"\x80",
    ],
)
def test_run_with_a_scans_file_that_says_something_else_is_a_wrong_call(call, scans: str | bytes) -> None:
    done = run_json(call, BLOCKS, scans, "Q0.0")
    assert done.code == 2
    assert done.out == ""
    assert len(done.err.strip().splitlines()) == 1
    assert "Traceback" not in done.err


@pytest.mark.parametrize("watch", ["Q99.0", "nonsense", "Q0.0,I0.9", "Q" + "1" * 10_000])
def test_run_watching_what_the_family_does_not_have_is_a_wrong_call(call, watch: str) -> None:
    done = run_json(call, BLOCKS, [{}], watch)
    assert (done.code, done.out) == (2, "")
    assert 0 < len(done.err) < 500


# lint


def test_lint_gives_a_list_of_findings_with_just_these_keys(call) -> None:
    done = lint_json(call, UNDERFLOW)
    assert (done.code, done.err) == (1, "")
    (one,) = done.json()
    assert set(one) == {"code", "severity", "row", "start", "stop", "text", "notes"}
    assert (one["code"], one["severity"], one["row"], one["start"], one["stop"]) == ("STK001", "error", 6, 0, 3)
    assert isinstance(one["text"], str)
    assert isinstance(one["notes"], list)


def test_lint_rows_count_from_1_and_columns_from_0_in_the_text_as_given(call) -> None:
    done = lint_json(call, "// 注释 first\n\nLD I0.0\n   ADN  I0.1  // 这里\n= Q0.0\n")
    (one,) = done.json()
    assert (one["code"], one["row"], one["start"], one["stop"]) == ("RDR001", 4, 3, 6)


def test_lint_columns_count_code_points_of_full_width_text(call) -> None:
    (one,) = lint_json(call, "ＬＤ　Ｉ０．０\n😀　ＡＤＮ\n＝　Ｑ０．０\n").json()
    assert (one["row"], one["start"]) == (2, 0)


def test_lint_residue_stands_at_the_networks_last_line(call) -> None:
    done = lint_json(call, "Network 1 // 启动\nLD I0.0\nLD I0.1\n= Q0.0\n\nNetwork 2\nLD I0.2\n= Q0.1\n")
    (one,) = done.json()
    assert (one["code"], one["severity"], one["row"]) == ("STK005", "warning", 4)


def test_lint_residue_stands_at_the_rungs_last_line_where_there_are_no_headings(call) -> None:
    done = lint_json(call, "LD %I0.0\nMPS\nAND %I0.1\nST %Q0.0\n", dialect="neza")
    (one,) = done.json()
    assert (one["severity"], one["row"]) == ("error", 4)


@pytest.mark.parametrize(
    ("program", "dialect", "code"),
    [
        (BLOCKS, "s7-200", 0),
        (RESIDUE, "s7-200", 0),
        ("LD I0.0\nLD I0.1\nOLD\n= Q0.0\n", "s7-200", 0),
        (UNDERFLOW, "s7-200", 1),
        ("LD X0\nLD X1\nOUT Y0\n", "fx", 1),
        (UNREADABLE, "s7-200", 1),
    ],
)
def test_lint_exits_1_on_errors_only(call, program: str, dialect: str, code: int) -> None:
    assert lint_json(call, program, dialect=dialect).code == code


def test_lint_of_a_right_program_is_an_empty_list(call) -> None:
    assert lint_json(call, BLOCKS).json() == []


def test_lint_of_a_folder_gives_a_list_for_each_path(call, tmp_path) -> None:
    folder = tmp_path / "class"
    (folder / "李雷").mkdir(parents=True)
    (folder / "right.stl").write_text(BLOCKS, encoding="utf-8")
    (folder / "李雷" / "wrong.stl").write_text(UNDERFLOW, encoding="utf-8")
    (folder / "李雷" / "warned.stl").write_text(RESIDUE, encoding="utf-8")
    done = call("lint", str(folder), "--dialect", "s7-200", "--json")
    assert (done.code, done.err) == (1, "")
    found = {Path(name).name: [one["code"] for one in each] for name, each in done.json().items()}
    assert found == {"right.stl": [], "wrong.stl": ["STK001"], "warned.stl": ["STK005"]}


def test_lint_of_a_folder_without_errors_exits_0(call, tmp_path) -> None:
    folder = tmp_path / "class"
    folder.mkdir()
    (folder / "warned.stl").write_text(RESIDUE, encoding="utf-8")
    assert call("lint", str(folder), "--dialect", "s7-200", "--json").code == 0
    (folder / "warned.stl").unlink()
    empty = call("lint", str(folder), "--dialect", "s7-200", "--json")
    assert (empty.code, empty.json()) == (0, {})


@pytest.fixture
def folder(tmp_path) -> Path:
    """A teacher's folder: programs of several kinds, a symbol table, and files that are none."""
    path = tmp_path / "class"
    (path / "李雷").mkdir(parents=True)
    (path / ".git").mkdir()
    for name, data in {
        "a right.awl": b"ORGANIZATION_BLOCK MAIN:OB1\r\nBEGIN\r\nNetwork 1\r\nLD I0.0\r\n= Q0.0\r\nEND_ORGANIZATION_BLOCK\r\n",
        "b fx.csv": '"MAIN"\n"0"\t""\t"LD"\t"X0"\n"1"\t""\t"ANI"\t"X1"\n"2"\t""\t"OUT"\t"Y0"\n'.encode("utf-16"),
        "c symbols.txt": "符号\t地址\n启动\tI0.0\n启动\tI0.1\n".encode("gbk"),
        "d project.mwp": b"MWP\x00\x01\x02" * 100,
        "e drawing.txt": "NOT·I0.0 -> Q0.0".encode(),
        "李雷/f.stl": UNDERFLOW.encode(),
        "李雷/g.il": RESIDUE.encode(),
        "notes.md": b"# LD",
        ".hidden.stl": b"ADN",
        ".git/h.stl": b"ADN",
    }.items():
        (path / name).write_bytes(data)
    return path


def test_lint_of_a_folder_takes_what_people_have_and_reports_what_is_no_program(call, folder) -> None:
    done = call("lint", str(folder), "--dialect", "s7-200", "--json")
    found = {name: [one["code"] for one in each] for name, each in done.json().items()}
    assert "RDR017" in found.pop("b fx.csv")
    assert found == {
        "a right.awl": [],
        "c symbols.txt": ["SYM003"],
        "d project.mwp": ["FIL002"],
        "e drawing.txt": ["FIL003"],
        "李雷/f.stl": ["STK001"],
        "李雷/g.il": ["STK005"],
    }
    assert (done.code, done.err) == (1, "")
    assert [one["code"] for one in call("lint", str(folder), "--dialect", "fx", "--json").json()["b fx.csv"]] == []


@pytest.mark.parametrize(
    ("lang", "head", "total"),
    [
        ("en", "file  reads like  errors  warnings  first finding", "7 files"),
        ("zh", "文件  读来像  错误  警告  第一条", "共7个文件"),
    ],
)
def test_lint_of_a_folder_ends_with_a_table(call, folder, lang: str, head: str, total: str) -> None:
    done = call("lint", str(folder), "--dialect", "s7-200", "--lang", lang)
    rows = done.out.splitlines()
    table = rows[-9:]
    assert table[0].split() == head.split()
    assert ("Mitsubishi FX" if lang == "en" else "三菱FX") in table[2]
    assert "6: STK001" in table[6]
    assert table[-1].startswith(total)
    assert table[-1].split()[-2:] == ["7", "1"]
    assert "== 李雷/f.stl" in rows
    assert "== a right.awl" not in rows


def test_lint_of_a_folder_without_a_differing_family_has_no_column_for_it(call, folder) -> None:
    (folder / "b fx.csv").unlink()
    head, *_, last = call("lint", str(folder), "--dialect", "s7-200").out.splitlines()[-8:]
    assert head.split() == ["file", "errors", "warnings", "first", "finding"]
    assert last.split() == ["6", "files", "4", "1"]


def test_lint_of_a_folder_reports_a_file_that_cannot_be_opened(call, folder, monkeypatch) -> None:
    opened = Path.open

    def refused(path: Path, *rest, **more):
        if path.suffix == ".awl":
            raise PermissionError(13, "Permission denied")
        return opened(path, *rest, **more)

    monkeypatch.setattr(Path, "open", refused)
    (one,) = call("lint", str(folder), "--dialect", "s7-200", "--json").json()["a right.awl"]
    assert (one["code"], one["severity"]) == ("FIL001", "error")
    assert "Permission denied" in one["text"]


def test_lint_of_a_folder_shows_its_progress_only_to_a_person(call, folder, monkeypatch) -> None:
    assert call("lint", str(folder)).err == ""
    monkeypatch.setattr(type(sys.stderr), "isatty", lambda _: True, raising=False)
    assert "/7 [" in call("lint", str(folder)).err


def test_lint_of_a_folder_of_thousands_of_files_is_done_soon(call, tmp_path) -> None:
    folder = tmp_path / "many"
    folder.mkdir()
    for number in range(4_000):
        (folder / f"{number:04}.stl").write_text(HOLD, encoding="utf-8")
    begun = time.monotonic()
    done = call("lint", str(folder), "--dialect", "s7-200")
    assert time.monotonic() - begun < 60  # a guard against hanging, no measurement
    assert (done.code, done.out.splitlines()[-1].split()) == (0, ["4000", "files", "0", "0"])


def test_lint_all_slips_are_reported_at_once(call) -> None:
    done = lint_json(call, "LD I0.8\nADN I0.1\nLPS 1\n= Q0.0\n")
    assert [(one["row"], one["code"]) for one in done.json()] == [(1, "RDR006"), (2, "RDR001"), (3, "RDR004")]


def test_lint_lds_with_a_relation_is_a_string_compare_and_refused_by_its_name(call) -> None:
    (one,) = lint_json(call, "LDS= VB0, VB10\n= Q0.0\n").json()
    assert (one["code"], one["severity"], one["row"]) == ("RDR002", "error", 1)
    assert "LDS=" in one["text"]


# check

DRAWING = "--[ I0.0 ]--[ I0.1 ]--+--( Q0.0 )\n--[ I0.2 ]--[ I0.3 ]--+\n"
CHECK_KEYS = {"status", "level", "proof", "counterexample", "outputs", "diagnostics", "explored"}
EXAMPLE_KEYS = {"inputs", "outputs", "expected", "got", "first"}


def test_check_equal(call) -> None:
    done = check_json(call, "LD I0.3\nA I0.2\nLD I0.1\nA I0.0\nOLD\n= Q0.0\n", BLOCKS)
    verdict = done.json()
    assert (done.code, done.err) == (0, "")
    assert set(verdict) == CHECK_KEYS
    assert (verdict["status"], verdict["level"], verdict["proof"]) == ("equal", "exact", "table")
    assert (verdict["counterexample"], verdict["outputs"], verdict["diagnostics"]) == (None, {"Q0.0": "equal"}, [])


def test_check_the_same_program_is_equal_by_structure(call) -> None:
    assert check_json(call, "ld i0.0; a i0.1\n  LD  I0.2; A I0.3; OLD; = Q0.0", BLOCKS).json()["proof"] == "structural"


def test_check_proof_is_null_unless_equal(call) -> None:
    assert check_json(call, "LD I0.0\n= Q0.0\n", BLOCKS).json()["proof"] is None
    assert check_json(call, UNDERFLOW, BLOCKS).json()["proof"] is None


@pytest.mark.parametrize(
    "student", ["LD I0.0\nA I0.1\nO I0.2\nA I0.3\n= Q0.0\n", "LD I0.0\nA I0.1\nLD I0.2\nA I0.3\nALD\n= Q0.0\n"]
)
def test_check_different_with_a_counterexample_that_run_replays(call, student: str) -> None:
    done = check_json(call, student, BLOCKS)
    verdict = done.json()
    assert (done.code, done.err) == (1, "")
    assert (verdict["status"], verdict["outputs"]) == ("different", {"Q0.0": "different"})
    example = verdict["counterexample"]
    assert set(example) == EXAMPLE_KEYS
    expected = run_json(call, BLOCKS, example["inputs"], "Q0.0").json()
    got = run_json(call, student, example["inputs"], "Q0.0").json()
    first = example["first"]
    assert (example["expected"], example["got"]) == (expected, got)
    assert set(first) == {"scan", "address"}
    assert expected[first["scan"]][first["address"]] != got[first["scan"]][first["address"]]
    assert all(expected[scan] == got[scan] for scan in range(first["scan"]))


def test_check_in_time_the_counterexample_replays_and_its_first_difference_is_the_first(call) -> None:
    student = HOLD.replace("AN I0.1", "A I0.1")
    example = check_json(call, student, HOLD).json()["counterexample"]
    replays = [run_json(call, program, example["inputs"], "Q0.0").json() for program in (HOLD, student)]
    assert replays == [example["expected"], example["got"]]
    differing = [scan for scan, (one, other) in enumerate(zip(*replays, strict=True)) if one != other]
    assert example["first"] == {"scan": differing[0], "address": "Q0.0"}


def test_check_set_and_reset_for_a_seal_in_is_proved_equal_over_time(call) -> None:
    done = check_json(call, "LD I0.0\nS Q0.0, 1\nLD I0.1\nR Q0.0, 1\n", HOLD)
    assert (done.code, done.json()["status"]) == (0, "equal")
    assert done.json()["proof"] in {"exhaustive", "induction"}


def test_check_set_dominant_is_not_reset_dominant(call) -> None:
    done = check_json(call, "LD I0.1\nR Q0.0, 1\nLD I0.0\nS Q0.0, 1\n", HOLD)
    example = done.json()["counterexample"]
    assert (done.code, len(example["inputs"])) == (1, 1)
    assert example["inputs"] == [{"I0.0": 1, "I0.1": 1}]
    assert (example["expected"], example["got"]) == ([{"Q0.0": 0}], [{"Q0.0": 1}])


def test_check_an_x_at_a_compared_output_is_different(call) -> None:
    student = "LD I0.0\nLD I0.1\nLRD\nLRD\nLD I0.2\nLD I0.3\nLDS 5\n= Q0.0\n"
    verdict = check_json(call, student, "LD I0.0\n= Q0.0\n").json()
    assert verdict["status"] in {"different", "error"}


@pytest.mark.parametrize("student", [UNDERFLOW, UNREADABLE, "LD I0.0\nA I0.1\n= Q0.0\nLPP\n= Q0.1\n"])
def test_check_a_reader_or_stack_error_is_the_status_error(call, student: str) -> None:
    done = check_json(call, student, BLOCKS)
    verdict = done.json()
    assert (done.code, done.err, verdict["status"], verdict["counterexample"]) == (1, "", "error", None)
    assert "error" in {one["severity"] for one in verdict["diagnostics"]}


def test_check_an_output_the_reference_does_not_write_is_a_warning_and_not_compared(call) -> None:
    done = check_json(call, BLOCKS + "= Q0.1\n", BLOCKS)
    verdict = done.json()
    assert (done.code, verdict["status"], verdict["outputs"]) == (0, "equal", {"Q0.0": "equal"})
    assert [one["severity"] for one in verdict["diagnostics"]] == ["warning"]
    assert "Q0.1" in verdict["diagnostics"][0]["text"]


def test_check_each_output_has_its_own_status(call) -> None:
    reference = "LD I0.0\n= Q0.0\nLD I0.1\n= Q0.1\n"
    verdict = check_json(call, "LD I0.0\n= Q0.0\nLDN I0.1\n= Q0.1\n", reference).json()
    assert (verdict["status"], verdict["outputs"]) == ("different", {"Q0.0": "equal", "Q0.1": "different"})


def test_check_an_output_that_is_missing_stays_0_and_differs(call) -> None:
    reference = "LD I0.0\n= Q0.0\nLD I0.1\n= Q0.1\n"
    verdict = check_json(call, "LD I0.0\n= Q0.0\n", reference).json()
    assert (verdict["status"], verdict["outputs"]["Q0.1"]) == ("different", "different")


@pytest.mark.parametrize(
    "reference",
    [
        DRAWING,
        "\n\n" + DRAWING,
        "// two blocks -- in parallel\n" + DRAWING,
        "I0.0 · I0.1 + I0.2 · I0.3 -> Q0.0\n",
        "(I0.0 * I0.1) + (I0.2 * I0.3) -> Q0.0\n",
    ],
)
def test_check_a_reference_may_be_a_ladder_drawing(call, reference: str) -> None:
    done = check_json(call, BLOCKS, reference)
    assert (done.code, done.json()["status"], done.err) == (0, "equal", "")


def test_check_dashes_in_a_comment_make_no_drawing(call) -> None:
    done = check_json(call, BLOCKS, "LD I0.0 // -- first block -> here\n" + BLOCKS.partition("\n")[2])
    assert (done.code, done.json()["status"]) == (0, "equal")


@pytest.mark.parametrize(
    ("dialect", "student"),
    [("fx", "LD X0\nOR Y0\nANI X1\nOUT Y0\n"), ("neza", "LD %I0.0\nOR %Q0.0\nANDN %I0.1\nST %Q0.0\n")],
)
def test_check_a_drawing_is_lowered_to_the_dialect_asked_for(call, dialect: str, student: str) -> None:
    a, b, q = {"fx": ("X0", "X1", "Y0"), "neza": ("%I0.0", "%I0.1", "%Q0.0")}[dialect]
    done = check_json(call, student, f"({a} + {q}) · /{b} -> {q}\n", dialect=dialect)
    assert (done.code, done.json()["status"]) == (0, "equal")


@pytest.mark.parametrize("level", ["exact", "settled", "either"])
def test_check_takes_a_level(call, level: str) -> None:
    done = check_json(call, BLOCKS, BLOCKS, "--level", level)
    assert (done.code, done.json()["status"]) == (0, "equal")


ONE_SCAN_LATER = "LD M0.0\n= Q0.0\nLD I0.0\n= M0.0\n"


@pytest.mark.parametrize(
    ("level", "status"), [("exact", "different"), ("settled", "equal"), ("either", "equal"), (None, "equal")]
)
def test_check_settled_accepts_rungs_in_another_order_and_exact_does_not(call, level: str | None, status: str) -> None:
    reference = "LD I0.0\n= M0.0\nLD M0.0\n= Q0.0\n"
    verdict = check_json(call, ONE_SCAN_LATER, reference, *(["--level", level] if level else [])).json()
    assert (verdict["status"], verdict["level"]) == (status, "exact" if level == "exact" else "settled")


def test_check_another_level_is_a_wrong_call(call) -> None:
    assert check_json(call, BLOCKS, BLOCKS, "--level", "roughly").code == 2


def test_check_takes_an_exercise(call) -> None:
    student = BLOCKS.replace("A I0.3", "AN I0.3")
    done = check_json(call, student, student, "--exercise", "s7-two-blocks")
    assert (done.code, done.json()["status"]) == (0, "equal")
    assert check_json(call, student, student, "--exercise", "no-such-task").code == 2


@pytest.mark.parametrize("reference", ["", UNDERFLOW, UNREADABLE, "--[ I0.0 ]--\n"])
def test_check_a_reference_that_is_wrong_itself_is_a_wrong_call(call, reference: str) -> None:
    done = check_json(call, BLOCKS, reference)
    assert (done.code, done.out) == (2, "")
    assert len(done.err.strip().splitlines()) == 1


def test_check_without_a_reference_is_a_wrong_call(call) -> None:
    assert call("check", call.save("p.stl", BLOCKS), "--dialect", "s7-200").code == 2


# standard input, encodings, languages, exit codes


def at_stdin(monkeypatch, data: bytes) -> None:
    monkeypatch.setattr(sys, "stdin", SimpleNamespace(buffer=io.BytesIO(data)))


def test_a_file_may_be_standard_input(call, monkeypatch) -> None:
    at_stdin(monkeypatch, BLOCKS.encode())
    scans = call.save("s.json", [{"I0.2": 1, "I0.3": 1}])
    assert call("run", "-", "--dialect", "s7-200", "--inputs", scans, "--watch", "Q0.0", "--json").json() == [
        {"Q0.0": 1}
    ]
    at_stdin(monkeypatch, UNDERFLOW.encode())
    assert [one["row"] for one in call("lint", "-", "--dialect", "s7-200", "--json").json()] == [6]
    at_stdin(monkeypatch, BLOCKS.encode())
    reference = call.save("ref.stl", DRAWING)
    assert call("check", "-", "--reference", reference, "--dialect", "s7-200", "--json").json()["status"] == "equal"
    at_stdin(monkeypatch, DRAWING.encode())
    student = call.save("mine.stl", BLOCKS)
    assert call("check", student, "--reference", "-", "--dialect", "s7-200", "--json").json()["status"] == "equal"


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "gbk", "cp1252"])
def test_a_file_comes_in_any_usual_encoding(call, encoding: str) -> None:
    comment = "schütz" if encoding == "cp1252" else "启动按钮"
    data = f"// {comment}\r\n{BLOCKS}".encode(encoding)
    assert lint_json(call, data).json() == []
    assert run_json(call, data, [{"I0.0": 1, "I0.1": 1}], "Q0.0").json() == [{"Q0.0": 1}]


@pytest.mark.parametrize("dialect", ["s7-200", "s7-200-smart", "fx", "neza", "gutta"])
def test_the_five_dialects(call, dialect: str) -> None:
    assert lint_json(call, "", dialect=dialect).json() == []


@pytest.mark.parametrize(
    "argv",
    [
        [],
        ["nonsense"],
        ["lint"],
        ["lint", "p.stl", "--dialect", "s5"],
        ["lint", "there-is-no-such-file.stl"],
        ["run", "there-is-no-such-file.stl", "--json"],
        ["lint", "-", "--lang", "fr"],
        ["figure", "NONSENSE"],
        ["figure", "LDS", "9"],
        ["explain", "NONSENSE"],
        ["explain", "STK999"],
    ],
)
def test_a_wrong_call_exits_2_and_says_so_on_stderr_only(call, argv: list[str]) -> None:
    done = call(*argv)
    assert done.code == 2
    assert "Traceback" not in done.err
    if argv:
        assert done.out == ""
        assert done.err != ""


def test_a_folder_can_only_be_linted(call, tmp_path) -> None:
    assert call("run", str(tmp_path), "--json").code == 2


@pytest.mark.parametrize(
    "argv", [["--help"], ["--version"], ["run", "--help"], ["lint", "--help"], ["check", "--help"]]
)
def test_asking_for_help_is_right(call, argv: list[str]) -> None:
    done = call(*argv)
    assert (done.code, done.err) == (0, "")
    assert done.out


def test_lang_chooses_the_language_of_all_words(call) -> None:
    english = lint_json(call, UNDERFLOW, "--lang", "en").json()[0]["text"]
    chinese = lint_json(call, UNDERFLOW, "--lang", "zh").json()[0]["text"]
    assert english.isascii()
    assert "堆栈" in chinese
    assert [one["code"] for one in lint_json(call, UNDERFLOW, "--lang", "zh").json()] == ["STK001"]


@pytest.mark.parametrize(
    ("variables", "chinese"),
    [
        ({}, False),
        ({"LANG": "zh_CN.UTF-8"}, True),
        ({"LANG": "de_DE.UTF-8"}, False),
        ({"LANG": "zh_CN.UTF-8", "LC_ALL": "C.UTF-8"}, False),
        ({"LANG": "en_US.UTF-8", "LC_ALL": "zh_TW.UTF-8"}, True),
        ({"LANG": "en_US.UTF-8", "LC_MESSAGES": "zh_CN.UTF-8"}, True),
    ],
)
def test_the_default_language_is_the_environments_else_english(
    call, monkeypatch, *, variables: dict[str, str], chinese: bool
) -> None:
    monkeypatch.delenv("LANG")
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert ("堆栈" in lint_json(call, UNDERFLOW).json()[0]["text"]) == chinese


def test_one_calls_language_is_not_the_next_ones(call) -> None:
    lint_json(call, UNDERFLOW, "--lang", "zh")
    assert lint_json(call, UNDERFLOW).json()[0]["text"].isascii()


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_for_people_the_finding_stands_under_its_row(call, lang: str) -> None:
    done = call("lint", call.save("p.stl", UNDERFLOW), "--dialect", "s7-200", "--lang", lang)
    rows = done.out.splitlines()
    assert (done.code, done.err) == (1, "")
    assert rows[0].startswith({"en": "6:1: error STK001", "zh": "6:1: 错误 STK001"}[lang])
    assert (rows[1].strip(), rows[2].strip()) == ("OLD", "^^^")


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_check_for_people_says_the_status_and_shows_the_inputs(call, lang: str) -> None:
    files = call.save("a.stl", "LD I0.0\n= Q0.0\n"), call.save("b.stl", BLOCKS)
    done = call("check", files[0], "--reference", files[1], "--dialect", "s7-200", "--lang", lang)
    assert (done.code, done.err) == (1, "")
    assert {"en": "different", "zh": "不同"}[lang] in done.out
    assert "I0.0" in done.out


@pytest.mark.parametrize(("lang", "held"), [("en", "hold"), ("zh", "保持")])
def test_check_tells_a_difference_in_time_as_a_chart_and_not_scan_by_scan(call, lang: str, held: str) -> None:
    """A timer of 4.9 s for one of 5 s: fifty scans of 100 ms are two columns, and a scan's length is no input."""
    timer = "LD I0.0\nTON T37, {}\nLD T37\n= Q0.0\n"
    files = call.save("p.stl", timer.format(49)), call.save("r.stl", timer.format(50))
    done = call("check", files[0], "--reference", files[1], "--dialect", "s7-200", "--lang", lang)
    assert (done.code, done.err) == (1, "")
    head, inputs = done.out.splitlines()[1:3]
    assert head.split()[:3] == [held, "4.9", "s"]
    assert re.fullmatch(r"I0\.0 +#+ #+", inputs)
    assert len(done.out.splitlines()) == 5


# explain, figure, play, sheet


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize(
    ("word", "dialect", "shows"),
    [
        ("OLD", "s7-200", "S2=S0|S1"),
        ("ANB", "fx", "ANB"),
        ("AND(", "neza", "AND("),
        ("P", "gutta", "P"),
        ("STK001", "s7-200", "STK001"),
    ],
)
def test_explain(call, word: str, dialect: str, shows: str, lang: str) -> None:
    done = call("explain", word, "--dialect", dialect, "--lang", lang)
    assert (done.code, done.err) == (0, "")
    assert word in done.out
    assert len(done.out.splitlines()) > 3
    if lang == "zh":
        assert any("一" <= sign <= "鿿" for sign in done.out)
    del shows


def test_explain_knows_every_code_and_every_instruction(call) -> None:
    listed = call("explain")
    assert listed.code == 0
    codes = [row.split()[0] for row in listed.out.splitlines() if row[:3].isupper()]
    assert {"STK001", "RDR001", "RUN001"} <= set(codes)
    for code in codes:
        assert call("explain", code).code == 0
    from plcteach import dialects

    for name in dialects.names():
        for mnemonic in dialects.dialect(name).words:
            done = call("explain", mnemonic, "--dialect", name)
            assert (done.code, done.err) == (0, ""), mnemonic


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_figure_writes_svg_pdf_and_png(call, tmp_path, lang: str) -> None:
    for name, starts in (("old.svg", b"<"), ("old.pdf", b"%PDF"), ("old.png", b"\x89PNG")):
        path = tmp_path / name
        done = call("figure", "OLD", "--dialect", "s7-200", "-o", str(path), "--lang", lang)
        assert (done.code, done.err) == (0, "")
        assert path.read_bytes().startswith(starts)


def test_figure_shows_the_cells_of_the_book(call) -> None:
    done = call("figure", "LDS", "3", "--dialect", "s7-200")
    assert (done.code, done.err) == (0, "")
    shown = "".join(ET.fromstring(done.out).itertext())  # noqa: S314  (our own output)
    assert "LDS 3" in shown
    assert "iv8" in shown


def test_figure_in_a_format_nobody_knows_is_a_wrong_call(call, tmp_path) -> None:
    assert call("figure", "OLD", "-o", str(tmp_path / "old.bmp")).code == 2
    assert not (tmp_path / "old.bmp").exists()


def test_figure_into_a_folder_that_is_not_there_is_a_wrong_call(call, tmp_path) -> None:
    for name in ("old.svg", "old.pdf"):
        done = call("figure", "OLD", "-o", str(tmp_path / "nowhere" / name))
        assert (done.code, done.out) == (2, "")


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_play_writes_a_page_of_its_own(call, tmp_path, lang: str) -> None:
    page = tmp_path / "player.html"
    files = call.save("p.stl", BLOCKS), call.save("s.json", [{"I0.0": 1, "I0.1": 1}])
    done = call("play", files[0], "--dialect", "s7-200", "--inputs", files[1], "-o", str(page), "--lang", lang)
    assert (done.code, done.err) == (0, "")
    text = page.read_text(encoding="utf-8")
    assert "OLD" in text
    assert "http://" not in text.replace("http://www.w3.org/", "")
    assert "https://" not in text


def test_play_of_a_wrong_program_exits_1_and_writes_nothing(call, tmp_path) -> None:
    page = tmp_path / "player.html"
    done = call("play", call.save("p.stl", UNDERFLOW), "--dialect", "s7-200", "-o", str(page))
    assert (done.code, done.err, page.exists()) == (1, "", False)


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("key", [[], ["--key"]])
def test_sheet_writes_a_pdf(call, tmp_path, key: list[str], lang: str) -> None:
    path = tmp_path / "sheet.pdf"
    done = call("sheet", call.save("p.stl", BLOCKS), "--dialect", "s7-200", "-o", str(path), "--lang", lang, *key)
    assert (done.code, done.err) == (0, "")
    assert path.read_bytes().startswith(b"%PDF")


def test_sheet_of_a_wrong_program_exits_1_and_writes_nothing(call, tmp_path) -> None:
    path = tmp_path / "sheet.pdf"
    done = call("sheet", call.save("p.stl", UNREADABLE), "--dialect", "s7-200", "-o", str(path))
    assert (done.code, done.err, path.exists()) == (1, "", False)


# as a program of its own


def program(*argv: str, given: bytes = b"", **variables: str) -> subprocess.CompletedProcess[bytes]:
    """Run the command as the shell would, with every warning an error."""
    kept = {name: value for name, value in os.environ.items() if name not in LANGUAGE_VARIABLES}
    code = "from plcteach.cli import script; script()"
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", code, *argv],
        cwd=ROOT,
        input=given,
        capture_output=True,
        env={**kept, "LANG": "C.UTF-8", **variables},
        timeout=120,
        check=False,
    )


def test_program_lint_from_standard_input() -> None:
    done = program("lint", "-", "--dialect", "s7-200", "--json", given=UNDERFLOW.encode())
    assert (done.returncode, done.stderr) == (1, b"")
    assert [one["code"] for one in json.loads(done.stdout)] == ["STK001"]


def test_program_lint_in_the_environments_language() -> None:
    done = program("lint", "-", "--json", given=UNDERFLOW.encode(), LANG="zh_CN.UTF-8")
    assert (done.returncode, done.stderr) == (1, b"")
    assert "堆栈" in json.loads(done.stdout)[0]["text"]


@pytest.mark.parametrize("encoding", ["cp1252", "ascii", "gbk", "utf-16"])
@pytest.mark.parametrize("json_too", [["--json"], []])
def test_program_speaks_chinese_also_where_the_terminal_cannot(encoding: str, json_too: list[str]) -> None:
    done = program("lint", "-", "--lang", "zh", *json_too, given=UNDERFLOW.encode(), PYTHONIOENCODING=encoding)
    assert (done.returncode, done.stderr) == (1, b"")
    if json_too:
        assert json.loads(done.stdout.decode(encoding))[0]["code"] == "STK001"


def test_program_run_and_check(tmp_path) -> None:
    (tmp_path / "s.json").write_text('[{"I0.0": 1, "I0.1": 1}]', encoding="utf-8")
    done = program("run", "-", "--inputs", str(tmp_path / "s.json"), "--watch", "q0.0", "--json", given=BLOCKS.encode())
    assert (done.returncode, json.loads(done.stdout), done.stderr) == (0, [{"q0.0": 1}], b"")
    (tmp_path / "r.stl").write_text(DRAWING, encoding="utf-8")
    done = program("check", "-", "--reference", str(tmp_path / "r.stl"), "--json", given=UNREADABLE.encode())
    assert (done.returncode, json.loads(done.stdout)["status"], done.stderr) == (1, "error", b"")


def test_program_figures_and_pages_without_a_word_on_stderr(tmp_path) -> None:
    for argv in (
        ["figure", "OLD", "-o", str(tmp_path / "old.pdf"), "--lang", "zh"],
        ["figure", "LPS", "-o", str(tmp_path / "lps.png")],
        ["sheet", "-", "-o", str(tmp_path / "sheet.pdf"), "--key", "--lang", "zh"],
        ["play", "-", "-o", str(tmp_path / "player.html")],
        ["explain", "OLD", "--lang", "zh"],
    ):
        done = program(*argv, given=BLOCKS.encode())
        assert (done.returncode, done.stderr) == (0, b""), argv


def test_program_a_wrong_call_has_no_traceback() -> None:
    done = program("lint", "no-such-file")
    assert (done.returncode, done.stdout) == (2, b"")
    assert b"Traceback" not in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_program_lint_of_a_folder_is_left_cleanly_with_ctrl_c(tmp_path) -> None:
    """At a terminal: the bar appears, Ctrl-C is pressed, and there is no traceback."""
    pty = pytest.importorskip("pty")
    for number in range(3_000):
        (tmp_path / f"{number:04}.stl").write_text(BLOCKS, encoding="utf-8")
    screen, terminal = pty.openpty()
    pytest.importorskip("termios").tcsetwinsize(terminal, (24, 80))
    code = "import signal; signal.signal(2, signal.default_int_handler); from plcteach.cli import script; script()"
    with subprocess.Popen(
        [sys.executable, "-W", "error", "-c", code, "lint", str(tmp_path)],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=terminal,
        start_new_session=True,
    ) as running:
        os.close(terminal)
        shown = os.read(screen, 1_000)
        running.send_signal(signal.SIGINT)
        with suppress(OSError):  # the terminal is closed
            while more := os.read(screen, 1_000):
                shown += more
        out = running.stdout.read()
    os.close(screen)
    assert (running.returncode, out) == (130, b"")
    assert b"/3000 [" in shown
    assert b"Traceback" not in shown


def test_program_a_closed_pipe_is_no_error() -> None:
    code = "from plcteach.cli import script; script()"
    shell = f'"{sys.executable}" -W error -c "{code}" explain | head -n 1'
    done = subprocess.run(["sh", "-c", shell], cwd=ROOT, capture_output=True, timeout=60, check=False)
    assert done.stderr == b""
