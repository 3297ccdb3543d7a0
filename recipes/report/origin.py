"""What the results come from: the jobs in results/jobs.jsonl, builds of the programs, the machine,
checksums."""

import json
import os
import platform
import re
from collections import Counter
from contextlib import suppress
from functools import cache
from pathlib import Path

from rupture.errors import Failure
from rupture.programs import output_of
from rupture.tools.command_line import plural
from claims.recipes import natural


def steps(jobs):
    """{rule: its jobs}, in the order in which the rules came first."""
    rules = dict.fromkeys(job["rule"] for job in jobs)
    return {rule: [job for job in jobs if job["rule"] == rule] for rule in rules}


def noted(path):
    """The JSON in each line of a file. Where the end of a line is missing, the run was killed."""
    for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else []:
        with suppress(ValueError):
            yield json.loads(line)


class Accounts:
    """What was noted about the job that last made a file, by file."""

    def __init__(self, root):
        jobs = noted(root / "results/jobs.jsonl")
        self.by_output = {output: job for job in jobs for output in job["output"]}

    def files_behind(self, recipe, files=()):
        """The results of a recipe, or these files, and all that they were made from, directly or
        not."""
        own = (path for path in self.by_output if path.startswith(f"results/{recipe}/"))
        waiting = [*own, *files]
        found = set(waiting)
        while waiting:
            inputs = self.by_output.get(waiting.pop(), {}).get("input", [])
            new = set(inputs) - found
            found |= new
            waiting.extend(new)
        return found

    def jobs(self, files):
        """The jobs that made the files, in the order in which they started."""
        accounts = [self.by_output[path] for path in files if path in self.by_output]
        found = {(job["rule"], *job["output"]): job for job in accounts}
        return sorted(found.values(), key=lambda job: (job["started"], job["rule"]))


@cache
def written_by(path):
    """The program that wrote a checkpoint or record: the last entry of its provenance."""
    import h5py  # takes longer to load than most commands do

    try:
        with h5py.File(path, "r", locking=False) as file:
            entries = file["provenance"]
            last = entries[max(entries)]
            words = (last[name].asstr()[()] for name in ("version", "commit", "compiler"))
            return "rupture {}, commit {}, {}".format(*words)
    except (OSError, KeyError, TypeError, ValueError):
        return "unknown (no provenance)"


def builds(root, files):
    """How many of the checkpoints and records each build has written."""
    paths = [root / name for name in sorted(files) if re.fullmatch(r"results/.*\.h5", name)]
    return Counter(written_by(path) for path in paths if path.exists()).most_common()


def checksums(root, files):
    """(name, checksum of its content) of the files that points wrote."""
    found = []
    for name in sorted(files, key=natural):
        path = root / name
        if name.startswith("results/data/points/") and path.suffix == ".json" and path.exists():
            written = json.loads(path.read_text(encoding="utf-8")).get("checksums", {})
            found += [(f"points/{path.stem}.{file}", sum) for file, sum in written.items()]
    return found


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
        count = sum(run["started"] <= job["started"] < end for job in jobs)
        if count > 0:
            return run | {"jobs": count}
    return None
