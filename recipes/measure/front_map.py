"""Maps of front types over prestress and width of phi.

A place is (tau_bar_0, sigma_bar); a map is {place: {seed: front}}, with the front that `analyze
front` reported, or None where no interface can be prepared. It has its types: front["types"][way].
"""

from itertools import pairwise

import numpy as np
from rupture.reports import values

from measure.ways import PRIMARY
from measure.fronts import TYPES, type_on_map
from measure.tables import SLOW_STRETCH, rounded, write_table

IMPOSSIBLE = "impossible"


# --- types ---------------------------------------------------------------------------------


def beyond_trigger(front):
    """Speeds of the stencils that count [m/s]; NaN where there is none."""
    return values(front["v_c"])[np.array(front["x"]) > front["criteria"]["skip_below_x"]]


def front_type(front, way=PRIMARY):
    """The type of a front by one of WAYS."""
    return IMPOSSIBLE if front is None else type_on_map(front["types"][way])


def below(ratio):
    """The way by which fronts are slow below c_s/ratio."""
    return PRIMARY if ratio == 20 else f"slow below c_s/{ratio}"


def types_of_seeds(fronts, way=PRIMARY):
    """{place: {seed: type}}"""
    return {
        place: {seed: front_type(front, way) for seed, front in seeds.items()}
        for place, seeds in fronts.items()
    }


def types_of(fronts, way=PRIMARY):
    """{place: type of its first seed}"""
    return {place: front_type(seeds[min(seeds)], way) for place, seeds in fronts.items()}


# --- where the type changes ----------------------------------------------------------------


def axes_of(places):
    """The values of tau_bar_0 and of sigma_bar, ascending."""
    return tuple(sorted(set(numbers)) for numbers in zip(*places))


def neighbours(grid):
    """Pairs of places next to each other on a rectangular grid."""
    taus, sigmas = axes_of(grid)
    for sigma in sigmas:
        yield from pairwise((tau, sigma) for tau in taus)
    for tau in taus:
        yield from pairwise((tau, sigma) for sigma in sigmas)


def differ(types, pair):
    """True if there is a change of type between the two places."""
    kinds = {types[place] for place in pair}
    return len(kinds) == 2 and IMPOSSIBLE not in kinds


def middle(pair):
    """The place halfway."""
    return tuple(rounded((a + b) / 2) for a, b in zip(*pair))


def changes(grid_types):
    """Pairs of neighbouring places of different type."""
    return [pair for pair in neighbours(grid_types) if differ(grid_types, pair)]


def to_refine(grid_types):
    """Places halfway between neighbours of which one is fast. A place between arrested and slow
    ones costs ten times as much: such fronts creep for 0.03 s to 0.1 s."""
    pairs = changes(grid_types)
    return sorted({middle(pair) for pair in pairs if "fast" in map(grid_types.get, pair)})


def boundary(grid_types, between_types=None):
    """Places next to another type; with those halfway, where they are known."""
    types = grid_types | (between_types or {})
    halves = []
    for first, last in changes(grid_types):
        halfway = middle((first, last))
        known = halfway in types
        halves += [(first, halfway), (halfway, last)] if known else [(first, last)]
    return sorted({place for pair in halves if differ(types, pair) for place in pair})


# --- what a map says -----------------------------------------------------------------------


def fast_below_left_of_arrested(seed_types):
    """Pairs of a fast point and an arrested one with at least its tau_bar_0 and sigma_bar, over all
    seeds: [(place of the fast one, place of the arrested one)]."""
    fast, arrested = (
        sorted(place for place, seeds in seed_types.items() if kind in seeds.values())
        for kind in ("fast", "arrested")
    )
    return [(f, a) for f in fast for a in arrested if f[0] <= a[0] and f[1] <= a[1]]


def steps_back(types):
    """Places where the type falls behind one before it with rising tau_bar_0: arrested, slow, fast
    is the order. Those that cannot be prepared do not count."""
    furthest: dict[float, int] = {}  # by sigma_bar
    found = set()
    for (tau, sigma), kind in sorted(types.items()):
        if kind in TYPES:
            order = TYPES.index(kind)
            if order < furthest.setdefault(sigma, order):
                found.add((tau, sigma))
            furthest[sigma] = max(order, furthest[sigma])
    return found


def out_of_order(fronts, way=PRIMARY):
    """Places that are fast below-left of an arrested one, over all seeds, and those where the type
    steps back along tau_bar_0."""
    found = {fast for fast, _ in fast_below_left_of_arrested(types_of_seeds(fronts, way))}
    return found | steps_back(types_of(fronts, way))


def medians_ascend(types, sigma):
    """Whether the median tau_bar_0 of the types that occur at this sigma_bar ascend: arrested,
    slow, fast."""
    of_kind = {
        kind: [t for (t, s), k in types.items() if (s, k) == (sigma, kind)] for kind in TYPES
    }
    medians = [float(np.median(taus)) for taus in of_kind.values() if taus]
    return all(low < high for low, high in zip(medians[:-1], medians[1:]))


def order_in_words(types):
    """How many types are present, and at how many sigma_bar their medians do not ascend."""
    out_of_order = [s for s in axes_of(types)[1] if not medians_ascend(types, s)]
    return len(set(types.values()) & set(TYPES)), len(out_of_order)


def slow_range(types):
    """The range of tau_bar_0 over slow fronts on a regular grid: their number at a sigma_bar, times
    the distance of grid points; the median over sigma_bar."""
    taus, sigmas = axes_of(types)
    slow = [sum(types.get((tau, sigma)) == "slow" for tau in taus) for sigma in sigmas]
    return float(np.median(slow)) * (taus[1] - taus[0])


def band(types, sigma):
    """Lowest and highest tau_bar_0 with a slow front at this sigma_bar, or None."""
    taus = [tau for (tau, s), kind in types.items() if s == sigma and kind == "slow"]
    return [min(taus), max(taus)] if taus else None


# --- maps of single seeds ------------------------------------------------------------------


def map_of_seed(fronts, seed):
    """The fronts of one seed, and those of the first where it has none: away from any boundary the
    seed is taken to make no difference."""
    return {
        place: {seed: seeds[seed] if seed in seeds else seeds[min(seeds)]}
        for place, seeds in fronts.items()
    }


# --- tables --------------------------------------------------------------------------------


def write_types(path, fronts):
    """One row per point, with where and how fast the front was slow."""
    stretch = {name: SLOW_STRETCH[name] for name in ("x_from", "x_to", "speed")}
    rows = [
        [*place, seed, front_type(front), *map(((front and front["slow"]) or {}).get, stretch)]
        for place, seeds in sorted(fronts.items())
        for seed, front in sorted(seeds.items())
    ]
    write_table(path, ["tau_bar_0", "sigma_bar", "seed", "type", *stretch.values()], rows)


def write_variants(path, maps):
    """One row per place of each {variant: map}."""
    rows = (
        [name, *place, kind]
        for name, fronts in maps.items()
        for place, kind in sorted(types_of(fronts).items())
    )
    write_table(path, ["variant", "tau_bar_0", "sigma_bar", "type"], rows)
