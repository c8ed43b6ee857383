"""A card for one instruction or one diagnostic: what a learner looks up, as text and as HTML."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

from plcteach.core.diagnostic import RULES, Rule
from plcteach.core.diagnostic import rule as find_rule
from plcteach.core.errors import UnknownNameError
from plcteach.core.text import Text, language, same
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import families
from plcteach.figure.illustration import illustration
from plcteach.figure.ladder import ladder_scene
from plcteach.figure.says import describes
from plcteach.figure.stack import illustrate
from plcteach.figure.strip import strip
from plcteach.figure.svg import svg
from plcteach.ladder import read_drawing
from plcteach.machine.scan import run
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.spec import Dialect, Insn, Sample
    from plcteach.figure.scene import Scene

_BAD = Text("这样会触发它", "This triggers it")
_GOOD = Text("这样就没有问题", "This does not")
_WHY = Text("为什么", "Why")
_BEFORE = Text("执行前", "before")
_AFTER = Text("执行后", "after")
_FORM = Text("格式", "form")
_OPERANDS = Text("操作数", "operand")
_EFFECT = Text("堆栈作用（右边是栈顶）", "stack effect (top on the right)")
_EXAMPLE = Text("例子", "example")
_CLASSES = {
    "contact": Text("触点指令", "contact instruction"),
    "coil": Text("线圈指令", "coil instruction"),
    "stack": Text("堆栈指令", "stack instruction"),
    "other": Text("其他指令", "other instruction"),
}
_SYMBOLS = {
    "load": "--[ {a} ]--", "series": "--[ {b} ]--[ {a} ]--", "parallel": "--[ {b} ]--+--\n--[ {a} ]--+",
    "load_not": "--[/{a} ]--", "series_not": "--[ {b} ]--[/{a} ]--", "parallel_not": "--[ {b} ]--+--\n--[/{a} ]--+",
    "invert": "--[ {b} ]--[NOT]--", "coil": "--[ {a} ]--", "set": "--[ {a} ]--", "reset": "--[ {a} ]--",
    "join_series": "--[ {a} ]--+--[ {b} ]--+--\n--[ {c} ]--+--[ {d} ]--+",
    "join_parallel": "--[ {a} ]--[ {b} ]--+--\n--[ {c} ]--[ {d} ]--+",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Card:
    """What there is to know of one instruction of one family."""

    dialect: Dialect
    insn: Insn

    def __repr__(self) -> str:
        return self.text(language())

    def _repr_html_(self) -> str:
        return self.html(language())

    @property
    def kind(self) -> Text:
        """Whether it is a contact, a coil or a stack instruction."""
        if any(verb.formula for verb in self.insn.then):
            return _CLASSES["coil"]
        if self.insn.operands and not self.insn.operands[0].number:
            return _CLASSES["contact"]
        return _CLASSES["stack"] if self.insn.effect.clauses[0].takes or self.insn.operands else _CLASSES["other"]

    @property
    def form(self) -> str:
        """How it is written: the mnemonic and its operands by name."""
        return f"{self.insn.mnemonic} {', '.join(operand.name for operand in self.insn.operands)}".strip()

    def facts(self) -> list[tuple[Text, Text]]:
        """Give the card's rows: class, form, operands, what it does, the effect as the table has it."""
        rows = [(_FORM, Text(self.form, self.form))]
        for operand in self.insn.operands:
            title = (
                Text(f"{operand.first}到{operand.last}", f"{operand.first} to {operand.last}")
                if operand.number
                else self.dialect.kinds[operand.kind].title
            )
            areas = "" if operand.number else " ".join(sorted(self.dialect.kinds[operand.kind].areas)).strip()
            zh, en = (f"（{areas}）", f" ({areas})") if areas else ("", "")
            rows.append((_OPERANDS, Text(f"{operand.name}：{title.zh}{zh}", f"{operand.name}: {title.en}{en}")))
        example = self.dialect.example(self.insn.mnemonic)
        rows.append((_EFFECT, same(self.insn.effect.text)))
        return [*rows, (_EXAMPLE, Text(example, example))]

    def symbol(self) -> Scene | None:
        """Draw what the instruction is in a ladder; stack instructions are wires there, so they show what they join."""
        role = self.dialect.parts.get(self.insn.mnemonic, "")
        drawing = _SYMBOLS.get(role)
        if not drawing:
            return None
        area = next(area for area in self.dialect.areas if area.role == "input")
        coil = next(area for area in self.dialect.areas if area.role == "output").first
        letters = {letter: area.address(place).text for place, letter in enumerate("abcd")}
        rows = drawing.format(**letters).split("\n")
        sign = {"set": "S ", "reset": "R "}.get(role, "")
        rows[0] += f"( {sign}{coil} )".replace("( S", "(S").replace("( R", "(R")
        ladder, found = read_drawing("\n".join(rows))
        return None if found else ladder_scene(ladder)

    def example(self) -> Scene:
        """Draw the example's stack, line by line, with inputs that all are 1."""
        program = read(self.dialect.example(self.insn.mnemonic), self.dialect)
        ones = {address.text: 1 for address in program.addresses("input")}
        return strip(run(program, [ones]).scans[0])

    def text(self, lang: str) -> str:
        """Give the card as lines of text for a terminal."""
        head = f"{self.insn.mnemonic}  {self.insn.title.in_(lang)}  [{self.dialect.title.in_(lang)}, {self.kind.in_(lang)}]"
        rows = [head, "", describes(self.dialect, self.insn).in_(lang), ""]
        rows += [f"{name.in_(lang)}: {value.in_(lang)}" for name, value in self.facts()]
        shown = illustration(self.dialect, self.insn.mnemonic)
        for title, columns in ((_BEFORE, shown.before), (_AFTER, shown.after)):
            rows.append(f"{title.in_(lang)}: {' | '.join(' '.join(column) for column in columns)}")
        return "\n".join(rows)

    def html(self, lang: str) -> str:
        """Give the card as HTML with its figures."""
        facts = "".join(
            f"<tr><th>{escape(a.in_(lang))}</th><td>{escape(b.in_(lang))}</td></tr>" for a, b in self.facts()
        )
        symbol = self.symbol()
        pictures = [*([symbol] if symbol else []), illustrate(self.dialect, self.insn.mnemonic), self.example()]
        figures = "".join(f"<div>{svg(scene, lang)}</div>" for scene in pictures)
        return (
            f"<h4>{escape(self.insn.mnemonic)} — {escape(self.insn.title.in_(lang))} "
            f"<small>{escape(self.dialect.title.in_(lang))}, {escape(self.kind.in_(lang))}</small></h4>"
            f"<p>{escape(describes(self.dialect, self.insn).in_(lang))}</p><table>{facts}</table>{figures}"
        )


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
        rows = [f"{self.rule.code}  {self.rule.name}  ({self.rule.severity})", "", self.rule.says.in_(lang), ""]
        rows += [f"{_WHY.in_(lang)}: {self.rule.why.in_(lang)}"]
        for dialect, sample in self.samples:
            rows += ["", f"[{dialect.title.in_(lang)}] {_BAD.in_(lang)}:", *_indented(sample.bad)]
            rows += [f"{_GOOD.in_(lang)}:", *_indented(sample.good)]
        return "\n".join(rows)


def _indented(program: str) -> list[str]:
    return [
        f"    {row.strip()!r}"[1:-1].replace("'", "") if "\x00" in row else f"    {row.strip()}"
        for row in program.replace(";", "\n").split("\n")
    ]


@dataclass(frozen=True, slots=True)
class RuleTable:
    """All diagnostics in one table, printed from the rules themselves."""

    def __repr__(self) -> str:
        lang = language()
        return "\n".join(f"{row.code}  {row.severity:8} {row.name:24} {row.says.in_(lang)}" for row in RULES.values())

    def _repr_html_(self) -> str:
        lang = language()
        body = "".join(
            f"<tr><td><code>{row.code}</code></td><td>{row.severity}</td><td>{escape(row.says.in_(lang))}</td></tr>"
            for row in RULES.values()
        )
        return f"<table>{body}</table>"


def explain(word: str = "", dialect: str | Dialect | None = None) -> Card | RulePage | RuleTable:
    """Explain an instruction (`OLD`), a diagnostic (`STK001`), or with no word list all diagnostics.

    Without a dialect the first family that has the instruction answers. UnknownNameError suggests the nearest name.
    """
    if not word:
        return RuleTable()
    if word.upper() in RULES:
        code = word.upper()
        mine = [find_dialect(dialect)] if dialect else families()
        samples = tuple((one, sample) for one in mine for sample in one.samples if sample.code == code)
        return RulePage(find_rule(code), samples)
    if dialect:
        family = find_dialect(dialect)
        return Card(family, family.insn(word))
    for family in families():
        if word.upper() in family.words:
            return Card(family, family.words[word.upper()])
    kind = "instruction or diagnostic"
    raise UnknownNameError(kind, word, [*RULES, *(name for family in families() for name in family.words)])
