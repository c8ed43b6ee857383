"""Processes that judge texts side by side; one that hangs or dies costs its own text and no other."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections import deque
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.connection import wait
from typing import TYPE_CHECKING

from plcteach.check.marking.mark import Mark, mark_of, stopped
from plcteach.core.errors import PlcTeachError
from plcteach.core.text import Text

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from multiprocessing.connection import Connection
    from multiprocessing.context import SpawnProcess

    from plcteach.core.exercise import Exercise

SECONDS = 60.0
"""So long one text may take: a watchdog, far above what judging takes, and never a part of the verdict."""

_TEXTS_EACH = 10
"""For fewer texts than this no further process is worth its start."""

_LATE = Text("超过{seconds:g}秒", "it took more than {seconds:g} seconds")
_DIED = Text("批改进程意外结束", "the judging process ended by itself")


def marked(
    exercise: Exercise, texts: Mapping[str, str], jobs: int | None = None, seconds: float = SECONDS
) -> Iterator[tuple[str, Mark]]:
    """Judge texts by their keys in several processes, and give each mark as soon as it is there."""
    waiting = deque(texts)
    count = min(jobs, len(texts)) if jobs else min(os.cpu_count() or 1, -(-len(texts) // _TEXTS_EACH))
    workers: list[_Worker] = []
    try:
        with _undisturbed():
            workers += [_Worker.started(exercise) for _ in range(count)]
        while waiting or any(one.key for one in workers):
            for one in workers:
                if waiting and not one.key:
                    one.take(key := waiting.popleft(), texts[key])
            busy = [one for one in workers if one.key]
            told = wait(
                [one.pipe for one in busy], max(0.0, min(one.since for one in busy) + seconds - time.monotonic())
            )
            for one in busy:
                if one.pipe in told or one.since + seconds <= time.monotonic():
                    yield one.key, one.answer(exercise, seconds)
                    one.key = ""
    finally:
        for one in workers:
            one.end()


@dataclass(slots=True)
class _Worker:
    """One process, the pipe to it, the key of the text it is at, and since when."""

    process: SpawnProcess
    pipe: Connection
    key: str = ""
    since: float = 0.0

    @classmethod
    def started(cls, exercise: Exercise) -> _Worker:
        context = get_context("spawn")
        ours, theirs = context.Pipe()
        process = context.Process(target=_work, args=(theirs, exercise), daemon=True)
        process.start()
        theirs.close()
        return cls(process, ours)

    def take(self, key: str, text: str) -> None:
        if not self.since:
            self.ready()
        self.key, self.since = key, time.monotonic()
        self.pipe.send(text)

    def ready(self) -> None:
        """Wait until the process has started; PlcTeachError if it never does."""
        try:
            self.pipe.recv()
        except (EOFError, OSError):
            msg = "a process for judging could not be started; a script that calls plcteach needs `if __name__ == '__main__':`"
            raise PlcTeachError(msg) from None

    def answer(self, exercise: Exercise, seconds: float) -> Mark:
        """Give the mark that has come, or say why none has; then another process takes this one's place."""
        reason = _LATE.format(seconds=seconds)
        try:
            if self.pipe.poll():
                told = self.pipe.recv()
                return told if isinstance(told, Mark) else stopped(_DIED)
        except (EOFError, OSError):
            reason = _DIED
        self.end()
        with _undisturbed():
            fresh = _Worker.started(exercise)
        self.process, self.pipe, self.since = fresh.process, fresh.pipe, 0.0
        return stopped(reason)

    def end(self) -> None:
        self.process.kill()
        self.process.join()
        self.pipe.close()


def _work(pipe: Connection, exercise: Exercise) -> None:
    """Judge what comes through the pipe until it closes."""
    pipe.send("ready")
    while True:
        try:
            text = pipe.recv()
        except (EOFError, OSError):
            return
        pipe.send(mark_of(exercise, text))


@contextmanager
def _undisturbed() -> Iterator[None]:
    """Start processes that Ctrl-C does not reach: who started them ends them, and nothing is printed over the terminal."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
