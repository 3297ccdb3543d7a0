"""Maps of front types for other lengths and nucleation energies, and claims Geow and Geo."""

from claims.judge import judged
from data.tables import points_of
from maps import front_map, map_conventions
from maps.front_map import TYPES, axes_of, steps_back, types_of
from maps.map_panels import draw_key, draw_regions
from pictures.plotting import DOUBLE, lettered, save

TITLES = {
    "L x 0.75": r"$0.75\,L$",
    "L x 1.5": r"$1.5\,L$",
    "trigger 0.2": r"$\bar\tau_\mathrm{trigger} = 0.2$",
    "trigger 0.4": r"$\bar\tau_\mathrm{trigger} = 0.4$",
}


def with_all_types(types):
    """The sigma_bar at which all three types are present."""
    return {
        sigma
        for sigma, places in front_map.along(types, 0).items()
        if {types[place] for place in places} == set(TYPES)
    }


def measured(name, fronts):
    types = types_of(fronts)
    sigmas = axes_of(types)[1]
    below_left = front_map.fast_below_left_of_arrested(front_map.types_of_seeds(fronts))
    bands = {sigma: front_map.band(types, sigma) for sigma in sigmas}
    in_order = set(sigmas) - {sigma for _, sigma in steps_back(types, 0)}
    return {
        f"{name}: sigma_bar in order": f"{len(in_order)} of {len(sigmas)}",
        f"{name}: of these with all three types": len(in_order & with_all_types(types)),
        f"{name}: places that step back along sigma_bar": len(steps_back(types, 1)),
        f"{name}: fast below-left of arrested": len(below_left),
        f"{name}: slow tau_bar_0 by sigma_bar": "; ".join(
            f"{sigma:g}: " + ("{:g} to {:g}".format(*band) if band else "none")
            for sigma, band in bands.items()
        ),
    }


def case_of(maps, axis=map_conventions.ALONG_TAU, **how):
    """The order of regions in all maps, and how many sigma_bar show all three of them."""
    maps = maps.values()
    unordered = [map_conventions.out_of_order(fronts, fronts, axis, **how) for fronts in maps]
    complete = [with_all_types(types_of(fronts, **how)) for fronts in maps]
    return {
        "maps in order": sum(not places for places in unordered),
        "fewest sigma_bar with all three types": min(map(len, complete)),
    }


def case_in_words(maps, **how):
    """Of the leading row."""
    orders = [front_map.order_in_words(types_of(fronts, **how)) for fronts in maps.values()]
    return {
        "fewest types present on a map": min(present for present, _ in orders),
        "sigma_bar out of order on all maps": sum(out_of_order for _, out_of_order in orders),
    }


def by_seed(maps, case):
    """The seeds, and what measures the case of one of them."""
    seeds = sorted({seed for fronts in maps.values() for seed in front_map.seeds_of(fronts)})
    of_seed = {
        s: {name: front_map.map_of_seed(fronts, s) for name, fronts in maps.items()} for s in seeds
    }
    return seeds, lambda seed, **way: case(of_seed[seed], **way)


def claim_Geow(maps):
    shown = case_in_words(maps)
    seeds, case = by_seed(maps, case_in_words)
    units = map_conventions.units_of_seeds(seeds, map_conventions.MEASURES, case)
    return judged("Geow", shown, shown, units, map_conventions.ABOUT_UNITS)


def claim_Geo(maps):
    shown = case_of(maps)
    seeds, case = by_seed(maps, case_of)
    return judged(
        "Geo",
        shown=shown,
        units=map_conventions.units_of_seeds(seeds, map_conventions.WAYS, case),
        measured=shown
        | {k: v for name, fronts in maps.items() for k, v in measured(name, fronts).items()}
        | map_conventions.over_product("Geo", seeds, case),
        note="Order: with rising tau_bar_0 arrested, slow, fast, never back, at each sigma_bar,"
        " with all three at two or more, and no place fast below-left of an arrested one. Block"
        " spacing and mass, p per block, H, h and the trigger region's length are kept, so N_x = 43"
        " and 85, M and F_N in proportion to N_x. " + map_conventions.ABOUT_UNITS,
    )


def draw(maps, stem):
    fig, panels = lettered("ABCD", DOUBLE, 0.32 * DOUBLE, sharey=True)
    for text, (name, fronts) in zip("ABCD", maps.items()):
        types = types_of(fronts)
        draw_regions(panels[text], types, types)
        panels[text].set(title=TITLES[name], **({} if text == "A" else {"ylabel": ""}))
    draw_key(panels["D"])
    save(fig, stem)


def make(data, results):
    tables = sorted(data.glob("geometry.csv")) + sorted(data.glob("geometry-seeds.csv"))
    points = [point for table in tables for point in points_of(table)]
    maps = front_map.read_variants(points, TITLES)
    draw(maps, results / "geometry")
    front_map.write_variants(results / "geometry.csv", maps)
    return [claim_Geow(maps), claim_Geo(maps)]
