"""How a PLC family is declared: its stacks, its areas of memory and its instructions, a row each.

A row that cannot work (an operand nobody declares, a stack that is not there) fails at import and names itself.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Literal

from plcteach.core.area import BYTE, Address, Area, Kind
from plcteach.core.diagnostic import RULES
from plcteach.core.effect import Shape
from plcteach.core.errors import DeclarationError, UnknownNameError
from plcteach.core.text import NOTHING, Text

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from plcteach.core.block import Bank, Block
    from plcteach.core.insn import Insn


@dataclass(frozen=True, slots=True)
class Stack:
    """A stack as the family's books draw it, so many cells deep.

    fixed: it always holds `depth` cells, and where one leaves, an unknown x enters.
    register: the top cell is drawn apart under this name (FX result register, NEZA accumulator), and level 1 is below it.
    """

    name: str
    title: Text
    depth: int
    fixed: bool = False
    register: Text | None = None

    @property
    def shape(self) -> Shape:
        """What the flow of an effect must know of it."""
        return Shape(self.name, self.depth, self.fixed)

    def level(self, position: int) -> Text:
        """Give the learner's name of a position counted from the top, 0 first: level 1, or the register."""
        if self.register and position == 0:
            return self.register
        number = position if self.register else position + 1
        return Text(f"第{number}层", f"level {number}")


@dataclass(frozen=True, slots=True)
class Sample:
    """For one diagnostic a program that triggers exactly it, and the mended program that triggers nothing."""

    code: str
    bad: str
    good: str


@dataclass(frozen=True, slots=True)
class Limit:
    """At most so many cells of one tag at once (FX: blocks, branch points)."""

    tag: str
    most: int
    title: Text


Role = Literal[
    "load", "load_not", "series", "series_not", "parallel", "parallel_not",
    "join_series", "join_parallel", "push", "read", "pop", "copy", "invert", "coil", "set", "reset", "rise", "fall", "end",
]  # fmt: skip


Use = Literal["input", "output", "memory", "step", "word", "timer", "counter"]
"""What an area is for, whatever a family calls it."""


@dataclass(frozen=True)
class Dialect:
    """A PLC family: what its machine has and what its instructions do. Flags carry their reasons.

    list: what the family calls an instruction list.  unit: what it calls a network.
    samples_edges_at_start: edges compare the images of two scan starts (NEZA), not two executions of one line.
    traps: the reader's stack errors stop the machine; where False, x flows instead (S7-200).
    roles: which mnemonic plays which part when a ladder is written out, and in the rules about blocks and branches.
    aliases: other spellings of mnemonics (German).  letters: other letters of areas (German E, A).
    recognised: mnemonics known by name but not run here.
    specials: bits that the system drives: "on", "off", "first" (scan), "later", "cold" (first scan of a cold start), "warm",
    "turns" (one scan on, one off), or the period of a clock in ms ("1000").
    blocks: the function blocks, one row an area.  flags: the bits in which arithmetic leaves what it found.
    wraps: a sum that is too large is cut off; where False, the target stays as it was.
    retentive: for each area the first and last number that outlive a warm start.  constant: the letters before a number
    and its base ("K": 10, "H": 16).
    first_heading: the number of the first network or rung.
    boxes: ladder boxes that the list has no instruction for, with the two instructions that they become.
    patterns: ladder boxes of several inputs that become a fixed list: the inputs' names, and the lines behind their loads, in
    which OUT is the bit that the box writes.
    counterparts: for each use the area that a translation from another family fills with what that family has for it.
    compound_ends: nothing may follow an output of several flows in its network (GUTTA).
    shows_rungs: its program editor shows a network as one rung, or not as a ladder at all (S7-200).
    residue: how bad a leftover at the end of a network is; a warning where the CPU itself does not mind.
    separator: what stands between two operands of a line.
    examples: small programs that together use every instruction; a card shows the first one that uses its own.
    """

    name: str
    title: Text
    list: Text
    unit: Text
    stacks: tuple[Stack, ...]
    areas: tuple[Area, ...]
    kinds: Mapping[str, Kind]
    insns: tuple[Insn, ...]
    roles: Mapping[Role, str]
    samples_edges_at_start: bool = False
    traps: bool = True
    networks_by_title: bool = True
    residue: Literal["error", "warning"] = "error"
    limits: tuple[Limit, ...] = ()
    aliases: Mapping[str, str] = field(default_factory=dict)
    letters: Mapping[str, str] = field(default_factory=dict)
    recognised: frozenset[str] = frozenset()
    specials: Mapping[str, str] = field(default_factory=dict)
    samples: tuple[Sample, ...] = ()
    examples: tuple[str, ...] = ()
    heading: str = "Network"
    first_heading: int = 1
    note_octal: Text = NOTHING
    blocks: tuple[Block, ...] = ()
    flags: Mapping[str, str] = field(default_factory=dict)
    wraps: bool = False
    retentive: Mapping[str, tuple[tuple[int, int], ...]] = field(default_factory=dict)
    constant: Mapping[str, int] = field(default_factory=lambda: {"": 10, "16#": 16, "2#": 2})
    boxes: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    patterns: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    counterparts: Mapping[Use, str] = field(default_factory=dict)
    compound_ends: bool = False
    shows_rungs: bool = False
    separator: str = ", "

    def __post_init__(self) -> None:
        """Tell the instructions how their operands are parted, and refuse a table that contradicts itself."""
        rows = (
            row if row.separator == self.separator else replace(row, separator=self.separator) for row in self.insns
        )
        object.__setattr__(self, "insns", tuple(rows))
        shapes = {stack.name for stack in self.stacks}
        areas = {area.prefix for area in self.areas}
        for row in self.insns:
            for effect in row.effects:
                self._refuse(
                    {clause.stack for clause in effect.clauses} - shapes,
                    f"{row.mnemonic} uses a stack that is not declared",
                )
            kinds = {one.kind for one in row.operands if one.kind}
            self._refuse(kinds - set(self.kinds), f"{row.mnemonic} has an operand kind that is not declared")
        for name, one in self.kinds.items():
            self._refuse(set(one.areas) - areas, f"the kind {name} lies in an area that is not declared")
        self._refuse(set(self.roles.values()) - set(self.words), "a role names an instruction that is not declared")
        mnemonics = [row.mnemonic for row in self.insns]
        self._refuse({one for one in mnemonics if mnemonics.count(one) > 1}, "an instruction is declared twice")
        self._refuse(
            {sample.code for sample in self.samples} - set(RULES), "a sample names a diagnostic that is not declared"
        )

    def _refuse(self, culprits: set[str], reason: str) -> None:
        if culprits:
            msg = f"dialect {self.name}: {reason}: {', '.join(repr(one) for one in sorted(culprits))}"
            raise DeclarationError(msg)

    def __repr__(self) -> str:
        return f"Dialect({self.name!r}, {len(self.insns)} instructions)"

    def __hash__(self) -> int:
        return hash(self.name)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Dialect) and other.name == self.name

    @cached_property
    def words(self) -> dict[str, Insn]:
        """The instructions by mnemonic."""
        return {row.mnemonic: row for row in self.insns}

    @cached_property
    def shapes(self) -> tuple[Shape, ...]:
        """The stacks as the flow of an effect sees them."""
        return tuple(stack.shape for stack in self.stacks)

    @cached_property
    def parts(self) -> dict[str, Role]:
        """The role of each mnemonic that has one."""
        return {mnemonic: role for role, mnemonic in self.roles.items()}

    @cached_property
    def moving(self) -> tuple[str, ...]:
        """The bits that the system drives and that change from scan to scan for ever."""
        return tuple(address for address, what in self.specials.items() if what.isdigit() or what == "turns")

    def special(self, meaning: str) -> str:
        """Give the first bit that the system drives so ("on", "first"); "" where there is none."""
        return next((bit for bit, what in self.specials.items() if what == meaning), "")

    def head(self, number: int) -> str:
        """Give the heading of a network, counted from 0, without its title: "Network 1"."""
        return f"{self.heading} {number + self.first_heading}"

    def example(self, mnemonic: str) -> str:
        """Give the first example that uses an instruction."""
        word, _, area = mnemonic.partition(" ")
        starts = f"{word} {area}" if area else word
        mine = (
            text
            for text in self.examples
            for line in text.split("; ")
            if word in {line.split()[0], re.sub(r"\d+", "", line)} and line.startswith(starts.rstrip(":"))
        )
        return next(mine, "")

    def insn(self, mnemonic: str) -> Insn:
        """Give an instruction by its mnemonic or one of its aliases; UnknownNameError suggests the nearest."""
        word = mnemonic.upper()
        try:
            return self.words[self.aliases.get(word, word)]
        except KeyError:
            what = f"{self.name} instruction"
            raise UnknownNameError(what, mnemonic, self.words) from None

    @cached_property
    def _areas(self) -> dict[str, Area]:
        return {area.prefix: area for area in sorted(self.areas, key=lambda area: -len(area.prefix))}

    def area(self, address: Address) -> Area:
        """Give the area in which an address lies."""
        return self._areas[address.area]

    @cached_property
    def _blocks(self) -> dict[str, Block]:
        return {block.area: block for block in self.blocks}

    def block(self, address: Address) -> Block | None:
        """Give the declaration of the block that an address belongs to, if it belongs to one."""
        return self._blocks.get(address.area)

    def bank(self, address: Address) -> Bank:
        """Give the timing of the timer or counter that an address belongs to."""
        return self._blocks[address.area].bank(address.index)

    def address(self, word: str) -> Address | Area | None:
        """Read an address in any usual spelling; an Area says that it lies outside that area, None that it reads as nothing."""
        upper = word.upper()
        for letters, plain in self.letters.items():
            if upper.startswith(letters) and upper[len(letters) : len(letters) + 2].lstrip("BWD")[:1].isdigit():
                upper = plain + upper[len(letters) :]
        for prefix, area in self._areas.items():
            if not upper.startswith(prefix):
                continue
            found = area.read(upper[len(prefix) :])
            if found is not None:
                return found
        return self._group(upper)

    def _group(self, word: str) -> Address | Area | None:
        """Read a row of bits taken four at a time (K4M0)."""
        match = _GROUP.fullmatch(word)
        area = self._areas.get(match["area"]) if match else None
        if match is None or area is None or not area.groups:
            return None
        first = area.read(match["unit"])
        if not isinstance(first, Address):
            return first
        size = _NIBBLE * int(match["count"])
        inside = area.holds(first.index + size - 1)
        return Address(area.prefix, first.index, f"K{match['count']}{first.text}", size, "K") if inside else area

    def whole(self, address: Address) -> Address:
        """Give the block or timer that a field belongs to."""
        return self.area(address).address(address.index) if address.field else address

    @cached_property
    def _covered(self) -> dict[Address, tuple[Address, ...]]:
        return {}

    def bits_of(self, address: Address) -> tuple[Address, ...]:
        """Give the bits that an address covers, the lowest first; none where it is kept as a number of its own."""
        known = self._covered.get(address)
        if known is None:
            known = self._covered[address] = self._bits_under(address)
        return known

    def _bits_under(self, address: Address) -> tuple[Address, ...]:
        if address.size == 1:
            return (address,)
        area = self.area(address)
        if address.field == "K":
            return tuple(area.address(address.index + place) for place in range(address.size))
        if not area.words:
            return ()
        last = address.size // BYTE - 1
        places = (BYTE * (last - place // BYTE) + place % BYTE for place in range(address.size))
        return tuple(area.address(address.index + place) for place in places)

    def following(self, address: Address, count: int) -> Iterator[Address]:
        """Give `count` addresses from this one on, as S and R with a number write them."""
        area = self.area(address)
        if address.field:
            names_of = [name for name in area.fields if name.isdigit()]
            at = names_of.index(address.field) if address.field in names_of else -1
            whole = area.address(address.index)
            return (area.part(whole, name) for name in names_of[at : at + count]) if at >= 0 else iter((address,))
        return (area.address(address.index + step) for step in range(count) if area.holds(address.index + step))


_GROUP = re.compile(r"K(?P<count>[1-8])(?P<area>[A-Z]+)(?P<unit>[0-9]{1,6})")
_NIBBLE = 4
