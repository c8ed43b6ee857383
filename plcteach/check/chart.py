"""A counterexample as a timing chart: scans in which nothing changes are one column, with how long it is held.

hold            4.9 s  1 scan
I0.0            #####  ######
Q0.1 expected   #####  ######
Q0.1 yours      #####  ______  <- differs
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from plcteach.core.text import NOTHING, Text, same
from plcteach.figure.face import lasting
from plcteach.ladder.symbols import columns as columns_of
from plcteach.machine.scan import SCAN_MS

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from plcteach.core.verdict import Counterexample, Verdict

Kind = Literal["input", "expected", "got"]

MOST_COLUMNS = 24
"""More columns than this are not shown; the first of them are left out, for the difference is in the last."""
_MANY = 12
_BITS = {"0": "_", "1": "#", "x": "x"}
_LABELS: dict[Kind, Text] = {
    "input": NOTHING,
    "expected": Text("应为", "expected"),
    "got": Text("你的", "yours"),
}
_HOLD, _SCANS = Text("保持", "hold"), Text("扫描数", "scans")
_ONE_SCAN = Text("1个扫描", "1 scan")
_DIFFERS = Text("<- 不同", "<- differs")
_MORE = Text("…（前面还有{count}列）", "… ({count} columns before these)")
_OTHERS_0 = Text("其余输入都是0。", "All other inputs are 0.")


@dataclass(frozen=True, slots=True)
class Column:
    """Some scans in a row in which nothing changes: the number of the first, how many, and how long they take in ms."""

    first: int
    scans: int
    ms: int | None = None


@dataclass(frozen=True, slots=True)
class Row:
    """An input, or what an output should be or is, with its value in each column: 0, 1, x, or a number."""

    address: str
    kind: Kind
    values: tuple[str, ...]
    differs: tuple[bool, ...] = ()

    @property
    def label(self) -> Text:
        """The address, and what the row shows of it."""
        word = _LABELS[self.kind]
        return Text(f"{self.address} {word.zh}".strip(), f"{self.address} {word.en}".strip())


@dataclass(frozen=True, slots=True)
class Chart:
    """A counterexample, column by column.

    at: the column of the first difference.  timed: whether it tells of times, and not only of scans.  left: how many columns
    before these are not shown.  others: whether inputs that are always 0 are left out.
    """

    columns: tuple[Column, ...]
    rows: tuple[Row, ...]
    at: int
    timed: bool
    left: int = 0
    others: bool = False

    def __repr__(self) -> str:
        return "\n".join(one.en for one in self.lines)

    @property
    def holds(self) -> tuple[Text, ...]:
        """How long each column is held; the last, in which the difference shows, may be one scan."""
        return tuple(_hold(one) for one in self.columns)

    @property
    def lines(self) -> tuple[Text, ...]:
        """The chart in signs of one width: `_` is 0, `#` is 1."""
        zh, en = (tuple(_lines(self, lang)) for lang in ("zh", "en"))
        return tuple(Text(*pair) for pair in zip(zh, en, strict=True) if any(pair))

    def as_dict(self) -> dict[str, Any]:
        """Give the chart as the browser wants it."""
        columns = [
            {"first": one.first, "scans": one.scans, "hold": hold.as_dict()}
            for one, hold in zip(self.columns, self.holds, strict=True)
        ]
        rows = [
            {
                "address": row.address,
                "kind": row.kind,
                "label": row.label.as_dict(),
                "values": list(row.values),
                "differs": list(row.differs),
            }
            for row in self.rows
        ]
        text = {lang: "\n".join(one.in_(lang) for one in self.lines) for lang in ("zh", "en")}
        return {"columns": columns, "rows": rows, "at": self.at, "timed": self.timed, "left": self.left, "text": text}


def chart_of(verdict: Verdict) -> Chart | None:
    """Give the chart of a verdict's counterexample; nothing where it has none."""
    example = verdict.counterexample
    if example is None or not example.inputs:
        return None
    inputs = held(example)
    columns = _merged(example, inputs)
    shown = columns[-MOST_COLUMNS:]
    at = max(number for number, one in enumerate(shown) if one.first <= max(example.scan, shown[0].first))
    names = list(dict.fromkeys(name for row in inputs for name in row))
    few = [name for name in names if any(row.get(name) not in {"0", None} for row in inputs)]
    others = len(names) > _MANY and len(few) < len(names)
    rows = [
        Row(name, "input", tuple(inputs[one.first].get(name, "0") for one in shown))
        for name in (few if others else names)
    ]
    rows += [row for address in _outputs(example) for row in _pair(example, address, shown)]
    return Chart(tuple(shown), tuple(rows), at, timed(example), len(columns) - len(shown), others)


def held(example: Counterexample) -> list[dict[str, str]]:
    """Give the inputs of each scan, those that are not named again included; a scan's length is no input."""
    rows: list[dict[str, str]] = []
    for row in example.inputs:
        rows.append({**(rows[-1] if rows else {}), **{name: str(value) for name, value in row.items() if name != "ms"}})
    return rows


def timed(example: Counterexample) -> bool:
    """Say whether a counterexample tells of times, and not only of scans."""
    return any("ms" in row for row in example.inputs)


def passed(example: Counterexample) -> int:
    """Give the ms from the first scan to the first difference; 0 where no times are told."""
    if not timed(example):
        return 0
    return sum(row.get("ms", SCAN_MS) for row in example.inputs[1 : example.scan + 1])


def _merged(example: Counterexample, inputs: Sequence[Mapping[str, str]]) -> list[Column]:
    """Put scans together in which nothing changes, with the time from the first of them to the next that is another."""
    told = timed(example)
    lasts = [row.get("ms", SCAN_MS) for row in example.inputs[1:]]
    starts = [0, *(number for number in range(1, len(inputs)) if _changes(example, inputs, number)), len(inputs)]
    found = []
    for first, stop in itertools.pairwise(starts):
        ms = sum(lasts[first : min(stop, len(lasts))])
        found.append(Column(first, stop - first, ms if told and (stop < len(inputs) or stop - first > 1) else None))
    return found


def _changes(example: Counterexample, inputs: Sequence[Mapping[str, str]], number: int) -> bool:
    return any(rows[number] != rows[number - 1] for rows in (inputs, example.expected, example.got))


def _outputs(example: Counterexample) -> list[str]:
    """Give the outputs, the one that differs first; of very many only those that differ at some time."""
    names = [example.address, *(one for one in example.expected[0] if one != example.address)]
    if len(names) <= _MANY:
        return names
    pairs = list(zip(example.expected, example.got, strict=True))
    return [one for one in names if any(wanted.get(one) != got.get(one) for wanted, got in pairs)][:_MANY]


def _pair(example: Counterexample, address: str, columns: Sequence[Column]) -> Iterator[Row]:
    wanted, got = (
        tuple(str(side[one.first].get(address, "x")) for one in columns) for side in (example.expected, example.got)
    )
    yield Row(address, "expected", wanted)
    yield Row(address, "got", got, tuple(one != other for one, other in zip(wanted, got, strict=True)))


def _hold(column: Column) -> Text:
    if column.ms is not None:
        return same(lasting(column.ms))
    return _ONE_SCAN if column.scans == 1 else Text(f"{column.scans}个扫描", f"{column.scans} scans")


def _lines(chart: Chart, lang: str) -> Iterator[str]:
    """Write the chart in one language."""
    holds = [
        hold.in_(lang) if chart.timed else str(one.scans) for one, hold in zip(chart.columns, chart.holds, strict=True)
    ]
    values = [row.values for row in chart.rows]
    widths = [max(4, columns_of(hold), *(len(row[at]) for row in values)) for at, hold in enumerate(holds)]
    head = (_HOLD if chart.timed else _SCANS).in_(lang)
    labels = [row.label.in_(lang) for row in chart.rows]
    room = max(map(columns_of, [head, *labels])) + 2
    yield _MORE.format(count=chart.left).in_(lang) if chart.left else ""
    yield _padded(head, room) + " ".join(map(_padded, holds, widths)).rstrip()
    for row, label in zip(chart.rows, labels, strict=True):
        signs = " ".join(_sign(one, width) for one, width in zip(row.values, widths, strict=True))
        mark = f"  {_DIFFERS.in_(lang)}" if any(row.differs) else ""
        yield _padded(label, room) + signs + mark
    yield _OTHERS_0.in_(lang) if chart.others else ""


def _sign(value: str, width: int) -> str:
    return _BITS[value] * width if value in _BITS else value.ljust(width)


def _padded(words: str, width: int) -> str:
    return words + " " * (width - columns_of(words))
