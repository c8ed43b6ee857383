"""Ways in which a row of a table can be wrong, and the table with one row changed."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect

ON_BITS = {"coil", "set", "reset"}


def table_with(family: Dialect, made: Insn) -> Dialect:
    """Give a copy of a table with one row changed; a name of its own keeps it apart from the true one."""
    insns = tuple(made if one.mnemonic == made.mnemonic else one for one in family.insns)
    return replace(family, name=f"{family.name} mutant", insns=insns)


def beyond_bits(row: Insn) -> bool:
    """Say whether a row has to do with words, blocks, ENO, or with where the program goes on, and not only with bits."""
    words = any(operand.relation for operand in row.operands) or "ENO" in row.effect.text
    return words or any(verb.name not in ON_BITS or verb.sources for verb in row.then)


def turned(text: str) -> Iterator[str]:
    """Give every effect that differs from this one in a single sign."""
    swaps = {"&": "|^", "|": "&^", "^": "&|"}
    for at, sign in enumerate(text):
        for other in swaps.get(sign, ""):
            yield text[:at] + other + text[at + 1 :]
        if sign == "!":
            yield text[:at] + text[at + 1 :]
    for one, other in (("rise(", "fall("), ("fall(", "rise(")):
        if one in text:
            yield text.replace(one, other, 1)
