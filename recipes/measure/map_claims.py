"""A map of front types, its data and its claim: Figures 4 D and S6 B."""

from functools import partial

from claims.judge import judged
from measure.tables import write_table
from measure.conventions import MEASURES
from measure import front_map
from measure.front_map import below, types_of, types_of_seeds
from measure.map_panels import draw_map

ABOUT_UNITS = "The map of a seed has its own fronts at the boundary and those of seed 1 elsewhere."


def out_of_order(fronts):
    """Places that are fast below-left of an arrested one, over all seeds, and those where the type
    steps back along tau_bar_0."""
    found = {fast for fast, _ in front_map.fast_below_left_of_arrested(types_of_seeds(fronts))}
    return found | front_map.steps_back(types_of(fronts))


def units_of_seeds(seeds, ways, case):
    """{seed: {convention: [case]}}; `case` measures the map of a seed in a way."""
    return {
        f"seed {seed}": {name: [case(seed, **way)] for name, way in ways.items()} for seed in seeds
    }


def claim_over_seeds(claim_id, shown, of_seeds, case):
    """`shown`: the map of all seeds, or several; `of_seeds`: the same of each seed, {seed: map}.
    The function measures the case in them."""

    def of_seed(seed, way):
        return case(of_seeds[seed], way=way)

    units = units_of_seeds(of_seeds, {name: {"way": name} for name in MEASURES}, of_seed)
    found = case(shown)
    return judged(claim_id, found, found, units, ABOUT_UNITS)


def thresholds_compared(fronts, grid, slow_below):
    """The effect of another threshold for slow fronts: numbers of grid points of each type, of
    those whose type is not that at the first threshold, and of violations over all seeds."""
    reference = types_of(grid, below(slow_below[0]))
    for ratio in slow_below:
        types = types_of(grid, below(ratio))
        seeds = types_of_seeds(fronts, below(ratio))
        yield {
            "c_s/threshold": ratio,
            "slow": sum(kind == "slow" for kind in types.values()),
            "fast": sum(kind == "fast" for kind in types.values()),
            "changed": sum(types[place] != reference[place] for place in types),
            "fast below-left of arrested": len(front_map.fast_below_left_of_arrested(seeds)),
        }


def case_of_map(fronts, grid, **how):
    """What the claim asks of a map."""
    types = types_of(fronts, **how)
    present, out_of_order = front_map.order_in_words({place: types[place] for place in grid})
    return {"types present": present, "sigma_bar out of order": out_of_order}


def make_map(fronts, grid, results, *, panel, slow_below, claim):
    """Everything that the recipe writes about its map (load_map()). Slow is below c_s over one of
    `slow_below`, of which the first is the default. Returns the claim; the case is the map of all
    seeds."""
    thresholds = list(thresholds_compared(fronts, grid, slow_below))
    draw_map(fronts, grid, slow_below, panel, results / f"{results.name}{panel}")
    front_map.write_types(results / "front-types.csv", fronts)
    write_table(results / "thresholds.csv", list(thresholds[0]), map(dict.values, thresholds))
    of_seed = {seed: front_map.map_of_seed(fronts, seed) for seed in front_map.seeds_of(fronts)}
    case = partial(case_of_map, grid=grid)
    return [claim_over_seeds(claim, fronts, of_seed, case)]
