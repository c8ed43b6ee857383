"""The live bench with a real kernel in a real JupyterLab: the eight lamps, the seal-in, two benches side by side."""

from __future__ import annotations

from typing import TYPE_CHECKING

import nbformat
import pytest
from labpage import axe, open_notebook, run_all

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from playwright.sync_api import Browser, Page

LAMPS = """%TM0: TYPE=TON TB=100ms P=10
LD %I0.0
OR %M0
ANDN %I0.1
ST %M0
BLK %TM0
LD %M0
ANDN %M1
IN
OUT_BLK
LD Q
ST %M1
END_BLK
LD %M1
ST %M2
LD %M0
ANDN %SBR0.0
ANDN %SBR0.1
ANDN %SBR0.2
ANDN %SBR0.3
ANDN %SBR0.4
ANDN %SBR0.5
ANDN %SBR0.6
ANDN %SBR0.7
S %SBR0.0
BLK %SBR0
LD %I0.1
R
LD %M2
CU
END_BLK
""" + "".join(f"LD %SBR0.{lamp}\nST %Q0.{lamp}\n" for lamp in range(8))
BENCH = "plc.bench('LD I0.0\\nO Q0.0\\nAN I0.1\\n= Q0.0')"


def notebook(folder: Path, name: str, *cells: str) -> None:
    book = nbformat.v4.new_notebook()
    book.cells = [nbformat.v4.new_code_cell(one) for one in ("import plcteach as plc\nplc.language('en')", *cells)]
    book.metadata = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    nbformat.write(book, folder / name)


@pytest.fixture
def lamps(chromium: Browser, lab: tuple[str, Path]) -> Iterator[Page]:
    address, folder = lab
    notebook(folder, "lamps.ipynb", f"one = plc.live({LAMPS!r}, 'neza')\none", BENCH)
    page = open_notebook(chromium, address, "lamps.ipynb", viewport={"width": 1400, "height": 1400})
    run_all(page)
    page.wait_for_selector(".plc-livebench .plc-status-value[data-value]", timeout=60_000)
    page.wait_for_selector(".plc-work", timeout=60_000)
    yield page
    page.close()


def on(page: Page) -> list[str]:
    found: list[str] = page.evaluate(
        """() => [...document.querySelectorAll('.plc-livebench .plc-lamp')].filter((one) => one.querySelector('[data-value="1"]'))
          .map((one) => one.querySelector('.plc-address').textContent).filter((name) => name.startsWith('%Q') || name.startsWith('Q'))"""
    )
    return found


def hold(page: Page, selector: str, ms: int = 200) -> None:
    page.locator(selector).first.scroll_into_view_if_needed()
    box = page.locator(selector).first.bounding_box()
    assert box
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.wait_for_timeout(ms)
    page.mouse.up()


def test_the_eight_lamps_run_freeze_step_go_on_stop_and_are_looked_back_at(lamps: Page) -> None:
    lamps.locator(".plc-live-run").first.click()
    hold(lamps, ".plc-live-push >> nth=0")
    lamps.wait_for_function("() => document.querySelector('.plc-livebench .plc-lamp-bulb[data-value=\"1\"]')")
    seen: list[str] = []
    for _ in range(16):
        lamps.wait_for_timeout(200)
        lit = on(lamps)
        assert len(lit) <= 1, "at most one lamp"
        seen += [one for one in lit if one not in seen]
    assert seen[:3] == ["%Q0.0", "%Q0.1", "%Q0.2"]
    lamps.locator(".plc-live-freeze").first.click()
    lamps.wait_for_selector(".plc-live-stage .plc-player")
    for _ in range(5):
        lamps.keyboard.press("ArrowRight")
    assert lamps.locator(".plc-live-stage [aria-current=step]").get_attribute("data-line") == "4"
    lamps.locator(".plc-live-freeze").first.click()
    lamps.wait_for_timeout(300)
    hold(lamps, ".plc-live-push >> nth=1")
    lamps.wait_for_function("() => !document.querySelector('.plc-livebench .plc-lamp-bulb[data-value=\"1\"]')")
    lamps.locator(".plc-live-run").first.click()
    lamps.wait_for_timeout(300)
    slider = lamps.locator(".plc-livebench .plc-seek input").first
    last = int(slider.get_attribute("max") or 0)
    slider.evaluate("(one) => { one.value = 5; one.dispatchEvent(new Event('input', {bubbles: true})); }")
    lamps.wait_for_function("() => document.querySelector('.plc-livebench .plc-count').textContent.includes('scan 6')")
    assert on(lamps) == []
    assert last > 200
    lamps.locator(".plc-livebench .plc-speed").last.select_option("5")
    lamps.locator(".plc-live-replay").first.click()
    lamps.wait_for_selector(".plc-live-taped-over", timeout=30_000)
    assert "as recorded" in lamps.locator(".plc-live-tape-words").first.inner_text()
    assert int(slider.get_attribute("max") or 0) == last, "it ran as many scans as before"
    assert axe(lamps, ".plc-livebench") == []


def test_the_workbench_goes_live_and_back_and_the_other_bench_is_not_disturbed(lamps: Page) -> None:
    work = ".plc-bench "
    lamps.locator(work + ".plc-live-choose-live").click()
    lamps.wait_for_selector(work + ".plc-livebench .plc-status-value[data-value]", timeout=10_000)
    assert not lamps.locator(work + ".plc-film").is_visible()
    lamps.locator(work + ".plc-live-run").click()
    hold(lamps, work + ".plc-live-push >> nth=0")
    lamps.wait_for_selector(work + ".plc-lamp-bulb[data-value='1']")
    others = lamps.locator(".plc-livebench").first
    assert others.locator(".plc-lamp-bulb[data-value='1']").count() == 0
    lamps.locator(work + ".plc-live-choose-step").click()
    lamps.wait_for_selector(work + ".plc-film .plc-player", timeout=10_000)
    lamps.wait_for_selector(work + ".plc-livebench", state="detached", timeout=10_000)
