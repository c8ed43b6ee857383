"""Which address of one family becomes which of another: bits in order, system bits by their meaning, words, timers, counters.

Everything is derived from what the two tables declare of their areas: each use has an area on both sides, and what is the
n-th bit (word) there is the n-th here. What cannot be placed so gets the next free place, and every choice is kept in a table
in order of first appearance, so that a learner sees it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NoReturn

from plcteach.core.area import Address
from plcteach.core.errors import NotRepresentableError
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Iterable

    from plcteach.core.area import Area
    from plcteach.core.block import Bank
    from plcteach.core.spec import Dialect, Use

WORD = 16
_OPPOSITE = {"on": "off", "off": "on", "first": "later", "later": "first"}


def lacking(zh: str, en: str) -> NotRepresentableError:
    """Make the reason why something has no counterpart."""
    return NotRepresentableError(Text(zh, en))


def none(zh: str, en: str) -> NoReturn:
    """Say that something has no counterpart."""
    raise lacking(zh, en)


class Places:
    """The table of addresses, filled as they appear.

    used: every address that the program names, so that a free place is none of theirs.
    """

    def __init__(self, source: Dialect, target: Dialect, used: Iterable[str]) -> None:
        self.source, self.target = source, target
        self.table: dict[str, str] = {}
        self.uses = {area: use for use, area in source.counterparts.items()}
        self.words = [one for word in used if isinstance(one := source.address(word), Address)]
        self.taken: set[str] = set()
        for one in self.words:
            if source.block(one):
                continue
            found = self.straight(one) if one.size == 1 else self.straight_word(one)
            self.taken |= {bit.text for bit in target.bits_of(found)} | {found.text} if found else set()

    def area(self, use: Use) -> Area | None:
        """Give the area that the target has for a use."""
        prefix = self.target.counterparts.get(use)
        return next((area for area in self.target.areas if area.prefix == prefix), None)

    def straight(self, bit: Address) -> Address | None:
        """Give the bit with the same number in the area for the same use, if it is there and is no system bit."""
        use = self.uses.get(bit.area)
        area = self.area(use) if use and not bit.field else None
        if area is None or area.size != 1 or not area.holds(bit.index):
            return None
        found = area.address(bit.index)
        return None if found.text in self.target.specials else found

    def straight_word(self, word: Address) -> Address | None:
        """Give the word with the same number among the words, if it begins where one begins there."""
        alike = next(
            (area for area in self.target.areas if area.prefix == word.area and area.words and word.size > 1), None
        )
        if alike and self.source.area(word).per == alike.per and not word.field:
            found = self.target.address(word.text)
            return found if isinstance(found, Address) else None
        area = self.area("word")
        if word.area != self.source.counterparts.get("word") or area is None or word.field or word.size % WORD:
            return None
        own = self.source.area(word)
        number, odd = divmod(word.index, WORD) if own.words else (word.index, 0)
        return None if odd else self._word(area, number, word.size)

    def _word(self, area: Area, number: int, size: int) -> Address | None:
        if area.words:
            letter = next((one for one, width in area.words.items() if width == size), "")
            found = area.read(f"{letter}{number * 2}") if letter else None
        else:
            found = area.address(number) if area.holds(number) and size == area.size else None
            wide = size > area.size and area.holds(number + size // area.size - 1) and not area.digits
            found = Address(area.prefix, number, area.address(number).text, size) if wide else found
        return found if isinstance(found, Address) else None

    def keep(self, word: str, found: str) -> str:
        """Enter a pair in the table."""
        self.table.setdefault(word, found)
        return self.table[word]

    # bits

    def bit(self, word: str) -> tuple[str, bool]:
        """Give the bit that takes the place of another, and whether it is its inverse; NotRepresentableError if none does."""
        meaning = self.source.specials.get(word)
        if meaning:
            return self.special(word, meaning)
        place = self.source.address(word)
        if not isinstance(place, Address) or place.size != 1:
            none(f"{word}不是一个位", f"{word} is no bit")
        if word in self.table:
            return self.table[word], False
        if self.source.block(place) or self.source.area(place).digits:
            none(f"{word}没有对应的位", f"there is no bit for {word}")
        if any(word == flag for flag in self.source.flags.values()):
            none(f"{word}是运算的标志位，各系列不同", f"{word} is a flag of the arithmetic, and those differ")
        straight = self.straight(place)
        if straight is None and self.source.area(place).role != "memory":
            none(
                f"{self.target.title.zh}没有{word}这么多的输入输出",
                f"{self.target.title.en} has no such input or output as {word}",
            )
        return self.keep(word, straight.text if straight else self.fresh()), False

    def special(self, word: str, meaning: str) -> tuple[str, bool]:
        """Give the system bit with the same meaning, or the inverse of the one with the opposite meaning."""
        meaning = {"cold": "first"}.get(meaning, meaning) if meaning not in self.target.specials.values() else meaning
        found, inverse = self.meant(meaning)
        if not found:
            none(f"没有和{word}意义相同的系统位", f"there is no system bit that means what {word} means")
        self.keep(word, f"/{found}" if inverse else found)
        return found, inverse

    def known(self, meaning: str) -> tuple[str, bool]:
        """Give the target's own bit of a meaning ("on", "first"), and whether it is the inverse."""
        found, inverse = self.meant(meaning)
        return (found, inverse) if found else none("没有这样的系统位", "there is no such system bit")

    def meant(self, meaning: str) -> tuple[str, bool]:
        """Give the target's bit of a meaning, else that of the opposite and True; "" where it has neither."""
        found = self.target.special(meaning)
        return (found, False) if found else (self.target.special(_OPPOSITE.get(meaning, "")), True)

    def fresh(self) -> str:
        """Give a bit of memory that nothing else uses."""
        area = self.area("memory")
        index = 0
        while area and area.holds(index):
            text = area.address(index).text
            if text not in self.taken:
                self.taken.add(text)
                return text
            index += 1
        none("没有空闲的内部位了", "no memory bit is free")

    # words

    def word(self, place: Address) -> str:
        """Give the word that takes the place of another; NotRepresentableError where its bits or bytes are used otherwise."""
        if place.text in self.table:
            return self.table[place.text]
        if self.source.block(place):
            return self.value(place)
        mine = set(self.source.bits_of(place))
        shared = next((one for one in self.words if one != place and mine & set(self.source.bits_of(one))), None)
        straight = self.straight_word(place)
        if shared and not (straight and straight.area == place.area):
            none(
                f"{place.text}和{shared.text}有共同的位，对面没有同样的安排",
                f"{place.text} shares bits with {shared.text}, and there is no such arrangement there",
            )
        if not straight and (self.source.area(place).role != "memory" or place.size % WORD):
            none(f"{place.text}没有对应的字", f"there is no word for {place.text}")
        return self.keep(place.text, straight.text if straight else self.fresh_word(place.size))

    def fresh_word(self, size: int) -> str:
        """Give a word that nothing else uses."""
        area, number = self.area("word"), 0
        while area:
            found = self._word(area, number, size)
            if found is None:
                break
            names = {bit.text for bit in self.target.bits_of(found)} | {found.text}
            if not names & self.taken:
                self.taken |= names
                return found.text
            number += size // WORD
        none("没有空闲的字了", "no word is free")

    def value(self, place: Address) -> str:
        """Give the current value of the timer or counter that took another's place."""
        whole = self.source.area(place).address(place.index).text
        if place.field not in {"", "V"} or whole not in self.table:
            none(f"{place.text}没有对应的字", f"there is no word for {place.text}")
        found = self.target.address(self.table[whole])
        if not isinstance(found, Address):
            none(f"{place.text}没有对应的字", f"there is no word for {place.text}")
        area = self.target.area(found)
        return self.keep(place.text, found.text if area.value else f"{found.text}.V")

    # timers and counters

    def number(self, use: Use, word: str, banks: Iterable[Bank]) -> str:
        """Give the first free number in some banks of the target's timers or counters."""
        if word in self.table:
            return self.table[word]
        area, some = self.area(use), list(banks)
        free = [
            area.address(index).text
            for bank in some
            for index in range(bank.first, bank.last + 1)
            if area and area.holds(index) and area.address(index).text not in self.taken
        ]
        if free:
            text = self.same_number(use, word, free)
            self.taken.add(text)
            return self.keep(word, text)
        none(f"没有空闲的号给{word}了", f"no number is free for {word}")

    def same_number(self, use: Use, word: str, free: list[str]) -> str:
        """Give the same number where it means the same on both sides, else the first free one."""
        mine, area = self.source.address(word), self.area(use)
        if not isinstance(mine, Address) or area is None:
            return free[0]
        kept = area.address(mine.index).text
        theirs = self.target.block(area.address(0))
        block = self.source.block(mine)
        alike = use == "counter" or (block is not None and theirs is not None and block.banks == theirs.banks)
        return kept if alike and kept in free else free[0]

    def output(self, word: str) -> str:
        """Give the bit by which a timer or counter of the target is read."""
        place = self.target.address(word)
        block = self.target.block(place) if isinstance(place, Address) else None
        field = "" if block is None else block.bit or ("D" if "D" in block.outputs else "")
        return f"{word}.{field}" if field else word
