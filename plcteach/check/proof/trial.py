"""One comparison from beginning to end: the ways of proving, cheap ones first, until one of them answers.

    no memory        the whole truth table, or a decision diagram
    a short search   all states from power-on, as far as a small budget reaches
    induction        what always agrees, whatever the presets
    a long search    the same with the whole budget
    one by one       each output by itself, with only what matters for it
    by chance        many timelines; finding nothing proves nothing

Budgets count work and never seconds, so that a verdict is the same on every machine.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from plcteach.check.proof.chance import Chance
from plcteach.check.proof.induction import always_equal
from plcteach.check.proof.replay import Replay, replay, rows_of
from plcteach.check.proof.search import Found, breadth_first, fewest
from plcteach.check.proof.table import MOST_ROWS, TooLarge, model_of
from plcteach.check.proof.walk import Budget, Walker
from plcteach.core.verdict import Verdict

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.check.proof.product import Product
    from plcteach.check.proof.walk import Scan
    from plcteach.core.exercise import Terms
    from plcteach.core.program import Program
    from plcteach.core.verdict import Proof, Status

MOST_INPUTS = 12
SHORT, LONG, CHANCES = 1_000_000, 8_000_000, 4_000_000
"""Work for a short search, for a long one, and for trying by chance; a million is something like a tenth of a second."""


@dataclass
class Trial:
    """Two programs on trial: the reference first."""

    programs: tuple[Program, Program]
    terms: Terms
    product: Product
    explored: int = 0
    restless: int = -1

    def decided(self, *, settled: bool, alone: bool = False) -> Verdict:
        """Give the verdict at one level; `alone`: this is already about a single output, and need not be shown."""
        if not self.product.state:
            found = self.by_table()
            if found:
                return found
        searched = len(self.product.inputs) <= MOST_INPUTS
        verdict = self.searched(SHORT, settled=settled, alone=alone) if searched else None
        if verdict is None:
            proved = always_equal(self.product)
            if len(proved) == len(self.product.outputs):
                return self.equal("induction")
            if searched and not alone:
                verdict = self.searched(LONG, settled=settled, alone=alone)
            if verdict is None and not alone and len(self.product.outputs) > 1:
                verdict = self.one_by_one(settled=settled)
        if verdict is None and not settled:
            verdict = self.by_chance()
        return verdict or self.unknown()

    def by_table(self) -> Verdict | None:
        """Decide a comparison in which nothing is remembered; None where it is too large for that."""
        first, later = self.product.first, self.product.later
        for scans, question in ((1, first), (2, later)):
            wrong = self.product.graph.any(question.bad.values()) & question.fair
            try:
                model = model_of(self.product.graph, wrong, rows=MOST_ROWS)
            except TooLarge:
                return None
            self.explored += 1
            if model is not None:
                scan = {name: model.get(name, 0) for name in self.product.inputs}
                return self.shown([scan] * scans) or self.unknown()
        return self.equal("table")

    def searched(self, units: int, *, settled: bool, alone: bool) -> Verdict | None:
        """Search the states from power-on; None where the budget ends first."""
        budget = Budget(units)
        walker = Walker(self.product, budget, settled=settled)
        found = breadth_first(walker, budget)
        self.explored = max(self.explored, found.states)
        if found.status == "equal":
            return self.equal("exhaustive")
        if found.status == "unknown":
            return None
        if found.status == "unsettled":
            self.restless = found.restless
            return Verdict("unsettled", None, None, self.said("unsettled"), explored=self.explored)
        if alone:
            return Verdict("different", None, None, self.said("different"), explored=self.explored)
        return self.different(walker, found) or self.unknown()

    def different(self, walker: Walker, found: Found) -> Verdict | None:
        """Show a difference, with as few presses as can be found; None where the plain machine does not show it."""
        walker.budget.units = SHORT
        best = fewest(walker, walker.budget)
        for cases in (best, found.cases):
            if cases is not None:
                verdict = self.shown(list(walker.scans(cases)), settled=walker.settled)
                if verdict:
                    return verdict
        return None

    def shown(self, scans: Sequence[Scan], *, settled: bool = False) -> Verdict | None:
        """Give the verdict that some scans show, each output judged for itself; None where they show nothing."""
        rows = rows_of(self.product, scans)
        seen = replay(self.programs, rows, self.product.outputs, self.terms) if rows else None
        if seen is None:
            return None
        return Verdict("different", None, seen.example, self.each(seen, settled=settled), explored=self.explored)

    def each(self, seen: Replay, *, settled: bool) -> dict[str, Status]:
        """Judge the outputs that a counterexample says nothing of."""
        said: dict[str, Status] = {}
        for text in self.product.outputs:
            said[text] = "different" if text in seen.wrong else self.judged(text, settled=settled).status
        return said

    def judged(self, text: str, *, settled: bool) -> Verdict:
        """Judge one output by itself."""
        if self.product.later.bad[text].number == 0 and self.product.first.bad[text].number == 0:
            return self.equal("table")
        alone = Trial(self.programs, self.terms, self.product.of([text]))
        verdict = alone.decided(settled=settled, alone=True)
        self.explored = max(self.explored, alone.explored)
        return verdict

    def one_by_one(self, *, settled: bool) -> Verdict | None:
        """Judge each output by itself; a difference is then looked for again, to be shown. None where one stays open."""
        verdicts = {text: self.judged(text, settled=settled) for text in self.product.outputs}
        said: dict[str, Status] = {text: one.status for text, one in verdicts.items()}
        if set(said.values()) == {"equal"}:
            proofs = [one.proof for one in verdicts.values()]
            return self.equal("induction" if "induction" in proofs else "exhaustive")
        for text, one in verdicts.items():
            if one.status == "different":
                alone = Trial(self.programs, self.terms, self.product.of([text]))
                shown = one if one.counterexample else alone.decided(settled=settled)
                if shown.counterexample:
                    return replace(shown, outputs=said | {text: "different"}, explored=self.explored)
        if "equal" in said.values():
            return Verdict("unknown", None, None, said, explored=self.explored)
        return None

    def by_chance(self) -> Verdict | None:
        """Try many timelines; None where nothing differs."""
        trying = Chance(self.product, Budget(CHANCES))
        scans = trying.found()
        self.explored = max(self.explored, trying.scans)
        rows = rows_of(self.product, scans) if scans else None
        seen = replay(self.programs, rows, self.product.outputs, self.terms) if rows else None
        if seen is None:
            return None
        said: dict[str, Status] = {
            text: "different" if text in seen.wrong else "unknown" for text in self.product.outputs
        }
        return Verdict("different", None, seen.example, said, explored=self.explored)

    def equal(self, proof: Proof) -> Verdict:
        """Give the verdict of a proof."""
        return Verdict("equal", proof, None, self.said("equal"), explored=self.explored)

    def unknown(self) -> Verdict:
        """Give the verdict of one who does not know."""
        return Verdict("unknown", None, None, self.said("unknown"), explored=self.explored)

    def said(self, status: Status) -> dict[str, Status]:
        """Say the same of all outputs."""
        return dict.fromkeys(self.product.outputs, status)
