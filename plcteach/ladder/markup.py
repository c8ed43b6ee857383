"""Reads a text of XML as a small tree with line numbers, and stops at the first thing that a harmless file does not have.

A document type, entities and whatever lies outside of the file are refused (by defusedxml); so are too many bytes, elements,
levels and attributes, while they are being read and not afterwards. Namespaces are left out of the names.
"""

from __future__ import annotations

import codecs
import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NoReturn

from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.errors import PlcTeachError
from plcteach.core.source import Span, decode
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

MOST_BYTES = 2_000_000
MOST_ELEMENTS = 100_000
MOST_LEVELS = 64
MOST_ATTRIBUTES = 40

_DECLARED = re.compile(rb"""<\?xml[^>]{0,80}encoding\s*=\s*["'](?P<name>[A-Za-z0-9._-]{1,20})["']""")
_ENCODINGS = frozenset({"ascii", "cp1252", "gb18030", "gb2312", "gbk", "iso8859-1", "iso8859-15", "utf-8"})

_CHARACTERS = Text("这些字符在XML里不能这样写", "these characters cannot stand so in XML")
_REASONS = {
    "no element found": Text("文件到这里就断了", "the file breaks off here"),
    "unclosed token": Text("一个标记没有写完", "a tag is not complete"),
    "mismatched tag": Text("结尾标记和开头的不是一对", "the closing tag does not match the one that is open"),
    "duplicate attribute": Text("同一个属性写了两次", "an attribute stands there twice"),
    "undefined entity": Text("用了没有声明的实体", "an entity is used that nobody declared"),
    "junk after document element": Text("最外层的元素结束后还有内容", "something follows the outermost element"),
}  # fmt: skip


class RefusedError(PlcTeachError):
    """Ends a reading at once, with what there is to say; it never leaves the room."""

    def __init__(self, found: Diagnostic) -> None:
        """Keep the finding."""
        self.found = found
        super().__init__(found.text.en)


def refuse(code: str, at: int, /, **values: object) -> NoReturn:
    """End a reading at a row."""
    raise RefusedError(rule(code).at(Span(at), **values))


@dataclass(slots=True, eq=False)
class Element:
    """One element: its name, its attributes, the row on which it begins, what stands in it, and its text."""

    name: str
    attributes: Mapping[str, str]
    row: int
    inside: list[Element] = field(default_factory=list)
    pieces: list[str] = field(default_factory=list)

    def __repr__(self) -> str:
        return f"<{self.name} {dict(self.attributes)}>"

    @property
    def text(self) -> str:
        """The text that stands right in it, its blanks in order."""
        return " ".join("".join(self.pieces).split())

    def get(self, name: str) -> str:
        """Give an attribute, or nothing."""
        return self.attributes.get(name, "").strip()

    def all(self, name: str) -> list[Element]:
        """Give the elements of a name that stand right in it."""
        return [one for one in self.inside if one.name == name]

    def at(self, path: str) -> list[Element]:
        """Give the elements at a path of names ("types/pous/pou")."""
        found = [self]
        for name in path.split("/"):
            found = [one for outer in found for one in outer.all(name)]
        return found

    def every(self) -> Iterator[Element]:
        """Give it and everything in it, in the order of the file."""
        waiting = [self]
        while waiting:
            one = waiting.pop()
            yield one
            waiting += reversed(one.inside)


def read_markup(data: bytes | str) -> Element | Diagnostic:
    """Read a text of XML; what is no XML, or is more than a file of a lesson can be, gives a finding instead."""
    try:
        return _parsed(_text(data))
    except RefusedError as refused:
        return refused.found


def _text(data: bytes | str) -> str:
    size = len(data) if isinstance(data, bytes) else len(data.encode("utf-8", errors="replace"))
    if size > MOST_BYTES:
        _too_large(1, Text("字节", "bytes"), MOST_BYTES)
    text = data if isinstance(data, str) else decode(data, _encoding(data))
    return text.encode("utf-8", errors="replace").decode("utf-8").removeprefix("\ufeff")


def _encoding(data: bytes) -> str | None:
    """Give the encoding that a file says it has, if it is one that people write in."""
    match = _DECLARED.match(data)
    try:
        name = codecs.lookup(match["name"].decode("ascii")).name if match else ""
    except LookupError:
        return None
    return name if name in _ENCODINGS else None


def _too_large(row: int, what: Text, most: int) -> NoReturn:
    refuse("XML002", row, what=what, most=most)


def _parsed(text: str) -> Element:
    from defusedxml import DefusedXmlException  # noqa: PLC0415 (opened only where there is a file of XML)
    from defusedxml.expatreader import DefusedExpatParser  # noqa: PLC0415

    parser = DefusedExpatParser(forbid_dtd=True)
    growing = _Growing(parser)
    parser.setContentHandler(growing)
    parser.setErrorHandler(growing)
    try:
        parser.feed(text)
        parser.close()
    except DefusedXmlException:
        refuse("XML003", growing.row)
    if growing.root is None:  # pragma: no cover (the parser has said so before)
        refuse("XML001", 1, reason=_CHARACTERS)
    return growing.root


class _Growing:
    """The tree while the parser reports what it reads."""

    def __init__(self, parser: Any) -> None:
        self.parser = parser
        self.root: Element | None = None
        self.open: list[Element] = []
        self.count = 0

    @property
    def row(self) -> int:
        """The row that is being read."""
        return max(1, int(self.parser.getLineNumber()))

    def startElement(self, name: str, attributes: Mapping[str, str]) -> None:  # noqa: N802 (the parser calls it so)
        """Begin an element."""
        self.count += 1
        for what, size, most in (
            (Text("个元素", "elements"), self.count, MOST_ELEMENTS),
            (Text("层嵌套", "levels of nesting"), len(self.open) + 1, MOST_LEVELS),
            (Text("个属性（一个元素里）", "attributes in one element"), len(attributes), MOST_ATTRIBUTES),
        ):
            if size > most:
                _too_large(self.row, what, most)
        local = {key.rpartition(":")[2]: value for key, value in attributes.items() if not key.startswith("xmlns")}
        one = Element(name.rpartition(":")[2], local, self.row)
        if self.open:
            self.open[-1].inside.append(one)
        else:
            self.root = one
        self.open.append(one)

    def endElement(self, _name: str) -> None:  # noqa: N802
        """End an element."""
        self.open.pop()

    def characters(self, text: str) -> None:
        """Take a stretch of text."""
        self.open[-1].pieces.append(text)

    def fatalError(self, error: Any) -> None:  # noqa: N802
        """Say where the text stops being XML."""
        reason = _REASONS.get(error.getMessage(), _CHARACTERS)
        refuse("XML001", max(1, error.getLineNumber() or 1), reason=reason)

    def ignored(self, *_: object) -> None:
        """Pass over what is no part of the tree."""

    setDocumentLocator = startDocument = endDocument = processingInstruction = ignorableWhitespace = ignored  # noqa: N815
    startPrefixMapping = endPrefixMapping = skippedEntity = notationDecl = unparsedEntityDecl = warning = ignored  # noqa: N815
    error = fatalError
