"""Round steps for scales and axes: 1, 2 or 5 times a power of ten."""

from __future__ import annotations

import math


def round_step(span: float, parts: float) -> float:
    """Give the smallest round step that cuts a span into at most so many parts."""
    least = max(span, 1e-9) / max(parts, 1)
    power = 10.0 ** math.floor(math.log10(least))
    return next(factor * power for factor in (1, 2, 5, 10) if factor * power >= least * (1 - 1e-9))
