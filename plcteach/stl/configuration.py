"""Reads the lines that configure function blocks before the first rung, such as `%TM0: TYPE=TON TB=10ms P=100 ADJ=N`.

The vendor's software keeps this in dialogues; as lines of the list it can be read, compared and taught.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from plcteach.core.area import Address, Area
from plcteach.core.text import Text, same
from plcteach.stl.expression import inside, joined
from plcteach.stl.words import Word

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.core.block import Block, Setting
    from plcteach.stl.operands import Operands

Said = int | str | tuple[str, ...]

_LINE = re.compile(r"(?P<block>%[A-Za-z]{1,4}[0-9]{1,9})\s*:(?![Xx][0-9])(?P<rest>.*)")
_NAME = re.compile(r"(?P<name>[A-Za-z]\w*)\s*=\s*")
_VALUES = re.compile(r"[^\s,]+")
_NUMBER = re.compile(r"[+-]?[0-9]{1,9}")
_ROW = re.compile(r"[01]{1,16}")
VALUE = ""
"""The name under which a constant word's number stands in the settings."""


class Configuration:
    """Everything that configuration lines say: for each block its settings, and the lines in canonical spelling."""

    def __init__(self, operands: Operands) -> None:
        self.operands = operands
        self.dialect = operands.dialect
        self.settings: dict[str, dict[str, Said]] = operands.settings
        self.lines: list[str] = []
        self.rows: dict[str, int] = {}

    def takes(self, words: list[Word]) -> bool:
        """Say whether a statement is a configuration line: a block's address and a colon."""
        configured = any(block.settings for block in self.dialect.blocks)
        return configured and words[0].text.startswith("%") and bool(_LINE.fullmatch(joined(words[:2]).text))

    def line(self, words: list[Word], *, late: bool) -> None:
        """Read one line; `late`: a rung stands above it."""
        whole = joined(words)
        match = _LINE.fullmatch(whole.text)
        if match is None:
            return
        word = Word(match["block"].upper(), inside(whole, *match.span("block")))
        place = self.place(word)
        if place is None:
            return
        if late:
            self.operands.say("CFG004", whole.span, block=place.text)
        elif place.text in self.rows:
            self.operands.say("CFG005", whole.span, word=place.text, row=self.rows[place.text])
        else:
            self.rows[place.text] = whole.span.row
            self.keep(place, self.said(place, whole, match.start("rest")))

    def place(self, word: Word) -> Address | None:
        """Give the block or constant word that a line is about."""
        found = self.dialect.address(word.text)
        if isinstance(found, Area):
            ends = {"first": found.first, "last": found.last}
            self.operands.say("RDR006", word.span, word=word.shown, area=found.title, **ends, note="")
            return None
        block = self.dialect.block(found) if found else None
        if found is None or not (self.fixed(found) or (block and block.settings)):
            self.operands.say("CFG001", word.span, word=word.shown, expected=same(", ".join(self.kinds())))
            return None
        return found

    def fixed(self, place: Address) -> bool:
        """Say whether an address is a word that no instruction can write."""
        wide = [kind for kind in self.dialect.kinds.values() if kind.size > 1]
        return place.size > 1 and not place.field and all(kind.constant for kind in wide if place.area in kind.areas)

    def kinds(self) -> list[str]:
        """Give the first address of every kind of thing that can be configured."""
        blocks = [self.dialect.areas[at].first for at, _ in enumerate(self.dialect.areas) if self._configured(at)]
        return [f"{first}:" for first in blocks]

    def _configured(self, at: int) -> bool:
        place = self.dialect.areas[at].address(0)
        block = self.dialect.block(place)
        return self.fixed(place) or bool(block and block.settings)

    def said(self, place: Address, whole: Word, at: int) -> dict[str, Said] | None:
        """Read what a line says of its block; None where something could not be read."""
        block = self.dialect.block(place)
        if block is None or block.settings is None:
            return self.constant(place, whole, at)
        heads = list(_NAME.finditer(whole.text, at))
        before = Word(whole.text[at : heads[0].start() if heads else None].strip(), inside(whole, at, len(whole.text)))
        names = same(", ".join(f"{name}=" for name in block.settings))
        if before.text or not heads:
            self.operands.say(
                "CFG001", before.span if before.text else whole.span, word=before.shown or ":", expected=names
            )
            return None
        found: dict[str, Said] = {}
        ends = [head.start() for head in heads[1:]] + [len(whole.text)]
        for head, end in zip(heads, ends, strict=True):
            name, span = head["name"].upper(), inside(whole, head.start(), end)
            values = [Word(one[0], inside(whole, *one.span())) for one in _VALUES.finditer(whole.text, head.end(), end)]
            if name not in block.settings:
                self.operands.say("CFG001", span, word=name, expected=names)
            elif name in found:
                self.operands.say("CFG005", span, word=f"{name}=", row=span.row)
            else:
                value = self.value(place, name, block.settings[name], values or [Word("", span)])
                found |= {} if value is None else {name: value}
        return self.whole(place, block, whole, found) if len(found) == len(heads) else None

    def constant(self, place: Address, whole: Word, at: int) -> dict[str, Said] | None:
        """Read the number of a constant word."""
        word = Word(whole.text[at:].strip(), inside(whole, at, len(whole.text)))
        kind = next(kind for kind in self.dialect.kinds.values() if kind.size > 1 and place.area in kind.areas)
        value = self.operands.constant(word.text, kind)
        if value is None or not self.operands.fits(value, kind):
            expected = Text("-32768到32767的整数", "a whole number from -32768 to 32767")
            self.operands.say("CFG002", word.span, name=place.text, word=word.shown, expected=expected)
            return None
        self.settings[place.text] = {VALUE: int(value.number)}
        self.lines.append(f"{place.text}: {value.text}")
        return None

    def value(self, place: Address, name: str, setting: Setting, words: Sequence[Word]) -> Said | None:
        """Read what stands behind one name."""
        first, last = words[0], words[-1]
        expected = self.expected(setting)
        if setting.list:
            return self.several(place, name, setting, words)
        found: Said | None
        if setting.choices:
            found = next((one for one in setting.choices if one.upper() == first.text.upper()), None)
        elif _NUMBER.fullmatch(first.text) and setting.first <= int(first.text) <= setting.last:
            found = int(first.text)
        else:
            found = None
        if found is None or len(words) > 1:
            self.refused(place, name, last, expected)
            return None
        return found

    def refused(self, place: Address, name: str, word: Word, expected: Text) -> None:
        """Say what was expected behind a name."""
        self.operands.say("CFG002", word.span, name=f"{name} ({place.text})", word=word.shown or "=", expected=expected)

    def expected(self, setting: Setting) -> Text:
        """Say what a setting may be."""
        if setting.choices:
            *most, last = setting.choices
            return Text(f"{'、'.join(most)}或{last}", f"{', '.join(most)} or {last}")
        return Text(f"{setting.first}到{setting.last}的整数", f"a whole number from {setting.first} to {setting.last}")

    def several(self, place: Address, name: str, setting: Setting, words: Sequence[Word]) -> tuple[str, ...] | None:
        """Read a drum's outputs or the rows of its steps."""
        if len(words) > setting.last:
            most = Text(f"最多{setting.last}个", f"at most {setting.last} of them")
            self.refused(place, name, words[setting.last], most)
            return None
        rows = [word.text if _ROW.fullmatch(word.text) else None for word in words]
        if name == "OUT":
            rows = [self.output(word) for word in words]
        for row, word in zip(rows, words, strict=True):
            if row is None:
                bits = Text("0和1组成的行，如0101", "a row of 0 and 1 such as 0101")
                self.refused(place, name, word, self.dialect.kinds["out"].title if name == "OUT" else bits)
                return None
        return tuple(row for row in rows if row is not None)

    def output(self, word: Word) -> str | None:
        """Read the address of a bit that a drum drives."""
        found = self.operands.place(word)
        fits = isinstance(found, Address) and found.size == 1 and found.area in self.dialect.kinds["out"].areas
        return found.text if isinstance(found, Address) and fits else None

    def whole(self, place: Address, block: Block, whole: Word, found: dict[str, Said]) -> dict[str, Said] | None:
        """Look at all settings of one line together: a drum wants its outputs and its steps, all rows equally long."""
        lists = [name for name, setting in (block.settings or {}).items() if setting.list]
        for name in lists:
            if name not in found:
                self.operands.say("CFG006", whole.span, block=place.text, word=f"{name}=")
                return None
        if lists:
            outputs, steps = (found[name] for name in lists)
            for number, row in enumerate(steps if isinstance(steps, tuple) else ()):
                if isinstance(outputs, tuple) and len(row) != len(outputs):
                    sizes = {"size": len(row), "outputs": len(outputs)}
                    self.operands.say("CFG003", whole.span, block=place.text, step=number, word=row, **sizes)
                    return None
        return {name: found[name] for name in block.settings or {} if name in found}

    def keep(self, place: Address, found: dict[str, Said] | None) -> None:
        """Enter what a line says, and the line as it is spelled."""
        if found:
            self.settings[place.text] = found
            shown = {name: ",".join(value) if isinstance(value, tuple) else value for name, value in found.items()}
            self.lines.append(f"{place.text}: {' '.join(f'{name}={value}' for name, value in shown.items())}")


def remarks(above: tuple[str, ...], comment: str) -> tuple[str, ...]:
    """Give the comments of a configuration line, which the next instruction takes over."""
    return (*above, comment) if comment else above


__all__ = ["VALUE", "Configuration", "remarks"]
