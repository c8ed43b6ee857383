"""The notation in which an instruction is its stack effect, read once when a dialect is imported.

    effect   = clause *( ";" clause )             one clause a stack: "a -- a ; aux: -- a"
    clause   = [ stack ":" ] cells "--" results   the top of the stack stands on the right
    cell     = name [ "." tag ] [ "?" ]           "?": taken if it is there (a result register that may be empty)
    result   = [ label "=" ] formula [ "." tag ]  the label is what the textbook calls the new value
    formula  = name | "!" f | f "&" f | f "^" f | f "|" f | "(" f ")" | "[" name "]" | rise(f) | fall(f)

A name left of "--" is a cell taken from the stack; any other name is an operand of the instruction. "[n]" is the cell n
places below the top, counted from 0, before the instruction. The grammar is read by one small function for each of its lines.
"""

from __future__ import annotations

import re
from functools import lru_cache

from plcteach.core.effect import At, Both, Clause, Edge, Effect, Formula, Given, Name, Not, Taken
from plcteach.core.errors import DeclarationError

_WORD = re.compile(r"\s*(?:(?P<name>[A-Za-z_]\w*)|(?P<sign>--|[!&|^()\[\]=.:;?]))")
_LEVELS = ("|", "^", "&")


class _Words:
    """The words of one effect with a finger on the next."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.words = self._split(text)
        self.next = 0

    def _split(self, text: str) -> list[str]:
        words, at = [], 0
        stripped = text.rstrip()
        while at < len(stripped):
            match = _WORD.match(stripped, at)
            if not match:
                msg = f"effect {text!r}: cannot read {stripped[at:]!r}"
                raise DeclarationError(msg)
            words.append(match["name"] or match["sign"])
            at = match.end()
        return words

    def peek(self, ahead: int = 0) -> str:
        place = self.next + ahead
        return self.words[place] if place < len(self.words) else ""

    def take(self, expected: str = "") -> str:
        word = self.peek()
        if (expected and word != expected) or not word:
            msg = f"effect {self.text!r}: expected {expected or 'a word'} before {' '.join(self.words[self.next :])!r}"
            raise DeclarationError(msg)
        self.next += 1
        return word

    def name(self) -> str:
        if not self.peek().isidentifier():
            self.take("a word")
        return self.take()

    def accept(self, word: str) -> bool:
        if self.peek() != word:
            return False
        self.next += 1
        return True


@lru_cache(maxsize=1024)
def parse_effect(text: str) -> Effect:
    """Read an effect in the notation above; DeclarationError names the word that does not fit."""
    words = _Words(text)
    clauses = [_clause(words)]
    while words.accept(";"):
        clauses.append(_clause(words))
    if words.peek():
        words.take("the end")
    _refuse_twice(text, [clause.stack for clause in clauses], "stack")
    _refuse_twice(text, [take.name for clause in clauses for take in clause.takes], "cell")
    return Effect(tuple(clauses), text)


def _refuse_twice(text: str, names: list[str], what: str) -> None:
    """Refuse a second clause for a stack, and a cell taken twice."""
    for name in names:
        if names.count(name) > 1:
            msg = f"effect {text!r}: the {what} {name or 'main'!r} stands there twice"
            raise DeclarationError(msg)


@lru_cache(maxsize=1024)
def parse_formula(text: str) -> Formula:
    """Read a formula alone, as the verbs beside an effect have it."""
    words = _Words(text)
    formula = _formula(words, 0)
    if words.peek():
        words.take("the end")
    return formula


def _clause(words: _Words) -> Clause:
    stack = ""
    if words.peek(1) == ":":
        stack = words.name()
        words.take(":")
    takes = []
    while not words.accept("--"):
        name = words.name()
        tag = words.name() if words.accept(".") else ""
        takes.append(Taken(name, tag, optional=words.accept("?")))
    gives = []
    while words.peek() not in {"", ";", ")"}:
        gives.append(_given(words))
    return Clause(stack, tuple(takes), tuple(gives))


def _given(words: _Words) -> Given:
    label = ""
    if words.peek(1) == "=":
        label = words.name()
        words.take("=")
    formula = _formula(words, 0)
    tag = words.name() if words.accept(".") else ""
    return Given(formula, tag, label)


def _formula(words: _Words, level: int) -> Formula:
    if level == len(_LEVELS):
        return _factor(words)
    left = _formula(words, level + 1)
    while words.accept(_LEVELS[level]):
        left = Both(_LEVELS[level], left, _formula(words, level + 1))
    return left


def _factor(words: _Words) -> Formula:
    if words.accept("!"):
        return Not(_factor(words))
    if words.accept("("):
        inner = _formula(words, 0)
        words.take(")")
        return inner
    if words.accept("["):
        n = words.name()
        words.take("]")
        return At(n)
    name = words.name()
    if name in {"rise", "fall"} and words.accept("("):
        inner = _formula(words, 0)
        words.take(")")
        return Edge(name == "rise", inner)
    return Name(name)
