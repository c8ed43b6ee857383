"""What a translation gives: the text in the other family, its program, the table of addresses, and what there is to say."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

from plcteach.core.text import Text, language

if TYPE_CHECKING:
    from plcteach.core.program import Program

_NOTE = Text("注意：", "note: ")


@dataclass(frozen=True, slots=True)
class Translation:
    """The text in the other family, the program that it reads as, the table of addresses, and what there is to say.

    addresses: for each address of the source what takes its place, in order of first appearance; `/` before it: its inverse.
    """

    text: str
    program: Program
    addresses: dict[str, str]
    notes: tuple[Text, ...]

    def __repr__(self) -> str:
        said = "".join(f"\n// {_NOTE.in_(language())}{one.in_(language())}" for one in self.notes)
        return self.text.rstrip("\n") + said

    def _repr_html_(self) -> str:
        notes = "".join(f"<li>{escape(one.in_(language()))}</li>" for one in self.notes)
        return f"<pre>{escape(self.text)}</pre>" + (f"<ul>{notes}</ul>" if notes else "")
