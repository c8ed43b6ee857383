"""The tasks that come with plcteach, one TOML file each (public, references included), and the loader for a teacher's own."""

from __future__ import annotations

import os
import re
import tomllib
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plcteach.core.diagnostic import RULES
from plcteach.core.errors import DeclarationError, UnknownNameError
from plcteach.core.exercise import KINDS, Exercise, Need, Terms, WrongSample
from plcteach.core.text import NOTHING, Text

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence


@cache
def _bundled(folder: str = "") -> dict[str, Exercise]:
    here = files(__package__)
    found = [
        parse(entry.read_text(encoding="utf-8"), entry.name.removesuffix(".toml"))
        for entry in (here / folder if folder else here).iterdir()
        if entry.name.endswith(".toml")
    ]
    return {one.id: one for one in sorted(found, key=lambda one: (one.order, one.id))}


def ids() -> tuple[str, ...]:
    """Give the ids of all bundled exercises in teaching order."""
    return tuple(_bundled())


def concept_test() -> tuple[Exercise, ...]:
    """Give the twelve short questions that are asked before a course and after it, each about one usual wrong idea."""
    return tuple(_bundled(_CONCEPT).values())


_CONCEPT = "concept"


def exercise(name: str | Exercise) -> Exercise:
    """Give an exercise by its id; UnknownNameError suggests the nearest.

    It is a bundled one, a question of the concept test, or one of a teacher's own in a folder that PLCTEACH_EXERCISES names.
    """
    if isinstance(name, Exercise):
        return name
    try:
        return _bundled()[name] if name in _bundled() else _bundled(_CONCEPT)[name]
    except KeyError:
        own = _own(name)
    if own is None:
        kind = "exercise"
        raise UnknownNameError(kind, name, _bundled())
    return load(own)


FOLDERS = "PLCTEACH_EXERCISES"
"""The variable of the environment that names a teacher's own folders, parted as in PATH."""


def _own(name: str) -> Path | None:
    """Give the file of an exercise in a teacher's own folders, if it is there."""
    if not _PLAIN.fullmatch(str(name)):
        return None
    places = (Path(one) / f"{name}.toml" for one in os.environ.get(FOLDERS, "").split(os.pathsep) if one)
    return next((place for place in places if place.is_file()), None)


_PLAIN = re.compile(r"[\w-][\w.-]{0,99}")


def folder(path: Path | str) -> tuple[Exercise, ...]:
    """Read a teacher's own folder of exercises, in teaching order; DeclarationError names the file that does not read."""
    found = [load(one) for one in Path(path).iterdir() if one.suffix == ".toml"]
    return tuple(sorted(found, key=lambda one: (one.order, one.id)))


def load(path: Path | str) -> Exercise:
    """Read a teacher's own exercise file; DeclarationError names what is missing.

    The exception is a new one, so that no traceback shows the file's text in its variables.
    """
    place = Path(path)
    try:
        return parse(place.read_text(encoding="utf-8"), place.stem)
    except DeclarationError as trouble:
        msg = str(trouble)
    except UnicodeDecodeError:
        msg = f"exercise {place.stem}: the file is not UTF-8"
    raise DeclarationError(msg)


def parse(toml: str, name: str) -> Exercise:
    """Read an exercise from TOML text; `name` becomes its id. DeclarationError names what is missing or unknown."""
    try:
        table = tomllib.loads(toml)
    except tomllib.TOMLDecodeError as trouble:
        msg = f"exercise {name}: {trouble}"
        raise DeclarationError(msg) from None
    unknown = set(table) - set(_FIELDS) - set(_TERMS)
    missing = {"dialect", "title", "task"} - set(table)
    missing |= set() if {"reference", "given"} & set(table) else {"reference"}
    if unknown or missing:
        msg = f"exercise {name}: unknown {sorted(unknown)}, missing {sorted(missing)}"
        raise DeclarationError(msg)
    terms = Terms(**_made(table, _TERMS, name))
    fields = _made(table, _FIELDS, name)
    fields["needs"] = fields.pop("need", ())
    return Exercise(**{"id": name, "reference": fields.get("given", ""), "terms": terms, **fields})


def _made(table: Mapping[str, Any], makers: Mapping[str, Callable[[Any], Any]], name: str) -> dict[str, Any]:
    """Give those of some fields that a table has; DeclarationError names the one that does not read."""
    fields = {}
    for key, make in makers.items():
        if key in table:
            try:
                fields[key] = make(table[key])
            except (KeyError, TypeError, ValueError, AttributeError) as trouble:
                msg = f"exercise {name}: {key} does not read ({type(trouble).__name__}: {trouble})"
                raise DeclarationError(msg) from None
    return fields


def _text(pair: dict[str, Any]) -> Text:
    return Text(str(pair["zh"]), str(pair["en"]))


def _one_of(*words: str) -> Callable[[str], str]:
    def chosen(word: str) -> str:
        if word not in words:
            msg = f"it is one of {', '.join(words)}, not {word!r}"
            raise ValueError(msg)
        return word

    return chosen


def _hints(pairs: list[dict[str, Any]]) -> tuple[Text, ...]:
    return tuple(_text(pair) for pair in pairs)


def _words(rows: Sequence[Any]) -> tuple[str, ...]:
    if isinstance(rows, str):
        msg = "it is a list of texts"
        raise TypeError(msg)
    return tuple(map(str, rows))


def _answer(sample: dict[str, Any]) -> str:
    return str(sample["answer"] if "answer" in sample else sample["program"])


def _right(samples: list[dict[str, Any]]) -> tuple[str, ...]:
    return tuple(map(_answer, samples))


def _wrong(samples: list[dict[str, Any]]) -> tuple[WrongSample, ...]:
    return tuple(map(_wrong_one, samples))


def _wrong_one(sample: dict[str, Any]) -> WrongSample:
    expect = sample["expect"]
    if expect not in _VERDICTS and expect not in RULES:
        msg = f"expect is one of {', '.join(_VERDICTS)} or the code of a diagnostic, not {expect!r}"
        raise ValueError(msg)
    because = _text(sample["because"]) if "because" in sample else NOTHING
    return WrongSample(_answer(sample), expect, because, int(sample.get("misconception", 0)))


_VERDICTS = ("different", "unsettled", "unknown", "equal")
"""What a wrong sample may be promised beside a diagnostic; "equal": it does the right thing, but a need is not met."""
_NEEDS = ("most", "uses", "avoids", "contact", "edits")


def _need(row: dict[str, Any]) -> Need:
    what = next((one for one in _NEEDS if one in row), "")
    unknown = set(row) - {what, "rung", "says"}
    if not what or unknown:
        msg = f"a need is one of {', '.join(_NEEDS)}, with rung and says, and not {sorted(row)}"
        raise ValueError(msg)
    says = _text(row["says"]) if "says" in row else NOTHING
    return Need(what, str(row[what]), str(row.get("rung", "")), says)  # type: ignore[arg-type]


def _needs(rows: list[dict[str, Any]]) -> tuple[Need, ...]:
    return tuple(map(_need, rows))


def _weights(table: dict[str, Any]) -> dict[str, float]:
    unknown = set(table) - {"outputs", "steps", "style", "needs"}
    if unknown or not table or min(map(float, table.values())) < 0 or not sum(map(float, table.values())):
        msg = f"weights are shares of outputs, steps, style and needs, and not {table}"
        raise ValueError(msg)
    return {key: float(value) for key, value in table.items()}


def _formulas(table: dict[str, Any]) -> dict[str, str]:
    return {str(key): str(value) for key, value in table.items()}


def _scans(rows: list[dict[str, Any]]) -> tuple[dict[str, Any], ...]:
    return tuple(dict(row) for row in rows)


_TERMS: dict[str, Callable[[Any], Any]] = {
    "level": _one_of("exact", "settled", "either"),
    "outputs": _words,
    "assume": _words,
    "single_change": bool,
    "dont_care": _formulas,
    "never": _words,
}

_FIELDS: dict[str, Callable[[Any], Any]] = {
    "kind": _one_of(*KINDS),
    "order": int,
    "dialect": str,
    "points": float,
    "title": _text,
    "task": _text,
    "reference": str,
    "start": str,
    "given": str,
    "source": str,
    "lesson": int,
    "after": _words,
    "misconceptions": lambda rows: tuple(map(int, rows)),
    "weights": _weights,
    "need": _needs,
    "scans": _scans,
    "levels": int,
    "row": int,
    "choices": _words,
    "distractors": _words,
    "hidden": bool,
    "hints": _hints,
    "right": _right,
    "wrong": _wrong,
}
