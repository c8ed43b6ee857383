"""The same verbs on the command line: exit code 0 for right, 1 for wrong work, 2 for a wrong call."""

from __future__ import annotations

import os
import sys
from io import TextIOWrapper
from typing import TYPE_CHECKING

from plcteach.cli.parser import parser_of_all
from plcteach.cli.reading import CallError
from plcteach.cli.verbs import MISCALLED, RIGHT
from plcteach.core.errors import PlcTeachError
from plcteach.core.text import speaking

if TYPE_CHECKING:
    from collections.abc import Sequence


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and give its exit code; nothing is raised but KeyboardInterrupt and a closed pipe."""
    parser = parser_of_all()
    try:
        options, others = parser.parse_known_args(argv)
        words = getattr(options, "word", None)
        if words is not None and not any(one.startswith("--") for one in others):
            options.word, others = [*words, *others], []  # an instruction may begin with a sign (-I)
        if others:
            parser.error(f"unrecognized arguments: {' '.join(others)}")
    except SystemExit as stop:
        return int(stop.code or 0)
    if not getattr(options, "verb", None):
        parser.print_help()
        return MISCALLED
    try:
        with speaking(options.lang):
            return int(options.verb(options))
    except BrokenPipeError:
        raise
    except (CallError, PlcTeachError, OSError) as trouble:
        sys.stderr.write(f"plcteach: {trouble}\n")
        return MISCALLED


def script() -> None:
    """Run as a program, ending quietly on Ctrl-C and on a closed pipe; what the terminal cannot show is escaped."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    try:
        code = main()
        sys.stdout.flush()
    except KeyboardInterrupt:
        code = 130
    except BrokenPipeError:
        code = RIGHT
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    raise SystemExit(code)
