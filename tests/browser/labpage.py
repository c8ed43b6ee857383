"""What the browser tests do in a page: open a notebook, run it, and look."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import axe_playwright_python

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

AXE = next(Path(axe_playwright_python.__file__).parent.glob("**/axe.min.js")).read_text(encoding="utf-8")
READY = """(() => {
  const panel = window.jupyterapp && window.jupyterapp.shell && window.jupyterapp.shell.currentWidget;
  const kernel = panel && panel.sessionContext && panel.sessionContext.session && panel.sessionContext.session.kernel;
  return Boolean(kernel && kernel.connectionStatus === 'connected' && document.querySelector('.jp-NotebookPanel .jp-Cell'));
})()"""
STATE = """(() => {
  const notebook = window.jupyterapp.shell.currentWidget.content;
  return { cells: notebook.widgets.length, active: notebook.activeCellIndex, mode: notebook.mode };
})()"""


def open_notebook(browser: Browser, address: str, name: str, **page_options: Any) -> Page:
    """Open a notebook in JupyterLab and wait for its kernel."""
    options = {"viewport": {"width": 1300, "height": 1000}, **page_options}
    page = browser.new_page(**options)
    page.goto(f"{address}/lab/tree/{name}?reset")
    page.wait_for_function(READY, timeout=90_000)
    return page


def run_all(page: Page) -> None:
    page.evaluate("window.jupyterapp.commands.execute('notebook:run-all-cells')")


def axe(page: Page, selector: str) -> list[str]:
    """Give the accessibility violations below a selector, each with the first element that has it."""
    page.evaluate(AXE)
    found = page.evaluate("selector => axe.run(selector, {resultTypes: ['violations']})", selector)
    return [f"{one['id']} ({one['impact']}): {one['nodes'][0]['html'][:200]}" for one in found["violations"]]
