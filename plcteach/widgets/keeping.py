"""What a learner has done, in a small file beside the notebook: attempts, best marks, hints, and every text as typed.

Several desks and notebooks may use one file at once: each change reads the file, changes its own exercise only, and puts the
whole back in one move. A file that cannot be understood is put aside under another name, one that must not be written is left
as it is, and both are told.
"""

from __future__ import annotations

import json
import os
import time
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

NAME = ".plcteach-progress.json"
ASKED = "PLCTEACH_PROGRESS"
_VERSION = 1
_MOST_EARLIER = 20
_MOST_NUMBER = 1e9
_PATIENCE, _STALE, _NAP = 2.0, 10.0, 0.02

Table = dict[str, Any]

_ASIDE = Text(
    "进度文件{old}读不出来，已改名为{new}保留；现在重新开始记录。",
    "The progress file {old} could not be read. It is kept as {new}, and a new one has begun.",
)
_UNREAD = Text("进度文件{old}读不出来。", "The progress file {old} cannot be read.")
_SHUT = Text(
    "进度文件{old}不能写入（{why}）；你输入的内容保留在这个浏览器里。",
    "The progress file {old} cannot be written ({why}); what you type is kept in this browser.",
)
_LATER = Text(
    "进度文件{old}来自更新版本的plcteach，不作改动。",
    "The progress file {old} comes from a newer plcteach and is left as it is.",
)


@dataclass(frozen=True, slots=True)
class Record:
    """What is known of one exercise; a text is None until something was typed.

    best: the highest marks, None before the first attempt.  model: the model answer was looked at, and later marks do not count.
    start: what the text was begun with.  others: texts begun with something else, (start, text).  earlier: texts that another
    took the place of.
    """

    attempts: int = 0
    best: float | None = None
    points: float = 0.0
    hints: int = 0
    text: str | None = None
    start: str = ""
    model: bool = False
    others: tuple[tuple[str, str], ...] = ()
    earlier: tuple[str, ...] = ()

    def begun_with(self, start: str) -> str | None:
        """Give the text that was typed into a start; None where nothing was."""
        whole = (*(() if self.text is None else ((self.start, self.text),)), *self.others)
        return next((text for one, text in whole if one == start), None)

    def besides(self, start: str) -> tuple[str, ...]:
        """Give every other text that is kept, each once and in an order that stays while one goes through them."""
        now = () if self.text is None or self.start == start else (self.text,)
        whole = (*now, *(text for one, text in self.others if one != start), *self.earlier)
        return tuple(dict.fromkeys(text for text in whole if text.strip()))


@dataclass(slots=True)
class Notes:
    """The file of one folder; `trouble` says what last went wrong with it."""

    path: Path = field(default_factory=lambda: Path(os.environ.get(ASKED) or NAME).absolute())
    trouble: Text | None = None

    def record(self, name: str) -> Record:
        """Give what is known of an exercise; of one that nobody has worked on, nothing."""
        return _record(self.exercises().get(name))

    def exercises(self) -> dict[str, Table]:
        """Give what is known of all exercises, by id."""
        return {name: row for name, row in self._read().get("exercises", {}).items() if isinstance(row, dict)}

    def records(self) -> dict[str, Record]:
        """Give what is known of all exercises, by id, read once."""
        return {name: _record(row) for name, row in self.exercises().items()}

    def test(self, name: str) -> Table:
        """Give what is known of a concept test."""
        row = self._read().get("tests", {}).get(name)
        return row if isinstance(row, dict) else {}

    def change(self, name: str, change: Callable[[Table], None], *, among: str = "exercises") -> None:
        """Change what is known of one exercise (or test), and nothing else, whoever else writes meanwhile."""
        self.trouble = None
        try:
            with _alone(self.path):
                table = self._open()
                if table is not None:
                    rows = table.setdefault(among, {})
                    row = rows.get(name)
                    rows[name] = row = row if isinstance(row, dict) else {}
                    change(row)
                    row["at"] = datetime.now(UTC).isoformat(timespec="seconds")
                    _put(self.path, table)
        except OSError as why:
            self.trouble = _SHUT.format(old=self.path.name, why=why.strerror or type(why).__name__)

    def _read(self) -> Table:
        """Read the file for looking at only."""
        try:
            found = _parsed(self.path)
        except OSError:
            found = _UNREAD.format(old=self.path.name)
        if isinstance(found, Text):
            self.trouble = found
            return {}
        return found

    def _open(self) -> Table | None:
        """Read the file for changing it: what cannot be understood is put aside first, what is newer than we are is left alone."""
        if self.path.exists() and not self.path.stat().st_mode & 0o222:
            self.trouble = _SHUT.format(old=self.path.name, why=Text("只读", "read only"))
            return None
        found = _parsed(self.path)
        if not isinstance(found, Text):
            return found
        if found == _LATER.format(old=self.path.name):
            self.trouble = found
            return None
        aside = _free(self.path)
        self.path.replace(aside)
        self.trouble = _ASIDE.format(old=self.path.name, new=aside.name)
        return {"plcteach": _VERSION}


def typed(text: str, start: str, known: str | None) -> Callable[[Table], None]:
    """Keep a text as typed; what it takes the place of is kept beside it, unless it has grown out of it.

    A text with another start waits for a desk with that start.  One that somebody else has put there meanwhile (it is not `known`)
    is kept among the earlier ones, and so is what stood there when a learner starts over.
    """

    def change(row: Table) -> None:
        old = _turned(row, start)
        over = text.strip() in {"", start.strip()} and old != start
        if old != text and (over or old != known):
            aside(old)(row)
        row |= {"text": text, "start": start}

    return change


def aside(text: str) -> Callable[[Table], None]:
    """Keep a text among the earlier ones, as the newest of them."""

    def change(row: Table) -> None:
        before = _record(row).earlier
        if text.strip() and text not in before:
            row["earlier"] = [text, *before][:_MOST_EARLIER]

    return change


def _turned(row: Table, start: str) -> str:
    """Give the text that is kept for a start, and put one with another start among the others."""
    now = _record(row)
    mine = now.begun_with(start) or ""
    if now.text is None or now.start == start:
        return mine
    others = [one for one in now.others if one[0] not in (start, now.start)]
    if now.text.strip() and now.text != now.start:
        others.insert(0, (now.start, now.text))
    for _, old in others[_MOST_EARLIER:]:
        aside(old)(row)
    row["others"] = [{"start": one, "text": text} for one, text in others[:_MOST_EARLIER]]
    return mine


def tried(marks: float, points: float) -> Callable[[Table], None]:
    """Count an attempt, and keep its marks if they are the best, as long as the model answer has not been seen."""

    def change(row: Table) -> None:
        now = _record(row)
        row |= {"attempts": now.attempts + 1, "points": points}
        if not now.model:
            row["best"] = max(marks, now.best or 0.0)

    return change


def hinted(count: int) -> Callable[[Table], None]:
    """Keep how many hints have been asked for."""

    def change(row: Table) -> None:
        row["hints"] = max(count, _record(row).hints)

    return change


def modelled(row: Table) -> None:
    """Keep that the model answer was looked at."""
    row["model"] = True


def _record(row: object) -> Record:
    """Read a row that may hold anything."""
    if not isinstance(row, dict):
        return Record()
    text, start, best = row.get("text"), row.get("start"), row.get("best")
    return Record(
        attempts=int(_number(row.get("attempts"))),
        best=None if best is None else _number(best),
        points=_number(row.get("points")),
        hints=int(_number(row.get("hints"))),
        text=text if isinstance(text, str) else None,
        start=start if isinstance(start, str) else "",
        model=row.get("model") is True,
        others=tuple(_others(row.get("others"))),
        earlier=tuple(one for one in _listed(row.get("earlier")) if isinstance(one, str)),
    )


def _others(rows: object) -> Iterator[tuple[str, str]]:
    for one in _listed(rows):
        start, text = (one.get("start"), one.get("text")) if isinstance(one, dict) else (None, None)
        if isinstance(start, str) and isinstance(text, str):
            yield start, text


def _listed(value: object) -> list[Any]:
    return value if isinstance(value, list) else []


def _number(value: object) -> float:
    good = isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value < _MOST_NUMBER
    return float(value) if good and isinstance(value, int | float) else 0.0


def _parsed(path: Path) -> Table | Text:
    """Read a file; nothing there is an empty table, and words say why it cannot be used."""
    try:
        table = json.loads(path.read_bytes())
    except FileNotFoundError:
        return {"plcteach": _VERSION}
    except (ValueError, RecursionError):
        return _UNREAD.format(old=path.name)
    version = table.get("plcteach") if isinstance(table, dict) else None
    if isinstance(version, int) and version > _VERSION:
        return _LATER.format(old=path.name)
    good = version == _VERSION and all(isinstance(table.get(key, {}), dict) for key in ("exercises", "tests"))
    return table if good else _UNREAD.format(old=path.name)


def _free(path: Path) -> Path:
    number = 1
    while (aside := path.with_name(f"{path.stem}.broken-{number}{path.suffix}")).exists():
        number += 1
    return aside


def _put(path: Path, table: Table) -> None:
    """Write the whole beside the file, then put it in its place in one move."""
    where = path.resolve()
    new = where.with_name(f"{where.name}.{os.getpid()}.new")
    try:
        new.write_text(json.dumps(table, indent=1, sort_keys=True) + "\n", encoding="ascii")
        _into_place(new, where)
    finally:
        with suppress(OSError):
            new.unlink(missing_ok=True)


def _into_place(new: Path, where: Path) -> None:
    """Put a file in the place of another; where a reader keeps it from going (Windows), try again for a moment."""
    until = time.monotonic() + _PATIENCE / 4
    while True:
        try:
            new.replace(where)
        except PermissionError:
            if time.monotonic() > until:
                raise
            time.sleep(_NAP)
        else:
            return


@contextmanager
def _alone(path: Path) -> Iterator[None]:
    """Hold the file's lock; one that was left behind by a process that is gone is taken over."""
    lock = path.with_name(f"{path.name}.lock")
    until = time.monotonic() + _PATIENCE
    while True:
        try:
            os.close(os.open(lock, os.O_CREAT | os.O_EXCL | os.O_WRONLY))
            break
        except FileExistsError:
            with suppress(OSError):
                if time.time() - lock.stat().st_mtime > _STALE or time.monotonic() > until:
                    lock.unlink()
            time.sleep(_NAP)
    try:
        yield
    finally:
        with suppress(OSError):
            lock.unlink()
