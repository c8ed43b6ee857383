"""Program to rung and back: reads and writes ladder drawings, and writes a ladder out as any family's instruction list."""

from plcteach.ladder.either import read_either
from plcteach.ladder.lower import lower, lower_lines
from plcteach.ladder.meaning import meaning
from plcteach.ladder.picture import is_drawing, read_drawing
from plcteach.ladder.typeset import write_drawing

__all__ = ["is_drawing", "lower", "lower_lines", "meaning", "read_drawing", "read_either", "write_drawing"]
