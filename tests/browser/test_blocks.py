"""Function blocks in the player's page: bars, numbers, words and rows that change as the lines are stepped over."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from labpage import axe

from plcteach.figure.verbs import film_of
from plcteach.publish import player_page

if TYPE_CHECKING:
    from pathlib import Path

    from playwright.sync_api import Browser, Page

QUEUE = "%R0: TYPE=FIFO; LD 1; [ %R0.I := %MW0 ]; LD %I0.0; I %R0; LD %I0.1; O %R0"
DRUM = "%DR0: OUT=%Q0.0,%Q0.1 STEPS=00,10,01; LD %I0.0; U %DR0"


def shown(chromium: Browser, path: Path, film: Any, lang: str = "en", **options: Any) -> Page:
    """Open a film in its page, with the network off."""
    path.write_text(player_page(film, lang), encoding="utf-8")
    page = chromium.new_context(offline=True, **options).new_page()
    problems: list[str] = []
    page.on("pageerror", lambda error: problems.append(str(error)))
    page.goto(path.as_uri())
    page.wait_for_selector(".plc-block")
    page.locator(".plc-player").focus()
    assert problems == []
    return page


def go(page: Page, index: int) -> None:
    """Go to a picture by the slider."""
    page.evaluate(
        "([index]) => { const slider = document.querySelector('input[type=range]');"
        "slider.value = index; slider.dispatchEvent(new Event('input', {bubbles: true})); }",
        [index],
    )


def fill(page: Page, kind: str) -> float:
    """Give how wide a bar is, as a part of its scale."""
    bar = page.locator(f".plc-block-{kind} .plc-gauge-bar").bounding_box()
    part = page.locator(f".plc-block-{kind} .plc-gauge-fill").bounding_box()
    assert bar
    assert part
    return part["width"] / bar["width"]


def words(page: Page, kind: str) -> str:
    return page.locator(f".plc-block-{kind} .plc-gauge-words").inner_text()


def test_the_bars_of_a_timer_and_a_counter_follow_their_numbers(chromium: Browser, tmp_path: Path) -> None:
    text = "LD I0.0; TON T37, 5; LD T37; = Q0.0; LD I0.1; LD I0.2; CTU C0, 3"
    film = film_of(text, "s7-200", [{"I0.0": 1, "I0.1": at % 2, "ms": 100} for at in range(10)])
    page = shown(chromium, tmp_path / "player.html", film, reduced_motion="reduce")
    assert fill(page, "timer") == pytest.approx(0, abs=0.02)
    bars: dict[str, list[float]] = {"timer": [], "counter": []}
    for scan in range(10):
        end = max(at for at, step in enumerate(film.data["steps"]) if step["scan"] == scan)
        go(page, end)
        for kind, bar in bars.items():
            bar.append(fill(page, kind))
        assert f"current {scan}" in " ".join(words(page, "timer").split())
        assert f"current {(scan + 1) // 2}" in " ".join(words(page, "counter").split())
    assert bars["timer"] == sorted(bars["timer"])
    assert bars["timer"][1] < bars["timer"][3] < bars["timer"][5] < bars["timer"][9]
    assert bars["counter"][0] + 0.1 < bars["counter"][1]
    assert bars["counter"][1] == pytest.approx(bars["counter"][2], abs=0.01)
    assert bars["counter"][2] + 0.1 < bars["counter"][3]
    mark = page.locator(".plc-block-timer .plc-gauge-mark").bounding_box()
    bar = page.locator(".plc-block-timer .plc-gauge-bar").bounding_box()
    assert mark
    assert bar
    part = (mark["x"] - bar["x"]) / bar["width"]
    assert bars["timer"][3] < part + 0.05 < bars["timer"][7], "the mark of the preset lies between 300 and 700 ms"
    page.context.close()


def test_a_line_of_a_timer_changes_its_bar_while_it_is_stepped_over(chromium: Browser, tmp_path: Path) -> None:
    film = film_of("LD I0.0; TON T37, 5; LD T37; = Q0.0", "s7-200", [{"I0.0": 1, "ms": 100}] * 4)
    page = shown(chromium, tmp_path / "player.html", film)
    lines = [step["line"] for step in film.data["steps"]]
    box = [at for at, line in enumerate(lines) if line == 1][2]
    go(page, box - 1)
    page.wait_for_timeout(700)
    before = fill(page, "timer")
    page.locator(".plc-player").focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_timeout(700)
    after = fill(page, "timer")
    assert after > before + 0.02
    page.keyboard.press("ArrowLeft")
    page.wait_for_timeout(700)
    assert fill(page, "timer") == pytest.approx(before, abs=0.01)
    page.context.close()


def tops(page: Page) -> dict[str, float]:
    """Give where each word of a queue stands."""
    return page.evaluate(
        "Object.fromEntries([...document.querySelectorAll('.plc-block-queue .plc-bead:not(.plc-bead-leaving)')]"
        ".map((one) => [one.textContent, one.getBoundingClientRect().top]))"
    )


def test_the_words_of_a_queue_are_seen_moving_down(chromium: Browser, tmp_path: Path) -> None:
    rows = (
        [{"%MW0": 0}]
        + [{"%MW0": word, "%I0.0": on} for word, on in ((11, 1), (0, 0), (22, 1), (0, 0))]
        + [{"%I0.1": 1}]
    )
    film = film_of(QUEUE, "neza", rows)
    page = shown(chromium, tmp_path / "player.html", film)
    taken = max(at for at, step in enumerate(film.data["steps"]) if step.get("faces"))
    go(page, taken - 1)
    page.wait_for_timeout(800)
    before = tops(page)
    assert set(before) == {"11", "22"}
    assert before["22"] < before["11"], "the newest word lies on top"
    page.locator(".plc-player").focus()
    page.keyboard.press("ArrowRight")
    seen = []
    for _ in range(12):
        seen.append(tops(page).get("22", before["22"]))
        page.wait_for_timeout(40)
    page.wait_for_timeout(600)
    after = tops(page)
    assert set(after) == {"22"}
    assert after["22"] == pytest.approx(before["11"], abs=1.5), "22 lies where 11 lay"
    assert any(before["22"] + 1 < top < after["22"] - 1 for top in seen), (before, seen, after)
    page.context.close()


def test_the_frame_of_a_drum_stands_on_its_active_step(chromium: Browser, tmp_path: Path) -> None:
    film = film_of(DRUM, "neza", [{"%I0.0": at % 2} for at in range(7)])
    page = shown(chromium, tmp_path / "player.html", film, reduced_motion="reduce")
    for scan, active in enumerate((0, 1, 1, 2, 2, 0, 0)):
        go(page, max(at for at, step in enumerate(film.data["steps"]) if step["scan"] == scan))
        page.wait_for_timeout(60)
        frame = page.locator(".plc-drum-active").bounding_box()
        row = page.locator(".plc-drum-step").nth(active).bounding_box()
        assert frame
        assert row
        assert frame["y"] + frame["height"] / 2 == pytest.approx(row["y"] + row["height"] / 2, abs=4)
        assert page.locator(".plc-drum-now").inner_text() == str(active)
    page.context.close()


EVERY_BLOCK = (
    "%TM0: TB=100ms P=3\n%C0: P=3\n%DR0: OUT=%Q0.0,%Q0.1 STEPS=00,10,01\n%R0: TYPE=LIFO\n"
    "LD %I0.0; IN %TM0; CU %C0; U %DR0; S %SBR0.0; CU %SBR0; CU %SC0; [ %R0.I := 45 ]; I %R0; LD %TM0.Q; ST %Q0.2"
)


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [360, 1100])
def test_axe_finds_nothing_in_the_blocks_and_nothing_is_too_wide(
    chromium: Browser, tmp_path: Path, scheme: str, width: int
) -> None:
    film = film_of(EVERY_BLOCK, "neza", [{"%I0.0": at % 2, "ms": 100} for at in range(4)])
    options = {"color_scheme": scheme, "bypass_csp": True, "viewport": {"width": width, "height": 900}}
    page = shown(chromium, tmp_path / "player.html", film, "zh" if scheme == "dark" else "en", **options)
    assert page.locator(".plc-block").count() == 6
    page.keyboard.press("End")
    page.wait_for_timeout(900)
    assert axe(page, "body") == []
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    page.context.close()
