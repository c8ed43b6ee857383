"""The tasks that come with plcteach, one TOML file each (public, references included), and the loader for a teacher's own."""

from __future__ import annotations

import os
import re
import tomllib
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_args

from plcteach.core.diagnostic import RULES
from plcteach.core.errors import DeclarationError, UnknownNameError, nearest
from plcteach.core.exercise import KINDS, Exercise, Need, NeedKind, Terms, WrongSample
from plcteach.core.text import NOTHING, Text, language

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


def exercise(name: str | Path | Exercise) -> Exercise:
    """Give an exercise by its id; UnknownNameError suggests the nearest.

    It is a bundled one, a question of the concept test, one of a teacher's own in a folder that PLCTEACH_EXERCISES names, or a
    file: a path, or a word that ends in .toml.
    """
    if isinstance(name, Exercise):
        return name
    if isinstance(name, os.PathLike) or str(name).endswith(".toml"):
        return load(name)
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
        msg = _of(place.stem, _NO_UTF8)
    except (OSError, ValueError):
        there = place.exists() if "\0" not in str(place) else False
        msg = (_NOT_OPEN if there else _NO_FILE).format(path=str(place)[:200]).in_(language())
    raise DeclarationError(msg)


_NO_UTF8 = Text("这个文件不是UTF-8", "the file is not UTF-8")
_NO_FILE = Text("没有文件{path}", "there is no file {path}")
_NOT_OPEN = Text("{path}打不开，或者不是文件", "{path} cannot be opened, or is no file")


def _of(name: str, words: Text) -> str:
    """Say what is wrong with an exercise in the language in force."""
    return Text(f"练习{name}：{words.zh}", f"exercise {name}: {words.en}").in_(language())


def parse(toml: str, name: str) -> Exercise:
    """Read an exercise from TOML text; `name` becomes its id. DeclarationError names what is missing or unknown."""
    try:
        table = tomllib.loads(toml)
    except tomllib.TOMLDecodeError as trouble:
        raise DeclarationError(_of(name, _NO_TOML.format(why=str(trouble)))) from None
    missing = {"dialect", "title", "task"} - set(table)
    missing |= set() if {"reference", "given"} & set(table) else {"reference"}
    wrong = [*map(_stray, set(table) - _KNOWN), *(_MISSING.format(field=field) for field in missing)]
    if wrong:
        said = sorted(wrong, key=lambda one: one.en)
        raise DeclarationError(_of(name, Text("；".join(one.zh for one in said), "; ".join(one.en for one in said))))
    terms = Terms(**_made(table, _TERMS, name))
    fields = _made(table, _FIELDS, name)
    fields["needs"] = fields.pop("need", ())
    return Exercise(**{"id": name, "reference": fields.get("given", ""), "terms": terms, **fields})


_NO_TOML = Text("不是TOML（{why}）", "it is no TOML ({why})")
_MISSING = Text("缺少{field}", "{field} is missing")


def _stray(field: str) -> Text:
    """Say that there is no such field, and which one may be meant."""
    near = nearest(field, _KNOWN, 1)
    meant = Text(f"，是不是{near[0]}？", f", did you mean {near[0]}?") if near else NOTHING
    return Text(f"没有{field[:40]}这一项{meant.zh}", f"there is no field {field[:40]}{meant.en}")


class _UnfitError(ValueError):
    """What is wrong with a field, in two languages."""

    def __init__(self, words: Text) -> None:
        super().__init__(words.en)
        self.words = words


def _made(table: Mapping[str, Any], makers: Mapping[str, Callable[[Any], Any]], name: str) -> dict[str, Any]:
    """Give those of some fields that a table has; DeclarationError names the one that does not read."""
    fields = {}
    for key, make in makers.items():
        if key in table:
            try:
                fields[key] = make(table[key])
            except (KeyError, TypeError, ValueError, AttributeError) as trouble:
                raise DeclarationError(_of(name, _put(key, _why(trouble)))) from None
    return fields


def _put(key: str, why: Text) -> Text:
    return Text(f"{key}：{why.zh}", f"{key}: {why.en}")


def _why(trouble: Exception) -> Text:
    """Say why a field does not read."""
    if isinstance(trouble, _UnfitError):
        return trouble.words
    if isinstance(trouble, KeyError):
        return _MISSING.format(field=str(trouble.args[0]))
    return Text("这一项读不出来，形式不对", "it does not read, for it has another form than it should")


def _text(pair: dict[str, Any]) -> Text:
    if not isinstance(pair, dict):
        raise _UnfitError(Text('应写成{ zh = "…", en = "…" }', 'it is written { zh = "…", en = "…" }'))
    return Text(str(pair["zh"]), str(pair["en"]))


def _whole(value: Any) -> int:
    if not isinstance(value, int) or isinstance(value, bool):
        raise _UnfitError(Text(f"应是整数，而不是{value!r}", f"it is a whole number, and not {value!r}"))
    return value


def _points(value: Any) -> float:
    if not isinstance(value, int | float) or isinstance(value, bool) or not 0 < value < _MOST_POINTS:
        raise _UnfitError(Text(f"必须大于0，而不是{value!r}", f"it must be a number above 0, and not {value!r}"))
    return float(value)


_MOST_POINTS = 1_000_000


def _one_of(*words: str) -> Callable[[str], str]:
    def chosen(word: str) -> str:
        if word not in words:
            raise _UnfitError(
                Text(
                    f"只能是{'、'.join(words)}之一，而不是{word!r}",
                    f"it is one of {', '.join(words)}, and not {word!r}",
                )
            )
        return word

    return chosen


def _hints(pairs: list[dict[str, Any]]) -> tuple[Text, ...]:
    return tuple(_text(pair) for pair in pairs)


def _words(rows: Sequence[Any]) -> tuple[str, ...]:
    if isinstance(rows, str):
        raise _UnfitError(Text('应是一组文字：["…", "…"]', 'it is a list of texts: ["…", "…"]'))
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
        known = ", ".join(_VERDICTS)
        raise _UnfitError(
            Text(
                f"expect应是{known}之一，或者一个诊断编号，而不是{expect!r}",
                f"expect is one of {known} or the code of a diagnostic, and not {expect!r}",
            )
        )
    because = _text(sample["because"]) if "because" in sample else NOTHING
    return WrongSample(_answer(sample), expect, because, int(sample.get("misconception", 0)))


_VERDICTS = ("different", "unsettled", "unknown", "equal")
"""What a wrong sample may be promised beside a diagnostic; "equal": it does the right thing, but a need is not met."""
_NEEDS = get_args(NeedKind)


def _need(row: dict[str, Any]) -> Need:
    what = next((one for one in _NEEDS if one in row), "")
    unknown = set(row) - {what, "rung", "says"}
    if not what or unknown:
        known, given = ", ".join(_NEEDS), ", ".join(sorted(row))
        raise _UnfitError(
            Text(
                f"一个要求是{known}之一，可以加rung和says，而不是{given}",
                f"a need is one of {known}, with rung and says, and not {given}",
            )
        )
    says = _text(row["says"]) if "says" in row else NOTHING
    return Need(what, str(row[what]), str(row.get("rung", "")), says)  # type: ignore[arg-type]


def _needs(rows: list[dict[str, Any]]) -> tuple[Need, ...]:
    return tuple(map(_need, rows))


def _weights(table: dict[str, Any]) -> dict[str, float]:
    unknown = set(table) - {"outputs", "steps", "style", "needs"}
    if unknown or not table or min(map(float, table.values())) < 0 or not sum(map(float, table.values())):
        raise _UnfitError(
            Text(
                "应是outputs、steps、style和needs各占的份额，不能是负数",
                "they are shares of outputs, steps, style and needs",
            )
        )
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
    "order": _whole,
    "dialect": str,
    "points": _points,
    "title": _text,
    "task": _text,
    "reference": str,
    "start": str,
    "given": str,
    "source": str,
    "lesson": _whole,
    "after": _words,
    "misconceptions": lambda rows: tuple(map(int, rows)),
    "weights": _weights,
    "need": _needs,
    "scans": _scans,
    "levels": _whole,
    "row": _whole,
    "choices": _words,
    "distractors": _words,
    "hidden": bool,
    "hints": _hints,
    "right": _right,
    "wrong": _wrong,
}

_KNOWN = frozenset(_FIELDS) | frozenset(_TERMS)
