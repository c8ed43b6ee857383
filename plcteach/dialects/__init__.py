"""The four families, one table each; only this room opens the tables, and everyone else asks for them by name."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.errors import UnknownNameError
from plcteach.dialects.fx import FX
from plcteach.dialects.gutta import GUTTA
from plcteach.dialects.neza import NEZA
from plcteach.dialects.s7200 import S7_200, S7_200_SMART

if TYPE_CHECKING:
    from plcteach.core.spec import Dialect

_ALL = {one.name: one for one in (S7_200, S7_200_SMART, FX, NEZA, GUTTA)}


def names() -> tuple[str, ...]:
    """Give the names of all dialects, the first being the default."""
    return tuple(_ALL)


def families() -> tuple[Dialect, ...]:
    """Give the four families, without the variants that differ in depth only."""
    return (S7_200, FX, NEZA, GUTTA)


def dialect(name: str | Dialect) -> Dialect:
    """Give a dialect by its name (any case, `s7-200` or `s7_200`); UnknownNameError suggests the nearest."""
    if not isinstance(name, str):
        return name
    try:
        return _ALL[name.strip().lower().replace("_", "-")]
    except KeyError:
        kind = "dialect"
        raise UnknownNameError(kind, name, _ALL) from None
