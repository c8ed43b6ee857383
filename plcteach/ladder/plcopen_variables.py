"""The variables of a ladder that is written as PLCopen XML: names for its addresses, and the instances of its boxes."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NoReturn

from plcteach.core.errors import NotRepresentableError
from plcteach.core.ladder import Box, Coil, Contact
from plcteach.core.text import Text
from plcteach.ladder.plcopen_names import ADDRESS, INPUTS, LONGEST_NAME, NAME, address_of, constant

if TYPE_CHECKING:
    from plcteach.core.ladder import Ladder

_BOX = re.compile(r"(?P<kind>[A-Z]+) (?P<name>[^\s,.]+), ?(?P<preset>\S+)")


def refuse(number: int, why: Text) -> NoReturn:
    """Say why a rung cannot be written."""
    said = Text("第{n}级写不成PLCopen XML：{why}。", "Rung {n} has no PLCopen XML: {why}.")
    raise NotRepresentableError(said.format(n=number + 1, why=why))


def plain_name(name: str) -> str:
    """Give a program's name as IEC 61131-3 takes it."""
    word = re.sub(r"\W+", "_", name.strip()[:LONGEST_NAME]).strip("_") or "main"
    return word if NAME.fullmatch(word) else f"p_{word}"


def boxed(box: Box, number: int) -> tuple[str, str, str]:
    """Give the kind, the name and the preset of a timer or counter with neutral text."""
    match = _BOX.fullmatch(box.text)
    if not match or match["kind"] not in INPUTS or not NAME.fullmatch(match["name"]):
        example = "TON T1, T#5S"
        refuse(number, Text(f"{{{box.text}}}不是{example}这样的方框", f"{{{box.text}}} is no box such as {example}"))
    kind, name, preset = match["kind"], match["name"], constant(match["preset"], match["kind"])
    pins = [box.entry or INPUTS[kind][0], *(pin for pin, _ in box.pins)]
    if not preset or len(set(pins)) < len(pins) or not {*pins} <= {*INPUTS[kind]}:
        inputs = ", ".join(INPUTS[kind])
        refuse(
            number,
            Text(
                f"{{{box.text}}}的输入只能是{inputs}，预设值写成T#5S或3",
                f"{{{box.text}}} has the inputs {inputs} and a preset such as T#5S or 3",
            ),
        )
    return kind, name, preset


class Variables:
    """The name that stands for each bit, where each is located, and the type of each instance."""

    def __init__(self, ladder: Ladder) -> None:
        self.words: dict[str, str] = {}
        self.located: dict[str, str] = {}
        self.blocks: dict[str, str] = {}
        symbols = [(number, one) for number, rung in enumerate(ladder.rungs) for one in rung.symbols]
        for number, one in symbols:
            if isinstance(one, Box):
                kind, name, _ = boxed(one, number)
                if self.blocks.setdefault(name, kind) != kind:
                    refuse(number, Text(f"{name}已经是{self.blocks[name]}", f"{name} is a {self.blocks[name]} already"))
        bits = dict.fromkeys(one.address for _, one in symbols if isinstance(one, Contact | Coil))
        for address in bits:
            if not _located(address) and NAME.fullmatch(address) and "." not in address:
                self.located[address], self.words[address] = "", address

    def bit(self, address: str, number: int) -> str:
        """Give the variable of a bit."""
        if address not in self.words:
            match = ADDRESS.fullmatch(_located(address))
            block = address.partition(".")[0] in self.blocks and NAME.fullmatch(address)
            if match:
                word = self.fresh(re.sub(r"\W", "_", f"{match[1]}{match[2]}"))
                self.located[word] = f"%{match[1]}X{match[2]}"
                self.words |= {address: word, address_of(self.located[word]): word}
            elif block:
                self.words[address] = address
            else:
                what = Text(
                    "既不是IEC地址，也不是变量名", "is neither an address of the IEC nor the name of a variable"
                )
                refuse(number, Text(f"{address}{what.zh}", f"{address} {what.en}"))
        if address in self.blocks:
            refuse(number, Text(f"{address}是方框的名字，不是位", f"{address} is the name of a box and no bit"))
        return self.words[address]

    def trigger(self, kind: str) -> str:
        """Give a new instance of an edge detection."""
        name = self.fresh(f"{kind}_1")
        self.blocks[name] = kind
        return name

    def fresh(self, word: str) -> str:
        """Give a name that nothing has yet."""
        taken, plain, at = self.located.keys() | self.blocks.keys(), word, 1
        while word in taken:
            at += 1
            word = f"{plain}_{at}"
        return word

    def declared(self) -> list[tuple[str, str, str]]:
        """Give each variable with its address and its type."""
        bits = [(name, address, "") for name, address in self.located.items()]
        return bits + [(name, "", kind) for name, kind in self.blocks.items()]


def _located(address: str) -> str:
    """Give an address of the IEC, or one written without its %, in canonical spelling."""
    return address_of(address if address.startswith("%") or "." not in address else f"%{address}")
