"""What a card says of the blocks that an instruction drives: their pins and outputs, their time bases, and what is special."""

from __future__ import annotations

from itertools import groupby
from typing import TYPE_CHECKING

from plcteach.core.text import Text, same
from plcteach.figure.face import lasting

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.block import Bank, Block
    from plcteach.core.insn import Insn
    from plcteach.core.spec import Dialect

_PINS = Text("引脚和输出", "pins and outputs")
_BASES = Text("时基", "time bases")
_NOTE = Text("注意", "note")
_SETTINGS = Text("配置", "configuration")
_LONG = 32


def blocks_of(dialect: Dialect, insn: Insn) -> Iterator[tuple[Text, Text]]:
    """Give the rows of a card about the blocks that an instruction opens, drives or gives a pin to."""
    targets = {verb.target for verb in insn.then if verb.name in {"open", "pin", "drive"}}
    kinds = [dialect.kinds[one.kind] for one in insn.operands if one.name in targets and one.kind]
    mine = [block for block in dialect.blocks if any(block.area in kind.areas for kind in kinds)]
    if "open" in insn.does:
        yield _PINS, same("; ".join(map(_pins, mine)))
    for block in mine if len(mine) == 1 else ():
        if block.settings:
            yield _SETTINGS, same(f"{block.area}0: {' '.join(_setting(block, name) for name in block.settings)}")
        if block.rule == "timer" and not block.settings:
            yield _BASES, _bases(dialect, block, insn)
        if block.down:
            yield _NOTE, _both_ways(block)
        if block.note.zh:
            yield _NOTE, block.note


def _pins(block: Block) -> str:
    outputs = f" → {', '.join(block.outputs)}" if block.outputs else ""
    return f"{block.area}: {', '.join(block.pins)}{outputs}"


def _setting(block: Block, name: str) -> str:
    setting = (block.settings or {})[name]
    if setting.list:
        return f"{name}=…"
    if setting.choices:
        return f"{name}={'|'.join(setting.choices)}"
    return f"{name}={setting.first}…{setting.last}"


def _bases(dialect: Dialect, block: Block, insn: Insn) -> Text:
    """Say which numbers count in which steps: those that keep their time apart, where they have an instruction of their own."""
    keeps = any(row.retentive for row in dialect.insns)
    banks = sorted((bank for bank in block.banks if not keeps or bank.retains == insn.retentive), key=_order)
    said = []
    for (base, retains), group in groupby(banks, key=lambda bank: (bank.base, bank.retains)):
        numbers = ", ".join(_span(block, bank) for bank in group)
        more = Text("（保持型）", " (retentive)") if retains and not keeps else same("")
        said.append(Text(f"{lasting(base)}{more.zh}：{numbers}", f"{lasting(base)}{more.en}: {numbers}"))
    return Text("；".join(one.zh for one in said), "; ".join(one.en for one in said))


def _order(bank: Bank) -> tuple[bool, int, int]:
    return bank.retains, bank.base, bank.first


def _span(block: Block, bank: Bank) -> str:
    first, last = f"{block.area}{bank.first}", f"{block.area}{bank.last}"
    return first if first == last else f"{first}–{last}"


def _both_ways(block: Block) -> Text:
    """Say which counters count 32 bits both ways, and by which bits."""
    bank = next(bank for bank in block.banks if bank.size == _LONG)
    numbers, bits = _span(block, bank), f"{block.down}{bank.first}–{block.down}{bank.last}"
    return Text(
        f"{numbers}是32位计数器，{bits}中对应的位为1时减计数；预设值向上通过时变为1，向下通过时变为0",
        f"{numbers} count 32 bits, and downwards while their bit of {bits} is 1; they become 1 where the preset is reached "
        "upwards and 0 where it is left downwards",
    )
