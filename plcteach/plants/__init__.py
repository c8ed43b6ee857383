"""The things that are driven, one TOML file each, and the loader for a teacher's own."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING

from plcteach.core.errors import UnknownNameError
from plcteach.plants.declared import Device, Plant, Sample
from plcteach.plants.model import Model
from plcteach.plants.moment import Fault, Moment
from plcteach.plants.reading import parse

if TYPE_CHECKING:
    from pathlib import Path

__all__ = ["Device", "Fault", "Model", "Moment", "Plant", "Sample", "load", "names", "parse", "plant"]


@cache
def _bundled() -> dict[str, Plant]:
    found = [
        parse(entry.read_text(encoding="utf-8"), entry.name.removesuffix(".toml"))
        for entry in files(__package__).iterdir()
        if entry.name.endswith(".toml")
    ]
    return {one.id: one for one in sorted(found, key=lambda one: (one.order, one.id))}


def names() -> tuple[str, ...]:
    """Give the ids of all bundled plants in teaching order."""
    return tuple(_bundled())


def plant(name: str | Plant) -> Plant:
    """Give a bundled plant by its id; UnknownNameError suggests the nearest."""
    if isinstance(name, Plant):
        return name
    try:
        return _bundled()[name]
    except KeyError:
        kind = "plant"
        raise UnknownNameError(kind, name, _bundled()) from None


def load(path: Path) -> Plant:
    """Read a teacher's own plant; DeclarationError names what does not fit."""
    return parse(path.read_text(encoding="utf-8"), path.stem)
