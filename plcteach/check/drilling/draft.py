"""An exercise drafted from a teacher's own ladder or list, with samples that have been judged and hints that have been counted."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from itertools import islice
from typing import TYPE_CHECKING

from plcteach.check.against import reference
from plcteach.check.drilling.asked import ASKED
from plcteach.check.drilling.courses import course
from plcteach.check.drilling.dice import Dice
from plcteach.check.drilling.samples import inverted_twice, right_lists
from plcteach.check.drilling.slips import slips
from plcteach.check.drilling.told import TITLES, has_edges, hints, subject, task
from plcteach.check.kinds import KINDS
from plcteach.core.diagnostic import errors
from plcteach.core.errors import NotRepresentableError, PlcTeachError
from plcteach.core.exercise import Exercise, Terms, WrongSample
from plcteach.core.ladder import Ladder
from plcteach.core.text import Text, language
from plcteach.ladder.either import ladder_either
from plcteach.ladder.picture import write_drawing
from plcteach.ladder.telling import is_drawing, is_plcopen
from plcteach.stl import read, write

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from plcteach.core.program import Program
    from plcteach.core.spec import Dialect

ENOUGH, MOST_TRIED = 4, 16
FEW_RIGHT, MOST_DETOURS = 2, 4
BLANK = "____"
_NO_PROOF = Text(
    "这段程序连与它自己相同也无法证明，所以也判不了学生的答案。请把它分成几个小的练习。",
    "Not even this program itself can be proved to do what it does, so no answer could be. Make several smaller exercises of it.",
)
_IN_WORDS = Text("请写出完成下面功能的{list}：……", "Write the {list} of a program that does this: …")
_NO_FAULT = Text(
    "没有找到只有一处错误、能运行而作用不同的写法，所以没有什么可改正的。",
    "No list with one thing wrong was found that runs and does something else, so there is nothing to mend.",
)
_NO_ADDRESS = Text("忘了写地址。", "Forgets the address.")
_LEFT_SO = Text("原样交了回来，没有改。", "Is handed in as it was given, with nothing changed.")
_TURNED = str.maketrans("01#_", "10_#")


def draft(text: str, dialect: Dialect, kind: str, name: str) -> Exercise:
    """Make an exercise of a drawing or a list; PlcTeachError says what is wrong with it, or why it does not make this kind."""
    ladder, drawing = _ladder(text, dialect)
    wanted = reference(drawing or text, dialect)
    program = read(write(wanted), dialect)
    plain = Exercise(
        name, dialect.name, TITLES[subject(program)], task("write", dialect), drawing or text,
        hints=hints(program), terms=Terms(level="exact" if has_edges(program) else "either"),
    )  # fmt: skip
    plain = replace(plain, right=tuple(_rights(plain, ladder, program)))
    if program.source not in plain.right:
        raise PlcTeachError(_NO_PROOF.in_(language()))
    told = plain.task if drawing else _IN_WORDS.format(list=dialect.list)
    plain = replace(plain, task=told, wrong=tuple(_wrongs(plain, program)))
    made = plain if kind == "write" else DRAFTED[kind](plain, program, Dice(drawing or text))
    return replace(made, wrong=tuple(_refused(made)))


def _ladder(text: str, dialect: Dialect) -> tuple[Ladder, str]:
    """Give the ladder of a text and its drawing; none where a list is no ladder, and PlcTeachError where it does not read."""
    given = ladder_either(text, dialect)
    for one in errors(given.found):
        msg = f"row {one.span.row}: {one.text.in_(language())}"
        raise PlcTeachError(msg)
    if not given.ladder.rungs:
        return Ladder(()), ""
    if is_drawing(text):
        return given.ladder, text
    ladder = replace(given.ladder, configuration=given.ladder.configuration or given.configuration)
    return (ladder, write_drawing(ladder)) if is_plcopen(text) or not given.found else (Ladder(()), "")


def _rights(plain: Exercise, ladder: Ladder, program: Program) -> Iterator[str]:
    """Give right lists, each judged: the list itself, others of its ladder, and where it has none the list with a detour in it."""
    found = [program.source]
    if ladder.rungs:
        with suppress(NotRepresentableError):
            found += right_lists(ladder, program.dialect)
    detours = islice(inverted_twice(program), MOST_DETOURS)
    count = 0
    for number, text in enumerate(dict.fromkeys((*found, *detours))):
        if (number < len(found) or count < FEW_RIGHT) and _is_right(plain, text):
            count += 1
            yield text


def _is_right(exercise: Exercise, text: str) -> bool:
    judged = KINDS[exercise.kind].judged(exercise, text)
    return judged.verdict.status == "equal" and judged.marks == exercise.points


def _wrongs(exercise: Exercise, program: Program) -> Iterator[WrongSample]:
    """Give wrong lists, each judged: first one for each reason, then others."""
    some = slips(program)
    first = {one.because: one for one in reversed(some)}
    telling = [one for one in some if first[one.because] is one]
    count = 0
    for one in [*telling, *(one for one in some if one not in telling)][:MOST_TRIED]:
        expected = _expected(exercise, one.text)
        if expected and count < ENOUGH:
            count += 1
            yield WrongSample(one.text, expected, one.because, one.misconception)
    if count < ENOUGH - 1:
        bare = f"{program.dialect.roles['load']}\n{program.source}"
        yield WrongSample(bare, _expected(exercise, bare), _NO_ADDRESS)


def _expected(exercise: Exercise, answer: str) -> str:
    """Give how an answer is refused: by the code of a finding, else as different; "" where it is not refused for sure."""
    judged = KINDS[exercise.kind].judged(exercise, answer)
    if judged.marks >= exercise.points or judged.verdict.status in {"equal", "unknown"}:
        return ""
    found = judged.verdict.diagnostics
    told = errors(found) or [one for one in found if one.severity == "warning" and one.code.startswith("STK")]
    return told[0].code if told else judged.verdict.status


def _refused(exercise: Exercise) -> Iterator[WrongSample]:
    """Give the wrong samples that are refused for sure, each with what it is refused for."""
    for one in exercise.wrong:
        expected = _expected(exercise, one.program)
        if expected:
            yield replace(one, expect=expected)


# the kinds


def _bug(plain: Exercise, program: Program, _dice: Dice) -> Exercise:
    """Let the first wrong list that does something else be mended."""
    start = next((one.program for one in plain.wrong if one.expect == "different"), "")
    if not start:
        raise PlcTeachError(_NO_FAULT.in_(language()))
    words = Text(
        f"这段{program.dialect.list.zh}里有一处错误，请改正。",
        f"There is one fault in this {program.dialect.list.en}. Mend it.",
    )
    because = next(one.because for one in plain.wrong if one.program == start)
    asis = WrongSample(start, "different", _LEFT_SO)
    wrong = (asis, *(one for one in plain.wrong if one.program != start))
    told = Text(f"写它的人：{because.zh}", f"Whoever wrote it: {because.en}")
    return replace(plain, kind="bug", task=words, start=start, wrong=wrong, hints=(*plain.hints[:1], told))


def _complete(plain: Exercise, program: Program, dice: Dice) -> Exercise:
    """Leave a line out, one that is no output."""
    rows = [line.span.row for line in program.lines[1:] if not line.insn.then] or [program.lines[0].span.row]
    gap = dice.pick(rows)
    lines = program.source.split("\n")
    start = "\n".join([*lines[: gap - 1], BLANK, *lines[gap:]])
    words = Text("把缺的一行补上。", "Fill in the line that is missing.")
    made = replace(plain, kind="complete", task=words, start=start, hints=plain.hints[:-1])
    rights = tuple(one for one in plain.right if _is_right(made, one))
    empty = "\n".join([*lines[: gap - 1], *lines[gap:]])
    samples = [WrongSample(empty, _expected(made, empty), _LEFT_SO)]
    samples += [
        WrongSample(one.program, _expected(made, one.program), one.because, one.misconception) for one in plain.wrong
    ]
    return replace(made, right=rights, wrong=tuple(one for one in samples if one.expect))


def _chart(plain: Exercise, program: Program, dice: Dice) -> Exercise:
    """Ask in which scans the outputs are on."""
    words = Text("每个扫描结束时，输出是接通还是断开？", "At the end of each scan, is the output on or off?")
    made = replace(
        plain,
        kind="chart",
        task=words,
        given=program.source,
        scans=course(program, dice),
        right=(),
        wrong=(),
        hints=_CHARTED,
    )
    answer = KINDS["chart"].model(made)
    turned = "\n".join(
        f"{row.partition(' ')[0]} {row.partition(' ')[2].translate(_TURNED)}" for row in answer.splitlines()
    )
    because = Text("接通和断开弄反了。", "Has on and off the wrong way round.")
    return replace(made, right=(answer,), wrong=(WrongSample(turned, "different", because),))


_CHARTED = (
    Text(
        "一个扫描一个扫描地做：先写下这个扫描的输入。", "Go scan by scan, and write down the inputs of that scan first."
    ),
    Text("没有再提到的输入保持原来的值。", "An input that is not named again keeps its value."),
)

DRAFTED: dict[str, Callable[[Exercise, Program, Dice], Exercise]] = {
    **ASKED,
    "bug": _bug,
    "complete": _complete,
    "chart": _chart,
}
"""How each kind is made of the plain exercise and its list."""
