"""What is shown in a notebook; the only room that knows anywidget. No PLC logic is here, and none in the browser."""

from plcteach.widgets.bench import Workbench
from plcteach.widgets.desk import ExerciseDesk
from plcteach.widgets.player import StackPlayer
from plcteach.widgets.quiz import ConceptTest

__all__ = ["ConceptTest", "ExerciseDesk", "StackPlayer", "Workbench"]
