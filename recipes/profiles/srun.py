"""Commands as SLURM jobs: what stands for Snakemake's shell() when a profile has a srun.ini.

Snakemake runs as on one machine, with many commands at a time. Each command waits here until it may
be a job, started by srun, which ends with it. No state is asked for and no queue is polled. Short
commands (those of the rules in GROUPED) that wait together go into one job, one after the other; a
job reports the end of each of them, so that what is finished stays finished if the job is ended.
Jobs are named after their rules and have a log each in results/log/slurm/.
"""

import configparser
import inspect
import math
import os
import re
import shlex
import subprocess
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path

from snakemake.shell import shell
from snakemake.utils import format as fill

GROUPED = {"point"}
GATHERING = 1.0  # [s] without a new command, after which a group is complete
GATHERING_AT_MOST = 5.0  # [s]
UNREACHABLE = re.compile(r"Unable to contact slurm controller|Socket timed out|Connection refused")
RETRY_EVERY = 10.0  # [s]
RETRY_FOR = 900.0  # [s]
STRICT = "set -euo pipefail; "  # as Snakemake's own shell
LAST_LINES = 5


@dataclass(frozen=True)
class Settings:
    options: list  # of srun
    jobs: int
    group: int
    logs: Path
    label: str  # by which squeue tells jobs of this folder


@dataclass(frozen=True)
class Needs:
    """What a job is for and what it asks for. Equal needs may share a job."""

    rule: str
    threads: int
    memory: int  # [MB]
    time: int  # [min]


@dataclass(eq=False)
class Command:
    text: str
    needs: Needs
    log: list  # files
    since: float = field(default_factory=time.monotonic)
    ended: threading.Event = field(default_factory=threading.Event)
    code: int = 1

    def end(self, code):
        self.code = code
        self.ended.set()


def read_settings(path, root, logs):
    ini = configparser.ConfigParser(interpolation=None)
    ini.read_string(Path(path).read_text(encoding="utf-8"), str(path))
    srun = ini["srun"]
    return Settings(
        shlex.split(srun.get("options", "")),
        srun.getint("jobs", 50),
        srun.getint("group", 20),
        Path(logs) / "slurm" / time.strftime("%Y%m%d-%H%M%S"),
        f"rupture:{root}",
    )


def end_leftovers(label):
    """Ends jobs of this folder from a run that was killed: they would write the same files."""
    left = jobs_of(label)
    if left:
        subprocess.run(["scancel", *left], check=False)
    while left and jobs_of(label):
        time.sleep(0.5)


def jobs_of(label):
    listed = subprocess.run(
        ["squeue", "--noheader", f"--user={os.getuid()}", "--format=%A %k"],
        capture_output=True,
        text=True,
        check=False,
    )
    lines = (line.split(maxsplit=1) for line in listed.stdout.splitlines())
    return [line[0] for line in lines if line[1:] == [label]]


# --- one job -------------------------------------------------------------------------------


def script(commands):
    """Runs the commands one after the other and reports `number code` after each."""
    lines = ["exec 3>&1 >&2", 'echo "job $SLURM_JOB_ID on $(hostname)"']
    for number, command in enumerate(commands):
        lines += [
            f"echo; echo {shlex.quote(command.text)}",
            f"code=0; bash -c {shlex.quote(STRICT + command.text)} 3>&- || code=$?",
            f'echo "$(date +%T) ended with $code"; echo "{number} $code" >&3',
        ]
    return "\n".join([*lines, 'exit "$code"' if len(commands) == 1 else "exit 0", ""])


def srun(settings, name, needs, count):
    return [
        "srun",
        f"--job-name={name}",
        f"--comment={settings.label}",
        "--nodes=1",
        "--ntasks=1",
        f"--cpus-per-task={needs.threads}",
        f"--mem={needs.memory}",
        f"--time={needs.time * count}",
        "--input=none",
        "--mpi=none",
        "--exact",  # within an allocation: no more than this
        "--quit-on-interrupt",
        *settings.options,
    ]


class Job:
    def __init__(self, settings, number, commands):
        self.commands = commands
        self.needs = commands[0].needs
        self.name = f"{self.needs.rule}-{number:04d}"
        self.log = settings.logs / f"{self.name}.log"
        self.script = settings.logs / f"{self.name}.sh"
        self.srun = srun(settings, self.name, self.needs, len(commands))

    def run(self):
        """Returns when all commands have ended."""
        self.script.write_text(script(self.commands), encoding="utf-8")
        self.note(shlex.join([*self.srun, "bash", str(self.script)]))
        give_up = time.monotonic() + RETRY_FOR
        code = self.attempt()
        while code and self.unreachable() and time.monotonic() < give_up:
            self.note(f"the controller cannot be reached; trying again in {RETRY_EVERY:.0f} s")
            time.sleep(RETRY_EVERY)
            code = self.attempt()
        self.note(f"ended with {code}")
        for command in self.waiting():
            self.explain(command, code)
            command.end(code or 1)

    def waiting(self):
        return [command for command in self.commands if not command.ended.is_set()]

    def attempt(self):
        environment = os.environ | {"OMP_NUM_THREADS": str(self.needs.threads)}
        with self.log.open("a", encoding="utf-8") as log:
            with subprocess.Popen(
                [*self.srun, "bash", str(self.script)],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
                env=environment,
            ) as process:
                for line in process.stdout:
                    number, code = map(int, line.split())
                    self.commands[number].end(code)
        return process.returncode

    def unreachable(self):
        """True if the job was not even submitted."""
        return len(self.waiting()) == len(self.commands) and UNREACHABLE.search(self.last_words())

    def last_words(self):
        return "\n".join(self.log.read_text(errors="replace").splitlines()[-LAST_LINES:])

    def explain(self, command, code):
        """In the rule's own log: what SLURM said about a command that has no end of its own."""
        for path in command.log:
            with open(path, "a", encoding="utf-8") as log:
                print(f"SLURM job {self.name} ended with {code} ({self.log}):", file=log)
                print(self.last_words(), file=log)

    def note(self, text):
        with self.log.open("a", encoding="utf-8") as log:
            print(time.strftime("%F %T"), text, file=log)


# --- the waiting line ----------------------------------------------------------------------


class Line:
    """Commands that wait to become jobs."""

    def __init__(self, settings):
        self.settings = settings
        self.groups = {}  # Needs: commands that wait
        self.running = 0
        self.started = 0
        self.changed = threading.Condition()
        self.server = None

    def run(self, command):
        """The command's exit code, when it has ended."""
        with self.changed:
            if not self.server:  # not for a call that only plans
                self.settings.logs.mkdir(parents=True, exist_ok=True)
                end_leftovers(self.settings.label)
                self.server = threading.Thread(target=self.serve, daemon=True)
                self.server.start()
            self.groups.setdefault(command.needs, []).append(command)
            self.changed.notify()
        command.ended.wait()
        return command.code

    def serve(self):
        while True:
            with self.changed:
                while not (commands := self.next_group()):
                    self.changed.wait(GATHERING / 4 if self.groups else None)
                self.running += 1
                self.started += 1
                job = Job(self.settings, self.started, commands)
            threading.Thread(target=self.start, args=[job], daemon=True).start()

    def start(self, job):
        try:
            job.run()
        finally:
            for command in job.waiting():
                command.end(1)
            with self.changed:
                self.running -= 1
                self.changed.notify()

    def next_group(self):
        """Takes the commands of the next job out of the line, if there may be one now."""
        free = self.settings.jobs - self.running
        for needs, waiting in self.groups.items():
            if free > 0 and (needs.rule not in GROUPED or self.is_gathered(waiting)):
                size = 1 if needs.rule not in GROUPED else math.ceil(len(waiting) / free)
                group = waiting[: min(size, self.settings.group)]
                del waiting[: len(group)]
                if not waiting:
                    del self.groups[needs]
                return group
        return []

    def is_gathered(self, waiting):
        now = time.monotonic()
        return (
            len(waiting) >= self.settings.group * self.settings.jobs
            or now - waiting[-1].since > GATHERING
            or now - waiting[0].since > GATHERING_AT_MOST
        )


def shell_on_cluster(settings):
    """What rules call instead of Snakemake's shell(); it runs in a thread of its own for each."""
    line = Line(settings)

    class ClusterShell(shell):
        def __new__(cls, text, **_):
            rule = inspect.currentframe().f_back.f_locals  # as the class above does
            command = Command(fill(text, stepout=2), needs_of(rule), list(rule["log"]))
            code = line.run(command)
            if code:
                raise subprocess.CalledProcessError(code, command.text)

    return ClusterShell


def needs_of(rule):
    resources = rule["resources"]
    return Needs(rule["rule"], rule["threads"], int(resources["mem_mb"]), int(resources["runtime"]))
