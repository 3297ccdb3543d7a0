#!/usr/bin/env python3
"""Maps of front types for other lengths and nucleation energies, and claim Geo:
geometry.py results/data results/robustness"""

import sys
from pathlib import Path

from claims.claim import write_claims
from claims.judge import judged
from maps.front_map import (
    TYPES,
    axes_of,
    band,
    fast_below_left_of_arrested,
    read_variants,
    types_of,
    types_of_seeds,
    write_variants,
)
from maps.map_panels import draw_key, draw_regions
from pictures.plotting import DOUBLE, figure, letter, save

TITLES = {
    "L x 0.75": r"$0.75\,L$",
    "L x 1.5": r"$1.5\,L$",
    "trigger 0.2": r"$\bar\tau_\mathrm{trigger} = 0.2$",
    "trigger 0.4": r"$\bar\tau_\mathrm{trigger} = 0.4$",
}


def column(types, sigma):
    """Types with rising tau_bar_0 at this sigma_bar, without places that cannot be prepared."""
    return [kind for (_, s), kind in sorted(types.items()) if s == sigma and kind in TYPES]


def is_in_order(kinds):
    """Never back from slow to arrested, or from fast to slow."""
    ranks = [TYPES.index(kind) for kind in kinds]
    return ranks == sorted(ranks)


def measured(name, fronts):
    types = types_of(fronts)
    columns = {sigma: column(types, sigma) for sigma in axes_of(types)[1]}
    return {
        f"{name}: sigma_bar in order": f"{sum(map(is_in_order, columns.values()))}"
        f" of {len(columns)}",
        f"{name}: of these with all three types": sum(
            is_in_order(kinds) and set(kinds) == set(TYPES) for kinds in columns.values()
        ),
        f"{name}: fast below-left of arrested": len(
            fast_below_left_of_arrested(types_of_seeds(fronts))
        ),
        f"{name}: slow tau_bar_0 by sigma_bar": "; ".join(
            f"{sigma:g}: " + ("{:g} to {:g}".format(*limits) if limits else "none")
            for sigma, limits in ((sigma, band(types, sigma)) for sigma in columns)
        ),
    }


def columns_of(fronts):
    types = types_of(fronts)
    return [column(types, sigma) for sigma in axes_of(types)[1]]


def case_of(maps):
    """The order of regions in all maps, and how many sigma_bar show all three of them."""
    columns = [columns_of(fronts) for fronts in maps.values()]
    return {
        "maps with all sigma_bar in order": sum(all(map(is_in_order, each)) for each in columns),
        "fewest sigma_bar with all three types": min(
            sum(set(kinds) == set(TYPES) for kinds in each) for each in columns
        ),
    }


def claim_Geo(maps):
    case = case_of(maps)
    return judged(
        "Geo",
        shown=case,
        measured=case
        | {k: v for name, fronts in maps.items() for k, v in measured(name, fronts).items()},
        note="Order: with rising tau_bar_0 arrested, slow, fast, never back, at each sigma_bar,"
        " with all three at two or more. Block spacing and mass, p per block, H, h and the trigger"
        " region's length are kept, so N_x = 43 and 85, M and F_N in proportion to N_x.",
    )


def draw(maps, stem):
    fig, panels = figure(DOUBLE, 0.32 * DOUBLE, ncols=len(maps), sharey=True)
    for axes, text, (name, fronts) in zip(panels, "ABCD", maps.items()):
        types = types_of(fronts)
        draw_regions(axes, types, types)
        axes.set_title(TITLES[name])
        letter(axes, text)
        if text != "A":
            axes.set(ylabel="")
    draw_key(panels[-1])
    save(fig, stem)


def main(data, results):
    data, results = Path(data), Path(results)
    maps = read_variants(data / "robustness/geometry.csv", TITLES, data / "points")
    draw(maps, results / "geometry")
    write_variants(results / "geometry.csv", maps)
    write_claims(data / "robustness/claims-Geo.json", [claim_Geo(maps)])


if __name__ == "__main__":
    main(*sys.argv[1:])
