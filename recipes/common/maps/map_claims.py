"""A map of front types, its data and its claims: Figures 4 D and S6 B."""

from functools import partial

import numpy as np

from data.tables import write_table
from maps import front_map, map_conventions
from maps.front_map import TYPES, types_of, types_of_seeds
from maps.map_conventions import ALONG_SIGMA, ALONG_TAU
from maps.map_panels import draw_map


def thresholds_compared(fronts, grid, slow_below):
    """The effect of another threshold for slow fronts: numbers of grid points of each type, of
    those whose type is not that at the first threshold, and of violations over all seeds."""
    reference = types_of(grid, slow_below=1 / slow_below[0])
    for ratio in slow_below:
        types = types_of(grid, slow_below=1 / ratio)
        seeds = types_of_seeds(fronts, slow_below=1 / ratio)
        yield {
            "c_s/threshold": ratio,
            "slow": sum(kind == "slow" for kind in types.values()),
            "fast": sum(kind == "fast" for kind in types.values()),
            "changed": sum(types[place] != reference[place] for place in types),
            "fast below-left of arrested": len(front_map.fast_below_left_of_arrested(seeds)),
        }


def median_spread(fronts, places):
    """How far the times at which the front arrives differ between seeds, over their mean."""
    times = [[front["t_rupture"][-1] for front in fronts[place].values()] for place in places]
    spreads = [(max(of) - min(of)) / float(np.mean(of)) for of in times]
    return float(np.median(spreads)) if spreads else None


def fewest_seeds(fronts, boundary):
    """Seeds with a front, at the place next to another type that has the fewest."""
    measured = [[f for f in fronts[place].values() if f is not None] for place in boundary]
    return min(map(len, measured), default=0)


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
        "fewest seeds at one of them": fewest_seeds(fronts, boundary),
        "of these the type depends on the seed": sum(len(k) > 1 for k in definite.values()),
        **spreads,
    }


def measured(fronts, grid, boundary, thresholds):
    types = types_of(grid)
    taus, sigmas = front_map.axes_of(grid)
    below_left = front_map.fast_below_left_of_arrested(types_of_seeds(fronts))
    kinds = {
        f"{kind} grid points": sum(t == kind for t in types.values())
        for kind in ("arrested", "slow", "fast", "impossible")
    }
    bands = {
        f"slow tau_bar_0 at sigma_bar = {s:.3g}": front_map.band(types, s)
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
        "fast points below-left of an arrest point": len({fast for fast, _ in below_left}),
        "grid points that step back along tau_bar_0": len(front_map.steps_back(types, ALONG_TAU)),
        "grid points that step back along sigma_bar": len(front_map.steps_back(types, ALONG_SIGMA)),
        "places out of order, if the stencil at 27.5 mm counts": len(
            map_conventions.out_of_order(fronts, grid, ALONG_TAU, side="left")
        ),
        **seeds_measured(fronts, boundary),
        **bands,
        **others,
    }


def case_of_map(fronts, grid, boundary_seeds, axis=ALONG_TAU, **how):
    """What the claim asks of a map; `boundary_seeds`: those at each place next to another type."""
    types = types_of(fronts, **how)
    kinds = [types[place] for place in grid]
    return {
        **{f"{kind} grid points": kinds.count(kind) for kind in TYPES},
        "places out of order": len(map_conventions.out_of_order(fronts, grid, axis, **how)),
        "smaller side of the grid": min(map(len, front_map.axes_of(grid))),
        "fewest seeds at one of them": boundary_seeds,
    }


def case_in_words(fronts, grid, **how):
    """What the leading row asks of a map."""
    types = types_of(fronts, **how)
    present, out_of_order = front_map.order_in_words({place: types[place] for place in grid})
    return {"types present": present, "sigma_bar out of order": out_of_order}


def map_claims(leading, strict, fronts, grid, boundary, thresholds, note):
    """Shown is the map of all seeds."""
    return map_conventions.claims_over_seeds(
        leading,
        strict,
        fronts,
        {seed: front_map.map_of_seed(fronts, seed) for seed in front_map.seeds_of(fronts)},
        partial(case_in_words, grid=grid),
        partial(case_of_map, grid=grid, boundary_seeds=fewest_seeds(fronts, boundary)),
        measured(fronts, grid, boundary, thresholds),
        note,
    )


def make_map(data, results, *, panel, tables, slow_below, claims, note):
    """Everything that the recipe writes about its map, of map.csv and these tables. Slow is below
    c_s over one of `slow_below`, of which the first is the default. Returns the claims: the
    leading one and the one that asks for more."""
    recipe = results.name
    fronts, grid, boundary = front_map.load_map(data, recipe, tables)
    thresholds = list(thresholds_compared(fronts, grid, slow_below))
    draw_map(fronts, grid, slow_below, panel, results / f"{recipe}{panel}")
    front_map.write_types(results / "front-types.csv", fronts)
    write_table(results / "thresholds.csv", list(thresholds[0]), map(dict.values, thresholds))
    leading, strict = claims
    return map_claims(leading, strict, fronts, grid, boundary, thresholds, note)
