"""Figure 5: the driving stops during event I; quasi-static fronts of a slider driven at h = 0."""

from functools import cache
from types import SimpleNamespace

import numpy as np
from rupture.once import keep, measured, run
from rupture.reports import value, values

import frozen
from claims.samples import Samples, Sample, every, sampled
from events import CROSSINGS, FINE, checkpoint_at, samples_of_events, shown_event
from fig5.quasistatic_stretch import advances_of, stretch_of
from maps import spaced
from measure.ways import PRIMARY, by_way
from measure.drawn import nothing_drawn
from measure.fronts import is_cut, middle_of

EVERY = 0.01  # [s], checkpoints of runs at h = 0
RECORDED = "--record record.h5 --record-every 1e-3"
CROSSED = f"{RECORDED} {CROSSINGS}"
BRANCHED = 0.03  # [s]; here runs get seeds of their own: the first junction breaks at 0.0378 s
SEEDS, SEEDS_WITHOUT_FORCE = frozen.SEEDS, frozen.SEEDS[:5]
MOVES = 2  # blocks; what moves less with the drive has nothing to compare


# --- A: event I --------------------------------------------------------------------------------


@cache
def event():
    """Event I, also with the driving stopped in the middle of its slow stretch."""
    of = shown_event("fast-slow-fast")
    until = round(middle_of(of.front.slow), 7)
    stopped = run(f"restart {of.start} -o amid-slow.h5 --until {until}")["amid-slow.h5"]
    line = f"restart {stopped} -o undriven.h5 --set driving.V=0 --for 0.01 {FINE}"
    record = run(line)["record.h5"]
    keep(record)
    return SimpleNamespace(
        **vars(of),
        undriven_record=record,
        undriven={PRIMARY: run(f"analyze front {record} --event 0")},
        stop=middle_of(of.front.slow),
    )


# --- B: driven at h = 0 ------------------------------------------------------------------------


def shown_load():
    """The load in the picture, until the second dynamic event is over."""
    times = [checkpoint_at(time) for time in spaced(BRANCHED, 0.65, EVERY)]
    return run(
        f"load -o load.h5 --set driving.h=0 --until 0.65 --checkpoint-every {EVERY} {RECORDED}",
        keep=["record.h5", *times],
    )


def load(seed):
    """Checkpoints are kept where the middle may be."""
    start = shown_load()[checkpoint_at(BRANCHED)]
    measured(nothing_drawn, start)
    times = [checkpoint_at(time) for time in spaced(0.45, 0.7, EVERY)]
    return run(
        f"restart {start} --seed {seed} -o load.h5 --until 0.75 --checkpoint-every {EVERY}"
        f" {RECORDED}",
        keep=["record.h5", *times],
    )


def stopped_at(load, stretch, branch, lasting):
    """The driving stops at a branch."""
    start = load[f"load-t{branch.t}.h5"]
    line = f"restart {start} -o stopped.h5 --set driving.V=0 --for {lasting} {RECORDED}"
    record, t = run(line)["record.h5"], float(branch.t)
    advance = measured(advances_of, load["record.h5"], record, stretch.interval_from, t)
    return SimpleNamespace(record=record, t=t, stretch=stretch, advance=advance)


def shown_branch(number):
    """A branch of the load in the picture. That in the middle goes on until the next dynamic
    event."""
    stretch = measured(stretch_of, shown_load()["record.h5"], EVERY)
    branch = stretch.branches[number]
    of = stopped_at(shown_load(), stretch, branch, 0.08 if branch.middle else 0.02)
    of.is_middle = branch.middle
    keep(of.record)
    return of


@cache
def branches():
    """The branches at each tenth of the stretch between the first two dynamic events."""
    stretch = measured(stretch_of, shown_load()["record.h5"], EVERY)
    points = [(number,) for number in range(len(stretch.branches))]
    return [*every(shown_branch, points, "driving stopped").values()]


def middle_branch():
    return next(of for of in branches() if of.is_middle)


def middle_of_seed(seed):
    stretch = measured(stretch_of, load(seed)["record.h5"], EVERY)
    middle = next(branch for branch in stretch.branches if branch.middle)
    return stopped_at(load(seed), stretch, middle, 0.02)


@cache
def seeds():
    """[(seed, its middle branch or a Failure)]"""
    found = sampled(middle_of_seed, [(seed,) for seed in SEEDS], "runs at h = 0")
    return [(seed, of) for (seed,), of in found]


@cache
def without_force(seed):
    """Slipping junctions carry no force (f_slip = 0), so that nothing can slip slowly."""
    changed = f"--set driving.h=0 --set junctions.mu_d=0 --set numerics.seed={seed}"
    record = run(f"load {changed} -o load.h5 --until 0.75 {CROSSED}")["record.h5"]
    events = by_way(f"analyze events {record}")
    return SimpleNamespace(
        events={way: report.events for way, report in events.items()},
        stretch=measured(stretch_of, record, EVERY),
    )


# --- what claims measure -----------------------------------------------------------------------


def each_event():
    return Samples({"": event()}, samples_of_events())


def difference(of, way):
    """5A: the largest of all blocks that rupture after the driving has stopped."""
    front, later = of.fronts[way], of.undriven[way]
    if is_cut(later):
        return None
    ruptured, undriven = values(front.t_rupture), values(later.t_rupture)
    apart = np.abs(undriven - ruptured)[ruptured > of.stop]
    reached = np.array(front.x)[ruptured <= of.stop]
    return {
        "driving stopped at [L]": reached.max() / front.L if len(reached) else np.nan,
        "difference/time below c_s/10": (apart.max() if len(apart) else np.nan)
        / value(front, "in_words.duration"),
    }


def each_branch():
    return Samples({"": middle_branch()}, {PRIMARY: [Sample(seed, of) for seed, of in seeds()]})


def speed(of, way):
    """5B"""
    if of.advance.driven <= MOVES:
        return None
    return {
        "mean speed [m/s]": of.stretch.speed,
        "c_s/speed": of.advance.c_s / of.stretch.speed,
        "blocks in 20 ms, V = 0": of.advance.stopped,
        "blocks in 20 ms, driven": of.advance.driven,
    }


def each_without_force():
    shown, *_ = SEEDS_WITHOUT_FORCE
    found = sampled(without_force, [(seed,) for seed in SEEDS_WITHOUT_FORCE], "runs at h = 0")
    taken = [Sample(seed, of) for (seed,), of in found]
    return Samples({"": without_force(shown)}, {PRIMARY: taken})


def slowed(of, way):
    """no-slip-force-driven"""
    spanning = [event for event in of.events[way] if event.spanning]
    slowed = [e for e in spanning if value(e, "in_words.fast_before") >= e.c_s / 10]
    return {
        "events that span": len(spanning),
        "of them fast, then slow": len(slowed),
        "c_s/speed of the quasi-static front": of.events[way][0].c_s / value(of.stretch, "speed"),
    }
