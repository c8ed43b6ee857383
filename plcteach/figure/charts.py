"""The timing chart of a run: a track for each address, from when it changed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.area import Address
from plcteach.core.text import Text
from plcteach.figure.face import lasting
from plcteach.figure.faces import block_names
from plcteach.figure.timing import chart_scene
from plcteach.figure.track import Track
from plcteach.machine.scan import address_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.core.program import Program
    from plcteach.figure.scene import Scene
    from plcteach.machine.scan import Trace


def tracks_of(trace: Trace, addresses: Iterable[str]) -> list[Track]:
    """Give a track for each address: bits as lines, words as steps, a timer's value with its unit."""
    return [_track(trace, address) for address in addresses]


def _track(trace: Trace, address: str) -> Track:
    place = address_of(trace.program.dialect, address)
    changes = tuple((ms, _plain(value)) for ms, value in trace.edges(address))
    block = trace.program.dialect.block(place)
    unit = ""
    if block and block.rule == "timer" and place.size > 1 and place.field != "P":
        unit = f"×{lasting(trace.base(place))}"
    return Track(place.text, changes, place.size > 1, unit)


def _plain(value: object) -> int | None:
    shown = repr(value)
    return None if shown == "x" else int(shown)


def telling_addresses(program: Program) -> list[str]:
    """Give what a chart shows unless it is told: inputs, the values of timers and counters, outputs."""
    inputs, outputs = (list(dict.fromkeys(one.text for one in program.addresses(role))) for role in ("input", "output"))
    values = [value for name in block_names(program) if (value := _value_of(program, name))]
    memory = [one.text for one in program.addresses("memory")]
    return [*inputs, *values, *outputs] or memory or [program.dialect.areas[0].address(0).text]


def _value_of(program: Program, name: str) -> str:
    """Give the address under which a block's current value is read; nothing where it has none."""
    place = program.dialect.address(name)
    if not isinstance(place, Address) or program.dialect.block(place) is None:
        return ""
    fields = program.dialect.area(place).fields
    value = next((field for field in ("V", "S") if fields.get(field, 0) > 1), "")
    return f"{name}.{value}" if value else ""


def chart_of(trace: Trace, addresses: Iterable[str] = (), *, title: Text | None = None, width: float = 720) -> Scene:
    """Draw the timing chart of a run."""
    tracks = tracks_of(trace, list(addresses) or telling_addresses(trace.program))
    words = title or Text("时序图", "timing chart")
    return chart_scene(tracks, _end(trace, tracks), title=words, scans=trace.starts, width=width)


def _end(trace: Trace, tracks: list[Track]) -> int:
    """Say where a chart ends: with the run, or well after the last change where nothing more happens."""
    whole = (trace.starts[-1] if trace.starts else 0) + trace.scan_ms
    last = max((track.changes[-1][0] for track in tracks if track.changes), default=0)
    return min(whole, last + max(last // 3, _TAIL * trace.scan_ms)) if last else whole


_TAIL = 5
