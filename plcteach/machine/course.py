"""The course of one scan: which line comes next, whether it is executed at all, and whether the rail has power.

`run` says where the program is executed: a line that is passed over changes nothing, not even the stack. It is a signal like
any other, so that a jump that only some of many cases take needs no branching here: the others simply go on.
Loops and jumps backwards need one answer for all cases; where there is none, `Mixed` says so and the cases run one by one.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, TypeVar

from plcteach.core.area import Address
from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.machine.plan import plan_of
from plcteach.machine.rails import Rails, number_of
from plcteach.machine.signals import Signal
from plcteach.machine.step import Stacks, Step, step

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from plcteach.core.program import Line
    from plcteach.core.verb import Verb
    from plcteach.machine.world import Plant

S = TypeVar("S", bound=Signal)

MOST_LINES = 20_000
"""So many lines in one scan, and a loop has run away."""

DEEPEST = 8


class Mixed(Exception):  # noqa: N818 (no error: the cases part ways)
    """Some cases go back and others do not."""


class Course(Generic[S]):
    """One scan under way."""

    def __init__(self, world: Plant[S]) -> None:
        self.world = world
        self.plan = plan_of(world.program)
        self.shapes = world.dialect.shapes
        self.routine = ""
        self.next, self.stop = self.plan.routines[""]
        self.run: S | None = None if world.stopped is None else ~world.stopped
        self.stacks: Stacks[S] = self.fresh()
        self.frames: list[tuple[str, int, int, S | None, Stacks[S], list[int], S]] = []
        self.waiting: dict[int, S] = {}
        self.loops: list[int] = []
        self.rails: Rails[S] = Rails(world)
        self.executed = 0
        self.went_back: Line | None = None
        self.found: list[Diagnostic] = []

    def fresh(self) -> Stacks[S]:
        """Give the stacks as a scan begins."""
        blank = self.world.domain.blank
        return tuple((blank,) * shape.depth if shape.fixed else () for shape in self.shapes)

    def steps(self) -> Iterator[Step[S]]:
        """Execute line after line, and give those that were executed."""
        lines, domain, count = self.plan.lines, self.world.domain, len(self.plan.lines)
        while self.next < self.stop or self.back():
            number = self.next
            self.next += 1
            if number >= self.stop:
                continue
            if number in self.plan.starts:
                self.stacks = tuple(
                    cells if shape.fixed else () for cells, shape in zip(self.stacks, self.shapes, strict=True)
                )
            self.rails.before(lines[number], lines[number - 1] if number else None)
            self.land(number)
            run = self.running()
            if run == domain.zero and number not in self.plan.wakes:
                continue
            self.world.at(number, count)
            one = step(lines[number], self.shapes, self.stacks, self.world, domain.blank, number=number)
            if run != domain.zero:
                one = self.rails.coil(one)
                self.world.keep(one, run)
                self.stacks = one.after if run is None else self.merged(one, run)
                yield one
            for verb, power in one.asks:
                _ASKED[verb.name](self, verb, one, power)
            self.executed += 1
            if self.executed > MOST_LINES:
                self.ran_away(number)
        self.end()

    def running(self) -> S | None:
        """Say where lines are executed; None: everywhere."""
        gate = self.rails.gate
        if self.run is None or gate is None:
            return self.run if gate is None else gate
        return self.run & gate

    def merged(self, one: Step[S], run: S) -> Stacks[S]:
        """Keep the old cells where the line was passed over."""
        pick = self.world.domain.pick
        return tuple(
            tuple(pick(run, new, old) for new, old in zip(after, before, strict=True))
            if len(after) == len(before)
            else after
            for before, after in zip(one.before, one.after, strict=True)
        )

    def less(self, power: S | None) -> None:
        """Go on only where there was no power."""
        if power is None:
            self.run = self.world.domain.zero
        else:
            self.run = ~power if self.run is None else self.run & ~power

    def here(self, power: S | None) -> S:
        """Say where a condition holds and the line is executed."""
        power = self.world.domain.one if power is None else power
        run = self.running()
        return power if run is None else power & run

    def sure(self, power: S | None) -> bool:
        """Say whether a condition holds, in all cases alike; an unknown one does not."""
        signal = self.here(power)
        answer = self.world.domain.certain(signal)
        if answer is None:
            if getattr(signal, "unknown", 0) and signal == self.world.domain.blank:
                return False
            raise Mixed
        return answer

    # What the verbs ask for.

    def jump(self, verb: Verb, one: Step[S], power: S | None) -> None:
        """Go on at a label: passing over what lies between, or back, where the answer is the same in all cases."""
        number = one.line.bound[verb.target]
        target = self.plan.labels.get((self.routine, int(number)))  # type: ignore[arg-type]
        if target is None:
            return
        if target <= one.number:
            if self.sure(power):
                self.next, self.went_back = target, one.line
            return
        taken = self.here(power)
        was = self.waiting.get(target)
        self.waiting[target] = taken if was is None else was | taken
        self.less(taken)

    def land(self, number: int) -> None:
        """Let those go on that have jumped to this line."""
        waiting = self.waiting.pop(number, None)
        if waiting is None or self.run is None:
            return
        self.run = self.run | waiting
        if self.run == self.world.domain.one:
            self.run = None

    def call(self, verb: Verb, one: Step[S], power: S | None) -> None:
        """Put the stack aside and begin a routine with 1 on top of zeros."""
        name, here, domain = one.line.spell(verb.target), self.here(power), self.world.domain
        if not name or name not in self.plan.routines or here == domain.zero:
            return
        if len(self.frames) >= DEEPEST:
            self.say("RUN003", one)
            return
        self.frames.append((self.routine, self.next, self.stop, self.run, self.stacks, self.loops, here))
        self.loops = []
        self.routine, (self.next, self.stop) = name, self.plan.routines[name]
        self.run = None if here == domain.one else here
        top = (domain.one,) + (domain.zero,) * (self.shapes[0].depth - 1)
        self.stacks = (top if self.shapes[0].fixed else (), *((),) * (len(self.shapes) - 1))

    def back(self) -> bool:
        """Return from a routine at its end, to a stack as it was; False: the scan is over."""
        if not self.frames:
            return False
        self.routine, self.next, self.stop, self.run, self.stacks, self.loops, called = self.frames.pop()
        self.world.bits["ENO"] = self.world.domain.pick(called, self.world.domain.one, self.world.register("ENO"))
        return True

    def leave(self, _verb: Verb, _one: Step[S], power: S | None) -> None:
        """Go on only where there was no power."""
        self.less(power)

    def finish(self, _verb: Verb, _one: Step[S], power: S | None) -> None:
        """End the scan, or end it where there is power."""
        if power is None:
            self.next = self.stop
            self.frames.clear()
            self.run = self.world.domain.zero
        else:
            self.less(power)

    def halt(self, _verb: Verb, _one: Step[S], power: S | None) -> None:
        """Remember where the CPU goes to STOP."""
        here = self.here(power)
        self.world.stopped = here if self.world.stopped is None else self.world.stopped | here
        if self.world.stopped == self.world.domain.zero:
            self.world.stopped = None

    def loop(self, verb: Verb, one: Step[S], power: S | None) -> None:
        """Begin a loop: the index becomes the first value, and the loop is passed over where the last one is smaller."""
        after = self.plan.ends.get(one.number)
        if after is None:
            return
        index, first, last = (one.line.bound[name] for name in (verb.target, *verb.sources))
        kind = self.world.dialect.kinds["word"]
        if self.sure(power) and isinstance(index, Address):
            self.world.store(index, self.world.word(first, kind))
            if self.sure(self.world.word(last, kind).ge(self.world.word(first, kind))):
                self.loops.append(one.number)
                return
        self.next = after + 1

    def again(self, _verb: Verb, one: Step[S], _power: S | None) -> None:
        """End a loop's body: count the index on, and go back until it has passed the last value."""
        first = self.plan.ends.get(one.number)
        if first is None or first not in self.loops:
            return
        del self.loops[self.loops.index(first) + 1 :]  # loops that a jump has left
        line, kind = self.plan.lines[first], self.world.dialect.kinds["word"]
        verb = line.insn.then[0]
        index, last = line.bound[verb.target], line.bound[verb.sources[1]]
        if not isinstance(index, Address):
            return
        count = self.world.word(index, kind) + self.world.domain.number(1)
        self.world.store(index, count.wrap(kind.size))
        if self.sure(self.world.word(last, kind).ge(count)):
            self.next, self.went_back = first + 1, one.line
        else:
            self.loops.pop()

    def master(self, verb: Verb, one: Step[S], power: S | None) -> None:
        """Switch the rail by a master control."""
        self.rails.master(number_of(verb, one), power)

    def restore(self, verb: Verb, one: Step[S], _power: S | None) -> None:
        """End a master control."""
        self.rails.restore(number_of(verb, one))

    def segment(self, verb: Verb, one: Step[S], power: S | None) -> None:
        """Begin a segment."""
        bit = one.line.bound[verb.target]
        if isinstance(bit, Address):
            self.rails.segment(bit, power)

    def unpower(self, _verb: Verb, _one: Step[S], power: S | None) -> None:
        """End a segment or a step."""
        self.rails.unpower(power)

    def transfer(self, _verb: Verb, _one: Step[S], power: S | None) -> None:
        """Leave a segment."""
        self.rails.transfer(self.here(power))

    def step(self, verb: Verb, one: Step[S], power: S | None) -> None:
        """Begin a step."""
        bit = one.line.bound[verb.target]
        if isinstance(bit, Address) and power is not None:
            self.rails.step(bit, power, one.number)

    def setting(self, verb: Verb, one: Step[S], power: S | None) -> None:
        """End a step at the end of the scan in which another is set from within it."""
        target = one.line.bound.get(verb.target)
        if isinstance(target, Address) and power is not None:
            self.rails.depart(target, self.here(power))

    def open_block(self, verb: Verb, one: Step[S], _power: S | None) -> None:
        """Begin a block's input section."""
        block = one.line.bound[verb.target]
        self.world.open_block, self.world.pins = str(block), {}

    def pin(self, verb: Verb, _one: Step[S], power: S | None) -> None:
        """Keep what a pin gets until the section ends."""
        if power is not None:
            self.world.pins[verb.op] = power

    def update(self, _verb: Verb, _one: Step[S], _power: S | None) -> None:
        """End a block's input section."""
        self.world.open_block = ""

    def end(self) -> None:
        """End the scan: steps that were left go off; a CPU that has gone to STOP switches its outputs off."""
        if self.plan.lines:
            self.world.at(len(self.plan.lines) - 1, len(self.plan.lines))
        self.rails.end()
        if self.world.stopped is not None:
            for area in self.world.dialect.areas:
                if area.role == "output":
                    for key in [key for key in self.world.bits if key.startswith(area.prefix)]:
                        self.world.bits[key] = self.world.bits[key] & ~self.world.stopped

    def ran_away(self, number: int) -> None:
        """Stop a scan that does not end, and say which line goes back."""
        line = self.went_back or self.plan.lines[number]
        self.say("RUN002", line, count=MOST_LINES)
        self.next, self.frames = self.stop, []
        self.world.stopped = self.world.domain.one

    def say(self, code: str, where: Any, **values: object) -> None:
        """Add a finding at a line."""
        line = getattr(where, "line", where)
        self.found.append(rule(code).at(line.span, **({"word": line.text} | values)))


_ASKED: dict[str, Callable[[Any, Verb, Any, Any], None]] = {
    "jump": Course.jump,
    "label": lambda *_: None,
    "call": Course.call,
    "return": Course.leave,
    "end": Course.finish,
    "stop": Course.halt,
    "loop": Course.loop,
    "next": Course.again,
    "master": Course.master,
    "restore": Course.restore,
    "segment": Course.segment,
    "rail": Course.unpower,
    "transfer": Course.transfer,
    "step": Course.step,
    "set": Course.setting,
    "open": Course.open_block,
    "pin": Course.pin,
    "update": Course.update,
    "entry": lambda *_: None,
}
