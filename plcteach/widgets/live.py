"""The LiveBench: a program that runs under the fingers; the page asks for the next scans, and the kernel computes them."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import traitlets

from plcteach.figure.live import Watch
from plcteach.machine.live import Live
from plcteach.machine.scan import SCAN_MS, warm
from plcteach.widgets.show import Shown, module, styles

if TYPE_CHECKING:
    from plcteach.core.program import Program
    from plcteach.machine.live import Driven
    from plcteach.machine.trace import Trace

MOST_SCANS = 2_000
"""More scans than this one request does not get, however long the page was away."""


class Session:
    """Answers what a page asks of a run under way; without a request nothing runs."""

    def __init__(self, live: Live) -> None:
        self.live = live
        self.watch = Watch(live)

    def answer(self, asked: dict[str, Any]) -> dict[str, Any]:
        """Give the answer to one message, as plain data."""
        for address, value in asked.get("events", ()):
            self.event(str(address), value)
        match asked.get("type"):
            case "run":
                self.live.run(max(0, min(MOST_SCANS, int(asked.get("scans", 0)))))
            case "start":
                memory = warm(self.live.program, self.live.recorder.memory()) if asked.get("how") == "warm" else None
                self.live.reset(memory)
                self.watch.forget()
            case "wire" if self.watch.model:
                self.wire(str(asked.get("symbol")), str(asked.get("how")))
            case "film":
                return {
                    "type": "film",
                    "id": asked.get("id"),
                    "film": self.watch.film(self.live.at(self.number(asked))),
                }
            case "timeline":
                return {
                    "type": "timeline",
                    "id": asked.get("id"),
                    "text": self.live.timeline() + "\n",
                    "name": "timeline.txt",
                }
        return self.batch(asked)

    def event(self, address: str, value: object) -> None:
        """Press a button of the plant, set an input that the program has, or give it back; nothing else can be set from a page.

        A button goes by its symbol with @ before it, or by its address; an input that the plant moves itself is forced.
        """
        model = self.watch.model
        hands = {one.symbol: one for one in model.plant.hands} if model else {}
        symbol = address.removeprefix("@") if address.startswith("@") else self.watch.symbols.get(address, "")
        if model and symbol in hands and address not in self.live.held:
            model.press(symbol, int(bool(value)))
            return
        if address not in {one.text for one in self.live.program.addresses("input")}:
            return
        if value is None:
            self.live.release(address)
        else:
            self.live.press(address, int(bool(value)))

    def wire(self, symbol: str, how: str) -> None:
        """Connect a button to its other contact, or fit another limit switch; what the plant does not have is passed over."""
        model = self.watch.model
        device = {one.symbol: one for one in model.plant.inputs}.get(symbol) if model else None
        if model and device and how in {"NO", "NC"}:
            model.wire(symbol, "NC" if how == "NC" else "NO")
        elif model and device and device.along and how in {"both", "up", "down"}:
            model.way(symbol, "up" if how == "up" else "down" if how == "down" else "both")

    def number(self, asked: dict[str, Any]) -> int:
        """Give the scan that is asked for: the last where none is named."""
        at = asked.get("at")
        return int(at) if isinstance(at, int | float) else self.live.scans - 1

    def batch(self, asked: dict[str, Any]) -> dict[str, Any]:
        """Give what has changed for the page."""
        if asked.get("anew"):
            self.watch.forget()
        if not self.live.scans:
            self.live.run(1)
        number = self.number(asked)
        return {
            "type": "batch",
            "id": asked.get("id"),
            **self.watch.batch(self.live.at(number), number),
            "chart": self.watch.chart(),
            "forced": self.live.forced(),
            "found": self.watch.found(),
        }


class LiveBench(Shown):
    """Press the button, watch the scan: switches, lamps, ladder, list, blocks and chart, all of one moment.

    cast: what does not change while it runs, as JSON.
    """

    _esm = module("render-live.js")
    _css = styles("player.css", "bench.css", "live.css")
    cast = traitlets.Unicode("{}").tag(sync=True)

    def __init__(self, program: Program, plant: Driven | None = None, *, scan_ms: int = SCAN_MS, **values: Any) -> None:
        self._session = Session(Live(program, plant, scan_ms=scan_ms))
        super().__init__(cast=json.dumps(self._session.watch.cast(), ensure_ascii=False), **values)
        self.on_msg(self._asked)

    def _asked(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        self.send(self._session.answer(content))

    @property
    def trace(self) -> Trace:
        """What has run, as far back as it is kept: to draw, to test, to look at."""
        return self._session.live.trace()

    @property
    def timeline(self) -> str:
        """What the inputs did, as a timeline: `plc.run(program, bench.timeline)` does it again."""
        return self._session.live.timeline()

    def _words(self) -> str:
        live = self._session.live
        return f"LiveBench({live.program.dialect.name}, {len(live.program.lines)} lines)"
