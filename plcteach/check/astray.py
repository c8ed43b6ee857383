"""Where a learner's program goes astray: the first line of the rung that wrote the wrong value whose value leads nowhere right.

A value is on the way if the reference makes it too: as one of its blocks, or as some of the contacts that it puts in series or
in parallel, in whatever order. Values are compared as functions, not as texts: each address stands for a long row of coin tosses,
and functions that give the same row are the same. This is a help for looking, never a verdict; that has been given before.
"""

from __future__ import annotations

from dataclasses import dataclass
from hashlib import shake_256
from itertools import combinations
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from plcteach.core.text import NOTHING, Text
from plcteach.machine.formula import name, spelled
from plcteach.machine.scan import run
from plcteach.machine.walk import walks

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from plcteach.core.program import Program
    from plcteach.core.verdict import Counterexample
    from plcteach.machine.formula import Term
    from plcteach.machine.scan import Scan
    from plcteach.machine.signals import Column

_TOSSES = 256
_ALL = (1 << 8 * _TOSSES) - 1
_MOST_PARTS = 6
_MOST_NODES = 5_000

_LEAVES = Text(
    "第{row}行的{line}：从这里起，堆栈里的值不再通向{address}应有的结果。",
    "Row {row}, {line}: from here on the value on the stack no longer leads to what {address} should be.",
)
_INSTEAD = Text("和参考程序的{line}比一比。", "Compare it with the reference's {line}.")
_COMES = Text(
    "第{row}行的{line}：{address}要看{bit}，而{bit}从这里起和应有的不一样。",
    "Row {row}, {line}: {address} depends on {bit}, and {bit} is not made here as it should be.",
)
_WRITES = Text(
    "第{row}行的{line}最后写入{address}：得到{got}，应为{wanted}。",
    "Row {row}, {line}, is the last to write {address}: it gives {got}, and {wanted} is expected.",
)
_NOBODY = Text("程序里没有一行写{address}。", "No line of the program writes {address}.")


@dataclass(frozen=True, slots=True)
class Astray:
    """The scan in which the outputs differ, the learner's line and the reference's, counted from 0 (None: there is none), in words.

    says: of the learner's program alone.  beside: what the reference does instead, which is nothing to be said of a hidden one.
    """

    scan: int
    line: int | None
    other: int | None
    says: Text
    beside: Text = NOTHING


@dataclass
class _Side:
    """One of the two programs: its lines with what flows in each, and what each wrote in the scan that is looked at."""

    program: Program
    scan: Scan[Column]

    def __post_init__(self) -> None:
        """Spell out what flows, and note who writes what."""
        self.lines = self.program.lines
        self.flow = spelled(self.program)
        self.starts = list(_starts(self.program))
        self.wrote: dict[str, list[int]] = {}
        for number, line in enumerate(self.lines):
            for _, target in line.targets:
                self.wrote.setdefault(target.text, []).append(number)
        for step in self.scan.steps[: _MOST_NODES * 4]:
            for address, _ in step.written:
                self.wrote.setdefault(address.text, []).append(step.number)

    def rung(self, end: int) -> list[int]:
        """Give the lines whose value goes into a line, in order, that line last."""
        inside = {id(one) for one in _nodes(self.taken(end))}
        first = self.starts[end]
        return [number for number in range(first, end) if id(self.top(number)) in inside] + [end]

    def taken(self, end: int) -> list[Term]:
        """Give what a line takes from the stack."""
        one = self.flow[end]
        return [one.before[stack][place] for stack, place in one.flow.named.values()]

    def top(self, number: int) -> Term:
        """Give what stands on the top after a line; where nothing stands, nobody knows."""
        column = self.flow[number].after[0]
        return column[0] if column else name("x")


def astray(wanted: Program, mine: Program, example: Counterexample) -> Astray:
    """Find where a program goes astray on the inputs that tell it from the reference."""
    theirs, own = (_Side(one, run(one, example.inputs).scans[example.scan]) for one in (wanted, mine))
    address, last = example.address, theirs.wrote.get(example.address, [None])[-1]
    if not own.wrote.get(address):
        return Astray(example.scan, None, last, _NOBODY.format(address=address))
    found = _search(theirs, own, address, set())
    if found:
        at, other, bit = found
        beside = NOTHING if other is None else _INSTEAD.format(line=theirs.lines[other].text)
        says = (_COMES if bit else _LEAVES).format(**_named(own, at), address=address, bit=bit)
        return Astray(example.scan, at, other, says, beside)
    at = own.wrote[address][-1]
    values = {"got": example.got[example.scan][address], "wanted": example.expected[example.scan][address]}
    return Astray(example.scan, at, last, _WRITES.format(**_named(own, at), address=address, **values))


def _search(theirs: _Side, own: _Side, address: str, seen: set[str]) -> tuple[int, int | None, str] | None:
    """Look through the rung that last wrote an address, and then through those that its own bits come from."""
    seen.add(address)
    ends = theirs.wrote.get(address, [])
    rung = own.rung(own.wrote[address][-1])
    known = _known(theirs, ends, own)
    for number in rung[:-1]:
        if known and _print(own.top(number)) not in known:
            return number, _parting(theirs, ends, own, rung), ""
    for bit in (place.text for number in rung for place in own.lines[number].places):
        if bit in seen or bit not in own.wrote or bit not in theirs.wrote:
            continue
        found = _search(theirs, own, bit, seen)
        if found:
            return found
        writer, others = own.lines[own.wrote[bit][-1]], theirs.wrote[bit]
        if writer.text not in {theirs.lines[one].text for one in others}:
            alike = [one for one in others if theirs.lines[one].insn.word == writer.insn.word]
            alike = alike or [
                one for one in others if any(target.text == bit for _, target in theirs.lines[one].targets)
            ]
            return own.wrote[bit][-1], alike[-1] if alike else None, bit
    return None


def _named(side: _Side, number: int) -> dict[str, object]:
    """Give the row and the words of a line, as a sentence names them."""
    line = side.lines[number]
    return {"row": line.span.row or number + 1, "line": line.text}


def _known(theirs: _Side, ends: Iterable[int], own: _Side) -> set[int]:
    """Give all values that lead to an address in the reference, and each contact that the learner may use to get there."""
    known: set[int] = set()
    for end in ends:
        nodes = _nodes([*theirs.taken(end), *(theirs.top(number) for number in theirs.rung(end)[:-1])])
        closed = {id(one.parts[0]) for one in nodes if one.op == "/"}
        open_too = {id(part) for one in nodes if one.op != "/" for part in one.parts} | {
            id(one) for one in theirs.taken(end)
        }
        for node in nodes:
            if id(node) not in closed or id(node) in open_too:
                known.update(_prints(node))
    if known:
        known.update(_tosses(address) for address in own.wrote if address not in theirs.wrote)
    return known


def _parting(theirs: _Side, ends: Iterable[int], own: _Side, rung: Sequence[int]) -> int | None:
    """Give the first line of the reference's rung that makes what the learner's rung never makes."""
    made = {_print(own.top(number)) for number in rung}
    for end in ends:
        for number in theirs.rung(end)[:-1]:
            if _print(theirs.top(number)) not in made:
                return number
    return next(iter(ends), None)


def _starts(program: Program) -> Iterator[int]:
    """Give for each line the line with which its rung begins: one that takes nothing while nothing is waiting to be used."""
    number = 0
    for walk in walks(program):
        start = number
        for move in walk.moves:
            waiting = any(cell.live for cells in move.before for cell in cells)
            if not move.taken and not waiting:
                start = number
            yield start
            number += 1


def _nodes(terms: Iterable[Term]) -> list[Term]:
    """Give some formulas and all their parts, each once, the parts before the whole."""
    found: dict[int, Term] = {}
    waiting = [(term, False) for term in terms]
    while waiting and len(found) < _MOST_NODES:
        one, done = waiting.pop()
        if done:
            found[id(one)] = one
        elif id(one) not in found:
            waiting.append((one, True))
            waiting += [(part, False) for part in one.parts if id(part) not in found]
    return list(found.values())


_thrown: WeakKeyDictionary[Term, int] = WeakKeyDictionary()


def _print(term: Term) -> int:
    """Give the row of tosses that a formula makes of those of its addresses: equal for equal functions."""
    waiting = [term]
    while waiting:
        one = waiting[-1]
        unknown = [part for part in one.parts if part not in _thrown]
        if not unknown:
            _thrown[one] = _value(one, [_thrown[part] for part in one.parts])
            waiting.pop()
        waiting += unknown
    return _thrown[term]


def _value(term: Term, parts: list[int]) -> int:
    match term.op:
        case "·":
            return parts[0] & parts[1]
        case "+":
            return parts[0] | parts[1]
        case "⊕":
            return parts[0] ^ parts[1]
        case "/":
            return ~parts[0] & _ALL
        case "":
            return {"0": 0, "1": _ALL}.get(term.word, _tosses(term.word))
    return _tosses(f"{term.op} {parts}")


def _tosses(word: str) -> int:
    return int.from_bytes(shake_256(word.encode()).digest(_TOSSES), "big")


def _prints(term: Term) -> Iterator[int]:
    """Give the row of a formula, and where it is a series or a parallel those of each choice of its parts."""
    parts = [_print(one) for one in _flat(term)] if term.op in {"·", "+"} else []
    yield _print(term)
    if len(parts) <= _MOST_PARTS:
        for count in range(1, len(parts)):
            for some in combinations(parts, count):
                yield _together(term.op, some)


def _together(op: str, rows: Iterable[int]) -> int:
    whole = _ALL if op == "·" else 0
    for row in rows:
        whole = whole & row if op == "·" else whole | row
    return whole


def _flat(term: Term) -> list[Term]:
    """Give the parts of a series of series, or of a parallel of parallels, in one row."""
    flat: list[Term] = []
    waiting = [term]
    while waiting and len(flat) <= _MOST_PARTS:
        one = waiting.pop()
        if one.op == term.op:
            waiting += one.parts[::-1]
        else:
            flat.append(one)
    return flat
