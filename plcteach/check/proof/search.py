"""The states that two programs can reach together from power-on, visited until an output differs or nothing new appears.

Breadth first is quickest to say whether there is a difference. How to show it to a person is another matter: an operator would
press as few buttons as possible, then wait as short a time as possible. That way is looked for once a difference is known.
"""

from __future__ import annotations

from dataclasses import dataclass
from heapq import heappop, heappush
from typing import TYPE_CHECKING, Literal

from plcteach.check.proof.table import simplest

if TYPE_CHECKING:
    from plcteach.check.proof.budget import Budget
    from plcteach.check.proof.walk import Outcome, Walker

MOST_STATES = 200_000

Place = tuple[int | None, int]
"""A state and the inputs that are held in it (the case of the step that led there, as far as it matters)."""

START: Place = (None, 0)


@dataclass(frozen=True, slots=True)
class Found:
    """What a search ends with. cases: the steps to the difference, or to where a program never rests; states: so many were seen.

    restless: the program that never rests, 0 the reference and 1 the student's; -1 none.
    """

    status: Literal["equal", "different", "unsettled", "unknown"]
    cases: tuple[int, ...] = ()
    states: int = 0
    restless: int = -1


def breadth_first(walker: Walker, budget: Budget) -> Found:
    """Visit state after state; "unknown" where the budget ends first."""
    came: dict[Place, tuple[Place, int] | None] = {START: None}
    waiting = [START]
    for place in waiting:
        if budget.spent or len(came) > MOST_STATES:
            return Found("unknown", states=len(came))
        outcome = walker.step(*place)
        ended = _ended(outcome)
        if ended:
            status, case, side = ended
            return Found(status, (*_way(came, place), case), len(came), side)
        for new, case in _following(walker, outcome):
            if new not in came:
                came[new] = (place, case)
                waiting.append(new)
    return Found("equal", states=len(came))


def _ended(outcome: Outcome) -> tuple[Literal["different", "unsettled"], int, int] | None:
    """Say how a search ends here: with a program that never rests, or with a difference; and in which case."""
    for side, cases in enumerate(outcome.restless):
        if cases:
            return "unsettled", simplest(cases), side
    return ("different", simplest(outcome.bad), -1) if outcome.bad else None


def _following(walker: Walker, outcome: Outcome) -> list[tuple[Place, int]]:
    """Give the places that a step leads to, each with a case that leads there."""
    if not walker.settled:
        return [((state, 0), (cases & -cases).bit_length() - 1) for cases, state in outcome.parts]
    found = []
    for cases, state in outcome.parts:
        seen = set()
        left = cases
        while left:
            case = (left & -left).bit_length() - 1
            left &= left - 1
            held = case & walker.lasting
            if held not in seen:
                seen.add(held)
                found.append(((state, held), case))
    walker.budget.spend(len(found))
    return found


def _way(came: dict[Place, tuple[Place, int] | None], place: Place) -> tuple[int, ...]:
    cases: list[int] = []
    step = came[place]
    while step is not None:
        cases.append(step[1])
        step = came[step[0]]
    return tuple(reversed(cases))


Cost = tuple[int, int, int]
"""Buttons pressed or let go, ticks waited, steps made."""


@dataclass(slots=True)
class _Fewest:
    """The cheapest ways found so far; a node is a place and the case that is about to be run there."""

    walker: Walker
    budget: Budget
    outcomes: dict[Place, tuple[Outcome, dict[int, int | None]]]
    costs: dict[tuple[Place, int], Cost]
    came: dict[tuple[Place, int], tuple[Place, int] | None]
    heap: list[tuple[Cost, int, Place, int]]

    def offer(self, cost: Cost, place: Place, case: int, before: tuple[Place, int] | None) -> None:
        """Take a way into account where it is the cheapest so far."""
        node = (place, case)
        if cost < self.costs.get(node, (1 << 60, 0, 0)):
            self.costs[node], self.came[node] = cost, before
            heappush(self.heap, (cost, len(self.costs), place, case))

    def after(self, place: Place, case: int) -> tuple[bool, int | None, bool]:
        """Say whether a case shows a difference, the state it leads to, and whether it may be at all."""
        known = self.outcomes.get(place)
        if known is None:
            known = self.outcomes[place] = (self.walker.step(*place), {})
        outcome, states = known
        bit = 1 << case
        if outcome.bad & bit:
            return True, None, True
        if case not in states:
            for cases, state in outcome.parts:
                if cases & bit:
                    states[case] = state
                    return False, state, True
            return False, None, False
        return False, states[case], True


def fewest(walker: Walker, budget: Budget) -> tuple[int, ...] | None:
    """Give the steps to a difference that an operator has least to do for; None where the budget ends first."""
    pressed = [place for place in range(len(walker.inputs)) if walker.pressed >> place & 1]
    idle = [place for place in range(len(walker.inputs)) if not walker.pressed >> place & 1]
    drifts = [sum(1 << place for number, place in enumerate(idle) if k >> number & 1) for k in range(1 << len(idle))]
    search = _Fewest(walker, budget, {}, {}, {}, [])
    for drift in drifts:
        search.offer((0, drift.bit_count(), 1), START, drift, None)
    while search.heap and not budget.spent:
        cost, _, place, case = heappop(search.heap)
        if search.costs[place, case] != cost:
            continue
        budget.spend(len(pressed) + len(drifts))
        shows, state, may = search.after(place, case)
        if shows:
            return _steps(search, place, case)
        for button in pressed:
            search.offer((cost[0] + 1, *cost[1:]), place, case ^ 1 << button, search.came[place, case])
        if may:
            held = case & walker.pressed
            new = (state, case & walker.lasting if walker.settled else 0)
            for drift in drifts:
                search.offer((cost[0], cost[1] + drift.bit_count(), cost[2] + 1), new, held | drift, (place, case))
    return None


def _steps(search: _Fewest, place: Place, case: int) -> tuple[int, ...]:
    """Give the cases along the way to a node."""
    cases = [case]
    before = search.came[place, case]
    while before is not None:
        cases.append(before[1])
        before = search.came[before]
    return tuple(reversed(cases))
