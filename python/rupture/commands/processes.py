"""Runs the programs of commands, here as processes of this machine."""

import os
import shutil
import signal
import subprocess
from contextlib import suppress

WITH_US = ["setpriv", "--pdeathsig", "KILL"]  # they end if we are killed


class Local:
    """What another executor has, too: start(words, folder), which returns what has the result(),
    and stop()."""

    def __init__(self):
        self.running, self.stopped = set(), False
        self.prefix = WITH_US if shutil.which(WITH_US[0]) else []

    def start(self, words, folder):
        return Process(self, words, folder)

    def stop(self):
        """Takes no lock: signals call it. Nobody needs what the programs have written."""
        self.stopped = True
        for process in list(self.running):
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)


class Process(subprocess.Popen):
    def __init__(self, executor, words, folder):
        streams = {
            "stdin": subprocess.DEVNULL,
            "stdout": subprocess.PIPE,
            "stderr": subprocess.PIPE,
        }
        options = {"text": True, "errors": "replace", "start_new_session": True}
        surroundings = {"OMP_NUM_THREADS": "1", **os.environ}
        words = [*executor.prefix, *words]
        super().__init__(words, cwd=folder, env=surroundings, **streams, **options)
        self.executor = executor
        executor.running.add(self)
        if executor.stopped:
            executor.stop()

    def result(self):
        """Exit code, standard output, and what was said on the other stream."""
        output, said = self.communicate()
        self.executor.running.discard(self)
        return self.returncode, output, said.strip()
