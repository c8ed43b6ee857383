"""Files for people without a kernel: a player page that opens by itself, one for several families, and the lessons to work on."""

from plcteach.publish.page import families_page, player_page

__all__ = ["families_page", "player_page"]
