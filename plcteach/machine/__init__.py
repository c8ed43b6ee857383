"""Program to trace: one pure `step` over any signal, run scan by scan in virtual time, with words, timers, counters and blocks."""

from plcteach.machine.scan import Domain, Memory, Scan, Trace, run, sweep
from plcteach.machine.signals import ONE, ZERO, Column, Signal, X
from plcteach.machine.step import Step, step

__all__ = ["ONE", "ZERO", "Column", "Domain", "Memory", "Scan", "Signal", "Step", "Trace", "X", "run", "step", "sweep"]
