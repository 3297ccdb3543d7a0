"""Figures and their report: ./reproduce.sh fig3, all, report."""

import sys
import time
import traceback
from contextlib import suppress

from claims.print_claims import print_claims
from claims.recipes import recipe_names
from claims.table import samples_from
from report.written import check, hold, is_intact, refuse_others, written
from reproduce.project import BESIDE_ALL, LOGS, RESULTS, ROOT, SHARE, STORE, complain
from reproduce.project import say, use_own_environment
from reproduce.processes import ensure_packages, set_up
from reproduce.stamps import is_current as is_made
from rupture import once
from rupture.errors import Failure, is_of_machine
from rupture.tools.command_line import plural


def prepare(request, processes):
    """Prepares what the commands need."""
    if not request.dry_run:
        request.turn = hold(RESULTS)
    elif RESULTS.is_dir():
        check(RESULTS)
    page = ("index.html", "numbers.csv", "claims.png", "claims.pdf")
    ours = ("ro-crate-metadata.json", *(page if request.command == "all" else ()))
    refuse_others(RESULTS, *(RESULTS / name for name in ours))  # before hours of computing
    if request.programs:
        ensure_packages(processes, "run")
    elif processes.has_turn:  # else another run builds the same
        set_up(processes, "build", request.cores, "tools", "run")
    use_own_environment()


def named_in(request):
    """The recipes."""
    if request.command != "all":
        return request.words
    return [name for name in recipe_names(SHARE) if name not in BESIDE_ALL and "/" not in name]


def is_whole(recipe, named):
    """Whether samples are computed: by a recipe of its paper that is named, or by itself."""
    source = samples_from(recipe)
    return source is None or source in named


def dry_run(request, processes):
    prepare(request, processes)
    making = once.use(STORE, dry_run=True)
    from reproduce import recipes

    if request.from_scratch:
        with suppress(once.Unknown):
            recipes.check_from_scratch(making)
    for name in request.words:
        say(f"# {name}")
        if not recipes.show(name, is_whole(name, request.words)):
            say("# More commands follow from reports that nobody has made yet.")
    return 0


def mistake(fault):
    """A sentence; the traceback goes to the log."""
    with open(LOGS / "mistakes.log", "a", encoding="utf-8") as log:
        traceback.print_exception(fault, file=log)
    return f"a mistake in its code, {fault!r}: {log.name} has the traceback"


def make_all(stale, named, making):
    """Returns whether one could not be made."""
    from reproduce import recipes  # NumPy and more, which nobody needs if there is nothing to do

    begun, has_failed = time.monotonic(), False
    for number, name in enumerate(stale, 1):
        try:
            recipes.make(name, is_whole(name, named), making)
        except Exception as fault:  # other recipes may do
            if is_of_machine(fault):
                raise
            has_failed = True
            complain(f"{name}: {fault if isinstance(fault, Failure) else mistake(fault)}")
            continue
        say(f"[{time.monotonic() - begun:4.0f} s] {number} of {len(stale)}: {name}")
    return has_failed


def reproduce(request, processes):
    """Computes the named recipes, or all and their report."""
    begun = time.monotonic()
    prepare(request, processes)
    named = named_in(request)
    names = " ".join(named)
    making = once.use(STORE, request.given, dry_run=False)
    cores = plural(making.pool.cores, "core")
    say(f"Computing {names} with {cores}{making.executor.where} ...")
    try:
        if request.from_scratch:
            from reproduce.recipes import check_from_scratch

            check_from_scratch(making)
        store = making.store
        stale = [name for name in named if not is_made(name, is_whole(name, named), store)]
        has_failed = bool(stale) and make_all(stale, named, making)
    finally:
        once.finish()
    if not stale:
        say("Nothing to compute: all results are up to date.")
    if has_failed:
        what = "not all figures could be" if request.command == "all" else f"{names} could not be"
        raise Failure(f"{what} computed; the messages above say why")
    for name in named:
        print_claims(name, RESULTS.resolve(), ROOT)
    is_all = request.command == "all"
    code = (write_report_if_needed if is_all else write_crate)(processes)
    minutes, seconds = divmod(round(time.monotonic() - begun), 60)
    say(f"\nDone in {f'{minutes} min ' if minutes else ''}{seconds} s.")
    return code


def is_current(path):
    """Whether a description of the results is newer than all jobs, texts and scripts behind it."""
    scripts = (one for one in (ROOT / "recipes").rglob("*") if one.suffix != ".pyc")
    texts = [ROOT / "CITATION.cff", *(ROOT / "docs").glob("*.md")]
    of_recipes = (RESULTS / name for name in recipe_names(SHARE))
    shown = [
        *RESULTS.glob("sweeps/*/*"),
        *(one for at in of_recipes for one in at.glob("*.json*")),
    ]
    sources = [one for one in (*scripts, *texts, *shown) if one.is_file()]
    newest = max(one.stat().st_mtime for one in sources)
    sha256 = written(RESULTS).get(str(path.relative_to(RESULTS)))
    return is_intact(path, sha256) and path.stat().st_mtime > newest


def write_crate(processes):
    """Writes what is in results/ and how it was made, for programs; takes about a second."""
    if is_current(RESULTS / "ro-crate-metadata.json"):
        return
    if processes.run([sys.executable, "-P", "-m", "report.crate"]):
        raise Failure(f"{RESULTS}/ro-crate-metadata.json could not be written.")


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
