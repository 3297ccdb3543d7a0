"""Independent runs of the slider, their events, and what becomes of an event when something changes
in it. Figures show one run, with seed 1, and events I, II and III of it from checkpoints/."""

import re
import shlex
from functools import cache
from pathlib import PosixPath
from types import SimpleNamespace

from rupture.errors import Failure
from rupture.once import measured, run
from rupture.programs import output_of

import frozen
from claims.recipes import RECIPES
from claims.samples import Sample, every, sampled
from measure.ways import PRIMARY, by_way
from measure.drawn import nothing_drawn
from measure.fronts import middle_of
from measure.slip import peaks_of_record

CHECKPOINTS = RECIPES.parent / "checkpoints"
EVENTS = {"event I": "fast-slow-fast", "event II": "second-slow", "event III": "fast-only"}
LAWS = {
    "reference": "",
    "simplified": "--set junctions.law=simplified --set junctions.v_slow=1.5e-3",
    "decaying": "--set junctions.law=decaying --set junctions.kappa=54.1e9"
    " --set junctions.mu_d=0.28 --set junctions.mu_new=0.196",
    "exponential": "--set junctions.slipping_times=exponential",
}
SEEDS = {  # of independent runs; the simplified law draws nothing
    "reference": frozen.SEEDS,
    "decaying": frozen.SEEDS[:10],
    "exponential": frozen.SEEDS[:10],
}
UNTIL = 1.2  # [s]
BRANCHED = 0.18  # [s]; here runs of a law get seeds of their own
TIMES = [n / 20 for n in range(4, 25)]  # of checkpoints that are kept [s]
CHECKPOINTED = "--checkpoint-every 0.05"
CROSSINGS = "--crossings 0.2,0.5"
COARSE = f"--record record.h5 --record-every 1e-3 {CROSSINGS}"
FINE = "--record record.h5 --record-every 1e-5"
FINEST = f"{FINE} {CROSSINGS}"  # of events and branches, for all ways to measure
BLOCKS = {8: PRIMARY, 11: "branch at 0.2 L", 14: "branch at 0.25 L"}  # of branches
WIDTH = 0.0025  # of a block [m]


# --- events I, II and III ----------------------------------------------------------------------


class Shipped(PosixPath):
    """A checkpoint of ours. In the text of a command it is one word, whatever its folder's name."""

    def __format__(self, _):
        return shlex.quote(str(self))


def checked(checkpoint, manifest):
    """Raises Failure if it is not the one in the manifest."""
    sums = dict(re.findall(r"(\S+)  (\S+)\n", manifest.read_text(encoding="utf-8")))
    if sums.get(output_of("analyze", "checksum", checkpoint).strip()) != checkpoint.name:
        raise Failure(f"checkpoints/{checkpoint.name} is not in its manifest (see README.md there)")
    return {}


@cache
def shipped(name):
    """The path of a checkpoint from which figures start, 0.5 ms before an event."""
    path = Shipped(CHECKPOINTS / f"{name}.h5")
    measured(checked, path, CHECKPOINTS / "manifest")
    return path


@cache
def shown_event(name):
    """An event as it is, from its checkpoint on."""
    start = shipped(name)
    record = run(f"restart {start} -o event.h5 --for 0.01 {FINE}", keep=["record.h5"])["record.h5"]
    front = run(f"analyze front {record} --event 0")
    return SimpleNamespace(
        start=start,
        record=record,
        front=front,
        fronts={PRIMARY: front},
        phi=run(f"analyze phi {start}"),
        strength=run(f"analyze strength {start}"),
    )


# --- runs and their events ---------------------------------------------------------------------


def checkpoint_at(time):
    """The name of a checkpoint of load.h5."""
    return f"load-t{time:.9f}.h5"


def shown_load(law):
    """The slider from t = 0 with seed 1. A seed draws slipping times and nothing else, so all runs
    of a law are one state until the first junction breaks, at 0.1845 s or later."""
    return run(
        f"load {LAWS[law]} -o load.h5 --until {UNTIL} {CHECKPOINTED} --checkpoint-at {BRANCHED}"
        f" {COARSE}",
        keep=["record.h5", *map(checkpoint_at, [BRANCHED, *TIMES])],
    )


def loads_from(start, seed):
    """The slider from a state in which nothing has been drawn, with slipping times of its own."""
    measured(nothing_drawn, start)
    return run(
        f"restart {start} --seed {seed} -o load.h5 --until {UNTIL} {CHECKPOINTED} {COARSE}",
        keep=["record.h5", *map(checkpoint_at, TIMES)],
    )


def load(seed, law="reference"):
    return loads_from(shown_load(law)[checkpoint_at(BRANCHED)], seed)


def events_in(load):
    """{way to measure: events}"""
    found = by_way(f"analyze events {load['record.h5']}")
    return {way: report.events for way, report in found.items()}


@cache
def shown_events(law):
    return events_in(shown_load(law))


@cache
def events_of(seed, law="reference"):
    return events_in(load(seed, law))


def all_runs():
    """{seed: events} of the reference, all of them."""
    found = every(events_of, [(seed,) for seed in SEEDS["reference"]], "runs")
    return {seed: events for (seed,), events in found.items()}


@cache
def runs(law="reference"):
    """[(seed, {way: events} or a Failure)]"""
    return [
        (seed, found)
        for (seed, _), found in sampled(events_of, [(seed, law) for seed in SEEDS[law]], "runs")
    ]


def spanning(events):
    """{way: those that span}"""
    return {way: [one for one in of if one.spanning] for way, of in events.items()}


def samples_of_runs(law="reference"):
    """A sample is the spanning events of a run."""
    return {
        PRIMARY: [
            Sample(seed, found if isinstance(found, Failure) else spanning(found))
            for seed, found in runs(law)
        ]
    }


def before(load, event, times=TIMES, early=0.5e-3):
    """The state of a run so long before an event [s]."""
    until = round(event.t_start - early, 7)
    last = max(time for time in times if time < until)
    start = run(f"restart {load[checkpoint_at(last)]} -o start.h5 --until {until}", ["start.h5"])
    return start["start.h5"]


# --- what becomes of an event ------------------------------------------------------------------


def duration(event):
    """The time for which an event is continued [s]."""
    ruptures = [time for time in event.t_rupture if time is not None]
    return max(0.01, 2 * (max(ruptures) - event.t_start))


def continued_from(load, event):
    """An event as it is, and with the driving stopped amid its slow stretch."""
    start, lasting, amid = before(load, event), duration(event), middle_of(event.in_words)
    record = run(f"restart {start} -o event.h5 --for {lasting} {FINEST}")["record.h5"]
    stopped = run(f"restart {start} -o amid-slow.h5 --until {amid}")["amid-slow.h5"]
    line = f"restart {stopped} -o undriven.h5 --set driving.V=0 --for {lasting} {FINEST}"
    undriven = run(line)["record.h5"]
    return SimpleNamespace(
        start=start,
        strength=run(f"analyze strength {start}"),
        fronts=by_way(f"analyze front {record} --event 0"),
        peaks=measured(peaks_of_record, record),
        stop=amid,
        undriven=by_way(f"analyze front {undriven} --event 0"),
    )


def widened(start, lasting):
    """The event with phi uniform and as wide as each block allows for x >= 0.25 L."""
    wider = run(f"modify-phi {start} -o wider.h5 --shape uniform --x-from 0.035")["wider.h5"]
    record = run(f"restart {wider} -o end.h5 --for {lasting} {FINEST}")["record.h5"]
    return SimpleNamespace(start=wider, record=record)


def slip_times(t_R):
    return f"--set junctions.t_R={t_R} --set junctions.delta_t_R={0.3 * t_R:g}"


NO_SLOW_SLIP = "--set junctions.f_new=f_slip"
CHANGES = {
    "stopped": "",
    "half": slip_times(1e-3),
    "double": slip_times(4e-3),
}


def branch_of(event, block, lasting):
    """What becomes of an event when something changes just as a block ruptures. Slip is followed at
    the block at 0.34 L, as in the paper, and at those 0.06 L and 0.1 L before the event's own slow
    stretch. `event`: where it starts, and its fronts as it is."""
    x, front = WIDTH * block, event.fronts[PRIMARY]
    branch = run(f"restart {event.start} -o branch.h5 --until-rupture-at {x} --for {lasting}")
    branch = branch["branch.h5"]

    def record_with(change, end=f"--for {lasting}"):
        changed = f"--set driving.V=0 {change} {end}"
        return run(f"restart {branch} -o end.h5 {changed} {FINEST}")["record.h5"]

    records = {name: record_with(change) for name, change in CHANGES.items()}
    until_arrest = f"--for {lasting + 0.03} --until-quiet"  # where it arrests shows when it is over
    records["no_slow_slip"] = record_with(NO_SLOW_SLIP, until_arrest)
    wider = widened(branch, lasting)

    def front_in(record):
        return by_way(f"analyze front {record} --event 0 --skip-below-x {x}")

    def slips_at(place):
        return [
            run(f"analyze slip {records[name]} --x {place}")
            for name in ("stopped", "half", "double")
        ]

    return SimpleNamespace(
        start=branch,
        fronts=event.fronts,
        block=block,
        records=records,
        stopped=front_in(records["stopped"]),
        no_slow_slip=front_in(records["no_slow_slip"]),
        half=front_in(records["half"]),
        double=front_in(records["double"]),
        slips=slips_at(0.0476),
        own_slips=slips_at(front.in_words.x_from - 0.06 * front.L),
        far_slips=slips_at(front.in_words.x_from - 0.1 * front.L),
        phi=run(f"analyze phi {branch}"),
        phi_wider=run(f"analyze phi {wider.start}"),
        wider=front_in(wider.record),
    )


def slow_events(found):
    """[(seed, number)] of the events of runs that are fast-slow-fast in words."""
    return [
        (seed, number)
        for seed, events in found
        if not isinstance(events, Failure)
        for number, event in enumerate(events[PRIMARY])
        if event.fast_slow_fast
    ]


@cache
def continued(seed, number):
    return continued_from(load(seed), events_of(seed)[PRIMARY][number])


def all_continued():
    """The continued events of all runs."""
    return [*every(continued, slow_events(all_runs().items()), "events").values()]


@cache
def branch(seed, number, block):
    lasting = duration(events_of(seed)[PRIMARY][number])
    return branch_of(continued(seed, number), block, lasting)


def samples_without_events():
    """Of the runs that have no such event, which count against what is said about it."""
    having = {seed for seed, _ in slow_events(runs())}
    none = Failure("no event of this run is fast, slow and fast again")
    return [Sample(seed, none) for seed, _ in runs() if seed not in having]


@cache
def samples_of_events():
    """A sample is an event, continued."""
    found = sampled(continued, slow_events(runs()), "events")
    return {PRIMARY: [Sample(seed, of) for (seed, _), of in found] + samples_without_events()}


@cache
def samples_of_branches():
    """A sample is an event that something happens to; elsewhere is another way."""
    points = [(*event, block) for event in slow_events(runs()) for block in BLOCKS]
    found = sampled(branch, points, "branches")
    return {
        name: [Sample(seed, of) for (seed, _, at), of in found if at == block]
        + samples_without_events()
        for block, name in BLOCKS.items()
    }


# --- the simplified law ------------------------------------------------------------------------


@cache
def simplified(number):
    """An event of the run with the simplified law: as it is, and without slow slip. This run ends
    once nothing has broken for 12 ms, so its record holds one event."""
    event = shown_events("simplified")[PRIMARY][number]
    start = before(shown_load("simplified"), event, [BRANCHED, *TIMES])
    record = run(f"restart {start} -o event.h5 --for 0.015 {FINE}")["record.h5"]
    changed = "--until-quiet 0.012 --for 0.05 --set junctions.v_slow=0"
    without = run(f"restart {start} -o without.h5 {changed} {FINEST}")["record.h5"]
    return SimpleNamespace(
        event=event,
        record=record,
        without_record=without,
        front=run(f"analyze front {record} --event 0"),
        without=by_way(f"analyze front {without} --event 0"),
    )


@cache
def all_simplified():
    """Every event of that run."""
    count = len(shown_events("simplified")[PRIMARY])
    return [*every(simplified, [(n,) for n in range(count)], "simplified events").values()]
