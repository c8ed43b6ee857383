"""player.html from file:// with the network off: steps, motion, keys, ask mode, widths, themes, languages."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from labpage import axe

from plcteach.core.text import Text
from plcteach.figure.film import film
from plcteach.machine import run
from plcteach.publish import player_page
from plcteach.stl import read

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

PROGRAMS = {
    "s7-200": (
        "LD I0.0; A I0.1; LD I0.2; AN I0.3; OLD; = Q0.0; LPS; A I0.4; = Q0.1; LPP; AN I0.5; = Q0.2",
        {"I0.2": 1},
    ),
    "fx": ("LD X0; OR X5; MPS; AND X1; OUT Y0; MRD; AND X2; OUT Y1; MPP; AND X3; OUT Y2; END", {"X0": 1, "X2": 1}),
    "neza": ("LD %I0.0; AND( %I0.1; OR %I0.2; ); MPS; ST %Q0.0; MPP; ANDN %I0.3; ST %Q0.1", {"%I0.0": 1, "%I0.2": 1}),
    "gutta": ("LD I0.0; LPS; A I0.1; = Q0.0; LPP; LD I0.2; O I0.3; ALD; = Q0.1", {"I0.0": 1, "I0.3": 1}),
}


@pytest.fixture(params=list(PROGRAMS))
def page_file(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    text, inputs = PROGRAMS[request.param]
    shot = film(run(read(text, request.param), [inputs]).scans, Text("演示", "A demonstration"))
    path = tmp_path / "player.html"
    path.write_text(player_page(shot, "en"), encoding="utf-8")
    return path


def opened(chromium: Browser, path: Path, **options: Any) -> Page:
    context = chromium.new_context(offline=True, bypass_csp=False, **options)
    page = context.new_page()
    problems: list[str] = []
    page.on("pageerror", lambda error: problems.append(str(error)))
    page.on("console", lambda message: problems.append(message.text) if message.type == "error" else None)
    page.goto(path.as_uri())
    page.wait_for_selector(".plc-player")
    assert problems == []
    return page


def stack(page: Page) -> str:
    return str(
        page.locator(".plc-stage, .plc-picture")
        .locator("xpath=descendant-or-self::*[@role='img']")
        .first.get_attribute("aria-label")
    )


def current(page: Page) -> str:
    return page.locator("[aria-current=step]").first.inner_text()


def test_steps_forward_and_back_without_a_network(chromium: Browser, page_file: Path) -> None:
    page = opened(chromium, page_file)
    slider = page.locator("input[type=range]").first
    last = int(slider.get_attribute("max") or 0)
    seen = [stack(page)]
    page.locator(".plc-player").focus()
    for _ in range(last):
        page.keyboard.press("ArrowRight")
        seen.append(stack(page))
    assert len(set(seen)) > last // 2
    back = [stack(page)]
    for _ in range(last):
        page.keyboard.press("ArrowLeft")
        back.append(stack(page))
    assert back == seen[::-1]
    page.keyboard.press("End")
    assert slider.input_value() == str(last)
    page.keyboard.press("Home")
    assert slider.input_value() == "0"
    page.context.close()


def test_a_cell_is_seen_on_its_way(chromium: Browser, tmp_path: Path) -> None:
    shot = film(run(read("LD I0.0; LD I0.1; OLD; = Q0.0", "s7-200"), [{"I0.0": 1}]).scans)
    path = tmp_path / "player.html"
    path.write_text(player_page(shot, "en"), encoding="utf-8")
    page = opened(chromium, path)
    page.locator(".plc-player").focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_timeout(900)
    where = """() => {
      const cell = document.querySelector('.plc-cell.plc-one');
      return cell.getBoundingClientRect().top;
    }"""
    start = page.evaluate(where)
    page.keyboard.press("ArrowRight")
    tops = []
    for _ in range(12):
        tops.append(page.evaluate(where))
        page.wait_for_timeout(50)
    page.wait_for_timeout(400)
    end = page.evaluate(where)
    assert end > start + 10, "the pushed-down cell ends one level lower"
    assert any(start + 1 < top < end - 1 for top in tops), f"it was seen between: {start} {tops} {end}"
    page.context.close()


def test_reduced_motion_moves_nothing_slowly(chromium: Browser, page_file: Path) -> None:
    page = opened(chromium, page_file, reduced_motion="reduce")
    page.locator(".plc-player").focus()
    page.keyboard.press("ArrowRight")
    assert page.evaluate("document.getAnimations().filter((one) => one.playState === 'running').length") == 0
    page.context.close()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing(chromium: Browser, page_file: Path, scheme: str) -> None:
    context = chromium.new_context(color_scheme=scheme, bypass_csp=True)
    page = context.new_page()
    page.goto(page_file.as_uri())
    page.wait_for_selector(".plc-player")
    page.locator(".plc-player").focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_timeout(800)
    assert axe(page, "body") == []
    context.close()


@pytest.mark.parametrize("width", [360, 1920])
def test_nothing_is_wider_than_the_page(chromium: Browser, page_file: Path, width: int) -> None:
    page = opened(chromium, page_file, viewport={"width": width, "height": 800})
    page.keyboard.press("End")
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    page.context.close()


def test_the_language_is_switched_in_the_page(chromium: Browser, page_file: Path) -> None:
    page = opened(chromium, page_file)
    page.locator(".plc-player").focus()
    page.keyboard.press("ArrowRight")
    before = page.locator(".plc-say").inner_text()
    page.get_by_role("button", name="中").first.click()
    after = page.locator(".plc-say").inner_text()
    assert before != after
    assert any("一" <= sign <= "鿿" for sign in after)
    page.context.close()


def test_ask_mode_keeps_its_secret_until_the_guess(chromium: Browser, tmp_path: Path) -> None:
    shot = film(run(read("LD I0.0; A I0.1; = Q0.0", "s7-200"), [{"I0.0": 1}]).scans)
    path = tmp_path / "player.html"
    path.write_text(player_page(shot, "en"), encoding="utf-8")
    page = opened(chromium, path)
    page.locator(".plc-player").focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_timeout(700)
    secret = shot.data["steps"][2]["say"]["en"]
    page.get_by_role("button", name="Ask").first.click()
    page.locator(".plc-player").focus()
    page.keyboard.press("ArrowRight")
    assert page.locator(".plc-answers").is_visible()
    assert secret not in page.content().split("<script")[0]
    page.keyboard.press("0")
    page.wait_for_timeout(700)
    assert secret in page.locator(".plc-player").inner_text()
    page.context.close()
