"""Commands of rules as SLURM jobs: what stands for Snakemake's shell() when a profile has a srun.ini.

Snakemake runs as on one machine, with many commands at a time. Each waits here until it may be a
job, started by srun, which ends with it; nobody has to ask how it is. Short commands that wait
together share a job, one after the other; the job reports the end of each, so that what is
finished stays finished if the job is ended. Jobs are named after their rules and have a log each
in results/log/slurm/.
"""

import inspect
import signal
import subprocess

from slurm.job import Command, Needs
from slurm.line import Line
from snakemake.shell import shell
from snakemake.utils import format as fill

INTERRUPTIONS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def shell_on_cluster(settings):
    line = Line(settings)

    class ClusterShell(shell):
        """Each command has a thread of its own."""

        def __new__(cls, text, **_):
            rule = inspect.currentframe().f_back.f_locals  # as the class above does
            command = Command(fill(text, stepout=2), needs_of(rule), list(rule["log"]))
            code = line.run(command)
            if code:
                raise subprocess.CalledProcessError(code, command.text)

        @staticmethod
        def open():
            """Before the first command."""
            line.open()
            for number in INTERRUPTIONS:
                if signal.getsignal(number) != signal.SIG_IGN:  # nohup
                    signal.signal(number, interrupt)

    def interrupt(*_):
        line.close()
        raise KeyboardInterrupt

    return ClusterShell


def needs_of(rule):
    resources = rule["resources"]
    return Needs(rule["rule"], rule["threads"], int(resources["mem_mb"]), int(resources["runtime"]))
