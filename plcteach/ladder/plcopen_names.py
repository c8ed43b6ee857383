"""What the names of a PLCopen program mean: addresses in canonical spelling, instances of blocks, times and numbers.

An address is written without the X of IEC 61131-3 (%IX0.0 is %I0.0), as the lists of the families have it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.ladder.markup import Element

LONGEST_NAME = 80
INPUTS = {
    "TON": ("IN",), "TOF": ("IN",), "TP": ("IN",),
    "CTU": ("CU", "R"), "CTD": ("CD", "LD"), "CTUD": ("CU", "CD", "R", "LD"),
}  # fmt: skip
"""The inputs of each block that take the flow, in the order of the standard."""
OUTPUTS = {"TON": ("Q",), "TOF": ("Q",), "TP": ("Q",), "CTU": ("Q",), "CTD": ("Q",), "CTUD": ("QU", "QD")}
NUMBERS = {"ET", "CV"}
"""Outputs that are no bit: the time and the count so far."""
FLOWS = {"NOT": ("IN", "OUT"), "R_TRIG": ("CLK", "Q"), "F_TRIG": ("CLK", "Q")}
"""Blocks that are signs on the wire: the input and the output of each."""

ADDRESS = re.compile(r"%([IQM])X?(\d{1,9}(?:\.\d{1,9}){0,3})", re.IGNORECASE)
NAME = re.compile(r"[^\W\d]\w*(?:\.\w+)?")
_TIME = re.compile(r"L?T(?:IME)?#(-?(?:\d[\d_]*(?:\.\d+)?(?:MS|US|NS|[DHMS])_?)+)")
_NUMBER = re.compile(r"(?:U?[SDL]?INT#|L?D?WORD#|BYTE#)?\+?(\d[\d_]{0,11})")


def preset_of(box: str) -> str:
    """Give the name of a block's preset."""
    return "PT" if box.startswith("T") else "PV"


def address_of(word: str) -> str:
    """Give an address of a bit in canonical spelling, or nothing."""
    match = ADDRESS.fullmatch(word.strip())
    if match is None:
        return ""
    return f"%{match[1].upper()}{'.'.join(str(int(part)) for part in match[2].split('.'))}"


def constant(word: str, box: str) -> str:
    """Give a preset in canonical spelling: a time T#5S, a number 3, or the name of a variable; nothing for anything else."""
    plain = "".join(word.split()).upper()
    if len(plain) > LONGEST_NAME:
        return ""
    time, number = _TIME.fullmatch(plain), _NUMBER.fullmatch(plain)
    if preset_of(box) == "PT" and time:
        return f"T#{time[1].replace('_', '')}"
    if preset_of(box) == "PV" and number:
        return str(int(number[1].replace("_", "")))
    return plain if NAME.fullmatch(plain) else ""


@dataclass(slots=True)
class Names:
    """The variables of a program and of the whole project: the address of each that has one, and which are blocks.

    loose: the names without an address that the ladder uses, each with the row of its first use.
    """

    addresses: dict[str, str] = field(default_factory=dict)
    blocks: dict[str, str] = field(default_factory=dict)
    loose: dict[str, int] = field(default_factory=dict)

    def declare(self, variables: Iterable[Element]) -> None:
        """Take declarations; what is declared first counts."""
        for one in variables:
            name = one.get("name").upper()
            if one.get("address"):
                self.addresses.setdefault(name, one.get("address"))
            for kind in one.at("type/derived"):
                self.blocks.setdefault(name, kind.get("name").upper())

    def bit(self, word: str, row: int) -> str:
        """Give what a contact or a coil stands for: an address, or a name in upper case; nothing if it is no bit."""
        name = word.strip().upper()
        given = self.addresses.get(name, name if name.startswith("%") else "")
        if given and "*" not in given:
            return address_of(given)
        if len(name) > LONGEST_NAME or not NAME.fullmatch(name):
            return ""
        if not given and name.partition(".")[0] not in self.blocks:
            self.loose.setdefault(name, row)
        return name
