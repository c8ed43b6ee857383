"""Every word that a learner reads, in Chinese and English at once, and which of the two is wanted now."""

from __future__ import annotations

import os
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator


@dataclass(frozen=True, slots=True)
class Text:
    """The same sentence in Chinese and in English, each as a good teacher would say it."""

    zh: str
    en: str

    def __repr__(self) -> str:
        return f"Text({self.zh!r}, {self.en!r})"

    def format(self, **values: object) -> Text:
        """Fill the named places of both sentences; a value that is itself a Text gives its own language."""
        return Text(
            self.zh.format(**{name: pick(value, "zh") for name, value in values.items()}),
            self.en.format(**{name: pick(value, "en") for name, value in values.items()}),
        )

    def in_(self, lang: str) -> str:
        """Give the sentence in one language."""
        return self.zh if lang == "zh" else self.en

    def as_dict(self) -> dict[str, str]:
        """Give the pair as the browser and `--json` want it."""
        return {"zh": self.zh, "en": self.en}


NOTHING = Text("", "")


def pick(value: object, lang: str) -> object:
    """Give a Text in the language `lang` and anything else as it is."""
    return value.in_(lang) if isinstance(value, Text) else value


def same(words: str) -> Text:
    """Make a Text of words that read alike in both languages: a mnemonic, an address, a formula."""
    return Text(words, words)


def counted(count: int, zh: str, en: str) -> Text:
    """Say how many there are of something: 3行, 3 rows."""
    return Text(f"{count}{zh}", f"{count} {en}")


def joined(parts: Iterable[Text], zh: str = "", en: str = " ") -> Text:
    """Put several texts after each other, separated as each language wants it."""
    kept = [part for part in parts if part.zh or part.en]
    return Text(zh.join(part.zh for part in kept), en.join(part.en for part in kept))


_chosen: list[str] = []


@contextmanager
def speaking(lang: str | None) -> Iterator[None]:
    """Speak a language for a while (None: the one in force), and then the one before again."""
    before = list(_chosen)
    if lang:
        language(lang)
    try:
        yield
    finally:
        _chosen[:] = before


_ASKED = ("PLCTEACH_LANG", "LC_ALL", "LC_MESSAGES", "LANG")


def language(lang: str | None = None) -> str:
    """Choose the language of everything shown from now on ("zh" or "en"), and give the one in force.

    Without a choice it is the environment's: Chinese where PLCTEACH_LANG, else the locale, begins with "zh", else English.
    """
    if lang is not None:
        if lang not in {"zh", "en"}:
            msg = f"The language is 'zh' or 'en', not {lang[:20]!r}."
            raise ValueError(msg)
        _chosen[:] = [lang]
    if _chosen:
        return _chosen[0]
    wanted = next((os.environ[name] for name in _ASKED if os.environ.get(name)), "")
    return "zh" if wanted.lower().startswith("zh") else "en"
