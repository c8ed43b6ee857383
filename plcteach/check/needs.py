"""What a task asks of the text beside doing the same: instructions used, avoided or counted, contacts in a rung, few edits."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from plcteach.check.bridged import matters
from plcteach.core.ladder import Box, Branch, Coil, Contact, symbols_of
from plcteach.core.text import NOTHING, Text
from plcteach.ladder.lift import lift
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from plcteach.core.exercise import Exercise, Need
    from plcteach.core.ladder import Out, Rung
    from plcteach.core.program import Line, Program

_MOST_LINES = 500
"""Texts longer than this are not compared line by line; no exercise's are."""

_SAYS = {
    "most": Text(
        "做同样的事只要{value}条指令，这里用了{count}条。哪一条可以省掉？",
        "{value} instructions do the same; here there are {count}. Which one can go?",
    ),
    "uses": Text(
        "题目要求用{value}，程序里还没有。", "The task asks for {value}, and the program does not use it yet."
    ),
    "avoids": Text(
        "题目要求不用{value}。换一种写法呢？", "The task asks to do without {value}. How else can it be written?"
    ),
    "contact": Text("{where}里还少一个{contact}{value}。", "{where} still lacks {contact} {value}."),
    "edits": Text(
        "只要改{value}行就够了，这里改了{count}行。原来的哪些行是对的？",
        "Changing {value} of the lines is enough; here {count} are changed. Which of them were right as they stood?",
    ),
}
_ANYWHERE = Text("程序", "The program")
_RUNG = Text("输出{rung}的梯级", "The rung that writes {rung}")
_OPEN, _CLOSED = Text("常开触点", "a normally open contact of"), Text("常闭触点", "a normally closed contact of")


def unmet(exercise: Exercise, program: Program) -> tuple[Text, ...]:
    """Say what the task asks for and the program does not show, in the order of the exercise."""
    return tuple(said for need in exercise.needs if (said := _lacks(need, exercise, program)) != NOTHING)


def _lacks(need: Need, exercise: Exercise, program: Program) -> Text:
    """Give what there is to say of a need; nothing where it is met."""
    said = _CHECKS[need.what](need, exercise, program)
    return (need.says if need.says != NOTHING else said) if said != NOTHING else NOTHING


def _most(need: Need, _exercise: Exercise, program: Program) -> Text:
    count = len(program.lines)
    return _SAYS["most"].format(value=need.value, count=count) if count > int(need.value) else NOTHING


def _uses(need: Need, _exercise: Exercise, program: Program) -> Text:
    return NOTHING if any(_is(line, need.value) for line in program.lines) else _SAYS["uses"].format(value=need.value)


def _avoids(need: Need, _exercise: Exercise, program: Program) -> Text:
    return _SAYS["avoids"].format(value=need.value) if any(_is(line, need.value) for line in program.lines) else NOTHING


def _is(line: Line, words: str) -> bool:
    """Say whether a line is an instruction, named by its mnemonic, or with its operands as a whole line."""
    wanted = " ".join(words.upper().split())
    return wanted in {line.insn.mnemonic.upper(), line.insn.word.upper(), line.text.upper()}


def _contact(need: Need, _exercise: Exercise, program: Program) -> Text:
    negated = need.value.startswith("/")
    address = need.value.lstrip("/ ").upper()
    rung = need.rung.upper()
    for one in lift(program).ladder.rungs:
        if any(address == each.address and negated == each.negated for each in _leading(one, rung)) and matters(
            one, rung, Contact(address, negated), program.dialect
        ):
            return NOTHING
    where = _RUNG.format(rung=need.rung) if need.rung else _ANYWHERE
    return _SAYS["contact"].format(where=where, contact=_CLOSED if negated else _OPEN, value=address)


def _leading(one: Rung, rung: str) -> Iterator[Contact]:
    """Give the contacts on the way from the left rail to what writes `rung`; all contacts where it is empty."""
    stem = tuple(symbols_of(one.stem)) if one.stem else ()
    waiting: list[tuple[Out, tuple[object, ...]]] = [(out, stem) for out in one.outs]
    while waiting:
        out, before = waiting.pop()
        if isinstance(out, Branch):
            waiting += [(each, (*before, *symbols_of(out.stem))) for each in out.outs]
        elif not rung or _writes(out, rung):
            pins = symbols_of(out) if isinstance(out, Box) else ()
            yield from (each for each in (*before, *pins) if isinstance(each, Contact))


def _writes(out: Coil | Box, rung: str) -> bool:
    if isinstance(out, Coil):
        return out.address == rung
    return rung in re.split(r"[\s,]+", out.text)


def _edits(need: Need, exercise: Exercise, program: Program) -> Text:
    start = read(exercise.start, exercise.dialect)
    count = changed([line.text for line in start.lines], [line.text for line in program.lines])
    return _SAYS["edits"].format(value=need.value, count=count) if count > int(need.value) else NOTHING


def changed(old: Sequence[str], new: Sequence[str]) -> int:
    """Count the lines that must be changed, put in or taken out to make one list of another."""
    if max(len(old), len(new)) > _MOST_LINES:
        return max(len(old), len(new))
    costs = list(range(len(new) + 1))
    for number, one in enumerate(old, 1):
        before, costs[0] = costs[0], number
        for place, other in enumerate(new, 1):
            kept = before + (one != other)
            before, costs[place] = costs[place], min(kept, costs[place] + 1, costs[place - 1] + 1)
    return costs[-1]


_CHECKS: dict[str, Callable[[Need, Exercise, Program], Text]] = {
    "most": _most,
    "uses": _uses,
    "avoids": _avoids,
    "contact": _contact,
    "edits": _edits,
}
