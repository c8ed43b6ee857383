"""The widgets without a browser: what the kernel answers when the page speaks, and what a saved page shows."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

import plcteach
from plcteach.core import text as words
from plcteach.figure.verbs import film_of
from plcteach.widgets import ExerciseDesk, StackPlayer, Workbench


@pytest.fixture(autouse=True)
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(words, "_chosen", ["en"])


def types(widget, source: str | None = None, **inputs: int) -> dict:
    """Do as the page does: put the text and the switches in, then count the serial up; give the answer."""
    if source is not None:
        widget.source = source
    if inputs:
        widget.inputs = json.dumps({**json.loads(widget.inputs), **{k.replace("_", "."): v for k, v in inputs.items()}})
    widget.serial += 1
    return json.loads(widget.report)


def presses(widget, button: str, buffers: list[bytes] | None = None, **content: object) -> dict:
    widget._handle_custom_msg({"type": button, **content}, buffers or [])
    return json.loads(widget.report)


def lamps(report: dict) -> dict[str, str]:
    return {lamp["address"]: lamp["value"] for lamp in report["lamps"]}


def film(widget) -> dict:
    return json.loads(widget.film)


SEAL_IN = "LD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n"


# The bench.


def test_a_bench_runs_one_scan_when_it_opens() -> None:
    bench = Workbench(SEAL_IN, "s7-200", {"I0.0": 1})
    report = json.loads(bench.report)
    assert report["switches"] == [{"address": "I0.0", "value": 1}, {"address": "I0.1", "value": 0}]
    assert lamps(report) == {"Q0.0": "1"}
    assert (report["source"], report["ok"], report["scan"], report["diagnostics"]) == (0, True, 1, [])
    assert report["dialect"]["name"] == "s7-200"
    assert [line["text"] for line in film(bench)["lines"]] == ["LD I0.0", "O Q0.0", "AN I0.1", "= Q0.0"]


def test_the_serial_of_the_text_comes_back_in_the_report() -> None:
    bench = Workbench(SEAL_IN, "s7-200")
    for wanted in (1, 2, 3):
        assert types(bench, f"LD I0.{wanted}\n= Q0.0\n")["source"] == wanted
    assert film(bench)["lines"][0]["text"] == "LD I0.3"


def test_a_text_with_errors_keeps_the_last_film_and_the_text() -> None:
    bench = Workbench(SEAL_IN, "s7-200")
    before = bench.film
    report = types(bench, "LD I0.0\nOLD\n= Q0.0\nADN I0.9")
    assert bench.film == before
    assert bench.source == "LD I0.0\nOLD\n= Q0.0\nADN I0.9"
    assert not report["ok"]
    (found,) = [one for one in report["diagnostics"] if one["row"] == 4]
    assert (found["code"], found["severity"], found["start"], found["stop"]) == ("RDR001", "error", 0, 3)
    assert set(found["text"]) == {"zh", "en"}
    assert types(bench, "LD I0.5\n= Q0.0")["ok"]
    assert bench.film != before


def test_an_empty_text_is_no_program_yet() -> None:
    bench = Workbench("", "fx")
    assert json.loads(bench.report)["ok"] is False
    assert repr(bench) == "Workbench(fx, no program yet)"
    assert bench.film == ""
    assert types(bench, "LD X0\nOUT Y0")["ok"]


def test_switches_and_scans_go_on_from_the_memory_and_a_restart_forgets_it() -> None:
    bench = Workbench(SEAL_IN, "s7-200")
    assert lamps(types(bench, I0_0=1)) == {"Q0.0": "1"}
    assert lamps(types(bench, I0_0=0)) == {"Q0.0": "1"}
    assert presses(bench, "scan")["scan"] == 4
    assert lamps(types(bench, I0_1=1)) == {"Q0.0": "0"}
    types(bench, I0_0=1, I0_1=0)
    types(bench, I0_0=0)
    report = presses(bench, "restart")
    assert (lamps(report), report["scan"]) == ({"Q0.0": "0"}, 1)


def test_a_serial_alone_announces_a_button_and_runs_nothing() -> None:
    bench = Workbench("LD I0.0\nEU\n= Q0.0\n", "s7-200")
    types(bench, I0_0=1)
    bench.serial += 1
    report = presses(bench, "scan")
    assert (report["scan"], report["source"]) == (3, 2)


def test_another_text_starts_cold() -> None:
    bench = Workbench(SEAL_IN, "s7-200", {"I0.0": 1})
    types(bench, I0_0=0)
    report = types(bench, SEAL_IN + "// a word more\n")
    assert (lamps(report), report["scan"]) == ({"Q0.0": "0"}, 1)


def test_x_at_an_output_is_reported_and_lit_as_x() -> None:
    report = json.loads(Workbench("LD I0.0\nO I0.1\nNOT\nLD I0.2\nALD\n= Q0.0\n= M0.0", "s7-200").report)
    assert report["ok"]
    assert lamps(report) == {"Q0.0": "0", "M0.0": "0"}
    first = json.loads(Workbench("LD I0.0\nLDI I0.1\nOLD\n= Q0.0", "s7-200").report)
    assert [(one["code"], one["severity"]) for one in first["diagnostics"]] == [("STK007", "info")]


def test_a_file_is_opened_in_any_usual_encoding() -> None:
    bench = Workbench("", "s7-200")
    data = "Network 1 // 启动\r\nLD I0.0 // 按钮\r\n= Q0.0\r\n".encode("gbk")
    report = presses(bench, "open", [data], name="电机.awl")
    assert bench.source == "Network 1 // 启动\nLD I0.0 // 按钮\n= Q0.0\n"
    assert (bench.filename, report["ok"]) == ("电机.awl", True)
    presses(bench, "open", [memoryview(b"LD I0.1\n= Q0.1\n")], name="x" * 1_000)  # type: ignore[list-item]
    assert bench.source == "LD I0.1\n= Q0.1\n"
    assert len(bench.filename) <= 80
    before = bench.report
    presses(bench, "open")
    presses(bench, "nothing we know")
    assert bench.report == before


def test_a_program_is_saved_and_loaded_as_typed(tmp_path: Path) -> None:
    bench = Workbench("ld i0.0 // 按钮\n=q0.0", "s7-200")
    bench.save(tmp_path / "mine.stl")
    assert (tmp_path / "mine.stl").read_bytes() == "ld i0.0 // 按钮\n=q0.0".encode()
    other = Workbench("", "s7-200")
    other.load(tmp_path / "mine.stl")
    assert (other.source, other.filename) == (bench.source, "mine.stl")


@pytest.mark.parametrize(
    ("dialect", "text", "lamp"),
    [("fx", "LD X0\nOUT Y0\nOUT M5", {"Y0": "0", "M5": "0"}), ("neza", "LDN %I0.0\nST %Q0.0", {"%Q0.0": "1"}),
     ("gutta", "LD I0.0\nP M0.0\n= Q0.0", {"Q0.0": "0", "M0.0": "0"})],
)  # fmt: skip
def test_every_family_has_its_bench(dialect: str, text: str, lamp: dict[str, str]) -> None:
    assert lamps(json.loads(Workbench(text, dialect).report)) == lamp


@pytest.mark.parametrize("inputs", ['{"I0.0": 1, "X7": 1}', '{"I9.9": 1}', '{"I0.0": null}', '{"I0.0": "yes"}'])
def test_switches_that_the_program_does_not_know_do_no_harm(inputs: str) -> None:
    bench = Workbench("LD I0.0\n= Q0.0\n", "s7-200")
    bench.inputs = inputs
    bench.serial += 1
    assert json.loads(bench.report)["ok"]


# The player.

OLD = "LD I0.0; LD I0.1; OLD; = Q0.0"


def test_a_player_holds_its_film_and_goes_where_it_is_told() -> None:
    player = StackPlayer(film_of(OLD, "s7-200"), index=3)
    assert (player.index, len(film(player)["steps"])) == (3, 5)
    assert StackPlayer(film_of(OLD, "s7-200"), index=99).index == 4
    player.show(film_of("LD X0; OUT Y0", "fx"))
    assert film(player)["lines"][0]["text"] == "LD X0"
    assert repr(player).endswith("2 steps, stack 0)")


def test_a_player_says_the_same_on_every_run_and_in_every_process() -> None:
    one = repr(plcteach.play(OLD, inputs={"I0.1": 1}))
    assert one == repr(plcteach.play(OLD, inputs={"I0.1": 1}))
    assert one.startswith("StackPlayer(")
    assert one.endswith(", 4 steps, stack 1xxxxxxxx)")
    code = f"import plcteach; print(plcteach.play({OLD!r}, inputs={{'I0.1': 1}}))"
    shown = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert shown.stdout.strip() == one


def html(widget) -> str:
    data, _ = widget._repr_mimebundle_()
    assert data["text/plain"] == repr(widget)
    assert "application/vnd.jupyter.widget-view+json" in data
    return data["text/html"]


def test_a_saved_page_shows_a_table_without_a_kernel() -> None:
    shown = html(StackPlayer(film_of(OLD, "s7-200")))
    assert shown.count("<tr>") == 4
    assert "<code>OLD</code>" in shown
    assert "no program yet" in html(Workbench("", "s7-200"))
    assert "<svg" in html(plcteach.desk("s7-two-blocks")), "the ladder can be read without a kernel"


@pytest.mark.parametrize("hostile", ["<script>alert(1)</script>", "<img src=x onerror=alert(1)>"])
def test_nothing_that_a_learner_types_becomes_a_tag(hostile: str) -> None:
    bench = Workbench(f"LD I0.0 // {hostile}\n= Q0.0\n", "s7-200")
    types(bench, f"{hostile}\nLD I0.0\n= Q0.0 // {hostile}")
    for widget in (bench, StackPlayer(film_of(f"LD I0.0 // {hostile}\n= Q0.0", "s7-200"))):
        assert "<script" not in html(widget)
        assert "<img" not in html(widget)


def test_the_verbs_open_them() -> None:
    assert isinstance(plcteach.play(OLD), StackPlayer)
    bench = plcteach.bench("\nLD X0\nOUT Y0\n", "fx", {"X0": 1})
    assert isinstance(bench, Workbench)
    assert bench.source == "LD X0\nOUT Y0"
    assert isinstance(plcteach.desk("s7-two-blocks", size=2), ExerciseDesk)
    assert plcteach.play(OLD, index=2, size=1.5).size == 1.5


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_widgets_open_in_the_language_in_force(monkeypatch: pytest.MonkeyPatch, lang: str) -> None:
    monkeypatch.setattr(words, "_chosen", [lang])
    assert Workbench("", "fx").language == lang
    assert plcteach.desk("s7-two-blocks").language == lang
    assert plcteach.play(OLD).language == lang


@pytest.mark.parametrize("kind", [Workbench, ExerciseDesk, StackPlayer])
def test_a_widgets_browser_code_is_one_module_that_needs_nothing_else(kind) -> None:
    code = str(kind._esm)
    assert "export default { render }" in code
    assert "import " not in code.split("export default")[1]
    assert "\nimport " not in code
    assert "https://" not in code.replace("https://codemirror.net", "").replace("http://www.w3.org", "")
