"""Which build and which machine the results come from, and which checksums they have."""

import json
import os
import platform
import re
import subprocess
from collections import Counter
from functools import cache
from pathlib import Path

import h5py

from runs.recipes import natural


def text(dataset):
    value = dataset[()]
    return value.decode() if isinstance(value, bytes) else str(value)


@cache
def written_by(path):
    """The program that wrote a checkpoint or record: the last entry of its provenance."""
    try:
        with h5py.File(path) as file:
            entries = file["provenance"]
            last = entries[max(entries)]
            return "rupture {}, commit {}, {}".format(
                *(text(last[name]) for name in ("version", "commit", "compiler"))
            )
    except (OSError, KeyError, ValueError):
        return "unknown (no provenance)"


def builds(root, files):
    """How many of the checkpoints and records each build has written."""
    counts: Counter[str] = Counter()
    for name in files:
        path = Path(root) / name
        if name.startswith("results/") and path.suffix == ".h5" and path.exists():
            counts[written_by(path)] += 1
    return counts.most_common()


def checksums(root, files):
    """Contents of the .sum files: (name, checksum)."""
    found = []
    for name in sorted(files, key=natural):
        path = root / name
        if name.startswith("results/data/") and path.suffix == ".sum" and path.exists():
            words = path.read_text(encoding="utf-8").split()
            checksum = words[-2] if len(words) > 1 else "empty"
            found.append((name.removeprefix("results/data/").removesuffix(".sum"), checksum))
    return found


def present_build(root):
    """Version, commit and instruction set of the programs as they are now; None without them."""
    try:
        said = subprocess.run(
            [Path(root).resolve() / "build/release/bin/load", "--version"],
            capture_output=True,
            text=True,
            check=True,
        )
    except (OSError, subprocess.CalledProcessError):
        return None
    found = re.fullmatch(r"load \((rupture .*), (\S+)\)\s*", said.stdout)
    return found and {"version": found[1], "instructions": found[2]}


def processor():
    try:
        names = re.findall(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    except OSError:
        names = []
    return f"{names[0] if names else platform.machine()}, {os.cpu_count()} cores"


def last_run(root, jobs):
    """The last run that computed any of the jobs, as ./reproduce.sh noted it, and how many; None
    if there was none."""
    try:
        lines = (Path(root) / "results/runs.jsonl").read_text(encoding="utf-8").splitlines()
    except OSError:
        return None
    for run in map(json.loads, reversed(lines)):
        end = run["started"] + run["seconds"] + 1  # both are whole seconds
        count = sum(run["started"] <= job.started < end for job in jobs)
        if count > 0:
            return run | {"jobs": count}
    return None
