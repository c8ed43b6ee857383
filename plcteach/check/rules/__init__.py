"""The rules, one decorated function each; what they say stands in core.diagnostic, their programs in the dialects."""

from plcteach.check.rules.registry import STACK_RULES
from plcteach.check.rules import stack as _stack  # noqa: F401, I001  (importing it fills the registry)

__all__ = ["STACK_RULES"]
