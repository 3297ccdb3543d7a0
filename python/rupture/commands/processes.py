"""Runs programs of commands: here, as processes of this machine."""

import os
import shutil
import signal
import subprocess
from contextlib import suppress
from typing import NamedTuple

WITH_US = ["setpriv", "--pdeathsig", "KILL"]  # they end if we are killed


class Ended(NamedTuple):
    """A program that has."""

    code: int
    output: str
    sentence: str


class Local:
    """What another executor has, too: start(words, folder), of which result() is awaited, and
    stop()."""

    def __init__(self):
        self.running, self.stopped = set(), False
        self.prefix = WITH_US if shutil.which(WITH_US[0]) else []
        self.surroundings = {"OMP_NUM_THREADS": "1", **os.environ}

    def start(self, words, folder):
        return Process(self, words, folder)

    def stop(self):
        """Takes no lock: a signal may come at any time. Nothing that they have written is needed."""
        self.stopped = True
        for process in list(self.running):
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)


class Process:
    def __init__(self, executor, words, folder):
        self.executor = executor
        self.process = subprocess.Popen(
            [*executor.prefix, *words],
            cwd=folder,
            env=executor.surroundings,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            errors="replace",
            start_new_session=True,
        )
        executor.running.add(self.process)
        if executor.stopped:
            executor.stop()

    def result(self):
        output, sentence = self.process.communicate()
        self.executor.running.discard(self.process)
        return Ended(self.process.returncode, output, sentence.strip())
