"""The objects of a ladder body of PLCopen XML, each with what it is in a ladder, where it stands, and what is on its left."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NoReturn

from plcteach.core.ladder import Coil, CoilKind, Contact, Edge, EdgeKind, Invert
from plcteach.core.text import Text, same
from plcteach.ladder.markup import RefusedError, refuse
from plcteach.ladder.plcopen_names import FLOWS, INPUTS, NUMBERS, OUTPUTS, constant, preset_of

if TYPE_CHECKING:
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.ladder.markup import Element
    from plcteach.ladder.plcopen_names import Names

MOST_PARTS = 4_000
MOST_WIRES = 12_000
_SHOWN = 40
_DIGITS = 18

_TITLES = {
    "contact": Text("触点", "The contact"),
    "coil": Text("线圈", "The coil"),
    "block": Text("方框", "The box"),
    "inVariable": Text("输入变量", "The input variable"),
    "outVariable": Text("输出变量", "The output variable"),
    "leftPowerRail": Text("左母线", "The left rail"),
    "rightPowerRail": Text("右母线", "The right rail"),
    "jump": Text("跳转", "The jump"),
    "label": Text("标号", "The label"),
    "return": Text("返回", "The return"),
    "connector": Text("连接符", "The connector"),
    "continuation": Text("续接符", "The continuation"),
}  # fmt: skip
_SILENT = frozenset({"comment", "vendorElement", "addData", "documentation"})
_EDGES: dict[str, EdgeKind] = {"rising": "rise", "falling": "fall"}


@dataclass(frozen=True, slots=True)
class Wire:
    """What an input hangs on: the number of the object on its left, and which of its outputs."""

    target: int
    output: str
    row: int


@dataclass(slots=True)
class Inlet:
    """One input of an object: its wires, and what stands before it on the box."""

    wires: list[Wire]
    negated: bool = False
    edge: EdgeKind = ""


@dataclass(slots=True, eq=False)
class Part:
    """One object: its number, its tag, its row in the file and its place in the drawing, and what it is in a ladder.

    symbol: its sign; for a block, what flows through it.  kind, name, preset: a timer's or counter's.
    outlets: outputs of a box that are turned round or taken at an edge.
    """

    number: int
    tag: str
    row: int
    place: tuple[float, float]
    symbol: Contact | Invert | Edge | Coil | None = None
    kind: str = ""
    name: str = ""
    preset: str = ""
    word: str = ""
    inlets: dict[str, Inlet] = field(default_factory=dict)
    outlets: dict[str, tuple[bool, EdgeKind]] = field(default_factory=dict)
    problem: Diagnostic | None = None

    def __repr__(self) -> str:
        return f"Part({self.number} {self.tag} {self.word})"

    @property
    def what(self) -> Text:
        """How a message calls it: the contact %I0.0, the box TON T1."""
        title = _TITLES.get(self.tag, Text(f"图形{self.tag[:_SHOWN]}", f"The sign {self.tag[:_SHOWN]}"))
        word = self.word if len(self.word) <= _SHOWN else f"{self.word[:_SHOWN]}…"
        return Text(f"{title.zh}{word}", f"{title.en} {word}".strip())

    @property
    def box(self) -> bool:
        """Whether it is a timer or a counter."""
        return self.kind in INPUTS

    def refuse(self, code: str, **values: object) -> NoReturn:
        """Say why the rung with this object is not read."""
        refuse(code, self.row, what=self.what, id=self.number, **values)


def parts(body: Element, names: Names) -> dict[int, Part]:
    """Read the objects of a ladder body by their numbers; one that is no part of a ladder keeps its finding with it."""
    found: dict[int, Part] = {}
    wires = 0
    for element in body.inside:
        if element.name in _SILENT:
            continue
        digits = element.get("localId")
        part = Part(_number(digits), element.name, element.row, place_of(element))
        if part.number < 0 or part.number in found:
            row = found[part.number].row if part.number in found else element.row
            refuse("XML008", element.row, id=digits[:_SHOWN] or "?", row=row)
        found[part.number] = part
        try:
            _read(part, element, names)
        except RefusedError as refused:
            part.problem = refused.found
        wires += sum(len(inlet.wires) for inlet in part.inlets.values())
        if len(found) > MOST_PARTS or wires > MOST_WIRES:
            many = len(found) > MOST_PARTS
            what = Text("个图形", "signs in the drawing") if many else Text("条连线", "wires")
            refuse("XML002", element.row, what=what, most=MOST_PARTS if many else MOST_WIRES)
    return found


def _number(digits: str) -> int:
    return int(digits) if digits.isascii() and digits.isdigit() and len(digits) <= _DIGITS else -1


def place_of(element: Element) -> tuple[float, float]:
    """Give where an object stands, from above and then from the left."""
    at = next(iter(element.all("position")), None)
    return (_length(at.get("y")), _length(at.get("x"))) if at else (0.0, 0.0)


def _length(word: str) -> float:
    try:
        return max(-1e9, min(1e9, float(word[:_SHOWN])))
    except ValueError:
        return 0.0


def _inlets(element: Element) -> Inlet:
    """Read what an object or an input hangs on."""
    wires = [
        Wire(_number(one.get("refLocalId")), one.get("formalParameter").upper(), one.row)
        for one in element.at("connectionPointIn/connection")
    ]
    return Inlet(wires, _yes(element, "negated"), _EDGES.get(element.get("edge"), ""))


def _yes(element: Element, name: str) -> bool:
    return element.get(name) in {"true", "1"}


def _read(part: Part, element: Element, names: Names) -> None:
    match element.name:
        case "leftPowerRail":
            pass
        case "rightPowerRail":
            part.inlets[""] = _inlets(element)
        case "contact":
            part.inlets[""] = _inlets(element)
            part.symbol = _contact(part, element, names)
        case "coil":
            part.inlets[""] = _inlets(element)
            part.symbol = _coil(part, element, names)
        case "inVariable":
            part.word = " ".join(one.text for one in element.all("expression"))
            part.outlets[""] = (_yes(element, "negated"), _EDGES.get(element.get("edge"), ""))
        case "outVariable":
            _sink(part, element, names)
        case "block":
            _block(part, element)
        case _:
            part.inlets[""] = _inlets(element)
            part.refuse("XML006")


def _bit(part: Part, element: Element, names: Names, tag: str = "variable") -> str:
    """Read the variable that an object stands for."""
    word = " ".join(one.text for one in element.all(tag))
    found = names.bit(word, element.row)
    if not found:
        part.refuse("XML013", word=word[:_SHOWN] or "?")
    part.word = found
    return found


def _marks(part: Part, element: Element) -> tuple[bool, EdgeKind, str]:
    """Read what stands in a contact or a coil: at most one of negated, an edge, set and reset."""
    negated, edge, storage = _yes(element, "negated"), element.get("edge"), element.get("storage")
    said = ["negated"] * negated + [one for one in (edge, storage) if one not in {"", "none"}]
    known = {"negated", "rising", "falling", *(("set", "reset") if part.tag in {"coil", "outVariable"} else ())}
    if len(said) > 1 or not known.issuperset(said):
        part.refuse("XML012", marks=", ".join(said)[:_SHOWN])
    return negated, _EDGES.get(edge, ""), storage


def _contact(part: Part, element: Element, names: Names, tag: str = "variable") -> Contact:
    address = _bit(part, element, names, tag)
    negated, edge, _ = _marks(part, element)
    return Contact(address, negated, edge)


def _coil(part: Part, element: Element, names: Names, tag: str = "variable") -> Coil:
    address = _bit(part, element, names, tag)
    negated, edge, storage = _marks(part, element)
    kinds: dict[str, CoilKind] = {"set": "set", "reset": "reset"}
    return Coil(address, "not" if negated else kinds.get(storage, edge))


def source(part: Part, names: Names) -> Contact:
    """Give the contact of a variable that stands at the left of a rung, or at an input of a box."""
    negated, edge = part.outlets.get("", (False, ""))
    address = names.bit(part.word, part.row)
    if not address or (negated and edge):
        part.refuse("XML013", word=part.word[:_SHOWN] or "?")
    return Contact(address, negated, edge)


def always(part: Part) -> bool | None:
    """Say what a variable at the left is, if it is one of the two constants."""
    return {"TRUE": True, "1": True, "FALSE": False, "0": False}.get(part.word.upper().removeprefix("BOOL#"))


def _sink(part: Part, element: Element, names: Names) -> None:
    """Read a variable that a box or a flow is written to."""
    part.inlets[""] = _inlets(element)
    part.inlets[""].negated = False
    outputs = [wire.output for wire in part.inlets[""].wires]
    if outputs and NUMBERS.issuperset(outputs):
        part.word = " ".join(one.text for one in element.all("expression"))
        return
    part.symbol = _coil(part, element, names, "expression")


def _block(part: Part, element: Element) -> None:
    part.kind, part.name = element.get("typeName").upper(), element.get("instanceName").upper()
    part.word = f"{element.get('typeName')} {element.get('instanceName')}".strip()
    for one in element.at("inputVariables/variable"):
        part.inlets[one.get("formalParameter").upper()] = _inlets(one)
    for one in element.at("outputVariables/variable"):
        negated, edge, storage = _yes(one, "negated"), _EDGES.get(one.get("edge"), ""), one.get("storage")
        if (negated and edge) or storage not in {"", "none"}:
            part.refuse("XML012", marks=f"{one.get('formalParameter')[:_SHOWN]}: {storage or 'negated'}")
        if negated or edge:
            part.outlets[one.get("formalParameter").upper()] = (negated, edge)
    signs: dict[str, Invert | Edge] = {"NOT": Invert(), "R_TRIG": Edge(), "F_TRIG": Edge(rising=False)}
    part.symbol = signs.get(part.kind)
    if part.symbol and part.outlets:
        part.refuse("XML006")
    if part.symbol:
        _sign(part)
    elif not part.box:
        part.refuse("XML006")
    elif not part.name or len(part.name) > _SHOWN:
        part.refuse("XML014", missing=Text("名字", "a name"))


def _sign(part: Part) -> None:
    """Give a block that stands on the wire its one input the plain name."""
    wanted = FLOWS[part.kind][0]
    flow = part.inlets.pop(wanted, None) or next((part.inlets.pop(one) for one in [*part.inlets] if one != "EN"), None)
    if len(part.inlets) > ("EN" in part.inlets) or (flow and (flow.negated or flow.edge)):
        part.refuse("XML006")
    part.inlets[""] = flow or Inlet([])


def preset(part: Part, found: dict[int, Part]) -> str:
    """Give the preset of a box in canonical spelling, from the one variable or literal that its PT or PV hangs on."""
    name = preset_of(part.kind)
    wires = part.inlets[name].wires if name in part.inlets else []
    given = found.get(wires[0].target) if len(wires) == 1 else None
    made = constant(given.word, part.kind) if given and given.tag == "inVariable" else ""
    if not made:
        missing = Text(
            f"{name}（如{'T#5s' if name == 'PT' else '3'}）", f"{name}, such as {'T#5s' if name == 'PT' else '3'}"
        )
        part.refuse("XML014", missing=missing)
    return made


def flows(part: Part) -> list[str]:
    """Give the inputs of a box that something hangs on, in the order of the standard; further ones are refused."""
    known = {*INPUTS[part.kind], preset_of(part.kind), "EN"}
    strange = [name for name, inlet in part.inlets.items() if name not in known and inlet.wires]
    if strange:
        word = same(f"{part.kind}.{strange[0][:_SHOWN]}")
        refuse("XML006", part.row, what=word, id=part.number)
    return [name for name in INPUTS[part.kind] if name in part.inlets and part.inlets[name].wires]


def output(part: Part, name: str) -> Contact:
    """Give the contact of an output bit of a box."""
    asked = name or OUTPUTS[part.kind][0]
    if asked not in OUTPUTS[part.kind]:
        refuse("XML006", part.row, what=same(f"{part.kind}.{asked[:_SHOWN]}"), id=part.number)
    negated, edge = part.outlets.get(asked, (False, ""))
    return Contact(f"{part.name}.{asked}", negated, edge)
