"""Declares the verbs and their options."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plcteach import __version__
from plcteach.cli import exercises, ladders
from plcteach.cli import verbs as verbs_of
from plcteach.cli.grading import grade_verb
from plcteach.dialects import names

if TYPE_CHECKING:
    from collections.abc import Callable


def parser_of_all() -> argparse.ArgumentParser:
    """Give the parser of the whole command line."""
    parser = argparse.ArgumentParser(prog="plcteach", description="Learn how a PLC thinks.")
    parser.add_argument("--version", action="version", version=f"plcteach {__version__}")
    common = argparse.ArgumentParser(add_help=False)
    spoken: dict[str, Any] = {
        "choices": ["en", "zh"],
        "help": "language of what is printed (default: the environment's)",
    }
    parser.add_argument("--lang", default=None, **spoken)
    common.add_argument("--lang", default=argparse.SUPPRESS, **spoken)
    family = argparse.ArgumentParser(add_help=False)
    family.add_argument("--dialect", choices=names(), help=f"PLC family (default {names()[0]})")
    reading = argparse.ArgumentParser(add_help=False, parents=[common, family])
    reading.add_argument("--symbols", metavar="FILE", help="a symbol table (tab-separated: name, address, comment)")
    reading.add_argument("--encoding", help="encoding to try after UTF-8 (then GBK, cp1252)")
    verbs = parser.add_subparsers(title="verbs", metavar="VERB")
    _judging_verbs(verbs, reading)
    _showing_verbs(verbs, common, family)
    _ladder_verbs(verbs, reading)
    _making_verbs(verbs, common, reading)
    _grading_verb(verbs, common)
    _exercise_verbs(verbs, common, reading)
    return parser


_INPUTS = (
    'a file, or the text itself: JSON, a list with one object a scan: [{"I0.0": 1, "ms": 10}, {}], where an input not named keeps its value; '
    "or what check --json prints; or a timeline: I0.0: 1s off, 0.2s on, off"
)


def _judging_verbs(verbs: Any, reading: argparse.ArgumentParser) -> None:

    one = _verb(verbs, "run", verbs_of.run_verb, [reading], "run a program scan by scan")
    one.add_argument("file", help="the program; - for standard input")
    one.add_argument("--inputs", help=_INPUTS)
    one.add_argument("--watch", help="addresses to print, separated by commas (default: all outputs)")
    one.add_argument("--scan-ms", type=int, default=10, help="length of a scan in ms (default 10)")
    one.add_argument("--anyway", action="store_true", help="run past stack errors where the machine has no trap")
    one.add_argument("--json", action="store_true", help="print JSON only")

    one = _verb(
        verbs, "lint", verbs_of.lint_verb, [reading], "say what is to be said of a program, or of a folder of them"
    )
    one.add_argument("file", help="the program or folder; - for standard input")
    one.add_argument("--json", action="store_true", help="print JSON only")

    one = _verb(
        verbs, "check", verbs_of.check_verb, [reading], "compare a program with a reference, by proof or counterexample"
    )
    one.add_argument("student", help="the program to judge; - for standard input")
    one.add_argument("--reference", help="a program or a ladder drawing (default: the exercise's own)")
    one.add_argument(
        "--exercise",
        metavar="ID",
        help="judge by this exercise (a bundled one, or your own .toml file): its family and its ladder",
    )
    one.add_argument(
        "--level",
        choices=["exact", "settled", "either"],
        help="equal at every scan's end, once settled, or either (default: the exercise's, else either)",
    )
    one.add_argument("--json", action="store_true", help="print JSON only")


def _showing_verbs(verbs: Any, common: argparse.ArgumentParser, family: argparse.ArgumentParser) -> None:
    one = _verb(
        verbs, "figure", verbs_of.figure_verb, [common, family], "draw the before/after figure of an instruction"
    )
    one.add_argument("mnemonic", help="OLD, LPS, LDS …")
    one.add_argument("number", nargs="?", type=int, help="the number behind it, as in LDS 3")
    one.add_argument("-o", "--output", type=Path, help=".svg, .pdf or .png (default: SVG to standard output)")

    one = _verb(
        verbs,
        "explain",
        verbs_of.explain_verb,
        [common],
        "explain an instruction or a diagnostic; without a word, list all",
    )
    one.add_argument(
        "word", nargs="*", help="OLD, LDS 3, STK001 …; with --dialect and no word, list that family's instructions"
    )
    one.add_argument("--dialect", choices=names(), help="PLC family (default: the first that has it)")


def _ladder_verbs(verbs: Any, reading: argparse.ArgumentParser) -> None:
    json: dict[str, Any] = {"action": "store_true", "help": "print JSON only"}

    one = _verb(
        verbs, "ladder", ladders.ladder_verb, [reading], "draw a program as a ladder, with what no ladder can show"
    )
    one.add_argument("file", help="a list, a ladder drawing or a PLCopen file; - for standard input")
    kinds = ".svg, .pdf or .png, .txt for a drawing, .xml for PLCopen (default: the drawing to standard output)"
    one.add_argument("-o", "--output", type=Path, help=kinds)
    one.add_argument(
        "--style", choices=["relay", "iec"], default="relay", help="round coils, or coils as the standard has them"
    )
    one.add_argument("--legend", action="store_true", help="with the meaning of the signs")
    one.add_argument("--formulas", action="store_true", help="with the Boolean formula of each output")
    one.add_argument("--json", **json)

    one = _verb(verbs, "lower", ladders.lower_verb, [reading], "write a ladder out as an instruction list")
    one.add_argument("file", metavar="drawing", help="a ladder drawing, a PLCopen file or a list; - for standard input")
    one.add_argument("--grouped", action="store_true", help="joins together behind their blocks, not one after each")
    one.add_argument("--unfused", action="store_true", help="each contact a block of its own: a load and a join")
    one.add_argument("--reasons", action="store_true", help="with the reason for each inserted instruction")
    one.add_argument("--json", **json)

    one = _verb(verbs, "translate", ladders.translate_verb, [reading], "carry a program from one family to another")
    one.add_argument("file", help="the program; - for standard input")
    one.add_argument(
        "--from", dest="source", choices=names(), help=f"the family it is written for (default {names()[0]})"
    )
    one.add_argument("--to", choices=names(), required=True, help="the family to write it for")
    one.add_argument("--json", **json)


def _making_verbs(verbs: Any, common: argparse.ArgumentParser, reading: argparse.ArgumentParser) -> None:
    one = _verb(verbs, "chart", verbs_of.chart_verb, [reading], "draw the timing chart of a run")
    one.add_argument("file", help="the program; - for standard input")
    one.add_argument("--inputs", help=_INPUTS)
    one.add_argument("--watch", help="addresses to draw, separated by commas (default: inputs, timers, outputs)")
    one.add_argument("--scan-ms", type=int, default=10, help="length of a scan in ms (default 10)")
    one.add_argument("-o", "--output", type=Path, help=".svg, .pdf or .png (default: SVG to standard output)")

    one = _verb(verbs, "play", verbs_of.play_verb, [reading], "write a player page that needs no kernel and no network")
    one.add_argument("file", help="the program; - for standard input")
    one.add_argument("--inputs", help="as for run (default: one scan with inputs that tell the instructions apart)")
    one.add_argument("--at", type=float, default=0, metavar="SECONDS", help="begin so many seconds into the run")
    one.add_argument("--scans", type=int, help="how many scans to show (default: all that have room)")
    one.add_argument("-o", "--output", type=Path, required=True, help="the page, such as player.html")

    one = _verb(verbs, "sheet", verbs_of.sheet_verb, [reading], "write a worksheet: an empty stack table as PDF")
    one.add_argument("file", help="the program; - for standard input")
    one.add_argument("-o", "--output", type=Path, required=True, help="the PDF")
    one.add_argument("--inputs", help="as for run; its first scan is used (default: chosen to tell AND from OR)")
    one.add_argument("--key", action="store_true", help="with the answers filled in")

    one = _verb(verbs, "lab", verbs_of.lab_verb, [common], "open the lessons in JupyterLab")
    one.add_argument(
        "folder",
        nargs="?",
        type=Path,
        help="copy the lessons there and work on the copies (default: the checkout's own, else ./plcteach-lessons)",
    )
    one.add_argument("--no-browser", action="store_true", help="do not open a browser")


def _grading_verb(verbs: Any, common: argparse.ArgumentParser) -> None:
    one = _verb(verbs, "grade", grade_verb, [common], "grade a folder of answers, as a learning platform gives it out")
    one.add_argument(
        "folder", help="a folder for each learner, or a file for each (a ZIP file is to be unpacked first)"
    )
    one.add_argument("--exercise", required=True, metavar="ID", help="a bundled exercise, or your own .toml file")
    one.add_argument("-o", "--output", type=Path, metavar="OUT", help="where the results go (default: FOLDER-marks)")
    one.add_argument("--jobs", type=_count, help="how many processes (default: one for each core)")
    one.add_argument("--cluster", metavar="ADDRESS", help="judge on a dask.distributed cluster, as tcp://host:8786")
    one.add_argument("--encoding", help="encoding to try after UTF-8 (then GBK, cp1252)")
    one.add_argument("--json", action="store_true", help="print the results as JSON")


def _exercise_verbs(verbs: Any, common: argparse.ArgumentParser, reading: argparse.ArgumentParser) -> None:
    about = "list and show exercises, write one from a ladder, or prove one"
    parser = _verb(verbs, "exercise", exercises.list_verb, [common], about)
    parser.set_defaults(dialect=None, json=False)
    some = parser.add_subparsers(title="verbs", metavar="VERB")
    json: dict[str, Any] = {"action": "store_true", "help": "print JSON only"}

    one = _verb(some, "list", exercises.list_verb, [common], "print the catalogue in teaching order")
    one.add_argument("--dialect", choices=names(), help="only of this PLC family")
    one.add_argument("--json", **json)

    one = _verb(some, "show", exercises.show_verb, [common], "print a task as a learner sees it")
    one.add_argument("what", metavar="ID", help="a bundled exercise, a drill (drill-blocks-2-7-…), or a .toml file")

    one = _verb(some, "new", exercises.new_verb, [reading], "write an exercise file from a ladder drawing or a list")
    _new_options(one)

    one = _verb(
        some,
        "test",
        exercises.test_verb,
        [common],
        "prove that exercises accept what is right and refuse what is wrong",
    )
    one.add_argument("what", nargs="*", metavar="FILE", help="files, folders or ids (default: all bundled exercises)")
    one.add_argument("--json", **json)


def _new_options(one: argparse.ArgumentParser) -> None:
    """Declare what may be said of an exercise that is written."""
    one.add_argument("file", help="a ladder drawing, a list or a PLCopen file; - for standard input")
    one.add_argument(
        "--kind",
        choices=["write", "complete", "bug", "order", "predict", "join", "match", "chart"],
        default="write",
        help="what the learner is asked to do (default: write the list)",
    )
    where = "where to write it (default: standard output)"
    one.add_argument("-o", "--output", type=Path, metavar="FILE.toml", help=where)
    one.add_argument("--force", action="store_true", help="write over a file that is there already")


def _count(word: str) -> int:
    """Read how many; at least one."""
    if not word.isdecimal() or not int(word):
        msg = f"{word!r} is no number from 1"
        raise argparse.ArgumentTypeError(msg)
    return int(word)


def _verb(
    verbs: Any, name: str, verb: Callable[[argparse.Namespace], int], parents: list[argparse.ArgumentParser], text: str
) -> argparse.ArgumentParser:
    one: argparse.ArgumentParser = verbs.add_parser(
        name, parents=parents, help=text, description=text[0].upper() + text[1:] + "."
    )
    one.set_defaults(verb=verb)
    return one
