"""What a hint claims, held against its exercise: the counts, the instructions and the addresses that it names, in both languages.

A claim that can be refuted is a lie, and fails; one that no sample bears out is a suspicion, and is only noted.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache
from itertools import chain
from typing import TYPE_CHECKING, Literal

from plcteach.core.area import Address
from plcteach.core.program import Value
from plcteach.core.text import Text
from plcteach.dialects import dialect
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.exercise import Exercise
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect

State = Literal["proved", "failed", "note"]
Claim = tuple[State, Text]
Code = tuple[str, str]
"""An instruction word and the address behind it, either of which may be missing."""

_FEW, _MOST_SPAN = 2, 256
_ADDRESS = re.compile(r"(?<![A-Za-z0-9_.%])%?[A-Z]{1,4}\d+(?:\.[A-Z0-9_]+)?(?![A-Za-z0-9_])", re.ASCII)
_ENDS = re.compile(r"[。；！\n]|(?<=[？?])|[.;!](?=\s|$)")
_WARNS = re.compile(
    r"\b(?:[Nn](?:ot|ever|o|one|or|either|othing)|(?:[Dd]o|[Dd]oes|[Ii]s) NOT|[Ww]ithout|[Ii]nstead|[Rr]ather|[Aa]void|[Uu]nlike"
    r"|[Ww]rong|[Ff]orget|[Cc]annot|would)\b|n't\b|[不别勿没无非错免]"
)
"""NOT alone is an instruction."""
_ASKS = re.compile(r"[?？]|\b(?:e\.g\.|for example|such as)|例如|比如", re.IGNORECASE)
_CLAUSES = re.compile(r"，|,\s")
_RANGE_TO = re.compile(r"(?:\bto|\bthrough|[到至–—~～-])\s*$")
_RANGE_FROM = re.compile(r"%?[A-Z]+[\d.]+\s*(?:to\b|through\b|[到至–—~～-])\s*%?[A-Z]")
_ENGLISH = {"AND", "OR", "NOT"}
"""Words of a list that a sentence in English stresses, too."""
_TELLS = re.compile(r"(?:\b(?:use|write|add|insert|take|put)\s+(?:an?\s+|the\s+)?|[用写])$", re.IGNORECASE)

_ENGLISH_NUMBERS = ("one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
_NUMBERS = {word: number for number, word in enumerate(_ENGLISH_NUMBERS, 1)}
_NUMBERS |= {word: number for number, word in enumerate("一二三四五六七八九十", 1)} | {"两": 2}
_NUMBER = rf"(\d+|{'|'.join(_NUMBERS)})"
_COUNTS = tuple(
    re.compile(one, re.IGNORECASE)
    for one in (
        rf"(?:answer|list|program|ladder) (?:has|needs|takes|wants|consists of) (?:only |just )?{_NUMBER} (?:instruction|line)s?\b",
        rf"(?:答案|语句表|指令表|程序|梯形图)(?:里|中)?(?:只|有|要|需要|一共|共)+{_NUMBER}(?:条|行)(?!支路)",
    )
)
_ENOUGH = tuple(
    re.compile(one, re.IGNORECASE)
    for one in (
        rf"(?:^|[.:;?] ){_NUMBER} (?:instruction|line)s? (?:will do|are enough|is enough|suffices?)",
        rf"(?:^|[。：；？]){_NUMBER}(?:条|行)(?:指令)?(?:就够|就行|足够|即可)",
    )
)


@dataclass(frozen=True, slots=True)
class Known:
    """What an exercise holds: how long its right lists are, its instruction words, its addresses, its lines."""

    lengths: frozenset[int]
    words: frozenset[str]
    places: frozenset[str]
    lines: frozenset[Code]


def claims(exercise: Exercise, right: list[Program]) -> Iterator[Claim]:
    """Say of each hint whether it is true, as far as can be told; `right`: the right answers, where answers are lists."""
    known = _known(exercise, right)
    for hint in exercise.hints:
        found = [*_counted(hint, known), *_named(hint, exercise, known), *_parted(hint, exercise)]
        yield min(found, key=lambda one: ("failed", "note").index(one[0]), default=("proved", Text("", "")))


# what a hint counts


def _counted(hint: Text, known: Known) -> Iterator[Claim]:
    for said in (hint.zh, hint.en) if known.lengths else ():
        for pattern in _COUNTS:
            for claim in pattern.findall(said):
                if _number(claim) not in known.lengths:
                    yield "failed", Text(f"“{claim}”和标准答案不符", f"{claim!r} is not what the model answer has")
        for pattern in _ENOUGH:
            for claim in pattern.findall(said):
                if _number(claim) < min(known.lengths):
                    yield "note", Text(f"“{claim}”条不够", f"{claim!r} is less than any right sample has")


def _number(word: str) -> int:
    return int(word) if word.isdigit() else _NUMBERS[word.lower()]


# what a hint names


def _named(hint: Text, exercise: Exercise, known: Known) -> Iterator[Claim]:
    """Look for instructions and addresses that stand nowhere and are not warned of."""
    family = dialect(exercise.dialect)
    for sentence in chain(_ENDS.split(hint.zh), _ENDS.split(hint.en)):
        soft = bool(_WARNS.search(sentence) or _ASKS.search(sentence))
        for clause in _CLAUSES.split(sentence):
            if not _WARNS.search(clause):
                for state, says in _claimed(clause, family, known):
                    yield "note" if soft else state, says


def _claimed(clause: str, family: Dialect, known: Known) -> Iterator[Claim]:
    for at, (word, place) in codes(clause, family):
        if place and known.places.isdisjoint(_cells(place, family)):
            if not _in_a_range(clause, at):
                yield "failed", Text(f"这个练习里没有{place}", f"{place} occurs nowhere in this exercise")
        elif word and word not in known.words:
            told = _TELLS.search(clause[:at].rstrip())
            yield "failed" if told else "note", Text(f"正确样本里没有{word}", f"no right sample uses {word}")
        elif word and place and known.lines and (word, place) not in known.lines:
            yield "note", Text(f"正确样本里没有{word} {place}", f"no right sample has {word} {place}")


def _in_a_range(clause: str, at: int) -> bool:
    """Say whether an address is an end of a range (T0 to T199), which need not stand anywhere."""
    return bool(_RANGE_TO.search(clause[:at]) or _RANGE_FROM.match(clause[at:]))


def _parted(hint: Text, exercise: Exercise) -> Iterator[Claim]:
    """Hold the two languages of a hint against each other: each may name only what the other names."""
    families = {exercise.dialect, exercise.source or exercise.dialect}
    zh, en = (
        {one for name in families for _, code in codes(said, dialect(name)) for one in code if one} - _ENGLISH
        for said in (hint.zh, hint.en)
    )
    if zh != en:
        mine, yours = (", ".join(sorted(one)) or "–" for one in (zh - en, en - zh))
        state: State = "failed" if zh - en and en - zh else "note"
        says = Text(
            f"只有中文里有：{mine}；只有英文里有：{yours}", f"only in Chinese: {mine}; only in English: {yours}"
        )
        yield state, says


def codes(said: str, family: Dialect) -> Iterator[tuple[int, Code]]:
    """Give the instruction words and addresses that a text names, with where each begins.

    A word of a single letter counts with an address behind it only: `A` begins English sentences, too.
    """
    for found in _words(family).finditer(said):
        behind = _ADDRESS.match(said, found.end() + 1) if said[found.end() : found.end() + 1] == " " else None
        place = _canonical(behind[0], family) if behind else ""
        if place or len(found[0]) >= _FEW:
            yield found.start(), (found[0], place)
    for found in _ADDRESS.finditer(said):
        place = _canonical(found[0], family)
        if place:
            yield found.start(), ("", place)


@lru_cache(maxsize=16)
def _words(family: Dialect) -> re.Pattern[str]:
    """Make the pattern of a family's instruction words: longest first, bounded by what is no ASCII letter or digit."""
    plain = {word.split()[0] for word in family.words if word[0].isalpha()}
    some = "|".join(re.escape(one) for one in sorted(plain, key=lambda one: (-len(one), one)))
    return re.compile(rf"(?<![A-Za-z0-9_.%/])(?:{some})(?![A-Za-z0-9_(]|\.[A-Za-z0-9])")


def _canonical(word: str, family: Dialect) -> str:
    found = family.address(word)
    return found.text if isinstance(found, Address) else ""


def _cells(place: str, family: Dialect) -> set[str]:
    found = family.address(place)
    if not isinstance(found, Address):
        return {place}
    return {place, family.whole(found).text, *(one.text for one in family.bits_of(found))}


# what an exercise holds


def _known(exercise: Exercise, right: list[Program]) -> Known:
    family = dialect(exercise.dialect)
    other = dialect(exercise.source or exercise.dialect)
    seen = [read(text, family) for text in (exercise.start,) if text.strip()]
    seen += [read(text, other) for text in (exercise.given,) if text.strip()]
    shown = (exercise.reference, *exercise.right, exercise.start, exercise.given, *exercise.choices)
    lines = [line for one in (*right, *seen) for line in one.lines]
    words = {word for line in lines for word in (line.insn.mnemonic, line.insn.word, line.insn.word.split()[0])}
    words |= {code[0] for text in shown for one in (family, other) for _, code in codes(text, one)}
    pairs = {(line.insn.word, place.text) for line in lines for place in line.places}
    return Known(
        frozenset(len(one.lines) for one in right),
        frozenset(words),
        frozenset(_places(exercise, [*right, *seen], family)),
        frozenset(pairs),
    )


def _places(exercise: Exercise, programs: list[Program], family: Dialect) -> Iterator[str]:
    """Give every address of an exercise: in its texts, in its terms, and those that a line reaches with a number behind it."""
    terms = exercise.terms
    texts = [
        exercise.reference, exercise.start, exercise.given, exercise.task.zh, exercise.task.en, *exercise.right,
        *exercise.choices, *exercise.distractors, *(one.program for one in exercise.wrong), *terms.outputs, *terms.assume,
        *terms.never, *terms.dont_care, *terms.dont_care.values(), *(name for row in exercise.scans for name in row),
        *(text for one in exercise.needs for text in (one.value, one.rung)),
    ]  # fmt: skip
    for text in texts:
        for _, (_, place) in codes(text, family):
            yield from _cells(place, family) if place else ()
    for line in (line for one in programs if one.dialect == family for line in one.lines):
        numbers = [arg.number if isinstance(arg, Value) else arg for arg in line.args]
        count = max((one for one in numbers if isinstance(one, int)), default=1)
        for address in line.places:
            yield from _cells(address.text, family)
            yield from (one.text for one in family.following(address, min(count, _MOST_SPAN)))
