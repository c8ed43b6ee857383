"""Writes an exercise as a TOML file that a teacher goes on from, with a remark wherever something waits to be said better."""

from __future__ import annotations

import json
import re
from typing import TYPE_CHECKING, Any

from plcteach.core.text import NOTHING, Text, language
from plcteach.ladder.telling import is_drawing

if TYPE_CHECKING:
    from collections.abc import Iterator

    from plcteach.core.exercise import Exercise

ENOUGH_WRONG = 3
_HEAD = Text(
    "这个练习是从一个梯形图或指令表生成的。改完以后用 plcteach exercise test 这个文件 检查。",
    "Drafted from a ladder or a list. When you have changed it, prove it: plcteach exercise test THIS FILE",
)
_ORDER = Text(
    "在课程里的次序；lesson是第几课；after是应先做的练习。",
    "Its place in the course; lesson: of which lesson; after: exercises to be done before.",
)
_SAID = Text("改成您自己的话。两种语言都要写。", "Say it in your own words, in both languages.")
_HIDDEN = Text(
    "考试用：参考在哪里都不显示，所以题目要用文字说清程序该做什么。",
    "For an examination: the reference is shown nowhere, so the task must say in words what the program is to do.",
)
_HINTS = Text(
    "从含糊到几乎是答案。下面的数都是从参考数出来的。",
    "From vague to nearly the answer. What is counted here was counted off the reference.",
)
_RIGHT = Text(
    "每一个都要得满分。再加一种您学生常用的写法。",
    "Each must get full marks. Add another way in which your learners write it.",
)
_FEW_RIGHT = Text("只找到一种正确的写法，请再加一种。", "Only one right way was found; please add another.")
_WRONG = Text(
    "每一个都要因所写的原因被拒绝：expect是different或一个诊断编号；because是写它的人怎么想的。",
    "Each must be refused for the stated reason: expect is different or the code of a finding; because: what its writer believed.",
)
_FEW_WRONG = Text(
    "错误的写法找到的不多，最好有三个；请加上您的学生常犯的错误。",
    "Few wrong ways were found, and three would be better; please add the mistakes that your learners make.",
)
_NO_LADDER = Text(
    "这段程序画不成梯形图，学生看不到图；题目要用文字说清程序该做什么。",
    "This program cannot be drawn, so no ladder is shown: the task must say in words what the program is to do.",
)
_LEVEL = Text("有沿，所以每个扫描都比较。", "There are edges, so it is compared at the end of every scan.")


def toml(one: Exercise) -> str:
    """Write an exercise as TOML, with remarks in the language in force."""
    return "".join(f"{row}\n" for row in _rows(one))


def _rows(one: Exercise) -> Iterator[str]:
    yield from (_remark(_HEAD), "", _remark(_ORDER), f"order = {one.order}", "# lesson = 5", "# after = []")
    yield from (f"kind = {_text(one.kind)}", f"dialect = {_text(one.dialect)}", f"points = {one.points:g}")
    if one.terms.level != "either":
        yield from (_remark(_LEVEL), f"level = {_text(one.terms.level)}")
    yield from (_remark(_HIDDEN), "# hidden = true", "", _remark(_SAID))
    if one.kind in {"write", "order"} and not is_drawing(one.reference):
        yield _remark(_NO_LADDER)
    yield from (f"title = {_pair(one.title)}", f"task = {_pair(one.task)}", "")
    yield from _material(one)
    yield from (_remark(_HINTS), "hints = [", *(f"    {_pair(hint)}," for hint in one.hints), "]", "")
    yield _remark(_RIGHT if len(one.right) > 1 else _FEW_RIGHT)
    for text in one.right:
        yield from ("[[right]]", f"program = {_long(text)}", "")
    yield _remark(_WRONG)
    if len(one.wrong) < ENOUGH_WRONG:
        yield _remark(_FEW_WRONG)
    for sample in one.wrong:
        yield from ("[[wrong]]", f"expect = {_text(sample.expect)}")
        if sample.misconception:
            yield f"misconception = {sample.misconception}"
        yield from (f"because = {_pair(sample.because)}", f"program = {_long(sample.program)}", "")


def _material(one: Exercise) -> Iterator[str]:
    """Give what a learner works on."""
    yield from (f"reference = {_long(one.reference)}", "")
    for name in ("given", "start"):
        text: str = getattr(one, name)
        if text.strip():
            yield from (f"{name} = {_long(text)}", "")
    if one.row:
        yield f"row = {one.row}"
    if one.scans:
        yield from ("scans = [", *(f"    {_table(row)}," for row in one.scans), "]")
    for name in ("choices", "distractors"):
        texts: tuple[str, ...] = getattr(one, name)
        if texts:
            yield from (f"{name} = [", *(f"{_several(text)}," for text in texts), "]")


def _several(words: str) -> str:
    return _long(words) if len(words.splitlines()) > 1 else _text(words)


def _remark(words: Text) -> str:
    return f"# {words.in_(language())}"


def _pair(words: Text) -> str:
    return f"{{ zh = {_text(words.zh)}, en = {_text(words.en)} }}" if words != NOTHING else '{ zh = "", en = "" }'


def _table(row: Any) -> str:
    return f"{{ {', '.join(f'{_text(key)} = {int(value)}' for key, value in row.items())} }}" if row else "{}"


def _text(words: str) -> str:
    return json.dumps(words, ensure_ascii=False).replace("\x7f", "\\u007f")


_ODD = re.compile(r"[\x00-\x08\x0b-\x1f\x7f]")


def _long(words: str) -> str:
    """Write several rows between three quotation marks; what cannot stand there is escaped."""
    body = words.replace("\\", "\\\\").replace('"""', '""\\"')
    body = _ODD.sub(lambda found: f"\\u{ord(found[0]):04x}", body.strip("\n"))
    return f'"""\n{body}\n"""'
