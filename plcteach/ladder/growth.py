"""How the ladder grows while the list is read: for each line the symbols that it draws, and those that the top stands for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.ladder.lifted import Growth, LiftedRung, Refs

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.ladder.piece import Piece

Read = tuple["Piece | None", "tuple[Piece, Piece] | None"]
"""What a line leaves on the top of the stack, and the two blocks that it joins, if it joins any."""


class Drawn:
    """Where each piece is drawn: its own symbols, wherever they stand."""

    def __init__(self) -> None:
        self.places: dict[int, list[tuple[int, int]]] = {}
        self.known: dict[int, Refs] = {}

    def note(self, rung: int, spans: Iterable[tuple[Piece, int, int]]) -> None:
        """Take over what one rung has drawn."""
        for piece, start, stop in spans:
            self.places.setdefault(id(piece), []).extend((rung, number) for number in range(start, stop))

    def refs(self, piece: Piece | None) -> Refs:
        """Give every symbol that a piece stands for, from the left rail on; known ones are shared."""
        waiting: list[Piece] = []
        while piece is not None and id(piece) not in self.known:
            waiting.append(piece)
            piece = piece.before
        found: Refs = self.known[id(piece)] if piece is not None else ()
        for one in reversed(waiting):
            own = self.places.get(id(one))
            found = tuple(sorted({*found, *own})) if own else found
            self.known[id(one)] = found
        return found


def grown(
    reads: list[Read], rungs: list[LiftedRung], outputs: dict[int, tuple[int, int]], drawn: Drawn
) -> list[Growth]:
    """Give the growth of each line; `outputs`: for each line that makes a coil or a box, where that stands."""
    added: list[list[tuple[int, int]]] = [[] for _ in reads]
    for number, one in enumerate(rungs):
        for symbol, lines in enumerate(one.sources):
            for line in dict.fromkeys(lines):
                added[line].append((number, symbol))
    found = []
    for line, (top, joined) in enumerate(reads):
        blocks = (drawn.refs(joined[0]), drawn.refs(joined[1])) if joined else None
        out = (outputs[line],) if line in outputs else ()
        found.append(Growth(tuple(added[line]), drawn.refs(top), blocks, out))
    return found
