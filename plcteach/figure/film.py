"""A run as the browser plays it: keyed frames of cells with positions and words, a pure function of a trace.

The browser never learns what OLD means. It is told, for every cell, a key that stays with it while it is the same cell, what a
new one was made from and where a vanished one went; all of that follows from `Step.flow`, which the machine itself obeys.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from itertools import chain
from typing import TYPE_CHECKING, Any

from plcteach.core.diagnostic import rule
from plcteach.core.effect import Name
from plcteach.core.text import Text, joined
from plcteach.figure.cast import cast
from plcteach.figure.face import face_changes
from plcteach.figure.faces import Blocks
from plcteach.figure.growth import Growth
from plcteach.figure.opening import inputs_of, opens
from plcteach.figure.says import says
from plcteach.machine.formula import Term, spelled, written
from plcteach.machine.walk import Move, walks

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from plcteach.core.effect import Effect
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.machine.scan import Scan
    from plcteach.machine.signals import Column
    from plcteach.machine.step import Step
    from plcteach.machine.store import Store

MOST_STEPS = 2_000
MOST_FORMULA_NODES = 120


@dataclass(frozen=True, slots=True)
class Film:
    """A film: plain data for JSON. `steps` of it are drawn one at a time; step 0 is before the first line."""

    data: dict[str, Any]

    def __repr__(self) -> str:
        return f"Film({self.data['digest']}, {len(self.data['steps'])} steps)"

    @property
    def json(self) -> str:
        """The film as the browser gets it."""
        return json.dumps(self.data, ensure_ascii=False, separators=(",", ":"))

    @property
    def length(self) -> int:
        """How many pictures it has, the one before the first line included."""
        return len(self.data["steps"])


def film(scans: Iterable[Scan[Column]], title: Text | None = None, *, rows: bool = False) -> Film:
    """Make a film of some scans of one trace; past `MOST_STEPS` steps it ends and says so in its title.

    rows: number the lines by their rows in the text, as beside an editor, and not one after the other.
    """
    waiting = iter(scans)
    first = next(waiting)
    program = first.program
    maker = _Maker(program, rows=rows)
    for scan in chain([first], waiting):
        if maker.cut or (len(maker.steps) + len(program.lines) >= MOST_STEPS and maker.steps):
            maker.cut = True
            break
        maker.scan(scan)
    whole = title or program.dialect.title
    return Film(maker.data(joined((whole, _BEGINNING)) if maker.cut else whole))


_BEGINNING = Text("（只放开头部分）", "(the beginning only)")
_LOST = Text(
    "最下面一层还没有用过的值被推出栈底，丢失了。",
    "The bottom level's value, not yet used, was pushed out and is lost.",
)
_LEFT = Text(
    "本{unit}到此结束，堆栈里还剩{count}没有用过的值。",
    "The {unit} ends here; unused values left on the stack: {count}.",
)


@dataclass(slots=True)
class _Maker:
    """Collects the steps of one film, with the keys of the cells that stand now."""

    program: Program
    rows: bool = False
    steps: list[dict[str, Any]] = field(default_factory=list)
    texts: dict[str, int] = field(default_factory=dict)
    keys: list[list[str]] = field(default_factory=list)
    foreign: set[str] = field(default_factory=set)
    blank: set[str] = field(default_factory=set)
    made: int = 0
    formulas: tuple[Step[Term], ...] = ()
    moves: tuple[Move, ...] = ()
    residues: dict[int, Text] = field(default_factory=dict)
    faces: dict[str, dict[str, Any]] = field(default_factory=dict)
    first_faces: list[dict[str, Any]] = field(default_factory=list)
    blocks: Blocks = field(init=False)
    growth: Growth = field(init=False)
    held: dict[str, str] = field(default_factory=dict)
    last: tuple[Column, ...] | None = None
    kept_keys: dict[int, list[list[str]]] = field(default_factory=dict)
    alive: list[Step[Column]] = field(default_factory=list)
    heights: list[int] = field(default_factory=list)
    cut: bool = False

    def __post_init__(self) -> None:
        self.formulas = spelled(self.program)
        self.blocks = Blocks(self.program)
        self.growth = Growth(self.program)
        for walk in walks(self.program):
            self.moves += walk.moves
            if walk.leftover:
                count = Text(f"{len(walk.leftover)}个", f"{len(walk.leftover)}")
                self.residues[len(self.moves) - 1] = _LEFT.format(unit=self.dialect.unit, count=count)
        self.heights = [0] * len(self.program.dialect.stacks)

    def scan(self, scan: Scan[Column]) -> None:
        """Add the picture before a scan's first line and one for each of its steps."""
        gone, start = [key for stack in self.keys for key in stack], scan.start()
        self.keys = [
            [self.new(blank=True) for _ in range(stack.depth)] if stack.fixed else [] for stack in self.dialect.stacks
        ]
        first = [["x" for _ in keys] for keys in self.keys]
        self.foreign.clear()
        self.steps.append(
            {
                "line": -1,
                "scan": scan.number,
                "cells": self.cells(first, None, None),
                "leave": dict.fromkeys(gone, "top"),
                "read": [[address, value] for address, value in inputs_of(scan)],
                "say": opens(scan, start).as_dict(),
            }
        )
        self.steps[-1] |= {"power": power} if (power := self.growth.start()) else {}
        self.faced(self.steps[-1], start)
        self.walk(scan)

    def walk(self, scan: Scan[Column]) -> None:
        """Add one picture for each step of a scan."""
        heads = {
            sum(len(one.lines) for one in self.program.networks[:at]) for at in range(1, len(self.program.networks))
        }
        self.last = None
        self.kept_keys.clear()
        self.alive.clear()
        for step, plant in scan.walk():
            self.cut = len(self.alive) >= max(MOST_STEPS - 1, len(self.program.lines))  # a loop that ran away
            if self.cut:
                break
            self.alive.append(step)
            self.blocks.look(step)
            self.step(scan, step.number, step, starts=step.number in heads)
            self.faced(self.steps[-1], plant)

    def faced(self, shot: dict[str, Any], store: Store[Column]) -> None:
        """Add what the blocks show, where it is no longer what they showed before."""
        for face in self.blocks.faces(store):
            now = face.as_dict()
            if face.address not in self.faces:
                self.first_faces.append(now)
            elif changes := face_changes(self.faces[face.address], now):
                shot.setdefault("faces", {})[face.address] = changes
            self.faces[face.address] = now

    @property
    def dialect(self) -> Dialect:
        return self.program.dialect

    def new(self, *, blank: bool = False) -> str:
        self.made += 1
        key = f"k{self.made}"
        if blank:
            self.blank.add(key)
        return key

    def word(self, text: str) -> int:
        return self.texts.setdefault(text, len(self.texts)) if text else -1

    def step(self, scan: Scan[Column], number: int, step: Step[Column], *, starts: bool) -> None:
        shown = {key for keys in self.keys for key in keys}
        swept = self.new_network() if starts else {}
        aside = self.put_aside(step)
        before = [list(keys) for keys in self.keys]
        shot: dict[str, Any] = {
            "line": number,
            "scan": scan.number,
            "from": {},
            "enter": dict.fromkeys((key for keys in self.keys for key in keys), "load") if aside else {},
            "leave": aside | swept,
            "changed": [],
        }
        self.keys = [
            [self.key(shot, stack, place, before, step) for place in range(len(origins))]
            for stack, origins in enumerate(step.flow.after)
        ]
        self.left(shot, before, step)
        standing = {key for keys in self.keys for key in keys}
        shot["enter"] = {key: how for key, how in shot["enter"].items() if key in standing}
        shot["leave"] = {key: how for key, how in shot["leave"].items() if key in shown}
        self.kept_keys[id(step.after[0])] = [list(keys) for keys in self.keys]
        values = [[repr(value) for value in stack] for stack in step.after]
        shot["cells"] = self.cells(values, number, step)
        shot["read"] = [[address.text, repr(value)] for address, value in step.read]
        shot["write"] = list(self.written(step))
        shot["say"] = says(self.dialect, step, first=not scan.before.scans).as_dict()
        shot["power"] = self.growth.step(step)
        shot["warn"] = self.warning(number, step)
        self.steps.append({name: value for name, value in shot.items() if name == "cells" or value not in ({}, [])})

    def put_aside(self, step: Step[Column]) -> dict[str, str]:
        """Put the whole stack aside at a call, and bring it back at the return; give the keys that go."""
        main = step.before[0]
        last, self.last = self.last, step.after[0]
        kept = self.kept_keys.get(id(main))
        if last is None or last is main or (not main and not self.keys[0]):
            return {}
        gone = dict.fromkeys((key for keys in self.keys for key in keys), "top")
        self.keys = [list(keys) for keys in kept] if kept else [[self.new() for _ in cells] for cells in step.before]
        return gone

    def written(self, step: Step[Column]) -> Iterator[list[str]]:
        """Give what a step wrote; of words and rows that were left as they were, nothing."""
        quiet = step.line.insn.does <= {"work", "shift"}
        for address, value in step.written:
            said = repr(value)
            if not quiet or self.held.get(address.text, "0") != said:
                yield [address.text, said]
            self.held[address.text] = said

    def new_network(self) -> dict[str, str]:
        """Between networks growing stacks are emptied, and what a fixed one still holds belongs to somebody else."""
        swept: dict[str, str] = {}
        for number, stack in enumerate(self.dialect.stacks):
            if stack.fixed:
                self.foreign.update(key for key in self.keys[number] if key not in self.blank)
            else:
                swept.update(dict.fromkeys(self.keys[number], "top"))
                self.keys[number] = []
        return swept

    def key(self, shot: dict[str, Any], stack: int, place: int, before: list[list[str]], step: Step[Column]) -> str:
        """Give the key of one cell afterwards: the old one if it is the same cell, else a new one and its parents."""
        origin = step.flow.after[stack][place]
        parents = [before[number][at] for number, at in origin.sources if at < len(before[number])]
        if origin.how == "kept" and parents:
            return parents[0]
        if origin.how == "made" and origin.sources == ((stack, place),) and parents:
            if step.before[stack][place] != step.after[stack][place]:
                shot["changed"].append(parents[0])
            self.foreign.discard(parents[0])
            self.blank.discard(parents[0])
            return parents[0]
        key = self.new(blank=origin.how == "blank")
        if parents:
            shot["from"][key] = parents
        else:
            shot["enter"][key] = "bottom" if origin.how == "blank" else "load"
        return key

    def left(self, shot: dict[str, Any], before: list[list[str]], step: Step[Column]) -> None:
        standing = {key for stack in self.keys for key in stack}
        for places, where in ((step.flow.lost, "bottom"), (step.flow.merged, "merge"), (step.flow.dropped, "top")):
            for stack, place in places:
                if before[stack][place] not in standing:
                    shot["leave"][before[stack][place]] = where

    def cells(self, values: list[list[str]], number: int | None, step: Step[Column] | None) -> list[list[Any]]:
        rows: list[list[Any]] = []
        for stack, keys in enumerate(self.keys):
            self.heights[stack] = max(self.heights[stack], len(keys))
            for place, key in enumerate(keys):
                formula, name, flags = -1, -1, "u" if key in self.blank else ""
                if number is not None and step is not None:
                    formula = self.formula(number, stack, place)
                    name = self.word(_name(step, stack, place))
                    flags = self.flags(number, stack, place, key)
                rows.append([key, stack, place, values[stack][place], formula, name, flags])
        return rows

    def formula(self, number: int, stack: int, place: int) -> int:
        """Give the formula of a cell; one that nobody knows has none worth showing."""
        text = written(self.formulas[number].after[stack][place], MOST_FORMULA_NODES)
        return -1 if text == "x" else self.word(text)

    def flags(self, number: int, stack: int, place: int, key: str) -> str:
        if key in self.blank:
            return "u"
        cell = self.moves[number].after[stack][place]
        return ("s" if cell.spent else "") + ("f" if key in self.foreign else "") + cell.tag

    def warning(self, number: int, step: Step[Column]) -> dict[str, str]:
        for address, value in step.written:
            if value.unknown:
                return rule("RUN001").says.format(address=address.text).as_dict()
        told = [self.residues[number]] if number in self.residues else []
        if self.moves[number].lost:
            told.insert(0, _LOST)
        return joined(told).as_dict() if told else {}

    def data(self, title: Text) -> dict[str, Any]:
        """Give the whole film."""
        film = cast(self.program, self.heights, rows=self.rows) | {"title": title.as_dict()}
        film |= {"texts": list(self.texts), "steps": self.steps, "ladder": self.growth.data()}
        return film | ({"faces": self.first_faces} if self.first_faces else {})


def _name(step: Step[Column], stack: int, place: int) -> str:
    """Give the name that the textbook's figure of this instruction has for a cell afterwards: iv0, S2, I0.1, x."""
    if stack:
        return ""
    origin = step.flow.after[stack][place]
    if origin.label:
        return origin.label
    if origin.how in {"kept", "copied"}:
        return "" if origin.sources[0][0] else figure_names(step.line.effect, len(step.before[0]))[origin.sources[0][1]]
    if origin.how == "blank":
        return "x"
    return ", ".join(address.text for address, _ in step.read) if isinstance(origin.formula, Name) else ""


def figure_names(effect: Effect, height: int) -> list[str]:
    """Name the cells before an instruction as its figure does, top first: its labels for those it takes, iv0, iv1 … else."""
    takes = [take.name for take in effect.clauses[0].takes][::-1] if effect.labelled else []
    return [takes[place] if place < len(takes) else f"iv{place - len(takes)}" for place in range(height)]
