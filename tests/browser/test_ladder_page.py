"""The ladder beside its list in a real page: it grows sign by sign, signs and lines point at each other, families step together."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Any

import pytest
from labpage import axe

from plcteach.dialects import families
from plcteach.figure.families import together
from plcteach.figure.verbs import film_of
from plcteach.publish import families_page, player_page

if TYPE_CHECKING:
    from pathlib import Path

    from playwright.sync_api import Browser, Page

PROGRAM = "LD I0.0; A I0.1; LD I0.2; AN I0.3; OLD; LD I0.4; O I0.5; ALD; = Q0.0; LPS; A I0.6; = Q0.1; LPP; TON T37, 5"
INPUTS = {"I0.2": 1, "I0.5": 1}
DRAWING = """
--[ I0.0 ]--[ I0.1 ]--+--+--[ I0.4 ]--( Q0.0 )
--[ I0.2 ]--[/I0.3 ]--+  +--[ I0.5 ]--( Q0.1 )
                         +--( Q0.2 )
"""


def opened(chromium: Browser, path: Path, html: str, **options: Any) -> Page:
    path.write_text(html, encoding="utf-8")
    options.setdefault("reduced_motion", "reduce")
    page = chromium.new_context(offline=True, **options).new_page()
    problems: list[str] = []
    page.on("pageerror", lambda error: problems.append(str(error)))
    page.goto(path.as_uri())
    page.wait_for_selector(".plc-rung")
    page.locator(".plc-player").focus()
    assert problems == []
    return page


@pytest.fixture
def page(chromium: Browser, tmp_path: Path) -> Page:
    return opened(chromium, tmp_path / "player.html", player_page(film_of(PROGRAM, "s7-200", INPUTS), "en"))


def parts(page: Page, state: str) -> set[str]:
    """Give the signs that are in a state."""
    found: list[str] = page.evaluate(
        "(state) => [...document.querySelectorAll(`.plc-rung [data-part^=s].${state}`)].map((one) => one.dataset.part)",
        state,
    )
    return set(found)


def press(page: Page, times: int) -> None:
    for _ in range(times):
        page.keyboard.press("ArrowRight")


def inside(page: Page, part: str, frame: str) -> bool:
    """Say whether the middle of a sign lies within a frame that is drawn."""
    return bool(
        page.evaluate(
            """([part, frame]) => {
              const box = document.querySelector(`[data-part="${part}"]`).getBoundingClientRect();
              const around = document.querySelector(frame).getBoundingClientRect();
              const [x, y] = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
              return around.left < x && x < around.right && around.top < y && y < around.bottom;
            }""",
            [part, frame],
        )
    )


def test_stepping_grows_the_ladder_contact_by_contact(page: Page) -> None:
    every = {f"s0-{at}" for at in range(10)}
    drawn = []
    for _ in range(15):
        drawn.append(every - parts(page, "plc-unbuilt"))
        press(page, 1)
    sizes = [len(one) for one in drawn]
    assert sizes == [0, 1, 2, 3, 4, 4, 5, 6, 6, 7, 7, 8, 9, 9, 10]
    assert all(one <= after for one, after in itertools.pairwise(drawn))
    page.keyboard.press("Home")
    assert parts(page, "plc-unbuilt") == every


def test_power_is_where_the_contacts_let_it(page: Page) -> None:
    press(page, 9)
    assert parts(page, "plc-lit") == {"s0-2", "s0-3", "s0-5", "s0-6"}
    assert (
        page.locator(".plc-rung .plc-lit .plc-line").first.evaluate("(line) => getComputedStyle(line).stroke")
        == "rgb(46, 125, 50)"
    )


def test_a_join_brackets_the_two_blocks_that_it_joins(page: Page) -> None:
    press(page, 5)
    assert page.locator(".plc-mark-block").count() == 2
    for part, block in (("s0-0", 1), ("s0-1", 1), ("s0-2", 2), ("s0-3", 2)):
        assert inside(page, part, f".plc-mark-block-{block}")
        assert not inside(page, part, f".plc-mark-block-{3 - block}")
    press(page, 1)
    assert page.locator(".plc-mark-block").count() == 0
    page.locator(".plc-line[data-line='7']").hover()
    assert page.locator(".plc-mark-block").count() == 2
    assert inside(page, "s0-4", ".plc-mark-block-2")
    assert not inside(page, "s0-4", ".plc-mark-block-1")


def test_pointing_at_a_contact_marks_its_line_and_choosing_it_goes_there(page: Page) -> None:
    press(page, 14)
    sign = page.locator("[data-part='s0-4']")
    sign.hover()
    assert page.locator(".plc-line-linked").evaluate_all("(rows) => rows.map((row) => row.dataset.line)") == ["5"]
    page.locator(".plc-caption").hover()
    assert page.locator(".plc-line-linked").count() == 0
    sign.click()
    assert page.locator("[aria-current=step]").first.get_attribute("data-line") == "5"
    page.locator(".plc-line[data-line='1']").hover()
    assert inside(page, "s0-1", ".plc-mark-new")


def test_the_keys_walk_from_sign_to_sign_without_stepping_the_player(page: Page) -> None:
    press(page, 2)
    page.locator("[data-part='s0-0']").focus()
    page.keyboard.press("ArrowRight")
    assert page.evaluate("document.activeElement.dataset.part") == "s0-1"
    assert page.locator("[aria-current=step]").first.get_attribute("data-line") == "1"
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    assert page.locator("[aria-current=step]").first.get_attribute("data-line") == "2"
    assert "I0.2" in str(page.evaluate("document.activeElement.getAttribute('aria-label')"))


def test_the_ladder_can_be_folded_away_and_shows_formulas_on_demand(page: Page) -> None:
    assert page.locator(".plc-rung-formulas").count() == 0
    page.locator(".plc-formulas").click()
    assert "Q0.0 = (I0.0·I0.1+I0.2·/I0.3)·(I0.4+I0.5)" in page.locator(".plc-rung-formulas").inner_text()
    page.locator(".plc-view .plc-ladder").click()
    assert not page.locator(".plc-ladder-view").is_visible()
    page.locator(".plc-view .plc-ladder").click()
    assert page.locator(".plc-rung").is_visible()


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [360, 1100])
def test_the_page_with_a_ladder_is_accessible_and_never_wider_than_the_window(
    chromium: Browser, tmp_path: Path, width: int, theme: str
) -> None:
    film = film_of(PROGRAM, "s7-200", [INPUTS, {}])
    page = opened(
        chromium,
        tmp_path / "player.html",
        player_page(film, "zh"),
        viewport={"width": width, "height": 800},
        color_scheme=theme,
    )
    press(page, 5)
    assert axe(page, ".plc-player") == []
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    press(page, 6)
    sign = page.locator("[data-part='s0-7']").bounding_box()
    assert sign
    assert 0 <= sign["x"] < sign["x"] + sign["width"] <= width


def tops(page: Page) -> list[str]:
    """Give for each family the value that stands highest."""
    found: list[str] = page.evaluate(
        """() => [...document.querySelectorAll('.plc-family')].map((family) => {
          const cells = [...family.querySelectorAll('.plc-cell:not(.plc-ghost)')];
          const place = (cell) => cell.getBoundingClientRect().top * 10 + cell.getBoundingClientRect().left / 1000;
          return cells.length ? cells.sort((a, b) => place(a) - place(b))[0].querySelector('.plc-value').textContent : '';
        })"""
    )
    return found


def test_four_stacks_move_together_and_stand_as_high_as_each_other(chromium: Browser, tmp_path: Path) -> None:
    shown = together(DRAWING, None, families(), {"I0.2": 1, "I0.5": 1})
    page = opened(
        chromium, tmp_path / "four.html", families_page(shown, "en"), viewport={"width": 1400, "height": 1100}
    )
    assert page.locator(".plc-family").count() == 4
    for _ in range(4):
        press(page, 1)
        assert len(set(tops(page))) == 1
    press(page, 1)
    lines = page.locator(".plc-family [aria-current=step] .plc-words").all_inner_texts()
    assert [line.split()[0] for line in lines] == ["OLD", "ORB", ")", "OLD"]
    assert tops(page) == ["1", "1", "1", "1"]
    press(page, 1)
    heights: list[list[float]] = page.evaluate(
        """() => [...document.querySelectorAll('.plc-family')].slice(0, 2).map((family) =>
          [...family.querySelectorAll('.plc-one')].map((cell) => Math.round(cell.getBoundingClientRect().top)).sort((a, b) => a - b))"""
    )
    s7, fx = heights
    assert s7 == fx, "the result register is as high as level 1, level 1 as high as level 2"
    assert len(s7) == 2
    page.keyboard.press("End")
    assert page.locator(".plc-family [aria-current=step]").count() == 4
    assert axe(page, ".plc-player") == []
