"""Reads the operands of one instruction: bits, words, numbers, whole blocks, two words compared; says what it expected."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from plcteach.core.area import Address, Area
from plcteach.core.diagnostic import rule
from plcteach.core.program import Arg, Compare, Source, Value
from plcteach.core.source import Span
from plcteach.core.text import NOTHING, Text, same

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.core.area import Kind
    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.insn import Insn, Operand
    from plcteach.core.spec import Dialect
    from plcteach.stl.words import Word

_NUMBER = re.compile(r"[+-]?\d{1,9}")
_REAL = re.compile(r"[+-]?\d{1,20}\.\d{1,20}(?:[Ee][+-]?\d{1,3})?")
_NAME = re.compile(r'"[^"]+"|[^\W\d]{3,}\w*|\w*[^\x00-\x7f]\w*')
_SYMBOL = Text("如果它是符号名，还需要符号表。", "If it is a symbol, its table is wanted too.")
_OCTAL = 8
_HEX = 16
_LONGEST_ADDRESS = 16
_LONGEST_NUMBER = 40
_EVEN = Text("这里的字只从偶数号开始。", "Words begin at even numbers here. ")


class Operands:
    """Reads operands for one family; `find` looks a word up in the symbol table, if there is one."""

    def __init__(
        self, dialect: Dialect, found: list[Diagnostic], find: Callable[[str], str | None] | None = None
    ) -> None:
        self.dialect = dialect
        self.found = found
        self.find = find
        self.symbols: dict[str, str] = {}
        self.settings: dict[str, dict[str, int | str | tuple[str, ...]]] = {}
        self.brackets: Callable[[Operands, Insn, Operand, Word], Arg | None] | None = None

    def say(self, code: str, span: Span, **values: object) -> None:
        """Report one finding."""
        self.found.append(rule(code).at(span, family=self.dialect.title, **values))

    def args(self, insn: Insn, first: Word, words: list[Word], span: Span) -> tuple[Arg, ...] | None:
        """Read the operands of an instruction; None where one of them could not be read, which has been said."""
        args: list[Arg] = []
        at = 0
        for operand in insn.operands:
            wants = 2 if operand.relation else 1
            if at + wants > len(words):
                if not operand.optional:
                    self.say("RDR003", span, word=insn.word, expected=self.expected(operand))
                    return None
                break
            arg = self.arg(insn, self.suited(insn, operand, args), words[at : at + wants])
            if arg is None:
                return None
            args.append(arg)
            at += wants
        if words[at:]:
            here = [word for word in words[at:] if word.span.row == words[at].span.row]
            rest = Span(here[0].span.row, here[0].span.start, here[-1].span.stop)
            self.say("RDR004", rest, word=first.shown.upper(), rest=words[at].shown)
            return None
        return tuple(args)

    def arg(self, insn: Insn, operand: Operand, words: list[Word]) -> Arg | None:
        """Read one operand."""
        if operand.number:
            return self.number(insn, operand, words[0])
        if operand.relation:
            return self.compared(insn, operand, words)
        kind = self.dialect.kinds[operand.kind]
        if self.brackets and (operand.kind == "assign" or (kind.compare and words[0].text.startswith("["))):
            return self.brackets(self, insn, operand, words[0])
        if kind.size == 1:
            return self.bit(insn, operand, words[0])
        return self.word(insn, operand, words[0], kind)

    def suited(self, insn: Insn, operand: Operand, args: list[Arg]) -> Operand:
        """Give the operand as the block before it wants it: the preset of a 32-bit counter has 32 bits."""
        is_preset = any(verb.name == "drive" and operand.name in verb.sources for verb in insn.then)
        if not is_preset or not args or not isinstance(args[0], Address):
            return operand
        wide = f"{operand.kind}{self.dialect.bank(args[0]).size}"
        return replace(operand, kind=wide) if wide in self.dialect.kinds else operand

    def expected(self, operand: Operand) -> Text:
        """Say what stands for an operand."""
        if operand.number and operand.mark:
            return same(f"{operand.mark}{operand.first}…{operand.mark}{operand.last}")
        if operand.number:
            return Text(f"{operand.first}到{operand.last}之间的数", f"a number from {operand.first} to {operand.last}")
        return self.dialect.kinds[operand.kind].title

    def number(self, insn: Insn, operand: Operand, word: Word) -> int | None:
        """Read a plain number between two others, with the letters that belong before it."""
        text = word.text.upper()
        digits = text.removeprefix(operand.mark).removeprefix("_") if operand.mark else text
        marked = not operand.mark or text.startswith(operand.mark) or digits.isdigit()
        if not marked or not _NUMBER.fullmatch(digits) or not operand.first <= int(digits) <= operand.last:
            values = {"name": same(operand.name), "number": word.shown}
            ends = {"first": f"{operand.mark}{operand.first}", "last": f"{operand.mark}{operand.last}"}
            self.say("RDR008", word.span, word=insn.word, **values, **ends)
            return None
        return int(digits)

    def place(self, word: Word) -> Address | Area | None:
        """Look a word up as an address, then as a symbol."""
        found = self.dialect.address(word.text)
        if found is None and self.find:
            address = self.find(word.text)
            found = self.dialect.address(address) if address else None
            if isinstance(found, Address):
                self.symbols[found.text] = word.text.strip('"')
        return found

    def bit(self, insn: Insn, operand: Operand, word: Word) -> Address | None:
        """Read the address of a bit."""
        found = self.place(word)
        kind = self.dialect.kinds[operand.kind]
        if isinstance(found, Address) and f"{insn.word} {found.area}" in self.dialect.recognised:
            self.say("RDR002", word.span, word=f"{insn.word} {found.text}")
        elif isinstance(found, Address) and found.size != 1 and not self.takes_words(insn, operand, found):
            self.say("RDR019", word.span, word=insn.word, address=found.text, expected=self.expected(operand))
        elif isinstance(found, Address) and found.area in kind.areas:
            if insn.then and self.dialect.area(found).role == "input" and operand.name in {"out", "m"}:
                self.say("RDR012", word.span, word=insn.word, address=found.text)
            return found
        elif isinstance(found, Address):
            self.say("RDR007", word.span, word=insn.word, address=found.text, expected=self.expected(operand))
        else:
            self.nowhere(operand, word, found)
        return None

    def takes_words(self, insn: Insn, operand: Operand, address: Address) -> bool:
        """Say whether an instruction that takes bits takes this word as well, as a reset takes D0 (but no %MW0, which has bits)."""
        area = self.dialect.area(address)
        plain = address.size == area.size and not area.digits
        return (
            plain
            and address.area in self.dialect.kinds[operand.kind].areas
            and any(verb.name == "reset" for verb in insn.then)
        )

    def nowhere(self, operand: Operand, word: Word, found: Area | None) -> None:
        """Say that a word is no address, or one outside its area."""
        if found is None:
            near = self.near_address(word.text)
            self.say("RDR005", word.span, word=word.shown, expected=self.expected(operand), near=near)
        else:
            note = self.dialect.note_octal if found.base == _OCTAL else _EVEN if found.even else NOTHING
            ends = {"first": found.first, "last": found.last}
            self.say("RDR006", word.span, word=word.shown, area=found.title, **ends, note=note)

    def word(self, insn: Insn, operand: Operand, word: Word, kind: Kind) -> Source | None:
        """Read a word, a whole block, or a number where the kind takes one."""
        if kind.constant:
            value = self.constant(word.text, kind)
            if value is not None:
                if self.fits(value, kind):
                    return value
                low, high = limits(kind)
                values = {"name": same(operand.name), "number": word.shown, "first": low, "last": high}
                self.say("RDR008", word.span, word=insn.word, **values)
                return None
        found = self.place(word)
        if isinstance(found, Address):
            wide = self.widened(found, kind)
            if wide is not None and not kind.size and self.without_timing(found):
                self.say("RDR002", word.span, word=f"{insn.word} {found.text}")
                return None
            if wide is not None:
                return wide
            self.say("RDR007", word.span, word=insn.word, address=found.text, expected=self.expected(operand))
        else:
            self.nowhere(operand, word, found)
        return None

    def without_timing(self, found: Address) -> bool:
        """Say whether a block's number lies in no bank of its area, as a high-speed counter's does."""
        block = self.dialect.block(found)
        banks = block.banks if block else ()
        return bool(banks) and not any(bank.first <= found.index <= bank.last for bank in banks)

    def widened(self, found: Address, kind: Kind) -> Address | None:
        """Give an address with the width that a kind wants; None where it lies elsewhere or has another width."""
        area = self.dialect.area(found)
        if found.area not in kind.areas:
            return None
        if kind.size == 0:
            return found if found.size == 0 or (found.size == 1 and area.value and not found.field) else None
        if found.size == 1 and area.value and not found.field:
            size = self.dialect.bank(found).size
            return Address(found.area, found.index, found.text, size) if size == kind.size else None
        if found.size in {0, 1} or (found.size > kind.size and area.size != found.size):
            return None
        if found.size == area.size and not found.field and kind.size > found.size:
            return Address(found.area, found.index, found.text, kind.size)
        return None if area.words and found.size != kind.size and not found.field else found

    def constant(self, text: str, kind: Kind) -> Value | None:
        """Read a number in any of the family's spellings (16#0F, K10, 3.14)."""
        upper = text.upper()
        if len(upper) > _LONGEST_NUMBER:
            return None
        if kind.real and _REAL.fullmatch(upper):
            number = float(upper)
            return Value(number, repr(number))
        for prefix, base in sorted(self.dialect.constant.items(), key=lambda one: -len(one[0])):
            digits = upper[len(prefix) :]
            sign = digits[:1] if digits[:1] in {"+", "-"} else ""
            if upper.startswith(prefix) and _digits(digits[len(sign) :], base):
                number = int(digits[len(sign) :], base) * (-1 if sign == "-" else 1)
                shown = f"{number:X}" if base == _HEX else f"{number:b}" if base == 2 else f"{number}"  # noqa: PLR2004
                return Value(number, prefix + shown)
        return None

    def fits(self, value: Value, kind: Kind) -> bool:
        """Say whether a number has room in a kind of word."""
        low, high = limits(kind)
        if kind.ends:
            return low <= value.number <= high
        bits = (value.text[:1].isalpha() and not value.text.startswith("K")) or "#" in value.text
        return kind.real or low <= value.number <= high or (bits and 0 <= value.number < 1 << kind.size)

    def compared(self, insn: Insn, operand: Operand, words: list[Word]) -> Compare | None:
        """Read two words with a relation between them."""
        kind = self.dialect.kinds[operand.kind]
        left, right = (self.word(insn, operand, word, kind) for word in words)
        if left is None or right is None:
            return None
        text = self.dialect.separator.join((left.text, right.text))
        return Compare(left, operand.relation, right, operand.kind, text)

    def near_address(self, word: str) -> Text:
        """Suggest an address for IO.0 (a letter O), I00 (no dot) or Q0,1."""
        if len(word) > _LONGEST_ADDRESS:
            return NOTHING
        digits = word.upper()
        tries = [
            digits[:1] + digits[1:].replace("O", "0").replace("L", "1"),
            f"{digits[:-1]}.{digits[-1:]}",
            f"%{digits}",
        ]
        if digits.startswith("%"):
            tries.append(digits[1:])
        near = tuple(one for one in tries if isinstance(self.dialect.address(one), Address))[:1]
        return did_you_mean(near) if near or not _NAME.fullmatch(word) else _SYMBOL


def limits(kind: Kind) -> tuple[int, int]:
    """Give the smallest and the largest number that a kind of word holds."""
    if kind.ends:
        return kind.ends
    if not kind.signed:
        return 0, (1 << kind.size) - 1
    return -(1 << (kind.size - 1)), (1 << (kind.size - 1)) - 1


def _digits(text: str, base: int) -> bool:
    return bool(text) and text.isascii() and text.isalnum() and all(int(sign, 36) < base for sign in text)


def did_you_mean(near: tuple[str, ...]) -> Text:
    """Ask whether one of some words was meant; nothing, where there is none."""
    if not near:
        return NOTHING
    return Text(f"是不是{'或'.join(near)}？", f"Did you mean {' or '.join(near)}? ")
