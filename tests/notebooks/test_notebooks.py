"""The lessons as files: two editions with one code, built and normalised, in the words of the glossary and the shape of a lesson."""

from __future__ import annotations

import ast
import html
import importlib.util
import itertools
import json
import re
from pathlib import Path
from urllib.parse import unquote

import nbformat
import pytest

from plcteach.check.drill import KINDS as DRILLS
from plcteach.check.drill import from_id
from plcteach.core.diagnostic import RULES
from plcteach.exercises import concept_test, exercise, ids

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "notebooks"
_spec = importlib.util.spec_from_file_location("build_notebooks", Path(__file__).with_name("build.py"))
build = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(build)

BOOKS = [path.relative_to(FOLDER).as_posix() for path in build.notebooks()]
MADE = [path.relative_to(FOLDER).as_posix() for path in build.exercise_books.paths()]
FAMILY_BOOKS = [name for name in MADE if "/exercises-" in name]
LESSONS = sorted(path.name for path in (FOLDER / "en").glob("[0-9]*.ipynb"))
EDITIONS = [f"{lang}/{name}" for name in LESSONS for lang in ("en", "zh")]
FIRST = 'import plcteach as plc\n\nplc.language("{}")'

SHAPE = {
    "en": (
        "**After this lesson you can**",
        "**Predict.**",
        "**Observe.**",
        "**Explain.**",
        "## Summary",
        "## Check yourself",
        "## What to remember",
        "## Exercises",
        "## Next",
        "## Sources",
        "**A model, not the hardware.**",
        "[rec]",
    ),
    "zh": (
        "**学完以后，你能够**",
        "**先猜一猜。**",
        "**观察。**",
        "**解释。**",
        "## 小结",
        "## 自我检查",
        "## 请记住",
        "## 练习",
        "## 下一",
        "## 资料来源",
        "**这是模型，不是真实的PLC。**",
        "[rec]",
    ),
}
MINUTES = {"en": re.compile(r"\*About \d+ minutes · "), "zh": re.compile(r"\*约\d+分钟 · ")}
TERMS = {
    "00-contacts-and-coils.ipynb": (
        "梯形图 左母线 能流 触点 常开触点 常闭触点 线圈 位地址 操作码 操作数 语句表（STL） 扫描周期 过程映像 网络 自锁 连续（纵接）输出"
    ),
    "01-what-the-stack-is-for.ipynb": (
        "逻辑堆栈 层 栈顶 栈底 入栈 后进先出 电路块 电路块并联 电路块串联 分支点 逻辑入栈 逻辑读栈 逻辑出栈 装载堆栈 运算结果寄存器 "
        "指令表 栈内残留值"
    ),
    "02-the-scan-and-why-order-matters.ipynb": "扫描周期 过程映像 时序图 双线圈输出 特殊存储器位 网络",
    "03-edges-set-reset-and-double-coils.ipynb": (
        "上升沿 下降沿 脉冲生成指令 取反 置位 复位 触发器 置位优先 复位优先 双线圈输出"
    ),
    "04-timers-and-their-resolutions.ipynb": (
        "预设值 当前值 时基 接通延时 断开延时 有记忆接通延时 脉冲定时器 积算定时器 脉冲发生电路"
    ),
    "05-counters.ipynb": "加计数器 减计数器 加减计数器 当前值 预设值 上升沿 复位 上溢出 下溢出",
    "06-drums-shift-registers-step-counters-and-queues.ipynb": (
        "鼓形控制器 步 控制位 移位寄存器 步进计数器 先进先出 后进先出 行程开关 电磁阀 原位 上升沿"
    ),
    "07-blocks-and-joins.ipynb": "电路块 独立电路 电路块串联 电路块并联",
    "08-branches-on-one-and-two-levels.ipynb": ("分支 连续（纵接）输出 多重输出 逻辑入栈 逻辑读栈 逻辑出栈 装载堆栈"),
    "09-parentheses.ipynb": "布尔累加器 指令表 取反",
    "10-two-stacks-fusion-and-decomposition.ipynb": (
        "数据栈 辅助栈 输入指令 输出指令 复合输入指令 复合输出指令 系统指令"
    ),
    "11-from-ladder-to-list-and-back.ipynb": "梯形图 常开触点 常闭触点 能流 逻辑入栈 装载堆栈",
    "12-four-families-side-by-side.ipynb": "运算结果寄存器 布尔累加器 电路块并联 电路块串联",
    "13-finding-the-fault.ipynb": (
        "自锁 状态监视 强制 双线圈输出 运算结果寄存器 电路块串联 电路块并联 栈内残留值 移位寄存器 上升沿"
    ),
}
NEVER = {
    "zh": re.compile(r"堆(?!栈)|(?<!入)(?<!出)(?<!读)(?<!进)接点|映象|非法|无效|断路触点|S0层|第0层"),
    "en": re.compile(r"\b(illegal|invalid|obviously|simply|of course)\b|level S\d|level 0\b", re.IGNORECASE),
}


def _read(name):
    return nbformat.read(FOLDER / name, 4)


def _cells(name, kind):
    return [cell for cell in _read(name).cells if cell.cell_type == kind]


def _prose(name):
    return "\n\n".join(cell.source for cell in _cells(name, "markdown"))


def test_both_editions_have_the_same_lessons():
    assert LESSONS
    assert sorted(path.name for path in (FOLDER / "zh").glob("[0-9]*.ipynb")) == LESSONS


@pytest.mark.parametrize("name", LESSONS)
def test_both_editions_have_the_same_code_cells_but_for_the_language(name):
    english, chinese = ([(cell.id, cell.source) for cell in _cells(f"{lang}/{name}", "code")] for lang in ("en", "zh"))
    assert english[0][1] == FIRST.format("en")
    assert chinese[0][1] == FIRST.format("zh")
    assert english[1:] == chinese[1:]


@pytest.mark.parametrize("name", BOOKS)
def test_a_notebook_is_executed_without_trouble(name):
    code = _cells(name, "code")
    assert [cell.execution_count for cell in code] == list(range(1, len(code) + 1))
    kinds = {output.output_type for cell in code for output in cell.outputs}
    assert kinds <= {"execute_result"}


@pytest.mark.parametrize("name", BOOKS)
def test_a_notebook_is_in_its_normal_form(name):
    text = (FOLDER / name).read_text(encoding="utf-8")
    assert build.normal(_read(name)) == text
    raw = json.loads(text)
    assert raw["metadata"] == {"kernelspec": build.KERNEL, "language_info": {"name": "python"}}
    assert [cell["id"] for cell in raw["cells"]] == [f"c{number:03d}" for number in range(len(raw["cells"]))]
    assert "widget-view" not in text


@pytest.mark.parametrize("name", BOOKS)
def test_what_is_shown_can_be_compared_as_text(name):
    shown = {kind for cell in _cells(name, "code") for output in cell.outputs for kind in output.data}
    assert shown <= {"text/plain", "text/html", "image/svg+xml"}


@pytest.mark.parametrize("name", EDITIONS)
def test_a_lesson_has_the_lesson_shape_with_its_chapters_in_order(name):
    lang = name[:2]
    prose = _prose(name)
    places = {part: prose.find(part) for part in SHAPE[lang]}
    assert [part for part, place in places.items() if place < 0] == []
    chapters = [place for part, place in places.items() if part.startswith("## ")]
    assert chapters == sorted(chapters)
    assert MINUTES[lang].search(prose)


@pytest.mark.parametrize("name", EDITIONS)
def test_a_lesson_ends_with_three_questions_and_their_folded_answers(name):
    asked = next(cell.source for cell in _cells(name, "markdown") if SHAPE[name[:2]][5] in cell.source)
    assert re.findall(r"^\*\*(\d)\.\*\*", asked, re.MULTILINE) == ["1", "2", "3"]
    assert asked.count("<details><summary>") == asked.count("</details>") == 3


@pytest.mark.parametrize("name", EDITIONS)
def test_every_prediction_is_asked_before_a_folded_answer(name):
    predict = SHAPE[name[:2]][1]
    cells = _read(name).cells
    asked = [
        number
        for number, cell in enumerate(cells)
        if number and cell.cell_type == "markdown" and predict in cell.source
    ]
    folded = [number for number, cell in enumerate(cells) if cell.metadata.get("jupyter", {}).get("outputs_hidden")]
    assert len(asked) >= 8
    assert [number for number in asked if number + 1 not in folded] == []


@pytest.mark.parametrize("name", EDITIONS)
def test_a_cell_holds_one_idea_of_at_most_three_statements(name):
    for cell in _cells(name, "code"):
        outside = re.sub(r'""".*?"""', '""', cell.source, flags=re.DOTALL)
        assert len([line for line in outside.splitlines() if line.strip()]) <= 3, cell.source


@pytest.mark.parametrize("name", LESSONS)
def test_the_chinese_edition_introduces_the_words_of_the_glossary_in_bold(name):
    bold = set(re.findall(r"\*\*([^*\n]+)\*\*", _prose(f"zh/{name}")))
    assert [term for term in TERMS[name].split() if term not in bold] == []


@pytest.mark.parametrize("name", BOOKS)
def test_no_word_is_used_that_the_glossary_or_the_voice_forbids(name):
    prose = _prose(name)
    spared = re.sub(r"https?://\S+|\(.*?\.ipynb\)", "", prose)
    languages = ("en", "zh") if "/" not in name else (name[:2],)
    assert [word.group() for lang in languages for word in NEVER[lang].finditer(spared)] == []


def test_the_forbidden_words_are_recognised():
    assert NEVER["zh"].search("把值压入堆里")
    assert not NEVER["zh"].search("逻辑堆栈")
    assert NEVER["en"].search("An illegal instruction")


@pytest.mark.parametrize("name", BOOKS)
def test_every_link_between_notebooks_leads_somewhere(name):
    links = re.findall(r"\]\(([^)#]+)\)", _prose(name))
    local = [link for link in links if "://" not in link]
    assert local
    assert [link for link in local if not ((FOLDER / name).parent / unquote(link)).resolve().is_file()] == []


def test_the_index_lists_every_lesson_in_both_editions_with_its_title_and_minutes():
    prose = _prose("index.ipynb")
    for name in EDITIONS:
        first = _cells(name, "markdown")[0].source
        title = first.splitlines()[0].removeprefix("# ")
        minutes = re.search(r"\d+(?=分钟| minutes)", first).group()
        row = next(line for line in prose.splitlines() if f"]({name})" in line)
        assert row.startswith(f"| [{title}]({name}) |")
        assert row.endswith(f"| {minutes} |")


@pytest.mark.parametrize("name", EDITIONS)
def test_a_lesson_names_its_sources_by_their_files(name):
    sources = _prose(name).split(SHAPE[name[:2]][9])[1]
    assert set(re.findall(r"\b\d{3}_[0-9a-f]{16}\.txt", sources)) >= {
        "000_8c35a2fe1b5d9b9b.txt",
        "002_0e43569a3a430994.txt",
    }


@pytest.mark.parametrize("name", EDITIONS)
def test_a_file_is_named_once_and_only_among_the_sources(name):
    text, sources = _prose(name).split(SHAPE[name[:2]][9])
    assert re.findall(r"\d{3}_[0-9a-f]{16}", text) == []
    named = re.findall(r"\d{3}_[0-9a-f]{16}\.txt", sources)
    assert len(named) == len(set(named))


DESK = re.compile(r'plc\.desk\("([\w-]+)"\)')
DRILLED = re.compile(r'plc\.desk\(plc\.drill\("([\w-]+)", seed=\d+, level=\d, dialect="([\w-]+)", ask="(\w+)"\)\)')


def _desks(cells):
    return [found[1] for cell in cells if cell.cell_type == "code" and (found := DESK.fullmatch(cell.source))]


def _end(name):
    """Give the cells of a lesson's exercises."""
    cells = _read(name).cells
    head, after = SHAPE[name[:2]][7], SHAPE[name[:2]][8]
    first = next(number for number, cell in enumerate(cells) if cell.source.startswith(head))
    last = next(number for number, cell in enumerate(cells) if cell.source.startswith(after))
    return cells[first:last]


@pytest.mark.parametrize("name", EDITIONS)
def test_a_lesson_ends_with_two_to_four_of_its_exercises_each_with_a_reason(name):
    cells = _end(name)
    chosen = _desks(cells)
    assert 2 <= len(chosen) <= 4
    assert len(set(chosen)) == len(chosen)
    assert {exercise(one).lesson for one in chosen} == {int(name[3:5])}
    for before, cell in itertools.pairwise(cells):
        if found := DESK.fullmatch(cell.source):
            title, empty, reason = before.source.split("\n")
            assert title.startswith(f"### {exercise(found[1]).title.in_(name[:2])}")
            assert empty == ""
            assert len(re.findall(r"[.。?？]$", reason)) == 1


@pytest.mark.parametrize("name", EDITIONS)
def test_a_lesson_ends_with_the_list_of_all_its_exercises_and_the_books_that_have_them(name):
    cells = [cell for cell in _end(name) if "ids()" in cell.source or "](exercises-" in cell.source]
    lesson = int(name[3:5])
    wanted = {one: exercise(one).title.in_(name[:2]) for one in ids() if exercise(one).lesson == lesson}
    assert ast.literal_eval(cells[1].outputs[0].data["text/plain"]) == wanted
    linked = re.findall(r"\]\(exercises-([\w-]+)\.ipynb\)", cells[0].source)
    assert sorted(linked) == sorted({exercise(one).dialect for one in wanted})


@pytest.mark.parametrize("name", EDITIONS)
def test_every_diagnostic_that_names_a_lesson_is_found_in_a_cell_of_it(name):
    wanted = {rule.code: rule.why.in_(name[:2]) for rule in RULES.values() if rule.lesson == int(name[3:5])}
    cells = [cell for cell in _end(name) if "RULES.values()" in cell.source]
    assert [ast.literal_eval(cell.outputs[0].data["text/plain"]) for cell in cells] == [wanted] * bool(wanted)
    shown = [re.search(r'plc\.explain\("(\w+)"\)', cell.source) for cell in _end(name)]
    assert [found[1] for found in shown if found] == [*wanted][:1]


@pytest.mark.parametrize("name", [*MADE, *EDITIONS, "index.ipynb"])
def test_what_comes_from_the_catalogue_is_up_to_date(name):
    wanted = build.exercise_books.source(FOLDER / name)
    assert [(cell.cell_type, cell.source) for cell in wanted.cells] == [
        (cell.cell_type, cell.source) for cell in _read(name).cells
    ]


def test_there_is_a_book_for_each_family_and_one_concept_test_in_both_editions():
    families = {exercise(one).dialect for one in ids()}
    for lang in ("en", "zh"):
        found = {path.name for path in (FOLDER / lang).glob("*.ipynb")} - {*LESSONS}
        assert found == {"concept-test.ipynb", *(f"exercises-{family}.ipynb" for family in families)}
        tests = [cell for cell in _cells(f"{lang}/concept-test.ipynb", "code") if cell.source == "plc.concept_test()"]
        assert len(tests) == 1
        (shown,) = tests[0].outputs
        assert [one.id for one in concept_test() if one.title.in_(lang) not in _words(shown.data["text/html"])] == []


def _words(page):
    return html.unescape(re.sub(r"<[^>]+>", "", page))


@pytest.mark.parametrize("name", FAMILY_BOOKS)
def test_a_book_has_every_exercise_of_its_family_once_lesson_by_lesson_in_teaching_order(name):
    family = Path(name).stem.removeprefix("exercises-")
    cells = _read(name).cells
    wanted = [one for one in ids() if exercise(one).dialect == family]
    assert _desks(cells) == sorted(wanted, key=lambda one: exercise(one).lesson)
    lesson = None
    for before, cell in itertools.pairwise(cells):
        if found := re.match(r"## (?:Lesson |第)(\d+)", before.source):
            lesson = int(found[1])
        if found := DESK.fullmatch(cell.source):
            one = exercise(found[1])
            assert one.lesson == lesson
            assert before.source.startswith(f"### {one.title.in_(name[:2])}\n\n`{one.id}` · ")
            assert [other for other in one.after if exercise(other).title.in_(name[:2]) not in before.source] == []
            assert one.task.in_(name[:2]) in _words(cell.outputs[0].data["text/html"])


@pytest.mark.parametrize("name", FAMILY_BOOKS)
def test_a_book_begins_with_the_progress_and_ends_with_a_drill_of_each_kind(name):
    family = Path(name).stem.removeprefix("exercises-")
    code = _cells(name, "code")
    assert code[1].source == f'plc.progress("{family}")'
    drills = [found.groups() for cell in code if (found := DRILLED.fullmatch(cell.source))]
    assert [cell.source for cell in code[-len(drills) :] if not DRILLED.fullmatch(cell.source)] == []
    assert [kind for kind, _, _ in drills] == list(DRILLS)
    assert {dialect for _, dialect, _ in drills} == {family}
    words = [cell.outputs[0].data["text/plain"] for cell in code[-len(drills) :]]
    assert [one for one in words if from_id(re.fullmatch(r"ExerciseDesk\((.+)\)", one)[1]) is None] == []


@pytest.mark.parametrize("name", [name.removeprefix("en/") for name in MADE if name.startswith("en/")])
def test_both_editions_of_a_book_have_the_same_code_but_for_the_language(name):
    english, chinese = ([cell.source for cell in _cells(f"{lang}/{name}", "code")] for lang in ("en", "zh"))
    assert (english[0], chinese[0]) == (FIRST.format("en"), FIRST.format("zh"))
    assert english[1:] == chinese[1:]


def test_nobodys_progress_stands_in_a_book():
    shown = [cell.outputs[0].data["text/html"] for name in FAMILY_BOOKS for cell in _cells(name, "code")[1:2]]
    assert len(shown) == len(FAMILY_BOOKS)
    assert [page for page in shown if "✓" in page or "…" in page] == []


def test_every_exercise_and_every_diagnostic_leads_to_a_lesson_that_is_there():
    there = {int(name[:2]) for name in LESSONS}
    assert {exercise(one).lesson for one in ids()} == there
    assert {one.lesson for one in concept_test()} <= there
    assert {rule.lesson for rule in RULES.values()} - {-1} <= there


def test_the_index_lists_every_book_in_both_editions_with_the_number_of_its_exercises():
    rows = [line for line in _prose("index.ipynb").splitlines() if line.startswith("| ") and "](en/exercises-" in line]
    told = {re.search(r"\]\(en/(exercises-.+?\.ipynb)\)", row)[1]: row.split("|")[3].strip() for row in rows}
    families = [exercise(one).dialect for one in ids()]
    assert told == {f"exercises-{family}.ipynb": str(families.count(family)) for family in set(families)}
    for name in (name for name in MADE if name.startswith("en/")):
        assert f"]({name})" in _prose("index.ipynb")
        assert f"](zh/{name[3:]})" in _prose("index.ipynb")
