"""A recording used as a test: another program gets the same inputs, and its outputs are held against those that were seen."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

from plcteach.core.diagnostic import refuse
from plcteach.core.errors import PlcTeachError
from plcteach.core.text import Text, language
from plcteach.figure.running import program_of
from plcteach.machine.recording import differences, to_its_end
from plcteach.machine.scan import SCAN_MS, run
from plcteach.machine.timeline import timeline as read_timeline

if TYPE_CHECKING:
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.machine.recording import Difference
    from plcteach.machine.trace import Trace

_SAME = Text(
    "重放了{time}：{addresses}每次扫描都与记录相同。", "{time} replayed: in every scan {addresses} as recorded."
)
_NONE = Text(
    "这份时间表没有记下输出（例如 = {example}: 1s off, on），没有可比较的。",
    "This timeline says of no output what it should be (such as = {example}: 1s off, on): there is nothing to compare.",
)


@dataclass(frozen=True, slots=True)
class Replay:
    """What came of it; true if every recorded output was the same.  differences: for each that was not, the first scan.

    trace: the run, to be charted or played.  seen: the addresses that were compared.
    """

    trace: Trace
    seen: tuple[str, ...]
    differences: tuple[Difference, ...]

    def __bool__(self) -> bool:
        return bool(self.seen) and not self.differences

    @property
    def says(self) -> tuple[Text, ...]:
        """What there is to say, the first difference first."""
        if not self.seen:
            return (_NONE.format(example=next(iter(self.trace.program.dialect.areas)).first),)
        ran = f"{(self.trace.starts[-1] + self.trace.scan_ms) / 1000:.2f} s"
        well = _SAME.format(time=ran, addresses=", ".join(self.seen))
        return tuple(one.text for one in self.differences) or (well,)

    def assert_same(self) -> None:
        """Raise an AssertionError that begins with the first difference, if there is one or nothing was compared."""
        if not self:
            raise AssertionError(repr(self))

    def __repr__(self) -> str:
        return "\n".join(one.in_(language()) for one in self.says)

    def _repr_html_(self) -> str:
        return f"<ul>{''.join(f'<li>{escape(one.in_(language()))}</li>' for one in self.says)}</ul>"


def replay(
    text: str | Program,
    timeline: str,
    dialect: str | Dialect | None = None,
    *,
    within_ms: int = 0,
    scan_ms: int = SCAN_MS,
) -> Replay:
    """Run a recording again, and say in which scan an output differs first: `plc.replay(program, bench.timeline)`.

    timeline: inputs as for `run`, and rows such as "= Q0.0: 1s off, on" for what should be seen.  within_ms: so much earlier or
    later an output may change.
    """
    if within_ms < 0:
        msg = f"an output may come 0 ms or more earlier or later, not {within_ms}"
        raise PlcTeachError(msg)
    program = program_of(text, dialect)
    line = to_its_end(read_timeline(timeline, program.dialect, scan_ms=scan_ms))
    refuse(line.diagnostics)
    trace = run(program, line.scans(), scan_ms=scan_ms)
    return Replay(trace, tuple(one.address for one in line.seen), differences(line, trace, within_ms))
