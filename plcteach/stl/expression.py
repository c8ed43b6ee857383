"""Reads what NEZA's lists write in brackets: a word worked out from others (`[%MW0 := %MW1 + 5]`), or two words compared."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.program import Assign, Compare, Source
from plcteach.core.source import Span
from plcteach.core.text import Text, same
from plcteach.stl.words import Word

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.core.insn import Insn, Operand
    from plcteach.stl.operands import Operands

LONGEST = 120
"""No operation with two operands is longer."""

OPERATORS = {
    "+": "add", "-": "sub", "*": "mul", "/": "div", "REM": "rem", "AND": "and", "OR": "or", "XOR": "xor",
}  # fmt: skip
FUNCTIONS = {"NOT": "not", "SQRT": "sqrt"}
MOVES = {"SHL": "shl16", "SHR": "shr16", "ROL": "rol16", "ROR": "ror16"}
STEPS = {"INC": "inc", "DEC": "dec"}
RELATIONS = ("=", "<>", ">=", "<=", ">", "<")

_PART = re.compile(r"\s*(:=|<>|>=|<=|[-+*/=<>(),]|[0-9]+#[0-9A-Za-z]+|[0-9]+|[%A-Za-z_][\w.:%]*?(?=:=|[^\w.:%]|$)|\S)")
_SIGNS = {"+", "-"}
_WORDS = "word"

_OPERATOR = Text("运算符（+ - * / REM AND OR XOR）", "an operator (+ - * / REM AND OR XOR)")
_WHAT = Text(
    "一个运算（%MW0 := %MW1 + 5）或一个比较（%MW0 > 10）", "an operation (%MW0 := %MW1 + 5) or a comparison (%MW0 > 10)"
)
_END = Text("右方括号", "the closing bracket")


def joined(words: Sequence[Word]) -> Word:
    """Make one word of several, with the blanks that stood between them, so that places in it are places in the row."""
    text = words[0].text
    for before, word in pairwise(words):
        apart = word.span.start - before.span.stop if word.span.row == before.span.row else 1
        text += " " * min(max(apart, 0), LONGEST) + word.text
    return Word(text, Span(words[0].span.row, words[0].span.start, words[-1].span.stop))


def inside(word: Word, first: int, last: int) -> Span:
    """Give the place of a part of a word."""
    at = word.span.start
    return Span(word.span.row, min(at + first, max(word.span.stop - 1, at)), min(at + last, word.span.stop))


def bracketed(words: list[Word]) -> list[Word]:
    """Put everything from a [ to its ] into one word, wherever blanks stand; a bracket that is not closed takes the rest."""
    first = next((at for at, word in enumerate(words) if "[" in word.text), None)
    if first is None:
        return words
    last = next((at for at in range(first, len(words)) if "]" in words[at].text), len(words) - 1)
    whole = joined(words[first : last + 1])
    opens, closes = whole.text.index("["), whole.text.find("]") + 1 or len(whole.text)
    parts = ((0, opens), (opens, closes), (closes, len(whole.text)))
    cut = [Word(whole.text[a:b].strip(), inside(whole, a, b)) for a, b in parts if whole.text[a:b].strip()]
    return [*words[:first], *cut, *words[last + 1 :]]


@dataclass(slots=True)
class _Parts:
    """The parts of a bracket with a finger on the next; `failed`: something has been said, and nothing more will be."""

    operands: Operands
    insn: Insn
    operand: Operand
    whole: Word
    parts: list[Word] = field(default_factory=list)
    next: int = 0
    failed: bool = False

    def peek(self, ahead: int = 0) -> str:
        at = self.next + ahead
        return self.parts[at].text.upper() if at < len(self.parts) else ""

    def accept(self, *signs: str) -> str:
        """Pass over a sign if it stands there."""
        found = self.peek()
        if found not in signs or not found:
            return ""
        self.next += 1
        return found

    def refuse(self, expected: Text) -> None:
        """Say once what was expected instead of the next part."""
        if not self.failed:
            one = self.parts[self.next] if self.next < len(self.parts) else None
            end = Word("]", inside(self.whole, len(self.whole.text) - 1, len(self.whole.text)))
            self.operands.say("EXP001", (one or end).span, word=(one or end).shown, expected=expected)
        self.failed = True

    def source(self) -> Source | None:
        """Read a word or a number, which may have a sign."""
        signed = self.peek() in _SIGNS and self.peek(1)[:1].isdigit()
        taken = self.parts[self.next : self.next + 1 + signed]
        kind = self.operands.dialect.kinds[_WORDS]
        if self.failed or not taken or (not taken[-1].text[:1].isalnum() and not taken[-1].text.startswith("%")):
            self.refuse(kind.title)
            return None
        self.next += len(taken)
        word = Word(
            "".join(one.text for one in taken), Span(taken[0].span.row, taken[0].span.start, taken[-1].span.stop)
        )
        found = self.operands.word(self.insn, self.operand, word, kind)
        self.failed |= found is None
        return found

    def target(self) -> Address | None:
        """Read the word that is written."""
        at = self.next
        found = self.source()
        word = self.parts[at] if at < len(self.parts) else self.whole
        return self.writable(found, word) if found is not None else None

    def writable(self, found: Source, word: Word) -> Address | None:
        """Give the address if a program may write it; a block's current value and a preset that is locked may not."""
        dialect = self.operands.dialect
        kind = dialect.kinds["assign"]
        block = dialect.block(found) if isinstance(found, Address) else None
        open_field = block is None or (isinstance(found, Address) and found.field in {block.preset, *block.pins} - {""})
        if not isinstance(found, Address) or found.area not in kind.areas or not open_field:
            self.failed = True
            self.operands.say("RDR007", word.span, word=":=", address=found.text, expected=kind.title)
            return None
        whole = dialect.whole(found)
        if block and self.operands.settings.get(whole.text, {}).get("ADJ") == "N":
            self.failed = True
            self.operands.say("CFG007", word.span, address=found.text, block=whole.text)
            return None
        return found


def expression(operands: Operands, insn: Insn, operand: Operand, word: Word) -> Assign | Compare | None:
    """Read a bracket; None where it could not be read, which has been said."""
    text = word.text
    parts = _Parts(operands, insn, operand, word)
    if len(text) > LONGEST or not (text.startswith("[") and text.endswith("]")):
        parts.next, parts.parts = 0, [word]
        parts.refuse(_WHAT if len(text) > LONGEST else _END)
        return None
    parts.parts = [Word(one[1], inside(word, *one.span(1))) for one in _PART.finditer(text, 1, len(text) - 1)]
    wants_bit = operands.dialect.kinds[operand.kind].compare
    found = _compared(parts) if wants_bit else _assigned(parts)
    if found is not None and not parts.failed and parts.peek():
        parts.refuse(_END)
    return None if parts.failed else found


def _compared(parts: _Parts) -> Compare | None:
    left = parts.source()
    relation = "" if left is None else parts.accept(*RELATIONS)
    if left is None or not relation:
        parts.refuse(Text("一个比较（= <> >= <= > <）", "a comparison (= <> >= <= > <)"))
        return None
    right = parts.source()
    if right is None:
        return None
    return Compare(left, relation, right, _WORDS, f"[{left.text} {relation} {right.text}]")


def _assigned(parts: _Parts) -> Assign | None:
    step = parts.accept(*STEPS)
    if step:
        target = parts.target()
        return None if target is None else Assign(target, STEPS[step], (target,), _WORDS, f"[{step} {target.text}]")
    target = parts.target()
    if target is None:
        parts.refuse(_WHAT)
        return None
    if not parts.accept(":="):
        parts.refuse(same(":="))
        return None
    op, sources, text = _worked(parts)
    return Assign(target, op, sources, _WORDS, f"[{target.text} := {text}]")


def _worked(parts: _Parts) -> tuple[str, tuple[Source, ...], str]:
    """Read what stands right of :=, with the rule it follows and its canonical spelling."""
    name = parts.accept(*FUNCTIONS, *MOVES)
    if name:
        return _function(parts, name)
    first = parts.source()
    if first is None or not parts.peek():
        return "move", (first,) if first else (), first.text if first else ""
    sign = parts.accept(*OPERATORS)
    if not sign:
        parts.refuse(_OPERATOR)
    second = parts.source()
    if second is None:
        return "", (), ""
    return OPERATORS[sign], (first, second), f"{first.text} {sign} {second.text}"


def _function(parts: _Parts, name: str) -> tuple[str, tuple[Source, ...], str]:
    """Read NOT(word), SHL(word, number): the parentheses and the comma may be missing."""
    opened = parts.accept("(")
    sources = [parts.source()]
    if name in MOVES:
        parts.accept(",")
        sources.append(parts.source())
    if opened and not parts.accept(")"):
        parts.refuse(same(")"))
    found = tuple(one for one in sources if one is not None)
    return (MOVES | FUNCTIONS)[name], found, f"{name}({', '.join(one.text for one in found)})"
