"""The tasks that come with plcteach, one TOML file each (public, references included), and the loader for a teacher's own."""

from __future__ import annotations

import tomllib
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from plcteach.core.diagnostic import RULES
from plcteach.core.errors import DeclarationError, UnknownNameError
from plcteach.core.exercise import Exercise, WrongSample
from plcteach.core.text import NOTHING, Text

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path


@cache
def _bundled() -> dict[str, Exercise]:
    found = [
        parse(entry.read_text(encoding="utf-8"), entry.name.removesuffix(".toml"))
        for entry in files(__package__).iterdir()
        if entry.name.endswith(".toml")
    ]
    return {one.id: one for one in sorted(found, key=lambda one: (one.order, one.id))}


def ids() -> tuple[str, ...]:
    """Give the ids of all bundled exercises in teaching order."""
    return tuple(_bundled())


def exercise(name: str | Exercise) -> Exercise:
    """Give a bundled exercise by its id; UnknownNameError suggests the nearest."""
    if isinstance(name, Exercise):
        return name
    try:
        return _bundled()[name]
    except KeyError:
        kind = "exercise"
        raise UnknownNameError(kind, name, _bundled()) from None


def load(path: Path) -> Exercise:
    """Read a teacher's own exercise file; DeclarationError names what is missing."""
    return parse(path.read_text(encoding="utf-8"), path.stem)


def parse(toml: str, name: str) -> Exercise:
    """Read an exercise from TOML text; `name` becomes its id. DeclarationError names what is missing or unknown."""
    try:
        table = tomllib.loads(toml)
    except tomllib.TOMLDecodeError as trouble:
        msg = f"exercise {name}: {trouble}"
        raise DeclarationError(msg) from None
    unknown = set(table) - set(_FIELDS)
    missing = {"dialect", "title", "task", "reference"} - set(table)
    if unknown or missing:
        msg = f"exercise {name}: unknown {sorted(unknown)}, missing {sorted(missing)}"
        raise DeclarationError(msg)
    fields: dict[str, Any] = {"id": name}
    for key, make in _FIELDS.items():
        if key in table:
            try:
                fields[key] = make(table[key])
            except (KeyError, TypeError, ValueError, AttributeError) as trouble:
                msg = f"exercise {name}: {key} does not read ({type(trouble).__name__}: {trouble})"
                raise DeclarationError(msg) from None
    return Exercise(**fields)


def _text(pair: dict[str, Any]) -> Text:
    return Text(str(pair["zh"]), str(pair["en"]))


def _level(word: str) -> str:
    if word not in {"exact", "settled", "either"}:
        msg = f"the level is exact, settled or either, not {word!r}"
        raise ValueError(msg)
    return word


def _hints(pairs: list[dict[str, Any]]) -> tuple[Text, ...]:
    return tuple(_text(pair) for pair in pairs)


def _right(samples: list[dict[str, Any]]) -> tuple[str, ...]:
    return tuple(str(sample["program"]) for sample in samples)


def _wrong(samples: list[dict[str, Any]]) -> tuple[WrongSample, ...]:
    return tuple(_wrong_one(sample) for sample in samples)


def _wrong_one(sample: dict[str, Any]) -> WrongSample:
    expect = sample["expect"]
    if expect != "different" and expect not in RULES:
        msg = f"expect is 'different' or the code of a diagnostic, not {expect!r}"
        raise ValueError(msg)
    return WrongSample(str(sample["program"]), expect, _text(sample["because"]) if "because" in sample else NOTHING)


_FIELDS: dict[str, Callable[[Any], Any]] = {
    "order": int,
    "dialect": str,
    "points": float,
    "title": _text,
    "task": _text,
    "reference": str,
    "start": str,
    "level": _level,
    "hints": _hints,
    "right": _right,
    "wrong": _wrong,
}
