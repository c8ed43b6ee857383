"""What a function block shows at one moment, as plain values: pins, a gauge, a row of bits or words, a drum's grid.

A face knows no machine and no ink. `face_scene` draws it on paper, `as_dict` hands it to the browser.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from plcteach.core.text import NOTHING, Text, joined, same

Kind = Literal["timer", "counter", "drum", "shift", "steps", "queue"]
Mark = Literal["", "active", "new", "gone", "pointer"]
Way = Literal["", "left", "right", "fifo", "lifo"]

GAP = "…"
"""The label of a slot that stands for all those left out."""

_AROUND = 4
_SPARE = 1.25
_LONG_MS = 600_000
_SECOND = 1_000


@dataclass(frozen=True, slots=True)
class Pin:
    """One connection: "0", "1" or "x", nothing while it is not connected, or a number as text."""

    name: str
    value: str = ""


@dataclass(frozen=True, slots=True)
class Gauge:
    """A current value against a preset; None is a value that nobody knows.

    most, least: how far the current value can go.  base: what one count lasts in ms, 0 for what is no time.
    """

    value: int | None
    preset: int | None
    unit: Text = NOTHING
    most: int = 32_767
    least: int = 0
    base: int = 0

    @property
    def end(self) -> int:
        """Where the scale ends: a quarter beyond the preset, so that going past it can be seen."""
        wanted = round(abs(self.preset) * _SPARE) if self.preset else self.most
        return max(1, min(wanted, self.most))

    @property
    def bar(self) -> tuple[float, float]:
        """Where the bar begins and ends, as parts of the scale; a value that nobody knows takes all of it."""
        if self.value is None:
            return 0.0, 1.0
        ends = sorted((self.part(0), self.part(self.value)))
        return ends[0], ends[1]

    @property
    def mark(self) -> float | None:
        """Where the preset stands, as a part of the scale."""
        return None if self.preset is None else self.part(self.preset)

    @property
    def beyond(self) -> bool:
        """Whether the value has left the scale."""
        return self.value is not None and abs(self.value) > self.end

    @property
    def time(self) -> Text:
        """The time that has passed and the time that is set, in words."""
        if not self.base:
            return NOTHING
        passed, wanted = (lasting(None if one is None else one * self.base) for one in (self.value, self.preset))
        passed = "0" if self.value == 0 else passed
        return Text(f"已计{passed}，设定{wanted}", f"{passed} of {wanted}")

    def part(self, value: int) -> float:
        """Give where a value stands on the scale, from 0 to 1."""
        low = -self.end if self.least < 0 else 0
        return min(1.0, max(0.0, (value - low) / (self.end - low)))

    def as_dict(self) -> dict[str, Any]:
        """Give the gauge with its geometry worked out, so that the browser only draws."""
        data: dict[str, Any] = {"value": self.value, "preset": self.preset, "most": self.most}
        data["bar"] = [round(one, 4) for one in self.bar]
        data["mark"] = None if self.mark is None else round(self.mark, 4)
        data |= {"unit": _said(self.unit), "time": _said(self.time), "beyond": self.beyond or None}
        return {name: value for name, value in data.items() if value is not None}


def timed(value: int | None, preset: int | None, base: int, *, most: int = 32_767) -> Gauge:
    """Make the gauge of a timer that counts in steps of `base` ms."""
    return Gauge(value, preset, same(f"×{lasting(base)}"), most, 0, base)


def lasting(ms: int | None) -> str:
    """Write a length of time as briefly as it can be read: 10 ms, 1.2 s, 12 min 5 s; x for one that nobody knows."""
    if ms is None:
        return "x"
    if ms >= _LONG_MS or (ms and ms % 60_000 == 0):
        minutes, rest = divmod(ms, 60_000)
        return f"{minutes} min" + (f" {lasting(rest)}" if rest else "")
    return f"{ms} ms" if 0 < ms < _SECOND else f"{ms / _SECOND:.3f}".rstrip("0").rstrip(".") + " s"


@dataclass(frozen=True, slots=True)
class Slot:
    """One bit of a shift register, one step, or one word of a queue (an empty value: nothing there)."""

    label: str
    value: str = ""
    mark: Mark = ""


@dataclass(frozen=True, slots=True)
class Grid:
    """A drum: its control bits as columns, a row of "0" and "1" for each step, and the step that is active (-1: unknown)."""

    columns: tuple[str, ...]
    rows: tuple[str, ...]
    active: int


@dataclass(frozen=True, slots=True)
class Face:
    """What one block shows.

    slots: by their number, the lowest first. A shift register that has just shifted carries the bit that was lost as one more
    slot with the mark "gone": after the highest when the bits went up, before the lowest when they went down. Slot 0 of a
    queue is the bottom of the pile. In a queue the pins `.I` and `.O` are its two words.
    way: the one way in which a shift register moves (left: to higher numbers), or which word a queue gives back first.
    """

    address: str
    kind: Kind
    title: Text
    inputs: tuple[Pin, ...] = ()
    outputs: tuple[Pin, ...] = ()
    gauge: Gauge | None = None
    slots: tuple[Slot, ...] = ()
    grid: Grid | None = None
    note: Text = NOTHING
    way: Way = ""

    def __repr__(self) -> str:
        pins = " ".join(f"{pin.name}={pin.value or '-'}" for pin in (*self.inputs, *self.outputs))
        return f"Face({self.address}, {self.kind}, {pins})"

    @property
    def words(self) -> Text:
        """What the block shows, for whoever cannot see it."""
        pins = ", ".join(f"{pin.name}={pin.value}" for pin in (*self.inputs, *self.outputs) if pin.value)
        parts = [same(pins), _gauge_words(self.gauge), _slot_words(self), _grid_words(self.grid)]
        told = joined(parts, "；", "; ")
        head = Text(f"{self.title.zh}{self.address}", f"{self.title.en} {self.address}")
        return Text(f"{head.zh}：{told.zh}", f"{head.en}: {told.en}") if told.zh else head

    def as_dict(self) -> dict[str, Any]:
        """Give the face as the browser wants it; what is empty is left out."""
        data: dict[str, Any] = {"address": self.address, "kind": self.kind, "title": self.title.as_dict()}
        data["inputs"] = [[pin.name, pin.value] for pin in self.inputs]
        data["outputs"] = [[pin.name, pin.value] for pin in self.outputs]
        data["gauge"] = self.gauge.as_dict() if self.gauge else None
        data["slots"] = [[slot.label, slot.value, slot.mark] for slot in window(self)]
        if self.grid:
            rows = {"rows": list(self.grid.rows), "active": self.grid.active}
            data["grid"] = {"columns": list(self.grid.columns), **rows}
        data |= {"note": _said(self.note), "way": self.way}
        return {name: value for name, value in data.items() if value not in (None, "", [])}


def face_changes(before: dict[str, Any], after: dict[str, Any]) -> dict[str, Any]:
    """Give the keys in which two dicts of the same face differ; a key that is gone comes as None."""
    names = [*after, *(name for name in before if name not in after)]
    return {name: after.get(name) for name in names if before.get(name) != after.get(name)}


def window(face: Face) -> tuple[Slot, ...]:
    """Give the slots worth drawing: of a step counter those around the active step, of the others all."""
    most = 2 * _AROUND + 1
    if face.kind != "steps" or len(face.slots) <= most + 2:
        return face.slots
    active = next((place for place, slot in enumerate(face.slots) if slot.mark == "active" or slot.value == "1"), 0)
    first = min(max(0, active - _AROUND), len(face.slots) - most)
    head = (Slot(GAP),) if first else ()
    tail = (Slot(GAP),) if first + most < len(face.slots) else ()
    return head + face.slots[first : first + most] + tail


def step_slots(active: int | None, count: int = 256) -> tuple[Slot, ...]:
    """Give all steps of a step counter, exactly one of which is 1; all are x when nobody knows which."""
    if active is None:
        return tuple(Slot(str(step), "x") for step in range(count))
    return tuple(Slot(str(step), *(("1", "active") if step == active else ("0", ""))) for step in range(count))


def _said(text: Text) -> dict[str, str] | None:
    return text.as_dict() if text.zh or text.en else None


def _gauge_words(gauge: Gauge | None) -> Text:
    if not gauge:
        return NOTHING
    value, preset = ("x" if one is None else one for one in (gauge.value, gauge.preset))
    numbers = Text(f"当前值{value}，预设值{preset}", f"current value {value}, preset {preset}")
    time = gauge.time
    return Text(f"{numbers.zh}（{time.zh}）", f"{numbers.en} ({time.en})") if time.zh else numbers


def _grid_words(grid: Grid | None) -> Text:
    if not grid:
        return NOTHING
    if not 0 <= grid.active < len(grid.rows):
        return Text("现在是哪一步未知", "the active step is unknown")
    pairs = zip(grid.columns, grid.rows[grid.active], strict=False)
    on = [name for name, bit in pairs if bit == "1" and name]
    return Text(
        f"第{grid.active}步，接通{'、'.join(on) or '无'}", f"step {grid.active}, on: {', '.join(on) or 'nothing'}"
    )


def _slot_words(face: Face) -> Text:
    slots = [slot for slot in face.slots if slot.mark != "gone"]
    if not slots:
        return NOTHING
    if face.kind == "steps":
        active = next((slot.label for slot in slots if slot.value == "1"), "x")
        return Text(f"第{active}步", f"step {active}")
    if face.kind == "queue":
        kept = [slot.value for slot in slots if slot.value]
        told = " ".join(kept)
        return Text(f"存有{len(kept)}个字，自底向上：{told}", f"{len(kept)} words, from the bottom up: {told}")
    bits = "".join(slot.value or "-" for slot in reversed(slots))
    return Text(f"各位（高位在左）：{bits}", f"bits, the highest first: {bits}")
