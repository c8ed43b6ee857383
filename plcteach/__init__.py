"""plcteach teaches how a PLC computes: instruction lists beside their stack, ladders beside their lists, proofs for marks.

    import plcteach as plc

    plc.play("LD I0.0; A I0.1; LD I0.2; A I0.3; OLD; = Q0.0", inputs={"I0.2": 1, "I0.3": 1})

The words below are all a lesson needs. Each is found when it is first used, so that importing plcteach costs next to nothing
and everything but the widgets and matplotlib's ink works on plain Python.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

_WORDS = {
    "read": "stl",
    "write": "stl",
    "read_symbols": "stl",
    "run": "figure.running",
    "lint": "check.lint",
    "compare": "check.same",
    "judge": "check.judge",
    "grade": "check.score",
    "drill": "check.drill",
    "table": "figure.running",
    "illustrate": "figure.running",
    "strip": "figure.verbs",
    "draw": "figure.ladders",
    "lift": "figure.ladders",
    "lower": "ladder.verbs",
    "translate": "ladder.verbs",
    "chart": "figure.verbs",
    "face": "figure.verbs",
    "replay": "figure.replaying",
    "drive": "figure.driving",
    "explain": "check.manual",
    "play": "widgets.verbs",
    "families": "widgets.verbs",
    "bench": "widgets.verbs",
    "live": "widgets.verbs",
    "desk": "widgets.verbs",
    "progress": "widgets.progress",
    "concept_test": "widgets.quiz",
    "language": "core.text",
}

__all__ = list(_WORDS)
__version__ = "0.1.0"


def __getattr__(name: str) -> Any:
    if name not in _WORDS:
        msg = f"module 'plcteach' has no attribute {name!r}"
        raise AttributeError(msg)
    return getattr(import_module(f"plcteach.{_WORDS[name]}"), name)


def load_ipython_extension(shell: Any) -> None:
    """Give a notebook the magic %%stl, on `%load_ext plcteach`."""
    import_module("plcteach.check.marking.magic").load(shell)


def __dir__() -> list[str]:
    return sorted(_WORDS)
