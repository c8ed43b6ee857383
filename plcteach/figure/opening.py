"""What a scan begins with, in words: the inputs it has read, and the timers that its beginning has moved on."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.text import Text, joined
from plcteach.machine.signals import ZERO
from plcteach.machine.store import Store

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.machine.scan import Scan
    from plcteach.machine.signals import Column
    from plcteach.machine.world import Plant


def inputs_of(scan: Scan[Column]) -> list[tuple[str, str]]:
    """Give every input of the program as the scan's input image holds it."""
    return [(one.text, repr(scan.inputs.get(one.text, ZERO))) for one in scan.program.addresses("input")]


def opens(scan: Scan[Column], start: Plant[Column]) -> Text:
    """Say what the scan begins with; `start`: the plant as it finds it."""
    inputs = [f"{address} = {value}" for address, value in inputs_of(scan)]
    said = Text("扫描开始，还没有执行任何指令。", "The scan begins; no instruction has run yet.")
    if inputs:
        zh, en = "、".join(inputs), ", ".join(inputs)
        said = Text(f"扫描开始：输入映像读到{zh}。", f"The scan begins: the input image holds {en}.")
    return joined((said, *_ticked(scan, start)))


def _ticked(scan: Scan[Column], start: Plant[Column]) -> Iterator[Text]:
    """Tell of each timer that the start of the scan has brought up to date."""
    before = Store(scan.program, scan.before, scan.domain)
    for target, _, when in start.clocks:
        ms = start.number(f"{target.text}.ms")
        if when == "scan" and ms != before.number(f"{target.text}.ms"):
            bit, count = start.kept(start.output(target)), ms.over(start.base(target))
            yield Text(
                f"定时器{target.text}在这里刷新：当前值{count!r}，位{bit!r}。",
                f"Timer {target.text} is brought up to date here: current value {count!r}, bit {bit!r}.",
            )
