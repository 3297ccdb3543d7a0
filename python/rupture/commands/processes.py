"""Runs the programs of commands, here as processes of this machine."""

import os
import shutil
import signal
import subprocess
from contextlib import suppress
from weakref import WeakSet

WITH_US = ["setpriv", "--pdeathsig"]  # they get a signal if we are killed


class Local:
    """What another executor has, too: start(words, folder), which returns what has the result(),
    and stop(). `step` takes the place of a shell, and runs the command in an allocation of SLURM.
    """

    def __init__(self, step=None):
        self.running: WeakSet[Process] = WeakSet()
        self.stopped = False
        self.ending = signal.SIGINT if step else signal.SIGKILL  # a step ends what runs elsewhere
        self.prefix = (
            [*WITH_US, self.ending.name.removeprefix("SIG")] if shutil.which(WITH_US[0]) else []
        )
        self.prefix += [str(step), "-c", 'exec "$0" "$@"'] if step else []

    def start(self, words, folder):
        process = Process(
            [*self.prefix, *words],
            cwd=folder,
            env={"OMP_NUM_THREADS": "1", **os.environ},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            errors="replace",
            start_new_session=True,
        )
        self.running.add(process)
        if self.stopped:
            self.stop()
        return process

    def stop(self):
        """Takes no lock: signals call it. Nobody needs what the programs have written."""
        self.stopped = True
        for process in list(self.running):
            with suppress(ProcessLookupError):
                os.killpg(process.pid, self.ending)


class Process(subprocess.Popen):
    def result(self):
        """Exit code, standard output, and what was said on the other stream."""
        output, said = self.communicate()
        return self.returncode, output, said.strip()
