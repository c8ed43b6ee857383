"""Reads a ladder from PLCopen XML (IEC 61131-10, TC6 0201): one program's LD body, as Beremiz, the OpenPLC Editor and others write it.

What is read: contacts, coils, power rails, parallel paths and branches by their connections, TON, TOF, TP, CTU, CTD, CTUD, the
function NOT and R_TRIG, F_TRIG as signs on the wire, variables and literals at inputs, variables written at outputs. The order
of execution is from top to bottom by the coils and boxes, as those editors have it.

A timer or counter becomes a box with neutral text, for no family in particular: `TON T1, T#5S`, `CTU PARTS, 3` with the input R
as a pin; its output bit is read as a contact `T1.Q`. `plcopen_fit` makes a family's own boxes of them. An address loses the X
(%IX0.0 is %I0.0); a name without an address stays a name.

What is not read, and is named in a message: FBD, SFC, ST and IL bodies, actions and transitions, further programs of the file,
jumps, labels and returns, connectors and continuations, functions (AND, GE, ADD, MOVE, …) and blocks of anybody's own, EN that
hangs on a contact, the time and count so far (ET, CV), initial values, and orders of execution given by number.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.ladder import Ladder, titled
from plcteach.core.source import Span
from plcteach.core.text import Text, joined
from plcteach.ladder.markup import Element, RefusedError, read_markup, refuse
from plcteach.ladder.plcopen_names import Names
from plcteach.ladder.plcopen_nets import rungs
from plcteach.ladder.plcopen_parts import parts, place_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.ladder import Rung
    from plcteach.ladder.plcopen_nets import Drawn
    from plcteach.ladder.plcopen_parts import Part

MOST_FINDINGS = 20
_FEW = 12
_LOOKED_AT = 4_000
_LONGEST_TITLE = 80
_START = re.compile(r"\s*(?:<\?xml[^>]*\?>)?(?:\s|<!--(?:(?!-->).)*-->)*<(?:[\w.-]+:)?project\b", re.DOTALL)
_BODIES = {"LD", "FBD", "SFC", "ST", "IL"}


def is_plcopen(text: bytes | str) -> bool:
    """Say whether a text is a project in PLCopen XML, by its first characters."""
    if isinstance(text, bytes):
        wide = text.startswith((b"\xff\xfe", b"\xfe\xff"))
        text = text[:_LOOKED_AT].decode("utf-16" if wide else "utf-8", errors="replace")
    return bool(_START.match(text[:_LOOKED_AT].removeprefix("\ufeff")))


def read_plcopen(data: bytes | str, *, pou: str = "") -> tuple[Ladder, tuple[Diagnostic, ...]]:
    """Read one program's ladder (`pou`: its name); rungs that could not be read are left out, and all that was found is said."""
    root = read_markup(data)
    if isinstance(root, Diagnostic):
        return Ladder(()), (root,)
    try:
        return _read(root, pou)
    except RefusedError as refused:
        return Ladder(()), (refused.found,)


def _read(root: Element, wanted: str) -> tuple[Ladder, tuple[Diagnostic, ...]]:
    program, body = _program(root, wanted)
    names = Names()
    for place in (program.all("interface"), root.at("instances/configurations/configuration")):
        names.declare(one for outer in place for one in outer.every() if one.name == "variable")
    found = parts(body, names)
    drawn, said = rungs(found, names)
    if not drawn and not said:
        refuse("XML004", body.row, found=Text("一张空的LD图", "an empty LD body"))
    if names.loose:
        said.append(rule("XML016").at(Span(min(names.loose.values())), names=_list([*names.loose])))
    said += [*_beside(root, program, body), *_numbers(found)]
    said.sort(key=lambda one: (one.severity != "error", one.span))
    title = " ".join(one.text for one in root.at("contentHeader/Comment"))[:_LONGEST_TITLE]
    return Ladder(_titled(drawn, body), title), tuple(said[:MOST_FINDINGS])


def _bodies(program: Element) -> list[Element]:
    return [one for one in program.at("body") for one in one.inside if one.name in _BODIES]


def _program(root: Element, wanted: str) -> tuple[Element, Element]:
    """Give the program to be read, and its ladder: the one of that name, else the first program, else the first with a ladder."""
    found = root.at("types/pous/pou") if root.name == "project" else []
    if root.name != "project":
        refuse("XML004", root.row, found=Text(f"最外层是{root.name[:30]}", f"it begins with {root.name[:30]}"))
    if wanted:
        named = [one for one in found if one.get("name").upper() == wanted.strip().upper()]
        if not named:
            refuse("XML005", root.row, name=wanted[:_LONGEST_TITLE], names=_list([one.get("name") for one in found]))
        found = named
    found = sorted(found, key=lambda one: one.get("pouType") != "program")
    for program in found:
        for body in _bodies(program):
            if body.name == "LD":
                return program, body
    kinds = [f"{one.get('name')[:30]} ({', '.join(body.name for body in _bodies(one)) or '-'})" for one in found]
    return refuse("XML004", found[0].row if found else root.row, found=_list(kinds))


def _list(words: list[str]) -> Text:
    """Name a few of some words."""
    shown = [word[:_LONGEST_TITLE] or "?" for word in words[:_FEW]]
    more = len(words) - len(shown)
    if not words:
        return Text("没有程序", "no program")
    return Text(
        "、".join(shown) + (f"等{len(words)}个" if more else ""),
        ", ".join(shown) + (f" and {more} more" if more else ""),
    )


def _beside(root: Element, program: Element, body: Element) -> Iterator[Diagnostic]:
    """Say what else the file holds: further programs, bodies in other languages, actions, an order of execution."""
    others = [one for one in root.at("types/pous/pou") if one is not program]
    bodies = [one for one in _bodies(program) if one is not body]
    inner = program.at("actions/action") + program.at("transitions/transition")
    orders = [one for one in body.inside if one.get("executionOrderId") not in {"", "0"}]
    yield from _left_out(Text("程序", "the programs"), others, "name")
    yield from _left_out(Text("程序的其他部分", "further parts of the program"), bodies, "")
    yield from _left_out(Text("动作和转换", "the actions and transitions"), inner, "name")
    order = Text("执行次序编号（executionOrderId），localId", "the order of execution (executionOrderId) of localId")
    yield from _left_out(order, orders, "localId")


def _left_out(what: Text, places: list[Element], name: str) -> Iterator[Diagnostic]:
    if places:
        listed = _list([one.get(name) if name else one.name for one in places])
        yield rule("XML017").at(Span(places[0].row), what=joined((what, listed), zh=" "))


def _numbers(found: dict[int, Part]) -> Iterator[Diagnostic]:
    """Say which variables a time or a count is written to."""
    written = [one for one in found.values() if one.tag == "outVariable" and not one.symbol and not one.problem]
    if written:
        what = Text("写到变量里的时间和计数", "the times and counts written to")
        listed = _list([one.word for one in written])
        yield rule("XML017").at(Span(written[0].row), what=joined((what, listed), zh=" "))


def _titled(drawn: list[Drawn], body: Element) -> tuple[Rung, ...]:
    """Give each rung the comment that stands above it, the nearest one."""
    made = [one.rung for one in drawn]
    for comment in sorted(body.all("comment"), key=place_of):
        words = " ".join(" ".join(one.text for one in comment.every()).split())
        below = next((at for at, one in enumerate(drawn) if one.place[0] >= place_of(comment)[0]), None)
        if below is not None and words:
            made[below] = titled(made[below], words[:_LONGEST_TITLE].strip())
    return tuple(made)
