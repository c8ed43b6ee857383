"""A card for one instruction: what a learner looks up of it, as text and as HTML."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

from plcteach.core.text import Text, language, same
from plcteach.core.verb import coil
from plcteach.figure.blocks import blocks_of
from plcteach.figure.illustration import illustration
from plcteach.figure.ladder import ladder_scene
from plcteach.figure.says import describes
from plcteach.figure.stack import illustrate
from plcteach.figure.strip import strip
from plcteach.figure.svg import svg
from plcteach.ladder.picture import read_drawing
from plcteach.machine.scan import run
from plcteach.stl import read

if TYPE_CHECKING:
    from plcteach.core.insn import Insn, Operand
    from plcteach.core.spec import Dialect
    from plcteach.figure.scene import Scene

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
    "block": Text("功能块指令", "block instruction"),
    "word": Text("字指令", "word instruction"),
    "course": Text("程序流程指令", "program control instruction"),
    "other": Text("其他指令", "other instruction"),
}
_VERBS = {
    "block": {"drive", "pin", "open", "update"},
    "word": {"work", "shift"},
    "course": {
        "jump", "label", "call", "return", "loop", "next", "end", "stop", "master", "restore", "segment", "transfer", "step",
        "rail", "entry",
    },
    "coil": {"coil", "set", "reset"},
}  # fmt: skip
_BRANCHES = "{a} -> ({b} -> {q}), ({c} -> {r}), ({d} -> {s})"
_SYMBOLS = {
    "join_series": "({a} + {b}) * ({c} + {d}) -> {q}", "join_parallel": "{a} * {b} + {c} * {d} -> {q}",
    "invert": "{b} * NOT -> {q}", "coil": "{a} -> {q}", "set": "{a} -> S {q}", "reset": "{a} -> R {q}",
    "push": _BRANCHES, "read": _BRANCHES, "pop": _BRANCHES,
}  # fmt: skip
_MARKS = {"bit": "", "!bit": "/", "rise(bit)": "P ", "fall(bit)": "N ", "!a": "/ "}
_PLACES = {"-- ": "{m}{a} -> {q}", "a&": "{b} * {m}{a} -> {q}", "a|": "{b} + {m}{a} -> {q}"}
_BLOCKS = {"&": "{b} * ({m}{a} + {c}) -> {q}", "|": "{b} + {m}{a} * {c} -> {q}"}


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
        verbs = {
            verb.name for verb in self.insn.then if verb.name not in _VERBS["coil"] or verb.target in {"out", "direct"}
        }
        for kind, names in _VERBS.items():
            if verbs & names:
                return _CLASSES[kind]
        if self.insn.operands and not self.insn.operands[0].number:
            return _CLASSES["contact"]
        return _CLASSES["stack"] if self.insn.effect.clauses[0].takes or self.insn.operands else _CLASSES["other"]

    @property
    def name(self) -> str:
        """What the instruction is called: its mnemonic, and where that is an opening bracket, both brackets."""
        return f"{self.insn.mnemonic} ]" if self.insn.mnemonic == "[" else self.insn.mnemonic

    @property
    def form(self) -> str:
        """How it is written: the mnemonic and its operands by name."""
        word, operands = self.insn.word, self.insn.operands
        if "update" in self.insn.does:
            return word
        if operands and operands[0].mark and operands[0].mark == word.rstrip(":"):
            return f"{operands[0].mark}{operands[0].name}{word.removeprefix(operands[0].mark)}"
        said = self.insn.separator.join(self._spelled(operand) for operand in operands)
        return f"[ {said} ]" if word == "[" else f"{word} {said}".strip()

    def _spelled(self, operand: Operand) -> str:
        if operand.relation:
            return self.insn.separator.join((f"{operand.name}1", f"{operand.name}2"))
        return f"{operand.mark}{operand.name}"

    def facts(self) -> list[tuple[Text, Text]]:
        """Give the card's rows: class, form, operands, what it does, the effect as the table has it."""
        rows = [(_FORM, Text(self.form, self.form))]
        rows += [(_OPERANDS, self._operand(operand)) for operand in self.insn.operands]
        rows += blocks_of(self.dialect, self.insn)
        rows.append((_EFFECT, same(self.insn.effect.text)))
        return [*rows, (_EXAMPLE, same(self.dialect.example(self.insn.mnemonic)))]

    def _operand(self, operand: Operand) -> Text:
        """Say what may stand for an operand."""
        name = self._spelled(operand) if operand.relation else operand.name
        if operand.number:
            first, last = f"{operand.mark}{operand.first}", f"{operand.mark}{operand.last}"
            return Text(f"{name}：{first}到{last}", f"{name}: {first} to {last}")
        kind = self.dialect.kinds[operand.kind]
        areas = " ".join(sorted(kind.areas)).strip()
        zh, en = (f"（{areas}）", f" ({areas})") if areas else ("", "")
        return Text(f"{name}：{kind.title.zh}{zh}", f"{name}: {kind.title.en}{en}")

    def symbol(self) -> Scene | None:
        """Draw what the instruction is in a ladder; stack instructions are wires there, so they show what they join."""
        line = self._drawing()
        if not line or not self.insn.does <= _VERBS["coil"]:
            return None
        letters = {letter: self._bit("input", place) for place, letter in enumerate("abcd")}
        coils = {letter: self._bit("output", place) for place, letter in enumerate("qrs")}
        ladder, found = read_drawing(line.format(**letters, **coils))
        return None if found else ladder_scene(ladder)

    def _bit(self, role: str, place: int) -> str:
        area = next(area for area in self.dialect.areas if area.role == role)
        return area.address(place).text

    def _drawing(self) -> str:
        """Find the one-line ladder that shows this instruction: by its part in a ladder, or by what its effect does."""
        formula = self.insn.effect.text.partition("-- ")[2].partition(" ;")[0].split(".L ")[-1]
        sign = self.insn.close.text.partition("-- ")[2][1] if self.insn.close else ""
        if sign and formula in _MARKS:
            return _BLOCKS[sign].replace("{m}", _MARKS[formula])
        for verb in self.insn.then:
            if verb == coil("!a"):
                return "{a} -> / {q}"
        for start, drawing in _PLACES.items():
            mark = _MARKS.get(formula.removeprefix(start))
            if mark is not None and (formula.startswith(start) or start == "-- ") and self.insn.operands:
                return drawing.replace("{m}", mark)
        return _SYMBOLS.get(self.dialect.parts.get(self.insn.mnemonic, ""), "")

    def example(self) -> Scene:
        """Draw the example's stack, line by line, with inputs that all are 1."""
        program = read(self.dialect.example(self.insn.mnemonic).replace("; ", "\n"), self.dialect)
        ones = {address.text: 1 for address in program.addresses("input")}
        return strip(run(program, [ones]).scans[0])

    def text(self, lang: str) -> str:
        """Give the card as lines of text for a terminal."""
        head = f"{self.name}  {self.insn.title.in_(lang)}  [{self.dialect.title.in_(lang)}, {self.kind.in_(lang)}]"
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
            f"<h4>{escape(self.name)} — {escape(self.insn.title.in_(lang))} "
            f"<small>{escape(self.dialect.title.in_(lang))}, {escape(self.kind.in_(lang))}</small></h4>"
            f"<p>{escape(describes(self.dialect, self.insn).in_(lang))}</p><table>{facts}</table>{figures}"
        )
