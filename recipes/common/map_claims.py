"""What the claims about maps of front types (4D, S6B) measure and how they are judged."""

from common.claims import Claim, verdict
from common.front_map import (
    axes_of,
    band,
    depends_on_seed,
    fast_below_left_of_arrested,
    types_of,
    types_of_seeds,
)

GRID = 20  # places along either axis
SEEDS = 5  # at the boundary
ACCEPTANCE = (
    "arrested, slow and fast all present; no fast point below-left of an arrest point;"
    " >= 20 x 20 grid, >= 5 seeds at the boundary"
)


def thresholds_compared(fronts, grid, slow_below):
    """What another threshold for slow fronts changes: numbers of grid points of each type, of those
    whose type is not that at the first threshold, and of violations over all seeds."""
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


def seeds_measured(fronts, boundary):
    """What the seeds at the boundary say. Seeds matter through slipping times only: a front that is
    through before it meets a repinned junction is the same for all of them."""
    at = {place: fronts[place] for place in boundary}
    mixed = [p for p, seeds in types_of_seeds(at).items() if len(set(seeds.values())) > 1]
    same = [p for p in at if not depends_on_seed(at[p], lambda front: front["t_rupture"])]
    return {
        "boundary points": len(at),
        "fewest seeds at one of them": min(map(len, at.values()), default=0),
        "of these the type depends on the seed": len(mixed),
        "of these the rupture line is the same for all seeds": len(same),
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
        **kinds,
        "points with all seeds": sum(map(len, fronts.values())),
        "fast points below-left of an arrest point": len(
            {pair[0] for pair in fast_below_left_of_arrested(types_of_seeds(fronts))}
        ),
        **seeds_measured(fronts, boundary),
        **bands,
        **others,
    }


def is_accepted(values, grid):
    present = all(values[f"{kind} grid points"] > 0 for kind in ("arrested", "slow", "fast"))
    in_order = values["fast points below-left of an arrest point"] == 0
    large = min(map(len, axes_of(grid))) >= GRID
    return present and in_order and large and values["fewest seeds at one of them"] >= SEEDS


def map_claim(name, paper, fronts, grid, boundary, thresholds, note):
    values = measured(fronts, grid, boundary, thresholds)
    return Claim(name, paper, values, ACCEPTANCE, verdict(is_accepted(values, grid)), note)
