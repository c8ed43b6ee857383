"""The other questions about a random ladder: predict the stack, which blocks, put in order, which ladder."""

from __future__ import annotations

from dataclasses import replace
from string import ascii_uppercase
from typing import TYPE_CHECKING

from plcteach.check.against import verdict_on
from plcteach.check.drilling.slips import joins, slips
from plcteach.check.drilling.told import TITLES, task
from plcteach.check.kinds import KINDS
from plcteach.check.lint import lint
from plcteach.core.errors import NotRepresentableError, PlcTeachError
from plcteach.core.exercise import WrongSample
from plcteach.core.text import Text, language
from plcteach.figure.table import telling_inputs
from plcteach.ladder.lift import lift
from plcteach.ladder.picture import write_drawing
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Callable

    from plcteach.check.drilling.dice import Dice
    from plcteach.core.exercise import Exercise
    from plcteach.core.program import Program

__all__ = ["ASKED", "TITLES"]

_CHOICES = 4
_DISTRACTORS = 2
_OTHER = Text("这是另一个答案。", "This is another answer.")


def predict(plain: Exercise, program: Program, dice: Dice) -> Exercise:
    """Ask what is on the stack after each instruction of one scan."""
    inputs = telling_inputs(program)
    scan = {address: value if dice.falls(0.6) else dice.number(0, 1) for address, value in inputs.items()}
    made = replace(
        plain, kind="predict", task=task("predict", program.dialect), given=program.source, scans=(scan,),
        hints=_AT_EACH_LINE, right=(), wrong=(), needs=(),
    )  # fmt: skip
    rows = KINDS["predict"].model(made).splitlines()
    turned = [row.translate(_TURNED) for row in rows]
    told = [number for number, row in enumerate(rows) if turned[number] != row]
    if not told:
        raise PlcTeachError(_NO_VALUE.in_(language()))
    places = dict.fromkeys((told[0], told[-1], told[len(told) // 2]))
    grids = [[*rows[:at], turned[at], *rows[at + 1 :]] for at in places]
    wrong = [WrongSample("\n".join(grid), "different", _OTHER) for grid in (*grids, turned, [])]
    line, value = program.lines[told[0]].text, rows[told[0]]
    first = Text(
        f"第{told[0] + 1}条指令{line}以后，是{value}。", f"After instruction {told[0] + 1}, {line}, it is {value}."
    )
    return replace(made, hints=(*_AT_EACH_LINE, first), right=("\n".join(rows),), wrong=tuple(wrong[:3]))


_NO_VALUE = Text(
    "运行时栈上没有任何值，所以没有什么可问的。", "Nothing stands on the stack as it runs, so there is nothing to ask."
)
_TURNED = str.maketrans("01", "10")
_AT_EACH_LINE = (
    Text(
        "对每条指令问两个问题：它从栈里取几个值，又放回几个？",
        "Ask two questions of each instruction: how many values does it take, and how many does it give back?",
    ),
)


def join(plain: Exercise, program: Program, dice: Dice) -> Exercise:
    """Ask which two blocks a join joins."""
    rows = [number for number, line in enumerate(program.lines, 1) if _joins(program, number)]
    if not rows:
        raise PlcTeachError(_NO_JOIN.in_(language()))
    row = dice.pick(rows[1:] or rows)
    made = replace(
        plain, kind="join", task=task("join", program.dialect, row), given=program.source, row=row, right=(), wrong=(), needs=(),
    )  # fmt: skip
    answer = KINDS["join"].model(made)
    upper, lower = (tuple(map(int, one.split("-"))) for one in answer.split())
    others = (
        f"{upper[0]}-{lower[0]} {lower[0]}-{lower[1]}",
        f"1-{row - 1} {row}-{row}",
        f"{row}-{row} {row - 1}-{row - 1}",
    )
    hints = (
        Text(
            "连接指令总是连接它上面最近的两个已经完成的块。", "A join takes the two nearest finished blocks above it."
        ),
        Text(
            f"两块里靠下的那一块，最后一条是第{lower[1]}条指令。",
            f"The lower of the two blocks ends with instruction {lower[1]}.",
        ),
    )
    wrong = tuple(WrongSample(one, "different", _OTHER) for one in others)
    return replace(made, hints=hints, right=(answer, " ".join(answer.split()[::-1])), wrong=wrong)


_NO_JOIN = Text(
    "这里没有块连接，所以没有什么可问的。请用一个有两个块并联或串联的梯形图。",
    "There is no join of blocks in this, so there is nothing to ask. Take a ladder in which two blocks stand side by side or in a row.",
)


def _joins(program: Program, number: int) -> bool:
    """Say whether an instruction, counted from 1, joins two blocks; where parentheses do, it is the one that closes."""
    line = program.lines[number - 1]
    return line.insn.mnemonic == ")" or (not line.insn.close and line in joins(program))


def order(plain: Exercise, program: Program, dice: Dice) -> Exercise:
    """Ask for the order of the lines, some of which do not belong."""
    own = [line.text for line in program.lines]
    others = [
        line.text for one in slips(program) for line in read(one.text, program.dialect).lines if line.text not in own
    ]
    chosen = dice.mixed(dict.fromkeys(others))[:_DISTRACTORS]
    made = replace(
        plain, kind="order", task=task("order", program.dialect), distractors=tuple(chosen), right=plain.right[:1]
    )
    model = made.right[0]
    rows = [row for row in model.split("\n") if row.strip()]
    backwards = "\n".join([*rows[:-2], rows[-1], rows[-2]])
    because = Text("把最后两行写反了。", "Has the last two lines the wrong way round.")
    short = Text("少写了最后一行。", "Leaves the last line out.")
    wrong = (
        WrongSample("\n".join(rows[:-1]), _expected(program, "\n".join(rows[:-1])), short),
        WrongSample(backwards, _expected(program, backwards), because),
        WrongSample(f"{model.rstrip()}\n{rows[-1]}", "KND003", Text("同一行用了两次。", "Uses a line twice.")),
    )
    return replace(made, wrong=wrong)


def _expected(program: Program, text: str) -> str:
    found = lint(read(text, program.dialect))
    wrong = [one for one in found if one.severity == "error"]
    return wrong[0].code if wrong else "different"


def match(plain: Exercise, program: Program, dice: Dice) -> Exercise:
    """Ask which of some ladders a list is."""
    choices = [plain.reference]
    for one in slips(program):
        drawing = _drawn(read(one.text, program.dialect))
        if one.sure and drawing and drawing not in choices and _does_something_else(plain, program, one.text):
            choices.append(drawing)
        if len(choices) == _CHOICES:
            break
    if len(choices) < 2:  # noqa: PLR2004 (one is no choice)
        raise PlcTeachError(_NO_OTHER.in_(language()))
    mixed = dice.mixed(choices)
    right = ascii_uppercase[mixed.index(plain.reference)]
    letters = [letter for letter in ascii_uppercase[: len(mixed)] if letter != right]
    hints = (
        Text("一条一条地读，每读一条就画一个触点。", "Read line by line, and draw a contact for each."),
        Text(f"不是{letters[0]}。", f"It is not {letters[0]}."),
    )
    wrong = tuple(WrongSample(letter, "different", _OTHER) for letter in letters)
    return replace(
        plain, kind="match", task=task("match", program.dialect), given=program.source, choices=tuple(mixed), hints=hints,
        right=(right, str(ascii_uppercase.index(right) + 1)), wrong=wrong, needs=(),
    )  # fmt: skip


_NO_OTHER = Text(
    "没有找到另一个像它的梯形图可供选择。",
    "No other ladder was found that is like it, so there is nothing to choose from.",
)


def _does_something_else(plain: Exercise, program: Program, text: str) -> bool:
    return verdict_on(program, read(text, program.dialect), plain.terms).status == "different"


def _drawn(program: Program) -> str:
    """Draw a list, if it is a ladder without a remark."""
    if lint(program):
        return ""
    lifted = lift(program)
    try:
        return "" if lifted.diagnostics or not lifted.rungs else write_drawing(lifted.ladder)
    except NotRepresentableError:
        return ""


ASKED: dict[str, Callable[[Exercise, Program, Dice], Exercise]] = {
    "predict": predict,
    "join": join,
    "order": order,
    "match": match,
}
"""How each question is made of the plain exercise and its list."""
