"""On paper: files that exist, that are the same each time, and that cost not one word on stderr."""

from __future__ import annotations

import subprocess
import sys

import pytest
from matplotlib import rcParams
from matplotlib.figure import Figure

from plcteach.core.text import Text, same
from plcteach.figure import mpl
from plcteach.figure.scene import Box, Disc, Scene, Stroke, Words
from plcteach.figure.stack import illustrate

WITHOUT_CHINESE = """
import matplotlib.font_manager as fonts
fonts.fontManager.ttflist = [font for font in fonts.fontManager.ttflist if font.name.startswith("DejaVu")]
"""
DRAW = """
import sys
from plcteach.figure import mpl
from plcteach.figure.stack import illustrate
from plcteach.figure.scene import Scene, Words
from plcteach.core.text import same
scene = illustrate("s7-200", "OLD")
odd = Scene(90, 40, (Words(40, 20, same("层 $x_1$ \\U0001f600")),), same("odd"))
for kind in ("svg", "pdf", "png"):
    mpl.save(scene, sys.argv[1] + "/old." + kind, "zh")
    mpl.save(odd, sys.argv[1] + "/odd." + kind, "zh")
mpl.save_pages([scene, odd], sys.argv[1] + "/pages.pdf", "zh")
print(repr(mpl.chinese_font()))
"""


@pytest.mark.parametrize("before", ["", WITHOUT_CHINESE])
def test_nothing_on_stderr(before, tmp_path):
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", before + DRAW, str(tmp_path)], capture_output=True, text=True, check=False
    )
    assert done.stderr == ""
    assert done.returncode == 0
    assert len(list(tmp_path.iterdir())) == 7
    assert all(file.stat().st_size > 500 for file in tmp_path.iterdir())
    if before:
        assert done.stdout == "''\n"


def test_without_a_chinese_font_the_words_are_english(monkeypatch):
    monkeypatch.setattr(mpl, "chinese_font", lambda: "")
    axes = mpl.draw(illustrate("s7-200", "OLD"), "zh")
    assert "before" in [text.get_text() for text in axes.texts]


@pytest.mark.parametrize("kind", ["svg", "pdf", "png"])
def test_the_same_scene_is_the_same_bytes(kind, tmp_path):
    scene = illustrate("gutta", "P")
    one, two = (mpl.save(scene, tmp_path / f"{name}.{kind}", "en") for name in ("one", "two"))
    assert one.read_bytes() == two.read_bytes()


def test_pages(tmp_path):
    scenes = [illustrate("fx", word) for word in ("LD", "ORB", "MPP")]
    one, two = (mpl.save_pages(scenes, tmp_path / name, "en") for name in ("one.pdf", "two.pdf"))
    assert one.read_bytes() == two.read_bytes()
    assert one.read_bytes().count(b"/Type /Page ") == 3
    assert b"CreationDate" not in one.read_bytes()


@pytest.mark.parametrize("draw", [mpl.save, lambda scene, path, lang: mpl.save_pages([scene], path, lang)])
def test_other_files_are_refused_in_words(draw, tmp_path):
    with pytest.raises(ValueError, match="gif"):
        draw(illustrate("fx", "LD"), tmp_path / "a.gif", "en")


def test_every_shape_where_the_scene_has_it():
    shapes = (
        Box(5, 5, 60, 20, "cell"),
        Box(5, 40, 60, 20, "chip", 8),
        Stroke(((0, 0), (10, 20)), "accent", arrow=True),
        Disc(80, 40, 9, "wire", open=60),
        Disc(80, 60, 3, "dot"),
        Words(10, 10, Text("层", "level"), anchor="start"),
    )
    axes = mpl.draw(Scene(100, 80, shapes, same("all")), "en")
    assert len(axes.patches) == 2 + 2 + 2 + 1  # boxes, a line with its head, two arcs, a dot
    corner = axes.patches[0].get_extents().transformed(axes.transData.inverted())
    assert (round(corner.x0), round(corner.x1)) == (5, 65)
    assert sorted((round(corner.y0), round(corner.y1))) == [5, 25]
    assert axes.get_xlim() == (0, 100)
    assert axes.get_ylim() == (80, 0)
    assert [text.get_text() for text in axes.texts] == ["level"]


def test_drawing_into_given_axes_leaves_the_settings_alone():
    before = dict(rcParams)
    figure = Figure(figsize=(4, 3))
    axes = figure.add_subplot()
    assert mpl.draw(illustrate("fx", "LD"), "en", axes) is axes
    assert dict(rcParams) == before
