"""Function blocks as a family declares them: which area they fill, their pins, their ranges and what they count in.

How a block behaves is no business of the table: `rule` names it, and the machine has each rule once for all families.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from plcteach.core.text import NOTHING, Text

if TYPE_CHECKING:
    from collections.abc import Mapping

BlockRule = Literal["timer", "counter", "drum", "bits", "steps", "queue"]
When = Literal["scan", "line", "always"]


@dataclass(frozen=True, slots=True)
class Bank:
    """A stretch of numbers of one area that share their timing.

    base: the time base in ms.  when: where the current value is brought up to date: at the start of the scan, when the
    instruction executes, or all the time (as if each line ran a little later).  retains: holds its value without power.
    size: the width of the current value.
    """

    first: int
    last: int
    base: int = 0
    when: When = "line"
    retains: bool = False
    size: int = 16

    def rule(self, op: str) -> str:
        """Say which rule a timer follows: an on-delay whose number keeps its time is retentive."""
        return "retentive" if op == "on" and self.retains else op


@dataclass(frozen=True, slots=True)
class Setting:
    """One thing that a configuration line may set (TYPE=TON): what it may be, and what it is if nothing is said.

    choices: the words it may be, with what each means to the machine.  first, last: the numbers it may be.
    list: it is a list of further words, separated by commas.
    """

    default: str | int
    choices: Mapping[str, str | int] | None = None
    first: int = 0
    last: int = 0
    list: bool = False


@dataclass(frozen=True)
class Block:
    """The blocks of one area.

    title: what one is called.  pins: its inputs.  bit: the field that is its output bit, "" where the address itself is.
    most: where the count ends.  stops: it stops at the preset.  latches: a new preset counts from the next start.
    banks: timing by number.  settings: what a configuration line may set.  preset: the field in which the preset stands.
    down: the letters before a counter's number that make the bit by which it counts down.
    """

    area: str
    rule: BlockRule
    title: Text
    pins: tuple[str, ...]
    outputs: tuple[str, ...] = ()
    bit: str = ""
    most: int = 32767
    stops: bool = False
    latches: bool = False
    banks: tuple[Bank, ...] = ()
    settings: Mapping[str, Setting] | None = None
    preset: str = ""
    down: str = ""
    note: Text = NOTHING

    def __repr__(self) -> str:
        return f"Block({self.area} {self.rule})"

    def bank(self, index: int) -> Bank:
        """Give the timing of one number; a block without banks has one for all."""
        return next((bank for bank in self.banks if bank.first <= index <= bank.last), Bank(0, 0))
