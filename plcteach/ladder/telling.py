"""Tells a ladder drawing from an instruction list by its first line; reads neither."""

from __future__ import annotations

import re

from plcteach.core.source import half_width

MOST_CHARACTERS = 100_000

PLAIN = str.maketrans(
    dict.fromkeys("─━—―╌┄═", "-") | dict.fromkeys("│┃║┆╎", "|") | dict.fromkeys("┌┐└┘├┤┬┴┼╭╮╯╰┏┓┗┛┣┫┳┻╋╔╗╚╝╠╣╦╩╬", "+")
)
HEADING = re.compile(r"\s*(?:NETWORK|RUNG|网络|程序段|梯级)\s*\d{0,9}\s*(?P<rest>(?![\w.]).*)", re.IGNORECASE)
CONFIGURATION = re.compile(r"\s*%[A-Z]+\d+\s*:\s*[A-Z]+\s*=.*", re.IGNORECASE)
"""A line before the first rung that sets up a block: %TM0: TYPE=TON TB=10ms P=100."""

_COMMENTS = re.compile(r"//[^\n]*|\(\*.*?(?:\*\)|\Z)", re.DOTALL)
_INSIDE = re.compile(r"\[[^\[\]]*\]")
_DASHED = re.compile(r"[-|+\[].*?(?:(?<=\])\s*-|(?<=-)\s*\([^()]*\))")


def is_drawing(text: str) -> bool:
    """Say whether a text is a ladder and not a program, by its first line, comments, headings and the lines that set up blocks apart.

    That line holds `--` or `->`, or it begins with a symbol or a wire and joins symbols with single dashes: `[I0.0]-(Q0.0)`.
    """
    for line in _COMMENTS.sub("", _plain(text[:MOST_CHARACTERS])).splitlines():
        if line.strip(" |+\t") and not HEADING.fullmatch(line) and not CONFIGURATION.fullmatch(line):
            return "--" in line or "->" in line or bool(_DASHED.match(_INSIDE.sub("[]", line.strip())))
    return False


def _plain(text: str) -> str:
    return half_width(text.translate(PLAIN)).replace("→", "->")


def is_plcopen(text: str) -> bool:
    """Say whether a text is an XML file, which is read as PLCopen, by how it begins."""
    return text[:200].lstrip("\ufeff \t\r\n").startswith("<")
