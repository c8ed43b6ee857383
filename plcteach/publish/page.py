"""A player as one self-contained HTML file: it opens from a memory stick, with no kernel and no network."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from plcteach.core.text import Text, language
from plcteach.figure.page import FOOT, script, styles

if TYPE_CHECKING:
    from plcteach.figure.families import Together
    from plcteach.figure.film import Film

_POLICY = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:"


def player_page(film: Film, lang: str | None = None) -> str:
    """Give a page that plays a film; the language can be switched in it."""
    return _page(film, lang, "player.js", mount="mountPlayer", what="film")


def families_page(together: Together, lang: str | None = None) -> str:
    """Give a page that plays one ladder in several families at once."""
    return _page(together, lang, "families.js", mount="mountFamilies", what="data")


def _page(shown: Film | Together, lang: str | None, module: str, *, mount: str, what: str) -> str:
    lang = lang or language()
    return _PAGE.format(
        lang="zh-CN" if lang == "zh" else "en",
        policy=_POLICY,
        title=escape(Text(**shown.data["title"]).in_(lang)),
        styles=styles("player.css"),
        foot=escape(FOOT.in_(lang)),
        zh=escape(FOOT.zh),
        en=escape(FOOT.en),
        data=shown.json.replace("<", "\\u003c"),
        script=script(module).replace("</", "<\\/"),
        language=lang,
        mount=mount,
        what=what,
    )


_PAGE = """<!doctype html>
<html lang="{lang}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<title>{title}</title>
<style>
body {{ margin: 0; padding: 1rem; font-family: system-ui, sans-serif; background: #fff; color: #1b1b1b; }}
h1 {{ position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); margin: 0; }}
footer {{ max-width: 1400px; margin: .75rem auto 0; font-size: .8rem; color: #555; }}
@media (prefers-color-scheme: dark) {{ body {{ background: #16181c; color: #e8e8e8; }} footer {{ color: #b0b0b0; }} }}
{styles}
#player .plc-player:not(:fullscreen) {{ max-width: min(1400px, 100%); }}
#player .plc-together:not(:fullscreen) {{ max-width: 100%; }}
@media (min-width: 1400px) {{ .plc-player {{ --plc-base: clamp(15px, min(1.15vw, 2vh), 20px); }} }}
</style>
</head>
<body>
<main><h1>{title}</h1><div id="player"></div></main>
<footer data-zh="{zh}" data-en="{en}">{foot}</footer>
<script type="application/json" id="film">{data}</script>
<script type="module">
{script}
const shown = JSON.parse(document.getElementById("film").textContent);
const followLanguage = (lang) => {{
  const foot = document.querySelector("footer");
  document.documentElement.lang = lang === "zh" ? "zh-CN" : "en";
  document.title = document.querySelector("h1").textContent = say(shown.title, lang);
  foot.textContent = foot.dataset[lang];
}};
{mount}(document.getElementById("player"), {{ {what}: shown, lang: "{language}", index: 0, onLang: followLanguage }});
document.querySelector(".plc-player").focus({{ preventScroll: true }});
</script>
</body>
</html>
"""
