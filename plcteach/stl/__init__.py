"""Text to program and back: reads what people have, reports all it finds, and writes the canonical form."""

from plcteach.stl.reader import read
from plcteach.stl.writer import write

__all__ = ["read", "write"]
