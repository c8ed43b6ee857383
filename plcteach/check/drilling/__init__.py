"""Random tasks from a seed: shapes draws a ladder, slips makes the lists that a learner might write for it, told says what is true of it."""
