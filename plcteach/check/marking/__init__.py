"""A whole class's answers to one exercise: a folder as a learning platform gives it out, to marks, tables and pages."""
