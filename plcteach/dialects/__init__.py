"""The four families, one table each; only this room opens the tables, and everyone else asks for them by name."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING

from plcteach.core.effect import Name
from plcteach.core.errors import DeclarationError, UnknownNameError

if TYPE_CHECKING:
    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect

_ALL = {
    "s7-200": ("s7200", "S7_200"),
    "s7-200-smart": ("s7200", "S7_200_SMART"),
    "fx": ("fx", "FX"),
    "neza": ("neza", "NEZA"),
    "gutta": ("gutta", "GUTTA"),
}
"""Where each table stands; one is opened when it is first asked for."""

_FAMILIES = ("s7-200", "fx", "neza", "gutta")


def names() -> tuple[str, ...]:
    """Give the names of all dialects, the first being the default."""
    return tuple(_ALL)


def families() -> tuple[Dialect, ...]:
    """Give the four families, without the variants that differ in depth only."""
    return tuple(map(dialect, _FAMILIES))


def dialect(name: str | Dialect) -> Dialect:
    """Give a dialect by its name (any case, `s7-200` or `s7_200`); UnknownNameError suggests the nearest."""
    if not isinstance(name, str):
        return name
    try:
        return _opened(*_ALL[name.strip().lower().replace("_", "-")])
    except KeyError:
        kind = "dialect"
        raise UnknownNameError(kind, name, _ALL) from None


@cache
def _opened(module: str, table: str) -> Dialect:
    found: Dialect = getattr(import_module(f"plcteach.dialects.{module}"), table)
    return found


def extended(family: str | Dialect, *rows: Insn) -> Dialect:
    """Give a family with further instructions, such as a block that a user has built; DeclarationError says what cannot be.

    An instruction that makes a flow of flows (an input, a compound input) writes nothing: only an output may.
    """
    base = dialect(family)
    for row in rows:
        if row.then and not _is_output(row):
            writes = ", ".join(sorted({verb.target or verb.name for verb in row.then}))
            msg = (
                f"{row.mnemonic} makes a flow ({row.effect.text}), so it is an input, and an input only reads: "
                f"its operands may not be written, and {writes} is. Give the flows back as they are to make it an output."
            )
            raise DeclarationError(msg)
    new = {row.mnemonic for row in rows}
    return replace(
        base,
        name="+".join((base.name, *sorted(new))),
        insns=(*base.insns, *rows),
        recognised=base.recognised - new,
    )


def _is_output(row: Insn) -> bool:
    """Say whether an instruction leaves every stack as it found it."""
    return all(
        [give.formula for give in clause.gives] == [Name(take.name) for take in clause.takes]
        for clause in row.effect.clauses
    )
