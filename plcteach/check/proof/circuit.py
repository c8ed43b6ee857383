"""A program as a circuit: for its first scan and for every later one, what each output and each remembered bit becomes.

The scan is run by the machine itself, over gates. What it remembers is found by running it: at first nothing is remembered but
what the first scan leaves; a remembered bit that a later scan leaves as it was is a constant, and any other becomes a variable,
until nothing new appears. Time is a `tick`: in each scan either none passes or as much as the smallest time base.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from plcteach.check.proof.bounds import Bound, bounds, natural
from plcteach.core.area import Address
from plcteach.machine.course import Course, Mixed
from plcteach.machine.gates import Bit, Blurred, Gate, Graph, Unprovable
from plcteach.machine.store import PIN, SEEN, Memory, Store
from plcteach.machine.words import Vector, constant
from plcteach.machine.world import Plant

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from plcteach.core.area import Kind
    from plcteach.core.program import Arg, Program
    from plcteach.machine.step import Step

Key = tuple[Any, ...]
"""What is remembered: ("bit", key), ("word", key, place), ("past", line), ("image", address) or ("stop",)."""

TICK = ("tick",)
WIDE = 40
MOST_ROUNDS, MOST_STEPS = 40, 5_000
MOST_NUMBER_BITS = 800
"""A program that remembers more bits in its numbers is too large for a proof (forty timers of the largest preset)."""


def bases(program: Program) -> set[int]:
    """Give the time bases, in ms, of all timers that a program names."""
    store: Store[Any] = Store(program, Memory(), None)  # type: ignore[arg-type]
    found = set()
    for place in (place for line in program.lines for place in line.places):
        block = program.dialect.block(place)
        if block and block.rule == "timer":
            found.add(store.base(program.dialect.whole(place)))
    return found


@dataclass
class Setting:
    """Where two programs are built side by side: one graph, one unit of time (ms), and the bits that are free for both."""

    graph: Graph
    unit: int
    free: frozenset[str] = frozenset()


class _Scaled(Store[Any]):
    """A store whose times are counted in units."""

    unit: int

    def base(self, block: Address) -> int:
        """Give a timer's time base in units."""
        return super().base(block) // self.unit


class _Gated(_Scaled, Plant[Any]):
    """A plant of gates, in which time comes in ticks and the clocks are free."""

    def __init__(self, setting: Setting, side: int, program: Program, memory: Memory[Any]) -> None:
        self.graph, self.unit, self.side = setting.graph, setting.unit, side
        self.pending: Any = None
        inputs = _inputs(setting, program)
        super().__init__(program, memory, inputs, setting.graph.domain)
        self.touched = {
            number
            for number, line in enumerate(program.lines)
            if any(target in line.places for target, _, moment in self.clocks if moment == "always")
        }

    def lapse(self, ms: int) -> Any:
        """Give the time since the last scan in units: none or one, and none before the first."""
        del ms
        self.pending = self.graph.variable(TICK) if self.scans else self.graph.zero
        return Vector((self.pending, self.graph.zero), self.graph.zero)

    def share(self, first: int, stop: int, of: int) -> Any:
        """Let the tick of the fastest timers come somewhere in the scan, nobody knows where; at its end at the latest."""
        here = self.pending
        if stop < of and self.scans:
            here = here & self.graph.variable(("here", self.side, first, stop))
        self.pending = self.pending & ~here
        return Vector((here, self.graph.zero), self.graph.zero)

    def word(self, arg: Arg, kind: Kind | None = None) -> Any:
        """Give a number; Unprovable where one of its bits may be x, for then nobody knows the whole of it."""
        found = super().word(arg, kind)
        if isinstance(found, Vector) and any(isinstance(one, Blurred) for one in found.signs):
            raise Unprovable
        return found

    def keep(self, one: Step[Any], run: Any = None) -> None:
        """Take over what a step wrote; a number that has grown wider than it can ever be loses the bits that are always 0."""
        super().keep(one, run)
        for key, _ in one.numbers:
            value = self.words[key]
            if len(value.signs) > WIDE:
                bound = natural(self, key)
                self.words[key] = value.wrap(bound.size + bound.signed, signed=bound.signed)

    def at(self, line: int, of: int) -> None:
        """Come to a line; only where a line looks at a fast timer does it matter when the tick comes."""
        if line in self.touched or line + 1 == of or not self.reached:
            super().at(line, of)
        else:
            self.line = line

    def driven(self) -> dict[str, Any]:
        """Give the bits that the system drives: a clock is 0 at first, and then nobody knows."""
        found: dict[str, Any] = super().driven()
        if not self.scans:
            return found
        for address in self.dialect.moving:
            if self.dialect.specials[address] == "turns":
                found[address] = ~self.memory.bits[address]
            else:
                found[address] = self.graph.variable(("clock", address))
        return found


def _inputs(setting: Setting, program: Program) -> dict[str, Any]:
    """Give a variable for each input that a program names, made in the order in which it names them, and for each free bit."""
    found: dict[str, Any] = {}
    dialect, graph = program.dialect, setting.graph
    for place in (place for line in program.lines for place in line.places if dialect.area(place).role == "input"):
        bits = dialect.bits_of(place)
        if not bits:
            found[place.text] = _free_word(graph, place)
        found |= {one.text: graph.variable(("in", one.text)) for one in bits}
    names = [one.text for one in program.addresses("input")] + sorted(setting.free)
    return found | {name: graph.variable(("in", name)) for name in names}


def _free_word(graph: Graph, place: Address) -> Vector[Any]:
    signs = tuple(graph.variable(("in", place.text, number)) for number in range(place.size))
    return Vector(signs, graph.zero)


@dataclass
class Circuit:
    """A program in gates. first, later: the memory after the first scan, and after any other one.

    start, next: for each remembered bit that is not the same for ever its gate after the first scan and after a later one.
    reads, writes: the addresses that it names in doing so.
    """

    graph: Graph
    program: Program
    first: Memory[Any]
    later: Memory[Any]
    start: dict[Key, Bit]
    next: dict[Key, Bit]
    reads: set[str] = field(default_factory=set)
    writes: set[str] = field(default_factory=set)

    def value(self, memory: Memory[Any], address: Address) -> Any:
        """Give what an address holds in a memory: a bit, or a number; Unprovable for a timer's, which is counted in units."""
        block = self.program.dialect.block(address)
        if block and block.rule == "timer" and address.size > 1:
            raise Unprovable
        return Store(self.program, memory, self.graph.domain).value(address)


class _Builder:
    """One program being turned into a circuit."""

    def __init__(self, setting: Setting, side: int, program: Program) -> None:
        self.setting, self.side, self.program = setting, side, program
        self.graph = setting.graph
        self.reads: set[str] = set()
        self.writes: set[str] = set()
        self.ranges: dict[str, Bound] = {}
        self.past_image = program.dialect.samples_edges_at_start
        self.taken = {one.text for one in program.addresses("input")} | setting.free
        self.taken |= {address for address, what in program.dialect.specials.items() if what != "turns"}
        self.known: dict[Key, Bit] = {}
        self.start: dict[Key, Bit] = {}
        self.late: set[Key] = set()

    def scan(self, memory: Memory[Any]) -> tuple[dict[Key, Bit], Memory[Any]]:
        """Run one scan and give what it leaves."""
        course = Course(_Gated(self.setting, self.side, self.program, memory))
        try:
            for number, one in enumerate(course.steps()):
                self.watch(one)
                if number > MOST_STEPS:
                    raise Unprovable
        except Mixed:
            raise Unprovable from None
        if course.found:
            raise Unprovable
        after = course.world.after()
        self.writes |= {key for key in after.bits if key not in self.taken}
        return self.flat(after), after

    def watch(self, one: Step[Any]) -> None:
        self.reads.update(address.text for address, _ in one.read)
        self.writes.update(address.text for address, _ in one.written)
        if one.line.insn.does & {"set", "reset"}:
            self.reads.update(address.text for address, _ in one.written)

    def flat(self, memory: Memory[Any]) -> dict[Key, Bit]:
        """Give a memory bit by bit."""
        found: dict[Key, Bit] = {("bit", key): value for key, value in memory.bits.items() if key not in self.taken}
        store = _Scaled(self.program, Memory(), self.graph.domain)
        store.unit = self.setting.unit
        fresh = [key for key in memory.words if key not in self.ranges]
        self.ranges |= bounds(self.program, store, fresh)
        for key, value in memory.words.items():
            if not self._is_input(key):
                found |= {("word", key, place): bit for place, bit in enumerate(self._bits(key, value))}
        found |= {("past", line): value for line, value in memory.past.items()}
        if self.past_image:
            found |= {("image", key): value for key, value in (memory.image or {}).items()}
        if memory.stopped is not None:
            found["stop",] = memory.stopped
        return found

    def _is_input(self, key: str) -> bool:
        place = self.program.dialect.address(key)
        return isinstance(place, Address) and self.program.dialect.area(place).role == "input"

    def _bits(self, key: str, value: Vector[Any]) -> list[Bit]:
        """Give a number as so many bits, held at the last value that matters."""
        bound = self.ranges[key]
        if bound.most is not None:
            domain = self.graph.domain
            most = constant(bound.most, self.graph.zero)
            value = domain.pick(value.ge(most), most, value)
        return [value.at(place) for place in range(bound.size + bound.signed)]

    def memory(self, known: Mapping[Key, Bit]) -> Memory[Any]:
        """Put bits together to a memory, as it is before a later scan."""
        words: dict[str, list[Any]] = {}
        parts: dict[str, dict[Any, Bit]] = {"bit": {}, "past": {}, "image": {}, "stop": {}}
        for key, value in known.items():
            if key[0] == "word":
                words.setdefault(key[1], []).append(value)
            else:
                parts[key[0]][key[1] if len(key) > 1 else ""] = value
        zero = self.graph.zero
        numbers = {
            key: Vector(tuple(bits) if self.ranges[key].signed else (*bits, zero), zero) for key, bits in words.items()
        }
        image = parts["image"] if self.past_image else {}
        return Memory(parts["bit"], parts["past"], image, 1, numbers, stopped=parts["stop"].get(""))

    def built(self) -> Circuit:
        """Run the first scan, then later ones until what is remembered is known."""
        self.start, first = self.scan(Memory())
        if sum(bound.size for bound in self.ranges.values()) > MOST_NUMBER_BITS:
            raise Unprovable
        self.known = {key: self.guess(key, value) for key, value in self.start.items()}
        for _ in range(MOST_ROUNDS):
            after, later = self.scan(self.memory(self.known))
            self.seen(after)
            if set(self.known) - set(after):
                raise Unprovable
            if not self.learned(after):
                moving = [key for key, value in self.known.items() if not _fixed(value)]
                start, then = {key: self.start[key] for key in moving}, {key: after[key] for key in moving}
                return Circuit(self.graph, self.program, first, later, start, then, self.reads, self.writes)
        raise Unprovable

    def seen(self, after: dict[Key, Bit]) -> None:
        """Let what an edge saw last count only from the scan on in which its line was first executed, where that is a later one."""
        for key in after:
            if key not in self.known and key not in self.late and (mark := _mark(key)) is not None:
                self.late.add(mark)
        for mark in self.late:
            after.setdefault(mark, self.graph.one)

    def guess(self, key: Key, value: Bit) -> Bit:
        """Take a remembered bit for a constant where it is one after the first scan."""
        return value if _fixed(value) else self.variable(key, blurred=not isinstance(value, Gate))

    def variable(self, key: Key, *, blurred: bool) -> Bit:
        plain = self.graph.variable((self.side, *key))
        if not blurred:
            return plain
        unknown = self.graph.variable((self.side, *key, "x"))
        return Blurred(plain & ~unknown, unknown)

    def learned(self, after: Mapping[Key, Bit]) -> bool:
        """Take up what is remembered beyond what was known, or is no constant after all; False where all was known."""
        learned = False
        for key, value in after.items():
            known = self.known.get(key)
            if known is None:
                learned = True
                self.start[key] = self.default(key)
                known = self.known[key] = self.start[key]
            blurred = not isinstance(value, Gate)
            if (_fixed(known) and not _same(value, known)) or (blurred and isinstance(known, Gate)):
                learned = True
                self.known[key] = self.variable(key, blurred=blurred)
        return learned

    def default(self, key: Key) -> Bit:
        """Give what a remembered bit is at power-on."""
        if key[0] != "word":
            return self.graph.zero
        store: Store[Any] = Store(self.program, Memory(), self.graph.domain)
        value = constant(store.initial(key[1]), self.graph.zero)
        bit: Bit = value.at(key[2])
        return bit


def _mark(key: Key) -> Key | None:
    """Give the key that says whether an edge has seen anything yet, for the key of what it saw last."""
    if key[0] == "past":
        return ("past", ~key[1]) if key[1] >= 0 else None
    if key[0] == "bit" and PIN in key[1] and not key[1].endswith(SEEN):
        return ("bit", key[1] + SEEN)
    return None


def _fixed(value: Bit) -> bool:
    return isinstance(value, Gate) and value.number < 2  # noqa: PLR2004 (the constants)


def _same(one: Bit, other: Bit) -> bool:
    return one is other or one == other


def circuit(setting: Setting, side: int, program: Program) -> Circuit:
    """Turn a program into a circuit; Unprovable where it does what no circuit does, or too much of it."""
    return _Builder(setting, side, program).built()


def split(bits: Iterable[tuple[Key, Bit]]) -> dict[Key, Gate]:
    """Give bits as gates, one that may be x as two: where it is surely 1, and where it is x."""
    found: dict[Key, Gate] = {}
    for key, bit in bits:
        found[key] = bit.surely
        if isinstance(bit, Blurred):
            found[*key, "x"] = bit.unknown
    return found
