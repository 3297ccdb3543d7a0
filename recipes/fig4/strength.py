"""The strength of blocks, and whether those that a slow front passes have a low sigma_bar or a low
prestress, as the script of two chains:

    deviation   = script strength.py deviation {all strength} {all strength_curves}
    shown       = script strength.py shown {all ../fig2/event} {all strength_curves}
    on_map      = script strength.py on_map {seed} {all map} {all map_between} {all map_boundary}
    over_events = script strength.py over_events {all ../ensemble/continued}

`deviation`: the largest one of prepared points from the curves. `shown`: the share of all blocks of
events I and II that lie near a curve. `on_map` and `over_events`: in which share of pairs of a slow
and a fast place the slow one has the lower sigma_bar, over the grid points of Figure 4 D with the
fronts of a seed, and over the blocks of an event (the median event, in each way, "under"; also the
share with the lower tau_0/p).
"""

from collections import namedtuple

import numpy as np

from chains.results import read_points
from measure.pairs import share_of_lower
from measure.tables import values
from measure.fronts import LOADING_ZONE, SLOW_BELOW
from measure.front_map import load_map, map_of_seed, type_on_map, types_of

BINS = (0.1, 0.05, 0.2)  # of tau_bar_0: blocks in one bin count as equally loaded; primary first
OTHER_BINS = {f"bins of {width:g}": width for width in BINS[1:]}
CURVES = ("uniform", "bell")
MIDDLE = 40  # a block between the trigger region and the leading edge
NEAR = 0.1  # a curve, in mu_bar_eff
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


# --- what they say -------------------------------------------------------------------------


def deviation(block, line):
    """Relative, from the curve at the sigma_bar that the finite number of junctions has."""
    return block.mu_bar_eff / np.interp(block.sigma_bar, *line) - 1


def largest_deviation(points, lines):
    return max(abs(deviation(point, lines[point.shape])) for point in points)


def distance(block, lines):
    """In mu_bar_eff, from the nearer of the curves."""
    curves = (np.interp(block.sigma_bar, *lines[shape]) for shape in CURVES)
    return min(abs(block.mu_bar_eff - curve) for curve in curves)


def share_near(blocks, lines):
    """`blocks` without contact have no strength and do not count."""
    near = [distance(block, lines) <= NEAR for block in blocks if np.isfinite(block.mu_bar_eff)]
    return float(np.mean(near))


def strata_of(points):
    """sigma_bar of slow and of fast points by stratum. `points`: (stratum, sigma_bar, kind)."""
    return [
        tuple([s for of, s, k in points if (of, k) == (stratum, kind)] for kind in KINDS)
        for stratum in sorted({of for of, *_ in points})
    ]


def map_strata(types):
    """Groups the grid points of a map by tau_bar_0."""
    return strata_of([(*place, kind) for place, kind in sorted(types.items())])


def share_by_width(blocks, width=BINS[0]):
    """Share of the pairs of a slow and a fast block with tau_bar_0 in the same bin in which the
    slow one has the lower sigma_bar; None without such pairs."""
    return share_of_lower(
        strata_of([(np.floor(b.tau_bar_0 / width), b.sigma_bar, b.kind) for b in blocks])
    )


# --- reports -------------------------------------------------------------------------------


def over_events(events):
    """The share of the blocks of each event, its median over events, also with other bins."""

    def found(width):
        of_width = [share_by_width(blocks, width) for blocks in events]
        shares = [share for share in of_width if share is not None]
        return {"events": len(shares), "share": float(np.median(shares)) if shares else None}

    return found(BINS[0]) | {"under": {way: found(w) for way, w in OTHER_BINS.items()}}


def main(which, *words):
    if which == "on_map":
        seed, *files = words
        fronts, grid = load_map(*map(read_points, files))
        of_seed = map_of_seed({place: fronts[place] for place in grid}, int(seed))
        return {"share": share_of_lower(map_strata(types_of(of_seed)))}
    points, *curves = map(read_points, words)
    if which == "deviation":
        return {"largest": largest_deviation(prepared_points(points), lines_of(*curves))}
    events = [blocks_of(point["front"], point["strength"]) for point in points]
    if which == "shown":
        return {"near": share_near(sum(events, []), lines_of(*curves))}
    return over_events(events)
