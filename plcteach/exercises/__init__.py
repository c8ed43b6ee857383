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
    unknown = set(table) - _KEYS
    missing = {"dialect", "title", "task", "reference"} - set(table)
    if unknown or missing:
        msg = f"exercise {name}: unknown {sorted(unknown)}, missing {sorted(missing)}"
        raise DeclarationError(msg)
    try:
        return _made(table, name)
    except (KeyError, TypeError, ValueError, AttributeError) as trouble:
        msg = f"exercise {name}: {type(trouble).__name__} {trouble}: is something missing or of another kind?"
        raise DeclarationError(msg) from None


def _made(table: dict[str, Any], name: str) -> Exercise:
    for sample in table.get("wrong", ()):
        if sample["expect"] != "different" and sample["expect"] not in RULES:
            msg = f"expect is 'different' or the code of a diagnostic, not {sample['expect']!r}"
            raise ValueError(msg)
    return Exercise(
        id=name,
        dialect=table["dialect"],
        title=_text(table["title"]),
        task=_text(table["task"]),
        reference=table["reference"],
        start=table.get("start", ""),
        hints=tuple(_text(hint) for hint in table.get("hints", ())),
        right=tuple(sample["program"] for sample in table.get("right", ())),
        wrong=tuple(
            WrongSample(sample["program"], sample["expect"], _text(sample.get("because", {})))
            for sample in table.get("wrong", ())
        ),
        points=float(table.get("points", 4)),
        order=int(table.get("order", 0)),
    )


_KEYS = {"dialect", "title", "task", "reference", "start", "hints", "right", "wrong", "points", "order"}


def _text(pair: dict[str, Any]) -> Text:
    return Text(str(pair["zh"]), str(pair["en"])) if pair else NOTHING
