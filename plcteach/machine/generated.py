"""Scans as plain Python: the same steps, run once over pieces of source text, leave a function that does one scan.

The signals here are names of variables, and what is done with them is written down, one assignment an operation. So the
generated scan can do nothing but what `step` and the rules do, only without looking anything up. Where a scan cannot be
written down once for all (it goes back, an x takes part, an edge has not been seen yet) there is no generated scan, and the
program runs line by line as ever. Nothing that a learner has typed stands in the text: addresses become numbered variables.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, ClassVar

from plcteach.machine.course import Course, Mixed
from plcteach.machine.plan import plan_of
from plcteach.machine.signals import ONE, ZERO, Column
from plcteach.machine.store import PIN, Memory
from plcteach.machine.words import BITS, Domain, Number
from plcteach.machine.world import Plant, beat

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence

    from plcteach.core.program import Program

MOST_LINES = 20_000


class Unsure(Exception):  # noqa: N818 (no error: the program is run line by line instead)
    """The scan cannot be written down once for all."""


@dataclass(slots=True)
class _Text:
    """The text so far, and the functions that it calls."""

    rows: list[str] = field(default_factory=list)
    names: dict[str, Any] = field(default_factory=dict)

    def put(self, expression: str) -> str:
        if len(self.rows) >= MOST_LINES:
            raise Unsure
        name = f"t{len(self.rows)}"
        self.rows.append(f"    {name} = {expression}")
        return name


@dataclass(frozen=True, slots=True)
class Code:
    """A bit or a number as the name of a variable, or a constant; "" is an x, which spreads to whatever is made of it."""

    name: str
    text: _Text = field(compare=False, repr=False)
    unknown: ClassVar[int] = 0

    def _new(self, expression: str, *others: Code) -> Code:
        """Write an operation down; an x makes an x."""
        known = self.name and all(one.name for one in others)
        return Code(self.text.put(expression) if known else "", self.text)

    def __and__(self, other: Code) -> Code:
        if "0" in {self.name, other.name}:
            return Code("0", self.text)
        if self.name in {"1", other.name}:
            return other
        return self if other.name == "1" else self._new(f"{self.name} & {other.name}", other)

    def __or__(self, other: Code) -> Code:
        if "1" in {self.name, other.name}:
            return Code("1", self.text)
        if self.name in {"0", other.name}:
            return other
        return self if other.name == "0" else self._new(f"{self.name} | {other.name}", other)

    def __xor__(self, other: Code) -> Code:
        return self._new(f"{self.name} ^ {other.name}", other)

    def __invert__(self) -> Code:
        fixed = {"0": "1", "1": "0"}.get(self.name)
        return Code(fixed, self.text) if fixed else self._new(f"{self.name} ^ 1")

    def edge(self, previous: Code | None, *, rising: bool) -> Code:
        """Give the edge since another variable."""
        if previous is None:
            raise Unsure
        return self & ~previous if rising else ~self & previous

    # As a number.

    def __add__(self, other: Code) -> Code:
        return self if other.name == "0" else self._new(f"{self.name} + {other.name}", other)

    def __sub__(self, other: Code) -> Code:
        return self._new(f"{self.name} - {other.name}", other)

    def times(self, factor: int) -> Code:
        """Multiply by a number known beforehand."""
        return self._new(f"{self.name} * {factor}")

    def over(self, divisor: int) -> Code:
        """Divide by a positive number."""
        return self._new(f"{self.name} // {divisor}")

    def ge(self, other: Code) -> Code:
        """Say whether it is at least the other."""
        return self._new(f"({self.name} >= {other.name}) + 0", other)

    def eq(self, other: Code) -> Code:
        """Say whether it equals the other."""
        return self._new(f"({self.name} == {other.name}) + 0", other)

    def wrap(self, size: int, *, signed: bool = True) -> Code:
        """Keep the lowest bits."""
        half, whole = 1 << (size - 1), 1 << size
        if signed:
            return self._new(f"({self.name} + {half} & {whole - 1}) - {half}")
        return self._new(f"{self.name} & {whole - 1}")

    def bits(self, size: int) -> tuple[Code, ...]:
        """Give the lowest bits, the lowest first."""
        return tuple(self._new(f"{self.name} >> {place} & 1") for place in range(size))


@dataclass(frozen=True, slots=True)
class _Writing(Domain[Code]):
    """The domain in which everything is written down."""

    text: _Text = field(default_factory=_Text)

    def number(self, value: int | None) -> Code:
        return Code("" if value is None else f"({value})" if value < 0 else f"{value}", self.text)

    def join(self, bits: Sequence[Code], *, signed: bool = True) -> Code:
        last = len(bits) - 1
        parts = [
            f"({bit.name} << {place})" if not (signed and place == last) else f"-({bit.name} << {place})"
            for place, bit in enumerate(bits)
            if bit.name != "0"
        ]
        if not all(bit.name for bit in bits):
            return self.blank
        return Code(self.text.put(" + ".join(parts).replace("+ -", "- ") or "0"), self.text)

    def pick(self, condition: Code, this: Any, other: Any) -> Code:
        if condition.name in {"0", "1"} or this == other:
            chosen: Code = other if condition.name == "0" else this
            return chosen
        if not (condition.name and this.name and other.name):
            return self.blank
        return Code(self.text.put(f"{this.name} if {condition.name} else {other.name}"), self.text)

    def apply(self, rule: Callable[..., int | None], *words: Any) -> Code:
        if not all(word.name for word in words):
            return self.blank
        name = f"f{len(self.text.names)}"
        self.text.names[name] = lambda *values: rule(*values) or 0
        return Code(self.text.put(f"{name}({', '.join(word.name for word in words)})"), self.text)


class _Plant(Plant[Code]):
    """A plant whose time and clocks are variables."""

    def driven(self) -> dict[str, Code]:
        text = self.domain.text  # type: ignore[attr-defined]
        return {
            address: Code(_clock(address, self.dialect.specials), text) if address in self.dialect.moving else value
            for address, value in super().driven().items()
        }

    def lapse(self, ms: int) -> Code:
        del ms
        return Code("dt", self.domain.text)  # type: ignore[attr-defined]

    def share(self, first: int, stop: int, of: int) -> Code:
        text = self.domain.text  # type: ignore[attr-defined]
        return Code(text.put(f"dt * {stop} // {of} - dt * {first} // {of}"), text)


def _clock(address: str, specials: Mapping[str, str]) -> str:
    return f"c{list(specials).index(address)}"


class Generated:
    """One scan of a program as a function; `state` and `inputs` are tuples in the order of `keys` and `fed`."""

    def __init__(self, program: Program, memory: Memory[Column], fed: Sequence[str]) -> None:
        """Write the scan down for what a memory holds after a first scan; Unsure where it cannot be."""
        if not plan_of(program).straight or memory.stopped is not None:
            raise Unsure
        self.program = program
        self.fed = tuple(fed)
        self.clocks = program.dialect.moving
        driven = set(program.dialect.specials)
        self.bits = tuple(key for key in memory.bits if key not in driven and key not in self.fed)
        self.words = tuple(key for key in memory.words if key not in self.fed)
        self.past = tuple(memory.past)
        self.image: tuple[str, ...] = ()
        self.numbers = {key for key in (*self.words, *self.fed) if key in memory.words}
        function = self._compiled() or self._compiled()
        if function is None:
            raise Unsure
        self.call = function
        self.keys = (*self.bits, *self.words)
        self.counts = frozenset(self.words)

    def _compiled(self) -> Callable[..., tuple[Any, ...]] | None:
        """Write the scan down; None where it writes bits or numbers that were not known yet, which now are."""
        text, image = _Text(), _Image()
        world = self._world(text, image)
        before = world.memory
        try:
            for _ in Course(world).steps():
                pass
        except Mixed:
            raise Unsure from None
        after = world.after()
        if set(after.past) != set(before.past):
            raise Unsure
        if self._learned(before, after):
            return None
        self.image = tuple(image.names)
        results = [after.bits[key] for key in self.bits] + [after.words[key] for key in self.words]
        results += [after.past[key] for key in self.past]
        results += [(after.image or {}).get(key, world.domain.zero) for key in self.image]
        if not all(one.name for one in results):
            raise Unsure
        return self._function(text, [one.name for one in results])

    def _world(self, text: _Text, image: _Image) -> _Plant:
        """Give a plant in which everything is a variable."""
        domain = _Writing(Code("0", text), Code("1", text), Code("", text), text)
        image.text = text
        before = Memory(
            {key: Code(f"b{at}", text) for at, key in enumerate(self.bits)},
            {key: Code(f"p{at}", text) for at, key in enumerate(self.past)},
            image if self.program.dialect.samples_edges_at_start else None,  # type: ignore[arg-type]
            1,
            {key: Code(f"w{at}", text) for at, key in enumerate(self.words)},
        )
        inputs = {key: Code(f"i{at}", text) for at, key in enumerate(self.fed)}
        world = _Plant(self.program, before, {}, domain)
        world.inputs = {key: value for key, value in inputs.items() if key not in self.numbers}
        world.bits |= world.inputs
        world.words |= {key: value for key, value in inputs.items() if key in self.numbers}
        world.image |= world.inputs
        return world

    def _learned(self, before: Memory[Code], after: Memory[Code]) -> bool:
        """Take up bits and numbers that the scan writes and the state does not have yet; True if there were any."""
        known = {*self.fed, *self.program.dialect.specials}
        bits = [key for key in after.bits if key not in known and key not in before.bits]
        words = [key for key in after.words if key not in known and key not in before.words]
        if any(PIN in key for key in bits):
            raise Unsure
        self.bits, self.words = (*self.bits, *bits), (*self.words, *words)
        return bool(bits or words)

    def _function(self, text: _Text, results: list[str]) -> Callable[..., tuple[Any, ...]]:
        names = [f"b{at}" for at in range(len(self.bits))] + [f"w{at}" for at in range(len(self.words))]
        names += [f"p{at}" for at in range(len(self.past))] + [f"m{at}" for at in range(len(self.image))]
        ins = [f"i{at}" for at in range(len(self.fed))]
        clocks = [_clock(key, self.program.dialect.specials) for key in self.clocks]
        head = ["def scan(state, inputs, clocks, dt):"]
        for row, source in ((names, "state"), (ins, "inputs"), (clocks, "clocks")):
            if row:
                head.append(f"    {', '.join(row)}, = {source}")
        body = _used(text.rows, results)
        tail = f"    return ({', '.join(results)}{',' if results else ''})"
        space: dict[str, Any] = dict(text.names)
        exec(compile("\n".join([*head, *body, tail]), "<scan>", "exec"), space)  # noqa: S102 (our own text, see above)
        function: Callable[..., tuple[Any, ...]] = space["scan"]
        return function

    def state(self, memory: Memory[Column]) -> tuple[int, ...]:
        """Give a memory as the function's state; Unsure where an x is in it."""
        world = Plant(self.program, Memory(), {}, BITS)
        found = [memory.bits.get(key, ZERO) for key in self.bits]
        found += [memory.words[key] if key in memory.words else world.number(key) for key in self.words]
        found += [memory.past[key] for key in self.past]
        found += [(memory.image or {}).get(key, ZERO) for key in self.image]
        return tuple(map(plain, found))

    def given(self, inputs: Mapping[str, Any]) -> tuple[int, ...]:
        """Give inputs as the function takes them; Unsure where one of them is an x."""
        return tuple(plain(inputs[key]) if key in inputs else 0 for key in self.fed)

    def memory(
        self, values: tuple[Sequence[int], Sequence[int], Sequence[int]], like: Memory[Column], scans: int, now: int
    ) -> Memory[Column]:
        """Give a state, its inputs and its clocks as a memory; what never changes is as in an earlier one."""
        state, inputs, clocks = values
        bits, words = len(self.bits), len(self.words)
        fed = dict(zip(self.fed, inputs, strict=True))
        past = state[bits + words : bits + words + len(self.past)]
        image = None
        if like.image is not None:
            last = state[bits + words + len(self.past) :]
            image = {**like.image, **{key: bit_of(one) for key, one in zip(self.image, last, strict=True)}}
        found = dict(zip(self.bits, map(bit_of, state[:bits]), strict=True))
        found |= {key: bit_of(value) for key, value in fed.items() if key not in self.numbers}
        found |= {key: bit_of(value) for key, value in zip(self.clocks, clocks, strict=True)}
        numbers = dict(zip(self.words, map(Number, state[bits : bits + words]), strict=True))
        numbers |= {key: Number(value) for key, value in fed.items() if key in self.numbers}
        past_of_lines = dict(zip(self.past, map(bit_of, past), strict=True))
        return Memory({**like.bits, **found}, past_of_lines, image, scans, numbers, now, like.warm)

    def ticks(self, scans: int, now: int) -> tuple[int, ...]:
        """Give what the moving system bits are in one scan."""
        specials = self.program.dialect.specials
        return tuple(beat(specials[key], scans, now) for key in self.clocks)


class _Image:
    """The bits at the last scan's start: those that an edge asks for become variables."""

    def __init__(self) -> None:
        self.text = _Text()
        self.names: dict[str, Code] = {}

    def get(self, key: str, default: Code) -> Code:
        del default
        return self.names.setdefault(key, Code(f"m{len(self.names)}", self.text))


def _used(rows: list[str], results: list[str]) -> Iterator[str]:
    """Leave out the rows whose variable nobody needs."""
    wanted = set(results)
    kept: list[str] = []
    for row in reversed(rows):
        name, _, expression = row.strip().partition(" = ")
        if name in wanted:
            kept.append(row)
            wanted.update(expression.replace("(", " ").replace(")", " ").replace(",", " ").replace("-", " ").split())
    return reversed(kept)


def plain(value: Any) -> int:
    """Give a bit or a number as a whole number; Unsure where nobody knows it."""
    if value.unknown:
        raise Unsure
    return value.may1 if isinstance(value, Column) else int(value.value)


def bit_of(value: int) -> Column:
    """Give a whole number as a bit."""
    return ONE if value else ZERO
