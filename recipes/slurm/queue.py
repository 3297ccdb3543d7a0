"""SLURM's queue, as far as it holds jobs of this folder."""

import os
import subprocess
import time

LEAVING = 120.0  # [s] that cancelled jobs may take to be gone


def jobs_of(label):
    """{number: name} of this folder's jobs in the queue."""
    listed = subprocess.run(
        ["squeue", "--noheader", f"--user={os.getuid()}", "--format=%A %j %k"],
        capture_output=True,
        text=True,
        check=False,
    )
    lines = (line.split(maxsplit=2) for line in listed.stdout.splitlines())
    return {line[0]: line[1] for line in lines if line[2:] == [label]}


def cancel(numbers):
    if numbers:
        subprocess.run(["scancel", *numbers], check=False)


def end_leftovers(label):
    """Ends jobs of this folder from a run that was killed: they would write the same files."""
    left = jobs_of(label)
    cancel(left)
    give_up = time.monotonic() + LEAVING
    while left and jobs_of(label) and time.monotonic() < give_up:
        time.sleep(0.5)
