"""The strength of blocks, and whether those that a slow front passes have a low sigma_bar, as the
script of two chains:

    deviation   = script strength.py deviation {all strength} {all strength_curves}
    on_map      = script strength.py on_map {seed} {all map} {all map_between} {all map_boundary}
    over_events = script strength.py over_events {all ../ensemble/continued}

`deviation`: the largest one of prepared points from the curves. `on_map`: p of a rank test over the
grid points of Figure 4 D with the fronts of a seed. `over_events`: p over the events, each of which
gives one share. Either p in each way ("under").
"""

from collections import namedtuple

import numpy as np

from chains.results import read_points
from measure.rank_test import permutation, share_of_lower, signed_rank, van_elteren
from measure.records import values
from measure.fronts import LOADING_ZONE, SLOW_BELOW
from measure.front_map import load_map, map_of_seed, type_on_map, types_of

BINS = (0.1, 0.05, 0.2)  # of tau_bar_0: blocks in one bin count as equally loaded; primary first
OTHER_BINS = {f"bins of {width:g}": width for width in BINS[1:]}
PERMUTATION = "permutation test"
CURVES = ("uniform", "bell")
MIDDLE = 40  # a block between the trigger region and the leading edge
FEWEST_EVENTS = 5  # for a test over events
KINDS = ("slow", "fast")
# Of an event, or of a prepared interface, where all beyond the trigger region are alike; `shape` is
# that of a prepared phi.
Block = namedtuple("Block", "kind sigma_bar tau_bar_0 mu_bar_eff shape", defaults=[""])


# --- data ----------------------------------------------------------------------------------


def kind_of(x, v_c, c_s):
    """None where no speed is known, or where the front ran backwards."""
    if x < LOADING_ZONE:
        return "loading zone"
    if not v_c > 0:
        return None
    return "slow" if v_c < SLOW_BELOW * c_s else "fast"


def blocks_of(front, strength):
    """The blocks of one event: what they could bear before it, how fast the front passed them."""
    kinds = [kind_of(x, v, front["c_s"]) for x, v in zip(front["x"], values(front["v_c"]))]
    quantities = zip(*(values(strength[q]) for q in ("sigma_bar", "tau_bar_0", "mu_bar_eff")))
    return [Block(kind, *of_block) for kind, of_block in zip(kinds, quantities) if kind]


def prepared_points(points):
    """The block in the middle of prepared interfaces, without those that cannot be prepared."""
    return [
        Block(
            type_on_map(point["front"]["type"]),
            point["strength"]["sigma_bar"][MIDDLE],
            point["tau-bar"],
            point["strength"]["mu_bar_eff"][MIDDLE],
            point["shape"],
        )
        for point in points
        if point.status == "done"
    ]


def lines_of(points):
    """{shape: (sigma_bar, mu_bar_eff)}"""
    pairs = [(p["shape"], p["sigma-bar"], p["strength"]["mu_bar_eff"]) for p in points]
    return {shape: [*zip(*(xy for of, *xy in pairs if of == shape))] for shape in CURVES}


# --- tests ---------------------------------------------------------------------------------


def deviation(block, line):
    """Relative, from the curve at the sigma_bar that the finite number of junctions has."""
    return block.mu_bar_eff / np.interp(block.sigma_bar, *line) - 1


def strata_of(points):
    """sigma_bar of slow and of fast points by stratum. `points`: (stratum, sigma_bar, kind)."""
    return [
        tuple([s for of, s, k in points if (of, k) == (stratum, kind)] for kind in KINDS)
        for stratum in sorted({of for of, *_ in points})
    ]


def map_strata(types):
    """Of grid points, by tau_bar_0."""
    return strata_of([(*place, kind) for place, kind in sorted(types.items())])


def block_strata(blocks, width):
    """Of blocks beyond the loading zone, by bins of tau_bar_0."""
    return strata_of([(np.floor(b.tau_bar_0 / width), b.sigma_bar, b.kind) for b in blocks])


def shares_of(events, width=BINS[0]):
    """{event: share of its pairs of a slow and a fast block in which the slow one has the lower
    sigma_bar}"""
    shares = {name: share_of_lower(block_strata(of, width)) for name, of in events.items()}
    return {event: share for event, share in shares.items() if share is not None}


# --- reports -------------------------------------------------------------------------------


def on_map(types):
    """Of {grid point: type}. Bins do not act on a map: its tau_bar_0 are few."""
    strata = map_strata(types)
    p = van_elteren(strata)
    others = dict.fromkeys(OTHER_BINS, p) | {PERMUTATION: permutation(strata)}
    return {"p": p, "under": {way: {"p": other} for way, other in others.items()}}


def over_events(events):
    """Of {event: blocks}; p is None with too few events."""

    def found(width):
        shares = list(shares_of(events, width).values())
        return {
            "p": signed_rank(shares) if len(shares) >= FEWEST_EVENTS else None,
            "events": len(shares),
            "median_share": float(np.median(shares)) if shares else None,
        }

    primary = found(BINS[0])
    others = {name: found(width) for name, width in OTHER_BINS.items()}
    return primary | {"under": others | {PERMUTATION: primary}}


def largest_deviation(points, lines):
    return max(abs(deviation(point, lines[point.shape])) for point in points)


def main(which, *words):
    if which == "on_map":
        seed, *files = words
        fronts, grid = load_map(*map(read_points, files))
        of_seed = map_of_seed({place: fronts[place] for place in grid}, int(seed))
        return on_map(types_of(of_seed))
    if which == "over_events":
        points = enumerate(read_points(words[0]))
        return over_events({n: blocks_of(p["front"], p["strength"]) for n, p in points})
    points, curves = map(read_points, words)
    return {"largest": largest_deviation(prepared_points(points), lines_of(curves))}
