"""The programs as they are now, the machine, and the last run."""

import json
import os
import platform
import re
from contextlib import suppress
from pathlib import Path

from rupture.errors import Failure
from rupture.programs import output_of
from rupture.tools.command_line import plural


def noted(path):
    """The JSON in each line of a file. Where the end of a line is missing, the run was killed."""
    for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else []:
        with suppress(ValueError):
            yield json.loads(line)


def present_build():
    """Version, commit and instruction set of the programs as they are now; None without them."""
    try:
        said = output_of("load", "--version")
    except Failure:
        return None
    found = re.fullmatch(r"load \((rupture .*), (\S+)\)\s*", said)
    return found and {"version": found[1], "instructions": found[2]}


def processor():
    names = re.findall(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    return f"{names[0] if names else platform.machine()}, {plural(os.cpu_count(), 'core')}"


def last_run(root, jobs):
    """The last run that computed any of the jobs, as ./reproduce.sh noted it, and how many; None
    if there was none."""
    for run in reversed([*noted(root / "results/runs.jsonl")]):
        end = run["started"] + run["seconds"] + 1  # both are whole seconds
        count = sum(run["started"] <= job.get("started", 0) < end for job in jobs)
        if count > 0:
            return run | {"jobs": count}
    return None
