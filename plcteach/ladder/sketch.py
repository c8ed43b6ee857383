"""The world in which a list draws its ladder: every bit that is read is a contact, and nothing ever happens."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.ladder import Compared, Contact
from plcteach.ladder.piece import Page, Piece, leaf

if TYPE_CHECKING:
    from typing import Literal

    from plcteach.core.insn import Operand
    from plcteach.core.ladder import Relation, Size
    from plcteach.core.program import Compare
    from plcteach.core.spec import Dialect, Role

_SIZES: dict[int, Size] = {8: "B", 16: "", 32: "D"}


class Sketch:
    """A world of contacts; `page` says which line reads them."""

    spells = True
    rail: Piece | None = None

    def __init__(self, dialect: Dialect, page: Page) -> None:
        self.dialect, self.page = dialect, page

    def read(self, operand: Operand, address: Address) -> Piece:
        """Give a contact of the address, immediate where the operand may be nothing but an input."""
        now = directly(self.dialect, operand, "input", "load")
        return leaf(self.page, Contact(address.text, immediate=now), (address,))

    def compare(self, compare: Compare) -> Piece:
        """Give a comparing contact."""
        kind = self.dialect.kinds[compare.kind]
        size: Size = "R" if kind.real else _SIZES[kind.size]
        relation: Relation = compare.relation  # type: ignore[assignment]
        places = tuple(one for one in (compare.left, compare.right) if isinstance(one, Address))
        return leaf(self.page, Compared(compare.left.text, relation, compare.right.text, size), places)

    def register(self, name: str) -> Piece:
        """Give a contact of a bit of the machine itself."""
        return leaf(self.page, Contact(name))

    def past(self, address: Address | None, value: Piece) -> tuple[Piece, Piece | None]:
        """Give the value itself; its edge is a symbol behind it."""
        del address
        return value, None

    def following(self, address: Address, count: int) -> tuple[Address, ...]:
        """Give the address alone; a coil is drawn once, however many bits it reaches."""
        del count
        return (address,)


def directly(dialect: Dialect, operand: Operand, role: Literal["input", "output"], plain: Role) -> bool:
    """Say whether an operand goes past the process image: its areas are of one role only, and it is not the plain one's."""
    base = dialect.words[dialect.roles[plain]].operands[0].kind
    kind = dialect.kinds.get(operand.kind)
    if kind is None or operand.kind == base:
        return False
    return {area.role for area in dialect.areas if area.prefix in kind.areas} == {role} and kind.size == 1
