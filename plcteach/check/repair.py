"""The one edit that mends a program: every single edit is tried, and what is given has been proved to do what is asked.

Edits are filtered by the counterexamples known so far, replayed on the plain machine, and what passes is handed to the proof; a
proof that fails gives one counterexample more. Work is counted, never timed, so that the same edit is found on every machine.
What is said of a repair in stages (where, of what kind, the edit itself) is true of the edit that was proved.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from plcteach.check.against import verdict_on
from plcteach.check.edits import Edit, Listing, edits
from plcteach.check.repaired import Repair
from plcteach.check.rules import STACK_RULES
from plcteach.check.rungs import network_lines, relevant_lines, rungs
from plcteach.core.diagnostic import errors
from plcteach.core.exercise import Terms
from plcteach.machine.scan import run
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import Any

    from plcteach.core.program import Program
    from plcteach.core.verdict import Verdict

__all__ = ["Repair", "repair"]

MOST_LINES = 200
"""A longer program is not searched: an edit there is for a learner to find rung by rung."""
MOST_WORK = 40_000
"""Instructions read, replayed and proved, all together; the other numbers weigh them by what they cost on the average."""
PER_READING = 3
PER_PROOF = 20
PER_PROOF_IN_TIME = 300
PER_TRIAL = 12_000
"""A proof that did not come to an end has tried many timelines."""
MOST_SCANS = 600
MOST_KNOWN = 8
_HELD = 4
_USUAL = Terms()


def repair(
    reference: Program,
    program: Program,
    terms: Terms = _USUAL,
    *,
    verdict: Verdict | None = None,
    accepts: Callable[[str], bool] | None = None,
) -> Repair | None:
    """Give the first single edit that is proved to make a program do what the reference does; None if none was found.

    verdict: what has been found out about the program already.  accepts: what else a task wants of the mended list.
    """
    if errors(program.diagnostics) or not 0 < len(program.lines) <= MOST_LINES:
        return None
    verdict = verdict or verdict_on(reference, program, terms)
    if verdict.status == "equal":
        return None
    search = _Search(reference, terms)
    search.learn(verdict, program)
    listing = Listing(program, reference, rungs(program))
    relevant, shapes = _scope(verdict, listing)
    tried = {"".join(f"{row}\n" for row in listing.rows)}
    for edit in edits(listing, relevant, shapes=shapes):
        if search.work > MOST_WORK:
            return None
        if edit.text not in tried and search.mends(edit) and (accepts is None or accepts(edit.text)):
            return Repair(edit, program)
        tried.add(edit.text)
    return None


def _scope(verdict: Verdict, listing: Listing) -> tuple[Callable[[int], bool], bool]:
    """Say which lines a repair may touch, and whether only the shape of the list is wrong and not what its contacts read."""
    program = listing.program
    found = errors(verdict.diagnostics) if verdict.status == "error" else []
    if not found:
        return relevant_lines(listing.rungs, program, _wrong(verdict)), False
    places = network_lines(program, found[0].span.row)
    return (lambda number: number in places), all(one.code in STACK_RULES for one in found)


def _wrong(verdict: Verdict) -> tuple[str, ...]:
    """Give the outputs that a repair must touch: the one of the counterexample, else all that are not proved right."""
    if verdict.counterexample and verdict.status == "different":
        return (verdict.counterexample.address,)
    return tuple(one for one, status in verdict.outputs.items() if status != "equal")


@dataclass
class _Replay:
    """Inputs that tell a wrong program from the right one: what an output should be at their end."""

    rows: list[Mapping[str, Any]]
    address: str
    wanted: str


@dataclass
class _Search:
    """What a search has learnt so far, and what it has cost."""

    reference: Program
    terms: Terms
    known: list[_Replay] = field(default_factory=list)
    work: int = 0

    def learn(self, verdict: Verdict, program: Program) -> None:
        """Keep a counterexample, if the difference in it lasts as long as it must."""
        example = verdict.counterexample
        if example is None or len(example.inputs) > MOST_SCANS or len(self.known) >= MOST_KNOWN:
            return
        rows: list[Mapping[str, Any]] = [*example.inputs[: example.scan + 1]]
        if self.terms.level != "exact":
            rows += [{"ms": 0}] * _HELD
        if len(rows) * max(len(program.lines), len(self.reference.lines)) > MOST_WORK // 4:
            return
        replay = _Replay(rows, example.address, self.at_end(self.reference, rows, example.address))
        if self.at_end(program, rows, example.address) != replay.wanted:
            self.known.append(replay)

    def at_end(self, program: Program, rows: list[Mapping[str, Any]], address: str) -> str:
        """Give what an output is when some scans are over; a replay costs its lines."""
        self.work += len(program.lines) * len(rows)
        trace = run(program, rows)
        return repr(trace.value(address, len(trace) - 1)) if len(trace) == len(rows) else ""

    def mends(self, edit: Edit) -> bool:
        """Say whether a list after an edit is readable, passes all known counterexamples, and is proved right."""
        program = read(edit.text, self.reference.dialect)
        self.work += PER_READING * len(program.lines)
        if errors(program.diagnostics):
            return False
        if any(self.at_end(program, one.rows, one.address) != one.wanted for one in self.known):
            return False
        verdict = verdict_on(self.reference, program, self.terms)
        if verdict.status != "error":
            timed = any("drive" in line.insn.does for line in program.lines)
            self.work += (PER_PROOF_IN_TIME if timed else PER_PROOF) * len(program.lines)
            self.work += PER_TRIAL if verdict.status == "unknown" else 0
            self.learn(verdict, program)
        return verdict.status == "equal"
