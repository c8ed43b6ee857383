"""What a learner does in a test is kept in a file of that test."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture(autouse=True)
def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    path = tmp_path / ".plcteach-progress.json"
    monkeypatch.setenv("PLCTEACH_PROGRESS", str(path))
    return path
