"""The tools that read the code, the browser's own tests, and the notebooks: run here, so that one command runs everything."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
SCRIPTS = Path(sys.executable).parent


def run(*command: str | Path) -> str:
    environment = {name: value for name, value in os.environ.items() if name not in {"LANG", "LC_ALL", "PLCTEACH_LANG"}}
    environment["PLCTEACH_PROGRESS"] = str(Path(tempfile.gettempdir()) / f"plcteach-progress-{os.getpid()}.json")
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False, env=environment)
    assert done.returncode == 0, f"{done.stdout[-6000:]}\n{done.stderr[-3000:]}"
    return done.stdout


def test_ruff_has_nothing_to_remark() -> None:
    run(SCRIPTS / "ruff", "check", "plcteach", "tests")


def test_the_code_is_formatted() -> None:
    run(SCRIPTS / "ruff", "format", "--check", "plcteach", "tests")


def test_the_types_hold_strictly() -> None:
    assert "no issues found" in run(SCRIPTS / "mypy")


def test_the_browsers_pure_parts() -> None:
    node = shutil.which("node")
    if node is None:
        if os.environ.get("PLCTEACH_BROWSER") == "required":
            pytest.fail("node is required here and was not found: install the package nodejs")
        pytest.skip("node was not found: install the package nodejs to run the browser's own tests")
    tests = sorted(str(path) for path in (ROOT / "tests" / "js").glob("*.test.mjs"))
    out = run(node, "--test", "--test-reporter=tap", *tests)
    assert "# fail 0" in out
    assert int(out.split("# pass ")[1].split()[0]) > 40


def test_the_notebooks_give_what_they_show() -> None:
    notebooks = sorted(
        str(path)
        for path in (ROOT / "notebooks").rglob("*.ipynb")
        if not {".ipynb_checkpoints", "course"} & {*path.relative_to(ROOT).parts}
    )
    sanitize = ROOT / "tests" / "notebooks" / "sanitize.cfg"
    out = run(
        sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-W", "ignore", "--nbval", f"--nbval-sanitize-with={sanitize}", *notebooks
    )  # fmt: skip
    assert "passed" in out
