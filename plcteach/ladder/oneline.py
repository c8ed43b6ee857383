"""A rung on one line, (I0.0 + Q0.0) · /I0.1 -> Q0.0, read and written.

    rung    = [ sum ] "->" out *( "," out )
    sum     = product *( ( "+" | "|" ) product )
    product = factor *( ( "·" | "*" | "&" ) factor )
    factor  = address | "/" factor | ( "P" | "N" | "I" ) address | "[" comparison "]" | "(" sum ")"
            | "NOT" | ( "P" | "N" ) [ ":" address ]
    out     = [ "/" | "S" | "R" | "P" | "N" | "I" | "SI" | "RI" ] address [ number ] | "(" rung ")"
            | "{" [ name ":" ] instruction *( ";" name ":" sum ) "}"

An inverted parenthesis is turned into inverted contacts at once (/(a+b) is /a·/b), so that NOT on the wire is written only
where it is meant.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import NoReturn

from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.ladder import (
    MOST_NESTED,
    OPPOSITE,
    Box,
    Branch,
    Coil,
    Compared,
    Contact,
    Edge,
    Invert,
    Node,
    Out,
    Parallel,
    Rung,
    Series,
    branch,
    parallel,
    rung,
    series,
)  # fmt: skip
from plcteach.core.source import Span
from plcteach.core.text import Text, same
from plcteach.ladder.symbols import (
    ADDRESS,
    EDGES,
    KINDS,
    NAME,
    RESERVED,
    Input,
    box,
    coil_of,
    compared,
    contact_of,
    shortened,
)  # fmt: skip

_TOKEN = re.compile(rf"->|→|\[[^\[\]{{}}]*\]?|\{{[^{{}};]*|{ADDRESS}|\S")
_ARROW = "->"
_MOST_OPEN = MOST_NESTED // 3
_ORS, _ANDS, _NOTS = frozenset("+|∨"), frozenset("·*&•∧⋅"), frozenset("/!¬")
_CONTACTS = frozenset({*EDGES, "I"})


class _UnreadError(Exception):
    """What the parser stopped at; it never leaves this module."""

    def __init__(self, found: Diagnostic) -> None:
        self.found = found
        super().__init__(found.code)


def read_line(text: str, row: int = 1) -> Rung | Diagnostic:
    """Read a rung on one line (half-width already), or give the first thing that does not fit."""
    parser = _Parser(text, row)
    try:
        found = parser.rung()
        if parser.peek():
            parser.stop(Text("行的结尾", "the end of the line"))
    except _UnreadError as unread:
        return unread.found
    return rung(found[0], *found[1])


class _Parser:
    """The words of one line with a finger on the next, and how many parentheses are open.

    wide: what is to be said where an output follows a box of several inputs, once there is one.
    """

    def __init__(self, text: str, row: int) -> None:
        self.words = [(match[0].replace("→", _ARROW), *match.span()) for match in _TOKEN.finditer(text)]
        self.end, self.row, self.next, self.nested = len(text.rstrip()), row, 0, 0
        self.wide: Diagnostic | None = None

    def peek(self, ahead: int = 0) -> str:
        place = self.next + ahead
        return self.words[place][0] if place < len(self.words) else ""

    def span(self) -> Span:
        if self.next >= len(self.words):
            return Span(self.row, self.end, self.end)
        _, start, stop = self.words[self.next]
        return Span(self.row, start, stop)

    def stop(self, expected: Text) -> NoReturn:
        word = same(shortened(self.peek())) if self.peek() else Text("行的结尾", "the end of the line")
        raise _UnreadError(rule("DRW013").at(self.span(), word=word, expected=expected))

    def take(self) -> str:
        self.next += 1
        return self.words[self.next - 1][0]

    def expect(self, word: str) -> None:
        if self.peek() != word:
            self.stop(same(word))
        self.take()

    def deeper(self) -> None:
        self.nested += 1
        if self.nested > _MOST_OPEN:
            raise _UnreadError(rule("DRW014").at(self.span(), most=_MOST_OPEN))
        self.take()

    def shallower(self) -> None:
        self.expect(")")
        self.nested -= 1

    def rung(self) -> tuple[Node | None, list[Out]]:
        stem = None if self.peek() == _ARROW else self.sum()
        self.expect(_ARROW)
        outs = [self.out()]
        while self.peek() == ",":
            self.take()
            outs.append(self.out())
        return stem, outs

    def sum(self) -> Node:
        parts = [self.product()]
        while self.peek() in _ORS:
            self.take()
            parts.append(self.product())
        return parallel(*parts)

    def product(self) -> Node:
        parts = [self.factor()]
        while self.peek() in _ANDS:
            self.take()
            parts.append(self.factor())
        return series(*parts)

    def factor(self) -> Node:
        inverted = False
        while self.peek() in _NOTS:
            self.take()
            inverted = not inverted
        if self.peek() == "(":
            self.deeper()
            inner = self.sum()
            self.shallower()
        else:
            inner = self.contact()
        return self.inverse(inner) if inverted else inner

    def contact(self) -> Node:
        word = self.peek().upper()
        if word == "NOT":
            self.take()
            return Invert()
        if word.startswith("["):
            return self.compared()
        marked = word in _CONTACTS and self.is_address(self.peek(1))
        if word in EDGES and not marked:
            return self.edge()
        if marked:
            self.take()
        return contact_of(
            self.address(Text("触点的地址或 (", "the address of a contact, or (")), word if marked else ""
        )

    def compared(self) -> Compared:
        word = self.peek()
        found = compared(word[1:-1]) if word.endswith("]") else None
        if found is None:
            self.stop(Text("一个比较，如 [VW0 >= 5]", "a comparison such as [VW0 >= 5]"))
        self.take()
        return found

    def edge(self) -> Edge:
        rising = EDGES[self.take().upper()] == "rise"
        if self.peek() != ":":
            return Edge(rising)
        self.take()
        return Edge(rising, self.address(Text("记忆位的地址", "the address of the memory bit")))

    def address(self, expected: Text) -> str:
        return self.take() if self.is_address(self.peek()) else self.stop(expected)

    @staticmethod
    def is_address(word: str) -> bool:
        return bool(re.fullmatch(ADDRESS, word)) and word.upper() not in RESERVED

    def inverse(self, node: Node) -> Node:
        """Turn a node round by turning round its contacts, series into parallel and parallel into series."""
        match node:
            case Contact(_, negated, ""):
                return replace(node, negated=not negated)
            case Compared(_, relation):
                return replace(node, relation=OPPOSITE[relation])
            case Series(parts):
                return parallel(*map(self.inverse, parts))
            case Parallel(parts):
                return series(*map(self.inverse, parts))
        return self.stop(
            Text("能取反的部分（沿和NOT前面不能写 /）", "a part without edges and NOT, for / cannot turn those round")
        )

    def out(self) -> Out:
        if self.wide:
            raise _UnreadError(self.wide)
        if self.peek().startswith("{"):
            return self.box()
        if self.peek() == "(":
            self.deeper()
            stem, outs = self.rung()
            self.shallower()
            if stem is None:
                self.stop(Text("支路的触点", "the contacts of a branch"))
            return branch(stem, *outs)
        return self.coil()

    def coil(self) -> Coil:
        mark = self.peek().upper()
        if mark in KINDS and self.peek(1):
            self.take()
        else:
            mark = ""
        if not self.is_address(self.peek()) or self.peek().isdigit():
            self.stop(Text("线圈的地址", "the address of a coil"))
        address = self.take()
        count = self.take() if self.peek().isdigit() else None
        found = coil_of(address, mark, count)
        if found is None:
            self.next -= 1
            self.stop(
                Text("逗号；只有S和R可以写位数（1–255）", "a comma; only S and R take a number of bits (1 to 255)")
            )
        return found

    def box(self) -> Box:
        word, span = self.peek(), self.span()
        found = box(word[1:])
        if isinstance(found, Input):
            found = found.label
        if found is None:
            self.stop(Text("方框里的指令，如 {TON T37, 50}", "a box with its instruction, such as {TON T37, 50}"))
        self.take()
        pins = []
        while self.peek() == ";":
            self.take()
            pins.append(self.pin())
        self.expect("}")
        if pins:
            self.wide = rule("DRW020").at(span, word=same(f"{shortened(word)}…}}"))
        return replace(found, pins=tuple(pins))

    def pin(self) -> tuple[str, Node]:
        name = self.peek().upper()
        if not re.fullmatch(NAME, name):
            self.stop(Text("输入的名字，如 R:", "the name of an input, such as R:"))
        self.take()
        self.expect(":")
        return name, self.sum()


def write_line(one: Rung) -> str:
    """Write a rung on one line; an output path with contacts of its own stands in parentheses."""
    outs = ", ".join(map(_out, one.outs))
    return f"{_sum(one.stem)} -> {outs}" if one.stem else f"-> {outs}"


def _sum(node: Node) -> str:
    return " + ".join(map(_product, node.parts)) if isinstance(node, Parallel) else _product(node)


def _product(node: Node) -> str:
    return " · ".join(map(_factor, node.parts)) if isinstance(node, Series) else _factor(node)


def _factor(node: Node) -> str:
    match node:
        case Contact():
            return f"{node.mark}{node.address}"
        case Compared():
            return f"[{node.text}]"
        case Edge():
            return node.mark
        case Invert():
            return "NOT"
    return f"({_sum(node)})"


def _out(one: Out) -> str:
    if isinstance(one, Branch):
        return f"({_sum(one.stem)} -> {', '.join(map(_out, one.outs))})"
    if isinstance(one, Box):
        entry = f"{one.entry}: " if one.entry else ""
        pins = "".join(f"; {name}: {_sum(node)}" for name, node in one.pins)
        return f"{{{entry}{one.text}{pins}}}"
    count = f" {one.count}" if one.count > 1 else ""
    return f"{'/' if one.kind == 'not' else one.mark}{one.address}{count}"
