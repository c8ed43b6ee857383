"""The example course: run nbgrader in this folder."""

c = get_config()  # noqa: F821

c.CourseDirectory.course_id = "plc101"
c.ClearSolutions.code_stub = {"python": "// your answer here · 在这里作答"}
c.ExecutePreprocessor.timeout = 120
