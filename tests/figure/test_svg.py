"""SVG: well-formed whatever the words, the same bytes every time, and without matplotlib."""

from __future__ import annotations

import subprocess
import sys
from xml.etree import ElementTree as ET

import pytest

from plcteach.core.text import Text, language, same
from plcteach.figure.ink import COLOURS, INKS
from plcteach.figure.scene import Box, Disc, Scene, Stroke, Words
from plcteach.figure.stack import illustrate
from plcteach.figure.svg import Figure, svg

NS = "{http://www.w3.org/2000/svg}"
HOSTILE = "</text><script>alert('1')</script>&amp;\"]]>\x00\x1b\ud800\ufffe"


def parsed(text: str) -> ET.Element:
    return ET.fromstring(text.encode())  # noqa: S314, the text is ours


def scene(words: str = "iv0") -> Scene:
    shapes = (
        *(Box(5, 5, 60, 20, ink, 3) for ink in INKS),
        Stroke(((0, 0), (10, 0), (10, 20)), "accent", arrow=True),
        Stroke(((0, 0), (10, 0), (10, 20), (30, 20)), "dashed", arrow=True, curve=True),
        Disc(40, 40, 9, "dot"),
        Disc(60, 40, 9, "wire", open=80),
        Words(10, 10, same(words), code=True, bold=True),
    )
    return Scene(100, 80, shapes, same(f"title {words}"))


@pytest.mark.parametrize("lang", ["zh", "en"])
@pytest.mark.parametrize("dark", [None, True, False])
def test_hostile_words_stay_words(lang, dark):
    root = parsed(svg(scene(HOSTILE), lang, dark=dark))
    assert root.get("role") == "img"
    assert not list(root.iter(f"{NS}script"))
    shown = "</text><script>alert('1')</script>&amp;\"]]>"
    assert root.findtext(f"{NS}title") == root.get("aria-label") == f"title {shown}"
    assert [text.text for text in root.iter(f"{NS}text")] == [shown]


def test_each_shape_is_drawn():
    root = parsed(svg(scene(), "en"))
    kinds = [child.tag.removeprefix(NS) for child in root]
    assert kinds.count("rect") == len(INKS) + 1  # and the paper
    assert kinds.count("polygon") == 2  # arrow heads
    assert kinds.count("circle") == 1
    assert kinds.count("path") == 2  # a curve and a coil
    coil = root.findall(f"{NS}path")[1].get("d") or ""
    assert coil.count("A") == 2  # two arcs, open at the top and at the bottom


def test_the_same_scene_is_the_same_bytes():
    assert svg(scene(), "zh") == svg(scene(), "zh")
    code = (
        "from plcteach.figure.stack import illustrate; from plcteach.figure.svg import svg; import hashlib; "
        "print(hashlib.sha256(svg(illustrate('neza', 'AND('), 'zh').encode()).hexdigest())"
    )
    prints = {
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
        for _ in range(2)
    }
    assert len(prints) == 1


def test_the_theme_follows_the_reader_or_is_forced():
    auto, dark, light = (svg(scene(), "en", dark=dark) for dark in (None, True, False))
    assert "prefers-color-scheme:dark" in auto
    assert "data-jp-theme-light=false" in auto
    assert "prefers-color-scheme" not in dark + light
    for role, hues in COLOURS.items():
        assert f"--plc-{role}:{hues[1]}" in dark
        assert f"--plc-{role}:{hues[0]}" in light
    assert 'fill="#ffffff"' not in dark


def test_nothing_is_fetched_and_no_name_is_shared():
    text = svg(scene(), "en")
    assert "http" not in text.replace("http://www.w3.org/2000/svg", "")
    assert " id=" not in text  # several figures may stand in one page


def test_scale_and_paper():
    text = svg(scene(), "en", scale=2, paper=False)
    assert 'width="200" height="160" viewBox="0 0 100 80"' in text
    assert 'class="plc-ink plc-ink-paper"' not in svg(illustrate("fx", "LD"), "en", paper=False)


def test_a_figure_shows_itself(tmp_path):
    figure = Figure(illustrate("s7-200", "OLD"), "zh")
    bundle = figure._repr_mimebundle_()
    assert bundle["text/plain"] == figure.scene.title.zh
    assert bundle["image/svg+xml"] == figure._repr_svg_() == svg(figure.scene, "zh")
    assert repr(figure) == repr(Figure(illustrate("s7-200", "OLD"), "zh"))
    assert "\n" not in repr(figure)
    assert figure.save(tmp_path / "old.svg").read_text(encoding="utf-8") == figure.svg()
    with pytest.raises(ValueError, match="pdf"):
        figure.save(tmp_path / "old.pdf")


def test_a_figure_speaks_the_language_in_force():
    figure = Figure(Scene(10, 10, (Words(1, 1, Text("层", "level")),), Text("图", "figure")))
    before = language()
    try:
        language("zh")
        assert "层" in figure.svg()
        language("en")
        assert "level" in figure.svg()
    finally:
        language(before)


def test_no_matplotlib_and_no_numpy():
    code = (
        "import sys; from plcteach.figure import stack, svg, table, says, mpl; "
        "svg.svg(stack.illustrate('fx', 'LD'), 'zh'); "
        "print([name for name in sys.modules if name.split('.')[0] in ('matplotlib', 'numpy', 'IPython')])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
