"""The exercise desk in a real JupyterLab: from a wrong answer to full marks and back after a reload; every form by keyboard alone."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import nbformat
import pytest
from labpage import READY, STATE, axe, open_notebook, run_all

from plcteach.check.judge import model
from plcteach.exercises import exercise, ids

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from playwright.sync_api import Browser, Page

WRONG, RIGHT = "LD X0\nANI X1\nOUT Y0\n", "LD X0\nOR Y0\nANI X1\nOUT Y0\n"
KERNEL = "window.jupyterapp.shell.currentWidget.sessionContext.session.kernel"
EDITOR = ".plc-editor .cm-content"
FIRST = {
    kind: next(name for name in ids() if exercise(name).kind == kind)
    for kind in ("order", "predict", "join", "match", "chart")
}


def notebook(folder: Path, name: str, *cells: str, lang: str = "en") -> str:
    book = nbformat.v4.new_notebook()
    book.cells = [nbformat.v4.new_code_cell(one) for one in (f"import plcteach as plc\nplc.language('{lang}')", *cells)]
    book.metadata = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    (folder / "desks").mkdir(exist_ok=True)
    nbformat.write(book, folder / "desks" / name)
    return f"desks/{name}"


def opened(chromium: Browser, lab: tuple[str, Path], name: str, cell: str, **options: object) -> Page:
    address, folder = lab
    page = open_notebook(
        chromium, address, notebook(folder, name, cell, lang=str(options.pop("lang", "en"))), **options
    )
    run_all(page)
    page.wait_for_selector(".plc-desk", timeout=60_000)
    page.wait_for_timeout(800)
    return page


@pytest.fixture
def kept(lab: tuple[str, Path]) -> Iterator[Path]:
    """The file beside the notebooks of these tests; each test begins without it."""
    path = lab[1] / "desks" / ".plcteach-progress.json"
    path.unlink(missing_ok=True)
    yield path
    path.unlink(missing_ok=True)


def press(page: Page, name: str) -> None:
    page.get_by_role("button", name=name, exact=True).first.click()


def told(page: Page, words: str) -> None:
    page.wait_for_function(
        "words => document.querySelector('.plc-verdict-headline')?.textContent.includes(words)",
        arg=words,
        timeout=15_000,
    )


def editor_text(page: Page) -> str:
    return "\n".join(page.locator(f"{EDITOR} .cm-line").all_inner_texts()).strip()


def test_from_a_wrong_answer_to_full_marks_and_still_there_after_a_reload(
    chromium: Browser, lab: tuple[str, Path], kept: Path
) -> None:
    page = opened(chromium, lab, "lifecycle.ipynb", "plc.desk('fx-start-stop')")
    page.locator(EDITOR).first.click()
    page.keyboard.type(WRONG)
    press(page, "Check")
    told(page, "Y0 should be 1; your program gives 0")
    chart = page.locator(".plc-example svg")
    assert "Y0" in chart.evaluate("one => one.textContent")
    press(page, "Show me")
    page.wait_for_selector(".plc-show-other .plc-player", timeout=15_000)
    assert "ANI X1" in page.locator(".plc-show-say").inner_text()
    now = page.locator(".plc-player [aria-current=step]").all_inner_texts()
    assert ["".join(one.split()) for one in now] == ["2ANIX1", "2ORY0"], "both stand where they part"
    assert "ANI X1" in page.locator(".plc-editor-now").inner_text()
    press(page, "First hint")
    page.wait_for_selector(".plc-hints li", timeout=15_000)
    press(page, "Next hint")
    page.wait_for_function("document.querySelectorAll('.plc-hints li').length === 2", timeout=15_000)
    assert axe(page, ".plc-root, .plc-desk") == []
    page.locator(EDITOR).first.click()
    page.keyboard.press("Control+a")
    page.keyboard.type(RIGHT)
    page.keyboard.press("Control+Enter")
    told(page, "Correct, 4 of 4")
    assert page.locator(".plc-kept").inner_text().replace("\n", " ") == "checked 2× best mark 4 / 4 hints used: 2"
    assert page.evaluate(STATE)["cells"] == 2, "no key of the desk has acted on the notebook"
    page.close()

    page = open_notebook(chromium, lab[0], "desks/lifecycle.ipynb")
    run_all(page)
    page.wait_for_selector(EDITOR, timeout=60_000)
    page.wait_for_timeout(800)
    assert editor_text(page) == RIGHT.strip()
    assert "best mark 4 / 4" in page.locator(".plc-kept").inner_text()
    page.evaluate(f"{KERNEL}.restart()")
    page.wait_for_timeout(3000)
    run_all(page)
    page.wait_for_function("document.querySelector('.plc-kept')?.textContent.includes('best mark')", timeout=60_000)
    assert editor_text(page) == RIGHT.strip()
    assert json.loads(kept.read_text(encoding="utf-8"))["exercises"]["fx-start-stop"]["attempts"] == 2
    page.close()


def test_what_is_typed_while_the_kernel_is_gone_is_offered_when_it_is_back(
    chromium: Browser, lab: tuple[str, Path], kept: Path
) -> None:
    address, folder = lab
    name = notebook(folder, "gone.ipynb", "plc.desk('fx-one-contact')")
    context = chromium.new_context(viewport={"width": 1300, "height": 1000})
    page = context.new_page()
    page.goto(f"{address}/lab/tree/{name}?reset")
    page.wait_for_function(READY, timeout=90_000)
    run_all(page)
    page.wait_for_selector(EDITOR, timeout=60_000)
    page.wait_for_timeout(800)
    page.evaluate("window.jupyterapp.shell.currentWidget.sessionContext.shutdown()")
    page.wait_for_timeout(1500)
    page.locator(EDITOR).first.click()
    page.keyboard.type("LD X5 // nobody listens")
    page.wait_for_timeout(600)
    page.close()
    assert not kept.exists()
    page = context.new_page()
    page.goto(f"{address}/lab/tree/{name}?reset")
    page.wait_for_function(READY, timeout=90_000)
    run_all(page)
    page.wait_for_selector(".plc-draft:not([hidden])", timeout=60_000)
    press(page, "Restore the draft")
    page.wait_for_timeout(800)
    assert editor_text(page) == "LD X5 // nobody listens"
    assert "nobody listens" in kept.read_text(encoding="utf-8")
    page.close()
    context.close()


def fill(page: Page, kind: str) -> None:
    """Give the right answer with the keyboard alone."""
    one = exercise(FIRST[kind])
    answer = model(one)
    if kind == "match":
        page.locator("input[type=radio]").first.focus()
        for _ in range(ord(answer) - ord("A")):
            page.keyboard.press("ArrowDown")
        if answer == "A":
            page.keyboard.press("Space")
    elif kind == "join":
        for number in answer.replace("-", " ").split():
            page.locator(f"[data-key='b{number}']").focus()
            page.keyboard.press("Enter")
    elif kind == "order":
        for line in answer.strip().split("\n"):
            page.locator(".plc-tray .plc-line-text").filter(has_text=line).first.focus()
            page.keyboard.press("Enter")
    else:
        rows = [row.split() for row in answer.strip().split("\n")]
        signs = ["".join(row[1:]) if kind == "chart" else "".join(row) for row in rows]
        page.locator("[data-key='c0-0']").focus()
        for sign in "".join(signs):
            page.keyboard.press(sign)


@pytest.mark.parametrize("kind", FIRST)
def test_every_form_takes_an_answer_from_the_keyboard_and_keeps_it(
    chromium: Browser, lab: tuple[str, Path], kept: Path, kind: str
) -> None:
    page = opened(chromium, lab, f"{kind}.ipynb", f"plc.desk('{FIRST[kind]}')")
    before = page.evaluate(STATE)
    fill(page, kind)
    page.keyboard.press("Control+Enter")
    told(page, "Correct")
    assert page.evaluate(STATE)["cells"] == before["cells"]
    assert axe(page, ".plc-desk") == []
    press(page, "Model answer")
    page.wait_for_selector(".plc-model:not([hidden])", timeout=15_000)
    assert axe(page, ".plc-desk") == []
    row = json.loads(kept.read_text(encoding="utf-8"))["exercises"][FIRST[kind]]
    assert (row["best"], row["attempts"], row["model"]) == (exercise(FIRST[kind]).points, 1, True)
    page.close()


@pytest.mark.usefixtures("kept")
def test_lines_are_dragged_out_of_the_tray_and_back(chromium: Browser, lab: tuple[str, Path]) -> None:
    page = opened(chromium, lab, "drag.ipynb", f"plc.desk('{FIRST['order']}')")
    lines = [page.locator(".plc-tray .plc-line-text").nth(at).inner_text() for at in (0, 1)]
    for at in range(2):
        page.locator(".plc-tray .plc-line-text").first.drag_to(
            page.locator(".plc-rows:not(.plc-tray) li").first, target_position={"x": 20, "y": 2}
        )
        page.wait_for_function(
            "count => document.querySelectorAll('.plc-rows:not(.plc-tray) .plc-line-text').length === count", arg=at + 1
        )
    used = page.locator(".plc-rows:not(.plc-tray) .plc-line-text")
    assert used.all_inner_texts() == lines[::-1], "each was let go above the first"
    used.first.focus()
    page.keyboard.press("Alt+ArrowDown")
    assert used.all_inner_texts() == lines
    used.first.drag_to(page.locator(".plc-tray"))
    assert used.all_inner_texts() == lines[1:]
    page.keyboard.press("Control+z")
    assert used.all_inner_texts() == lines
    page.close()


@pytest.mark.usefixtures("kept")
@pytest.mark.parametrize(("width", "lang"), [(360, "zh"), (1920, "en")])
def test_a_desk_fits_a_phone_and_a_wide_screen(chromium: Browser, lab: tuple[str, Path], width: int, lang: str) -> None:
    cell = f"display(*map(plc.desk, {[FIRST['predict'], FIRST['order'], FIRST['chart']]}))"
    page = opened(chromium, lab, f"fits-{width}.ipynb", cell, lang=lang, viewport={"width": 1920, "height": 900})
    page.add_style_tag(
        content=f".jp-OutputArea-output {{ max-width: {width}px !important; flex: 0 0 {width}px !important; }}"
    )
    page.wait_for_timeout(300)
    wide = page.evaluate("[...document.querySelectorAll('.plc-desk')].map((one) => one.scrollWidth - one.clientWidth)")
    assert len(wide) == 3
    assert max(wide) <= 1
    assert axe(page, ".plc-desk") == []
    page.close()


def test_the_concept_test_is_taken_twice_and_compared(chromium: Browser, lab: tuple[str, Path], kept: Path) -> None:
    page = opened(chromium, lab, "quiz.ipynb", "plc.concept_test()")
    assert axe(page, ".plc-quiz") == []
    for number in range(2, 13):
        press(page, "Next")
        page.wait_for_selector(f".plc-quiz-number[aria-current]:text-is('{number}')", timeout=15_000)
    words = page.locator(".plc-quiz button").all_inner_texts()
    assert not {"Check", "First hint", "after each row"} & set(words), "a test tells nothing"
    press(page, "Finish")
    page.get_by_role("button", name="Take it again").click(timeout=15_000)
    page.wait_for_selector("text=after the course", timeout=15_000)
    press(page, "Finish")
    page.wait_for_selector(".plc-quiz-table", timeout=15_000)
    assert page.locator(".plc-quiz-table tbody tr").count() == 12
    assert axe(page, ".plc-quiz") == []
    assert json.loads(kept.read_text(encoding="utf-8"))["tests"]["concept"]["after"]["done"] is True
    page.close()
