"""The manual: a page for each diagnostic, printed from its row and from what it really says of the families' samples."""

from __future__ import annotations

import re
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

from plcteach.check.lint import lint
from plcteach.core.diagnostic import RULES, Rule, rule
from plcteach.core.errors import UnknownNameError
from plcteach.core.misconception import misconception
from plcteach.core.text import Text, language
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import families
from plcteach.figure.card import Card
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect, Sample

_BAD = Text("这样会触发它", "This triggers it")
_GOOD = Text("这样就没有问题", "This does not")
_SAID = Text("提示", "It says")
_WHY = Text("为什么", "Why")
_IDEA = Text("常见的误解", "A usual wrong idea")
_LESSON = Text("见第{number}课。", "Lesson {number} is about it.")


@dataclass(frozen=True, slots=True)
class RulePage:
    """What there is to know of one diagnostic, with a program that triggers it and the mended one, family by family."""

    rule: Rule
    samples: tuple[tuple[Dialect, Sample], ...]

    def __repr__(self) -> str:
        return self.text(language())

    def _repr_html_(self) -> str:
        return f"<pre>{escape(self.text(language()))}</pre>"

    def text(self, lang: str) -> str:
        """Give the page as lines of text."""
        rows = [f"{self.rule.code}  {self.rule.name}", "", f"{_WHY.in_(lang)}: {self.rule.why.in_(lang)}"]
        ideas = [misconception(number) for number in self.rule.misconceptions]
        rows += [f"{_IDEA.in_(lang)} ({one.number}): {one.thinks.in_(lang)} {one.fact.in_(lang)}" for one in ideas]
        rows += [_LESSON.format(number=self.rule.lesson).in_(lang)] if self.rule.lesson >= 0 else []
        for dialect, sample in self.samples:
            said = next(
                one for one in lint(read(sample.bad.replace("; ", "\n"), dialect)) if one.code == self.rule.code
            )
            rows += ["", f"[{dialect.title.in_(lang)}] {_BAD.in_(lang)}:", *_listing(sample.bad)]
            rows += [f"{_SAID.in_(lang)} ({said.severity}): {said.text.in_(lang)}"]
            rows += [f"{_GOOD.in_(lang)}:", *_listing(sample.good)]
        if not self.samples:
            rows += ["", blanks(self.rule.says).in_(lang)]
        return "\n".join(rows)


def blanks(says: Text) -> Text:
    """Put an ellipsis where a message names what it has found."""

    class _Blank(dict[str, str]):
        def __missing__(self, key: str) -> str:
            return "…"

    return Text(says.zh.format_map(_Blank()), says.en.format_map(_Blank()))


def _listing(program: str) -> list[str]:
    """Give a sample one instruction a line, numbered as its findings count."""
    rows = program.replace("\x00", "␀").replace("; ", "\n").split("\n")
    return [f"    {row.strip()}" for row in rows]


@dataclass(frozen=True, slots=True)
class RuleTable:
    """All diagnostics in one table, printed from the rules themselves."""

    def __repr__(self) -> str:
        lang = language()
        return "\n".join(
            f"{row.code}  {row.severity:8} {row.name:24} {blanks(row.says).in_(lang)}" for row in RULES.values()
        )

    def _repr_html_(self) -> str:
        lang = language()
        body = "".join(
            f"<tr><td><code>{row.code}</code></td><td>{row.severity}</td><td>{escape(blanks(row.says).in_(lang))}</td></tr>"
            for row in RULES.values()
        )
        return f"<table>{body}</table>"


@dataclass(frozen=True, slots=True)
class InsnTable:
    """All instructions of one family, with their names and their effects."""

    dialect: Dialect

    def __repr__(self) -> str:
        lang = language()
        rows = [(row.mnemonic, row.effect.text, row.title.in_(lang)) for row in self.dialect.insns]
        return "\n".join(f"{mnemonic:8}{effect:28}{title}" for mnemonic, effect, title in rows)

    def _repr_html_(self) -> str:
        lang = language()
        body = "".join(
            f"<tr><td><code>{escape(row.mnemonic)}</code></td><td>{escape(row.title.in_(lang))}</td>"
            f"<td><code>{escape(row.effect.text)}</code></td></tr>"
            for row in self.dialect.insns
        )
        return f"<table>{body}</table>"


def explain(word: str = "", dialect: str | Dialect | None = None) -> Card | RulePage | RuleTable | InsnTable:
    """Explain an instruction (`OLD`), a diagnostic (`STK001`), or with no word list all diagnostics (of a dialect: all its instructions).

    Without a dialect the first family that has the instruction answers. UnknownNameError suggests the nearest name.
    """
    if not word:
        return InsnTable(find_dialect(dialect)) if dialect else RuleTable()
    code = word.strip().upper()
    mine = [find_dialect(dialect)] if dialect else families()
    if code in RULES:
        samples = tuple((one, sample) for one in mine for sample in one.samples if sample.code == code)
        return RulePage(rule(code), samples)
    for family in mine:
        row = _row(family, code)
        if row:
            return Card(family, row)
    if dialect:
        return Card(mine[0], mine[0].insn(code.partition(" ")[0]))
    kind = "instruction or diagnostic"
    raise UnknownNameError(kind, word, [*RULES, *(name for family in families() for name in family.words)])


def _row(family: Dialect, words: str) -> Insn | None:
    """Find an instruction by its mnemonic, by a whole line of it (LDS 3, OUT T0 K10), or by its word alone (CU)."""
    word, _, operands = words.partition(" ")
    area = re.match(r"%?[A-Z]*", operands)
    for name in (words, f"{word} {area.group()}" if area else word, family.aliases.get(word, word)):
        if name in family.words:
            return family.words[name]
    if word.startswith("[") and "[" in family.words:
        return family.words["["]
    return next((row for row in family.insns if row.word == word), None)
