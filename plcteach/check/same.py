"""Whether two programs are the same machine, seen from their inputs and outputs: proved, refuted, or honestly not known.

The machine that is animated is the one that grades: a scan is run once over `Column`s that hold every combination of inputs, so
2^n rows cost one run. Three ways are tried, in this order:

* no memory: all rows of one scan decide (proof "table");
* induction: the remembered bits of both programs are inputs too. Those that always agree are found by splitting classes: at
  first all that are equal after the first scan, then, scan by scan, only those that stay equal if they were. If the outputs
  agree under that hypothesis they agree for ever (proof "induction");
* from power-on: every state that both can reach together is visited, breadth first, all inputs of a scan at once. Running out
  of states is a proof ("exhaustive"), a difference is a counterexample with the fewest scans, and running out of budget is
  "unknown". Budgets count states, never seconds, so that a verdict is the same on every machine.

Programs with time or words in them are only tried (check.tried): a difference is shown, and finding none is "unknown".

At the level "settled" a step is not one scan but as many as both programs need to come to rest with the inputs held.
Edge memories belong to lines, and the two programs need not have the same lines: that is why classes are found, not named.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from plcteach.check.pair import MOST_SETTLING_SCANS, Key, Machine, Pair, either, pair_of
from plcteach.check.tried import LASTING, beyond_bits, different, tried
from plcteach.core.diagnostic import Diagnostic, refuse, rule
from plcteach.core.source import Span
from plcteach.core.verdict import Proof, Status, Verdict
from plcteach.dialects import names
from plcteach.ladder.either import read_either
from plcteach.machine.rows import Rows
from plcteach.machine.scan import run
from plcteach.machine.signals import ONE, ZERO, Column, X

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect

MOST_VARIABLES = 20
MOST_SEARCHED_INPUTS = 12
MOST_STATES = 4_000
MOST_INSTRUCTIONS = 2_000


def compare(
    reference: Program | str,
    student: Program | str,
    dialect: str | Dialect | None = None,
    *,
    outputs: Iterable[str] = (),
    level: str = "exact",
) -> Verdict:
    """Judge whether the student's program does what the reference does; neither may have an error.

    Each may be a program, or the text of a list or a drawing in the family `dialect`, and then PlcTeachError says what is wrong
    with it.  outputs: the addresses compared; by default the outputs that the reference writes.
    level: "exact" compares at the end of every scan; "settled" holds the inputs until both are at rest and compares then;
    "either" takes what is right at one of the two, and says where it reacts later.
    """
    reference, student = _sound(reference, dialect), _sound(student, dialect)
    pair = pair_of(reference, student, tuple(outputs))
    if beyond_bits(reference) or beyond_bits(student):
        return _tried(pair, level)
    if level == "settled":
        return replace(_judged(replace(pair, settled=True)), level=level)
    verdict = _judged(pair)
    if level == "either" and verdict.status in {"different", "unknown"}:
        settled = _judged(replace(pair, settled=True))
        if settled.status == "equal":
            later = rule("CHK003").at(Span(0))
            return replace(settled, level="settled", diagnostics=(*settled.diagnostics, later))
    return verdict


def _judged(pair: Pair) -> Verdict:
    reference, student = pair.reference.program, pair.student.program
    if _same_text(reference, student):
        return _equal(pair, "structural")
    if max(len(reference.lines), len(student.lines)) > MOST_INSTRUCTIONS or len(pair.inputs) > MOST_VARIABLES:
        return Verdict("unknown", outputs=dict.fromkeys(pair.outputs, "unknown"), diagnostics=_beside(pair))
    at_first, after = _first_scan(pair)
    agreed = at_first & _induction(pair, after)
    if len(agreed) == len(pair.outputs):
        proof: Proof = "induction" if pair.state else "table"
        return _equal(pair, proof, 1)
    return _search(pair, agreed)


def _same_text(reference: Program, student: Program) -> bool:
    return _instructions(reference) == _instructions(student) and reference.settings == student.settings


def _sound(text: Program | str, dialect: str | Dialect | None) -> Program:
    if not isinstance(text, str):
        return text
    program = read_either(text, dialect or names()[0])
    refuse(program.diagnostics)
    return program


def _tried(pair: Pair, level: str) -> Verdict:
    """Try two programs with time or words in them; exactly, or so that only a difference that lasts counts."""
    reference, student = pair.reference.program, pair.student.program
    if _same_text(reference, student):
        return _equal(pair, "structural")
    lasting = 1 if level == "exact" else LASTING
    verdict = tried((reference, student), pair.inputs, pair.outputs, _beside(pair), lasting=lasting)
    return replace(verdict, level="settled") if level == "settled" else verdict


def _instructions(program: Program) -> list[list[tuple[str, str]]]:
    """Give a program as its instructions alone: comments, titles and headings do not count."""
    return [[(line.text, line.effect.text) for line in one.lines] for one in program.networks if one.lines]


def _beside(pair: Pair) -> tuple[Diagnostic, ...]:
    """Say which outputs the student writes beyond the reference, and which never."""
    mine, theirs = pair.reference.writes, pair.student.writes
    places = {arg.text: line.span for line in pair.student.program.lines if line.insn.then for arg in line.bits}
    dialect = pair.student.program.dialect
    roles = {arg.text: dialect.area(arg).role for line in pair.student.program.lines for arg in line.bits}
    extra = [
        rule("CHK001").at(places[text], address=text) for text in sorted(theirs - mine) if roles.get(text) == "output"
    ]
    missing = [rule("CHK002").at(Span(0), address=text) for text in pair.outputs if text not in theirs]
    return tuple(extra + missing)


def _first_scan(pair: Pair) -> tuple[set[str], dict[tuple[int, Key], Column]]:
    """Run the first scan from power-on over all inputs: the outputs that agree in it, and the state after."""
    rows = Rows(len(pair.inputs))
    inputs = {address: rows.variable(number) for number, address in enumerate(pair.inputs)}
    differ, after = pair.scan(inputs, {}, rows, first=True)
    return {address for address, cases in differ.items() if not cases}, after


def _simplest(cases: int) -> int:
    """Give the case with the fewest inputs on, the first of those."""
    best, at = -1, 0
    while cases:
        skip = (cases & -cases).bit_length() - 1
        at += skip
        if best < 0 or at.bit_count() < best.bit_count():
            best = at
        if best.bit_count() <= 1:
            return best
        cases >>= skip + 1
        at += 1
    return best


def _induction(pair: Pair, after: dict[tuple[int, Key], Column]) -> set[str]:
    """Find the remembered bits that always agree, and give the outputs that then agree in every later scan."""
    classes = _classes(dict.fromkeys(pair.state, 0), after)
    while True:
        count = len(set(classes.values()))
        if len(pair.inputs) + count > MOST_VARIABLES:
            return set()
        rows = Rows(len(pair.inputs) + count)
        inputs = {address: rows.variable(number) for number, address in enumerate(pair.inputs)}
        state = {key: rows.variable(len(pair.inputs) + number) for key, number in classes.items()}
        differ, then = pair.scan(inputs, state, rows, first=False)
        split = _classes(classes, then)
        if len(set(split.values())) == count:
            return {address for address, cases in differ.items() if not cases}
        classes = split


def _classes(
    old: Mapping[tuple[int, Key], int], values: Mapping[tuple[int, Key], Column]
) -> dict[tuple[int, Key], int]:
    """Split classes: two remembered bits stay together only if they were and are equal."""
    numbers: dict[tuple[int, Column], int] = {}
    return {key: numbers.setdefault((old[key], value), len(numbers)) for key, value in values.items() if key in old}


_State = tuple[str, ...]


def _search(pair: Pair, agreed: set[str]) -> Verdict:
    """Visit the states that both reach from power-on, breadth first, until they differ, end, or use up the budget."""
    rows = Rows(len(pair.inputs))
    inputs = {address: rows.variable(number) for number, address in enumerate(pair.inputs)}
    start: _State = ("",)
    came: dict[_State, tuple[_State, int] | None] = {start: None}
    waiting = [start]
    explored = 0
    while waiting:
        following: list[_State] = []
        for state in waiting:
            explored += 1
            differ, after = pair.scan(inputs, _columns(pair, state, rows), rows, first=state == start)
            cases = either(differ.values())
            if cases:
                case = _simplest(cases)
                return _different(pair, [*_path(came, state), case], agreed, explored)
            if len(pair.inputs) > MOST_SEARCHED_INPUTS or explored >= MOST_STATES:
                return _unknown(pair, agreed, explored)
            for case, new in _successors(pair, after, rows):
                if new not in came:
                    came[new] = (state, case)
                    following.append(new)
        waiting = following
    return _equal(pair, "exhaustive", explored)


def _equal(pair: Pair, proof: Proof, explored: int = 0) -> Verdict:
    return Verdict("equal", proof, None, dict.fromkeys(pair.outputs, "equal"), _beside(pair), explored)


def _unknown(pair: Pair, agreed: set[str], explored: int) -> Verdict:
    outputs: dict[str, Status] = {address: "equal" if address in agreed else "unknown" for address in pair.outputs}
    return Verdict("unknown", None, None, outputs, _beside(pair), explored)


def _columns(pair: Pair, state: _State, rows: Rows) -> dict[tuple[int, Key], Column]:
    bits = {"0": ZERO, "1": ONE, "x": X}
    if state == ("",):
        return {}
    return {key: rows.constant(bits[value]) for key, value in zip(pair.state, state, strict=True)}


def _successors(pair: Pair, after: Mapping[tuple[int, Key], Column], rows: Rows) -> Iterable[tuple[int, _State]]:
    """Give each state that some inputs lead to, once, with the simplest such inputs first."""
    columns = [after[key] for key in pair.state]
    if all(one.may0 == 0 or one.may1 == 0 for one in columns):
        yield 0, tuple(one.at(0) for one in columns)
        return
    seen = set()
    for case in sorted(range(rows.cases), key=int.bit_count):
        new = tuple(one.at(case) for one in columns)
        if new not in seen:
            seen.add(new)
            yield case, new


def _path(came: Mapping[_State, tuple[_State, int] | None], state: _State) -> list[int]:
    cases: list[int] = []
    step = came[state]
    while step is not None:
        cases.append(step[1])
        step = came[step[0]]
    return cases[::-1]


def _different(pair: Pair, cases: list[int], agreed: set[str], explored: int) -> Verdict:
    """Replay the found inputs, held until both are at rest where that is the level."""
    rows = [{address: case >> number & 1 for number, address in enumerate(pair.inputs)} for case in cases]
    scans = _held(pair, rows) if pair.settled else rows
    if not scans:
        return Verdict("unsettled", None, None, dict.fromkeys(pair.outputs, "unsettled"), _beside(pair), explored)
    verdict = different((pair.reference.program, pair.student.program), scans, pair.outputs, agreed)
    return replace(verdict, diagnostics=_beside(pair), explored=explored)


def _held(pair: Pair, rows: list[dict[str, int]]) -> list[dict[str, int]]:
    """Hold each row of inputs until both programs are at rest; nothing, where one of them never is."""
    scans: list[dict[str, int]] = []
    for row in rows:
        for _ in range(MOST_SETTLING_SCANS + 2):
            scans.append(row)
            if all(_at_rest(machine, [*scans, row]) for machine in (pair.reference, pair.student)):
                break
        else:
            return []
    return scans


def _at_rest(machine: Machine, scans: list[dict[str, int]]) -> bool:
    """Say whether the last of some scans changed nothing."""
    last, before = run(machine.program, scans).scans[-1], run(machine.program, scans[:-1]).scans[-1]
    same_bits = all(last[address] == before[address] for address in machine.writes)
    return same_bits and last.after.past == before.after.past
