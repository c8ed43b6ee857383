"""Files for people without a kernel: one page that asks nobody for anything, and lessons that overwrite nothing."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from plcteach.core import text as words
from plcteach.core.errors import PlcTeachError
from plcteach.figure.film import film
from plcteach.figure.verbs import film_of
from plcteach.machine import run
from plcteach.publish import lab, player_page
from plcteach.stl import read

HOSTILE = "</script><script>alert(1)</script><!-- ]]> &"


def page(text: str, lang: str | None = "en", title=None) -> str:
    return player_page(film(run(read(text, "s7-200")).scans, title), lang)


def data_of(html: str) -> dict:
    found = re.search(r'<script type="application/json" id="film">(.*?)</script>', html, re.DOTALL)
    assert found is not None
    return json.loads(found[1])


def test_the_page_holds_the_whole_film() -> None:
    one = film_of("LD I0.0; LD I0.1; OLD; = Q0.0", "s7-200")
    assert data_of(player_page(one, "en")) == one.data


def test_the_page_asks_nobody_for_anything() -> None:
    html = page("LD I0.0\n= Q0.0")
    assert "default-src 'none'" in html
    for sign in ("<link", "src=", "href=", "@import", "fetch(", "XMLHttpRequest", "WebSocket"):
        assert sign not in html
    assert set(re.findall(r"https?://[\w./-]+", html)) <= {"http://www.w3.org/2000/svg"}


@pytest.mark.parametrize(
    ("lang", "tag", "foot"), [("zh", "zh-CN", "教学用的模型"), ("en", "en", "a model for teaching")]
)
def test_the_page_speaks_one_language_first(lang: str, tag: str, foot: str) -> None:
    html = page("LD I0.0\n= Q0.0", lang)
    assert f'<html lang="{tag}">' in html
    assert foot in html
    assert f'lang: "{lang}"' in html


def test_without_a_wish_it_is_the_language_in_force(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(words, "_chosen", ["zh"])
    assert '<html lang="zh-CN">' in page("LD I0.0\n= Q0.0", None)


def test_nothing_in_a_comment_or_title_ends_the_script() -> None:
    html = page(f"Network 1 // {HOSTILE}\nLD I0.0 // {HOSTILE}\n= Q0.0", title=words.Text(HOSTILE, HOSTILE))
    assert html.count("<script") == 2
    assert html.count("</script>") == 2
    data = data_of(html)
    assert data["lines"][0]["comment"] == HOSTILE
    assert data["title"]["en"] == HOSTILE
    title = re.search(r"<title>(.*?)</title>", html, re.DOTALL)
    assert title is not None
    assert "<" not in title[1]


def test_the_same_film_is_the_same_page() -> None:
    assert page("LD I0.0\n= Q0.0") == page("LD I0.0\n= Q0.0")


# The lessons.


def test_the_checkouts_own_lessons_are_opened_where_they_are() -> None:
    folder = lab.lessons()
    assert (folder / "index.ipynb").is_file()
    assert folder.name == "notebooks"


def test_copies_overwrite_nothing(tmp_path: Path) -> None:
    target = tmp_path / "mine"
    target.mkdir()
    (target / "index.ipynb").write_text("my own notes", encoding="utf-8")
    assert lab.lessons(target) == target
    assert (target / "index.ipynb").read_text(encoding="utf-8") == "my own notes"
    copies = {path.relative_to(target).as_posix() for path in target.rglob("*.ipynb")}
    assert {path for path in copies if path.startswith("zh/")}
    assert {path.removeprefix("zh/") for path in copies if path.startswith("zh/")} == {
        path.removeprefix("en/") for path in copies if path.startswith("en/")
    }
    assert not [path for path in copies if ".ipynb_checkpoints" in path]


def test_the_example_course_is_copied_whole(tmp_path: Path) -> None:
    """A course folder without its configuration and its page of commands is of no use to anybody."""
    course = lab.lessons(tmp_path / "mine") / "course"
    told = (course / "README.md").read_text(encoding="utf-8")
    for name in ("nbgrader_config.py", "source/ps1/stack.ipynb"):
        assert name in told
        assert (course / "nbgrader" / name).is_file()
    assert (course / "otter" / "stack.ipynb").is_file()


def test_an_installation_without_lessons_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lab, "_PACKAGE", tmp_path / "site" / "plcteach")
    with pytest.raises(PlcTeachError, match="reinstall"):
        lab.lessons()


def test_an_installed_package_gives_copies_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    inside = tmp_path / "site" / "plcteach" / "lessons" / "en"
    inside.mkdir(parents=True)
    (inside.parent / "index.ipynb").write_text("{}", encoding="utf-8")
    (inside / "00.ipynb").write_text("{}", encoding="utf-8")
    monkeypatch.setattr(lab, "_PACKAGE", tmp_path / "site" / "plcteach")
    monkeypatch.chdir(tmp_path)
    where = lab.lessons()
    assert where == Path("plcteach-lessons")
    assert sorted(path.as_posix() for path in where.rglob("*.ipynb")) == [
        "plcteach-lessons/en/00.ipynb",
        "plcteach-lessons/index.ipynb",
    ]


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch) -> list[list[str]]:
    """Note the commands instead of running them; JupyterLab is there and ends with 7."""
    commands: list[list[str]] = []

    def runs(command: list[str], **_how: object) -> subprocess.CompletedProcess[str]:
        commands.append(command)
        return subprocess.CompletedProcess(command, 7)

    monkeypatch.setattr(lab.subprocess, "run", runs)
    monkeypatch.setattr(lab, "find_spec", lambda _name: object())
    return commands


def test_jupyterlab_is_started_on_the_lessons(tmp_path: Path, started: list[list[str]]) -> None:
    assert lab.open_lab(tmp_path / "here", browser=False) == 7
    command = started[-1]
    assert command[:3] == [sys.executable, "-m", "jupyterlab"]
    assert f"--ServerApp.root_dir={(tmp_path / 'here').resolve()}" in command
    assert "--no-browser" in command
    assert lab.open_lab(tmp_path / "here") == 7
    assert "--no-browser" not in started[-1]


def test_only_our_own_lessons_are_trusted(tmp_path: Path, started: list[list[str]]) -> None:
    (tmp_path / "somebody").mkdir()
    (tmp_path / "somebody" / "elses.ipynb").write_text("{}", encoding="utf-8")
    (tmp_path / "index.ipynb").write_text("{}", encoding="utf-8")
    lab.open_lab(tmp_path)
    signed = [word for command in started if "nbformat.sign" in command for word in command]
    assert str(tmp_path / "zh" / "00-contacts-and-coils.ipynb") in signed
    assert not [word for word in signed if word.endswith("elses.ipynb")]
    assert str(tmp_path / "index.ipynb") not in signed


def test_ctrl_c_is_a_usual_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, started: list[list[str]]) -> None:
    def runs(command: list[str], **_how: object) -> subprocess.CompletedProcess[str]:
        started.append(command)
        if "jupyterlab" in command:
            raise KeyboardInterrupt
        return subprocess.CompletedProcess(command, 0)

    monkeypatch.setattr(lab.subprocess, "run", runs)
    assert lab.open_lab(tmp_path / "here") == 0
    assert "jupyterlab" in started[-1]


def test_without_jupyterlab_it_says_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lab, "find_spec", lambda _name: None)
    with pytest.raises(PlcTeachError, match=r"pip install 'plcteach\[lab\]'"):
        lab.open_lab()
