"""The exercise books, one a family, and the concept test: notebooks made from the catalogue, so that no exercise is listed twice by hand."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import nbformat
from lesson_ends import families_of, lesson_of, woven
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from plcteach.check.drilling.told import TITLES
from plcteach.core.text import Text
from plcteach.dialects import dialect, names
from plcteach.exercises import concept_test, exercise, ids
from plcteach.widgets.progress import KINDS

if TYPE_CHECKING:
    from plcteach.core.exercise import Exercise

FOLDER = Path(__file__).resolve().parents[2] / "notebooks"
LANGUAGES = ("en", "zh")
OTHER = {"en": ("zh", "中文版"), "zh": ("en", "English")}
CONCEPT = "concept-test.ipynb"
INDEX = "index.ipynb"
_BOOK = "exercises-"

FIRST = 'import plcteach as plc\n\nplc.language("{lang}")'
DRILLS = {
    "contacts": "write",
    "blocks": "join",
    "branches": "predict",
    "set-reset": "match",
    "edges": "write",
    "timers": "order",
    "counters": "write",
}
"""What is asked in a book's drill of each kind, so that a learner sees every question once."""

BOOK_HEAD = Text(
    """# 练习册 · {title}

*{count}道练习 · {list} · [{other}](../{folder}/{name}) · [全部课程](../index.ipynb)*

这里是{title}的全部练习，按课排列，每一课里由易到难。没运行时，每道题就像印在纸上一样。先运行下面第一个灰色单元，再运行想做的那道题的单元（Shift+Enter），练习台就打开：写出答案，按“检查”；做不下去时，可以要提示。

- **想做哪道就运行哪道。** 写着“先做”的，是这道题要用到的题。“运行全部单元”会把{count}个练习台一起打开，要等一会儿，也没有必要。
- **写过的不会丢。** 答案、检查次数、最好成绩和用过的提示，记在笔记本旁边的小文件`.plcteach-progress.json`里，下次打开还在；不想要了，删掉这个文件就从头开始。""",
    """# Exercises · {title}

*{count} exercises · {list} · [{other}](../{folder}/{name}) · [all lessons](../index.ipynb)*

Here are all exercises for the {title}, lesson by lesson, and within a lesson from easy to hard. Until you run it, an exercise stands there as it would on paper. Run the first grey cell below, then the cell of the exercise you want to do (Shift+Enter), and its desk opens: write your answer, press *Check*, and ask for a hint when you are stuck.

- **Run the ones you want to do.** *First* names the exercises that this one builds on. "Run All Cells" opens all {count} desks at once, which takes a while and is no use to you.
- **What you write is kept.** Answers, attempts, best marks and hints used stand in a small file beside the notebook, `.plcteach-progress.json`, and are there again next time; delete that file to begin afresh.""",
)
FAR = Text(
    "## 做到哪里了\n\n✓是满分，…是做过还没有满分。做了几道以后，再运行一次这个单元。",
    "## How far you are\n\n✓ is full marks, … is begun. Run this cell again after an exercise or two.",
)
LESSON = Text("## 第{title}\n\n[打开这一课]({name})", "## Lesson {title}\n\n[Open the lesson]({name})")
ASKS = Text(
    "### {title}\n\n`{id}` · {kind} · {points:g}分{after}", "### {title}\n\n`{id}` · {kind} · {points:g} points{after}"
)
AFTER = Text(" · 先做：{titles}", " · First: {titles}")
QUOTED = Text("“{title}”{place}", "*{title}*{place}")
FURTHER_DOWN = Text("（第{lesson}课，在后面）", " (lesson {lesson}, further down)")
DRILL_HEAD = Text(
    """## 做不完的题

下面的题是随机出的，每一种先给一道。把`seed`换成别的数，就是另一道题；`level`从1（容易）到5；`ask`是要做什么：`"write"`写程序，`"predict"`预测堆栈，`"order"`排序，`"match"`选梯形图，电路块还可以问`"join"`连接哪两块。同样的数在哪台电脑上都是同一道题，所以可以和同学比一比。""",
    """## More, without end

These exercises are random; here is one of each kind. Another `seed` is another exercise. `level` goes from 1 (easy) to 5. `ask` is what you do with it: `"write"` the list, `"predict"` the stack, put lines in `"order"`, `"match"` list and ladder, or, with blocks, say which two a join joins: `"join"`. The same numbers give the same exercise on every computer, so you can compare with others.""",
)
CONCEPT_TEXT = Text(
    """# 概念测验

*{count}道小题，课前课后各做一次，每次约15分钟 · [English](../en/concept-test.ipynb) · [全部课程](../index.ipynb)*

**上第0课以前**做一次，**学完第13课以后**再做一次。题目问的都是几乎人人起初会想错的地方。第一次做，不会的就凭感觉答，或者空着：不计成绩，空着也说明了问题。

第一次做完只告诉你答对几题，不说哪几题，免得第二次变成背答案；第二次做完，两次的结果并排列出来，还告诉你哪一题该再看哪一课。答案记在笔记本旁边的小文件里，中途关掉也不要紧。""",
    """# Concept test

*{count} short questions, before the course and after it, about 15 minutes each time · [中文版](../zh/concept-test.ipynb) · [all lessons](../index.ipynb)*

Take it once **before lesson 0** and once **after lesson 13**. Each question is about something that nearly everybody gets wrong at first. What you don't know the first time, guess or leave empty: there are no marks, and an empty answer tells something too.

The first time you are told how many were right, but not which, so that the second time still asks something. Then both results stand side by side, with the lesson to read again for each question. Your answers are kept in a small file beside the notebook, so you may stop at any question.""",
)
CONCEPT_RUN = Text("运行下面的单元，测验就从第1题开始。", "Run the cell below, and the test opens at question 1.")
CONCEPT_NEXT = Text(
    "**第一次做完？** 从[第0课]({first})开始。**第二次做完？** [首页](../index.ipynb)上有每个系列的练习册。",
    "**Done for the first time?** Begin with [lesson 0]({first}). **Done for the second time?** The [start page](../index.ipynb) has an exercise book for each family.",
)
BOOKS_HEAD = """## Exercises · 练习

Each lesson ends with some of its exercises; the books have them all. The concept test is for before lesson 0 and after lesson 13.

每一课的最后有几道练习，全部练习在练习册里。概念测验在第0课以前做一次，第13课以后再做一次。

| exercise book | 练习册 | exercises · 题数 |
|---|---|---|"""
BOOK_ROW = "| [{en}](en/{name}) | [{zh}](zh/{name}) | {count} |"
ANYWHERE = """Any exercise opens in any cell: `plc.desk("s7-two-blocks")`; how far you are: `plc.progress()`.

每道练习都可以在任何单元里打开：`plc.desk("s7-two-blocks")`；做到哪里了：`plc.progress()`。"""


def families() -> list[str]:
    """Name the families that have exercises, in the order of the house."""
    used = {exercise(name).dialect for name in ids()}
    return [name for name in names() if name in used]


def book_name(family: str) -> str:
    """Name a family's exercise book."""
    return f"{_BOOK}{family}.ipynb"


def lessons() -> dict[int, str]:
    """Give the lessons' files by their numbers."""
    return {lesson_of(path.name): path.name for path in sorted((FOLDER / "en").glob("[0-9]*.ipynb"))}


def title_of(lesson: int, lang: str) -> str:
    """Give a lesson's title from its own first line, with its number in front."""
    first = nbformat.read(FOLDER / lang / lessons()[lesson], 4).cells[0].source.splitlines()[0].removeprefix("# ")
    return first.replace(" · ", "课 · ", 1) if lang == "zh" else first


def exercises_of(family: str) -> dict[int, list[Exercise]]:
    """Give a family's exercises by lesson, each lesson's in teaching order."""
    found = [one for one in map(exercise, ids()) if one.dialect == family]
    return {lesson: [one for one in found if one.lesson == lesson] for lesson in sorted({one.lesson for one in found})}


def _heading(one: Exercise, lang: str) -> str:
    befores = []
    for other in map(exercise, one.after):
        place = FURTHER_DOWN.format(lesson=other.lesson).in_(lang) if other.lesson > one.lesson else ""
        befores.append(QUOTED.format(title=other.title, place=place).in_(lang))
    after = AFTER.in_(lang).format(titles=("" if lang == "zh" else ", ").join(befores)) if befores else ""
    return ASKS.in_(lang).format(
        title=one.title.in_(lang), id=one.id, kind=KINDS[one.kind].in_(lang), points=one.points, after=after
    )


def exercise_book(family: str, lang: str) -> Any:
    """Make a family's exercise book in one language."""
    groups, spec, (folder, other) = exercises_of(family), dialect(family), OTHER[lang]
    head = BOOK_HEAD.in_(lang).format(
        title=spec.title.in_(lang), list=spec.list.in_(lang), count=sum(map(len, groups.values())),
        other=other, folder=folder, name=book_name(family),
    )  # fmt: skip
    cells = [new_markdown_cell(head), new_code_cell(FIRST.format(lang=lang))]
    cells += [new_markdown_cell(FAR.in_(lang)), new_code_cell(f'plc.progress("{family}")')]
    for lesson, found in groups.items():
        cells.append(new_markdown_cell(LESSON.in_(lang).format(title=title_of(lesson, lang), name=lessons()[lesson])))
        for one in found:
            cells += [new_markdown_cell(_heading(one, lang)), new_code_cell(f'plc.desk("{one.id}")')]
    cells.append(new_markdown_cell(DRILL_HEAD.in_(lang)))
    for kind, ask in DRILLS.items():
        cells.append(new_markdown_cell(f"### {TITLES[kind].in_(lang)}"))
        cells.append(new_code_cell(f'plc.desk(plc.drill("{kind}", seed=1, level=2, dialect="{family}", ask="{ask}"))'))
    return new_notebook(cells=cells)


def concept_book(lang: str) -> Any:
    """Make the notebook of the concept test in one language."""
    return new_notebook(
        cells=[
            new_markdown_cell(CONCEPT_TEXT.in_(lang).format(count=len(concept_test()))),
            new_code_cell(FIRST.format(lang=lang)),
            new_markdown_cell(CONCEPT_RUN.in_(lang)),
            new_code_cell("plc.concept_test()"),
            new_markdown_cell(CONCEPT_NEXT.in_(lang).format(first=lessons()[0])),
        ]
    )


def paths() -> list[Path]:
    """Give the places of all notebooks that come from the catalogue alone."""
    found = [CONCEPT, *map(book_name, families())]
    return [FOLDER / lang / name for lang in LANGUAGES for name in found]


def from_catalogue(path: Path) -> Any | None:
    """Make a notebook that comes from the catalogue alone; None for one that is written by hand."""
    if path not in paths():
        return None
    lang = path.parent.name
    return concept_book(lang) if path.name == CONCEPT else exercise_book(path.stem.removeprefix(_BOOK), lang)


def indexed(book: Any) -> Any:
    """Put the table of the books into the index, in place of the one that stands there."""
    rows = [
        BOOK_ROW.format(
            en=dialect(family).title.en, zh=dialect(family).title.zh,
            count=sum(map(len, exercises_of(family).values())), name=book_name(family),
        )
        for family in families()
    ]  # fmt: skip
    rows.append(BOOK_ROW.format(en="Concept test", zh="概念测验", count=len(concept_test()), name=CONCEPT))
    place = next(cell for cell in book.cells if cell.source.startswith(BOOKS_HEAD.split("\n", 1)[0]))
    place.source = "\n".join([BOOKS_HEAD, *rows, "", ANYWHERE])
    return book


def source(path: Path) -> Any:
    """Give a notebook before it is run: made from the catalogue, or as written by hand with the catalogue's part put in."""
    made = from_catalogue(path)
    if made is not None:
        return made
    book = nbformat.read(path, 4)
    if path.name == INDEX:
        return indexed(book)
    if path.name[:1].isdigit():
        lesson, lang = lesson_of(path.name), path.parent.name
        links = [f"[{dialect(one).title.in_(lang)}]({book_name(one)})" for one in families_of(lesson)]
        return woven(book, lesson, lang, ("、" if lang == "zh" else ", ").join(links))
    return book
