"""The programs as they are now, the machine, and the last run."""

import os
import platform
import re
from contextlib import suppress
from pathlib import Path

from report.written import is_intact, written
from rupture.commands.folder import parsed, read_own
from rupture.errors import Failure
from rupture.programs import output_of
from rupture.tools.command_line import plural

RUNS = "runs.jsonl"


def is_moment(value):
    """Seconds since 1970, or between two moments."""
    return isinstance(value, (int, float)) and 0 <= value < 1e11


RUN = {"recipes": str, "where": str, "started": is_moment, "seconds": is_moment}


def noted(path, form):
    """The JSON in each line of a file, of those that have the form."""
    with suppress(OSError):
        for line in read_own(path).decode(errors="replace").splitlines():
            with suppress(ValueError):
                yield parsed(line, form)


def runs_of(results):
    """The calls of ./reproduce.sh; none if these are not as they were written."""
    path = results / RUNS
    return [*noted(path, RUN)] if is_intact(path, written(results).get(RUNS)) else []


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
    for run in reversed(runs_of(root / "results")):
        end = run["started"] + run["seconds"] + 1  # both are whole seconds
        count = sum(run["started"] <= job.get("started", 0) < end for job in jobs)
        if count > 0:
            return run | {"jobs": count}
    return None
