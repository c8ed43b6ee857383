"""Reads an instruction list of any family: understands what it can, and reports everything it could not."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

from plcteach.core.area import Address, Area
from plcteach.core.diagnostic import MOST_FINDINGS, Diagnostic, few
from plcteach.core.errors import nearest
from plcteach.core.program import Line, Program
from plcteach.core.source import Span, decode
from plcteach.core.text import NOTHING, Text
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import names
from plcteach.stl.boxes import expanded
from plcteach.stl.circuits import arrange
from plcteach.stl.configuration import Configuration, remarks
from plcteach.stl.expression import bracketed, expression
from plcteach.stl.operands import Operands, did_you_mean
from plcteach.stl.section import Section, Spelled
from plcteach.stl.tokens import Heading, Statement, Word, cut

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect
    from plcteach.stl.symbols import Symbols

_MOST_SUGGESTIONS = 200


def read(
    text: str | bytes,
    dialect: str | Dialect | None = None,
    *,
    encoding: str | None = None,
    symbols: Symbols | None = None,
) -> Program:
    """Read a program; what could not be read stands in `Program.diagnostics`, each finding with its place.

    Bytes are decoded first (UTF-8, UTF-16, `encoding`, GBK, cp1252). `symbols`: names that may stand for addresses.
    UnknownNameError if there is no such dialect.
    """
    family = find_dialect(dialect or names()[0])
    source = text if isinstance(text, str) else decode(text, encoding)
    tokens = cut(source, closers=")" in family.words)
    reading = _Reading(family, symbols.find if symbols else None)
    items: list[Line | Heading] = []
    for item in _continued(tokens.items, family):
        if isinstance(item, Heading):
            reading.section.close()
            items.append(item)
        else:
            items.extend(reading.line(item))
        if len(reading.diagnostics) > MOST_FINDINGS:
            break
    reading.section.close()
    networks, found = arrange(family, items)
    diagnostics = sorted([*tokens.diagnostics, *reading.diagnostics, *found], key=lambda one: one.span)
    return Program(
        family,
        networks,
        reading.above + tokens.tail,
        tuple(reading.configuration.lines),
        source=source,
        diagnostics=tuple(few(diagnostics)),
        settings=reading.configuration.settings,
        symbols=reading.operands.symbols,
    )


def _continued(items: list[Statement | Heading], dialect: Dialect) -> Iterator[Statement | Heading]:
    """Put a preset that stands on a row of its own (`OUT T0`, below it `K10`) behind the instruction above it."""
    marks = tuple(mark for mark in dialect.constant if mark.isalpha())
    waiting: Statement | None = None
    for item in items:
        lone = isinstance(item, Statement) and len(item.words) == 1 and item.words[0].text.upper()
        if waiting and lone and lone.startswith(marks or "?") and lone[1:].isdigit() and isinstance(item, Statement):
            waiting.words.append(item.words[0])
            waiting.comment = waiting.comment or item.comment
            continue
        if waiting:
            yield waiting
        waiting = item if isinstance(item, Statement) else None
        if isinstance(item, Heading):
            yield item
    if waiting:
        yield waiting


class _Reading:
    """Turns statements into lines for one family, collecting findings as it goes."""

    def __init__(self, dialect: Dialect, find: Callable[[str], str | None] | None = None) -> None:
        self.dialect = dialect
        self.diagnostics: list[Diagnostic] = []
        self.operands = Operands(dialect, self.diagnostics, find)
        self.operands.brackets = expression
        self.configuration = Configuration(self.operands)
        self.section = Section(self.operands)
        self.above: tuple[str, ...] = ()
        self.began = False
        self.say = self.operands.say

    def line(self, statement: Statement) -> Iterator[Line]:
        words = _unnumbered(statement.words)
        words = bracketed(words) if "[" in self.dialect.words else words
        if words[0].text.upper() in self.dialect.boxes:
            yield from expanded(self.operands, words, statement)
            return
        if not self.section.numbered(words) and self.configuration.takes(words):
            self.configuration.line(words, late=self.began)
            self.above += remarks(statement.above, statement.comment)
            return
        spelled = self.section.spelled(words)
        if spelled is None:
            return
        ends = replace(statement, comment="") if spelled.rest else statement
        yield from self.instruction(spelled, ends)
        if spelled.rest:
            yield from self.line(Statement(list(spelled.rest), statement.comment))

    def instruction(self, spelled: Spelled, statement: Statement) -> Iterator[Line]:
        """Read one instruction, its operands written out."""
        words = spelled.words
        insn, operands = self.insn(words)
        if insn is None:
            return
        last = [word for word in words if word.span.row == words[0].span.row][-1]
        span = Span(words[0].span.row, words[0].span.start, last.span.stop)
        insn = self.suited(insn, operands)
        args = self.operands.args(insn, words[0], operands, span) if self.section.suits(insn, operands) else None
        self.began = True
        if args is None:
            return
        effect = insn.bare if insn.bare and not args else insn.effect
        numbers = {name.name: arg for name, arg in zip(insn.operands, args, strict=False) if isinstance(arg, int)}
        said = self.section.said(insn, args, spelled)
        above, self.above = self.above + statement.above, ()
        line = Line(insn, args, effect.bind(numbers), span, statement.comment, above, said)
        self.section.after(line)
        yield line

    def suited(self, insn: Insn, operands: list[Word]) -> Insn:
        """Give the row that an instruction has for the area of its operand (OUT T0 is no OUT Y0), else the row itself."""
        found = self.operands.place(operands[0]) if operands and insn.word in self.several else None
        area = found.area if isinstance(found, Address) else found.prefix if isinstance(found, Area) else ""
        area = "" if isinstance(found, Address) and found.field else area
        return self.dialect.words.get(f"{insn.word} {area}", insn)

    @cached_property
    def several(self) -> dict[str, Insn]:
        """The instructions with rows of their own for some areas, each with one of its rows."""
        return {row.word: row for row in self.dialect.insns if " " in row.mnemonic}

    def insn(self, words: list[Word]) -> tuple[Insn | None, list[Word]]:
        """Find the instruction that a statement begins with, also where its sign is glued to the operand (=Q0.0)."""
        first, rest = words[0], words[1:]
        found = self.known(first.text)
        if found:
            return found, rest
        for mnemonic in self.glued:
            if first.text.upper().startswith(mnemonic):
                cut_at = first.span.start + len(mnemonic)
                operand = Word(first.text[len(mnemonic) :], Span(first.span.row, cut_at, first.span.stop))
                return self.dialect.words[mnemonic], [operand, *rest]
        self.unknown(first)
        return None, rest

    def known(self, word: str) -> Insn | None:
        upper = word.upper()
        found = self.dialect.words.get(self.dialect.aliases.get(upper, upper))
        return found or self.several.get(upper)

    @cached_property
    def glued(self) -> list[str]:
        signs = [mnemonic for mnemonic in self.dialect.words if not mnemonic[-1].isalnum()]
        return sorted(signs, key=len, reverse=True)

    def unknown(self, word: Word) -> None:
        if word.text.upper() in self.dialect.recognised:
            self.say("RDR002", word.span, word=word.shown.upper())
        else:
            near = self.near(word.text) if len(self.diagnostics) < _MOST_SUGGESTIONS else NOTHING
            self.say("RDR001", word.span, word=word.shown, near=near)

    def near(self, word: str) -> Text:
        """Suggest what an unknown word may have been meant for: LDI0.0 for LD I0.0, ADN for AN."""
        for size in range(min(4, len(word) - 1), 0, -1):
            if self.known(word[:size]) and isinstance(self.dialect.address(word[size:]), Address):
                return did_you_mean((f"{word[:size].upper()} {word[size:].upper()}",))
        return did_you_mean(_nearest(word, self.dialect))


def _unnumbered(words: list[Word]) -> list[Word]:
    """Pass over the step number that a listing puts before the instruction (`0 LD X000`)."""
    return words[1:] if len(words) > 1 and words[0].text.rstrip(":").isdigit() else words


@lru_cache(maxsize=512)
def _nearest(word: str, dialect: Dialect) -> tuple[str, ...]:
    return tuple(nearest(word, dialect.words))
