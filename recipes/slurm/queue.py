"""SLURM's queue, as far as it holds jobs of this folder."""

import os
import subprocess
import time
from dataclasses import dataclass

PATIENCE = 900.0  # [s] with a controller that is away, and with jobs that take long to end
ASK_EVERY = 2.0  # [s]


@dataclass(frozen=True)
class Queued:
    number: str
    name: str
    reason: str  # why it waits; None if it does not
    run: str


def jobs_of(folder):
    """This folder's jobs; None if squeue does not know."""
    listed = subprocess.run(
        ["squeue", "--noheader", f"--user={os.getuid()}", "--format=%A %j %r %k"],
        capture_output=True,
        text=True,
        check=False,
    )
    if listed.returncode:
        return None
    lines = (line.split(maxsplit=3) for line in listed.stdout.splitlines())
    return [Queued(*line) for line in lines if line[3:] and line[3].startswith(folder)]


def cancel(numbers):
    if numbers:
        subprocess.run(["scancel", *numbers], check=False)


def end_leftovers(folder):
    """Ends jobs of this folder from a run that was killed: they would write the same files."""
    give_up = time.monotonic() + PATIENCE
    while (left := jobs_of(folder)) != [] and time.monotonic() < give_up:
        cancel([job.number for job in left or []])
        time.sleep(ASK_EVERY)
    if left != []:
        raise RuntimeError("jobs of an earlier run in this folder may still be there (squeue)")
