"""Text to program and back: reads what people have, reports all it finds, and writes canonical text or people's files."""

from plcteach.stl.reader import read
from plcteach.stl.symbols import Symbol, Symbols, read_symbols
from plcteach.stl.writer import write, write_bytes

__all__ = ["Symbol", "Symbols", "read", "read_symbols", "write", "write_bytes"]
