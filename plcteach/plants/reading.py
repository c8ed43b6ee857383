"""Reads a plant from TOML; a DeclarationError names the row that does not fit, and what was expected there."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from plcteach.core.errors import DeclarationError
from plcteach.core.text import NOTHING, Text
from plcteach.plants.condition import Condition, micro, read_condition
from plcteach.plants.declared import (
    KINDS,
    SHAPES,
    Act,
    Birth,
    Change,
    Cycle,
    Device,
    Drawn,
    Hazard,
    Item,
    Latch,
    Move,
    Part,
    Plant,
    Sample,
    Seen,
    Stop,
)
from plcteach.plants.proving import prove

if TYPE_CHECKING:
    from plcteach.plants.condition import Bound

Row = Mapping[str, Any]
Made = TypeVar("Made")


def parse(toml: str, name: str) -> Plant:
    """Read a plant from TOML text; `name` becomes its id."""
    try:
        table = tomllib.loads(toml)
    except tomllib.TOMLDecodeError as trouble:
        msg = f"plant {name}: {trouble}"
        raise DeclarationError(msg) from None
    plant = _at(f"plant {name}", _plant, {**table, "id": name})
    prove(plant)
    return plant


def _at(where: str, make: Callable[[Row], Made], row: Row) -> Made:
    """Make something of a row; whatever does not fit is reported with the row's name before it."""
    try:
        return make(row)
    except (DeclarationError, KeyError, TypeError, ValueError, AttributeError) as trouble:
        said = str(trouble) if isinstance(trouble, DeclarationError) else f"{type(trouble).__name__}: {trouble}"
        msg = f"{where}: {said}"
        raise DeclarationError(msg) from None


def _keys(row: Row, needed: str, others: str = "") -> None:
    """Refuse a key that is missing, and one that nobody knows."""
    must = set(needed.split())
    unknown, missing = set(row) - must - set(others.split()), must - set(row)
    if unknown or missing:
        msg = f"unknown {sorted(unknown)}, missing {sorted(missing)}"
        raise DeclarationError(msg)


def _rows(table: Row, key: str, make: Callable[[Row], Made]) -> tuple[Made, ...]:
    """Read an array of tables, each by its number and, where it has one, its name."""
    rows: list[Row] = table.get(key, [])
    return tuple(_at(f"{key} {number} {_called(row)}".strip(), make, row) for number, row in enumerate(rows, start=1))


def _called(row: Row) -> str:
    return str(next((row[key] for key in ("symbol", "name", "id", "for", "role") if key in row), ""))


def _plant(row: Row) -> Plant:
    _keys(row, "id title story io cycle program picture", "order part item birth change latch fault draw")
    samples = _rows(row, "program", _sample)
    reference = [one for one in samples if one.role == "reference"]
    if len(reference) != 1:
        msg = f"one program is the reference, and not {len(reference)}"
        raise DeclarationError(msg)
    wide, high = row["picture"]
    return Plant(
        id=row["id"],
        order=int(row.get("order", 0)),
        title=_at("title", _text, row["title"]),
        story=_at("story", _text, row["story"]),
        family=reference[0].family,
        devices=_rows(row, "io", _device),
        parts=_rows(row, "part", _part),
        items=_rows(row, "item", _item),
        births=_rows(row, "birth", _birth),
        changes=_rows(row, "change", _change),
        latches=_rows(row, "latch", _latch),
        hazards=_rows(row, "fault", _hazard),
        samples=samples,
        cycle=_at("cycle", _cycle, row["cycle"]),
        size=(float(wide), float(high)),
        drawn=_rows({"draw": _pieces(row.get("draw", []))}, "draw", _drawn),
    )


def _text(pair: Row) -> Text:
    _keys(pair, "zh en")
    return Text(str(pair["zh"]), str(pair["en"]))


def _one_of(word: Any, known: Iterable[str], what: str) -> Any:
    """Give the word if it is one of those known."""
    if word not in known:
        msg = f"{what} is {', '.join(known)}, and not {word!r}"
        raise DeclarationError(msg)
    return word


def _condition(row: Row, key: str) -> Condition:
    return read_condition(row.get(key, ""))


def _maybe(row: Row, key: str) -> Condition | None:
    return read_condition(row[key]) if key in row else None


def _speed(number: object) -> int:
    """Give a speed in millionths a millisecond from one in units a second."""
    steps = micro(number)
    if steps % 1000:
        msg = f"a speed has at most three decimals, and {number} has more"
        raise DeclarationError(msg)
    return steps // 1000


def _moves(row: Row) -> tuple[Move, ...]:
    for move in row.get("moves", []):
        _keys(move, "speed", "while")
    return tuple(Move(_condition(move, "while"), _speed(move["speed"])) for move in row.get("moves", []))


def _device(row: Row) -> Device:
    _keys(row, "symbol kind what", "at wired way start on")
    kind = _one_of(row["kind"], KINDS, "the kind")
    role = KINDS[kind]
    if (role == "sense") != ("on" in row) or (role != "hand" and "at" not in row):
        msg = "a switch or sensor that the plant moves says when it is `on`, no other does; only a hand may have no address"
        raise DeclarationError(msg)
    return Device(
        symbol=row["symbol"],
        address=row.get("at", ""),
        kind=kind,
        what=_text(row["what"]),
        wired=_one_of(row.get("wired", "NO"), ("NO", "NC"), "wired"),
        way=_one_of(row.get("way", "both"), ("both", "up", "down"), "way"),
        start=bool(row.get("start", False)),
        on=_maybe(row, "on"),
    )


def _part(row: Row) -> Part:
    _keys(row, "name from to", "unit start moves round home notch by")
    least, most = micro(row["from"]), micro(row["to"])
    start = micro(row.get("start", row["from"]))
    if not least <= start <= most or least == most:
        msg = "it starts between `from` and `to`, and `to` is more than `from`"
        raise DeclarationError(msg)
    return Part(
        name=row["name"],
        unit=str(row.get("unit", "")),
        least=least,
        most=most,
        start=start,
        moves=_moves(row),
        round=bool(row.get("round", False)),
        home=_maybe(row, "home"),
        notch=_maybe(row, "notch"),
        by=micro(row.get("by", 1)),
    )


def _item(row: Row) -> Item:
    _keys(row, "name to", "from moves stops gap")
    moves = _moves(row)
    if any(move.speed < 0 for move in moves):
        msg = "workpieces travel forwards only"
        raise DeclarationError(msg)
    for stop in row.get("stops", []):
        _keys(stop, "at unless")
    stops = tuple(Stop(micro(stop["at"]), read_condition(stop["unless"])) for stop in row.get("stops", []))
    return Item(row["name"], micro(row.get("from", 0)), micro(row["to"]), moves, stops, micro(row.get("gap", 0)))


def _birth(row: Row) -> Birth:
    _keys(row, "on items", "if")
    return Birth(read_condition(row["on"]), tuple(str(one) for one in row["items"]), _condition(row, "if"))


def _change(row: Row) -> Change:
    _keys(row, "where into", "while")
    where = read_condition(row["where"])
    if len(where.bounds) != 1 or where.bits:
        msg = f"`where` is one comparison of a workpiece, and not {where.text!r}"
        raise DeclarationError(msg)
    bound: Bound = where.bounds[0]
    return Change(bound.name, bound, _condition(row, "while"), row["into"])


def _latch(row: Row) -> Latch:
    _keys(row, "name set reset")
    return Latch(row["name"], read_condition(row["set"]), read_condition(row["reset"]))


def _hazard(row: Row) -> Hazard:
    _keys(row, "id when says", "lasts")
    return Hazard(row["id"], read_condition(row["when"]), int(row.get("lasts", 0)), _text(row["says"]))


def _cycle(row: Row) -> Cycle:
    _keys(row, "every times acts", "sees")
    acts = tuple(sorted((Act(int(ms), symbol, bool(down)) for ms, symbol, down in row["acts"]), key=lambda one: one.ms))
    seen = tuple(Seen(int(ms), read_condition(what)) for ms, what in row.get("sees", []))
    every = int(row["every"])
    if any(not 0 <= ms < every for ms in (*(one.ms for one in acts), *(one.ms for one in seen))):
        msg = f"a round lasts {every} ms; something in it lies outside"
        raise DeclarationError(msg)
    return Cycle(every, int(row["times"]), acts, seen)


def _sample(row: Row) -> Sample:
    _keys(row, "role family title text", "because fault at wired ways cycle")
    role = _one_of(row["role"], ("reference", "right", "book", "wrong"), "the role")
    fault = str(row.get("fault", ""))
    if (role in {"book", "wrong"}) != bool(fault):
        msg = "a program of the book's or a wrong one names its fault, and no other does"
        raise DeclarationError(msg)
    return Sample(
        role=role,
        family=str(row["family"]),
        text=str(row["text"]),
        title=_text(row["title"]),
        because=_text(row["because"]) if "because" in row else NOTHING,
        fault=fault,
        addresses=row.get("at"),
        wired=row.get("wired"),
        ways=row.get("ways"),
        cycle=_at("cycle", _cycle, row["cycle"]) if "cycle" in row else None,
    )


_COMMON = "kind part x y for on moves turns text"


def _pieces(rows: list[Row]) -> list[Row]:
    """Name every piece of the picture, and let the further pieces of a part move, turn and light up as its first one says."""
    found: list[Row] = []
    first: dict[str, Row] = {}
    for number, row in enumerate(rows):
        name = str(row.get("part", row.get("for", f"d{number}")))
        shared = {key: value for key, value in first.setdefault(name, row).items() if key in {"moves", "turns", "on"}}
        found.append({**shared, **row, "part": name})
    return found


def _drawn(row: Row) -> Drawn:
    needed, others = SHAPES[_one_of(row.get("kind"), SHAPES, "the kind")]
    _keys(row, f"kind part x y {' '.join(needed)}", f"{_COMMON} {' '.join(others)}")
    return Drawn(
        kind=row["kind"],
        part=str(row["part"]),
        x=float(row["x"]),
        y=float(row["y"]),
        symbol=str(row.get("for", "")),
        on=_maybe(row, "on"),
        moves={name: (float(dx), float(dy)) for name, (dx, dy) in row.get("moves", {}).items()},
        turns={name: float(degrees) for name, degrees in row.get("turns", {}).items()},
        text=_text(row["text"]) if "text" in row else NOTHING,
        more={key: row[key] for key in needed | others if key in row and key not in {"for", "text"}},
    )
