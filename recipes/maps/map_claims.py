"""Measured values and verdicts of the claims about maps of front types (4D, S6B)."""

import numpy as np

from claims.judge import judged
from maps.front_map import (
    axes_of,
    band,
    fast_below_left_of_arrested,
    spread_of_crossing,
    types_of,
    types_of_seeds,
)


def thresholds_compared(fronts, grid, slow_below):
    """The effect of another threshold for slow fronts: numbers of grid points of each type, of
    those whose type is not that at the first threshold, and of violations over all seeds."""
    reference = types_of(grid, 1 / slow_below[0])
    for ratio in slow_below:
        types = types_of(grid, 1 / ratio)
        seeds = types_of_seeds(fronts, 1 / ratio)
        yield {
            "c_s/threshold": ratio,
            "slow": sum(kind == "slow" for kind in types.values()),
            "fast": sum(kind == "fast" for kind in types.values()),
            "changed": sum(types[place] != reference[place] for place in types),
            "fast below-left of arrested": len(fast_below_left_of_arrested(seeds)),
        }


def median_spread(fronts, places):
    spreads = [spread_of_crossing(fronts[place]) for place in places]
    return float(np.median(spreads)) if spreads else None


def seeds_measured(fronts, boundary):
    """The agreement of the seeds at the boundary. Seeds act through the slipping times only, so
    where few junctions repin before the front has crossed, they hardly differ."""
    kinds = types_of_seeds({place: fronts[place] for place in boundary})
    definite = {place: set(seeds.values()) for place, seeds in kinds.items()}
    spreads = {
        f"median spread of crossing times over seeds, {kind}": median_spread(
            fronts, [place for place in boundary if definite[place] == {kind}]
        )
        for kind in ("slow", "fast")
    }
    return {
        "boundary points": len(boundary),
        "fewest seeds at one of them": min((len(fronts[place]) for place in boundary), default=0),
        "of these the type depends on the seed": sum(len(k) > 1 for k in definite.values()),
        **spreads,
    }


def measured(fronts, grid, boundary, thresholds):
    types = types_of(grid)
    taus, sigmas = axes_of(grid)
    kinds = {
        f"{kind} grid points": sum(t == kind for t in types.values())
        for kind in ("arrested", "slow", "fast", "impossible")
    }
    bands = {
        f"slow tau_bar_0 at sigma_bar = {s:.3g}": band(types, s)
        for s in (sigmas[0], sigmas[len(sigmas) // 2], sigmas[-1])
    }
    others = {
        f"grid points of other type with c_s/{row['c_s/threshold']}": row["changed"]
        for row in thresholds[1:]
    }
    return {
        "grid": f"{len(taus)} x {len(sigmas)}",
        "smaller side of the grid": min(len(taus), len(sigmas)),
        **kinds,
        "points with all seeds": sum(map(len, fronts.values())),
        "fast points below-left of an arrest point": len(
            {pair[0] for pair in fast_below_left_of_arrested(types_of_seeds(fronts))}
        ),
        **seeds_measured(fronts, boundary),
        **bands,
        **others,
    }


def map_claim(name, fronts, grid, boundary, thresholds, note):
    values = measured(fronts, grid, boundary, thresholds)
    return judged(name, values, values, note=note)
