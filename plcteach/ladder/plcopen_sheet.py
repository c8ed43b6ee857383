"""The elements of PLCopen XML that a ladder body is made of, in the order of the schema, with places for an editor to draw them at."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape, quoteattr

from plcteach.ladder.plcopen_names import INPUTS, OUTPUTS, preset_of

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.ladder import CoilKind, EdgeKind

Refs = tuple[tuple[int, str], ...]
"""What an input hangs on: numbers of objects, and which output of each."""
Rows = list[str]
Point = tuple[int, int]

_WIDE, _HIGH = 120, 60
"""How far apart columns and rows are."""
_SIGN = (30, 20)
_STAMP = "2000-01-01T00:00:00"
"""The same ladder gives the same file."""
_EDGES = {"": "none", "rise": "rising", "fall": "falling"}
_CONTROL = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_LEFT, _RIGHT = 1, 2


def plain(text: str) -> str:
    """Give a text without what XML cannot hold."""
    return escape(_CONTROL.sub("?", text))


def tag(name: str, /, *inside: Rows | str, **attributes: object) -> Rows:
    """Give an element: its attributes, and the rows of what stands in it, or its text."""
    said = "".join(
        f" {key.rstrip('_')}={quoteattr(_CONTROL.sub('?', str(value)))}" for key, value in attributes.items()
    )
    if not inside:
        return [f"<{name}{said}/>"]
    if len(inside) == 1 and isinstance(inside[0], str):
        return [f"<{name}{said}>{plain(inside[0])}</{name}>"]
    rows = [f"  {row}" for part in inside for row in ([part] if isinstance(part, str) else part)]
    return [f"<{name}{said}>", *rows, f"</{name}>"]


class Sheet:
    """The objects of a body, numbered as they are drawn, and the points at which their wires end."""

    def __init__(self) -> None:
        self.drawn: list[Rows] = []
        self.points: dict[tuple[int, str], Point] = {}
        self.rail: list[int] = []
        self.coils: list[int] = []
        self.right = self.bottom = 0

    def new(self) -> int:
        """Give the next number; the rails have the first two."""
        return len(self.drawn) + _RIGHT + 1

    def place(self, at: tuple[int, int]) -> Point:
        """Give the corner of what stands in a row and a column."""
        x, y = at[1] * _WIDE, at[0] * _HIGH
        self.right, self.bottom = max(self.right, x), max(self.bottom, y)
        return x, y

    def inlet(self, refs: Refs, point: Point, corner: Point) -> Rows:
        """Write an input and its wires, each from right to left."""
        x, y = point
        made: list[Rows] = [_at("relPosition", (x - corner[0], y - corner[1]))]
        for number, output in refs:
            if number == _LEFT and y not in self.rail:
                self.rail.append(y)
            end = (_WIDE // 2 + 10, y) if number == _LEFT else self.points[number, output]
            middle = [] if end[1] == y else [(x - 20, y), (x - 20, end[1])]
            said: dict[str, object] = {"formalParameter": output} if output else {}
            made.append(
                tag("connection", *(_at("position", one) for one in (point, *middle, end)), refLocalId=number, **said)
            )
        return tag("connectionPointIn", *made)

    def sign(self, name: str, word: str, at: tuple[int, int], refs: Refs, marks: Mapping[str, str]) -> int:
        """Write a contact or a coil."""
        number, corner = self.new(), self.place(at)
        x, y = corner
        wide, high = _SIGN
        self.points[number, ""] = (x + wide, y + high // 2)
        self.drawn.append(
            tag(
                name,
                _at("position", corner),
                self.inlet(refs, (x, y + high // 2), corner),
                tag("connectionPointOut", _at("relPosition", (wide, high // 2))),
                tag("variable", word),
                localId=number,
                height=high,
                width=wide,
                **marks,
            )
        )
        return number

    def contact(self, word: str, at: tuple[int, int], refs: Refs, *, negated: bool, edge: EdgeKind) -> Refs:
        """Write a contact; give what hangs on it."""
        marks = {"negated": str(negated).lower(), "edge": _EDGES[edge]}
        return ((self.sign("contact", word, at, refs, marks), ""),)

    def coil(self, word: str, at: tuple[int, int], refs: Refs, kind: CoilKind) -> None:
        """Write a coil."""
        storage = kind if kind in {"set", "reset"} else "none"
        marks = {"negated": str(kind == "not").lower(), "edge": _EDGES.get(kind, "none"), "storage": storage}
        self.coils.append(self.sign("coil", word, at, refs, marks))

    def block(
        self, kind: str, name: str, at: tuple[int, int], inputs: dict[str, Refs], outputs: tuple[str, ...]
    ) -> Refs:
        """Write a block; give what hangs on its first output."""
        number, corner = self.new(), self.place(at)
        x, y = corner
        wide, high = _WIDE // 2, 20 * max(len(inputs), len(outputs)) + 20
        into = [
            tag("variable", self.inlet(refs, (x, y + 10 + 20 * at), corner), formalParameter=pin)
            for at, (pin, refs) in enumerate(inputs.items())
        ]
        out = []
        for nth, pin in enumerate(outputs):
            self.points[number, pin] = (x + wide, y + 10 + 20 * nth)
            point = tag("connectionPointOut", _at("relPosition", (wide, 10 + 20 * nth)))
            out.append(tag("variable", point, formalParameter=pin))
        said: dict[str, object] = {"localId": number, "width": wide, "height": high, "typeName": kind}
        said |= {"instanceName": name} if name else {}
        inside = (tag("inputVariables", *into), tag("inOutVariables"), tag("outputVariables", *out))
        self.drawn.append(tag("block", _at("position", corner), *inside, **said))
        return ((number, outputs[0]),)

    def timed(self, kind: str, name: str, preset: str, at: tuple[int, int], inputs: dict[str, Refs]) -> None:
        """Write a timer or counter, and its preset on its left."""
        number, corner = self.new(), self.place((at[0], at[1] - 1))
        point = (corner[0] + _WIDE // 2, corner[1] + 10 + 20 * len(INPUTS[kind]))
        self.points[number, ""] = point
        self.drawn.append(
            tag(
                "inVariable",
                _at("position", (corner[0], point[1] - 10)),
                tag("connectionPointOut", _at("relPosition", (_WIDE // 2, 10))),
                tag("expression", preset),
                localId=number,
                height=20,
                width=_WIDE // 2,
                negated="false",
            )
        )
        pins: dict[str, Refs] = {pin: inputs.get(pin, ()) for pin in INPUTS[kind]}
        numbers = "ET" if preset_of(kind) == "PT" else "CV"
        self.block(kind, name, at, {**pins, preset_of(kind): ((number, ""),)}, (*OUTPUTS[kind], numbers))

    def comment(self, words: str, row: int) -> None:
        """Write a rung's title above it."""
        content = tag("content", tag("xhtml:p", words))
        number = self.new()
        self.drawn.append(
            tag("comment", _at("position", self.place((row, 1))), content, localId=number, height=30, width=_WIDE * 5)
        )

    def rows(self) -> Rows:
        """Give the whole body, the two rails first."""
        high, right = self.bottom + _HIGH, self.right + _WIDE
        outs = [tag("connectionPointOut", _at("relPosition", (10, y)), formalParameter="") for y in sorted(self.rail)]
        left = tag("leftPowerRail", _at("position", (_WIDE // 2, 0)), *outs, localId=_LEFT, height=high, width=10)
        ends = [self.inlet(((one, ""),), (right, self.points[one, ""][1]), (right, 0)) for one in self.coils]
        rail = tag("rightPowerRail", _at("position", (right, 0)), *ends, localId=_RIGHT, height=high, width=10)
        return tag("LD", left, rail, *self.drawn)


def _at(name: str, point: Point) -> Rows:
    return tag(name, x=point[0], y=point[1])


def framed(program: str, title: str, variables: list[tuple[str, str, str]], body: Rows) -> str:
    """Give a whole project around a body: headers, the program with its variables, and a task that runs it."""
    scale = [tag(one, tag("scaling", x=10, y=10)) for one in ("fbd", "ld", "sfc")]
    comment = [tag("Comment", title)] if title else []
    types = [tag("derived", name=kind) if kind else tag("BOOL") for _, _, kind in variables]
    listed = [
        tag("variable", tag("type", kind), **({"name": name, "address": address} if address else {"name": name}))
        for (name, address, _), kind in zip(variables, types, strict=True)
    ]
    interface = tag("interface", tag("localVars", *listed)) if listed else tag("interface")
    pou = tag("pou", interface, tag("body", body), name=program, pouType="program")
    instance = tag("pouInstance", name="instance0", typeName=program)
    task = tag("task", instance, name="task0", priority=0, interval="T#20ms")
    resource = tag("resource", task, name="resource0")
    project = tag(
        "project",
        tag("fileHeader", companyName="-", productName="plcteach", productVersion="1", creationDateTime=_STAMP),
        tag("contentHeader", *comment, tag("coordinateInfo", *scale), name=program, modificationDateTime=_STAMP),
        tag("types", tag("dataTypes"), tag("pous", pou)),
        tag("instances", tag("configurations", tag("configuration", resource, name="config0"))),
        xmlns="http://www.plcopen.org/xml/tc6_0201",
        **{"xmlns:xhtml": "http://www.w3.org/1999/xhtml"},
    )
    return "\n".join(["<?xml version='1.0' encoding='utf-8'?>", *project, ""])
