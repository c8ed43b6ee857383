"""The verbs about ladders: draw one, write one out as a list, and carry a program from one family to another."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.cli.printing import finding_json, print_findings, print_json, say
from plcteach.cli.reading import CallError, family_of, ladder_of, program_of
from plcteach.cli.verbs import RIGHT, WRONG, drawn
from plcteach.core.diagnostic import errors
from plcteach.core.errors import NotRepresentableError
from plcteach.core.text import language
from plcteach.dialects import dialect as find_dialect

if TYPE_CHECKING:
    import argparse

    from plcteach.core.diagnostic import Diagnostic
    from plcteach.core.ladder import Ladder
    from plcteach.ladder.translation import Translation

MOST_DRAWN = 200
"""More rungs than this make a picture of dots that no viewer opens."""


def ladder_verb(options: argparse.Namespace) -> int:
    """Draw a program as a ladder: as text to standard output, or as a picture, text or PLCopen XML to a file."""
    try:
        given, source = ladder_of(options.file, options)
        if options.json:
            return _json_ladder(given.ladder, given.found)
        if given.ladder.rungs:
            _write(given.ladder, options)
    except NotRepresentableError as reason:
        return _refused(reason, options)
    if not given.ladder.rungs:
        return _not_read(given.found, source, options)
    print_findings(given.found, source)
    return WRONG if errors(given.found) else RIGHT


def _json_ladder(ladder: Ladder, found: tuple[Diagnostic, ...]) -> int:
    from plcteach.ladder.picture import write_drawing, write_line

    rungs = [{"title": one.title, "line": write_line(one)} for one in ladder.rungs]
    print_json({"drawing": write_drawing(ladder), "rungs": rungs, "diagnostics": [finding_json(one) for one in found]})
    return WRONG if errors(found) or not ladder.rungs else RIGHT


def _write(ladder: Ladder, options: argparse.Namespace) -> None:
    """Write a ladder in the form that the ending of the file asks for."""
    from plcteach.figure.ladder import ladder_scene
    from plcteach.ladder.picture import write_drawing

    ending = options.output.suffix.lower() if options.output else ""
    if options.output is None:
        print(write_drawing(ladder), end="")
    elif ending == ".txt":
        options.output.write_text(write_drawing(ladder), encoding="utf-8")
    elif ending == ".xml":
        from plcteach.ladder.plcopen_write import write_plcopen

        options.output.write_text(write_plcopen(ladder), encoding="utf-8")
    elif ending in {".png", ".pdf"} and len(ladder.rungs) > MOST_DRAWN:
        msg = f"{options.output}: {len(ladder.rungs)} rungs are too many for one {ending}; write .svg, or a part of the program"
        raise CallError(msg)
    else:
        scene = ladder_scene(ladder, style=options.style, legend=options.legend, formulas=options.formulas)
        drawn(scene, options)


def lower_verb(options: argparse.Namespace) -> int:
    """Write a ladder out as an instruction list."""
    from plcteach.ladder.lower import lower, lower_lines

    family, how = family_of(options), {"grouped": options.grouped, "fused": not options.unfused}
    try:
        given, source = ladder_of(options.file, options)
        if errors(given.found) or not given.ladder.rungs:
            return _not_read(given.found, source, options)
        lines = lower_lines(given.ladder, family, **how)
        text = "\n".join((*given.configuration, lower(given.ladder, family, **how)))
    except NotRepresentableError as reason:
        return _refused(reason, options)
    if options.json:
        rows = [{"text": one.text, "rung": one.rung, "reason": one.reason.in_(language())} for one in lines]
        print_json({"program": text, "lines": rows})
    elif options.reasons:
        wide = max(len(one.text) for one in lines)
        print("".join(f"{row}\n" for row in (*given.configuration, *given.ladder.configuration)), end="")
        for one in lines:
            print(f"{one.text:{wide}}  // {one.reason.in_(language())}" if one.reason.en else one.text)
    else:
        print(text, end="")
    return RIGHT


def _not_read(found: tuple[Diagnostic, ...], source: str, options: argparse.Namespace) -> int:
    """Say why a text could not be read."""
    if options.json:
        print_json({"diagnostics": [finding_json(one) for one in found]})
    else:
        print_findings(found, source)
        if not found:
            print(say("这里面没有梯级，也没有指令。", "There is neither a rung nor an instruction in it."))
    return WRONG


def _refused(reason: NotRepresentableError, options: argparse.Namespace) -> int:
    """Say why a family has no list for a ladder."""
    if options.json:
        print_json({"reason": str(reason)})
    else:
        print(reason)
    return WRONG


def translate_verb(options: argparse.Namespace) -> int:
    """Carry a program from one family to another, its addresses too."""
    from plcteach.ladder.translate import translate

    if options.dialect and options.source and options.dialect != options.source:
        msg = f"--from {options.source} and --dialect {options.dialect} do not agree"
        raise CallError(msg)
    options.dialect = options.source or options.dialect
    try:
        program = program_of(options.file, options)
        if errors(program.diagnostics) or not program.lines:
            return _not_read(program.diagnostics, program.source, options)
        made = translate(program, find_dialect(options.to))
    except NotRepresentableError as reason:
        return _refused(reason, options)
    _print_translation(made, options)
    return RIGHT


def _print_translation(made: Translation, options: argparse.Namespace) -> None:
    notes = [note.in_(language()) for note in made.notes]
    if options.json:
        print_json({"program": made.text, "addresses": dict(made.addresses), "notes": notes})
        return
    print(made.text, end="")
    for note in notes:
        print(f"// {say('注意', 'note')}: {note}")
