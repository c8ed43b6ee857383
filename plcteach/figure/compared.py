"""How a comparison is written where people read it: VW0 ≥ 10, whatever the list puts between the two words."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plcteach.core.program import Compare

_SIGNS = {">=": "≥", "<=": "≤", "<>": "≠"}


def comparison(compare: Compare) -> str:
    """Write a comparison as it is read aloud: VW0 ≥ 10."""
    return f"{compare.left.text} {_SIGNS.get(compare.relation, compare.relation)} {compare.right.text}"
