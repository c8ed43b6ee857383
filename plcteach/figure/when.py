"""The words for the condition under which an instruction acts: without values both ways, with values the one that happened."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.effect import Edge, Name, Not
from plcteach.core.text import NOTHING, Text
from plcteach.figure.told import edge_seen, inverse, with_value

if TYPE_CHECKING:
    from plcteach.core.effect import Formula
    from plcteach.core.verb import Verb
    from plcteach.figure.told import Told


def fired(told: Told, verb: Verb) -> str:
    """Say whether a verb's condition held: "1", "0", "x"; nothing without values or where an edge cannot be seen."""
    if told.step is None:
        return ""
    power = told.was() or "x"
    match verb.formula:
        case None:
            power = "1"
        case Not():
            power = inverse(power)
        case Edge() if power == "1":
            worked = repr(dict(told.step.kept).get("ENO"))
            power = "0" if told.first else "1" if worked == "1" else ""
        case Name(name) if name in told.line.bound:
            power = told.value
    return power


def condition(told: Told, formula: Formula | None) -> Text:
    """Name what decides: a relay that the line itself names, or the result so far."""
    if isinstance(formula, Name) and formula.name in told.line.bound:
        return Text(f"继电器{told.address(formula.name)}", f"relay {told.address(formula.name)}")
    return told.result


def when(told: Told, verb: Verb, yes: Text, no: Text, now: Text = NOTHING) -> Text:
    """Say what happens if the condition holds and if not; `now`: what to say where an edge cannot be seen."""
    if verb.formula is None:
        return yes
    it, power = condition(told, verb.formula), fired(told, verb)
    values = {"it": it, "yes": yes, "no": no}
    if isinstance(verb.formula, Edge):
        return _at_edge(told, power, values, now or yes)
    if told.step is None:
        on, off = ("0", "1") if isinstance(verb.formula, Not) else ("1", "0")
        said = Text("{it}为{on}时，{yes}；为{off}时，{no}", "if {it} is {on}, {yes}; if it is {off}, {no}")
        return said.format(**values, on=on, off=off)
    if power == "x":
        return _unknown(values)
    seen = inverse(power) if isinstance(verb.formula, Not) else power
    said = Text("{it}为{seen}，{what}", "{it} is {seen}, so {what}")
    return said.format(it=it, seen=seen, what=yes if power == "1" else no)


def _unknown(values: dict[str, Text]) -> Text:
    said = Text(
        "{it}为x，会怎样无法知道：可能{yes}，也可能{no}", "{it} is x, so nobody knows which: either {yes}, or {no}"
    )
    return said.format(**values)


def _at_edge(told: Told, power: str, values: dict[str, Text], now: Text) -> Text:
    """Say it of a verb that acts on an edge only."""
    if told.step is None:
        said = Text(
            "只在{it}由0变1的那个扫描周期里，{yes}；此外{no}",
            "only in the scan in which {it} rises, {yes}; otherwise {no}",
        )
        return said.format(**values)
    if power == "x":
        return _unknown(values)
    if not power:
        said = Text("{it}为1，只有它刚由0变1时才执行；{now}", "{it} is 1, and only its rising edge counts; {now}")
        return said.format(**values, now=now)
    why = edge_seen(told, with_value(told.result, told.was()), power, rising=True)
    said = Text("{why}，{what}", "{why}, so {what}")
    return said.format(why=why, what=values["yes" if power == "1" else "no"])
