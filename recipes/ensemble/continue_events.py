"""Continues every fast-slow-fast event of a load with changes, and measures what becomes of it:

    continue_events.py RUN CHECKPOINT_EVERY OPTIONS_OF_RECORDS

RUN is results/data/ensemble/load-203, say: names of the load's checkpoints and events begin so. The
commands run in the folder RUN-scratch, which is deleted at the end. Prints, by the events' numbers:

    "event"         as it was in the load; "unmodified": its front, continued alone
    "strength"      of each block before the event
    "peaks"         of tau/p of each block
    "branches"      {branch: {run: front, "slip": {x: {run: slip}}, "phi": {"before", "after"}}}
    "undriven"      front if the driving stops in the middle of the slow stretch, "undriven_from"
    "conventions"   {convention: {run: front}} of the unmodified event and of "wider"

A branch is null where the front does not rupture its block; a front where nothing ruptures.
"""

import shutil
from pathlib import Path

import rupture
from workshop import Workshop, short, without_lines

from data.scratch import scratch
from events.choose_events import read_events
from events.continuations import BEFORE_TRANSITION, BRANCHES, CONTINUATIONS, DURATION
from events.continuations import OWN_BLOCK, SLIPS, WIDER
from events.conventions import CONVENTIONS
from events.fronts import middle_of
from events.slip import peaks_of

RUNS = ["stopped", "no-slow-slip", "t_R-half", "t_R-double"]
FRONTS = ["stopped", "no-slow-slip", "wider"]  # of which the front is measured


def continued(workshop, branch, duration, slip_at):
    """What becomes of the event from a branch on; leaves the records there."""
    source = workshop.path(branch)
    for run in RUNS:
        options = CONTINUATIONS[run].split()
        workshop.recorded(source, f"{branch}-{run}", *options, "--for", duration)
    workshop.run("modify-phi", source, f"{branch}-wider-start", *WIDER.split())
    workshop.recorded(workshop.path(f"{branch}-wider-start"), f"{branch}-wider", "--for", duration)
    phi = {"before": source, "after": workshop.path(f"{branch}-wider-start")}
    slips = {run: workshop.slips(f"{branch}-{run}", slip_at) for run in SLIPS}
    return {
        **{run: short(workshop.front(f"{branch}-{run}")) for run in FRONTS},
        "slip": {place: {run: of_run[place] for run, of_run in slips.items()} for place in slip_at},
        "phi": {when: short(rupture.analyze("phi", path)) for when, path in phi.items()},
    }


def under_conventions(workshop, branch):
    """The unmodified front and the one with a wider phi, without their lines."""
    runs = {"unmodified": "event", "wider": f"{branch}-wider"}
    found = {name: workshop.fronts(run, CONVENTIONS) for name, run in runs.items()}
    return {
        convention: {name: without_lines(fronts[convention]) for name, fronts in found.items()}
        for convention in CONVENTIONS
    }


def run_event(workshop, event, times, duration):
    """The unchanged event, and its states at the times of the branches."""
    workshop.start(event)
    at = ["--checkpoint-at", *sorted(times.values())]
    workshop.recorded(workshop.path("start"), "event", "--for", duration, *at)
    for name, t in times.items():
        shutil.copy(workshop.folder / f"event-t{t:.9f}.h5", workshop.path(name))


def measure(workshop, event):
    ruptured = {branch: event["t_rupture"][block] for branch, (block, _) in BRANCHES.items()}
    times = {branch: t for branch, t in ruptured.items() if t is not None}
    crossing = max(t for t in event["t_rupture"] if t is not None) - event["t_start"]
    amid_slow, duration = middle_of(event["in_words"]), max(DURATION, 2 * crossing)
    slip_at = {OWN_BLOCK: event["in_words"]["x_from"] - BEFORE_TRANSITION * event["L"]}
    run_event(workshop, event, times, duration)
    workshop.run("restart", workshop.path("start"), "amid-slow", "--until", amid_slow)
    stop = ["--set", "driving.V=0", "--for", duration]
    workshop.recorded(workshop.path("amid-slow"), "undriven", *stop)
    branches = {
        branch: continued(workshop, branch, duration, slip_at) if branch in times else None
        for branch in BRANCHES
    }
    first = next(iter(BRANCHES))
    return {
        "t_start": event["t_start"],
        "unmodified": workshop.front("event"),
        "event": without_lines(event),
        "strength": rupture.analyze("strength", workshop.path("start")),
        "peaks": peaks_of(rupture.open(workshop.path("event-record"))),
        "branches": branches,
        "undriven": short(workshop.front("undriven")),
        "undriven_from": amid_slow,
        "conventions": branches[first] and under_conventions(workshop, first),
    }


def main(run, *options):
    found = {}
    for event in read_events(f"{run}-events.json"):
        if event["fast_slow_fast"]:
            with scratch(Path(f"{run}-scratch")) as folder:
                workshop = Workshop(run, *options, folder)
                found[event["number"]] = measure(workshop, event)
    return found
