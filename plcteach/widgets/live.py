"""The LiveBench: a program that runs under the fingers; the page asks for the next scans, and the kernel computes them."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import traitlets

from plcteach.core.diagnostic import errors, refuse
from plcteach.core.text import Text
from plcteach.figure.live import Watch
from plcteach.machine.live import Live
from plcteach.machine.recording import to_its_end
from plcteach.machine.scan import SCAN_MS, warm
from plcteach.machine.timeline import timeline
from plcteach.widgets.show import Shown, module, styles

if TYPE_CHECKING:
    from plcteach.core.program import Program
    from plcteach.machine.live import Driven
    from plcteach.machine.timeline import Timeline
    from plcteach.machine.trace import Trace

MOST_SCANS = 2_000
"""More scans than this one request does not get, however long the page was away."""

_ROW = Text("时间表第{row}行：{says}", "row {row} of the timeline: {says}")
_GONE = Text(
    "这次运行太长，开头的记录已经不在了，不能从头重放。先冷启动，再重新记录。",
    "This run was so long that the beginning of its recording is gone. Make a cold start, and record it again.",
)
_NOT_COLD = Text("这次记录不是从冷启动开始的。", "This recording did not begin with a cold start.")


class Session:
    """Answers what a page asks of a run under way; without a request nothing runs.

    loaded: the recording that was given or opened last, to be replayed where nothing has been done by hand.
    """

    def __init__(self, live: Live, loaded: Timeline | None = None) -> None:
        self.live = live
        self.watch = Watch(live)
        self.loaded = loaded
        self.acted = False

    def answer(self, asked: dict[str, Any]) -> dict[str, Any]:
        """Give the answer to one message, as plain data."""
        for address, value in asked.get("events", ()):
            self.event(str(address), value)
        match asked.get("type"):
            case "run":
                self.live.run(max(0, min(MOST_SCANS, int(asked.get("scans", 0)))))
            case "replay":
                return self.replay(asked)
            case "hand":
                self.take_over()
            case "start":
                memory = warm(self.live.program, self.live.recorder.memory()) if asked.get("how") == "warm" else None
                self.live.reset(memory)
                self.acted = any(self.live.held.values())
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
                    "text": self.text(),
                    "name": "timeline.txt",
                }
        return self.batch(asked)

    def event(self, address: str, value: object) -> None:
        """Press a button of the plant, set an input that the program has, or give it back; nothing else can be set from a page.

        A button goes by its symbol with @ before it, or by its address; an input that the plant moves itself is forced. While a
        recording runs, nothing is pressed.
        """
        if self.live.tape:
            return
        self.acted = True
        model = self.watch.model
        hands = {one.symbol: one for one in model.plant.hands} if model else {}
        symbol = address.removeprefix("@") if address.startswith("@") else self.watch.symbols.get(address, "")
        if model and symbol in hands and address not in self.live.held:
            if not hands[symbol].address:
                self.live.touch(symbol, int(bool(value)), int(model.bits[symbol]))
            model.press(symbol, int(bool(value)))
            return
        if address not in {one.text for one in self.live.program.addresses("input")}:
            return
        if value is None:
            self.live.release(address)
        else:
            self.live.press(address, int(bool(value)))

    def replay(self, asked: dict[str, Any]) -> dict[str, Any]:
        """Run a recording again from power-on: this bench's own, or the text of one; what cannot be read is answered in words."""
        given = asked.get("text")
        line = self.own() if given is None else recording(str(given), self.live)
        slips = errors(line.diagnostics) if line else []
        says = [_ROW.format(row=one.span.row, says=one.text) for one in slips] if line else [_GONE]
        if line is None or says:
            return {"type": "refused", "id": asked.get("id"), "says": [one.as_dict() for one in says]}
        again = line is not self.loaded and given is None
        self.loaded = self.loaded if again else line
        self.live.replay(line, self.live.origin if again else None)
        self.watch.forget()
        return self.batch(asked) | {"anew": True}

    def own(self) -> Timeline | None:
        """Give the recording that runs, or else what has been done since power-on; where that is nothing, what was loaded last.

        None where its beginning is forgotten.
        """
        if self.live.tape:
            return self.live.tape
        if self.loaded and not self.acted:
            return self.loaded
        return self.live.recording() if self.live.whole else None

    def text(self) -> str:
        """Give the recording as a file; a run that did not begin with an empty memory says so."""
        cold = not self.live.origin.bits and not self.live.origin.words and self.live.whole
        return ("" if cold else f"// {_NOT_COLD.zh} {_NOT_COLD.en}\n") + self.live.timeline() + "\n"

    def take_over(self) -> None:
        """Give the inputs back to the hand, and let go the buttons that spring back."""
        self.live.take_over()
        self.acted = True
        model = self.watch.model
        for one in model.plant.hands if model else ():
            if one.momentary and model:
                model.press(one.symbol, 0)

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
            "held": [one for one, value in self.live.held.items() if value],
            "tape": self.taped(),
        }

    def taped(self) -> dict[str, Any] | None:
        """Give how long the recording is that runs, whether it is over, and whether it says what the outputs were."""
        line = self.live.tape
        if line is None:
            return None
        return {"end": line.until_ms, "over": self.live.over, "tells": bool(line.seen), "same": not self.live.differs}


def recording(text: str, live: Live) -> Timeline:
    """Read a timeline to be replayed in a run; its diagnostics say what cannot be read."""
    return to_its_end(timeline(text, live.program.dialect, scan_ms=live.scan_ms))


class LiveBench(Shown):
    """Press the button, watch the scan: switches, lamps, ladder, list, blocks and chart, all of one moment.

    cast: what does not change while it runs, as JSON.
    """

    _esm = module("render-live.js")
    _css = styles("player.css", "bench.css", "live.css")
    cast = traitlets.Unicode("{}").tag(sync=True)

    def __init__(
        self,
        program: Program,
        plant: Driven | None = None,
        *,
        scan_ms: int = SCAN_MS,
        tape: str | None = None,
        **values: Any,
    ) -> None:
        live = Live(program, plant, scan_ms=scan_ms)
        self._session = Session(live, None if tape is None else recording(tape, live))
        if self._session.loaded:
            refuse(self._session.loaded.diagnostics)
            live.replay(self._session.loaded)
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
        """What the inputs did and the outputs were, as a timeline: `plc.replay(program, bench.timeline)` does it again."""
        return self._session.live.timeline()

    def _words(self) -> str:
        live = self._session.live
        return f"LiveBench({live.program.dialect.name}, {len(live.program.lines)} lines)"
