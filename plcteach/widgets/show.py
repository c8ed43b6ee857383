"""What all our widgets share: a deterministic word for themselves, and a picture for pages without a kernel."""

from __future__ import annotations

from html import escape
from typing import Any

import anywidget
import traitlets

from plcteach.core.text import language
from plcteach.figure.page import script, styles


def module(name: str) -> str:
    """Give a widget's browser module: our scripts in order, and the default export that anywidget wants."""
    return f"{script(name)}\nexport default {{ render }};\n"


class Shown(anywidget.AnyWidget):
    """A widget that says what it shows, the same words on every run, and leaves a still picture in a saved notebook."""

    language = traitlets.Unicode("en").tag(sync=True)
    size = traitlets.Float(1.0).tag(sync=True)

    def __init__(self, **values: Any) -> None:
        values.setdefault("language", language())
        super().__init__(**values)

    def _words(self) -> str:
        """Say in one line what is shown."""
        return type(self).__name__

    def _still(self) -> str:
        """Give HTML for an untrusted or printed notebook; every word from a learner escaped."""
        return f"<pre>{escape(self._words())}</pre>"

    def __repr__(self) -> str:
        return self._words()

    def _repr_mimebundle_(self, **asked: Any) -> Any:
        bundle = super()._repr_mimebundle_(**asked)
        data, metadata = bundle if isinstance(bundle, tuple) else (bundle or {}, {})
        return {**data, "text/plain": self._words(), "text/html": self._still()}, metadata


__all__ = ["Shown", "module", "styles"]
