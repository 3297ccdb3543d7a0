"""Details that the paper leaves open, one changed at a time, and two together: fronts on prepared
interfaces, and eight loads, compared with those with our choices and the same seeds.
"""

from functools import cache

from rupture.once import each, run

import events
import maps
from claims.samples import Sample, every, outcomes
from events import LAWS, duration, loads_from, slow_events
from measure.ways import PRIMARY

HALF_EDGES = "--set slider.edge_springs=half"
ALONG_SPRING = "--set slider.damping_along=spring"
CHOICES = {
    "reference": "",
    # eta, which is the square root of the damping, half and twice as large
    "damping-half": "--set slider.damping=0.025",
    "damping-twice": "--set slider.damping=0.4",
    "stiffness-initial": "--set junctions.k_ij_from=initial",
    "springs-linear": "--set slider.springs=linearised",
    "foundation-damped": "--set slider.foundation_damping=0.1",  # as strongly as the bulk
    "contact-lost": "--set junctions.without_contact=break",
    "edge-springs-half": HALF_EDGES,
    "damping-along-spring": ALONG_SPRING,
    "both": f"{HALF_EDGES} {ALONG_SPRING}",
    # the height at which the slider is driven, half and one and a half times the paper's
    "drive-lower": "--set driving.h=2.5e-3",
    "drive-higher": "--set driving.h=7.5e-3",
    "K-tenth": "--set driving.K=4e5",  # matters to prepared interfaces only
    "decaying": LAWS["decaying"],
    "decaying-exact": f"{LAWS['decaying']} --set junctions.repin=exact",
    "decaying-both": f"{LAWS['decaying']} {HALF_EDGES} {ALONG_SPRING}",
}
DECAYING = ("decaying", "decaying-exact", "decaying-both")  # without edges, and without branches
SETTLED = ("reference", "decaying")  # our choices
SIGMA_BARS = (0, 0.285)  # of prepared interfaces
SEEDS = range(401, 409)
BLOCK = 8  # of branches


# --- prepared interfaces -----------------------------------------------------------------------


@cache
def edges():
    """{(choice, sigma_bar): edges}"""
    choices = [choice for choice in CHOICES if choice not in DECAYING]
    points = {(choice, s): (s, CHOICES[choice]) for choice in choices for s in SIGMA_BARS}
    found = every(maps.edges, [*points.values()], "edges")
    return {place: found[point] for place, point in points.items()}


# --- loads -------------------------------------------------------------------------------------


def load(choice, seed):
    """The load of a choice. With half edge springs, the decaying law breaks junctions before 0.18
    s; driven lower, the slider breaks the first ones before 0.12 s."""
    if choice in SETTLED:
        return events.load(seed, choice)
    until = 0.1 if choice == "drive-lower" else 0.17
    start = run(f"load {CHOICES[choice]} -o start.h5 --until {until}", keep=["start.h5"])
    return loads_from(start["start.h5"], seed)


@cache
def events_of(choice, seed):
    return events.events_in(load(choice, seed))


@cache
def runs():
    """{choice: [(seed, {way: events})]}; nothing of what matters to prepared interfaces only."""
    points = [(choice, seed) for choice in CHOICES if choice != "K-tenth" for seed in SEEDS]
    found: dict[str, list] = {choice: [] for choice in CHOICES}
    for (choice, seed), events_of_run in every(events_of, points, "loads").items():
        found[choice].append((seed, events_of_run))
    return found


def branch(choice, seed, number):
    """What becomes of an event when something changes as block 8 ruptures."""
    if choice == "reference":
        return events.branch(seed, number, BLOCK)
    event = events_of(choice, seed)[PRIMARY][number]
    of = events.continued_from(load(choice, seed), event)
    return events.branch_of(of, BLOCK, duration(event))


def samples_of_runs(choice):
    return {PRIMARY: [Sample(seed, events.spanning(found)) for seed, found in runs()[choice]]}


@cache
def branches():
    """{choice: samples}"""
    points = [
        (choice, *event)
        for choice, of in runs().items()
        for event in slow_events(of)
        if choice not in DECAYING
    ]
    found: dict[str, list] = {choice: [] for choice in CHOICES}
    for (choice, seed, _), of_event in outcomes(points, each(branch, points, "branches")):
        found[choice].append(Sample(seed, of_event))
    return found


def samples_of_branches(choice):
    return {PRIMARY: branches()[choice]}
