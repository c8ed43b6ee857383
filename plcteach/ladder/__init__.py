"""Program to rung and back: reads and writes ladder drawings, and writes a ladder out as any family's instruction list."""
