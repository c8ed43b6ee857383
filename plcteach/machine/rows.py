"""All combinations of a number of bits at once: the truth table as columns, one big integer a variable."""

from __future__ import annotations

from dataclasses import dataclass

from plcteach.machine.scan import Domain
from plcteach.machine.signals import ONE, ZERO, Column, X


@dataclass(frozen=True, slots=True)
class Rows:
    """The 2^count cases of `count` variables; case k gives variable v bit v of k."""

    count: int

    @property
    def cases(self) -> int:
        """How many cases there are."""
        return 1 << self.count

    @property
    def domain(self) -> Domain[Column]:
        """The constants, each the same in every case."""
        return Domain(self.constant(ZERO), self.constant(ONE), self.constant(X))

    def constant(self, bit: Column) -> Column:
        """Give the column that has one value in every case."""
        every = (1 << self.cases) - 1
        return Column(every * bit.may0, every * bit.may1)

    def variable(self, number: int) -> Column:
        """Give the column of one variable."""
        ones = pattern(number, self.cases)
        return Column(((1 << self.cases) - 1) & ~ones, ones)


def pattern(number: int, cases: int) -> int:
    """Give a variable's values in 2^n cases: case k has bit `number` of k."""
    block = 1 << number
    ones, width = ((1 << block) - 1) << block, block * 2
    while width < cases:
        ones |= ones << width
        width *= 2
    return ones
