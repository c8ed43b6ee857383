"""What can be said of a file before its program is read: that it cannot be opened, and that it is no text."""

from __future__ import annotations

from plcteach.core.diagnostic import Diagnostic, rule
from plcteach.core.source import Span
from plcteach.core.text import same

_ENOUGH_BYTES = 8_192
_MARKS = (b"\xff\xfe", b"\xfe\xff")


def no_text(data: bytes) -> bool:
    """Say whether bytes are not the text of a program, as those of a project file are not."""
    return b"\0" in data[:_ENOUGH_BYTES] and not data.startswith(_MARKS)


def unread(trouble: OSError) -> Diagnostic:
    """Give the finding that a file cannot be opened or read, with the system's reason."""
    return rule("FIL001").at(Span(1), reason=same(trouble.strerror or type(trouble).__name__))
