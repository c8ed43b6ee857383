"""What can be said of a file before its program is read: that it cannot be opened, and that it is no text."""

from __future__ import annotations

import re

from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.source import Span
from plcteach.core.text import Text, same

_ENOUGH_BYTES = 8_192
_MARKS = (b"\xff\xfe", b"\xfe\xff")


def no_text(data: bytes) -> bool:
    """Say whether bytes are not the text of a program, as those of a project file are not."""
    return b"\0" in data[:_ENOUGH_BYTES] and not data.startswith(_MARKS)


_PROJECT = Text("多半是软件自己的工程文件", "most likely it is a project as the software keeps it")
_DOCUMENT = Text("而是{what}（.{ending}）", "it is {what} (.{ending})")
_DOCUMENTS = {
    r"pdf": Text("PDF文档", "a PDF document"),
    r"docx?|odt|pages|rtf|wps": Text("文字处理软件的文档", "a word processor's document"),
    r"et|ods|xlsx?": Text("电子表格", "a spreadsheet"),
    r"dps|odp|pptx?": Text("演示文稿", "a set of slides"),
    r"ipynb": Text("Jupyter笔记本", "a Jupyter notebook"),
    r"bmp|gif|hei[cf]|jfif|jpe?g|png|svg|tiff?|webp": Text("图片", "a picture"),
    r"avi|mov|mp4": Text("视频", "a film"),
    r"html?": Text("网页", "a web page"),
    r"py": Text("Python程序", "a Python program"),
    r"exe": Text("Windows程序", "a program for Windows"),
    r"7z|bz2|gz|rar|tar|tgz|xz|zip": Text("压缩文件", "an archive"),
}


def document(ending: str) -> Diagnostic | None:
    """Give the finding that a file is a document of another kind, by the ending of its name; None if it may be a list."""
    for endings, what in _DOCUMENTS.items():
        if re.fullmatch(endings, ending, re.IGNORECASE):
            return rule("FIL002").at(Span(1), what=_DOCUMENT.format(what=what, ending=ending.lower()))
    return None


def project() -> Diagnostic:
    """Give the finding that a file's bytes are no text."""
    return rule("FIL002").at(Span(1), what=_PROJECT)


def unread(trouble: OSError) -> Diagnostic:
    """Give the finding that a file cannot be opened or read, with the system's reason."""
    return rule("FIL001").at(Span(1), reason=same(trouble.strerror or type(trouble).__name__))
