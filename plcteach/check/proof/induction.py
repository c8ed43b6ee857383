"""What two programs remember that is always the same, found by guessing and proved by induction over scans.

Twelve timers of 32767 have more states than anybody can visit. But a renamed timer counts in step with its original, and that is
easily proved: if two remembered bits are equal now, they are so after the next scan. So bits are put into classes, at first as
some runs by chance suggest, and a class is split whenever the proof fails, until it holds for all of them together (C. A. J. van
Eijk's signal correspondence). If the outputs cannot differ under what then is known, they never differ.
"""

from __future__ import annotations

from random import Random
from typing import TYPE_CHECKING

from plcteach.check.proof.table import TooLarge, model_of

if TYPE_CHECKING:
    from collections.abc import Hashable, Sequence

    from plcteach.check.proof.budget import Budget
    from plcteach.check.proof.product import Product
    from plcteach.check.proof.table import Model
    from plcteach.machine.gates import Gate

LANES, SCANS, ROUNDS = 128, 24, 200
MOST_MODELS = 64
NODES = 20_000
_SEED = 20030907

Member = tuple[int, int]
"""A remembered bit by its place in the product's state, and 1 where it is the opposite of its class; place -1 is the constant 0."""

Classes = list[list[Member]]


def always_equal(product: Product, budget: Budget | None = None) -> frozenset[str]:
    """Give the outputs that induction proves equal for ever; those that it leaves open may be equal as well."""
    try:
        classes = _guessed(product)
        classes = _based(product, classes, budget)
        proved = _proved(product, classes, budget)
    except TooLarge:
        return frozenset()
    if proved is None:
        return frozenset()
    return frozenset(text for text in product.outputs if _never(product, proved, text, budget))


def _never(product: Product, by: dict[Hashable, Gate], text: str, budget: Budget | None) -> bool:
    """Say whether an output cannot differ, neither in the first scan nor, under what is known, in a later one."""
    graph = product.graph
    try:
        if model_of(graph, product.first.bad[text] & product.first.fair, nodes=NODES, budget=budget) is not None:
            return False
        bad, fair = graph.rewritten([product.later.bad[text], product.later.fair], by)
        return model_of(graph, bad & fair, nodes=NODES, budget=budget) is None
    except TooLarge:
        return False


def _guessed(product: Product) -> Classes:
    """Put those bits together that were the same, or opposite, in many runs by chance."""
    chance = Random(_SEED)  # noqa: S311 (the same guesses everywhere, on purpose)
    every = (1 << LANES) - 1
    graph, count = product.graph, len(product.state)
    first = graph.compiled([*(product.start[name] for name in product.state), product.first.fair], product.inputs)
    later = graph.compiled(
        [*(product.next[name] for name in product.state), product.later.fair], (*product.state, *product.inputs)
    )
    held = [chance.getrandbits(LANES) for _ in product.inputs]
    *state, fair = first.call(held, every)
    traces = [value & fair for value in state]
    alive = fair
    for _ in range(1, SCANS):
        held = [one ^ (chance.getrandbits(LANES) & chance.getrandbits(LANES)) for one in held]
        *state, fair = later.call([*state, *held], every)
        alive &= fair
        traces = [trace << LANES | value & alive for trace, value in zip(traces, state, strict=True)]
        if not alive:
            break
    return _grouped(traces, count, sure=alive == every)


def _grouped(traces: Sequence[int], count: int, *, sure: bool) -> Classes:
    """Group bits by what they did; the constant 0 is one of them. Opposites only where every run counted to its end."""
    groups: dict[int, list[Member]] = {0: [(-1, 0)]}
    longest = max((trace.bit_length() for trace in traces), default=0)
    whole = (1 << max(longest, 1)) - 1
    for place in range(count):
        trace, opposite = traces[place], 0
        if sure and trace & 1:
            trace, opposite = trace ^ whole, 1
        groups.setdefault(trace, []).append((place, opposite))
    return list(groups.values())


def _based(product: Product, classes: Classes, budget: Budget | None) -> Classes:
    """Split the classes until they hold after the first scan."""
    ends = [product.start[name] for name in product.state]
    for _ in range(ROUNDS):
        models = _against(product, classes, (ends, product.first.fair), budget)
        if not models:
            return classes
        values = _replayed(product, ends, product.inputs, models, {})
        classes = _split(classes, values, len(models))
    raise TooLarge


def _proved(product: Product, classes: Classes, budget: Budget | None) -> dict[Hashable, Gate] | None:
    """Split the classes until each scan keeps them, and give what then stands for each remembered bit."""
    graph, ends = product.graph, [product.next[name] for name in product.state]
    for _ in range(ROUNDS):
        by = _leaders(product, classes)
        *then, fair = graph.rewritten([*ends, product.later.fair], by)
        models = _against(product, classes, (then, fair), budget)
        if not models:
            return by
        names = (*product.state, *product.inputs)
        values = _replayed(product, then, names, models, by)
        new = _split(classes, values, len(models))
        if len(new) == len(classes):
            return None
        classes = new
    return None


def _leaders(product: Product, classes: Classes) -> dict[Hashable, Gate]:
    """Give for each remembered bit the first of its class, or its opposite."""
    graph, by = product.graph, {}
    for (leader, turned), *others in classes:
        base = graph.zero if leader < 0 else graph.variable(product.state[leader])
        for place, opposite in others:
            by[product.state[place]] = ~base if opposite != turned else base
    return by


def _against(
    product: Product, classes: Classes, after: tuple[Sequence[Gate], Gate], budget: Budget | None
) -> list[Model]:
    """Give some cases in which members of a class part; `after`: what all bits become, and where that may be."""
    (ends, fair), graph = after, product.graph
    models: list[Model] = []
    for (leader, turned), *others in classes:
        first = graph.zero if leader < 0 else ends[leader]
        for place, opposite in others:
            parted = first ^ ends[place] if opposite == turned else ~(first ^ ends[place])
            model = model_of(graph, parted & fair, nodes=NODES, budget=budget)
            if model is not None:
                models.append(model)
                if len(models) >= MOST_MODELS:
                    return models
    return models


def _replayed(
    product: Product, ends: Sequence[Gate], names: Sequence[Hashable], models: list[Model], by: dict[Hashable, Gate]
) -> list[int]:
    """Work out what all remembered bits become in some cases, side by side."""
    every = (1 << len(models)) - 1
    free = [name for name in names if name not in by]
    given = [sum(model.get(name, 0) << lane for lane, model in enumerate(models)) for name in free]
    return list(product.graph.compiled(ends, free).call(given, every))


def _split(classes: Classes, values: Sequence[int], lanes: int) -> Classes:
    """Split classes by what their members have become."""
    every = (1 << lanes) - 1
    found: Classes = []
    for members in classes:
        groups: dict[int, list[Member]] = {}
        for place, opposite in members:
            value = 0 if place < 0 else values[place]
            groups.setdefault(value ^ every if opposite else value, []).append((place, opposite))
        found += groups.values()
    return found
