"""The cell magic %%stl in a real IPython shell: the text stays to the letter, and what is to be said of it is shown."""

from __future__ import annotations

import subprocess
import sys

import pytest
from IPython.core.interactiveshell import InteractiveShell
from traitlets.config import Config

from plcteach.check.lint import lint
from plcteach.check.score import grade


@pytest.fixture(scope="module")
def shell():
    config = Config()
    config.HistoryManager.enabled = False
    config.InteractiveShell.warn_venv = False
    shell = InteractiveShell(config=config)
    shell.run_line_magic("load_ext", "plcteach")
    return shell


def run(shell: InteractiveShell, cell: str):
    return shell.run_cell(cell)


@pytest.mark.parametrize(
    "text",
    [
        "LD I0.0\n= Q0.0\n",
        '### BEGIN SOLUTION\nLD I0.0\n\n   =  Q0.0   // 中文 """ \\n {x} $y %%stl\n### END SOLUTION\n',
        "\n  !ls\n%time\n?help\n",
        "--[ I0.0 ]--( Q0.0 )\n",
    ],
)
def test_the_text_is_kept_to_the_letter(shell, text: str) -> None:
    assert run(shell, f"%%stl program\n{text}").success
    assert shell.user_ns["program"] == text


def test_what_is_to_be_said_is_the_cells_output_and_nothing_else(shell, capsys) -> None:
    found = run(shell, "%%stl program\nLD I0.0\nOLD\n= Q0.0\n").result
    assert found == lint("LD I0.0\nOLD\n= Q0.0\n")
    assert "STK001" in found._repr_html_()
    assert run(shell, "%%stl program\nLD I0.0\n= Q0.0\n").result is None
    assert capsys.readouterr().err == ""


def test_a_family_or_an_exercise_says_how_it_is_read(shell) -> None:
    text = "LD X0\nANI X1\nOUT Y0\n"
    assert run(shell, f"%%stl program --dialect fx\n{text}").result is None
    assert run(shell, f"%%stl program --exercise fx-one-contact\n{text}").result is None
    assert run(shell, f"%%stl program --dialect=fx\n{text}").result is None
    assert run(shell, f"%%stl program\n{text}").result


def test_an_answer_that_is_no_program_is_not_read_as_one(shell) -> None:
    assert run(shell, "%%stl cells --exercise s7-predict-blocks\n1 .\n1 .\n1 1\n0 1\n1 .\n1 .\n").result is None
    assert grade("s7-predict-blocks", shell.user_ns["cells"]) == 4


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("", "Usage: %%stl NAME"),
        ("3x", "Usage"),
        ("for", "Usage"),
        ("x --dialect", "Usage"),
        ("x --family fx", "Usage"),
        ("x --dialect f", "There is no dialect"),
        ("x --exercise s7-two-block", "s7-two-blocks"),
    ],
)
def test_a_wrong_call_says_what_to_do_in_one_line(shell, line: str, said: str, monkeypatch) -> None:
    monkeypatch.setenv("PLCTEACH_LANG", "en")
    failed = run(shell, f"%%stl {line}\nLD I0.0\n").error_in_exec
    assert said in str(failed)
    assert len(failed._render_traceback_()) == 1


def test_a_drawing_that_no_list_can_express_is_kept_and_left_to_the_judge(shell) -> None:
    text = "NOT·I0.0 -> Q0.0\n"
    done = run(shell, f"%%stl program\n{text}")
    assert done.success
    assert shell.user_ns["program"] == text


def test_no_widget_is_opened_on_the_way_to_the_marks() -> None:
    code = (
        "import sys, plcteach\n"
        "class Shell:\n"
        "    def register_magic_function(self, *rest, **more): pass\n"
        "plcteach.load_ipython_extension(Shell())\n"
        "plcteach.grade('s7-two-blocks', 'LD I0.0')\n"
        "print(sorted({'matplotlib', 'numpy', 'IPython', 'ipywidgets', 'anywidget'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=True)
    assert (done.stdout.strip(), done.stderr) == ("[]", "")


SAMPLES = (
    "import plcteach\n"
    "from plcteach.check.judge import model\n"
    "from plcteach.exercises import exercise, ids\n"
    "for name in ids()[::4]:\n"
    "    task = exercise(name)\n"
    "    for text in (model(task), *(one.program for one in task.wrong), '', 'OLD', '\\x00\\ud800<b>'):\n"
    "        score = plcteach.grade(task, text)\n"
    "        assert 0 <= score <= task.points and score._repr_html_()\n"
)


def test_nothing_stands_on_stderr_where_marks_are_made_not_even_a_warning() -> None:
    done = subprocess.run([sys.executable, "-W", "error", "-c", SAMPLES], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr, done.stdout) == (0, "", "")
