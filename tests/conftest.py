"""The files of tests that take longest begin first, so that two workers end at the same time."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pytest

LONGEST_FIRST = ("tests/test_tools.py", "tests/browser/", "tests/test_hostile.py", "tests/ladder/", "tests/figure/")


def pytest_configure(config: pytest.Config) -> None:
    """Let xdist hand the files out in this order; by itself it begins with those that hold most tests."""
    if hasattr(config.option, "loadscopereorder"):
        config.option.loadscopereorder = False


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put the long files before the others; within a file nothing changes."""
    items.sort(
        key=lambda item: next(
            (at for at, where in enumerate(LONGEST_FIRST) if item.nodeid.startswith(where)), len(LONGEST_FIRST)
        )
    )
