"""Figures and sweeps: ./reproduce.sh fig3, all, sweep, report."""

import json
import os
import re
import shutil
import sys
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from chains.store import digest, put_back, read, write_if_changed
from rupture.errors import Failure
from rupture.tools.command_line import plural
from report.written import LIST, append_to, note, refuse_others
from reproduce.machine import usable_megabytes
from reproduce.project import LOGS, PROGRAMS, READ, ROOT, SHARE, refuse_links, say
from reproduce.project import use_own_environment
from reproduce.processes import ensure_packages, set_up
from claims.print_claims import print_claims

RESULTS = Path("results")
STATE = Path("build/cache/state")  # in which there was nothing to do, see state_of
TRIES = 3  # in an allocation, where a node may be lost
FROM_SCRATCH = SHARE / "recipes/fig2/from_scratch.ini"
INSIDE_STEP = re.compile(r"\d{1,6}")  # the interactive step of salloc has a larger number


# --- where commands run: on this machine, or in an allocation of SLURM (docs/cluster.md) -----


def count_cores(text):
    """The cores of all nodes: SLURM_JOB_CPUS_PER_NODE is like 16(x2),8."""
    found = re.findall(r"(\d+)(?:\(x(\d+)\))?", text)
    return sum(int(cores) * int(nodes or 1) for cores, nodes in found)


def memory_of_allocation(environment, cores):
    """Memory [MB], or None if SLURM does not state it."""
    if per_core := environment.get("SLURM_MEM_PER_CPU"):
        return int(per_core) * cores
    if per_node := environment.get("SLURM_MEM_PER_NODE"):
        return int(per_node) * int(environment.get("SLURM_JOB_NUM_NODES", 1))
    return None


@dataclass(frozen=True)
class Place:
    name: str
    cores: int
    megabytes: int | None
    step: Path | None = None  # with which a command becomes a step of an allocation


def place_of(request):
    """Raises Failure if the profile cannot be used here."""
    if not request.profile:
        return Place(f"with {plural(request.cores, 'core')}", request.cores, usable_megabytes())
    if "SLURM_JOB_ID" not in os.environ:
        raise Failure(
            f"the profile {request.profile.parent.name} needs an allocation of SLURM; run the"
            " command with sbatch or salloc, as in docs/cluster.md"
        )
    if INSIDE_STEP.fullmatch(os.environ.get("SLURM_STEP_ID", "")):
        raise Failure(
            "inside a step of a job (srun), further steps would wait for its cores for ever;"
            " use the default profile here, or salloc or sbatch."
        )
    cores = count_cores(os.environ["SLURM_JOB_CPUS_PER_NODE"])
    name = f"in job {os.environ['SLURM_JOB_ID']} of SLURM, with {plural(cores, 'core')}"
    memory = memory_of_allocation(os.environ, cores)
    return Place(name, cores, memory, step=request.profile)


# --- figures and sweeps ------------------------------------------------------------------


def prepare(request, processes):
    """Prepares what the commands need, and returns where they run."""
    refuse_links(RESULTS / name for name in (LIST, "jobs.jsonl", "runs.jsonl"))
    refuse_links(Path(at, folder) for at, folders, _ in os.walk(RESULTS) for folder in folders)
    of_chains = [RESULTS / "data" / name for name in ("plan", "points", "digests", "spare")]
    of_chains += RESULTS.glob("sweeps/*/plan")
    refuse_links(path for folder in of_chains if folder.exists() for path in os.scandir(folder))
    if processes.has_turn:
        put_back()  # of a run that was killed
    page = ("index.html", "numbers.csv", "claims.png", "claims.pdf")
    ours = ("ro-crate-metadata.json", *(page if request.command == "all" else ()))
    refuse_others(RESULTS, *(RESULTS / name for name in ours))  # before hours of computing
    if request.programs:
        ensure_packages(processes, "run")
    elif processes.has_turn:  # else another run builds the same
        set_up(processes, "build", request.cores, "tools", "run")
    use_own_environment()
    return place_of(request)


def note_run(recipes, place, started):
    """Notes for the report which recipes ran, with how many cores, when, and for how long."""
    run = {"recipes": " ".join(recipes), "where": place.name, "started": int(started)}
    run["seconds"] = int(time.time() - started)
    with append_to(RESULTS / "runs.jsonl") as file:
        print(json.dumps(run), file=file)


def run_recipes(request, processes, recipes, place):
    """Returns whether there was anything to do, and whether that failed. With --from-scratch,
    checkpoints that are shipped must first come out as they are."""
    if not request.from_scratch:
        return run_ninja(processes, place, recipes=recipes)
    from chains.selection import Chains
    from chains.store import result_of

    did, has_failed = run_ninja(processes, place, files=[str(FROM_SCRATCH)])
    if has_failed:
        return did, has_failed
    chains = Chains()
    made = chains.points(chains.load(FROM_SCRATCH))
    for point in (*chains.deciding, *made):  # those that choose the events may have failed, too
        if sentence := result_of(point.path)["sentence"]:
            raise Failure(f"{sentence} (see checkpoints/README.md)")
    did_more, has_failed = run_ninja(processes, place, recipes=recipes)
    return did or did_more, has_failed


def state_of(wanted):
    """A digest of what is wanted, and of names, dates and sizes of all files from which it comes or
    in which it is: as long as it stays the same, there is nothing to do."""
    folders = [RESULTS / name for name in ("data", *wanted.get("recipes", ()))]
    folders += [os.environ["RUPTURE_BIN"], *(SHARE / name for name in READ)]
    seen = []
    for at, _, names in (each for folder in folders for each in sorted(os.walk(folder))):
        for file in (os.path.join(at, name) for name in sorted(names)):
            with suppress(OSError):  # of a link that leads nowhere
                stat = os.stat(file)
                seen.append((file, stat.st_mtime_ns, stat.st_size))
    return digest(json.dumps([wanted, seen]))


def run_ninja(processes, place, own=None, **wanted):
    """Makes what is `wanted` by a plan, which Ninja may write again. Returns whether there was
    anything to do, and whether that failed."""
    from chains.plan import write_plan
    from chains.progress import PART, STATUS, follow

    wanted |= {"cores": place.cores, "megabytes": place.megabytes}
    state = "" if own else state_of(wanted)  # before it is looked at: it may change meanwhile
    if state and read(STATE) == state:
        return False, False
    try:
        plan = write_plan(**wanted, own=own)
    except OSError as error:
        raise Failure(f"{ROOT / RESULTS} cannot be written ({error.strerror})") from None
    if not shutil.which("ninja"):
        raise Failure("there is no program ninja on the PATH; packages.txt names its package")
    os.environ |= {"RUPTURE_PLAN": json.dumps(wanted), "RUPTURE_PYTHON": sys.executable}
    os.environ |= {"RUPTURE_STEP": str(place.step or "sh"), "MPLBACKEND": "Agg"}
    os.environ["NINJA_STATUS"] = STATUS
    ninja, did = ["ninja", "-f", plan, "-j", place.cores, "-k", 0], []
    for _ in range(TRIES if place.step else 1):
        try:
            code = processes.run(ninja, lambda lines: did.append(follow(lines, 0 if own else PART)))
        finally:
            put_back()
        if not code:
            break
    if state and not code and not any(did):
        write_if_changed(STATE, state)
    return any(did), bool(code)


def reproduce(request, recipes, processes):
    place = prepare(request, processes)
    names = " ".join(recipes)
    say(f"Computing {names} {place.name} ...")
    note(RESULTS, RESULTS / "runs.jsonl")
    started = time.time()
    has_computed, has_failed = run_recipes(request, processes, recipes, place)
    if not has_computed:
        say("Nothing to compute: all results are up to date.")
    if has_failed:
        what = "not all figures could be" if request.command == "all" else f"{names} could not be"
        raise Failure(f"{what} computed; the messages above say why (log: {LOGS}/recipes.log)")
    note_run(recipes, place, started)
    for name in recipes:
        print_claims(name, RESULTS.resolve(), ROOT)


def is_current(path):
    """Whether a description of the results is newer than all jobs, texts and scripts behind it."""
    scripts = (one for one in (ROOT / "recipes").rglob("*") if one.suffix != ".pyc")
    texts = [ROOT / "CITATION.cff", *(ROOT / "docs").glob("*.md")]
    texts.append(Path(os.environ["RUPTURE_BIN"], "load"))
    shown = [RESULTS / "jobs.jsonl", *RESULTS.glob("*/*.json")]
    sources = [one for one in (*scripts, *texts, *shown) if one.is_file()]
    return path.exists() and path.stat().st_mtime > max(one.stat().st_mtime for one in sources)


def write_crate(processes):
    """Writes what is in results/ and how it was made, for programs; takes about a second."""
    if is_current(RESULTS / "ro-crate-metadata.json"):
        return
    if processes.run([sys.executable, "-P", "-m", "report.crate"]):
        raise Failure(f"{RESULTS}/ro-crate-metadata.json could not be written.")


def run_sweep(request, processes):
    """Writes the table even if points could not be computed; it states which, and why."""
    from chains.store import STORE
    from chains.sweeps import OwnSweep
    from chains import table as report

    place = prepare(request, processes)
    own = OwnSweep(request.file)
    if request.dry_run:
        report.preview(own, request.programs or PROGRAMS)
        return 0
    own.write()
    there, count = {*STORE.glob("*.json")}, len(own.missing())
    run_ninja(processes, place, own=own, files=[str(request.file)])
    if own.points is None:
        own = OwnSweep(request.file)
        if own.points is None:
            raise Failure(f"{request.file}: its points follow from others, which were not computed")
        own.write()
        count = len([point for point in own.points if point.path not in there])
    code = report.report_sweep(own.sweep, count)
    write_crate(processes)
    return code


def write_report_if_needed(processes):
    say()
    page = RESULTS / "index.html"
    if not is_current(page) or not is_current(RESULTS / "ro-crate-metadata.json"):
        return write_report(processes)
    say(f"Report: {page.resolve()}")
    return 0


def write_report(processes):
    use_own_environment()
    return processes.run([sys.executable, "-P", "-m", "report.page"])
