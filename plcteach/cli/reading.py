"""Reads what the caller names: files, standard input, the JSON of a run's inputs."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plcteach.core.area import Address
from plcteach.core.diagnostic import errors
from plcteach.core.source import decode
from plcteach.core.text import language
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import names
from plcteach.ladder.either import read_either
from plcteach.machine.scan import SCAN_MS
from plcteach.machine.timeline import timeline
from plcteach.stl.symbols import read_symbols

if TYPE_CHECKING:
    import argparse

    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect
    from plcteach.stl.symbols import Symbols


class CallError(Exception):
    """The command was called in a way that cannot be carried out; says what to do next."""


def _content(name: str) -> bytes:
    if name == "-":
        return sys.stdin.buffer.read()
    path = Path(name)
    if not path.is_file():
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
    return read_either(text_of(name, options), family_of(options), _symbols_of(options))


def _symbols_of(options: argparse.Namespace) -> Symbols | None:
    """Read the symbol table that the caller named."""
    name = getattr(options, "symbols", None)
    if not name:
        return None
    table = read_symbols(_content(name), encoding=options.encoding)
    wrong = errors(table.diagnostics)
    if wrong:
        msg = f"{name}: row {wrong[0].span.row}: {wrong[0].text.in_(language())}"
        raise CallError(msg)
    return table


def scans_of(name: str | None, program: Program, scan_ms: int = SCAN_MS) -> list[dict[str, Any]]:
    """Read the inputs: a JSON list with one object a scan, or a timeline; CallError says what they should look like."""
    if name is None:
        return [{}]
    typed = ":" in name and not Path(name).is_file()
    content = name.encode() if typed else _content(name)
    name = "--inputs" if typed else name
    if content.lstrip()[:1] not in {b"[", b"{", b""}:
        return _timeline_of(name, decode(content), program, scan_ms)
    try:
        rows = json.loads(content)
    except (ValueError, RecursionError) as trouble:
        msg = f"{name}: not JSON ({trouble})"
        raise CallError(msg) from None
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        msg = f'{name}: expected a list with one object a scan, such as [{{"I0.0": 1}}, {{}}]'
        raise CallError(msg)
    for row in rows:
        for address, value in row.items():
            _check(name, address, value, program)
    return rows


def _check(name: str, address: str, value: object, program: Program) -> None:
    """Refuse a value that its address cannot hold."""
    place = program.dialect.address(address)
    word = address == "ms" or (isinstance(place, Address) and place.size > 1)
    if not isinstance(value, int) or (not word and value not in (0, 1)):
        what = "a word, so it is a whole number" if word else "a bit, so it is 0 or 1"
        msg = f"{name}: {address} is {what}"
        raise CallError(msg)
    if isinstance(place, Address) and not -(1 << place.size >> 1) <= value < 1 << place.size:
        msg = f"{name}: {address} has {place.size} bits, and {value} does not fit"
        raise CallError(msg)
    if address == "ms" and not 0 <= value <= MOST_MS:
        msg = f"{name}: a scan lasts 0 to {MOST_MS} ms, not {value}"
        raise CallError(msg)


MOST_MS = 3_600_000


def _timeline_of(name: str, text: str, program: Program, scan_ms: int) -> list[dict[str, Any]]:
    found = timeline(text, program.dialect, scan_ms=scan_ms)
    wrong = errors(found.diagnostics)
    if wrong:
        msg = f"{name}: row {wrong[0].span.row}: {wrong[0].text.in_(language())}"
        raise CallError(msg)
    return list(found.scans())


def watched_of(names_given: str | None, program: Program) -> list[str]:
    """Give the addresses to print: those asked for, else all outputs."""
    if names_given:
        return [name.strip() for name in names_given.split(",") if name.strip()]
    return [address.text for address in program.addresses("output")]
