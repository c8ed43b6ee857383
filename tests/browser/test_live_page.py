"""The live bench under a real pointer and real keys: run, press, freeze, step, let go, look back."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from labpage import axe
from livepage import served

from plcteach.plants import Model, plant
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Iterator

    from playwright.sync_api import Browser, Page

    from plcteach.widgets.live import Session

HOME = 5
"""The limit switch at home is met a few mm before the end."""

SEAL_IN = """Network 1 // start and stop
LD I0.0
O Q0.0
AN I0.1
= Q0.0
Network 2 // flash
LD Q0.0
AN T38
TON T37, 5
Network 3
LD T37
TON T38, 5
= Q0.1
Network 4 // count
LD Q0.1
EU
INCW VW0
"""


@pytest.fixture
def bench(chromium: Browser) -> Iterator[tuple[Page, Session]]:
    with served(read(SEAL_IN, "s7-200")) as (address, session):
        page = opened(chromium, address)
        yield page, session
        page.context.close()


def opened(chromium: Browser, address: str, **options: Any) -> Page:
    page = chromium.new_context(**{"viewport": {"width": 1300, "height": 1000}, **options}).new_page()
    problems: list[str] = []
    page.on("pageerror", lambda error: problems.append(str(error)))
    page.goto(address)
    page.wait_for_selector(".plc-status-value[data-value]")
    assert problems == []
    return page


def lamp(page: Page, address: str) -> str:
    return page.locator(f".plc-lamp:has(.plc-address:text-is('{address}')) .plc-lamp-bulb").inner_text()


def until(page: Page, address: str, value: str) -> None:
    page.wait_for_function(
        """([address, value]) => [...document.querySelectorAll('.plc-lamp')].some((one) =>
          one.querySelector('.plc-address').textContent === address && one.querySelector('.plc-lamp-bulb').textContent === value)""",
        arg=[address, value],
    )


def push(page: Page, number: int) -> Any:
    return page.locator(".plc-live-push").nth(number)


def hold(page: Page, number: int, ms: int = 150) -> None:
    box = push(page, number).bounding_box()
    assert box
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.wait_for_timeout(ms)
    page.mouse.up()


def test_a_button_that_is_held_for_a_moment_starts_what_seals_itself_in(bench: tuple[Page, Session]) -> None:
    page, session = bench
    page.locator(".plc-live-run").click()
    hold(page, 0)
    until(page, "Q0.0", "1")
    page.wait_for_timeout(1_300)
    assert push(page, 0).get_attribute("data-value") == "0", "the button is up again"
    assert lamp(page, "Q0.0") == "1"
    assert session.live.trace()["Q0.1"].count("01") >= 1
    hold(page, 1)
    until(page, "Q0.0", "0")
    trace = session.live.trace()
    stopped = trace["I0.1"].index("1")
    assert trace["Q0.0"][stopped] == trace["Q0.1"][stopped] == "0", "all off in the scan that sees the button"


def test_no_request_no_run_and_the_pause_button_means_it(bench: tuple[Page, Session]) -> None:
    page, session = bench
    page.wait_for_timeout(300)
    assert session.live.scans == 1
    page.locator(".plc-live-run").click()
    page.wait_for_timeout(500)
    page.locator(".plc-live-run").click()
    page.wait_for_timeout(200)
    ran = session.live.scans
    assert ran > 10
    page.wait_for_timeout(400)
    assert session.live.scans == ran
    page.locator(".plc-live-scan").click()
    page.wait_for_function("(scans) => window.answers.at(-1)[2] === scans", arg=ran + 1)


def test_a_frozen_scan_is_stepped_through_and_let_go_again(bench: tuple[Page, Session]) -> None:
    page, session = bench
    page.locator(".plc-live-run").click()
    page.locator(".plc-live-latch").first.click()
    until(page, "Q0.0", "1")
    page.locator(".plc-live-freeze").click()
    page.wait_for_selector(".plc-live-stage .plc-player")
    frozen = session.live.scans
    for _ in range(5):
        page.keyboard.press("ArrowRight")
    assert page.locator(".plc-live-stage [aria-current=step]").get_attribute("data-line") == "4"
    assert page.locator(".plc-live-stage .plc-cell.plc-one").count() >= 1
    assert session.live.scans == frozen
    page.locator(".plc-live-freeze").click()
    page.wait_for_timeout(400)
    assert session.live.scans > frozen
    assert not page.locator(".plc-live-stage").is_visible()


def test_the_past_can_be_looked_at_again_up_to_the_moment_of_the_press(bench: tuple[Page, Session]) -> None:
    page, session = bench
    page.locator(".plc-live-run").click()
    page.wait_for_timeout(400)
    hold(page, 0, 120)
    until(page, "Q0.0", "1")
    page.wait_for_timeout(300)
    page.locator(".plc-live-run").click()
    page.wait_for_timeout(200)
    pressed = session.live.trace()["I0.0"].index("1")
    slider = page.locator(".plc-seek input")
    for scan, value in ((pressed - 1, "0"), (pressed, "1")):
        slider.evaluate(
            "(one, scan) => { one.value = scan; one.dispatchEvent(new Event('input', {bubbles: true})); }", scan
        )
        page.wait_for_function(
            "(words) => document.querySelector('.plc-count').textContent.includes(words)", arg=f"scan {scan + 1}"
        )
        assert lamp(page, "Q0.0") == value
        assert push(page, 0).locator(".plc-live-value").inner_text() == value
    assert page.locator("tr[data-line='3'] .plc-status-value").first.inner_text() == "1"
    assert "I0.0 1" in str(page.locator("svg.plc-live-chart").get_attribute("aria-label"))


def test_everything_can_be_done_with_the_keys(bench: tuple[Page, Session]) -> None:
    page, session = bench
    page.locator(".plc-live-run").focus()
    page.keyboard.press("Space")
    page.keyboard.down("1")
    until(page, "Q0.0", "1")
    page.keyboard.up("1")
    page.wait_for_timeout(200)
    assert push(page, 0).get_attribute("data-value") == "0"
    push(page, 1).focus()
    page.keyboard.down("Space")
    until(page, "Q0.0", "0")
    page.keyboard.up("Space")
    assert session.live.held["I0.1"] in {0, 1}


def test_panels_fold_away_and_more_levels_can_be_shown(bench: tuple[Page, Session]) -> None:
    page, _ = bench
    assert page.locator("tr[data-line='0'] .plc-status-value").count() == 2
    page.locator(".plc-live-levels select").select_option("4")
    assert page.locator("tr[data-line='0'] .plc-status-value").count() == 5
    page.locator(".plc-live-panel.plc-live-ladder > summary").click()
    assert not page.locator(".plc-rung").first.is_visible()


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [360, 1920])
def test_the_bench_is_accessible_and_never_wider_than_the_window(chromium: Browser, width: int, theme: str) -> None:
    with served(read(SEAL_IN, "s7-200"), lang="zh") as (address, _):
        page = opened(chromium, address, viewport={"width": width, "height": 900}, color_scheme=theme)
        page.locator(".plc-live-run").click()
        page.locator(".plc-live-latch").first.click()
        until(page, "Q0.0", "1")
        page.locator(".plc-live-run").click()
        page.wait_for_timeout(200)
        assert axe(page, ".plc-livebench") == []
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        page.context.close()


def test_the_drilling_head_runs_its_whole_cycle_and_comes_home(chromium: Browser) -> None:
    there = plant("drilling-head")
    sample = there.reference
    with served(read(sample.text, sample.family), Model(there.for_(sample))) as (address, session):
        page = opened(chromium, address)
        page.locator(".plc-speed").last.select_option("5")
        page.locator(".plc-live-run").click()
        hand = page.locator(".plc-plant-hand").first.bounding_box()
        assert hand
        page.mouse.move(hand["x"] + hand["width"] / 2, hand["y"] + hand["height"] / 2)
        page.mouse.down()
        page.wait_for_timeout(200)
        page.mouse.up()
        words = "() => [...document.querySelectorAll('.plc-plant-picture text')].map((one) => one.textContent).find((text) => text.endsWith(' mm'))"
        seen: list[int] = []
        for _ in range(120):
            seen.append(int(str(page.evaluate(words)).split()[0]))
            if max(seen) > 50 and seen[-1] <= HOME:
                break
            page.wait_for_timeout(100)
        assert max(seen) > 50
        assert seen[-1] <= HOME, "it is home again"
        assert session.watch.found() == []
        assert page.locator(".plc-live-faults p").count() == 0
        assert axe(page, ".plc-livebench") == []
        page.context.close()


def test_a_fault_of_the_plant_is_reported_in_words(chromium: Browser) -> None:
    there = plant("star-delta")
    sample = next(one for one in there.samples if one.role == "wrong")
    with served(read(sample.text, sample.family), Model(there.for_(sample)), lang="zh") as (address, session):
        page = opened(chromium, address)
        page.locator(".plc-speed").last.select_option("5")
        page.locator(".plc-live-run").click()
        page.locator(".plc-live-push").first.focus()
        page.keyboard.down("Space")
        page.wait_for_timeout(100)
        page.keyboard.up("Space")
        page.wait_for_selector(".plc-live-faults p", timeout=15_000)
        said = page.locator(".plc-live-faults p").first.inner_text()
        assert said.strip() == session.watch.found()[0]["zh"]
        page.context.close()


def test_what_was_done_is_replayed_scan_for_scan_and_taken_over(bench: tuple[Page, Session]) -> None:
    page, session = bench
    page.locator(".plc-live-run").click()
    hold(page, 0, 120)
    until(page, "Q0.0", "1")
    page.wait_for_timeout(700)
    page.locator(".plc-live-run").click()
    page.wait_for_timeout(200)
    first, text = session.live.trace(), session.live.timeline()
    assert "= Q0.0: " in text
    page.locator(".plc-speed").last.select_option("5")
    page.locator(".plc-live-replay").click()
    page.wait_for_selector(".plc-live-tape:not([hidden])")
    assert push(page, 0).is_disabled()
    page.wait_for_selector(".plc-live-taped-over")
    again = session.live.trace()
    assert again.starts == first.starts
    assert all(again[one] == first[one] for one in ("I0.0", "I0.1", "Q0.0", "Q0.1", "VW0"))
    assert "as recorded" in page.locator(".plc-live-tape-words").inner_text()
    assert axe(page, ".plc-livebench") == []
    page.locator(".plc-live-hand").click()
    page.wait_for_selector(".plc-live-tape", state="hidden")
    page.locator(".plc-live-run").click()
    hold(page, 1)
    until(page, "Q0.0", "0")
    assert session.live.scans > len(first.starts)


def test_a_file_is_replayed_paused_stepped_looked_back_at_and_a_difference_is_said(bench: tuple[Page, Session]) -> None:
    page, session = bench
    text = "I0.0: 0.2s off, on\n= Q0.0: 0.2s off, 4s on\n= Q0.1: 9s off"
    page.locator(".plc-live-tape-words").wait_for(state="hidden")
    with page.expect_file_chooser() as chooser:
        page.locator(".plc-live-load").click()
    chooser.value.set_files({"name": "timeline.txt", "mimeType": "text/plain", "buffer": text.encode()})
    until(page, "Q0.0", "1")
    page.locator(".plc-live-run").click()
    page.wait_for_timeout(200)
    ran = session.live.scans
    page.locator(".plc-live-scan").click()
    page.wait_for_function("(scans) => window.answers.at(-1)[2] === scans", arg=ran + 1)
    slider = page.locator(".plc-seek input")
    slider.evaluate("(one) => { one.value = 5; one.dispatchEvent(new Event('input', {bubbles: true})); }")
    page.wait_for_function("() => document.querySelector('.plc-count').textContent.includes('scan 6')")
    assert lamp(page, "Q0.0") == "0"
    page.locator(".plc-speed").last.select_option("5")
    page.locator(".plc-live-run").click()
    page.wait_for_selector(".plc-live-taped-over")
    said = page.locator(".plc-live-faults p").inner_text().strip()
    assert said == session.live.differs[0].text.en
    assert said.startswith("0.70 s (scan 71): Q0.1 was 0"), "the flasher comes 0.5 s after the button"
    page.locator(".plc-live-hand").click()
    page.wait_for_selector(".plc-live-tape", state="hidden")
    assert page.locator(".plc-live-latch").first.get_attribute("aria-checked") == "true", "what was on stays on"


def test_a_file_that_cannot_be_read_is_answered_in_words(bench: tuple[Page, Session]) -> None:
    page, session = bench
    with page.expect_file_chooser() as chooser:
        page.locator(".plc-live-load").click()
    chooser.value.set_files({"name": "timeline.txt", "mimeType": "text/plain", "buffer": b"I0.0: soon"})
    page.wait_for_function("() => document.querySelector('.plc-live-note').textContent.includes('row 1')")
    assert session.live.tape is None


def test_a_switch_that_no_input_sees_is_replayed_too(chromium: Browser) -> None:
    there = plant("reject-conveyor")
    sample = there.reference
    with served(read(sample.text, sample.family), Model(there.for_(sample))) as (address, session):
        page = opened(chromium, address)
        page.locator(".plc-live-run").click()
        page.locator("[data-part='W-']").click()
        page.wait_for_timeout(400)
        page.locator(".plc-live-run").click()
        page.wait_for_timeout(200)
        model = session.watch.model
        assert model is not None
        assert "@W: " in session.live.timeline()
        was = model.moment()
        page.locator(".plc-live-replay").click()
        page.wait_for_selector(".plc-live-taped-over")
        assert model.moment() == was, "the whole plant is where it was"
        page.context.close()


def test_a_switch_of_the_plant_stays_where_it_is_turned_to(chromium: Browser) -> None:
    there = plant("reject-conveyor")
    sample = there.reference
    with served(read(sample.text, sample.family), Model(there.for_(sample))) as (address, session):
        page = opened(chromium, address)
        model = session.watch.model
        assert model is not None
        page.locator("[data-part='W-']").click()
        page.wait_for_timeout(300)
        assert model.bits["W"] is True
        page.locator("[data-part='W+']").press("Space")
        page.wait_for_timeout(300)
        assert model.bits["W"] is False
        assert axe(page, ".plc-livebench") == []
        page.context.close()
