"""The text that a learner typed into a form of the platform, out of the web page as which the platform keeps it."""

from __future__ import annotations

from html.parser import HTMLParser

_ROWS = {"p", "div", "br", "li", "tr", "pre", "h1", "h2", "h3"}
_UNSEEN = {"script", "style", "head", "title"}


class _Typed(HTMLParser):
    """Keeps the words of a page, each block on rows of its own."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.words: list[str] = []
        self.unseen = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:  # noqa: ARG002 (the parser calls it so)
        self.unseen += tag in _UNSEEN
        if tag in _ROWS:
            self.words.append("\n")

    def handle_endtag(self, tag: str) -> None:
        self.unseen = max(0, self.unseen - (tag in _UNSEEN))
        if tag in _ROWS - {"br"}:
            self.words.append("\n")

    def handle_data(self, data: str) -> None:
        if not self.unseen:
            self.words.append(data)


def web_text(page: str) -> str:
    """Give the rows that a learner typed, empty ones left out."""
    typed = _Typed()
    typed.feed(page)
    typed.close()
    rows = "".join(typed.words).replace("\xa0", " ").splitlines()
    return "\n".join(row.rstrip() for row in rows if row.strip())
