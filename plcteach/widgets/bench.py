"""The Workbench: an editor, switches, the player and lamps; every change is read, checked and run in the kernel."""

from __future__ import annotations

import json
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any

import traitlets

from plcteach.check.lint import lint
from plcteach.core.diagnostic import errors
from plcteach.core.source import decode
from plcteach.dialects import dialect as find_dialect
from plcteach.figure.film import film
from plcteach.machine.live import Live
from plcteach.machine.scan import Trace, run
from plcteach.stl import read
from plcteach.widgets.live import Session
from plcteach.widgets.player import still, table
from plcteach.widgets.show import Shown, module, styles

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.core.area import Address
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.figure.film import Film
    from plcteach.machine.scan import Memory
    from plcteach.machine.signals import Column


class Workbench(Shown):
    """Type an instruction list, switch its inputs, watch the stack; or let it run live.

    source: the text as typed, never lost, errors or not.  inputs: a JSON object {address: 0 | 1}.  live: what the live bench
    shows of the program, as JSON; nothing while it is stepped through.
    """

    _esm = module("render-bench.js")
    _css = styles("player.css", "bench.css", "live.css")
    source = traitlets.Unicode("").tag(sync=True)
    inputs = traitlets.Unicode("{}").tag(sync=True)
    film = traitlets.Unicode("").tag(sync=True)
    report = traitlets.Unicode("{}").tag(sync=True)
    serial = traitlets.Int(0).tag(sync=True)
    index = traitlets.Int(0).tag(sync=True)
    filename = traitlets.Unicode("program.stl").tag(sync=True)
    live = traitlets.Unicode("").tag(sync=True)

    def __init__(self, text: str, dialect: str | Dialect, inputs: dict[str, int] | None = None, **values: Any) -> None:
        self._dialect = find_dialect(dialect)
        self._memory: Memory[Column] | None = None
        self._scan = 0
        self._film: Film | None = None
        self._ran = ""
        self._seen = ("", "")
        self._session: Session | None = None
        values.setdefault("filename", f"program-{sha256(text.encode()).hexdigest()[:4]}.stl")  # drafts go by file name
        super().__init__(source=text, inputs=json.dumps(inputs or {}), **values)
        self._answer(cold=True)
        self.observe(self._changed, names=["serial"])
        self.on_msg(self._asked)

    def save(self, path: str | Path) -> None:
        """Write the text as typed to a file, as UTF-8."""
        Path(path).write_text(self.source, encoding="utf-8")

    def load(self, path: str | Path) -> None:
        """Read a file in any usual encoding into the editor."""
        self._open(Path(path).name, Path(path).read_bytes())

    def _open(self, name: str, data: bytes) -> None:
        self.filename = name
        self.source = decode(data).replace("\r\n", "\n")
        self._answer(cold=True)

    def _changed(self, _change: object) -> None:
        """Answer a change in the page; a serial alone announces a button, whose message follows."""
        if (self.source, self.inputs) != self._seen:
            self._answer(cold=self.source != self._ran)

    def _asked(self, _widget: object, content: dict[str, Any], buffers: list[bytes]) -> None:
        """Do what a button in the page asks: one more scan, a cold start, open a file."""
        match content.get("type"):
            case "scan":
                self._answer(cold=False)
            case "restart":
                self._answer(cold=True)
            case "open" if buffers:
                self._open(str(content.get("name", "program.stl"))[:80], bytes(buffers[0]))
            case "live":
                self._go_live(read(self._ran, self._dialect) if content.get("on") and self._ran else None)
            case _ if self._session:
                self.send(self._session.answer(content))

    def _go_live(self, program: Program | None) -> None:
        """Run a program live from power-on, or go back to stepping; what was pressed before a change can be replayed after it."""
        before = self._session.own() if self._session else None
        self._session = Session(Live(program), before) if program else None
        self.live = json.dumps(self._session.watch.cast(), ensure_ascii=False) if self._session else ""

    def _answer(self, *, cold: bool) -> None:
        """Read, check and (where there is no error) run one scan, then tell the page."""
        self._seen = (self.source, self.inputs)
        program = read(self.source, self._dialect)
        found = list(lint(program))
        good = not errors(found) and bool(program.lines)
        if good:
            self._run(program, found, cold=cold)
        with self.hold_sync():
            if good and self._film:
                self.film = self._film.json
            self.report = json.dumps(self._report(program, found, good=good), ensure_ascii=False)

    def _run(self, program: Program, found: list[Diagnostic], *, cold: bool) -> None:
        if cold:
            self._memory, self._scan = None, 0
        wanted = json.loads(self.inputs)
        known = {address.text for address in program.addresses("input")}
        trace: Trace = run(
            program,
            [{name: 1 if value in (1, True) else 0 for name, value in wanted.items() if name in known}],
            memory=self._memory,
        )
        found += trace.diagnostics
        self._memory = trace.scans[-1].after
        self._scan += 1
        if self._session and self._ran != self.source:
            self._go_live(program)
        self._ran = self.source
        self._film = film(trace.scans, rows=True)

    def _report(self, program: Program, found: Iterable[Diagnostic], *, good: bool) -> dict[str, Any]:
        wanted = json.loads(self.inputs)
        bits = self._memory.bits if self._memory else {}
        lamps = (*program.addresses("output"), *_written(program))
        return {
            "source": self.serial,
            "dialect": {"name": self._dialect.name, "title": self._dialect.title.as_dict()},
            "list": self._dialect.list.as_dict(),
            "diagnostics": [as_json(one) for one in found],
            "switches": [
                {"address": one.text, "value": 1 if wanted.get(one.text) else 0} for one in program.addresses("input")
            ],
            "lamps": [
                {"address": one.text, "value": repr(bits[one.text]) if one.text in bits else "0"} for one in lamps
            ],
            "scan": self._scan,
            "ok": good,
        }

    def _words(self) -> str:
        shown = still(self._film) if self._film else "no program yet"
        return f"Workbench({self._dialect.name}, {shown})"

    def _still(self) -> str:
        return table(self._film) if self._film else super()._still()


def _written(program: Program) -> tuple[Address, ...]:
    """Give the memory bits that a program writes, as lamps of their own."""
    written = {arg.text for line in program.lines if line.insn.then for arg in line.bits}
    return tuple(one for one in program.addresses("memory") if one.text in written)


def as_json(one: Diagnostic) -> dict[str, Any]:
    """Give a finding as the editor wants it."""
    span = one.span
    return {
        "code": one.code,
        "severity": one.severity,
        "row": span.row,
        "start": span.start,
        "stop": span.stop,
        "text": one.text.as_dict(),
        "notes": [
            {"text": note.text.as_dict(), "row": note.span.row, "start": note.span.start, "stop": note.span.stop}
            for note in one.notes
        ],
        **({"fix": one.fix.as_dict()} if one.fix.en else {}),
    }
