"""Writes the plan by which Ninja computes a user's sweep, results/sweeps/NAME/plan/build.ninja.

./reproduce.sh writes it, and Ninja does so again (python -m chains.plan) once the points are there
that decide which other points there are. $RUPTURE_PLAN is the request as a JSON object: files,
cores, megabytes. What Ninja is to compare by date are files that are written only when they change:
so neither dates of sources, nor the folder, nor the number of cores makes anything stale."""

import json
import math
import os
import re

from chains.store import RESULTS, SPARE, digest_file, digest_of_tool, is_current, write_if_changed
from rupture.errors import Failure, UsageError
from report.written import note

MOST_BATCHES = 64  # of up to LARGEST_BATCH points, so that many cores have work until the end
LARGEST_BATCH = 60  # points
FILES = ("build.ninja", ".ninja_log", ".ninja_deps")
# A profile's `step` starts commands as the shell does (docs/cluster.md);
# setpriv ends them with a Ninja that is killed.
STEP = (
    'export OMP_NUM_THREADS=$threads; exec "$$RUPTURE_STEP"'
    ' -c \'exec setpriv --pdeathsig TERM "$$RUPTURE_PYTHON" -P'
)
RULES = f"""\
ninja_required_version = 1.10
builddir = {{folder}}
threads = 1

rule points
  command = {STEP} -S -m chains.point $todo'
  rspfile = $todo
  rspfile_content = $works
  restat = 1
  description = $what

rule plan
  command = exec "$$RUPTURE_PYTHON" -P -m chains.plan
  generator = 1
  restat = 1
  description = plan what follows from these
"""


def escaped(text):
    return str(text).replace("$", "$$")


def paths(*files):
    return " ".join(re.sub("([ :$])", r"$\1", str(file)) for file in files)


def batches_of(points):
    """The points of each job, in their order."""
    size = min(LARGEST_BATCH, math.ceil(len(points) / MOST_BATCHES))
    return [points[start : start + size] for start in range(0, len(points), size or 1)]


class Plan:
    """The lines of the plan, as they come."""

    def __init__(self, cores, megabytes, folder):
        self.folder, self.file = folder, folder / "build.ninja"
        self.cores, self.megabytes = cores, megabytes
        self.pools, self.points, self.edges, self.written, self.tools = {}, {}, {}, [], set()

    def pool(self, needs):
        """Limits how many points of this size run at a time."""
        memory, threads = needs["megabytes"], needs["threads"]
        most = min(self.cores // threads, (self.megabytes or math.inf) // memory)
        name = f"points_of_{memory}_MB_{threads}"
        self.pools[name] = f"pool {name}\n  depth = {max(1, most)}\n"
        return name

    def add_points(self, points):
        """Adds the points of a chain and those that they come from; many go together in batches."""
        new = {point.path: point for point in points if point.path not in self.points}
        self.points |= new
        above = [point.of for point in new.values() if point.of]
        if above:
            self.add_points(above)
        for batch in batches_of([*new.values()]):
            self.add_batch(batch)

    def add_batch(self, batch):
        first, works = batch[0], [point.work | {"path": str(point.path)} for point in batch]
        needs, what = first.chain.needs, first.described
        if len(batch) > 1:
            what = f"{first.chain.name}: {len(batch)} points"
        kept = [point.file(name) for point in batch for name in point.chain.keep]
        inputs = [digest_file(tool) for point in batch for tool in point.tools]
        inputs += [file for point in batch for file in point.inputs]
        todo = first.path.with_suffix(".todo")
        about = {"chain": first.chain.name, "described": what, "works": works}
        self.edges[first.path] = (
            f"build {paths(*(point.path for point in batch))}{' | ' if kept else ''}{paths(*kept)}:"
            f" points | {paths(*dict.fromkeys(inputs))}\n  pool = {self.pool(needs)}\n"
            f"  threads = {needs['threads']}\n  todo = {todo}\n  what = {escaped(what)}\n"
            f"  works = {escaped(json.dumps(about))}\n"
        )
        self.tools.update(tool for point in batch for tool in point.tools)
        self.written += [todo, *kept, *(file.with_name(f"{file.name}.part") for file in kept)]
        outputs = [*(point.path for point in batch), *kept]
        self.written += [SPARE / file.name for file in outputs if len(batch) > 1]
        for point in batch:
            ends = (".json", ".origin", ".crash")
            self.written += [point.path.with_suffix(end) for end in ends]
            if point.path.exists() and not is_current(point.path):
                point.path.unlink()  # damaged or edited: it is computed again

    def write(self):
        self.written += [self.folder / name for name in FILES]
        self.written += [RESULTS / "jobs.jsonl", *map(digest_file, self.tools)]
        note(RESULTS, *self.written)
        for tool in self.tools:
            write_if_changed(digest_file(tool), digest_of_tool(tool))
        rules = RULES.replace("{folder}", str(self.folder))
        write_if_changed(self.file, "\n".join([rules, *self.pools.values(), *self.edges.values()]))


def write_plan(cores, megabytes, file, own=None):
    """Writes the plan of a user's sweep, and returns its path. Raises UsageError, with the file and
    the line, if anything in the file leads nowhere. `own`: the sweep if it is checked already."""
    from chains.sweeps import OwnSweep  # which imports this module, too

    own = own or OwnSweep(file)
    chains, plan = own.chains, Plan(cores, megabytes, own.stem.parent / "plan")
    plan.add_points(own.points or [])
    deciding = chains.deciding
    if own.points is None and all(point.path.exists() for point in deciding):
        raise Failure(f"{file}: its points depend on what no other point reports")
    for chain in {point.chain: None for point in deciding}:
        plan.add_points([point for point in deciding if point.chain is chain])
    if deciding:  # Ninja makes these before anything else, and then the plan anew
        edge = f"build {plan.file}: plan | {paths(*(point.path for point in deciding))}\n"
        plan.edges[plan.file] = edge
    plan.write()
    return plan.file


if __name__ == "__main__":
    try:
        write_plan(**json.loads(os.environ["RUPTURE_PLAN"]))
    except (Failure, UsageError) as error:
        raise SystemExit(str(error)) from None
