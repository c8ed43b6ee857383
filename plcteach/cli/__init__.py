"""The same verbs on the command line: exit code 0 for right, 1 for wrong work, 2 for a wrong call."""

from __future__ import annotations

import sys
from contextlib import suppress
from typing import TYPE_CHECKING

from plcteach.cli.parser import parser_of_all
from plcteach.cli.reading import CallError
from plcteach.cli.verbs import MISCALLED, RIGHT
from plcteach.core.errors import PlcTeachError
from plcteach.core.text import language

if TYPE_CHECKING:
    from collections.abc import Sequence


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and give its exit code; nothing is raised but KeyboardInterrupt."""
    parser = parser_of_all()
    try:
        options = parser.parse_args(argv)
    except SystemExit as stop:
        return int(stop.code or 0)
    if options.lang:
        language(options.lang)
    if not getattr(options, "verb", None):
        parser.print_help()
        return MISCALLED
    try:
        return int(options.verb(options))
    except (CallError, PlcTeachError, OSError) as trouble:
        sys.stderr.write(f"plcteach: {trouble}\n")
        return MISCALLED


def script() -> None:
    """Run as a program, ending quietly on Ctrl-C and on a closed pipe."""
    try:
        code = main()
    except KeyboardInterrupt:
        code = 130
    except BrokenPipeError:
        code = RIGHT
        with suppress(OSError):
            sys.stdout = None
    raise SystemExit(code)
