"""The commands behind the results of a recipe: results/NAME/jobs.jsonl, a line for each."""

import json
import os
from collections import Counter

from claims.recipes import RECIPES
from rupture.commands.identity import Made
from rupture.commands.script import with_sources
from rupture.replacing import write_whole

JOBS = "jobs.jsonl"
STORED = ("build", "started", "seconds", "checksums")  # what the store knows of a command


def name_of(source):
    """The file of another command, or that of a user."""
    if isinstance(source, Made):
        return f"{source.work.own}/{source.name}"
    return os.path.relpath(source, RECIPES.parent)


def jobs_of(works):
    """Of commands that a recipe has asked for (once.asked), each after those whose files it
    reads."""
    for work in with_sources(works):
        job = {"id": work.own, "command": work.typed}
        job["inputs"] = {name: name_of(source) for name, source in work.inputs.items()}
        found = work.making.store.result(work.own) or {}
        yield job | {name: found[name] for name in STORED if found.get(name) is not None}


def write_jobs(folder, jobs):
    write_whole(folder / JOBS, "".join(f"{json.dumps(job)}\n" for job in jobs))


def read_jobs(folder):
    path = folder / JOBS
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else ()
    return [json.loads(line) for line in lines]


def step_of(job):
    """analyze front, restart; a function in Python."""
    program, *words = job["command"].removeprefix("rupture ").split()
    if program == "#":  # in Python: MODULE.FUNCTION
        return words[2]
    return f"{program} {words[0]}" if program == "analyze" else program


def steps(jobs):
    """{what they do: jobs}, in the order in which it came first."""
    found: dict[str, list] = {}
    for job in jobs:
        found.setdefault(step_of(job), []).append(job)
    return found


def builds_of(jobs):
    """How many of the commands each build of the programs has done."""
    return Counter(job["build"] for job in jobs if "build" in job).most_common()


def seconds_of(jobs):
    return sum(job.get("seconds", 0) for job in jobs)


def files_of(jobs):
    """(ID of its command, name, checksum of its content) of checkpoints and records."""
    return [(job["id"], *file) for job in jobs for file in job.get("checksums", {}).items()]
