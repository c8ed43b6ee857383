"""Values to shapes to ink: every picture is a Scene of plain shapes before anything draws it."""
