"""A SLURM job that runs some commands, one after the other."""

import math
import os
import re
import shlex
import signal
import subprocess
import threading
import time
from dataclasses import dataclass, field, replace

AWAY = re.compile(  # said by srun when asking again later may help
    r"Unable to contact slurm controller|Socket timed out|Connection refused|submit limit"
)
SUBMITTED = re.compile(r"\bjob (allocation )?\d+|StepId=|JobId=", re.I)
TOO_LITTLE = re.compile(r"DUE TO TIME LIMIT|out.of.memory|oom.kill", re.I)
RETRY_EVERY = 10.0  # [s]
RETRY_FOR = 900.0  # [s]
STRICT = "set -euo pipefail; "  # as Snakemake's own shell
REPORT = re.compile(r"rupture: (\d+) (\d+)$")
BEGUN = "rupture: begun"
LAST_LINES = 5
REASONS = [  # the most telling first
    re.compile(pattern, re.M)
    for pattern in (r"\*\*\* (.*?) \*\*\*", r"^srun: error: (.*)", r"^srun: (.*)")
]


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
    attempts: int = 0
    since: float = 0.0  # when it began to wait
    ended: threading.Event = field(default_factory=threading.Event)
    code: int = 1

    def end(self, code):
        self.code = code
        self.ended.set()

    def ask_for_more(self):
        """Twice as much as at first, then three times."""
        ratio = (self.attempts + 1) / self.attempts
        self.needs = replace(
            self.needs,
            memory=math.ceil(self.needs.memory * ratio),
            time=math.ceil(self.needs.time * ratio),
        )


def script(commands):
    """Runs the commands one after the other and reports their codes, each when it ends. One that
    SIGKILL or SIGTERM ended has no code of its own: the job is being ended, or has too little
    memory."""
    lines = [
        f"exec 3>&1 >&2; echo {BEGUN} >&3",
        'echo "job ${SLURM_JOB_ID-} on ${SLURMD_NODENAME-}"',
    ]
    for number, command in enumerate(commands):
        lines += [
            f"echo; echo {shlex.quote(command.text)}",
            f"code=0; bash -c {shlex.quote(STRICT + command.text)} 3>&- || code=$?",
            'echo "$(date +%T) ended with $code"; [[ $code != 137 && $code != 143 ]] || exit "$code"',
            f'echo "rupture: {number} $code" >&3',
        ]
    return "\n".join([*lines, 'exit "$code"', ""])


def srun(settings, name, needs, count):
    return [
        "srun",
        f"--job-name={name}",
        f"--comment={settings.run}",
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
        self.srun = [*srun(settings, self.name, self.needs, len(commands)), "bash", self.script]
        self.code = None
        self.process = None
        self.interrupted = False
        self.begun = False

    def run(self):
        """Returns when all its commands have ended, or it has itself."""
        self.script.write_text(script(self.commands), encoding="utf-8")
        self.note(shlex.join(map(str, self.srun)))
        give_up = time.monotonic() + RETRY_FOR
        self.attempt()
        while self.is_away() and time.monotonic() < give_up:
            self.note(f"trying again in {RETRY_EVERY:.0f} s")
            time.sleep(RETRY_EVERY)
            self.attempt()

    def attempt(self):
        environment = os.environ | {"OMP_NUM_THREADS": str(self.needs.threads)}
        with self.log.open("a", encoding="utf-8") as log, subprocess.Popen(
            self.srun,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=log,
            text=True,
            env=environment,
            start_new_session=True,  # Ctrl-C ends it through interrupt() only
        ) as process:
            self.process = process
            if self.interrupted:
                self.interrupt()
            for line in process.stdout:
                self.hear(line.rstrip("\n"))
        self.code = process.returncode
        self.note(f"ended with {self.code}")

    def hear(self, line):
        """What the script said, and others on its way."""
        self.begun = self.begun or line == BEGUN
        if report := REPORT.match(line):
            self.commands[int(report[1])].end(int(report[2]))

    def interrupt(self):
        self.interrupted = True
        if self.process:
            self.process.send_signal(signal.SIGINT)

    def left(self):
        """The commands that have not ended."""
        return [command for command in self.commands if not command.ended.is_set()]

    def is_away(self):
        return not self.interrupted and not self.begun and AWAY.search(self.last_words())

    def is_refused(self):
        """True if SLURM did not take it."""
        return not self.begun and not SUBMITTED.search(self.said())

    def had_too_little(self):
        """Time or memory. The kernel may have killed a command without a word of SLURM's."""
        said = self.said()
        return TOO_LITTLE.search(said) or (self.code == 137 and "CANCELLED" not in said)

    def said(self):
        try:
            return self.log.read_text(errors="replace")
        except OSError as error:
            return str(error)

    def last_words(self):
        return "\n".join(self.said().splitlines()[-LAST_LINES:])

    def reason(self):
        """What SLURM said, if anything."""
        said = self.said()
        for kind in REASONS:
            if found := kind.findall(said):
                return found[-1]
        return f"srun ended with {self.code}"

    def note(self, text):
        with self.log.open("a", encoding="utf-8") as log:
            print(time.strftime("%F %T"), text, file=log)
