"""The rules, one decorated function each; what they say stands in core.diagnostic, their programs in the dialects."""

from plcteach.check.rules import blocks, coils, course, loops, rails, stack, style, timers
from plcteach.check.rules.registry import PROGRAM_RULES, STACK_RULES

__all__ = ["PROGRAM_RULES", "STACK_RULES", "blocks", "coils", "course", "loops", "rails", "stack", "style", "timers"]
