"""Runs the programs of commands as processes of this machine."""

import os
import shutil
import signal
import subprocess
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from threading import RLock
from typing import Any

from rupture.commands.machine import programs_at_a_time
from rupture.errors import MachineFailure

WITH_US = ["setpriv", "--pdeathsig", "KILL"]  # they are killed if we are
APART: dict[str, Any] = {  # how a program of a command starts, wherever it does
    "stdin": subprocess.DEVNULL,
    "stdout": subprocess.PIPE,
    "stderr": subprocess.PIPE,
    "text": True,
    "errors": "replace",
    "start_new_session": True,
}


class Local:
    """What another executor has, too: how many `cores`, and `where` they are; run(words, folder),
    stop(), close(); and watch(), with what is to be called when the number of cores changes."""

    where = ""

    def __init__(self, megabytes=None, threads=1):
        self.cores, self.threads = programs_at_a_time(megabytes, threads), threads
        self.running: set[subprocess.Popen] = set()
        self.guard, self.stopped = RLock(), False
        self.starter = ThreadPoolExecutor(1)  # no signal comes between a start and its note
        self.starter.submit(int).result()  # its thread begins before a signal may interrupt that
        self.prefix = WITH_US if shutil.which(WITH_US[0]) else []

    def run(self, words, folder):
        """Exit code, standard output, and what was said on the other stream."""
        process = self.starter.submit(self.start, words, folder).result()
        try:
            output, said = process.communicate()
            return process.returncode, output, said.strip()
        finally:
            self.running.discard(process)

    def start(self, words, folder):
        with self.guard:
            if self.stopped:
                raise MachineFailure("it was stopped")
            process = subprocess.Popen(
                [*self.prefix, *words],
                cwd=folder,
                env={"OMP_NUM_THREADS": str(self.threads), **os.environ},
                **APART,
            )
            self.running.add(process)
        return process

    def stop(self):
        """Signals call it, in the main thread. Nobody needs what the programs have written."""
        with self.guard:
            self.stopped = True
            for process in list(self.running):
                with suppress(ProcessLookupError):
                    os.killpg(process.pid, signal.SIGKILL)

    def close(self):
        self.starter.shutdown(wait=False)

    def watch(self, _):
        """It does not change."""
