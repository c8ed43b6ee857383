"""Random programs with timers, counters and words: what they are, how each family's list spells them, and what they do.

Nothing here comes from the package. `render` writes lists by rules of its own, and `Direct` works a program out from its
contacts and blocks, without any instruction, stack or list, from the sentences of the notes on the four families.

A name is a letter and a number: i inputs, q outputs, m memory bits, r bits of a shift register, t timers, c counters, w words,
p words that hold presets, x an edge's memory, f flags. `t37` is the timer's bit as a contact and its current value as a word.
"""

from __future__ import annotations

import operator
from collections import deque
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from random import Random

# What a program is.


@dataclass(frozen=True)
class Contact:
    """A bit, as it is ("") or turned: "not", "rise", "fall"."""

    bit: str
    how: str = ""


@dataclass(frozen=True)
class Compare:
    relation: str
    left: str
    right: str | int


@dataclass(frozen=True)
class Series:
    parts: tuple[Node, ...]


@dataclass(frozen=True)
class Parallel:
    parts: tuple[Node, ...]


Node = Contact | Compare | Series | Parallel


@dataclass(frozen=True)
class Sink:
    """What a flow acts on: a verb, its target, the values it uses; `rule`: which timer, counter, sum or shift it is."""

    verb: str
    target: str
    sources: tuple[str | int, ...] = ()
    rule: str = ""


@dataclass(frozen=True)
class Rung:
    """Conditions (one for each pin), what the flow of a single one goes through ("not", "rise", "fall"), and the sinks.

    `form`: whether a block's pins come together ("") or one by one ("apart"); `tail`: a coil of one of the block's bits.
    """

    pins: tuple[tuple[str, Node], ...]
    sinks: tuple[Sink, ...]
    turn: str = ""
    form: str = ""
    tail: tuple[str, str] | None = None


@dataclass(frozen=True)
class Program:
    family: str
    rungs: tuple[Rung, ...]
    first: dict[str, int]
    """What words hold at the start."""

    def sinks(self) -> list[Sink]:
        return [sink for rung in self.rungs for sink in rung.sinks]


# How a list spells it.

PLACES = {
    "s7-200": {"i": "I0.", "q": "Q0.", "m": "M0.", "r": "V50.", "t": "T", "c": "C", "f": "SM1."},
    "gutta": {"i": "I0.", "q": "Q0.", "m": "M0.", "t": "T", "c": "C", "f": "SM1."},
    "fx": {"i": "X", "q": "Y", "m": "M", "r": "M10", "t": "T", "c": "C", "w": "D", "p": "D10", "d": "M8", "f": "M802"},
    "neza": {"i": "%I0.", "q": "%Q0.", "m": "%M", "r": "%SBR0.", "s": "%SC0.", "w": "%MW", "p": "%MW1", "c": "%C", "t": "%TM"},
}  # fmt: skip
WORDS = {"s7-200": "VW", "gutta": "MW"}
SINGLE = {
    "s7-200": {"first": "SM0.1", "on": "SM0.0"},
    "gutta": {"first": "SM0.1", "on": "SM0.0"},
    "fx": {"first": "M8002", "on": "M8000"},
    "neza": {"first": "%S13", "on": "1", "out": "%S17", "step": "%DR0.S", "last": "%DR0.F", "in": "%R0.I", "taken": "%R0.O",
             "empty": "%R0.E", "full": "%R0.F"},
}  # fmt: skip


def spelled(family: str, name: str | int, *, word: bool = False) -> str:
    """Give a name's address; `word`: its number and not its bit."""
    if isinstance(name, int):
        return f"K{name}" if family == "fx" else str(name)
    if name in SINGLE[family]:
        return SINGLE[family][name]
    letter, number = name[0], name[1:]
    if letter in "wp" and family in WORDS:
        return f"{WORDS[family]}{20 + 2 * int(number) + 6 * (letter == 'p')}"
    if letter == "x":
        return f"M{int(number) // 8 + 1}.{int(number) % 8}"
    address = PLACES[family][letter] + number
    if family == "neza" and letter in "tc" and "." not in number:
        return f"{address}.{'V' if word else 'Q' if letter == 't' else 'D'}"
    return address


def kept(family: str, name: str, *, word: bool = False) -> str:
    """Give the address under which a trace keeps a name: of a timer or counter its bit, or its current value."""
    values = word and name[0] in "tc" and family != "neza"
    return f"{spelled(family, name, word=word)}{'.V' if values else ''}"


def block(family: str, name: str) -> str:
    """Give the address of a whole timer or counter."""
    return PLACES[family][name[0]] + name[1:]


class Siemens:
    """S7-200 and GUTTA: blocks on a stack, joined by ALD and OLD; GUTTA's edges keep the last flow in a bit."""

    edges = ("EU", "ED")

    def __init__(self, program: Program) -> None:
        self.program, self.family = program, program.family
        self.memories = 0

    def text(self) -> str:
        rows = []
        for number, rung in enumerate(self.program.rungs, 1):
            rows += [f"Network {number}", *self.rung(rung)]
        return "\n".join(rows)

    def place(self, name: str | int, *, word: bool = False) -> str:
        return spelled(self.family, name, word=word)

    def turned(self, how: str) -> list[str]:
        if how in {"rise", "fall"} and self.family == "gutta":
            self.memories += 1
            return [f"{'P' if how == 'rise' else 'N'} {self.place(f'x{self.memories}')}"]
        return {"": [], "not": ["NOT"], "rise": [self.edges[0]], "fall": [self.edges[1]]}[how]

    def leaf(self, node: Node, word: str) -> str | None:
        """Give the one line that a contact or a compare is, or None where it takes several."""
        if isinstance(node, Contact) and node.how in {"", "not"}:
            return f"{word}{'N' if node.how else ''} {self.place(node.bit)}"
        if isinstance(node, Compare):
            return f"{word}W{node.relation} {self.place(node.left, word=True)}, {self.place(node.right, word=True)}"
        return None

    def block(self, node: Node) -> list[str]:
        """Give the lines that push a node's value."""
        line = self.leaf(node, "LD")
        if line:
            return [line]
        if isinstance(node, Contact):
            return [f"LD {self.place(node.bit)}", *self.turned(node.how)]
        word, join = ("A", "ALD") if isinstance(node, Series) else ("O", "OLD")
        assert isinstance(node, Series | Parallel)
        rows = self.block(node.parts[0])
        for part in node.parts[1:]:
            line = self.leaf(part, word)
            rows += [line] if line else [*self.block(part), join]
        return rows

    def rung(self, rung: Rung) -> list[str]:
        rows = [row for _, node in rung.pins for row in self.block(node)]
        return [*rows, *self.turned(rung.turn), *(self.sink(sink) for sink in rung.sinks)]

    def sink(self, sink: Sink) -> str:  # noqa: PLR0911 (a row for each sort)
        target, values = sink.target, [self.place(one, word=True) for one in sink.sources]
        if sink.verb == "coil":
            return f"= {self.place(target)}"
        if sink.verb in {"set", "reset", "clear"}:
            return f"{'S' if sink.verb == 'set' else 'R'} {self.place(target)}, {(*values, '1')[0]}"
        if sink.verb == "timer":
            return f"{ {'on': 'TON', 'off': 'TOF', 'retentive': 'TONR'}[sink.rule] } {block(self.family, target)}, {values[0]}"
        if sink.verb == "counter":
            return f"{ {'up': 'CTU', 'down': 'CTD', 'updown': 'CTUD'}[sink.rule] } {block(self.family, target)}, {values[0]}"
        if sink.verb == "shift":
            return f"SHRB {self.place(sink.sources[0])}, {self.place(target)}, {sink.sources[1]}"
        word = self.place(target, word=True)
        if sink.rule == "move":
            return f"MOVW {values[0]}, {word}"
        if sink.rule in {"next", "last"}:
            counts = ("INCW", "DECW") if self.family == "s7-200" else ("+I 1,", "-I 1,")
            return f"{counts[sink.rule == 'last']} {word}"
        return f"{'+I' if sink.rule == 'add' else '-I'} {values[1]}, {word}"


class Mitsubishi(Siemens):
    """FX: blocks joined by ANB and ORB; edges are contacts of their own; pulses by PLS, MEP or a P behind the word."""

    edges = ("MEP", "MEF")
    leaves = {"LD": ("LD", "LDI"), "A": ("AND", "ANI"), "O": ("OR", "ORI")}  # noqa: RUF012

    def text(self) -> str:
        return "\n".join([*(row for rung in self.program.rungs for row in self.rung(rung)), "END"])

    def leaf(self, node: Node, word: str) -> str | None:
        plain, inverse = self.leaves[word]
        if isinstance(node, Contact):
            line = {"": plain, "not": inverse, "rise": f"{plain}P", "fall": f"{plain}F"}[node.how]
            return f"{line} {self.place(node.bit)}"
        if isinstance(node, Compare):
            long = "D" if node.left == "c200" else ""
            return f"{plain}{long}{node.relation} {self.place(node.left)} {self.place(node.right)}"
        return None

    def block(self, node: Node) -> list[str]:
        return [{"ALD": "ANB", "OLD": "ORB"}.get(row, row) for row in super().block(node)]

    def rung(self, rung: Rung) -> list[str]:
        rows = [row for _, node in rung.pins for row in self.block(node)]
        verbs = {sink.verb for sink in rung.sinks}
        if rung.turn == "rise" and verbs <= {"sum", "shift"}:
            return [*rows, *(self.sink(sink, "P") for sink in rung.sinks)]
        if rung.turn in {"rise", "fall"} and verbs == {"coil"} and len(rung.sinks) == 1:
            return [*rows, f"{'PLS' if rung.turn == 'rise' else 'PLF'} {self.place(rung.sinks[0].target)}"]
        turned = ["INV"] if rung.turn == "not" else self.turned(rung.turn)
        return [*rows, *turned, *(self.sink(sink) for sink in rung.sinks)]

    def sink(self, sink: Sink, pulse: str = "") -> str:
        target, values = self.place(sink.target), [self.place(one) for one in sink.sources]
        if sink.verb in {"coil", "timer", "counter"}:
            return " ".join(["OUT", target, *values])
        if sink.verb in {"set", "reset", "clear"}:
            return f"{'SET' if sink.verb == 'set' else 'RST'} {target}"
        if sink.verb == "shift":
            word = "SFTL" if sink.rule == "up" else "SFTR"
            return f"{word}{pulse} {values[0]} {target} {values[1]} {values[2]}"
        word = {"move": "MOV", "add": "ADD", "sub": "SUB", "next": "INC", "last": "DEC"}[sink.rule]
        return " ".join([f"{word}{pulse}", *(values if sink.rule in {"move", "add", "sub"} else []), target])


class Schneider:
    """NEZA: an accumulator and parentheses; blocks between BLK and END_BLK or pin by pin; their presets stand in front."""

    suffix = {"": "", "not": "N", "rise": "R", "fall": "F"}  # noqa: RUF012
    blocks = {"drum": "%DR0", "steps": "%SC0", "shift": "%SBR0", "queue": "%R0"}  # noqa: RUF012

    def __init__(self, program: Program) -> None:
        self.program = program

    def text(self) -> str:
        rows = [row for sink in self.program.sinks() for row in self.configured(sink)]
        return "\n".join([*rows, *(row for rung in self.program.rungs for row in self.rung(rung))])

    def place(self, name: str | int, *, word: bool = False) -> str:
        return spelled("neza", name, word=word)

    def configured(self, sink: Sink) -> list[str]:
        if sink.verb == "timer":
            kind = {"on": "TON", "off": "TOF", "pulse": "TP"}[sink.rule]
            return [f"%TM{sink.target[1:]}: TYPE={kind} TB={sink.sources[1]}ms P={sink.sources[0]}"]
        if sink.verb == "counter":
            return [f"%C{sink.target[1:]}: P={sink.sources[0]}"]
        if sink.verb == "queue":
            return [f"%R0: TYPE={sink.rule}"]
        if sink.verb == "drum":
            outputs = ",".join(self.place(f"q{number}") for number in range(3, 3 + len(str(sink.sources[0]))))
            return [f"%DR0: OUT={outputs} STEPS={','.join(str(one) for one in sink.sources)}"]
        return []

    def leaf(self, node: Contact | Compare, word: str) -> str:
        if isinstance(node, Compare):
            return f"{word} [{self.place(node.left, word=True)} {node.relation} {self.place(node.right, word=True)}]"
        return f"{word}{self.suffix[node.how]} {self.place(node.bit)}"

    def block(self, node: Node, first: str = "LD") -> list[str]:
        """Give the lines that work a node out; `first`: LD, or the parenthesis that it begins with."""
        if isinstance(node, Contact | Compare):
            return [self.leaf(node, first)]
        word = "AND" if isinstance(node, Series) else "OR"
        rows = self.block(node.parts[0], first)
        for part in node.parts[1:]:
            rows += (
                [self.leaf(part, word)] if isinstance(part, Contact | Compare) else [*self.block(part, f"{word}("), ")"]
            )
        return rows

    def rung(self, rung: Rung) -> list[str]:
        sink = rung.sinks[0]
        name = self.blocks.get(sink.verb) or (block("neza", sink.target) if sink.verb in {"timer", "counter"} else "")
        if name and rung.form == "apart":
            return [row for pin, node in rung.pins for row in (*self.block(node), f"{pin} {name}")]
        if name:
            rows = [row for pin, node in rung.pins for row in (*self.block(node), pin)]
            tail = ["OUT_BLK", f"LD {rung.tail[0]}", f"ST {self.place(rung.tail[1])}"] if rung.tail else []
            return [f"BLK {name}", *rows, *tail, "END_BLK"]
        rows = self.block(rung.pins[0][1])
        return [*rows, *(["N"] if rung.turn else []), *(self.sink(sink) for sink in rung.sinks)]

    def sink(self, sink: Sink) -> str:
        target, values = (
            self.place(sink.target, word=sink.verb == "sum"),
            [self.place(one, word=True) for one in sink.sources],
        )
        if sink.verb == "sum":
            signs = {"move": "", "add": " + ", "sub": " - ", "next": " + 1", "last": " - 1"}
            return f"[ {target} := {signs[sink.rule].join(values)}{signs[sink.rule] if len(values) == 1 else ''} ]"
        return f"{ {'coil': 'ST', 'coil not': 'STN', 'set': 'S', 'reset': 'R'}[sink.verb] } {target}"


def render(program: Program, family: str) -> str:
    """Give a family's list of a program."""
    assert program.family == family
    if family == "neza":
        return Schneider(program).text()
    return (Mitsubishi(program) if family == "fx" else Siemens(program)).text()


# What it does.

LOW, HIGH = -32768, 32767
RELATIONS = {
    "=": operator.eq,
    "<>": operator.ne,
    ">=": operator.ge,
    "<=": operator.le,
    ">": operator.gt,
    "<": operator.lt,
}


@dataclass(frozen=True)
class Ways:
    """In what the families differ."""

    at_scan_start: tuple[int, ...] = ()
    """The time bases whose timers are brought up to date at the start of the scan; the others when their line is reached."""
    most: int = HIGH
    """Where a timer's current value ends."""
    stops: bool = False
    """An on-delay's current value stops at its preset."""
    images: bool = False
    """A contact's edge is between the starts of two scans, and not since its line was last executed."""
    flow_from_0: bool = False
    """An edge's memory is 0 at first, so that what is on in the first scan rises."""
    outside: str = "keeps"
    """What a sum that does not fit does: the target keeps its value, or it wraps, or all bits but the sign do ("signed")."""


WAYS = {
    "s7-200": Ways(at_scan_start=(10,)),
    "gutta": Ways(at_scan_start=(10,), flow_from_0=True),
    "fx": Ways(stops=True, outside="signed"),
    "neza": Ways(at_scan_start=(1, 10, 100), most=9999, stops=True, images=True, outside="wraps"),
}


@dataclass
class Clock:
    """A timer. `armed`: an off-delay has seen its input on and waits for it to go off."""

    rule: str
    base: int
    bit: bool = False
    ms: int = 0
    going: bool = False
    armed: bool = False
    was: bool = False
    goal: int = 0


def base_of(family: str, timer: Sink) -> int:
    """Give a timer's time base in ms."""
    number = int(timer.target[1:])
    if family == "neza":
        return int(timer.sources[1])
    ranges: tuple[tuple[int, int], ...]
    if family == "fx":
        ranges = ((199, 100), (245, 10), (249, 1), (255, 100), (511, 1))
    else:
        ranges = ((0, 1), (4, 10), (31, 100), (32, 1), (36, 10), (63, 100), (64, 1), (68, 10), (95, 100), (96, 1), (100, 10), (255, 100))  # fmt: skip
    return next(base for last, base in ranges if number <= last)


@dataclass
class Direct:
    """One scan after another over plain truth values and whole numbers."""

    program: Program
    bits: dict[str, bool] = field(default_factory=dict)
    words: dict[str, int] = field(default_factory=dict)
    clocks: dict[str, Clock] = field(default_factory=dict)
    seen: dict[object, bool] = field(default_factory=dict)
    last: dict[str, bool] | None = None
    scans: int = 0
    dt: int = 0

    def __post_init__(self) -> None:
        self.ways = WAYS[self.program.family]
        self.words.update(self.program.first)
        self.queue: deque[int] = deque()
        for sink in self.program.sinks():
            if sink.verb == "timer":
                self.clocks[sink.target] = Clock(sink.rule, base_of(self.program.family, sink))
                self.words.setdefault(
                    f"{sink.target}.P", int(sink.sources[0]) if isinstance(sink.sources[0], int) else 0
                )
            if sink.verb == "queue":
                self.bits["empty"] = True
            if sink.verb == "steps":
                self.bits["s0"] = True

    def scan(self, inputs: dict[str, bool], dt: int) -> None:
        """Work out one scan that begins `dt` ms after the last one; the first begins at 0."""
        self.dt = dt if self.scans else 0
        self.bits |= inputs | {"first": not self.scans, "on": True}
        for name, clock in self.clocks.items():
            if clock.base in self.ways.at_scan_start:
                self.advance(clock)
                self.bits[name] = clock.bit
        self.image = dict(self.bits)
        self.place = 0
        for rung in self.program.rungs:
            self.rung(rung)
        self.last = self.image
        self.scans += 1
        for name, clock in self.clocks.items():
            self.words[name] = self.current(clock)

    def rung(self, rung: Rung) -> None:
        if rung.form == "apart":
            for pin, node in rung.pins:
                self.act(rung.sinks[0], {pin: self.closed(node)})
            return
        pins = {pin: self.closed(node) for pin, node in rung.pins}
        if rung.turn == "not":
            pins = {"": not pins[""]}
        elif rung.turn:
            pins = {"": self.edge(rung.turn, self.fresh(), now=pins[""])}
        for sink in rung.sinks:
            self.act(sink, pins)
        if rung.tail:
            self.bits[rung.tail[1]] = self.bit(
                f"{rung.sinks[0].target}.{rung.tail[0]}".removesuffix(".Q").removesuffix(".D")
            )

    # Conditions.

    def closed(self, node: Node) -> bool:
        if isinstance(node, Series):
            return all([self.closed(part) for part in node.parts])  # noqa: C419 (every edge in it looks)
        if isinstance(node, Parallel):
            return any([self.closed(part) for part in node.parts])  # noqa: C419
        if isinstance(node, Compare):
            return bool(RELATIONS[node.relation](self.word(node.left), self.word(node.right)))
        if node.how in {"", "not"}:
            return self.bit(node.bit) != (node.how == "not")
        if self.ways.images:
            before = self.last.get(node.bit, False) if self.last is not None else None
            return self.between(node.how, before=before, now=self.image.get(node.bit, False))
        return self.edge(node.how, self.fresh(), now=self.bit(node.bit))

    def bit(self, name: str) -> bool:
        return self.bits.get(name, False)

    def word(self, name: str | int) -> int:
        if isinstance(name, int):
            return name
        return self.current(self.clocks[name]) if name in self.clocks else self.words.get(name, 0)

    def fresh(self) -> int:
        """Give the place of an edge among all of the program's, which are worked out in the same order in each scan."""
        self.place += 1
        return self.place

    def edge(self, how: str, key: object, *, now: bool) -> bool:
        """Give an edge since this place was last worked out."""
        before = self.seen.get(key, False if self.ways.flow_from_0 else None)
        self.seen[key] = now
        return self.between(how, before=before, now=now)

    def between(self, how: str, *, before: bool | None, now: bool) -> bool:
        """Tell an edge; where there is no before, in the first scan, there is none."""
        return before is not None and before != now and now == (how == "rise")

    def counts(self, sink: Sink, pins: dict[str, bool], pin: str) -> bool:
        """Tell whether a block's pin rises since the block last looked at it; never in the first scan."""
        if pin not in pins:
            return False
        before = self.seen.get((sink.target, pin))
        self.seen[sink.target, pin] = pins[pin]
        return self.between("rise", before=before, now=pins[pin])

    # What the flow acts on.

    def act(self, sink: Sink, pins: dict[str, bool]) -> None:
        flow = pins.get("", False)
        if sink.verb in {"coil", "coil not"}:
            self.bits[sink.target] = flow != (sink.verb == "coil not")
        elif sink.verb in {"set", "reset"}:
            count = int(sink.sources[0]) if sink.sources else 1
            for number in range(int(sink.target[1:]), int(sink.target[1:]) + count):
                if flow:
                    self.bits[f"{sink.target[0]}{number}"] = sink.verb == "set"
        elif sink.verb == "timer":
            self.time(sink, power=pins.get("IN", flow))
        else:
            {"clear": self.clear, "counter": self.count, "sum": self.sum, "shift": self.shift, "drum": self.drum,
             "steps": self.steps, "queue": self.store}[sink.verb](sink, pins)  # fmt: skip

    def clear(self, sink: Sink, pins: dict[str, bool]) -> None:
        """R or RST of a timer or counter: its bit and its current value."""
        if not pins[""]:
            return
        self.bits[sink.target] = False
        self.words[sink.target] = 0
        if sink.target in self.clocks:
            clock = self.clocks[sink.target]
            clock.bit, clock.ms, clock.going, clock.armed = False, 0, False, False

    # Timers.

    def current(self, clock: Clock) -> int:
        return min(clock.ms // clock.base, self.ways.most)

    def advance(self, clock: Clock) -> None:
        """Let a running timer's time pass, also in the scan that finds its input off: it was on since the last one [rec]."""
        if not clock.going:
            return
        clock.ms += self.dt
        due = clock.ms >= clock.goal
        if due and (self.ways.stops or clock.rule in {"off", "pulse"}):
            clock.ms = clock.goal
        if clock.rule in {"on", "retentive"}:
            clock.bit = due
        elif due:
            clock.bit = clock.going = False

    def time(self, sink: Sink, *, power: bool) -> None:
        clock, name = self.clocks[sink.target], sink.target
        goal = self.word(f"{name}.P" if self.program.family == "neza" else sink.sources[0]) * clock.base
        if self.program.family != "neza" or not clock.going:
            clock.goal = goal
        if clock.base not in self.ways.at_scan_start:
            self.advance(clock)
        if clock.rule == "off":
            self.off_delay(clock, power=power)
        elif clock.rule == "pulse":
            self.pulse(clock, power=power)
        elif power and not clock.going:
            self.start(clock)
            clock.bit = clock.ms >= clock.goal
        elif not power:
            clock.going = False
            if clock.rule == "on":
                clock.ms, clock.bit = 0, False
        clock.was = power
        self.bits[name] = clock.bit

    def start(self, clock: Clock) -> None:
        """Begin; the scan that starts a timer adds nothing."""
        clock.going = True

    def off_delay(self, clock: Clock, *, power: bool) -> None:
        if power:
            clock.bit, clock.ms, clock.going, clock.armed = True, 0, False, True
        elif clock.armed:
            clock.armed = False
            self.start(clock)

    def pulse(self, clock: Clock, *, power: bool) -> None:
        if power and not clock.was and not clock.going:
            clock.bit, clock.ms = True, 0
            self.start(clock)
        elif not power and not clock.going:
            clock.ms = 0

    # Counters.

    def count(self, sink: Sink, pins: dict[str, bool]) -> None:
        {"up": self.count_up, "down": self.count_down, "updown": self.count_both, "to": self.count_to, "ring": self.count_ring,
         "preset": self.count_preset}[sink.rule](sink, pins)  # fmt: skip

    def count_up(self, sink: Sink, pins: dict[str, bool]) -> None:
        name, value = sink.target, self.word(sink.target)
        if self.counts(sink, pins, "CU"):
            value = min(value + 1, HIGH)
        self.words[name] = 0 if pins["R"] else value
        self.bits[name] = not pins["R"] and value >= self.word(sink.sources[0])

    def count_down(self, sink: Sink, pins: dict[str, bool]) -> None:
        name, value = sink.target, self.word(sink.target)
        if self.counts(sink, pins, "CD"):
            value = max(value - 1, 0)
        self.words[name] = self.word(sink.sources[0]) if pins["LD"] else value
        self.bits[name] = not pins["LD"] and value == 0

    def count_both(self, sink: Sink, pins: dict[str, bool]) -> None:
        name, value = sink.target, self.word(sink.target)
        value += self.counts(sink, pins, "CU") - self.counts(sink, pins, "CD")
        value = LOW if value > HIGH else HIGH if value < LOW else value
        self.words[name] = 0 if pins["R"] else value
        self.bits[name] = not pins["R"] and value >= self.word(sink.sources[0])

    def count_to(self, sink: Sink, pins: dict[str, bool]) -> None:
        """FX, 16 bits: up to the preset; the contact stays on until RST."""
        name, goal = sink.target, self.word(sink.sources[0])
        if self.counts(sink, pins, "") and self.word(name) < goal:
            self.words[name] = self.word(name) + 1
            self.bits[name] = self.bit(name) or self.words[name] == goal

    def count_ring(self, sink: Sink, pins: dict[str, bool]) -> None:
        """FX, 32 bits: M82xx says down; on as the preset is passed upwards, off as it is passed downwards."""
        name, goal, before = sink.target, self.word(sink.sources[0]), self.word(sink.target)
        if not self.counts(sink, pins, ""):
            return
        down = self.bit(f"d{name[1:]}")
        after = (before + (-1 if down else 1) + 2**31) % 2**32 - 2**31
        self.words[name] = after
        if not down and after == goal:
            self.bits[name] = True
        if down and before == goal:
            self.bits[name] = False

    def count_preset(self, sink: Sink, pins: dict[str, bool]) -> None:
        """NEZA: R before S before the counts; E and F mark the way round 0 until the next count."""
        name, goal, value = sink.target, self.word(sink.sources[0]), self.word(sink.target)
        change = self.counts(sink, pins, "CU") - self.counts(sink, pins, "CD")
        if pins.get("R"):
            self.words[name] = 0
            self.bits |= {name: False, f"{name}.E": False, f"{name}.F": False}
            return
        if pins.get("S"):
            self.words[name] = goal
        elif change:
            self.bits |= {f"{name}.F": value + change > 9999, f"{name}.E": value + change < 0}
            self.words[name] = (value + change) % 10000
        self.bits[name] = self.word(name) == goal

    # Words and rows of bits.

    def sum(self, sink: Sink, pins: dict[str, bool]) -> None:
        values = [self.word(one) for one in sink.sources]
        if not pins[""]:
            return
        if sink.rule == "move":
            self.words[sink.target] = values[0]
            return
        change = {"next": 1, "last": -1}.get(sink.rule) or (values[1] if sink.rule == "add" else -values[1])
        exact = values[0] + change
        fits = LOW <= exact <= HIGH
        wrapped = (exact - LOW) % 65536 + LOW
        outside = self.ways.outside
        if outside == "signed" and sink.rule in {"add", "sub"}:
            wrapped = exact % 32768 - (
                32768 if exact < 0 else 0
            )  # the manual's figure: 32767, 0, 1 and -1, 0 ... -32768, -1
            self.bits |= {"f0": wrapped == 0, "f1": exact < LOW, "f2": exact > HIGH}
        if outside == "keeps":
            self.bits |= {"f0": fits and exact == 0, "f1": not fits, "f2": fits and exact < 0}
        self.words[sink.target] = exact if fits else values[0] if outside == "keeps" else wrapped

    def shift(self, sink: Sink, pins: dict[str, bool]) -> None:
        if sink.rule == "block":
            self.shift_block(sink, pins)
            return
        start = int(sink.sources[0][1:]) if isinstance(sink.sources[0], str) else 0
        length, by = abs(int(sink.sources[1])), int(sink.sources[2]) if len(sink.sources) > 2 else 1
        names = [f"r{number}" for number in range(length)]
        row = [self.bit(name) for name in names]
        letter = str(sink.sources[0])[0]
        new = [self.bit(f"{letter}{start + number}") for number in range(by)]
        if not pins[""]:
            return
        if self.program.family != "fx":
            self.bits["f1"] = row[-1] if sink.rule == "up" else row[0]
        row = [*new, *row[:-by]] if sink.rule == "up" else [*row[by:], *new]
        self.bits |= dict(zip(names, row, strict=True))

    def shift_block(self, sink: Sink, pins: dict[str, bool]) -> None:
        """NEZA: 16 bits; R clears, CU to the left, CD to the right, 0 enters."""
        names = [f"r{number}" for number in range(16)]
        row = [self.bit(name) for name in names]
        change = self.counts(sink, pins, "CU") - self.counts(sink, pins, "CD")
        if change:
            self.bits["out"] = row[-1] if change > 0 else row[0]
            row = [False, *row[:-1]] if change > 0 else [*row[1:], False]
        self.bits |= dict(zip(names, [False] * 16 if pins.get("R") else row, strict=True))

    # NEZA's other blocks.

    def steps(self, sink: Sink, pins: dict[str, bool]) -> None:
        """Exactly one bit is 1; R to step 0; at either end it stays."""
        change = self.counts(sink, pins, "CU") - self.counts(sink, pins, "CD")
        step = 0 if pins.get("R") else min(max(self.word("at") + change, 0), 255)
        self.bits[f"s{self.word('at')}"] = False
        self.bits[f"s{step}"] = True
        self.words["at"] = step

    def drum(self, sink: Sink, pins: dict[str, bool]) -> None:
        """R to step 0, U to the next; control bits are written on a change, under R and at cold start."""
        turns, step = self.counts(sink, pins, "U"), self.word("step")
        after = 0 if pins.get("R") else (step + turns) % len(sink.sources)
        self.words["step"], self.bits["last"] = after, after == len(sink.sources) - 1
        if pins.get("R") or after != step or not self.scans:
            self.bits |= {f"q{3 + number}": one == "1" for number, one in enumerate(str(sink.sources[after]))}

    def store(self, sink: Sink, pins: dict[str, bool]) -> None:
        """Sixteen words; I and O together do neither; .O keeps what was taken last."""
        put, take = self.counts(sink, pins, "I"), self.counts(sink, pins, "O")
        if pins.get("R"):
            self.queue.clear()
        elif put and not take and len(self.queue) < 16:
            self.queue.append(self.word("in"))
        elif take and not put and self.queue:
            self.words["taken"] = self.queue.popleft() if sink.rule == "FIFO" else self.queue.pop()
        self.bits |= {"empty": not self.queue, "full": len(self.queue) == 16}


# Which programs there are.

TIMERS: dict[str, dict[str, tuple[int, ...]]] = {
    "s7-200": {"on": (33, 37, 97, 101), "off": (34, 38, 98, 102), "retentive": (1, 5, 65, 69)},
    "fx": {"on": (0, 199, 200, 256), "retentive": (246, 250)},
    "neza": {"on": (0, 1), "off": (2, 3), "pulse": (4, 5)},
}
TIMERS["gutta"] = TIMERS["s7-200"]
MENU = {
    "s7-200": "coil coil set reset timer timer timer counter counter sum sum clear clear shift",
    "gutta": "coil coil set reset timer timer timer counter counter sum sum clear clear",
    "fx": "coil coil set reset timer timer timer counter counter counter sum sum sum clear clear shift",
    "neza": "coil coil set reset timer timer timer counter counter sum sum sum shift drum steps queue queue",
}
SEVERAL = {"coil", "coil not", "set", "reset", "clear", "sum"}


class Maker:
    """Draws a program of a family."""

    def __init__(self, chance: Random, family: str) -> None:
        self.chance, self.family = chance, family
        self.siemens = family in {"s7-200", "gutta"}
        self.blocks: dict[str, Sink] = {}
        self.bits = ["i0", "i1", "i2", "i3"] * 2 + ["q0", "q1", "q2", "m0", "m1", "m2", "first"]
        self.words = ["w0", "w1", "w2"]

    def program(self) -> Program:
        wanted = [self.chance.choice(MENU[self.family].split()) for _ in range(self.chance.randint(2, 5))]
        self.plan = [self.planned(verb) for verb in wanted]
        if "queue" in self.blocks:
            self.plan.insert(self.chance.randint(0, len(self.plan)), Sink("sum", "in", ("in", 7), "add"))
        rungs = tuple(self.rung(sink) for sink in self.plan)
        first = {name: self.start() for name in ("w0", "w1", "w2")} | {
            "p0": self.chance.randint(1, 4),
            "p1": self.chance.randint(1, 4),
        }
        return Program(self.family, rungs, first | self.high_counts())

    def start(self) -> int:
        return self.chance.choice([0, 1, 5, -3, 32766, 32760, -32767, -32760, self.chance.randint(LOW, HIGH)])

    def high_counts(self) -> dict[str, int]:
        """Let a counter now and then begin near its end."""
        ends = {"up": (32765, 32766), "updown": (32766, -32767), "ring": (2**31 - 2, 1 - 2**31)}
        counters = [sink for sink in self.blocks.values() if sink.verb == "counter" and sink.rule in ends]
        return {sink.target: self.chance.choice(ends[sink.rule]) for sink in counters if self.chance.random() < 0.2}

    def planned(self, verb: str) -> Sink:
        """Choose the blocks first, so that any rung may look at any of them; each block stands once."""
        if verb == "timer":
            rule = self.chance.choice(sorted(TIMERS[self.family]))
            name = f"t{self.chance.choice(TIMERS[self.family][rule])}"
            sink = Sink(verb, name, (), rule)
            base = self.chance.choice([1, 10, 100]) if self.family == "neza" else base_of(self.family, sink)
            preset: str | int = self.chance.randint(1, max(400 // base, 3))
            if self.family == "neza":
                sink = Sink(verb, name, (preset, base), rule)
            else:
                preset = "p0" if self.chance.random() < 0.2 else preset
                moving = self.siemens and base == 100 and rule == "on" and self.chance.random() < 0.3
                sink = Sink(verb, name, ("p1" if moving else preset,), rule)
        elif verb == "counter":
            sink = self.counter()
        elif verb == "drum":
            width = self.chance.randint(1, 3)
            rows = ("".join(self.chance.choice("01") for _ in range(width)) for _ in range(self.chance.randint(2, 5)))
            sink = Sink(verb, "dr", tuple(rows))
        elif verb in {"steps", "queue"}:
            sink = Sink(verb, verb, (), self.chance.choice(["FIFO", "LIFO"]))
        elif verb == "shift":
            sink = self.shift()
        else:
            return Sink(verb, "")
        if sink.target in self.blocks:
            return Sink("coil", "")
        self.blocks[sink.target] = sink
        self.seen(sink)
        return sink

    def seen(self, sink: Sink) -> None:
        """Let conditions look at a block."""
        found = {
            "timer": ([sink.target] * 3, [sink.target]),
            "counter": ([sink.target] * 3, [sink.target]),
            "drum": (["last", "q3"], ["step"]),
            "steps": (["s0", "s1", "s2"], []),
            "queue": (["empty", "full"], ["taken", "in"]),
            "shift": (["r0", "r2"], []),
        }[sink.verb]
        self.bits += found[0]
        self.words += found[1]
        if sink.verb == "counter" and self.family == "neza":
            self.bits += [f"{sink.target}.E", f"{sink.target}.F"]

    def counter(self) -> Sink:
        if self.siemens:
            number, rule = self.chance.choice([(0, "up"), (1, "down"), (2, "updown"), (3, "updown")])
            presets: list[str | int] = [1, 2, 3, "p0", "p1"]
            return Sink("counter", f"c{number}", (self.chance.choice(presets),), rule)
        if self.family == "fx":
            number, rule = self.chance.choice([(0, "to"), (1, "to"), (200, "ring")])
            fixed: str | int = "p0" if rule == "to" and self.chance.random() < 0.2 else self.chance.randint(1, 3)
            return Sink("counter", f"c{number}", (fixed,), rule)
        return Sink("counter", f"c{self.chance.choice([0, 1])}", (self.chance.choice([1, 2, 3, 9999, 9998]),), "preset")

    def shift(self) -> Sink:
        rule = self.chance.choice(["up", "down"])
        if self.family == "neza":
            return Sink("shift", "r0", (), "block")
        length = self.chance.randint(3, 6)
        if self.family == "fx":
            by = self.chance.choice([1, 1, 2])
            return Sink("shift", "r0", (f"i{self.chance.randint(0, 2)}", length, by), rule)
        return Sink(
            "shift", "r0", (self.chance.choice(["i0", "i1", "m0", "q0"]), length if rule == "up" else -length), rule
        )

    def rung(self, planned: Sink) -> Rung:
        pins = self.pins(planned)
        if len(pins) > 1 or pins[0][0]:
            form = "apart" if self.family == "neza" and self.chance.random() < 0.4 else ""
            bit = {"timer": "Q", "counter": "D"}.get(planned.verb, "") if self.family == "neza" and not form else ""
            tail = (bit, self.chance.choice(["q0", "q1"])) if bit and self.chance.random() < 0.4 else None
            return Rung(pins, (planned,), form=form, tail=tail)
        turns = ["", "", "", "not"] + (["rise", "fall", "rise"] if self.family != "neza" else [])
        sinks = [self.filled(planned)]
        if planned.verb in SEVERAL and self.chance.random() < 0.3:
            sinks.append(self.filled(Sink(self.chance.choice(["coil", "set", "reset", "sum"]), "")))
        return Rung(pins, tuple(sinks), turn=self.chance.choice(turns))

    def pins(self, sink: Sink) -> tuple[tuple[str, Node], ...]:
        if self.siemens and sink.verb == "counter":
            names = {"up": ("CU", "R"), "down": ("CD", "LD"), "updown": ("CU", "CD", "R")}[sink.rule]
        elif self.family == "neza" and sink.verb in {"timer", "counter", "drum", "steps", "queue", "shift"}:
            every = {"timer": ["IN"], "counter": ["R", "S", "CU", "CD"], "drum": ["R", "U"], "queue": ["R", "I", "O"]}
            chosen = [
                name for name in every.get(sink.verb, ["R", "CU", "CD"]) if len(name) > 1 or self.chance.random() < 0.75
            ]
            self.chance.shuffle(chosen)
            names = tuple(chosen) or ("R",)
        else:
            names = ("",)
        quick = {"I": "i0", "O": "i1"} if sink.verb == "queue" and self.chance.random() < 0.7 else {}
        rare = {"R", "S", "LD"}
        return tuple((pin, Contact(quick[pin]) if pin in quick else self.node(2, rare=pin in rare)) for pin in names)

    def filled(self, sink: Sink) -> Sink:
        """Say on what a coil, a set, a clear or a sum acts."""
        chance = self.chance
        if sink.verb == "clear":
            blocks = sorted(name for name, one in self.blocks.items() if one.verb in {"timer", "counter"})
            sink = Sink("clear", chance.choice(blocks)) if blocks else Sink("coil", "")
        if sink.verb == "sum" and not sink.target:
            return self.sum()
        if sink.target:
            return sink
        places = ["q0", "q1", "q2", "m0", "m1", "m2"]
        places += ["r0", "r1"] if "r0" in self.blocks else []
        places += ["d200"] * 4 if "c200" in self.blocks else []
        target = chance.choice(places)
        if sink.verb == "coil":
            return Sink("coil not" if self.family == "neza" and chance.random() < 0.3 else "coil", target)
        many = self.siemens and target[1:] in {"0", "1"}
        return Sink(sink.verb, target, (chance.choice([1, 2]),) if many else (1,) if self.siemens else ())

    def sum(self) -> Sink:
        chance = self.chance
        rule, target = chance.choice(["move", "add", "sub", "next", "last"]), chance.choice(["w0", "w1", "w2"])
        values: list[str | int] = [
            "w0",
            "w1",
            "w2",
            1,
            7,
            1000,
            -5,
            32767,
            *(w for w in self.words if w[0] in "tc" and w != "c200"),
        ]
        presets = [name for name, one in self.blocks.items() if one.verb == "timer"] if self.family == "neza" else []
        if presets and chance.random() < 0.4:
            return Sink("sum", f"{chance.choice(presets)}.P", (chance.randint(1, 5),), "move")
        if self.siemens and chance.random() < 0.2:
            return (
                Sink("sum", "p1", (chance.randint(0, 5),), "move")
                if chance.random() < 0.6
                else Sink("sum", "p1", ("p1",), "next")
            )
        if "queue" in self.blocks and chance.random() < 0.5:
            return Sink("sum", "in", (chance.choice(values),), "move")
        if rule == "move":
            return Sink("sum", target, (chance.choice(values),), rule)
        left = target if self.siemens or rule in {"next", "last"} or chance.random() < 0.5 else chance.choice(values)
        return Sink("sum", target, (left, chance.choice(values)) if rule in {"add", "sub"} else (left,), rule)

    def node(self, depth: int, *, rare: bool = False) -> Node:
        """Draw a condition; `rare`: one that is seldom on."""
        if rare and self.chance.random() < 0.7:
            return Series((Contact(f"i{self.chance.randint(0, 1)}"), Contact("i2"), Contact("i3", "not")))
        dice = self.chance.random()
        if depth and dice < 0.35:
            parts = tuple(self.node(depth - 1) for _ in range(self.chance.randint(2, 3)))
            return Series(parts) if self.chance.random() < 0.5 else Parallel(parts)
        return self.compare() if dice > 0.88 else self.contact()

    def compare(self) -> Compare:
        left = self.chance.choice(self.words)
        others = [0, 1, 2, 3, 5, -1, 32766] + [name for name in self.words if name != "c200" and left != "c200"]
        return Compare(self.chance.choice(list(RELATIONS)), left, self.chance.choice(others))

    def contact(self) -> Contact:
        if self.family == "neza" and self.chance.random() < 0.1:
            return Contact(self.chance.choice(["m0", "m1", "m2"]), self.chance.choice(["rise", "fall"]))
        bit = self.chance.choice(self.bits)
        edges = self.family != "neza" or bit[0] in "im"
        return Contact(bit, self.chance.choice(["", "", "", "not", "rise", "fall"] if edges else ["", "", "not"]))


def random_program(chance: Random, family: str) -> Program:
    """Draw a program of two to five rungs."""
    return Maker(chance, family).program()


def random_scans(chance: Random, count: int) -> list[tuple[dict[str, bool], int]]:
    """Draw inputs that change now and then, and how long each scan lasts."""
    now = {f"i{number}": chance.random() < 0.4 for number in range(4)}
    scans = []
    for _ in range(count):
        now = {name: bit != (chance.random() < 0.3) for name, bit in now.items()}
        scans.append((now, chance.choice([1, 7, 10, 20, 30, 50, 90, 100, 130, 250])))
    return scans


def watched(program: Program) -> list[tuple[str, bool]]:
    """Give every name whose value is compared, each with whether it is a word."""
    bits = {f"{letter}{number}" for letter in "qm" for number in range(3)}
    words = {"w0", "w1", "w2"}
    for sink in program.sinks():
        if sink.verb in {"timer", "counter"}:
            words.add(sink.target)
            bits.add(sink.target)
        if sink.verb == "counter" and program.family == "neza":
            bits |= {f"{sink.target}.E", f"{sink.target}.F"}
        if sink.verb == "timer" and program.family == "neza":
            words.add(f"{sink.target}.P")
        if sink.verb == "shift":
            bits |= {f"r{number}" for number in range(16 if program.family == "neza" else abs(int(sink.sources[1])))}
            bits |= {"out"} if program.family == "neza" else set()
        if sink.verb == "drum":
            words.add("step")
            bits |= {"last", "q3", "q4", "q5"}
        if sink.verb == "steps":
            bits |= {f"s{number}" for number in range(6)}
        if sink.verb == "queue":
            words |= {"in", "taken"}
            bits |= {"empty", "full"}
    bits |= {"f0", "f1", "f2"} if program.family != "neza" else set()
    words |= {"p1"} if program.family in {"s7-200", "gutta"} else set()
    return [(name, False) for name in sorted(bits)] + [(name, True) for name in sorted(words)]
