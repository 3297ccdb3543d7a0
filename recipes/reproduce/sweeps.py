"""A user's sweep: ./reproduce.sh sweep FILE.ini."""

import os
import shlex
from pathlib import Path

from reproduce import stamps
from reproduce.compute import prepare, write_crate
from reproduce.project import RESULTS, STORE, complain, say
from rupture import once
from rupture.tools.command_line import in_one_line, plural
from sweeps.text import name_of

SAID = "said"
LINES = {"lines": [str], "code": int}


def run_sweep(request, processes):
    """Writes the table even if points could not be computed; it says which, and why."""
    name = f"sweeps/{name_of(request.file)}"
    prepare(request, processes)
    if request.dry_run:
        return preview(request)
    try:
        said = said_of(name, request.file) or make(name, request)
    finally:
        once.finish()
    say("\n".join(map(in_one_line, said["lines"])))
    if said["code"]:
        complain("to retry the unfinished points, run the same command again")
    write_crate(processes)
    return said["code"]


def said_of(name, file):
    """What was said the last time if nothing has changed since. Another file may have the name."""
    store = once.use(STORE, dry_run=False).store
    stamp = store.result(stamps.record_of(name, "stamp"), stamps.STAMP)
    is_same = stamp and os.path.relpath(file) in stamp["files"]
    if not is_same or not stamps.is_current(name, True, store, f"{file.stem}.csv"):
        return None
    say("Nothing to compute: all results are up to date.")
    return store.result(stamps.record_of(name, SAID), LINES)


def look_up(sweep, making):
    """What computes points, {number: row} of what is known, and the points that are missing."""
    from sweeps.points import Points

    points = Points(sweep, making)
    found = {point.number: row for (point,), row in once.known(points.compute, sweep.points)}
    missing = [point for point in sweep.points if point.number not in found]
    done = f"{len(found)} done, {len(missing)} to compute"
    say(f"{sweep.title}: {plural(len(sweep.points), 'point')}: {done}")
    return points, found, missing


def preview(request):
    from sweeps.estimate import Estimate
    from sweeps.sweep import Sweep

    sweep = Sweep(request.file)
    _, _, missing = look_up(sweep, once.use(STORE, dry_run=True))
    if missing:
        say("Commands of the first point to compute:")
        for command in sweep.commands:
            filled = "" if command.is_later else shlex.join(sweep.words(command, missing[0]))
            say(f"  rupture {filled or command.line}")
        say("Asking the programs about these points, for at most half a minute ...")
        estimate = Estimate(sweep)
        estimate.ask(missing)
        say("\n".join(estimate.lines(len(missing))))
    return 0


def make(name, request):
    """Returns the lines to be said, and the exit code."""
    from report.jobs import jobs_of, write_jobs
    from report.written import refuse_others
    from reproduce.recipes import note_asked, publish
    from rupture import figures
    from rupture.commands.script import with_sources
    from sweeps.sweep import Sweep
    from sweeps.table import UNFINISHED, summary, write_results

    file, folder = request.file, RESULTS / name
    sweep = Sweep(file)
    needs = {"megabytes": sweep.megabytes, "threads": sweep.threads}
    cores = request.given and max(1, request.given // sweep.threads)
    making = once.use(STORE, cores, dry_run=False, **needs)
    store = making.store
    code = stamps.code_behind([Path(__file__)], store)
    refuse_others(RESULTS, folder / f"{sweep.name}.csv")  # before hours of computing
    note_asked(name, [], store, is_finished=False)
    with once.asked() as works:
        points, found, missing = look_up(sweep, making)
        computed = once.each(points.compute, missing, sweep.title)
    found |= {point.number: row for (point,), row in computed}
    rows = [found[point.number] for point in sweep.points]
    figures.made_by = [f"./reproduce.sh sweep {file.name}"]
    drawn = store.now / "drawn" / name
    drawn.mkdir(parents=True)
    written = write_results(drawn, sweep, rows)
    write_jobs(drawn, jobs_of(works))
    publish(drawn, folder)
    behind = with_sources(works)
    note_asked(name, behind, store)
    now = f"Computed now: {len(missing)}; already done: {len(rows) - len(missing)}."
    first, *others = summary(sweep, rows)
    said: dict = {"lines": ["", first, now, *others, f"In {folder.resolve()}:", *written]}
    said["code"] = int(any(row["status"] == UNFINISHED for row in rows))
    if not said["code"]:
        inputs = {path for work in behind for path in work.stamps}
        inputs |= {str(path) for path in (file, sweep.table) if path}
        kept = {RESULTS / row[name] for row in rows for name in sweep.kept if name in row}
        stamps.save(name, code | stamps.described([*inputs, *kept], store), [], store)
        again = {"lines": ["", first, *others, *said["lines"][-1 - len(written) :]], "code": 0}
        store.save(stamps.record_of(name, SAID), again)
    return said
