"""The paper on which results are printed: one self-contained page, light or dark, on a telephone, a screen or a printer."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from plcteach.figure.page import FOOT

if TYPE_CHECKING:
    from collections.abc import Iterable

_POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'"

_STYLE = """
:root { color-scheme: light dark; --paper: #fff; --ink: #1f2328; --quiet: #5a626b; --rule: #cfd4da; --tint: #f3f5f7; --bar: #1f5fa8;
  --good: #1b6e20; --bad: #a4262c; --note: #fdf3d9; }
@media (prefers-color-scheme: dark) { :root { --paper: #14171a; --ink: #e6e9ec; --quiet: #a9b1b9; --rule: #3b4249; --tint: #1e2328; --bar: #6aa5e8;
  --good: #7fd083; --bad: #ff9d9d; --note: #3a2d10; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", "PingFang SC", "Microsoft YaHei", "Noto Sans CJK SC", "WenQuanYi Micro Hei", sans-serif; }
main, footer { max-width: 64rem; margin: 0 auto; padding: 1rem clamp(.75rem, 3vw, 2rem); overflow-wrap: anywhere; }
footer { color: var(--quiet); font-size: .85rem; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: .5rem 0; } h2 { font-size: 1.15rem; margin: 2rem 0 .5rem; } h3 { font-size: 1rem; margin: 1.25rem 0 .5rem; }
a { color: var(--bar); }
.quiet { color: var(--quiet); } .good { color: var(--good); } .bad { color: var(--bad); }
.marks { font-size: 1.5rem; font-weight: 600; margin: .5rem 0; }
.scroll { overflow-x: auto; overflow-wrap: normal; } td.short { white-space: nowrap; } .scroll td:last-child:nth-child(n + 4) { min-width: 16rem; } .scroll:focus-visible { outline: 2px solid var(--bar); }
table { border-collapse: collapse; } th, td { text-align: start; vertical-align: top; padding: .25rem .75rem .25rem 0; border-bottom: 1px solid var(--rule); }
th { font-weight: 600; } td.number, th.number { text-align: end; font-variant-numeric: tabular-nums; white-space: nowrap; }
.facts { display: flex; flex-wrap: wrap; gap: .5rem 2rem; margin: .75rem 0; } .facts div { min-width: 5rem; }
.facts dt { color: var(--quiet); font-size: .85rem; } .facts dd { margin: 0; font-size: 1.25rem; font-weight: 600; }
.bars { width: 100%; } .bars td.number, .bars th { width: 1%; } .bars th { white-space: nowrap; font-weight: 400; }
.bars.words { table-layout: fixed; } .bars.words th { white-space: normal; width: auto; } .bars.words td.number { width: 3.5rem; } .bars.words td:last-child { width: 30%; }
@media (max-width: 34rem) { .bars.words td:last-child { width: 15%; } }
.bar { height: 1.1rem; background: var(--bar); border-radius: 2px; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.who { margin: .25rem 0 0; font-size: .9rem; } summary { cursor: pointer; }
.beside { display: flex; flex-wrap: wrap; gap: 1rem; align-items: stretch; } .beside > div { flex: 1 1 16rem; min-width: 0; }
.beside p { margin: 0 0 .25rem; }
.text { overflow-x: auto; background: var(--tint); border: 1px solid var(--rule); border-radius: 4px; padding: .5rem 0; }
.text table { width: 100%; } .text td { border: 0; padding: 0 .75rem; white-space: pre; overflow-wrap: normal;
  font: .9rem/1.45 ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; }
.text td.number { color: var(--quiet); width: 1%; user-select: none; } .text tr.found td { background: var(--note); }
code { font-family: ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; }
.report svg { max-width: 100%; height: auto; } .report { overflow-x: auto; }
@media print { :root { --paper: #fff; --ink: #000; --quiet: #444; --rule: #aaa; --tint: #fff; --bar: #555; --good: #000; --bad: #000; --note: #eee; color-scheme: light; }
  main, footer { max-width: none; padding: 0; } .text, tr, .beside > div, h2 + * { break-inside: avoid; } h2, h3 { break-after: avoid; }
  .scroll, .text { overflow: visible; } .text td { white-space: pre-wrap; } a { color: inherit; text-decoration: none; }
  details::details-content { content-visibility: visible; block-size: auto; } }
"""


def page(title: str, body: Iterable[str], lang: str) -> str:
    """Give a whole page; nothing in it is fetched, and nothing in it runs."""
    return (
        f'<!doctype html>\n<html lang="{"zh-CN" if lang == "zh" else "en"}">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        f"<title>{escape(title)}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n<main>\n"
        + "\n".join(body)
        + f"\n</main>\n<footer>{escape(FOOT.in_(lang))}</footer>\n</body>\n</html>\n"
    )


def table(name: str, heads: Iterable[tuple[str, str]], rows: Iterable[Iterable[str]]) -> str:
    """Give a table that scrolls by itself where the screen is narrow. heads: words, and the column's kind (number, short or "")."""
    heads = list(heads)
    head = "".join(f'<th scope="col" class="{kind}">{escape(words)}</th>' for words, kind in heads)
    body = "\n".join(
        "<tr>" + "".join(f'<td class="{kind}">{one}</td>' for one, (_, kind) in zip(row, heads, strict=True)) + "</tr>"
        for row in rows
    )
    return (
        f'<div class="scroll" role="region" tabindex="0" aria-label="{escape(name)}"><table>'
        f"<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody></table></div>"
    )


def bars(name: str, rows: Iterable[tuple[str, int, str]], kind: str = "") -> str:
    """Give counts as bars: words, how many, and what stands below the words. kind: "words" where they are whole sentences."""
    rows = list(rows)
    most = max((count for _, count, _ in rows), default=0) or 1
    body = "\n".join(
        f'<tr><th scope="row">{words}{more}</th><td class="number">{count}</td>'
        f'<td><div class="bar" style="width:{100 * count / most:.1f}%"></div></td></tr>'
        for words, count, more in rows
    )
    return f'<table class="bars {kind}" aria-label="{escape(name)}"><tbody>\n{body}\n</tbody></table>'
