"""Every rule about the code that can be a test is a test."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from plcteach import dialects
from plcteach.core.diagnostic import RULES

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "plcteach"
MODULES = sorted(path for path in PACKAGE.rglob("*.py") if "lessons" not in path.parts)
TABLES = {PACKAGE / "dialects" / name for name in ("fx.py", "gutta.py", "neza.py", "s7200.py")}
LONGEST_MODULE, LONGEST_FUNCTION, MOST_ARGUMENTS = 300, 30, 6
DECLARATIONS = {PACKAGE / "core" / "diagnostic.py"}
"""Declared rows of words, like the dialects' tables."""


def named(path: Path) -> str:
    return str(path.relative_to(ROOT))


def functions(path: Path) -> list[ast.FunctionDef]:
    return [node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.FunctionDef)]


def test_the_five_walls_stand_in_the_only_configuration_file() -> None:
    table = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    kinds = [contract["type"] for contract in table["tool"]["importlinter"]["contracts"]]
    assert kinds == ["layers", "acyclic_siblings", "forbidden", "independence", "protected"]
    assert not list(ROOT.glob("*.cfg")) + list(ROOT.glob("*.ini")) + list(ROOT.glob(".*.toml"))


def test_no_wall_is_broken() -> None:
    done = subprocess.run(
        [Path(sys.executable).with_name("lint-imports"), "--no-cache"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "5 kept, 0 broken" in done.stdout


@pytest.mark.parametrize("path", MODULES, ids=named)
def test_a_module_opens_with_one_sentence_that_says_what_it_knows(path: Path) -> None:
    first = (ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or "").split("\n\n")[0]
    assert 20 < len(first) < 400
    assert first.rstrip().endswith((".", ":"))


@pytest.mark.parametrize("path", [path for path in MODULES if path not in TABLES | DECLARATIONS], ids=named)
def test_a_module_has_at_most_300_lines_of_code(path: Path) -> None:
    code = [row for row in path.read_text(encoding="utf-8").splitlines() if row.strip()]
    assert len(code) <= LONGEST_MODULE


@pytest.mark.parametrize("path", MODULES, ids=named)
def test_a_function_is_short_and_takes_few_arguments(path: Path) -> None:
    for function in functions(path):
        body = [
            node for node in function.body if not (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant))
        ]
        if not body:
            continue
        lines = (body[-1].end_lineno or 0) - body[0].lineno + 1
        assert lines <= LONGEST_FUNCTION, f"{function.name}: {lines} lines"
        if function.name not in {"insn", "__init__"}:
            arguments = [
                one for one in function.args.posonlyargs + function.args.args if one.arg not in {"self", "cls"}
            ]
            assert len(arguments) <= MOST_ARGUMENTS, function.name


@pytest.mark.parametrize(
    "path", [path for path in MODULES if path.parent.name not in {"dialects", "exercises"}], ids=named
)
def test_no_file_outside_the_tables_spells_a_dialects_name(path: Path) -> None:
    names = {one.lower() for one in dialects.names()}
    words = [
        node.value.lower()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    ]
    assert not names & set(words)


def test_names_of_things_that_do_things_are_plc_words() -> None:
    for path in MODULES:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef):
                assert not re.search(r"(Manager|Handler|Engine|Helper|Util|Visitor|StackMachine)", node.name), node.name
        assert "util" not in path.stem


def test_a_dialects_table_has_no_functions_and_keeps_to_one_call_a_line() -> None:
    for path in TABLES:
        assert not functions(path)


def test_importing_plcteach_opens_no_screen() -> None:
    code = (
        "import sys, plcteach; plcteach.read, plcteach.run, plcteach.lint, plcteach.explain, plcteach.illustrate;"
        "print(sorted({'matplotlib','numpy','IPython','ipywidgets','anywidget','traitlets'} & set(sys.modules)))"
    )
    assert (
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "[]"
    )


def test_every_rule_says_what_it_sees_and_ends_with_a_question_or_an_action_or_a_fact() -> None:
    for row in RULES.values():
        for words in (row.says.zh, row.says.en, row.why.zh, row.why.en):
            assert words.strip()
            assert not re.search(r"illegal|invalid|非法|无效|错误的", words), row.code
        assert set(re.findall(r"{(\w+)}", row.says.zh)) == set(re.findall(r"{(\w+)}", row.says.en)), row.code


def test_nothing_names_this_workplace() -> None:
    done = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False)
    for name in done.stdout.split():
        path = ROOT / name
        if path.suffix in {".py", ".js", ".mjs", ".md", ".toml", ".ipynb", ".css", ".txt", ".cfg"} and path.is_file():
            text = path.read_text(encoding="utf-8")
            assert not re.search(r"(?<![\w.])/(?:work|opt|root|home)/\w", text), name
