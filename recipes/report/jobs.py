"""The commands behind the results of a recipe: results/NAME/jobs.jsonl, a line for each."""

import json
import os
import re
from collections import Counter

from claims.recipes import RECIPES
from rupture.commands.folder import in_lines, parsed, read_own
from rupture.commands.identity import Made
from rupture.commands.script import with_sources
from rupture.commands.store import have_plain_names, is_moment
from rupture.errors import Failure
from rupture.replacing import write_whole

JOBS = "jobs.jsonl"


JOB = {"id": re.compile("[0-9a-f]+"), "command": str, "inputs?": {"": str}, "build?": str}
JOB |= {"started?": is_moment, "seconds?": is_moment, "checksums?": have_plain_names}
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
        found = work.making.known(work) or {}
        known = {name: found[name] for name in STORED if found.get(name) is not None}
        yield in_lines(job | known)


def write_jobs(folder, jobs):
    write_whole(folder / JOBS, "".join(f"{json.dumps(job)}\n" for job in jobs))


def read_jobs(folder):
    path = folder / JOBS
    try:
        return [parsed(line, JOB, in_lines) for line in read_own(path).decode().splitlines()]
    except FileNotFoundError:
        return []
    except (OSError, ValueError) as error:
        raise Failure(f"{path} is not a list of commands ({error})") from error


def builds_of(jobs):
    """How many of the commands each build of the programs has done."""
    return Counter(job["build"] for job in jobs if "build" in job).most_common()


def files_of(jobs):
    """(ID of its command, name, checksum of its content) of checkpoints and records."""
    return [(job["id"], *file) for job in jobs for file in job.get("checksums", {}).items()]
