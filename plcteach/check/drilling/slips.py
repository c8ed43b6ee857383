"""The lists that a learner might write by a slip or by a usual wrong idea: one change each, found by comparing effects.

A slip names what its writer believed. Whether it makes a difference is not said here but proved by whoever uses it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from plcteach.core.insn import Insn
    from plcteach.core.program import Line, Program
    from plcteach.core.spec import Dialect


@dataclass(frozen=True, slots=True)
class Slip:
    """A list with one thing changed, why somebody might write it so, and the number of that belief among the usual ones.

    sure: it makes a difference wherever each contact counts; some slips do so in some families only.
    """

    text: str
    because: Text
    misconception: int = 0
    sure: bool = True

    def __repr__(self) -> str:
        return f"Slip({self.because.en!r})"


Change = tuple[int, tuple[str, ...], Text, int]
"""A row from 1, what stands there instead, why, and the belief."""


def slips(program: Program) -> list[Slip]:
    """Give every slip, the most telling first, one of each sort before the second of any."""
    rows = program.source.split("\n")
    sorts = [list(find(program)) for find in _SORTS]
    found: list[Slip] = []
    for turn in range(max(map(len, sorts), default=0)):
        for sort in sorts:
            found += [_made(rows, one) for one in sort[turn : turn + 1]]
    return list({one.text: one for one in reversed(found)}.values())[::-1]


def _made(rows: list[str], change: list[Change]) -> Slip:
    new: dict[int, tuple[str, ...]] = {row: texts for row, texts, _, _ in change}
    kept = [text for number, row in enumerate(rows, 1) for text in new.get(number, (row,))]
    misconception = change[0][3]
    return Slip("\n".join(kept), change[0][2], misconception, misconception not in _UNSURE)


_UNSURE = (10,)
"""To read the branch point where it should be fetched changes nothing where a left-over does no harm."""


# twins


def twin(dialect: Dialect, row: Insn, old: str, new: str) -> Insn | None:
    """Give the instruction that does the same but for one part of its effect; None where there is none."""
    wanted = [text.replace(old, new) if text else text for text in _effects(row)]
    if wanted == _effects(row):
        return None
    return next((one for one in dialect.insns if _effects(one) == wanted and _alike(one, row)), None)


def _effects(row: Insn) -> list[str]:
    return [one.text if one else "" for one in (row.effect, row.fresh, row.bare, row.close)]


def _alike(one: Insn, other: Insn) -> bool:
    """Say whether two rows take an operand each in areas of which one lies in the other, and do the same beside their effect."""
    same = len(one.operands) == len(other.operands) and one.then == other.then
    return same and all(
        (mine.relation, mine.optional) == (theirs.relation, theirs.optional) and mine.kind != "now" != theirs.kind
        for mine, theirs in zip(one.operands, other.operands, strict=True)
    )


def _spelled(line: Line, row: Insn) -> str:
    return f"{row.mnemonic} {line.text.partition(' ')[2]}".strip()


def _twins(
    program: Program, pairs: tuple[tuple[str, str], ...], wanted: Callable[[Line], bool]
) -> Iterator[tuple[Line, Insn]]:
    for line in program.lines:
        for old, new in pairs if wanted(line) else ():
            row = twin(program.dialect, line.insn, old, new)
            if row is not None:
                yield line, row
                break


def joins(program: Program) -> list[Line]:
    """Give the lines that join two blocks: the join, or what opens the parenthesis of the second block."""
    roles = {program.dialect.roles.get("join_series", ""), program.dialect.roles.get("join_parallel", "")}
    return [line for line in program.lines if line.insn.mnemonic in roles or line.insn.close]


def _reads(line: Line) -> bool:
    return bool(line.bits) and not line.insn.then and not line.insn.close


# the sorts of slips


def _wrong_join(program: Program) -> Iterator[list[Change]]:
    """Take the join in series for the join in parallel."""
    because = Text("把块的串联和并联弄反了。", "Takes blocks in series for blocks in parallel, or the other way round.")
    theirs = joins(program)
    for pairs in ((("a&b", "a|b"), ("a|b", "a&b"), ("S0&S1", "S0|S1"), ("S0|S1", "S0&S1")),):
        for line, row in _twins(program, pairs, lambda line: line in theirs):
            yield [(line.span.row, (_spelled(line, row),), because, 6)]


def _no_join(program: Program) -> Iterator[list[Change]]:
    """Leave a join out."""
    because = Text(
        "以为LD只是“下一个触点”，忘了连接。", 'Believes that a load means "and the next contact", and forgets the join.'
    )
    for line in joins(program):
        if not line.insn.close:
            yield [(line.span.row, (), because, 3)]


def _join_too_many(program: Program) -> Iterator[list[Change]]:
    """Write a join for each block."""
    because = Text("以为有几个块就要几条连接指令。", "Believes that n blocks need n joins.")
    for line in joins(program)[-1:]:
        if not line.insn.close:
            yield [(line.span.row, (line.text, line.text), because, 4)]


def _branches(program: Program) -> Iterator[list[Change]]:
    """Write no branch instruction at all, fetch where it should be read, or read where it should be fetched."""
    roles = program.dialect.roles
    at = {
        role: [line for line in program.lines if line.insn.mnemonic == roles.get(role, "")]
        for role in ("push", "read", "pop")
    }
    every = [line for some in at.values() for line in some]
    if every:
        because = Text(
            "以为写完一个输出以后，会自动回到分支点。",
            "Believes that after an output one is back at the branch point by itself.",
        )
        yield [(line.span.row, (), because, 8) for line in every]
    for line in at["read"]:
        because = Text("每一条支路都用出栈指令。", "Fetches the branch point for every branch, not only for the last.")
        yield [(line.span.row, (roles["pop"],), because, 9)]
    for line in at["pop"]:
        because = Text("以为最后一条支路用读栈也一样。", "Believes that reading does for the last branch as well.")
        yield [(line.span.row, (roles["read"],), because, 10)]


def _set_reset(program: Program) -> Iterator[list[Change]]:
    """Take set for reset, or a coil for set."""
    roles = program.dialect.roles
    for line in program.lines:
        if line.insn.mnemonic == roles.get("set") and line.bits:
            because = Text(
                "以为置位和普通线圈一样，条件一断就断开。",
                "Believes that a set coil is like any coil and goes off with its condition.",
            )
            yield [(line.span.row, (f"{roles['coil']} {line.bits[0].text}",), because, 0)]


def _turned_rungs(program: Program) -> Iterator[list[Change]]:
    """Write two neighbouring rungs in the other order."""
    because = Text(
        "以为置位和复位谁在前都一样。", "Believes that it does not matter which of set and reset comes first."
    )
    roles = program.dialect.roles
    kinds = {roles.get("set"), roles.get("reset")}
    some = [one for one in program.networks if one.lines]
    for one, other in pairwise(some):
        if {one.lines[-1].insn.mnemonic, other.lines[-1].insn.mnemonic} == kinds:
            texts = [tuple(line.text for line in each.lines) for each in (other, one)]
            yield [
                (line.span.row, texts[number] if place == 0 else (), because, 21)
                for number, each in enumerate((one, other))
                for place, line in enumerate(each.lines)
            ]


def _edges(program: Program) -> Iterator[list[Change]]:
    """Take one edge for the other, or no edge at all."""
    other = Text("把上升沿和下降沿弄反了。", "Takes the rising edge for the falling one, or the other way round.")
    none = Text("没有取沿，所以不是只接通一个扫描周期。", "Takes no edge, so that it is on for longer than one scan.")
    roles = program.dialect.roles
    both = {roles.get("rise"): roles.get("fall"), roles.get("fall"): roles.get("rise")}
    for line in program.lines:
        if line.insn.mnemonic in both:
            word = both[line.insn.mnemonic] or ""
            yield [(line.span.row, (f"{word} {line.text.partition(' ')[2]}".strip(),), other, 0)]
            yield [(line.span.row, (), none, 18)]
    for line, row in _twins(program, (("rise(bit)", "fall(bit)"), ("fall(bit)", "rise(bit)")), _reads):
        yield [(line.span.row, (_spelled(line, row),), other, 0)]
    for line, row in _twins(program, (("rise(bit)", "bit"), ("fall(bit)", "bit")), _reads):
        yield [(line.span.row, (_spelled(line, row),), none, 18)]


def _presets(program: Program) -> Iterator[list[Change]]:
    """Count one more, or one less."""
    because = Text("预设值差了1。", "Has a preset that is one too many.")
    for line in program.lines:
        if any(verb.name == "drive" and verb.sources for verb in line.insn.then):
            text = _NUMBER.sub(lambda found: str(int(found[0]) + 1), line.text)
            yield [(line.span.row, (text,), because, 0)]
    for number, row in enumerate(program.source.split("\n"), 1):
        if row.strip() in program.configuration and _PRESET.search(row):
            text = _PRESET.sub(lambda found: f"P={int(found[1]) + 1}", row)
            yield [(number, (text,), because, 0)]


_NUMBER = re.compile(r"\d+$")
_PRESET = re.compile(r"\bP=(\d+)")


def _turned_contact(program: Program) -> Iterator[list[Change]]:
    """Take a normally open contact for a normally closed one."""
    because = Text(
        "把常开触点和常闭触点弄反了。",
        "Takes a normally open contact for a normally closed one, or the other way round.",
    )
    for line, row in _twins(program, (("!bit", "bit"), ("bit", "!bit")), _reads):
        if "(bit)" not in line.insn.effect.text:
            yield [(line.span.row, (_spelled(line, row),), because, 0)]


def _kept_coil(program: Program) -> Iterator[list[Change]]:
    """Take a set coil for a plain one."""
    because = Text(
        "把线圈写成了置位，接通以后就不再断开。", "Writes a set coil for a plain one, which then never goes off again."
    )
    coil, kept = (program.dialect.words[program.dialect.roles[role]] for role in ("coil", "set"))
    counted = any(one.number for one in kept.operands)
    for line in program.lines:
        if line.insn is coil:
            text = f"{kept.mnemonic} {line.bits[0].text}{f'{kept.separator}1' if counted else ''}"
            yield [(line.span.row, (text,), because, 0)]


def _turned_connection(program: Program) -> Iterator[list[Change]]:
    """Put a contact in parallel that stands in series."""
    because = Text(
        "把一个触点的串联和并联弄反了。", "Takes a contact in series for one in parallel, or the other way round."
    )
    for line, row in _twins(program, (("a&", "a|"), ("a|", "a&")), _reads):
        yield [(line.span.row, (_spelled(line, row),), because, 0)]


_SORTS: tuple[Callable[[Program], Iterator[list[Change]]], ...] = (
    _wrong_join,
    _no_join,
    _join_too_many,
    _branches,
    _turned_rungs,
    _set_reset,
    _edges,
    _presets,
    _turned_connection,
    _turned_contact,
    _kept_coil,
)
