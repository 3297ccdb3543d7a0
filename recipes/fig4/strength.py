"""The strength of blocks, and whether those that a slow front passes have a low sigma_bar."""

from collections import namedtuple

import numpy as np
from rupture.reports import LOADING_ZONE, values

from measure.ways import PRIMARY
from measure.fronts import SLOW_BELOW, type_on_map
from measure.pairs import share_of_lower

# Of tau_bar_0: blocks in one bin count as equally loaded.
BINS = {PRIMARY: 0.1, "bins of 0.05": 0.05, "bins of 0.2": 0.2}
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


def prepared_block(strength, front, tau_bar, shape):
    """The block in the middle of a prepared interface."""
    quantities = strength["sigma_bar"][MIDDLE], tau_bar, strength["mu_bar_eff"][MIDDLE]
    return Block(type_on_map(front["type"]), *quantities, shape)


# --- what they say -------------------------------------------------------------------------


def deviation(block, line):
    """Relative, from the curve at the sigma_bar that the finite number of junctions has."""
    return block.mu_bar_eff / np.interp(block.sigma_bar, *line) - 1


def largest_deviation(points, lines):
    return max(abs(deviation(point, lines[point.shape])) for point in points)


def distance(block, lines):
    """The distance from the nearer of the curves, in mu_bar_eff."""
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


def share_by_width(blocks, width=BINS[PRIMARY]):
    """Share of the pairs of a slow and a fast block with tau_bar_0 in the same bin in which the
    slow one has the lower sigma_bar; None without such pairs."""
    return share_of_lower(
        strata_of([(np.floor(b.tau_bar_0 / width), b.sigma_bar, b.kind) for b in blocks])
    )


def over_events(events):
    """{width of bins: of how many events, and the share of the median event}"""
    found = {}
    for name, width in BINS.items():
        shares = [share_by_width(blocks, width) for blocks in events]
        known = [share for share in shares if share is not None]
        found[name] = len(known), np.median(known) if known else np.nan
    return found
