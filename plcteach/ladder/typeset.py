"""Writes ladders as text drawings in their one canonical form, which `read_drawing` reads back to equal ladders."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plcteach.core.source import printable
from plcteach.ladder.layout import RAIL, Layout, Post, layout
from plcteach.ladder.symbols import columns, drawn, drawn_input

if TYPE_CHECKING:
    from plcteach.core.ladder import Ladder, Rung


def write_drawing(ladder: Ladder | Rung) -> str:
    """Draw a ladder, or one rung, as text; where any rung has a title, every rung gets a heading."""
    rungs = getattr(ladder, "rungs", (ladder,))
    headed = any(one.title for one in rungs)
    parts = [
        "\n".join(_heading(one, number, headed=headed) + _rows(layout(one))) for number, one in enumerate(rungs, 1)
    ]
    title = "" if ladder in rungs else _one_line(ladder.title)
    head = [*([f"// {title}"] if title else []), *getattr(ladder, "configuration", ())]
    return "".join(f"{part}\n" for part in (*head, "\n\n".join(parts)) if part)


def _heading(rung: Rung, number: int, *, headed: bool) -> list[str]:
    if not headed:
        return []
    title = _one_line(rung.title)
    return [f"Network {number} // {title}" if title else f"Network {number}"]


def _one_line(title: str) -> str:
    return " ".join(printable(title).split())


def _rows(plan: Layout) -> list[str]:
    posts = [post for post in plan.posts if (post.boundary, post.net) != (0, RAIL)]
    sheet = _Sheet(plan, posts)
    rows = []
    for row in range(plan.rows):
        rows.append(sheet.row(row))
        if _touching(posts, row):
            rows.append(sheet.spacer(row))
    return rows


def _touching(posts: list[Post], row: int) -> bool:
    """Say whether two separate vertical wires would touch if the next row followed at once."""
    ending = {post.boundary for post in posts if post.rows[-1] == row}
    return any(post.rows[0] == row + 1 and post.boundary in ending for post in posts)


class _Sheet:
    """One rung on its way to text: how wide each column is, and what stands in each cell."""

    def __init__(self, plan: Layout, posts: list[Post]) -> None:
        self.plan = plan
        self.posts = posts
        self.words = {(piece.row, piece.column): drawn(piece.symbol) for piece in plan.pieces}
        box = columns(drawn(plan.pieces[-1].symbol))
        self.words |= {(pin.row, plan.columns - 1): drawn_input(pin.name, box) for pin in plan.pins}
        self.wired = {(run.row, column) for run in plan.runs for column in range(run.start, run.stop)}
        self.widths = [
            max((columns(word) for (_, column), word in self.words.items() if column == wanted), default=0)
            for wanted in range(plan.columns)
        ]
        self.forked = {post.boundary for post in posts}
        self.doubled = {boundary for boundary, _ in plan.doubled}

    def row(self, row: int) -> str:
        signs = [self.gap(row, 0)]
        for column, width in enumerate(self.widths):
            word = self.words.get((row, column), "")
            fill = "-" if (word or (row, column) in self.wired) and column < self.plan.columns - 1 else " "
            signs += [word, fill * (width - columns(word)), self.gap(row, column + 1)]
        return "".join(signs).rstrip()

    def filled(self, row: int, column: int) -> bool:
        return (row, column) in self.words or (row, column) in self.wired

    def gap(self, row: int, boundary: int) -> str:
        """Give the wires on a boundary: a joint, a vertical wire passing by, a wire straight on, or nothing."""
        left, right = self.filled(row, boundary - 1), self.filled(row, boundary)
        if boundary == self.plan.columns:
            return ""
        if boundary not in self.forked:
            return "--" if right else "  "
        marks = [self.mark(posts, row) for posts in self.uprights(boundary)]
        through = "-" if left and right else " "
        apart = marks == ["+", "+"] and not any(row == post.rows[0] for post in self.posts if post.boundary == boundary)
        middle = ("  " if apart else through * 2).join(mark or through for mark in marks)
        return ("--" if left else "  ") + middle + ("--" if right else "  ")

    def uprights(self, boundary: int) -> list[list[Post]]:
        """Give the vertical wires of a boundary: all in one column, or those that close beside those that open."""
        here = [post for post in self.posts if post.boundary == boundary]
        if boundary not in self.doubled:
            return [here]
        return [[post for post in here if post.opens is opens] for opens in (False, True)]

    @staticmethod
    def mark(posts: list[Post], row: int) -> str:
        """Give the sign of a row in a column of vertical wires: a joint, a wire passing by, or nothing."""
        if any(row in post.rows for post in posts):
            return "+"
        return "|" if any(post.rows[0] < row < post.rows[-1] for post in posts) else ""

    def spacer(self, row: int) -> str:
        """Give a row that only keeps two vertical wires apart; a piece of the left rail shows that the rung goes on."""
        signs = ["  "]
        for boundary in range(1, self.plan.columns):
            signs.append(" " * self.widths[boundary - 1])
            if boundary in self.forked:
                over = [[post.rows[0] <= row < post.rows[-1] for post in posts] for posts in self.uprights(boundary)]
                signs.append(f"  {'  '.join('|' if any(some) else ' ' for some in over)}  ")
            else:
                signs.append("  ")
        return "".join(signs).rstrip() or "|"
