"""What a live bench shows of one moment: values beside the lines, power in the ladder, lamps, words, faces, and the chart so far.

Everything is a pure reading of one scan, run again line by line; a part that is as it was is not said again.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from plcteach.core.program import Value
from plcteach.core.text import Text
from plcteach.figure.cast import cast
from plcteach.figure.faces import Blocks
from plcteach.figure.film import film
from plcteach.figure.growth import Growth
from plcteach.figure.plant import plant_scene, plant_state
from plcteach.figure.svg import svg
from plcteach.plants import Model

if TYPE_CHECKING:
    from plcteach.core.area import Address
    from plcteach.core.program import Program
    from plcteach.figure.symbol import Style
    from plcteach.machine.live import Live
    from plcteach.machine.signals import Column
    from plcteach.machine.step import Step
    from plcteach.machine.trace import Scan

LEVELS = 4
"""So many levels of the stack stand beside a line, as the vendors' status view has them."""


_FAULT = Text("{time}：{says}", "{time}: {says}")


@dataclass(slots=True)
class Watch:
    """A live run as it is shown; `sent`: what the page knows already, `charted`: up to which change of each row."""

    live: Live
    style: Style = "relay"
    growth: Growth = field(init=False)
    blocks: Blocks = field(init=False)
    sent: dict[str, Any] = field(default_factory=dict)
    charted: int = -1
    drawn: dict[str, Any] = field(default_factory=dict)
    rows: tuple[Address, ...] = field(init=False)
    numbers: tuple[Address, ...] = field(init=False)

    def __post_init__(self) -> None:
        """Lift the program and find its blocks."""
        self.growth = Growth(self.program, self.style)
        self.blocks = Blocks(self.program)
        self.numbers = self.words()
        self.rows = self.charts()

    @property
    def program(self) -> Program:
        """The program that runs."""
        return self.live.program

    @property
    def symbols(self) -> dict[str, str]:
        """What the plant calls the addresses that it is connected to."""
        return {one.address: one.symbol for one in self.model.plant.devices} if self.model else {}

    def cast(self) -> dict[str, Any]:
        """Give what does not change: the lines, the ladder, and what there is to switch, to light and to draw."""
        return cast(self.program, [0] * len(self.program.dialect.stacks), rows=False) | {
            "title": self.program.dialect.title.as_dict(),
            "ladder": self.growth.data(),
            "inputs": [self.named(one) for one in self.program.addresses("input")],
            "lamps": [self.named(one) for one in (*self.program.addresses("output"), *self.written())],
            "words": [self.named(one) for one in self.words()],
            "rows": [[one.text, int(one.size > 1)] for one in self.rows],
            "ms": self.live.scan_ms,
            **({"plant": self.planted(self.model)} if self.model else {}),
        }

    @property
    def model(self) -> Model | None:
        """The plant that is driven, if it is one that can be drawn."""
        return self.live.plant if isinstance(self.live.plant, Model) else None

    def planted(self, model: Model) -> dict[str, Any]:
        """Give what does not change of the plant: its picture, its story, what a hand can press, and how inputs are wired."""
        plant = model.plant
        return {
            "svg": {lang: svg(plant_scene(plant), lang, paper=False) for lang in ("zh", "en")},
            "title": plant.title.as_dict(),
            "story": plant.story.as_dict(),
            "hands": {one.symbol: one.what.as_dict() | {"springs": one.momentary} for one in plant.hands},
            "wires": [
                [one.symbol, model.wires.get(one.symbol, one.wired), one.what.as_dict()]
                for one in plant.inputs
                if one.role == "hand"
            ],
            "ways": [
                [one.symbol, model.ways.get(one.symbol, one.way), one.what.as_dict()]
                for one in plant.inputs
                if one.along
            ],
        }

    def plant(self, scan: int) -> dict[str, Any]:
        """Give the state of the plant's picture after a scan."""
        model = self.model
        if model is None:
            return {}
        then = self.live.plant_at(scan)
        if then is None:
            return plant_state(model)
        now = model.moment()
        model.back_to(then)
        shown = plant_state(model)
        model.back_to(now)
        return shown

    def named(self, address: Address) -> dict[str, str]:
        """Give an address with its name, where a symbol table has one."""
        name = self.program.symbols.get(address.text, "") or self.symbols.get(address.text, "")
        return {"address": address.text} | ({"name": name} if name else {})

    def written(self) -> tuple[Address, ...]:
        """Give the memory bits that the program writes, timers and counters apart, which have faces."""
        mine = {arg.text for line in self.program.lines if line.insn.then for arg in line.bits}
        dialect = self.program.dialect
        return tuple(one for one in self.program.addresses("memory") if one.text in mine and not dialect.block(one))

    def words(self) -> tuple[Address, ...]:
        """Give the words that the program names, timers and counters apart, which have faces."""
        return tuple(one for one in self.program.words() if not one.field and self.program.dialect.block(one) is None)

    def charts(self) -> tuple[Address, ...]:
        """Give what the chart draws: inputs, written memory bits, outputs, words."""
        return (*self.program.addresses("input"), *self.written(), *self.program.addresses("output"), *self.words())

    def moment(self, scan: Scan[Column]) -> dict[str, Any]:
        """Give everything that is seen of one scan's end."""
        values: dict[int, list[str]] = {}
        self.growth.start()
        plant = scan.start()
        for step, plant in scan.walk():  # noqa: B007 (the last one is wanted)
            self.blocks.look(step)
            self.growth.step(step)
            values[step.number] = _beside(step)
        lit = sorted(part for parts in self.growth.lit.values() for part in parts)
        return {
            "lines": [values.get(number, []) for number in range(len(self.program.lines))],
            "lit": lit,
            "bits": {one.text: repr(plant.bit(one)) for one in self.rows if one.size == 1},
            "words": {one.text: _number(plant.word(one)) for one in self.numbers},
            "faces": {face.address: face.as_dict() for face in self.blocks.faces(plant)},
        }

    def batch(self, scan: Scan[Column], number: int) -> dict[str, Any]:
        """Give what has changed since the page was last told."""
        now = self.moment(scan) | ({"plant": self.plant(number)} if self.model else {})
        changed = {name: value for name, value in now.items() if self.sent.get(name) != value and name != "faces"}
        known = self.sent.get("faces", {})
        faces = {address: face for address, face in now["faces"].items() if known.get(address) != face}
        self.sent = now
        return (
            changed
            | ({"faces": faces} if faces else {})
            | {
                "scan": number,
                "now": scan.start_ms,
                "scans": self.live.scans,
                "first": self.live.forgotten,
                "end": self.live.now,
            }
        )

    def forget(self) -> None:
        """Tell the page everything anew the next time."""
        self.sent, self.charted, self.drawn = {}, -1, {}

    def chart(self) -> dict[str, list[list[Any]]]:
        """Give each row's new changes, [ms, value], since the last time; a word over bits as it is now, where it is another."""
        trace = self.live.recorder
        since, self.charted = self.charted, self.live.scans - 1
        found: dict[str, list[list[Any]]] = {}
        for one in self.rows:
            new = []
            when, values = trace.changes.get(one.text, ((), ()))
            for at in range(len(when) - 1, -1, -1):
                if when[at] + self.live.forgotten <= since:
                    break
                new.append([trace.starts[when[at]], repr(values[at])])
            word = self.sent.get("words", {}).get(one.text)
            if not new and one.size > 1 and self.drawn.get(one.text) != word:
                new.append([self.live.now, word])
            if new:
                found[one.text] = new[::-1]
                self.drawn[one.text] = new[0][1]
        return found

    def found(self) -> list[dict[str, str]]:
        """Give what there is to say of the run so far: an x at an output, a loop that ran away, a fault, another output than recorded."""
        faults = self.model.faults if self.model else ()
        said = [one.text for one in self.live.recorder.found.values()]
        said += [_FAULT.format(time=f"{fault.ms / 1000:.2f} s", says=fault.says) for fault in faults]
        said += [one.text for one in self.live.differs]
        return [one.as_dict() for one in said]

    def film(self, scan: Scan[Column]) -> str:
        """Give one scan as a film, to be stepped through instruction by instruction."""
        title = Text(
            f"第{scan.number + 1 + self.live.forgotten}个扫描周期", f"scan {scan.number + 1 + self.live.forgotten}"
        )
        return film([scan], title).json


def _beside(step: Step[Column]) -> list[str]:
    """Give what stands beside a line: its operand's value, and the uppermost levels of the stack after it."""
    operand = ""
    if step.read:
        operand = _number(step.read[0][1])
    elif step.written:
        operand = _number(step.written[0][1])
    return [operand, *(repr(cell) for cell in step.after[0][:LEVELS])]


def _number(value: Any) -> str:
    if isinstance(value, Value):
        return value.text
    return repr(value)
