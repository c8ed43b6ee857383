"""How two programs are proved to do the same, or caught at not doing it: circuits, searches, inductions, and trials by chance."""
