"""Reads an instruction list of any family: understands what it can, and reports everything it could not."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import TYPE_CHECKING

from plcteach.core.area import Address, Area
from plcteach.core.diagnostic import MOST_FINDINGS, Diagnostic, few, rule
from plcteach.core.errors import nearest
from plcteach.core.program import Arg, Line, Program
from plcteach.core.source import Span, decode
from plcteach.core.text import NOTHING, Text, same
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import names
from plcteach.stl.circuits import arrange
from plcteach.stl.tokens import Heading, Statement, Word, cut

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.spec import Dialect, Insn, Operand

_NUMBER = re.compile(r"[+]?\d{1,9}")
_MOST_SUGGESTIONS = 200


def read(text: str | bytes, dialect: str | Dialect | None = None, *, encoding: str | None = None) -> Program:
    """Read a program; what could not be read stands in `Program.diagnostics`, each finding with its place.

    Bytes are decoded first (UTF-8, UTF-16, `encoding`, GBK, cp1252). UnknownNameError if there is no such dialect.
    """
    family = find_dialect(dialect or names()[0])
    source = text if isinstance(text, str) else decode(text, encoding)
    tokens = cut(source, closers=")" in family.words)
    reading = _Reading(family)
    items: list[Line | Heading] = []
    for item in tokens.items:
        if isinstance(item, Heading):
            items.append(item)
        else:
            items.extend(reading.line(item))
        if len(reading.diagnostics) > MOST_FINDINGS:
            break
    networks, found = arrange(family, items)
    diagnostics = sorted([*tokens.diagnostics, *reading.diagnostics, *found], key=lambda one: one.span)
    return Program(family, networks, tokens.tail, source, tuple(few(diagnostics)))


class _Reading:
    """Turns statements into lines for one family, collecting findings as it goes."""

    def __init__(self, dialect: Dialect) -> None:
        self.dialect = dialect
        self.diagnostics: list[Diagnostic] = []

    def say(self, code: str, span: Span, **values: object) -> None:
        self.diagnostics.append(rule(code).at(span, family=self.dialect.title, **values))

    def line(self, statement: Statement) -> Iterator[Line]:
        words = _unnumbered(statement.words)
        insn, operands = self.insn(words)
        if insn is None:
            return
        span = Span(words[0].span.row, words[0].span.start, words[-1].span.stop)
        args = self.args(insn, words[0], operands, span)
        if args is None:
            return
        effect = insn.bare if insn.bare and not args else insn.effect
        numbers = {name.name: arg for name, arg in zip(insn.operands, args, strict=False) if isinstance(arg, int)}
        yield Line(insn, args, effect.bind(numbers), span, statement.comment, statement.above)

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
        return self.dialect.words.get(self.dialect.aliases.get(upper, upper))

    @property
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
                return _did_you_mean((f"{word[:size].upper()} {word[size:].upper()}",))
        return _did_you_mean(_nearest(word, self.dialect))

    def args(self, insn: Insn, first: Word, words: list[Word], span: Span) -> tuple[Arg, ...] | None:
        args: list[Arg] = []
        for place, operand in enumerate(insn.operands):
            if place >= len(words):
                if not operand.optional:
                    self.say("RDR003", span, word=insn.mnemonic, expected=self.expected(operand))
                    return None
                break
            arg = self.number(insn, operand, words[place]) if operand.number else self.bit(insn, operand, words[place])
            if arg is None:
                return None
            args.append(arg)
        extra = words[len(insn.operands) :]
        if extra:
            rest = Span(span.row, extra[0].span.start, extra[-1].span.stop)
            self.say("RDR004", rest, word=first.shown.upper(), rest=extra[0].shown)
            return None
        return tuple(args)

    def expected(self, operand: Operand) -> Text:
        if operand.number:
            return Text(f"{operand.first}到{operand.last}之间的数", f"a number from {operand.first} to {operand.last}")
        return self.dialect.kinds[operand.kind].title

    def number(self, insn: Insn, operand: Operand, word: Word) -> int | None:
        if not _NUMBER.fullmatch(word.text) or not operand.first <= int(word.text) <= operand.last:
            values = {"name": same(operand.name), "first": operand.first, "last": operand.last, "number": word.shown}
            self.say("RDR008", word.span, word=insn.mnemonic, **values)
            return None
        return int(word.text)

    def bit(self, insn: Insn, operand: Operand, word: Word) -> Address | None:
        found = self.dialect.address(word.text)
        expected = self.expected(operand)
        if found is None:
            self.say("RDR005", word.span, word=word.shown, expected=expected, near=self.near_address(word.text))
        elif isinstance(found, Area):
            note = self.dialect.note_octal if found.base == _OCTAL else NOTHING
            self.say(
                "RDR006", word.span, word=word.shown, area=found.title, first=found.first, last=found.last, note=note
            )
        elif f"{insn.mnemonic} {found.area}" in self.dialect.recognised:
            self.say("RDR002", word.span, word=f"{insn.mnemonic} {found.text}")
        elif found.area not in self.dialect.kinds[operand.kind].areas:
            self.say("RDR007", word.span, word=insn.mnemonic, address=found.text, expected=expected)
        else:
            if insn.then and self.dialect.area(found).role == "input":
                self.say("RDR012", word.span, word=insn.mnemonic, address=found.text)
            return found
        return None

    def near_address(self, word: str) -> Text:
        """Suggest an address for IO.0 (a letter O), I00 (no dot) or Q0,1."""
        if len(word) > _LONGEST_ADDRESS:
            return NOTHING
        digits = word.upper()
        tries = [
            digits[:1] + digits[1:].replace("O", "0").replace("L", "1"),
            f"{digits[:-1]}.{digits[-1:]}",
            f"%{digits}",
        ]
        if digits.startswith("%"):
            tries.append(digits[1:])
        return _did_you_mean(tuple(one for one in tries if isinstance(self.dialect.address(one), Address))[:1])


_OCTAL = 8
_LONGEST_ADDRESS = 16


def _unnumbered(words: list[Word]) -> list[Word]:
    """Pass over the step number that a listing puts before the instruction (`0 LD X000`)."""
    return words[1:] if len(words) > 1 and words[0].text.rstrip(":").isdigit() else words


def _did_you_mean(near: tuple[str, ...]) -> Text:
    if not near:
        return NOTHING
    return Text(f"是不是{'或'.join(near)}？", f"Did you mean {' or '.join(near)}? ")


@lru_cache(maxsize=512)
def _nearest(word: str, dialect: Dialect) -> tuple[str, ...]:
    return tuple(nearest(word, dialect.words))
