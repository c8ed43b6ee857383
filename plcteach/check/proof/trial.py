"""One comparison from beginning to end: the ways of proving, cheap ones first, until one of them answers.

    no memory        the whole truth table, or a decision diagram
    a short search   all states from power-on, as far as a small budget reaches
    induction        what always agrees, whatever the presets
    a long search    the same with the whole budget
    one by one       each output by itself, with only what matters for it
    patience         inputs held until the longest timer is over; finding nothing proves nothing
    by chance        many timelines; nor does it here

Budgets count work and never seconds, so that a verdict is the same on every machine.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from plcteach.check.proof.budget import CHANCES, SHORT, Budget, Means
from plcteach.check.proof.chance import Chance
from plcteach.check.proof.induction import always_equal
from plcteach.check.proof.replay import Replay, replay, rows_of
from plcteach.check.proof.rest import rested
from plcteach.check.proof.search import Found, breadth_first, fewest
from plcteach.check.proof.table import MOST_ROWS, TooLarge, model_of
from plcteach.check.proof.walk import MOST_SETTLING_SCANS, Walker
from plcteach.core.diagnostic import rule
from plcteach.core.source import Span
from plcteach.core.verdict import Verdict

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.check.proof.product import Product, Question
    from plcteach.check.proof.table import Model
    from plcteach.check.proof.walk import Scan
    from plcteach.core.exercise import Terms
    from plcteach.core.program import Program
    from plcteach.core.verdict import Proof, Status

MOST_INPUTS = 12
LASTING = 5
"""A difference that is over sooner may be no more than rungs in another order."""
MOST_CUT = 2_000
"""A longer counterexample is not looked at again scan by scan for a pulse."""


@dataclass
class Trial:
    """Two programs on trial: the reference first.

    restless: the program that never comes to rest.  means: what may still be spent.  proved: outputs that induction has proved.
    parting: scans after which an output differs; none where waiting long has found none.  ghost: a difference was found that no
    time and no clock can bring about, so that no search need be made again.
    """

    programs: tuple[Program, Program]
    terms: Terms
    product: Product
    explored: int = 0
    restless: int = -1
    means: Means = field(default_factory=Means)
    proved: frozenset[str] | None = None
    parting: list[Scan] | None = None
    ghost: bool = False

    def decided(self, *, settled: bool, alone: bool = False) -> Verdict:
        """Give the verdict at one level; `alone`: only its status is asked for, nothing need be shown."""
        verdict = self.attempted(settled=settled, alone=alone)
        calm = self.product.calm()
        if verdict.status == "equal" or calm is self.product:
            return verdict
        again = self.of(calm).attempted(settled=settled, alone=alone)
        return again if again.status in {"different", "unsettled"} else self.unknown()

    def attempted(self, *, settled: bool, alone: bool) -> Verdict:
        """Try one way of proving after another."""
        verdict = self.by_table(settled=settled) if not self.product.state else None
        searched = len(self.product.inputs) <= MOST_INPUTS
        if verdict is None and searched and not self.ghost:
            verdict = self.searched(min(SHORT, self.means.searches.units), settled=settled, alone=alone)
        if verdict is None and not self.ghost:
            verdict = self.proven()
        if verdict is None and searched and not self.ghost:
            verdict = self.searched(self.means.searches.units, settled=settled, alone=alone)
        if verdict is None and len(self.product.outputs) > 1 and not self.ghost:
            verdict = self.one_by_one(settled=settled)
        if verdict is None and not self.ghost:
            verdict = self.waited(settled=settled, alone=alone)
        if verdict is None and not alone:
            verdict = self.by_chance(settled=settled)
        return verdict or self.unknown()

    def of(self, product: Product) -> Trial:
        """Try another question about the same programs, with the means that are left."""
        return Trial(self.programs, self.terms, product, means=self.means)

    def proven(self) -> Verdict | None:
        """Give the verdict of induction, which is asked once; None where it leaves an output open."""
        if self.proved is None:
            self.proved = always_equal(self.product, self.means.inductions)
        return self.equal("induction") if len(self.proved) == len(self.product.outputs) else None

    def by_table(self, *, settled: bool) -> Verdict | None:
        """Decide a comparison in which nothing is remembered; None where it is too large for that.

        At rest the first scan is passed over, and whether it gives a pulse is left to a search.
        """
        for scans, question in ((1, self.product.first), (2, self.product.later))[settled:]:
            try:
                model = self.model(question)
            except TooLarge:
                return None
            self.explored += 1
            if model is not None:
                scan = {name: model.get(name, 0) for name in self.product.inputs}
                shown = self.shown([scan] * scans)
                self.ghost = shown is None
                return shown
        return None if settled else self.equal("table")

    def model(self, question: Question) -> Model | None:
        """Give inputs under which an output differs where nothing is remembered; TooLarge where nobody knows."""
        wrong = self.product.graph.any(question.bad.values()) & question.fair
        return model_of(self.product.graph, wrong, rows=MOST_ROWS)

    def fleeting(self) -> bool:
        """Say whether a difference where nothing is remembered is one of the first scan alone."""
        try:
            return self.model(self.product.later) is None
        except TooLarge:
            return False

    def searched(self, units: int, *, settled: bool, alone: bool) -> Verdict | None:
        """Search the states from power-on; None where the budget ends first."""
        if units <= 0:
            return None
        budget = Budget(units)
        walker = Walker(self.product, budget, settled=settled, pulses=self.terms.level == "either")
        found = breadth_first(walker, budget)
        self.means.searches.spend(units - max(budget.units, 0))
        self.explored = max(self.explored, found.states)
        if found.status == "equal":
            return self.equal("exhaustive")
        if found.status == "unknown":
            return None
        if found.status == "unsettled":
            self.restless = found.restless
            return Verdict("unsettled", None, None, self.said("unsettled"), explored=self.explored)
        if not settled:
            self.parting = list(walker.scans(found.cases))
        if alone:
            return Verdict("different", None, None, self.said("different"), explored=self.explored)
        shown = self.different(walker, found)
        self.ghost = shown is None
        return shown

    def waited(self, *, settled: bool, alone: bool) -> Verdict | None:
        """Hold the inputs for long; None where nothing differs. At rest: with as much rest after each scan as it takes."""
        if self.parting is None:
            trying = Chance(self.product, self.means.waiting)
            self.parting = trying.patient() or []
            self.explored = max(self.explored, trying.scans)
        if not self.parting:
            return None
        if alone and not settled:
            return Verdict("different", None, None, self.said("different"))
        scans = rested(self.product, self.parting) if settled else self.parting
        return self.shown(scans, settled=settled) if scans else None

    def different(self, walker: Walker, found: Found) -> Verdict | None:
        """Show a difference, with as few presses as can be found; None where the plain machine does not show it."""
        walker.budget.units = SHORT
        best = fewest(walker, walker.budget)
        for cases in (best, found.cases):
            if cases is not None:
                scans = list(walker.scans(cases))
                verdict = self.shown(scans, settled=walker.settled) or (self.pulse(scans) if walker.settled else None)
                if verdict:
                    return verdict
        return None

    def pulse(self, scans: Sequence[Scan]) -> Verdict | None:
        """Show a pulse on the way to rest, after which nothing differs any more."""
        rows = rows_of(self.product, scans) or []
        for cut in range(1, MOST_SETTLING_SCANS + 2) if len(rows) < MOST_CUT else ():
            seen = replay(self.programs, rows[:-cut], self.product.outputs, self.terms)
            if seen is not None:
                said = rule("CHK005").at(Span(0), address=seen.example.address)
                return replace(self.differing(seen, settled=True), diagnostics=(said,))
        return None

    def shown(self, scans: Sequence[Scan], *, settled: bool = False) -> Verdict | None:
        """Give the verdict that some scans show, each output judged for itself; None where they show nothing."""
        rows = rows_of(self.product, scans)
        seen = replay(self.programs, rows, self.product.outputs, self.terms) if rows else None
        return self.differing(seen, settled=settled) if seen else None

    def differing(self, seen: Replay, *, settled: bool) -> Verdict:
        """Give the verdict of a difference that the plain machine has shown."""
        said = self.each(seen, settled=settled)
        return Verdict("different", None, seen.example, said, explored=self.explored)

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
        if text in (self.proved or ()):
            return self.equal("induction")
        alone = self.of(self.product.of([text]))
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
                alone = self.of(self.product.of([text]))
                shown = one if one.counterexample else alone.decided(settled=settled)
                if shown.counterexample:
                    return replace(shown, outputs=said | {text: "different"}, explored=self.explored)
        self.proved = frozenset(text for text, one in said.items() if one == "equal")
        return None

    def by_chance(self, *, settled: bool) -> Verdict | None:
        """Try many timelines; None where nothing differs, or not at rest as well."""
        trying = Chance(self.product, Budget(CHANCES))
        scans = trying.found(lasting=LASTING if settled else 1)
        if scans and settled and not self.product.clocks:
            scans = rested(self.product, scans)
        self.explored = max(self.explored, trying.scans)
        rows = rows_of(self.product, scans) if scans else None
        seen = replay(self.programs, rows, self.product.outputs, self.terms) if rows else None
        if seen is None:
            return None
        equal = self.proved or frozenset()
        said: dict[str, Status] = {
            text: "different" if text in seen.wrong else "equal" if text in equal else "unknown"
            for text in self.product.outputs
        }
        return Verdict("different", None, seen.example, said, explored=self.explored)

    def equal(self, proof: Proof) -> Verdict:
        """Give the verdict of a proof."""
        return Verdict("equal", proof, None, self.said("equal"), explored=self.explored)

    def unknown(self) -> Verdict:
        """Give the verdict of one who does not know."""
        equal = self.proved or frozenset()
        said: dict[str, Status] = {text: "equal" if text in equal else "unknown" for text in self.product.outputs}
        return Verdict("unknown", None, None, said, explored=self.explored)

    def said(self, status: Status) -> dict[str, Status]:
        """Say the same of all outputs."""
        return dict.fromkeys(self.product.outputs, status)
