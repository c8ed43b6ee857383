"""What the checker answers: equal with a proof, different with a counterexample, or an honest don't-know."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from plcteach.core.diagnostic import Diagnostic

Status = Literal["equal", "different", "unsettled", "unknown", "error"]
Proof = Literal["structural", "table", "exhaustive", "induction"]
Scans = tuple[dict[str, int], ...]


@dataclass(frozen=True, slots=True)
class Counterexample:
    """Inputs, scan by scan, under which the two programs differ, and what each gives at the end of each scan.

    scan, address: the first difference, scans counted from 0. Values are "0", "1" or "x".
    """

    inputs: Scans
    expected: tuple[dict[str, str], ...]
    got: tuple[dict[str, str], ...]
    scan: int
    address: str


@dataclass(frozen=True, slots=True)
class Verdict:
    """The judgement of one submission; `explored` counts states looked at, so that "unknown" says how far."""

    status: Status
    proof: Proof | None = None
    counterexample: Counterexample | None = None
    outputs: dict[str, Status] = field(default_factory=dict)
    diagnostics: tuple[Diagnostic, ...] = ()
    explored: int = 0
    level: str = "exact"

    def __repr__(self) -> str:
        return f"Verdict({self.status}{f', {self.proof}' if self.proof else ''})"
