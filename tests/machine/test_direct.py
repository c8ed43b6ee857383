"""Random programs with timers, counters and words: the machine and a direct evaluator agree at the end of every scan."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from random import Random

import pytest

from plcteach.machine import run
from plcteach.stl import read
