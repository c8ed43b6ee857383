"""Scans taken again with as much rest after each as it takes, to see whether a difference is one at rest as well.

What was found scan by scan may be no more than rungs in another order. Here time passes and inputs change only where both programs
have come to rest, in one case and not in all of them at once, so that it does not matter how many inputs there are.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.check.proof.walk import MOST_SETTLING_SCANS, of_time

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plcteach.check.proof.product import Product
    from plcteach.check.proof.walk import Scan

MOST_SCANS = 60_000


class _Unfit(Exception):  # noqa: N818 (no error: there is nothing to be seen)
    """The programs never rest, or the inputs are such as may not be."""


class _Resting:
    """Two programs on their way from rest to rest. made: the scans so far; bad: whether an output differs at rest."""

    def __init__(self, product: Product) -> None:
        self.names = product.inputs
        self.first, self.later = product.scan(first=True), product.scan(first=False)
        self.state: list[int] | None = None
        self.made: list[Scan] = []
        self.bad = False

    def scan(self, inputs: Scan) -> list[int]:
        """Run one scan and give what is remembered then."""
        values = [inputs[name] for name in self.names]
        found = self.first.call(values, 1) if self.state is None else self.later.call([*self.state, *values], 1)
        *state, bad, fair = found
        if not fair or len(self.made) > MOST_SCANS:
            raise _Unfit
        self.bad = bool(bad)
        return state

    def settle(self, inputs: Scan, still: Scan) -> bool:
        """Run a scan, and others with the inputs held until nothing changes; say whether an output differs then."""
        self.state = self.scan(inputs)
        self.made.append(inputs)
        for _ in range(MOST_SETTLING_SCANS):
            shown = self.bad
            after = self.scan(still)
            if after == self.state:
                if self.bad and not shown:
                    self.made.append(still)
                return self.bad
            self.state = after
            self.made.append(still)
        raise _Unfit


def rested(product: Product, scans: Sequence[Scan]) -> list[Scan] | None:
    """Give scans that end with a difference at rest, made of the given ones; None where they show none."""
    work = _Resting(product)
    held: Scan = {}
    try:
        for scan in scans:
            quiet = {name: 0 if of_time(name) else value for name, value in scan.items()}
            ticked = bool(held) and scan != quiet
            if ticked and work.settle(held | {name: scan[name] for name in scan if of_time(name)}, held):
                return work.made
            if not (ticked and quiet == held) and work.settle(quiet, quiet):
                return work.made
            held = quiet
    except _Unfit:
        pass
    return None
