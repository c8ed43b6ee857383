"""Proves an exercise by its own samples: what is right is accepted, what is wrong refused for its reason, and no hint lies.

Used by a teacher at the command line and by the tests of the bundled exercises alike.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from plcteach.check.drilling.claims import claims
from plcteach.check.hints import mended
from plcteach.check.judge import judge, model, reference, shown
from plcteach.core.diagnostic import RULES, errors
from plcteach.core.errors import PlcTeachError
from plcteach.core.text import NOTHING, Text, language
from plcteach.dialects import dialect
from plcteach.ladder.picture import read_drawing
from plcteach.ladder.telling import is_drawing
from plcteach.stl import read

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from plcteach.check.judgement import Judgement
    from plcteach.core.exercise import Exercise, WrongSample

State = Literal["proved", "failed", "note"]
FEW_RIGHT, FEW_WRONG, FEW_HINTS = 2, 3, 2
MOST_SEARCHED = 60
"""So many lines of wrong lists are searched for a repair; the list that goes beyond is the last."""
_LISTS = ("write", "complete", "bug", "translate", "order")
_CHINESE = re.compile(r"[\u4e00-\u9fff]")


@dataclass(frozen=True, slots=True)
class Proof:
    """One thing that was looked at: what it is, how it came out, and what there is to say."""

    what: Text
    state: State
    says: Text = NOTHING

    def __repr__(self) -> str:
        return f"{self.what.en}: {self.state}{f' ({self.says.en})' if self.says.en else ''}"


def proofs(
    exercise: Exercise, known: Mapping[str, Exercise] | None = None, *, repairs: bool = True
) -> tuple[Proof, ...]:
    """Look at everything that makes an exercise sound; `known`: the exercises that it may build on, by their ids.

    repairs: whether the edits that a learner is led to are searched for and followed too, which takes longest.
    """
    found: list[Proof] = []
    looks = (_words, _drawing, _material, _model, _start, _right, _wrong, _after, _hints, _repairs)
    for look in looks if repairs else looks[:-1]:
        try:
            found += look(exercise, known or {})
        except PlcTeachError as trouble:
            found.append(Proof(_NAMES[look.__name__], "failed", Text(str(trouble), str(trouble))))
    return tuple(found)


def proved(some: tuple[Proof, ...]) -> bool:
    """Say whether nothing failed; a note is only advice."""
    return all(one.state != "failed" for one in some)


def sound(made: Exercise) -> Exercise:
    """Give a drafted exercise back if it proves itself; PlcTeachError says what of it does not."""
    bad = next((one for one in proofs(made, repairs=False) if one.state == "failed"), None)
    if bad:
        raise PlcTeachError(_NOT_SOUND.format(what=bad.what, says=bad.says).in_(language()))
    return made


_NOT_SOUND = Text(
    "从这里没有得到能证明自己的练习（{what}：{says}）。请换一种题型，或改一改程序。",
    "No exercise that proves itself came of this ({what}: {says}). Try another kind, or change the program.",
)
_Known = "Mapping[str, Exercise]"
_NAMES: dict[str, Text] = {
    "_words": Text("两种语言", "both languages"),
    "_drawing": Text("参考", "the reference"),
    "_material": Text("题目材料", "the material"),
    "_model": Text("标准答案", "the model answer"),
    "_start": Text("起始内容", "the start"),
    "_right": Text("正确样本", "right samples"),
    "_wrong": Text("错误样本", "wrong samples"),
    "_after": Text("先修练习", "prerequisites"),
    "_hints": Text("提示", "hints"),
    "_repairs": Text("改正提示", "hints by repair"),
}


def _put(name: str, number: int = 0) -> Text:
    what = _NAMES[name]
    return Text(f"{what.zh} {number}", f"{what.en} {number}") if number else what


def _plain(zh: str, en: str) -> Text:
    return Text(zh, en)


def _words(exercise: Exercise, _known: Mapping[str, Exercise]) -> Iterator[Proof]:
    """Look for a sentence that is missing, or stands in the wrong language; a list reads alike in both."""
    said = {"title": exercise.title, "task": exercise.task}
    said |= {f"hint {number}": one for number, one in enumerate(exercise.hints, 1)}
    said |= {f"because {number}": one.because for number, one in enumerate(exercise.wrong, 1)}
    bad = [
        name
        for name, one in said.items()
        if not (one.zh.strip() and one.en.strip())
        or _CHINESE.search(one.en)
        or not (_CHINESE.search(one.zh) or one.zh == one.en)
    ]
    names = ", ".join(bad)
    trouble = _plain(f"缺一种语言，或写错了语言：{names}", f"a language is missing, or is the other one: {names}")
    yield Proof(_put("_words"), "failed" if bad else "proved", trouble if bad else NOTHING)


def _drawing(exercise: Exercise, _known: Mapping[str, Exercise]) -> Iterator[Proof]:
    """Read the drawing and the list that it becomes."""
    family = dialect(exercise.dialect)
    for text in (exercise.reference, *exercise.choices):
        if is_drawing(text):
            found = errors(read_drawing(text)[1])
            if found:
                yield Proof(_put("_drawing"), "failed", found[0].text)
                return
    if exercise.kind in {"write", "complete", "bug", "order"}:
        program = reference(exercise.reference, family)
        count = len(program.lines)
        yield Proof(_put("_drawing"), "proved", _plain(f"{count}条指令", f"{count} instructions"))
    else:
        yield Proof(_put("_drawing"), "proved")


def _material(exercise: Exercise, _known: Mapping[str, Exercise]) -> Iterator[Proof]:
    """Make what a learner sees before answering."""
    sheet = shown(exercise)
    yield Proof(_put("_material"), "proved", _plain(sheet.form, sheet.form))
    told = exercise.task
    if exercise.hidden and sheet.form == "list" and not sheet.ladders and ("ladder" in told.en or "梯形图" in told.zh):
        yield Proof(_put("_material"), "note", _NOT_SHOWN)


_NOT_SHOWN = Text(
    "题目提到梯形图，而这是考试用的练习，梯形图不显示。请用文字说明程序该做什么。",
    "The task speaks of a ladder, and a hidden exercise shows none. Say in words what the program is to do.",
)


def _model(exercise: Exercise, _known: Mapping[str, Exercise]) -> Iterator[Proof]:
    judged = judge(exercise, model(exercise))
    yield Proof(_put("_model"), "proved" if _full(judged) else "failed", _status(judged))


def _start(exercise: Exercise, _known: Mapping[str, Exercise]) -> Iterator[Proof]:
    if exercise.start.strip():
        judged = judge(exercise, exercise.start)
        yield Proof(_put("_start"), "failed" if _full(judged) else "proved", _status(judged))


def _right(exercise: Exercise, _known: Mapping[str, Exercise]) -> Iterator[Proof]:
    """Judge the right samples; each wants full marks."""
    for number, text in enumerate(exercise.right, 1):
        judged = judge(exercise, text)
        yield Proof(_put("_right", number), "proved" if _full(judged) else "failed", _status(judged))
    yield from _few("_right", len(exercise.right), FEW_RIGHT)


def _wrong(exercise: Exercise, _known: Mapping[str, Exercise]) -> Iterator[Proof]:
    """Judge the wrong samples; each wants the verdict or the finding that it promises."""
    for number, sample in enumerate(exercise.wrong, 1):
        judged = judge(exercise, sample.program)
        yield Proof(
            _put("_wrong", number),
            "proved" if refused_as_promised(judged, sample) else "failed",
            _reason(judged, sample),
        )
    yield from _few("_wrong", len(exercise.wrong), FEW_WRONG)


def _few(name: str, count: int, enough: int) -> Iterator[Proof]:
    if not count:
        yield Proof(_put(name), "failed", _plain("一个也没有", "there is none"))
    elif count < enough:
        yield Proof(
            _put(name),
            "note",
            _plain(f"只有{count}个，最好有{enough}个", f"only {count}, and {enough} would be better"),
        )


def refused_as_promised(judged: Judgement, sample: WrongSample) -> bool:
    """Say whether an answer lost marks for the reason that its sample gives."""
    if judged.marks >= judged.exercise.points:
        return False
    codes = {one.code for one in judged.verdict.diagnostics}
    if sample.expect in RULES:
        return sample.expect in codes
    return judged.verdict.status == sample.expect


def _full(judged: Judgement) -> bool:
    return judged.verdict.status == "equal" and judged.marks == judged.exercise.points


def _status(judged: Judgement) -> Text:
    verdict = judged.verdict
    codes = " ".join(dict.fromkeys(one.code for one in verdict.diagnostics))
    said = f"{verdict.status}{f' ({verdict.proof})' if verdict.proof else ''} {judged.marks:g}/{judged.exercise.points:g} {codes}"
    more = "; ".join(one.en for one in judged.says)
    return _plain(f"{said} {'；'.join(one.zh for one in judged.says)}".strip(), f"{said} {more}".strip())


def _reason(judged: Judgement, sample: WrongSample) -> Text:
    got = _status(judged)
    return _plain(f"应为{sample.expect}：{got.zh}", f"promised {sample.expect}: {got.en}")


def _after(exercise: Exercise, known: Mapping[str, Exercise]) -> Iterator[Proof]:
    """Look for the exercises that are to be done before."""
    missing = [name for name in exercise.after if name not in known]
    late = [name for name in exercise.after if name in known and known[name].order > exercise.order]
    if missing:
        names = ", ".join(missing)
        yield Proof(_put("_after"), "failed", _plain(f"没有这样的练习：{names}", f"there is no exercise {names}"))
    if late:
        names = ", ".join(late)
        yield Proof(_put("_after"), "failed", _plain(f"排在后面：{names}", f"comes later: {names}"))
    if exercise.after and not missing and not late:
        yield Proof(_put("_after"), "proved", _plain(", ".join(exercise.after), ", ".join(exercise.after)))


# hints


def _hints(exercise: Exercise, _known: Mapping[str, Exercise]) -> Iterator[Proof]:
    """Hold what the hints count and name against the answers that are right."""
    texts = (model(exercise), *exercise.right) if exercise.kind in _LISTS else ()
    programs = [read(text, exercise.dialect) for text in texts]
    for number, claim in enumerate(claims(exercise, programs), 1):
        yield Proof(_put("_hints", number), *claim)
    count = len(exercise.hints)
    if count < FEW_HINTS:
        yield Proof(_put("_hints"), "note", _plain(f"只有{count}个", f"only {count}"))


def _repairs(exercise: Exercise, _known: Mapping[str, Exercise]) -> Iterator[Proof]:
    """Follow the hint that a learner with a wrong list gets: mended by it the list does what it should.

    A list that is mended and still lacks what the task asks for is worth a note. Work is counted: long lists are not all searched.
    """
    lines = 0
    for number, sample in enumerate(exercise.wrong, 1) if exercise.kind in _LISTS else ():
        judged = judge(exercise, sample.program)
        if lines > MOST_SEARCHED:
            left = len(exercise.wrong) - number + 1
            yield Proof(_put("_repairs"), "proved", _plain(f"还有{left}个没有查", f"{left} more were not searched"))
            return
        lines += len(judged.program.lines) if judged.program else 0
        found = mended(judged)
        if found:
            after = judge(exercise, found.edit.text)
            state: State = "proved" if _full(after) else "note" if after.verdict.status == "equal" else "failed"
            yield Proof(_put("_repairs", number), state, _status(after))
