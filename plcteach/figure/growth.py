"""What a film tells of the ladder beside its list: the drawn rungs, which lines made which sign, and where power is.

The browser is told names of parts, `s0-3` for the fourth sign of the first rung and `n0-2` for a net of its wires, and when
each is lit; it never learns what a contact is.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from plcteach.core.effect import Edge as Turn
from plcteach.core.ladder import Compared, Contact, Edge
from plcteach.figure.ladder import frame_of, rung_scene
from plcteach.figure.power import live_nets, passes
from plcteach.figure.svg import bare
from plcteach.ladder.formulas import formulas
from plcteach.ladder.layout import RAIL, Layout, layout
from plcteach.ladder.lift import Lifted, lift

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from plcteach.core.ladder import Symbol
    from plcteach.core.program import Program
    from plcteach.figure.symbol import Style
    from plcteach.ladder.layout import Placed
    from plcteach.machine.signals import Column
    from plcteach.machine.step import Step

MOST_RUNGS = 200
"""More rungs than this are not drawn beside a film."""
COLUMNS = 8
_FEWEST, _LEFT = 6, 6.0


@dataclass(slots=True)
class Growth:
    """The ladder of one program while its film is being made: what conducts now, and which nets carry power."""

    program: Program
    style: Style = "relay"
    lifted: Lifted = field(init=False)
    plans: list[Layout] = field(init=False)
    closed: dict[tuple[int, int], bool] = field(default_factory=dict)
    lit: dict[int, frozenset[str]] = field(default_factory=dict)
    made_by: dict[int, list[tuple[int, int]]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Lift the program and plan each rung."""
        self.lifted = lift(self.program)
        self.plans = [layout(one.rung) for one in self.lifted.rungs[:MOST_RUNGS]]
        for number, one in enumerate(self.lifted.rungs[:MOST_RUNGS]):
            for at, lines in enumerate(one.sources):
                for line in lines:
                    self.made_by.setdefault(line, []).append((number, at))

    def start(self) -> list[list[Any]]:
        """Begin a scan: nothing has been executed yet, and nothing carries power."""
        gone = [[part, 0] for rung in sorted(self.lit) for part in sorted(self.lit[rung])]
        self.closed.clear()
        self.lit.clear()
        return gone

    def step(self, step: Step[Column]) -> list[list[Any]]:
        """Take what a line has read, and give the parts whose light has changed: [part, 1 or 0]."""
        changed: list[list[Any]] = []
        for rung, at in self.made_by.get(step.number, ()):
            symbol = self.plans[rung].pieces[at].symbol
            own = self.lifted.rungs[rung].sources[at][0] == step.number
            if own or _turned(step, symbol):
                self.closed[rung, at] = _conducts(step, symbol)
                changed += self.changes(rung)
        return changed

    def changes(self, rung: int) -> list[list[Any]]:
        """Give what has been lit in a rung, or has gone out, since the last time."""
        before, now = self.lit.get(rung, frozenset()), frozenset(self.parts(rung))
        self.lit[rung] = now
        return [[part, 1] for part in sorted(now - before)] + [[part, 0] for part in sorted(before - now)]

    def parts(self, rung: int) -> Iterator[str]:
        """Give the parts of a rung that carry power now; what has not been executed in this scan lets none through."""
        plan = self.plans[rung]

        def conducts(piece: Placed, number: int) -> bool:
            del piece
            return self.closed.get((rung, number), False)

        executed = {number for number in range(len(plan.pieces)) if (rung, number) in self.closed}
        live = live_nets(plan, conducts) - self.unborn(plan, executed)
        yield from (f"n{rung}-{net}" for net in live)
        for number, piece in enumerate(plan.pieces):
            if number in executed and passes(piece, number, live, conducts):
                yield f"s{rung}-{number}"

    @staticmethod
    def unborn(plan: Layout, executed: set[int]) -> frozenset[int]:
        """Give the nets behind signs of which none has been executed yet, so that a NOT does not light up too early."""
        born = {plan.pieces[number].target for number in executed} | {RAIL}
        return frozenset({piece.target for piece in plan.pieces if piece.target is not None} - born)

    def joints(self) -> dict[tuple[int, int, bool], int]:
        """Give for each vertical wire (rung, net, opens) that a join makes the line of that join."""
        found: dict[tuple[int, int, bool], int] = {}
        for number, one in enumerate(self.lifted.growth):
            if not one.blocks or not all(one.blocks):
                continue
            (rung, upper), (other, lower) = (block[-1] for block in one.blocks)
            if rung != other or rung >= MOST_RUNGS:
                continue
            pieces, first = self.plans[rung].pieces, one.blocks[1][0][1]
            ends = pieces[upper].target, pieces[lower].target
            if ends[0] == ends[1] and ends[0] is not None:
                found[rung, ends[0], False] = number
            elif ends[0] is not None and pieces[first].source == ends[0]:
                found[rung, ends[0], True] = number
        return found

    def data(self) -> dict[str, Any]:
        """Give the fixed part: the drawn rungs, the lines of each sign, and what each line has drawn and joined."""
        joints = self.joints()
        frame = frame_of(self.plans, COLUMNS, fewest=_FEWEST, left=_LEFT) if self.plans else None
        rungs = [
            {
                "svg": bare(rung_scene(one.rung, number, frame, self.style)) if frame else "",
                "network": one.network,
                "title": one.rung.title,
                "lines": [list(lines) for lines in one.sources],
                "nets": _feeders(self.plans[number]),
                "joints": {
                    f"{net}-{int(opens)}": line for (rung, net, opens), line in joints.items() if rung == number
                },
                "formulas": [list(pair) for pair in formulas(one.rung)],
            }
            for number, one in enumerate(self.lifted.rungs[:MOST_RUNGS])
        ]
        notes = [one.text.as_dict() for one in self.lifted.diagnostics]
        return {
            "rungs": rungs,
            "growth": [self.line(number) for number in range(len(self.program.lines))],
            "notes": notes,
        }

    def line(self, number: int) -> dict[str, Any]:
        """Give what one line has drawn, what the top stands for after it, and the blocks that it joins."""
        one = self.lifted.growth[number]
        told: dict[str, Any] = {"added": _names(one.added), "top": _names(one.top)}
        if one.blocks:
            told["blocks"] = [_names(block) for block in one.blocks]
        return {name: value for name, value in told.items() if value}


def _names(refs: Iterable[tuple[int, int]]) -> list[str]:
    return [f"s{rung}-{at}" for rung, at in refs if rung < MOST_RUNGS]


def _feeders(plan: Layout) -> dict[str, list[int]]:
    """Give for each net the signs on its left, of which one must be there before the wire is."""
    found: dict[str, list[int]] = {}
    for number, piece in enumerate(plan.pieces):
        if piece.target is not None:
            found.setdefault(str(piece.target), []).append(number)
    return found


def _conducts(step: Step[Column], symbol: Symbol) -> bool:
    """Say whether a contact lets power through, by what its line has read; an edge by what the line has made of it."""
    if isinstance(symbol, Contact) and symbol.edge and not _turned(step, symbol):
        return False
    takes = bool(step.flow.named)
    after = repr(step.after[0][0]) if step.after[0] else "0"
    before = repr(step.before[0][0]) if step.before[0] else "0"
    if isinstance(symbol, Edge) or (isinstance(symbol, Contact) and symbol.edge):
        return after == "1" and (not takes or _in_series(step) or before != "1")
    if isinstance(symbol, Contact | Compared):
        if not takes and step.after[0]:
            return after == "1"
        value = repr(step.read[0][1]) if step.read else "0"
        return value == ("0" if isinstance(symbol, Contact) and symbol.negated else "1")
    return False


def _turned(step: Step[Column], symbol: Symbol) -> bool:
    """Say whether a line makes the edge that a sign shows."""
    if not isinstance(symbol, Edge | Contact) or (isinstance(symbol, Contact) and not symbol.edge):
        return False
    found = [give.formula for clause in step.line.effect.clauses for give in clause.gives]
    return isinstance(symbol, Edge) or any(_has_edge(formula) for formula in found)


def _has_edge(formula: Any) -> bool:
    if isinstance(formula, Turn):
        return True
    return any(_has_edge(getattr(formula, name)) for name in ("left", "right", "of") if hasattr(formula, name))


def _in_series(step: Step[Column]) -> bool:
    formula = step.line.effect.clauses[0].gives[-1].formula
    return getattr(formula, "op", "&") == "&"
