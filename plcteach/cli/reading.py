"""Reads what the caller names: files, standard input, the JSON of a run's inputs."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plcteach.core.area import Address
from plcteach.core.diagnostic import errors
from plcteach.core.source import decode
from plcteach.core.text import language
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import names
from plcteach.ladder.either import ladder_either, read_either
from plcteach.machine.scan import SCAN_MS
from plcteach.machine.timeline import timeline
from plcteach.stl.symbols import read_symbols

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterable

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.ladder.either import Given
    from plcteach.stl.symbols import Symbols


class CallError(Exception):
    """The command was called in a way that cannot be carried out; says what to do next."""


def _content(name: str) -> bytes:
    if name == "-":
        return sys.stdin.buffer.read()
    path = Path(name)
    if path.is_dir():
        msg = f"{name} is a folder; name one file in it"
        raise CallError(msg)
    if not path.exists():
        msg = f"there is no file {name}"
        raise CallError(msg)
    return path.read_bytes()


def text_of(name: str, options: argparse.Namespace) -> str:
    """Give the text of a file, decoded."""
    return decode(_content(name), options.encoding)


def family_of(options: argparse.Namespace) -> Dialect:
    """Give the family that the caller chose, or the default."""
    return find_dialect(options.dialect or names()[0])


def program_of(name: str, options: argparse.Namespace) -> Program:
    """Read a program file, or lower a ladder drawing, in the family that the caller chose."""
    return read_either(text_of(name, options), family_of(options), symbols_of(options))


def ladder_of(name: str, options: argparse.Namespace) -> tuple[Given, str]:
    """Read a ladder drawing, or lift a list, in the family that the caller chose; gives the text too."""
    text = text_of(name, options)
    return ladder_either(text, family_of(options), symbols_of(options)), text


def symbols_of(options: argparse.Namespace) -> Symbols | None:
    """Read the symbol table that the caller named, once a command."""
    name: str | None = getattr(options, "symbols", None)
    if name and "table" not in options:
        table = read_symbols(_content(name), encoding=options.encoding)
        _refuse_wrong(name, table.diagnostics)
        options.table = table
    return options.table if name else None


def _refuse_wrong(name: str, found: Iterable[Diagnostic]) -> None:
    """Refuse a file with an error in it; CallError gives the first one with its row."""
    wrong = errors(found)
    if wrong:
        msg = f"{name}: row {wrong[0].span.row}: {wrong[0].text.in_(language())}"
        raise CallError(msg)


def scans_of(name: str | None, program: Program, options: argparse.Namespace) -> list[dict[str, Any]]:
    """Read the inputs: a JSON list with one object a scan, or a timeline; CallError says what they should look like.

    A name from the symbol table may stand for its address.
    """
    if name is None:
        return [{}]
    scan_ms, table = getattr(options, "scan_ms", SCAN_MS), symbols_of(options)
    typed = ":" in name and not Path(name).exists()
    content = name.encode() if typed else _content(name)
    name = "--inputs" if typed else name
    if content.lstrip()[:1] not in {b"[", b"{", b""}:
        return _timeline_of(name, _plain(decode(content), table), program, scan_ms)
    try:
        rows = json.loads(content)
    except (ValueError, RecursionError) as trouble:
        msg = f"{name}: not JSON ({trouble})"
        raise CallError(msg) from None
    rows = _of_report(rows)
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        msg = f'{name}: expected a list with one object a scan, such as [{{"I0.0": 1}}, {{}}], or what check --json prints'
        raise CallError(msg)
    rows = [{_address(key, table): value for key, value in row.items()} for row in rows]
    for row in rows:
        for address, value in row.items():
            _check(name, address, value, program)
    return rows


def _of_report(told: Any) -> Any:
    """Give the inputs of the counterexample, if this is what `check --json` prints; else all of it."""
    example = told.get("counterexample") if isinstance(told, dict) else None
    return example.get("inputs") if isinstance(example, dict) else told


def _address(word: str, table: Symbols | None) -> str:
    """Give the address that a name of the symbol table stands for, and any other word as it is."""
    return (table.find(word) if table else None) or word


def _plain(text: str, table: Symbols | None) -> str:
    """Put the addresses for the names before the colons of a timeline."""
    return _ROW.sub(lambda match: match[1] + _address(match[2].strip(), table) + ":", text) if table else text


_ROW = re.compile(r"(^|[;；\n]\s*)([^:：;；\n]+)[:：]")


def _check(name: str, address: str, value: object, program: Program) -> None:
    """Refuse a value that its address cannot hold."""
    place = program.dialect.address(address)
    word = address == "ms" or (isinstance(place, Address) and place.size > 1)
    if not isinstance(value, int) or (not word and value not in (0, 1)):
        what = "a word, so it is a whole number" if word else "a bit, so it is 0 or 1"
        msg = f"{name}: {address} is {what}"
        raise CallError(msg)
    if isinstance(place, Address) and not place.fits(value):
        msg = f"{name}: {address} has {place.size} bits, and {value} does not fit"
        raise CallError(msg)
    if address == "ms" and not 0 <= value <= MOST_MS:
        msg = f"{name}: a scan lasts 0 to {MOST_MS} ms, not {value}"
        raise CallError(msg)


MOST_MS = 3_600_000


def _timeline_of(name: str, text: str, program: Program, scan_ms: int) -> list[dict[str, Any]]:
    found = timeline(text, program.dialect, scan_ms=scan_ms)
    _refuse_wrong(name, found.diagnostics)
    return list(found.scans())


def watched_of(names_given: str | None, program: Program, options: argparse.Namespace) -> dict[str, str]:
    """Give the addresses to print, by the names as typed: those asked for, else all outputs."""
    if names_given:
        table = symbols_of(options)
        return {name.strip(): _address(name.strip(), table) for name in names_given.split(",") if name.strip()}
    return {address.text: address.text for address in program.addresses("output")}
