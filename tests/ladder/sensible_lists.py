"""Random lists that mostly make sense: every join has its block and every pop its push, in the words of any family."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from random import Random

WORDS = {
    "s7-200": (["LD", "LDN"], ["A", "AN", "O", "ON"], ["ALD", "OLD"], ["LPS", "LRD", "LPP"], ["NOT", "EU", "ED", "LDS 1"]),
    "fx": (
        ["LD", "LDI", "LDP"], ["AND", "ANI", "OR", "ORI", "ANDP", "ORF"], ["ANB", "ORB"], ["MPS", "MRD", "MPP"],
        ["INV", "MEP", "MEF"],
    ),
    "neza": (
        ["AND(", "OR(", "AND(N"], ["AND", "ANDN", "OR", "ORN", "XOR", "XORN"], [")"], ["MPS", "MRD", "MPP"],
        ["N", "XORR %I0.0", "ANDF %I0.1"],
    ),
    "gutta": (["LD", "LDN"], ["A", "AN", "O", "ON"], ["ALD", "OLD"], ["LPS", "LRD", "LPP"], ["NOT", "P {memory}", "N {memory}"]),
}  # fmt: skip
"""What begins a block, a contact, a join, the branch instructions, and what acts on the flow."""

COILS = {
    "s7-200": ["= Q0.0", "= M0.0", "S Q0.1, 2", "R Q0.1, 1", "=I Q0.3"],
    "fx": ["OUT Y0", "OUT M0", "SET Y1", "RST Y1", "PLS M1"],
    "neza": ["ST %Q0.0", "ST %M0", "STN %M1", "S %Q0.1", "R %Q0.1"],
    "gutta": ["= Q0.0", "= M0.0", "S Q0.1, 2", "R Q0.1, 1"],
}
BITS = {
    "s7-200": ["I0.0", "I0.1", "I0.2", "M0.0", "Q0.1"],
    "fx": ["X0", "X1", "X2", "M0", "Y1"],
    "neza": ["%I0.0", "%I0.1", "%I0.2", "%M0", "%Q0.1"],
    "gutta": ["I0.0", "I0.1", "I0.2", "M0.0", "Q0.1"],
}


class _List:
    """A list being written, and what waits on its stack: a block (L) or a branch point (B)."""

    def __init__(self, family: str, random: Random) -> None:
        self.family, self.random, self.neza = family, random, family == "neza"
        self.loads, self.contacts, self.joins, self.branches, self.acts = WORDS[family]
        self.cells: list[str] = []
        self.memory = 0
        self.lines = [f"{'LD' if self.neza else random.choice(self.loads)} {self.bit()}"]

    def bit(self) -> str:
        return self.random.choice(BITS[self.family])

    def contact(self) -> None:
        self.lines.append(f"{self.random.choice(self.contacts)} {self.bit()}")

    def load(self) -> None:
        if len(self.cells) < 5:
            self.lines.append(f"{self.random.choice(self.loads)} {self.bit()}")
            self.cells.append("L")

    def join(self) -> None:
        if self.cells and (self.cells[-1] == "L" or self.family == "s7-200"):
            self.cells.pop()
            self.lines.append(self.random.choice(self.joins))

    def push(self) -> None:
        if len(self.cells) < 5 and not (self.neza and "L" in self.cells):
            self.lines.append(self.branches[0])
            self.cells.append("B")

    def branch(self) -> None:
        if self.cells and self.cells[-1] == "B":
            self.lines.append(self.random.choice(self.branches[1:]))
            if self.lines[-1] == self.branches[2]:
                self.cells.pop()

    def act(self) -> None:
        self.memory = self.memory % 7 + 1
        self.lines.append(self.random.choice(self.acts).format(memory=f"M1.{self.memory}"))

    def coil(self) -> None:
        if not (self.neza and "L" in self.cells):
            self.lines.append(self.random.choice(COILS[self.family]))

    def end(self) -> None:
        while self.cells:
            self.lines.append(self.random.choice(self.joins) if self.cells.pop() == "L" else self.branches[2])
            if self.random.random() < 0.5:
                self.contact()
        self.coil()


def sensible(family: str, random: Random, most: int = 14) -> str:
    """Write one network: contacts, blocks, branches and coils, with nothing left over at its end."""
    one = _List(family, random)
    ways = [
        one.contact,
        one.contact,
        one.contact,
        one.load,
        one.join,
        one.push,
        one.branch,
        one.act,
        one.coil,
        one.coil,
    ]
    for _ in range(random.randint(1, most)):
        random.choice(ways)()
    one.end()
    return "\n".join(one.lines)
