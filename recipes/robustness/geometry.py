"""Maps of front types for other lengths and nucleation energies, and claims Geow and Geo."""

from data.tables import points_of
from maps import front_map, map_conventions
from maps.front_map import TYPES, axes_of, steps_back, types_of
from maps.map_panels import draw_key, draw_regions
from pictures.plotting import DOUBLE, lettered, save

IN_ORDER = "maps in order"
TITLES = {
    "L x 0.75": r"$0.75\,L$",
    "L x 1.5": r"$1.5\,L$",
    "trigger 0.2": r"$\bar\tau_\mathrm{trigger} = 0.2$",
    "trigger 0.4": r"$\bar\tau_\mathrm{trigger} = 0.4$",
}


def with_all_types(types):
    """The sigma_bar at which all three types are present."""
    points = {(sigma, kind) for (_, sigma), kind in types.items()}
    return {sigma for sigma, _ in points if points >= {(sigma, kind) for kind in TYPES}}


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
        IN_ORDER: sum(not places for places in unordered),
        "fewest sigma_bar with all three types": min(map(len, complete)),
    }


def case_in_words(maps, **how):
    """Of the leading row."""
    orders = [front_map.order_in_words(types_of(fronts, **how)) for fronts in maps.values()]
    return {
        "fewest types present on a map": min(present for present, _ in orders),
        "sigma_bar out of order on all maps": sum(out_of_order for _, out_of_order in orders),
    }


def claims_of(maps):
    seeds = {seed for fronts in maps.values() for seed in front_map.seeds_of(fronts)}
    return map_conventions.claims_over_seeds(
        "Geow",
        "Geo",
        maps,
        {s: {n: front_map.map_of_seed(m, s) for n, m in maps.items()} for s in sorted(seeds)},
        case_in_words,
        case_of,
        case_of(maps)
        | {"maps in order, if the stencil at 27.5 mm counts": case_of(maps, side="left")[IN_ORDER]}
        | {k: v for name, m in maps.items() for k, v in measured(name, m).items()},
        "Order: at each sigma_bar, fronts are arrested, slow and fast with rising tau_bar_0, and"
        " never the reverse; all three types occur at two sigma_bar or more; no fast place is"
        " below-left of an arrested one. Block spacing and mass, p per block, H, h and the trigger"
        " region's length are kept, so N_x = 43 and 85, M and F_N in proportion to N_x.",
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
    return claims_of(maps)
