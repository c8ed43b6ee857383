"""Puts the browser's modules together: one script from plain ES modules, in the order in which they import each other."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from plcteach.core.text import Text

FOOT = Text("这是教学用的模型，不是真实的PLC。", "This is a model for teaching, not the hardware.")
"""What stands at the foot of every page that leaves the house."""

STATIC = Path(__file__).parent / "static"

_IMPORT = re.compile(r'^import [^\n]*?from "\./(?P<name>[\w./-]+)";\n', re.MULTILINE)
_EXPORT = re.compile(r"^export (?=(?:async )?(?:const|let|function|class)\b)", re.MULTILINE)
_EXPORT_LIST = re.compile(r"^export \{[^}]*\};\n?", re.MULTILINE)


@cache
def script(name: str) -> str:
    """Give a module and all it imports as one script without imports or exports; top-level names are unique by design."""
    return "\n".join(_plain(one) for one in _order(name))


@cache
def styles(*names: str) -> str:
    """Give style sheets, one after the other."""
    return "\n".join((STATIC / name).read_text(encoding="utf-8") for name in names)


def _order(name: str) -> list[str]:
    """List a module's imports before it, each once."""
    found: list[str] = []

    def visit(one: str) -> None:
        if one in found:
            return
        for match in _IMPORT.finditer((STATIC / one).read_text(encoding="utf-8")):
            visit(match["name"])
        found.append(one)

    visit(name)
    return found


def _plain(name: str) -> str:
    text = (STATIC / name).read_text(encoding="utf-8")
    text = _EXPORT_LIST.sub("", _IMPORT.sub("", text))
    return _EXPORT.sub("", text)
