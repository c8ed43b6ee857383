"""What a PLC holds between two lines: its bits and words by address, whatever way they are kept.

Bits are kept one by one, and a word over bits (VW100, K4M0) is read from them; registers are kept as numbers. A timer keeps
the ms that it has counted, a step counter its step, and what an address shows of them is worked out when it is asked for.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from plcteach.core.area import BYTE, Address
from plcteach.core.program import Value
from plcteach.machine.arithmetic import number_of
from plcteach.machine.signals import Signal
from plcteach.machine.sums import ordered
from plcteach.machine.words import wrapped

if TYPE_CHECKING:
    from collections.abc import Mapping

    from plcteach.core.area import Kind
    from plcteach.core.program import Arg, Compare, Program
    from plcteach.core.spec import Dialect
    from plcteach.machine.words import Domain

S = TypeVar("S", bound=Signal)


@dataclass(frozen=True, slots=True)
class Memory(Generic[S]):
    """What lasts between scans.

    bits: every bit that is not 0, by address, and what blocks remember in bits.  past: for each line with an edge the value it
    last saw.  image: the bits at the start of the last scan (None before the first).  scans: how many have run.
    words: numbers by address, and what blocks remember in numbers.  now: the virtual time of the last scan's start in ms.
    warm: the run began with a warm start.  stopped: where the CPU has gone to STOP.
    """

    bits: Mapping[str, S] = field(default_factory=dict)
    past: Mapping[int, S] = field(default_factory=dict)
    image: Mapping[str, S] | None = None
    scans: int = 0
    words: Mapping[str, Any] = field(default_factory=dict)
    now: int = 0
    warm: bool = False
    stopped: S | None = None


PIN, SEEN = "<", "?"
"""What stands in the key of a pin's last value, and behind the key that says where there is one."""


def in_word(dialect: Dialect, place: Address) -> bool:
    """Say whether an address is one bit of a word that is kept as a number."""
    return bool(place.field) and place.size == 1 and bool(dialect.area(place).digits)


def owner(dialect: Dialect, key: str) -> Address | None:
    """Give the address that a key belongs to, be it a value or what a block remembers; None where there is none."""
    plain = key.partition(PIN)[0].partition("#")[0]
    found = dialect.address(plain) or dialect.address(plain.rpartition(".")[0])
    return found if isinstance(found, Address) else None


class Store(Generic[S]):
    """The bits and words of one moment, to be read."""

    def __init__(self, program: Program, memory: Memory[S], domain: Domain[S]) -> None:
        self.program = program
        self.dialect = program.dialect
        self.domain = domain
        self.bits = memory.bits
        self.words = memory.words

    def value(self, address: Address) -> Any:
        """Give what an address holds: a bit, or a number."""
        return self.bit(address) if address.size == 1 else self.word(address)

    def bit(self, address: Address) -> S:
        """Give a bit; a step counter's bit and a word's bit are worked out from their number."""
        known = self.bits.get(address.text)
        if known is not None or not address.field:
            return self.domain.zero if known is None else known
        block = self.dialect.block(address)
        if block and block.rule == "steps":
            step = self.number(f"{self.dialect.whole(address).text}.S")
            here: S = step.eq(self.domain.number(int(address.field)))
            return here
        if block and block.rule == "queue" and address.field == "E":
            empty: S = self.domain.number(0).ge(self.number(f"{self.dialect.whole(address).text}#"))
            return empty
        if in_word(self.dialect, address):
            bits: tuple[S, ...] = self.number(self.dialect.whole(address).text).bits(int(address.field) + 1)
            return bits[-1]
        return self.domain.zero

    def kept(self, key: str) -> S:
        """Give a bit by its key."""
        return self.bits.get(key, self.domain.zero)

    def remembered(self, key: str, value: S) -> S | None:
        """Give what a pin saw the last time (None: never before); where it has not seen anything, its value now."""
        last, seen = self.bits.get(key), self.bits.get(key + SEEN)
        return last if last is None or seen is None else self.domain.pick(seen, last, value)

    def number(self, key: str) -> Any:
        """Give a number by its key."""
        found = self.words.get(key)
        return self.domain.number(self.initial(key)) if found is None else found

    def initial(self, key: str) -> int:
        """Give what a number is at power-on: a configured preset, the number of a constant word, else 0."""
        if key in self.program.settings:
            return int(self.program.settings[key].get("", 0))  # type: ignore[arg-type]
        whole, _, name = key.rpartition(".")
        place = self.dialect.address(whole) if name == "P" else None
        return int(self.setting(place, "P")) if isinstance(place, Address) else 0

    def word(self, arg: Arg, kind: Kind | None = None) -> Any:
        """Give the number that an operand of this kind stands for."""
        if isinstance(arg, Value):
            number = number_of(arg, as_real=bool(kind and kind.real))
            whole_number = number is not None and kind is not None and kind.signed and not kind.real
            return self.domain.number(wrapped(number, kind.size) if whole_number else number)  # type: ignore[arg-type, union-attr]
        if isinstance(arg, int):
            return self.domain.number(arg)
        if not isinstance(arg, Address):
            return self.domain.number(None)
        bits = self.dialect.bits_of(arg)
        if bits and arg.size > 1:
            whole = len(bits) >= (kind.size if kind else REGISTER if arg.field else 0)
            return self.domain.join(
                [self.bit(one) for one in bits], signed=whole and (kind.signed if kind else arg.size > BYTE)
            )
        return self._own(arg, kind.size if kind else arg.size, signed=not kind or kind.signed)

    def _own(self, arg: Address, size: int, *, signed: bool) -> Any:
        """Give a number that is kept as such: a register, two of them, a part of one, or a timer's current value."""
        area, block = self.dialect.area(arg), self.dialect.block(arg)
        key = f"{self.dialect.whole(arg).text}.{area.value}" if area.value and not arg.field else arg.text
        if block and block.rule == "timer" and key.endswith(".V"):
            whole = self.dialect.whole(arg)
            return self.number(f"{whole.text}.ms").over(self.base(whole))
        low = self.number(key)
        if max(size, arg.size) > area.size == REGISTER and not block:
            high = self.number(area.address(arg.index + 1).text)
            return self.domain.join((*low.bits(REGISTER), *high.bits(REGISTER)), signed=signed)
        return low.wrap(size, signed=signed) if size < arg.size else low

    def compare(self, compare: Compare) -> S:
        """Say how two words compare."""
        kind = self.dialect.kinds[compare.kind]
        left, right = self.word(compare.left, kind), self.word(compare.right, kind)
        if kind.real:
            left, right = (self.domain.apply(ordered, one) for one in (left, right))
        result: S = _RELATIONS[compare.relation](left, right)
        return result

    def register(self, name: str) -> S:
        """Give a bit of the machine itself."""
        return self.bits.get(name, self.domain.one)

    def setting(self, block: Address, name: str) -> Any:
        """Give what a block is configured to be, as the machine knows it."""
        declared = (self.dialect.block(block).settings or {})[name]  # type: ignore[union-attr]
        said = self.program.settings.get(self.dialect.whole(block).text, {}).get(name, declared.default)
        return declared.choices[str(said)] if declared.choices else said

    def base(self, block: Address) -> int:
        """Give a timer's time base in ms."""
        declared = self.dialect.block(block)
        configured = declared and declared.settings and "TB" in declared.settings
        return int(self.setting(block, "TB")) if configured else self.dialect.bank(block).base

    def output(self, timer: Address) -> str:
        """Give the key of a timer's output bit: a field of its own, or the address itself."""
        declared = self.dialect.block(timer)
        return f"{timer.text}.{declared.bit}" if declared and declared.bit else timer.text

    def preset(self, block: Address, given: Arg | None) -> Any:
        """Give a preset: the operand's, or the one that stands in the block."""
        if given is None:
            return self.number(f"{block.text}.P")
        size = self.dialect.bank(block).size
        kind = next(kind for kind in self.dialect.kinds.values() if kind.size == size and kind.constant and kind.signed)
        return self.word(given, kind)


REGISTER = 16
_RELATIONS = {
    "=": lambda a, b: a.eq(b),
    "<>": lambda a, b: ~a.eq(b),
    ">=": lambda a, b: a.ge(b),
    "<=": lambda a, b: b.ge(a),
    ">": lambda a, b: ~b.ge(a),
    "<": lambda a, b: ~a.ge(b),
}
