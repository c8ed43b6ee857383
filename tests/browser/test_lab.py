"""The widgets in a real JupyterLab: a lesson run from top to bottom, the player, the workbench and the desk."""

from __future__ import annotations

from typing import TYPE_CHECKING

import nbformat
import pytest
from labpage import STATE, axe, open_notebook, run_all

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from playwright.sync_api import Browser, Page

PLAYER = "plc.play('LD I0.0; A I0.1; LD I0.2; AN I0.3; OLD; = Q0.0', inputs={'I0.2': 1})"
BENCH = "plc.bench('LD I0.0\\nO Q0.0\\nAN I0.1\\n= Q0.0')"
DESK = "plc.desk('s7-two-blocks')"
WRONG = "LD I0.0\nA I0.1\nLD I0.2\nAN I0.3\nALD\n= Q0.0\n"


def notebook(folder: Path, name: str, *cells: str) -> None:
    book = nbformat.v4.new_notebook()
    book.cells = [nbformat.v4.new_code_cell(one) for one in ("import plcteach as plc\nplc.language('en')", *cells)]
    book.metadata = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    nbformat.write(book, folder / name)


@pytest.fixture
def player(chromium: Browser, lab: tuple[str, Path]) -> Iterator[Page]:
    address, folder = lab
    notebook(folder, "player.ipynb", PLAYER, "1 + 1", "2 + 2")
    page = open_notebook(chromium, address, "player.ipynb")
    run_all(page)
    page.wait_for_selector(".plc-player", timeout=60_000)
    page.wait_for_timeout(1000)
    yield page
    page.close()


def index(page: Page) -> int:
    return int(page.locator(".plc-player input[type=range]").first.input_value())


def test_keys_step_the_player_and_leave_the_notebook_alone(player: Page) -> None:
    player.locator(".plc-player").first.click(position={"x": 5, "y": 5})
    player.locator(".plc-player").first.focus()
    before = player.evaluate(STATE)
    player.keyboard.press("ArrowRight")
    player.keyboard.press("ArrowRight")
    assert index(player) == 2
    for key in ("b", "a", "m", "d", "d", "x", "0", "0", "ArrowLeft", "ArrowDown"):
        player.keyboard.press(key)
    assert player.evaluate(STATE) == before
    assert index(player) == 1
    player.keyboard.press("End")
    assert index(player) == 6
    player.keyboard.press("Home")
    assert index(player) == 0


def test_buttons_step_and_a_cell_is_seen_between_two_levels(player: Page) -> None:
    forward = player.get_by_role("button", name="Next").first
    for _ in range(2):
        forward.click()
        player.wait_for_timeout(700)
    where = "document.querySelector('.plc-player .plc-cell.plc-zero, .plc-player .plc-cell.plc-one').getBoundingClientRect().top"
    start = player.evaluate(where)
    forward.click()
    tops = []
    for _ in range(10):
        tops.append(player.evaluate(where))
        player.wait_for_timeout(40)
    player.wait_for_timeout(600)
    end = player.evaluate(where)
    assert end > start + 10
    assert any(start + 1 < top < end - 1 for top in tops), (start, tops, end)


def test_the_player_goes_on_while_the_kernel_is_busy(player: Page) -> None:
    kernel = "window.jupyterapp.shell.currentWidget.sessionContext.session.kernel"
    player.evaluate(f"void {kernel}.requestExecute({{code: 'import time; time.sleep(12)'}})")
    player.wait_for_function(f"{kernel}.status === 'busy'", timeout=20_000)
    player.locator(".plc-player").first.focus()
    player.keyboard.press("ArrowRight")
    player.keyboard.press("ArrowRight")
    assert index(player) == 2
    assert "A I0.1" in player.locator("[aria-current=step]").first.inner_text().replace("\n", " ").replace("  ", " ")
    assert player.evaluate(f"{kernel}.status") == "busy", "the kernel was busy all the while"


def test_axe_finds_nothing_in_the_lab(player: Page) -> None:
    player.locator(".plc-player").first.focus()
    player.keyboard.press("ArrowRight")
    player.wait_for_timeout(800)
    assert axe(player, ".plc-root") == []


TIMED = (
    "trace = plc.run('LD I0.0; TON T37, 5; LD T37; = Q0.0', 'I0.0: 0.2s off, 0.8s on, off', scan_ms=100)",
    "plc.chart(trace, show='I0.0 T37.V Q0.0')",
    "plc.face(trace, 'T37', 6)",
    "plc.play(trace, at=0.4)",
)
PICTURES = """(() => [...document.querySelectorAll('.jp-OutputArea-output .jp-RenderedSVG, .jp-OutputArea-output.jp-RenderedSVG')].map((box) => {
  const image = box.querySelector('img');
  return {
    text: image ? decodeURIComponent(image.src.split(',').slice(1).join(',')) : box.innerHTML,
    width: (image || box.querySelector('svg')).getBoundingClientRect().width,
  };
}))()"""


def test_a_chart_a_face_and_a_player_with_a_timer_in_the_lab(chromium: Browser, lab: tuple[str, Path]) -> None:
    address, folder = lab
    notebook(folder, "timed.ipynb", *TIMED)
    page = open_notebook(chromium, address, "timed.ipynb")
    run_all(page)
    page.wait_for_selector(".plc-block-timer", timeout=60_000)
    page.wait_for_timeout(800)
    pictures = page.evaluate(PICTURES)
    assert len(pictures) == 2, "the chart and the face"
    chart, face = pictures
    assert "Q0.0" in chart["text"]
    assert all(
        "T37" in one["text"] and one["text"].lstrip().startswith("<svg") and one["width"] > 100 for one in (chart, face)
    )
    words = page.locator(".plc-block-timer .plc-gauge-words").first
    assert "current 1" in " ".join(words.inner_text().split())
    page.locator(".plc-player").first.focus()
    for _ in range(2):
        page.keyboard.press("ArrowRight")
    page.wait_for_timeout(700)
    assert "current 2" in " ".join(words.inner_text().split())
    assert axe(page, ".plc-root") == []
    page.close()


@pytest.fixture
def bench(chromium: Browser, lab: tuple[str, Path]) -> Iterator[Page]:
    address, folder = lab
    notebook(folder, "bench.ipynb", BENCH)
    page = open_notebook(chromium, address, "bench.ipynb")
    run_all(page)
    page.wait_for_selector(".plc-switch", timeout=60_000)
    page.wait_for_timeout(800)
    yield page
    page.close()


def lamp(page: Page) -> str:
    return page.locator(".plc-lamp-bulb").first.inner_text()


def test_the_seal_in_holds_on_the_workbench(bench: Page) -> None:
    start, stop = bench.locator(".plc-switch").nth(0), bench.locator(".plc-switch").nth(1)
    assert lamp(bench) == "0"
    start.click()
    bench.wait_for_function("document.querySelector('.plc-lamp-bulb').textContent === '1'", timeout=10_000)
    start.click()
    bench.wait_for_timeout(800)
    assert lamp(bench) == "1", "the coil seals itself in after the button is released"
    stop.click()
    bench.wait_for_function("document.querySelector('.plc-lamp-bulb').textContent === '0'", timeout=10_000)


def test_what_is_typed_is_read_and_kept_even_with_errors(bench: Page) -> None:
    editor = bench.locator(".plc-editor .cm-content").first
    editor.click()
    bench.keyboard.press("Control+End")
    bench.keyboard.type("\nADN I0.2")
    bench.wait_for_selector("text=RDR001", timeout=10_000)
    assert "ADN I0.2" in editor.inner_text()
    assert "AN" in bench.locator(".plc-editor").inner_text().split("RDR001")[1]
    bench.keyboard.press("Control+z")
    bench.wait_for_function("!document.querySelector('.plc-editor').innerText.includes('RDR001')", timeout=10_000)
    state = bench.evaluate(STATE)
    assert state["cells"] == 2
    assert axe(bench, ".plc-root") == []


def test_a_wrong_answer_is_shown_on_the_inputs_that_tell_it_apart(chromium: Browser, lab: tuple[str, Path]) -> None:
    address, folder = lab
    notebook(folder, "desk.ipynb", DESK)
    page = open_notebook(chromium, address, "desk.ipynb")
    run_all(page)
    page.wait_for_selector(".plc-editor .cm-content", timeout=60_000)
    page.wait_for_timeout(800)
    page.locator(".plc-editor .cm-content").first.click()
    page.keyboard.type(WRONG)
    page.wait_for_timeout(500)
    page.get_by_role("button", name="Check").first.click()
    headline = page.locator(".plc-verdict-headline")
    headline.wait_for(timeout=10_000)
    assert "I0.2=1" in headline.inner_text()
    assert "should be 1; your program gives 0" in headline.inner_text()
    page.get_by_role("button", name="Show me").first.click()
    page.wait_for_selector(".plc-player", timeout=10_000)
    page.locator(".plc-player").first.focus()
    page.keyboard.press("End")
    assert "Q0.0 := 0" in page.locator(".plc-player").first.inner_text()
    assert axe(page, ".plc-root") == []
    page.locator(".plc-editor .cm-content").first.click()
    page.keyboard.press("Control+a")
    page.keyboard.type(WRONG.replace("ALD", "OLD"))
    page.wait_for_timeout(500)
    page.get_by_role("button", name="Check").first.click()
    page.wait_for_function(
        "document.querySelector('.plc-verdict-headline').textContent.startsWith('Correct')", timeout=10_000
    )
    page.close()


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_lesson_1_runs_from_top_to_bottom(chromium: Browser, lab: tuple[str, Path], lang: str) -> None:
    address, _ = lab
    page = open_notebook(chromium, address, f"{lang}/01-what-the-stack-is-for.ipynb")
    run_all(page)
    page.wait_for_function(
        "[...window.jupyterapp.shell.currentWidget.content.widgets].filter((one) => one.model.type === 'code')"
        ".every((one) => one.model.executionCount)",
        timeout=120_000,
    )
    page.wait_for_selector(".plc-player", timeout=60_000)
    errors = page.evaluate(
        "[...window.jupyterapp.shell.currentWidget.content.widgets].filter((one) => one.model.type === 'code')"
        ".flatMap((one) => one.model.outputs.toJSON()).filter((one) => one.output_type === 'error').map((one) => one.evalue)"
    )
    assert errors == []
    page.close()
