"""Files for people without a kernel: a player in one page that needs no network, worksheets as PDF."""

from plcteach.publish.page import player_page

__all__ = ["player_page"]
