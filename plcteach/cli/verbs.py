"""What each verb of the command line does: read, ask the rooms, print; exit code 0 right, 1 wrong work, 2 wrong call."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plcteach.check.drill import task_of as exercise
from plcteach.check.judge import reference, verdict_on
from plcteach.check.lint import lint
from plcteach.cli.printing import (
    finding_json,
    plain,
    print_findings,
    print_folder,
    print_json,
    print_table,
    print_verdict,
    say,
    say_empty,
    verdict_json,
)
from plcteach.cli.reading import CallError, family_of, program_of, scans_of, symbols_of, text_of, watched_of
from plcteach.core.diagnostic import errors
from plcteach.core.exercise import Terms
from plcteach.core.text import language, same
from plcteach.machine import run

if TYPE_CHECKING:
    import argparse

    from plcteach.core.program import Program

RIGHT, WRONG, MISCALLED = 0, 1, 2


def run_verb(options: argparse.Namespace) -> int:
    """Run a program over the scans of a file."""
    program = program_of(options.file, options)
    found = lint(program)
    stopped = errors(found if program.dialect.traps or not options.anyway else program.diagnostics)
    if stopped or not program.lines:
        if options.json:
            print_json({"diagnostics": [finding_json(one) for one in found]})
        else:
            print_findings(found, program)
            say_empty(program)
        return WRONG
    trace = run(program, scans_of(options.inputs, program, options), scan_ms=options.scan_ms)
    watched = watched_of(options.watch, program, options)
    columns = {name: trace.values(address) for name, address in watched.items()}
    rows = [{name: plain(repr(values[scan])) for name, values in columns.items()} for scan in range(len(trace.starts))]
    if options.json and errors(trace.diagnostics):
        print_json({"diagnostics": [finding_json(one) for one in trace.diagnostics]})
    elif options.json:
        print_json(rows)
    else:
        print_table([say("扫描", "scan"), *watched], [[number, *row.values()] for number, row in enumerate(rows)])
        print_findings(trace.diagnostics, program)
    return WRONG if errors(trace.diagnostics) else RIGHT


def lint_verb(options: argparse.Namespace) -> int:
    """Say what is to be said of a program or a folder."""
    path = Path(options.file)
    if options.file != "-" and path.is_dir():
        return _lint_folder(path, options)
    program = program_of(options.file, options)
    found = lint(program)
    if options.json:
        print_json([finding_json(one) for one in found])
    else:
        print_findings(found, program)
        if not found:
            print(found)
    return WRONG if errors(found) else RIGHT


def _lint_folder(folder: Path, options: argparse.Namespace) -> int:
    from plcteach.cli.folder import lint_files

    files = list(lint_files(folder, family_of(options), options.encoding, symbols_of(options)))
    if options.json:
        print_json({one.name: [finding_json(each) for each in one.found] for one in files})
    else:
        print_folder(files)
    return WRONG if any(errors(one.found) for one in files) else RIGHT


def check_verb(options: argparse.Namespace) -> int:
    """Compare a submission with a reference."""
    drawing, terms = "", Terms()
    if options.exercise:
        task = exercise(options.exercise)
        if options.dialect not in {None, task.dialect}:
            msg = f"exercise {task.id} is for {task.dialect}, not for {options.dialect}"
            raise CallError(msg)
        options.dialect, drawing = task.dialect, task.reference
        terms = task.terms
    if not options.reference and not drawing:
        msg = "check wants --reference FILE or --exercise ID"
        raise CallError(msg)
    student = program_of(options.student, options)
    wanted = reference(text_of(options.reference, options) if options.reference else drawing, family_of(options))
    terms = replace(terms, level=options.level) if options.level else terms
    verdict = verdict_on(wanted, student, terms)
    if options.json:
        print_json(verdict_json(verdict))
    else:
        print_findings(verdict.diagnostics, student)
        say_empty(student)
        print_verdict(verdict)
    return RIGHT if verdict.status == "equal" else WRONG


def chart_verb(options: argparse.Namespace) -> int:
    """Draw the timing chart of a run."""
    from plcteach.figure.charts import chart_of

    program = _sound(options)
    if program is None:
        return WRONG
    trace = run(program, scans_of(options.inputs, program, options), scan_ms=options.scan_ms)
    shown = watched_of(options.watch, program, options).values() if options.watch else ()
    return drawn(chart_of(trace, shown), options)


def figure_verb(options: argparse.Namespace) -> int:
    """Draw an instruction's before/after figure."""
    from plcteach.figure.stack import illustrate

    return drawn(illustrate(family_of(options), options.mnemonic.upper(), options.number), options)


def drawn(scene: Any, options: argparse.Namespace) -> int:
    """Write a picture to the file that was asked for, else as SVG to standard output."""
    from plcteach.figure.svg import svg

    if options.output is None:
        print(svg(scene, language()))
    elif options.output.suffix == ".svg":
        options.output.write_text(svg(scene, language()), encoding="utf-8")
    else:
        _ink(scene, options.output)
    return RIGHT


def _ink(scene: Any, path: Path) -> None:
    if path.suffix not in {".pdf", ".png"}:
        msg = f"{path}: a figure is written as .svg, .pdf or .png"
        raise CallError(msg)
    from plcteach.figure.mpl import save

    save(scene, path, language())


def explain_verb(options: argparse.Namespace) -> int:
    """Print a card or a rule's page."""
    from plcteach.check.manual import explain

    print(explain(" ".join(options.word), options.dialect))
    return RIGHT


def _sound(options: argparse.Namespace) -> Program | None:
    """Read a program that can be shown; print what keeps it from being shown, and give nothing, where there is an error."""
    program = program_of(options.file, options)
    found = lint(program)
    if not errors(found) and program.lines:
        return program
    print_findings(found, program)
    say_empty(program)
    return None


def play_verb(options: argparse.Namespace) -> int:
    """Write a player page."""
    from plcteach.figure.table import telling_inputs
    from plcteach.figure.verbs import film_of
    from plcteach.publish import player_page

    program = _sound(options)
    if program is None:
        return WRONG
    name = Path(options.file).name if options.file != "-" else ""
    scans = scans_of(options.inputs, program, options) if options.inputs else [telling_inputs(program)]
    shot = film_of(run(program, scans), at=options.at, scans=options.scans, title=same(name) if name else None)
    options.output.write_text(player_page(shot), encoding="utf-8")
    print(options.output)
    return RIGHT


def sheet_verb(options: argparse.Namespace) -> int:
    """Write a worksheet."""
    from plcteach.figure.mpl import save_pages
    from plcteach.figure.table import sheet

    if options.output.suffix.lower() != ".pdf":
        msg = f"{options.output}: a worksheet is written as .pdf"
        raise CallError(msg)
    program = _sound(options)
    if program is None:
        return WRONG
    inputs: dict[str, int] | None = dict(*scans_of(options.inputs, program, options)[:1]) if options.inputs else None
    save_pages(sheet(program, key=options.key, inputs=inputs), options.output, language())
    print(options.output)
    return RIGHT


def lab_verb(options: argparse.Namespace) -> int:
    """Open the lessons."""
    from plcteach.publish.lab import open_lab

    return open_lab(options.folder, browser=not options.no_browser)
