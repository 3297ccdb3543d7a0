"""Ways to read a map of front types that the paper leaves open, as data, and the map of each seed
under each of them: the units of claims 4D, S6B and Geo.

A way is options of front_type(), and the axis along which types may not step back. Where stencils
at the ends of a slow stretch count makes no difference to a type, so those ways are left out.
"""

from claims.judge import judged
from events.conventions import CONVENTIONS
from maps.front_map import fast_below_left_of_arrested, steps_back, types_of, types_of_seeds

OPTIONS = {  # of `analyze`: of front_type()
    "--stencil": "stencil",
    "--slow-below": "slow_below",
    "--ruptured-below": "ruptured_below",
}


MEASURES = {  # those that make a difference to types
    name: {OPTIONS[option]: value for option, value in options.items()}
    for name, options in CONVENTIONS.items()
    if set(options) <= set(OPTIONS)
}
ALONG_TAU, ALONG_SIGMA = 0, 1  # axes of a place
WAYS = {name: {"axis": ALONG_TAU} | how for name, how in MEASURES.items()} | {
    "order along sigma_bar": {"axis": ALONG_SIGMA}
}

ABOUT_UNITS = "The map of a seed has its own fronts at the boundary and those of seed 1 elsewhere."


def out_of_order(fronts, grid, axis, **how):
    """Places that are fast below-left of an arrested one, over all seeds, and those of the regular
    grid where the type steps back along an axis."""
    found = {fast for fast, _ in fast_below_left_of_arrested(types_of_seeds(fronts, **how))}
    types = types_of(fronts, **how)
    return found | steps_back({place: types[place] for place in grid}, axis)


def units_of_seeds(seeds, ways, case):
    """{seed: {convention: [case]}}; `case` measures the map of a seed in a way."""
    return {
        f"seed {seed}": {name: [case(seed, **way)] for name, way in ways.items()} for seed in seeds
    }


def claims_over_seeds(leading, strict, shown, of_seeds, case_in_words, case, measured, note):
    """The leading claim, and the one that asks for more. `shown`: the map of all seeds, or several;
    `of_seeds`: the same of each seed, {seed: map}. The functions measure the cases in them."""

    def units(ways, measure):
        return units_of_seeds(of_seeds, ways, lambda seed, **way: measure(of_seeds[seed], **way))

    words, note = case_in_words(shown), f"{note} {ABOUT_UNITS}"
    return [
        judged(leading, words, words, units(MEASURES, case_in_words), ABOUT_UNITS),
        judged(strict, measured, case(shown), units(WAYS, case), note),
    ]
