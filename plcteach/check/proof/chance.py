"""Two programs run where no proof and no search comes to an end: many timelines at once, the same ones everywhere.

Some are patient: two combinations of inputs follow each other, and the second is held until the longest timer is over, or they
take turns until a counter is full. The others go by chance; what they find is then cut down: presses that are not needed are
taken back, many such attempts side by side in one run.
"""

from __future__ import annotations

from itertools import islice
from random import Random
from typing import TYPE_CHECKING

from plcteach.check.proof.replay import free_bits
from plcteach.machine.world import beat

if TYPE_CHECKING:
    from collections.abc import Hashable, Iterable, Iterator, Sequence

    from plcteach.check.proof.budget import Budget
    from plcteach.check.proof.product import Product
    from plcteach.check.proof.walk import Scan

LANES, SCANS = 256, 400
MOST_ROUNDS = 60
PAIRS, PATIENT_SCANS, FREE_SCANS, AT_FIRST = 256, 33_000, 2_000, 3
"""So many pairs of combinations are held, for so many scans (the longest preset and a few; fewer where bits of memory are written
from outside, which is slow to replay); the first one only at first."""
CLOCK_MS = 100
"""So much time passes in a scan where there is no timer, and only clocks tell of it."""
_SEED = 20030907

Rows = list[list[int]]
"""For each scan the value of each input."""


class Chance:
    """The two programs at the end of every scan, run over many timelines."""

    def __init__(self, product: Product, budget: Budget) -> None:
        self.product, self.budget = product, budget
        self.names = product.inputs
        self.scans = 0
        self.tick_ms = product.unit if ("tick",) in self.names else CLOCK_MS
        self.drift = [name in product.drift for name in self.names]
        self.first, self.later = product.scan(first=True), product.scan(first=False)

    def found(self, *, lasting: int = 1) -> list[Scan] | None:
        """Give scans that end with a difference, lasting so many of them; None where none was found."""
        rows = self.timelines()
        ended = self.run(rows, LANES, lasting)
        if ended is None:
            return None
        last, lane = ended
        mine = [[value >> lane & 1 for value in scan] for scan in rows[: last + 1]]
        return [dict(zip(self.names, scan, strict=True)) for scan in self.lessened(mine, lasting)]

    def patient(self) -> list[Scan] | None:
        """Give scans that end with a difference, where inputs are held for long or take turns; None where none was found."""
        pairs = self.pairs()
        ended = self.run(self.waiting(pairs), 2 * len(pairs))
        if ended is None:
            return None
        last, lane = ended
        turns, number = divmod(lane, len(pairs))
        rows = islice(self.waiting([pairs[number]]), last + 1)
        return [{name: value >> turns & 1 for name, value in zip(self.names, row, strict=True)} for row in rows]

    def pairs(self) -> list[tuple[int, int]]:
        """Give pairs of combinations of what an operator can press, a bit for each button; those with few presses first."""
        chance = Random(_SEED)  # noqa: S311 (the same timelines everywhere, on purpose)
        count = self.drift.count(False)
        if 1 << 2 * count <= PAIRS:
            found = {(one, two) for one in range(1 << count) for two in range(1 << count)}
        else:
            single = [0, *(1 << button for button in range(count))]
            found = {(one, two) for one in single[:16] for two in single[:8]}
            while len(found) < PAIRS:
                found.add((chance.getrandbits(count), chance.getrandbits(count)))
        return sorted(found, key=lambda pair: (pair[0].bit_count() + (pair[0] ^ pair[1]).bit_count(), pair))

    def waiting(self, pairs: Sequence[tuple[int, int]]) -> Iterator[list[int]]:
        """Give the scans of two timelines a pair: in the one the second combination is held, in the other they take turns."""
        count = len(pairs)
        every = (1 << 2 * count) - 1
        buttons = [place for place, drifts in enumerate(self.drift) if not drifts]
        one, two = (
            [sum((pair[which] >> bit & 1) << lane for lane, pair in enumerate(pairs)) for bit in range(len(buttons))]
            for which in (0, 1)
        )
        for scan in range(FREE_SCANS if free_bits(self.product) else PATIENT_SCANS):
            row = [every * self.moved(name, scan, scan * self.tick_ms) for name in self.names]
            for place, a, b in zip(buttons, one, two, strict=True):
                row[place] = (a if scan < AT_FIRST else b) | (b if scan & 1 else a) << count
            yield row

    def timelines(self) -> Rows:
        """Give inputs that are turned over now and then: in a quarter of the timelines often, in the others more seldom."""
        chance = Random(_SEED)  # noqa: S311 (the same timelines everywhere, on purpose)
        groups = [((1 << LANES // 4) - 1) << LANES // 4 * number for number in range(4)]
        rows: Rows = []
        now, ms = [0] * len(self.names), 0
        for scan in range(SCANS):
            ms += self.tick_ms if scan else 0
            for place, name in enumerate(self.names):
                if self.drift[place]:
                    now[place] = self.moved(name, scan, ms) * ((1 << LANES) - 1)
                    continue
                turned = 0
                for number, group in enumerate(groups):
                    mask = group
                    for _ in range(1 + 2 * number):
                        mask &= chance.getrandbits(LANES)
                    turned |= mask
                now[place] ^= turned
            rows.append(list(now))
        return rows

    def moved(self, name: Hashable, scan: int, ms: int) -> int:
        """Give what nobody presses: time passes in every scan, and the clocks go by it."""
        match name:
            case ("clock", str(address)):
                return beat(self.product.circuits[0].program.dialect.specials[address], scan, ms)
            case ("tick",):
                return 1
        return 0

    def run(self, rows: Iterable[list[int]], lanes: int, lasting: int = 1) -> tuple[int, int] | None:
        """Run timelines side by side until one shows a difference for so long, its inputs held; give the scan and the timeline."""
        every = alive = (1 << lanes) - 1
        recent: list[int] = []
        state: Sequence[int] = ()
        last: list[int] = []
        for number, scan in enumerate(rows):
            call = self.later if number else self.first
            *state, bad, fair = call.call([*state, *scan], every)
            self.budget.spend(call.cost * (1 + (lanes >> 9)))
            self.scans = max(self.scans, number + 1)
            alive &= fair
            recent = [*(one & ~self.moving(scan, last) for one in recent[1 - lasting :]), bad] if lasting > 1 else [bad]
            last = scan
            shown = alive
            for one in recent:
                shown &= one
            if shown and len(recent) == lasting:
                return number, (shown & -shown).bit_length() - 1
            if not alive or self.budget.spent:
                return None
        return None

    def moving(self, scan: list[int], last: list[int]) -> int:
        """Give the timelines in which an input that can be pressed has changed: a difference that lasts begins anew there."""
        moved = 0
        for now, before, drifts in zip(scan, last, self.drift, strict=False):
            moved |= 0 if drifts else now ^ before
        return moved

    def lessened(self, rows: Rows, lasting: int) -> Rows:
        """Take back presses one by one, as long as a difference remains, and cut off what comes after it."""
        for _ in range(MOST_ROUNDS):
            attempts = self.attempts(rows)
            if not attempts or self.budget.spent:
                return rows
            lanes = [
                [
                    sum(attempt[scan][place] << lane for lane, attempt in enumerate(attempts))
                    for place in range(len(self.names))
                ]
                for scan in range(len(rows))
            ]
            ended = self.run(lanes, len(attempts), lasting)
            if ended is None:
                return rows
            last, lane = ended
            rows = attempts[lane][: last + 1]
        return rows

    def attempts(self, rows: Rows) -> list[Rows]:
        """Give the same scans with one press less each: an input stays as it was until it would have been so again."""
        found: list[Rows] = []
        for place, drifts in enumerate(self.drift):
            if drifts:
                continue
            before = 0
            for scan, row in enumerate(rows):
                if row[place] != before:
                    found.append(_without(rows, place, scan))
                before = row[place]
        return found


def _without(rows: Rows, place: int, scan: int) -> Rows:
    held = 1 - rows[scan][place]
    end = next((later for later in range(scan, len(rows)) if rows[later][place] == held), len(rows))
    return [
        [held if number == place and scan <= at < end else value for number, value in enumerate(row)]
        for at, row in enumerate(rows)
    ]
