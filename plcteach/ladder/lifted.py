"""What lifting gives: the rungs of a list, which lines made each symbol, and how the ladder grows line by line."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from plcteach.core.ladder import Ladder

if TYPE_CHECKING:
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.ladder import Rung
    from plcteach.core.program import Program

Refs = tuple[tuple[int, int], ...]
"""Symbols of a lifted ladder: the number of the rung, and the number of the symbol in it, both from 0."""


@dataclass(frozen=True, slots=True)
class LiftedRung:
    """A rung, the network that it comes from, and for each of its symbols the lines that made it, its own line first."""

    rung: Rung
    network: int
    sources: tuple[tuple[int, ...], ...]

    def __repr__(self) -> str:
        return f"LiftedRung({self.rung!r}, network {self.network})"


@dataclass(frozen=True, slots=True)
class Growth:
    """What one line of the list does to the ladder.

    added: the symbols that it draws or changes.  top: what the top of the stack stands for after it.  blocks: the two blocks
    that a join joins, the upper first.  out: the coil or box that it drives.
    """

    added: Refs = ()
    top: Refs = ()
    blocks: tuple[Refs, Refs] | None = None
    out: Refs = ()

    def __repr__(self) -> str:
        return f"Growth({len(self.added)} added, {len(self.top)} on top{', a join' if self.blocks else ''})"


@dataclass(frozen=True)
class Lifted:
    """A list as a ladder: every rung that is one, what there is to say about the others, and a growth for each line."""

    program: Program
    rungs: tuple[LiftedRung, ...]
    diagnostics: tuple[Diagnostic, ...]
    growth: tuple[Growth, ...]

    def __repr__(self) -> str:
        return f"Lifted({len(self.rungs)} rungs, {len(self.diagnostics)} remarks)"

    @cached_property
    def ladder(self) -> Ladder:
        """All rungs, from top to bottom, and the lines that set up their blocks."""
        return Ladder(tuple(one.rung for one in self.rungs), configuration=self.program.configuration)
