"""Reads what the caller names: files, standard input, the JSON of a run's inputs."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plcteach.core.source import decode
from plcteach.dialects import dialect as find_dialect
from plcteach.dialects import names
from plcteach.ladder import read_either

if TYPE_CHECKING:
    import argparse

    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect


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
    return read_either(text_of(name, options), family_of(options))


def scans_of(name: str | None) -> list[dict[str, Any]]:
    """Read the JSON list of inputs; CallError says what it should look like."""
    if name is None:
        return [{}]
    try:
        rows = json.loads(_content(name))
    except (ValueError, RecursionError) as trouble:
        msg = f"{name}: not JSON ({trouble})"
        raise CallError(msg) from None
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        msg = f'{name}: expected a list with one object a scan, such as [{{"I0.0": 1}}, {{}}]'
        raise CallError(msg)
    for row in rows:
        for address, value in row.items():
            if not isinstance(value, int) or (address != "ms" and value not in (0, 1)):
                msg = f"{name}: {address} is a bit, so it is 0 or 1"
                raise CallError(msg)
    return rows


def watched_of(names_given: str | None, program: Program) -> list[str]:
    """Give the addresses to print: those asked for, else all outputs."""
    if names_given:
        return [name.strip() for name in names_given.split(",") if name.strip()]
    return [address.text for address in program.addresses("output")]
